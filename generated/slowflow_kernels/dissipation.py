
"""Structural and quadratic damping, and dry friction of what is attached.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/paper/averaging.py, derivations/paper/slow_flow.py, derivations/extensions/dissipation.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless, for any kind of number that has arithmetic: floats, complex numbers, arrays, an integrator's
symbols. Each output has the shape of the arguments that it depends on, broadcast. Each docstring gives equation number,
domain and floating-point operations.
Rounding errors are in u (1 + kappa), u = 2^-53: proved ones hold wherever nothing overflows or underflows, measured
ones are the worst of all outputs that was found, by a search for it with A 1e-09 to 1000, F_0 1e-09 to 1000, I
1e-12 to 1000 or 0, I_0 1e-12 to 1 or 0, I_0A 1e-09 to 1e+06 of either sign or 0, I_0AA 1e-09 to 1e+09 of either
sign or 0, I_0AAA 1e-09 to 1e+12 of either sign or 0, I_0_over_A 1e-12 to 1e+06 or 0, I_A 1e-09 to 1e+06 of either
sign or 0, I_over_A 1e-12 to 1e+06 or 0, Omega 0.001 to 1000, R 1e-09 to 1e+06 of either sign or 0, R_A 1e-09 to
1e+06 of either sign or 0, c_2 1e-12 to 1000 or 0, c_3 1e-12 to 1000 or 0, d 1e-12 to 1000 or 0, d_3 1e-12 to 1000
or 0, eta 1e-12 to 1 or 0, h 1e-12 to 1000 of either sign or 0, h_A 1e-09 to 1e+06 of either sign or 0, h_AA 1e-09
to 1e+09 of either sign or 0, h_AAA 1e-09 to 1e+12 of either sign or 0, h_over_A 1e-09 to 1e+06 of either sign or 0,
m 1e-12 to 1 or 0, steepest 1e-09 to 1e+06 or 0, u_cr 1e-06 to 1, x 0.001 to 1000, zeta 1e-12 to 1 or 0, zeta_2
1e-12 to 1000 or 0, zeta_A 1e-09 to 1e+06 or 0, zeta_AA 1e-09 to 1e+06 or 0, zeta_AAA 1e-09 to 1e+06 or 0.
"""

# a formatter would spread each polynomial over a page
# fmt: off

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np


__all__ = [
    "F_A", "F_AA", "I_A", "F", "F_AOmega", "F_AOmegaOmega", "F_A_halved", "F_A_scaled", "F_Omega", "F_OmegaOmega",
    "I", "I_scaled", "Omega_A", "Omega_A_by_inertia", "R_of_peak", "R_of_response", "R_where_stationary", "at_rest",
    "cubic", "cusp_bend", "cusp_bend_by_inertia", "cusps_by_Omega", "cusps_by_R", "cusps_far_by_R",
    "cusps_far_by_x", "far", "far_by_inertia", "fold_polynomial", "folds_by_Omega", "folds_by_R", "folds_far_by_R",
    "folds_far_by_x", "full_by_inertia", "isola_bend", "isola_bend_by_inertia", "isolas_by_Omega", "isolas_by_R",
    "isolas_far_by_R", "isolas_far_by_x", "least_scaled", "limit_envelope", "peaks_by_Omega", "peaks_by_R",
    "peaks_far_by_R", "peaks_far_by_x", "quadratic", "quadratic_bound", "released", "released_moves",
    "response_polynomial", "rest_moves", "restoring", "stability", "static", "structural_bound", "turn_share",
    "turns_by_Omega", "turns_by_R", "viscous", "viscous_moves",
]


def quadratic(c_2: Any) -> Any:
    """The factor of A^2 Omega^2 in I of quadratic damping.

    Equation from (19). Domain: any. Operations: 1. Error / u (1 + kappa): measured 0.69.
    """
    return 0.84882636315677518 * c_2


def cubic(c_3: Any) -> Any:
    """The factor of A^3 Omega^3 in I of cubic damping.

    Equation from (19). Domain: any. Operations: 1. Error / u (1 + kappa): proved 0.51.
    """
    return 0.75 * c_3


def restoring(A: Any, F_0: Any, d: Any) -> Any:
    """The largest |h| of a state with this amplitude, as quadratic damping bounds its frequency.

    Equation from (23). Domain: A > 0, d > 0. Operations: 3. Error / u (1 + kappa): proved 2.01.
    """
    return F_0 + F_0 / (A * d)


def at_rest(A: Any, m: Any, eta: Any) -> tuple[Any, Any, Any, Any]:
    """I_0, I at Omega = 0, and three derivatives by A: friction acts throughout.

    Equation from (19). Domain: A > 0. Operations: 2. Error / u (1 + kappa): proved 1.01, 0.0, 0.0, 0.0.
    """
    return A * eta + m, eta, 0.0, 0.0


def released(A: Any, m: Any, eta: Any, u_cr: Any) -> tuple[Any, Any, Any, Any]:
    """The same where friction acts for |u| < u_cr only.

    Equation from (19). Domain: A >= u_cr > 0. Operations: 13. Error / u (1 + kappa): proved 1.01, 1.01, 0.67, 0.86.
    """
    t0 = m * u_cr
    A2 = A * A
    A3 = A * A2
    A4 = A2 * A2
    return A * eta + t0 / A, eta - t0 / A2, 2.0 * t0 / A3, -6.0 * t0 / A4


