"""Forces that are Python functions: in go functions of u, out comes a mechanism's record, with averages by quadrature.

Such a function has no derivatives, and nothing encloses it. On each of its pieces it is replaced by the polynomial
through its values at Chebyshev's points, as many as it takes; that has derivatives, bounds, and an error that is
measured. All else is of this polynomial: sums over the quarter cycle, what ends of pieces add to them, and the bounds
by which no fold is missed. From the reach on the force goes on as a straight line, which no answer is about.
"""

from __future__ import annotations

import inspect
import math
import pickle
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.polynomial import chebyshev
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray
from scipy.fft import dct

from slowflow_kernels import sampled, sampled_intervals
from slowflow_kernels.quadrature_conventions import DENSE, NODES
from slowflow_support.quadrature import over_quarter
from slowflow_support.record import Enclosed, Law, Mechanism, Parameter

Floats = NDArray[np.float64]

#: points of the first look, and of the last
FEWEST, MOST = 16, 1024
#: what the last eighth of the coefficients is of the largest where a function is known to rounding, and at most
ROUNDED, RESOLVED = 2.0**-51, 2.0**-44
#: points at which the error is measured
CHECKED = 500
#: parts of a piece on which its values are bounded
CELLS = 256
#: derivatives that are asked for
ORDERS = 4
#: what a breakpoint adds, by the lowest order of what is lost there
BENT_ENDS = (
    sampled_intervals.bent_end_0,
    sampled_intervals.bent_end_1,
    sampled_intervals.bent_end_2,
    sampled_intervals.bent_end_3,
)
#: a function stated for u > 0 and u < 0 is odd within this share of itself
ODD = 1e-9
#: designs whose polynomials are kept
KEPT = 4096

REACHED = "the function is not asked for what lies beyond"
_HALF = leggauss(NODES)
RULE = tuple((float(node), float(weight)) for node, weight in zip(*_HALF, strict=True) if node > 0)


