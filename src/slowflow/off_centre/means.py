"""Means over a cycle of a force and its derivatives, c_n = <f^(n)> and s_n = <f^(n) cos psi>, along u = B + A cos psi.

In:  the force as a sum of steps (derivations/asymmetric/off_centre.py), A and B.
Out: c_n and s_n. Every step adds D_k L_(k-n) to c_n, and D_k M_(k-n) to s_n. On boxes `ends` holds them.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import combinations, pairwise
from typing import Any

import numpy as np

from slowflow import validate
from slowflow.backend import SOLVER
from slowflow.intervals import Elementary
from slowflow.mechanism import Mechanism
from slowflow.model import Floats
from slowflow.off_centre.curved import Curved, Part
from slowflow.off_centre.smooth import SINGULAR, Beyond, check, outwards
from slowflow.text import Sentence, text
from slowflow_support.errors import NotSettled

NO_MEANS = Sentence("{name:s}: motions off the centre are not derived for a force {what:s}")
JUMPS = text("that jumps at {u} = 0, as a preload does")
NOT_SMOOTH = "of which a piece is no polynomial, nor known to be smooth up to its ends"

#: derivatives of the force that are asked for at most, as `off_centre.averaged` does
ORDERS = 3
#: of an interval that holds all numbers
ALL = np.array([[-np.inf], [np.inf]])
#: places at which a piece is looked at to bound it
GRID = 64
#: by how much a problem is taken to be larger than the longest length of its force
SMALL = 4.0


@dataclass(frozen=True, eq=False)
class Means:
    """c_n and s_n for n = 0, 1, ..., arrays of numbers."""

    c: tuple[Any, ...]
    s: tuple[Any, ...]


IN_PLAY = Sentence(
    "in a play a mean is not singled out: the force is the load, {load:g}, on all of {u[0]:g} < {u} < {u[1]:g}, where "
    "the mass rests, and moves, about one place as well as about another"
)


class Steps:
    """A force as steps: the first piece, which all of a motion is above, and at each breakpoint one on either side.

    A force that is not odd has the piece about u = 0 first, and a step at each of its own breakpoints. Of one that is
    no polynomial the steps are what it and its slope gain at its breakpoints, and `curved` is all else.

    Raises ValueError where a piece of the force is not smooth, or nothing is derived of it.
    """

    curved: Curved | None = None
    #: of a force that is no polynomial, above and below
    beyond: tuple[Beyond, Beyond] | None = None
    #: and what each parameter does to it: to what it and its slope gain at its breakpoints, and to all else
    by_parameter: tuple[tuple[Floats, Curved], ...] = ()

    def __init__(self, mechanism: Mechanism, parameters: tuple[float, ...], load: float) -> None:
        ends = np.array([float(end) for end in mechanism.breakpoints(*parameters)])
        if mechanism.steps is None:
            self._state_curved(mechanism, parameters, ends, load)
            return
        values = np.array([float(value) for value in mechanism.steps(*parameters)])
        if mechanism.odd:
            self._state(ends, values.reshape(ends.size + 2, -1), load)
        else:
            rows = values.reshape(2 * ends.size + 1, -1)
            self._state_sided(ends, rows[: ends.size + 1], rows[ends.size + 1 :], load)

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

    def check_balanced(self) -> None:
        """Raises ArithmeticError where the force is the load on a whole interval of u, as in a play."""
        if self.curved is not None or self.odd:
            return
        edges = [-math.inf, *self.breakpoints.tolist(), math.inf]
        for row, low, high in zip(self.pieces, edges, edges[1:], strict=False):
            if row[0] == self.load and not row[1:].any():
                raise NotSettled(IN_PLAY.format(self.load, (low, high)))

    def first(self) -> Steps:
        """The first piece alone, as if it held everywhere."""
        other = Steps.__new__(Steps)
        if self.curved is not None:
            other._state_sided(np.empty(0), np.zeros((1, 2)), np.empty((0, 2)), self.load)
            other.curved = self.curved.first()
        elif self.odd:
            other._state(np.empty(0), np.stack((self._rows[0], self._rows[0])), self.load)
        else:
            other._state_sided(np.empty(0), self.gains[:1], np.empty((0, self.highest + 1)), self.load)
        return other

    def _state(self, ends: Floats, rows: Floats, load: float) -> None:
        """From the breakpoints and a row of derivatives for each of the steps, and for the last piece."""
        self.load, self.odd = load, True
        self.breakpoints = ends
        self.highest = rows.shape[1] - 1
        #: between which u the first piece holds, and beyond all breakpoints the force on the right and on the left
        self.inner = (-float(ends[0]), float(ends[0])) if ends.size else (-math.inf, math.inf)
        self.outer: tuple[Floats, ...] = (rows[-1],)
        odd = np.arange(self.highest + 1) % 2 == 1
        #: the odd part of the first piece is one for all u; what else it has for u > 0 is a step at 0
        first = np.where(odd, 0.0, rows[0])
        steps = rows[1:-1] if not first.any() else np.concatenate((first[np.newaxis], rows[1:-1]))
        places = ends if not first.any() else np.array([0.0, *ends])
        #: where they are, and on which side; the first is that of all u
        self.places = np.array([0.0, *places, *places])
        self.sides = np.array([1.0] * (places.size + 1) + [-1.0] * places.size)
        self.gains = np.concatenate((np.where(odd, rows[0], 0.0)[np.newaxis], steps, steps))
        self._rows = rows
        self._of_c, self._of_s = self._weights()
        mirrored = -((-1.0) ** np.arange(self.highest + 1))
        right = [rows[0]]
        for end, gained in zip(ends[:-1], rows[1:-2], strict=True):
            right.append(right[-1] + _about(gained, -float(end)))
        right = [*right, rows[-1]][: 1 + ends.size]
        #: pieces by rising u, the derivatives of each at u = 0
        self.pieces = np.array([*(mirrored * row for row in right[: None if first.any() else 0 : -1]), *right])
        #: the odd part of the last piece, which holds everywhere but for what is bounded
        self._last = rows[-1]
        self._even = np.where(odd, 0.0, rows[-1])
        self._beside = [self._bound(n) for n in range(ORDERS)]
        #: of derivatives the size of the terms that they are made of, at breakpoints too
        most, far = np.abs(rows).max(axis=0), float(ends.max(initial=0.0))
        sizes = [
            sum(most[j] * far ** (j - k) / math.factorial(j - k) for j in range(k, most.size)) for k in range(most.size)
        ]
        self._sizes = np.array(sizes)

    def _state_sided(self, ends: Floats, pieces: Floats, gains: Floats, load: float) -> None:
        """From rows of derivatives: of each piece at u = 0, by rising u, and of what is gained at each breakpoint."""
        self.load, self.odd = load, False
        self.breakpoints = ends
        self.highest = pieces.shape[1] - 1
        #: on the left it is -f(-u) that is gained there, as of a force that is odd
        mirrored = (-1.0) ** np.arange(self.highest + 1)
        right, about = ends >= 0, int((ends < 0).sum())
        self.inner = (
            float(ends[about - 1]) if about else -math.inf,
            float(ends[about]) if about < ends.size else math.inf,
        )
        self.outer = (pieces[-1], -mirrored * pieces[0])
        self.pieces = pieces
        self.places = np.array([0.0, *ends[right], *-ends[~right]])
        self.sides = np.array([1.0] * (1 + int(right.sum())) + [-1.0] * about)
        self.gains = np.concatenate((pieces[about : about + 1], gains[right], gains[~right] * mirrored))
        self._of_c, self._of_s = self._weights()

    def _state_curved(self, mechanism: Mechanism, parameters: tuple[float, ...], ends: Floats, load: float) -> None:
        """Of a force that is no polynomial, from what it and its slope gain at its ends."""
        stated = mechanism.curved
        if stated is None:
            jumps = mechanism.odd and float(mechanism.pieces[0].force(0.0, *parameters)) != 0
            raise validate.NotAvailable(NO_MEANS.format(mechanism.name, JUMPS if jumps else NOT_SMOOTH))
        gains = np.array([float(one) for one in stated.gained(*parameters)]).reshape(-1, 3)
        laws = [
            (partial(_law, one, parameters), partial(_held, other, parameters), False)
            for one, other in zip(stated.pieces, stated.held, strict=True)
        ]
        if mechanism.odd:
            laws = [*((law, held, True) for law, held, _ in laws[:0:-1]), *laws]
            ends, gains = np.concatenate((-ends[::-1], ends)), np.concatenate((gains[::-1] * (1, -1, 1), gains))
        about = int((ends < 0).sum())
        lines = _lines(ends, gains)
        self._state_sided(ends, lines, gains[:, :2], load)
        parts = [Part(*law, (float(a), float(b))) for law, (a, b) in zip(laws, lines, strict=True)]
        self.odd = mechanism.odd
        if mechanism.odd:
            self.breakpoints = ends[about:]

        def complain(number: int) -> Callable[[float], str]:
            own = number - about if mechanism.odd else number
            return lambda u: SINGULAR.format(mechanism.name, abs(own) + 1, u)

        for number, (low, high) in enumerate(pairwise(ends.tolist()), start=1):
            check(parts[number], low, high, complain(number))
        size = max(1.0, abs(load), *map(abs, ends))
        starts = (-ends[0], ends[-1]) if ends.size else (0.0, 0.0)
        self.beyond = (
            outwards(parts[-1], 1.0, float(starts[1]), size, load, complain(len(parts) - 1)),
            outwards(parts[0], -1.0, float(starts[0]), size, load, complain(0)),
        )
        self.curved = Curved(parts, ends, gains[:, 2], (-self.beyond[1].wall, self.beyond[0].wall))
        self._state_moved(mechanism, parameters, parts)

    def _state_moved(self, mechanism: Mechanism, parameters: tuple[float, ...], parts: list[Part]) -> None:
        """What each parameter does to such a force."""
        stated, count, known = mechanism.curved, len(parameters), self.curved
        assert stated is not None and known is not None
        own = known.ends.size // 2 if mechanism.odd else known.ends.size
        gained = np.array([float(one) for one in stated.gained_by(*parameters)]).reshape(own, count, 2)
        for number in range(count):
            gains, laws = gained[:, number], [partial(_law, piece[number], parameters) for piece in stated.moved]
            if mechanism.odd:
                gains, laws = np.concatenate((gains[::-1] * (1, -1), gains)), [*laws[:0:-1], *laws]
            lines = zip(laws, parts, _lines(known.ends, gains), strict=True)
            moved = [Part(law, None, part.mirrored, (float(a), float(b))) for law, part, (a, b) in lines]
            self.by_parameter += ((gains, Curved(moved, known.ends, np.zeros(known.ends.size), known.walls)),)

    def _weights(self) -> tuple[Floats, Floats]:
        """What c_n and s_n take of L_j and M_j of each step, j from -ORDERS on: (ORDERS + 1, steps, j)."""
        weights = np.zeros((2, ORDERS + 1, self.places.size, ORDERS + self.highest + 1))
        for n in range(ORDERS + 1):
            weights[:, n, :, ORDERS - n : ORDERS - n + self.highest + 1] = self.gains
            # on the left it is -f(-u), and -cos psi
            weights[0, n] *= (self.sides ** (n + 1))[:, np.newaxis]
            weights[1, n] *= (self.sides**n)[:, np.newaxis]
        return weights[0], weights[1]

    def _bound(self, n: int) -> float:
        """A bound of the n-th derivative of what the force has beside the base up to its last breakpoint."""
        ends, most = [0.0, *self.breakpoints], 0.0
        for piece in range(self.breakpoints.size):
            # its derivatives where the piece begins, less the base's
            at = ends[piece]
            values = np.array([self._derivative(j, piece, at) for j in range(n, self.highest + 1)])
            width = ends[piece + 1] - at
            grid = np.linspace(0.0, width, GRID + 1)
            powers = [grid**k / math.factorial(k) for k in range(values.size)]
            slopes = [width**k / math.factorial(k) for k in range(max(values.size - 1, 0))]
            steep = float(np.abs(values[1:]) @ np.array(slopes)) if slopes else 0.0
            on_grid = float(np.max(np.abs(values @ np.array(powers)))) if values.size else 0.0
            most = max(most, on_grid + steep * width / GRID)
        return most * (1 + 2.0**-40)

    def _derivative(self, n: int, piece: int, at: float) -> float:
        """Of the n-th derivative of a piece what it has beside the base, at u = `at` > 0."""
        total = 0.0
        for place, row in zip((0.0, *self.breakpoints), self._rows[: 1 + piece], strict=False):
            total += sum(row[k] * (at - place) ** (k - n) / math.factorial(k - n) for k in range(n, row.size))
        odd = self._last - self._even
        return float(total - sum(odd[k] * at ** (k - n) / math.factorial(k - n) for k in range(n, odd.size)))

    def at(self, A: Floats, B: Floats, orders: int) -> Means:
        """At numbers A > 0 and B of one shape (n,)."""
        L, M = self._ladders(A, B)
        c = tuple(self._summed(self._of_c[n], L) for n in range(orders + 1))
        s = tuple(self._summed(self._of_s[n], M) for n in range(orders + 1))
        if self.curved is None:
            return Means(c, s)
        others = self.curved.at(A, B, orders)
        return Means(*(tuple(map(np.add, *both)) for both in zip((c, s), others, strict=True)))

    def moved(self, A: Floats, B: Floats, gains: Floats, places: Floats, curved: Curved | None = None) -> Means:
        """What c_n and s_n do as the gains move, u held fixed, and the places of the steps: n below `ORDERS`.

        curved -- what moves beside the steps, of a force that is no polynomial

        A step whose place moves adds what it gains there, and nothing else: -D_0 L_(-n-1) and -D_0 M_(-n-1).
        """
        other = copy.copy(self)
        other.gains = gains
        L, M = self._ladders(A, B)
        found = []
        for ladder, weights, power in zip((L, M), other._weights(), (1, 0), strict=True):
            for n in range(ORDERS):
                weights[n, :, ORDERS - n - 1] -= self.sides ** (n + power) * places * self.gains[:, 0]
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
        a = self.places[:, np.newaxis] - self.sides[:, np.newaxis] * B
        whole, room = np.arange(self.places.size)[:, np.newaxis] == 0, np.empty(ORDERS + self.highest + 1)
        L, M = SOLVER.step_means(A, a, whole, ORDERS, room)
        return L.transpose(0, 2, 1), M.transpose(0, 2, 1)


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


def _held(kernel: Any, parameters: tuple[float, ...], u: Elementary) -> Any:
    return kernel(Elementary.point, u, *map(Elementary.point, parameters))


def _about(derivatives: Floats, at: float) -> Floats:
    """Of a polynomial with these derivatives at 0 those at another place."""
    n = derivatives.size
    power = [at**k / math.factorial(k) for k in range(n)]
    return np.array([sum(derivatives[j] * power[j - k] for j in range(k, n)) for k in range(n)])
