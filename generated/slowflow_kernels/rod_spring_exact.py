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


def _averaged_passed_1_far(A, alpha, beta, u_cr):
    # operations: 670 structured, 670 common subexpressions, 610 power chains
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
    term_1 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1)
    )
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    term_2 = (
        f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0 +
        0.98366812327974718) + 1.0) / (c + delta_2)
    )
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    term_3 = (
        f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 * (0.96002186496830755 * t0 +
        0.96002186496830755) + 1.0) / (c + delta_3)
    )
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    term_4 = (
        f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 +
        0.92620004742927431) + 1.0) / (c + delta_4)
    )
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    term_5 = (
        f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 * (0.88256053579205274 * t0 +
        0.88256053579205274) + 1.0) / (c + delta_5)
    )
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    term_6 = (
        f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 +
        0.82956576238276836) + 1.0) / (c + delta_6)
    )
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    term_7 = (
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7)
    )
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    term_8 = (
        f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585 * t0 +
        0.69785049479331585) + 1.0) / (c + delta_8)
    )
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    term_9 = (
        f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 +
        0.62052618298924289) + 1.0) / (c + delta_9)
    )
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    term_10 = (
        f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0) * (g_10 * (0.53662414814201986 * t0 +
        0.53662414814201986) + 1.0) / (c + delta_10)
    )
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    term_11 = (
        f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 +
        0.44703376953808915) + 1.0) / (c + delta_11)
    )
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    term_12 = (
        f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 * (0.35270472553087812 * t0 +
        0.35270472553087812) + 1.0) / (c + delta_12)
    )
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    term_13 = (
        f_13 * g_13 * (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 +
        0.25463692616788985) + 1.0) / (c + delta_13)
    )
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    term_14 = (
        f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 * t0 +
        0.15386991360858354) + 1.0) / (c + delta_14)
    )
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    term_15 = (
        f_15 * g_15 * (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 +
        0.051471842555317698) + 1.0) / (c + delta_15)
    )
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
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
    sum_2 = (
        tangent_10_2 * term_10 + tangent_11_2 * term_11 + tangent_12_2 * term_12 + tangent_13_2 * term_13 +
        tangent_14_2 * term_14 + tangent_15_2 * term_15 + tangent_1_2 * term_1 + tangent_2_2 * term_2 + tangent_3_2
        * term_3 + tangent_4_2 * term_4 + tangent_5_2 * term_5 + tangent_6_2 * term_6 + tangent_7_2 * term_7 +
        tangent_8_2 * term_8 + tangent_9_2 * term_9
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
    sum_3 = (
        tangent_10_3 * term_10 + tangent_11_3 * term_11 + tangent_12_3 * term_12 + tangent_13_3 * term_13 +
        tangent_14_3 * term_14 + tangent_15_3 * term_15 + tangent_1_3 * term_1 + tangent_2_3 * term_2 + tangent_3_3
        * term_3 + tangent_4_3 * term_4 + tangent_5_3 * term_5 + tangent_6_3 * term_6 + tangent_7_3 * term_7 +
        tangent_8_3 * term_8 + tangent_9_3 * term_9
    )
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    return (
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A,
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c) - 1.0,
        2.5464790894703255 * beta * (48.0 * T3 * sum_0 * u_cr2 / c + 56.0 * T3 * sum_1 * u_cr2 / c + 24.0 * T3 *
        sum_2 * u_cr2 / c) / A,
        2.5464790894703255 * beta * (-192.0 * T3 * sum_0 * u_cr2 / c - 384.0 * T3 * sum_1 * u_cr2 / c - 360.0 * T3 *
        sum_2 * u_cr2 / c - 120.0 * T3 * sum_3 * u_cr2 / c) / A2,
    )


def _averaged_passed_1(A, alpha, beta, u_cr):
    # operations: 637 structured, 637 common subexpressions, 594 power chains
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
    fall_1 = f_1 * v2_1 / square_1
    fall_2 = f_2 * v2_2 / square_2
    fall_3 = f_3 * v2_3 / square_3
    fall_4 = f_4 * v2_4 / square_4
    fall_5 = f_5 * v2_5 / square_5
    fall_6 = f_6 * v2_6 / square_6
    fall_7 = f_7 * v2_7 / square_7
    fall_8 = f_8 * v2_8 / square_8
    fall_9 = f_9 * v2_9 / square_9
    fall_10 = f_10 * v2_10 / square_10
    fall_11 = f_11 * v2_11 / square_11
    fall_12 = f_12 * v2_12 / square_12
    fall_13 = f_13 * v2_13 / square_13
    fall_14 = f_14 * v2_14 / square_14
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
    sum_2 = (
        fall_1 / square_1 + fall_10 / square_10 + fall_11 / square_11 + fall_12 / square_12 + fall_13 / square_13 +
        fall_14 / square_14 + fall_15 / square_15 + fall_2 / square_2 + fall_3 / square_3 + fall_4 / square_4 +
        fall_5 / square_5 + fall_6 / square_6 + fall_7 / square_7 + fall_8 / square_8 + fall_9 / square_9
    )
    sum_3 = (
        fall_1 * (4.0 * U2 * v2_1 + 1.0) / (square_1 * square_1) + fall_10 * (4.0 * U2 * v2_10 + 1.0) / (square_10 *
        square_10) + fall_11 * (4.0 * U2 * v2_11 + 1.0) / (square_11 * square_11) + fall_12 * (4.0 * U2 * v2_12 +
        1.0) / (square_12 * square_12) + fall_13 * (4.0 * U2 * v2_13 + 1.0) / (square_13 * square_13) + fall_14 *
        (4.0 * U2 * v2_14 + 1.0) / (square_14 * square_14) + fall_15 * (4.0 * U2 * v2_15 + 1.0) / (square_15 *
        square_15) + fall_2 * (4.0 * U2 * v2_2 + 1.0) / (square_2 * square_2) + fall_3 * (4.0 * U2 * v2_3 + 1.0) /
        (square_3 * square_3) + fall_4 * (4.0 * U2 * v2_4 + 1.0) / (square_4 * square_4) + fall_5 * (4.0 * U2 * v2_5
        + 1.0) / (square_5 * square_5) + fall_6 * (4.0 * U2 * v2_6 + 1.0) / (square_6 * square_6) + fall_7 * (4.0 *
        U2 * v2_7 + 1.0) / (square_7 * square_7) + fall_8 * (4.0 * U2 * v2_8 + 1.0) / (square_8 * square_8) + fall_9
        * (4.0 * U2 * v2_9 + 1.0) / (square_9 * square_9)
    )
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    T4 = t0 * t0
    T5 = T * T4
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    A3 = A * A2
    c2 = c * c
    c3 = c * c2
    root2 = root * root
    root3 = root * root2
    A4 = A2 * A2
    c4 = c2 * c2
    c5 = c * c4
    return (
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A,
        -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr2 / c) - 1.0,
        -2.5464790894703255 * beta * (96.0 * A * T5 * sum_2 - u_cr5 / (A3 * c3 * root)),
        -2.5464790894703255 * beta * (96.0 * T5 * sum_3 - 3.0 * u_cr5 / (A4 * c5 * root) + 3.0 * u_cr5 / (A4 * c3 *
        root) + u_cr5 / (A2 * c3 * root3)),
    )


