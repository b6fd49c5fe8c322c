"""Beside (20)-(22): h_AAA is monotone in A on each piece of the force, so its values at two amplitudes bound it.

In:  `Dimensionless`: the force piece by piece, its coefficients and breakpoints in the design numbers; their domains.
Out: `prove_monotone`: nothing where it is proved, ArithmeticError where it is not; `not_shown`: why not; `smooth_end`:
     a breakpoint about which the force is smooth.

Where A exceeds the first j breakpoints, the force is its next piece f all along, plus, below each breakpoint b that A
exceeds, the step d from the piece above b to the piece below it. As u = A sin t goes over the quarter cycle,

    h_AAAA = -(4/pi) int_0^(pi/2) f_uuuu(A sin t) sin^5 t dt  -  sum over b of (4/pi) int_0^b d(u) u K(u) du

with K the fourth derivative of 1/(A sqrt(A^2 - u^2)) by A, which is positive: that is a product of the powers -1, -1/2
and -1/2 of A, A - u and A + u, and the derivatives of each alternate in sign. So h_AAA is monotone if f_uuuu on the
piece and every d below its b have one sign, all the same.

For that sign they are written as polynomials in one variable on [0, 1] in Bernstein form, which has the sign of its
coefficients if these have one; and a coefficient has that of its factors, each a polynomial in numbers that take all
positive values, with coefficients of one sign. What holds sqrt(1 - u^2) is a polynomial in its inverse w, from 1 on.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import sympy as sp

from slowflow.support.errors import NotSettled

from ..mechanisms import Parameter
from ..paper.equation_of_motion import Dimensionless
from ..symbols import u
from ..vanishing import reduced, vanishes

_w, _v = sp.symbols("w v", positive=True)
_y = sp.Symbol("y", nonnegative=True)


def prove_monotone(oscillator: Dimensionless) -> None:
    """That h_AAA is monotone on each piece for every design, and h_A or h_AA infinite above each breakpoint."""
    reason = not_shown(oscillator)
    if reason:
        raise NotSettled(f"{oscillator.mechanism.name}: {reason}")


def not_shown(oscillator: Dimensionless) -> str:
    """What is not shown of that, in words; "" where all is."""
    values = _on_positive_numbers(oscillator)
    breakpoints = oscillator.mechanism.breakpoints
    pieces = oscillator.polynomials
    steps = [below - above for below, above in itertools.pairwise(pieces)]
    first = sp.Poly(pieces[0], u).terms() if pieces[0].is_polynomial(u) else ()
    even = [power for (power,), value in reversed(first) if power % 2 == 0 and value != 0]
    if even:
        return f"powers {even} of u in the first piece: next to rest amplitudes are searched as if h were odd in A"
    smooth = smooth_end(oscillator)
    if smooth is not None:
        return f"neither the force nor its slope jumps at {smooth}: amplitudes above it are searched as if one did"
    for passed, piece in enumerate(pieces):
        coefficients = [*_bernstein(sp.diff(piece, u, 4), (*breakpoints, None)[passed], values)]
        for step, b in zip(steps[:passed], breakpoints, strict=False):
            coefficients += _bernstein(step, b, values)
        if not _have_one_sign(coefficients):
            return (
                f"not shown that h_AAA is monotone on piece {passed + 1} of the force. "
                "Folds are searched between amplitudes by its values there, so that none is missed"
            )
    return ""


def smooth_end(oscillator: Dimensionless) -> sp.Symbol | None:
    """A breakpoint at which neither the force nor its slope jumps, for any design; None where there is none."""
    values = _on_positive_numbers(oscillator)
    pieces = itertools.pairwise(oscillator.polynomials)
    for (below, above), b in zip(pieces, oscillator.mechanism.breakpoints, strict=True):
        if all(vanishes(sp.diff(below - above, u, order).subs(u, b).subs(values)) for order in (0, 1)):
            return b
    return None


def _on_positive_numbers(oscillator: Dimensionless) -> dict[sp.Symbol, sp.Expr]:
    """Coefficients and breakpoints in numbers that take all positive values, where the design's domains allow that."""
    domain = {parameter.symbol: _by_positive(parameter) for parameter in oscillator.mechanism.design}
    defined = {name: reduced(sp.sympify(value).subs(domain)) for name, value in oscillator.definitions.items()}
    return defined | {name: value for name, value in domain.items() if name in defined}


