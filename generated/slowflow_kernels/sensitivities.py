"""How answers move with the parameters: what the implicit function theorem asks for.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/paper/averaging.py, derivations/paper/slow_flow.py, derivations/extensions/dissipation.py, derivations/extensions/inertia.py, derivations/systems/gradients.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless, for any kind of number that has arithmetic: floats, complex numbers, arrays, an integrator's
symbols. Each docstring gives equation number, domain and floating-point operations.
Rounding errors are in u (1 + kappa), u = 2^-53: proved ones hold wherever nothing overflows or underflows, measured
ones are the worst of all outputs that was found, by a search for it with A 1e-09 to 1000, A_p 1e-09 to 1000 of
either sign or 0, F_0 1e-09 to 1000, F_0_p 1e-09 to 1000 of either sign or 0, I_0 1e-12 to 1 or 0, I_0A 1e-09 to
1e+06 of either sign or 0, I_0AA 1e-09 to 1e+09 of either sign or 0, I_0AAA 1e-09 to 1e+12 of either sign or 0,
I_0AAp 1e-09 to 1000 of either sign or 0, I_0Ap 1e-09 to 1000 of either sign or 0, I_0p 1e-09 to 1000 of either sign
or 0, Omega 0.001 to 1000, Omega_p 1e-09 to 1000 of either sign or 0, R 1e-09 to 1e+06 of either sign or 0, S_F
1e-09 to 1000 of either sign or 0, S_FOmega 1e-09 to 1000 of either sign or 0, S_Omega 1e-09 to 1000 of either sign
or 0, S_OmegaOmega 1e-09 to 1000 of either sign or 0, d 1e-12 to 1000 or 0, d_p 1e-09 to 1000 of either sign or 0,
end_p 1e-09 to 1000 of either sign or 0, force 1e-09 to 1000, force_F 1e-09 to 1000 of either sign or 0, force_Omega
1e-09 to 1000 of either sign or 0, forcing_p 1e-09 to 1000 of either sign or 0, frequency_p 1e-09 to 1000 of either
sign or 0, h 1e-12 to 1000 of either sign or 0, h_A 1e-09 to 1e+06 of either sign or 0, h_AA 1e-09 to 1e+09 of
either sign or 0, h_AAA 1e-09 to 1e+12 of either sign or 0, h_AAp 1e-09 to 1000 of either sign or 0, h_Ap 1e-09 to
1000 of either sign or 0, h_p 1e-09 to 1000 of either sign or 0, zeta 1e-12 to 1 or 0, zeta_p 1e-09 to 1000 of
either sign or 0.
"""

# a formatter would spread each polynomial over a page
# fmt: off

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np


__all__ = [
    "by_force", "by_inertia", "of_state", "right", "slopes",
]


