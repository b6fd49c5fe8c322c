"""Saddle-node bifurcations at a forcing: in goes a model, out come its folds.

Folds at F_0 are zeros of a function that is explicit in A (see along); for an excitation by inertia they lie where the
level along the fold locus passes F_0, by other laws of damping they are looked for in boxes. And corners: at a
breakpoint b of a force that jumps there, or beyond which nothing rubs, F_A changes sign between b and the next
amplitude above, without passing zero.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from slowflow.averaged import words
from slowflow.averaged.reference import dissipated, doubt
from slowflow.averaged.reference.along import FoldAt, omega_by_share
from slowflow.averaged.reference.arcs import Arc, Graph, Roots
from slowflow.averaged.reference.bounds import amplitude_bound
from slowflow.averaged.reference.boxes import points_of
from slowflow.averaged.reference.cells import Samples, samples_at, stretches_up_to
from slowflow.averaged.reference.excited import frequencies_abreast, frequencies_at
from slowflow.averaged.reference.locus import Stations, of_locus
from slowflow.averaged.reference.roots import Ints, fold_roots, response_roots, taken
from slowflow.averaged.reference.search import GIVEN_UP, Zeros, find_zeros_abreast
from slowflow.intervals import Bools
from slowflow.model import THROUGHOUT, Floats, Model
from slowflow.results import SaddleNodes
from slowflow_kernels import slow_flow
from slowflow_kernels.conventions import CLOSE, NEAR_END
from slowflow_support.errors import NotSettled

#: by how much more than I the terms of R may be, as a share of I, or if squares of roundings are to count: as in
#: native/locus.h
FEW_LOST, SQUARE_LOST = 4.0, 2.0**24
#: F_A at a fold is less, as a share of its terms: far more than rounding leaves, far less than beside a fold
OF_A_FOLD = 2.0**-20
#: what of an amplitude is left out next to rest, as a share
NEXT_TO_REST = 2.0**-200


def saddle_nodes(model: Model, F_0: float) -> SaddleNodes:
    """Every fold at F_0 > m, in every regime, by rising Omega, of one Omega by rising A, of one A the corner first."""
    return folds_up_to(model, F_0, *amplitude_bound(model, F_0))


def folds_up_to(model: Model, F_0: float, A_max: float, remark: str) -> SaddleNodes:
    """The same, up to the amplitude that `amplitude_bound` gives, with its remark."""
    found = folds_abreast(model, F_0, A_max)
    if found.given_up.any():
        raise NotSettled(GIVEN_UP)
    return _told(model, F_0, found, remark)


def _told(model: Model, F_0: float, found: Folds, remark: str) -> SaddleNodes:
    """The answer of one design."""
    undecided = bool(found.undecided.any())
    message, cut = words.of_folds(model, F_0, found.A.size > 0 or undecided, remark)
    kind = np.where(found.up, "jump-up", "jump-down")
    codes = words.beside(undecided, cut)
    found_as = {"Omega": found.Omega, "A": found.A, "kind": kind, "corner": found.corner}
    return SaddleNodes._made(**found_as, F_0=F_0, message=message, remarks=codes, _model=model)


@dataclass(frozen=True, eq=False)
class Folds:
    """Folds of designs abreast, of each by rising Omega, of one Omega by rising A, of one A the corner first.

    of        -- of which of the designs
    up        -- whether a sweep that leaves it goes up
    undecided -- of each design, whether doubles tell how many there are, and where
    given_up  -- of each, whether the search was given up, and what is found is no answer
    """

    of: Ints
    Omega: Floats
    A: Floats
    up: Bools
    corner: Bools
    undecided: Bools
    given_up: Bools

    def take(self, which: Any, designs: Any) -> Folds:
        """Some folds, of some designs."""
        of, Omega, A = self.of[which], self.Omega[which], self.A[which]
        up, corner = self.up[which], self.corner[which]
        return Folds(of, Omega, A, up, corner, self.undecided[designs], self.given_up[designs])


@np.errstate(all="ignore")
def folds_abreast(model: Model, F_0: Any, A_max: Any) -> Folds:
    """Every fold at F_0 up to A_max, numbers or arrays of each of designs abreast."""
    found_by = _points if model.laws.any else _crossings if model.inertial else _zeros
    of, A, Omega, undecided, given_up = found_by(model, F_0, A_max)
    own = model.take(of)
    # Leaving a fold, a sweep goes the way of the saddle: up where the stable branch lies below it in amplitude.
    up = own.F_AA(Omega, A) < 0
    if not (model.laws.any or model.inertial):
        undecided[of[doubt.have_few_digits(own, taken(F_0, of), Omega, A)]] = True
    undecided |= doubt.nearly_sticks(model, F_0) | doubt.are_corners_close(model, F_0, A_max)
    corners = _on_corners(model, F_0, A_max)
    of, Omega, A, up = (np.concatenate(both) for both in zip((of, Omega, A, up), corners, strict=True))
    corner = np.arange(A.size) >= A.size - corners[0].size
    order = np.lexsort((~corner, A, Omega, of))
    return Folds(of[order], Omega[order], A[order], up[order], corner[order], undecided, given_up)


#: of the folds inside of pieces: of which design each is, A and Omega; of each design whether there may be others, and
#: whether the search was given up
Inside = tuple[Ints, Floats, Floats, Bools, Bools]


def _of_one(A: Floats, Omega: Floats, undecided: bool) -> Inside:
    return np.zeros(A.size, np.intp), A, Omega, np.array([undecided]), np.array([False])


def _points(model: Model, F_0: float, A_max: float) -> Inside:
    """For other laws of damping."""
    system = "folds_by_inertia" if model.inertial else "folds"
    found = points_of(model, system, stretches_up_to(model, A_max), F_0)
    return _of_one(found.A, found.Omega, found.undecided)


def _zeros(model: Model, F_0: Any, A_max: Any) -> Inside:
    """For a force."""
    (found,), given_up = find_zeros_abreast(model, [FoldAt(model, F_0)], stretches_up_to(model, A_max))
    return found.of, found.A, _settled(model, F_0, found), found.undecided, given_up


def _crossings(model: Model, F_0: float, A_max: float) -> Inside:
    """For an excitation by inertia: where the level along the arcs of the fold locus, monotone, passes F_0."""
    from scipy.optimize import brentq  # here, not above: folds at a force do without SciPy

    locus, stations = Roots(model, -1.0), Stations.of(model, A_max)
    found, near = [], stations.undecided

    def at(A: float, count: int, index: int) -> float:
        (Omega,) = locus.at(np.array([A]), np.array([count]), np.array([index]))
        return float(Omega)

    def level_at(Omega: float, A: float) -> float:
        return float(of_locus(model, np.array([Omega]), np.array([A]))[0])

    for arc in Graph.of(locus, stations.events()).arcs:
        low, high = arc.A
        if low == 0 and model.preload > 0:  # with A the level tends to 0 as Omega tends to inf, and Omega is not known
            low = high * NEXT_TO_REST
            arc = replace(arc, A=[low, high], Omega=[at(low, arc.count, arc.index), arc.Omega[1]])
        places = zip(arc.A, arc.Omega, strict=True)
        ends = [level_at(Omega, A) if Omega > 0 or A == 0 else np.inf for A, Omega in places]
        near |= any(abs(level - F_0) <= CLOSE * F_0 for level in ends)
        if (ends[0] < F_0) == (ends[1] < F_0):
            continue

        def excess(A: float, arc: Arc = arc, ends: list[float] = ends) -> float:
            there = ends[arc.A.index(A)] if A in arc.A else level_at(at(A, arc.count, arc.index), A)
            return min(there, 2 * F_0 + 1.0) - F_0

        root = float(brentq(excess, *arc.A, xtol=4e-323, rtol=4 * np.finfo(float).eps, maxiter=1000))
        Omega = arc.Omega[arc.A.index(root)] if root in arc.A else at(root, arc.count, arc.index)
        # from F = 0, where at a fold it does not depend on A to first order
        of_response = frequencies_at(model, root, F_0)
        found.append((root, min(of_response, key=lambda one: abs(one - Omega), default=Omega)))
    As, Omegas = np.array(found).reshape(-1, 2).T
    return _of_one(As, _sharp(model, F_0, As, Omegas) if model.zeta > 0 else Omegas, near)


def _sharp(model: Model, F_0: float, A: Floats, Omega: Floats) -> Floats:
    """Omega where damping is so weak that what rounding leaves of R takes folds off the response.

    By I and F_A = 0, if h is that of the amplitude but for roundings.
    """
    at = samples_at(model, A)
    w, share = omega_by_share(model, F_0, at, np.ones(A.size, dtype=bool), fold=True)
    I, size = model.force(F_0, w), at.size_of_R(w)
    loss = size / I
    sharp = (w > 0) & ((np.abs(share) * loss > FEW_LOST) | (loss > SQUARE_LOST))
    sharp &= np.abs(slow_flow.R(w, at.A, at.h) + share * I) <= CLOSE * size
    return np.where(sharp, w, Omega)


def _settled(model: Model, F_0: Any, found: Zeros) -> Floats:
    """Omega from F = 0, where at a fold it does not depend on A to first order: the root next to the one by I or R.

    Where damping is next to none neither has digits, and that root may be no fold: then the one at which F_A is.
    """
    A, Omega, own, at = found.A, found.Omega, model.take(found.of), samples_at(model, found.A, found.of)
    roots, count = response_roots(A, at.h, own.m, own.zeta, taken(F_0, found.of))
    # beyond the tip of the curve by rounding: Omega from F_A = 0 after all
    beyond = np.flatnonzero(count <= 0)
    if beyond.size:
        damping = taken(own.m, beyond), taken(own.zeta, beyond)
        roots[beyond] = fold_roots(A[beyond], at.h[beyond], at.h_A[beyond], *damping)[0]
    distance = np.where(np.isnan(roots), np.inf, np.abs(roots - Omega[:, np.newaxis]))
    share = np.array([_share_of_F_A(own, at, column) for column in roots.T]).T
    share[np.isnan(share)] = np.inf
    place = distance.argmin(axis=-1)
    is_fold = np.take_along_axis(share, place[:, np.newaxis], axis=-1)[:, 0] <= OF_A_FOLD
    place = np.where(is_fold, place, share.argmin(axis=-1))
    nearest = np.take_along_axis(roots, place[:, np.newaxis], axis=-1)[:, 0]
    return np.where(np.isfinite(nearest), nearest, Omega)


def _share_of_F_A(own: Model, at: Samples, Omega: Floats) -> Floats:
    """F_A as a share of what its terms may be: at a fold that is small."""
    R, S = np.abs(slow_flow.R(Omega, at.A, at.h)), np.abs(Omega**2 + at.h_A)
    lag = 2 * own.zeta * Omega * slow_flow.I(Omega, at.A, own.m, own.zeta)
    size = lag + R * (Omega**2 + np.abs(at.h_A)) + S * at.size_of_R(Omega)
    F_A = slow_flow.F_A(Omega, at.A, own.m, own.zeta, at.h, at.h_A)
    return np.asarray(np.abs(F_A) / (2 * size))


def _on_corners(model: Model, F_0: Any, A_max: Any) -> tuple[Ints, Floats, Floats, Bools]:
    """Folds on a breakpoint where the force jumps by J: next to it F_A = 2 R h_A + ... has the sign of R J.

    Of which of the designs abreast, Omega, A, and whether the stable side lies below.
    """
    found: list[tuple[Ints, Floats, Floats, Bools]] = []
    for i, (b, jump) in enumerate(zip(model.breakpoints, model.jumps, strict=True)):
        leaves = i == 0 and model.laws.rubs != THROUGHOUT
        of = np.flatnonzero(np.broadcast_to(b < A_max, (model.abreast,)))
        if (not np.any(jump) and not leaves) or not of.size:
            continue
        of, Omega = frequencies_abreast(model, np.broadcast_to(taken(b, of), of.shape), F_0, of)
        of, Omega = of[np.isfinite(Omega)], Omega[np.isfinite(Omega)]
        below = _is_stable_below(model, F_0, i, Omega, of)
        changes = below != dissipated.is_stable_above(model, i, Omega, of)
        A = np.broadcast_to(taken(b, of), of.shape)
        found.append((of[changes], Omega[changes], A[changes], below[changes]))
    if not found:
        return np.empty(0, np.intp), np.empty(0), np.empty(0), np.empty(0, dtype=bool)
    of, Omega, A, up = (np.concatenate(column) for column in zip(*found, strict=True))
    return of, Omega, A, up


def _is_stable_below(model: Model, F_0: Any, i: int, Omega: Floats, of: Ints) -> Bools:
    """Whether the side below breakpoint i is stable at states on it, of which of the designs abreast: F_A > 0.

    Where the state is, to rounding, the end of the fold locus below, the sign of `Fold` there decides, which decided
    whether that has a zero next to b. To first order F and F_A are multiples of it, and F_A at the state is less
    by F_AOmega F/F_Omega; without viscous damping it is F, and F_A is 0.
    """
    own, b = model.take(of), np.broadcast_to(taken(model.breakpoints[i], of), of.shape)
    if model.inertial or model.laws.any:
        return own.F_A(Omega, b) > 0
    m, zeta, at = own.m, own.zeta, samples_at(model, b, of)
    fold = FoldAt(model, F_0).ask(at)
    R = slow_flow.R(Omega, b, at.h)
    F, F_A = (np.ones_like(R), np.zeros_like(R)) if model.undamped else slow_flow.fold_moves(b, at.k, R)
    turn = slow_flow.F_AOmega(Omega, b, m, zeta, at.h, at.h_A) / slow_flow.F_Omega(Omega, b, m, zeta, at.h)
    ends = fold.exists[0] & (np.abs(fold.Omega[0] - Omega) < NEAR_END * Omega)
    stable = np.where(ends, fold.y[0] * (F_A - turn * F), slow_flow.F_A(Omega, b, m, zeta, at.h, at.h_A))
    return np.asarray(stable > 0)
