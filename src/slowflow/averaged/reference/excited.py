"""At one amplitude, by either excitation: in go a model and an amplitude, out come its frequencies."""

from __future__ import annotations

import numpy as np

from slowflow.averaged.reference import dissipated, inertia
from slowflow.averaged.reference.roots import peak_roots, response_roots
from slowflow.model import Floats, Model


def frequencies_at(model: Model, A: float, F_0: float) -> Floats:
    """Every Omega at which A is a steady state at the amplitude F_0 of the excitation, by its size."""
    if model.laws.any:
        return dissipated.frequencies_at(model, A, F_0)
    at = np.array([A])
    if not model.inertial:
        roots, count = response_roots(at, model.averaged(at)[0], model.m, model.zeta, F_0)
        return np.asarray(roots[0, : count[0]])
    along = inertia.Roots(model, F_0)
    (n,) = along.count(at)
    return along.at(np.full(n, A), np.full(n, n), np.arange(n))


def stationary_at(model: Model, A: float) -> Floats:
    """Every Omega > 0 at which the level of the amplitude is stationary, by its size."""
    if model.laws.any:
        return dissipated.stationary_at(model, A)
    at = np.array([A])
    h = model.averaged(at)[0]
    if not model.inertial:
        roots, count = peak_roots(at, h, model.m, model.zeta)
        return np.asarray(roots[0, : count[0]])
    falls, Omega = inertia.falls_to_least(model, at, h)
    return np.asarray(Omega[falls])
