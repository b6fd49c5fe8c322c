"""What is proved on the way: `claim` proves a statement and keeps it, or says which equation fails, and by what.

In:  a sentence, both sides of what it states, the equation's number.
Out: `PROVED`, every statement that was proved, by the module that states it; `page`, the same to read.
"""

from __future__ import annotations

import inspect

import sympy as sp
from sympy.logic.boolalg import BooleanAtom

from .vanishing import vanishes

#: sentences with the numbers of their equations, by module, in the order in which they were proved
PROVED: dict[str, dict[str, str]] = {}


class Unproved(ArithmeticError):
    """A step of the derivation does not hold."""


def claim(sentence: str, left: sp.Expr | bool | BooleanAtom, right: sp.Expr = sp.S.Zero, *, eq: str = "") -> None:
    """Prove that both sides are one, or that a condition holds, and keep the sentence.

    Raises `Unproved` with the equation's number, both sides and their difference.
    """
    if isinstance(left, bool | BooleanAtom):
        if not left:
            raise Unproved(f"{eq or 'beside the paper'}: not shown: {sentence}")
    elif not vanishes(left - right):
        raise Unproved(
            f"{eq or 'beside the paper'}: not shown: {sentence}\n    left       {left}\n    right      {right}\n"
            f"    difference {sp.simplify(left - right)}"
        )
    frame = inspect.currentframe()
    assert frame is not None and frame.f_back is not None
    module = frame.f_back.f_globals["__name__"].partition(".")[2]
    PROVED.setdefault(module, {})[sentence] = eq


def page() -> str:
    """What has been proved so far, as Markdown."""
    lines = [
        "# Identities proved in the derivation",
        "",
        "The derivation proves each statement exactly; if a proof fails, it stops with an error.",
        "",
    ]
    for module, sentences in PROVED.items():
        lines += [f"## {module}", ""]
        lines += [f"- {f'{eq}: ' if eq else ''}{sentence}" for sentence, eq in sentences.items()]
        lines.append("")
    return "\n".join(lines)
