"""Sentences that carry their numbers: a pattern and values in, out comes a string that can be read in units too.

A pattern is one of `str.format` whose places are named after quantities (`slowflow.answers.table.QUANTITIES`):

    {F_0}          the symbol
    {F_0:g}        a number, or several; in units with their unit
    {F_0 = :g}     both: "F_0 = 0.04", "F = 8 N"
    {F_0=:g}       as an argument of a call, in SI units: "F_0=0.04", "F=8"
    {Omega[0]:g}   one of several numbers
    {why:s}        words, which may be such a string themselves
    {one|other}    the one without units, the other with units

A number without a kind of unit, as a count, is the same in all units.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator, Mapping, Sequence
from string import Formatter
from typing import Any, NamedTuple

#: digits of a number in units: as many as it is written with, at least and at most
FEWEST, MOST = 4, 15
#: of numbers that are written as a user gave them
BRACKETS: Mapping[type, tuple[str, str]] = {tuple: ("(", ")"), list: ("[", "]")}
#: what tells symbols and numbers in units: `slowflow.answers.quantities.Scales`
Units = Any


class _Place(NamedTuple):
    """A place of a pattern, after literal text.

    name   -- of the value, and of the quantity
    joint  -- between symbol and number: " = ", "="; "" where the number stands alone
    spec   -- of the number's format; "s" of words, "" of a symbol
    which  -- of several numbers
    """

    literal: str
    name: str
    joint: str
    spec: str
    which: int | None


def _slots(pattern: str) -> Iterator[_Place]:
    for literal, field, spec, _ in Formatter().parse(pattern):
        if field is None:
            yield _Place(literal, "", "", "", None)
            continue
        name = field.rstrip("= ")
        key, _, which = name.partition("[")
        yield _Place(
            literal, key if which else name, field[len(name) :], spec or "", int(which[:-1]) if which else None
        )


class Sentence:
    """A pattern, read when it is first used; `format` makes a `Text` of it."""

    def __init__(self, pattern: str) -> None:
        self.pattern = pattern

    @functools.cached_property
    def slots(self) -> tuple[_Place, ...]:
        """Its places."""
        return tuple(_slots(self.pattern))

    @functools.cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the values, in the order in which `format` takes them."""
        return tuple(dict.fromkeys(one.name for one in self.slots if one.spec or one.joint))

    def format(self, *values: Any, **named: Any) -> Text:
        """The sentence with values in the order of its places, or by name."""
        if named:
            values += tuple(named[name] for name in self.names[len(values) :])
        return _made(self.render(values, None), self, values)

    def render(self, values: tuple[Any, ...], units: Units | None) -> str:
        """The sentence with these values in these units, or dimensionless."""
        return "".join(self._render(place, values, units) for place in self.slots)

    def _render(self, place: _Place, values: tuple[Any, ...], units: Units | None) -> str:
        literal, name, joint, spec, which = place
        if not name:
            return literal
        one, _, other = name.partition("|")
        if not (spec or joint):
            return literal + (one if units is None else other or units.symbol(name))
        value = values[self.names.index(name)]
        if which is not None:
            value = value[which]
        if spec == "s":
            return literal + in_units(value, units)
        head = "" if not joint else (name if units is None else units.symbol(name)) + joint
        several = isinstance(value, (list, tuple)) or (bool(getattr(value, "ndim", 0)) and spec != "r")
        numbers = [self._number(place, one, units) for one in (value if several else (value,))]
        begin, end = BRACKETS.get(type(value), ("", "")) if spec in ("", "r") else ("", "")
        known = units is not None and joint != "=" and (several or _is_number(value))
        unit = units.unit(name) if units is not None and known else ""
        return f"{literal}{head}{begin}{', '.join(numbers)}{end}{unit and ' ' + unit}"

    def _number(self, place: _Place, value: Any, units: Units | None) -> str:
        """A number, in units with as many digits as it is written with without."""
        if isinstance(value, str) and place.spec != "r":  # a place that stays one
            return value
        written = repr(value) if place.spec == "r" else format(value, place.spec)
        if units is None or not _is_number(value) or not units.unit(place.name):
            return written
        number = units.number(place.name, value, si=place.joint == "=")
        digits = sum(map(str.isdigit, written.partition("e")[0].lstrip("-0.")))
        return number if isinstance(number, str) else f"{number:.{max(FEWEST, min(MOST, digits))}g}"


def _is_number(value: Any) -> bool:
    """Whether it is one, and neither words in its place nor what a user took for one."""
    return hasattr(value, "__float__") and not isinstance(value, bool) and not getattr(value, "ndim", 0)


class Text(str):
    """A sentence about dimensionless numbers that knows them."""

    __slots__ = ("sentence", "values")

    sentence: Sentence
    values: tuple[Any, ...]

    def __reduce__(self) -> tuple[Any, ...]:
        return _remade, (self.sentence.pattern, self.values)

    def __add__(self, other: str) -> str:
        return together("", (self, other)) if other else self

    def __radd__(self, other: str) -> str:
        return together("", (other, self)) if other else self

    def in_units(self, units: Units) -> str:
        """The same sentence with the symbols and numbers of a mount."""
        return self.sentence.render(self.values, units)


def listed(numbers: Mapping[str, Any]) -> str:
    """Numbers as they are given, by name."""
    return together(", ", tuple(text(f"{{{name} = :r}}", value) for name, value in numbers.items()))


#: `Text(...)` without looking for `__init__`, which takes as long again
_blank = str.__new__


def _made(plain: str, sentence: Sentence, values: tuple[Any, ...]) -> Text:
    made = _blank(Text, plain)
    made.sentence, made.values = sentence, values
    return made


@functools.cache
def _sentence(pattern: str) -> Sentence:
    return Sentence(pattern)


def _remade(pattern: str, values: tuple[Any, ...]) -> Text:
    return _sentence(pattern).format(*values)


def text(pattern: str, *values: Any, **named: Any) -> Text:
    """A sentence that is made in one place only, or has no numbers."""
    return _sentence(pattern).format(*values, **named)


def in_units(message: str, units: Units | None) -> str:
    """Words in these units, or dimensionless; as they are where they know no numbers."""
    return message.in_units(units) if units is not None and isinstance(message, Text) else message


@functools.cache
def _row(between: str, size: int) -> Sentence:
    return Sentence(between.join(f"{{_{k}:s}}" for k in range(size)))


def together(between: str, texts: Sequence[str]) -> str:
    """Words one after the other, which know the numbers of each."""
    if len(texts) == 1:
        return texts[0]
    plain = between.join(texts)
    return (
        _made(plain, _row(between, len(texts)), tuple(texts)) if any(isinstance(one, Text) for one in texts) else plain
    )
