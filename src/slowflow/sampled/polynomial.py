"""A function known by its values: in goes what can be called with u, out comes a polynomial, its slopes and bounds.

It goes through the values at Chebyshev's points, as many as it takes, and has an error that is measured.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from slowflow_support.errors import Refused

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
            raise Refused(f"{told} is not the polynomial through {self.points} of its values: {_LEFT}")

    def _places(self, count: int) -> Floats:
        return np.asarray(0.5 * self.length * (1 - np.cos(np.pi * (np.arange(count) + 0.5) / count)))

    def _through(self, values: Callable[[Floats], Floats], told: str) -> Floats:
        """Coefficients of Chebyshev's polynomials; what is left out is rounding."""
        found, count = None, FEWEST
        while count <= MOST:
            # by rising v: the polynomials' signs alternate
            coefficients = _cosines(values(self._places(count)))
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
            raise Refused(f"{told}: {MOST} of its values leave {tail / size:.1g} of it open: {_LEFT}")
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


def _cosines(values: Floats) -> Floats:
    """Coefficients of Chebyshev's polynomials by falling v, the first one twice, from values along the last axis."""
    from scipy.fft import dct  # here, not above: a force that is no Python function does without SciPy

    found: Floats = dct(values, type=2, axis=-1) / values.shape[-1]
    return found


class _Ranges:
    """What a polynomial is on intervals, by what it is on parts, dense where the piece begins."""

    def __init__(self, piece: Smooth, order: int) -> None:
        edges = piece.length * (np.arange(CELLS + 1) / CELLS) ** 2
        self.edges = edges
        # on a part it is the polynomial through so many of its values, whose coefficients bound it
        count = piece.of[0].size + piece.power
        places = 0.5 * (1 - np.cos(np.pi * (np.arange(count) + 0.5) / count))
        (values,) = piece.at(edges[:-1, np.newaxis] + np.diff(edges)[:, np.newaxis] * places, (order,))
        coefficients = _cosines(np.broadcast_to(values, (CELLS, count)))
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
