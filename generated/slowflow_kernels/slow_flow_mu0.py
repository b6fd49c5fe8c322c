
"""Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/paper/averaging.py, derivations/paper/slow_flow.py, derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py, derivations/systems/newton.py, derivations/paper/critical_forcings.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless. Arguments broadcast; each output has their common shape, NumPy scalars for scalars, where
arguments are of type ArrayLike, and the shape of those that it depends on where they may be any kind of number. Each
docstring gives equation number, domain and floating-point operations, by regime where there are several.
Rounding errors are in u (1 + kappa), u = 2^-53: proved ones hold wherever nothing overflows or underflows, measured
ones are the worst of all outputs that was found, by a search for it with A 1e-09 to 1000, F_0 1e-09 to 1000, h
1e-12 to 1000 of either sign or 0, h_A 1e-09 to 1e+06 of either sign or 0, h_AA 1e-09 to 1e+09 of either sign or 0,
k 1e-09 to 1000 of either sign, k_A 1e-09 to 1e+06 of either sign or 0, m 1e-12 to 1 or 0, zeta 1e-12 to 1 or 0.
"""

# a formatter would spread each polynomial over a page
# fmt: off

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow_kernels.slow_flow import (
    F_A, F_AA, F, F_AOmega, F_Omega, I, R, backbone, equivalent_damping, fold_quartic, isola_Omega, level,
    limit_envelope, peak_cubic, phase, stability,
)
from slowflow.support.backend import NATIVE, compiled
from slowflow.support.broadcast import broadcast_outputs, floats, stacked

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from slowflow.support.broadcast import Floats

SCENE = "mu = 0: F is a quadratic in Omega^2, roots in closed form"

__all__ = [
    "F_A", "F_AA", "SCENE", "F", "F_AOmega", "F_Omega", "I", "R", "backbone", "detachment", "equivalent_damping",
    "fold", "fold_quartic", "isola", "isola_Omega", "level", "limit_envelope", "peak_cubic", "phase",
    "response_quartic", "stability",
]


def response_quartic(A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.

    Equation (24). Domain: A > 0. Operations: 10. Error / u (1 + kappa): proved -, 0.0, 1.61, 0.34; measured 0.92.
    """
    A, F_0, m, zeta, h = floats(A, F_0, m, zeta, h)
    t0 = A * A
    return broadcast_outputs((A, F_0, m, zeta, h),
        (-F_0 + h) * (F_0 + h),
        0.0,
        2.0 * A * h + 4.0 * t0 * zeta * zeta,
        t0,
    )


def detachment(A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Floats:
    """Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.

    Equation (34). Domain: A > 0. Operations: 14. Error / u (1 + kappa): proved 4.01, 5.67, 0.0. One array,
    coefficients by rising power along its first axis.
    """
    A, m, zeta, h = floats(A, m, zeta, h)
    t0 = h * h
    zeta2 = zeta * zeta
    t1 = A * zeta2
    t2 = 4.0 * t1
    zeta4 = zeta2 * zeta2
    return stacked((A, m, zeta, h), -t0 * t2 * (h + t1), 4.0 * A * A * zeta4 + h * t2 - t0, 1.0)


def fold(A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike, k: ArrayLike, k_A: ArrayLike) -> tuple[Any, Any, Any]:
    """Zero at a fold at F_0: R of (23) less the R of F = F_A = 0; its slope along A, and Omega.

    Equation from (24), (30). Domain: A > 0, F_0 > m, k^2 >= F_0^2 - m^2. Operations: 39. Error / u (1 + kappa):
    measured 1.4.
    """
    A, F_0, m, zeta, h, h_A, k, k_A = floats(A, F_0, m, zeta, h, h_A, k, k_A)
    excess = F_0 * F_0
    least = np.sqrt(excess)
    t0 = 1.0 / k
    t1 = least * t0
    share = np.sqrt((1.0 - t1) * (t1 + 1.0))
    t2 = excess / F_0
    lag = share * t2
    t3 = t0 * t2
    t4 = 1.0 / (zeta * zeta)
    t5 = 1.0 / A
    t6 = t4 * t5
    t7 = 0.25 * lag * lag
    return broadcast_outputs((A, F_0, m, zeta, h, h_A, k, k_A),
        -F_0 * t3 + h + t6 * t7,
        F_0 * k_A * t2 * t2 * (F_0 / excess + 0.5 * t3 * t6) / (k * k) + h_A - t4 * t7 / (A * A),
        0.5 * lag * t5 / zeta,
    )


def isola(A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike, h_AA: ArrayLike) -> tuple[Any, Any]:
    """Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A.

    Equation from (30), (34). Domain: A > 0, h_A > 0; for m = 0 any h_A. Operations: 9. Error / u (1 + kappa):
    proved 2.34, 1.67.
    """
    A, m, zeta, h, h_A, h_AA = floats(A, m, zeta, h, h_A, h_AA)
    t0 = 2.0 * zeta * zeta
    bracket = A * (h_A + t0) + h
    bracket_A = A * h_AA + 2.0 * h_A + t0
    return broadcast_outputs((A, m, zeta, h, h_A, h_AA), bracket, bracket_A)


if NATIVE is not None:
    globals().update(compiled(globals(), NATIVE.slow_flow_mu0()))
