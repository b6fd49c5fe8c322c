"""All that there is off the centre. Takes steps with damping; returns every state and every fold as points of (A, B).

No part of the plane is left unless it is proved to hold nothing (see `boxes`), whatever the balance's sheets do,
wherever they turn. What could not be decided comes out beside what was found.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from slowflow.core.mechanism import Ints
from slowflow.core.model import Floats
from slowflow.off_centre.boxes import Solutions, solve
from slowflow.off_centre.by_turning_points import ON, ByMotion, Equations, folds, on_edges, refined, solve_edges, states
from slowflow.off_centre.flow import Flow
from slowflow.off_centre.means import UNBOUNDED, Steps
from slowflow.off_centre.onset import Lowest, Search
from slowflow.off_centre.solution_sheets import FARTHEST, TOO_FAR, Corner, Sheets
from slowflow.support.errors import NotSettled, OutOfRange, Refused
from slowflow.support.text import text

#: octaves of the amplitude that are looked at above the size of the problem
ABOVE = 8
#: octaves that are looked at above these for any fold, as long as none is known
FIRST = 2
#: octaves of an amplitude beside the size of the problem, where what is beyond is not bounded by a polynomial
OCTAVES = 40
#: parts of the range of B that are looked at first
SUBDIVISIONS = 8
#: frequencies that are looked at together
TOGETHER = 64
#: the amplitude of an onset beside the size of the problem below which folds tend to rest, as next to a preload
TENDED = 2.0**-64
#: x or y next to an edge of its chart
NEAR = 2.0**-8
#: |B| up to which a motion without a load is about the centre, where all others are told from it by more
AT_CENTRE = 1e-12
#: no bound of B, and so none of what is to be looked at
ENDLESS = "folds occur at ever lower forcings towards {Omega} = 0, or towards a turning point of the mean"


def farthest_fold(steps: Steps, flow: Flow, F_0: float) -> float:
    """Up to which amplitude folds at F_0 are looked for: 2^8 times what the problem is as large as.

    A force that is no polynomial may be 2^24 times the load and 1 on both sides before: up to there, then.
    """
    if flow.zeta > 0 or F_0 == 0:
        damped = F_0 / flow.zeta if F_0 > 0 else 0.0
    else:
        damped = 2 * float(replace(flow, mu=0.0).bound(1.0, F_0))
    return min(2.0**ABOVE * max(steps.size, F_0, damped), steps.grown)


class Complete:
    """Every state and every fold of an oscillator off the centre.

    sheets -- of the balance of the mean, in whose charts they are looked for
    """

    def __init__(self, steps: Steps, flow: Flow) -> None:
        self._steps, self._flow = steps, flow
        self.sheets = Sheets(steps, self.offset_bound)

    @property
    def has_centre(self) -> bool:
        """Whether motions about the centre are there, which have solvers of their own: an odd force and no load."""
        return bool(self.sheets.charts.has_centre)

    def states(self, Omega: Floats, F_0: float) -> tuple[Floats, Ints, Ints]:
        """All states at any number of frequencies, by A and B, the number of each, those that may have others."""
        chunks = [self._at(Omega[first : first + TOGETHER], F_0) for first in range(0, Omega.size, TOGETHER)]
        of, undecided = (
            np.concatenate([TOGETHER * k + getattr(part, name) for k, part in enumerate(chunks)])
            for name in ("of", "undecided_of")
        )
        return np.concatenate([part.x for part in chunks], axis=1), of, undecided

    def folds(self, F_0: Floats) -> Solutions:
        """All folds at some forcings but those on corners, by A, B and R."""
        boxes = self.sheets.folds(max(map(self.A_max, F_0.tolist())), F_0, self._flow)
        found = self._solved(folds(self.sheets.charts, self._flow, F_0), *boxes)
        # the equations go on to negative squares of Omega, as if it were 0 there
        A, B, R = found.x
        moving = R + 2 * self._steps.at(A, B, 0).s[0] > 0
        return replace(found, x=found.x[:, moving], of=found.of[moving])

    def corners(self, F_0: float) -> tuple[Floats, list[str], Floats]:
        """The folds where a motion just touches a jump of the force, their kinds, and where there may be others.

        By A, B and Omega: A and B, rounded, may pass the jump, which moves h by the root of that.
        """
        found: list[tuple[float, ...]] = []
        kinds: list[str] = []
        corners, open_ = self.sheets.corners(self.A_max(F_0))
        for corner in corners:
            if self.has_centre and abs(corner.B) <= AT_CENTRE:
                continue
            A = np.array([corner.A])
            Omega = self._flow.frequencies(A, np.array([-2 * corner.s_0]), F_0)[0]
            for at in Omega[Omega > 0].tolist():
                if kind := self._kind_at_corner(corner, at):
                    found.append((corner.A, corner.B, at))
                    kinds.append(kind)
        open_ = np.concatenate((open_, np.zeros((1, open_.shape[1]))))
        return np.array(found).reshape(-1, 3).T, kinds, open_

    def detaching(self) -> Floats:
        """A and B of all motions that reach an end of the piece about u = 0, and no end is passed, (2, n)."""
        charts, boxes = self.sheets.charts, []
        for edge in (0, 1):
            of = charts.about(edge)
            high = charts.high[1 - edge, of]
            if not np.isfinite(high).all():
                most = 2 * self._highest_at(edge, of)
                high = np.minimum(high, np.where(charts.rooted[1 - edge, of], np.sqrt(most), most))
            ends = np.linspace(0.0, high, SUBDIVISIONS + 1)
            boxes.append((ends[:-1].ravel(), ends[1:].ravel(), np.tile(charts.system(edge, of), SUBDIVISIONS)))
        low, high, of = (np.concatenate(column) for column in zip(*boxes, strict=True))
        solved = solve_edges(charts, low, high, of)
        motions = np.stack(charts.on_edge(solved.x[0], solved.of))
        return motions[:, motions[0] > 0]

    def _highest_at(self, edge: int, charts: Ints) -> float:
        """An amplitude beyond which the mean is not balanced where motions come to the end of a piece with one only."""
        edges = self._steps.size * 2.0 ** np.arange(0, OCTAVES + 0.25, 0.5)
        distances = 2 * edges if not self.sheets.charts.rooted[1 - edge, charts[0]] else np.sqrt(2 * edges)
        low, high = (np.tile(ends, charts.size)[np.newaxis] for ends in (distances[:-1], distances[1:]))
        with np.errstate(all="ignore"):
            number = np.repeat(self.sheets.charts.system(edge, charts), distances.size - 1)
            f_0 = on_edges(self.sheets.charts, low, high, number)[:, ON]
        may = np.any(((f_0[:, 0] <= 0) & (f_0[:, 1] >= 0)).reshape(charts.size, -1), axis=0)
        if may[-1]:
            raise Refused(UNBOUNDED)
        return float(edges[1:][may].max(initial=edges[0]))

    def lowest(self) -> Lowest | None:
        """The fold at the onset, or None where none is. Raises ArithmeticError where that is not decided."""
        search = Search(self.sheets, self._flow)
        known = search.corners(self.sheets.corners(self.A_max(self._flow.m))[0])
        while True:
            best = min(known, key=lambda fold: fold.F_0, default=None)
            if best is not None and not best.kind:
                raise NotSettled(text(ENDLESS))
            if best is not None and best.A < TENDED * self._steps.size:
                raise NotSettled("folds occur at ever lower forcings towards ever smaller amplitudes")
            if best is not None and best.A > self.A_max(best.F_0):
                raise NotSettled("folds occur at ever lower forcings towards ever larger amplitudes")
            # a first one may lie beyond what is looked at for small forcings
            first = min(2.0**FIRST * self.A_max(self._flow.m), self._steps.grown)
            A_max, F_0 = (first, math.inf) if best is None else (self.A_max(best.F_0), best.F_0)
            lower = search.lower(A_max, F_0)
            if lower is None:
                return best
            known.append(search.descend(lower))
            if best is not None and known[-1].F_0 >= best.F_0:
                raise NotSettled("a lower fold exists, but the search does not reach it")

    def A_max(self, F_0: float) -> float:
        """Up to which amplitude folds at F_0 are looked for."""
        return farthest_fold(self._steps, self._flow, F_0)

    def offset_bound(self, A: float) -> float:
        """What |B| does not exceed where the mean is balanced, for amplitudes up to A: no motion is all `settled`."""
        bound = (A + self._steps.settled) * (1 + 2.0**-40)
        if not bound < FARTHEST:
            raise OutOfRange(TOO_FAR.format(max(A, bound)))
        return bound

    def _at(self, Omega: Floats, F_0: float) -> Solutions:
        """All states at some frequencies, by A and B."""
        with np.errstate(divide="ignore", over="ignore"):
            force = self._flow.force(F_0, Omega)
            # I is not more than the force
            bounds = self._flow.bound(Omega, force) * (1 + 2.0**-40)
        # at Omega = 0 it is a static state
        most = max(self.A_max(F_0), float(bounds[np.isfinite(bounds)].max(initial=0.0)))
        most = min(most, self._steps.grown)
        boxes = self.sheets.states(most, Omega, F_0, self._flow)
        return self._solved(states(self.sheets.charts, self._flow, Omega, F_0), *boxes)

    def _solved(self, equations: Equations, low: Floats, high: Floats, of: Ints) -> Solutions:
        """Solutions by A and B, and by the number of the frequency or forcing."""
        (on, by_motion), charts = equations, self.sheets.charts
        (_, chart), free = charts.of_system(of), np.full((len(low) - 2, of.size), np.inf)
        limits = np.concatenate((charts.low[:, chart], -free)), np.concatenate((charts.high[:, chart], free))
        found = solve(on, low, high, of, limits)
        x, of = self._motions(found.x, found.of, by_motion)
        return Solutions(x, of, *self._motions(found.undecided, found.undecided_of))

    def _motions(self, x: Floats, of: Ints, by_motion: ByMotion | None = None) -> tuple[Floats, Ints]:
        """Points by A and B, and by the number of the frequency or forcing, in order; to their last digits by that."""
        charts, (number, chart) = self.sheets.charts, self.sheets.charts.of_system(of)
        z = np.concatenate((np.stack(charts.motion(x[0], x[1], chart)), x[2:]))
        if by_motion is not None and of.size:
            # next to an edge x and y have more digits
            z = refined(by_motion, z, number, (charts.rooted[:, chart] & (x[:2] < NEAR)).any(axis=0))
        if self.has_centre:
            # those about the centre have solvers of their own, and all others are there mirrored as well
            off = np.flatnonzero(z[1] > AT_CENTRE)
            z, number = np.repeat(z[:, off], 2, axis=1), np.repeat(number[off], 2)
            z[1, 1::2] *= -1.0
        order = np.lexsort((*z[::-1], number))
        return z[:, order], number[order]

    def _kind_at_corner(self, corner: Corner, Omega: float) -> str:
        """The kind of a fold there, "" for none: F_A has other signs where a motion reaches no jump and beyond it."""
        h = -2 * corner.s_0
        turns = [float(self._flow.F_A(Omega, corner.A, (h, h / corner.A - e))) for e in corner.e]
        if turns[0] * turns[1] >= 0:
            return ""
        side = int(turns[1] > 0)
        if not corner.stiff[side]:
            return "unstable"
        # stable motions are above the corner or below it
        return "jump-down" if corner.rises[side] else "jump-up"