def _averaged_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 1666 structured, 1666 common subexpressions, 1613 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    a0_half_0_2 = a0_half_0 * a0_half_0
    a0_half_0_3 = a0_half_0 * a0_half_0_2
    a02_0 = -a0_half_0_3
    a03_0 = -2.0 * a02_0 * a0_half_0_2
    b0_0 = np.sqrt(Y_0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    lam0_2 = a02_0 * b0_0 + a02_0
    lam0_3 = a03_0 * b0_0 + a03_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    term03_0 = -term0_0 * (lam0_1 * term02_0 + lam0_2 * term01_0 + lam0_3 * term0_0)
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1 + 0.25
    X0_2 = 0.25 * lam0_2
    X0_3 = 0.25 * lam0_3
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1
    Y0_2 = 0.25 * lam0_2
    Y0_3 = 0.25 * lam0_3
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    Z0_2 = 0.25 * lam0_2
    Z0_3 = 0.25 * lam0_3
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0)
    a13_0 = a1_half_0 * (X0_3 - 2.0 * a11_0 * a12_0)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0)
    b13_0 = b1_half_0 * (Y0_3 - 2.0 * b11_0 * b12_0)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0)
    c13_0 = c1_half_0 * (Z0_3 - 2.0 * c11_0 * c12_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    lam1_2 = (
        a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 + b1_0) + c1_0 *
        (a12_0 + b12_0)
    )
    lam1_3 = (
        a11_0 * b12_0 + a12_0 * b11_0 + a13_0 * b1_0 + a1_0 * b13_0 + c11_0 * (a12_0 + b12_0) + c12_0 * (a11_0 +
        b11_0) + c13_0 * (a1_0 + b1_0) + c1_0 * (a13_0 + b13_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    q1_2 = Z0_2 + lam1_2
    q1_3 = Z0_3 + lam1_3
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    below1_3 = c11_0 * q1_2 + c12_0 * q1_1 + c13_0 * q1_0 + c1_0 * q1_3
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    term13_0 = -term1_0 * (below1_1 * term12_0 + below1_2 * term11_0 + below1_3 * term1_0)
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    X1_2 = 0.25 * X0_2 + 0.25 * lam1_2
    X1_3 = 0.25 * X0_3 + 0.25 * lam1_3
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2
    Y1_3 = 0.25 * Y0_3 + 0.25 * lam1_3
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2
    Z1_3 = 0.25 * Z0_3 + 0.25 * lam1_3
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
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    lam2_2 = (
        a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 + b2_0) + c2_0 *
        (a22_0 + b22_0)
    )
    lam2_3 = (
        a21_0 * b22_0 + a22_0 * b21_0 + a23_0 * b2_0 + a2_0 * b23_0 + c21_0 * (a22_0 + b22_0) + c22_0 * (a21_0 +
        b21_0) + c23_0 * (a2_0 + b2_0) + c2_0 * (a23_0 + b23_0)
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
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    X2_2 = 0.25 * X1_2 + 0.25 * lam2_2
    X2_3 = 0.25 * X1_3 + 0.25 * lam2_3
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2
    Y2_3 = 0.25 * Y1_3 + 0.25 * lam2_3
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2
    Z2_3 = 0.25 * Z1_3 + 0.25 * lam2_3
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
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    lam3_2 = (
        a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 + b3_0) + c3_0 *
        (a32_0 + b32_0)
    )
    lam3_3 = (
        a31_0 * b32_0 + a32_0 * b31_0 + a33_0 * b3_0 + a3_0 * b33_0 + c31_0 * (a32_0 + b32_0) + c32_0 * (a31_0 +
        b31_0) + c33_0 * (a3_0 + b3_0) + c3_0 * (a33_0 + b33_0)
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
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    X3_2 = 0.25 * X2_2 + 0.25 * lam3_2
    X3_3 = 0.25 * X2_3 + 0.25 * lam3_3
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2
    Y3_3 = 0.25 * Y2_3 + 0.25 * lam3_3
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2
    Z3_3 = 0.25 * Z2_3 + 0.25 * lam3_3
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
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    lam4_2 = (
        a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 + b4_0) + c4_0 *
        (a42_0 + b42_0)
    )
    lam4_3 = (
        a41_0 * b42_0 + a42_0 * b41_0 + a43_0 * b4_0 + a4_0 * b43_0 + c41_0 * (a42_0 + b42_0) + c42_0 * (a41_0 +
        b41_0) + c43_0 * (a4_0 + b4_0) + c4_0 * (a43_0 + b43_0)
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
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    X4_2 = 0.25 * X3_2 + 0.25 * lam4_2
    X4_3 = 0.25 * X3_3 + 0.25 * lam4_3
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2
    Y4_3 = 0.25 * Y3_3 + 0.25 * lam4_3
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2
    Z4_3 = 0.25 * Z3_3 + 0.25 * lam4_3
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
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    lam5_2 = (
        a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 + b5_0) + c5_0 *
        (a52_0 + b52_0)
    )
    lam5_3 = (
        a51_0 * b52_0 + a52_0 * b51_0 + a53_0 * b5_0 + a5_0 * b53_0 + c51_0 * (a52_0 + b52_0) + c52_0 * (a51_0 +
        b51_0) + c53_0 * (a5_0 + b5_0) + c5_0 * (a53_0 + b53_0)
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
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    X5_2 = 0.25 * X4_2 + 0.25 * lam5_2
    X5_3 = 0.25 * X4_3 + 0.25 * lam5_3
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2
    Y5_3 = 0.25 * Y4_3 + 0.25 * lam5_3
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2
    Z5_3 = 0.25 * Z4_3 + 0.25 * lam5_3
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    mean_3 = 0.20000000000000001 * X5_3 + 0.20000000000000001 * Y5_3 + 0.59999999999999998 * Z5_3
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    over3_0 = -over_0 * (mean_1 * over2_0 + mean_2 * over1_0 + mean_3 * over_0)
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2)
    dx_3 = (
        over1_0 * (-X5_2 + mean_2) + over2_0 * (-X5_1 + mean_1) + over3_0 * (-X5_0 + mean_0) + over_0 * (-X5_3 +
        mean_3)
    )
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2)
    dy_3 = (
        over1_0 * (-Y5_2 + mean_2) + over2_0 * (-Y5_1 + mean_1) + over3_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_3 +
        mean_3)
    )
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    dz_3 = -0.33333333333333331 * dx_3 - 0.33333333333333331 * dy_3
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    xy_3 = dx_0 * dy_3 + dx_1 * dy_2 + dx_2 * dy_1 + dx_3 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1
    zz_3 = 2.0 * dz_0 * dz_3 + 2.0 * dz_1 * dz_2
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E2_3 = xy_3 - 6.0 * zz_3
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_2 = (
        dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E3_3 = (
        dz_0 * (3.0 * xy_3 - 8.0 * zz_3) + dz_1 * (3.0 * xy_2 - 8.0 * zz_2) + dz_2 * (3.0 * xy_1 - 8.0 * zz_1) +
        dz_3 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_2 = (
        zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E4_3 = (
        zz_0 * (3.0 * xy_3 - 3.0 * zz_3) + zz_1 * (3.0 * xy_2 - 3.0 * zz_2) + zz_2 * (3.0 * xy_1 - 3.0 * zz_1) +
        zz_3 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    E5_2 = (
        dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2 * xy_0 * zz_0
    )
    E5_3 = (
        dz_0 * (xy_0 * zz_3 + xy_1 * zz_2 + xy_2 * zz_1 + xy_3 * zz_0) + dz_1 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 *
        zz_0) + dz_2 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_3 * xy_0 * zz_0
    )
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 + 0.10227272727272728 * E2_1 * E2_1 -
        0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 - 0.21428571428571427 * E2_2 +
        0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 * E5_2
    )
    series_3 = (
        0.20454545454545456 * E2_0 * E2_3 - 0.17307692307692307 * E2_0 * E3_3 + 0.20454545454545456 * E2_1 * E2_2 -
        0.17307692307692307 * E2_1 * E3_2 - 0.17307692307692307 * E2_2 * E3_1 - 0.17307692307692307 * E2_3 * E3_0 -
        0.21428571428571427 * E2_3 + 0.16666666666666666 * E3_3 - 0.13636363636363635 * E4_3 + 0.11538461538461539 *
        E5_3
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
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
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
    sum_2 = (
        tangent_10_2 * term_10 + tangent_11_2 * term_11 + tangent_12_2 * term_12 + tangent_13_2 * term_13 +
        tangent_14_2 * term_14 + tangent_15_2 * term_15 + tangent_1_2 * term_1 + tangent_2_2 * term_2 + tangent_3_2
        * term_3 + tangent_4_2 * term_4 + tangent_5_2 * term_5 + tangent_6_2 * term_6 + tangent_7_2 * term_7 +
        tangent_8_2 * term_8 + tangent_9_2 * term_9
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
    sum_3 = (
        tangent_10_3 * term_10 + tangent_11_3 * term_11 + tangent_12_3 * term_12 + tangent_13_3 * term_13 +
        tangent_14_3 * term_14 + tangent_15_3 * term_15 + tangent_1_3 * term_1 + tangent_2_3 * term_2 + tangent_3_3
        * term_3 + tangent_4_3 * term_4 + tangent_5_3 * term_5 + tangent_6_3 * term_6 + tangent_7_3 * term_7 +
        tangent_8_3 * term_8 + tangent_9_3 * term_9
    )
    T3 = T * t0
    return (
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A,
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4) - 1.0,
        2.5464790894703255 * beta * (48.0 * T3 * sum_0 / c + 56.0 * T3 * sum_1 / c + 24.0 * T3 * sum_2 / c - 6.0 *
        V2 - 7.0 * V4 - 3.0 * V6) / A,
        2.5464790894703255 * beta * (-192.0 * T3 * sum_0 / c - 384.0 * T3 * sum_1 / c - 360.0 * T3 * sum_2 / c -
        120.0 * T3 * sum_3 / c + 24.0 * V2 + 48.0 * V4 + 45.0 * V6 + 15.0 * V8) / A2,
    )


def _averaged_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 1452 structured, 1452 common subexpressions, 1414 power chains
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
    u_cr2 = u_cr * u_cr
    A2 = A * A
    x2 = u_cr2 / A2
    root2 = root * root
    y2 = root2 / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(Y_0)
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
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1
    X0_2 = 0.25 * lam0_2
    X0_3 = 0.25 * lam0_3
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1 + 0.25
    Y0_2 = 0.25 * lam0_2
    Y0_3 = 0.25 * lam0_3
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    Z0_2 = 0.25 * lam0_2
    Z0_3 = 0.25 * lam0_3
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0)
    a13_0 = a1_half_0 * (X0_3 - 2.0 * a11_0 * a12_0)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0)
    b13_0 = b1_half_0 * (Y0_3 - 2.0 * b11_0 * b12_0)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0)
    c13_0 = c1_half_0 * (Z0_3 - 2.0 * c11_0 * c12_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    lam1_2 = (
        a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 + b1_0) + c1_0 *
        (a12_0 + b12_0)
    )
    lam1_3 = (
        a11_0 * b12_0 + a12_0 * b11_0 + a13_0 * b1_0 + a1_0 * b13_0 + c11_0 * (a12_0 + b12_0) + c12_0 * (a11_0 +
        b11_0) + c13_0 * (a1_0 + b1_0) + c1_0 * (a13_0 + b13_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    q1_2 = Z0_2 + lam1_2
    q1_3 = Z0_3 + lam1_3
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    below1_3 = c11_0 * q1_2 + c12_0 * q1_1 + c13_0 * q1_0 + c1_0 * q1_3
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    term13_0 = -term1_0 * (below1_1 * term12_0 + below1_2 * term11_0 + below1_3 * term1_0)
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    X1_2 = 0.25 * X0_2 + 0.25 * lam1_2
    X1_3 = 0.25 * X0_3 + 0.25 * lam1_3
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2
    Y1_3 = 0.25 * Y0_3 + 0.25 * lam1_3
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2
    Z1_3 = 0.25 * Z0_3 + 0.25 * lam1_3
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
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    lam2_2 = (
        a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 + b2_0) + c2_0 *
        (a22_0 + b22_0)
    )
    lam2_3 = (
        a21_0 * b22_0 + a22_0 * b21_0 + a23_0 * b2_0 + a2_0 * b23_0 + c21_0 * (a22_0 + b22_0) + c22_0 * (a21_0 +
        b21_0) + c23_0 * (a2_0 + b2_0) + c2_0 * (a23_0 + b23_0)
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
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    X2_2 = 0.25 * X1_2 + 0.25 * lam2_2
    X2_3 = 0.25 * X1_3 + 0.25 * lam2_3
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2
    Y2_3 = 0.25 * Y1_3 + 0.25 * lam2_3
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2
    Z2_3 = 0.25 * Z1_3 + 0.25 * lam2_3
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
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    lam3_2 = (
        a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 + b3_0) + c3_0 *
        (a32_0 + b32_0)
    )
    lam3_3 = (
        a31_0 * b32_0 + a32_0 * b31_0 + a33_0 * b3_0 + a3_0 * b33_0 + c31_0 * (a32_0 + b32_0) + c32_0 * (a31_0 +
        b31_0) + c33_0 * (a3_0 + b3_0) + c3_0 * (a33_0 + b33_0)
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
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    X3_2 = 0.25 * X2_2 + 0.25 * lam3_2
    X3_3 = 0.25 * X2_3 + 0.25 * lam3_3
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2
    Y3_3 = 0.25 * Y2_3 + 0.25 * lam3_3
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2
    Z3_3 = 0.25 * Z2_3 + 0.25 * lam3_3
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
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    lam4_2 = (
        a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 + b4_0) + c4_0 *
        (a42_0 + b42_0)
    )
    lam4_3 = (
        a41_0 * b42_0 + a42_0 * b41_0 + a43_0 * b4_0 + a4_0 * b43_0 + c41_0 * (a42_0 + b42_0) + c42_0 * (a41_0 +
        b41_0) + c43_0 * (a4_0 + b4_0) + c4_0 * (a43_0 + b43_0)
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
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    X4_2 = 0.25 * X3_2 + 0.25 * lam4_2
    X4_3 = 0.25 * X3_3 + 0.25 * lam4_3
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2
    Y4_3 = 0.25 * Y3_3 + 0.25 * lam4_3
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2
    Z4_3 = 0.25 * Z3_3 + 0.25 * lam4_3
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
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    lam5_2 = (
        a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 + b5_0) + c5_0 *
        (a52_0 + b52_0)
    )
    lam5_3 = (
        a51_0 * b52_0 + a52_0 * b51_0 + a53_0 * b5_0 + a5_0 * b53_0 + c51_0 * (a52_0 + b52_0) + c52_0 * (a51_0 +
        b51_0) + c53_0 * (a5_0 + b5_0) + c5_0 * (a53_0 + b53_0)
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
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    X5_2 = 0.25 * X4_2 + 0.25 * lam5_2
    X5_3 = 0.25 * X4_3 + 0.25 * lam5_3
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2
    Y5_3 = 0.25 * Y4_3 + 0.25 * lam5_3
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2
    Z5_3 = 0.25 * Z4_3 + 0.25 * lam5_3
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    mean_3 = 0.20000000000000001 * X5_3 + 0.20000000000000001 * Y5_3 + 0.59999999999999998 * Z5_3
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    over3_0 = -over_0 * (mean_1 * over2_0 + mean_2 * over1_0 + mean_3 * over_0)
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2)
    dx_3 = (
        over1_0 * (-X5_2 + mean_2) + over2_0 * (-X5_1 + mean_1) + over3_0 * (-X5_0 + mean_0) + over_0 * (-X5_3 +
        mean_3)
    )
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2)
    dy_3 = (
        over1_0 * (-Y5_2 + mean_2) + over2_0 * (-Y5_1 + mean_1) + over3_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_3 +
        mean_3)
    )
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    dz_3 = -0.33333333333333331 * dx_3 - 0.33333333333333331 * dy_3
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    xy_3 = dx_0 * dy_3 + dx_1 * dy_2 + dx_2 * dy_1 + dx_3 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1
    zz_3 = 2.0 * dz_0 * dz_3 + 2.0 * dz_1 * dz_2
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E2_3 = xy_3 - 6.0 * zz_3
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_2 = (
        dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E3_3 = (
        dz_0 * (3.0 * xy_3 - 8.0 * zz_3) + dz_1 * (3.0 * xy_2 - 8.0 * zz_2) + dz_2 * (3.0 * xy_1 - 8.0 * zz_1) +
        dz_3 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_2 = (
        zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E4_3 = (
        zz_0 * (3.0 * xy_3 - 3.0 * zz_3) + zz_1 * (3.0 * xy_2 - 3.0 * zz_2) + zz_2 * (3.0 * xy_1 - 3.0 * zz_1) +
        zz_3 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    E5_2 = (
        dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2 * xy_0 * zz_0
    )
    E5_3 = (
        dz_0 * (xy_0 * zz_3 + xy_1 * zz_2 + xy_2 * zz_1 + xy_3 * zz_0) + dz_1 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 *
        zz_0) + dz_2 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_3 * xy_0 * zz_0
    )
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 + 0.10227272727272728 * E2_1 * E2_1 -
        0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 - 0.21428571428571427 * E2_2 +
        0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 * E5_2
    )
    series_3 = (
        0.20454545454545456 * E2_0 * E2_3 - 0.17307692307692307 * E2_0 * E3_3 + 0.20454545454545456 * E2_1 * E2_2 -
        0.17307692307692307 * E2_1 * E3_2 - 0.17307692307692307 * E2_2 * E3_1 - 0.17307692307692307 * E2_3 * E3_0 -
        0.21428571428571427 * E2_3 + 0.16666666666666666 * E3_3 - 0.13636363636363635 * E4_3 + 0.11538461538461539 *
        E5_3
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
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    T3 = T * t0
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    A3 = A * A2
    c2 = c * c
    c3 = c * c2
    root3 = root * root2
    A4 = A2 * A2
    c4 = c2 * c2
    c5 = c * c4
    return (
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A,
        -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2) - 1.0,
        -2.5464790894703255 * beta * (3.0 * A * (A2 * V6 + V4) - u_cr5 / (A3 * c3 * root)),
        -2.5464790894703255 * beta * (3.0 * A2 * (5.0 * A2 * V8 + 6.0 * V6) + 3.0 * V4 - 3.0 * u_cr5 / (A4 * c5 *
        root) + 3.0 * u_cr5 / (A4 * c3 * root) + u_cr5 / (A2 * c3 * root3)),
    )


def averaged(A, alpha, beta, u_cr):
    """h, h_A, h_AA, h_AAA together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, (u_cr <= 0.75) & (1.05 * u_cr <= A), u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_averaged_passed_0, _averaged_passed_0_steep, _averaged_passed_1_far, _averaged_passed_1, _averaged_passed_1_steep_far, _averaged_passed_1_steep)
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


def _averaged_3_passed_1_far(A, alpha, beta, u_cr):
    # operations: 576 structured, 576 common subexpressions, 544 power chains
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
    term_1 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1)
    )
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    term_2 = (
        f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0 +
        0.98366812327974718) + 1.0) / (c + delta_2)
    )
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    term_3 = (
        f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 * (0.96002186496830755 * t0 +
        0.96002186496830755) + 1.0) / (c + delta_3)
    )
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    term_4 = (
        f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 +
        0.92620004742927431) + 1.0) / (c + delta_4)
    )
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    term_5 = (
        f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 * (0.88256053579205274 * t0 +
        0.88256053579205274) + 1.0) / (c + delta_5)
    )
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    term_6 = (
        f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 +
        0.82956576238276836) + 1.0) / (c + delta_6)
    )
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    term_7 = (
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7)
    )
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    term_8 = (
        f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585 * t0 +
        0.69785049479331585) + 1.0) / (c + delta_8)
    )
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    term_9 = (
        f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 +
        0.62052618298924289) + 1.0) / (c + delta_9)
    )
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    term_10 = (
        f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0) * (g_10 * (0.53662414814201986 * t0 +
        0.53662414814201986) + 1.0) / (c + delta_10)
    )
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    term_11 = (
        f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 +
        0.44703376953808915) + 1.0) / (c + delta_11)
    )
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    term_12 = (
        f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 * (0.35270472553087812 * t0 +
        0.35270472553087812) + 1.0) / (c + delta_12)
    )
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    term_13 = (
        f_13 * g_13 * (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 +
        0.25463692616788985) + 1.0) / (c + delta_13)
    )
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    term_14 = (
        f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 * t0 +
        0.15386991360858354) + 1.0) / (c + delta_14)
    )
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    term_15 = (
        f_15 * g_15 * (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 +
        0.051471842555317698) + 1.0) / (c + delta_15)
    )
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
    )
    sum_2 = (
        tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 * tangent_11 * term_11 +
        tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 * tangent_14 * term_14 +
        tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 * tangent_3 * term_3 +
        tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6 * term_6 + tangent_7
        * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9
    )
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    return (
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A,
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c) - 1.0,
        2.5464790894703255 * beta * (48.0 * T3 * sum_0 * u_cr2 / c + 56.0 * T3 * sum_1 * u_cr2 / c + 24.0 * T3 *
        sum_2 * u_cr2 / c) / A,
    )


def _averaged_3_passed_1(A, alpha, beta, u_cr):
    # operations: 482 structured, 482 common subexpressions, 467 power chains
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
    fall_1 = f_1 * v2_1 / square_1
    fall_2 = f_2 * v2_2 / square_2
    fall_3 = f_3 * v2_3 / square_3
    fall_4 = f_4 * v2_4 / square_4
    fall_5 = f_5 * v2_5 / square_5
    fall_6 = f_6 * v2_6 / square_6
    fall_7 = f_7 * v2_7 / square_7
    fall_8 = f_8 * v2_8 / square_8
    fall_9 = f_9 * v2_9 / square_9
    fall_10 = f_10 * v2_10 / square_10
    fall_11 = f_11 * v2_11 / square_11
    fall_12 = f_12 * v2_12 / square_12
    fall_13 = f_13 * v2_13 / square_13
    fall_14 = f_14 * v2_14 / square_14
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
    sum_2 = (
        fall_1 / square_1 + fall_10 / square_10 + fall_11 / square_11 + fall_12 / square_12 + fall_13 / square_13 +
        fall_14 / square_14 + fall_15 / square_15 + fall_2 / square_2 + fall_3 / square_3 + fall_4 / square_4 +
        fall_5 / square_5 + fall_6 / square_6 + fall_7 / square_7 + fall_8 / square_8 + fall_9 / square_9
    )
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    T4 = t0 * t0
    T5 = T * T4
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    A3 = A * A2
    c2 = c * c
    c3 = c * c2
    return (
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A,
        -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr2 / c) - 1.0,
        -2.5464790894703255 * beta * (96.0 * A * T5 * sum_2 - u_cr5 / (A3 * c3 * root)),
    )


def _averaged_3_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 1116 structured, 1116 common subexpressions, 1089 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    a0_half_0_2 = a0_half_0 * a0_half_0
    a0_half_0_3 = a0_half_0 * a0_half_0_2
    a02_0 = -a0_half_0_3
    b0_0 = np.sqrt(Y_0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    lam0_2 = a02_0 * b0_0 + a02_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1 + 0.25
    X0_2 = 0.25 * lam0_2
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1
    Y0_2 = 0.25 * lam0_2
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    Z0_2 = 0.25 * lam0_2
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    lam1_2 = (
        a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 + b1_0) + c1_0 *
        (a12_0 + b12_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    q1_2 = Z0_2 + lam1_2
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    X1_2 = 0.25 * X0_2 + 0.25 * lam1_2
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2
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
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    lam2_2 = (
        a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 + b2_0) + c2_0 *
        (a22_0 + b22_0)
    )
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    X2_2 = 0.25 * X1_2 + 0.25 * lam2_2
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2
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
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    lam3_2 = (
        a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 + b3_0) + c3_0 *
        (a32_0 + b32_0)
    )
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    X3_2 = 0.25 * X2_2 + 0.25 * lam3_2
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2
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
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    lam4_2 = (
        a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 + b4_0) + c4_0 *
        (a42_0 + b42_0)
    )
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    X4_2 = 0.25 * X3_2 + 0.25 * lam4_2
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2
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
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    lam5_2 = (
        a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 + b5_0) + c5_0 *
        (a52_0 + b52_0)
    )
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    X5_2 = 0.25 * X4_2 + 0.25 * lam5_2
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_2 = (
        dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_2 = (
        zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    E5_2 = (
        dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2 * xy_0 * zz_0
    )
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 + 0.10227272727272728 * E2_1 * E2_1 -
        0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 - 0.21428571428571427 * E2_2 +
        0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 * E5_2
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
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
    )
    sum_2 = (
        tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 * tangent_11 * term_11 +
        tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 * tangent_14 * term_14 +
        tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 * tangent_3 * term_3 +
        tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6 * term_6 + tangent_7
        * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9
    )
    T3 = T * t0
    return (
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A,
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4) - 1.0,
        2.5464790894703255 * beta * (48.0 * T3 * sum_0 / c + 56.0 * T3 * sum_1 / c + 24.0 * T3 * sum_2 / c - 6.0 *
        V2 - 7.0 * V4 - 3.0 * V6) / A,
    )


def _averaged_3_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 941 structured, 941 common subexpressions, 932 power chains
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
    u_cr2 = u_cr * u_cr
    A2 = A * A
    x2 = u_cr2 / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(Y_0)
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
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1
    X0_2 = 0.25 * lam0_2
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1 + 0.25
    Y0_2 = 0.25 * lam0_2
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    Z0_2 = 0.25 * lam0_2
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    lam1_2 = (
        a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 + b1_0) + c1_0 *
        (a12_0 + b12_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    q1_2 = Z0_2 + lam1_2
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    X1_2 = 0.25 * X0_2 + 0.25 * lam1_2
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2
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
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    lam2_2 = (
        a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 + b2_0) + c2_0 *
        (a22_0 + b22_0)
    )
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    X2_2 = 0.25 * X1_2 + 0.25 * lam2_2
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2
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
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    lam3_2 = (
        a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 + b3_0) + c3_0 *
        (a32_0 + b32_0)
    )
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    X3_2 = 0.25 * X2_2 + 0.25 * lam3_2
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2
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
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    lam4_2 = (
        a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 + b4_0) + c4_0 *
        (a42_0 + b42_0)
    )
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    X4_2 = 0.25 * X3_2 + 0.25 * lam4_2
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2
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
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    lam5_2 = (
        a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 + b5_0) + c5_0 *
        (a52_0 + b52_0)
    )
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    X5_2 = 0.25 * X4_2 + 0.25 * lam5_2
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_2 = (
        dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_2 = (
        zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    E5_2 = (
        dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2 * xy_0 * zz_0
    )
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 + 0.10227272727272728 * E2_1 * E2_1 -
        0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 - 0.21428571428571427 * E2_2 +
        0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 * E5_2
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
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    T3 = T * t0
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    A3 = A * A2
    c2 = c * c
    c3 = c * c2
    return (
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A,
        -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2) - 1.0,
        -2.5464790894703255 * beta * (3.0 * A * (A2 * V6 + V4) - u_cr5 / (A3 * c3 * root)),
    )


def averaged_3(A, alpha, beta, u_cr):
    """h, h_A, h_AA together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, (u_cr <= 0.75) & (1.05 * u_cr <= A), u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_averaged_3_passed_0, _averaged_3_passed_0_steep, _averaged_3_passed_1_far, _averaged_3_passed_1, _averaged_3_passed_1_steep_far, _averaged_3_passed_1_steep)
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


def _averaged_2_passed_1_far(A, alpha, beta, u_cr):
    # operations: 506 structured, 506 common subexpressions, 483 power chains
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
    term_1 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1)
    )
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    term_2 = (
        f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0 +
        0.98366812327974718) + 1.0) / (c + delta_2)
    )
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    term_3 = (
        f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 * (0.96002186496830755 * t0 +
        0.96002186496830755) + 1.0) / (c + delta_3)
    )
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    term_4 = (
        f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 +
        0.92620004742927431) + 1.0) / (c + delta_4)
    )
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    term_5 = (
        f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 * (0.88256053579205274 * t0 +
        0.88256053579205274) + 1.0) / (c + delta_5)
    )
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    term_6 = (
        f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 +
        0.82956576238276836) + 1.0) / (c + delta_6)
    )
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    term_7 = (
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7)
    )
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    term_8 = (
        f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585 * t0 +
        0.69785049479331585) + 1.0) / (c + delta_8)
    )
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    term_9 = (
        f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 +
        0.62052618298924289) + 1.0) / (c + delta_9)
    )
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    term_10 = (
        f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0) * (g_10 * (0.53662414814201986 * t0 +
        0.53662414814201986) + 1.0) / (c + delta_10)
    )
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    term_11 = (
        f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 +
        0.44703376953808915) + 1.0) / (c + delta_11)
    )
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    term_12 = (
        f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 * (0.35270472553087812 * t0 +
        0.35270472553087812) + 1.0) / (c + delta_12)
    )
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    term_13 = (
        f_13 * g_13 * (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 +
        0.25463692616788985) + 1.0) / (c + delta_13)
    )
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    term_14 = (
        f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 * t0 +
        0.15386991360858354) + 1.0) / (c + delta_14)
    )
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    term_15 = (
        f_15 * g_15 * (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 +
        0.051471842555317698) + 1.0) / (c + delta_15)
    )
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
    )
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    return (
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A,
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c) - 1.0,
    )


