"""Means over a cycle of what a force has beside its steps, r = f - steps, where that is no polynomial.

In:  the pieces of the force as `Curved` of a record has them, and how they are summed.
Out: moments <r^(n) cos^p psi> along u = B + A cos psi: values, and intervals that hold them on boxes.

r' is continuous (derivations/asymmetric/curved.py): moments of r and r' have slopes without terms from moving angles,
and those of r'' only where r'' jumps.

Values are sums by Gauss's rule between the angles at which the motion passes an end, on 2, 4, 8, ... panels until twice
as many change nothing. On a box the force and its derivatives are evaluated on intervals of u, panel by panel of the
angle. That alone would be off by the width of the panels: a moment is its value in the middle of the box and what its
slopes, held on all of the box, can change it by. So it is held the better the smaller the box, by the square of that.
"""

from __future__ import annotations

from collections import namedtuple
from collections.abc import Sequence
from functools import cache
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from slowflow.core.intervals import ALL, Elementary, Interval
from slowflow.core.mechanism import Flags
from slowflow.core.model import Floats
from slowflow.support.quadrature import gauss

#: nodes of Gauss's rule on each panel, and its most panels between two ends
NODES, MOST_PANELS = 16, 256
#: by how much sums on twice as many panels may differ, and sums by quadrature err, of the integral of the size
AGREED, DOUBT = 2.0**-46, 2.0**-46
#: panels of the angle on boxes: an even number, for the cosine has one sign on each
PANELS = 40
#: numbers that are held at a time
TOGETHER = 1 << 20
#: roundings outwards
_OUT = np.array([[-(2.0**-48)], [2.0**-48]])

