"""Saddle-node bifurcations at a forcing: in goes a model, out come its folds.

Folds at F_0 are zeros of a function that is explicit in A (see along); for an excitation by inertia they lie where the
level along the fold locus passes F_0, by other laws of damping they are looked for in boxes. And corners: at a
breakpoint b of a force that jumps there, or beyond which nothing rubs, F_A changes sign between b and the next
amplitude above, without passing zero.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from slowflow.averaged import words
from slowflow.averaged.reference import dissipated, doubt
from slowflow.averaged.reference.along import FoldAt, omega_by_share
from slowflow.averaged.reference.arcs import Arc, Graph, Roots
from slowflow.averaged.reference.bounds import amplitude_bound
from slowflow.averaged.reference.boxes import points_of
from slowflow.averaged.reference.cells import Samples, samples_at, stretches_up_to
from slowflow.averaged.reference.excited import frequencies_at
from slowflow.averaged.reference.intervals import Bools
from slowflow.averaged.reference.locus import Stations, of_locus
from slowflow.averaged.reference.roots import fold_roots, response_roots
from slowflow.averaged.reference.search import find_zeros
from slowflow.model import THROUGHOUT, Floats, Model
from slowflow.results import SaddleNodes
from slowflow_kernels import slow_flow
from slowflow_kernels.conventions import CLOSE, NEAR_END

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
    found_by = _points if model.laws.any else _crossings if model.inertial else _zeros
    with np.errstate(all="ignore"):
        A, Omega, near = found_by(model, F_0, A_max)
        # Leaving a fold, a sweep goes the way of the saddle: up where the stable branch lies below it in amplitude.
        up = model.F_AA(Omega, A) < 0
        corner_Omega, corner_A, corner_up = _on_corners(model, F_0, A_max)
        if not (model.laws.any or model.inertial):
            near = near or bool(doubt.have_few_digits(model, F_0, Omega, A).any())
        undecided = near or doubt.nearly_sticks(model, F_0) or doubt.are_corners_close(model, F_0, A_max)
    Omega, A = np.concatenate((Omega, corner_Omega)), np.concatenate((A, corner_A))
    up = np.concatenate((up, corner_up))
    corner = np.arange(A.size) >= A.size - corner_A.size
    order = np.lexsort((~corner, A, Omega))
    message, cut = words.of_folds(model, F_0, A.size > 0 or undecided, remark)
    kind = np.where(up, "jump-up", "jump-down")[order]
    codes = words.beside(undecided, cut)
    return SaddleNodes(Omega[order], A[order], kind, corner[order], F_0, message, model, remarks=codes)


def _points(model: Model, F_0: float, A_max: float) -> tuple[Floats, Floats, bool]:
    """A and Omega of the folds inside of pieces, and whether there may be others; for other laws of damping."""
    system = "folds_by_inertia" if model.inertial else "folds"
    found = points_of(model, system, stretches_up_to(model, A_max), F_0)
    return found.A, found.Omega, found.undecided


def _zeros(model: Model, F_0: float, A_max: float) -> tuple[Floats, Floats, bool]:
    """A and Omega of the folds inside of pieces, and whether there may be others; for a force."""
    (found,) = find_zeros(model, [FoldAt(model, F_0)], stretches_up_to(model, A_max))
    return found.A, _settled(model, F_0, found.A, found.Omega), found.undecided


def _crossings(model: Model, F_0: float, A_max: float) -> tuple[Floats, Floats, bool]:
    """The same for an excitation by inertia: where the level along the arcs of the fold locus, monotone, passes F_0."""
    from scipy.optimize import brentq  # here, not above: folds at a force do without SciPy

    locus, stations = Roots(model, -1.0), Stations.of(model, A_max)
    found, near = [], stations.undecided

    def at(A: float, count: int, index: int) -> float:
        (Omega,) = locus.at(np.array([A]), np.array([count]), np.array([index]))
        return float(Omega)

    def level_at(Omega: float, A: float) -> float:
        return float(of_locus(model, np.array([Omega]), np.array([A]))[0])

    for arc in Graph(locus, stations.events()).arcs:
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
    return As, _sharp(model, F_0, As, Omegas) if model.zeta > 0 else Omegas, near


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


def _settled(model: Model, F_0: float, A: Floats, Omega: Floats) -> Floats:
    """Omega from F = 0, where at a fold it does not depend on A to first order: the root next to the one by I or R.

    Where damping is next to none neither has digits, and that root may be no fold: then the one at which F_A is.
    """
    at = samples_at(model, A)
    roots, count = response_roots(A, at.h, model.m, model.zeta, F_0)
    # beyond the tip of the curve by rounding: Omega from F_A = 0 after all
    beyond = np.flatnonzero(count <= 0)
    if beyond.size:
        roots[beyond] = fold_roots(A[beyond], at.h[beyond], at.h_A[beyond], model.m, model.zeta)[0]
    distance = np.where(np.isnan(roots), np.inf, np.abs(roots - Omega[:, np.newaxis]))
    share = np.array([_share_of_F_A(model, at, column) for column in roots.T]).T
    share[np.isnan(share)] = np.inf
    place = distance.argmin(axis=-1)
    is_fold = np.take_along_axis(share, place[:, np.newaxis], axis=-1)[:, 0] <= OF_A_FOLD
    place = np.where(is_fold, place, share.argmin(axis=-1))
    nearest = np.take_along_axis(roots, place[:, np.newaxis], axis=-1)[:, 0]
    return np.where(np.isfinite(nearest), nearest, Omega)


def _share_of_F_A(model: Model, at: Samples, Omega: Floats) -> Floats:
    """F_A as a share of what its terms may be: at a fold that is small."""
    R, S = np.abs(slow_flow.R(Omega, at.A, at.h)), np.abs(Omega**2 + at.h_A)
    lag = 2 * model.zeta * Omega * slow_flow.I(Omega, at.A, model.m, model.zeta)
    size = lag + R * (Omega**2 + np.abs(at.h_A)) + S * at.size_of_R(Omega)
    F_A = slow_flow.F_A(Omega, at.A, model.m, model.zeta, at.h, at.h_A)
    return np.asarray(np.abs(F_A) / (2 * size))


def _on_corners(model: Model, F_0: float, A_max: float) -> tuple[Floats, Floats, Bools]:
    """Folds on a breakpoint where the force jumps by J: next to it F_A = 2 R h_A + ... has the sign of R J.

    Omega, A, and whether the stable side lies below.
    """
    Omegas, As, ups = [np.empty(0)], [np.empty(0)], [np.empty(0, dtype=bool)]
    for i, (b, jump) in enumerate(zip(model.breakpoints, model.jumps, strict=True)):
        leaves = i == 0 and model.laws.rubs != THROUGHOUT
        if (jump == 0 and not leaves) or not b < A_max:
            continue
        Omega = frequencies_at(model, b, F_0)
        Omega = Omega[np.isfinite(Omega)]
        below = _is_stable_below(model, F_0, b, Omega)
        above = dissipated.is_stable_above(model, i, Omega)
        changes = below != above
        Omegas.append(Omega[changes])
        As.append(np.full(int(changes.sum()), b))
        ups.append(below[changes])
    return np.concatenate(Omegas), np.concatenate(As), np.concatenate(ups)


def _is_stable_below(model: Model, F_0: float, b: float, Omega: Floats) -> Bools:
    """Whether the side below breakpoint b is stable at the states (b, Omega): F_A > 0.

    Where the state is, to rounding, the end of the fold locus below, the sign of `Fold` there decides, which decided
    whether that has a zero next to b. To first order F and F_A are multiples of it, and F_A at the state is less
    by F_AOmega F/F_Omega; without viscous damping it is F, and F_A is 0.
    """
    m, zeta, at = model.m, model.zeta, samples_at(model, b)
    if model.inertial or model.laws.any:
        return model.F_A(Omega, b) > 0
    fold = FoldAt(model, F_0).ask(at).take(0)
    (h,), (h_A,), (k,) = at.h, at.h_A, at.k
    R = slow_flow.R(Omega, b, h)
    F, F_A = slow_flow.fold_moves(b, k, R) if zeta > 0 else (np.ones_like(R), np.zeros_like(R))
    turn = slow_flow.F_AOmega(Omega, b, m, zeta, h, h_A) / slow_flow.F_Omega(Omega, b, m, zeta, h)
    ends = fold.exists & (np.abs(fold.Omega - Omega) < NEAR_END * Omega)
    return np.asarray(np.where(ends, fold.y * (F_A - turn * F), slow_flow.F_A(Omega, b, m, zeta, h, h_A)) > 0)
