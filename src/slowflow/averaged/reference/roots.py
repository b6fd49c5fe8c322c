"""Positive frequencies at a given amplitude: in go A, h, h_A, m, zeta, F_0, out come sorted Omega and their number.

=================  =========================================  ==========  ==================
function           equation                                   paper       roots
=================  =========================================  ==========  ==================
`response_roots`   F = R^2 + (I - F_0)(I + F_0) = 0           (24)        0, 1, 2 or 3
`fold_roots`       F_A/2 = R (w^2 + h_A) + 2 zeta w I = 0     (30)        0, 1, 2 or 3
`peak_roots`       F_Omega/(4 A) = w R + zeta I = 0           (34)        0, 1 or 2
=================  =========================================  ==========  ==================

with R = A w^2 + h and I = 2 zeta A w + m; everything is dimensionless.

They run compiled (native/roots.h) where that is built, on NumPy otherwise; what follows holds for both.

Method.  Both quartics are depressed, with a positive leading and a non-negative linear coefficient, and their
derivative is k (A w^3 + p w + q), q >= 0.  So there are at most two positive critical points, a maximum w1 and then a
minimum w2.  The signs at 0, w1 and w2 give the number of roots; between these points the quartic is monotone.  Each
root is found by Halley steps kept in their bracket, on the unexpanded form, and corrected by Newton with a residual in
double-double.  A sign that rounding could have decided is found again in double-double.

Conventions, the same as in native/roots.h:

- roots are counted with multiplicity: a curve that touches zero gives its double root twice, as two equal numbers
  (three for a triple root), so that branches keep their partner up to the point where they meet;
- "touches" means that the value at the critical point is zero to within the error of double-double, 2^-98 of its terms;
- a root at w = 0 is not positive and is not counted;
- unused places are NaN;
- the domain is A > 0, m >= 0, zeta >= 0, F_0 >= 0, all finite; outside it the count is -1 and all places are NaN.

The error of a root is at most u (1 + kappa), u = 2^-53, kappa the condition number of the root in the arguments.  For
that, squares of the arguments must not overflow and the square of F_0 must stay above 1e-290; h_A may have any finite
size.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from slowflow.backend import SOLVER
from slowflow_kernels import frequencies, slow_flow_zeta0
from slowflow_kernels.conventions import (
    BY_RISE,
    CORRECTED,
    CORRECTING,
    MAY_MEET,
    NEAR_ROOT,
    NEARING,
    POLISHED,
    POLISHING,
    SIMPLE,
)
from slowflow_support.broadcast import common_shape, floats

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]
Counts = NDArray[np.int32]
Ints = NDArray[np.intp]

ROUGH: float = frequencies.ROUGH  # a value below this part of its terms has no certain sign in double
FINE: float = frequencies.FINE  # the same in double-double
CHUNK = 8192  # elements solved together: the work arrays stay in the cache, and memory is bounded


# ==== The formulas, as they are generated, for either quartic.  Everything below this block is a solver that knows only
# these. ==============================================================================================================


def taken(value: Any, which: Any) -> Any:
    """Some elements of an array; a number is the same for all of them."""
    return value[which] if isinstance(value, np.ndarray) else value


class _Quartic:
    """Parameters, and the coefficients of the derivative k (A w^3 + p w + q); p and q are double-double.

    A, p and p_low are arrays (n,), all others too, or numbers, whose arithmetic takes a tenth of the time.

    other -- F_0 of the response, h_A of the fold
    """

    def __init__(
        self, A: Floats, h: Any, m: Any, zeta: Any, other: Any, k: Any, p: Floats, p_low: Floats, q: Any, q_low: Any
    ) -> None:
        self.A, self.h, self.m, self.zeta, self.other = A, h, m, zeta, other
        self.k, self.p, self.p_low, self.q, self.q_low = k, p, p_low, q, q_low

    def take(self, which: Ints | Bools) -> Self:
        return type(self)(*[taken(value, which) for value in vars(self).values()])

    def value(self, w: Floats) -> tuple[Floats, Floats]:
        """The quartic in double, and a size; the error is below ROUGH * size."""
        raise NotImplementedError

    def value_fine(self, w: Floats) -> Floats:
        """The quartic in double-double, rounded to double."""
        raise NotImplementedError

    def value_beside(self, w: Floats, tail: Floats) -> tuple[Floats, Floats]:
        """The same at w + tail, a correction below the last place of w, and a size; the error is below FINE * size."""
        raise NotImplementedError

    def exactly_at_0(self) -> Floats:
        """The quartic at 0 with a certain sign."""
        raise NotImplementedError

    def value_at_0(self) -> Floats:
        """The same in double, where it is certain."""
        return self.exactly_at_0()

    def cubic(self, w: Floats) -> Floats:
        """A w^3 + p w + q."""
        return _floats(frequencies.cubic(w, self.A, self.p, self.q))

    def cubic_slope(self, w: Floats) -> Floats:
        """Its slope."""
        return _floats(frequencies.cubic_slope(w, self.A, self.p))

    def cubic_fine(self, w: Floats) -> Floats:
        """The cubic in double-double, rounded to double."""
        return _floats(frequencies.cubic_fine(w, self.A, self.p, self.p_low, self.q, self.q_low))

    def rise(self, w: Floats) -> tuple[Floats, Floats]:
        """From 0 to a critical point, whose terms may be far smaller than those of the value; and its terms' size."""
        rise, size = frequencies.rise(w, self.A, self.p, self.k)
        return rise, size

    def gap(self) -> Floats:
        """1 - rho^2 = (4 |p|^3 - 27 A q^2) / (4 |p|^3) in double-double, for p < 0; 0 where only rounding is left."""
        value, first = frequencies.discriminant(self.A, self.p, self.p_low, self.q, self.q_low)
        return np.where(np.abs(value) <= FINE * first, 0.0, value / first)


