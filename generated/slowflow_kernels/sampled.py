
"""The average of a force that is known by its values and those of its derivatives, u = A sine.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/forces/quadrature.py, derivations/forces/sampled.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless, for any kind of number that has arithmetic: floats, complex numbers, arrays, an integrator's
symbols. Each output has the shape of the arguments that it depends on, broadcast. Each docstring gives equation number,
domain and floating-point operations.
Rounding errors are in u (1 + kappa), u = 2^-53: proved ones hold wherever nothing overflows or underflows, measured
ones are the worst of all outputs that was found, by a search for it with A 1e-09 to 1000, b 1e-09 to 1000, cosine
1e-09 to 1, f 1e-09 to 1000 of either sign or 0, f_u 1e-09 to 1000 of either sign or 0, f_uu 1e-09 to 1000 of either
sign or 0, f_uuu 1e-09 to 1000 of either sign or 0, f_uuuu 1e-09 to 1000 of either sign or 0, lost_0 1e-09 to 1000
of either sign or 0, lost_1 1e-09 to 1000 of either sign or 0, lost_2 1e-09 to 1000 of either sign or 0, lost_3
1e-09 to 1000 of either sign or 0, sine 1e-09 to 1.
"""

# a formatter would spread each polynomial over a page
# fmt: off

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np


__all__ = [
    "at_rest", "averaged_end", "averaged_terms", "bent_end_0", "bent_end_1", "bent_end_2", "bent_end_3",
    "bent_terms", "harmonics_end", "harmonics_terms", "intercept_end", "intercept_terms",
]


def at_rest(f: Any) -> Any:
    """h as A tends to 0.

    Equation (20). Domain: any. Operations: 1. Error / u (1 + kappa): measured 0.73.
    """
    return -1.2732395447351628 * f


def averaged_terms(sine: Any, f: Any, f_u: Any, f_uu: Any, f_uuu: Any) -> tuple[Any, Any, Any, Any]:
    """Under the integrals of h, h_A, h_AA, h_AAA over the quarter cycle.

    Equation (20)-(22), (31). Domain: any. Operations: 11. Error / u (1 + kappa): measured 0.66.
    """
    sine2 = sine * sine
    sine3 = sine * sine2
    sine4 = sine2 * sine2
    return (
        -1.2732395447351628 * f * sine,
        -1.2732395447351628 * f_u * sine2,
        -1.2732395447351628 * f_uu * sine3,
        -1.2732395447351628 * f_uuu * sine4,
    )


def averaged_end(A: Any, b: Any, lost_0: Any, lost_1: Any, lost_2: Any) -> tuple[Any, Any, Any]:
    """What a breakpoint adds to h_A, h_AA, h_AAA.

    Equation (21), (22), (31). Domain: A > b > 0. Operations: 49. Error / u (1 + kappa): measured 0.94.
    """
    root = np.sqrt(A - b) * np.sqrt(A + b)
    A2 = A * A
    t0 = 1.2732395447351628
    t1 = t0 / root
    b2 = b * b
    t2 = b2 * lost_0
    A3 = A * A2
    t3 = 1.0 / A3
    b3 = b * b2
    t4 = b3 * lost_1
    root2 = root * root
    root3 = root * root2
    t5 = t0 / root3
    A4 = A2 * A2
    t6 = 1.0 / A4
    b4 = b2 * b2
    root4 = root2 * root2
    root5 = root * root4
    return (
        t1 * t2 / A2,
        t1 * t3 * t4 - t2 * t3 * t5 * (A2 + 2.0 * root2),
        b4 * lost_2 * t1 * t6 - t4 * t5 * t6 * (A2 + 3.0 * root2) + 3.8197186342054881 * t2 * t6 * (A2 * root2 + A4
        + 2.0 * root4) / root5,
    )


def intercept_terms(A: Any, sine: Any, cosine: Any, f_uu: Any) -> Any:
    """Under the integral of h - A h_A, which `at_rest` adds to.

    Equation from (20). Domain: any. Operations: 6. Error / u (1 + kappa): measured 0.52.
    """
    return 1.2732395447351628 * A * A * cosine * cosine * f_uu * sine


