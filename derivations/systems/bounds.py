"""Beside (23): what no state at a forcing exceeds, whatever the mechanism.

In:  `SlowFlow` with viscous damping; the mechanism stays an open h(A).
Out: `Bounds`.

At a state R^2 + I^2 = F_0^2, so that neither R nor I exceeds F_0. I <= F_0 bounds A Omega, and then R = A Omega^2 + h
bounds h:

    A Omega <= c        |h| <= |R| + A Omega^2 <= F_0 + c^2/A
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..paper.slow_flow import SlowFlow
from ..symbols import F_0, A, Omega, h

Let = tuple[sp.Symbol, sp.Expr]

_c, _fastest = sp.symbols("c fastest", nonnegative=True)


@dataclass(frozen=True)
class Bounds:
    """What no state exceeds.

    restoring -- largest |h| at an amplitude, in its lets
    """

    restoring_lets: tuple[Let, ...]
    restoring: sp.Expr


def bounds(flow: SlowFlow) -> Bounds:
    """All of it."""
    (highest,) = sp.solve(flow.I - F_0, Omega)
    c = sp.factor(A * highest)
    if c.has(A) or sp.expand(flow.R - h - A * Omega**2) != 0:
        raise ArithmeticError("A Omega or R - h is not what the bound is made of")
    # c over A is the highest frequency; c^2 may be too large for a double
    return Bounds(((_c, c), (_fastest, _c / A)), F_0 + _c * _fastest)
