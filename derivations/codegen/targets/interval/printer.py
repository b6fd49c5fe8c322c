"""SymPy expressions on intervals: with elementary functions in C, and as operators in Python."""

from __future__ import annotations

from typing import ClassVar

import sympy as sp
from sympy.printing.precedence import PRECEDENCE

from ....forces.quadrature import FUNCTIONS
from ...passes import is_constant
from ..calls import CallPrinter, is_double
from ..printing import InPython, Unprintable, literal


class CEnclosurePrinter(CallPrinter):
    """C with the functions of native/elementary.h."""

    functions: ClassVar = {function: f"sfi_{function.__name__}" for function in FUNCTIONS} | {
        sp.sqrt: "sfi_root",
        sp.Pow: "sfi_power",
    }

    def _print_Pow(self, expr: sp.Expr, rational: bool = False) -> str:
        base, exponent = expr.args
        if exponent in (2, -1):
            return super()._print_Pow(expr, rational)
        if exponent.could_extract_minus_sign():
            return f"INVERSE({self._print(sp.Pow(base, -exponent))})"
        if exponent == sp.Rational(1, 2):
            return f"sfi_root({self._print(base)})"
        return f"sfi_power({self._print(base)}, {self._print(exponent)})"

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
