"""Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not
truncated.

Written by `make derive`; never edit.
Input: derivations/mechanisms/rod_spring_exact.py, sha256 1b3371a6f3bd082d4bd24294ddea9a01f4b0822a58acd7b5b61ebe7b7e44131c
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless. Arguments broadcast; outputs have their common shape, NumPy scalars for scalars. Each
docstring gives equation number, domain and the operations after each pass.
Regimes: passed_n where A exceeds n breakpoints, far_k where it exceeds k of them 5/4 times.
"""

# a formatter would spread each polynomial over a page
# fmt: off

import numpy as np

from slowflow_kernels import slow_flow as flow
from slowflow_kernels._backend import compiled
from slowflow_kernels._broadcast import by_regime, floats, full

PARAMETERS = ("alpha", "beta", "u_cr")
RATIOS = ("lam", "r", "delta_h")
REACH = 1.0
REACH_REASON = "the push-rod stands vertical"

__all__ = [
    "F_A",
    "F_AA",
    "F_AAA",
    "H_A",
    "H_AA",
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
    "averaged",
    "averaged_2",
    "averaged_3",
    "backbone",
    "breakpoints",
    "coefficients",
    "equivalent_damping",
    "force",
    "h",
    "h_A",
    "h_AA",
    "h_AAA",
    "jacobian",
    "jumps",
    "limit_envelope",
    "phase",
    "stability",
    "transmissibility",
    "untruncated_force",
]


def _averaged_passed_0(A, alpha, beta, u_cr):
    # operations: 97 structured, 88 common subexpressions, 87 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    t5 = e_3 * e_3
    t6 = 1.0 / a_4
    t7 = m * t6
    e_4 = 0.25 * t5 * t7
    e = e_1 + e_2 + e_3 + e_4
    tau = 16.0 * e_4 * e_4 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5
    P = t7 * (e + tau)
    B = t6 * (-m * tau + 1.0)
    C = 2.0 * t6 * tau
    t8 = 2.0 * beta
    t9 = A * t8
    t10 = 1.0 / k
    k2 = k * k
    t11 = 1.0 / k2
    k3 = k * k2
    return (
        -A * alpha - P * t9,
        -alpha - t8 * (B * m * t10 - C * m + P),
        -t9 * (2.0 * B * t11 + C * t10),
        -t8 * (B * (5.0 * m + 3.0) / k3 + C * t11 * (7.0 * m - 3.0)),
    )


def _averaged_passed_0_steep(A, alpha, beta, u_cr):
    # operations: 153 structured, 136 common subexpressions, 135 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    b_4 = np.sqrt(a_3) * np.sqrt(b_3)
    t5 = e_3 * e_3
    e_4 = t3 * t5 / a_4
    a_5 = 0.5 * a_4 + 0.5 * b_4
    b_5 = np.sqrt(a_4) * np.sqrt(b_4)
    t6 = e_4 * e_4
    e_5 = t3 * t6 / a_5
    a_6 = 0.5 * a_5 + 0.5 * b_5
    b_6 = np.sqrt(a_5) * np.sqrt(b_5)
    t7 = e_5 * e_5
    e_6 = t3 * t7 / a_6
    a_7 = 0.5 * a_6 + 0.5 * b_6
    b_7 = np.sqrt(a_6) * np.sqrt(b_6)
    t8 = e_6 * e_6
    e_7 = t3 * t8 / a_7
    a_8 = 0.5 * a_7 + 0.5 * b_7
    t9 = e_7 * e_7
    t10 = 1.0 / a_8
    t11 = m * t10
    e_8 = 0.25 * t11 * t9
    e = e_1 + e_2 + e_3 + e_4 + e_5 + e_6 + e_7 + e_8
    tau = 256.0 * e_8 * e_8 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5 + 16.0 * t6 + 32.0 * t7 + 64.0 * t8 + 128.0 * t9
    P = t11 * (e + tau)
    B = t10 * (-m * tau + 1.0)
    C = 2.0 * t10 * tau
    t12 = 2.0 * beta
    t13 = A * t12
    t14 = 1.0 / k
    k2 = k * k
    t15 = 1.0 / k2
    k3 = k * k2
    return (
        -A * alpha - P * t13,
        -alpha - t12 * (B * m * t14 - C * m + P),
        -t13 * (2.0 * B * t15 + C * t14),
        -t12 * (B * (5.0 * m + 3.0) / k3 + C * t15 * (7.0 * m - 3.0)),
    )


def _averaged_passed_1(A, alpha, beta, u_cr):
    # operations: 637 structured, 596 common subexpressions, 586 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    c = np.sqrt((1.0 - u_cr) * (u_cr + 1.0))
    T = u_cr / (A + root)
    t0 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0)
    A2 = A * A
    U2 = 4.0 * A2 * t0
    v2_1 = 0.99379661859049351 * g_1 * g_1
    t1 = U2 * v2_1
    square_1 = 1.0 - t1
    delta_1 = np.sqrt(square_1)
    f_1 = 0.007968192496166605 * g_1 * v2_1 / delta_1
    t2 = 1.0 / square_1
    fall_1 = f_1 * t2 * v2_1
    v2_2 = 0.96760297675669993 * g_2 * g_2
    t3 = U2 * v2_2
    square_2 = 1.0 - t3
    delta_2 = np.sqrt(square_2)
    f_2 = 0.018466468311090958 * g_2 * v2_2 / delta_2
    t4 = 1.0 / square_2
    fall_2 = f_2 * t4 * v2_2
    v2_3 = 0.92164198121722729 * g_3 * g_3
    t5 = U2 * v2_3
    square_3 = 1.0 - t5
    delta_3 = np.sqrt(square_3)
    f_3 = 0.028784707883323369 * g_3 * v2_3 / delta_3
    t6 = 1.0 / square_3
    fall_3 = f_3 * t6 * v2_3
    v2_4 = 0.85784652785798998 * g_4 * g_4
    t7 = U2 * v2_4
    square_4 = 1.0 - t7
    delta_4 = np.sqrt(square_4)
    f_4 = 0.03879919256962705 * g_4 * v2_4 / delta_4
    t8 = 1.0 / square_4
    fall_4 = f_4 * t8 * v2_4
    v2_5 = 0.77891309933755515 * g_5 * g_5
    t9 = U2 * v2_5
    square_5 = 1.0 - t9
    delta_5 = np.sqrt(square_5)
    f_5 = 0.048402672830594053 * g_5 * v2_5 / delta_5
    t10 = 1.0 / square_5
    fall_5 = f_5 * t10 * v2_5
    v2_6 = 0.68817935411770381 * g_6 * g_6
    t11 = U2 * v2_6
    square_6 = 1.0 - t11
    delta_6 = np.sqrt(square_6)
    f_6 = 0.057493156217619065 * g_6 * v2_6 / delta_6
    t12 = 1.0 / square_6
    fall_6 = f_6 * t12 * v2_6
    v2_7 = 0.58948218524948104 * g_7 * g_7
    t13 = U2 * v2_7
    square_7 = 1.0 - t13
    delta_7 = np.sqrt(square_7)
    f_7 = 0.065974229882180491 * g_7 * v2_7 / delta_7
    t14 = 1.0 / square_7
    fall_7 = f_7 * t14 * v2_7
    v2_8 = 0.4869953130832757 * g_8 * g_8
    t15 = U2 * v2_8
    square_8 = 1.0 - t15
    delta_8 = np.sqrt(square_8)
    f_8 = 0.073755974737705204 * g_8 * v2_8 / delta_8
    t16 = 1.0 / square_8
    fall_8 = f_8 * t16 * v2_8
    v2_9 = 0.38505274377519932 * g_9 * g_9
    t17 = U2 * v2_9
    square_9 = 1.0 - t17
    delta_9 = np.sqrt(square_9)
    f_9 = 0.080755895229420213 * g_9 * v2_9 / delta_9
    t18 = 1.0 / square_9
    fall_9 = f_9 * t18 * v2_9
    v2_10 = 0.28796547636914854 * g_10 * g_10
    t19 = U2 * v2_10
    square_10 = 1.0 - t19
    delta_10 = np.sqrt(square_10)
    f_10 = 0.086899787201082976 * g_10 * v2_10 / delta_10
    t20 = 1.0 / square_10
    fall_10 = f_10 * t20 * v2_10
    v2_11 = 0.19983919110743342 * g_11 * g_11
    t21 = U2 * v2_11
    square_11 = 1.0 - t21
    delta_11 = np.sqrt(square_11)
    f_11 = 0.092122522237786122 * g_11 * v2_11 / delta_11
    t22 = 1.0 / square_11
    fall_11 = f_11 * t22 * v2_11
    v2_12 = 0.12440062341181206 * g_12 * g_12
    t23 = U2 * v2_12
    square_12 = 1.0 - t23
    delta_12 = np.sqrt(square_12)
    f_12 = 0.096368737174644253 * g_12 * v2_12 / delta_12
    t24 = 1.0 / square_12
    fall_12 = f_12 * t24 * v2_12
    v2_13 = 0.064839964168231387 * g_13 * g_13
    t25 = U2 * v2_13
    square_13 = 1.0 - t25
    delta_13 = np.sqrt(square_13)
    f_13 = 0.099593420586795267 * g_13 * v2_13 / delta_13
    t26 = 1.0 / square_13
    fall_13 = f_13 * t26 * v2_13
    v2_14 = 0.023675950313912963 * g_14 * g_14
    t27 = U2 * v2_14
    square_14 = 1.0 - t27
    delta_14 = np.sqrt(square_14)
    f_14 = 0.1017623897484055 * g_14 * v2_14 / delta_14
    t28 = 1.0 / square_14
    fall_14 = f_14 * t28 * v2_14
    v2_15 = 0.0026493505760394136 * g_15 * g_15
    t29 = U2 * v2_15
    square_15 = 1.0 - t29
    delta_15 = np.sqrt(square_15)
    f_15 = 0.10285265289355884 * g_15 * v2_15 / delta_15
    t30 = 1.0 / square_15
    fall_15 = f_15 * t30 * v2_15
    sum_0 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1) + f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0)
        * (g_10 * (0.53662414814201986 * t0 + 0.53662414814201986) + 1.0) / (c + delta_10) + f_11 * g_11 *
        (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 + 0.44703376953808915)
        + 1.0) / (c + delta_11) + f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 *
        (0.35270472553087812 * t0 + 0.35270472553087812) + 1.0) / (c + delta_12) + f_13 * g_13 * (0.7453630738321102
        - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 + 0.25463692616788985) + 1.0) / (c +
        delta_13) + f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 *
        t0 + 0.15386991360858354) + 1.0) / (c + delta_14) + f_15 * g_15 * (0.94852815744468233 -
        0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 + 0.051471842555317698) + 1.0) / (c +
        delta_15) + f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0
        + 0.98366812327974718) + 1.0) / (c + delta_2) + f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 *
        t0) * (g_3 * (0.96002186496830755 * t0 + 0.96002186496830755) + 1.0) / (c + delta_3) + f_4 * g_4 *
        (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 + 0.92620004742927431)
        + 1.0) / (c + delta_4) + f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 *
        (0.88256053579205274 * t0 + 0.88256053579205274) + 1.0) / (c + delta_5) + f_6 * g_6 * (0.17043423761723162 -
        0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 + 0.82956576238276836) + 1.0) / (c + delta_6) +
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7) + f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) *
        (g_8 * (0.69785049479331585 * t0 + 0.69785049479331585) + 1.0) / (c + delta_8) + f_9 * g_9 *
        (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 + 0.62052618298924289) +
        1.0) / (c + delta_9)
    )
    sum_1 = (
        fall_1 + fall_10 + fall_11 + fall_12 + fall_13 + fall_14 + fall_15 + fall_2 + fall_3 + fall_4 + fall_5 +
        fall_6 + fall_7 + fall_8 + fall_9
    )
    sum_2 = (
        fall_1 * t2 + fall_10 * t20 + fall_11 * t22 + fall_12 * t24 + fall_13 * t26 + fall_14 * t28 + fall_15 * t30
        + fall_2 * t4 + fall_3 * t6 + fall_4 * t8 + fall_5 * t10 + fall_6 * t12 + fall_7 * t14 + fall_8 * t16 +
        fall_9 * t18
    )
    sum_3 = (
        fall_1 * (4.0 * t1 + 1.0) / (square_1 * square_1) + fall_10 * (4.0 * t19 + 1.0) / (square_10 * square_10) +
        fall_11 * (4.0 * t21 + 1.0) / (square_11 * square_11) + fall_12 * (4.0 * t23 + 1.0) / (square_12 *
        square_12) + fall_13 * (4.0 * t25 + 1.0) / (square_13 * square_13) + fall_14 * (4.0 * t27 + 1.0) /
        (square_14 * square_14) + fall_15 * (4.0 * t29 + 1.0) / (square_15 * square_15) + fall_2 * (4.0 * t3 + 1.0)
        / (square_2 * square_2) + fall_3 * (4.0 * t5 + 1.0) / (square_3 * square_3) + fall_4 * (4.0 * t7 + 1.0) /
        (square_4 * square_4) + fall_5 * (4.0 * t9 + 1.0) / (square_5 * square_5) + fall_6 * (4.0 * t11 + 1.0) /
        (square_6 * square_6) + fall_7 * (4.0 * t13 + 1.0) / (square_7 * square_7) + fall_8 * (4.0 * t15 + 1.0) /
        (square_8 * square_8) + fall_9 * (4.0 * t17 + 1.0) / (square_9 * square_9)
    )
    t31 = 0.31830988618379069 * beta
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    t32 = T3 * sum_0 * u_cr2 / c
    T4 = t0 * t0
    T5 = T * T4
    t33 = 8.0 * t31
    t34 = 96.0 * T5
    t35 = 1.0 / root
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    c2 = c * c
    c3 = c * c2
    t36 = u_cr5 / c3
    t37 = t35 * t36
    A4 = A2 * A2
    t38 = 3.0 / A4
    A3 = A * A2
    root2 = root * root
    root3 = root * root2
    c4 = c2 * c2
    c5 = c * c4
    return (
        64.0 * A * t31 * t32 - A,
        -t33 * (32.0 * A2 * T5 * sum_1 - 8.0 * t32) - 1.0,
        -t33 * (A * sum_2 * t34 - t37 / A3),
        -t33 * (sum_3 * t34 + t37 * t38 - t35 * t38 * u_cr5 / c5 + t36 / (A2 * root3)),
    )


