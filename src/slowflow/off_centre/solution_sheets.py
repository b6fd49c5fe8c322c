"""The balance of the mean as boxes that hold all of it. Takes a force as steps; returns cells of its sheets.

Where the mean is balanced is asked by every question alike, whatever the forcing and the frequency: so it is looked for
once for an oscillator. Charts of the plane of a motion's ends (`turning_points`) are cut into boxes, and each is made
smaller as far as f_0 = 0 leaves it; those without are left. What is known on a cell tells at once whether it may hold a
state, a fold or a peak: `Sheets.states` and `Sheets.folds` are the boxes that may, from which `boxes.solve` goes on.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from slowflow.core.backend import SOLVER
from slowflow.core.intervals import Interval
from slowflow.core.mechanism import Flags, Ints
from slowflow.core.model import Floats
from slowflow.off_centre.boxes import MOST_BOXES, TOO_MANY
from slowflow.off_centre.by_turning_points import solve_edges
from slowflow.off_centre.flow import Flow
from slowflow.off_centre.means import Steps
from slowflow.off_centre.turning_points import Charts, above_diagonal
from slowflow.support.errors import NotSettled, OutOfRange
from slowflow.support.text import Sentence

#: octaves of the ends' distance from a chart's edge that are cut apart at first, by twos, and parts between two edges
BELOW, DIVISIONS = 5, 4
#: how small cells are beside their amplitude, which amplitude is small beside the problem, rounds of cuts
FINE, SMALL, ROUNDS = 2.0**-4, 2.0**-8, 16
#: boxes that are enclosed at once: few enough for what is known of them to stay in the processor's caches
TOGETHER = 4096
#: of R, by rows
SIGNS = np.array([[-1.0], [1.0]])
#: amplitudes beyond it are not followed, as their squares are beyond the range of doubles
FARTHEST = 2.0**500
TOO_FAR = Sentence("offset motions are unresolved: amplitudes may be as large as {A:.3g}, beyond the range of doubles")
UNKNOWN = "folds are unresolved: their frequencies are unbounded at turning points of the mean"


@dataclass(frozen=True, eq=False)
class Cells:
    """Boxes that hold the balance, one column each.

    chart     -- the chart of each
    low, high -- the ends of x and y
    A, B, p, e -- intervals on each: p = -h/A, e = -h_A - p along the balance
    rising    -- what the mean stiffness c_1 may be: an interval of its sign
    """

    chart: Ints
    rows: Floats

    low = property(lambda self: self.rows[0:2])
    high = property(lambda self: self.rows[2:4])
    p = property(lambda self: Interval(self.rows[4:6]))
    e = property(lambda self: Interval(self.rows[6:8]))
    rising = property(lambda self: Interval(self.rows[8:10]))
    A = property(lambda self: Interval(self.rows[10:12]))
    B = property(lambda self: Interval(self.rows[12:14]))

    @classmethod
    def joined(cls, chunks: Sequence[Cells]) -> Cells:
        """All of some."""
        return cls(*(np.concatenate([getattr(one, name) for one in chunks], axis=-1) for name in ("chart", "rows")))

    def take(self, which: Any) -> Cells:
        """Some of them."""
        return Cells(self.chart[which], self.rows[:, which])


class Corner(NamedTuple):
    """Where the balance just comes to a jump of the force; the last three for motions that do not pass it, and that do.

    A, B, s_0 -- there
    e         -- -h_A - p along the balance
    stiff     -- whether the mean stiffness is positive
    rises     -- whether A rises away from the corner
    """

    A: float
    B: float
    s_0: float
    e: tuple[float, float]
    stiff: tuple[bool, bool]
    rises: tuple[bool, bool]


class Sheets:
    """The balance of one force, up to amplitudes that are asked for.

    offset_bound -- what |B| does not exceed for amplitudes up to one
    """

    def __init__(self, steps: Steps, offset_bound: Callable[[float], float]) -> None:
        self.steps, self.charts, self._offset_bound = steps, Charts(steps), offset_bound
        self._size = steps.size
        self._known: dict[int, Cells] = {}
        self._corners: dict[int, tuple[list[Corner], Floats]] = {}

    def cells(self, A_max: float, may: Callable[[Cells], Flags] | None = None) -> Cells:
        """All of the balance up to an amplitude, and somewhat beyond, in large cells.

        may -- of cells, whether a question may have an answer there: those without are left, others are cut until small

        Raises ArithmeticError for too many boxes, and in a dead zone.
        """
        octave, done = self._octave(A_max), []
        if (cells := self._known.get(octave)) is None:
            # those of a larger amplitude hold these too, but a search must not look at more for an earlier question
            if (larger := min((one for one in self._known if one > octave), default=None)) is not None:
                cells = self._known[larger].take(self._known[larger].A.lo <= 2.0**octave)
            else:
                self.steps.check_balanced()
                with np.errstate(all="ignore"):
                    cells = self.looked_at(*self._first(2.0**octave), 2.0**octave)
            self._known[octave] = cells
        if may is None:
            return cells
        with np.errstate(all="ignore"):
            for number in range(ROUNDS):
                if cells.chart.size > MOST_BOXES:
                    raise NotSettled(TOO_MANY)
                cells = cells.take(may(cells))
                fine = (self._wide(cells.low, cells.high, cells.chart).max(axis=0) <= FINE * cells.A.hi) | (
                    cells.A.hi <= SMALL * self._size
                )
                fine |= number == ROUNDS - 1
                done.append(cells.take(fine))
                if fine.all():
                    break
                cells = self.cut(cells.take(~fine), 2.0**octave)
            return Cells.joined(done)

    def cut(self, cells: Cells, A_max: float = math.inf, most: float = math.inf) -> Cells:
        """Each in four, less what the balance leaves out, up to an amplitude.

        most -- of what is left: beyond it the search has failed, and the remaining boxes are not looked at
        """
        low, high, chart = cells.low, cells.high, cells.chart
        for _ in range(2):
            (low, high), chart = halved(low, high, self._wide(low, high, chart)), np.tile(chart, 2)
        found, count = [], 0
        for start in range(0, max(chart.size, 1), TOGETHER):
            some = slice(start, start + TOGETHER)
            found.append(self.looked_at(low[:, some], high[:, some], chart[some], A_max))
            count += found[-1].chart.size
            if count > most:
                break
        return Cells.joined(found)

    def middles(self, cells: Cells) -> Floats:
        """A and B of a motion in each, (2, n)."""
        x, y = 0.5 * (cells.low + cells.high)
        return np.stack(self.charts.motion(x, y, cells.chart))

    def _wide(self, low: Floats, high: Floats, chart: Ints) -> Floats:
        """By how much either end of the motion changes over boxes."""
        return np.asarray((high - low) * np.where(self.charts.rooted[:, chart], 2 * high, 1.0))

    def _octave(self, A_max: float) -> int:
        """The least that holds an amplitude.

        Raises OverflowError for an amplitude that is not known to be below `FARTHEST`.
        """
        if not A_max < FARTHEST:
            raise OutOfRange(TOO_FAR.format(A_max))
        return math.ceil(math.log2(A_max))

    def corners(self, A_max: float) -> tuple[list[Corner], Floats]:
        """All corners, and A and B next to which there may be others, (2, k)."""
        cells, octave = self.cells(A_max), self._octave(A_max)
        if octave not in self._corners:
            charts = self.charts
            edge, some = np.nonzero(charts.rooted[:, cells.chart] & (cells.low == 0))
            low, high = (ends[1 - edge, some] for ends in (cells.low, cells.high))
            solved = solve_edges(charts, low, high, charts.system(edge, cells.chart[some]))
            of = (numbers.tolist() for numbers in charts.of_system(solved.of))
            found = [self._corner(*at) for at in zip(*of, solved.x[0].tolist(), strict=True)]
            self._corners[octave] = found, np.stack(charts.on_edge(solved.undecided[0], solved.undecided_of))
        return self._corners[octave]

    def _corner(self, edge: int, chart: int, distance: float) -> Corner:
        other, *inside = self.charts.inside(edge, distance, chart)
        positions = np.array((inside, (0.0, distance) if edge == 0 else (distance, 0.0))).T
        with np.errstate(all="ignore"):
            charts = np.array((other, chart))
            here, _ = self.charts.on(positions, positions, charts)
            rows = SOLVER.on_balance(*self.charts.operands(positions, positions, charts), False)
            bent, A_t = Interval(rows[:, 6:8].T), Interval(rows[:, 8:10].T)
            e = (bent - here.s_0 / here.A) * 4.0
            # without ends, what is not known, they add to NaN
            A_t, e, A, B, s_0 = (one.ends.sum(axis=0) for one in (A_t, e, here.A, here.B, here.s_0))
        # the balance goes as (-c_y, c_x), away from the corner as x or y falls before it and rises past it
        ahead = (here.c_x if edge else -here.c_y).ends.sum(axis=0) * np.array((-1.0, 1.0))
        stiff, rises = (A_t > 0).tolist(), (A_t * ahead > 0).tolist()
        return Corner(0.5 * A[1], 0.5 * B[1], 0.5 * s_0[1], tuple((0.5 * e).tolist()), tuple(stiff), tuple(rises))

    def looked_at(self, low: Floats, high: Floats, chart: Ints, A_max: float = math.inf) -> Cells:
        """What the balance leaves of boxes that may hold it, up to an amplitude."""
        charts = self.charts
        low = above_diagonal(low, high, charts.passes[chart])
        rows = SOLVER.on_balance(*charts.operands(low, high, chart), charts.has_centre)
        left = np.flatnonzero((rows[:, 14] != 0) & (rows[:, 10] <= A_max))
        found = Cells(chart[left], rows[left].T)
        small = np.flatnonzero(found.A.lo <= np.where(charts.passes[found.chart], 0.0, SMALL * self._size))
        if small.size:
            x, y = (Interval(np.array((low[i], high[i]))[:, left[small]]) for i in (0, 1))
            found.p.ends[:, small] = found.p.take(small).both(charts.stiffness(x, y, found.chart[small])).ends
        found.e.ends[:] = (found.e * 4.0 - found.p * 2.0).ends
        return found

    def _first(self, A_max: float) -> tuple[Floats, Floats, Ints]:
        """Boxes of all charts: motions up to an amplitude."""
        charts, bound = self.charts, A_max + self._offset_bound(A_max)
        if not bound < FARTHEST:
            raise OutOfRange(TOO_FAR.format(bound))
        octaves = self._size * 0.5 ** np.arange(BELOW, -math.ceil(math.log2(bound / self._size)) - 2, -2)
        both, from_step = np.concatenate((-octaves[::-1], [0.0], octaves)), np.concatenate(([0.0], np.sqrt(octaves)))

        @cache
        def edges(low: float, high: float, rooted: bool) -> Floats:
            if math.isfinite(low) and math.isfinite(high):
                return np.linspace(low, high, DIVISIONS + 1)
            return from_step if rooted else np.unique(np.clip(both, low, high))

        boxes, number = [np.empty((4, 0))], [np.empty(0, dtype=np.intp)]
        for chart, axes in enumerate(np.stack((charts.low, charts.high, charts.rooted)).T.tolist()):
            x, y = (edges(*axis) for axis in axes)
            if x.size * y.size > MOST_BOXES:  # an amplitude of hundreds of octaves
                raise NotSettled(TOO_MANY)
            ends = np.broadcast_arrays(x[:-1, np.newaxis], y[:-1], x[1:, np.newaxis], y[1:])
            box = np.stack(ends).reshape(4, -1)
            boxes.append(box if charts.passes[chart] else box[:, box[2] + box[3] > 0])
            number.append(np.full(boxes[-1].shape[1], chart))
        low, high = np.split(np.concatenate(boxes, axis=1), 2)
        return low, high, np.concatenate(number)

    def folds(self, A_max: float, F_0: Floats, flow: Flow) -> tuple[Floats, Floats, Ints]:
        """Boxes of x, y and R in which folds may be, and of which system each is (`by_turning_points`).

        Cells on which R has no bound are cut further.
        """
        at = F_0[:, np.newaxis, np.newaxis]

        def between(cells: Cells) -> tuple[Floats, Flags]:
            """By forcing, sign of R and cell."""
            return flow.folds_between(cells.A, cells.p, cells.e, SIGNS, at, at)

        cells = self.cells(A_max, lambda cells: np.asarray(between(cells)[1].any(axis=(0, 1))))
        with np.errstate(all="ignore"):
            for _ in range(ROUNDS):
                R, may = between(cells)
                unbounded = (may & ~np.isfinite(R).all(axis=0)).any(axis=(0, 1))
                if not unbounded.any():
                    break
                cells = Cells.joined([cells.take(~unbounded), self.cut(cells.take(unbounded))])
            else:
                raise NotSettled(UNKNOWN)
        number, sign, cell = np.nonzero(may)
        R = R[:, number, sign, cell]
        R = np.where(SIGNS[sign, 0] > 0, R, -R[::-1])
        low, high = (np.concatenate((ends[:, cell], R[k : k + 1])) for k, ends in enumerate((cells.low, cells.high)))
        return low, high, self.charts.system(number, cells.chart[cell])

    def states(self, A_max: float, Omega: Floats, F_0: float, flow: Flow) -> tuple[Floats, Floats, Ints]:
        """Boxes of x and y in which states may be, and of which system each is."""
        at = Omega[:, np.newaxis], flow.force(F_0, Omega)[:, np.newaxis], flow.damping

        def may(cells: Cells) -> Flags:
            """By frequency and cell."""
            return np.asarray(SOLVER.may_be_state(cells.A.ends.T, cells.p.ends.T, *at) != 0)

        cells = self.cells(A_max, lambda cells: np.asarray(may(cells).any(axis=0)))
        with np.errstate(all="ignore"):
            number, cell = np.nonzero(may(cells))
        return cells.low[:, cell], cells.high[:, cell], self.charts.system(number, cells.chart[cell])


def halved(low: Floats, high: Floats, wide: Floats) -> tuple[Floats, Floats]:
    """Each box in two, across its wider side."""
    across = (wide[1] > wide[0]).astype(int)
    n, middle, upper, lower = np.arange(across.size), 0.5 * (low + high), high.copy(), low.copy()
    upper[across, n] = lower[across, n] = middle[across, n]
    return np.concatenate((low, lower), axis=1), np.concatenate((upper, high), axis=1)
