"""Shooting: the steady state at one frequency by Newton's iteration, from a guess or from time stepping.

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

from slowflow.answers.answer import Answer, in_values
from slowflow.answers.transmissibility import Transmitted, validated
from slowflow.core import validate
from slowflow.core.mechanism import EquationOfMotion, Floats
from slowflow.exact import motion
from slowflow.exact.cycle import Cycle, closed_cycle, required_half_turns, sticks_at_jump
from slowflow.exact.motion import TURN, Forced, Phase, check_forcing, check_numbers, follow, limited
from slowflow.support.errors import NotSettled, Refused
from slowflow.support.quadrature import gauss
from slowflow.support.text import Sentence

MOST_TURNS = 3000  # of the forcing, before time stepping gives up
DIVERGENCE_TURNS = 30  # over which motions that begin next to each other are compared
#: the least factor by which they diverge in these turns if chaotic; otherwise they diverge at most linearly in time
DIVERGENCE = 1e3
LONGEST = 16  # turns of the forcing that a motion may take, as subharmonics do
#: lengths of a cycle that are tried, by turns of the forcing: a motion of an odd number may be its own mirror image
HALF_TURNS = tuple(n for turns in range(1, LONGEST + 1) for n in ((turns, 2 * turns) if turns % 2 else (2 * turns,)))
SHORT = 3  # periods, in turns, that are always tried where the motion returns
#: ratio of the distances at the return after more and after fewer turns below which a longer subharmonic is tried
NEARER_BACK = 0.1
#: distance, over the largest |u|, of a return at which Newton's iteration is tried; turns at most between two tests
COMES_BACK, CHECK_INTERVAL = 0.01, 8
#: distance from a stable motion, over A, that counts as convergence; the smaller of two deviations by which the period
#: map is tested for linearity, and how much their changes may differ
ARRIVED, NEARER, UNLIKE = 1e-8, 0.1, 0.5


def lengths(system: EquationOfMotion) -> tuple[int, ...]:
    """`HALF_TURNS` that a motion may have: an asymmetric motion is never its own mirror image half a turn later."""
    return HALF_TURNS if system.centred else tuple(n for n in HALF_TURNS if n % 2 == 0)


def _turns(half_turns: int) -> int:
    """The period, in turns of the forcing, of a motion whose cycle has that many half turns."""
    return half_turns if half_turns % 2 else half_turns // 2


CLOSURE = 1e-9  # distance, over the amplitude, at which a motion counts as closed
GAUSS_NODES = 40  # per phase of the motion, for its harmonics
#: positions per phase at which a transmitted wave is searched for its largest size, and how often between two of them:
#: the distance of positions is then 5e-7 of the phase, by whose square the size may be off
PEAK_SAMPLES, PEAK_ROUNDS = 65, 4
#: fractions of the amplitude at which the stiffness is tested for zero
FRACTIONS = (0.25, 0.5, 0.9)
#: change in a turn of the forcing, over the amplitude, at which a motion with a free mean counts as steady
UNCHANGED = 1e-10
#: distance of a multiplier from 1 beyond which it decides stability by itself
NEUTRAL = 1e-6
#: doublings of the distance from a neutral motion; ratio of a drift to rounding that is significant
FARTHER, SEEN = 60, 100.0
#: positions on each side at which the slope of the force is tested
SLOPES = 16

FREE_MEAN = Sentence(
    "the steady state at {Omega = :g}, {F_0 = :g} is not unique: a motion of amplitude {A:.6g} stays {where:s} no "
    "force restores its mean, so that the mean is arbitrary; {A = :.6g} gives the motion about {u} = 0"
)
WITHIN_END = Sentence("within |{u}| = {u:g}, where")

CHAOTIC = Sentence(
    "no steady state found at {Omega = :g}, {F_0 = :g}: the motion is chaotic, as far as {turns:d} periods of "
    "the forcing show: neighbouring motions separate by a factor of {rate:.2g} in each; A= gives the periodic "
    "motion, stable or not, nearest to an amplitude"
)
STICKS_AT_JUMP = Sentence(
    "the motion at {Omega = :g}, {F_0 = :g} is periodic with {A = :.6g}, but the mass comes to rest at {u} = 0 in each "
    "period, where the force jumps, after infinitely many crossings: it has no multipliers; sweep follows it in time"
)
COMES_TO_REST = Sentence(
    "no steady state found at {Omega = :g}, {F_0 = :g}: a motion from {u = :.6g} comes to rest, where "
    "friction holds the mass"
)
NOT_FOUND = Sentence(
    "no steady state found at {Omega = :}, {F_0 = :}: after {turns:d} periods of the forcing the motion comes back "
    "only to within {A:.1e}; {why:s}"
)


class NotPeriodic(NotSettled):
    """The motion did not approach a periodic one within `MOST_TURNS` periods of the forcing."""


@dataclass(frozen=True, eq=False)
class SteadyState(Answer):
    """A periodic motion. All quantities dimensionless; arrays over one period have `samples` entries, tau from 0.

    F_0          -- amplitude of the excitation; `force` is the amplitude of the force
    A            -- largest |u|, the mean included, with a relative error of about 1e-13
    stops        -- number of stick phases per period
    multipliers  -- Floquet multipliers over `period`, shape (2,)
    half_multipliers -- multipliers of the map over half a period with u -> -u, for a half-wave symmetric motion, else
            None; `multipliers` are their squares
    stable       -- whether both multipliers lie inside the unit circle
    symmetric    -- whether u(tau + period/2) = -u(tau)
    phases       -- phases of one cycle, from its highest turning point
    message      -- diagnostics as text; empty if there are none
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
    unknowns: Floats = field(repr=False)
    phases: list[Phase] = field(repr=False)
    message: str = ""

    @property
    def force(self) -> float:
        """Amplitude of the force on the mass: F_0, or F_0 Omega^2 for base excitation and unbalance."""
        return self.cycle.system.forcing(Omega=self.Omega, F_0=self.F_0)

    @property
    def period(self) -> float:
        """Period in tau."""
        return self.cycle.half_turns * (2 if self.symmetric else 1) * math.pi / self.Omega

    @functools.cached_property
    def residual(self) -> float:
        """Residual of periodicity: difference of (u, v) after one period, from a point within the first phase."""
        forced = Forced(self.cycle.system, self.Omega, self.F_0)
        slip, region = self.cycle.signature[0]
        theta, span = float(self.unknowns[1]), float(self.unknowns[2])
        middle = theta + 0.5 * span
        ((u, v, _),) = self._sample_phase(self.phases[0], np.array([middle])).tolist()
        last = follow(forced, middle, u, v, middle + self.Omega * self.period, (slip, region))[-1]
        return float(max(abs(last.u_end - u), abs(last.v_end - v)))

    @property
    def undecided(self) -> bool:
        """Whether rounding decides if there is a further stop: the velocity touches zero within a slip phase."""
        return any(phase.undecided for phase in self.phases)

    def series(self, samples: int = 400) -> tuple[Floats, Floats, Floats]:
        """tau, u, v = du/dtau at `samples` equal steps of one period from tau = 0, where the forcing is largest."""
        samples = validate.count("samples", samples, least=1, most=validate.MOST_SAMPLES)
        theta = self.Omega * self.period * np.arange(samples) / samples
        u, v = self._at(theta)
        return theta / self.Omega, u, v

    def columns(self, samples: int = 400) -> dict[str, Floats]:
        """Return tau, u and v from `series`, for `to_pandas` and `to_xarray`."""
        return dict(zip(("tau", "u", "v"), self.series(samples), strict=True))

    def about(self) -> dict[str, Any]:
        """Return frequency, forcing, amplitude, stops, stability."""
        return {name: getattr(self, name) for name in ("Omega", "F_0", "A", "stops", "stable", "symmetric", "period")}

    def __str__(self) -> str:
        return "\n".join(in_values(self, self.about()))

    def harmonics(self, most: int = 7) -> NDArray[np.complex128]:
        """Compute c_0 ... c_most of u = Re sum c_k exp(i k Omega' tau), Omega' = 2 pi/period, by Gauss quadrature."""
        orders = np.arange(validate.count("most", most, least=0, most=validate.MOST_SAMPLES) + 1)
        span = self.cycle.half_turns * math.pi
        whole = self.Omega * self.period
        base = TURN / whole
        total = np.zeros(most + 1, dtype=np.complex128)
        for phase, at, weights in self._on_nodes():
            total += np.exp(-1j * base * np.outer(orders, at)) @ (weights * self._sample_phase(phase, at)[:, 0])
        if whole > span * 1.5:  # the second half of a symmetric motion mirrors the first
            total *= 1.0 - (-1.0) ** orders
        total *= 2.0 / whole
        total[0] *= 0.5
        return total

    def transmitted(self, of: str = "force") -> Transmitted:
        """Transmissibility with all harmonics: first harmonic, peak and root mean square.

        of -- "force": force of spring, damper and friction over the amplitude of the force; under base excitation this
              is also the acceleration of the mass over that of the base. "relative": u over F_0, mean included.
              "absolute": under base excitation the displacement of the mass over that of the base, with an unbalance
              the displacement of the centre of mass over F_0.

        Raises ValueError for another `of`, and for "absolute" under a force.
        """
        validated(of, inertial=self.cycle.system.inertial)
        whole = self.cycle.half_turns * math.pi
        square, first, peak = 0.0, 0j, 0.0
        for phase, at, weights in self._on_nodes():
            wave = self._wave(of, phase, at)
            square += float(weights @ wave**2)
            first += complex((weights * wave) @ np.exp(-1j * at))
            peak = max(peak, self._highest(of, phase))
        scale = self.force if of == "force" else self.F_0
        return Transmitted(2.0 * abs(first) / whole / scale, peak / scale, math.sqrt(square / whole) / scale)

    def _on_nodes(self) -> Iterator[tuple[Phase, Floats, Floats]]:
        """Each phase with angles in it and their weights, by Gauss's rule."""
        nodes, weights = gauss(GAUSS_NODES)
        for phase in self.phases:
            width = phase.end - phase.theta
            yield phase, phase.theta + width * nodes, width * weights

    def _wave(self, of: str, phase: Phase, theta: Floats) -> Floats:
        """The wave `of` the motion within a phase."""
        u, _, a = self._sample_phase(phase, theta).T
        # spring, damper and friction accelerate the mass, and balance all of the force at rest
        return -a if of == "force" else np.asarray(u + self.F_0 * np.cos(theta)) if of == "absolute" else u

    def _highest(self, of: str, phase: Phase) -> float:
        """The largest size of that within a phase, its ends included, on ever finer grids about each local maximum."""

        def sizes_between(low: float, high: float) -> tuple[Floats, Floats]:
            grid = np.linspace(low, high, PEAK_SAMPLES)
            return grid, np.abs(self._wave(of, phase, grid))

        grid, sizes = sizes_between(phase.theta, phase.end)
        top = float(sizes.max())
        # all of them: both ends of a half turn have the same size, and the peak may be next to either
        bordered = np.concatenate(([-1.0], sizes, [-1.0]))
        for at in np.flatnonzero((sizes > bordered[:-2]) & (sizes >= bordered[2:])).tolist():
            about = grid
            for _ in range(PEAK_ROUNDS - 1):
                about, finer = sizes_between(about[max(at - 1, 0)], about[min(at + 1, PEAK_SAMPLES - 1)])
                at = int(np.argmax(finer))
                top = max(top, float(finer[at]))
        return top

    def _sample_phase(self, phase: Phase, theta: Floats) -> Floats:
        """u, v and acceleration at angles within a phase, as `motion.sample` has them."""
        return motion.sample(Forced(self.cycle.system, self.Omega, self.F_0), phase, theta)

    def _state(self, theta: float) -> tuple[float, float]:
        """(u, v) at one angle of the forcing."""
        ((u,), (v,)) = self._at(np.array([theta]))
        return float(u), float(v)

    def _at(self, theta: Floats) -> tuple[Floats, Floats]:
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
                out[chosen] = self._sample_phase(phase, local[chosen])
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
    """Find a periodic motion at one frequency.

    guess      -- a neighbouring `SteadyState`, or (A, phi) of u = A cos(Omega tau + phi); by default the mass is
                  released at u_0 with velocity v_0, where the forcing is largest, and followed until it settles, which
                  finds stable motions only
    half_turns -- 1: half-wave symmetric motions u(tau + pi/Omega) = -u(tau); 2: any motion with the period of the
                  forcing; n: motions whose state after n pi/Omega is (-1)^n times the initial one. By default motions
                  of up to 16 periods of the forcing are tried, the shortest first; under a load, motions that are
                  their own mirror images are left out.

    A guess leads to a motion near it, stable or not; if Newton's iteration does not converge, the motion is followed
    from the guess until it settles. The returned motion is verified through all its switches. Raises ValueError for
    parameters out of range or if friction holds the mass permanently, ArithmeticError if nothing periodic is found.
    """
    check_forcing(system, Omega, F_0, initial=(u_0, v_0) if guess is None else None)
    forced = Forced(system, float(Omega), float(F_0))
    tries = lengths(system) if half_turns is None else (half_turns,)
    theta, u, v = 0.0, u_0, v_0
    if isinstance(guess, SteadyState):
        cycle = guess.cycle
        if cycle.system is not system:
            cycle = replace(cycle, system=system)
        z = guess.unknowns.copy()
        z[-1] = Omega
        found = _converge_signature(cycle, z, forced, tries)
        if found is not None:
            return _minimal_period(found, forced, tries)
        theta, u, v = float(z[1]), float(z[0]), 0.0
    elif guess is not None:
        (theta, u), v = _start(guess), 0.0
        found = _near(forced, theta, u, tries, u)
        if found is not None:
            return found
    return _by_time_stepping(forced, theta, (u, v), tries)


