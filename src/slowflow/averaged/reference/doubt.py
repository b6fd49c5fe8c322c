"""Where rounding may decide a number of folds or states: in go values on doubles, out come flags.

As in native/decide.h, but nothing decides instead: an answer that is in doubt says that it is undecided.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from slowflow.averaged.reference.cells import Samples
from slowflow.averaged.reference.excited import frequencies_abreast, stationary_abreast
from slowflow.averaged.reference.minima import cusp_bend
from slowflow.averaged.reference.roots import Ints, taken
from slowflow.intervals import Bools
from slowflow.model import Floats, Model
from slowflow_kernels import slow_flow
from slowflow_kernels.conventions import CLOSE, STEEP, TOLD_APART

#: a share of a frequency or amplitude, relatively, that is too much to be lost
FEW_DIGITS = 2.0**-30


def size_at(at: Samples, F_0: Any) -> Floats:
    """What a force, or its average, may be as large as; a stiffness of 1 is that of the vertical spring."""
    return np.asarray(F_0 + np.abs(at.h) + at.A * (1 + np.abs(at.h_A)))


def is_fold_close(model: Model, F_0: Any, least: Any, at: Samples, y: Floats, Omega: Floats) -> Bools:
    """Whether the function whose zeros are folds is as near to 0 as rounding may bring it.

    Two of its zeros that are about to meet, or have met, lead the search there.
    """
    size = size_at(at, F_0)
    if model.undamped:
        size = size**2
    else:
        share = least / at.k
        left = np.maximum((1 - share) * (1 + share), CLOSE)
        size = size + Omega * slow_flow.I(Omega, at.A, model.m, model.zeta) / (model.zeta * left)
    return np.asarray(np.isfinite(at.h_A) & (np.abs(y) <= CLOSE * size))


def is_F_close(model: Model, F_0: Any, Omega: Floats, A: Floats) -> Bools:
    """Whether F = R^2 + I^2 - F_0^2 is as near to 0 as rounding may bring it."""
    F_0 = model.force(F_0, Omega)
    h, h_A = model.averaged(A)[:2]
    m, zeta = model.alike(Omega, A)
    R, sine = slow_flow.R(Omega, A, h), slow_flow.I(Omega, A, m, zeta)
    of_R = CLOSE * (np.abs(h) + A * (1 + np.abs(h_A)) + A * Omega**2)
    doubt = of_R * (2 * np.abs(R) + of_R) + CLOSE * (sine**2 + F_0 * F_0)
    return np.asarray(np.abs(slow_flow.F(Omega, A, F_0, m, zeta, h)) <= doubt)


def have_few_digits(model: Model, F_0: Any, Omega: Floats, A: Floats) -> Bools:
    """Which folds of a force move by more than 2^-30 where F does not vanish by itself, or by 4 roundings of its terms.

    F_A is 0 there: Omega moves by F/F_Omega, and A by what F_A changes with that, over F_AA. As next to Omega = 0, and
    to a cusp. Native solvers ask that of a step in double-double.
    """
    m, zeta = model.m, model.zeta
    h, h_A, h_AA, _ = model.averaged(A)
    R, sine = slow_flow.R(Omega, A, h), slow_flow.I(Omega, A, m, zeta)
    of_R = 4 * np.finfo(float).eps * (np.abs(h) + A * (1 + np.abs(h_A)) + A * Omega**2)
    lost = of_R * (2 * np.abs(R) + of_R) + 4 * np.finfo(float).eps * (sine**2 + F_0 * F_0)
    lost += np.abs(slow_flow.F(Omega, A, F_0, m, zeta, h))
    moved = np.abs(lost / slow_flow.F_Omega(Omega, A, m, zeta, h))
    turned = np.abs(slow_flow.F_AOmega(Omega, A, m, zeta, h, h_A) * moved)
    turned /= np.abs(slow_flow.F_AA(Omega, A, m, zeta, h, h_A, h_AA))
    return np.asarray((moved > FEW_DIGITS * Omega) | (turned > FEW_DIGITS * A))


def have_cusps_few_digits(model: Model, Omega: Floats, A: Floats) -> Bools:
    """Which cusps move in Omega by more than 2^-30 when A moves by a unit in its last place, as next to a singularity.

    Along the fold locus Omega turns there: it moves by half F_AAA/F_AOmega times the square of that. Not told of an
    excitation by inertia, and without viscous damping.
    """
    if model.inertial or model.undamped:
        return np.zeros(A.shape, dtype=bool)
    h, h_A = model.averaged(A)[:2]
    slopes = slow_flow.F_AOmega(Omega, A, model.m, model.zeta, h, h_A)
    F_AAA = cusp_bend(model, Omega, A) * A / (slopes * slow_flow.F_Omega(Omega, A, model.m, model.zeta, h))
    return np.asarray(np.abs(F_AAA / slopes) * np.spacing(A) ** 2 > 2 * FEW_DIGITS * Omega)


def are_corners_close(model: Model, F_0: Any, A_max: Any) -> Bools:
    """Of which of designs abreast rounding may decide the folds on a breakpoint, or between it and the next double."""
    close = np.zeros(model.abreast, dtype=bool)
    for i, (b, jump) in enumerate(zip(model.breakpoints, model.jumps, strict=True)):
        # a jump that is 0 by rounding is none only if the force has none
        if np.any(jump) or model.mechanism.truncated:
            of = np.flatnonzero(np.broadcast_to(b < A_max, close.shape))
            close[_close_corners(model, F_0, i, of)] = True
    return close


def _close_corners(model: Model, F_0: Any, i: int, of: Ints) -> Ints:
    """Which of some designs abreast have such folds on breakpoint i."""
    if not of.size:
        return of
    A, jump = np.broadcast_to(taken(model.breakpoints[i], of), of.shape), taken(model.jumps[i], of)
    found = of[np.abs(jump) <= CLOSE * A * (1 + np.abs(model.take(of).averaged(A)[1]))]
    still, at = stationary_abreast(model, A, of)
    still, at = np.concatenate((still, of)), np.append(at, 0.0 * of)
    b = taken(model.breakpoints[i], still)
    touch = still[is_F_close(model.take(still), taken(F_0, still), at, np.broadcast_to(b, at.shape))]
    which, Omega = frequencies_abreast(model, A, F_0, of)
    which, Omega = which[np.isfinite(Omega)], Omega[np.isfinite(Omega)]
    own, b, jump = model.take(which), taken(model.breakpoints[i], which), taken(model.jumps[i], which)
    h, h_A = own.averaged(b)[:2]
    R, slope = np.abs(slow_flow.R(Omega, b, h)), b * np.abs(own.F_A(Omega, b)) / 2
    size = own.force(taken(F_0, which), Omega) + np.abs(h) + b * (1 + np.abs(h_A))
    close = (R <= CLOSE * size) | (slope <= CLOSE * (size * size)) | (R * np.abs(jump) * STEEP <= slope)
    return np.concatenate((found, touch, which[close]))


def nearly_sticks(model: Model, F_0: Any) -> Bools:
    """Whether rounding may decide if F_0 exceeds the forcing that leaves the mass at rest."""
    return np.asarray((np.abs(F_0 - model.m) <= CLOSE * model.m) & (not model.inertial))


def is_at_fold(model: Model, F_0: float, Omega: Floats, at: Floats, A: Floats) -> Bools:
    """Which frequencies are those of a fold (at, A) to within what rounding may make of F there."""
    near = np.abs(at - Omega[:, np.newaxis]) <= TOLD_APART * np.maximum(at, Omega[:, np.newaxis])
    which, fold = np.nonzero(near)
    close = np.zeros(Omega.size, dtype=bool)
    close[which[is_F_close(model, F_0, Omega[which], A[fold])]] = True
    return close
