"""Structural and quadratic damping, and dry friction of what is attached.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/paper/averaging.py, derivations/paper/slow_flow.py, derivations/extensions/dissipation.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless, for any kind of number that has arithmetic: floats, complex numbers, arrays, an integrator's
symbols. Each docstring gives equation number, domain and floating-point operations.
Rounding errors are in u (1 + kappa), u = 2^-53: proved ones hold wherever nothing overflows or underflows, measured
ones are the worst of all outputs that was found, by a search for it with A 1e-09 to 1000, F_0 1e-09 to 1000, I
1e-12 to 1000 or 0, I_0 1e-12 to 1 or 0, I_0A 1e-09 to 1e+06 of either sign or 0, I_0AA 1e-09 to 1e+09 of either
sign or 0, I_0AAA 1e-09 to 1e+12 of either sign or 0, I_0_over_A 1e-12 to 1e+06 or 0, I_A 1e-09 to 1e+06 of either
sign or 0, I_over_A 1e-12 to 1e+06 or 0, Omega 0.001 to 1000, R 1e-09 to 1e+06 of either sign or 0, R_A 1e-09 to
1e+06 of either sign or 0, c_2 1e-12 to 1000 or 0, d 1e-12 to 1000 or 0, eta 1e-12 to 1 or 0, h 1e-12 to 1000 of
either sign or 0, h_A 1e-09 to 1e+06 of either sign or 0, h_AA 1e-09 to 1e+09 of either sign or 0, h_AAA 1e-09 to
1e+12 of either sign or 0, h_over_A 1e-09 to 1e+06 of either sign or 0, m 1e-12 to 1 or 0, steepest 1e-09 to 1e+06
or 0, u_cr 1e-06 to 1, x 0.001 to 1000, zeta 1e-12 to 1 or 0.
"""

# a formatter would spread each polynomial over a page
# fmt: off

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np


__all__ = [
    "F_A", "F_AA", "I_A", "F", "F_AOmega", "F_AOmegaOmega", "F_A_halved", "F_A_scaled", "F_Omega", "F_OmegaOmega",
    "I", "I_scaled", "Omega_A", "Omega_A_by_inertia", "R_of_peak", "R_of_response", "R_where_stationary", "at_rest",
    "cusp_bend", "cusp_bend_by_inertia", "cusps_by_Omega", "cusps_by_R", "cusps_far_by_R", "cusps_far_by_x", "far",
    "far_by_inertia", "fold_quartic", "folds_by_Omega", "folds_by_R", "folds_far_by_R", "folds_far_by_x",
    "full_by_inertia", "isola_bend", "isola_bend_by_inertia", "isolas_by_Omega", "isolas_by_R", "isolas_far_by_R",
    "isolas_far_by_x", "least_scaled", "limit_envelope", "peaks_by_Omega", "peaks_by_R", "peaks_far_by_R",
    "peaks_far_by_x", "quadratic", "quadratic_bound", "released", "released_moves", "response_quartic",
    "rest_moves", "restoring", "stability", "static", "structural_bound", "turn_share", "turns_by_Omega",
    "turns_by_R",
]


def quadratic(c_2: Any) -> Any:
    """Quadratic damping's factor of A^2 Omega^2 in I.

    Equation from (19). Domain: any. Shape: the arguments that it depends on, broadcast. Operations: 1.
    Measured, error / u (1 + kappa): 0.69
    """
    return 0.84882636315677518 * c_2


def restoring(A: Any, F_0: Any, d: Any) -> Any:
    """The largest |h| of a state with this amplitude, as quadratic damping bounds its frequency.

    Equation from (23). Domain: A > 0, d > 0. Shape: the arguments that it depends on, broadcast. Operations: 3.
    Proved, error / u (1 + kappa): 2.01
    """
    return F_0 + F_0 / (A * d)


def at_rest(A: Any, m: Any, eta: Any) -> tuple[Any, Any, Any, Any]:
    """I_0, I at Omega = 0, and three derivatives by A: friction acts throughout.

    Equation from (19). Domain: A > 0. Shape: 4 results, each the arguments that it depends on, broadcast.
    Operations: 2.
    Proved, error / u (1 + kappa): 1.01, 0.0, 0.0, 0.0
    """
    return A * eta + m, eta, 0.0, 0.0


def released(A: Any, m: Any, eta: Any, u_cr: Any) -> tuple[Any, Any, Any, Any]:
    """The same where friction acts for |u| < u_cr only.

    Equation from (19). Domain: A >= u_cr > 0. Shape: 4 results, each the arguments that it depends on, broadcast.
    Operations: 13.
    Proved, error / u (1 + kappa): 1.01, 1.01, 0.67, 0.86
    """
    t0 = m * u_cr
    A2 = A * A
    A3 = A * A2
    A4 = A2 * A2
    return A * eta + t0 / A, eta - t0 / A2, 2.0 * t0 / A3, -6.0 * t0 / A4


