"""Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/oscillator.py, derivations/averaging.py, derivations/slow_flow.py, derivations/inertia.py, derivations/gradients.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless. Arguments broadcast; outputs have their common shape, NumPy scalars for scalars. Each
docstring gives equation number, domain, shape and the operations after each pass.
Rounding errors are in u (1 + kappa), u = 2^-53: proved ones hold wherever nothing overflows or underflows, measured
ones are the worst of all outputs that was found, by a search for it with A 0.01 to 1, F_0 0.03 to 0.1, Omega 0.3 to
2, cubic up to 1 of either sign, fall 0.001 to 1, force 0.001 to 0.1, h 0.001 to 1 of either sign, h_A up to 2 of
either sign, h_AA up to 5 of either sign, h_AAA up to 20 of either sign, holds 0.001 to 0.1, k 0.04 to 4, linear
0.0001 to 0.03, lost 0.001 to 0.5, m 0.001 to 0.03, other up to 1 of either sign, rest 0.001 to 1, share up to 0.5
of either sign, x 0.5 to 3, zeta 0.004 to 0.1.
"""

# a formatter would spread each polynomial over a page
# fmt: off

import numpy as np

from slowflow_support.backend import NATIVE, compiled
from slowflow_support.broadcast import by_regime, common_shape, floats, full

__all__ = [
    "MOVES", "F", "Omega_A", "Omega_of_share", "amplitude", "beside", "bound", "cusp_bend", "fold_force",
    "fold_level", "fold_slopes", "force", "force_slopes", "hessian", "isola", "isola_apart", "least",
    "least_Omega_A", "level", "level_rise", "level_slope", "moves_from", "moves_of_corner_backbone",
    "moves_of_corner_end", "moves_of_corner_fold", "moves_of_corner_rest", "moves_of_corner_top", "moves_of_cusp",
    "moves_of_fold", "moves_of_isola", "moves_of_peak", "moves_of_phase", "moves_of_state", "outer", "peak",
    "peak_share", "share", "terms",
]


def force(Omega, F_0):
    """Amplitude of the force on the mass.

    Equation beside (3). Domain: Omega >= 0. Shape: as the arguments broadcast.
    Operations: 2 structured, 2 common subexpressions, 2 power chains.
    Proved, error / u (1 + kappa): 0.51
    """
    Omega, F_0 = floats(Omega, F_0)
    return F_0 * Omega * Omega


def force_slopes(Omega, F_0):
    """Its slopes by Omega, F_0.

    Equation beside (3). Domain: Omega >= 0. Shape: 2 results, each as the arguments broadcast.
    Operations: 3 structured, 3 common subexpressions, 3 power chains.
    Proved, error / u (1 + kappa): 0.34, 0.34
    """
    Omega, F_0 = floats(Omega, F_0)
    shape = common_shape((Omega, F_0))
    return (
        2.0 * F_0 * Omega,
        full(Omega * Omega, shape),
    )


def amplitude(Omega, force):
    """The F_0 of a force at one frequency.

    Equation beside (3). Domain: Omega > 0. Shape: as the arguments broadcast.
    Operations: 2 structured, 2 common subexpressions, 2 power chains.
    Proved, error / u (1 + kappa): 0.51
    """
    Omega, force = floats(Omega, force)
    return force / (Omega * Omega)


def moves_from(F_0, holds):
    """The Omega from which on the force exceeds what holds a mass at rest, 4 mu/pi on the average.

    Equation beside (3). Domain: F_0 > 0, holds >= 0. Shape: as the arguments broadcast.
    Operations: 2 structured, 2 common subexpressions, 2 power chains.
    Measured, error / u (1 + kappa): 0.61
    """
    F_0, holds = floats(F_0, holds)
    turn = holds / F_0
    return np.sqrt(turn)


def level(Omega, A, m, zeta, h):
    """The amplitude F_0 of the excitation for which (Omega, A) is a steady state.

    Equation from (24). Domain: Omega > 0, A > 0. Shape: as the arguments broadcast.
    Operations: 13 structured, 12 common subexpressions, 12 power chains.
    Measured, error / u (1 + kappa): 1.3
    """
    Omega, A, m, zeta, h = floats(Omega, A, m, zeta, h)
    t0 = Omega * Omega
    R = A * t0 + h
    I = 2.0 * A * Omega * zeta + m
    return np.sqrt(I * I + R * R) / t0


def F(Omega, A, F_0, m, zeta, h):
    """Zero at a steady state.

    Equation from (24). Domain: Omega > 0, A > 0. Shape: as the arguments broadcast.
    Operations: 16 structured, 13 common subexpressions, 13 power chains.
    Measured, error / u (1 + kappa): 0.81
    """
    Omega, A, F_0, m, zeta, h = floats(Omega, A, F_0, m, zeta, h)
    t0 = Omega * Omega
    R = A * t0 + h
    I = 2.0 * A * Omega * zeta + m
    t1 = F_0 * t0
    return R * R + (I - t1) * (I + t1)


