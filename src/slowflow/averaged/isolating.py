"""From which frequency on less than a level is transmitted. Takes a response curve, or the folds of many designs.

A state has R^2 + I^2 = F_0^2 and transmits the square root of h^2 + I^2: the frequency of a level is explicit in A
(`slow_flow.isolation`). Of one curve, of many, about the centre and off it the last crossing or end is what is asked.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from operator import itemgetter
from typing import Any, NamedTuple

import numpy as np

from slowflow.answers.transmissibility import in_motion
from slowflow.core import validate
from slowflow.core.mechanism import Flags, Floats, Ints
from slowflow.core.model import Model, SlowFlow
from slowflow.support.text import Sentence
from slowflow_kernels import inertia, slow_flow
from slowflow_kernels.conventions import ENDLESS, HIGHEST_OMEGA

ISOLATES = Sentence("every motion transmits less than {what:s}")
NEVER = Sentence("a motion that transmits more than {what:s} extends to arbitrarily high frequencies")
FLOOR = Sentence("at any frequency, however high, {what:s} transmits {floor:.4g} dB: it never stays below {level:g} dB")
#: frequencies looked at, over the highest one at which anything can be transmitted in full
BEYOND = 1.1
#: amplitudes looked at of each of many designs, and the lowest of them over that of the peak; of frequencies likewise
AMPLITUDES, LEAST = 64, 1e-6


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


def passes_on(model: Model, floor: float, level: Level) -> str:
    """Why less than that is transmitted at no frequency; "" where what transmissibility tends to is below."""
    if not level.dB or floor < level.ratio:
        return ""
    what = "quadratic damping" if model.inertial else "friction" if model.preload == 0 else "a preload"
    return FLOOR.format(what, 20 * math.log10(floor), level.dB)


def isolated(model: Model, curve: Any, F_0: float, level: Level) -> tuple[Any, ...]:
    """`begins` of motions about the centre: whether at a fold, Omega and A.

    A state has R^2 + I^2 = F_0^2 and transmits the square root of h^2 + I^2: the share kappa of F_0 where
    R^2 - h^2 = (1 - kappa^2) F_0^2, for kappa = 1 at sqrt(2) times the frequency of the backbone, as for a linear
    spring. That is explicit in A (`slow_flow.isolation`). Of an excitation by inertia F_0 Omega^2 takes the place of
    F_0 in this (`inertia.isolation`), and the frequency has an error of some u/kappa^2, as A is next to F_0 there.
    """
    Omega, A, stable = curve.Omega, curve.A, curve.stable

    def crossing(one: Ints, other: Ints) -> tuple[Floats, ...]:
        return _crossing(model, F_0, A[one], A[other], level, stable[one] & stable[other])

    found = begins(curve, (Omega, A), transmits(model, Omega, A, F_0, level), crossing)
    return _from_rest_on(rests_up_to(model, F_0), *found)


def isolated_each(
    flow: SlowFlow, folds: tuple[Floats, Floats], A_max: Floats, F_0: Floats, level: Level
) -> tuple[Any, ...]:
    """`isolated` of designs in rows, from all their folds; and where a zero may lie below the amplitudes looked at.

    flow, A_max, F_0, level -- have an axis of one for the amplitudes
    folds -- Omega and A of those that end a stable motion, NaN for none

    At the frequency of a level an amplitude takes one forcing: the motions at F_0 are its zeros in A less F_0, on
    isolas, too, without a response curve. The last that is stable, or the last fold that transmits more.
    """
    Omega, A = folds
    lowest = _lowest(flow, F_0, level)
    grid = lowest + (A_max - lowest) * np.geomspace(LEAST, 1.0, AMPLITUDES)
    above = _excess(flow, grid, F_0, level) > 0
    rows, k = np.nonzero(above[:, 1:] != above[:, :-1])
    levels = Level(*(column[rows] for column in level))
    low, high = grid[rows, k, np.newaxis], grid[rows, k + 1, np.newaxis]
    at, of_A = _crossing(flow.each(itemgetter(rows)), F_0[rows], low, high, levels)
    last, last_A = _last(len(F_0), rows, at[:, 0], of_A[:, 0])
    ends = np.where(transmits(flow, Omega, A, F_0, level), Omega, -math.inf)
    at_end = ends.argmax(axis=1)[:, np.newaxis]
    end, end_A = (np.take_along_axis(one, at_end, axis=1)[:, 0] for one in (ends, A))
    at_fold = end > last
    last, last_A = np.where(at_fold, end, last), np.where(at_fold, end_A, last_A)
    found = at_fold, np.maximum(last, 0.0), np.where(last > 0, last_A, np.nan)
    below = above[:, 0] | _is_free(flow, flow.averaged(grid[:, :1])[0], level)[:, 0]
    return below, *_from_rest_on(rests_up_to(flow, F_0)[:, 0], *found)


def _last(n: int, rows: Ints, Omega: Floats, *others: Floats) -> tuple[Floats, ...]:
    """Of n rows the highest Omega, -inf where there is none, and what else belongs to it."""
    order = np.argsort(Omega)  # the last that is put in is the highest
    found = [np.full(n, -math.inf) for _ in (Omega, *others)]
    for column, values in zip(found, (Omega, *others), strict=True):
        column[rows[order]] = values[order]
    return tuple(found)


def transmits(of: Any, Omega: Floats, A: Floats, F_0: Any, level: Level, h: Any = None) -> Any:
    """Whether motions transmit that much; none does where one of them is NaN. h -- as `up_to` takes it"""
    whole, h = np.asarray(level.dB == 0), of.averaged(A)[0] if h is None else h
    with np.errstate(invalid="ignore"):
        passes = Omega >= 0
        if whole.any():  # each state transmits the whole force at Omega = 0, where rounding would decide
            passes = passes & (~whole | (Omega <= up_to(of, A, F_0, level, h)))
        if not whole.all():
            passes = passes & (whole | (in_motion(A, of.transmissibility(Omega, A, F_0, h)) >= level.ratio))
    return passes


def _crossing(of: Any, F_0: Any, A: Floats, other: Floats, level: Level, sure: Any = False) -> tuple[Floats, Floats]:
    """Omega and A of motions at F_0 that transmit that, between two amplitudes; -inf where none is stable."""
    root = _between(of, F_0, A, other, level)
    at_root = up_to(of, root, F_0, level)
    with np.errstate(all="ignore"):
        return np.where(sure | (of.F_A(at_root, root) > 0), at_root, -math.inf), root


def _from_rest_on(end: Any, at_fold: Any, Omega: Any, A: Any) -> tuple[Any, ...]:
    """The same, where the mass rests up to a frequency, `end`: there it passes on all that drives it."""
    sticks = Omega < end
    return at_fold & ~sticks, np.where(sticks, end, Omega), np.where(sticks, 0.0, A)


def rests_up_to(of: Any, F_0: Any) -> Any:
    """The frequency up to which friction holds a mass that is excited by inertia, 0 of others."""
    with np.errstate(over="ignore"):  # beyond any double it is at all
        return inertia.moves_from(F_0, of.break_loose) if of.inertial else 0.0 * F_0


def begins(
    curve: Any, at: tuple[Floats, ...], transmits: Flags, crossing: Callable[[Ints, Ints], tuple[Floats, ...]]
) -> tuple[Any, ...]:
    """Where isolation begins on a response curve: whether at a fold, Omega, and what else its points have.

    at        -- Omega, A and what else an answer has of a point
    transmits -- which of its points transmit that much
    crossing  -- Omega and so on, between two neighbours of which the first does so and the other does not; Omega is
                 -inf where no stable motion does: one of them may be a fold

    Omega is 0 where no stable motion transmits that much, NaN where one that does has no end; then the others are NaN.
    """
    Omega, stable, branch = curve.Omega, curve.stable, curve.branch
    isola = np.asarray(curve.isola, dtype=bool)[branch]
    full, k = stable & transmits, np.arange(Omega.size)
    ends = full.copy()
    neighbours, steady, beyond, pairs = np.zeros(Omega.size, int), stable.copy(), np.zeros_like(stable), []
    for step in (-1, 1):
        there = np.clip(k + step, 0, k.size - 1)
        own = (there == k + step) & (branch[there] == branch)
        higher = own & (Omega[there] > Omega)
        one = np.flatnonzero((stable | stable[there]) & higher & transmits & ~transmits[there])
        pairs.append((one, one + step))
        ends &= ~higher
        neighbours += own
        steady &= ~own | stable[there]
        beyond |= own & full[there] & (Omega[there] < Omega)
    ends |= transmits & ~stable & beyond  # a fold, which rounding may leave on either side of stability
    crossings = crossing(*map(np.concatenate, zip(*pairs, strict=True)))
    last = crossings[0].argmax() if crossings[0].size else None
    end = np.where(ends, Omega, -math.inf).argmax()
    if last is not None and crossings[0][last] >= (Omega[end] if ends[end] else 0.0):
        return False, *(column[last] for column in crossings)
    if not ends[end]:
        return False, 0.0, *(math.nan for _ in at[1:])
    if steady[end] and neighbours[end] < 2 and not isola[end]:
        return False, *(math.nan for _ in at)
    return True, *(column[end] for column in at)


def up_to(of: Any, A: Floats, F_0: Any, level: Level, h: Any = None) -> Floats:
    """The frequency up to which motions of these amplitudes transmit that; -inf where there is none.

    h -- by default that of motions about the centre
    """
    kernel = inertia.isolation if of.inertial else slow_flow.isolation
    with np.errstate(all="ignore"):
        h = of.averaged(A)[0] if h is None else h
        Omega = kernel(A, F_0, level.reduction, h)
        if of.inertial:
            Omega = np.where(_is_free(of, h, level), _free_up_to(of, A, F_0, level), Omega)
    return np.where(Omega > 0, Omega, -math.inf)


def _is_free(of: Any, h: Any, level: Level) -> Flags:
    """Where an excitation by inertia drives motions without a spring force, which transmit some of it by damping."""
    return np.asarray((h == 0) & (level.dB != 0) & of.inertial)


def _free_up_to(of: Any, A: Floats, F_0: Any, level: Level) -> Floats:
    """`up_to` of these: I = kappa F_0 Omega^2, a quadratic in Omega. At F_0 they have A = sqrt(1 - kappa^2) F_0."""
    m, damping, rises = of.at_rest(A)[0], of.viscous(A)[0] * A, level.ratio * F_0 - of.d * A**2
    return np.asarray((damping + np.hypot(damping, np.sqrt(m * rises))) / rises)


def _excess(of: Any, A: Floats, F_0: Any, level: Level) -> Floats:
    """The transmissibility at F_0 of motions with the frequency of that level, less that: the sign counts."""
    h = of.averaged(A)[0]
    Omega = up_to(of, A, F_0, level, h)
    with np.errstate(all="ignore"):
        # of the whole force the forcing of these motions less F_0 has that sign
        found = np.asarray(of.level(Omega, A) - F_0)
        if np.any(level.dB):
            found = np.where(level.dB, of.transmissibility(Omega, A, F_0, h) - level.ratio, found)
    # any amplitude has such a frequency without a spring force, one of them at F_0
    return np.where(_is_free(of, h, level), _lowest(of, F_0, level) - A, found)


def _lowest(of: Any, F_0: Any, level: Level) -> Any:
    """An amplitude below which motions that an excitation by inertia drives transmit that at any frequency, or 0."""
    return F_0 * np.sqrt(level.reduction) * (1 + 4 * np.finfo(float).eps) if of.inertial else 0.0


def _between(of: Any, F_0: Floats, A: Floats, other: Floats, level: Level) -> Floats:
    """The amplitudes between two at which motions at F_0 transmit that."""
    least = _lowest(of, F_0, level)
    A, other = np.maximum(A, least), np.maximum(other, least)
    return zeros(partial(_excess, of, F_0=F_0, level=level), A, other)


def zeros(function: Callable[[Floats], Floats], low: Floats, high: Floats) -> Floats:
    """Zeros to their last digits between pairs of numbers, for all pairs at once.

    Where signs at both ends are not opposite, as one end is the zero itself, that with the lesser value.
    """
    from scipy.optimize.elementwise import find_root  # which takes longer to import than most questions

    at = np.array(low)

    def some(x: Floats, which: Ints) -> Floats:
        at.flat[which] = x
        return np.asarray(function(at).flat[which])

    lesser = np.where(np.abs(function(high)) < np.abs(function(low)), high, low)
    found = find_root(some, (low, high), args=(np.arange(at.size).reshape(at.shape),), tolerances={"fatol": 0.0})
    return np.where(np.isfinite(found.x), found.x, lesser)


def highest(of: Any, A_max: float, F_0: float, level: Level, samples: int) -> float:
    """A frequency beyond which no motion up to an amplitude transmits that."""
    A = A_max * np.arange(1, samples + 1) / samples
    A = A[A > 0]  # fractions of the least double are 0
    if not level.dB:
        return min(BEYOND * max(1.0, float(up_to(of, A, F_0, level).max())), float(HIGHEST_OMEGA))
    with np.errstate(all="ignore"):
        steepest = ((np.abs(of.averaged(A)[0]) - of.preload) / A).max()
    return min(float(last_passed(of, F_0, level, max(steepest, 1.0), of.preload)), float(HIGHEST_OMEGA))


def lowest_passed(of: SlowFlow, A: float, F_0: float, level: Level) -> float:
    """A frequency below which no motion beyond an amplitude has that transmissibility, where no spring bounds motions.

    Where one has it A Omega^2 is at least -2 h and sqrt(1 - kappa^2) F_0 (`slow_flow.isolation`), h of a force that
    levels off; and as I does not exceed F_0, damping bounds A Omega.
    """
    with np.errstate(all="ignore"):  # without a law it bounds nothing
        speed = (np.divide(F_0, [2 * of.zeta, of.d, of.d_3]) ** [1, 1 / 2, 1 / 3]).min()
        pull = -2 * max(of.averaged(A)[0], of.averaged(ENDLESS)[0])
    return float(max(pull, math.sqrt(level.reduction) * F_0, 0.0) / speed)


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
