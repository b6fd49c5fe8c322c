"""Other laws of damping: in go a model and a forcing, out come frequencies at an amplitude, bounds.

With I = I_0(A) + 2 zeta A Omega + d (A Omega)^2, F and F_A/2 are quartics in Omega whose coefficients of Omega, Omega^3
and Omega^4 are not negative (derivations/dissipation.py): they have at most two positive critical points, a maximum w1
and then a minimum w2, and are monotone between. Where their number changes along the amplitude `dissipated_points` has.

Under an excitation by inertia F has -F_0^2 Omega^4 in the place of -F_0^2: over Omega^4 it is such a quartic in
x = 1/Omega, with the same coefficients the other way round. Its root that comes from x = 0, Omega = inf, is there below
the amplitude that the response tends to. F_A is the same.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from slowflow.averaged.reference.arcs import Event, Ints, Kind
from slowflow.averaged.reference.cells import cells_of, samples_at
from slowflow.averaged.reference.enclosed import enclosed
from slowflow.averaged.reference.inertia import intervals_beyond
from slowflow.averaged.reference.roots import taken
from slowflow.model import THROUGHOUT, Floats, Model
from slowflow_kernels import dissipation, slow_flow
from slowflow_kernels.conventions import ENDLESS

Bools = NDArray[np.bool_]

#: of Newton's and bisecting steps
STEPS = 200
#: below it F_0^4 and what is its rounding are not told apart from 0
LEAST_F_0 = 2.0**-240


@dataclass(frozen=True)
class Roots:
    """The frequencies along the amplitude: of the response at F_0, or for F_0 < 0 of the fold locus."""

    model: Model
    F_0: float

    def take(self, of: Ints) -> Roots:
        """These: of one design."""
        return self

    def count(self, A: Floats) -> Ints:
        """How many there are at each amplitude."""
        return np.asarray(Quartics(self.model, self.F_0, A).shown.sum(axis=0), dtype=np.intp)

    def at(self, A: Floats, count: Ints, index: Ints) -> Floats:
        """Number `index` of `count` at each amplitude; where rounding hides a pair, the place where it meets."""
        return Quartics(self.model, self.F_0, A).roots(count, index)

    def lower_pair(self, event: Event) -> tuple[bool, float]:
        """Whether the lower pair of roots meets at an event, and where."""
        if event.kind in (Kind.PAIR_LOW, Kind.PAIR_HIGH):
            return event.kind == Kind.PAIR_LOW, event.Omega
        one = Quartics(self.model, self.F_0, np.array([event.A]))
        first = bool(one.w1[0] > 0 and abs(one.f1[0]) < abs(one.f2[0]))
        w = float(one.w1[0] if first else one.w2[0])
        return (not first, 1 / w) if one.by_x else (first, w)


class Damped(Protocol):
    """What a quartic takes of an oscillator: as `Model` has it."""

    @property
    def zeta(self) -> float: ...

    @property
    def d(self) -> float: ...

    @property
    def inertial(self) -> bool: ...

    def averaged(self, A: Any) -> tuple[Any, ...]: ...

    def at_rest(self, A: Any, beyond: Any = None) -> tuple[Any, ...]: ...

    def F_A(self, Omega: Any, A: Any, beyond: Any = None) -> Any: ...


class Quartics:
    """The quartic of each amplitude: its coefficients c, its critical points w1 <= w2 or NaN, its values there.

    beyond -- as in `Model.at_rest`
    by_x   -- whether it is one in 1/Omega: w is 1/Omega then
    """

    def __init__(self, model: Damped, F_0: float, A: Floats, beyond: bool | None = None) -> None:
        self.model, self.F_0, self.A, self.beyond = model, F_0, A, beyond
        h, h_A, *_ = (value + np.zeros_like(A) for value in model.averaged(A))
        I_0, I_0A, *_ = model.at_rest(A, beyond)
        damping = model.zeta, model.d
        if F_0 < 0:
            coefficients = dissipation.fold_quartic(A, I_0, I_0A, *damping, h, h_A)
        else:
            coefficients = dissipation.response_quartic(A, I_0, *damping, h)
        self.c = [np.asarray(one + np.zeros_like(A)) for one in coefficients]
        self.by_x = model.inertial and F_0 >= 0
        if self.by_x:
            self.c = self.c[::-1]
        self.w1, self.w2 = _critical(self.c)
        self.f0, self.f1, self.f2 = (self.value(w) for w in (np.zeros_like(A), self.w1, self.w2))

    def value(self, w: Floats) -> Floats:
        """F, or F_A/2, from R and I, in which nothing cancels but what cancels in F."""
        if self.F_0 < 0:
            return np.asarray(0.5 * self.model.F_A(w, self.A, self.beyond))
        model, I_0 = self.model, self.model.at_rest(self.A)[0]
        if self.by_x:
            known = (self.A, self.F_0, I_0, model.zeta, model.d, model.averaged(self.A)[0])
            return np.asarray(dissipation.far_by_inertia(w, *known)[0])
        return np.asarray(dissipation.F(w, self.A, self.F_0, I_0, model.zeta, model.d, model.averaged(self.A)[0]))

    @property
    def shown(self) -> Bools:
        """Which of the three intervals between 0, w1, w2 and inf hold a root."""
        exist = np.isfinite(self.w2)
        below = np.where(exist, (self.f0 < 0) & (self.f1 > 0), False)
        between = exist & (self.f1 > 0) & (self.f2 < 0)
        return np.array((below, between, np.where(exist, self.f2 < 0, self.f0 < 0)))

    def roots(self, count: Ints, index: Ints) -> Floats:
        """See `Roots.at`."""
        if self.by_x:
            return np.asarray(1 / self._roots(count, count - 1 - index))
        return self._roots(count, index)

    def _roots(self, count: Ints, index: Ints) -> Floats:
        """By rising w."""
        shown = self.shown
        missing = count - shown.sum(axis=0)
        # next to where a pair meets rounding may hide or show it: at the critical point whose value is next to 0
        lower = (np.abs(self.f1) < np.abs(self.f2)) & (self.w1 > 0)
        there = shown.copy()
        for pair in (missing >= 2, missing <= -2):
            for place, own in ((0, lower), (1, True), (2, ~lower)):
                there[place] = np.where(pair & own, missing > 0, there[place])
        # and where one ends at Omega = 0, the lowest
        odd = missing % 2 == 1
        rank = np.cumsum(there, axis=0) - 1
        there &= ~(odd & (missing < 0) & (rank == 0))
        wanted = index - np.where(odd & (missing > 0), 1, 0)
        rank = np.cumsum(there, axis=0) - 1
        place = np.argmax(there & (rank == np.maximum(wanted, 0)), axis=0)
        exist = np.isfinite(self.w2)
        low = np.where(exist, np.choose(place, (np.zeros_like(self.w1), self.w1, self.w2)), 0.0)
        high = np.where(exist, np.choose(place, (self.w1, self.w2, np.full_like(self.w2, np.inf))), np.inf)
        found = self._solved(low, np.where(np.isinf(high), self._above(), high), place == 1)
        meets = np.where(lower, self.w1, self.w2)
        is_shown = np.take_along_axis(shown, place[np.newaxis], axis=0)[0]
        return np.asarray(np.where(wanted < 0, 0.0, np.where(is_shown, found, meets)))

    def _above(self) -> Floats:
        """Above the largest root: where the quartic without its odd powers, which only raise it, vanishes."""
        c = self.c
        root = np.sqrt(np.maximum(c[2] ** 2 - 4 * c[4] * self.f0, 0.0))
        with np.errstate(divide="ignore", invalid="ignore"):  # within a play c[4] is 0
            square = np.where(c[2] > 0, -2 * self.f0 / (c[2] + root), (root - c[2]) / (2 * c[4]))
        return np.asarray(np.sqrt(np.maximum(square, 0.0)) * (1 + 2.0**-20) + 1e-300)

    def _solved(self, low: Floats, high: Floats, falls: Bools) -> Floats:
        """Newton's steps, kept in the brackets."""
        c, lo, hi = self.c, low.copy(), high.copy()
        w = 0.5 * (lo + hi)
        for _ in range(STEPS):
            f = self.value(w)
            slope = c[1] + w * (2 * c[2] + w * (3 * c[3] + w * (4 * c[4])))
            left = (f < 0) != falls
            lo, hi = np.where(left, w, lo), np.where(left, hi, w)
            following = w - f / slope
            following = np.where((following > lo) & (following < hi), following, 0.5 * (lo + hi))
            done = np.abs(following - w) <= 2.0**-52 * w
            w = following
            if done.all():
                break
        return w


