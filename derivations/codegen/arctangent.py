"""The arctangent of the C sources: its polynomial and the bound of its error, derived.

In:  the error that is small enough, `ENOUGH`.
Out: `series()`: exact coefficients of a polynomial E such that t + t E(t^2 - 1/2) is near atan(t) on 0 <= t <= 1;
     `in_pairs()`: a table and a power series for twice the digits.

Why not the C library's: a call there does not vectorise, and its last digit differs between libraries and processors.

The generating function of the Chebyshev polynomials gives, for |q| < 1 and |t| <= 1,

    2 sum_k (-1)^k q^(2k+1)/(2k+1) T_{2k+1}(t) = atan(2 q t/(1 - q^2)),

which is atan(t) for the root q = sqrt(2) - 1 of 2 q = 1 - q^2. As |T_{2k+1}(t)| <= (2k+1) |t|, the terms left out
after n are at most 2 |t| sum_{k >= n} q^(2k+1) = |t| q^(2n) (2 q/(1 - q^2)) = |t| q^(2n), and |t| <= (4/pi) |atan t|.

E is expanded about the middle of 0 <= t^2 <= 1, where its terms fall fast enough that they do not cancel: E is between
-0.215 and 0, so that rounding in E counts for little in t + t E.

In double-double the next of n + 1 angles atan(k/n) is taken off first: atan(t) - atan(c) = atan((t - c)/(1 + c t)). Its
argument is at most 1/(2 n), so that few terms of the power series are left, and most of these may be doubles.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass

import sympy as sp
from flint import arb, ctx, fmpq

t, w = sp.symbols("t w")
# relative error of the polynomial, in units of the 2^-53 that one rounding may cost
ENOUGH = sp.Rational(1, 16)
#: in double-double: angles of the table less one, and the relative error that is small enough
PAIRS_CUT, PAIRS_ENOUGH = 16, sp.Rational(1, 2**106)


@dataclass(frozen=True)
class Series:
    """The polynomial t + t E(w), w = t^2 - 1/2.

    coefficients -- of E, constant first, in Q(sqrt 2)
    bound        -- of the relative error on 0 <= t <= 1, in units of 2^-53
    """

    coefficients: tuple[sp.Expr, ...]
    bound: sp.Expr


@functools.cache
def series() -> Series:
    """The shortest such polynomial that is good enough."""
    q = sp.sqrt(2) - 1
    if sp.expand(2 * q - (1 - q**2)) != 0:
        raise ArithmeticError("q does not map the series to atan(t)")
    n = 1
    while _bound(q, n) > ENOUGH:
        n += 1
    field = sp.QQ.algebraic_field(sp.sqrt(2))
    exact, over_t = field.from_sympy(q), sp.Poly(-1, w, domain=field)
    for k in range(n):
        # T_(2k+1)(t)/t is a polynomial in t^2
        term = sp.Poly(sp.chebyshevt_poly(2 * k + 1, w, polys=True).all_coeffs()[:-1:2], w, domain=field)
        over_t += term.mul_ground(2 * (-1) ** k * exact ** (2 * k + 1) / (2 * k + 1))
    shifted = over_t.compose(sp.Poly(w + sp.Rational(1, 2), w, domain=field))
    return Series(tuple(reversed(shifted.all_coeffs())), _bound(q, n))


def _bound(q: sp.Expr, n: int) -> sp.Expr:
    """Relative error of n terms, in units of 2^-53."""
    return 2**53 * 4 / sp.pi * q ** (2 * n)


@functools.cache
def in_pairs() -> tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
    """atan(k/n) to more digits than a pair has; coefficients of (atan(z)/z - 1)/z^2 by powers of z^2, |z| <= 1/(2 n).

    The first ones are needed as pairs; those whose rounding to a double counts for too little are the others.
    """
    w = sp.Rational(1, (2 * PAIRS_CUT) ** 2)
    first: list[sp.Expr] = []
    others: list[sp.Expr] = []
    k = 1
    # the series alternates: what is left out is less than its first term
    while w**k / (2 * k + 1) > PAIRS_ENOUGH:
        (first if w**k / (2 * k + 1) * sp.Rational(1, 2**53) > PAIRS_ENOUGH else others).append(
            sp.Rational((-1) ** k, 2 * k + 1)
        )
        k += 1
    return tuple(_angle(sp.Rational(k, PAIRS_CUT)) for k in range(PAIRS_CUT + 1)), tuple(first), tuple(others)


def _angle(t: sp.Rational) -> sp.Rational:
    """A number within 2^-290 of atan(t)."""
    with ctx.workprec(300):
        mantissa, exponent = arb(fmpq(int(t.p), int(t.q))).atan().mid().man_exp()
    return sp.Integer(int(mantissa)) * sp.Integer(2) ** int(exponent)


def estrin(coefficients: tuple[str, ...], variable: str) -> list[tuple[str, str]]:
    """Assignments (name, value) that evaluate a polynomial of printed coefficients by pairs; the last one is its value.

    Pairs wait for one another at few levels, where Horner's rule waits for every multiplication.
    """
    level, power, row = 0, variable, list(coefficients)
    lines: list[tuple[str, str]] = []
    while len(row) > 1:
        pairs = []
        for k in range(0, len(row) - 1, 2):
            pairs.append(f"e{level}_{k // 2}")
            lines.append((pairs[-1], f"{row[k]} + {power} * {row[k + 1]}"))
        if len(row) % 2:
            pairs.append(row[-1])
        row, level = pairs, level + 1
        if len(row) > 1:
            lines.append((f"{variable}{2**level}", f"{power} * {power}"))
            power = lines[-1][0]
    return lines
