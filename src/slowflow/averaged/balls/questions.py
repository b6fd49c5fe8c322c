"""The questions of native/certify.h, in balls of any number of bits. Takes a model; returns the same tuples.

For what intervals of doubles leave undecided. None where a force has no form in balls.
"""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from flint import arb, ctx

from slowflow.answers.certificate import Proved
from slowflow.averaged import solvers
from slowflow.averaged.balls.search import (
    ALL,
    AT_0,
    INFINITE,
    NOWHERE,
    PARTLY,
    POSITIVE,
    THROUGHOUT,
    ZERO,
    BallModel,
    Cell,
    Enclosure,
    Range,
    amplitudes_of,
    averages_of,
    defined,
    frequencies_of,
    hull,
)
from slowflow.core.mechanism import Flags
from slowflow.core.model import Floats, Model
from slowflow_kernels import slow_flow_intervals as flow
from slowflow_kernels.conventions import ENDLESS, FIRST, OnsetKind, Status

#: by how much, relatively, the forcing up to which an onset is proved to be the lowest exceeds the one that was found
ABOVE_ONSET = 2.0**-20

#: the digits of FLINT are one number for all threads
_DIGITS = threading.Lock()


class Point(NamedTuple):
    """A point of a question: its cell, and a sign that the question is about; of a level that may be known better."""

    Omega: Enclosure
    on: Cell
    sign: int
    level: Enclosure = ALL
    kind: OnsetKind = OnsetKind.NO
    corner: bool = False


#: points, and amplitudes in doubt
Points = tuple[list[Point], list[Enclosure]]