def _averaged_2_passed_1(A, alpha, beta, u_cr):
    # operations: 432 structured, 432 common subexpressions, 424 power chains
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
    fall_1 = f_1 * v2_1 / square_1
    fall_2 = f_2 * v2_2 / square_2
    fall_3 = f_3 * v2_3 / square_3
    fall_4 = f_4 * v2_4 / square_4
    fall_5 = f_5 * v2_5 / square_5
    fall_6 = f_6 * v2_6 / square_6
    fall_7 = f_7 * v2_7 / square_7
    fall_8 = f_8 * v2_8 / square_8
    fall_9 = f_9 * v2_9 / square_9
    fall_10 = f_10 * v2_10 / square_10
    fall_11 = f_11 * v2_11 / square_11
    fall_12 = f_12 * v2_12 / square_12
    fall_13 = f_13 * v2_13 / square_13
    fall_14 = f_14 * v2_14 / square_14
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
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    T4 = t0 * t0
    T5 = T * T4
    return (
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A,
        -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr2 / c) - 1.0,
    )


def _averaged_2_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 692 structured, 692 common subexpressions, 671 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    b0_0 = np.sqrt(Y_0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1 + 0.25
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
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
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
    )
    T3 = T * t0
    return (
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A,
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4) - 1.0,
    )


def _averaged_2_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 568 structured, 568 common subexpressions, 563 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(Y_0)
    b0_half_0 = 0.5 / b0_0
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_0 * b0_half_0 + b0_half_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1 + 0.25
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
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
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    T3 = T * t0
    return (
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A,
        -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2) - 1.0,
    )


def averaged_2(A, alpha, beta, u_cr):
    """h, h_A together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, (u_cr <= 0.75) & (1.05 * u_cr <= A), u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_averaged_2_passed_0, _averaged_2_passed_0_steep, _averaged_2_passed_1_far, _averaged_2_passed_1, _averaged_2_passed_1_steep_far, _averaged_2_passed_1_steep)
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


def _h_passed_1_far(A, alpha, beta, u_cr):
    # operations: 369 structured, 369 common subexpressions, 367 power chains
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
    term_1 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1)
    )
    term_2 = (
        f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0 +
        0.98366812327974718) + 1.0) / (c + delta_2)
    )
    term_3 = (
        f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 * (0.96002186496830755 * t0 +
        0.96002186496830755) + 1.0) / (c + delta_3)
    )
    term_4 = (
        f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 +
        0.92620004742927431) + 1.0) / (c + delta_4)
    )
    term_5 = (
        f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 * (0.88256053579205274 * t0 +
        0.88256053579205274) + 1.0) / (c + delta_5)
    )
    term_6 = (
        f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 +
        0.82956576238276836) + 1.0) / (c + delta_6)
    )
    term_7 = (
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7)
    )
    term_8 = (
        f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585 * t0 +
        0.69785049479331585) + 1.0) / (c + delta_8)
    )
    term_9 = (
        f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 +
        0.62052618298924289) + 1.0) / (c + delta_9)
    )
    term_10 = (
        f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0) * (g_10 * (0.53662414814201986 * t0 +
        0.53662414814201986) + 1.0) / (c + delta_10)
    )
    term_11 = (
        f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 +
        0.44703376953808915) + 1.0) / (c + delta_11)
    )
    term_12 = (
        f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 * (0.35270472553087812 * t0 +
        0.35270472553087812) + 1.0) / (c + delta_12)
    )
    term_13 = (
        f_13 * g_13 * (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 +
        0.25463692616788985) + 1.0) / (c + delta_13)
    )
    term_14 = (
        f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 * t0 +
        0.15386991360858354) + 1.0) / (c + delta_14)
    )
    term_15 = (
        f_15 * g_15 * (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 +
        0.051471842555317698) + 1.0) / (c + delta_15)
    )
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    T3 = T * t0
    return (
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr * u_cr / c - A,
    )


def _h_passed_1(A, alpha, beta, u_cr):
    # operations: 369 structured, 369 common subexpressions, 367 power chains
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
    # operations: 305 structured, 305 common subexpressions, 303 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(Y_0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Z0_0 = 0.25 * lam0_0 + 0.25
    a1_0 = np.sqrt(X0_0)
    b1_0 = np.sqrt(Y0_0)
    c1_0 = np.sqrt(Z0_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    q1_0 = Z0_0 + lam1_0
    below1_0 = c1_0 * q1_0
    term1_0 = 1.0 / below1_0
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    a2_0 = np.sqrt(X1_0)
    b2_0 = np.sqrt(Y1_0)
    c2_0 = np.sqrt(Z1_0)
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    q2_0 = Z1_0 + lam2_0
    below2_0 = c2_0 * q2_0
    term2_0 = 1.0 / below2_0
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    a3_0 = np.sqrt(X2_0)
    b3_0 = np.sqrt(Y2_0)
    c3_0 = np.sqrt(Z2_0)
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    q3_0 = Z2_0 + lam3_0
    below3_0 = c3_0 * q3_0
    term3_0 = 1.0 / below3_0
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    a4_0 = np.sqrt(X3_0)
    b4_0 = np.sqrt(Y3_0)
    c4_0 = np.sqrt(Z3_0)
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    q4_0 = Z3_0 + lam4_0
    below4_0 = c4_0 * q4_0
    term4_0 = 1.0 / below4_0
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    a5_0 = np.sqrt(X4_0)
    b5_0 = np.sqrt(Y4_0)
    c5_0 = np.sqrt(Z4_0)
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    q5_0 = Z4_0 + lam5_0
    below5_0 = c5_0 * q5_0
    term5_0 = 1.0 / below5_0
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    over_0 = 1.0 / mean_0
    dx_0 = over_0 * (-X5_0 + mean_0)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    xy_0 = dx_0 * dy_0
    zz_0 = dz_0 * dz_0
    E2_0 = xy_0 - 6.0 * zz_0
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
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
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    T3 = T * t0
    return (
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A,
    )


def _h_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 305 structured, 305 common subexpressions, 303 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(Y_0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Z0_0 = 0.25 * lam0_0 + 0.25
    a1_0 = np.sqrt(X0_0)
    b1_0 = np.sqrt(Y0_0)
    c1_0 = np.sqrt(Z0_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    q1_0 = Z0_0 + lam1_0
    below1_0 = c1_0 * q1_0
    term1_0 = 1.0 / below1_0
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    a2_0 = np.sqrt(X1_0)
    b2_0 = np.sqrt(Y1_0)
    c2_0 = np.sqrt(Z1_0)
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    q2_0 = Z1_0 + lam2_0
    below2_0 = c2_0 * q2_0
    term2_0 = 1.0 / below2_0
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    a3_0 = np.sqrt(X2_0)
    b3_0 = np.sqrt(Y2_0)
    c3_0 = np.sqrt(Z2_0)
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    q3_0 = Z2_0 + lam3_0
    below3_0 = c3_0 * q3_0
    term3_0 = 1.0 / below3_0
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    a4_0 = np.sqrt(X3_0)
    b4_0 = np.sqrt(Y3_0)
    c4_0 = np.sqrt(Z3_0)
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    q4_0 = Z3_0 + lam4_0
    below4_0 = c4_0 * q4_0
    term4_0 = 1.0 / below4_0
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    a5_0 = np.sqrt(X4_0)
    b5_0 = np.sqrt(Y4_0)
    c5_0 = np.sqrt(Z4_0)
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    q5_0 = Z4_0 + lam5_0
    below5_0 = c5_0 * q5_0
    term5_0 = 1.0 / below5_0
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    over_0 = 1.0 / mean_0
    dx_0 = over_0 * (-X5_0 + mean_0)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    xy_0 = dx_0 * dy_0
    zz_0 = dz_0 * dz_0
    E2_0 = xy_0 - 6.0 * zz_0
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
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
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    T3 = T * t0
    return (
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A,
    )


def h(A, alpha, beta, u_cr):
    """The averaged restoring force h = H - A.

    Equation (20)-(22). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, (u_cr <= 0.75) & (1.05 * u_cr <= A), u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_h_passed_0, _h_passed_0_steep, _h_passed_1_far, _h_passed_1, _h_passed_1_steep_far, _h_passed_1_steep)
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


