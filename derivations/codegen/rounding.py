"""How far a kernel's rounding errors reach, proved: k with |computed - exact| <= k u (1 + kappa).

In:  the straight-line `Program` of a branch that is a polynomial in its arguments, or one divided by monomials.
Out: k for each output, for all arguments where nothing overflows or underflows; None where this way finds none.
     `python -m derivations.codegen.rounding` proves all of them anew and writes `proved.json`, which headers quote.

u = 2^-53, and (1 + kappa) |f| is |f| + sum |x df/dx| over the arguments x. Every node of the program is such a
polynomial. Rounding a sum of n terms costs each at most n - 1 units, whatever the order, a product or quotient one for
each operation, a constant that is no double one. So a node errs by at most u sum e_j |t_j|, t_j the values of its
monomials. Rules for sums and products are `_sum` and `_product`.

That this is at most k u (1 + kappa) |f| is shown, for each choice of signs of the arguments, by multipliers of the
sums f and x df/dx = sum m_j t_j (m_j the exponents of x): numbers of size k at most with which these add up to a sum
of t_j's that exceeds each e_j |t_j|. A linear program finds them, in floats; rational arithmetic then checks them
exactly.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
import sympy as sp
from scipy.optimize import linprog

from ..paper.slow_flow import m
from ..results import derive
from ..symbols import F_0, A, Omega, mu, zeta
from . import proved
from .catalogue.every_module import all_modules
from .form import Module
from .passes import Program, is_constant
from .views import programs

#: arguments that are not negative
POSITIVE = (A, Omega, F_0, m, mu, zeta)
#: what is left out: products of roundings, which are below 2^-53 of what is counted as long as that is below 10^4 units
SECOND_ORDER = Fraction(1, 10**9)
#: as many monomials, or lets of a program, as a proof takes on
MOST = 60
#: exponents of the arguments
Monomial = tuple[int, ...]
Polynomial = dict[Monomial, Fraction]


class NoBound(ArithmeticError):
    """This way finds no bound."""


@dataclass(frozen=True)
class Value:
    """A node: what it is, and what it errs by in u, both by monomials; the errors' coefficients are not negative."""

    exact: Polynomial
    error: Polynomial


def bounds(program: Program, arguments: Sequence[sp.Symbol]) -> list[Fraction | None]:
    """k for each output, rounded up to hundredths."""
    known = {x: Value({_unit(arguments, x): Fraction(1)}, {}) for x in arguments}
    try:
        for symbol, expression in program.lets:
            known[symbol] = _value(expression, known, len(arguments))
    except NoBound:
        return [None] * len(program.outputs)
    found: list[Fraction | None] = []
    for output in program.outputs:
        try:
            found.append(_bound(_value(output, known, len(arguments)), arguments))
        except NoBound:
            found.append(None)
    return found


def _unit(arguments: Sequence[sp.Symbol], x: sp.Symbol) -> Monomial:
    return tuple(int(y == x) for y in arguments)


def _constant(number: sp.Expr, size: int) -> tuple[Value, bool]:
    """A number as printed, and whether multiplying by it is exact."""
    number = number.doit()
    if not number.is_Rational:
        raise NoBound(f"the constant {number}")
    value = Fraction(int(number.p), int(number.q))
    one = (0,) * size
    if value == 0:
        return Value({}, {}), True
    rounded = Fraction(float(value)) != value
    power_of_two = math.frexp(float(value))[0] in (0.5, -0.5) and not rounded
    return Value({one: value}, {one: abs(value)} if rounded else {}), power_of_two


def _value(expression: sp.Expr, known: dict[sp.Symbol, Value], size: int) -> Value:
    """A node from those before it."""
    if is_constant(expression):
        return _constant(expression, size)[0]
    if expression.is_Symbol:
        return known[expression]
    if expression.is_Add:
        return _sum([_value(term, known, size) for term in expression.args])
    if expression.is_Mul or (expression.is_Pow and expression.exp.is_Integer):
        result, exact = Value({(0,) * size: Fraction(1)}, {}), True
        for factor in sp.Mul.make_args(expression):
            if is_constant(factor):
                other, free = _constant(factor, size)
                result, exact = _product(result, other, rounded=not (free or exact)), exact and free
                continue
            base, exponent = factor.as_base_exp()
            if not exponent.is_Integer:
                raise NoBound(str(factor))
            other = _value(base, known, size)
            for _ in range(abs(int(exponent))):
                by = other if exponent > 0 else _reciprocal(other)
                result, exact = _product(result, by, rounded=exponent < 0 or not exact), False
        return result
    raise NoBound(str(expression.func))


def _sum(terms: Sequence[Value]) -> Value:
    """Each term is in at most n - 1 partial sums."""
    exact = _added([term.exact for term in terms])
    partial = _added([_sizes(term.exact) for term in terms])
    # of two terms the sum itself is rounded, in which monomials may cancel
    rounded = _sizes(exact) if len(terms) == 2 else _times(partial, Fraction(len(terms) - 1))
    return Value(exact, _added([rounded, *(term.error for term in terms)]))


