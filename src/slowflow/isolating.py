"""From which frequency on less than a level is transmitted: in go response curves, out come where that begins on each.

A state has R^2 + I^2 = F_0^2 and transmits the square root of h^2 + I^2: the frequency of a level is explicit in A
(`slow_flow.isolation`). Of one curve, of many, about the centre and off it the last crossing or end is what is asked.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple, TypeVar

import numpy as np

from slowflow import validate
from slowflow.answer import joined
from slowflow.mechanism import Flags, Floats, Ints
from slowflow.model import Model
from slowflow.text import Sentence
from slowflow.transmitted import in_motion
from slowflow_kernels import inertia, slow_flow
from slowflow_kernels.conventions import HIGHEST_OMEGA

Begins = TypeVar("Begins")

ISOLATES = Sentence("every motion transmits less than {what:s}")
NEVER = Sentence("a motion that transmits more than {what:s} has no end towards high frequencies")
FLOOR = Sentence(
    "however high the frequency, {what:s} passes on {floor:.4g} dB: from none on less than {level:g} dB is transmitted"
)
#: frequencies looked at, over the highest one at which anything can be transmitted in full
BEYOND = 1.1
#: of Brent's method, as SciPy's
MOST_STEPS = 100


class Level(NamedTuple):
    """A transmissibility, a number or an array: in decibels, as a ratio, and 1 less the square of that ratio."""

    dB: Any
    ratio: Any
    reduction: Any

    @classmethod
    def of(cls, dB: Any) -> Level:
        """From decibels; next to 0 dB what is lacking has all its digits, too."""
        return cls(dB, 10.0 ** (np.asarray(dB) / 20.0), 0.0 - np.expm1(np.asarray(dB) * (math.log(10.0) / 10.0)))

    def __str__(self) -> str:
        return f"{self.dB:g} dB" if self.dB else "the force"


#: all of what drives the mass
WHOLE = Level.of(0.0)


def as_level(level_dB: Any) -> Level:
    """Raises Refused for a level that is no number <= 0."""
    return Level.of(validate.number("level_dB", level_dB, most=0.0))


def told(made: Callable[..., Begins], curve: Any, level: Level, at_fold: bool, *at: float) -> Begins:
    """An answer from a row of columns: whether it is at a fold, and its numbers, the frequency first."""
    Omega, *_ = numbers = [None if math.isnan(one) else one for one in at]
    none = NEVER if Omega is None else ISOLATES if Omega == 0 else None
    message = joined(curve.message, none.format(str(level))) if none else curve.message
    return made(*numbers, at_fold, curve.F_0, message, curve.remarks)


def passes_on(model: Model, floor: float, level: Level) -> str:
    """Why less than that is transmitted at no frequency; "" where what transmissibility tends to is below."""
    if not level.dB or floor < level.ratio:
        return ""
    what = "quadratic damping" if model.inertial else "friction" if model.preload == 0 else "a preload"
    return FLOOR.format(what, 20 * math.log10(floor), level.dB)


class Curves(NamedTuple):
    """Response curves, a row each: what their points have along the last axis, with branch -1 behind the last one.

    at -- Omega, A and what else an answer has of a point
    """

    at: tuple[Floats, ...]
    stable: Flags
    branch: Ints
    isola: Flags

    @classmethod
    def of(cls, curve: Any, *at: Floats) -> Curves:
        """The only row of a single curve."""
        isola = np.array(curve.isola, dtype=bool)[curve.branch]
        flags = (one[np.newaxis] for one in (curve.stable, curve.branch, isola))
        return cls(tuple(one[np.newaxis] for one in (curve.Omega, curve.A, *at)), *flags)


def isolated(of: Callable[[Any], Any], curves: Curves, F_0: Floats, level: Level) -> tuple[Any, ...]:
    """`begins` of motions about the centre: whether at a fold, Omega and A.

    of -- the slow flows of the designs in some rows; F_0, level -- with an axis of one for the points

    A state has R^2 + I^2 = F_0^2 and transmits the square root of h^2 + I^2: the share kappa of F_0 where
    R^2 - h^2 = (1 - kappa^2) F_0^2, for kappa = 1 at sqrt(2) times the frequency of the backbone, as for a linear
    spring. That is explicit in A (`slow_flow.isolation`). Of an excitation by inertia F_0 Omega^2 takes the place of
    F_0 in this (`inertia.isolation`), and the frequency has an error of some u/kappa^2, as A is next to F_0 there.
    """
    (Omega, A), flow = curves.at, of(slice(None))
    transmits = np.asarray(level.dB < 0)
    if not transmits.all():  # each state transmits the whole force at Omega = 0, where rounding would decide
        transmits = transmits | (Omega <= _up_to(flow, A, F_0, level))
    if np.any(level.dB):
        transmits = transmits & ((level.dB == 0) | (in_motion(A, _passed(flow, Omega, A, F_0)) >= level.ratio))

    def passes(rows: Ints, one: Ints, other: Ints) -> tuple[Floats, ...]:
        some, forcing, levels = of(rows), F_0[rows], Level(*(column[rows] for column in level))
        root = _between(some, forcing, A[rows, one][:, np.newaxis], A[rows, other][:, np.newaxis], levels)
        at_root, sure = _up_to(some, root, forcing, levels), curves.stable[rows, one] & curves.stable[rows, other]
        with np.errstate(all="ignore"):
            keeps = sure | (some.F_A(at_root, root)[:, 0] > 0)
        return np.where(keeps, at_root[:, 0], -math.inf), root[:, 0]

    at_fold, Omega, A = begins(curves, transmits, passes)
    if flow.inertial:  # up to there a mass at rest passes on all that drives it
        moves_from = np.broadcast_to(inertia.moves_from(F_0, flow.held), (Omega.size, 1))[:, 0]
        rests = Omega < moves_from
        Omega, A, at_fold = np.where(rests, moves_from, Omega), np.where(rests, 0.0, A), at_fold & ~rests
    return at_fold, Omega, A


def begins(
    curves: Curves, transmits: Flags, passes: Callable[[Ints, Ints, Ints], tuple[Floats, ...]]
) -> tuple[Any, ...]:
    """Where isolation begins, of each response curve: whether at a fold, Omega, and what else its points have.

    transmits -- which of its points transmit that much
    passes    -- Omega and so on, in some rows, between two neighbours of which the first does so and the other does
                 not; Omega is -inf where no stable motion does: one of them may be a fold

    Omega is 0 where no stable motion transmits that much, NaN where one that does has no end; then the others are NaN.
    """
    (Omega, *_), stable, branch, isola = curves
    full, ends, k = stable & transmits, stable & transmits, np.arange(Omega.shape[1])
    neighbours, steady, beyond, pairs = np.zeros(Omega.shape, int), stable.copy(), np.zeros_like(stable), []
    for step in (-1, 1):
        there = np.clip(k + step, 0, k.size - 1)
        own = (there == k + step) & (branch[:, there] == branch) & (branch >= 0)
        higher = own & (Omega[:, there] > Omega)
        rows, one = np.nonzero((stable | stable[:, there]) & higher & transmits & ~transmits[:, there])
        pairs.append((rows, one, one + step))
        ends &= ~higher
        neighbours += own
        steady &= ~own | stable[:, there]
        beyond |= own & full[:, there] & (Omega[:, there] < Omega)
    ends |= transmits & ~stable & beyond  # a fold, which rounding may leave on either side of stability
    each = np.arange(len(Omega))
    last = np.where(ends, Omega, -math.inf).argmax(axis=1)
    at_end, endless = ends[each, last], (steady & (neighbours < 2) & ~isola)[each, last]
    rows, *between = map(np.concatenate, zip(*pairs, strict=True))
    found = passes(rows, *between)
    order = np.argsort(found[0])  # the last that is put in is the highest
    order = order[found[0][order] > -math.inf]
    best = [np.full(each.size, np.nan) for _ in found]
    for column, values in zip(best, found, strict=True):
        column[rows[order]] = values[order]
    at_end &= ~(best[0] >= Omega[each, last])
    nowhere = at_end & endless
    best = [
        np.where(nowhere, np.nan, np.where(at_end, column[each, last], one))
        for column, one in zip(curves.at, best, strict=True)
    ]
    best[0] = np.where(np.isnan(best[0]) & ~nowhere, 0.0, best[0])
    return at_end & ~nowhere, *best


def _up_to(of: Any, A: Floats, F_0: Any, level: Level) -> Floats:
    """The frequency up to which motions of these amplitudes transmit that; -inf where there is none."""
    kernel = inertia.isolation if of.inertial else slow_flow.isolation
    with np.errstate(all="ignore"):
        Omega = kernel(A, F_0, level.reduction, of.averaged(A)[0])
    return np.where(Omega > 0, Omega, -math.inf)


def _excess(of: Any, A: Floats, F_0: Any, level: Level) -> Floats:
    """The transmissibility at F_0 of motions with the frequency of that level, less that: the sign counts."""
    Omega = _up_to(of, A, F_0, level)
    with np.errstate(all="ignore"):
        # of the whole force the forcing of these motions less F_0 has that sign
        found = np.asarray(of.level(Omega, A) - F_0)
        if np.any(level.dB):
            found = np.where(level.dB, _passed(of, Omega, A, F_0) - level.ratio, found)
    return found


def _passed(of: Any, Omega: Floats, A: Floats, F_0: Any) -> Floats:
    """Transmissibility of motions."""
    (m, zeta), h = of.alike(Omega, A), of.averaged(A)[0]
    return np.asarray(slow_flow.transmissibility(Omega, A, of.force(F_0, Omega), m, zeta, h))


def _between(of: Any, F_0: Floats, A: Floats, other: Floats, level: Level) -> Floats:
    """The amplitudes between two at which motions at F_0 transmit that."""
    if of.inertial:  # smaller ones transmit it at any frequency
        least = F_0 * np.sqrt(level.reduction) * (1 + 4 * np.finfo(float).eps)
        A, other = np.maximum(A, least), np.maximum(other, least)
    return zeros(partial(_excess, of, F_0=F_0, level=level), A, other)


def zeros(function: Callable[[Floats], Floats], low: Floats, high: Floats) -> Floats:
    """Zeros to their last digits between pairs of numbers, for all pairs at once, by the steps of SciPy's brentq.

    Where signs at both ends are not opposite, as one end is the zero itself, that with the lesser value.
    """
    eps, tiny = 4 * np.finfo(float).eps, 4 * np.finfo(float).tiny
    old, now = np.array(low), np.array(high)
    f_old, f_now = function(old), function(now)
    with np.errstate(all="ignore"):  # of pairs that are through already
        done = ~(f_old * f_now < 0)
        found = np.where(np.abs(f_now) < np.abs(f_old), now, old)
        end, f_end, before, step = now, f_now, now - old, now - old
        for _ in range(MOST_STEPS):
            changes = (f_old != 0) & (f_now != 0) & (np.signbit(f_old) != np.signbit(f_now))
            end, f_end = np.where(changes, old, end), np.where(changes, f_old, f_end)
            before, step = (np.where(changes, now - old, one) for one in (before, step))
            swaps = np.abs(f_end) < np.abs(f_now)
            old, now, end = np.where(swaps, now, old), np.where(swaps, end, now), np.where(swaps, now, end)
            f_old, f_now, f_end = (
                np.where(swaps, f_now, f_old),
                np.where(swaps, f_end, f_now),
                np.where(swaps, f_now, f_end),
            )
            least, half = (tiny + eps * np.abs(now)) / 2, (end - now) / 2
            found = np.where(done, found, now)
            done = done | (f_now == 0) | (np.abs(half) < least)
            if done.all():
                break
            slope, slope_end = (f_old - f_now) / (old - now), (f_end - f_now) / (end - now)
            secant = -f_now * (now - old) / (f_now - f_old)
            inverse = -f_now * (f_end * slope_end - f_old * slope) / (slope_end * slope * (f_end - f_old))
            tried = np.where(old == end, secant, inverse)
            good = (np.abs(before) > least) & (np.abs(f_now) < np.abs(f_old))
            good &= 2 * np.abs(tried) < np.minimum(np.abs(before), 3 * np.abs(half) - least)
            before, step = np.where(good, step, half), np.where(good, tried, half)
            old, f_old = now, f_now
            now = now + np.where(np.abs(step) > least, step, np.where(half > 0, least, -least))
            f_now = function(now)
    return found


def highest(of: Any, A_max: Floats, F_0: Any, level: Level, samples: int) -> Floats:
    """A frequency beyond which no motion up to an amplitude transmits that; of one row, or each row."""
    A = A_max * np.arange(1, samples + 1) / samples
    last = BEYOND * np.maximum(1.0, _up_to(of, A, F_0, WHOLE).max(axis=1, keepdims=True))
    if np.any(level.dB):
        with np.errstate(all="ignore"):
            steepest = ((np.abs(of.averaged(A)[0]) - of.preload) / A).max(axis=1, keepdims=True)
            passed = last_passed(of, F_0, level, np.maximum(steepest, 1.0), of.preload)
        last = np.where(level.dB, passed, last)
    return np.asarray(np.minimum(last, float(HIGHEST_OMEGA)))


def last_passed(of: Any, F_0: Any, level: Level, steepest: Any, preload: Any = 0.0) -> Floats:
    """A frequency beyond which no motion transmits that; `HIGHEST_OMEGA` at most.

    of -- has the force at a frequency, and the sine balance; steepest -- of which |h| <= preload + steepest A

    As R does not exceed the force g, A Omega^2 <= g + |h|: that bounds A, then |h| and I, all of which fall over g.
    """
    Omega = BEYOND * np.sqrt(2 * np.asarray(steepest))
    while True:
        force = of.force(F_0, Omega)
        A = (force + preload) / (Omega**2 - steepest)
        passed = np.hypot(preload + steepest * A, of.sine(Omega, A)) >= level.ratio * force
        further = passed & (Omega < HIGHEST_OMEGA)
        if not np.any(further):
            return np.asarray(Omega)
        Omega = np.where(further, Omega * BEYOND, Omega)
