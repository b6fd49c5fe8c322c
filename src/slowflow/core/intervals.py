"""Arithmetic on closed intervals of doubles, rounded outwards: arrays of intervals in, one that holds every result out.

What is not known is NaN, or reaches to infinity: a test that asks whether something is proved fails there. 0 times
infinity is 0, as infinity stands for arbitrarily large numbers. The operations are those of the compiled solvers
(native/interval.h, native/elementary.h), by the names that programs have for them.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from slowflow.core.backend import SOLVER
from slowflow.core.mechanism import Floats

#: ends of an interval that holds all numbers
ALL = np.array([[-np.inf], [np.inf]])


def _operation(name: str) -> Callable[..., Any]:
    """The method of an operation on one or two intervals; numbers stand for themselves."""
    operate = SOLVER.INTERVALS[name]

    def method(self: Interval, other: Any = 0.0) -> Any:
        ends = other.ends if isinstance(other, Interval) else (other, other)
        return type(self)(np.array(operate(*self.ends, *ends)))

    return method


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
    def around(cls, x: float) -> Interval:
        """A number that no double is equal to, for any number of elements."""
        return cls.of([x - abs(x) * 2.0**-52], [x + abs(x) * 2.0**-52])

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

    def __rsub__(self, other: float) -> Any:
        return -self + other

    def __rtruediv__(self, other: float) -> Any:
        return self.inverse() * other

    __add__ = __radd__ = _operation("ADD")
    __mul__ = __rmul__ = _operation("MUL")
    __sub__, __truediv__ = _operation("SUB"), _operation("DIV")
    #: 1 over an interval on one side of 0, which it may touch; anything over one that holds 0 inside
    inverse = _operation("INVERSE")
    #: the square, which is not negative, and the root of the part that is not negative
    square, sqrt = _operation("SQUARE"), _operation("SQRT")

    def both(self, other: Interval) -> Interval:
        """What both hold, each being known to hold the value."""
        return type(self)(np.array((np.fmax(self.ends[0], other.ends[0]), np.fmin(self.ends[1], other.ends[1]))))

    def take(self, which: Any) -> Interval:
        """Some of them."""
        return type(self)(self.ends[:, which])


class Elementary(Interval):
    """Intervals with elementary functions; where an argument leaves a function's domain nothing is known: NaN."""

    __slots__ = ()

    exp, log, log1p = _operation("EXP"), _operation("LOG"), _operation("LOG1P")
    sin, cos, tan = _operation("SIN"), _operation("COS"), _operation("TAN")
    asin, acos, atan = _operation("ASIN"), _operation("ACOS"), _operation("ATAN")
    sinh, cosh, tanh = _operation("SINH"), _operation("COSH"), _operation("TANH")
    asinh, acosh, atanh = _operation("ASINH"), _operation("ACOSH"), _operation("ATANH")
    #: the square root, and a power that is an interval or a number, of what is not negative
    root, power = _operation("ROOT"), _operation("POWER")
