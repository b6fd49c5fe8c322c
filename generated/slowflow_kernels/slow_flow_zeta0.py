"""Slow flow of any mechanism, in h = H - A and its derivatives, in the scene zeta = 0.

Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

Rounding errors were measured with A, F_0 1e-09 to 1000; Omega 0.001 to 1000; h 1e-12 to 1000 of either sign or 0;
h_A, k_A 1e-09 to 1e+06 of either sign or 0; h_AA 1e-09 to 1e+09 of either sign or 0; h_AAA 1e-09 to 1e+12 of either
sign or 0; k 1e-09 to 1000 of either sign; m, zeta 1e-12 to 1 or 0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow_kernels.slow_flow import (
    F_A, F_AA, F, F_AOmega, F_Omega, I, R, backbone, equivalent_damping, fold_quartic, level, peak_cubic, phase,
    response_quartic, stability,
)
from slowflow.support.backend import NATIVE, compiled, from_c
from slowflow.support.broadcast import broadcast_outputs, common_shape, floats, full, stacked

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from slowflow.support.broadcast import Floats

SCENE = "zeta = 0: F is a quadratic in Omega^2, roots in closed form"

__all__ = [
    "F_A", "F_AA", "SCENE", "F", "F_AOmega", "F_Omega", "I", "R", "backbone", "detachment", "equivalent_damping",
    "fold", "fold_quartic", "level", "limit_envelope", "peak_cubic", "phase", "response_quartic", "stability",
    "undamped", "undamped_Omega", "undamped_level", "undamped_rises",
]


def limit_envelope(Omega: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike) -> Any:
    """Largest amplitude that the forcing can hold at this frequency.

    Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. Operations: 0. Error / u (1 + kappa): measured 0.
    """
    Omega, F_0, m, zeta = floats(Omega, F_0, m, zeta)
    return full(np.inf, common_shape((Omega, F_0, m, zeta)))


def detachment(A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Floats:
    """Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.

    Equation (34). Domain: A > 0. Operations: 6. Error / u (1 + kappa): proved 0.81, 0.67, 0.0. One array,
    coefficients by rising power along its first axis.
    """
    A, m, zeta, h = floats(A, m, zeta, h)
    t0 = m * m
    t1 = h * h
    return stacked((A, m, zeta, h), t0 * (t0 + t1), -2.0 * t0 - t1, 1.0)


def fold(F_0: ArrayLike, m: ArrayLike, k: ArrayLike, k_A: ArrayLike) -> tuple[Any, Any]:
    """Zero at a fold at F_0, where h_A < 0: R^2 + I^2 - F_0^2 on the undamped folds, and its slope along A.

    Equation from (24), (30). Domain: F_0 > m. Operations: 9. Error / u (1 + kappa): measured 0.62.
    """
    F_0, m, k, k_A = floats(F_0, m, k, k_A)
    excess = (F_0 - m) * (F_0 + m)
    least = np.sqrt(excess)
    return broadcast_outputs((F_0, m, k, k_A), (k - least) * (k + least), 2.0 * k * k_A)


if NATIVE is not None:
    globals().update(compiled(globals(), NATIVE.slow_flow_zeta0()))
#: functions that no Python code calls, which are in C, with their arguments; see generated/c/slow_flow_zeta0.h
FROM_C = {
    "undamped_Omega": "h_A",
    "undamped_level": "m k",
    "undamped_rises": "h_AA h_AAA k",
    "undamped": "A h h_A h_AA h_AAA",
}
globals().update(from_c("slow_flow_zeta0", FROM_C))