def _averaged_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 1650 structured, 1448 common subexpressions, 1430 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    t2 = 0.99379661859049351 * t1
    g_1 = 1.0 / (t2 + 1.0)
    t3 = 0.96760297675669993 * t1
    g_2 = 1.0 / (t3 + 1.0)
    t4 = 0.92164198121722729 * t1
    g_3 = 1.0 / (t4 + 1.0)
    t5 = 0.85784652785798998 * t1
    g_4 = 1.0 / (t5 + 1.0)
    t6 = 0.77891309933755515 * t1
    g_5 = 1.0 / (t6 + 1.0)
    t7 = 0.68817935411770381 * t1
    g_6 = 1.0 / (t7 + 1.0)
    t8 = 0.58948218524948104 * t1
    g_7 = 1.0 / (t8 + 1.0)
    t9 = 0.4869953130832757 * t1
    g_8 = 1.0 / (t9 + 1.0)
    t10 = 0.38505274377519932 * t1
    g_9 = 1.0 / (t10 + 1.0)
    t11 = 0.28796547636914854 * t1
    g_10 = 1.0 / (t11 + 1.0)
    t12 = 0.19983919110743342 * t1
    g_11 = 1.0 / (t12 + 1.0)
    t13 = 0.12440062341181206 * t1
    g_12 = 1.0 / (t13 + 1.0)
    t14 = 0.064839964168231387 * t1
    g_13 = 1.0 / (t14 + 1.0)
    t15 = 0.023675950313912963 * t1
    g_14 = 1.0 / (t15 + 1.0)
    t16 = 0.0026493505760394136 * t1
    g_15 = 1.0 / (t16 + 1.0)
    t17 = 1.0 / (A * A)
    x2 = t17 * u_cr * u_cr
    y2 = root * root * t17
    t18 = 1.0 / A
    third = 0.33333333333333331 * t18 * u_cr * x2
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    a0_half_0_2 = a0_half_0 * a0_half_0
    a0_half_0_3 = a0_half_0 * a0_half_0_2
    a02_0 = -a0_half_0_3
    a03_0 = -2.0 * a02_0 * a0_half_0_2
    b0_0 = np.sqrt(t0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    lam0_2 = a02_0 * b0_0 + a02_0
    lam0_3 = a03_0 * b0_0 + a03_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    term03_0 = -term0_0 * (lam0_1 * term02_0 + lam0_2 * term01_0 + lam0_3 * term0_0)
    t19 = 0.25 * lam0_0
    X0_0 = t19 + 0.25 * y2
    t20 = 0.25 * lam0_1
    X0_1 = t20 + 0.25
    t21 = 0.25 * lam0_2
    t22 = 0.25 * lam0_3
    Y0_0 = 0.25 * t0 + t19
    Z0_0 = t19 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (-a11_0 * a11_0 + t21)
    a13_0 = a1_half_0 * (-2.0 * a11_0 * a12_0 + t22)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = b1_half_0 * t20
    b12_0 = b1_half_0 * (-b11_0 * b11_0 + t21)
    b13_0 = b1_half_0 * (-2.0 * b11_0 * b12_0 + t22)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t20
    c12_0 = c1_half_0 * (-c11_0 * c11_0 + t21)
    c13_0 = c1_half_0 * (-2.0 * c11_0 * c12_0 + t22)
    t23 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t23
    t24 = a11_0 + b11_0
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t23 + c1_0 * t24
    t25 = a12_0 + b12_0
    lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * t24 + c12_0 * t23 + c1_0 * t25
    lam1_3 = (
        a11_0 * b12_0 + a12_0 * b11_0 + a13_0 * b1_0 + a1_0 * b13_0 + c11_0 * t25 + c12_0 * t24 + c13_0 * t23 + c1_0
        * (a13_0 + b13_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t20
    q1_2 = lam1_2 + t21
    q1_3 = lam1_3 + t22
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    below1_3 = c11_0 * q1_2 + c12_0 * q1_1 + c13_0 * q1_0 + c1_0 * q1_3
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    term13_0 = -term1_0 * (below1_1 * term12_0 + below1_2 * term11_0 + below1_3 * term1_0)
    t26 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t26
    t27 = 0.25 * lam1_1
    X1_1 = 0.25 * X0_1 + t27
    t28 = 0.25 * lam1_2
    X1_2 = 0.25 * t21 + t28
    t29 = 0.25 * lam1_3
    X1_3 = 0.25 * t22 + t29
    Y1_0 = 0.25 * Y0_0 + t26
    Y1_1 = 0.25 * t20 + t27
    Y1_2 = 0.25 * t21 + t28
    Y1_3 = 0.25 * t22 + t29
    Z1_0 = 0.25 * Z0_0 + t26
    Z1_1 = 0.25 * t20 + t27
    Z1_2 = 0.25 * t21 + t28
    Z1_3 = 0.25 * t22 + t29
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0)
    a23_0 = a2_half_0 * (X1_3 - 2.0 * a21_0 * a22_0)
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0)
    b23_0 = b2_half_0 * (Y1_3 - 2.0 * b21_0 * b22_0)
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0)
    c23_0 = c2_half_0 * (Z1_3 - 2.0 * c21_0 * c22_0)
    t30 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t30
    t31 = a21_0 + b21_0
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t30 + c2_0 * t31
    t32 = a22_0 + b22_0
    lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * t31 + c22_0 * t30 + c2_0 * t32
    lam2_3 = (
        a21_0 * b22_0 + a22_0 * b21_0 + a23_0 * b2_0 + a2_0 * b23_0 + c21_0 * t32 + c22_0 * t31 + c23_0 * t30 + c2_0
        * (a23_0 + b23_0)
    )
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    q2_3 = Z1_3 + lam2_3
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    below2_3 = c21_0 * q2_2 + c22_0 * q2_1 + c23_0 * q2_0 + c2_0 * q2_3
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    term23_0 = -term2_0 * (below2_1 * term22_0 + below2_2 * term21_0 + below2_3 * term2_0)
    t33 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t33
    t34 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t34
    t35 = 0.25 * lam2_2
    X2_2 = 0.25 * X1_2 + t35
    t36 = 0.25 * lam2_3
    X2_3 = 0.25 * X1_3 + t36
    Y2_0 = 0.25 * Y1_0 + t33
    Y2_1 = 0.25 * Y1_1 + t34
    Y2_2 = 0.25 * Y1_2 + t35
    Y2_3 = 0.25 * Y1_3 + t36
    Z2_0 = 0.25 * Z1_0 + t33
    Z2_1 = 0.25 * Z1_1 + t34
    Z2_2 = 0.25 * Z1_2 + t35
    Z2_3 = 0.25 * Z1_3 + t36
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0)
    a33_0 = a3_half_0 * (X2_3 - 2.0 * a31_0 * a32_0)
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0)
    b33_0 = b3_half_0 * (Y2_3 - 2.0 * b31_0 * b32_0)
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0)
    c33_0 = c3_half_0 * (Z2_3 - 2.0 * c31_0 * c32_0)
    t37 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t37
    t38 = a31_0 + b31_0
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t37 + c3_0 * t38
    t39 = a32_0 + b32_0
    lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * t38 + c32_0 * t37 + c3_0 * t39
    lam3_3 = (
        a31_0 * b32_0 + a32_0 * b31_0 + a33_0 * b3_0 + a3_0 * b33_0 + c31_0 * t39 + c32_0 * t38 + c33_0 * t37 + c3_0
        * (a33_0 + b33_0)
    )
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    q3_3 = Z2_3 + lam3_3
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    below3_3 = c31_0 * q3_2 + c32_0 * q3_1 + c33_0 * q3_0 + c3_0 * q3_3
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    term33_0 = -term3_0 * (below3_1 * term32_0 + below3_2 * term31_0 + below3_3 * term3_0)
    t40 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t40
    t41 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t41
    t42 = 0.25 * lam3_2
    X3_2 = 0.25 * X2_2 + t42
    t43 = 0.25 * lam3_3
    X3_3 = 0.25 * X2_3 + t43
    Y3_0 = 0.25 * Y2_0 + t40
    Y3_1 = 0.25 * Y2_1 + t41
    Y3_2 = 0.25 * Y2_2 + t42
    Y3_3 = 0.25 * Y2_3 + t43
    Z3_0 = 0.25 * Z2_0 + t40
    Z3_1 = 0.25 * Z2_1 + t41
    Z3_2 = 0.25 * Z2_2 + t42
    Z3_3 = 0.25 * Z2_3 + t43
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0)
    a43_0 = a4_half_0 * (X3_3 - 2.0 * a41_0 * a42_0)
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0)
    b43_0 = b4_half_0 * (Y3_3 - 2.0 * b41_0 * b42_0)
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0)
    c43_0 = c4_half_0 * (Z3_3 - 2.0 * c41_0 * c42_0)
    t44 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t44
    t45 = a41_0 + b41_0
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t44 + c4_0 * t45
    t46 = a42_0 + b42_0
    lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * t45 + c42_0 * t44 + c4_0 * t46
    lam4_3 = (
        a41_0 * b42_0 + a42_0 * b41_0 + a43_0 * b4_0 + a4_0 * b43_0 + c41_0 * t46 + c42_0 * t45 + c43_0 * t44 + c4_0
        * (a43_0 + b43_0)
    )
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    q4_3 = Z3_3 + lam4_3
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    below4_3 = c41_0 * q4_2 + c42_0 * q4_1 + c43_0 * q4_0 + c4_0 * q4_3
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    term43_0 = -term4_0 * (below4_1 * term42_0 + below4_2 * term41_0 + below4_3 * term4_0)
    t47 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t47
    t48 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t48
    t49 = 0.25 * lam4_2
    X4_2 = 0.25 * X3_2 + t49
    t50 = 0.25 * lam4_3
    X4_3 = 0.25 * X3_3 + t50
    Y4_0 = 0.25 * Y3_0 + t47
    Y4_1 = 0.25 * Y3_1 + t48
    Y4_2 = 0.25 * Y3_2 + t49
    Y4_3 = 0.25 * Y3_3 + t50
    Z4_0 = 0.25 * Z3_0 + t47
    Z4_1 = 0.25 * Z3_1 + t48
    Z4_2 = 0.25 * Z3_2 + t49
    Z4_3 = 0.25 * Z3_3 + t50
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0)
    a53_0 = a5_half_0 * (X4_3 - 2.0 * a51_0 * a52_0)
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0)
    b53_0 = b5_half_0 * (Y4_3 - 2.0 * b51_0 * b52_0)
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0)
    c53_0 = c5_half_0 * (Z4_3 - 2.0 * c51_0 * c52_0)
    t51 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t51
    t52 = a51_0 + b51_0
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t51 + c5_0 * t52
    t53 = a52_0 + b52_0
    lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * t52 + c52_0 * t51 + c5_0 * t53
    lam5_3 = (
        a51_0 * b52_0 + a52_0 * b51_0 + a53_0 * b5_0 + a5_0 * b53_0 + c51_0 * t53 + c52_0 * t52 + c53_0 * t51 + c5_0
        * (a53_0 + b53_0)
    )
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    q5_3 = Z4_3 + lam5_3
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    below5_3 = c51_0 * q5_2 + c52_0 * q5_1 + c53_0 * q5_0 + c5_0 * q5_3
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    term53_0 = -term5_0 * (below5_1 * term52_0 + below5_2 * term51_0 + below5_3 * term5_0)
    t54 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t54
    t55 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t55
    t56 = 0.25 * lam5_2
    X5_2 = 0.25 * X4_2 + t56
    t57 = 0.25 * lam5_3
    X5_3 = 0.25 * X4_3 + t57
    Y5_0 = 0.25 * Y4_0 + t54
    Y5_1 = 0.25 * Y4_1 + t55
    Y5_2 = 0.25 * Y4_2 + t56
    Y5_3 = 0.25 * Y4_3 + t57
    Z5_0 = 0.25 * Z4_0 + t54
    Z5_1 = 0.25 * Z4_1 + t55
    Z5_2 = 0.25 * Z4_2 + t56
    Z5_3 = 0.25 * Z4_3 + t57
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    mean_3 = 0.20000000000000001 * X5_3 + 0.20000000000000001 * Y5_3 + 0.59999999999999998 * Z5_3
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    over3_0 = -over_0 * (mean_1 * over2_0 + mean_2 * over1_0 + mean_3 * over_0)
    t58 = -mean_0
    t59 = -X5_0 - t58
    dx_0 = over_0 * t59
    t60 = -mean_1
    t61 = -X5_1 - t60
    dx_1 = over1_0 * t59 + over_0 * t61
    t62 = -mean_2
    t63 = -X5_2 - t62
    dx_2 = over1_0 * t61 + over2_0 * t59 + over_0 * t63
    t64 = -mean_3
    dx_3 = over1_0 * t63 + over2_0 * t61 + over3_0 * t59 + over_0 * (-X5_3 - t64)
    t65 = -Y5_0 - t58
    dy_0 = over_0 * t65
    t66 = -Y5_1 - t60
    dy_1 = over1_0 * t65 + over_0 * t66
    t67 = -Y5_2 - t62
    dy_2 = over1_0 * t66 + over2_0 * t65 + over_0 * t67
    dy_3 = over1_0 * t67 + over2_0 * t66 + over3_0 * t65 + over_0 * (-Y5_3 - t64)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    dz_3 = -0.33333333333333331 * dx_3 - 0.33333333333333331 * dy_3
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    xy_3 = dx_0 * dy_3 + dx_1 * dy_2 + dx_2 * dy_1 + dx_3 * dy_0
    zz_0 = dz_0 * dz_0
    t68 = 2.0 * dz_0
    zz_1 = dz_1 * t68
    zz_2 = dz_1 * dz_1 + dz_2 * t68
    zz_3 = 2.0 * dz_1 * dz_2 + dz_3 * t68
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E2_3 = xy_3 - 6.0 * zz_3
    t69 = 3.0 * xy_0
    t70 = t69 - 8.0 * zz_0
    E3_0 = dz_0 * t70
    t71 = 3.0 * xy_1
    t72 = t71 - 8.0 * zz_1
    E3_1 = dz_0 * t72 + dz_1 * t70
    t73 = 3.0 * xy_2
    t74 = t73 - 8.0 * zz_2
    E3_2 = dz_0 * t74 + dz_1 * t72 + dz_2 * t70
    t75 = 3.0 * xy_3
    E3_3 = dz_0 * (t75 - 8.0 * zz_3) + dz_1 * t74 + dz_2 * t72 + dz_3 * t70
    t76 = t69 - 3.0 * zz_0
    E4_0 = t76 * zz_0
    t77 = t71 - 3.0 * zz_1
    E4_1 = t76 * zz_1 + t77 * zz_0
    t78 = t73 - 3.0 * zz_2
    E4_2 = t76 * zz_2 + t77 * zz_1 + t78 * zz_0
    E4_3 = t76 * zz_3 + t77 * zz_2 + t78 * zz_1 + zz_0 * (t75 - 3.0 * zz_3)
    t79 = xy_0 * zz_0
    E5_0 = dz_0 * t79
    t80 = xy_0 * zz_1 + xy_1 * zz_0
    E5_1 = dz_0 * t80 + dz_1 * t79
    t81 = xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0
    E5_2 = dz_0 * t81 + dz_1 * t80 + dz_2 * t79
    E5_3 = dz_0 * (xy_0 * zz_3 + xy_1 * zz_2 + xy_2 * zz_1 + xy_3 * zz_0) + dz_1 * t81 + dz_2 * t80 + dz_3 * t79
    t82 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t82 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    t83 = 0.17307692307692307 * E2_1
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.21428571428571427 * E2_1 - E3_0 * t83 - E3_1 * t82 +
        0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    t84 = 0.17307692307692307 * E2_2
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 + 0.10227272727272728 * E2_1 * E2_1 - 0.21428571428571427 * E2_2 - E3_0 *
        t84 - E3_1 * t83 - E3_2 * t82 + 0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 +
        0.11538461538461539 * E5_2
    )
    series_3 = (
        0.20454545454545456 * E2_0 * E2_3 + 0.20454545454545456 * E2_1 * E2_2 - 0.17307692307692307 * E2_3 * E3_0 -
        0.21428571428571427 * E2_3 - E3_1 * t84 - E3_2 * t83 - E3_3 * t82 + 0.16666666666666666 * E3_3 -
        0.13636363636363635 * E4_3 + 0.11538461538461539 * E5_3
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0)
    sq3_0 = sq_half_0 * (over3_0 - 2.0 * sq1_0 * sq2_0)
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0
    power_3 = over1_0 * sq2_0 + over2_0 * sq1_0 + over3_0 * sq_0 + over_0 * sq3_0
    last_0 = power_0 * series_0
    last_1 = power_0 * series_1 + power_1 * series_0
    last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0
    last_3 = power_0 * series_3 + power_1 * series_2 + power_2 * series_1 + power_3 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    R_2 = (
        0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 * term32_0 +
        0.01171875 * term42_0 + 0.0029296875 * term52_0
    )
    R_3 = (
        0.000244140625 * last_3 + 3.0 * term03_0 + 0.75 * term13_0 + 0.1875 * term23_0 + 0.046875 * term33_0 +
        0.01171875 * term43_0 + 0.0029296875 * term53_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    x2_2 = x2 * x2
    V6 = 2.6666666666666665 * R_2 * third * x2_2
    x2_3 = x2 * x2_2
    V8 = -3.2000000000000002 * R_3 * third * x2_3
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    t85 = 1.0 - t2
    tangent_1 = 3.975186474361974 * t1 / (t85 * t85)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t86 = 1.0 - t3
    tangent_2 = 3.8704119070267997 * t1 / (t86 * t86)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t87 = 1.0 - t4
    tangent_3 = 3.6865679248689092 * t1 / (t87 * t87)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t88 = 1.0 - t5
    tangent_4 = 3.4313861114319599 * t1 / (t88 * t88)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t89 = 1.0 - t6
    tangent_5 = 3.1156523973502206 * t1 / (t89 * t89)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t90 = 1.0 - t7
    tangent_6 = 2.7527174164708152 * t1 / (t90 * t90)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t91 = 1.0 - t8
    tangent_7 = 2.3579287409979242 * t1 / (t91 * t91)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t92 = 1.0 - t9
    tangent_8 = 1.9479812523331028 * t1 / (t92 * t92)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t93 = 1.0 - t10
    tangent_9 = 1.5402109751007973 * t1 / (t93 * t93)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t94 = 1.0 - t11
    tangent_10 = 1.1518619054765942 * t1 / (t94 * t94)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t95 = 1.0 - t12
    tangent_11 = 0.79935676442973369 * t1 / (t95 * t95)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t96 = 1.0 - t13
    tangent_12 = 0.49760249364724823 * t1 / (t96 * t96)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t97 = 1.0 - t14
    tangent_13 = 0.25935985667292555 * t1 / (t97 * t97)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t98 = 1.0 - t15
    tangent_14 = 0.094703801255651851 * t1 / (t98 * t98)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t99 = 1.0 - t16
    tangent_15 = 0.010597402304157654 * t1 / (t99 * t99)
    T3 = T * t1
    t100 = 8.0 * T3
    S_0 = (
        t100 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    S_1 = (
        t100 * (tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13
        * term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 +
        tangent_4 * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 +
        tangent_9 * term_9)
    )
    tangent_1_2 = tangent_1 * tangent_1
    tangent_10_2 = tangent_10 * tangent_10
    tangent_11_2 = tangent_11 * tangent_11
    tangent_12_2 = tangent_12 * tangent_12
    tangent_13_2 = tangent_13 * tangent_13
    tangent_14_2 = tangent_14 * tangent_14
    tangent_15_2 = tangent_15 * tangent_15
    tangent_2_2 = tangent_2 * tangent_2
    tangent_3_2 = tangent_3 * tangent_3
    tangent_4_2 = tangent_4 * tangent_4
    tangent_5_2 = tangent_5 * tangent_5
    tangent_6_2 = tangent_6 * tangent_6
    tangent_7_2 = tangent_7 * tangent_7
    tangent_8_2 = tangent_8 * tangent_8
    tangent_9_2 = tangent_9 * tangent_9
    S_2 = (
        t100 * (tangent_10_2 * term_10 + tangent_11_2 * term_11 + tangent_12_2 * term_12 + tangent_13_2 * term_13 +
        tangent_14_2 * term_14 + tangent_15_2 * term_15 + tangent_1_2 * term_1 + tangent_2_2 * term_2 + tangent_3_2
        * term_3 + tangent_4_2 * term_4 + tangent_5_2 * term_5 + tangent_6_2 * term_6 + tangent_7_2 * term_7 +
        tangent_8_2 * term_8 + tangent_9_2 * term_9)
    )
    tangent_1_3 = tangent_1 * tangent_1_2
    tangent_10_3 = tangent_10 * tangent_10_2
    tangent_11_3 = tangent_11 * tangent_11_2
    tangent_12_3 = tangent_12 * tangent_12_2
    tangent_13_3 = tangent_13 * tangent_13_2
    tangent_14_3 = tangent_14 * tangent_14_2
    tangent_15_3 = tangent_15 * tangent_15_2
    tangent_2_3 = tangent_2 * tangent_2_2
    tangent_3_3 = tangent_3 * tangent_3_2
    tangent_4_3 = tangent_4 * tangent_4_2
    tangent_5_3 = tangent_5 * tangent_5_2
    tangent_6_3 = tangent_6 * tangent_6_2
    tangent_7_3 = tangent_7 * tangent_7_2
    tangent_8_3 = tangent_8 * tangent_8_2
    tangent_9_3 = tangent_9 * tangent_9_2
    S_3 = (
        t100 * (tangent_10_3 * term_10 + tangent_11_3 * term_11 + tangent_12_3 * term_12 + tangent_13_3 * term_13 +
        tangent_14_3 * term_14 + tangent_15_3 * term_15 + tangent_1_3 * term_1 + tangent_2_3 * term_2 + tangent_3_3
        * term_3 + tangent_4_3 * term_4 + tangent_5_3 * term_5 + tangent_6_3 * term_6 + tangent_7_3 * term_7 +
        tangent_8_3 * term_8 + tangent_9_3 * term_9)
    )
    t101 = 1.0 / c
    t102 = S_0 * t101
    t103 = 2.5464790894703255 * beta
    t104 = S_1 * t101
    t105 = S_2 * t101
    return (
        A * t103 * (-V2 + t102) - A,
        t103 * (2.0 * V2 + V4 - 2.0 * t102 - t104) - 1.0,
        t103 * t18 * (-6.0 * V2 - 7.0 * V4 - 3.0 * V6 + 6.0 * t102 + 7.0 * t104 + 3.0 * t105),
        t103 * t17 * (-15.0 * S_3 * t101 + 24.0 * V2 + 48.0 * V4 + 45.0 * V6 + 15.0 * V8 - 24.0 * t102 - 48.0 * t104
        - 45.0 * t105),
    )


def _averaged_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 1448 structured, 1262 common subexpressions, 1251 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t1 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t1 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t1 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t1 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t1 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t1 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t1 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t1 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t1 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t1 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t1 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t1 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t1 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t1 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t1 + 1.0)
    A2 = A * A
    t2 = 1.0 / A2
    u_cr2 = u_cr * u_cr
    x2 = t2 * u_cr2
    root2 = root * root
    y2 = root2 * t2
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(t0)
    b0_half_0 = 0.5 / b0_0
    b0_half_0_2 = b0_half_0 * b0_half_0
    b0_half_0_3 = b0_half_0 * b0_half_0_2
    b02_0 = -b0_half_0_3
    b03_0 = -2.0 * b02_0 * b0_half_0_2
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_0 * b0_half_0 + b0_half_0
    lam0_2 = a0_0 * b02_0 + b02_0
    lam0_3 = a0_0 * b03_0 + b03_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    term03_0 = -term0_0 * (lam0_1 * term02_0 + lam0_2 * term01_0 + lam0_3 * term0_0)
    t3 = 0.25 * lam0_0
    X0_0 = t3 + 0.25 * y2
    t4 = 0.25 * lam0_1
    t5 = 0.25 * lam0_2
    t6 = 0.25 * lam0_3
    Y0_0 = 0.25 * t0 + t3
    Y0_1 = t4 + 0.25
    Z0_0 = t3 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = a1_half_0 * t4
    a12_0 = a1_half_0 * (-a11_0 * a11_0 + t5)
    a13_0 = a1_half_0 * (-2.0 * a11_0 * a12_0 + t6)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (-b11_0 * b11_0 + t5)
    b13_0 = b1_half_0 * (-2.0 * b11_0 * b12_0 + t6)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t4
    c12_0 = c1_half_0 * (-c11_0 * c11_0 + t5)
    c13_0 = c1_half_0 * (-2.0 * c11_0 * c12_0 + t6)
    t7 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t7
    t8 = a11_0 + b11_0
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t7 + c1_0 * t8
    t9 = a12_0 + b12_0
    lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * t8 + c12_0 * t7 + c1_0 * t9
    lam1_3 = (
        a11_0 * b12_0 + a12_0 * b11_0 + a13_0 * b1_0 + a1_0 * b13_0 + c11_0 * t9 + c12_0 * t8 + c13_0 * t7 + c1_0 *
        (a13_0 + b13_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t4
    q1_2 = lam1_2 + t5
    q1_3 = lam1_3 + t6
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    below1_3 = c11_0 * q1_2 + c12_0 * q1_1 + c13_0 * q1_0 + c1_0 * q1_3
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    term13_0 = -term1_0 * (below1_1 * term12_0 + below1_2 * term11_0 + below1_3 * term1_0)
    t10 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t10
    t11 = 0.25 * lam1_1
    X1_1 = t11 + 0.25 * t4
    t12 = 0.25 * lam1_2
    X1_2 = t12 + 0.25 * t5
    t13 = 0.25 * lam1_3
    X1_3 = t13 + 0.25 * t6
    Y1_0 = 0.25 * Y0_0 + t10
    Y1_1 = 0.25 * Y0_1 + t11
    Y1_2 = t12 + 0.25 * t5
    Y1_3 = t13 + 0.25 * t6
    Z1_0 = 0.25 * Z0_0 + t10
    Z1_1 = t11 + 0.25 * t4
    Z1_2 = t12 + 0.25 * t5
    Z1_3 = t13 + 0.25 * t6
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0)
    a23_0 = a2_half_0 * (X1_3 - 2.0 * a21_0 * a22_0)
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0)
    b23_0 = b2_half_0 * (Y1_3 - 2.0 * b21_0 * b22_0)
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0)
    c23_0 = c2_half_0 * (Z1_3 - 2.0 * c21_0 * c22_0)
    t14 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t14
    t15 = a21_0 + b21_0
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t14 + c2_0 * t15
    t16 = a22_0 + b22_0
    lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * t15 + c22_0 * t14 + c2_0 * t16
    lam2_3 = (
        a21_0 * b22_0 + a22_0 * b21_0 + a23_0 * b2_0 + a2_0 * b23_0 + c21_0 * t16 + c22_0 * t15 + c23_0 * t14 + c2_0
        * (a23_0 + b23_0)
    )
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    q2_3 = Z1_3 + lam2_3
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    below2_3 = c21_0 * q2_2 + c22_0 * q2_1 + c23_0 * q2_0 + c2_0 * q2_3
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    term23_0 = -term2_0 * (below2_1 * term22_0 + below2_2 * term21_0 + below2_3 * term2_0)
    t17 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t17
    t18 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t18
    t19 = 0.25 * lam2_2
    X2_2 = 0.25 * X1_2 + t19
    t20 = 0.25 * lam2_3
    X2_3 = 0.25 * X1_3 + t20
    Y2_0 = 0.25 * Y1_0 + t17
    Y2_1 = 0.25 * Y1_1 + t18
    Y2_2 = 0.25 * Y1_2 + t19
    Y2_3 = 0.25 * Y1_3 + t20
    Z2_0 = 0.25 * Z1_0 + t17
    Z2_1 = 0.25 * Z1_1 + t18
    Z2_2 = 0.25 * Z1_2 + t19
    Z2_3 = 0.25 * Z1_3 + t20
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0)
    a33_0 = a3_half_0 * (X2_3 - 2.0 * a31_0 * a32_0)
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0)
    b33_0 = b3_half_0 * (Y2_3 - 2.0 * b31_0 * b32_0)
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0)
    c33_0 = c3_half_0 * (Z2_3 - 2.0 * c31_0 * c32_0)
    t21 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t21
    t22 = a31_0 + b31_0
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t21 + c3_0 * t22
    t23 = a32_0 + b32_0
    lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * t22 + c32_0 * t21 + c3_0 * t23
    lam3_3 = (
        a31_0 * b32_0 + a32_0 * b31_0 + a33_0 * b3_0 + a3_0 * b33_0 + c31_0 * t23 + c32_0 * t22 + c33_0 * t21 + c3_0
        * (a33_0 + b33_0)
    )
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    q3_3 = Z2_3 + lam3_3
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    below3_3 = c31_0 * q3_2 + c32_0 * q3_1 + c33_0 * q3_0 + c3_0 * q3_3
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    term33_0 = -term3_0 * (below3_1 * term32_0 + below3_2 * term31_0 + below3_3 * term3_0)
    t24 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t24
    t25 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t25
    t26 = 0.25 * lam3_2
    X3_2 = 0.25 * X2_2 + t26
    t27 = 0.25 * lam3_3
    X3_3 = 0.25 * X2_3 + t27
    Y3_0 = 0.25 * Y2_0 + t24
    Y3_1 = 0.25 * Y2_1 + t25
    Y3_2 = 0.25 * Y2_2 + t26
    Y3_3 = 0.25 * Y2_3 + t27
    Z3_0 = 0.25 * Z2_0 + t24
    Z3_1 = 0.25 * Z2_1 + t25
    Z3_2 = 0.25 * Z2_2 + t26
    Z3_3 = 0.25 * Z2_3 + t27
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0)
    a43_0 = a4_half_0 * (X3_3 - 2.0 * a41_0 * a42_0)
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0)
    b43_0 = b4_half_0 * (Y3_3 - 2.0 * b41_0 * b42_0)
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0)
    c43_0 = c4_half_0 * (Z3_3 - 2.0 * c41_0 * c42_0)
    t28 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t28
    t29 = a41_0 + b41_0
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t28 + c4_0 * t29
    t30 = a42_0 + b42_0
    lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * t29 + c42_0 * t28 + c4_0 * t30
    lam4_3 = (
        a41_0 * b42_0 + a42_0 * b41_0 + a43_0 * b4_0 + a4_0 * b43_0 + c41_0 * t30 + c42_0 * t29 + c43_0 * t28 + c4_0
        * (a43_0 + b43_0)
    )
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    q4_3 = Z3_3 + lam4_3
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    below4_3 = c41_0 * q4_2 + c42_0 * q4_1 + c43_0 * q4_0 + c4_0 * q4_3
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    term43_0 = -term4_0 * (below4_1 * term42_0 + below4_2 * term41_0 + below4_3 * term4_0)
    t31 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t31
    t32 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t32
    t33 = 0.25 * lam4_2
    X4_2 = 0.25 * X3_2 + t33
    t34 = 0.25 * lam4_3
    X4_3 = 0.25 * X3_3 + t34
    Y4_0 = 0.25 * Y3_0 + t31
    Y4_1 = 0.25 * Y3_1 + t32
    Y4_2 = 0.25 * Y3_2 + t33
    Y4_3 = 0.25 * Y3_3 + t34
    Z4_0 = 0.25 * Z3_0 + t31
    Z4_1 = 0.25 * Z3_1 + t32
    Z4_2 = 0.25 * Z3_2 + t33
    Z4_3 = 0.25 * Z3_3 + t34
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0)
    a53_0 = a5_half_0 * (X4_3 - 2.0 * a51_0 * a52_0)
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0)
    b53_0 = b5_half_0 * (Y4_3 - 2.0 * b51_0 * b52_0)
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0)
    c53_0 = c5_half_0 * (Z4_3 - 2.0 * c51_0 * c52_0)
    t35 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t35
    t36 = a51_0 + b51_0
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t35 + c5_0 * t36
    t37 = a52_0 + b52_0
    lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * t36 + c52_0 * t35 + c5_0 * t37
    lam5_3 = (
        a51_0 * b52_0 + a52_0 * b51_0 + a53_0 * b5_0 + a5_0 * b53_0 + c51_0 * t37 + c52_0 * t36 + c53_0 * t35 + c5_0
        * (a53_0 + b53_0)
    )
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    q5_3 = Z4_3 + lam5_3
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    below5_3 = c51_0 * q5_2 + c52_0 * q5_1 + c53_0 * q5_0 + c5_0 * q5_3
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    term53_0 = -term5_0 * (below5_1 * term52_0 + below5_2 * term51_0 + below5_3 * term5_0)
    t38 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t38
    t39 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t39
    t40 = 0.25 * lam5_2
    X5_2 = 0.25 * X4_2 + t40
    t41 = 0.25 * lam5_3
    X5_3 = 0.25 * X4_3 + t41
    Y5_0 = 0.25 * Y4_0 + t38
    Y5_1 = 0.25 * Y4_1 + t39
    Y5_2 = 0.25 * Y4_2 + t40
    Y5_3 = 0.25 * Y4_3 + t41
    Z5_0 = 0.25 * Z4_0 + t38
    Z5_1 = 0.25 * Z4_1 + t39
    Z5_2 = 0.25 * Z4_2 + t40
    Z5_3 = 0.25 * Z4_3 + t41
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    mean_3 = 0.20000000000000001 * X5_3 + 0.20000000000000001 * Y5_3 + 0.59999999999999998 * Z5_3
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    over3_0 = -over_0 * (mean_1 * over2_0 + mean_2 * over1_0 + mean_3 * over_0)
    t42 = -mean_0
    t43 = -X5_0 - t42
    dx_0 = over_0 * t43
    t44 = -mean_1
    t45 = -X5_1 - t44
    dx_1 = over1_0 * t43 + over_0 * t45
    t46 = -mean_2
    t47 = -X5_2 - t46
    dx_2 = over1_0 * t45 + over2_0 * t43 + over_0 * t47
    t48 = -mean_3
    dx_3 = over1_0 * t47 + over2_0 * t45 + over3_0 * t43 + over_0 * (-X5_3 - t48)
    t49 = -Y5_0 - t42
    dy_0 = over_0 * t49
    t50 = -Y5_1 - t44
    dy_1 = over1_0 * t49 + over_0 * t50
    t51 = -Y5_2 - t46
    dy_2 = over1_0 * t50 + over2_0 * t49 + over_0 * t51
    dy_3 = over1_0 * t51 + over2_0 * t50 + over3_0 * t49 + over_0 * (-Y5_3 - t48)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    dz_3 = -0.33333333333333331 * dx_3 - 0.33333333333333331 * dy_3
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    xy_3 = dx_0 * dy_3 + dx_1 * dy_2 + dx_2 * dy_1 + dx_3 * dy_0
    zz_0 = dz_0 * dz_0
    t52 = 2.0 * dz_0
    zz_1 = dz_1 * t52
    zz_2 = dz_1 * dz_1 + dz_2 * t52
    zz_3 = 2.0 * dz_1 * dz_2 + dz_3 * t52
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E2_3 = xy_3 - 6.0 * zz_3
    t53 = 3.0 * xy_0
    t54 = t53 - 8.0 * zz_0
    E3_0 = dz_0 * t54
    t55 = 3.0 * xy_1
    t56 = t55 - 8.0 * zz_1
    E3_1 = dz_0 * t56 + dz_1 * t54
    t57 = 3.0 * xy_2
    t58 = t57 - 8.0 * zz_2
    E3_2 = dz_0 * t58 + dz_1 * t56 + dz_2 * t54
    t59 = 3.0 * xy_3
    E3_3 = dz_0 * (t59 - 8.0 * zz_3) + dz_1 * t58 + dz_2 * t56 + dz_3 * t54
    t60 = t53 - 3.0 * zz_0
    E4_0 = t60 * zz_0
    t61 = t55 - 3.0 * zz_1
    E4_1 = t60 * zz_1 + t61 * zz_0
    t62 = t57 - 3.0 * zz_2
    E4_2 = t60 * zz_2 + t61 * zz_1 + t62 * zz_0
    E4_3 = t60 * zz_3 + t61 * zz_2 + t62 * zz_1 + zz_0 * (t59 - 3.0 * zz_3)
    t63 = xy_0 * zz_0
    E5_0 = dz_0 * t63
    t64 = xy_0 * zz_1 + xy_1 * zz_0
    E5_1 = dz_0 * t64 + dz_1 * t63
    t65 = xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0
    E5_2 = dz_0 * t65 + dz_1 * t64 + dz_2 * t63
    E5_3 = dz_0 * (xy_0 * zz_3 + xy_1 * zz_2 + xy_2 * zz_1 + xy_3 * zz_0) + dz_1 * t65 + dz_2 * t64 + dz_3 * t63
    t66 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t66 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    t67 = 0.17307692307692307 * E2_1
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.21428571428571427 * E2_1 - E3_0 * t67 - E3_1 * t66 +
        0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    t68 = 0.17307692307692307 * E2_2
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 + 0.10227272727272728 * E2_1 * E2_1 - 0.21428571428571427 * E2_2 - E3_0 *
        t68 - E3_1 * t67 - E3_2 * t66 + 0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 +
        0.11538461538461539 * E5_2
    )
    series_3 = (
        0.20454545454545456 * E2_0 * E2_3 + 0.20454545454545456 * E2_1 * E2_2 - 0.17307692307692307 * E2_3 * E3_0 -
        0.21428571428571427 * E2_3 - E3_1 * t68 - E3_2 * t67 - E3_3 * t66 + 0.16666666666666666 * E3_3 -
        0.13636363636363635 * E4_3 + 0.11538461538461539 * E5_3
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0)
    sq3_0 = sq_half_0 * (over3_0 - 2.0 * sq1_0 * sq2_0)
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0
    power_3 = over1_0 * sq2_0 + over2_0 * sq1_0 + over3_0 * sq_0 + over_0 * sq3_0
    last_0 = power_0 * series_0
    last_1 = power_0 * series_1 + power_1 * series_0
    last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0
    last_3 = power_0 * series_3 + power_1 * series_2 + power_2 * series_1 + power_3 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    R_2 = (
        0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 * term32_0 +
        0.01171875 * term42_0 + 0.0029296875 * term52_0
    )
    R_3 = (
        0.000244140625 * last_3 + 3.0 * term03_0 + 0.75 * term13_0 + 0.1875 * term23_0 + 0.046875 * term33_0 +
        0.01171875 * term43_0 + 0.0029296875 * term53_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    x2_2 = x2 * x2
    V6 = 2.6666666666666665 * R_2 * third * x2_2
    x2_3 = x2 * x2_2
    V8 = -3.2000000000000002 * R_3 * third * x2_3
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    T3 = T * t1
    S_0 = (
        8.0 * T3 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    t69 = S_0 / c
    t70 = 2.5464790894703255 * beta
    t71 = 1.0 / root
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    c2 = c * c
    c3 = c * c2
    t72 = u_cr5 / c3
    t73 = t71 * t72
    A4 = A2 * A2
    t74 = 3.0 / A4
    A3 = A * A2
    root3 = root * root2
    c4 = c2 * c2
    c5 = c * c4
    return (
        A * t70 * (-V2 + t69) - A,
        -t70 * (A2 * V4 + V2 - t69) - 1.0,
        -t70 * (3.0 * A * (A2 * V6 + V4) - t73 / A3),
        -t70 * (3.0 * A2 * (5.0 * A2 * V8 + 6.0 * V6) + 3.0 * V4 + t73 * t74 + t2 * t72 / root3 - t71 * t74 * u_cr5
        / c5),
    )


def averaged(A, alpha, beta, u_cr):
    """h, h_A, h_AA, h_AAA together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_averaged_passed_0, _averaged_passed_0_steep, _averaged_passed_1, _averaged_passed_1_steep_far, _averaged_passed_1_steep)
    return by_regime(guards, bodies, arguments, 4)


def _averaged_3_passed_0(A, alpha, beta, u_cr):
    # operations: 83 structured, 75 common subexpressions, 75 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    t5 = e_3 * e_3
    t6 = 1.0 / a_4
    t7 = m * t6
    e_4 = 0.25 * t5 * t7
    e = e_1 + e_2 + e_3 + e_4
    tau = 16.0 * e_4 * e_4 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5
    P = t7 * (e + tau)
    B = t6 * (-m * tau + 1.0)
    C = 2.0 * t6 * tau
    t8 = 2.0 * beta
    t9 = A * t8
    t10 = 1.0 / k
    return (
        -A * alpha - P * t9,
        -alpha - t8 * (B * m * t10 - C * m + P),
        -t9 * (2.0 * B / (k * k) + C * t10),
    )


def _averaged_3_passed_0_steep(A, alpha, beta, u_cr):
    # operations: 139 structured, 123 common subexpressions, 123 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    b_4 = np.sqrt(a_3) * np.sqrt(b_3)
    t5 = e_3 * e_3
    e_4 = t3 * t5 / a_4
    a_5 = 0.5 * a_4 + 0.5 * b_4
    b_5 = np.sqrt(a_4) * np.sqrt(b_4)
    t6 = e_4 * e_4
    e_5 = t3 * t6 / a_5
    a_6 = 0.5 * a_5 + 0.5 * b_5
    b_6 = np.sqrt(a_5) * np.sqrt(b_5)
    t7 = e_5 * e_5
    e_6 = t3 * t7 / a_6
    a_7 = 0.5 * a_6 + 0.5 * b_6
    b_7 = np.sqrt(a_6) * np.sqrt(b_6)
    t8 = e_6 * e_6
    e_7 = t3 * t8 / a_7
    a_8 = 0.5 * a_7 + 0.5 * b_7
    t9 = e_7 * e_7
    t10 = 1.0 / a_8
    t11 = m * t10
    e_8 = 0.25 * t11 * t9
    e = e_1 + e_2 + e_3 + e_4 + e_5 + e_6 + e_7 + e_8
    tau = 256.0 * e_8 * e_8 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5 + 16.0 * t6 + 32.0 * t7 + 64.0 * t8 + 128.0 * t9
    P = t11 * (e + tau)
    B = t10 * (-m * tau + 1.0)
    C = 2.0 * t10 * tau
    t12 = 2.0 * beta
    t13 = A * t12
    t14 = 1.0 / k
    return (
        -A * alpha - P * t13,
        -alpha - t12 * (B * m * t14 - C * m + P),
        -t13 * (2.0 * B / (k * k) + C * t14),
    )


def _averaged_3_passed_1(A, alpha, beta, u_cr):
    # operations: 482 structured, 485 common subexpressions, 479 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    c = np.sqrt((1.0 - u_cr) * (u_cr + 1.0))
    T = u_cr / (A + root)
    t0 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0)
    A2 = A * A
    U2 = 4.0 * A2 * t0
    v2_1 = 0.99379661859049351 * g_1 * g_1
    square_1 = -U2 * v2_1 + 1.0
    delta_1 = np.sqrt(square_1)
    f_1 = 0.007968192496166605 * g_1 * v2_1 / delta_1
    t1 = 1.0 / square_1
    fall_1 = f_1 * t1 * v2_1
    v2_2 = 0.96760297675669993 * g_2 * g_2
    square_2 = -U2 * v2_2 + 1.0
    delta_2 = np.sqrt(square_2)
    f_2 = 0.018466468311090958 * g_2 * v2_2 / delta_2
    t2 = 1.0 / square_2
    fall_2 = f_2 * t2 * v2_2
    v2_3 = 0.92164198121722729 * g_3 * g_3
    square_3 = -U2 * v2_3 + 1.0
    delta_3 = np.sqrt(square_3)
    f_3 = 0.028784707883323369 * g_3 * v2_3 / delta_3
    t3 = 1.0 / square_3
    fall_3 = f_3 * t3 * v2_3
    v2_4 = 0.85784652785798998 * g_4 * g_4
    square_4 = -U2 * v2_4 + 1.0
    delta_4 = np.sqrt(square_4)
    f_4 = 0.03879919256962705 * g_4 * v2_4 / delta_4
    t4 = 1.0 / square_4
    fall_4 = f_4 * t4 * v2_4
    v2_5 = 0.77891309933755515 * g_5 * g_5
    square_5 = -U2 * v2_5 + 1.0
    delta_5 = np.sqrt(square_5)
    f_5 = 0.048402672830594053 * g_5 * v2_5 / delta_5
    t5 = 1.0 / square_5
    fall_5 = f_5 * t5 * v2_5
    v2_6 = 0.68817935411770381 * g_6 * g_6
    square_6 = -U2 * v2_6 + 1.0
    delta_6 = np.sqrt(square_6)
    f_6 = 0.057493156217619065 * g_6 * v2_6 / delta_6
    t6 = 1.0 / square_6
    fall_6 = f_6 * t6 * v2_6
    v2_7 = 0.58948218524948104 * g_7 * g_7
    square_7 = -U2 * v2_7 + 1.0
    delta_7 = np.sqrt(square_7)
    f_7 = 0.065974229882180491 * g_7 * v2_7 / delta_7
    t7 = 1.0 / square_7
    fall_7 = f_7 * t7 * v2_7
    v2_8 = 0.4869953130832757 * g_8 * g_8
    square_8 = -U2 * v2_8 + 1.0
    delta_8 = np.sqrt(square_8)
    f_8 = 0.073755974737705204 * g_8 * v2_8 / delta_8
    t8 = 1.0 / square_8
    fall_8 = f_8 * t8 * v2_8
    v2_9 = 0.38505274377519932 * g_9 * g_9
    square_9 = -U2 * v2_9 + 1.0
    delta_9 = np.sqrt(square_9)
    f_9 = 0.080755895229420213 * g_9 * v2_9 / delta_9
    t9 = 1.0 / square_9
    fall_9 = f_9 * t9 * v2_9
    v2_10 = 0.28796547636914854 * g_10 * g_10
    square_10 = -U2 * v2_10 + 1.0
    delta_10 = np.sqrt(square_10)
    f_10 = 0.086899787201082976 * g_10 * v2_10 / delta_10
    t10 = 1.0 / square_10
    fall_10 = f_10 * t10 * v2_10
    v2_11 = 0.19983919110743342 * g_11 * g_11
    square_11 = -U2 * v2_11 + 1.0
    delta_11 = np.sqrt(square_11)
    f_11 = 0.092122522237786122 * g_11 * v2_11 / delta_11
    t11 = 1.0 / square_11
    fall_11 = f_11 * t11 * v2_11
    v2_12 = 0.12440062341181206 * g_12 * g_12
    square_12 = -U2 * v2_12 + 1.0
    delta_12 = np.sqrt(square_12)
    f_12 = 0.096368737174644253 * g_12 * v2_12 / delta_12
    t12 = 1.0 / square_12
    fall_12 = f_12 * t12 * v2_12
    v2_13 = 0.064839964168231387 * g_13 * g_13
    square_13 = -U2 * v2_13 + 1.0
    delta_13 = np.sqrt(square_13)
    f_13 = 0.099593420586795267 * g_13 * v2_13 / delta_13
    t13 = 1.0 / square_13
    fall_13 = f_13 * t13 * v2_13
    v2_14 = 0.023675950313912963 * g_14 * g_14
    square_14 = -U2 * v2_14 + 1.0
    delta_14 = np.sqrt(square_14)
    f_14 = 0.1017623897484055 * g_14 * v2_14 / delta_14
    t14 = 1.0 / square_14
    fall_14 = f_14 * t14 * v2_14
    v2_15 = 0.0026493505760394136 * g_15 * g_15
    square_15 = -U2 * v2_15 + 1.0
    delta_15 = np.sqrt(square_15)
    f_15 = 0.10285265289355884 * g_15 * v2_15 / delta_15
    t15 = 1.0 / square_15
    fall_15 = f_15 * t15 * v2_15
    sum_0 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1) + f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0)
        * (g_10 * (0.53662414814201986 * t0 + 0.53662414814201986) + 1.0) / (c + delta_10) + f_11 * g_11 *
        (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 + 0.44703376953808915)
        + 1.0) / (c + delta_11) + f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 *
        (0.35270472553087812 * t0 + 0.35270472553087812) + 1.0) / (c + delta_12) + f_13 * g_13 * (0.7453630738321102
        - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 + 0.25463692616788985) + 1.0) / (c +
        delta_13) + f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 *
        t0 + 0.15386991360858354) + 1.0) / (c + delta_14) + f_15 * g_15 * (0.94852815744468233 -
        0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 + 0.051471842555317698) + 1.0) / (c +
        delta_15) + f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0
        + 0.98366812327974718) + 1.0) / (c + delta_2) + f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 *
        t0) * (g_3 * (0.96002186496830755 * t0 + 0.96002186496830755) + 1.0) / (c + delta_3) + f_4 * g_4 *
        (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 + 0.92620004742927431)
        + 1.0) / (c + delta_4) + f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 *
        (0.88256053579205274 * t0 + 0.88256053579205274) + 1.0) / (c + delta_5) + f_6 * g_6 * (0.17043423761723162 -
        0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 + 0.82956576238276836) + 1.0) / (c + delta_6) +
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7) + f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) *
        (g_8 * (0.69785049479331585 * t0 + 0.69785049479331585) + 1.0) / (c + delta_8) + f_9 * g_9 *
        (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 + 0.62052618298924289) +
        1.0) / (c + delta_9)
    )
    sum_1 = (
        fall_1 + fall_10 + fall_11 + fall_12 + fall_13 + fall_14 + fall_15 + fall_2 + fall_3 + fall_4 + fall_5 +
        fall_6 + fall_7 + fall_8 + fall_9
    )
    sum_2 = (
        fall_1 * t1 + fall_10 * t10 + fall_11 * t11 + fall_12 * t12 + fall_13 * t13 + fall_14 * t14 + fall_15 * t15
        + fall_2 * t2 + fall_3 * t3 + fall_4 * t4 + fall_5 * t5 + fall_6 * t6 + fall_7 * t7 + fall_8 * t8 + fall_9 *
        t9
    )
    t16 = 0.31830988618379069 * beta
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    t17 = T3 * sum_0 * u_cr2 / c
    T4 = t0 * t0
    T5 = T * T4
    t18 = 8.0 * t16
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    A3 = A * A2
    c2 = c * c
    c3 = c * c2
    return (
        64.0 * A * t16 * t17 - A,
        -t18 * (32.0 * A2 * T5 * sum_1 - 8.0 * t17) - 1.0,
        -t18 * (96.0 * A * T5 * sum_2 - u_cr5 / (A3 * c3 * root)),
    )


def _averaged_3_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 1108 structured, 979 common subexpressions, 978 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    t2 = 0.99379661859049351 * t1
    g_1 = 1.0 / (t2 + 1.0)
    t3 = 0.96760297675669993 * t1
    g_2 = 1.0 / (t3 + 1.0)
    t4 = 0.92164198121722729 * t1
    g_3 = 1.0 / (t4 + 1.0)
    t5 = 0.85784652785798998 * t1
    g_4 = 1.0 / (t5 + 1.0)
    t6 = 0.77891309933755515 * t1
    g_5 = 1.0 / (t6 + 1.0)
    t7 = 0.68817935411770381 * t1
    g_6 = 1.0 / (t7 + 1.0)
    t8 = 0.58948218524948104 * t1
    g_7 = 1.0 / (t8 + 1.0)
    t9 = 0.4869953130832757 * t1
    g_8 = 1.0 / (t9 + 1.0)
    t10 = 0.38505274377519932 * t1
    g_9 = 1.0 / (t10 + 1.0)
    t11 = 0.28796547636914854 * t1
    g_10 = 1.0 / (t11 + 1.0)
    t12 = 0.19983919110743342 * t1
    g_11 = 1.0 / (t12 + 1.0)
    t13 = 0.12440062341181206 * t1
    g_12 = 1.0 / (t13 + 1.0)
    t14 = 0.064839964168231387 * t1
    g_13 = 1.0 / (t14 + 1.0)
    t15 = 0.023675950313912963 * t1
    g_14 = 1.0 / (t15 + 1.0)
    t16 = 0.0026493505760394136 * t1
    g_15 = 1.0 / (t16 + 1.0)
    t17 = 1.0 / (A * A)
    x2 = t17 * u_cr * u_cr
    y2 = root * root * t17
    t18 = 1.0 / A
    third = 0.33333333333333331 * t18 * u_cr * x2
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    a0_half_0_2 = a0_half_0 * a0_half_0
    a0_half_0_3 = a0_half_0 * a0_half_0_2
    a02_0 = -a0_half_0_3
    b0_0 = np.sqrt(t0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    lam0_2 = a02_0 * b0_0 + a02_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    t19 = 0.25 * lam0_0
    X0_0 = t19 + 0.25 * y2
    t20 = 0.25 * lam0_1
    X0_1 = t20 + 0.25
    t21 = 0.25 * lam0_2
    Y0_0 = 0.25 * t0 + t19
    Z0_0 = t19 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (-a11_0 * a11_0 + t21)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = b1_half_0 * t20
    b12_0 = b1_half_0 * (-b11_0 * b11_0 + t21)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t20
    c12_0 = c1_half_0 * (-c11_0 * c11_0 + t21)
    t22 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t22
    t23 = a11_0 + b11_0
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t22 + c1_0 * t23
    lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * t23 + c12_0 * t22 + c1_0 * (a12_0 + b12_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t20
    q1_2 = lam1_2 + t21
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    t24 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t24
    t25 = 0.25 * lam1_1
    X1_1 = 0.25 * X0_1 + t25
    t26 = 0.25 * lam1_2
    X1_2 = 0.25 * t21 + t26
    Y1_0 = 0.25 * Y0_0 + t24
    Y1_1 = 0.25 * t20 + t25
    Y1_2 = 0.25 * t21 + t26
    Z1_0 = 0.25 * Z0_0 + t24
    Z1_1 = 0.25 * t20 + t25
    Z1_2 = 0.25 * t21 + t26
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0)
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0)
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0)
    t27 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t27
    t28 = a21_0 + b21_0
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t27 + c2_0 * t28
    lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * t28 + c22_0 * t27 + c2_0 * (a22_0 + b22_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    t29 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t29
    t30 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t30
    t31 = 0.25 * lam2_2
    X2_2 = 0.25 * X1_2 + t31
    Y2_0 = 0.25 * Y1_0 + t29
    Y2_1 = 0.25 * Y1_1 + t30
    Y2_2 = 0.25 * Y1_2 + t31
    Z2_0 = 0.25 * Z1_0 + t29
    Z2_1 = 0.25 * Z1_1 + t30
    Z2_2 = 0.25 * Z1_2 + t31
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0)
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0)
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0)
    t32 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t32
    t33 = a31_0 + b31_0
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t32 + c3_0 * t33
    lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * t33 + c32_0 * t32 + c3_0 * (a32_0 + b32_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    t34 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t34
    t35 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t35
    t36 = 0.25 * lam3_2
    X3_2 = 0.25 * X2_2 + t36
    Y3_0 = 0.25 * Y2_0 + t34
    Y3_1 = 0.25 * Y2_1 + t35
    Y3_2 = 0.25 * Y2_2 + t36
    Z3_0 = 0.25 * Z2_0 + t34
    Z3_1 = 0.25 * Z2_1 + t35
    Z3_2 = 0.25 * Z2_2 + t36
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0)
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0)
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0)
    t37 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t37
    t38 = a41_0 + b41_0
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t37 + c4_0 * t38
    lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * t38 + c42_0 * t37 + c4_0 * (a42_0 + b42_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    t39 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t39
    t40 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t40
    t41 = 0.25 * lam4_2
    X4_2 = 0.25 * X3_2 + t41
    Y4_0 = 0.25 * Y3_0 + t39
    Y4_1 = 0.25 * Y3_1 + t40
    Y4_2 = 0.25 * Y3_2 + t41
    Z4_0 = 0.25 * Z3_0 + t39
    Z4_1 = 0.25 * Z3_1 + t40
    Z4_2 = 0.25 * Z3_2 + t41
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0)
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0)
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0)
    t42 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t42
    t43 = a51_0 + b51_0
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t42 + c5_0 * t43
    lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * t43 + c52_0 * t42 + c5_0 * (a52_0 + b52_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    t44 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t44
    t45 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t45
    t46 = 0.25 * lam5_2
    X5_2 = 0.25 * X4_2 + t46
    Y5_0 = 0.25 * Y4_0 + t44
    Y5_1 = 0.25 * Y4_1 + t45
    Y5_2 = 0.25 * Y4_2 + t46
    Z5_0 = 0.25 * Z4_0 + t44
    Z5_1 = 0.25 * Z4_1 + t45
    Z5_2 = 0.25 * Z4_2 + t46
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    t47 = -mean_0
    t48 = -X5_0 - t47
    dx_0 = over_0 * t48
    t49 = -mean_1
    t50 = -X5_1 - t49
    dx_1 = over1_0 * t48 + over_0 * t50
    t51 = -mean_2
    dx_2 = over1_0 * t50 + over2_0 * t48 + over_0 * (-X5_2 - t51)
    t52 = -Y5_0 - t47
    dy_0 = over_0 * t52
    t53 = -Y5_1 - t49
    dy_1 = over1_0 * t52 + over_0 * t53
    dy_2 = over1_0 * t53 + over2_0 * t52 + over_0 * (-Y5_2 - t51)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    zz_0 = dz_0 * dz_0
    t54 = 2.0 * dz_0
    zz_1 = dz_1 * t54
    zz_2 = dz_1 * dz_1 + dz_2 * t54
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    t55 = 3.0 * xy_0
    t56 = t55 - 8.0 * zz_0
    E3_0 = dz_0 * t56
    t57 = 3.0 * xy_1
    t58 = t57 - 8.0 * zz_1
    E3_1 = dz_0 * t58 + dz_1 * t56
    t59 = 3.0 * xy_2
    E3_2 = dz_0 * (t59 - 8.0 * zz_2) + dz_1 * t58 + dz_2 * t56
    t60 = t55 - 3.0 * zz_0
    E4_0 = t60 * zz_0
    t61 = t57 - 3.0 * zz_1
    E4_1 = t60 * zz_1 + t61 * zz_0
    E4_2 = t60 * zz_2 + t61 * zz_1 + zz_0 * (t59 - 3.0 * zz_2)
    t62 = xy_0 * zz_0
    E5_0 = dz_0 * t62
    t63 = xy_0 * zz_1 + xy_1 * zz_0
    E5_1 = dz_0 * t63 + dz_1 * t62
    E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * t63 + dz_2 * t62
    t64 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t64 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    t65 = 0.17307692307692307 * E2_1
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.21428571428571427 * E2_1 - E3_0 * t65 - E3_1 * t64 +
        0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 + 0.10227272727272728 * E2_1 * E2_1 - 0.17307692307692307 * E2_2 * E3_0 -
        0.21428571428571427 * E2_2 - E3_1 * t65 - E3_2 * t64 + 0.16666666666666666 * E3_2 - 0.13636363636363635 *
        E4_2 + 0.11538461538461539 * E5_2
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0)
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0
    last_0 = power_0 * series_0
    last_1 = power_0 * series_1 + power_1 * series_0
    last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    R_2 = (
        0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 * term32_0 +
        0.01171875 * term42_0 + 0.0029296875 * term52_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    V6 = 2.6666666666666665 * R_2 * third * x2 * x2
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    t66 = 1.0 - t2
    tangent_1 = 3.975186474361974 * t1 / (t66 * t66)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t67 = 1.0 - t3
    tangent_2 = 3.8704119070267997 * t1 / (t67 * t67)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t68 = 1.0 - t4
    tangent_3 = 3.6865679248689092 * t1 / (t68 * t68)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t69 = 1.0 - t5
    tangent_4 = 3.4313861114319599 * t1 / (t69 * t69)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t70 = 1.0 - t6
    tangent_5 = 3.1156523973502206 * t1 / (t70 * t70)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t71 = 1.0 - t7
    tangent_6 = 2.7527174164708152 * t1 / (t71 * t71)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t72 = 1.0 - t8
    tangent_7 = 2.3579287409979242 * t1 / (t72 * t72)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t73 = 1.0 - t9
    tangent_8 = 1.9479812523331028 * t1 / (t73 * t73)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t74 = 1.0 - t10
    tangent_9 = 1.5402109751007973 * t1 / (t74 * t74)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t75 = 1.0 - t11
    tangent_10 = 1.1518619054765942 * t1 / (t75 * t75)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t76 = 1.0 - t12
    tangent_11 = 0.79935676442973369 * t1 / (t76 * t76)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t77 = 1.0 - t13
    tangent_12 = 0.49760249364724823 * t1 / (t77 * t77)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t78 = 1.0 - t14
    tangent_13 = 0.25935985667292555 * t1 / (t78 * t78)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t79 = 1.0 - t15
    tangent_14 = 0.094703801255651851 * t1 / (t79 * t79)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t80 = 1.0 - t16
    tangent_15 = 0.010597402304157654 * t1 / (t80 * t80)
    T3 = T * t1
    t81 = 8.0 * T3
    S_0 = (
        t81 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    S_1 = (
        t81 * (tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13
        * term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 +
        tangent_4 * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 +
        tangent_9 * term_9)
    )
    S_2 = (
        t81 * (tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 * tangent_11 *
        term_11 + tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 * tangent_14 *
        term_14 + tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 * tangent_3 *
        term_3 + tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6 * term_6 +
        tangent_7 * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9)
    )
    t82 = 1.0 / c
    t83 = S_0 * t82
    t84 = 2.5464790894703255 * beta
    t85 = S_1 * t82
    return (
        A * t84 * (-V2 + t83) - A,
        t84 * (2.0 * V2 + V4 - 2.0 * t83 - t85) - 1.0,
        t18 * t84 * (3.0 * S_2 * t82 - 6.0 * V2 - 7.0 * V4 - 3.0 * V6 + 6.0 * t83 + 7.0 * t85),
    )


def _averaged_3_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 937 structured, 842 common subexpressions, 838 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t1 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t1 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t1 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t1 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t1 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t1 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t1 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t1 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t1 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t1 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t1 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t1 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t1 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t1 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t1 + 1.0)
    A2 = A * A
    t2 = 1.0 / A2
    u_cr2 = u_cr * u_cr
    x2 = t2 * u_cr2
    y2 = root * root * t2
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(t0)
    b0_half_0 = 0.5 / b0_0
    b0_half_0_2 = b0_half_0 * b0_half_0
    b0_half_0_3 = b0_half_0 * b0_half_0_2
    b02_0 = -b0_half_0_3
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_0 * b0_half_0 + b0_half_0
    lam0_2 = a0_0 * b02_0 + b02_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    t3 = 0.25 * lam0_0
    X0_0 = t3 + 0.25 * y2
    t4 = 0.25 * lam0_1
    t5 = 0.25 * lam0_2
    Y0_0 = 0.25 * t0 + t3
    Y0_1 = t4 + 0.25
    Z0_0 = t3 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = a1_half_0 * t4
    a12_0 = a1_half_0 * (-a11_0 * a11_0 + t5)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (-b11_0 * b11_0 + t5)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t4
    c12_0 = c1_half_0 * (-c11_0 * c11_0 + t5)
    t6 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t6
    t7 = a11_0 + b11_0
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t6 + c1_0 * t7
    lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * t7 + c12_0 * t6 + c1_0 * (a12_0 + b12_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t4
    q1_2 = lam1_2 + t5
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    t8 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t8
    t9 = 0.25 * lam1_1
    X1_1 = 0.25 * t4 + t9
    t10 = 0.25 * lam1_2
    X1_2 = t10 + 0.25 * t5
    Y1_0 = 0.25 * Y0_0 + t8
    Y1_1 = 0.25 * Y0_1 + t9
    Y1_2 = t10 + 0.25 * t5
    Z1_0 = 0.25 * Z0_0 + t8
    Z1_1 = 0.25 * t4 + t9
    Z1_2 = t10 + 0.25 * t5
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0)
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0)
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0)
    t11 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t11
    t12 = a21_0 + b21_0
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t11 + c2_0 * t12
    lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * t12 + c22_0 * t11 + c2_0 * (a22_0 + b22_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    t13 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t13
    t14 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t14
    t15 = 0.25 * lam2_2
    X2_2 = 0.25 * X1_2 + t15
    Y2_0 = 0.25 * Y1_0 + t13
    Y2_1 = 0.25 * Y1_1 + t14
    Y2_2 = 0.25 * Y1_2 + t15
    Z2_0 = 0.25 * Z1_0 + t13
    Z2_1 = 0.25 * Z1_1 + t14
    Z2_2 = 0.25 * Z1_2 + t15
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0)
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0)
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0)
    t16 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t16
    t17 = a31_0 + b31_0
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t16 + c3_0 * t17
    lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * t17 + c32_0 * t16 + c3_0 * (a32_0 + b32_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    t18 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t18
    t19 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t19
    t20 = 0.25 * lam3_2
    X3_2 = 0.25 * X2_2 + t20
    Y3_0 = 0.25 * Y2_0 + t18
    Y3_1 = 0.25 * Y2_1 + t19
    Y3_2 = 0.25 * Y2_2 + t20
    Z3_0 = 0.25 * Z2_0 + t18
    Z3_1 = 0.25 * Z2_1 + t19
    Z3_2 = 0.25 * Z2_2 + t20
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0)
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0)
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0)
    t21 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t21
    t22 = a41_0 + b41_0
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t21 + c4_0 * t22
    lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * t22 + c42_0 * t21 + c4_0 * (a42_0 + b42_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    t23 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t23
    t24 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t24
    t25 = 0.25 * lam4_2
    X4_2 = 0.25 * X3_2 + t25
    Y4_0 = 0.25 * Y3_0 + t23
    Y4_1 = 0.25 * Y3_1 + t24
    Y4_2 = 0.25 * Y3_2 + t25
    Z4_0 = 0.25 * Z3_0 + t23
    Z4_1 = 0.25 * Z3_1 + t24
    Z4_2 = 0.25 * Z3_2 + t25
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0)
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0)
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0)
    t26 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t26
    t27 = a51_0 + b51_0
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t26 + c5_0 * t27
    lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * t27 + c52_0 * t26 + c5_0 * (a52_0 + b52_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    t28 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t28
    t29 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t29
    t30 = 0.25 * lam5_2
    X5_2 = 0.25 * X4_2 + t30
    Y5_0 = 0.25 * Y4_0 + t28
    Y5_1 = 0.25 * Y4_1 + t29
    Y5_2 = 0.25 * Y4_2 + t30
    Z5_0 = 0.25 * Z4_0 + t28
    Z5_1 = 0.25 * Z4_1 + t29
    Z5_2 = 0.25 * Z4_2 + t30
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    t31 = -mean_0
    t32 = -X5_0 - t31
    dx_0 = over_0 * t32
    t33 = -mean_1
    t34 = -X5_1 - t33
    dx_1 = over1_0 * t32 + over_0 * t34
    t35 = -mean_2
    dx_2 = over1_0 * t34 + over2_0 * t32 + over_0 * (-X5_2 - t35)
    t36 = -Y5_0 - t31
    dy_0 = over_0 * t36
    t37 = -Y5_1 - t33
    dy_1 = over1_0 * t36 + over_0 * t37
    dy_2 = over1_0 * t37 + over2_0 * t36 + over_0 * (-Y5_2 - t35)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    zz_0 = dz_0 * dz_0
    t38 = 2.0 * dz_0
    zz_1 = dz_1 * t38
    zz_2 = dz_1 * dz_1 + dz_2 * t38
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    t39 = 3.0 * xy_0
    t40 = t39 - 8.0 * zz_0
    E3_0 = dz_0 * t40
    t41 = 3.0 * xy_1
    t42 = t41 - 8.0 * zz_1
    E3_1 = dz_0 * t42 + dz_1 * t40
    t43 = 3.0 * xy_2
    E3_2 = dz_0 * (t43 - 8.0 * zz_2) + dz_1 * t42 + dz_2 * t40
    t44 = t39 - 3.0 * zz_0
    E4_0 = t44 * zz_0
    t45 = t41 - 3.0 * zz_1
    E4_1 = t44 * zz_1 + t45 * zz_0
    E4_2 = t44 * zz_2 + t45 * zz_1 + zz_0 * (t43 - 3.0 * zz_2)
    t46 = xy_0 * zz_0
    E5_0 = dz_0 * t46
    t47 = xy_0 * zz_1 + xy_1 * zz_0
    E5_1 = dz_0 * t47 + dz_1 * t46
    E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * t47 + dz_2 * t46
    t48 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t48 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    t49 = 0.17307692307692307 * E2_1
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.21428571428571427 * E2_1 - E3_0 * t49 - E3_1 * t48 +
        0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 + 0.10227272727272728 * E2_1 * E2_1 - 0.17307692307692307 * E2_2 * E3_0 -
        0.21428571428571427 * E2_2 - E3_1 * t49 - E3_2 * t48 + 0.16666666666666666 * E3_2 - 0.13636363636363635 *
        E4_2 + 0.11538461538461539 * E5_2
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0)
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0
    last_0 = power_0 * series_0
    last_1 = power_0 * series_1 + power_1 * series_0
    last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    R_2 = (
        0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 * term32_0 +
        0.01171875 * term42_0 + 0.0029296875 * term52_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    V6 = 2.6666666666666665 * R_2 * third * x2 * x2
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    T3 = T * t1
    S_0 = (
        8.0 * T3 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    t50 = S_0 / c
    t51 = 2.5464790894703255 * beta
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    A3 = A * A2
    c2 = c * c
    c3 = c * c2
    return (
        A * t51 * (-V2 + t50) - A,
        -t51 * (A2 * V4 + V2 - t50) - 1.0,
        -t51 * (3.0 * A * (A2 * V6 + V4) - u_cr5 / (A3 * c3 * root)),
    )


def averaged_3(A, alpha, beta, u_cr):
    """h, h_A, h_AA together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_averaged_3_passed_0, _averaged_3_passed_0_steep, _averaged_3_passed_1, _averaged_3_passed_1_steep_far, _averaged_3_passed_1_steep)
    return by_regime(guards, bodies, arguments, 3)


def _averaged_2_passed_0(A, alpha, beta, u_cr):
    # operations: 75 structured, 68 common subexpressions, 68 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    t5 = e_3 * e_3
    t6 = 1.0 / a_4
    t7 = m * t6
    e_4 = 0.25 * t5 * t7
    e = e_1 + e_2 + e_3 + e_4
    tau = 16.0 * e_4 * e_4 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5
    P = t7 * (e + tau)
    B = t6 * (-m * tau + 1.0)
    C = 2.0 * t6 * tau
    t8 = 2.0 * beta
    return (
        -A * P * t8 - A * alpha,
        -alpha - t8 * (B * m / k - C * m + P),
    )


def _averaged_2_passed_0_steep(A, alpha, beta, u_cr):
    # operations: 131 structured, 116 common subexpressions, 116 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    b_4 = np.sqrt(a_3) * np.sqrt(b_3)
    t5 = e_3 * e_3
    e_4 = t3 * t5 / a_4
    a_5 = 0.5 * a_4 + 0.5 * b_4
    b_5 = np.sqrt(a_4) * np.sqrt(b_4)
    t6 = e_4 * e_4
    e_5 = t3 * t6 / a_5
    a_6 = 0.5 * a_5 + 0.5 * b_5
    b_6 = np.sqrt(a_5) * np.sqrt(b_5)
    t7 = e_5 * e_5
    e_6 = t3 * t7 / a_6
    a_7 = 0.5 * a_6 + 0.5 * b_6
    b_7 = np.sqrt(a_6) * np.sqrt(b_6)
    t8 = e_6 * e_6
    e_7 = t3 * t8 / a_7
    a_8 = 0.5 * a_7 + 0.5 * b_7
    t9 = e_7 * e_7
    t10 = 1.0 / a_8
    t11 = m * t10
    e_8 = 0.25 * t11 * t9
    e = e_1 + e_2 + e_3 + e_4 + e_5 + e_6 + e_7 + e_8
    tau = 256.0 * e_8 * e_8 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5 + 16.0 * t6 + 32.0 * t7 + 64.0 * t8 + 128.0 * t9
    P = t11 * (e + tau)
    B = t10 * (-m * tau + 1.0)
    C = 2.0 * t10 * tau
    t12 = 2.0 * beta
    return (
        -A * P * t12 - A * alpha,
        -alpha - t12 * (B * m / k - C * m + P),
    )


def _averaged_2_passed_1(A, alpha, beta, u_cr):
    # operations: 432 structured, 425 common subexpressions, 422 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    c = np.sqrt((1.0 - u_cr) * (u_cr + 1.0))
    T = u_cr / (A + root)
    t0 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0)
    t1 = A * A
    U2 = 4.0 * t0 * t1
    v2_1 = 0.99379661859049351 * g_1 * g_1
    square_1 = -U2 * v2_1 + 1.0
    delta_1 = np.sqrt(square_1)
    f_1 = 0.007968192496166605 * g_1 * v2_1 / delta_1
    fall_1 = f_1 * v2_1 / square_1
    v2_2 = 0.96760297675669993 * g_2 * g_2
    square_2 = -U2 * v2_2 + 1.0
    delta_2 = np.sqrt(square_2)
    f_2 = 0.018466468311090958 * g_2 * v2_2 / delta_2
    fall_2 = f_2 * v2_2 / square_2
    v2_3 = 0.92164198121722729 * g_3 * g_3
    square_3 = -U2 * v2_3 + 1.0
    delta_3 = np.sqrt(square_3)
    f_3 = 0.028784707883323369 * g_3 * v2_3 / delta_3
    fall_3 = f_3 * v2_3 / square_3
    v2_4 = 0.85784652785798998 * g_4 * g_4
    square_4 = -U2 * v2_4 + 1.0
    delta_4 = np.sqrt(square_4)
    f_4 = 0.03879919256962705 * g_4 * v2_4 / delta_4
    fall_4 = f_4 * v2_4 / square_4
    v2_5 = 0.77891309933755515 * g_5 * g_5
    square_5 = -U2 * v2_5 + 1.0
    delta_5 = np.sqrt(square_5)
    f_5 = 0.048402672830594053 * g_5 * v2_5 / delta_5
    fall_5 = f_5 * v2_5 / square_5
    v2_6 = 0.68817935411770381 * g_6 * g_6
    square_6 = -U2 * v2_6 + 1.0
    delta_6 = np.sqrt(square_6)
    f_6 = 0.057493156217619065 * g_6 * v2_6 / delta_6
    fall_6 = f_6 * v2_6 / square_6
    v2_7 = 0.58948218524948104 * g_7 * g_7
    square_7 = -U2 * v2_7 + 1.0
    delta_7 = np.sqrt(square_7)
    f_7 = 0.065974229882180491 * g_7 * v2_7 / delta_7
    fall_7 = f_7 * v2_7 / square_7
    v2_8 = 0.4869953130832757 * g_8 * g_8
    square_8 = -U2 * v2_8 + 1.0
    delta_8 = np.sqrt(square_8)
    f_8 = 0.073755974737705204 * g_8 * v2_8 / delta_8
    fall_8 = f_8 * v2_8 / square_8
    v2_9 = 0.38505274377519932 * g_9 * g_9
    square_9 = -U2 * v2_9 + 1.0
    delta_9 = np.sqrt(square_9)
    f_9 = 0.080755895229420213 * g_9 * v2_9 / delta_9
    fall_9 = f_9 * v2_9 / square_9
    v2_10 = 0.28796547636914854 * g_10 * g_10
    square_10 = -U2 * v2_10 + 1.0
    delta_10 = np.sqrt(square_10)
    f_10 = 0.086899787201082976 * g_10 * v2_10 / delta_10
    fall_10 = f_10 * v2_10 / square_10
    v2_11 = 0.19983919110743342 * g_11 * g_11
    square_11 = -U2 * v2_11 + 1.0
    delta_11 = np.sqrt(square_11)
    f_11 = 0.092122522237786122 * g_11 * v2_11 / delta_11
    fall_11 = f_11 * v2_11 / square_11
    v2_12 = 0.12440062341181206 * g_12 * g_12
    square_12 = -U2 * v2_12 + 1.0
    delta_12 = np.sqrt(square_12)
    f_12 = 0.096368737174644253 * g_12 * v2_12 / delta_12
    fall_12 = f_12 * v2_12 / square_12
    v2_13 = 0.064839964168231387 * g_13 * g_13
    square_13 = -U2 * v2_13 + 1.0
    delta_13 = np.sqrt(square_13)
    f_13 = 0.099593420586795267 * g_13 * v2_13 / delta_13
    fall_13 = f_13 * v2_13 / square_13
    v2_14 = 0.023675950313912963 * g_14 * g_14
    square_14 = -U2 * v2_14 + 1.0
    delta_14 = np.sqrt(square_14)
    f_14 = 0.1017623897484055 * g_14 * v2_14 / delta_14
    fall_14 = f_14 * v2_14 / square_14
    v2_15 = 0.0026493505760394136 * g_15 * g_15
    square_15 = -U2 * v2_15 + 1.0
    delta_15 = np.sqrt(square_15)
    f_15 = 0.10285265289355884 * g_15 * v2_15 / delta_15
    fall_15 = f_15 * v2_15 / square_15
    sum_0 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1) + f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0)
        * (g_10 * (0.53662414814201986 * t0 + 0.53662414814201986) + 1.0) / (c + delta_10) + f_11 * g_11 *
        (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 + 0.44703376953808915)
        + 1.0) / (c + delta_11) + f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 *
        (0.35270472553087812 * t0 + 0.35270472553087812) + 1.0) / (c + delta_12) + f_13 * g_13 * (0.7453630738321102
        - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 + 0.25463692616788985) + 1.0) / (c +
        delta_13) + f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 *
        t0 + 0.15386991360858354) + 1.0) / (c + delta_14) + f_15 * g_15 * (0.94852815744468233 -
        0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 + 0.051471842555317698) + 1.0) / (c +
        delta_15) + f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0
        + 0.98366812327974718) + 1.0) / (c + delta_2) + f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 *
        t0) * (g_3 * (0.96002186496830755 * t0 + 0.96002186496830755) + 1.0) / (c + delta_3) + f_4 * g_4 *
        (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 + 0.92620004742927431)
        + 1.0) / (c + delta_4) + f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 *
        (0.88256053579205274 * t0 + 0.88256053579205274) + 1.0) / (c + delta_5) + f_6 * g_6 * (0.17043423761723162 -
        0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 + 0.82956576238276836) + 1.0) / (c + delta_6) +
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7) + f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) *
        (g_8 * (0.69785049479331585 * t0 + 0.69785049479331585) + 1.0) / (c + delta_8) + f_9 * g_9 *
        (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 + 0.62052618298924289) +
        1.0) / (c + delta_9)
    )
    sum_1 = (
        fall_1 + fall_10 + fall_11 + fall_12 + fall_13 + fall_14 + fall_15 + fall_2 + fall_3 + fall_4 + fall_5 +
        fall_6 + fall_7 + fall_8 + fall_9
    )
    t2 = 0.31830988618379069 * beta
    T3 = T * t0
    t3 = T3 * sum_0 * u_cr * u_cr / c
    T4 = t0 * t0
    T5 = T * T4
    return (
        64.0 * A * t2 * t3 - A,
        -8.0 * t2 * (32.0 * T5 * sum_1 * t1 - 8.0 * t3) - 1.0,
    )


