"""Shock response of many designs, as arrays."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from slowflow.answers.results import Remark
from slowflow.averaged.batches import Batch
from slowflow.averaged.chunks import map_chunks
from slowflow.averaged.many import Designs, failed
from slowflow.core import validate
from slowflow.core.backend import EXACT
from slowflow.core.mechanism import Floats
from slowflow.exact import questions
from slowflow.exact.motion import MOST_STEPS, MOST_WORK, design_rows, recurrences, system_of
from slowflow.exact.transient import AFTER, NO_PULSE, half_sine, record, transient
from slowflow.support import progress
from slowflow.support.errors import Refused
from slowflow.support.text import text
from slowflow_kernels.conventions import Status
from slowflow_kernels.exact_conventions import Outcome

#: arcs in a chunk, which take some tenths of a second; arcs that a shock costs in addition to those of its pulse
CHUNK_ARCS, OVERHEAD = 2**14, 16
#: of a design's numbers by name, what has its equilibria: `slowflow.off_centre.OffCentre`, of a room above this
AtRest = Callable[[dict[str, float]], Any]

SAMPLES = "{tau} and acceleration must have the same number of samples, not {shapes:s}"


def answer(
    designs: Designs,
    question: str,
    acceleration: Any,
    duration: Any = None,
    tau: Any = None,
    after: float | None = None,
    workers: int = 1,
    mu_s: Any = None,
    *,
    at_rest: AtRest,
    batch: Callable[..., Batch] = Batch,
) -> Batch:
    """See `shock_spectrum` and `transient` of `slowflow.answers.table.ManyQuestions`.

    mu_s    -- static friction of each design, None where it is that of sliding
    at_rest -- of one design, from its numbers by name, what has its equilibria
    batch   -- what an answer is
    """
    validate.is_in_time(question, designs.values)
    if (duration is None) == (tau is None):
        raise Refused(NO_PULSE)
    last = AFTER if after is None else validate.number("after", after, least=0.0)
    pulse: dict[str, Any] = {}
    allowed: Any
    with np.errstate(all="ignore"):  # what is no pulse has a status
        if tau is None:
            pulse = _numbers(acceleration=acceleration, duration=duration)
            validate.common_shape(pulse)
            peak, span = pulse.values()
            arcs, allowed = half_sine(peak, span), span > 0
            begin = np.zeros(arcs.shape[:-2])
        else:
            times, accelerations = _samples(tau, acceleration)
            arcs, begin, allowed = record(times, accelerations), times[..., 0], (np.diff(times) > 0).all(axis=-1)
    if question == "shock_spectrum":
        allowed, last = allowed & (peak > 0), 0.0
    columns = _solve(designs, at_rest, arcs, begin, allowed, last, workers, mu_s)
    if question == "shock_spectrum":
        columns["ratio"] = columns["a_max"] / peak
    with np.errstate(all="ignore"):  # what is no design has no pieces
        beyond = designs.mechanism.reach_at(*designs.mechanism.coefficients(*designs.design)) < columns["A"]
    codes = np.where(beyond, np.uint16(Remark.BEYOND_REACH), np.uint16(0))
    return batch(question, columns, designs, pulse, remarks=codes)


def _numbers(**values: Any) -> dict[str, Floats]:
    """Numbers of pulses, in doubles. Raises Refused for what is no plain array."""
    for name, value in values.items():
        if validate.is_labelled(value):
            raise Refused(f"{name} has named axes, or is cut into blocks: shocks take plain arrays")
    return {name: validate.real_array(name, value).astype(float) for name, value in values.items()}


def _samples(tau: Any, acceleration: Any) -> tuple[Floats, Floats]:
    """Records in doubles, samples along the last axis. Raises ValueError for other arrays than of as many samples."""
    times, values = _numbers(tau=tau, acceleration=acceleration).values()
    if not (times.ndim and values.ndim and times.shape[-1] == values.shape[-1] >= 2):
        raise Refused(text(SAMPLES, f"{times.shape} and {values.shape}"))
    validate.common_shape({"tau": times, "acceleration": values})
    return times, values


def _solve(
    designs: Designs, at_rest: AtRest, arcs: Floats, begin: Floats, allowed: Any, after: float, workers: int, mu_s: Any
) -> dict[str, Any]:
    """The columns of "transient" for arcs of shape (..., n, 4), which before that broadcast with the designs."""
    threads = validate.workers(workers)
    pulses = {"begin": begin, "pulse": arcs[..., 0, 0]}
    shape = validate.common_shape({**designs.values, **pulses})
    values = {name: np.broadcast_to(value, shape).ravel() for name, value in designs.values.items()}
    pulses_of = arcs.reshape(-1, *arcs.shape[-2:])  # not broadcast: a record is long
    index = np.broadcast_to(np.arange(len(pulses_of)).reshape(arcs.shape[:-2]), shape).ravel()
    begins = np.broadcast_to(begin, shape).ravel()
    finite = allowed & np.isfinite(arcs).all(axis=(-1, -2)) & np.isfinite(begin)
    static = None if mu_s is None else np.broadcast_to(mu_s, shape).ravel()
    loaded = "load" in designs.values
    known = loaded or np.broadcast_to(designs.detachment(workers=workers).status != Status.INVALID, shape)
    valid = individual = np.flatnonzero(np.broadcast_to(finite, shape) & known)
    status, numbers = np.full(begins.size, Status.INVALID, np.int8), np.full((begins.size, 8), np.nan)
    laws = tuple(recurrences(law) for law in designs.mechanism.pieces)
    if not (loaded or designs.laws or None in laws or static is not None):
        with np.errstate(all="ignore"):
            centre = designs.mechanism.at_rest(*designs.mechanism.coefficients(*designs.design))[:2]
        # a force that jumps at u = 0, or whose equilibrium there may be unstable, is followed singly, which refuses one
        # without finite stiffness
        smooth = np.broadcast_to((centre[0] == 0) & np.isfinite(centre[1]) & (centre[1] < 0), shape).ravel()
        individual = valid[~smooth[valid]]
    for k in progress.each(individual.tolist(), individual.size, "designs integrated one by one"):
        one = {name: float(value[k]) for name, value in values.items()}
        more = {} if static is None else {"mu_s": float(static[k])}
        status[k], numbers[k] = _single(designs, at_rest, one, pulses_of[index[k]], float(begins[k]), after, **more)
    batched = np.setdiff1d(valid, individual, assume_unique=True)

    def solve(part: Any) -> None:
        chunk = batched[part]
        own = {name: value[chunk] for name, value in values.items()}
        outcomes, found = np.empty(chunk.size, np.int8), np.empty((chunk.size, 7))
        rows = design_rows(designs.mechanism, own, ("mu", "zeta"))
        rows += [np.ascontiguousarray(group) for group in (pulses_of[index[chunk]], begins[chunk])]
        EXACT.shocks(laws, *rows, after, MOST_STEPS, MOST_WORK, outcomes, found)
        numbers[chunk, :7] = found
        status[chunk] = np.where(outcomes == Outcome.GOOD, Status.OK, Status.UNRESOLVED)

    size = max(1, CHUNK_ARCS // (OVERHEAD + arcs.shape[-2]))
    chunks = (slice(first, first + size) for first in range(0, batched.size, size))
    map_chunks(solve, chunks, threads, lambda part: batched[part].size, batched.size)
    A, tau_A, a_max, tau_a, tau_detaches, sticks, u_end, stable = np.moveaxis(numbers.reshape(*shape, 8), -1, 0).copy()
    flags = {"detaches": ~np.isnan(tau_detaches), "rests": sticks == 1, "status": status.reshape(shape)}
    flags["stands"] = np.nan_to_num(stable)
    found = {"A": A, "tau_A": tau_A, "a_max": a_max, "tau_a": tau_a, "tau_detaches": tau_detaches, "u_end": u_end}
    return {**found, **{name: values.astype(np.int8) for name, values in flags.items()}}


def _single(
    designs: Designs, at_rest: AtRest, values: dict[str, float], arcs: Floats, begin: float, after: float, **more: Any
) -> tuple[Status, tuple[float, ...]]:
    """The status and the numbers of one design, by `transient`, and how many stable equilibria it has."""
    try:
        system = replace(system_of(designs, values, validate.number("load", values.get("load", 0.0))), **more)
        at, stable = 0.0, 1
        # averages about a mean do not exist for some forces: not needed where the mass rests at u = 0
        if not (system.centred and questions.stable_at_centre(system)):
            equilibria = at_rest(values)
            at, stable = questions.equilibrium(equilibria, system)[0], int(equilibria.rest().stable.sum())
        found = transient(system, arcs, begin=begin, after=after, at=at)
    except (ValueError, ArithmeticError) as error:
        return failed(error), (np.nan,) * 8
    tau_detaches = np.nan if found.tau_detaches is None else found.tau_detaches
    motion = found.A, found.tau_A, found.a_max, found.tau_a, tau_detaches, float(found.rests), found.u_end
    return Status.OK, (*motion, stable)
