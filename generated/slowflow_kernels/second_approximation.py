"""Second approximation of any mechanism, with higher harmonics, in A = A_1 + a_3 + a_5.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/averaging.py, derivations/slow_flow.py, derivations/second_approximation.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless. Arguments broadcast; outputs have their common shape, NumPy scalars for scalars. Each
docstring gives equation number, domain, shape and the operations after each pass.
"""

# a formatter would spread each polynomial over a page
# fmt: off

import numpy as np

from slowflow_support.backend import NATIVE, compiled
from slowflow_support.broadcast import floats, full

RESONANCE = 9.0

__all__ = [
    "RESONANCE", "detachment", "detachment_by_inertia", "folds", "response",
]


def response(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA):
    """Largest displacement, A_1 and phase, R, F, and dF/dA, dF/dOmega, dR/dA, dR/dOmega.

    Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2. Shape: 9 results, each as the arguments
    broadcast.
    Operations: 359 structured, 255 common subexpressions, 254 power chains.
    """
    Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA = floats(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA)
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
    t35 = -I
    t36 = 2.0 * I
    t37 = 2.0 * R
    arguments = (Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA)
    return (
        full(u_max, arguments),
        full(A_1, arguments),
        full(np.arctan2(t35, -R), arguments),
        full(R, arguments),
        full(R * R + (-F_0 - t35) * (F_0 + I), arguments),
        full(I_A * t36 + R_A * t37, arguments),
        full(I_Omega * t36 + R_Omega * t37, arguments),
        full(R_A, arguments),
        full(R_Omega, arguments),
    )


def detachment(Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA):
    """The forcing (24), largest displacement, and what vanishes where the forcing that reaches it is least.

    Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2. Shape: 3 results, each as the arguments
    broadcast.
    Operations: 357 structured, 253 common subexpressions, 252 power chains.
    """
    Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA = floats(Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA)
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
    t35 = 2.0 * I
    t36 = 2.0 * R
    arguments = (Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA)
    return (
        full(np.hypot(R, I), arguments),
        full(u_max, arguments),
        u_max_A * (I_Omega * t35 + R_Omega * t36) - u_max_Omega * (I_A * t35 + R_A * t36),
    )


def detachment_by_inertia(Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA):
    """The same of an excitation by inertia.

    Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2. Shape: 3 results, each as the arguments
    broadcast.
    Operations: 390 structured, 288 common subexpressions, 287 power chains.
    """
    Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA = floats(Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA)
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
    t27 = m * sine
    R = A_1 * Omega2 + spring - t27
    R_A = A_1_A * Omega2 - m * sine_A + spring_A
    t28 = m * u_max
    t29 = t18 * t28
    t30 = a_3 * a_3
    t31 = a_5 * a_5
    t32 = 9.0 * t30 + 25.0 * t31
    t33 = 2.0 * Omega * zeta
    I = t29 + t33 * (A_1 + t18 * t32)
    t34 = Omega * t18 * zeta
    t35 = t22 * t28
    I_A = (
        A_1_A * (t33 * (-t22 * t32 + 1.0) - t35) + 36.0 * a_3 * a_3_A * t34 + 100.0 * a_5 * a_5_A * t34 + t19 *
        u_max_A
    )
    t36 = 2.0 * I
    t37 = 2.0 * R
    t38 = 18.0 * t30
    t39 = 50.0 * t31
    t40 = A_1_Omega * Omega2 * t22 * zeta
    arguments = (Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA)
    return (
        full(t1 * np.hypot(R, I), arguments),
        full(u_max, arguments),
        -u_max_Omega * (I_A * t36 + R_A * t37) + u_max_A * (t36 * (-A_1 * t33 - A_1_Omega * Omega * t35 + 2.0 *
        A_1_Omega * Omega2 * zeta + Omega * m * t18 * u_max_Omega + 36.0 * Omega2 * a_3 * a_3_Omega * t18 * zeta +
        100.0 * Omega2 * a_5 * a_5_Omega * t18 * zeta - 2.0 * t29 - t34 * t38 - t34 * t39 - t38 * t40 - t39 * t40) +
        t37 * (A_1_Omega * Omega3 - Omega * m * sine_Omega + Omega * spring_Omega - 2.0 * spring + 2.0 * t27)) /
        Omega,
    )