def _averaged_2_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 689 structured, 611 common subexpressions, 610 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    t2 = 0.99379661859049351 * t1
    g_1 = 1.0 / (t2 + 1.0)
    t3 = 0.96760297675669993 * t1
    g_2 = 1.0 / (t3 + 1.0)
    t4 = 0.92164198121722729 * t1
    g_3 = 1.0 / (t4 + 1.0)
    t5 = 0.85784652785798998 * t1
    g_4 = 1.0 / (t5 + 1.0)
    t6 = 0.77891309933755515 * t1
    g_5 = 1.0 / (t6 + 1.0)
    t7 = 0.68817935411770381 * t1
    g_6 = 1.0 / (t7 + 1.0)
    t8 = 0.58948218524948104 * t1
    g_7 = 1.0 / (t8 + 1.0)
    t9 = 0.4869953130832757 * t1
    g_8 = 1.0 / (t9 + 1.0)
    t10 = 0.38505274377519932 * t1
    g_9 = 1.0 / (t10 + 1.0)
    t11 = 0.28796547636914854 * t1
    g_10 = 1.0 / (t11 + 1.0)
    t12 = 0.19983919110743342 * t1
    g_11 = 1.0 / (t12 + 1.0)
    t13 = 0.12440062341181206 * t1
    g_12 = 1.0 / (t13 + 1.0)
    t14 = 0.064839964168231387 * t1
    g_13 = 1.0 / (t14 + 1.0)
    t15 = 0.023675950313912963 * t1
    g_14 = 1.0 / (t15 + 1.0)
    t16 = 0.0026493505760394136 * t1
    g_15 = 1.0 / (t16 + 1.0)
    t17 = 1.0 / (A * A)
    x2 = t17 * u_cr * u_cr
    y2 = root * root * t17
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    b0_0 = np.sqrt(t0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    t18 = 0.25 * lam0_0
    X0_0 = t18 + 0.25 * y2
    t19 = 0.25 * lam0_1
    X0_1 = t19 + 0.25
    Y0_0 = 0.25 * t0 + t18
    Z0_0 = t18 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = b1_half_0 * t19
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t19
    t20 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t20
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t20 + c1_0 * (a11_0 + b11_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t19
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    t21 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t21
    t22 = 0.25 * lam1_1
    X1_1 = 0.25 * X0_1 + t22
    Y1_0 = 0.25 * Y0_0 + t21
    Y1_1 = 0.25 * t19 + t22
    Z1_0 = 0.25 * Z0_0 + t21
    Z1_1 = 0.25 * t19 + t22
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    t23 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t23
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t23 + c2_0 * (a21_0 + b21_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    t24 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t24
    t25 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t25
    Y2_0 = 0.25 * Y1_0 + t24
    Y2_1 = 0.25 * Y1_1 + t25
    Z2_0 = 0.25 * Z1_0 + t24
    Z2_1 = 0.25 * Z1_1 + t25
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    t26 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t26
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t26 + c3_0 * (a31_0 + b31_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    t27 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t27
    t28 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t28
    Y3_0 = 0.25 * Y2_0 + t27
    Y3_1 = 0.25 * Y2_1 + t28
    Z3_0 = 0.25 * Z2_0 + t27
    Z3_1 = 0.25 * Z2_1 + t28
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    t29 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t29
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t29 + c4_0 * (a41_0 + b41_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    t30 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t30
    t31 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t31
    Y4_0 = 0.25 * Y3_0 + t30
    Y4_1 = 0.25 * Y3_1 + t31
    Z4_0 = 0.25 * Z3_0 + t30
    Z4_1 = 0.25 * Z3_1 + t31
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    t32 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t32
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t32 + c5_0 * (a51_0 + b51_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    t33 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t33
    t34 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t34
    Y5_0 = 0.25 * Y4_0 + t33
    Y5_1 = 0.25 * Y4_1 + t34
    Z5_0 = 0.25 * Z4_0 + t33
    Z5_1 = 0.25 * Z4_1 + t34
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    t35 = -mean_0
    t36 = -X5_0 - t35
    dx_0 = over_0 * t36
    t37 = -mean_1
    dx_1 = over1_0 * t36 + over_0 * (-X5_1 - t37)
    t38 = -Y5_0 - t35
    dy_0 = over_0 * t38
    dy_1 = over1_0 * t38 + over_0 * (-Y5_1 - t37)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    t39 = 3.0 * xy_0
    t40 = t39 - 8.0 * zz_0
    E3_0 = dz_0 * t40
    t41 = 3.0 * xy_1
    E3_1 = dz_0 * (t41 - 8.0 * zz_1) + dz_1 * t40
    t42 = t39 - 3.0 * zz_0
    E4_0 = t42 * zz_0
    E4_1 = t42 * zz_1 + zz_0 * (t41 - 3.0 * zz_1)
    t43 = xy_0 * zz_0
    E5_0 = dz_0 * t43
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * t43
    t44 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t44 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 - E3_1 *
        t44 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    last_0 = power_0 * series_0
    last_1 = power_0 * series_1 + power_1 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    t45 = 1.0 - t2
    tangent_1 = 3.975186474361974 * t1 / (t45 * t45)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t46 = 1.0 - t3
    tangent_2 = 3.8704119070267997 * t1 / (t46 * t46)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t47 = 1.0 - t4
    tangent_3 = 3.6865679248689092 * t1 / (t47 * t47)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t48 = 1.0 - t5
    tangent_4 = 3.4313861114319599 * t1 / (t48 * t48)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t49 = 1.0 - t6
    tangent_5 = 3.1156523973502206 * t1 / (t49 * t49)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t50 = 1.0 - t7
    tangent_6 = 2.7527174164708152 * t1 / (t50 * t50)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t51 = 1.0 - t8
    tangent_7 = 2.3579287409979242 * t1 / (t51 * t51)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t52 = 1.0 - t9
    tangent_8 = 1.9479812523331028 * t1 / (t52 * t52)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t53 = 1.0 - t10
    tangent_9 = 1.5402109751007973 * t1 / (t53 * t53)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t54 = 1.0 - t11
    tangent_10 = 1.1518619054765942 * t1 / (t54 * t54)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t55 = 1.0 - t12
    tangent_11 = 0.79935676442973369 * t1 / (t55 * t55)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t56 = 1.0 - t13
    tangent_12 = 0.49760249364724823 * t1 / (t56 * t56)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t57 = 1.0 - t14
    tangent_13 = 0.25935985667292555 * t1 / (t57 * t57)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t58 = 1.0 - t15
    tangent_14 = 0.094703801255651851 * t1 / (t58 * t58)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t59 = 1.0 - t16
    tangent_15 = 0.010597402304157654 * t1 / (t59 * t59)
    T3 = T * t1
    t60 = 8.0 * T3
    S_0 = (
        t60 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    S_1 = (
        t60 * (tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13
        * term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 +
        tangent_4 * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 +
        tangent_9 * term_9)
    )
    t61 = 1.0 / c
    t62 = S_0 * t61
    t63 = 2.5464790894703255 * beta
    return (
        A * t63 * (-V2 + t62) - A,
        t63 * (-S_1 * t61 + 2.0 * V2 + V4 - 2.0 * t62) - 1.0,
    )


def _averaged_2_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 564 structured, 517 common subexpressions, 516 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t1 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t1 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t1 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t1 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t1 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t1 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t1 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t1 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t1 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t1 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t1 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t1 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t1 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t1 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t1 + 1.0)
    t2 = A * A
    t3 = 1.0 / t2
    x2 = t3 * u_cr * u_cr
    y2 = root * root * t3
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(t0)
    b0_half_0 = 0.5 / b0_0
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_0 * b0_half_0 + b0_half_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    t4 = 0.25 * lam0_0
    X0_0 = t4 + 0.25 * y2
    t5 = 0.25 * lam0_1
    Y0_0 = 0.25 * t0 + t4
    Y0_1 = t5 + 0.25
    Z0_0 = t4 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = a1_half_0 * t5
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t5
    t6 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t6
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t6 + c1_0 * (a11_0 + b11_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t5
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    t7 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t7
    t8 = 0.25 * lam1_1
    X1_1 = 0.25 * t5 + t8
    Y1_0 = 0.25 * Y0_0 + t7
    Y1_1 = 0.25 * Y0_1 + t8
    Z1_0 = 0.25 * Z0_0 + t7
    Z1_1 = 0.25 * t5 + t8
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    t9 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t9
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t9 + c2_0 * (a21_0 + b21_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    t10 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t10
    t11 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t11
    Y2_0 = 0.25 * Y1_0 + t10
    Y2_1 = 0.25 * Y1_1 + t11
    Z2_0 = 0.25 * Z1_0 + t10
    Z2_1 = 0.25 * Z1_1 + t11
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    t12 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t12
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t12 + c3_0 * (a31_0 + b31_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    t13 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t13
    t14 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t14
    Y3_0 = 0.25 * Y2_0 + t13
    Y3_1 = 0.25 * Y2_1 + t14
    Z3_0 = 0.25 * Z2_0 + t13
    Z3_1 = 0.25 * Z2_1 + t14
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    t15 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t15
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t15 + c4_0 * (a41_0 + b41_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    t16 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t16
    t17 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t17
    Y4_0 = 0.25 * Y3_0 + t16
    Y4_1 = 0.25 * Y3_1 + t17
    Z4_0 = 0.25 * Z3_0 + t16
    Z4_1 = 0.25 * Z3_1 + t17
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    t18 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t18
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t18 + c5_0 * (a51_0 + b51_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    t19 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t19
    t20 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t20
    Y5_0 = 0.25 * Y4_0 + t19
    Y5_1 = 0.25 * Y4_1 + t20
    Z5_0 = 0.25 * Z4_0 + t19
    Z5_1 = 0.25 * Z4_1 + t20
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    t21 = -mean_0
    t22 = -X5_0 - t21
    dx_0 = over_0 * t22
    t23 = -mean_1
    dx_1 = over1_0 * t22 + over_0 * (-X5_1 - t23)
    t24 = -Y5_0 - t21
    dy_0 = over_0 * t24
    dy_1 = over1_0 * t24 + over_0 * (-Y5_1 - t23)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    t25 = 3.0 * xy_0
    t26 = t25 - 8.0 * zz_0
    E3_0 = dz_0 * t26
    t27 = 3.0 * xy_1
    E3_1 = dz_0 * (t27 - 8.0 * zz_1) + dz_1 * t26
    t28 = t25 - 3.0 * zz_0
    E4_0 = t28 * zz_0
    E4_1 = t28 * zz_1 + zz_0 * (t27 - 3.0 * zz_1)
    t29 = xy_0 * zz_0
    E5_0 = dz_0 * t29
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * t29
    t30 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t30 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 - E3_1 *
        t30 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    last_0 = power_0 * series_0
    last_1 = power_0 * series_1 + power_1 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    T3 = T * t1
    S_0 = (
        8.0 * T3 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    t31 = S_0 / c
    t32 = 2.5464790894703255 * beta
    return (
        A * t32 * (-V2 + t31) - A,
        -t32 * (V2 + V4 * t2 - t31) - 1.0,
    )


def averaged_2(A, alpha, beta, u_cr):
    """h, h_A together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_averaged_2_passed_0, _averaged_2_passed_0_steep, _averaged_2_passed_1, _averaged_2_passed_1_steep_far, _averaged_2_passed_1_steep)
    return by_regime(guards, bodies, arguments, 2)


def _h_passed_0(A, alpha, beta, u_cr):
    # operations: 59 structured, 54 common subexpressions, 54 power chains
    m = A * A
    k_c = np.sqrt(1.0 - A) * np.sqrt(A + 1.0)
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t0 = e_1 * e_1
    t1 = 0.25 * m
    e_2 = t0 * t1 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t2 = e_2 * e_2
    e_3 = t1 * t2 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    t3 = e_3 * e_3
    t4 = m / a_4
    e_4 = 0.25 * t3 * t4
    e = e_1 + e_2 + e_3 + e_4
    tau = 16.0 * e_4 * e_4 + 2.0 * t0 + 4.0 * t2 + 8.0 * t3
    P = t4 * (e + tau)
    return (
        -2.0 * A * P * beta - A * alpha,
    )


def _h_passed_0_steep(A, alpha, beta, u_cr):
    # operations: 115 structured, 102 common subexpressions, 102 power chains
    m = A * A
    k_c = np.sqrt(1.0 - A) * np.sqrt(A + 1.0)
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t0 = e_1 * e_1
    t1 = 0.25 * m
    e_2 = t0 * t1 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t2 = e_2 * e_2
    e_3 = t1 * t2 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    b_4 = np.sqrt(a_3) * np.sqrt(b_3)
    t3 = e_3 * e_3
    e_4 = t1 * t3 / a_4
    a_5 = 0.5 * a_4 + 0.5 * b_4
    b_5 = np.sqrt(a_4) * np.sqrt(b_4)
    t4 = e_4 * e_4
    e_5 = t1 * t4 / a_5
    a_6 = 0.5 * a_5 + 0.5 * b_5
    b_6 = np.sqrt(a_5) * np.sqrt(b_5)
    t5 = e_5 * e_5
    e_6 = t1 * t5 / a_6
    a_7 = 0.5 * a_6 + 0.5 * b_6
    b_7 = np.sqrt(a_6) * np.sqrt(b_6)
    t6 = e_6 * e_6
    e_7 = t1 * t6 / a_7
    a_8 = 0.5 * a_7 + 0.5 * b_7
    t7 = e_7 * e_7
    t8 = m / a_8
    e_8 = 0.25 * t7 * t8
    e = e_1 + e_2 + e_3 + e_4 + e_5 + e_6 + e_7 + e_8
    tau = 256.0 * e_8 * e_8 + 2.0 * t0 + 4.0 * t2 + 8.0 * t3 + 16.0 * t4 + 32.0 * t5 + 64.0 * t6 + 128.0 * t7
    P = t8 * (e + tau)
    return (
        -2.0 * A * P * beta - A * alpha,
    )


def _h_passed_1(A, alpha, beta, u_cr):
    # operations: 369 structured, 368 common subexpressions, 367 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    c = np.sqrt((1.0 - u_cr) * (u_cr + 1.0))
    T = u_cr / (A + root)
    t0 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0)
    U2 = 4.0 * A * A * t0
    v2_1 = 0.99379661859049351 * g_1 * g_1
    square_1 = -U2 * v2_1 + 1.0
    delta_1 = np.sqrt(square_1)
    f_1 = 0.007968192496166605 * g_1 * v2_1 / delta_1
    v2_2 = 0.96760297675669993 * g_2 * g_2
    square_2 = -U2 * v2_2 + 1.0
    delta_2 = np.sqrt(square_2)
    f_2 = 0.018466468311090958 * g_2 * v2_2 / delta_2
    v2_3 = 0.92164198121722729 * g_3 * g_3
    square_3 = -U2 * v2_3 + 1.0
    delta_3 = np.sqrt(square_3)
    f_3 = 0.028784707883323369 * g_3 * v2_3 / delta_3
    v2_4 = 0.85784652785798998 * g_4 * g_4
    square_4 = -U2 * v2_4 + 1.0
    delta_4 = np.sqrt(square_4)
    f_4 = 0.03879919256962705 * g_4 * v2_4 / delta_4
    v2_5 = 0.77891309933755515 * g_5 * g_5
    square_5 = -U2 * v2_5 + 1.0
    delta_5 = np.sqrt(square_5)
    f_5 = 0.048402672830594053 * g_5 * v2_5 / delta_5
    v2_6 = 0.68817935411770381 * g_6 * g_6
    square_6 = -U2 * v2_6 + 1.0
    delta_6 = np.sqrt(square_6)
    f_6 = 0.057493156217619065 * g_6 * v2_6 / delta_6
    v2_7 = 0.58948218524948104 * g_7 * g_7
    square_7 = -U2 * v2_7 + 1.0
    delta_7 = np.sqrt(square_7)
    f_7 = 0.065974229882180491 * g_7 * v2_7 / delta_7
    v2_8 = 0.4869953130832757 * g_8 * g_8
    square_8 = -U2 * v2_8 + 1.0
    delta_8 = np.sqrt(square_8)
    f_8 = 0.073755974737705204 * g_8 * v2_8 / delta_8
    v2_9 = 0.38505274377519932 * g_9 * g_9
    square_9 = -U2 * v2_9 + 1.0
    delta_9 = np.sqrt(square_9)
    f_9 = 0.080755895229420213 * g_9 * v2_9 / delta_9
    v2_10 = 0.28796547636914854 * g_10 * g_10
    square_10 = -U2 * v2_10 + 1.0
    delta_10 = np.sqrt(square_10)
    f_10 = 0.086899787201082976 * g_10 * v2_10 / delta_10
    v2_11 = 0.19983919110743342 * g_11 * g_11
    square_11 = -U2 * v2_11 + 1.0
    delta_11 = np.sqrt(square_11)
    f_11 = 0.092122522237786122 * g_11 * v2_11 / delta_11
    v2_12 = 0.12440062341181206 * g_12 * g_12
    square_12 = -U2 * v2_12 + 1.0
    delta_12 = np.sqrt(square_12)
    f_12 = 0.096368737174644253 * g_12 * v2_12 / delta_12
    v2_13 = 0.064839964168231387 * g_13 * g_13
    square_13 = -U2 * v2_13 + 1.0
    delta_13 = np.sqrt(square_13)
    f_13 = 0.099593420586795267 * g_13 * v2_13 / delta_13
    v2_14 = 0.023675950313912963 * g_14 * g_14
    square_14 = -U2 * v2_14 + 1.0
    delta_14 = np.sqrt(square_14)
    f_14 = 0.1017623897484055 * g_14 * v2_14 / delta_14
    v2_15 = 0.0026493505760394136 * g_15 * g_15
    square_15 = -U2 * v2_15 + 1.0
    delta_15 = np.sqrt(square_15)
    f_15 = 0.10285265289355884 * g_15 * v2_15 / delta_15
    sum_0 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1) + f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0)
        * (g_10 * (0.53662414814201986 * t0 + 0.53662414814201986) + 1.0) / (c + delta_10) + f_11 * g_11 *
        (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 + 0.44703376953808915)
        + 1.0) / (c + delta_11) + f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 *
        (0.35270472553087812 * t0 + 0.35270472553087812) + 1.0) / (c + delta_12) + f_13 * g_13 * (0.7453630738321102
        - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 + 0.25463692616788985) + 1.0) / (c +
        delta_13) + f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 *
        t0 + 0.15386991360858354) + 1.0) / (c + delta_14) + f_15 * g_15 * (0.94852815744468233 -
        0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 + 0.051471842555317698) + 1.0) / (c +
        delta_15) + f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0
        + 0.98366812327974718) + 1.0) / (c + delta_2) + f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 *
        t0) * (g_3 * (0.96002186496830755 * t0 + 0.96002186496830755) + 1.0) / (c + delta_3) + f_4 * g_4 *
        (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 + 0.92620004742927431)
        + 1.0) / (c + delta_4) + f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 *
        (0.88256053579205274 * t0 + 0.88256053579205274) + 1.0) / (c + delta_5) + f_6 * g_6 * (0.17043423761723162 -
        0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 + 0.82956576238276836) + 1.0) / (c + delta_6) +
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7) + f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) *
        (g_8 * (0.69785049479331585 * t0 + 0.69785049479331585) + 1.0) / (c + delta_8) + f_9 * g_9 *
        (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 + 0.62052618298924289) +
        1.0) / (c + delta_9)
    )
    T3 = T * t0
    return (
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr * u_cr / c - A,
    )


def _h_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 305 structured, 289 common subexpressions, 288 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t1 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t1 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t1 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t1 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t1 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t1 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t1 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t1 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t1 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t1 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t1 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t1 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t1 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t1 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t1 + 1.0)
    t2 = 1.0 / (A * A)
    x2 = t2 * u_cr * u_cr
    y2 = root * root * t2
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(t0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    t3 = 0.25 * lam0_0
    X0_0 = t3 + 0.25 * y2
    Y0_0 = 0.25 * t0 + t3
    Z0_0 = t3 + 0.25
    a1_0 = np.sqrt(X0_0)
    b1_0 = np.sqrt(Y0_0)
    c1_0 = np.sqrt(Z0_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    q1_0 = Z0_0 + lam1_0
    below1_0 = c1_0 * q1_0
    term1_0 = 1.0 / below1_0
    t4 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t4
    Y1_0 = 0.25 * Y0_0 + t4
    Z1_0 = 0.25 * Z0_0 + t4
    a2_0 = np.sqrt(X1_0)
    b2_0 = np.sqrt(Y1_0)
    c2_0 = np.sqrt(Z1_0)
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    q2_0 = Z1_0 + lam2_0
    below2_0 = c2_0 * q2_0
    term2_0 = 1.0 / below2_0
    t5 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t5
    Y2_0 = 0.25 * Y1_0 + t5
    Z2_0 = 0.25 * Z1_0 + t5
    a3_0 = np.sqrt(X2_0)
    b3_0 = np.sqrt(Y2_0)
    c3_0 = np.sqrt(Z2_0)
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    q3_0 = Z2_0 + lam3_0
    below3_0 = c3_0 * q3_0
    term3_0 = 1.0 / below3_0
    t6 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t6
    Y3_0 = 0.25 * Y2_0 + t6
    Z3_0 = 0.25 * Z2_0 + t6
    a4_0 = np.sqrt(X3_0)
    b4_0 = np.sqrt(Y3_0)
    c4_0 = np.sqrt(Z3_0)
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    q4_0 = Z3_0 + lam4_0
    below4_0 = c4_0 * q4_0
    term4_0 = 1.0 / below4_0
    t7 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t7
    Y4_0 = 0.25 * Y3_0 + t7
    Z4_0 = 0.25 * Z3_0 + t7
    a5_0 = np.sqrt(X4_0)
    b5_0 = np.sqrt(Y4_0)
    c5_0 = np.sqrt(Z4_0)
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    q5_0 = Z4_0 + lam5_0
    below5_0 = c5_0 * q5_0
    term5_0 = 1.0 / below5_0
    t8 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t8
    Y5_0 = 0.25 * Y4_0 + t8
    Z5_0 = 0.25 * Z4_0 + t8
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    over_0 = 1.0 / mean_0
    t9 = -mean_0
    dx_0 = over_0 * (-X5_0 - t9)
    dy_0 = over_0 * (-Y5_0 - t9)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    xy_0 = dx_0 * dy_0
    zz_0 = dz_0 * dz_0
    E2_0 = xy_0 - 6.0 * zz_0
    t10 = 3.0 * xy_0
    E3_0 = dz_0 * (t10 - 8.0 * zz_0)
    E4_0 = zz_0 * (t10 - 3.0 * zz_0)
    E5_0 = dz_0 * xy_0 * zz_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    sq_0 = np.sqrt(over_0)
    power_0 = over_0 * sq_0
    last_0 = power_0 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    V2 = R_0 * third
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    T3 = T * t1
    S_0 = (
        8.0 * T3 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    return (
        2.5464790894703255 * A * beta * (S_0 / c - V2) - A,
    )


def _h_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 305 structured, 289 common subexpressions, 288 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t1 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t1 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t1 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t1 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t1 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t1 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t1 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t1 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t1 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t1 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t1 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t1 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t1 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t1 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t1 + 1.0)
    t2 = 1.0 / (A * A)
    x2 = t2 * u_cr * u_cr
    y2 = root * root * t2
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(t0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    t3 = 0.25 * lam0_0
    X0_0 = t3 + 0.25 * y2
    Y0_0 = 0.25 * t0 + t3
    Z0_0 = t3 + 0.25
    a1_0 = np.sqrt(X0_0)
    b1_0 = np.sqrt(Y0_0)
    c1_0 = np.sqrt(Z0_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    q1_0 = Z0_0 + lam1_0
    below1_0 = c1_0 * q1_0
    term1_0 = 1.0 / below1_0
    t4 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t4
    Y1_0 = 0.25 * Y0_0 + t4
    Z1_0 = 0.25 * Z0_0 + t4
    a2_0 = np.sqrt(X1_0)
    b2_0 = np.sqrt(Y1_0)
    c2_0 = np.sqrt(Z1_0)
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    q2_0 = Z1_0 + lam2_0
    below2_0 = c2_0 * q2_0
    term2_0 = 1.0 / below2_0
    t5 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t5
    Y2_0 = 0.25 * Y1_0 + t5
    Z2_0 = 0.25 * Z1_0 + t5
    a3_0 = np.sqrt(X2_0)
    b3_0 = np.sqrt(Y2_0)
    c3_0 = np.sqrt(Z2_0)
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    q3_0 = Z2_0 + lam3_0
    below3_0 = c3_0 * q3_0
    term3_0 = 1.0 / below3_0
    t6 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t6
    Y3_0 = 0.25 * Y2_0 + t6
    Z3_0 = 0.25 * Z2_0 + t6
    a4_0 = np.sqrt(X3_0)
    b4_0 = np.sqrt(Y3_0)
    c4_0 = np.sqrt(Z3_0)
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    q4_0 = Z3_0 + lam4_0
    below4_0 = c4_0 * q4_0
    term4_0 = 1.0 / below4_0
    t7 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t7
    Y4_0 = 0.25 * Y3_0 + t7
    Z4_0 = 0.25 * Z3_0 + t7
    a5_0 = np.sqrt(X4_0)
    b5_0 = np.sqrt(Y4_0)
    c5_0 = np.sqrt(Z4_0)
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    q5_0 = Z4_0 + lam5_0
    below5_0 = c5_0 * q5_0
    term5_0 = 1.0 / below5_0
    t8 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t8
    Y5_0 = 0.25 * Y4_0 + t8
    Z5_0 = 0.25 * Z4_0 + t8
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    over_0 = 1.0 / mean_0
    t9 = -mean_0
    dx_0 = over_0 * (-X5_0 - t9)
    dy_0 = over_0 * (-Y5_0 - t9)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    xy_0 = dx_0 * dy_0
    zz_0 = dz_0 * dz_0
    E2_0 = xy_0 - 6.0 * zz_0
    t10 = 3.0 * xy_0
    E3_0 = dz_0 * (t10 - 8.0 * zz_0)
    E4_0 = zz_0 * (t10 - 3.0 * zz_0)
    E5_0 = dz_0 * xy_0 * zz_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    sq_0 = np.sqrt(over_0)
    power_0 = over_0 * sq_0
    last_0 = power_0 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    V2 = R_0 * third
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    T3 = T * t1
    S_0 = (
        8.0 * T3 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    return (
        2.5464790894703255 * A * beta * (S_0 / c - V2) - A,
    )


def h(A, alpha, beta, u_cr):
    """The averaged restoring force h = H - A.

    Equation (20)-(22). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_h_passed_0, _h_passed_0_steep, _h_passed_1, _h_passed_1_steep_far, _h_passed_1_steep)
    return by_regime(guards, bodies, arguments, 1)[0]


def _h_A_passed_0(A, alpha, beta, u_cr):
    # operations: 70 structured, 64 common subexpressions, 64 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    t5 = e_3 * e_3
    t6 = 1.0 / a_4
    t7 = m * t6
    e_4 = 0.25 * t5 * t7
    e = e_1 + e_2 + e_3 + e_4
    tau = 16.0 * e_4 * e_4 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5
    P = t7 * (e + tau)
    B = t6 * (-m * tau + 1.0)
    C = 2.0 * t6 * tau
    return (
        -alpha - 2.0 * beta * (B * m / k - C * m + P),
    )


def _h_A_passed_0_steep(A, alpha, beta, u_cr):
    # operations: 126 structured, 112 common subexpressions, 112 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    b_4 = np.sqrt(a_3) * np.sqrt(b_3)
    t5 = e_3 * e_3
    e_4 = t3 * t5 / a_4
    a_5 = 0.5 * a_4 + 0.5 * b_4
    b_5 = np.sqrt(a_4) * np.sqrt(b_4)
    t6 = e_4 * e_4
    e_5 = t3 * t6 / a_5
    a_6 = 0.5 * a_5 + 0.5 * b_5
    b_6 = np.sqrt(a_5) * np.sqrt(b_5)
    t7 = e_5 * e_5
    e_6 = t3 * t7 / a_6
    a_7 = 0.5 * a_6 + 0.5 * b_6
    b_7 = np.sqrt(a_6) * np.sqrt(b_6)
    t8 = e_6 * e_6
    e_7 = t3 * t8 / a_7
    a_8 = 0.5 * a_7 + 0.5 * b_7
    t9 = e_7 * e_7
    t10 = 1.0 / a_8
    t11 = m * t10
    e_8 = 0.25 * t11 * t9
    e = e_1 + e_2 + e_3 + e_4 + e_5 + e_6 + e_7 + e_8
    tau = 256.0 * e_8 * e_8 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5 + 16.0 * t6 + 32.0 * t7 + 64.0 * t8 + 128.0 * t9
    P = t11 * (e + tau)
    B = t10 * (-m * tau + 1.0)
    C = 2.0 * t10 * tau
    return (
        -alpha - 2.0 * beta * (B * m / k - C * m + P),
    )


def _h_A_passed_1(A, alpha, beta, u_cr):
    # operations: 422 structured, 420 common subexpressions, 417 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    c = np.sqrt((1.0 - u_cr) * (u_cr + 1.0))
    T = u_cr / (A + root)
    t0 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0)
    t1 = A * A
    U2 = 4.0 * t0 * t1
    v2_1 = 0.99379661859049351 * g_1 * g_1
    square_1 = -U2 * v2_1 + 1.0
    delta_1 = np.sqrt(square_1)
    f_1 = 0.007968192496166605 * g_1 * v2_1 / delta_1
    fall_1 = f_1 * v2_1 / square_1
    v2_2 = 0.96760297675669993 * g_2 * g_2
    square_2 = -U2 * v2_2 + 1.0
    delta_2 = np.sqrt(square_2)
    f_2 = 0.018466468311090958 * g_2 * v2_2 / delta_2
    fall_2 = f_2 * v2_2 / square_2
    v2_3 = 0.92164198121722729 * g_3 * g_3
    square_3 = -U2 * v2_3 + 1.0
    delta_3 = np.sqrt(square_3)
    f_3 = 0.028784707883323369 * g_3 * v2_3 / delta_3
    fall_3 = f_3 * v2_3 / square_3
    v2_4 = 0.85784652785798998 * g_4 * g_4
    square_4 = -U2 * v2_4 + 1.0
    delta_4 = np.sqrt(square_4)
    f_4 = 0.03879919256962705 * g_4 * v2_4 / delta_4
    fall_4 = f_4 * v2_4 / square_4
    v2_5 = 0.77891309933755515 * g_5 * g_5
    square_5 = -U2 * v2_5 + 1.0
    delta_5 = np.sqrt(square_5)
    f_5 = 0.048402672830594053 * g_5 * v2_5 / delta_5
    fall_5 = f_5 * v2_5 / square_5
    v2_6 = 0.68817935411770381 * g_6 * g_6
    square_6 = -U2 * v2_6 + 1.0
    delta_6 = np.sqrt(square_6)
    f_6 = 0.057493156217619065 * g_6 * v2_6 / delta_6
    fall_6 = f_6 * v2_6 / square_6
    v2_7 = 0.58948218524948104 * g_7 * g_7
    square_7 = -U2 * v2_7 + 1.0
    delta_7 = np.sqrt(square_7)
    f_7 = 0.065974229882180491 * g_7 * v2_7 / delta_7
    fall_7 = f_7 * v2_7 / square_7
    v2_8 = 0.4869953130832757 * g_8 * g_8
    square_8 = -U2 * v2_8 + 1.0
    delta_8 = np.sqrt(square_8)
    f_8 = 0.073755974737705204 * g_8 * v2_8 / delta_8
    fall_8 = f_8 * v2_8 / square_8
    v2_9 = 0.38505274377519932 * g_9 * g_9
    square_9 = -U2 * v2_9 + 1.0
    delta_9 = np.sqrt(square_9)
    f_9 = 0.080755895229420213 * g_9 * v2_9 / delta_9
    fall_9 = f_9 * v2_9 / square_9
    v2_10 = 0.28796547636914854 * g_10 * g_10
    square_10 = -U2 * v2_10 + 1.0
    delta_10 = np.sqrt(square_10)
    f_10 = 0.086899787201082976 * g_10 * v2_10 / delta_10
    fall_10 = f_10 * v2_10 / square_10
    v2_11 = 0.19983919110743342 * g_11 * g_11
    square_11 = -U2 * v2_11 + 1.0
    delta_11 = np.sqrt(square_11)
    f_11 = 0.092122522237786122 * g_11 * v2_11 / delta_11
    fall_11 = f_11 * v2_11 / square_11
    v2_12 = 0.12440062341181206 * g_12 * g_12
    square_12 = -U2 * v2_12 + 1.0
    delta_12 = np.sqrt(square_12)
    f_12 = 0.096368737174644253 * g_12 * v2_12 / delta_12
    fall_12 = f_12 * v2_12 / square_12
    v2_13 = 0.064839964168231387 * g_13 * g_13
    square_13 = -U2 * v2_13 + 1.0
    delta_13 = np.sqrt(square_13)
    f_13 = 0.099593420586795267 * g_13 * v2_13 / delta_13
    fall_13 = f_13 * v2_13 / square_13
    v2_14 = 0.023675950313912963 * g_14 * g_14
    square_14 = -U2 * v2_14 + 1.0
    delta_14 = np.sqrt(square_14)
    f_14 = 0.1017623897484055 * g_14 * v2_14 / delta_14
    fall_14 = f_14 * v2_14 / square_14
    v2_15 = 0.0026493505760394136 * g_15 * g_15
    square_15 = -U2 * v2_15 + 1.0
    delta_15 = np.sqrt(square_15)
    f_15 = 0.10285265289355884 * g_15 * v2_15 / delta_15
    fall_15 = f_15 * v2_15 / square_15
    sum_0 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1) + f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0)
        * (g_10 * (0.53662414814201986 * t0 + 0.53662414814201986) + 1.0) / (c + delta_10) + f_11 * g_11 *
        (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 + 0.44703376953808915)
        + 1.0) / (c + delta_11) + f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 *
        (0.35270472553087812 * t0 + 0.35270472553087812) + 1.0) / (c + delta_12) + f_13 * g_13 * (0.7453630738321102
        - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 + 0.25463692616788985) + 1.0) / (c +
        delta_13) + f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 *
        t0 + 0.15386991360858354) + 1.0) / (c + delta_14) + f_15 * g_15 * (0.94852815744468233 -
        0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 + 0.051471842555317698) + 1.0) / (c +
        delta_15) + f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0
        + 0.98366812327974718) + 1.0) / (c + delta_2) + f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 *
        t0) * (g_3 * (0.96002186496830755 * t0 + 0.96002186496830755) + 1.0) / (c + delta_3) + f_4 * g_4 *
        (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 + 0.92620004742927431)
        + 1.0) / (c + delta_4) + f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 *
        (0.88256053579205274 * t0 + 0.88256053579205274) + 1.0) / (c + delta_5) + f_6 * g_6 * (0.17043423761723162 -
        0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 + 0.82956576238276836) + 1.0) / (c + delta_6) +
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7) + f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) *
        (g_8 * (0.69785049479331585 * t0 + 0.69785049479331585) + 1.0) / (c + delta_8) + f_9 * g_9 *
        (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 + 0.62052618298924289) +
        1.0) / (c + delta_9)
    )
    sum_1 = (
        fall_1 + fall_10 + fall_11 + fall_12 + fall_13 + fall_14 + fall_15 + fall_2 + fall_3 + fall_4 + fall_5 +
        fall_6 + fall_7 + fall_8 + fall_9
    )
    T4 = t0 * t0
    T5 = T * T4
    T3 = T * t0
    return (
        -2.5464790894703255 * beta * (-8.0 * T3 * sum_0 * u_cr * u_cr / c + 32.0 * T5 * sum_1 * t1) - 1.0,
    )


