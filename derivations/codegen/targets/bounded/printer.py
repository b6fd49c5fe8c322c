"""SymPy expressions as calls of double-double arithmetic that carries a bound of its error."""

from __future__ import annotations

from typing import ClassVar

import sympy as sp

from ..interval.printer import CallPrinter, is_double
from ..pair.printer import high_and_low
from ..printing import literal


class BoundedPrinter(CallPrinter):
    """With the functions of native/bounded.h."""

    prefix = "sfb_"
    infinity = "sfb_point(HUGE_VAL)"
    functions: ClassVar = {sp.sqrt: "sfb_sqrt", sp.atan2: "sfb_atan2"}

    def _number(self, expr: sp.Expr) -> str:
        value = expr.doit()
        return self._of("point", literal(value)) if is_double(value) else self._of("around", *high_and_low(value))
