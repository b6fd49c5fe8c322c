"""Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr.

Written by `make derive`; never edit.
Input: derivations/mechanisms/rod_spring.py, sha256 76b1d63466e9529259acb51ca65a45e8a9acd6a1a923137e90a07d40549a4ff1
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless. Arguments broadcast; outputs have their common shape, NumPy scalars for scalars. Each
docstring gives equation number, domain and the operations after each pass.
FORCE: force and slope of each piece, for any kind of number that has arithmetic.
Regimes: passed_n where A exceeds n breakpoints, far_k where it exceeds k of them 5/4 times.
"""

# a formatter would spread each polynomial over a page
# fmt: off

import numpy as np

from slowflow_kernels import slow_flow as flow
from slowflow_support.backend import NATIVE, coefficients_of, in_tuple
from slowflow_support.broadcast import by_regime, floats, full, number_by_regime, stacked
from slowflow_support.record import Mechanism, Parameter, nothing

NAME = "rod_spring"
PARAMETERS = ("alpha", "beta", "gamma", "u_cr")
RATIOS = ("lam", "r", "delta_h")
REACH = 1.0
REACH_REASON = "the push-rod stands vertical"
HARMONICS_UP_TO = float("inf")

__all__ = [
    "FORCE",
    "F_A",
    "F_AA",
    "F_AAA",
    "HARMONICS_UP_TO",
    "H_A",
    "H_AA",
    "NAME",
    "PARAMETERS",
    "RATIOS",
    "REACH",
    "REACH_REASON",
    "F",
    "F_AOmega",
    "F_Omega",
    "H",
    "I",
    "R",
    "attached",
    "averaged",
    "averaged_2",
    "averaged_3",
    "backbone",
    "breakpoints",
    "coefficients",
    "equivalent_damping",
    "force",
    "force_1",
    "force_1_u",
    "force_2",
    "force_2_u",
    "h",
    "h_A",
    "h_AA",
    "h_AAA",
    "hardening",
    "harmonics",
    "jacobian",
    "jumps",
    "limit_envelope",
    "phase",
    "saddle_node_onset",
    "saddle_nodes",
    "stability",
    "transmissibility",
]


def _averaged_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 28 structured, 19 common subexpressions, 19 power chains
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
    # operations: 249 structured, 123 common subexpressions, 116 power chains
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
    # operations: 336 structured, 168 common subexpressions, 154 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    s = x / np.sqrt(2.0 * y + 2.0)
    s2 = s * s
    s4 = s2 * s2
    s3 = s * s2
    s6 = s3 * s3
    s7 = s * s6
    M6 = (
        s7 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.00021441317186122989 * s4 - 0.00038296467549092059)
        - 0.000746755888967803) - 0.0016416352370689656) - 0.0042968750000000003) - 0.01488095238095238) -
        0.088235294117647065) - 3.0769230769230771) - 35.555555555555557) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (-0.00016468815332235291 * s4 - 0.00028384801668998523) - 0.00052806309291294638) -
        0.0010878039944556453) - 0.0025860821759259261) - 0.007642663043478261) - 0.032894736842105261) -
        0.33333333333333331) + 21.818181818181817) + 18.285714285714285)
    )
    x2 = x * x
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    x3 = x * x2
    M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y
    S2_2 = -M2 + 0.78539816339744828
    A2 = A * A
    t1 = M4 * beta
    A4 = A2 * A2
    t2 = M6 * gamma
    t3 = A4 * t2
    t4 = M2 * alpha + S2_2
    t5 = 3.0 * beta
    t6 = 1.0 / A2
    t7 = 1.0 / root
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    t8 = gamma * u_cr2
    t9 = alpha - 1.0
    t10 = t9 + u_cr2 * (beta + t8)
    t11 = 6.0 * t1
    A3 = A * A2
    root2 = root * root
    root3 = root * root2
    t12 = u_cr3 / root3
    t13 = t10 * t12
    t14 = t7 * u_cr3
    t15 = t14 / A3
    t16 = -t9 - u_cr2 * (t5 + 5.0 * t8)
    t17 = 1.0 / A4
    t18 = t14 * t17
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    return (
        -1.2732395447351628 * A * (A2 * t1 + t3 + t4),
        1.2732395447351628 * (-A2 * M4 * t5 + t10 * t6 * t7 * u_cr3 - 5.0 * t3 - t4),
        -1.2732395447351628 * (A * t11 + 20.0 * A3 * t2 + t0 * t13 + 2.0 * t10 * t15 + t15 * t16),
        1.2732395447351628 * (-60.0 * A2 * t2 + t10 * t12 * t6 + 6.0 * t10 * t18 - t11 + t12 * t16 * t6 + t13 * (2.0
        * t6 + 3.0 / root2) + 3.0 * t16 * t18 + 2.0 * t17 * t7 * u_cr5 * (t5 + 10.0 * t8)),
    )


def averaged(A, alpha, beta, gamma, u_cr):
    """h, h_A, h_AA, h_AAA together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = (A <= u_cr, A <= 1.25 * u_cr,)
    bodies = (_averaged_passed_0, _averaged_passed_1, _averaged_passed_1_far_1)
    return by_regime(guards, bodies, arguments, 4)


def _averaged_3_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 23 structured, 17 common subexpressions, 17 power chains
    t0 = -alpha
    t1 = A * A
    t2 = gamma * t1
    return (
        A * (t0 + t1 * (-0.75 * beta - 0.625 * t2)),
        t0 + t1 * (-2.25 * beta - 3.125 * t2),
        A * (-4.5 * beta - 12.5 * t2),
    )


def _averaged_3_passed_1(A, alpha, beta, gamma, u_cr):
    # operations: 134 structured, 89 common subexpressions, 85 power chains
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
    t4 = A2 * M4
    t5 = M6 * gamma
    A4 = A2 * A2
    t6 = A4 * t5
    t7 = M2 * alpha + S2_2
    t8 = 3.0 * beta
    t9 = 1.0 / root
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    t10 = gamma * u_cr2
    t11 = alpha - 1.0
    t12 = t11 + u_cr2 * (beta + t10)
    A3 = A * A2
    t13 = 1.0 / A3
    t14 = t9 * u_cr3
    root2 = root * root
    root3 = root * root2
    return (
        -1.2732395447351628 * A * (beta * t4 + t6 + t7),
        1.2732395447351628 * (-t4 * t8 - 5.0 * t6 - t7 + t12 * t9 * u_cr3 / A2),
        -1.2732395447351628 * (6.0 * A * M4 * beta + 20.0 * A3 * t5 + 2.0 * t12 * t13 * t14 + t13 * t14 * (-t11 -
        u_cr2 * (5.0 * t10 + t8)) + t0 * t12 * u_cr3 / root3),
    )


def _averaged_3_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    # operations: 221 structured, 134 common subexpressions, 123 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    s = x / np.sqrt(2.0 * y + 2.0)
    s2 = s * s
    s4 = s2 * s2
    s3 = s * s2
    s6 = s3 * s3
    s7 = s * s6
    M6 = (
        s7 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.00021441317186122989 * s4 - 0.00038296467549092059)
        - 0.000746755888967803) - 0.0016416352370689656) - 0.0042968750000000003) - 0.01488095238095238) -
        0.088235294117647065) - 3.0769230769230771) - 35.555555555555557) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (-0.00016468815332235291 * s4 - 0.00028384801668998523) - 0.00052806309291294638) -
        0.0010878039944556453) - 0.0025860821759259261) - 0.007642663043478261) - 0.032894736842105261) -
        0.33333333333333331) + 21.818181818181817) + 18.285714285714285)
    )
    x2 = x * x
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    x3 = x * x2
    M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y
    S2_2 = -M2 + 0.78539816339744828
    A2 = A * A
    t1 = A2 * M4
    t2 = M6 * gamma
    A4 = A2 * A2
    t3 = A4 * t2
    t4 = M2 * alpha + S2_2
    t5 = 3.0 * beta
    t6 = 1.0 / root
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    t7 = gamma * u_cr2
    t8 = alpha - 1.0
    t9 = t8 + u_cr2 * (beta + t7)
    A3 = A * A2
    t10 = 1.0 / A3
    t11 = t6 * u_cr3
    root2 = root * root
    root3 = root * root2
    return (
        -1.2732395447351628 * A * (beta * t1 + t3 + t4),
        1.2732395447351628 * (-t1 * t5 - 5.0 * t3 - t4 + t6 * t9 * u_cr3 / A2),
        -1.2732395447351628 * (6.0 * A * M4 * beta + 20.0 * A3 * t2 + 2.0 * t10 * t11 * t9 + t10 * t11 * (-t8 -
        u_cr2 * (t5 + 5.0 * t7)) + t0 * t9 * u_cr3 / root3),
    )


def averaged_3(A, alpha, beta, gamma, u_cr):
    """h, h_A, h_AA together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = (A <= u_cr, A <= 1.25 * u_cr,)
    bodies = (_averaged_3_passed_0, _averaged_3_passed_1, _averaged_3_passed_1_far_1)
    return by_regime(guards, bodies, arguments, 3)


