"""Exact solutions for an oscillator, whose averaged solution, which takes microseconds, supplies the guesses."""

from __future__ import annotations

import dataclasses
import math
import sys
from dataclasses import dataclass
from typing import Any

import numpy as np

from slowflow.answers.answer import joined
from slowflow.answers.results import Remark
from slowflow.averaged.diagnostics import MESSAGES
from slowflow.core import validate
from slowflow.core.mechanism import EquationOfMotion
from slowflow.core.model import Loaded
from slowflow.exact import response, shooting
from slowflow.exact.motion import NO_DAMPING, check_forcing, must_stick, stays_at_rest, sticking_message
from slowflow.exact.sweep import Sweep
from slowflow.exact.sweep import sweep as exact_sweep
from slowflow.exact.transient import AFTER, NO_PULSE, Arc, ShockSpectrum, Transient, half_sine, record, shock_spectrum
from slowflow.exact.transient import transient as exact_transient
from slowflow.support import boundary
from slowflow.support.errors import NotSettled, Refused
from slowflow.support.text import Sentence, text
from slowflow_kernels import inertia

#: distance, relative in amplitude and frequency, from which on the averaged points are those of another curve
SEPARATION = 0.1

#: largest relative distance of an averaged fold from the frequency for which it supplies a guess
FOLD_DISTANCE = 0.05

#: ratio of force and friction where a curve begins that would otherwise begin at rest
EXCEEDS = 1.05

STARTS_ABOVE = Sentence(
    "at this {F_0} friction holds the mass up to {Omega} = {Omega[0]:.4g}: the curve begins at {Omega} = {Omega[1]:.4g}"
)

OTHER = Sentence(
    "averaging predicts another curve, at {Omega = :.4g}, {A = :.4g}; "
    "start = steady_state({Omega=:.4g}, {F_0}=..., {A=:.4g}) leads to it, at the {F_0} of this curve"
)
#: a pulse, or a step of a record, whose frequency is beyond the range of doubles
SHORTEST = math.pi / sys.float_info.max
NOWHERE = text("no motion from rest: there is no stable equilibrium to start from; set the initial displacement {u_0}=")
SEVERAL = Sentence(
    "there are several stable equilibria, at {u = :.6g}: the mass starts from {u} = {u_0:.6g}, the nearest to the "
    "centre; {u_0}= sets another start"
)
#: displacement at which the sign of a force without stiffness at u = 0 is evaluated
PROBE = 2.0**-20
BOTH = Sentence("{name:s} selects a motion, {u_0} and v_0 set the start of one: give one or the other")
ONLY = Sentence("averaging has only this motion, and the mass was not found to reach it from rest: {why:s}")
UNKNOWN = Sentence("whether there are other curves is unknown, as averaging does not give them: {why:s}")
NO_START = "start = {!r} is not allowed: start must be a result of steady_state"
START = Sentence(
    "start at {Omega} = {Omega[0]:.6g}, {F_0} = {F_0[0]:.6g} is not allowed: start must be a steady state at "
    "{F_0} = {F_0[1]:.6g}, {Omega} from {Omega[1]:.6g} to {Omega[2]:.6g}"
)
ROWS = "{tau} and acceleration must be two rows of equal length, {tau} ascending: not of {shapes:s}"


#: (A, phi) and the mean B that Newton's iteration starts from
Guess = tuple[tuple[float, float], float]