def _product(one: Value, other: Value, rounded: bool) -> Value:
    exact = _multiplied(one.exact, other.exact)
    errors = [_multiplied(_sizes(one.exact), other.error), _multiplied(one.error, _sizes(other.exact))]
    return Value(exact, _added([*errors, *([_sizes(exact)] if rounded else [])]))


def _reciprocal(value: Value) -> Value:
    """Of a monomial; the division itself is counted as the product's rounding."""
    if len(value.exact) != 1:
        raise NoBound("a quotient by a sum")
    ((monomial, coefficient),) = value.exact.items()
    inverse = tuple(-power for power in monomial)
    if any(other != monomial for other in value.error):
        raise NoBound("a divisor whose error is no share of it")
    ratio = value.error.get(monomial, Fraction(0)) / abs(coefficient)
    return Value({inverse: 1 / coefficient}, {inverse: ratio / abs(coefficient)} if ratio else {})


def _added(polynomials: Sequence[Polynomial]) -> Polynomial:
    total: Polynomial = {}
    for polynomial in polynomials:
        for monomial, coefficient in polynomial.items():
            total[monomial] = total.get(monomial, Fraction(0)) + coefficient
    return {monomial: coefficient for monomial, coefficient in total.items() if coefficient}


def _multiplied(one: Polynomial, other: Polynomial) -> Polynomial:
    if len(one) * len(other) > MOST**2:
        raise NoBound("too many monomials")
    return _added(
        [
            {tuple(map(sum, zip(p, q, strict=True))): a * b}
            for (p, a), (q, b) in itertools.product(one.items(), other.items())
        ]
    )


def _sizes(polynomial: Polynomial) -> Polynomial:
    return {monomial: abs(coefficient) for monomial, coefficient in polynomial.items()}


def _times(polynomial: Polynomial, number: Fraction) -> Polynomial:
    return {monomial: number * coefficient for monomial, coefficient in polynomial.items()}


def _bound(value: Value, arguments: Sequence[sp.Symbol]) -> Fraction:
    """The largest over all signs of the arguments that may have either."""
    if not value.exact:
        if value.error:
            raise NoBound("an error of zero")
        return Fraction(0)
    if len(value.exact) > MOST or value.error.keys() - value.exact.keys():
        raise NoBound("an error in a monomial that is not there")
    either = [k for k, x in enumerate(arguments) if x not in POSITIVE and any(t[k] % 2 for t in value.exact)]
    worst = Fraction(0)
    for signs in itertools.product((1, -1), repeat=len(either)):
        worst = max(worst, _of_signs(value, dict(zip(either, signs, strict=True))))
    k = worst * (1 + SECOND_ORDER)
    return Fraction(math.ceil(k * 100), 100)


def _of_signs(value: Value, sign: dict[int, int]) -> Fraction:
    """By a linear program for the multipliers, checked exactly."""
    monomials = sorted(value.exact)
    weights = [value.error.get(t, Fraction(0)) / abs(value.exact[t]) for t in monomials]
    signs = [(1 if value.exact[t] > 0 else -1) * math.prod(s for k, s in sign.items() if t[k] % 2) for t in monomials]
    rows = [[Fraction(s) for s in signs]]
    rows += [[Fraction(s * t[k]) for s, t in zip(signs, monomials, strict=True)] for k in range(len(monomials[0]))]
    count = len(rows)
    # variables: multipliers, then k; each monomial's sum at least its weight, and k at least each multiplier's size
    above = np.array([[-float(row[j]) for row in rows] + [0.0] for j in range(len(monomials))])
    within = np.array([[s * float(i == j) for j in range(count)] + [-1.0] for i in range(count) for s in (1, -1)])
    found = linprog(
        [0.0] * count + [1.0],
        A_ub=np.vstack((above, within)),
        b_ub=np.array([-float(w) for w in weights] + [0.0] * len(within)),
        bounds=[(None, None)] * count + [(0, None)],
    )
    if not found.success:
        raise NoBound("no multipliers")
    multipliers = [Fraction(x).limit_denominator(10**6) * (1 + Fraction(1, 10**4)) for x in found.x[:count]]
    for j, weight in enumerate(weights):
        if sum(x * row[j] for x, row in zip(multipliers, rows, strict=True)) < weight:
            raise NoBound("the multipliers do not hold in exact arithmetic")
    return max(abs(x) for x in multipliers)


def proved_of(module: Module) -> dict[str, dict[str, object]]:
    """What is proved of a module's kernels, by the digest of the program it is proved for."""
    code, found = programs(module), {}
    for kernel in module.kernels:
        for branch, program in zip(kernel.branches, code[kernel.name], strict=True):
            if len(program.lets) > MOST:
                continue
            k = bounds(program, kernel.arguments)
            if any(one is not None for one in k):
                name = ".".join(part for part in (module.name, kernel.name, branch.name) if part)
                shown = [None if one is None else str(float(one)) for one in k]
                found[proved.digest(program, kernel.arguments)] = {"kernel": name, "k": shown}
    return found


def main() -> None:
    """Prove all and write."""
    found: dict[str, dict[str, object]] = {}
    for module in all_modules(derive()):
        found |= proved_of(module)
    proved.write(found)


if __name__ == "__main__":
    main()