class Smooth:
    """One piece as a polynomial in v, what u exceeds its begin by, from 0 to its length.

    Where it begins with 0, as at rest, it is a polynomial times a power of v, which keeps its digits there.

    power  -- that of v
    points -- how many values it goes through
    noise  -- what its coefficients are in doubt by
    error  -- the largest that was measured between these points, of the largest force
    """

    points: int
    noise: float
    of: list[Any]

    def __init__(self, values: Callable[[Floats], Floats], length: float, from_zero: bool, told: str) -> None:
        self.length, self.power = length, 0
        coefficients = self._through(values, told)
        while from_zero and self.power < ORDERS and np.any(coefficients):
            start = float(chebyshev.chebval(-1.0, coefficients))
            if abs(start) > max(RESOLVED * np.abs(coefficients).max(), self._doubt(coefficients, 0)):
                break
            kept = self.points, self.noise
            try:
                coefficients = self._through(lambda v: values(v) / v ** (self.power + 1), told)
            except ValueError:
                self.points, self.noise = kept
                break
            self.power += 1
        self.of = [coefficients]
        for _ in range(ORDERS):
            self.of.append(chebyshev.chebder(self.of[-1], scl=2 / length))
        v = np.concatenate((self._places(CHECKED), length * np.linspace(0, 1, CHECKED + 2)[1:-1]))
        given = values(v)
        size = float(np.abs(given).max(initial=0.0))
        self.error = float(np.abs(given - self.at(v, (0,))[0]).max()) / size if size > 0 else 0.0
        if self.error > math.sqrt(RESOLVED):
            raise ValueError(f"{told} is not the polynomial through {self.points} of its values: {_LEFT}")

    def _places(self, count: int) -> Floats:
        return np.asarray(0.5 * self.length * (1 - np.cos(np.pi * (np.arange(count) + 0.5) / count)))

    def _through(self, values: Callable[[Floats], Floats], told: str) -> Floats:
        """Coefficients of Chebyshev's polynomials; what is left out is rounding."""
        found, count = None, FEWEST
        while count <= MOST:
            # by rising v: the polynomials' signs alternate
            coefficients = dct(values(self._places(count)), type=2) / count
            coefficients[0] *= 0.5
            coefficients *= (-1.0) ** np.arange(count)
            tail, size = np.abs(coefficients[-(count // 8) :]).max(), np.abs(coefficients).max()
            if found is None and tail <= RESOLVED * size:
                found = coefficients, tail, count
            if tail <= ROUNDED * size:
                found = coefficients, tail, count
                break
            count *= 2
        if found is None:
            raise ValueError(f"{told}: {MOST} of its values leave {tail / size:.1g} of it open: {_LEFT}")
        coefficients, tail, self.points = found
        self.noise = float(max(tail, 2.0**-53 * np.abs(coefficients).max()))
        kept = np.flatnonzero(np.abs(coefficients) > self.noise)
        return np.asarray(coefficients[: kept[-1] + 1 if kept.size else 1])

    def _doubt(self, coefficients: Floats, order: int) -> float:
        """What noise in the coefficients makes of a derivative where the piece begins or ends, at most."""
        k = np.arange(coefficients.size, dtype=float)
        steep = np.ones_like(k)
        for j in range(order):
            steep *= (k * k - j * j) / (2 * j + 1)
        return float(self.noise * np.abs(steep).sum() * (2 / self.length) ** order)

    def _bound(self, order: int, known: Callable[[int], float]) -> float:
        """Of a derivative, from those of the polynomial beside the power of v."""
        return math.fsum(factor * self.length**power * known(k) for factor, power, k in self._terms(order))

    def _terms(self, order: int) -> list[tuple[int, int, int]]:
        """A derivative of v^m q as a sum: factor, power of v, which derivative of q; by Leibniz's rule."""
        lowered = range(min(order, self.power) + 1)
        return [(math.comb(order, j) * math.perm(self.power, j), self.power - j, order - j) for j in lowered]

    def doubt(self, order: int) -> float:
        """The same of the force."""
        return self._bound(order, lambda k: self._doubt(self.of[0], k))

    def rough(self, order: int) -> float:
        """By what rounding makes a derivative wrong, at most."""
        return float((4 + self.of[0].size) * 2.0**-52 * self.size(order))

    def size(self, order: int) -> float:
        """What a derivative does not exceed."""
        return self._bound(order, lambda k: float(np.abs(self.of[k]).sum()))

    def raise_by(self, amount: float) -> None:
        """Adds a constant."""
        self.of[0] = self.of[0].copy()
        self.of[0][0] += amount

    def at(self, v: Any, orders: Sequence[int]) -> list[Any]:
        """The force and its derivatives, those of these orders."""
        x = 2 * np.asarray(v) / self.length - 1
        terms = [self._terms(order) for order in orders]
        of = {k: chebyshev.chebval(x, self.of[k]) for k in {k for some in terms for _, _, k in some}}
        return [sum(factor * v**power * of[k] for factor, power, k in some) for some in terms]

    @cached_property
    def ranges(self) -> tuple[_Ranges, _Ranges]:
        """Of the force, and of its fourth derivative."""
        return _Ranges(self, 0), _Ranges(self, ORDERS)


_LEFT = "what is not smooth at some |u| ends a piece there, and a power that is no whole number is stated as a formula"


class _Ranges:
    """What a polynomial is on intervals, by what it is on parts, dense where the piece begins."""

    def __init__(self, piece: Smooth, order: int) -> None:
        edges = piece.length * (np.arange(CELLS + 1) / CELLS) ** 2
        self.edges = edges
        # on a part it is the polynomial through so many of its values, whose coefficients bound it
        count = piece.of[0].size + piece.power
        places = 0.5 * (1 - np.cos(np.pi * (np.arange(count) + 0.5) / count))
        (values,) = piece.at(edges[:-1, np.newaxis] + np.diff(edges)[:, np.newaxis] * places, (order,))
        coefficients = dct(np.broadcast_to(values, (CELLS, count)), type=2, axis=1) / count
        middle, beside = 0.5 * coefficients[:, 0], np.abs(coefficients[:, 1:]).sum(axis=1)
        beside += 4 * count * 2.0**-52 * piece.size(order)
        # of 2^k parts from each on
        self.least, self.most = [middle - beside], [middle + beside]
        while self.least[-1].size > 1:
            step = 2 ** (len(self.least) - 1)
            self.least.append(np.minimum(self.least[-1][:-step], self.least[-1][step:]))
            self.most.append(np.maximum(self.most[-1][:-step], self.most[-1][step:]))

    def on(self, low: Floats, high: Floats) -> Floats:
        """Ends (2, n) of what it is from low to high."""
        first = np.clip(np.searchsorted(self.edges, low, side="right") - 1, 0, CELLS - 1)
        last = np.clip(np.searchsorted(self.edges, high, side="left") - 1, first, CELLS - 1)
        level = np.frexp(last - first + 1)[1] - 1
        found = np.empty((2, low.size))
        for k in np.unique(level):
            here = level == k
            a, b = first[here], last[here] + 1 - 2**k
            found[0, here] = np.minimum(self.least[k][a], self.least[k][b])
            found[1, here] = np.maximum(self.most[k][a], self.most[k][b])
        return found


class Force:
    """The force of one design.

    smooth -- its pieces, None for one without extent
    ends   -- where they end: the breakpoints, and the reach
    lost   -- what f, f', f'', f''' lose there; exact zeros where that is rounding
    """

    def __init__(self, stated: Stated, numbers: tuple[float, ...]) -> None:
        self.numbers = numbers
        self.ends = (*stated.ends_of(numbers), stated.reach)
        begins = (0.0, *self.ends[:-1])
        given = stated.given(numbers)
        if any(not end >= begin for begin, end in pairwise((0.0, *self.ends))):
            where = ", ".join(f"{end:g}" for end in self.ends)
            raise ValueError(f"{given}pieces of {stated.name} end at |u| = {where}: these must rise up to the reach")
        self.smooth: list[Smooth | None] = []
        for number, (begin, end) in enumerate(zip(begins, self.ends, strict=True)):
            if not end > begin:
                self.smooth.append(None)
                continue
            if begin == 0:
                stated.check_odd(number, numbers, end)
            told = f"{given}piece {number + 1} of {stated.name}"

            def values(v: Floats, number: int = number, begin: float = begin) -> Floats:
                return stated.values(number, begin + v, numbers)

            from_zero = begin == 0 or self._ends_with_zero()
            self.smooth.append(Smooth(values, end - begin, from_zero, told))
        if self.smooth[-1] is None:
            raise ValueError(f"{given}the last piece of {stated.name} begins at its reach, {stated.reach:g}")
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

    @cached_property
    def error(self) -> float:
        """The largest error that was measured."""
        return max(one.error for one in self.smooth if one is not None)

    @cached_property
    def points(self) -> int:
        """How many values stand for it."""
        return sum(one.points for one in self.smooth if one is not None)

    def beyond(self, v: Any, orders: Sequence[int]) -> list[Any]:
        """The straight line from the reach on, and its derivatives of these orders."""
        value, slope = self.line
        all_orders = [value + slope * v, np.full_like(v, slope), np.zeros_like(v), np.zeros_like(v)]
        return [all_orders[order] for order in orders]

    def summed(
        self, A: Any, of_pieces: Callable[..., Any], of_end: Callable[..., Any], orders: Sequence[int]
    ) -> tuple[Any, ...]:
        """Integrals over the quarter cycle, and what ends that are passed add.

        of_pieces -- at sine, cosine and those derivatives of the force that are wanted
        of_end    -- at amplitudes beyond an end, that end, and what is lost there
        orders    -- which derivative stands under each integral
        """
        wanted = sorted(set(orders))
        rough = [max(one.rough(k) for one in self.smooth if one is not None) for k in orders]
        A = np.asarray(A, dtype=float)

        def terms(of: Callable[[Any, Sequence[int]], list[Any]]) -> Callable[..., Any]:
            return lambda beyond, sine, cosine: of_pieces(sine, cosine, *of(beyond, wanted))

        def nothing(beyond: Any, orders: Sequence[int]) -> list[Any]:
            return [np.zeros_like(beyond)] * len(orders)

        pieces = [terms(nothing if one is None else one.at) for one in self.smooth]
        pieces.append(terms(self.beyond))

        def closing(A: Floats, *sums: Any) -> list[Any]:
            total = [np.array(one) for one in sums]
            for end, lost in zip(self.ends, self.lost, strict=True):
                passed = A > end
                if end > 0 and passed.any():
                    for one, more in zip(total, of_end(A[passed], end, lost), strict=True):
                        one[passed] += more
            return total

        graded = (DENSE,) * len(pieces)
        flat = over_quarter(A.ravel(), (), lambda: self.ends, pieces, closing, len(orders), graded, RULE, (), rough)
        return tuple(one.reshape(A.shape)[()] for one in flat)

    def averaged(self, A: Any) -> Any:
        """h and three derivatives."""
        return self.summed(
            A,
            lambda sine, cosine, *f: sampled.averaged_terms(sine, *f),
            lambda A, end, lost: (0.0, *sampled.averaged_end(A, end, *lost[:3])),
            range(4),
        )

    def harmonics(self, A: Any) -> Any:
        """h_3 and h_5, each with three derivatives."""

        def of_end(A: Floats, end: float, lost: tuple[float, ...]) -> Any:
            found = sampled.harmonics_end(A, end, *lost[:3])
            return (0.0, *found[:3], 0.0, *found[3:])

        return self.summed(
            A, lambda sine, cosine, *f: sampled.harmonics_terms(sine, *f), of_end, (*range(4), *range(4))
        )

    def intercept(self, A: Any) -> Any:
        """h - A h_A."""
        A = np.asarray(A, dtype=float)
        # A^2 stands before the integral
        (found,) = self.summed(
            A,
            lambda sine, cosine, f_uu: (sampled.intercept_terms(1.0, sine, cosine, f_uu),),
            lambda A, end, lost: (sampled.intercept_end(A, end, *lost[:2]) / A**2,),
            (2,),
        )
        first = next(one for one in self.smooth if one is not None)
        return A**2 * found + sampled.at_rest(float(first.at(0.0, (0,))[0]))

    def value(self, number: int, u: Any, order: int) -> Any:
        """A piece of the force, or its slope, on both sides of u = 0."""
        begin = (0.0, *self.ends)[number]
        size = np.abs(u)
        side = np.copysign(1.0, u) if order == 0 else 1.0
        piece = self.smooth[number]
        if piece is None:
            return 0.0 * size
        v = size - begin
        if number + 1 < len(self.smooth):
            return side * piece.at(v, (order,))[0]
        further = v - piece.length
        (inside,) = piece.at(np.minimum(v, piece.length), (order,))
        return side * np.where(further > 0, self.beyond(np.maximum(further, 0.0), (order,))[0], inside)

    def bounds(self, number: int, v: Any) -> tuple[Any, Any]:
        """A piece and its fourth derivative on intervals; NaN beyond the reach, where nothing is known."""
        piece = self.smooth[number]
        low, high = v.ends
        if piece is None:
            return 0.0 * v, 0.0 * v
        outside = high > piece.length * (1 + 2.0**-40)
        found = []
        for one in piece.ranges:
            ends = one.on(np.maximum(low, 0.0), np.minimum(high, piece.length))
            ends[:, outside] = np.nan
            found.append(type(v)(ends))
        return found[0], found[1]


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
            raise TypeError(
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

    def given(self, numbers: tuple[float, ...]) -> str:
        """A design in words."""
        told = ", ".join(f"{name} = {value!r}" for name, value in zip(self.names, numbers, strict=True))
        return f"{told}: " if told else ""

    def by_name(self, numbers: tuple[float, ...]) -> dict[str, float]:
        """What functions are called with."""
        return dict(zip(self.names, numbers, strict=True))

    def ends_of(self, numbers: tuple[float, ...]) -> tuple[float, ...]:
        """The breakpoints."""
        found = []
        for number, end in enumerate(self.ends, start=1):
            value = self._asked(f"the end of piece {number}", end, (), numbers) if callable(end) else end
            found.append(_real(f"{self.given(numbers)}the end of piece {number} of {self.name}", value))
        return tuple(found)

    def _asked(self, what: str, function: Callable[..., Any], at: tuple[Any, ...], numbers: tuple[float, ...]) -> Any:
        try:
            return function(*at, **self.by_name(numbers))
        except Exception as error:
            where = f" at u = {at[0]!r}" if at else ""
            raise ValueError(
                f"{self.given(numbers)}{what} of {self.name} raises {type(error).__name__}{where}: {error}"
            ) from error

    def values(self, number: int, u: Floats, numbers: tuple[float, ...]) -> Floats:
        """A piece at displacements (n,): all at once where its function takes arrays, and one by one elsewhere."""
        function, what = self.functions[number], f"piece {number + 1}"
        ends = [float(self._asked_one(what, function, float(u[k]), numbers)) for k in (0, -1)]
        try:
            together = np.asarray(function(u.copy(), **self.by_name(numbers)), dtype=float)
        except Exception:
            together = np.empty(0)
        alike = together.shape == u.shape and np.allclose(together[[0, -1]], ends, rtol=1e-12, atol=0, equal_nan=True)
        if not alike:
            together = np.array([self._asked_one(what, function, float(one), numbers) for one in u])
        bad = ~np.isfinite(together)
        if bad.any():
            where = int(np.argmax(bad))
            raise ValueError(
                f"{self.given(numbers)}{what} of {self.name} is {together[where]} at u = {u[where]:.17g}: "
                f"it must be finite up to its end, and up to the reach, {self.reach:g}"
            )
        return together

    def _asked_one(self, what: str, function: Callable[..., Any], u: float, numbers: tuple[float, ...]) -> float:
        value = self._asked(what, function, (u,), numbers)
        return _real(f"{self.given(numbers)}{what} of {self.name} at u = {u!r}", value, finite=False)

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
                raise ValueError(
                    f"{self.given(numbers)}piece {number + 1} of {self.name} is {value:.6g} at u = {one:g} "
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
        raise ValueError(f"{what} is {value!r}: it must be a real number") from None
    if finite and not math.isfinite(found):
        raise ValueError(f"{what} is {found!r}: it must be finite")
    return found


@dataclass(frozen=True)
class Asked:
    """One function of the record: of a piece by its number, where it is of one.

    what -- one of those below
    """

    stated: Stated
    what: Callable[..., Any]
    number: int = 0

    @property
    def __name__(self) -> str:
        return self.what.__name__

    def __call__(self, *arguments: Any) -> Any:
        return self.what(self, *arguments)

    def _numbers(self, given: Sequence[Any]) -> tuple[float, ...]:
        return tuple(float(one) for one in given)

    def _by_design(self, given: Sequence[Any], *beside: Any, of: Callable[..., Sequence[Any]]) -> tuple[Any, ...]:
        """What is of one design, of arrays of them: each once."""
        if all(np.ndim(one) == 0 for one in given):
            return tuple(of(self.stated.force(self._numbers(given)), *beside))
        *arrays, shaped = np.broadcast_arrays(*given, *(beside or (0.0,)))
        arrays.append(shaped)
        rows = np.stack([np.asarray(one, dtype=float).ravel() for one in arrays[: len(given)]], axis=-1)
        others = [np.asarray(one, dtype=float).ravel() for one in arrays[len(given) :]]
        designs, of_row = np.unique(rows, axis=0, return_inverse=True)
        found: list[Floats] = []
        for k, design in enumerate(designs):
            here = of_row.ravel() == k
            values = of(self.stated.force(self._numbers(design)), *((one[here] for one in others) if beside else ()))
            if not found:
                found = [np.empty(len(rows)) for _ in values]
            for whole, value in zip(found, values, strict=True):
                whole[here] = value
        return tuple(one.reshape(arrays[0].shape) for one in found)

    # --- of the parameters ---

    def coefficients(self, *design: Any) -> Any:
        """The parameters are the design; a force that is not allowed is told here, before any work."""
        self._by_design(design, of=lambda force: (0.0,))
        return tuple(design)

    def breakpoints(self, *given: Any) -> Any:
        return self._by_design(given, of=lambda force: force.ends[:-1])

    def jumps(self, *given: Any) -> Any:
        return self._by_design(given, of=lambda force: [lost[0] for lost in force.lost[:-1]])

    def kinks(self, *given: Any) -> Any:
        return self._by_design(given, of=lambda force: [one for lost in force.lost[:-1] for one in lost[1:3]])

    def hardening(self, *given: Any) -> Any:
        return self._by_design(given, of=lambda force: (-1.0,))

    def told(self, *given: Any) -> str:
        force = self.stated.force(self._numbers(given))
        by = f"by {force.points} of its values, error {force.error:.1g}"
        return f"a Python function, {by}; quadrature on NumPy, not compiled"

    # --- of the amplitude ---

    def averaged(self, A: Any, *given: Any) -> Any:
        return self._by_design(given, A, of=Force.averaged)

    def harmonics(self, A: Any, *given: Any) -> Any:
        return self._by_design(given, A, of=Force.harmonics)

    def intercept(self, A: Any, *given: Any) -> Any:
        (found,) = self._by_design(given, A, of=lambda force, A: (force.intercept(A),))
        return found

    # --- of a piece ---

    def force(self, u: Any, *given: Any) -> Any:
        return self.stated.force(self._numbers(given)).value(self.number, u, 0)

    def slope(self, u: Any, *given: Any) -> Any:
        return self.stated.force(self._numbers(given)).value(self.number, u, 1)

    # --- on intervals ---

    def enclosed_terms(self, around: Any, A: Any, beyond: Any, sine: Any, *given: Any) -> Any:
        value, fourth = self._of(given).bounds(self.number, beyond)
        return sampled_intervals.bent_terms(sine, value, fourth)

    def enclosed_closing(self, around: Any, A: Any, *numbers: Any) -> Any:
        """The number is how many breakpoints are exceeded; their roots come before the sums."""
        h, bend = numbers[self.number : self.number + 2]
        force = self._of(numbers[self.number + 2 :])
        for end, lost in list(zip(force.ends, force.lost, strict=True))[: self.number]:
            lowest = next((order for order, one in enumerate(lost) if one != 0), None)
            if lowest is not None and end > 0:
                bend = bend + BENT_ENDS[lowest](A, *(A.point(one) for one in (end, *lost[lowest:])))
        return h, bend

    def _of(self, given: Sequence[Any]) -> Force:
        return self.stated.force(tuple(float(one.ends[0, 0]) for one in given))


def record(stated: Stated, title: str, design: tuple[Parameter, ...], reach_reason: str) -> Mechanism:
    """The record of a mechanism whose force is stated by functions."""
    count = len(stated.functions)
    return Mechanism(
        name=stated.name,
        title=title,
        design=design,
        parameters=design,
        coefficients=Asked(stated, Asked.coefficients),
        pieces=tuple(Law(Asked(stated, Asked.force, k), Asked(stated, Asked.slope, k)) for k in range(count)),
        breakpoints=Asked(stated, Asked.breakpoints),
        jumps=Asked(stated, Asked.jumps),
        kinks=Asked(stated, Asked.kinks),
        hardening=Asked(stated, Asked.hardening),
        averaged=Asked(stated, Asked.averaged),
        intercept=Asked(stated, Asked.intercept),
        harmonics=Asked(stated, Asked.harmonics),
        harmonics_up_to=math.inf,
        reach=stated.reach,
        reach_reason=reach_reason or REACHED,
        truncated=False,
        load_untruncated=None,
        enclosed=Enclosed(
            tuple(Asked(stated, Asked.enclosed_terms, k) for k in range(count)),
            tuple(Asked(stated, Asked.enclosed_closing, k) for k in range(count)),
        ),
        told=Asked(stated, Asked.told),
    )


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
        raise TypeError(f"{what} cannot be called as f({called}): {error}") from None