def _h_A_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 683 structured, 607 common subexpressions, 606 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    t2 = 0.99379661859049351 * t1
    g_1 = 1.0 / (t2 + 1.0)
    t3 = 0.96760297675669993 * t1
    g_2 = 1.0 / (t3 + 1.0)
    t4 = 0.92164198121722729 * t1
    g_3 = 1.0 / (t4 + 1.0)
    t5 = 0.85784652785798998 * t1
    g_4 = 1.0 / (t5 + 1.0)
    t6 = 0.77891309933755515 * t1
    g_5 = 1.0 / (t6 + 1.0)
    t7 = 0.68817935411770381 * t1
    g_6 = 1.0 / (t7 + 1.0)
    t8 = 0.58948218524948104 * t1
    g_7 = 1.0 / (t8 + 1.0)
    t9 = 0.4869953130832757 * t1
    g_8 = 1.0 / (t9 + 1.0)
    t10 = 0.38505274377519932 * t1
    g_9 = 1.0 / (t10 + 1.0)
    t11 = 0.28796547636914854 * t1
    g_10 = 1.0 / (t11 + 1.0)
    t12 = 0.19983919110743342 * t1
    g_11 = 1.0 / (t12 + 1.0)
    t13 = 0.12440062341181206 * t1
    g_12 = 1.0 / (t13 + 1.0)
    t14 = 0.064839964168231387 * t1
    g_13 = 1.0 / (t14 + 1.0)
    t15 = 0.023675950313912963 * t1
    g_14 = 1.0 / (t15 + 1.0)
    t16 = 0.0026493505760394136 * t1
    g_15 = 1.0 / (t16 + 1.0)
    t17 = 1.0 / (A * A)
    x2 = t17 * u_cr * u_cr
    y2 = root * root * t17
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    b0_0 = np.sqrt(t0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    t18 = 0.25 * lam0_0
    X0_0 = t18 + 0.25 * y2
    t19 = 0.25 * lam0_1
    X0_1 = t19 + 0.25
    Y0_0 = 0.25 * t0 + t18
    Z0_0 = t18 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = b1_half_0 * t19
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t19
    t20 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t20
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t20 + c1_0 * (a11_0 + b11_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t19
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    t21 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t21
    t22 = 0.25 * lam1_1
    X1_1 = 0.25 * X0_1 + t22
    Y1_0 = 0.25 * Y0_0 + t21
    Y1_1 = 0.25 * t19 + t22
    Z1_0 = 0.25 * Z0_0 + t21
    Z1_1 = 0.25 * t19 + t22
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    t23 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t23
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t23 + c2_0 * (a21_0 + b21_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    t24 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t24
    t25 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t25
    Y2_0 = 0.25 * Y1_0 + t24
    Y2_1 = 0.25 * Y1_1 + t25
    Z2_0 = 0.25 * Z1_0 + t24
    Z2_1 = 0.25 * Z1_1 + t25
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    t26 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t26
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t26 + c3_0 * (a31_0 + b31_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    t27 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t27
    t28 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t28
    Y3_0 = 0.25 * Y2_0 + t27
    Y3_1 = 0.25 * Y2_1 + t28
    Z3_0 = 0.25 * Z2_0 + t27
    Z3_1 = 0.25 * Z2_1 + t28
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    t29 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t29
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t29 + c4_0 * (a41_0 + b41_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    t30 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t30
    t31 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t31
    Y4_0 = 0.25 * Y3_0 + t30
    Y4_1 = 0.25 * Y3_1 + t31
    Z4_0 = 0.25 * Z3_0 + t30
    Z4_1 = 0.25 * Z3_1 + t31
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    t32 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t32
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t32 + c5_0 * (a51_0 + b51_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    t33 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t33
    t34 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t34
    Y5_0 = 0.25 * Y4_0 + t33
    Y5_1 = 0.25 * Y4_1 + t34
    Z5_0 = 0.25 * Z4_0 + t33
    Z5_1 = 0.25 * Z4_1 + t34
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    t35 = -mean_0
    t36 = -X5_0 - t35
    dx_0 = over_0 * t36
    t37 = -mean_1
    dx_1 = over1_0 * t36 + over_0 * (-X5_1 - t37)
    t38 = -Y5_0 - t35
    dy_0 = over_0 * t38
    dy_1 = over1_0 * t38 + over_0 * (-Y5_1 - t37)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    t39 = 3.0 * xy_0
    t40 = t39 - 8.0 * zz_0
    E3_0 = dz_0 * t40
    t41 = 3.0 * xy_1
    E3_1 = dz_0 * (t41 - 8.0 * zz_1) + dz_1 * t40
    t42 = t39 - 3.0 * zz_0
    E4_0 = t42 * zz_0
    E4_1 = t42 * zz_1 + zz_0 * (t41 - 3.0 * zz_1)
    t43 = xy_0 * zz_0
    E5_0 = dz_0 * t43
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * t43
    t44 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t44 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 - E3_1 *
        t44 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    last_0 = power_0 * series_0
    last_1 = power_0 * series_1 + power_1 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    t45 = 1.0 - t2
    tangent_1 = 3.975186474361974 * t1 / (t45 * t45)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t46 = 1.0 - t3
    tangent_2 = 3.8704119070267997 * t1 / (t46 * t46)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t47 = 1.0 - t4
    tangent_3 = 3.6865679248689092 * t1 / (t47 * t47)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t48 = 1.0 - t5
    tangent_4 = 3.4313861114319599 * t1 / (t48 * t48)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t49 = 1.0 - t6
    tangent_5 = 3.1156523973502206 * t1 / (t49 * t49)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t50 = 1.0 - t7
    tangent_6 = 2.7527174164708152 * t1 / (t50 * t50)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t51 = 1.0 - t8
    tangent_7 = 2.3579287409979242 * t1 / (t51 * t51)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t52 = 1.0 - t9
    tangent_8 = 1.9479812523331028 * t1 / (t52 * t52)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t53 = 1.0 - t10
    tangent_9 = 1.5402109751007973 * t1 / (t53 * t53)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t54 = 1.0 - t11
    tangent_10 = 1.1518619054765942 * t1 / (t54 * t54)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t55 = 1.0 - t12
    tangent_11 = 0.79935676442973369 * t1 / (t55 * t55)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t56 = 1.0 - t13
    tangent_12 = 0.49760249364724823 * t1 / (t56 * t56)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t57 = 1.0 - t14
    tangent_13 = 0.25935985667292555 * t1 / (t57 * t57)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t58 = 1.0 - t15
    tangent_14 = 0.094703801255651851 * t1 / (t58 * t58)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t59 = 1.0 - t16
    tangent_15 = 0.010597402304157654 * t1 / (t59 * t59)
    T3 = T * t1
    t60 = 8.0 * T3
    S_0 = (
        t60 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    S_1 = (
        t60 * (tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13
        * term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 +
        tangent_4 * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 +
        tangent_9 * term_9)
    )
    t61 = 1.0 / c
    return (
        2.5464790894703255 * beta * (-2.0 * S_0 * t61 - S_1 * t61 + 2.0 * V2 + V4) - 1.0,
    )


def _h_A_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 558 structured, 513 common subexpressions, 512 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t1 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t1 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t1 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t1 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t1 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t1 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t1 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t1 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t1 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t1 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t1 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t1 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t1 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t1 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t1 + 1.0)
    t2 = A * A
    t3 = 1.0 / t2
    x2 = t3 * u_cr * u_cr
    y2 = root * root * t3
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(t0)
    b0_half_0 = 0.5 / b0_0
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_0 * b0_half_0 + b0_half_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    t4 = 0.25 * lam0_0
    X0_0 = t4 + 0.25 * y2
    t5 = 0.25 * lam0_1
    Y0_0 = 0.25 * t0 + t4
    Y0_1 = t5 + 0.25
    Z0_0 = t4 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = a1_half_0 * t5
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t5
    t6 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t6
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t6 + c1_0 * (a11_0 + b11_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t5
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    t7 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t7
    t8 = 0.25 * lam1_1
    X1_1 = 0.25 * t5 + t8
    Y1_0 = 0.25 * Y0_0 + t7
    Y1_1 = 0.25 * Y0_1 + t8
    Z1_0 = 0.25 * Z0_0 + t7
    Z1_1 = 0.25 * t5 + t8
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    t9 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t9
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t9 + c2_0 * (a21_0 + b21_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    t10 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t10
    t11 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t11
    Y2_0 = 0.25 * Y1_0 + t10
    Y2_1 = 0.25 * Y1_1 + t11
    Z2_0 = 0.25 * Z1_0 + t10
    Z2_1 = 0.25 * Z1_1 + t11
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    t12 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t12
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t12 + c3_0 * (a31_0 + b31_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    t13 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t13
    t14 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t14
    Y3_0 = 0.25 * Y2_0 + t13
    Y3_1 = 0.25 * Y2_1 + t14
    Z3_0 = 0.25 * Z2_0 + t13
    Z3_1 = 0.25 * Z2_1 + t14
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    t15 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t15
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t15 + c4_0 * (a41_0 + b41_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    t16 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t16
    t17 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t17
    Y4_0 = 0.25 * Y3_0 + t16
    Y4_1 = 0.25 * Y3_1 + t17
    Z4_0 = 0.25 * Z3_0 + t16
    Z4_1 = 0.25 * Z3_1 + t17
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    t18 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t18
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t18 + c5_0 * (a51_0 + b51_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    t19 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t19
    t20 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t20
    Y5_0 = 0.25 * Y4_0 + t19
    Y5_1 = 0.25 * Y4_1 + t20
    Z5_0 = 0.25 * Z4_0 + t19
    Z5_1 = 0.25 * Z4_1 + t20
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    t21 = -mean_0
    t22 = -X5_0 - t21
    dx_0 = over_0 * t22
    t23 = -mean_1
    dx_1 = over1_0 * t22 + over_0 * (-X5_1 - t23)
    t24 = -Y5_0 - t21
    dy_0 = over_0 * t24
    dy_1 = over1_0 * t24 + over_0 * (-Y5_1 - t23)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    t25 = 3.0 * xy_0
    t26 = t25 - 8.0 * zz_0
    E3_0 = dz_0 * t26
    t27 = 3.0 * xy_1
    E3_1 = dz_0 * (t27 - 8.0 * zz_1) + dz_1 * t26
    t28 = t25 - 3.0 * zz_0
    E4_0 = t28 * zz_0
    E4_1 = t28 * zz_1 + zz_0 * (t27 - 3.0 * zz_1)
    t29 = xy_0 * zz_0
    E5_0 = dz_0 * t29
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * t29
    t30 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t30 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 - E3_1 *
        t30 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    last_0 = power_0 * series_0
    last_1 = power_0 * series_1 + power_1 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    T3 = T * t1
    S_0 = (
        8.0 * T3 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    return (
        -2.5464790894703255 * beta * (-S_0 / c + V2 + V4 * t2) - 1.0,
    )


def h_A(A, alpha, beta, u_cr):
    """d/dA of the averaged restoring force h = H - A.

    Equation (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_h_A_passed_0, _h_A_passed_0_steep, _h_A_passed_1, _h_A_passed_1_steep_far, _h_A_passed_1_steep)
    return by_regime(guards, bodies, arguments, 1)[0]


def _h_AA_passed_0(A, alpha, beta, u_cr):
    # operations: 64 structured, 58 common subexpressions, 58 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    t5 = e_3 * e_3
    t6 = 1.0 / a_4
    e_4 = t3 * t5 * t6
    tau = 16.0 * e_4 * e_4 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5
    B = t6 * (-m * tau + 1.0)
    C = 2.0 * t6 * tau
    return (
        -2.0 * A * beta * (2.0 * B / (k * k) + C / k),
    )


def _h_AA_passed_0_steep(A, alpha, beta, u_cr):
    # operations: 116 structured, 102 common subexpressions, 102 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    b_4 = np.sqrt(a_3) * np.sqrt(b_3)
    t5 = e_3 * e_3
    e_4 = t3 * t5 / a_4
    a_5 = 0.5 * a_4 + 0.5 * b_4
    b_5 = np.sqrt(a_4) * np.sqrt(b_4)
    t6 = e_4 * e_4
    e_5 = t3 * t6 / a_5
    a_6 = 0.5 * a_5 + 0.5 * b_5
    b_6 = np.sqrt(a_5) * np.sqrt(b_5)
    t7 = e_5 * e_5
    e_6 = t3 * t7 / a_6
    a_7 = 0.5 * a_6 + 0.5 * b_6
    b_7 = np.sqrt(a_6) * np.sqrt(b_6)
    t8 = e_6 * e_6
    e_7 = t3 * t8 / a_7
    a_8 = 0.5 * a_7 + 0.5 * b_7
    t9 = e_7 * e_7
    t10 = 1.0 / a_8
    e_8 = t10 * t3 * t9
    tau = 256.0 * e_8 * e_8 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5 + 16.0 * t6 + 32.0 * t7 + 64.0 * t8 + 128.0 * t9
    B = t10 * (-m * tau + 1.0)
    C = 2.0 * t10 * tau
    return (
        -2.0 * A * beta * (2.0 * B / (k * k) + C / k),
    )


def _h_AA_passed_1(A, alpha, beta, u_cr):
    # operations: 260 structured, 274 common subexpressions, 270 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    c = np.sqrt((1.0 - u_cr) * (u_cr + 1.0))
    T = u_cr / (A + root)
    t0 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0)
    A2 = A * A
    U2 = 4.0 * A2 * t0
    v2_1 = 0.99379661859049351 * g_1 * g_1
    square_1 = -U2 * v2_1 + 1.0
    delta_1 = np.sqrt(square_1)
    f_1 = 0.007968192496166605 * g_1 * v2_1 / delta_1
    t1 = 1.0 / square_1
    fall_1 = f_1 * t1 * v2_1
    v2_2 = 0.96760297675669993 * g_2 * g_2
    square_2 = -U2 * v2_2 + 1.0
    delta_2 = np.sqrt(square_2)
    f_2 = 0.018466468311090958 * g_2 * v2_2 / delta_2
    t2 = 1.0 / square_2
    fall_2 = f_2 * t2 * v2_2
    v2_3 = 0.92164198121722729 * g_3 * g_3
    square_3 = -U2 * v2_3 + 1.0
    delta_3 = np.sqrt(square_3)
    f_3 = 0.028784707883323369 * g_3 * v2_3 / delta_3
    t3 = 1.0 / square_3
    fall_3 = f_3 * t3 * v2_3
    v2_4 = 0.85784652785798998 * g_4 * g_4
    square_4 = -U2 * v2_4 + 1.0
    delta_4 = np.sqrt(square_4)
    f_4 = 0.03879919256962705 * g_4 * v2_4 / delta_4
    t4 = 1.0 / square_4
    fall_4 = f_4 * t4 * v2_4
    v2_5 = 0.77891309933755515 * g_5 * g_5
    square_5 = -U2 * v2_5 + 1.0
    delta_5 = np.sqrt(square_5)
    f_5 = 0.048402672830594053 * g_5 * v2_5 / delta_5
    t5 = 1.0 / square_5
    fall_5 = f_5 * t5 * v2_5
    v2_6 = 0.68817935411770381 * g_6 * g_6
    square_6 = -U2 * v2_6 + 1.0
    delta_6 = np.sqrt(square_6)
    f_6 = 0.057493156217619065 * g_6 * v2_6 / delta_6
    t6 = 1.0 / square_6
    fall_6 = f_6 * t6 * v2_6
    v2_7 = 0.58948218524948104 * g_7 * g_7
    square_7 = -U2 * v2_7 + 1.0
    delta_7 = np.sqrt(square_7)
    f_7 = 0.065974229882180491 * g_7 * v2_7 / delta_7
    t7 = 1.0 / square_7
    fall_7 = f_7 * t7 * v2_7
    v2_8 = 0.4869953130832757 * g_8 * g_8
    square_8 = -U2 * v2_8 + 1.0
    delta_8 = np.sqrt(square_8)
    f_8 = 0.073755974737705204 * g_8 * v2_8 / delta_8
    t8 = 1.0 / square_8
    fall_8 = f_8 * t8 * v2_8
    v2_9 = 0.38505274377519932 * g_9 * g_9
    square_9 = -U2 * v2_9 + 1.0
    delta_9 = np.sqrt(square_9)
    f_9 = 0.080755895229420213 * g_9 * v2_9 / delta_9
    t9 = 1.0 / square_9
    fall_9 = f_9 * t9 * v2_9
    v2_10 = 0.28796547636914854 * g_10 * g_10
    square_10 = -U2 * v2_10 + 1.0
    delta_10 = np.sqrt(square_10)
    f_10 = 0.086899787201082976 * g_10 * v2_10 / delta_10
    t10 = 1.0 / square_10
    fall_10 = f_10 * t10 * v2_10
    v2_11 = 0.19983919110743342 * g_11 * g_11
    square_11 = -U2 * v2_11 + 1.0
    delta_11 = np.sqrt(square_11)
    f_11 = 0.092122522237786122 * g_11 * v2_11 / delta_11
    t11 = 1.0 / square_11
    fall_11 = f_11 * t11 * v2_11
    v2_12 = 0.12440062341181206 * g_12 * g_12
    square_12 = -U2 * v2_12 + 1.0
    delta_12 = np.sqrt(square_12)
    f_12 = 0.096368737174644253 * g_12 * v2_12 / delta_12
    t12 = 1.0 / square_12
    fall_12 = f_12 * t12 * v2_12
    v2_13 = 0.064839964168231387 * g_13 * g_13
    square_13 = -U2 * v2_13 + 1.0
    delta_13 = np.sqrt(square_13)
    f_13 = 0.099593420586795267 * g_13 * v2_13 / delta_13
    t13 = 1.0 / square_13
    fall_13 = f_13 * t13 * v2_13
    v2_14 = 0.023675950313912963 * g_14 * g_14
    square_14 = -U2 * v2_14 + 1.0
    delta_14 = np.sqrt(square_14)
    f_14 = 0.1017623897484055 * g_14 * v2_14 / delta_14
    t14 = 1.0 / square_14
    fall_14 = f_14 * t14 * v2_14
    v2_15 = 0.0026493505760394136 * g_15 * g_15
    square_15 = -U2 * v2_15 + 1.0
    delta_15 = np.sqrt(square_15)
    f_15 = 0.10285265289355884 * g_15 * v2_15 / delta_15
    t15 = 1.0 / square_15
    fall_15 = f_15 * t15 * v2_15
    sum_2 = (
        fall_1 * t1 + fall_10 * t10 + fall_11 * t11 + fall_12 * t12 + fall_13 * t13 + fall_14 * t14 + fall_15 * t15
        + fall_2 * t2 + fall_3 * t3 + fall_4 * t4 + fall_5 * t5 + fall_6 * t6 + fall_7 * t7 + fall_8 * t8 + fall_9 *
        t9
    )
    T4 = t0 * t0
    T5 = T * T4
    u_cr2 = u_cr * u_cr
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    A3 = A * A2
    c2 = c * c
    c3 = c * c2
    return (
        -2.5464790894703255 * beta * (96.0 * A * T5 * sum_2 - u_cr5 / (A3 * c3 * root)),
    )


def _h_AA_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 1092 structured, 968 common subexpressions, 967 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    t2 = 0.99379661859049351 * t1
    g_1 = 1.0 / (t2 + 1.0)
    t3 = 0.96760297675669993 * t1
    g_2 = 1.0 / (t3 + 1.0)
    t4 = 0.92164198121722729 * t1
    g_3 = 1.0 / (t4 + 1.0)
    t5 = 0.85784652785798998 * t1
    g_4 = 1.0 / (t5 + 1.0)
    t6 = 0.77891309933755515 * t1
    g_5 = 1.0 / (t6 + 1.0)
    t7 = 0.68817935411770381 * t1
    g_6 = 1.0 / (t7 + 1.0)
    t8 = 0.58948218524948104 * t1
    g_7 = 1.0 / (t8 + 1.0)
    t9 = 0.4869953130832757 * t1
    g_8 = 1.0 / (t9 + 1.0)
    t10 = 0.38505274377519932 * t1
    g_9 = 1.0 / (t10 + 1.0)
    t11 = 0.28796547636914854 * t1
    g_10 = 1.0 / (t11 + 1.0)
    t12 = 0.19983919110743342 * t1
    g_11 = 1.0 / (t12 + 1.0)
    t13 = 0.12440062341181206 * t1
    g_12 = 1.0 / (t13 + 1.0)
    t14 = 0.064839964168231387 * t1
    g_13 = 1.0 / (t14 + 1.0)
    t15 = 0.023675950313912963 * t1
    g_14 = 1.0 / (t15 + 1.0)
    t16 = 0.0026493505760394136 * t1
    g_15 = 1.0 / (t16 + 1.0)
    t17 = 1.0 / (A * A)
    x2 = t17 * u_cr * u_cr
    y2 = root * root * t17
    t18 = 1.0 / A
    third = 0.33333333333333331 * t18 * u_cr * x2
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    a0_half_0_2 = a0_half_0 * a0_half_0
    a0_half_0_3 = a0_half_0 * a0_half_0_2
    a02_0 = -a0_half_0_3
    b0_0 = np.sqrt(t0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    lam0_2 = a02_0 * b0_0 + a02_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    t19 = 0.25 * lam0_0
    X0_0 = t19 + 0.25 * y2
    t20 = 0.25 * lam0_1
    X0_1 = t20 + 0.25
    t21 = 0.25 * lam0_2
    Y0_0 = 0.25 * t0 + t19
    Z0_0 = t19 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (-a11_0 * a11_0 + t21)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = b1_half_0 * t20
    b12_0 = b1_half_0 * (-b11_0 * b11_0 + t21)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t20
    c12_0 = c1_half_0 * (-c11_0 * c11_0 + t21)
    t22 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t22
    t23 = a11_0 + b11_0
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t22 + c1_0 * t23
    lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * t23 + c12_0 * t22 + c1_0 * (a12_0 + b12_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t20
    q1_2 = lam1_2 + t21
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    t24 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t24
    t25 = 0.25 * lam1_1
    X1_1 = 0.25 * X0_1 + t25
    t26 = 0.25 * lam1_2
    X1_2 = 0.25 * t21 + t26
    Y1_0 = 0.25 * Y0_0 + t24
    Y1_1 = 0.25 * t20 + t25
    Y1_2 = 0.25 * t21 + t26
    Z1_0 = 0.25 * Z0_0 + t24
    Z1_1 = 0.25 * t20 + t25
    Z1_2 = 0.25 * t21 + t26
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0)
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0)
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0)
    t27 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t27
    t28 = a21_0 + b21_0
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t27 + c2_0 * t28
    lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * t28 + c22_0 * t27 + c2_0 * (a22_0 + b22_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    t29 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t29
    t30 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t30
    t31 = 0.25 * lam2_2
    X2_2 = 0.25 * X1_2 + t31
    Y2_0 = 0.25 * Y1_0 + t29
    Y2_1 = 0.25 * Y1_1 + t30
    Y2_2 = 0.25 * Y1_2 + t31
    Z2_0 = 0.25 * Z1_0 + t29
    Z2_1 = 0.25 * Z1_1 + t30
    Z2_2 = 0.25 * Z1_2 + t31
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0)
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0)
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0)
    t32 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t32
    t33 = a31_0 + b31_0
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t32 + c3_0 * t33
    lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * t33 + c32_0 * t32 + c3_0 * (a32_0 + b32_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    t34 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t34
    t35 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t35
    t36 = 0.25 * lam3_2
    X3_2 = 0.25 * X2_2 + t36
    Y3_0 = 0.25 * Y2_0 + t34
    Y3_1 = 0.25 * Y2_1 + t35
    Y3_2 = 0.25 * Y2_2 + t36
    Z3_0 = 0.25 * Z2_0 + t34
    Z3_1 = 0.25 * Z2_1 + t35
    Z3_2 = 0.25 * Z2_2 + t36
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0)
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0)
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0)
    t37 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t37
    t38 = a41_0 + b41_0
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t37 + c4_0 * t38
    lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * t38 + c42_0 * t37 + c4_0 * (a42_0 + b42_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    t39 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t39
    t40 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t40
    t41 = 0.25 * lam4_2
    X4_2 = 0.25 * X3_2 + t41
    Y4_0 = 0.25 * Y3_0 + t39
    Y4_1 = 0.25 * Y3_1 + t40
    Y4_2 = 0.25 * Y3_2 + t41
    Z4_0 = 0.25 * Z3_0 + t39
    Z4_1 = 0.25 * Z3_1 + t40
    Z4_2 = 0.25 * Z3_2 + t41
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0)
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0)
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0)
    t42 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t42
    t43 = a51_0 + b51_0
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t42 + c5_0 * t43
    lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * t43 + c52_0 * t42 + c5_0 * (a52_0 + b52_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    t44 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t44
    t45 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t45
    t46 = 0.25 * lam5_2
    X5_2 = 0.25 * X4_2 + t46
    Y5_0 = 0.25 * Y4_0 + t44
    Y5_1 = 0.25 * Y4_1 + t45
    Y5_2 = 0.25 * Y4_2 + t46
    Z5_0 = 0.25 * Z4_0 + t44
    Z5_1 = 0.25 * Z4_1 + t45
    Z5_2 = 0.25 * Z4_2 + t46
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    t47 = -mean_0
    t48 = -X5_0 - t47
    dx_0 = over_0 * t48
    t49 = -mean_1
    t50 = -X5_1 - t49
    dx_1 = over1_0 * t48 + over_0 * t50
    t51 = -mean_2
    dx_2 = over1_0 * t50 + over2_0 * t48 + over_0 * (-X5_2 - t51)
    t52 = -Y5_0 - t47
    dy_0 = over_0 * t52
    t53 = -Y5_1 - t49
    dy_1 = over1_0 * t52 + over_0 * t53
    dy_2 = over1_0 * t53 + over2_0 * t52 + over_0 * (-Y5_2 - t51)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    zz_0 = dz_0 * dz_0
    t54 = 2.0 * dz_0
    zz_1 = dz_1 * t54
    zz_2 = dz_1 * dz_1 + dz_2 * t54
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    t55 = 3.0 * xy_0
    t56 = t55 - 8.0 * zz_0
    E3_0 = dz_0 * t56
    t57 = 3.0 * xy_1
    t58 = t57 - 8.0 * zz_1
    E3_1 = dz_0 * t58 + dz_1 * t56
    t59 = 3.0 * xy_2
    E3_2 = dz_0 * (t59 - 8.0 * zz_2) + dz_1 * t58 + dz_2 * t56
    t60 = t55 - 3.0 * zz_0
    E4_0 = t60 * zz_0
    t61 = t57 - 3.0 * zz_1
    E4_1 = t60 * zz_1 + t61 * zz_0
    E4_2 = t60 * zz_2 + t61 * zz_1 + zz_0 * (t59 - 3.0 * zz_2)
    t62 = xy_0 * zz_0
    E5_0 = dz_0 * t62
    t63 = xy_0 * zz_1 + xy_1 * zz_0
    E5_1 = dz_0 * t63 + dz_1 * t62
    E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * t63 + dz_2 * t62
    t64 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t64 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    t65 = 0.17307692307692307 * E2_1
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.21428571428571427 * E2_1 - E3_0 * t65 - E3_1 * t64 +
        0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 + 0.10227272727272728 * E2_1 * E2_1 - 0.17307692307692307 * E2_2 * E3_0 -
        0.21428571428571427 * E2_2 - E3_1 * t65 - E3_2 * t64 + 0.16666666666666666 * E3_2 - 0.13636363636363635 *
        E4_2 + 0.11538461538461539 * E5_2
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0)
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0
    last_0 = power_0 * series_0
    last_1 = power_0 * series_1 + power_1 * series_0
    last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    R_2 = (
        0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 * term32_0 +
        0.01171875 * term42_0 + 0.0029296875 * term52_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    V6 = 2.6666666666666665 * R_2 * third * x2 * x2
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    t66 = 1.0 - t2
    tangent_1 = 3.975186474361974 * t1 / (t66 * t66)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t67 = 1.0 - t3
    tangent_2 = 3.8704119070267997 * t1 / (t67 * t67)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t68 = 1.0 - t4
    tangent_3 = 3.6865679248689092 * t1 / (t68 * t68)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t69 = 1.0 - t5
    tangent_4 = 3.4313861114319599 * t1 / (t69 * t69)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t70 = 1.0 - t6
    tangent_5 = 3.1156523973502206 * t1 / (t70 * t70)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t71 = 1.0 - t7
    tangent_6 = 2.7527174164708152 * t1 / (t71 * t71)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t72 = 1.0 - t8
    tangent_7 = 2.3579287409979242 * t1 / (t72 * t72)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t73 = 1.0 - t9
    tangent_8 = 1.9479812523331028 * t1 / (t73 * t73)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t74 = 1.0 - t10
    tangent_9 = 1.5402109751007973 * t1 / (t74 * t74)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t75 = 1.0 - t11
    tangent_10 = 1.1518619054765942 * t1 / (t75 * t75)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t76 = 1.0 - t12
    tangent_11 = 0.79935676442973369 * t1 / (t76 * t76)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t77 = 1.0 - t13
    tangent_12 = 0.49760249364724823 * t1 / (t77 * t77)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t78 = 1.0 - t14
    tangent_13 = 0.25935985667292555 * t1 / (t78 * t78)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t79 = 1.0 - t15
    tangent_14 = 0.094703801255651851 * t1 / (t79 * t79)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t80 = 1.0 - t16
    tangent_15 = 0.010597402304157654 * t1 / (t80 * t80)
    T3 = T * t1
    t81 = 8.0 * T3
    S_0 = (
        t81 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    S_1 = (
        t81 * (tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13
        * term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 +
        tangent_4 * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 +
        tangent_9 * term_9)
    )
    S_2 = (
        t81 * (tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 * tangent_11 *
        term_11 + tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 * tangent_14 *
        term_14 + tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 * tangent_3 *
        term_3 + tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6 * term_6 +
        tangent_7 * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9)
    )
    t82 = 1.0 / c
    return (
        2.5464790894703255 * beta * t18 * (6.0 * S_0 * t82 + 7.0 * S_1 * t82 + 3.0 * S_2 * t82 - 6.0 * V2 - 7.0 * V4
        - 3.0 * V6),
    )


def _h_AA_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 797 structured, 706 common subexpressions, 703 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    A2 = A * A
    t1 = 1.0 / A2
    u_cr2 = u_cr * u_cr
    x2 = t1 * u_cr2
    y2 = root * root * t1
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(t0)
    b0_half_0 = 0.5 / b0_0
    b0_half_0_2 = b0_half_0 * b0_half_0
    b0_half_0_3 = b0_half_0 * b0_half_0_2
    b02_0 = -b0_half_0_3
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_0 * b0_half_0 + b0_half_0
    lam0_2 = a0_0 * b02_0 + b02_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    t2 = 0.25 * lam0_0
    X0_0 = t2 + 0.25 * y2
    t3 = 0.25 * lam0_1
    t4 = 0.25 * lam0_2
    Y0_0 = 0.25 * t0 + t2
    Y0_1 = t3 + 0.25
    Z0_0 = t2 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = a1_half_0 * t3
    a12_0 = a1_half_0 * (-a11_0 * a11_0 + t4)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (-b11_0 * b11_0 + t4)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t3
    c12_0 = c1_half_0 * (-c11_0 * c11_0 + t4)
    t5 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t5
    t6 = a11_0 + b11_0
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t5 + c1_0 * t6
    lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * t6 + c12_0 * t5 + c1_0 * (a12_0 + b12_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t3
    q1_2 = lam1_2 + t4
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    t7 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t7
    t8 = 0.25 * lam1_1
    X1_1 = 0.25 * t3 + t8
    t9 = 0.25 * lam1_2
    X1_2 = 0.25 * t4 + t9
    Y1_0 = 0.25 * Y0_0 + t7
    Y1_1 = 0.25 * Y0_1 + t8
    Y1_2 = 0.25 * t4 + t9
    Z1_0 = 0.25 * Z0_0 + t7
    Z1_1 = 0.25 * t3 + t8
    Z1_2 = 0.25 * t4 + t9
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0)
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0)
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0)
    t10 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t10
    t11 = a21_0 + b21_0
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t10 + c2_0 * t11
    lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * t11 + c22_0 * t10 + c2_0 * (a22_0 + b22_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    t12 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t12
    t13 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t13
    t14 = 0.25 * lam2_2
    X2_2 = 0.25 * X1_2 + t14
    Y2_0 = 0.25 * Y1_0 + t12
    Y2_1 = 0.25 * Y1_1 + t13
    Y2_2 = 0.25 * Y1_2 + t14
    Z2_0 = 0.25 * Z1_0 + t12
    Z2_1 = 0.25 * Z1_1 + t13
    Z2_2 = 0.25 * Z1_2 + t14
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0)
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0)
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0)
    t15 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t15
    t16 = a31_0 + b31_0
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t15 + c3_0 * t16
    lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * t16 + c32_0 * t15 + c3_0 * (a32_0 + b32_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    t17 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t17
    t18 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t18
    t19 = 0.25 * lam3_2
    X3_2 = 0.25 * X2_2 + t19
    Y3_0 = 0.25 * Y2_0 + t17
    Y3_1 = 0.25 * Y2_1 + t18
    Y3_2 = 0.25 * Y2_2 + t19
    Z3_0 = 0.25 * Z2_0 + t17
    Z3_1 = 0.25 * Z2_1 + t18
    Z3_2 = 0.25 * Z2_2 + t19
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0)
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0)
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0)
    t20 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t20
    t21 = a41_0 + b41_0
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t20 + c4_0 * t21
    lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * t21 + c42_0 * t20 + c4_0 * (a42_0 + b42_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    t22 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t22
    t23 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t23
    t24 = 0.25 * lam4_2
    X4_2 = 0.25 * X3_2 + t24
    Y4_0 = 0.25 * Y3_0 + t22
    Y4_1 = 0.25 * Y3_1 + t23
    Y4_2 = 0.25 * Y3_2 + t24
    Z4_0 = 0.25 * Z3_0 + t22
    Z4_1 = 0.25 * Z3_1 + t23
    Z4_2 = 0.25 * Z3_2 + t24
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0)
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0)
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0)
    t25 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t25
    t26 = a51_0 + b51_0
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t25 + c5_0 * t26
    lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * t26 + c52_0 * t25 + c5_0 * (a52_0 + b52_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    t27 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t27
    t28 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t28
    t29 = 0.25 * lam5_2
    X5_2 = 0.25 * X4_2 + t29
    Y5_0 = 0.25 * Y4_0 + t27
    Y5_1 = 0.25 * Y4_1 + t28
    Y5_2 = 0.25 * Y4_2 + t29
    Z5_0 = 0.25 * Z4_0 + t27
    Z5_1 = 0.25 * Z4_1 + t28
    Z5_2 = 0.25 * Z4_2 + t29
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    t30 = -mean_0
    t31 = -X5_0 - t30
    dx_0 = over_0 * t31
    t32 = -mean_1
    t33 = -X5_1 - t32
    dx_1 = over1_0 * t31 + over_0 * t33
    t34 = -mean_2
    dx_2 = over1_0 * t33 + over2_0 * t31 + over_0 * (-X5_2 - t34)
    t35 = -Y5_0 - t30
    dy_0 = over_0 * t35
    t36 = -Y5_1 - t32
    dy_1 = over1_0 * t35 + over_0 * t36
    dy_2 = over1_0 * t36 + over2_0 * t35 + over_0 * (-Y5_2 - t34)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    zz_0 = dz_0 * dz_0
    t37 = 2.0 * dz_0
    zz_1 = dz_1 * t37
    zz_2 = dz_1 * dz_1 + dz_2 * t37
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    t38 = 3.0 * xy_0
    t39 = t38 - 8.0 * zz_0
    E3_0 = dz_0 * t39
    t40 = 3.0 * xy_1
    t41 = t40 - 8.0 * zz_1
    E3_1 = dz_0 * t41 + dz_1 * t39
    t42 = 3.0 * xy_2
    E3_2 = dz_0 * (t42 - 8.0 * zz_2) + dz_1 * t41 + dz_2 * t39
    t43 = t38 - 3.0 * zz_0
    E4_0 = t43 * zz_0
    t44 = t40 - 3.0 * zz_1
    E4_1 = t43 * zz_1 + t44 * zz_0
    E4_2 = t43 * zz_2 + t44 * zz_1 + zz_0 * (t42 - 3.0 * zz_2)
    t45 = xy_0 * zz_0
    E5_0 = dz_0 * t45
    t46 = xy_0 * zz_1 + xy_1 * zz_0
    E5_1 = dz_0 * t46 + dz_1 * t45
    E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * t46 + dz_2 * t45
    t47 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t47 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    t48 = 0.17307692307692307 * E2_1
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.21428571428571427 * E2_1 - E3_0 * t48 - E3_1 * t47 +
        0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 + 0.10227272727272728 * E2_1 * E2_1 - 0.17307692307692307 * E2_2 * E3_0 -
        0.21428571428571427 * E2_2 - E3_1 * t48 - E3_2 * t47 + 0.16666666666666666 * E3_2 - 0.13636363636363635 *
        E4_2 + 0.11538461538461539 * E5_2
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0)
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0
    last_1 = power_0 * series_1 + power_1 * series_0
    last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    R_2 = (
        0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 * term32_0 +
        0.01171875 * term42_0 + 0.0029296875 * term52_0
    )
    V4 = -2.0 * R_1 * third * x2
    V6 = 2.6666666666666665 * R_2 * third * x2 * x2
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    A3 = A * A2
    c2 = c * c
    c3 = c * c2
    return (
        -2.5464790894703255 * beta * (3.0 * A * (A2 * V6 + V4) - u_cr5 / (A3 * c3 * root)),
    )


def h_AA(A, alpha, beta, u_cr):
    """d2/dA2 of the averaged restoring force h = H - A.

    Equation from (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_h_AA_passed_0, _h_AA_passed_0_steep, _h_AA_passed_1, _h_AA_passed_1_steep_far, _h_AA_passed_1_steep)
    return by_regime(guards, bodies, arguments, 1)[0]


def _h_AAA_passed_0(A, alpha, beta, u_cr):
    # operations: 70 structured, 64 common subexpressions, 63 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    t5 = e_3 * e_3
    t6 = 1.0 / a_4
    e_4 = t3 * t5 * t6
    tau = 16.0 * e_4 * e_4 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5
    B = t6 * (-m * tau + 1.0)
    C = 2.0 * t6 * tau
    k2 = k * k
    k3 = k * k2
    return (
        -2.0 * beta * (B * (5.0 * m + 3.0) / k3 + C * (7.0 * m - 3.0) / k2),
    )


def _h_AAA_passed_0_steep(A, alpha, beta, u_cr):
    # operations: 122 structured, 108 common subexpressions, 107 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    b_4 = np.sqrt(a_3) * np.sqrt(b_3)
    t5 = e_3 * e_3
    e_4 = t3 * t5 / a_4
    a_5 = 0.5 * a_4 + 0.5 * b_4
    b_5 = np.sqrt(a_4) * np.sqrt(b_4)
    t6 = e_4 * e_4
    e_5 = t3 * t6 / a_5
    a_6 = 0.5 * a_5 + 0.5 * b_5
    b_6 = np.sqrt(a_5) * np.sqrt(b_5)
    t7 = e_5 * e_5
    e_6 = t3 * t7 / a_6
    a_7 = 0.5 * a_6 + 0.5 * b_6
    b_7 = np.sqrt(a_6) * np.sqrt(b_6)
    t8 = e_6 * e_6
    e_7 = t3 * t8 / a_7
    a_8 = 0.5 * a_7 + 0.5 * b_7
    t9 = e_7 * e_7
    t10 = 1.0 / a_8
    e_8 = t10 * t3 * t9
    tau = 256.0 * e_8 * e_8 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5 + 16.0 * t6 + 32.0 * t7 + 64.0 * t8 + 128.0 * t9
    B = t10 * (-m * tau + 1.0)
    C = 2.0 * t10 * tau
    k2 = k * k
    k3 = k * k2
    return (
        -2.0 * beta * (B * (5.0 * m + 3.0) / k3 + C * (7.0 * m - 3.0) / k2),
    )


def _h_AAA_passed_1(A, alpha, beta, u_cr):
    # operations: 365 structured, 332 common subexpressions, 325 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    c = np.sqrt((1.0 - u_cr) * (u_cr + 1.0))
    T = u_cr / (A + root)
    t0 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0)
    A2 = A * A
    U2 = 4.0 * A2 * t0
    v2_1 = 0.99379661859049351 * g_1 * g_1
    t1 = U2 * v2_1
    square_1 = 1.0 - t1
    delta_1 = np.sqrt(square_1)
    f_1 = 0.007968192496166605 * g_1 * v2_1 / delta_1
    fall_1 = f_1 * v2_1 / square_1
    v2_2 = 0.96760297675669993 * g_2 * g_2
    t2 = U2 * v2_2
    square_2 = 1.0 - t2
    delta_2 = np.sqrt(square_2)
    f_2 = 0.018466468311090958 * g_2 * v2_2 / delta_2
    fall_2 = f_2 * v2_2 / square_2
    v2_3 = 0.92164198121722729 * g_3 * g_3
    t3 = U2 * v2_3
    square_3 = 1.0 - t3
    delta_3 = np.sqrt(square_3)
    f_3 = 0.028784707883323369 * g_3 * v2_3 / delta_3
    fall_3 = f_3 * v2_3 / square_3
    v2_4 = 0.85784652785798998 * g_4 * g_4
    t4 = U2 * v2_4
    square_4 = 1.0 - t4
    delta_4 = np.sqrt(square_4)
    f_4 = 0.03879919256962705 * g_4 * v2_4 / delta_4
    fall_4 = f_4 * v2_4 / square_4
    v2_5 = 0.77891309933755515 * g_5 * g_5
    t5 = U2 * v2_5
    square_5 = 1.0 - t5
    delta_5 = np.sqrt(square_5)
    f_5 = 0.048402672830594053 * g_5 * v2_5 / delta_5
    fall_5 = f_5 * v2_5 / square_5
    v2_6 = 0.68817935411770381 * g_6 * g_6
    t6 = U2 * v2_6
    square_6 = 1.0 - t6
    delta_6 = np.sqrt(square_6)
    f_6 = 0.057493156217619065 * g_6 * v2_6 / delta_6
    fall_6 = f_6 * v2_6 / square_6
    v2_7 = 0.58948218524948104 * g_7 * g_7
    t7 = U2 * v2_7
    square_7 = 1.0 - t7
    delta_7 = np.sqrt(square_7)
    f_7 = 0.065974229882180491 * g_7 * v2_7 / delta_7
    fall_7 = f_7 * v2_7 / square_7
    v2_8 = 0.4869953130832757 * g_8 * g_8
    t8 = U2 * v2_8
    square_8 = 1.0 - t8
    delta_8 = np.sqrt(square_8)
    f_8 = 0.073755974737705204 * g_8 * v2_8 / delta_8
    fall_8 = f_8 * v2_8 / square_8
    v2_9 = 0.38505274377519932 * g_9 * g_9
    t9 = U2 * v2_9
    square_9 = 1.0 - t9
    delta_9 = np.sqrt(square_9)
    f_9 = 0.080755895229420213 * g_9 * v2_9 / delta_9
    fall_9 = f_9 * v2_9 / square_9
    v2_10 = 0.28796547636914854 * g_10 * g_10
    t10 = U2 * v2_10
    square_10 = 1.0 - t10
    delta_10 = np.sqrt(square_10)
    f_10 = 0.086899787201082976 * g_10 * v2_10 / delta_10
    fall_10 = f_10 * v2_10 / square_10
    v2_11 = 0.19983919110743342 * g_11 * g_11
    t11 = U2 * v2_11
    square_11 = 1.0 - t11
    delta_11 = np.sqrt(square_11)
    f_11 = 0.092122522237786122 * g_11 * v2_11 / delta_11
    fall_11 = f_11 * v2_11 / square_11
    v2_12 = 0.12440062341181206 * g_12 * g_12
    t12 = U2 * v2_12
    square_12 = 1.0 - t12
    delta_12 = np.sqrt(square_12)
    f_12 = 0.096368737174644253 * g_12 * v2_12 / delta_12
    fall_12 = f_12 * v2_12 / square_12
    v2_13 = 0.064839964168231387 * g_13 * g_13
    t13 = U2 * v2_13
    square_13 = 1.0 - t13
    delta_13 = np.sqrt(square_13)
    f_13 = 0.099593420586795267 * g_13 * v2_13 / delta_13
    fall_13 = f_13 * v2_13 / square_13
    v2_14 = 0.023675950313912963 * g_14 * g_14
    t14 = U2 * v2_14
    square_14 = 1.0 - t14
    delta_14 = np.sqrt(square_14)
    f_14 = 0.1017623897484055 * g_14 * v2_14 / delta_14
    fall_14 = f_14 * v2_14 / square_14
    v2_15 = 0.0026493505760394136 * g_15 * g_15
    t15 = U2 * v2_15
    square_15 = 1.0 - t15
    delta_15 = np.sqrt(square_15)
    f_15 = 0.10285265289355884 * g_15 * v2_15 / delta_15
    fall_15 = f_15 * v2_15 / square_15
    sum_3 = (
        fall_1 * (4.0 * t1 + 1.0) / (square_1 * square_1) + fall_10 * (4.0 * t10 + 1.0) / (square_10 * square_10) +
        fall_11 * (4.0 * t11 + 1.0) / (square_11 * square_11) + fall_12 * (4.0 * t12 + 1.0) / (square_12 *
        square_12) + fall_13 * (4.0 * t13 + 1.0) / (square_13 * square_13) + fall_14 * (4.0 * t14 + 1.0) /
        (square_14 * square_14) + fall_15 * (4.0 * t15 + 1.0) / (square_15 * square_15) + fall_2 * (4.0 * t2 + 1.0)
        / (square_2 * square_2) + fall_3 * (4.0 * t3 + 1.0) / (square_3 * square_3) + fall_4 * (4.0 * t4 + 1.0) /
        (square_4 * square_4) + fall_5 * (4.0 * t5 + 1.0) / (square_5 * square_5) + fall_6 * (4.0 * t6 + 1.0) /
        (square_6 * square_6) + fall_7 * (4.0 * t7 + 1.0) / (square_7 * square_7) + fall_8 * (4.0 * t8 + 1.0) /
        (square_8 * square_8) + fall_9 * (4.0 * t9 + 1.0) / (square_9 * square_9)
    )
    u_cr2 = u_cr * u_cr
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    c2 = c * c
    c3 = c * c2
    t16 = u_cr5 / c3
    A4 = A2 * A2
    t17 = 3.0 / (A4 * root)
    T4 = t0 * t0
    T5 = T * T4
    root2 = root * root
    root3 = root * root2
    c4 = c2 * c2
    c5 = c * c4
    return (
        -2.5464790894703255 * beta * (96.0 * T5 * sum_3 + t16 * t17 - t17 * u_cr5 / c5 + t16 / (A2 * root3)),
    )


def _h_AAA_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 1617 structured, 1423 common subexpressions, 1405 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    t2 = 0.99379661859049351 * t1
    g_1 = 1.0 / (t2 + 1.0)
    t3 = 0.96760297675669993 * t1
    g_2 = 1.0 / (t3 + 1.0)
    t4 = 0.92164198121722729 * t1
    g_3 = 1.0 / (t4 + 1.0)
    t5 = 0.85784652785798998 * t1
    g_4 = 1.0 / (t5 + 1.0)
    t6 = 0.77891309933755515 * t1
    g_5 = 1.0 / (t6 + 1.0)
    t7 = 0.68817935411770381 * t1
    g_6 = 1.0 / (t7 + 1.0)
    t8 = 0.58948218524948104 * t1
    g_7 = 1.0 / (t8 + 1.0)
    t9 = 0.4869953130832757 * t1
    g_8 = 1.0 / (t9 + 1.0)
    t10 = 0.38505274377519932 * t1
    g_9 = 1.0 / (t10 + 1.0)
    t11 = 0.28796547636914854 * t1
    g_10 = 1.0 / (t11 + 1.0)
    t12 = 0.19983919110743342 * t1
    g_11 = 1.0 / (t12 + 1.0)
    t13 = 0.12440062341181206 * t1
    g_12 = 1.0 / (t13 + 1.0)
    t14 = 0.064839964168231387 * t1
    g_13 = 1.0 / (t14 + 1.0)
    t15 = 0.023675950313912963 * t1
    g_14 = 1.0 / (t15 + 1.0)
    t16 = 0.0026493505760394136 * t1
    g_15 = 1.0 / (t16 + 1.0)
    t17 = 1.0 / (A * A)
    x2 = t17 * u_cr * u_cr
    y2 = root * root * t17
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    a0_half_0_2 = a0_half_0 * a0_half_0
    a0_half_0_3 = a0_half_0 * a0_half_0_2
    a02_0 = -a0_half_0_3
    a03_0 = -2.0 * a02_0 * a0_half_0_2
    b0_0 = np.sqrt(t0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    lam0_2 = a02_0 * b0_0 + a02_0
    lam0_3 = a03_0 * b0_0 + a03_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    term03_0 = -term0_0 * (lam0_1 * term02_0 + lam0_2 * term01_0 + lam0_3 * term0_0)
    t18 = 0.25 * lam0_0
    X0_0 = t18 + 0.25 * y2
    t19 = 0.25 * lam0_1
    X0_1 = t19 + 0.25
    t20 = 0.25 * lam0_2
    t21 = 0.25 * lam0_3
    Y0_0 = 0.25 * t0 + t18
    Z0_0 = t18 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (-a11_0 * a11_0 + t20)
    a13_0 = a1_half_0 * (-2.0 * a11_0 * a12_0 + t21)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = b1_half_0 * t19
    b12_0 = b1_half_0 * (-b11_0 * b11_0 + t20)
    b13_0 = b1_half_0 * (-2.0 * b11_0 * b12_0 + t21)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t19
    c12_0 = c1_half_0 * (-c11_0 * c11_0 + t20)
    c13_0 = c1_half_0 * (-2.0 * c11_0 * c12_0 + t21)
    t22 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t22
    t23 = a11_0 + b11_0
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t22 + c1_0 * t23
    t24 = a12_0 + b12_0
    lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * t23 + c12_0 * t22 + c1_0 * t24
    lam1_3 = (
        a11_0 * b12_0 + a12_0 * b11_0 + a13_0 * b1_0 + a1_0 * b13_0 + c11_0 * t24 + c12_0 * t23 + c13_0 * t22 + c1_0
        * (a13_0 + b13_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t19
    q1_2 = lam1_2 + t20
    q1_3 = lam1_3 + t21
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    below1_3 = c11_0 * q1_2 + c12_0 * q1_1 + c13_0 * q1_0 + c1_0 * q1_3
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    term13_0 = -term1_0 * (below1_1 * term12_0 + below1_2 * term11_0 + below1_3 * term1_0)
    t25 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t25
    t26 = 0.25 * lam1_1
    X1_1 = 0.25 * X0_1 + t26
    t27 = 0.25 * lam1_2
    X1_2 = 0.25 * t20 + t27
    t28 = 0.25 * lam1_3
    X1_3 = 0.25 * t21 + t28
    Y1_0 = 0.25 * Y0_0 + t25
    Y1_1 = 0.25 * t19 + t26
    Y1_2 = 0.25 * t20 + t27
    Y1_3 = 0.25 * t21 + t28
    Z1_0 = 0.25 * Z0_0 + t25
    Z1_1 = 0.25 * t19 + t26
    Z1_2 = 0.25 * t20 + t27
    Z1_3 = 0.25 * t21 + t28
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0)
    a23_0 = a2_half_0 * (X1_3 - 2.0 * a21_0 * a22_0)
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0)
    b23_0 = b2_half_0 * (Y1_3 - 2.0 * b21_0 * b22_0)
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0)
    c23_0 = c2_half_0 * (Z1_3 - 2.0 * c21_0 * c22_0)
    t29 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t29
    t30 = a21_0 + b21_0
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t29 + c2_0 * t30
    t31 = a22_0 + b22_0
    lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * t30 + c22_0 * t29 + c2_0 * t31
    lam2_3 = (
        a21_0 * b22_0 + a22_0 * b21_0 + a23_0 * b2_0 + a2_0 * b23_0 + c21_0 * t31 + c22_0 * t30 + c23_0 * t29 + c2_0
        * (a23_0 + b23_0)
    )
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    q2_3 = Z1_3 + lam2_3
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    below2_3 = c21_0 * q2_2 + c22_0 * q2_1 + c23_0 * q2_0 + c2_0 * q2_3
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    term23_0 = -term2_0 * (below2_1 * term22_0 + below2_2 * term21_0 + below2_3 * term2_0)
    t32 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t32
    t33 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t33
    t34 = 0.25 * lam2_2
    X2_2 = 0.25 * X1_2 + t34
    t35 = 0.25 * lam2_3
    X2_3 = 0.25 * X1_3 + t35
    Y2_0 = 0.25 * Y1_0 + t32
    Y2_1 = 0.25 * Y1_1 + t33
    Y2_2 = 0.25 * Y1_2 + t34
    Y2_3 = 0.25 * Y1_3 + t35
    Z2_0 = 0.25 * Z1_0 + t32
    Z2_1 = 0.25 * Z1_1 + t33
    Z2_2 = 0.25 * Z1_2 + t34
    Z2_3 = 0.25 * Z1_3 + t35
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0)
    a33_0 = a3_half_0 * (X2_3 - 2.0 * a31_0 * a32_0)
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0)
    b33_0 = b3_half_0 * (Y2_3 - 2.0 * b31_0 * b32_0)
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0)
    c33_0 = c3_half_0 * (Z2_3 - 2.0 * c31_0 * c32_0)
    t36 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t36
    t37 = a31_0 + b31_0
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t36 + c3_0 * t37
    t38 = a32_0 + b32_0
    lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * t37 + c32_0 * t36 + c3_0 * t38
    lam3_3 = (
        a31_0 * b32_0 + a32_0 * b31_0 + a33_0 * b3_0 + a3_0 * b33_0 + c31_0 * t38 + c32_0 * t37 + c33_0 * t36 + c3_0
        * (a33_0 + b33_0)
    )
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    q3_3 = Z2_3 + lam3_3
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    below3_3 = c31_0 * q3_2 + c32_0 * q3_1 + c33_0 * q3_0 + c3_0 * q3_3
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    term33_0 = -term3_0 * (below3_1 * term32_0 + below3_2 * term31_0 + below3_3 * term3_0)
    t39 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t39
    t40 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t40
    t41 = 0.25 * lam3_2
    X3_2 = 0.25 * X2_2 + t41
    t42 = 0.25 * lam3_3
    X3_3 = 0.25 * X2_3 + t42
    Y3_0 = 0.25 * Y2_0 + t39
    Y3_1 = 0.25 * Y2_1 + t40
    Y3_2 = 0.25 * Y2_2 + t41
    Y3_3 = 0.25 * Y2_3 + t42
    Z3_0 = 0.25 * Z2_0 + t39
    Z3_1 = 0.25 * Z2_1 + t40
    Z3_2 = 0.25 * Z2_2 + t41
    Z3_3 = 0.25 * Z2_3 + t42
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0)
    a43_0 = a4_half_0 * (X3_3 - 2.0 * a41_0 * a42_0)
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0)
    b43_0 = b4_half_0 * (Y3_3 - 2.0 * b41_0 * b42_0)
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0)
    c43_0 = c4_half_0 * (Z3_3 - 2.0 * c41_0 * c42_0)
    t43 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t43
    t44 = a41_0 + b41_0
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t43 + c4_0 * t44
    t45 = a42_0 + b42_0
    lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * t44 + c42_0 * t43 + c4_0 * t45
    lam4_3 = (
        a41_0 * b42_0 + a42_0 * b41_0 + a43_0 * b4_0 + a4_0 * b43_0 + c41_0 * t45 + c42_0 * t44 + c43_0 * t43 + c4_0
        * (a43_0 + b43_0)
    )
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    q4_3 = Z3_3 + lam4_3
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    below4_3 = c41_0 * q4_2 + c42_0 * q4_1 + c43_0 * q4_0 + c4_0 * q4_3
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    term43_0 = -term4_0 * (below4_1 * term42_0 + below4_2 * term41_0 + below4_3 * term4_0)
    t46 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t46
    t47 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t47
    t48 = 0.25 * lam4_2
    X4_2 = 0.25 * X3_2 + t48
    t49 = 0.25 * lam4_3
    X4_3 = 0.25 * X3_3 + t49
    Y4_0 = 0.25 * Y3_0 + t46
    Y4_1 = 0.25 * Y3_1 + t47
    Y4_2 = 0.25 * Y3_2 + t48
    Y4_3 = 0.25 * Y3_3 + t49
    Z4_0 = 0.25 * Z3_0 + t46
    Z4_1 = 0.25 * Z3_1 + t47
    Z4_2 = 0.25 * Z3_2 + t48
    Z4_3 = 0.25 * Z3_3 + t49
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0)
    a53_0 = a5_half_0 * (X4_3 - 2.0 * a51_0 * a52_0)
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0)
    b53_0 = b5_half_0 * (Y4_3 - 2.0 * b51_0 * b52_0)
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0)
    c53_0 = c5_half_0 * (Z4_3 - 2.0 * c51_0 * c52_0)
    t50 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t50
    t51 = a51_0 + b51_0
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t50 + c5_0 * t51
    t52 = a52_0 + b52_0
    lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * t51 + c52_0 * t50 + c5_0 * t52
    lam5_3 = (
        a51_0 * b52_0 + a52_0 * b51_0 + a53_0 * b5_0 + a5_0 * b53_0 + c51_0 * t52 + c52_0 * t51 + c53_0 * t50 + c5_0
        * (a53_0 + b53_0)
    )
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    q5_3 = Z4_3 + lam5_3
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    below5_3 = c51_0 * q5_2 + c52_0 * q5_1 + c53_0 * q5_0 + c5_0 * q5_3
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    term53_0 = -term5_0 * (below5_1 * term52_0 + below5_2 * term51_0 + below5_3 * term5_0)
    t53 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t53
    t54 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t54
    t55 = 0.25 * lam5_2
    X5_2 = 0.25 * X4_2 + t55
    t56 = 0.25 * lam5_3
    X5_3 = 0.25 * X4_3 + t56
    Y5_0 = 0.25 * Y4_0 + t53
    Y5_1 = 0.25 * Y4_1 + t54
    Y5_2 = 0.25 * Y4_2 + t55
    Y5_3 = 0.25 * Y4_3 + t56
    Z5_0 = 0.25 * Z4_0 + t53
    Z5_1 = 0.25 * Z4_1 + t54
    Z5_2 = 0.25 * Z4_2 + t55
    Z5_3 = 0.25 * Z4_3 + t56
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    mean_3 = 0.20000000000000001 * X5_3 + 0.20000000000000001 * Y5_3 + 0.59999999999999998 * Z5_3
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    over3_0 = -over_0 * (mean_1 * over2_0 + mean_2 * over1_0 + mean_3 * over_0)
    t57 = -mean_0
    t58 = -X5_0 - t57
    dx_0 = over_0 * t58
    t59 = -mean_1
    t60 = -X5_1 - t59
    dx_1 = over1_0 * t58 + over_0 * t60
    t61 = -mean_2
    t62 = -X5_2 - t61
    dx_2 = over1_0 * t60 + over2_0 * t58 + over_0 * t62
    t63 = -mean_3
    dx_3 = over1_0 * t62 + over2_0 * t60 + over3_0 * t58 + over_0 * (-X5_3 - t63)
    t64 = -Y5_0 - t57
    dy_0 = over_0 * t64
    t65 = -Y5_1 - t59
    dy_1 = over1_0 * t64 + over_0 * t65
    t66 = -Y5_2 - t61
    dy_2 = over1_0 * t65 + over2_0 * t64 + over_0 * t66
    dy_3 = over1_0 * t66 + over2_0 * t65 + over3_0 * t64 + over_0 * (-Y5_3 - t63)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    dz_3 = -0.33333333333333331 * dx_3 - 0.33333333333333331 * dy_3
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    xy_3 = dx_0 * dy_3 + dx_1 * dy_2 + dx_2 * dy_1 + dx_3 * dy_0
    zz_0 = dz_0 * dz_0
    t67 = 2.0 * dz_0
    zz_1 = dz_1 * t67
    zz_2 = dz_1 * dz_1 + dz_2 * t67
    zz_3 = 2.0 * dz_1 * dz_2 + dz_3 * t67
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E2_3 = xy_3 - 6.0 * zz_3
    t68 = 3.0 * xy_0
    t69 = t68 - 8.0 * zz_0
    E3_0 = dz_0 * t69
    t70 = 3.0 * xy_1
    t71 = t70 - 8.0 * zz_1
    E3_1 = dz_0 * t71 + dz_1 * t69
    t72 = 3.0 * xy_2
    t73 = t72 - 8.0 * zz_2
    E3_2 = dz_0 * t73 + dz_1 * t71 + dz_2 * t69
    t74 = 3.0 * xy_3
    E3_3 = dz_0 * (t74 - 8.0 * zz_3) + dz_1 * t73 + dz_2 * t71 + dz_3 * t69
    t75 = t68 - 3.0 * zz_0
    E4_0 = t75 * zz_0
    t76 = t70 - 3.0 * zz_1
    E4_1 = t75 * zz_1 + t76 * zz_0
    t77 = t72 - 3.0 * zz_2
    E4_2 = t75 * zz_2 + t76 * zz_1 + t77 * zz_0
    E4_3 = t75 * zz_3 + t76 * zz_2 + t77 * zz_1 + zz_0 * (t74 - 3.0 * zz_3)
    t78 = xy_0 * zz_0
    E5_0 = dz_0 * t78
    t79 = xy_0 * zz_1 + xy_1 * zz_0
    E5_1 = dz_0 * t79 + dz_1 * t78
    t80 = xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0
    E5_2 = dz_0 * t80 + dz_1 * t79 + dz_2 * t78
    E5_3 = dz_0 * (xy_0 * zz_3 + xy_1 * zz_2 + xy_2 * zz_1 + xy_3 * zz_0) + dz_1 * t80 + dz_2 * t79 + dz_3 * t78
    t81 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t81 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    t82 = 0.17307692307692307 * E2_1
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.21428571428571427 * E2_1 - E3_0 * t82 - E3_1 * t81 +
        0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    t83 = 0.17307692307692307 * E2_2
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 + 0.10227272727272728 * E2_1 * E2_1 - 0.21428571428571427 * E2_2 - E3_0 *
        t83 - E3_1 * t82 - E3_2 * t81 + 0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 +
        0.11538461538461539 * E5_2
    )
    series_3 = (
        0.20454545454545456 * E2_0 * E2_3 + 0.20454545454545456 * E2_1 * E2_2 - 0.17307692307692307 * E2_3 * E3_0 -
        0.21428571428571427 * E2_3 - E3_1 * t83 - E3_2 * t82 - E3_3 * t81 + 0.16666666666666666 * E3_3 -
        0.13636363636363635 * E4_3 + 0.11538461538461539 * E5_3
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0)
    sq3_0 = sq_half_0 * (over3_0 - 2.0 * sq1_0 * sq2_0)
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0
    power_3 = over1_0 * sq2_0 + over2_0 * sq1_0 + over3_0 * sq_0 + over_0 * sq3_0
    last_0 = power_0 * series_0
    last_1 = power_0 * series_1 + power_1 * series_0
    last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0
    last_3 = power_0 * series_3 + power_1 * series_2 + power_2 * series_1 + power_3 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    R_2 = (
        0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 * term32_0 +
        0.01171875 * term42_0 + 0.0029296875 * term52_0
    )
    R_3 = (
        0.000244140625 * last_3 + 3.0 * term03_0 + 0.75 * term13_0 + 0.1875 * term23_0 + 0.046875 * term33_0 +
        0.01171875 * term43_0 + 0.0029296875 * term53_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    x2_2 = x2 * x2
    V6 = 2.6666666666666665 * R_2 * third * x2_2
    x2_3 = x2 * x2_2
    V8 = -3.2000000000000002 * R_3 * third * x2_3
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    t84 = 1.0 - t2
    tangent_1 = 3.975186474361974 * t1 / (t84 * t84)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t85 = 1.0 - t3
    tangent_2 = 3.8704119070267997 * t1 / (t85 * t85)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t86 = 1.0 - t4
    tangent_3 = 3.6865679248689092 * t1 / (t86 * t86)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t87 = 1.0 - t5
    tangent_4 = 3.4313861114319599 * t1 / (t87 * t87)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t88 = 1.0 - t6
    tangent_5 = 3.1156523973502206 * t1 / (t88 * t88)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t89 = 1.0 - t7
    tangent_6 = 2.7527174164708152 * t1 / (t89 * t89)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t90 = 1.0 - t8
    tangent_7 = 2.3579287409979242 * t1 / (t90 * t90)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t91 = 1.0 - t9
    tangent_8 = 1.9479812523331028 * t1 / (t91 * t91)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t92 = 1.0 - t10
    tangent_9 = 1.5402109751007973 * t1 / (t92 * t92)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t93 = 1.0 - t11
    tangent_10 = 1.1518619054765942 * t1 / (t93 * t93)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t94 = 1.0 - t12
    tangent_11 = 0.79935676442973369 * t1 / (t94 * t94)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t95 = 1.0 - t13
    tangent_12 = 0.49760249364724823 * t1 / (t95 * t95)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t96 = 1.0 - t14
    tangent_13 = 0.25935985667292555 * t1 / (t96 * t96)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t97 = 1.0 - t15
    tangent_14 = 0.094703801255651851 * t1 / (t97 * t97)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t98 = 1.0 - t16
    tangent_15 = 0.010597402304157654 * t1 / (t98 * t98)
    T3 = T * t1
    t99 = 8.0 * T3
    S_0 = (
        t99 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    S_1 = (
        t99 * (tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13
        * term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 +
        tangent_4 * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 +
        tangent_9 * term_9)
    )
    tangent_1_2 = tangent_1 * tangent_1
    tangent_10_2 = tangent_10 * tangent_10
    tangent_11_2 = tangent_11 * tangent_11
    tangent_12_2 = tangent_12 * tangent_12
    tangent_13_2 = tangent_13 * tangent_13
    tangent_14_2 = tangent_14 * tangent_14
    tangent_15_2 = tangent_15 * tangent_15
    tangent_2_2 = tangent_2 * tangent_2
    tangent_3_2 = tangent_3 * tangent_3
    tangent_4_2 = tangent_4 * tangent_4
    tangent_5_2 = tangent_5 * tangent_5
    tangent_6_2 = tangent_6 * tangent_6
    tangent_7_2 = tangent_7 * tangent_7
    tangent_8_2 = tangent_8 * tangent_8
    tangent_9_2 = tangent_9 * tangent_9
    S_2 = (
        t99 * (tangent_10_2 * term_10 + tangent_11_2 * term_11 + tangent_12_2 * term_12 + tangent_13_2 * term_13 +
        tangent_14_2 * term_14 + tangent_15_2 * term_15 + tangent_1_2 * term_1 + tangent_2_2 * term_2 + tangent_3_2
        * term_3 + tangent_4_2 * term_4 + tangent_5_2 * term_5 + tangent_6_2 * term_6 + tangent_7_2 * term_7 +
        tangent_8_2 * term_8 + tangent_9_2 * term_9)
    )
    tangent_1_3 = tangent_1 * tangent_1_2
    tangent_10_3 = tangent_10 * tangent_10_2
    tangent_11_3 = tangent_11 * tangent_11_2
    tangent_12_3 = tangent_12 * tangent_12_2
    tangent_13_3 = tangent_13 * tangent_13_2
    tangent_14_3 = tangent_14 * tangent_14_2
    tangent_15_3 = tangent_15 * tangent_15_2
    tangent_2_3 = tangent_2 * tangent_2_2
    tangent_3_3 = tangent_3 * tangent_3_2
    tangent_4_3 = tangent_4 * tangent_4_2
    tangent_5_3 = tangent_5 * tangent_5_2
    tangent_6_3 = tangent_6 * tangent_6_2
    tangent_7_3 = tangent_7 * tangent_7_2
    tangent_8_3 = tangent_8 * tangent_8_2
    tangent_9_3 = tangent_9 * tangent_9_2
    S_3 = (
        t99 * (tangent_10_3 * term_10 + tangent_11_3 * term_11 + tangent_12_3 * term_12 + tangent_13_3 * term_13 +
        tangent_14_3 * term_14 + tangent_15_3 * term_15 + tangent_1_3 * term_1 + tangent_2_3 * term_2 + tangent_3_3
        * term_3 + tangent_4_3 * term_4 + tangent_5_3 * term_5 + tangent_6_3 * term_6 + tangent_7_3 * term_7 +
        tangent_8_3 * term_8 + tangent_9_3 * term_9)
    )
    t100 = 1.0 / c
    return (
        2.5464790894703255 * beta * t17 * (-24.0 * S_0 * t100 - 48.0 * S_1 * t100 - 45.0 * S_2 * t100 - 15.0 * S_3 *
        t100 + 24.0 * V2 + 48.0 * V4 + 45.0 * V6 + 15.0 * V8),
    )


def _h_AAA_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 1289 structured, 1115 common subexpressions, 1106 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    A2 = A * A
    t1 = 1.0 / A2
    u_cr2 = u_cr * u_cr
    x2 = t1 * u_cr2
    root2 = root * root
    y2 = root2 * t1
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(t0)
    b0_half_0 = 0.5 / b0_0
    b0_half_0_2 = b0_half_0 * b0_half_0
    b0_half_0_3 = b0_half_0 * b0_half_0_2
    b02_0 = -b0_half_0_3
    b03_0 = -2.0 * b02_0 * b0_half_0_2
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_0 * b0_half_0 + b0_half_0
    lam0_2 = a0_0 * b02_0 + b02_0
    lam0_3 = a0_0 * b03_0 + b03_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    term03_0 = -term0_0 * (lam0_1 * term02_0 + lam0_2 * term01_0 + lam0_3 * term0_0)
    t2 = 0.25 * lam0_0
    X0_0 = t2 + 0.25 * y2
    t3 = 0.25 * lam0_1
    t4 = 0.25 * lam0_2
    t5 = 0.25 * lam0_3
    Y0_0 = 0.25 * t0 + t2
    Y0_1 = t3 + 0.25
    Z0_0 = t2 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = a1_half_0 * t3
    a12_0 = a1_half_0 * (-a11_0 * a11_0 + t4)
    a13_0 = a1_half_0 * (-2.0 * a11_0 * a12_0 + t5)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (-b11_0 * b11_0 + t4)
    b13_0 = b1_half_0 * (-2.0 * b11_0 * b12_0 + t5)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t3
    c12_0 = c1_half_0 * (-c11_0 * c11_0 + t4)
    c13_0 = c1_half_0 * (-2.0 * c11_0 * c12_0 + t5)
    t6 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t6
    t7 = a11_0 + b11_0
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t6 + c1_0 * t7
    t8 = a12_0 + b12_0
    lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * t7 + c12_0 * t6 + c1_0 * t8
    lam1_3 = (
        a11_0 * b12_0 + a12_0 * b11_0 + a13_0 * b1_0 + a1_0 * b13_0 + c11_0 * t8 + c12_0 * t7 + c13_0 * t6 + c1_0 *
        (a13_0 + b13_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t3
    q1_2 = lam1_2 + t4
    q1_3 = lam1_3 + t5
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    below1_3 = c11_0 * q1_2 + c12_0 * q1_1 + c13_0 * q1_0 + c1_0 * q1_3
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    term13_0 = -term1_0 * (below1_1 * term12_0 + below1_2 * term11_0 + below1_3 * term1_0)
    t9 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t9
    t10 = 0.25 * lam1_1
    X1_1 = t10 + 0.25 * t3
    t11 = 0.25 * lam1_2
    X1_2 = t11 + 0.25 * t4
    t12 = 0.25 * lam1_3
    X1_3 = t12 + 0.25 * t5
    Y1_0 = 0.25 * Y0_0 + t9
    Y1_1 = 0.25 * Y0_1 + t10
    Y1_2 = t11 + 0.25 * t4
    Y1_3 = t12 + 0.25 * t5
    Z1_0 = 0.25 * Z0_0 + t9
    Z1_1 = t10 + 0.25 * t3
    Z1_2 = t11 + 0.25 * t4
    Z1_3 = t12 + 0.25 * t5
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0)
    a23_0 = a2_half_0 * (X1_3 - 2.0 * a21_0 * a22_0)
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0)
    b23_0 = b2_half_0 * (Y1_3 - 2.0 * b21_0 * b22_0)
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0)
    c23_0 = c2_half_0 * (Z1_3 - 2.0 * c21_0 * c22_0)
    t13 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t13
    t14 = a21_0 + b21_0
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t13 + c2_0 * t14
    t15 = a22_0 + b22_0
    lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * t14 + c22_0 * t13 + c2_0 * t15
    lam2_3 = (
        a21_0 * b22_0 + a22_0 * b21_0 + a23_0 * b2_0 + a2_0 * b23_0 + c21_0 * t15 + c22_0 * t14 + c23_0 * t13 + c2_0
        * (a23_0 + b23_0)
    )
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    q2_3 = Z1_3 + lam2_3
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    below2_3 = c21_0 * q2_2 + c22_0 * q2_1 + c23_0 * q2_0 + c2_0 * q2_3
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    term23_0 = -term2_0 * (below2_1 * term22_0 + below2_2 * term21_0 + below2_3 * term2_0)
    t16 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t16
    t17 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t17
    t18 = 0.25 * lam2_2
    X2_2 = 0.25 * X1_2 + t18
    t19 = 0.25 * lam2_3
    X2_3 = 0.25 * X1_3 + t19
    Y2_0 = 0.25 * Y1_0 + t16
    Y2_1 = 0.25 * Y1_1 + t17
    Y2_2 = 0.25 * Y1_2 + t18
    Y2_3 = 0.25 * Y1_3 + t19
    Z2_0 = 0.25 * Z1_0 + t16
    Z2_1 = 0.25 * Z1_1 + t17
    Z2_2 = 0.25 * Z1_2 + t18
    Z2_3 = 0.25 * Z1_3 + t19
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0)
    a33_0 = a3_half_0 * (X2_3 - 2.0 * a31_0 * a32_0)
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0)
    b33_0 = b3_half_0 * (Y2_3 - 2.0 * b31_0 * b32_0)
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0)
    c33_0 = c3_half_0 * (Z2_3 - 2.0 * c31_0 * c32_0)
    t20 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t20
    t21 = a31_0 + b31_0
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t20 + c3_0 * t21
    t22 = a32_0 + b32_0
    lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * t21 + c32_0 * t20 + c3_0 * t22
    lam3_3 = (
        a31_0 * b32_0 + a32_0 * b31_0 + a33_0 * b3_0 + a3_0 * b33_0 + c31_0 * t22 + c32_0 * t21 + c33_0 * t20 + c3_0
        * (a33_0 + b33_0)
    )
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    q3_3 = Z2_3 + lam3_3
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    below3_3 = c31_0 * q3_2 + c32_0 * q3_1 + c33_0 * q3_0 + c3_0 * q3_3
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    term33_0 = -term3_0 * (below3_1 * term32_0 + below3_2 * term31_0 + below3_3 * term3_0)
    t23 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t23
    t24 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t24
    t25 = 0.25 * lam3_2
    X3_2 = 0.25 * X2_2 + t25
    t26 = 0.25 * lam3_3
    X3_3 = 0.25 * X2_3 + t26
    Y3_0 = 0.25 * Y2_0 + t23
    Y3_1 = 0.25 * Y2_1 + t24
    Y3_2 = 0.25 * Y2_2 + t25
    Y3_3 = 0.25 * Y2_3 + t26
    Z3_0 = 0.25 * Z2_0 + t23
    Z3_1 = 0.25 * Z2_1 + t24
    Z3_2 = 0.25 * Z2_2 + t25
    Z3_3 = 0.25 * Z2_3 + t26
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0)
    a43_0 = a4_half_0 * (X3_3 - 2.0 * a41_0 * a42_0)
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0)
    b43_0 = b4_half_0 * (Y3_3 - 2.0 * b41_0 * b42_0)
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0)
    c43_0 = c4_half_0 * (Z3_3 - 2.0 * c41_0 * c42_0)
    t27 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t27
    t28 = a41_0 + b41_0
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t27 + c4_0 * t28
    t29 = a42_0 + b42_0
    lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * t28 + c42_0 * t27 + c4_0 * t29
    lam4_3 = (
        a41_0 * b42_0 + a42_0 * b41_0 + a43_0 * b4_0 + a4_0 * b43_0 + c41_0 * t29 + c42_0 * t28 + c43_0 * t27 + c4_0
        * (a43_0 + b43_0)
    )
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    q4_3 = Z3_3 + lam4_3
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    below4_3 = c41_0 * q4_2 + c42_0 * q4_1 + c43_0 * q4_0 + c4_0 * q4_3
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    term43_0 = -term4_0 * (below4_1 * term42_0 + below4_2 * term41_0 + below4_3 * term4_0)
    t30 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t30
    t31 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t31
    t32 = 0.25 * lam4_2
    X4_2 = 0.25 * X3_2 + t32
    t33 = 0.25 * lam4_3
    X4_3 = 0.25 * X3_3 + t33
    Y4_0 = 0.25 * Y3_0 + t30
    Y4_1 = 0.25 * Y3_1 + t31
    Y4_2 = 0.25 * Y3_2 + t32
    Y4_3 = 0.25 * Y3_3 + t33
    Z4_0 = 0.25 * Z3_0 + t30
    Z4_1 = 0.25 * Z3_1 + t31
    Z4_2 = 0.25 * Z3_2 + t32
    Z4_3 = 0.25 * Z3_3 + t33
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0)
    a53_0 = a5_half_0 * (X4_3 - 2.0 * a51_0 * a52_0)
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0)
    b53_0 = b5_half_0 * (Y4_3 - 2.0 * b51_0 * b52_0)
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0)
    c53_0 = c5_half_0 * (Z4_3 - 2.0 * c51_0 * c52_0)
    t34 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t34
    t35 = a51_0 + b51_0
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t34 + c5_0 * t35
    t36 = a52_0 + b52_0
    lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * t35 + c52_0 * t34 + c5_0 * t36
    lam5_3 = (
        a51_0 * b52_0 + a52_0 * b51_0 + a53_0 * b5_0 + a5_0 * b53_0 + c51_0 * t36 + c52_0 * t35 + c53_0 * t34 + c5_0
        * (a53_0 + b53_0)
    )
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    q5_3 = Z4_3 + lam5_3
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    below5_3 = c51_0 * q5_2 + c52_0 * q5_1 + c53_0 * q5_0 + c5_0 * q5_3
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    term53_0 = -term5_0 * (below5_1 * term52_0 + below5_2 * term51_0 + below5_3 * term5_0)
    t37 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t37
    t38 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t38
    t39 = 0.25 * lam5_2
    X5_2 = 0.25 * X4_2 + t39
    t40 = 0.25 * lam5_3
    X5_3 = 0.25 * X4_3 + t40
    Y5_0 = 0.25 * Y4_0 + t37
    Y5_1 = 0.25 * Y4_1 + t38
    Y5_2 = 0.25 * Y4_2 + t39
    Y5_3 = 0.25 * Y4_3 + t40
    Z5_0 = 0.25 * Z4_0 + t37
    Z5_1 = 0.25 * Z4_1 + t38
    Z5_2 = 0.25 * Z4_2 + t39
    Z5_3 = 0.25 * Z4_3 + t40
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    mean_3 = 0.20000000000000001 * X5_3 + 0.20000000000000001 * Y5_3 + 0.59999999999999998 * Z5_3
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    over3_0 = -over_0 * (mean_1 * over2_0 + mean_2 * over1_0 + mean_3 * over_0)
    t41 = -mean_0
    t42 = -X5_0 - t41
    dx_0 = over_0 * t42
    t43 = -mean_1
    t44 = -X5_1 - t43
    dx_1 = over1_0 * t42 + over_0 * t44
    t45 = -mean_2
    t46 = -X5_2 - t45
    dx_2 = over1_0 * t44 + over2_0 * t42 + over_0 * t46
    t47 = -mean_3
    dx_3 = over1_0 * t46 + over2_0 * t44 + over3_0 * t42 + over_0 * (-X5_3 - t47)
    t48 = -Y5_0 - t41
    dy_0 = over_0 * t48
    t49 = -Y5_1 - t43
    dy_1 = over1_0 * t48 + over_0 * t49
    t50 = -Y5_2 - t45
    dy_2 = over1_0 * t49 + over2_0 * t48 + over_0 * t50
    dy_3 = over1_0 * t50 + over2_0 * t49 + over3_0 * t48 + over_0 * (-Y5_3 - t47)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    dz_3 = -0.33333333333333331 * dx_3 - 0.33333333333333331 * dy_3
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    xy_3 = dx_0 * dy_3 + dx_1 * dy_2 + dx_2 * dy_1 + dx_3 * dy_0
    zz_0 = dz_0 * dz_0
    t51 = 2.0 * dz_0
    zz_1 = dz_1 * t51
    zz_2 = dz_1 * dz_1 + dz_2 * t51
    zz_3 = 2.0 * dz_1 * dz_2 + dz_3 * t51
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E2_3 = xy_3 - 6.0 * zz_3
    t52 = 3.0 * xy_0
    t53 = t52 - 8.0 * zz_0
    E3_0 = dz_0 * t53
    t54 = 3.0 * xy_1
    t55 = t54 - 8.0 * zz_1
    E3_1 = dz_0 * t55 + dz_1 * t53
    t56 = 3.0 * xy_2
    t57 = t56 - 8.0 * zz_2
    E3_2 = dz_0 * t57 + dz_1 * t55 + dz_2 * t53
    t58 = 3.0 * xy_3
    E3_3 = dz_0 * (t58 - 8.0 * zz_3) + dz_1 * t57 + dz_2 * t55 + dz_3 * t53
    t59 = t52 - 3.0 * zz_0
    E4_0 = t59 * zz_0
    t60 = t54 - 3.0 * zz_1
    E4_1 = t59 * zz_1 + t60 * zz_0
    t61 = t56 - 3.0 * zz_2
    E4_2 = t59 * zz_2 + t60 * zz_1 + t61 * zz_0
    E4_3 = t59 * zz_3 + t60 * zz_2 + t61 * zz_1 + zz_0 * (t58 - 3.0 * zz_3)
    t62 = xy_0 * zz_0
    E5_0 = dz_0 * t62
    t63 = xy_0 * zz_1 + xy_1 * zz_0
    E5_1 = dz_0 * t63 + dz_1 * t62
    t64 = xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0
    E5_2 = dz_0 * t64 + dz_1 * t63 + dz_2 * t62
    E5_3 = dz_0 * (xy_0 * zz_3 + xy_1 * zz_2 + xy_2 * zz_1 + xy_3 * zz_0) + dz_1 * t64 + dz_2 * t63 + dz_3 * t62
    t65 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t65 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    t66 = 0.17307692307692307 * E2_1
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.21428571428571427 * E2_1 - E3_0 * t66 - E3_1 * t65 +
        0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    t67 = 0.17307692307692307 * E2_2
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 + 0.10227272727272728 * E2_1 * E2_1 - 0.21428571428571427 * E2_2 - E3_0 *
        t67 - E3_1 * t66 - E3_2 * t65 + 0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 +
        0.11538461538461539 * E5_2
    )
    series_3 = (
        0.20454545454545456 * E2_0 * E2_3 + 0.20454545454545456 * E2_1 * E2_2 - 0.17307692307692307 * E2_3 * E3_0 -
        0.21428571428571427 * E2_3 - E3_1 * t67 - E3_2 * t66 - E3_3 * t65 + 0.16666666666666666 * E3_3 -
        0.13636363636363635 * E4_3 + 0.11538461538461539 * E5_3
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0)
    sq3_0 = sq_half_0 * (over3_0 - 2.0 * sq1_0 * sq2_0)
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0
    power_3 = over1_0 * sq2_0 + over2_0 * sq1_0 + over3_0 * sq_0 + over_0 * sq3_0
    last_1 = power_0 * series_1 + power_1 * series_0
    last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0
    last_3 = power_0 * series_3 + power_1 * series_2 + power_2 * series_1 + power_3 * series_0
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    R_2 = (
        0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 * term32_0 +
        0.01171875 * term42_0 + 0.0029296875 * term52_0
    )
    R_3 = (
        0.000244140625 * last_3 + 3.0 * term03_0 + 0.75 * term13_0 + 0.1875 * term23_0 + 0.046875 * term33_0 +
        0.01171875 * term43_0 + 0.0029296875 * term53_0
    )
    V4 = -2.0 * R_1 * third * x2
    x2_2 = x2 * x2
    V6 = 2.6666666666666665 * R_2 * third * x2_2
    x2_3 = x2 * x2_2
    V8 = -3.2000000000000002 * R_3 * third * x2_3
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    c2 = c * c
    c3 = c * c2
    t68 = u_cr5 / c3
    A4 = A2 * A2
    t69 = 3.0 / (A4 * root)
    root3 = root * root2
    c4 = c2 * c2
    c5 = c * c4
    return (
        -2.5464790894703255 * beta * (3.0 * A2 * (5.0 * A2 * V8 + 6.0 * V6) + 3.0 * V4 + t68 * t69 + t1 * t68 /
        root3 - t69 * u_cr5 / c5),
    )


