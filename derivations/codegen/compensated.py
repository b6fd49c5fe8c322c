"""From an expression to double-double code: sums and products with their rounding errors, which low parts gather.

In:  lets and outputs in structured form, exact; which arguments come with a low part.
Out: `Twofold`: a straight line of exact sums, exact products and plain assignments; `magnitude`, the size of the terms
     that a value is a sum of, by which its error is measured.

A number is a high part, a double, and a low part, the double that its roundings left (Dekker 1971; Knuth, TAOCP 2,
4.2.2). With s + e = a + b and p + e = a b exactly,

    (a, a_low) + (b, b_low)  =  s,  e + a_low + b_low
    (a, a_low) (b, b_low)    =  p,  e + a b_low + a_low (b + b_low)

Low parts are rounded as they come and not normalised: the error stays below 2^-98 of the terms.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from ..kernels import Let
from .form import TwofoldKernel

TWO_SUM, TWO_PRODUCT = "two_sum", "two_product"

#: x y + z, in one rounding where the language has it; |x| with the sign of y
fma, copysign = sp.symbols("fma copysign", cls=sp.Function)


@dataclass(frozen=True)
class Exact:
    """high + low = left op right, exactly; a fast sum needs |left| >= |right|."""

    op: str
    high: sp.Symbol
    low: sp.Symbol
    left: sp.Expr
    right: sp.Expr


@dataclass(frozen=True)
class Twofold:
    """Straight-line code.

    lines   -- exact sums and products, and plain lets, in order
    outputs -- expressions in doubles; if `distilled` there is none, and the value is the exact sum of these doubles
    """

    lines: tuple[Exact | Let, ...]
    outputs: tuple[sp.Expr, ...]
    distilled: tuple[sp.Expr, ...] = ()


@dataclass(frozen=True)
class _Pair:
    high: sp.Expr
    low: sp.Expr = sp.S.Zero


class _Code:
    """Lines as they come; each sum and product once."""

    def __init__(self, lows: Mapping[sp.Symbol, sp.Symbol]) -> None:
        self.lines: list[Exact | Let] = []
        self.inexact = set(lows)
        self.known: dict[object, _Pair] = {symbol: _Pair(symbol, low) for symbol, low in lows.items()}
        self.number = 0

    def fresh(self) -> sp.Symbol:
        self.number += 1
        return sp.Symbol(f"d{self.number - 1}", real=True)

    def let(self, value: sp.Expr) -> sp.Expr:
        """The value under a name, unless it has one or is a number."""
        if value.is_Symbol or value.is_Number:
            return value
        name = self.fresh()
        self.lines.append((name, value))
        return name

    def exact(self, op: str, left: sp.Expr, right: sp.Expr) -> _Pair:
        high = self.fresh()
        low = _low_of(high)
        self.lines.append(Exact(op, high, low, left, right))
        return _Pair(high, low)

    def named(self, name: sp.Symbol, value: sp.Expr) -> _Pair:
        """The pair of an expression, under the name of a let."""
        pair = self.of(value)
        rename = {pair.high: name, pair.low: _low_of(name)}
        made = {line.high if isinstance(line, Exact) else line[0] for line in self.lines}
        if not made >= {pair.high}:
            raise ArithmeticError(f"{name} = {value} is no sum or product")

        def renamed(x: sp.Expr) -> sp.Expr:
            return x.xreplace(rename)

        self.lines = [
            Exact(line.op, *map(renamed, (line.high, line.low, line.left, line.right)))
            if isinstance(line, Exact)
            else (renamed(line[0]), renamed(line[1]))
            for line in self.lines
        ]
        self.known = {key: _Pair(renamed(old.high), renamed(old.low)) for key, old in self.known.items()}
        self.known[name] = _Pair(renamed(pair.high), renamed(pair.low))
        self.inexact.add(name)
        return self.known[name]

    def of(self, expression: sp.Expr) -> _Pair:
        """The pair of an expression."""
        if expression not in self.known:
            self.known[expression] = self._made(expression)
        return self.known[expression]

    def _made(self, expression: sp.Expr) -> _Pair:
        number, rest = expression.as_coeff_Mul()
        if _is_double(expression) or (rest.is_Symbol and rest not in self.inexact and _power_of_two(number)):
            return _Pair(expression)
        if expression.is_Add:
            first, *others = (self.of(term) for term in sorted(expression.args, key=str))
            return functools.reduce(self.sum, others, first)
        return self._product(number, rest)

    def _product(self, number: sp.Rational, rest: sp.Expr) -> _Pair:
        # doubles before pairs, so that what products have in common comes first and is computed once
        doubles = rest.free_symbols - self.inexact
        factors = sorted(_repeated(rest), key=lambda factor: (factor not in doubles, str(factor)))
        plain = [k for k, factor in enumerate(factors) if factor in doubles]
        odd = abs(number)
        while odd.q == 1 and odd.p % 2 == 0:
            odd /= 2
        if odd.q == 1 and odd != 1:
            factors, number = [odd, *factors], number / odd
        if not _power_of_two(number):
            raise ArithmeticError(f"the factor {number} of {rest} is not exact in double-double")
        if plain and odd == 1 and number > 0:
            factors[plain[-1]], number = number * factors[plain[-1]], sp.S.One
        pair = self._chain(tuple(factors))
        return _Pair(number * pair.high, number * pair.low)

    def _chain(self, factors: tuple[sp.Expr, ...]) -> _Pair:
        if len(factors) == 1:
            return self.of(factors[0])
        if factors not in self.known:
            self.known[factors] = self.product(self._chain(factors[:-1]), self.of(factors[-1]))
        return self.known[factors]

    def sum(self, a: _Pair, b: _Pair) -> _Pair:
        exact = self.exact(TWO_SUM, a.high, b.high)
        return _Pair(exact.high, self.let(exact.low + a.low + b.low))

    def product(self, a: _Pair, b: _Pair) -> _Pair:
        exact = self.exact(TWO_PRODUCT, a.high, b.high)
        low: sp.Expr = exact.low
        if a == b and a.low != 0:
            return _Pair(exact.high, self.let(fma(a.low, 2 * a.high + a.low, low)))
        if b.low != 0:
            low = self.let(fma(a.high, b.low, low))
        if a.low != 0:
            low = self.let(fma(a.low, b.high + b.low, low))
        return _Pair(exact.high, low)


def _low_of(high: sp.Symbol) -> sp.Symbol:
    return sp.Symbol(f"{high.name}_low", real=True)


def _repeated(product: sp.Expr) -> list[sp.Expr]:
    """The factors, powers as often as they say."""
    factors = []
    for factor in sp.Mul.make_args(product):
        base, exponent = factor.as_base_exp()
        if not (exponent.is_Integer and exponent > 0) or (base == factor and not (base.is_Symbol or base.is_Add)):
            raise ArithmeticError(f"there is no double-double code for {factor}")
        factors += [base] * int(exponent)
    return factors


def _is_double(number: sp.Expr) -> bool:
    return bool(number.is_Rational) and _power_of_two(sp.Rational(1, number.q)) and abs(number.p) < 2**53


def _power_of_two(number: sp.Expr) -> bool:
    return bool(number.is_Rational) and all(part & (part - 1) == 0 for part in (abs(int(number.p)), int(number.q)))


def _evaluated(lets: Sequence[Let], value: sp.Expr, lows: Mapping[sp.Symbol, sp.Symbol]) -> tuple[_Code, _Pair]:
    code = _Code(lows)
    for name, of_let in lets:
        code.named(name, of_let)
    return code, code.of(value)


def rounded(lets: Sequence[Let], value: sp.Expr, lows: Mapping[sp.Symbol, sp.Symbol]) -> Twofold:
    """A value in double-double, in the end rounded to a double."""
    code, pair = _evaluated(lets, value, lows)
    return Twofold(tuple(code.lines), (pair.high + code.let(pair.low),))


def normalised(values: Sequence[sp.Expr]) -> Twofold:
    """Values as pairs, each low part below half a last place of its high part: high, low, high, low, ..."""
    code = _Code({})
    outputs: list[sp.Expr] = []
    for value in values:
        pair = code.of(value)
        if pair.low not in (0, _low_of(pair.high) if pair.high.is_Symbol else 0):
            pair = code.exact(TWO_SUM, pair.high, pair.low)
        outputs += [pair.high, pair.low]
    return Twofold(tuple(code.lines), tuple(outputs))


def exactly(value: sp.Expr) -> Twofold:
    """A sum of products of two doubles each, with a certain sign: their exact products, to be distilled."""
    code = _Code({})
    products = [code.of(term) for term in sp.Add.make_args(value)]
    return Twofold(tuple(code.lines), (), (*(pair.low for pair in products), *(pair.high for pair in products)))


def twofold(kernel: TwofoldKernel) -> Twofold:
    """A kernel's lines."""
    if kernel.returns == "pairs":
        return normalised(kernel.values)
    (value,) = kernel.values
    return exactly(value) if kernel.returns == "distilled" else rounded(kernel.lets, value, kernel.lows)


