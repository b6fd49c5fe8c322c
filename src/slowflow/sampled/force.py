"""The force of a design of stated functions. Takes functions of u with numbers; returns values, averages and bounds.

All is of the pieces' polynomials: sums over the quarter cycle, what ends of pieces add to them, and the bounds by which
no fold is missed. In averages the force goes on as a straight line from the reach on, which no answer is about. Motions
go where they go: for these the function is asked beyond the reach too, and has polynomials there.
"""

from __future__ import annotations

import inspect
import math
import pickle
from array import array
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.polynomial.legendre import leggauss

from slowflow.sampled.polynomial import CELLS, ORDERS, Floats, Smooth
from slowflow.support.backend import loaded
from slowflow.support.errors import Refused, WrongType
from slowflow.support.quadrature import averages
from slowflow.support.record import Law, Mechanism, Parameter
from slowflow_kernels.quadrature_conventions import NODES

#: a function stated for u > 0 and u < 0 is odd within this share of itself
ODD = 1e-9
#: designs whose polynomials are kept
KEPT = 4096

_HALF = leggauss(NODES)
RULE = tuple((float(node), float(weight)) for node, weight in zip(*_HALF, strict=True) if node > 0)


class Force:
    """The force of one design.

    smooth -- its pieces, None for one without extent
    ends   -- where they end: the breakpoints, and the reach
    lost   -- what f, f', f'', f''' lose there; exact zeros where that is rounding
    """

    def __init__(self, stated: Stated, numbers: tuple[float, ...]) -> None:
        self.stated, self.numbers = stated, numbers
        self.doublings: dict[int, Smooth | None] = {}
        self.ends = (*stated.ends_of(numbers), stated.reach)
        begins = (0.0, *self.ends[:-1])
        description = stated.description(numbers)
        if any(not end >= begin for begin, end in pairwise((0.0, *self.ends))):
            where = ", ".join(f"{end:g}" for end in self.ends)
            raise Refused(f"{description}pieces of {stated.name} end at |u| = {where}: must ascend up to the reach")
        self.smooth: list[Smooth | None] = []
        for number, (begin, end) in enumerate(zip(begins, self.ends, strict=True)):
            if not end > begin:
                self.smooth.append(None)
                continue
            if begin == 0:
                stated.check_odd(number, numbers, end)
            name = f"{description}piece {number + 1} of {stated.name}"

            def values(v: Floats, number: int = number, begin: float = begin) -> Floats:
                return stated.values(number, begin + v, numbers)

            from_zero = begin == 0 or self._ends_with_zero()
            self.smooth.append(Smooth(values, end - begin, from_zero, name))
        if self.smooth[-1] is None:
            raise Refused(f"{description}the last piece of {stated.name} begins at its reach, {stated.reach:g}")
        self._join()

    def _ends_with_zero(self) -> bool:
        """Whether there is no force on the piece before."""
        before = next((one for one in reversed(self.smooth) if one is not None), None)
        return before is not None and not np.any(before.of[0])

    def _join(self) -> None:
        """What is lost at each end; what is rounding is none, and then the upper piece begins where the lower ends."""
        self.lost: list[tuple[float, ...]] = []
        below: Smooth | None = None
        for number, above in enumerate((*self.smooth, None)):
            if number > 0:
                self.lost.append((0.0,) * ORDERS)
            if above is None and number < len(self.smooth):
                continue
            if below is not None:
                ended = [float(one) for one in below.at(below.length, range(ORDERS))]
                if above is None:
                    # a straight line follows
                    self.lost[-1] = (0.0, 0.0, *ended[2:])
                else:
                    begun = [float(one) for one in above.at(0.0, range(ORDERS))]
                    lost = [one - other for one, other in zip(ended, begun, strict=True)]
                    for order in range(ORDERS):
                        if abs(lost[order]) <= 8 * (below.doubt(order) + above.doubt(order)):
                            lost[order] = 0.0
                    if lost[0] == 0:
                        above.raise_by(ended[0] - begun[0])
                    self.lost[-1] = tuple(lost)
            below = above
        last = self.smooth[-1]
        assert last is not None
        self.line = tuple(float(one) for one in last.at(last.length, (0, 1)))

    @property
    def description(self) -> str:
        """How many values stand for it, and the largest error that was measured."""
        pieces = [one for one in self.smooth if one is not None]
        points, error = sum(one.points for one in pieces), max(one.error for one in pieces)
        return f"a Python function, interpolated at {points} points with error {error:.1g}; averages are sums"

    @cached_property
    def samples(self) -> tuple[bytes, bytes]:
        """What native/sampled_force.h reads: ints and doubles, as bytes."""
        integers = [len(self.numbers), len(self.ends) - 1, len(RULE)]
        numbers: list[Any] = [np.ravel(RULE)]
        for end, lost, piece in zip(self.ends, self.lost, self.smooth, strict=True):
            integers.append(0 if piece is None else piece.of[0].size)
            if piece is not None:
                integers += [piece.power, CELLS]
                numbers += [[piece.length], *piece.of, piece.edges, *piece.ranges(0), *piece.ranges(ORDERS)]
            numbers += [[end], lost]
        rough = [max(one.rough(order) for one in self.smooth if one is not None) for order in range(ORDERS)]
        return array("i", integers).tobytes(), np.concatenate([*numbers, self.line, rough]).tobytes()

    @cached_property
    def _record(self) -> Any:
        return loaded("slowflow._native").record(True, self.stated.name, *self.samples, False, False)

    def averages(self, A: Any, outputs: int) -> tuple[Any, ...]:
        """h and three derivatives; h_3 and h_5, each with three derivatives, as 8 outputs; or h - A h_A as one.

        Raises ArithmeticError where they do not settle.
        """
        return tuple(averages(self._record, self.numbers, A, outputs))

    def value(self, number: int, u: Any, order: int) -> Any:
        """A piece of the force, or its slope, on both sides of u = 0.

        Of the last one beyond the reach too, where averages have a straight line; NaN where its function is not smooth.
        """
        piece, size = self.smooth[number], np.abs(u)
        if piece is None:
            return 0.0 * size
        side = np.copysign(1.0, u) if order == 0 else np.ones_like(size)
        v, reach, last = size - (0.0, *self.ends)[number], self.ends[-1], number + 1 == len(self.smooth)
        found = np.array(side * piece.at(np.minimum(v, piece.length) if last else v, (order,))[0])
        beyond = last & (size > reach)
        if np.any(beyond):
            found[beyond] = np.nan
            doubled = np.frexp(np.where(beyond & np.isfinite(size), size, 0.5 * reach) / reach)[1] - 1
            for k in np.unique(doubled[doubled >= 0]).tolist():
                here = doubled == k
                if (piece := self._doubling(k)) is not None:
                    found[here] = side[here] * piece.at((size - reach * 2.0**k)[here], (order,))[0]
        return found[()]

    def _doubling(self, k: int) -> Smooth | None:
        """The last piece from 2^k to 2^(k + 1) times the reach; None where its function is not smooth there."""
        if k not in self.doublings:
            number, begin = len(self.smooth) - 1, self.ends[-1] * 2.0**k
            below = self.smooth[-1] if k == 0 else self._doubling(k - 1)
            name = f"{self.stated.description(self.numbers)}piece {number + 1} of {self.stated.name} beyond its reach"
            try:
                found = Smooth(lambda v: self.stated.values(number, begin + v, self.numbers), begin, False, name)
            except Refused:
                below = None
            if below is not None:
                lost = float(below.at(below.length, (0,))[0] - found.at(0.0, (0,))[0])
                if abs(lost) <= 8 * (below.doubt(0) + found.doubt(0)):
                    found.raise_by(lost)
                else:
                    below = None
            self.doublings[k] = None if below is None else found
        return self.doublings[k]


