"""Means over a cycle by the motion's ends, B + A and B - A, in coordinates in which they are smooth.

In:  a force as steps; charts of the plane of both ends, and boxes of x and y in these.
Out: `Local`: A, c_0 = <f>, s_0 = <f cos psi> and the slopes of c_0 by x and y, which hold all values on each box.

Where a motion just passes a step, what the force gains there shares in c_1 as 1/sqrt(distance), and no box in A and B
is narrow enough. Lines through the steps cut the plane of the ends into rectangles, the charts. In each the same steps
are passed, and only those at its own lower edge of B + A and upper edge of B - A are near: with x and y the distances
from these, or their roots where the force jumps, everything is smooth up to the edges
(derivations/asymmetric/off_centre.py).

U_k and V_k = L_k +- M_k are the means of (A cos psi - a)^k/k! with 1 +- cos psi. Both rise with either end of the
motion, so that the values at two corners hold them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from slowflow.intervals import Bools, Interval
from slowflow.model import Floats
from slowflow.off_centre.boxes import Ints
from slowflow.off_centre.means import ALL, DOUBT, Steps
from slowflow_kernels import off_centre

#: times the farthest step, the amplitude from which on motions are large beside all steps
LARGE = 4.0
#: a root is taken for no less: it stands in products that vanish with it
TINY = 2.0**-400
_OUTWARDS = np.array([[-(2.0**-50)], [2.0**-50]])


@dataclass(frozen=True, eq=False)
class Local:
    """On boxes: X and Y are A_x and A_y, X_x and Y_y their slopes; c_x ... those of c_0."""

    A: Interval
    B: Interval
    c_0: Interval
    s_0: Interval
    c_x: Interval
    c_y: Interval
    c_xx: Interval
    c_yy: Interval
    X: Interval
    Y: Interval
    X_x: Interval
    Y_y: Interval

    def take(self, which: Any) -> Local:
        """Some of the boxes."""
        return Local(*(one.take(which) for one in vars(self).values()))


class Charts:
    """The charts of one force, by number.

    passes    -- whether its motions pass a step; where they do not x = B + A and y = A - B
    place     -- the ends' values where x = 0 and y = 0, (2, charts)
    rooted    -- whether x and y are roots, (2, charts): where the force jumps at x = 0 or y = 0. Elsewhere they are how
                 far each end is past that
    low, high -- the limits of x and y in each, (2, charts)
    """

    def __init__(self, steps: Steps) -> None:
        self.steps = steps
        at = steps.sides[1:] * steps.places[1:]
        lines = np.unique(at)
        edges = np.concatenate(([-np.inf], lines, [np.inf]))
        if steps.beyond is not None:
            edges[[0, -1]] = -steps.beyond[1].wall, steps.beyond[0].wall
        self.upper, self.lower = np.array([(i, k) for i in range(edges.size - 1) for k in range(i + 1)]).T
        i, k = self.upper, self.lower
        self._at, self._line = lines[:, np.newaxis], 1 + np.arange(lines.size)[:, np.newaxis]
        #: what is gained at lines: above the piece that a motion's means begin with by steps on the right, and below it
        #: by steps on the left, which are those of -f(-u)
        self._mirrored = (-1.0) ** np.arange(steps.highest + 1)
        self._gains = np.zeros((lines.size, steps.highest + 1))
        for line, side, gain in zip(
            self._line[:, 0][np.searchsorted(lines, at)], steps.sides[1:], steps.gains[1:], strict=True
        ):
            self._gains[line - 1] += gain if side > 0 else self._mirrored * gain
        self._large = (
            LARGE * float(np.abs(lines).max()) if lines.size and steps.odd and steps.curved is None else np.inf
        )
        self.passes = i > k
        jumps = np.append(self._gains[:, 0], 0.0) != 0
        self.rooted = self.passes & np.stack((jumps[i - 1], jumps[k]))
        self.place = np.where(self.passes, np.stack((edges[i], edges[k + 1])), 0.0)
        with np.errstate(invalid="ignore"):
            lengths = np.stack((edges[i + 1] - edges[i], edges[k + 1] - edges[k]))
        self.low = np.where(self.passes, 0.0, np.stack((edges[i], -edges[k + 1])))
        self.high = np.where(self.passes, lengths, np.stack((edges[i + 1], -edges[k])))
        self.high[self.rooted] = np.sqrt(self.high[self.rooted])

    def motion(self, x: Floats, y: Floats, chart: Ints) -> tuple[Floats, Floats]:
        """A and B at points."""
        past_x, past_y = (np.where(self.rooted[i, chart], one * one, one) for i, one in enumerate((x, y)))
        upper, lower = self.place[:, chart]
        return 0.5 * (upper - lower + (past_x + past_y)), 0.5 * (upper + lower + (past_x - past_y))

    def inside(self, edge: int, along: float, chart: int) -> tuple[int, float, float]:
        """The chart on the other side of the edge x = 0 or y = 0, of motions that are not past it; x and y there."""
        i, k = int(self.upper[chart]) - (edge == 0), int(self.lower[chart]) + (edge == 1)
        (other,) = np.flatnonzero((self.upper == i) & (self.lower == k)).tolist()
        if i == k:  # x and y are the ends there
            past = along**2 if self.rooted[1 - edge, chart] else along
            along = past + float(self.place[1 - edge, chart]) * (1 if edge else -1)
        at = float(self.high[edge, other])
        return (other, along, at) if edge else (other, at, along)

    def stiffness(self, x: Interval, y: Interval, chart: Ints) -> Interval:
        """f' on all that motions may pass next to one place: -h/A is a mean of it; unknown where the force jumps there.

        They are of one piece, or of two, one step being passed by small motions.
        """
        passes, rooted = self.passes[chart], self.rooted[:, chart]
        past_x, past_y = (np.where(root, one.hi**2, one.hi) for root, one in zip(rooted, (x, y), strict=True))
        upper, lower = self.place[:, chart]
        u = Interval(np.stack((lower - past_y, upper + past_x)))
        ends = [self._slope(u, self.steps.pieces[of[chart]].T).ends for of in (self.upper, self.lower)]
        hull = np.stack((np.minimum(ends[0][0], ends[1][0]), np.maximum(ends[0][1], ends[1][1])))
        known = ~rooted.any(axis=0) & (~passes | (self.upper[chart] == self.lower[chart] + 1))
        found = Interval(np.where(known, hull, ALL))
        return found if self.steps.curved is None else found + self.steps.curved.slope(u)

    @staticmethod
    def _slope(u: Interval, D: Floats) -> Interval:
        """That of a polynomial by its derivatives at u = 0."""
        found, power = Interval(np.zeros_like(u.ends)), Interval(np.ones_like(u.ends))
        for k in range(1, len(D)):
            found = found + _scaled(power, D[k] / math.factorial(k - 1))
            power = (u.square() if k == 2 else power * u) if k > 1 else u
        return found

    def on(self, x: Interval, y: Interval, chart: Ints) -> Local:
        """On boxes within the limits of their charts."""
        with np.errstate(all="ignore"):
            return self._on(x, y, chart)

    def _on(self, x: Interval, y: Interval, chart: Ints) -> Local:
        (root_x, root_y), (upper, lower) = self.rooted[:, chart], self.place[:, chart]
        x, y = above_diagonal(x, y, self.passes[chart])
        past_x, past_y = x.square().where(root_x, x), y.square().where(root_y, y)
        top, bottom = past_x + upper, -past_y + lower
        A = (past_x + past_y + (upper - lower)) * 0.5
        nowhere = A.hi < 0
        A = Interval(np.maximum(A.ends, 0.0))
        one = np.ones_like(x.ends)
        X, Y = (z.where(rooted, Interval(0.5 * one)) for z, rooted in ((x, root_x), (y, root_y)))
        X_x, Y_y = Interval(root_x * one), Interval(root_y * one)
        # the piece in the middle of the motion: the others are passed least
        centre = np.searchsorted(self._at[:, 0], 0.25 * (top.ends + bottom.ends).sum(axis=0))
        base = np.clip(centre, self.lower[chart], self.upper[chart])
        known = [self._first(top, bottom, A, base)]
        shares = [Interval(0.0 * one)] * 4
        if self._at.size:
            others, shares = self._others((past_x, X, X_x), (past_y, Y, Y_y), A, chart, base)
            known.append(others)
        # where A is negative nothing is known: in the middle of a box that holds A = 0
        c_0, s_0, P_1, Q_1, P_2, Q_2 = (
            Interval(np.where(nowhere, ALL, sum(parts[1:], parts[0]).ends)) for parts in zip(*known, strict=True)
        )
        s_1 = (P_1 - Q_1) * 0.5
        bent = s_1 / A
        c_x, c_y = X * P_1 + shares[0], -(Y * Q_1 + shares[1])
        c_xx = X_x * P_1 + X.square() * (P_2 * 2.0 - bent) + shares[2]
        c_yy = Y.square() * (Q_2 * 2.0 - bent) - Y_y * Q_1 - shares[3]
        B = (top + bottom) * 0.5
        found = self._beside_large(Local(A, B, c_0, s_0, c_x, c_y, c_xx, c_yy, X, Y, X_x, Y_y))
        if self.steps.curved is None:
            return found
        r = self.steps.curved.by_ends(top, bottom)
        gained = {
            "c_0": r.c_0,
            "s_0": r.s_0,
            "c_x": X * r.P_1,
            "c_y": -(Y * r.Q_1),
            "c_xx": X_x * r.P_1 + X.square() * r.P_P,
            "c_yy": Y.square() * r.Q_Q - Y_y * r.Q_1,
        }
        return replace(found, **{name: getattr(found, name) + value for name, value in gained.items()})

    def _beside_large(self, found: Local) -> Local:
        """The same, of motions that are large beside all steps by the base alone too, see `Steps.on`."""
        large = np.flatnonzero(found.A.lo > self._large)
        if not large.size:
            return found
        of = found.take(large)
        means = self.steps.on(of.A, of.B, 2)
        (c_0, c_1, c_2), (s_0, s_1, s_2) = means.c, means.s
        P_1, Q_1, bent = c_1 + s_1, c_1 - s_1, s_1 / of.A
        nearer = {
            "c_0": c_0,
            "s_0": s_0,
            "c_x": of.X * P_1,
            "c_y": -(of.Y * Q_1),
            "c_xx": of.X_x * P_1 + of.X.square() * ((c_2 + s_2) * 2.0 - bent),
            "c_yy": of.Y.square() * ((c_2 - s_2) * 2.0 - bent) - of.Y_y * Q_1,
        }
        whole = dict(vars(found))
        for name, value in nearer.items():
            ends = whole[name].ends.copy()
            ends[:, large] = getattr(of, name).both(value).ends
            whole[name] = Interval(ends)
        return Local(**whole)

    def _first(self, top: Interval, bottom: Interval, A: Interval, base: Ints) -> list[Interval]:
        """c_0, s_0, P_1, Q_1, P_2, Q_2 of the piece to begin with.

        What it has beside a straight line is a step on either side of u = 0: each has powers of one sign only.
        """
        D = self.steps.pieces[base].T
        bent = D[:, np.newaxis] * np.stack((np.ones(len(D)), -self._mirrored), axis=1)[..., np.newaxis]
        bent[:2] = 0.0
        right = np.array([[True], [False]])
        over, under = (
            np.stack(pair, axis=1) for pair in ((top.ends, -bottom.ends[::-1]), (-bottom.ends[::-1], top.ends))
        )
        # how far the lower end is below u = 0, and for the left how far the upper end is above it
        found = _summed(bent, right, _ladder(over, under, len(D) - 1))
        slope = _scaled(Interval(np.ones_like(top.ends)), D[1])
        straight = (_scaled((top + bottom) * 0.5, D[1]) + D[0], _scaled(A * 0.5, D[1]), slope, slope)
        return [*(one + other for one, other in zip(found, straight, strict=False)), *found[4:]]

    def _others(
        self, by_x: Sequence[Interval], by_y: Sequence[Interval], A: Interval, chart: Ints, base: Ints
    ) -> tuple[list[Interval], list[Interval]]:
        """The same of all other steps, and what c_x, -c_y, c_xx, -c_yy have of gains of f and f' that are passed."""
        upper, lower = self.upper[chart], self.lower[chart]
        passed = (lower < self._line) & (self._line <= upper)
        right = self._line > base
        # from the coordinates themselves: exact where a step is near
        place_x, place_y = self.place[:, chart]
        beyond_x, beyond_y = place_x - self._at, self._at - place_y
        above, below = (
            _wide(by[0].ends[:, np.newaxis] + beyond) for by, beyond in ((by_x, beyond_x), (by_y, beyond_y))
        )
        above, below = (np.where(passed, np.maximum(one, 0.0), 1.0) for one in (above, below))
        over, under = np.where(right, above, below), np.where(right, below, above)
        mirrored = np.where(right, 1.0, self._mirrored[:, np.newaxis, np.newaxis])
        gains = np.where(passed, self._gains.T[..., np.newaxis] * mirrored, 0.0)
        known = _summed(gains, right, _ladder(over, under, self.steps.highest))
        shares = np.zeros((4, *A.ends.shape))
        step, box = np.nonzero((gains[:2] != 0).any(axis=0))
        if box.size:
            near_x, near_y = (
                (Interval(ends[:, step, box]).sqrt(), beyond[step, box], *(one.take(box) for one in by[1:]))
                for by, ends, beyond in ((by_x, above, beyond_x), (by_y, below, beyond_y))
            )
            D_0, D_1 = self._gains[step, :2].T / np.pi
            for row, value in enumerate(_shares(near_x, near_y, A.take(box), D_0, D_1)):
                for end in (0, 1):
                    np.add.at(shares[row, end], box, value.ends[end])
        return known, [Interval(_wide(one)) for one in shares]


