"""Den Hartog's exact solution of the linear oscillator with dry friction, without stops.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/den_hartog.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless. Arguments broadcast; outputs have their common shape, NumPy scalars for scalars. Each
docstring gives equation number, domain and the operations after each pass.
"""

import numpy as np

from slowflow_kernels._broadcast import floats

__all__ = [
    "S_ratio",
    "U",
    "V",
    "amplitude",
    "bound",
    "motion",
]


def V(Omega):
    """Response function.

    Equation (37). Domain: Omega > 0, Omega != 1.
    Operations: 3 structured, 3 common subexpressions, 3 power chains.
    """
    (Omega,) = floats(Omega)
    return -1.0 / ((Omega - 1.0) * (Omega + 1.0))


def U(Omega):
    """Damping function.

    Equation (37). Domain: Omega > 0, Omega != 1, 1/3, 1/5, ....
    Operations: 3 structured, 3 common subexpressions, 3 power chains.
    """
    (Omega,) = floats(Omega)
    t0 = 1.0 / Omega
    return t0 * np.tan(1.5707963267948966 * t0)


def S_ratio(tau, Omega):
    """S is the maximum of this over 0 < tau < pi/Omega.

    Equation (37). Domain: 0 < tau < pi/Omega, Omega > 0, Omega != 1, 1/3, 1/5, ....
    Operations: 21 structured, 20 common subexpressions, 20 power chains.
    """
    tau, Omega = floats(tau, Omega)
    t0 = 1.0 / Omega
    U = t0 * np.tan(1.5707963267948966 * t0)
    t1 = 0.5 * tau
    return (
        Omega * (-2.0 * Omega * U * np.sin(t1 * (Omega - 1.0)) * np.sin(t1 * (Omega + 1.0)) + np.sin(tau)) /
        (np.sin(Omega * tau))
    )


def amplitude(Omega, F_0, mu):
    """Amplitude of the motion.

    Equation (35). Domain: F_0 |V| > mu |U|, Omega > 0, Omega != 1, 1/3, 1/5, ....
    Operations: 14 structured, 12 common subexpressions, 12 power chains.
    """
    Omega, F_0, mu = floats(Omega, F_0, mu)
    V = -1.0 / ((Omega - 1.0) * (Omega + 1.0))
    t0 = 1.0 / Omega
    U = t0 * np.tan(1.5707963267948966 * t0)
    t1 = F_0 * V
    t2 = U * mu
    return np.sqrt((t1 - t2) * (t1 + t2))


def bound(Omega, F_0, S):
    """The motion has no stops while its amplitude exceeds this.

    Equation (36). Domain: Omega > 0, Omega != 1, 1/3, 1/5, ....
    Operations: 19 structured, 19 common subexpressions, 18 power chains.
    """
    Omega, F_0, S = floats(Omega, F_0, S)
    V = -1.0 / ((Omega - 1.0) * (Omega + 1.0))
    t0 = 1.0 / Omega
    U = t0 * np.tan(1.5707963267948966 * t0)
    Omega2 = Omega * Omega
    Omega4 = Omega2 * Omega2
    return F_0 * np.abs(S) * np.abs(V) / (np.sqrt(Omega4 * U * U + S * S))


def motion(tau, Omega, A, mu):
    """Displacement tau after a maximum.

    Equation from (37). Domain: 0 <= tau <= pi/Omega, Omega > 0, Omega != 1, 1/3, 1/5, ....
    Operations: 20 structured, 18 common subexpressions, 18 power chains.
    """
    tau, Omega, A, mu = floats(tau, Omega, A, mu)
    t0 = 1.0 / Omega
    U = t0 * np.tan(1.5707963267948966 * t0)
    t1 = Omega * tau
    t2 = U * mu
    return A * np.cos(t1) - Omega * t2 * np.sin(tau) - mu * np.cos(tau) + mu + t2 * np.sin(t1)
