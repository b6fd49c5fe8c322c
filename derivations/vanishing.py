"""Whether an expression is 0, whatever its symbols are.

In:  an exact expression.
Out: True where it is shown to vanish. A quotient of polynomials does if its numerator has no term, which is decided
     either way; SymPy simplifies anything else, which takes a hundred times as long.
"""

from __future__ import annotations

import sympy as sp


def vanishes(expression: sp.Expr) -> bool:
    """Whether nothing is left of it."""
    if sp.expand(expression) == 0:
        return True
    if expression.is_rational_function():
        return bool(sp.expand(sp.fraction(sp.together(expression))[0]) == 0)
    return bool(sp.simplify(expression) == 0)


def reduced(expression: sp.Expr) -> sp.Expr:
    """The same in a form that is 0 where it vanishes."""
    return sp.cancel(expression) if expression.is_rational_function() else sp.simplify(expression)