def level_slope(Omega, A, m, zeta, h):
    """Omega^5 times the derivative of level^2 by Omega.

    Equation from (24). Domain: Omega > 0, A > 0. Shape: as the arguments broadcast.
    Operations: 15 structured, 13 common subexpressions, 13 power chains.
    Proved, error / u (1 + kappa): 5.26
    """
    Omega, A, m, zeta, h = floats(Omega, A, m, zeta, h)
    R = A * Omega * Omega + h
    t0 = A * Omega * zeta
    I = m + 2.0 * t0
    return -4.0 * I * (m + t0) - 4.0 * R * h


def Omega_A(Omega, A, m, zeta, h, h_A):
    """dOmega/dA along the response.

    Equation from (24). Domain: Omega > 0, A > 0. Shape: as the arguments broadcast.
    Operations: 25 structured, 21 common subexpressions, 21 power chains.
    Measured, error / u (1 + kappa): 1.1
    """
    Omega, A, m, zeta, h, h_A = floats(Omega, A, m, zeta, h, h_A)
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = Omega * zeta
    t2 = A * t1
    I = m + 2.0 * t2
    return -2.0 * Omega * (2.0 * I * t1 + R * (h_A + t0)) / (-4.0 * I * (m + t2) - 4.0 * R * h)


def _outer_falling(A, F_0, m, zeta, h):
    # operations: 36 structured, 31 common subexpressions, 30 power chains
    t0 = zeta * zeta
    t1 = A * t0
    falls = -A * (h + 2.0 * t1)
    t2 = m * m
    square = h * h + t2
    over = (A - F_0) * (A + F_0)
    A2 = A * A
    A3 = A * A2
    inner = -A2 * t2 + 4.0 * A3 * t0 * (h + t1) + F_0 * F_0 * square
    spread = np.sqrt(0.5 * inner + 0.5 * np.abs(inner))
    t3 = falls + spread
    return (
        t3 / square,
        over / t3,
    )


def _outer_rising(A, F_0, m, zeta, h):
    # operations: 36 structured, 31 common subexpressions, 30 power chains
    t0 = zeta * zeta
    t1 = A * t0
    falls = -A * (h + 2.0 * t1)
    t2 = m * m
    square = h * h + t2
    over = (A - F_0) * (A + F_0)
    A2 = A * A
    A3 = A * A2
    inner = -A2 * t2 + 4.0 * A3 * t0 * (h + t1) + F_0 * F_0 * square
    spread = np.sqrt(0.5 * inner + 0.5 * np.abs(inner))
    t3 = falls - spread
    return (
        over / t3,
        t3 / square,
    )


def outer(A, F_0, m, zeta, h):
    """1/Omega^2 below the low frequency of an amplitude, and above the high one, where it has that.

    Equation from (24). Domain: A > 0, where F has a root. Shape: 2 results, each as the arguments broadcast.
    Measured, error / u (1 + kappa): 1.1
    """
    arguments = floats(A, F_0, m, zeta, h)
    A, F_0, m, zeta, h = arguments
    guards = (2.0 * A * zeta * zeta + h <= 0.0,)
    bodies = (_outer_falling, _outer_rising)
    return by_regime(guards, bodies, arguments, 2)


def terms(A, m, zeta, h):
    """What the least level of an amplitude follows from; it has one where the first, fall, is positive.

    Equation from (24). Domain: A > 0. Shape: 3 results, each as the arguments broadcast.
    Operations: 11 structured, 11 common subexpressions, 11 power chains.
    Proved, error / u (1 + kappa): 1.61, 0.76, 0.67
    """
    A, m, zeta, h = floats(A, m, zeta, h)
    shape = common_shape((A, m, zeta, h))
    return (
        full(-A * (2.0 * A * zeta * zeta + h), shape),
        full(12.0 * A * m * zeta, shape),
        full(h * h + m * m, shape),
    )


def least(fall, linear, rest):
    """x = 1/Omega where the level of an amplitude is least, by its `terms`.

    Equation from (24). Domain: fall > 0, linear >= 0, rest > 0. Shape: as the arguments broadcast.
    Operations: 8 structured, 8 common subexpressions, 8 power chains.
    Measured, error / u (1 + kappa): 1.3
    """
    fall, linear, rest = floats(fall, linear, rest)
    return 8.0 * fall / (linear + np.sqrt(64.0 * fall * rest + linear * linear))


def least_Omega_A(x, A, m, zeta, h, h_A):
    """dOmega/dA where the level of an amplitude is least: what a rounding of A does to Omega there.

    Equation from (24). Domain: x of `least`, h < 0. Shape: as the arguments broadcast.
    Operations: 28 structured, 24 common subexpressions, 24 power chains.
    Measured, error / u (1 + kappa): 1.7
    """
    x, A, m, zeta, h, h_A = floats(x, A, m, zeta, h, h_A)
    t0 = x * x
    t1 = 3.0 * m * zeta
    t2 = 2.0 * x
    return (
        (4.0 * A * zeta * zeta + h + h_A * (A + 2.0 * h * t0) + t1 * x) / (t0 * (A * t1 + h * h * t2 + m * m * t2))
    )


