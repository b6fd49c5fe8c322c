"""Means over a cycle of a force and its derivatives, c_n = <f^(n)> and s_n = <f^(n) cos psi>, along u = B + A cos psi.

In:  the force as a sum of steps (derivations/asymmetric/off_centre.py), A and B.
Out: c_n and s_n. Every step adds D_k L_(k-n) to c_n, and D_k M_(k-n) to s_n. On boxes `turning_points` holds them.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations, pairwise
from typing import Any

import numpy as np

from slowflow.core import validate
from slowflow.core.backend import SOLVER
from slowflow.core.mechanism import Flags, Mechanism
from slowflow.core.model import Floats
from slowflow.off_centre.curved import Curved, Formula, Part
from slowflow.off_centre.smooth import SINGULAR, Beyond, check, outwards
from slowflow.support.errors import NotSettled, Refused
from slowflow.support.text import Sentence, text
from slowflow_kernels import off_centre

NO_MEANS = Sentence("{name:s}: offset motions are not derived for a force {what:s}")
NEXT_TO_REST = text("a force without the jump at {u} = 0 that its formula allows has no gradients for offset motions")
JUMPS = text("that jumps at {u} = 0, as a preload does")
NO_EXTENT = text("whose first piece ends at {u} = 0, with another piece that is not a polynomial")
NOT_SMOOTH = "with a piece that is neither a polynomial nor known to be smooth up to its ends"

UNBOUNDED = "the outermost piece of the force does not grow: offset motions are unbounded there"

#: derivatives of the force that are asked for at most, as `off_centre.averaged` does
ORDERS = 3
#: most steps of Newton's method; relative to A, the length of its last step, and of one that shows that it converges
STEPS, SETTLED, BALANCED = 8, 2.0**-48, 2.0**-30
#: how near to a step, relative to A + |B|, a motion reaches it but does not pass it
REACHED = 2.0**-40
#: places at which a piece is looked at to bound it
GRID = 64
#: by how much a problem is taken to be larger than the longest length of its force
SMALL = 4.0


@dataclass(frozen=True, eq=False)
class Means:
    """c_n and s_n for n = 0, 1, ..., arrays of numbers."""

    c: tuple[Any, ...]
    s: tuple[Any, ...]


IN_DEAD_ZONE = Sentence(
    "in a dead zone the mean is arbitrary: the force equals the load, {load:g}, for all {u[0]:g} < {u} < {u[1]:g}, "
    "where the mass may rest, or move, about any point"
)


class Steps:
    """A force as steps: the piece about u = 0, which all of a motion is above, and one at each end on its side.

    Of an odd force the ends for u > 0 are stated, each of which has a step on either side. Of one that is no polynomial
    the steps are what it and its slope gain at its ends, and `curved` is all else.

    Raises ValueError where a piece of the force is not smooth, or nothing is derived of it.

    breakpoints -- the ends, as they are stated
    places, sides, gains -- where steps are, outwards from u = 0, on which side, and what derivatives gain there; the
                   first is that of all u, then come those on the right
    pieces -- by rising u, the derivatives of each that has an extent by its formula at u = 0
    inner, about -- between which u the piece about u = 0 holds, and its number as they are stated
    """

    curved: Curved | None = None
    #: of a force that is no polynomial, above and below
    beyond: tuple[Beyond, Beyond] | None = None

    def __init__(self, mechanism: Mechanism, parameters: tuple[float, ...], load: float) -> None:
        self.load, self.odd = load, mechanism.odd
        self.breakpoints = ends = np.array([float(end) for end in mechanism.breakpoints(*parameters)])
        below, above = (-ends, ends) if self.odd else (ends[ends < 0], ends[ends >= 0])
        self.inner = float(below.max(initial=-math.inf)), float(above.min(initial=math.inf))
        self.about = 0 if self.odd else below.size
        if mechanism.steps is None:
            first, gains = np.zeros(2), self._state_curved(mechanism, parameters)
        else:
            values = np.array([float(value) for value in mechanism.steps(*parameters)])
            rows = values.reshape(ends.size + 2 if self.odd else 2 * ends.size + 1, -1)
            first, gains = rows[self.about], rows[1:-1] if self.odd else rows[ends.size + 1 :]
            self.pieces = self._both_sides(rows) if self.odd else rows[: ends.size + 1]
        #: of an odd force the odd part of its first piece is one for all u; what else that has is a step at 0
        right, at_0 = np.arange(self.about, ends.size), [-1] * bool(self.odd and first[::2].any())
        left = right if self.odd else np.arange(self.about)
        self._end_of = np.array([-1, *at_0, *right, *at_0, *left])
        self.sides = np.array([1.0] * (1 + len(at_0) + right.size) + [-1.0] * (len(at_0) + left.size))
        self.highest = first.size - 1
        self.positions, self.gains = self.by_step(ends), self._gained(first, gains)
        self._of_c, self._of_s = self._weights()

    @property
    def length(self) -> float:
        """The longest length of a piecewise polynomial: an end, or where two powers, or one and the load, are equal.

        Infinite where it has none, as a linear force, and of a force that is no polynomial.
        """
        if self.curved is not None:
            return math.inf
        found = [abs(float(end)) for end in self.breakpoints if end]
        for row in np.abs(self.pieces):
            known = [k for k in range(1, row.size) if row[k] > 0]
            size = [float(row[k]) / math.factorial(k) for k in known]
            for i, j in combinations(range(len(known)), 2):
                found.append((size[i] / size[j]) ** (1 / (known[j] - known[i])))
            if known[-1:] > [1]:
                found += [(abs(self.load) / one) ** (1 / k) for one, k in zip(size, known, strict=True) if self.load]
        return max(found, default=math.inf)

    @property
    def size(self) -> float:
        """What the problem is as large as: 1, or less where the force's lengths all are, its load and its ends."""
        ends: list[float] = np.abs(self.breakpoints).tolist()
        return max(min(1.0, SMALL * self.length), abs(self.load), *ends)

    @property
    def settled(self) -> float:
        """The |u| from which on the force is nowhere the load. Raises ValueError where it does not grow."""
        if self.beyond is None:
            roots = (_root_bound(outer, self.load) for outer in (self.pieces[-1], self.pieces[0]))
            return max(*roots, *map(abs, map(float, self.breakpoints)))
        if math.isinf(found := max(one.settled for one in self.beyond)):
            raise Refused(UNBOUNDED)
        return found

    @property
    def grown(self) -> float:
        """Amplitudes at which a force that is no polynomial is beyond any forcing."""
        return math.inf if self.beyond is None else max(one.grown for one in self.beyond)

    def check_balanced(self) -> None:
        """Raises ArithmeticError where the force is the load on a whole interval of u, as in a dead zone."""
        if self.curved is not None or self.odd:
            return
        edges = [-math.inf, *self.breakpoints.tolist(), math.inf]
        for row, low, high in zip(self.pieces, edges, edges[1:], strict=False):
            if row[0] == self.load and not row[1:].any():
                raise NotSettled(IN_DEAD_ZONE.format(self.load, (low, high)))

    def reached(self, A: Any, B: Any) -> int:
        """The number of the step to which an end of one motion is nearest, 0 where there is none."""
        return int(np.argmin(np.append(np.inf, np.abs(self.positions - self.sides * B - A)[1:])))

    def passed(self, A: Any, B: Any) -> Flags:
        """Which steps one motion passes."""
        (low, high), whole = short_of(A, B), np.arange(self.positions.size) == 0
        return np.asarray(whole | (self.positions < np.where(self.sides > 0, high, -low)))

    def within(self, A: Any, B: Any) -> Steps:
        """The means of the pieces alone that one motion passes, the outermost as if they held everywhere beyond."""
        other, own = copy.copy(self), self.passed(A, B)
        other.positions, other.sides, other.gains = self.positions[own], self.sides[own], self.gains[own]
        other._of_c, other._of_s = other._weights()
        other.curved = None if self.curved is None else self.curved.within(*short_of(A, B))
        return other

    def by_step(self, ends: Floats) -> Floats:
        """What is known of each end, along the last axis, by steps as these count: outwards; 0 at u = 0."""
        none = np.zeros((*ends.shape[:-1], 1))
        return np.asarray(np.append(ends, none, axis=-1)[..., self._end_of] * (1.0 if self.odd else self.sides))

    def _gained(self, first: Floats, gains: Floats) -> Floats:
        """Rows of steps from that of the piece about u = 0 and those of ends, (..., orders) and (..., ends, orders)."""
        even = np.where(np.arange(first.shape[-1]) % 2 == 0, first, 0.0) if self.odd else np.zeros_like(first)
        rows = np.append(gains, even[..., np.newaxis, :], axis=-2)[..., self._end_of, :]
        rows[..., 0, :] = first - even
        # on the left it is -f(-u) that is gained
        return rows if self.odd else np.where(self.sides[:, np.newaxis] < 0, -_turned(rows), rows)

    def by_parameter(self, mechanism: Mechanism, parameters: tuple[float, ...]) -> Floats:
        """What each parameter does to the gains of the steps, u held fixed: (parameters, steps, orders).

        Raises NotAvailable where that adds a step at u = 0.
        """
        count, ends = len(parameters), self.breakpoints.size
        if mechanism.steps_by is None:
            assert mechanism.curved is not None
            gains = np.array([float(one) for one in mechanism.curved.gained_by(*parameters)])
            return self._gained(np.zeros((count, 2)), gains.reshape(ends, count, 2).swapaxes(0, 1))
        rows = np.array([float(one) for one in mechanism.steps_by(*parameters)])
        rows = rows.reshape(count, 2 * ends + 1, self.highest + 1)
        first = rows[:, self.about]
        if self.odd and (self._end_of < 0).sum() == 1 and first[:, ::2].any():
            raise validate.NotAvailable(NEXT_TO_REST)
        return self._gained(first, rows[:, ends + 1 :])

    def _both_sides(self, rows: Floats) -> Floats:
        """All pieces of an odd force, from what is stated for u > 0: its first, what each end gains, its last."""
        right = [rows[0]]
        for end, gained in zip(self.breakpoints[:-1], rows[1:-2], strict=True):
            right.append(right[-1] + _about(gained, -float(end)))
        right = [*right, rows[-1]][: 1 + self.breakpoints.size]
        #: the odd part of the last piece, which holds everywhere but for what is bounded
        self._last, self._even = rows[-1], np.where(np.arange(rows.shape[1]) % 2 == 1, 0.0, rows[-1])
        self._deviations = [self._bound(n, right) for n in range(ORDERS)]
        #: of derivatives the size of the terms that they are made of, at breakpoints too
        most, far = np.abs(rows).max(axis=0), float(self.breakpoints.max(initial=0.0))
        sizes = [
            sum(most[j] * far ** (j - k) / math.factorial(j - k) for j in range(k, most.size)) for k in range(most.size)
        ]
        self._sizes = np.array(sizes)
        empty = bool(self.breakpoints.size and self.breakpoints[0] == 0)
        right = right[empty:]  # a first piece that ends at 0 is none
        return np.array([*map(_turned, right[: None if empty or rows[0, ::2].any() else 0 : -1]), *right])

    def _state_curved(self, mechanism: Mechanism, parameters: tuple[float, ...]) -> Floats:
        """Of a force that is no polynomial all but its steps, and what it and its slope gain at its ends."""
        stated, ends = mechanism.curved, self.breakpoints
        if stated is None:
            jumps = mechanism.odd and float(mechanism.pieces[0].force(0.0, *parameters)) != 0
            raise validate.NotAvailable(NO_MEANS.format(mechanism.name, JUMPS if jumps else NOT_SMOOTH))
        if mechanism.odd and ends.size and ends[0] == 0:
            raise validate.NotAvailable(NO_MEANS.format(mechanism.name, NO_EXTENT))
        gains = own = np.array([float(one) for one in stated.gained(*parameters)]).reshape(-1, 3)
        laws = [
            (Formula(partial(_law, one, parameters), partial(_enclosed, other, parameters)), False)
            for one, other in zip(stated.pieces, stated.held, strict=True)
        ]
        if mechanism.odd:
            laws = [*((formula, True) for formula, _ in laws[:0:-1]), *laws]
            ends, gains = np.concatenate((-ends[::-1], ends)), np.concatenate((gains[::-1] * (1, -1, 1), gains))
        about = int((ends < 0).sum())
        self.pieces = lines = _lines(ends, gains)
        pieces = [Part(*law, (float(a), float(b))) for law, (a, b) in zip(laws, lines, strict=True)]

        def complain(number: int) -> Callable[[float], str]:
            own = number - about if mechanism.odd else number
            return lambda u: SINGULAR.format(mechanism.name, abs(own) + 1, u)

        for number, (low, high) in enumerate(pairwise(ends.tolist()), start=1):
            check(pieces[number], low, high, complain(number))
        size = max(1.0, abs(self.load), *map(abs, ends))
        starts = (-ends[0], ends[-1]) if ends.size else (0.0, 0.0)
        self.beyond = (
            outwards(pieces[-1], 1.0, float(starts[1]), size, self.load, complain(len(pieces) - 1)),
            outwards(pieces[0], -1.0, float(starts[0]), size, self.load, complain(0)),
        )
        self.curved = Curved(pieces, ends, gains[:, 2], (-self.beyond[1].wall, self.beyond[0].wall))
        return own[:, :2]

    def curved_by(
        self, mechanism: Mechanism, parameters: tuple[float, ...], of_parameters: Floats
    ) -> list[Curved | None]:
        """The sensitivity of the rest of the force to each number of the design; None for a piecewise polynomial.

        of_parameters -- that of the parameters of the force, (parameters, numbers)
        """
        stated, known = mechanism.curved, self.curved
        found: list[Curved | None] = []
        if stated is None or known is None:
            return [None] * len(mechanism.design)
        own, count = self.breakpoints.size, len(parameters)
        gained = np.array([float(one) for one in stated.gained_by(*parameters)]).reshape(own, count, 2)
        for slopes in of_parameters.T:
            gains = np.einsum("p,epk->ek", slopes, gained)
            laws = [partial(_combined, piece, slopes, parameters) for piece in stated.moved]
            if mechanism.odd:
                gains, laws = np.concatenate((gains[::-1] * (1, -1), gains)), [*laws[:0:-1], *laws]
            lines = zip(laws, known.pieces, _lines(known.ends, gains), strict=True)
            moving = [Part(Formula(law), part.mirrored, (float(a), float(b))) for law, part, (a, b) in lines]
            found.append(Curved(moving, known.ends, np.zeros(known.ends.size), known.walls, ORDERS))
        return found

    def _weights(self) -> tuple[Floats, Floats]:
        """What c_n and s_n take of L_j and M_j of each step, j from -ORDERS on: (ORDERS + 1, steps, j)."""
        weights = np.zeros((2, ORDERS + 1, self.positions.size, ORDERS + self.highest + 1))
        for n in range(ORDERS + 1):
            weights[:, n, :, ORDERS - n : ORDERS - n + self.highest + 1] = self.gains
            # on the left it is -f(-u), and -cos psi
            weights[0, n] *= (self.sides ** (n + 1))[:, np.newaxis]
            weights[1, n] *= (self.sides**n)[:, np.newaxis]
        return weights[0], weights[1]

    def _bound(self, n: int, right: list[Floats]) -> float:
        """A bound of the n-th derivative of what the force has beside the base up to its last breakpoint."""
        most = 0.0
        for (at, end), piece in zip(pairwise([0.0, *self.breakpoints.tolist()]), right, strict=False):
            # its derivatives where the piece begins, less the base's
            values, width = _about(piece - (self._last - self._even), at)[n:], end - at
            grid = np.linspace(0.0, width, GRID + 1)
            powers = [grid**k / math.factorial(k) for k in range(values.size)]
            slopes = [width**k / math.factorial(k) for k in range(max(values.size - 1, 0))]
            steep = float(np.abs(values[1:]) @ np.array(slopes)) if slopes else 0.0
            on_grid = float(np.max(np.abs(values @ np.array(powers)))) if values.size else 0.0
            most = max(most, on_grid + steep * width / GRID)
        return most * (1 + 2.0**-40)

    def at(self, A: Floats, B: Floats, orders: int) -> Means:
        """At numbers A > 0 and B of one shape (n,)."""
        L, M = self._ladders(A, B)
        c = tuple(self._summed(self._of_c[n], L) for n in range(orders + 1))
        s = tuple(self._summed(self._of_s[n], M) for n in range(orders + 1))
        if self.curved is None:
            return Means(c, s)
        others = self.curved.at(A, B, orders)
        return Means(*(tuple(map(np.add, *both)) for both in zip((c, s), others, strict=True)))

    def balanced(self, x: Floats) -> tuple[Floats, Flags]:
        """Where the mean is balanced next to A and B, (2, n), and whether Newton's method comes there."""
        for _ in range(STEPS):
            means = self.at(x[0], x[1], 1)
            slope = np.stack((means.s[1], means.c[1]))
            change = slope * (means.c[0] - self.load) / (slope * slope).sum(axis=0)
            x = x - change
            if not (np.abs(change) > SETTLED * np.abs(x[0])).any():
                break
        return x, np.asarray((np.abs(change) <= BALANCED * x[0]).all(axis=0))

    def averaged(self, A: Floats, B: Floats) -> tuple[Means, tuple[Floats, ...]]:
        """All means, and h, h_A, h_AA, h_AAA along the balance."""
        means = self.at(A, B, ORDERS)
        with np.errstate(all="ignore"):
            return means, off_centre.averaged(A, *means.c[1:], *means.s)

    def sensitivity(
        self, A: Floats, B: Floats, gains: Floats, positions: Floats, curved: Curved | None = None
    ) -> Means:
        """The change of c_n and s_n with the gains, at constant u, and positions of the steps: n below `ORDERS`.

        curved -- the change of the rest of a force that is no polynomial

        A step whose position changes adds what it gains there, and nothing else: -D_0 L_(-n-1) and -D_0 M_(-n-1).
        """
        other = copy.copy(self)
        other.gains = gains
        L, M = self._ladders(A, B)
        found = []
        for ladder, weights, power in zip((L, M), other._weights(), (1, 0), strict=True):
            for n in range(ORDERS):
                weights[n, :, ORDERS - n - 1] -= self.sides ** (n + power) * positions * self.gains[:, 0]
            found.append(tuple(self._summed(weights[n], ladder) for n in range(ORDERS)))
        if curved is None:
            return Means(*found)
        others = curved.at(A, B, ORDERS - 1)
        return Means(*(tuple(map(np.add, *both)) for both in zip(found, others, strict=True)))

    def _summed(self, weights: Floats, ladder: Floats) -> Floats:
        used = weights != 0
        return np.asarray(weights[used] @ ladder[used])

    def _ladders(self, A: Floats, B: Floats) -> tuple[Floats, Floats]:
        """L_j and M_j of every step, j from -ORDERS on: (steps, j, n)."""
        a = self.positions[:, np.newaxis] - self.sides[:, np.newaxis] * B
        whole, room = np.arange(self.positions.size)[:, np.newaxis] == 0, np.empty(ORDERS + self.highest + 1)
        L, M = SOLVER.step_means(A, a, whole, ORDERS, room)
        return L.transpose(0, 2, 1), M.transpose(0, 2, 1)


