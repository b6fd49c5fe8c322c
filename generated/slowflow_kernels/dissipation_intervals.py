"""Structural and quadratic damping, and dry friction of what is attached: on whole intervals.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/averaging.py, derivations/slow_flow.py, derivations/dissipation.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Each output holds every value that the function of the same name takes on the arguments: objects with operators and
the methods `square` and `sqrt`.
"""

# a formatter would spread each polynomial over a page
# fmt: off

__all__ = [
    "at_rest",
    "cusps",
    "F_A_halved",
    "F_A_scaled",
    "far",
    "far_by_inertia",
    "folds",
    "folds_by_inertia",
    "h_A_of_turn",
    "I",
    "I_A",
    "I_scaled",
    "isolas",
    "isolas_by_inertia",
    "least_F_A",
    "peaks",
    "peaks_by_inertia",
    "R_of_fold",
    "R_of_peak",
    "R_of_response",
    "R_where_stationary",
    "released",
    "rest",
    "static",
    "stiffness",
    "turn_share",
    "turns",
]


def at_rest(A, m, eta):
    """I_0, I at Omega = 0, and three derivatives by A: friction acts throughout.

    Equation from (19). Domain: A > 0.
    """
    return (
        A * eta + m,
        eta,
        0.0,
        0.0,
    )


def released(A, m, eta, u_cr):
    """The same where friction acts for |u| < u_cr only.

    Equation from (19). Domain: A >= u_cr > 0.
    """
    t0 = m * u_cr
    A2 = A.square()
    A3 = A * A2
    A4 = A2.square()
    return (
        A * eta + t0 / A,
        eta - t0 / A2,
        2.0 * t0 / A3,
        -6.0 * t0 / A4,
    )


def I(Omega, A, I_0, zeta, d):
    """Sine balance, -F_0 sin phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0.
    """
    return (
        A.square() * Omega.square() * d + 2.0 * A * Omega * zeta + I_0
    )


def I_A(Omega, A, I_0A, zeta, d):
    """dI/dA.

    Equation (23). Domain: Omega > 0, A > 0.
    """
    return (
        2.0 * A * Omega.square() * d + I_0A + 2.0 * Omega * zeta
    )


def far(x, A, I_0, I_0A, zeta, d, h, h_A):
    """R, R_A, I and I_A over Omega^2, at x = 1/Omega.

    Equation (23). Domain: x >= 0, A > 0.
    """
    t0 = x.square()
    t1 = 2.0 * A
    t2 = x * zeta
    return (
        A + h * t0,
        h_A * t0 + 1.0,
        A.square() * d + I_0 * t0 + t1 * t2,
        I_0A * t0 + d * t1 + 2.0 * t2,
    )


def static(F_0, I_0, I_0A, h, h_A):
    """F at Omega = 0 by its halves h - c and h + c, c^2 = F_0^2 - I_0^2; and the slope of each.

    Equation from (24). Domain: F_0 > I_0.
    """
    c = ((F_0 - I_0) * (F_0 + I_0)).sqrt()
    t0 = I_0 * I_0A / c
    return (
        -c + h,
        c + h,
        h_A + t0,
        h_A - t0,
    )


def turn_share(x, A, I_0, I_0A, zeta, d):
    """D/Omega^2 at x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D.

    Equation from (30). Domain: x >= 0, A > 0.
    """
    A2 = A.square()
    t0 = A2 * d
    x2 = x.square()
    x3 = x * x2
    A3 = A * A2
    return (
        4.0 * A3 * d.square() + 9.0 * t0 * x * zeta + x2 * (2.0 * A * I_0 * d + 4.0 * A * zeta.square() + I_0A * t0)
        + x3 * (A * I_0A * zeta + I_0 * zeta)
    )


def F_A_halved(R, R_A, I, I_A):
    """F_A/2 by R, I and their slopes.

    Equation (30). Domain: Omega >= 0, A > 0.
    """
    return (
        I * I_A + R * R_A
    )


def R_of_response(F_0, I):
    """The size of R where F = 0.

    Equation (24). Domain: Omega >= 0, A > 0.
    """
    return (
        (F_0.square() - I.square()).sqrt()
    )


def R_of_peak(Omega, A, zeta, d, I):
    """R where F_Omega = 0.

    Equation from (24). Domain: Omega >= 0, A > 0.
    """
    return (
        I * (-A * d - zeta / Omega)
    )