@np.errstate(divide="ignore", invalid="ignore")
def _critical(c: list[Floats]) -> tuple[Floats, Floats]:
    """Both positive zeros of the derivative, or NaN: it is convex, so Newton's steps from outside do not pass them."""
    least = -2 * c[2] / (1.5 * c[3] + np.sqrt(2.25 * c[3] ** 2 - 6 * c[4] * c[2])) / 2

    def derivative(w: Floats) -> Floats:
        return c[1] + w * (2 * c[2] + w * (3 * c[3] + w * (4 * c[4])))

    exist = (c[2] < 0) & (derivative(least) < 0)
    w1, w2 = np.zeros_like(least), np.sqrt(np.maximum(-c[2] / (2 * c[4]), 0.0))
    for _ in range(STEPS):
        moved = []
        for w in (w1, w2):
            step = derivative(w) / (2 * c[2] + w * (6 * c[3] + w * (12 * c[4])))
            moved.append(np.where(exist & np.isfinite(step), w - step, w))
        done = all((np.abs(new - w) <= 2.0**-51 * w).all() for new, w in zip(moved, (w1, w2), strict=True))
        w1, w2 = np.clip(moved[0], 0.0, least), np.maximum(moved[1], least)
        if done:
            break
    return np.where(exist, w1, np.nan), np.where(exist, w2, np.nan)


