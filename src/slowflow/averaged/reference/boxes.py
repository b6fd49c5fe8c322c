"""Points (Omega, A) at which two functions vanish: in go pieces of the force and a system, out come all of its points.

None is missed: a box of amplitudes and frequencies is left only when it is proved to hold no point, because one of
the functions has one sign on all of it, or exactly one, because Krawczyk's operator maps it into itself. Otherwise it
is cut. Where that goes on until no double lies between its ends, a double point to rounding, that it was undecided is
said. What h and its derivatives are on an interval of amplitudes is said in cells; intervals are rounded outwards, and
what kernels err by is taken for granted there.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slowflow import backend
from slowflow.averaged.reference.cells import (
    Cells,
    Samples,
    Stretch,
    amid,
    cells_of,
    joined,
    samples_at,
    stretches_up_to,
)
from slowflow.intervals import Bools, Interval
from slowflow.model import THROUGHOUT, Floats, Model
from slowflow_kernels import dissipation, dissipation_intervals, slow_flow, slow_flow_intervals
from slowflow_kernels.conventions import CLOSE, FIRST, NARROW, Status
from slowflow_support.errors import NotSettled

Ints = NDArray[np.intp]

#: two functions and their slopes, at points and on boxes, by what the system looks for
SYSTEMS: dict[str, tuple[Callable[..., Any], Callable[..., Any]]] = {
    "folds": (dissipation.folds, dissipation_intervals.folds),
    "peaks": (dissipation.peaks, dissipation_intervals.peaks),
    "cusps": (dissipation.cusps, dissipation_intervals.cusps),
    "isolas": (dissipation.isolas, dissipation_intervals.isolas),
    "turns": (dissipation.turns, dissipation_intervals.turns),
    "rest": (dissipation.rest, dissipation_intervals.rest),
    "stiffness": (dissipation.stiffness, dissipation_intervals.stiffness),
    "folds_by_inertia": (dissipation.folds_by_inertia, dissipation_intervals.folds_by_inertia),
    "peaks_by_inertia": (dissipation.peaks_by_inertia, dissipation_intervals.peaks_by_inertia),
    "isolas_by_inertia": (dissipation.isolas_by_inertia, dissipation_intervals.isolas_by_inertia),
}
#: numbers of those that are compiled, see native/points_work.h
COMPILED = {"folds": 0, "peaks": 1, "cusps": 2, "isolas": 3}
#: systems with F, with F_A, with F_Omega, and with the level of an excitation by inertia stationary
FORCED, FOLDED, PEAKED, STATIONARY = (
    {"folds", "peaks", "rest", "folds_by_inertia", "peaks_by_inertia"},
    {"folds", "cusps", "isolas", "turns", "stiffness", "folds_by_inertia", "isolas_by_inertia"},
    {"peaks", "isolas"},
    {"peaks_by_inertia", "isolas_by_inertia"},
)
INERTIAL = STATIONARY | {"folds_by_inertia"}
#: systems of points at Omega = 0, and how far from there they are looked for
STATIC, ASIDE = {"rest", "stiffness"}, 2.0**-20
#: how much of a frequency a box may span between amplitudes that are next to each other, and to a jump
THIN_ENOUGH = 2.0**-24
#: by how much more than A the average moves next to a jump
STEEP = 2.0**10
#: a frequency that counts as 0 where widths are compared
LOW = 2.0**-10
#: into how many orders a piece from A = 0 on is divided before the first look, and how many boxes are looked at at most
ORDERS, MOST = 7, 200_000
#: the same with a preload, of which the rest, 2^-59 of it, is left out: there x = A Omega^2 is all that counts, and
#: F = (x + h)^2 + m^2 - F_0^2 has no fold but where F_0 is m, or what holds the mass at rest, to rounding
ORDERS_OF_PRELOAD = 27
#: where a box is cut, not in its middle: what vanishes there would lie on the edges of two
ASKEW = 0.4375 + 2.0**-9
#: a box that keeps more than this of its area is cut, too
MUCH = 0.4
#: of Newton's steps from the middle of a box that holds one point
STEPS = 12


@dataclass(frozen=True, eq=False)
class Points:
    """Points of one system, by rising A.

    piece     -- on which of the pieces
    A, Omega  -- where
    A_undecided -- amplitudes of boxes that hold a number of points that doubles do not tell
    """

    piece: Ints
    A: Floats
    Omega: Floats
    A_undecided: Floats

    @property
    def undecided(self) -> bool:
        """Whether there are such boxes."""
        return bool(self.A_undecided.size)

    def take(self, which: Any) -> Points:
        """Some of them."""
        return Points(self.piece[which], self.A[which], self.Omega[which], self.A_undecided)

    def __len__(self) -> int:
        return self.A.size


@dataclass(eq=False)
class _Boxes:
    """Boxes: number of the piece, samples at both amplitudes, lowest and highest frequency."""

    piece: Ints
    a: Samples
    b: Samples
    low: Floats
    high: Floats

    def take(self, which: Any) -> _Boxes:
        return _Boxes(self.piece[which], self.a.take(which), self.b.take(which), self.low[which], self.high[which])

    def __len__(self) -> int:
        return self.low.size


def _all(parts: Sequence[_Boxes]) -> _Boxes:
    return _Boxes(
        np.concatenate([part.piece for part in parts]),
        joined(*(part.a for part in parts)),
        joined(*(part.b for part in parts)),
        np.concatenate([part.low for part in parts]),
        np.concatenate([part.high for part in parts]),
    )


class Searched:
    """One system of one model: its functions at points and on boxes."""

    def __init__(self, model: Model, system: str, F_0: float, pieces: Sequence[Stretch], most: float) -> None:
        self.model, self.system, self.F_0, self.most = model, system, F_0, most
        self.beyond = np.concatenate([piece.base > 0 for piece in pieces])
        self.at_points, self.on_boxes = SYSTEMS[system]
        self.names = tuple(inspect.signature(self.on_boxes).parameters)
        self.zeta, self.d = Interval.point(model.zeta), Interval.point(model.d)

    def rest(self, A: Interval, piece: Ints) -> tuple[Interval, ...]:
        """I_0 and its derivatives on amplitudes of a piece."""
        m, eta = Interval.point(self.model.m), Interval.point(self.model.laws.eta)
        found = tuple(_interval(one, A) for one in dissipation_intervals.at_rest(A, m, eta))
        beyond = self.beyond[piece]
        if self.model.laws.rubs == THROUGHOUT or not beyond.any():
            return found
        u_cr = Interval.point(self.model.breakpoints[0])
        other = dissipation_intervals.released(Interval(np.maximum(A.ends, u_cr.ends)), m, eta, u_cr)
        return tuple(two.where(beyond, one) for one, two in zip(found, other, strict=True))

    def _known(self, cells: Cells, piece: Ints, Omega: Interval) -> dict[str, Interval]:
        """What the functions take, on boxes."""
        A, zeta, d = cells.A, self.zeta, self.d
        I_0, I_0A, I_0AA, I_0AAA = self.rest(A, piece)
        # where h/A is nearly its slope, and both nearly -Omega^2, the second is the narrower one
        R, by_tangent = slow_flow_intervals.state_R(Omega, A, cells.h, cells.h_A, cells.k)
        return {
            **{"Omega": Omega, "A": A, "F_0": Interval.point(self.F_0), "zeta": zeta, "d": d},
            "R": R.both(by_tangent),
            "I": dissipation_intervals.I(Omega, A, I_0, zeta, d),
            **{"I_0": I_0, "I_0A": I_0A, "I_0AA": I_0AA, "I_0AAA": I_0AAA},
            **{"h": cells.h, "h_A": cells.h_A, "h_AA": cells.h_AA, "h_AAA": cells.h_AAA},
        }

    def _values(self, known: dict[str, Interval]) -> list[Interval]:
        found = self.on_boxes(*(known[name] for name in self.names))
        return [_interval(one, known["A"]) for one in self._with_Omega(found, known["Omega"])]

    def _with_Omega(self, found: Any, Omega: Any) -> Any:
        """Both functions and their slopes: at rest the other one is Omega."""
        if self.system not in STATIC:
            return found
        value, by_A, by_Omega = found
        return value, Omega, by_A, by_Omega, 0.0, 1.0

    def slopes(self, cells: Cells, piece: Ints, Omega: Interval) -> list[Interval]:
        """The four slopes on boxes."""
        return self._values(self._known(cells, piece, Omega))[2:]

    def empty(self, cells: Cells, piece: Ints, Omega: Interval) -> Bools:
        """Which boxes are known to hold no point, where R and I are what they can be at one."""
        if self.system in STATIC:
            Omega = Interval(np.zeros_like(Omega.ends))
        elif self.system in FOLDED:
            Omega = self._not_behind(cells, piece, Omega)
        known = self._known(cells, piece, Omega)
        A, zeta, d, R, lag = (known[name] for name in ("A", "zeta", "d", "R", "I"))
        I_A = dissipation_intervals.I_A(Omega, A, known["I_0A"], zeta, d)
        if self.system in FORCED:
            force = self._force(self.F_0, Omega)
            lag = lag.both(Interval(np.array((-force.hi, force.hi))))
            most = dissipation_intervals.R_of_response(force, lag)
            R = R.both(Interval(np.array((-most.hi, most.hi))))
        if self.system in PEAKED:
            R = R.both(dissipation_intervals.R_of_peak(Omega, A, zeta, d, lag))
        if self.system in FOLDED:
            R = R.both(dissipation_intervals.R_of_fold(Omega, cells.h_A, lag, I_A))
        if self.system == "turns":
            beside = Omega.square() * self._turn_share(1.0 / Omega, known)
            known["h_A"] = known["h_A"].both(dissipation_intervals.h_A_of_turn(Omega, A, R, beside))
        first, second, *_ = self._values({**known, "R": R, "I": lag})
        found = (R.lo > R.hi) | (lag.lo > lag.hi) | (Omega.lo > Omega.hi) | first.has_sign | second.has_sign
        if self.most < np.inf:
            found |= (R.square() + lag.square()).lo > self._force(self.most, Omega).hi ** 2 * (1 + 2.0**-40)
        if self.system in FOLDED:
            found |= dissipation_intervals.least_F_A(A, cells.k, lag, I_A).lo > 0
            found |= self._rises(cells, I_A, Omega) | self._far(known, Omega)
        found |= self._slides(cells, known, I_A)
        if self.system in INERTIAL:
            found |= self._far_by_inertia(known, Omega) | self._has_none_by_inertia(known, Omega)
        if self.system == "peaks_by_inertia":
            found |= self._far_from_peaks(cells, Omega)
        return np.asarray(found)

    def _not_behind(self, cells: Cells, piece: Ints, Omega: Interval) -> Interval:
        """The frequencies at which F_A/2 = R R_A + I I_A may vanish: below these R and R_A are negative, I_A is not.

        Where no stiffness holds at rest all terms vanish with A and Omega, by powers of their own: on a box down to
        Omega = 0 none is known to be the largest.
        """
        I_0A = self.rest(cells.A, piece)[1]
        behind = (cells.h.hi < 0) & (cells.h_A.hi < 0) & (I_0A.lo >= 0)
        # R_A vanishes where R of an amplitude of 1 does
        least = np.minimum(*(slow_flow.backbone(A, h.hi) for A, h in ((cells.A.hi, cells.h), (1.0, cells.h_A))))
        least = np.where(behind, least * (1 - 2.0**-40), 0.0)
        return Interval.of(np.maximum(Omega.lo, least), Omega.hi)

    def _slides(self, cells: Cells, known: dict[str, Interval], I_A: Interval) -> Bools:
        """Whether nothing pulls back, as in a play: F_A/2 = R R_A + I I_A > 0, and h R + I (I_0 + zeta A Omega) > 0.

        R is A Omega^2 at least, and R_A, which is Omega^2 at least, positive too. At Omega = 0 all of it vanishes, next
        to which no box would be small enough.
        """
        free = (cells.h.lo >= 0) & (known["I"].lo >= 0)
        if self.system in FOLDED - STATIC:
            return np.asarray(free & (cells.h_A.lo >= 0) & (I_A.lo >= 0))
        return np.asarray(free & (self.system == "peaks_by_inertia" and self.model.zeta > 0))

    def _force(self, F_0: float, Omega: Interval) -> Interval:
        """Amplitude of the force."""
        return Interval.point(F_0) * Omega.square() if self.model.inertial else Interval.of(0.0 * Omega.lo + F_0, F_0)

    def _far_by_inertia(self, known: dict[str, Interval], Omega: Interval) -> Bools:
        """Whether F, or what vanishes where the level is stationary, has one sign, in x = 1/Omega."""
        names = ("A", "F_0", "I_0", "zeta", "d", "h")
        F, stays, grows = dissipation_intervals.far_by_inertia(1.0 / Omega, *(known[name] for name in names))
        found = np.zeros(Omega.lo.shape, dtype=bool)
        if self.system in FORCED:
            found |= F.has_sign
        if self.system in STATIONARY:
            found |= (stays.lo > 0) | (stays.lo + Omega.lo * np.maximum(grows.lo, 0.0) > 2.0**-40 * np.abs(stays.lo))
            found |= (stays.hi < 0) & (self.model.zeta * self.model.d == 0)
        return found

    def _has_none_by_inertia(self, known: dict[str, Interval], Omega: Interval) -> Bools:
        """Whether F, or F_A, has one sign at each R that what else vanishes leaves, all over powers of Omega.

        Next to Omega = 0 that tells where h = 0, too. Where damping is weak the lower R of a stationary level is next
        to nothing: boxes along the backbone are told apart by I alone.
        """
        x = 1.0 / Omega
        names = ("A", "I_0", "I_0A", "zeta", "d", "h", "h_A")
        R, R_A, lag, I_A = dissipation_intervals.far(x, *(known[name] for name in names))
        force = Interval.point(self.F_0)
        if self.system in FORCED:
            lag = lag.both(Interval(np.array((-force.hi, force.hi)) + 0.0 * lag.ends))
        if self.system in FOLDED:
            one = Interval.point(1.0)
            R = R.both(dissipation_intervals.R_of_fold(one, x.square() * known["h_A"], lag, I_A))
        found, left = np.zeros(Omega.lo.shape, dtype=bool), [R]
        if self.system in STATIONARY:
            rest = (known[name] for name in ("A", "I_0", "zeta", "d"))
            square, *either = dissipation_intervals.R_where_stationary(x, *rest)
            found, left = square.hi < 0, [R.both(one) for one in either]
        none = np.ones(Omega.lo.shape, dtype=bool)
        for one in left:
            if self.system in FORCED:
                value = one.square() + lag.square() - force.square()
            else:
                value = dissipation_intervals.F_A_halved(one, R_A, lag, I_A)
            none &= (one.lo > one.hi) | value.has_sign
        return np.asarray(found | none | (lag.lo > lag.hi))

    def _far_from_peaks(self, cells: Cells, Omega: Interval) -> Bools:
        """Whether there is no peak on boxes that reach down to A = 0, by what both functions are over A^2."""
        A, start, model = cells.A, samples_at(self.model, 0.0), self.model
        slope = Interval.hull(np.minimum(start.h_A, cells.h_A.lo), np.maximum(start.h_A, cells.h_A.hi))
        over = dissipation.at_rest(A.hi, model.m, model.laws.eta)[0] / A.hi
        rest = Interval.of(over, np.full(over.shape, np.inf) if model.m > 0 else over)
        one = Interval.point(1.0)
        known = {
            **{"Omega": Omega, "A": one, "F_0": Interval.point(self.F_0) / A, "zeta": self.zeta, "d": self.d},
            **{"I_0": rest, "h": slope, "R": slope + Omega.square()},
            "I": dissipation_intervals.I_scaled(Omega, A, rest, self.zeta, self.d),
        }
        first, second, *_ = self.on_boxes(*(known.get(name, one) for name in self.names))
        return np.asarray((A.lo == 0) & (first.has_sign | second.has_sign))

    def _turn_share(self, x: Interval, known: dict[str, Interval]) -> Interval:
        names = ("A", "I_0", "I_0A", "zeta", "d")
        return _interval(dissipation_intervals.turn_share(x, *(known[name] for name in names)), x)

    def _far(self, known: dict[str, Interval], Omega: Interval) -> Bools:
        """Whether F_A has one sign on boxes without a highest frequency: that of F_A/Omega^4, in x = 1/Omega."""
        x = 1.0 / Omega
        names = ("A", "I_0", "I_0A", "zeta", "d", "h", "h_A")
        R, R_A, lag, I_A = dissipation_intervals.far(x, *(known[name] for name in names))
        if self.system == "turns":
            R_A = R_A.both(-((R + self._turn_share(x, known)) / known["A"]))
        return np.asarray(np.isinf(Omega.hi) & dissipation_intervals.F_A_halved(R, R_A, lag, I_A).has_sign)

    def _rises(self, cells: Cells, I_A: Interval, Omega: Interval) -> Bools:
        """Whether F_A is positive for 0 < A on boxes that reach down to A = 0, where it vanishes."""
        A, start, eta = cells.A, samples_at(self.model, 0.0), self.model.laws.eta
        slope = Interval.hull(np.minimum(start.h_A, cells.h_A.lo), np.maximum(start.h_A, cells.h_A.hi))
        over = dissipation.at_rest(A.hi, self.model.m, eta)[0] / A.hi
        lag = dissipation_intervals.I_scaled(Omega, A, Interval.of(over, over), self.zeta, self.d)
        value = dissipation_intervals.F_A_scaled(Omega, slope, cells.h_A, lag, I_A)
        w = np.maximum(Omega.lo, 0.0) * (1 - 2.0**-40)
        bend = np.abs(cells.h_AA.ends).max(axis=0)
        first, second = dissipation.least_scaled(w, self.model.zeta, eta, self.model.d, bend)
        least = first + A.hi**2 * np.minimum(second, 0.0) + np.where(first == 0, second, 0.0)
        return np.asarray((A.lo == 0) & (I_A.lo >= 0) & ((value.lo > 0) | (least > 2.0**-40 * first)))

    def values(self, A: Floats, h: Sequence[Floats], piece: Ints, Omega: Floats) -> list[Floats]:
        """The same at points."""
        model = self.model
        I_0 = model.at_rest(A, self.beyond[piece])
        known = {
            **{"Omega": Omega, "A": A, "F_0": self.F_0, "zeta": model.zeta, "d": model.d},
            "R": slow_flow.R(Omega, A, h[0]),
            "I": dissipation.I(Omega, A, I_0[0], model.zeta, model.d),
            **dict(zip(("I_0", "I_0A", "I_0AA", "I_0AAA"), I_0, strict=True)),
            **dict(zip(("h", "h_A", "h_AA", "h_AAA"), h, strict=True)),
        }
        found = self.at_points(*(known[name] for name in self.names))
        return [np.asarray(one + 0.0 * A) for one in self._with_Omega(found, Omega)]


def slopes_at(model: Model, system: str, points: Points, F_0: float) -> list[Floats]:
    """The four slopes of a system's functions at points of it."""
    pieces = stretches_up_to(model, np.inf if not points.A.size else 2 * float(points.A.max()))
    searched = Searched(model, system, F_0, pieces, np.inf)
    return searched.values(points.A, model.averaged(points.A), points.piece, points.Omega)[2:]


