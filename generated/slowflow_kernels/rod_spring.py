"""Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr.

Written by `make derive` from derivations/mechanisms/rod_spring.py; never edit.

Regimes: passed_n where A exceeds n breakpoints, far_k where it exceeds k of them 21/20 times.
Rounding errors were measured with A, F_0 1e-09 to 1000; Omega 0.001 to 1000; alpha 1e-16 to 1000 of either sign or
0; beta 1e-12 to 1000 of either sign or 0; delta_h 1e-12 to 1; gamma 1e-12 to 1000 or 0; lam 1 to 100; m, mu, zeta
1e-12 to 1 or 0; r 1e-06 to 1e+06; u 1e-09 to 1000 of either sign or 0; u_cr 1e-06 to 1.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow_kernels import slow_flow as flow
from slowflow.support.backend import NATIVE, compiled, from_c
from slowflow.support.broadcast import broadcast_outputs, by_regime, floats, number_by_regime
from slowflow.support.record import Law, Mechanism, Parameter, Scale

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from slowflow.support.broadcast import Floats

__all__ = [
    "F_A", "H_A", "H_AA", "MECHANISM", "F", "H", "averaged", "averaged_2", "averaged_H", "backbone", "breakpoints",
    "by_design", "by_parameter", "coefficients", "detachment", "equivalent_damping", "fold_quartic", "force",
    "force_1", "force_1_u", "force_2", "force_2_u", "h", "h_A", "h_AA", "h_AAA", "hardening", "harmonics",
    "intercept", "jacobian", "jumps", "level", "limit_envelope", "peak_cubic", "phase", "response_quartic",
    "saddle_node_onset", "saddle_nodes", "stability", "steps", "steps_by", "transmissibility",
]


def _common_1(A, u_cr):
    """What averaged_passed_1_far_1, averaged_2_passed_1_far_1, averaged_H_passed_1_far_1, intercept_passed_1_far_1,
    by_parameter_passed_1_far_1 have in common."""
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    x2 = x * x
    s = x / np.sqrt(2.0 * y + 2.0)
    s2 = s * s
    s4 = s2 * s2
    s8 = s4 * s4
    s9 = s * s8
    M8 = (
        s9 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (3.6963081749325447e-05 * s4 +
        6.2301919302519632e-05) + 0.00011102157704373623) + 0.00021201233531153478) + 0.00044230925731169869) +
        0.00103759765625) + 0.0028666834677419355) + 0.010127314814814815) + 0.05434782608695652) +
        0.73684210526315785) - 74.666666666666671) - 162.90909090909091) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (s4 * (s4 * (s4 * (2.8978731853911948e-05 * s4 + 4.7688218677100145e-05) + 8.2529815179961072e-05) +
        0.00015194217363993326) + 0.00030240198461020863) + 0.00066602552259290536) + 0.0016830906723484848) +
        0.0051858836206896556) + 0.021874999999999999) + 0.16666666666666666) + 8.235294117647058) +
        172.30769230769232) + 56.888888888888886)
    )
    x3 = x * x2
    x6 = x3 * x3
    x7 = x * x6
    M6 = 1.1428571428571428 * M8 + 0.14285714285714285 * x7 * y
    return root, x, y, M8, M6


def _common_2(A, W3_3, W3_5, W5_3, W5_5, alpha, beta, gamma, root, u_cr, x, y):
    """The outputs of harmonics_passed_1, harmonics_passed_1_far_1."""
    t0 = 1.0 / A
    x2 = x * x
    x3 = x * x2
    t1 = x3 * y
    W3_1 = -t1
    W5_1 = -t1 * (2.6666666666666665 * x2 - 1.6666666666666667)
    t3 = alpha - 1.0
    t4 = W3_1 * t3
    A2 = A * A
    t5 = W3_3 * beta
    A4 = A2 * A2
    t6 = A4 * gamma
    t7 = W3_5 * t6
    t8 = 1.2732395447351628 * A
    t9 = 3.0 * beta
    t10 = A2 * t9
    t11 = 1.0 / A2
    t12 = 1.0 / root
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    t13 = t11 * u_cr2
    t14 = -4.0 * t13
    t15 = -t14 - 3.0
    t16 = gamma * u_cr2
    t17 = t3 + u_cr2 * (beta + t16)
    t18 = 6.0 * t5
    t19 = W3_5 * gamma
    A3 = A * A2
    t20 = 20.0 * A3
    t21 = t17 * u_cr3
    t22 = t12 * t21
    t23 = 1.0 / A3
    t24 = t15 * t23
    root2 = root * root
    root3 = root * root2
    t25 = 1.0 / root3
    t26 = t21 * t25
    t27 = t0 * t26
    t28 = t14 + 1.0
    t29 = -t3 - u_cr2 * (5.0 * t16 + t9)
    t30 = t12 * t29 * u_cr3
    t31 = 60.0 * A2
    t32 = 1.0 / A4
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    t33 = 10.0 * t16 + t9
    t34 = t22 * t32
    t35 = 3.0 * t28
    t36 = t30 * t32
    t37 = 3.0 / root2
    t38 = W5_1 * t3
    t39 = W5_3 * beta
    t40 = W5_5 * t6
    t41 = t32 * u_cr4
    t42 = 16.0 * t41
    t43 = -20.0 * t13 + t42 + 5.0
    t44 = 6.0 * t39
    t45 = W5_5 * gamma
    t46 = t23 * t43
    t47 = 12.0 * t11 * u_cr2 - t42 - 1.0
    t48 = 5.0 * t47
    return (
        -t8 * (A2 * t5 + t4 + t7),
        1.2732395447351628 * (-W3_3 * t10 + t11 * t12 * t15 * t17 * u_cr3 - t4 - 5.0 * t7),
        1.2732395447351628 * (-A * t18 + 3.0 * t12 * t17 * t23 * t28 * u_cr3 - t15 * t27 - t19 * t20 - t22 * t24 -
        t24 * t30),
        1.2732395447351628 * (t11 * t15 * t25 * t29 * u_cr3 - t11 * t26 * t35 + 2.0 * t12 * t15 * t17 * t32 * u_cr3
        + 2.0 * t12 * t15 * t29 * t32 * u_cr3 + 2.0 * t12 * t15 * t32 * t33 * u_cr5 + 6.0 * t12 * t17 * t32 * u_cr3
        * (8.0 * t11 * u_cr2 - 1.0) - t18 - t19 * t31 - t26 * (-t11 * t15 + 3.0 * t11 * t28 - t15 * t37) - 6.0 * t28
        * t34 - t35 * t36),
        -t8 * (A2 * t39 + t38 + t40),
        1.2732395447351628 * (-W5_3 * t10 + t11 * t12 * t17 * t43 * u_cr3 - t38 - 5.0 * t40),
        1.2732395447351628 * (-A * t44 + 5.0 * t12 * t17 * t23 * t47 * u_cr3 - t20 * t45 - t22 * t46 - t27 * t43 -
        t30 * t46),
        1.2732395447351628 * (t11 * t25 * t29 * t43 * u_cr3 - t11 * t26 * t48 + 2.0 * t12 * t17 * t32 * t43 * u_cr3
        + 10.0 * t12 * t17 * t32 * u_cr3 * (-24.0 * t13 + 48.0 * t41 + 1.0) + 2.0 * t12 * t29 * t32 * t43 * u_cr3 +
        2.0 * t12 * t32 * t33 * t43 * u_cr5 - t26 * (-t11 * t43 + 5.0 * t11 * t47 - t37 * t43) - t31 * t45 - 10.0 *
        t34 * t47 - t36 * t48 - t44),
    )


def _averaged_passed_0(A, alpha, beta, gamma, u_cr):
    t0 = -alpha
    t1 = A * A
    t2 = gamma * t1
    t3 = 4.5 * beta
    return (
        A * (t0 + t1 * (-0.75 * beta - 0.625 * t2)),
        t0 + t1 * (-2.25 * beta - 3.125 * t2),
        A * (-12.5 * t2 - t3),
        -37.5 * t2 - t3,
    )


def _averaged_passed_1(A, alpha, beta, gamma, u_cr):
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    psi_0 = np.arctan2(root, u_cr)
    theta = np.arctan2(u_cr, root)
    t1 = x * y
    t2 = 0.5 * t1
    M2 = -t2 + 0.5 * theta
    t3 = x * x
    M4 = -t1 * (0.25 * t3 + 0.375) + 0.375 * theta
    M6 = -t1 * (t3 * (0.16666666666666666 * t3 + 0.20833333333333334) + 0.3125) + 0.3125 * theta
    S2_2 = 0.5 * psi_0 + t2
    A2 = A * A
    t4 = M4 * beta
    A4 = A2 * A2
    t5 = M6 * gamma
    t6 = A4 * t5
    t7 = M2 * alpha + S2_2
    t8 = 3.0 * beta
    t9 = 1.0 / A2
    t10 = 1.0 / root
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    t11 = gamma * u_cr2
    t12 = alpha - 1.0
    t13 = t12 + u_cr2 * (beta + t11)
    t14 = 6.0 * t4
    A3 = A * A2
    root2 = root * root
    root3 = root * root2
    t15 = u_cr3 / root3
    t16 = t13 * t15
    t17 = t10 * u_cr3
    t18 = t17 / A3
    t19 = -t12 - u_cr2 * (5.0 * t11 + t8)
    t20 = 1.0 / A4
    t21 = t17 * t20
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    return (
        -1.2732395447351628 * A * (A2 * t4 + t6 + t7),
        1.2732395447351628 * (-A2 * M4 * t8 + t10 * t13 * t9 * u_cr3 - 5.0 * t6 - t7),
        -1.2732395447351628 * (A * t14 + 20.0 * A3 * t5 + t0 * t16 + 2.0 * t13 * t18 + t18 * t19),
        1.2732395447351628 * (-60.0 * A2 * t5 + 2.0 * t10 * t20 * u_cr5 * (10.0 * t11 + t8) + t13 * t15 * t9 + 6.0 *
        t13 * t21 - t14 + t15 * t19 * t9 + t16 * (2.0 * t9 + 3.0 / root2) + 3.0 * t19 * t21),
    )


def _averaged_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    root, x, y, M8, M6 = _common_1(A, u_cr)
    t0 = 1.0 / A
    x2 = x * x
    z = x2 / (y * y)
    x3 = x * x2
    x6 = x3 * x3
    x7 = x * x6
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y
    t1 = alpha - 1.0
    t2 = A * A
    t3 = gamma * t2
    t4 = 1.0 / y
    t5 = t4 * x3
    t6 = t4 * x5
    t7 = t4 * x7
    t8 = t1 * t5
    t9 = 7.2000000000000002 * M6
    t10 = 1.2 * x2
    t11 = 3.0 * z
    return (
        -1.2732395447351628 * A * (M2 * t1 + t2 * (M4 * beta + M6 * t3)) - A,
        -1.2732395447351628 * (t1 * (M2 - t5) + t2 * (beta * (3.6000000000000001 * M6 + t6 * (-0.59999999999999998 *
        x2 - 0.40000000000000002)) + t3 * (5.7142857142857144 * M8 + t7 * (-0.7142857142857143 * x2 -
        0.2857142857142857)))) - 1.0,
        -1.2732395447351628 * t0 * (t2 * (beta * (t6 * (-t10 + z + 1.2) + t9) + t3 * (22.857142857142858 * M8 + t7 *
        (-2.8571428571428572 * x2 + z + 0.8571428571428571))) + t8 * (z + 2.0)),
        -1.2732395447351628 * (t2 * (beta * (t6 * (-t10 + z * (-t11 - 6.0) - 4.7999999999999998) + t9) + t3 *
        (68.571428571428569 * M8 + t7 * (-8.5714285714285712 * x2 + z * (-t11 - 4.0) - 3.4285714285714284))) + t8 *
        (z * (-t11 - 8.0) - 8.0)) / t2,
    )


def averaged(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """h, h_A, h_AA, h_AAA together.

    Equation (20)-(22), (31). Domain: A >= 0. Operations: 19 in passed_0, 116 in passed_1, 167 in passed_1_far_1.
    Error / u (1 + kappa): proved in passed_0 5.51, 4.51, 2.34, 1.51; measured 2.2.
    """
    A, alpha, beta, gamma, u_cr = arguments = floats(A, alpha, beta, gamma, u_cr)
    bodies = (_averaged_passed_0, _averaged_passed_1, _averaged_passed_1_far_1)
    return by_regime((A <= u_cr, A <= 1.05 * u_cr), bodies, arguments, 4)


def _averaged_2_passed_0(A, alpha, beta, gamma, u_cr):
    t0 = -alpha
    t1 = A * A
    t2 = gamma * t1
    return A * (t0 + t1 * (-0.75 * beta - 0.625 * t2)), t0 + t1 * (-2.25 * beta - 3.125 * t2)


def _averaged_2_passed_1(A, alpha, beta, gamma, u_cr):
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    psi_0 = np.arctan2(root, u_cr)
    theta = np.arctan2(u_cr, root)
    t1 = x * y
    t2 = 0.5 * t1
    M2 = -t2 + 0.5 * theta
    t3 = x * x
    M4 = -t1 * (0.25 * t3 + 0.375) + 0.375 * theta
    M6 = -t1 * (t3 * (0.16666666666666666 * t3 + 0.20833333333333334) + 0.3125) + 0.3125 * theta
    S2_2 = 0.5 * psi_0 + t2
    A2 = A * A
    t4 = A2 * M4 * beta
    A4 = A2 * A2
    t5 = A4 * M6 * gamma
    t6 = M2 * alpha + S2_2
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    return (
        -1.2732395447351628 * A * (t4 + t5 + t6),
        1.2732395447351628 * (-3.0 * t4 - 5.0 * t5 - t6 + u_cr3 * (alpha + u_cr2 * (beta + gamma * u_cr2) - 1.0) /
        (A2 * root)),
    )


def _averaged_2_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    root, x, y, M8, M6 = _common_1(A, u_cr)
    x2 = x * x
    x3 = x * x2
    x6 = x3 * x3
    x7 = x * x6
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y
    t1 = alpha - 1.0
    t2 = A * A
    t3 = gamma * t2
    t4 = 1.0 / y
    return (
        -1.2732395447351628 * A * (M2 * t1 + t2 * (M4 * beta + M6 * t3)) - A,
        -1.2732395447351628 * (t1 * (M2 - t4 * x3) + t2 * (beta * (3.6000000000000001 * M6 + t4 * x5 *
        (-0.59999999999999998 * x2 - 0.40000000000000002)) + t3 * (5.7142857142857144 * M8 + t4 * x7 *
        (-0.7142857142857143 * x2 - 0.2857142857142857)))) - 1.0,
    )


def averaged_2(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> tuple[Any, Any]:
    """h, h_A together.

    Equation (20)-(22), (31). Domain: A >= 0. Operations: 13 in passed_0, 56 in passed_1, 117 in passed_1_far_1.
    Error / u (1 + kappa): proved in passed_0 5.51, 4.51; measured 1.6.
    """
    A, alpha, beta, gamma, u_cr = arguments = floats(A, alpha, beta, gamma, u_cr)
    bodies = (_averaged_2_passed_0, _averaged_2_passed_1, _averaged_2_passed_1_far_1)
    return by_regime((A <= u_cr, A <= 1.05 * u_cr), bodies, arguments, 2)


def _averaged_H_passed_0(A, alpha, beta, gamma, u_cr):
    t0 = A * A
    t1 = gamma * t0
    t2 = 1.0 - alpha
    return A * (t0 * (-0.75 * beta - 0.625 * t1) + t2), t0 * (-2.25 * beta - 3.125 * t1) + t2


def _averaged_H_passed_1(A, alpha, beta, gamma, u_cr):
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    theta = np.arctan2(u_cr, root)
    t1 = x * y
    M2 = -0.5 * t1 + 0.5 * theta
    t2 = x * x
    M4 = -t1 * (0.25 * t2 + 0.375) + 0.375 * theta
    M6 = -t1 * (t2 * (0.16666666666666666 * t2 + 0.20833333333333334) + 0.3125) + 0.3125 * theta
    t3 = alpha - 1.0
    t4 = M2 * t3
    A2 = A * A
    t5 = A2 * M4 * beta
    A4 = A2 * A2
    t6 = A4 * M6 * gamma
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    return (
        -1.2732395447351628 * A * (t4 + t5 + t6),
        1.2732395447351628 * (-t4 - 3.0 * t5 - 5.0 * t6 + u_cr3 * (t3 + u_cr2 * (beta + gamma * u_cr2)) / (A2 *
        root)),
    )


def _averaged_H_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    root, x, y, M8, M6 = _common_1(A, u_cr)
    x2 = x * x
    x3 = x * x2
    x6 = x3 * x3
    x7 = x * x6
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y
    t1 = alpha - 1.0
    t2 = A * A
    t3 = gamma * t2
    t4 = 1.0 / y
    return (
        -1.2732395447351628 * A * (M2 * t1 + t2 * (M4 * beta + M6 * t3)),
        -1.2732395447351628 * (t1 * (M2 - t4 * x3) + t2 * (beta * (3.6000000000000001 * M6 + t4 * x5 *
        (-0.59999999999999998 * x2 - 0.40000000000000002)) + t3 * (5.7142857142857144 * M8 + t4 * x7 *
        (-0.7142857142857143 * x2 - 0.2857142857142857)))),
    )


def averaged_H(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> tuple[Any, Any]:
    """H, H_A together.

    Equation (20)-(22), (31). Domain: A >= 0. Operations: 14 in passed_0, 52 in passed_1, 115 in passed_1_far_1.
    Error / u (1 + kappa): proved in passed_0 7.67, 6.34; measured 3.
    """
    A, alpha, beta, gamma, u_cr = arguments = floats(A, alpha, beta, gamma, u_cr)
    bodies = (_averaged_H_passed_0, _averaged_H_passed_1, _averaged_H_passed_1_far_1)
    return by_regime((A <= u_cr, A <= 1.05 * u_cr), bodies, arguments, 2)


def _intercept_passed_0(A, alpha, beta, gamma, u_cr):
    A2 = A * A
    A3 = A * A2
    return A3 * (2.5 * A2 * gamma + 1.5 * beta)


def _intercept_passed_1(A, alpha, beta, gamma, u_cr):
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    theta = np.arctan2(u_cr, root)
    t1 = x * x
    t2 = x * y
    M4 = -t2 * (0.25 * t1 + 0.375) + 0.375 * theta
    M6 = -t2 * (t1 * (0.16666666666666666 * t1 + 0.20833333333333334) + 0.3125) + 0.3125 * theta
    u_cr2 = u_cr * u_cr
    A2 = A * A
    A3 = A * A2
    A4 = A2 * A2
    A5 = A * A4
    u_cr3 = u_cr * u_cr2
    return (
        1.2732395447351628 * (2.0 * A3 * M4 * beta + 4.0 * A5 * M6 * gamma - t0 * u_cr3 * (alpha + u_cr2 * (beta +
        gamma * u_cr2) - 1.0) / root)
    )


def _intercept_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    root, x, y, M8, M6 = _common_1(A, u_cr)
    x2 = x * x
    x3 = x * x2
    x6 = x3 * x3
    x7 = x * x6
    t1 = 1.0 / y
    t2 = A * A
    x4 = x2 * x2
    x5 = x * x4
    return (
        -1.2732395447351628 * A * (t1 * x3 * (alpha - 1.0) + t2 * (beta * (-2.3999999999999999 * M6 + t1 * x5 *
        (0.40000000000000002 * x2 + 0.59999999999999998)) + gamma * t2 * (-4.5714285714285712 * M8 + t1 * x7 *
        (0.5714285714285714 * x2 + 0.42857142857142855))))
    )


def intercept(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """h - A h_A, where the tangent of h meets A = 0; linear terms are none.

    Equation (20)-(22), (31). Domain: A >= 0. Operations: 7 in passed_0, 45 in passed_1, 99 in passed_1_far_1. Error
    / u (1 + kappa): proved in passed_0 4.61; measured 3.
    """
    A, alpha, beta, gamma, u_cr = arguments = floats(A, alpha, beta, gamma, u_cr)
    bodies = (_intercept_passed_0, _intercept_passed_1, _intercept_passed_1_far_1)
    return number_by_regime((A <= u_cr, A <= 1.05 * u_cr), bodies, arguments)


def _harmonics_passed_0(A, alpha, beta, gamma, u_cr):
    A2 = A * A
    A3 = A * A2
    t0 = A2 * gamma
    t1 = 1.5 * beta
    A4 = A2 * A2
    A5 = A * A4
    return (
        A3 * (-0.25 * beta - 0.3125 * t0),
        A2 * (-0.75 * beta - 1.5625 * t0),
        A * (-6.25 * t0 - t1),
        -18.75 * t0 - t1,
        -0.0625 * A5 * gamma,
        -0.3125 * A4 * gamma,
        -1.25 * A3 * gamma,
        -3.75 * t0,
    )


def _harmonics_passed_1(A, alpha, beta, gamma, u_cr):
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    theta = np.arctan2(u_cr, root)
    x2 = x * x
    t2 = x * y
    W3_3 = -t2 * (x2 * (0.66666666666666663 * x2 + 0.083333333333333329) + 0.125) + 0.125 * theta
    W3_5 = (
        -t2 * (x2 * (x2 * (0.5 * x2 + 0.083333333333333329) + 0.10416666666666667) + 0.15625) + 0.15625 * theta
    )
    x4 = x2 * x2
    x5 = x * x4
    W5_3 = -x5 * y * (2.0 * x2 - 1.0)
    W5_5 = (
        -t2 * (x2 * (x2 * (x2 * (1.6000000000000001 * x2 - 0.69999999999999996) + 0.016666666666666666) +
        0.020833333333333332) + 0.03125) + 0.03125 * theta
    )
    result_0, result_1, result_2, result_3, result_4, result_5, result_6, result_7 = _common_2(
        A, W3_3, W3_5, W5_3, W5_5, alpha, beta, gamma, root, u_cr, x, y
    )
    return result_0, result_1, result_2, result_3, result_4, result_5, result_6, result_7


def _harmonics_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    s = x / np.sqrt(2.0 * y + 2.0)
    s2 = s * s
    s4 = s2 * s2
    s5 = s * s4
    s10 = s5 * s5
    s11 = s * s10
    M10 = (
        s11 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-3.4702182012168982e-05 * s4 -
        6.5400985614308773e-05) - 0.00013219458716256277) - 0.00029172897338867185) - 0.00072125690739329265) -
        0.0020784945101351353) - 0.007457386363636364) - 0.037715517241379309) - 0.35999999999999999) - 24.0) -
        790.58823529411768) - 708.92307692307691) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (-4.7267075966704972e-05 * s4 - 9.2082602136275347e-05) - 0.00019396873230629778) - 0.00045130973638490189)
        - 0.0011972280649038462) - 0.0038085937499999999) - 0.015877016129032258) - 0.10416666666666667) -
        1.826086956521739) + 265.26315789473682) + 1075.2) + 186.18181818181819)
    )
    x2 = x * x
    x4 = x2 * x2
    x8 = x4 * x4
    x9 = x * x8
    M8 = 1.1111111111111112 * M10 + 0.1111111111111111 * x9 * y
    x3 = x * x2
    x6 = x3 * x3
    x7 = x * x6
    M6 = 1.1428571428571428 * M8 + 0.14285714285714285 * x7 * y
    x5 = x * x4
    t1 = x5 * y
    M4 = 1.2 * M6 + 0.20000000000000001 * t1
    W3_3 = -3.0 * M4 + 4.0 * M6
    W3_5 = -3.0 * M6 + 4.0 * M8
    W5_3 = -t1 * (2.0 * x2 - 1.0)
    W5_5 = 16.0 * M10 + 5.0 * M6 - 20.0 * M8
    result_0, result_1, result_2, result_3, result_4, result_5, result_6, result_7 = _common_2(
        A, W3_3, W3_5, W5_3, W5_5, alpha, beta, gamma, root, u_cr, x, y
    )
    return result_0, result_1, result_2, result_3, result_4, result_5, result_6, result_7


def harmonics(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any]:
    """Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA.

    Equation beyond (20). Domain: A >= 0. Operations: 26 in passed_0, 278 in passed_1, 331 in passed_1_far_1. Error
    / u (1 + kappa): proved in passed_0 4.11, 3.51, 2.34, 1.51, 0.72, 0.84, 0.81, 0.76; measured 3.8.
    """
    A, alpha, beta, gamma, u_cr = arguments = floats(A, alpha, beta, gamma, u_cr)
    bodies = (_harmonics_passed_0, _harmonics_passed_1, _harmonics_passed_1_far_1)
    return by_regime((A <= u_cr, A <= 1.05 * u_cr), bodies, arguments, 8)


def _by_parameter_passed_0(A, h, h_A, h_AA, alpha, beta, gamma, u_cr):
    A2 = A * A
    A3 = A * A2
    A4 = A2 * A2
    A5 = A * A4
    return -A, -1.0, 0.0, -0.75 * A3, -2.25 * A2, -4.5 * A, -0.625 * A5, -3.125 * A4, -12.5 * A3, 0.0, 0.0, 0.0


def _by_parameter_passed_1(A, h, h_A, h_AA, alpha, beta, gamma, u_cr):
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    theta = np.arctan2(u_cr, root)
    t1 = x * y
    M2 = -0.5 * t1 + 0.5 * theta
    t2 = x * x
    M4 = -t1 * (0.25 * t2 + 0.375) + 0.375 * theta
    M6 = -t1 * (t2 * (0.16666666666666666 * t2 + 0.20833333333333334) + 0.3125) + 0.3125 * theta
    A2 = A * A
    t3 = 1.0 / A2
    t4 = 1.0 / root
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    A3 = A * A2
    t5 = 1.0 / A3
    root2 = root * root
    root3 = root * root2
    t6 = 1.0 / root3
    t7 = t0 * t6
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    A4 = A2 * A2
    u_cr6 = u_cr3 * u_cr3
    u_cr7 = u_cr * u_cr6
    t8 = 1.2732395447351628 * u_cr2 * (alpha + beta * u_cr2 + gamma * u_cr4 - 1.0)
    A5 = A * A4
    root4 = root2 * root2
    root5 = root * root4
    return (
        -1.2732395447351628 * A * M2,
        1.2732395447351628 * (-M2 + t3 * t4 * u_cr3),
        1.2732395447351628 * (-t4 * t5 * u_cr3 - t7 * u_cr3),
        -1.2732395447351628 * A3 * M4,
        1.2732395447351628 * (-3.0 * A2 * M4 + t3 * t4 * u_cr5),
        1.2732395447351628 * (-6.0 * A * M4 + t4 * t5 * u_cr5 - t7 * u_cr5),
        -1.2732395447351628 * A5 * M6,
        1.2732395447351628 * (-5.0 * A4 * M6 + t3 * t4 * u_cr7),
        1.2732395447351628 * (-20.0 * A3 * M6 + 3.0 * t4 * t5 * u_cr7 - t7 * u_cr7),
        -t0 * t4 * t8,
        t3 * t6 * t8 * (A2 + root2),
        -t5 * t8 * (A2 * root2 + 3.0 * A4 + 2.0 * root4) / root5,
    )


def _by_parameter_passed_1_far_1(A, h, h_A, h_AA, alpha, beta, gamma, u_cr):
    root, x, y, M8, M6 = _common_1(A, u_cr)
    t0 = 1.0 / A
    x2 = x * x
    z = x2 / (y * y)
    x3 = x * x2
    x6 = x3 * x3
    x7 = x * x6
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y
    t1 = 1.2732395447351628 * A
    t2 = 1.0 / y
    t3 = t2 * x3
    t4 = 1.2732395447351628 * t0
    A2 = A * A
    A3 = A * A2
    t5 = 1.2732395447351628 * A3
    t6 = t2 * x5
    A4 = A2 * A2
    t7 = t2 * x7
    u_cr2 = u_cr * u_cr
    u_cr4 = u_cr2 * u_cr2
    t8 = u_cr2 * (alpha + beta * u_cr2 + gamma * u_cr4 - 1.0)
    root2 = root * root
    t9 = 1.2732395447351628 * t8
    A5 = A * A4
    root3 = root * root2
    root4 = root2 * root2
    root5 = root * root4
    return (
        -M2 * t1,
        -1.2732395447351628 * (M2 - t3),
        -t3 * t4 * (z + 2.0),
        -M4 * t5,
        -1.2732395447351628 * A2 * (3.6000000000000001 * M6 + t6 * (-0.59999999999999998 * x2 -
        0.40000000000000002)),
        -t1 * (7.2000000000000002 * M6 + t6 * (-1.2 * x2 + z + 1.2)),
        -1.2732395447351628 * A5 * M6,
        -1.2732395447351628 * A4 * (5.7142857142857144 * M8 + t7 * (-0.7142857142857143 * x2 - 0.2857142857142857)),
        -t5 * (22.857142857142858 * M8 + t7 * (-2.8571428571428572 * x2 + z + 0.8571428571428571)),
        -t4 * t8 / root,
        t9 * (A2 + root2) / (A2 * root3),
        -t9 * (A2 * root2 + 3.0 * A4 + 2.0 * root4) / (A3 * root5),
    )


def by_parameter(A: Any, h: Any, h_A: Any, h_AA: Any, alpha: Any, beta: Any, gamma: Any, u_cr: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """d/dp of h, h_A and h_AA at a fixed A, for each parameter p in turn.

    Equation from (20)-(22), (31). Domain: A > 0. Operations: 10 in passed_0, 109 in passed_1, 159 in
    passed_1_far_1. Error / u (1 + kappa): proved in passed_0 0.84 at most.
    """
    A, h, h_A, h_AA, alpha, beta, gamma, u_cr = arguments = floats(A, h, h_A, h_AA, alpha, beta, gamma, u_cr)
    bodies = (_by_parameter_passed_0, _by_parameter_passed_1, _by_parameter_passed_1_far_1)
    return by_regime((A <= u_cr, A <= 1.05 * u_cr), bodies, arguments, 12)


def by_design(lam: Any, r: Any, delta_h: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """d/d of each number of the design: of each parameter in turn, then of each breakpoint.

    Equation (5), (7). Domain: any design that has a breakpoint. Operations: 17.
    """
    lam, r, delta_h = floats(lam, r, delta_h)
    t0 = lam * r
    t1 = delta_h - 1.0
    t2 = 0.5 * t1
    t3 = 0.375 * t1
    t4 = -t1 / (np.sqrt(delta_h) * np.sqrt(2.0 - delta_h))
    return broadcast_outputs((lam, r, delta_h),
        -delta_h * r,
        -delta_h * lam,
        -t0,
        -r * t2,
        -lam * t2,
        -0.5 * t0,
        -r * t3,
        -lam * t3,
        -0.375 * t0,
        0.0, 0.0, t4, 0.0, 0.0, t4,
    )


def coefficients(lam: ArrayLike, r: ArrayLike, delta_h: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """The parameters alpha, beta, gamma, u_cr from the design.

    Equation (5), (7). Domain: any design. Operations: 11. Error / u (1 + kappa): proved 1.34, 6.01, 8.01, -;
    measured 2.1.
    """
    lam, r, delta_h = floats(lam, r, delta_h)
    t0 = lam * r
    t1 = t0 * (delta_h - 1.0)
    return broadcast_outputs((lam, r, delta_h),
        -delta_h * t0 + 1.0,
        -0.5 * t1,
        -0.375 * t1,
        np.sqrt(delta_h) * np.sqrt(2.0 - delta_h),
    )


def breakpoints(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> tuple[Any]:
    """The |u| at which a piece of the force ends.

    Equation (5). Domain: any parameters. Operations: 0. Error / u (1 + kappa): proved 0.0.
    """
    alpha, beta, gamma, u_cr = floats(alpha, beta, gamma, u_cr)
    return broadcast_outputs((alpha, beta, gamma, u_cr), u_cr)


def jumps(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> tuple[Any]:
    """What the force loses at each breakpoint: f below less f above.

    Equation (6). Domain: any parameters. Operations: 7. Error / u (1 + kappa): proved 7.67.
    """
    alpha, beta, gamma, u_cr = floats(alpha, beta, gamma, u_cr)
    t0 = u_cr * u_cr
    return (
        u_cr * (alpha + t0 * (beta + gamma * t0) - 1.0),
    )


def hardening(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> tuple[Any, Any, Any]:
    """The force over the displacement, f(u)/u, rises with |u| where none of these is negative.

    Equation from (3). Domain: any parameters. Operations: 7. Error / u (1 + kappa): proved 0.0, 0.0, 7.67.
    """
    alpha, beta, gamma, u_cr = floats(alpha, beta, gamma, u_cr)
    t0 = u_cr * u_cr
    return broadcast_outputs((alpha, beta, gamma, u_cr),
        beta, gamma,
        -u_cr * (alpha + t0 * (beta + gamma * t0) - 1.0),
    )


def steps(alpha: Any, beta: Any, gamma: Any, u_cr: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """f and its derivatives just above 0, their gains at each breakpoint, and the last piece's by its formula at 0.

    Equation (3), (5). Domain: any parameters. Operations: 21. Error / u (1 + kappa): proved 7.67 at most.
    """
    alpha, beta, gamma, u_cr = floats(alpha, beta, gamma, u_cr)
    t0 = 6.0 * beta
    t1 = 120.0 * gamma
    t2 = u_cr * u_cr
    t3 = gamma * t2
    return broadcast_outputs((alpha, beta, gamma, u_cr),
        0.0, alpha, 0.0, t0, 0.0, t1,
        -u_cr * (alpha + t2 * (beta + t3) - 1.0),
        -alpha + t2 * (-3.0 * beta - 5.0 * t3) + 1.0,
        u_cr * (-t0 - 20.0 * t3),
        -t0 - 60.0 * t3,
        -t1 * u_cr,
        -t1, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0,
    )


def steps_by(alpha: Any, beta: Any, gamma: Any, u_cr: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """What each parameter does to derivatives of each piece at u = 0, then to their gains at each breakpoint.

    Equation (3). Domain: any parameters. Operations: 10. Error / u (1 + kappa): proved 0.81 at most.
    """
    alpha, beta, gamma, u_cr = floats(alpha, beta, gamma, u_cr)
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    return broadcast_outputs((alpha, beta, gamma, u_cr),
        0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -u_cr, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        6.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -u_cr3,
        -3.0 * u_cr2,
        -6.0 * u_cr,
        -6.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 120.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -u_cr5,
        -5.0 * u_cr4,
        -20.0 * u_cr3,
        -60.0 * u_cr2,
        -120.0 * u_cr,
        -120.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    )


def force_1(u: Any, alpha: Any, beta: Any, gamma: Any, u_cr: Any) -> Any:
    """Piece 1 of the whole restoring force u + F_k(u).

    Equation (3), (6). Domain: where it holds. Operations: 6. Error / u (1 + kappa): proved 4.76.
    """
    t0 = u * u
    return u * (alpha + t0 * (beta + gamma * t0))


def force_1_u(u: Any, alpha: Any, beta: Any, gamma: Any, u_cr: Any) -> Any:
    """d/du of piece 1 of the whole restoring force u + F_k(u).

    Equation (3), (6). Domain: where it holds. Operations: 7. Error / u (1 + kappa): proved 4.51.
    """
    t0 = u * u
    return alpha + t0 * (3.0 * beta + 5.0 * gamma * t0)


def force_2(u: Any, alpha: Any, beta: Any, gamma: Any, u_cr: Any) -> Any:
    """Piece 2 of the whole restoring force u + F_k(u).

    Equation (3), (6). Domain: where it holds. Operations: 0. Error / u (1 + kappa): proved 0.0.
    """
    return u


def force_2_u(u: Any, alpha: Any, beta: Any, gamma: Any, u_cr: Any) -> Any:
    """d/du of piece 2 of the whole restoring force u + F_k(u).

    Equation (3), (6). Domain: where it holds. Operations: 0. Error / u (1 + kappa): proved 0.0.
    """
    return 1.0


def force(u: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """Whole dimensionless restoring force u + F_k(u), truncated.

    Equation (3), (6). Domain: any u.
    """
    u, alpha, beta, gamma, u_cr = arguments = floats(u, alpha, beta, gamma, u_cr)
    bodies = (force_1, force_2)
    return number_by_regime((np.abs(u) <= u_cr,), bodies, arguments)


def h(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """The averaged restoring force h = H - A.

    Equation (20)-(22). Domain: A >= 0. Error / u (1 + kappa): measured 0.97.
    """
    return averaged_2(A, alpha, beta, gamma, u_cr)[0]


def h_A(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """d/dA of the averaged restoring force h = H - A.

    Equation (31). Domain: A >= 0. Error / u (1 + kappa): measured 2.8.
    """
    return averaged_2(A, alpha, beta, gamma, u_cr)[1]


def h_AA(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """d2/dA2 of the averaged restoring force h = H - A.

    Equation from (31). Domain: A >= 0. Error / u (1 + kappa): measured 2.5.
    """
    return averaged(A, alpha, beta, gamma, u_cr)[2]


def h_AAA(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """d3/dA3 of the averaged restoring force h = H - A.

    Equation from (31). Domain: A >= 0. Error / u (1 + kappa): measured 0.83.
    """
    return averaged(A, alpha, beta, gamma, u_cr)[3]


def H(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """The averaged force H beside the vertical spring.

    Equation (20)-(22). Domain: A >= 0. Error / u (1 + kappa): measured 1.9.
    """
    return averaged_H(A, alpha, beta, gamma, u_cr)[0]


def H_A(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """d/dA of the averaged force H beside the vertical spring.

    Equation (31). Domain: A >= 0. Error / u (1 + kappa): measured 2.9.
    """
    return averaged_H(A, alpha, beta, gamma, u_cr)[1]


def H_AA(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """d2/dA2 of the averaged force H beside the vertical spring.

    Equation from (31). Domain: A >= 0. Error / u (1 + kappa): measured 1.8.
    """
    return averaged(A, alpha, beta, gamma, u_cr)[2]


def F(Omega: ArrayLike, A: ArrayLike, F_0: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """Frequency response; zero at a steady state.

    Equation (24). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 1.7.
    """
    average, _ = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.F(Omega, A, F_0, flow.friction(mu), zeta, average)


def F_A(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """dF/dA; positive where stable.

    Equation (24), (30). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 7.1.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.F_A(Omega, A, flow.friction(mu), zeta, average, average_A)