class Systems:
    """The systems of an oscillator at a forcing: functions of Omega and A, and the points at their common zeros."""

    def __init__(self, balls: BallModel, F_0: float = math.inf) -> None:
        self.balls, self.m, self.zeta, self.F_0 = balls, balls.m, balls.zeta, Enclosure.of(F_0)
        self.least = flow.least_restoring(self.F_0, self.m) if F_0 < math.inf else ALL
        #: without friction functions vanish at 0: amplitudes of 1e-60 and less are left out
        self.start = 0.0 if self.m.hi > 0 else FIRST

    def level(self, Omega: Enclosure, on: Cell) -> Enclosure:
        """The forcing of a point."""
        return Enclosure.of(flow.level(Omega, on.A, self.m, self.zeta, on.h))

    def F(self, on: Cell, w: Enclosure) -> tuple[Any, Any]:
        """F and its slope along Omega."""
        return flow.F(w, on.A, self.F_0, self.m, self.zeta, on.h), flow.F_Omega(w, on.A, self.m, self.zeta, on.h)

    def F_A(self, on: Cell, w: Enclosure) -> tuple[Any, Any]:
        """F_A likewise."""
        terms = w, on.A, self.m, self.zeta, on.h, on.h_A
        return flow.F_A(*terms), flow.F_AOmega(*terms)

    def F_Omega(self, on: Cell, w: Enclosure) -> tuple[Any, Any]:
        """F_Omega without what is common, likewise."""
        if self.m.hi == 0:
            value, slope = flow.F_Omega_reduced_mu0(w, on.A, self.zeta, on.h)
        elif self.zeta.hi == 0:
            value, slope = flow.F_Omega_reduced_zeta0(w, on.A, on.h)
        else:
            value, slope = flow.F_Omega_reduced(w, on.A, self.m, self.zeta, on.h)
        return value, slope

    # ---- folds and states at the forcing ----

    def fold(self, cell: Cell) -> Sequence[Range]:
        """With viscous damping it ends at Omega = 0, where |k| is the least; F_A there has the sign of h_A."""
        if self.zeta.hi == 0:
            return (Range(defined(-cell.h_A), *flow.fold_zeta0(self.F_0, self.m, cell.k, cell.k_A)),)
        low = self.least.lo
        if cell.k.hi < low and cell.k.lo > -low:
            return (Range(),)
        if not (cell.k.hi < low or cell.k.lo > -low):
            return (Range(PARTLY),)  # on both sides
        where = THROUGHOUT if max(-cell.k.hi, cell.k.lo) >= self.least.hi else PARTLY
        edge = cell.h_A.sign if where == PARTLY and cell.k_A.sign else 0
        return (Range(where, *self._fold(cell)[:2], edge=edge),)

    def _fold(self, cell: Cell) -> tuple[Enclosure, Enclosure, Enclosure]:
        low = self.least.lo
        k = cell.k.both(Enclosure(low, INFINITE) if cell.k.hi >= low else Enclosure(-INFINITE, -low))
        y, dy, Omega = flow.fold(cell.A, self.F_0, self.m, self.zeta, cell.h, cell.h_A, k, cell.k_A)
        return y, dy, Omega

    def folds(self, A_max: float) -> Points:
        """All of them, with the sign of F_AA."""
        zeros, doubts = amplitudes_of(self.balls, self.fold, A_max)
        points, more = self._folds_on_breakpoints(A_max)
        for on in (zero.on for zero in zeros):
            # from I, which exceeds m by little if damping is weak, or h_A: no bound next to a jump of the force
            w = flow.undamped_Omega(on.h_A) if self.zeta.hi == 0 else self._fold(on)[2]
            w = w.both(Enclosure(ZERO, self._highest(on)))
            found = frequencies_of(partial(self.F, on), w.lo, w.hi).positions()
            # then by F = 0, of which several roots may lie there: R has the sign of k
            Omega = hull([one for one, _ in found if flow.R(one, on.A, on.h).sign != -on.k.sign] or [w])
            points.append(Point(Omega, on, flow.F_AA(Omega, on.A, self.m, self.zeta, on.h, on.h_A, on.h_AA).sign))
        return points, doubts + more

    def _highest(self, on: Cell) -> arb:
        """The frequency beyond which R exceeds F_0."""
        return Enclosure.of(flow.backbone(on.A, on.h - self.F_0)).hi

    def _folds_on_breakpoints(self, A_max: float) -> Points:
        """Where the force jumps: F_A has one sign below and another above."""
        points, doubts, balls = [], [], self.balls
        for i, b in enumerate(balls.b):
            on = balls.on(i)
            if not balls.jumps_at(i) or b.lo > A_max:
                continue
            for Omega, doubtful in frequencies_of(partial(self.F, on), ZERO, 2 * self._highest(on)).positions():
                above = (flow.R(Omega, b, on.h) * balls.jumps[i]).sign
                below = self.F_A(on, Omega)[0].sign
                if above and above == below:
                    continue  # no fold, however many roots there are
                if doubtful or not (above and below):
                    doubts.append(b)
                else:
                    points.append(Point(Omega, on, -below, corner=True))
        return points, doubts

    def states(self, Omega: Enclosure, A_max: float) -> Points:
        """All of them at a frequency, with the sign of F_A."""

        def ranges(cell: Cell) -> Sequence[Range]:
            """F by R and its tangent, F_A and F_AA."""
            one, two = flow.state_R(Omega, cell.A, cell.h, cell.h_A, cell.k)
            terms = Omega, cell.A, self.F_0, self.m, self.zeta, cell.h_A, cell.h_AA
            return (Range(THROUGHOUT, *flow.state(*terms, one.both(two))),)

        zeros, doubts = amplitudes_of(self.balls, ranges, A_max)
        return [Point(Omega, zero.on, 1 if zero.rising else -1) for zero in zeros], doubts

    # ---- points of the fold locus: their sign is 1 where the level is least along it, -1 where most ----

    def isola(self, cell: Cell) -> Sequence[Range]:
        """Isola points of levels up to F_0."""
        where = defined(cell.h_A)
        if where == NOWHERE or self.level(flow.isola_Omega(cell.h_A), cell).lo > self.F_0.hi:
            return (Range(),)
        terms = self.zeta, cell.h, cell.h_A, cell.h_AA
        found = flow.isola_mu0(cell.A, *terms) if self.m.hi == 0 else flow.isola(cell.A, self.m, *terms)
        return (Range(where, *found),)

    def isolas(self, A_max: float) -> Points:
        """All of them."""
        zeros, doubts = amplitudes_of(self.balls, self.isola, A_max, self.start)
        points = []
        for on in (zero.on for zero in zeros):
            Omega = flow.isola_Omega(on.h_A)
            sign = flow.isola_bend(Omega, on.A, self.m, self.zeta, on.h_AA).sign
            points.append(Point(Omega, on, sign, kind=OnsetKind.ISOLA))
        return points, doubts

    def cusp(self, cell: Cell, larger: bool) -> tuple[Range, Enclosure, Enclosure, Enclosure]:
        """F_A/2 where F_AA vanishes, with the level, Omega^2 and dR/dA, from the larger root of a quadratic, or not."""
        a, b, c, d, discriminant = flow.cusps(cell.A, self.zeta, cell.h, cell.h_A, cell.h_AA, cell.k)
        root = discriminant.sqrt()
        X, T = (_root_of(*of, root, larger) for of in ((c, d), (a, b)))
        where = NOWHERE if discriminant.hi < 0 else defined(X)
        X = X.both(POSITIVE)
        one, two = flow.cusp_R(cell.A, self.zeta, cell.h_AA, cell.k, X, T)
        terms = cell.A, self.m, self.zeta, cell.h_AA, cell.h_AAA, cell.k, X, T, one.both(two)
        y, same, dy, level = flow.cusp(*terms, root if larger else -root)
        where = NOWHERE if level.lo > self.F_0.hi else where if discriminant.lo > 0 else min(where, PARTLY)
        return Range(where, y.both(same), dy), level, X, T

    def cusps(self, A_max: float) -> Points:
        """Those of levels up to F_0; on the fold locus R has the sign of k, and F_AA = 0 only if h_AA has the other."""

        def ranges(cell: Cell) -> Sequence[Range]:
            same = (cell.h_AA.lo >= 0 and cell.k.lo >= 0) or (cell.h_AA.hi <= 0 and cell.k.hi <= 0)
            return [Range() if same else self.cusp(cell, larger)[0] for larger in (True, False)]

        zeros, doubts = amplitudes_of(self.balls, ranges, A_max, self.start)
        points = []
        for on, channel in ((zero.on, zero.channel) for zero in zeros):
            _, level, X, T = self.cusp(on, channel == 0)
            Omega = X.sqrt()
            sign = flow.cusp_bend(Omega, on.A, self.zeta, on.h_AA, on.h_AAA, T).sign
            points.append(Point(Omega, on, sign, level.both(self.level(Omega, on)), OnsetKind.CUSP))
        return points, doubts

    def corners(self) -> Points:
        """Where the force jumps, or its slope, where the locus bends and does no more."""
        points: list[Point] = []
        for i, b in enumerate(self.balls.b):
            on, jumps = self.balls.on(i), self.balls.jumps_at(i)
            jump = (self.balls.jumps if jumps else self.balls.kinks)[i].sign
            no_R = flow.backbone(b, on.h)
            if jumps and on.h.lo < 0 and jump <= 0:
                points.append(Point(no_R, on, -jump if on.h.hi < 0 else 0))
            # beyond the last of these R is positive, and Omega^2 + h_A
            highest = 2 * max(flow.undamped_Omega(on.h_A).hi, no_R.hi)
            for function in (self.F_A, self.F_Omega)[: 1 + jumps]:
                for w, doubtful in frequencies_of(partial(function, on), ZERO, highest).positions():
                    rises = -flow.R(w, b, on.h).sign * jump
                    if function == self.F_A:
                        one = -flow.level_rise(w, b, self.m, self.zeta, on.h, on.h_A, on.h_AA).sign
                        slope = flow.F_Omega(w, b, self.m, self.zeta, on.h)
                        other = rises * (slope * self.F_A(on, w)[1]).sign
                    else:
                        one, other = rises * self.F_A(on, w)[0].sign, flow.F_OmegaOmega(w, b, self.zeta, on.h).sign
                    points.append(Point(w, on, 0 if doubtful else -1 if min(one, other) < 0 else one * other))
        return [one._replace(kind=OnsetKind.CORNER) for one in points], []

    # ---- the same without viscous damping: folds lie at Omega^2 = -h_A, their R is k ----

    def undamped(self) -> Points:
        """Points at which |k| is least, with it the level; one at infinity is in doubt, as is whether k tends to 0."""
        balls = self.balls
        zeros, doubts = amplitudes_of(balls, partial(undamped, 0), ENDLESS, FIRST)
        _, more = amplitudes_of(balls, partial(undamped, 1), ENDLESS, FIRST)
        points = []
        far = balls.at(balls.count, arb(ENDLESS))
        if not (far.h_A.lo >= 0 or flow.undamped_rises(far.h_AA, far.h_AAA, far.k)[0].lo >= 0):
            more.append(ALL)
        for on in (zero.on for zero in zeros):
            sign = flow.undamped_rises(on.h_AA, on.h_AAA, on.k)[1].sign
            points.append(Point(flow.undamped_Omega(on.h_A), on, sign, kind=OnsetKind.CUSP))
        for i in range(balls.count):
            on, jump = balls.on(i), balls.jumps[i].sign
            if on.h_A.lo >= 0:
                continue
            # |k| falls below; above h_AA is infinite, with the sign of what the slope loses
            falls = -flow.undamped_rises(on.h_AA, on.h_AAA, on.k)[0].sign
            turn = 1 if jump < 0 else -on.k.sign if balls.jumps_at(i) else -(on.k * balls.kinks[i]).sign
            known = on.h_A.sign and falls and turn and (jump or not balls.jumps_at(i))
            sign = min(falls, turn) if known else 0
            points.append(Point(flow.undamped_Omega(on.h_A), on, sign, kind=OnsetKind.CORNER))
        return points, doubts + more

    def lowest(self, A_max: float) -> tuple[Point | None, bool]:
        """What the lowest level that has a fold is known to be, of no kind if that is not known, and whether it is it.

        Minima of the level are cusps and isola points, ends of pieces on breakpoints, and ends at Omega = 0, where none
        is born.
        """
        results = (self.undamped(),) if self.zeta.hi == 0 else (self.isolas(A_max), self.cusps(A_max), self.corners())
        every = [one._replace(level=one.level.both(self.level(one.Omega, one.on))) for of in results for one in of[0]]
        doubted = min((one.level.lo for one in every if one.sign == 0), default=INFINITE)
        unknown = any(doubts for _, doubts in results) or not all(one.Omega.hi < INFINITE for one in every)
        minima = [one for one in every if one.sign > 0]
        if not minima:
            return None, bool(not unknown and doubted > 0)
        hi = min(one.level.hi for one in minima)
        kept = [one for one in minima if one.level.lo <= hi]
        kind = kept[0].kind if len({one.kind for one in kept}) == 1 else OnsetKind.NO
        on = kept[0].on._replace(A=hull([one.on.A for one in kept]))
        level, Omega = Enclosure(min(one.level.lo for one in kept), hi), hull([one.Omega for one in kept])
        return Point(Omega, on, 1, level, kind), bool(not unknown and doubted > hi)


