"""Saddle-node bifurcations: in goes a model, out come its folds at a forcing, their onset, and the detachment.

Folds at F_0 are level crossings of the fold locus, which is explicit in A (see derivations/along.py), and corners: at a
breakpoint b of a force that jumps there, F_A changes sign between b and the next amplitude above, without passing zero.
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from slowflow.averaged.reference.bounds import amplitude_bound, least_forcing
from slowflow.averaged.reference.minima import cusp_is_minimum, isola_is_minimum
from slowflow.averaged.reference.roots import fold_roots, peak_roots, response_roots
from slowflow.averaged.reference.spans import Spans, fold_locus, peak_locus, spans, static_locus
from slowflow.model import Floats, Model
from slowflow.results import Detachment, Peak, Remark, SaddleNodeOnset, SaddleNodes
from slowflow_kernels import slow_flow as general_flow
from slowflow_kernels.conventions import RAISE, RAISES

#: what is said where there is no answer
NO_FOLD = "no saddle node at F_0 = {:g}: the response is single-valued"
NO_LOWEST = "no lowest forcing: without viscous damping every F_0 > 4 mu/pi = {:g} has a fold"
NO_ONSET = "no saddle node"
AT_REST = "below it there are folds that end at Omega = 0, from F_0 = {:g} on"
NONE_BUT_AT_REST = "no saddle node is born: there are folds that end at Omega = 0, from F_0 = {:g} on"
NO_DETACHMENT = "no detachment: the force has one piece only"
NO_PEAK = "no peak: without viscous damping the response is unbounded"
NO_LOCUS = "no saddle node with an amplitude up to {:g}, whatever the forcing"
NO_CUSP = "no cusp of the fold locus with an amplitude up to {:g}"
NO_ISOLA = "no isola is born or merges with an amplitude up to {:g}"

#: Newton steps on F = F_A = 0 after the bracketed solution
POLISHING_STEPS = 3


def F_A(model: Model, Omega: Floats, A: Floats) -> Floats:
    """Derivative of F with respect to A; a steady state is stable where it is positive (30)."""
    h, h_A, _, _ = model.averaged(A)
    return np.asarray(model.flow.F_A(Omega, A, model.m, model.zeta, h, h_A))


def polish(model: Model, Omega: Floats, A: Floats, F_0: float) -> tuple[Floats, Floats]:
    """Newton steps on F = 0, F_A = 0 at each point, kept where they do not leave the neighbourhood."""
    flow, m, zeta = model.flow, model.m, model.zeta
    for _ in range(POLISHING_STEPS):
        h, h_A, h_AA, _ = model.averaged(A)
        F = flow.F(Omega, A, F_0, m, zeta, h)
        slope = flow.F_A(Omega, A, m, zeta, h, h_A)
        F_AA = flow.F_AA(Omega, A, m, zeta, h, h_A, h_AA)
        F_Omega = flow.F_Omega(Omega, A, m, zeta, h)
        F_AOmega = flow.F_AOmega(Omega, A, m, zeta, h, h_A)
        determinant = slope * F_AOmega - F_Omega * F_AA
        with np.errstate(divide="ignore", invalid="ignore"):
            step_A = (F_Omega * slope - F_AOmega * F) / determinant
            step_Omega = (F_AA * F - slope * slope) / determinant
        near = (np.abs(step_A) < 1e-6 * A) & (np.abs(step_Omega) < 1e-6 * Omega)
        A = np.where(near, A + np.where(near, step_A, 0.0), A)
        Omega = np.where(near, Omega + np.where(near, step_Omega, 0.0), Omega)
    # At a fold the curve's Omega does not depend on A to first order. The locus's does, steeply next to a breakpoint:
    # there A is known to its last place and F_A = 0 still leaves Omega open. F = 0 does not.
    roots, _ = response_roots(A, model.averaged(A)[0], m, zeta, F_0)
    distance = np.where(np.isnan(roots), np.inf, np.abs(roots - Omega[:, np.newaxis]))
    nearest = np.take_along_axis(roots, distance.argmin(axis=-1)[:, np.newaxis], axis=-1)[:, 0]
    return np.where(np.isfinite(nearest), nearest, Omega), A


def corner_folds(model: Model, F_0: float) -> tuple[Floats, Floats, np.ndarray]:
    """Folds that sit on a breakpoint: Omega, A, and whether the stable side lies below."""
    Omegas, As, ups = [], [], []
    for b, jump in zip(model.breakpoints, model.jumps, strict=True):
        if jump == 0:
            continue
        A = np.array([b])
        Omega, count = response_roots(A, model.averaged(A)[0], model.m, model.zeta, F_0)
        at = Omega[0, : count[0]]
        below = F_A(model, at, np.full_like(at, b))
        above = F_A(model, at, np.full_like(at, np.nextafter(b, np.inf)))
        changes = (below > 0) != (above > 0)
        Omegas.append(at[changes])
        As.append(np.full(int(changes.sum()), b))
        ups.append(below[changes] > 0)
    if not Omegas:
        return np.empty(0), np.empty(0), np.empty(0, dtype=bool)
    return np.concatenate(Omegas), np.concatenate(As), np.concatenate(ups)


def saddle_nodes(model: Model, F_0: float) -> SaddleNodes:
    """Every fold at F_0 > m, in every regime, by rising Omega."""
    A_max, remark = amplitude_bound(model, F_0)
    A, Omega = spans(fold_locus(model), A_max).crossings(F_0)
    Omega, A = polish(model, Omega, A, F_0)
    h, h_A, h_AA, _ = model.averaged(A)
    # Leaving a fold, a sweep goes the way of the saddle: up where the stable branch lies below it in amplitude.
    up = np.asarray(model.flow.F_AA(Omega, A, model.m, model.zeta, h, h_A, h_AA)) < 0
    corner_Omega, corner_A, corner_up = corner_folds(model, F_0)
    Omega, A, up = (np.concatenate(pair) for pair in ((Omega, corner_Omega), (A, corner_A), (up, corner_up)))
    corner = np.arange(A.size) >= A.size - corner_A.size
    order = np.argsort(Omega, kind="stable")
    message = remark if A.size else NO_FOLD.format(F_0)
    kind = np.where(up, "jump-up", "jump-down")[order]
    return SaddleNodes(Omega[order], A[order], kind, corner[order], F_0, message, model)


def onset(model: Model) -> SaddleNodeOnset:
    """The lowest forcing that has a fold, in whatever regime it lies."""
    if model.zeta == 0:
        return _onset_without_viscous_damping(model)
    F_0, rest = RAISE * max(model.m, 1e-6), math.inf
    for _ in range(RAISES):
        A_max, _ = amplitude_bound(model, F_0)
        best, at_rest = _lowest(model, spans(fold_locus(model), A_max))
        # samples up to a larger amplitude may pass what these have found
        rest = min(rest, at_rest)
        # Every fold at a forcing up to F_0 lies below A_max.
        if best.F_SN is not None and best.F_SN <= F_0:
            return with_folds_at_rest(best, rest)
        F_0 *= RAISE
    nothing = SaddleNodeOnset(None, None, None, "", f"no saddle node up to F_0 = {F_0:g}")
    return with_folds_at_rest(nothing, rest)


def _lowest(model: Model, located: Spans) -> tuple[SaddleNodeOnset, float]:
    """Lowest minimum of the level along the fold locus and over the corners, joints of both included.

    Beside it the lowest level at which the locus ends at Omega = 0, inf for none.
    """
    candidates: list[tuple[float, float, float, str]] = []
    # a softening force has folds at rest: the locus ends at Omega = 0 where h or h_A vanishes
    rest = float(located.level[located.mark == "zero"].min(initial=math.inf))
    for kind, is_minimum in (("cusp", cusp_is_minimum), ("isola", isola_is_minimum)):
        rows = located.marked(kind)
        level, Omega, A = located.level[rows, 1], located.Omega[rows, 1], located.A[rows, 1]
        least = is_minimum(model, Omega, A)
        candidates += [(*point, kind) for point in np.stack([level, Omega, A], axis=-1)[least].tolist()]
    for b, jump in zip(model.breakpoints, model.jumps, strict=True):
        points, at_rest = _on_breakpoint(model, b, jump)
        candidates += [(*point, b, "corner") for point in points]
        rest = min(rest, at_rest)
    if np.isclose(rest, model.m, rtol=1e-6, atol=1e-8):  # where h vanishes, not known to the last place
        rest = model.m
    if not candidates:
        return SaddleNodeOnset(None, None, None, "", NO_ONSET), rest
    F_SN, Omega, A, kind = min(candidates)
    return SaddleNodeOnset(F_SN, Omega, A, kind, ""), rest


def with_folds_at_rest(onset: SaddleNodeOnset, rest: float) -> SaddleNodeOnset:
    """The onset, with the remark that there are folds at lower forcings: the locus ends at Omega = 0 at this level."""
    if not rest < (math.inf if onset.F_SN is None else onset.F_SN):
        return onset
    words = (NONE_BUT_AT_REST if onset.F_SN is None else AT_REST).format(rest)
    return dataclasses.replace(onset, message=words, remarks=Remark.FOLDS_AT_REST)


def _on_breakpoint(model: Model, b: float, jump: float) -> tuple[list[tuple[float, float]], float]:
    """Level and Omega where folds on a breakpoint have their lowest level, and the level of those at Omega = 0.

    Where the force jumps by J folds sit on the breakpoint where F_A has there the other sign than R J, which it has
    next to it: from where the locus below ends, and, for J < 0, from R = 0 on, where the locus above comes in; both
    lead to a higher Omega and level. Between, the level may be stationary. Where only the slope jumps the locus goes
    on, but its level may turn, as F_AA above is infinite. As in native/onset.h.
    """
    flow, m, zeta = model.flow, model.m, model.zeta
    h, h_A, h_AA, _ = model.averaged(b)
    sign = jump if jump != 0 else float(model.averaged(np.nextafter(b, np.inf))[2] - h_AA)

    def level(Omega: Floats) -> Floats:
        return np.asarray(flow.level(Omega, b, m, zeta, h))

    roots, count = fold_roots(np.array([b]), np.array([h]), np.array([h_A]), m, zeta)
    w = roots[0, : count[0]]
    side = flow.F_Omega(w, b, m, zeta, h) * flow.F_AOmega(w, b, m, zeta, h, h_A) * flow.R(w, b, h) * sign
    falls = general_flow.level_rise(w, b, m, zeta, h, h_A, h_AA) < 0
    Omega = w[np.asarray(falls & (side < 0))].tolist()
    if jump == 0:
        return list(zip(level(np.array(Omega)).tolist(), Omega, strict=True)), math.inf
    if h < 0 and jump < 0:
        Omega.append(float(flow.backbone(b, h)))
    stationary, number = peak_roots(np.array([b]), np.array([h]), m, zeta)
    w = stationary[0, : number[0]]
    inside = flow.F_A(w, b, m, zeta, h, h_A) * flow.R(w, b, h) * jump < 0
    Omega += w[np.asarray(inside & (general_flow.F_OmegaOmega(w, b, zeta, h) > 0))].tolist()
    ends = h_A * jump < 0 and (m > 0 or general_flow.F_OmegaOmega(0.0, b, zeta, h) >= 0)
    rest = float(level(np.array(0.0))) if ends else math.inf
    return list(zip(level(np.array(Omega)).tolist(), Omega, strict=True)), rest


def _onset_without_viscous_damping(model: Model) -> SaddleNodeOnset:
    """zeta = 0: the fold Omega^2 = -h_A starts from F_0 = m at A = 0, which is approached, not reached."""
    if not saddle_nodes(model, 2 * model.m + 1.0).A.size:
        return SaddleNodeOnset(None, None, None, "", "no saddle node: the oscillator is linear")
    return SaddleNodeOnset(None, None, None, "", NO_LOWEST.format(model.m))


def detachment(model: Model) -> Detachment:
    """The lowest forcing for which the first breakpoint is a steady state (34)."""
    if not model.breakpoints:
        return Detachment(None, None, None, NO_DETACHMENT)
    level, Omega = least_forcing(model, np.array([model.breakpoints[0]]))
    return Detachment(float(level[0]), float(Omega[0]), model.breakpoints[0], "")


def peak(model: Model, F_0: float) -> Peak:
    """The highest peak at F_0 > m; where A only falls with Omega, the static amplitude at Omega = 0."""
    if model.zeta == 0:
        return Peak(None, None, F_0, NO_PEAK)
    A_max, _ = amplitude_bound(model, F_0)
    peaks = spans(peak_locus(model), A_max)
    rows = peaks.crossed(F_0)
    # the larger Omega is the minimum of F over Omega, the smaller one its maximum: F rises or falls through a peak of A
    rising = peaks.level[rows, 1] > peaks.level[rows, 0]
    upper = peaks.index[rows] == peaks.count[rows] - 1
    A, Omega = peaks.crossings(F_0, rows[rising == upper])
    if not A.size:
        A, Omega = spans(static_locus(model), A_max).crossings(F_0)
    if not A.size:
        raise ArithmeticError(f"the response is unresolved at F_0 = {F_0:.17g}: no state lies on the samples")
    return Peak(float(A[-1]), float(Omega[-1]), F_0, "")