def level(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """The forcing F_0 for which (Omega, A) is a steady state.

    Equation (24). Domain: Omega >= 0, A > 0. Error / u (1 + kappa): measured 1.7.
    """
    average, _ = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.level(Omega, A, flow.friction(mu), zeta, average)


def phase(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """Phase phi of a steady state, from -pi to 0.

    Equation (25). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 1.5.
    """
    average, _ = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.phase(Omega, A, flow.friction(mu), zeta, average)


def jacobian(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.

    Equation (28). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 1.7.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.jacobian(Omega, A, flow.friction(mu), zeta, average, average_A)


def stability(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.

    Equation (30). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 3.9.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.stability(Omega, A, flow.friction(mu), zeta, average, average_A)


def transmissibility(Omega: ArrayLike, A: ArrayLike, F_0: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """Fundamental harmonic of the force on the base over F_0, at a steady state.

    Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0. Error / u (1 + kappa): measured 1.1.
    """
    average, _ = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.transmissibility(Omega, A, F_0, flow.friction(mu), zeta, average)


def backbone(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Any:
    """Frequency on the backbone.

    Equation (26). Domain: A > 0, h <= 0. Error / u (1 + kappa): measured 1.8.
    """
    average, _ = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.backbone(A, average)


def limit_envelope(Omega: ArrayLike, F_0: ArrayLike, mu: ArrayLike, zeta: ArrayLike) -> Any:
    """Largest amplitude that the forcing can hold at this frequency.

    Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. Error / u (1 + kappa): measured 0.58.
    """
    return flow.limit_envelope(Omega, F_0, flow.friction(mu), zeta)


def equivalent_damping(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike) -> Any:
    """Viscous damping ratio that dissipates as much as zeta and friction together.

    Equation (38). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 0.82.
    """
    return flow.equivalent_damping(Omega, A, flow.friction(mu), zeta)


def response_quartic(A: ArrayLike, F_0: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.

    Equation (24). Domain: A > 0. Error / u (1 + kappa): measured 1.8.
    """
    average, _ = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.response_quartic(A, F_0, flow.friction(mu), zeta, average)


def fold_quartic(A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.

    Equation (24), (30). Domain: A > 0. Error / u (1 + kappa): measured 8.8.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.fold_quartic(A, flow.friction(mu), zeta, average, average_A)


def peak_cubic(A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> tuple[Any, Any, Any]:
    """F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3.

    Equation (34). Domain: A > 0. Error / u (1 + kappa): measured 0.98.
    """
    average, _ = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.peak_cubic(A, flow.friction(mu), zeta, average)


def detachment(A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike, u_cr: ArrayLike) -> Floats:
    """Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.

    Equation (34). Domain: A > 0. Error / u (1 + kappa): measured 1.7. One array, coefficients by rising power along
    its first axis.
    """
    average, _ = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.detachment(A, flow.friction(mu), zeta, average)


if NATIVE is not None:
    globals().update(compiled(globals(), NATIVE.rod_spring()))
#: functions that no Python code calls, which are in C, with their arguments; see generated/c/rod_spring.h
FROM_C = {
    "saddle_node_onset": "m zeta alpha beta gamma u_cr",
    "saddle_nodes": "F_0 m zeta alpha beta gamma u_cr",
}
globals().update(from_c("rod_spring", FROM_C, stacked=["saddle_node_onset", "saddle_nodes"]))


def _load_untruncated():
    from slowflow_kernels import rod_spring_untruncated

    return rod_spring_untruncated.MECHANISM


def _load_balls():
    from slowflow_kernels import rod_spring_balls

    return rod_spring_balls


_PIECES = (
    Law(force_1, force_1_u, "rod_spring.force_1"),
    Law(force_2, force_2_u, "rod_spring.force_2"),
)
_DESIGN = (
    Parameter("lam", "number of horizontal springs", "1", above=0.0),
    Parameter("r", "stiffness k_h of one of them", "k_v", above=0.0),
    Parameter("delta_h", "their preload Delta_h; 0 is a linear oscillator", "L", least=0.0, below=1.0),
)
_PARAMETERS = (
    Parameter("alpha", "coefficient of u in the Taylor series of piece 1 of the force", "k_v"),
    Parameter("beta", "coefficient of u^3 in the Taylor series of piece 1 of the force", "k_v/L^2"),
    Parameter("gamma", "coefficient of u^5 in the Taylor series of piece 1 of the force", "k_v/L^4"),
    Parameter("u_cr", "|u| at which piece 1 of the force ends", "L"),
)
MECHANISM = Mechanism(
    name="rod_spring",
    title="Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr",
    design=_DESIGN,
    parameters=_PARAMETERS,
    coefficients=coefficients,
    pieces=_PIECES,
    breakpoints=breakpoints,
    jumps=jumps,
    hardening=hardening,
    averaged=averaged,
    intercept=intercept,
    harmonics=harmonics,
    harmonics_up_to=float("inf"),
    by_parameter=by_parameter,
    by_design=by_design,
    reach=1.0,
    reach_reason="the push-rod stands vertical",
    truncated=True,
    steps=steps,
    steps_by=steps_by,
    load_untruncated=_load_untruncated,
    load_balls=_load_balls,
    scales=(
        Scale("lam", 1.0, (0.0, 0.0, 0.0)),
        Scale("k_h", 1.0, (1.0, 0.0, 0.0)),
        Scale("Delta_h", 1.0, (0.0, 1.0, 0.0)),
    ),
)