def _h_A_passed_1_far(A, alpha, beta, u_cr):
    # operations: 496 structured, 496 common subexpressions, 476 power chains
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
    term_1 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1)
    )
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    term_2 = (
        f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0 +
        0.98366812327974718) + 1.0) / (c + delta_2)
    )
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    term_3 = (
        f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 * (0.96002186496830755 * t0 +
        0.96002186496830755) + 1.0) / (c + delta_3)
    )
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    term_4 = (
        f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 +
        0.92620004742927431) + 1.0) / (c + delta_4)
    )
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    term_5 = (
        f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 * (0.88256053579205274 * t0 +
        0.88256053579205274) + 1.0) / (c + delta_5)
    )
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    term_6 = (
        f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 +
        0.82956576238276836) + 1.0) / (c + delta_6)
    )
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    term_7 = (
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7)
    )
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    term_8 = (
        f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585 * t0 +
        0.69785049479331585) + 1.0) / (c + delta_8)
    )
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    term_9 = (
        f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 +
        0.62052618298924289) + 1.0) / (c + delta_9)
    )
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    term_10 = (
        f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0) * (g_10 * (0.53662414814201986 * t0 +
        0.53662414814201986) + 1.0) / (c + delta_10)
    )
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    term_11 = (
        f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 +
        0.44703376953808915) + 1.0) / (c + delta_11)
    )
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    term_12 = (
        f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 * (0.35270472553087812 * t0 +
        0.35270472553087812) + 1.0) / (c + delta_12)
    )
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    term_13 = (
        f_13 * g_13 * (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 +
        0.25463692616788985) + 1.0) / (c + delta_13)
    )
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    term_14 = (
        f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 * t0 +
        0.15386991360858354) + 1.0) / (c + delta_14)
    )
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    term_15 = (
        f_15 * g_15 * (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 +
        0.051471842555317698) + 1.0) / (c + delta_15)
    )
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
    )
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    return (
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c) - 1.0,
    )


def _h_A_passed_1(A, alpha, beta, u_cr):
    # operations: 422 structured, 422 common subexpressions, 417 power chains
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
    fall_1 = f_1 * v2_1 / square_1
    fall_2 = f_2 * v2_2 / square_2
    fall_3 = f_3 * v2_3 / square_3
    fall_4 = f_4 * v2_4 / square_4
    fall_5 = f_5 * v2_5 / square_5
    fall_6 = f_6 * v2_6 / square_6
    fall_7 = f_7 * v2_7 / square_7
    fall_8 = f_8 * v2_8 / square_8
    fall_9 = f_9 * v2_9 / square_9
    fall_10 = f_10 * v2_10 / square_10
    fall_11 = f_11 * v2_11 / square_11
    fall_12 = f_12 * v2_12 / square_12
    fall_13 = f_13 * v2_13 / square_13
    fall_14 = f_14 * v2_14 / square_14
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
        -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr * u_cr / c) - 1.0,
    )


def _h_A_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 682 structured, 682 common subexpressions, 663 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    b0_0 = np.sqrt(Y_0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1 + 0.25
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
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
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
    )
    T3 = T * t0
    return (
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4) - 1.0,
    )


def _h_A_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 558 structured, 558 common subexpressions, 555 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(Y_0)
    b0_half_0 = 0.5 / b0_0
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_0 * b0_half_0 + b0_half_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1 + 0.25
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
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
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    T3 = T * t0
    return (
        -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2) - 1.0,
    )


