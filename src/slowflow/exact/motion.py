"""Motion from switch to switch, in phases: slip in one direction over one piece of the force, or stick.

Switches, all exact: the velocity reaches zero; |u| reaches a breakpoint; at rest |force cos theta - f(u)| <= mu holds
the mass, or mu_s in its place if that is more, and it breaks away when that bound is met, at an angle known in closed
form. theta = Omega tau; v = du/dtau.

Smooth motion is compiled: Taylor series of order 24, one rounding of error per step, without the GIL. The pieces of a
force have recurrences, compiled or interpreted, or are approximated by polynomials. The oscillator that the C functions
take is immutable and made once; they have no other state in common, so any thread may call them. How many steps a
question may take is counted.
"""

from __future__ import annotations

import contextlib
import functools
import json
import math
import struct
import sys
from array import array
from collections.abc import Iterator, Mapping, Sequence
from contextvars import ContextVar
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from slowflow.core.backend import EXACT
from slowflow.core.mechanism import EquationOfMotion, Floats, Force, Law, Piece, followed
from slowflow.core.model import THROUGHOUT
from slowflow.sampled import rows
from slowflow.support.errors import NotSettled, Refused
from slowflow.support.text import Sentence, text
from slowflow_kernels import motion
from slowflow_kernels.exact_conventions import FAR, MOST_PHASES, Outcome

# ---- how long a question may take


MOST_STEPS = 200_000  # of one integration: a slip takes some tens, hundreds at low frequency
#: steps of one question, 240 times what a curve of 390 points takes: ten to twenty seconds
MOST_WORK = 3_000_000
GIVEN_UP = "stopped after {} integration steps, the limit for one answer"


class OutOfWork(Exception):
    """The question has used up its steps. No ArithmeticError: a trial that fails is replaced by another."""

    def __init__(self, most: int) -> None:
        super().__init__(GIVEN_UP.format(most))


_remaining: ContextVar[list[int] | None] = ContextVar("steps that the question has left", default=None)


@contextlib.contextmanager
def limited(most: int = MOST_WORK) -> Iterator[None]:
    """Bounds the steps of one question, inner questions included. Raises ArithmeticError where they do not suffice."""
    if _remaining.get() is not None:
        yield
        return
    token = _remaining.set([most, most])
    try:
        yield
    except OutOfWork as used_up:
        raise NotSettled(str(used_up)) from None
    finally:
        _remaining.reset(token)


def steps_left() -> int:
    """The steps that one integration may take now."""
    remaining = _remaining.get()
    return MOST_STEPS if remaining is None else max(0, min(MOST_STEPS, remaining[0] + 1))


def spend(steps: int, *, keep: bool = False) -> None:
    """Counts steps of an integrator against what the question has left.

    keep -- what was found with them is good: not this call is refused but the next
    """
    remaining = _remaining.get()
    if remaining is not None:
        remaining[0] -= steps
        if remaining[0] < 0 and not keep:
            raise OutOfWork(remaining[1])


# ---- the oscillator in C

CACHE_SIZE = 64  # oscillators in C
#: the last oscillator and its handle, set as one tuple for thread safety
_last: tuple[EquationOfMotion | None, Any] = None, None


def recurrences(law: Law) -> Any:
    """A law's recurrences in C, those that are interpreted among them; None for one that has none, or too many."""
    if not law.name:
        return None
    if law.name not in EXACT.LAWS:
        _interpret(law.force)
    return EXACT.LAWS.get(law.name)


def _interpret(force: Any) -> None:
    """Makes laws of the programs in the folder of a force's module, if there are any."""
    module = sys.modules[force.__module__]
    path = Path(module.__file__ or "")
    path = path.with_name(f"{path.stem}_motion.json")
    for name, program in json.loads(path.read_text()).items() if path.exists() else ():
        lists = array("i", program["words"]).tobytes(), array("d", program["numbers"]).tobytes()
        EXACT.LAWS[name] = EXACT.interpreted(name, *lists)


def _law(piece: Piece, low: float, high: float) -> tuple[Any, tuple[float, ...]]:
    """The law for C of a piece that holds from low to high, and its constants: polynomials where it has no series."""
    series = recurrences(piece.law)
    if series is not None:
        return series, piece.constants
    sides = []
    for side in (-1.0, 1.0):
        begin, end = sorted((side * low, side * high))
        begin = max(begin, 0.0)
        # on a side where it does not hold Newton's iteration may try it
        end = end if end > begin else begin + 1.0
        first = end - begin if end < FAR else max(begin, 1.0)
        sides.append(rows(lambda v, side=side: side * _values(piece, side * v), begin, end, first))  # type: ignore[misc]
    return EXACT.polynomials(*sides), ()


