
"""The quartics whose roots are the frequencies at an amplitude: F of the response, F_A/2 of the folds.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/paper/averaging.py, derivations/paper/slow_flow.py, derivations/systems/frequencies.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless, for floats and arrays of them as they are. Each docstring gives equation number and domain.
Rounding errors are in u (1 + kappa), u = 2^-53: proved ones hold wherever nothing overflows or underflows, measured
ones are the worst of all outputs that was found, by a search for it with A 1e-09 to 1000, F_0 1e-09 to 1000, Omega
0.001 to 1000, h 1e-12 to 1000 of either sign or 0, h_A 1e-09 to 1e+06 of either sign or 0, k 1e-09 to 1000 of
either sign, m 1e-12 to 1 or 0, p 1e-09 to 1000 of either sign, p_low up to 1e-10 of either sign, q 1e-12 to 1000 or
0, q_low up to 1e-10 of either sign, tail up to 1e-10 of either sign, zeta 1e-12 to 1 or 0.
"""

# a formatter would spread each polynomial over a page
# fmt: off

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.support.twofold import distilled, two_product, two_sum

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

ROUGH = 8.881784197001252e-16
FINE = 3.1554436208840472e-30

__all__ = [
    "FINE", "ROUGH", "cubic", "cubic_fine", "cubic_slope", "discriminant", "fold", "fold_at_0", "fold_beside",
    "fold_derivative", "fold_fine", "response", "response_at_0", "response_beside", "response_derivative",
    "response_exactly_at_0", "response_fine", "rise",
]


def response(Omega: Any, A: Any, F_0: Any, m: Any, zeta: Any, h: Any) -> tuple[Any, Any]:
    """F, and what its rounding error is below ROUGH times of.

    Equation (24). Domain: Omega >= 0, A > 0. Operations: 20. Error / u (1 + kappa): measured 0.98.
    """
    t0 = A * Omega * Omega
    R = h + t0
    I = 2.0 * A * Omega * zeta + m
    t1 = F_0 + I
    t2 = t0 + np.abs(h)
    return R * R + t1 * (-F_0 + I), t1 * t1 + t2 * (8.8817841970012523e-16 * t2 + np.abs(R))


def response_at_0(F_0: Any, m: Any, h: Any) -> tuple[Any, Any]:
    """F at Omega = 0, and what its rounding error is below ROUGH times of.

    Equation (24). Domain: any. Operations: 7. Error / u (1 + kappa): proved -, 1.34; measured 1.3.
    """
    t0 = h * h
    t1 = F_0 + m
    return t0 + t1 * (-F_0 + m), t0 + t1 * t1


def fold(Omega: Any, A: Any, m: Any, zeta: Any, h: Any, h_A: Any) -> tuple[Any, Any]:
    """F_A/2, and what its rounding error is below ROUGH times of.

    Equation (30). Domain: Omega >= 0, A > 0. Operations: 23. Error / u (1 + kappa): measured 1.1.
    """
    t0 = Omega * Omega
    t1 = A * t0
    R = h + t1
    t2 = 2.0 * Omega * zeta
    I = A * t2 + m
    t3 = I * t2
    t4 = h_A + t0
    t5 = t1 + np.abs(h)
    return R * t4 + t3, t3 + t5 * np.abs(t4) + (t0 + np.abs(h_A)) * (8.8817841970012523e-16 * t5 + np.abs(R))


def fold_at_0(h: Any, h_A: Any) -> Any:
    """F_A/2 at Omega = 0.

    Equation (30). Domain: any. Operations: 1. Error / u (1 + kappa): proved 0.34.
    """
    return h * h_A


def cubic(Omega: Any, A: Any, p: Any, q: Any) -> Any:
    """A Omega^3 + p Omega + q.

    Equation from (24), (30). Domain: Omega >= 0, A > 0. Operations: 5. Error / u (1 + kappa): proved 2.67.
    """
    return Omega * (A * Omega * Omega + p) + q


