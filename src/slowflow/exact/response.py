"""Response curves over Omega through all folds, by continuation: amplitude, stability, stops, folds and borders."""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Iterator
from contextvars import Context
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slowflow.answers.answer import Drawn, Table
from slowflow.answers.transmissibility import Transmitted
from slowflow.core.mechanism import EquationOfMotion, Flags, Floats
from slowflow.exact.continuation import FOLDS, STEP, CurveEnds, LostCurve, Path, Point, is_same
from slowflow.exact.motion import Forced, OutOfWork, check_forcing, limited
from slowflow.exact.shooting import Limit, SteadyState, converge, describe, lengths, steady_state
from slowflow.support.errors import NotSettled, Refused
from slowflow.support.text import text

NEAR_TOP = 0.9  # fraction of the highest point's amplitude above which a segment of the curve may contain its peak
PARTLY = "only part of the curve: "
#: relative distances beyond a fold at which the motion that a sweep jumps to is determined, and its turns at most
FOLD_OFFSET, JUMP_OFFSET, JUMP_TURNS = 1e-5, 1e-3, 2000


@dataclass(frozen=True)
class Fold:
    """A saddle node of the curve.

    `kind` is the direction of the jump of a sweep, `corner` whether the order of switches changes there, for example
    because the springs just detach.
    """

    Omega: float
    A: float
    kind: str
    corner: bool


class ResponsePoint(NamedTuple):
    """A point of a `Response`."""

    Omega: float
    A: float
    stable: bool
    stops: int


@dataclass(frozen=True, eq=False)
class Response(Drawn, Table):
    """Exact response curve at one F_0; arrays run along the curve, empty where friction holds the mass at rest.

    Omega, A     -- frequency, largest |u|
    stable       -- whether both Floquet multipliers lie inside the unit circle
    multipliers  -- over one period, shape (points, 2)
    stops        -- number of stick phases per period
    folds        -- in ascending order of Omega
    borders      -- (Omega, A) where the order of switches changes
    closed       -- whether the curve closed on itself (an isola)
    message      -- other, disconnected curves, as predicted by averaging; where and why the computation stopped; empty
            if there is nothing to report
    complete     -- whether it was followed to its ends; if not, the points are those computed before it stopped
    """

    entry: ClassVar[Any] = ResponsePoint

    F_0: float
    Omega: Floats
    A: Floats
    stable: Flags
    multipliers: NDArray[np.complex128]
    stops: NDArray[np.int64]
    folds: tuple[Fold, ...]
    borders: tuple[tuple[float, float], ...]
    closed: bool
    states: tuple[Point, ...] = field(repr=False)
    message: str = ""
    complete: bool = True
    picture: ClassVar[str] = "motions"

    def steady_state(self, index: int) -> SteadyState:
        """The full steady state of a point of the curve."""
        point = self.states[index]
        return describe(point.cycle, point.z, self.F_0, point.monodromy)

    def transmitted(self, of: str = "force") -> Transmitted:
        """Transmissibility of each motion by first harmonic, peak and root mean square, arrays along the curve.

        See `SteadyState.transmitted`; about a millisecond per point.
        """
        values = [self.steady_state(k).transmitted(of) for k in range(len(self))]
        return Transmitted(*np.array(values).reshape(-1, 3).T)

    @functools.cached_property
    def peak(self) -> SteadyState:
        """The motion with the largest A on the curve, stable or not, also between computed points.

        It is a maximum along the curve, a border, or an end of the range.
        """
        if not self.states:
            raise NotSettled("no peak, as there is no motion: " + self.message)
        with limited():
            point = _highest(self.F_0, self.states)
        return describe(point.cycle, point.z, self.F_0, point.monodromy)


@limited()
def exact_response(
    system: EquationOfMotion,
    F_0: float,
    *,
    Omega: tuple[float, float] = (0.5, 1.5),
    start: SteadyState | None = None,
    step: float = STEP,
) -> Response:
    """Follow the response curve between two frequencies, through all its folds.

    start -- a point of the curve; by default the steady state at the lower frequency, reached from rest. A disconnected
             curve (an isola) needs its own start.
    step  -- largest distance between neighbouring points: relative change of u_0, radians of phase, twice the relative
             change of Omega

    A curve that takes more than `MOST_WORK` integration steps (about ten seconds), or that cannot be followed further,
    is returned as far as it was computed, with `complete` False. Raises ValueError for parameters out of range,
    ArithmeticError if no start is found, nothing beyond it is reached, or resonance is unbounded.
    """
    low, high = (float(end) for end in Omega)
    if not (0 < low < high < math.inf):
        raise Refused(text("{Omega = :r} must be ascending and positive", Omega))
    if not 0 < step <= 0.5:
        raise Refused(f"step = {step} must lie in (0, 0.5]")
    check_forcing(system, low, F_0)
    if start is None:
        start = steady_state(system, Omega=low, F_0=F_0)
    if not low <= start.Omega <= high:
        raise Refused(text("start.{Omega} = {Omega_0:r} lies outside {Omega = :r}", float(start.Omega), Omega))
    path = Path(F_0, low, high, step, start)
    forward, lost = _collect(path, path.begin(start, 1.0))
    closed = path.closed
    backward: list[Point] = []
    if not closed and start.Omega > low:
        backward, before = _collect(path, path.begin(start, -1.0))
        if lost is None or (isinstance(lost, CurveEnds) and before is not None):
            lost = before
    points = [point.flip() for point in reversed(backward[1:])] + forward
    if lost is not None and len(points) == 1:
        raise lost
    found = through(F_0, points, closed)
    if isinstance(lost, CurveEnds):
        return replace(found, message=lost.args[0])
    return found if lost is None else replace(found, message=PARTLY + lost.args[0], complete=False)


