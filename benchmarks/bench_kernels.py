"""H and H' together: amplitudes in, time per point and error in u (1 + kappa) of each method out.

Methods: the compiled ufunc, and SymPy's `lambdify(cse=True)` of the closed form in that regime. The ufunc writes into
arrays that exist already. kappa is the condition number in all arguments, so that u (1 + kappa) is what rounding these
and the result would cost.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import mpmath
import numpy as np
import sympy as sp

from benchmarks.remote import medians
from derivations.mechanisms import all_mechanisms
from derivations.paper.equation_of_motion import oscillator
from derivations.paper.restoring_force import FAR, restoring
from derivations.symbols import A
from slowflow.example import DESIGN
from slowflow_kernels import rod_spring
from tests.oracles import kernels

U = 2.0**-53
SEED = 3
Method = Callable[..., tuple[np.ndarray, np.ndarray]]


class Result(NamedTuple):
    """Seconds per point of both methods, and their largest errors in u (1 + kappa)."""

    seconds: float
    by_sympy: float
    error: float
    error_by_sympy: float


def families(u_cr: float, count: int) -> dict[str, tuple[np.ndarray, int]]:
    """Amplitudes by family, and how many breakpoints they exceed."""
    rng, far = np.random.default_rng(SEED), float(FAR)
    return {
        "attached": (rng.uniform(0.01, u_cr, count), 0),
        f"detached, A < {far} u_cr": (rng.uniform(u_cr, far * u_cr, count), 1),
        f"detached, A > {far} u_cr": (rng.uniform(far * u_cr, 2.5 * u_cr, count), 1),
        "detached, rising": (np.linspace(u_cr, 2.5 * u_cr, count + 1)[1:], 1),
        "detached, at random": (rng.uniform(u_cr, 2.5 * u_cr, count), 1),
    }


def worst(answers: tuple[np.ndarray, np.ndarray], certified: list[tuple[list[Any], list[Any]]]) -> float:
    """Largest error in u (1 + kappa), by certified values and what rounding arguments and result would cost."""
    found = [0.0]
    for values, (truth, scales) in zip(zip(*answers, strict=True), certified, strict=True):
        rounded = zip(values, truth, scales, strict=True)
        found += [float(abs(mpmath.mpf(float(value)) - exact) / (U * scale)) for value, exact, scale in rounded]
    return max(found)


def measure(count: int, rounds: int, checked: int = 100) -> dict[str, Result]:
    """Results by family of `count` amplitudes, errors at `checked` of these."""
    mechanism = next(m for m in all_mechanisms() if m.name == "rod_spring")
    whole = restoring(oscillator(mechanism).polynomials, mechanism.breakpoints)
    p = tuple(float(value) for value in rod_spring.coefficients(*DESIGN))
    out = tuple(np.empty((2, count)))
    found = {}
    for family, (amplitudes, passed) in families(p[-1], count).items():
        closed = [whole.regimes[passed].closed_form(order) for order in (0, 1)]
        arguments = (A, *mechanism.parameters)
        by_sympy = sp.lambdify(arguments, closed, modules="numpy", cse=True)
        methods: dict[str, Method] = {"slowflow": rod_spring.averaged_2, "SymPy": by_sympy}
        calls = {name: partial(method, amplitudes, *p) for name, method in methods.items()}
        seconds = medians({**calls, "slowflow": partial(calls["slowflow"], out=out)}, rounds)
        some = amplitudes[:: count // checked]
        certified = [
            kernels.values("rod_spring", "averaged_2", list(map(str, arguments)), (float(x), *p)) for x in some
        ]
        errors = [worst(method(some, *p), certified) for method in methods.values()]
        found[family] = Result(*(taken / count for taken in seconds.values()), *errors)
    return found
