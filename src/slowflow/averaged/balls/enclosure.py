"""Closed intervals between exact numbers of FLINT: in go intervals, out comes one that holds every result.

As native/interval.h, to the digits of `flint.ctx`: what is not known is NaN, or reaches to infinity, and a test that
asks whether something is proved fails there; 0 times infinity is 0, as infinity stands for arbitrarily large numbers.
Balls would not do for wide intervals: one that reaches to infinity holds all numbers, and the square of one about 0
negative ones.
"""

from __future__ import annotations

import math
from typing import Any

from flint import arb

INFINITE, ZERO = arb(math.inf), arb(0)


def least(a: arb, b: arb) -> arb:
    """The lesser of two exact numbers, the second where one is NaN."""
    return a if a < b else b


def most(a: arb, b: arb) -> arb:
    """The greater one, likewise."""
    return a if a > b else b


def _product(a: arb, b: arb) -> arb:
    product = a * b
    return ZERO if product.is_nan() and (a.is_zero() or b.is_zero()) else product


class Enclosure:
    """An interval, with the operators that generated kernels take; numbers stand for themselves.

    lo, hi -- exact numbers
    """

    __slots__ = ("hi", "lo")

    def __init__(self, lo: arb, hi: arb) -> None:
        self.lo, self.hi = lo, hi

    @classmethod
    def of(cls, value: Any) -> Enclosure:
        """From a ball, or an exact number; of a ball of which nothing is known, all numbers."""
        ball = arb(value)
        return cls(ball.lower(), ball.upper()) if ball.is_finite() else cls(-INFINITE, INFINITE)

    def __repr__(self) -> str:
        return f"[{self.lo}, {self.hi}]"

    @property
    def sign(self) -> int:
        """1 or -1 where it is proved, else 0."""
        return int(self.lo > 0) - int(self.hi < 0)

    @property
    def width(self) -> arb:
        """From end to end, rounded up."""
        return (self.hi - self.lo).upper()

    @property
    def middle(self) -> arb:
        """A number in it."""
        return ((self.lo + self.hi) / 2).mid()

    def __neg__(self) -> Enclosure:
        return Enclosure(-self.hi, -self.lo)

    def __add__(self, other: Any) -> Enclosure:
        lo, hi = (other.lo, other.hi) if isinstance(other, Enclosure) else (other, other)
        return Enclosure((self.lo + lo).lower(), (self.hi + hi).upper())

    def __sub__(self, other: Any) -> Enclosure:
        lo, hi = (other.lo, other.hi) if isinstance(other, Enclosure) else (other, other)
        return Enclosure((self.lo - hi).lower(), (self.hi - lo).upper())

    def __rsub__(self, other: Any) -> Enclosure:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> Enclosure:
        if not isinstance(other, Enclosure):
            ends = (self.lo, self.hi) if other > 0 else (self.hi, self.lo)
            return Enclosure((ends[0] * other).lower(), (ends[1] * other).upper())
        if self.lo >= 0:
            return self._positive_times(other)
        if self.hi <= 0:
            return -(-self)._positive_times(other)
        if other.lo >= 0:
            return other._positive_times(self)
        if other.hi <= 0:
            return -(-other)._positive_times(self)
        if not (self.lo <= self.hi and other.lo <= other.hi):
            return Enclosure(arb.nan(), arb.nan())
        return Enclosure(
            least(_product(self.lo, other.hi).lower(), _product(self.hi, other.lo).lower()),
            most(_product(self.lo, other.lo).upper(), _product(self.hi, other.hi).upper()),
        )

    __radd__, __rmul__ = __add__, __mul__

    def _positive_times(self, other: Enclosure) -> Enclosure:
        """Of one that is not negative."""
        low = self.lo if other.lo >= 0 else self.hi
        high = self.lo if other.hi <= 0 else self.hi
        return Enclosure(_product(low, other.lo).lower(), _product(high, other.hi).upper())

    def __truediv__(self, other: Any) -> Enclosure:
        inverse = other.inverse() if isinstance(other, Enclosure) else Enclosure.of(1 / arb(other))
        return self * inverse

    def __rtruediv__(self, other: Any) -> Enclosure:
        return self.inverse().__mul__(other)

    def inverse(self) -> Enclosure:
        """1 over an interval on one side of 0, which it may touch; all numbers over one that holds 0 inside."""
        if self.lo >= 0:
            return Enclosure((1 / self.hi).lower(), (1 / self.lo).upper() if self.lo > 0 else INFINITE)
        if self.hi <= 0:
            return -(-self).inverse()
        return Enclosure(-INFINITE, INFINITE)

    def square(self) -> Enclosure:
        """The square, which is not negative."""
        if not self.lo <= self.hi:
            return Enclosure(arb.nan(), arb.nan())
        lo = self.lo if self.lo > 0 else -self.hi if self.hi < 0 else ZERO
        hi = most(-self.lo, self.hi)
        return Enclosure((lo * lo).lower(), (hi * hi).upper())

    def sqrt(self) -> Enclosure:
        """The root of the part that is not negative."""
        lo = self.lo.sqrt().lower() if self.lo > 0 else ZERO
        return Enclosure(lo, self.hi.sqrt().upper() if not self.hi <= 0 else ZERO)

    def both(self, other: Enclosure) -> Enclosure:
        """What both hold, each being known to hold the value."""
        return Enclosure(
            other.lo if other.lo > self.lo else self.lo,
            other.hi if other.hi < self.hi else self.hi,
        )

    def hull(self, other: Enclosure) -> Enclosure:
        """From the least to the greatest."""
        return Enclosure(least(self.lo, other.lo), most(self.hi, other.hi))


ALL = Enclosure(-INFINITE, INFINITE)