def _averaged_2_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 17 structured, 13 common subexpressions, 13 power chains
    t0 = -alpha
    t1 = A * A
    t2 = gamma * t1
    return (
        A * (t0 + t1 * (-0.75 * beta - 0.625 * t2)),
        t0 + t1 * (-2.25 * beta - 3.125 * t2),
    )


def _averaged_2_passed_1(A, alpha, beta, gamma, u_cr):
    # operations: 76 structured, 59 common subexpressions, 56 power chains
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
    # operations: 163 structured, 104 common subexpressions, 94 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    s = x / np.sqrt(2.0 * y + 2.0)
    s2 = s * s
    s4 = s2 * s2
    s3 = s * s2
    s6 = s3 * s3
    s7 = s * s6
    M6 = (
        s7 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.00021441317186122989 * s4 - 0.00038296467549092059)
        - 0.000746755888967803) - 0.0016416352370689656) - 0.0042968750000000003) - 0.01488095238095238) -
        0.088235294117647065) - 3.0769230769230771) - 35.555555555555557) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (-0.00016468815332235291 * s4 - 0.00028384801668998523) - 0.00052806309291294638) -
        0.0010878039944556453) - 0.0025860821759259261) - 0.007642663043478261) - 0.032894736842105261) -
        0.33333333333333331) + 21.818181818181817) + 18.285714285714285)
    )
    x2 = x * x
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    x3 = x * x2
    M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y
    S2_2 = -M2 + 0.78539816339744828
    A2 = A * A
    t1 = A2 * M4 * beta
    A4 = A2 * A2
    t2 = A4 * M6 * gamma
    t3 = M2 * alpha + S2_2
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    return (
        -1.2732395447351628 * A * (t1 + t2 + t3),
        1.2732395447351628 * (-3.0 * t1 - 5.0 * t2 - t3 + u_cr3 * (alpha + u_cr2 * (beta + gamma * u_cr2) - 1.0) /
        (A2 * root)),
    )


def averaged_2(A, alpha, beta, gamma, u_cr):
    """h, h_A together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = (A <= u_cr, A <= 1.25 * u_cr,)
    bodies = (_averaged_2_passed_0, _averaged_2_passed_1, _averaged_2_passed_1_far_1)
    return by_regime(guards, bodies, arguments, 2)


def attached(A, alpha, beta, gamma, u_cr):
    """The first piece alone: h, h_A, h_AA, h_AAA together.

    Equation (20), (21). Domain: 0 <= A <= u_cr.
    Operations: 28 structured, 19 common subexpressions, 19 power chains.
    """
    A, alpha, beta, gamma, u_cr = floats(A, alpha, beta, gamma, u_cr)
    t0 = -alpha
    t1 = A * A
    t2 = gamma * t1
    t3 = 4.5 * beta
    arguments = (A, alpha, beta, gamma, u_cr)
    return (
        full(A * (t0 + t1 * (-0.75 * beta - 0.625 * t2)), arguments),
        full(t0 + t1 * (-2.25 * beta - 3.125 * t2), arguments),
        full(A * (-12.5 * t2 - t3), arguments),
        full(-37.5 * t2 - t3, arguments),
    )


def _h_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 9 structured, 8 common subexpressions, 8 power chains
    t0 = A * A
    return A * (-alpha + t0 * (-0.75 * beta - 0.625 * gamma * t0))


def _h_passed_1(A, alpha, beta, gamma, u_cr):
    # operations: 47 structured, 42 common subexpressions, 40 power chains
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
    A4 = A2 * A2
    return -1.2732395447351628 * A * (A2 * M4 * beta + A4 * M6 * gamma + M2 * alpha + S2_2)


def _h_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    # operations: 134 structured, 87 common subexpressions, 78 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    s = x / np.sqrt(2.0 * y + 2.0)
    s2 = s * s
    s4 = s2 * s2
    s3 = s * s2
    s6 = s3 * s3
    s7 = s * s6
    M6 = (
        s7 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.00021441317186122989 * s4 - 0.00038296467549092059)
        - 0.000746755888967803) - 0.0016416352370689656) - 0.0042968750000000003) - 0.01488095238095238) -
        0.088235294117647065) - 3.0769230769230771) - 35.555555555555557) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (-0.00016468815332235291 * s4 - 0.00028384801668998523) - 0.00052806309291294638) -
        0.0010878039944556453) - 0.0025860821759259261) - 0.007642663043478261) - 0.032894736842105261) -
        0.33333333333333331) + 21.818181818181817) + 18.285714285714285)
    )
    x2 = x * x
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    x3 = x * x2
    M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y
    S2_2 = -M2 + 0.78539816339744828
    A2 = A * A
    A4 = A2 * A2
    return -1.2732395447351628 * A * (A2 * M4 * beta + A4 * M6 * gamma + M2 * alpha + S2_2)


def h(A, alpha, beta, gamma, u_cr):
    """The averaged restoring force h = H - A.

    Equation (20)-(22). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = (A <= u_cr, A <= 1.25 * u_cr,)
    bodies = (_h_passed_0, _h_passed_1, _h_passed_1_far_1)
    return number_by_regime(guards, bodies, arguments)


def _h_A_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 8 structured, 7 common subexpressions, 7 power chains
    t0 = A * A
    return -alpha + t0 * (-2.25 * beta - 3.125 * gamma * t0)


