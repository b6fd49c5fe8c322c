"""The questions about one oscillator. Takes a model and numbers; returns answers of the compiled solvers."""

from __future__ import annotations

import math
from functools import partial, reduce
from operator import add

import numpy as np

from slowflow.answers.results import (
    NOTHING,
    Cusps,
    Detachment,
    FoldLocus,
    FrequencyResponse,
    IsolaPoints,
    Peak,
    SaddleNodeOnset,
    SaddleNodes,
    SteadyStates,
)
from slowflow.averaged import messages
from slowflow.core import backend
from slowflow.core.model import Floats, Model, SlowFlow
from slowflow.support import boundary
from slowflow.support.errors import NotSettled, OutOfRange
from slowflow_kernels import dissipation
from slowflow_kernels.conventions import STATIC_MULTIPLE, OnsetKind, Status

#: the words for kinds of folds, by whether a sweep leaves them upwards
FOLD_KINDS = np.array(["jump-down", "jump-up"])
NO_NUMBER = np.empty(0)
#: the words for kinds of onsets
ONSET_KINDS = {kind.value: kind.name.lower() if kind else "" for kind in OnsetKind}


def check(status: int, model: Model, F_0: float | None = None) -> None:
    """Raises what there is to raise where there is no answer; a mass that sticks is one, without an entry."""
    if status == Status.OK:
        return
    if status == Status.NO_MEMORY:
        raise MemoryError
    if status == Status.NO_BOUND:
        undamped = model.inertial and model.zeta == model.m == model.laws.eta == 0
        if undamped and model.spring == "none" and F_0 is not None:
            raise NotSettled(messages.EVERYWHERE.format(float(dissipation.full_by_inertia(F_0, model.d))))
        # where there is a bound, up to it squares leave the range of doubles
        if model.laws.any and F_0 is not None and backend.SOLVER.amplitude_bound(model.native, F_0)[1] < math.inf:
            laws = " with " + model.laws.description()
            raise OutOfRange(messages.SQUARES.format(F_0, laws))
        raise OutOfRange(messages.unbounded(model, F_0))
    if status in (Status.TOO_MANY, Status.UNRESOLVED):
        raise NotSettled("the response is unresolved" if F_0 is None else messages.unresolved(model, F_0))


def may_be_cut(flow: SlowFlow, lowest: float) -> bool:
    """Whether a damped response may have no bound at frequencies from `lowest` on, of one oscillator or of many.

    By inertia a hardening spring may not end the resonance; a force of one's own may soften up to its reach; and where
    a force does not grow far away, or is none, it does not hold the mass as Omega tends to 0.
    """
    if flow.inertial or flow.mechanism.enclosed is not None:
        return True
    return lowest == 0 and flow.mechanism.reach == math.inf


def remark_of(model: Model, F_0: float, lowest: float = 0.0) -> str:
    """A message on where a response is cut; lowest: the lowest Omega of the query."""
    if model.sticks(F_0):
        return ""
    if model.undamped:
        return messages.cut(model, F_0)[1]
    if not may_be_cut(model, lowest):
        return ""
    status, A_max = backend.SOLVER.amplitude_bound(model.native, F_0)
    if status != Status.UNBOUNDED:
        return ""
    if not model.inertial and model.mechanism.enclosed is None:
        why = "no spring holds the mass" if model.spring == "none" else messages.LEVELS_OFF
        return messages.CUT_TOWARDS_REST.format(why, float(STATIC_MULTIPLE * max(F_0, *model.breakpoints, 0.0)))
    if model.inertial and A_max != model.reach:
        return messages.NOT_CLOSED.format(A_max)
    return messages.CUT_AT_REACH.format(model.reach, model.mechanism.reach_reason)


def amplitude_bound(model: Model, F_0: float) -> float:
    """An amplitude above that of every steady state at F_0, or where the response is cut.

    Raises OverflowError where no such amplitude is found.
    """
    status, A_max = backend.SOLVER.amplitude_bound(model.native, F_0)
    check(status, model, F_0)
    return float(A_max)


