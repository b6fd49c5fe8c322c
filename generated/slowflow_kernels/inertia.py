"""Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/oscillator.py, derivations/averaging.py, derivations/slow_flow.py, derivations/inertia.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless. Arguments broadcast; outputs have their common shape, NumPy scalars for scalars. Each
docstring gives equation number, domain and the operations after each pass.
"""

# a formatter would spread each polynomial over a page
# fmt: off

import numpy as np

from slowflow_support.backend import NATIVE, compiled
from slowflow_support.broadcast import floats, full

__all__ = [
    "F",
    "Omega_A",
    "bound",
    "cusp_bend",
    "force",
    "hessian",
    "isola",
    "least",
    "level",
    "level_rise",
    "level_slope",
    "peak",
    "terms",
]


def force(Omega, F_0):
    """Amplitude of the force on the mass.

    Equation beside (3). Domain: Omega >= 0.
    Operations: 2 structured, 2 common subexpressions, 2 power chains.
    """
    Omega, F_0 = floats(Omega, F_0)
    return F_0 * Omega * Omega


def level(Omega, A, m, zeta, h):
    """The amplitude F_0 of the excitation for which (Omega, A) is a steady state.

    Equation from (24). Domain: Omega > 0, A > 0.
    Operations: 13 structured, 12 common subexpressions, 12 power chains.
    """
    Omega, A, m, zeta, h = floats(Omega, A, m, zeta, h)
    t0 = Omega * Omega
    R = A * t0 + h
    I = 2.0 * A * Omega * zeta + m
    return np.sqrt(I * I + R * R) / t0


def F(Omega, A, F_0, m, zeta, h):
    """Zero at a steady state.

    Equation from (24). Domain: Omega > 0, A > 0.
    Operations: 16 structured, 13 common subexpressions, 13 power chains.
    """
    Omega, A, F_0, m, zeta, h = floats(Omega, A, F_0, m, zeta, h)
    t0 = Omega * Omega
    R = A * t0 + h
    I = 2.0 * A * Omega * zeta + m
    t1 = F_0 * t0
    return R * R + (I - t1) * (I + t1)


def level_slope(Omega, A, m, zeta, h):
    """Omega^5 times the derivative of level^2 by Omega.

    Equation from (24). Domain: Omega > 0, A > 0.
    Operations: 15 structured, 13 common subexpressions, 13 power chains.
    """
    Omega, A, m, zeta, h = floats(Omega, A, m, zeta, h)
    R = A * Omega * Omega + h
    t0 = A * Omega * zeta
    I = m + 2.0 * t0
    return -4.0 * I * (m + t0) - 4.0 * R * h


def Omega_A(Omega, A, m, zeta, h, h_A):
    """dOmega/dA along the response.

    Equation from (24). Domain: Omega > 0, A > 0.
    Operations: 25 structured, 21 common subexpressions, 21 power chains.
    """
    Omega, A, m, zeta, h, h_A = floats(Omega, A, m, zeta, h, h_A)
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = Omega * zeta
    t2 = A * t1
    I = m + 2.0 * t2
    return -2.0 * Omega * (2.0 * I * t1 + R * (h_A + t0)) / (-4.0 * I * (m + t2) - 4.0 * R * h)


def terms(A, m, zeta, h):
    """What the least level of an amplitude follows from; it has one where the first, fall, is positive.

    Equation from (24). Domain: A > 0.
    Operations: 11 structured, 11 common subexpressions, 11 power chains.
    """
    A, m, zeta, h = floats(A, m, zeta, h)
    arguments = (A, m, zeta, h)
    return (
        full(-A * (2.0 * A * zeta * zeta + h), arguments),
        full(12.0 * A * m * zeta, arguments),
        full(h * h + m * m, arguments),
    )


def least(fall, linear, rest):
    """x = 1/Omega where the level of an amplitude is least, by its `terms`.

    Equation from (24). Domain: fall > 0, linear >= 0, rest > 0.
    Operations: 8 structured, 8 common subexpressions, 8 power chains.
    """
    fall, linear, rest = floats(fall, linear, rest)
    return 8.0 * fall / (linear + np.sqrt(64.0 * fall * rest + linear * linear))


def peak(x, A, F_0, m, zeta, h, h_A):
    """The least level of an amplitude less F_0, and its slope along A.

    Equation from (24). Domain: x of `least`, h < 0.
    Operations: 23 structured, 19 common subexpressions, 19 power chains.
    """
    x, A, F_0, m, zeta, h, h_A = floats(x, A, F_0, m, zeta, h, h_A)
    t0 = A * zeta
    t1 = m * x
    drag = t0 + t1
    share = drag / h
    t2 = x * x
    root = np.sqrt(share * share + t2)
    arguments = (x, A, F_0, m, zeta, h, h_A)
    return (
        full(-F_0 + root * (2.0 * t0 + t1), arguments),
        full((-share * (h_A * t2 + 1.0) + 2.0 * t2 * zeta) / root, arguments),
    )


