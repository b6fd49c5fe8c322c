"""One steady state at one frequency: Newton's iteration on the periodic motion, from a guess or from time stepping.

In:  an oscillator, Omega, F_0, perhaps a guess.
Out: `SteadyState`: one period, its harmonics, stops, Floquet multipliers and the residual of its periodicity.

Time stepping ends where it is shown that the motion approaches the one that Newton's iteration found (`_approaches`).
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slowflow.answer import Answer, in_values
from slowflow.exact import compiled
from slowflow.exact.cycle import Cycle, closed_cycle, rests_at_jump, shown_in
from slowflow.exact.motion import TURN, Forced, Phase, check_forcing, check_numbers, follow, only_rests, stays_at_rest
from slowflow.exact.work import limited
from slowflow.mechanism import EquationOfMotion
from slowflow.text import Sentence
from slowflow.transmissibility import Transmitted, asked
from slowflow_support.errors import NotSettled, Refused

Array = NDArray[np.float64]

MOST_TURNS = 3000  # of the forcing, before time stepping gives up
PARTING_TURNS = 30  # over which motions that begin next to each other are compared
#: by what they part in these turns at least where it is chaotic; else they do so in proportion to time at most
PARTED = 1e3
LONGEST = 16  # turns of the forcing that a motion may take, as subharmonics do
#: lengths of a cycle that are tried, by turns of the forcing: a motion of an odd number may be its own mirror image
HALF_TURNS = tuple(n for turns in range(1, LONGEST + 1) for n in ((turns, 2 * turns) if turns % 2 else (2 * turns,)))
SHORT = 3  # turns of those that are asked for wherever the motion comes back
#: how much nearer a motion comes back after more turns than after fewer, where it is asked for a longer subharmonic
NEARER_BACK = 0.1
#: of the largest |u|, to which a motion comes back that may settle; turns at most from one look to the next
COMES_BACK, ASKED_AGAIN = 0.01, 8
#: distance from a stable motion, over A, that needs no proof of going there; by how much a state is nearer by which the
#: map is seen to be linear, and by how much of each other two ways differ at most where it is
ARRIVED, NEARER, UNLIKE = 1e-8, 0.1, 0.5


def lengths(system: EquationOfMotion) -> tuple[int, ...]:
    """Of these those that a motion may have: off the centre none is the mirror image of itself half a turn later."""
    return HALF_TURNS if system.centred else tuple(n for n in HALF_TURNS if n % 2 == 0)


def _turns(half_turns: int) -> int:
    """Turns of the forcing after which a motion of a cycle of so many half turns is where it was."""
    return half_turns if half_turns % 2 else half_turns // 2


AGAIN = 1e-9  # of its amplitude, within which a motion is where it was before
GAUSS_NODES = 40  # per phase of the motion, for its harmonics
PEAK_SAMPLES = 65  # per phase, between which the largest force that is passed on is looked for
#: shares of the amplitude at which it is asked whether the force has any stiffness there
WITHIN = (0.25, 0.5, 0.9)
#: of its amplitude, what a motion that is adrift may still change in a turn of the forcing
CALM = 1e-10
#: distance of a multiplier from 1, from which on it says by itself whether a motion is stable
NEUTRAL = 1e-6
#: doublings of the distance from a neutral motion, and how much more than rounding a way is that is seen
FARTHER, SEEN = 60, 100.0
#: places on each side at which it is asked whether the force rises
SLOPES = 16

ADRIFT = Sentence(
    "no steady state is singled out at {Omega = :g}, {F_0 = :g}: a motion of amplitude {A:.6g} stays {where:s} no "
    "force brings its mean back, and each such mean is as good as another; {A = :.6g} gives the one about {u} = 0"
)
WITHIN_END = Sentence("within |{u}| = {u:g}, where")

CHAOTIC = Sentence(
    "no steady state found at {Omega = :g}, {F_0 = :g}: the motion is chaotic, as far as {turns:d} turns of the "
    "forcing tell: motions that begin beside each other part by a factor of {rate:.2g} in each; A= gives the periodic "
    "motion, stable or not, next to an amplitude"
)
RESTS_AT_JUMP = Sentence(
    "the motion at {Omega = :g}, {F_0 = :g} repeats itself with {A = :.6g}, but the mass rests at {u} = 0 in each "
    "turn, where the force jumps, after passing it ever more often: that is followed in time, by sweep, and has no "
    "multipliers"
)
COMES_TO_REST = Sentence(
    "no steady state found at {Omega = :g}, {F_0 = :g}: a motion from {u = :.6g} on comes to rest, where "
    "friction holds the mass"
)
NOT_FOUND = Sentence(
    "no steady state found at {Omega = :}, {F_0 = :}: after {turns:d} turns of the forcing the motion comes back only "
    "to within {A:.1e}; {why:s}"
)


class NotPeriodic(NotSettled):
    """The motion was followed for `MOST_TURNS` turns and not seen to approach a periodic one."""


@dataclass(frozen=True, eq=False)
class SteadyState(Answer):
    """A periodic motion. All quantities dimensionless; arrays over one period have `samples` entries, tau from 0.

    F_0          -- amplitude of the excitation; `force` is that of the force
    A            -- largest |u|, the mean included, good to about 1e-13 whatever its size
    stops        -- rests in one period
    multipliers  -- Floquet multipliers over `period`, shape (2,)
    half_multipliers -- of the map over half a period with u -> -u, where the motion is half-wave symmetric, else None;
                        `multipliers` are their squares
    stable       -- both multipliers inside the unit circle
    symmetric    -- whether u(tau + period/2) = -u(tau)
    phases       -- of one cycle, from its highest turning point
    message      -- what to bear in mind; empty if there is nothing to say
    """

    has_rows = True

    Omega: float
    F_0: float
    A: float
    stops: int
    multipliers: NDArray[np.complex128]
    half_multipliers: NDArray[np.complex128] | None
    stable: bool
    symmetric: bool
    cycle: Cycle = field(repr=False)
    unknowns: Array = field(repr=False)
    phases: list[Phase] = field(repr=False)
    message: str = ""

    @property
    def force(self) -> float:
        """Amplitude of the force on the mass: F_0, or F_0 Omega^2 for an excitation by inertia."""
        return self.cycle.system.forcing(Omega=self.Omega, F_0=self.F_0)

    @property
    def period(self) -> float:
        """Period in tau."""
        return self.cycle.half_turns * (2 if self.symmetric else 1) * math.pi / self.Omega

    @functools.cached_property
    def residual(self) -> float:
        """Largest difference of (u, v) after one period from a point within the first phase, followed with switches."""
        forced = Forced(self.cycle.system, self.Omega, self.F_0)
        slip, region = self.cycle.signature[0]
        theta, span = float(self.unknowns[1]), float(self.unknowns[2])
        middle = theta + 0.5 * span
        ((u, v, _),) = self._within(self.phases[0], np.array([middle])).tolist()
        last = follow(forced, middle, u, v, middle + self.Omega * self.period, (slip, region))[-1]
        return float(max(abs(last.u_end - u), abs(last.v_end - v)))

    @property
    def undecided(self) -> bool:
        """Whether rounding hides if the mass stops once more: its velocity touches zero within a slip."""
        return any(phase.undecided for phase in self.phases)

    def series(self, samples: int = 400) -> tuple[Array, Array, Array]:
        """tau, u, v = du/dtau at `samples` equal steps of one period from tau = 0, where the forcing is largest."""
        theta = self.Omega * self.period * np.arange(samples) / samples
        u, v = self._at(theta)
        return theta / self.Omega, u, v

    def columns(self, samples: int = 400) -> dict[str, Array]:
        """tau, u and v, as `series` gives them: what `to_pandas` and `to_xarray` have."""
        return dict(zip(("tau", "u", "v"), self.series(samples), strict=True))

    def about(self) -> dict[str, Any]:
        """Frequency, forcing, amplitude, stops, stability."""
        return {name: getattr(self, name) for name in ("Omega", "F_0", "A", "stops", "stable", "symmetric", "period")}

    def __str__(self) -> str:
        return "\n".join(in_values(self, self.about()))

    def harmonics(self, most: int = 7) -> NDArray[np.complex128]:
        """c_0 ... c_most of u = Re sum c_k exp(i k Omega' tau), Omega' = 2 pi/period; by a Gauss rule on each phase."""
        orders = np.arange(most + 1)
        span = self.cycle.half_turns * math.pi
        whole = self.Omega * self.period
        base = TURN / whole
        total = np.zeros(most + 1, dtype=np.complex128)
        for phase, at, weights in self._on_nodes():
            total += np.exp(-1j * base * np.outer(orders, at)) @ (weights * self._within(phase, at)[:, 0])
        if whole > span * 1.5:  # the second half of a symmetric motion mirrors the first
            total *= 1.0 - (-1.0) ** orders
        total *= 2.0 / whole
        total[0] *= 0.5
        return total

    def transmitted(self, of: str = "force") -> Transmitted:
        """What the motion passes on, all harmonics of it, over what drives it.

        of -- "force": spring, damper and friction over the amplitude of the force; on a base that shakes it is as well
              the acceleration of the mass over that of the base. "relative": u over F_0, its mean included.
              "absolute": of a base that shakes the displacement of the mass over that of the base, of an unbalance that
              of the centre of mass over F_0.

        Raises ValueError for another `of`, and for "absolute" where the base stands still.
        """
        asked(of, inertial=self.cycle.system.inertial)
        whole = self.cycle.half_turns * math.pi
        square, first, peak = 0.0, 0j, 0.0
        for phase, at, weights in self._on_nodes():
            passed = self._wave(of, phase, at)
            square += float(weights @ passed**2)
            first += complex((weights * passed) @ np.exp(-1j * at))
            peak = max(peak, self._highest(of, phase))
        drives = self.force if of == "force" else self.F_0
        return Transmitted(2.0 * abs(first) / whole / drives, peak / drives, math.sqrt(square / whole) / drives)

    def _on_nodes(self) -> Iterator[tuple[Phase, Array, Array]]:
        """Each phase with angles in it and their weights, by Gauss's rule."""
        nodes, weights = np.polynomial.legendre.leggauss(GAUSS_NODES)
        for phase in self.phases:
            half = 0.5 * (phase.end - phase.theta)
            yield phase, phase.theta + half * (1.0 + nodes), half * weights

    def _wave(self, of: str, phase: Phase, theta: Array) -> Array:
        """What is asked for of the motion within a phase."""
        u, _, a = self._within(phase, theta).T
        # spring, damper and friction: what accelerates the mass, and at rest holds against all of the force
        return -a if of == "force" else np.asarray(u + self.F_0 * np.cos(theta)) if of == "absolute" else u

    def _highest(self, of: str, phase: Phase) -> float:
        """The largest size of that within a phase, its ends included."""
        grid = np.linspace(phase.theta, phase.end, PEAK_SAMPLES)
        sizes = np.abs(self._wave(of, phase, grid))
        top = int(np.argmax(sizes))
        if top in (0, sizes.size - 1):
            return float(sizes[top])
        # here, not above: a first motion does without SciPy, whose import takes longer than all else
        from scipy.optimize import minimize_scalar

        found = minimize_scalar(
            lambda theta: -abs(float(self._wave(of, phase, np.array([theta]))[0])),
            bounds=(grid[top - 1], grid[top + 1]),
            method="bounded",
            options={"xatol": 1e-9},
        )
        return max(float(sizes[top]), -float(found.fun))

    def _within(self, phase: Phase, theta: Array) -> Array:
        """u, v and acceleration at angles within a phase, as `compiled.sample` has them."""
        return compiled.sample(Forced(self.cycle.system, self.Omega, self.F_0), phase, theta)

    def _state(self, theta: float) -> tuple[float, float]:
        """(u, v) at one angle of the forcing: as `_at`, in a third of the time, as time stepping asks often."""
        start, span = float(self.unknowns[1]), self.cycle.half_turns * math.pi
        turns = math.floor((theta - start) / span)
        local = theta - turns * span
        phase = next((one for one in reversed(self.phases) if one.theta <= local), self.phases[0])
        ((u, v, _),) = self._within(phase, np.array([local])).tolist()
        sign = self.cycle.sign if turns % 2 else 1
        return sign * u, sign * v

    def _at(self, theta: Array) -> tuple[Array, Array]:
        start, span = float(self.unknowns[1]), self.cycle.half_turns * math.pi
        turns = np.floor((theta - start) / span)
        local = theta - turns * span
        sign = np.where(turns % 2 == 0, 1.0, float(self.cycle.sign))
        out = np.zeros((theta.size, 3))
        phases = self.phases
        order = np.argsort(local)
        which = np.clip(np.searchsorted([p.theta for p in phases], local[order], side="right") - 1, 0, None)
        for i, phase in enumerate(phases):
            chosen = order[which == i]
            if chosen.size:
                out[chosen] = self._within(phase, local[chosen])
        return sign * out[:, 0], sign * out[:, 1]


@limited()
def steady_state(
    system: EquationOfMotion,
    guess: SteadyState | tuple[float, float] | None = None,
    *,
    Omega: float,
    F_0: float,
    half_turns: int | None = None,
    u_0: float = 0.0,
    v_0: float = 0.0,
) -> SteadyState:
    """The periodic motion at one frequency.

    guess      -- a neighbouring `SteadyState`, or (A, phi) of u = A cos(Omega tau + phi); without it the mass is
                  released at u_0 with the velocity v_0, where the forcing is largest, and followed until it settles,
                  which finds stable motions only
    half_turns -- 1: look for half-wave symmetric motions u(tau + pi/Omega) = -u(tau); 2: for any with the forcing's
                  period; n: with the state (-1)^n times the same after n pi/Omega. By default all of up to 16 turns
                  of the forcing, the shortest first; under a load none that are their own mirror images.

    A guess leads to a motion near it, stable or not; if Newton's iteration finds none, the motion is followed from the
    guess until it settles. The motion returned has been followed through all its switches.
    Raises ValueError for parameters out of range or where friction holds the mass for ever, ArithmeticError if nothing
    periodic is found.
    """
    check_forcing(system, Omega, F_0, begins=(u_0, v_0) if guess is None else None)
    forced = Forced(system, float(Omega), float(F_0))
    tries = lengths(system) if half_turns is None else (half_turns,)
    theta, u, v = 0.0, u_0, v_0
    if isinstance(guess, SteadyState):
        cycle = guess.cycle
        if cycle.system is not system:
            cycle = replace(cycle, system=system)
        z = guess.unknowns.copy()
        z[-1] = Omega
        found = _settle_signature(cycle, z, forced, tries)
        if found is not None:
            return _once(found, forced, tries)
        theta, u, v = float(z[1]), float(z[0]), 0.0
    elif guess is not None:
        (theta, u), v = _start(guess), 0.0
        found = _near(forced, theta, u, tries, u)
        if found is not None:
            return found
    return _by_time_stepping(forced, theta, (u, v), tries)


@limited()
def near(
    system: EquationOfMotion,
    Omega: float,
    F_0: float,
    guess: tuple[float, float],
    *,
    B: float = 0.0,
) -> SteadyState | None:
    """The motion, stable or not, that Newton's iteration finds near u = B + A cos(Omega tau + phi), guess = (A, phi).

    None if it finds none of half to one and a half times that amplitude, or the mass released there escapes. Raises
    ValueError for parameters out of range.
    """
    check_forcing(system, Omega, F_0)
    theta, u = _start(guess)
    try:
        forced = Forced(system, float(Omega), float(F_0))
        return _near(forced, theta, u + B, lengths(system), u + abs(B))
    except ArithmeticError:
        return None


def _start(guess: tuple[float, float]) -> tuple[float, float]:
    """theta and u of the highest point of u = A cos(Omega tau + phi)."""
    A, phi = guess
    if not (math.isfinite(A) and A > 0 and math.isfinite(phi)):
        raise Refused(f"guess = (A, phi) = {guess} must be finite, A positive")
    return (-phi) % TURN, float(A)


def _near(forced: Forced, theta: float, u: float, tries: tuple[int, ...], A: float) -> SteadyState | None:
    """The motion whose largest |u| is about A that Newton's iteration finds from rest at (theta, u)."""
    for n in tries[:2]:
        found = from_start(forced, theta, u, n)
        if found is not None and abs(found.A - A) <= 0.5 * A:
            return _once(found, forced, tries)
    return None


def _once(found: SteadyState, forced: Forced, tries: tuple[int, ...]) -> SteadyState:
    """The motion over its own period, where what was found goes through it several times.

    Turns that are looked at by chance may come nearer to each other three apart than one: where a motion settles by
    a third of a turn in each, a longer cycle is closed first.
    """
    theta, u = float(found.unknowns[1]), float(found.unknowns[0])
    for n in sorted(tries):
        if n >= found.cycle.half_turns:
            break
        there = found._state(theta + math.pi * n)
        sign = -1 if n % 2 else 1
        if found.cycle.half_turns % n == 0 and max(abs(there[0] - sign * u), abs(there[1])) <= AGAIN * found.A:
            shorter = from_start(forced, theta, u, n)
            if shorter is not None and abs(shorter.A - found.A) <= AGAIN * found.A:
                return shorter
    return found


def comes_to_rest(system: EquationOfMotion, Omega: float, F_0: float, u: float, v: float) -> SteadyState | None:
    """The place at which a motion from (u, v) stays at rest for ever, as a steady state; None where it moves on."""
    check_numbers(system, Omega, F_0)
    if v == 0 and stays_at_rest(system, Omega, F_0, u):
        return held(system, Omega, F_0, u)
    if not only_rests(system, Omega, F_0):
        return None
    end = settle(Forced(system, Omega, F_0), 0.0, u, v, lengths(system), MOST_TURNS)
    return held(system, Omega, F_0, end.u) if at_rest(end.phases) else None


def held(system: EquationOfMotion, Omega: float, F_0: float, u: float) -> SteadyState:
    """A mass that friction holds at u for ever, as a steady state: about any place nearby it would as well.

    A deviation of u stays, and one of the velocity ends: the multipliers are 1 and 0, and it is stable.
    """
    check_numbers(system, Omega, F_0)
    region = system.force.region_of(u)
    phase = Phase(0, region, 0.0, u, 0.0, TURN, u, 0.0, 0)
    return SteadyState(
        Omega=Omega,
        F_0=F_0,
        A=abs(u),
        stops=1,
        multipliers=np.array([1.0, 0.0], dtype=np.complex128),
        half_multipliers=None,
        stable=True,
        symmetric=False,
        cycle=Cycle(system, ((0, region),), 2),
        unknowns=np.array([u, 0.0, TURN, Omega]),
        phases=[phase],
    )


def describe(cycle: Cycle, z: Array, F_0: float, monodromy: Array, phases: list[Phase] | None = None) -> SteadyState:
    """The `SteadyState` of a converged cycle.

    phases -- of one cycle; they are followed where they are not at hand
    """
    multipliers = cycle.multipliers(monodromy)
    symmetric = cycle.sign == -1
    half = multipliers if symmetric else None
    if symmetric:
        multipliers = multipliers**2
    Omega = float(z[-1])
    phases = cycle.phases(z, F_0)[: len(cycle.signature)] if phases is None else phases
    return SteadyState(
        Omega=Omega,
        F_0=F_0,
        A=largest(phases),
        stops=cycle.stops,
        multipliers=multipliers,
        half_multipliers=half,
        stable=all(abs(multiplier) < 1.0 for multiplier in multipliers.tolist()),
        symmetric=symmetric,
        cycle=cycle,
        unknowns=z,
        phases=phases,
    )


def at_rest(phases: list[Phase]) -> bool:
    """Whether the mass rests all the time."""
    return all(phase.slip == 0 for phase in phases)


def largest(phases: list[Phase]) -> float:
    """The largest |u| of them, which lies at a switch."""
    return max(max(abs(phase.u), abs(phase.u_end)) for phase in phases)


def from_start(forced: Forced, theta: float, u: float, half_turns: int, v: float = 0.0) -> SteadyState | None:
    """Newton's iteration with the order of switches that the motion from (theta, u, v) shows."""
    end = theta + shown_in(half_turns) * math.pi
    closed = closed_cycle(forced.system, half_turns, follow(forced, theta, u, v, end), forced.Omega)
    return None if closed is None else _settle_signature(*closed, forced, (half_turns,))


def _settle_signature(cycle: Cycle, z: Array, forced: Forced, tries: tuple[int, ...]) -> SteadyState | None:
    """Newton's iteration, repeated with the order of switches of what it found until that order holds."""
    if cycle.half_turns not in tries:
        return None
    seen = set()
    for _ in range(8):
        seen.add(cycle.signature)
        solved = cycle.newton(z, forced.F_0)
        if solved is None:
            return None
        z, equations = solved
        phases = cycle.followed(z, forced.F_0)
        if phases is not None:
            return describe(cycle, z, forced.F_0, equations.monodromy, phases)
        theta, u = float(z[1]), float(z[0])
        end = theta + shown_in(cycle.half_turns) * math.pi
        try:
            motion = follow(forced, theta, u, 0.0, end)
        except ArithmeticError:
            return None
        closed = closed_cycle(forced.system, cycle.half_turns, motion, forced.Omega)
        if closed is None or closed[0].signature in seen:
            return None
        cycle, z = closed
    return None


class Settled(NamedTuple):
    """Where time stepping ends: the motion that is approached, None if none was found; the turns that were followed.

    u, v   -- the state at the start of a turn: that of the motion found, else the last one
    phases -- the last turn followed
    change -- of (u, v), over the last turn or the last turns of a subharmonic
    adrift -- the motion about u = 0 that is approached but for its mean, which no force brings back; else None
    repeats -- whether the last turn is as the one before, as the mass rests at u = 0 in both, where the force jumps
    """

    found: SteadyState | None
    turns: int
    u: float
    v: float
    phases: list[Phase]
    change: float
    adrift: SteadyState | None = None
    repeats: bool = False


def settle(forced: Forced, theta: float, u: float, v: float, tries: tuple[int, ...], most_turns: int) -> Settled:
    """Follows the motion from (theta, u, v) until it is shown to approach a stable periodic one, or has ended.

    tries -- half turns of the cycles that are looked for, see `steady_state`
    Raises ArithmeticError if the motion escapes or chatters.
    """
    history = [(u, v)]
    phases: list[Phase] = []
    change = math.inf
    ask = 1
    known: dict[int, SteadyState] = {}
    while len(history) <= most_turns:
        phases = follow(forced, theta, u, v, theta + TURN)
        u, v = phases[-1].u_end, phases[-1].v_end
        history.append((u, v))
        if at_rest(phases):
            return Settled(None, len(history) - 1, u, v, phases, 0.0)
        if rests_at_jump(forced.system, phases):
            change = max(abs(u - history[-2][0]), abs(v - history[-2][1]))
            if change <= AGAIN * largest(phases):
                return Settled(None, len(history) - 1, u, v, phases, change, repeats=True)
        if len(history) <= ask:
            continue
        ask += min(ask, ASKED_AGAIN)
        scale = COMES_BACK * largest(phases)
        change = sooner = math.inf  # after any number of turns, and after fewer
        last = 0
        for n in tries:
            turns = _turns(n)
            if turns >= len(history):
                break
            if turns > last:
                sooner, last = change, turns
            before = history[-1 - turns]
            back = max(abs(u - before[0]), abs(v - before[1]))
            change = min(change, back)
            if back >= scale or (turns > SHORT and back > NEARER_BACK * sooner):
                continue
            found = known.get(n) or from_start(forced, theta, u, n, v)
            if found is not None and _is_adrift(found):
                return Settled(None, len(history) - 1, u, v, phases, change, found)
            if found is not None and (found.stable or _is_neutral(found)):
                found = known.get(n) or _once(found, forced, tries)
                there = _passed(found, theta, u, v)
                if found.stable and _approaches(forced, found, theta, (u, v), there):
                    return Settled(found, len(history) - 1, *there, phases, change)
                if _drifts_to(forced, found, theta, u, there):
                    return Settled(replace(found, stable=True), len(history) - 1, *there, phases, change)
                # it is nearer the next time, or this is not the one
                known = {n: found} if max(abs(u - there[0]), abs(v - there[1])) < scale else {}
    return Settled(None, len(history) - 1, u, v, phases, change)


def _by_time_stepping(forced: Forced, theta: float, state: tuple[float, float], tries: tuple[int, ...]) -> SteadyState:
    """The motion that the one from (theta, u, v) settles to."""
    settled = settle(forced, theta, *state, tries, MOST_TURNS)
    parted = _parted(forced, theta, settled)
    if settled.found is not None:
        return settled.found
    if settled.adrift is not None:
        ends = forced.system.force.breakpoints
        where = WITHIN_END.format(ends[0]) if ends else "where"
        raise NotSettled(ADRIFT.format(Omega=forced.Omega, F_0=forced.F_0, A=settled.adrift.A, where=where))
    if settled.repeats:
        raise NotPeriodic(RESTS_AT_JUMP.format(Omega=forced.Omega, F_0=forced.F_0, A=largest(settled.phases)))
    if at_rest(settled.phases):
        raise NotPeriodic(COMES_TO_REST.format(Omega=forced.Omega, F_0=forced.F_0, u=state[0]))
    if parted >= PARTED:
        rate = parted ** (1.0 / PARTING_TURNS)
        raise NotPeriodic(
            CHAOTIC.format(Omega=forced.Omega, F_0=forced.F_0, turns=settled.turns + PARTING_TURNS, rate=rate)
        )
    share, longest = settled.change / largest(settled.phases), max(map(_turns, tries))
    why = (
        "it repeats itself, but Newton's iteration does not find it: sweep follows it in time"
        if share <= AGAIN
        else "it still drifts, too slowly to be followed to where it settles"
        if share < 1e-3
        else f"it may be on its way still, or chaotic, or a subharmonic of more than {longest} turns"
    )
    raise NotPeriodic(NOT_FOUND.format(forced.Omega, forced.F_0, settled.turns, settled.change, why))


def _parted(forced: Forced, theta: float, settled: Settled) -> float:
    """By what a motion that has not settled and one beside it part within `PARTING_TURNS` turns, on average of these.

    The one beside is brought near again after each turn; 1 of a motion that has an end.
    """
    ends = settled.found is not None or settled.adrift is not None or settled.repeats
    if ends or at_rest(settled.phases):
        return 1.0
    parted, near = 1.0, 1e-7 * largest(settled.phases)
    here, beside = (settled.u, settled.v), (settled.u + near, settled.v)
    for _ in range(PARTING_TURNS):
        here, there = (
            (last.u_end, last.v_end)
            for last in (follow(forced, theta, *state, theta + TURN)[-1] for state in (here, beside))
        )
        way = there[0] - here[0], there[1] - here[1]
        share = near / max(math.hypot(*way), 1e-6 * near)
        parted /= share
        beside = here[0] + share * way[0], here[1] + share * way[1]
    return parted


def calmed(forced: Forced, theta: float, end: Settled, most_turns: int) -> Settled:
    """A motion that is adrift, followed on until it does not change any more from turn to turn, or for `most_turns`."""
    turns, u, v, phases, change = end.turns, end.u, end.v, end.phases, end.change
    while turns < most_turns and change > CALM * largest(phases):
        before = u, v
        phases = follow(forced, theta, u, v, theta + TURN)
        u, v = phases[-1].u_end, phases[-1].v_end
        turns, change = turns + 1, max(abs(u - before[0]), abs(v - before[1]))
    return Settled(None, turns, u, v, phases, change, end.adrift)


def _is_adrift(found: SteadyState) -> bool:
    """Whether a motion stays where the force is 0, as within a play: then it may as well be about any other place."""
    inner = found.cycle.system.force.pieces[0]
    within = all(region == 0 for _, region in found.cycle.signature)
    return within and all(inner.slope(share * found.A) == 0 for share in WITHIN)


def _is_neutral(found: SteadyState) -> bool:
    """Whether rounding may hide how a symmetric motion's mean is brought back: a multiplier of half of it is -1."""
    half = found.half_multipliers
    return half is not None and bool(np.min(np.abs(half + 1.0)) < NEUTRAL)


def _drifts_to(forced: Forced, found: SteadyState, theta: float, u: float, there: tuple[float, float]) -> bool:
    """Whether a motion at u tends to the neutral one found, which passes `there`, though rounding hides how it moves.

    The mean is brought back by the spring alone, and the more the farther off it is, where the force rises all the way:
    so what moves farther off tells of the way between, from the nearest place on at which it is seen to move.
    """
    if not _is_neutral(found):
        return False
    end = theta + found.Omega * found.period

    def way(off: float) -> float:
        return follow(forced, theta, there[0] + off, there[1], end)[-1].u_end - (there[0] + off)

    away, still = abs(u - there[0]), abs(way(0.0))
    off = math.copysign(AGAIN * found.A, u - there[0])
    for _ in range(FARTHER):
        largest = found.A + abs(off)
        if not _rises(forced.system, largest):
            return False
        moved = way(off)
        if abs(moved) > SEEN * max(still, 2.0**-53 * largest):
            if not (moved * off < 0.0 and abs(moved) < abs(off)):
                return False
            if abs(off) >= away:
                return True
        off *= 2.0
    return False


def _rises(system: EquationOfMotion, A: float) -> bool:
    """Whether the force nowhere falls up to |u| = A; at SLOPES places."""
    places = (A * i / SLOPES for i in range(-SLOPES, SLOPES + 1))
    return all(system.force.piece(system.force.region_of(u)).slope(u) >= 0.0 for u in places)


def _passed(found: SteadyState, theta: float, u: float, v: float) -> tuple[float, float]:
    """The state of the motion found at theta that lies nearest to (u, v): a subharmonic passes in any of its turns."""
    passed = (found._state(theta + TURN * turn) for turn in range(found.cycle.half_turns))
    return min(passed, key=lambda there: max(abs(there[0] - u), abs(there[1] - v)))


def _approaches(
    forced: Forced, found: SteadyState, theta: float, state: tuple[float, float], there: tuple[float, float]
) -> bool:
    """Whether the motion through `state` tends to the stable one found, which passes `there`.

    It does where the map over a period is near its linear part, so that the multipliers' rate of approach holds: the
    way that `state` makes in a period differs from ten times the way of a state ten times as near by less than half of
    what the larger multiplier brings it nearer. Of the way itself that may be next to nothing: lightly damped, a motion
    goes round and round the one found, or round one that it does not come to.
    A motion that merely lingers, or drifts too slowly to be seen, fails this whatever its distance.
    """
    away = state[0] - there[0], state[1] - there[1]
    distance = max(map(abs, away))
    if distance <= ARRIVED * found.A:
        return True
    nears = (1.0 - max(map(abs, found.multipliers.tolist()))) * distance
    end = theta + found.Omega * found.period
    ways = []
    for share in (1.0, NEARER):
        u, v = there[0] + share * away[0], there[1] + share * away[1]
        last = follow(forced, theta, u, v, end)[-1]
        ways.append(((last.u_end - u) / share, (last.v_end - v) / share))
    (of_u, of_v), (nearer_of_u, nearer_of_v) = ways
    return bool(max(abs(of_u - nearer_of_u), abs(of_v - nearer_of_v)) <= UNLIKE * nears)