class _Response(_Quartic):
    """F."""

    @classmethod
    def of(cls, A: Floats, h: Any, m: Any, zeta: Any, F_0: Any) -> Self:
        p, p_low, q, q_low, k = frequencies.response_derivative(A, m, zeta, h)
        return cls(A, h, m, zeta, F_0, k, p, p_low, q, q_low)

    def value(self, w: Floats) -> tuple[Floats, Floats]:
        value, size = frequencies.response(w, self.A, self.other, self.m, self.zeta, self.h)
        return value, size

    def value_fine(self, w: Floats) -> Floats:
        return _floats(frequencies.response_fine(w, self.A, self.other, self.m, self.zeta, self.h)[0])

    def value_beside(self, w: Floats, tail: Floats) -> tuple[Floats, Floats]:
        value, size = frequencies.response_beside(w, tail, self.A, self.other, self.m, self.zeta, self.h)
        return value, size

    def exactly_at_0(self) -> Floats:
        return _floats(frequencies.response_exactly_at_0(self.other, self.m, self.h))

    def value_at_0(self) -> Floats:
        value, size = frequencies.response_at_0(self.other, self.m, self.h)
        unsure = np.flatnonzero(np.abs(value) < ROUGH * size)
        if unsure.size:
            value[unsure] = self.take(unsure).exactly_at_0()
        return _floats(value)


class _Fold(_Quartic):
    """F_A/2."""

    @classmethod
    def of(cls, A: Floats, h: Any, h_A: Any, m: Any, zeta: Any) -> Self:
        p, p_low, q, q_low, k = frequencies.fold_derivative(A, m, zeta, h, h_A)
        return cls(A, h, m, zeta, h_A, k, p, p_low, q, q_low)

    def value(self, w: Floats) -> tuple[Floats, Floats]:
        value, size = frequencies.fold(w, self.A, self.m, self.zeta, self.h, self.other)
        return value, size

    def value_fine(self, w: Floats) -> Floats:
        return _floats(frequencies.fold_fine(w, self.A, self.m, self.zeta, self.h, self.other)[0])

    def value_beside(self, w: Floats, tail: Floats) -> tuple[Floats, Floats]:
        value, size = frequencies.fold_beside(w, tail, self.A, self.m, self.zeta, self.h, self.other)
        return value, size

    def exactly_at_0(self) -> Floats:
        return _floats(frequencies.fold_at_0(self.h, self.other))


