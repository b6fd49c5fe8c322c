"""SymPy expressions as calls of functions in C, as of interval arithmetic, and as operators on intervals in Python."""

from __future__ import annotations

from typing import ClassVar

import sympy as sp
from sympy.printing.precedence import PRECEDENCE

from ....forces.quadrature import FUNCTIONS
from ...passes import is_constant
from ..printing import InC, InPython, Unprintable, factors_of, literal


class CallPrinter(InC):
    """C99, each operation a call of a function whose name begins with `prefix`."""

    prefix: ClassVar[str]

    def _of(self, function: str, *arguments: str) -> str:
        return f"{self.prefix}{function}({', '.join(arguments)})"

    def _print_Add(self, expr: sp.Expr, order: str | None = None) -> str:
        first, *terms = sorted(self._as_ordered_terms(expr), key=sp.Expr.could_extract_minus_sign)
        text = self._print(first)
        for term in terms:
            negative = term.could_extract_minus_sign()
            text = self._of("sub" if negative else "add", text, self._print(-term if negative else term))
        return text

    def _print_Mul(self, expr: sp.Expr) -> str:
        constant, *factors = factors_of(expr)
        above, below = ([self._print(one) for one in some] for some in factors)
        text = self._product(above) if above else self._number(abs(constant))
        if above and abs(constant) != 1:
            text = self._times(abs(constant), text)
        if below:
            text = self._of("div", text, self._product(below))
        return self._of("neg", text) if constant.is_negative else text

    def _times(self, constant: sp.Expr, text: str) -> str:
        if is_double(constant):
            return self._of("times", literal(constant), text)
        return self._of("mul", self._number(constant), text)

    def _product(self, factors: list[str]) -> str:
        text = factors[0]
        for factor in factors[1:]:
            text = self._of("mul", text, factor)
        return text

    def _print_Pow(self, expr: sp.Expr, rational: bool = False) -> str:
        base, exponent = expr.args
        if exponent == sp.Rational(1, 2):
            return self._of("sqrt", self._print(base))
        if exponent == 2:
            return self._of("square", self._print(base))
        if exponent in (-1, -2, sp.Rational(-1, 2)):
            return self._of("inverse", self._print(sp.Pow(base, -exponent)))
        raise Unprintable(f"the power {expr} is not a chain of multiplications: it has to go through the passes")


def is_double(number: sp.Expr) -> bool:
    """Whether some double is equal to it."""
    return bool(number.is_Rational) and sp.Rational(float(number)) == number


class CIntervalPrinter(CallPrinter):
    """With the functions of native/interval.h."""

    prefix = "sfi_"
    infinity = "sfi_point(HUGE_VAL)"
    functions: ClassVar = {sp.sqrt: "sfi_sqrt", sp.atan2: "sfi_atan2"}

    def _number(self, expr: sp.Expr) -> str:
        return self._of("point" if is_double(expr.doit()) else "around", literal(expr))


class CEnclosurePrinter(CIntervalPrinter):
    """The same with those of native/elementary.h."""

    functions: ClassVar = {function: f"sfi_{function.__name__}" for function in FUNCTIONS} | {
        sp.sqrt: "sfi_root",
        sp.Pow: "sfi_power",
    }

    def _print_Pow(self, expr: sp.Expr, rational: bool = False) -> str:
        base, exponent = expr.args
        if exponent in (2, -1):
            return super()._print_Pow(expr, rational)
        if exponent.could_extract_minus_sign():
            return self._of("inverse", self._print(sp.Pow(base, -exponent)))
        if exponent == sp.Rational(1, 2):
            return self._of("root", self._print(base))
        return self._of("power", self._print(base), self._print(exponent))

    def _print_Function(self, expr: sp.Expr) -> str:
        return self._number(expr) if is_constant(expr) else super()._print_Function(expr)


class PythonIntervalPrinter(InPython):
    """Python, with the operators of an interval class and its methods `square` and `sqrt`."""

    functions: ClassVar = {sp.sqrt: "sqrt"}

    def _number(self, expr: sp.Expr) -> str:
        text = literal(expr)
        if not is_double(expr.doit()):
            raise Unprintable(f"a number that no double is equal to, on intervals: {expr}")
        return text

    def _print_Pow(self, expr: sp.Expr, rational: bool = False) -> str:
        method = {sp.Integer(2): "square", sp.Rational(1, 2): "sqrt"}.get(expr.exp)
        if method is None:
            return super()._print_Pow(expr, rational)
        return f"{self.parenthesize(expr.base, PRECEDENCE['Atom'], strict=True)}.{method}()"


class EnclosurePrinter(PythonIntervalPrinter):
    """The same with a method for each elementary function, and `around` for numbers that no double is equal to."""

    functions: ClassVar = {function: function.__name__ for function in FUNCTIONS} | {sp.sqrt: "root", sp.Pow: "power"}

    def _number(self, expr: sp.Expr) -> str:
        text = literal(expr)
        return text if is_double(expr.doit()) else f"around({text})"

    def _print_Mul(self, expr: sp.Expr) -> str:
        constant = sp.Mul(*(factor.doit() for factor in expr.args if is_constant(factor)))
        if is_double(constant):
            return super()._print_Mul(expr)
        rest = sp.Mul(*(factor for factor in expr.args if not is_constant(factor)))
        return f"{self._number(constant)} * {self.parenthesize(rest, PRECEDENCE['Mul'])}"

    def _print_Pow(self, expr: sp.Expr, rational: bool = False) -> str:
        if expr.exp == 2:
            return super()._print_Pow(expr, rational)
        base = self.parenthesize(expr.base, PRECEDENCE["Atom"], strict=True)
        if expr.exp == sp.Rational(1, 2):
            return f"{base}.root()"
        if expr.exp == -1:
            return f"1.0 / {base}"
        if expr.exp.could_extract_minus_sign():
            return f"1.0 / {self._print_Pow(sp.Pow(expr.base, -expr.exp))}"
        return f"{base}.power({self._print(expr.exp)})"

    def _print_Function(self, expr: sp.Expr) -> str:
        (argument,) = expr.args
        if is_constant(expr):
            return self._number(expr)
        return f"{self.parenthesize(argument, PRECEDENCE['Atom'], strict=True)}.{self.functions[expr.func]}()"