def h_A(A, alpha, beta, u_cr):
    """d/dA of the averaged restoring force h = H - A.

    Equation (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, (u_cr <= 0.75) & (1.05 * u_cr <= A), u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_h_A_passed_0, _h_A_passed_0_steep, _h_A_passed_1_far, _h_A_passed_1, _h_A_passed_1_steep_far, _h_A_passed_1_steep)
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


def _h_AA_passed_1_far(A, alpha, beta, u_cr):
    # operations: 548 structured, 548 common subexpressions, 525 power chains
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
    term_1 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1)
    )
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    term_2 = (
        f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0 +
        0.98366812327974718) + 1.0) / (c + delta_2)
    )
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    term_3 = (
        f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 * (0.96002186496830755 * t0 +
        0.96002186496830755) + 1.0) / (c + delta_3)
    )
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    term_4 = (
        f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 +
        0.92620004742927431) + 1.0) / (c + delta_4)
    )
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    term_5 = (
        f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 * (0.88256053579205274 * t0 +
        0.88256053579205274) + 1.0) / (c + delta_5)
    )
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    term_6 = (
        f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 +
        0.82956576238276836) + 1.0) / (c + delta_6)
    )
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    term_7 = (
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7)
    )
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    term_8 = (
        f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585 * t0 +
        0.69785049479331585) + 1.0) / (c + delta_8)
    )
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    term_9 = (
        f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 +
        0.62052618298924289) + 1.0) / (c + delta_9)
    )
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    term_10 = (
        f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0) * (g_10 * (0.53662414814201986 * t0 +
        0.53662414814201986) + 1.0) / (c + delta_10)
    )
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    term_11 = (
        f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 +
        0.44703376953808915) + 1.0) / (c + delta_11)
    )
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    term_12 = (
        f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 * (0.35270472553087812 * t0 +
        0.35270472553087812) + 1.0) / (c + delta_12)
    )
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    term_13 = (
        f_13 * g_13 * (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 +
        0.25463692616788985) + 1.0) / (c + delta_13)
    )
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    term_14 = (
        f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 * t0 +
        0.15386991360858354) + 1.0) / (c + delta_14)
    )
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    term_15 = (
        f_15 * g_15 * (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 +
        0.051471842555317698) + 1.0) / (c + delta_15)
    )
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
    )
    sum_2 = (
        tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 * tangent_11 * term_11 +
        tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 * tangent_14 * term_14 +
        tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 * tangent_3 * term_3 +
        tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6 * term_6 + tangent_7
        * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9
    )
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    return (
        2.5464790894703255 * beta * (48.0 * T3 * sum_0 * u_cr2 / c + 56.0 * T3 * sum_1 * u_cr2 / c + 24.0 * T3 *
        sum_2 * u_cr2 / c) / A,
    )


def _h_AA_passed_1(A, alpha, beta, u_cr):
    # operations: 260 structured, 260 common subexpressions, 255 power chains
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
    fall_1 = f_1 * v2_1 / square_1
    fall_2 = f_2 * v2_2 / square_2
    fall_3 = f_3 * v2_3 / square_3
    fall_4 = f_4 * v2_4 / square_4
    fall_5 = f_5 * v2_5 / square_5
    fall_6 = f_6 * v2_6 / square_6
    fall_7 = f_7 * v2_7 / square_7
    fall_8 = f_8 * v2_8 / square_8
    fall_9 = f_9 * v2_9 / square_9
    fall_10 = f_10 * v2_10 / square_10
    fall_11 = f_11 * v2_11 / square_11
    fall_12 = f_12 * v2_12 / square_12
    fall_13 = f_13 * v2_13 / square_13
    fall_14 = f_14 * v2_14 / square_14
    fall_15 = f_15 * v2_15 / square_15
    sum_2 = (
        fall_1 / square_1 + fall_10 / square_10 + fall_11 / square_11 + fall_12 / square_12 + fall_13 / square_13 +
        fall_14 / square_14 + fall_15 / square_15 + fall_2 / square_2 + fall_3 / square_3 + fall_4 / square_4 +
        fall_5 / square_5 + fall_6 / square_6 + fall_7 / square_7 + fall_8 / square_8 + fall_9 / square_9
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
    # operations: 1089 structured, 1089 common subexpressions, 1068 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    a0_half_0_2 = a0_half_0 * a0_half_0
    a0_half_0_3 = a0_half_0 * a0_half_0_2
    a02_0 = -a0_half_0_3
    b0_0 = np.sqrt(Y_0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    lam0_2 = a02_0 * b0_0 + a02_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1 + 0.25
    X0_2 = 0.25 * lam0_2
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1
    Y0_2 = 0.25 * lam0_2
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    Z0_2 = 0.25 * lam0_2
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    lam1_2 = (
        a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 + b1_0) + c1_0 *
        (a12_0 + b12_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    q1_2 = Z0_2 + lam1_2
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    X1_2 = 0.25 * X0_2 + 0.25 * lam1_2
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2
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
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    lam2_2 = (
        a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 + b2_0) + c2_0 *
        (a22_0 + b22_0)
    )
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    X2_2 = 0.25 * X1_2 + 0.25 * lam2_2
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2
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
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    lam3_2 = (
        a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 + b3_0) + c3_0 *
        (a32_0 + b32_0)
    )
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    X3_2 = 0.25 * X2_2 + 0.25 * lam3_2
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2
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
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    lam4_2 = (
        a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 + b4_0) + c4_0 *
        (a42_0 + b42_0)
    )
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    X4_2 = 0.25 * X3_2 + 0.25 * lam4_2
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2
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
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    lam5_2 = (
        a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 + b5_0) + c5_0 *
        (a52_0 + b52_0)
    )
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    X5_2 = 0.25 * X4_2 + 0.25 * lam5_2
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_2 = (
        dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_2 = (
        zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    E5_2 = (
        dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2 * xy_0 * zz_0
    )
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 + 0.10227272727272728 * E2_1 * E2_1 -
        0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 - 0.21428571428571427 * E2_2 +
        0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 * E5_2
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
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
    )
    sum_2 = (
        tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 * tangent_11 * term_11 +
        tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 * tangent_14 * term_14 +
        tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 * tangent_3 * term_3 +
        tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6 * term_6 + tangent_7
        * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9
    )
    T3 = T * t0
    return (
        2.5464790894703255 * beta * (48.0 * T3 * sum_0 / c + 56.0 * T3 * sum_1 / c + 24.0 * T3 * sum_2 / c - 6.0 *
        V2 - 7.0 * V4 - 3.0 * V6) / A,
    )


def _h_AA_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 797 structured, 797 common subexpressions, 792 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    c = np.sqrt((1.0 - u_cr) * (u_cr + 1.0))
    u_cr2 = u_cr * u_cr
    A2 = A * A
    x2 = u_cr2 / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(Y_0)
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
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1
    X0_2 = 0.25 * lam0_2
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1 + 0.25
    Y0_2 = 0.25 * lam0_2
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    Z0_2 = 0.25 * lam0_2
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    lam1_2 = (
        a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 + b1_0) + c1_0 *
        (a12_0 + b12_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    q1_2 = Z0_2 + lam1_2
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    X1_2 = 0.25 * X0_2 + 0.25 * lam1_2
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2
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
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    lam2_2 = (
        a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 + b2_0) + c2_0 *
        (a22_0 + b22_0)
    )
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    X2_2 = 0.25 * X1_2 + 0.25 * lam2_2
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2
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
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    lam3_2 = (
        a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 + b3_0) + c3_0 *
        (a32_0 + b32_0)
    )
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    X3_2 = 0.25 * X2_2 + 0.25 * lam3_2
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2
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
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    lam4_2 = (
        a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 + b4_0) + c4_0 *
        (a42_0 + b42_0)
    )
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    X4_2 = 0.25 * X3_2 + 0.25 * lam4_2
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2
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
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    lam5_2 = (
        a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 + b5_0) + c5_0 *
        (a52_0 + b52_0)
    )
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    X5_2 = 0.25 * X4_2 + 0.25 * lam5_2
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_2 = (
        dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_2 = (
        zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    E5_2 = (
        dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2 * xy_0 * zz_0
    )
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 + 0.10227272727272728 * E2_1 * E2_1 -
        0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 - 0.21428571428571427 * E2_2 +
        0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 * E5_2
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
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, (u_cr <= 0.75) & (1.05 * u_cr <= A), u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_h_AA_passed_0, _h_AA_passed_0_steep, _h_AA_passed_1_far, _h_AA_passed_1, _h_AA_passed_1_steep_far, _h_AA_passed_1_steep)
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


def _h_AAA_passed_1_far(A, alpha, beta, u_cr):
    # operations: 616 structured, 616 common subexpressions, 574 power chains
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
    term_1 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1)
    )
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    term_2 = (
        f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0 +
        0.98366812327974718) + 1.0) / (c + delta_2)
    )
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    term_3 = (
        f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 * (0.96002186496830755 * t0 +
        0.96002186496830755) + 1.0) / (c + delta_3)
    )
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    term_4 = (
        f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 +
        0.92620004742927431) + 1.0) / (c + delta_4)
    )
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    term_5 = (
        f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 * (0.88256053579205274 * t0 +
        0.88256053579205274) + 1.0) / (c + delta_5)
    )
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    term_6 = (
        f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 +
        0.82956576238276836) + 1.0) / (c + delta_6)
    )
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    term_7 = (
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7)
    )
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    term_8 = (
        f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585 * t0 +
        0.69785049479331585) + 1.0) / (c + delta_8)
    )
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    term_9 = (
        f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 +
        0.62052618298924289) + 1.0) / (c + delta_9)
    )
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    term_10 = (
        f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0) * (g_10 * (0.53662414814201986 * t0 +
        0.53662414814201986) + 1.0) / (c + delta_10)
    )
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    term_11 = (
        f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 +
        0.44703376953808915) + 1.0) / (c + delta_11)
    )
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    term_12 = (
        f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 * (0.35270472553087812 * t0 +
        0.35270472553087812) + 1.0) / (c + delta_12)
    )
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    term_13 = (
        f_13 * g_13 * (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 +
        0.25463692616788985) + 1.0) / (c + delta_13)
    )
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    term_14 = (
        f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 * t0 +
        0.15386991360858354) + 1.0) / (c + delta_14)
    )
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    term_15 = (
        f_15 * g_15 * (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 +
        0.051471842555317698) + 1.0) / (c + delta_15)
    )
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
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
    sum_2 = (
        tangent_10_2 * term_10 + tangent_11_2 * term_11 + tangent_12_2 * term_12 + tangent_13_2 * term_13 +
        tangent_14_2 * term_14 + tangent_15_2 * term_15 + tangent_1_2 * term_1 + tangent_2_2 * term_2 + tangent_3_2
        * term_3 + tangent_4_2 * term_4 + tangent_5_2 * term_5 + tangent_6_2 * term_6 + tangent_7_2 * term_7 +
        tangent_8_2 * term_8 + tangent_9_2 * term_9
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
    sum_3 = (
        tangent_10_3 * term_10 + tangent_11_3 * term_11 + tangent_12_3 * term_12 + tangent_13_3 * term_13 +
        tangent_14_3 * term_14 + tangent_15_3 * term_15 + tangent_1_3 * term_1 + tangent_2_3 * term_2 + tangent_3_3
        * term_3 + tangent_4_3 * term_4 + tangent_5_3 * term_5 + tangent_6_3 * term_6 + tangent_7_3 * term_7 +
        tangent_8_3 * term_8 + tangent_9_3 * term_9
    )
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    return (
        2.5464790894703255 * beta * (-192.0 * T3 * sum_0 * u_cr2 / c - 384.0 * T3 * sum_1 * u_cr2 / c - 360.0 * T3 *
        sum_2 * u_cr2 / c - 120.0 * T3 * sum_3 * u_cr2 / c) / A2,
    )


def _h_AAA_passed_1(A, alpha, beta, u_cr):
    # operations: 365 structured, 365 common subexpressions, 343 power chains
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
    fall_1 = f_1 * v2_1 / square_1
    fall_2 = f_2 * v2_2 / square_2
    fall_3 = f_3 * v2_3 / square_3
    fall_4 = f_4 * v2_4 / square_4
    fall_5 = f_5 * v2_5 / square_5
    fall_6 = f_6 * v2_6 / square_6
    fall_7 = f_7 * v2_7 / square_7
    fall_8 = f_8 * v2_8 / square_8
    fall_9 = f_9 * v2_9 / square_9
    fall_10 = f_10 * v2_10 / square_10
    fall_11 = f_11 * v2_11 / square_11
    fall_12 = f_12 * v2_12 / square_12
    fall_13 = f_13 * v2_13 / square_13
    fall_14 = f_14 * v2_14 / square_14
    fall_15 = f_15 * v2_15 / square_15
    sum_3 = (
        fall_1 * (4.0 * U2 * v2_1 + 1.0) / (square_1 * square_1) + fall_10 * (4.0 * U2 * v2_10 + 1.0) / (square_10 *
        square_10) + fall_11 * (4.0 * U2 * v2_11 + 1.0) / (square_11 * square_11) + fall_12 * (4.0 * U2 * v2_12 +
        1.0) / (square_12 * square_12) + fall_13 * (4.0 * U2 * v2_13 + 1.0) / (square_13 * square_13) + fall_14 *
        (4.0 * U2 * v2_14 + 1.0) / (square_14 * square_14) + fall_15 * (4.0 * U2 * v2_15 + 1.0) / (square_15 *
        square_15) + fall_2 * (4.0 * U2 * v2_2 + 1.0) / (square_2 * square_2) + fall_3 * (4.0 * U2 * v2_3 + 1.0) /
        (square_3 * square_3) + fall_4 * (4.0 * U2 * v2_4 + 1.0) / (square_4 * square_4) + fall_5 * (4.0 * U2 * v2_5
        + 1.0) / (square_5 * square_5) + fall_6 * (4.0 * U2 * v2_6 + 1.0) / (square_6 * square_6) + fall_7 * (4.0 *
        U2 * v2_7 + 1.0) / (square_7 * square_7) + fall_8 * (4.0 * U2 * v2_8 + 1.0) / (square_8 * square_8) + fall_9
        * (4.0 * U2 * v2_9 + 1.0) / (square_9 * square_9)
    )
    T4 = t0 * t0
    T5 = T * T4
    u_cr2 = u_cr * u_cr
    u_cr4 = u_cr2 * u_cr2
    u_cr5 = u_cr * u_cr4
    root2 = root * root
    root3 = root * root2
    c2 = c * c
    c3 = c * c2
    A4 = A2 * A2
    c4 = c2 * c2
    c5 = c * c4
    return (
        -2.5464790894703255 * beta * (96.0 * T5 * sum_3 - 3.0 * u_cr5 / (A4 * c5 * root) + 3.0 * u_cr5 / (A4 * c3 *
        root) + u_cr5 / (A2 * c3 * root3)),
    )


def _h_AAA_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 1613 structured, 1613 common subexpressions, 1572 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    a0_half_0_2 = a0_half_0 * a0_half_0
    a0_half_0_3 = a0_half_0 * a0_half_0_2
    a02_0 = -a0_half_0_3
    a03_0 = -2.0 * a02_0 * a0_half_0_2
    b0_0 = np.sqrt(Y_0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    lam0_2 = a02_0 * b0_0 + a02_0
    lam0_3 = a03_0 * b0_0 + a03_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    term03_0 = -term0_0 * (lam0_1 * term02_0 + lam0_2 * term01_0 + lam0_3 * term0_0)
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1 + 0.25
    X0_2 = 0.25 * lam0_2
    X0_3 = 0.25 * lam0_3
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1
    Y0_2 = 0.25 * lam0_2
    Y0_3 = 0.25 * lam0_3
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    Z0_2 = 0.25 * lam0_2
    Z0_3 = 0.25 * lam0_3
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0)
    a13_0 = a1_half_0 * (X0_3 - 2.0 * a11_0 * a12_0)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0)
    b13_0 = b1_half_0 * (Y0_3 - 2.0 * b11_0 * b12_0)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0)
    c13_0 = c1_half_0 * (Z0_3 - 2.0 * c11_0 * c12_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    lam1_2 = (
        a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 + b1_0) + c1_0 *
        (a12_0 + b12_0)
    )
    lam1_3 = (
        a11_0 * b12_0 + a12_0 * b11_0 + a13_0 * b1_0 + a1_0 * b13_0 + c11_0 * (a12_0 + b12_0) + c12_0 * (a11_0 +
        b11_0) + c13_0 * (a1_0 + b1_0) + c1_0 * (a13_0 + b13_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    q1_2 = Z0_2 + lam1_2
    q1_3 = Z0_3 + lam1_3
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    below1_3 = c11_0 * q1_2 + c12_0 * q1_1 + c13_0 * q1_0 + c1_0 * q1_3
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    term13_0 = -term1_0 * (below1_1 * term12_0 + below1_2 * term11_0 + below1_3 * term1_0)
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    X1_2 = 0.25 * X0_2 + 0.25 * lam1_2
    X1_3 = 0.25 * X0_3 + 0.25 * lam1_3
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2
    Y1_3 = 0.25 * Y0_3 + 0.25 * lam1_3
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2
    Z1_3 = 0.25 * Z0_3 + 0.25 * lam1_3
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
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    lam2_2 = (
        a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 + b2_0) + c2_0 *
        (a22_0 + b22_0)
    )
    lam2_3 = (
        a21_0 * b22_0 + a22_0 * b21_0 + a23_0 * b2_0 + a2_0 * b23_0 + c21_0 * (a22_0 + b22_0) + c22_0 * (a21_0 +
        b21_0) + c23_0 * (a2_0 + b2_0) + c2_0 * (a23_0 + b23_0)
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
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    X2_2 = 0.25 * X1_2 + 0.25 * lam2_2
    X2_3 = 0.25 * X1_3 + 0.25 * lam2_3
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2
    Y2_3 = 0.25 * Y1_3 + 0.25 * lam2_3
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2
    Z2_3 = 0.25 * Z1_3 + 0.25 * lam2_3
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
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    lam3_2 = (
        a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 + b3_0) + c3_0 *
        (a32_0 + b32_0)
    )
    lam3_3 = (
        a31_0 * b32_0 + a32_0 * b31_0 + a33_0 * b3_0 + a3_0 * b33_0 + c31_0 * (a32_0 + b32_0) + c32_0 * (a31_0 +
        b31_0) + c33_0 * (a3_0 + b3_0) + c3_0 * (a33_0 + b33_0)
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
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    X3_2 = 0.25 * X2_2 + 0.25 * lam3_2
    X3_3 = 0.25 * X2_3 + 0.25 * lam3_3
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2
    Y3_3 = 0.25 * Y2_3 + 0.25 * lam3_3
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2
    Z3_3 = 0.25 * Z2_3 + 0.25 * lam3_3
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
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    lam4_2 = (
        a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 + b4_0) + c4_0 *
        (a42_0 + b42_0)
    )
    lam4_3 = (
        a41_0 * b42_0 + a42_0 * b41_0 + a43_0 * b4_0 + a4_0 * b43_0 + c41_0 * (a42_0 + b42_0) + c42_0 * (a41_0 +
        b41_0) + c43_0 * (a4_0 + b4_0) + c4_0 * (a43_0 + b43_0)
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
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    X4_2 = 0.25 * X3_2 + 0.25 * lam4_2
    X4_3 = 0.25 * X3_3 + 0.25 * lam4_3
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2
    Y4_3 = 0.25 * Y3_3 + 0.25 * lam4_3
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2
    Z4_3 = 0.25 * Z3_3 + 0.25 * lam4_3
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
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    lam5_2 = (
        a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 + b5_0) + c5_0 *
        (a52_0 + b52_0)
    )
    lam5_3 = (
        a51_0 * b52_0 + a52_0 * b51_0 + a53_0 * b5_0 + a5_0 * b53_0 + c51_0 * (a52_0 + b52_0) + c52_0 * (a51_0 +
        b51_0) + c53_0 * (a5_0 + b5_0) + c5_0 * (a53_0 + b53_0)
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
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    X5_2 = 0.25 * X4_2 + 0.25 * lam5_2
    X5_3 = 0.25 * X4_3 + 0.25 * lam5_3
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2
    Y5_3 = 0.25 * Y4_3 + 0.25 * lam5_3
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2
    Z5_3 = 0.25 * Z4_3 + 0.25 * lam5_3
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    mean_3 = 0.20000000000000001 * X5_3 + 0.20000000000000001 * Y5_3 + 0.59999999999999998 * Z5_3
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    over3_0 = -over_0 * (mean_1 * over2_0 + mean_2 * over1_0 + mean_3 * over_0)
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2)
    dx_3 = (
        over1_0 * (-X5_2 + mean_2) + over2_0 * (-X5_1 + mean_1) + over3_0 * (-X5_0 + mean_0) + over_0 * (-X5_3 +
        mean_3)
    )
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2)
    dy_3 = (
        over1_0 * (-Y5_2 + mean_2) + over2_0 * (-Y5_1 + mean_1) + over3_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_3 +
        mean_3)
    )
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    dz_3 = -0.33333333333333331 * dx_3 - 0.33333333333333331 * dy_3
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    xy_3 = dx_0 * dy_3 + dx_1 * dy_2 + dx_2 * dy_1 + dx_3 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1
    zz_3 = 2.0 * dz_0 * dz_3 + 2.0 * dz_1 * dz_2
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E2_3 = xy_3 - 6.0 * zz_3
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_2 = (
        dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E3_3 = (
        dz_0 * (3.0 * xy_3 - 8.0 * zz_3) + dz_1 * (3.0 * xy_2 - 8.0 * zz_2) + dz_2 * (3.0 * xy_1 - 8.0 * zz_1) +
        dz_3 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_2 = (
        zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E4_3 = (
        zz_0 * (3.0 * xy_3 - 3.0 * zz_3) + zz_1 * (3.0 * xy_2 - 3.0 * zz_2) + zz_2 * (3.0 * xy_1 - 3.0 * zz_1) +
        zz_3 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    E5_2 = (
        dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2 * xy_0 * zz_0
    )
    E5_3 = (
        dz_0 * (xy_0 * zz_3 + xy_1 * zz_2 + xy_2 * zz_1 + xy_3 * zz_0) + dz_1 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 *
        zz_0) + dz_2 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_3 * xy_0 * zz_0
    )
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 + 0.10227272727272728 * E2_1 * E2_1 -
        0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 - 0.21428571428571427 * E2_2 +
        0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 * E5_2
    )
    series_3 = (
        0.20454545454545456 * E2_0 * E2_3 - 0.17307692307692307 * E2_0 * E3_3 + 0.20454545454545456 * E2_1 * E2_2 -
        0.17307692307692307 * E2_1 * E3_2 - 0.17307692307692307 * E2_2 * E3_1 - 0.17307692307692307 * E2_3 * E3_0 -
        0.21428571428571427 * E2_3 + 0.16666666666666666 * E3_3 - 0.13636363636363635 * E4_3 + 0.11538461538461539 *
        E5_3
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
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
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
    sum_2 = (
        tangent_10_2 * term_10 + tangent_11_2 * term_11 + tangent_12_2 * term_12 + tangent_13_2 * term_13 +
        tangent_14_2 * term_14 + tangent_15_2 * term_15 + tangent_1_2 * term_1 + tangent_2_2 * term_2 + tangent_3_2
        * term_3 + tangent_4_2 * term_4 + tangent_5_2 * term_5 + tangent_6_2 * term_6 + tangent_7_2 * term_7 +
        tangent_8_2 * term_8 + tangent_9_2 * term_9
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
    sum_3 = (
        tangent_10_3 * term_10 + tangent_11_3 * term_11 + tangent_12_3 * term_12 + tangent_13_3 * term_13 +
        tangent_14_3 * term_14 + tangent_15_3 * term_15 + tangent_1_3 * term_1 + tangent_2_3 * term_2 + tangent_3_3
        * term_3 + tangent_4_3 * term_4 + tangent_5_3 * term_5 + tangent_6_3 * term_6 + tangent_7_3 * term_7 +
        tangent_8_3 * term_8 + tangent_9_3 * term_9
    )
    T3 = T * t0
    return (
        2.5464790894703255 * beta * (-192.0 * T3 * sum_0 / c - 384.0 * T3 * sum_1 / c - 360.0 * T3 * sum_2 / c -
        120.0 * T3 * sum_3 / c + 24.0 * V2 + 48.0 * V4 + 45.0 * V6 + 15.0 * V8) / A2,
    )


def _h_AAA_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 1289 structured, 1289 common subexpressions, 1263 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    c = np.sqrt((1.0 - u_cr) * (u_cr + 1.0))
    u_cr2 = u_cr * u_cr
    A2 = A * A
    x2 = u_cr2 / A2
    root2 = root * root
    y2 = root2 / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(Y_0)
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
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1
    X0_2 = 0.25 * lam0_2
    X0_3 = 0.25 * lam0_3
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1 + 0.25
    Y0_2 = 0.25 * lam0_2
    Y0_3 = 0.25 * lam0_3
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    Z0_2 = 0.25 * lam0_2
    Z0_3 = 0.25 * lam0_3
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0)
    a13_0 = a1_half_0 * (X0_3 - 2.0 * a11_0 * a12_0)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0)
    b13_0 = b1_half_0 * (Y0_3 - 2.0 * b11_0 * b12_0)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0)
    c13_0 = c1_half_0 * (Z0_3 - 2.0 * c11_0 * c12_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    lam1_2 = (
        a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 + b1_0) + c1_0 *
        (a12_0 + b12_0)
    )
    lam1_3 = (
        a11_0 * b12_0 + a12_0 * b11_0 + a13_0 * b1_0 + a1_0 * b13_0 + c11_0 * (a12_0 + b12_0) + c12_0 * (a11_0 +
        b11_0) + c13_0 * (a1_0 + b1_0) + c1_0 * (a13_0 + b13_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    q1_2 = Z0_2 + lam1_2
    q1_3 = Z0_3 + lam1_3
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    below1_3 = c11_0 * q1_2 + c12_0 * q1_1 + c13_0 * q1_0 + c1_0 * q1_3
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    term13_0 = -term1_0 * (below1_1 * term12_0 + below1_2 * term11_0 + below1_3 * term1_0)
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    X1_2 = 0.25 * X0_2 + 0.25 * lam1_2
    X1_3 = 0.25 * X0_3 + 0.25 * lam1_3
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2
    Y1_3 = 0.25 * Y0_3 + 0.25 * lam1_3
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2
    Z1_3 = 0.25 * Z0_3 + 0.25 * lam1_3
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
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    lam2_2 = (
        a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 + b2_0) + c2_0 *
        (a22_0 + b22_0)
    )
    lam2_3 = (
        a21_0 * b22_0 + a22_0 * b21_0 + a23_0 * b2_0 + a2_0 * b23_0 + c21_0 * (a22_0 + b22_0) + c22_0 * (a21_0 +
        b21_0) + c23_0 * (a2_0 + b2_0) + c2_0 * (a23_0 + b23_0)
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
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    X2_2 = 0.25 * X1_2 + 0.25 * lam2_2
    X2_3 = 0.25 * X1_3 + 0.25 * lam2_3
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2
    Y2_3 = 0.25 * Y1_3 + 0.25 * lam2_3
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2
    Z2_3 = 0.25 * Z1_3 + 0.25 * lam2_3
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
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    lam3_2 = (
        a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 + b3_0) + c3_0 *
        (a32_0 + b32_0)
    )
    lam3_3 = (
        a31_0 * b32_0 + a32_0 * b31_0 + a33_0 * b3_0 + a3_0 * b33_0 + c31_0 * (a32_0 + b32_0) + c32_0 * (a31_0 +
        b31_0) + c33_0 * (a3_0 + b3_0) + c3_0 * (a33_0 + b33_0)
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
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    X3_2 = 0.25 * X2_2 + 0.25 * lam3_2
    X3_3 = 0.25 * X2_3 + 0.25 * lam3_3
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2
    Y3_3 = 0.25 * Y2_3 + 0.25 * lam3_3
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2
    Z3_3 = 0.25 * Z2_3 + 0.25 * lam3_3
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
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    lam4_2 = (
        a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 + b4_0) + c4_0 *
        (a42_0 + b42_0)
    )
    lam4_3 = (
        a41_0 * b42_0 + a42_0 * b41_0 + a43_0 * b4_0 + a4_0 * b43_0 + c41_0 * (a42_0 + b42_0) + c42_0 * (a41_0 +
        b41_0) + c43_0 * (a4_0 + b4_0) + c4_0 * (a43_0 + b43_0)
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
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    X4_2 = 0.25 * X3_2 + 0.25 * lam4_2
    X4_3 = 0.25 * X3_3 + 0.25 * lam4_3
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2
    Y4_3 = 0.25 * Y3_3 + 0.25 * lam4_3
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2
    Z4_3 = 0.25 * Z3_3 + 0.25 * lam4_3
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
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    lam5_2 = (
        a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 + b5_0) + c5_0 *
        (a52_0 + b52_0)
    )
    lam5_3 = (
        a51_0 * b52_0 + a52_0 * b51_0 + a53_0 * b5_0 + a5_0 * b53_0 + c51_0 * (a52_0 + b52_0) + c52_0 * (a51_0 +
        b51_0) + c53_0 * (a5_0 + b5_0) + c5_0 * (a53_0 + b53_0)
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
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    X5_2 = 0.25 * X4_2 + 0.25 * lam5_2
    X5_3 = 0.25 * X4_3 + 0.25 * lam5_3
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2
    Y5_3 = 0.25 * Y4_3 + 0.25 * lam5_3
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2
    Z5_3 = 0.25 * Z4_3 + 0.25 * lam5_3
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    mean_3 = 0.20000000000000001 * X5_3 + 0.20000000000000001 * Y5_3 + 0.59999999999999998 * Z5_3
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    over3_0 = -over_0 * (mean_1 * over2_0 + mean_2 * over1_0 + mean_3 * over_0)
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2)
    dx_3 = (
        over1_0 * (-X5_2 + mean_2) + over2_0 * (-X5_1 + mean_1) + over3_0 * (-X5_0 + mean_0) + over_0 * (-X5_3 +
        mean_3)
    )
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2)
    dy_3 = (
        over1_0 * (-Y5_2 + mean_2) + over2_0 * (-Y5_1 + mean_1) + over3_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_3 +
        mean_3)
    )
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    dz_3 = -0.33333333333333331 * dx_3 - 0.33333333333333331 * dy_3
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    xy_3 = dx_0 * dy_3 + dx_1 * dy_2 + dx_2 * dy_1 + dx_3 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1
    zz_3 = 2.0 * dz_0 * dz_3 + 2.0 * dz_1 * dz_2
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E2_3 = xy_3 - 6.0 * zz_3
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_2 = (
        dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E3_3 = (
        dz_0 * (3.0 * xy_3 - 8.0 * zz_3) + dz_1 * (3.0 * xy_2 - 8.0 * zz_2) + dz_2 * (3.0 * xy_1 - 8.0 * zz_1) +
        dz_3 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_2 = (
        zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E4_3 = (
        zz_0 * (3.0 * xy_3 - 3.0 * zz_3) + zz_1 * (3.0 * xy_2 - 3.0 * zz_2) + zz_2 * (3.0 * xy_1 - 3.0 * zz_1) +
        zz_3 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    E5_2 = (
        dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2 * xy_0 * zz_0
    )
    E5_3 = (
        dz_0 * (xy_0 * zz_3 + xy_1 * zz_2 + xy_2 * zz_1 + xy_3 * zz_0) + dz_1 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 *
        zz_0) + dz_2 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_3 * xy_0 * zz_0
    )
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 + 0.10227272727272728 * E2_1 * E2_1 -
        0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 - 0.21428571428571427 * E2_2 +
        0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 * E5_2
    )
    series_3 = (
        0.20454545454545456 * E2_0 * E2_3 - 0.17307692307692307 * E2_0 * E3_3 + 0.20454545454545456 * E2_1 * E2_2 -
        0.17307692307692307 * E2_1 * E3_2 - 0.17307692307692307 * E2_2 * E3_1 - 0.17307692307692307 * E2_3 * E3_0 -
        0.21428571428571427 * E2_3 + 0.16666666666666666 * E3_3 - 0.13636363636363635 * E4_3 + 0.11538461538461539 *
        E5_3
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
    root3 = root * root2
    c2 = c * c
    c3 = c * c2
    A4 = A2 * A2
    c4 = c2 * c2
    c5 = c * c4
    return (
        -2.5464790894703255 * beta * (3.0 * A2 * (5.0 * A2 * V8 + 6.0 * V6) + 3.0 * V4 - 3.0 * u_cr5 / (A4 * c5 *
        root) + 3.0 * u_cr5 / (A4 * c3 * root) + u_cr5 / (A2 * c3 * root3)),
    )


def h_AAA(A, alpha, beta, u_cr):
    """d3/dA3 of the averaged restoring force h = H - A.

    Equation from (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, (u_cr <= 0.75) & (1.05 * u_cr <= A), u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_h_AAA_passed_0, _h_AAA_passed_0_steep, _h_AAA_passed_1_far, _h_AAA_passed_1, _h_AAA_passed_1_steep_far, _h_AAA_passed_1_steep)
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


