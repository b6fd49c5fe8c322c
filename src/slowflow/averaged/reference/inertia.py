"""Excitation by inertia, F_0 Omega^2: in go a model and an amplitude of the excitation, out come frequencies, a bound.

The level of an amplitude, the F_0 for which it is a steady state at Omega, falls from inf at Omega = 0 to its least and
rises from there to A as Omega tends to inf; or it only falls to A. So an amplitude below F_0 has one frequency, and one
above it two or none (derivations/inertia.py). As in native/inertia.h.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from slowflow.averaged.reference.arcs import Along, Event, Ints, Kind
from slowflow.averaged.reference.cells import samples_at
from slowflow.averaged.reference.enclosed import enclosed
from slowflow.model import Floats, Model
from slowflow_kernels import inertia
from slowflow_kernels.conventions import ENDLESS, STATIC_MULTIPLE

Bools = NDArray[np.bool_]

#: of Newton's steps, which bisection keeps in their bracket
STEPS = 200


def falls_to_least(model: Model, A: Floats, h: Floats) -> tuple[Bools, Floats]:
    """Whether the level of each amplitude has a least one, and its frequency."""
    fall, linear, rest = inertia.terms(A, model.m, model.zeta, h)
    falls = np.asarray(fall > 0)
    return falls, 1 / np.where(falls, inertia.least(fall, linear, rest), np.nan)


@dataclass(frozen=True)
class Roots:
    """The frequencies of the response along the amplitude."""

    model: Model
    F_0: float

    def take(self, of: Ints) -> Roots:
        """These: of one design."""
        return self

    def count(self, A: Floats) -> Ints:
        """How many there are at each amplitude; -1 where squares of h are beyond the range of doubles."""
        h = self.model.averaged(A)[0]
        outer = inertia.outer(A, self.F_0, self.model.m, self.model.zeta, h)[0]
        beyond = (A < self.F_0) & (h != 0) & ~(outer < np.inf)
        falls, Omega = falls_to_least(self.model, A, h)
        above = inertia.peak(1 / Omega, A, self.F_0, self.model.m, self.model.zeta, h, 0.0)[0] < 0
        pair = np.where(falls & above, np.where(A > self.F_0, 2, 1), 0)
        return np.where(beyond, -1, np.where(A < self.F_0, 1, pair)).astype(np.intp)

    def at(self, A: Floats, count: Ints, index: Ints) -> Floats:
        """Number `index` of `count` at each amplitude; where rounding hides a pair, the place where it meets."""
        h = np.asarray(self.model.averaged(A)[0] + 0.0 * A)
        _, least = falls_to_least(self.model, A, h)
        shown = self.count(A)
        high = (count == 2) & (index == 1)
        found = np.full(A.shape, np.nan)
        for wanted, solve in ((~high & (shown > 0), self._low), (high & (shown == 2), self._high)):
            found[wanted] = solve(A[wanted], h[wanted], least[wanted])
        found[high & (A <= self.F_0)] = np.inf
        return np.where(np.isnan(found), least, found)

    def lower_pair(self, event: Event) -> tuple[bool, float]:
        """That the pair is not the lower one of three, and where it meets."""
        if event.kind is Kind.PAIR_HIGH:
            return False, event.Omega
        A = np.array([event.A])
        return False, float(falls_to_least(self.model, A, self.model.averaged(A)[0])[1][0])

    def start(self) -> float:
        """Where the response begins, at A = 0: below it the mass sticks."""
        return float(inertia.moves_from(self.F_0, self.model.held))

    def _low(self, A: Floats, h: Floats, least: Floats) -> Floats:
        """Below the frequency of the least level."""
        most = np.sqrt(inertia.outer(A, self.F_0, self.model.m, self.model.zeta, h)[0]) * (1 + 2.0**-40)
        return self._solved(A, h, most, np.where(np.isnan(least), 0.0, 1 / least), most, 1.0)

    def _high(self, A: Floats, h: Floats, least: Floats) -> Floats:
        """Above it."""
        least_X = inertia.outer(A, self.F_0, self.model.m, self.model.zeta, h)[1]
        first = np.sqrt(np.maximum(least_X, 0.0)) * (1 - 2.0**-40)
        return self._solved(A, h, first, first, 1 / least, -1.0)

    def _solved(self, A: Floats, h: Floats, x: Floats, lo: Floats, hi: Floats, rising: float) -> Floats:
        """Newton's steps in x = 1/Omega, kept in the bracket; F rises with x for +1 and falls for -1."""
        model, F_0 = self.model, self.F_0
        x, lo, hi = np.clip(x, lo, hi), lo.copy(), hi.copy()
        active = np.arange(A.size)
        for _ in range(STEPS):
            at, below, above = x[active], lo[active], hi[active]
            Omega, of_A, of_h = 1 / at, A[active], h[active]
            F = inertia.F(Omega, of_A, F_0, model.m, model.zeta, of_h)
            following = at + F / (Omega * inertia.level_slope(Omega, of_A, model.m, model.zeta, of_h))
            left = rising * F < 0
            below, above = np.where(left, at, below), np.where(left, above, at)
            inside = (following >= below) & (following <= above)
            following = np.where(inside, following, 0.5 * (below + above))
            lo[active], hi[active], x[active] = below, above, following
            active = active[np.abs(following - at) > 2.0**-52 * at]
            if not active.size:
                break
        return 1 / x


