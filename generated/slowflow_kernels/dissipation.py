"""Structural and quadratic damping, and dry friction of what is attached.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/averaging.py, derivations/slow_flow.py, derivations/dissipation.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless, for any kind of number that has arithmetic: floats, complex numbers, arrays, an integrator's
symbols. Each docstring gives equation number, domain and the operations after each pass.
"""

# a formatter would spread each polynomial over a page
# fmt: off

import numpy as np


__all__ = [
    "F_A",
    "F_AA",
    "F_AOmega",
    "F_AOmegaOmega",
    "F_Omega",
    "F_OmegaOmega",
    "I",
    "Omega_A",
    "at_rest",
    "cusps",
    "fold_quartic",
    "folds",
    "isolas",
    "limit_envelope",
    "peaks",
    "quadratic",
    "released",
    "resistance",
    "response_quartic",
    "rest",
    "restoring",
    "stability",
    "stiffness",
    "turn_share",
    "turns",
]


def quadratic(c_2):
    """Quadratic damping's factor of A^2 Omega^2 in I.

    Equation from (19). Domain: any.
    Operations: 1 structured, 1 common subexpressions, 1 power chains.
    """
    return 0.84882636315677518 * c_2


def restoring(A, F_0, d):
    """The largest |h| of a state with this amplitude, as quadratic damping bounds its frequency.

    Equation from (23). Domain: A > 0, d > 0.
    Operations: 3 structured, 3 common subexpressions, 3 power chains.
    Proved, error / u (1 + kappa): 2.01
    """
    return F_0 + F_0 / (A * d)


def resistance(v, zeta, friction, quadratic):
    """Friction and quadratic damping, both times the sign of u'; and the zeta of the slope of all by u'.

    Equation (3). Domain: any.
    Operations: 5 structured, 5 common subexpressions, 5 power chains.
    Proved, error / u (1 + kappa): 1.01, 1.01
    """
    return (
        friction + quadratic * v * v,
        quadratic * v + zeta,
    )


def at_rest(A, m, eta):
    """I_0, I at Omega = 0, and three derivatives by A: friction acts throughout.

    Equation from (19). Domain: A > 0.
    Operations: 2 structured, 2 common subexpressions, 2 power chains.
    Proved, error / u (1 + kappa): 1.01, 0.0, 0.0, 0.0
    """
    return (
        A * eta + m,
        eta,
        0.0,
        0.0,
    )


def released(A, m, eta, u_cr):
    """The same where friction acts for |u| < u_cr only.

    Equation from (19). Domain: A >= u_cr > 0.
    Operations: 19 structured, 16 common subexpressions, 13 power chains.
    Proved, error / u (1 + kappa): 1.01, 1.01, 0.67, 0.86
    """
    t0 = m * u_cr
    A2 = A * A
    A3 = A * A2
    A4 = A2 * A2
    return (
        A * eta + t0 / A,
        eta - t0 / A2,
        2.0 * t0 / A3,
        -6.0 * t0 / A4,
    )


def I(Omega, A, I_0, zeta, d):  # noqa: E743
    """Sine balance, -F_0 sin phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0.
    Operations: 9 structured, 9 common subexpressions, 9 power chains.
    Proved, error / u (1 + kappa): 4.01
    """
    return A * A * Omega * Omega * d + 2.0 * A * Omega * zeta + I_0


def F_A(Omega, A, I_0, I_0A, zeta, d, h, h_A):
    """dF/dA; positive where stable.

    Equation (24), (30). Domain: Omega > 0, A > 0.
    Operations: 26 structured, 20 common subexpressions, 20 power chains.
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = 2.0 * Omega * zeta
    I = A * A * d * t0 + A * t2 + I_0
    return 2.0 * (I * (I_0A + 2.0 * d * t1 + t2) + R * (h_A + t0))


def F_AA(Omega, A, I_0, I_0A, I_0AA, zeta, d, h, h_A, h_AA):
    """d2F/dA2.

    Equation (24). Domain: Omega > 0, A > 0.
    Operations: 35 structured, 27 common subexpressions, 27 power chains.
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = 2.0 * Omega * zeta
    t3 = d * t0
    I = A * A * t3 + A * t2 + I_0
    t4 = h_A + t0
    t5 = I_0A + 2.0 * d * t1 + t2
    return 2.0 * (I * I_0AA + 2.0 * I * t3 + R * h_AA + t4 * t4 + t5 * t5)


def F_Omega(Omega, A, I_0, zeta, d, h):
    """dF/dOmega.

    Equation (24). Domain: Omega > 0, A > 0.
    Operations: 20 structured, 18 common subexpressions, 18 power chains.
    """
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = A * Omega
    I = A * A * d * t0 + I_0 + 2.0 * t1 * zeta
    return 4.0 * A * (I * (d * t1 + zeta) + Omega * R)