def _interval(value: Any, like: Interval) -> Interval:
    """What a kernel gives, a number too, as intervals of the shape of others."""
    ends = value.ends if isinstance(value, Interval) else np.full((2, 1), value)
    return Interval(np.broadcast_to(ends, like.ends.shape))


def _compiled(model: Model, system: str, pieces: Sequence[Stretch], level: float) -> Points | None:
    """The same by the compiled search; None where that leaves boxes undecided."""
    ends = ([piece.first.A[0] for piece in pieces], [piece.last.A[0] for piece in pieces])
    bases = [float(piece.base[0]) for piece in pieces]
    found = backend.SOLVER.law_points(model.searched, COMPILED[system], level, *ends, bases)
    status, number, A, Omega, doubt = found
    if status != Status.OK or doubt.size:
        return None
    order = np.lexsort((Omega, A, number))
    return Points(number[order], A[order], Omega[order], doubt)


@np.errstate(all="ignore")
def points_of(model: Model, system: str, pieces: Sequence[Stretch], F_0: float = 0.0, most: float = np.inf) -> Points:
    """All points of a system on the pieces; most: the highest level that is asked for.

    Raises ArithmeticError where too many boxes stay undecided.
    """
    # under an excitation by inertia only folds are, which nobody asks for here where that is so
    if model.searched is not None and system in COMPILED and not model.inertial:
        compiled = _compiled(model, system, pieces, F_0 if system in FORCED else most)
        if compiled is not None:
            return compiled
    searched = Searched(model, system, F_0, pieces, most)
    base = np.concatenate([piece.base for piece in pieces])
    boxes = _first_boxes(searched, pieces, F_0 if system in FORCED else most)
    found, undecided, looked_at = [], [np.empty(0)], 0
    while len(boxes):
        looked_at += len(boxes)
        if looked_at > MOST:
            raise NotSettled("the response is unresolved: too many boxes of amplitude and frequency stay undecided")
        Omega = Interval.of(boxes.low, boxes.high)
        cells = cells_of(model, boxes.a, boxes.b, boxes.a)
        left = np.flatnonzero(~searched.empty(cells, boxes.piece, Omega))
        if not left.size:
            break
        boxes = boxes.take(left)
        slopes = searched.slopes(cells.take(left), boxes.piece, Omega.take(left))
        middle = amid(base[boxes.piece], boxes.a.A, boxes.b.A)
        inside = (middle > boxes.a.A) & (middle < boxes.b.A)
        middle = np.where(inside, middle, boxes.a.A)
        at = samples_at(model, middle)
        w = np.where(np.isinf(boxes.high), np.maximum(4 * boxes.low, 4.0), boxes.low + ASKEW * (boxes.high - boxes.low))
        single, gone, *left_over = _mapped(searched, boxes, at, w, slopes)
        if single.any():
            found.append((boxes.piece[single], *_solved(searched, boxes.take(single), at.A[single], w[single])))
        narrow = (boxes.b.A - boxes.a.A <= NARROW * boxes.b.A) | ~inside
        low, high = boxes.low, boxes.high
        # Omega = 0 is known of a static system: nothing is cut across it
        # next to a jump Omega moves by roots of roundings of A: finer boxes tell nothing
        span = cells.h.hi[left] - cells.h.lo[left]
        rounded = CLOSE * np.abs(boxes.a.h)
        steep = ~(span <= STEEP * (boxes.b.A - boxes.a.A) + rounded)
        width = np.where(steep & narrow, THIN_ENOUGH, NARROW)
        thin = np.isfinite(high) & (high - low <= width * np.maximum(np.abs(high), LOW)) | (system in STATIC)
        ends = ~single & ~gone & ((narrow & thin) | (boxes.b.A < FIRST))
        undecided.append(boxes.b.A[ends & (boxes.b.A >= FIRST)])
        kept = np.flatnonzero(~(single | gone | ends))
        boxes = _cut(
            searched,
            boxes.take(kept),
            at.take(kept),
            w[kept],
            (left_over[0].take(kept), left_over[1].take(kept)),
            (narrow[kept], thin[kept]),
            [one.take(kept) for one in slopes],
            span[kept],
            steep[kept],
        )
    if not found:
        none = np.empty(0)
        return Points(np.empty(0, np.intp), none, none, np.concatenate(undecided))
    of_piece, A, at_Omega = (np.concatenate(column) for column in zip(*found, strict=True))
    order = np.lexsort((at_Omega, A, of_piece))
    return Points(of_piece[order], A[order], at_Omega[order], np.concatenate(undecided))