def _h_A_passed_1(A, alpha, beta, gamma, u_cr):
    # operations: 62 structured, 55 common subexpressions, 52 power chains
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
    u_cr2 = u_cr * u_cr
    A4 = A2 * A2
    u_cr3 = u_cr * u_cr2
    return 1.2732395447351628 * (-3.0 * A2 * M4 * beta - 5.0 * A4 * M6 * gamma - M2 * alpha - S2_2 + u_cr3 * (alpha
        + u_cr2 * (beta + gamma * u_cr2) - 1.0) / (A2 * root))


def _h_A_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    # operations: 149 structured, 100 common subexpressions, 90 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    s = x / np.sqrt(2.0 * y + 2.0)
    s2 = s * s
    s4 = s2 * s2
    s3 = s * s2
    s6 = s3 * s3
    s7 = s * s6
    M6 = (
        s7 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.00021441317186122989 * s4 - 0.00038296467549092059)
        - 0.000746755888967803) - 0.0016416352370689656) - 0.0042968750000000003) - 0.01488095238095238) -
        0.088235294117647065) - 3.0769230769230771) - 35.555555555555557) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (-0.00016468815332235291 * s4 - 0.00028384801668998523) - 0.00052806309291294638) -
        0.0010878039944556453) - 0.0025860821759259261) - 0.007642663043478261) - 0.032894736842105261) -
        0.33333333333333331) + 21.818181818181817) + 18.285714285714285)
    )
    x2 = x * x
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    x3 = x * x2
    M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y
    S2_2 = -M2 + 0.78539816339744828
    A2 = A * A
    u_cr2 = u_cr * u_cr
    A4 = A2 * A2
    u_cr3 = u_cr * u_cr2
    return 1.2732395447351628 * (-3.0 * A2 * M4 * beta - 5.0 * A4 * M6 * gamma - M2 * alpha - S2_2 + u_cr3 * (alpha
        + u_cr2 * (beta + gamma * u_cr2) - 1.0) / (A2 * root))


def h_A(A, alpha, beta, gamma, u_cr):
    """d/dA of the averaged restoring force h = H - A.

    Equation (31). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = (A <= u_cr, A <= 1.25 * u_cr,)
    bodies = (_h_A_passed_0, _h_A_passed_1, _h_A_passed_1_far_1)
    return number_by_regime(guards, bodies, arguments)


def _h_AA_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 6 structured, 6 common subexpressions, 6 power chains
    return A * (-12.5 * A * A * gamma - 4.5 * beta)


def _h_AA_passed_1(A, alpha, beta, gamma, u_cr):
    # operations: 82 structured, 58 common subexpressions, 57 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    theta = np.arctan2(u_cr, root)
    t1 = x * x
    t2 = x * y
    M4 = -t2 * (0.25 * t1 + 0.375) + 0.375 * theta
    M6 = -t2 * (t1 * (0.16666666666666666 * t1 + 0.20833333333333334) + 0.3125) + 0.3125 * theta
    A2 = A * A
    A3 = A * A2
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    t3 = gamma * u_cr2
    t4 = alpha - 1.0
    t5 = t4 + u_cr2 * (beta + t3)
    t6 = u_cr3 / (A3 * root)
    root2 = root * root
    root3 = root * root2
    return -1.2732395447351628 * (6.0 * A * M4 * beta + 20.0 * A3 * M6 * gamma + 2.0 * t5 * t6 + t6 * (-t4 - u_cr2 *
        (3.0 * beta + 5.0 * t3)) + t0 * t5 * u_cr3 / root3)


def _h_AA_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    # operations: 171 structured, 102 common subexpressions, 95 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    s = x / np.sqrt(2.0 * y + 2.0)
    s2 = s * s
    s4 = s2 * s2
    s3 = s * s2
    s6 = s3 * s3
    s7 = s * s6
    M6 = (
        s7 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.00021441317186122989 * s4 - 0.00038296467549092059)
        - 0.000746755888967803) - 0.0016416352370689656) - 0.0042968750000000003) - 0.01488095238095238) -
        0.088235294117647065) - 3.0769230769230771) - 35.555555555555557) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (-0.00016468815332235291 * s4 - 0.00028384801668998523) - 0.00052806309291294638) -
        0.0010878039944556453) - 0.0025860821759259261) - 0.007642663043478261) - 0.032894736842105261) -
        0.33333333333333331) + 21.818181818181817) + 18.285714285714285)
    )
    x2 = x * x
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    A2 = A * A
    A3 = A * A2
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    t1 = gamma * u_cr2
    t2 = alpha - 1.0
    t3 = t2 + u_cr2 * (beta + t1)
    t4 = u_cr3 / (A3 * root)
    root2 = root * root
    root3 = root * root2
    return -1.2732395447351628 * (6.0 * A * M4 * beta + 20.0 * A3 * M6 * gamma + 2.0 * t3 * t4 + t4 * (-t2 - u_cr2 *
        (3.0 * beta + 5.0 * t1)) + t0 * t3 * u_cr3 / root3)


def h_AA(A, alpha, beta, gamma, u_cr):
    """d2/dA2 of the averaged restoring force h = H - A.

    Equation from (31). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = (A <= u_cr, A <= 1.25 * u_cr,)
    bodies = (_h_AA_passed_0, _h_AA_passed_1, _h_AA_passed_1_far_1)
    return number_by_regime(guards, bodies, arguments)


def _h_AAA_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 5 structured, 5 common subexpressions, 5 power chains
    return -37.5 * A * A * gamma - 4.5 * beta


def _h_AAA_passed_1(A, alpha, beta, gamma, u_cr):
    # operations: 139 structured, 80 common subexpressions, 74 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    theta = np.arctan2(u_cr, root)
    t1 = x * x
    t2 = x * y
    M4 = -t2 * (0.25 * t1 + 0.375) + 0.375 * theta
    M6 = -t2 * (t1 * (0.16666666666666666 * t1 + 0.20833333333333334) + 0.3125) + 0.3125 * theta
    A2 = A * A
    t3 = 3.0 * beta
    u_cr2 = u_cr * u_cr
    t4 = gamma * u_cr2
    A4 = A2 * A2
    t5 = 1.0 / (A4 * root)
    t6 = alpha - 1.0
    t7 = t6 + u_cr2 * (beta + t4)
    t8 = 1.0 / A2
    u_cr3 = u_cr * u_cr2
    root2 = root * root
    root3 = root * root2
    t9 = u_cr3 / root3
    t10 = t8 * t9
    t11 = t5 * u_cr3
    t12 = -t6 - u_cr2 * (t3 + 5.0 * t4)
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    return 1.2732395447351628 * (-60.0 * A2 * M6 * gamma - 6.0 * M4 * beta + t10 * t12 + t10 * t7 + 3.0 * t11 * t12
        + 6.0 * t11 * t7 + 2.0 * t5 * u_cr5 * (t3 + 10.0 * t4) + t7 * t9 * (2.0 * t8 + 3.0 / root2))


