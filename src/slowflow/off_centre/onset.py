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

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from slowflow.core.mechanism import Flags
from slowflow.core.model import Floats
from slowflow.off_centre.flow import Flow
from slowflow.off_centre.solution_sheets import SIGNS, Cells, Corner, Sheets
from slowflow.support.errors import NotSettled

#: relative distance below F_SN within which no fold is proved to be absent
GAP = 2.0**-16
#: boxes that are looked at in all, and up to which number the middle of each is asked for a lower fold
MOST_BOXES, FEW = 100_000, 2000
#: how often boxes are cut in four: then both sides are as narrow as doubles allow, and the same box would come back;
#: sides that end at 0 take a halving for each power of 2 that doubles have
MOST_ROUNDS = 1100
#: by how many values a root is told
VALUES = 16


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

    def folds(self, A: Floats, B: Floats) -> tuple[Floats, Floats]:
        """The lowest level of a fold at each point of the balance, inf where none ends a stable motion; its Omega."""
        means = self.steps.at(A, B, 1)
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
    def descend(self, A: float, B: float) -> Lowest:
        """From a point of the balance with a fold on it to the least level nearby."""
        width = 0.05 * (A + abs(B))
        for _ in range(200):
            at = self._tangent_points(A, B)
            found = minimize_scalar(
                lambda distance, at=at: min(self._level(*at(distance)), 1e300),
                bounds=(-width, width),
                method="bounded",
                options={"xatol": 0.02 * width},
            )
            lower = self._level(*at(found.x)) <= self._level(A, B)
            if lower:
                A, B = at(found.x)
            if not lower or abs(found.x) < 0.5 * width:
                width *= 0.05
            if width < 1e-5 * (A + abs(B)):
                break
        return self._stationary(A, B)

    def _tangent_points(self, A: float, B: float) -> Callable[[float], tuple[float, float]]:
        """Points of the balance by their distance along its tangent."""
        means = self.steps.at(np.array([A]), np.array([B]), 1)
        slope = np.array((means.s[1][0], means.c[1][0]))
        slope /= np.hypot(*slope)

        def at(distance: float) -> tuple[float, float]:
            x = np.array((A, B)) + distance * np.array((slope[1], -slope[0]))
            for _ in range(4):
                if not x[0] > 0:
                    break
                means = self.steps.at(x[:1], x[1:], 1)
                by = np.array((means.s[1][0], means.c[1][0]))
                x = x - slope * (means.c[0][0] - self.steps.load) / (slope @ by)
            return float(x[0]), float(x[1])

        return at

    def _level(self, A: float, B: float) -> float:
        return float(self.folds(np.array([A]), np.array([B]))[0][0]) if A > 0 else np.inf

    def _stationary(self, A: float, B: float) -> Lowest:
        """The nearest root of F_AA along the balance, or of F_Omega, near a least level."""
        at, (level, Omega) = self._tangent_points(A, B), self.folds(np.array([A]), np.array([B]))
        near = 2.0**-36 * (A + abs(B))
        offsets = near * np.linspace(-1.0, 1.0, VALUES)
        for width in (1e-6, 1e-5, 1e-4, 1e-3):
            width *= A + abs(B)
            for name in ("cusp", "isola"):

                def vanishes(distance: float, name: str = name) -> float:
                    return self._slopes(*at(distance))[name]

                if not vanishes(-width) * vanishes(width) < 0:
                    continue
                root = float(brentq(vanishes, -width, width, xtol=near / 16))
                # by many values, each of which has its roundings: their line, and the mean of what is stationary
                values = np.array([vanishes(root + one) for one in offsets.tolist()])
                root -= float(values.mean() * (offsets @ offsets) / (offsets @ values))
                levels = self.folds(*np.array([at(root + one) for one in offsets.tolist()]).T)
                k = int(np.argmin(levels[0]))
                if 0 < k < VALUES - 1 and levels[0][k] < levels[0].mean() * (1 - 2.0**-40) < np.inf:
                    # just beyond an end at which the slope of the force jumps the level rises as a root does
                    return Lowest(float(levels[0][k]), float(levels[1][k]), *at(root + offsets[k]), name)
                if levels[0].mean() <= level[0] * (1 + 1e-9):
                    return Lowest(float(levels[0].mean()), float(levels[1].mean()), *at(root), name)
        return Lowest(float(level[0]), float(Omega[0]), A, B, "")

    def _slopes(self, A: float, B: float) -> dict[str, float]:
        at = np.array([A]), np.array([B])
        (_, averages), Omega = self.steps.averaged(*at), self.folds(*at)[1]
        return {
            "cusp": float(self.flow.F_AA(Omega, at[0], averages)[0]),
            "isola": float(np.asarray(self.flow.F_Omega(Omega, at[0], averages[0]))[0]),
        }

    # ==== No fold is lower ============================================================================================

    def lower(self, A_max: float, known: float) -> tuple[float, float] | None:
        """A point of the balance with a lower fold up to an amplitude, or None: none is below (1 - GAP) of it.

        Raises ArithmeticError where too many boxes stay undecided.
        """
        may = partial(self._may_be_lower, below=known * (1 - GAP))
        rounds, looked_at, cells = 0, 0, self.sheets.cells(A_max, may)
        while cells.chart.size:
            rounds, looked_at = rounds + 1, looked_at + cells.chart.size
            if looked_at > MOST_BOXES or rounds > MOST_ROUNDS:
                raise NotSettled("too many boxes of A and B may hold a lower fold")
            with np.errstate(all="ignore"):
                cells = cells.take(may(cells))
            if 0 < cells.chart.size <= FEW:
                A, B = self.sheets.middles(cells)
                for _ in range(4):
                    means = self.steps.at(A, B, 1)
                    with np.errstate(all="ignore"):
                        B = B - (means.c[0] - self.steps.load) / means.c[1]
                inside = np.isfinite(B) & (cells.B.lo <= B) & (cells.B.hi >= B)
                level = np.full(A.size, np.inf)
                level[inside] = self.folds(A[inside], B[inside])[0]
                if level.min() < known * (1 - GAP / 2):
                    i = int(np.argmin(level))
                    return float(A[i]), float(B[i])
            with np.errstate(all="ignore"):
                cells = self.sheets.cut(cells, most=MOST_BOXES - looked_at)
        return None

    def _may_be_lower(self, cells: Cells, below: float) -> Flags:
        """Which cells may hold a fold with a level below."""
        found = self.flow.folds_between(cells.A, cells.p, cells.e, SIGNS, 0.0, below)[1].any(axis=0)
        return np.asarray((cells.rising.hi > 0) & found)
