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
from slowflow_kernels.exact_conventions import ALONG

STEP = 0.02  # largest step: relative in u_0, radians in theta_0, half of it in Omega
SMALLEST_STEP = 1e-9
STRAIGHT = 0.98  # cosine of the largest angle between neighbouring tangents
LARGEST = 1e3  # amplitude, in rod lengths, beyond which a curve counts as unbounded
NEAR = 2e-3  # largest distance, in Omega and relative in u_0, of the first point beyond a border
COINCIDE = 1e-8  # neighbouring folds closer than this, in Omega and A, are one turn there and back by rounding
LEVEL = 1e-5  # Omega component of a tangent that counts as zero, as where phases vanish like a square root
#: relative distance before a border at which the order of switches is tested: nearer, where motions touch a jump of
#: the force, rounding decides
BEFORE = 1e-3
AT_BORDER = 1e-10  # a span, or a margin, that counts as zero
MOST_POINTS = 20_000
TRACE_POINTS = 50  # points at a time: some milliseconds, after which Ctrl-C is heard
PASSES = "the response curve at {F_0 = :} passes {A = :g} at {Omega = :.9g}: {why:s}choose a range on one side of it"
ENDS = "the response curve at {F_0 = :} cannot be followed beyond {Omega = :.9g}, {A = :.9g}"
FOLDS = ("fold", "corner")  # roles of points


