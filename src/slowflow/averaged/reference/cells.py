"""Cells: two amplitudes of one piece of the force in, what h and its derivatives are on all of the interval out.

On each piece h_AAA is monotone: the derivation proves it (derivations/monotone.py). So its values at the ends bound it,
and what is known of a slope bounds the function between two of its values. Of a force of which that is not proved it is
h_AAAA that is enclosed. Where the force or its slope jumps, the derivatives of h tend to infinity as A falls to the
breakpoint: that is the sample at the beginning of a piece.
k = h - A h_A is where the tangent of h meets A = 0. As in native/cells.h.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from slowflow.averaged.reference.enclosed import enclosed
from slowflow.averaged.reference.roots import Ints, taken
from slowflow.intervals import Interval
from slowflow.model import Floats, Model
from slowflow_kernels import slow_flow, slow_flow_intervals
from slowflow_kernels.conventions import CANCELLED, DOUBT, FAR_ABOVE


@dataclass(frozen=True, eq=False)
class Samples:
    """The averaged force at amplitudes.

    rows -- array (7, n): A, h, h_A, h_AA, h_AAA, k, and which of the designs abreast it is of
    """

    rows: Floats

    def take(self, which: Any) -> Samples:
        """Some of them."""
        return Samples(self.rows[:, which])

    def __len__(self) -> int:
        return int(self.rows.shape[1])

    @property
    def A(self) -> Floats:
        return np.asarray(self.rows[0])

    @property
    def h(self) -> Floats:
        return np.asarray(self.rows[1])

    @property
    def h_A(self) -> Floats:
        return np.asarray(self.rows[2])

    @property
    def h_AA(self) -> Floats:
        return np.asarray(self.rows[3])

    @property
    def h_AAA(self) -> Floats:
        return np.asarray(self.rows[4])

    @property
    def k(self) -> Floats:
        return np.asarray(self.rows[5])

    @property
    def of(self) -> Ints:
        return np.asarray(self.rows[6], dtype=np.intp)

    def size_of_R(self, Omega: Floats) -> Floats:
        """What rounding may leave of R at frequencies, over a rounding."""
        return np.asarray(np.abs(self.h) + self.A * np.abs(self.h_A) + self.A * Omega**2)


def joined(*parts: Samples) -> Samples:
    """All of them, in order."""
    return Samples(np.concatenate([part.rows for part in parts], axis=1))


def samples_at(model: Model, A: Any, of: Any = 0) -> Samples:
    """At amplitudes of any number; k without what cancels in it, where it has lost digits as a difference.

    of -- which of the designs abreast each is of
    """
    A = np.array(A, dtype=float, ndmin=1)
    rows = np.empty((7, A.size))
    rows[0], rows[6] = A, of
    own = model.take(of)
    for row, value in zip(rows[1:5], own.averaged(A), strict=True):
        row[...] = value
    _, h, h_A, h_AA, _, k, _ = rows
    # at A = 0 a slope that is infinite there takes nothing off h
    k[...] = np.where(A > 0, slow_flow.intercept(A, h, h_A, h_AA)[0], h)
    lost = (np.abs(k) < CANCELLED * np.abs(h)).nonzero()
    if lost[0].size:
        k[lost] = model.mechanism.intercept(A[lost], *(taken(one, lost) for one in own.parameters))
    return Samples(rows)


def sample_above(model: Model, i: int, of: Any = 0) -> Samples:
    """The limit from above at breakpoint i: the force's jump makes h_A infinite there, a jump of its slope h_AA.

    of -- of which of the designs abreast: each has the same jumps
    """
    b, jump = taken(model.breakpoints[i], of), taken(model.jumps[i], of)
    slope, curvature = model.kinks[i]
    at = samples_at(model, b, of)
    jumps = np.any(model.jumps[i])
    if not jumps:
        beyond = samples_at(model, np.nextafter(b, np.inf), of).rows
    if not jumps and not np.any(slope):
        beyond[0] = b
        if np.any(curvature):
            beyond[4] = np.copysign(np.inf, beyond[4] - at.h_AAA)
        return Samples(beyond)
    rows = at.rows.copy()
    if jumps:
        rows[2] = rows[4] = np.copysign(np.inf, jump)
        rows[3] = rows[5] = -rows[2]
    else:
        rows[3] = np.copysign(np.inf, beyond[3] - at.h_AA)
        rows[4] = -rows[3]
    return Samples(rows)


@dataclass(frozen=True, eq=False)
class Stretch:
    """A piece of the force, from its first amplitude (0 or a breakpoint, as its own side has it) to its last.

    Of designs abreast, that of each which comes to it.

    base -- where the piece begins, which may be below its first amplitude
    """

    first: Samples
    last: Samples
    base: Floats

    @property
    def has_force(self) -> bool:
        """Whether there is any on it."""
        return bool(self.first.rows[1:6].any() or self.last.rows[1:6].any())


def stretches_up_to(model: Model, A_max: Any) -> list[Stretch]:
    """All pieces up to an amplitude; of designs abreast each has its own."""
    everyone = np.arange(model.abreast)
    A_max = np.broadcast_to(A_max, everyone.shape)
    ends = [np.broadcast_to(b, everyone.shape) for b in model.breakpoints]
    beyond = [np.flatnonzero(b < A_max) for b in ends]
    of = [everyone, everyone, *beyond]
    at = samples_at(model, np.concatenate((0.0 * everyone, A_max, *map(np.take, ends, beyond))), np.concatenate(of))
    start, highest, *at_ends = (
        Samples(rows) for rows in np.split(at.rows, np.cumsum([len(one) for one in of])[:-1], 1)
    )
    firsts = [start, *(sample_above(model, i, those) for i, those in enumerate(beyond) if those.size)]
    found = []
    for i, first in enumerate(firsts):
        last = highest.take(first.of)
        if i + 1 < len(firsts):
            last.rows[:, np.isin(first.of, beyond[i])] = at_ends[i].rows
        found.append(Stretch(first, last, first.A))
    return found


def between(f_a: Floats, f_b: Floats, slope: Interval, width: Floats) -> Interval:
    """A function between two of its values whose slope is known."""
    lo, hi = slope.ends
    no_low, no_high = lo == -np.inf, hi == np.inf
    x_below = np.maximum(0, np.minimum(width, (f_b - f_a - hi * width) / (lo - hi)))
    x_above = np.maximum(0, np.minimum(width, (f_b - f_a - lo * width) / (hi - lo)))
    below = np.where(no_low, f_b - hi * width, f_a + lo * np.where(no_high, width, x_below))
    above = np.where(no_low, f_a + hi * width, np.where(no_high, f_b - lo * width, f_a + hi * x_above))
    doubt = DOUBT * (np.abs(f_a) + np.abs(f_b))
    monotone = (lo >= 0) | (hi <= 0)
    known = (lo < 0) & (hi > 0) & ~(no_low & no_high)
    low = np.where(monotone, np.minimum(f_a, f_b), np.where(known, below - doubt, -np.inf))
    high = np.where(monotone, np.maximum(f_a, f_b), np.where(known, above + doubt, np.inf))
    return Interval(np.array((low, high)))


def doubtful(f: Floats, A: Floats, slope: Floats) -> Interval:
    """What holds a kernel's value."""
    doubt = _doubt(f, A, slope)
    return Interval.of(f - doubt, f + doubt)


