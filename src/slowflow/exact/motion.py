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
from slowflow.exact.compiled import Drive
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


class Lost(NotSettled):
    """A motion that is not followed further: why, in words without what drives it, and at which angle of that."""

    why: str
    theta: float


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

    def drive(self, slip: int, region: int) -> Drive:
        """The constants of a slip phase in that region."""
        system = self.system
        friction = slip * system.friction(region) - system.load
        zeta, by_Omega = system.damping(self.Omega)
        return Drive(self.Omega, self.force, zeta, friction, slip * system.c_2, by_Omega)

    def push(self, region: int, theta: float, u: float) -> float:
        """The force less f(u): what friction has to hold at rest."""
        return float(motion.push(math.cos(theta), self.force, self.piece(region).value(u) - self.system.load))

    def acceleration(self, slip: int, region: int, theta: float, u: float, v: float) -> float:
        """u'' in a slip phase."""
        drive = self.drive(slip, region)
        spring = self.piece(region).value(u)
        return float(motion.acceleration(math.cos(theta), v, drive.F_0, drive.zeta, drive.resistance(v), spring))


def edge_ahead(system: EquationOfMotion, slip: int, region: int) -> float:
    """The breakpoint towards which a mass in that region slips, with its sign; slip * FAR if there is none."""
    edge = system.force.edge_ahead(slip, region)
    return slip * FAR if edge is None else edge


def follow(
    forced: Forced, theta: float, u: float, v: float, end: float, start: tuple[int, int] | None = None
) -> list[Phase]:
    """All phases from (theta, u, v) to `end`; `start` = (slip, region) overrides the state, e.g. at break-away.

    Raises `Lost` if switches accumulate (the mass chatters at a jump of the force), the motion escapes, or comes to
    where the integration stalls.
    """
    outcome, rows = compiled.follow(forced.system, forced.Omega, forced.F_0, (theta, u, v), end, start)
    phases = list(map(_phase, rows))
    if outcome:
        last = phases[-1] if phases else None  # which ends where the motion is lost
        raise _lost(outcome, forced, *((theta, u) if last is None else (last.end, last.u_end)))
    return phases


def _lost(outcome: int, forced: Forced, theta: float, u: float) -> Exception:
    """In words why a motion is given up at an angle, and at u."""
    if outcome == Outcome.NO_MEMORY:
        return MemoryError("no memory for the phases of the motion")
    if outcome == Outcome.CHATTERS:
        why = CHATTERS.format(u, MOST_PHASES)
    elif outcome == Outcome.ESCAPES:
        why = ESCAPES.format(FAR)
    else:
        why = (UNBOUNDED if _grows_without_bound(forced.system, u) else STALLS).format(u)
    lost = Lost(AT.format(why, forced.Omega, forced.F_0) if forced.F_0 else why)
    lost.why, lost.theta = why, theta
    return lost


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
