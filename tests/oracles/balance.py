"""The balance of the second approximation. Takes a slow flow, Omega and A; returns the generated kernels' values.

A is A_1 + a_3 + a_5 here, as in `slowflow_kernels.second_approximation`; friction's harmonics take a little off it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

from slowflow.core.model import Floats, Model
from slowflow_kernels import inertia
from slowflow_kernels import second_approximation as kernels


class Values(NamedTuple):
    """Largest displacement, first harmonic's amplitude and phase; R, F and their derivatives."""

    u_max: Floats
    A_1: Floats
    phi: Floats
    R: Floats
    F: Floats
    F_A: Floats
    F_Omega: Floats
    R_A: Floats
    R_Omega: Floats


@dataclass(frozen=True)
class Balance:
    """The kernels of the second approximation with a slow flow's numbers put in; arrays broadcast."""

    model: Model

    def averages(self, A: Any) -> tuple[Floats, ...]:
        """h, h_3 and h_5, each with two derivatives."""
        h, h_A, h_AA, _ = self.model.averaged(A)
        h_3, h_3_A, h_3_AA, _, h_5, h_5_A, h_5_AA, _ = self.model.harmonics(A)
        return h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA

    def response(self, Omega: Any, A: Any, F_0: float) -> Values:
        """What a response curve needs."""
        force = self.model.force(F_0, Omega)
        found = Values(*kernels.response(Omega, A, force, self.model.m, self.model.zeta, *self.averages(A)))
        if not self.model.inertial:
            return found
        return found._replace(F_Omega=found.F_Omega - 2 * force * inertia.force_slopes(Omega, F_0)[0])

    def detachment(self, Omega: Any, A: Any) -> tuple[Floats, ...]:
        """The forcing for which that is a steady state, u_max, turning"""
        of = kernels.detachment_by_inertia if self.model.inertial else kernels.detachment
        values: tuple[Floats, ...] = of(Omega, A, self.model.m, self.model.zeta, *self.averages(A))
        return values

    def folds(self, Omega: Any, A: Any, F_0: Any) -> tuple[Floats, ...]:
        """F, F_A, F_AA"""
        m, zeta = self.model.m, self.model.zeta
        values: tuple[Floats, ...] = kernels.folds(
            Omega, A, self.model.force(F_0, Omega), m, zeta, *self.model.averaged(A), *self.model.harmonics(A)
        )
        return values
