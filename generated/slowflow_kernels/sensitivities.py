"""How answers move with the parameters: what the implicit function theorem asks for.

Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
derivations/extensions/dissipation.py, derivations/extensions/inertia.py, derivations/systems/gradients.py; never
edit.

Rounding errors were measured with A, F_0, force 1e-09 to 1000; A_p, F_0_p, I_0AAp, I_0Ap, I_0p, Omega_p, S_F,
S_FOmega, S_Omega, S_OmegaOmega, d_3p, d_p, end_p, force_F, force_Omega, forcing_p, frequency_p, h_AAp, h_Ap, h_p,
zeta_AAp, zeta_Ap, zeta_p 1e-09 to 1000 of either sign or 0; I_0, zeta 1e-12 to 1 or 0; I_0A, R, h_A 1e-09 to 1e+06
of either sign or 0; I_0AA, h_AA 1e-09 to 1e+09 of either sign or 0; I_0AAA, h_AAA 1e-09 to 1e+12 of either sign or
0; Omega 0.001 to 1000; d, d_3 1e-12 to 1000 or 0; h 1e-12 to 1000 of either sign or 0; zeta_A, zeta_AA, zeta_AAA
1e-09 to 1e+06 or 0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.support.backend import from_c

__all__ = [
    "by_force", "by_inertia", "of_state", "right", "slopes",
]


def slopes(Omega: Any, A: Any, R: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, zeta_A: Any, zeta_AA: Any, zeta_AAA: Any, d: Any, d_3: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, S_Omega: Any, S_OmegaOmega: Any, S_F: Any, S_FOmega: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """By A, Omega and F_0, of what vanishes by `conventions.SYSTEMS`; then the sizes of these.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Operations: 272. Error / u (1 + kappa): measured 1.1.
    """
    Omega2 = Omega * Omega
    A2 = A * A
    t0 = A2 * Omega2
    Omega3 = Omega * Omega2
    t1 = Omega3 * d_3
    t2 = 2.0 * zeta
    t3 = Omega * t2
    A3 = A * A2
    t4 = A * t3 + A3 * t1 + d * t0
    I = I_0 + t4
    t5 = Omega2 + h_A
    t6 = A * Omega2
    t7 = 2.0 * A
    t8 = t7 * zeta_A
    t9 = 3.0 * A2 * t1 + Omega * t8 + 2.0 * d * t6 + t3
    t10 = I_0A + t9
    t11 = 2.0 * R
    t12 = Omega * t11
    t13 = Omega * d
    t14 = 3.0 * d_3
    t15 = t0 * t14 + t13 * t7 + t2
    t16 = 2.0 * Omega
    t17 = t16 * zeta_A
    t18 = Omega * t7
    t19 = t18 * zeta_AA
    t20 = t13 + t14 * t6 + zeta_A
    t21 = t16 * t20
    t22 = 4.0 * A
    t23 = 9.0 * d_3
    t24 = t0 * t23 + t13 * t22 + t2
    t25 = t24 + t8
    t26 = A * t10
    t27 = 2.0 * (I * t25 + t12 + t15 * t26 + t18 * t5)
    t28 = 4.0 * Omega
    t29 = t10 * t28
    t30 = I + t26
    t31 = t28 * zeta_AA
    t32 = t17 + t19 + t21
    t33 = 2.0 * t13 + t23 * t6 + zeta_A
    t34 = A * t15
    t35 = Omega * t34
    t36 = t7 * (A * Omega * t14 + d)
    t37 = A * t15 * t15
    t38 = Omega2 + np.abs(h_A)
    t39 = np.abs(h)
    t40 = t39 + t6
    t41 = 2.0 * t40
    t42 = t9 + np.abs(I_0A)
    t43 = t4 + np.abs(I_0)
    t44 = 2.0 * t43
    t45 = np.abs(h_AA)
    t46 = np.abs(I_0AA)
    t47 = t28 * t43
    t48 = t31 * t43
    t49 = A * t28
    t50 = A * t42
    t51 = 2.0 * t15 * t50 + t25 * t44 + t28 * t40 + t38 * t49
    t52 = 8.0 * Omega
    t53 = t42 * t52
    t54 = 2.0 * t42
    t55 = t43 + t50
    return (
        2.0 * (I * t10 + R * t5),
        -S_Omega + t7 * (I * t15 + t12),
        -S_F,
        2.0 * (I * I_0AA + I * t17 + I * t19 + I * t21 + R * h_AA + t10 * t10 + t5 * t5),
        t27, 0.0,
        2.0 * (I * I_0AAA + 6.0 * I * t1 + I * t16 * zeta_AA + I * t18 * zeta_AAA + 2.0 * I_0AA * t10 + R * h_AAA +
        3.0 * h_AA * t5 + t10 * (I_0AA + t32) + t20 * t29 + t29 * zeta_A + t30 * t31),
        2.0 * (2.0 * I * t33 + I_0AA * t34 + h_AA * t18 + t10 * t24 + t10 * t25 + t15 * t18 * t20 + t28 * t5 + t7 *
        zeta_AA * (I + t35) + 2.0 * zeta_A * (t30 + t35)),
        0.0, t27,
        -S_OmegaOmega + t7 * (I * t36 + t11 + t37 + 4.0 * t6),
        -S_FOmega, t5, t18, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0,
        t38 * t41 + t42 * t44,
        t7 * (t15 * t43 + t16 * t40) + np.abs(S_Omega),
        np.abs(S_F),
        A * t48 + t20 * t47 + 2.0 * t38 * t38 + t41 * t45 + 2.0 * t42 * t42 + t44 * t46 + t47 * zeta_A,
        t51, 0.0,
        A * t47 * zeta_AAA + 12.0 * t1 * t43 + t20 * t53 + 6.0 * t38 * t45 + t41 * np.abs(h_AAA) + 4.0 * t42 * t46 +
        t44 * np.abs(I_0AAA) + t48 + t52 * t55 * zeta_AA + t53 * zeta_A + t54 * (t32 + t46),
        t15 * t46 * t7 + 4.0 * t20 * t35 + t22 * zeta_AA * (t35 + t43) + t24 * t54 + t25 * t54 + 4.0 * t33 * t43 +
        t38 * t52 + t45 * t49 + 4.0 * zeta_A * (t35 + t55),
        0.0, t51,
        t7 * (t36 * t43 + t37 + 2.0 * t39 + 6.0 * t6) + np.abs(S_OmegaOmega),
        np.abs(S_FOmega),
        t38, t18, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0,
    )

#: functions that no Python code calls, which are in C, with their arguments; see generated/c/sensitivities.h
FROM_C = {
    "right": "Omega A R I_0 I_0A I_0AA zeta zeta_A zeta_AA d d_3 h_A h_AA h_p h_Ap h_AAp I_0p I_0Ap I_0AAp zeta_p zeta_Ap zeta_AAp d_p d_3p forcing_p frequency_p end_p",
    "of_state": "Omega A I_0 I_0A zeta zeta_A d d_3 h h_A force force_Omega force_F h_p I_0p zeta_p d_p d_3p A_p Omega_p F_0_p",
    "by_force": "Omega F_0",
    "by_inertia": "Omega F_0",
}
globals().update(from_c("sensitivities", FROM_C))