def rest_moves(A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """What m, then eta, does to I_0, I_0A and I_0AA: friction acts throughout.

    Equation from (19). Domain: A > 0. Shape: 6 results, each the arguments that it depends on, broadcast.
    Operations: 0.
    Proved, error / u (1 + kappa): 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    """
    return 1.0, 0.0, 0.0, A, 1.0, 0.0


def released_moves(A: Any, m: Any, u_cr: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """What m, then eta, then u_cr does to them where friction acts for |u| < u_cr only.

    Equation from (19). Domain: A >= u_cr > 0. Shape: 9 results, each the arguments that it depends on, broadcast.
    Operations: 11.
    Proved, error / u (1 + kappa): 0.67, 0.76, 0.81, 0.0, 0.0, 0.0, 0.67, 0.76, 0.81
    """
    t0 = 1.0 / A
    A2 = A * A
    t1 = 1.0 / A2
    A3 = A * A2
    t2 = 2.0 / A3
    return t0 * u_cr, -t1 * u_cr, t2 * u_cr, A, 1.0, 0.0, m * t0, -m * t1, m * t2


def I(Omega: Any, A: Any, I_0: Any, zeta: Any, d: Any) -> Any:  # noqa: E743
    """Sine balance, -F_0 sin phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 9.
    Proved, error / u (1 + kappa): 4.01
    """
    return A * A * Omega * Omega * d + 2.0 * A * Omega * zeta + I_0


def I_A(Omega: Any, A: Any, I_0A: Any, zeta: Any, d: Any) -> Any:
    """dI/dA.

    Equation (23). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 8.
    Proved, error / u (1 + kappa): 2.61
    """
    return 2.0 * A * Omega * Omega * d + I_0A + 2.0 * Omega * zeta


def far(x: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, d: Any, h: Any, h_A: Any) -> tuple[Any, Any, Any, Any]:
    """R, R_A, I and I_A over Omega^2, at x = 1/Omega.

    Equation (23). Domain: x >= 0, A > 0. Shape: 4 results, each the arguments that it depends on, broadcast.
    Operations: 18.
    Proved, error / u (1 + kappa): 1.01, 1.34, 4.01, 2.61
    """
    t0 = x * x
    t1 = 2.0 * A
    t2 = x * zeta
    return A + h * t0, h_A * t0 + 1.0, A * A * d + I_0 * t0 + t1 * t2, I_0A * t0 + d * t1 + 2.0 * t2


def F(Omega: Any, A: Any, F_0: Any, I_0: Any, zeta: Any, d: Any, h: Any) -> Any:
    """Zero at a steady state.

    Equation (24). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 16.
    Measured, error / u (1 + kappa): 1.2
    """
    t0 = Omega * Omega
    R = A * t0 + h
    I = A * A * d * t0 + 2.0 * A * Omega * zeta + I_0
    return R * R + (-F_0 + I) * (F_0 + I)


def F_A(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, d: Any, h: Any, h_A: Any) -> Any:
    """dF/dA; positive where stable.

    Equation (24), (30). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations:
    20.
    Measured, error / u (1 + kappa): 0.86
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = 2.0 * Omega * zeta
    I = A * A * d * t0 + A * t2 + I_0
    return 2.0 * (I * (I_0A + 2.0 * d * t1 + t2) + R * (h_A + t0))


def F_AA(Omega: Any, A: Any, I_0: Any, I_0A: Any, I_0AA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any) -> Any:
    """d2F/dA2.

    Equation (24). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 27.
    Measured, error / u (1 + kappa): 1.5
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


def F_Omega(Omega: Any, A: Any, I_0: Any, zeta: Any, d: Any, h: Any) -> Any:
    """dF/dOmega.

    Equation (24). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 18.
    Measured, error / u (1 + kappa): 0.77
    """
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = A * Omega
    I = A * A * d * t0 + I_0 + 2.0 * t1 * zeta
    return 4.0 * A * (I * (d * t1 + zeta) + Omega * R)


def F_OmegaOmega(Omega: Any, A: Any, I_0: Any, zeta: Any, d: Any, h: Any) -> Any:
    """d2F/dOmega2.

    Equation (24). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 23.
    Measured, error / u (1 + kappa): 1.3
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = 2.0 * A
    I = A * A * d * t0 + I_0 + Omega * t2 * zeta
    t3 = A * d
    t4 = Omega * t3 + zeta
    return 4.0 * A * (I * t3 + R + 2.0 * t1 + t2 * t4 * t4)


def F_AOmega(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, d: Any, h: Any, h_A: Any) -> Any:
    """d2F/dA dOmega.

    Equation (24). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 30.
    Measured, error / u (1 + kappa): 1.2
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


def F_AOmegaOmega(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, d: Any, h: Any, h_A: Any) -> Any:
    """d3F/dA dOmega2.

    Equation (24). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 35.
    Measured, error / u (1 + kappa): 1.5
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


def Omega_A(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, d: Any, h: Any, h_A: Any) -> Any:
    """dOmega/dA along the response.

    Equation from (24). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations:
    31.
    Measured, error / u (1 + kappa): 1.9
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


def Omega_A_by_inertia(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, d: Any, h: Any, h_A: Any) -> Any:
    """The same of an excitation by inertia.

    Equation from (24). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations:
    29.
    Measured, error / u (1 + kappa): 1.4
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = Omega * zeta
    t3 = A * t2
    I = A * A * d * t0 + I_0 + 2.0 * t3
    return (
        2.0 * Omega * (I * (I_0A + 2.0 * d * t1 + 2.0 * t2) + R * (h_A + t0)) / (4.0 * I * (I_0 + t3) + 4.0 * R * h)
    )


def cusp_bend(Omega: Any, A: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any) -> Any:
    """Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast.
    Operations: 55.
    Measured, error / u (1 + kappa): 0.98
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = 2.0 * Omega
    t3 = t2 * zeta
    t4 = d * t0
    I = A * A * t4 + A * t3 + I_0
    t5 = h_A + t0
    t6 = I_0A + 2.0 * d * t1 + t3
    F_AAA = (
        2.0 * (I * I_0AAA + 2.0 * I_0AA * t6 + R * h_AAA + 3.0 * h_AA * t5 + 4.0 * t4 * t6 + t6 * (I_0AA + 2.0 *
        t4))
    )
    t7 = Omega * R
    t8 = A * Omega
    t9 = d * t8 + zeta
    F_Omega = 4.0 * A * (I * t9 + t7)
    F_AOmega = 4.0 * (A * t6 * t9 + I * (A * d * t2 + zeta) + t5 * t8 + t7)
    return -F_AAA * F_AOmega * F_Omega / A


def isola_bend(Omega: Any, A: Any, I_0: Any, I_0A: Any, I_0AA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any) -> tuple[Any, Any]:
    """At an isola point: negative at a saddle of F; and as `cusp_bend`.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Shape: 2 results, each the arguments that it depends on,
    broadcast. Operations: 81.
    Measured, error / u (1 + kappa): 1.4
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * zeta
    t2 = Omega * t1
    t3 = A * A
    t4 = Omega2 * t3
    I = A * t2 + I_0 + d * t4
    t5 = R * h_AA
    t6 = 2.0 * d
    t7 = Omega2 * t6
    t8 = Omega2 + h_A
    t9 = I_0A + t0 * t6 + t2
    t10 = t8 * t8 + t9 * t9
    F_AA = 2.0 * (I * I_0AA + I * t7 + t10 + t5)
    t11 = t3 * t6
    t12 = A * t1 + Omega * t11
    G_AOmega = 2.0 * A * Omega * t8 + t12 * t9
    G_OmegaOmega = t12 * t12 + 4.0 * t4
    S_AA = I * (I_0AA + t7) + t5
    t13 = 2.0 * R
    t14 = A * d
    t15 = Omega * t14
    S_AOmega = I * (t1 + 4.0 * t15) + Omega * t13
    S_OmegaOmega = A * t13 + I * t11
    t16 = 4.0 * S_OmegaOmega
    Omega3 = Omega * Omega2
    t17 = I_0A * Omega + Omega2 * zeta + Omega3 * t14 - h_A * t15 - h_A * zeta
    t18 = (
        -8.0 * G_AOmega * S_AOmega + 4.0 * G_OmegaOmega * S_AA + S_AA * t16 - 4.0 * S_AOmega * S_AOmega + t10 * t16
        + 16.0 * t17 * t17 * t3
    )
    return t18, F_AA * t18


def stability(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, d: Any, h: Any, h_A: Any) -> Any:
    """4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.

    Equation (30). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 20.
    Measured, error / u (1 + kappa): 1
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = 2.0 * Omega * zeta
    I = A * A * d * t0 + A * t2 + I_0
    return (I * (I_0A + 2.0 * d * t1 + t2) + R * (h_A + t0)) / A


def static(F_0: Any, I_0: Any, I_0A: Any, h: Any, h_A: Any) -> tuple[Any, Any, Any, Any]:
    """F at Omega = 0 by its halves h - c and h + c, c^2 = F_0^2 - I_0^2; and the slope of each.

    Equation from (24). Domain: F_0 > I_0. Shape: 4 results, each the arguments that it depends on, broadcast.
    Operations: 10.
    Measured, error / u (1 + kappa): 0.51
    """
    c = np.sqrt((F_0 - I_0) * (F_0 + I_0))
    t0 = I_0 * I_0A / c
    return -c + h, c + h, h_A + t0, h_A - t0


def response_quartic(A: Any, I_0: Any, zeta: Any, d: Any, h: Any) -> tuple[Any, Any, Any, Any, Any]:
    """F + F_0^2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^4.

    Equation (24). Domain: A > 0. Shape: 5 results, each the arguments that it depends on, broadcast. Operations:
    23.
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


def fold_quartic(A: Any, I_0: Any, I_0A: Any, zeta: Any, d: Any, h: Any, h_A: Any) -> tuple[Any, Any, Any, Any, Any]:
    """F_A/2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^4.

    Equation (30). Domain: A > 0. Shape: 5 results, each the arguments that it depends on, broadcast. Operations:
    28.
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


def limit_envelope(Omega: Any, F_0: Any, m: Any, zeta: Any, eta: Any, d: Any) -> Any:
    """Largest amplitude that the forcing can hold at this frequency, where friction acts throughout.

    Equation (27). Domain: Omega > 0, F_0 > m, one of zeta, eta, d > 0. Shape: the arguments that it depends on,
    broadcast. Operations: 16.
    Measured, error / u (1 + kappa): 0.89
    """
    t0 = 2.0 * Omega * zeta + eta
    return (2.0 * F_0 - 2.0 * m) / (t0 + np.sqrt(-4.0 * Omega * Omega * d * (-F_0 + m) + t0 * t0))


def turn_share(x: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, d: Any) -> Any:
    """D/Omega^2 at x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D.

    Equation from (30). Domain: x >= 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 29.
    Measured, error / u (1 + kappa): 1.1
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


def F_A_halved(R: Any, R_A: Any, I: Any, I_A: Any) -> Any:
    """F_A/2 by R, I and their slopes.

    Equation (30). Domain: Omega >= 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 3.
    Proved, error / u (1 + kappa): 1.01
    """
    return I * I_A + R * R_A


def R_of_response(F_0: Any, I: Any) -> Any:
    """The size of R where F = 0.

    Equation (24). Domain: Omega >= 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 4.
    Measured, error / u (1 + kappa): 0.62
    """
    return np.sqrt(F_0 * F_0 - I * I)


def R_of_peak(Omega: Any, A: Any, zeta: Any, d: Any, I: Any) -> Any:
    """R where F_Omega = 0.

    Equation from (24). Domain: Omega >= 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations:
    4.
    Proved, error / u (1 + kappa): 1.51
    """
    return I * (-A * d - zeta / Omega)


def R_where_stationary(x: Any, A: Any, I_0: Any, zeta: Any, d: Any) -> tuple[Any, Any, Any]:
    """Where a level by inertia is stationary, x = 1/Omega: what is not negative, lower and higher R/Omega^2.

    Equation from (24). Domain: Omega >= 0, A > 0. Shape: 3 results, each the arguments that it depends on,
    broadcast. Operations: 20.
    Measured, error / u (1 + kappa): 0.92
    """
    t0 = A * A
    t1 = A * zeta
    t2 = x * (I_0 * x + t1) * (I_0 * x * x + d * t0 + 2.0 * t1 * x)
    t3 = t0 - 4.0 * t2
    t4 = 0.5 * A + 0.5 * np.sqrt(t3)
    return t3, t2 / t4, t4


def I_scaled(Omega: Any, A: Any, I_0_over_A: Any, zeta: Any, d: Any) -> Any:
    """I/A, by I_0/A.

    Equation (23). Domain: Omega >= 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 7.
    Proved, error / u (1 + kappa): 2.61
    """
    return A * Omega * Omega * d + I_0_over_A + 2.0 * Omega * zeta


def F_A_scaled(Omega: Any, h_over_A: Any, h_A: Any, I_over_A: Any, I_A: Any) -> Any:
    """F_A/(2 A), by h/A and I/A.

    Equation (30). Domain: Omega >= 0, A > 0. Shape: the arguments that it depends on, broadcast. Operations: 6.
    Measured, error / u (1 + kappa): 0.94
    """
    t0 = Omega * Omega
    return I_A * I_over_A + (h_A + t0) * (h_over_A + t0)


def least_scaled(Omega: Any, zeta: Any, eta: Any, d: Any, h_AA: Any) -> tuple[Any, Any]:
    """Of what 4/A times the least F_A/2 is not below where |k| <= A^2 |h_AA|/2, friction throughout: 1, A^2.

    Equation from (30). Domain: Omega >= 0. Shape: 2 results, each the arguments that it depends on, broadcast.
    Operations: 13.
    Proved, error / u (1 + kappa): -, 1.01
    Measured, error / u (1 + kappa): 0.78
    """
    t0 = 2.0 * Omega * zeta + eta
    Omega2 = Omega * Omega
    Omega4 = Omega2 * Omega2
    return 4.0 * t0 * t0, 8.0 * Omega4 * d * d - 0.25 * h_AA * h_AA


def far_by_inertia(x: Any, A: Any, F_0: Any, I_0: Any, zeta: Any, d: Any, h: Any) -> tuple[Any, Any, Any]:
    """F/Omega^4 at x = 1/Omega; and -Omega^3/4 dlevel^2/dOmega, less Omega times the third.

    Equation (24). Domain: x >= 0, A > 0. Shape: 3 results, each the arguments that it depends on, broadcast.
    Operations: 34.
    Proved, error / u (1 + kappa): -, -, 0.67
    Measured, error / u (1 + kappa): 1.2
    """
    t0 = x * x
    A2 = A * A
    t1 = A2 * d
    t2 = A * x * zeta
    t3 = A + h * t0
    t4 = I_0 * t0 + t1 + 2.0 * t2
    A3 = A * A2
    return (
        -F_0 * F_0 + t3 * t3 + t4 * t4,
        A * h + 2.0 * A2 * zeta * zeta + I_0 * t1 + 3.0 * I_0 * t2 + t0 * (I_0 * I_0 + h * h),
        A3 * d * zeta,
    )


def cusp_bend_by_inertia(Omega: Any, A: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any) -> Any:
    """As `cusp_bend`, for an excitation by inertia.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Shape: the arguments that it depends on, broadcast.
    Operations: 54.
    Measured, error / u (1 + kappa): 0.78
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = Omega * zeta
    t3 = 2.0 * t2
    t4 = d * t0
    I = A * A * t4 + A * t3 + I_0
    t5 = h_A + t0
    t6 = I_0A + 2.0 * d * t1 + t3
    F_AAA = (
        2.0 * (I * I_0AAA + 2.0 * I_0AA * t6 + R * h_AAA + 3.0 * h_AA * t5 + 4.0 * t4 * t6 + t6 * (I_0AA + 2.0 *
        t4))
    )
    t7 = A * Omega
    t8 = d * t7
    F_AOmega = 4.0 * (A * t6 * (t8 + zeta) + I * (2.0 * t8 + zeta) + Omega * R + t5 * t7)
    return F_AAA * F_AOmega * (I * (A * t2 + I_0) + R * h)


def isola_bend_by_inertia(Omega: Any, A: Any, I_0: Any, I_0A: Any, I_0AA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any) -> tuple[Any, Any]:
    """As `isola_bend`, for an excitation by inertia.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Shape: 2 results, each the arguments that it depends on,
    broadcast. Operations: 61.
    Measured, error / u (1 + kappa): 1.7
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = Omega * zeta
    t3 = 2.0 * t2
    t4 = A * A
    t5 = d * t0
    I = A * t3 + I_0 + t4 * t5
    t6 = h_A + t0
    t7 = 2.0 * d
    t8 = I_0A + t1 * t7 + t3
    F_AA = 2.0 * (I * I_0AA + 2.0 * I * t5 + R * h_AA + t6 * t6 + t8 * t8)
    t9 = A * Omega
    t10 = d * t9
    F_AOmega = 4.0 * (A * t8 * (t10 + zeta) + I * (2.0 * t10 + zeta) + Omega * R + t6 * t9)
    t11 = A * zeta
    F_OmegaOmega = (
        (-4.0 * I * t11 - 8.0 * h * t9 - 4.0 * (A * t2 + I_0) * (Omega * t4 * t7 + 2.0 * t11)) / Omega
    )
    t12 = F_AA * F_OmegaOmega - F_AOmega * F_AOmega
    return t12, F_AA * t12


def full_by_inertia(F_0: Any, d: Any) -> Any:
    """The amplitude that the response tends to as Omega grows.

    Equation from (24). Domain: F_0 > 0. Shape: the arguments that it depends on, broadcast. Operations: 10.
    Measured, error / u (1 + kappa): 1.4
    """
    return 1.4142135623730951 * F_0 / np.sqrt(np.sqrt(4.0 * F_0 * F_0 * d * d + 1.0) + 1.0)


def structural_bound(A: Any, F_0: Any, eta: Any, h: Any, steepest: Any) -> tuple[Any, Any]:
    """Both positive: no state above A, while |h| grows by steepest dA at most.

    Equation from (23), (24). Domain: A > 0. Shape: 2 results, each the arguments that it depends on, broadcast.
    Operations: 10.
    Proved, error / u (1 + kappa): -, 3.76
    Measured, error / u (1 + kappa): 0.84
    """
    t0 = A - F_0
    t1 = A * eta
    return -F_0 * np.abs(h) + t0 * t1, -F_0 * steepest + eta * t0 + t1


def quadratic_bound(F_0: Any, d: Any) -> Any:
    """What no amplitude exceeds.

    Equation from (23), (24). Domain: d > 0. Shape: the arguments that it depends on, broadcast. Operations: 3.
    Measured, error / u (1 + kappa): 1.2
    """
    return np.sqrt(F_0) / np.sqrt(d)


def folds_by_R(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and F_A/2; derivatives by A and by R of the first, then of the second.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 44.
    Proved, error / u (1 + kappa): -, 1.01, 3.51, 3.01, -, -
    Measured, error / u (1 + kappa): 0.68
    """
    t0 = 1.0 / Omega
    t1 = A * Omega * d
    t2 = t0 * (t1 + zeta)
    t3 = I_A - R_A * t2
    t4 = 1.0 / A
    t5 = R_A * t4
    t6 = t0 * (2.0 * t1 + zeta)
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        I * I_A + R * R_A,
        2.0 * I * t3,
        2.0 * (I * t2 + R),
        I * (I_0AA + 2.0 * Omega * Omega * d - t5 * t6) + I_A * t3 + R * (h_AA - t5),
        I * t4 * t6 + I_A * t2 + R * t4 + R_A,
    )


def peaks_by_R(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second.

    Equation from (24). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 35.
    Proved, error / u (1 + kappa): -, 2.26, 3.51, 3.01, -, -
    Measured, error / u (1 + kappa): 0.42
    """
    t0 = A * d
    t1 = 1.0 / Omega
    t2 = t0 + t1 * zeta
    t3 = t1 * (Omega * t0 + zeta)
    t4 = I_A - R_A * t3
    Omega2 = Omega * Omega
    Omega3 = Omega * Omega2
    t5 = 0.5 * I * zeta / (A * Omega3)
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        I * t2 + R,
        2.0 * I * t4,
        2.0 * (I * t3 + R),
        I * d + R_A * t5 + t2 * t4,
        t2 * t3 - t5 + 1.0,
    )


def cusps_by_R(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and F_AA/2; derivatives by A and by R of the first, then of the second.

    Equation from (30), (33). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 66.
    Proved, error / u (1 + kappa): 1.01, 3.01, -, -, -, -
    Measured, error / u (1 + kappa): 0.72
    """
    t0 = 2.0 * d
    t1 = Omega * Omega * t0
    t2 = 1.0 / A
    t3 = R_A * t2
    t4 = h_AA - t3
    t5 = 1.0 / Omega
    t6 = A * Omega
    t7 = t5 * (d * t6 + zeta)
    t8 = I_A - R_A * t7
    t9 = t5 * (t0 * t6 + zeta)
    t10 = I_0AA + t1
    t11 = t10 - t3 * t9
    t12 = I * t2
    t13 = 2.0 * I_A
    return (
        I * I_A + R * R_A,
        I * I_0AA + I * t1 + I_A * I_A + R * h_AA + R_A * R_A,
        I * t11 + I_A * t8 + R * t4,
        I_A * t7 + R * t2 + R_A + t12 * t9,
        I * I_0AAA - I * t0 * t3 + R * h_AAA + 2.0 * R_A * t4 + t10 * t8 + t11 * t13,
        h_AA + t0 * t12 + t10 * t7 + t13 * t2 * t9 + 2.0 * t3,
    )


def isolas_by_R(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 51.
    Proved, error / u (1 + kappa): 1.01, 2.26, -, -, -, -
    Measured, error / u (1 + kappa): 0.71
    """
    t0 = A * d
    t1 = 1.0 / Omega
    t2 = t0 + t1 * zeta
    t3 = 1.0 / A
    t4 = R_A * t3
    t5 = Omega * t0
    t6 = t1 * (t5 + zeta)
    t7 = I_A - R_A * t6
    t8 = t1 * (2.0 * t5 + zeta)
    t9 = I * t3
    Omega2 = Omega * Omega
    Omega3 = Omega * Omega2
    t10 = 0.5 * zeta / Omega3
    return (
        I * I_A + R * R_A,
        I * t2 + R,
        I * (I_0AA + 2.0 * Omega2 * d - t4 * t8) + I_A * t7 + R * (h_AA - t4),
        I_A * t6 + R * t3 + R_A + t8 * t9,
        I * d + I * t10 * t4 + t2 * t7,
        -t10 * t9 + t2 * t6 + 1.0,
    )


def turns_by_R(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and F_AOmega/(4 Omega); derivatives by A and by R of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 97.
    Proved, error / u (1 + kappa): 1.01, -, -, -, -, -
    Measured, error / u (1 + kappa): 0.73
    """
    t0 = R * R_A
    t1 = A * R_A
    t2 = 2.0 * d
    t3 = I * t2
    t4 = A * A
    t5 = I_A * d
    t6 = zeta / Omega
    t7 = I * t6
    t8 = I_A * t6
    t9 = 1.0 / A
    Omega2 = Omega * Omega
    t10 = t7 * t9
    t11 = A * t5
    t12 = A * t6
    Omega3 = Omega * Omega2
    t13 = 0.5 * zeta / Omega3
    t14 = I_A * t13
    t15 = d * d * t4
    t16 = 4.0 * t15
    t17 = 2.0 * zeta * zeta / Omega2
    t18 = 6.0 * d
    t19 = I * t13 * t9
    return (
        I * I_A + t0,
        A * t3 + A * t8 + R + t1 + t4 * t5 + t7,
        I * I_0AA + 2.0 * I * Omega2 * d + I_A * I_A + R * h_AA - R_A * t10 - R_A * t3 - R_A * t8 - t0 * t9 - t1 *
        t5,
        R * t9 + R_A + t10 + t11 + t3 + t8,
        A * Omega * t2 * zeta + A * h_AA + I_0AA * d * t4 + I_0AA * t12 + 2.0 * Omega2 * t15 + R_A * t14 - R_A * t16
        - R_A * t17 + R_A * t19 - t1 * t18 * t6 + 4.0 * t11 + t3 + 2.0 * t8,
        t12 * t18 - t14 + t16 + t17 - t19 + 2.0,
    )


def folds_by_Omega(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and F_A/2; derivatives by A and by Omega of the first, then of the second.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 38.
    Proved, error / u (1 + kappa): -, 1.01, 1.01, 3.26, 3.01, -
    Measured, error / u (1 + kappa): 0.43
    """
    t0 = I * I_A + R * R_A
    t1 = Omega * R
    t2 = A * Omega
    t3 = d * t2
    t4 = t3 + zeta
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        t0,
        2.0 * t0,
        4.0 * A * (I * t4 + t1),
        I * (I_0AA + 2.0 * Omega * Omega * d) + I_A * I_A + R * h_AA + R_A * R_A,
        2.0 * (A * I_A * t4 + I * (2.0 * t3 + zeta) + R_A * t2 + t1),
    )


def peaks_by_Omega(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second.

    Equation from (24). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 48.
    Proved, error / u (1 + kappa): -, -, 1.01, 3.26, -, 10.51
    Measured, error / u (1 + kappa): 0.52
    """
    t0 = zeta / Omega
    t1 = 3.0 * zeta
    t2 = A * d
    t3 = Omega * t2
    t4 = I_0 * d + t3 * (t1 + t3) + 2.0 * zeta * zeta
    t5 = t1 + 2.0 * t3
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        A * t4 + I_0 * t0 + R,
        2.0 * (I * I_A + R * R_A),
        4.0 * A * (I * (t3 + zeta) + Omega * R),
        I_0A * (t0 + t2) + R_A + t3 * t5 + t4,
        A * A * d * t5 + 2.0 * A * Omega - I_0 * zeta / (Omega * Omega),
    )


def cusps_by_Omega(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and F_AA/2; derivatives by A and by Omega of the first, then of the second.

    Equation from (30), (33). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 54.
    Proved, error / u (1 + kappa): 1.01, 2.51, 2.01, -, 3.51, -
    Measured, error / u (1 + kappa): 0.76
    """
    t0 = 2.0 * d
    t1 = Omega * Omega * t0
    t2 = I_A * I_A + R * h_AA + R_A * R_A
    t3 = I_0AA + t1
    t4 = A * Omega
    t5 = t0 * t4 + zeta
    t6 = A * (d * t4 + zeta)
    return (
        I * I_A + R * R_A,
        I * I_0AA + I * t1 + t2,
        I * t3 + t2,
        2.0 * (I * t5 + I_A * t6 + Omega * R + R_A * t4),
        I * I_0AAA + 3.0 * I_A * t3 + R * h_AAA + 3.0 * R_A * h_AA,
        2.0 * (I * Omega * t0 + 2.0 * I_A * t5 + 2.0 * Omega * R_A + h_AA * t4 + t3 * t6),
    )


def isolas_by_Omega(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 57.
    Proved, error / u (1 + kappa): 1.01, -, 3.01, -, -, 10.51
    Measured, error / u (1 + kappa): 0.9
    """
    t0 = zeta / Omega
    t1 = 3.0 * zeta
    t2 = A * d
    t3 = Omega * t2
    t4 = I_0 * d + t3 * (t1 + t3) + 2.0 * zeta * zeta
    t5 = Omega * Omega
    t6 = A * Omega
    t7 = 2.0 * t3
    t8 = t1 + t7
    return (
        I * I_A + R * R_A,
        A * t4 + I_0 * t0 + R,
        I * (I_0AA + 2.0 * d * t5) + I_A * I_A + R * h_AA + R_A * R_A,
        2.0 * (A * I_A * (t3 + zeta) + I * (t7 + zeta) + Omega * R + R_A * t6),
        I_0A * (t0 + t2) + R_A + t3 * t8 + t4,
        A * A * d * t8 - I_0 * zeta / t5 + 2.0 * t6,
    )


def turns_by_Omega(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and F_AOmega/(4 Omega); derivatives by A and by Omega of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 84.
    Proved, error / u (1 + kappa): 1.01, -, 3.01, -, -, -
    Measured, error / u (1 + kappa): 1.2
    """
    t0 = A * R_A
    t1 = 2.0 * d
    t2 = I * t1
    t3 = A * t2
    A2 = A * A
    t4 = A2 * d
    t5 = I_A * t4
    t6 = 1.0 / Omega
    t7 = I * zeta
    t8 = I_A * zeta
    t9 = A * t8
    t10 = Omega * Omega
    t11 = 4.0 * A
    t12 = A * zeta
    t13 = d * d
    t14 = 1.0 / t10
    A3 = A * A2
    return (
        I * I_A + R * R_A,
        R + t0 + t3 + t5 + t6 * t7 + t6 * t9,
        I * I_0AA + I_A * I_A + R * h_AA + R_A * R_A + t10 * t2,
        2.0 * (Omega * R + Omega * t0 + Omega * t3 + Omega * t5 + t7 + t9),
        A * h_AA + 2.0 * A2 * t10 * t13 + I_0AA * t12 * t6 + I_0AA * t4 + I_A * d * t11 + Omega * t1 * t12 + 2.0 *
        R_A + t2 + 2.0 * t6 * t8,
        8.0 * A3 * Omega * t13 + Omega * t11 + t11 * t6 * zeta * zeta - t14 * t7 - t14 * t9 + 12.0 * t4 * zeta,
    )


def folds_far_by_R(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 45.
    Proved, error / u (1 + kappa): -, 1.01, 4.01, 3.51, 13.67, 11.67
    Measured, error / u (1 + kappa): 0.53
    """
    t0 = 1.0 / h
    t1 = t0 / x
    t2 = t1 * (A * zeta + I_0 * x)
    t3 = I_A - R_A * t2
    t4 = x * x
    t5 = h_A * t0
    t6 = t1 * (I_0A * x + zeta)
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        I * I_A + R * R_A,
        2.0 * I * t3,
        2.0 * (I * t2 + R),
        I * (I_0AA * t4 - R_A * t6 + 2.0 * d) + I_A * t3 + R * (-R_A * t5 + h_AA * t4),
        I * t6 + I_A * t2 + R * t5 + R_A,
    )


def peaks_far_by_R(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.

    Equation from (24). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 53.
    Proved, error / u (1 + kappa): -, 3.26, 4.51, 4.01, -, -
    Measured, error / u (1 + kappa): 0.91
    """
    t0 = 1.0 / h
    t1 = 1.0 / x
    t2 = A * zeta
    t3 = t1 * t2
    t4 = I_0 * x + t2
    t5 = t0 * t4
    t6 = I_A - R_A * t1 * t5
    t7 = I * t1
    t8 = I * t0
    x2 = x * x
    x3 = x * x2
    t9 = 0.5 * t2 / x3
    t10 = I_0 + t3
    t11 = 1.0 / (h * h)
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        I * (I_0 * t0 + t0 * t3) + R,
        2.0 * I * t6,
        2.0 * (R + t5 * t7),
        t0 * (I * I_0A + R_A * t8 * t9 - h_A * t10 * t8 + t10 * t6 + t7 * zeta),
        -I * t11 * t9 + t1 * t10 * t11 * t4 + 1.0,
    )


def cusps_far_by_R(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.

    Equation from (30), (33). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 72.
    Proved, error / u (1 + kappa): 1.01, 4.01, 13.01, 11.67, -, -
    Measured, error / u (1 + kappa): 0.84
    """
    t0 = 2.0 * d
    t1 = x * x
    t2 = I_0AA * t1
    t3 = h_AA * t1
    t4 = 1.0 / h
    t5 = h_A * t4
    t6 = R_A * t5
    t7 = h_AA * t1 - t6
    t8 = A * zeta + I_0 * x
    t9 = t4 / x
    t10 = R_A * t9
    t11 = I_A - t10 * t8
    t12 = I_0A * x + zeta
    t13 = t0 + t2
    t14 = -t10 * t12 + t13
    t15 = t12 * t9
    t16 = t8 * t9
    t17 = t4 * (I * I_0AA + R * h_AA)
    t18 = 2.0 * I_A
    return (
        I * I_A + R * R_A,
        I * t0 + I * t2 + I_A * I_A + R * t3 + R_A * R_A,
        I * t14 + I_A * t11 + R * t7,
        I * t15 + I_A * t16 + R * t5 + R_A,
        I * I_0AAA * t1 + R * h_AAA * t1 - R_A * t17 + 2.0 * R_A * t7 + t11 * t13 + t14 * t18,
        t13 * t16 + t15 * t18 + t17 + t3 + 2.0 * t6,
    )


def isolas_far_by_R(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 69.
    Proved, error / u (1 + kappa): 1.01, 3.26, 15.01, 13.01, -, -
    Measured, error / u (1 + kappa): 0.7
    """
    t0 = 1.0 / h
    t1 = 1.0 / x
    t2 = A * zeta
    t3 = t1 * t2
    x2 = x * x
    t4 = h_A * t0
    t5 = R_A * t1
    t6 = I_0 * x + t2
    t7 = t0 * t6
    t8 = I_A - t5 * t7
    t9 = t0 * (I_0A * x + zeta)
    t10 = I * t1
    x3 = x * x2
    t11 = 0.5 * I * t2 / x3
    t12 = I_0 + t3
    t13 = 1.0 / (h * h)
    return (
        I * I_A + R * R_A,
        I * (I_0 * t0 + t0 * t3) + R,
        I * (I_0AA * x2 + 2.0 * d - t5 * t9) + I_A * t8 + R * (-R_A * t4 + h_AA * x2),
        I_A * t1 * t7 + R * t4 + R_A + t10 * t9,
        t0 * (I * I_0A - I * t12 * t4 + R_A * t0 * t11 + t10 * zeta + t12 * t8),
        t1 * t12 * t13 * t6 - t11 * t13 + 1.0,
    )


def folds_far_by_x(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 40.
    Proved, error / u (1 + kappa): -, 1.01, 1.01, 2.01, 3.67, 7.67
    Measured, error / u (1 + kappa): 0.59
    """
    t0 = I * I_A + R * R_A
    t1 = R * x
    t2 = A * zeta + I_0 * x
    t3 = x * x
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        t0,
        2.0 * t0,
        4.0 * (I * t2 + h * t1),
        I * (I_0AA * t3 + 2.0 * d) + I_A * I_A + R * h_AA * t3 + R_A * R_A,
        2.0 * (I * (I_0A * x + zeta) + I_A * t2 + R_A * h * x + h_A * t1),
    )


def peaks_far_by_x(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.

    Equation from (24). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 54.
    Proved, error / u (1 + kappa): -, 7.51, 1.01, 2.01, 16.21, 8.51
    Measured, error / u (1 + kappa): 0.91
    """
    t0 = R * h
    t1 = A * zeta
    t2 = I_0 * x
    t3 = 2.0 * t1
    t4 = A * A
    t5 = d / x
    t6 = t2 + t3 + t4 * t5
    t7 = t1 + t2
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        I * I_0 + t0 + t1 * t6,
        2.0 * (I * I_A + R * R_A),
        4.0 * (I * t7 + t0 * x),
        I_0 * I_A + I_0A * (I + t1 * x) + R * h_A + R_A * h + t3 * (A * t5 + zeta) + t6 * zeta,
        2.0 * I_0 * t7 + 2.0 * h * h * x + t1 * (I_0 - d * t4 / (x * x)),
    )


def cusps_far_by_x(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.

    Equation from (30), (33). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 62.
    Proved, error / u (1 + kappa): 1.01, 3.34, 3.01, 7.67, 4.21, -
    Measured, error / u (1 + kappa): 0.75
    """
    t0 = 2.0 * d
    x2 = x * x
    t1 = I_0AA * x2
    t2 = R * x2
    t3 = I_A * I_A + R_A * R_A + h_AA * t2
    t4 = t0 + t1
    t5 = R * x
    t6 = R_A * x
    t7 = I_0A * x + zeta
    t8 = A * zeta + I_0 * x
    x3 = x * x2
    return (
        I * I_A + R * R_A,
        I * t0 + I * t1 + t3,
        I * t4 + t3,
        2.0 * (I * t7 + I_A * t8 + h * t6 + h_A * t5),
        I * I_0AAA * x2 + 3.0 * I_A * t4 + 3.0 * R_A * h_AA * x2 + h_AAA * t2,
        2.0 * (I * I_0AA * x + 2.0 * I_A * t7 + h * h_AA * x3 + 2.0 * h_A * t6 + h_AA * t5 + t4 * t8),
    )


def isolas_far_by_x(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast. Operations: 65.
    Proved, error / u (1 + kappa): 1.01, 7.51, 3.67, 7.67, 16.21, 8.51
    """
    t0 = A * zeta
    t1 = I_0 * x
    t2 = 2.0 * t0
    t3 = A * A
    t4 = d / x
    t5 = t1 + t2 + t3 * t4
    t6 = x * x
    t7 = R * h_A
    t8 = R_A * h
    t9 = t0 + t1
    return (
        I * I_A + R * R_A,
        I * I_0 + R * h + t0 * t5,
        I * (I_0AA * t6 + 2.0 * d) + I_A * I_A + R * h_AA * t6 + R_A * R_A,
        2.0 * (I * (I_0A * x + zeta) + I_A * t9 + t7 * x + t8 * x),
        I_0 * I_A + I_0A * (I + t0 * x) + t2 * (A * t4 + zeta) + t5 * zeta + t7 + t8,
        2.0 * I_0 * t9 + 2.0 * h * h * x + t0 * (I_0 - d * t3 / t6),
    )