def F_OmegaOmega(Omega, A, I_0, zeta, d, h):
    """d2F/dOmega2.

    Equation (24). Domain: Omega > 0, A > 0.
    Operations: 28 structured, 23 common subexpressions, 23 power chains.
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = 2.0 * A
    I = A * A * d * t0 + I_0 + Omega * t2 * zeta
    t3 = A * d
    t4 = Omega * t3 + zeta
    return 4.0 * A * (I * t3 + R + 2.0 * t1 + t2 * t4 * t4)


def F_AOmega(Omega, A, I_0, I_0A, zeta, d, h, h_A):
    """d2F/dA dOmega.

    Equation (24). Domain: Omega > 0, A > 0.
    Operations: 39 structured, 30 common subexpressions, 30 power chains.
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = A * Omega
    t3 = 2.0 * zeta
    I = A * A * d * t0 + I_0 + t2 * t3
    t4 = d * t2
    return (
        4.0 * (A * (t4 + zeta) * (I_0A + Omega * t3 + 2.0 * d * t1) + I * (2.0 * t4 + zeta) + Omega * R + t2 * (h_A
        + t0))
    )


def F_AOmegaOmega(Omega, A, I_0, I_0A, zeta, d, h, h_A):
    """d3F/dA dOmega2.

    Equation (24). Domain: Omega > 0, A > 0.
    Operations: 48 structured, 35 common subexpressions, 35 power chains.
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = 2.0 * Omega
    t3 = t2 * zeta
    t4 = A * A * d
    I = A * t3 + I_0 + t0 * t4
    t5 = A * d
    return (
        4.0 * (A * (h_A + t0) + 4.0 * A * (Omega * t5 + zeta) * (t2 * t5 + zeta) + 2.0 * I * t5 + R + 4.0 * t1 + t4
        * (I_0A + 2.0 * d * t1 + t3))
    )


def Omega_A(Omega, A, I_0, I_0A, zeta, d, h, h_A):
    """dOmega/dA along the response.

    Equation from (24). Domain: Omega > 0, A > 0.
    Operations: 40 structured, 31 common subexpressions, 31 power chains.
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = 2.0 * zeta
    t3 = A * t2
    t4 = A * A * d
    I = I_0 + Omega * t3 + t0 * t4
    return (
        -2.0 * (I * (I_0A + Omega * t2 + 2.0 * d * t1) + R * (h_A + t0)) / (4.0 * A * Omega * R + 2.0 * I * (2.0 *
        Omega * t4 + t3))
    )