def _h_AAA_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    # operations: 228 structured, 124 common subexpressions, 112 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    s = x / np.sqrt(2.0 * y + 2.0)
    s2 = s * s
    s4 = s2 * s2
    s3 = s * s2
    s6 = s3 * s3
    s7 = s * s6
    M6 = (
        s7 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.00021441317186122989 * s4 - 0.00038296467549092059)
        - 0.000746755888967803) - 0.0016416352370689656) - 0.0042968750000000003) - 0.01488095238095238) -
        0.088235294117647065) - 3.0769230769230771) - 35.555555555555557) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (-0.00016468815332235291 * s4 - 0.00028384801668998523) - 0.00052806309291294638) -
        0.0010878039944556453) - 0.0025860821759259261) - 0.007642663043478261) - 0.032894736842105261) -
        0.33333333333333331) + 21.818181818181817) + 18.285714285714285)
    )
    x2 = x * x
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    A2 = A * A
    t1 = 3.0 * beta
    u_cr2 = u_cr * u_cr
    t2 = gamma * u_cr2
    A4 = A2 * A2
    t3 = 1.0 / (A4 * root)
    t4 = alpha - 1.0
    t5 = t4 + u_cr2 * (beta + t2)
    t6 = 1.0 / A2
    u_cr3 = u_cr * u_cr2
    root2 = root * root
    root3 = root * root2
    t7 = u_cr3 / root3
    t8 = t6 * t7
    t9 = t3 * u_cr3
    t10 = -t4 - u_cr2 * (t1 + 5.0 * t2)
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    return 1.2732395447351628 * (-60.0 * A2 * M6 * gamma - 6.0 * M4 * beta + t10 * t8 + 3.0 * t10 * t9 + 2.0 * t3 *
        u_cr5 * (t1 + 10.0 * t2) + t5 * t7 * (2.0 * t6 + 3.0 / root2) + t5 * t8 + 6.0 * t5 * t9)


def h_AAA(A, alpha, beta, gamma, u_cr):
    """d3/dA3 of the averaged restoring force h = H - A.

    Equation from (31). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = (A <= u_cr, A <= 1.25 * u_cr,)
    bodies = (_h_AAA_passed_0, _h_AAA_passed_1, _h_AAA_passed_1_far_1)
    return number_by_regime(guards, bodies, arguments)


def _H_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 10 structured, 9 common subexpressions, 9 power chains
    t0 = A * A
    return A * (-alpha + t0 * (-0.75 * beta - 0.625 * gamma * t0) + 1.0)


def _H_passed_1(A, alpha, beta, gamma, u_cr):
    # operations: 42 structured, 39 common subexpressions, 37 power chains
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
    A4 = A2 * A2
    return -1.2732395447351628 * A * (A2 * M4 * beta + A4 * M6 * gamma + M2 * (alpha - 1.0))


def _H_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    # operations: 133 structured, 86 common subexpressions, 77 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    s = x / np.sqrt(2.0 * y + 2.0)
    s2 = s * s
    s4 = s2 * s2
    s3 = s * s2
    s6 = s3 * s3
    s7 = s * s6
    M6 = (
        s7 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.00021441317186122989 * s4 - 0.00038296467549092059)
        - 0.000746755888967803) - 0.0016416352370689656) - 0.0042968750000000003) - 0.01488095238095238) -
        0.088235294117647065) - 3.0769230769230771) - 35.555555555555557) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (-0.00016468815332235291 * s4 - 0.00028384801668998523) - 0.00052806309291294638) -
        0.0010878039944556453) - 0.0025860821759259261) - 0.007642663043478261) - 0.032894736842105261) -
        0.33333333333333331) + 21.818181818181817) + 18.285714285714285)
    )
    x2 = x * x
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    x3 = x * x2
    M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y
    A2 = A * A
    A4 = A2 * A2
    return -1.2732395447351628 * A * (A2 * M4 * beta + A4 * M6 * gamma + M2 * (alpha - 1.0))


def H(A, alpha, beta, gamma, u_cr):
    """The averaged force H beside the vertical spring.

    Equation (20)-(22). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = (A <= u_cr, A <= 1.25 * u_cr,)
    bodies = (_H_passed_0, _H_passed_1, _H_passed_1_far_1)
    return number_by_regime(guards, bodies, arguments)


def _H_A_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 9 structured, 8 common subexpressions, 8 power chains
    t0 = A * A
    return -alpha + t0 * (-2.25 * beta - 3.125 * gamma * t0) + 1.0


def _H_A_passed_1(A, alpha, beta, gamma, u_cr):
    # operations: 57 structured, 51 common subexpressions, 48 power chains
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
    A2 = A * A
    u_cr2 = u_cr * u_cr
    A4 = A2 * A2
    u_cr3 = u_cr * u_cr2
    return 1.2732395447351628 * (-3.0 * A2 * M4 * beta - 5.0 * A4 * M6 * gamma - M2 * t3 + u_cr3 * (t3 + u_cr2 *
        (beta + gamma * u_cr2)) / (A2 * root))


def _H_A_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    # operations: 148 structured, 98 common subexpressions, 88 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    s = x / np.sqrt(2.0 * y + 2.0)
    s2 = s * s
    s4 = s2 * s2
    s3 = s * s2
    s6 = s3 * s3
    s7 = s * s6
    M6 = (
        s7 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.00021441317186122989 * s4 - 0.00038296467549092059)
        - 0.000746755888967803) - 0.0016416352370689656) - 0.0042968750000000003) - 0.01488095238095238) -
        0.088235294117647065) - 3.0769230769230771) - 35.555555555555557) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (-0.00016468815332235291 * s4 - 0.00028384801668998523) - 0.00052806309291294638) -
        0.0010878039944556453) - 0.0025860821759259261) - 0.007642663043478261) - 0.032894736842105261) -
        0.33333333333333331) + 21.818181818181817) + 18.285714285714285)
    )
    x2 = x * x
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    x3 = x * x2
    M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y
    t1 = alpha - 1.0
    A2 = A * A
    u_cr2 = u_cr * u_cr
    A4 = A2 * A2
    u_cr3 = u_cr * u_cr2
    return 1.2732395447351628 * (-3.0 * A2 * M4 * beta - 5.0 * A4 * M6 * gamma - M2 * t1 + u_cr3 * (t1 + u_cr2 *
        (beta + gamma * u_cr2)) / (A2 * root))


