"""Saddle-node bifurcations at a forcing: in goes a model, out come its folds.

Folds at F_0 are zeros of a function that is explicit in A (see along), and corners: at a breakpoint b of a force that
jumps there, F_A changes sign between b and the next amplitude above, without passing zero.
"""

from __future__ import annotations

import numpy as np

from slowflow.averaged import words
from slowflow.averaged.reference import doubt
from slowflow.averaged.reference.along import FoldAt
from slowflow.averaged.reference.bounds import amplitude_bound
from slowflow.averaged.reference.cells import samples_at, stretches_up_to
from slowflow.averaged.reference.intervals import Bools
from slowflow.averaged.reference.roots import fold_roots, response_roots
from slowflow.averaged.reference.search import find_zeros
from slowflow.model import Floats, Model
from slowflow.results import Remark, SaddleNodes
from slowflow_kernels import slow_flow
from slowflow_kernels.conventions import NEAR_END


#: what is said where there is no answer
def saddle_nodes(model: Model, F_0: float) -> SaddleNodes:
    """Every fold at F_0 > m, in every regime, by rising Omega."""
    A_max, remark = amplitude_bound(model, F_0)
    (found,) = find_zeros(model, [FoldAt(model, F_0)], stretches_up_to(model, A_max))
    with np.errstate(all="ignore"):
        A, Omega = found.A, _settled(model, F_0, found.A, found.Omega)
        h, h_A, h_AA, _ = model.averaged(A)
        # Leaving a fold, a sweep goes the way of the saddle: up where the stable branch lies below it in amplitude.
        up = np.asarray(model.flow.F_AA(Omega, A, model.m, model.zeta, h, h_A, h_AA)) < 0
        corner_Omega, corner_A, corner_up = _on_corners(model, F_0, A_max)
        undecided = found.undecided or doubt.nearly_sticks(model, F_0) or doubt.are_corners_close(model, F_0, A_max)
    Omega, A = np.concatenate((Omega, corner_Omega)), np.concatenate((A, corner_A))
    up = np.concatenate((up, corner_up))
    corner = np.arange(A.size) >= A.size - corner_A.size
    order = np.argsort(Omega, kind="stable")
    message = remark if A.size or undecided else words.NO_FOLD.format(F_0)
    kind = np.where(up, "jump-up", "jump-down")[order]
    beside = Remark.UNDECIDED if undecided else Remark(0)
    return SaddleNodes(Omega[order], A[order], kind, corner[order], F_0, message, model, remarks=beside)


def _settled(model: Model, F_0: float, A: Floats, Omega: Floats) -> Floats:
    """Omega from F = 0, where at a fold it does not depend on A to first order: the root next to the one by I."""
    h, h_A = model.averaged(A)[:2]
    roots, count = response_roots(A, h, model.m, model.zeta, F_0)
    # beyond the tip of the curve by rounding: Omega from F_A = 0 after all
    roots = np.where((count > 0)[:, np.newaxis], roots, fold_roots(A, h, h_A, model.m, model.zeta)[0])
    distance = np.where(np.isnan(roots), np.inf, np.abs(roots - Omega[:, np.newaxis]))
    nearest = np.take_along_axis(roots, distance.argmin(axis=-1)[:, np.newaxis], axis=-1)[:, 0]
    return np.where(np.isfinite(nearest), nearest, Omega)


def _on_corners(model: Model, F_0: float, A_max: float) -> tuple[Floats, Floats, Bools]:
    """Folds on a breakpoint where the force jumps by J: next to it F_A = 2 R h_A + ... has the sign of R J.

    Omega, A, and whether the stable side lies below.
    """
    Omegas, As, ups = [np.empty(0)], [np.empty(0)], [np.empty(0, dtype=bool)]
    for b, jump in zip(model.breakpoints, model.jumps, strict=True):
        if jump == 0 or not b < A_max:
            continue
        A, h = np.array([b]), model.averaged(np.array([b]))[0]
        roots, count = response_roots(A, h, model.m, model.zeta, F_0)
        Omega = roots[0, : count[0]]
        below, above = _is_stable_below(model, F_0, b, Omega), slow_flow.R(Omega, b, h) * jump > 0
        changes = below != above
        Omegas.append(Omega[changes])
        As.append(np.full(int(changes.sum()), b))
        ups.append(below[changes])
    return np.concatenate(Omegas), np.concatenate(As), np.concatenate(ups)


def _is_stable_below(model: Model, F_0: float, b: float, Omega: Floats) -> Bools:
    """Whether the side below breakpoint b is stable at the states (b, Omega): F_A > 0.

    Where the state is, to rounding, the end of the fold locus below, the sign of `Fold` there decides, which decided
    whether that has a zero next to b. With y it, F = 2 R y and F_A = (2/A) (2 R - k) y to first order, and F_A at the
    state is less by F_AOmega F/F_Omega; without viscous damping F = y and F_A = 0.
    """
    m, zeta, at = model.m, model.zeta, samples_at(model, b)
    (fold,) = FoldAt(model, F_0).ask(at)
    (h,), (h_A,), (k,) = at.h, at.h_A, at.k
    R = slow_flow.R(Omega, b, h)
    F, F_A = (2 * R, 2 * (2 * R - k) / b) if zeta > 0 else (np.ones_like(R), np.zeros_like(R))
    turn = slow_flow.F_AOmega(Omega, b, m, zeta, h, h_A) / slow_flow.F_Omega(Omega, b, m, zeta, h)
    ends = fold.exists & (np.abs(fold.Omega - Omega) < NEAR_END * Omega)
    return np.asarray(np.where(ends, fold.y * (F_A - turn * F), slow_flow.F_A(Omega, b, m, zeta, h, h_A)) > 0)