def R_where_stationary(x, A, I_0, zeta, d):
    """Where a level by inertia is stationary, x = 1/Omega: what is not negative, lower and higher R/Omega^2.

    Equation from (24). Domain: Omega >= 0, A > 0.
    """
    t0 = A.square()
    t1 = A * zeta
    t2 = x * (I_0 * x + t1) * (I_0 * x.square() + d * t0 + 2.0 * t1 * x)
    t3 = t0 - 4.0 * t2
    t4 = 0.5 * A + 0.5 * t3.sqrt()
    return (
        t3,
        t2 / t4,
        t4,
    )


def R_of_fold(Omega, h_A, I, I_A):
    """R where F_A = 0.

    Equation from (30). Domain: Omega >= 0, A > 0.
    """
    return (
        -I * I_A / (Omega.square() + h_A)
    )


def h_A_of_turn(Omega, A, R, beside):
    """h_A where F_AOmega = 0; beside is Omega^2 `turn_share`.

    Equation from (30). Domain: Omega >= 0, A > 0.
    """
    return (
        -Omega.square() + (-R - beside) / A
    )


def least_F_A(A, k, I, I_A):
    """4 A times the least F_A/2 that any R leaves.

    Equation from (30). Domain: Omega >= 0, A > 0.
    """
    return (
        4.0 * A * I * I_A - k.square()
    )


def I_scaled(Omega, A, I_0_over_A, zeta, d):
    """I/A, by I_0/A.

    Equation (23). Domain: Omega >= 0, A > 0.
    """
    return (
        A * Omega.square() * d + I_0_over_A + 2.0 * Omega * zeta
    )


def F_A_scaled(Omega, h_over_A, h_A, I_over_A, I_A):
    """F_A/(2 A), by h/A and I/A.

    Equation (30). Domain: Omega >= 0, A > 0.
    """
    t0 = Omega.square()
    return (
        I_A * I_over_A + (h_A + t0) * (h_over_A + t0)
    )


def far_by_inertia(x, A, F_0, I_0, zeta, d, h):
    """F/Omega^4 at x = 1/Omega; and -Omega^3/4 dlevel^2/dOmega, less Omega times the third.

    Equation (24). Domain: x >= 0, A > 0.
    """
    t0 = x.square()
    A2 = A.square()
    t1 = A2 * d
    t2 = A * x * zeta
    t3 = A + h * t0
    t4 = I_0 * t0 + t1 + 2.0 * t2
    A3 = A * A2
    return (
        -F_0.square() + t3.square() + t4.square(),
        A * h + 2.0 * A2 * zeta.square() + I_0 * t1 + 3.0 * I_0 * t2 + t0 * (I_0.square() + h.square()),
        A3 * d * zeta,
    )


def folds(Omega, A, F_0, I_0A, I_0AA, zeta, d, h_A, h_AA, R, I):
    """F and F_A; derivatives by A and by Omega of the first, then of the second.

    Equation from (24), (30). Domain: Omega > 0, A > 0.
    """
    t0 = Omega.square()
    t1 = h_A + t0
    t2 = 2.0 * Omega
    t3 = A * d
    t4 = 2.0 * t0
    t5 = I_0A + t2 * zeta + t3 * t4
    t6 = 2.0 * (I * t5 + R * t1)
    t7 = Omega * R
    t8 = A * Omega
    t9 = d * t8 + zeta
    return (
        R.square() + (-F_0 + I) * (F_0 + I),
        t6,
        t6,
        4.0 * A * (I * t9 + t7),
        2.0 * (I * I_0AA + I * d * t4 + R * h_AA + t1.square() + t5.square()),
        4.0 * (A * t5 * t9 + I * (t2 * t3 + zeta) + t1 * t8 + t7),
    )


def peaks(Omega, A, F_0, I_0, I_0A, zeta, d, h_A, R, I):
    """F and F_Omega/(4 A Omega); derivatives by A and by Omega of the first, then of the second.

    Equation from (24). Domain: Omega > 0, A > 0.
    """
    t0 = zeta / Omega
    t1 = 3.0 * zeta
    t2 = A * d
    t3 = Omega * t2
    t4 = I_0 * d + t3 * (t1 + t3) + 2.0 * zeta.square()
    t5 = Omega.square()
    t6 = h_A + t5
    t7 = 2.0 * Omega
    t8 = t1 + 2.0 * t3
    return (
        R.square() + (-F_0 + I) * (F_0 + I),
        A * t4 + I_0 * t0 + R,
        2.0 * (I * (I_0A + 2.0 * t2 * t5 + t7 * zeta) + R * t6),
        4.0 * A * (I * (t3 + zeta) + Omega * R),
        I_0A * (t0 + t2) + t3 * t8 + t4 + t6,
        A.square() * d * t8 + A * t7 - I_0 * zeta / t5,
    )