def _first_boxes(searched: Searched, pieces: Sequence[Stretch], most: float) -> _Boxes:
    """Intervals of each piece, each with all frequencies that a point there can have."""
    model, parts = searched.model, []
    for number, piece in enumerate(pieces):
        first, last = piece.first.A[0], piece.last.A[0]
        if first == 0:
            # bounds are a forcing times a power of 2: static states of a linear spring would lie on the edges of two
            orders = ORDERS if model.preload == 0 else ORDERS_OF_PRELOAD
            nodes = last * (0.5 * ASKEW) ** np.arange(orders, -1, -1)
            nodes = np.concatenate(([0.0], nodes)) if model.preload == 0 else nodes
        else:
            nodes = np.array([first, last])
            for _ in range(2):
                inner = amid(np.full(nodes.size - 1, piece.base), nodes[:-1], nodes[1:])
                nodes = np.unique(np.concatenate((nodes, inner)))
        between = samples_at(model, nodes[1:-1])
        begin = piece.first if nodes[0] == first else samples_at(model, nodes[:1])
        a, b = joined(begin, between), joined(between, piece.last)
        numbers = np.full(len(a), number)
        cells = cells_of(model, a, b, a)
        if searched.system in STATIC:
            low, high = np.full(len(a), -ASIDE), np.full(len(a), ASIDE * 1.0625)
        else:
            low, high = np.zeros(len(a)), _highest(searched, cells, numbers, piece, most)
        parts.append(_Boxes(numbers, a, b, low, high))
    return _all(parts)