def h_AAA(A, alpha, beta, u_cr):
    """d3/dA3 of the averaged restoring force h = H - A.

    Equation from (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_h_AAA_passed_0, _h_AAA_passed_0_steep, _h_AAA_passed_1, _h_AAA_passed_1_steep_far, _h_AAA_passed_1_steep)
    return by_regime(guards, bodies, arguments, 1)[0]


def _H_passed_0(A, alpha, beta, u_cr):
    # operations: 60 structured, 55 common subexpressions, 55 power chains
    m = A * A
    k_c = np.sqrt(1.0 - A) * np.sqrt(A + 1.0)
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t0 = e_1 * e_1
    t1 = 0.25 * m
    e_2 = t0 * t1 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t2 = e_2 * e_2
    e_3 = t1 * t2 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    t3 = e_3 * e_3
    t4 = m / a_4
    e_4 = 0.25 * t3 * t4
    e = e_1 + e_2 + e_3 + e_4
    tau = 16.0 * e_4 * e_4 + 2.0 * t0 + 4.0 * t2 + 8.0 * t3
    P = t4 * (e + tau)
    return (
        -2.0 * A * P * beta - A * (alpha - 1.0),
    )


def _H_passed_0_steep(A, alpha, beta, u_cr):
    # operations: 116 structured, 103 common subexpressions, 103 power chains
    m = A * A
    k_c = np.sqrt(1.0 - A) * np.sqrt(A + 1.0)
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t0 = e_1 * e_1
    t1 = 0.25 * m
    e_2 = t0 * t1 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t2 = e_2 * e_2
    e_3 = t1 * t2 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    b_4 = np.sqrt(a_3) * np.sqrt(b_3)
    t3 = e_3 * e_3
    e_4 = t1 * t3 / a_4
    a_5 = 0.5 * a_4 + 0.5 * b_4
    b_5 = np.sqrt(a_4) * np.sqrt(b_4)
    t4 = e_4 * e_4
    e_5 = t1 * t4 / a_5
    a_6 = 0.5 * a_5 + 0.5 * b_5
    b_6 = np.sqrt(a_5) * np.sqrt(b_5)
    t5 = e_5 * e_5
    e_6 = t1 * t5 / a_6
    a_7 = 0.5 * a_6 + 0.5 * b_6
    b_7 = np.sqrt(a_6) * np.sqrt(b_6)
    t6 = e_6 * e_6
    e_7 = t1 * t6 / a_7
    a_8 = 0.5 * a_7 + 0.5 * b_7
    t7 = e_7 * e_7
    t8 = m / a_8
    e_8 = 0.25 * t7 * t8
    e = e_1 + e_2 + e_3 + e_4 + e_5 + e_6 + e_7 + e_8
    tau = 256.0 * e_8 * e_8 + 2.0 * t0 + 4.0 * t2 + 8.0 * t3 + 16.0 * t4 + 32.0 * t5 + 64.0 * t6 + 128.0 * t7
    P = t8 * (e + tau)
    return (
        -2.0 * A * P * beta - A * (alpha - 1.0),
    )


def _H_passed_1(A, alpha, beta, u_cr):
    # operations: 368 structured, 367 common subexpressions, 366 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    c = np.sqrt((1.0 - u_cr) * (u_cr + 1.0))
    T = u_cr / (A + root)
    t0 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0)
    U2 = 4.0 * A * A * t0
    v2_1 = 0.99379661859049351 * g_1 * g_1
    square_1 = -U2 * v2_1 + 1.0
    delta_1 = np.sqrt(square_1)
    f_1 = 0.007968192496166605 * g_1 * v2_1 / delta_1
    v2_2 = 0.96760297675669993 * g_2 * g_2
    square_2 = -U2 * v2_2 + 1.0
    delta_2 = np.sqrt(square_2)
    f_2 = 0.018466468311090958 * g_2 * v2_2 / delta_2
    v2_3 = 0.92164198121722729 * g_3 * g_3
    square_3 = -U2 * v2_3 + 1.0
    delta_3 = np.sqrt(square_3)
    f_3 = 0.028784707883323369 * g_3 * v2_3 / delta_3
    v2_4 = 0.85784652785798998 * g_4 * g_4
    square_4 = -U2 * v2_4 + 1.0
    delta_4 = np.sqrt(square_4)
    f_4 = 0.03879919256962705 * g_4 * v2_4 / delta_4
    v2_5 = 0.77891309933755515 * g_5 * g_5
    square_5 = -U2 * v2_5 + 1.0
    delta_5 = np.sqrt(square_5)
    f_5 = 0.048402672830594053 * g_5 * v2_5 / delta_5
    v2_6 = 0.68817935411770381 * g_6 * g_6
    square_6 = -U2 * v2_6 + 1.0
    delta_6 = np.sqrt(square_6)
    f_6 = 0.057493156217619065 * g_6 * v2_6 / delta_6
    v2_7 = 0.58948218524948104 * g_7 * g_7
    square_7 = -U2 * v2_7 + 1.0
    delta_7 = np.sqrt(square_7)
    f_7 = 0.065974229882180491 * g_7 * v2_7 / delta_7
    v2_8 = 0.4869953130832757 * g_8 * g_8
    square_8 = -U2 * v2_8 + 1.0
    delta_8 = np.sqrt(square_8)
    f_8 = 0.073755974737705204 * g_8 * v2_8 / delta_8
    v2_9 = 0.38505274377519932 * g_9 * g_9
    square_9 = -U2 * v2_9 + 1.0
    delta_9 = np.sqrt(square_9)
    f_9 = 0.080755895229420213 * g_9 * v2_9 / delta_9
    v2_10 = 0.28796547636914854 * g_10 * g_10
    square_10 = -U2 * v2_10 + 1.0
    delta_10 = np.sqrt(square_10)
    f_10 = 0.086899787201082976 * g_10 * v2_10 / delta_10
    v2_11 = 0.19983919110743342 * g_11 * g_11
    square_11 = -U2 * v2_11 + 1.0
    delta_11 = np.sqrt(square_11)
    f_11 = 0.092122522237786122 * g_11 * v2_11 / delta_11
    v2_12 = 0.12440062341181206 * g_12 * g_12
    square_12 = -U2 * v2_12 + 1.0
    delta_12 = np.sqrt(square_12)
    f_12 = 0.096368737174644253 * g_12 * v2_12 / delta_12
    v2_13 = 0.064839964168231387 * g_13 * g_13
    square_13 = -U2 * v2_13 + 1.0
    delta_13 = np.sqrt(square_13)
    f_13 = 0.099593420586795267 * g_13 * v2_13 / delta_13
    v2_14 = 0.023675950313912963 * g_14 * g_14
    square_14 = -U2 * v2_14 + 1.0
    delta_14 = np.sqrt(square_14)
    f_14 = 0.1017623897484055 * g_14 * v2_14 / delta_14
    v2_15 = 0.0026493505760394136 * g_15 * g_15
    square_15 = -U2 * v2_15 + 1.0
    delta_15 = np.sqrt(square_15)
    f_15 = 0.10285265289355884 * g_15 * v2_15 / delta_15
    sum_0 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1) + f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0)
        * (g_10 * (0.53662414814201986 * t0 + 0.53662414814201986) + 1.0) / (c + delta_10) + f_11 * g_11 *
        (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 + 0.44703376953808915)
        + 1.0) / (c + delta_11) + f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 *
        (0.35270472553087812 * t0 + 0.35270472553087812) + 1.0) / (c + delta_12) + f_13 * g_13 * (0.7453630738321102
        - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 + 0.25463692616788985) + 1.0) / (c +
        delta_13) + f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 *
        t0 + 0.15386991360858354) + 1.0) / (c + delta_14) + f_15 * g_15 * (0.94852815744468233 -
        0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 + 0.051471842555317698) + 1.0) / (c +
        delta_15) + f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0
        + 0.98366812327974718) + 1.0) / (c + delta_2) + f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 *
        t0) * (g_3 * (0.96002186496830755 * t0 + 0.96002186496830755) + 1.0) / (c + delta_3) + f_4 * g_4 *
        (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 + 0.92620004742927431)
        + 1.0) / (c + delta_4) + f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 *
        (0.88256053579205274 * t0 + 0.88256053579205274) + 1.0) / (c + delta_5) + f_6 * g_6 * (0.17043423761723162 -
        0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 + 0.82956576238276836) + 1.0) / (c + delta_6) +
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7) + f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) *
        (g_8 * (0.69785049479331585 * t0 + 0.69785049479331585) + 1.0) / (c + delta_8) + f_9 * g_9 *
        (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 + 0.62052618298924289) +
        1.0) / (c + delta_9)
    )
    T3 = T * t0
    return (
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr * u_cr / c,
    )


def _H_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 304 structured, 288 common subexpressions, 287 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t1 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t1 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t1 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t1 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t1 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t1 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t1 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t1 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t1 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t1 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t1 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t1 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t1 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t1 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t1 + 1.0)
    t2 = 1.0 / (A * A)
    x2 = t2 * u_cr * u_cr
    y2 = root * root * t2
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(t0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    t3 = 0.25 * lam0_0
    X0_0 = t3 + 0.25 * y2
    Y0_0 = 0.25 * t0 + t3
    Z0_0 = t3 + 0.25
    a1_0 = np.sqrt(X0_0)
    b1_0 = np.sqrt(Y0_0)
    c1_0 = np.sqrt(Z0_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    q1_0 = Z0_0 + lam1_0
    below1_0 = c1_0 * q1_0
    term1_0 = 1.0 / below1_0
    t4 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t4
    Y1_0 = 0.25 * Y0_0 + t4
    Z1_0 = 0.25 * Z0_0 + t4
    a2_0 = np.sqrt(X1_0)
    b2_0 = np.sqrt(Y1_0)
    c2_0 = np.sqrt(Z1_0)
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    q2_0 = Z1_0 + lam2_0
    below2_0 = c2_0 * q2_0
    term2_0 = 1.0 / below2_0
    t5 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t5
    Y2_0 = 0.25 * Y1_0 + t5
    Z2_0 = 0.25 * Z1_0 + t5
    a3_0 = np.sqrt(X2_0)
    b3_0 = np.sqrt(Y2_0)
    c3_0 = np.sqrt(Z2_0)
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    q3_0 = Z2_0 + lam3_0
    below3_0 = c3_0 * q3_0
    term3_0 = 1.0 / below3_0
    t6 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t6
    Y3_0 = 0.25 * Y2_0 + t6
    Z3_0 = 0.25 * Z2_0 + t6
    a4_0 = np.sqrt(X3_0)
    b4_0 = np.sqrt(Y3_0)
    c4_0 = np.sqrt(Z3_0)
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    q4_0 = Z3_0 + lam4_0
    below4_0 = c4_0 * q4_0
    term4_0 = 1.0 / below4_0
    t7 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t7
    Y4_0 = 0.25 * Y3_0 + t7
    Z4_0 = 0.25 * Z3_0 + t7
    a5_0 = np.sqrt(X4_0)
    b5_0 = np.sqrt(Y4_0)
    c5_0 = np.sqrt(Z4_0)
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    q5_0 = Z4_0 + lam5_0
    below5_0 = c5_0 * q5_0
    term5_0 = 1.0 / below5_0
    t8 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t8
    Y5_0 = 0.25 * Y4_0 + t8
    Z5_0 = 0.25 * Z4_0 + t8
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    over_0 = 1.0 / mean_0
    t9 = -mean_0
    dx_0 = over_0 * (-X5_0 - t9)
    dy_0 = over_0 * (-Y5_0 - t9)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    xy_0 = dx_0 * dy_0
    zz_0 = dz_0 * dz_0
    E2_0 = xy_0 - 6.0 * zz_0
    t10 = 3.0 * xy_0
    E3_0 = dz_0 * (t10 - 8.0 * zz_0)
    E4_0 = zz_0 * (t10 - 3.0 * zz_0)
    E5_0 = dz_0 * xy_0 * zz_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    sq_0 = np.sqrt(over_0)
    power_0 = over_0 * sq_0
    last_0 = power_0 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    V2 = R_0 * third
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    T3 = T * t1
    S_0 = (
        8.0 * T3 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    return (
        2.5464790894703255 * A * beta * (S_0 / c - V2),
    )


def _H_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 304 structured, 288 common subexpressions, 287 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t1 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t1 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t1 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t1 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t1 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t1 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t1 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t1 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t1 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t1 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t1 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t1 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t1 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t1 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t1 + 1.0)
    t2 = 1.0 / (A * A)
    x2 = t2 * u_cr * u_cr
    y2 = root * root * t2
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(t0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    t3 = 0.25 * lam0_0
    X0_0 = t3 + 0.25 * y2
    Y0_0 = 0.25 * t0 + t3
    Z0_0 = t3 + 0.25
    a1_0 = np.sqrt(X0_0)
    b1_0 = np.sqrt(Y0_0)
    c1_0 = np.sqrt(Z0_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    q1_0 = Z0_0 + lam1_0
    below1_0 = c1_0 * q1_0
    term1_0 = 1.0 / below1_0
    t4 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t4
    Y1_0 = 0.25 * Y0_0 + t4
    Z1_0 = 0.25 * Z0_0 + t4
    a2_0 = np.sqrt(X1_0)
    b2_0 = np.sqrt(Y1_0)
    c2_0 = np.sqrt(Z1_0)
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    q2_0 = Z1_0 + lam2_0
    below2_0 = c2_0 * q2_0
    term2_0 = 1.0 / below2_0
    t5 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t5
    Y2_0 = 0.25 * Y1_0 + t5
    Z2_0 = 0.25 * Z1_0 + t5
    a3_0 = np.sqrt(X2_0)
    b3_0 = np.sqrt(Y2_0)
    c3_0 = np.sqrt(Z2_0)
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    q3_0 = Z2_0 + lam3_0
    below3_0 = c3_0 * q3_0
    term3_0 = 1.0 / below3_0
    t6 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t6
    Y3_0 = 0.25 * Y2_0 + t6
    Z3_0 = 0.25 * Z2_0 + t6
    a4_0 = np.sqrt(X3_0)
    b4_0 = np.sqrt(Y3_0)
    c4_0 = np.sqrt(Z3_0)
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    q4_0 = Z3_0 + lam4_0
    below4_0 = c4_0 * q4_0
    term4_0 = 1.0 / below4_0
    t7 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t7
    Y4_0 = 0.25 * Y3_0 + t7
    Z4_0 = 0.25 * Z3_0 + t7
    a5_0 = np.sqrt(X4_0)
    b5_0 = np.sqrt(Y4_0)
    c5_0 = np.sqrt(Z4_0)
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    q5_0 = Z4_0 + lam5_0
    below5_0 = c5_0 * q5_0
    term5_0 = 1.0 / below5_0
    t8 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t8
    Y5_0 = 0.25 * Y4_0 + t8
    Z5_0 = 0.25 * Z4_0 + t8
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    over_0 = 1.0 / mean_0
    t9 = -mean_0
    dx_0 = over_0 * (-X5_0 - t9)
    dy_0 = over_0 * (-Y5_0 - t9)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    xy_0 = dx_0 * dy_0
    zz_0 = dz_0 * dz_0
    E2_0 = xy_0 - 6.0 * zz_0
    t10 = 3.0 * xy_0
    E3_0 = dz_0 * (t10 - 8.0 * zz_0)
    E4_0 = zz_0 * (t10 - 3.0 * zz_0)
    E5_0 = dz_0 * xy_0 * zz_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    sq_0 = np.sqrt(over_0)
    power_0 = over_0 * sq_0
    last_0 = power_0 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    V2 = R_0 * third
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    T3 = T * t1
    S_0 = (
        8.0 * T3 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    return (
        2.5464790894703255 * A * beta * (S_0 / c - V2),
    )


def H(A, alpha, beta, u_cr):
    """The averaged force H beside the vertical spring.

    Equation (20)-(22). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_H_passed_0, _H_passed_0_steep, _H_passed_1, _H_passed_1_steep_far, _H_passed_1_steep)
    return by_regime(guards, bodies, arguments, 1)[0]


