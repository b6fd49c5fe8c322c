"""Exact comparison: a SymPy expression in, its canonical quotient of polynomials over the rationals out.

sin, cos, exp, sign, square roots and pi become variables of a polynomial ring. What holds between them is divided out:

    sin^2 x + cos^2 x = 1        sin 2x = 2 sin x cos x, ...        sqrt(e)^2 = e        exp(a + b) = exp(a) exp(b)

If the numerator that is left is the zero polynomial, the expression is zero. If it is not, it might still be so through
a relation not used (roots of dependent radicands); so a difference is shown not to vanish by enclosing its value at a
point. No equality is decided by rounded numbers or by `simplify`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp
from flint import Ordering, arb, fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from sympy.simplify.fu import TR8

from . import balls

PYTHAGORAS = "sin²x + cos²x = 1"
ROOT = "(√e)² = e"
MULTIPLES = "multiple angles expressed by the smallest one"


@dataclass(frozen=True)
class Quotient:
    """numerator/denominator, in lowest terms, and the relations that were needed to get there."""

    numerator: sp.Expr
    denominator: sp.Expr
    relations: tuple[str, ...]

    @property
    def is_zero(self) -> bool:
        return self.numerator == 0

    def text(self) -> str:
        """Factored, for readers."""
        return sp.sstr(self.numerator / self.denominator)


class _Ring:
    """The atoms of some expressions as variables, and quotients of polynomials in them."""

    def __init__(self, expressions: Iterable[sp.Expr]) -> None:
        atoms: set[sp.Expr] = set()
        for expression in expressions:
            self._collect(expression, atoms)
        self.roots = sorted((a for a in atoms if a.is_Pow), key=sp.srepr, reverse=True)
        self.angles = sorted({a.args[0] for a in atoms if a.func in (sp.sin, sp.cos)}, key=sp.srepr)
        circular = [f(x) for x in self.angles for f in (sp.sin, sp.cos)]
        rest = sorted(atoms - set(self.roots) - set(circular), key=sp.srepr)
        # a root may hold sines, not the other way round: its variable comes first and is reduced first
        self.atoms: list[sp.Expr] = [*self.roots, *circular, *rest]
        self.index = {atom: k for k, atom in enumerate(self.atoms)}
        self.context = fmpq_mpoly_ctx.get([f"v{k}" for k in range(len(self.atoms))], Ordering.lex)
        self.variables = self.context.gens()
        self.one = self.context.constant(1)

    def _collect(self, expression: sp.Expr, atoms: set[sp.Expr]) -> None:
        if expression.is_Rational:
            return
        if expression.is_Add or expression.is_Mul:
            for argument in expression.args:
                self._collect(argument, atoms)
        elif expression.is_Pow and expression.exp.is_Integer:
            self._collect(expression.base, atoms)
        elif expression.is_Pow and expression.exp.is_Rational and expression.exp.q == 2:
            atoms.add(sp.sqrt(expression.base))
            self._collect(expression.base, atoms)
        elif isinstance(expression, sp.exp):
            for term in sp.Add.make_args(sp.expand(expression.exp)):
                atoms.add(sp.exp(term.as_coeff_Mul()[1]))
        elif expression.is_Symbol or expression is sp.pi or expression.func in (sp.sin, sp.cos, sp.sign, sp.atan2):
            atoms.add(expression)
            if expression.func in (sp.sin, sp.cos):
                atoms.update((sp.sin(expression.args[0]), sp.cos(expression.args[0])))
        else:
            raise ArithmeticError(f"{expression} has no polynomial form")

    def quotient(self, expression: sp.Expr) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        """The expression as numerator and denominator, before any relation is used."""
        if expression.is_Rational:
            return self.context.constant(fmpq(int(expression.p), int(expression.q))), self.one
        if expression.is_Add:
            numerator, denominator = self.context.constant(0), self.one
            for argument in expression.args:
                n, d = self.quotient(argument)
                if d == denominator:
                    numerator += n
                else:
                    common = d.gcd(denominator)
                    numerator = numerator * (d / common) + n * (denominator / common)
                    denominator = denominator * (d / common)
            return numerator, denominator
        if expression.is_Mul:
            numerator, denominator = self.one, self.one
            for argument in expression.args:
                n, d = self.quotient(argument)
                numerator, denominator = numerator * n, denominator * d
            return numerator, denominator
        if isinstance(expression, sp.exp):
            factors = (term.as_coeff_Mul() for term in sp.Add.make_args(sp.expand(expression.exp)))
            powers = [(sp.exp(monomial), coefficient) for coefficient, monomial in factors]
        elif expression.is_Pow and expression.exp.is_Rational and expression.exp.q == 2:
            powers = [(sp.sqrt(expression.base), 2 * expression.exp)]
        elif expression.is_Pow:
            n, d = self.quotient(expression.base)
            k = int(expression.exp)
            return (n**k, d**k) if k >= 0 else (d**-k, n**-k)
        else:
            powers = [(expression, sp.Integer(1))]
        numerator, denominator = self.one, self.one
        for atom, power in powers:
            if not power.is_Integer:
                raise ArithmeticError(f"{expression} has a fractional power")
            variable = self.variables[self.index[atom]]
            if power >= 0:
                numerator *= variable ** int(power)
            else:
                denominator *= variable ** int(-power)
        return numerator, denominator

    def reduce(self, polynomial: fmpq_mpoly, used: set[str]) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        """A polynomial with every root's and every sine's power brought below two: numerator and denominator."""
        denominator = self.one
        for root in self.roots:
            n, d = self.quotient(root.base)
            polynomial, scale = self._replace_square(polynomial, self.index[root], n, d, ROOT, used)
            denominator *= scale
        for angle in self.angles:
            cosine = self.variables[self.index[sp.cos(angle)]]
            polynomial, _ = self._replace_square(
                polynomial, self.index[sp.sin(angle)], 1 - cosine**2, self.one, PYTHAGORAS, used
            )
        return polynomial, denominator

    def _replace_square(
        self, polynomial: fmpq_mpoly, k: int, n: fmpq_mpoly, d: fmpq_mpoly, name: str, used: set[str]
    ) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        """v_k^2 -> n/d; the denominator d^K that the result needs comes along."""
        by_power: dict[int, dict] = {}
        for powers, coefficient in polynomial.to_dict().items():
            rest = (*powers[:k], powers[k] % 2, *powers[k + 1 :])
            by_power.setdefault(powers[k] // 2, {})[rest] = coefficient
        highest = max(by_power, default=0)
        if not highest:
            return polynomial, self.one
        used.add(name)
        total = self.context.constant(0)
        for half, terms in by_power.items():
            total += self.context.from_dict(terms) * n**half * d ** (highest - half)
        return total, d**highest

    def expression(self, polynomial: fmpq_mpoly) -> sp.Expr:
        """Back to SymPy, factored."""
        if polynomial.is_zero():
            return sp.Integer(0)
        constant, factors = polynomial.factor()
        result: list[sp.Expr] = [sp.Rational(int(constant.p), int(constant.q))]
        for factor, multiplicity in factors:
            terms = [
                sp.Rational(int(c.p), int(c.q)) * sp.Mul(*(atom**e for atom, e in zip(self.atoms, powers, strict=True)))
                for powers, c in sorted(factor.to_dict().items(), reverse=True)
            ]
            result.append(sp.Add(*terms) ** int(multiplicity))
        # all at once: SymPy multiplies a number into a lone sum
        return sp.Mul(*result)


def _plain_roots(expression: sp.Expr) -> sp.Expr:
    """Radicands expanded, so that equal ones look alike and squares come out."""
    roots = {p for p in expression.atoms(sp.Pow) if p.exp.is_Rational and p.exp.q == 2}
    return expression.xreplace({p: sp.Pow(sp.expand(p.base), p.exp) for p in roots})


def _common_angles(expression: sp.Expr) -> tuple[sp.Expr, dict[sp.Symbol, sp.Expr]]:
    """Every tan as sin/cos, sums and multiples of angles expanded; parts of angles as symbols, with their values."""
    expression = expression.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x))
    circular = {f for f in expression.atoms(sp.sin, sp.cos)}
    terms = [term.as_coeff_Mul() for f in circular for term in sp.Add.make_args(sp.expand(f.args[0]))]
    denominators: dict[sp.Expr, int] = {}
    for coefficient, monomial in terms:
        denominators[monomial] = sp.ilcm(denominators.get(monomial, 1), coefficient.q)
    halves = {mono: q for mono, q in sorted(denominators.items(), key=lambda item: sp.srepr(item[0])) if q > 1}
    units = {sp.Symbol(f"unit{k}", real=True): mono / q for k, (mono, q) in enumerate(halves.items())}
    of_monomial = {mono: unit * q for unit, (mono, q) in zip(units, halves.items(), strict=True)}

    def in_units(angle: sp.Expr) -> sp.Expr:
        split = (term.as_coeff_Mul() for term in sp.Add.make_args(sp.expand(angle)))
        return sp.Add(*(coefficient * of_monomial.get(mono, mono) for coefficient, mono in split))

    return sp.expand_trig(expression.xreplace({f: f.func(in_units(f.args[0])) for f in circular})), units


def canonical(expression: sp.Expr) -> Quotient:
    """The expression as a quotient of coprime polynomials."""
    plain = _plain_roots(sp.sympify(expression))
    expression, units = _common_angles(plain)
    ring = _Ring([expression])
    numerator, denominator = ring.quotient(expression)
    used = {MULTIPLES} if expression != plain else set()
    if numerator.is_zero():
        return Quotient(sp.Integer(0), sp.Integer(1), tuple(used))
    numerator, below = ring.reduce(numerator, used)
    denominator, above = ring.reduce(denominator, used)
    if denominator.is_zero():
        raise ZeroDivisionError(f"the denominator of {expression} vanishes identically")
    numerator, denominator = numerator * above, denominator * below
    common = numerator.gcd(denominator)
    top, bottom = (ring.expression(part / common).xreplace(units) for part in (numerator, denominator))
    if units:
        top, bottom = (sp.factor(sp.expand(TR8(sp.expand(part)))) for part in (top, bottom))
    return Quotient(top, bottom, tuple(sorted(used)))


def nonzero_somewhere(quotient: Quotient) -> bool:
    """Whether the value at some rational point is certainly not zero."""
    symbols = sorted(quotient.numerator.free_symbols, key=lambda symbol: symbol.name)
    with balls.precision():
        for shift in range(1, 17):
            # spread over (0, 3), signs where they are free, another order each time: to meet every root's domain
            point = {
                symbol: arb((k + 1) * shift * 7 % 23 + 1) / (-8 if not symbol.is_nonnegative and (k + shift) % 2 else 8)
                for k, symbol in enumerate(symbols)
            }
            value = balls.evaluate(quotient.numerator, point)
            if value.is_finite() and not value.contains(0):
                return True
    return False
