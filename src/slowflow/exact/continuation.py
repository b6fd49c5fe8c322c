"""Continuation of periodic motions over Omega, through folds and through every change in the order of switches.

Within one order of switches the curve is smooth (see `cycle`) and followed by pseudo-arclength; every point is then
followed through its switches. Where the order changes the border is solved for, and the curve is taken up on the other
side: a fold that sits on the border (`corner`) is found as such, and no fold is made up there.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from slowflow.core.backend import EXACT
from slowflow.core.mechanism import Floats
from slowflow.exact.cycle import Cycle, Equations, closed_cycle
from slowflow.exact.motion import Forced, follow, handle, spend, steps_left
from slowflow.exact.shooting import SteadyState
from slowflow.support.errors import NotSettled
from slowflow.support.text import text
from slowflow_kernels.exact_conventions import Pause

STEP = 0.02  # largest step: relative in u_0, radians in theta_0, half of it in Omega
SMALLEST_STEP = 1e-9
STRAIGHT = 0.98  # cosine of the largest angle between neighbouring tangents
LARGEST = 1e3  # amplitude, in rod lengths, beyond which a curve counts as unbounded
NEAR = 2e-3  # largest distance, in Omega and relative in u_0, of the first point beyond a border
COINCIDE = 1e-8  # neighbouring folds closer than this, in Omega and A, are one turn there and back by rounding
#: relative distance before a border at which the order of switches is tested, and which way the curve runs: nearer,
#: where motions touch a jump of the force, phases vanish like a square root, and rounding decides
TESTED = 1e-3
AT_BORDER = 1e-10  # a span, or a margin, that counts as zero
MOST_POINTS = 20_000
TRACE_POINTS = 50  # points at a time: some milliseconds, after which Ctrl-C is heard
PASSES = "the response curve at {F_0 = :} passes {A = :g} at {Omega = :.9g}: {why:s}choose a range on one side of it"
ENDS = "the response curve at {F_0 = :} cannot be followed beyond {Omega = :.9g}, {A = :.9g}"
JUMPS = (
    "the response curve at {F_0 = :} ends at {Omega = :.9g}, {A = :.9g}: there the mass just stops or just breaks away,"
    " and as {mu_s} exceeds {mu}, the motion beyond is another one"
)
#: changes of u_0, relative, across the end of a curve, and how many times the last of them states then are apart
ACROSS, APART = (1e-6, 1e-8), 1e2
FOLDS = ("fold", "corner")  # roles of points
#: where the point that is found last is none of those that are followed
BEFORE = (Pause.BENDS, Pause.LEAVES, Pause.SWITCHES)


class LostCurve(NotSettled):
    """The curve cannot be followed beyond the last point that was found."""


class CurveEnds(LostCurve):
    """The curve has no points beyond it."""


class Point(NamedTuple):
    """A motion on the curve, and how the curve goes on there."""

    cycle: Cycle
    z: Floats
    tangent: Floats
    #: largest |u| at a switch, and its derivative along the curve
    A: float
    rise: float
    monodromy: Floats
    role: str = ""  # "fold", "border", "corner"
    #: whether the motion really switches in the order of the cycle
    holds: bool = True
    #: the point before, in the same order of switches: its unknowns, its tangent
    previous: tuple[Floats, Floats] | None = None

    @classmethod
    def of(cls, cycle: Cycle, z: Floats, equations: Equations, tangent: Floats) -> Point:
        """The point where Newton's iteration ended."""
        return cls(cycle, z, tangent, equations.A, float(equations.of_A[:-1] @ tangent), equations.monodromy)

    def flip(self) -> Point:
        """The point with the curve run through the other way."""
        return self._replace(tangent=-self.tangent, rise=-self.rise, previous=None)

    @property
    def multipliers(self) -> NDArray[np.complex128]:
        found = self.cycle.multipliers(self.monodromy)
        return found**2 if self.cycle.sign == -1 else found

    @property
    def stable(self) -> bool:
        """Whether both lie inside the unit circle; at a fold rounding decides."""
        return bool(np.all(np.abs(self.multipliers) < 1.0))


def is_same(fold: Point, other: Point) -> bool:
    """Whether two folds agree within the accuracy of a fold."""
    return abs(float(fold.z[-1] - other.z[-1])) < COINCIDE and abs(fold.A - other.A) < COINCIDE


def passed_fold(points: list[Point]) -> bool:
    """Whether a branch has a fold at the last point but one; one there and back by rounding is none."""
    if len(points) < 2 or points[-2].role not in FOLDS:
        return False
    if points[-1].role in FOLDS and is_same(points[-2], points[-1]):
        del points[-2:]
        return False
    return True


