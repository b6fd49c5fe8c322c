"""How far to look: in go a model and a forcing, out comes an amplitude that no steady state exceeds."""

from __future__ import annotations

import numpy as np

from slowflow.averaged.reference.roots import peak_roots
from slowflow.model import Floats, Model
from slowflow_kernels import slow_flow
from slowflow_kernels.conventions import STATIC_MULTIPLE

#: multiples of the least amplitude that are tried as a bound
RUNGS = np.ldexp(1.0, [*range(16), *range(16, 117, 4)])


def least_forcing(model: Model, A: Floats) -> tuple[Floats, Floats]:
    """The lowest F_0 for which each A (n,) is a steady state, and its Omega: min over Omega >= 0 of sqrt(R^2 + I^2)."""
    h = model.averaged(A)[0]
    flow = model.flow
    Omega = np.concatenate([np.zeros((*A.shape, 1)), peak_roots(A, h, model.m, model.zeta)[0]], axis=-1)
    level = flow.level(Omega, A[..., np.newaxis], model.m, model.zeta, h[..., np.newaxis])
    lowest = np.nanargmin(level, axis=-1)[..., np.newaxis]
    return np.take_along_axis(level, lowest, -1)[..., 0], np.take_along_axis(Omega, lowest, -1)[..., 0]


def cut(model: Model, F_0: float) -> tuple[float, str]:
    """Where the response is cut that has no viscous damping and is unbounded for F_0 > m (27), and a remark.

    That is at the mechanism's reach, or at a multiple of the static deflection.
    """
    words = "unbounded without viscous damping: cut at A = "
    if np.isfinite(model.reach):
        return model.reach, f"{words}{model.reach:g}, {model.mechanism.reach_reason}"
    A_max = max(STATIC_MULTIPLE * F_0, 2 * max(model.breakpoints, default=0.0))
    return A_max, f"{words}{A_max:g}"


def amplitude_bound(model: Model, F_0: float) -> tuple[float, str]:
    """An amplitude above that of every steady state at F_0, and a remark in words where the response has to be cut.

    Raises OverflowError where no such amplitude is found.
    """
    if model.zeta == 0:
        return cut(model, F_0)
    # From the bound on |h| is too large for a state, and h keeps its sign: where it changes between two rungs, |h| is
    # small.
    ladder = max(2 * max(model.breakpoints, default=0.0), F_0, 1e-6) * RUNGS
    h = model.averaged(ladder)[0]
    with np.errstate(over="ignore"):
        holds = ~(np.abs(h) > slow_flow.most_restoring(ladder, F_0, model.m, model.zeta) + 0.01 * F_0)
    if holds[-1]:
        raise OverflowError(f"no amplitude up to {ladder[-1]:g} bounds the response to F_0 = {F_0}")
    below = np.flatnonzero(holds[:-1] | ((h[1:] > 0) != (h[:-1] > 0)))
    return float(ladder[below[-1] + 1 if below.size else 0]), ""