def _highest(searched: Searched, cells: Cells, numbers: Ints, piece: Stretch, most: float) -> Floats:
    """A frequency above that of every point: by the slopes of R and R/A, and by the forcing."""
    over = cells.h / cells.A
    if piece.base == 0 and searched.model.preload == 0:  # h/A lies between slopes of h
        start = piece.first.h_A
        slope = Interval.hull(np.minimum(start, cells.h_A.lo), np.maximum(start, cells.h_A.hi))
        over = over.both(slope)
    if searched.system == "peaks":  # R is not positive there
        squared = np.maximum(-over.lo, 0.0)
    elif searched.system == "peaks_by_inertia":
        squared = np.full(over.lo.shape, np.inf)
    else:
        I_0, I_0A, *_ = searched.rest(cells.A, numbers)
        falls = np.where(I_0A.lo < 0, (I_0 * I_0A / cells.A).lo, 0.0)
        second, constant = (over + cells.h_A).lo, (over * cells.h_A).lo + np.minimum(falls, 0.0)
        B, C = np.maximum(-second, 0.0), np.maximum(-constant, 0.0)
        squared = 0.5 * (B + np.sqrt(B * B + 4 * C))
    by_force = (most + np.abs(cells.h.ends).max(axis=0)) / cells.A.lo
    if searched.model.inertial:  # of the force F_0 Omega^2
        left = cells.A.lo - most
        by_force = np.where(left > 0, np.abs(cells.h.ends).max(axis=0) / left, np.inf)
    bounds = np.fmin(np.where(np.isnan(squared), np.inf, squared), np.where(np.isnan(by_force), np.inf, by_force))
    return np.asarray(np.sqrt(bounds) * (1 + 2.0**-10) + 2.0**-10)