def short_of(A: Any, B: Any) -> tuple[Any, Any]:
    """Between which displacements motions are, less what rounding may bring beyond an end that they just reach."""
    inner = A - REACHED * (A + np.abs(B))
    return B - inner, B + inner


def _lines(ends: Floats, gains: Floats) -> Floats:
    """What steps that gain so much, and so much slope, at these ends are on each piece by rising u: a + b u."""
    about = int((ends < 0).sum())
    lines = np.zeros((ends.size + 1, 2))
    shares = np.stack((gains[:, 0] - gains[:, 1] * ends, gains[:, 1]), axis=1)
    lines[about + 1 :] = np.cumsum(shares[about:], axis=0)
    lines[:about] = -np.cumsum(shares[:about][::-1], axis=0)[::-1]
    return lines


def _law(kernel: Any, parameters: tuple[float, ...], u: Floats) -> Any:
    return kernel(u, *parameters)


def _combined(kernels: Sequence[Any], slopes: Floats, parameters: tuple[float, ...], u: Floats) -> Any:
    """The same of several laws, each times a slope."""
    terms = [
        (slope, kernel(u, *parameters))
        for kernel, slope in zip(kernels, slopes.tolist(), strict=True)
        if slope and kernel
    ]
    return [sum(slope * values[n] for slope, values in terms) for n in range(ORDERS)]


