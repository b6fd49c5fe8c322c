"""States and folds of a force that rises with u, without a proof. Takes steps with damping; returns all at conditions.

Where the force rises with u so does its mean with B: at each amplitude one mean is balanced, and h is a function of A
alone, as it is about the centre. It is taken for a cubic between amplitudes next to each other by a fixed ratio; where
F changes its sign, and at folds the forcing less the one that is asked for, Newton's method begins with all unknowns.
Two states whose amplitudes differ by less than a `FINE` part of that ratio may be missed, and that the force rises is
looked at in `SAMPLES` positions of each piece, not proved; `complete` proves both.
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
#: samples of a force in each piece, and on each side of 0 in so many octaves
SAMPLES, SMALLEST = 128, 24
#: by how much the last step moves an amplitude, or a mean, at most; steps of Newton's method, and of one with ends
NEAR, STEPS, MOST_STEPS = 1e-8, 6, 100

#: of several conditions, which one each answer is of, and their columns
Found = tuple[Ints, dict[str, Any]]


def states(steps: Steps, flow: Flow, Omega: Floats, F_0: Floats) -> Found | None:
    """States at frequencies and forcings (n,), by rising amplitude, without those at rest; None where f may fall."""
    force = flow.force(F_0, Omega)
    moving = np.flatnonzero(force > flow.m)
    Omega, F_0, force = Omega[moving], F_0[moving], force[moving]
    sheet = _sheet(steps, flow, float(flow.bound(Omega, force).max(initial=flow.m)), OCTAVES)
    if sheet is None:
        return None
    A, h, _, mean = sheet
    at = Omega[:, np.newaxis]
    of, near = _changes(np.hypot(A * at**2 + h, flow.sine(at, A)) - force[:, np.newaxis], A)
    slow, Omega = Slow(steps, flow, F_0[of]), Omega[of]
    (A, B), there = _solved(lambda x: slow.state(Omega, x), np.stack((near, mean(near))))
    stable, h = slow.stability(Omega, A, B)
    columns = {"A": A, "B": B, "stable": stable, "phi": flow.phase(Omega, A, h)}
    columns["transmissibility"] = flow.transmissibility(Omega, A, F_0[of], h)
    return moving[of[there]], {name: value[there] for name, value in columns.items()}


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
    _, (h, h_A, *_) = steps.averaged(nodes, B)
    spline = CubicHermiteSpline(np.append(0.0, nodes), np.append(0.0, h), np.append(h[0] / nodes[0], h_A))
    A = np.append(0.0, nodes[:-1, np.newaxis] + np.diff(nodes)[:, np.newaxis] * np.arange(FINE) / FINE)
    return A, spline(A), spline(A, 1), lambda A: np.interp(A, nodes, B)


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