def _H_A_passed_0(A, alpha, beta, u_cr):
    # operations: 71 structured, 65 common subexpressions, 65 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    t5 = e_3 * e_3
    t6 = 1.0 / a_4
    t7 = m * t6
    e_4 = 0.25 * t5 * t7
    e = e_1 + e_2 + e_3 + e_4
    tau = 16.0 * e_4 * e_4 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5
    P = t7 * (e + tau)
    B = t6 * (-m * tau + 1.0)
    C = 2.0 * t6 * tau
    return (
        -alpha - 2.0 * beta * (B * m / k - C * m + P) + 1.0,
    )


def _H_A_passed_0_steep(A, alpha, beta, u_cr):
    # operations: 127 structured, 113 common subexpressions, 113 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    b_4 = np.sqrt(a_3) * np.sqrt(b_3)
    t5 = e_3 * e_3
    e_4 = t3 * t5 / a_4
    a_5 = 0.5 * a_4 + 0.5 * b_4
    b_5 = np.sqrt(a_4) * np.sqrt(b_4)
    t6 = e_4 * e_4
    e_5 = t3 * t6 / a_5
    a_6 = 0.5 * a_5 + 0.5 * b_5
    b_6 = np.sqrt(a_5) * np.sqrt(b_5)
    t7 = e_5 * e_5
    e_6 = t3 * t7 / a_6
    a_7 = 0.5 * a_6 + 0.5 * b_6
    b_7 = np.sqrt(a_6) * np.sqrt(b_6)
    t8 = e_6 * e_6
    e_7 = t3 * t8 / a_7
    a_8 = 0.5 * a_7 + 0.5 * b_7
    t9 = e_7 * e_7
    t10 = 1.0 / a_8
    t11 = m * t10
    e_8 = 0.25 * t11 * t9
    e = e_1 + e_2 + e_3 + e_4 + e_5 + e_6 + e_7 + e_8
    tau = 256.0 * e_8 * e_8 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5 + 16.0 * t6 + 32.0 * t7 + 64.0 * t8 + 128.0 * t9
    P = t11 * (e + tau)
    B = t10 * (-m * tau + 1.0)
    C = 2.0 * t10 * tau
    return (
        -alpha - 2.0 * beta * (B * m / k - C * m + P) + 1.0,
    )