def _root_of(a: Enclosure, b: Enclosure, root: Enclosure, larger: bool) -> Enclosure:
    """A root of x^2 + 2 a x + b from both forms, root^2 = a^2 - b."""
    if not larger:
        return -_root_of(-a, b, root, True)
    return (root - a).both(-(b / (a + root))) if a.lo >= 0 else root - a


def undamped(which: int, cell: Cell) -> Sequence[Range]:
    """Where, on the locus without viscous damping, h_AA vanishes (0) or k (1)."""
    return (Range(defined(-cell.h_A), *((cell.h_AA, cell.h_AAA), (cell.k, cell.k_A))[which]),)


def tends_to_friction(balls: BallModel) -> bool:
    """Whether without viscous damping folds come as near to 4 mu/pi as one asks, as k tends to 0 on the locus.

    At A = 0, next to which h_A is negative; on a breakpoint, where folds sit at Omega^2 > -h_A if the force jumps down,
    or below; or between.
    """
    first, A = balls.at(0, ZERO), min(float(balls.b[0].lo), 1.0) if balls.count else 1.0
    while first.k.lo == first.k.hi == 0 and A > FIRST:
        last = balls.at(0, arb(A))
        cell = balls.between(0, first, last)
        falls = cell.h_AA.hi < 0 or (first.h_AA.hi <= 0 and cell.h_AAA.hi < 0)
        if cell.h_A.hi < 0 or (first.h_A.hi <= 0 and falls):
            if last.k.sign:
                return True
            break
        A *= 0.125
    for i in range(balls.count):
        at, jump = balls.below(i), balls.jumps[i].sign
        falls = at.h_A.hi < 0
        if jump < 0 and ((falls and at.k.hi <= 0) or (at.h_A.lo >= 0 and at.h.hi <= 0)):
            return True
        if jump > 0 and falls and at.h.hi <= 0 and at.k.lo >= 0:
            return True
    return bool(amplitudes_of(balls, partial(undamped, 1), ENDLESS, FIRST)[0])