def are_events_close(model: Model, F_0: float) -> bool:
    """Whether doubles leave open which peaks and static states a response curve has; of a force."""
    try:
        return bool(backend.SOLVER.are_events_close(model.native, F_0, amplitude_bound(model, F_0)))
    except ArithmeticError:
        return True


def closes(model: Model, F_0: float) -> bool:
    """Whether the response at F_0 > m is known to have a highest amplitude, for zeta > 0 or other laws of damping."""
    return bool(backend.SOLVER.amplitude_bound(model.native, F_0)[0] == Status.OK)


def is_cut(model: Model, F_0: float) -> bool:
    """Whether the response at F_0 > m is followed up to the reach of the force only."""
    status, A_max = backend.SOLVER.amplitude_bound(model.native, F_0)
    return bool(status == Status.UNBOUNDED and A_max == model.reach)


def folds(model: Model, F_0: float) -> SaddleNodes:
    """Every fold at F_0 > m, in every regime, by rising Omega."""
    boundary.begin()
    status, Omega, A, up, corner, undecided = backend.SOLVER.saddle_nodes(model.native, F_0)
    check(status, model, F_0)
    message, cut = messages.of_folds(model, F_0, A.size > 0 or undecided, remark_of(model, F_0))
    codes = messages.codes(undecided, cut)
    columns = {"Omega": Omega, "A": A, "kind": FOLD_KINDS.take(up), "corner": corner}
    return SaddleNodes._made(**columns, F_0=F_0, message=message, remarks=codes, _model=model)


def onset(model: Model) -> SaddleNodeOnset:
    """The lowest forcing that has a fold, in whatever regime it lies."""
    boundary.begin()
    status, F_SN, Omega, A, kind, _, at_rest = backend.SOLVER.onset(model.native)
    if status == Status.OK:
        onset = {"F_SN": F_SN, "Omega": Omega, "A": A, "kind": ONSET_KINDS[kind], "untruncated": None}
        found = SaddleNodeOnset._made(**onset, message="", remarks=NOTHING)
        return messages.with_folds_at_rest(model, found, at_rest)
    if status == Status.UNRESOLVED:
        raise NotSettled(messages.unresolved_onset(model))
    check(status, model, at_rest if model.laws.any else None)  # the forcing that no amplitude bounds
    if status == Status.UNBOUNDED:  # at_rest is what the level comes down to
        no_lowest = messages.STIFF_AT_REST if model.zeta > 0 else messages.NO_LOWEST
        message = no_lowest.format(model.m) if at_rest < math.inf else messages.OPEN
        return SaddleNodeOnset(None, None, None, "", message, _status=Status.UNBOUNDED)
    return messages.with_folds_at_rest(model, SaddleNodeOnset(None, None, None, "", messages.NO_ONSET), at_rest)


def detachment(model: Model) -> Detachment:
    """The lowest forcing for which the first breakpoint is a steady state (34)."""
    boundary.begin()
    status, F_cr, Omega_cr, u_cr = backend.SOLVER.detachment(model.native)
    if status == Status.NO_BOUND:
        raise OutOfRange(messages.BEYOND_RANGE.format(model.breakpoints[0]))
    if status == Status.NONE:
        ends = model.breakpoints
        message = messages.NOT_REACHED.format(ends[0], model.full_level(ends[0])) if ends else messages.NO_DETACHMENT
        return Detachment(None, None, None, message)
    return Detachment._made(F_cr=F_cr, Omega_cr=Omega_cr, u_cr=u_cr, message="", remarks=NOTHING)


