"""States and folds by the motion's ends, as `boxes` takes them. Takes charts and a forcing; returns equations.

EndedState  f_0 = F = 0                  in x and y, at frequencies and a forcing
EndedFold   f_0 = F = 0, F stationary    in x, y and R, at forcings; Omega follows
EndedEdge   f_0 = 0                      in x or y, of motions that just come to the edge of a chart

A system is a frequency, a forcing or an edge in one chart (`Charts.system`).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from slowflow.backend import SOLVER
from slowflow.intervals import ALL, Interval
from slowflow.mechanism import Ints
from slowflow.model import Floats
from slowflow.off_centre.boxes import Equations
from slowflow.off_centre.flow import Flow, Slow
from slowflow.off_centre.turning_points import EDGES, Charts
from slowflow_kernels import off_centre

#: x or y next to an edge of its chart
NEAR = 2.0**-8
#: what is known of one unknown in a row of `boxes.Equations.on`
AT, ON, SLOPE = slice(0, 2), slice(6, 8), slice(12, 14)


def numbers_of(rows: Any, d: int, n: int) -> tuple[Floats, Floats]:
    """Values (d, n) and slopes (d, d, n) from a kernel's outputs."""
    found = np.array([row + np.zeros(n) for row in rows])
    return found[:d], found[d:].reshape(d, d, n)


class ByEnds(Equations):
    """What both share.

    values -- the frequencies or the forcings
    """

    unknowns = 2

    def __init__(self, charts: Charts, flow: Flow, values: Floats) -> None:
        self.charts, self.flow, self.values = charts, flow, values

    def chart(self, of: Ints) -> Ints:
        """Of a system."""
        return self.charts.of_system(of)[1]

    def number(self, of: Ints) -> Ints:
        """Of a system's frequency or forcing."""
        return self.charts.of_system(of)[0]

    def limits(self, of: Ints) -> tuple[Any, Any]:
        """See `boxes.Equations`."""
        chart = self.chart(of)
        free = np.full((self.unknowns - 2, of.size), np.inf)
        return np.concatenate((self.charts.low[:, chart], -free)), np.concatenate((self.charts.high[:, chart], free))

    def boxes(self, low: Floats, high: Floats, of: Ints) -> tuple[Any, ...]:
        """What a compiled function takes of boxes."""
        return self.charts.operands(low, high, self.chart(of), self.charts.steps.load)

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


class EndedState(ByEnds):
    """At frequencies and one forcing."""

    def __init__(self, charts: Charts, flow: Flow, Omega: Floats, F_0: float) -> None:
        super().__init__(charts, flow, Omega)
        self.F_0, self.force = F_0, flow.force(F_0, Omega)

    def on(self, low: Floats, high: Floats, of: Ints) -> Floats:
        """See `boxes.Equations`."""
        known = (*(each[self.number(of)] for each in (self.values, self.force)), self.flow.damping)
        return np.asarray(SOLVER.ended_state(*self.boxes(low, high, of), *known))

    def by_motion(self, z: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `ByEnds`."""
        slow = Slow(self.charts.steps, self.flow, self.F_0)
        return numbers_of(slow.state(self.values[self.number(of)], z), 2, of.size)


class EndedFold(ByEnds):
    """At forcings; of an odd force without a load those off the centre, as motions about it have solvers of their own.

    Where these lose their stability others begin, and all equations vanish: there is no fold of the others there.
    """

    unknowns = 3

    def on(self, low: Floats, high: Floats, of: Ints) -> Floats:
        """See `boxes.Equations`."""
        known = *self.flow.forcing(self.values[self.number(of)]), self.flow.damping, self.charts.has_centre
        return np.asarray(SOLVER.ended_fold(*self.boxes(low, high, of), *known))

    def by_motion(self, z: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `ByEnds`."""
        means = self.charts.steps.at(z[0], z[1], 2)
        m, zeta, eta, d = self.flow.damping
        known = *self.flow.forcing(self.values[self.number(of)]), m, eta, zeta, d, self.charts.steps.load
        return numbers_of(off_centre.fold(z[2], z[0], *known, *means.c, *means.s), 3, of.size)


class Resting(Equations):
    """Where the mass stands when nothing moves it."""

    def __init__(self, charts: Charts) -> None:
        self.charts, self.steps = charts, charts.steps

    def limits(self, of: Ints) -> tuple[Any, Any]:
        """See `boxes.Equations`."""
        return -np.inf, np.inf

    def on(self, low: Floats, high: Floats, of: Ints) -> Floats:
        """See `boxes.Equations`: on each piece of the force of all motions in a box, those at rest among them."""
        x, n = 0.5 * (low + high), of.size
        u, nowhere = np.stack((np.append(low, x), np.append(high, x))), np.array([[np.inf], [-np.inf]])
        f, slope = (np.tile(nowhere, (1, 2 * n)) for _ in range(2))
        for chart in np.flatnonzero(~self.charts.passes):
            part = np.stack((np.maximum(u[0], self.charts.low[0, chart]), np.minimum(u[1], self.charts.high[0, chart])))
            some = np.flatnonzero(part[0] <= part[1])
            here = self.charts.on_piece(part[:, some], np.full(some.size, chart))
            for whole, one in ((f, here.c_0), (slope, here.c_x - here.c_y)):
                whole[:, some] = np.minimum(whole[0, some], one.lo), np.maximum(whole[1, some], one.hi)
        for jump in self.charts.jumps.tolist():
            slope[:, (u[0] <= jump) & (jump <= u[1])] = ALL
        values, rows = (Interval(f) - self.steps.load).ends, np.tile([-np.inf, np.inf], (n, 18))
        rows[:, AT], rows[:, ON], rows[:, SLOPE] = values[:, n:].T, values[:, :n].T, slope[:, :n].T
        return rows


class EndedEdge(Equations):
    """On an edge, x = 0 or y = 0, of a chart."""

    def __init__(self, charts: Charts) -> None:
        self.charts = charts

    def limits(self, of: Ints) -> tuple[Any, Any]:
        """See `boxes.Equations`."""
        edge, chart = self.charts.of_system(of)
        return self.charts.low[1 - edge, chart][np.newaxis], self.charts.high[1 - edge, chart][np.newaxis]

    def on(self, low: Floats, high: Floats, of: Ints) -> Floats:
        """See `boxes.Equations`."""
        edge, chart = self.charts.of_system(of)
        low, high = (np.where(edge == EDGES, 0.0, one) for one in (low, high))
        return np.asarray(SOLVER.ended_edge(*self.charts.operands(low, high, chart, self.charts.steps.load), edge))