def _floats(value: Any) -> Floats:
    """What a generated kernel returns, which is not typed."""
    result: Floats = value
    return result


# ==== The cubic A w^3 + p w + q, q >= 0 ===============================================================================


def _critical_points(s: _Quartic) -> tuple[Bools, Floats, Floats]:
    """Where the cubic vanishes on w >= 0 (twice, with multiplicity), and the two points.

    With y = w / sqrt(-p/3A) the cubic is y^3 - 3 y + 2 rho, whose roots are cos(b) ± sqrt(3) sin(b), 3 b = acos(rho).
    cos(b) is well conditioned on 0 <= rho <= 1, and sin(b) = sin(3b) / (4 cos(b)^2 - 1), so two Newton steps on
    4 c^3 - 3 c = rho take the place of the trigonometric functions.  The small root follows from Vieta.
    """
    falls = s.p < 0
    r = np.sqrt(np.where(falls, -s.p, 1.0) / (3 * s.A))
    rho = np.where(falls, 1.5 * s.q / (np.abs(s.p) * r), 2.0)
    gap = (1 - rho) * (1 + rho)
    unsure = np.flatnonzero(np.abs(rho - 1) <= MAY_MEET)
    if unsure.size:
        gap[unsure] = s.take(unsure).gap()
    exist = gap >= 0
    rho = np.minimum(rho, 1 + MAY_MEET)
    # cubic Hermite interpolation of c(rho) between c(0) = sqrt(3)/2, c' = 1/6 and c(1) = 1, c' = 1/9
    half_root_3 = np.sqrt(0.75)
    rise = 1 - half_root_3
    c = half_root_3 + rho * (1 / 6 + rho * ((3 * rise - 4 / 9) + rho * (5 / 18 - 2 * rise)))
    for _ in range(2):
        cc = c * c
        c = (8 * cc * c + rho) / (12 * cc - 3)
    y2 = c + np.sqrt(3 * np.maximum(gap, 0.0)) / (4 * c * c - 1)
    biquadratic = s.q == 0
    w1 = np.where(biquadratic, 0.0, r * rho / (y2 * c))
    w2 = np.where(biquadratic, np.sqrt(np.maximum(-s.p / s.A, 0.0)), r * y2)
    return exist, w1, w2


def _polish_cubic(s: _Quartic, w: Floats) -> Floats:
    """Newton with the double-double residual on simple roots of the cubic near w."""
    w = w.copy()
    t, x, active = s, w, np.arange(w.size)
    for _ in range(POLISHING if w.size else 0):
        slope = t.cubic_slope(x)
        step = t.cubic_fine(x) / slope
        # at a double root the slope is noise, and w is as good as it gets
        simple = np.abs(step) <= SIMPLE * x
        x = np.where(simple, x - step, x)
        w[active] = x
        left_over = (simple & (3 * t.A * x * step * step > POLISHED * x * np.abs(slope))).nonzero()[0]
        if not left_over.size:
            break
        t, x, active = t.take(left_over), x[left_over], active[left_over]
    return w


# ==== The quartic =====================================================================================================


