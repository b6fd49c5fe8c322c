"""SymPy expressions as source text: what the printers of all languages share.

In:  an expression as `passes` leaves it: exact numbers, powers as products but in where a piece ends.
Out: source text, every number a double of 17 digits, by a class that mixes in `Rules` and has the table `functions`.

Whatever a printer does not know is an error (`Unprintable`): an unsupported function, a floating-point number, an
object that was not evaluated, a power that is not a chain.
"""

from __future__ import annotations

import functools
from typing import ClassVar

import sympy as sp
from sympy.printing.c import C99CodePrinter
from sympy.printing.numpy import NumPyPrinter
from sympy.printing.precedence import PRECEDENCE

from ..passes import is_constant

#: the highest power that is printed as a product
LONGEST = 8


class Unprintable(TypeError):
    """The printer does not know this object."""


def literal(number: sp.Expr) -> str:
    """An exact real number as a double: 17 significant digits, always with a point or an exponent."""
    if number.atoms(sp.Float):
        raise Unprintable(f"a floating-point number among exact ones: {number}")
    number = number.doit()
    for node in sp.preorder_traversal(number):
        built = node.is_Rational or node.is_Add or node.is_Mul or node.is_Pow or isinstance(node, sp.Function)
        if not (built or node in (sp.pi, sp.E)):
            raise Unprintable(f"not a rational, pi, e, or made of such: {node}")
    if not number.is_real:
        raise Unprintable(f"not a finite real number: {number}")
    # 40 digits first: SymPy's own conversion rounds once more
    text = format(float(sp.N(number, 40)), ".17g")
    return text if any(mark in text for mark in ".e") else text + ".0"


def stated(number: sp.Expr | int) -> str:
    """The same, but a count as an integer."""
    return str(number) if isinstance(number, int) else literal(number)


@functools.cache
def ordered_terms(total: sp.Expr) -> list[sp.Expr]:
    """As SymPy orders them, once for all languages: it evaluates their coefficients."""
    return total.as_ordered_terms()


@functools.cache
def factors_of(product: sp.Expr) -> tuple[sp.Expr, list[sp.Expr], list[sp.Expr]]:
    """The constant of a product, its other factors, and those of its denominator, as SymPy orders them."""
    factors = product.as_ordered_factors()
    constant = sp.Mul(*(factor.doit() for factor in factors if is_constant(factor)))
    above, below = [], []
    for factor in factors:
        if is_constant(factor):
            continue
        if factor.is_Pow and factor.exp.could_extract_minus_sign():
            below.append(sp.Pow(factor.base, -factor.exp))
        else:
            above.append(factor)
    return constant, above, below


class Rules:
    """Mixed in before one of SymPy's printers.

    functions   -- what the language calls each function
    infinity    -- and infinity
    conjunction -- what stands between two conditions
    bracketed   -- whether a long right-hand side may only break inside of brackets
    """

    functions: ClassVar[dict[object, str]]
    infinity: str
    conjunction: str
    bracketed: bool

    def _number(self, expr: sp.Expr) -> str:
        """A constant but an infinity, or a function of constants."""
        return literal(expr)

    def _as_ordered_terms(self, expr: sp.Expr, order: str | None = None) -> list[sp.Expr]:
        return ordered_terms(expr)

    def _print_Infinity(self, expr: sp.Expr) -> str:
        return self.infinity

    def _print_Add(self, expr: sp.Expr, order: str | None = None) -> str:
        text = ""
        for term in self._as_ordered_terms(expr):
            part = f"({self._print(term)})" if term.is_Add else self._print(term)
            if not text:
                text = part
            elif part.startswith("-"):
                text += " - " + part[1:]
            else:
                text += " + " + part
        return text

    def _print_Mul(self, expr: sp.Expr) -> str:
        constant, *factors = factors_of(expr)
        above, below = ([self.parenthesize(one, PRECEDENCE["Mul"]) for one in some] for some in factors)
        sign = "-" if constant.is_negative else ""
        if abs(constant) != 1 or not above:
            above.insert(0, literal(abs(constant)))
        text = sign + " * ".join(above)
        if below:
            product = any(one.is_Pow and one.exp.is_Integer for one in factors[1])
            text += " / " + (f"({' * '.join(below)})" if len(below) > 1 or product else below[0])
        return text

    def _print_Pow(self, expr: sp.Expr, rational: bool = False) -> str:
        base, exponent = expr.args
        if exponent == sp.Rational(1, 2):
            return f"{self.functions[sp.sqrt]}({self._print(base)})"
        if exponent == sp.Rational(1, 3):
            return f"{self.functions[sp.cbrt]}({self._print(base)})"
        # in where a piece ends; kernels have lost theirs in the passes
        if exponent.is_Integer and 2 <= exponent <= LONGEST:
            return " * ".join([self.parenthesize(base, PRECEDENCE["Mul"])] * int(exponent))
        if exponent == sp.Rational(-1, 2) or (exponent.is_Integer and -LONGEST <= exponent < 0):
            return self._print_Mul(sp.Mul(sp.Integer(1), expr, evaluate=False))
        if exponent.is_Integer or sp.Pow not in self.functions:
            raise Unprintable(f"the power {expr} is not a chain of multiplications: it has to go through the passes")
        return f"{self.functions[sp.Pow]}({self._print(base)}, {self._print(exponent)})"

    def _print(self, expr: sp.Basic, **settings: object) -> str:
        # SymPy's printers have a method for each function they know, which would come before the table, and print more
        if isinstance(expr, sp.Function):
            return self._print_Function(expr) if expr.func in self.functions else self.emptyPrinter(expr)
        if is_constant(expr) and expr is not sp.oo:
            return self._number(expr)
        if expr is not sp.oo and not isinstance(expr, sp.Symbol | sp.Add | sp.Mul | sp.Pow | sp.UnevaluatedExpr):
            self.emptyPrinter(expr)
        return super()._print(expr, **settings)

    def _print_Function(self, expr: sp.Expr) -> str:
        return f"{self.functions[expr.func]}({', '.join(self._print(arg) for arg in expr.args)})"

    def emptyPrinter(self, expr: sp.Basic) -> str:
        raise Unprintable(f"{type(self).__name__} does not know {type(expr).__name__}: {expr}")

    _print_not_supported = emptyPrinter

    def doprint(self, expr: sp.Expr, assign_to: None = None) -> str:
        """Source text of one expression; kept, because kernels of one family share most of theirs."""
        if not isinstance(expr, sp.Basic):
            self.emptyPrinter(expr)
        if expr not in self._kept:
            self._kept[expr] = self._print(expr)
        return self._kept[expr]

    @functools.cached_property
    def _kept(self) -> dict[sp.Expr, str]:
        return {}


class InC(Rules, C99CodePrinter):
    """C99."""

    conjunction, bracketed = " && ", False

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        # complex.h makes a macro of I
        return "I_" if expr.name == "I" else expr.name


class SharedArctangent(InC):
    """An angle and its complement from the same arguments in the same order: they share their arctangent."""

    swapped: ClassVar = "_swapped"

    def _print_Function(self, expr: sp.Expr) -> str:
        if expr.func is not sp.atan2:
            return super()._print_Function(expr)
        name, (y, x) = self.functions[sp.atan2], map(self._print, expr.args)
        return f"{name}({y}, {x})" if y <= x else f"{name}{self.swapped}({x}, {y})"


class InPython(Rules, NumPyPrinter):
    """Python, with NumPy as np."""

    infinity = "np.inf"
    conjunction, bracketed = " & ", True

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        return expr.name
