"""What vanishes off the centre, as `boxes` takes it: in go a force as steps and a forcing, out come equations.

State      f_0 = F = 0              in A and B, at frequencies and a forcing
Past       f_0 = F = 0              in psi and A, of motions that pass a jump of the force, just by too
Fold       f_0 = c_1 F_A = F = 0    in A, B and t, at a forcing; Omega follows
Touching   f_0 = F = 0              in A and t, at a forcing, of motions that just touch a jump of the force
Resting    f_0 = 0                  in B, at A = 0
Detaching  f_0 = 0                  in A, where the motion comes to an end of the first piece
"""

from __future__ import annotations

from typing import Any

import numpy as np

from slowflow.averaged.reference.intervals import Interval
from slowflow.model import Floats
from slowflow.off_centre.boxes import Ints
from slowflow.off_centre.means import ALL, DOUBT, Means, Steps
from slowflow_kernels import off_centre, off_centre_intervals


def _square(rows: Any, d: int) -> tuple[Any, Any]:
    """Values and slopes from a kernel's outputs."""
    values, slopes = rows[:d], rows[d:]
    return values, [slopes[d * i : d * (i + 1)] for i in range(d)]


def _ends(rows: Any, d: int, n: int) -> tuple[Floats, Floats]:
    """The same of intervals, as arrays."""
    values, slopes = _square(
        [row.ends + np.zeros((2, n)) if isinstance(row, Interval) else np.full((2, n), row) for row in rows], d
    )
    return np.stack(values, axis=1), np.stack([np.stack(row, axis=1) for row in slopes], axis=1)


def _numbers(rows: Any, d: int, n: int) -> tuple[Floats, Floats]:
    values, slopes = _square([row + np.zeros(n) for row in rows], d)
    return np.stack(values), np.stack([np.stack(row) for row in slopes])


def _interval(x: Floats, r: Floats) -> Interval:
    """x +- r; not rounded outwards: neighbouring boxes are made of the same ends."""
    return Interval(np.array((x - r, x + r)))