def isola(x, A, m, zeta, h, h_A, h_AA):
    """Has the sign of F_A where an amplitude's level is least: zero at an isola point; its slope along A.

    Equation from (24), (30). Domain: x of `least`, h < 0.
    Operations: 73 structured, 50 common subexpressions, 50 power chains.
    """
    x, A, m, zeta, h, h_A, h_AA = floats(x, A, m, zeta, h, h_A, h_AA)
    t0 = A * zeta
    t1 = m * x
    t2 = t0 + t1
    t3 = x * x
    t4 = h * t3
    t5 = 2.0 * zeta
    t6 = h_A * t3
    t7 = t6 + 1.0
    t8 = 8.0 * x
    t9 = 4.0 * h
    arguments = (x, A, m, zeta, h, h_A, h_AA)
    return (
        full(t2 * t7 - t4 * t5, arguments),
        h_AA * t2 * t3 - t5 * t6 + t7 * zeta - (2.0 * h_A * t2 * x + m * t7 - t9 * x * zeta) * (-16.0 * A * zeta *
        zeta + h_A * (-4.0 * A - 8.0 * t4) - 12.0 * t1 * zeta - t9) / (-h * h * t8 - m * m * t8 - 12.0 * m * t0),
    )


def level_rise(Omega, A, m, zeta, h, h_A, h_AA):
    """Positive where the level rises with A along the fold locus, negative where it falls.

    Equation from (24), (30). Domain: Omega > 0, A > 0.
    Operations: 41 structured, 32 common subexpressions, 32 power chains.
    """
    Omega, A, m, zeta, h, h_A, h_AA = floats(Omega, A, m, zeta, h, h_A, h_AA)
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = A * Omega
    t2 = t1 * zeta
    I = m + 2.0 * t2
    t3 = h_A + t0
    t4 = zeta * zeta
    return (
        8.0 * (4.0 * I * (m + t2) + 4.0 * R * h) * (R * h_AA + 4.0 * t0 * t4 + t3 * t3) * (I * zeta + Omega * R + t1
        * t3 + 2.0 * t1 * t4)
    )


def cusp_bend(Omega, A, m, zeta, h, h_A, h_AA, h_AAA):
    """Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum.

    Equation from (24), (30). Domain: Omega > 0, A > 0.
    Operations: 37 structured, 30 common subexpressions, 30 power chains.
    """
    Omega, A, m, zeta, h, h_A, h_AA, h_AAA = floats(Omega, A, m, zeta, h, h_A, h_AA, h_AAA)
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = A * Omega
    t2 = t1 * zeta
    I = m + 2.0 * t2
    t3 = h_A + t0
    return (
        8.0 * (4.0 * I * (m + t2) + 4.0 * R * h) * (R * h_AAA + 3.0 * h_AA * t3) * (I * zeta + Omega * R + t1 * t3 +
        2.0 * t1 * zeta * zeta)
    )


def hessian(Omega, A, m, zeta, h, h_A, h_AA):
    """At an isola point: negative where the level has a saddle in (A, Omega).

    Equation from (24), (30). Domain: Omega > 0, A > 0.
    Operations: 47 structured, 36 common subexpressions, 36 power chains.
    """
    Omega, A, m, zeta, h, h_A, h_AA = floats(Omega, A, m, zeta, h, h_A, h_AA)
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = A * Omega
    t2 = 2.0 * t1
    I = m + t2 * zeta
    t3 = zeta * zeta
    t4 = h_A + t0
    t5 = 4.0 * t3
    t6 = I * zeta + Omega * R + t1 * t4 + t2 * t3
    return (
        -8.0 * A * (2.0 * Omega * h + 3.0 * m * zeta + t1 * t5) * (R * h_AA + t0 * t5 + t4 * t4) / Omega - 16.0 * t6
        * t6
    )


def bound(A, F_0, zeta, h, h_A, h_AA, h_AAA, lost):
    """Positive where no state has an amplitude A > F_0, if zeta^2 A <= lost |h|; three derivatives by A.

    Equation from (24). Domain: A > 0, h < 0, lost <= 1/2.
    Operations: 34 structured, 21 common subexpressions, 20 power chains.
    """
    A, F_0, zeta, h, h_A, h_AA, h_AAA, lost = floats(A, F_0, zeta, h, h_A, h_AA, h_AAA, lost)
    t0 = F_0 * F_0
    t1 = zeta * zeta * (1.0 - lost)
    t2 = 24.0 * t1
    A2 = A * A
    A3 = A * A2
    arguments = (A, F_0, zeta, h, h_A, h_AA, h_AAA, lost)
    return (
        full(4.0 * A3 * t1 + h * t0, arguments),
        full(12.0 * A2 * t1 + h_A * t0, arguments),
        full(A * t2 + h_AA * t0, arguments),
        full(h_AAA * t0 + t2, arguments),
    )


if NATIVE is not None:
    (
        force,
        level,
        F,
        level_slope,
        Omega_A,
        terms,
        least,
        peak,
        isola,
        level_rise,
        cusp_bend,
        hessian,
        bound,
    ) = compiled(
        (force, level, F, level_slope, Omega_A, terms, least, peak, isola, level_rise, cusp_bend, hessian, bound,),
        NATIVE.inertia(),
    )