def lowest_at_rest(balls: BallModel) -> Enclosure | None:
    """What holds the lowest level at which the fold locus ends at Omega = 0, infinite if nowhere; None: not decided.

    There h_A vanishes, or h, and so R; from where F_Omega falls below 0 without friction the level does not rise, so
    that there are folds at every forcing about it. Of amplitudes from 1e-60 on.
    """

    def ends(cell: Cell) -> Sequence[Range]:
        return Range(THROUGHOUT, cell.h, cell.h_A), Range(THROUGHOUT, cell.h_A, cell.h_AA)

    zeros, doubts = amplitudes_of(balls, ends, ENDLESS, FIRST)
    levels, at, decided = [Enclosure(INFINITE, INFINITE)], [one.on for one in zeros if one.channel], not doubts
    levels += [balls.m for one in zeros if not one.channel]
    for i in range(balls.count):
        on, jump = balls.on(i), balls.jumps[i].sign
        # h_A of the other side is infinite there: it passes 0 on the breakpoint
        if balls.jumps_at(i) and jump * on.h_A.sign <= 0:
            at.append(on)
            decided = decided and bool(jump and on.h_A.sign)
    for on in at:
        rises = 1 if balls.m.lo > 0 else flow.F_OmegaOmega(AT_0, on.A, balls.zeta, on.h).sign
        decided = decided and bool(rises)
        if rises > 0:
            levels.append(Systems(balls).level(AT_0, on))
    return Enclosure(min(one.lo for one in levels), min(one.hi for one in levels)) if decided else None