def cusps(Omega, A, I_0A, I_0AA, I_0AAA, zeta, d, h_A, h_AA, h_AAA, R, I):
    """F_A and F_AA; derivatives by A and by Omega of the first, then of the second.

    Equation from (30), (33). Domain: Omega > 0, A > 0.
    """
    t0 = Omega.square()
    t1 = h_A + t0
    t2 = 2.0 * Omega
    t3 = d * t0
    t4 = 2.0 * t3
    t5 = A * t4 + I_0A + t2 * zeta
    t6 = 2.0 * (I * I_0AA + I * t4 + R * h_AA + t1.square() + t5.square())
    t7 = A * Omega
    t8 = d * t2
    t9 = A * t8 + zeta
    t10 = A * (d * t7 + zeta)
    t11 = 2.0 * t5
    t12 = I_0AA + t4
    return (
        2.0 * (I * t5 + R * t1),
        t6,
        t6,
        4.0 * (I * t9 + Omega * R + t1 * t7 + t10 * t5),
        2.0 * (I * I_0AAA + I_0AA * t11 + R * h_AAA + 3.0 * h_AA * t1 + t12 * t5 + 4.0 * t3 * t5),
        4.0 * (I * t8 + h_AA * t7 + t1 * t2 + t10 * t12 + t11 * t9),
    )


def isolas(Omega, A, I_0, I_0A, I_0AA, zeta, d, h_A, h_AA, R, I):
    """F_A and F_Omega/(4 A Omega); derivatives by A and by Omega of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0.
    """
    t0 = Omega.square()
    t1 = h_A + t0
    t2 = 2.0 * Omega
    t3 = A * d
    t4 = 2.0 * t0
    t5 = I_0A + t2 * zeta + t3 * t4
    t6 = zeta / Omega
    t7 = 3.0 * zeta
    t8 = Omega * t3
    t9 = I_0 * d + t8 * (t7 + t8) + 2.0 * zeta.square()
    t10 = t2 * t3
    t11 = t10 + t7
    return (
        2.0 * (I * t5 + R * t1),
        A * t9 + I_0 * t6 + R,
        2.0 * (I * I_0AA + I * d * t4 + R * h_AA + t1.square() + t5.square()),
        4.0 * (A * Omega * t1 + A * t5 * (t8 + zeta) + I * (t10 + zeta) + Omega * R),
        I_0A * (t3 + t6) + t1 + t11 * t8 + t9,
        A.square() * d * t11 + A * t2 - I_0 * zeta / t0,
    )


def turns(Omega, A, I_0, I_0A, I_0AA, zeta, d, h, h_A, h_AA, R, I):
    """F_A and F_AOmega/Omega, less constant factors; derivatives by A and by Omega of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0.
    """
    t0 = Omega.square()
    t1 = h_A + t0
    t2 = 2.0 * Omega
    t3 = A * d
    t4 = 2.0 * t3
    t5 = I_0A + t0 * t4 + t2 * zeta
    t6 = 2.0 * h_A
    t7 = 4.0 * A
    t8 = zeta.square()
    A2 = A.square()
    t9 = 2.0 * d
    t10 = A2 * d * zeta
    t11 = A * I_0A
    t12 = I_0 + t11
    t13 = zeta / Omega
    t14 = d.square()
    t15 = Omega * t3
    t16 = A2 * t14
    A3 = A * A2
    return (
        2.0 * (I * t5 + R * t1),
        A * t6 + 8.0 * A * t8 + A2 * I_0A * t9 + I_0 * d * t7 + 18.0 * Omega * t10 + 2.0 * h + t0 * (8.0 * A3 * t14
        + t7) + 2.0 * t12 * t13,
        2.0 * (I * I_0AA + I * t0 * t9 + R * h_AA + t1.square() + t5.square()),
        4.0 * (A * Omega * t1 + A * t5 * (t15 + zeta) + I * (t2 * t3 + zeta) + Omega * R),
        2.0 * (A * I_0AA * (t13 + t3) + A * h_AA + I_0 * t9 + I_0A * t13 + I_0A * (t13 + t4) + 2.0 * t0 * (6.0 * t16
        + 1.0) + t11 * t9 + 18.0 * t15 * zeta + t6 + 4.0 * t8),
        2.0 * (Omega * t7 * (2.0 * t16 + 1.0) + 9.0 * t10 - t12 * zeta / t0),
    )


