"""SymPy expressions as operators on FLINT's balls in Python, every number exact or enclosed to the digits asked for."""

from __future__ import annotations

from typing import ClassVar

import sympy as sp
from sympy.printing.precedence import PRECEDENCE

from ....forces.elliptic import R_D, R_F
from ..interval.printer import EnclosurePrinter, is_double
from ..printing import Unprintable, literal


class BallPrinter(EnclosurePrinter):
    """With the methods of `flint.arb`, and Carlson's integrals from slowflow.support/balls.py."""

    conjunction = " and "
    functions: ClassVar = {sp.sqrt: "sqrt", sp.atan2: "arb.atan2", R_F: "R_F", R_D: "R_D"}

    def _number(self, expr: sp.Expr) -> str:
        value = expr.doit()
        if is_double(value):
            return literal(value)
        rational, power = value.as_coeff_Mul()
        if power not in (1, sp.pi, 1 / sp.pi) or not rational.is_Rational:
            raise Unprintable(f"a number that is no rational times a power of pi: {expr}")
        if power == 1:
            return f"(arb({rational.p}) / {rational.q})"
        above, below = [str(rational.p)] * (rational.p != 1), [str(rational.q)] * (rational.q != 1)
        (above if power == sp.pi else below).append("arb.pi()")
        over = f" / {below[0]}" if len(below) == 1 else f" / ({' * '.join(below)})" if below else ""
        return f"({' * '.join(above) or '1'}{over})"

    def _print_Pow(self, expr: sp.Expr, rational: bool = False) -> str:
        base = self.parenthesize(expr.base, PRECEDENCE["Atom"], strict=True)
        if expr.exp == 2:
            return f"{base}**2"
        if expr.exp == sp.Rational(1, 2):
            return f"{base}.sqrt()"
        return super()._print_Pow(expr, rational)

    def _print_Function(self, expr: sp.Expr) -> str:
        return f"{self.functions[expr.func]}({', '.join(self._print(argument) for argument in expr.args)})"