def stability(Omega, A, I_0, I_0A, zeta, d, h, h_A):
    """4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.

    Equation (30). Domain: Omega > 0, A > 0.
    Operations: 26 structured, 20 common subexpressions, 20 power chains.
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = 2.0 * Omega * zeta
    I = A * A * d * t0 + A * t2 + I_0
    return (I * (I_0A + 2.0 * d * t1 + t2) + R * (h_A + t0)) / A


def response_quartic(A, I_0, zeta, d, h):
    """F + F_0^2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^4.

    Equation (24). Domain: A > 0.
    Operations: 28 structured, 26 common subexpressions, 23 power chains.
    Proved, error / u (1 + kappa): 0.67, 0.51, 2.51, 0.67, 0.86
    """
    t0 = 4.0 * zeta
    A2 = A * A
    A3 = A * A2
    A4 = A2 * A2
    return (
        I_0 * I_0 + h * h,
        A * I_0 * t0,
        2.0 * A * h + A2 * (2.0 * I_0 * d + 4.0 * zeta * zeta),
        A3 * d * t0,
        A2 + A4 * d * d,
    )


def fold_quartic(A, I_0, I_0A, zeta, d, h, h_A):
    """F_A/2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^4.

    Equation (30). Domain: A > 0.
    Operations: 32 structured, 29 common subexpressions, 28 power chains.
    Proved, error / u (1 + kappa): 1.01, 1.67, 4.76, 0.81, 0.84
    """
    t0 = 2.0 * I_0
    A2 = A * A
    t1 = A2 * d
    A3 = A * A2
    return (
        I_0 * I_0A + h * h_A,
        2.0 * A * I_0A * zeta + t0 * zeta,
        A * h_A + A * (d * t0 + 4.0 * zeta * zeta) + I_0A * t1 + h,
        6.0 * t1 * zeta,
        A + 2.0 * A3 * d * d,
    )


def limit_envelope(Omega, F_0, m, zeta, eta, d):
    """Largest amplitude that the forcing can hold at this frequency, where friction acts throughout.

    Equation (27). Domain: Omega > 0, F_0 > m, one of zeta, eta, d > 0.
    Operations: 19 structured, 16 common subexpressions, 16 power chains.
    """
    t0 = 2.0 * Omega * zeta + eta
    return (2.0 * F_0 - 2.0 * m) / (t0 + np.sqrt(-4.0 * Omega * Omega * d * (-F_0 + m) + t0 * t0))


def turn_share(x, A, I_0, I_0A, zeta, d):
    """D/Omega^2 at x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D.

    Equation from (30). Domain: x >= 0, A > 0.
    Operations: 33 structured, 31 common subexpressions, 29 power chains.
    """
    A2 = A * A
    t0 = A2 * d
    x2 = x * x
    x3 = x * x2
    A3 = A * A2
    return (
        4.0 * A3 * d * d + 9.0 * t0 * x * zeta + x2 * (2.0 * A * I_0 * d + 4.0 * A * zeta * zeta + I_0A * t0) + x3 *
        (A * I_0A * zeta + I_0 * zeta)
    )


def folds(Omega, A, F_0, I_0A, I_0AA, zeta, d, h_A, h_AA, R, I):
    """F and F_A; derivatives by A and by Omega of the first, then of the second.

    Equation from (24), (30). Domain: Omega > 0, A > 0.
    Operations: 91 structured, 47 common subexpressions, 47 power chains.
    Proved, error / u (1 + kappa): -, 5.01, 5.01, 3.26, -, -
    """
    t0 = Omega * Omega
    t1 = h_A + t0
    t2 = 2.0 * Omega
    t3 = A * d
    t4 = 2.0 * t0
    t5 = I_0A + t2 * zeta + t3 * t4
    t6 = 2.0 * (I * t5 + R * t1)
    t7 = Omega * R
    t8 = A * Omega
    t9 = d * t8 + zeta
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        t6,
        t6,
        4.0 * A * (I * t9 + t7),
        2.0 * (I * I_0AA + I * d * t4 + R * h_AA + t1 * t1 + t5 * t5),
        4.0 * (A * t5 * t9 + I * (t2 * t3 + zeta) + t1 * t8 + t7),
    )


def peaks(Omega, A, F_0, I_0, I_0A, zeta, d, h_A, R, I):
    """F and F_Omega/(4 A Omega); derivatives by A and by Omega of the first, then of the second.

    Equation from (24). Domain: Omega > 0, A > 0.
    Operations: 88 structured, 54 common subexpressions, 54 power chains.
    Proved, error / u (1 + kappa): -, -, 5.01, 3.26, -, 10.51
    """
    t0 = zeta / Omega
    t1 = 3.0 * zeta
    t2 = A * d
    t3 = Omega * t2
    t4 = I_0 * d + t3 * (t1 + t3) + 2.0 * zeta * zeta
    t5 = Omega * Omega
    t6 = h_A + t5
    t7 = 2.0 * Omega
    t8 = t1 + 2.0 * t3
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        A * t4 + I_0 * t0 + R,
        2.0 * (I * (I_0A + 2.0 * t2 * t5 + t7 * zeta) + R * t6),
        4.0 * A * (I * (t3 + zeta) + Omega * R),
        I_0A * (t0 + t2) + t3 * t8 + t4 + t6,
        A * A * d * t8 + A * t7 - I_0 * zeta / t5,
    )


def cusps(Omega, A, I_0A, I_0AA, I_0AAA, zeta, d, h_A, h_AA, h_AAA, R, I):
    """F_A and F_AA; derivatives by A and by Omega of the first, then of the second.

    Equation from (30), (33). Domain: Omega > 0, A > 0.
    Operations: 171 structured, 64 common subexpressions, 64 power chains.
    Proved, error / u (1 + kappa): 5.01, -, -, -, -, -
    """
    t0 = Omega * Omega
    t1 = h_A + t0
    t2 = 2.0 * Omega
    t3 = d * t0
    t4 = 2.0 * t3
    t5 = A * t4 + I_0A + t2 * zeta
    t6 = 2.0 * (I * I_0AA + I * t4 + R * h_AA + t1 * t1 + t5 * t5)
    t7 = A * Omega
    t8 = d * t2
    t9 = A * t8 + zeta
    t10 = A * (d * t7 + zeta)
    t11 = 2.0 * t5
    t12 = I_0AA + t4
    return (
        2.0 * (I * t5 + R * t1),
        t6,
        t6,
        4.0 * (I * t9 + Omega * R + t1 * t7 + t10 * t5),
        2.0 * (I * I_0AAA + I_0AA * t11 + R * h_AAA + 3.0 * h_AA * t1 + t12 * t5 + 4.0 * t3 * t5),
        4.0 * (I * t8 + h_AA * t7 + t1 * t2 + t10 * t12 + t11 * t9),
    )


def isolas(Omega, A, I_0, I_0A, I_0AA, zeta, d, h_A, h_AA, R, I):
    """F_A and F_Omega/(4 A Omega); derivatives by A and by Omega of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0.
    Operations: 125 structured, 66 common subexpressions, 66 power chains.
    Proved, error / u (1 + kappa): 5.01, -, -, -, -, 10.51
    """
    t0 = Omega * Omega
    t1 = h_A + t0
    t2 = 2.0 * Omega
    t3 = A * d
    t4 = 2.0 * t0
    t5 = I_0A + t2 * zeta + t3 * t4
    t6 = zeta / Omega
    t7 = 3.0 * zeta
    t8 = Omega * t3
    t9 = I_0 * d + t8 * (t7 + t8) + 2.0 * zeta * zeta
    t10 = t2 * t3
    t11 = t10 + t7
    return (
        2.0 * (I * t5 + R * t1),
        A * t9 + I_0 * t6 + R,
        2.0 * (I * I_0AA + I * d * t4 + R * h_AA + t1 * t1 + t5 * t5),
        4.0 * (A * Omega * t1 + A * t5 * (t8 + zeta) + I * (t10 + zeta) + Omega * R),
        I_0A * (t3 + t6) + t1 + t11 * t8 + t9,
        A * A * d * t11 + A * t2 - I_0 * zeta / t0,
    )


def turns(Omega, A, I_0, I_0A, I_0AA, zeta, d, h, h_A, h_AA, R, I):
    """F_A and F_AOmega/Omega, less constant factors; derivatives by A and by Omega of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0.
    Operations: 166 structured, 111 common subexpressions, 110 power chains.
    Proved, error / u (1 + kappa): 5.01, -, -, -, -, 13.17
    """
    t0 = Omega * Omega
    t1 = h_A + t0
    t2 = 2.0 * Omega
    t3 = A * d
    t4 = 2.0 * t3
    t5 = I_0A + t0 * t4 + t2 * zeta
    t6 = 2.0 * h_A
    t7 = 4.0 * A
    t8 = zeta * zeta
    A2 = A * A
    t9 = 2.0 * d
    t10 = A2 * d * zeta
    t11 = A * I_0A
    t12 = I_0 + t11
    t13 = zeta / Omega
    t14 = d * d
    t15 = Omega * t3
    t16 = A2 * t14
    A3 = A * A2
    return (
        2.0 * (I * t5 + R * t1),
        A * t6 + 8.0 * A * t8 + A2 * I_0A * t9 + I_0 * d * t7 + 18.0 * Omega * t10 + 2.0 * h + t0 * (8.0 * A3 * t14
        + t7) + 2.0 * t12 * t13,
        2.0 * (I * I_0AA + I * t0 * t9 + R * h_AA + t1 * t1 + t5 * t5),
        4.0 * (A * Omega * t1 + A * t5 * (t15 + zeta) + I * (t2 * t3 + zeta) + Omega * R),
        2.0 * (A * I_0AA * (t13 + t3) + A * h_AA + I_0 * t9 + I_0A * t13 + I_0A * (t13 + t4) + 2.0 * t0 * (6.0 * t16
        + 1.0) + t11 * t9 + 18.0 * t15 * zeta + t6 + 4.0 * t8),
        2.0 * (Omega * t7 * (2.0 * t16 + 1.0) + 9.0 * t10 - t12 * zeta / t0),
    )


def rest(Omega, A, F_0, I_0A, zeta, d, h_A, R, I):
    """F, for Omega = 0; derivatives by A and by Omega.

    Equation from (24). Domain: Omega > 0, A > 0.
    Operations: 27 structured, 25 common subexpressions, 25 power chains.
    Proved, error / u (1 + kappa): -, 5.01, 3.26
    """
    t0 = Omega * Omega
    t1 = A * d
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        2.0 * (I * (I_0A + 2.0 * Omega * zeta + 2.0 * t0 * t1) + R * (h_A + t0)),
        4.0 * A * (I * (Omega * t1 + zeta) + Omega * R),
    )


def stiffness(Omega, A, I_0A, I_0AA, zeta, d, h_A, h_AA, R, I):
    """F_A, for Omega = 0; derivatives by A and by Omega.

    Equation from (30). Domain: Omega > 0, A > 0.
    Operations: 64 structured, 38 common subexpressions, 38 power chains.
    Proved, error / u (1 + kappa): 5.01, -, -
    """
    t0 = Omega * Omega
    t1 = h_A + t0
    t2 = 2.0 * Omega
    t3 = A * d
    t4 = 2.0 * t0
    t5 = I_0A + t2 * zeta + t3 * t4
    t6 = A * Omega
    return (
        2.0 * (I * t5 + R * t1),
        2.0 * (I * I_0AA + I * d * t4 + R * h_AA + t1 * t1 + t5 * t5),
        4.0 * (A * t5 * (d * t6 + zeta) + I * (t2 * t3 + zeta) + Omega * R + t1 * t6),
    )

