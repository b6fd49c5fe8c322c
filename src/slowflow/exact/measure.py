"""Averaged answers held against the equation of motion, here and now. Takes answers; returns their errors.

In:  an averaged oscillator and the equation of motion, steady states or folds at one forcing; off the centre their mean
     displacements B, and |B| + A is what the largest |u| of a motion is held against. Or a peak, onset or detachment.
Out: `Measured`, `MeasuredFolds` or `MeasuredPoint`: what each leads to, and how far from it averaging is; where it
     leads to nothing, words.

A state leads to the motion that Newton's iteration finds from it, a fold to the first one of the exact curve that is
met from a motion beside it and is not nearer to another averaged fold, a peak to that of the exact curve through such a
motion. An onset and a detachment are zeros of functions of the forcing, each value of which takes an exact curve.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from slowflow.exact import response, shooting
from slowflow.exact.work import limited
from slowflow.mechanism import EquationOfMotion, Floats, Force
from slowflow.results import (
    Detachment,
    Measured,
    MeasuredFolds,
    MeasuredPoint,
    SaddleNodeOnset,
    SaddleNodes,
    SteadyStates,
)
from slowflow.text import text
from slowflow_support.errors import NotSettled

#: motions nearer to each other than this, relative in amplitude, are one
MATCHES = 1e-8

#: shares of the averaged amplitude from which Newton's iteration starts until it finds a motion
TRIALS = (1.0, 0.98, 1.02)

#: relative distances of a fold from the frequencies at which motions beside it are looked for
BESIDE = (0.003, 0.01, 0.03, 0.1)

#: the exact curve is followed to folds within this factor of the averaged frequency
AROUND = 1.25

#: and to a peak within this one first, which most lie in
NEXT_TO = 1.02

#: on one side of a fold there are two states more than on the other, this far from it
ASIDE = 1e-3

#: how far from the averaged one a critical forcing is looked for, and steps towards it; how nearly it is found
FARTHEST, WIDENING = 1.7, (0.01, 0.03, 0.06, 0.12, 0.25, 0.7)
NEARLY = 1e-9
#: the same of a frequency of isolation, which friction takes far up where the peak counts
UPWARDS = (0.01, 0.03, 0.1, 0.3, 0.7, 1.5, 3.0, 7.0)

AT_REST = text("at {Omega = :g} nothing moves", 0.0)
NO_MOTION = "Newton's iteration finds no motion near it"
NO_LEVEL = f"no frequency within a factor of {1 + UPWARDS[-1]:g} of it is found from which on the motion transmits less"
TAKEN = "it leads to the motion of another state"
NO_FOLD = f"the exact curve beside it has no fold within a factor of {AROUND:g} of its frequency"
NO_PEAK = f"the exact curve beside it has no peak within a factor of {AROUND:g} of its frequency"
NO_FORCING = f"no forcing within a factor of {FARTHEST:g} of it is found at which the exact curve does so"
BORN = "an isolated curve is born there, which the exact curve through the motions beside it does not show"
TAKEN_FOLD = "the folds that the exact curve has beside it are nearer to other ones"


#: averaged states at a frequency
AtFrequency = Callable[[float], SteadyStates]


def measured(oscillator: Any, found: Any, force: str | None, of: str = "") -> Measured | MeasuredFolds | MeasuredPoint:
    """An answer of an oscillator against its equation of motion with that force; `of` its wave, where isolation is."""
    system = oscillator.equation_of_motion(force)

    def at_frequency(Omega: float) -> SteadyStates:
        ask = oscillator.states if getattr(found, "B", None) is None else oscillator.off_centre.amplitudes
        at: SteadyStates = ask(Omega=Omega, F_0=found.F_0)
        return at

    if of:
        return isolation(at_frequency, system, found, of)
    if isinstance(found, SteadyStates):
        return states(system, found)
    if isinstance(found, SaddleNodes):
        return folds(at_frequency, system, found)
    if isinstance(found, SaddleNodeOnset):
        return onset(system, found)
    return detachment(system, found) if isinstance(found, Detachment) else peak(at_frequency, system, found)


def states(system: EquationOfMotion, found: SteadyStates) -> Measured:
    """The motion that each averaged state leads to. Raises ValueError for a force <= mu."""
    means = found.mean
    largest = found.A + np.abs(means)
    motions: list[shooting.SteadyState | None] = []
    reasons = [""] * found.A.size
    forcing = np.broadcast_to(found.F_0, found.Omega.shape)
    columns = (column.tolist() for column in (found.Omega, found.A, found.phi, forcing, means))
    for i, (Omega, A, phi, F_0, mean) in enumerate(zip(*columns, strict=True)):
        motion = None
        if A == 0.0 and Omega > 0.0:
            motion = shooting.comes_to_rest(system, Omega, F_0, mean, 0.0)
        for share in TRIALS if Omega > 0.0 and A > 0.0 else ():
            motion = shooting.near(system, Omega, F_0, (share * A, phi), B=mean)
            if motion is not None:
                break
        motions.append(motion)
        if motion is None:
            reasons[i] = NO_MOTION if Omega > 0.0 else AT_REST
    _one_each(found, largest, forcing, motions, reasons, has_mean=found.B is not None)
    return Measured(
        Omega=found.Omega.copy(),
        A=np.array([np.nan if motion is None else motion.A for motion in motions]),
        error=np.array([np.nan if m is None else _error(A, m.A) for m, A in zip(motions, largest, strict=True)]),
        stable=np.array([motion is not None and motion.stable for motion in motions], dtype=bool),
        stops=np.array([0 if motion is None else motion.stops for motion in motions], dtype=np.intp),
        found=np.array([motion is not None for motion in motions], dtype=bool),
        reason=np.array(reasons, dtype=np.str_),
        message=_told(reasons, "states"),
    )


def _error(A: float, exact: float) -> float:
    """Relative error of an amplitude; none where both are 0, of a mass at rest."""
    return 0.0 if A == exact else A / exact - 1.0


def _one_each(
    found: Any,
    largest: Floats,
    forcing: Floats,
    motions: list[shooting.SteadyState | None],
    reasons: list[str],
    *,
    has_mean: bool,
) -> None:
    """Leaves a motion to one of the states at its frequency that lead to it: as stable as it is, else the nearest.

    Of two whose means are opposite |u| is alike, and u where it turns is not.
    """

    def distance(i: int) -> tuple[bool, float]:
        motion = motions[i]
        assert motion is not None
        return bool(found.stable[i]) != motion.stable, abs(float(largest[i]) - motion.A)

    for i, motion in enumerate(motions):
        for j in range(i - 1, -1, -1):
            other = motions[j]
            if found.Omega[j] != found.Omega[i] or forcing[j] != forcing[i]:
                break
            if motion is None or other is None or abs(motion.A - other.A) > MATCHES * motion.A:
                continue
            if has_mean and abs(float(motion.unknowns[0] - other.unknowns[0])) > MATCHES * motion.A:
                continue
            loser = max(i, j, key=distance)
            motions[loser], reasons[loser] = None, TAKEN
            motion = motions[i]


@limited()
def folds(at_frequency: AtFrequency, system: EquationOfMotion, found: SaddleNodes) -> MeasuredFolds:
    """The fold of the exact curve that each averaged one leads to. Raises ValueError for F_0 <= mu."""
    largest = found.A + np.abs(found.mean)
    averaged = list(zip(found.Omega.tolist(), largest.tolist(), strict=True))
    exact, reasons = _matched(averaged, [_folds_near(at_frequency, system, found.F_0, *one) for one in averaged])
    pairs = [(np.nan, np.nan) if fold is None else (fold.Omega, fold.A) for fold in exact]
    at, height = np.array(pairs).reshape(-1, 2).T
    return MeasuredFolds(
        Omega=at,
        A=height,
        error=found.Omega / at - 1.0,
        error_of_A=largest / height - 1.0,
        found=np.array([fold is not None for fold in exact], dtype=bool),
        reason=np.array(reasons, dtype=np.str_),
        message=_told(reasons, "folds"),
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
    """The folds that the exact curve meets from motions beside the averaged one, the nearest motions first."""
    more, fewer = (at_frequency(Omega * (1 + side * ASIDE)).A.size for side in (1, -1))
    for offset in BESIDE:
        for side in (1.0, -1.0) if more == fewer else (1.0,) if more > fewer else (-1.0,):
            at = Omega * (1.0 + side * offset)
            beside = at_frequency(at)
            by_distance = np.argsort(np.abs(beside.A + np.abs(beside.mean) - A) / A + ~beside.stable)
            for i in by_distance[:2]:
                guess = float(beside.A[i]), float(beside.phi[i])
                start = shooting.near(system, at, F_0, guess, B=float(beside.mean[i]))
                if start is None:
                    continue
                fold = response.first_fold(start, -side, (Omega / AROUND, Omega * AROUND))
                if fold is not None:
                    yield fold


def _told(reasons: list[str], what: str) -> str:
    """How many lead nowhere, and why."""
    told = []
    for reason in dict.fromkeys(reasons):
        if reason:
            told.append(f"{reasons.count(reason)} of {len(reasons)} {what}: {reason}")
    return "; ".join(told)


@limited()
def peak(at_frequency: AtFrequency, system: EquationOfMotion, found: Any) -> MeasuredPoint:
    """The peak of the exact curve that passes beside an averaged one. Raises ValueError for F_0 <= mu."""
    if not found.Omega:
        return _nothing(found.message if found.Omega is None else AT_REST)
    for offset in BESIDE:
        for side in (-1.0, 1.0):
            at = found.Omega * (1.0 + side * offset)
            beside = at_frequency(at)
            if not beside.A.size:
                continue
            start = shooting.near(system, at, found.F_0, (float(beside.A[-1]), float(beside.phi[-1])))
            top = None if start is None else _top(system, found.F_0, found.Omega, start)
            if top is not None:
                return _point(found.F_0, top.Omega, top.A, found.A / top.A, found.Omega)
    return _nothing(NO_PEAK)


@limited()
def detachment(system: EquationOfMotion, found: Any) -> MeasuredPoint:
    """The forcing at which the peak of the exact curve with the first piece alone is u_cr. Raises as `peak`."""
    if not found.Omega_cr:
        return _nothing(found.message if found.Omega_cr is None else AT_REST)
    force, inner = system.force, system.force.innermost
    attached = replace(system, force=Force(force.pieces[: inner + 1], force.breakpoints[:inner]))
    u_cr = force.breakpoints[inner]

    def highest(F_0: float) -> shooting.SteadyState:
        # where the averaged motion is at resonance; from rest where that leads nowhere
        start = shooting.near(attached, found.Omega_cr, F_0, (u_cr, -math.pi / 2))
        top = _top(attached, F_0, found.Omega_cr, start)
        if top is None:
            raise NotSettled(NO_PEAK)
        return top

    F_cr = _zero_near(lambda F_0: highest(F_0).A / u_cr - 1.0, found.F_cr)
    if F_cr is None:
        return _nothing(NO_FORCING)
    top = highest(F_cr)
    return _point(F_cr, top.Omega, top.A, found.F_cr / F_cr, found.Omega_cr)


@limited()
def isolation(at_frequency: AtFrequency, system: EquationOfMotion, found: Any, of: str) -> MeasuredPoint:
    """From where on the exact motions beside averaged ones transmit less, `of` their wave. Raises as `peak`."""
    if not found.Omega or not found.A:
        return _nothing(found.message if found.Omega is None else AT_REST)
    ratio = 10.0 ** (found.level_dB / 20.0)

    def motion(Omega: float) -> tuple[float, shooting.SteadyState]:
        """What the motions that are stable on the average lead to: the largest share that is transmitted."""
        beside = at_frequency(Omega)
        guesses = zip(beside.A[beside.stable].tolist(), beside.phi[beside.stable].tolist(), strict=True)
        motions = [shooting.near(system, Omega, found.F_0, guess) for guess in guesses if guess[0] > 0.0]
        passed = [(getattr(one.transmitted(), of), one) for one in motions if one is not None]
        if not passed:
            raise NotSettled(NO_MOTION)
        return max(passed, key=lambda pair: float(pair[0]))

    def lacks(Omega: float) -> float:
        return float(1.0 - motion(Omega)[0] / ratio)

    at = found.Omega
    if found.at_fold:
        fold = next(_folds_near(at_frequency, system, found.F_0, at, found.A), None)
        if fold is None:
            return _nothing(NO_FOLD)
        at = fold.Omega * (1.0 + ASIDE)
        if lacks(at) >= 0.0:
            return _point(found.F_0, fold.Omega, fold.A, found.Omega / fold.Omega, found.Omega)
    Omega = _zero_near(lacks, at, UPWARDS)
    if Omega is None:
        return _nothing(NO_LEVEL)
    return _point(found.F_0, Omega, motion(Omega)[1].A, found.Omega / Omega, found.Omega)


@limited()
def onset(system: EquationOfMotion, found: Any) -> MeasuredPoint:
    """The forcing at which the exact curve beside an averaged onset begins to fold. Raises as `peak`."""
    if found.F_SN is None:
        return _nothing(found.message)
    if found.kind == "isola":
        return _nothing(BORN)
    window = (found.Omega / AROUND**2, found.Omega * AROUND)

    def steepest(F_0: float) -> tuple[float, Any]:
        """How steep the curve is at most, over what is vertical; a jump at a corner. And where."""
        curve = response.exact_response(system, F_0, Omega=window)
        if not curve.complete:
            raise NotSettled(curve.message)
        return _steepest(curve)

    F_SN = _zero_near(lambda F_0: steepest(F_0)[0], found.F_SN)
    if F_SN is None:
        return _nothing(NO_FORCING)
    _, point = steepest(F_SN)
    return _point(F_SN, float(point.z[-1]), point.A, found.F_SN / F_SN, found.Omega)


def _steepest(curve: response.Response) -> tuple[float, Any]:
    """Minus the least component along Omega of the tangent, positive where the curve folds, and the point there.

    By a parabola through it and its neighbours; where it is at a corner, 1 if there are folds and -1 if there are none.
    """
    points = [point for point in curve.states if point.role != "fold"]
    along = np.array([point.tangent[-1] for point in points])
    i = int(along.argmin())
    if not 2 <= i < along.size - 2 or any(point.role for point in points[i - 2 : i + 3]):
        return 1.0 if curve.folds else -1.0, points[i]
    way = np.array([float(point.z[1]) for point in points[i - 2 : i + 3]]) - float(points[i].z[1])
    c, b, a = np.polynomial.polynomial.polyfit(way, along[i - 2 : i + 3], 2)
    return -float(c - b * b / (4 * a)) if a > 0 else -float(along[i]), points[i]


def _top(
    system: EquationOfMotion, F_0: float, Omega: float, start: shooting.SteadyState | None = None
) -> shooting.SteadyState | None:
    """The peak of a curve about a frequency; None where it ends before it turns, or cannot be followed."""
    for factor in (NEXT_TO, AROUND):
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

    last, before = at, value(at)
    if before is None:
        return None
    for share in widening:
        there = at / (1.0 + share) if before > 0.0 else at * (1.0 + share)
        found = value(there)
        if found is None:
            continue
        if before * found <= 0.0:
            try:
                return float(brentq(function, last, there, xtol=NEARLY * at, rtol=NEARLY))
            except ArithmeticError:
                return None
        last, before = there, found
    return None


def _point(F_0: float, Omega: float, A: float, share: float, averaged_Omega: float) -> MeasuredPoint:
    return MeasuredPoint(F_0, Omega, A, share - 1.0, averaged_Omega / Omega - 1.0, "")


def _nothing(message: str) -> MeasuredPoint:
    return MeasuredPoint(None, None, None, None, None, message)