class LostCurve(NotSettled):
    """The curve cannot be followed beyond the last point that was found."""


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
    #: the point before, in the same order of switches: its unknowns, its tangent, and the row by which it measured
    previous: tuple[Floats, Floats, Floats] | None = None

    @classmethod
    def of(cls, cycle: Cycle, z: Floats, equations: Equations, tangent: Floats) -> Point:
        """The point where Newton's iteration ended."""
        return cls(cycle, z, tangent, equations.A, float(equations.of_A[:-1] @ tangent), equations.monodromy)

    def flip(self) -> Point:
        """The point with the curve run through the other way."""
        return self._replace(tangent=-self.tangent, rise=-self.rise, previous=None)

    def predict(self, row: Floats, size: float) -> Floats:
        """Predict the unknowns at a distance measured by that row: cubic Hermite extrapolation, or the tangent."""
        if self.previous is None:
            return self.z + size * self.tangent
        z, tangent, before = self.previous
        # the cubic through both points along both tangents, over the distance as measured at the first
        chord, rate = self.z - z, float(before @ self.tangent)
        far = float(before @ chord)
        x = size * rate / far
        here, there = (far / rate) * self.tangent - chord, far * tangent - chord
        bent = self.z + size * self.tangent + x * x * ((2.0 + x) * here + (1.0 + x) * there)
        return bent + (size - float(row @ (bent - self.z))) * self.tangent

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
        tangent = self._tangent(z, equations, np.append(np.zeros(z.size - 1), direction))
        return Point.of(cycle, z, equations, tangent)

    def follow(self, point: Point) -> Iterator[Point]:
        """The points from `point` on, until Omega leaves the range or the curve closes."""
        first = point
        yield point
        size = 0.1 * self.step
        travelled = 0.0
        for _ in range(MOST_POINTS):
            traced, size, travelled = self._trace(point, first, size, travelled)
            yield from traced
            point = traced[-1] if traced else point
            if len(traced) == TRACE_POINTS:
                continue
            new = self._correct(point, size)
            if new is not None and self._is_small(point, new, size):
                if not self.low < float(new.z[-1]) < self.high:
                    yield self._at_end(point, new)
                    return
                if new.cycle.holds(new.z, self.F_0):
                    if new.tangent[-1] * point.tangent[-1] < 0:
                        yield self._fold(point, new, size)
                    yield new
                    if new.A > LARGEST:
                        unbounded = new.cycle.system.zeta == new.cycle.system.eta == 0
                        why = "without viscous damping resonance is unbounded (27); " if unbounded else ""
                        raise NotSettled(text(PASSES, self.F_0, LARGEST, new.z[-1], why))
                    travelled += size
                    if travelled > 10 * self.step and self._meets(point, new, first):
                        self.closed = True
                        return
                    point = new
                    size = min(1.5 * size, self.step)
                    continue
                crossed = self._cross(point, size)
                if crossed is not None:
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
        raise LostCurve(text(ENDS, self.F_0, point.z[-1], point.A))

    def up_to_fold(self, start: SteadyState, direction: float) -> tuple[list[Point], bool]:
        """The points from a motion on up to the first beyond a fold, and whether there is one before the curve ends."""
        points: list[Point] = []
        with contextlib.suppress(ArithmeticError):
            for point in self.follow(self.begin(start, direction)):
                points.append(point)
                if passed_fold(points):
                    return points, True
        return points, False

    def _trace(self, point: Point, first: Point, size: float, travelled: float) -> tuple[list[Point], float, float]:
        """Points after one as long as nothing is to be decided, in C; the next step and the way from the first."""
        cycle, n = point.cycle, point.z.size
        here = np.zeros(5 * n)  # unknowns and tangent, and those of the point before with its row, which C brings along
        arrays = (point.z, point.tangent, *(point.previous or ()))
        here[: len(arrays) * n] = np.concatenate(arrays)
        start = (first.z, first.tangent) if first.cycle.signature == cycle.signature else (np.empty(0),)
        rows = np.empty((TRACE_POINTS, 2 * n + 6))
        limits = (self.low, self.high, self.step, STRAIGHT, LARGEST, self.least)
        count, steps, size, travelled = EXACT.trace(
            *(handle(cycle.system), cycle.packed, cycle.half_turns, cycle.starts_sticking, self.F_0, limits, here),
            *(point.previous is not None, size, travelled, np.concatenate(start), steps_left(), rows),
        )
        spend(steps, keep=count > 0)
        points = [
            Point(cycle, row[:n], row[n : 2 * n], float(row[2 * n]), float(row[2 * n + 1]), row[2 * n + 2 :])
            for row in rows[:count]
        ]
        if points:
            points[-1] = points[-1]._replace(previous=(here[2 * n : 3 * n], here[3 * n : 4 * n], here[4 * n :]))
        return points, size, travelled

    def _weights(self, z: Floats) -> Floats:
        # spans count too: where phases are about to vanish, the curve is smooth in them and in nothing else
        weights = np.full(z.size, 0.1)
        weights[0] = 1.0 / max(abs(float(z[0])), self.least) ** 2
        weights[1] = 1.0
        weights[-1] = 4.0
        return weights

    def _tangent(self, z: Floats, equations: Equations, sense: Floats) -> Floats:
        """Unit tangent, in the sense of another."""
        tangent = np.linalg.svd(equations.jacobian[:, :-1])[2][-1]
        opposite = float(tangent @ (self._weights(z) * sense)) < 0
        return self._unit(z, -tangent if opposite else tangent)

    def _unit(self, z: Floats, tangent: Floats | None) -> Floats:
        """The tangent at z, of unit length."""
        assert tangent is not None
        unit: Floats = tangent / math.sqrt(float(tangent @ (self._weights(z) * tangent)))
        return unit

    def _correct(self, point: Point, size: float) -> Point | None:
        """The point of the curve at arclength `size` from `point`, whether or not its order of switches holds."""
        if size == 0.0:
            return point
        row = self._weights(point.z) * point.tangent
        # tangents are of unit length: the weighted distance along this one is the size
        value = float(row @ point.z) + size
        found = point.cycle.newton(point.predict(row, size), self.F_0, row, value, most=ALONG)
        if found is None:
            return None
        tangent = self._unit(found[0], found[1].direction)
        return Point.of(point.cycle, *found, tangent)._replace(previous=(point.z, point.tangent, row))

    def _is_small(self, a: Point, b: Point, size: float) -> bool:
        """Whether the curve is nearly straight between two points, and not much longer than the step between them."""
        return float(a.tangent @ (self._weights(a.z) * b.tangent)) > STRAIGHT and self._distance(a, b) < 2 * size

    def _distance(self, a: Point, b: Point) -> float:
        difference = b.z - a.z
        return math.sqrt(float(difference @ (self._weights(a.z) * difference)))

    def _at_end(self, point: Point, beyond: Point) -> Point:
        """The point where the curve leaves the range of Omega."""
        target = self.high if beyond.z[-1] >= self.high else self.low
        fraction = (target - point.z[-1]) / (beyond.z[-1] - point.z[-1])
        z = point.z + fraction * (beyond.z - point.z)
        z[-1] = target
        found = point.cycle.newton(z, self.F_0)
        if found is None:
            return beyond
        return Point.of(point.cycle, *found, self._tangent(found[0], found[1], point.tangent))

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
                return found if found.cycle.holds(found.z, self.F_0) else None
            if not there.cycle.holds(there.z, self.F_0):
                return None
            size *= 2.0
        return None

    def _fold_behind(self, new: Point) -> Point | None:
        """A fold between a border and the first point beyond it, found going back."""
        back = new.flip()
        size = SMALLEST_STEP
        while size < self.step:
            there = self._correct(back, size)
            if there is None or not there.cycle.holds(there.z, self.F_0):
                return None
            if there.tangent[-1] * back.tangent[-1] < 0:
                fold = self._fold(back, there, size)
                return fold.flip()
            size *= 1.5
        return None

    def _meets(self, a: Point, b: Point, first: Point) -> bool:
        """Whether the curve passes its first point between two neighbours."""
        if not (a.cycle.signature == b.cycle.signature == first.cycle.signature):
            return False
        weights = self._weights(first.z)
        before, after = (float((p.z - first.z) @ (weights * first.tangent)) for p in (a, b))
        near = min(self._distance(first, a), self._distance(first, b))
        return before < 0 <= after and near <= 2 * self.step

    def _cross(self, point: Point, size: float) -> list[Point] | None:
        """The border beyond `point`, and a first point with the new order of switches; a fold before it, if any."""
        limit = self._order_limit(point, size)
        last = self._correct(point, limit)
        if last is None:
            return None
        for beyond in (1e-4, 1e-3, 1e-5, 1e-2, 1e-6):
            trial = self._correct(point, limit + beyond * self.step * 10)
            if trial is None:
                continue
            new = self._other_side(last, trial)
            if new is not None:
                sense = point.tangent[-1]
                found = []
                if sense * last.tangent[-1] < 0 and abs(last.tangent[-1]) > LEVEL:
                    found.append(self._fold(point, last, limit))
                    sense = last.tangent[-1]
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
        before = (1.0 - BEFORE) * border
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
        return at is not None and at.cycle.holds(at.z, self.F_0)

    def _other_side(self, last: Point, trial: Point) -> Point | None:
        """A point near the border with the new order of switches."""
        start = last.cycle.highest(last.z, self.F_0) if self.restarts else 0
        last, trial = (self._restart(point, start) for point in (last, trial))
        nearest, best = None, NEAR
        for cycle, z in self._orders(trial):
            if cycle.order == last.cycle.order or not cycle.consistent:
                continue
            for index in (0, -1):
                row = np.zeros(z.size)
                row[index] = 1.0
                for offset in (0.0, 1e-6, -1e-6, 1e-5, -1e-5, 1e-4, -1e-4):
                    at = z.copy()
                    at[index] = z[index] * (1.0 + offset)
                    new = self._solve_fixed(cycle, at, row)
                    if new is None:
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
        start = cycle.signature[0] if cycle.starts_sticking else None
        theta = float(z[1])
        try:
            motion = follow(forced, theta, float(z[0]), 0.0, theta + (cycle.half_turns + 3) * math.pi, start)
        except ArithmeticError:
            return None
        return closed_cycle(cycle.system, cycle.half_turns, motion, forced.Omega)

    def _solve_fixed(self, cycle: Cycle, z: Floats, row: Floats) -> Point | None:
        """The solution with one unknown kept, if its order of switches holds."""
        found = cycle.newton(z, self.F_0, row, float(row @ z))
        if found is None or not cycle.holds(found[0], self.F_0):
            return None
        return Point.of(cycle, *found, self._unit(found[0], found[1].direction))

    def _orient(self, new: Point, last: Point) -> Point:
        """The first point beyond a border with its tangent turned away from the border."""
        senses = [new, new.flip()]
        for size in (1e-4, 1e-3, 1e-2):
            there = [self._correct(point, size) for point in senses]
            valid = [point is not None and point.cycle.holds(point.z, self.F_0) for point in there]
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
