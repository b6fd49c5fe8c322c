"""Truncated Taylor series in several variables: a function of numbers in, all its derivatives at a place out.

For definitions that are differentiated many times over: `mp.diff` asks for the function anew for each derivative.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Sequence
from typing import Any

from mpmath import mp, mpf

Powers = tuple[int, ...]


@functools.cache
def monomials(count: int, order: int) -> tuple[Powers, ...]:
    """The powers of each variable, lowest order first."""
    found = itertools.product(range(order + 1), repeat=count)
    return tuple(sorted((powers for powers in found if sum(powers) <= order), key=lambda powers: (sum(powers), powers)))


@functools.cache
def products(count: int, order: int) -> list[list[tuple[int, int]]]:
    """For each monomial the others that it may be multiplied by, and which ones come out."""
    known = monomials(count, order)
    place = {powers: k for k, powers in enumerate(known)}
    both = [[tuple(map(sum, zip(a, b, strict=True))) for b in known] for a in known]
    return [[(j, place[one]) for j, one in enumerate(row) if one in place] for row in both]


class Series:
    """Coefficients of the monomials in `count` variables up to a total order."""

    def __init__(self, count: int, order: int, terms: list[Any]) -> None:
        self.count, self.order, self.terms = count, order, terms

    def _like(self, value: Any) -> Series:
        if isinstance(value, Series):
            return value
        return Series(self.count, self.order, [value, *[0] * (len(self.terms) - 1)])

    def __add__(self, other: Any) -> Series:
        if not isinstance(other, Series):
            return Series(self.count, self.order, [self.terms[0] + other, *self.terms[1:]])
        return Series(self.count, self.order, [a + b for a, b in zip(self.terms, other.terms, strict=True)])

    def __neg__(self) -> Series:
        return Series(self.count, self.order, [-a for a in self.terms])

    def __sub__(self, other: Any) -> Series:
        return self + -other

    def __rsub__(self, other: Any) -> Series:
        return -self + other

    def __mul__(self, other: Any) -> Series:
        if not isinstance(other, Series):
            return Series(self.count, self.order, [a * other for a in self.terms])
        terms: list[Any] = [0] * len(self.terms)
        for a, row in zip(self.terms, products(self.count, self.order), strict=True):
            if a:
                for j, k in row:
                    if b := other.terms[j]:
                        terms[k] += a * b
        return Series(self.count, self.order, terms)

    __radd__, __rmul__ = __add__, __mul__

    def __pow__(self, exponent: Any) -> Series:
        """Whole powers by multiplication, others by the binomial series."""
        if isinstance(exponent, int) and exponent >= 0:
            return functools.reduce(Series.__mul__, [self] * exponent) if exponent else self._like(1)
        first = self.terms[0]
        rest, factor, found = self * (1 / first) - 1, first**exponent, self._like(0)
        factors = [factor * mp.binomial(exponent, k) for k in range(self.order + 1)]
        for one in reversed(factors):
            found = found * rest + one
        return found

    def __truediv__(self, other: Any) -> Series:
        return self * (other**-1 if isinstance(other, Series) else 1 / mpf(other))

    def __rtruediv__(self, other: Any) -> Series:
        return self**-1 * other

    def sqrt(self) -> Series:
        """The positive root."""
        return self ** mpf("0.5")

    @property
    def value(self) -> Any:
        """At the place itself."""
        return self.terms[0]

    def derivative(self, *orders: int) -> Any:
        """There, of an order by each variable."""
        factor = math.prod(math.factorial(order) for order in orders)
        return self.terms[monomials(self.count, self.order).index(orders)] * factor

    def slopes(self) -> list[Any]:
        """By each variable in turn."""
        return [self.derivative(*(int(k == j) for j in range(self.count))) for k in range(self.count)]

    def by(self, k: int) -> Series:
        """The derivative by a variable, of an order less."""
        known = monomials(self.count, self.order)
        terms: list[Any] = [0] * len(known)
        for powers, a in zip(known, self.terms, strict=True):
            if powers[k]:
                terms[known.index((*powers[:k], powers[k] - 1, *powers[k + 1 :]))] = a * powers[k]
        return Series(self.count, self.order, terms)


def variables(place: Sequence[Any], order: int) -> list[Series]:
    """Each variable, at its place."""
    count = len(place)
    known = monomials(count, order)
    found = []
    for k, value in enumerate(place):
        terms: list[Any] = [0] * len(known)
        terms[0] = mp.mpmathify(value)
        terms[known.index(tuple(int(k == j) for j in range(count)))] = mpf(1)
        found.append(Series(count, order, terms))
    return found


def stated(*found: Series) -> list[Any]:
    """Values of each, then slopes of each."""
    return [*(one.value for one in found), *itertools.chain(*(one.slopes() for one in found))]
