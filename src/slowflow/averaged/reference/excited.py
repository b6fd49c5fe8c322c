"""At one amplitude, by either excitation: in go a model and an amplitude, out come its frequencies."""

from __future__ import annotations

from typing import Any

import numpy as np

from slowflow.averaged.reference import dissipated, inertia
from slowflow.averaged.reference.roots import Counts, Ints, peak_roots, response_roots, taken
from slowflow.model import Floats, Model


def frequencies_at(model: Model, A: float, F_0: float) -> Floats:
    """Every Omega at which A is a steady state at the amplitude F_0 of the excitation, by its size."""
    if model.laws.any:
        return dissipated.frequencies_at(model, A, F_0)
    if not model.inertial:
        return frequencies_abreast(model, np.array([A]), F_0, np.zeros(1, np.intp))[1]
    along, at = inertia.Roots(model, F_0), np.array([A])
    (n,) = along.count(at)
    return along.at(np.full(n, A), np.full(n, n), np.arange(n))


def frequencies_abreast(model: Model, A: Floats, F_0: Any, of: Ints) -> tuple[Ints, Floats]:
    """The same at an amplitude of each of some designs abreast, `of`: of which of them it is, and Omega."""
    if model.inertial or model.laws.any:  # one design
        Omega = frequencies_at(model, float(A[0]), F_0)
        return np.zeros(Omega.size, np.intp), Omega
    own = model.take(of)
    return _counted(of, response_roots(A, own.averaged(A)[0], own.m, own.zeta, taken(F_0, of)))


def stationary_at(model: Model, A: float) -> Floats:
    """Every Omega > 0 at which the level of the amplitude is stationary, by its size."""
    if model.laws.any:
        return dissipated.stationary_at(model, A)
    at = np.array([A])
    if not model.inertial:
        return stationary_abreast(model, at, np.zeros(1, np.intp))[1]
    falls, Omega = inertia.falls_to_least(model, at, model.averaged(at)[0])
    return np.asarray(Omega[falls])


def stationary_abreast(model: Model, A: Floats, of: Ints) -> tuple[Ints, Floats]:
    """The same, as `frequencies_abreast`."""
    if model.inertial or model.laws.any:
        Omega = stationary_at(model, float(A[0]))
        return np.zeros(Omega.size, np.intp), Omega
    own = model.take(of)
    return _counted(of, peak_roots(A, own.averaged(A)[0], own.m, own.zeta))


def _counted(of: Ints, found: tuple[Floats, Counts]) -> tuple[Ints, Floats]:
    roots, count = found
    which, place = (np.arange(roots.shape[1]) < count[:, np.newaxis]).nonzero()
    return of[which], roots[which, place]