def _critical_values(s: _Quartic, w: Floats, there: Bools) -> Floats:
    """The quartics at their critical points near w (2, n), where there are any, with a certain sign; elsewhere NaN.

    0 where only rounding is left.
    """
    value, size = s.value(w)
    value = np.where(there, value, np.nan)
    unsure = (np.abs(value) <= ROUGH * size).nonzero()
    if unsure[0].size:
        t, x = s.take(unsure[1]), w[unsure]
        tail = np.zeros_like(x)
        for last in (False, False, True):
            step = t.cubic_fine(x) / t.cubic_slope(x)
            # where maximum and minimum coincide the value does not depend on w in second order
            step = np.where(np.abs(step) <= SIMPLE * x, step, 0.0)
            if last:
                tail = -step
            else:
                x = x - step
        fine, size = t.value_beside(x, tail)
        start = t.exactly_at_0()
        rise, terms = t.rise(x)
        by_rise = np.abs(start + rise) > BY_RISE * (np.abs(start) + terms)
        value[unsure] = np.where(by_rise, start + rise, np.where(np.abs(fine) <= FINE * size, 0.0, fine))
    return value


def _refine(s: _Quartic, w: Floats, lo: Floats, hi: Floats, rising: Floats) -> Floats:
    """The roots between lo and hi, where the quartics are monotone and rise (+1) or fall (-1), from first guesses w."""
    state = np.array((np.where((w > lo) & (w < hi), w, 0.5 * (lo + hi)), lo, hi))
    t, (x, below, above), way, active = s, state, rising, np.arange(w.size)
    for _ in range(NEARING if w.size else 0):  # Halley in double, until the next error is below 2^-36 of that to a fold
        f, size = t.value(x)
        certain = np.abs(f) > ROUGH * size
        D = t.cubic_slope(x)
        C = t.cubic(x)
        left = f * way < 0
        below = np.where(certain & left, x, below)
        above = np.where(certain & ~left, x, above)
        following = x - 2 * f * C / (2 * t.k * C * C - f * D)
        following = np.where((following > below) & (following < above), following, 0.5 * (below + above))
        moved = np.abs(following - x)
        near = (moved * np.abs(D) <= NEAR_ROOT * np.abs(C)) & (moved <= NEAR_ROOT * following)
        left_over = (certain & ~near).nonzero()[0]
        state[:, active] = np.where(certain, following, x), below, above
        if not left_over.size:
            break
        t, way, active, (x, below, above) = (
            t.take(left_over),
            way[left_over],
            active[left_over],
            state[:, active[left_over]],
        )

    t, (x, below, above), way, active = s, state, rising, np.arange(w.size)
    for _ in range(
        CORRECTING if w.size else 0
    ):  # Newton with the double-double residual: once, but for nearly multiple roots
        f = t.value_fine(x)
        D = t.cubic_slope(x)
        C = t.cubic(x)
        step = f / (t.k * C)
        following = x - step
        done = (step * step * np.abs(D) <= CORRECTED * np.abs(C) * x) & (following >= below) & (following <= above)
        left = f * way < 0
        below = np.where(left, x, below)
        above = np.where(left, above, x)
        inside = (following > below) & (following < above)
        following = np.where(done | inside, following, 0.5 * (below + above))
        left_over = (~done & (following != x) & (below < above)).nonzero()[0]
        state[:, active] = following, below, above
        if not left_over.size:
            break
        t, way, active, (x, below, above) = (
            t.take(left_over),
            way[left_over],
            active[left_over],
            state[:, active[left_over]],
        )
    return np.asarray(state[0])


