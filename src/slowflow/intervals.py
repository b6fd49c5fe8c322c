"""Arithmetic on closed intervals of doubles, rounded outwards: arrays of intervals in, one that holds every result out.

What is not known is NaN, or reaches to infinity: a test that asks whether something is proved fails there. 0 times
infinity is 0, as infinity stands for arbitrarily large numbers. As in native/interval.h each operation is rounded to
nearest and then moved by more than an ulp, so that no rounding mode is switched.

A search in boxes asks of a few intervals at a time, and NumPy takes most of that time between its operations: what
takes many of them is compiled (native/solver/intervals.c).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from slowflow.backend import SOLVER
from slowflow.mechanism import Flags, Floats

#: ends of an interval that holds all numbers
ALL = np.array([[-np.inf], [np.inf]])
#: an ulp outwards of the lower and of the upper end, and what a product that is no double may have lost
_ULP = np.array([[-(2.0**-52)], [2.0**-52]])
_LEAST = np.array([[-(2.0**-1022)], [2.0**-1022]])


def _wider(ends: Floats) -> Floats:
    """The ends of sums and roots, an ulp outwards: they are exact where they are subnormal."""
    found: Floats = ends + _ULP * np.abs(ends)
    return found


class Interval:
    """Intervals, elementwise; in sums and products numbers stand for themselves.

    ends -- array (2, n): the lower and the upper ends
    """

    __slots__ = ("ends",)

    def __init__(self, ends: Floats) -> None:
        self.ends = ends

    @classmethod
    def of(cls, lo: Any, hi: Any) -> Interval:
        """From lower and upper ends, which broadcast."""
        return cls(np.stack(np.broadcast_arrays(lo, hi)))

    @classmethod
    def point(cls, x: Any) -> Interval:
        """A number, for any number of elements; or an array of them, one for each."""
        return cls(np.array((x, x), dtype=float).reshape(2, -1))

    @classmethod
    def like(cls, value: Any, other: Interval) -> Interval:
        """An interval or a number, for as many elements as another has."""
        ends = value.ends if isinstance(value, Interval) else cls.point(float(value)).ends
        return cls(np.broadcast_to(ends, other.ends.shape))

    @property
    def lo(self) -> Floats:
        """Lower ends."""
        return np.asarray(self.ends[0])

    @property
    def hi(self) -> Floats:
        """Upper ends."""
        return np.asarray(self.ends[1])

    def __neg__(self) -> Interval:
        return type(self)(-self.ends[::-1])

    def __add__(self, other: Any) -> Interval:
        return type(self)(_wider(self.ends + (other.ends if isinstance(other, Interval) else other)))

    def __sub__(self, other: Any) -> Interval:
        return type(self)(_wider(self.ends - (other.ends[::-1] if isinstance(other, Interval) else other)))

    def __rsub__(self, other: float) -> Interval:
        return type(self)(_wider(other - self.ends[::-1]))

    def __mul__(self, other: Any) -> Interval:
        if not isinstance(other, Interval):
            ends = self.ends if other >= 0 else self.ends[::-1]
            return type(self)(_wider(ends * other) + _LEAST * ((ends != 0) & (other != 0)))
        return type(self)(np.array(SOLVER.interval_product(*self.ends, *other.ends)))

    __radd__, __rmul__ = __add__, __mul__

    def __truediv__(self, other: Interval) -> Interval:
        return self * other._inverse()

    def __rtruediv__(self, other: float) -> Interval:
        inverse = self._inverse()
        return inverse if other == 1 else inverse * other

    def _inverse(self) -> Interval:
        """1 over an interval on one side of 0, which it may touch; anything over one that holds 0 inside."""
        return type(self)(np.array(SOLVER.interval_inverse(*self.ends)))

    def square(self) -> Interval:
        """The square, which is not negative."""
        return type(self)(np.array(SOLVER.interval_square(*self.ends)))

    def sqrt(self) -> Interval:
        """The root of the part that is not negative."""
        return type(self)(np.maximum(_wider(np.sqrt(np.maximum(self.ends, 0.0))), 0.0))

    def both(self, other: Interval) -> Interval:
        """What both hold, each being known to hold the value."""
        return type(self)(np.array((np.fmax(self.ends[0], other.ends[0]), np.fmin(self.ends[1], other.ends[1]))))

    def where(self, condition: Flags, other: Interval) -> Interval:
        """These where the condition holds, others elsewhere."""
        return type(self)(np.where(condition, self.ends, other.ends))

    def take(self, which: Any) -> Interval:
        """Some of them."""
        return type(self)(self.ends[:, which])


#: what stands for any larger value of an elementary function at the lower end: products of six of them are doubles
_LARGEST = 2.0**160
#: what an elementary function of NumPy may err by, relatively; it is known to err by some ulps
_FUNCTION = np.array([[-(2.0**-46)], [2.0**-46]])


def _apart(ends: Floats) -> Floats:
    """What a function's values may be; one that is very large is large at least."""
    least, most = np.array([[-np.inf], [-_LARGEST]]), np.array([[_LARGEST], [np.inf]])
    return np.asarray(np.clip(ends + _FUNCTION * np.where(np.isinf(ends), 0.0, np.abs(ends)), least, most))