@limited()
def near(
    system: EquationOfMotion, Omega: float, F_0: float, guess: tuple[float, float], *, B: float = 0.0
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
            return _minimal_period(found, forced, tries)
    return None


def _minimal_period(found: SteadyState, forced: Forced, tries: tuple[int, ...]) -> SteadyState:
    """The motion over its minimal period, of which the cycle found may be a multiple.

    Where a motion converges by a rotation of a third of a turn per turn, states three turns apart are nearest, and a
    longer cycle is closed first.
    """
    theta, u = float(found.unknowns[1]), float(found.unknowns[0])
    for n in sorted(tries):
        if n >= found.cycle.half_turns:
            break
        there = found._state(theta + math.pi * n)
        sign = -1 if n % 2 else 1
        if found.cycle.half_turns % n == 0 and max(abs(there[0] - sign * u), abs(there[1])) <= CLOSURE * found.A:
            shorter = from_start(forced, theta, u, n)
            if shorter is not None and abs(shorter.A - found.A) <= CLOSURE * found.A:
                return shorter
    return found


def static_state_from(system: EquationOfMotion, Omega: float, F_0: float, u: float, v: float) -> SteadyState | None:
    """The position at which a motion from (u, v) sticks for good, as a steady state; None where it keeps moving."""
    check_numbers(system, Omega, F_0)
    if v == 0 and motion.stays_at_rest(system, Omega, F_0, u):
        return static_state(system, Omega, F_0, u)
    if not motion.must_stick(system, Omega, F_0):
        return None
    end = converge(Forced(system, Omega, F_0), 0.0, u, v, lengths(system), MOST_TURNS)
    return static_state(system, Omega, F_0, end.u) if at_rest(end.phases) else None


def static_state(system: EquationOfMotion, Omega: float, F_0: float, u: float) -> SteadyState:
    """A mass that friction holds at u, as a steady state: any position nearby is one as well.

    A deviation of u persists, and one of the velocity ends: the multipliers are 1 and 0, and it is stable.
    """
    check_numbers(system, Omega, F_0)
    region = system.force.region_of(u)
    phase = Phase(0, region, 0.0, u, 0.0, TURN, u, 0.0, 0)
    z = np.array([u, 0.0, TURN, Omega])
    return describe(Cycle(system, ((0, region),), 2), z, F_0, np.diag((1.0, 0.0)), [phase], stable=True)


def describe(
    cycle: Cycle,
    z: Floats,
    F_0: float,
    monodromy: Floats,
    phases: list[Phase] | None = None,
    *,
    stable: bool | None = None,
) -> SteadyState:
    """The `SteadyState` of a converged cycle.

    phases -- of one cycle; by default integrated anew
    stable -- by default by the multipliers
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
        stable=all(abs(one) < 1.0 for one in multipliers.tolist()) if stable is None else stable,
        symmetric=symmetric,
        cycle=cycle,
        unknowns=z,
        phases=phases,
    )


def at_rest(phases: list[Phase]) -> bool:
    """Whether the mass sticks in all phases."""
    return all(phase.slip == 0 for phase in phases)


def largest(phases: list[Phase]) -> float:
    """The largest |u| of them, which lies at a switch."""
    return max(max(abs(phase.u), abs(phase.u_end)) for phase in phases)


def from_start(forced: Forced, theta: float, u: float, half_turns: int, v: float = 0.0) -> SteadyState | None:
    """Newton's iteration with the order of switches that the motion from (theta, u, v) shows."""
    end = theta + required_half_turns(half_turns) * math.pi
    closed = closed_cycle(forced, half_turns, follow(forced, theta, u, v, end))
    return None if closed is None else _converge_signature(*closed, forced, (half_turns,))


def _converge_signature(cycle: Cycle, z: Floats, forced: Forced, tries: tuple[int, ...]) -> SteadyState | None:
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
        phases = cycle.verified_phases(z, forced.F_0)
        if phases is not None:
            return describe(cycle, z, forced.F_0, equations.monodromy, phases)
        theta, u = float(z[1]), float(z[0])
        end = theta + required_half_turns(cycle.half_turns) * math.pi
        try:
            motion = follow(forced, theta, u, 0.0, end)
        except ArithmeticError:
            return None
        closed = closed_cycle(forced, cycle.half_turns, motion)
        if closed is None or closed[0].signature in seen:
            return None
        cycle, z = closed
    return None


class Limit(NamedTuple):
    """Where time stepping ends: the motion that is approached, None if none was found; the number of turns.

    u, v      -- the state at the start of a turn: that of the motion found, else the last one
    phases    -- the last turn
    change    -- of (u, v), over the last turn or the last turns of a subharmonic
    free_mean -- the motion about u = 0 that is approached up to its mean, which no force restores; else None
    repeats   -- whether the last two turns agree, with the mass sticking at u = 0, where the force jumps
    """

    found: SteadyState | None
    turns: int
    u: float
    v: float
    phases: list[Phase]
    change: float
    free_mean: SteadyState | None = None
    repeats: bool = False


def converge(forced: Forced, theta: float, u: float, v: float, tries: tuple[int, ...], most_turns: int) -> Limit:
    """Follows the motion from (theta, u, v) until it is shown to approach a stable periodic one, or has ended.

    tries -- half turns of the cycles that are tried, see `steady_state`
    Raises ArithmeticError if the motion escapes or chatters.
    """
    history = [(u, v)]
    phases: list[Phase] = []
    change = math.inf
    next_check = 1
    known: dict[int, SteadyState] = {}
    while len(history) <= most_turns:
        phases = follow(forced, theta, u, v, theta + TURN)
        u, v = phases[-1].u_end, phases[-1].v_end
        history.append((u, v))
        if at_rest(phases):
            return Limit(None, len(history) - 1, u, v, phases, 0.0)
        if sticks_at_jump(forced.system, phases):
            change = max(abs(u - history[-2][0]), abs(v - history[-2][1]))
            if change <= CLOSURE * largest(phases):
                return Limit(None, len(history) - 1, u, v, phases, change, repeats=True)
        if len(history) <= next_check:
            continue
        next_check += min(next_check, CHECK_INTERVAL)
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
            if found is not None and _has_free_mean(found):
                return Limit(None, len(history) - 1, u, v, phases, change, found)
            if found is not None and (found.stable or _is_neutral(found)):
                found = known.get(n) or _minimal_period(found, forced, tries)
                there = _nearest_state(found, theta, u, v)
                if found.stable and _approaches(forced, found, theta, (u, v), there):
                    return Limit(found, len(history) - 1, *there, phases, change)
                if _drifts_to(forced, found, theta, u, there):
                    return Limit(replace(found, stable=True), len(history) - 1, *there, phases, change)
                # keep it for the next test only if it is near
                known = {n: found} if max(abs(u - there[0]), abs(v - there[1])) < scale else {}
    return Limit(None, len(history) - 1, u, v, phases, change)


def _by_time_stepping(forced: Forced, theta: float, state: tuple[float, float], tries: tuple[int, ...]) -> SteadyState:
    """The motion that the one from (theta, u, v) converges to."""
    end = converge(forced, theta, *state, tries, MOST_TURNS)
    if end.found is not None:
        return end.found
    if end.free_mean is not None:
        breakpoints = forced.system.force.breakpoints
        where = WITHIN_END.format(breakpoints[0]) if breakpoints else "where"
        raise NotSettled(FREE_MEAN.format(Omega=forced.Omega, F_0=forced.F_0, A=end.free_mean.A, where=where))
    if end.repeats:
        raise NotPeriodic(STICKS_AT_JUMP.format(Omega=forced.Omega, F_0=forced.F_0, A=largest(end.phases)))
    if at_rest(end.phases):
        raise NotPeriodic(COMES_TO_REST.format(Omega=forced.Omega, F_0=forced.F_0, u=state[0]))
    if (divergence := _divergence(forced, theta, end)) >= DIVERGENCE:
        rate = divergence ** (1.0 / DIVERGENCE_TURNS)
        raise NotPeriodic(
            CHAOTIC.format(Omega=forced.Omega, F_0=forced.F_0, turns=end.turns + DIVERGENCE_TURNS, rate=rate)
        )
    change, longest = end.change / largest(end.phases), max(map(_turns, tries))
    why = (
        "it is periodic, but Newton's iteration does not converge to it: sweep follows it in time"
        if change <= CLOSURE
        else "it still drifts, too slowly to be followed until it settles"
        if change < 1e-3
        else f"it may not have settled yet, or be chaotic, or be a subharmonic of more than {longest} periods"
    )
    raise NotPeriodic(NOT_FOUND.format(forced.Omega, forced.F_0, end.turns, end.change, why))


def _divergence(forced: Forced, theta: float, end: Limit) -> float:
    """The factor by which neighbouring motions diverge in `DIVERGENCE_TURNS` turns.

    The neighbour is rescaled to its first distance after each turn, as for the largest Lyapunov exponent.
    """
    divergence, near = 1.0, 1e-7 * largest(end.phases)
    here, neighbour = (end.u, end.v), (end.u + near, end.v)
    for _ in range(DIVERGENCE_TURNS):
        here, there = (
            (last.u_end, last.v_end)
            for last in (follow(forced, theta, *state, theta + TURN)[-1] for state in (here, neighbour))
        )
        difference = there[0] - here[0], there[1] - here[1]
        scale = near / max(math.hypot(*difference), 1e-6 * near)
        divergence /= scale
        neighbour = here[0] + scale * difference[0], here[1] + scale * difference[1]
    return divergence


def continue_stepping(forced: Forced, theta: float, end: Limit, most_turns: int) -> Limit:
    """Follow a motion with a free mean on until it does not change from turn to turn, or for `most_turns`."""
    turns, u, v, phases, change = end.turns, end.u, end.v, end.phases, end.change
    while turns < most_turns and change > UNCHANGED * largest(phases):
        before = u, v
        phases = follow(forced, theta, u, v, theta + TURN)
        u, v = phases[-1].u_end, phases[-1].v_end
        turns, change = turns + 1, max(abs(u - before[0]), abs(v - before[1]))
    return Limit(None, turns, u, v, phases, change, end.free_mean)


def _has_free_mean(found: SteadyState) -> bool:
    """Whether a motion stays where the force is 0, as in a dead zone: then its mean is arbitrary."""
    inner = found.cycle.system.force.pieces[0]
    inner_only = all(region == 0 for _, region in found.cycle.signature)
    return inner_only and all(inner.slope(fraction * found.A) == 0 for fraction in FRACTIONS)


def _is_neutral(found: SteadyState) -> bool:
    """Whether rounding may hide the restoring of a symmetric motion's mean: a multiplier over half a period is -1."""
    half = found.half_multipliers
    return half is not None and bool(np.min(np.abs(half + 1.0)) < NEUTRAL)


def _drifts_to(forced: Forced, found: SteadyState, theta: float, u: float, there: tuple[float, float]) -> bool:
    """Whether a motion at u tends to the neutral one found, which passes `there`, though rounding hides its drift.

    The spring alone restores the mean, and the more the farther off it is, where the force is monotone: so the sign of
    the drift between is that at the smallest offset whose drift exceeds rounding.
    """
    if not _is_neutral(found):
        return False
    end = theta + found.Omega * found.period

    def drift(offset: float) -> float:
        return follow(forced, theta, there[0] + offset, there[1], end)[-1].u_end - (there[0] + offset)

    distance, noise = abs(u - there[0]), abs(drift(0.0))
    offset = math.copysign(CLOSURE * found.A, u - there[0])
    for _ in range(FARTHER):
        largest = found.A + abs(offset)
        if not _is_monotone(forced.system, largest):
            return False
        change = drift(offset)
        if abs(change) > SEEN * max(noise, 2.0**-53 * largest):
            if not (change * offset < 0.0 and abs(change) < abs(offset)):
                return False
            if abs(offset) >= distance:
                return True
        offset *= 2.0
    return False


def _is_monotone(system: EquationOfMotion, A: float) -> bool:
    """Whether the force nowhere falls up to |u| = A, tested at SLOPES positions on each side."""
    positions = (A * i / SLOPES for i in range(-SLOPES, SLOPES + 1))
    return all(system.force.piece(system.force.region_of(u)).slope(u) >= 0.0 for u in positions)


def _nearest_state(found: SteadyState, theta: float, u: float, v: float) -> tuple[float, float]:
    """The state of the motion found at theta that lies nearest to (u, v): a subharmonic passes in any of its turns."""
    states = (found._state(theta + TURN * turn) for turn in range(found.cycle.half_turns))
    return min(states, key=lambda there: max(abs(there[0] - u), abs(there[1] - v)))


def _approaches(
    forced: Forced, found: SteadyState, theta: float, state: tuple[float, float], there: tuple[float, float]
) -> bool:
    """Whether the motion through `state` tends to the stable one found, which passes `there`.

    It does where the map over a period is nearly linear, so that the multipliers give the rate of approach: the change
    of `state` in a period differs from ten times that of a state ten times as near by less than half of the decay by
    the larger multiplier. The change itself would not do: lightly damped, a motion circles the one found, or another
    that it does not converge to. A motion that merely lingers, or drifts slowly, fails this at any distance.
    """
    deviation = state[0] - there[0], state[1] - there[1]
    distance = max(map(abs, deviation))
    if distance <= ARRIVED * found.A:
        return True
    decay = (1.0 - max(map(abs, found.multipliers.tolist()))) * distance
    end = theta + found.Omega * found.period
    changes = []
    for scale in (1.0, NEARER):
        u, v = there[0] + scale * deviation[0], there[1] + scale * deviation[1]
        last = follow(forced, theta, u, v, end)[-1]
        changes.append(((last.u_end - u) / scale, (last.v_end - v) / scale))
    (du, dv), (du_near, dv_near) = changes
    return bool(max(abs(du - du_near), abs(dv - dv_near)) <= UNLIKE * decay)
