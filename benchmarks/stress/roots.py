"""Roots in Omega at an amplitude: seeded hard cases in, counts and the worst error in u (1 + kappa) out.

In:  the families of `tests.oracles.frequencies`: tangent, double and triple to an ulp, vanishing dampings, F_0 far
     below and above |h|, beside a corner. Certified roots are FLINT's, of the exact coefficients.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.stress import search
from benchmarks.stress.search import Found, Point
from slowflow.core.backend import SOLVER
from tests.oracles.frequencies import KINDS, U, relative_error, stress_cases
from tests.oracles.frequencies import roots as certified

TARGET = 1.0
NAMES = {
    "response": "response quartic, Omega at given A and F_0 (24)",
    "fold": "fold quartic, Omega of a fold at given A (30)",
    "peak": "peak cubic, Omega where F_Omega = 0",
}
SEED = 11
Solver = Callable[..., tuple[np.ndarray, np.ndarray]]
INSTALLED: dict[str, Solver] = {
    "response": SOLVER.response_roots,
    "fold": SOLVER.fold_roots,
    "peak": SOLVER.peak_roots,
}


def judged(Omega: np.ndarray, exact: list[tuple[Any, float]]) -> tuple[float, float]:
    """The largest error in u (1 + kappa), with 1 + kappa, of as many roots as there are."""
    found = [
        (relative_error(float(value), root) / (U * (1 + kappa)), 1 + kappa)
        for value, (root, kappa) in zip(Omega, exact, strict=False)
        if math.isfinite(kappa)
    ]
    return max(found, default=(0.0, 1.0))


def error(kind: str, at: Point) -> tuple[float, float] | None:
    """The error at one point; infinite for a wrong number of roots, None outside the domain.

    Outside are points with a root below all normal doubles: the product m zeta has no digits there.
    """
    if (
        not all(math.isfinite(x) for x in at)
        or at[0] <= 0
        or any(x < 0 for name, x in zip(KINDS[kind], at, strict=True) if name not in ("h", "h_A"))
    ):
        return None
    exact = certified(kind, at)
    if any(float(root) < np.finfo(float).tiny for root, _ in exact):
        return None
    Omega, count = INSTALLED[kind](*at)
    if int(count) != len(exact):
        return math.inf, math.inf
    return judged(Omega, exact)


def stress(kind: str, family: str, count: int, steps: int) -> dict[str, Any]:
    """One family: `count` quartics, the wrong counts among them, and the search from the worst."""
    rows = stress_cases(kind, count, SEED)[family]
    found_Omega, found_count = INSTALLED[kind](*rows.T)
    seen, wrong = [], []
    for row, Omega, number in zip(rows.tolist(), found_Omega, found_count, strict=True):
        exact = certified(kind, tuple(row))
        if int(number) != len(exact):
            wrong.append(row)
            continue
        seen.append(Found(*judged(Omega, exact), tuple(row), family))
    rng = np.random.default_rng([SEED, len(family)])
    return {
        "kind": kind,
        "family": family,
        "names": KINDS[kind],
        "cases": count,
        "wrong": wrong,
        "drawn": [(f.condition, f.error) for f in seen[:: max(1, count // 150)]],
        "worst": [dataclasses.asdict(f) for f in search.worst(lambda at: error(kind, at), seen, 1, steps, rng)],
    }


def jobs() -> list[tuple[str, str]]:
    """Every kind and family."""
    return [(kind, family) for kind in KINDS for family in stress_cases(kind, 1, 0)]
