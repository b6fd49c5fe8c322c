"""What one would write without slowflow, on the same cases: numpy.roots on (24), the resultant's roots in doubles,
scipy.optimize.brentq between the points of a grid, fsolve from a grid of starts.

In:  an oscillator, a forcing and a frequency, or rows of quartics. Out: numbers of states, folds, roots.
"""

from __future__ import annotations

import math
import warnings
from typing import Any

import numpy as np
from scipy.optimize import brentq, fsolve

from benchmarks.bench_roots import expanded, positive
from benchmarks.stress.roots import judged
from slowflow_kernels import duffing, slow_flow
from tests.oracles.frequencies import roots as certified
from tests.oracles.frequencies import stress_cases

GRID = 400
STARTS = 6
#: a root counts as real, and two as the same, to this
SAME = 1e-6


def quartics(count: int, seed: int) -> list[dict[str, Any]]:
    """numpy.roots on the coefficients of (24): by family cases, wrong counts, the worst error in u (1 + kappa)."""
    table = []
    for family, rows in stress_cases("response", count, seed).items():
        wrong, worst = 0, 0.0
        for row, coefficients in zip(rows, expanded(rows), strict=True):
            exact = certified("response", tuple(map(float, row)))
            found = positive(np.roots(coefficients))
            if len(found) != len(exact):
                wrong += 1
            else:
                worst = max(worst, judged(found, exact)[0])
        table.append({"family": family, "cases": count, "wrong": wrong, "error": worst})
    return table


def counts(kind: str, iso: Any, Omega: float, F_0: float) -> dict[str, int]:
    """Numbers found by each way at one case."""
    with np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        if kind == "states":
            return {f"brentq between {GRID} amplitudes": _by_brentq(iso, Omega, F_0)}
        found = {f"fsolve from {STARTS} × {STARTS} starts": _by_fsolve(iso, F_0)}
        if not iso.breakpoints:
            found["numpy.roots on the resultant"] = _by_resultant(iso, F_0)
        return found


def _largest(iso: Any, F_0: float) -> float:
    """An amplitude that the response hardly exceeds."""
    reach = iso.model.reach
    return min(float(reach), 50.0) if math.isfinite(reach) else max(5.0, F_0 / max(iso.zeta, 1e-3))


def _F(iso: Any, Omega: Any, A: Any, F_0: float) -> Any:
    h = iso.model.averaged(A)[0]
    return slow_flow.F(Omega, A, F_0, iso.model.m, iso.zeta, h)


def _by_brentq(iso: Any, Omega: float, F_0: float) -> int:
    A = np.geomspace(1e-6, _largest(iso, F_0), GRID)
    values = _F(iso, Omega, A, F_0)
    changes = np.flatnonzero(np.sign(values[:-1]) != np.sign(values[1:]))
    return len([brentq(lambda a: float(_F(iso, Omega, a, F_0)), A[k], A[k + 1]) for k in changes])


def _by_fsolve(iso: Any, F_0: float) -> int:
    def system(x: Any) -> list[float]:
        Omega, A = abs(x)
        h, h_A = iso.model.averaged(A)[:2]
        m, zeta = iso.model.m, iso.zeta
        return [float(slow_flow.F(Omega, A, F_0, m, zeta, h)), float(slow_flow.F_A(Omega, A, m, zeta, h, h_A))]

    found: list[tuple[float, float]] = []
    for Omega in np.linspace(0.2, 2, STARTS):
        for A in np.geomspace(0.01, 2, STARTS):
            x, _, flag, _ = fsolve(system, [Omega, A], full_output=True)
            x = np.abs(x)
            if flag == 1 and all(max(abs(x[0] / a - 1), abs(x[1] / b - 1)) > SAME for a, b in found):
                found.append((float(x[0]), float(x[1])))
    return len(found)


def _by_resultant(iso: Any, F_0: float) -> int:
    m, zeta = iso.model.m, iso.zeta
    coefficients = np.ravel(duffing.saddle_nodes(F_0, m, zeta, *iso.model.parameters))
    squares = np.roots(coefficients[::-1]) if np.isfinite(coefficients).all() else np.empty(0)
    number = 0
    for A in np.sqrt(squares.real[(abs(squares.imag) < SAME * abs(squares)) & (squares.real > 0)]):
        h, h_A = iso.model.averaged(A)[:2]
        R = np.roots(expanded(np.array([[A, h, m, zeta, F_0]]))[0])
        Omega = R.real[(abs(R.imag) < SAME * abs(R)) & (R.real > 0)]
        slope = slow_flow.F_A(Omega, A, m, zeta, h, h_A)
        number += int(np.any(abs(slope) * A < 1e-4 * F_0**2))
    return number
