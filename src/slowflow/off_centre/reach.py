"""How far motions go at a forcing. Takes a force as steps and damping; returns the farthest, and that none is beyond.

A point of the balance is a steady state at F_0 if its least forcing, over all Omega, does not exceed F_0. With p = -h/A
that is the least of A^2 (Omega^2 - p)^2 + (4 mu/pi + 2 zeta A Omega)^2, whose root is L(A, p). Both squares rise with
A, and so does L. Where p > 0 the least is at Omega^2 <= p, as a higher Omega makes both squares larger than sqrt(p)
does; there, and at Omega = 0 where p < 0, the first square rises with |p|, and so does L. So L at the least A and the
least |p| of a box is below that of all its motions, and no frequency has to be looked for.

`farthest` cuts the cells of the balance (`solution_sheets`) and leaves those in which it does not hold, those that need
more than F_0, and those that are nearer than a motion that is known. Motions with c_1 = df_0/dB > 0 are looked at, as
those are of which stable ones are.

`last_transmitting` goes on in the same way with the motions at F_0 that transmit a level. Their frequency is explicit
in A and p (slowflow/averaged/isolating.py); it rises with p and falls with A, so that corners of a box bound it, and
with it what is transmitted.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np

from slowflow.averaged.isolating import Level, up_to
from slowflow.core.intervals import ALL, Interval
from slowflow.core.mechanism import Flags
from slowflow.core.model import Floats
from slowflow.off_centre.flow import ROUNDED, Flow, Slow
from slowflow.off_centre.solution_sheets import Cells, Sheets
from slowflow.support.errors import NotSettled
from slowflow.support.text import Sentence

#: share of the farthest beyond which it is proved that no motion goes
GAP = 2.0**-24
#: boxes that are looked at in all; middles of boxes from which motions are looked for, and steps of Newton's method
MOST_BOXES, MIDDLES, STEPS = 100_000, 64, 10
#: rounds after which it is looked for them again
EVERY = 3
#: share of a frequency beyond which it is proved that nothing transmits a level
BEYOND = 2.0**-16
#: by how much A and B change for the slopes of a frequency, relative to A + |B|: only the speed of Newton's method
#: depends on it
NEAR = 2.0**-26
#: by how much a forcing may be off by rounding
AT = 2.0**-40


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
    """How far a motion goes: at A and B, and what that does not exceed on boxes of these."""

    at: Callable[[Floats, Floats], Floats]
    most: Callable[[Interval, Interval], Floats]


#: the amplitude; the largest |u|
AMPLITUDE = Measure(lambda A, B: A, lambda A, B: A.hi)
NO_FREQUENCY = Sentence(
    "the largest motion is unresolved: double precision does not resolve the frequency at which {A = :g}"
)
LARGEST = Measure(lambda A, B: A + np.abs(B), lambda A, B: A.hi + np.maximum(-B.lo, B.hi))


class Reach:
    """For one force with its load, by what excites and dissipates, zeta > 0."""

    def __init__(self, sheets: Sheets, flow: Flow, A_max: Callable[[float], float]) -> None:
        self.sheets, self.steps, self.flow, self._A_max = sheets, sheets.steps, flow, A_max

    def farthest(self, F_0: float, measure: Measure) -> Farthest | None:
        """The motion at F_0 up to `A_max` that goes farthest; no other goes farther by more than `GAP` of that.

        None where no motion is found. Raises ArithmeticError where too many boxes stay undecided.
        """

        def most(cells: Cells) -> Floats:
            return np.where(self._may_move(cells, F_0), measure.most(cells.A, cells.B), -np.inf)

        found, is_proved = self._search(F_0, most, partial(self._motions, F_0=F_0, measure=measure), GAP)
        if not is_proved:
            raise NotSettled("the largest motion is unresolved: too many boxes stay undecided")
        return found

    def last_transmitting(self, F_0: float, level: Level, Omega: float) -> tuple[Farthest | None, bool]:
        """The stable motion beyond Omega that transmits a level at the highest frequency; whether no other does.

        One that is nearer to it, or to Omega, than by `BEYOND` of that may be missed.
        """
        most = partial(self._transmits_up_to, F_0=F_0, level=level)
        motions = partial(self._transmitting, F_0=F_0, level=level)
        known = Farthest(Omega, Omega, 0.0, 0.0, False)
        found, is_proved = self._search(F_0, most, motions, BEYOND, known)
        return None if found is known else found, is_proved

    def _search(
        self,
        F_0: float,
        most: Callable[[Cells], Floats],
        motions: Callable[[Floats], Farthest | None],
        gap: float,
        best: Farthest | None = None,
    ) -> tuple[Farthest | None, bool]:
        """The motion of the largest value, and whether none exceeds it by more than a share of that.

        most    -- what values of motions on cells do not exceed: -inf where there are none, NaN where it is not known
        motions -- the best of those that are found from some places
        best    -- one that is known
        """

        def may(cells: Cells) -> Flags:
            with np.errstate(all="ignore"):
                value = most(cells)
            return np.isnan(value) | (value > (-np.inf if best is None else best.value * (1 + gap)))

        looked_at, rounds, cells = 0, 0, self.sheets.cells(self._A_max(F_0), may)
        while cells.chart.size:
            looked_at, rounds = looked_at + cells.chart.size, rounds + 1
            if looked_at > MOST_BOXES:
                return best, False
            with np.errstate(all="ignore"):
                if rounds % EVERY == 1:
                    # a motion that is found in one round mostly stays the best in the next ones
                    first = np.argsort(-most(cells), kind="stable")[:MIDDLES]
                    found = motions(self.sheets.middles(cells.take(first)))
                    if found is not None and (best is None or found.value > best.value):
                        best = found
                    cells = cells.take(may(cells))
                cells = self.sheets.cut(cells)
                cells = cells.take(may(cells))
        return best, True

    def _may_move(self, cells: Cells, F_0: float) -> Flags:
        """Which cells may hold a motion at F_0 that is stable."""
        return np.asarray((cells.rising.hi > 0) & (self.flow.needed(cells.A, cells.p) * (1 - ROUNDED) <= F_0))

    def _transmits_up_to(self, cells: Cells, F_0: float, level: Level) -> Floats:
        """Up to which frequency stable motions at F_0 may transmit a level, by cells; -inf where none does."""
        flow, A, e = self.flow, cells.A, cells.e
        p = Interval(np.where(np.isnan(cells.p.ends), ALL, cells.p.ends))
        corners = up_to(flow, A.ends[:, np.newaxis], F_0, level, -A.ends[:, np.newaxis] * p.ends)
        # an amplitude that is too small for a level is next to one at which it is transmitted at any frequency
        low, high = np.maximum(corners[1, 0], 0.0), np.where(corners[0, 1] > 0, corners[0, 1], np.inf)
        # I and h, and under a force A Omega too, rise with A and |p|; over Omega^2 what is transmitted falls with Omega
        at = np.array((high, low) if flow.inertial else (np.maximum(corners[0, 0], 0.0), corners[1, 1]))
        sizes = np.where((p.lo > 0) | (p.hi < 0), np.abs(p.ends).min(axis=0), 0.0), np.abs(p.ends).max(axis=0)
        passed = np.hypot(A.ends * sizes, flow.sine(at, A.ends)) / flow.force(F_0, at)
        none = (passed[0] * (1 - ROUNDED) > level.ratio) | (passed[1] * (1 + ROUNDED) < level.ratio)
        square = Interval.of(low * (1 - ROUNDED), high * (1 + ROUNDED)).square()
        R, (I, I_A) = A * (square - p), flow.balances(square.sqrt(), A)
        # F_A along the balance
        none |= ((R * (square - p - e) + I * I_A).hi < 0) | ~(corners[1, 1] > 0)
        # where the mean turns back motions lose their stability while they transmit that: below the level's frequency,
        # which motions with R < 0 are if Omega^2 < p, or up to that of R = F_0
        nearest = np.inf if flow.inertial else np.sqrt(p.hi + F_0 / A.lo)
        turning = np.where(passed[1] * (1 + ROUNDED) < level.ratio, np.sqrt(p.hi), np.fmin(high, nearest))
        most = np.where(none, -np.inf, high)
        most = np.where(cells.rising.lo > 0, most, np.where(p.hi > 0, turning, -np.inf))
        return np.where(self._may_move(cells, F_0), most, -np.inf)

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
        value = np.where(holds, measure.at(A, B), -np.inf)
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

    def _transmitting(self, x: Floats, F_0: float, level: Level) -> Farthest | None:
        """The stable motion of the highest frequency that is found from some places and transmits a level."""
        slow = Slow(self.steps, self.flow, F_0)

        def frequency(x: Floats) -> Floats:
            return up_to(self.flow, x[0], F_0, level, -2 * self.steps.at(x[0], x[1], 0).s[0])

        for _ in range(STEPS):
            Omega, near = frequency(x), NEAR * (x[0] + np.abs(x[1]))
            by_A, by_B = ((frequency(x + near * one) - Omega) / near for one in np.eye(2)[..., np.newaxis])
            *state, F_A, F_B = slow.state(Omega, x)
            by_Omega = self.flow.F_Omega(Omega, x[0], -2 * self.steps.at(x[0], x[1], 0).s[0])
            change = slow.step((*state, F_A + by_Omega * by_A, F_B + by_Omega * by_B))
            x = x - change
        Omega = frequency(x)
        holds = (np.abs(change).max(axis=0) <= AT * x[0]) & (Omega > 0) & slow.stability(Omega, *x)[0]
        if not holds.any():
            return None
        k = int(np.argmax(np.where(holds, Omega, -np.inf)))
        return Farthest(float(Omega[k]), float(Omega[k]), float(x[0, k]), float(x[1, k]), False)

    def _highest(self, A: Floats, h: Floats, F_0: float) -> float:
        """The highest frequency of a state. Raises ArithmeticError where rounding leaves none."""
        found = self.flow.frequencies(A, h, F_0)
        if np.isnan(found).all():
            raise NotSettled(NO_FREQUENCY.format(float(A[0])))
        return float(np.nanmax(found))
