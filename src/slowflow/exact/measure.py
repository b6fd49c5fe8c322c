"""Errors of averaged answers, by comparison with exact solutions of the equation of motion.

A state is compared with the motion that Newton's iteration finds from it, by the largest |u|, A or A + |B|; a fold with
the first one of the exact curve from a neighbouring motion that is not nearer to another averaged fold; a peak with
that of the exact curve through such a motion. An onset and a detachment are zeros of functions of the forcing, each
value of which takes an exact curve. Where there is nothing to compare with, the result has the reason.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from slowflow.answers.results import Detachment, SaddleNodeOnset, SaddleNodes, SteadyStates
from slowflow.answers.validity import Measured, MeasuredFolds, MeasuredPoint
from slowflow.core.mechanism import EquationOfMotion, Floats, Force
from slowflow.exact import response, shooting
from slowflow.exact.motion import limited
from slowflow.support.errors import NotSettled
from slowflow.support.text import text

#: motions nearer to each other than this, relative in amplitude, are one
MATCHES = 1e-8

#: fractions of the averaged amplitude from which Newton's iteration starts until it finds a motion
TRIALS = (1.0, 0.98, 1.02)

#: relative distances from a fold of the frequencies at which the search for neighbouring motions starts
OFFSETS = (0.003, 0.01, 0.03, 0.1)

#: the exact curve is followed to folds within this factor of the averaged frequency
FOLD_WINDOW = 1.25

#: and to a peak within this one first, which most lie in
PEAK_WINDOW = 1.02

#: on one side of a fold there are two states more than on the other, this far from it
SIDE_OFFSET = 1e-3

#: range of the search for a critical forcing relative to the averaged one, its steps, and its tolerance
FARTHEST, WIDENING = 1.7, (0.01, 0.03, 0.06, 0.12, 0.25, 0.7)
TOLERANCE = 1e-9
#: the same of a frequency of isolation, which friction takes far up where the peak counts
RISING = (0.01, 0.03, 0.1, 0.3, 0.7, 1.5, 3.0, 7.0)

AT_REST = text("at {Omega = :g} the mass does not move", 0.0)
NO_MOTION = "Newton's iteration finds no motion near it"
NO_LEVEL = f"no frequency above which the motion transmits less is found within a factor of {1 + RISING[-1]:g} of it"
TAKEN = "it leads to the motion of another state"
NO_FOLD = f"the exact curve near it has no fold within a factor of {FOLD_WINDOW:g} of its frequency"
NO_PEAK = f"the exact curve near it has no peak within a factor of {FOLD_WINDOW:g} of its frequency"
NO_FORCING = f"no such forcing of the exact curve is found within a factor of {FARTHEST:g} of it"
BORN = "an isolated curve is born there, which the exact curve through neighbouring motions does not show"
TAKEN_FOLD = "the neighbouring folds of the exact curve are closer to other ones"


#: averaged states at a frequency
AtFrequency = Callable[[float], SteadyStates]


def measured(oscillator: Any, answer: Any, force: str | None, of: str = "") -> Measured | MeasuredFolds | MeasuredPoint:
    """An answer of an oscillator against its equation of motion with that force; `of` its wave, where isolation is."""
    system = oscillator.equation_of_motion(force)

    def at_frequency(Omega: float) -> SteadyStates:
        question = oscillator.states if getattr(answer, "B", None) is None else oscillator.off_centre.amplitudes
        states_at: SteadyStates = question(Omega=Omega, F_0=answer.F_0)
        return states_at

    if of:
        return isolation(at_frequency, system, answer, of)
    if isinstance(answer, SteadyStates):
        return states(system, answer)
    if isinstance(answer, SaddleNodes):
        return folds(at_frequency, system, answer)
    if isinstance(answer, SaddleNodeOnset):
        return onset(system, answer)
    return detachment(system, answer) if isinstance(answer, Detachment) else peak(at_frequency, system, answer)


def states(system: EquationOfMotion, answer: SteadyStates) -> Measured:
    """The motion that each averaged state leads to. Raises ValueError for a force <= mu."""
    means = answer.mean
    largest = answer.A + np.abs(means)
    motions: list[shooting.SteadyState | None] = []
    reasons = [""] * answer.A.size
    forcing = np.broadcast_to(answer.F_0, answer.Omega.shape)
    columns = (column.tolist() for column in (answer.Omega, answer.A, answer.phi, forcing, means))
    for i, (Omega, A, phi, F_0, mean) in enumerate(zip(*columns, strict=True)):
        motion = None
        if A == 0.0 and Omega > 0.0:
            motion = shooting.static_state_from(system, Omega, F_0, mean, 0.0)
        for scale in TRIALS if Omega > 0.0 and A > 0.0 else ():
            motion = shooting.near(system, Omega, F_0, (scale * A, phi), B=mean)
            if motion is not None:
                break
        motions.append(motion)
        if motion is None:
            reasons[i] = NO_MOTION if Omega > 0.0 else AT_REST
    _drop_duplicates(answer, largest, forcing, motions, reasons, has_mean=answer.B is not None)
    return Measured(
        Omega=answer.Omega.copy(),
        A=np.array([np.nan if motion is None else motion.A for motion in motions]),
        error=np.array([np.nan if m is None else _error(A, m.A) for m, A in zip(motions, largest, strict=True)]),
        stable=np.array([motion is not None and motion.stable for motion in motions], dtype=bool),
        stops=np.array([0 if motion is None else motion.stops for motion in motions], dtype=np.intp),
        found=np.array([motion is not None for motion in motions], dtype=bool),
        reason=np.array(reasons, dtype=np.str_),
        message=_summary(reasons, "states"),
    )


def _error(A: float, exact: float) -> float:
    """Relative error of an amplitude; none where both are 0, of a mass at rest."""
    return 0.0 if A == exact else A / exact - 1.0


def _drop_duplicates(
    answer: Any,
    largest: Floats,
    forcing: Floats,
    motions: list[shooting.SteadyState | None],
    reasons: list[str],
    *,
    has_mean: bool,
) -> None:
    """Keep a motion for one of the states at its frequency that lead to it: as stable as it is, else the nearest.

    Motions of opposite means have the same |u|, but differ in u at the turning point.
    """

    def distance(i: int) -> tuple[bool, float]:
        motion = motions[i]
        assert motion is not None
        return bool(answer.stable[i]) != motion.stable, abs(float(largest[i]) - motion.A)

    for i, motion in enumerate(motions):
        for j in range(i - 1, -1, -1):
            other = motions[j]
            if answer.Omega[j] != answer.Omega[i] or forcing[j] != forcing[i]:
                break
            if motion is None or other is None or abs(motion.A - other.A) > MATCHES * motion.A:
                continue
            if has_mean and abs(float(motion.unknowns[0] - other.unknowns[0])) > MATCHES * motion.A:
                continue
            duplicate = max(i, j, key=distance)
            motions[duplicate], reasons[duplicate] = None, TAKEN
            motion = motions[i]


@limited()
def folds(at_frequency: AtFrequency, system: EquationOfMotion, answer: SaddleNodes) -> MeasuredFolds:
    """The fold of the exact curve that each averaged one leads to. Raises ValueError for F_0 <= mu."""
    largest = answer.A + np.abs(answer.mean)
    averaged = list(zip(answer.Omega.tolist(), largest.tolist(), strict=True))
    exact, reasons = _matched(averaged, [_folds_near(at_frequency, system, answer.F_0, *one) for one in averaged])
    pairs = [(np.nan, np.nan) if fold is None else (fold.Omega, fold.A) for fold in exact]
    at, height = np.array(pairs).reshape(-1, 2).T
    return MeasuredFolds(
        Omega=at,
        A=height,
        error=answer.Omega / at - 1.0,
        error_of_A=largest / height - 1.0,
        found=np.array([fold is not None for fold in exact], dtype=bool),
        reason=np.array(reasons, dtype=np.str_),
        message=_summary(reasons, "folds"),
    )


def _matched(
    averaged: list[tuple[float, float]], candidates: list[Iterator[response.ResponsePoint]]
) -> tuple[list[response.ResponsePoint | None], list[str]]:
    """An exact fold for each averaged one, as a stable matching: each takes the first of its candidates that no nearer
    averaged fold has; and why where there is none."""
    exact: list[response.ResponsePoint | None] = [None] * len(averaged)
    reasons = [NO_FOLD] * len(averaged)

    def distance(i: int, fold: response.ResponsePoint) -> float:
        Omega, A = averaged[i]
        return abs(math.log(Omega / fold.Omega)) + abs(math.log(A / fold.A))

    left = list(range(len(averaged)))
    while left:
        i = left.pop(0)
        for fold in candidates[i]:
            same = (j for j, other in enumerate(exact) if other is not None and _is_same_fold(fold, other))
            if (j := next(same, None)) is not None:
                if distance(i, fold) >= distance(j, fold):
                    reasons[i] = TAKEN_FOLD
                    continue
                exact[j], reasons[j] = None, TAKEN_FOLD
                left.append(j)
            exact[i], reasons[i] = fold, ""
            break
    return exact, reasons


def _is_same_fold(one: response.ResponsePoint, other: response.ResponsePoint) -> bool:
    return abs(other.Omega / one.Omega - 1.0) + abs(other.A / one.A - 1.0) < MATCHES


def _folds_near(
    at_frequency: AtFrequency, system: EquationOfMotion, F_0: float, Omega: float, A: float
) -> Iterator[response.ResponsePoint]:
    """The folds of the exact curve from motions near the averaged one, the nearest motions first."""
    more, fewer = (at_frequency(Omega * (1 + side * SIDE_OFFSET)).A.size for side in (1, -1))
    for offset in OFFSETS:
        for side in (1.0, -1.0) if more == fewer else (1.0,) if more > fewer else (-1.0,):
            Omega_near = Omega * (1.0 + side * offset)
            neighbours = at_frequency(Omega_near)
            by_distance = np.argsort(np.abs(neighbours.A + np.abs(neighbours.mean) - A) / A + ~neighbours.stable)
            for i in by_distance[:2]:
                guess = float(neighbours.A[i]), float(neighbours.phi[i])
                start = shooting.near(system, Omega_near, F_0, guess, B=float(neighbours.mean[i]))
                if start is None:
                    continue
                fold = response.first_fold(start, -side, (Omega / FOLD_WINDOW, Omega * FOLD_WINDOW))
                if fold is not None:
                    yield fold


def _summary(reasons: list[str], noun: str) -> str:
    """How many states or folds have no exact counterpart, and why."""
    messages = (f"{reasons.count(one)} of {len(reasons)} {noun}: {one}" for one in dict.fromkeys(reasons) if one)
    return "; ".join(messages)


@limited()
def peak(at_frequency: AtFrequency, system: EquationOfMotion, answer: Any) -> MeasuredPoint:
    """The peak of the exact curve near an averaged one. Raises ValueError for F_0 <= mu."""
    if not answer.Omega:
        return _no_point(answer.message if answer.Omega is None else AT_REST)
    for offset in OFFSETS:
        for side in (-1.0, 1.0):
            Omega = answer.Omega * (1.0 + side * offset)
            neighbours = at_frequency(Omega)
            if not neighbours.A.size:
                continue
            start = shooting.near(system, Omega, answer.F_0, (float(neighbours.A[-1]), float(neighbours.phi[-1])))
            top = None if start is None else _top(system, answer.F_0, answer.Omega, start)
            if top is not None:
                return _point(answer.F_0, top.Omega, top.A, answer.A / top.A, answer.Omega)
    return _no_point(NO_PEAK)


@limited()
def detachment(system: EquationOfMotion, answer: Any) -> MeasuredPoint:
    """The forcing at which the peak of the exact curve with the first piece alone is u_cr. Raises as `peak`."""
    if not answer.Omega_cr:
        return _no_point(answer.message if answer.Omega_cr is None else AT_REST)
    force, inner = system.force, system.force.innermost
    attached = replace(system, force=Force(force.pieces[: inner + 1], force.breakpoints[:inner]))
    u_cr = force.breakpoints[inner]

    def highest(F_0: float) -> shooting.SteadyState:
        # where the averaged motion is at resonance; from rest where that leads nowhere
        start = shooting.near(attached, answer.Omega_cr, F_0, (u_cr, -math.pi / 2))
        top = _top(attached, F_0, answer.Omega_cr, start)
        if top is None:
            raise NotSettled(NO_PEAK)
        return top

    F_cr = _zero_near(lambda F_0: highest(F_0).A / u_cr - 1.0, answer.F_cr)
    if F_cr is None:
        return _no_point(NO_FORCING)
    top = highest(F_cr)
    return _point(F_cr, top.Omega, top.A, answer.F_cr / F_cr, answer.Omega_cr)


@limited()
def isolation(at_frequency: AtFrequency, system: EquationOfMotion, answer: Any, of: str) -> MeasuredPoint:
    """The frequency above which exact motions near averaged ones transmit less, `of` their wave. Raises as `peak`."""
    if not answer.Omega or not answer.A:
        return _no_point(answer.message if answer.Omega is None else AT_REST)
    ratio = 10.0 ** (answer.level_dB / 20.0)

    def motion(Omega: float) -> tuple[float, shooting.SteadyState]:
        """The largest transmissibility of the motions that stable averaged states lead to, and its motion."""
        neighbours = at_frequency(Omega)
        guesses = zip(neighbours.A[neighbours.stable].tolist(), neighbours.phi[neighbours.stable].tolist(), strict=True)
        motions = [shooting.near(system, Omega, answer.F_0, guess) for guess in guesses if guess[0] > 0.0]
        ratios = [(getattr(one.transmitted(), of), one) for one in motions if one is not None]
        if not ratios:
            raise NotSettled(NO_MOTION)
        return max(ratios, key=lambda pair: float(pair[0]))

    def shortfall(Omega: float) -> float:
        return float(1.0 - motion(Omega)[0] / ratio)

    at = answer.Omega
    if answer.at_fold:
        fold = next(_folds_near(at_frequency, system, answer.F_0, at, answer.A), None)
        if fold is None:
            return _no_point(NO_FOLD)
        at = fold.Omega * (1.0 + SIDE_OFFSET)
        if shortfall(at) >= 0.0:
            return _point(answer.F_0, fold.Omega, fold.A, answer.Omega / fold.Omega, answer.Omega)
    Omega = _zero_near(shortfall, at, RISING)
    if Omega is None:
        return _no_point(NO_LEVEL)
    return _point(answer.F_0, Omega, motion(Omega)[1].A, answer.Omega / Omega, answer.Omega)


@limited()
def onset(system: EquationOfMotion, answer: Any) -> MeasuredPoint:
    """The forcing at which the exact curve near an averaged onset begins to fold. Raises as `peak`."""
    if answer.F_SN is None:
        return _no_point(answer.message)
    if answer.kind == "isola":
        return _no_point(BORN)
    window = (answer.Omega / FOLD_WINDOW**2, answer.Omega * FOLD_WINDOW)

    def steepest(F_0: float) -> tuple[float, Any]:
        """`_steepest` of the exact curve at a forcing."""
        curve = response.exact_response(system, F_0, Omega=window)
        if not curve.complete:
            raise NotSettled(curve.message)
        return _steepest(curve)

    F_SN = _zero_near(lambda F_0: steepest(F_0)[0], answer.F_SN)
    if F_SN is None:
        return _no_point(NO_FORCING)
    _, point = steepest(F_SN)
    return _point(F_SN, float(point.z[-1]), point.A, answer.F_SN / F_SN, answer.Omega)


def _steepest(curve: response.Response) -> tuple[float, Any]:
    """Minus the least component along Omega of the tangent, positive where the curve folds, and the point there.

    By a parabola through it and its neighbours; where it is at a corner, 1 if there are folds and -1 if there are none.
    """
    points = [point for point in curve.states if point.role != "fold"]
    components = np.array([point.tangent[-1] for point in points])
    i = int(components.argmin())
    if not 2 <= i < components.size - 2 or any(point.role for point in points[i - 2 : i + 3]):
        return 1.0 if curve.folds else -1.0, points[i]
    offsets = np.array([float(point.z[1]) for point in points[i - 2 : i + 3]]) - float(points[i].z[1])
    c, b, a = np.polynomial.polynomial.polyfit(offsets, components[i - 2 : i + 3], 2)
    return -float(c - b * b / (4 * a)) if a > 0 else -float(components[i]), points[i]


def _top(
    system: EquationOfMotion, F_0: float, Omega: float, start: shooting.SteadyState | None = None
) -> shooting.SteadyState | None:
    """The peak of a curve about a frequency; None where it ends before it turns, or cannot be followed."""
    for factor in (PEAK_WINDOW, FOLD_WINDOW):
        window = (Omega / factor, Omega * factor)
        if start is not None and not window[0] <= start.Omega <= window[1]:
            continue
        try:
            curve = response.exact_response(system, F_0, Omega=window, start=start)
        except ArithmeticError:
            continue
        top = curve.peak if curve.complete else None
        if top is not None and window[0] * (1 + MATCHES) < top.Omega < window[1] * (1 - MATCHES):
            return top
    return None


def _zero_near(function: Callable[[float], float], at: float, widening: tuple[float, ...] = WIDENING) -> float | None:
    """The zero nearest to a number of a function that rises with it, and may jump there; None if none is found."""

    def value(F_0: float) -> float | None:
        try:
            return function(F_0)
        except (ArithmeticError, ValueError):  # no curve there: friction holds the mass, say
            return None

    from scipy.optimize import brentq  # other questions do without SciPy

    a, f_a = at, value(at)
    if f_a is None:
        return None
    for step in widening:
        b = at / (1.0 + step) if f_a > 0.0 else at * (1.0 + step)
        f_b = value(b)
        if f_b is None:
            continue
        if f_a * f_b <= 0.0:
            try:
                return float(brentq(function, a, b, xtol=TOLERANCE * at, rtol=TOLERANCE))
            except ArithmeticError:
                return None
        a, f_a = b, f_b
    return None


def _point(F_0: float, Omega: float, A: float, ratio: float, averaged_Omega: float) -> MeasuredPoint:
    return MeasuredPoint(F_0, Omega, A, ratio - 1.0, averaged_Omega / Omega - 1.0, "")


def _no_point(message: str) -> MeasuredPoint:
    return MeasuredPoint(None, None, None, None, None, message)
