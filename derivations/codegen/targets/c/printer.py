"""SymPy expressions as C99, and the functions that they call."""

from __future__ import annotations

from typing import ClassVar

import sympy as sp
from sympy.codegen.cfunctions import hypot, log1p
from sympy.printing.c import C99CodePrinter

from ...compensated import copysign, fma
from ..printing import Rules


class CPrinter(Rules, C99CodePrinter):
    """C99, with math.h's functions and the arctangent of `arctangent`."""

    infinity = "INFINITY"
    functions: ClassVar = {
        sp.sqrt: "sqrt",
        sp.cbrt: "cbrt",
        hypot: "hypot",
        sp.Abs: "fabs",
        sp.sin: "sin",
        sp.cos: "cos",
        sp.tan: "tan",
        sp.exp: "exp",
        sp.log: "log",
        log1p: "log1p",
        sp.sinh: "sinh",
        sp.cosh: "cosh",
        sp.tanh: "tanh",
        sp.asin: "asin",
        sp.acos: "acos",
        sp.atan: "atan",
        sp.asinh: "asinh",
        sp.acosh: "acosh",
        sp.atanh: "atanh",
        sp.Pow: "pow",
        fma: "fma",
        copysign: "copysign",
        sp.atan2: "angles_atan2",
    }

    def _print_Function(self, expr: sp.Expr) -> str:
        if expr.func is sp.atan2:
            # an angle and its complement from the same arguments in the same order: they share their arctangent
            y, x = (self._print(arg) for arg in expr.args)
            return f"angles_atan2({y}, {x})" if y <= x else f"angles_atan2_swapped({x}, {y})"
        return super()._print_Function(expr)

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        # complex.h makes a macro of I
        return "I_" if expr.name == "I" else expr.name
