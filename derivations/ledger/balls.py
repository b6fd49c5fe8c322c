"""Exact expressions in; numbers that enclose their values, and certified roots, out.

A ball (python-flint's `arb`) holds the true value. A sign, a count or a rounded digit decided from it is decided.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from decimal import ROUND_HALF_EVEN, Decimal, localcontext
from fractions import Fraction
from functools import cache, partial, reduce
from itertools import pairwise
from operator import add, methodcaller, mul
from typing import Any

import sympy as sp
from flint import acb, arb, arb_poly, arb_series, ctx, fmpq

from ..forces.elliptic import R_D, R_F

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


def ball(value: Any) -> arb:
    """A Fraction, integer, SymPy rational or decimal text, as a ball."""
    return arb(rational(Fraction(value) if isinstance(value, str) else value))


def evaluate(expression: sp.Expr, values: Mapping[sp.Symbol, Any]) -> Any:
    """The expression with balls (or Taylor series, or polynomials) for its symbols."""
    found: list[Any] = []
    for act, operands in _steps(expression, ctx.prec):
        found.append(values[operands] if act is None else act(*[found[k] for k in operands]))
    return found[-1]


@cache
def _steps(expression: sp.Expr, bits: int) -> tuple[tuple[Callable[..., Any] | None, Any], ...]:
    """Steps in turn, each part of the expression once: a function and the positions of its arguments, or a symbol.

    Kept for an expression, which is evaluated at thousands of balls, and for the precision that its constants have.
    """
    steps: list[tuple[Callable[..., Any] | None, Any]] = []
    positions: dict[sp.Expr, int] = {}

    def place(part: sp.Expr) -> int:
        if part not in positions:
            act, operands = _step(part)
            steps.append((act, operands if act is None else tuple(place(one) for one in operands)))
            positions[part] = len(steps) - 1
        return positions[part]

    place(expression)
    return tuple(steps)


def _step(part: sp.Expr) -> tuple[Callable[..., Any] | None, Any]:
    """How a part is had of others, and these; of a symbol the symbol."""
    if part.is_Symbol:
        return None, part
    if part.is_Rational or part is sp.pi:
        constant = arb.pi() if part is sp.pi else ball(part)
        return lambda: constant, ()
    if part.func in (sp.atan, sp.atan2):
        return _angle, part.args if isinstance(part, sp.atan2) else sp.fraction(part.args[0])
    if part.func in (R_F, R_D):
        carlson = acb.elliptic_rf if part.func == R_F else acb.elliptic_rd
        return lambda *of: carlson(*of).real, part.args
    if part.is_Add:
        return lambda *of: reduce(add, of), part.args
    if part.is_Mul:
        return lambda *of: reduce(mul, of), part.args
    if part.is_Pow:
        return partial(_power, root=part.exp.q == 2, exponent=int(part.exp * part.exp.q)), part.args[:1]
    if part.func in (sp.sin, sp.cos, sp.exp, sp.tan):
        return methodcaller(part.func.__name__), part.args
    if part.func is sp.sign:
        return methodcaller("sgn"), part.args
    raise ArithmeticError(f"{part.func} is not evaluated")


def _angle(y: Any, x: Any) -> Any:
    """The angle of (x, y), x and y lengths and not negative: by the quotient that stays bounded."""
    return (y / x).atan() if (x if isinstance(x, arb) else x[0]) > 0 else arb.pi() / 2 - (x / y).atan()


def _power(base: Any, root: bool, exponent: int) -> Any:
    whole = (base.sqrt() if root else base) ** abs(exponent)
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
