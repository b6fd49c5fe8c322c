"""Den Hartog's exact solution of the linear oscillator with dry friction, without stops.

Written by `make derive` from derivations/paper/den_hartog.py; never edit.

Rounding errors were measured with A 0.01 to 1; F_0 0.03 to 0.1; Omega 0.3 to 2; S 0.5 to 2; mu 0.001 to 0.02; tau
1e-09 to 30.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.support.backend import NATIVE, compiled
from slowflow.support.broadcast import floats

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "S_ratio", "U", "V", "amplitude", "bound", "motion",
]


def V(Omega: ArrayLike) -> Any:
    """Response function.

    Equation (37). Domain: Omega > 0, Omega != 1. Operations: 3. Error / u (1 + kappa): measured 1.4.
    """
    (Omega,) = floats(Omega)
    return -1.0 / ((Omega - 1.0) * (Omega + 1.0))


def U(Omega: ArrayLike) -> Any:
    """Damping function.

    Equation (37). Domain: Omega > 0, Omega not 1, 1/3, 1/5 and so on. Operations: 6. Error / u (1 + kappa):
    measured 1.4.
    """
    (Omega,) = floats(Omega)
    t0 = 1.0 / Omega
    return t0 / np.tan(1.5707963267948966 * t0 * (Omega - 1.0))


def S_ratio(tau: ArrayLike, Omega: ArrayLike) -> Any:
    """S is the maximum of this over 0 < tau < pi/Omega.

    Equation (37). Domain: 0 < tau < pi/Omega, Omega > 0, Omega not 1, 1/3, 1/5 and so on. Operations: 23. Error / u
    (1 + kappa): measured 3.9.
    """
    tau, Omega = floats(tau, Omega)
    t0 = 1.0 / Omega
    t1 = Omega - 1.0
    U = t0 / np.tan(1.5707963267948966 * t0 * t1)
    t2 = 0.5 * tau
    return (
        (-2.0 * Omega * Omega * U * np.sin(t1 * t2) * np.sin(t2 * (Omega + 1.0)) + Omega * np.sin(tau)) /
        np.sin(Omega * tau)
    )


def amplitude(Omega: ArrayLike, F_0: ArrayLike, mu: ArrayLike) -> Any:
    """Amplitude of the motion.

    Equation (35). Domain: F_0 |V| > mu |U|, Omega > 0, Omega not 1, 1/3, 1/5 and so on. Operations: 14. Error / u
    (1 + kappa): measured 1.5.
    """
    Omega, F_0, mu = floats(Omega, F_0, mu)
    t0 = Omega - 1.0
    V = -1.0 / (t0 * (Omega + 1.0))
    t1 = 1.0 / Omega
    U = t1 / np.tan(1.5707963267948966 * t0 * t1)
    t2 = F_0 * V
    t3 = U * mu
    return np.sqrt((t2 - t3) * (t2 + t3))


def bound(Omega: ArrayLike, F_0: ArrayLike, S: ArrayLike) -> Any:
    """The motion has no stops while its amplitude exceeds this.

    Equation (36). Domain: Omega > 0, Omega not 1, 1/3, 1/5 and so on. Operations: 20. Error / u (1 + kappa):
    measured 1.9.
    """
    Omega, F_0, S = floats(Omega, F_0, S)
    t0 = Omega - 1.0
    V = -1.0 / (t0 * (Omega + 1.0))
    t1 = 1.0 / Omega
    U = t1 / np.tan(1.5707963267948966 * t0 * t1)
    Omega2 = Omega * Omega
    Omega4 = Omega2 * Omega2
    return F_0 * np.abs(S) * np.abs(V) / np.sqrt(Omega4 * U * U + S * S)


def motion(tau: ArrayLike, Omega: ArrayLike, A: ArrayLike, mu: ArrayLike) -> Any:
    """Displacement tau after a maximum.

    Equation from (37). Domain: 0 <= tau <= pi/Omega, Omega > 0, Omega not 1, 1/3, 1/5 and so on. Operations: 27.
    Error / u (1 + kappa): measured 1.7.
    """
    tau, Omega, A, mu = floats(tau, Omega, A, mu)
    t0 = 1.0 / Omega
    t1 = Omega - 1.0
    U = t0 / np.tan(1.5707963267948966 * t0 * t1)
    t2 = Omega * tau
    t3 = 0.5 * tau
    return (
        A * np.cos(t2) + U * mu * (-t1 * np.sin(tau) + 2.0 * np.sin(t1 * t3) * np.cos(0.5 * t2 + t3)) - mu *
        np.cos(tau) + mu
    )


if NATIVE is not None:
    globals().update(compiled(globals(), NATIVE.den_hartog()))
