"""What the level does along the fold locus at its cusps and isola points: in go (Omega, A), out come flags."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from slowflow.model import Floats, Model
from slowflow_kernels import inertia, slow_flow

Flags = npt.NDArray[np.bool_]


def cusp_is_minimum(model: Model, Omega: Floats, A: Floats) -> Flags:
    """Whether the level has a minimum along the fold locus at these cusps, by its second derivative."""
    h, h_A, h_AA, h_AAA = model.averaged(A)
    if model.inertial:
        return np.asarray(inertia.cusp_bend(Omega, A, model.m, model.zeta, h, h_A, h_AA, h_AAA) > 0)
    return np.asarray(cusp_bend(model, Omega, A) > 0)


def cusp_bend(model: Model, Omega: Floats, A: Floats) -> Floats:
    """-F_AAA F_AOmega F_Omega/A at cusps of a force's amplitude."""
    _, _, h_AA, h_AAA = model.averaged(A)
    T = _cusp_tangent(model, Omega, A, h_AA)
    return np.asarray(slow_flow.cusp_bend(Omega, A, model.zeta, h_AA, h_AAA, T))


def _cusp_tangent(model: Model, Omega: Floats, A: Floats, h_AA: Floats) -> Floats:
    """dR/dA at a cusp, by its frequency.

    With R from F_AA = 0 F_A is T^3 + p T - q, whose root nothing cancels in; h_A has few digits of it if damping is
    weak.
    """
    doubled = 2 * model.zeta * Omega
    size = np.cbrt(doubled * slow_flow.I(Omega, A, model.m, model.zeta) * h_AA)
    e = (doubled / size) ** 2
    v = np.cbrt(0.5 + np.sqrt(0.25 + e**3 / 27))
    return np.asarray(np.where(e < 1e30, size / (v * v + e / 3 + (e / (3 * v)) ** 2), size / e))


def isola_is_minimum(model: Model, Omega: Floats, A: Floats) -> Flags:
    """The same at these isola points."""
    if model.inertial:
        rises = slow_flow.F_AA(Omega, A, model.m, model.zeta, *model.averaged(A)[:3]) > 0
        return np.asarray(rises & ~is_saddle(model, Omega, A))
    return np.asarray(slow_flow.isola_bend(Omega, A, model.m, model.zeta, model.averaged(A)[2]) > 0)


def is_saddle(model: Model, Omega: Floats, A: Floats) -> Flags:
    """Whether F has a saddle in (A, Omega) at these isola points: its Hessian is negative."""
    h, h_A, h_AA, _ = model.averaged(A)
    if model.inertial:
        return np.asarray(inertia.hessian(Omega, A, model.m, model.zeta, h, h_A, h_AA) < 0)
    return np.asarray(slow_flow.isola_hessian(Omega, A, model.m, model.zeta, h_AA) < 0)