def is_in_range(model: Model, F_0: float, A_max: float) -> bool:
    """Whether doubles hold squares of coefficients of the quartics up to an amplitude, and (d F_0)^2; and F_0^4."""
    one = Quartics(model, F_0, np.array([A_max]))
    held = np.isfinite([*(c * c for c in one.c), [np.square(model.d * F_0)]]).all()
    return bool(held and F_0 >= LEAST_F_0)


def most_restoring(model: Model, F_0: float, rungs: Floats) -> tuple[Floats, float]:
    """What |h| is at most at a state of each amplitude, and an amplitude above all states that damping alone gives.

    The frequencies that damping leaves to a state fall as the amplitude rises. Either is inf where it is not known.
    """
    friction = model.m if model.laws.rubs == THROUGHOUT else 0.0
    most = np.full(rungs.shape, np.inf)
    if model.zeta > 0:
        most = np.minimum(most, slow_flow.most_restoring(rungs, F_0, friction, model.zeta))
    if model.d > 0:
        most = np.minimum(most, dissipation.restoring(rungs, F_0, model.d))
    # I is not less than its structural part
    return most, 2 * (F_0 - friction) / model.laws.eta if model.laws.eta > 0 else np.inf


def bound_by_inertia(model: Model, F_0: float, rungs: Floats) -> float | None:
    """The same under an excitation by inertia, by damping or as nothing pulls back; None where none is known.

    Where h >= 0 from an amplitude above F_0 on, as of a softening spring, R >= A Omega^2 exceeds F_0 Omega^2.
    """
    found = [np.inf]
    if model.d > 0:
        found.append(2 * float(dissipation.quadratic_bound(F_0, model.d)))
    eta = model.laws.eta
    if model.mechanism.enclosed is None:
        at, far = samples_at(model, rungs), samples_at(model, ENDLESS * np.maximum(rungs, 1.0))
        slope = cells_of(model, at, far, at).h_A
        holds = (rungs > F_0) & (at.h >= 0) & (slope.lo >= 0)
        if eta > 0:
            steepest = np.abs(slope.ends).max(axis=0)
            by_eta = dissipation.structural_bound(rungs, F_0, eta, at.h, steepest)
            holds |= np.all([one > 0 for one in by_eta], axis=0)
        found.append(float(rungs[np.argmax(holds)]) if holds.any() else np.inf)
    else:
        nodes = intervals_beyond(model, rungs)
        low = nodes[:-1]
        h, _ = enclosed(model, low, nodes[1:])
        excluded = (low > F_0) & (h.lo >= 0)
        if eta > 0:
            excluded |= dissipation.structural_bound(low, F_0, eta, np.abs(h.ends).max(axis=0), 0.0)[0] > 0
        beyond = low[np.logical_and.accumulate(excluded[::-1])[::-1]]
        found.append(float(np.min(rungs[np.isin(rungs, beyond)], initial=np.inf)))
    least = min(found)
    return least if least < np.inf else None


def stationary_at(model: Model, A: float, F_0: float = 0.0) -> Floats:
    """Every Omega > 0 at which the level of the amplitude is stationary, by its size."""
    one = Quartics(model, F_0, np.array([A]))
    found = np.concatenate((one.w1, one.w2))
    found = found[found > 0]
    return np.sort(1 / found) if one.by_x else np.asarray(found)


def frequencies_at(model: Model, A: float, F_0: float, beyond: bool | None = None) -> Floats:
    """Every Omega at which A is a steady state at F_0, or for F_0 < 0 on the fold locus, by its size.

    beyond -- as in `Model.at_rest`
    """
    one = Quartics(model, F_0, np.array([A]), beyond)
    n = int(one.shown.sum())
    many = Quartics(model, F_0, np.full(n, A), beyond)
    return many.roots(np.full(n, n), np.arange(n))


def is_stable_above(model: Model, i: int, Omega: Floats, of: Any = 0) -> Bools:
    """Whether the side above breakpoint i is stable at states on it: by the force's jump, or by what rubs no more.

    of -- of which of the designs abreast
    """
    b, jump = taken(model.breakpoints[i], of), taken(model.jumps[i], of)
    if np.any(model.jumps[i]):  # then each of the designs jumps
        return np.asarray(slow_flow.R(Omega, b, model.take(of).averaged(b)[0]) * jump > 0)
    return np.asarray(model.F_A(Omega, b, beyond=True) > 0)


def corner_frequencies(model: Model, i: int) -> Floats:
    """Frequencies of which one has the least level of all folds on breakpoint i.

    Folds sit on it where the sign of F_A changes across it: that begins and ends where F_A vanishes on one side, or R
    where the force jumps; between, the level may be stationary.
    """
    b, jump = model.breakpoints[i], model.jumps[i]
    found = [frequencies_at(model, b, -1.0), stationary_at(model, b)]
    if jump == 0:
        found.append(frequencies_at(model, b, -1.0, beyond=True))
    else:
        h = model.averaged(np.array([b]))[0]
        found.append(np.asarray(slow_flow.backbone(b, np.minimum(h, 0.0))))
    whole = np.concatenate(found)
    return np.asarray(whole[whole > 0])