def peak(x, A, F_0, m, zeta, h, h_A):
    """The least level of an amplitude less F_0, and its slope along A.

    Equation from (24). Domain: x of `least`, h < 0. Shape: 2 results, each as the arguments broadcast.
    Operations: 23 structured, 19 common subexpressions, 19 power chains.
    Measured, error / u (1 + kappa): 0.87
    """
    x, A, F_0, m, zeta, h, h_A = floats(x, A, F_0, m, zeta, h, h_A)
    t0 = A * zeta
    t1 = m * x
    drag = t0 + t1
    share = drag / h
    t2 = x * x
    root = np.sqrt(share * share + t2)
    shape = common_shape((x, A, F_0, m, zeta, h, h_A))
    return (
        full(-F_0 + root * (2.0 * t0 + t1), shape),
        full((-share * (h_A * t2 + 1.0) + 2.0 * t2 * zeta) / root, shape),
    )


def isola(x, A, m, zeta, h, h_A, h_AA):
    """Has the sign of F_A where an amplitude's level is least: zero at an isola point; its slope along A.

    Equation from (24), (30). Domain: x of `least`, h < 0. Shape: 2 results, each as the arguments broadcast.
    Operations: 73 structured, 50 common subexpressions, 50 power chains.
    Measured, error / u (1 + kappa): 1.2
    """
    x, A, m, zeta, h, h_A, h_AA = floats(x, A, m, zeta, h, h_A, h_AA)
    t0 = A * zeta
    t1 = m * x
    t2 = t0 + t1
    t3 = x * x
    t4 = h * t3
    t5 = 2.0 * zeta
    t6 = h_A * t3
    t7 = t6 + 1.0
    t8 = 8.0 * x
    t9 = 4.0 * h
    shape = common_shape((x, A, m, zeta, h, h_A, h_AA))
    return (
        full(t2 * t7 - t4 * t5, shape),
        h_AA * t2 * t3 - t5 * t6 + t7 * zeta + (2.0 * h_A * t2 * x + m * t7 - t9 * x * zeta) * (16.0 * A * zeta *
        zeta - h_A * (-4.0 * A - 8.0 * t4) + 12.0 * t1 * zeta + t9) / (-h * h * t8 - m * m * t8 - 12.0 * m * t0),
    )


def isola_apart(x, A, m, zeta, h, k, cubic):
    """The same without its slope by k = h - A h_A and cubic = 3 h - A h_A, small where h is like A^3.

    Equation from (24), (30). Domain: x of `least`, h < 0. Shape: as the arguments broadcast.
    Operations: 21 structured, 18 common subexpressions, 17 power chains.
    Measured, error / u (1 + kappa): 1.1
    """
    x, A, m, zeta, h, k, cubic = floats(x, A, m, zeta, h, k, cubic)
    t0 = A * zeta
    t1 = m * x
    drag = t0 + t1
    x2 = x * x
    x3 = x * x2
    return (-cubic * t0 * x2 + drag * drag * (-2.0 * t0 - t1) / h - k * m * x3) / A


def fold_slopes(Omega, A, m, zeta, k):
    """dR/dA at a fold by k = h - A h_A: of the two with F_A = 0 the larger, the other; -R/I with the first.

    Equation from (30). Domain: Omega > 0, A > 0, zeta > 0, k other than 0. Shape: 3 results, each as the arguments
    broadcast.
    Operations: 28 structured, 24 common subexpressions, 24 power chains.
    Measured, error / u (1 + kappa): 1.1
    """
    Omega, A, m, zeta, k = floats(Omega, A, m, zeta, k)
    t0 = 2.0 * Omega * zeta
    I = A * t0 + m
    part = -8.0 * A * I * Omega * zeta / (k * k) + 1.0
    root = np.sqrt(0.5 * part + 0.5 * np.abs(part))
    t1 = 1.0 / A
    steep = -0.5 * k * t1 * (root + 1.0)
    t2 = t0 / steep
    return (
        steep,
        I * t1 * t2,
        t2,
    )


def fold_force(Omega, A, m, zeta, other):
    """The F_0 of a force at a fold, by the one of `fold_slopes` that is not its own.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Shape: as the arguments broadcast.
    Operations: 10 structured, 10 common subexpressions, 10 power chains.
    Measured, error / u (1 + kappa): 0.91
    """
    Omega, A, m, zeta, other = floats(Omega, A, m, zeta, other)
    I = 2.0 * A * Omega * zeta + m
    return np.sqrt(A * A * other * other + I * I)


def fold_level(Omega, A, m, zeta, other):
    """The F_0 of a fold, by the one of `fold_slopes` that is not its own.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Shape: as the arguments broadcast.
    Operations: 12 structured, 12 common subexpressions, 12 power chains.
    Measured, error / u (1 + kappa): 0.73
    """
    Omega, A, m, zeta, other = floats(Omega, A, m, zeta, other)
    I = 2.0 * A * Omega * zeta + m
    return np.sqrt(A * A * other * other + I * I) / (Omega * Omega)


