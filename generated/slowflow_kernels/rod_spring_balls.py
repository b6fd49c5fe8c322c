"""Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr: in balls.

Written by `make derive` from derivations/mechanisms/rod_spring.py; never edit.

Arguments are `flint.arb`, or numbers that are exact; each output holds the value of the function of the same name,
to the digits of `flint.ctx`. passed_n is meant where A exceeds n breakpoints; beyond: by how much it exceeds the
last of these. Equations and domains that are not stated here are those of rod_spring.py.
"""

from flint import arb

__all__ = [
    "breakpoints", "given", "known",
]


def breakpoints(alpha, beta, gamma, u_cr):
    """The |u| at which a piece of the force ends."""
    return (
        u_cr,
    )


def given(lam, r, delta_h):
    """The parameters from the design, and what the force loses at each breakpoint.

    Equation (5)-(7). Domain: any design.
    """
    u_cr = delta_h.sqrt() * (2.0 - delta_h).sqrt()
    t0 = lam * r
    t1 = t0 * (delta_h - 1.0)
    delta_h2 = delta_h**2
    delta_h3 = delta_h * delta_h2
    return (
        -delta_h * t0 + 1.0,
        -0.5 * t1,
        -0.375 * t1,
        u_cr,
        -0.125 * delta_h3 * t0 * u_cr * (-15.0 * delta_h + 3.0 * delta_h2 + 20.0),
    )


def _known_passed_0(A, beyond, alpha, beta, gamma, u_cr, jump_1):
    t0 = -alpha
    A2 = A**2
    t1 = A2 * gamma
    t2 = 4.5 * beta
    A3 = A * A2
    return (
        A * (A2 * (-0.75 * beta - 0.625 * t1) + t0),
        A2 * (-2.25 * beta - 3.125 * t1) + t0,
        A * (-12.5 * t1 - t2),
        -37.5 * t1 - t2,
        A3 * (1.5 * beta + 2.5 * t1),
    )


def _known_passed_1(A, beyond, alpha, beta, gamma, u_cr, jump_1):
    root = beyond.sqrt() * (A + u_cr).sqrt()
    t0 = 1.0 / A
    x = t0 * u_cr
    y = root * t0
    psi_0 = arb.atan2(root, u_cr)
    theta = arb.atan2(u_cr, root)
    t1 = x * y
    t2 = 0.5 * t1
    M2 = -t2 + 0.5 * theta
    t3 = x**2
    M4 = -t1 * (0.25 * t3 + 0.375) + 0.375 * theta
    M6 = -t1 * (t3 * ((arb(1) / 6) * t3 + (arb(5) / 24)) + 0.3125) + 0.3125 * theta
    S2_2 = 0.5 * psi_0 + t2
    A2 = A**2
    t4 = M4 * beta
    A4 = A2**2
    t5 = M6 * gamma
    t6 = A4 * t5
    t7 = M2 * alpha + S2_2
    t8 = 3.0 * beta
    t9 = 1.0 / A2
    t10 = 1.0 / root
    u_cr2 = u_cr**2
    t11 = 6.0 * t4
    A3 = A * A2
    t12 = jump_1 * u_cr2
    root2 = root**2
    root3 = root * root2
    t13 = 1.0 / root3
    t14 = t12 * t13
    t15 = t10 / A3
    t16 = gamma * u_cr2
    u_cr3 = u_cr * u_cr2
    t17 = u_cr3 * (-alpha - u_cr2 * (5.0 * t16 + t8) + 1.0)
    t18 = 1.0 / A4
    t19 = t10 * t12
    t20 = t10 * t18
    u_cr4 = u_cr2**2
    u_cr5 = u_cr * u_cr4
    A5 = A * A4
    return (
        (-4 / arb.pi()) * (A * (A2 * t4 + t6 + t7)),
        (4 / arb.pi()) * (-A2 * M4 * t8 + jump_1 * t10 * t9 * u_cr2 - 5.0 * t6 - t7),
        (-4 / arb.pi()) * (A * t11 + 20.0 * A3 * t5 + t0 * t14 + 2.0 * t12 * t15 + t15 * t17),
        (4 / arb.pi()) * (-60.0 * A2 * t5 - t11 + t12 * t13 * t9 + t13 * t17 * t9 + t14 * (2.0 * t9 + 3.0 / root2) +
        3.0 * t17 * t20 + 6.0 * t18 * t19 + 2.0 * t20 * u_cr5 * (10.0 * t16 + t8)),
        (4 / arb.pi()) * (2.0 * A3 * t4 + 4.0 * A5 * t5 - t0 * t19),
    )


def known(passed, A, beyond, alpha, beta, gamma, u_cr, jump_1):
    """h, h_A, h_AA, h_AAA, h - A h_A together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    of = (_known_passed_0, _known_passed_1, )
    return of[passed](A, beyond, alpha, beta, gamma, u_cr, jump_1)