def rest_moves(A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """What m, then eta, does to I_0, I_0A and I_0AA: friction acts throughout.

    Equation from (19). Domain: A > 0. Operations: 0. Error / u (1 + kappa): proved 0.0, 0.0, 0.0, 0.0, 0.0, 0.0.
    """
    return 1.0, 0.0, 0.0, A, 1.0, 0.0


def released_moves(A: Any, m: Any, u_cr: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """What m, then eta, then u_cr does to them where friction acts for |u| < u_cr only.

    Equation from (19). Domain: A >= u_cr > 0. Operations: 11. Error / u (1 + kappa): proved 0.81 at most.
    """
    t0 = 1.0 / A
    A2 = A * A
    t1 = 1.0 / A2
    A3 = A * A2
    t2 = 2.0 / A3
    return t0 * u_cr, -t1 * u_cr, t2 * u_cr, A, 1.0, 0.0, m * t0, -m * t1, m * t2


def viscous(A: Any, zeta: Any, zeta_2: Any) -> tuple[Any, Any, Any, Any]:
    """The viscous damping ratio of a cycle, and three derivatives by A.

    Equation from (19). Domain: A > 0. Operations: 6. Error / u (1 + kappa): proved 1.01, 0.34, 0.0, 0.0.
    """
    t0 = 0.5 * zeta_2
    return 0.25 * A * A * zeta_2 + zeta, A * t0, t0, 0.0


def viscous_moves(A: Any) -> tuple[Any, Any, Any]:
    """What zeta_2 does to the first three of `viscous`.

    Equation from (19). Domain: A > 0. Operations: 3. Error / u (1 + kappa): proved 0.34, 0.0, 0.0.
    """
    return 0.25 * A * A, 0.5 * A, 0.5


def I(Omega: Any, A: Any, I_0: Any, zeta: Any, d: Any, d_3: Any) -> Any:  # noqa: E743
    """Sine balance, -F_0 sin phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0. Operations: 14. Error / u (1 + kappa): proved 7.01.
    """
    A2 = A * A
    Omega2 = Omega * Omega
    A3 = A * A2
    Omega3 = Omega * Omega2
    return 2.0 * A * Omega * zeta + A2 * Omega2 * d + A3 * Omega3 * d_3 + I_0


def I_A(Omega: Any, A: Any, I_0A: Any, zeta: Any, zeta_A: Any, d: Any, d_3: Any) -> Any:
    """dI/dA.

    Equation (23). Domain: Omega > 0, A > 0. Operations: 17. Error / u (1 + kappa): proved 7.26.
    """
    t0 = 2.0 * Omega
    Omega2 = Omega * Omega
    Omega3 = Omega * Omega2
    return 3.0 * A * A * Omega3 * d_3 + 2.0 * A * Omega2 * d + A * t0 * zeta_A + I_0A + t0 * zeta


def far(x: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, zeta_A: Any, d: Any, h: Any, h_A: Any) -> tuple[Any, Any, Any, Any]:
    """R, R_A, I and I_A over Omega^2, at x = 1/Omega.

    Equation (23). Domain: x >= 0, A > 0. Operations: 21. Error / u (1 + kappa): proved 1.01, 1.34, 4.01, 4.51.
    """
    t0 = x * x
    t1 = 2.0 * A
    t2 = x * zeta
    return (
        A + h * t0,
        h_A * t0 + 1.0,
        A * A * d + I_0 * t0 + t1 * t2,
        I_0A * t0 + d * t1 + t1 * x * zeta_A + 2.0 * t2,
    )


def F(Omega: Any, A: Any, F_0: Any, I_0: Any, zeta: Any, d: Any, d_3: Any, h: Any) -> Any:
    """Zero at a steady state.

    Equation (24). Domain: Omega > 0, A > 0. Operations: 21. Error / u (1 + kappa): measured 0.51.
    """
    Omega2 = Omega * Omega
    R = A * Omega2 + h
    A2 = A * A
    A3 = A * A2
    Omega3 = Omega * Omega2
    I = 2.0 * A * Omega * zeta + A2 * Omega2 * d + A3 * Omega3 * d_3 + I_0
    return R * R + (-F_0 + I) * (F_0 + I)


def F_A(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, zeta_A: Any, d: Any, d_3: Any, h: Any, h_A: Any) -> Any:
    """dF/dA; positive where stable.

    Equation (24), (30). Domain: Omega > 0, A > 0. Operations: 31. Error / u (1 + kappa): measured 0.64.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * Omega
    t2 = t1 * zeta
    A2 = A * A
    Omega3 = Omega * Omega2
    t3 = Omega3 * d_3
    A3 = A * A2
    I = A * t2 + A2 * Omega2 * d + A3 * t3 + I_0
    return 2.0 * (I * (A * t1 * zeta_A + 3.0 * A2 * t3 + I_0A + 2.0 * d * t0 + t2) + R * (Omega2 + h_A))


def F_AA(Omega: Any, A: Any, I_0: Any, I_0A: Any, I_0AA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any) -> Any:
    """d2F/dA2.

    Equation (24). Domain: Omega > 0, A > 0. Operations: 48. Error / u (1 + kappa): measured 0.89.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * Omega
    t2 = t1 * zeta
    A2 = A * A
    Omega3 = Omega * Omega2
    t3 = Omega3 * d_3
    A3 = A * A2
    I = A * t2 + A2 * Omega2 * d + A3 * t3 + I_0
    t4 = t1 * zeta_A
    t5 = I * t1
    t6 = Omega2 + h_A
    t7 = A * t4 + 3.0 * A2 * t3 + I_0A + 2.0 * d * t0 + t2
    return (
        2.0 * (A * t5 * zeta_AA + I * I_0AA + I * t4 + R * h_AA + t5 * (Omega * d + 3.0 * d_3 * t0 + zeta_A) + t6 *
        t6 + t7 * t7)
    )


def F_Omega(Omega: Any, A: Any, I_0: Any, zeta: Any, d: Any, d_3: Any, h: Any) -> Any:
    """dF/dOmega.

    Equation (24). Domain: Omega > 0, A > 0. Operations: 28. Error / u (1 + kappa): measured 0.79.
    """
    Omega2 = Omega * Omega
    R = A * Omega2 + h
    t0 = 2.0 * zeta
    A2 = A * A
    t1 = A2 * Omega2
    A3 = A * A2
    Omega3 = Omega * Omega2
    I = A * Omega * t0 + A3 * Omega3 * d_3 + I_0 + d * t1
    t2 = 2.0 * Omega
    return 2.0 * A * (I * (A * d * t2 + 3.0 * d_3 * t1 + t0) + R * t2)


def F_OmegaOmega(Omega: Any, A: Any, I_0: Any, zeta: Any, d: Any, d_3: Any, h: Any) -> Any:
    """d2F/dOmega2.

    Equation (24). Domain: Omega > 0, A > 0. Operations: 35. Error / u (1 + kappa): measured 0.84.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * zeta
    t2 = A * Omega
    A2 = A * A
    t3 = A2 * Omega2
    A3 = A * A2
    Omega3 = Omega * Omega2
    I = A3 * Omega3 * d_3 + I_0 + d * t3 + t1 * t2
    t4 = 3.0 * d_3
    t5 = 2.0 * A
    t6 = Omega * d * t5 + t1 + t3 * t4
    return t5 * (A * t6 * t6 + I * t5 * (d + t2 * t4) + 2.0 * R + 4.0 * t0)


def F_AOmega(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, zeta_A: Any, d: Any, d_3: Any, h: Any, h_A: Any) -> Any:
    """d2F/dA dOmega.

    Equation (24). Domain: Omega > 0, A > 0. Operations: 51. Error / u (1 + kappa): measured 0.38.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * zeta
    t2 = Omega * t1
    A2 = A * A
    t3 = A2 * Omega2
    Omega3 = Omega * Omega2
    t4 = Omega3 * d_3
    A3 = A * A2
    I = A * t2 + A3 * t4 + I_0 + d * t3
    t5 = 2.0 * A
    t6 = t5 * zeta_A
    t7 = Omega * d
    t8 = d_3 * t3
    return (
        2.0 * (A * (t1 + t5 * t7 + 3.0 * t8) * (3.0 * A2 * t4 + I_0A + Omega * t6 + 2.0 * d * t0 + t2) + I * (4.0 *
        A * t7 + t1 + t6 + 9.0 * t8) + 2.0 * Omega * R + Omega * t5 * (Omega2 + h_A))
    )


def F_AOmegaOmega(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, zeta_A: Any, d: Any, d_3: Any, h: Any, h_A: Any) -> Any:
    """d3F/dA dOmega2.

    Equation (24). Domain: Omega > 0, A > 0. Operations: 59. Error / u (1 + kappa): measured 0.76.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * zeta
    t2 = Omega * t1
    A2 = A * A
    t3 = A2 * Omega2
    Omega3 = Omega * Omega2
    t4 = Omega3 * d_3
    A3 = A * A2
    I = A * t2 + A3 * t4 + I_0 + d * t3
    t5 = 2.0 * d
    t6 = A * Omega
    t7 = 9.0 * d_3
    t8 = 3.0 * d_3
    t9 = 2.0 * A * zeta_A
    return (
        4.0 * (A * I * (t5 + t6 * t7) + A * (Omega2 + h_A) + A * (t1 + t3 * t8 + t5 * t6) * (4.0 * d * t6 + t1 + t3
        * t7 + t9) + A2 * (d + t6 * t8) * (3.0 * A2 * t4 + I_0A + Omega * t9 + t0 * t5 + t2) + R + 4.0 * t0)
    )


def Omega_A(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, zeta_A: Any, d: Any, d_3: Any, h: Any, h_A: Any) -> Any:
    """dOmega/dA along the response.

    Equation from (24). Domain: Omega > 0, A > 0. Operations: 46. Error / u (1 + kappa): measured 0.78.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * zeta
    t2 = A * t1
    A2 = A * A
    t3 = A2 * d
    Omega3 = Omega * Omega2
    A3 = A * A2
    t4 = A3 * d_3
    I = I_0 + Omega * t2 + Omega2 * t3 + Omega3 * t4
    t5 = 2.0 * Omega
    return (
        -2.0 * (I * (A * t5 * zeta_A + 3.0 * A2 * Omega3 * d_3 + I_0A + Omega * t1 + 2.0 * d * t0) + R * (Omega2 +
        h_A)) / (4.0 * A * Omega * R + 2.0 * I * (3.0 * Omega2 * t4 + t2 + t3 * t5))
    )


def Omega_A_by_inertia(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, zeta_A: Any, d: Any, d_3: Any, h: Any, h_A: Any) -> Any:
    """The same of an excitation by inertia.

    Equation from (24). Domain: Omega > 0, A > 0. Operations: 42. Error / u (1 + kappa): measured 0.95.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = Omega * zeta
    t2 = A * t1
    A2 = A * A
    Omega3 = Omega * Omega2
    t3 = Omega3 * d_3
    A3 = A * A2
    t4 = A3 * t3
    I = A2 * Omega2 * d + I_0 + 2.0 * t2 + t4
    t5 = 2.0 * Omega
    return (
        t5 * (I * (A * t5 * zeta_A + 3.0 * A2 * t3 + I_0A + 2.0 * d * t0 + 2.0 * t1) + R * (Omega2 + h_A)) / (4.0 *
        I * (I_0 + t2 - 0.5 * t4) + 4.0 * R * h)
    )


def cusp_bend(Omega: Any, A: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any) -> Any:
    """Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 98. Error / u (1 + kappa): measured 0.93.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * zeta
    t2 = Omega * t1
    A2 = A * A
    t3 = A2 * Omega2
    Omega3 = Omega * Omega2
    t4 = Omega3 * d_3
    A3 = A * A2
    I = A * t2 + A3 * t4 + I_0 + d * t3
    t5 = 2.0 * Omega
    t6 = t5 * zeta_AA
    t7 = A * t5
    t8 = Omega2 + h_A
    t9 = t5 * zeta_A
    t10 = A * t9 + 3.0 * A2 * t4 + I_0A + 2.0 * d * t0 + t2
    t11 = 4.0 * Omega
    t12 = t10 * t11
    t13 = A * t10
    t14 = Omega * d
    t15 = 3.0 * d_3
    t16 = t0 * t15 + t14 + zeta_A
    F_AAA = (
        2.0 * (I * I_0AAA + 6.0 * I * t4 + I * t6 + I * t7 * zeta_AAA + 2.0 * I_0AA * t10 + R * h_AAA + 3.0 * h_AA *
        t8 + t10 * (A * t6 + I_0AA + t16 * t5 + t9) + t11 * zeta_AA * (I + t13) + t12 * t16 + t12 * zeta_A)
    )
    t17 = R * t5
    t18 = 2.0 * A
    t19 = t1 + t14 * t18 + t15 * t3
    F_Omega = t18 * (I * t19 + t17)
    F_AOmega = 2.0 * (I * (4.0 * A * t14 + 9.0 * d_3 * t3 + t1 + t18 * zeta_A) + t13 * t19 + t17 + t7 * t8)
    return -F_AAA * F_AOmega * F_Omega / A


def isola_bend(Omega: Any, A: Any, I_0: Any, I_0A: Any, I_0AA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any) -> tuple[Any, Any]:
    """At an isola point: negative at a saddle of F; and as `cusp_bend`.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 133. Error / u (1 + kappa): measured 0.71.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * zeta
    t2 = Omega * t1
    A2 = A * A
    t3 = A2 * Omega2
    A3 = A * A2
    Omega3 = Omega * Omega2
    t4 = Omega3 * d_3
    I = A * t2 + A3 * t4 + I_0 + d * t3
    t5 = R * h_AA
    t6 = Omega * zeta_A
    t7 = Omega * d
    t8 = 3.0 * d_3
    t9 = 2.0 * Omega
    t10 = 2.0 * A
    t11 = Omega * t10
    t12 = t11 * zeta_AA
    t13 = Omega2 + h_A
    t14 = 2.0 * d
    t15 = 3.0 * A2
    t16 = I_0A + t0 * t14 + t10 * t6 + t15 * t4 + t2
    t17 = t13 * t13 + t16 * t16
    F_AA = 2.0 * (I * I_0AA + I * t12 + 2.0 * I * t6 + I * t9 * (t0 * t8 + t7 + zeta_A) + t17 + t5)
    t18 = A * t1 + 2.0 * A2 * t7 + A3 * Omega2 * t8
    G_AOmega = t11 * t13 + t16 * t18
    G_OmegaOmega = t18 * t18 + 4.0 * t3
    S_AA = I * (6.0 * A * t4 + I_0AA + Omega2 * t14 + t12 + 4.0 * t6) + t5
    S_AOmega = I * (4.0 * A * t7 + 9.0 * d_3 * t3 + t1 + t10 * zeta_A) + R * t9
    S_OmegaOmega = I * (A2 * t14 + 6.0 * A3 * Omega * d_3) + R * t10
    t19 = 4.0 * S_OmegaOmega
    Omega4 = Omega2 * Omega2
    t20 = (
        A * Omega3 * t14 + I_0A * t9 + Omega2 * t1 + Omega4 * d_3 * t15 - h_A * t1 - h_A * t10 * t7 - h_A * t3 * t8
        + 4.0 * t0 * zeta_A
    )
    t21 = (
        4.0 * A2 * t20 * t20 - 8.0 * G_AOmega * S_AOmega + 4.0 * G_OmegaOmega * S_AA + S_AA * t19 - 4.0 * S_AOmega *
        S_AOmega + t17 * t19
    )
    return t21, F_AA * t21


def stability(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, zeta_A: Any, d: Any, d_3: Any, h: Any, h_A: Any) -> Any:
    """4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.

    Equation (30). Domain: Omega > 0, A > 0. Operations: 31. Error / u (1 + kappa): measured 0.41.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * Omega
    t2 = t1 * zeta
    A2 = A * A
    Omega3 = Omega * Omega2
    t3 = Omega3 * d_3
    A3 = A * A2
    I = A * t2 + A2 * Omega2 * d + A3 * t3 + I_0
    return (I * (A * t1 * zeta_A + 3.0 * A2 * t3 + I_0A + 2.0 * d * t0 + t2) + R * (Omega2 + h_A)) / A


def static(F_0: Any, I_0: Any, I_0A: Any, h: Any, h_A: Any) -> tuple[Any, Any, Any, Any]:
    """F at Omega = 0 by its halves h - c and h + c, c^2 = F_0^2 - I_0^2; and the slope of each.

    Equation from (24). Domain: F_0 > I_0. Operations: 10. Error / u (1 + kappa): measured 0.71.
    """
    c = np.sqrt((F_0 - I_0) * (F_0 + I_0))
    t0 = I_0 * I_0A / c
    return -c + h, c + h, h_A + t0, h_A - t0


def response_polynomial(A: Any, I_0: Any, zeta: Any, d: Any, d_3: Any, h: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any]:
    """F + F_0^2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^6.

    Equation (24). Domain: A > 0. Operations: 34. Error / u (1 + kappa): proved 0.67, 0.51, 2.51, 2.51, 3.67, 0.76,
    0.78.
    """
    t0 = 4.0 * zeta
    A2 = A * A
    t1 = 2.0 * I_0
    A3 = A * A2
    A4 = A2 * A2
    A5 = A * A4
    A6 = A3 * A3
    return (
        I_0 * I_0 + h * h,
        A * I_0 * t0,
        2.0 * A * h + A2 * (d * t1 + 4.0 * zeta * zeta),
        A3 * (d * t0 + d_3 * t1),
        A2 + A4 * (d * d + d_3 * t0),
        2.0 * A5 * d * d_3,
        A6 * d_3 * d_3,
    )


def fold_polynomial(A: Any, I_0: Any, I_0A: Any, zeta: Any, zeta_A: Any, d: Any, d_3: Any, h: Any, h_A: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any]:
    """F_A/2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^6.

    Equation (30). Domain: A > 0. Operations: 56. Error / u (1 + kappa): proved 1.01, 2.01, 7.15, 6.01, 6.17, 0.86,
    0.88.
    """
    t0 = 2.0 * I_0
    A2 = A * A
    A3 = A * A2
    t1 = 2.0 * zeta_A
    A4 = A2 * A2
    t2 = A4 * d_3
    A5 = A * A4
    return (
        I_0 * I_0A + h * h_A,
        A * (2.0 * I_0A * zeta + t0 * zeta_A) + t0 * zeta,
        A * h_A + A * (d * t0 + 4.0 * zeta * zeta) + A2 * (I_0A * d + 4.0 * zeta * zeta_A) + h,
        A2 * (3.0 * I_0 * d_3 + 6.0 * d * zeta) + A3 * (I_0A * d_3 + d * t1),
        A + A3 * (2.0 * d * d + 8.0 * d_3 * zeta) + t1 * t2,
        5.0 * d * t2,
        3.0 * A5 * d_3 * d_3,
    )


def limit_envelope(Omega: Any, F_0: Any, m: Any, zeta: Any, eta: Any, d: Any) -> Any:
    """Largest amplitude that the forcing can hold at this frequency, where friction acts throughout.

    Equation (27). Domain: Omega > 0, F_0 > m, one of zeta, eta, d > 0. Operations: 16. Error / u (1 + kappa):
    measured 0.89.
    """
    t0 = 2.0 * Omega * zeta + eta
    return (2.0 * F_0 - 2.0 * m) / (t0 + np.sqrt(-4.0 * Omega * Omega * d * (-F_0 + m) + t0 * t0))


def turn_share(x: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, zeta_A: Any, d: Any) -> Any:
    """D/Omega^2 at x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D without cubic damping.

    Equation from (30). Domain: x >= 0, A > 0. Operations: 39. Error / u (1 + kappa): measured 0.69.
    """
    A2 = A * A
    A3 = A * A2
    t0 = A * I_0
    t1 = A2 * d
    x2 = x * x
    x3 = x * x2
    return (
        4.0 * A3 * d * d + x * (3.0 * A3 * d * zeta_A + 9.0 * t1 * zeta) + x2 * (4.0 * A * zeta * zeta + 4.0 * A2 *
        zeta * zeta_A + I_0A * t1 + 2.0 * d * t0) + x3 * (A * I_0A * zeta + I_0 * zeta + t0 * zeta_A)
    )


def F_A_halved(R: Any, R_A: Any, I: Any, I_A: Any) -> Any:
    """F_A/2 by R, I and their slopes.

    Equation (30). Domain: Omega >= 0, A > 0. Operations: 3. Error / u (1 + kappa): proved 1.01.
    """
    return I * I_A + R * R_A


def R_of_response(F_0: Any, I: Any) -> Any:
    """The size of R where F = 0.

    Equation (24). Domain: Omega >= 0, A > 0. Operations: 4. Error / u (1 + kappa): measured 0.62.
    """
    return np.sqrt(F_0 * F_0 - I * I)


def R_of_peak(Omega: Any, A: Any, zeta: Any, d: Any, d_3: Any, I: Any) -> Any:
    """R where F_Omega = 0.

    Equation from (24). Domain: Omega >= 0, A > 0. Operations: 9. Error / u (1 + kappa): proved 4.76.
    """
    return I * (-1.5 * A * A * Omega * d_3 - A * d - zeta / Omega)


def R_where_stationary(x: Any, A: Any, I_0: Any, zeta: Any, d: Any) -> tuple[Any, Any, Any]:
    """Where a level by inertia is stationary, x = 1/Omega: what is not negative, lower and higher R/Omega^2.

    Equation from (24). Domain: Omega >= 0, A > 0. Operations: 20. Error / u (1 + kappa): measured 0.92.
    """
    t0 = A * A
    t1 = A * zeta
    t2 = x * (I_0 * x + t1) * (I_0 * x * x + d * t0 + 2.0 * t1 * x)
    t3 = t0 - 4.0 * t2
    t4 = 0.5 * A + 0.5 * np.sqrt(t3)
    return t3, t2 / t4, t4


def I_scaled(Omega: Any, A: Any, I_0_over_A: Any, zeta: Any, d: Any, d_3: Any) -> Any:
    """I/A, by I_0/A.

    Equation (23). Domain: Omega >= 0, A > 0. Operations: 12. Error / u (1 + kappa): proved 6.01.
    """
    Omega2 = Omega * Omega
    Omega3 = Omega * Omega2
    return A * A * Omega3 * d_3 + A * Omega2 * d + I_0_over_A + 2.0 * Omega * zeta


def F_A_scaled(Omega: Any, h_over_A: Any, h_A: Any, I_over_A: Any, I_A: Any) -> Any:
    """F_A/(2 A), by h/A and I/A.

    Equation (30). Domain: Omega >= 0, A > 0. Operations: 6. Error / u (1 + kappa): measured 0.95.
    """
    t0 = Omega * Omega
    return I_A * I_over_A + (h_A + t0) * (h_over_A + t0)


def least_scaled(Omega: Any, zeta: Any, eta: Any, d: Any, h_AA: Any) -> tuple[Any, Any]:
    """Of what 4/A times the least F_A/2 is not below where |k| <= A^2 |h_AA|/2, friction throughout: 1, A^2.

    Equation from (30). Domain: Omega >= 0. Operations: 13. Error / u (1 + kappa): proved -, 1.01; measured 0.78.
    """
    t0 = 2.0 * Omega * zeta + eta
    Omega2 = Omega * Omega
    Omega4 = Omega2 * Omega2
    return 4.0 * t0 * t0, 8.0 * Omega4 * d * d - 0.25 * h_AA * h_AA


def far_by_inertia(x: Any, A: Any, F_0: Any, I_0: Any, zeta: Any, d: Any, h: Any) -> tuple[Any, Any, Any]:
    """F/Omega^4 at x = 1/Omega; and -Omega^3/4 dlevel^2/dOmega, less Omega times the third.

    Equation (24). Domain: x >= 0, A > 0. Operations: 34. Error / u (1 + kappa): proved -, -, 0.67; measured 1.2.
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


def cusp_bend_by_inertia(Omega: Any, A: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any) -> Any:
    """As `cusp_bend`, for an excitation by inertia.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 102. Error / u (1 + kappa): measured 0.81.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * zeta
    t2 = Omega * t1
    A2 = A * A
    t3 = A2 * Omega2
    Omega3 = Omega * Omega2
    t4 = Omega3 * d_3
    A3 = A * A2
    t5 = A3 * t4
    I = A * t2 + I_0 + d * t3 + t5
    t6 = 2.0 * Omega
    t7 = t6 * zeta_AA
    t8 = A * t6
    t9 = Omega2 + h_A
    t10 = t6 * zeta_A
    t11 = A * t10 + 3.0 * A2 * t4 + I_0A + 2.0 * d * t0 + t2
    t12 = 4.0 * Omega
    t13 = t11 * t12
    t14 = A * t11
    t15 = Omega * d
    t16 = 3.0 * d_3
    t17 = t0 * t16 + t15 + zeta_A
    F_AAA = (
        2.0 * (I * I_0AAA + 6.0 * I * t4 + I * t7 + I * t8 * zeta_AAA + 2.0 * I_0AA * t11 + R * h_AAA + 3.0 * h_AA *
        t9 + t11 * (A * t7 + I_0AA + t10 + t17 * t6) + t12 * zeta_AA * (I + t14) + t13 * t17 + t13 * zeta_A)
    )
    t18 = 2.0 * A
    F_AOmega = (
        2.0 * (I * (4.0 * A * t15 + 9.0 * d_3 * t3 + t1 + t18 * zeta_A) + R * t6 + t14 * (t1 + t15 * t18 + t16 * t3)
        + t8 * t9)
    )
    return F_AAA * F_AOmega * (I * (A * Omega * zeta + I_0 - 0.5 * t5) + R * h)


def isola_bend_by_inertia(Omega: Any, A: Any, I_0: Any, I_0A: Any, I_0AA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any) -> tuple[Any, Any]:
    """As `isola_bend`, for an excitation by inertia.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 102. Error / u (1 + kappa): measured 1.5.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * zeta
    t2 = Omega * t1
    A2 = A * A
    t3 = A2 * Omega2
    A3 = A * A2
    Omega3 = Omega * Omega2
    t4 = Omega3 * d_3
    t5 = A3 * t4
    I = A * t2 + I_0 + d * t3 + t5
    t6 = 2.0 * zeta_A
    t7 = 2.0 * Omega
    t8 = I * t7
    t9 = Omega2 + h_A
    t10 = Omega * d
    t11 = 3.0 * d_3
    t12 = A * t6
    t13 = 3.0 * A2 * t4 + I_0A + Omega * t12 + 2.0 * d * t0 + t2
    F_AA = (
        2.0 * (A * t8 * zeta_AA + I * I_0AA + I * Omega * t6 + R * h_AA + t13 * t13 + t8 * (t0 * t11 + t10 + zeta_A)
        + t9 * t9)
    )
    t14 = A * t10
    F_AOmega = (
        2.0 * (A * t13 * (t1 + t11 * t3 + 2.0 * t14) + A * t7 * t9 + I * (9.0 * d_3 * t3 + t1 + t12 + 4.0 * t14) + R
        * t7)
    )
    t15 = A3 * Omega2
    F_OmegaOmega = (
        (-8.0 * A * Omega * h - 4.0 * I * (A * zeta - 1.5 * d_3 * t15) - 4.0 * (A * t1 + 2.0 * A2 * t10 + t11 * t15)
        * (A * Omega * zeta + I_0 - 0.5 * t5)) / Omega
    )
    t16 = F_AA * F_OmegaOmega - F_AOmega * F_AOmega
    return t16, F_AA * t16


def full_by_inertia(F_0: Any, d: Any) -> Any:
    """The amplitude that the response tends to as Omega grows.

    Equation from (24). Domain: F_0 > 0. Operations: 10. Error / u (1 + kappa): measured 1.4.
    """
    return 1.4142135623730951 * F_0 / np.sqrt(np.sqrt(4.0 * F_0 * F_0 * d * d + 1.0) + 1.0)


def structural_bound(A: Any, F_0: Any, eta: Any, h: Any, steepest: Any) -> tuple[Any, Any]:
    """Both positive: no state above A, while |h| grows by steepest dA at most.

    Equation from (23), (24). Domain: A > 0. Operations: 10. Error / u (1 + kappa): proved -, 3.76; measured 0.85.
    """
    t0 = A - F_0
    t1 = A * eta
    return -F_0 * np.abs(h) + t0 * t1, -F_0 * steepest + eta * t0 + t1


def quadratic_bound(F_0: Any, d: Any) -> Any:
    """What no amplitude exceeds.

    Equation from (23), (24). Domain: d > 0. Operations: 3. Error / u (1 + kappa): measured 1.2.
    """
    return np.sqrt(F_0) / np.sqrt(d)


def folds_by_R(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and F_A/2; derivatives by A and by R of the first, then of the second.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 73. Error / u (1 + kappa): proved -, 1.01, 9.26,
    8.26, -, -; measured 0.83.
    """
    t0 = 1.0 / Omega
    t1 = 2.0 * zeta
    t2 = 2.0 * A
    Omega2 = Omega * Omega
    t3 = A * A * Omega2 * d_3
    t4 = t0 * (Omega * d * t2 + t1 + 3.0 * t3)
    t5 = R_A * t4
    t6 = 1.0 / A
    t7 = R_A * t6
    t8 = 0.5 * I_A
    t9 = A * Omega
    t10 = 4.0 * d
    t11 = t0 * (t1 + t10 * t9 + t2 * zeta_A + 9.0 * t3)
    t12 = 0.5 * I
    Omega3 = Omega * Omega2
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        I * I_A + R * R_A,
        2.0 * I * (I_A - 0.5 * t5),
        I * t4 + 2.0 * R,
        R * (h_AA - t7) + t12 * (12.0 * A * Omega3 * d_3 + 2.0 * I_0AA + 8.0 * Omega * zeta_A + Omega2 * t10 - t11 *
        t7 + 4.0 * t9 * zeta_AA) + t8 * (2.0 * I_A - t5),
        R * t6 + R_A + t11 * t12 * t6 + t4 * t8,
    )


def peaks_by_R(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second.

    Equation from (24). Domain: Omega > 0, A > 0. Operations: 61. Error / u (1 + kappa): proved -, 6.01, 9.26, 8.26,
    -, -; measured 0.92.
    """
    t0 = A * d
    t1 = 1.0 / Omega
    t2 = t1 * zeta
    t3 = A * A * d_3
    t4 = 2.0 * zeta
    t5 = 2.0 * t0
    t6 = Omega * Omega
    t7 = 3.0 * t3
    t8 = t1 * (Omega * t5 + t4 + t6 * t7)
    t9 = R_A * t8
    t10 = I * t1
    t11 = 0.25 * t10 * (-t4 / t6 + t7) / A
    t12 = 0.25 * Omega * t7 + 0.5 * t2 + 0.25 * t5
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        I * (1.5 * Omega * t3 + t0 + t2) + R,
        2.0 * I * (I_A - 0.5 * t9),
        I * t8 + 2.0 * R,
        I * (3.0 * A * Omega * d_3 + d) - R_A * t11 + t10 * zeta_A + t12 * (2.0 * I_A - t9),
        t11 + t12 * t8 + 1.0,
    )


def cusps_by_R(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and F_AA/2; derivatives by A and by R of the first, then of the second.

    Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 125. Error / u (1 + kappa): proved 1.01, 10.26,
    -, -, -, -; measured 0.71.
    """
    t0 = Omega * zeta_A
    t1 = 4.0 * t0
    t2 = A * zeta_AA
    t3 = Omega * t2
    t4 = 2.0 * t3
    Omega2 = Omega * Omega
    t5 = Omega2 * d
    t6 = 2.0 * t5
    Omega3 = Omega * Omega2
    t7 = Omega3 * d_3
    t8 = A * t7
    t9 = 6.0 * t8
    t10 = 1.0 / A
    t11 = R_A * t10
    t12 = h_AA - t11
    t13 = 1.0 / Omega
    t14 = 2.0 * zeta
    t15 = Omega * d
    t16 = 2.0 * t15
    t17 = A * A * Omega2 * d_3
    t18 = t13 * (A * t16 + t14 + 3.0 * t17)
    t19 = I_A - 0.5 * R_A * t18
    t20 = 2.0 * zeta_A
    t21 = t13 * (4.0 * A * t15 + A * t20 + t14 + 9.0 * t17)
    t22 = 2.0 * I_0AA + 8.0 * t0 - t11 * t21 + 4.0 * t3 + 4.0 * t5 + 12.0 * t8
    t23 = 0.5 * I
    t24 = 0.5 * t18
    t25 = t10 * t21
    t26 = 6.0 * I
    t27 = I * t13 * (9.0 * A * Omega2 * d_3 + t16 + t2 + t20)
    t28 = I_0AA + t1 + t4 + t6 + t9
    return (
        I * I_A + R * R_A,
        I * I_0AA + I * t1 + I * t4 + I * t6 + I * t9 + I_A * I_A + R * h_AA + R_A * R_A,
        I_A * t19 + R * t12 + t22 * t23,
        I_A * t24 + R * t10 + R_A + t23 * t25,
        2.0 * A * I * Omega * zeta_AAA + I * I_0AAA + I_A * t22 + Omega * t26 * zeta_AA + R * h_AAA + 2.0 * R_A *
        t12 - t11 * t27 + t19 * t28 + t26 * t7,
        I_A * t25 + h_AA + t10 * t27 + 2.0 * t11 + t24 * t28,
    )


def isolas_by_R(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0. Operations: 95. Error / u (1 + kappa): proved 1.01, 6.01, -, -, -,
    -; measured 0.67.
    """
    t0 = A * d
    t1 = 1.0 / Omega
    t2 = t1 * zeta
    t3 = A * A * d_3
    t4 = 1.0 / A
    t5 = R_A * t4
    Omega2 = Omega * Omega
    t6 = 2.0 * zeta
    t7 = 2.0 * t0
    t8 = 3.0 * t3
    t9 = t1 * (Omega * t7 + Omega2 * t8 + t6)
    t10 = 2.0 * I_A - R_A * t9
    t11 = 0.5 * I_A
    t12 = 4.0 * Omega
    t13 = A * d_3
    t14 = t1 * (2.0 * A * zeta_A + 9.0 * Omega2 * t3 + t0 * t12 + t6)
    t15 = 0.5 * I
    t16 = I * t1
    t17 = 0.25 * t16 * (t8 - t6 / Omega2)
    t18 = 0.25 * Omega * t8 + 0.5 * t2 + 0.25 * t7
    Omega3 = Omega * Omega2
    return (
        I * I_A + R * R_A,
        I * (1.5 * Omega * t3 + t0 + t2) + R,
        R * (h_AA - t5) + t10 * t11 + t15 * (A * t12 * zeta_AA + 2.0 * I_0AA + 8.0 * Omega * zeta_A + 4.0 * Omega2 *
        d + 12.0 * Omega3 * t13 - t14 * t5),
        R * t4 + R_A + t11 * t9 + t14 * t15 * t4,
        I * (3.0 * Omega * t13 + d) + t10 * t18 + t16 * zeta_A - t17 * t5,
        t17 * t4 + t18 * t9 + 1.0,
    )


def turns_by_R(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and F_AOmega/(4 Omega); derivatives by A and by R of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0. Operations: 241. Error / u (1 + kappa): proved 1.01, -, -, -, -,
    -; measured 1.3.
    """
    t0 = R * R_A
    t1 = A * R_A
    t2 = 2.0 * I * d
    A2 = A * A
    t3 = I_A * d
    t4 = 1.0 / Omega
    t5 = I * t4
    t6 = t5 * zeta
    t7 = t5 * zeta_A
    t8 = t4 * zeta
    t9 = I_A * t8
    t10 = A2 * d_3
    t11 = I * Omega
    t12 = 4.5 * t11
    A3 = A * A2
    t13 = A3 * d_3
    t14 = I_A * Omega
    t15 = 1.5 * t14
    t16 = 1.0 / A
    Omega2 = Omega * Omega
    t17 = d_3 * t1
    Omega3 = Omega * Omega2
    t18 = t10 * t15
    t19 = t16 * t6
    t20 = A * t3
    t21 = A * d_3
    t22 = 4.0 * zeta_A
    t23 = A * zeta
    t24 = A2 * d
    t25 = Omega * d
    t26 = A2 * zeta
    t27 = 2.0 * zeta_AA
    t28 = A * t8
    t29 = I_A * t4
    t30 = 2.0 * zeta_A
    t31 = d_3 * t26
    t32 = 12.0 * t31
    t33 = t13 * zeta_A
    t34 = 3.0 * t33
    t35 = 0.5 / Omega3
    t36 = I * t35
    t37 = t36 * zeta_A
    t38 = I_A * t35 * zeta
    t39 = A2 * d * d
    t40 = 4.0 * t39
    t41 = 2.0 / Omega2
    t42 = t41 * zeta * zeta
    t43 = 2.25 * t5
    t44 = t41 * zeta_A
    t45 = 6.0 * d
    t46 = 15.0 * t13 * t25
    t47 = 6.0 * Omega2
    A4 = A2 * A2
    t48 = A4 * d_3 * d_3
    t49 = t16 * t36 * zeta
    t50 = 0.75 * t10 * t29
    t51 = t24 * t30 * t4
    t52 = 13.5 * Omega2 * t48
    Omega4 = Omega2 * Omega2
    return (
        I * I_A + t0,
        A * t2 + A * t7 + A * t9 + A2 * t3 + R + t1 + t10 * t12 + t13 * t15 + t6,
        2.0 * A * I * Omega * zeta_AA + 6.0 * A * I * Omega3 * d_3 + I * I_0AA + 4.0 * I * Omega * zeta_A + 2.0 * I
        * Omega2 * d + I_A * I_A + R * h_AA - R_A * t18 - R_A * t19 - R_A * t2 - R_A * t7 - R_A * t9 - t0 * t16 - t1
        * t3 - t12 * t17,
        R * t16 + R_A + t12 * t21 + t18 + t19 + t2 + t20 + t7 + t9,
        A * h_AA + A * t29 * t30 + A * t5 * zeta_AA + A3 * t25 * t27 + 3.0 * A4 * Omega2 * d_3 * zeta_AA + 1.5 *
        I_0AA * Omega * t13 + I_0AA * t24 + I_0AA * t28 + Omega * t22 * t24 + 2.0 * Omega2 * t39 + 9.0 * Omega3 * d
        * t13 + 9.0 * Omega4 * t48 - R_A * t32 - R_A * t34 + R_A * t37 + R_A * t38 - R_A * t40 - R_A * t42 - R_A *
        t46 + R_A * t49 - R_A * t50 - R_A * t51 - R_A * t52 - t1 * t44 * zeta - t1 * t45 * t8 + 9.0 * t10 * t14 +
        9.0 * t11 * t21 - t17 * t43 + t2 + 4.0 * t20 + t22 * t23 + 2.0 * t23 * t25 + t26 * t27 + t31 * t47 + t33 *
        t47 + 2.0 * t7 + 2.0 * t9,
        t21 * t43 + t23 * t44 + t28 * t45 + t32 + t34 - t37 - t38 + t40 + t42 + t46 - t49 + t50 + t51 + t52 + 2.0,
    )


def folds_by_Omega(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and F_A/2; derivatives by A and by Omega of the first, then of the second.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 59. Error / u (1 + kappa): proved -, 1.01, 1.01,
    7.26, 10.26, -; measured 0.5.
    """
    t0 = I * I_A + R * R_A
    t1 = 2.0 * Omega
    t2 = R * t1
    t3 = 2.0 * zeta
    t4 = A * t1
    Omega2 = Omega * Omega
    t5 = A * A * Omega2 * d_3
    t6 = d * t4 + t3 + 3.0 * t5
    t7 = 2.0 * A
    t8 = 4.0 * Omega
    Omega3 = Omega * Omega2
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        t0,
        2.0 * t0,
        t7 * (I * t6 + t2),
        I * (6.0 * A * Omega3 * d_3 + I_0AA + 2.0 * Omega2 * d + t4 * zeta_AA + t8 * zeta_A) + I_A * I_A + R * h_AA
        + R_A * R_A,
        A * I_A * t6 + I * (A * d * t8 + t3 + 9.0 * t5 + t7 * zeta_A) + R_A * t4 + t2,
    )


def peaks_by_Omega(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second.

    Equation from (24). Domain: Omega > 0, A > 0. Operations: 101. Error / u (1 + kappa): proved -, -, 1.01, 7.26,
    -, -; measured 0.68.
    """
    t0 = 1.0 / Omega
    t1 = I_0 * t0
    t2 = 3.0 * zeta
    t3 = A * Omega
    t4 = d * t3
    t5 = I_0 * d + t4 * (t2 + t4) + 2.0 * zeta * zeta
    t6 = 5.0 * d
    t7 = 3.0 * d_3
    t8 = t3 * (t3 * t7 + t6) + 8.0 * zeta
    t9 = 3.0 * I_0 + t3 * t8
    A2 = A * A
    t10 = 0.5 * A2
    t11 = d_3 * t10 * t9
    t12 = 2.0 * zeta
    t13 = 2.0 * t4
    t14 = Omega * Omega
    t15 = A2 * t7
    t16 = 2.0 * A
    A3 = A * A2
    t17 = d_3 * t14
    t18 = t13 + t2
    t19 = d_3 * t3
    t20 = t3 * (6.0 * t19 + t6) + t8
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        A * t5 + Omega * t11 + R + t1 * zeta,
        2.0 * (I * I_A + R * R_A),
        t16 * (I * (t12 + t13 + t14 * t15) + 2.0 * Omega * R),
        0.5 * I_0A * (Omega * t15 + d * t16 + t0 * t12) + R_A + t10 * t17 * t20 + t18 * t4 + t19 * t9 + t5 + zeta_A
        * (A * (3.0 * t4 + 4.0 * zeta) + 4.0 * A3 * t17 + t1),
        A2 * d * t18 + 0.5 * A3 * Omega * d_3 * t20 - I_0 * zeta / t14 + t11 + 2.0 * t3,
    )


def cusps_by_Omega(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and F_AA/2; derivatives by A and by Omega of the first, then of the second.

    Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 99. Error / u (1 + kappa): proved 1.01, 8.26,
    8.26, -, -, -; measured 1.2.
    """
    Omega2 = Omega * Omega
    t0 = 2.0 * d
    t1 = Omega2 * t0
    t2 = 4.0 * zeta_A
    t3 = Omega * t2
    t4 = 2.0 * A
    t5 = Omega * t4
    t6 = t5 * zeta_AA
    t7 = A * d_3
    Omega3 = Omega * Omega2
    t8 = 6.0 * Omega3
    t9 = t7 * t8
    t10 = I_A * I_A + R * h_AA + R_A * R_A
    t11 = I_0AA + t1 + t3 + t6 + t9
    t12 = 2.0 * zeta
    t13 = A * A * Omega2 * d_3
    t14 = A * (A * Omega * t0 + t12 + 3.0 * t13)
    t15 = 4.0 * Omega
    t16 = d * t15
    t17 = A * t16 + t12 + 9.0 * t13 + t4 * zeta_A
    t18 = I * zeta_AA
    return (
        I * I_A + R * R_A,
        I * I_0AA + I * t1 + I * t3 + I * t6 + I * t9 + t10,
        I * t11 + t10,
        I * t17 + I_A * t14 + 2.0 * Omega * R + R_A * t5,
        I * I_0AAA + I * d_3 * t8 + I * t5 * zeta_AAA + 3.0 * I_A * t11 + 6.0 * Omega * t18 + R * h_AAA + 3.0 * R_A
        * h_AA,
        18.0 * I * Omega2 * t7 + I * t16 + I * t2 + 2.0 * I_A * t17 + R_A * t15 + h_AA * t5 + t11 * t14 + t18 * t4,
    )


def isolas_by_Omega(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0. Operations: 125. Error / u (1 + kappa): proved 1.01, -, 10.26, -,
    -, -; measured 0.49.
    """
    t0 = 1.0 / Omega
    t1 = I_0 * t0
    t2 = 3.0 * zeta
    t3 = A * Omega
    t4 = d * t3
    t5 = I_0 * d + t4 * (t2 + t4) + 2.0 * zeta * zeta
    A2 = A * A
    t6 = A2 * Omega
    t7 = 5.0 * d
    t8 = 3.0 * d_3
    t9 = t3 * (t3 * t8 + t7) + 8.0 * zeta
    t10 = d_3 * (3.0 * I_0 + t3 * t9)
    t11 = 0.5 * t10
    t12 = 2.0 * t3
    Omega2 = Omega * Omega
    t13 = 2.0 * d
    t14 = 6.0 * d_3
    t15 = 2.0 * zeta
    t16 = 2.0 * t4
    t17 = A2 * Omega2
    t18 = d_3 * t17
    A3 = A * A2
    t19 = A3 * d_3
    t20 = t16 + t2
    t21 = 0.5 * t3 * (t14 * t3 + t7) + 0.5 * t9
    Omega3 = Omega * Omega2
    return (
        I * I_A + R * R_A,
        A * t5 + R + t1 * zeta + t11 * t6,
        I * (A * Omega3 * t14 + I_0AA + 4.0 * Omega * zeta_A + Omega2 * t13 + t12 * zeta_AA) + I_A * I_A + R * h_AA
        + R_A * R_A,
        A * I_A * (t15 + t16 + t17 * t8) + I * (2.0 * A * zeta_A + t15 + 9.0 * t18 + 4.0 * t4) + 2.0 * Omega * R +
        R_A * t12,
        0.5 * I_0A * (A * t13 + t0 * t15 + t6 * t8) + R_A + t10 * t3 + t18 * t21 + t20 * t4 + t5 + zeta_A * (A *
        (3.0 * t4 + 4.0 * zeta) + 4.0 * Omega2 * t19 + t1),
        A2 * d * t20 + A2 * t11 - I_0 * zeta / Omega2 + Omega * t19 * t21 + t12,
    )


def turns_by_Omega(Omega: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and F_AOmega/(4 Omega); derivatives by A and by Omega of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0. Operations: 203. Error / u (1 + kappa): proved 1.01, -, 10.26, -,
    -, -; measured 1.3.
    """
    t0 = A * R_A
    t1 = 2.0 * I
    t2 = d * t1
    A2 = A * A
    t3 = A2 * d
    t4 = I_A * t3
    t5 = 1.0 / Omega
    t6 = I * zeta
    t7 = A * t5
    t8 = I * zeta_A
    t9 = I_A * zeta
    t10 = I * d_3
    t11 = A2 * t10
    t12 = 4.5 * t11
    t13 = 1.5 * I_A
    A3 = A * A2
    t14 = A3 * Omega
    t15 = d_3 * t14
    t16 = 4.0 * Omega
    t17 = I * zeta_AA
    t18 = 2.0 * Omega
    t19 = A * t18
    Omega2 = Omega * Omega
    Omega3 = Omega * Omega2
    t20 = A * t10
    t21 = t1 * zeta_A
    t22 = 2.0 * t9
    t23 = A * t16
    t24 = A3 * d_3
    t25 = 3.0 * Omega2
    t26 = 4.0 * A
    t27 = zeta * zeta_A
    t28 = 9.0 * Omega
    t29 = 2.0 * A2
    t30 = A2 * d_3
    t31 = A3 * d
    t32 = 6.0 * Omega2
    A4 = A2 * A2
    t33 = A4 * d_3
    t34 = d * d
    t35 = d_3 * d_3
    t36 = 1.0 / Omega2
    t37 = A * t36
    Omega4 = Omega2 * Omega2
    A5 = A * A4
    return (
        I * I_A + R * R_A,
        A * t2 + Omega * t12 + R + t0 + t13 * t15 + t4 + t5 * t6 + t7 * t8 + t7 * t9,
        I * I_0AA + I_A * I_A + Omega2 * t2 + 6.0 * Omega3 * t20 + R * h_AA + R_A * R_A + t16 * t8 + t17 * t19,
        A * t21 + A * t22 + I * d * t23 + I_A * t24 * t25 + 9.0 * Omega2 * t11 + R * t18 + t0 * t18 + t18 * t4 + 2.0
        * t6,
        A * h_AA + 9.0 * A4 * Omega4 * t35 + 1.5 * I_0AA * t15 + I_0AA * t3 + I_0AA * t7 * zeta + I_A * d * t26 +
        I_A * t28 * t30 + 2.0 * I_A * t7 * zeta_A + Omega2 * t29 * t34 + 9.0 * Omega3 * d_3 * t31 + 2.0 * R_A + d *
        t19 * zeta + t16 * t3 * zeta_A + t17 * t7 + t18 * t31 * zeta_AA + t2 + t20 * t28 + t21 * t5 + t22 * t5 + t24
        * t32 * zeta_A + t25 * t33 * zeta_AA + t26 * t27 + t29 * zeta * zeta_AA + t30 * t32 * zeta,
        4.0 * A2 * t27 * t5 + 27.0 * A5 * Omega3 * t35 + 6.0 * Omega * t33 * zeta_A + 30.0 * Omega2 * d * t33 + t12
        + t13 * t24 + 8.0 * t14 * t34 + 24.0 * t15 * zeta + t23 + 12.0 * t3 * zeta + 4.0 * t31 * zeta_A - t36 * t6 -
        t37 * t8 - t37 * t9 + 4.0 * t7 * zeta * zeta,
    )


def folds_far_by_R(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 54. Error / u (1 + kappa): proved -, 1.01, 4.01,
    3.51, 24.51, 12.34; measured 0.7.
    """
    t0 = 1.0 / h
    t1 = t0 / x
    t2 = t1 * (A * zeta + I_0 * x)
    t3 = I_A - R_A * t2
    t4 = x * x
    t5 = h_A * t0
    t6 = t1 * (A * zeta_A + I_0A * x + zeta)
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        I * I_A + R * R_A,
        2.0 * I * t3,
        2.0 * (I * t2 + R),
        I * (2.0 * A * x * zeta_AA + I_0AA * t4 - R_A * t6 + 2.0 * d + 4.0 * x * zeta_A) + I_A * t3 + R * (-R_A * t5
        + h_AA * t4),
        I * t6 + I_A * t2 + R * t5 + R_A,
    )


def peaks_far_by_R(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.

    Equation from (24). Domain: Omega > 0, A > 0. Operations: 56. Error / u (1 + kappa): proved -, 3.26, 4.51, 4.01,
    -, -; measured 0.97.
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
        t0 * (A * t7 * zeta_A + I * I_0A + R_A * t8 * t9 - h_A * t10 * t8 + t10 * t6 + t7 * zeta),
        -I * t11 * t9 + t1 * t10 * t11 * t4 + 1.0,
    )


def cusps_far_by_R(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.

    Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 99. Error / u (1 + kappa): proved 1.01, 8.01,
    21.51, 12.34, -, -; measured 0.63.
    """
    t0 = 2.0 * d
    t1 = 4.0 * x * zeta_A
    t2 = x * x
    t3 = I_0AA * t2
    t4 = h_AA * t2
    t5 = 2.0 * I
    t6 = A * zeta_AA
    t7 = t6 * x
    t8 = 1.0 / h
    t9 = h_A * t8
    t10 = R_A * t9
    t11 = h_AA * t2 - t10
    t12 = A * zeta + I_0 * x
    t13 = t8 / x
    t14 = R_A * t13
    t15 = I_A - t12 * t14
    t16 = A * zeta_A + I_0A * x + zeta
    t17 = t0 + t1 + t3 + 2.0 * t7
    t18 = -t14 * t16 + t17
    t19 = t12 * t13
    t20 = t13 * t16
    t21 = I * x
    t22 = t13 * (I * t6 + I_0AA * t21 + R * h_AA * x + t5 * zeta_A)
    t23 = 2.0 * I_A
    return (
        I * I_A + R * R_A,
        I * t0 + I * t1 + I * t3 + I_A * I_A + R * t4 + R_A * R_A + t5 * t7,
        I * t18 + I_A * t15 + R * t11,
        I * t20 + I_A * t19 + R * t9 + R_A,
        A * t5 * x * zeta_AAA + I * I_0AAA * t2 + R * h_AAA * t2 + 2.0 * R_A * t11 - R_A * t22 + t15 * t17 + t18 *
        t23 + 6.0 * t21 * zeta_AA,
        2.0 * t10 + t17 * t19 + t20 * t23 + t22 + t4,
    )


def isolas_far_by_R(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0. Operations: 80. Error / u (1 + kappa): proved 1.01, 3.26, 25.84,
    13.67, -, -; measured 0.46.
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
    t9 = A * zeta_A
    t10 = t0 * (I_0A * x + t9 + zeta)
    t11 = I * t1
    x3 = x * x2
    t12 = 0.5 * I * t2 / x3
    t13 = I_0 + t3
    t14 = 1.0 / (h * h)
    return (
        I * I_A + R * R_A,
        I * (I_0 * t0 + t0 * t3) + R,
        I * (2.0 * A * x * zeta_AA + I_0AA * x2 + 2.0 * d - t10 * t5 + 4.0 * x * zeta_A) + I_A * t8 + R * (-R_A * t4
        + h_AA * x2),
        I_A * t1 * t7 + R * t4 + R_A + t10 * t11,
        t0 * (I * I_0A - I * t13 * t4 + R_A * t0 * t12 + t11 * t9 + t11 * zeta + t13 * t8),
        t1 * t13 * t14 * t6 - t12 * t14 + 1.0,
    )


def folds_far_by_x(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 49. Error / u (1 + kappa): proved -, 1.01, 1.01,
    2.01, 8.01, 8.34; measured 0.5.
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
        I * (2.0 * A * x * zeta_AA + I_0AA * t3 + 2.0 * d + 4.0 * x * zeta_A) + I_A * I_A + R * h_AA * t3 + R_A *
        R_A,
        2.0 * (I * (A * zeta_A + I_0A * x + zeta) + I_A * t2 + R_A * h * x + h_A * t1),
    )


def peaks_far_by_x(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.

    Equation from (24). Domain: Omega > 0, A > 0. Operations: 59. Error / u (1 + kappa): proved -, 7.01, 1.01, 2.01,
    -, 8.51; measured 0.55.
    """
    t0 = R * h
    t1 = A * zeta
    t2 = 2.0 * t1
    t3 = I_0 * x
    t4 = A * A
    t5 = d / x
    t6 = t3 + t4 * t5
    t7 = t2 + t6
    t8 = t1 + t3
    return (
        R * R + (-F_0 + I) * (F_0 + I),
        I * I_0 + t0 + t1 * t7,
        2.0 * (I * I_A + R * R_A),
        4.0 * (I * t8 + t0 * x),
        A * zeta_A * (4.0 * t1 + t6) + I_0 * I_A + I_0A * (I + t1 * x) + R * h_A + R_A * h + t2 * (A * t5 + zeta) +
        t7 * zeta,
        2.0 * I_0 * t8 + 2.0 * h * h * x + t1 * (I_0 - d * t4 / (x * x)),
    )


def cusps_far_by_x(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.

    Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 87. Error / u (1 + kappa): proved 1.01, 6.01,
    6.01, 8.34, 13.41, -; measured 0.58.
    """
    t0 = 2.0 * d
    x2 = x * x
    t1 = I_0AA * x2
    t2 = 4.0 * x * zeta_A
    t3 = 2.0 * I
    t4 = A * zeta_AA
    t5 = t4 * x
    t6 = R * x2
    t7 = I_A * I_A + R_A * R_A + h_AA * t6
    t8 = t0 + t1 + t2 + 2.0 * t5
    t9 = R * x
    t10 = R_A * x
    t11 = A * zeta + I_0 * x
    t12 = A * zeta_A + I_0A * x + zeta
    t13 = I * x
    x3 = x * x2
    return (
        I * I_A + R * R_A,
        I * t0 + I * t1 + I * t2 + t3 * t5 + t7,
        I * t8 + t7,
        2.0 * (I * t12 + I_A * t11 + h * t10 + h_A * t9),
        A * t3 * x * zeta_AAA + I * I_0AAA * x2 + 3.0 * I_A * t8 + 3.0 * R_A * h_AA * x2 + h_AAA * t6 + 6.0 * t13 *
        zeta_AA,
        2.0 * (I * t4 + I_0AA * t13 + 2.0 * I_A * t12 + h * h_AA * x3 + 2.0 * h_A * t10 + h_AA * t9 + t11 * t8 + t3
        * zeta_A),
    )


def isolas_far_by_x(x: Any, A: Any, F_0: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, R: Any, I: Any, R_A: Any, I_A: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0. Operations: 77. Error / u (1 + kappa): proved 1.01, 7.01, 8.01,
    8.34, -, 8.51; measured 0.71.
    """
    t0 = A * zeta
    t1 = 2.0 * t0
    t2 = I_0 * x
    t3 = A * A
    t4 = d / x
    t5 = t2 + t3 * t4
    t6 = t1 + t5
    t7 = x * x
    t8 = 2.0 * x
    t9 = R * h_A
    t10 = R_A * h
    t11 = t0 + t2
    t12 = A * zeta_A
    return (
        I * I_A + R * R_A,
        I * I_0 + R * h + t0 * t6,
        I * (A * t8 * zeta_AA + I_0AA * t7 + 2.0 * d + 4.0 * x * zeta_A) + I_A * I_A + R * h_AA * t7 + R_A * R_A,
        2.0 * (I * (I_0A * x + t12 + zeta) + I_A * t11 + t10 * x + t9 * x),
        I_0 * I_A + I_0A * (I + t0 * x) + t1 * (A * t4 + zeta) + t10 + t12 * (4.0 * t0 + t5) + t6 * zeta + t9,
        2.0 * I_0 * t11 + h * h * t8 + t0 * (I_0 - d * t3 / t7),
    )

