"""Stretches of an algorithm that it goes through many times: stated once, and printed once, as a function.

In:  arguments, lets and outputs, as of a kernel.
Out: `Repeated`; `at` gives lets that stand for its outputs at other arguments, or after so many turns from these.

An output at given arguments is a SymPy function of them, `Output`: nothing has to know of it but what prints it.
"""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

Let = tuple[sp.Symbol, sp.Expr]

#: the last argument of a loop: how often it is gone through
TURNS = sp.Symbol("turns", integer=True, positive=True)


class Output(sp.Function):
    """One of the outputs of a `Repeated`, at arguments that are symbols or numbers."""

    repeated: Repeated
    number: int


@dataclass(frozen=True)
class Repeated:
    """Lets and outputs in some arguments. A loop takes `TURNS`; its outputs are the first arguments of the next turn.

    name    -- of the function
    doc     -- what it gives
    outputs -- expressions in the arguments and the lets, each by its name
    straight -- whether the lets are straight-line code already
    """

    name: str
    doc: str
    arguments: tuple[sp.Symbol, ...]
    lets: tuple[Let, ...]
    outputs: tuple[Let, ...]
    straight: bool = False

    def __post_init__(self) -> None:
        names = [symbol.name for symbol in (*self.arguments, *(symbol for symbol, _ in (*self.lets, *self.outputs)))]
        if len(set(names)) < len(names):
            raise ArithmeticError(f"{self.name} has two things of one name: {sorted(names)}")

    @property
    def state(self) -> tuple[sp.Symbol, ...]:
        """The arguments that go on from turn to turn."""
        return self.arguments[: len(self.outputs)] if TURNS in self.arguments else ()

    def at(self, values: Sequence[sp.Expr], names: Sequence[sp.Symbol]) -> list[Let]:
        """The outputs by these names, at arguments in their order."""
        if len(values) != len(self.arguments) or not all(value.is_Symbol or value.is_number for value in values):
            raise ArithmeticError(f"{self.name} takes {len(self.arguments)} symbols or numbers, not {values}")
        return [(name, _output(self, k)(*values)) for k, (name, _) in enumerate(zip(names, self.outputs, strict=True))]


@functools.cache
def _output(repeated: Repeated, number: int) -> type[Output]:
    name = f"{repeated.name}_{repeated.outputs[number][0]}"
    return type(name, (Output,), {"repeated": repeated, "number": number})