def _doubt(f: Floats, A: Floats, slope: Floats) -> Floats:
    """By how much a kernel may err: relatively, and as if its argument were a rounding away; a limit does not."""
    doubt = DOUBT * (np.abs(f) + A * np.abs(slope))
    relative = np.where(np.isinf(f), 0.0, DOUBT * np.abs(f))
    return np.asarray(np.where(doubt < np.inf, doubt, relative))


@dataclass(frozen=True, eq=False)
class Cells:
    """What h and its derivatives are on intervals of A.

    rows -- array (7, 2, n): the ends of A, h, h_A, h_AA, h_AAA, k, k_A
    first -- samples where the piece of each begins
    """

    rows: Floats
    first: Samples

    @property
    def of(self) -> Ints:
        """Which of the designs abreast each is of."""
        return self.first.of

    def take(self, which: Any) -> Cells:
        """Some of them."""
        return Cells(self.rows[..., which], self.first.take(which))

    def twice(self) -> Cells:
        """All of them, and all of them again, for questions with two channels."""
        return Cells(np.concatenate((self.rows, self.rows), axis=-1), joined(self.first, self.first))

    def __len__(self) -> int:
        return int(self.rows.shape[-1])

    @property
    def A(self) -> Interval:
        return Interval(self.rows[0])

    @property
    def h(self) -> Interval:
        return Interval(self.rows[1])

    @property
    def h_A(self) -> Interval:
        return Interval(self.rows[2])

    @property
    def h_AA(self) -> Interval:
        return Interval(self.rows[3])

    @property
    def h_AAA(self) -> Interval:
        return Interval(self.rows[4])

    @property
    def k(self) -> Interval:
        return Interval(self.rows[5])

    @property
    def k_A(self) -> Interval:
        return Interval(self.rows[6])


