"""How far to look: in go a model and a forcing, out comes an amplitude that no steady state exceeds."""

from __future__ import annotations

from typing import Any

import numpy as np

from slowflow.averaged import words
from slowflow.averaged.reference import dissipated, inertia
from slowflow.averaged.reference.cells import cells_of, samples_at
from slowflow.averaged.reference.enclosed import enclosed
from slowflow.averaged.reference.roots import Ints, peak_roots, response_roots, taken
from slowflow.intervals import Bools
from slowflow.model import Floats, Model
from slowflow_kernels import dissipation, slow_flow
from slowflow_kernels.conventions import COARSEST, ENDLESS, FINE_RUNGS, RUNGS
from slowflow_support.errors import NotSettled, OutOfRange


def _rungs() -> Floats:
    """Multiples of the least amplitude that are tried as a bound, in steps that grow."""
    found, step = [1.0], 2.0
    for i in range(RUNGS - 1):
        found.append(found[-1] * step)
        if i >= FINE_RUNGS and step < COARSEST:
            step *= 2
    return np.array(found)


_RUNGS = _rungs()


def least_forcing(model: Model, A: Floats) -> tuple[Floats, Floats]:
    """The lowest F_0 for which each A (n,) is a steady state, and its Omega: min over Omega >= 0 of sqrt(R^2 + I^2)."""
    stationary = peak_roots(A, model.averaged(A)[0], model.m, model.zeta)[0]
    Omega = np.concatenate([np.zeros((*A.shape, 1)), stationary], axis=-1)
    level = model.level(Omega, A[..., np.newaxis])
    lowest = np.nanargmin(level, axis=-1)[..., np.newaxis]
    return np.take_along_axis(level, lowest, -1)[..., 0], np.take_along_axis(Omega, lowest, -1)[..., 0]


@np.errstate(all="ignore")
def amplitude_bound(model: Model, F_0: float, lowest: float = 0.0) -> tuple[float, str]:
    """An amplitude above that of every steady state at F_0, and a remark in words where the response has to be cut.

    From there on |h| is too large for a state: it is so there, and rises up to where it has no bound in doubles. Raises
    OverflowError where no such amplitude is found, or up to it numbers leave the range of doubles.

    lowest -- the lowest Omega that is asked for: it bounds the states of a mass that no spring holds
    """
    found = _bounded(model, F_0, lowest)
    if model.laws.any and not dissipated.is_in_range(model, F_0, found[0]):
        raise OutOfRange(words.beyond_range(model, F_0))
    return found


def _bounded(model: Model, F_0: float, lowest: float) -> tuple[float, str]:
    """The same, of numbers of any size."""
    if model.zeta == 0 and not model.laws.any:
        return words.cut(model, F_0)
    if model.free and model.laws.eta == 0:
        if not model.inertial:
            return _bound_of_free(model, F_0, lowest)
        if model.zeta == model.m == 0:
            raise NotSettled(words.everywhere(float(dissipation.full_by_inertia(F_0, model.d))))
    rungs = max(2 * max(model.breakpoints, default=0.0), F_0) * _RUNGS
    if model.inertial:
        known = [inertia.bound(model, F_0, rungs) if model.zeta > 0 else None]
        if model.laws.any:
            known.append(dissipated.bound_by_inertia(model, F_0, rungs))
        closed = min((one for one in known if one is not None), default=None)
        along = dissipated.Roots(model, F_0) if model.laws.any else inertia.Roots(model, F_0)
        if closed is not None:
            return closed, ""
        if not (cut := inertia.cut(along, rungs)) < np.inf:
            raise OutOfRange(words.beyond_range(model, F_0))
        return words.does_not_close(cut)
    if model.mechanism.enclosed is None and not model.laws.any:
        (found,) = first_bounds(model, F_0).tolist()
        return (found, "") if found < np.inf else _beyond_rungs(model, F_0, lowest)
    by_damping = np.inf
    if model.laws.any:
        most, by_damping = dissipated.most_restoring(model, F_0, rungs)
    else:
        most = slow_flow.most_restoring(rungs, F_0, model.m, model.zeta)
    if model.mechanism.enclosed is not None:
        bounds = least_beyond(model, rungs) > most
        bounded = (bounds & (rungs <= model.reach)).any() or by_damping <= model.reach
        if np.isfinite(model.reach) and not bounded:
            return words.cut_at_reach(model) if _has_state(model, model.reach, F_0) else (model.reach, "")
    else:
        bounds = _exceeds_from(model, rungs, most, np.zeros(rungs.size, np.intp))
    bounds &= np.isfinite(rungs)
    found = min(float(rungs[np.argmax(bounds)]) if bounds.any() else np.inf, by_damping)
    return (found, "") if found < np.inf else _beyond_rungs(model, F_0, lowest)