def cubic_slope(Omega: Any, A: Any, p: Any) -> Any:
    """Its derivative by Omega.

    Equation from (24), (30). Domain: Omega >= 0, A > 0. Operations: 4. Error / u (1 + kappa): proved 1.26.
    """
    return 3.0 * A * Omega * Omega + p


def rise(Omega: Any, A: Any, p: Any, k: Any) -> tuple[Any, Any]:
    """Of a quartic from 0 to a critical point, and its magnitude.

    Equation from (24), (30). Domain: Omega >= 0, A > 0. Operations: 11. Error / u (1 + kappa): proved 3.01, -;
    measured 0.55.
    """
    t0 = Omega * Omega
    t1 = 0.75 * A * t0
    t2 = k * t0
    return t2 * (-0.5 * p - t1), t2 * (t1 + 0.5 * np.abs(p))


def response_fine(Omega: ArrayLike, A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> tuple[Any, Any]:
    """F in double-double, and what its error is below FINE times of.

    Exact: 6 products and 4 sums. Equation (24). Domain: Omega >= 0, A > 0. Error / u (1 + kappa): measured 1.9.
    """
    d0, d0_low = two_product(A, Omega)
    d1, d1_low = two_product(d0, Omega)
    d2 = d0_low * Omega + d1_low
    R, d3_low = two_sum(d1, h)
    R_low = d2 + d3_low
    d5, d5_low = two_product(d0, 2.0 * zeta)
    d6 = d0_low * (2.0 * zeta) + d5_low
    I, d7_low = two_sum(d5, m)
    I_low = d6 + d7_low
    d9, d9_low = two_product(F_0, F_0)
    d10, d10_low = two_product(I, I)
    d11 = I_low * (2.0 * I + I_low) + d10_low
    d12, d12_low = two_product(R, R)
    d13 = R_low * (2.0 * R + R_low) + d12_low
    d14, d14_low = two_sum(-d9, d10)
    d15 = d11 + d14_low - d9_low
    d16, d16_low = two_sum(d14, d12)
    d17 = d13 + d15 + d16_low
    t0 = A * Omega * Omega + np.abs(h)
    t1 = F_0 + I
    return d16 + d17, t0 * (3.1554436208840472e-30 * t0 + np.abs(R)) + t1 * t1


def response_beside(Omega: ArrayLike, tail: ArrayLike, A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> tuple[Any, Any]:
    """F at Omega + tail in double-double, and what its error is below FINE times of.

    Exact: 7 products and 4 sums. Equation (24). Domain: Omega >= 0, A > 0. Error / u (1 + kappa): measured 1.7.
    """
    d0, d0_low = two_product(A, Omega)
    d1 = A * tail + d0_low
    d2, d2_low = two_product(d0, Omega)
    d3 = d0 * tail + d2_low
    d4 = d1 * (Omega + tail) + d3
    R, d5_low = two_sum(d2, h)
    R_low = d4 + d5_low
    d7, d7_low = two_product(A, 2.0 * zeta)
    d8, d8_low = two_product(d7, Omega)
    d9 = d7 * tail + d8_low
    d10 = d7_low * (Omega + tail) + d9
    I, d11_low = two_sum(d8, m)
    I_low = d10 + d11_low
    d13, d13_low = two_product(F_0, F_0)
    d14, d14_low = two_product(I, I)
    d15 = I_low * (2.0 * I + I_low) + d14_low
    d16, d16_low = two_product(R, R)
    d17 = R_low * (2.0 * R + R_low) + d16_low
    d18, d18_low = two_sum(-d13, d14)
    d19 = -d13_low + d15 + d18_low
    d20, d20_low = two_sum(d18, d16)
    d21 = d17 + d19 + d20_low
    t0 = A * Omega * Omega + np.abs(h)
    t1 = F_0 + I
    return d20 + d21, t0 * (3.1554436208840472e-30 * t0 + np.abs(R)) + t1 * t1


def response_derivative(A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> tuple[Any, Any, Any, Any, Any]:
    """The derivative of F by Omega is k (A Omega^3 + p Omega + q): p, p_low, q, q_low, k.

    Exact: 3 products and 2 sums. Equation (24). Domain: A > 0. Error / u (1 + kappa): measured 0.31.
    """
    d0, d0_low = two_product(A, zeta)
    d1, d1_low = two_product(d0, 2.0 * zeta)
    d2 = d0_low * (2.0 * zeta) + d1_low
    d3, d3_low = two_sum(d1, h)
    d4 = d2 + d3_low
    d5, d5_low = two_sum(d3, d4)
    d6, d6_low = two_product(m, zeta)
    return d5, d5_low, d6, d6_low, 4.0 * A


def response_exactly_at_0(F_0: ArrayLike, m: ArrayLike, h: ArrayLike) -> Any:
    """F at Omega = 0, with a certain sign.

    Exact: 3 products. Equation (24). Domain: any. Error / u (1 + kappa): measured 0.34.
    """
    d0, d0_low = two_product(h, h)
    d1, d1_low = two_product(m, m)
    d2, d2_low = two_product(F_0, F_0)
    return distilled([d0_low, d1_low, -d2_low, d0, d1, -d2])


def fold_fine(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike) -> tuple[Any, Any]:
    """F_A/2 in double-double, and what its error is below FINE times of.

    Exact: 7 products and 4 sums. Equation (30). Domain: Omega >= 0, A > 0. Error / u (1 + kappa): measured 1.5.
    """
    d0, d0_low = two_product(A, Omega)
    d1, d1_low = two_product(d0, Omega)
    d2 = d0_low * Omega + d1_low
    R, d3_low = two_sum(d1, h)
    R_low = d2 + d3_low
    d5, d5_low = two_product(d0, 2.0 * zeta)
    d6 = d0_low * (2.0 * zeta) + d5_low
    I, d7_low = two_sum(d5, m)
    I_low = d6 + d7_low
    d9, d9_low = two_product(Omega, 2.0 * zeta)
    d10, d10_low = two_product(d9, I)
    d11 = d9 * I_low + d10_low
    d12 = d9_low * (I + I_low) + d11
    d13, d13_low = two_product(Omega, Omega)
    d14, d14_low = two_sum(d13, h_A)
    d15 = d13_low + d14_low
    d16, d16_low = two_product(d14, R)
    d17 = d14 * R_low + d16_low
    d18 = d15 * (R + R_low) + d17
    d19, d19_low = two_sum(d10, d16)
    d20 = d12 + d18 + d19_low
    t0 = Omega * Omega
    t1 = A * t0 + np.abs(h)
    return (
        d19 + d20,
        2.0 * I * Omega * zeta + t1 * np.abs(h_A + t0) + (t0 + np.abs(h_A)) * (3.1554436208840472e-30 * t1 +
        np.abs(R)),
    )


def fold_beside(Omega: ArrayLike, tail: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike) -> tuple[Any, Any]:
    """F_A/2 at Omega + tail in double-double, and what its error is below FINE times of.

    Exact: 8 products and 4 sums. Equation (30). Domain: Omega >= 0, A > 0. Error / u (1 + kappa): measured 1.1.
    """
    d0, d0_low = two_product(A, Omega)
    d1 = A * tail + d0_low
    d2, d2_low = two_product(d0, Omega)
    d3 = d0 * tail + d2_low
    d4 = d1 * (Omega + tail) + d3
    R, d5_low = two_sum(d2, h)
    R_low = d4 + d5_low
    d7, d7_low = two_product(A, 2.0 * zeta)
    d8, d8_low = two_product(d7, Omega)
    d9 = d7 * tail + d8_low
    d10 = d7_low * (Omega + tail) + d9
    I, d11_low = two_sum(d8, m)
    I_low = d10 + d11_low
    d13, d13_low = two_product(2.0 * zeta, I)
    d14 = (2.0 * zeta) * I_low + d13_low
    d15, d15_low = two_product(d13, Omega)
    d16 = d13 * tail + d15_low
    d17 = d14 * (Omega + tail) + d16
    d18, d18_low = two_product(Omega, Omega)
    d19 = tail * (2.0 * Omega + tail) + d18_low
    d20, d20_low = two_sum(d18, h_A)
    d21 = d19 + d20_low
    d22, d22_low = two_product(d20, R)
    d23 = d20 * R_low + d22_low
    d24 = d21 * (R + R_low) + d23
    d25, d25_low = two_sum(d15, d22)
    d26 = d17 + d24 + d25_low
    t0 = Omega * Omega
    t1 = A * t0 + np.abs(h)
    return (
        d25 + d26,
        2.0 * I * Omega * zeta + t1 * np.abs(h_A + t0) + (t0 + np.abs(h_A)) * (3.1554436208840472e-30 * t1 +
        np.abs(R)),
    )


def fold_derivative(A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike) -> tuple[Any, Any, Any, Any, Any]:
    """The derivative of F_A/2 by Omega is k (A Omega^3 + p Omega + q): p, p_low, q, q_low, k.

    Exact: 4 products and 4 sums. Equation (30). Domain: A > 0. Error / u (1 + kappa): measured 0.76.
    """
    d0, d0_low = two_product(A, zeta)
    d1, d1_low = two_product(d0, 2.0 * zeta)
    d2 = d0_low * (2.0 * zeta) + d1_low
    d3, d3_low = two_product(A, h_A)
    d4, d4_low = two_sum(d1, 0.5 * d3)
    d5 = d2 + 0.5 * d3_low + d4_low
    d6, d6_low = two_sum(d4, 0.5 * h)
    d7 = d5 + d6_low
    d8, d8_low = two_sum(d6, d7)
    d9, d9_low = two_product(m, zeta)
    d10, d10_low = two_sum(0.5 * d9, 0.5 * d9_low)
    return d8, d8_low, d10, d10_low, 4.0


def cubic_fine(Omega: ArrayLike, A: ArrayLike, p: ArrayLike, p_low: ArrayLike, q: ArrayLike, q_low: ArrayLike) -> Any:
    """A Omega^3 + p Omega + q in double-double.

    Exact: 3 products and 2 sums. Equation from (24), (30). Domain: A > 0. Error / u (1 + kappa): measured 0.5.
    """
    d0, d0_low = two_product(A, Omega)
    d1, d1_low = two_product(d0, Omega)
    d2 = d0_low * Omega + d1_low
    d3, d3_low = two_sum(d1, p)
    d4 = d2 + d3_low + p_low
    d5, d5_low = two_product(Omega, d3)
    d6 = Omega * d4 + d5_low
    d7, d7_low = two_sum(d5, q)
    d8 = d6 + d7_low + q_low
    return d7 + d8


def discriminant(A: ArrayLike, p: ArrayLike, p_low: ArrayLike, q: ArrayLike, q_low: ArrayLike) -> tuple[Any, Any]:
    """Of the cubic, over A: for p < 0 < q positive where it has two positive roots; and its first term.

    Exact: 5 products and 1 sum. Equation from (24), (30). Domain: A > 0. Error / u (1 + kappa): measured 1.6.
    """
    d0, d0_low = two_product(27.0, A)
    d1, d1_low = two_product(d0, q)
    d2 = d0 * q_low + d1_low
    d3 = d0_low * (q + q_low) + d2
    d4, d4_low = two_product(d1, q)
    d5 = d1 * q_low + d4_low
    d6 = d3 * (q + q_low) + d5
    d7, d7_low = two_product(p, p)
    d8 = p_low * (2.0 * p + p_low) + d7_low
    d9, d9_low = two_product(d7, p)
    d10 = d7 * p_low + d9_low
    d11 = d8 * (p + p_low) + d10
    d12, d12_low = two_sum(-d4, -4.0 * d9)
    d13 = -4.0 * d11 + d12_low - d6
    p2 = p * p
    p3 = p * p2
    return d12 + d13, -4.0 * p3

