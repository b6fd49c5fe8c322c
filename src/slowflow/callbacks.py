"""Records of forces whose averages are Python functions. Takes a mechanism; returns a record that calls them.

Such a mechanism is typed by hand, or a generated one with something replaced: what is compiled is not its own. The
compiled solvers search all the same; what they ask of the force they ask Python for, some microseconds each time.
"""

from __future__ import annotations

import contextlib
import ctypes
from collections.abc import Callable
from functools import lru_cache
from types import ModuleType
from typing import Any

import numpy as np

from slowflow.support.record import Mechanism

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
def record(solver: ModuleType, mechanism: Mechanism, inertial: bool, laws: bool, enclosed: Any) -> Any:
    """The record of an odd force, which keeps its functions.

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
    return solver.called(mechanism.name, sizes, reach, up_to, addresses, functions, inertial, laws, enclosed)
