"""Averages that are integrals over the quarter cycle: in go amplitudes and parameters, out come what C sums.

They are summed by Gauss's rule, piece by piece (src/slowflow/native/quarter.h), by a record that was compiled for the
force, or that interprets the program beside the module that asks.
"""

from __future__ import annotations

import json
import sys
from array import array
from collections.abc import Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from slowflow_support.backend import loaded
from slowflow_support.errors import NotSettled, Refused

UNSETTLED = (
    "the average at A = {:.17g} does not settle: the force is all but singular there, or a difference in which its "
    "digits are lost; what lies beyond a `reach` that is stated with it is not asked for"
)
NO_PROGRAM = "{} has averages by quadrature, and no program beside it that can be interpreted"

#: records by the names of modules whose averages are quadratures
RECORDS: dict[str, Any] = {}


def interpreted(module: ModuleType) -> Any:
    """A record from the program beside a mechanism's module; None where there is none, or the force has no room."""
    place = Path(module.__file__ or "").with_suffix(".json")
    if not place.exists():
        return None
    program = json.loads(place.read_text())
    lists = array("i", program["words"]).tobytes(), array("d", program["numbers"]).tobytes()
    return loaded("slowflow._native").program(module.MECHANISM.name, *lists)


def over_quarter(module: str, outputs: int, A: Any, parameters: Sequence[Any]) -> tuple[Any, ...]:
    """Averages of a module's force at A and parameters that broadcast, those that `averages` in C has so many of.

    Raises ArithmeticError where a sum does not settle: the force is all but singular; ValueError without a record.
    """
    if outputs == 0:  # slopes by parameters, of a force that has none
        return ()
    if module not in RECORDS:
        RECORDS[module] = interpreted(sys.modules[module])
    if RECORDS[module] is None:
        raise Refused(NO_PROGRAM.format(module))
    averages = loaded("slowflow._native").averages
    A, *given = np.broadcast_arrays(*(np.asarray(one, dtype=float) for one in (A, *parameters)))
    amplitudes, rows = A.ravel(), np.reshape([one.ravel() for one in given], (len(given), A.size))
    found = np.empty((outputs, A.size))
    if A.size and not any(np.ndim(one) for one in parameters):
        averages(RECORDS[module], tuple(rows[:, 0].tolist()), amplitudes, found)
    else:
        for k, numbers in enumerate(rows.T.tolist()):
            averages(RECORDS[module], tuple(numbers), amplitudes[k : k + 1], one := np.empty((outputs, 1)))
            found[:, k] = one[:, 0]
    lost = np.isnan(found).any(axis=0) & np.isfinite(amplitudes) & np.isfinite(rows).all(axis=0)
    if lost.any():
        raise NotSettled(UNSETTLED.format(amplitudes[lost][0]))
    return tuple(found.reshape(outputs, *A.shape)[()])