@dataclass(frozen=True)
class _Isolated:
    """Quartics with what tells where their roots lie: the values f0 at 0, f1 at the maximum w1, f2 at the minimum w2.

    Without critical points their values are NaN; where the quartic is biquadratic w1 is 0.
    """

    s: _Quartic
    exist: Bools
    w1: Floats
    w2: Floats
    f0: Floats
    f1: Floats
    f2: Floats

    @classmethod
    def of(cls, s: _Quartic) -> Self:
        f0 = s.value_at_0()
        exist, w1, w2 = _critical_points(s)
        inside = w1 > 0
        f1, f2 = _critical_values(s, np.array((w1, w2)), np.array((exist & inside, exist)))
        f1 = np.where(exist & ~inside, f0, f1)
        return cls(s, exist, w1, w2, f0, f1, f2)

    @cached_property
    def places(self) -> tuple[Ints, Counts]:
        """The places (4, n) of the roots that the signs show, by rising w, `NO_PLACE` behind the last; and how many.

        A pair that touches is not counted.
        """
        signs = 4 * (self.f0 < 0) + 2 * (self.f1 > 0) + (self.f2 < 0)
        case = np.where(self.exist, signs, 8 + signs)
        return _PLACES[:, case], _SHOWN[case]

    def roots(self, which: Ints, place: Ints) -> Floats:
        """The roots of the given elements at the given places: each by a first guess, refined between its bounds."""
        start, lo, hi = np.empty((3, which.size))
        for one, guess in enumerate((self._below, self._between, self._above, self._rising)):
            at = np.flatnonzero(place == one)
            if at.size:
                start[at], lo[at], hi[at] = guess(which[at])
        return _refine(self.s.take(which), start, lo, hi, np.where(place == BETWEEN, -1.0, 1.0))

    # In go elements, out come first guesses, and lower and upper bounds. Between 0 and the maximum the quartic is
    # concave: the tangent at 0 and the parabola at w1 end below the root. With v^2 = slope'(w2)/(2A),
    # d (v ± d/2) = ±S is exact for q = 0, and a close first guess otherwise. Where the quartic is biquadratic, w1 = 0,
    # the guess is the root but for rounding.

    def _below(self, which: Ints) -> tuple[Any, Any, Any]:
        s, w1 = self.s.take(which), self.w1[which]
        drop = _drop(s, w1, self.f1[which])
        return np.maximum(-self.f0[which] / (s.k * s.q), w1 - drop), 0.0, w1

    def _between(self, which: Ints) -> tuple[Any, Any, Any]:
        s, w1, w2, f1, f2 = self.s.take(which), self.w1[which], self.w2[which], self.f1[which], self.f2[which]
        vv, twice_S = _parabola(s, w2, f2)
        down = w2 - twice_S / (np.sqrt(vv) + np.sqrt(np.maximum(vv - twice_S, 0.0)))
        single = np.sqrt(4 * self.f0[which] / (s.k * s.A * (w2 * w2 + twice_S)))
        return np.where(w1 == 0, single, np.where(f1 < -f2, w1 + _drop(s, w1, f1), down)), w1, w2

    def _above(self, which: Ints) -> tuple[Any, Any, Any]:
        w2 = self.w2[which]
        vv, twice_S = _parabola(self.s.take(which), w2, self.f2[which])
        above = w2 + twice_S / (np.sqrt(vv) + np.sqrt(vv + twice_S))
        start = np.where(self.w1[which] == 0, np.sqrt(w2 * w2 + twice_S), above)
        return start, w2, 2 * start

    def _rising(self, which: Ints) -> tuple[Any, Any, Any]:
        """One root, below the biquadratic's and, for p >= 0, below the line's."""
        s = self.s.take(which)
        A, p, E = s.A, s.p, -self.f0[which] / s.k
        root = np.sqrt(p * p + 4 * A * E)
        high = np.sqrt(np.where(p > 0, 4 * E / (p + root), (root - p) / A))
        return np.where(p >= 0, np.minimum(high, E / s.q), high), 0.0, 2 * high


def _drop(s: _Quartic, w1: Floats, f1: Floats) -> Floats:
    """How far from the maximum its parabola ends."""
    return np.asarray(np.sqrt(2 * np.maximum(f1, 0.0) / (-s.k * s.cubic_slope(w1))))


def _parabola(s: _Quartic, w2: Floats, f2: Floats) -> tuple[Floats, Floats]:
    """v^2 and 2 S at the minimum."""
    vv = 0.5 * np.maximum(3 * w2 * w2 + s.p / s.A, 0.0)
    return vv, 2 * np.sqrt(np.maximum(-f2, 0.0) / (s.k * s.A))


#: where a root lies: below the maximum, between it and the minimum, above that, or where there are none; and, of a
#: curve's root that the signs don't show, the point that stands for it
BELOW, BETWEEN, ABOVE, RISING, AT_W1, AT_W2, AT_0, NO_PLACE = range(8)