def _enclosed(kernel: Any, parameters: tuple[float, ...], make: Any, u: Any) -> Any:
    return kernel(make.around, u, *map(make.point, parameters))


def _root_bound(derivatives: Floats, load: float) -> float:
    """What |u| does not exceed where a polynomial with these derivatives at u = 0 is the load."""
    last = np.abs(np.trim_zeros(derivatives, "b")).tolist()
    if (n := len(last) - 1) < 1:
        raise Refused(UNBOUNDED)
    size = [value / math.factorial(k) for k, value in enumerate(last[:-1])]
    size[0] += abs(load)
    ratio: list[float] = [value * math.factorial(n) / last[n] for value in size]
    # Cauchy's bound; the sum of the n-th roots holds them too, and is less for small ones
    return float(min(1.0 + max(ratio), 2 * max(value ** (1 / (n - k)) for k, value in enumerate(ratio))))


def _turned(derivatives: Floats) -> Floats:
    """Of -f(-u), along the last axis."""
    return np.asarray(-((-1.0) ** np.arange(derivatives.shape[-1])) * derivatives)


def _about(derivatives: Floats, at: float) -> Floats:
    """Of a polynomial with these derivatives at 0 those at another place."""
    n = derivatives.size
    power = [at**k / math.factorial(k) for k in range(n)]
    return np.array([sum(derivatives[j] * power[j - k] for j in range(k, n)) for k in range(n)])