def _H_A_passed_1(A, alpha, beta, u_cr):
    # operations: 421 structured, 419 common subexpressions, 416 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    c = np.sqrt((1.0 - u_cr) * (u_cr + 1.0))
    T = u_cr / (A + root)
    t0 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0)
    t1 = A * A
    U2 = 4.0 * t0 * t1
    v2_1 = 0.99379661859049351 * g_1 * g_1
    square_1 = -U2 * v2_1 + 1.0
    delta_1 = np.sqrt(square_1)
    f_1 = 0.007968192496166605 * g_1 * v2_1 / delta_1
    fall_1 = f_1 * v2_1 / square_1
    v2_2 = 0.96760297675669993 * g_2 * g_2
    square_2 = -U2 * v2_2 + 1.0
    delta_2 = np.sqrt(square_2)
    f_2 = 0.018466468311090958 * g_2 * v2_2 / delta_2
    fall_2 = f_2 * v2_2 / square_2
    v2_3 = 0.92164198121722729 * g_3 * g_3
    square_3 = -U2 * v2_3 + 1.0
    delta_3 = np.sqrt(square_3)
    f_3 = 0.028784707883323369 * g_3 * v2_3 / delta_3
    fall_3 = f_3 * v2_3 / square_3
    v2_4 = 0.85784652785798998 * g_4 * g_4
    square_4 = -U2 * v2_4 + 1.0
    delta_4 = np.sqrt(square_4)
    f_4 = 0.03879919256962705 * g_4 * v2_4 / delta_4
    fall_4 = f_4 * v2_4 / square_4
    v2_5 = 0.77891309933755515 * g_5 * g_5
    square_5 = -U2 * v2_5 + 1.0
    delta_5 = np.sqrt(square_5)
    f_5 = 0.048402672830594053 * g_5 * v2_5 / delta_5
    fall_5 = f_5 * v2_5 / square_5
    v2_6 = 0.68817935411770381 * g_6 * g_6
    square_6 = -U2 * v2_6 + 1.0
    delta_6 = np.sqrt(square_6)
    f_6 = 0.057493156217619065 * g_6 * v2_6 / delta_6
    fall_6 = f_6 * v2_6 / square_6
    v2_7 = 0.58948218524948104 * g_7 * g_7
    square_7 = -U2 * v2_7 + 1.0
    delta_7 = np.sqrt(square_7)
    f_7 = 0.065974229882180491 * g_7 * v2_7 / delta_7
    fall_7 = f_7 * v2_7 / square_7
    v2_8 = 0.4869953130832757 * g_8 * g_8
    square_8 = -U2 * v2_8 + 1.0
    delta_8 = np.sqrt(square_8)
    f_8 = 0.073755974737705204 * g_8 * v2_8 / delta_8
    fall_8 = f_8 * v2_8 / square_8
    v2_9 = 0.38505274377519932 * g_9 * g_9
    square_9 = -U2 * v2_9 + 1.0
    delta_9 = np.sqrt(square_9)
    f_9 = 0.080755895229420213 * g_9 * v2_9 / delta_9
    fall_9 = f_9 * v2_9 / square_9
    v2_10 = 0.28796547636914854 * g_10 * g_10
    square_10 = -U2 * v2_10 + 1.0
    delta_10 = np.sqrt(square_10)
    f_10 = 0.086899787201082976 * g_10 * v2_10 / delta_10
    fall_10 = f_10 * v2_10 / square_10
    v2_11 = 0.19983919110743342 * g_11 * g_11
    square_11 = -U2 * v2_11 + 1.0
    delta_11 = np.sqrt(square_11)
    f_11 = 0.092122522237786122 * g_11 * v2_11 / delta_11
    fall_11 = f_11 * v2_11 / square_11
    v2_12 = 0.12440062341181206 * g_12 * g_12
    square_12 = -U2 * v2_12 + 1.0
    delta_12 = np.sqrt(square_12)
    f_12 = 0.096368737174644253 * g_12 * v2_12 / delta_12
    fall_12 = f_12 * v2_12 / square_12
    v2_13 = 0.064839964168231387 * g_13 * g_13
    square_13 = -U2 * v2_13 + 1.0
    delta_13 = np.sqrt(square_13)
    f_13 = 0.099593420586795267 * g_13 * v2_13 / delta_13
    fall_13 = f_13 * v2_13 / square_13
    v2_14 = 0.023675950313912963 * g_14 * g_14
    square_14 = -U2 * v2_14 + 1.0
    delta_14 = np.sqrt(square_14)
    f_14 = 0.1017623897484055 * g_14 * v2_14 / delta_14
    fall_14 = f_14 * v2_14 / square_14
    v2_15 = 0.0026493505760394136 * g_15 * g_15
    square_15 = -U2 * v2_15 + 1.0
    delta_15 = np.sqrt(square_15)
    f_15 = 0.10285265289355884 * g_15 * v2_15 / delta_15
    fall_15 = f_15 * v2_15 / square_15
    sum_0 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1) + f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0)
        * (g_10 * (0.53662414814201986 * t0 + 0.53662414814201986) + 1.0) / (c + delta_10) + f_11 * g_11 *
        (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 + 0.44703376953808915)
        + 1.0) / (c + delta_11) + f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 *
        (0.35270472553087812 * t0 + 0.35270472553087812) + 1.0) / (c + delta_12) + f_13 * g_13 * (0.7453630738321102
        - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 + 0.25463692616788985) + 1.0) / (c +
        delta_13) + f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 *
        t0 + 0.15386991360858354) + 1.0) / (c + delta_14) + f_15 * g_15 * (0.94852815744468233 -
        0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 + 0.051471842555317698) + 1.0) / (c +
        delta_15) + f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0
        + 0.98366812327974718) + 1.0) / (c + delta_2) + f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 *
        t0) * (g_3 * (0.96002186496830755 * t0 + 0.96002186496830755) + 1.0) / (c + delta_3) + f_4 * g_4 *
        (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 + 0.92620004742927431)
        + 1.0) / (c + delta_4) + f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 *
        (0.88256053579205274 * t0 + 0.88256053579205274) + 1.0) / (c + delta_5) + f_6 * g_6 * (0.17043423761723162 -
        0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 + 0.82956576238276836) + 1.0) / (c + delta_6) +
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7) + f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) *
        (g_8 * (0.69785049479331585 * t0 + 0.69785049479331585) + 1.0) / (c + delta_8) + f_9 * g_9 *
        (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 + 0.62052618298924289) +
        1.0) / (c + delta_9)
    )
    sum_1 = (
        fall_1 + fall_10 + fall_11 + fall_12 + fall_13 + fall_14 + fall_15 + fall_2 + fall_3 + fall_4 + fall_5 +
        fall_6 + fall_7 + fall_8 + fall_9
    )
    T4 = t0 * t0
    T5 = T * T4
    T3 = T * t0
    return (
        -2.5464790894703255 * beta * (-8.0 * T3 * sum_0 * u_cr * u_cr / c + 32.0 * T5 * sum_1 * t1),
    )