def _collect(path: Path, first: Point) -> tuple[list[Point], ArithmeticError | None]:
    """The points of a curve from the first on, and why there are no more of them; None where it came to its end."""
    points = [first]
    try:
        for point in itertools.islice(path.follow(first), 1, None):
            points.append(point)
    except LostCurve as lost:
        return points, lost
    except OutOfWork as used_up:
        where = text(", at {Omega = :.9g}, {A = :.9g}", points[-1].z[-1], points[-1].A)
        return points, NotSettled(used_up.args[0] + where)
    return points, None


def first_fold(start: SteadyState, towards: float, Omega_range: tuple[float, float]) -> ResponsePoint | None:
    """The first fold of the curve from a steady state, towards increasing (1) or decreasing (-1) Omega.

    None if the curve leaves the range of Omega before, or cannot be followed.
    """
    points, turned = Path(start.F_0, *Omega_range, STEP, start).up_to_fold(start, towards)
    if not turned:
        return None
    fold = points[-2]
    return ResponsePoint(float(fold.z[-1]), fold.A, False, fold.cycle.stops)


def _highest(F_0: float, points: tuple[Point, ...]) -> Point:
    """The highest point of the curve through the points, between them too."""
    best = max(points, key=lambda point: point.A)
    path = Path(F_0, 0.0, math.inf, STEP, best)
    least = NEAR_TOP * best.A
    for a, b in itertools.pairwise(points):
        if max(a.A, b.A) < least:
            continue
        back = [point.flip() for point in (b, a)]
        for base, other in ((a, b), back):
            # in another order of switches the slope beyond the border is unrelated to that before it
            if base.rise > 0.0 and (other.rise <= 0.0 or other.cycle.order != base.cycle.order):
                found = path.summit(base, other)
                if found is not None and found.A > best.A:
                    best = found
                    break
    return best


def _fold_at(F_0: float, i: int, points: list[Point]) -> Fold:
    """A fold of a curve through points, and whether a sweep goes to a larger amplitude there or to a smaller one.

    It is read off the stable motions of the curve beyond the fold if all are larger or all smaller; otherwise, as where
    a sweep jumps to another curve, the motion of the fold is followed in time from there.
    """
    fold = points[i]
    at, A = float(fold.z[-1]), fold.A
    # the curve lies on one side of a fold: a neighbour farther off may have turned again
    ends = max((float(points[k].z[-1]) - at for k in (i - 1, i + 1)), key=abs)
    larger = {motion > A for motion in _stable_at(at * (1.0 - math.copysign(FOLD_OFFSET, ends)), points)}
    # nearer to the fold a motion lingers for thousands of turns before it falls
    up = larger.pop() if len(larger) == 1 else _jumps_up(F_0, fold, at * (1.0 - math.copysign(JUMP_OFFSET, ends)))
    return Fold(at, A, "jump-up" if up else "jump-down", fold.role == "corner")


def _stable_at(Omega: float, points: list[Point]) -> Iterator[float]:
    """Amplitudes of the stable motions of a curve at a frequency, between its points."""
    for one, other in itertools.pairwise(points):
        here, there = float(one.z[-1]) - Omega, float(other.z[-1]) - Omega
        if here * there < 0.0 and all(point.stable for point in (one, other) if point.role not in FOLDS):
            yield (here * other.A - there * one.A) / (here - there)


def _jumps_up(F_0: float, fold: Point, Omega: float) -> bool:
    """Whether the motion of a fold, followed just beyond it, converges to a larger one, or escapes."""
    system = fold.cycle.system

    def final() -> Limit:
        state = describe(fold.cycle, fold.z, F_0, fold.monodromy)._state(0.0)
        return converge(Forced(system, Omega, F_0), 0.0, *state, lengths(system), JUMP_TURNS)

    try:
        # with steps of its own: the folds of an incomplete curve are classified as well
        end = Context().run(limited()(final))
    except ArithmeticError:
        return True
    A = max(abs(phase.u_end) for phase in end.phases) if end.found is None else end.found.A
    return A > fold.A


def through(F_0: float, points: list[Point], closed: bool, message: str = "") -> Response:
    """The curve through points; of a mass that stays at rest through none, with the reason."""
    multipliers = np.array([point.multipliers for point in points], dtype=np.complex128).reshape(-1, 2)
    # at a fold one multiplier is 1 up to rounding
    at_fold = np.array([point.role in FOLDS for point in points], dtype=bool)
    stable = np.all(np.abs(multipliers) < 1.0, axis=1) & ~at_fold
    folds: list[int] = []
    for i in (np.flatnonzero(at_fold[1:-1]) + 1).tolist():
        if folds and is_same(points[folds[-1]], points[i]):
            folds.pop()  # there and back: none
        else:
            folds.append(i)
    found = (_fold_at(F_0, i, points) for i in folds)
    return Response(
        F_0=F_0,
        Omega=np.array([float(point.z[-1]) for point in points]),
        A=np.array([point.A for point in points]),
        stable=stable,
        multipliers=multipliers,
        stops=np.array([point.cycle.stops for point in points], dtype=np.int64),
        folds=tuple(sorted(found, key=lambda fold: fold.Omega)),
        borders=tuple((float(p.z[-1]), p.A) for p in points if p.role in ("border", "corner")),
        closed=closed,
        states=tuple(points),
        message=message,
    )