def _H_passed_1_far(A, alpha, beta, u_cr):
    # operations: 368 structured, 368 common subexpressions, 366 power chains
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
    term_1 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1)
    )
    term_2 = (
        f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0 +
        0.98366812327974718) + 1.0) / (c + delta_2)
    )
    term_3 = (
        f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 * (0.96002186496830755 * t0 +
        0.96002186496830755) + 1.0) / (c + delta_3)
    )
    term_4 = (
        f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 +
        0.92620004742927431) + 1.0) / (c + delta_4)
    )
    term_5 = (
        f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 * (0.88256053579205274 * t0 +
        0.88256053579205274) + 1.0) / (c + delta_5)
    )
    term_6 = (
        f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 +
        0.82956576238276836) + 1.0) / (c + delta_6)
    )
    term_7 = (
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7)
    )
    term_8 = (
        f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585 * t0 +
        0.69785049479331585) + 1.0) / (c + delta_8)
    )
    term_9 = (
        f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 +
        0.62052618298924289) + 1.0) / (c + delta_9)
    )
    term_10 = (
        f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0) * (g_10 * (0.53662414814201986 * t0 +
        0.53662414814201986) + 1.0) / (c + delta_10)
    )
    term_11 = (
        f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 +
        0.44703376953808915) + 1.0) / (c + delta_11)
    )
    term_12 = (
        f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 * (0.35270472553087812 * t0 +
        0.35270472553087812) + 1.0) / (c + delta_12)
    )
    term_13 = (
        f_13 * g_13 * (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 +
        0.25463692616788985) + 1.0) / (c + delta_13)
    )
    term_14 = (
        f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 * t0 +
        0.15386991360858354) + 1.0) / (c + delta_14)
    )
    term_15 = (
        f_15 * g_15 * (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 +
        0.051471842555317698) + 1.0) / (c + delta_15)
    )
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    T3 = T * t0
    return (
        20.371832715762604 * A * T3 * beta * sum_0 * u_cr * u_cr / c,
    )


