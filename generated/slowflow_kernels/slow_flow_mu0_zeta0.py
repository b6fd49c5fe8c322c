"""Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0 and zeta = 0.

Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

Rounding errors were measured with A 1e-09 to 1000; h 1e-12 to 1000 of either sign or 0; m, zeta 1e-12 to 1 or 0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from slowflow_kernels.slow_flow import (
    F_A, F_AA, F, F_AOmega, F_Omega, I, R, backbone, equivalent_damping, fold_quartic, level, peak_cubic, phase,
    stability,
)
from slowflow_kernels.slow_flow_mu0 import response_quartic
from slowflow_kernels.slow_flow_zeta0 import (
    fold, limit_envelope, undamped, undamped_Omega, undamped_level, undamped_rises,
)
from slowflow.support.backend import NATIVE, compiled
from slowflow.support.broadcast import floats, stacked

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from slowflow.support.broadcast import Floats

SCENE = "mu = zeta = 0: F is a quadratic in Omega^2, roots in closed form"

__all__ = [
    "F_A", "F_AA", "SCENE", "F", "F_AOmega", "F_Omega", "I", "R", "backbone", "detachment", "equivalent_damping",
    "fold", "fold_quartic", "level", "limit_envelope", "peak_cubic", "phase", "response_quartic", "stability",
    "undamped", "undamped_Omega", "undamped_level", "undamped_rises",
]


def detachment(A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Floats:
    """Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.

    Equation (34). Domain: A > 0. Operations: 1. Error / u (1 + kappa): proved 0.34, 0.0. One array, coefficients by
    rising power along its first axis.
    """
    A, m, zeta, h = floats(A, m, zeta, h)
    return stacked((A, m, zeta, h), -h * h, 1.0)


if NATIVE is not None:
    globals().update(compiled(globals(), NATIVE.slow_flow_mu0_zeta0()))
