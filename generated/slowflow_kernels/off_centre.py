"""Motions off the centre, u = B + A cos psi, by the means of the force and its derivatives over a cycle.

Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
derivations/asymmetric/off_centre.py; never edit.

Rounding errors were measured with A, B, F_0, X, Y, force, root 1e-09 to 1000; F_2 1e-09 to 1000 or 0; I, d 1e-12 to
1000 or 0; I_A, L_1, L_2, L_k, M_1, M_2, M_k, X_x, Y_y, a, c_0, c_0_p, c_1, c_1_p, c_2, c_2_p, c_3, c_x, c_xx, c_y,
c_yy, end_p, load, load_p, s_0, s_0_p, s_1, s_1_p, s_2, s_2_p, s_3, span 1e-09 to 1000 of either sign or 0; Omega
0.001 to 1000; R 1e-09 to 1e+06 of either sign or 0; angle 1e-09 to 3.142; eta, m, zeta 1e-12 to 1 or 0; h 1e-12 to
1000 of either sign or 0; k 1 to 1000 of either sign or 0; side 1 to 1 of either sign.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.support.backend import from_c

__all__ = [
    "averaged", "begin", "beside", "down", "ended_along", "ended_fold", "ended_slopes", "ended_state", "fold",
    "frequency_by_phase", "moved", "moved_at_end", "state", "up",
]


def averaged(A: Any, c_1: Any, c_2: Any, c_3: Any, s_0: Any, s_1: Any, s_2: Any, s_3: Any) -> tuple[Any, Any, Any, Any]:
    """h, h_A, h_AA, h_AAA along the balance of the mean.

    Equation (20), (31). Domain: A > 0, c_1 other than 0. Operations: 105. Error / u (1 + kappa): proved 0.0, 2.01,
    28.01, -; measured 0.78.
    """
    t0 = 1.0 / c_1
    B_A = -s_1 * t0
    t1 = 1.0 / A
    t2 = 2.0 * s_2
    B_A2 = B_A * B_A
    B_AA = t0 * t1 * (-A * (B_A * t2 + B_A2 * c_2 + c_2) + s_1)
    A2 = A * A
    t3 = 1.0 / A2
    t4 = 2.0 * s_1
    t5 = 3.0 * B_A
    t6 = B_AA * s_2
    B_A3 = B_A * B_A2
    t7 = B_AA * c_2
    B_AAA = (
        t0 * t3 * (A * (c_2 + s_2 * t5) - A2 * (3.0 * B_A2 * s_3 + B_A3 * c_3 + c_3 * t5 + s_3 + t5 * t7 + 3.0 * t6)
        - t4)
    )
    t8 = 6.0 * B_A
    A3 = A * A2
    return (
        -2.0 * s_0,
        -B_A * t4 - 2.0 * c_1 + 2.0 * s_0 * t1,
        -4.0 * B_A * c_2 + 4.0 * B_A * s_1 * t1 - B_A2 * t2 - B_AA * t4 + 2.0 * c_1 * t1 - 4.0 * s_0 * t3 - t2,
        6.0 * B_A * c_2 * t1 - 12.0 * B_A * s_1 * t3 - 6.0 * B_A2 * c_3 + 6.0 * B_A2 * s_2 * t1 - 2.0 * B_A3 * s_3 +
        6.0 * B_AA * s_1 * t1 - B_AAA * t4 - 6.0 * c_1 * t3 - 2.0 * c_3 + 4.0 * s_2 * t1 - s_3 * t8 - t6 * t8 - 6.0
        * t7 + 12.0 * s_0 / A3,
    )


def state(Omega: Any, A: Any, force: Any, I: Any, I_A: Any, load: Any, c_0: Any, c_1: Any, s_0: Any, s_1: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """What vanishes at a steady state: the balance of the mean and F; slopes of each by A and B.

    Equation (24) and the mean of (3). Domain: A > 0. Operations: 21. Error / u (1 + kappa): proved 1.01, -, 0.0,
    0.0, -, 1.51; measured 1.1.
    """
    t0 = 2.0 * s_0
    t1 = Omega * Omega
    R = A * t1 - t0
    return (
        c_0 - load,
        I * I + R * R - force * force,
        s_1, c_1,
        2.0 * I * I_A + 2.0 * R * (-2.0 * c_1 + t1 + t0 / A),
        -4.0 * R * s_1,
    )


def fold(R: Any, A: Any, F_0: Any, F_2: Any, m: Any, eta: Any, zeta: Any, d: Any, load: Any, c_0: Any, c_1: Any, c_2: Any, s_0: Any, s_1: Any, s_2: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """What vanishes at a fold, by R, with the force F_0 + F_2 Omega^2: the balance, F along it by c_1 A/2, and F; slopes of each by A, B and R.

    Equation (24), (30) and the mean of (3). Domain: A > 0, R + 2 s_0 > 0. Operations: 125. Error / u (1 + kappa):
    measured 1.4.
    """
    t0 = 1.0 / A
    t1 = R + 2.0 * s_0
    square = t0 * t1
    speed = np.sqrt(A) * np.sqrt(t1)
    force = F_0 + F_2 * square
    t2 = 2.0 * zeta
    t3 = d * speed * speed
    I = A * eta + m + speed * t2 + t3
    drift = -m + t3
    t4 = force * force
    t5 = I * drift + t4
    t6 = c_1 * c_1
    t7 = s_1 * s_1
    t8 = 2.0 * A
    t9 = t8 * (t6 - t7)
    t10 = c_1 * t8
    t11 = R + t10
    t12 = I * d
    t13 = c_1 * t12
    t14 = c_1 - s_0 * t0
    t15 = 4.0 * c_1
    t16 = R * t15
    t17 = s_1 * t0
    t18 = 4.0 * A * R * s_1
    t19 = R * (-A * t15 + 4.0 * s_0) + t5
    t20 = (2.0 * d * speed + t2) / speed
    t21 = 0.5 * t20
    t22 = eta + t11 * t21
    t23 = c_1 * drift
    t24 = 2.0 * t0
    t25 = F_2 * force
    t26 = 2.0 * t25 * (t14 * t24 - t1 / (A * A))
    t27 = t17 * t25
    t28 = A * t20
    t29 = t24 * t25
    return (
        c_0 - load,
        R * (4.0 * c_1 * s_0 - t9) + c_1 * t5,
        I * I + R * R - t4,
        s_1, c_1, 0.0,
        R * (-2.0 * t6 + 2.0 * t7) + c_1 * t26 + s_2 * t19 + t11 * t13 + t14 * t16 + t18 * (c_2 - t17) + t22 * t23,
        c_2 * t19 + s_1 * t10 * t12 + s_1 * t16 + s_1 * t23 * t28 + s_2 * t18 + t15 * t27,
        A * t13 + A * t21 * t23 + 4.0 * c_1 * s_0 + c_1 * t29 - t9,
        2.0 * I * t22 - t26,
        I * s_1 * t20 * t8 - 4.0 * t27,
        I * t28 + 2.0 * R - t29,
    )


def ended_state(Omega: Any, A: Any, force: Any, I: Any, I_A: Any, load: Any, c_0: Any, s_0: Any, c_x: Any, c_y: Any, X: Any, Y: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """What vanishes at a steady state, by coordinates x and y of the motion's ends: the balance of the mean and F; slopes of each by x and y.

    Equation (24) and the mean of (3). Domain: A > 0. Operations: 30. Error / u (1 + kappa): proved 1.01, -, 0.0,
    0.0, -, -; measured 1.2.
    """
    t0 = 2.0 * s_0
    t1 = Omega * Omega
    R = A * t1 - t0
    t2 = 2.0 * I * I_A
    t3 = t0 / A
    t4 = 2.0 * R
    return (
        c_0 - load,
        I * I + R * R - force * force,
        c_x, c_y,
        X * t2 + t4 * (X * t1 + X * t3 - 2.0 * c_x),
        Y * t2 + t4 * (Y * t1 + Y * t3 + 2.0 * c_y),
    )


def ended_slopes(A: Any, s_0: Any, c_x: Any, c_y: Any, X: Any, Y: Any) -> tuple[Any, Any, Any]:
    """Slopes of s_0 by coordinates x and y of the motion's ends, and of c_x by y.

    Equation the mean of (3). Domain: A > 0. Operations: 11. Error / u (1 + kappa): proved 1.26, 1.26, 2.01.
    """
    t0 = 1.0 / A
    t1 = s_0 * t0
    return -X * t1 + c_x, -Y * t1 - c_y, 0.5 * t0 * (-X * c_y - Y * c_x)


def ended_fold(R: Any, A: Any, F_0: Any, F_2: Any, m: Any, eta: Any, zeta: Any, d: Any, load: Any, c_0: Any, s_0: Any, c_x: Any, c_y: Any, c_xx: Any, c_yy: Any, X: Any, Y: Any, X_x: Any, Y_y: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """What vanishes at a fold, by R, with the force F_0 + F_2 Omega^2, by coordinates x and y of the motion's ends: the balance, F along it times A/2, and F; slopes of each by x, y and R.

    Equation (24), (30) and the mean of (3). Domain: A > 0, R + 2 s_0 > 0. Operations: 155. Error / u (1 + kappa):
    measured 1.4.
    """
    t0 = 1.0 / A
    t1 = R + 2.0 * s_0
    square = t0 * t1
    speed = np.sqrt(A) * np.sqrt(t1)
    force = F_0 + F_2 * square
    t2 = 2.0 * zeta
    t3 = d * speed * speed
    I = A * eta + m + speed * t2 + t3
    drift = -m + t3
    t4 = force * force
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
    t28 = t1 / (A * A)
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
        I * I + R * R - t4,
        c_x, c_y, 0.0,
        R * c_x * t13 + X_x * (-c_y * t14 - c_y * t5) + c_xx * t21 + t16 * t17 + t19 * t20 + t24 * t25 + t26 * t27 +
        t32 * t8,
        4.0 * R * c_y * t7 + Y_y * (c_x * t14 + c_x * t5) + c_yy * t26 + t17 * t33 + t20 * t34 + t21 * t27 + t25 *
        t35 + t36 * t8,
        A * t17 + A * t23 * t25 + t12 + t37 * t8,
        2.0 * I * t24 - t32,
        2.0 * I * t35 - t36,
        A * I * t22 + 2.0 * R - t37,
    )


def frequency_by_phase(A: Any, R: Any, I: Any, m: Any, zeta: Any, h: Any) -> tuple[Any, Any]:
    """Omega of a motion by I; and its square by R.

    Equation (23). Domain: A > 0, zeta > 0. Operations: 7. Error / u (1 + kappa): proved 4.01, 3.01.
    """
    t0 = 1.0 / A
    return 0.5 * t0 * (I - m) / zeta, t0 * (R - h)


def beside(B: Any, c_3: Any, s_2: Any) -> Any:
    """(c_1^2 - s_1^2)/c_1 of an odd force without a load where f_0 = 0 and B is not 0, with c_3 and s_2 of some B between 0 and there.

    Equation the mean of (3). Domain: c_3 other than 0. Operations: 7. Error / u (1 + kappa): proved 1.51.
    """
    return 0.33333333333333331 * B * B * c_3 - 3.0 * s_2 * s_2 / c_3


def moved(A: Any, c_1: Any, c_2: Any, c_3: Any, s_1: Any, s_2: Any, s_3: Any, c_0_p: Any, c_1_p: Any, c_2_p: Any, s_0_p: Any, s_1_p: Any, s_2_p: Any, load_p: Any) -> tuple[Any, Any, Any, Any]:
    """B_p, h_p, h_Ap, h_AAp along the balance at a fixed A, by what a parameter does to means and load.

    Equation (20), (31). Domain: A > 0, c_1 other than 0. Operations: 119. Error / u (1 + kappa): proved 3.01, 5.01,
    -, -; measured 1.3.
    """
    t0 = 1.0 / c_1
    B_A = -s_1 * t0
    t1 = 2.0 * s_2
    t2 = B_A * B_A
    t3 = 1.0 / A
    t4 = t0 * t3
    B_AA = t4 * (-A * (B_A * t1 + c_2 * t2 + c_2) + s_1)
    B_p = t0 * (-c_0_p + load_p)
    t5 = B_p * c_2
    t6 = B_p * s_2
    t7 = s_1_p + t6
    B_Ap = t0 * (-B_A * c_1_p - B_A * t5 - t7)
    t8 = B_p * c_3
    t9 = 2.0 * s_2_p
    t10 = B_Ap * c_2
    t11 = 2.0 * B_A
    t12 = 2.0 * B_p * s_3
    B_AAp = (
        t4 * (-A * (B_A * t12 + B_A * t9 + B_AA * c_1_p + B_AA * t5 + B_Ap * t1 + c_2_p * t2 + c_2_p + t10 * t11 +
        t2 * t8 + t8) + t7)
    )
    t13 = 2.0 * s_1
    t14 = 2.0 * s_1_p
    t15 = 4.0 * B_A
    t16 = 4.0 / (A * A)
    return (
        B_p,
        -B_p * t13 - 2.0 * s_0_p,
        -B_A * t14 - B_Ap * t13 + 2.0 * B_p * s_1 * t3 - 2.0 * c_1_p + 2.0 * s_0_p * t3 - t11 * t6 - 2.0 * t5,
        4.0 * B_A * B_p * s_2 * t3 + 4.0 * B_A * s_1_p * t3 - B_AA * t14 - 2.0 * B_AA * t6 - B_AAp * t13 + 4.0 *
        B_Ap * s_1 * t3 - B_Ap * s_2 * t15 + 2.0 * B_p * c_2 * t3 - B_p * s_1 * t16 + 2.0 * c_1_p * t3 - c_2_p * t15
        - s_0_p * t16 - 4.0 * t10 - t12 * t2 - t12 - t15 * t8 - t2 * t9 - t9,
    )


def moved_at_end(side: Any, c_1: Any, s_1: Any, c_0_p: Any, load_p: Any, end_p: Any) -> tuple[Any]:
    """A_p of a motion that comes to an end of a piece: at B + A for side = 1, at B - A for side = -1.

    Equation the mean of (3). Domain: side c_1 other than s_1. Operations: 6. Error / u (1 + kappa): measured 0.8.
    """
    t0 = c_1 * side
    return (
        (c_0_p + end_p * t0 - load_p) / (-s_1 + t0),
    )

#: functions that no Python code calls, which are in C, with their arguments; see generated/c/off_centre.h
FROM_C = {
    "ended_along": "A s_0 c_x c_y X Y",
    "begin": "A a root angle",
    "up": "k A a span L_2 L_1 M_2 M_1",
    "down": "k A a root L_1 L_k M_1 M_k",
}
globals().update(from_c("off_centre", FROM_C))
