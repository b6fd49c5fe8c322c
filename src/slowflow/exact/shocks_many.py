"""Shocks of many designs. Takes pulses of the base and designs; returns the answers of `shocks` as arrays."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from slowflow import progress, validate
from slowflow.averaged.batches import Batch
from slowflow.averaged.chunks import share
from slowflow.averaged.many import Designs
from slowflow.backend import EXACT
from slowflow.exact import questions
from slowflow.exact.compiled import recurrences
from slowflow.exact.transient import AFTER, NO_PULSE, half_sine, record, transient
from slowflow.exact.work import MOST_STEPS, MOST_WORK
from slowflow.mechanism import EquationOfMotion, Floats, Force, followed
from slowflow.model import THROUGHOUT, Model
from slowflow.results import Remark
from slowflow.text import text
from slowflow_kernels.conventions import Status
from slowflow_kernels.exact_conventions import Outcome
from slowflow_support.errors import Refused

#: arcs that take no more than some tenths of a second, as many as a shock takes beside those of its pulse
AT_ONCE, ALONE = 2**14, 16
#: what says of a model under a load where it rests: `slowflow.off_centre.OffCentre`, of a room above this
OffCentres = Callable[[Model, float], Any]

SAMPLES = "{tau} and acceleration must have as many samples, not {shapes:s}"


def _batch(question: str, columns: dict[str, Any], designs: Designs, pulse: Mapping[str, Any]) -> Batch:
    """An answer whose remarks say where A is beyond what the mechanism reaches."""
    with np.errstate(all="ignore"):  # what is no design has no pieces
        beyond = designs.mechanism.reach_at(*designs.mechanism.coefficients(*designs.design)) < columns["A"]
    said = np.where(beyond, np.uint16(Remark.BEYOND_REACH), np.uint16(0))
    return Batch(question, columns, designs, pulse, remarks=said)


def of_designs(
    designs: Designs, acceleration: Any, duration: Any, workers: int = 1, *, off_centre: OffCentres
) -> Batch:
    """See `slowflow.designs.Designs.shock_spectrum`."""
    pulse = numbers(acceleration=acceleration, duration=duration)
    validate.common_shape(pulse)
    peak, span = pulse.values()
    allowed = (peak > 0) & (span > 0)
    found = _followed(designs, off_centre, *_half_sine(peak, span), allowed, 0.0, workers)
    return _batch("shock_spectrum", {**found, "ratio": found["a_max"] / peak}, designs, pulse)


def transients(
    designs: Designs,
    acceleration: Any,
    duration: Any,
    tau: Any,
    after: Any,
    workers: int = 1,
    *,
    off_centre: OffCentres,
) -> Batch:
    """See `slowflow.designs.Designs.transient`."""
    last = AFTER if after is None else validate.number("after", after, least=0.0)
    if (duration is None) == (tau is None):
        raise Refused(NO_PULSE)
    if tau is None:
        pulse = numbers(acceleration=acceleration, duration=duration)
        validate.common_shape(pulse)
        peak, span = pulse.values()
        found = _followed(designs, off_centre, *_half_sine(peak, span), span > 0, last, workers)
        return _batch("transient", found, designs, pulse)
    times, accelerations = samples(tau, acceleration)
    rises = (np.diff(times) > 0).all(axis=-1)
    with np.errstate(all="ignore"):  # what is no pulse has a status
        arcs = record(times, accelerations)
    found = _followed(designs, off_centre, arcs, times[..., 0], rises, last, workers)
    return _batch("transient", found, designs, {})


def numbers(**values: Any) -> dict[str, Floats]:
    """Numbers of pulses, in doubles. Raises Refused for what is no plain array."""
    for name, value in values.items():
        if validate.is_labelled(value):
            raise Refused(f"{name} has named axes, or is cut into blocks: shocks take plain arrays")
    return {name: validate.real_array(name, value).astype(float) for name, value in values.items()}


def samples(tau: Any, acceleration: Any) -> tuple[Floats, Floats]:
    """Records in doubles, samples along the last axis. Raises ValueError for other arrays than of as many samples."""
    times, values = numbers(tau=tau, acceleration=acceleration).values()
    if not (times.ndim and values.ndim and times.shape[-1] == values.shape[-1] >= 2):
        raise Refused(text(SAMPLES, f"{times.shape} and {values.shape}"))
    validate.common_shape({"tau": times, "acceleration": values})
    return times, values


def _half_sine(peak: Floats, span: Floats) -> tuple[Floats, Floats]:
    """Its arcs, and when they begin."""
    with np.errstate(all="ignore"):  # what is no pulse has a status
        arcs = half_sine(peak, span)
    return arcs, np.zeros(arcs.shape[:-2])


def _followed(
    designs: Designs,
    off_centre: OffCentres,
    arcs: Floats,
    begin: Floats,
    allowed: Any,
    after: float,
    workers: int,
) -> dict[str, Any]:
    """The columns of "transient" for arcs of shape (..., n, 4), which before that broadcast with the designs."""
    if "eta" in designs.values:
        validate.is_plain("a shock", designs.laws)
    threads = validate.workers(workers)
    pulses = {"begin": begin, "pulse": arcs[..., 0, 0]}
    shape = validate.common_shape({**designs.values, **pulses})
    values = {name: np.broadcast_to(value, shape).ravel() for name, value in designs.values.items()}
    pulses_of = arcs.reshape(-1, *arcs.shape[-2:])  # not spread: designs share pulses, of which a record is long
    which = np.broadcast_to(np.arange(len(pulses_of)).reshape(arcs.shape[:-2]), shape).ravel()
    begins = np.broadcast_to(begin, shape).ravel()
    finite = allowed & np.isfinite(arcs).all(axis=(-1, -2)) & np.isfinite(begin)
    known = np.broadcast_to(designs.detachment(workers=workers).status != Status.INVALID, shape)
    asked = np.flatnonzero(np.broadcast_to(finite, shape) & known)
    status, numbers = np.full(begins.size, Status.INVALID, np.int8), np.full((begins.size, 7), np.nan)
    laws = tuple(recurrences(law) for law in designs.mechanism.pieces)
    with np.errstate(all="ignore"):
        at_rest = designs.mechanism.at_rest(*designs.mechanism.coefficients(*designs.design))[:2]
    # a force that jumps at rest, or that may push away from there, is followed one by one; one that has no finite
    # stiffness there is refused by that
    smooth = np.broadcast_to((at_rest[0] == 0) & np.isfinite(at_rest[1]) & (at_rest[1] < 0), shape).ravel()
    singly = asked if designs.laws or None in laws else asked[~smooth[asked]]
    for k in progress.each(singly.tolist(), singly.size, "designs followed singly"):
        one = {name: float(value[k]) for name, value in values.items()}
        status[k], numbers[k] = _alone(designs, off_centre, one, pulses_of[which[k]], float(begins[k]), after)
    together = np.setdiff1d(asked, singly, assume_unique=True)

    def part(where: Any) -> None:
        here = together[where]
        own = {name: value[here] for name, value in values.items()}
        parameters = designs.mechanism.coefficients(*(own[domain.name] for domain in designs.mechanism.design))
        ends = designs.mechanism.breakpoints(*parameters)
        columns = [_columns(of, here.size) for of in (parameters, ends, (own["mu"], own["zeta"]))]
        outcomes, found = np.empty(here.size, np.int8), np.empty((here.size, 7))
        rows = (np.ascontiguousarray(of) for of in (*columns, pulses_of[which[here]], begins[here]))
        EXACT.shocks(laws, *rows, after, MOST_STEPS, MOST_WORK, outcomes, found)
        numbers[here] = found
        status[here] = np.where(outcomes == Outcome.GOOD, Status.OK, Status.UNRESOLVED)

    at_once = max(1, AT_ONCE // (ALONE + arcs.shape[-2]))
    parts = (slice(first, first + at_once) for first in range(0, together.size, at_once))
    share(part, parts, threads, lambda where: together[where].size, together.size)
    A, tau_A, a_max, tau_a, tau_detaches, rests, u_end = np.moveaxis(numbers.reshape(*shape, 7), -1, 0).copy()
    flags = {"detaches": ~np.isnan(tau_detaches), "rests": rests == 1, "status": status.reshape(shape)}
    found = {"A": A, "tau_A": tau_A, "a_max": a_max, "tau_a": tau_a, "tau_detaches": tau_detaches, "u_end": u_end}
    return {**found, **{name: values.astype(np.int8) for name, values in flags.items()}}


def _columns(values: Sequence[Any], count: int) -> Floats:
    """Numbers of so many designs, a row for each."""
    return np.array([np.broadcast_to(value, count) for value in values], dtype=float).reshape(-1, count).T


def _alone(
    designs: Designs,
    off_centre: OffCentres,
    values: dict[str, float],
    arcs: Floats,
    begin: float,
    after: float,
) -> tuple[Status, tuple[float, ...]]:
    """The status and the numbers of one design, by `transient`."""
    none = (np.nan,) * 7
    try:
        model = designs.model(values)
        force = followed(Force.of(designs.mechanism, model.parameters), designs.mechanism.name)
        laws: dict[str, Any] = {"c_2": model.laws.c_2, "released": model.laws.rubs != THROUGHOUT}
        system = EquationOfMotion(force, model.mu, model.zeta, **laws)
        # off the centre nothing is averaged of some forces, of which nothing is asked where the mass rests at u = 0
        centred = system.centred and questions.rests_at_centre(system)
        at = 0.0 if centred else questions.at_rest(off_centre(model, 0.0), system)[0]
        found = transient(system, arcs, begin=begin, after=after, at=at)
    except ValueError:
        return Status.INVALID, none
    except ArithmeticError:
        return Status.UNRESOLVED, none
    left = np.nan if found.tau_detaches is None else found.tau_detaches
    return Status.OK, (found.A, found.tau_A, found.a_max, found.tau_a, left, float(found.rests), found.u_end)
