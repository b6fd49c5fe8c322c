"""What the level does along the fold locus at its cusps and isola points: in go (Omega, A), out come flags."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from slowflow.model import Floats, Model

Flags = npt.NDArray[np.bool_]


def cusp_is_minimum(model: Model, Omega: Floats, A: Floats) -> Flags:
    """Whether the level has a minimum along the fold locus at these cusps, by its second derivative."""
    flow, m, zeta = model.flow, model.m, model.zeta
    h, h_A, h_AA, h_AAA = model.averaged(A)
    F_Omega, F_AOmega = flow.F_Omega(Omega, A, m, zeta, h), flow.F_AOmega(Omega, A, m, zeta, h, h_A)
    return np.asarray(F_Omega / A * flow.F_AAA(Omega, A, m, zeta, h, h_A, h_AA, h_AAA) * F_AOmega < 0)


def isola_is_minimum(model: Model, Omega: Floats, A: Floats) -> Flags:
    """The same at these isola points."""
    F_AA, F_AOmega, F_OmegaOmega = _second_derivatives(model, Omega, A)
    return np.asarray(F_AA * (F_AA * F_OmegaOmega - F_AOmega * F_AOmega) > 0)


def is_saddle(model: Model, Omega: Floats, A: Floats) -> Flags:
    """Whether F has a saddle in (A, Omega) at these isola points: its Hessian is negative."""
    F_AA, F_AOmega, F_OmegaOmega = _second_derivatives(model, Omega, A)
    return np.asarray(F_AA * F_OmegaOmega < F_AOmega * F_AOmega)


def _second_derivatives(model: Model, Omega: Floats, A: Floats) -> tuple[Floats, Floats, Floats]:
    """F_AA, F_AOmega and F_OmegaOmega."""
    flow, m, zeta = model.flow, model.m, model.zeta
    h, h_A, h_AA, _ = model.averaged(A)
    F_AA, F_AOmega = flow.F_AA(Omega, A, m, zeta, h, h_A, h_AA), flow.F_AOmega(Omega, A, m, zeta, h, h_A)
    return F_AA, F_AOmega, flow.F_OmegaOmega(Omega, A, zeta, h)