def _beyond_rungs(model: Model, F_0: float, lowest: float) -> tuple[float, str]:
    """The same where the spring does not bound the response: where its force levels off damping does, at Omega > 0."""
    if not model.lets_go or model.laws.eta > 0:
        raise OutOfRange(words.unbounded(model, F_0))
    return _bound_of_free(model, F_0, lowest)


def first_bounds(model: Model, F_0: Any) -> Floats:
    """Of each of designs abreast the first of the rungs above which no state lies, by a force; inf where none is known.

    For viscous damping, and averages in closed form.
    """
    found, left = np.full(model.abreast, np.inf), np.arange(model.abreast)
    least = np.max(np.broadcast_arrays(F_0, *(2 * b for b in model.breakpoints)), axis=0)
    least = np.broadcast_to(least, left.shape)
    # most are among the first
    for rungs in np.split(_RUNGS, [FINE_RUNGS]):
        A, of = np.outer(least[left], rungs), np.repeat(left, rungs.size)
        own = model.take(of)
        most = slow_flow.most_restoring(A.ravel(), taken(F_0, of), own.m, own.zeta)
        bounds = _exceeds_from(model, A.ravel(), most, of).reshape(A.shape) & np.isfinite(A)
        known = bounds.any(axis=1)
        found[left[known]] = A[known, bounds[known].argmax(axis=1)]
        left = left[~known]
        if not left.size:
            break
    return found


def _exceeds_from(model: Model, A: Floats, most: Floats, of: Ints) -> Bools:
    """Whether |h| exceeds so much at amplitudes, and rises from there on; `of`: of which of the designs abreast."""
    both = samples_at(model, np.concatenate((A, ENDLESS * np.maximum(A, 1.0))), np.tile(of, 2))
    at, far = both.take(slice(0, A.size)), both.take(slice(A.size, None))
    slope = cells_of(model, at, far, at).h_A
    rises = np.where(at.h > 0, slope.lo >= 0, slope.hi <= 0)
    return np.asarray(rises & (np.abs(at.h) > most))


def _bound_of_free(model: Model, F_0: float, lowest: float) -> tuple[float, str]:
    """The same of a mass that the spring does not hold, whose motions at Omega damping limits, (27): none does at 0."""
    if lowest == 0:
        return words.cut_towards_rest(model, F_0)
    by_damping = 2 * float(dissipation.limit_envelope(lowest, F_0, model.m, model.zeta, 0.0, model.d))
    return max(by_damping, *(2 * b for b in model.breakpoints), 0.0), ""


def _has_state(model: Model, A: float, F_0: float) -> bool:
    """Whether an amplitude is a steady state at some frequency."""
    if model.laws.any:
        return bool(dissipated.frequencies_at(model, A, F_0).size)
    h = model.averaged(A)[0]
    return bool(response_roots(np.array([A]), np.array([h]), model.m, model.zeta, F_0)[1].any())


def least_beyond(model: Model, rungs: Floats) -> Floats:
    """What |h| is not less than from each of some rising amplitudes on, up to the reach or an endless one."""
    nodes = inertia.intervals_beyond(model, rungs)
    h, _ = enclosed(model, nodes[:-1], nodes[1:])
    least = np.where(h.has_sign, np.minimum(np.abs(h.lo), np.abs(h.hi)), 0.0)
    beyond = np.minimum.accumulate(least[::-1])[::-1]
    return np.asarray(np.append(beyond, 0.0)[np.minimum(np.searchsorted(nodes, rungs), beyond.size)])


def closes(model: Model, F_0: float) -> bool:
    """Whether the response at F_0 > m is known to have a highest amplitude, for zeta > 0 or other laws of damping."""
    try:
        return not amplitude_bound(model, F_0)[1]
    except OverflowError:
        return False