def intercept_end(A: Any, b: Any, lost_0: Any, lost_1: Any) -> Any:
    """What a breakpoint adds to h - A h_A.

    Equation from (20). Domain: A > b > 0. Operations: 16. Error / u (1 + kappa): measured 2.7.
    """
    root = np.sqrt(A - b) * np.sqrt(A + b)
    t0 = 1.0 / A
    return 1.2732395447351628 * (-b * b * lost_0 * t0 / root + root * t0 * (-b * lost_1 + lost_0))


def harmonics_terms(sine: Any, f: Any, f_u: Any, f_uu: Any, f_uuu: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any]:
    """Under the integrals of h_3 and three derivatives, then of h_5.

    Equation beyond (20). Domain: any. Operations: 23. Error / u (1 + kappa): measured 1.4.
    """
    sine2 = sine * sine
    T_2 = 2.0 * sine2 - 1.0
    t0 = 2.0 * T_2
    T_3 = sine * (t0 - 1.0)
    T_5 = T_3 * t0 - sine
    t1 = 1.2732395447351628 * f
    t2 = 1.2732395447351628 * T_3
    t3 = f_u * sine
    t4 = f_uu * sine2
    sine3 = sine * sine2
    t5 = f_uuu * sine3
    t6 = 1.2732395447351628 * T_5
    return -T_3 * t1, -t2 * t3, -t2 * t4, -t2 * t5, -T_5 * t1, -t3 * t6, -t4 * t6, -t5 * t6


def harmonics_end(A: Any, b: Any, lost_0: Any, lost_1: Any, lost_2: Any) -> tuple[Any, Any, Any, Any, Any, Any]:
    """What a breakpoint adds to the three derivatives of h_3, then of h_5.

    Equation beyond (20). Domain: A > b > 0. Operations: 156. Error / u (1 + kappa): measured 2.7.
    """
    root = np.sqrt(A - b) * np.sqrt(A + b)
    A2 = A * A
    A4 = A2 * A2
    b2 = b * b
    t0 = 4.0 * b2 * lost_0
    t1 = 0.31830988618379069 / root
    t2 = t1 * (-3.0 * A2 + 4.0 * b2)
    A5 = A * A4
    t3 = 1.0 / A5
    t4 = 4.0 * t2
    b3 = b * b2
    t5 = b3 * lost_1
    root2 = root * root
    t6 = A2 * root2
    t7 = -4.0 * A2 * b2 + 3.0 * A4
    root3 = root * root2
    t8 = 0.31830988618379069 / root3
    t9 = t0 * t8
    A3 = A * A2
    A6 = A3 * A3
    t10 = 1.0 / A6
    b4 = b2 * b2
    t11 = b4 * lost_2
    t12 = 4.0 * t5
    t13 = t12 * t8
    root4 = root2 * root2
    t14 = A2 * root4
    t15 = A4 * root2
    t16 = t0 * t10
    root5 = root * root4
    t17 = 0.31830988618379069 / root5
    t18 = 16.0 * b4
    t19 = t1 * (-20.0 * A2 * b2 + 5.0 * A4 + t18)
    A7 = A * A6
    t20 = 1.0 / A7
    t21 = b4 * root2
    t22 = A2 * t18 - 20.0 * A4 * b2 + 5.0 * A6
    A8 = A4 * A4
    t23 = 1.0 / A8
    return (
        t0 * t2 / A4,
        t3 * t4 * t5 - t3 * t9 * (16.0 * b2 * root2 - 6.0 * t6 - t7),
        t10 * t11 * t4 - t10 * t13 * (20.0 * b2 * root2 - 9.0 * t6 - t7) + t16 * t17 * (28.0 * A2 * b2 * root2 +
        12.0 * A4 * b2 - 9.0 * A6 + 80.0 * b2 * root4 - 18.0 * t14 - 9.0 * t15),
        t16 * t19,
        t12 * t19 * t20 - t20 * t9 * (-80.0 * b2 * t6 + 10.0 * t15 + 96.0 * t21 + t22),
        t0 * t17 * t23 * (-140.0 * A4 * b2 * root2 + 48.0 * A4 * b4 + 30.0 * A4 * root4 - 60.0 * A6 * b2 + 15.0 * A6
        * root2 + 15.0 * A8 - 400.0 * b2 * t14 + 672.0 * b4 * root4 + 176.0 * b4 * t6) + 4.0 * t11 * t19 * t23 - t13
        * t23 * (-100.0 * b2 * t6 + 15.0 * t15 + 112.0 * t21 + t22),
    )


