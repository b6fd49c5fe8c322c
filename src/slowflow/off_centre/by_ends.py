"""States and folds by the motion's ends, as `boxes` takes them: in go charts and a forcing, out come equations.

EndedState  f_0 = F = 0                  in x and y, at frequencies and a forcing
EndedFold   f_0 = F = 0, F stationary    in x, y and R, at forcings; Omega follows
EndedEdge   f_0 = 0                      in x or y, of motions that just come to the edge of a chart

A system is a frequency, or a forcing, in one chart: its number is that of the first times the charts, and the chart's.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from slowflow.intervals import Interval
from slowflow.model import Floats
from slowflow.off_centre.boxes import Ints, interval_of
from slowflow.off_centre.ends import Charts, Local
from slowflow.off_centre.flow import Flow, Slow
from slowflow.off_centre.means import ALL
from slowflow_kernels import off_centre, off_centre_intervals

#: x or y next to an edge of its chart
NEAR = 2.0**-8


def _square(rows: Any, d: int) -> tuple[Any, Any]:
    """Values and slopes from a kernel's outputs."""
    values, slopes = rows[:d], rows[d:]
    return values, [slopes[d * i : d * (i + 1)] for i in range(d)]


def ends_of(rows: Any, d: int, n: int) -> tuple[Floats, Floats]:
    """Values (2, d, n) and slopes (d, d, 2, n) from a kernel's outputs on intervals."""
    values, slopes = _square(
        [row.ends + np.zeros((2, n)) if isinstance(row, Interval) else np.full((2, n), row) for row in rows], d
    )
    return np.stack(values, axis=1), np.stack([np.stack(row, axis=1) for row in slopes], axis=1)


def numbers_of(rows: Any, d: int, n: int) -> tuple[Floats, Floats]:
    """Values (d, n) and slopes (d, d, n) from a kernel's outputs."""
    values, slopes = _square([row + np.zeros(n) for row in rows], d)
    return np.stack(values), np.stack([np.stack(row) for row in slopes])