@dataclass(frozen=True)
class Motions:
    """What is asked of an oscillator's motions: `slowflow.Oscillator` has each question by its name.

    averaged -- the oscillator, or its `OffCentre`: averaged answers, which are guesses
    system   -- its equation of motion
    """

    averaged: Any
    system: EquationOfMotion

    def _begin(self) -> None:
        """Begin to compute a forced motion. Raises ValueError where nothing damps it or holds the mass."""
        if not (self.system.is_damped or self.system.force.jump):
            raise Refused(NO_DAMPING)
        boundary.begin()

    def steady_state(
        self, Omega: float, F_0: float, A: float | None, u_0: float | None, v_0: float
    ) -> shooting.SteadyState:
        """The motion next to A, or that from rest or from (u_0, v_0)."""
        Omega = validate.number("Omega", Omega, above=0.0)
        F_0 = validate.number("F_0", F_0, above=0.0)
        target = None if A is None else validate.number("A", A, above=0.0)
        if target is None:
            return self._from_rest(Omega, F_0, u_0, v_0)
        if u_0 is not None or v_0 != 0:
            raise Refused(BOTH.format("A"))
        if must_stick(self.system, Omega, F_0):
            return self._from_rest(Omega, F_0)
        check_forcing(self.system, Omega, F_0)
        guesses = (self._guesses if self.system.centred else self._guesses_with_mean)(Omega, F_0, target)
        near = (shooting.near(self.system, Omega, F_0, guess, B=B) for guess, B in guesses)
        found = [motion for motion in near if motion is not None] + self._static(Omega, F_0)
        if found:
            return min(found, key=lambda motion: abs(motion.A - target))
        if not guesses:  # friction holds every averaged state
            return self._from_rest(Omega, F_0)
        (A, phi), B = guesses[0]
        return shooting.steady_state(self.system, (A + max(B, 0.0), phi), Omega=Omega, F_0=F_0)

    def _static(self, Omega: float, F_0: float) -> list[shooting.SteadyState]:
        """The motion from rest against static friction, which averaging does not have; empty if there is none."""
        if not self.system.mu_s > self.system.mu:
            return []
        try:
            at, _ = equilibrium(self.averaged, self.system)
            return [] if stays_at_rest(self.system, Omega, F_0, at) else [self._from_rest(Omega, F_0)]
        except ArithmeticError:
            return []

    def exact_response(
        self,
        F_0: float,
        Omega: tuple[float, float],
        start: shooting.SteadyState | None,
        step: float,
        u_0: float | None,
        v_0: float,
    ) -> response.Response:
        """The curve in a window of frequencies, through `start` or the motion at its lower end."""
        system = self.system
        F_0 = validate.number("F_0", F_0, above=0.0)
        low, high = validate.window("Omega", Omega)
        low = validate.number("Omega[0]", low, above=0.0)
        step = validate.number("step", step, above=0.0, most=0.5)
        self._begin()
        begins = ""
        if system.inertial and system.forcing(Omega=low, F_0=F_0) < EXCEEDS * system.holds(0):
            Omega_min = float(inertia.moves_from(F_0, system.holds(0)))
            low = min(high, math.sqrt(EXCEEDS) * Omega_min)
            begins = STARTS_ABOVE.format((Omega_min, low))
        if start is None:
            start = self._from_rest(low, F_0, u_0, v_0)
        elif u_0 is not None or v_0 != 0:
            raise Refused(BOTH.format("start"))
        elif not isinstance(start, shooting.SteadyState):
            raise Refused(NO_START.format(start))
        elif not (low <= start.Omega <= high and start.F_0 == F_0):
            raise Refused(START.format((start.Omega, low, high), (start.F_0, F_0)))
        if start.cycle.sticks:
            message = sticking_message(system, start.Omega, F_0, float(start.unknowns[0]))
            return response.through(F_0, [], False, joined(start.message, message))
        found = response.exact_response(system, F_0, Omega=(low, high), start=start, step=step)
        # an incomplete curve cannot be compared with averaged ones
        others = self._other_curves(found, (low, high)) if found.complete else ""
        return dataclasses.replace(found, message=joined(begins, start.message, found.message, others))

    def _other_curves(self, found: response.Response, window: tuple[float, float]) -> str:
        """Names a stable point of each averaged curve in the window that the exact one does not come near."""
        loaded = isinstance(self.averaged.model, Loaded)
        ask = self.averaged.frequency_response if loaded else self.averaged.curve
        try:
            curve = ask(found.F_0, samples=100, Omega=window)
        except (ArithmeticError, ValueError) as error:
            return UNKNOWN.format(error.args[0])
        A = curve.A + np.abs(curve.mean)
        points = np.log(np.column_stack((curve.Omega, A)))
        line = np.log(np.column_stack((found.Omega, found.A)))
        distances = np.array([np.abs(line - point).max(axis=1).min() for point in points])
        branches = [np.flatnonzero(curve.branch == branch) for branch in np.unique(curve.branch)]
        branches.sort(key=lambda members: float(np.median(distances[members])))
        notes = []
        for members in branches[1:]:  # the nearest is this curve, however far friction keeps averaging from it
            stable = members[curve.stable[members]]
            if stable.size and np.median(distances[members]) > SEPARATION:
                middle = stable[stable.size // 2]
                notes.append(OTHER.format(Omega=curve.Omega[middle], A=A[middle]))
        return joined(*notes)

    def sweep(self, Omega: Any, F_0: float, u_0: float | None, v_0: float) -> Sweep:
        """The motion through frequencies, from rest or from (u_0, v_0)."""
        F_0 = validate.number("F_0", F_0, above=0.0)
        frequencies = validate.positive_array("Omega", Omega)
        self._begin()
        u, v, message = self._initial_state(u_0, v_0)
        found = exact_sweep(self.system, Omega=frequencies, F_0=F_0, u_0=u, v_0=v)
        return dataclasses.replace(found, message=message)

    def transient(
        self, acceleration: Any, duration: Any, tau: Any, after: Any, u_0: float | None, v_0: float
    ) -> Transient:
        """The motion in a pulse or a record of the base, or freely, from rest or from (u_0, v_0)."""
        free = acceleration is None and duration is None and tau is None and (u_0 is not None or v_0 != 0)
        if not free and (duration is None) == (tau is None):
            raise Refused(NO_PULSE)
        begin = 0.0
        if free:
            arcs = np.empty((0, len(Arc._fields)))
        elif duration is not None:
            peak = validate.number("acceleration", acceleration)
            span = validate.number("duration", duration, above=0.0)
            arcs = half_sine(peak, validate.number("duration", span, above=SHORTEST))
        else:
            times, samples = validate.finite_array("tau", tau), validate.finite_array("acceleration", acceleration)
            if (
                times.ndim != 1
                or times.shape != samples.shape
                or times.size < 2
                or not (np.diff(times) > SHORTEST).all()
            ):
                raise Refused(text(ROWS, f"{times.shape} and {samples.shape}"))
            arcs, begin = record(times, samples), float(times[0])
        last = AFTER if after is None else validate.number("after", after, least=0.0)
        boundary.begin()
        at, v, message = self._initial_state(u_0, v_0)
        rest = at if u_0 is None else equilibrium(self.averaged, self.system)[0]
        found = exact_transient(self.system, arcs, begin=begin, after=last, at=at, v=v, rest=rest)
        return dataclasses.replace(found, message=joined(message, self._beyond_reach(found.A)))

    def shock_spectrum(self, acceleration: Any, duration: Any) -> ShockSpectrum:
        """What half sines of the base do, from rest."""
        pulses = {
            "acceleration": validate.positive_array("acceleration", acceleration),
            "duration": validate.positive_array("duration", duration),
        }
        shape = validate.common_shape(pulses)
        validate.number("duration", float(pulses["duration"].min(initial=1.0)), above=SHORTEST)
        boundary.begin()
        at, message = equilibrium(self.averaged, self.system)
        peaks, spans = (np.broadcast_to(values, shape).ravel() for values in pulses.values())
        found = shock_spectrum(self.system, peaks, spans, at)
        beyond = self._beyond_reach(float(found.A.max(initial=0.0)))
        return dataclasses.replace(found, message=joined(message, beyond))

    def _initial_state(self, u_0: Any, v_0: Any) -> tuple[float, float, str]:
        """Initial displacement and velocity, by default at equilibrium, and a message."""
        v = validate.number("v_0", v_0)
        if u_0 is not None:
            return validate.number("u_0", u_0), v, ""
        at, message = equilibrium(self.averaged, self.system)
        return at, v, message

    def _beyond_reach(self, A: float) -> str:
        """The diagnostic of a deflection beyond the mechanism's reach; empty within it."""
        model = self.averaged.model
        if A <= model.reach:
            return ""
        return MESSAGES[Remark.BEYOND_REACH].format(reach=model.reach, reason=model.mechanism.reach_reason)

    def _from_rest(self, Omega: float, F_0: float, u_0: float | None = None, v_0: float = 0.0) -> shooting.SteadyState:
        """The steady state reached from equilibrium, or from (u_0, v_0), by time stepping.

        If that does not become periodic but averaging has a single state, its motion, with a message.
        """
        system = self.system
        u, v, message = self._initial_state(u_0, v_0)
        if (found := shooting.static_state_from(system, Omega, F_0, u, v)) is not None:
            return dataclasses.replace(found, message=message)
        try:
            found = shooting.steady_state(system, Omega=Omega, F_0=F_0, u_0=u, v_0=v)
            return dataclasses.replace(found, message=message)
        except shooting.NotPeriodic as error:
            states = list(self.averaged.states(Omega=Omega, F_0=F_0)) if system.centred else self._states(Omega, F_0)
            if len(states) == 1:
                B = 0.0 if system.centred else states[0].B
                found = shooting.near(system, Omega, F_0, (states[0].A, states[0].phi), B=B)
                if found is not None and found.stable:
                    return dataclasses.replace(found, message=joined(message, ONLY.format(error.args[0])))
            raise

    def _states(self, Omega: float, F_0: float) -> list[Any]:
        """States with a mean in which the mass moves."""
        return [state for state in self.averaged.amplitudes(Omega=Omega, F_0=F_0) if state.A > 0]

    def _guesses(self, Omega: float, F_0: float, A: float) -> list[Guess]:
        """(A, phi) from which Newton's iteration may come to a motion of amplitude A, the averaged state nearest first.

        Averaged folds are slightly off: the motion may exist where averaging has no such state, so the folds near Omega
        are tried, and the amplitude itself with its averaged phase.
        """
        model = self.averaged.model
        states, folds = self.averaged.states(Omega=Omega, F_0=F_0), self.averaged.folds(F_0)
        near = np.abs(folds.Omega / Omega - 1.0) < FOLD_DISTANCE
        amplitudes = np.concatenate((folds.A[near], [A]))
        frequencies = np.concatenate((folds.Omega[near], [Omega]))
        h = model.averaged(amplitudes)[0]
        phases = model.phase(frequencies, amplitudes, h)
        known = sorted(zip(states.A, states.phi, strict=True), key=lambda state: abs(state[0] - A))
        return [((float(a), float(phi)), 0.0) for a, phi in (*known[:1], *zip(amplitudes, phases, strict=True))]

    def _guesses_with_mean(self, Omega: float, F_0: float, A: float) -> list[Guess]:
        """The same of motions whose largest |u| is A, about the mean B of each averaged state, the nearest first.

        The amplitude itself about each mean, at resonance, is a guess too: averaging does not have all motions.
        """
        states = sorted(self._states(Omega, F_0), key=lambda state: abs(state.A + abs(state.B) - A))
        at_resonance = [((A - abs(one.B), -math.pi / 2), one.B) for one in states if abs(one.B) < A]
        return [*(((one.A, one.phi), one.B) for one in states), *at_resonance]


def stable_at_centre(system: EquationOfMotion) -> bool:
    """Whether u = 0 is an equilibrium that the force does not push the mass away from, on either side."""
    force = system.force
    if force.jump != 0:
        return force.jump > 0
    if force.value(0.0) != system.load:
        return False
    for side in (1.0, -1.0):
        stiffness = force.piece(force.region_of(side * PROBE)).slope(0.0)
        if not (stiffness > 0 or (stiffness == 0 and side * (force.value(side * PROBE) - system.load) >= 0)):
            return False
    return True


def equilibrium(averaged: Any, system: EquationOfMotion) -> tuple[float, str]:
    """The stable equilibrium f(u) = load nearest to the centre, and a message where there are several.

    Of two that are equally near it is the one with u > 0. Friction widens each to an interval, which is disregarded.
    Raises ArithmeticError where there is none.
    """
    stable = stable_at_centre(system)
    if stable and system.centred:
        return 0.0, ""
    found, force = averaged.rest(), system.force
    equilibria = found.u[found.stable]
    if not equilibria.size and stable:
        return 0.0, ""
    if not equilibria.size:
        raise NotSettled(NOWHERE)
    candidates = equilibria[equilibria > 0] if system.centred else equilibria
    from scipy.optimize import root_scalar  # a motion about the centre does without SciPy

    # of the exact force, which may differ from the averaged one
    solution = root_scalar(
        lambda u: force.value(u) - system.load,
        fprime=lambda u: force.piece(force.region_of(u)).slope(u),
        x0=float(candidates[np.argmin(np.abs(candidates))]),
        method="newton",
    )
    if not solution.converged:
        raise NotSettled(NOWHERE)
    # the same double from whatever guess: motions from here may be chaotic
    near = (solution.root + np.arange(-4, 5) * np.spacing(solution.root)).tolist()
    u = min(near, key=lambda u: abs(force.value(u) - system.load))
    if equilibria.size == 1:
        return u, ""
    return u, SEVERAL.format(equilibria, u)
