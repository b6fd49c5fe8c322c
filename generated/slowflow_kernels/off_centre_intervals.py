"""Motions off the centre, u = B + A cos psi, by the means of the force and its derivatives over a cycle: on whole intervals.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/paper/averaging.py, derivations/paper/slow_flow.py, derivations/asymmetric/off_centre.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Each output holds every value that the function of the same name takes on the arguments: objects with operators and
the methods `square` and `sqrt`.
"""

# a formatter would spread each polynomial over a page
# fmt: off

__all__ = [
    "beside", "ended_along", "ended_fold", "ended_state",
]


def ended_state(Omega, A, force, I, I_A, load, c_0, s_0, c_x, c_y, X, Y):
    """What vanishes at a steady state, by coordinates x and y of the motion's ends: the balance of the mean and F; slopes of each by x and y.

    Equation (24) and the mean of (3). Domain: A > 0.
    """
    t0 = 2.0 * s_0
    t1 = Omega.square()
    R = A * t1 - t0
    t2 = 2.0 * I * I_A
    t3 = t0 / A
    t4 = 2.0 * R
    return (
        c_0 - load,
        I.square() + R.square() - force.square(),
        c_x,
        c_y,
        X * t2 + t4 * (X * t1 + X * t3 - 2.0 * c_x),
        Y * t2 + t4 * (Y * t1 + Y * t3 + 2.0 * c_y),
    )


def ended_along(A, s_0, c_x, c_y, X, Y):
    """Along the balance, by coordinates of the motion's ends: A's slope, and what F_A gains there by R.

    Equation (30) and the mean of (3). Domain: A > 0.
    """
    t0 = -X * c_y + Y * c_x
    return (
        t0,
        A * c_x * c_y + s_0 * t0,
    )


def ended_fold(R, A, F_0, F_2, m, eta, zeta, d, load, c_0, s_0, c_x, c_y, c_xx, c_yy, X, Y, X_x, Y_y):
    """What vanishes at a fold, by R, with the force F_0 + F_2 Omega^2, by coordinates x and y of the motion's ends: the balance, F along it times A/2, and F; slopes of each by x, y and R.

    Equation (24), (30) and the mean of (3). Domain: A > 0, R + 2 s_0 > 0.
    """
    t0 = 1.0 / A
    t1 = R + 2.0 * s_0
    square = t0 * t1
    speed = A.sqrt() * t1.sqrt()
    force = F_0 + F_2 * square
    t2 = 2.0 * zeta
    t3 = d * speed.square()
    I = A * eta + m + speed * t2 + t3
    drift = -m + t3
    t4 = force.square()
    t5 = I * drift + t4
    t6 = X * c_y
    t7 = Y * c_x
    t8 = -t6 + t7
    t9 = 4.0 * A
    t10 = c_y * t9
    t11 = 4.0 * s_0
    t12 = c_x * t10 + t11 * t8
    t13 = 4.0 * t6
    t14 = R * t11
    t15 = 2.0 * A
    t16 = R * X + c_x * t15
    t17 = I * d * t8
    t18 = s_0 * t0
    t19 = -X * t18 + c_x
    t20 = R * (4.0 * Y * c_x - t13)
    t21 = R * (Y * t11 + t10) + Y * t5
    t22 = (2.0 * d * speed + t2) / speed
    t23 = 0.5 * t22
    t24 = X * eta + t16 * t23
    t25 = drift * t8
    t26 = R * (-X * t11 + c_x * t9) - X * t5
    t27 = 0.5 * t0 * (-t6 - t7)
    t28 = t1 / (A.square())
    t29 = 2.0 * t0
    t30 = F_2 * force
    t31 = 2.0 * t30
    t32 = t31 * (-X * t28 + t19 * t29)
    t33 = R * Y - c_y * t15
    t34 = -Y * t18 - c_y
    t35 = Y * eta + t23 * t33
    t36 = t31 * (-Y * t28 + t29 * t34)
    t37 = t29 * t30
    return (
        c_0 - load,
        R * t12 + t5 * t8,
        I.square() + R.square() - t4,
        c_x,
        c_y,
        0.0,
        R * c_x * t13 + X_x * (-c_y * t14 - c_y * t5) + c_xx * t21 + t16 * t17 + t19 * t20 + t24 * t25 + t26 * t27 +
        t32 * t8,
        4.0 * R * c_y * t7 + Y_y * (c_x * t14 + c_x * t5) + c_yy * t26 + t17 * t33 + t20 * t34 + t21 * t27 + t25 *
        t35 + t36 * t8,
        A * t17 + A * t23 * t25 + t12 + t37 * t8,
        2.0 * I * t24 - t32,
        2.0 * I * t35 - t36,
        A * I * t22 + 2.0 * R - t37,
    )


def beside(B, c_3, s_2):
    """(c_1^2 - s_1^2)/c_1 of an odd force without a load where f_0 = 0 and B is not 0, with c_3 and s_2 of some B between 0 and there.

    Equation the mean of (3). Domain: c_3 other than 0.
    """
    return 0.33333333333333331 * B.square() * c_3 - 3.0 * s_2.square() / c_3
