"""Engineering checks of many designs. Takes designs and forcings; returns columns, one row per design.

The answers are those of `checks`, computed from the batch questions. Where these do not suffice, as for designs with
more than two folds or with other damping laws, single designs are evaluated.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from operator import itemgetter
from typing import Any

import numpy as np

from slowflow.answers.results import Remark
from slowflow.answers.table import AVERAGING, QUESTIONS, Codes
from slowflow.averaged import checks, isolating, many
from slowflow.averaged.batches import Batch
from slowflow.averaged.diagnostics import gives_way
from slowflow.averaged.questions import Averaged
from slowflow.core import validate
from slowflow.core.mechanism import Flags, Floats, Ints
from slowflow.support import progress
from slowflow_kernels import dissipation, inertia, slow_flow
from slowflow_kernels.conventions import Status

#: designs at once
AT_ONCE = 1024

#: bands of this share of their frequency may be rounding
NARROW = 1e-12

#: where a question failed that may have an answer
FAILED = (Status.NO_BOUND, Status.UNRESOLVED, Status.NO_MEMORY)


def at_rest(designs: Designs, workers: int = 1) -> Batch:
    """See `slowflow.answers.table.ManyQuestions.at_rest`."""
    allowed = designs.detachment(workers=workers).status != Status.INVALID
    with np.errstate(all="ignore"):  # what is no design has no pieces
        columns = checks.static(designs._flow, designs.design, np.asarray(designs.values["mu"], dtype=float))
    found = {name: np.where(allowed, np.broadcast_to(one, designs.shape), np.nan) for name, one in columns.items()}
    return Batch("at_rest", found | {"status": np.where(allowed, Status.OK, Status.INVALID).astype(np.int8)}, designs)


def margins(designs: Designs, F_0: Any, workers: int = 1) -> Batch:
    """See `slowflow.answers.table.ManyQuestions.margins`."""
    folds, peaks = designs.saddle_nodes(F_0, workers=workers), designs.peak(F_0, workers=workers)
    onsets, detachments = designs.saddle_node_onset(workers=workers), designs.detachment(workers=workers)
    shape, allowed = folds.status.shape, folds.status != Status.INVALID
    F_SN = np.where(onsets.status == Status.NONE, math.inf, onsets.F_SN)
    F_cr = lifting(designs, detachments)
    sticks = (folds.status == Status.STICKS) | ((folds.remarks & Remark.HELD_AT_REST) != 0)
    # the highest motion is stable: beyond it there is none
    with np.errstate(all="ignore"):  # what is no design has no pieces
        flow = designs._flow
        ends = flow.first_end
    endless = peaks.status == Status.UNBOUNDED
    passes = np.array(endless | (peaks.A > ends))
    drifts = passes & ((peaks.remarks & Remark.LEAVES_CENTRE) != 0)
    unsure = drifts | (endless & (designs.excitation == "force") & ~checks.resonates(flow))
    forcing, sticks_below = np.asarray(F_0, dtype=float), np.zeros(())
    if designs.excitation != "force":  # an amplitude that only rises tends to F_0
        passes |= (peaks.status == Status.NONE) & (forcing > F_cr)
        with np.errstate(all="ignore"):
            sticks_below = inertia.moves_from(forcing, slow_flow.friction(designs.values["mu"]))
    status = np.where(folds.status == Status.STICKS, Status.OK, folds.status)
    for one, counts in ((onsets, True), (detachments, True), (peaks, np.isfinite(F_cr))):
        status = np.where((status == Status.OK) & np.isin(one.status, FAILED) & counts, one.status, status)
    for at, found in _singly(designs, F_0, unsure & np.isfinite(F_cr) & (status == Status.OK), checks.passes_first_end):
        passes[at], status[at] = bool(found), Status.UNRESOLVED if found is None else Status.OK
    detaches = passes & np.isfinite(F_cr)
    with np.errstate(all="ignore"):  # what is no forcing has no share of one
        columns = {"F_SN": F_SN, "F_cr": F_cr, "of_SN": F_SN / forcing, "of_cr": F_cr / forcing}
    columns["Omega_sticks"] = np.where(sticks, math.inf, sticks_below)
    codes = {"kind": onsets.kind, "detaches": detaches, "sticks": sticks}
    known: dict[str, Any] = {
        name: np.where(allowed, np.broadcast_to(values, shape), np.nan) for name, values in columns.items()
    }
    known |= {name: np.where(allowed, np.broadcast_to(code, shape), 0).astype(np.int8) for name, code in codes.items()}
    known |= {"folds": folds.count, "onset": np.broadcast_to(onsets.status, shape).copy()}
    remarks = np.where(allowed, folds.remarks | onsets.remarks | detachments.remarks, np.uint16(0))
    return Batch("margins", known | {"status": status.astype(np.int8)}, designs, {"F_0": F_0}, remarks=remarks)


def lifting(designs: Designs, detachments: Batch) -> Floats:
    """F_cr of each design; inf if there is none, and the limit if it is only approached as Omega increases.

    The limit is u_cr, or more with quadratic damping, for which the amplitude tends to less than F_0.
    """
    none: Any = math.inf
    if designs.excitation != "force":
        with np.errstate(all="ignore"):  # what is no design, or is in one piece, has no limit
            flow = designs._flow
            u_cr = flow.first_end
            none = np.where(np.isfinite(u_cr), flow.full_level(u_cr), u_cr)
    return np.where(detachments.status == Status.NONE, none, detachments.F_cr)


def full(designs: Designs, F_0: Any) -> Floats:
    """The limit of the amplitude under base excitation or unbalance as Omega tends to inf: F_0 without c_2."""
    return np.asarray(dissipation.full_by_inertia(np.asarray(F_0, dtype=float), designs._flow.d))


def hysteresis(designs: Designs, F_0: Any, max_count: int = 3, workers: int = 1) -> Batch:
    """See `slowflow.answers.table.ManyQuestions.hysteresis`."""
    folds = designs.saddle_nodes(F_0, workers=workers)
    shape = folds.status.shape
    columns = QUESTIONS["hysteresis"].blank(AVERAGING, shape, place=max_count)
    low, high, motions, count, status = columns.values()
    status[...] = np.where(folds.status == Status.TOO_MANY, Status.OK, folds.status)
    zeta = np.broadcast_to(designs.values["zeta"], shape)
    own = Remark.LEAVES_CENTRE | Remark.NEGATIVE_STIFFNESS | Remark.HELD_AT_REST | Remark.UNDECIDED
    remarked = (folds.remarks & own) != 0
    # below two folds and above them there is one motion, so there are three between them, the middle one unstable
    low_end, high_end = folds.Omega[..., 0], folds.Omega[..., 1]
    plain = (folds.count == 2) & (zeta > 0) & ~remarked & (high_end - low_end > NARROW * high_end)
    with np.errstate(all="ignore"):  # a number outside its domain has a status
        flow = designs._flow
        # of two motions one may be beyond the well, and none then
        plain &= flow.stays_centred | ~gives_way(flow)
    if designs.excitation != "force":  # a response that does not close has more
        plain &= designs.peak(F_0, workers=workers).status != Status.UNBOUNDED
    low[plain, 0], high[plain, 0] = low_end[plain], high_end[plain]
    motions[plain, 0], count[plain] = 2, 1
    for at, found in _singly(designs, F_0, (status == Status.OK) & (folds.count > 0) & ~plain, checks.hysteresis):
        if found is None:
            status[at] = Status.UNRESOLVED
            continue
        n, count[at] = min(max_count, len(found)), len(found)
        low[at][:n], high[at][:n] = found.Omega_low[:n], found.Omega_high[:n]
        motions[at][:n] = found.motions[:n]
    status[(count > max_count) & (status == Status.OK)] = Status.TOO_MANY
    return Batch("hysteresis", columns, designs, {"F_0": F_0}, remarks=folds.remarks)


def isolation(designs: Designs, F_0: Any, level_dB: Any = None, workers: int = 1) -> Batch:
    """See `slowflow.answers.table.ManyQuestions.isolation`.

    Uses `isolating.isolated_each` with peaks and folds. Designs whose motions may leave the centre, or whose peak or
    folds are not all known, are evaluated singly.
    """
    peaks, folds = designs.peak(F_0, workers=workers), designs.saddle_nodes(F_0, workers=workers)
    level = validate.real_array("level_dB", 0.0 if level_dB is None else level_dB)
    shape = validate.common_shape({**designs.values, "F_0": np.asarray(F_0), "level_dB": level})
    dB, forcing = (np.broadcast_to(np.asarray(one, dtype=float), shape) for one in (level, F_0))
    with np.errstate(all="ignore"):  # a number outside its domain has a status
        flow, levels = designs._flow, isolating.Level.of(dB)
        status = np.where(np.isfinite(dB) & (dB <= 0), peaks.status, Status.INVALID).astype(np.int8)
        answered = np.isin(status, (Status.OK, Status.NONE) if flow.inertial else Status.OK)
        # friction alone passes on more, at any frequency, whether the response is known or not
        any_state = answered if flow.inertial else ~np.isin(status, (Status.INVALID, Status.STICKS))
        floor = (dB < 0) & (flow.floor(forcing) >= levels.ratio) & any_state
        known = flow.stays_centred & answered & ~floor
    status[floor] = Status.NONE
    remarks = (peaks.remarks | folds.remarks) & ~np.uint16(Remark.OF_TRUNCATION)  # which a fold is of, not the response
    known &= (folds.status == Status.OK) & (remarks & (Remark.UNDECIDED | Remark.BY_BALLS) == 0)
    remarks = np.broadcast_to(np.where(known | (status == Status.STICKS), remarks, np.uint16(0)), shape).copy()
    found = {**QUESTIONS["isolation"].blank(AVERAGING, shape), "status": status}
    singly = np.array(np.isin(status, (Status.OK, Status.UNBOUNDED, Status.NONE)) & ~floor & ~known)
    # without a peak no motion on a base that shakes exceeds F_0
    highest = np.broadcast_to(np.where(peaks.status == Status.NONE, F_0, peaks.A), shape)
    of_folds = [np.broadcast_to(one, (*shape, one.shape[-1])) for one in (folds.Omega, folds.A)]
    spread, rows = flow.each(lambda number: np.broadcast_to(number, shape)), np.argwhere(known)
    for part in progress.chunks(len(rows), AT_ONCE, "isolation"):
        at = tuple(rows[part].T) or (np.newaxis,)  # a single design has no axis
        place = (*at, np.newaxis)
        own = spread.each(itemgetter(place))
        A_max, F, *of_level = (one[place] for one in (highest, forcing, *levels))
        with np.errstate(all="ignore"):  # an amplitude may have no frequency of that level
            unsure, *columns = isolating.isolated_each(
                own, tuple(one[at] for one in of_folds), A_max, F, isolating.Level(*of_level)
            )
        for name, column in zip(("at_fold", "Omega", "A"), columns, strict=True):
            found[name][at] = column
        status[at], singly[at] = Status.OK, unsure
        if flow.inertial:  # at low frequencies friction all but holds the mass
            remarks[at] |= np.where(own.mu[:, 0] > 0, np.uint16(Remark.NEAR_STICKING), np.uint16(0))
    for at, one in _singly(designs, F_0, singly, checks.isolation, dB):
        status[at] = Status.UNRESOLVED if one is None else Status.NONE if one.Omega is None else Status.OK
        remarks[at] = 0 if one is None else one.remarks
        found["at_fold"][at] = one is not None and one.at_fold
        for name in ("Omega", "A"):
            value = getattr(one, name, None)
            found[name][at] = np.nan if value is None else value
    at_level = {} if level_dB is None else {"level_dB": level_dB}
    return Batch("isolation", found, designs, {"F_0": F_0, **at_level}, remarks=remarks)


def spectrum(designs: Designs, Omega: Any, F_0: Any, workers: int = 1) -> Batch:
    """See `slowflow.answers.table.ManyQuestions.spectrum`."""
    rows = designs._with_values({name: value[..., np.newaxis] for name, value in designs.values.items()})
    arguments = {"Omega": Omega, "F_0": F_0}
    states = _with_all(partial(rows.amplitudes, **arguments, workers=workers))
    shape = states.status.shape
    at, F = (np.broadcast_to(np.asarray(value, dtype=float), shape) for value in arguments.values())
    crosses, status = _crossed(rows, at, F, states.status, workers)
    amplitudes = np.where(states.stable == 1, states.A, -math.inf)
    top = amplitudes.argmax(axis=-1)[..., np.newaxis]
    A, passes = (np.take_along_axis(one, top, -1)[..., 0] for one in (amplitudes, states.transmissibility))
    moving, sticks = A > 0, A == 0
    with np.errstate(all="ignore"):  # a number outside its domain has a status, and no amplitude
        detaches = moving & (rows._flow.first_end < A)
        dB = np.where(A >= 0, 20 * np.log10(passes), np.nan)
    # of a way that is not known a row has the status
    known = np.isin(status, (Status.OK, Status.STICKS, Status.NONE))
    status = np.where(sticks & known, Status.STICKS, np.where((status == Status.OK) & ~moving, Status.NONE, status))
    flags = {"motions": ((states.stable == 1) & (states.A > 0)).sum(axis=-1), "crosses": crosses}
    flags |= {"detaches": detaches, "sticks": sticks, "status": status}
    columns = {"A": np.where(A >= 0, A, np.nan), "transmissibility_dB": dB}
    columns |= {name: value.astype(np.int8) for name, value in flags.items()}
    return Batch("spectrum", columns, rows, {"F_0": F_0, "Omega": Omega}, remarks=states.remarks)


def _crossed(rows: Designs, Omega: Floats, F_0: Floats, status: Codes, workers: int) -> tuple[Flags, Codes]:
    """Whether a fold lies on the way to each row from the one before, and the status of rows, that of ways included."""
    shape, crosses, status = status.shape, np.zeros(status.shape, dtype=bool), status.copy()
    spread = {name: np.broadcast_to(value, shape)[..., 1:].ravel() for name, value in rows.values.items()}
    before, here = (
        np.array([Omega[..., part].ravel(), F_0[..., part].ravel()]) for part in (slice(-1), slice(1, None))
    )
    # of a way from or to a row that is none no fold is asked for
    valid = (status[..., 1:] != Status.INVALID) & (status[..., :-1] != Status.INVALID)
    fares = np.where(valid, Status.OK, Status.INVALID).astype(np.int8).ravel()
    found = np.zeros(fares.size, dtype=bool)
    ways = np.flatnonzero(valid)
    for first in range(0, ways.size, AT_ONCE):
        part = ways[first : first + AT_ONCE]

        def sides(which: Ints, at: Floats, forcing: Floats, part: Ints = part) -> Ints:
            return _sides(rows, spread, fares, part[which], at, forcing, workers)

        found[part] = checks.crossed(sides, before[:, part], here[:, part])
    crosses[..., 1:] = found.reshape(crosses[..., 1:].shape)
    later = status[..., 1:]
    later[...] = np.where(np.isin(later, (Status.OK, Status.STICKS)), fares.reshape(later.shape), later)
    return crosses, status


def _sides(
    rows: Designs, spread: dict[str, Floats], fares: Codes, which: Ints, Omega: Floats, F_0: Floats, workers: int
) -> Ints:
    """`checks.on_both_sides` of ways by their number; `fares` takes the status of those whose folds are not known."""
    # in their order ways of one design share forcings: each begins where the last one ends
    own = [F_0, *(value[which] for value in spread.values())]
    new = np.ones(which.size, dtype=bool)
    new[1:] = np.any([value[1:] != value[:-1] for value in own], axis=0)
    designs = rows._with_values({name: value[which][new] for name, value in spread.items()})
    folds = _with_all(partial(designs.saddle_nodes, F_0[new], workers=workers))
    of = np.cumsum(new) - 1
    failed = np.isin(folds.status[of], FAILED)
    fares[which[failed]] = folds.status[of][failed]
    return checks.on_both_sides(folds.Omega[of], Omega)


def _singly(designs: Designs, F_0: Any, selected: Flags, ask: Callable[..., Any], *extra: Floats) -> Any:
    """A single answer for each selected design, with its index; None where it fails."""
    for at, numbers, arguments in designs._each(selected, F_0, *extra):
        try:
            yield at, ask(Averaged(designs._model(numbers)), *arguments)
        except ArithmeticError:
            yield at, None


def _with_all(ask: Callable[..., Any]) -> Any:
    """The batch that `ask` gives, with places for all that any design has."""
    found = ask()
    return ask(max_count=int(found.count.max())) if (found.status == Status.TOO_MANY).any() else found


#: the questions that combine others, by name
COMBINED = {one.__name__: one for one in (at_rest, margins, hysteresis, isolation, spectrum)}


class Designs(many.Designs):
    """Arrays of designs of one mechanism; questions that combine others are functions of this module."""

    def _ask(self, question: str, /, *, workers: int = 1, **kwargs: Any) -> Batch:
        """The answer to a question by its name, from what its method takes."""
        if (combined := COMBINED.get(question)) is None:
            return super()._ask(question, workers=workers, **kwargs)
        if "max_count" in kwargs:
            kwargs["max_count"] = validate.count("max_count", kwargs["max_count"], least=1)
        found: Batch = combined(self, **kwargs, workers=workers)
        return found
