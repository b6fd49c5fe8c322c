"""SymPy expressions as NumPy source."""

from __future__ import annotations

from typing import ClassVar

import sympy as sp
from sympy.printing.numpy import NumPyPrinter

from derivations.emit.targets.printing import Rules


class NumpyPrinter(Rules, NumPyPrinter):
    """NumPy, imported as np."""

    infinity = "np.inf"
    functions: ClassVar = {
        sp.sqrt: "np.sqrt",
        sp.cbrt: "np.cbrt",
        sp.Abs: "np.abs",
        sp.sin: "np.sin",
        sp.cos: "np.cos",
        sp.tan: "np.tan",
        sp.atan2: "np.arctan2",
    }

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        return expr.name