def cells_of(model: Model, a: Samples, b: Samples, first: Samples) -> Cells:
    """From samples at the ends, by rising A, and where their pieces begin."""
    width = b.A - a.A

    def along(f_a: Floats, f_b: Floats, slope_a: Floats, slope_b: Floats, slope: Interval) -> Interval:
        # both ends in doubt, below and above, at once
        d_a, d_b = _doubt(f_a, a.A, slope_a), _doubt(f_b, b.A, slope_b)
        doubled = between(
            np.concatenate((f_a - d_a, f_a + d_a)),
            np.concatenate((f_b - d_b, f_b + d_b)),
            Interval(np.concatenate((slope.ends, slope.ends), axis=1)),
            np.concatenate((width, width)),
        )
        n = len(a)
        return Interval(np.array((doubled.ends[0, :n], doubled.ends[1, n:])))

    A = Interval(np.array((a.A, b.A)))
    if model.mechanism.enclosed is None:
        h_AAA = Interval.hull(a.h_AAA, b.h_AAA)
    else:
        bend = enclosed(model, a.A, b.A)[1]
        h_AAA = along(a.h_AAA, b.h_AAA, bend.lo, bend.hi, bend)
    h_AA = along(a.h_AA, b.h_AA, a.h_AAA, b.h_AAA, h_AAA)
    h_A = along(a.h_A, b.h_A, a.h_AA, b.h_AA, h_AA)
    h = along(a.h, b.h, a.h_A, b.h_A, h_A)
    _, k_A = slow_flow_intervals.intercept(A, h, h_A, h_AA)
    k = along(a.k, b.k, a.A * a.h_AA, b.A * b.h_AA, k_A)
    return Cells(np.array([one.ends for one in (A, h, h_A, h_AA, h_AAA, k, k_A)]), first)


def amid(base: Floats, a: Floats, b: Floats) -> Floats:
    """Amplitudes well inside: halfway in the coordinate in which h is smooth, in orders of magnitude if there are many.

    base -- where the piece begins
    """
    p, q = a / base, b / base
    r = 0.5 * (np.sqrt((p - 1) * (p + 1)) + np.sqrt((q - 1) * (q + 1)))
    # far above the base the coordinate is A itself, and the square of A / base may overflow
    near = (base > 0) & (a < FAR_ABOVE * base)
    middle = np.where(near, base + base * (r * r / (1 + np.sqrt(1 + r * r))), 0.5 * (a + b))
    return np.where(a == 0, 0.125 * b, np.where(b > 4 * a, np.sqrt(a) * np.sqrt(b), middle))