def peak(model: Model, F_0: float, most: float = math.inf) -> Peak:
    """The highest peak at F_0 > m with an amplitude up to `most`."""
    boundary.begin()
    status, A, Omega = backend.SOLVER.peak(model.native, F_0, most)
    if status == Status.STICKS:
        message = partial(messages.sticks, model, F_0)
        return Peak._made(A=None, Omega=None, F_0=F_0, message=message, remarks=NOTHING, _status=Status.STICKS)
    if status == Status.UNRESOLVED and A > 0:
        raise NotSettled(messages.PEAK_AT.format(F_0, A))
    check(status, model, F_0)
    if status == Status.UNBOUNDED:
        reason = remark_of(model, F_0) if not model.undamped else messages.NO_PEAK
        return Peak(None, None, F_0, reason, _status=Status.UNBOUNDED)
    if status == Status.NONE:
        return messages.no_top(model, F_0, most)
    return Peak._made(A=A, Omega=Omega, F_0=F_0, message="", remarks=NOTHING)


def fold_locus(model: Model, A_max: float, samples: int) -> FoldLocus:
    """About `samples` points of the fold locus up to A_max."""
    boundary.begin()
    status, Omega, A, F_0, branch = backend.SOLVER.fold_locus(model.native, A_max, samples)
    check(status, model)
    # next to a breakpoint a force that hardly jumps has folds too
    ends = [b for b in model.breakpoints if b < A_max and model.mechanism.truncated]
    none = reduce(add, map(messages.AT_JUMP.format, ends), messages.NO_LOCUS.format(A_max))
    return FoldLocus(Omega, A, F_0, branch, "" if A.size else none)


def extrema(model: Model, A_max: float) -> tuple[Cusps, IsolaPoints]:
    """The cusps and the isola points up to A_max."""
    boundary.begin()
    status, *columns = backend.SOLVER.extrema(model.native, A_max)
    check(status, model)
    isola = columns[3]
    F_0, Omega, A, _, minimum, _, few = (column[~isola] for column in columns)
    cusps = Cusps(F_0, Omega, A, minimum, **messages.of_points(A, few, messages.NO_CUSP.format(A_max)))
    F_0, Omega, A, _, minimum, saddle, few = (column[isola] for column in columns)
    kind = np.where(saddle, "merger", np.where(minimum, "birth", "death"))
    return cusps, IsolaPoints(F_0, Omega, A, kind, **messages.of_points(A, few, messages.NO_ISOLA.format(A_max)))


def frequency_response(model: Model, F_0: float, samples: int, window: tuple[float, float]) -> FrequencyResponse:
    """About `samples` points along every branch in the window, and its ends, folds, peaks and corners."""
    boundary.begin()
    answer = backend.SOLVER.frequency_response(model.native, F_0, samples, *window)
    status, Omega, A, stable, branch, isola, undecided = answer
    check(status, model, F_0)
    remark = remark_of(model, F_0, window[0])
    message = remark if A.size else partial(messages.empty_window, model, F_0, window, remark)
    columns = {"Omega": Omega, "A": A, "stable": stable, "branch": branch, "isola": tuple(isola.tolist())}
    columns |= {"Omega_undecided": NO_NUMBER}
    codes = messages.codes(undecided, remark)
    return FrequencyResponse._made(**columns, F_0=F_0, message=message, remarks=codes, _model=model)


def states(model: Model, Omega: Floats, F_0: float) -> SteadyStates:
    """Every steady state at each frequency, by the order of Omega, then by rising A."""
    boundary.begin()
    status, at, A, stable, undecided = backend.SOLVER.steady_states(model.native, F_0, Omega)
    check(status, model, F_0)
    remark = remark_of(model, F_0, float(np.min(Omega, initial=np.inf)))
    message = partial(messages.of_states, model, F_0, remark, Omega, at, undecided)
    columns = {"Omega": at, "A": A, "stable": stable, "Omega_undecided": undecided}
    codes = messages.codes(undecided.size > 0, remark)
    return SteadyStates._made(**columns, F_0=F_0, message=message, remarks=codes, _model=model)