@dataclass(frozen=True)
class Stated:
    """A force as it is stated.

    functions -- of each piece, called with u and the parameters by name
    ends      -- where each but the last ends: a number, or a function of the parameters by name
    names     -- of the parameters
    reach     -- up to which |u| the force is asked for
    """

    name: str
    functions: tuple[Callable[..., Any], ...]
    ends: tuple[Any, ...]
    names: tuple[str, ...]
    reach: float
    _made: dict[tuple[float, ...], Force] = field(default_factory=dict, compare=False, repr=False)

    def __reduce__(self) -> tuple[Any, ...]:
        try:
            pickle.dumps((self.functions, self.ends))
        except Exception as error:
            raise WrongType(
                f"{self.name} cannot be pickled, as its functions cannot: {error}. Those that a module defines can"
            ) from error
        return Stated, (self.name, self.functions, self.ends, self.names, self.reach)

    def force(self, numbers: tuple[float, ...]) -> Force:
        """Of a design."""
        found = self._made.get(numbers)
        if found is None:
            if len(self._made) >= KEPT:
                self._made.clear()
            with np.errstate(all="ignore"):
                found = self._made[numbers] = Force(self, numbers)
        return found

    def description(self, numbers: tuple[float, ...]) -> str:
        """A description of a design, the prefix of messages."""
        text = ", ".join(f"{name} = {value!r}" for name, value in zip(self.names, numbers, strict=True))
        return f"{text}: " if text else ""

    def by_name(self, numbers: tuple[float, ...]) -> dict[str, float]:
        """What functions are called with."""
        return dict(zip(self.names, numbers, strict=True))

    def ends_of(self, numbers: tuple[float, ...]) -> tuple[float, ...]:
        """The breakpoints."""
        found = []
        for number, end in enumerate(self.ends, start=1):
            value = self._call(f"the end of piece {number}", end, (), numbers) if callable(end) else end
            found.append(_real(f"{self.description(numbers)}the end of piece {number} of {self.name}", value))
        return tuple(found)

    def _call(self, what: str, function: Callable[..., Any], at: tuple[Any, ...], numbers: tuple[float, ...]) -> Any:
        try:
            return function(*at, **self.by_name(numbers))
        except Exception as error:
            where = f" at u = {at[0]!r}" if at else ""
            raise Refused(
                f"{self.description(numbers)}{what} of {self.name} raises {type(error).__name__}{where}: {error}"
            ) from error

    def values(self, number: int, u: Floats, numbers: tuple[float, ...]) -> Floats:
        """A piece at displacements (n,): all at once where its function takes arrays, and one by one elsewhere."""
        function, what = self.functions[number], f"piece {number + 1}"
        ends = [float(self._call_one(what, function, float(u[k]), numbers)) for k in (0, -1)]
        try:
            together = np.asarray(function(u.copy(), **self.by_name(numbers)), dtype=float)
        except Exception:
            together = np.empty(0)
        vectorized = together.shape == u.shape and np.allclose(
            together[[0, -1]], ends, rtol=1e-12, atol=0, equal_nan=True
        )
        if not vectorized:
            together = np.array([self._call_one(what, function, float(one), numbers) for one in u])
        bad = ~np.isfinite(together)
        if bad.any():
            where = int(np.argmax(bad))
            raise Refused(
                f"{self.description(numbers)}{what} of {self.name} is {together[where]} at u = {u[where]:.17g}: "
                f"it must be finite up to its end, and up to the reach, {self.reach:g}"
            )
        return together

    def _call_one(self, what: str, function: Callable[..., Any], u: float, numbers: tuple[float, ...]) -> float:
        value = self._call(what, function, (u,), numbers)
        return _real(f"{self.description(numbers)}{what} of {self.name} at u = {u!r}", value, finite=False)

    def check_odd(self, number: int, numbers: tuple[float, ...], end: float) -> None:
        """Raises ValueError for a first piece that is there on both sides of u = 0, and not odd."""
        function = self.functions[number]
        u = np.linspace(0, min(end, self.reach), 6)[1:-1]
        right = self.values(number, u, numbers)
        for one, value in zip(u, right, strict=True):
            try:
                left = float(function(-float(one), **self.by_name(numbers)))
            except Exception:
                return
            if not math.isnan(left) and not abs(left + value) <= ODD * np.abs(right).max():
                raise Refused(
                    f"{self.description(numbers)}piece {number + 1} of {self.name} is {value:.6g} at u = {one:g} "
                    f"and {left:.6g} at u = {-one:g}: it is not odd. In a function a preload is copysign(c, u), "
                    "an even power u abs(u)"
                )