def peak_share(Omega, A, m, zeta):
    """-R/I where the level is least and R small beside A Omega^2.

    Equation from (24). Domain: Omega > 0, A > 0, zeta > 0. Shape: as the arguments broadcast.
    Operations: 29 structured, 24 common subexpressions, 22 power chains.
    Measured, error / u (1 + kappa): 1.2
    """
    Omega, A, m, zeta = floats(Omega, A, m, zeta)
    t0 = A * Omega * zeta
    t1 = 2.0 * t0
    I = m + t1
    Omega2 = Omega * Omega
    Omega4 = Omega2 * Omega2
    part = A * A * Omega4 - 4.0 * I * (m + t0)
    root = np.sqrt(0.5 * part + 0.5 * np.abs(part))
    return (-2.0 * m - t1) / (A * Omega2 + root)


def Omega_of_share(A, F_0, m, zeta, share):
    """Omega of a steady state with that -R/I.

    Equation from (24). Domain: A > 0, F_0 > 0. Shape: as the arguments broadcast.
    Operations: 13 structured, 13 common subexpressions, 13 power chains.
    Measured, error / u (1 + kappa): 1.2
    """
    A, F_0, m, zeta, share = floats(A, F_0, m, zeta, share)
    of_I = F_0 / np.sqrt(share * share + 1.0)
    return (A * zeta + np.sqrt(A * A * zeta * zeta + m * of_I)) / of_I


def level_rise(Omega, A, m, zeta, h, h_A, h_AA):
    """Positive where the level rises with A along the fold locus, negative where it falls.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Shape: as the arguments broadcast.
    Operations: 41 structured, 32 common subexpressions, 32 power chains.
    Measured, error / u (1 + kappa): 1.3
    """
    Omega, A, m, zeta, h, h_A, h_AA = floats(Omega, A, m, zeta, h, h_A, h_AA)
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = A * Omega
    t2 = t1 * zeta
    I = m + 2.0 * t2
    t3 = h_A + t0
    t4 = zeta * zeta
    return (
        8.0 * (4.0 * I * (m + t2) + 4.0 * R * h) * (R * h_AA + 4.0 * t0 * t4 + t3 * t3) * (I * zeta + Omega * R + t1
        * t3 + 2.0 * t1 * t4)
    )


def cusp_bend(Omega, A, m, zeta, h, h_A, h_AA, h_AAA):
    """Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum.

    Equation from (24), (30). Domain: Omega > 0, A > 0. Shape: as the arguments broadcast.
    Operations: 37 structured, 30 common subexpressions, 30 power chains.
    Measured, error / u (1 + kappa): 0.87
    """
    Omega, A, m, zeta, h, h_A, h_AA, h_AAA = floats(Omega, A, m, zeta, h, h_A, h_AA, h_AAA)
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = A * Omega
    t2 = t1 * zeta
    I = m + 2.0 * t2
    t3 = h_A + t0
    return (
        8.0 * (4.0 * I * (m + t2) + 4.0 * R * h) * (R * h_AAA + 3.0 * h_AA * t3) * (I * zeta + Omega * R + t1 * t3 +
        2.0 * t1 * zeta * zeta)
    )


def hessian(Omega, A, m, zeta, h, h_A, h_AA):
    """At an isola point: negative where the level has a saddle in (A, Omega).

    Equation from (24), (30). Domain: Omega > 0, A > 0. Shape: as the arguments broadcast.
    Operations: 83 structured, 55 common subexpressions, 55 power chains.
    Measured, error / u (1 + kappa): 1.7
    """
    Omega, A, m, zeta, h, h_A, h_AA = floats(Omega, A, m, zeta, h, h_A, h_AA)
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = 2.0 * A
    t2 = Omega * t1
    I = m + t2 * zeta
    t3 = h_A + t0
    t4 = zeta * zeta
    t5 = 4.0 * t4
    t6 = t0 * t5 + t3 * t3
    G_AOmega = A * Omega * t5 + t2 * t3
    t7 = A * A
    G_OmegaOmega = 4.0 * t0 * t7 + t5 * t7
    t8 = R * h_AA
    t9 = I * zeta
    t10 = Omega * R
    S_AOmega = 2.0 * t10 + 2.0 * t9
    S_OmegaOmega = R * t1
    t11 = 4.0 * S_OmegaOmega
    t12 = -h_A + t0
    return (
        -24.0 * A * (t10 + t9) * (t6 + t8) / Omega - 8.0 * G_AOmega * S_AOmega + 4.0 * G_OmegaOmega * t8 - 4.0 *
        S_AOmega * S_AOmega + t11 * t6 + t11 * t8 + 16.0 * t12 * t12 * t4 * t7
    )


