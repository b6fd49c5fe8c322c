"""What the level does along the fold locus at its cusps and isola points: in go (Omega, A), out come flags."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow.model import Floats, Model
from slowflow_kernels import inertia, slow_flow

Flags = npt.NDArray[np.bool_]


def cusp_is_minimum(model: Model, Omega: Floats, A: Floats) -> Flags:
    """Whether the level has a minimum along the fold locus at these cusps, by its second derivative."""
    kernels: Any = inertia if model.inertial else slow_flow
    return np.asarray(kernels.cusp_bend(Omega, A, model.m, model.zeta, *model.averaged(A)) > 0)


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
