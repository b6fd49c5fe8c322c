"""Answers of designs abreast, on NumPy: in go designs of one kind and what is asked, out come the columns of a batch.

Each entry is what `slowflow.averaged.asked` makes of a single answer by doubles, to the last bit.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from slowflow.averaged import remarks
from slowflow.averaged.asked import MOST_COUNTED, onset_in_columns, states_in_places
from slowflow.averaged.reference import steps
from slowflow.averaged.reference.abreast import Abreast
from slowflow.averaged.reference.bounds import amplitude_bounds
from slowflow.averaged.reference.folds import folds_abreast
from slowflow.averaged.reference.intervals import Bools
from slowflow.averaged.reference.onset import onset_in_steps, peaks_abreast
from slowflow.averaged.reference.response import amplitudes_in_steps
from slowflow.model import Floats
from slowflow_kernels.conventions import FoldKind, Status

Columns = tuple[Any, ...]


def saddle_nodes(model: Abreast, F_0: Floats, places: int) -> Columns:
    """Every fold at F_0 > m of each."""
    A_max, bounded = _bounds(model, F_0)
    found = folds_abreast(model, F_0, A_max)
    number = np.bincount(found.of, minlength=model.abreast)
    status = _status(bounded, found.given_up | (number > MOST_COUNTED), number > places, Status.TOO_MANY)
    answered = (status == Status.OK) | (status == Status.TOO_MANY)
    place = np.arange(found.of.size) - (np.cumsum(number) - number)[found.of]
    kept = (place < places) & answered[found.of]
    at = found.of[kept], place[kept]
    Omega, A = np.full((2, model.abreast, places), np.nan)
    kind = np.zeros((model.abreast, places), np.int8)
    Omega[at], A[at] = found.Omega[kept], found.A[kept]
    inside = np.where(found.up, FoldKind.JUMP_UP, FoldKind.JUMP_DOWN)
    on_corner = np.where(found.up, FoldKind.JUMP_UP_AT_CORNER, FoldKind.JUMP_DOWN_AT_CORNER)
    kind[at] = np.where(found.corner, on_corner, inside)[kept]
    return Omega, A, kind, np.where(answered, number, 0), found.undecided & answered, status


def onset(model: Abreast, _: int) -> Columns:
    """F_SN of each."""
    return _columns(steps.together(model, [onset_in_steps(one) for one in model.each]), onset_in_columns)


def amplitudes(model: Abreast, F_0: Floats, Omega: Floats, places: int) -> Columns:
    """Every steady state at (Omega, F_0), F_0 > m, of each."""
    asked = zip(model.each, Omega[:, np.newaxis], F_0.tolist(), strict=True)
    found = steps.together(model, [amplitudes_in_steps(*one) for one in asked])
    A, stable, *rest = map(np.array, _columns(found, lambda one: states_in_places(one, places)))
    kept, beyond = remarks.look_at(model.mechanism, model.parameters, Omega[:, np.newaxis], A)
    return A, stable & kept & ~beyond, *rest


def _columns(found: Sequence[Any], told: Callable[[Any], Columns]) -> Columns:
    """What is told of each answer; of one that is not found, what is of None, and why."""
    blank = told(None)[:-1]

    def row(one: Any) -> Columns:
        if not isinstance(one, ArithmeticError):
            return told(one)
        return *blank, Status.NO_BOUND if isinstance(one, OverflowError) else Status.UNRESOLVED

    return tuple(zip(*map(row, found), strict=True))


def peak(model: Abreast, F_0: Floats, _: int) -> Columns:
    """The highest peak at F_0 > m of each; `Status.NONE` where nothing ends the response, as of the solvers in C."""
    none = np.full(model.abreast, np.nan)
    if model.undamped:
        return none, none, np.full(model.abreast, Status.UNBOUNDED)
    A_max, bounded = _bounds(model, F_0)
    A, Omega, given_up = peaks_abreast(model, F_0, A_max)
    status = _status(bounded, given_up, np.isnan(A), Status.NONE)
    return *(np.where(status == Status.OK, value, np.nan) for value in (A, Omega)), status


def _bounds(model: Abreast, F_0: Floats) -> tuple[Floats, Bools]:
    """How far each is looked at, and whether that bounds its states: where it does not the answer is none."""
    A_max = np.array([A_max for A_max, _ in amplitude_bounds(model, F_0)])
    bounded = A_max < np.inf
    return np.where(bounded, A_max, F_0), bounded


def _status(bounded: Bools, given_up: Bools, other: Bools, otherwise: Status) -> Any:
    """Of each, why it has no answer."""
    status = np.where(given_up, Status.UNRESOLVED, np.where(other, otherwise, Status.OK))
    return np.where(bounded, status, Status.NO_BOUND)