class State:
    """At frequencies (k,) and a forcing F_0; system i is that of frequency i."""

    positive = True

    def __init__(self, steps: Steps, m: float, zeta: float, Omega: Floats, F_0: float) -> None:
        self.steps, self.m, self.zeta, self.Omega, self.F_0 = steps, m, zeta, Omega, F_0

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        A, B = _interval(x[0], r[0]), _interval(x[1], r[1])
        means = self.steps.on(A, B, 1)
        Omega = Interval(np.array((self.Omega[of],) * 2))
        given = (Interval.point(value) for value in (self.F_0, self.m, self.zeta, self.steps.load))
        return _ends(off_centre_intervals.state(Omega, A, *given, *means.c, *means.s), 2, of.size)

    def at(self, x: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        means = self.steps.at(x[0], x[1], 1)
        given = (self.F_0, self.m, self.zeta, self.steps.load)
        return _numbers(off_centre.state(self.Omega[of], x[0], *given, *means.c, *means.s), 2, of.size)


class Past:
    """As `State`, of motions that pass one step, at the angle psi: in psi and A, B = side (a_step - A cos psi).

    Next to a jump of the force f_0 and F go as the root of how far a motion passes it, and are smooth in psi: what the
    jump adds to c_0 is side D_0 psi/pi, and to s_0 it is D_0 sin(psi)/pi.
    """

    positive = True

    def __init__(self, state: State, step: int) -> None:
        self.state, self.step = state, step
        self.place, self.side, self.D_0 = (
            float(of[step]) for of in (state.steps.places, state.steps.sides, state.steps.gains[:, 0])
        )

    def offset(self, psi: Floats, A: Floats) -> Floats:
        """B there."""
        return np.asarray(self.side * (self.place - A * np.cos(psi)))

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        psi, A = _interval(x[0], r[0]), _interval(x[1], r[1])
        about = 1 + np.array([[-DOUBT], [DOUBT]])
        sine, cosine = Interval(np.sin(psi.ends) * about), Interval(np.cos(psi.ends[::-1]) * about)
        B = (self.place - A * cosine) * self.side
        means = self.state.steps.past_on(self.step, psi, sine, A, B)
        state, point = self.state, Interval.point
        given = (point(value) for value in (state.F_0, state.m, state.zeta, state.steps.load))
        Omega = Interval(np.array((state.Omega[of],) * 2))
        share = Interval(np.sort(about * self.D_0 / np.pi, axis=0))
        rows = self._rows(off_centre_intervals.state, (Omega, A, *given), sine, cosine, share, means)
        return _ends(rows, 2, of.size)

    def at(self, x: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        psi, A = x
        means = self.state.steps.past(self.step, psi, np.sin(psi), A, self.offset(psi, A))
        state = self.state
        given = (state.Omega[of], A, state.F_0, state.m, state.zeta, state.steps.load)
        rows = self._rows(off_centre.state, given, np.sin(psi), np.cos(psi), self.D_0 / np.pi, means)
        return _numbers(rows, 2, of.size)

    def _rows(
        self, state: Any, given: tuple[Any, ...], sine: Any, cosine: Any, share: Any, means: Means
    ) -> tuple[Any, ...]:
        """f_0 and F, and their slopes by psi and A: the kernel's by B and A, with the means' slopes by psi and A.

        dB/dpsi = side A sin(psi) and dB/dA = -side cos(psi), with which c_1 and s_1 lose their poles.
        """
        A, (c_0, c_1), (s_0, s_1) = given[1], means.c, means.s
        by_psi = ((A * sine * c_1 + share) * self.side, A * sine * s_1 * self.side + cosine * share)
        # d s_0/dA has -s_0/A, which the kernel adds
        by_A = (s_1 - cosine * c_1 * self.side, c_1 - cosine * s_1 * self.side + sine / A * share)
        f_0, F, _, f_psi, _, F_psi = state(*given, c_0, by_psi[0], s_0, by_psi[1])
        _, _, f_A, _, F_A, _ = state(*given, c_0, by_A[1], s_0, by_A[0])
        return f_0, F, f_psi, f_A, F_psi, F_A


class Resting:
    """Where the mass stands when nothing moves it."""

    positive = False

    def __init__(self, steps: Steps) -> None:
        self.steps = steps

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        means = self.steps.on(Interval(np.zeros((2, of.size))), _interval(x[0], r[0]), 1)
        return (means.c[0] - self.steps.load).ends[:, np.newaxis], means.c[1].ends[:, np.newaxis, np.newaxis]

    def at(self, x: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        means = self.steps.at(np.zeros(of.size), x[0], 1)
        return (means.c[0] - self.steps.load)[np.newaxis], means.c[1][np.newaxis, np.newaxis]


class Detaching:
    """Where the motion reaches an end of the first piece: in A, system 0 the upper one, system 1 the lower one."""

    positive = True

    def __init__(self, steps: Steps) -> None:
        self.steps, (self.lower, self.upper) = steps.first(), steps.inner

    def offset(self, A: Floats, of: Ints) -> Floats:
        """B there."""
        return np.where(of == 0, self.upper - A, self.lower + A)

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        A, below = _interval(x[0], r[0]), of == 0
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
    """At forcings (k,); system i is that of forcing i. What is just at a jump of the force is left to `Touching`.

    centred -- whether motions about the centre, which have solvers of their own, are left out: of an odd force without
               a load. Where those lose their stability others begin, and all three equations vanish
    """

    positive = True

    def __init__(self, steps: Steps, m: float, zeta: float, F_0: Floats, *, centred: bool) -> None:
        self.steps, self.m, self.zeta, self.F_0, self.centred = steps, m, zeta, F_0, centred

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        A, B, t = (_interval(*pair) for pair in zip(x, r, strict=True))
        means = self.steps.on(A, B, 2)
        F_0 = Interval(np.array((self.F_0[of],) * 2))
        m, zeta, load = (Interval.point(value) for value in (self.m, self.zeta, self.steps.load))
        values, slopes = _ends(off_centre_intervals.fold(t, A, F_0, m, zeta, load, *means.c, *means.s), 3, of.size)
        resists: tuple[Interval, ...] = self.steps.resists(A, B, means)
        none = np.zeros(of.size, dtype=bool)
        if self.centred:
            beside, none = self._beside_centre(A, B, means)
            resists = tuple(one.both(beside) for one in resists)
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
        return _numbers(off_centre.fold(x[2], x[0], *given, *means.c, *means.s), 3, of.size)


class Touching:
    """At one forcing, of motions that come to one step and no farther: in A and t, B follows."""

    positive = True

    def __init__(self, steps: Steps, step: int, m: float, zeta: float, F_0: float) -> None:
        self.steps, self.m, self.zeta, self.F_0 = steps.touching(step), m, zeta, F_0
        self.place, self.side = float(steps.places[step]), float(steps.sides[step])

    def offset(self, A: Any) -> Any:
        """B there."""
        return (self.place - A) * self.side

    def on(self, x: Floats, r: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        A, t = _interval(x[0], r[0]), _interval(x[1], r[1])
        means = self.steps.on(A, self.offset(A), 2)
        given = (Interval.point(value) for value in (self.F_0, self.m, self.zeta, self.steps.load))
        values, slopes = _ends(off_centre_intervals.fold(t, A, *given, *means.c, *means.s), 3, of.size)
        by_A = [(Interval(slopes[:, i, 0]) - Interval(slopes[:, i, 1]) * self.side).ends for i in (0, 2)]
        return values[:, ::2], np.stack((np.stack(by_A, axis=1), slopes[:, ::2, 2]), axis=2)

    def at(self, x: Floats, of: Ints) -> tuple[Floats, Floats]:
        """See `boxes.Equations`."""
        means = self.steps.at(x[0], self.offset(x[0]), 2)
        given = (self.F_0, self.m, self.zeta, self.steps.load)
        values, slopes = _numbers(off_centre.fold(x[1], x[0], *given, *means.c, *means.s), 3, of.size)
        return values[::2], np.stack((slopes[::2, 0] - self.side * slopes[::2, 1], slopes[::2, 2]), axis=1)
