"""Slow flow of any mechanism, in h = H - A and its derivatives.

Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

Rounding errors were measured with A, F_0 1e-09 to 1000; Omega 0.001 to 1000; R, T, h_A, k_A 1e-09 to 1e+06 of
either sign or 0; X 1e-06 to 1e+06; h 1e-12 to 1000 of either sign or 0; h_AA 1e-09 to 1e+09 of either sign or 0;
h_AAA 1e-09 to 1e+12 of either sign or 0; k, root 1e-09 to 1000 of either sign; lacks 1e-09 to 1000 of either sign
or 0; m, mu, preload, reduction, zeta 1e-12 to 1 or 0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.support.backend import NATIVE, compiled, from_c
from slowflow.support.broadcast import broadcast_outputs, common_shape, floats, full, number_by_regime, stacked

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from slowflow.support.broadcast import Floats

__all__ = [
    "F_A", "F_AA", "F", "F_AOmega", "F_Omega", "F_OmegaOmega", "I", "Omega_A", "R", "backbone", "cusp", "cusp_R",
    "cusp_balance", "cusp_bend", "cusps", "detachment", "detachment_mu0", "detachment_mu0_zeta0",
    "detachment_zeta0", "equivalent_damping", "fold", "fold_moves", "fold_mu0", "fold_quartic", "fold_square",
    "fold_zeta0", "friction", "held", "intercept", "isola", "isola_Omega", "isola_bend", "isola_hessian",
    "isola_level", "isola_mu0", "isolation", "jacobian", "least_restoring", "level", "level_rise", "limit_envelope",
    "mean_stiffness", "most_restoring", "offset_stiffness", "peak", "peak_Omega_A", "peak_cubic", "phase",
    "response_quartic", "response_quartic_mu0", "rest", "stability", "tail", "transmissibility", "turn", "undamped",
    "undamped_Omega", "undamped_level", "undamped_rises",
]


def friction(mu: ArrayLike) -> Any:
    """Dry friction's share of I.

    Equation (23). Domain: mu >= 0. Operations: 1. Error / u (1 + kappa): measured 0.76.
    """
    (mu,) = floats(mu)
    return 1.2732395447351628 * mu


def R(Omega: ArrayLike, A: ArrayLike, h: ArrayLike) -> Any:
    """Cosine balance, -F_0 cos phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0. Operations: 3. Error / u (1 + kappa): proved 1.01.
    """
    Omega, A, h = floats(Omega, A, h)
    return A * Omega * Omega + h


def I(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike) -> Any:  # noqa: E743
    """Sine balance, -F_0 sin phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0. Operations: 4. Error / u (1 + kappa): proved 0.76.
    """
    Omega, A, m, zeta = floats(Omega, A, m, zeta)
    return 2.0 * A * Omega * zeta + m


def F(Omega: ArrayLike, A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Any:
    """Frequency response; zero at a steady state.

    Equation (24). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): measured 1.4.
    """
    Omega, A, F_0, m, zeta, h = floats(Omega, A, F_0, m, zeta, h)
    R = A * Omega * Omega + h
    I = 2.0 * A * Omega * zeta + m
    return R * R + (-F_0 + I) * (F_0 + I)


def F_A(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike) -> Any:
    """dF/dA; positive where stable.

    Equation (24), (30). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): measured 1.1.
    """
    Omega, A, m, zeta, h, h_A = floats(Omega, A, m, zeta, h, h_A)
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = 2.0 * Omega * zeta
    I = A * t1 + m
    return 2.0 * (I * t1 + R * (h_A + t0))


def F_AA(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike, h_AA: ArrayLike) -> Any:
    """d2F/dA2.

    Equation (24), (33). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): measured 1.3.
    """
    Omega, A, m, zeta, h, h_A, h_AA = floats(Omega, A, m, zeta, h, h_A, h_AA)
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = h_A + t0
    return full(2.0 * (R * h_AA + 4.0 * t0 * zeta * zeta + t1 * t1), common_shape((Omega, A, m, zeta, h, h_A, h_AA)))


def F_Omega(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Any:
    """dF/dOmega.

    Equation (24), (34). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): proved 3.67.
    """
    Omega, A, m, zeta, h = floats(Omega, A, m, zeta, h)
    R = A * Omega * Omega + h
    I = 2.0 * A * Omega * zeta + m
    return 4.0 * A * (I * zeta + Omega * R)


def F_AOmega(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike) -> Any:
    """d2F/dA dOmega.

    Equation (24). Domain: Omega > 0, A > 0. Operations: 17. Error / u (1 + kappa): proved 4.72.
    """
    Omega, A, m, zeta, h, h_A = floats(Omega, A, m, zeta, h, h_A)
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = A * Omega
    t2 = 2.0 * t1
    I = m + t2 * zeta
    return 4.0 * (I * zeta + Omega * R + t1 * (h_A + t0) + t2 * zeta * zeta)


def F_OmegaOmega(Omega: ArrayLike, A: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Any:
    """d2F/dOmega2.

    Equation (24). Domain: Omega > 0, A > 0. Operations: 11. Error / u (1 + kappa): proved 2.67.
    """
    Omega, A, zeta, h = floats(Omega, A, zeta, h)
    t0 = A * Omega * Omega
    R = h + t0
    return 4.0 * A * (2.0 * A * zeta * zeta + R + 2.0 * t0)


def phase(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Any:
    """Phase phi of a steady state, from -pi to 0.

    Equation (25). Domain: Omega > 0, A > 0. Operations: 8. Error / u (1 + kappa): measured 0.88.
    """
    Omega, A, m, zeta, h = floats(Omega, A, m, zeta, h)
    R = A * Omega * Omega + h
    I = 2.0 * A * Omega * zeta + m
    return np.arctan2(-I, -R)


def backbone(A: ArrayLike, h: ArrayLike) -> Any:
    """Frequency on the backbone.

    Equation (26). Domain: A > 0, h <= 0. Operations: 2. Error / u (1 + kappa): measured 0.71.
    """
    A, h = floats(A, h)
    turn = -h / A
    return np.sqrt(turn)


def limit_envelope(Omega: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike) -> Any:
    """Largest amplitude that the forcing can hold at this frequency.

    Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. Operations: 4. Error / u (1 + kappa): proved 4.01.
    """
    Omega, F_0, m, zeta = floats(Omega, F_0, m, zeta)
    return 0.5 * (F_0 - m) / (Omega * zeta)


def equivalent_damping(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike) -> Any:
    """Viscous damping ratio that dissipates as much as zeta and friction together.

    Equation (38). Domain: Omega > 0, A > 0. Operations: 4. Error / u (1 + kappa): proved 0.76.
    """
    Omega, A, m, zeta = floats(Omega, A, m, zeta)
    return zeta + 0.5 * m / (A * Omega)


def transmissibility(Omega: ArrayLike, A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Any:
    """Fundamental harmonic of the force on the base over F_0, at a steady state.

    Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0. Operations: 6. Error / u (1 + kappa): measured 0.67.
    """
    Omega, A, F_0, m, zeta, h = floats(Omega, A, F_0, m, zeta, h)
    I = 2.0 * A * Omega * zeta + m
    return np.hypot(h, I) / F_0


def _isolation_inwards(A, F_0, reduction, h):
    removed = F_0 * np.sqrt(reduction)
    whole = np.hypot(h, removed)
    turn = (-h + whole) / A
    return np.sqrt(turn)


def _isolation_outwards(A, F_0, reduction, h):
    removed = F_0 * np.sqrt(reduction)
    whole = np.hypot(h, removed)
    turn = removed * removed / (A * (h + whole))
    return np.sqrt(turn)


def isolation(A: ArrayLike, F_0: ArrayLike, reduction: ArrayLike, h: ArrayLike) -> Any:
    """Frequency of a state that transmits sqrt(1 - reduction) of what drives it, though it moves.

    Equation from (23). Domain: A > 0, F_0 > 0, 0 <= reduction < 1. Operations: 6 in inwards, 8 in outwards. Error /
    u (1 + kappa): measured 0.83.
    """
    A, F_0, reduction, h = arguments = floats(A, F_0, reduction, h)
    bodies = (_isolation_inwards, _isolation_outwards)
    return number_by_regime((h <= 0.0,), bodies, arguments)


def held(m: Any, preload: Any) -> Any:
    """The forcing up to which a mass at rest stays there: that of a state as A tends to 0.

    Equation (24). Domain: preload >= 0, -h as A tends to 0. Operations: 1. Error / u (1 + kappa): measured 0.5.
    """
    m, preload = floats(m, preload)
    return np.hypot(m, preload)


def jacobian(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.

    Equation (28). Domain: Omega > 0, A > 0. Operations: 13. Error / u (1 + kappa): proved 0.0, 2.01, 3.01, 3.01.
    """
    Omega, A, m, zeta, h, h_A = floats(Omega, A, m, zeta, h, h_A)
    t0 = Omega * Omega
    t1 = 0.5 / Omega
    t2 = t1 / A
    return broadcast_outputs((Omega, A, m, zeta, h, h_A),
        -zeta,
        t1 * (A * t0 + h),
        t2 * (-h_A - t0),
        t2 * (-2.0 * A * Omega * zeta - m),
    )


