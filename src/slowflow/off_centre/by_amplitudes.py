"""States and folds of a force that rises with u, without a proof. Takes steps with damping; returns all at conditions.

Where the force rises with u so does its mean with B: at each amplitude one mean is balanced, and h is a function of A
alone, as it is about the centre. It is taken for a cubic between amplitudes next to each other by a fixed ratio; where
F changes its sign, and at folds the forcing less the one that is asked for, Newton's method begins with all unknowns.
Where F turns next to 0, as close to a fold, both states begin from there. Two folds whose amplitudes differ by less
than a `FINE` part of that ratio may be missed, as may two states close to a fold on a corner that differ by 1e-7, and
that the force rises is looked at in `SAMPLES` positions of each piece, not proved; `complete` proves all.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from slowflow.core.mechanism import Flags, Force, Ints
from slowflow.core.model import Floats
from slowflow.off_centre.complete import ABOVE, farthest_fold
from slowflow.off_centre.flow import Flow, Slow
from slowflow.off_centre.means import Steps
from slowflow.off_centre.solution_sheets import FARTHEST, TOO_FAR
from slowflow.support.errors import OutOfRange
from slowflow_kernels.conventions import FoldKind

#: octaves of amplitudes, at how many in each the mean is balanced, and how often F is looked at between two of these
OCTAVES, NODES, FINE = 16, 4, 16
#: how far motions pass a jump of the force, relative to A, where the mean is balanced too
PAST = np.append(0.0, 2.0 ** -np.arange(4.0, 28.0, 2.0))
#: samples of a force in each piece, and on each side of 0 in so many octaves
SAMPLES, SMALLEST = 128, 24
#: by how much the last step moves an amplitude, or a mean, at most; steps of Newton's method, and of one with ends
NEAR, STEPS, MOST_STEPS = 1e-8, 6, 100
#: steps of Newton's method to where F turns, and how near to that, relative to A, states may lie between samples
TURNING_STEPS, CLOSE = 3, 2.0**-6

#: of several conditions, which one each answer is of, and their columns
Found = tuple[Ints, dict[str, Any]]


def states(steps: Steps, flow: Flow, Omega: Floats, F_0: Floats) -> Found | None:
    """States at frequencies and forcings (n,), by rising amplitude, without those at rest; None where f may fall."""
    force = flow.force(F_0, Omega)
    moving = np.flatnonzero(force > flow.m)
    Omega, F_0, force = Omega[moving], F_0[moving], force[moving]
    # states may lie at the bound itself
    sheet = _sheet(steps, flow, (1 + CLOSE) * float(flow.bound(Omega, force).max(initial=flow.m)), OCTAVES)
    if sheet is None:
        return None
    A, h, _, mean = sheet
    at = Omega[:, np.newaxis]
    F = np.hypot(A * at**2 + h, flow.sine(at, A)) - force[:, np.newaxis]
    of, near = _changes(F, A)
    # where F turns next to 0 two states may lie between samples
    rise = np.diff(F)
    row, cell = np.nonzero((rise[:, 1:] > 0) != (rise[:, :-1] > 0))
    turn = cell + 1
    reach = (CLOSE * A[turn] / (A[turn + 1] - A[turn])) ** 2
    some = np.abs(F[row, turn]) < reach * np.abs(rise[row, turn] - rise[row, cell])
    row, top = row[some], A[turn[some]]
    close, pairs = _pairs(steps, flow, Omega[row], force[row], np.stack((top, mean(top))))
    of = np.concatenate((of, row[close], row[close]))
    slow = Slow(steps, flow, F_0[of])
    start = np.concatenate((np.stack((near, mean(near))), pairs), axis=1)
    (A, B), there = _solved(lambda x: slow.state(Omega[of], x), start)
    stable, h = slow.stability(Omega[of], A, B)
    order = np.flatnonzero(there)[np.lexsort((A[there], of[there]))]
    of, A, B, stable, h = of[order], A[order], B[order], stable[order], h[order]
    # the stability of states next to one another differs: others are found twice
    once = np.ones(of.size, dtype=bool)
    once[1:] = (of[1:] != of[:-1]) | (stable[1:] != stable[:-1]) | (A[1:] - A[:-1] > NEAR * A[1:])
    columns = {"A": A, "B": B, "stable": stable, "phi": flow.phase(Omega[of], A, h)}
    columns["transmissibility"] = flow.transmissibility(Omega[of], A, F_0[of], h)
    return moving[of[once]], {name: value[once] for name, value in columns.items()}


def folds(steps: Steps, flow: Flow, F_0: Floats) -> Found | None:
    """Folds at forcings (n,), by rising frequency; None where f may fall, or jumps, as some folds are on corners."""
    jumps = steps.gains[1:, 0].any()
    sheet = None if jumps else _sheet(steps, flow, farthest_fold(steps, flow, float(F_0.max())), OCTAVES + ABOVE)
    if sheet is None:
        return None
    A, h, h_A, mean = sheet
    A, h, h_A = A[1:], h[1:], h_A[1:]
    Omega = flow.fold_frequencies(A, h, h_A)
    level = flow.level(Omega, A[:, np.newaxis], (h[:, np.newaxis],)).T
    row, near = _changes((level - F_0[:, np.newaxis, np.newaxis]).reshape(-1, A.size), A)
    of, root = np.divmod(row, len(level))
    left = np.searchsorted(A, near) - 1
    R = A[:, np.newaxis] * Omega**2 + h[:, np.newaxis]
    R = R[left, root] + (R[left + 1, root] - R[left, root]) * (near - A[left]) / (A[left + 1] - A[left])
    x, there = _solved(Slow(steps, flow, F_0[of]).fold, np.stack((near, mean(near), R)))
    (A, B, R), of = x[:, there], of[there]
    _, averages = steps.averaged(A, B)
    Omega = np.sqrt((R - averages[0]) / A)
    kind = np.where(flow.F_AA(Omega, A, averages) < 0, FoldKind.JUMP_UP, FoldKind.JUMP_DOWN)
    order = np.lexsort((Omega, of))
    columns = {"Omega": Omega, "A": A, "B": B, "kind": kind}
    return of[order], {name: value[order] for name, value in columns.items()}


def _sheet(
    steps: Steps, flow: Flow, A_max: float, octaves: int
) -> tuple[Floats, Floats, Floats, Callable[[Floats], Floats]] | None:
    """Rising amplitudes from 0 on, h and h_A along the balance there, and the mean at any; None where f may fall.

    Raises ArithmeticError where nothing bounds the motions, ValueError where the force does not grow.
    """
    from scipy.interpolate import CubicHermiteSpline  # only fits ask for this: it takes 80 ms to import

    A_max = min(A_max, steps.grown)
    if not A_max < FARTHEST:
        raise OutOfRange(TOO_FAR.format(A_max))
    bound = A_max + steps.settled
    if _may_fall(Force.of(flow.mechanism, flow.parameters), bound):
        return None
    nodes = A_max * 2.0 ** np.linspace(-octaves, 0.0, octaves * NODES + 1)
    B = _balanced(steps, nodes, bound)
    past_jumps, mean_there = _passing(steps, nodes, B)
    nodes, order = np.unique(np.append(nodes, past_jumps), return_index=True)
    B = np.append(B, mean_there)[order]
    _, (h, h_A, *_) = steps.averaged(nodes, B)
    spline = CubicHermiteSpline(np.append(0.0, nodes), np.append(0.0, h), np.append(h[0] / nodes[0], h_A))
    A = np.append(0.0, nodes[:-1, np.newaxis] + np.diff(nodes)[:, np.newaxis] * np.arange(FINE) / FINE)
    return A, spline(A), spline(A, 1), lambda A: np.interp(A, nodes, B)


def _passing(steps: Steps, A: Floats, B: Floats) -> Floats:
    """A and B where motions come to a jump of the force and just pass it, from samples of the balance.

    There h goes as a root. By the secant method along a line on which an end of the motion stays.
    """
    gap = A + steps.sides[:, np.newaxis] * B - steps.positions[:, np.newaxis]
    step, cell = np.nonzero(((gap[:, 1:] > 0) != (gap[:, :-1] > 0)) & (steps.gains[:, :1] != 0))
    step, cell, past = np.repeat(step, PAST.size), np.repeat(cell, PAST.size), np.tile(PAST, step.size)
    side, (low, high) = steps.sides[step], (A[cell], A[cell + 1])
    place = steps.positions[step] + past * low
    f_low, f_high = (steps.at(one, side * (place - one), 0).c[0] for one in (low, high))
    for _ in range(STEPS):
        with np.errstate(invalid="ignore"):
            change = (steps.load - f_high) * (high - low) / (f_high - f_low)
        low, f_low = high, f_high
        high = np.clip(high + np.where(np.isfinite(change), change, 0.0), 0.5 * A[cell], 2 * A[cell])
        f_high = steps.at(high, side * (place - high), 0).c[0]
    return np.stack((high, side * (place - high)))


def _may_fall(force: Force, bound: float) -> bool:
    """Whether a force falls between samples: within each piece, and next to 0 as well as far from it."""
    sizes = bound * 2.0 ** np.linspace(-SMALLEST, 0.0, SAMPLES)
    ends = np.clip((-bound, *force.edges, bound), -bound, bound)
    u = np.unique(np.concatenate((-sizes, sizes, np.linspace(ends[:-1], ends[1:], SAMPLES).ravel())))
    return bool((np.diff(force(u)) <= 0).any())


def _balanced(steps: Steps, A: Floats, bound: float) -> Floats:
    """The mean displacement at amplitudes, by Newton's method between ends that close in."""
    low, high, B = np.full(A.size, -bound), np.full(A.size, bound), np.zeros(A.size)
    left = np.arange(A.size)
    for _ in range(MOST_STEPS):
        means = steps.at(A[left], B[left], 1)
        f_0, before = means.c[0] - steps.load, B[left]
        low[left], high[left] = np.where(f_0 > 0, (low[left], before), (before, high[left]))
        B[left] = before - f_0 / means.c[1]
        B[left] = np.where((B[left] >= low[left]) & (B[left] <= high[left]), B[left], 0.5 * (low[left] + high[left]))
        left = left[np.abs(B[left] - before) > NEAR * A[left]]
        if not left.size:
            break
    return B