def bound(A, F_0, zeta, h, h_A, h_AA, h_AAA, lost):
    """Positive where no state has an amplitude A > F_0, if zeta^2 A <= lost |h|; three derivatives by A.

    Equation from (24). Domain: A > 0, h < 0, lost <= 1/2. Shape: 4 results, each as the arguments broadcast.
    Operations: 34 structured, 21 common subexpressions, 20 power chains.
    Proved, error / u (1 + kappa): 14.01, 14.01, 12.01, 10.01
    """
    A, F_0, zeta, h, h_A, h_AA, h_AAA, lost = floats(A, F_0, zeta, h, h_A, h_AA, h_AAA, lost)
    t0 = F_0 * F_0
    t1 = zeta * zeta * (1.0 - lost)
    t2 = 24.0 * t1
    A2 = A * A
    A3 = A * A2
    shape = common_shape((A, F_0, zeta, h, h_A, h_AA, h_AAA, lost))
    return (
        full(4.0 * A3 * t1 + h * t0, shape),
        full(12.0 * A2 * t1 + h_A * t0, shape),
        full(A * t2 + h_AA * t0, shape),
        full(h_AAA * t0 + t2, shape),
    )


def share(A, zeta, h):
    """What zeta^2 A is of |h|: `lost` of the `bound`.

    Equation from (24). Domain: h < 0. Shape: as the arguments broadcast.
    Operations: 3 structured, 3 common subexpressions, 3 power chains.
    Proved, error / u (1 + kappa): 0.61
    """
    A, zeta, h = floats(A, zeta, h)
    twice = zeta * zeta
    return -A * twice / h


