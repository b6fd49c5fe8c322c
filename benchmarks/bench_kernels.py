"""H and H' together: amplitudes in, time a point and error in u (1 + kappa) of each method out.

Methods: the compiled ufunc, the same kernel on NumPy, SymPy's `lambdify(cse=True)` of the closed form in that regime.
All are timed in turn in every round, on the processor clock of this thread, into arrays that exist already where the
method can; medians are compared.
kappa is the condition number in all arguments, so that u (1 + kappa) is what rounding these and the result would cost.
`python -m benchmarks.bench_kernels` prints the table; `rows` gives it.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from functools import partial
from types import ModuleType
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from derivations.mechanisms import all_mechanisms
from derivations.paper.equation_of_motion import oscillator
from derivations.paper.restoring_force import FAR, restoring
from derivations.symbols import A
from slowflow.example import DESIGN
from tests import backends

U = 2.0**-53
Method = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]


def scenes(u_cr: float, count: int, seed: int) -> dict[str, tuple[np.ndarray, int]]:
    """Amplitudes by scene, and how many breakpoints they exceed."""
    rng, far = np.random.default_rng(seed), float(FAR)
    return {
        "attached": (rng.uniform(0.01, u_cr, count), 0),
        f"detached, A < {far} u_cr": (rng.uniform(u_cr, far * u_cr, count), 1),
        f"detached, A > {far} u_cr": (rng.uniform(far * u_cr, 2.5 * u_cr, count), 1),
        "detached, rising": (np.linspace(u_cr, 2.5 * u_cr, count + 1)[1:], 1),
        "detached, at random": (rng.uniform(u_cr, 2.5 * u_cr, count), 1),
    }


def of_kernels(module: ModuleType, p: tuple[float, ...], amplitudes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """h and h_A from generated kernels."""
    return module.averaged_2(amplitudes, *p)


def of_sympy(
    function: Callable[..., Any], p: tuple[float, ...], amplitudes: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """h and h_A from a lambdified closed form."""
    return tuple(function(amplitudes, *p))


def condition(exact: Callable[..., Any], point: tuple[float, ...]) -> list[tuple[Any, Any]]:
    """Value and |f| + sum |x df/dx| of both functions at a point, from the closed form at 50 digits."""
    with mpmath.workdps(50):
        values = exact(*map(mpmath.mpf, point))
        scales = [abs(value) for value in values]
        for k, x in enumerate(point):
            step = mpmath.mpf(x) * mpmath.mpf(10) ** -20
            neighbour = exact(*(mpmath.mpf(y) + (step if j == k else 0) for j, y in enumerate(point)))
            scales = [s + abs((b - a) * x / step) for s, a, b in zip(scales, values, neighbour, strict=True)]
        return list(zip(values, scales, strict=True))


def worst(method: Method, certified: list[list[tuple[Any, Any]]], amplitudes: np.ndarray) -> float:
    """Largest error in u (1 + kappa)."""
    found = [0.0]
    for values, truth in zip(zip(*method(amplitudes), strict=True), certified, strict=True):
        with mpmath.workdps(50):
            found += [float(abs(mpmath.mpf(float(v)) - t) / (U * s)) for v, (t, s) in zip(values, truth, strict=True)]
    return max(found)


def rows(count: int = 10**6, repeats: int = 7, checked: int = 100, seed: int = 3) -> list[dict[str, Any]]:
    """One dictionary for each scene and method; `count` points, `repeats` rounds, errors at `checked` points."""
    mechanism = next(m for m in all_mechanisms() if m.name == "rod_spring")
    whole = restoring(oscillator(mechanism).polynomials, mechanism.breakpoints)
    numpy_kernels = backends.load("numpy")["rod_spring"]
    p = tuple(float(value) for value in numpy_kernels.coefficients(*DESIGN))
    kernels = {"NumPy": numpy_kernels}
    try:
        kernels = {"native": backends.load("native")["rod_spring"], **kernels}
    except ImportError:
        pass
    results = np.empty((2, count))
    table = []
    for scene, (amplitudes, passed) in scenes(p[-1], count, seed).items():
        closed = [whole.regimes[passed].closed_form(order) for order in (0, 1)]
        by_sympy = sp.lambdify((A, *mechanism.parameters), closed, modules="numpy", cse=True)
        exact = sp.lambdify((A, *mechanism.parameters), closed, modules="mpmath")
        methods: dict[str, Method] = {name: partial(of_kernels, module, p) for name, module in kernels.items()}
        methods["lambdify(cse=True)"] = partial(of_sympy, by_sympy, p)
        timed: dict[str, Callable[[], object]] = {name: partial(m, amplitudes) for name, m in methods.items()}
        if "native" in kernels:
            out = (results[0], results[1])
            timed["native"] = partial(kernels["native"].averaged_2, amplitudes, *p, out=out)
        seconds: dict[str, list[float]] = {name: [] for name in timed}
        for _ in range(repeats):
            for name, method in timed.items():
                start = time.thread_time()
                method()
                seconds[name].append(time.thread_time() - start)
        some = amplitudes[:: count // checked]
        certified = [condition(exact, (float(x), *p)) for x in some]
        fastest = np.median(seconds[next(iter(seconds))])
        for name, method in methods.items():
            table.append(
                {
                    "scene": scene,
                    "method": name,
                    "ns": float(np.median(seconds[name])) / count * 1e9,
                    "ratio": float(np.median(seconds[name]) / fastest),
                    "error_max": worst(method, certified, some),
                    "points": count,
                }
            )
    return table


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=10**6)
    parser.add_argument("--repeats", type=int, default=7)
    options = parser.parse_args()
    print(f"{'scene':28}{'method':22}{'ns':>9}{'ratio':>8}{'max error':>12}")
    for row in rows(options.count, options.repeats):
        print(f"{row['scene']:28}{row['method']:22}{row['ns']:9.2f}{row['ratio']:8.1f}{row['error_max']:12.3g}")


if __name__ == "__main__":
    main()