def _pairs(steps: Steps, flow: Flow, Omega: Floats, force: Floats, x: Floats) -> tuple[Flags, Floats]:
    """Where two states are close to an amplitude at which F turns, from A and B next to that; A and B of these."""
    A, B = x
    with np.errstate(all="ignore"):
        for _ in range(TURNING_STEPS):
            means, averages = steps.averaged(A, B)
            F_AA = flow.F_AA(Omega, A, averages)
            change = -flow.F_A(Omega, A, averages) / F_AA
            B = B - (means.c[0] - steps.load + means.s[1] * change) / means.c[1]
            A = A + change
        means = steps.at(A, B, 1)
        I, h = flow.sine(Omega, A), -2 * (means.s[0] - means.s[1] * (means.c[0] - steps.load) / means.c[1])
        apart = np.sqrt(-2 * ((A * Omega**2 + h) ** 2 + (I - force) * (I + force)) / F_AA)
        close = apart <= CLOSE * A
    middle, away = np.stack((A, B, apart, -means.s[1] / means.c[1] * apart))[:, close].reshape(2, 2, -1)
    return close, np.concatenate((middle - away, middle + away), axis=1)


def _changes(rows: Floats, A: Floats) -> tuple[Ints, Floats]:
    """Where rows change their sign along A: the number of the row, and A by a straight line."""
    known = np.isfinite(rows[:, 1:] - rows[:, :-1])
    row, cell = np.nonzero(known & ((rows[:, 1:] > 0) != (rows[:, :-1] > 0)))
    fraction = rows[row, cell] / (rows[row, cell] - rows[row, cell + 1])
    return row, A[cell] + fraction * (A[cell + 1] - A[cell])


def _solved(equations: Callable[[Floats], Any], x: Floats) -> tuple[Floats, Flags]:
    """Solutions by Newton's method from (d, n) on, and where it came to one; A is the first unknown.

    equations -- d values, then the slopes of each
    """
    d = len(x)
    there: Flags = np.zeros(x.shape[1], dtype=bool)
    for _ in range(STEPS):
        values, slopes = np.split(np.array([row + np.zeros(x.shape[1]) for row in equations(x)]), [d])
        J = slopes.reshape(d, d, -1).transpose(2, 0, 1)
        step = np.linalg.solve(J, values.T[..., np.newaxis])[..., 0].T
        x = x - step
        there = np.asarray((np.abs(step) <= NEAR * np.maximum(np.abs(x), x[:1])).all(axis=0))
        if there.all():
            break
    return x, there