def _mapped(
    searched: Searched, boxes: _Boxes, at: Samples, w: Floats, slopes: list[Interval]
) -> tuple[Bools, Bools, Interval, Interval]:
    """By Krawczyk's operator: which boxes hold one point, which none, and what is left of each of them."""
    f, g, *near = _at(searched, at, boxes.piece, w)
    a, b, c, e = near
    determinant = a * e - b * c
    inverse = np.array(((e, -b), (-c, a))) / determinant
    A, Omega = Interval.of(boxes.a.A, boxes.b.A), Interval.of(boxes.low, boxes.high)
    off = (_less(A, at.A), _less(Omega, w))
    f_A, f_Omega, g_A, g_Omega = slopes
    maps = []
    for i, middle in enumerate((at.A, w)):
        p, q = (_scaled(one, inverse[i, k]) for k, one in enumerate((f, g)))
        by_A = _scaled(f_A, inverse[i, 0]) + _scaled(g_A, inverse[i, 1])
        by_Omega = _scaled(f_Omega, inverse[i, 0]) + _scaled(g_Omega, inverse[i, 1])
        own = (_one_less(by_A, i == 0), _one_less(by_Omega, i == 1))
        moved = own[0] * off[0] + own[1] * off[1] - (p + q)
        maps.append(_plus(moved, middle))
    known = np.isfinite(maps[0].ends).all(axis=0) & np.isfinite(maps[1].ends).all(axis=0)
    inside, gone = known.copy(), np.zeros(known.shape, dtype=bool)
    left = []
    for box, image in zip((A, Omega), maps, strict=True):
        inside &= (image.lo > box.lo) & (image.hi < box.hi)
        gone |= known & ((image.hi < box.lo) | (image.lo > box.hi))
        # somewhat wider, or rounding would keep the next image from lying inside
        wider = (image.hi - image.lo) / 16
        image = Interval(np.array((image.lo - wider, image.hi + wider)))
        left.append(box.where(np.asarray(~known), box.both(image)))
    if searched.system in STATIC:
        left[1] = Omega
    return inside & ~gone, gone, left[0], left[1]


