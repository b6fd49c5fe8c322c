"""Second approximation of any mechanism: with what the higher harmonics do to the first.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/averaging.py, derivations/slow_flow.py, derivations/second_approximation.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless. Arguments broadcast; outputs have their common shape, NumPy scalars for scalars. Each
docstring gives equation number, domain and the operations after each pass.
"""

# a formatter would spread each polynomial over a page
# fmt: off

import numpy as np

from slowflow_kernels._backend import compiled
from slowflow_kernels._broadcast import floats, full

RESONANCE = 9.0

__all__ = [
    "RESONANCE",
    "detachment",
    "folds",
    "response",
]


def response(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA):
    """Largest displacement, phase, R, I, F, and dF/dA, dF/dOmega, dR/dA, dR/dOmega.

    Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2.
    Operations: 316 structured, 233 common subexpressions, 232 power chains.
    """
    Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA = floats(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA)
    t0 = 1.0 / A
    Omega2 = Omega * Omega
    t1 = 1.0 / Omega2
    kappa = -h * t0 * t1
    t2 = t0 * t1
    t3 = 1.0 / (A * A)
    kappa_A = h * t1 * t3 - h_A * t2
    Omega3 = Omega * Omega2
    t4 = 1.0 / Omega3
    kappa_Omega = 2.0 * h * t0 * t4
    t5 = 9.0 - kappa
    t6 = 1.0 / t5
    t7 = t1 * t6
    a_3 = -h_3 * t7
    t8 = kappa_A * t1
    t9 = 1.0 / (t5 * t5)
    t10 = h_3 * t9
    a_3_A = -h_3_A * t7 - t10 * t8
    t11 = kappa_Omega * t1
    a_3_Omega = 2.0 * h_3 * t4 * t6 - t10 * t11
    t12 = 25.0 - kappa
    t13 = 1.0 / t12
    t14 = t1 * t13
    a_5 = -h_5 * t14
    t15 = 1.0 / (t12 * t12)
    t16 = h_5 * t15
    a_5_A = -h_5_A * t14 - t16 * t8
    a_5_Omega = 2.0 * h_5 * t13 * t4 - t11 * t16
    t17 = 49.0 - kappa
    total = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (kappa * (4.4420846017798256e-35 * kappa + 3.5993895204234291e-33) +
        2.9170831235780408e-31) + 2.3647520450964226e-29) + 1.9177758641615431e-27) + 1.5562307152262564e-25) +
        1.264003059063471e-23) + 1.0280748556111104e-21) + 8.3794971769130177e-20) + 6.851973846392482e-18) +
        5.6310244406867976e-16) + 4.6641592175262402e-14) + 3.912344846154278e-12) + 3.3510322056003729e-10) +
        2.9768494689292246e-08) + 2.8346687069545959e-06) + 0.00031585946398298526) + t13 + t6 +
        0.062181275759752595 + 1.0 / t17
    )
    total_1 = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (7.5515438230257031e-34 * kappa + 5.7590232326774865e-32) +
        4.3756246853670614e-30) + 3.3106528631349914e-28) + 2.4931086234100061e-26) + 1.8674768582715075e-24) +
        1.3904033649698182e-22) + 1.0280748556111104e-20) + 7.5415474592217156e-19) + 5.4815790771139856e-17) +
        3.9417171084807582e-15) + 2.798495530515744e-13) + 1.9561724230771392e-11) + 1.3404128822401492e-09) +
        8.9305484067876734e-08) + 5.6693374139091918e-06) + t15 + t9 + 0.00031585946398298526 + 1.0 / (t17 * t17)
    )
    t18 = m * t2
    delta = -t18 * total
    t19 = t18 * total_1
    delta_A = -kappa_A * t19 + m * t1 * t3 * total
    delta_Omega = -kappa_Omega * t19 + 2.0 * m * t0 * t4 * total
    t20 = np.sin(delta)
    t21 = np.cos(delta)
    cosine_1 = -t20
    u_max = A * t21 + a_3 + a_5
    t22 = A * cosine_1
    u_max_A = a_3_A + a_5_A + delta_A * t22 + t21
    u_max_Omega = a_3_Omega + a_5_Omega + delta_Omega * t22
    R = A * Omega2 + a_3 * h_3_A + a_5 * h_5_A + h - m * t20
    t23 = m * t21
    R_A = Omega2 + a_3 * h_3_AA + a_3_A * h_3_A + a_5 * h_5_AA + a_5_A * h_5_A - delta_A * t23 + h_A
    t24 = 2.0 * Omega
    R_Omega = A * t24 + a_3_Omega * h_3_A + a_5_Omega * h_5_A - delta_Omega * t23
    t25 = m * t0
    t26 = 9.0 * a_3 * a_3 + 25.0 * a_5 * a_5
    t27 = zeta * (A + t0 * t26)
    I = t24 * t27 + t25 * u_max
    t28 = Omega * t0 * zeta
    t29 = 36.0 * a_3 * t28
    t30 = 100.0 * a_5 * t28
    I_A = a_3_A * t29 + a_5_A * t30 - m * t3 * u_max + t24 * zeta * (-t26 * t3 + 1.0) + t25 * u_max_A
    I_Omega = a_3_Omega * t29 + a_5_Omega * t30 + t25 * u_max_Omega + 2.0 * t27
    t31 = -I
    t32 = 2.0 * I
    t33 = 2.0 * R
    arguments = (Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA)
    return (
        full(u_max, arguments),
        full(np.arctan2(t31, -R), arguments),
        full(R, arguments),
        full(I, arguments),
        full(R * R + (-F_0 - t31) * (F_0 + I), arguments),
        full(I_A * t32 + R_A * t33, arguments),
        full(I_Omega * t32 + R_Omega * t33, arguments),
        full(R_A, arguments),
        full(R_Omega, arguments),
    )