class ByEnds:
    """What both share.

    given -- the frequencies or the forcings
    """

    unknowns = 2

    def __init__(self, charts: Charts, flow: Flow, given: Floats) -> None:
        self.charts, self.flow, self.given = charts, flow, given

    def chart(self, of: Ints) -> Ints:
        """Of a system."""
        return np.asarray(of % self.charts.passes.size)

    def number(self, of: Ints) -> Ints:
        """Of a system's frequency or forcing."""
        return np.asarray(of // self.charts.passes.size)

    def limits(self, of: Ints) -> tuple[Any, Any]:
        """See `boxes.Equations`."""
        chart = self.chart(of)
        free = np.full((self.unknowns - 2, of.size), np.inf)
        return np.concatenate((self.charts.low[:, chart], -free)), np.concatenate((self.charts.high[:, chart], free))

    def at(self, x: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`; the middles of what is known of points."""
        values, slopes, *_ = self.on(x, np.zeros_like(x), of)
        return 0.5 * (values[0] + values[1])[: self.unknowns], 0.5 * (slopes[0] + slopes[1])

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, ...]:
        """See `boxes.Equations`."""
        raise NotImplementedError

    def by_motion(self, z: Floats, of: Ints) -> tuple[Floats, Floats]:
        """As `at`, by A and B in the place of x and y."""
        raise NotImplementedError

    def refined(self, z: Floats, x: Floats, of: Ints) -> Floats:
        """Solutions by A and B, to their last digits; not next to an edge, where x and y have more of these."""
        near = (self.charts.rooted[:, self.chart(of)] & (x[:2] < NEAR)).any(axis=0)
        with np.errstate(all="ignore"):
            for _ in range(3):
                values, slopes = self.by_motion(z, of)
                known = ~near & np.isfinite(slopes).all(axis=(0, 1))
                J = np.where(known, slopes, np.eye(len(z))[..., np.newaxis]).transpose(2, 0, 1)
                change = np.linalg.solve(J, values.T[..., np.newaxis])[..., 0].T
                size = np.maximum(np.abs(z), np.abs(z[:1]))
                z = np.where(known & (np.abs(change) < 2.0**-30 * size).all(axis=0), z - change, z)
        return z

    @property
    def _load(self) -> Interval:
        return Interval.point(self.charts.steps.load)


def _of_motions(values: Floats, slopes: Floats, here: Local, r: Floats) -> tuple[Floats, Floats]:
    """Values and slopes, with no zero in boxes without any motion: those beyond A = 0."""
    values[:, 0, (here.A.hi <= 0) & (r > 0).all(axis=0)] = 1.0
    return values, slopes


class EndedState(ByEnds):
    """At frequencies and one forcing."""

    def __init__(self, charts: Charts, flow: Flow, Omega: Floats, F_0: float) -> None:
        super().__init__(charts, flow, Omega)
        self.F_0, self.force = F_0, flow.force(F_0, Omega)

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, ...]:
        """See `boxes.Equations`."""
        here = self.charts.on(interval_of(x[0], r[0]), interval_of(x[1], r[1]), self.chart(of))
        Omega, force = (Interval.point(one[self.number(of)]) for one in (self.given, self.force))
        known = force, *self.flow.balances(Omega, here.A), self._load
        of_means = here.c_0, here.s_0, here.c_x, here.c_y, here.X, here.Y
        found = off_centre_intervals.ended_state(Omega, here.A, *known, *of_means)
        return _of_motions(*ends_of(found, 2, of.size), here, r)

    def by_motion(self, z: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `ByEnds`."""
        slow = Slow(self.charts.steps, self.flow, self.F_0)
        return numbers_of(slow.state(self.given[self.number(of)], z), 2, of.size)


class EndedFold(ByEnds):
    """At forcings; of an odd force without a load those off the centre, as motions about it have solvers of their own.

    Where these lose their stability others begin, and all equations vanish: there is no fold of the others there.
    """

    unknowns = 3

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, ...]:
        """See `boxes.Equations`."""
        xy = [interval_of(*pair) for pair in zip(x, r, strict=True)]
        here = self.charts.on(xy[0], xy[1], self.chart(of))
        forcing = [Interval.point(one) for one in self.flow.forcing(self.given[self.number(of)])]
        known = [Interval.point(one) for one in self._damping]
        of_means = (here.c_0, here.s_0, here.c_x, here.c_y, here.c_xx, here.c_yy, here.X, here.Y, here.X_x, here.Y_y)
        given = (xy[2], here.A, *forcing, *known, self._load, *of_means)
        found = off_centre_intervals.ended_fold(*given)
        holds = np.stack((np.full_like(x, -np.inf), np.full_like(x, np.inf)))
        # R (h - A h_A) = G^2 + I (A I_A - I)
        along = resists(here)[0]
        if self.charts.has_centre:
            about, single, beside = beside_centre(here)
            along = along.where(single, beside)
        intercept = (here.A * along - here.s_0) * 4.0
        square = Interval(np.maximum((xy[2] + here.s_0 * 2.0).ends, 0.0))
        of_speed = square * here.A
        force, speed = forcing[0] + forcing[1] * (square / here.A), of_speed.sqrt()
        moves = here.A * self.flow.eta + speed * (2 * self.flow.zeta) + of_speed * self.flow.d + self.flow.m
        by_line = (force.square() + moves * (of_speed * self.flow.d - self.flow.m)) / intercept
        most = (force.square() - moves.square()).sqrt().hi
        holds[0, 2], holds[1, 2] = np.fmax(by_line.lo, -most), np.fmin(by_line.hi, most)
        values, slopes = _of_motions(*ends_of(found, 3, of.size), here, r)
        if self.charts.has_centre:
            values[:, 0, about & single] = 1.0
        return values, slopes, holds

    def by_motion(self, z: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `ByEnds`."""
        means = self.charts.steps.at(z[0], z[1], 2)
        known = *self.flow.forcing(self.given[self.number(of)]), *self._damping, self.charts.steps.load
        return numbers_of(off_centre.fold(z[2], z[0], *known, *means.c, *means.s), 3, of.size)

    @property
    def _damping(self) -> tuple[float, ...]:
        return self.flow.m, self.flow.eta, self.flow.zeta, self.flow.d


class Resting:
    """Where the mass stands when nothing moves it."""

    def __init__(self, charts: Charts) -> None:
        self.charts, self.steps = charts, charts.steps

    def limits(self, of: Ints) -> tuple[Any, Any]:
        """See `boxes.Equations`."""
        return -np.inf, np.inf

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`: on each piece of the force of all motions in a box, those at rest among them."""
        u, nowhere = interval_of(x[0], r[0]), np.array([[np.inf], [-np.inf]])
        f, slope = (np.tile(nowhere, (1, of.size)) for _ in range(2))
        for chart in np.flatnonzero(~self.charts.passes):
            part = np.stack((np.maximum(u.lo, self.charts.low[0, chart]), np.minimum(u.hi, self.charts.high[0, chart])))
            some = np.flatnonzero(part[0] <= part[1])
            here = self.charts.on(Interval(part[:, some]), -Interval(part[:, some]), np.full(some.size, chart))
            for whole, one in ((f, here.c_0), (slope, here.c_x - here.c_y)):
                whole[:, some] = np.minimum(whole[0, some], one.lo), np.maximum(whole[1, some], one.hi)
        for jump in self.charts.jumps.tolist():
            slope[:, (u.lo <= jump) & (jump <= u.hi)] = ALL
        return (Interval(f) - self.steps.load).ends[:, np.newaxis], slope[:, np.newaxis, np.newaxis]

    def at(self, x: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        means = self.steps.at(np.zeros(of.size), x[0], 1)
        return (means.c[0] - self.steps.load)[np.newaxis], means.c[1][np.newaxis, np.newaxis]


class EndedEdge:
    """On one edge of charts, which is a system: x = 0, or y = 0.

    edge -- 0 for x = 0, 1 for y = 0
    """

    def __init__(self, charts: Charts, edge: int) -> None:
        self.charts, self.edge = charts, edge

    def limits(self, of: Ints) -> tuple[Any, Any]:
        """See `boxes.Equations`."""
        along = 1 - self.edge
        return self.charts.low[along, of][np.newaxis], self.charts.high[along, of][np.newaxis]

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, ...]:
        """See `boxes.Equations`."""
        none, along = Interval(np.zeros((2, of.size))), interval_of(x[0], r[0])
        x_, y_ = (along, none) if self.edge else (none, along)
        here = self.charts.on(x_, y_, of)
        slope = here.c_x if self.edge else here.c_y
        return (here.c_0 - self.charts.steps.load).ends[:, np.newaxis], slope.ends[:, np.newaxis, np.newaxis]

    def at(self, x: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        values, slopes = self.on(x, np.zeros_like(x), of)
        return 0.5 * (values[0] + values[1]), 0.5 * (slopes[0] + slopes[1])


def along_balance(charts: Charts, here: Local) -> tuple[Interval, Interval]:
    """`resists` and A's slope; of an odd force without a load next to where motions leave the centre, of both kinds."""
    found, A_t = resists(here)
    if charts.has_centre:
        _, single, beside = beside_centre(here)
        c_1 = _stiffness(here) * 0.5
        hull = np.array((np.minimum(beside.lo, c_1.lo), np.maximum(beside.hi, c_1.hi)))
        found = found.where(single, Interval(np.where(np.isfinite(hull).all(axis=0), hull, ALL)))
    return found, A_t


def beside_centre(here: Local) -> tuple[Any, Any, Interval]:
    """Which boxes touch B = 0, in which c_1 has a sign, and `resists` of motions off the centre in the others.

    Of an odd force without a load. Where f_0/B vanishes, c_1 between 0 and B has no sign: where it has one next to the
    centre, no motion is off it.
    """
    touches = (here.B.lo <= 0) & (here.B.hi >= 0)
    single = ~touches | _stiffness(here).has_sign
    beside = off_centre_intervals.beside(here.B, here.c_3, here.s_2) * 0.5
    return touches, single, Interval(np.where(here.c_3.has_sign, beside.ends, ALL))


def _stiffness(here: Local) -> Interval:
    """c_1"""
    return (here.c_x / here.X - here.c_y / here.Y) * 0.5


def resists(here: Local) -> tuple[Interval, Interval]:
    """(c_1^2 - s_1^2)/(2 c_1) on boxes, as h_A = 2 s_0/A - 4 of it along the balance; and A's slope, of c_1's sign.

    With p = c_x and q = -c_y it is p q/(X q + Y p), which rises with p and with q as long as c_1 has a sign.
    """
    A_t, _ = off_centre_intervals.ended_along(here.A, here.s_0, here.c_x, here.c_y, here.X, here.Y)
    found = []
    for outwards, p, q in ((-1.0, here.c_x.lo, here.c_y.hi), (1.0, here.c_x.hi, here.c_y.lo)):
        X = np.where((p < 0) == (outwards < 0), here.X.lo, here.X.hi)
        Y = np.where((q > 0) == (outwards < 0), here.Y.lo, here.Y.hi)
        slope, gain = off_centre.ended_along(1.0, 0.0, p, q, X, Y)
        value = -gain / slope
        found.append(value + outwards * 2.0**-48 * np.abs(value))
    known = A_t.has_sign & np.isfinite(found).all(axis=0)
    return Interval(np.where(known, np.stack(found), ALL)), A_t
