"""The averaged equations of an oscillator about the centre on a grid of amplitudes: states and folds are counted.

h is a quadrature of the oscillator's force, of a cubic spring the closed form typed here, and I the work of each law of
damping over a cycle. So a state is where R^2 + I^2 passes the square of the force, stable where it rises (30), and a
fold where the number of states changes by two.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np

from slowflow import Duffing
from slowflow.answers.results import Remark

#: on (0, 1), for each stretch of an angle between breakpoints, crowded at its ends: powers 3/2 are smooth there
NODES, WEIGHTS = np.polynomial.legendre.leggauss(48)
NODES, WEIGHTS = (2 - NODES) * (1 + NODES) ** 2 / 4, 3 / 4 * (1 - NODES**2) * WEIGHTS
#: amplitudes 0.14 per cent apart
GRID = np.geomspace(1e-8, 100.0, 16_001)
#: relative distances at which a grid is finer about amplitudes that are found
NEARBY = np.geomspace(1e-12, 1e-3, 19)[:, np.newaxis] * [-1.0, 1.0]
#: where states are counted
FREQUENCIES = (0.3, 0.7, 0.9, 1.05, 1.4, 2.3)
#: remarks of motions that averaging alone calls stable
LEAVE = Remark.LEAVES_CENTRE | Remark.BEYOND_WELL


def average(osc: Any, A: Any) -> Any:
    """h, of a cubic spring in the precision of the amplitudes."""
    if isinstance(osc, Duffing):
        return -osc.alpha * A - 0.75 * osc.beta * A**3
    force, A = osc.restoring_force(), np.asarray(A, dtype=float)
    turns = [np.arccos(np.minimum(end / A, 1.0)) for end in reversed(osc.breakpoints)]
    edges, total = [0.0 * A, *turns, 0.0 * A + np.pi / 2], 0.0 * A
    for low, high in pairwise(edges):
        width = (high - low)[..., np.newaxis]
        cosine = np.cos(low[..., np.newaxis] + width * NODES)
        total += (force(A[..., np.newaxis] * cosine) * cosine * width) @ WEIGHTS
    return -4 / np.pi * total


@lru_cache(maxsize=2)
def on_grid(osc: Any) -> Any:
    """h, which takes longest."""
    return average(osc, GRID)


def lag(osc: Any, Omega: Any, A: Any) -> Any:
    """I, by the work of friction, viscous, structural, quadratic and cubic damping over a cycle."""
    way = np.minimum(A, osc.breakpoints[0]) if osc.contact == "attached" else A
    work = 4 * osc.mu * way + np.pi * (osc.eta + 2 * osc.zeta * Omega) * A**2 + 8 / 3 * osc.c_2 * Omega**2 * A**3
    return (work + np.pi * (0.5 * osc.zeta_2 * Omega + 0.75 * osc.c_3 * Omega**3) * A**4) / (np.pi * A)


def balances(osc: Any, Omega: Any, A: Any) -> tuple[Any, Any]:
    """R and I."""
    return A * Omega**2 + average(osc, A), lag(osc, Omega, A)


def force_of(osc: Any, Omega: Any, F_0: float) -> Any:
    """The force of an excitation."""
    return F_0 * Omega**2 if osc.model.inertial else F_0


def assert_complete(osc: Any, F_0: float, frequencies: Sequence[float] = FREQUENCIES, reach: float = GRID[-1]) -> None:
    """Assert that folds, and states at frequencies and between folds, are all that there are up to an amplitude."""
    folds = osc.saddle_nodes(F_0)
    assert Remark.UNDECIDED not in folds.remarks, osc
    ends = np.sort(folds.Omega)
    ends = np.concatenate((0.9 * ends[:1], ends, 1.1 * ends[-1:]))
    between = 0.5 * (ends[1:] + ends[:-1])
    every = np.unique(np.concatenate((between, frequencies)))
    states = osc.amplitudes(Omega=every, F_0=F_0)
    assert not states.Omega_undecided.size, osc
    grid, counts = GRID[GRID <= reach], {}
    h = on_grid(osc)[: grid.size]
    for Omega in every.tolist():
        here = (states.Omega == Omega) & (states.A > 0)  # beside a mass that is held at rest
        near = np.multiply.outer(states.A[here], 1 + NEARBY).ravel()
        A, order = np.unique(np.concatenate((grid, near)).astype(np.longdouble), return_index=True)
        R = A * Omega**2 + np.concatenate((h, average(osc, near.astype(np.longdouble))))[order]
        F = R**2 + lag(osc, Omega, A) ** 2 - force_of(osc, np.longdouble(Omega), F_0) ** 2
        passed = np.flatnonzero((F[1:] < 0) != (F[:-1] < 0))
        np.testing.assert_allclose(states.A[here], A[passed].astype(float), rtol=2e-3, err_msg=f"{osc} {F_0} {Omega}")
        rises, stable = F[passed + 1] > 0, states.stable[here]
        assert np.array_equal(stable, rises) or (LEAVE & states.remarks and (rises | ~stable).all()), (osc, F_0, Omega)
        counts[Omega] = passed.size
    assert all(abs(counts[one] - counts[other]) == 2 for one, other in pairwise(between.tolist())), (osc, F_0, counts)
    for found in (states, folds):
        A, Omega = found.A[found.A > 0], found.Omega[found.A > 0]
        (R, I), force = balances(osc, Omega, A), force_of(osc, Omega, F_0)
        terms = 2 * A * Omega**2 + np.abs(R) + I + force + 0.1 * A  # springs may cancel in h
        assert (np.abs(np.hypot(R, I) - force) <= 1e-12 * terms).all(), (osc, F_0)