def _values(piece: Piece, u: Floats) -> Floats:
    """A force at several displacements, NaN where it has none."""
    force = functools.partial(_value, piece)
    try:
        values = np.asarray(piece.law.force(u, *piece.constants), dtype=float)
    except Exception:
        values = np.empty(0)
    return values if values.shape == u.shape else np.array([force(one) for one in u.tolist()])


def _value(piece: Piece, u: float) -> float:
    try:
        return float(piece.law.force(u, *piece.constants))
    except Exception:
        return math.nan


def design_rows(mechanism: Any, values: Mapping[str, Floats], damping: Sequence[str]) -> list[Floats]:
    """Constants of the force, ends of its pieces and damping of many designs, a row for each, as C takes them.

    values -- by name, each (n,); damping -- which of these, 0 where one is missing
    """
    count = next(iter(values.values())).size
    parameters = mechanism.coefficients(*(values[name] for name in mechanism.design_names))
    groups = parameters, mechanism.breakpoints(*parameters), [values.get(name, 0.0) for name in damping]
    columns = ([np.broadcast_to(value, count) for value in group] for group in groups)
    return [np.ascontiguousarray(np.array(group, dtype=float).reshape(-1, count).T) for group in columns]


def system_of(designs: Any, numbers: dict[str, float], load: float = 0.0) -> EquationOfMotion:
    """The equation of motion of one of many designs, from its numbers by name, where no law is stated at a frequency.

    Raises ValueError for one outside its domain.
    """
    model = designs.model(numbers)
    force = followed(Force.of(designs.mechanism, model.parameters), designs.mechanism.name)
    released = model.laws.contact != THROUGHOUT
    return EquationOfMotion(force, model.mu, model.zeta, load=load, released=released, **model.laws.numbers)


def handle(system: EquationOfMotion) -> Any:
    """The oscillator for C. The last one is compared by identity, as its hash takes longer than a step."""
    global _last
    known, compiled = _last
    if known is not system:
        compiled = _compile(system)
        _last = system, compiled
    return compiled


@functools.lru_cache(maxsize=CACHE_SIZE)
def _compile(system: EquationOfMotion) -> Any:
    force = system.force
    centre = -force.region_of(-math.inf)
    ends = (-FAR, *force.edges, FAR)
    if force.odd:  # each holds on both sides of u = 0
        positive = [_law(piece, *ends[centre + i : centre + i + 2]) for i, piece in enumerate(force.pieces)]
        laws_of = positive[:0:-1] + positive
    else:
        laws_of = [_law(piece, *ends[i : i + 2]) for i, piece in enumerate(force.pieces)]
    laws, constants = zip(*laws_of, strict=True)
    damping = system.mu, system.zeta, system.inertial, system.load, system.c_2, system.released, system.mu_s
    others = system.eta, system.c_3, system.zeta_2, force.jump
    return EXACT.system(laws, constants, force.edges, centre, force.odd, *damping, *others)


def advance(
    forced: Any, slip: int, region: int, theta: float, u: float, v: float, end: float
) -> tuple[float, float, Floats]:
    """State (u, v) at `end`, also before theta, and its derivatives by (u, v, Omega, F_0): shape (2, 4)."""
    system, Omega, F_0 = forced
    flow = np.empty((2, 4))
    outcome, steps, u, v = EXACT.advance(handle(system), Omega, F_0, slip, region, theta, u, v, end, steps_left(), flow)
    spend(steps)
    if outcome:
        raise NotSettled(f"the integration from theta = {theta} to {end} failed")
    return u, v, flow


def sample(forced: Any, phase: Any, grid: Floats) -> Floats:
    """u, v and the absolute acceleration of the mass within a phase: shape (grid.size, 3).

    grid -- does not fall, and lies at or after where the phase begins
    """
    system, Omega, F_0 = forced
    states = np.empty((grid.size, 3))
    outcome, steps = EXACT.sample(
        handle(system), Omega, F_0, *phase[:5], steps_left(), np.ascontiguousarray(grid), states
    )
    spend(steps)
    if outcome:
        raise NotSettled(f"the integration from theta = {phase.theta} to {grid[-1]} failed")
    return states


# ---- phases

TURN = 2.0 * math.pi
PHASE = struct.Struct("@iiddddddi?0d")  # a phase as C has it, in the order of `Phase`

