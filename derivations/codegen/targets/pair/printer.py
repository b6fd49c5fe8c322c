"""SymPy expressions as calls of double-double arithmetic in C."""

from __future__ import annotations

from typing import ClassVar

import sympy as sp

from ..interval.printer import CallPrinter, is_double
from ..printing import SharedArctangent, literal


def high_and_low(number: sp.Expr) -> tuple[str, str]:
    """An exact number as the double next to it and the double next to what that leaves."""
    high = literal(number)
    return high, literal(number - sp.Rational(float(high)))


class PairPrinter(SharedArctangent, CallPrinter):
    """With the functions of native/pair.h and the generated arctangent."""

    prefix = "sfp_"
    infinity = "sfp_point(HUGE_VAL)"
    functions: ClassVar = {sp.sqrt: "sfp_sqrt", sp.atan2: "pair_angles_atan2"}

    def _number(self, expr: sp.Expr) -> str:
        value = expr.doit()
        return self._of("point", literal(value)) if is_double(value) else self._of("of", *high_and_low(value))
