"""Gaussian averages of a restoring force. Takes the force and root mean squares of u; returns the equivalent stiffness.

By Gauss's rule on parts of each piece of the force, so that averages are as near as roundings whatever the pieces are.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from slowflow.intervals import Interval
from slowflow.mechanism import Floats, Force

#: |u|/sigma up to which a Gaussian motion is looked at: the rest has a share of 1e-23
FAR = 10.0
#: parts of each piece of the force, and nodes in each: a part is at most 1.25 sigma wide
PARTS, NODES = 8, 12
#: where f/u is sampled, beside the size of the force, how often, and by how much of its range it may be off between
WIDE, SAMPLES, APART = 1e8, 2000, 0.01
_AT, _WEIGHTS = np.polynomial.legendre.leggauss(NODES)
_SHARES = ((np.arange(PARTS)[:, np.newaxis] + 0.5 * (1 + _AT)) / PARTS).ravel()
_SUMMED = np.tile(_WEIGHTS, PARTS) / (2 * PARTS)


class Averages(NamedTuple):
    """Averages of an odd force, each of where u f is positive and of where it is negative: (2, n).

    first, third -- |E[u f]|/sigma^2 and |E[u^3 f]|/sigma^4
    square -- E[f^2], (n,)
    """

    first: Floats
    third: Floats
    square: Floats

    @property
    def stiffness(self) -> Floats:
        """E[u f]/sigma^2."""
        return np.asarray(self.first[0] - self.first[1])


def averages(force: Force, sigma: Floats) -> Averages:
    """Of an odd force over u with these root mean squares, (n,)."""
    found, square = np.zeros((2, 2, sigma.size)), np.zeros(sigma.size)
    ends = np.array([0.0, *force.breakpoints[force.innermost :], math.inf]) / sigma[:, np.newaxis]
    low, width = np.minimum(ends[:, :-1], FAR), np.diff(np.minimum(ends, FAR))
    for number, piece in enumerate(force.pieces[force.innermost :]):
        some = np.flatnonzero(width[:, number] > 0)
        x = low[some, number, np.newaxis] + width[some, number, np.newaxis] * _SHARES
        weights = width[some, number, np.newaxis] * _SUMMED * np.exp(-0.5 * x * x) * math.sqrt(2 / math.pi)
        f = piece(sigma[some, np.newaxis] * x)
        of_u = weights * x * f / sigma[some, np.newaxis]
        parts = np.stack((np.maximum(of_u, 0.0), np.maximum(-of_u, 0.0)))
        found[:, :, some] += np.stack((parts.sum(axis=2), (parts * x * x).sum(axis=2)))
        square[some] += (weights * f * f).sum(axis=1)
    return Averages(found[0], found[1], square)


def sizes(force: Force, count: int) -> Floats:
    """Displacements from far below what the force is as large as to far beyond."""
    return np.asarray(max([1.0, *force.breakpoints]) * np.geomspace(1 / WIDE, WIDE, count))


class Secants:
    """Between which numbers f/u is from 0 on, by samples: stiffness is a mean of it, whatever sigma is."""

    def __init__(self, force: Force) -> None:
        self._u = sizes(force, SAMPLES)
        secants = force(self._u) / self._u
        self._least, self._most = np.minimum.accumulate(secants), np.maximum.accumulate(secants)

    def up_to(self, u: Floats) -> Interval:
        """Up to some u, a little wider than samples have it."""
        at = np.minimum(np.searchsorted(self._u, u), SAMPLES - 1)
        more = APART * (self._most[at] - self._least[at])
        return Interval.of(self._least[at] - more, self._most[at] + more)


def on_ranges(force: Force, secants: Secants, low: Floats, high: Floats) -> tuple[Interval, Interval]:
    """The stiffness where sigma is between two, and its slope by ln(sigma).

    The density of u times u^n/sigma^n is at most (high/low)^(n + 1) times that at the upper end, and at least that
    share of that at the lower end. The slope is E[u^3 f]/sigma^4 less three times the stiffness, three times the
    difference of two means of f/u.
    """
    at_low, at_high = averages(force, low), averages(force, high)
    first, third = (
        Interval.of(a[0] / grows - b[1] * grows, b[0] * grows - a[1] / grows)
        for a, b, grows in (
            (at_low.first, at_high.first, (high / low) ** 3),
            (at_low.third, at_high.third, (high / low) ** 5),
        )
    )
    held = secants.up_to(FAR * high)
    return first.both(held), (third - 3.0 * first).both(3.0 * (held - held))
