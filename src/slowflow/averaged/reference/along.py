"""What is asked along the amplitude: samples of the averaged force in, functions of A whose zeros count out.

Or cells of amplitudes in, and out what these functions and their slopes are on all of each cell.

=========  ==================  ======================================================================================
Stiffness                      h and h_A: the static state and its fold at Omega = 0
Fold       F = F_A = 0         R, I and so Omega from both, put into R = A Omega^2 + h
Isola      F_A = F_Omega = 0   Omega from both, put into F_Omega
Cusp       F_A = F_AA = 0      F_AA is biquadratic in Omega: both roots in closed form, put into F_A
Turn       F_A = F_AOmega = 0  F_A at its two critical points in Omega
Undamped   cusps for zeta = 0  h_AA = 0, or the locus touches the backbone R = 0
Peak       F = F_Omega = 0     F at its two critical points in Omega
Rest       F = Omega = 0       h^2 + m^2 = F_0^2
Inertia    peaks and isolas    of an excitation by inertia: where an amplitude's level is least, in closed form
=========  ==================  ======================================================================================

As in native/along.h and native/ranges.h. The functions are generated, for numbers and for intervals
(derivations/along.py). Designs may go abreast: samples and cells say which of them they are of.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from slowflow.averaged.reference.cells import Cells, Samples, doubtful
from slowflow.averaged.reference.doubt import is_fold_close
from slowflow.averaged.reference.roots import Quartics, critical_points, fold_roots, peak_roots, taken
from slowflow.intervals import Bools, Interval
from slowflow.model import Floats, Model
from slowflow_kernels import (
    inertia,
    inertia_intervals,
    slow_flow,
    slow_flow_intervals,
    slow_flow_mu0_intervals,
    slow_flow_zeta0_intervals,
)
from slowflow_kernels.conventions import BESIDE, CANCELLED, CLOSE, DOUBT, SOFT

#: of -R/I, up to which R follows from I better than from h where that is all rounding; how many are tried until none
#: changes Omega: as in native/inertial.h
LARGEST_SHARE, MOST_SHARES = 0.5, 100
#: where a channel is defined on a cell
NOWHERE, PARTLY, THROUGHOUT = 0, 1, 2


@dataclass(frozen=True, eq=False)
class Channels:
    """The channels of a question at samples.

    rows -- array (7, channels, n):
        exists, y, dy  -- whether it is defined, its value and slope
        Omega, Omega_A -- of its zero, and dOmega/dA where that is known, else 0
        level          -- a cusp's forcing
        edge           -- its sign where it ends, if it ends next to the sample; 0 where that is not known
    """

    rows: Floats

    def take(self, which: Any) -> Channels:
        """At some of them."""
        return Channels(self.rows[..., which])

    @property
    def exists(self) -> Bools:
        return np.asarray(self.rows[0] != 0)

    @property
    def y(self) -> Floats:
        return np.asarray(self.rows[1])

    @property
    def dy(self) -> Floats:
        return np.asarray(self.rows[2])

    @property
    def Omega(self) -> Floats:
        return np.asarray(self.rows[3])

    @property
    def Omega_A(self) -> Floats:
        return np.asarray(self.rows[4])

    @property
    def level(self) -> Floats:
        return np.asarray(self.rows[5])

    @property
    def edge(self) -> Floats:
        return np.asarray(self.rows[6])


@dataclass(frozen=True, eq=False)
class Ranges:
    """The channels on cells: where they are defined, what holds them and their slopes there; arrays (channels, n).

    edge -- its sign at the end of where it is defined, if there is one such end in the cell and the sign is known; or 0
    once -- whether it has one zero at most, its slope apart
    """

    where: np.ndarray[Any, np.dtype[np.int_]]
    y: Interval
    dy: Interval
    edge: np.ndarray[Any, np.dtype[np.int_]]
    once: Bools


def _channels(count: int, like: Samples, exists: Any, y: Any, dy: Any, Omega: Any = 0.0, *beside: Any) -> Channels:
    """Of values that broadcast to (count, n)."""
    rows = np.zeros((7, count, len(like)))
    for row, value in zip(rows, (exists, y, dy, Omega, *beside), strict=False):
        row[...] = value
    return Channels(rows)


def _ranges(count: int, like: Cells, where: Any, y: Interval, dy: Interval, edge: Any = 0, once: Any = False) -> Ranges:
    """Of intervals (2, count n), channel by channel, and flags that broadcast to (count, n)."""
    shape = (count, len(like))
    y, dy = (Interval(one.ends.reshape(2, *shape)) for one in (y, dy))
    where, edge, once = (np.broadcast_to(flag, shape) for flag in (where, edge, once))
    return Ranges(where, y, dy, edge, once)


def _beside(*parts: Interval) -> Interval:
    """All of them, one after the other."""
    return Interval(np.concatenate([part.ends for part in parts], axis=1))


def _largest(x: Interval) -> Floats:
    return np.asarray(np.maximum(np.abs(x.lo), np.abs(x.hi)))


def _unknown(like: Cells) -> Interval:
    return Interval(np.array([[-np.inf], [np.inf]]) + np.zeros(len(like)))


def _where_positive(x: Interval) -> np.ndarray[Any, np.dtype[np.int_]]:
    return np.where(x.lo > 0, THROUGHOUT, np.where(x.hi <= 0, NOWHERE, PARTLY))


class Asked:
    """One of those above, about a model, with so many `channels`."""

    channels: ClassVar[int] = 2

    def __init__(self, model: Model) -> None:
        self.model = model

    def damping(self, cells: Cells) -> tuple[Interval, Interval]:
        """m and zeta on cells."""
        own = self.model.take(cells.of)
        return Interval.point(own.m), Interval.point(own.zeta)

    def ask(self, at: Samples) -> Channels:
        """At samples."""
        raise NotImplementedError

    def range(self, cells: Cells) -> Ranges:
        """On cells."""
        raise NotImplementedError

    def is_close(self, at: Samples, answers: Channels) -> Bools:
        """At which samples rounding may decide a number of zeros, as far as these tell."""
        return np.zeros(len(at), dtype=bool)


class Stiffness(Asked):
    """h, next to A = 0 over A, and h_A."""

    def ask(self, at: Samples) -> Channels:
        first = np.where(at.A > 0, at.h, at.h_A)
        return _channels(2, at, True, np.array((first, at.h_A)), np.array((at.h_A, at.h_AA)))

    def range(self, cells: Cells) -> Ranges:
        # where h is constant, as under a preload alone, F_A vanishes at Omega = 0 throughout: nothing ends there
        flat = (cells.h_A.lo == 0) & (cells.h_A.hi == 0)
        inside = (cells.A.lo > 0) | flat
        y = _beside(cells.h.where(inside, cells.h_A), cells.h_A)
        dy = _beside(cells.h_A.where(inside, cells.h_AA), cells.h_AA)
        return _ranges(2, cells, np.where([np.zeros_like(flat), flat], NOWHERE, THROUGHOUT), y, dy)


class FoldAt(Asked):
    """At a forcing. With viscous damping the channel ends at Omega = 0, where |k| is the least."""

    channels = 1

    def __init__(self, model: Model, F_0: Any) -> None:
        super().__init__(model)
        self.F_0 = F_0
        self.least = slow_flow.least_restoring(F_0, model.m)

    def ask(self, at: Samples) -> Channels:
        model, F_0 = self.model.take(at.of), taken(self.F_0, at.of)
        _, k_A = slow_flow.intercept(at.A, at.h, at.h_A, at.h_AA)
        if model.undamped:
            y, dy = model.flow.fold(F_0, model.m, at.k, k_A)
            return _channels(1, at, at.h_A < 0, y, dy, model.flow.undamped_Omega(np.minimum(at.h_A, 0.0)))
        y, dy, Omega = model.flow.fold(at.A, F_0, model.m, model.zeta, at.h, at.h_A, at.k, k_A)
        # |k| may be the least but for the rounding of that: then y is NaN
        exists = (np.abs(at.k) >= taken(self.least, at.of)) & ~np.isnan(y)
        # F_A has the sign of h_A where the channel ends
        return _channels(1, at, exists, y, dy, self._Omega(model, at, Omega, y), 0.0, 0.0, np.sign(at.h_A))

    def is_close(self, at: Samples, answers: Channels) -> Bools:
        """Where the function is next to 0."""
        model, F_0, least = self.model.take(at.of), taken(self.F_0, at.of), taken(self.least, at.of)
        return np.asarray(answers.exists[0] & is_fold_close(model, F_0, least, at, answers.y[0], answers.Omega[0]))

    def _Omega(self, model: Model, at: Samples, Omega: Floats, y: Floats) -> Floats:
        """Where a fold may be, from I or from R, y being what the two lack of agreeing: what rounding moves less.

        I exceeds m by little if damping is weak, and |k| the least if Omega is low.
        """
        lag, square = slow_flow.I(Omega, at.A, 0.0, model.zeta), slow_flow.fold_square(Omega, at.A, y)
        least = taken(self.least, at.of) / at.k
        of_I = (lag + model.m) / (lag * (1 - least) * (1 + least))
        of_R = (2 * np.abs(at.h) + at.A * square) / (at.A * square)
        return np.where((square > 0) & ~(of_R >= of_I), np.sqrt(np.maximum(square, 0.0)), Omega)

    def range(self, cells: Cells) -> Ranges:
        k, force, least = cells.k, taken(self.F_0, cells.of), taken(self.least, cells.of)
        F_0, (m, zeta) = Interval.point(force), self.damping(cells)
        if self.model.undamped:
            y, dy = slow_flow_zeta0_intervals.fold(F_0, m, k, cells.k_A)
            return _ranges(1, cells, _where_positive(-cells.h_A), y, dy)
        nowhere = (k.hi < least) & (k.lo > -least)
        both_sides = ~((k.hi < least) | (k.lo > -least))
        whole = (k.lo >= least) | (k.hi <= -least)
        above = k.hi >= least
        part = Interval.of(np.where(above, np.maximum(k.lo, least), k.lo), np.where(above, k.hi, -least))
        k = k.where(whole, part)
        where = np.where(nowhere, NOWHERE, np.where(whole, THROUGHOUT, PARTLY))
        # F_A has the sign of h_A where the channel ends
        known = ~whole & ~both_sides & cells.k_A.has_sign & cells.h_A.has_sign
        edge = np.where(known, np.where(cells.h_A.lo > 0, 1, -1), 0)
        y, dy, _ = slow_flow_intervals.fold(cells.A, F_0, m, zeta, cells.h, cells.h_A, k, cells.k_A)
        # if that turns on the cell a fold may lie so near to the end that rounding of the least decides
        turns, h, h_A = (where == PARTLY) & ~cells.h_A.has_sign, _largest(cells.h), _largest(cells.h_A)
        rounding = np.where(turns, CLOSE * (force + h + cells.A.hi * (1 + h_A)), 0.0)
        y = y + Interval.of(-rounding, rounding)
        unknown = _unknown(cells)
        return _ranges(1, cells, where, unknown.where(both_sides, y), unknown.where(both_sides, dy), edge)


class Isola(Asked):
    """For zeta > 0; for m = 0 without the factor Omega."""

    channels = 1

    def ask(self, at: Samples) -> Channels:
        model = self.model.take(at.of)
        rises = np.maximum(at.h_A, 0.0)
        y, dy = model.flow.isola(at.A, model.m, model.zeta, at.h, rises, at.h_AA)
        # where the channel ends, at Omega = 0, F_Omega/(4 A) is m zeta
        edge = np.where((model.m > 0) & (model.zeta > 0), 1.0, 0.0)
        return _channels(1, at, at.h_A > 0, y, dy, self._Omega(model, at, rises), 0.0, 0.0, edge)

    def _Omega(self, model: Model, at: Samples, rises: Floats) -> Floats:
        """Omega^2 = h_A, or, where h_A is small beside its terms, the root of F_Omega, without h_A, next to that.

        Where h_A is as small as its rounding that is all that is left of Omega.
        """
        rounding = CLOSE * (np.abs(at.h) / at.A + np.abs(at.h_A))
        roots, count = peak_roots(np.where(at.A > 0, at.A, 1.0), at.h, model.m, model.zeta)
        lost = (rises * at.A < SOFT * np.abs(at.h)) & (count == 2)
        lost &= np.abs(roots[:, 0] ** 2 - rises) < 2 * BESIDE * rises + rounding
        return np.where(lost, roots[:, 0], slow_flow.isola_Omega(rises))

    def range(self, cells: Cells) -> Ranges:
        intervals = slow_flow_intervals if np.any(self.model.m) else slow_flow_mu0_intervals
        y, dy = intervals.isola(cells.A, *self.damping(cells), cells.h, cells.h_A, cells.h_AA)
        return _ranges(1, cells, _where_positive(cells.h_A), y, dy)


def _folds_next_to(model: Model, at: Samples, some: Bools, w: Floats, level: Floats) -> None:
    """Puts into Omega and level (2, n), some of them, those of the fold at A whose Omega is the nearest.

    Next to Omega = 0 a rounding of A moves the root X = Omega^2 of F_AA by more than X, but hardly that fold, whose
    Omega is a root of F_A.
    """
    channel, those = some.nonzero()
    if not those.size:
        return
    thrice = np.repeat(those, 3)
    A, h, h_A, m, zeta = (taken(column, thrice) for column in (at.A, at.h, at.h_A, model.m, model.zeta))
    index = np.tile(np.arange(3), those.size)
    folds = Quartics(A, h, h_A, m, zeta, -1.0)
    count = folds.count().astype(np.intp)
    roots = np.where(index < count, folds.roots(count, index), np.nan).reshape(-1, 3)
    off = np.where(np.isnan(roots), np.inf, np.abs(roots - w[channel, those][:, np.newaxis]))
    found = np.isfinite(off).any(axis=1)
    channel, those = channel[found], those[found]
    nearest = np.take_along_axis(roots, off.argmin(axis=1)[:, np.newaxis], axis=1)[found, 0]
    w[channel, those] = nearest
    m, zeta = taken(model.m, those), taken(model.zeta, those)
    level[channel, those] = slow_flow.level(nearest, at.A[those], m, zeta, at.h[those])


def _quadratic_roots(a: Floats, b: Floats, root: Floats) -> Floats:
    """The larger and the smaller root (2, n) of x^2 + 2 a x + b, root^2 = a^2 - b."""
    plus, minus = a + root, root - a
    return np.array((np.where(a > 0, -b / plus, minus), np.where(a < 0, b / minus, -plus)))


def _quadratic_root_ranges(a: Interval, b: Interval, root: Interval) -> Interval:
    """The same as of numbers, the larger roots before the smaller ones; both forms hold the root."""
    plus, minus = a + root, root - a
    direct, quotient = _beside(minus, -plus), _beside(-b, b) / _beside(plus, minus)
    return direct.both(quotient).where(np.concatenate((a.lo >= 0, a.hi <= 0)), direct)


class Cusp(Asked):
    """For zeta > 0; those at a forcing above F_0 may be left out. The first channel is the larger root Omega^2."""

    def __init__(self, model: Model, F_0: Any = np.inf) -> None:
        super().__init__(model)
        self.F_0 = F_0

    def ask(self, at: Samples) -> Channels:
        model = self.model.take(at.of)
        a, b, c, d, square = slow_flow.cusps(at.A, model.zeta, at.h, at.h_A, at.h_AA, at.k)
        root = np.sqrt(np.maximum(square, 0.0))
        X, T = _quadratic_roots(c, d, root), _quadratic_roots(a, b, root)
        # where a channel ends at Omega = 0 F_A has the sign of h h_A
        edge = np.where(np.abs(d) <= CLOSE * c * c, np.where(at.h * at.h_A > 0, 1.0, -1.0), 0.0)
        exists = (square >= 0) & (X > 0)
        X = np.where(exists, X, np.nan)
        by_tangent, by_F_AA = slow_flow.cusp_R(at.A, model.zeta, at.h_AA, at.k, X, T)
        # k + A T has lost digits
        lost = np.abs(by_tangent) < CANCELLED * np.abs(at.k)
        R, w, signed = np.where(lost, by_F_AA, by_tangent), np.sqrt(X), np.array((root, -root))
        y, _, dy, level = slow_flow.cusp(at.A, model.m, model.zeta, at.h_AA, at.h_AAA, at.k, X, T, R, signed)
        # a rounding of A moves h_AA by much where that is steep, but no fold by F_A beside a cusp
        nearly, _ = slow_flow.cusp_balance(at.A, model.m, model.zeta, at.h, at.k, X, T)
        right, forcing = slow_flow.cusp_balance(at.A, model.m, model.zeta, at.h, at.k, nearly, T)
        small = np.abs(slow_flow.R(np.sqrt(nearly), at.A, at.h)) < SOFT * np.abs(at.h)
        lost &= small & (right > 0) & (forcing > 0)
        w, level = np.where(lost, np.sqrt(right), w), np.where(lost, np.sqrt(forcing), level)
        _folds_next_to(model, at, X < SOFT * np.abs(c), w, level)
        return _channels(2, at, exists, y, dy, w, 0.0, level, edge)

    def range(self, cells: Cells) -> Ranges:
        """On the fold locus R has the sign of k.

        There F_AA/2 = (dR/dA)^2 + h_AA R + 4 zeta^2 Omega^2 vanishes only if h_AA has the other sign.
        """
        alike = ((cells.h_AA.lo >= 0) & (cells.k.lo >= 0)) | ((cells.h_AA.hi <= 0) & (cells.k.hi <= 0))
        free, twice = self._is_free_of_folds(cells), cells.twice()
        _, zeta = self.damping(cells)
        a, b, c, d, square = slow_flow_intervals.cusps(cells.A, zeta, cells.h, cells.h_A, cells.h_AA, cells.k)
        root, n = square.sqrt(), len(cells)
        # X and T, by their larger and by their smaller roots
        both = _quadratic_root_ranges(_beside(c, a), _beside(d, b), _beside(root, root)).ends.reshape(2, 2, 2, n)
        X, T = (Interval(both[:, :, k].reshape(2, 2 * n)) for k in (0, 1))
        where = _where_positive(X).reshape(2, n)
        where = np.where(square.lo > 0, where, np.minimum(where, PARTLY))
        X, signed, (m, zeta) = Interval.of(np.maximum(X.lo, 0.0), X.hi), _beside(root, -root), self.damping(twice)
        by_tangent, by_F_AA = slow_flow_intervals.cusp_R(twice.A, zeta, twice.h_AA, twice.k, X, T)
        y, less, dy, level = slow_flow_intervals.cusp(
            twice.A, m, zeta, twice.h_AA, twice.h_AAA, twice.k, X, T, by_tangent.both(by_F_AA), signed
        )
        above = level.lo.reshape(2, n) > taken(self.F_0, cells.of)
        where = np.where(alike | free | (square.hi < 0) | above, NOWHERE, where)
        return _ranges(2, cells, where, y.both(less), dy)

    def _is_free_of_folds(self, cells: Cells) -> Bools:
        """Whether F_A > 0 at all frequencies, which is known also where h_AA is infinite.

        That is where without friction no coefficient of it is negative, or where its discriminant is. Next to A = 0
        h/A is a slope of h: without a preload h = 0 there.
        """
        slope, origin = cells.h_A, cells.A.lo == 0
        over_A = slope.where(origin, cells.h / cells.A)
        apart = (slope - slope).where(origin, cells.k / cells.A)
        b, discriminant = slow_flow_intervals.fold_least(self.damping(cells)[1], slope, over_A, apart)
        alike = ((slope.lo >= 0) & (over_A.lo >= 0)) | ((slope.hi <= 0) & (over_A.hi <= 0))
        known = ~origin | (taken(self.model.preload, cells.of) == 0)
        return np.asarray(known & ((alike & (b.lo > 0)) | (discriminant.hi < 0)))


def _over_A(cells: Cells) -> tuple[Interval, Interval]:
    """A and h, or, next to A = 0, where functions of them vanish, 1 and h/A, which is a slope of h."""
    origin = cells.A.lo == 0
    return Interval.point(1.0).where(origin, cells.A), cells.h_A.where(origin, cells.h)


def _critical_of(cells: Cells, p: Interval, q: Floats) -> tuple[Any, Interval]:
    """Positive roots w1 < w2 of A w^3 + p w + q: where they exist, and what holds them, (2, 2 n).

    As A and p rise w1 rises and w2 falls, so the corners of the box (A, p) hold them. Next to A = 0, where p vanishes
    too, p is asked over A; with friction there is no root for small A.
    """
    A, n = cells.A, cells.A.lo.size
    q = np.broadcast_to(q, n)
    origin = A.lo == 0
    inner = np.where(origin, A.hi, A.lo)
    steepest = np.where(origin, np.minimum(p.lo, 0.0) * (1 + DOUBT) * A.hi, p.lo)
    exist, first, second = critical_points(
        np.concatenate((inner, A.hi)), np.concatenate((steepest, p.hi)), np.tile(q, 2)
    )
    low, high = exist[:n], exist[n:]
    where = np.where(low, np.where(high, THROUGHOUT, PARTLY), NOWHERE)
    # where only the lower corner has them they meet in between, or at 0
    w1 = Interval.of(first[:n] * (1 - DOUBT), np.where(high, first[n:], np.where(q > 0, second[:n], 0.0)) * (1 + DOUBT))
    w2 = Interval.of(np.where(high, second[n:], first[:n]) * (1 - DOUBT), second[:n] * (1 + DOUBT))
    where = np.where(origin, np.where((p.lo < 0) & low, PARTLY, NOWHERE), where)
    most = np.sqrt(np.maximum(-p.lo, 0.0)) * (1 + DOUBT)
    # the higher one lies above where the cubic's slope is 0
    least = np.sqrt(np.maximum(-p.hi, 0.0) / 3) * (1 - DOUBT)
    w1, w2 = Interval.of(np.zeros(n), most).where(origin, w1), Interval.of(least, most).where(origin, w2)
    return where, _beside(w1, w2)


class Turn(Asked):
    """For zeta > 0; without friction the first channel lies at Omega = 0 and belongs to other questions."""

    def ask(self, at: Samples) -> Channels:
        model, flow = self.model.take(at.of), slow_flow
        inside = at.A > 0
        A = np.where(inside, at.A, 1.0)
        quartics = Quartics(A, at.h, at.h_A, model.m, model.zeta, -1.0)
        w, y = np.array(quartics.critical).swapaxes(0, 1)
        dy = 0.5 * flow.F_AA(w, A, model.m, model.zeta, at.h, at.h_A, at.h_AA)
        # at the upper one F_A is all rounding of h if damping is weak
        y[1], dy[1] = flow.turn(w[1], A, model.m, model.zeta, at.h_AA, at.k)
        return _channels(2, at, inside & quartics.exist & (w > 0), y, dy, w)

    def range(self, cells: Cells) -> Ranges:
        A, h = _over_A(cells)
        m, zeta = self.damping(cells)
        _, q, p, _ = slow_flow_intervals.fold_quartic(A, m, zeta, h, cells.h_A)
        where, w = _critical_of(cells, 0.5 * p, 0.25 * q.lo)
        origin = cells.A.lo == 0
        m = (m / cells.A).where(origin, m)
        k = cells.k_A.where(origin, cells.k)  # next to A = 0 k/A is a slope of k
        n = len(cells)
        w1, w2 = Interval(w.ends[:, :n]), Interval(w.ends[:, n:])
        lower = 0.5 * slow_flow_intervals.F_A(w1, A, m, zeta, h, cells.h_A)
        lower_A = 0.5 * slow_flow_intervals.F_AA(w1, A, m, zeta, h, cells.h_A, cells.h_AA)
        upper, upper_A = slow_flow_intervals.turn(w2, A, m, zeta, cells.h_AA, k)
        dy = _unknown(cells.twice()).where(np.tile(origin, 2), _beside(lower_A, upper_A))
        there = [np.where(taken(self.model.m, cells.of) > 0, where, NOWHERE), where]
        return _ranges(2, cells, there, _beside(lower, upper), dy)


class Undamped(Asked):
    """For zeta = 0: h_AA, next to A = 0 over A, and R, there over A^3/3."""

    def ask(self, at: Samples) -> Channels:
        flow = self.model.flow
        first, first_A, second, second_A = flow.undamped(at.A, at.h, at.h_A, at.h_AA, at.h_AAA)
        falls, inside = at.h_A < 0, at.A > 0
        Omega = flow.undamped_Omega(np.minimum(at.h_A, 0.0))
        y = np.where(inside, (first, second), (at.h_AAA, -at.h_AAA))
        return _channels(2, at, falls, y, np.array((first_A, second_A)), Omega)

    def range(self, cells: Cells) -> Ranges:
        where, inside, unknown = _where_positive(-cells.h_A), cells.A.lo > 0, _unknown(cells)
        y = _beside(cells.h_AA.where(inside, cells.h_AAA), cells.k.where(inside, -cells.h_AAA))
        dy = _beside(cells.h_AAA.where(inside, unknown), cells.k_A.where(inside, unknown))
        return _ranges(2, cells, where, y, dy)


class Peak(Asked):
    """At a forcing, for zeta > 0. The second channel is the minimum over Omega; without friction it is the only one."""

    def __init__(self, model: Model, F_0: Any) -> None:
        super().__init__(model)
        self.F_0 = F_0

    def ask(self, at: Samples) -> Channels:
        own, F_0 = self.model.take(at.of), taken(self.F_0, at.of)
        m, zeta = own.m, own.zeta
        inside = at.A > 0
        A = np.where(inside, at.A, 1.0)
        w, n = peak_roots(A, at.h, m, zeta)
        channel = np.array([[0], [1]])
        exists = inside & (n > 1 - channel) & (zeta > 0)
        Omega = np.where(exists, w[np.arange(len(at)), np.clip(channel + n - 2, 0, 1)], np.nan)
        y, dy = slow_flow.peak(Omega, A, F_0, m, zeta, at.h_A)
        return _channels(2, at, exists, y, dy, Omega, slow_flow.peak_Omega_A(Omega, A, m, zeta, at.h_A))

    def range(self, cells: Cells) -> Ranges:
        twice = cells.twice()
        if self.model.undamped:
            return _ranges(2, cells, NOWHERE, _unknown(twice), _unknown(twice))
        A, h = _over_A(cells)
        q, p, _ = slow_flow_intervals.peak_cubic(A, *self.damping(cells), h)
        where, w = _critical_of(cells, p, q.lo)
        F_0 = Interval.point(taken(self.F_0, twice.of))
        y, dy = slow_flow_intervals.peak(w, twice.A, F_0, *self.damping(twice), twice.h_A)
        y = Interval.of(np.where(y.lo > -np.inf, y.lo, -np.inf), np.fmin(y.hi, np.tile(self._most(cells), 2)))
        there = [np.where(taken(self.model.m, cells.of) > 0, where, NOWHERE), where]
        return _ranges(2, cells, there, y, dy)

    def _most(self, cells: Cells) -> Floats:
        """What F does not exceed at an extremum over Omega.

        There R = -zeta I/Omega is not positive, so that |R| <= |h| and A Omega^2 <= |h|: of small amplitudes this tells
        all, also where h/A has no bound.
        """
        size = np.maximum(np.abs(cells.h.lo), np.abs(cells.h.hi))
        # A Omega = sqrt(A size) at most
        own, F_0 = self.model.take(cells.of), np.asarray(taken(self.F_0, cells.of))
        lag = slow_flow.I(np.sqrt(cells.A.hi * size), 1.0, own.m, own.zeta)
        with np.errstate(over="ignore", invalid="ignore"):  # beyond the range of doubles it tells nothing
            return np.asarray((size**2 + lag**2) * (1 + DOUBT) - F_0 * F_0 * (1 - DOUBT))


class Rest(Asked):
    """At a forcing: h^2 + m^2 = F_0^2 has two smooth halves."""

    def __init__(self, model: Model, F_0: Any) -> None:
        super().__init__(model)
        self.F_0 = F_0

    def ask(self, at: Samples) -> Channels:
        lower, upper, slope = slow_flow.rest(taken(self.F_0, at.of), self.model.take(at.of).m, at.h, at.h_A)
        return _channels(2, at, True, np.array((lower, upper)), slope)

    def range(self, cells: Cells) -> Ranges:
        # F at A = 0: -c and c
        halves = slow_flow.rest(taken(self.F_0, cells.of), self.model.take(cells.of).m, 0.0, 0.0)[:2]
        doubts = (DOUBT * np.abs(half) for half in halves)
        around = (
            Interval(np.array((half - doubt, half + doubt)).reshape(2, -1))
            for half, doubt in zip(halves, doubts, strict=True)
        )
        y = _beside(*(cells.h + half for half in around))
        return _ranges(2, cells, THROUGHOUT, y, _beside(cells.h_A, cells.h_A))


def omega_by_share(model: Model, F_0: float, at: Samples, some: Bools, *, fold: bool) -> tuple[Floats, Floats]:
    """Omega of folds, or of peaks, by I and what R is of it there, without h, which may be all rounding; and -R/I.

    0 where that is too much, and beside `some`.
    """
    found, shares = np.zeros(at.A.shape), np.zeros(at.A.shape)
    which = np.flatnonzero(some)
    w = np.zeros(which.size)
    for _ in range(MOST_SHARES):
        A, last = at.A[which], w
        w = inertia.Omega_of_share(A, F_0, model.m, model.zeta, shares[which])
        if fold:
            share = inertia.fold_slopes(w, A, model.m, model.zeta, at.k[which])[2]
        else:
            share = inertia.peak_share(w, A, model.m, model.zeta)
        shares[which] = share
        settled, stays = np.abs(w - last) <= 2.0**-52 * w, np.abs(share) <= LARGEST_SHARE
        found[which[settled & stays]] = w[settled & stays]
        which, w = which[~settled & stays], w[~settled & stays]
        if not which.size:
            break
    return found, shares


class _Inertia(Asked):
    """Of an excitation by inertia: at x = 1/Omega where the level of an amplitude is least, if there is one.

    Next to A = 0, below the least amplitude that is looked at, the force is its slope: there nothing vanishes.
    """

    channels = 1

    def _exists(self, at: Samples) -> tuple[Bools, Floats]:
        fall, linear, rest = inertia.terms(at.A, self.model.m, self.model.zeta, at.h)
        exists = (at.A > 0) & (fall > 0)
        return exists, np.where(exists, inertia.least(np.where(exists, fall, 1.0), linear, rest), 1.0)

    def _lost(self, at: Samples, exists: Bools) -> Bools:
        """Where h lacks of being 0 what damping makes of it, so that x is all rounding."""
        fall, _, _ = inertia.terms(at.A, self.model.m, self.model.zeta, at.h)
        return np.asarray(exists & (fall <= SOFT * at.A * (np.abs(at.h) + at.A * np.abs(at.h_A))))

    def _Omega_A(self, x: Floats, at: Samples) -> Floats:
        """What a rounding of A does to 1/x."""
        return np.asarray(inertia.least_Omega_A(x, at.A, self.model.m, self.model.zeta, at.h, at.h_A))

    def _where(self, cells: Cells) -> tuple[np.ndarray[Any, np.dtype[np.int_]], Interval]:
        """x rises with fall and falls with the others, so the corners hold it."""
        fall, linear, rest = inertia_intervals.terms(cells.A, *self.damping(cells), cells.h)
        where = np.where(cells.A.lo > 0, _where_positive(fall), NOWHERE)
        lo = np.where(fall.lo > 0, inertia.least(fall.lo, linear.hi, rest.hi), 0.0)
        return where, Interval.of(lo * (1 - DOUBT), inertia.least(fall.hi, linear.lo, rest.lo) * (1 + DOUBT))


class InertiaPeak(_Inertia):
    """At an amplitude of the excitation: the least level of A less that."""

    def __init__(self, model: Model, F_0: float) -> None:
        super().__init__(model)
        self.F_0 = F_0

    def ask(self, at: Samples) -> Channels:
        exists, x = self._exists(at)
        y, dy = inertia.peak(x, at.A, self.F_0, self.model.m, self.model.zeta, at.h, at.h_A)
        by_share = omega_by_share(self.model, self.F_0, at, self._lost(at, exists), fold=False)[0]
        Omega = np.where(by_share > 0, by_share, 1 / x)
        moves = np.where(by_share > 0, 0.0, self._Omega_A(x, at))
        # where the channel ends, as Omega tends to inf, the level is the amplitude
        edge = np.where(at.A > self.F_0, 1.0, -1.0) * (self.model.zeta > 0)
        return _channels(1, at, exists, y, dy, Omega, moves, 0.0, edge)

    def range(self, cells: Cells) -> Ranges:
        where, x = self._where(cells)
        F_0 = Interval.point(self.F_0)
        y, dy = inertia_intervals.peak(x, cells.A, F_0, *self.damping(cells), cells.h, cells.h_A)
        return _ranges(1, cells, where, y, dy)


class InertiaIsola(_Inertia):
    """A function with the sign of F_A, which rises where the channel ends, as Omega tends to inf."""

    def ask(self, at: Samples) -> Channels:
        exists, x = self._exists(at)
        m, zeta = self.model.m, self.model.zeta
        _, dy = inertia.isola(x, at.A, m, zeta, at.h, at.h_A, at.h_AA)
        y = inertia.isola_apart(x, at.A, m, zeta, at.h, at.k, 2 * at.h + at.k)
        lost = self._lost(at, exists)
        Omega = self._Omega(at, lost, x)
        moves = np.where(lost, 0.0, self._Omega_A(x, at))
        return _channels(1, at, exists, y, dy, Omega, moves, 0.0, float(zeta > 0))

    def _Omega(self, at: Samples, lost: Bools, x: Floats) -> Floats:
        """1/x, or, where that is lost, what h on the fold locus lacks the least of making the level stationary at."""
        m, zeta, Omega = self.model.m, self.model.zeta, 1 / x
        if lost.any():
            A, h = at.A[lost], at.h[lost]
            roots, count = fold_roots(A, h, at.h_A[lost], m, zeta)
            A, h = A[:, np.newaxis], h[:, np.newaxis]
            lacks = np.abs(inertia.level_slope(roots, A, m, zeta, h) / slow_flow.R(roots, A, h))
            lacks = np.where(roots > 0, lacks, np.inf)
            found = np.take_along_axis(roots, np.nanargmin(lacks, axis=-1)[:, np.newaxis], axis=-1)[:, 0]
            Omega[lost] = np.where(count > 0, found, Omega[lost])
        return Omega

    def range(self, cells: Cells) -> Ranges:
        where, x = self._where(cells)
        y, dy = inertia_intervals.isola(x, cells.A, *self.damping(cells), cells.h, cells.h_A, cells.h_AA)
        cubic = self._cubic(cells)
        # where there is a least level
        most = np.minimum(cells.h.hi, -2 * self.model.zeta**2 * cells.A.lo * (1 - DOUBT))
        h = Interval.of(cells.h.lo, most)
        y = y.both(inertia_intervals.isola_apart(x, cells.A, *self.damping(cells), h, cells.k, cubic))
        # A F_A is 0 beside a zero of h, which doubles may not tell from it, where zeta A^2 + m A x = cubic zeta A x^2 +
        # k m x^3, which one x is; and as h rises to where the least level ends, x falls to 0
        once = cells.h_A.has_sign & (-h.lo <= BESIDE * np.minimum(cells.k.lo, cubic.lo))
        return _ranges(1, cells, where, y, dy, 0, once)

    def _cubic(self, cells: Cells) -> Interval:
        """3 h - A h_A, which is 2 h + k, on cells; also from where their pieces begin.

        Far out, where h is like A^3, it is a small difference of large terms there, and its second derivative
        h_AA - A h_AAA is small on all of the way.
        """
        direct, first = 2.0 * cells.h + cells.k, cells.first
        if self.model.mechanism.enclosed is not None:
            return direct
        way = cells.A - Interval.of(first.A, first.A)
        bend = Interval.of(np.minimum(first.h_AAA, cells.h_AAA.lo), np.maximum(first.h_AAA, cells.h_AAA.hi))
        h, h_A, h_AA = (
            doubtful(f, first.A, slope)
            for f, slope in ((first.h, first.h_A), (first.h_A, first.h_AA), (first.h_AA, first.h_AAA))
        )
        k = doubtful(first.k, first.A, first.A * first.h_AA)
        at = Interval.of(first.A, first.A)
        slope, bend = 2.0 * h_A - at * h_AA, h_AA - at * bend + way * (bend - bend)
        cubic = 2.0 * h + k + way * (slope + 0.5 * (way * bend))
        known = np.isfinite(cubic.hi - cubic.lo)
        return direct.both(cubic).where(known, direct)