class Path:
    """Follows a curve of cycles point by point.

    start -- a motion of the curve; steps of asymmetric motions, whose u_0 may pass 0, are relative to its amplitude
    """

    def __init__(self, F_0: float, low: float, high: float, step: float, start: SteadyState | Point) -> None:
        self.F_0, self.low, self.high, self.step = F_0, low, high, step
        self.least = 0.0 if start.cycle.system.centred else start.A
        self.closed = False
        self.restarts = True  # whether cycles are restarted at their highest point before their order is changed

    def begin(self, start: SteadyState, direction: float) -> Point:
        """The first point, to be left towards rising (direction 1) or falling Omega."""
        cycle, z = start.cycle, start.unknowns
        equations = cycle.equations(z, self.F_0)
        tangent = np.linalg.svd(equations.jacobian[:, :-1])[2][-1]
        return Point.of(cycle, z, equations, self._unit(z, math.copysign(1.0, direction * tangent[-1]) * tangent))

    def follow(self, point: Point) -> Iterator[Point]:
        """The points from `point` on, until Omega leaves the range or the curve closes."""
        first = point
        yield point
        size, travelled = 0.1 * self.step, 0.0
        for _ in range(MOST_POINTS):
            points, pause, size, travelled = self._trace(point, size, TRACE_POINTS, first, travelled)
            beyond = points.pop() if pause in BEFORE else point
            if points:
                *before, new = point, *points
                yield from before[1:]
                if new.tangent[-1] * before[-1].tangent[-1] < 0:
                    fold = self._fold(before[-1], new, size)
                    if self._ends(fold):
                        raise CurveEnds(text(JUMPS, self.F_0, fold.z[-1], fold.A))
                    yield fold
                yield new
                if new.A > LARGEST:
                    unbounded = new.cycle.system.zeta == new.cycle.system.eta == 0
                    why = "without viscous damping resonance is unbounded (27); " if unbounded else ""
                    raise NotSettled(text(PASSES, self.F_0, LARGEST, new.z[-1], why))
                point = new
            if pause == Pause.CLOSES:
                self.closed = True
                return
            if pause in (Pause.FULL, Pause.TURNS):
                size = min(1.5 * size, self.step)
                continue
            if pause == Pause.LEAVES:
                yield self.at(self.high if beyond.z[-1] >= self.high else self.low, point, beyond) or beyond
                return
            if pause == Pause.SWITCHES and (crossed := self._cross(point, size)) is not None:
                yield from crossed
                point = crossed[-1]
                size = 0.05 * self.step
                continue
            size *= 0.5
            if size < SMALLEST_STEP:
                if not self.restarts or point.cycle.system.centred:
                    break
                # once more: an asymmetric cycle that starts elsewhere may have its start at the border
                self.restarts, size = False, 0.1 * self.step
        if self._ends(point):
            raise CurveEnds(text(JUMPS, self.F_0, point.z[-1], point.A))
        raise LostCurve(text(ENDS, self.F_0, point.z[-1], point.A))

    def _ends(self, point: Point) -> bool:
        """Whether static friction makes motions jump there: they do not come nearer as their starts do."""
        cycle, z = point.cycle, point.z
        if not cycle.system.mu_s > cycle.system.mu:
            return False
        forced, theta = Forced(cycle.system, float(z[-1]), self.F_0), float(z[1])
        start = cycle.signature[0] if cycle.starts_sticking else None
        distances = []
        for offset in (change * point.A for change in ACROSS):
            ends = []
            for u in (float(z[0]) - offset, float(z[0]) + offset):
                try:
                    last = follow(forced, theta, u, 0.0, theta + math.pi * cycle.half_turns, start)[-1]
                except ArithmeticError:
                    return False
                ends.append((last.u_end, last.v_end))
            distances.append(math.dist(*ends))
        return distances[1] > max(APART * offset, 0.5 * distances[0])

    def up_to_fold(self, start: SteadyState, direction: float) -> tuple[list[Point], bool]:
        """The points from a motion on up to the first beyond a fold, and whether there is one before the curve ends."""
        points: list[Point] = []
        with contextlib.suppress(ArithmeticError):
            for point in self.follow(self.begin(start, direction)):
                points.append(point)
                if passed_fold(points):
                    return points, True
        return points, False

    def _trace(
        self, point: Point, size: float, most: int, first: Point | None = None, travelled: float = 0.0
    ) -> tuple[list[Point], Pause, float, float]:
        """Up to so many points after one, in steps that begin with `size`; the last step, and the way from the first.

        Where it pauses before a point, that is the last one.
        """
        cycle, n = point.cycle, point.z.size
        begins = first is not None and first.cycle.signature == cycle.signature
        start = np.concatenate((first.z, first.tangent)) if first is not None and begins else np.empty(0)
        last = np.concatenate((point.z, point.tangent, *(point.previous or ())))
        rows = np.empty((most, 2 * n + 7))
        limits = (self.low, self.high, self.step, STRAIGHT, LARGEST, self.least)
        count, steps, pause, size, travelled = EXACT.trace(
            *(handle(cycle.system), cycle.packed, cycle.half_turns, cycle.starts_sticking, self.F_0, limits),
            *(last, size, travelled, start, steps_left(), rows),
        )
        spend(steps, keep=count > 0)
        points: list[Point] = []
        previous = point.z, point.tangent
        rows = rows[: count + (pause in BEFORE)]
        for row, (A, rise, *_, holds) in zip(rows, rows[:, 2 * n :].tolist(), strict=True):
            points.append(Point(cycle, row[:n], row[n : 2 * n], A, rise, row[2 * n + 2 : -1], "", holds > 0, previous))
            previous = points[-1].z, points[-1].tangent
        return points, Pause(pause), size, travelled

    def _weights(self, z: Floats) -> Floats:
        # spans count too: where phases are about to vanish, the curve is smooth in them and in nothing else
        weights = np.full(z.size, 0.1)
        weights[0] = 1.0 / max(abs(float(z[0])), self.least) ** 2
        weights[1] = 1.0
        weights[-1] = 4.0
        return weights

    def _unit(self, z: Floats, tangent: Floats | None) -> Floats:
        """The tangent at z, of unit length."""
        assert tangent is not None
        unit: Floats = tangent / math.sqrt(float(tangent @ (self._weights(z) * tangent)))
        return unit

    def _correct(self, point: Point, size: float) -> Point | None:
        """The point of the curve at arclength `size` from `point`, whether or not its order of switches holds."""
        if size == 0.0:
            return point
        points, *_ = self._trace(point, size, 1)
        return points[0] if points else None

    def at(self, Omega: float, before: Point, after: Point) -> Point | None:
        """The point of the curve at a frequency between two others; None where Newton's iteration finds none."""
        for base, other in ((before, after), (after, before)):
            z = base.z.copy()
            if base.cycle.signature == other.cycle.signature:
                step = float(other.z[-1] - base.z[-1])
                z += (0.0 if step == 0.0 else (Omega - float(base.z[-1])) / step) * (other.z - base.z)
            z[-1] = Omega
            found = self._solve_fixed(base.cycle, z, -1)
            if found is not None and found.holds:
                return found if float(found.tangent @ (self._weights(z) * base.tangent)) > 0 else found.flip()
        return None

    def _fold(self, point: Point, new: Point, size: float) -> Point:
        """Where the tangent's Omega component vanishes."""
        return self._zero(lambda at: float(at.tangent[-1]), point, new, size)._replace(role="fold")

    def _zero(
        self, function: Callable[[Point], float], point: Point, new: Point, size: float, within: float = 1e-13
    ) -> Point:
        """Where a function vanishes between `point` and `new`, within a bound: regula falsi (Illinois) on the curve."""
        a, b = 0.0, size
        at_a, at_b = function(point), function(new)
        middle = new
        for _ in range(60):
            c = (a * at_b - b * at_a) / (at_b - at_a)
            corrected = self._correct(point, c)
            if corrected is None:
                break
            middle = corrected
            at_c = function(middle)
            if at_c == 0.0 or abs(at_c) < within:
                break
            if at_c * at_b < 0:
                a, at_a = b, at_b
            else:
                at_a *= 0.5
            b, at_b = c, at_c
            if abs(b - a) < 1e-14:
                break
        return middle

    def summit(self, base: Point, other: Point) -> Point | None:
        """Where A, which rises from `base` along its tangent, turns before `other`; None if it does not."""
        # a lower bound of their distance along the curve, to which the phases contribute
        size = math.hypot(other.A / base.A - 1.0, 2.0 * float(other.z[-1] - base.z[-1]))
        for _ in range(8):
            there = self._correct(base, size)
            if there is None:
                return None
            if there.rise < 0.0:
                found = self._zero(lambda at: at.rise, base, there, size)
                return found if found.holds else None
            if not there.holds:
                return None
            size *= 2.0
        return None

    def _fold_behind(self, new: Point) -> Point | None:
        """A fold between a border and the first point beyond it, found going back."""
        back = new.flip()
        size = SMALLEST_STEP
        while size < self.step:
            there = self._correct(back, size)
            if there is None or not there.holds:
                return None
            if there.tangent[-1] * back.tangent[-1] < 0:
                fold = self._fold(back, there, size)
                return fold.flip()
            size *= 1.5
        return None

    def _cross(self, point: Point, size: float) -> list[Point] | None:
        """The border beyond `point`, and a first point with the new order of switches; a fold before it, if any."""
        limit = self._order_limit(point, size)
        before, last = (self._correct(point, size) for size in ((1.0 - TESTED) * limit, limit))
        if before is None or last is None:
            return None
        for beyond in (1e-4, 1e-3, 1e-5, 1e-2, 1e-6):
            trial = self._correct(point, limit + beyond * self.step * 10)
            if trial is None:
                continue
            new = self._other_side(last, trial)
            if new is not None:
                sense = point.tangent[-1]
                found = []
                if sense * before.tangent[-1] < 0:
                    found.append(self._fold(point, before, (1.0 - TESTED) * limit))
                    sense = before.tangent[-1]
                border, after = self._border(last, new), [new]
                outgoing = new.tangent[-1]
                if (new.z[-1] - border.z[-1]) * outgoing < 0 and abs(new.z[-1] - border.z[-1]) > COINCIDE:
                    fold = self._fold_behind(new)
                    if fold is not None:
                        after, outgoing = [fold, new], -outgoing
                found.append(border._replace(role="corner") if sense * outgoing < 0 else border)
                return found + after
        return None

    def _order_limit(self, point: Point, size: float) -> float:
        """The arclength up to which the order of switches holds that is lost at `size`.

        A zero of a span or a margin is found to rounding, and the order is tested just before it. Otherwise, as where
        the mass stops within a slip, the interval is bisected.
        """
        border = self._border_ahead(point, size)
        if border is None:
            return self._halved(point, size)
        before = (1.0 - TESTED) * border
        return border if self._holds_at(point, before) else self._halved(point, before)

    def _border_ahead(self, point: Point, size: float) -> float | None:
        """The arclength at which the first of the spans and margins vanishes that are lost at `size`; None if none is.

        The search runs along the curve: with a span of zero the equations have other solutions as well.
        """
        there = self._correct(point, size)
        if there is None:
            return None
        spans = point.z.size - 3

        def values(at: Point) -> list[float]:
            """Its spans and margins."""
            return [*at.z[2:-1].tolist(), *(one.margin for one in at.cycle.equations(at.z, self.F_0).borders)]

        pairs = enumerate(zip(values(point), values(there), strict=True))
        vanishing = [(here / (here - beyond), i) for i, (here, beyond) in pairs if beyond < 0.0 < here]
        if not vanishing:
            return None
        _, first = min(vanishing)

        def value(at: Point) -> float:
            return float(at.z[2 + first]) if first < spans else values(at)[first]

        found = self._zero(value, point, there, size, within=AT_BORDER)
        return float((self._weights(point.z) * point.tangent) @ (found.z - point.z))

    def _halved(self, point: Point, size: float) -> float:
        """The arclength up to which the order of switches holds, by bisection."""
        low, high = 0.0, size
        for _ in range(24):
            middle = 0.5 * (low + high)
            if self._holds_at(point, middle):
                low = middle
            else:
                high = middle
        return low

    def _holds_at(self, point: Point, size: float) -> bool:
        """Whether the order of switches holds at an arclength."""
        at = self._correct(point, size)
        return at is not None and at.holds

    def _other_side(self, last: Point, trial: Point) -> Point | None:
        """A point near the border with the new order of switches."""
        start = last.cycle.highest(last.z, self.F_0) if self.restarts else 0
        last, trial = (self._restart(point, start) for point in (last, trial))
        nearest, best = None, NEAR
        for cycle, z in self._orders(trial):
            if cycle.order == last.cycle.order or not cycle.consistent:
                continue
            for index in (0, -1):
                for offset in (0.0, 1e-6, -1e-6, 1e-5, -1e-5, 1e-4, -1e-4):
                    at = z.copy()
                    at[index] = z[index] * (1.0 + offset)
                    new = self._solve_fixed(cycle, at, index)
                    if new is None or not new.holds:
                        continue
                    size = max(abs(float(last.z[0])), self.least)
                    distance = max(abs(float(new.z[0] - last.z[0])) / size, abs(float(new.z[-1] - last.z[-1])))
                    if distance < best:
                        nearest, best = new, distance
                    if best < 1e-5:
                        return self._orient(new, last)
        return None if nearest is None else self._orient(nearest, last)

    def _restart(self, point: Point, phase: int) -> Point:
        if phase == 0:
            return point
        cycle, z = point.cycle.restart(point.z, self.F_0, phase)
        # only its cycle and unknowns are valid: the tangent is that of the other start
        return point._replace(cycle=cycle, z=z, previous=None)

    def _orders(self, trial: Point) -> Iterator[tuple[Cycle, Floats]]:
        """Orders of switches that may hold beyond a border, with trial unknowns; `trial` has the order that is lost."""
        cycle, z = trial.cycle, trial.z
        if np.min(z[2:-1]) < 1e-2:
            # phases that come to nothing together need not do so at the same rate
            for short in (0.0, 1e-3, 1e-2, 5e-2):
                found = _without_short(trial, short)
                if found is not None:
                    yield found
        for border in cycle.equations(z, self.F_0).borders:
            if border.margin < 0.0 and not border.sticking:
                found = cycle.with_excursion(z, self.F_0, border.phase)
                if found is not None:
                    yield found
        found = self._simulated_order(trial)
        if found is not None:
            yield found

    def _simulated_order(self, trial: Point) -> tuple[Cycle, Floats] | None:
        cycle, z = trial.cycle, trial.z
        forced = Forced(cycle.system, float(z[-1]), self.F_0)
        theta, u = float(z[1]), float(z[0])
        # a mass that breaks away may have passed a breakpoint at the border
        start = (-1, cycle.system.force.region_of(u)) if cycle.starts_sticking else None
        try:
            motion = follow(forced, theta, u, 0.0, theta + (cycle.half_turns + 3) * math.pi, start)
        except ArithmeticError:
            return None
        return closed_cycle(forced, cycle.half_turns, motion)

    def _solve_fixed(self, cycle: Cycle, z: Floats, index: int) -> Point | None:
        """The solution with one unknown kept, along which that rises."""
        row = np.zeros(z.size)
        row[index] = 1.0
        found = cycle.newton(z, self.F_0, row, float(z[index]))
        if found is None:
            return None
        tangent = self._unit(found[0], found[1].direction)
        return Point.of(cycle, *found, tangent)._replace(holds=cycle.holds(found[0], self.F_0))

    def _orient(self, new: Point, last: Point) -> Point:
        """The first point beyond a border with its tangent turned away from the border."""
        senses = [new, new.flip()]
        for size in (1e-4, 1e-3, 1e-2):
            there = [self._correct(point, size) for point in senses]
            valid = [point is not None and point.holds for point in there]
            if valid[0] != valid[1]:  # only one sense leads back across the border
                return senses[0] if valid[0] else senses[1]
        offset = new.z[[0, -1]] - last.z[[0, -1]]
        component = float(new.tangent[[0, -1]] @ (self._weights(new.z)[[0, -1]] * offset))
        return senses[0] if component > 0 else senses[1]

    def _border(self, last: Point, new: Point) -> Point:
        """The border between two orders of switches, solved for on the side with fewer phases."""
        simple = min((last, new), key=lambda p: len(p.cycle.signature))
        borders = simple.cycle.equations(simple.z, self.F_0).borders
        if borders:
            margins = [abs(border.margin) for border in borders]
            index = margins.index(min(margins))

            # to rounding: beyond a touching point everything grows like the square root of its error
            found = simple.cycle.newton(simple.z, self.F_0, border=index, tolerance=1e-16)
            # the border may also be a stop in mid-slip, which has no margin: then `last` is the best estimate
            if found is not None and abs(found[0][-1] - last.z[-1]) < 1e-5 and abs(found[1].A / last.A - 1) < 1e-5:
                return Point.of(simple.cycle, *found, simple.tangent)._replace(role="border")
        return last._replace(role="border")


def _without_short(trial: Point, short: float) -> tuple[Cycle, Floats] | None:
    """The cycle without the phases of at most that span; a slip that one of them cut in two is one again."""
    phases: list[tuple[int, int]] = []
    spans: list[float] = []
    for (slip, region), span in zip(trial.cycle.signature, trial.z[2:-1], strict=True):
        if span <= short:
            continue
        if slip == 0 and phases:  # at rest where the slip before it ended
            region = phases[-1][1]
        if phases and phases[-1] == (slip, region):
            spans[-1] += span
        else:
            phases.append((slip, region))
            spans.append(float(span))
    if not phases or phases[0][0] != -1:
        return None
    z = np.array([trial.z[0], trial.z[1], *spans, trial.z[-1]])
    return replace(trial.cycle, signature=tuple(phases)), z
