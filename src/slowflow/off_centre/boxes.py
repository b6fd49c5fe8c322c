"""All solutions of a few equations in boxes: none is missed, and each that is given is proved to be there, once.

In:  equations that give values and slopes on boxes, as intervals, and at points; boxes.
Out: `Solutions`: points, and the boxes in which doubles do not decide.

A box is left only when some equation has no zero in it, when Krawczyk's operator maps a slightly larger one into itself
(it holds just one solution then) or out of it (none). Otherwise it is cut. What is left is smaller than `NARROW` of its
place: it is given as undecided.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import Any

import numpy as np

from slowflow.mechanism import Flags, Ints
from slowflow.model import Floats
from slowflow.support.errors import NotSettled

#: by how much of its half width a box is enlarged for the proof, so that a solution on an edge is inside of one
AROUND = 0.125
#: a box is not cut further below this share of its place, and of 1
NARROW = 2.0**-42
#: half the width below which a box is not made narrower
THIN = 2.0**-43
#: boxes that are looked at for one system: usual questions take hundreds, hard ones some ten thousand; this many take
#: some seconds. And for each of many, on the average
MOST_BOXES, MOST_EACH = 150_000, 4_000
TOO_MANY = "the states are unresolved: too many boxes stay undecided"


class Equations:
    """As many equations as unknowns; `of` tells which of several systems each box or point belongs to."""

    def limits(self, of: Ints) -> tuple[Any, Any]:
        """Lower and upper ends of all that there is, which broadcast to (d, n): no box is made larger beyond."""
        raise NotImplementedError

    def on(self, low: Floats, x: Floats, high: Floats, of: Ints) -> tuple[Floats, ...]:
        """Values at points x of boxes, and on the boxes, (2, d, n), and slopes on these, (2, d, d, n), by their ends.

        A fourth array (2, d, n) may follow: between which ends the solutions of each box are.
        """
        raise NotImplementedError

    def at(self, x: Floats, of: Ints) -> tuple[Floats, Floats]:
        """Values (d, n) and slopes (d, d, n) at points (d, n): the middles of what is known of these."""
        _, values, slopes, *_ = self.on(x, x, x, of)
        return 0.5 * (values[0] + values[1]), 0.5 * (slopes[0] + slopes[1])


@dataclass(frozen=True, eq=False)
class Solutions:
    """Points (d, n), by their first unknown, and which system each solves.

    undecided, undecided_of -- centres (d, k) of boxes that may hold others, and their systems
    """

    x: Floats
    of: Ints
    undecided: Floats
    undecided_of: Ints


def solve(equations: Equations, low: Floats, high: Floats, of: Ints) -> Solutions:
    """All solutions in the boxes from low to high, shape (d, n). Raises ArithmeticError where too many stay open."""
    with np.errstate(all="ignore"):
        return _solve(equations, low, high, of)


def _solve(equations: Equations, low: Floats, high: Floats, of: Ints) -> Solutions:
    d, looked_at, doubt = low.shape[0], 0, np.zeros_like(low)
    most = max(MOST_BOXES, MOST_EACH * np.unique(of).size)
    no_x, no_of = np.zeros((d, 0)), np.zeros(0, dtype=np.intp)
    found, open_ = [(no_x, no_x, no_x, no_of)], [(no_x, no_of)]
    while of.size:
        looked_at += of.size
        if looked_at > most:
            raise NotSettled(TOO_MANY)
        x, r = 0.5 * (low + high), 0.5 * (high - low)
        least, most_ = equations.limits(of)
        around = AROUND * r + doubt
        ends = np.maximum(low - around, least), np.minimum(high + around, most_)
        x_wide = 0.5 * (ends[0] + ends[1])
        wide = np.maximum(ends[1] - x_wide, x_wide - ends[0])
        middle, values, slopes, *bounds = equations.on(ends[0], x_wide, ends[1], of)
        none = ((values[0] > 0) | (values[1] < 0)).any(axis=0)
        # by how much slopes can move the value in the middle
        reach = np.einsum("ijn,jn->in", np.max(np.abs(slopes), axis=0), wide) * (1 + 2.0**-48)
        none |= ((middle[0] - reach > 0) | (middle[1] + reach < 0)).any(axis=0)
        centre, radius, floor = _krawczyk(middle, x_wide, wide, slopes)
        none |= ((centre - radius > high) | (centre + radius < low)).any(axis=0)
        inside = (np.abs(centre - x_wide) + radius < wide).all(axis=0) & ~none
        bounds.append(_each_equation(middle, x_wide, wide, slopes))
        for holds in bounds:
            low, high = np.fmax(low, holds[0]), np.fmin(high, holds[1])
            none |= (low > high).any(axis=0)
            inside &= ~none
        narrow = (r <= NARROW * np.maximum(np.abs(x), 1.0)).all(axis=0)
        if inside.any():
            found.append((centre[:, inside], x_wide[:, inside], wide[:, inside], of[inside]))
        last = narrow & ~inside & ~none
        open_.append((x[:, last], of[last]))
        left = np.flatnonzero(~(none | inside | last))
        # what the operator leaves of a box holds what solutions it has
        low = np.fmax(low, centre - radius)[:, left]
        high = np.fmin(high, centre + radius)[:, left]
        # in no direction by so much that roundings would count there, while it is still wide in others
        more = np.maximum(THIN * np.maximum(np.abs(x[:, left]), 1.0) - 0.5 * (high - low), 0.0)
        low, high = low - more, high + more
        # a proof has to be wider than the roundings that it holds
        doubt = 2 * np.tile(np.where(np.isfinite(floor), floor, 0.0)[:, left], 2)
        low, high, of = _cut(low, high, of[left], slopes[..., left])
    undecided, undecided_of = (np.concatenate(pieces, axis=-1) for pieces in zip(*open_, strict=True))
    x, middle, wide, of = (np.concatenate(pieces, axis=-1) for pieces in zip(*found, strict=True))
    if of.size:
        x = _refined(equations, x, of, wide)
    kept = _once(x, middle, wide, of)
    covered = _covered(undecided, undecided_of, middle[:, kept], wide[:, kept], of[kept])
    return Solutions(x[:, kept], of[kept], undecided[:, ~covered], undecided_of[~covered])


def _krawczyk(values: Floats, x: Floats, r: Floats, slopes: Floats) -> tuple[Floats, Floats, Floats]:
    """x - Y f(x) + (1 - Y J)(X - x), Y the inverse of J in the middle of X: its centre and radius; `values` at x.

    And what of the radius is due to how `values` are known.
    """
    d = x.shape[0]
    middle, spread = 0.5 * (slopes[0] + slopes[1]), 0.5 * (slopes[1] - slopes[0])
    known = np.isfinite(middle).all(axis=(0, 1)) & np.isfinite(spread).all(axis=(0, 1))
    J = np.where(known, middle, np.eye(d)[..., np.newaxis]).transpose(2, 0, 1)
    determinant = np.linalg.det(J)
    singular = ~(np.abs(determinant) > 0) | ~np.isfinite(determinant)
    J[singular] = np.eye(d)
    Y = np.linalg.inv(J)
    # at x itself, with its roundings
    value, doubt = (0.5 * (values[1] + sign * values[0]).T[..., np.newaxis] for sign in (1, -1))
    size = np.abs(Y)
    centre = x - (Y @ value)[..., 0].T
    apart = np.abs(np.eye(d) - Y @ J) + size @ spread.transpose(2, 0, 1)
    # some multiplications of doubles, each a rounding
    rounding = 2.0**-49 * (size @ np.abs(J) + 1.0) @ r.T[..., np.newaxis] + 2.0**-49 * size @ np.abs(value)
    floor = (size @ doubt)[..., 0].T + 2.0**-51 * np.abs(x)
    radius = (apart @ r.T[..., np.newaxis] + rounding)[..., 0].T + floor
    lost = singular | ~known
    return centre, np.where(lost | np.isnan(radius), np.inf, radius), np.where(lost, np.inf, floor)


def _each_equation(values: Floats, x: Floats, r: Floats, slopes: Floats) -> Floats:
    """Between which ends each equation by itself has its zeros in each unknown by which its slope has a sign."""
    variation = np.max(np.abs(slopes), axis=0) * r * (1 + 2.0**-40)
    low, high = np.full_like(x, -np.inf), np.full_like(x, np.inf)
    for i, by in enumerate(variation):
        for j in range(len(x)):
            others = by.sum(axis=0) - by[j] + 2.0**-40 * by.sum(axis=0)
            flat = np.where(
                slopes[0, i, j] > 0, slopes[0, i, j], np.where(slopes[1, i, j] < 0, slopes[1, i, j], np.nan)
            )
            steep = np.where(flat > 0, slopes[1, i, j], slopes[0, i, j])
            # -(value + what others move it by) over a slope between these two
            ends = np.stack((others - values[0, i], -others - values[1, i]))
            each = ends[:, np.newaxis] / np.stack((flat, steep))
            doubt = 2.0**-40 * np.abs(each).max(axis=(0, 1))
            low[j] = np.fmax(low[j], x[j] + each.min(axis=(0, 1)) - doubt)
            high[j] = np.fmin(high[j], x[j] + each.max(axis=(0, 1)) + doubt)
    return np.stack((low, high))


def _cut(low: Floats, high: Floats, of: Ints, slopes: Floats) -> tuple[Floats, Floats, Ints]:
    """Each box in two, across the unknown in which the equations vary most over it."""
    width = high - low
    size = np.max(np.abs(slopes), axis=0)
    scale = np.max(np.where(np.isfinite(size), size, 0.0), axis=1, keepdims=True)
    varies = np.max(np.where(np.isfinite(size), size / np.where(scale > 0, scale, 1.0), 1.0), axis=0) * width
    # one that is not to be cut further is not cut
    place = 0.5 * (low + high)
    varies = np.where(0.5 * width > NARROW * np.maximum(np.abs(place), 1.0), np.maximum(varies, 1e-3 * width), 0.0)
    across = np.argmax(varies, axis=0)
    n = np.arange(of.size)
    middle = place[across, n]
    lower, upper = high.copy(), low.copy()
    lower[across, n] = upper[across, n] = middle
    return np.concatenate((low, upper), axis=1), np.concatenate((lower, high), axis=1), np.concatenate((of, of))


def _refined(equations: Equations, x: Floats, of: Ints, scale: Floats) -> Floats:
    """Newton's steps, as long as they become shorter."""
    last = np.full(of.size, np.inf)
    for _ in range(12):
        values, slopes = equations.at(x, of)
        J = slopes.transpose(2, 0, 1)
        # of numbers that underflow nothing is left to solve
        regular = np.linalg.det(J / np.maximum(np.abs(J).max(axis=(1, 2), keepdims=True), 2.0**-1000)) != 0
        J = np.where(regular[:, np.newaxis, np.newaxis], J, np.eye(len(x)))
        step = np.where(regular, np.linalg.solve(J, values.T[..., np.newaxis])[..., 0].T, 0.0)
        length = np.max(np.abs(step) / scale, axis=0)
        goes = (length < last) & (length > 0)
        if not goes.any():
            break
        x = np.where(goes, x - step, x)
        last = np.where(goes, length, last)
    return x


def _once(x: Floats, middle: Floats, wide: Floats, of: Ints) -> list[int]:
    """Numbers of the solutions, each once: one on the edge of two boxes was found in both, which hold just one each."""
    kept: list[int] = []
    for i in np.lexsort((*x[::-1], of)):
        others = itertools.takewhile(lambda j, i=i: of[j] == of[i], reversed(kept))  # type: ignore[misc]
        if not any((np.abs(x[:, i] - middle[:, j]) < wide[:, j]).all() for j in others):
            kept.append(int(i))
    return kept


def _covered(undecided: Floats, undecided_of: Ints, middle: Floats, wide: Floats, of: Ints) -> Flags:
    """Which undecided boxes lie where a solution is proved to be the only one."""
    covered = np.zeros(undecided_of.size, dtype=bool)
    for i, one in enumerate(undecided_of):
        inside = np.abs(undecided[:, i : i + 1] - middle) < (1 - AROUND) * wide
        covered[i] = bool((inside.all(axis=0) & (of == one)).any())
    return covered
