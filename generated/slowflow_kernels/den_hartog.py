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
    Operations: 2 structured, 2 common subexpressions, 2 power chains.
    """
    (Omega,) = floats(Omega)
    return -1.0 / ((Omega * Omega - 1.0))


def U(Omega):
    """Damping function.

    Equation (37). Domain: Omega > 0, Omega != 1, 1/3, 1/5, ....
    Operations: 7 structured, 6 common subexpressions, 6 power chains.
    """
    (Omega,) = floats(Omega)
    t0 = 3.1415926535897931 / Omega
    return np.sin(t0) / ((Omega * np.cos(t0) + Omega))


def S_ratio(tau, Omega):
    """S is the maximum of this over 0 < tau < pi/Omega.

    Equation (37). Domain: 0 < tau < pi/Omega, Omega > 0, Omega != 1, 1/3, 1/5, ....
    Operations: 21 structured, 18 common subexpressions, 18 power chains.
    """
    tau, Omega = floats(tau, Omega)
    t0 = 3.1415926535897931 / Omega
    U = np.sin(t0) / ((Omega * np.cos(t0) + Omega))
    t1 = Omega * tau
    t2 = Omega * U
    return Omega * (t2 * np.cos(t1) - t2 * np.cos(tau) + np.sin(tau)) / np.sin(t1)


def amplitude(Omega, F_0, mu):
    """Amplitude of the motion.

    Equation (35). Domain: F_0 |V| > mu |U|, Omega > 0, Omega != 1, 1/3, 1/5, ....
    Operations: 17 structured, 16 common subexpressions, 16 power chains.
    """
    Omega, F_0, mu = floats(Omega, F_0, mu)
    V = -1.0 / ((Omega * Omega - 1.0))
    t0 = 3.1415926535897931 / Omega
    U = np.sin(t0) / ((Omega * np.cos(t0) + Omega))
    return np.sqrt(F_0 * F_0 * V * V - U * U * mu * mu)


def bound(Omega, F_0, S):
    """The motion has no stops while its amplitude exceeds this.

    Equation (36). Domain: Omega > 0, Omega != 1, 1/3, 1/5, ....
    Operations: 22 structured, 21 common subexpressions, 19 power chains.
    """
    Omega, F_0, S = floats(Omega, F_0, S)
    Omega2 = Omega * Omega
    V = -1.0 / (Omega2 - 1.0)
    t0 = 3.1415926535897931 / Omega
    U = np.sin(t0) / ((Omega * np.cos(t0) + Omega))
    Omega4 = Omega2 * Omega2
    return F_0 * np.abs(S) * np.abs(V) / (np.sqrt(Omega4 * U * U + S * S))


def motion(tau, Omega, A, mu):
    """Displacement tau after a maximum.

    Equation from (37). Domain: 0 <= tau <= pi/Omega, Omega > 0, Omega != 1, 1/3, 1/5, ....
    Operations: 24 structured, 21 common subexpressions, 21 power chains.
    """
    tau, Omega, A, mu = floats(tau, Omega, A, mu)
    t0 = 3.1415926535897931 / Omega
    U = np.sin(t0) / ((Omega * np.cos(t0) + Omega))
    t1 = Omega * tau
    t2 = U * mu
    return A * np.cos(t1) - Omega * t2 * np.sin(tau) - mu * np.cos(tau) + mu + t2 * np.sin(t1)
