"""Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance.

Written by `make derive` from derivations/paper/equation_of_motion.py, derivations/paper/averaging.py,
derivations/paper/slow_flow.py, derivations/extensions/inertia.py; never edit.

Rounding errors were measured with A 0.01 to 1; F_0 0.03 to 0.1; Omega 0.3 to 2; cubic, other up to 1 of either
sign; fall, rest 0.001 to 1; force, holds 0.001 to 0.1; h 0.001 to 1 of either sign; h_A up to 2 of either sign;
h_AA up to 5 of either sign; h_AAA up to 20 of either sign; k 0.04 to 4; linear 0.0001 to 0.03; lost 0.001 to 0.5; m
0.001 to 0.03; reduction 0.01 to 0.999; share up to 0.5 of either sign; x 0.5 to 3; zeta 0.004 to 0.1.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.support.backend import NATIVE, compiled, from_c
from slowflow.support.broadcast import floats

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "F", "Omega_A", "Omega_of_share", "amplitude", "bound", "cusp_bend", "fold_force", "fold_level", "fold_slopes",
    "force", "force_slopes", "hessian", "isola", "isola_apart", "isolation", "least", "least_Omega_A", "level",
    "level_slope", "moves_from", "peak", "peak_share", "share", "terms",
]


def force(Omega: ArrayLike, F_0: ArrayLike) -> Any:
    """Amplitude of the force on the mass.

    Equation beside (3). Domain: Omega >= 0. Operations: 2. Error / u (1 + kappa): proved 0.51.
    """
    Omega, F_0 = floats(Omega, F_0)
    return F_0 * Omega * Omega


def amplitude(Omega: Any, force: Any) -> Any:
    """The F_0 of a force at one frequency.

    Equation beside (3). Domain: Omega > 0. Operations: 2. Error / u (1 + kappa): proved 0.51.
    """
    Omega, force = floats(Omega, force)
    return force / (Omega * Omega)


def moves_from(F_0: Any, holds: Any) -> Any:
    """The Omega from which on the force exceeds what holds a mass at rest, 4 mu/pi on the average.

    Equation beside (3). Domain: F_0 > 0, holds >= 0. Operations: 2. Error / u (1 + kappa): measured 0.61.
    """
    F_0, holds = floats(F_0, holds)
    turn = holds / F_0
    return np.sqrt(turn)


def isolation(A: ArrayLike, F_0: ArrayLike, reduction: ArrayLike, h: ArrayLike) -> Any:
    """Frequency of a state that transmits sqrt(1 - reduction) of what drives it, though it moves.

    Equation from (23). Domain: A > F_0 sqrt(reduction), 0 <= reduction < 1, h <= 0. Operations: 8. Error / u (1 +
    kappa): measured 0.78.
    """
    A, F_0, reduction, h = floats(A, F_0, reduction, h)
    removed = F_0 * np.sqrt(reduction)
    turn = -2.0 * h / (A - removed * removed / A)
    return np.sqrt(turn)


def level(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Any:
    """The amplitude F_0 of the excitation for which (Omega, A) is a steady state.

    Equation from (24). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): measured 1.3.
    """
    Omega, A, m, zeta, h = floats(Omega, A, m, zeta, h)
    t0 = Omega * Omega
    R = A * t0 + h
    I = 2.0 * A * Omega * zeta + m
    return np.sqrt(I * I + R * R) / t0


def F(Omega: ArrayLike, A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Any:
    """Zero at a steady state.

    Equation from (24). Domain: Omega > 0, A > 0. Operations: 13. Error / u (1 + kappa): measured 0.81.
    """
    Omega, A, F_0, m, zeta, h = floats(Omega, A, F_0, m, zeta, h)
    t0 = Omega * Omega
    R = A * t0 + h
    I = 2.0 * A * Omega * zeta + m
    t1 = F_0 * t0
    return R * R + (I - t1) * (I + t1)


if NATIVE is not None:
    globals().update(compiled(globals(), NATIVE.inertia()))
#: functions that no Python code calls, which are in C, with their arguments; see generated/c/inertia.h
FROM_C = {
    "force_slopes": "Omega F_0",
    "level_slope": "Omega A m zeta h",
    "Omega_A": "Omega A m zeta h h_A",
    "terms": "A m zeta h",
    "least": "fall linear rest",
    "least_Omega_A": "x A m zeta h h_A",
    "peak": "x A F_0 m zeta h h_A",
    "isola": "x A m zeta h h_A h_AA",
    "isola_apart": "x A m zeta h k cubic",
    "fold_slopes": "Omega A m zeta k",
    "fold_force": "Omega A m zeta other",
    "fold_level": "Omega A m zeta other",
    "peak_share": "Omega A m zeta",
    "Omega_of_share": "A F_0 m zeta share",
    "cusp_bend": "Omega A m zeta h h_A h_AA h_AAA",
    "hessian": "Omega A m zeta h h_A h_AA",
    "bound": "A F_0 zeta h h_A h_AA h_AAA lost",
    "share": "A zeta h",
}
globals().update(from_c("inertia", FROM_C))
