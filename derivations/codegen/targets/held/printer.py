"""SymPy expressions as calls of double-double arithmetic that carries a bound of its error."""

from __future__ import annotations

from typing import ClassVar

import sympy as sp

from ..interval.printer import CallPrinter, is_double
from ..pair.printer import high_and_low
from ..printing import literal


class HeldPrinter(CallPrinter):
    """With the functions of native/held.h."""

    prefix = "sfh_"
    infinity = "sfh_point(HUGE_VAL)"
    functions: ClassVar = {sp.sqrt: "sfh_sqrt", sp.atan2: "sfh_atan2"}

    def _number(self, expr: sp.Expr) -> str:
        value = expr.doit()
        return self._of("point", literal(value)) if is_double(value) else self._of("around", *high_and_low(value))
