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
import struct
from typing import NamedTuple

import numpy as np

from slowflow.backend import EXACT
from slowflow.exact.compiled import of_system
from slowflow.exact.work import spend, steps_left
from slowflow.mechanism import EquationOfMotion, Piece
from slowflow.text import Sentence, text
from slowflow_kernels import motion
from slowflow_kernels.exact_conventions import FAR, MOST_PHASES, Outcome
from slowflow_support.errors import NotSettled, Refused

TURN = 2.0 * math.pi
PHASE = struct.Struct("@iiddddddi?0d")  # a phase as C has it, in the order of `Phase`

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


#: of the load, the difference from the spring's force that rounding makes where they balance
BALANCED = 2.0**-40
FORCE = Sentence("{F_0 = :g}")
INERTIA = Sentence("the inertia force {force:g} at {Omega = :g}")
PUSH = Sentence(" and the push {force:g} of the spring at {u = :g}, together,")
NEVER_MOVES = Sentence("{what:s} does not exceed {mu = :g}: friction holds the mass for ever, it never moves")
HELD = Sentence(
    "{what:s} does not exceed {holds:s} = {force:g}: friction holds a mass at rest for ever; of motions beside that, "
    "if there are any, steady_state has the one next to A="
)
NO_DAMPING = text("{mu = :g} and zeta = 0: without any damping the forced motion has no attracting steady state", 0.0)


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
    system, Omega, F_0 = forced
    of, given = of_system(system), (start is not None, *(start or (0, 0)))
    outcome, steps, found = EXACT.follow(of, Omega, F_0, theta, u, v, end, *given, steps_left())
    spend(steps)
    phases = list(map(_phase, PHASE.iter_unpack(found)))
    if outcome:
        last = phases[-1] if phases else None  # which ends where the motion is lost
        why = lost(outcome, system, u if last is None else last.u_end)
        raise NotSettled(AT.format(why, Omega, F_0) if F_0 else why)
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


def stays_at_rest(system: EquationOfMotion, Omega: float, F_0: float, u: float = 0.0) -> bool:
    """Whether friction holds a mass at rest at u for ever, as spring, load and forcing together do not exceed it."""
    region = system.force.region_of(u)
    return system.forcing(Omega=Omega, F_0=F_0) + _pull(system, u) <= system.holds(region)


def only_rests(system: EquationOfMotion, Omega: float, F_0: float) -> bool:
    """Whether every motion comes to rest: kinetic friction on all of the way takes more than such a force gives."""
    return system.forcing(Omega=Omega, F_0=F_0) <= system.mu and not system.released


def _pull(system: EquationOfMotion, u: float) -> float:
    """What spring and load together push with at u; 0 where they balance but for rounding."""
    at = system.force.value(u)
    pull = abs(at - system.load)
    return 0.0 if pull <= BALANCED * abs(system.load) else pull


def check_forcing(
    system: EquationOfMotion, Omega: float, F_0: float, *, begins: tuple[float, float] | None = None
) -> None:
    """Raises ValueError unless Omega > 0, F_0 > 0 are finite, damping settles a motion, and the forcing keeps one up.

    Kinetic friction that acts throughout takes more than a force that does not exceed it can give. Static friction, and
    one that ends at a breakpoint, holds a mass that `begins` with such (u, v), beside which there may be motions.
    """
    check_numbers(system, Omega, F_0)
    if only_rests(system, Omega, F_0) or (
        begins is not None and begins[1] == 0 and stays_at_rest(system, Omega, F_0, begins[0])
    ):
        raise Refused(why_at_rest(system, Omega, F_0, 0.0 if begins is None else begins[0]))


def why_at_rest(system: EquationOfMotion, Omega: float, F_0: float, u: float) -> str:
    """In words that friction holds a mass at rest at u for ever."""
    force = system.forcing(Omega=Omega, F_0=F_0)
    told = INERTIA.format(force, Omega) if system.inertial else FORCE.format(F_0)
    if only_rests(system, Omega, F_0):
        return NEVER_MOVES.format(told, system.mu)
    region, pull = system.force.region_of(u), _pull(system, u)
    both = told + PUSH.format(pull, u) if pull else told
    name = text("{mu_s}" if system.mu_s > system.mu else "{mu}")
    jump = text(" and what the force jumps to at {u} = 0, together") if system.force.jump else ""
    return HELD.format(both, name + jump, system.holds(region))


def check_numbers(system: EquationOfMotion, Omega: float, F_0: float) -> None:
    """Raises ValueError unless Omega > 0 and F_0 > 0 are finite, and there is damping."""
    for name, value in (("Omega", Omega), ("F_0", F_0)):
        if not (math.isfinite(value) and value > 0):
            raise Refused(text(f"{{{name} = :}} must be positive and finite", value))
    if not system.is_damped:
        raise Refused(NO_DAMPING)