def folds(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA):
    """F and its derivatives: a fold has F = F_A = 0, a cusp all three.

    Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2. Shape: 3 results, each as the arguments
    broadcast.
    Operations: 574 structured, 400 common subexpressions, 396 power chains.
    """
    Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA = floats(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA)
    t0 = 1.0 / A
    t1 = Omega * Omega
    t2 = 1.0 / t1
    t3 = h * t2
    kappa = -t0 * t3
    t4 = t0 * t2
    A2 = A * A
    t5 = 1.0 / A2
    kappa_A = h * t2 * t5 - h_A * t4
    A3 = A * A2
    kappa_AA = 2.0 * h_A * t2 * t5 - h_AA * t4 - 2.0 * t3 / A3
    t6 = kappa - 9.0
    t7 = -t6
    t8 = 1.0 / t7
    t9 = t2 * t8
    a_3 = -h_3 * t9
    t10 = t7 * t7
    t11 = 1.0 / t10
    t12 = t11 * t2
    t13 = h_3 * t12
    a_3_A = -h_3_A * t9 - kappa_A * t13
    t14 = h_3_A * t12
    t15 = 2.0 * t2
    t16 = kappa_A * t15
    t17 = t10 * t7
    a_3_AA = -h_3_AA * t9 - kappa_A * t14 + kappa_A * (-h_3 * t16 / t17 - t14) - kappa_AA * t13
    t18 = kappa - 25.0
    t19 = -t18
    t20 = 1.0 / t19
    t21 = t2 * t20
    a_5 = -h_5 * t21
    t22 = t19 * t19
    t23 = 1.0 / t22
    t24 = t2 * t23
    t25 = h_5 * t24
    a_5_A = -h_5_A * t21 - kappa_A * t25
    t26 = h_5_A * t24
    t27 = t19 * t22
    a_5_AA = -h_5_AA * t21 - kappa_A * t26 + kappa_A * (-h_5 * t16 / t27 - t26) - kappa_AA * t25
    t28 = a_3 + a_5
    t29 = a_3_A + a_5_A
    share_AA = a_3_AA + a_5_AA
    A_1 = A - t28
    A_1_A = 1.0 - t29
    A_1_AA = -share_AA
    t30 = kappa - 49.0
    t31 = -t30
    total = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (kappa * (4.4420846017798256e-35 * kappa + 3.5993895204234291e-33) +
        2.9170831235780408e-31) + 2.3647520450964226e-29) + 1.9177758641615431e-27) + 1.5562307152262564e-25) +
        1.264003059063471e-23) + 1.0280748556111104e-21) + 8.3794971769130177e-20) + 6.851973846392482e-18) +
        5.6310244406867976e-16) + 4.6641592175262402e-14) + 3.912344846154278e-12) + 3.3510322056003729e-10) +
        2.9768494689292246e-08) + 2.8346687069545959e-06) + 0.00031585946398298526) + t20 + t8 +
        0.062181275759752595 + 1.0 / t31
    )
    total_1 = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (7.5515438230257031e-34 * kappa + 5.7590232326774865e-32) +
        4.3756246853670614e-30) + 3.3106528631349914e-28) + 2.4931086234100061e-26) + 1.8674768582715075e-24) +
        1.3904033649698182e-22) + 1.0280748556111104e-20) + 7.5415474592217156e-19) + 5.4815790771139856e-17) +
        3.9417171084807582e-15) + 2.798495530515744e-13) + 1.9561724230771392e-11) + 1.3404128822401492e-09) +
        8.9305484067876734e-08) + 5.6693374139091918e-06) + t11 + t23 + 0.00031585946398298526 + 1.0 / (t31 * t31)
    )
    t32 = t18 * t18
    t33 = t18 * t32
    t34 = t30 * t30
    t35 = t30 * t34
    t36 = t6 * t6
    t37 = t36 * t6
    total_2 = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (1.2082470116841125e-32 * kappa + 8.6385348490162305e-31) + 6.1258745595138854e-29) +
        4.303848722075489e-27) + 2.9917303480920074e-25) + 2.0542245440986584e-23) + 1.3904033649698181e-21) +
        9.2526737004999928e-20) + 6.0332379673773725e-18) + 3.8371053539797902e-16) + 2.3650302650884553e-14) +
        1.3992477652578719e-12) + 7.8246896923085567e-11) + 4.0212386467204473e-09) + 1.7861096813575347e-07) +
        5.6693374139091918e-06 - 2.0 / t37 - 2.0 / t35 - 2.0 / t33
    )
    t38 = 1.0 / A_1
    t39 = m * t38
    t40 = t2 * total
    sine = -t39 * t40
    t41 = t2 * t39
    t42 = kappa_A * total_1
    A_1_2 = A_1 * A_1
    t43 = 1.0 / A_1_2
    sine_A = A_1_A * m * t2 * t43 * total - t41 * t42
    t44 = m * t43
    t45 = t2 * t42 * t44
    A_1_3 = A_1 * A_1_2
    t46 = 1.0 / A_1_3
    sine_AA = (
        A_1_A * t45 + A_1_A * (-A_1_A * m * t15 * t46 * total + t45) + A_1_AA * t40 * t44 - kappa_A * kappa_A * t41
        * total_2 - kappa_AA * t41 * total_1
    )
    cosine = np.sqrt((1.0 - sine) * (sine + 1.0))
    cosine_1 = -sine / cosine
    cosine2 = cosine * cosine
    cosine3 = cosine * cosine2
    cosine_2 = -1.0 / cosine3
    u_max = A_1 * cosine + t28
    t47 = A_1 * cosine_1
    u_max_A = A_1_A * cosine + sine_A * t47 + t29
    u_max_AA = (
        A_1 * cosine_2 * sine_A * sine_A + 2.0 * A_1_A * cosine_1 * sine_A + A_1_AA * cosine + share_AA + sine_AA *
        t47
    )
    t48 = -h_A
    t49 = h_3_A + t48
    t50 = h_5_A + t48
    spring = a_3 * t49 + a_5 * t50 + h
    t51 = -t28
    spring_A = a_3 * h_3_AA + a_3_A * t49 + a_5 * h_5_AA + a_5_A * t50 + h_A + h_AA * t51
    t52 = -h_AA
    spring_AA = (
        a_3 * h_3_AAA + a_3_A * h_3_AA + a_3_A * (h_3_AA + t52) + a_3_AA * t49 + a_5 * h_5_AAA + a_5_A * h_5_AA +
        a_5_A * (h_5_AA + t52) + a_5_AA * t50 + h_AA * (1.0 - t29) + h_AAA * t51
    )
    R = A_1 * t1 - m * sine + spring
    R_A = A_1_A * t1 - m * sine_A + spring_A
    R_AA = A_1_AA * t1 - m * sine_AA + spring_AA
    t53 = m * u_max
    t54 = 9.0 * a_3 * a_3 + 25.0 * a_5 * a_5
    t55 = Omega * zeta
    t56 = 2.0 * t55
    I = t38 * t53 + t56 * (A_1 + t38 * t54)
    t57 = m * u_max_A
    t58 = t38 * t55
    t59 = 36.0 * a_3_A
    t60 = t58 * t59
    t61 = 100.0 * a_5_A
    t62 = t58 * t61
    t63 = -t43 * t53 + t56 * (-t43 * t54 + 1.0)
    I_A = A_1_A * t63 + a_3 * t60 + a_5 * t62 + t38 * t57
    t64 = t43 * t57
    t65 = t43 * t55
    t66 = a_3 * t65
    t67 = a_5 * t65
    I_AA = (
        -A_1_A * t64 + A_1_A * (A_1_A * (2.0 * t46 * t53 + 4.0 * t46 * t54 * t55) - t59 * t66 - t61 * t67 - t64) +
        A_1_AA * t63 + 36.0 * a_3 * a_3_AA * t58 + a_3_A * (-36.0 * A_1_A * t66 + t60) + 100.0 * a_5 * a_5_AA * t58
        + a_5_A * (-100.0 * A_1_A * t67 + t62) + t39 * u_max_AA
    )
    t68 = 2.0 * I
    t69 = 2.0 * R
    arguments = (Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA)
    return (
        full(R * R + (-F_0 + I) * (F_0 + I), arguments),
        full(I_A * t68 + R_A * t69, arguments),
        full(2.0 * I_A * I_A + I_AA * t68 + 2.0 * R_A * R_A + R_AA * t69, arguments),
    )


if NATIVE is not None:
    (
        response, detachment, detachment_by_inertia, folds,
    ) = compiled(
        (response, detachment, detachment_by_inertia, folds,),
        NATIVE.second_approximation(),
    )
