"""The compiled code, and what it takes. Takes mechanisms and numbers; returns records and oscillators.

KERNELS   compiled kernels (slowflow_kernels._native)
SOLVER    compiled solvers (slowflow._native)
EXACT     the compiled equation of motion (slowflow._exact)
record_of, parameters_of, compiled_model   what the solvers take: a mechanism's record, and one oscillator
"""

from __future__ import annotations

import sys
from types import ModuleType
from typing import Any

import numpy as np

from slowflow import callbacks
from slowflow.support.backend import NATIVE, loaded
from slowflow.support.errors import Refused
from slowflow.support.quadrature import RECORDS, interpreted
from slowflow.support.record import Mechanism, stated_by_module

ENCLOSED = "{}: enclosed is not allowed in a record that is typed: only what is derived is known on intervals"
NO_ROOM = (
    "{} is not allowed: its force has {} numbers of a design (at most {}), {} parameters (at most {}) and {} "
    "breakpoints (at most {})"
)
TOO_LONG = "{} is not allowed: its formulas are too long to be interpreted; with compile = True they are compiled"


KERNELS: Any = NATIVE
SOLVER: Any = loaded("slowflow._native")
EXACT: Any = loaded("slowflow._exact")


def record_of(mechanism: Mechanism, inertial: bool = False, laws: bool = False) -> Any:
    """The compiled record of a mechanism, None where there is none of this very one.

    inertial -- whether it is excited by inertia
    laws     -- whether it takes other laws of damping: mu, zeta, eta, c_2, and whether friction ends at a breakpoint
    """
    if not mechanism.is_generated:
        return None
    if mechanism.name not in SOLVER.RECORDS:
        SOLVER.RECORDS[mechanism.name] = _interpreted(mechanism)
    record = SOLVER.RECORDS[mechanism.name]
    if record is None:
        return None
    record = SOLVER.inertial(record) if inertial else record
    return SOLVER.with_laws(record) if laws else record


def check_room(mechanism: Mechanism, *, interpreted: bool = True) -> None:
    """Raises ValueError for an odd force beyond what the compiled solvers have room for.

    interpreted -- whether its programs have to be read too
    """
    if not mechanism.odd:
        return
    sizes = len(mechanism.design), len(mechanism.parameters), len(mechanism.pieces) - 1
    pairs = tuple(zip(sizes, SOLVER.MOST, strict=True))
    if any(size > most for size, most in pairs):
        raise Refused(NO_ROOM.format(mechanism.name, *(number for pair in pairs for number in pair)))
    if interpreted and mechanism.is_generated and record_of(mechanism) is None:
        raise Refused(TOO_LONG.format(mechanism.name))


def _interpreted(mechanism: Mechanism) -> Any:
    """A record from the program beside the mechanism's module; None where there is none, or the force has no room."""
    module = sys.modules[mechanism.pieces[0].force.__module__]
    record = interpreted(module)
    if record is not None:
        sum_in_C(module, record)
    return record


def sum_in_C(module: ModuleType, record: Any) -> None:
    """Lets a record answer for its module's averages where these are quadratures."""
    RECORDS[module.__name__] = record


def parameters_of(mechanism: Mechanism, design: tuple[float, ...]) -> tuple[float, ...]:
    """The parameters of a design within its domain, from the compiled record where there is one.

    A difference of nearly equal numbers, as a stiffness next to 0, has a double's digits: from the record's pairs.
    """
    record = record_of(mechanism)
    if record is not None:
        found: tuple[float, ...] = SOLVER.parameters_of(record, design)
        return found
    with np.errstate(all="ignore"):
        return tuple(map(float, mechanism.coefficients(*design)))


def compiled_model(
    mechanism: Mechanism,
    parameters: tuple[float, ...],
    damping: tuple[float, ...],
    design: tuple[float, ...],
    inertial: bool,
) -> Any:
    """One oscillator as the compiled solvers take it, None where they have no record of its mechanism, or refuse it."""
    laws = len(damping) > 2
    if mechanism.samples is not None:
        record = SOLVER.samples(mechanism.name, *mechanism.samples(*parameters), inertial, laws)
    elif mechanism.odd and not mechanism.is_generated:
        stated = stated_by_module(mechanism)
        derived = stated is not None and mechanism.enclosed == stated.enclosed
        if mechanism.enclosed is not None and not derived:
            raise Refused(ENCLOSED.format(mechanism.name))
        check_room(mechanism)
        bounds = None if mechanism.enclosed is None or stated is None else record_of(stated)
        record = callbacks.record(SOLVER, mechanism, inertial, laws, bounds)
    else:
        record = record_of(mechanism, inertial, laws)
    if record is None:
        check_room(mechanism)
        return None
    return SOLVER.model(record, parameters, damping, design)
