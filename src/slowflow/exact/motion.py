"""Motion from switch to switch: slip in one direction over one piece of the force, or rest.

In:  an oscillator, the forcing, a state at rest or in motion.
Out: its phases in order, each with its start, its end and what ended it.

Switches, all exact: the velocity reaches zero; |u| reaches a breakpoint; at rest |force cos theta - f(u)| <= mu holds
the mass, or mu_s in its place if that is more, and it breaks away when that bound is met, at an angle known in closed
form. theta = Omega tau; v = du/dtau.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from slowflow.exact import compiled
from slowflow.mechanism import EquationOfMotion, Piece
from slowflow.text import Sentence
from slowflow_kernels import motion
from slowflow_kernels.exact_conventions import FAR, MOST_PHASES, Outcome
from slowflow_support.errors import NotSettled

TURN = 2.0 * math.pi

CHATTERS = Sentence(
    "the mass chatters near {u = :.6g}, where the restoring force jumps: more than {most:d} switches in one turn"
)
ESCAPES = Sentence("the motion escapes: |{u}| passes {u:g}, the restoring force does not hold it")
STALLS = Sentence(
    "the integration stalls near {u = :.6g}: its steps become too many, or the force is not defined there"
)
UNBOUNDED = Sentence("the integration stalls near {u = :.6g}, where the restoring force grows without bound")
AT = Sentence("{why:s}; at {Omega = :}, {F_0 = :}")
#: a force that has no bound near u is larger there, by this factor, than at `NEARER` u
GROWS, NEARER = 1e6, 0.9


class Phase(NamedTuple):
    """A stretch of smooth motion.

    slip      -- sign of the velocity, 0 at rest
    region    -- index of the piece, signed like u
    undecided -- the velocity comes so near to zero on the way that rounding hides whether it gets there
    """

    slip: int
    region: int
    theta: float
    u: float
    v: float
    end: float
    u_end: float
    v_end: float
    event: int
    undecided: bool = False


_phase = functools.partial(tuple.__new__, Phase)  # of as many fields as C has: `_make` would count them each time


class Forced(NamedTuple):
    """An oscillator under the force of an excitation F_0 times cos(Omega tau)."""

    system: EquationOfMotion
    Omega: float
    F_0: float

    @property
    def force(self) -> float:
        """Amplitude of the force."""
        return self.system.forcing(Omega=self.Omega, F_0=self.F_0)

    def piece(self, region: int) -> Piece:
        """The piece of the force in that region."""
        return self.system.force.piece(region)

    def push(self, region: int, theta: float, u: float) -> float:
        """The force less f(u): what friction has to hold at rest."""
        return float(motion.push(math.cos(theta), self.force, self.piece(region).value(u) - self.system.load))

    def starts(self, slip: int, region: int, theta: float, u: float) -> float:
        """u'' where a slip begins, or ends."""
        return self.push(region, theta, u) - slip * self.system.friction(region)


def edge_ahead(system: EquationOfMotion, slip: int, region: int) -> float:
    """The breakpoint towards which a mass in that region slips, with its sign; slip * FAR if there is none."""
    edge = system.force.edge_ahead(slip, region)
    return slip * FAR if edge is None else edge


def follow(
    forced: Forced, theta: float, u: float, v: float, end: float, start: tuple[int, int] | None = None
) -> list[Phase]:
    """All phases from (theta, u, v) to `end`; `start` = (slip, region) overrides the state, e.g. at break-away.

    Raises ArithmeticError if switches accumulate (the mass chatters at a jump of the force), the motion escapes, or
    comes to where the integration stalls.
    """
    outcome, rows = compiled.follow(forced.system, forced.Omega, forced.F_0, (theta, u, v), end, start)
    phases = list(map(_phase, rows))
    if outcome:
        last = phases[-1] if phases else None  # which ends where the motion is lost
        why = lost(outcome, forced.system, u if last is None else last.u_end)
        raise NotSettled(AT.format(why, forced.Omega, forced.F_0) if forced.F_0 else why)
    return phases


def lost(outcome: int, system: EquationOfMotion, u: float) -> str:
    """In words why a motion is given up at u. Raises MemoryError where there is no room for its phases."""
    if outcome == Outcome.NO_MEMORY:
        raise MemoryError("no memory for the phases of the motion")
    if outcome == Outcome.CHATTERS:
        return CHATTERS.format(u, MOST_PHASES)
    if outcome == Outcome.ESCAPES:
        return ESCAPES.format(FAR)
    return (UNBOUNDED if _grows_without_bound(system, u) else STALLS).format(u)


def _grows_without_bound(system: EquationOfMotion, u: float) -> bool:
    """Whether the restoring force is beyond all measure at u, where an integration has stalled."""
    with np.errstate(all="ignore"):  # it may have no value there
        at, nearer = (abs(system.force.value(spot)) for spot in (u, NEARER * u))
    return bool(np.isinf(at) or at > GROWS * nearer)


def signature(phases: list[Phase]) -> tuple[tuple[int, int], ...]:
    """(slip, region) of each phase: the order of switches, which smooth continuation keeps."""
    return tuple((phase.slip, phase.region) for phase in phases)


def stops(phases: list[Phase]) -> int:
    """How many of the phases are rests."""
    return sum(phase.slip == 0 for phase in phases)
