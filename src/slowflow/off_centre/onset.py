"""The lowest forcing with a fold off the centre. Takes a force as steps and damping; returns F_SN, Omega, A and B.

A point of the balance and F_A = 0 along it give Omega, and the two with it the forcing, `slow_flow.level`. So folds of
all forcings lie on curves in the plane of A and B, and the onset is the lowest level on them. The search has two parts.

descend  from a fold down to where the level is stationary: that is a fold, and its level not less than the onset
lower    cuts the plane into boxes until on each it is proved that the balance does not hold, that F_A along it does not
         vanish, or that a level is not below (1 - GAP) of the lowest known. A lower fold that turns up is given back.

With p = -h/A, q = -h_A, y = Omega^2 - p and e = q - p, F_A = 0 is |y| (|e| - |y|) = 4 zeta^2 Omega^2 + 2 zeta m Omega/A
with y of the sign of e, and R = A y. On a box of A, p and e both sides are bounded, on parts of the range of y.

Only folds that end a stable motion are looked at, those with c_1 = df_0/dB > 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from slowflow.core.mechanism import Flags
from slowflow.core.model import Floats
from slowflow.off_centre.flow import Flow
from slowflow.off_centre.means import Steps
from slowflow.off_centre.solution_sheets import SIGNS, Cells, Corner, Sheets
from slowflow.support.errors import NotSettled

#: relative distance below F_SN within which no fold is proved to be absent
GAP = 2.0**-16
#: boxes that are looked at in all, and up to which number the middle of each is asked for a lower fold
MOST_BOXES, FEW = 100_000, 2000
#: how often boxes are cut in four: then both sides are as narrow as doubles allow, and the same box would come back;
#: sides that end at 0 take a halving for each power of 2 that doubles have
MOST_ROUNDS = 1100
#: positions on both sides of a point, as fractions of a width, at which a least level or a root is looked for
POSITIONS = np.linspace(-1.0, 1.0, 17)
#: widths relative to A + |B|: the first, the last, and one within which values differ by rounding only; most steps
WIDEST, NARROWEST, NEAR, MOST_STEPS = 0.05, 1e-6, 2.0**-36, 200
#: of Newton's method, to where a motion next to a kink just reaches it
KINK_STEPS = 3


@dataclass(frozen=True)
class Lowest:
    """A fold, its forcing, and what makes this the lowest: "cusp", "isola", "corner", or "" where none of them does."""

    F_0: float
    Omega: float
    A: float
    B: float
    kind: str


class Search:
    """For one force with its load, by what excites and dissipates."""

    def __init__(self, sheets: Sheets, flow: Flow) -> None:
        self.sheets, self.steps, self.flow = sheets, sheets.steps, flow

    # ==== Folds at points of the balance ==============================================================================

    def folds(self, A: Floats, B: Floats, steps: Steps | None = None) -> tuple[Floats, Floats]:
        """The lowest level of a fold at each point of the balance, inf where none ends a stable motion; its Omega."""
        means = (steps or self.steps).at(A, B, 1)
        with np.errstate(all="ignore"):
            h_A = 2 * means.s[0] / A - 2 * (means.c[1] - means.s[1] ** 2 / means.c[1])
        return self.flow.least_fold(A, -2 * means.s[0], np.where(means.c[1] > 0, h_A, np.nan))

    def corners(self, corners: list[Corner]) -> list[Lowest]:
        """Folds that sit where the motion comes to a jump of the force, at the lowest forcing each.

        Where F_A along the balance has another sign on either side, the least level of the frequencies.
        """
        found = []
        for corner in corners:
            if not any(corner.stiff):
                continue
            A, s_0 = np.array([corner.A]), np.array([corner.s_0])
            slopes = [-2 * s_0 / A - e for e in corner.e]
            candidates = [self.flow.least_fold(A, -2 * s_0, h_A) for h_A in slopes]
            Omega = self.flow.stationary(A, -2 * s_0)[0]
            Omega = Omega[(Omega > 0) & np.isfinite(Omega)]
            turns = [self.flow.F_A(Omega, corner.A, (-2 * s_0, h_A)) for h_A in slopes]
            Omega = Omega[turns[0] * turns[1] < 0]
            candidates.append((self.flow.level(Omega, corner.A, (-2 * s_0,)), Omega))
            level, Omega = (np.concatenate(column) for column in zip(*candidates, strict=True))
            i = int(np.argmin(level))
            if np.isfinite(level[i]):
                found.append(Lowest(float(level[i]), float(Omega[i]), float(corner.A), float(corner.B), "corner"))
        return found

    # ==== Down to the lowest ==========================================================================================

    @np.errstate(all="ignore")  # where the force jumps at the mean a slope has no bound
    def descend(self, x: Floats) -> Lowest:
        """From A and B of a fold on the balance, (2, 1), to the least level nearby."""
        width = WIDEST
        for _ in range(MOST_STEPS):
            at = self._near_tangent(x, width * POSITIONS)
            lowest = int(np.argmin(self.folds(*at)[0]))
            x = at[:, lowest : lowest + 1]
            if 0 < lowest < POSITIONS.size - 1:
                width *= 0.25
            if width < NARROWEST:
                break
        return self._stationary(x)

    def _near_tangent(self, x: Floats, distances: Floats) -> Floats:
        """Points of the balance next to one, (2, n), by their distances along its tangent, relative to A + |B|."""
        means = self.steps.at(x[0], x[1], 1)
        tangent = np.stack((means.c[1], -means.s[1]))
        at, there = self.steps.balanced(x + tangent / np.hypot(*tangent) * np.abs(x).sum() * distances)
        return np.where(there, at, np.nan)

    def _stationary(self, x: Floats) -> Lowest:
        """The nearest root of F_AA along the balance, or of F_Omega, near a least level."""
        level, Omega = self.folds(*x)
        for width in (1e-6, 1e-5, 1e-4, 1e-3):
            for name in ("cusp", "isola"):
                if (root := self._root(x, name, width)) is None:
                    continue
                if (kink := self._on_kink(root)) is not None:
                    return kink
                at = self._near_tangent(root, NEAR * POSITIONS)
                levels, found = self.folds(*at)
                if levels.mean() <= level[0] * (1 + 1e-9):
                    return Lowest(float(levels.mean()), float(found.mean()), float(root[0, 0]), float(root[1, 0]), name)
        return Lowest(float(level[0]), float(Omega[0]), float(x[0, 0]), float(x[1, 0]), "")

    def _on_kink(self, x: Floats) -> Lowest | None:
        """The fold where a motion near a point of the balance just reaches a step, None where it comes to none.

        F_AA changes its sign by a jump there, with the slope of the force. Means are those of the pieces before.
        """
        A, B = x
        step = self.steps.reached(A, B)
        side, place = self.steps.sides[step], self.steps.positions[step]
        if step == 0 or np.abs(A + side * B - place) > 4 * NEAR * (A + np.abs(B)):
            return None
        before = self.steps.within(A, B)
        for _ in range(KINK_STEPS):
            means = before.at(A, side * (place - A), 1)
            A = A - (means.c[0] - self.steps.load) / (means.s[1] - side * means.c[1])
        B = side * (place - A)
        level, Omega = self.folds(A, B, before)
        return Lowest(float(level[0]), float(Omega[0]), float(A[0]), float(B[0]), "corner")

    def _root(self, x: Floats, name: str, width: float) -> Floats | None:
        """Where what vanishes at a cusp, or at an isola, changes its sign within a width of a point of the balance."""
        while width > NEAR:
            values = self._vanishing(self._near_tangent(x, width * POSITIONS), name)
            change = np.flatnonzero(values[1:] * values[:-1] < 0)
            if not change.size:
                return None
            x, width = self._near_tangent(x, width * (POSITIONS[change[:1]] + POSITIONS[change[:1] + 1]) / 2), width / 8
        # by the line through many values, which all have their roundings
        values = self._vanishing(self._near_tangent(x, NEAR * POSITIONS), name)
        return self._near_tangent(
            x, -NEAR * values.mean(keepdims=True) * (POSITIONS @ POSITIONS) / (POSITIONS @ values)
        )

    def _vanishing(self, x: Floats, name: str) -> Floats:
        (_, averages), Omega = self.steps.averaged(*x), self.folds(*x)[1]
        return np.asarray(
            self.flow.F_AA(Omega, x[0], averages) if name == "cusp" else self.flow.F_Omega(Omega, x[0], averages[0])
        )

    # ==== No fold is lower ============================================================================================

    @np.errstate(all="ignore")
    def lower(self, A_max: float, known: float) -> Floats | None:
        """A point of the balance with a lower fold up to an amplitude, (2, 1), or None: none is below (1 - GAP) of it.

        Raises ArithmeticError where too many boxes stay undecided.
        """
        may = partial(self._may_be_lower, below=known * (1 - GAP))
        rounds, looked_at, cells = 0, 0, self.sheets.cells(A_max, may)
        while cells.chart.size:
            rounds, looked_at = rounds + 1, looked_at + cells.chart.size
            if looked_at > MOST_BOXES or rounds > MOST_ROUNDS:
                raise NotSettled("too many boxes of A and B may hold a lower fold")
            cells = cells.take(may(cells))
            if 0 < cells.chart.size <= FEW:
                x, there = self.steps.balanced(self.sheets.middles(cells))
                level = np.where(there, self.folds(*x)[0], np.inf)
                if level.min() < known * (1 - GAP / 2):
                    return x[:, [int(np.argmin(level))]]
            cells = self.sheets.cut(cells, most=MOST_BOXES - looked_at)
        return None

    def _may_be_lower(self, cells: Cells, below: float) -> Flags:
        """Which cells may hold a fold with a level below."""
        found = self.flow.folds_between(cells.A, cells.p, cells.e, SIGNS, 0.0, below)[1].any(axis=0)
        return np.asarray((cells.rising.hi > 0) & found)
