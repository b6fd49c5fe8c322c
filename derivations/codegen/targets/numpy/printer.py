"""SymPy expressions as NumPy source."""

from __future__ import annotations

from typing import ClassVar

import sympy as sp
from sympy.codegen.cfunctions import hypot, log1p
from sympy.printing.numpy import NumPyPrinter
from sympy.printing.precedence import PRECEDENCE

from ...compensated import copysign, fma
from ..printing import Rules


class NumpyPrinter(Rules, NumPyPrinter):
    """NumPy, imported as np."""

    infinity = "np.inf"
    functions: ClassVar = {
        sp.sqrt: "np.sqrt",
        sp.cbrt: "np.cbrt",
        hypot: "np.hypot",
        sp.Abs: "np.abs",
        sp.sin: "np.sin",
        sp.cos: "np.cos",
        sp.tan: "np.tan",
        sp.exp: "np.exp",
        sp.log: "np.log",
        log1p: "np.log1p",
        sp.sinh: "np.sinh",
        sp.cosh: "np.cosh",
        sp.tanh: "np.tanh",
        sp.asin: "np.arcsin",
        sp.acos: "np.arccos",
        sp.atan: "np.arctan",
        sp.asinh: "np.arcsinh",
        sp.acosh: "np.arccosh",
        sp.atanh: "np.arctanh",
        sp.Pow: "np.power",
        fma: "",
        copysign: "np.copysign",
        sp.atan2: "np.arctan2",
    }

    def _print_Function(self, expr: sp.Expr) -> str:
        if expr.func is fma:
            # NumPy has none; it stands alone on a right-hand side, so that it needs no brackets
            x, y, z = (self.parenthesize(arg, PRECEDENCE["Mul"]) for arg in expr.args)
            return f"{x} * {y} + {z}"
        return super()._print_Function(expr)

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        return expr.name