def _real(what: str, value: Any, finite: bool = True) -> float:
    """A real number."""
    try:
        if isinstance(value, (bool, str, bytes)) or np.shape(value) != () or np.iscomplexobj(value):
            raise TypeError
        found = float(value)
    except (TypeError, ValueError):
        raise Refused(f"{what} is {value!r}: it must be a real number") from None
    if finite and not math.isfinite(found):
        raise Refused(f"{what} is {found!r}: it must be finite")
    return found


def check_signature(what: str, function: Callable[..., Any], names: Sequence[str], before: int) -> None:
    """Raises TypeError for a function that cannot be called with the parameters by name."""
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):
        return  # some of C have none
    try:
        signature.bind(*(0.0,) * before, **dict.fromkeys(names, 0.0))
    except TypeError as error:
        called = ", ".join([*("u",) * before, *(f"{name}=..." for name in names)])
        raise WrongType(f"{what} cannot be called as f({called}): {error}") from None


# ---- the record: what it has as functions of arrays of designs is asked of the force of each

REACHED = "averaging does not evaluate the function beyond it"


#: what a force says of a design: tuples of numbers that may be of arrays of designs, and what is of one design only
OF_DESIGNS: dict[str, Callable[[Force], Sequence[float]]] = {
    "coefficients": lambda force: force.numbers,
    "breakpoints": lambda force: force.ends[:-1],
    "jumps": lambda force: [lost[0] for lost in force.lost[:-1]],
    "kinks": lambda force: [one for lost in force.lost[:-1] for one in lost[1:3]],
    "hardening": lambda force: (-1.0,),
}
OF_ONE = {"samples": "samples", "told": "description"}
#: how many outputs averages have; of a piece which derivative it is
AVERAGES = {"averaged": 4, "harmonics": 8, "intercept": 1}
OF_PIECE = {"force": 0, "slope": 1}