def _shown(case: int) -> list[int]:
    """The places of the roots that signs show: 8 without critical points, 4 for f0 < 0, 2 for f1 > 0, 1 for f2 < 0."""
    none, low, hump, dip = case & 8, case & 4, case & 2, case & 1
    if none:
        return [RISING] if low else []
    there = (BELOW, low and hump), (BETWEEN, hump and dip), (ABOVE, dip)
    return [place for place, is_there in there if is_there]


_PLACES = np.array([(_shown(case) + [NO_PLACE] * 4)[:4] for case in range(16)], dtype=np.intp).T
_SHOWN = np.array([len(_shown(case)) for case in range(16)], dtype=np.int32)


def _quartic_roots(s: _Quartic) -> tuple[Floats, Counts]:
    """All positive roots of each quartic, shape (n, 3), and their number."""
    found = np.full((s.A.size, 3), np.nan)
    q = _Isolated.of(s)
    # where the quartic touches zero; NaN compares false
    at_maximum, at_minimum = (q.f1 == 0) & (q.w1 > 0), q.f2 == 0
    found[at_maximum, :2] = q.w1[at_maximum, None]
    found[at_minimum, 1:] = q.w2[at_minimum, None]
    place, _ = q.places
    number, which = np.nonzero(place < NO_PLACE)
    place = place[number, which]
    column = np.array([0, 1, 2, 0])[place]
    found[which, column] = q.roots(which, place)
    found.sort(axis=-1)
    return found, np.sum(found > 0, axis=-1, dtype=np.int32)


# ==== Public ==========================================================================================================


def _response(A: Floats, h: Any, m: Any, zeta: Any, F_0: Any) -> tuple[Floats, Counts]:
    found, count = np.full((A.size, 3), np.nan), np.zeros(A.size, np.int32)
    moves = np.flatnonzero(np.full(A.size, F_0 >= m))  # otherwise I >= m > F_0: the mass sticks
    if moves.size:
        of = (taken(value, moves) for value in (A, h, m, zeta, F_0))
        found[moves], count[moves] = _quartic_roots(_Response.of(*of))
    return found, count


