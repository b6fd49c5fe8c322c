"""Forces of references and tests, each stated once: pieces by rising u > 0, each with where it ends.

The package derives averages from these; the references evaluate them as they are, on series of FLINT (`on_series`).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

u, k, c, p, a, b, gap, end = sp.symbols("u k c p a b gap end")
#: the root of what u exceeds the last breakpoint by
excess = sp.Symbol("excess", positive=True)
Pieces = list[tuple[Any, Any]]

_stopped_softly: Pieces = [(u, gap), (u + c * sp.tanh(k * (u - gap)), None)]
_touching: Pieces = [(u, gap), (u + k * (u - gap) ** sp.Rational(3, 2), None)]
_wave: Pieces = [(u + k * sp.sin(c * u), None)]
_exponential: Pieces = [(k * (sp.exp(c * u) - 1), None)]
_oblique: Pieces = [(u + 2 * k * u * (1 - c / sp.sqrt(c**2 + u**2)), None)]
#: of `forces.json`
AVERAGED: dict[str, Pieces] = {
    "pendulum": [(k * sp.sin(u), None)],
    "preload": [(c + k * u + u**3, None)],
    "quadratic": [(k * u + c * u**2, None)],
    "preloaded_stop": [(c + k * u, gap), (c + k * u + p * (u - gap), None)],
    "let_go": [(c + p * u + p * u**2 - u**3, gap), (k * u, None)],
    "wave": _wave,
    "saturating": [(sp.tanh(k * u), None)],
    "exponential": _exponential,
    "oblique": _oblique,
    "arctangent": [(sp.atan(u / k), None)],
    "dead": [(sp.Integer(0), gap), (k * (u - gap) ** 2, None)],
    "hard_stop": [(u, gap), (u + 2 * k * sp.sinh(u - gap), None)],
    "soft_stop": _stopped_softly,
    "two_stops": [
        (u, gap),
        (u + c * sp.tanh(k * (u - gap)), end),
        (u + c * sp.tanh(k * (end - gap)) + p * (u - end), None),
    ],
    "two_steps": [(k * sp.sin(u), gap), (p * u + (u - gap) ** 2 * sp.exp(c * u), end), (u**3 + c * u, None)],
    "letting_go": [(k * sp.sin(u), gap), (u, None)],
    "hertz": _touching,
    "buffer": [(u + u**3, gap), (u + u**3 + k * (u - gap) ** sp.Rational(5, 2) * (1 + c * u), None)],
}
#: of `stated.json`
STATED: dict[str, Pieces] = {
    "wave": _wave,
    "saturating": [(c * u + sp.tanh(k * u), None)],
    "exponential": _exponential,
    "oblique": _oblique,
    "magnets": [(u + k * (1 / (c - u) ** 2 - 1 / (c + u) ** 2), None)],
    "power": [(u + k * u**p, None)],
    "root": [(u + k * u**p, None)],
    "preload": [(c + k * (sp.exp(u) - 1), None)],
    "preload_power": [(c + u + k * u**p, None)],
    "soft_stop": _stopped_softly,
    "hard_stop": [(u, gap), (u + k * (sp.exp(c * (u - gap)) - 1), None)],
    "root_stop": [(u, gap), (u + k * (sp.sqrt(1 + c * (u - gap)) - 1), None)],
    "contact": _touching,
    "preloaded_stop": [
        (c + u + k * sp.sin(u), gap),
        (c + u + k * sp.sin(u) + 3 * sp.tanh(u - gap), None),
    ],
}
#: of `closed.json`
CLOSED: dict[str, Pieces] = {
    "stop": [(u, gap), (u + k * (u - gap), None)],
    "bilinear": [(u, gap), (u + (k - 1) * (u - gap), None)],
    "play": [(sp.Integer(0), gap), (u - gap, None)],
    "even": [(u + a * u**2 + b * u**3, None)],
    "preload": [(c + u + b * u**3, None)],
}


def names_of(pieces: Pieces) -> list[str]:
    """Of a force's numbers."""
    expressions = [sp.sympify(one) for piece in pieces for one in piece if one is not None]
    return sorted({str(name) for one in expressions for name in one.free_symbols} - {"u"})


def tanh(x: Any) -> Any:
    """Of a series or a ball."""
    doubled = (2 * x).exp()
    return (doubled - 1) / (doubled + 1)


def root(x: Any) -> Any:
    """The square root, where the argument stays off its cut; a ValueError elsewhere."""
    first = x[0]
    if not (first.real > 0 or first.imag > 0 or first.imag < 0):
        raise ValueError("next to a branch cut")
    return x.sqrt()


def arctangent(x: Any) -> Any:
    """The same of the arctangent, whose cuts leave i and -i."""
    first = x[0]
    if not (first.real > 0 or first.real < 0 or abs(first.imag) < 1):
        raise ValueError("next to a branch cut")
    return x.atan()


_FUNCTIONS = {
    "sin": lambda x: x.sin(),
    "exp": lambda x: x.exp(),
    "sinh": lambda x: (x.exp() - (-x).exp()) / 2,
    "tanh": tanh,
    "sqrt": root,
    "atan": arctangent,
}


def on_series(expression: Any) -> Callable[..., Any]:
    """The expression as a function of u, of the numbers by name, and of `excess` where it is stated in that."""
    names = [name for name in names_of([(expression, None)]) if name != "excess"]
    f = sp.lambdify([u, excess, *names], expression, modules=[_FUNCTIONS])
    return lambda u, number, excess=None: 0 * u + f(u, excess, *map(number, names))


def in_excess(expression: Any, begin: Any) -> Any:
    """A power of what u exceeds the begin of a piece by, in that."""
    return expression.replace(lambda one: one.is_Pow and one.base == u - begin, lambda one: excess ** (2 * one.exp))