@dataclass(frozen=True)
class SampledFunction:
    """One function of the record, by its name in these tables: of a piece by its number, where it is of one."""

    stated: Stated
    what: str
    number: int = 0

    @property
    def __name__(self) -> str:
        return self.what

    def __call__(self, *arguments: Any) -> Any:
        what = self.what
        if what in OF_ONE:
            return getattr(self.stated.force(tuple(map(float, arguments))), OF_ONE[what])
        if what in OF_DESIGNS:
            return self._by_design(arguments, of=OF_DESIGNS[what])
        first, *numbers = arguments
        if what in AVERAGES:
            found = self._by_design(numbers, first, of=lambda force, A: force.averages(A, AVERAGES[what]))
            return found if what != "intercept" else found[0]
        order = OF_PIECE[what]
        return self._by_design(numbers, first, of=lambda force, u: (force.value(self.number, u, order),))[0]

    def _by_design(self, numbers: Sequence[Any], *extra: Any, of: Callable[..., Sequence[Any]]) -> tuple[Any, ...]:
        """What is of one design, of arrays of them: each once."""
        if all(np.ndim(one) == 0 for one in numbers):
            return tuple(of(self.stated.force(tuple(map(float, numbers))), *extra))
        *arrays, shaped = np.broadcast_arrays(*numbers, *(extra or (0.0,)))
        arrays.append(shaped)
        rows = np.stack([np.asarray(one, dtype=float).ravel() for one in arrays[: len(numbers)]], axis=-1)
        others = [np.asarray(one, dtype=float).ravel() for one in arrays[len(numbers) :]]
        designs, of_row = np.unique(rows, axis=0, return_inverse=True)
        found: list[Floats] = []
        for k, design in enumerate(designs):
            here = of_row.ravel() == k
            values = of(self.stated.force(tuple(design.tolist())), *((one[here] for one in others) if extra else ()))
            if not found:
                found = [np.empty(len(rows)) for _ in values]
            for whole, value in zip(found, values, strict=True):
                whole[here] = value
        return tuple(one.reshape(arrays[0].shape) for one in found)


def record(stated: Stated, title: str, design: tuple[Parameter, ...], reach_reason: str) -> Mechanism:
    """The record of a mechanism whose force is stated by functions."""
    functions: dict[str, Any] = {name: SampledFunction(stated, name) for name in (*OF_DESIGNS, *OF_ONE, *AVERAGES)}
    return Mechanism(
        **functions,
        name=stated.name,
        title=title,
        design=design,
        parameters=design,
        pieces=tuple(
            Law(SampledFunction(stated, "force", k), SampledFunction(stated, "slope", k))
            for k in range(len(stated.functions))
        ),
        harmonics_up_to=math.inf,
        reach=stated.reach,
        reach_reason=reach_reason or REACHED,
        truncated=False,
        load_untruncated=None,
        enclosed=(),
    )
