"""What vanishes by the motion's ends, as `boxes` solves it. Takes charts and a forcing; returns functions of boxes.

states   f_0 = F = 0                  in x and y, at frequencies and a forcing
folds    f_0 = F = 0, F stationary    in x, y and R, at forcings; Omega follows
on_edges f_0 = 0                      in x or y, of motions that just come to the edge of a chart
at_rest  f = load                     in u, where the mass stands when nothing moves it

A system is a frequency, a forcing or an edge in one chart (`Charts.system`).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from slowflow.core.backend import SOLVER
from slowflow.core.intervals import ALL, Interval
from slowflow.core.mechanism import Flags, Ints
from slowflow.core.model import Floats
from slowflow.off_centre.boxes import OnBoxes, Solutions, solve
from slowflow.off_centre.flow import Flow, Slow
from slowflow.off_centre.turning_points import EDGES, Charts

#: what is known of one unknown in a row of `OnBoxes`
AT, ON, SLOPE = slice(0, 2), slice(6, 8), slice(12, 14)
#: a kernel's values and slopes by A and B, and R of a fold, from these and the numbers of frequencies or forcings
ByMotion = Callable[[Floats, Ints], Any]
Equations = tuple[OnBoxes, ByMotion]


def states(charts: Charts, flow: Flow, Omega: Floats, F_0: float) -> Equations:
    """At frequencies and one forcing."""
    force, slow = flow.force(F_0, Omega), Slow(charts.steps, flow, F_0)

    def on(low: Floats, high: Floats, of: Ints) -> Floats:
        number, chart = charts.of_system(of)
        known = Omega[number], force[number], flow.damping
        return np.asarray(SOLVER.ended_state(*charts.operands(low, high, chart), *known))

    return on, lambda z, number: slow.state(Omega[number], z)


def folds(charts: Charts, flow: Flow, F_0: Floats) -> Equations:
    """At forcings; of an odd force without a load those off the centre, as motions about it have solvers of their own.

    Where these lose their stability others begin, and all equations vanish: there is no fold of the others there.
    """

    def on(low: Floats, high: Floats, of: Ints) -> Floats:
        number, chart = charts.of_system(of)
        known = *flow.forcing(F_0[number]), flow.damping, charts.has_centre
        return np.asarray(SOLVER.ended_fold(*charts.operands(low, high, chart), *known))

    return on, lambda z, number: Slow(charts.steps, flow, F_0[number]).fold(z)


def refined(by_motion: ByMotion, z: Floats, number: Ints, kept: Flags) -> Floats:
    """Solutions by A and B, and R, to their last digits, a step of Newton's method on; some are kept as they are."""
    d = len(z)
    with np.errstate(all="ignore"):
        values, slopes = np.split(np.array([row + np.zeros(number.size) for row in by_motion(z, number)]), [d])
        slopes = slopes.reshape(d, d, -1)
        known = ~kept & np.isfinite(slopes).all(axis=(0, 1))
        J = np.where(known, slopes, np.eye(d)[..., np.newaxis]).transpose(2, 0, 1)
        change = np.linalg.solve(J, values.T[..., np.newaxis])[..., 0].T
        size = np.maximum(np.abs(z), np.abs(z[:1]))
        return np.where(known & (np.abs(change) < 2.0**-30 * size).all(axis=0), z - change, z)


def on_edges(charts: Charts, low: Floats, high: Floats, of: Ints) -> Floats:
    """On an edge, x = 0 or y = 0, of a chart."""
    edge, chart = charts.of_system(of)
    low, high = (np.where(edge == EDGES, 0.0, one) for one in (low, high))
    return np.asarray(SOLVER.ended_edge(*charts.operands(low, high, chart), edge))


def solve_edges(charts: Charts, low: Floats, high: Floats, of: Ints) -> Solutions:
    """Where the mean is balanced on edges, between distances from their corners, each of shape (n,)."""
    edge, chart = charts.of_system(of)
    limits = charts.low[1 - edge, chart], charts.high[1 - edge, chart]
    return solve(partial(on_edges, charts), low[np.newaxis], high[np.newaxis], of, limits)


def at_rest(charts: Charts, low: Floats, high: Floats, of: Ints) -> Floats:
    """On each piece of the force of all motions in a box, those at rest among them."""
    x, n = 0.5 * (low + high), of.size
    u, nowhere = np.stack((np.append(low, x), np.append(high, x))), np.array([[np.inf], [-np.inf]])
    f, slope = (np.tile(nowhere, (1, 2 * n)) for _ in range(2))
    for chart in np.flatnonzero(~charts.passes):
        part = np.stack((np.maximum(u[0], charts.low[0, chart]), np.minimum(u[1], charts.high[0, chart])))
        some = np.flatnonzero(part[0] <= part[1])
        here = charts.on_piece(part[:, some], np.full(some.size, chart))
        for whole, one in ((f, here.c_0), (slope, here.c_x - here.c_y)):
            whole[:, some] = np.minimum(whole[0, some], one.lo), np.maximum(whole[1, some], one.hi)
    for jump in charts.jumps.tolist():
        slope[:, (u[0] <= jump) & (jump <= u[1])] = ALL
    values, rows = (Interval(f) - charts.steps.load).ends, np.tile([-np.inf, np.inf], (n, 18))
    rows[:, AT], rows[:, ON], rows[:, SLOPE] = values[:, n:].T, values[:, :n].T, slope[:, :n].T
    return rows