def above_diagonal(x: Interval, y: Interval, passes: Bools) -> tuple[Interval, Interval]:
    """Where motions pass no step, x = B + A and y = A - B the part of boxes in which A is not negative."""
    low = (
        np.where(passes, one.lo, np.minimum(np.maximum(one.lo, -other.hi), one.hi)) for one, other in ((x, y), (y, x))
    )
    low_x, low_y = low
    return Interval(np.stack((low_x, x.hi))), Interval(np.stack((low_y, y.hi)))


def _wide(ends: Floats) -> Floats:
    """Rounded outwards."""
    outwards = _OUTWARDS.reshape(2, *(1,) * (ends.ndim - 1))
    return np.asarray(ends + outwards * np.abs(ends))


def _scaled(value: Interval, by: Floats) -> Interval:
    """Times numbers of any sign; 0 times what is not known is 0."""
    return Interval(_wide(np.where(by == 0, 0.0, np.sort(value.ends * by, axis=0))))


def _shares(
    near_x: tuple[Interval, Floats, Interval, Interval],
    near_y: tuple[Interval, Floats, Interval, Interval],
    A: Interval,
    D_0: Floats,
    D_1: Floats,
) -> list[Interval]:
    """What gains D_0 pi of f and D_1 pi of f' share in c_x, -c_y, c_xx, -c_yy where a motion passes them.

    near_x, near_y -- the root of how far that end is past the step, the square of that where x = 0, X and X_x; of y too

    c_1 + s_1 has D_0 root_y/(root_x A), and c_1 - s_1 the inverse of that ratio; c_2 +- s_2 the same of D_1.
    """
    found = []
    for (root, far, X, X_x), (other, _, _, _), sign in ((near_x, near_y, 1.0), (near_y, near_x, -1.0)):
        rooted = X_x.lo > 0
        own = rooted & (far == 0)
        # of a root x/root rises from 0 to 1, and is 1 where the step is the chart's own; of an end 1/2 over it falls
        rising, falling = X.ends / np.sqrt(X.ends**2 + far), 0.5 / root.ends[::-1]
        ratio = Interval(np.where(own, 1.0, _wide(_wide(np.where(rooted, rising, falling)))))
        share = ratio * other / A
        cube = root.square() * root
        bent = Interval(np.where(rooted, np.stack((far, far)), -0.25)) / cube
        turn = Interval(np.where(own, 0.0, _wide(bent.ends)))
        slope = other / A * (turn - ratio * X / A)
        found.append((_scaled(share, D_0), _scaled(slope, D_0) + _scaled(X * share, 2.0 * sign * D_1)))
    return [found[0][0], found[1][0], found[0][1], found[1][1]]


