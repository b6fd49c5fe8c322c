"""Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not
truncated: in balls.

Written by `make derive` from derivations/mechanisms/rod_spring_untruncated.py, derivations/asymmetric/curved.py;
never edit.

Arguments are `flint.arb`, or numbers that are exact; each output holds the value of the function of the same name,
to the digits of `flint.ctx`. passed_n is meant where A exceeds n breakpoints; beyond: by how much it exceeds the
last of these. Equations and domains that are not stated here are those of rod_spring_untruncated.py.
"""

from flint import arb

from slowflow.support.balls import R_D, R_F

__all__ = [
    "at_rest", "breakpoints", "given", "kinks", "known",
]


def breakpoints(alpha, beta, delta_h):
    """The |u| at which a piece of the force ends."""
    return (
        (-delta_h**2 + 2.0 * delta_h).sqrt(),
    )


def given(lam, r, delta_h):
    """The parameters from the design, and what the force loses at each breakpoint.

    Equation (5)-(7). Domain: any design.
    """
    t0 = lam * r
    return -delta_h * t0 + 1.0, -0.5 * t0 * (delta_h - 1.0), delta_h, 0.0


def kinks(alpha, beta, delta_h):
    """What the slope of the force loses at each breakpoint.

    Equation (5). Domain: any parameters.
    """
    u_cr = (-delta_h**2 + 2.0 * delta_h).sqrt()
    c = 1.0 - delta_h
    t0 = 2.0 * beta
    c2 = c**2
    c3 = c * c2
    return (
        alpha - t0 - 1.0 + t0 * u_cr**2 / c3 + t0 / c,
    )


def at_rest(alpha, beta, delta_h):
    """h, h_A, h_AA, h_AAA, h - A h_A at A = 0.

    Equation (20)-(22), (31). Domain: any parameters.
    """
    return 0.0, -alpha, 0.0, -4.5 * beta, 0.0


def _known_passed_0(A, beyond, alpha, beta, delta_h):
    A2 = A**2
    t0 = 1.0 - A2
    F = R_F(0.0, t0, 1.0)
    D = (arb(1) / 3) * R_D(0.0, t0, 1.0)
    t1 = (4 / arb.pi())
    t2 = D * t1
    t3 = F * t1
    t4 = A + 1.0
    t5 = A - 1.0
    t6 = 1.0 / (A * t4 * t5)
    t7 = A2 - 2.0
    t8 = t2 * t6 * t7 + t3 * t6
    t9 = (8 / arb.pi())
    t10 = t6 * t9
    t11 = 5.0 * A2
    t12 = t4**2
    t13 = t5**2
    t14 = 1.0 / (A2 * t12 * t13)
    t15 = t14 * (t11 - 3.0)
    A4 = A2**2
    t16 = D * t14 * (A4 - t11 + 3.0)
    t17 = 2.0 * beta
    t18 = t12 * t4
    t19 = t13 * t5
    A3 = A * A2
    t20 = 1.0 / (A3 * t18 * t19)
    A6 = A3**2
    return (
        -A * alpha + 2.0 * A * beta * (1.0 - t2),
        -alpha + 2.0 * beta * (A * t8 - t2 + 1.0),
        t17 * (A * (-t15 * t3 - t16 * t9) + D * t10 * t7 + F * t10),
        t17 * (A * (t2 * t20 * (65.0 * A2 - 55.0 * A4 + 6.0 * A6 - 24.0) + t20 * t3 * (-31.0 * A2 + 27.0 * A4 +
        12.0)) + (-12 / arb.pi()) * (F * t15) + (-24 / arb.pi()) * t16),
        -A2 * t17 * t8,
    )


def _known_passed_1(A, beyond, alpha, beta, delta_h):
    u_cr = (-delta_h**2 + 2.0 * delta_h).sqrt()
    c = 1.0 - delta_h
    root = beyond.sqrt() * (A + u_cr).sqrt()
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    theta = arb.atan2(u_cr, root)
    y2 = y**2
    t1 = c**2
    F = x * R_F(y2, t1, 1.0)
    x2 = x**2
    x3 = x * x2
    D = (arb(1) / 3) * (x3 * R_D(y2, t1, 1.0))
    t2 = 1.0 / c
    t3 = x * y
    t4 = (1 / arb.pi()) * (-D + 0.5 * t2 * (-t3 + theta))
    t5 = (4 / arb.pi())
    t6 = F * t5
    t7 = A + 1.0
    t8 = A - 1.0
    t9 = t0 / (t7 * t8)
    t10 = t5 * t9
    t11 = t2 * t3
    A2 = A**2
    t12 = D * (A2 - 2.0)
    t13 = -t10 * t11 + t10 * t12 + t6 * t9
    t14 = 2.0 * beta
    t15 = (8 / arb.pi())
    t16 = t15 * t9
    t17 = 5.0 * A2
    t18 = t8**2
    t19 = t7**2
    t20 = 1.0 / (A2 * t18 * t19)
    t21 = t20 * (t17 - 3.0)
    A4 = A2**2
    t22 = 3.0 - t17
    t23 = D * t20 * (A4 + t22)
    t24 = A4 * x2
    t25 = A2 * x2
    t26 = t2 * x
    t27 = t20 * t26 * (t22 + t24 + 4.0 * t25 - 3.0 * x2) / y
    t28 = (12 / arb.pi())
    t29 = -31.0 * A2 + 27.0 * A4 + 12.0
    t30 = t18 * t8
    t31 = t19 * t7
    A3 = A * A2
    t32 = 1.0 / (A3 * t30 * t31)
    A6 = A3**2
    t33 = 6.0 * A6
    t34 = t32 * t5
    x4 = x2**2
    y3 = y * y2
    return (
        8.0 * A * beta * t4 - A,
        t14 * (A * t13 + 4.0 * t4) - 1.0,
        t14 * (A * (-t15 * t23 - t21 * t6 - t27 * t5) + F * t16 - t11 * t16 + t12 * t16),
        t14 * (A * (D * t34 * (65.0 * A2 - 55.0 * A4 + t33 - 24.0) - t26 * t34 * (-29.0 * A2 * x4 + 19.0 * A4 * x4 -
        7.0 * A6 * x2 - 44.0 * t24 + 59.0 * t25 + t29 + t33 * x4 - 24.0 * x2 + 12.0 * x4) / y3 + t29 * t32 * t6) - F
        * t21 * t28 + (-24 / arb.pi()) * t23 - t27 * t28),
        -A2 * t13 * t14,
    )


def known(passed, A, beyond, alpha, beta, delta_h):
    """h, h_A, h_AA, h_AAA, h - A h_A together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    of = (_known_passed_0, _known_passed_1, )
    return of[passed](A, beyond, alpha, beta, delta_h)
