"""Whether an expression vanishes: quotients of polynomials, which are decided, and others, which SymPy simplifies."""

from __future__ import annotations

import pytest
import sympy as sp

from derivations.vanishing import reduced, vanishes

x, y = sp.symbols("x y", positive=True)
NOTHING = [
    sp.Integer(0),
    (x + y) ** 3 - x**3 - 3 * x * y * (x + y) - y**3,
    x / (x + y) + y / (x + y) - 1,
    1 / (x - y) - (x + y) / (x**2 - y**2),
    sp.sin(x) ** 2 + sp.cos(x) ** 2 - 1,
    (sp.sqrt(x) + sp.sqrt(y)) * (sp.sqrt(x) - sp.sqrt(y)) - x + y,
]
SOMETHING = [sp.Integer(1), x - y, x / (x + y) - 1, 1 / x - 1 / y, sp.sqrt(x) - y]


@pytest.mark.parametrize("expression", NOTHING, ids=str)
def test_nothing_is_left(expression: sp.Expr) -> None:
    assert vanishes(expression)
    assert reduced(expression) == 0


@pytest.mark.parametrize("expression", SOMETHING, ids=str)
def test_something_is_left(expression: sp.Expr) -> None:
    assert not vanishes(expression)
    assert reduced(expression) != 0