def bound(model: Model, F_0: float, rungs: Floats) -> float | None:
    """The first of the amplitudes above which no state lies, all of them above F_0; None where none is known.

    What excludes states at an amplitude is positive on all that follow if its slopes are: the third is a sum of h_AAA,
    which is monotone, and of a number. Where that is not known it is h itself that is, on intervals of amplitudes.
    """
    if model.mechanism.enclosed is not None:
        return _bound_by_h(model, F_0, rungs)
    at, far = samples_at(model, rungs), samples_at(model, ENDLESS * np.maximum(rungs, 1.0))
    steepest = np.minimum(at.h_AAA, far.h_AAA)
    # zeta^2 A is at most so much of |h|: of all states half of it, and less where |h|/A is known to rise
    rises = (at.k >= 0) & (at.h_AA <= 0) & (np.maximum(at.h_AAA, far.h_AAA) <= 0)
    share = np.where(rises & (at.h < 0), np.minimum(inertia.share(at.A, model.zeta, at.h), 0.5), 0.5)
    closed = np.zeros(rungs.shape, dtype=bool)
    for lost in (0.5, share):
        values = inertia.bound(at.A, F_0, model.zeta, at.h, at.h_A, at.h_AA, steepest, lost)
        closed |= np.all([value > 0 for value in values], axis=0)
    return float(rungs[np.argmax(closed)]) if closed.any() else None


def _bound_by_h(model: Model, F_0: float, rungs: Floats) -> float | None:
    """The same up to the reach, or an endless amplitude; of all states above F_0 zeta^2 A is half of |h| at most."""
    nodes = intervals_beyond(model, rungs)
    low = nodes[:-1]
    h, _ = enclosed(model, low, nodes[1:])
    excluded = (inertia.bound(low, F_0, model.zeta, h.lo, 0.0, 0.0, 0.0, 0.5)[0] > 0) & (low > F_0)
    beyond = low[np.logical_and.accumulate(excluded[::-1])[::-1]]
    found = rungs[np.isin(rungs, beyond)]
    return float(found[0]) if found.size else None


def intervals_beyond(model: Model, rungs: Floats) -> Floats:
    """Ends of intervals from the first of some rising amplitudes on, up to the reach or an endless one."""
    end = min(model.reach, ENDLESS * max(rungs[0], 1.0))
    # so fine that a cube of A, as h may grow, changes by less than the half that is left of zeta^2 A
    steps = rungs[0] * 2.0 ** (0.125 * np.arange(np.ceil(8 * np.log2(end / rungs[0])) + 1))
    nodes = np.concatenate((rungs[rungs < end], steps[steps < end], [end]))
    return np.unique(np.concatenate((nodes, [b for b in model.breakpoints if rungs[0] < b < end])))


def cut(along: Along, rungs: Floats) -> float:
    """Where a response is cut that does not close: at the reach, or far from the spring's slope at rest.

    Amplitudes that are much less are reached there.
    """
    model = along.model
    if np.isfinite(model.reach):
        return model.reach
    if model.mechanism.enclosed is None:
        far = _is_far(along, rungs)
        return float(rungs[np.argmax(far)]) if far.any() else float(rungs[-1])
    # one by one: at amplitudes beyond sums may not settle
    return next((float(A) for A in rungs[:-1] if _is_far(along, np.array([A])).all()), float(rungs[-1]))


def _is_far(along: Along, rungs: Floats) -> Bools:
    """Of amplitudes, whether the spring is far from its slope at rest, and one that is much less is reached."""
    model, F_0 = along.model, along.F_0
    at = samples_at(model, rungs)
    # the slope at rest and what zeta^2 A is of |h|, as shares of |h|/A
    h = np.where(at.h < 0, at.h, np.nan)
    shares = -abs(samples_at(model, 0.0).h_A[0]) * at.A / h + inertia.share(at.A, model.zeta, h)
    less = rungs / STATIC_MULTIPLE
    return np.asarray((STATIC_MULTIPLE * shares <= 1) & (less > F_0) & (along.count(less) == 2))
