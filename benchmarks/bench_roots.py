"""Omega roots of one response quartic: scenes in, time per quartic and error in u (1 + kappa) of each method out.

Methods: the C solver (with a clone for fma, and without), the installed ufunc, a loop over
`numpy.roots` and batched companion eigenvalues, and Boost.Math's quartic and ACM's Algorithm 1010 where they are at
hand, the last four on the expanded coefficients of (24). All methods are timed in turn in every round, each after a
call that warms the caches for it, and the medians are compared.
`python -m benchmarks.bench_roots` prints the table; `rows` gives it.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks import acm1010, boost
from slowflow.core.backend import SOLVER
from tests.native.roots import build, why_not
from tests.oracles.frequencies import U, relative_error, roots, stress_cases

BOOST, ACM = "Boost.Math", "ACM Algorithm 1010"
SCENES = ("mild", "F_0 << |h|", "near tangent", "three roots")
Method = Callable[[np.ndarray], np.ndarray]


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
    found = np.zeros((len(rows), 4), complex)
    for i, coefficients in enumerate(expanded(rows)):
        found[i] = np.roots(coefficients)
    return found


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


def errors(method: Method, rows: np.ndarray, certified: list[Any]) -> tuple[float, float, int]:
    """Largest and median error in u (1 + kappa) where the number of roots is right, and how often it is wrong."""
    found, wrong = [], 0
    for values, exact in zip(method(rows), certified, strict=True):
        values = positive(values)
        if len(values) != len(exact):
            wrong += 1
            continue
        found += [
            relative_error(float(value), root) / (U * (1 + kappa))
            for value, (root, kappa) in zip(values, exact, strict=True)
        ]
    return max(found, default=np.nan), float(np.median(found)) if found else np.nan, wrong


def rows(count: int = 5000, repeats: int = 7, seed: int = 3) -> list[dict[str, Any]]:
    """One dictionary for each scene and method; count quartics a scene, repeats rounds."""
    methods: dict[str, Method] = {}
    with tempfile.TemporaryDirectory() as directory:
        for name, clones in (("C", True), ("C, fma by libm", False)):
            if why_not(clones) is None:
                solve = build(Path(directory), clones)
                methods[name] = lambda parameters, solve=solve: solve("response", parameters)[0]
        methods |= {
            "installed": installed,
            "companion eigenvalues, batched": companion_eigenvalues,
            "numpy.roots loop": numpy_roots_loop,
        }
        for name, solve in ((BOOST, boost.build(Path(directory))), (ACM, acm1010.build(Path(directory)))):
            if solve is not None:
                methods[name] = solve
        table = []
        families = stress_cases("response", count, seed)
        for scene in SCENES:
            parameters = np.ascontiguousarray(families[scene])
            certified = [roots("response", tuple(map(float, row))) for row in parameters]
            seconds: dict[str, list[float]] = {name: [] for name in methods}
            for _ in range(repeats):
                for name, method in methods.items():
                    method(parameters)
                    start = time.perf_counter()
                    method(parameters)
                    seconds[name].append(time.perf_counter() - start)
            fastest = np.median(seconds[next(iter(methods))])
            for name, method in methods.items():
                largest, median, wrong = errors(method, parameters, certified)
                table.append(
                    {
                        "scene": scene,
                        "method": name,
                        "ns": float(np.median(seconds[name])) / count * 1e9,
                        "ratio": float(np.median(seconds[name]) / fastest),
                        "error_max": largest,
                        "error_median": median,
                        "wrong_counts": wrong,
                        "quartics": count,
                    }
                )
    return table


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--repeats", type=int, default=7)
    options = parser.parse_args()
    print(f"{'scene':14}{'method':32}{'ns':>9}{'ratio':>8}{'max error':>11}{'median':>9}  wrong counts")
    for row in rows(options.count, options.repeats):
        print(
            f"{row['scene']:14}{row['method']:32}{row['ns']:9.0f}{row['ratio']:8.1f}{row['error_max']:11.3g}"
            f"{row['error_median']:9.2g}  {row['wrong_counts']} of {row['quartics']}"
        )


if __name__ == "__main__":
    main()
