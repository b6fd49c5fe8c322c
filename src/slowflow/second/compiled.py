"""Answers of the second approximation on the compiled solvers: the same functions as in `reference`."""

from __future__ import annotations

import numpy as np

from slowflow import backend
from slowflow.model import Floats
from slowflow.results import FrequencyResponse
from slowflow.second.balance import Balance
from slowflow.second.found import Curve, Fold, State, told
from slowflow_kernels.conventions import Status
from slowflow_kernels.second_conventions import Wanted


def serves(balance: Balance) -> bool:
    """Whether the compiled solvers have the model with its harmonics."""
    native = balance.model.native
    return native is not None and not balance.model.inertial and backend.solver().has_second(native)


def follow(balance: Balance, first: FrequencyResponse, wanted: Wanted = Wanted.EVERY_POINT) -> Curve:
    """The curve that the first approximation's moves to, as far as it is wanted."""
    closed = np.array(first.isola, dtype=bool)
    found = backend.solver().second_follow(
        *(balance.model.native, first.F_0, wanted, first.Omega, first.A, first.branch, closed)
    )
    Omega, A, u_max, A_1, phi, stable, part = (
        found[name] for name in ("Omega", "A", "u_max", "A_1", "phi", "stable", "part")
    )
    isola = tuple(found["closed"].tolist())
    return Curve(Omega, A, u_max, A_1, phi, stable, part, isola, told(first, *found["lost"]), found["curve"])


def folds(balance: Balance, curve: Curve, F_0: float) -> tuple[list[Fold], int, int]:
    """Every fold between points of the curve, by rising Omega; how many were not found, of how many."""
    status, found, lost, tried = backend.solver().second_folds(balance.model.native, F_0, curve.native)
    if status != Status.OK:
        raise ArithmeticError(f"the response is unresolved at F_0 = {F_0:.17g}")
    folds_found = [Fold(Omega, u_max, A_1, up != 0, corner != 0) for Omega, u_max, A_1, up, corner in found]
    return folds_found, lost, tried


def states(balance: Balance, curve: Curve, Omega: Floats, F_0: float) -> list[State]:
    """Every state where the curve passes one of the frequencies, by their order, then by rising A."""
    found = backend.solver().second_states(balance.model.native, F_0, curve.native, Omega)
    return [State(Omega, u_max, A_1, phi, stable != 0) for Omega, u_max, A_1, phi, stable in found]


def peak(balance: Balance, curve: Curve, F_0: float) -> tuple[float, float] | None:
    """The highest point between points of the curve, u_max and its Omega."""
    status, u_max, Omega = backend.solver().second_peak(balance.model.native, F_0, curve.native)
    return (u_max, Omega) if status == Status.OK else None


def cusp(balance: Balance, F_SN: float, Omega: float, A: float) -> tuple[float, float, float] | None:
    """The cusp that averaging's moves to: F_SN, Omega, u_max."""
    status, *found = backend.solver().second_onset(balance.model.native, F_SN, Omega, A)
    return (found[0], found[1], found[2]) if status == Status.OK else None


def detachment(balance: Balance, F_cr: float, Omega_cr: float, u_cr: float) -> tuple[float, float] | None:
    """The lowest forcing whose largest displacement is u_cr, and its frequency, beside averaging's."""
    status, *found = backend.solver().second_detachment(balance.model.native, F_cr, Omega_cr, u_cr)
    return (found[0], found[1]) if status == Status.OK else None
