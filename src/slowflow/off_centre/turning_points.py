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
from typing import Any, NamedTuple

import numpy as np

from slowflow.core.backend import SOLVER
from slowflow.core.intervals import ALL, Interval
from slowflow.core.mechanism import Flags, Ints
from slowflow.core.model import Floats
from slowflow.off_centre.means import Steps
from slowflow.support.errors import Refused
from slowflow.support.text import Sentence

#: times the farthest step, the amplitude from which on motions are large beside all steps
LARGE = 4.0
#: steps on both sides and powers of u in a piece, at most: as native/turning_points.h has room
MOST_LINES, MOST_POWERS = 32, 64
TOO_LARGE = Sentence(
    "offset motions are not derived for a force with {lines:d} breakpoints and powers up to {highest:d}: at most "
    "{most[0]:d} and {most[1]:d}"
)


#: of a chart: x = 0 and y = 0
EDGES = np.array([[0], [1]])
#: the remainder of a force that is a polynomial
NOTHING = np.empty(0)


class Local(NamedTuple):
    """On boxes: X and Y are A_x and A_y, X_x and Y_y their slopes; c_x ... those of c_0; c_3 and s_2 next to B = 0.

    The order is that of native/turning_points.h, which has them as rows (n, 28).
    """

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
    c_3: Interval
    s_2: Interval

    @classmethod
    def of(cls, rows: Floats) -> Local:
        """From rows."""
        return cls(*map(Interval, rows.T.reshape(len(cls._fields), 2, len(rows))))


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
        at = steps.sides[1:] * steps.positions[1:]
        lines = np.unique(at)
        edges = np.concatenate(([-np.inf], lines, [np.inf]))
        if steps.beyond is not None:
            edges[[0, -1]] = -steps.beyond[1].wall, steps.beyond[0].wall
        self.upper, self.lower = np.array([(i, k) for i in range(edges.size - 1) for k in range(i + 1)]).T
        i, k = self.upper, self.lower
        self._at = lines
        #: what is gained at lines: above the piece that a motion's means begin with by steps on the right, and below it
        #: by steps on the left, which are those of -f(-u)
        mirrored = (-1.0) ** np.arange(steps.highest + 1)
        self._gains = np.zeros((lines.size, steps.highest + 1))
        for line, side, gain in zip(np.searchsorted(lines, at), steps.sides[1:], steps.gains[1:], strict=True):
            self._gains[line] += gain if side > 0 else mirrored * gain
        self._large = (
            LARGE * float(np.abs(lines).max()) if lines.size and steps.odd and steps.curved is None else np.inf
        )
        self.passes = i > k
        #: by piece, the chart of motions on it alone
        self._own = np.flatnonzero(~self.passes)
        jumps = np.append(self._gains[:, 0], 0.0) != 0
        #: where the force jumps
        self.jumps = lines[jumps[:-1]]
        self.rooted = self.passes & np.stack((jumps[i - 1], jumps[k]))
        self.place = np.where(self.passes, np.stack((edges[i], edges[k + 1])), 0.0)
        with np.errstate(invalid="ignore"):
            lengths = np.stack((edges[i + 1] - edges[i], edges[k + 1] - edges[k]))
        self.low = np.where(self.passes, 0.0, np.stack((edges[i], -edges[k + 1])))
        self.high = np.where(self.passes, lengths, np.stack((edges[i + 1], -edges[k])))
        self.high[self.rooted] = np.sqrt(self.high[self.rooted])
        if lines.size > MOST_LINES or steps.highest >= MOST_POWERS:
            raise Refused(TOO_LARGE.format(lines.size, steps.highest, (MOST_LINES, MOST_POWERS - 1)))
        #: whether motions about the centre are there
        self.has_centre = steps.load == 0 and steps.odd
        self._packed = self._pack()

    def _pack(self) -> Floats:
        """What native/turning_points.h reads: sizes, and rows of the force, and of the charts."""
        steps, n = self.steps, self.steps.highest + 1
        bounded = (np.zeros(n), np.zeros(n), np.zeros(n), np.zeros(3))
        if math.isfinite(self._large):
            bounded = steps._last - steps._even, steps._even, steps._sizes, np.array(steps._deviations)
        rows = (self._at, self._gains, steps.pieces, *bounded, self.upper, self.lower, self.place, self.rooted)
        sizes = (self._at.size, steps.highest, self.passes.size, self._large)
        return np.concatenate([sizes, *(np.ravel(row) for row in rows)]).astype(float)

    def operands(self, low: Floats, high: Floats, chart: Ints, load: float | None = None) -> tuple[Any, ...]:
        """What compiled functions of boxes take first, (2, n) or more, within the limits of their charts.

        load -- what <f> is, if not the load; NaN where it is not known. The last operand is the force without its
        steps, where that is no polynomial.
        """
        rest = NOTHING if (curved := self.steps.curved) is None else curved.packed
        return self._packed, low.T, high.T, chart, self.steps.load if load is None else load, rest

    def on(self, low: Floats, high: Floats, chart: Ints) -> tuple[Local, Local]:
        """On boxes within the limits of their charts, (2, n), and in their middles."""
        rows = SOLVER.ends(*self.operands(low, high, chart, math.nan))
        return Local.of(rows[:, :28]), Local.of(rows[:, 28:])

    def on_piece(self, u: Floats, chart: Ints) -> Local:
        """Of all motions on one piece within intervals of u, (2, n), those at rest among them."""
        return self.on(np.stack((u[0], -u[1])), np.stack((u[1], -u[0])), chart)[0]

    def motion(self, x: Floats, y: Floats, chart: Ints) -> tuple[Floats, Floats]:
        """A and B at points."""
        past_x, past_y = (np.where(self.rooted[i, chart], one * one, one) for i, one in enumerate((x, y)))
        upper, lower = self.place[:, chart]
        return 0.5 * (upper - lower + (past_x + past_y)), 0.5 * (upper + lower + (past_x - past_y))

    def system(self, number: Any, chart: Ints) -> Ints:
        """The number of a system: a frequency, a forcing or an edge, by its number, in a chart."""
        return np.asarray(number * self.passes.size + chart)

    def of_system(self, of: Ints) -> tuple[Ints, Ints]:
        """The frequency, forcing or edge of a system, by its number, and its chart."""
        return np.divmod(of, self.passes.size)

    def on_edge(self, distance: Floats, of: Ints) -> tuple[Floats, Floats]:
        """A and B at points of edges."""
        edge, chart = self.of_system(of)
        x, y = np.where(edge == EDGES, 0.0, distance)
        return self.motion(x, y, chart)

    def about(self, edge: int) -> Ints:
        """Charts on whose edge motions reach the upper or the lower end of the piece about u = 0, which they are in."""
        lower, upper = self.steps.inner
        first, last = np.searchsorted(self._at, lower, side="right"), np.searchsorted(self._at, upper, side="left")
        one, other = (self.lower, self.upper) if edge else (self.upper, self.lower)
        found = (one == (first - 1 if edge else last + 1)) & (first <= other) & (other <= last)
        return np.flatnonzero(found)

    def inside(self, edge: int, distance: float, chart: int) -> tuple[int, float, float]:
        """The chart on the other side of the edge x = 0 or y = 0, of motions that are not past it; x and y there."""
        i, k = int(self.upper[chart]) - (edge == 0), int(self.lower[chart]) + (edge == 1)
        (other,) = np.flatnonzero((self.upper == i) & (self.lower == k)).tolist()
        if i == k:  # x and y are the ends there
            past = distance**2 if self.rooted[1 - edge, chart] else distance
            distance = past + float(self.place[1 - edge, chart]) * (1 if edge else -1)
        at = float(self.high[edge, other])
        return (other, distance, at) if edge else (other, at, distance)

    def stiffness(self, x: Interval, y: Interval, chart: Ints) -> Interval:
        """f' on all that motions may pass next to one place: -h/A is a mean of it; unknown where the force jumps there.

        They are of one piece, or of two, one step being passed by small motions.
        """
        passes, rooted = self.passes[chart], self.rooted[:, chart]
        past_x, past_y = (np.where(root, one.hi**2, one.hi) for root, one in zip(rooted, (x, y), strict=True))
        upper, lower = self.place[:, chart]
        u = np.stack((lower - past_y, upper + past_x))
        # of motions on one piece, those at rest among them
        here = self.on_piece(np.tile(u, 2), self._own[np.append(self.upper[chart], self.lower[chart])])
        low, high = (here.c_x - here.c_y).ends.reshape(2, 2, chart.size)
        hull = np.array((low.min(axis=0), high.max(axis=0)))
        known = ~rooted.any(axis=0) & (~passes | (self.upper[chart] == self.lower[chart] + 1))
        return Interval(np.where(known, hull, ALL))


def above_diagonal(low: Floats, high: Floats, passes: Flags) -> Floats:
    """The lower ends of boxes, and where motions pass no step, x = B + A and y = A - B, of the part with A >= 0."""
    return np.where(passes, low, np.minimum(np.maximum(low, -high[::-1]), high))
