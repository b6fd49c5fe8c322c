"""SymPy expressions as calls of interval arithmetic in C, and as operators on intervals in Python."""

from __future__ import annotations

from typing import ClassVar

import sympy as sp
from sympy.printing.c import C99CodePrinter
from sympy.printing.numpy import NumPyPrinter
from sympy.printing.precedence import PRECEDENCE

from ...passes import is_constant
from ..printing import Rules, Unprintable, literal


class CIntervalPrinter(Rules, C99CodePrinter):
    """C99, with the functions of native/interval.h."""

    infinity = "sfi_point(HUGE_VAL)"
    functions: ClassVar = {sp.sqrt: "sfi_sqrt", sp.atan2: "sfi_atan2"}

    def _print_Rational(self, expr: sp.Expr) -> str:
        return self._number(expr)

    _print_Integer = _print_Half = _print_One = _print_Zero = _print_NegativeOne = _print_Pi = _print_Rational

    def _number(self, expr: sp.Expr) -> str:
        text = literal(expr)
        exact = expr.doit().is_Rational and sp.Rational(float(text)) == expr.doit()
        return f"sfi_{'point' if exact else 'around'}({text})"

    def _print_UnevaluatedExpr(self, expr: sp.UnevaluatedExpr) -> str:
        return self._number(expr)

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        # complex.h makes a macro of I
        return "I_" if expr.name == "I" else expr.name

    def _print_Add(self, expr: sp.Expr, order: str | None = None) -> str:
        if is_constant(expr):
            return self._number(expr)
        first, *terms = sorted(self._as_ordered_terms(expr), key=sp.Expr.could_extract_minus_sign)
        text = self._print(first)
        for term in terms:
            negative = term.could_extract_minus_sign()
            text = f"sfi_{'sub' if negative else 'add'}({text}, {self._print(-term if negative else term)})"
        return text

    def _print_Mul(self, expr: sp.Expr) -> str:
        if is_constant(expr):
            return self._number(expr)
        factors = expr.as_ordered_factors()
        constant = sp.Mul(*(factor.doit() for factor in factors if is_constant(factor)))
        above, below = [], []
        for factor in factors:
            if is_constant(factor):
                continue
            if factor.is_Pow and factor.exp.could_extract_minus_sign():
                below.append(self._print(sp.Pow(factor.base, -factor.exp)))
            else:
                above.append(self._print(factor))
        text = self._product(above) if above else self._number(abs(constant))
        if above and abs(constant) != 1:
            text = self._times(abs(constant), text)
        if below:
            text = f"sfi_div({text}, {self._product(below)})"
        return f"sfi_neg({text})" if constant.is_negative else text

    def _times(self, constant: sp.Expr, text: str) -> str:
        exact = constant.is_Rational and sp.Rational(float(constant)) == constant
        return f"sfi_times({literal(constant)}, {text})" if exact else f"sfi_mul({self._number(constant)}, {text})"

    def _product(self, factors: list[str]) -> str:
        text = factors[0]
        for factor in factors[1:]:
            text = f"sfi_mul({text}, {factor})"
        return text

    def _print_Pow(self, expr: sp.Expr, rational: bool = False) -> str:
        if is_constant(expr):
            return self._number(expr)
        base, exponent = expr.args
        if exponent == sp.Rational(1, 2):
            return f"sfi_sqrt({self._print(base)})"
        if exponent == 2:
            return f"sfi_square({self._print(base)})"
        if exponent in (-1, -2, sp.Rational(-1, 2)):
            return f"sfi_inverse({self._print(sp.Pow(base, -exponent))})"
        raise Unprintable(f"the power {expr} is not a chain of multiplications: it has to go through the passes")


class PythonIntervalPrinter(Rules, NumPyPrinter):
    """Python, with the operators of an interval class and its methods `square` and `sqrt`."""

    infinity = "np.inf"
    functions: ClassVar = {sp.sqrt: "sqrt"}

    def _print_Rational(self, expr: sp.Expr) -> str:
        return self._number(expr)

    _print_Integer = _print_Half = _print_One = _print_Zero = _print_NegativeOne = _print_Pi = _print_Rational

    def _number(self, expr: sp.Expr) -> str:
        text = literal(expr)
        if not (expr.doit().is_Rational and sp.Rational(float(text)) == expr.doit()):
            raise Unprintable(f"a number that no double is equal to, on intervals: {expr}")
        return text

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        return expr.name

    def _print_Pow(self, expr: sp.Expr, rational: bool = False) -> str:
        method = {sp.Integer(2): "square", sp.Rational(1, 2): "sqrt"}.get(expr.exp)
        if is_constant(expr) or method is None:
            return super()._print_Pow(expr, rational)
        return f"{self.parenthesize(expr.base, PRECEDENCE['Atom'], strict=True)}.{method}()"