def stability(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike) -> Any:
    """4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.

    Equation (30). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): measured 1.1.
    """
    Omega, A, m, zeta, h, h_A = floats(Omega, A, m, zeta, h, h_A)
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = 2.0 * Omega * zeta
    I = A * t1 + m
    return (I * t1 + R * (h_A + t0)) / A


def response_quartic(A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.

    Equation (24). Domain: A > 0. Operations: 15. Error / u (1 + kappa): proved -, 0.51, 1.61, 0.34; measured 0.98.
    """
    A, F_0, m, zeta, h = floats(A, F_0, m, zeta, h)
    t0 = A * A
    return broadcast_outputs((A, F_0, m, zeta, h),
        h * h + (-F_0 + m) * (F_0 + m),
        4.0 * A * m * zeta,
        2.0 * A * h + 4.0 * t0 * zeta * zeta,
        t0,
    )


def fold_quartic(A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.

    Equation (24), (30). Domain: A > 0. Operations: 8. Error / u (1 + kappa): proved 0.34, 0.34, 2.34, 0.0.
    """
    A, m, zeta, h, h_A = floats(A, m, zeta, h, h_A)
    return broadcast_outputs((A, m, zeta, h, h_A), h * h_A, 2.0 * m * zeta, A * (h_A + 4.0 * zeta * zeta) + h, A)


def peak_cubic(A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> tuple[Any, Any, Any]:
    """F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3.

    Equation (34). Domain: A > 0. Operations: 5. Error / u (1 + kappa): proved 0.34, 1.01, 0.0.
    """
    A, m, zeta, h = floats(A, m, zeta, h)
    return broadcast_outputs((A, m, zeta, h), m * zeta, 2.0 * A * zeta * zeta + h, A)


def detachment(A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Floats:
    """Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.

    Equation (34). Domain: A > 0. Operations: 37. Error / u (1 + kappa): proved -, -, 6.67, 0.0; measured 1.3. One
    array, coefficients by rising power along its first axis.
    """
    A, m, zeta, h = floats(A, m, zeta, h)
    m2 = m * m
    zeta2 = zeta * zeta
    t0 = A * zeta2
    t1 = h + t0
    t2 = h * t0
    t3 = h * h
    zeta4 = zeta2 * zeta2
    t4 = A * A * zeta4
    t5 = -t3
    t6 = m2 + 4.0 * t2
    m4 = m2 * m2
    return stacked((A, m, zeta, h),
        -t6 * t6 * (m2 + t1 * t1),
        2.0 * m2 * (t2 + t3 + 10.0 * t4) + 3.0 * m4 - 8.0 * t0 * t1 * (-2.0 * t2 - 2.0 * t4 - t5),
        -3.0 * m2 + 8.0 * t2 + 8.0 * t4 + t5,
        1.0,
    )


def level(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Any:
    """The forcing F_0 for which (Omega, A) is a steady state.

    Equation (24). Domain: Omega >= 0, A > 0. Operations: 11. Error / u (1 + kappa): measured 1.4.
    """
    Omega, A, m, zeta, h = floats(Omega, A, m, zeta, h)
    R = A * Omega * Omega + h
    I = 2.0 * A * Omega * zeta + m
    return np.sqrt(I * I + R * R)


def intercept(A: ArrayLike, h: ArrayLike, h_A: ArrayLike, h_AA: ArrayLike) -> tuple[Any, Any]:
    """k = h - A h_A, where the tangent of h meets A = 0, and its slope along A.

    Equation from (24), (30). Domain: A >= 0. Operations: 3. Error / u (1 + kappa): proved 1.01, 0.34.
    """
    A, h, h_A, h_AA = floats(A, h, h_A, h_AA)
    return broadcast_outputs((A, h, h_A, h_AA), -A * h_A + h, -A * h_AA)


def fold(A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike, k: ArrayLike, k_A: ArrayLike) -> tuple[Any, Any, Any]:
    """Zero at a fold at F_0: R of (23) less the R of F = F_A = 0; its slope along A, and Omega.

    Equation from (24), (30). Domain: A > 0, F_0 > m, k^2 >= F_0^2 - m^2. Operations: 48. Error / u (1 + kappa):
    measured 1.9.
    """
    A, F_0, m, zeta, h, h_A, k, k_A = floats(A, F_0, m, zeta, h, h_A, k, k_A)
    excess = (F_0 - m) * (F_0 + m)
    least = np.sqrt(excess)
    t0 = 1.0 / k
    t1 = least * t0
    share = np.sqrt((1.0 - t1) * (t1 + 1.0))
    J = excess / (F_0 + m * share)
    t2 = 1.0 / share
    lag = excess / (F_0 * t2 + m)
    t3 = J * t0
    t4 = 1.0 / (zeta * zeta)
    t5 = 1.0 / A
    t6 = t4 * t5
    t7 = 0.25 * lag * lag
    return broadcast_outputs((A, F_0, m, zeta, h, h_A, k, k_A),
        -F_0 * t3 + h + t6 * t7,
        F_0 * J * J * k_A * (0.5 * t3 * t6 + (F_0 + m * t2) / excess) / (k * k) + h_A - t4 * t7 / (A * A),
        0.5 * lag * t5 / zeta,
    )


def cusps(A: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike, h_AA: ArrayLike, k: ArrayLike) -> tuple[Any, Any, Any, Any, Any]:
    """F_AA/2 = T^2 + 2 a T + b = X^2 + 2 c X + d, T = dR/dA, X = Omega^2: a, b, c, d, and a^2 - b = c^2 - d.

    Equation from (33). Domain: A > 0. Operations: 15. Error / u (1 + kappa): proved 1.01, 1.01, 1.51, 1.01, -;
    measured 0.89.
    """
    A, zeta, h, h_A, h_AA, k = floats(A, zeta, h, h_A, h_AA, k)
    t0 = zeta * zeta
    half_e = 0.5 * A * h_AA + 2.0 * t0
    t1 = 4.0 * h_A * t0 - h_AA * k
    return broadcast_outputs((A, zeta, h, h_A, h_AA, k),
        half_e, -t1,
        h_A + half_e,
        h * h_AA + h_A * h_A,
        half_e * half_e + t1,
    )


def cusp(A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h_AA: ArrayLike, h_AAA: ArrayLike, k: ArrayLike, X: ArrayLike, T: ArrayLike, R: ArrayLike, root: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """Where F_AA = 0 (`cusps`; root = a + T): F_A/2, the same less A F_AA/2, its slope along A, F_0 if it is 0.

    Equation from (33). Domain: A > 0, X > 0. Operations: 37. Error / u (1 + kappa): measured 1.2.
    """
    A, m, zeta, h_AA, h_AAA, k, X, T, R, root = floats(A, m, zeta, h_AA, h_AAA, k, X, T, R, root)
    w = np.sqrt(X)
    t0 = m * zeta
    t1 = 2.0 * t0 * w
    t2 = 4.0 * A * zeta * zeta
    return broadcast_outputs((A, m, zeta, h_AA, h_AAA, k, X, T, R, root),
        R * T + X * t2 + t1,
        -A * h_AA * k + T * (-A * A * h_AA + k) + t1,
        0.5 * (R * h_AAA + 3.0 * T * h_AA) * (-A * T - R - t0 / w - t2) / root,
        np.sqrt(A * t1 + R * k + m * m),
    )


def mean_stiffness(A: ArrayLike, h: ArrayLike, h_A: ArrayLike) -> Any:
    """Mean of the stiffness over a cycle of a motion about u = 0, which stays about it where this is positive.

    Equation beside (30). Domain: A > 0. Operations: 4. Error / u (1 + kappa): proved 1.01.
    """
    A, h, h_A = floats(A, h, h_A)
    return -0.5 * h_A - 0.5 * h / A


def _offset_stiffness_over(Omega, A, h, h_A):
    t0 = Omega * Omega
    t1 = 1.0 / A
    t2 = h * t1
    t3 = 4.0 * t0
    return (h_A * (0.5 * h_A - 3.0 * t2 - t3) + t2 * (0.5 * h * t1 - t3)) / (h_A + 8.0 * t0 + t2)


def _offset_stiffness_apart(Omega, A, h, h_A):
    t0 = 1.0 / A
    t1 = h * t0
    t2 = h * t0 - h_A
    return -0.5 * h_A - 0.5 * t1 + t2 * t2 / (8.0 * Omega * Omega + h_A + t1)


def offset_stiffness(Omega: ArrayLike, A: ArrayLike, h: ArrayLike, h_A: ArrayLike) -> Any:
    """What carries a small mean offset back; where the mean stiffness is negative this decides.

    Equation beside (30). Domain: Omega > 0, A > 0. Operations: 18 in over, 14 in apart. Error / u (1 + kappa):
    measured 2.
    """
    Omega, A, h, h_A = arguments = floats(Omega, A, h, h_A)
    bodies = (_offset_stiffness_over, _offset_stiffness_apart)
    return number_by_regime((0.5 * np.abs(h_A) + 0.5 * np.abs(h) / A <= np.abs(8.0 * Omega * Omega + h_A + h / A),), bodies, arguments)


def response_quartic_mu0(A: ArrayLike, F_0: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.

    Equation (24). Domain: m = 0, A > 0. Operations: 10. Error / u (1 + kappa): proved -, 0.0, 1.61, 0.34; measured
    0.92.
    """
    A, F_0, zeta, h = floats(A, F_0, zeta, h)
    t0 = A * A
    return broadcast_outputs((A, F_0, zeta, h),
        (-F_0 + h) * (F_0 + h),
        0.0,
        2.0 * A * h + 4.0 * t0 * zeta * zeta,
        t0,
    )


def detachment_mu0(A: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Floats:
    """Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.

    Equation (34). Domain: m = 0, A > 0. Operations: 14. Error / u (1 + kappa): proved 4.01, 5.67, 0.0. One array,
    coefficients by rising power along its first axis.
    """
    A, zeta, h = floats(A, zeta, h)
    t0 = h * h
    zeta2 = zeta * zeta
    t1 = A * zeta2
    t2 = 4.0 * t1
    zeta4 = zeta2 * zeta2
    return stacked((A, zeta, h), -t0 * t2 * (h + t1), 4.0 * A * A * zeta4 + h * t2 - t0, 1.0)


def detachment_zeta0(m: ArrayLike, h: ArrayLike) -> Floats:
    """Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.

    Equation (34). Domain: zeta = 0, A > 0. Operations: 6. Error / u (1 + kappa): proved 0.81, 0.67, 0.0. One array,
    coefficients by rising power along its first axis.
    """
    m, h = floats(m, h)
    t0 = m * m
    t1 = h * h
    return stacked((m, h), t0 * (t0 + t1), -2.0 * t0 - t1, 1.0)


def detachment_mu0_zeta0(h: ArrayLike) -> Floats:
    """Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.

    Equation (34). Domain: m = 0, zeta = 0, A > 0. Operations: 1. Error / u (1 + kappa): proved 0.34, 0.0. One
    array, coefficients by rising power along its first axis.
    """
    (h,) = floats(h)
    return stacked((h,), -h * h, 1.0)


if NATIVE is not None:
    globals().update(compiled(globals(), NATIVE.slow_flow()))
#: functions that no Python code calls, which are in C, with their arguments; see generated/c/slow_flow.h
FROM_C = {
    "rest": "F_0 m h h_A",
    "least_restoring": "F_0 m",
    "most_restoring": "A F_0 m zeta",
    "fold_square": "Omega A lacks",
    "fold_moves": "A k R",
    "isola_Omega": "h_A",
    "isola_level": "Omega A m zeta",
    "isola": "A m zeta h h_A h_AA",
    "cusp_R": "A zeta h_AA k X T",
    "cusp_balance": "A m zeta h k X T",
    "turn": "Omega A m zeta h_AA k",
    "peak": "Omega A F_0 m zeta h_A",
    "peak_Omega_A": "Omega A m zeta h_A",
    "Omega_A": "Omega A m zeta h h_A",
    "level_rise": "Omega A m zeta h h_A h_AA",
    "cusp_bend": "Omega A zeta h_AA h_AAA T",
    "isola_bend": "Omega A m zeta h_AA",
    "isola_hessian": "Omega A m zeta h_AA",
    "tail": "Omega F_0 m",
    "isola_mu0": "A zeta h h_A h_AA",
    "fold_mu0": "A F_0 zeta h h_A k k_A",
    "fold_zeta0": "F_0 m k k_A",
    "undamped_Omega": "h_A",
    "undamped_level": "m k",
    "undamped_rises": "h_AA h_AAA k",
    "undamped": "A h h_A h_AA h_AAA",
}
globals().update(from_c("slow_flow", FROM_C))