def H_A(A, alpha, beta, gamma, u_cr):
    """d/dA of the averaged force H beside the vertical spring.

    Equation (31). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = (A <= u_cr, A <= 1.25 * u_cr,)
    bodies = (_H_A_passed_0, _H_A_passed_1, _H_A_passed_1_far_1)
    return number_by_regime(guards, bodies, arguments)


def _H_AA_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 6 structured, 6 common subexpressions, 6 power chains
    return A * (-12.5 * A * A * gamma - 4.5 * beta)


def _H_AA_passed_1(A, alpha, beta, gamma, u_cr):
    # operations: 82 structured, 58 common subexpressions, 57 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    theta = np.arctan2(u_cr, root)
    t1 = x * x
    t2 = x * y
    M4 = -t2 * (0.25 * t1 + 0.375) + 0.375 * theta
    M6 = -t2 * (t1 * (0.16666666666666666 * t1 + 0.20833333333333334) + 0.3125) + 0.3125 * theta
    A2 = A * A
    A3 = A * A2
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    t3 = gamma * u_cr2
    t4 = alpha - 1.0
    t5 = t4 + u_cr2 * (beta + t3)
    t6 = u_cr3 / (A3 * root)
    root2 = root * root
    root3 = root * root2
    return -1.2732395447351628 * (6.0 * A * M4 * beta + 20.0 * A3 * M6 * gamma + 2.0 * t5 * t6 + t6 * (-t4 - u_cr2 *
        (3.0 * beta + 5.0 * t3)) + t0 * t5 * u_cr3 / root3)


def _H_AA_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    # operations: 171 structured, 102 common subexpressions, 95 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    s = x / np.sqrt(2.0 * y + 2.0)
    s2 = s * s
    s4 = s2 * s2
    s3 = s * s2
    s6 = s3 * s3
    s7 = s * s6
    M6 = (
        s7 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.00021441317186122989 * s4 - 0.00038296467549092059)
        - 0.000746755888967803) - 0.0016416352370689656) - 0.0042968750000000003) - 0.01488095238095238) -
        0.088235294117647065) - 3.0769230769230771) - 35.555555555555557) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (-0.00016468815332235291 * s4 - 0.00028384801668998523) - 0.00052806309291294638) -
        0.0010878039944556453) - 0.0025860821759259261) - 0.007642663043478261) - 0.032894736842105261) -
        0.33333333333333331) + 21.818181818181817) + 18.285714285714285)
    )
    x2 = x * x
    x4 = x2 * x2
    x5 = x * x4
    M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y
    A2 = A * A
    A3 = A * A2
    u_cr2 = u_cr * u_cr
    u_cr3 = u_cr * u_cr2
    t1 = gamma * u_cr2
    t2 = alpha - 1.0
    t3 = t2 + u_cr2 * (beta + t1)
    t4 = u_cr3 / (A3 * root)
    root2 = root * root
    root3 = root * root2
    return -1.2732395447351628 * (6.0 * A * M4 * beta + 20.0 * A3 * M6 * gamma + 2.0 * t3 * t4 + t4 * (-t2 - u_cr2 *
        (3.0 * beta + 5.0 * t1)) + t0 * t3 * u_cr3 / root3)


def H_AA(A, alpha, beta, gamma, u_cr):
    """d2/dA2 of the averaged force H beside the vertical spring.

    Equation from (31). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = (A <= u_cr, A <= 1.25 * u_cr,)
    bodies = (_H_AA_passed_0, _H_AA_passed_1, _H_AA_passed_1_far_1)
    return number_by_regime(guards, bodies, arguments)


def _harmonics_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 44 structured, 32 common subexpressions, 26 power chains
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
    # operations: 975 structured, 291 common subexpressions, 278 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    theta = np.arctan2(u_cr, root)
    x2 = x * x
    x3 = x * x2
    t1 = x3 * y
    W3_1 = -t1
    t2 = x * y
    W3_3 = -t2 * (x2 * (0.66666666666666663 * x2 + 0.083333333333333329) + 0.125) + 0.125 * theta
    W3_5 = (
        -t2 * (x2 * (x2 * (0.5 * x2 + 0.083333333333333329) + 0.10416666666666667) + 0.15625) + 0.15625 * theta
    )
    W5_1 = -t1 * (2.6666666666666665 * x2 - 1.6666666666666667)
    x4 = x2 * x2
    x5 = x * x4
    W5_3 = -x5 * y * (2.0 * x2 - 1.0)
    W5_5 = (
        -t2 * (x2 * (x2 * (x2 * (1.6000000000000001 * x2 - 0.69999999999999996) + 0.016666666666666666) +
        0.020833333333333332) + 0.03125) + 0.03125 * theta
    )
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


def _harmonics_passed_1_far_1(A, alpha, beta, gamma, u_cr):
    # operations: 1074 structured, 351 common subexpressions, 319 power chains
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
        s11 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.00029172897338867185 * s4 -
        0.00072125690739329265) - 0.0020784945101351353) - 0.007457386363636364) - 0.037715517241379309) -
        0.35999999999999999) - 24.0) - 790.58823529411768) - 708.92307692307691) + s4 * (s4 * (s4 * (s4 * (s4 * (s4
        * (s4 * (-0.00045130973638490189 * s4 - 0.0011972280649038462) - 0.0038085937499999999) -
        0.015877016129032258) - 0.10416666666666667) - 1.826086956521739) + 265.26315789473682) + 1075.2) +
        186.18181818181819)
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
    t2 = x3 * y
    W3_1 = -t2
    W3_3 = -3.0 * M4 + 4.0 * M6
    W3_5 = -3.0 * M6 + 4.0 * M8
    W5_1 = -t2 * (2.6666666666666665 * x2 - 1.6666666666666667)
    W5_3 = -t1 * (2.0 * x2 - 1.0)
    W5_5 = 16.0 * M10 + 5.0 * M6 - 20.0 * M8
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