def _H_passed_1(A, alpha, beta, u_cr):
    # operations: 368 structured, 368 common subexpressions, 366 power chains
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
    # operations: 304 structured, 304 common subexpressions, 302 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(Y_0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Z0_0 = 0.25 * lam0_0 + 0.25
    a1_0 = np.sqrt(X0_0)
    b1_0 = np.sqrt(Y0_0)
    c1_0 = np.sqrt(Z0_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    q1_0 = Z0_0 + lam1_0
    below1_0 = c1_0 * q1_0
    term1_0 = 1.0 / below1_0
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    a2_0 = np.sqrt(X1_0)
    b2_0 = np.sqrt(Y1_0)
    c2_0 = np.sqrt(Z1_0)
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    q2_0 = Z1_0 + lam2_0
    below2_0 = c2_0 * q2_0
    term2_0 = 1.0 / below2_0
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    a3_0 = np.sqrt(X2_0)
    b3_0 = np.sqrt(Y2_0)
    c3_0 = np.sqrt(Z2_0)
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    q3_0 = Z2_0 + lam3_0
    below3_0 = c3_0 * q3_0
    term3_0 = 1.0 / below3_0
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    a4_0 = np.sqrt(X3_0)
    b4_0 = np.sqrt(Y3_0)
    c4_0 = np.sqrt(Z3_0)
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    q4_0 = Z3_0 + lam4_0
    below4_0 = c4_0 * q4_0
    term4_0 = 1.0 / below4_0
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    a5_0 = np.sqrt(X4_0)
    b5_0 = np.sqrt(Y4_0)
    c5_0 = np.sqrt(Z4_0)
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    q5_0 = Z4_0 + lam5_0
    below5_0 = c5_0 * q5_0
    term5_0 = 1.0 / below5_0
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    over_0 = 1.0 / mean_0
    dx_0 = over_0 * (-X5_0 + mean_0)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    xy_0 = dx_0 * dy_0
    zz_0 = dz_0 * dz_0
    E2_0 = xy_0 - 6.0 * zz_0
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
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
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    T3 = T * t0
    return (
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2),
    )


def _H_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 304 structured, 304 common subexpressions, 302 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(Y_0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Z0_0 = 0.25 * lam0_0 + 0.25
    a1_0 = np.sqrt(X0_0)
    b1_0 = np.sqrt(Y0_0)
    c1_0 = np.sqrt(Z0_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    q1_0 = Z0_0 + lam1_0
    below1_0 = c1_0 * q1_0
    term1_0 = 1.0 / below1_0
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    a2_0 = np.sqrt(X1_0)
    b2_0 = np.sqrt(Y1_0)
    c2_0 = np.sqrt(Z1_0)
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    q2_0 = Z1_0 + lam2_0
    below2_0 = c2_0 * q2_0
    term2_0 = 1.0 / below2_0
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    a3_0 = np.sqrt(X2_0)
    b3_0 = np.sqrt(Y2_0)
    c3_0 = np.sqrt(Z2_0)
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    q3_0 = Z2_0 + lam3_0
    below3_0 = c3_0 * q3_0
    term3_0 = 1.0 / below3_0
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    a4_0 = np.sqrt(X3_0)
    b4_0 = np.sqrt(Y3_0)
    c4_0 = np.sqrt(Z3_0)
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    q4_0 = Z3_0 + lam4_0
    below4_0 = c4_0 * q4_0
    term4_0 = 1.0 / below4_0
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    a5_0 = np.sqrt(X4_0)
    b5_0 = np.sqrt(Y4_0)
    c5_0 = np.sqrt(Z4_0)
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    q5_0 = Z4_0 + lam5_0
    below5_0 = c5_0 * q5_0
    term5_0 = 1.0 / below5_0
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    over_0 = 1.0 / mean_0
    dx_0 = over_0 * (-X5_0 + mean_0)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    xy_0 = dx_0 * dy_0
    zz_0 = dz_0 * dz_0
    E2_0 = xy_0 - 6.0 * zz_0
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
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
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    T3 = T * t0
    return (
        2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2),
    )


def H(A, alpha, beta, u_cr):
    """The averaged force H beside the vertical spring.

    Equation (20)-(22). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, (u_cr <= 0.75) & (1.05 * u_cr <= A), u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_H_passed_0, _H_passed_0_steep, _H_passed_1_far, _H_passed_1, _H_passed_1_steep_far, _H_passed_1_steep)
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


def _H_A_passed_1_far(A, alpha, beta, u_cr):
    # operations: 495 structured, 495 common subexpressions, 475 power chains
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
    term_1 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1)
    )
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    term_2 = (
        f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0 +
        0.98366812327974718) + 1.0) / (c + delta_2)
    )
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    term_3 = (
        f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 * (0.96002186496830755 * t0 +
        0.96002186496830755) + 1.0) / (c + delta_3)
    )
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    term_4 = (
        f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 +
        0.92620004742927431) + 1.0) / (c + delta_4)
    )
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    term_5 = (
        f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 * (0.88256053579205274 * t0 +
        0.88256053579205274) + 1.0) / (c + delta_5)
    )
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    term_6 = (
        f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 +
        0.82956576238276836) + 1.0) / (c + delta_6)
    )
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    term_7 = (
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7)
    )
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    term_8 = (
        f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585 * t0 +
        0.69785049479331585) + 1.0) / (c + delta_8)
    )
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    term_9 = (
        f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 +
        0.62052618298924289) + 1.0) / (c + delta_9)
    )
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    term_10 = (
        f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0) * (g_10 * (0.53662414814201986 * t0 +
        0.53662414814201986) + 1.0) / (c + delta_10)
    )
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    term_11 = (
        f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 +
        0.44703376953808915) + 1.0) / (c + delta_11)
    )
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    term_12 = (
        f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 * (0.35270472553087812 * t0 +
        0.35270472553087812) + 1.0) / (c + delta_12)
    )
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    term_13 = (
        f_13 * g_13 * (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 +
        0.25463692616788985) + 1.0) / (c + delta_13)
    )
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    term_14 = (
        f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 * t0 +
        0.15386991360858354) + 1.0) / (c + delta_14)
    )
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    term_15 = (
        f_15 * g_15 * (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 +
        0.051471842555317698) + 1.0) / (c + delta_15)
    )
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
    )
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    return (
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c),
    )


def _H_A_passed_1(A, alpha, beta, u_cr):
    # operations: 421 structured, 421 common subexpressions, 416 power chains
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
    fall_1 = f_1 * v2_1 / square_1
    fall_2 = f_2 * v2_2 / square_2
    fall_3 = f_3 * v2_3 / square_3
    fall_4 = f_4 * v2_4 / square_4
    fall_5 = f_5 * v2_5 / square_5
    fall_6 = f_6 * v2_6 / square_6
    fall_7 = f_7 * v2_7 / square_7
    fall_8 = f_8 * v2_8 / square_8
    fall_9 = f_9 * v2_9 / square_9
    fall_10 = f_10 * v2_10 / square_10
    fall_11 = f_11 * v2_11 / square_11
    fall_12 = f_12 * v2_12 / square_12
    fall_13 = f_13 * v2_13 / square_13
    fall_14 = f_14 * v2_14 / square_14
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
        -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr * u_cr / c),
    )


def _H_A_passed_1_steep_far(A, alpha, beta, u_cr):
    # operations: 681 structured, 681 common subexpressions, 662 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    b0_0 = np.sqrt(Y_0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1 + 0.25
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
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
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
    )
    T3 = T * t0
    return (
        2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4),
    )


def _H_A_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 557 structured, 557 common subexpressions, 554 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(Y_0)
    b0_half_0 = 0.5 / b0_0
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_0 * b0_half_0 + b0_half_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1 + 0.25
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    a2_0 = np.sqrt(X1_0)
    a2_half_0 = 0.5 / a2_0
    a21_0 = X1_1 * a2_half_0
    b2_0 = np.sqrt(Y1_0)
    b2_half_0 = 0.5 / b2_0
    b21_0 = Y1_1 * b2_half_0
    c2_0 = np.sqrt(Z1_0)
    c2_half_0 = 0.5 / c2_0
    c21_0 = Z1_1 * c2_half_0
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    a3_0 = np.sqrt(X2_0)
    a3_half_0 = 0.5 / a3_0
    a31_0 = X2_1 * a3_half_0
    b3_0 = np.sqrt(Y2_0)
    b3_half_0 = 0.5 / b3_0
    b31_0 = Y2_1 * b3_half_0
    c3_0 = np.sqrt(Z2_0)
    c3_half_0 = 0.5 / c3_0
    c31_0 = Z2_1 * c3_half_0
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    a4_0 = np.sqrt(X3_0)
    a4_half_0 = 0.5 / a4_0
    a41_0 = X3_1 * a4_half_0
    b4_0 = np.sqrt(Y3_0)
    b4_half_0 = 0.5 / b4_0
    b41_0 = Y3_1 * b4_half_0
    c4_0 = np.sqrt(Z3_0)
    c4_half_0 = 0.5 / c4_0
    c41_0 = Z3_1 * c4_half_0
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    a5_0 = np.sqrt(X4_0)
    a5_half_0 = 0.5 / a5_0
    a51_0 = X4_1 * a5_half_0
    b5_0 = np.sqrt(Y4_0)
    b5_half_0 = 0.5 / b5_0
    b51_0 = Y4_1 * b5_half_0
    c5_0 = np.sqrt(Z4_0)
    c5_half_0 = 0.5 / c5_0
    c51_0 = Z4_1 * c5_half_0
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
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
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    T3 = T * t0
    return (
        -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2),
    )


def H_A(A, alpha, beta, u_cr):
    """d/dA of the averaged force H beside the vertical spring.

    Equation (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta, u_cr)
    A, alpha, beta, u_cr = arguments
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, (u_cr <= 0.75) & (1.05 * u_cr <= A), u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_H_A_passed_0, _H_A_passed_0_steep, _H_A_passed_1_far, _H_A_passed_1, _H_A_passed_1_steep_far, _H_A_passed_1_steep)
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


def _H_AA_passed_1_far(A, alpha, beta, u_cr):
    # operations: 548 structured, 548 common subexpressions, 525 power chains
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
    term_1 = (
        f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 * (0.99689348407464951 * t0 +
        0.99689348407464951) + 1.0) / (c + delta_1)
    )
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    term_2 = (
        f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 * (0.98366812327974718 * t0 +
        0.98366812327974718) + 1.0) / (c + delta_2)
    )
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    term_3 = (
        f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 * (0.96002186496830755 * t0 +
        0.96002186496830755) + 1.0) / (c + delta_3)
    )
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    term_4 = (
        f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 * (0.92620004742927431 * t0 +
        0.92620004742927431) + 1.0) / (c + delta_4)
    )
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    term_5 = (
        f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 * (0.88256053579205274 * t0 +
        0.88256053579205274) + 1.0) / (c + delta_5)
    )
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    term_6 = (
        f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 +
        0.82956576238276836) + 1.0) / (c + delta_6)
    )
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    term_7 = (
        f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619 * t0 +
        0.76777743210482619) + 1.0) / (c + delta_7)
    )
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    term_8 = (
        f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585 * t0 +
        0.69785049479331585) + 1.0) / (c + delta_8)
    )
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    term_9 = (
        f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289 * t0 +
        0.62052618298924289) + 1.0) / (c + delta_9)
    )
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    term_10 = (
        f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0) * (g_10 * (0.53662414814201986 * t0 +
        0.53662414814201986) + 1.0) / (c + delta_10)
    )
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    term_11 = (
        f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 * t0 +
        0.44703376953808915) + 1.0) / (c + delta_11)
    )
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    term_12 = (
        f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 * (0.35270472553087812 * t0 +
        0.35270472553087812) + 1.0) / (c + delta_12)
    )
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    term_13 = (
        f_13 * g_13 * (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 +
        0.25463692616788985) + 1.0) / (c + delta_13)
    )
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    term_14 = (
        f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 * (0.15386991360858354 * t0 +
        0.15386991360858354) + 1.0) / (c + delta_14)
    )
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    term_15 = (
        f_15 * g_15 * (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 +
        0.051471842555317698) + 1.0) / (c + delta_15)
    )
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
    )
    sum_2 = (
        tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 * tangent_11 * term_11 +
        tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 * tangent_14 * term_14 +
        tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 * tangent_3 * term_3 +
        tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6 * term_6 + tangent_7
        * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9
    )
    u_cr2 = u_cr * u_cr
    T3 = T * t0
    return (
        2.5464790894703255 * beta * (48.0 * T3 * sum_0 * u_cr2 / c + 56.0 * T3 * sum_1 * u_cr2 / c + 24.0 * T3 *
        sum_2 * u_cr2 / c) / A,
    )