_AT, _WEIGHTS = gauss(NODES)
_FRACTIONS = np.linspace(0.0, 1.0, PANELS + 1)
#: dense where a motion turns, about which a stiff force acts
_EDGES = np.pi * _FRACTIONS**2 * (3 - 2 * _FRACTIONS)
_INSIDE = _EDGES[:-1, np.newaxis] + _AT * np.diff(_EDGES)[:, np.newaxis]
#: cosine at the edges of the panels
_COSINE = np.cos(_EDGES)
_COSINE[PANELS // 2] = 0.0


def _weights(weight: Any) -> Floats:
    """The mean over each panel of a function of the cosine, over the half cycle, which has one sign on each."""
    return np.asarray(weight(np.cos(_INSIDE)) @ _WEIGHTS * np.diff(_EDGES) / np.pi)


#: of moments with (1 + cos)^i (1 - cos)^j, on boxes of both ends, and with cos^p, on boxes of A and B
_BY_ENDS = {(i, j): _weights(lambda c, i=i, j=j: (1 + c) ** i * (1 - c) ** j) for i in range(4) for j in range(4 - i)}
_OF_COSINE = {p: _weights(lambda c, p=p: c**p) for p in range(2)}
_TURNED = {1: _weights(lambda c: c * (1 + c)), -1: _weights(lambda c: c * (1 - c))}


@cache
def _rule(panels: int) -> tuple[Floats, Floats]:
    """Nodes on panels of (0, 1), and weights of means over the cycle, of which it is the half, (k,)."""
    x = ((np.arange(panels)[:, np.newaxis] + _AT) / panels).ravel()
    # dense next to both ends, in the third power
    fraction = x**3 * (10 - 15 * x + 6 * x * x)
    return fraction, np.tile(_WEIGHTS, panels) / (panels * np.pi) * 30 * (x * (1 - x)) ** 2


class Part(NamedTuple):
    """A piece of the force with its numbers.

    law, enclosed -- f and three derivatives at u, and on intervals of u
    mirrored      -- whether these are of -f(-u)
    line          -- what the steps are on it: a + b u
    """

    law: Any
    enclosed: Any
    mirrored: bool
    line: tuple[float, float]

    def at(self, u: Floats, far: Floats) -> tuple[list[Floats], list[Floats]]:
        """r and three derivatives; and by what size of numbers each is rounded, where u is as numbers of size `far`."""
        found = map(np.asarray, self.law(-u if self.mirrored else u))
        values = [one if one.shape == u.shape else np.broadcast_to(one.astype(float), u.shape) for one in found]
        if self.mirrored:
            values = [one if n % 2 else -one for n, one in enumerate(values)]
        (a, b), sizes = self.line, list(map(np.abs, values))
        sizes[0], sizes[1] = sizes[0] + (abs(a) + abs(b * u)), sizes[1] + abs(b)
        sizes = [*(one + far * slope for one, slope in pairwise(sizes)), sizes[-1]]
        return [values[0] - (a + b * u), values[1] - b, *values[2:]], sizes

    def force(self, u: Interval) -> list[Interval]:
        """f and three derivatives on intervals."""
        at = Elementary(-u.ends[::-1] if self.mirrored else u.ends)
        values = [Interval.like(one, at) for one in self.enclosed(at)]
        return [one if n % 2 else -one for n, one in enumerate(values)] if self.mirrored else values

    def on(self, u: Interval) -> list[Interval]:
        """r and three derivatives on intervals."""
        f, slope, *others = self.force(u)
        a, b = self.line
        return [f - (u * b + a), slope - b, *others]


#: moments on boxes of both ends of the motion: c_0, s_0, c_1 +- s_1, of r'' with (1 +- cos)^2; c_3 and s_2
Ended = namedtuple("Ended", "c_0 s_0 P_1 Q_1 P_P Q_Q c_3 s_2")


class Curved:
    """What one force has beside its steps.

    parts -- of the force by rising u
    ends  -- where each but the last ends
    bends -- what f'' gains there
    walls -- the u that no motion passes, below and above: beyond them nothing is known
    """

    def __init__(
        self, pieces: Sequence[Part], ends: Floats, bends: Floats, walls: tuple[float, float] = (-np.inf, np.inf)
    ) -> None:
        self.walls = walls
        self.pieces, self.ends, self.bends = tuple(pieces), ends, bends
        self._edges = np.concatenate(([-np.inf], ends, [np.inf]))
        #: u = 0 too, about which a force acts that is small beside the motion
        self._cuts = np.unique(np.append(ends, 0.0))
        self._of_cut = np.searchsorted(ends, np.append(self._cuts, np.inf), side="left")

    def within(self, low: Any, high: Any) -> Curved:
        """The pieces alone that one motion passes, the outermost as if they held everywhere beyond."""
        first, last = np.searchsorted(self.ends, np.ravel([low, high])).tolist()
        return Curved(self.pieces[first : last + 1], self.ends[first:last], self.bends[first:last])

    # ==== Numbers =====================================================================================================

    def at(self, A: Floats, B: Floats, orders: int) -> tuple[list[Floats], list[Floats]]:
        """c_n and s_n for n up to `orders`, at most 3, of which the last are as near as sums of the others require."""
        moments = [(n, p) for n in range(orders + 1) for p in (0, 1)]
        with np.errstate(all="ignore"):
            found = self._moments(A, B, moments)[0]
            if orders >= 3 and self.bends.any():
                a = self.ends[:, np.newaxis] - B
                root = np.sqrt((A - a) * (A + a))
                passed = np.abs(a) < A
                for row, value in ((6, 1 / (np.pi * root)), (7, a / (np.pi * A * root))):
                    found[row] += (self.bends[:, np.newaxis] * np.where(passed, value, 0.0)).sum(axis=0)
        return list(found[0::2]), list(found[1::2])

    def _moments(self, A: Floats, B: Floats, moments: Sequence[tuple[int, int]]) -> tuple[Floats, Floats]:
        """<r^(n) cos^p> for each (n, p), and the mean of what that is rounded by: (moments, n).

        A motion with a negative A is one turned by half.
        """
        turn, A = np.where(A < 0, -1.0, 1.0), np.abs(A)
        highest = max(n for n, _ in moments)
        found, size = np.zeros((2, len(moments), A.size))
        angles = self._angles(A, B)
        within = (B - A > self.walls[0]) & (B + A < self.walls[1])
        # a half cycle between two cuts is on the piece that ends at the upper one
        low, high = np.where(within, angles[1:], np.nan), angles[:-1]
        for number, part in enumerate(self.pieces):
            cuts, all_of = np.nonzero((self._of_cut == number)[:, np.newaxis] & (high > low))
            for first in range(0, all_of.size, step := max(1, TOGETHER // (NODES * 8 * (highest + 1)))):
                cut, of = cuts[first : first + step], all_of[first : first + step]
                own = self._settled(part, number, (A[of], B[of], low[cut, of], high[cut, of]), moments)
                np.add.at(found.T, of, own[0].T)
                np.add.at(size.T, of, own[1].T)
        for row, (_, p) in enumerate(moments):
            found[row] *= turn**p
        found[:, ~within] = np.nan
        return found, size

    def _angles(self, A: Floats, B: Floats) -> Floats:
        """At which the motion passes each cut, from pi down to 0."""
        a = self._cuts[:, np.newaxis] - B
        found = np.arctan2(np.sqrt(np.maximum((A - a) * (A + a), 0.0)), a)
        found = np.where(a >= A, 0.0, np.where(a <= -A, np.pi, found))
        return np.concatenate((np.full((1, A.size), np.pi), found, np.zeros((1, A.size))))

    def _settled(
        self, part: Part, number: int, motion: tuple[Floats, ...], moments: Sequence[tuple[int, int]]
    ) -> tuple[Floats, Floats]:
        """Over the angles at which motions are on one piece; NaN where sums do not converge."""
        n = motion[0].size
        sure = np.array([n < 3 for n, _ in moments])
        value, size, left = np.full((len(moments), n), np.nan), np.full((len(moments), n), np.nan), np.arange(n)
        last, panels = None, 2
        while left.size and panels <= MOST_PANELS:
            now, wide = self._summed(part, number, tuple(one[left] for one in motion), moments, panels)
            if last is not None:
                done = (np.abs(now - last) <= AGREED * wide)[sure].all(axis=0)
                value[:, left[done]], size[:, left[done]] = now[:, done], wide[:, done]
                # what is no number does not become one
                kept = ~done & np.isfinite(wide).all(axis=0)
                left, now = left[kept], now[:, kept]
            last, panels = now, 2 * panels
        return value, size

    def _summed(
        self,
        part: Part,
        number: int,
        motion: tuple[Floats, ...],
        moments: Sequence[tuple[int, int]],
        panels: int,
    ) -> tuple[Floats, Floats]:
        A, B, low, high = (one[:, np.newaxis] for one in motion)
        fraction, weight = _rule(panels)
        weight = weight * (high - low)
        cosine = np.cos(low + (high - low) * fraction)
        u = np.clip(B + A * cosine, self._edges[number], self._edges[number + 1])
        values, sizes = part.at(u, np.abs(A) + np.abs(B))
        powers = (cosine, cosine * cosine)
        found = [np.einsum("nk,nk->n", values[n] * powers[p - 1] if p else values[n], weight) for n, p in moments]
        size = {n: np.einsum("nk,nk->n", sizes[n], weight) for n in {n for n, _ in moments}}
        return np.array(found), np.array([size[n] for n, _ in moments])

    # ==== Boxes =======================================================================================================

    @np.errstate(all="ignore")
    def by_ends(self, top: Interval, bottom: Interval) -> Ended:
        """On boxes of B + A and B - A."""
        centre = [0.5 * (one.lo + one.hi) for one in (top, bottom)]
        radius = [
            np.maximum(one.hi - at, at - one.lo) * (1 + 2.0**-50) for one, at in zip((top, bottom), centre, strict=True)
        ]
        moments = [(0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2)]
        # boxes and their middles come together
        both, which = np.unique(np.stack((centre[0] - centre[1], centre[0] + centre[1])), axis=1, return_inverse=True)
        values, sizes = (one[:, which.ravel()] for one in self._moments(0.5 * both[0], 0.5 * both[1], moments))
        c_0, s_0, c_1, s_1, c_2, s_2, q_2 = values
        near = [c_0, s_0, c_1 + s_1, c_1 - s_1, c_2 + 2 * s_2 + q_2, c_2 - q_2, c_2 - 2 * s_2 + q_2]
        doubt = DOUBT * np.stack([sizes[0], sizes[0], *[2 * sizes[2]] * 2, *[4 * sizes[4]] * 3])
        at = [Interval(np.stack((one - off, one + off))) for one, off in zip(near, doubt, strict=True)]
        at += [Interval(np.tile(ALL, (1, c_0.size))) for _ in range(2)]
        wide = np.flatnonzero((radius[0] > 0) | (radius[1] > 0))
        if wide.size:
            some = [one.take(wide) for one in at]
            enclosures = self._around(
                top.take(wide), bottom.take(wide), [one[wide] for one in centre], [one[wide] for one in radius], some
            )
            for one, found in zip(at, enclosures, strict=True):
                one.ends[:, wide] = found.ends
        return Ended(*at[:5], *at[6:])

    def _around(
        self, top: Interval, bottom: Interval, centre: list[Floats], radius: list[Floats], at: list[Interval]
    ) -> list[Interval]:
        """The same as `at`, which is in the middles, on all of boxes."""
        # u rises with both ends: on each panel it is between those of its edges
        fraction = 0.5 * (1 + _COSINE)[:, np.newaxis]
        low, high = (end[0] * fraction + end[1] * (1 - fraction) for end in ((top.lo, bottom.lo), (top.hi, bottom.hi)))
        r, first, second, third = self._on_panels(np.minimum(low[:-1], low[1:]), np.maximum(high[:-1], high[1:]))

        def direct(values: Interval, i: int, j: int) -> Interval:
            return _mean(values, _BY_ENDS[i, j])

        def near(value: Interval, by_top: Interval, by_bottom: Interval) -> Interval:
            """Half of what the slopes bound, as A and B change by half as much as an end."""
            change = 0.5 * (_size(by_top) * radius[0] + _size(by_bottom) * radius[1]) * (1 + 2.0**-48)
            return Interval(np.stack((value.lo - change, value.hi + change)))

        slopes = {pair: direct(third, *pair) for pair in ((3, 0), (2, 1), (1, 2), (0, 3))}
        squares = {}
        for (i, j), value in zip(((2, 0), (1, 1), (0, 2)), at[4:7], strict=True):
            expanded = near(value, slopes[i + 1, j], slopes[i, j + 1]) + self._jumps(top, bottom, centre, i, j)
            squares[i, j] = direct(second, i, j).both(expanded)
        P_1 = direct(first, 1, 0).both(near(at[2], squares[2, 0], squares[1, 1]))
        Q_1 = direct(first, 0, 1).both(near(at[3], squares[1, 1], squares[0, 2]))
        c_0 = direct(r, 0, 0).both(near(at[0], P_1, Q_1))
        s_0 = _mean(r, _OF_COSINE[1]).both(near(at[1], *(_mean(first, _TURNED[side]) for side in (1, -1))))
        # where r'' jumps within a motion the mean of its slope has no bound
        bent = np.zeros(c_0.lo.size, dtype=bool)
        for end in self.ends[self.bends != 0].tolist():
            bent |= (bottom.lo <= end) & (end <= top.hi)
        c_3 = Interval(np.where(bent, ALL, _mean(third, _OF_COSINE[0]).ends))
        return [c_0, s_0, P_1, Q_1, *squares.values(), c_3, _mean(second, _OF_COSINE[1])]

    def _jumps(self, top: Interval, bottom: Interval, centre: list[Floats], i: int, j: int) -> Interval:
        """What jumps of r'' move its moment with (1 + cos)^i (1 - cos)^j by between the middle of a box and elsewhere.

        The share of a cycle beyond an end rises with both ends of the motion, with any weight.
        """
        found = np.zeros_like(top.ends)
        for end, bend in zip(self.ends.tolist(), self.bends.tolist(), strict=True):
            if bend == 0:
                continue
            here, low, high = (_beyond(end, T, D, i, j) for T, D in (centre, (top.lo, bottom.lo), (top.hi, bottom.hi)))
            both = bend * np.stack((low - here, high - here))
            found += np.sort(both, axis=0) + 2.0**-46 * abs(bend) * np.array([[-1.0], [1.0]])
        return Interval(found)

    def _on_panels(self, low: Floats, high: Floats) -> list[Interval]:
        """r and three derivatives on intervals of u, (2, panels, n)."""
        low, high = low - 2.0**-50 * np.abs(low), high + 2.0**-50 * np.abs(high)
        found = [np.stack((np.full(low.shape, np.inf), np.full(low.shape, -np.inf))) for _ in range(4)]
        for part, (start, end) in zip(self.pieces, pairwise(self._edges.tolist()), strict=True):
            there: Flags = (low <= end) & (high >= start)
            if not there.any():
                continue
            u = Interval(np.stack((np.maximum(low[there], start), np.minimum(high[there], end))))
            for bound, value in zip(found, part.on(u), strict=True):
                # what is not known of one piece is not known at all
                bound[0][there] = np.where(np.isnan(value.lo), -np.inf, np.minimum(bound[0][there], value.lo))
                bound[1][there] = np.where(np.isnan(value.hi), np.inf, np.maximum(bound[1][there], value.hi))
        return [Interval(one) for one in found]


def _mean(values: Interval, weights: Floats) -> Interval:
    """The mean over the cycle, of what is held on each panel (2, panels, n), with weights of one sign each."""
    w = weights[:, np.newaxis]
    both = np.where(w >= 0, values.ends, values.ends[::-1]) * w
    total, size = both.sum(axis=1), np.abs(both).sum(axis=1)
    return Interval(total + _OUT * np.where(np.isfinite(total), size, 0.0))


def _size(value: Interval) -> Floats:
    return np.asarray(np.abs(value.ends).max(axis=0))


def _beyond(end: float, top: Floats, bottom: Floats, i: int, j: int) -> Floats:
    """The mean of (1 + cos)^i (1 - cos)^j over the part of a cycle in which u is beyond an end; i + j = 2."""
    over, under = top - end, end - bottom
    angle = np.arctan2(np.sqrt(np.maximum(over * under, 0.0)), 0.5 * (under - over))
    angle = np.where(over <= 0, 0.0, np.where(under <= 0, np.pi, angle))
    sine, cosine = np.sin(angle), np.cos(angle)
    square = 0.5 * (angle + sine * cosine)
    linear = {(2, 0): 2.0, (1, 1): 0.0, (0, 2): -2.0}[i, j]
    return np.asarray((angle + linear * sine + (-square if i == j else square)) / np.pi)