def magnitude(lets: Sequence[Let], value: sp.Expr, epsilon: sp.Expr) -> sp.Expr:
    """How large the terms are that a value is the sum of: its error is a small multiple of u times this.

    What has no negative term is its own magnitude. A factor counts by its value, not by its terms, but for an epsilon
    of these: where it has cancelled its own error is left.
    """
    # held, or SymPy would multiply it out
    epsilon = sp.UnevaluatedExpr(epsilon)
    values = dict(lets)

    def positive(expression: sp.Expr) -> bool:
        return bool(expression.xreplace(values).expand().is_nonnegative)

    def of(expression: sp.Expr) -> sp.Expr:
        if positive(expression):
            return expression
        if expression in values:
            return of(values[expression])
        if expression.is_Symbol or expression.is_Number:
            return sp.Abs(expression)
        if expression.is_Add:
            return sp.Add(*(of(term) for term in expression.args))
        number, rest = expression.as_coeff_Mul()
        if number != 1:
            return abs(number) * of(rest)
        base, exponent = expression.as_base_exp()
        if exponent == 2:
            return (sp.Abs(base) + epsilon * of(base)) * of(base)
        whole, *others = sp.Mul.make_args(expression)
        total, size = whole, of(whole)
        for factor in others:
            if positive(total):
                size = total * of(factor)
            elif positive(factor):
                size = size * factor
            else:
                size = (sp.Abs(total) + epsilon * size) * of(factor) + sp.Abs(factor) * size
            total *= factor
        return size

    return of(value)
