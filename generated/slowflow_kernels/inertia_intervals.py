"""Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance: on whole intervals.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/oscillator.py, derivations/averaging.py, derivations/slow_flow.py, derivations/inertia.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Each output holds every value that the function of the same name takes on the arguments: objects with operators and
the methods `square` and `sqrt`.
"""

# a formatter would spread each polynomial over a page
# fmt: off

__all__ = [
    "isola",
    "isola_apart",
    "peak",
    "terms",
]


def terms(A, m, zeta, h):
    """What the least level of an amplitude follows from; it has one where the first, fall, is positive.

    Equation from (24). Domain: A > 0.
    """
    return (
        -A * (2.0 * A * zeta.square() + h),
        12.0 * A * m * zeta,
        h.square() + m.square(),
    )


def peak(x, A, F_0, m, zeta, h, h_A):
    """The least level of an amplitude less F_0, and its slope along A.

    Equation from (24). Domain: x of `least`, h < 0.
    """
    t0 = A * zeta
    t1 = m * x
    drag = t0 + t1
    share = drag / h
    t2 = x.square()
    root = (share.square() + t2).sqrt()
    return (
        -F_0 + root * (2.0 * t0 + t1),
        (-share * (h_A * t2 + 1.0) + 2.0 * t2 * zeta) / root,
    )


def isola(x, A, m, zeta, h, h_A, h_AA):
    """Has the sign of F_A where an amplitude's level is least: zero at an isola point; its slope along A.

    Equation from (24), (30). Domain: x of `least`, h < 0.
    """
    t0 = A * zeta
    t1 = m * x
    t2 = t0 + t1
    t3 = x.square()
    t4 = h * t3
    t5 = 2.0 * zeta
    t6 = h_A * t3
    t7 = t6 + 1.0
    t8 = 8.0 * x
    t9 = 4.0 * h
    return (
        t2 * t7 - t4 * t5,
        h_AA * t2 * t3 - t5 * t6 + t7 * zeta + (2.0 * h_A * t2 * x + m * t7 - t9 * x * zeta) * (16.0 * A *
        zeta.square() - h_A * (-4.0 * A - 8.0 * t4) + 12.0 * t1 * zeta + t9) / (-h.square() * t8 - m.square() * t8 -
        12.0 * m * t0),
    )


def isola_apart(x, A, m, zeta, h, k, cubic):
    """The same without its slope by k = h - A h_A and cubic = 3 h - A h_A, small where h is like A^3.

    Equation from (24), (30). Domain: x of `least`, h < 0.
    """
    t0 = A * zeta
    t1 = m * x
    drag = t0 + t1
    x2 = x.square()
    x3 = x * x2
    return (
        (-cubic * t0 * x2 + drag.square() * (-2.0 * t0 - t1) / h - k * m * x3) / A
    )