def harmonics(A, alpha, beta, gamma, u_cr):
    """Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA.

    Equation beyond (20). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = (A <= u_cr, A <= 1.25 * u_cr,)
    bodies = (_harmonics_passed_0, _harmonics_passed_1, _harmonics_passed_1_far_1)
    return by_regime(guards, bodies, arguments, 8)


def coefficients(lam, r, delta_h):
    """The parameters alpha, beta, gamma, u_cr from the design.

    Equation (5), (7). Domain: any design.
    Operations: 15 structured, 11 common subexpressions, 11 power chains.
    """
    lam, r, delta_h = floats(lam, r, delta_h)
    t0 = lam * r
    t1 = t0 * (delta_h - 1.0)
    arguments = (lam, r, delta_h)
    return (
        -delta_h * t0 + 1.0,
        -0.5 * t1,
        -0.375 * t1,
        full(np.sqrt(delta_h) * np.sqrt(2.0 - delta_h), arguments),
    )


def breakpoints(alpha, beta, gamma, u_cr):
    """The |u| at which a piece of the force ends.

    Equation (5). Domain: any parameters.
    Operations: 0 structured, 0 common subexpressions, 0 power chains.
    """
    alpha, beta, gamma, u_cr = floats(alpha, beta, gamma, u_cr)
    arguments = (alpha, beta, gamma, u_cr)
    return (
        full(u_cr, arguments),
    )


def jumps(alpha, beta, gamma, u_cr):
    """What the force loses at each breakpoint: f below less f above.

    Equation (6). Domain: any parameters.
    Operations: 8 structured, 7 common subexpressions, 7 power chains.
    """
    alpha, beta, gamma, u_cr = floats(alpha, beta, gamma, u_cr)
    t0 = u_cr * u_cr
    return (
        u_cr * (alpha + t0 * (beta + gamma * t0) - 1.0),
    )


def hardening(alpha, beta, gamma, u_cr):
    """The force over the displacement, f(u)/u, rises with |u| where none of these is negative.

    Equation from (3). Domain: any parameters.
    Operations: 8 structured, 7 common subexpressions, 7 power chains.
    """
    alpha, beta, gamma, u_cr = floats(alpha, beta, gamma, u_cr)
    t0 = u_cr * u_cr
    arguments = (alpha, beta, gamma, u_cr)
    return (
        full(beta, arguments),
        full(gamma, arguments),
        -u_cr * (alpha + t0 * (beta + gamma * t0) - 1.0),
    )


def _force_piece_1(u, alpha, beta, gamma, u_cr):
    # operations: 7 structured, 6 common subexpressions, 6 power chains
    t0 = u * u
    return u * (alpha + t0 * (beta + gamma * t0))


def _force_piece_2(u, alpha, beta, gamma, u_cr):
    # operations: 0 structured, 0 common subexpressions, 0 power chains
    return u


def force(u, alpha, beta, gamma, u_cr):
    """Whole dimensionless restoring force u + F_k(u), truncated.

    Equation (3), (6). Domain: any u.
    """
    arguments = floats(u, alpha, beta, gamma, u_cr)
    u, alpha, beta, gamma, u_cr = arguments
    guards = (np.abs(u) <= u_cr,)
    bodies = (_force_piece_1, _force_piece_2)
    return number_by_regime(guards, bodies, arguments)


def force_1(u, alpha, beta, gamma, u_cr):
    """Piece 1 of the whole restoring force u + F_k(u).

    Equation (3), (6). Domain: where it holds.
    Operations: 7 structured, 6 common subexpressions, 6 power chains.
    """
    t0 = u * u
    return u * (alpha + t0 * (beta + gamma * t0))


def force_1_u(u, alpha, beta, gamma, u_cr):
    """d/du of piece 1 of the whole restoring force u + F_k(u).

    Equation (3), (6). Domain: where it holds.
    Operations: 8 structured, 7 common subexpressions, 7 power chains.
    """
    t0 = u * u
    return alpha + t0 * (3.0 * beta + 5.0 * gamma * t0)


def force_2(u, alpha, beta, gamma, u_cr):
    """Piece 2 of the whole restoring force u + F_k(u).

    Equation (3), (6). Domain: where it holds.
    Operations: 0 structured, 0 common subexpressions, 0 power chains.
    """
    return u


def force_2_u(u, alpha, beta, gamma, u_cr):
    """d/du of piece 2 of the whole restoring force u + F_k(u).

    Equation (3), (6). Domain: where it holds.
    Operations: 0 structured, 0 common subexpressions, 0 power chains.
    """
    return 1.0


def saddle_node_onset(m, zeta, alpha, beta, gamma, u_cr):
    """Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset.

    Equation (33). Domain: roots with 0 < A <= u_cr.
    Operations: 718 structured, 299 common subexpressions, 253 power chains.
    """
    m, zeta, alpha, beta, gamma, u_cr = floats(m, zeta, alpha, beta, gamma, u_cr)
    t0 = alpha * alpha
    zeta2 = zeta * zeta
    zeta4 = zeta2 * zeta2
    m2 = m * m
    m4 = m2 * m2
    t1 = m4 * zeta4
    t2 = alpha * t1
    beta2 = beta * beta
    t3 = beta * gamma
    t4 = m2 * zeta4
    t5 = t0 * t4
    gamma2 = gamma * gamma
    beta3 = beta * beta2
    t6 = beta3 * zeta4
    t7 = alpha * m2
    beta4 = beta2 * beta2
    t8 = beta4 * zeta4
    t9 = beta4 * zeta2
    t10 = alpha * gamma
    beta5 = beta * beta4
    t11 = beta5 * zeta2
    t12 = gamma * m2
    t13 = alpha * gamma2
    t14 = beta3 * zeta2
    t15 = beta5 * zeta4
    gamma3 = gamma * gamma2
    t16 = gamma3 * t4
    t17 = beta2 * gamma2
    t18 = t7 * zeta2
    beta6 = beta3 * beta3
    t19 = beta6 * zeta2
    t20 = beta * gamma3
    t21 = t0 * zeta4
    beta7 = beta * beta6
    gamma4 = gamma2 * gamma2
    t22 = gamma4 * zeta4
    t23 = gamma4 * zeta2
    t24 = m2 * zeta2
    t25 = beta2 * gamma3
    gamma5 = gamma * gamma4
    t26 = gamma5 * zeta2
    gamma6 = gamma3 * gamma3
    t27 = gamma6 * zeta2
    gamma7 = gamma * gamma6
    beta8 = beta4 * beta4
    gamma8 = gamma4 * gamma4
    return stacked(
        (
            4096.0 * t0 * t1,
            36864.0 * beta * t2,
            34560.0 * beta2 * t1 + 76800.0 * gamma * t2,
            294912.0 * beta2 * t5 + 107520.0 * t1 * t3,
            72000.0 * gamma2 * t1 + 1474560.0 * t3 * t5 + 1658880.0 * t6 * t7,
            11335680.0 * beta2 * t10 * t4 + 1843200.0 * gamma2 * t5 + 1430784.0 * m2 * t8 - 1710720.0 * t7 * t9,
            25651200.0 * beta * t13 * t4 - 17038080.0 * gamma * t14 * t7 - 1819584.0 * m2 * t11 + 5308416.0 * t0 *
            t8 + 11335680.0 * t12 * t6,
            11943936.0 * alpha * t15 + 19200000.0 * alpha * t16 + 53084160.0 * gamma * t0 * t6 - 19692720.0 * t12 *
            t9 - 63417600.0 * t17 * t18 + 32659200.0 * t17 * t4,
            -1119744.0 * alpha * t19 + 40032000.0 * beta * t16 + 6718464.0 * beta6 * zeta4 - 83397600.0 * gamma2 *
            m2 * t14 + 129392640.0 * t10 * t8 + 199065600.0 * t17 * t21 - 104544000.0 * t18 * t20,
            -1259712.0 * beta7 * zeta2 + 78382080.0 * gamma * t15 + 17200000.0 * m2 * t22 - 14307840.0 * t10 * t11 +
            550195200.0 * t13 * t6 + 331776000.0 * t20 * t21 - 64400000.0 * t23 * t7 - 171684000.0 * t24 * t25,
            1140480000.0 * alpha * t25 * zeta4 - 170100000.0 * beta * gamma4 * t24 + 59049.0 * beta8 - 17146080.0 *
            gamma * t19 + 371692800.0 * gamma2 * t8 + 207360000.0 * t0 * t22 - 75427200.0 * t13 * t9,
            1140480000.0 * alpha * beta * gamma4 * zeta4 - 209952000.0 * alpha * gamma3 * t14 + 912384000.0 * beta3
            * gamma3 * zeta4 + 918540.0 * beta7 * gamma - 98560800.0 * gamma2 * t11 - 63750000.0 * m2 * t26,
            -325440000.0 * alpha * beta2 * t23 + 432000000.0 * alpha * gamma5 * zeta4 + 1215360000.0 * beta2 * t22 +
            6196500.0 * beta6 * gamma2 - 309906000.0 * gamma3 * t9,
            -266400000.0 * alpha * beta * t26 + 828000000.0 * beta * gamma5 * zeta4 + 23692500.0 * beta5 * gamma3 -
            575100000.0 * gamma4 * t14,
            -90000000.0 * alpha * t27 - 629100000.0 * beta2 * t26 + 56193750.0 * beta4 * gamma4 + 225000000.0 *
            gamma6 * zeta4,
            -375000000.0 * beta * t27 + 84712500.0 * beta3 * gamma5,
            79312500.0 * beta2 * gamma6 - 93750000.0 * gamma7 * zeta2,
            42187500.0 * beta * gamma7,
            9765625.0 * gamma8,
        ),
        (m, zeta, alpha, beta, gamma, u_cr),
    )


def saddle_nodes(F_0, m, zeta, alpha, beta, gamma, u_cr):
    """Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds.

    Equation from (24), (30). Domain: roots with 0 < A <= u_cr.
    Operations: 1405 structured, 504 common subexpressions, 460 power chains.
    """
    F_0, m, zeta, alpha, beta, gamma, u_cr = floats(F_0, m, zeta, alpha, beta, gamma, u_cr)
    F_0_2 = F_0 * F_0
    m2 = m * m
    m3 = m * m2
    m6 = m3 * m3
    F_0_4 = F_0_2 * F_0_2
    m4 = m2 * m2
    F_0_3 = F_0 * F_0_2
    F_0_6 = F_0_3 * F_0_3
    zeta2 = zeta * zeta
    t0 = m6 * zeta2
    t1 = 512.0 * alpha
    zeta4 = zeta2 * zeta2
    t2 = 1024.0 * zeta4
    t3 = F_0_2 * m4
    t4 = F_0_4 * m2
    t5 = t4 * zeta2
    t6 = F_0_6 * zeta2
    t7 = alpha * alpha
    t8 = t3 * zeta2
    t9 = 1536.0 * beta
    beta2 = beta * beta
    t10 = 288.0 * beta2
    t11 = 1280.0 * gamma
    t12 = m4 * zeta4
    t13 = alpha * t12
    t14 = 864.0 * beta2
    t15 = F_0_2 * zeta4
    t16 = m2 * t15
    t17 = alpha * beta
    t18 = beta * gamma
    t19 = 960.0 * t18
    t20 = 2880.0 * t18
    t21 = beta2 * zeta4
    t22 = F_0_4 * beta2
    t23 = alpha * zeta2
    t24 = beta2 * m4
    t25 = alpha * gamma
    t26 = m2 * zeta2
    t27 = F_0_2 * t26
    t28 = alpha * t27
    gamma2 = gamma * gamma
    t29 = 800.0 * gamma2
    t30 = 7680.0 * t18
    t31 = 2400.0 * gamma2
    beta3 = beta * beta2
    t32 = beta3 * zeta2
    t33 = 3840.0 * t18
    t34 = F_0_2 * m2
    t35 = m2 * t7
    beta4 = beta2 * beta2
    t36 = 324.0 * beta4
    t37 = beta4 * m2
    t38 = gamma2 * zeta4
    t39 = 6912.0 * alpha
    t40 = beta3 * t15
    t41 = gamma2 * t23
    t42 = F_0_4 * gamma
    t43 = beta2 * zeta2
    t44 = m2 * zeta4
    t45 = beta3 * t44
    t46 = gamma * m4
    t47 = t7 * zeta4
    t48 = 2160.0 * beta3
    t49 = 5184.0 * beta4
    t50 = 2592.0 * t37
    t51 = F_0_2 * zeta2
    t52 = beta4 * t51
    t53 = beta3 * gamma
    t54 = beta * gamma2
    t55 = 9600.0 * t54 * zeta2
    t56 = t21 * t25
    beta5 = beta * beta4
    t57 = 1944.0 * beta5
    t58 = 5400.0 * gamma2
    gamma3 = gamma * gamma2
    t59 = gamma3 * zeta2
    t60 = 6000.0 * F_0_4
    t61 = alpha * t38
    t62 = beta * t61
    t63 = F_0_2 * t32
    t64 = 17280.0 * t25
    t65 = m2 * t32
    t66 = beta2 * gamma2
    t67 = beta * gamma3
    t68 = beta5 * zeta4
    t69 = alpha * gamma3
    t70 = 14580.0 * gamma
    t71 = gamma2 * t21
    t72 = 43200.0 * alpha * t66
    gamma4 = gamma2 * gamma2
    t73 = 2500.0 * gamma4
    t74 = 5000.0 * gamma4
    t75 = F_0_2 * t59
    t76 = 48000.0 * t17
    t77 = m2 * t59
    t78 = 43200.0 * gamma2
    t79 = 20000.0 * gamma4
    t80 = alpha * t79
    t81 = 63000.0 * beta2
    t82 = 45000.0 * beta * gamma4
    gamma5 = gamma * gamma4
    t83 = 12500.0 * gamma5
    t84 = gamma5 * zeta4
    m8 = m4 * m4
    F_0_8 = F_0_4 * F_0_4
    beta6 = beta3 * beta3
    gamma6 = gamma3 * gamma3
    return stacked(
        (
            -256.0 * F_0_2 * m6 + 384.0 * F_0_4 * m4 - 256.0 * F_0_6 * m2 + 64.0 * F_0_8 + 64.0 * m8,
            1024.0 * F_0_2 * alpha * m4 * zeta2 + 1024.0 * F_0_4 * m2 * zeta4 - t0 * t1 - t1 * t5 - t2 * t3,
            -384.0 * beta * t0 - 1920.0 * beta * t5 + 768.0 * beta * t6 + m4 * t2 * t7 + t8 * t9,
            -F_0_6 * t10 - 320.0 * gamma * t0 - 2880.0 * gamma * t5 + 1920.0 * gamma * t8 + m6 * t10 + t11 * t6 +
            t13 * t9 - t14 * t3 + t14 * t4 + 3072.0 * t16 * t17,
            2304.0 * F_0_4 * t21 - F_0_6 * t19 + 1152.0 * beta2 * t28 + 576.0 * m4 * t21 + m6 * t19 + t11 * t13 +
            5120.0 * t16 * t25 - t20 * t3 + t20 * t4 + 1152.0 * t22 * t23 - 2304.0 * t23 * t24,
            F_0_4 * t23 * t33 + F_0_4 * t30 * zeta4 - 864.0 * F_0_4 * t32 - F_0_6 * t29 - m4 * t23 * t30 - 1728.0 *
            m4 * t32 + m6 * t29 + t12 * t19 - 1920.0 * t16 * t18 + 4608.0 * t21 * t35 + t28 * t33 - t3 * t31 + t31 *
            t4 + 2592.0 * t32 * t34,
            -648.0 * F_0_2 * t37 + F_0_4 * t36 + 6400.0 * F_0_4 * t38 + 3200.0 * F_0_4 * t41 + 12240.0 * beta2 *
            gamma * t27 + 3200.0 * gamma2 * t28 + 15360.0 * m2 * t18 * t47 + m4 * t36 + 400.0 * m4 * t38 - 6400.0 *
            m4 * t41 - 3200.0 * t34 * t38 + t39 * t40 + t39 * t45 - 5040.0 * t42 * t43 - 7200.0 * t43 * t46,
            34560.0 * F_0_2 * t56 - F_0_4 * t55 - 2592.0 * alpha * t52 + 28800.0 * m2 * t56 - m4 * t55 + t15 * t49 -
            t23 * t50 + 19200.0 * t27 * t54 - 4320.0 * t34 * t53 + 12800.0 * t35 * t38 + t42 * t48 + t46 * t48 + t50
            * zeta4,
            57600.0 * F_0_2 * t62 + 30240.0 * gamma * t40 + 12960.0 * gamma * t45 + 38400.0 * m2 * t62 - 4000.0 * m4
            * t59 + t22 * t58 + t24 * t58 - t26 * t57 + 10000.0 * t34 * t59 - 10800.0 * t34 * t66 + t47 * t49 - t51
            * t57 - t59 * t60 - t63 * t64 - t64 * t65,
            64800.0 * F_0_2 * t71 + 7776.0 * alpha * t68 + 23400.0 * m2 * t71 + 6000.0 * m4 * t67 + 32000.0 * t15 *
            t69 - t26 * t72 - 12000.0 * t34 * t67 - t37 * t70 * zeta2 + 16000.0 * t44 * t69 + 34560.0 * t47 * t53 -
            t51 * t72 - t52 * t70 + t60 * t67,
            F_0_4 * t73 + 58320.0 * alpha * beta4 * gamma * zeta4 + 2916.0 * beta6 * zeta4 + m4 * t73 + 60000.0 *
            t15 * t67 - t34 * t74 + 18000.0 * t44 * t67 - t63 * t78 - t65 * t78 + 86400.0 * t7 * t71 - t75 * t76 -
            t76 * t77,
            172800.0 * beta3 * t61 + 24300.0 * gamma * t68 + t15 * t79 - t26 * t80 + t44 * t74 + 96000.0 * t47 * t67
            - t51 * t80 - t75 * t81 - t77 * t81,
            83025.0 * beta4 * t38 + 40000.0 * gamma4 * t47 + 252000.0 * t21 * t69 - t26 * t82 - t51 * t82,
            180000.0 * alpha * beta * gamma4 * zeta4 + 148500.0 * beta3 * gamma3 * zeta4 - t26 * t83 - t51 * t83,
            50000.0 * alpha * t84 + 146250.0 * gamma4 * t21,
            75000.0 * beta * t84,
            15625.0 * gamma6 * zeta4,
        ),
        (F_0, m, zeta, alpha, beta, gamma, u_cr),
    )


def R(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """Cosine balance, -F_0 cos phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta, gamma, u_cr)
    arguments = (Omega, A, mu, zeta, alpha, beta, gamma, u_cr)
    return full(flow.R(Omega, A, average), arguments)


