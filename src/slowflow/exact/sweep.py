"""Stepped-sine sweeps: the motion is followed in time while the frequency is stepped; amplitudes and jumps."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from slowflow.answers.answer import Drawn, Table
from slowflow.core.mechanism import EquationOfMotion, Flags, Floats
from slowflow.exact.continuation import Path, Point, passed_fold
from slowflow.exact.motion import Forced, check_numbers, limited, stops
from slowflow.exact.shooting import SteadyState, at_rest, continue_stepping, converge, largest, lengths
from slowflow.support.errors import Refused
from slowflow.support.text import text

#: periods of the forcing at one frequency, at most
MOST_TURNS = 2000
#: largest step along a branch that is followed from frequency to frequency: it is bent as its tangents say
STEP = 0.1
#: of its amplitude, by which a motion that Newton's iteration found twice may differ
SAME = 1e-6
#: substeps of a step in which the motion may have changed its branch several times, and the depth of such subdivision
FINER, OFTEN = 8, 3
#: the same where two branches meet: near that point one of them grows like the square root of the distance
MEETS = 1e-4


@dataclass(frozen=True, eq=False)
class Sweep(Drawn, Table, entry="SweepPoint"):
    """A stepped-sine sweep; arrays in the order of the frequencies.

    Omega   -- the frequencies
    A       -- largest |u| of the settled motion; if the motion did not settle, over the last period of the forcing; if
            friction holds the mass, the |u| of the mass; in a dead zone, where no force restores the mean, about the
            last mean
    stops   -- number of stick phases in one period of the motion; if the motion did not settle, in the last period of
            the forcing
    turns   -- periods of the forcing until the motion was shown to settle
    settled -- whether the motion settled within the largest number of periods
    jumps   -- pairs (Omega before, Omega after) between which the motion left its branch
    message -- diagnostics as text; empty if there are none
    """

    F_0: float
    Omega: Floats
    A: Floats
    stops: NDArray[np.int64]
    turns: NDArray[np.int64]
    settled: Flags
    jumps: tuple[tuple[float, float], ...]
    message: str = ""
    picture: ClassVar[str] = "sweep"


#: A, stops, turns and settled of a `Sweep`; the periodic motions that it converged to, None where it did not
Visited = tuple[Any, Sequence[SteadyState | None]]


def sweep(
    system: EquationOfMotion,
    *,
    Omega: Sequence[float] | Floats,
    F_0: float,
    u_0: float = 0.0,
    v_0: float = 0.0,
) -> Sweep:
    """Follow the motion from (u_0, v_0) through the frequencies, keeping state and phase of the forcing at each step.

    At each frequency the motion is followed until it is shown to tend to a periodic one, from which the next frequency
    continues. A jump is a change of branch. Raises ValueError for parameters out of range, or if the
    mass never moves, ArithmeticError if the motion escapes or chatters.
    """
    frequencies = np.array(Omega, dtype=float, order="C")
    if frequencies.ndim != 1 or frequencies.size == 0:
        raise Refused(
            text("{Omega} must be a non-empty list of frequencies, not an array of shape {shape:r}", frequencies.shape)
        )
    for frequency in frequencies:
        check_numbers(system, float(frequency), F_0)

    tries = lengths(system)

    def through(Omega: Floats, u: float, v: float) -> Visited:
        """The motion from (u, v) through frequencies."""
        visited = []
        for at in Omega.tolist():
            with limited():
                forced = Forced(system, at, F_0)
                end = converge(forced, 0.0, u, v, tries, MOST_TURNS)
                if end.free_mean is not None:
                    end = continue_stepping(forced, 0.0, end, MOST_TURNS)
            u, v, found = end.u, end.v, end.found
            drifts = end.free_mean is not None and end.turns < MOST_TURNS
            steady = found is not None or end.repeats or at_rest(end.phases) or drifts
            seen = (largest(end.phases), stops(end.phases)) if found is None else (found.A, found.stops)
            visited.append((*seen, end.turns, steady, found))
        *columns, motions = zip(*visited, strict=True)
        return list(map(np.array, columns)), motions

    (A, stops_at, turns, steady), motions = through(frequencies, u_0, v_0)
    jumps = Branches(frequencies, F_0, motions, through).jumps()
    return Sweep(F_0, frequencies, A, stops_at, turns, steady, jumps)


@dataclass(frozen=True)
class Branches:
    """Whether the motions of a sweep continue each other along a branch of periodic motions.

    The branch of the motion at one frequency is followed to those that come next, as long as the frequency goes on the
    same way. The motion jumps where the branch folds before the next frequency, or where it is stable there and the
    motion is another one all the same. Where it loses its stability without a fold, as by period doubling, or ends on a
    branch of higher symmetry, the motion jumps unless the branch that it is on then meets this one.

    Between frequencies that are far apart there may be several such changes: where it does not meet this one, the step
    is made once more in `FINER` ones, and these likewise; there is a jump if there is one in them, or if they lead to
    another motion. A branch that is stable up to its fold needs no finer steps.

    motions -- the periodic motions that the sweep converged to; None, with an unknown branch, where it did not
    through -- follows the motion from a state through other frequencies
    finer   -- how often steps may be made finer
    """

    Omega: Floats
    F_0: float
    motions: Sequence[SteadyState | None]
    through: Callable[[Floats, float, float], Visited]
    finer: int = OFTEN

    def jumps(self) -> tuple[tuple[float, float], ...]:
        """Pairs of neighbouring frequencies."""
        found, i = [], 0
        while i < self.Omega.size - 1:
            motion = self.motions[i]
            if motion is None or self.Omega[i] == self.Omega[i + 1]:
                i += 1
                continue
            try:
                with limited():
                    i, jumps, certain = self._follow_branch(i, motion)
            except ArithmeticError:  # it cannot be followed in reasonable time
                i, jumps, certain = i + 1, False, True
            if jumps and (certain or self._jumps_finer(i)):
                found.append((float(self.Omega[i - 1]), float(self.Omega[i])))
        return tuple(found)

    def _jumps_finer(self, j: int) -> bool:
        """Whether there is a jump in finer steps too, from the frequency before number j on to that."""
        before, after = self.motions[j - 1], self.motions[j]
        if not self.finer or before is None or after is None:
            return True
        Omega = np.linspace(self.Omega[j - 1], self.Omega[j], FINER + 1)
        try:
            motions = [before, *self.through(Omega[1:], *before._state(0.0))[1]]
        except ArithmeticError:
            return True
        last = motions[-1]
        if last is None or abs(last.A - after.A) > SAME * after.A:
            return True
        return bool(Branches(Omega, self.F_0, motions, self.through, self.finer - 1).jumps())

    def _follow_branch(self, i: int, motion: SteadyState) -> tuple[int, bool, bool]:
        """At which frequency the motion is none of the branch any more, whether it jumps there, and if that is certain.

        That at which the frequency turns, or the last, where it is one up to there.
        """
        sense = math.copysign(1.0, self.Omega[i + 1] - self.Omega[i])
        j, end = i + 1, i + 1
        while end + 1 < self.Omega.size and sense * (self.Omega[end + 1] - self.Omega[end]) > 0:
            end += 1
        path, points = self._path(motion, self.Omega[i], self.Omega[end]), list[Point]()
        try:
            for point in path.follow(path.begin(motion, sense)):
                points.append(point)
                while j <= end and len(points) > 1 and sense * (self.Omega[j] - point.z[-1]) <= 0.0:
                    there = path.at(float(self.Omega[j]), points[-2], point)
                    if there is None or not self._on_branch(j, there):
                        return j, self._jumps_off(j, there, points), _is_stable(points[:-1])
                    j += 1
                if j > end:
                    return end, False, True
                if passed_fold(points):
                    return j, self._jumps_at_fold(j, points[-2]), _is_stable(points[:-2])
        except ArithmeticError:
            pass
        return j, self._jumps_off(j, None, points), False

    def _path(self, motion: SteadyState, one: float, other: float) -> Path:
        low, high = sorted((float(one), float(other)))
        return Path(self.F_0, low, high, STEP, motion)

    def _on_branch(self, j: int, point: Point) -> bool:
        """Whether the motion at a frequency is that of the branch."""
        motion = self.motions[j]
        return motion is not None and abs(motion.A - point.A) <= SAME * point.A

    def _jumps_off(self, j: int, there: Point | None, points: list[Point]) -> bool:
        """Whether a motion jumps that is not on the branch through the points at number j, which has no fold before.

        there -- the branch at that frequency, None where it does not come so far
        """
        if there is not None and there.stable:
            return True
        if self.motions[j] is None:  # chaotic, say: where it comes from is not known
            return False
        back, turned = self._back_from(j)
        if turned:
            return not self._meet(points, back[-2])
        motion, last = self.motions[j - 1], back[-1]
        returns = float(last.z[-1]) == float(self.Omega[j - 1])
        return returns and not (motion is not None and abs(motion.A - last.A) <= SAME * last.A)

    def _jumps_at_fold(self, j: int, turn: Point) -> bool:
        """Whether the motion at number j is not on a branch through the point where the one before it turns.

        Where it is, that is no fold: a branch without symmetry, or of a longer period, ends there on the other.
        """
        if self.motions[j] is None:
            return True
        back, turned = self._back_from(j)
        return not self._meet(back[:-1] if turned else back, turn)

    def _back_from(self, j: int) -> tuple[list[Point], bool]:
        """The branch of the motion at number j back to the frequency before; whether it turns, at the last but one."""
        motion, Omega, before = self.motions[j], self.Omega[j], self.Omega[j - 1]
        assert motion is not None
        return self._path(motion, Omega, before).up_to_fold(motion, math.copysign(1.0, before - Omega))

    def _meet(self, points: list[Point], turn: Point) -> bool:
        """Whether the branch through the points passes the one at which another turns."""
        Omega = float(turn.z[-1])
        for one, other in itertools.pairwise(points):
            if min(one.z[-1], other.z[-1]) <= Omega <= max(one.z[-1], other.z[-1]):
                there = Path(self.F_0, 0.0, math.inf, STEP, one).at(Omega, one, other)
                return there is not None and abs(there.A - turn.A) <= MEETS * turn.A
        return False


def _is_stable(points: list[Point]) -> bool:
    """Whether a branch is stable at all of its points but folds and borders."""
    return all(point.stable for point in points if not point.role)
