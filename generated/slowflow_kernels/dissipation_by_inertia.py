"""Gradients with other laws of damping under excitation by inertia.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/averaging.py, derivations/slow_flow.py, derivations/dissipation.py, derivations/inertia.py, derivations/gradients.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless, for any kind of number that has arithmetic: floats, complex numbers, arrays, an integrator's
symbols. Each docstring gives equation number, domain and the operations after each pass.
Rounding errors are in u (1 + kappa), u = 2^-53: proved ones hold wherever nothing overflows or underflows, measured
ones are the worst of all outputs that was found, by a search for it with A 1e-09 to 1000, A_p 1e-09 to 1000 of
either sign or 0, F_0 1e-09 to 1000, F_0_p 1e-09 to 1000 of either sign or 0, I_0 1e-12 to 1 or 0, I_0A 1e-09 to
1e+06 of either sign or 0, I_0AA 1e-09 to 1e+09 of either sign or 0, I_0AAA 1e-09 to 1e+12 of either sign or 0,
I_0AAp 1e-09 to 1000 of either sign or 0, I_0Ap 1e-09 to 1000 of either sign or 0, I_0p 1e-09 to 1000 of either sign
or 0, Omega 0.001 to 1000, Omega_p 1e-09 to 1000 of either sign or 0, d 1e-12 to 1000 or 0, d_p 1e-09 to 1000 of
either sign or 0, end_p 1e-09 to 1000 of either sign or 0, forcing_p 1e-09 to 1000 of either sign or 0, frequency_p
1e-09 to 1000 of either sign or 0, h 1e-12 to 1000 of either sign or 0, h_A 1e-09 to 1e+06 of either sign or 0, h_AA
1e-09 to 1e+09 of either sign or 0, h_AAA 1e-09 to 1e+12 of either sign or 0, h_AAp 1e-09 to 1000 of either sign or
0, h_Ap 1e-09 to 1000 of either sign or 0, h_p 1e-09 to 1000 of either sign or 0, zeta 1e-12 to 1 or 0, zeta_p 1e-09
to 1000 of either sign or 0.
"""

# a formatter would spread each polynomial over a page
# fmt: off

import numpy as np


__all__ = [
    "MOVES", "beside", "moves_of_corner_backbone", "moves_of_corner_end", "moves_of_corner_fold",
    "moves_of_corner_rest", "moves_of_corner_top", "moves_of_cusp", "moves_of_fold", "moves_of_isola",
    "moves_of_peak", "moves_of_phase", "moves_of_state",
]