def folds(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA):
    """F and its derivatives: a fold has F = F_A = 0, a cusp all three.

    Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2.
    Operations: 507 structured, 353 common subexpressions, 350 power chains.
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
    t6 = 1.0 / A3
    t7 = 2.0 * t6
    kappa_AA = 2.0 * h_A * t2 * t5 - h_AA * t4 - t3 * t7
    t8 = kappa - 9.0
    t9 = -t8
    t10 = 1.0 / t9
    t11 = t10 * t2
    a_3 = -h_3 * t11
    t12 = t9 * t9
    t13 = 1.0 / t12
    t14 = t13 * t2
    t15 = h_3 * t14
    a_3_A = -h_3_A * t11 - kappa_A * t15
    t16 = h_3_A * t14
    t17 = 2.0 * kappa_A * t2
    t18 = t12 * t9
    a_3_AA = -h_3_AA * t11 - kappa_A * t16 + kappa_A * (-h_3 * t17 / t18 - t16) - kappa_AA * t15
    t19 = kappa - 25.0
    t20 = -t19
    t21 = 1.0 / t20
    t22 = t2 * t21
    a_5 = -h_5 * t22
    t23 = t20 * t20
    t24 = 1.0 / t23
    t25 = t2 * t24
    t26 = h_5 * t25
    a_5_A = -h_5_A * t22 - kappa_A * t26
    t27 = h_5_A * t25
    t28 = t20 * t23
    a_5_AA = -h_5_AA * t22 - kappa_A * t27 + kappa_A * (-h_5 * t17 / t28 - t27) - kappa_AA * t26
    t29 = kappa - 49.0
    t30 = -t29
    total = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (kappa * (4.4420846017798256e-35 * kappa + 3.5993895204234291e-33) +
        2.9170831235780408e-31) + 2.3647520450964226e-29) + 1.9177758641615431e-27) + 1.5562307152262564e-25) +
        1.264003059063471e-23) + 1.0280748556111104e-21) + 8.3794971769130177e-20) + 6.851973846392482e-18) +
        5.6310244406867976e-16) + 4.6641592175262402e-14) + 3.912344846154278e-12) + 3.3510322056003729e-10) +
        2.9768494689292246e-08) + 2.8346687069545959e-06) + 0.00031585946398298526) + t10 + t21 +
        0.062181275759752595 + 1.0 / t30
    )
    total_1 = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (7.5515438230257031e-34 * kappa + 5.7590232326774865e-32) +
        4.3756246853670614e-30) + 3.3106528631349914e-28) + 2.4931086234100061e-26) + 1.8674768582715075e-24) +
        1.3904033649698182e-22) + 1.0280748556111104e-20) + 7.5415474592217156e-19) + 5.4815790771139856e-17) +
        3.9417171084807582e-15) + 2.798495530515744e-13) + 1.9561724230771392e-11) + 1.3404128822401492e-09) +
        8.9305484067876734e-08) + 5.6693374139091918e-06) + t13 + t24 + 0.00031585946398298526 + 1.0 / (t30 * t30)
    )
    t31 = t19 * t19
    t32 = t19 * t31
    t33 = t29 * t29
    t34 = t29 * t33
    t35 = t8 * t8
    t36 = t35 * t8
    total_2 = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (1.2082470116841125e-32 * kappa + 8.6385348490162305e-31) + 6.1258745595138854e-29) +
        4.303848722075489e-27) + 2.9917303480920074e-25) + 2.0542245440986584e-23) + 1.3904033649698181e-21) +
        9.2526737004999928e-20) + 6.0332379673773725e-18) + 3.8371053539797902e-16) + 2.3650302650884553e-14) +
        1.3992477652578719e-12) + 7.8246896923085567e-11) + 4.0212386467204473e-09) + 1.7861096813575347e-07) +
        5.6693374139091918e-06 - 2.0 / t36 - 2.0 / t34 - 2.0 / t32
    )
    t37 = m * t4
    delta = -t37 * total
    t38 = t37 * total_1
    delta_A = -kappa_A * t38 + m * t2 * t5 * total
    t39 = m * t7
    delta_AA = (
        -kappa_A * kappa_A * t37 * total_2 + 2.0 * kappa_A * m * t2 * t5 * total_1 - kappa_AA * t38 - t2 * t39 *
        total
    )
    t40 = np.sin(delta)
    t41 = np.cos(delta)
    t42 = -t40
    cosine_2 = -t41
    u_max = A * t41 + a_3 + a_5
    t43 = delta_A * t42
    u_max_A = A * t43 + a_3_A + a_5_A + t41
    t44 = delta_A * delta_A
    u_max_AA = A * cosine_2 * t44 + A * delta_AA * t42 + a_3_AA + a_5_AA + 2.0 * t43
    R = A * t1 + a_3 * h_3_A + a_5 * h_5_A + h - m * t40
    t45 = m * t41
    R_A = a_3 * h_3_AA + a_3_A * h_3_A + a_5 * h_5_AA + a_5_A * h_5_A - delta_A * t45 + h_A + t1
    R_AA = (
        a_3 * h_3_AAA + 2.0 * a_3_A * h_3_AA + a_3_AA * h_3_A + a_5 * h_5_AAA + 2.0 * a_5_A * h_5_AA + a_5_AA *
        h_5_A - delta_AA * t45 + h_AA - m * t42 * t44
    )
    t46 = m * t0
    t47 = 9.0 * a_3 * a_3 + 25.0 * a_5 * a_5
    t48 = Omega * zeta
    t49 = 2.0 * t48
    I = t46 * u_max + t49 * (A + t0 * t47)
    t50 = m * t5
    t51 = 36.0 * t48
    t52 = a_3 * t51
    t53 = a_3_A * t0
    t54 = 100.0 * t48
    t55 = a_5 * t54
    t56 = a_5_A * t0
    I_A = t46 * u_max_A + t49 * (-t47 * t5 + 1.0) - t50 * u_max + t52 * t53 + t55 * t56
    t57 = t5 * t52
    t58 = t5 * t55
    I_AA = (
        -a_3_A * t57 + a_3_A * (t51 * t53 - t57) + a_3_AA * t0 * t52 - a_5_A * t58 + a_5_A * (t54 * t56 - t58) +
        a_5_AA * t0 * t55 + t39 * u_max + t46 * u_max_AA + 4.0 * t47 * t48 * t6 - 2.0 * t50 * u_max_A
    )
    t59 = 2.0 * I
    t60 = 2.0 * R
    arguments = (Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA)
    return (
        full(R * R + (-F_0 + I) * (F_0 + I), arguments),
        full(I_A * t59 + R_A * t60, arguments),
        full(2.0 * I_A * I_A + I_AA * t59 + 2.0 * R_A * R_A + R_AA * t60, arguments),
    )


def detachment(Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA):
    """R, I, largest displacement, and what vanishes where the forcing that reaches it is least.

    Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2.
    Operations: 313 structured, 230 common subexpressions, 229 power chains.
    """
    Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA = floats(Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA)
    t0 = 1.0 / A
    Omega2 = Omega * Omega
    t1 = 1.0 / Omega2
    kappa = -h * t0 * t1
    t2 = t0 * t1
    t3 = 1.0 / (A * A)
    kappa_A = h * t1 * t3 - h_A * t2
    Omega3 = Omega * Omega2
    t4 = 1.0 / Omega3
    kappa_Omega = 2.0 * h * t0 * t4
    t5 = 9.0 - kappa
    t6 = 1.0 / t5
    t7 = t1 * t6
    a_3 = -h_3 * t7
    t8 = kappa_A * t1
    t9 = 1.0 / (t5 * t5)
    t10 = h_3 * t9
    a_3_A = -h_3_A * t7 - t10 * t8
    t11 = kappa_Omega * t1
    a_3_Omega = 2.0 * h_3 * t4 * t6 - t10 * t11
    t12 = 25.0 - kappa
    t13 = 1.0 / t12
    t14 = t1 * t13
    a_5 = -h_5 * t14
    t15 = 1.0 / (t12 * t12)
    t16 = h_5 * t15
    a_5_A = -h_5_A * t14 - t16 * t8
    a_5_Omega = 2.0 * h_5 * t13 * t4 - t11 * t16
    t17 = 49.0 - kappa
    total = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (kappa * (4.4420846017798256e-35 * kappa + 3.5993895204234291e-33) +
        2.9170831235780408e-31) + 2.3647520450964226e-29) + 1.9177758641615431e-27) + 1.5562307152262564e-25) +
        1.264003059063471e-23) + 1.0280748556111104e-21) + 8.3794971769130177e-20) + 6.851973846392482e-18) +
        5.6310244406867976e-16) + 4.6641592175262402e-14) + 3.912344846154278e-12) + 3.3510322056003729e-10) +
        2.9768494689292246e-08) + 2.8346687069545959e-06) + 0.00031585946398298526) + t13 + t6 +
        0.062181275759752595 + 1.0 / t17
    )
    total_1 = (
        kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (7.5515438230257031e-34 * kappa + 5.7590232326774865e-32) +
        4.3756246853670614e-30) + 3.3106528631349914e-28) + 2.4931086234100061e-26) + 1.8674768582715075e-24) +
        1.3904033649698182e-22) + 1.0280748556111104e-20) + 7.5415474592217156e-19) + 5.4815790771139856e-17) +
        3.9417171084807582e-15) + 2.798495530515744e-13) + 1.9561724230771392e-11) + 1.3404128822401492e-09) +
        8.9305484067876734e-08) + 5.6693374139091918e-06) + t15 + t9 + 0.00031585946398298526 + 1.0 / (t17 * t17)
    )
    t18 = m * t2
    delta = -t18 * total
    t19 = t18 * total_1
    delta_A = -kappa_A * t19 + m * t1 * t3 * total
    delta_Omega = -kappa_Omega * t19 + 2.0 * m * t0 * t4 * total
    t20 = np.sin(delta)
    t21 = np.cos(delta)
    cosine_1 = -t20
    u_max = A * t21 + a_3 + a_5
    t22 = A * cosine_1
    u_max_A = a_3_A + a_5_A + delta_A * t22 + t21
    u_max_Omega = a_3_Omega + a_5_Omega + delta_Omega * t22
    R = A * Omega2 + a_3 * h_3_A + a_5 * h_5_A + h - m * t20
    t23 = m * t21
    R_A = Omega2 + a_3 * h_3_AA + a_3_A * h_3_A + a_5 * h_5_AA + a_5_A * h_5_A - delta_A * t23 + h_A
    t24 = 2.0 * Omega
    R_Omega = A * t24 + a_3_Omega * h_3_A + a_5_Omega * h_5_A - delta_Omega * t23
    t25 = m * t0
    t26 = 9.0 * a_3 * a_3 + 25.0 * a_5 * a_5
    t27 = zeta * (A + t0 * t26)
    I = t24 * t27 + t25 * u_max
    t28 = Omega * t0 * zeta
    t29 = 36.0 * a_3 * t28
    t30 = 100.0 * a_5 * t28
    I_A = a_3_A * t29 + a_5_A * t30 - m * t3 * u_max + t24 * zeta * (-t26 * t3 + 1.0) + t25 * u_max_A
    I_Omega = a_3_Omega * t29 + a_5_Omega * t30 + t25 * u_max_Omega + 2.0 * t27
    t31 = 2.0 * I
    t32 = 2.0 * R
    arguments = (Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA)
    return (
        full(R, arguments),
        full(I, arguments),
        full(u_max, arguments),
        full(u_max_A * (I_Omega * t31 + R_Omega * t32) - u_max_Omega * (I_A * t31 + R_A * t32), arguments),
    )


globals().update(compiled("second_approximation"))