def bent_terms(sine: Any, f: Any, f_uuuu: Any) -> tuple[Any, Any]:
    """Under the integrals of h and h_AAAA.

    Equation (20), (31). Domain: any. Operations: 7. Error / u (1 + kappa): measured 0.77.
    """
    sine2 = sine * sine
    sine4 = sine2 * sine2
    sine5 = sine * sine4
    return -1.2732395447351628 * f * sine, -1.2732395447351628 * f_uuuu * sine5


def bent_end_0(A: Any, b: Any, lost_0: Any, lost_1: Any, lost_2: Any, lost_3: Any) -> Any:
    """What a breakpoint adds to h_AAAA; derivatives of order 0 are the first to be lost.

    Equation (31). Domain: A > b > 0. Operations: 56. Error / u (1 + kappa): measured 1.1.
    """
    root = np.sqrt(A - b) * np.sqrt(A + b)
    A2 = A * A
    A4 = A2 * A2
    A5 = A * A4
    t0 = 1.0 / A5
    root2 = root * root
    root4 = root2 * root2
    t1 = 3.0 * A4
    root3 = root * root2
    root6 = root3 * root3
    root7 = root * root6
    b2 = b * b
    b4 = b2 * b2
    b5 = b * b4
    b3 = b * b2
    A3 = A * A2
    A6 = A3 * A3
    return (
        -1.2732395447351628 * (3.0 * b2 * lost_0 * t0 * (4.0 * A2 * root4 + 5.0 * A6 + root2 * t1 + 8.0 * root6) +
        root2 * (-b3 * lost_1 * t0 * (5.0 * A2 * root2 + 12.0 * root4 + t1) + root2 * (b4 * lost_2 * t0 * (A2 + 4.0
        * root2) - b5 * lost_3 * root2 * t0))) / root7
    )


def bent_end_1(A: Any, b: Any, lost_1: Any, lost_2: Any, lost_3: Any) -> Any:
    """What a breakpoint adds to h_AAAA; derivatives of order 1 are the first to be lost.

    Equation (31). Domain: A > b > 0. Operations: 38. Error / u (1 + kappa): measured 0.76.
    """
    root = np.sqrt(A - b) * np.sqrt(A + b)
    A2 = A * A
    A4 = A2 * A2
    A5 = A * A4
    t0 = 1.0 / A5
    root2 = root * root
    root4 = root2 * root2
    root5 = root * root4
    b2 = b * b
    b4 = b2 * b2
    b5 = b * b4
    b3 = b * b2
    return (
        -1.2732395447351628 * (-b3 * lost_1 * t0 * (5.0 * A2 * root2 + 3.0 * A4 + 12.0 * root4) + root2 * (b4 *
        lost_2 * t0 * (A2 + 4.0 * root2) - b5 * lost_3 * root2 * t0)) / root5
    )


def bent_end_2(A: Any, b: Any, lost_2: Any, lost_3: Any) -> Any:
    """What a breakpoint adds to h_AAAA; derivatives of order 2 are the first to be lost.

    Equation (31). Domain: A > b > 0. Operations: 25. Error / u (1 + kappa): measured 1.2.
    """
    root = np.sqrt(A - b) * np.sqrt(A + b)
    A2 = A * A
    A4 = A2 * A2
    A5 = A * A4
    t0 = 1.0 / A5
    root2 = root * root
    root3 = root * root2
    b2 = b * b
    b4 = b2 * b2
    b5 = b * b4
    return -1.2732395447351628 * (b4 * lost_2 * t0 * (A2 + 4.0 * root2) - b5 * lost_3 * root2 * t0) / root3


def bent_end_3(A: Any, b: Any, lost_3: Any) -> Any:
    """What a breakpoint adds to h_AAAA; derivatives of order 3 are the first to be lost.

    Equation (31). Domain: A > b > 0. Operations: 15. Error / u (1 + kappa): measured 0.65.
    """
    root = np.sqrt(A - b) * np.sqrt(A + b)
    A2 = A * A
    A4 = A2 * A2
    A5 = A * A4
    b2 = b * b
    b4 = b2 * b2
    b5 = b * b4
    return 1.2732395447351628 * b5 * lost_3 / (A5 * root)