def _at(searched: Searched, at: Samples, piece: Ints, w: Floats) -> list[Any]:
    """Both functions at points, as intervals that hold their rounding, and their slopes as numbers."""
    rows = [at.h, at.h_A, at.h_AA, at.h_AAA]
    f, g, *slopes = searched.values(at.A, rows, piece, w)
    scale = (at.A * np.abs(slopes[0]) + w * np.abs(slopes[1]), at.A * np.abs(slopes[2]) + w * np.abs(slopes[3]))
    doubt = [2.0**-44 * (np.abs(value) + size) for value, size in zip((f, g), scale, strict=True)]
    return [Interval.of(value - off, value + off) for value, off in zip((f, g), doubt, strict=True)] + slopes


def _scaled(one: Interval, factor: Floats) -> Interval:
    return one * Interval.of(factor, factor)


def _less(one: Interval, number: Floats) -> Interval:
    return one - Interval.of(number, number)


def _plus(one: Interval, number: Floats) -> Interval:
    return one + Interval.of(number, number)


def _one_less(one: Interval, is_diagonal: bool) -> Interval:
    return (1.0 - one) if is_diagonal else -one


def _cut(
    searched: Searched,
    boxes: _Boxes,
    at: Samples,
    w: Floats,
    left: tuple[Interval, Interval],
    ended: tuple[Bools, Bools],
    slopes: list[Interval],
    span: Floats,
    steep: Bools,
) -> _Boxes:
    """What is left of the boxes; those of which much is left are cut in two, across what moves the functions most.

    span  -- of h; where it has no bounds, as averages by sums have none on wide intervals, no frequency decides
    steep -- where h moves by far more than A
    """
    if not len(boxes):
        return boxes
    A, Omega = left
    width, height = boxes.b.A - boxes.a.A, boxes.high - boxes.low
    with np.errstate(all="ignore"):
        shares = ((A.hi - A.lo) / width, (Omega.hi - Omega.lo) / height)
        area = np.fmin(shares[0], 1.0) * np.fmin(shares[1], 1.0)
        small = np.isfinite(area) & (area < MUCH)
        f_A, f_Omega, g_A, g_Omega = (np.abs(one.ends).max(axis=0) for one in slopes)
        by_A, by_Omega = (
            f_A * width / (f_A * width + f_Omega * height) + g_A * width / (g_A * width + g_Omega * height),
            f_Omega * height / (f_A * width + f_Omega * height) + g_Omega * height / (g_A * width + g_Omega * height),
        )
        relative = width / boxes.b.A, height / np.maximum(np.abs(boxes.high), LOW)
        of_A = np.where(np.isfinite(by_A + by_Omega), by_A >= by_Omega, relative[0] >= relative[1])
        of_A = np.where(relative[0] > 64 * relative[1], True, np.where(relative[1] > 64 * relative[0], False, of_A))
        # next to where the force jumps no slope by A is bounded, but h is: its span beside that of A Omega^2
        of_A = np.where(
            steep & np.isfinite(span) & np.isfinite(height), span >= 2 * boxes.b.A * boxes.high * height, of_A
        )
    if searched.system in INERTIAL:  # what A does to R/Omega^2 = A + h/Omega^2, where Omega has no end
        of_A |= np.isinf(boxes.high) & (width * boxes.low**2 > np.abs(at.h))
    of_A = ((of_A | np.isinf(span)) & ~ended[0]) | ended[1]
    model = searched.model
    shrunk = np.flatnonzero(small)
    parts = []
    if shrunk.size:
        own = boxes.take(shrunk)
        parts.append(
            _Boxes(
                own.piece,
                _moved(model, own.a, A.lo[shrunk]),
                _moved(model, own.b, A.hi[shrunk]),
                Omega.lo[shrunk],
                Omega.hi[shrunk],
            )
        )
    by_amplitude, by_frequency = np.flatnonzero(~small & of_A), np.flatnonzero(~small & ~of_A)
    if by_amplitude.size:
        own, between = boxes.take(by_amplitude), at.take(by_amplitude)
        parts += [
            _Boxes(own.piece, own.a, between, own.low, own.high),
            _Boxes(own.piece, between, own.b, own.low, own.high),
        ]
    if by_frequency.size:
        own, between_w = boxes.take(by_frequency), w[by_frequency]
        parts += [
            _Boxes(own.piece, own.a, own.b, own.low, between_w),
            _Boxes(own.piece, own.a, own.b, between_w, own.high),
        ]
    return _all(parts)


def _moved(model: Model, ends: Samples, A: Floats) -> Samples:
    """Samples at other amplitudes; where these are the same, as they were: limits at a breakpoint stay."""
    rows = ends.rows.copy()
    other = np.flatnonzero(A != ends.A)
    if other.size:
        rows[:, other] = samples_at(model, A[other]).rows
    return Samples(rows)


def _solved(searched: Searched, boxes: _Boxes, A: Floats, w: Floats) -> tuple[Floats, Floats]:
    """Newton's steps from the middle of boxes that hold one point each, kept in them."""
    for _ in range(STEPS):
        f, g, a, b, c, e = searched.values(A, searched.model.averaged(A), boxes.piece, w)
        determinant = a * e - b * c
        step = ((e * f - b * g) / determinant, (a * g - c * f) / determinant)
        by_A, by_Omega = (np.where(np.isfinite(one), one, 0.0) for one in step)
        A, w = np.clip(A - by_A, boxes.a.A, boxes.b.A), np.clip(w - by_Omega, boxes.low, boxes.high)
    return A, w
