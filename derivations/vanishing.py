"""Whether an expression is 0, whatever its symbols are.

In:  an exact expression.
Out: True where it is shown to vanish. A quotient of polynomials does if its numerator has no term, which is decided
     either way; SymPy simplifies anything else that vanishes at one point, which takes a hundred times as long.
"""

from __future__ import annotations

import sympy as sp


def vanishes(expression: sp.Expr) -> bool:
    """Whether nothing is left of it."""
    if sp.expand(expression) == 0 or sp.expand(sp.fraction(sp.together(expression))[0]) == 0:
        return True
    if expression.is_rational_function():
        return False
    point = {symbol: sp.Rational(1, k) for k, symbol in enumerate(sorted(expression.free_symbols, key=str), start=2)}
    return sp.N(expression.subs(point), chop=True) == 0 and bool(sp.simplify(expression) == 0)


def reduced(expression: sp.Expr) -> sp.Expr:
    """The same in a form that is 0 where it vanishes."""
    return sp.cancel(expression) if expression.is_rational_function() else sp.simplify(expression)
