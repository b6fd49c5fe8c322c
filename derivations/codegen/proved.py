"""Proved bounds of rounding errors, as data. Takes a program; returns k of each output if it is proved.

They are found by `rounding`, which takes longer than printing a kernel. Each is stored under the digest of the program
that it holds for: a program that changes has none until it is proved anew.
"""

from __future__ import annotations

import functools
import hashlib
import json
from pathlib import Path

import sympy as sp

from .passes import Program

DATA = Path(__file__).with_name("proved.json")


@functools.cache
def digest(program: Program, arguments: tuple[sp.Symbol, ...]) -> str:
    """Of what is computed, in which order."""
    lets = ((symbol, _text(value)) for symbol, value in program.lets)
    content = (arguments, *lets, *map(_text, program.outputs))
    return hashlib.sha256(repr(content).encode()).hexdigest()[:16]


@functools.cache
def _text(expression: sp.Basic) -> str:
    """An expression as it is built: SymPy's own text sorts terms, which takes longer than deriving them."""
    if not expression.args:
        return str(expression)
    return f"{expression.func.__name__}({','.join(map(_text, expression.args))})"


@functools.cache
def stored() -> dict[str, dict[str, object]]:
    """All that is proved, by digest: the kernel's name, and k of each output or None."""
    return json.loads(DATA.read_text(encoding="utf-8"))


def in_words(program: Program, arguments: tuple[sp.Symbol, ...]) -> str:
    """k of each output, `-` where it is not proved; "" where none is."""
    found = stored().get(digest(program, arguments))
    return "" if found is None else ", ".join("-" if k is None else k for k in found["k"])


def write(found: dict[str, dict[str, object]]) -> None:
    """One line each."""
    lines = [f' "{key}": {json.dumps(value)}' for key, value in sorted(found.items(), key=lambda one: one[1]["kernel"])]
    DATA.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
