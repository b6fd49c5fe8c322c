"""Random vibration of many designs. Takes their arrays and an excitation; returns all stationary motions of each."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow.answers.table import AVERAGING, OFFSET, QUESTIONS
from slowflow.averaged.batches import Batch
from slowflow.averaged.chunks import blocks, map_chunks
from slowflow.averaged.many import Designs, failed
from slowflow.core import validate
from slowflow.core.backend import EXACT
from slowflow.core.mechanism import Floats, by_piece
from slowflow.core.model import THROUGHOUT
from slowflow.exact.motion import design_rows, recurrences, system_of
from slowflow.random_vibration.excitation import White
from slowflow.random_vibration.questions import (
    NUMBERS,
    NUMBERS_OF_MOTION,
    Diagnostics,
    columns,
    diagnostics,
    diagnostics_of_one,
    excited_by,
    is_damped,
    stationary,
)
from slowflow.support import progress
from slowflow_kernels.conventions import Status

#: designs in a chunk, whose arrays stay in the processor's cache
CHUNK = 2**12


def answer(designs: Designs, S_0: Any, psd: Any, max_count: int, workers: int = 1) -> Batch:
    """See `random` of `slowflow.answers.table.ManyQuestions`."""
    validate.is_in_time("random", designs.values)
    released = designs.contact != THROUGHOUT
    excitation = excited_by(None if S_0 is None else 1.0, psd)
    max_count, threads = validate.count("max_count", max_count, least=1), validate.workers(workers)
    power = {} if S_0 is None else {"S_0": validate.real_array("S_0", S_0)}
    numbers = {**designs.values, **power}
    shape = validate.common_shape(numbers)
    own = {name: np.broadcast_to(value, shape).ravel().astype(float) for name, value in numbers.items()}
    found = QUESTIONS["random"].blank(AVERAGING, own["mu"].shape, place=max_count)
    (status := found["status"])[...] = Status.INVALID
    remarks = np.zeros(status.shape, np.uint16)
    valid = np.broadcast_to(_are_designs(designs, workers), shape).ravel()
    valid = valid & np.isfinite(own.get("load", 0.0))
    valid &= is_damped(own["mu"], own["zeta"], own.get("c_2", 0.0), released, S_0 is not None)
    if S_0 is not None:
        valid &= np.isfinite(own["S_0"]) & (own["S_0"] > 0)
    laws = tuple(recurrences(law) for law in designs.mechanism.pieces)
    odd = designs.mechanism.odd and None not in laws
    together = valid & (_stiffness_is_finite(designs.mechanism, own) if odd else False)

    def solve(part: tuple[Any, ...]) -> None:
        chunk = batched[part]
        motions, count = np.full((chunk.size, max_count, NUMBERS), np.nan), np.empty(chunk.size, np.int8)
        some = {name: value[chunk] for name, value in own.items()}
        some["released"] = np.full(chunk.size, released)
        constants, ends, damping = design_rows(designs.mechanism, some, NUMBERS_OF_MOTION)
        power, table = (b"", excitation.for_C) if S_0 is None else (np.pi * some["S_0"], b"")
        EXACT.stationary_of_each(laws, constants, ends, damping, power, table, count, motions)
        first = np.where(ends > 0, ends, np.inf).min(axis=1, initial=np.inf, keepdims=True)
        most = min(max(int(count.max()), 1), max_count)  # most designs have one motion
        with np.errstate(invalid="ignore"):  # empty places
            values = columns(motions[:, :most], (-first, first))
            force = functools.partial(_force, designs.mechanism, constants.T, ends.T)
            remarks[chunk] = _codes(diagnostics(force, list(damping.T), True, excitation, values, count), chunk.size)
        for name, value in values.items():
            found[name][chunk, :most] = value
        found["count"][chunk] = np.maximum(count, 0)
        status[chunk] = np.where(count > max_count, Status.TOO_MANY, np.where(count > 0, Status.OK, Status.UNRESOLVED))

    batched = np.flatnonzero(together)
    map_chunks(solve, blocks(batched.shape, CHUNK), threads, lambda part: batched[part].size, batched.size)
    singly = np.flatnonzero(valid & ~together).tolist()
    for k in progress.each(singly, len(singly), "designs asked singly"):
        one = {name: float(own[name][k]) for name in designs.values}
        try:
            of_one = excitation if S_0 is None else White(float(own["S_0"][k]))
            own_system = system_of(designs, one, one.get("load", 0.0))
            motions = stationary(own_system, of_one)
        except (ValueError, ArithmeticError) as error:
            status[k] = failed(error)
            continue
        found["count"][k] = count = motions["u_rms"].size
        remarks[k] = _codes(diagnostics_of_one(own_system, of_one, motions), 1)
        status[k] = Status.TOO_MANY if count > max_count else Status.OK
        for name, value in motions.items():
            found[name][k, :count] = value[:max_count]
    found = {name: value.reshape((*shape, *value.shape[1:])) for name, value in found.items()}
    system = OFFSET if "load" in designs.values else AVERAGING
    return Batch("random", found, designs, power, system, remarks=remarks.reshape(shape))


def _codes(found: Diagnostics, count: int) -> npt.NDArray[np.uint16]:
    """Codes that add up, of so many designs."""
    remarks = np.zeros(count, np.uint16)
    for remark, holds, _, _ in found:
        remarks |= np.where(holds, np.uint16(remark), np.uint16(0))
    return remarks


def _force(mechanism: Any, parameters: Floats, ends: Floats, u: Floats) -> Floats:
    """The odd force of designs, (numbers, n), at displacements, (n, motions, places)."""
    of_each, to_each = ([one[:, np.newaxis, np.newaxis] for one in numbers] for numbers in (parameters, ends))
    return np.asarray(np.sign(u) * by_piece(mechanism.pieces, to_each, np.abs(u), of_each))


def _are_designs(designs: Designs, workers: int) -> Any:
    """Whether the numbers are within their domains; of an asymmetric force that is found out singly."""
    if not designs.mechanism.odd:
        return True
    numbers = {name: value for name, value in designs.values.items() if name != "load"}
    centred = Designs(designs.mechanism, numbers, designs.excitation, designs.contact)
    return centred.detachment(workers=workers).status != Status.INVALID


def _stiffness_is_finite(mechanism: Any, values: dict[str, Floats]) -> Any:
    """At u = 0, of each design: the others are refused singly."""
    with np.errstate(all="ignore"):  # what is no design
        return np.isfinite(
            mechanism.at_rest(*mechanism.coefficients(*(values[one] for one in mechanism.design_names)))[1]
        )