def _by_positive(parameter: Parameter) -> sp.Expr:
    """A parameter from a positive number of its name, by its bounds from below and from above."""
    positive = sp.Symbol(parameter.symbol.name, positive=True)
    low = parameter.above if parameter.above is not None else parameter.least
    high = parameter.below if parameter.below is not None else parameter.most
    if low is None:
        return parameter.symbol if high is None else high - positive
    return low + positive if high is None else (low + high * positive) / (1 + positive)


def _bernstein(expression: sp.Expr, end: sp.Symbol | None, values: dict[sp.Symbol, sp.Expr]) -> Iterator[sp.Expr]:
    """Bernstein's coefficients of an expression in u on 0 < u < end, or of its polynomial's where there is no end.

    Factors that are positive for u > 0 are left out.
    """
    expression = sp.expand(sp.powsimp(expression))
    if expression == 0:
        return
    top: sp.Expr | None
    if expression.is_polynomial(u):
        polynomial = sp.Poly(expression, u)
        powers = [power for (power,) in polynomial.monoms()]
        lowest, stride = min(powers), sp.igcd(0, *(power - min(powers) for power in powers)) or 1
        terms = {(power - lowest) // stride: polynomial.coeff_monomial(u**power) for power in powers}
        top = None if end is None else end**stride
        start = sp.Integer(0)
    else:
        even = sp.expand(sp.expand(expression / u).subs(1 - u**2, _w**-2).subs(u, sp.sqrt(1 - _w**-2)))
        lowest = min(term.as_coeff_exponent(_w)[1] for term in sp.Add.make_args(even))
        polynomial = sp.Poly(sp.expand(even * _w**-lowest), _w)
        terms = {power: polynomial.coeff_monomial(_w**power) for (power,) in polynomial.monoms()}
        top = None if end is None else 1 / sp.sqrt(1 - end**2)
        start = sp.Integer(1)
    value = sum(coefficient * _v**power for power, coefficient in terms.items())
    if top is None:  # on all v from the start on: by powers of what exceeds it
        yield from (reduced(c.subs(values)) for c in sp.Poly(sp.expand(value.subs(_v, start + _y)), _y).coeffs())
        return
    top = reduced(top.subs(values))
    on_unit = sp.Poly(sp.expand(value.subs(values).subs(_v, start + (top - start) * _y)), _y)
    degree = on_unit.degree()
    for i in range(degree + 1):
        yield reduced(
            sum(sp.binomial(i, k) / sp.binomial(degree, k) * on_unit.coeff_monomial(_y**k) for k in range(i + 1))
        )


def _have_one_sign(coefficients: list[sp.Expr]) -> bool:
    """Whether each has the sign of the first that is not 0, or is 0."""
    first, *others = [c for c in coefficients if c != 0] or [sp.Integer(0)]
    return all(_is_not_negative(other / first) for other in others)


def _is_not_negative(expression: sp.Expr) -> bool:
    """By the signs of its factors."""
    sign = 1
    numerator, denominator = sp.fraction(sp.cancel(sp.together(expression)))
    for whole in (numerator, denominator):
        constant, factors = sp.factor_list(whole)
        sign *= 1 if constant > 0 else -1
        for factor, power in factors:
            if power % 2 == 0:
                continue
            polynomial = sp.Poly(factor, *sorted(factor.free_symbols, key=str))
            signs = {sp.sign(c) for c in polynomial.coeffs()}
            if len(signs) != 1 or not all(symbol.is_positive for symbol in polynomial.gens):
                return False
            sign *= int(signs.pop())
    return sign > 0
