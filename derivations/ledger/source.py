"""In: the path of published.py. Out: that file as a module of its own, and the namespace that makes it exact.

The runtime package is not imported: the ledger must not depend on what it is there to judge.
"""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType, SimpleNamespace

import sympy as sp

PUBLISHED = Path(__file__).parents[2] / "src" / "slowflow" / "paper" / "published.py"


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


def load() -> ModuleType:
    """published.py."""
    name = "published_standalone"
    spec = importlib.util.spec_from_file_location(name, PUBLISHED)
    if spec is None or spec.loader is None:
        raise ImportError(f"{PUBLISHED} cannot be loaded")
    module = importlib.util.module_from_spec(spec)
    # dataclasses look their module up by name while they are being made
    sys.modules[name] = module
    try:
        spec.loader.exec_module(module)
    finally:
        del sys.modules[name]
    return module
