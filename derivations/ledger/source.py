"""The namespace that makes formulas of published.py, and of the files of `literature`, exact."""

from __future__ import annotations

from types import SimpleNamespace

import sympy as sp


def _arcsin(x: sp.Expr) -> sp.Expr:
    """Of the sine of a positive symbol, that symbol: it is put in as an angle up to pi/2."""
    return x.args[0] if isinstance(x, sp.sin) and x.args[0].is_Symbol and x.args[0].is_positive else sp.asin(x)


def _sqrt(x: sp.Expr) -> sp.Expr:
    """Of one less the square of such a sine, the cosine."""
    for sine in x.atoms(sp.sin) if isinstance(x, sp.Expr) else ():
        if x == 1 - sine**2 and _arcsin(sine) == sine.args[0]:
            return sp.cos(sine.args[0])
    return sp.sqrt(x)


#: the functions that published.py, and the files of `literature`, ask their namespace for
EXACT = SimpleNamespace(
    sin=sp.sin,
    cos=sp.cos,
    sqrt=_sqrt,
    arccos=sp.acos,
    exp=sp.exp,
    sign=sp.sign,
    pi=sp.pi,
    arcsin=_arcsin,
    cbrt=lambda x: sp.root(sp.cancel(x), 3),
    power=lambda numerator, denominator, exponent: sp.Rational(numerator, denominator) ** exponent,
    rational=sp.Rational,
)
