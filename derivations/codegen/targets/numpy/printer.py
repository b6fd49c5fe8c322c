"""SymPy expressions as NumPy source."""

from __future__ import annotations

import re
from typing import ClassVar

import sympy as sp
from sympy.codegen.cfunctions import hypot
from sympy.printing.precedence import PRECEDENCE

from ....forces.quadrature import FUNCTIONS
from ...compensated import copysign, fma
from ..printing import InPython


class NumpyPrinter(InPython):
    """NumPy, imported as np; an inverse is arcsin, not asin."""

    functions: ClassVar = {function: f"np.{re.sub('^a', 'arc', function.__name__)}" for function in FUNCTIONS} | {
        sp.sqrt: "np.sqrt",
        sp.cbrt: "np.cbrt",
        hypot: "np.hypot",
        sp.Abs: "np.abs",
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
