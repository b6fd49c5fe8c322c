"""What native/certify.h asks, in balls: in goes an oscillator as it was given, out come enclosures and doubts.

They are of its folds or states at a forcing, of F_SN and of F_cr.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import NamedTuple

from flint import arb

from slowflow.averaged.balls import roots
from slowflow.averaged.balls.enclosure import ALL, INFINITE, ZERO, Enclosure, least, most
from slowflow.averaged.balls.given import Cell, Given, cell_between
from slowflow.averaged.balls.search import NOWHERE, Range, Search, Where, clipped, positive
from slowflow_kernels import slow_flow_intervals as flow
from slowflow_kernels import slow_flow_mu0_intervals as of_mu_0
from slowflow_kernels import slow_flow_zeta0_intervals as of_zeta_0
from slowflow_kernels.conventions import ENDLESS, FIRST, OnsetKind

#: an interval of Omega that is wider, relatively, is searched for roots
WIDE = 2.0**-20
#: by how much, relatively, the forcing up to which an onset is proved to be the lowest exceeds the one that was found
ABOVE_ONSET = 2.0**-20


@dataclass
class Found:
    """Folds or states: what holds each, whether it is on a breakpoint, the sign of F_AA or of F_A where it is known.

    doubts -- amplitudes between which these digits do not decide
    """

    Omega: list[Enclosure] = field(default_factory=list)
    A: list[Enclosure] = field(default_factory=list)
    corner: list[bool] = field(default_factory=list)
    sign: list[int] = field(default_factory=list)
    doubts: list[Enclosure] = field(default_factory=list)

    def add(self, Omega: Enclosure, A: Enclosure, corner: bool, sign: int) -> None:
        self.Omega.append(Omega)
        self.A.append(A)
        self.corner.append(corner)
        self.sign.append(sign)

    def by_Omega(self) -> Found:
        """By rising frequency, of those that are the same double by rising amplitude, and of one of both the corner."""

        def place(i: int) -> tuple[float, float, bool]:
            return float(self.Omega[i].middle), float(self.A[i].middle), not self.corner[i]

        order = sorted(range(len(self.A)), key=place)
        return Found(
            [self.Omega[i] for i in order],
            [self.A[i] for i in order],
            [self.corner[i] for i in order],
            [self.sign[i] for i in order],
            self.doubts,
        )


def _doubts(given: Given, search: Search) -> list[Enclosure]:
    return [given.beyond(one.piece, Enclosure(one.low, one.high)) for one in search.doubts]


def is_bounded(given: Given, F_0: arb, A: float) -> bool:
    """Whether no amplitude from A on, up to one that stands for all, is that of a state at F_0 or less."""
    at = arb(A)
    if given.zeta.lo == 0 or (given.count and not at > given.b[-1].hi):
        return False
    piece = given.count
    here = given.at(piece, (at - given.beginning(piece).hi).lower())
    there = given.at(piece, (ENDLESS * max(A, 1.0) - given.beginning(piece).lo).upper())
    cell = cell_between(Enclosure(here.A, there.A), here, there)
    limit = flow.most_restoring(Enclosure(at, at), Enclosure(F_0, F_0), given.m, given.zeta)
    if here.h.lo > 0:
        return bool(here.h.lo > limit.hi and cell.h_A.lo >= 0)
    return bool(-here.h.hi > limit.hi and cell.h_A.hi <= 0)


class Asked:
    """An oscillator at a forcing."""

    def __init__(self, given: Given, F_0: float) -> None:
        self.given, self.m, self.zeta = given, given.m, given.zeta
        self.F_0 = Enclosure(arb(F_0), arb(F_0))
        self.least = flow.least_restoring(self.F_0, self.m) if F_0 < math.inf else ALL

    def at_breakpoint(self, i: int) -> Cell:
        """Breakpoint i as its lower side has it."""
        at = self.given.below(i)
        return cell_between(self.given.b[i], at, at)

    # ---- frequencies at an amplitude ----

    def F(self, on: Cell, w: Enclosure) -> tuple[Enclosure, Enclosure]:
        """F and its slope along Omega."""
        return (
            flow.F(w, on.A, self.F_0, self.m, self.zeta, on.h),
            flow.F_Omega(w, on.A, self.m, self.zeta, on.h),
        )

    def F_A(self, on: Cell, w: Enclosure) -> tuple[Enclosure, Enclosure]:
        """F_A likewise."""
        return (
            flow.F_A(w, on.A, self.m, self.zeta, on.h, on.h_A),
            flow.F_AOmega(w, on.A, self.m, self.zeta, on.h, on.h_A),
        )

    def F_Omega(self, on: Cell, w: Enclosure) -> tuple[Enclosure, Enclosure]:
        """F_Omega without what is common, likewise."""
        own = of_mu_0 if self.m.hi == 0 else of_zeta_0 if self.zeta.hi == 0 else flow
        value, slope = own.F_Omega_reduced(w, on.A, self.m, self.zeta, on.h)
        return _enclosure(value), _enclosure(slope)

    def frequencies(self, on: Cell) -> roots.Roots:
        """All roots of F: beyond some frequency R exceeds F_0."""
        return roots.up_to(partial(self.F, on), self._highest(on))

    def _highest(self, on: Cell) -> arb:
        """The frequency beyond which R exceeds F_0."""
        found: arb = flow.backbone(on.A, on.h - self.F_0).hi
        return found

    def fold_frequencies(self, on: Cell) -> roots.Roots:
        """All roots of F_A: beyond some frequency R is positive, and Omega^2 + h_A."""
        highest = most(flow.backbone(on.A, on.h).hi, of_zeta_0.undamped_Omega(on.h_A).hi)
        return roots.up_to(partial(self.F_A, on), highest)

    def peak_frequencies(self, on: Cell) -> roots.Roots:
        """All roots of F_Omega: beyond some frequency R is positive."""
        return roots.up_to(partial(self.F_Omega, on), flow.backbone(on.A, on.h).hi)

    def level(self, Omega: Enclosure, on: Cell) -> Enclosure:
        """The forcing of a point."""
        found: Enclosure = flow.level(Omega, on.A, self.m, self.zeta, on.h)
        return found

    # ---- folds at the forcing ----

    def fold_on(self, cell: Cell) -> Sequence[Range]:
        """The function whose zeros are folds.

        With viscous damping it ends at Omega = 0, where |k| is the least; F_A there has the sign of h_A.
        """
        bound, k, edge = self.least, cell.k, 0
        if self.zeta.hi == 0:
            y, dy = of_zeta_0.fold(self.F_0, self.m, k, cell.k_A)
            return (Range(positive(-cell.h_A), y, dy),)
        if k.hi < bound.lo and k.lo > -bound.lo:
            return (NOWHERE,)
        if not (k.hi < bound.lo or k.lo > -bound.lo):
            return (Range(Where.PARTLY),)  # on both sides
        where = Where.THROUGHOUT if k.lo >= bound.hi or k.hi <= -bound.hi else Where.PARTLY
        if where is Where.PARTLY:
            k = self._k_of_fold(cell)
            edge = cell.h_A.sign if cell.k_A.sign else 0
        y, dy, _ = flow.fold(cell.A, self.F_0, self.m, self.zeta, cell.h, cell.h_A, k, cell.k_A)
        return (Range(where, y, dy, edge=edge),)

    def _k_of_fold(self, cell: Cell) -> Enclosure:
        """k on a cell that holds a fold, where its size is not below the least."""
        if cell.k.hi >= self.least.lo:
            return clipped(cell.k, low=self.least.lo)
        return clipped(cell.k, high=-self.least.lo)

    def fold_Omega(self, cell: Cell) -> Enclosure:
        """Omega of a fold from I, which exceeds m by little if damping is weak, or h_A; then by F = 0."""
        k, F = self._k_of_fold(cell), partial(self.F, cell)
        if self.zeta.hi == 0:  # next to a breakpoint where the force jumps h_A has no bound
            w = clipped(of_zeta_0.undamped_Omega(cell.h_A), high=self._highest(cell))
        else:
            *_, w = flow.fold(cell.A, self.F_0, self.m, self.zeta, cell.h, cell.h_A, k, cell.k_A)
        Omega: Enclosure = roots.narrowed(F, w)
        if Omega.width > WIDE * Omega.hi:  # two roots may lie in it: at the fold R has the sign of k
            found = roots.Roots([], [])
            roots.between(F, Omega.lo, Omega.hi, found)
            kept = [one for one in found.at if flow.R(one, cell.A, cell.h).sign != -k.sign]
            for number, one in enumerate(kept):
                Omega = Omega.hull(one) if number else one
        return Omega

    def folds(self, A_max: float) -> Found:
        """All of them up to an amplitude, by rising Omega."""
        given, found = self.given, Found()
        search = Search(given, self.fold_on).up_to(A_max)
        found.doubts = _doubts(given, search)
        for zero in search.zeros:
            on, Omega = zero.on, self.fold_Omega(zero.on)
            sign = flow.F_AA(Omega, on.A, self.m, self.zeta, on.h, on.h_A, on.h_AA).sign
            found.add(Omega, given.beyond(zero.piece, zero.beyond), False, sign)
        self._corners(A_max, found)
        return found.by_Omega()

    def _corners(self, A_max: float, found: Found) -> None:
        """Folds on breakpoints where the force jumps: F_A has one sign below and another above."""
        for i, (b, jump) in enumerate(zip(self.given.b, self.given.jumps, strict=True)):
            if jump.lo == jump.hi == 0 or b.lo > A_max:
                continue
            on = self.at_breakpoint(i)
            at = self.frequencies(on)
            if at.full:
                found.doubts.append(b)
            for Omega, doubtful in zip(at.at, at.doubtful, strict=True):
                above = (flow.R(Omega, b, on.h) * jump).sign
                below = self.F_A(on, Omega)[0].sign
                if above and above == below:
                    continue  # no fold, however many roots there are
                if doubtful or not (above and below):
                    found.doubts.append(b)
                else:
                    found.add(Omega, b, True, -below)

    # ---- states at a frequency ----

    def state_on(self, Omega: Enclosure, cell: Cell) -> Sequence[Range]:
        """F by R and its tangent, F_A and F_AA."""
        one, two = flow.state_R(Omega, cell.A, cell.h, cell.h_A, cell.k)
        values = flow.state(Omega, cell.A, self.F_0, self.m, self.zeta, cell.h_A, cell.h_AA, one.both(two))
        return (Range(Where.THROUGHOUT, *values),)

    def states(self, Omega: float, A_max: float) -> Found:
        """All of them up to an amplitude, by rising A."""
        given, found, at = self.given, Found(), Enclosure(arb(Omega), arb(Omega))
        search = Search(given, partial(self.state_on, at)).up_to(A_max)
        found.doubts = _doubts(given, search)
        for zero in sorted(search.zeros, key=lambda zero: (zero.piece, zero.beyond.middle)):
            found.add(at, given.beyond(zero.piece, zero.beyond), False, 1 if zero.rising else -1)
        return found

    # ---- critical forcings ----

    def detachment(self) -> tuple[Enclosure, Enclosure] | None:
        """F_cr, the least level on the first breakpoint, and its Omega: at 0, or where F_Omega vanishes.

        Each place that is tried is a bound from above, and the least lies at one of them: places in doubt do no harm.
        """
        on = self.at_breakpoint(0)
        found = self.peak_frequencies(on)
        if found.full:
            return None
        places = [(self.level(w, on), w) for w in (*found.at, Enclosure(ZERO, ZERO))]
        F_cr = places[0][0]
        for level, _ in places:
            F_cr = Enclosure(least(F_cr.lo, level.lo), least(F_cr.hi, level.hi))
        lowest = [w for level, w in places if level.lo <= F_cr.hi]
        Omega = lowest[0]
        for w in lowest:
            Omega = Omega.hull(w)
        return F_cr, Omega


def _enclosure(value: object) -> Enclosure:
    """What a kernel gives, a number too."""
    return value if isinstance(value, Enclosure) else Enclosure.of(value)


@dataclass(frozen=True)
class Candidate:
    """What may be the lowest forcing that has a fold."""

    level: Enclosure
    Omega: Enclosure
    A: Enclosure
    kind: OnsetKind


class _Cusp(NamedTuple):
    """Of a cusp on a cell: where it is, F_A/2 with its slope, the forcing, Omega^2, and dR/dA."""

    where: Where
    y: Enclosure
    dy: Enclosure
    level: Enclosure
    X: Enclosure
    T: Enclosure


@dataclass
class Candidates:
    """All of them up to a level, and the lowest level in doubt; full: whether there may be others."""

    asked: Asked
    at: list[Candidate] = field(default_factory=list)
    doubted: arb = INFINITE
    full: bool = False

    def enter(self, level: Enclosure, Omega: Enclosure, A: Enclosure, kind: OnsetKind, sign: int) -> None:
        """A level that is a minimum along the fold locus if the sign is positive, none if it is negative."""
        if sign == 0:
            self.doubted = least(self.doubted, level.lo)
        elif sign > 0:
            self.at.append(Candidate(level, Omega, A, kind))

    def lowest(self) -> Candidate | None:
        """What the lowest is known to be; of no kind if that is not known."""
        if not self.at:
            return None
        lo, hi = self.at[0].level.lo, self.at[0].level.hi
        for one in self.at:
            lo, hi = least(lo, one.level.lo), least(hi, one.level.hi)
        kept = [one for one in self.at if one.level.lo <= hi]
        Omega, A = kept[0].Omega, kept[0].A
        for one in kept:
            Omega, A = Omega.hull(one.Omega), A.hull(one.A)
        kinds = {one.kind for one in kept}
        return Candidate(Enclosure(lo, hi), Omega, A, kinds.pop() if len(kinds) == 1 else OnsetKind.NO)

    def isola_on(self, cell: Cell) -> Sequence[Range]:
        """Isola points of levels up to F_0."""
        asked, where = self.asked, positive(cell.h_A)
        if where is Where.NOWHERE or asked.level(flow.isola_Omega(cell.h_A), cell).lo > asked.F_0.hi:
            return (NOWHERE,)
        own = of_mu_0 if asked.m.hi == 0 else flow
        return (Range(where, *own.isola(cell.A, asked.m, asked.zeta, cell.h, cell.h_A, cell.h_AA)),)

    def cusps_on(self, cell: Cell) -> Sequence[Range]:
        """Cusps of levels up to F_0; on the fold locus R has the sign of k, and F_AA = 0 only if h_AA has the other."""
        h_AA, k = cell.h_AA, cell.k
        if (h_AA.lo >= 0 and k.lo >= 0) or (h_AA.hi <= 0 and k.hi <= 0):
            return NOWHERE, NOWHERE
        return tuple(self._cusp_on(cell, larger) for larger in (True, False))

    def _cusp_on(self, cell: Cell, larger: bool) -> Range:
        found = self.cusp(cell, larger)
        if found is None or found.level.lo > self.asked.F_0.hi:
            return NOWHERE
        return Range(found.where, found.y, found.dy)

    def cusp(self, cell: Cell, larger: bool) -> _Cusp | None:
        """Where Omega^2 of a cusp is real and positive; None where nowhere."""
        zeta = self.asked.zeta
        a, b, c, d, discriminant = flow.cusps(cell.A, zeta, cell.h, cell.h_A, cell.h_AA, cell.k)
        if discriminant.hi < 0:
            return None
        root = discriminant.sqrt()
        X = _quadratic_root(c, d, root, larger)
        where = positive(X)
        if where is Where.NOWHERE:
            return None
        where = where if discriminant.lo > 0 else Where.PARTLY
        X = clipped(X, low=ZERO)
        T = _quadratic_root(a, b, root, larger)
        by_tangent, by_F_AA = flow.cusp_R(cell.A, zeta, cell.h_AA, cell.k, X, T)
        R = by_tangent.both(by_F_AA)
        signed = root if larger else -root
        y, same, dy, level = flow.cusp(cell.A, self.asked.m, zeta, cell.h_AA, cell.h_AAA, cell.k, X, T, R, signed)
        return _Cusp(where, y.both(same), dy, level, X, T)

    def _start(self) -> float:
        """Without friction both functions vanish at 0: amplitudes of 1e-60 and less are left out."""
        return 0.0 if self.asked.m.hi > 0 else FIRST

    def cusps_up_to(self, A_max: float) -> Iterator[tuple[Enclosure, Enclosure, Enclosure, int]]:
        """Of each cusp the level, Omega and A, and 1 where the level is least along the fold locus, -1 where most."""
        asked = self.asked
        search = Search(asked.given, self.cusps_on).up_to(A_max, self._start())
        self.full |= bool(search.doubts)
        for zero in search.zeros:
            on, found = zero.on, self.cusp(zero.on, zero.channel == 0)
            assert found is not None, "a cusp that was found has an Omega"
            Omega = found.X.sqrt()
            bend = flow.cusp_bend(Omega, on.A, asked.zeta, on.h_AA, on.h_AAA, found.T)
            yield found.level.both(asked.level(Omega, on)), Omega, on.A, bend.sign

    def all_up_to(self, A_max: float) -> None:
        """Minima of the level along the fold locus.

        They are its cusps and isola points, ends of its pieces on breakpoints, and ends at Omega = 0, where no fold is
        born.
        """
        asked, given = self.asked, self.asked.given
        isolas = Search(given, self.isola_on).up_to(A_max, self._start())
        self.full |= bool(isolas.doubts)
        for zero in isolas.zeros:
            on, Omega = zero.on, flow.isola_Omega(zero.on.h_A)
            bend = flow.isola_bend(Omega, on.A, asked.m, asked.zeta, on.h_AA)
            self.enter(asked.level(Omega, on), Omega, on.A, OnsetKind.ISOLA, bend.sign)
        for level, Omega, A, sign in self.cusps_up_to(A_max):
            self.enter(level, Omega, A, OnsetKind.CUSP, sign)
        for i, jump in enumerate(given.jumps):
            self._corners(i, is_jump=not jump.lo == jump.hi == 0)

    def _corners(self, i: int, is_jump: bool) -> None:
        """Minima on breakpoint i, where the force jumps, or its slope, where the locus bends and does no more."""
        given, b = self.asked.given, self.asked.given.b[i]
        asked, m, zeta, on = self.asked, self.asked.m, self.asked.zeta, self.asked.at_breakpoint(i)
        jump = (given.jumps if is_jump else given.kinks)[i].sign
        if is_jump and on.h.lo < 0 and jump <= 0:
            Omega = flow.backbone(b, on.h)
            self.enter(asked.level(Omega, on), Omega, b, OnsetKind.CORNER, -jump if on.h.hi < 0 else 0)

        def consider(found: roots.Roots, signs: Callable[[Enclosure, int], tuple[int, int]]) -> None:
            self.full |= found.full
            for w, doubtful in zip(found.at, found.doubtful, strict=True):
                one, other = signs(w, flow.R(w, b, on.h).sign * jump)
                sign = 0 if doubtful else -1 if min(one, other) < 0 else one * other
                self.enter(asked.level(w, on), w, b, OnsetKind.CORNER, sign)

        def of_folds(w: Enclosure, beyond: int) -> tuple[int, int]:
            slopes = flow.F_Omega(w, b, m, zeta, on.h) * flow.F_AOmega(w, b, m, zeta, on.h, on.h_A)
            return -flow.level_rise(w, b, m, zeta, on.h, on.h_A, on.h_AA).sign, -beyond * slopes.sign

        def of_peaks(w: Enclosure, beyond: int) -> tuple[int, int]:
            return -beyond * flow.F_A(w, b, m, zeta, on.h, on.h_A).sign, flow.F_OmegaOmega(w, b, zeta, on.h).sign

        consider(asked.fold_frequencies(on), of_folds)
        if is_jump:
            consider(asked.peak_frequencies(on), of_peaks)


def _quadratic_root(a: Enclosure, b: Enclosure, root: Enclosure, larger: bool) -> Enclosure:
    """A root of x^2 + 2 a x + b, root^2 = a^2 - b."""
    return _larger_root(a, b, root) if larger else -_larger_root(-a, b, root)


def _larger_root(a: Enclosure, b: Enclosure, root: Enclosure) -> Enclosure:
    """From both forms; as it falls with b, and for b <= 0 with a, corners hold it too."""
    x = root - a
    if a.lo >= 0:
        x = x.both(-(b / (a + root)))
    if b.lo <= 0:
        x = clipped(x, high=_larger_root_at(a.lo, b.lo).hi)
    if b.hi <= 0:
        x = clipped(x, low=_larger_root_at(a.hi, b.hi).lo)
    return x


def _larger_root_at(a: arb, b: arb) -> Enclosure:
    """The same of numbers."""
    of_a, of_b = Enclosure(a, a), Enclosure(b, b)
    root = (of_a.square() - of_b).sqrt()
    return -of_b / (of_a + root) if a > 0 else root - of_a


def lowest_of_all(given: Given) -> tuple[Candidate | None, bool]:
    """The lowest forcing at which a fold is born, None if there is none, and whether that is proved.

    Among all forcings, and amplitudes up to one that stands for infinite ones.
    """
    candidates = Candidates(Asked(given, math.inf))
    candidates.all_up_to(ENDLESS)
    best = candidates.lowest()
    return best, not candidates.full and bool(candidates.doubted > (best.level.hi if best else 0))


def lowest_at_rest(given: Given) -> Enclosure | None:
    """The lowest level at which the fold locus ends at Omega = 0, infinite if it nowhere does; None if not decided.

    There h_A vanishes, or h, and so R; from where F_Omega falls below 0 without friction the level does not rise, so
    that there are folds at every forcing about it. Of amplitudes from 1e-60 on.
    """
    least_level = Enclosure(INFINITE, INFINITE)
    asked = Asked(given, math.inf)

    def consider(level: Enclosure) -> None:
        nonlocal least_level
        least_level = Enclosure(least(level.lo, least_level.lo), least(level.hi, least_level.hi))

    def end(on: Cell) -> bool:
        """Whether it is decided if it is one."""
        rises = 1 if given.m.lo > 0 else flow.F_OmegaOmega(Enclosure(ZERO, ZERO), on.A, given.zeta, on.h).sign
        if rises > 0:
            consider(asked.level(Enclosure(ZERO, ZERO), on))
        return bool(rises)

    def ends_on(cell: Cell) -> Sequence[Range]:
        return Range(Where.THROUGHOUT, cell.h, cell.h_A), Range(Where.THROUGHOUT, cell.h_A, cell.h_AA)

    search = Search(given, ends_on).up_to(ENDLESS, FIRST)
    if search.doubts:
        return None
    for zero in search.zeros:
        if zero.channel == 0:
            consider(given.m)
        elif not end(zero.on):
            return None
    for i, jump in enumerate(given.jumps):
        on = asked.at_breakpoint(i)
        if jump.lo == jump.hi == 0 or jump.sign * on.h_A.sign > 0:
            continue
        # h_A of the other side is infinite there: it passes 0 on the breakpoint
        if not (jump.sign and on.h_A.sign and end(on)):
            return None
    return least_level


def lowest_next_to(given: Given, F_SN: float, A_max: float) -> tuple[Candidate | None, bool]:
    """The same next to one that was found, which takes less time.

    A_max -- what no state at a forcing a little above exceeds
    """
    F_0 = F_SN * (1 + ABOVE_ONSET)
    candidates = Candidates(Asked(given, F_0), full=not is_bounded(given, arb(F_0), A_max))
    candidates.all_up_to(A_max)
    best = candidates.lowest()
    proved = best is not None and not candidates.full and candidates.doubted > best.level.hi and best.level.hi < F_0
    return best, bool(proved)


# ---- without viscous damping: folds lie at Omega^2 = -h_A, their R is k ---------------------------


def tends_to_friction(given: Given) -> bool:
    """Whether it is proved that folds come as near to 4 mu/pi as one asks, because k tends to 0 on the locus."""
    if _tends_at_rest(given) or any(_tends_at(given, i) for i in range(given.count)):
        return True
    return bool(_undamped(given, 1).zeros)


def _tends_at_rest(given: Given) -> bool:
    """Next to A = 0, where k is 0: h_A is negative next to it."""
    A = min(float(given.b[0].lo), 1.0) if given.count else 1.0
    first = given.at(0, ZERO)
    while first.k.lo == first.k.hi == 0 and A > FIRST:
        last = given.at(0, arb(A))
        cell = cell_between(Enclosure(ZERO, last.A), first, last)
        falls = cell.h_AA.hi < 0 or (first.h_AA.hi <= 0 and cell.h_AAA.hi < 0)
        if cell.h_A.hi < 0 or (first.h_A.hi <= 0 and falls):
            return bool(last.k.sign)
        A *= 0.125
    return False


def _tends_at(given: Given, i: int) -> bool:
    """On a breakpoint: where the force jumps by J folds sit on it at Omega^2 > -h_A, if J < 0, or below."""
    at, jump = given.below(i), given.jumps[i].sign
    if jump < 0:
        return bool((at.h_A.hi < 0 and at.k.hi <= 0) or (at.h_A.lo >= 0 and at.h.hi <= 0))
    return jump > 0 and bool(at.h_A.hi < 0 and at.h.hi <= 0 and at.k.lo >= 0)


def _undamped(given: Given, channel: int) -> Search:
    """Where, on the locus, h_AA vanishes (channel 0) or k (channel 1), on all amplitudes."""

    def on(cell: Cell) -> Sequence[Range]:
        y, dy = (cell.h_AA, cell.h_AAA) if channel == 0 else (cell.k, cell.k_A)
        return (Range(positive(-cell.h_A), y, dy),)

    return Search(given, on).up_to(ENDLESS, FIRST)


def lowest_undamped(given: Given) -> tuple[Candidate | None, bool]:
    """As `lowest_of_all`, where k does not tend to 0: the level is least where |k| is, along A and on breakpoints."""
    candidates = Candidates(Asked(given, math.inf))
    asked, turns = candidates.asked, _undamped(given, 0)
    far = given.at(given.count, arb(ENDLESS))
    rises = far.h_A.lo >= 0 or of_zeta_0.undamped_rises(far.h_AA, far.h_AAA, far.k)[0].lo >= 0
    candidates.full = bool(turns.doubts or _undamped(given, 1).doubts or not rises)
    for zero in turns.zeros:
        on = zero.on
        Omega = of_zeta_0.undamped_Omega(on.h_A)
        candidates.enter(
            asked.level(Omega, on),
            Omega,
            on.A,
            OnsetKind.CUSP,
            of_zeta_0.undamped_rises(on.h_AA, on.h_AAA, on.k)[1].sign,
        )
    for i, (jump, kink) in enumerate(zip(given.jumps, given.kinks, strict=True)):
        on, none = asked.at_breakpoint(i), jump.lo == jump.hi == 0
        if on.h_A.lo >= 0:
            continue
        # |k| falls below; above h_AA is infinite, with the sign of what the slope loses
        falls = -of_zeta_0.undamped_rises(on.h_AA, on.h_AAA, on.k)[0].sign
        turn = -(on.k * kink).sign if none else 1 if jump.sign < 0 else -on.k.sign
        sign = 0 if not (on.h_A.sign and falls and turn and (none or jump.sign)) else min(falls, turn)
        Omega = of_zeta_0.undamped_Omega(on.h_A)
        candidates.enter(asked.level(Omega, on), Omega, on.A, OnsetKind.CORNER, sign)
    best = candidates.lowest()
    return best, not candidates.full and bool(candidates.doubted > (best.level.hi if best else 0))
