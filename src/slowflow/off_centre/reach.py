"""How far motions go at a forcing. Takes a force as steps and damping; returns the farthest, and that none is beyond.

A point of the balance is a steady state at F_0 if its least forcing, over all Omega, does not exceed F_0. With p = -h/A
that is the least of A^2 (Omega^2 - p)^2 + (4 mu/pi + 2 zeta A Omega)^2, whose root is L(A, p). Both squares rise with
A, and so does L. Where p > 0 the least is at Omega^2 <= p, as a higher Omega makes both squares larger than sqrt(p)
does; there, and at Omega = 0 where p < 0, the first square rises with |p|, and so does L. So L at the least A and the
least |p| of a box is below that of all its motions, and no frequency has to be looked for.

`farthest` cuts the cells of the balance (`solution_sheets`) and leaves those in which it does not hold, those that need
more than F_0, and those that are nearer than a motion that is known. Motions with c_1 = df_0/dB > 0 are looked at, as
those are of which stable ones are.

`transmits_beyond` goes on in the same way with the motions beyond a frequency that transmit all of F_0, Omega^2 <= 2 p:
their frequencies lie between the two, and what F is there, and by which sign it changes with A, is known on boxes. Of a
share of F_0 another frequency is the last, and what is transmitted is known on boxes as well.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from slowflow.core.intervals import Interval
from slowflow.core.mechanism import Flags
from slowflow.core.model import Floats
from slowflow.off_centre.flow import ROUNDED, Flow, Slow
from slowflow.off_centre.solution_sheets import Cells, Sheets
from slowflow.support.errors import NotSettled
from slowflow.support.text import Sentence
from slowflow_kernels.conventions import HIGHEST_OMEGA

#: share of the farthest beyond which it is proved that no motion goes
GAP = 2.0**-24
#: boxes that are looked at in all; middles of boxes from which motions are looked for, and steps of Newton's method
MOST_BOXES, MIDDLES, STEPS = 100_000, 64, 10
#: rounds after which it is looked for them again
EVERY = 6
#: share of a frequency beyond which it is proved that nothing transmits the force; boxes and rounds for that
BEYOND, MOST_BEYOND, ROUNDS = 2.0**-16, 20_000, 80
#: parts of a range of frequencies, and how often what is left of it is cut into parts again
DIVISIONS, NARROWED = 8, 5
#: share of the forcing that motions are small against
SMALL = 2.0**-40
#: by how much a forcing may be off by rounding
AT = 2.0**-40


@dataclass(frozen=True)
class Transmissibility:
    """A transmissibility, and a bound of the frequencies at which motions reach it.

    ratio, last -- which, and a frequency beyond which none with |h| <= steepest A transmits it
    """

    ratio: float
    last: float
    steepest: float


@dataclass(frozen=True)
class Farthest:
    """The motion at F_0 that goes farthest, and how far; `turns` where it could at a lower forcing too.

    Then the balance turns back there, and the motion is told to `GAP` only.
    """

    value: float
    Omega: float
    A: float
    B: float
    turns: bool


class Measure(NamedTuple):
    """How far a motion goes: at A, B and p, and what that does not exceed on boxes of these."""

    at: Callable[[Floats, Floats, Floats], Floats]
    most: Callable[[Interval, Interval, Interval], Floats]


#: the amplitude; the largest |u|; the square of the frequency on the backbone, where that is not below 1
AMPLITUDE = Measure(lambda A, B, p: A, lambda A, B, p: A.hi)
NO_FREQUENCY = Sentence(
    "the largest motion is unresolved: double precision does not resolve the frequency at which {A = :g}"
)
LARGEST = Measure(lambda A, B, p: A + np.abs(B), lambda A, B, p: A.hi + np.maximum(-B.lo, B.hi))
BACKBONE = Measure(lambda A, B, p: np.maximum(p, 1.0), lambda A, B, p: np.maximum(p.hi, 1.0))


class Reach:
    """For one force with its load, by what excites and dissipates, zeta > 0."""

    def __init__(self, sheets: Sheets, flow: Flow, A_max: Callable[[float], float]) -> None:
        self.sheets, self.steps, self.flow, self._A_max = sheets, sheets.steps, flow, A_max

    def farthest(self, F_0: float, measure: Measure) -> Farthest | None:
        """The motion at F_0 up to `A_max` that goes farthest; no other goes farther by more than `GAP` of that.

        None where no motion is found. Raises ArithmeticError where too many boxes stay undecided.
        """
        return self._farthest(F_0, measure, GAP, 0.0)[0]

    def highest_backbone(self, F_0: float, gap: float) -> float:
        """The square of a frequency, 1 at least, that the backbone does not exceed at any motion at F_0, nearly.

        Next to where two pieces meet at rest p is as its slopes make it down to no size at all: there it is not known
        which of them it takes.
        """
        found, bound = self._farthest(F_0, BACKBONE, gap, SMALL * F_0)
        return max(1.0 if found is None else found.value, bound)

    def _farthest(self, F_0: float, measure: Measure, gap: float, small: float) -> tuple[Farthest | None, float]:
        """The same, and a bound for motions that are no larger than `small`, which are not told apart."""
        bound = -np.inf
        best, looked_at, rounds = None, 0, 0
        cells = self.sheets.cells(self._A_max(F_0), partial(self._may_move, F_0=F_0))
        while cells.chart.size:
            looked_at, rounds = looked_at + cells.chart.size, rounds + 1
            if looked_at > MOST_BOXES:
                raise NotSettled("the largest motion is unresolved: too many boxes stay undecided")
            with np.errstate(all="ignore"):
                most = measure.most(cells.A, cells.B, cells.p)
                left = self._may_move(cells, F_0)
                # p is not known of what has no size
                left &= np.isnan(most) | (most > (-np.inf if best is None else best.value * (1 + gap)))
                aside = left & (LARGEST.most(cells.A, cells.B, cells.p) <= small) & np.isfinite(most)
                bound = max(bound, float(np.max(most[aside], initial=-np.inf)))
                left &= ~aside
                cells, most = cells.take(left), most[left]
                # a motion that is found in one round mostly stays the farthest in the next ones
                first = np.argsort(-most, kind="stable")[: MIDDLES if rounds % EVERY == 1 else 0]
                x, y = 0.5 * (cells.low + cells.high)[:, first]
                motions = np.stack(self.sheets.charts.motion(x, y, cells.chart[first]))
                found = self._motions(motions, F_0, measure) if first.size else None
                if found is not None and (best is None or found.value > best.value):
                    best = found
                cells = self.sheets.cut(cells)
        return best, bound

    def _may_move(self, cells: Cells, F_0: float) -> Flags:
        """Which cells may hold a motion at F_0 that is stable."""
        return np.asarray((cells.rising.hi > 0) & (self.flow.needed(cells.A, cells.p) * (1 - ROUNDED) <= F_0))

    def transmits_beyond(
        self, F_0: float, Omega: float, limit: Transmissibility | None = None
    ) -> tuple[float, float] | None:
        """Between which frequencies beyond Omega stable motions at F_0 may transmit it; None: proved, nowhere.

        What is nearer to Omega than by `BEYOND` of it is not looked at.
        """
        least = (Omega * (1 + BEYOND)) ** 2
        may = partial(self._may_transmit, F_0=F_0, least=least, limit=limit)
        cells, looked_at = self.sheets.cells(self._A_max(F_0), may), 0
        for _ in range(ROUNDS):
            cells = cells.take(may(cells))
            looked_at += cells.chart.size
            if not cells.chart.size:
                return None
            if looked_at > MOST_BEYOND:
                break
            with np.errstate(all="ignore"):
                cells = self.sheets.cut(cells)
        return Omega, math.sqrt(2 * max(float(cells.p.hi.max()), 0.0)) if limit is None else limit.last

    def _may_transmit(self, cells: Cells, F_0: float, least: float, limit: Transmissibility | None) -> Flags:
        """Which cells may hold a stable motion at F_0 with least <= Omega^2 <= 2 p, or that transmits `limit`."""
        with np.errstate(all="ignore"):
            highest = 2 * cells.p.hi * (1 + ROUNDED)
            if limit is not None:
                highest = np.where(cells.p.lo >= -limit.steepest, limit.last**2, float(HIGHEST_OMEGA) ** 2)
            none = ~self._may_move(cells, F_0) | (highest < least)
            start = np.full(none.size, least * (1 - ROUNDED))
            end = np.maximum(highest, start)
            shares = np.arange(DIVISIONS + 1)[:, np.newaxis] / DIVISIONS
            # ever less of the range of Omega^2
            for _ in range(NARROWED):
                edges = start + shares * (end - start)
                may = np.array([self._may_at(cells, F_0, *ends, limit) for ends in pairwise(edges)])
                none |= ~may.any(axis=0)
                first, last = np.argmax(may, axis=0), DIVISIONS - np.argmax(may[::-1], axis=0)
                n = np.arange(none.size)
                start, end = np.where(none, start, edges[first, n]), np.where(none, end, edges[last, n])
        return np.asarray(~none)

    def _may_at(self, cells: Cells, F_0: float, low: Floats, high: Floats, limit: Transmissibility | None) -> Flags:
        """Which of them may have Omega^2 between two numbers each."""
        square = Interval.of(low * (1 - ROUNDED), high * (1 + ROUNDED))
        at = square.sqrt()
        R, (I, I_A) = cells.A * (square - cells.p), self.flow.balances(at, cells.A)
        level, force = R.square() + I.square(), self.flow.force(F_0, at.ends) ** 2
        # F_A along the balance
        rises = R * (square - cells.p - cells.e) + I * I_A
        beyond = (level.lo > force[1] * (1 + ROUNDED)) | (level.hi < force[0] * (1 - ROUNDED))
        if limit is not None:
            beyond |= ((cells.A * cells.p).square() + I.square()).hi < limit.ratio**2 * force[0] * (1 - ROUNDED)
        return np.asarray(~(beyond | (rises.hi < 0)))

    def _motions(self, x: Floats, F_0: float, measure: Measure) -> Farthest | None:
        """The farthest that is found from some places: where all of F_0 is needed, and on the balance near by."""
        turns = np.repeat([False, True], x.shape[1])
        x = np.concatenate((x, x), axis=1)
        for _ in range(STEPS):
            x = x - self._step(x, F_0, turns)
        A, B = x
        there = np.isfinite(A) & np.isfinite(B) & (A > 0)
        A, B, turns = A[there], B[there], turns[there]
        if not A.size:
            return None
        means = self.steps.at(A, B, 1)
        level, Omega = self.flow.least_forcing(A, -2 * means.s[0])
        size = np.abs(means.c[1]) * (A + np.abs(B)) + abs(self.steps.load)
        holds = (np.abs(means.c[0] - self.steps.load) <= AT * size) & (means.c[1] > 0)
        holds &= np.where(turns, level <= F_0, np.abs(level - F_0) <= AT * F_0)
        if not holds.any():
            return None
        value = np.where(holds, measure.at(A, B, 2 * means.s[0] / A), -np.inf)
        k = int(np.argmax(value))
        at = float(Omega[k]) if not turns[k] else self._highest(A[k : k + 1], -2 * means.s[0][k : k + 1], F_0)
        return Farthest(float(value[k]), at, float(A[k]), float(B[k]), bool(turns[k]))

    def _step(self, x: Floats, F_0: float, turns: Flags) -> Floats:
        """Newton's, for f_0 = 0 and the least forcing F_0, or for f_0 = 0 at an amplitude where it `turns`.

        Where it is the least, F does not change with Omega.
        """
        means, slow = self.steps.at(x[0], x[1], 1), Slow(self.steps, self.flow, F_0)
        _, Omega = self.flow.least_forcing(x[0], -2 * means.s[0])
        f_0, _, _, f_B, _, _ = state = slow.state(Omega, x, means)
        return np.where(turns, np.stack((0 * f_0, f_0 / f_B)), slow.step(state))

    def _highest(self, A: Floats, h: Floats, F_0: float) -> float:
        """The highest frequency of a state. Raises ArithmeticError where rounding leaves none."""
        found = self.flow.frequencies(A, h, F_0)
        if np.isnan(found).all():
            raise NotSettled(NO_FREQUENCY.format(float(A[0])))
        return float(np.nanmax(found))