def slopes(Omega: Any, A: Any, R: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, S_Omega: Any, S_OmegaOmega: Any, S_F: Any, S_FOmega: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """By A, Omega and F_0, of what vanishes by `conventions.SYSTEMS`; then the sizes of these.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 48 results, each the arguments that it depends on,
    broadcast. Operations: 174.
    Measured, error / u (1 + kappa): 0.98
    """
    t0 = Omega * Omega
    t1 = d * t0
    t2 = 2.0 * Omega
    t3 = t2 * zeta
    t4 = A * A * t1 + A * t3
    I = I_0 + t4
    t5 = h_A + t0
    t6 = A * t0
    t7 = 2.0 * t6
    t8 = d * t7
    t9 = t3 + t8
    t10 = I_0A + t9
    t11 = Omega * R
    t12 = A * Omega
    t13 = d * t12 + zeta
    t14 = 4.0 * A
    t15 = 2.0 * t1
    t16 = A * d
    t17 = t16 * t2 + zeta
    t18 = A * t13
    t19 = 4.0 * (I * t17 + t10 * t18 + t11 + t12 * t5)
    t20 = 2.0 * t10
    t21 = 2.0 * A * t13 * t13
    t22 = A * t2
    t23 = t0 + np.abs(h_A)
    t24 = np.abs(h)
    t25 = t24 + t6
    t26 = 2.0 * t25
    t27 = t9 + np.abs(I_0A)
    t28 = t4 + np.abs(I_0)
    t29 = 2.0 * t28
    t30 = Omega * t25
    t31 = np.abs(h_AA)
    t32 = np.abs(I_0AA)
    t33 = 4.0 * t28
    t34 = 4.0 * t12
    t35 = t13 * t14
    t36 = t17 * t33 + t23 * t34 + t27 * t35 + 4.0 * t30
    t37 = 8.0 * t27
    t38 = 8.0 * Omega
    return (
        2.0 * (I * t10 + R * t5),
        -S_Omega + t14 * (I * t13 + t11),
        -S_F,
        2.0 * (I * I_0AA + I * t15 + R * h_AA + t10 * t10 + t5 * t5),
        t19,
        0.0,
        2.0 * (I * I_0AAA + I_0AA * t20 + R * h_AAA + 3.0 * h_AA * t5 + 4.0 * t1 * t10 + t10 * (I_0AA + t15)),
        4.0 * (I * d * t2 + I_0AA * t18 + h_AA * t12 + t13 * t8 + t17 * t20 + t2 * t5),
        0.0,
        t19,
        -S_OmegaOmega + t14 * (I * t16 + R + t21 + t7),
        -S_FOmega,
        t5,
        t22,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        1.0,
        0.0,
        1.0,
        0.0,
        0.0,
        t23 * t26 + t27 * t29,
        t14 * (t13 * t28 + t30) + np.abs(S_Omega),
        np.abs(S_F),
        t1 * t33 + 2.0 * t23 * t23 + t26 * t31 + 2.0 * t27 * t27 + t29 * t32,
        t36,
        0.0,
        t1 * t37 + 6.0 * t23 * t31 + t26 * np.abs(h_AAA) + 4.0 * t27 * t32 + 2.0 * t27 * (t15 + t32) + t29 *
        np.abs(I_0AAA),
        8.0 * d * t13 * t6 + d * t28 * t38 + t17 * t37 + t23 * t38 + t31 * t34 + t32 * t35,
        0.0,
        t36,
        t14 * (t16 * t28 + t21 + t24 + 3.0 * t6) + np.abs(S_OmegaOmega),
        np.abs(S_FOmega),
        t23,
        t22,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        1.0,
        0.0,
        1.0,
        0.0,
        0.0,
    )


def right(Omega: Any, A: Any, R: Any, I_0: Any, I_0A: Any, I_0AA: Any, zeta: Any, d: Any, h_A: Any, h_AA: Any, h_p: Any, h_Ap: Any, h_AAp: Any, I_0p: Any, I_0Ap: Any, I_0AAp: Any, zeta_p: Any, d_p: Any, forcing_p: Any, frequency_p: Any, end_p: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any]:
    """What a parameter does to what vanishes, with the opposite sign.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 8 results, each the arguments that it depends on,
    broadcast. Operations: 74.
    Proved, error / u (1 + kappa): -, -, -, -, 0.0, 0.0, 0.0, 0.0
    Measured, error / u (1 + kappa): 0.68
    """
    t0 = 2.0 * Omega
    t1 = t0 * zeta
    t2 = Omega * Omega
    t3 = A * A * t2
    I = A * t1 + I_0 + d * t3
    t4 = A * t0 * zeta_p + I_0p + d_p * t3
    t5 = I * zeta_p
    t6 = h_A + t2
    t7 = 2.0 * t2
    t8 = d_p * t7
    t9 = d * t7
    t10 = A * t9 + I_0A + t1
    t11 = 2.0 * t10
    t12 = A * Omega
    return (
        -2.0 * (I * t4 + R * h_p),
        -2.0 * (A * I * t8 + I * I_0Ap + R * h_Ap + h_p * t6 + t0 * t5 + t10 * t4),
        -2.0 * (I * I_0AAp + I_0Ap * t11 + 4.0 * Omega * t10 * zeta_p + R * h_AAp + h_AA * h_p + 2.0 * h_Ap * t6 +
        t4 * (I_0AA + t9) + t8 * (A * t11 + I)),
        -4.0 * A * (I * d_p * t12 + Omega * h_p + t4 * (d * t12 + zeta) + t5),
        -h_p,
        forcing_p,
        frequency_p,
        end_p,
    )


def of_state(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, d: Any, h: Any, h_A: Any, force: Any, force_Omega: Any, force_F: Any, h_p: Any, I_0p: Any, zeta_p: Any, d_p: Any, A_p: Any, Omega_p: Any, F_0_p: Any) -> tuple[Any, Any]:
    """d/dp of the phase (25) and of the transmissibility of a state that moves by A_p, Omega_p, F_0_p.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 2 results, each the arguments that it depends on,
    broadcast. Operations: 60.
    Measured, error / u (1 + kappa): 0.63
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = 2.0 * Omega
    t3 = A * t2
    t4 = A * A
    t5 = t0 * t4
    I = I_0 + d * t5 + t3 * zeta
    t6 = A_p * h_A + h_p
    R_moved = A_p * t0 + Omega_p * t3 + t6
    I_moved = (
        2.0 * A * Omega_p * zeta + A_p * I_0A + 2.0 * A_p * d * t1 + A_p * t2 * zeta + I_0p + Omega_p * d * t2 * t4
        + d_p * t5 + t3 * zeta_p
    )
    t7 = 1.0 / force
    t8 = np.hypot(h, I)
    t9 = 1.0 / t8
    return (
        (-I * R_moved + I_moved * R) / (I * I + R * R),
        t7 * (I * I_moved * t9 + h * t6 * t9 - t7 * t8 * (F_0_p * force_F + Omega_p * force_Omega)),
    )


def by_force(Omega: Any, F_0: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any]:
    """Force, its slopes by Omega and F_0; of its square S_Omega, S_OmegaOmega, S_F, S_FOmega: a force.

    Equation (3). Domain: Omega >= 0. Shape: 7 results, each the arguments that it depends on, broadcast.
    Operations: 1.
    Proved, error / u (1 + kappa): 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    """
    return F_0, 0.0, 1.0, 0.0, 0.0, 2.0 * F_0, 0.0


def by_inertia(Omega: Any, F_0: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any]:
    """Force, its slopes by Omega and F_0; of its square S_Omega, S_OmegaOmega, S_F, S_FOmega: an excitation by inertia.

    Equation beside (3). Domain: Omega >= 0. Shape: 7 results, each the arguments that it depends on, broadcast.
    Operations: 14.
    Proved, error / u (1 + kappa): 0.51, 0.34, 0.34, 0.67, 0.81, 0.67, 0.61
    """
    Omega2 = Omega * Omega
    t0 = 2.0 * F_0
    t1 = F_0 * F_0
    Omega3 = Omega * Omega2
    Omega4 = Omega2 * Omega2
    return F_0 * Omega2, Omega * t0, Omega2, 4.0 * Omega3 * t1, 12.0 * Omega2 * t1, Omega4 * t0, 8.0 * F_0 * Omega3

