"""What vanishes at rest, as `boxes` takes it: in go charts of a force, out come equations.

Resting    f_0 = 0    in u, at A = 0
"""

from __future__ import annotations

from typing import Any

import numpy as np

from slowflow.intervals import Interval
from slowflow.model import Floats
from slowflow.off_centre.boxes import Ints, interval_of
from slowflow.off_centre.ends import Charts
from slowflow.off_centre.means import ALL


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
