"""Structural and quadratic damping, and dry friction of what is attached.

Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
derivations/extensions/dissipation.py; never edit.

Rounding errors were measured with A, F_0 1e-09 to 1000; I, c_2, c_3, d, d_3, zeta_2 1e-12 to 1000 or 0; I_0, eta,
m, zeta 1e-12 to 1 or 0; I_0A, I_A, R, R_A, h_A 1e-09 to 1e+06 of either sign or 0; I_0AA, h_AA 1e-09 to 1e+09 of
either sign or 0; I_0AAA, h_AAA 1e-09 to 1e+12 of either sign or 0; Omega, x 0.001 to 1000; h 1e-12 to 1000 of
either sign or 0; steepest, zeta_A, zeta_AA, zeta_AAA 1e-09 to 1e+06 or 0; u_cr 1e-06 to 1.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.support.backend import from_c

__all__ = [
    "F_A", "F_AA", "I_A", "F", "F_AOmegaOmega", "F_A_halved", "F_Omega", "F_OmegaOmega", "I", "Omega_A",
    "Omega_A_by_inertia", "R_of_peak", "R_of_response", "R_where_stationary", "at_rest", "cubic", "cusp_bend",
    "cusp_bend_by_inertia", "cusps_by_Omega", "cusps_by_R", "cusps_far_by_R", "cusps_far_by_x", "far",
    "far_by_inertia", "fold_polynomial", "folds_by_Omega", "folds_by_R", "folds_far_by_R", "folds_far_by_x",
    "full_by_inertia", "isola_bend", "isola_bend_by_inertia", "isolas_by_Omega", "isolas_by_R", "isolas_far_by_R",
    "isolas_far_by_x", "limit_envelope", "peaks_by_Omega", "peaks_by_R", "peaks_far_by_R", "peaks_far_by_x",
    "quadratic", "quadratic_bound", "released", "released_moves", "response_polynomial", "rest_moves", "restoring",
    "stability", "static", "structural_bound", "turn_share", "turns_by_Omega", "turns_by_R", "viscous",
    "viscous_moves",
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


def viscous(A: Any, zeta: Any, zeta_2: Any) -> tuple[Any, Any, Any, Any]:
    """The viscous damping ratio of a cycle, and three derivatives by A.

    Equation from (19). Domain: A > 0. Operations: 6. Error / u (1 + kappa): proved 1.01, 0.34, 0.0, 0.0.
    """
    t0 = 0.5 * zeta_2
    return 0.25 * A * A * zeta_2 + zeta, A * t0, t0, 0.0


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

    Equation (24). Domain: Omega > 0, A > 0. Operations: 48. Error / u (1 + kappa): measured 1.
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

    Equation (24). Domain: Omega > 0, A > 0. Operations: 28. Error / u (1 + kappa): measured 0.84.
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


def limit_envelope(Omega: Any, F_0: Any, m: Any, zeta: Any, eta: Any, d: Any) -> Any:
    """Largest amplitude that the forcing can hold at this frequency, where friction acts throughout.

    Equation (27). Domain: Omega > 0, F_0 > m, one of zeta, eta, d > 0. Operations: 16. Error / u (1 + kappa):
    measured 0.89.
    """
    t0 = 2.0 * Omega * zeta + eta
    return (2.0 * F_0 - 2.0 * m) / (t0 + np.sqrt(-4.0 * Omega * Omega * d * (-F_0 + m) + t0 * t0))


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


def full_by_inertia(F_0: Any, d: Any) -> Any:
    """The amplitude that the response tends to as Omega grows.

    Equation from (24). Domain: F_0 > 0. Operations: 10. Error / u (1 + kappa): measured 1.4.
    """
    return 1.4142135623730951 * F_0 / np.sqrt(np.sqrt(4.0 * F_0 * F_0 * d * d + 1.0) + 1.0)

#: functions that no Python code calls, which are in C, with their arguments; see generated/c/dissipation.h
FROM_C = {
    "restoring": "A F_0 d",
    "released_moves": "A m u_cr",
    "viscous_moves": "A",
    "far": "x A I_0 I_0A zeta zeta_A d h h_A",
    "F_OmegaOmega": "Omega A I_0 zeta d d_3 h",
    "F_AOmegaOmega": "Omega A I_0 I_0A zeta zeta_A d d_3 h h_A",
    "Omega_A": "Omega A I_0 I_0A zeta zeta_A d d_3 h h_A",
    "Omega_A_by_inertia": "Omega A I_0 I_0A zeta zeta_A d d_3 h h_A",
    "cusp_bend": "Omega A I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA",
    "isola_bend": "Omega A I_0 I_0A I_0AA zeta zeta_A zeta_AA d d_3 h h_A h_AA",
    "static": "F_0 I_0 I_0A h h_A",
    "response_polynomial": "A I_0 zeta d d_3 h",
    "fold_polynomial": "A I_0 I_0A zeta zeta_A d d_3 h h_A",
    "turn_share": "x A I_0 I_0A zeta zeta_A d",
    "F_A_halved": "R R_A I I_A",
    "R_of_response": "F_0 I",
    "R_of_peak": "Omega A zeta d d_3 I",
    "R_where_stationary": "x A I_0 zeta d",
    "cusp_bend_by_inertia": "Omega A I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA",
    "isola_bend_by_inertia": "Omega A I_0 I_0A I_0AA zeta zeta_A zeta_AA d d_3 h h_A h_AA",
    "structural_bound": "A F_0 eta h steepest",
    "quadratic_bound": "F_0 d",
    "folds_by_R": "Omega A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "peaks_by_R": "Omega A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "cusps_by_R": "Omega A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "isolas_by_R": "Omega A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "turns_by_R": "Omega A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "folds_by_Omega": "Omega A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "peaks_by_Omega": "Omega A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "cusps_by_Omega": "Omega A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "isolas_by_Omega": "Omega A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "turns_by_Omega": "Omega A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "folds_far_by_R": "x A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "peaks_far_by_R": "x A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "cusps_far_by_R": "x A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "isolas_far_by_R": "x A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "folds_far_by_x": "x A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "peaks_far_by_x": "x A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "cusps_far_by_x": "x A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
    "isolas_far_by_x": "x A F_0 I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA R I R_A I_A",
}
globals().update(from_c("dissipation", FROM_C))
