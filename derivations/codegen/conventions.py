"""What the solvers of every language have in common and no formula gives: how an answer fared, and where methods stop.

In:  decisions, stated in conventions.toml.
Out: `CONVENTIONS`: tables of words by number, and numbers of the methods, for averaged and for exact motions.
"""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import sympy as sp

from ..forces.quadrature import DENSE, NODES
from ..systems.gradients import KINDS, SYSTEMS


@dataclass(frozen=True)
class Word:
    """A name for the number that is its place in a table, and what it means, in one line."""

    name: str
    doc: str


@dataclass(frozen=True)
class Table:
    """Words by number.

    name   -- of the type in Python and in C
    doc    -- one line
    entries -- from number 0 on
    suffix -- to a word's name in C, where it would be another table's too
    """

    name: tuple[str, str]
    doc: str
    entries: tuple[Word, ...]
    suffix: str = ""


@dataclass(frozen=True)
class Number:
    """A name for a number, exact, an `int` where it counts; and what it is, in one line.

    C_alone -- whether C alone asks for it: Python does not have it
    """

    name: str
    value: sp.Rational | int
    doc: str
    C_alone: bool = False


@dataclass(frozen=True)
class Rows:
    """A name for rows of small integers, and what they are."""

    name: str
    values: tuple[tuple[int, ...], ...]
    doc: str


@dataclass(frozen=True)
class Conventions:
    """Tables and numbers of one file in each language."""

    name: str
    title: str
    tables: tuple[Table, ...]
    numbers: tuple[Number, ...]
    rows: tuple[Rows, ...] = ()


#: kinds of answers, whose conditions `gradients` states
_KINDS = {name.upper(): doc for name, (_, doc) in KINDS.items()}
#: numbers and rows that are stated where they are made use of first
_ELSEWHERE = {"NODES": NODES, "DENSE": DENSE, "SYSTEMS": SYSTEMS}


def _value(stated: str | int) -> Any:
    """A number that counts, or an exact one: a ratio, decimals or a power, unless it is stated elsewhere."""
    if isinstance(stated, int):
        return stated
    if stated in _ELSEWHERE:
        return _ELSEWHERE[stated]
    base, _, exponent = stated.partition("^")
    return sp.Rational(base) ** sp.Integer(exponent or 1)


def _conventions(name: str, stated: dict[str, Any]) -> Conventions:
    """One file of them."""
    tables = tuple(
        Table(
            (table, of["in_c"]),
            of["doc"],
            tuple(Word(*word) for word in of.get("words", _KINDS).items()),
            of.get("suffix", ""),
        )
        for table, of in stated.get("tables", {}).items()
    )
    numbers = tuple(
        Number(number, _value(value), doc, bool(of)) for number, (value, doc, *of) in stated["numbers"].items()
    )
    rows = tuple(Rows(of, _value(value), doc) for of, (value, doc) in stated.get("rows", {}).items())
    return Conventions(name, stated["title"], tables, numbers, rows)


CONVENTIONS = tuple(
    _conventions(name, stated)
    for name, stated in tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8")).items()
)
_BY_NAME = {one.name: one for one in CONVENTIONS}


def _number(of: str, name: str) -> Any:
    return next(number.value for number in _BY_NAME[of].numbers if number.name == name)


#: what programs do, and the form of the data that they are
OPERATION = _BY_NAME["program_conventions"].tables[0]
PROGRAM_FORM = _number("program_conventions", "PROGRAM_FORM")
#: of a force whose coefficients are printed, at most
FORCE_DEGREE = _number("exact_conventions", "FORCE_DEGREE")
