"""SymPy expressions in C as macros of arithmetic, whatever the numbers are: doubles, intervals, double-double.

In:  an expression as `passes` leaves it.
Out: its text, each operation a call such as ADD(x, y). What the names stand for is in arithmetic_*.h, which is included
     before the text.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

import sympy as sp

from ..passes import is_constant
from .printing import SharedArctangent, Unprintable, factors_of, literal


def is_double(number: sp.Expr) -> bool:
    """Whether some double is equal to it."""
    return bool(number.is_Rational) and sp.Rational(float(number)) == number


def high_and_low(number: sp.Expr) -> tuple[str, str]:
    """An exact number as the double next to it and the double next to what that leaves."""
    high = literal(number)
    return high, literal(number - sp.Rational(float(high)))


class CallPrinter(SharedArctangent):
    """C99, each operation a macro."""

    infinity = "POINT(HUGE_VAL)"
    functions: ClassVar = {sp.sqrt: "SQRT", sp.atan2: "ATAN2"}
    swapped = "_SWAPPED"

    def _number(self, expr: sp.Expr) -> str:
        value = expr.doit()
        return f"POINT({literal(value)})" if is_double(value) else f"CONSTANT({', '.join(high_and_low(value))})"

    def _print_Add(self, expr: sp.Expr, order: str | None = None) -> str:
        first, *terms = sorted(self._as_ordered_terms(expr), key=sp.Expr.could_extract_minus_sign)
        text = self._print(first)
        for term in terms:
            negative = term.could_extract_minus_sign()
            text = f"{'SUB' if negative else 'ADD'}({text}, {self._print(-term if negative else term)})"
        return text

    def _print_Mul(self, expr: sp.Expr) -> str:
        constant, above, below = factors_of(expr)
        size = abs(constant)
        text = self._multiplied(above) if above else self._number(size)
        if above and size != 1:
            text = f"TIMES({literal(size)}, {text})" if is_double(size) else f"MUL({self._number(size)}, {text})"
        if below:
            text = f"DIV({text}, {self._multiplied(below)})"
        return f"NEG({text})" if constant.is_negative else text

    def _multiplied(self, factors: Sequence[sp.Expr], text: str = "") -> str:
        for factor in factors:
            text = f"MUL({text}, {self._print(factor)})" if text else self._print(factor)
        return text

    def _print_Pow(self, expr: sp.Expr, rational: bool = False) -> str:
        base, exponent = expr.args
        if exponent == sp.Rational(1, 2):
            return f"SQRT({self._print(base)})"
        if exponent == 2:
            return f"SQUARE({self._print(base)})"
        if exponent in (-1, -2, sp.Rational(-1, 2)):
            return f"INVERSE({self._print(sp.Pow(base, -exponent))})"
        raise Unprintable(f"the power {expr} is not a chain of multiplications: it has to go through the passes")


class OperatorPrinter(CallPrinter):
    """The same in the order in which operators take operations: on doubles it has the same bits."""

    def _print_Add(self, expr: sp.Expr, order: str | None = None) -> str:
        first, *terms = self._as_ordered_terms(expr)
        text = self._print(first)
        for term in terms:
            negative, size = self._signed(term)
            text = f"{'SUB' if negative else 'ADD'}({text}, {size})"
        return text

    def _signed(self, term: sp.Expr) -> tuple[bool, str]:
        """Whether a minus stands before it, and what follows."""
        if is_constant(term):
            value = term.doit()
            return bool(value.is_negative), self._number(abs(value))
        if term.is_Mul:
            return self._product(term)
        return False, self._print(term)

    def _print_Mul(self, expr: sp.Expr) -> str:
        negative, text = self._product(expr)
        return f"NEG({text})" if negative else text

    def _product(self, expr: sp.Expr) -> tuple[bool, str]:
        constant, above, below = factors_of(expr)
        size, text = abs(constant), ""
        if size != 1 and above and is_double(size) and not _is_square(above[0]):
            text = f"TIMES({literal(size)}, {self._print(above[0])})"
            above = above[1:]
        elif size != 1 or not above:
            text = self._number(size)
        text = self._multiplied(above, text)
        return bool(constant.is_negative), f"DIV({text}, {self._multiplied(below)})" if below else text

    def _multiplied(self, factors: Sequence[sp.Expr], text: str = "") -> str:
        for factor in factors:
            squared = text and _is_square(factor)
            text = f"BY_SQUARE({text}, {self._print(factor.base)})" if squared else super()._multiplied([factor], text)
        return text


def _is_square(factor: sp.Expr) -> bool:
    return bool(factor.is_Pow and factor.exp == 2)


CALLS, AS_OPERATORS = CallPrinter(), OperatorPrinter()
