"""Exact expressions in; numbers that enclose their values, and certified roots, out.

A ball (python-flint's `arb`) holds the true value. A sign, a count or a rounded digit decided from it is decided.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from decimal import ROUND_HALF_EVEN, Decimal, localcontext
from itertools import pairwise
from typing import Any

import sympy as sp
from flint import acb, arb, arb_poly, arb_series, ctx, fmpq

from ..elliptic import R_D

#: working precision: about 60 digits, of which the tables show 12
BITS = 200


@contextmanager
def precision(bits: int = BITS) -> Iterator[None]:
    """Balls with `bits` bits, Taylor series of two terms (value and slope)."""
    before = ctx.prec, ctx.cap
    ctx.prec, ctx.cap = bits, 2
    try:
        yield
    finally:
        ctx.prec, ctx.cap = before


def rational(value: Any) -> fmpq:
    """A Fraction, integer or SymPy rational as FLINT's."""
    numerator, denominator = (value.p, value.q) if isinstance(value, sp.Rational) else value.as_integer_ratio()
    return fmpq(int(numerator), int(denominator))


def evaluate(expression: sp.Expr, values: Mapping[sp.Symbol, Any]) -> Any:
    """The expression with balls (or Taylor series, or polynomials) for its symbols."""
    if expression.is_Symbol:
        return values[expression]
    if expression.is_Rational:
        return arb(rational(expression))
    if expression is sp.pi:
        return arb.pi()
    if expression.func in (sp.atan, sp.atan2):
        quotient = expression.args if isinstance(expression, sp.atan2) else sp.fraction(expression.args[0])
        return _angle(*(evaluate(side, values) for side in quotient))
    parts = [evaluate(argument, values) for argument in expression.args]
    if expression.func == R_D:
        return acb.elliptic_rd(*parts).real
    if expression.is_Add:
        total = parts[0]
        for part in parts[1:]:
            total = total + part
        return total
    if expression.is_Mul:
        total = parts[0]
        for part in parts[1:]:
            total = total * part
        return total
    if expression.is_Pow:
        return _power(parts[0], expression.exp)
    if expression.func in (sp.sin, sp.cos, sp.exp, sp.tan):
        return getattr(parts[0], expression.func.__name__)()
    if expression.func is sp.sign:
        return parts[0].sgn()
    raise ArithmeticError(f"{expression.func} is not evaluated")


def _angle(y: Any, x: Any) -> Any:
    """The angle of (x, y), x and y lengths and not negative: by the quotient that stays bounded."""
    return (y / x).atan() if (x if isinstance(x, arb) else x[0]) > 0 else arb.pi() / 2 - (x / y).atan()


def _power(base: Any, exponent: sp.Rational) -> Any:
    if exponent.q == 2:
        base, exponent = base.sqrt(), 2 * exponent
    whole = base ** abs(int(exponent))
    return 1 / whole if exponent < 0 else whole


def sign(x: arb) -> int:
    """-1 or 1; an error if the ball leaves it open."""
    if x > 0:
        return 1
    if x < 0:
        return -1
    raise ArithmeticError(f"the sign of {x} is open")


def isolate(function: Callable[[Any], Any], left: arb, right: arb, pieces: int = 32) -> list[arb]:
    """Every zero on [left, right], each in a ball with no other.

    The function takes balls and Taylor series; it may return None where it knows that there is no zero, and a ball
    for a series where it cannot tell the slope. An interval is dropped when its mean-value form excludes zero, kept
    when the slope has one sign on it, else halved.
    """
    cuts = [left + (right - left) * k / pieces for k in range(pieces + 1)]
    return [zero for a, b in pairwise(cuts) for zero in _isolate(function, a, b, 60)]


def _isolate(function: Callable[[Any], Any], left: arb, right: arb, depth: int) -> list[arb]:
    ball = left.union(right)
    middle = arb(ball.mid())
    taylor = function(arb_series([ball, 1]))
    if taylor is None or not (taylor if isinstance(taylor, arb) else taylor[0]).contains(0):
        return []
    centre = function(middle)
    if not isinstance(taylor, arb) and centre is not None:
        slope = taylor[1]
        if not (centre + slope * (ball - middle)).contains(0):
            return []
        if not slope.contains(0):
            ends = function(left), function(right)
            if None in ends or sign(ends[0]) == sign(ends[1]):
                return []
            return [_polish(function, left, right)]
    if not depth:
        raise ArithmeticError(f"zeros near {middle} are not separated")
    return _isolate(function, left, middle, depth - 1) + _isolate(function, middle, right, depth - 1)


def _polish(function: Callable[[Any], Any], left: arb, right: arb) -> arb:
    """The one zero of a monotone function between left and right, by interval Newton steps."""
    ball = left.union(right)
    for _ in range(60):
        middle = arb(ball.mid())
        # the slope's enclosure holds on the whole ball, so the step encloses the zero
        new = middle - function(middle) / function(arb_series([ball, 1]))[1]
        narrower = new.intersection(ball)
        if not narrower.rad() < ball.rad() * arb("0.9"):
            return narrower
        ball = narrower
    return ball


def polynomial_zeros(coefficients: Mapping[int, arb]) -> list[arb]:
    """Positive zeros, all simple, of a polynomial given by powers; FLINT isolates them among the complex ones.

    Common powers of the variable are dropped; an even polynomial is solved in the square.
    """
    lowest = min(coefficients)
    step = 1 if any((power - lowest) % 2 for power in coefficients) else 2
    polynomial = arb_poly([coefficients.get(k, arb(0)) for k in range(lowest, max(coefficients) + 1, step)])
    slope = polynomial.derivative()
    found = []
    for root in polynomial.complex_roots():
        # the balls are disjoint: one that meets its mirror image is its own, so real
        if root.imag.contains(0) and not root.real < 0:
            box = root.real
            for _ in range(8):
                middle = arb(box.mid())
                box = (middle - polynomial(middle) / slope(box)).intersection(box)
            if not box > 0:
                raise ArithmeticError("a zero cannot be told from 0")
            found.append(box if step == 1 else box.sqrt())
    return sorted(found, key=lambda x: x.mid())


def _decimal(x: fmpq, digits: int) -> Decimal:
    with localcontext() as context:
        context.prec = digits
        return Decimal(int(x.p)) / Decimal(int(x.q))


def _ends(x: arb) -> list[Decimal]:
    ends = []
    for bound in (x.lower(), x.upper()):
        mantissa, exponent = bound.man_exp()
        ends.append(_decimal(fmpq(int(mantissa)) * fmpq(2) ** int(exponent), 50))
    return ends


def rounded(x: arb, decimals: int) -> str:
    """The value rounded to so many decimals; an error if the ball leaves the last one open."""
    quantum = Decimal(1).scaleb(-decimals)
    texts = {f"{end.quantize(quantum, ROUND_HALF_EVEN):f}" for end in _ends(x)}
    if len(texts) != 1:
        raise ArithmeticError(f"{x} is not known to {decimals} decimals")
    return texts.pop()


def significant(x: arb, digits: int = 12) -> str:
    """The value to so many significant digits."""
    low, high = _ends(x)
    if low.adjusted() != high.adjusted():
        raise ArithmeticError(f"{x} is not known to one digit")
    return rounded(x, digits - 1 - low.adjusted())
