"""Omega roots of one response quartic: families of quartics in, time per quartic and error in u (1 + kappa) out.

Methods: the installed ufunc, a loop over `numpy.roots` and batched companion eigenvalues, and Boost.Math's quartic and
ACM's Algorithm 1010 where they are installed, all but the first on the expanded coefficients of (24).
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from benchmarks import quartics
from benchmarks.remote import medians
from slowflow.core.backend import SOLVER
from tests.oracles.frequencies import U, relative_error, roots, stress_cases

OURS = "installed"
FAMILIES = ("mild", "F_0 << |h|", "near tangent", "three roots")
SEED = 3
Method = Callable[[np.ndarray], np.ndarray]


class Result(NamedTuple):
    """Of one method on one family: seconds per quartic, largest error in u (1 + kappa), wrong root counts."""

    seconds: float
    error: float
    wrong: int


def expanded(rows: np.ndarray) -> np.ndarray:
    """Coefficients of (24) in Omega, highest power first, divided by A^2."""
    A, h, m, zeta, F_0 = rows.T
    return np.column_stack(
        [
            np.ones_like(A),
            np.zeros_like(A),
            (4 * A**2 * zeta**2 + 2 * A * h) / A**2,
            4 * A * zeta * m / A**2,
            (m**2 + h**2 - F_0**2) / A**2,
        ]
    )


def numpy_roots_loop(rows: np.ndarray) -> np.ndarray:
    """Four complex roots of each quartic."""
    return np.array([np.roots(coefficients) for coefficients in expanded(rows)])


def companion_eigenvalues(rows: np.ndarray) -> np.ndarray:
    """Four complex roots of each quartic."""
    matrices = np.zeros((len(rows), 4, 4))
    matrices[:, 0, :] = -expanded(rows)[:, 1:]
    matrices[:, [1, 2, 3], [0, 1, 2]] = 1
    return np.linalg.eigvals(matrices)


def installed(rows: np.ndarray) -> np.ndarray:
    """What the compiled solvers run."""
    return SOLVER.response_roots(*rows.T)[0]


def positive(found: np.ndarray) -> np.ndarray:
    """Real positive roots of one quartic, rising; a complex result counts as real if its imaginary part is 0."""
    return np.sort(found.real[(found.imag == 0) & (found.real > 0)])


def errors(method: Method, rows: np.ndarray, certified: list[Any]) -> tuple[float, int]:
    """Largest error in u (1 + kappa) where the number of roots is right, and how often it is wrong."""
    largest, wrong = 0.0, 0
    for values, exact in zip(map(positive, method(rows)), certified, strict=True):
        if len(values) != len(exact):
            wrong += 1
            continue
        for value, (root, kappa) in zip(values, exact, strict=True):
            largest = max(largest, relative_error(float(value), root) / (U * (1 + kappa)))
    return largest, wrong


def measure(count: int, rounds: int) -> dict[str, dict[str, Result]]:
    """Results by method, then by family of `count` quartics."""
    methods: dict[str, Method] = {
        OURS: installed,
        "numpy.roots loop": numpy_roots_loop,
        "batched companion eigenvalues": companion_eigenvalues,
    }
    found: dict[str, dict[str, Result]] = {}
    with tempfile.TemporaryDirectory() as folder:
        methods |= quartics.build(Path(folder))
        cases = stress_cases("response", count, SEED)
        for family in FAMILIES:
            rows = np.ascontiguousarray(cases[family])
            certified = [roots("response", tuple(map(float, row))) for row in rows]
            seconds = medians({name: partial(method, rows) for name, method in methods.items()}, rounds)
            for name, method in methods.items():
                result = Result(seconds[name] / count, *errors(method, rows, certified))
                found.setdefault(name, {})[family] = result
    return found