def moves_of_state(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, m_p, zeta_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of a steady state; with Omega = 0 a peak at rest; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 61 structured, 49 common subexpressions, 46 power chains.
    Proved, error / u (1 + kappa): -, 0.0, 0.0, -, -, 0.0, 0.0
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * Omega
    t2 = A * t1
    t3 = m + t2 * zeta
    t4 = t3 * zeta
    F_A = 2.0 * (R * (Omega2 + h_A) + t1 * t4)
    Omega3 = Omega * Omega2
    F_Omega = 4.0 * A * (Omega * R + t4) - 4.0 * F_0 * F_0 * Omega3
    F_p = 2.0 * (R * h_p + t3 * (m_p + t2 * zeta_p))
    Omega4 = Omega2 * Omega2
    return (
        (2.0 * F_0 * Omega4 * forcing_p - F_Omega * frequency_p - F_p) / F_A,
        frequency_p,
        forcing_p,
        F_A,
        4.0 * Omega * t3 * zeta + 2.0 * (Omega2 + np.abs(h_A)) * (t0 + np.abs(h)),
        1.0,
        1.0,
    )


def moves_of_fold(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, m_p, zeta_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of a fold at a forcing; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 127 structured, 82 common subexpressions, 79 power chains.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * Omega
    t2 = 2.0 * t1
    t3 = m + t2 * zeta
    t4 = Omega2 + h_A
    t5 = zeta * zeta
    t6 = Omega2 * t5
    F_AA = 2.0 * (R * h_AA + t4 * t4 + 4.0 * t6)
    t7 = Omega * R + t3 * zeta
    F_AOmega = 4.0 * (t1 * t4 + t2 * t5 + t7)
    Omega3 = Omega * Omega2
    t8 = 4.0 * F_0 * F_0 * Omega3
    t9 = 4.0 * A
    F_Omega = t7 * t9 - t8
    t10 = m_p + t2 * zeta_p
    F_p = 2.0 * (R * h_p + t10 * t3)
    t11 = 2.0 * Omega
    F_Ap = 2.0 * (R * h_Ap + h_p * t4 + t10 * t11 * zeta + t11 * t3 * zeta_p)
    t12 = 1.0 / F_Omega
    Omega4 = Omega2 * Omega2
    t13 = 2.0 * F_0 * Omega4 * forcing_p
    t14 = t0 + np.abs(h)
    t15 = Omega2 + np.abs(h_A)
    return (
        -t12 * (-F_AOmega * F_p + F_AOmega * t13 + F_Ap * F_Omega) / F_AA,
        t12 * (-F_p + t13),
        forcing_p,
        F_AA,
        2.0 * t14 * np.abs(h_AA) + 2.0 * t15 * t15 + 8.0 * t6,
        F_Omega,
        t8 + t9 * (Omega * t14 + t3 * zeta),
    )


def moves_of_corner_fold(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, m_p, zeta_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of a fold at a forcing, on a breakpoint; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 63 structured, 46 common subexpressions, 43 power chains.
    Proved, error / u (1 + kappa): 0.0, -, 0.0, 4.67, -, 0.0, 0.0
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * Omega
    t2 = A * t1
    t3 = m + t2 * zeta
    t4 = t3 * zeta
    F_A = 2.0 * (R * (Omega2 + h_A) + t1 * t4)
    Omega3 = Omega * Omega2
    t5 = 4.0 * F_0 * F_0 * Omega3
    t6 = 4.0 * A
    F_Omega = -t5 + t6 * (Omega * R + t4)
    F_p = 2.0 * (R * h_p + t3 * (m_p + t2 * zeta_p))
    Omega4 = Omega2 * Omega2
    return (
        end_p,
        (2.0 * F_0 * Omega4 * forcing_p - F_A * end_p - F_p) / F_Omega,
        forcing_p,
        F_Omega,
        t5 + t6 * (Omega * (t0 + np.abs(h)) + t3 * zeta),
        1.0,
        1.0,
    )


def moves_of_peak(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, m_p, zeta_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of a peak at a forcing; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 124 structured, 82 common subexpressions, 79 power chains.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * Omega
    t2 = 2.0 * t1
    t3 = m + t2 * zeta
    t4 = t3 * zeta
    t5 = Omega2 + h_A
    F_A = 2.0 * (2.0 * Omega * t4 + R * t5)
    t6 = 2.0 * zeta * zeta
    F_AOmega = 4.0 * (Omega * R + t1 * t5 + t1 * t6 + t4)
    t7 = 12.0 * F_0 * F_0 * Omega2
    t8 = A * t6
    t9 = 4.0 * A
    F_OmegaOmega = -t7 + t9 * (R + 2.0 * t0 + t8)
    t10 = m_p + t2 * zeta_p
    F_p = 2.0 * (R * h_p + t10 * t3)
    F_Omegap = t9 * (Omega * h_p + t10 * zeta + t3 * zeta_p)
    t11 = 1.0 / F_A
    t12 = F_0 * forcing_p
    Omega4 = Omega2 * Omega2
    t13 = 2.0 * Omega4 * t12
    t14 = np.abs(h)
    Omega3 = Omega * Omega2
    return (
        t11 * (-F_p + t13),
        t11 * (-F_A * F_Omegap + 8.0 * F_A * Omega3 * t12 + F_AOmega * F_p - F_AOmega * t13) / F_OmegaOmega,
        forcing_p,
        F_A,
        4.0 * Omega * t3 * zeta + 2.0 * (Omega2 + np.abs(h_A)) * (t0 + t14),
        F_OmegaOmega,
        t7 + t9 * (3.0 * t0 + t14 + t8),
    )


def moves_of_cusp(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, m_p, zeta_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of where two folds meet; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 145 structured, 105 common subexpressions, 102 power chains.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * Omega
    t2 = 2.0 * t1
    t3 = m + t2 * zeta
    t4 = Omega2 + h_A
    F_AAA = 2.0 * (R * h_AAA + 3.0 * h_AA * t4)
    t5 = zeta * zeta
    t6 = Omega * R + t3 * zeta
    F_AOmega = 4.0 * (t1 * t4 + t2 * t5 + t6)
    t7 = 4.0 * Omega
    F_AAOmega = t7 * (A * h_AA + 2.0 * Omega2 + 2.0 * h_A + 4.0 * t5)
    Omega3 = Omega * Omega2
    F_Omega = 4.0 * A * t6 - 4.0 * F_0 * F_0 * Omega3
    t8 = m_p + t2 * zeta_p
    F_p = 2.0 * (R * h_p + t3 * t8)
    t9 = 2.0 * Omega
    F_Ap = 2.0 * (R * h_Ap + h_p * t4 + t3 * t9 * zeta_p + t8 * t9 * zeta)
    F_AAp = 2.0 * (8.0 * Omega2 * zeta * zeta_p + R * h_AAp + h_AA * h_p + 2.0 * h_Ap * t4)
    t10 = 1.0 / F_AOmega
    t11 = Omega2 + np.abs(h_A)
    t12 = t0 + np.abs(h)
    Omega4 = Omega2 * Omega2
    return (
        t10 * (F_AAOmega * F_Ap - F_AAp * F_AOmega) / F_AAA,
        -F_Ap * t10,
        0.5 * t10 * (F_AOmega * F_p - F_Ap * F_Omega) / (F_0 * Omega4),
        F_AAA,
        6.0 * t11 * np.abs(h_AA) + 2.0 * t12 * np.abs(h_AAA),
        F_AOmega,
        4.0 * t1 * t11 + 8.0 * t1 * t5 + t12 * t7 + 4.0 * t3 * zeta,
    )


def moves_of_isola(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, m_p, zeta_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of where an isolated curve is born; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 181 structured, 113 common subexpressions, 111 power chains.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * Omega
    t2 = 2.0 * t1
    t3 = m + t2 * zeta
    t4 = Omega2 + h_A
    t5 = zeta * zeta
    t6 = Omega2 * t5
    F_AA = 2.0 * (R * h_AA + t4 * t4 + 4.0 * t6)
    t7 = 2.0 * t5
    F_AOmega = 4.0 * (Omega * R + t1 * t4 + t1 * t7 + t3 * zeta)
    t8 = 12.0 * F_0 * F_0 * Omega2
    t9 = A * t7
    t10 = 4.0 * A
    F_OmegaOmega = t10 * (R + 2.0 * t0 + t9) - t8
    t11 = m_p + t2 * zeta_p
    F_p = 2.0 * (R * h_p + t11 * t3)
    t12 = t3 * zeta_p
    t13 = 2.0 * Omega
    t14 = t11 * zeta
    F_Ap = 2.0 * (R * h_Ap + h_p * t4 + t12 * t13 + t13 * t14)
    F_Omegap = t10 * (Omega * h_p + t12 + t14)
    t15 = 4.0 * F_p
    t16 = F_Ap * Omega
    t17 = F_AA * F_OmegaOmega - F_AOmega * F_AOmega
    t18 = 1.0 / (Omega * t17)
    t19 = Omega2 + np.abs(h_A)
    t20 = np.abs(h)
    t21 = t0 + t20
    Omega4 = Omega2 * Omega2
    t22 = 4.0 * Omega * t21 + 4.0 * t1 * t19 + 8.0 * t1 * t5 + 4.0 * t3 * zeta
    return (
        t18 * (F_AOmega * F_Omegap * Omega - F_AOmega * t15 - F_OmegaOmega * t16),
        -t18 * (F_AA * F_Omegap * Omega - F_AA * t15 - F_AOmega * t16),
        0.5 * F_p / (F_0 * Omega4),
        t17,
        t22 * t22 + (t10 * (3.0 * t0 + t20 + t9) + t8) * (2.0 * t19 * t19 + 2.0 * t21 * np.abs(h_AA) + 8.0 * t6),
        1.0,
        1.0,
    )


def moves_of_corner_top(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, m_p, zeta_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of the least forcing on a breakpoint; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 98 structured, 69 common subexpressions, 67 power chains.
    Proved, error / u (1 + kappa): 0.0, -, -, 3.56, -, 0.0, 0.0
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * Omega
    t2 = 2.0 * t1
    I = m + t2 * zeta
    t3 = I * zeta
    t4 = Omega2 + h_A
    F_A = 2.0 * (2.0 * Omega * t3 + R * t4)
    t5 = 2.0 * zeta * zeta
    F_AOmega = 4.0 * (Omega * R + t1 * t4 + t1 * t5 + t3)
    t6 = 12.0 * F_0 * F_0 * Omega2
    t7 = A * t5
    t8 = 4.0 * A
    F_OmegaOmega = -t6 + t8 * (R + 2.0 * t0 + t7)
    t9 = m_p + t2 * zeta_p
    F_p = 2.0 * (I * t9 + R * h_p)
    F_Omegap = t8 * (I * zeta_p + Omega * h_p + t9 * zeta)
    t10 = F_A * end_p
    Omega4 = Omega2 * Omega2
    return (
        end_p,
        (-F_AOmega * Omega * end_p - F_Omegap * Omega + 4.0 * F_p + 4.0 * t10) / (F_OmegaOmega * Omega),
        0.5 * (F_p + t10) / (F_0 * Omega4),
        F_OmegaOmega,
        t6 + t8 * (3.0 * t0 + t7 + np.abs(h)),
        1.0,
        1.0,
    )


def moves_of_corner_end(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, m_p, zeta_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of where the fold locus meets a breakpoint; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 110 structured, 80 common subexpressions, 77 power chains.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = A * Omega
    t2 = 2.0 * t1
    t3 = m + t2 * zeta
    t4 = Omega2 + h_A
    t5 = zeta * zeta
    F_AA = 2.0 * (4.0 * Omega2 * t5 + R * h_AA + t4 * t4)
    t6 = Omega * R + t3 * zeta
    F_AOmega = 4.0 * (t1 * t4 + t2 * t5 + t6)
    Omega3 = Omega * Omega2
    F_Omega = 4.0 * A * t6 - 4.0 * F_0 * F_0 * Omega3
    t7 = m_p + t2 * zeta_p
    F_p = 2.0 * (R * h_p + t3 * t7)
    t8 = 2.0 * Omega
    F_Ap = 2.0 * (R * h_Ap + h_p * t4 + t3 * t8 * zeta_p + t7 * t8 * zeta)
    t9 = 1.0 / F_AOmega
    t10 = F_AA * end_p
    Omega4 = Omega2 * Omega2
    return (
        end_p,
        -t9 * (F_Ap + t10),
        -0.5 * t9 * (-F_AOmega * F_p + F_Ap * F_Omega + F_Omega * t10) / (F_0 * Omega4),
        F_AOmega,
        4.0 * Omega * (t0 + np.abs(h)) + 8.0 * t1 * t5 + 4.0 * t1 * (Omega2 + np.abs(h_A)) + 4.0 * t3 * zeta,
        1.0,
        1.0,
    )


def moves_of_corner_backbone(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, m_p, zeta_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of where the backbone meets a breakpoint; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 47 structured, 39 common subexpressions, 36 power chains.
    Proved, error / u (1 + kappa): 0.0, 4.34, -, 0.34, 0.34, 0.0, 0.0
    """
    t0 = 2.0 * A * Omega
    I = m + t0 * zeta
    t1 = 4.0 * I * zeta
    F_A = Omega * t1
    Omega2 = Omega * Omega
    Omega3 = Omega * Omega2
    F_Omega = A * t1 - 4.0 * F_0 * F_0 * Omega3
    R_A = Omega2 + h_A
    F_p = 2.0 * I * (m_p + t0 * zeta_p)
    t2 = 1.0 / t0
    t3 = R_A * end_p
    Omega4 = Omega2 * Omega2
    return (
        end_p,
        -t2 * (h_p + t3),
        0.5 * t2 * (F_A * end_p * t0 - F_Omega * h_p - F_Omega * t3 + F_p * t0) / (F_0 * Omega4),
        t0,
        t0,
        1.0,
        1.0,
    )


def moves_of_corner_rest(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, m_p, zeta_p, end_p, forcing_p, frequency_p):
    """A_p, Omega_p, F_0_p of at Omega = 0 on a breakpoint; then what must not vanish, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 7 results, each the arguments that it depends on,
    broadcast.
    Operations: 44 structured, 39 common subexpressions, 36 power chains.
    Proved, error / u (1 + kappa): 0.0, 0.0, -, 0.0, 0.0, 0.0, 0.0
    """
    Omega2 = Omega * Omega
    R = A * Omega2 + h
    t0 = 2.0 * Omega
    t1 = A * t0
    I = m + t1 * zeta
    t2 = I * zeta
    F_A = 2.0 * (R * (Omega2 + h_A) + t0 * t2)
    Omega3 = Omega * Omega2
    F_Omega = 4.0 * A * (Omega * R + t2) - 4.0 * F_0 * F_0 * Omega3
    F_p = 2.0 * (I * (m_p + t1 * zeta_p) + R * h_p)
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


def beside(Omega, A, F_0, m, zeta, h, h_A):
    """F_A, F_Omega and R, each with its size.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 6 results, each the arguments that it depends on,
    broadcast.
    Operations: 66 structured, 37 common subexpressions, 36 power chains.
    """
    Omega2 = Omega * Omega
    t0 = A * Omega2
    R = h + t0
    t1 = 2.0 * Omega
    t2 = A * t1 * zeta + m
    t3 = t2 * zeta
    F_A = 2.0 * (R * (Omega2 + h_A) + t1 * t3)
    Omega3 = Omega * Omega2
    t4 = 4.0 * F_0 * F_0 * Omega3
    t5 = 4.0 * A
    F_Omega = -t4 + t5 * (Omega * R + t3)
    t6 = t2 * zeta
    t7 = t0 + np.abs(h)
    return (
        F_A,
        4.0 * Omega * t6 + 2.0 * t7 * (Omega2 + np.abs(h_A)),
        F_Omega,
        t4 + t5 * (Omega * t7 + t6),
        R,
        t7,
    )


def moves_of_phase(Omega, A, F_0, m, zeta, h, h_A, h_p, m_p, zeta_p, A_p, Omega_p, F_0_p):
    """d/dp of the phase (25) and of the transmissibility of a state that moves by A_p, Omega_p, F_0_p.

    Equation from (23)-(34). Domain: Omega > 0, A > 0. Shape: 2 results, each the arguments that it depends on,
    broadcast.
    Operations: 56 structured, 46 common subexpressions, 46 power chains.
    """
    t0 = Omega * Omega
    R = A * t0 + h
    t1 = 2.0 * A * Omega
    I = m + t1 * zeta
    t2 = A_p * h_A + h_p
    R_moved = A_p * t0 + Omega_p * t1 + t2
    t3 = 2.0 * zeta
    I_moved = A * Omega_p * t3 + A_p * Omega * t3 + m_p + t1 * zeta_p
    t4 = 1.0 / F_0
    t5 = np.hypot(h, I)
    t6 = 1.0 / t5
    return (
        (-I * R_moved + I_moved * R) / (I * I + R * R),
        t4 * (-F_0_p * t4 * t5 + I * I_moved * t6 + h * t2 * t6 - 2.0 * Omega_p * t5 / Omega) / t0,
    )


if NATIVE is not None:
    (
        force, force_slopes, level, F, level_slope, Omega_A, outer, terms, least, least_Omega_A, peak, isola,
        isola_apart, fold_slopes, fold_force, fold_level, peak_share, Omega_of_share, level_rise, cusp_bend,
        hessian, bound, share,
    ) = compiled(
        (force, force_slopes, level, F, level_slope, Omega_A, outer, terms, least, least_Omega_A, peak, isola,
         isola_apart, fold_slopes, fold_force, fold_level, peak_share, Omega_of_share, level_rise, cusp_bend,
         hessian, bound, share,),
        NATIVE.inertia(),
    )

# by the numbers of `conventions.Pinned`
MOVES = (
    moves_of_state, moves_of_fold, moves_of_corner_fold, moves_of_peak, moves_of_cusp, moves_of_isola,
    moves_of_corner_top, moves_of_corner_end, moves_of_corner_backbone, moves_of_corner_rest,
)
