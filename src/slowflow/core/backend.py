"""The compiled code, and what it takes. Takes mechanisms and numbers; returns records and oscillators.

KERNELS   compiled kernels (slowflow_kernels._native)
SOLVER    compiled solvers (slowflow._native)
EXACT     the compiled equation of motion (slowflow._exact)
record_of, parameters_of, compiled_model   what the solvers take: a mechanism's record, and one oscillator
"""

from __future__ import annotations

import contextlib
import ctypes
import sys
from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np

from slowflow.support import quadrature
from slowflow.support.backend import NATIVE, loaded
from slowflow.support.errors import Refused
from slowflow.support.record import Mechanism, stated_by_module

ENCLOSED = "{}: enclosed is not allowed in a hand-written record: only derived forces have enclosures"
NO_ROOM = (
    "{} is not allowed: its force has {} design parameters (at most {}), {} parameters (at most {}) and {} "
    "breakpoints (at most {})"
)
TOO_LONG = "{} is not allowed: its formulas are too long to be interpreted; with compile = True they are compiled"


KERNELS: Any = NATIVE
SOLVER: Any = loaded("slowflow._native")
EXACT: Any = loaded("slowflow._exact")


def record_of(mechanism: Mechanism, inertial: bool = False, laws: bool = False) -> Any:
    """The compiled record of a mechanism, None where there is none of this very one.

    inertial -- whether it is excited by inertia
    laws     -- whether it takes other laws of damping: mu, zeta, those of `DISSIPATION`, whether friction ends
    """
    if not mechanism.is_generated:
        return None
    record = quadrature.record_of(sys.modules[mechanism.pieces[0].force.__module__])
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
        record = SOLVER.record(True, mechanism.name, *mechanism.samples(*parameters), inertial, laws)
    elif mechanism.odd and not mechanism.is_generated:
        stated = stated_by_module(mechanism)
        derived = stated is not None and mechanism.enclosed == stated.enclosed
        if mechanism.enclosed is not None and not derived:
            raise Refused(ENCLOSED.format(mechanism.name))
        check_room(mechanism)
        bounds = None if mechanism.enclosed is None or stated is None else record_of(stated)
        record = _calling(mechanism, inertial, laws, bounds)
    else:
        record = record_of(mechanism, inertial, laws)
    if record is None:
        check_room(mechanism)
        return None
    return SOLVER.model(record, parameters, damping, design)


_Doubles = ctypes.POINTER(ctypes.c_double)
#: of the record, the parameters and what is filled
_OF_FORCE = ctypes.CFUNCTYPE(None, ctypes.c_void_p, _Doubles, _Doubles)
#: of the record, a number of amplitudes, these, the parameters and what is filled
_PER_AMPLITUDE = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_ssize_t, _Doubles, _Doubles, _Doubles)
#: of the record, an amplitude and the parameters
_AT = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_void_p, ctypes.c_double, _Doubles)
#: mechanisms whose records are kept
KEPT = 64


@lru_cache(KEPT)
def _calling(mechanism: Mechanism, inertial: bool, laws: bool, enclosed: Any) -> Any:
    """The record of an odd force whose averages are Python functions, which it keeps: searches call them.

    Such a mechanism is typed by hand, or a generated one with something replaced: what is compiled is not its own. What
    the compiled solvers ask of the force they ask Python for, some microseconds each time.

    enclosed -- the record whose bounds between two amplitudes hold for it, None where it needs none
    """
    size = len(mechanism.parameters)
    breakpoints = len(mechanism.pieces) - 1

    def of_force(function: Callable[..., Any]) -> Any:
        def fill(_: Any, p: Any, out: Any) -> None:
            for k, value in enumerate(function(*p[:size])):
                out[k] = value

        return _OF_FORCE(fill)

    def per_amplitude(function: Callable[..., Any], rows: int) -> Any:
        def fill(_: Any, n: int, A: Any, p: Any, out: Any) -> None:
            if n > 0:
                whole = np.ctypeslib.as_array(out, (rows, n))
                whole[:] = np.nan
                # what is not known stays NaN
                with np.errstate(all="ignore"), contextlib.suppress(ArithmeticError):
                    for row, values in zip(whole, function(np.array(A[:n]), *p[:size]), strict=False):
                        row[:] = values

        return _PER_AMPLITUDE(fill)

    def intercept(_: Any, A: float, p: Any) -> float:
        with np.errstate(all="ignore"), contextlib.suppress(ArithmeticError):
            return float(mechanism.intercept(A, *p[:size]))
        return np.nan

    functions = {
        "ends": of_force(mechanism.breakpoints),
        "jumps": of_force(mechanism.jumps),
        "kinks": None if mechanism.kinks is None else of_force(mechanism.kinks),
        "averaged": per_amplitude(mechanism.averaged, 4),
        "averaged_2": per_amplitude(mechanism.averaged, 2),
        "intercept": _AT(intercept),
        "harmonics": per_amplitude(mechanism.harmonics, 8),
    }
    addresses = tuple(0 if one is None else ctypes.cast(one, ctypes.c_void_p).value for one in functions.values())
    sizes = len(mechanism.design), size, breakpoints
    reach, up_to = mechanism.reach, mechanism.harmonics_up_to
    return SOLVER.called(mechanism.name, sizes, reach, up_to, addresses, functions, inertial, laws, enclosed)