def _fold(A: Floats, h: Floats, h_A: Floats, m: Any, zeta: Any) -> tuple[Floats, Counts]:
    found = np.full((A.size, 3), np.nan)
    two_factors = np.full(A.size, zeta == 0)  # the backbone, and one in h_A alone
    i = np.flatnonzero(two_factors)
    if i.size:
        found[i, 0] = slow_flow_zeta0.backbone(A[i], np.where(h[i] < 0, h[i], np.nan))
        found[i, 1] = slow_flow_zeta0.undamped_Omega(np.where(h_A[i] < 0, h_A[i], np.nan))
    i = np.flatnonzero(~two_factors)
    if i.size:
        A, h, h_A, m, zeta = (taken(value, i) for value in (A, h, h_A, m, zeta))
        # beside a corner h_A is huge: measure w there in units of sqrt|h_A|, lest w^4 overflow
        huge = np.abs(h_A) > 2.0**100
        if huge.any():
            e = np.where(huge, np.frexp(h_A)[1] // 4, 0)
            scaled = (np.ldexp(A, 2 * e), np.ldexp(h, -2 * e), np.ldexp(h_A, -4 * e), np.ldexp(m, -2 * e))
            found[i] = _quartic_roots(_Fold.of(*scaled, np.ldexp(zeta, -2 * e)))[0] * np.ldexp(1.0, 2 * e)[:, None]
        else:
            found[i] = _quartic_roots(_Fold.of(A, h, h_A, m, zeta))[0]
    found.sort(axis=-1)
    return found, np.sum(found > 0, axis=-1, dtype=np.int32)


def _peak(A: Floats, h: Any, m: Any, zeta: Any) -> tuple[Floats, Counts]:
    found = np.full((A.size, 2), np.nan)
    s = _Response.of(A, h, m, zeta, 0.0)
    exist, w1, w2 = _critical_points(s)
    which, place = np.array((exist & (w1 > 0), exist)).T.nonzero()
    found[which, place] = _polish_cubic(s.take(which), np.array((w1, w2))[place, which])
    found.sort(axis=-1)
    return found, np.sum(found > 0, axis=-1, dtype=np.int32)


class Quartics:
    """The response quartics at F_0, or for F_0 < 0 the fold quartics, at amplitudes: arrays A, h, h_A of one length.

    Along a curve the number of roots is known from both sides. Where rounding hides a pair that is about to meet, or
    shows one that has met already, the known number decides, and the place where the pair meets stands for the root.
    """

    def __init__(self, A: Floats, h: Floats, h_A: Floats, m: float, zeta: float, F_0: Any) -> None:
        of_folds = np.any(np.less(F_0, 0))
        self._isolated = _Isolated.of(_Fold.of(A, h, h_A, m, zeta) if of_folds else _Response.of(A, h, m, zeta, F_0))

    @property
    def exist(self) -> Bools:
        """Whether there are critical points."""
        return self._isolated.exist

    @property
    def critical(self) -> tuple[tuple[Floats, Floats], tuple[Floats, Floats]]:
        """Where the maximum and the minimum over Omega lie, and the values there, with a certain sign."""
        q = self._isolated
        return (q.w1, q.f1), (q.w2, q.f2)

    def count(self) -> Counts:
        """How many roots the signs show; a pair that touches is not counted."""
        return self._isolated.places[1]

    def roots(self, count: Ints, index: Ints) -> Floats:
        """Root number `index` of `count`, also where the signs count otherwise."""
        q = self._isolated
        place = self._place(count, index)
        proper = np.flatnonzero(place <= RISING)
        if proper.size == place.size:
            return q.roots(proper, place)
        Omega = np.where(place == AT_W1, q.w1, np.where((place == AT_W2) & q.exist, q.w2, 0.0))
        if proper.size:
            Omega[proper] = q.roots(proper, place[proper])
        return Omega

    def _place(self, count: Ints, index: Ints) -> Ints:
        places, shown = self._isolated.places
        place = np.where(index < count, _picked(places, index), AT_W2)
        others = np.flatnonzero(shown != count)
        if others.size:
            place[others] = self._place_by_count(others, count[others], index[others])
        return place

    def _place_by_count(self, which: Ints, count: Any, index: Any) -> Ints:
        """The places where the signs of these elements count otherwise."""
        q = self._isolated
        places, shown = q.places[0][:, which], q.places[1][which]
        exist, f0, f1, f2 = (part[which] for part in (q.exist, q.f0, q.f1, q.f2))

        def at(number: Any) -> Any:
            return _picked(places, number)

        # a pair that is about to meet: where maximum and minimum are about to as well, all three roots are
        lower = np.where(index < 2, AT_W1, at(index - 2))
        upper = np.where(index < count - 2, at(index), AT_W2)
        hidden = np.where(exist, np.where(f1 > 0, upper, lower), np.where(f0 < 0, RISING, AT_0))
        # of two too many the pair that is nearest to nothing does not count
        surplus = at(np.where(np.abs(f1) < np.abs(f2), index + 2, index))
        chosen: Ints = np.select(
            [shown == count - 1, shown == count + 1, shown == count - 2, shown == count + 2],
            [
                np.where(index == 0, AT_0, at(index - 1)),  # the lowest has gone to 0
                at(index + 1),  # one has come from 0
                hidden,
                surplus,
            ],
            np.where(shown > 0, at(shown.astype(np.intp) - 1), AT_0),
        )
        return chosen


def _picked(places: Ints, number: Any) -> Ints:
    """Of each element the place with its number."""
    picked: Ints = places[np.clip(number, 0, 3), np.arange(places.shape[1])]
    return picked


def critical_points(A: Floats, p: Floats, q: Any) -> tuple[Bools, Floats, Floats]:
    """Where A w^3 + p w + q, q >= 0, vanishes on w >= 0, and the two points; A and p of one length."""
    return _critical_points(_Quartic(A, 0.0, 0.0, 0.0, 0.0, 0.0, p, np.zeros_like(p), q, 0.0))


def _broadcast(
    solve: Callable[..., tuple[Floats, Counts]], places: int, any_sign: tuple[int, ...], *parameters: ArrayLike
) -> tuple[Floats, Counts]:
    """Solve in chunks over the broadcast parameters; those outside the domain get the count -1.

    places, any_sign -- for how many roots, and which arguments may be negative
    """
    arrays = floats(*parameters)
    shape = common_shape(arrays)
    # what is one number stays one
    flat = [
        float(array) if array.ndim == 0 and number not in (0, *any_sign) else np.broadcast_to(array, shape).reshape(-1)
        for number, array in enumerate(arrays)
    ]
    n = math.prod(shape)
    valid = np.asarray(flat[0] > 0)
    for number, array in enumerate(flat):
        valid = valid & (np.abs(array) < np.inf if number in any_sign else (array >= 0) & (array < np.inf))
    found, count = np.full((n, places), np.nan), np.full(n, -1, np.int32)
    left = np.flatnonzero(valid)
    with np.errstate(all="ignore"):
        for first in range(0, left.size, CHUNK):
            i = left[first : first + CHUNK]
            found[i], count[i] = solve(*(taken(array, i) for array in flat))
    return found.reshape(*shape, places), count.reshape(shape)


#: the functions below on NumPy, whatever the backend
numpy_response_roots = partial(_broadcast, _response, 3, (1,))
numpy_fold_roots = partial(_broadcast, _fold, 3, (1, 2))
numpy_peak_roots = partial(_broadcast, _peak, 2, (1,))

_response_roots = numpy_response_roots if SOLVER is None else SOLVER.response_roots
_fold_roots = numpy_fold_roots if SOLVER is None else SOLVER.fold_roots
_peak_roots = numpy_peak_roots if SOLVER is None else SOLVER.peak_roots


def response_roots(A: ArrayLike, h: ArrayLike, m: ArrayLike, zeta: ArrayLike, F_0: ArrayLike) -> tuple[Floats, Counts]:
    """All Omega > 0 of the response curve F = 0, equation (24), at amplitude A under the forcing F_0.

    The arguments broadcast and are dimensionless: A the amplitude, h = H(A) - A the averaged restoring force,
    m = 4 mu/pi the averaged friction, zeta the damping ratio, F_0 the forcing.  Returns Omega, shape (..., 3), rising,
    padded with NaN, and the number of roots, shape (...), -1 outside the domain (see the module); nothing is raised but
    for arguments that do not broadcast.  With F_0 < m there is no root.
    """
    found: tuple[Floats, Counts] = _response_roots(A, h, m, zeta, F_0)
    return found


def fold_roots(A: ArrayLike, h: ArrayLike, h_A: ArrayLike, m: ArrayLike, zeta: ArrayLike) -> tuple[Floats, Counts]:
    """All Omega > 0 of the fold locus F_A = 0, equation (30), at amplitude A; the forcing there is sqrt(R^2 + I^2).

    h_A is the derivative of h, of either sign and any finite size.  Otherwise as in `response_roots`.
    """
    found: tuple[Floats, Counts] = _fold_roots(A, h, h_A, m, zeta)
    return found


def peak_roots(A: ArrayLike, h: ArrayLike, m: ArrayLike, zeta: ArrayLike) -> tuple[Floats, Counts]:
    """All Omega > 0 of the peak locus F_Omega = 0, in (34), at amplitude A; the forcing there is sqrt(R^2 + I^2).

    Returns Omega, shape (..., 2), and the number of roots; otherwise as in `response_roots`.
    """
    found: tuple[Floats, Counts] = _peak_roots(A, h, m, zeta)
    return found
