"""Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0.

Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

Rounding errors were measured with A, F_0 1e-09 to 1000; h 1e-12 to 1000 of either sign or 0; h_A, k_A 1e-09 to
1e+06 of either sign or 0; h_AA 1e-09 to 1e+09 of either sign or 0; k 1e-09 to 1000 of either sign; m, zeta 1e-12 to
1 or 0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from slowflow_kernels.slow_flow import (
    F_A, F_AA, F, F_AOmega, F_Omega, I, R, backbone, equivalent_damping, fold_quartic, isola_Omega, level,
    limit_envelope, peak_cubic, phase, stability,
)
from slowflow.support.backend import NATIVE, compiled, from_c
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


if NATIVE is not None:
    globals().update(compiled(globals(), NATIVE.slow_flow_mu0()))
#: functions that no Python code calls, which are in C, with their arguments; see generated/c/slow_flow_mu0.h
FROM_C = {
    "fold": "A F_0 m zeta h h_A k k_A",
    "isola": "A m zeta h h_A h_AA",
}
globals().update(from_c("slow_flow_mu0", FROM_C))