def _rising(function: Any, least: float = -np.inf, most: float = np.inf) -> Callable[[Any], Elementary]:
    """The method of a function that rises, on its domain."""

    def method(self: Elementary) -> Elementary:
        values = _apart(function(self.ends))
        return Elementary(np.where((self.ends[0] >= least) & (self.ends[1] <= most), values, np.nan))

    return method


class Elementary(Interval):
    """Intervals with elementary functions; where an argument leaves a function's domain nothing is known: NaN."""

    __slots__ = ()

    exp = _rising(np.exp)
    log = _rising(np.log, 0.0)
    log1p = _rising(np.log1p, -1.0)
    #: the square root
    root = _rising(np.sqrt, 0.0)
    sinh = _rising(np.sinh)
    tanh = _rising(np.tanh)
    atan = _rising(np.arctan)
    asinh = _rising(np.arcsinh)
    asin = _rising(np.arcsin, -1.0, 1.0)
    acosh = _rising(np.arccosh, 1.0)
    atanh = _rising(np.arctanh, -1.0, 1.0)

    def acos(self) -> Elementary:
        """Its arccosine."""
        return Elementary((0.5 * np.pi - self.asin()).ends)

    def tan(self) -> Elementary:
        """Its tangent, between two poles."""
        branch = np.floor(self.ends / np.pi + 0.5)
        return Elementary(np.where(branch[0] == branch[1], _rising(np.tan)(self).ends, np.nan))

    def cosh(self) -> Elementary:
        """Its hyperbolic cosine, which is not less than 1."""
        least = np.maximum(np.maximum(self.ends[0], -self.ends[1]), 0.0)
        return _rising(np.cosh)(Elementary(np.array((least, np.abs(self.ends).max(axis=0)))))

    def sin(self) -> Elementary:
        """Its sine, by the maxima and minima that it passes."""
        return self._waves(np.sin, 0.5 * np.pi)

    def cos(self) -> Elementary:
        """Its cosine."""
        return self._waves(np.cos, 0.0)

    def _waves(self, function: Any, maximum: float) -> Elementary:
        """A function of period 2 pi that is 1 at its maximum and -1 half a period off."""
        wider = _wider(self.ends)
        at = function(wider)

        def holds(place: float) -> Flags:
            turns = (wider - place) / (2 * np.pi)
            # a rounding more of a turn than there is
            doubt = 2.0**-50 * (1 + np.abs(turns))
            return np.asarray(np.ceil(turns[0] - doubt[0]) <= np.floor(turns[1] + doubt[1]))

        low = np.where(holds(maximum + np.pi), -1.0, np.minimum(at[0], at[1]) - 2.0**-48)
        high = np.where(holds(maximum), 1.0, np.maximum(at[0], at[1]) + 2.0**-48)
        known = np.isfinite(wider).all(axis=0)
        return Elementary(np.where(known, np.array((low, high)), np.array([[-1.0], [1.0]])))

    def power(self, exponent: Any) -> Elementary:
        """Not negative, to a power that is an interval or a number."""
        ends = exponent.ends if isinstance(exponent, Interval) else np.full((2, 1), float(exponent))
        values = np.power(self.ends[:, np.newaxis], ends)
        low, high = values.min(axis=(0, 1)), values.max(axis=(0, 1))
        return Elementary(np.where(self.ends[0] >= 0, _apart(np.array((low, high))), np.nan))
