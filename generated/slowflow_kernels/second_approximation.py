"""Second approximation of any mechanism, with higher harmonics, in A = A_1 + a_3 + a_5.

Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
derivations/extensions/second_approximation.py, derivations/extensions/wave.py; never edit.

Rounding errors were measured with A, A_1 0.01 to 1; F_0 0.03 to 0.1; Omega 0.3 to 2; a_3, h_3, h_5 up to 0.02 of
either sign; a_5 up to 0.01 of either sign; cosine, sine up to 0.99 of either sign; h 0.001 to 1 of either sign;
h_3_A, h_5_A up to 0.2 of either sign; h_3_AA, h_5_AA, h_A up to 2 of either sign; h_3_AAA, h_5_AAA, h_AAA up to 20
of either sign; h_AA up to 5 of either sign; kappa up to 8 of either sign; m 0.001 to 0.03; turned up to 3.14; zeta
0.004 to 0.1.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.support.backend import NATIVE, compiled, from_c
from slowflow.support.broadcast import broadcast_outputs, floats

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

RESONANCE = 9.0

__all__ = [
    "RESONANCE", "components", "detachment", "detachment_by_inertia", "folds", "response", "wave",
]


def _common_1(A, Omega, h, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA, h_A, h_AA, m, zeta):
    """What response, detachment have in common."""
    t0 = 1.0 / A
    Omega2 = Omega * Omega
    t1 = 1.0 / Omega2
    kappa = -h * t0 * t1
    kappa_A = -h_A * t0 * t1 + h * t1 / (A * A)
    Omega3 = Omega * Omega2
    t2 = 1.0 / Omega3
    t3 = 2.0 * t2
    kappa_Omega = h * t0 * t3
    t4 = 9.0 - kappa
    t5 = 1.0 / t4
    t6 = t1 * t5
    a_3 = -h_3 * t6
    t7 = kappa_A * t1
    t8 = 1.0 / (t4 * t4)
    t9 = h_3 * t8
    a_3_A = -h_3_A * t6 - t7 * t9
    t10 = kappa_Omega * t1
    a_3_Omega = 2.0 * h_3 * t2 * t5 - t10 * t9
    t11 = 25.0 - kappa
    t12 = 1.0 / t11
    t13 = t1 * t12
    a_5 = -h_5 * t13
    t14 = 1.0 / (t11 * t11)
    t15 = h_5 * t14
    a_5_A = -h_5_A * t13 - t15 * t7
    a_5_Omega = 2.0 * h_5 * t12 * t2 - t10 * t15
    t16 = a_3 + a_5
    share_A = a_3_A + a_5_A
    share_Omega = a_3_Omega + a_5_Omega
    A_1 = A - t16
    A_1_A = 1.0 - share_A
    A_1_Omega = -share_Omega
    t17 = 49.0 - kappa
    total = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (kappa * (4.4420846017798256e-35 * kappa + 3.5993895204234291e-33) +
        2.9170831235780408e-31) + 2.3647520450964226e-29) + 1.9177758641615431e-27) + 1.5562307152262564e-25) +
        1.264003059063471e-23) + 1.0280748556111104e-21) + 8.3794971769130177e-20) + 6.851973846392482e-18) +
        5.6310244406867976e-16) + 4.6641592175262402e-14) + 3.912344846154278e-12) + 3.3510322056003729e-10) +
        2.9768494689292246e-08) + 2.8346687069545959e-06) + 0.00031585946398298526) + t12 + t5 +
        0.062181275759752595 + 1.0 / t17
    )
    total_1 = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (7.5515438230257031e-34 * kappa + 5.7590232326774865e-32) +
        4.3756246853670614e-30) + 3.3106528631349914e-28) + 2.4931086234100061e-26) + 1.8674768582715075e-24) +
        1.3904033649698182e-22) + 1.0280748556111104e-20) + 7.5415474592217156e-19) + 5.4815790771139856e-17) +
        3.9417171084807582e-15) + 2.798495530515744e-13) + 1.9561724230771392e-11) + 1.3404128822401492e-09) +
        8.9305484067876734e-08) + 5.6693374139091918e-06) + t14 + t8 + 0.00031585946398298526 + 1.0 / (t17 * t17)
    )
    t18 = 1.0 / A_1
    t19 = m * t18
    t20 = t1 * total
    sine = -t19 * t20
    t21 = t19 * total_1
    t22 = 1.0 / (A_1 * A_1)
    sine_A = A_1_A * m * t1 * t22 * total - t21 * t7
    sine_Omega = A_1_Omega * m * t20 * t22 - t10 * t21 + t19 * t3 * total
    cosine = np.sqrt((1.0 - sine) * (sine + 1.0))
    cosine_1 = -sine / cosine
    u_max = A_1 * cosine + t16
    t23 = A_1 * cosine_1
    u_max_A = A_1_A * cosine + share_A + sine_A * t23
    u_max_Omega = A_1_Omega * cosine + share_Omega + sine_Omega * t23
    t24 = -h_A
    t25 = h_3_A + t24
    t26 = h_5_A + t24
    spring = a_3 * t25 + a_5 * t26 + h
    spring_A = a_3 * h_3_AA + a_3_A * t25 + a_5 * h_5_AA + a_5_A * t26 + h_A - h_AA * t16
    spring_Omega = a_3_Omega * t25 + a_5_Omega * t26
    R = A_1 * Omega2 - m * sine + spring
    R_A = A_1_A * Omega2 - m * sine_A + spring_A
    t27 = 2.0 * Omega
    R_Omega = A_1 * t27 + A_1_Omega * Omega2 - m * sine_Omega + spring_Omega
    t28 = m * u_max
    t29 = 9.0 * a_3 * a_3 + 25.0 * a_5 * a_5
    t30 = zeta * (A_1 + t18 * t29)
    I = t18 * t28 + t27 * t30
    t31 = Omega * t18 * zeta
    t32 = 36.0 * a_3 * t31
    t33 = 100.0 * a_5 * t31
    t34 = -t22 * t28 + t27 * zeta * (-t22 * t29 + 1.0)
    I_A = A_1_A * t34 + a_3_A * t32 + a_5_A * t33 + t19 * u_max_A
    I_Omega = A_1_Omega * t34 + a_3_Omega * t32 + a_5_Omega * t33 + t19 * u_max_Omega + 2.0 * t30
    return A_1, u_max, u_max_A, u_max_Omega, R, R_A, R_Omega, I, I_A, I_Omega


def response(Omega: ArrayLike, A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike, h_AA: ArrayLike, h_3: ArrayLike, h_3_A: ArrayLike, h_3_AA: ArrayLike, h_5: ArrayLike, h_5_A: ArrayLike, h_5_AA: ArrayLike) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """Largest displacement, A_1 and phase, R, F, and dF/dA, dF/dOmega, dR/dA, dR/dOmega.

    Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2. Operations: 254. Error / u (1 + kappa):
    measured 1.3.
    """
    Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA = floats(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA)
    A_1, u_max, u_max_A, u_max_Omega, R, R_A, R_Omega, I, I_A, I_Omega = _common_1(
        A, Omega, h, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA, h_A, h_AA, m, zeta
    )
    t35 = -I
    t36 = 2.0 * I
    t37 = 2.0 * R
    return broadcast_outputs((Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA),
        u_max, A_1,
        np.arctan2(t35, -R),
        R,
        R * R + (-F_0 - t35) * (F_0 + I),
        I_A * t36 + R_A * t37,
        I_Omega * t36 + R_Omega * t37,
        R_A, R_Omega,
    )


def detachment(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike, h_AA: ArrayLike, h_3: ArrayLike, h_3_A: ArrayLike, h_3_AA: ArrayLike, h_5: ArrayLike, h_5_A: ArrayLike, h_5_AA: ArrayLike) -> tuple[Any, Any, Any]:
    """The forcing (24), largest displacement, and what vanishes where the forcing that reaches it is least.

    Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2. Operations: 252. Error / u (1 + kappa):
    measured 1.6.
    """
    Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA = floats(Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA)
    A_1, u_max, u_max_A, u_max_Omega, R, R_A, R_Omega, I, I_A, I_Omega = _common_1(
        A, Omega, h, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA, h_A, h_AA, m, zeta
    )
    t35 = 2.0 * I
    t36 = 2.0 * R
    return broadcast_outputs((Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA),
        np.hypot(R, I),
        u_max,
        u_max_A * (I_Omega * t35 + R_Omega * t36) - u_max_Omega * (I_A * t35 + R_A * t36),
    )


def components(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, h: ArrayLike, h_3: ArrayLike, h_5: ArrayLike) -> tuple[Any, Any, Any, Any, Any, Any, Any]:
    """Largest displacement and what `wave` takes.

    Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2. Operations: 62. Error / u (1 + kappa):
    measured 1.1.
    """
    Omega, A, m, h, h_3, h_5 = floats(Omega, A, m, h, h_3, h_5)
    t0 = 1.0 / (Omega * Omega)
    kappa = -h * t0 / A
    t1 = 1.0 / (9.0 - kappa)
    a_3 = -h_3 * t0 * t1
    t2 = 1.0 / (25.0 - kappa)
    a_5 = -h_5 * t0 * t2
    share = a_3 + a_5
    A_1 = A - share
    total = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (kappa * (4.4420846017798256e-35 * kappa + 3.5993895204234291e-33) +
        2.9170831235780408e-31) + 2.3647520450964226e-29) + 1.9177758641615431e-27) + 1.5562307152262564e-25) +
        1.264003059063471e-23) + 1.0280748556111104e-21) + 8.3794971769130177e-20) + 6.851973846392482e-18) +
        5.6310244406867976e-16) + 4.6641592175262402e-14) + 3.912344846154278e-12) + 3.3510322056003729e-10) +
        2.9768494689292246e-08) + 2.8346687069545959e-06) + 0.00031585946398298526) + t1 + t2 + 0.062181275759752595
        + 1.0 / (49.0 - kappa)
    )
    sine = -m * t0 * total / A_1
    cosine = np.sqrt((1.0 - sine) * (sine + 1.0))
    u_max = A_1 * cosine + share
    return broadcast_outputs((Omega, A, m, h, h_3, h_5), u_max, A_1, sine, cosine, a_3, a_5, kappa)


def wave(turned: ArrayLike, Omega: ArrayLike, m: ArrayLike, A_1: ArrayLike, sine: ArrayLike, cosine: ArrayLike, a_3: ArrayLike, a_5: ArrayLike, kappa: ArrayLike) -> tuple[Any, Any]:
    """u and u' at an angle after the mass turned at its largest displacement.

    Equation beyond (23). Domain: Omega > 0, 0 <= turned <= pi, |kappa| < 9. Operations: 343. Error / u (1 + kappa):
    measured 1.5.
    """
    turned, Omega, m, A_1, sine, cosine, a_3, a_5, kappa = floats(turned, Omega, m, A_1, sine, cosine, a_3, a_5, kappa)
    c_1 = np.cos(turned)
    s_1 = np.sin(turned)
    twice = (c_1 + s_1) * (2.0 * c_1 - 2.0 * s_1)
    c_3 = c_1 * twice - c_1
    s_3 = s_1 * twice + s_1
    c_5 = -c_1 + c_3 * twice
    s_5 = -s_1 + s_3 * twice
    c_7 = -c_3 + c_5 * twice
    s_7 = -s_3 + s_5 * twice
    c_9 = -c_5 + c_7 * twice
    s_9 = -s_5 + s_7 * twice
    c_11 = -c_7 + c_9 * twice
    s_11 = -s_7 + s_9 * twice
    c_13 = c_11 * twice - c_9
    s_13 = s_11 * twice - s_9
    c_15 = -c_11 + c_13 * twice
    s_15 = -s_11 + s_13 * twice
    x = -turned + 1.5707963267948966
    x2 = x * x
    kappa2 = kappa * kappa
    kappa4 = kappa2 * kappa2
    kappa8 = kappa4 * kappa4
    left_3 = kappa8 / (387420489.0 - 43046721.0 * kappa)
    left_5 = kappa8 / (3814697265625.0 - 152587890625.0 * kappa)
    left_7 = kappa8 / (1628413597910449.0 - 33232930569601.0 * kappa)
    left_9 = kappa8 / (1.5009463529699914e+17 - 1853020188851841.0 * kappa)
    left_11 = kappa8 / (5.5599173134922312e+18 - 45949729863572160.0 * kappa)
    left_13 = kappa8 / (1.124554069519574e+20 - 6.654166091831799e+17 * kappa)
    left_15 = kappa8 / (1.4778918800354003e+21 - 6.5684083557128909e+18 * kappa)
    t0 = (
        x2 * (x2 * (x2 * (3.8681701706306841e-23 * x2 - 1.9572941063391263e-20) + 8.2206352466243295e-18) -
        2.8114572543455206e-15)
    )
    t1 = x2 * (t0 + 7.6471637318198164e-13)
    t2 = x2 * (t1 - 1.6059043836821613e-10)
    t3 = x2 * (t2 + 2.505210838544172e-08)
    t4 = x2 * (t3 - 2.7557319223985893e-06)
    t5 = x2 * (t4 + 0.00019841269841269841)
    t6 = x2 * (t5 - 0.0083333333333333332)
    closed_cosines = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * x * (x2 * (x2 * (x2 * (x2 * (x2 * (x2 * (x2 *
        (t0 + 1.6410953816489557e-13) - 4.9869519852303398e-12) + 9.6254507448290844e-11) - 1.2276568272158579e-09)
        + 9.9832961864901149e-09) - 4.687521813584026e-08) + 1.0440270469314786e-07) - 6.9659157375612845e-08) + x *
        (x2 * (x2 * (x2 * (x2 * (x2 * (x2 * (t1 - 3.4463003014628067e-11) + 7.7796450969593306e-10) -
        1.0587995819311993e-08) + 8.839129155954177e-08) - 4.1929843983258485e-07) + 9.3750436271680509e-07) -
        6.2641622815888723e-07)) + x * (x2 * (x2 * (x2 * (x2 * (x2 * (t2 + 5.3762284702819786e-09) -
        8.5576096066552638e-08) + 7.6233569899046347e-07) - 3.7124342455007543e-06) + 8.3859687966516967e-06) -
        5.625026176300831e-06)) + x * (x2 * (x2 * (x2 * (x2 * (t3 - 5.9138513173101762e-07) +
        6.1614789167917898e-06) - 3.2018099357599463e-05) + 7.4248684910015081e-05) - 5.0315812779910177e-05)) + x *
        (x2 * (x2 * (x2 * (t4 + 4.257972948463327e-05) - 0.00025878211450525515) + 0.00064036198715198937) -
        0.00044549210946009048)) + x * (x2 * (x2 * (t5 - 0.0017883486383545974) + 0.0051756422901051034) -
        0.0038421719229119358)) + x * (x2 * (t6 + 0.035766972767091947) - 0.031053853740630619)) + x * (x2 * (t6 +
        0.16666666666666666) - 0.21460183660255169)
    )
    t7 = (
        x2 * (x2 * (x2 * (8.8967913924505741e-22 - 1.6117375710961184e-24 * x2) - 4.1103176233121648e-19) +
        1.5619206968586225e-16)
    )
    t8 = x2 * (t7 - 4.7794773323873853e-14)
    t9 = x2 * (t8 + 1.1470745597729725e-11)
    t10 = x2 * (t9 - 2.08767569878681e-09)
    t11 = x2 * (t10 + 2.7557319223985888e-07)
    t12 = x2 * (t11 - 2.4801587301587302e-05)
    t13 = x2 * (t12 + 0.0013888888888888889)
    closed_sines = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (x2 * (x2 * (x2 * (x2 * (x2 * (x2 * (x2 * (x2
        * (t7 - 1.0256846135305973e-14) + 3.5621085608788143e-13) - 8.021208954024237e-12) + 1.2276568272158579e-10)
        - 1.2479120233112644e-09) + 7.8125363559733761e-09) - 2.6100676173286966e-08) + 3.4829578687806423e-08) -
        7.7422178957115755e-09) + x2 * (x2 * (x2 * (x2 * (x2 * (x2 * (x2 * (t8 + 2.4616430724734335e-12) -
        6.4830375807994417e-11) + 1.0587995819311992e-09) - 1.1048911444942721e-08) + 6.9883073305430808e-08) -
        2.3437609067920127e-07) + 3.1320811407944362e-07) - 6.9659157375612845e-08) + x2 * (x2 * (x2 * (x2 * (x2 *
        (x2 * (t9 - 4.4801903919016488e-10) + 8.5576096066552628e-09) - 9.5291962373807933e-08) +
        6.1873904091679242e-07) - 2.0964921991629242e-06) + 2.8125130881504155e-06) - 6.2641622815888723e-07) + x2 *
        (x2 * (x2 * (x2 * (x2 * (t10 + 5.9138513173101769e-08) - 7.7018486459897373e-07) + 5.3363498929332442e-06) -
        1.856217122750377e-05) + 2.5157906389955088e-05) - 5.625026176300831e-06) + x2 * (x2 * (x2 * (x2 * (t11 -
        5.3224661855791587e-06) + 4.3130352417542525e-05) - 0.00016009049678799734) + 0.00022274605473004524) -
        5.0315812779910177e-05) + x2 * (x2 * (x2 * (t12 + 0.00029805810639243292) - 0.0012939105725262758) +
        0.0019210859614559679) - 0.00044549210946009048) + x2 * (x2 * (t13 - 0.0089417431917729866) +
        0.015526926870315309) - 0.0038421719229119358) + x2 * (x2 * (t13 - 0.041666666666666664) +
        0.10730091830127585) - 0.031053853740630619
    )
    t14 = m / (Omega * Omega)
    return (
        A_1 * (c_1 * cosine - s_1 * sine) + a_3 * c_3 + a_5 * c_5 - t14 * (closed_sines + 0.090909090909090912 *
        left_11 * s_11 + 0.076923076923076927 * left_13 * s_13 + 0.066666666666666666 * left_15 * s_15 +
        0.33333333333333331 * left_3 * s_3 + 0.20000000000000001 * left_5 * s_5 + 0.14285714285714285 * left_7 * s_7
        + 0.1111111111111111 * left_9 * s_9),
        Omega * (-A_1 * (c_1 * sine + cosine * s_1) - 3.0 * a_3 * s_3 - 5.0 * a_5 * s_5 - t14 * (c_11 * left_11 +
        c_13 * left_13 + c_15 * left_15 + c_3 * left_3 + c_5 * left_5 + c_7 * left_7 + c_9 * left_9 +
        closed_cosines)),
    )


if NATIVE is not None:
    globals().update(compiled(globals(), NATIVE.second_approximation()))
#: functions that no Python code calls, which are in C, with their arguments; see generated/c/second_approximation.h
FROM_C = {
    "detachment_by_inertia": "Omega A m zeta h h_A h_AA h_3 h_3_A h_3_AA h_5 h_5_A h_5_AA",
    "folds": "Omega A F_0 m zeta h h_A h_AA h_AAA h_3 h_3_A h_3_AA h_3_AAA h_5 h_5_A h_5_AA h_5_AAA",
}
globals().update(from_c("second_approximation", FROM_C))