# ---- answers, as native/questions.h has them -------------------------------------------------------------------------


def _double(end: arb, towards: float) -> float:
    """The double that is an exact number, or the next one on that side."""
    value = float(end)
    beyond = arb(value) > end if towards < 0 else arb(value) < end
    return math.nextafter(value, towards) if beyond else value


def _pairs(enclosures: Iterable[Enclosure]) -> Floats:
    """Enclosures by doubles, shape (n, 2)."""
    ends = [(_double(one.lo, -math.inf), _double(one.hi, math.inf)) for one in enclosures]
    return np.array(ends, dtype=float).reshape(-1, 2)


def ask(question: str, model: Model, bits: int, *numbers: float) -> Any:
    """What balls of so many bits answer, as the compiled solvers' question of that name; None where they have no form.

    Two that those have not: `certify_cusps` up to an amplitude, whether all is proved, with F_0, Omega, A and which are
    minima; `at_rest`.
    """
    averages = averages_of(model.mechanism)
    if averages is None or not model.has_design:
        return None
    ends = model.mechanism.breakpoints(*model.parameters)  # of which a design without a preload has none above 0
    if not len(ends) == len(model.breakpoints) == len(model.jumps):
        return None
    with _DIGITS, np.errstate(all="ignore"), ctx.workprec(bits):
        return _QUESTIONS[question](BallModel(model, averages), *numbers)


def _at_forcing(balls: BallModel, F_0: float, *frequency: float) -> Any:
    """Folds, or states at a frequency.

    Status, Omega, A, corner, sign, what is in doubt, A_max, whether it bounds them, and is all.
    """
    A_max, points, doubts = 0.0, list[Point](), list[Enclosure]()
    status, bounded = Status.STICKS, bool(F_0 <= balls.m.lo)
    if F_0 > balls.m.hi:
        try:
            A_max = solvers.amplitude_bound(balls.model, F_0)
        except OverflowError:
            return None
        systems = Systems(balls, F_0)
        points, doubts = systems.states(Enclosure.of(*frequency), A_max) if frequency else systems.folds(A_max)
        status, bounded = Status.OK, balls.is_bounded(arb(F_0), A_max)
    # by rising frequency, of those that are the same double by rising amplitude, and of one of both the corner
    points.sort(key=lambda one: (float(one.Omega.middle), float(one.on.A.middle), not one.corner))
    columns = _pairs(one.Omega for one in points), _pairs(one.on.A for one in points)
    corner, sign = np.array([one.corner for one in points], bool), np.array([one.sign for one in points], int)
    return status, *columns, corner, sign, _pairs(doubts), A_max, bounded, True