def moves_of_state(Omega, A, F_0, I_0, I_0A, I_0AA, I_0AAA, zeta, d, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, I_0p, I_0Ap, I_0AAp, zeta_p, d_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of a steady state; with Omega = 0 a peak at rest; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 94 structured, 66 common subexpressions, 63 power chains.
    Proved, error / u (1 + kappa): -, 0.0, 0.0, -, -, 0.0, 0.0
    Measured, error / u (1 + kappa): 0.36
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * A * Omega2
    t2 = 2.0 * Omega
    t3 = t2 * zeta
    t4 = A * t3 + d * t1
    I = I_0 + t4
    t5 = 2.0 * d * t0 + t3
    F_A = 2.0 * (I * (I_0A + t5) + R * (Omega2 + h_A))
    Omega3 = Omega * Omega2
    F_Omega = 4.0 * A * (I * (A * Omega * d + zeta) + Omega * R) - 4.0 * F_0 * F_0 * Omega3
    F_p = 2.0 * (I * (A * t2 * zeta_p + I_0p + d_p * t1) + R * h_p)
    Omega4 = Omega2 * Omega2
    return (
        (2.0 * F_0 * Omega4 * forcing_p - F_Omega * frequency_p - F_p) / F_A,
        frequency_p,
        forcing_p,
        F_A,
        2.0 * (Omega2 + np.abs(h_A)) * (t0 + np.abs(h)) + 2.0 * (t4 + np.abs(I_0)) * (t5 + np.abs(I_0A)),
        1.0,
        1.0,
    )


def moves_of_fold(Omega, A, F_0, I_0, I_0A, I_0AA, I_0AAA, zeta, d, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, I_0p, I_0Ap, I_0AAp, zeta_p, d_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of a fold at a forcing; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 229 structured, 121 common subexpressions, 118 power chains.
    Measured, error / u (1 + kappa): 97
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * A * Omega2
    t2 = 2.0 * Omega
    t3 = t2 * zeta
    t4 = A * t3 + d * t1
    I = I_0 + t4
    t5 = 2.0 * d
    t6 = Omega2 + h_A
    t7 = t0 * t5 + t3
    t8 = I_0A + t7
    F_AA = 2.0 * (I * I_0AA + I * Omega2 * t5 + R * h_AA + t6 * t6 + t8 * t8)
    t9 = Omega * R
    t10 = A * Omega
    t11 = A * t2
    t12 = d * t10 + zeta
    F_AOmega = 4.0 * (A * t12 * t8 + I * (d * t11 + zeta) + t10 * t6 + t9)
    Omega3 = Omega * Omega2
    t13 = 4.0 * F_0 * F_0 * Omega3
    t14 = 4.0 * A
    F_Omega = -t13 + t14 * (I * t12 + t9)
    t15 = I_0p + d_p * t1 + t11 * zeta_p
    F_p = 2.0 * (I * t15 + R * h_p)
    F_Ap = 2.0 * (I * I_0Ap + 2.0 * I * d_p * t0 + I * t2 * zeta_p + R * h_Ap + h_p * t6 + t15 * t8)
    t16 = 1.0 / F_Omega
    Omega4 = Omega2 * Omega2
    t17 = 2.0 * F_0 * Omega4 * forcing_p
    t18 = t0 + np.abs(h)
    t19 = t4 + np.abs(I_0)
    t20 = Omega2 + np.abs(h_A)
    t21 = t7 + np.abs(I_0A)
    return (
        -t16 * (-F_AOmega * F_p + F_AOmega * t17 + F_Ap * F_Omega) / F_AA,
        t16 * (-F_p + t17),
        forcing_p,
        F_AA,
        4.0 * Omega2 * d * t19 + 2.0 * t18 * np.abs(h_AA) + 2.0 * t19 * np.abs(I_0AA) + 2.0 * t20 * t20 + 2.0 * t21
        * t21,
        F_Omega,
        t13 + t14 * (Omega * t18 + t12 * t19),
    )


def moves_of_corner_fold(Omega, A, F_0, I_0, I_0A, I_0AA, I_0AAA, zeta, d, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, I_0p, I_0Ap, I_0AAp, zeta_p, d_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of a fold at a forcing, on a breakpoint; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 91 structured, 62 common subexpressions, 59 power chains.
    Proved, error / u (1 + kappa): 0.0, -, 0.0, -, -, 0.0, 0.0
    Measured, error / u (1 + kappa): 0.42
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * A * Omega2
    t2 = 2.0 * Omega
    t3 = t2 * zeta
    t4 = A * t3 + d * t1
    I = I_0 + t4
    F_A = 2.0 * (I * (I_0A + 2.0 * d * t0 + t3) + R * (Omega2 + h_A))
    Omega3 = Omega * Omega2
    t5 = 4.0 * F_0 * F_0 * Omega3
    t6 = A * Omega * d + zeta
    t7 = 4.0 * A
    F_Omega = -t5 + t7 * (I * t6 + Omega * R)
    F_p = 2.0 * (I * (A * t2 * zeta_p + I_0p + d_p * t1) + R * h_p)
    Omega4 = Omega2 * Omega2
    return (
        end_p,
        (2.0 * F_0 * Omega4 * forcing_p - F_A * end_p - F_p) / F_Omega,
        forcing_p,
        F_Omega,
        t5 + t7 * (Omega * (t0 + np.abs(h)) + t6 * (t4 + np.abs(I_0))),
        1.0,
        1.0,
    )


def moves_of_peak(Omega, A, F_0, I_0, I_0A, I_0AA, I_0AAA, zeta, d, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, I_0p, I_0Ap, I_0AAp, zeta_p, d_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of a peak at a forcing; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 201 structured, 108 common subexpressions, 105 power chains.
    Measured, error / u (1 + kappa): 14
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * A * Omega2
    t2 = 2.0 * Omega
    t3 = t2 * zeta
    t4 = A * t3 + d * t1
    I = I_0 + t4
    t5 = Omega2 + h_A
    t6 = 2.0 * t0
    t7 = d * t6 + t3
    t8 = I_0A + t7
    F_A = 2.0 * (I * t8 + R * t5)
    t9 = A * Omega
    t10 = A * d
    t11 = d * t9 + zeta
    F_AOmega = 4.0 * (A * t11 * t8 + I * (t10 * t2 + zeta) + Omega * R + t5 * t9)
    t12 = 12.0 * F_0 * F_0 * Omega2
    t13 = 2.0 * A * t11 * t11
    t14 = 4.0 * A
    F_OmegaOmega = -t12 + t14 * (I * t10 + R + t13 + t6)
    t15 = A * t2 * zeta_p + I_0p + d_p * t1
    F_p = 2.0 * (I * t15 + R * h_p)
    F_Omegap = t14 * (I * d_p * t9 + I * zeta_p + Omega * h_p + t11 * t15)
    t16 = 1.0 / F_A
    t17 = F_0 * forcing_p
    Omega4 = Omega2 * Omega2
    t18 = 2.0 * Omega4 * t17
    t19 = np.abs(h)
    t20 = t4 + np.abs(I_0)
    Omega3 = Omega * Omega2
    return (
        t16 * (-F_p + t18),
        t16 * (-F_A * F_Omegap + 8.0 * F_A * Omega3 * t17 + F_AOmega * F_p - F_AOmega * t18) / F_OmegaOmega,
        forcing_p,
        F_A,
        2.0 * t20 * (t7 + np.abs(I_0A)) + 2.0 * (Omega2 + np.abs(h_A)) * (t0 + t19),
        F_OmegaOmega,
        t12 + t14 * (3.0 * t0 + t10 * t20 + t13 + t19),
    )


def moves_of_cusp(Omega, A, F_0, I_0, I_0A, I_0AA, I_0AAA, zeta, d, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, I_0p, I_0Ap, I_0AAp, zeta_p, d_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of where two folds meet; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 391 structured, 171 common subexpressions, 168 power chains.
    Measured, error / u (1 + kappa): 4.7
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * A
    t2 = Omega2 * d
    t3 = 2.0 * Omega
    t4 = t3 * zeta
    t5 = A * t4 + t1 * t2
    I = I_0 + t5
    t6 = Omega2 + h_A
    t7 = 2.0 * t0
    t8 = d * t7
    t9 = t4 + t8
    t10 = I_0A + t9
    t11 = 2.0 * t10
    t12 = 2.0 * t2
    t13 = I_0AA + t12
    F_AAA = 2.0 * (I * I_0AAA + I_0AA * t11 + R * h_AAA + 3.0 * h_AA * t6 + t10 * t13 + 4.0 * t10 * t2)
    t14 = Omega * R
    t15 = A * Omega
    t16 = d * t3
    t17 = A * t16 + zeta
    t18 = d * t15 + zeta
    t19 = A * t18
    F_AOmega = 4.0 * (I * t17 + t10 * t19 + t14 + t15 * t6)
    F_AAOmega = 4.0 * (I * t16 + I_0AA * t19 + h_AA * t15 + t11 * t17 + t18 * t8 + t3 * t6)
    Omega3 = Omega * Omega2
    F_Omega = 4.0 * A * (I * t18 + t14) - 4.0 * F_0 * F_0 * Omega3
    t20 = t3 * zeta_p
    t21 = Omega2 * d_p
    t22 = A * t20 + I_0p + t1 * t21
    F_p = 2.0 * (I * t22 + R * h_p)
    F_Ap = 2.0 * (I * I_0Ap + I * d_p * t7 + I * t20 + R * h_Ap + h_p * t6 + t10 * t22)
    t23 = 4.0 * Omega
    F_AAp = (
        2.0 * (I * I_0AAp + I_0Ap * t11 + R * h_AAp + h_AA * h_p + 2.0 * h_Ap * t6 + t10 * t23 * zeta_p + t13 * t22
        + 2.0 * t21 * (A * t11 + I))
    )
    t24 = 1.0 / F_AOmega
    t25 = Omega2 + np.abs(h_A)
    t26 = t0 + np.abs(h)
    t27 = np.abs(I_0AA)
    t28 = t9 + np.abs(I_0A)
    t29 = 4.0 * t28
    t30 = t5 + np.abs(I_0)
    Omega4 = Omega2 * Omega2
    return (
        t24 * (F_AAOmega * F_Ap - F_AAp * F_AOmega) / F_AAA,
        -F_Ap * t24,
        0.5 * t24 * (F_AOmega * F_p - F_Ap * F_Omega) / (F_0 * Omega4),
        F_AAA,
        8.0 * t2 * t28 + 6.0 * t25 * np.abs(h_AA) + 2.0 * t26 * np.abs(h_AAA) + t27 * t29 + 2.0 * t28 * (t12 + t27)
        + 2.0 * t30 * np.abs(I_0AAA),
        F_AOmega,
        4.0 * t15 * t25 + 4.0 * t17 * t30 + t19 * t29 + t23 * t26,
    )


def moves_of_isola(Omega, A, F_0, I_0, I_0A, I_0AA, I_0AAA, zeta, d, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, I_0p, I_0Ap, I_0AAp, zeta_p, d_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of where an isolated curve is born; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 326 structured, 156 common subexpressions, 154 power chains.
    Measured, error / u (1 + kappa): 2.7
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * A * Omega2
    t2 = 2.0 * Omega
    t3 = t2 * zeta
    t4 = A * t3 + d * t1
    I = I_0 + t4
    t5 = Omega2 * d
    t6 = Omega2 + h_A
    t7 = 2.0 * t0
    t8 = d * t7 + t3
    t9 = I_0A + t8
    F_AA = 2.0 * (I * I_0AA + 2.0 * I * t5 + R * h_AA + t6 * t6 + t9 * t9)
    t10 = A * Omega
    t11 = A * d
    t12 = t11 * t2 + zeta
    t13 = d * t10 + zeta
    t14 = A * t13
    F_AOmega = 4.0 * (I * t12 + Omega * R + t10 * t6 + t14 * t9)
    t15 = 12.0 * F_0 * F_0 * Omega2
    t16 = 2.0 * A * t13 * t13
    t17 = 4.0 * A
    F_OmegaOmega = -t15 + t17 * (I * t11 + R + t16 + t7)
    t18 = A * t2 * zeta_p + I_0p + d_p * t1
    F_p = 2.0 * (I * t18 + R * h_p)
    t19 = I * zeta_p
    t20 = I * d_p
    F_Ap = 2.0 * (I * I_0Ap + R * h_Ap + h_p * t6 + t18 * t9 + t19 * t2 + t20 * t7)
    F_Omegap = t17 * (Omega * h_p + t10 * t20 + t13 * t18 + t19)
    t21 = 4.0 * F_p
    t22 = F_Ap * Omega
    t23 = F_AA * F_OmegaOmega - F_AOmega * F_AOmega
    t24 = 1.0 / (Omega * t23)
    t25 = Omega2 + np.abs(h_A)
    t26 = np.abs(h)
    t27 = t0 + t26
    t28 = t8 + np.abs(I_0A)
    t29 = t4 + np.abs(I_0)
    t30 = 4.0 * t29
    Omega4 = Omega2 * Omega2
    t31 = 4.0 * Omega * t27 + 4.0 * t10 * t25 + t12 * t30 + 4.0 * t14 * t28
    return (
        t24 * (F_AOmega * F_Omegap * Omega - F_AOmega * t21 - F_OmegaOmega * t22),
        -t24 * (F_AA * F_Omegap * Omega - F_AA * t21 - F_AOmega * t22),
        0.5 * F_p / (F_0 * Omega4),
        t23,
        t31 * t31 + (t15 + t17 * (3.0 * t0 + t11 * t29 + t16 + t26)) * (2.0 * t25 * t25 + 2.0 * t27 * np.abs(h_AA) +
        2.0 * t28 * t28 + 2.0 * t29 * np.abs(I_0AA) + t30 * t5),
        1.0,
        1.0,
    )


def moves_of_corner_top(Omega, A, F_0, I_0, I_0A, I_0AA, I_0AAA, zeta, d, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, I_0p, I_0Ap, I_0AAp, zeta_p, d_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of the least forcing on a breakpoint; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 161 structured, 94 common subexpressions, 92 power chains.
    Proved, error / u (1 + kappa): 0.0, -, -, -, -, 0.0, 0.0
    Measured, error / u (1 + kappa): 0.5
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * A * Omega2
    t2 = 2.0 * Omega
    t3 = t2 * zeta
    t4 = A * t3 + d * t1
    I = I_0 + t4
    t5 = Omega2 + h_A
    t6 = 2.0 * t0
    t7 = I_0A + d * t6 + t3
    F_A = 2.0 * (I * t7 + R * t5)
    t8 = A * Omega
    t9 = A * d
    t10 = d * t8 + zeta
    F_AOmega = 4.0 * (A * t10 * t7 + I * (t2 * t9 + zeta) + Omega * R + t5 * t8)
    t11 = 12.0 * F_0 * F_0 * Omega2
    t12 = 2.0 * A * t10 * t10
    t13 = 4.0 * A
    F_OmegaOmega = -t11 + t13 * (I * t9 + R + t12 + t6)
    t14 = A * t2 * zeta_p + I_0p + d_p * t1
    F_p = 2.0 * (I * t14 + R * h_p)
    F_Omegap = t13 * (I * d_p * t8 + I * zeta_p + Omega * h_p + t10 * t14)
    t15 = F_A * end_p
    Omega4 = Omega2 * Omega2
    return (
        end_p,
        (-F_AOmega * Omega * end_p - F_Omegap * Omega + 4.0 * F_p + 4.0 * t15) / (F_OmegaOmega * Omega),
        0.5 * (F_p + t15) / (F_0 * Omega4),
        F_OmegaOmega,
        t11 + t13 * (3.0 * t0 + t12 + t9 * (t4 + np.abs(I_0)) + np.abs(h)),
        1.0,
        1.0,
    )


def moves_of_corner_end(Omega, A, F_0, I_0, I_0A, I_0AA, I_0AAA, zeta, d, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, I_0p, I_0Ap, I_0AAp, zeta_p, d_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of where the fold locus meets a breakpoint; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 188 structured, 110 common subexpressions, 107 power chains.
    Measured, error / u (1 + kappa): 31
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * A * Omega2
    t2 = 2.0 * Omega
    t3 = t2 * zeta
    t4 = A * t3 + d * t1
    I = I_0 + t4
    t5 = 2.0 * d
    t6 = Omega2 + h_A
    t7 = t0 * t5 + t3
    t8 = I_0A + t7
    F_AA = 2.0 * (I * I_0AA + I * Omega2 * t5 + R * h_AA + t6 * t6 + t8 * t8)
    t9 = Omega * R
    t10 = A * Omega
    t11 = A * t2
    t12 = d * t11 + zeta
    t13 = d * t10 + zeta
    t14 = A * t13
    F_AOmega = 4.0 * (I * t12 + t10 * t6 + t14 * t8 + t9)
    Omega3 = Omega * Omega2
    F_Omega = 4.0 * A * (I * t13 + t9) - 4.0 * F_0 * F_0 * Omega3
    t15 = I_0p + d_p * t1 + t11 * zeta_p
    F_p = 2.0 * (I * t15 + R * h_p)
    F_Ap = 2.0 * (I * I_0Ap + 2.0 * I * d_p * t0 + I * t2 * zeta_p + R * h_Ap + h_p * t6 + t15 * t8)
    t16 = 1.0 / F_AOmega
    t17 = F_AA * end_p
    Omega4 = Omega2 * Omega2
    return (
        end_p,
        -t16 * (F_Ap + t17),
        -0.5 * t16 * (-F_AOmega * F_p + F_Ap * F_Omega + F_Omega * t17) / (F_0 * Omega4),
        F_AOmega,
        4.0 * Omega * (t0 + np.abs(h)) + 4.0 * t10 * (Omega2 + np.abs(h_A)) + 4.0 * t12 * (t4 + np.abs(I_0)) + 4.0 *
        t14 * (t7 + np.abs(I_0A)),
        1.0,
        1.0,
    )


def moves_of_corner_backbone(Omega, A, F_0, I_0, I_0A, I_0AA, I_0AAA, zeta, d, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, I_0p, I_0Ap, I_0AAp, zeta_p, d_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of where the backbone meets a breakpoint; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 67 structured, 53 common subexpressions, 50 power chains.
    Proved, error / u (1 + kappa): 0.0, 4.34, -, 0.34, 0.34, 0.0, 0.0
    Measured, error / u (1 + kappa): 0.79
    """
    t0 = 2.0 * Omega
    t1 = t0 * zeta
    Omega2 = Omega * Omega
    t2 = A * A * Omega2
    I = A * t1 + I_0 + d * t2
    t3 = A * d
    t4 = 2.0 * I
    F_A = t4 * (I_0A + 2.0 * Omega2 * t3 + t1)
    Omega3 = Omega * Omega2
    F_Omega = 4.0 * A * I * (Omega * t3 + zeta) - 4.0 * F_0 * F_0 * Omega3
    R_A = Omega2 + h_A
    t5 = A * t0
    F_p = t4 * (I_0p + d_p * t2 + t5 * zeta_p)
    t6 = 1.0 / t5
    t7 = R_A * end_p
    Omega4 = Omega2 * Omega2
    return (
        end_p,
        -t6 * (h_p + t7),
        0.5 * t6 * (F_A * end_p * t5 - F_Omega * h_p - F_Omega * t7 + F_p * t5) / (F_0 * Omega4),
        t5,
        t5,
        1.0,
        1.0,
    )


def moves_of_corner_rest(Omega, A, F_0, I_0, I_0A, I_0AA, I_0AAA, zeta, d, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, I_0p, I_0Ap, I_0AAp, zeta_p, d_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of at Omega = 0 on a breakpoint; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 63 structured, 53 common subexpressions, 50 power chains.
    Proved, error / u (1 + kappa): 0.0, 0.0, -, 0.0, 0.0, 0.0, 0.0
    Measured, error / u (1 + kappa): 0.55
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * Omega
    t2 = t1 * zeta
    t3 = A * A * Omega2
    I = A * t2 + I_0 + d * t3
    F_A = 2.0 * (I * (I_0A + 2.0 * d * t0 + t2) + R * (Omega2 + h_A))
    Omega3 = Omega * Omega2
    F_Omega = 4.0 * A * (I * (A * Omega * d + zeta) + Omega * R) - 4.0 * F_0 * F_0 * Omega3
    F_p = 2.0 * (I * (A * t1 * zeta_p + I_0p + d_p * t3) + R * h_p)
    Omega4 = Omega2 * Omega2
    return (
        end_p,
        frequency_p,
        0.5 * (F_A * end_p + F_Omega * frequency_p + F_p) / (F_0 * Omega4),
        1.0,
        1.0,
        1.0,
        1.0,
    )


def beside(Omega, A, F_0, I_0, I_0A, zeta, d, h, h_A):
    """F_A, F_Omega and R, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast.
    Operations: 103 structured, 52 common subexpressions, 51 power chains.
    Measured, error / u (1 + kappa): 0.55
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * Omega * zeta
    t2 = A * A * Omega2 * d + A * t1
    I = I_0 + t2
    t3 = 2.0 * d * t0 + t1
    F_A = 2.0 * (I * (I_0A + t3) + R * (Omega2 + h_A))
    Omega3 = Omega * Omega2
    t4 = 4.0 * F_0 * F_0 * Omega3
    t5 = A * Omega * d + zeta
    t6 = 4.0 * A
    F_Omega = -t4 + t6 * (I * t5 + Omega * R)
    t7 = t0 + np.abs(h)
    t8 = t2 + np.abs(I_0)
    return (
        F_A,
        2.0 * t7 * (Omega2 + np.abs(h_A)) + 2.0 * t8 * (t3 + np.abs(I_0A)),
        F_Omega,
        t4 + t6 * (Omega * t7 + t5 * t8),
        R,
        t7,
    )


def moves_of_phase(Omega, A, F_0, I_0, I_0A, zeta, d, h, h_A, h_p, I_0p, zeta_p, d_p, A_p, Omega_p, F_0_p):
    """d/dp of the phase (25) and of the transmissibility of a state that moves by A_p, Omega_p, F_0_p.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 2 results, each the arguments that it depends on,
    broadcast.
    Operations: 80 structured, 61 common subexpressions, 61 power chains.
    Measured, error / u (1 + kappa): 0.93
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
    t7 = 2.0 * Omega_p
    I_moved = (
        A * t7 * zeta + A_p * I_0A + 2.0 * A_p * d * t1 + A_p * t2 * zeta + I_0p + Omega_p * d * t2 * t4 + d_p * t5
        + t3 * zeta_p
    )
    t8 = 1.0 / F_0
    t9 = np.hypot(h, I)
    t10 = 1.0 / t9
    return (
        (-I * R_moved + I_moved * R) / (I * I + R * R),
        t8 * (-F_0_p * t8 * t9 + I * I_moved * t10 + h * t10 * t6 - t7 * t9 / Omega) / t0,
    )


# by the numbers of `conventions.Pinned`
MOVES = (
    moves_of_state, moves_of_fold, moves_of_corner_fold, moves_of_peak, moves_of_cusp, moves_of_isola,
    moves_of_corner_top, moves_of_corner_end, moves_of_corner_backbone, moves_of_corner_rest,
)
