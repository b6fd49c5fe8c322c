"""Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not
truncated: in balls.

Written by `make derive`; never edit.
Input: derivations/mechanisms/rod_spring_untruncated.py, sha256 fcc795df716f7e2f9f892242cfe193b7bb6d648ba5e980491479e0dbe8cfd9fa
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Arguments are `flint.arb`, or numbers that are exact; each output holds the value of the function of the same name, to the
digits of `flint.ctx`. passed_n is meant where A exceeds n breakpoints; beyond: by how much it exceeds the last of these.
"""

# a formatter would spread each polynomial over a page
# fmt: off

from flint import arb

from slowflow_support.balls import R_D, R_F

__all__ = [
    "at_rest",
    "breakpoints",
    "given",
    "kinks",
    "known",
]


def given(lam, r, delta_h):
    """The parameters from the design, and what the force loses at each breakpoint.

    Equation (5)-(7). Domain: any design.
    """
    t0 = lam * r
    return (
        -delta_h * t0 + 1.0,
        -0.5 * t0 * (delta_h - 1.0),
        delta_h,
        0.0,
    )


def breakpoints(alpha, beta, delta_h):
    """The |u| at which a piece of the force ends.

    Equation (5). Domain: any parameters.
    """
    return (
        (-delta_h**2 + 2.0 * delta_h).sqrt(),
    )


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
    return (
        0.0,
        -alpha,
        0.0,
        -4.5 * beta,
        0.0,
    )


def _known_passed_0(A, beyond, alpha, beta, delta_h):
    A2 = A**2
    t0 = 1.0 - A2
    F = R_F(0.0, t0, 1.0)
    D = (arb(1) / 3) * R_D(0.0, t0, 1.0)
    t1 = (1 / arb.pi()) * D
    t2 = 1.0 - 4.0 * t1
    t3 = 8.0 * beta
    t4 = (1 / arb.pi()) * F
    t5 = t3 * t4
    t6 = A + 1.0
    t7 = A - 1.0
    t8 = 1.0 / (A * t6 * t7)
    t9 = t1 * (A2 - 2.0)
    t10 = t3 * t8 * t9 + t5 * t8
    t11 = 16.0 * beta
    t12 = t11 * t8
    t13 = 5.0 * A2
    t14 = t6**2
    t15 = t7**2
    t16 = 1.0 / (A2 * t14 * t15)
    t17 = t16 * (t13 - 3.0)
    A4 = A2**2
    t18 = t1 * t16 * (A4 - t13 + 3.0)
    t19 = t14 * t6
    t20 = t15 * t7
    A3 = A * A2
    t21 = 1.0 / (A3 * t19 * t20)
    A6 = A3**2
    return (
        A * (-alpha + 2.0 * beta * t2),
        A * t10 - alpha + 2.0 * beta * t2,
        A * (-t11 * t18 - t17 * t5) + t12 * t4 + t12 * t9,
        A * (t1 * t21 * t3 * (65.0 * A2 - 55.0 * A4 + 6.0 * A6 - 24.0) + t21 * t5 * (-31.0 * A2 + 27.0 * A4 + 12.0))
        - 24.0 * beta * t17 * t4 - 48.0 * beta * t18,
        -A2 * t10,
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
    t3 = (1 / arb.pi()) * beta
    t4 = 8.0 * t3
    t5 = t4 * (-D + 0.5 * t2 * (theta - x * y)) - 1.0
    t6 = F * t4
    t7 = A + 1.0
    t8 = A - 1.0
    t9 = t0 / (t7 * t8)
    A2 = A**2
    t10 = D * (A2 - 2.0)
    t11 = t4 * t9
    t12 = t2 * t3 * x
    t13 = 4.0 * t12
    t14 = -x2
    t15 = A2 * x2
    t16 = A2 * y2
    t17 = (-A2 + t14 + t15 + t16 - 3.0 * y2 + 1.0) / y
    t18 = t10 * t11 + t13 * t17 * t9 + t6 * t9
    t19 = 16.0 * t3
    t20 = t19 * t9
    t21 = 5.0 * A2
    t22 = t7**2
    t23 = t8**2
    t24 = 1.0 / (A2 * t22 * t23)
    t25 = t24 * (t21 - 3.0)
    A4 = A2**2
    t26 = D * t24 * (A4 - t21 + 3.0)
    x4 = x2**2
    y4 = y2**2
    t27 = A4 * x4
    t28 = A2 * x4
    t29 = A2 * y4
    t30 = A4 * x2
    t31 = 2.0 * A4
    t32 = x2 * y2
    t33 = t15 * y2
    t34 = t30 * y2
    y3 = y * y2
    t35 = (
        t24 * (t14 + 2.0 * t15 + 6.0 * t16 + t27 - 2.0 * t28 - 16.0 * t29 - t30 - t31 * y2 + t31 * y4 + 5.0 * t32 -
        10.0 * t33 + 5.0 * t34 + x4 - 4.0 * y2 + 10.0 * y4) / y3
    )
    t36 = t22 * t7
    t37 = t23 * t8
    A3 = A * A2
    t38 = 1.0 / (A3 * t36 * t37)
    A6 = A3**2
    t39 = 6.0 * A6
    t40 = 3.0 * x4
    x6 = x3**2
    t41 = 3.0 * x6
    y6 = y3**2
    t42 = 9.0 * x6
    t43 = 27.0 * x2 * y4
    t44 = 12.0 * x4 * y2
    t45 = 81.0 * y4
    y5 = y * y4
    return (
        A * t5,
        A * t18 + t5,
        A * (-t13 * t35 - t19 * t26 - t25 * t6) + F * t20 + t10 * t20 + t11 * t17 * t2 * x,
        A * (D * t38 * t4 * (65.0 * A2 - 55.0 * A4 + t39 - 24.0) + t13 * t38 * (A2 * t42 + 112.0 * A2 * y6 - A4 *
        t42 + 38.0 * A4 * y4 - 92.0 * A4 * y6 - 7.0 * A6 * t32 - A6 * t40 + A6 * t41 + A6 * t43 + A6 * t44 + t15 *
        t45 + 36.0 * t16 * x4 - 36.0 * t27 * y2 + 9.0 * t27 - 9.0 * t28 - 50.0 * t29 - t30 * t45 + 9.0 * t32 - 25.0
        * t33 + 23.0 * t34 - t39 * y4 + t39 * y6 + t40 - t41 - t43 - t44 + 18.0 * y4 - 42.0 * y6) / y5 + t38 * t6 *
        (-31.0 * A2 + 27.0 * A4 + 12.0)) - 24.0 * F * t25 * t3 - 12.0 * t12 * t35 - 48.0 * t26 * t3,
        -A2 * t18,
    )


def known(passed, A, beyond, alpha, beta, delta_h):
    """h, h_A, h_AA, h_AAA, h - A h_A together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    of = (_known_passed_0, _known_passed_1, )
    return of[passed](A, beyond, alpha, beta, delta_h)