def _onset(balls: BallModel) -> Any:
    """F_SN, and that no fold is born at a lower forcing; or that there is none, or none that is the lowest.

    Next to the one that doubles found, if they did, which takes less time; else among all forcings, and amplitudes up
    to one that stands for infinite ones.
    """
    model, F_0, A_max = balls.model, math.inf, float(ENDLESS)
    try:
        if model.zeta > 0 and (F_SN := solvers.onset(model).F_SN) is not None:
            F_0 = F_SN * (1 + ABOVE_ONSET)
            A_max = solvers.amplitude_bound(model, F_0)
    except ArithmeticError:  # unresolved, or beyond the range of doubles
        F_0 = math.inf
    if model.zeta == 0 and tends_to_friction(balls):
        return Status.UNBOUNDED, None, None, None, OnsetKind.NO, True
    best, proved = Systems(balls, F_0).lowest(A_max)
    if F_0 < math.inf:
        proved = proved and best is not None and best.level.hi < F_0 and balls.is_bounded(arb(F_0), A_max)
    if best is None:
        return Status.NONE if proved or model.zeta > 0 else Status.UNBOUNDED, None, None, None, OnsetKind.NO, proved
    return Status.OK, *_pairs((best.level, best.Omega, best.on.A)), best.kind, proved


def _detachment(balls: BallModel) -> Any:
    """F_cr, the least level on the first breakpoint: at Omega = 0, or where F_Omega vanishes.

    Each point that is tried is a bound from above, and the least lies at one of them: points in doubt do no harm.
    """
    if not balls.count:
        return Status.NONE, None, None, None
    systems, on = Systems(balls), balls.on(0)
    found = frequencies_of(partial(systems.F_Omega, on), ZERO, 2 * flow.backbone(on.A, on.h).hi).positions()
    levels = [(systems.level(w, on), w) for w in (*(w for w, _ in found), AT_0)]
    hi = min(level.hi for level, _ in levels)
    F_cr = Enclosure(min(level.lo for level, _ in levels), hi)
    Omega = hull([w for level, w in levels if level.lo <= hi])
    return (Status.OK, *_pairs((F_cr, Omega, on.A))) if Omega.hi < INFINITE else None


def _cusps(balls: BallModel, A_max: float) -> Any:
    points, doubts = Systems(balls).cusps(A_max)
    points.sort(key=lambda one: float(one.on.A.middle))
    columns = (_pairs(column) for column in zip(*((one.level, one.Omega, one.on.A) for one in points), strict=True))
    minimum = np.array([one.sign > 0 for one in points], dtype=bool)
    return not doubts and all(one.sign for one in points), *(columns if points else [_pairs([])] * 3), minimum


def _at_rest(balls: BallModel, F_SN: float) -> Any:
    """What holds the lowest level at which the fold locus ends at Omega = 0, infinite if it nowhere does.

    From 0 on where that is not decided, or states at F_SN may lie beyond the amplitude that stands for infinite ones.
    """
    level = lowest_at_rest(balls)
    if level is None or not balls.is_bounded(arb(F_SN), ENDLESS):
        return 0.0, math.inf
    return _pairs([level])[0].tolist()


@dataclass(frozen=True, eq=False)
class ProvedCusps(Proved):
    """All cusps of the fold locus up to an amplitude, by rising A; each three intervals hold one, no two the same.

    F_0, Omega, A -- lowest and highest of each, shape (n, 2)
    minimum -- as in `Cusps`, shape (n,)
    """

    F_0: Floats
    Omega: Floats
    A: Floats
    minimum: Flags


_QUESTIONS: dict[str, Callable[..., Any]] = {
    "certify_folds": _at_forcing,
    "certify_states": _at_forcing,
    "certify_onset": _onset,
    "certify_detachment": _detachment,
    "certify_cusps": _cusps,
    "at_rest": _at_rest,
}
