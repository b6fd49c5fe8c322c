
"""The average of a force that is known by its values and those of its derivatives, u = A sine.

Written by `make derive` from derivations/forces/quadrature.py, derivations/forces/sampled.py; never edit.

Everything is dimensionless. Arguments broadcast; each output has their common shape, NumPy scalars for scalars, where
arguments are of type ArrayLike, and the shape of those that it depends on where they may be any kind of number. Each
docstring gives equation number, domain and floating-point operations, by regime where there are several.
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

from slowflow.support.backend import from_c

__all__ = [
    "at_rest", "averaged_end", "averaged_terms", "bent_end_0", "bent_end_1", "bent_end_2", "bent_end_3",
    "bent_terms", "harmonics_end", "harmonics_terms", "intercept_end", "intercept_terms",
]


def at_rest(f: Any) -> Any:
    """h as A tends to 0.

    Equation (20). Domain: any. Operations: 1. Error / u (1 + kappa): measured 0.73.
    """
    return -1.2732395447351628 * f


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

#: functions that no Python code calls, which are in C, with their arguments; see generated/c/sampled.h
FROM_C = {
    "averaged_terms": "sine f f_u f_uu f_uuu",
    "averaged_end": "A b lost_0 lost_1 lost_2",
    "intercept_terms": "A sine cosine f_uu",
    "intercept_end": "A b lost_0 lost_1",
    "harmonics_terms": "sine f f_u f_uu f_uuu",
    "harmonics_end": "A b lost_0 lost_1 lost_2",
}
globals().update(from_c("sampled", FROM_C))
