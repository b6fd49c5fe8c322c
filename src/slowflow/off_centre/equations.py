"""What vanishes off the centre, as `boxes` takes it: in go a force as steps and a forcing, out come equations.

Fold       f_0 = c_1 F_A = F = 0    in A, B and t, at a forcing, of an odd force without a load; Omega follows
Resting    f_0 = 0                  in B, at A = 0
Detaching  f_0 = 0                  in A, where the motion comes to an end of the first piece
"""

from __future__ import annotations

from typing import Any

import numpy as np

from slowflow.intervals import Interval
from slowflow.model import Floats
from slowflow.off_centre.boxes import Ints
from slowflow.off_centre.means import ALL, Means, Steps
from slowflow_kernels import off_centre, off_centre_intervals


def _square(rows: Any, d: int) -> tuple[Any, Any]:
    """Values and slopes from a kernel's outputs."""
    values, slopes = rows[:d], rows[d:]
    return values, [slopes[d * i : d * (i + 1)] for i in range(d)]


def ends_of(rows: Any, d: int, n: int) -> tuple[Floats, Floats]:
    """Values (2, d, n) and slopes (d, d, 2, n) from a kernel's outputs on intervals."""
    values, slopes = _square(
        [row.ends + np.zeros((2, n)) if isinstance(row, Interval) else np.full((2, n), row) for row in rows], d
    )
    return np.stack(values, axis=1), np.stack([np.stack(row, axis=1) for row in slopes], axis=1)


def numbers_of(rows: Any, d: int, n: int) -> tuple[Floats, Floats]:
    """Values (d, n) and slopes (d, d, n) from a kernel's outputs."""
    values, slopes = _square([row + np.zeros(n) for row in rows], d)
    return np.stack(values), np.stack([np.stack(row) for row in slopes])


def interval_of(x: Floats, r: Floats) -> Interval:
    """x +- r; not rounded outwards: neighbouring boxes are made of the same ends."""
    return Interval(np.array((x - r, x + r)))


class Resting:
    """Where the mass stands when nothing moves it."""

    def __init__(self, steps: Steps) -> None:
        self.steps = steps

    def limits(self, of: Ints) -> tuple[Any, Any]:
        """See `boxes.Equations`."""
        return -np.inf, np.inf

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        means = self.steps.on(Interval(np.zeros((2, of.size))), interval_of(x[0], r[0]), 1)
        return (means.c[0] - self.steps.load).ends[:, np.newaxis], means.c[1].ends[:, np.newaxis, np.newaxis]

    def at(self, x: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        means = self.steps.at(np.zeros(of.size), x[0], 1)
        return (means.c[0] - self.steps.load)[np.newaxis], means.c[1][np.newaxis, np.newaxis]


class Detaching:
    """Where the motion reaches an end of the first piece: in A, system 0 the upper one, system 1 the lower one."""

    def __init__(self, steps: Steps) -> None:
        self.steps, (self.lower, self.upper) = steps.first(), steps.inner

    def offset(self, A: Floats, of: Ints) -> Floats:
        """B there."""
        return np.where(of == 0, self.upper - A, self.lower + A)

    def limits(self, of: Ints) -> tuple[Any, Any]:
        """See `boxes.Equations`."""
        return 0.0, np.inf

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        A, below = interval_of(x[0], r[0]), of == 0
        B = (self.upper - A).where(below, A + self.lower)
        means = self.steps.on(A, B, 1)
        slope = (means.s[1] - means.c[1]).where(below, means.s[1] + means.c[1])
        return (means.c[0] - self.steps.load).ends[:, np.newaxis], slope.ends[:, np.newaxis, np.newaxis]

    def at(self, x: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        means = self.steps.at(x[0], self.offset(x[0], of), 1)
        slope = means.s[1] - np.where(of == 0, 1.0, -1.0) * means.c[1]
        return (means.c[0] - self.steps.load)[np.newaxis], slope[np.newaxis, np.newaxis]


class Fold:
    """At forcings (k,), of an odd force without a load; system i is that of forcing i.

    Motions about the centre have solvers of their own, and are left out; where those lose their stability others begin,
    and all three equations vanish. What is just at a jump of the force is left out too.
    """

    def __init__(self, steps: Steps, m: float, zeta: float, F_0: Floats) -> None:
        self.steps, self.m, self.zeta, self.F_0 = steps, m, zeta, F_0

    def limits(self, of: Ints) -> tuple[Any, Any]:
        """See `boxes.Equations`."""
        return np.array([[0.0], [-np.inf], [-np.inf]]), np.inf

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        A, B, t = (interval_of(*pair) for pair in zip(x, r, strict=True))
        means = self.steps.on(A, B, 2)
        F_0 = Interval(np.array((self.F_0[of],) * 2))
        m, zeta, load = (Interval.point(value) for value in (self.m, self.zeta, self.steps.load))
        values, slopes = ends_of(
            off_centre_intervals.fold_by_t(t, A, F_0, m, zeta, load, *means.c, *means.s), 3, of.size
        )
        beside, none = self._beside_centre(A, B, means)
        resists = [one.both(beside) for one in self.steps.resists(A, B, means)]
        turns = [
            off_centre_intervals.turns(t, A, F_0, m, one, means.s[0]).ends.reshape(2, -1) + np.zeros((2, of.size))
            for one in resists
        ]
        none |= np.logical_and.reduce([(one[0] > 0) | (one[1] < 0) for one in turns])
        last = np.where(none, 1.0, ALL)
        return np.concatenate((values, last[:, np.newaxis]), axis=1), slopes

    def _beside_centre(self, A: Interval, B: Interval, means: Means) -> tuple[Interval, Any]:
        """What `resists` is off the centre on boxes that touch it, and which of these hold no motion off it.

        Where f_0/B vanishes, c_1 between 0 and B has no sign.
        """
        ends = np.full((2, A.lo.size), ALL)
        touches = (B.lo <= 0) & (B.hi >= 0)
        some = np.flatnonzero(touches & ~means.c[1].has_sign)
        if some.size:
            A_, B_ = A.take(some), B.take(some)
            near = self.steps.on(A_, B_, 3)
            beside = off_centre_intervals.beside(B_, near.c[3], near.s[2])
            ends[:, some] = np.where(near.c[3].has_sign, beside.ends, ends[:, some])
        return Interval(ends), touches & means.c[1].has_sign

    def at(self, x: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        means = self.steps.at(x[0], x[1], 2)
        given = (self.F_0[of], self.m, self.zeta, self.steps.load)
        return numbers_of(off_centre.fold_by_t(x[2], x[0], *given, *means.c, *means.s), 3, of.size)