def I(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):  # noqa: E743
    """Sine balance, -F_0 sin phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0.
    """
    arguments = (Omega, A, mu, zeta, alpha, beta, gamma, u_cr)
    return full(flow.I(Omega, A, flow.friction(mu), zeta), arguments)


def F(Omega, A, F_0, mu, zeta, alpha, beta, gamma, u_cr):
    """Frequency response; zero at a steady state.

    Equation (24). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta, gamma, u_cr)
    return flow.F(Omega, A, F_0, flow.friction(mu), zeta, average)


def F_A(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """dF/dA; positive where stable.

    Equation (24), (30). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.F_A(Omega, A, flow.friction(mu), zeta, average, average_A)


def F_AA(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """d2F/dA2.

    Equation (24), (33). Domain: Omega > 0, A > 0.
    """
    average, average_A, average_AA = averaged_3(A, alpha, beta, gamma, u_cr)
    return flow.F_AA(Omega, A, flow.friction(mu), zeta, average, average_A, average_AA)


def F_AAA(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """d3F/dA3.

    Equation (24). Domain: Omega > 0, A > 0.
    """
    average, average_A, average_AA, average_AAA = averaged(A, alpha, beta, gamma, u_cr)
    return flow.F_AAA(Omega, A, flow.friction(mu), zeta, average, average_A, average_AA, average_AAA)


def F_Omega(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """dF/dOmega.

    Equation (24), (34). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta, gamma, u_cr)
    return flow.F_Omega(Omega, A, flow.friction(mu), zeta, average)


def F_AOmega(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """d2F/dA dOmega.

    Equation (24). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.F_AOmega(Omega, A, flow.friction(mu), zeta, average, average_A)


def phase(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """Phase phi of a steady state, from -pi to 0.

    Equation (25). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta, gamma, u_cr)
    return flow.phase(Omega, A, flow.friction(mu), zeta, average)


def jacobian(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.

    Equation (28). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.jacobian(Omega, A, flow.friction(mu), zeta, average, average_A)


def stability(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.

    Equation (30). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.stability(Omega, A, flow.friction(mu), zeta, average, average_A)


def transmissibility(Omega, A, F_0, mu, zeta, alpha, beta, gamma, u_cr):
    """Fundamental harmonic of the force on the base over F_0, at a steady state.

    Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0.
    """
    average = h(A, alpha, beta, gamma, u_cr)
    return flow.transmissibility(Omega, A, F_0, flow.friction(mu), zeta, average)


def backbone(A, alpha, beta, gamma, u_cr):
    """Frequency on the backbone.

    Equation (26). Domain: A > 0, h <= 0.
    """
    average = h(A, alpha, beta, gamma, u_cr)
    return flow.backbone(A, average)


def limit_envelope(Omega, F_0, mu, zeta):
    """Largest amplitude that the forcing can hold at this frequency.

    Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise.
    """
    return flow.limit_envelope(Omega, F_0, flow.friction(mu), zeta)


def equivalent_damping(Omega, A, mu, zeta):
    """Viscous damping ratio that dissipates as much as zeta and friction together.

    Equation (38). Domain: Omega > 0, A > 0.
    """
    return flow.equivalent_damping(Omega, A, flow.friction(mu), zeta)


FORCE = ((force_1, force_1_u), (force_2, force_2_u))

if NATIVE is not None:
    (
        averaged,
        averaged_3,
        averaged_2,
        attached,
        h,
        h_A,
        h_AA,
        h_AAA,
        H,
        H_A,
        H_AA,
        harmonics,
        coefficients,
        breakpoints,
        jumps,
        hardening,
        force,
        saddle_node_onset,
        saddle_nodes,
        R,
        I,
        F,
        F_A,
        F_AA,
        F_AAA,
        F_Omega,
        F_AOmega,
        phase,
        jacobian,
        stability,
        transmissibility,
        backbone,
        limit_envelope,
        equivalent_damping,
    ) = NATIVE.rod_spring()
    saddle_node_onset = coefficients_of(saddle_node_onset)
    saddle_nodes = coefficients_of(saddle_nodes)
    breakpoints = in_tuple(breakpoints)
    jumps = in_tuple(jumps)


def _load_untruncated():
    from slowflow_kernels import rod_spring_untruncated

    return rod_spring_untruncated.MECHANISM


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
_ATTACHED = Mechanism(
    name="rod_spring_attached",
    title="Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, attached only",
    design=_DESIGN,
    parameters=_PARAMETERS,
    coefficients=coefficients,
    pieces=FORCE[:1],
    breakpoints=nothing,
    jumps=nothing,
    hardening=hardening,
    averaged=attached,
    harmonics=harmonics,
    harmonics_up_to=float("inf"),
    reach=1.0,
    reach_reason="the push-rod stands vertical",
    truncated=True,
    attached=None,
    load_untruncated=_load_untruncated,
)
MECHANISM = Mechanism(
    name="rod_spring",
    title="Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr",
    design=_DESIGN,
    parameters=_PARAMETERS,
    coefficients=coefficients,
    pieces=FORCE,
    breakpoints=breakpoints,
    jumps=jumps,
    hardening=hardening,
    averaged=averaged,
    harmonics=harmonics,
    harmonics_up_to=float("inf"),
    reach=1.0,
    reach_reason="the push-rod stands vertical",
    truncated=True,
    attached=_ATTACHED,
    load_untruncated=_load_untruncated,
)