def _H_AA_passed_1(A, alpha, beta, u_cr):
    # operations: 260 structured, 260 common subexpressions, 255 power chains
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
    fall_1 = f_1 * v2_1 / square_1
    fall_2 = f_2 * v2_2 / square_2
    fall_3 = f_3 * v2_3 / square_3
    fall_4 = f_4 * v2_4 / square_4
    fall_5 = f_5 * v2_5 / square_5
    fall_6 = f_6 * v2_6 / square_6
    fall_7 = f_7 * v2_7 / square_7
    fall_8 = f_8 * v2_8 / square_8
    fall_9 = f_9 * v2_9 / square_9
    fall_10 = f_10 * v2_10 / square_10
    fall_11 = f_11 * v2_11 / square_11
    fall_12 = f_12 * v2_12 / square_12
    fall_13 = f_13 * v2_13 / square_13
    fall_14 = f_14 * v2_14 / square_14
    fall_15 = f_15 * v2_15 / square_15
    sum_2 = (
        fall_1 / square_1 + fall_10 / square_10 + fall_11 / square_11 + fall_12 / square_12 + fall_13 / square_13 +
        fall_14 / square_14 + fall_15 / square_15 + fall_2 / square_2 + fall_3 / square_3 + fall_4 / square_4 +
        fall_5 / square_5 + fall_6 / square_6 + fall_7 / square_7 + fall_8 / square_8 + fall_9 / square_9
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
    # operations: 1089 structured, 1089 common subexpressions, 1068 power chains
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
    x2 = u_cr * u_cr / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    a0_half_0 = 0.5 / a0_0
    a0_half_0_2 = a0_half_0 * a0_half_0
    a0_half_0_3 = a0_half_0 * a0_half_0_2
    a02_0 = -a0_half_0_3
    b0_0 = np.sqrt(Y_0)
    lam0_0 = a0_0 * b0_0 + a0_0 + b0_0
    lam0_1 = a0_half_0 * b0_0 + a0_half_0
    lam0_2 = a02_0 * b0_0 + a02_0
    q0_0 = lam0_0 + 1.0
    term0_0 = 1.0 / q0_0
    term01_0 = -lam0_1 * term0_0 * term0_0
    term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0)
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1 + 0.25
    X0_2 = 0.25 * lam0_2
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1
    Y0_2 = 0.25 * lam0_2
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    Z0_2 = 0.25 * lam0_2
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    lam1_2 = (
        a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 + b1_0) + c1_0 *
        (a12_0 + b12_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    q1_2 = Z0_2 + lam1_2
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    X1_2 = 0.25 * X0_2 + 0.25 * lam1_2
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2
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
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    lam2_2 = (
        a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 + b2_0) + c2_0 *
        (a22_0 + b22_0)
    )
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    X2_2 = 0.25 * X1_2 + 0.25 * lam2_2
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2
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
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    lam3_2 = (
        a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 + b3_0) + c3_0 *
        (a32_0 + b32_0)
    )
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    X3_2 = 0.25 * X2_2 + 0.25 * lam3_2
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2
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
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    lam4_2 = (
        a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 + b4_0) + c4_0 *
        (a42_0 + b42_0)
    )
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    X4_2 = 0.25 * X3_2 + 0.25 * lam4_2
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2
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
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    lam5_2 = (
        a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 + b5_0) + c5_0 *
        (a52_0 + b52_0)
    )
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    X5_2 = 0.25 * X4_2 + 0.25 * lam5_2
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_2 = (
        dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_2 = (
        zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    E5_2 = (
        dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2 * xy_0 * zz_0
    )
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 + 0.10227272727272728 * E2_1 * E2_1 -
        0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 - 0.21428571428571427 * E2_2 +
        0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 * E5_2
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
    t1 = 1.0 - 0.99379661859049351 * t0
    tangent_1 = 3.975186474361974 * t0 / (t1 * t1)
    g_2_2 = g_2 * g_2
    g_2_3 = g_2 * g_2_2
    term_2 = 0.017868209707994881 * g_2_3
    t2 = 1.0 - 0.96760297675669993 * t0
    tangent_2 = 3.8704119070267997 * t0 / (t2 * t2)
    g_3_2 = g_3 * g_3
    g_3_3 = g_3 * g_3_2
    term_3 = 0.026529195202345292 * g_3_3
    t3 = 1.0 - 0.92164198121722729 * t0
    tangent_3 = 3.6865679248689092 * t0 / (t3 * t3)
    g_4_2 = g_4 * g_4
    g_4_3 = g_4 * g_4_2
    term_4 = 0.033283752629548087 * g_4_3
    t4 = 1.0 - 0.85784652785798998 * t0
    tangent_4 = 3.4313861114319599 * t0 / (t4 * t4)
    g_5_2 = g_5 * g_5
    g_5_3 = g_5 * g_5_2
    term_5 = 0.037701475910699687 * g_5_3
    t5 = 1.0 - 0.77891309933755515 * t0
    tangent_5 = 3.1156523973502206 * t0 / (t5 * t5)
    g_6_2 = g_6 * g_6
    g_6_3 = g_6 * g_6_2
    term_6 = 0.039565603112029335 * g_6_3
    t6 = 1.0 - 0.68817935411770381 * t0
    tangent_6 = 2.7527174164708152 * t0 / (t6 * t6)
    g_7_2 = g_7 * g_7
    g_7_3 = g_7 * g_7_2
    term_7 = 0.038890633201099367 * g_7_3
    t7 = 1.0 - 0.58948218524948104 * t0
    tangent_7 = 2.3579287409979242 * t0 / (t7 * t7)
    g_8_2 = g_8 * g_8
    g_8_3 = g_8 * g_8_2
    term_8 = 0.035918814009150916 * g_8_3
    t8 = 1.0 - 0.4869953130832757 * t0
    tangent_8 = 1.9479812523331028 * t0 / (t8 * t8)
    g_9_2 = g_9 * g_9
    g_9_3 = g_9 * g_9_2
    term_9 = 0.031095279034110784 * g_9_3
    t9 = 1.0 - 0.38505274377519932 * t0
    tangent_9 = 1.5402109751007973 * t0 / (t9 * t9)
    g_10_2 = g_10 * g_10
    g_10_3 = g_10 * g_10_2
    term_10 = 0.025024138617737494 * g_10_3
    t10 = 1.0 - 0.28796547636914854 * t0
    tangent_10 = 1.1518619054765942 * t0 / (t10 * t10)
    g_11_2 = g_11 * g_11
    g_11_3 = g_11 * g_11_2
    term_11 = 0.018409690326775727 * g_11_3
    t11 = 1.0 - 0.19983919110743342 * t0
    tangent_11 = 0.79935676442973369 * t0 / (t11 * t11)
    g_12_2 = g_12 * g_12
    g_12_3 = g_12 * g_12_2
    term_12 = 0.011988330981934815 * g_12_3
    t12 = 1.0 - 0.12440062341181206 * t0
    tangent_12 = 0.49760249364724823 * t0 / (t12 * t12)
    g_13_2 = g_13 * g_13
    g_13_3 = g_13 * g_13_2
    term_13 = 0.0064576338222394032 * g_13_3
    t13 = 1.0 - 0.064839964168231387 * t0
    tangent_13 = 0.25935985667292555 * t0 / (t13 * t13)
    g_14_2 = g_14 * g_14
    g_14_3 = g_14 * g_14_2
    term_14 = 0.0024093212835082948 * g_14_3
    t14 = 1.0 - 0.023675950313912963 * t0
    tangent_14 = 0.094703801255651851 * t0 / (t14 * t14)
    g_15_2 = g_15 * g_15
    g_15_3 = g_15 * g_15_2
    term_15 = 0.00027249273519073196 * g_15_3
    t15 = 1.0 - 0.0026493505760394136 * t0
    tangent_15 = 0.010597402304157654 * t0 / (t15 * t15)
    sum_0 = (
        term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9
    )
    sum_1 = (
        tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 + tangent_13 *
        term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3 + tangent_4
        * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 + tangent_9 *
        term_9
    )
    sum_2 = (
        tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 * tangent_11 * term_11 +
        tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 * tangent_14 * term_14 +
        tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 * tangent_3 * term_3 +
        tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6 * term_6 + tangent_7
        * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9
    )
    T3 = T * t0
    return (
        2.5464790894703255 * beta * (48.0 * T3 * sum_0 / c + 56.0 * T3 * sum_1 / c + 24.0 * T3 * sum_2 / c - 6.0 *
        V2 - 7.0 * V4 - 3.0 * V6) / A,
    )


def _H_AA_passed_1_steep(A, alpha, beta, u_cr):
    # operations: 797 structured, 797 common subexpressions, 792 power chains
    root = np.sqrt((A - u_cr) * (A + u_cr))
    c = np.sqrt((1.0 - u_cr) * (u_cr + 1.0))
    u_cr2 = u_cr * u_cr
    A2 = A * A
    x2 = u_cr2 / A2
    y2 = root * root / A2
    third = 0.33333333333333331 * u_cr * x2 / A
    Y_0 = (1.0 - u_cr) * (u_cr + 1.0)
    a0_0 = np.sqrt(y2)
    b0_0 = np.sqrt(Y_0)
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
    X0_0 = 0.25 * lam0_0 + 0.25 * y2
    X0_1 = 0.25 * lam0_1
    X0_2 = 0.25 * lam0_2
    Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0
    Y0_1 = 0.25 * lam0_1 + 0.25
    Y0_2 = 0.25 * lam0_2
    Z0_0 = 0.25 * lam0_0 + 0.25
    Z0_1 = 0.25 * lam0_1
    Z0_2 = 0.25 * lam0_2
    a1_0 = np.sqrt(X0_0)
    a1_half_0 = 0.5 / a1_0
    a11_0 = X0_1 * a1_half_0
    a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0)
    b1_0 = np.sqrt(Y0_0)
    b1_half_0 = 0.5 / b1_0
    b11_0 = Y0_1 * b1_half_0
    b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0)
    c1_0 = np.sqrt(Z0_0)
    c1_half_0 = 0.5 / c1_0
    c11_0 = Z0_1 * c1_half_0
    c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0)
    lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0)
    lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0)
    lam1_2 = (
        a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 + b1_0) + c1_0 *
        (a12_0 + b12_0)
    )
    q1_0 = Z0_0 + lam1_0
    q1_1 = Z0_1 + lam1_1
    q1_2 = Z0_2 + lam1_2
    below1_0 = c1_0 * q1_0
    below1_1 = c11_0 * q1_0 + c1_0 * q1_1
    below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2
    term1_0 = 1.0 / below1_0
    term11_0 = -below1_1 * term1_0 * term1_0
    term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0)
    X1_0 = 0.25 * X0_0 + 0.25 * lam1_0
    X1_1 = 0.25 * X0_1 + 0.25 * lam1_1
    X1_2 = 0.25 * X0_2 + 0.25 * lam1_2
    Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0
    Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1
    Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2
    Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0
    Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1
    Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2
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
    lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0)
    lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0)
    lam2_2 = (
        a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 + b2_0) + c2_0 *
        (a22_0 + b22_0)
    )
    q2_0 = Z1_0 + lam2_0
    q2_1 = Z1_1 + lam2_1
    q2_2 = Z1_2 + lam2_2
    below2_0 = c2_0 * q2_0
    below2_1 = c21_0 * q2_0 + c2_0 * q2_1
    below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2
    term2_0 = 1.0 / below2_0
    term21_0 = -below2_1 * term2_0 * term2_0
    term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0)
    X2_0 = 0.25 * X1_0 + 0.25 * lam2_0
    X2_1 = 0.25 * X1_1 + 0.25 * lam2_1
    X2_2 = 0.25 * X1_2 + 0.25 * lam2_2
    Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0
    Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1
    Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2
    Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0
    Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1
    Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2
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
    lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0)
    lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0)
    lam3_2 = (
        a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 + b3_0) + c3_0 *
        (a32_0 + b32_0)
    )
    q3_0 = Z2_0 + lam3_0
    q3_1 = Z2_1 + lam3_1
    q3_2 = Z2_2 + lam3_2
    below3_0 = c3_0 * q3_0
    below3_1 = c31_0 * q3_0 + c3_0 * q3_1
    below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2
    term3_0 = 1.0 / below3_0
    term31_0 = -below3_1 * term3_0 * term3_0
    term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0)
    X3_0 = 0.25 * X2_0 + 0.25 * lam3_0
    X3_1 = 0.25 * X2_1 + 0.25 * lam3_1
    X3_2 = 0.25 * X2_2 + 0.25 * lam3_2
    Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0
    Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1
    Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2
    Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0
    Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1
    Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2
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
    lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0)
    lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0)
    lam4_2 = (
        a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 + b4_0) + c4_0 *
        (a42_0 + b42_0)
    )
    q4_0 = Z3_0 + lam4_0
    q4_1 = Z3_1 + lam4_1
    q4_2 = Z3_2 + lam4_2
    below4_0 = c4_0 * q4_0
    below4_1 = c41_0 * q4_0 + c4_0 * q4_1
    below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2
    term4_0 = 1.0 / below4_0
    term41_0 = -below4_1 * term4_0 * term4_0
    term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0)
    X4_0 = 0.25 * X3_0 + 0.25 * lam4_0
    X4_1 = 0.25 * X3_1 + 0.25 * lam4_1
    X4_2 = 0.25 * X3_2 + 0.25 * lam4_2
    Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0
    Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1
    Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2
    Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0
    Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1
    Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2
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
    lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0)
    lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0)
    lam5_2 = (
        a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 + b5_0) + c5_0 *
        (a52_0 + b52_0)
    )
    q5_0 = Z4_0 + lam5_0
    q5_1 = Z4_1 + lam5_1
    q5_2 = Z4_2 + lam5_2
    below5_0 = c5_0 * q5_0
    below5_1 = c51_0 * q5_0 + c5_0 * q5_1
    below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2
    term5_0 = 1.0 / below5_0
    term51_0 = -below5_1 * term5_0 * term5_0
    term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0)
    X5_0 = 0.25 * X4_0 + 0.25 * lam5_0
    X5_1 = 0.25 * X4_1 + 0.25 * lam5_1
    X5_2 = 0.25 * X4_2 + 0.25 * lam5_2
    Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0
    Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1
    Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2
    Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0
    Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1
    Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2
    mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0
    mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1
    mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2
    over_0 = 1.0 / mean_0
    over1_0 = -mean_1 * over_0 * over_0
    over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0)
    dx_0 = over_0 * (-X5_0 + mean_0)
    dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1)
    dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2)
    dy_0 = over_0 * (-Y5_0 + mean_0)
    dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1)
    dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2)
    dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0
    dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1
    dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2
    xy_0 = dx_0 * dy_0
    xy_1 = dx_0 * dy_1 + dx_1 * dy_0
    xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0
    zz_0 = dz_0 * dz_0
    zz_1 = 2.0 * dz_0 * dz_1
    zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1
    E2_0 = xy_0 - 6.0 * zz_0
    E2_1 = xy_1 - 6.0 * zz_1
    E2_2 = xy_2 - 6.0 * zz_2
    E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0)
    E3_2 = (
        dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 - 8.0 * zz_0)
    )
    E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0)
    E4_2 = (
        zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 - 3.0 * zz_0)
    )
    E5_0 = dz_0 * xy_0 * zz_0
    E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0
    E5_2 = (
        dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2 * xy_0 * zz_0
    )
    series_0 = (
        0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 - 0.21428571428571427 * E2_0 +
        0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 * E5_0 + 1.0
    )
    series_1 = (
        0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 - 0.17307692307692307 * E2_1 * E3_0 -
        0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 - 0.13636363636363635 * E4_1 + 0.11538461538461539 *
        E5_1
    )
    series_2 = (
        0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 + 0.10227272727272728 * E2_1 * E2_1 -
        0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 - 0.21428571428571427 * E2_2 +
        0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 * E5_2
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
    guards = ((A <= u_cr) & (A <= 0.69999999999999996), A <= u_cr, (u_cr <= 0.75) & (1.05 * u_cr <= A), u_cr <= 0.75, 1.05 * u_cr <= A,)
    bodies = (_H_AA_passed_0, _H_AA_passed_0_steep, _H_AA_passed_1_far, _H_AA_passed_1, _H_AA_passed_1_steep_far, _H_AA_passed_1_steep)
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