def _H_A_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 682 structured, 606 common subexpressions, 605 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    t2 = 0.99379661859049351 * t1
    g_1 = 1.0 / (t2 + 1.0)
    t3 = 0.96760297675669993 * t1
    g_2 = 1.0 / (t3 + 1.0)
    t4 = 0.92164198121722729 * t1
    g_3 = 1.0 / (t4 + 1.0)
    t5 = 0.85784652785798998 * t1
    g_4 = 1.0 / (t5 + 1.0)
    t6 = 0.77891309933755515 * t1
    g_5 = 1.0 / (t6 + 1.0)
    t7 = 0.68817935411770381 * t1
    g_6 = 1.0 / (t7 + 1.0)
    t8 = 0.58948218524948104 * t1
    g_7 = 1.0 / (t8 + 1.0)
    t9 = 0.4869953130832757 * t1
    g_8 = 1.0 / (t9 + 1.0)
    t10 = 0.38505274377519932 * t1
    g_9 = 1.0 / (t10 + 1.0)
    t11 = 0.28796547636914854 * t1
    g_10 = 1.0 / (t11 + 1.0)
    t12 = 0.19983919110743342 * t1
    g_11 = 1.0 / (t12 + 1.0)
    t13 = 0.12440062341181206 * t1
    g_12 = 1.0 / (t13 + 1.0)
    t14 = 0.064839964168231387 * t1
    g_13 = 1.0 / (t14 + 1.0)
    t15 = 0.023675950313912963 * t1
    g_14 = 1.0 / (t15 + 1.0)
    t16 = 0.0026493505760394136 * t1
    g_15 = 1.0 / (t16 + 1.0)
    t17 = 1.0 / (A * A)
    x2 = t17 * u_cr * u_cr
    y2 = root * root * t17
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    b0_0 = np.sqrt(t0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    t18 = 0.25 * lam0_0
    X0_0 = t18 + 0.25 * y2
    t19 = 0.25 * lam0_1
    X0_1 = t19 + 0.25
    Y0_0 = 0.25 * t0 + t18
    Z0_0 = t18 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = b1_half_0 * t19
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t19
    t20 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t20
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t20 + c1_0 * (a11_0 + b11_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t19
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    t21 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t21
    t22 = 0.25 * lam1_1
    X1_1 = 0.25 * X0_1 + t22
    Y1_0 = 0.25 * Y0_0 + t21
    Y1_1 = 0.25 * t19 + t22
    Z1_0 = 0.25 * Z0_0 + t21
    Z1_1 = 0.25 * t19 + t22
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    t23 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t23
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t23 + c2_0 * (a21_0 + b21_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    t24 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t24
    t25 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t25
    Y2_0 = 0.25 * Y1_0 + t24
    Y2_1 = 0.25 * Y1_1 + t25
    Z2_0 = 0.25 * Z1_0 + t24
    Z2_1 = 0.25 * Z1_1 + t25
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    t26 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t26
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t26 + c3_0 * (a31_0 + b31_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    t27 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t27
    t28 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t28
    Y3_0 = 0.25 * Y2_0 + t27
    Y3_1 = 0.25 * Y2_1 + t28
    Z3_0 = 0.25 * Z2_0 + t27
    Z3_1 = 0.25 * Z2_1 + t28
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    t29 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t29
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t29 + c4_0 * (a41_0 + b41_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    t30 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t30
    t31 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t31
    Y4_0 = 0.25 * Y3_0 + t30
    Y4_1 = 0.25 * Y3_1 + t31
    Z4_0 = 0.25 * Z3_0 + t30
    Z4_1 = 0.25 * Z3_1 + t31
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    t32 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t32
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t32 + c5_0 * (a51_0 + b51_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    t33 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t33
    t34 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t34
    Y5_0 = 0.25 * Y4_0 + t33
    Y5_1 = 0.25 * Y4_1 + t34
    Z5_0 = 0.25 * Z4_0 + t33
    Z5_1 = 0.25 * Z4_1 + t34
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    t35 = -mean_0
    t36 = -X5_0 - t35
    dx_0 = over_0 * t36
    t37 = -mean_1
    dx_1 = over1_0 * t36 + over_0 * (-X5_1 - t37)
    t38 = -Y5_0 - t35
    dy_0 = over_0 * t38
    dy_1 = over1_0 * t38 + over_0 * (-Y5_1 - t37)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    t39 = 3.0 * xy_0
    t40 = t39 - 8.0 * zz_0
    E3_0 = dz_0 * t40
    t41 = 3.0 * xy_1
    E3_1 = dz_0 * (t41 - 8.0 * zz_1) + dz_1 * t40
    t42 = t39 - 3.0 * zz_0
    E4_0 = t42 * zz_0
    E4_1 = t42 * zz_1 + zz_0 * (t41 - 3.0 * zz_1)
    t43 = xy_0 * zz_0
    E5_0 = dz_0 * t43
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * t43
    t44 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t44 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 - E3_1 *
        t44 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    last_0 = power_0 * series_0
    last_1 = power_0 * series_1 + power_1 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    t45 = 1.0 - t2
    tangent_1 = 3.975186474361974 * t1 / (t45 * t45)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t46 = 1.0 - t3
    tangent_2 = 3.8704119070267997 * t1 / (t46 * t46)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t47 = 1.0 - t4
    tangent_3 = 3.6865679248689092 * t1 / (t47 * t47)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t48 = 1.0 - t5
    tangent_4 = 3.4313861114319599 * t1 / (t48 * t48)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t49 = 1.0 - t6
    tangent_5 = 3.1156523973502206 * t1 / (t49 * t49)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t50 = 1.0 - t7
    tangent_6 = 2.7527174164708152 * t1 / (t50 * t50)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t51 = 1.0 - t8
    tangent_7 = 2.3579287409979242 * t1 / (t51 * t51)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t52 = 1.0 - t9
    tangent_8 = 1.9479812523331028 * t1 / (t52 * t52)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t53 = 1.0 - t10
    tangent_9 = 1.5402109751007973 * t1 / (t53 * t53)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t54 = 1.0 - t11
    tangent_10 = 1.1518619054765942 * t1 / (t54 * t54)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t55 = 1.0 - t12
    tangent_11 = 0.79935676442973369 * t1 / (t55 * t55)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t56 = 1.0 - t13
    tangent_12 = 0.49760249364724823 * t1 / (t56 * t56)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t57 = 1.0 - t14
    tangent_13 = 0.25935985667292555 * t1 / (t57 * t57)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t58 = 1.0 - t15
    tangent_14 = 0.094703801255651851 * t1 / (t58 * t58)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t59 = 1.0 - t16
    tangent_15 = 0.010597402304157654 * t1 / (t59 * t59)
    T3 = T * t1
    t60 = 8.0 * T3
    S_0 = (
        t60 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    S_1 = (
        t60 * (tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13
        * term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 +
        tangent_4 * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 +
        tangent_9 * term_9)
    )
    t61 = 1.0 / c
    return (
        2.5464790894703255 * beta * (-2.0 * S_0 * t61 - S_1 * t61 + 2.0 * V2 + V4),
    )


def _H_A_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 557 structured, 512 common subexpressions, 511 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t1 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t1 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t1 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t1 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t1 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t1 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t1 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t1 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t1 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t1 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t1 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t1 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t1 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t1 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t1 + 1.0)
    t2 = A * A
    t3 = 1.0 / t2
    x2 = t3 * u_cr * u_cr
    y2 = root * root * t3
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(t0)
    b0_half_0 = 0.5 / b0_0
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_0 * b0_half_0 + b0_half_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    t4 = 0.25 * lam0_0
    X0_0 = t4 + 0.25 * y2
    t5 = 0.25 * lam0_1
    Y0_0 = 0.25 * t0 + t4
    Y0_1 = t5 + 0.25
    Z0_0 = t4 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = a1_half_0 * t5
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t5
    t6 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t6
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t6 + c1_0 * (a11_0 + b11_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t5
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    t7 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t7
    t8 = 0.25 * lam1_1
    X1_1 = 0.25 * t5 + t8
    Y1_0 = 0.25 * Y0_0 + t7
    Y1_1 = 0.25 * Y0_1 + t8
    Z1_0 = 0.25 * Z0_0 + t7
    Z1_1 = 0.25 * t5 + t8
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    t9 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t9
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t9 + c2_0 * (a21_0 + b21_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    t10 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t10
    t11 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t11
    Y2_0 = 0.25 * Y1_0 + t10
    Y2_1 = 0.25 * Y1_1 + t11
    Z2_0 = 0.25 * Z1_0 + t10
    Z2_1 = 0.25 * Z1_1 + t11
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    t12 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t12
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t12 + c3_0 * (a31_0 + b31_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    t13 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t13
    t14 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t14
    Y3_0 = 0.25 * Y2_0 + t13
    Y3_1 = 0.25 * Y2_1 + t14
    Z3_0 = 0.25 * Z2_0 + t13
    Z3_1 = 0.25 * Z2_1 + t14
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    t15 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t15
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t15 + c4_0 * (a41_0 + b41_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    t16 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t16
    t17 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t17
    Y4_0 = 0.25 * Y3_0 + t16
    Y4_1 = 0.25 * Y3_1 + t17
    Z4_0 = 0.25 * Z3_0 + t16
    Z4_1 = 0.25 * Z3_1 + t17
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    t18 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t18
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t18 + c5_0 * (a51_0 + b51_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    t19 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t19
    t20 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t20
    Y5_0 = 0.25 * Y4_0 + t19
    Y5_1 = 0.25 * Y4_1 + t20
    Z5_0 = 0.25 * Z4_0 + t19
    Z5_1 = 0.25 * Z4_1 + t20
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    t21 = -mean_0
    t22 = -X5_0 - t21
    dx_0 = over_0 * t22
    t23 = -mean_1
    dx_1 = over1_0 * t22 + over_0 * (-X5_1 - t23)
    t24 = -Y5_0 - t21
    dy_0 = over_0 * t24
    dy_1 = over1_0 * t24 + over_0 * (-Y5_1 - t23)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    t25 = 3.0 * xy_0
    t26 = t25 - 8.0 * zz_0
    E3_0 = dz_0 * t26
    t27 = 3.0 * xy_1
    E3_1 = dz_0 * (t27 - 8.0 * zz_1) + dz_1 * t26
    t28 = t25 - 3.0 * zz_0
    E4_0 = t28 * zz_0
    E4_1 = t28 * zz_1 + zz_0 * (t27 - 3.0 * zz_1)
    t29 = xy_0 * zz_0
    E5_0 = dz_0 * t29
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * t29
    t30 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t30 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 - E3_1 *
        t30 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    last_0 = power_0 * series_0
    last_1 = power_0 * series_1 + power_1 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    T3 = T * t1
    S_0 = (
        8.0 * T3 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    return (
        -2.5464790894703255 * beta * (-S_0 / c + V2 + V4 * t2),
    )


def H_A(A, alpha, beta, u_cr):
    """d/dA of the averaged force H beside the vertical spring.

    Equation (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_H_A_passed_0, _H_A_passed_0_steep, _H_A_passed_1, _H_A_passed_1_steep_far, _H_A_passed_1_steep)
    return by_regime(guards, bodies, arguments, 1)[0]


def _H_AA_passed_0(A, alpha, beta, u_cr):
    # operations: 64 structured, 58 common subexpressions, 58 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    t5 = e_3 * e_3
    t6 = 1.0 / a_4
    e_4 = t3 * t5 * t6
    tau = 16.0 * e_4 * e_4 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5
    B = t6 * (-m * tau + 1.0)
    C = 2.0 * t6 * tau
    return (
        -2.0 * A * beta * (2.0 * B / (k * k) + C / k),
    )


def _H_AA_passed_0_steep(A, alpha, beta, u_cr):
    # operations: 116 structured, 102 common subexpressions, 102 power chains
    m = A * A
    t0 = A + 1.0
    t1 = 1.0 - A
    k_c = np.sqrt(t0) * np.sqrt(t1)
    k = t0 * t1
    a_1 = 0.5 * k_c + 0.5
    b_1 = np.sqrt(k_c)
    e_1 = 0.25 / a_1
    a_2 = 0.5 * a_1 + 0.5 * b_1
    b_2 = np.sqrt(a_1) * np.sqrt(b_1)
    t2 = e_1 * e_1
    t3 = 0.25 * m
    e_2 = t2 * t3 / a_2
    a_3 = 0.5 * a_2 + 0.5 * b_2
    b_3 = np.sqrt(a_2) * np.sqrt(b_2)
    t4 = e_2 * e_2
    e_3 = t3 * t4 / a_3
    a_4 = 0.5 * a_3 + 0.5 * b_3
    b_4 = np.sqrt(a_3) * np.sqrt(b_3)
    t5 = e_3 * e_3
    e_4 = t3 * t5 / a_4
    a_5 = 0.5 * a_4 + 0.5 * b_4
    b_5 = np.sqrt(a_4) * np.sqrt(b_4)
    t6 = e_4 * e_4
    e_5 = t3 * t6 / a_5
    a_6 = 0.5 * a_5 + 0.5 * b_5
    b_6 = np.sqrt(a_5) * np.sqrt(b_5)
    t7 = e_5 * e_5
    e_6 = t3 * t7 / a_6
    a_7 = 0.5 * a_6 + 0.5 * b_6
    b_7 = np.sqrt(a_6) * np.sqrt(b_6)
    t8 = e_6 * e_6
    e_7 = t3 * t8 / a_7
    a_8 = 0.5 * a_7 + 0.5 * b_7
    t9 = e_7 * e_7
    t10 = 1.0 / a_8
    e_8 = t10 * t3 * t9
    tau = 256.0 * e_8 * e_8 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5 + 16.0 * t6 + 32.0 * t7 + 64.0 * t8 + 128.0 * t9
    B = t10 * (-m * tau + 1.0)
    C = 2.0 * t10 * tau
    return (
        -2.0 * A * beta * (2.0 * B / (k * k) + C / k),
    )


def _H_AA_passed_1(A, alpha, beta, u_cr):
    # operations: 260 structured, 274 common subexpressions, 270 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    c = np.sqrt((1.0 - u_cr) * (u_cr + 1.0))
    T = u_cr / (A + root)
    t0 = T * T
    g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0)
    g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0)
    g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0)
    g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0)
    g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0)
    g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0)
    g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0)
    g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0)
    g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0)
    g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0)
    g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0)
    g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0)
    g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0)
    g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0)
    g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0)
    A2 = A * A
    U2 = 4.0 * A2 * t0
    v2_1 = 0.99379661859049351 * g_1 * g_1
    square_1 = -U2 * v2_1 + 1.0
    delta_1 = np.sqrt(square_1)
    f_1 = 0.007968192496166605 * g_1 * v2_1 / delta_1
    t1 = 1.0 / square_1
    fall_1 = f_1 * t1 * v2_1
    v2_2 = 0.96760297675669993 * g_2 * g_2
    square_2 = -U2 * v2_2 + 1.0
    delta_2 = np.sqrt(square_2)
    f_2 = 0.018466468311090958 * g_2 * v2_2 / delta_2
    t2 = 1.0 / square_2
    fall_2 = f_2 * t2 * v2_2
    v2_3 = 0.92164198121722729 * g_3 * g_3
    square_3 = -U2 * v2_3 + 1.0
    delta_3 = np.sqrt(square_3)
    f_3 = 0.028784707883323369 * g_3 * v2_3 / delta_3
    t3 = 1.0 / square_3
    fall_3 = f_3 * t3 * v2_3
    v2_4 = 0.85784652785798998 * g_4 * g_4
    square_4 = -U2 * v2_4 + 1.0
    delta_4 = np.sqrt(square_4)
    f_4 = 0.03879919256962705 * g_4 * v2_4 / delta_4
    t4 = 1.0 / square_4
    fall_4 = f_4 * t4 * v2_4
    v2_5 = 0.77891309933755515 * g_5 * g_5
    square_5 = -U2 * v2_5 + 1.0
    delta_5 = np.sqrt(square_5)
    f_5 = 0.048402672830594053 * g_5 * v2_5 / delta_5
    t5 = 1.0 / square_5
    fall_5 = f_5 * t5 * v2_5
    v2_6 = 0.68817935411770381 * g_6 * g_6
    square_6 = -U2 * v2_6 + 1.0
    delta_6 = np.sqrt(square_6)
    f_6 = 0.057493156217619065 * g_6 * v2_6 / delta_6
    t6 = 1.0 / square_6
    fall_6 = f_6 * t6 * v2_6
    v2_7 = 0.58948218524948104 * g_7 * g_7
    square_7 = -U2 * v2_7 + 1.0
    delta_7 = np.sqrt(square_7)
    f_7 = 0.065974229882180491 * g_7 * v2_7 / delta_7
    t7 = 1.0 / square_7
    fall_7 = f_7 * t7 * v2_7
    v2_8 = 0.4869953130832757 * g_8 * g_8
    square_8 = -U2 * v2_8 + 1.0
    delta_8 = np.sqrt(square_8)
    f_8 = 0.073755974737705204 * g_8 * v2_8 / delta_8
    t8 = 1.0 / square_8
    fall_8 = f_8 * t8 * v2_8
    v2_9 = 0.38505274377519932 * g_9 * g_9
    square_9 = -U2 * v2_9 + 1.0
    delta_9 = np.sqrt(square_9)
    f_9 = 0.080755895229420213 * g_9 * v2_9 / delta_9
    t9 = 1.0 / square_9
    fall_9 = f_9 * t9 * v2_9
    v2_10 = 0.28796547636914854 * g_10 * g_10
    square_10 = -U2 * v2_10 + 1.0
    delta_10 = np.sqrt(square_10)
    f_10 = 0.086899787201082976 * g_10 * v2_10 / delta_10
    t10 = 1.0 / square_10
    fall_10 = f_10 * t10 * v2_10
    v2_11 = 0.19983919110743342 * g_11 * g_11
    square_11 = -U2 * v2_11 + 1.0
    delta_11 = np.sqrt(square_11)
    f_11 = 0.092122522237786122 * g_11 * v2_11 / delta_11
    t11 = 1.0 / square_11
    fall_11 = f_11 * t11 * v2_11
    v2_12 = 0.12440062341181206 * g_12 * g_12
    square_12 = -U2 * v2_12 + 1.0
    delta_12 = np.sqrt(square_12)
    f_12 = 0.096368737174644253 * g_12 * v2_12 / delta_12
    t12 = 1.0 / square_12
    fall_12 = f_12 * t12 * v2_12
    v2_13 = 0.064839964168231387 * g_13 * g_13
    square_13 = -U2 * v2_13 + 1.0
    delta_13 = np.sqrt(square_13)
    f_13 = 0.099593420586795267 * g_13 * v2_13 / delta_13
    t13 = 1.0 / square_13
    fall_13 = f_13 * t13 * v2_13
    v2_14 = 0.023675950313912963 * g_14 * g_14
    square_14 = -U2 * v2_14 + 1.0
    delta_14 = np.sqrt(square_14)
    f_14 = 0.1017623897484055 * g_14 * v2_14 / delta_14
    t14 = 1.0 / square_14
    fall_14 = f_14 * t14 * v2_14
    v2_15 = 0.0026493505760394136 * g_15 * g_15
    square_15 = -U2 * v2_15 + 1.0
    delta_15 = np.sqrt(square_15)
    f_15 = 0.10285265289355884 * g_15 * v2_15 / delta_15
    t15 = 1.0 / square_15
    fall_15 = f_15 * t15 * v2_15
    sum_2 = (
        fall_1 * t1 + fall_10 * t10 + fall_11 * t11 + fall_12 * t12 + fall_13 * t13 + fall_14 * t14 + fall_15 * t15
        + fall_2 * t2 + fall_3 * t3 + fall_4 * t4 + fall_5 * t5 + fall_6 * t6 + fall_7 * t7 + fall_8 * t8 + fall_9 *
        t9
    )
    T4 = t0 * t0
    T5 = T * T4
    u_cr2 = u_cr * u_cr
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    A3 = A * A2
    c2 = c * c
    c3 = c * c2
    return (
        -2.5464790894703255 * beta * (96.0 * A * T5 * sum_2 - u_cr5 / (A3 * c3 * root)),
    )


def _H_AA_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 1092 structured, 968 common subexpressions, 967 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    T = u_cr / (A + root)
    t1 = T * T
    t2 = 0.99379661859049351 * t1
    g_1 = 1.0 / (t2 + 1.0)
    t3 = 0.96760297675669993 * t1
    g_2 = 1.0 / (t3 + 1.0)
    t4 = 0.92164198121722729 * t1
    g_3 = 1.0 / (t4 + 1.0)
    t5 = 0.85784652785798998 * t1
    g_4 = 1.0 / (t5 + 1.0)
    t6 = 0.77891309933755515 * t1
    g_5 = 1.0 / (t6 + 1.0)
    t7 = 0.68817935411770381 * t1
    g_6 = 1.0 / (t7 + 1.0)
    t8 = 0.58948218524948104 * t1
    g_7 = 1.0 / (t8 + 1.0)
    t9 = 0.4869953130832757 * t1
    g_8 = 1.0 / (t9 + 1.0)
    t10 = 0.38505274377519932 * t1
    g_9 = 1.0 / (t10 + 1.0)
    t11 = 0.28796547636914854 * t1
    g_10 = 1.0 / (t11 + 1.0)
    t12 = 0.19983919110743342 * t1
    g_11 = 1.0 / (t12 + 1.0)
    t13 = 0.12440062341181206 * t1
    g_12 = 1.0 / (t13 + 1.0)
    t14 = 0.064839964168231387 * t1
    g_13 = 1.0 / (t14 + 1.0)
    t15 = 0.023675950313912963 * t1
    g_14 = 1.0 / (t15 + 1.0)
    t16 = 0.0026493505760394136 * t1
    g_15 = 1.0 / (t16 + 1.0)
    t17 = 1.0 / (A * A)
    x2 = t17 * u_cr * u_cr
    y2 = root * root * t17
    t18 = 1.0 / A
    third = 0.33333333333333331 * t18 * u_cr * x2
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    a0_half_0_2 = a0_half_0 * a0_half_0
    a0_half_0_3 = a0_half_0 * a0_half_0_2
    a02_0 = -a0_half_0_3
    b0_0 = np.sqrt(t0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    lam0_2 = a02_0 * b0_0 + a02_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    t19 = 0.25 * lam0_0
    X0_0 = t19 + 0.25 * y2
    t20 = 0.25 * lam0_1
    X0_1 = t20 + 0.25
    t21 = 0.25 * lam0_2
    Y0_0 = 0.25 * t0 + t19
    Z0_0 = t19 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (-a11_0 * a11_0 + t21)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = b1_half_0 * t20
    b12_0 = b1_half_0 * (-b11_0 * b11_0 + t21)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t20
    c12_0 = c1_half_0 * (-c11_0 * c11_0 + t21)
    t22 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t22
    t23 = a11_0 + b11_0
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t22 + c1_0 * t23
    lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * t23 + c12_0 * t22 + c1_0 * (a12_0 + b12_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t20
    q1_2 = lam1_2 + t21
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    t24 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t24
    t25 = 0.25 * lam1_1
    X1_1 = 0.25 * X0_1 + t25
    t26 = 0.25 * lam1_2
    X1_2 = 0.25 * t21 + t26
    Y1_0 = 0.25 * Y0_0 + t24
    Y1_1 = 0.25 * t20 + t25
    Y1_2 = 0.25 * t21 + t26
    Z1_0 = 0.25 * Z0_0 + t24
    Z1_1 = 0.25 * t20 + t25
    Z1_2 = 0.25 * t21 + t26
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0)
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0)
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0)
    t27 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t27
    t28 = a21_0 + b21_0
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t27 + c2_0 * t28
    lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * t28 + c22_0 * t27 + c2_0 * (a22_0 + b22_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    t29 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t29
    t30 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t30
    t31 = 0.25 * lam2_2
    X2_2 = 0.25 * X1_2 + t31
    Y2_0 = 0.25 * Y1_0 + t29
    Y2_1 = 0.25 * Y1_1 + t30
    Y2_2 = 0.25 * Y1_2 + t31
    Z2_0 = 0.25 * Z1_0 + t29
    Z2_1 = 0.25 * Z1_1 + t30
    Z2_2 = 0.25 * Z1_2 + t31
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0)
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0)
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0)
    t32 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t32
    t33 = a31_0 + b31_0
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t32 + c3_0 * t33
    lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * t33 + c32_0 * t32 + c3_0 * (a32_0 + b32_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    t34 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t34
    t35 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t35
    t36 = 0.25 * lam3_2
    X3_2 = 0.25 * X2_2 + t36
    Y3_0 = 0.25 * Y2_0 + t34
    Y3_1 = 0.25 * Y2_1 + t35
    Y3_2 = 0.25 * Y2_2 + t36
    Z3_0 = 0.25 * Z2_0 + t34
    Z3_1 = 0.25 * Z2_1 + t35
    Z3_2 = 0.25 * Z2_2 + t36
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0)
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0)
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0)
    t37 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t37
    t38 = a41_0 + b41_0
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t37 + c4_0 * t38
    lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * t38 + c42_0 * t37 + c4_0 * (a42_0 + b42_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    t39 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t39
    t40 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t40
    t41 = 0.25 * lam4_2
    X4_2 = 0.25 * X3_2 + t41
    Y4_0 = 0.25 * Y3_0 + t39
    Y4_1 = 0.25 * Y3_1 + t40
    Y4_2 = 0.25 * Y3_2 + t41
    Z4_0 = 0.25 * Z3_0 + t39
    Z4_1 = 0.25 * Z3_1 + t40
    Z4_2 = 0.25 * Z3_2 + t41
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0)
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0)
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0)
    t42 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t42
    t43 = a51_0 + b51_0
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t42 + c5_0 * t43
    lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * t43 + c52_0 * t42 + c5_0 * (a52_0 + b52_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    t44 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t44
    t45 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t45
    t46 = 0.25 * lam5_2
    X5_2 = 0.25 * X4_2 + t46
    Y5_0 = 0.25 * Y4_0 + t44
    Y5_1 = 0.25 * Y4_1 + t45
    Y5_2 = 0.25 * Y4_2 + t46
    Z5_0 = 0.25 * Z4_0 + t44
    Z5_1 = 0.25 * Z4_1 + t45
    Z5_2 = 0.25 * Z4_2 + t46
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    t47 = -mean_0
    t48 = -X5_0 - t47
    dx_0 = over_0 * t48
    t49 = -mean_1
    t50 = -X5_1 - t49
    dx_1 = over1_0 * t48 + over_0 * t50
    t51 = -mean_2
    dx_2 = over1_0 * t50 + over2_0 * t48 + over_0 * (-X5_2 - t51)
    t52 = -Y5_0 - t47
    dy_0 = over_0 * t52
    t53 = -Y5_1 - t49
    dy_1 = over1_0 * t52 + over_0 * t53
    dy_2 = over1_0 * t53 + over2_0 * t52 + over_0 * (-Y5_2 - t51)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    zz_0 = dz_0 * dz_0
    t54 = 2.0 * dz_0
    zz_1 = dz_1 * t54
    zz_2 = dz_1 * dz_1 + dz_2 * t54
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    t55 = 3.0 * xy_0
    t56 = t55 - 8.0 * zz_0
    E3_0 = dz_0 * t56
    t57 = 3.0 * xy_1
    t58 = t57 - 8.0 * zz_1
    E3_1 = dz_0 * t58 + dz_1 * t56
    t59 = 3.0 * xy_2
    E3_2 = dz_0 * (t59 - 8.0 * zz_2) + dz_1 * t58 + dz_2 * t56
    t60 = t55 - 3.0 * zz_0
    E4_0 = t60 * zz_0
    t61 = t57 - 3.0 * zz_1
    E4_1 = t60 * zz_1 + t61 * zz_0
    E4_2 = t60 * zz_2 + t61 * zz_1 + zz_0 * (t59 - 3.0 * zz_2)
    t62 = xy_0 * zz_0
    E5_0 = dz_0 * t62
    t63 = xy_0 * zz_1 + xy_1 * zz_0
    E5_1 = dz_0 * t63 + dz_1 * t62
    E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * t63 + dz_2 * t62
    t64 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t64 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    t65 = 0.17307692307692307 * E2_1
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.21428571428571427 * E2_1 - E3_0 * t65 - E3_1 * t64 +
        0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 + 0.10227272727272728 * E2_1 * E2_1 - 0.17307692307692307 * E2_2 * E3_0 -
        0.21428571428571427 * E2_2 - E3_1 * t65 - E3_2 * t64 + 0.16666666666666666 * E3_2 - 0.13636363636363635 *
        E4_2 + 0.11538461538461539 * E5_2
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0)
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0
    last_0 = power_0 * series_0
    last_1 = power_0 * series_1 + power_1 * series_0
    last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0
    R_0 = (
        0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 * term3_0 +
        0.01171875 * term4_0 + 0.0029296875 * term5_0
    )
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    R_2 = (
        0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 * term32_0 +
        0.01171875 * term42_0 + 0.0029296875 * term52_0
    )
    V2 = R_0 * third
    V4 = -2.0 * R_1 * third * x2
    V6 = 2.6666666666666665 * R_2 * third * x2 * x2
    g_1_2 = g_1 * g_1
    g_1_3 = g_1 * g_1_2
    term_1 = 0.0079187627589685176 * g_1_3
    t66 = 1.0 - t2
    tangent_1 = 3.975186474361974 * t1 / (t66 * t66)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t67 = 1.0 - t3
    tangent_2 = 3.8704119070267997 * t1 / (t67 * t67)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t68 = 1.0 - t4
    tangent_3 = 3.6865679248689092 * t1 / (t68 * t68)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t69 = 1.0 - t5
    tangent_4 = 3.4313861114319599 * t1 / (t69 * t69)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t70 = 1.0 - t6
    tangent_5 = 3.1156523973502206 * t1 / (t70 * t70)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t71 = 1.0 - t7
    tangent_6 = 2.7527174164708152 * t1 / (t71 * t71)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t72 = 1.0 - t8
    tangent_7 = 2.3579287409979242 * t1 / (t72 * t72)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t73 = 1.0 - t9
    tangent_8 = 1.9479812523331028 * t1 / (t73 * t73)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t74 = 1.0 - t10
    tangent_9 = 1.5402109751007973 * t1 / (t74 * t74)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t75 = 1.0 - t11
    tangent_10 = 1.1518619054765942 * t1 / (t75 * t75)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t76 = 1.0 - t12
    tangent_11 = 0.79935676442973369 * t1 / (t76 * t76)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t77 = 1.0 - t13
    tangent_12 = 0.49760249364724823 * t1 / (t77 * t77)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t78 = 1.0 - t14
    tangent_13 = 0.25935985667292555 * t1 / (t78 * t78)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t79 = 1.0 - t15
    tangent_14 = 0.094703801255651851 * t1 / (t79 * t79)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t80 = 1.0 - t16
    tangent_15 = 0.010597402304157654 * t1 / (t80 * t80)
    T3 = T * t1
    t81 = 8.0 * T3
    S_0 = (
        t81 * (term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 +
        term_5 + term_6 + term_7 + term_8 + term_9)
    )
    S_1 = (
        t81 * (tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13
        * term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 +
        tangent_4 * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 +
        tangent_9 * term_9)
    )
    S_2 = (
        t81 * (tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 * tangent_11 *
        term_11 + tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 * tangent_14 *
        term_14 + tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 * tangent_3 *
        term_3 + tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6 * term_6 +
        tangent_7 * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9)
    )
    t82 = 1.0 / c
    return (
        2.5464790894703255 * beta * t18 * (6.0 * S_0 * t82 + 7.0 * S_1 * t82 + 3.0 * S_2 * t82 - 6.0 * V2 - 7.0 * V4
        - 3.0 * V6),
    )


def _H_AA_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 797 structured, 706 common subexpressions, 703 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    t0 = (1.0 - u_cr) * (u_cr + 1.0)
    c = np.sqrt(t0)
    A2 = A * A
    t1 = 1.0 / A2
    u_cr2 = u_cr * u_cr
    x2 = t1 * u_cr2
    y2 = root * root * t1
    third = 0.33333333333333331 * u_cr * x2 / A
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(t0)
    b0_half_0 = 0.5 / b0_0
    b0_half_0_2 = b0_half_0 * b0_half_0
    b0_half_0_3 = b0_half_0 * b0_half_0_2
    b02_0 = -b0_half_0_3
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_0 * b0_half_0 + b0_half_0
    lam0_2 = a0_0 * b02_0 + b02_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    t2 = 0.25 * lam0_0
    X0_0 = t2 + 0.25 * y2
    t3 = 0.25 * lam0_1
    t4 = 0.25 * lam0_2
    Y0_0 = 0.25 * t0 + t2
    Y0_1 = t3 + 0.25
    Z0_0 = t2 + 0.25
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = a1_half_0 * t3
    a12_0 = a1_half_0 * (-a11_0 * a11_0 + t4)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (-b11_0 * b11_0 + t4)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = c1_half_0 * t3
    c12_0 = c1_half_0 * (-c11_0 * c11_0 + t4)
    t5 = a1_0 + b1_0
    lam1_0 = a1_0 * b1_0 + c1_0 * t5
    t6 = a11_0 + b11_0
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * t5 + c1_0 * t6
    lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * t6 + c12_0 * t5 + c1_0 * (a12_0 + b12_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = lam1_1 + t3
    q1_2 = lam1_2 + t4
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    t7 = 0.25 * lam1_0
    X1_0 = 0.25 * X0_0 + t7
    t8 = 0.25 * lam1_1
    X1_1 = 0.25 * t3 + t8
    t9 = 0.25 * lam1_2
    X1_2 = 0.25 * t4 + t9
    Y1_0 = 0.25 * Y0_0 + t7
    Y1_1 = 0.25 * Y0_1 + t8
    Y1_2 = 0.25 * t4 + t9
    Z1_0 = 0.25 * Z0_0 + t7
    Z1_1 = 0.25 * t3 + t8
    Z1_2 = 0.25 * t4 + t9
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0)
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0)
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0)
    t10 = a2_0 + b2_0
    lam2_0 = a2_0 * b2_0 + c2_0 * t10
    t11 = a21_0 + b21_0
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * t10 + c2_0 * t11
    lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * t11 + c22_0 * t10 + c2_0 * (a22_0 + b22_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    t12 = 0.25 * lam2_0
    X2_0 = 0.25 * X1_0 + t12
    t13 = 0.25 * lam2_1
    X2_1 = 0.25 * X1_1 + t13
    t14 = 0.25 * lam2_2
    X2_2 = 0.25 * X1_2 + t14
    Y2_0 = 0.25 * Y1_0 + t12
    Y2_1 = 0.25 * Y1_1 + t13
    Y2_2 = 0.25 * Y1_2 + t14
    Z2_0 = 0.25 * Z1_0 + t12
    Z2_1 = 0.25 * Z1_1 + t13
    Z2_2 = 0.25 * Z1_2 + t14
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0)
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0)
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0)
    t15 = a3_0 + b3_0
    lam3_0 = a3_0 * b3_0 + c3_0 * t15
    t16 = a31_0 + b31_0
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * t15 + c3_0 * t16
    lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * t16 + c32_0 * t15 + c3_0 * (a32_0 + b32_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    t17 = 0.25 * lam3_0
    X3_0 = 0.25 * X2_0 + t17
    t18 = 0.25 * lam3_1
    X3_1 = 0.25 * X2_1 + t18
    t19 = 0.25 * lam3_2
    X3_2 = 0.25 * X2_2 + t19
    Y3_0 = 0.25 * Y2_0 + t17
    Y3_1 = 0.25 * Y2_1 + t18
    Y3_2 = 0.25 * Y2_2 + t19
    Z3_0 = 0.25 * Z2_0 + t17
    Z3_1 = 0.25 * Z2_1 + t18
    Z3_2 = 0.25 * Z2_2 + t19
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0)
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0)
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0)
    t20 = a4_0 + b4_0
    lam4_0 = a4_0 * b4_0 + c4_0 * t20
    t21 = a41_0 + b41_0
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * t20 + c4_0 * t21
    lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * t21 + c42_0 * t20 + c4_0 * (a42_0 + b42_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    t22 = 0.25 * lam4_0
    X4_0 = 0.25 * X3_0 + t22
    t23 = 0.25 * lam4_1
    X4_1 = 0.25 * X3_1 + t23
    t24 = 0.25 * lam4_2
    X4_2 = 0.25 * X3_2 + t24
    Y4_0 = 0.25 * Y3_0 + t22
    Y4_1 = 0.25 * Y3_1 + t23
    Y4_2 = 0.25 * Y3_2 + t24
    Z4_0 = 0.25 * Z3_0 + t22
    Z4_1 = 0.25 * Z3_1 + t23
    Z4_2 = 0.25 * Z3_2 + t24
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0)
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0)
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0)
    t25 = a5_0 + b5_0
    lam5_0 = a5_0 * b5_0 + c5_0 * t25
    t26 = a51_0 + b51_0
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * t25 + c5_0 * t26
    lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * t26 + c52_0 * t25 + c5_0 * (a52_0 + b52_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    t27 = 0.25 * lam5_0
    X5_0 = 0.25 * X4_0 + t27
    t28 = 0.25 * lam5_1
    X5_1 = 0.25 * X4_1 + t28
    t29 = 0.25 * lam5_2
    X5_2 = 0.25 * X4_2 + t29
    Y5_0 = 0.25 * Y4_0 + t27
    Y5_1 = 0.25 * Y4_1 + t28
    Y5_2 = 0.25 * Y4_2 + t29
    Z5_0 = 0.25 * Z4_0 + t27
    Z5_1 = 0.25 * Z4_1 + t28
    Z5_2 = 0.25 * Z4_2 + t29
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    t30 = -mean_0
    t31 = -X5_0 - t30
    dx_0 = over_0 * t31
    t32 = -mean_1
    t33 = -X5_1 - t32
    dx_1 = over1_0 * t31 + over_0 * t33
    t34 = -mean_2
    dx_2 = over1_0 * t33 + over2_0 * t31 + over_0 * (-X5_2 - t34)
    t35 = -Y5_0 - t30
    dy_0 = over_0 * t35
    t36 = -Y5_1 - t32
    dy_1 = over1_0 * t35 + over_0 * t36
    dy_2 = over1_0 * t36 + over2_0 * t35 + over_0 * (-Y5_2 - t34)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    zz_0 = dz_0 * dz_0
    t37 = 2.0 * dz_0
    zz_1 = dz_1 * t37
    zz_2 = dz_1 * dz_1 + dz_2 * t37
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    t38 = 3.0 * xy_0
    t39 = t38 - 8.0 * zz_0
    E3_0 = dz_0 * t39
    t40 = 3.0 * xy_1
    t41 = t40 - 8.0 * zz_1
    E3_1 = dz_0 * t41 + dz_1 * t39
    t42 = 3.0 * xy_2
    E3_2 = dz_0 * (t42 - 8.0 * zz_2) + dz_1 * t41 + dz_2 * t39
    t43 = t38 - 3.0 * zz_0
    E4_0 = t43 * zz_0
    t44 = t40 - 3.0 * zz_1
    E4_1 = t43 * zz_1 + t44 * zz_0
    E4_2 = t43 * zz_2 + t44 * zz_1 + zz_0 * (t42 - 3.0 * zz_2)
    t45 = xy_0 * zz_0
    E5_0 = dz_0 * t45
    t46 = xy_0 * zz_1 + xy_1 * zz_0
    E5_1 = dz_0 * t46 + dz_1 * t45
    E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * t46 + dz_2 * t45
    t47 = 0.17307692307692307 * E2_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.21428571428571427 * E2_0 - E3_0 * t47 + 0.16666666666666666 * E3_0 -
        0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    t48 = 0.17307692307692307 * E2_1
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.21428571428571427 * E2_1 - E3_0 * t48 - E3_1 * t47 +
        0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 + 0.10227272727272728 * E2_1 * E2_1 - 0.17307692307692307 * E2_2 * E3_0 -
        0.21428571428571427 * E2_2 - E3_1 * t48 - E3_2 * t47 + 0.16666666666666666 * E3_2 - 0.13636363636363635 *
        E4_2 + 0.11538461538461539 * E5_2
    )
    sq_0 = np.sqrt(over_0)
    sq_half_0 = 0.5 / sq_0
    sq1_0 = over1_0 * sq_half_0
    sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0)
    power_0 = over_0 * sq_0
    power_1 = over1_0 * sq_0 + over_0 * sq1_0
    power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0
    last_1 = power_0 * series_1 + power_1 * series_0
    last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0
    R_1 = (
        0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 * term31_0 +
        0.01171875 * term41_0 + 0.0029296875 * term51_0
    )
    R_2 = (
        0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 * term32_0 +
        0.01171875 * term42_0 + 0.0029296875 * term52_0
    )
    V4 = -2.0 * R_1 * third * x2
    V6 = 2.6666666666666665 * R_2 * third * x2 * x2
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    A3 = A * A2
    c2 = c * c
    c3 = c * c2
    return (
        -2.5464790894703255 * beta * (3.0 * A * (A2 * V6 + V4) - u_cr5 / (A3 * c3 * root)),
    )


def H_AA(A, alpha, beta, u_cr):
    """d2/dA2 of the averaged force H beside the vertical spring.

    Equation from (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_H_AA_passed_0, _H_AA_passed_0_steep, _H_AA_passed_1, _H_AA_passed_1_steep_far, _H_AA_passed_1_steep)
    return by_regime(guards, bodies, arguments, 1)[0]


def coefficients(lam, r, delta_h):
    """The parameters alpha, beta, u_cr from the design ratios.

    Equation (5), (7). Domain: any ratios.
    Operations: 11 structured, 10 common subexpressions, 10 power chains.
    """
    lam, r, delta_h = floats(lam, r, delta_h)
    t0 = lam * r
    arguments = (lam, r, delta_h)
    return (
        -delta_h * t0 + 1.0,
        -0.5 * t0 * (delta_h - 1.0),
        full(np.sqrt(delta_h) * np.sqrt(2.0 - delta_h), arguments),
    )


def breakpoints(alpha, beta, u_cr):
    """The |u| at which a piece of the force ends.

    Equation (5). Domain: any parameters.
    Operations: 0 structured, 0 common subexpressions, 0 power chains.
    """
    alpha, beta, u_cr = floats(alpha, beta, u_cr)
    arguments = (alpha, beta, u_cr)
    return (
        full(u_cr, arguments),
    )


def jumps(alpha, beta, u_cr):
    """What the force loses at each breakpoint: f below less f above.

    Equation (5). Domain: any parameters.
    Operations: 0 structured, 0 common subexpressions, 0 power chains.
    """
    alpha, beta, u_cr = floats(alpha, beta, u_cr)
    arguments = (alpha, beta, u_cr)
    return (
        full(0.0, arguments),
    )


def _force_piece_1(u, alpha, beta, u_cr):
    # operations: 16 structured, 12 common subexpressions, 12 power chains
    t0 = np.sqrt((1.0 - u) * (u + 1.0))
    return (
        u * (alpha + 2.0 * beta * u * u / (t0 * (t0 + 1.0))),
    )


def _force_piece_2(u, alpha, beta, u_cr):
    # operations: 0 structured, 0 common subexpressions, 0 power chains
    return (
        u,
    )


def force(u, alpha, beta, u_cr):
    """Whole dimensionless restoring force u + F_k(u), untruncated.

    Equation (3), (5). Domain: |u| < 1.
    """
    arguments = floats(u, alpha, beta, u_cr)
    u, alpha, beta, u_cr = arguments
    guards = (np.abs(u) <= u_cr,)
    bodies = (_force_piece_1, _force_piece_2)
    return by_regime(guards, bodies, arguments, 1)[0]


def _untruncated_force_piece_1(u, lam, r, delta_h):
    # operations: 15 structured, 11 common subexpressions, 11 power chains
    t0 = u * u
    t1 = np.sqrt(1.0 - t0)
    return (
        -lam * r * u * (delta_h - t0 / (t1 + 1.0)) / t1 + u,
    )


def _untruncated_force_piece_2(u, lam, r, delta_h):
    # operations: 0 structured, 0 common subexpressions, 0 power chains
    return (
        u,
    )


def untruncated_force(u, lam, r, delta_h):
    """Whole dimensionless restoring force u + F_k(u), untruncated.

    Equation (3), (5). Domain: |u| < 1.
    """
    arguments = floats(u, lam, r, delta_h)
    u, lam, r, delta_h = arguments
    guards = (np.abs(u) <= np.sqrt(delta_h) * np.sqrt(2.0 - delta_h),)
    bodies = (_untruncated_force_piece_1, _untruncated_force_piece_2)
    return by_regime(guards, bodies, arguments, 1)[0]


def R(Omega, A, mu, zeta, alpha, beta, u_cr):
    """Cosine balance, -F_0 cos phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta, u_cr)
    arguments = (Omega, A, mu, zeta, alpha, beta, u_cr)
    return full(flow.R(Omega, A, average), arguments)


def I(Omega, A, mu, zeta, alpha, beta, u_cr):  # noqa: E743
    """Sine balance, -F_0 sin phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0.
    """
    arguments = (Omega, A, mu, zeta, alpha, beta, u_cr)
    return full(flow.I(Omega, A, flow.friction(mu), zeta), arguments)


def F(Omega, A, F_0, mu, zeta, alpha, beta, u_cr):
    """Frequency response; zero at a steady state.

    Equation (24). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta, u_cr)
    return flow.F(Omega, A, F_0, flow.friction(mu), zeta, average)


def F_A(Omega, A, mu, zeta, alpha, beta, u_cr):
    """dF/dA; positive where stable.

    Equation (24), (30). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta, u_cr)
    return flow.F_A(Omega, A, flow.friction(mu), zeta, average, average_A)


def F_AA(Omega, A, mu, zeta, alpha, beta, u_cr):
    """d2F/dA2.

    Equation (24), (33). Domain: Omega > 0, A > 0.
    """
    average, average_A, average_AA = averaged_3(A, alpha, beta, u_cr)
    return flow.F_AA(Omega, A, flow.friction(mu), zeta, average, average_A, average_AA)


def F_AAA(Omega, A, mu, zeta, alpha, beta, u_cr):
    """d3F/dA3.

    Equation (24). Domain: Omega > 0, A > 0.
    """
    average, average_A, average_AA, average_AAA = averaged(A, alpha, beta, u_cr)
    return flow.F_AAA(Omega, A, flow.friction(mu), zeta, average, average_A, average_AA, average_AAA)


def F_Omega(Omega, A, mu, zeta, alpha, beta, u_cr):
    """dF/dOmega.

    Equation (24), (34). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta, u_cr)
    return flow.F_Omega(Omega, A, flow.friction(mu), zeta, average)


def F_AOmega(Omega, A, mu, zeta, alpha, beta, u_cr):
    """d2F/dA dOmega.

    Equation (24). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta, u_cr)
    return flow.F_AOmega(Omega, A, flow.friction(mu), zeta, average, average_A)


def phase(Omega, A, mu, zeta, alpha, beta, u_cr):
    """Phase phi of a steady state, from -pi to 0.

    Equation (25). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta, u_cr)
    return flow.phase(Omega, A, flow.friction(mu), zeta, average)


def jacobian(Omega, A, mu, zeta, alpha, beta, u_cr):
    """Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.

    Equation (28). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta, u_cr)
    return flow.jacobian(Omega, A, flow.friction(mu), zeta, average, average_A)


def stability(Omega, A, mu, zeta, alpha, beta, u_cr):
    """4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.

    Equation (30). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta, u_cr)
    return flow.stability(Omega, A, flow.friction(mu), zeta, average, average_A)


def transmissibility(Omega, A, F_0, mu, zeta, alpha, beta, u_cr):
    """Fundamental harmonic of the force on the base over F_0, at a steady state.

    Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0.
    """
    average = h(A, alpha, beta, u_cr)
    return flow.transmissibility(Omega, A, F_0, flow.friction(mu), zeta, average)


def backbone(A, alpha, beta, u_cr):
    """Frequency on the backbone.

    Equation (26). Domain: A > 0, h <= 0.
    """
    average = h(A, alpha, beta, u_cr)
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


globals().update(compiled("rod_spring_exact"))
