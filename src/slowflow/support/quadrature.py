"""Averages that are integrals over the quarter cycle. Takes amplitudes and parameters; returns what C sums.

They are summed by Gauss's rule, piece by piece (src/slowflow/native/quarter.h), by a record that was compiled for the
force, or that interprets the program beside the module that asks.
"""

from __future__ import annotations

import sys
from array import array
from collections.abc import Sequence
from math import isfinite
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from slowflow.support.backend import loaded
from slowflow.support.errors import NotSettled, Refused

UNSETTLED = (
    "the average at A = {:.17g} does not converge: the force is nearly singular there, or a difference that loses its "
    "digits; a smaller `reach` ends the search before it"
)
NO_PROGRAM = "{} has averages by quadrature, and no program that can be interpreted"


def gauss(count: int) -> tuple[Any, Any]:
    """Nodes and weights of Gauss's rule on (0, 1)."""
    at, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * (1 + at), 0.5 * weights


def record_of(module: ModuleType) -> Any:
    """The compiled record of a module's mechanism, read from the program beside it where none was compiled.

    None where there is no program, or the force has no room. A module of one's own may state a name that is taken.
    """
    records, mechanism = loaded("slowflow._native").RECORDS, module.MECHANISM
    name = mechanism.name if mechanism.is_generated else module.__name__
    if name not in records:
        records[name] = _interpreted(module)
    return records[name]


def _interpreted(module: ModuleType) -> Any:
    place = Path(module.__file__ or "").with_suffix(".json")
    if not place.exists():
        return None
    import json  # here, not above: a force that is compiled needs no program

    program = json.loads(place.read_text())
    lists = array("i", program["words"]).tobytes(), array("d", program["numbers"]).tobytes()
    return loaded("slowflow._native").record(False, module.MECHANISM.name, *lists)


def averages(record: Any, numbers: tuple[float, ...], A: Any, outputs: int) -> Any:
    """Averages of a record's force at amplitudes of any shape, those that `averages` in C has so many of.

    Raises ArithmeticError where a sum does not settle: the force is all but singular.
    """
    A = np.asarray(A, dtype=float, order="C")
    found = np.empty((outputs, *A.shape))
    loaded("slowflow._native").averages(record, numbers, A, found)
    lost = np.isnan(found).any(axis=0) & np.isfinite(A) & all(map(isfinite, numbers))
    if lost.any():
        raise NotSettled(UNSETTLED.format(A[lost][0]))
    return found


def over_quarter(module: str, outputs: int, A: Any, parameters: Sequence[Any]) -> tuple[Any, ...]:
    """The averages of a module's force at A and parameters that broadcast. ValueError where it has no record."""
    if outputs == 0:  # slopes by parameters, of a force that has none
        return ()
    record = record_of(sys.modules[module])
    if record is None:
        raise Refused(NO_PROGRAM.format(module))
    if not any(np.ndim(one) for one in parameters):
        return tuple(averages(record, tuple(map(float, parameters)), A, outputs))
    arrays = np.broadcast_arrays(*(np.asarray(one, dtype=float) for one in (A, *parameters)))
    rows = zip(*(one.ravel().tolist() for one in arrays), strict=True)
    found = [averages(record, tuple(numbers), at, outputs) for at, *numbers in rows]
    return tuple(np.reshape(np.transpose(found), (outputs, *arrays[0].shape)))
