"""What a force has beside its steps, r = f - steps, where that is no polynomial, for native/curved.h.

In:  the pieces of the force as `Curved` of a record has them.
Out: `Curved`: means <r^(n)> and <r^(n) cos psi> along u = B + A cos psi; `packed`, from which boxes are enclosed.

Each piece is called once, with a number that records what is done with it: that is its formula as a straight line,
which C evaluates at numbers and on intervals.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from slowflow.core.backend import SOLVER
from slowflow.core.model import Floats
from slowflow.support.errors import Refused
from slowflow.support.quadrature import gauss
from slowflow_kernels.program_conventions import MOST_REGISTERS, Operation

#: nodes of Gauss's rule on each panel, and panels of the angle on boxes, as native/curved.h has them: an even number,
#: for the cosine has one sign on each
NODES, PANELS = 16, 40
#: operations that NumPy calls otherwise, besides arc...
NUMPY = {"subtract": "SUB", "multiply": "MUL", "divide": "DIV", "negative": "NEG", "absolute": "ABS", "fabs": "ABS"}
#: powers of half-integers up to this one are products with a root
MOST_HALVES = 16
TOO_LONG = "offset motions are not derived for a force with a piece of more than {} operations"
UNKNOWN = "offset motions are not derived for a force with the function {}"

#: ends of segments on which a force is enclosed once and for all
_OCTAVES = 2.0 ** np.arange(-4, 20.25, 0.25)
_EDGES_OF_U = np.concatenate((-_OCTAVES[::-1], [0.0], _OCTAVES))
_AT, _WEIGHTS = gauss(NODES)
_FRACTIONS = np.linspace(0.0, 1.0, PANELS + 1)
#: dense where a motion turns, about which a stiff force acts
_EDGES = np.pi * _FRACTIONS**2 * (3 - 2 * _FRACTIONS)
_INSIDE = _EDGES[:-1, np.newaxis] + _AT * np.diff(_EDGES)[:, np.newaxis]
#: cosine at the edges of the panels
_COSINE = np.cos(_EDGES)
_COSINE[PANELS // 2] = 0.0


def _weights(weight: Callable[[Floats], Floats]) -> Floats:
    """The mean over each panel of a function of the cosine, over the half cycle, which has one sign on each."""
    return np.asarray(weight(np.cos(_INSIDE)) @ _WEIGHTS * np.diff(_EDGES) / np.pi)


#: of moments with (1 + cos)^i (1 - cos)^j, with cos, and with cos (1 +- cos), ordered as from `SF_WEIGHT_30` on
_ENDS = [(order - j, j) for order in (3, 2, 1, 0) for j in range(order + 1)]
_BY_PANEL = [_weights(lambda c, i=i, j=j: (1 + c) ** i * (1 - c) ** j) for i, j in _ENDS]  # type: ignore[misc]
_BY_PANEL += [_weights(lambda c: c), _weights(lambda c: c * (1 + c)), _weights(lambda c: c * (1 - c))]
_TABLES = np.concatenate([_AT, _WEIGHTS, _COSINE, *_BY_PANEL])


class Line:
    """A straight line of operations on `u` in the making: of doubles, or `on` intervals."""

    def __init__(self, *, on: bool) -> None:
        self.on, self.u = on, Traced(self)
        self._constants: dict[tuple[float, float], Traced] = {}
        self._done: dict[tuple[Operation, Traced, Traced], Traced] = {}

    def point(self, number: Any, error: float = 0.0) -> Any:
        """A double, or what is known to a relative error; or what is recorded already."""
        if isinstance(number, Traced):
            return number
        ends = float(number) - abs(number) * error, float(number) + abs(number) * error
        return self._constants.setdefault(ends, Traced(self, float(number)))

    def around(self, number: float) -> Any:
        """A number that no double is equal to."""
        return self.point(number, 2.0**-52)

    def do(self, name: str, one: Any, *others: Any) -> Any:
        """An operation on one or two numbers."""
        taken = [self.point(one), *map(self.point, others)]
        if name not in Operation.__members__:
            raise Refused(UNKNOWN.format(name.lower()))
        return self._done.setdefault((Operation[name], taken[0], taken[-1]), Traced(self))

    def of(self, outputs: Sequence[Any]) -> tuple[list[int], list[float]]:
        """Words and numbers as native/straight.h reads them; registers hold u, the constants, and what is computed."""
        found = list(map(self.point, outputs))
        values = (self.u, *self._constants.values(), *self._done.values())
        register = {one: k for k, one in enumerate(values)}
        if len(register) > MOST_REGISTERS:
            raise Refused(TOO_LONG.format(MOST_REGISTERS))
        integers = [1, len(self._constants), len(register), len(self._done), len(found)]
        for (operation, *taken), one in self._done.items():
            integers += [operation, *(register[value] for value in (one, *taken))]
        return integers + [register[one] for one in found], [end for ends in self._constants for end in ends]


class Traced:
    """A number that records what is done with it, by Python's operators, NumPy's functions or `Elementary`'s.

    number -- that of a constant, None of others
    """

    __slots__ = ("line", "number")

    def __init__(self, line: Line, number: float | None = None) -> None:
        self.line, self.number = line, number

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *others: self.line.do(name.upper(), self, *others)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any) -> Any:
        name = NUMPY.get(ufunc.__name__, ufunc.__name__.replace("arc", "a").upper())
        return self.line.point(inputs[0]).power(inputs[1]) if name == "POWER" else self.line.do(name, *inputs)

    def power(self, exponent: Any) -> Any:
        """A power of what is not negative; of half an odd number a product with the root, which takes less time."""
        halves = 2 * (self.line.point(exponent).number or 0.0)
        if halves % 2 != 1 or abs(halves) > MOST_HALVES:
            return self.line.do("POWER", self, exponent)
        found = self.root() if self.line.on else self.sqrt()
        for _ in range(int(abs(halves)) // 2):
            found = found * self
        return found if halves > 0 else 1.0 / found

    def __neg__(self) -> Any:
        return self.line.do("NEG", self)

    def __add__(self, other: Any) -> Any:
        return self.line.do("ADD", self, other)

    def __sub__(self, other: Any) -> Any:
        return self.line.do("SUB", self, other)

    def __rsub__(self, other: Any) -> Any:
        return self.line.do("SUB", other, self)

    def __mul__(self, other: Any) -> Any:
        return self.line.do("MUL", self, other)

    def __truediv__(self, other: Any) -> Any:
        return self.line.do("DIV", self, other)

    def __rtruediv__(self, other: Any) -> Any:
        return self.inverse() * other if self.line.on else self.line.do("DIV", other, self)

    __radd__, __rmul__ = __add__, __mul__


@dataclass(frozen=True)
class Formula:
    """A smooth force of u.

    law, enclosed -- it and derivatives of u; it to its third derivative of what makes intervals of numbers, and of u
    """

    law: Callable[[Any], Any]
    enclosed: Callable[[Any, Any], Any] | None = None

    @cached_property
    def lines(self) -> list[tuple[list[int], list[float]]]:
        """Straight lines of both, of doubles and on intervals."""
        numbers, intervals = Line(on=False), Line(on=True)
        found = [numbers.of(self.law(numbers.u))]
        return found if self.enclosed is None else [*found, intervals.of(self.enclosed(intervals, intervals.u))]


class Part(NamedTuple):
    """A piece of the force with its numbers.

    mirrored -- whether it is -f(-u) of its formula
    line     -- what the steps are on it: a + b u
    """

    formula: Formula
    mirrored: bool
    line: tuple[float, float]

    def between(self, low: Any, high: Any) -> Floats:
        """Between which f and three derivatives are from one u to another, (n, 4, 2)."""
        return Curved((self._replace(line=(0.0, 0.0)),), np.empty(0), np.empty(0)).between(low, high).reshape(-1, 4, 2)


class Curved:
    """What one force has beside its steps.

    parts  -- of the force by rising u
    ends   -- where each but the last ends
    bends  -- what f'' gains there
    walls  -- the u that no motion passes, below and above: beyond them nothing is known
    orders -- how many of f and its derivatives the parts have
    """

    def __init__(
        self,
        pieces: Sequence[Part],
        ends: Floats,
        bends: Floats,
        walls: tuple[float, float] = (-np.inf, np.inf),
        orders: int = 4,
    ) -> None:
        self.pieces, self.ends, self.bends, self.walls, self.orders = tuple(pieces), ends, bends, walls, orders

    def within(self, low: Any, high: Any) -> Curved:
        """The pieces alone that one motion passes, the outermost as if they held everywhere beyond."""
        first, last = np.searchsorted(self.ends, np.ravel([low, high])).tolist()
        own = self.pieces[first : last + 1]
        return Curved(own, self.ends[first:last], self.bends[first:last], orders=self.orders)

    @cached_property
    def packed(self) -> Floats:
        """What native/curved.h reads; where intervals are known with what they are on narrow segments of u."""
        edges = np.unique([*_EDGES_OF_U, *self.ends])
        is_enclosed = all(piece.formula.enclosed for piece in self.pieces)
        if not is_enclosed:
            return self._with_segments()
        return self._with_segments(edges, self.between(edges[:-1], edges[1:]) * np.tile((-1.0, 1.0), self.orders))

    def between(self, low: Any, high: Any) -> Floats:
        """Between which r and three derivatives are from one u to another, (n, 8)."""
        return np.asarray(SOLVER.curved_between(self._with_segments(), low, high))

    def _with_segments(self, edges: Floats = _EDGES_OF_U[:1], segments: Floats = _EDGES_OF_U[:0]) -> Floats:
        lines = [line for piece in self.pieces for line in piece.formula.lines]
        integers, numbers = ([one for line in lines for one in line[k]] for k in (0, 1))
        sizes = len(self.pieces), self.orders, len(lines) > len(self.pieces), len(integers), len(edges) - 1
        steps = [(*piece.line, piece.mirrored) for piece in self.pieces]
        rows = (sizes, edges, segments, self.ends, self.bends, self.walls, steps, _TABLES, integers, numbers)
        return np.concatenate([np.ravel(row) for row in rows]).astype(float)

    def at(self, A: Floats, B: Floats, orders: int) -> tuple[list[Floats], list[Floats]]:
        """c_n and s_n for n up to `orders`, at most 3, of which the last are as near as sums of the others require."""
        found = SOLVER.curved_means(self.packed, A, B, orders)
        return list(found[:, : orders + 1].T), list(found[:, 4 : 5 + orders].T)