def _ladder(over: Floats, under: Floats, highest: int) -> tuple[Floats, Floats, Floats]:
    """L_k, U_k and V_k of steps: lower and upper ends, (2, highest + 1, steps, n).

    over, under -- ends of how far the upper end of the motion is above a step, and its lower end below it
    """
    # both corners: the lesser has the least of the upper and the least of the lower end
    under = under[::-1]
    A, a = 0.5 * (over + under), 0.5 * (under - over)
    above, passed = over > 0, (over > 0) & (under > 0)
    root = np.sqrt(np.where(passed, over * under, 0.0))
    shape = (2, highest + 1, *over.shape[1:])
    L, M, U, V = np.zeros((4, *shape))
    begin = off_centre.begin(A, a, np.maximum(root, TINY), np.arctan2(root, a))
    L_1, M_1 = (np.where(passed, begin[row], 0.0) for row in (0, 2))
    L[:, 0], M[:, 0] = np.where(passed, begin[1], above), np.where(passed, begin[3], 0.0)
    doubt = np.where(above, DOUBT, 0.0)
    sign = np.array([-2.0, 2.0]).reshape(2, *(1,) * (over.ndim - 1))
    for k in range(highest + 1):
        if k:
            before = (L_1, M_1) if k == 1 else (L[:, k - 2], M[:, k - 2])
            L[:, k], M[:, k] = off_centre.up(k, A, a, before[0], L[:, k - 1], before[1], M[:, k - 1])
            doubt = doubt * (A + np.abs(a)) / k
        for held, value in ((U, L[:, k] + M[:, k]), (V, L[:, k] - M[:, k])):
            held[:, k] = np.where(above, np.maximum(value + sign * doubt, 0.0), 0.0)
        L[:, k], M[:, k] = (np.where(above, one[:, k], 0.0) for one in (L, M))
    return 0.5 * (U + V), U, V


def _summed(D: Floats, right: Bools, ladder: tuple[Floats, Floats, Floats]) -> list[Interval]:
    """c_0, s_0, P_1, Q_1, P_2, Q_2: steps on the left are those of -f(-u), in which 1 + cos psi and 1 - cos psi change.

    D -- gains of each derivative (k, steps, n or 1)
    """
    L, U, V = ladder
    M = 0.5 * (U - V[::-1])
    P, Q, side = np.where(right, U, V), np.where(right, V, U), np.where(right, 1.0, -1.0)
    sums = ((side * D, L, 0), (D, M, 0), (D, P, 1), (D, Q, 1), (side * D, P, 2), (side * D, Q, 2))
    found = []
    for weights, ends, n in sums:
        w, held = weights[n:], ends[:, : ends.shape[1] - n]
        low = np.where(w >= 0, w * held[0], w * held[1]).sum(axis=(0, 1))
        high = np.where(w >= 0, w * held[1], w * held[0]).sum(axis=(0, 1))
        slack = (w.shape[0] * w.shape[1] + 2) * 2.0**-52 * (np.abs(w) * np.abs(held).max(axis=0)).sum(axis=(0, 1))
        found.append(Interval(np.stack((low - slack, high + slack))))
    return found
