"""What a user states of a mechanism, checked. Takes arguments as they come; returns what the derivation takes of them.

Each refusal names the argument, what it was, and what is allowed: TypeError for another kind of thing, ValueError for
one that is not allowed.
"""

from __future__ import annotations

import keyword
import math
import sys
from collections.abc import Mapping, Sequence
from numbers import Real
from typing import Any

import sympy as sp

from slowflow.support.errors import Refused, WrongType

#: what is said of a parameter, and which of that are bounds
TEXTS, BOUNDS = ("doc", "unit"), ("above", "least", "below", "most")
#: the largest denominator of a fraction that is shown as one
LONGEST = 10**9


def text(what: str, value: Any) -> str:
    """A string."""
    if not isinstance(value, str):
        raise WrongType(f"{what} = {value!r} is not allowed: it must be a string")
    if not value.isascii() and value != value.encode(errors="ignore").decode():
        raise Refused(f"{what} = {value!r} is not allowed: it has half of a surrogate pair, which no file can hold")
    return value


def flag(what: str, value: Any) -> bool:
    """True or False."""
    if not isinstance(value, bool):
        raise WrongType(f"{what} = {value!r} is not allowed: it must be True or False")
    return value


def module_name(value: Any) -> str:
    """The name of a module."""
    if not text("name", value).isidentifier() or keyword.iskeyword(value):
        raise Refused(f"name = {value!r} is not allowed: it must be the name of a module")
    return str(value)


def exact(what: str, value: Any) -> sp.Expr:
    """A finite real number, exactly: of a floating-point number of any precision the rational number that it is."""
    if isinstance(value, bool) or not isinstance(value, (Real, sp.Number)):
        raise WrongType(f"{what} = {value!r} is not allowed: it must be a number")
    if not math.isfinite(value):
        raise Refused(f"{what} = {value!r} is not allowed: it must be finite")
    return in_rationals(sp.sympify(value))


def in_rationals(value: sp.Expr) -> sp.Expr:
    """An expression with the rational number that each of its floating-point numbers is in their place."""
    return value.xreplace({number: sp.Rational(number) for number in value.atoms(sp.Float)})


def in_decimals(value: sp.Expr) -> sp.Expr:
    """The same to be read, not computed with: long fractions with 17 digits, a double with those that name it."""
    long = (number for number in value.atoms(sp.Rational) if number.q > LONGEST)
    return value.xreplace({number: sp.Float(_named(number), 17) for number in long})


def in_text(value: sp.Expr) -> str:
    """An expression in a message."""
    return str(sp.sstr(in_decimals(value), full_prec=False))


def _named(number: sp.Rational) -> sp.Rational | str:
    near = float(number)
    return repr(near) if number == sp.Rational(near) else number


def reach(value: Any) -> sp.Expr:
    """The largest |u|, infinite where there is none."""
    if value is sp.oo:
        return value
    found = exact("reach", value)
    if not found > 0:
        raise Refused(f"reach = {value!r} is not allowed: it must be > 0")
    return found


def parameters(value: Any) -> Mapping[str, Mapping[str, Any]]:
    """Names with what is said of each, the bounds as exact numbers."""
    allowed = f"names with what is said of each, some of {', '.join((*TEXTS, *BOUNDS))}"
    if not isinstance(value, Mapping):
        raise WrongType(f"parameters = {value!r} is not allowed: it must be a mapping of {allowed}")
    found = {}
    for name, about in value.items():
        text("a parameter's name", name)
        if not isinstance(about, Mapping):
            raise WrongType(f"parameter {name} = {about!r} is not allowed: it must be a mapping of {allowed}")
        for key in about:
            if key not in (*TEXTS, *BOUNDS):
                raise Refused(
                    f"parameter {name}: {key!r} is not allowed: it must be one of {', '.join((*TEXTS, *BOUNDS))}"
                )
        texts = {key: text(f"parameter {name}: {key}", about[key]) for key in TEXTS if key in about}
        bounds = {key: exact(f"parameter {name}: {key}", about[key]) for key in BOUNDS if about.get(key) is not None}
        _leaves_some(name, bounds)
        found[name] = texts | bounds
    return found


def _leaves_some(name: str, bounds: Mapping[str, sp.Expr]) -> None:
    """Raises ValueError for bounds between which there is no number."""
    for low in ("above", "least"):
        for high in ("below", "most"):
            if low not in bounds or high not in bounds:
                continue
            touch = (low, high) == ("least", "most")
            if not (bounds[low] < bounds[high] or (touch and bounds[low] == bounds[high])):
                lowest, highest = in_text(bounds[low]), in_text(bounds[high])
                raise Refused(f"parameter {name}: {low} = {lowest} and {high} = {highest} leave no number between them")


def pieces(value: Any) -> Sequence[tuple[Any, Any]]:
    """Pairs of a force and where it ends."""
    allowed = "a list of pairs (force, where it ends), None for the end of the last"
    if not isinstance(value, (list, tuple)):
        raise WrongType(f"pieces = {value!r} is not allowed: it must be {allowed}")
    if not value:
        raise Refused("pieces is empty: at least one is needed")
    for number, piece in enumerate(value, start=1):
        if not isinstance(piece, (list, tuple)) or len(piece) != 2:
            raise WrongType(f"piece {number} = {piece!r} is not allowed: pieces must be {allowed}")
    return [(force, end) for force, end in value]


def expression(what: str, value: Any) -> sp.Expr:
    """A real SymPy expression, its numbers exact."""
    if isinstance(value, Real) and not isinstance(value, bool):
        return exact(what, value)
    if not isinstance(value, sp.Expr):
        raise WrongType(f"{what} = {value!r} is not allowed: it must be a SymPy expression; strings are never read")
    if value.has(sp.nan, sp.zoo, sp.oo, -sp.oo, sp.I):
        raise Refused(f"{what} = {value} is not allowed: it must be real and finite")
    found = in_rationals(value)
    sizes = [abs(number) for number in found.atoms(sp.Rational) if number != 0]
    if any(not sys.float_info.min <= size <= sys.float_info.max for size in sizes):
        raise Refused(f"{what} is not allowed: it has a number beyond the range of doubles")
    return found