CHATTERS = Sentence(
    "the mass chatters near {u = :.6g}, where the restoring force jumps: more than {most:d} events in one period"
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
NEVER_MOVES = Sentence("{what:s} does not exceed {mu = :g}: friction holds the mass, which never moves")
STUCK = Sentence(
    "{what:s} does not exceed {holds:s} = {force:g}: friction holds a mass at rest permanently; other motions, "
    "if there are any, are found by steady_state(..., A=...)"
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
        """The force less f(u), which friction balances at rest."""
        return float(motion.push(math.cos(theta), self.force, self.piece(region).value(u) - self.system.load))

    def acceleration(self, slip: int, region: int, theta: float, u: float) -> float:
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
    oscillator, override = handle(system), (start is not None, *(start or (0, 0)))
    outcome, steps, found = EXACT.follow(oscillator, Omega, F_0, theta, u, v, end, *override, steps_left())
    spend(steps)
    phases = list(map(_phase, PHASE.iter_unpack(found)))
    if outcome:
        last = phases[-1] if phases else None  # which ends where the motion is lost
        why = lost(outcome, system, u if last is None else last.u_end)
        raise NotSettled(AT.format(why, Omega, F_0) if F_0 else why)
    return phases


def lost(outcome: int, system: EquationOfMotion, u: float) -> str:
    """The message why the integration failed at u. Raises MemoryError where memory for its phases ran out."""
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
        at, nearer = (abs(system.force.value(position)) for position in (u, NEARER * u))
    return bool(np.isinf(at) or at > GROWS * nearer)


def signature(phases: list[Phase]) -> tuple[tuple[int, int], ...]:
    """(slip, region) of each phase: the order of switches, which smooth continuation keeps."""
    return tuple((phase.slip, phase.region) for phase in phases)


def stops(phases: list[Phase]) -> int:
    """The number of stick phases."""
    return sum(phase.slip == 0 for phase in phases)


def stays_at_rest(system: EquationOfMotion, Omega: float, F_0: float, u: float = 0.0) -> bool:
    """Whether a mass at rest at u sticks: spring, load and forcing together do not exceed friction."""
    region = system.force.region_of(u)
    return system.forcing(Omega=Omega, F_0=F_0) + _net_force(system, u) <= system.holds(region)


def must_stick(system: EquationOfMotion, Omega: float, F_0: float) -> bool:
    """Whether every motion ends in sticking: kinetic friction dissipates more than such a force can supply."""
    return system.forcing(Omega=Omega, F_0=F_0) <= system.mu and not system.released


def _net_force(system: EquationOfMotion, u: float) -> float:
    """What spring and load together push with at u; 0 where they balance but for rounding."""
    spring = system.force.value(u)
    force = abs(spring - system.load)
    return 0.0 if force <= BALANCED * abs(system.load) else force


def check_forcing(
    system: EquationOfMotion, Omega: float, F_0: float, *, initial: tuple[float, float] | None = None
) -> None:
    """Raises ValueError unless Omega > 0, F_0 > 0 are finite, damping settles a motion, and the forcing keeps one up.

    Kinetic friction that acts throughout dissipates more than a force up to its size can supply. Static friction, or
    one that ends at a breakpoint, may hold a mass with the `initial` (u, v) although there are other motions.
    """
    check_numbers(system, Omega, F_0)
    if must_stick(system, Omega, F_0) or (
        initial is not None and initial[1] == 0 and stays_at_rest(system, Omega, F_0, initial[0])
    ):
        raise Refused(sticking_message(system, Omega, F_0, 0.0 if initial is None else initial[0]))


def sticking_message(system: EquationOfMotion, Omega: float, F_0: float, u: float) -> str:
    """The message that a mass at rest at u sticks."""
    force = system.forcing(Omega=Omega, F_0=F_0)
    excitation = INERTIA.format(force, Omega) if system.inertial else FORCE.format(F_0)
    if must_stick(system, Omega, F_0):
        return NEVER_MOVES.format(excitation, system.mu)
    region, push = system.force.region_of(u), _net_force(system, u)
    total = excitation + PUSH.format(push, u) if push else excitation
    name = text("{mu_s}" if system.mu_s > system.mu else "{mu}")
    jump = text(" and the jump of the force at {u} = 0, together,") if system.force.jump else ""
    return STUCK.format(total, name + jump, system.holds(region))


def check_numbers(system: EquationOfMotion, Omega: float, F_0: float) -> None:
    """Raises ValueError unless Omega > 0 and F_0 > 0 are finite, and there is damping."""
    for name, value in (("Omega", Omega), ("F_0", F_0)):
        if not (math.isfinite(value) and value > 0):
            raise Refused(text(f"{{{name} = :}} must be positive and finite", value))
    if not system.is_damped:
        raise Refused(NO_DAMPING)
