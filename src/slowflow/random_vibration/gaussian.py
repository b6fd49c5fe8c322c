"""Gaussian averages of a restoring force. Takes the force and root mean squares of u; returns the equivalent stiffness.

By Gauss's rule on parts of each piece of the force, see `native/exact/gaussian.h`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from slowflow.backend import EXACT
from slowflow.exact import compiled
from slowflow.intervals import Interval
from slowflow.mechanism import EquationOfMotion, Floats, Force

#: |u|/sigma up to which a Gaussian motion is looked at
FAR = 10.0
#: where f/u is sampled, beside the size of the force, how often, and by how much of its range it may be off between
WIDE, SAMPLES, APART = 1e8, 2000, 0.01


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
    handle = compiled.handle(EquationOfMotion(force, 0.0, 0.0))
    found = np.frombuffer(EXACT.averages(handle, np.ascontiguousarray(sigma))).reshape(-1, 6).T
    return Averages(found[1:3] / sigma**2, found[3:5] / sigma**2, found[5])


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