def rest(Omega, A, F_0, I_0A, zeta, d, h_A, R, I):
    """F, for Omega = 0; derivatives by A and by Omega.

    Equation from (24). Domain: Omega > 0, A > 0.
    """
    t0 = Omega.square()
    t1 = A * d
    return (
        R.square() + (-F_0 + I) * (F_0 + I),
        2.0 * (I * (I_0A + 2.0 * Omega * zeta + 2.0 * t0 * t1) + R * (h_A + t0)),
        4.0 * A * (I * (Omega * t1 + zeta) + Omega * R),
    )


def stiffness(Omega, A, I_0A, I_0AA, zeta, d, h_A, h_AA, R, I):
    """F_A, for Omega = 0; derivatives by A and by Omega.

    Equation from (30). Domain: Omega > 0, A > 0.
    """
    t0 = Omega.square()
    t1 = h_A + t0
    t2 = 2.0 * Omega
    t3 = A * d
    t4 = 2.0 * t0
    t5 = I_0A + t2 * zeta + t3 * t4
    t6 = A * Omega
    return (
        2.0 * (I * t5 + R * t1),
        2.0 * (I * I_0AA + I * d * t4 + R * h_AA + t1.square() + t5.square()),
        4.0 * (A * t5 * (d * t6 + zeta) + I * (t2 * t3 + zeta) + Omega * R + t1 * t6),
    )


def folds_by_inertia(Omega, A, F_0, I_0A, I_0AA, zeta, d, h_A, h_AA, R, I):
    """F and F_A by inertia; derivatives by A and by Omega of the first, then of the second.

    Equation from (24), (30). Domain: Omega > 0, A > 0.
    """
    Omega2 = Omega.square()
    t0 = F_0 * Omega2
    t1 = Omega2 + h_A
    t2 = 2.0 * Omega
    t3 = A * d
    t4 = 2.0 * Omega2
    t5 = I_0A + t2 * zeta + t3 * t4
    t6 = 2.0 * (I * t5 + R * t1)
    t7 = Omega * R
    t8 = A * Omega
    t9 = A * (d * t8 + zeta)
    Omega3 = Omega * Omega2
    return (
        R.square() + (I - t0) * (I + t0),
        t6,
        t6,
        4.0 * (A * t7 - F_0.square() * Omega3 + I * t9),
        2.0 * (I * I_0AA + I * d * t4 + R * h_AA + t1.square() + t5.square()),
        4.0 * (I * (t2 * t3 + zeta) + t1 * t8 + t5 * t9 + t7),
    )


def peaks_by_inertia(Omega, A, F_0, I_0, I_0A, zeta, d, h, h_A, R, I):
    """F and -Omega^5/4 dlevel^2/dOmega by inertia; derivatives by A and by Omega of the first, then of the second.

    Equation from (24). Domain: Omega > 0, A > 0.
    """
    Omega2 = Omega.square()
    t0 = F_0 * Omega2
    t1 = Omega * zeta
    t2 = A * t1 + I_0
    t3 = Omega2 + h_A
    t4 = 2.0 * A * Omega2 * d + I_0A + 2.0 * t1
    t5 = A * Omega
    t6 = d * t5 + zeta
    t7 = I * zeta
    Omega3 = Omega * Omega2
    return (
        R.square() + (I - t0) * (I + t0),
        I * t2 + R * h,
        2.0 * (I * t4 + R * t3),
        4.0 * (A * I * t6 - F_0.square() * Omega3 + R * t5),
        I * I_0A + Omega * t7 + R * h_A + h * t3 + t2 * t4,
        A * (2.0 * Omega * h + 2.0 * t2 * t6 + t7),
    )


def isolas_by_inertia(Omega, A, I_0, I_0A, I_0AA, zeta, d, h, h_A, h_AA, R, I):
    """F_A and -Omega^5/4 dlevel^2/dOmega by inertia; derivatives by A and by Omega of the first, then of the second.

    Equation from (30). Domain: Omega > 0, A > 0.
    """
    t0 = Omega.square()
    t1 = h_A + t0
    t2 = Omega * zeta
    t3 = 2.0 * d * t0
    t4 = A * t3 + I_0A + 2.0 * t2
    t5 = A * t2 + I_0
    t6 = A * Omega
    t7 = d * t6
    t8 = t7 + zeta
    t9 = I * zeta
    return (
        2.0 * (I * t4 + R * t1),
        I * t5 + R * h,
        2.0 * (I * I_0AA + I * t3 + R * h_AA + t1.square() + t4.square()),
        4.0 * (A * t4 * t8 + I * (2.0 * t7 + zeta) + Omega * R + t1 * t6),
        I * I_0A + Omega * t9 + R * h_A + h * t1 + t4 * t5,
        A * (2.0 * Omega * h + 2.0 * t5 * t8 + t9),
    )
