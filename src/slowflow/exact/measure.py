"""Averaged answers held against the equation of motion, here and now: in go states or folds, out come their errors.

In:  an averaged oscillator and the equation of motion, steady states or folds at one forcing; off the centre their mean
     displacements B, and |B| + A is what the largest |u| of a motion is held against.
Out: `Measured` or `MeasuredFolds`: the motion or fold that each leads to, and how far from it averaging is; where it
     leads to none, words.

A state leads to the motion that Newton's iteration finds from it, a fold to the first one of the exact curve that is
met from a motion beside it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from slowflow.exact import response, shooting
from slowflow.exact.integrate import limited
from slowflow.mechanism import EquationOfMotion, Floats
from slowflow.results import Measured, MeasuredFolds

#: motions nearer to each other than this, relative in amplitude, are one
MATCHES = 1e-8

#: shares of the averaged amplitude from which Newton's iteration starts until it finds a motion
TRIALS = (1.0, 0.98, 1.02)

#: relative distances of a fold from the frequencies at which motions beside it are looked for
BESIDE = (0.003, 0.01, 0.03, 0.1)

#: the exact curve is followed to folds within this factor of the averaged frequency
AROUND = 1.25

#: on one side of a fold there are two states more than on the other, this far from it
ASIDE = 1e-3

AT_REST = "at Omega = 0 nothing moves"
NO_MOTION = "Newton's iteration finds no motion near it"
TAKEN = "it leads to the motion of another state"
NO_FOLD = f"the exact curve beside it has no fold within a factor of {AROUND:g} of its frequency"
TAKEN_FOLD = "it leads to the fold of another one"


#: averaged states at a frequency, with their means
AtFrequency = Callable[[float], tuple[Any, Floats]]


def states(system: EquationOfMotion, found: Any, B: Floats | None = None) -> Measured:
    """The motion that each averaged state leads to. Raises ValueError for a force <= mu."""
    means = np.zeros(found.A.size) if B is None else B
    largest = found.A + np.abs(means)
    motions: list[shooting.SteadyState | None] = []
    reasons = [""] * found.A.size
    forcing = np.broadcast_to(found.F_0, found.Omega.shape)
    columns = (column.tolist() for column in (found.Omega, found.A, found.phi, forcing, means))
    for i, (Omega, A, phi, F_0, mean) in enumerate(zip(*columns, strict=True)):
        motion = None
        for share in TRIALS if Omega > 0.0 else ():
            motion = shooting.near(system, Omega, F_0, (share * A, phi), B=mean)
            if motion is not None:
                break
        motions.append(motion)
        if motion is None:
            reasons[i] = NO_MOTION if Omega > 0.0 else AT_REST
    _one_each(found, largest, forcing, motions, reasons, has_mean=B is not None)
    return Measured(
        Omega=found.Omega.copy(),
        A=np.array([np.nan if motion is None else motion.A for motion in motions]),
        error=np.array([np.nan if m is None else A / m.A - 1.0 for m, A in zip(motions, largest, strict=True)]),
        stable=np.array([motion is not None and motion.stable for motion in motions], dtype=bool),
        stops=np.array([0 if motion is None else motion.stops for motion in motions], dtype=np.intp),
        found=np.array([motion is not None for motion in motions], dtype=bool),
        reason=np.array(reasons, dtype=np.str_),
        message=_told(reasons, "states"),
    )


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
def folds(at_frequency: AtFrequency, system: EquationOfMotion, found: Any, B: Floats | None = None) -> MeasuredFolds:
    """The fold of the exact curve that each averaged one leads to. Raises ValueError for F_0 <= mu."""
    exact: list[response.Fold | None] = []
    reasons = []
    largest = found.A if B is None else found.A + np.abs(B)
    for Omega, A in zip(found.Omega.tolist(), largest.tolist(), strict=True):
        fold = _fold(at_frequency, system, found.F_0, Omega, A)
        taken = fold is not None and any(
            abs(other.Omega / fold.Omega - 1.0) + abs(other.A / fold.A - 1.0) < MATCHES for other in exact if other
        )
        reasons.append(TAKEN_FOLD if taken else "" if fold is not None else NO_FOLD)
        exact.append(None if taken else fold)
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


def _fold(
    at_frequency: AtFrequency, system: EquationOfMotion, F_0: float, Omega: float, A: float
) -> response.Fold | None:
    """The nearest of the folds that the exact curve meets from motions beside the averaged one."""
    more, fewer = (at_frequency(Omega * (1 + side * ASIDE))[0].A.size for side in (1, -1))
    for offset in BESIDE:
        for side in (1.0, -1.0) if more == fewer else (1.0,) if more > fewer else (-1.0,):
            at = Omega * (1.0 + side * offset)
            beside, means = at_frequency(at)
            by_distance = np.argsort(np.abs(beside.A + np.abs(means) - A) / A + ~beside.stable)
            for i in by_distance[:2]:
                guess = float(beside.A[i]), float(beside.phi[i])
                start = shooting.near(system, at, F_0, guess, B=float(means[i]))
                if start is None:
                    continue
                fold = response.first_fold(start, -side, (Omega / AROUND, Omega * AROUND))
                if fold is not None:
                    return fold
    return None


def _told(reasons: list[str], what: str) -> str:
    """How many lead nowhere, and why."""
    told = []
    for reason in dict.fromkeys(reasons):
        if reason:
            told.append(f"{reasons.count(reason)} of {len(reasons)} {what}: {reason}")
    return "; ".join(told)
