"""A function known by its values. Takes what can be called with u; returns a polynomial, its slopes and bounds.

It goes through the values at Chebyshev's points, as many as it takes, and has an error that is measured.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from slowflow.support.errors import Refused
from slowflow_kernels.exact_conventions import MOST_DEGREE

Floats = NDArray[np.float64]

#: points of the first look, and of the last
FEWEST, MOST = 16, 1024
#: what the last eighth of the coefficients is of the largest where a function is known to rounding, and at most
ROUNDED, RESOLVED = 2.0**-51, 2.0**-44
#: points at which the error is measured
CHECKED = 500
#: parts of a piece on which its values are bounded
CELLS = 256
#: numbers of a polynomial that a motion is followed by, at most
DEGREES = MOST_DEGREE + 1
#: of a place or of 1, the length of a part in which a function is not smooth; what it changes by there where it is
#: continuous
SHORTEST, CONTINUOUS = 2.0**-27, 2.0**-10
#: by how much of a place rounding of it may change a polynomial over the length of a part
ROUGH = 2.0**-48
#: derivatives that are asked for
ORDERS = 4


class Smooth:
    """One piece as a polynomial in v, what u exceeds its begin by, from 0 to its length.

    Where it begins with 0, as at rest, it is a polynomial times a power of v, which keeps its digits there.

    resolved -- what the last coefficients may be of the largest
    power  -- that of v
    points -- how many values it goes through
    noise  -- what its coefficients are in doubt by
    error  -- the largest that was measured between these points, of the largest force
    """

    points: int
    noise: float
    of: list[Any]

    def __init__(
        self,
        values: Callable[[Floats], Floats],
        length: float,
        from_zero: bool,
        name: str,
        resolved: float = RESOLVED,
    ) -> None:
        self.length, self.power, self.resolved = length, 0, resolved
        coefficients = self._through(values, name)
        while from_zero and self.power < ORDERS and np.any(coefficients):
            start = float(chebyshev.chebval(-1.0, coefficients))
            if abs(start) > max(resolved * np.abs(coefficients).max(), self._doubt(coefficients, 0)):
                break
            kept = self.points, self.noise
            try:
                coefficients = self._through(lambda v: values(v) / v ** (self.power + 1), name)
            except ValueError:
                self.points, self.noise = kept
                break
            self.power += 1
        self.of = [coefficients]
        for _ in range(ORDERS):
            self.of.append(chebyshev.chebder(self.of[-1], scl=2 / length))
        v = np.concatenate((self._points(CHECKED), length * np.linspace(0, 1, CHECKED + 2)[1:-1]))
        expected = values(v)
        size = float(np.abs(expected).max(initial=0.0))
        self.error = float(np.abs(expected - self.at(v, (0,))[0]).max()) / size if size > 0 else 0.0
        if self.error > math.sqrt(RESOLVED):
            raise Refused(f"{name} is not resolved by the polynomial through {self.points} points: {_LEFT}")

    def _points(self, count: int) -> Floats:
        return np.asarray(0.5 * self.length * (1 - np.cos(np.pi * (np.arange(count) + 0.5) / count)))

    def _through(self, values: Callable[[Floats], Floats], name: str) -> Floats:
        """Coefficients of Chebyshev's polynomials; what is left out is rounding."""
        found, count = None, FEWEST
        while count <= MOST:
            coefficients = _through(values(self._points(count)))
            tail, size = np.abs(coefficients[-(count // 8) :]).max(), np.abs(coefficients).max()
            if found is None and tail <= self.resolved * size:
                found = coefficients, tail, count
            if tail <= ROUNDED * size:
                found = coefficients, tail, count
                break
            count *= 2
        if found is None:
            raise Refused(
                f"{name} is not resolved: with {MOST} points the relative error is {tail / size:.1g}: {_LEFT}"
            )
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

    def pieces(self) -> list[list[float]]:
        """The same as polynomials of at most `DEGREES` numbers, one after the other, as `rows` has them."""
        return self._pieces(0.0, self.length, self.of[0], self.power)

    def _pieces(self, a: float, b: float, coefficients: Floats, power: int) -> list[list[float]]:
        if coefficients.size <= DEGREES:
            slope = chebyshev.chebder(coefficients, scl=2 / (b - a))
            filled = (np.pad(one, (0, DEGREES - one.size)) for one in (coefficients, slope))
            return [[a, b - a, power, coefficients.size - 1, *np.concatenate(list(filled))]]
        half = 0.5 * (a + b)
        return [row for ends in ((a, half), (half, b)) for row in self._pieces(*ends, *self._on(*ends))]

    def _on(self, a: float, b: float) -> tuple[Floats, int]:
        """Numbers of the polynomial on a part, as far as they are known, and the power of v beside it."""
        power = self.power if a == 0 else 0
        count = self.of[0].size + self.power - power
        v = a + (b - a) * self._points(count) / self.length
        coefficients = _through(v ** (self.power - power) * chebyshev.chebval(2 * v / self.length - 1, self.of[0]))
        noise = max(self.noise * b ** (self.power - power), 2.0**-53 * np.abs(coefficients).max())
        kept = np.flatnonzero(np.abs(coefficients) > noise)
        return coefficients[: kept[-1] + 1 if kept.size else 1], power

    @property
    def edges(self) -> Floats:
        """Those of the parts that `ranges` bounds it on, dense where the piece begins."""
        return np.asarray(self.length * (np.arange(CELLS + 1) / CELLS) ** 2)

    def ranges(self, order: int) -> tuple[Floats, Floats]:
        """What a derivative is at least, and at most, on each part."""
        # on a part it is the polynomial through so many of its values, whose coefficients bound it
        count = self.of[0].size + self.power
        points = 0.5 * (1 - np.cos(np.pi * (np.arange(count) + 0.5) / count))
        edges = self.edges[:, np.newaxis]
        (values,) = self.at(edges[:-1] + np.diff(edges, axis=0) * points, (order,))
        coefficients = _cosines(np.broadcast_to(values, (CELLS, count)))
        middle, radius = 0.5 * coefficients[:, 0], np.abs(coefficients[:, 1:]).sum(axis=1)
        radius += 4 * count * 2.0**-52 * self.size(order)
        return middle - radius, middle + radius


_LEFT = "end the piece where the function is not smooth, and define a fractional power by a formula"


def rows(values: Callable[[Floats], Floats], begin: float, end: float, first: float) -> Floats:
    """A function from begin to end as polynomials one after the other, as the compiled motions take them.

    Each is begin, length, power, degree, its numbers and those of its slope beside the power, `DEGREES` of each. The
    parts halve towards a place where the function is not smooth, and a short one leads across it where it is
    continuous; beyond any other it is NaN.

    first -- length of the first part that is tried
    """
    found: list[list[float]] = []
    at, length = begin, first
    while at < end:
        length = min(length, end - at)
        try:
            with np.errstate(all="ignore"):
                known = max(RESOLVED, ROUGH * at / length)  # what lies next to a pole is in doubt as u is
                pieces = Smooth(lambda v, at=at: values(at + v), length, at == 0, "", known).pieces()  # type: ignore[misc]
        except Refused:
            if length > SHORTEST * max(at, 1.0):
                length *= 0.5
                continue
            here, there = values(np.array([at, at + length])).tolist()
            if not abs(there - here) <= CONTINUOUS * max(abs(here), abs(there), 1.0):
                break
            rise = 0.5 * (there - here)
            pieces = [[0.0, length, 0.0, 1.0, here + rise, rise, *[0.0] * (2 * DEGREES - 2)]]
            pieces[0][4 + DEGREES] = 2 * rise / length
        found += [[at + a, *row] for a, *row in pieces]
        at, length = at + length, 2 * length
    if at < end or not found:
        found.append([at, 1.0, 0.0, 0.0, *[math.nan] * (2 * DEGREES)])
    return np.array(found)


def _through(values: Floats) -> Floats:
    """Numbers of the polynomial with these values at the points by rising v, for which the signs alternate."""
    coefficients = _cosines(values)
    coefficients[0] *= 0.5
    coefficients *= (-1.0) ** np.arange(coefficients.size)
    return coefficients


def _cosines(values: Floats) -> Floats:
    """Coefficients of Chebyshev's polynomials by falling v, the first one twice, from values along the last axis."""
    from scipy.fft import dct  # here, not above: a force that is no Python function does without SciPy

    found: Floats = dct(values, type=2, axis=-1) / values.shape[-1]
    return found
