"""Records of mechanisms as Python sees them: a capsule or a C source in, its numbers and functions out."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tests.native.compiler import FLAGS, HERE, WARNINGS, compiled

Doubles = ctypes.POINTER(ctypes.c_double)
#: functions of the force take the record first
Self = ctypes.c_void_p
FromNumbers = ctypes.CFUNCTYPE(ctypes.c_int, Doubles, Doubles)
FromDesign = ctypes.CFUNCTYPE(ctypes.c_int, Self, Doubles, Doubles)
Fill = ctypes.CFUNCTYPE(None, Self, Doubles, Doubles)
Averages = ctypes.CFUNCTYPE(None, Self, ctypes.c_ssize_t, Doubles, Doubles, Doubles)
NAME = b"slowflow.core.mechanism"


class Interval(ctypes.Structure):
    """sf_interval"""

    _fields_ = (("lo", ctypes.c_double), ("hi", ctypes.c_double))


Bent = ctypes.CFUNCTYPE(None, Self, Interval, Doubles, ctypes.POINTER(Interval))


class Mechanism(ctypes.Structure):
    """sf_mechanism of src/slowflow/native/mechanism.h"""

    _fields_ = (
        ("form", ctypes.c_int),
        ("name", ctypes.c_char_p),
        *((name, ctypes.c_int) for name in ("design_size", "damping_size", "parameters", "breakpoints")),
        ("reach", ctypes.c_double),
        ("parameters_of", FromDesign),
        ("damping_of", FromNumbers),
        ("is_forcing", ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_double)),
        ("ends", Fill),
        ("jumps", Fill),
        ("kinks", Fill),
        ("averaged", Averages),
        ("averaged_2", Averages),
        ("intercept", ctypes.c_void_p),
        ("bent", Bent),
        ("harmonics", ctypes.c_void_p),
        ("harmonics_up_to", ctypes.c_double),
        *((name, ctypes.c_void_p) for name in ("by_parameter", "by_design")),
        ("dissipation", ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double, ctypes.c_double, Doubles)),
        ("level", ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double, ctypes.c_double, Doubles, ctypes.c_double)),
        ("inertial", ctypes.c_int),
        ("mean_offset", ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double, Doubles)),
        *((name, ctypes.c_void_p) for name in ("parameters_within", "ends_within", "kinks_within", "averaged_within")),
        *((name, ctypes.c_void_p) for name in ("parameters_in_pairs", "ends_in_pairs", "averaged_in_pairs")),
        *((name, ctypes.c_void_p) for name in ("many_in_pairs", "on_first_end_in_pairs", "program")),
    )

    def ask(self, name: str, *arguments: Any) -> Any:
        """Calls a function of the force, which takes the record first."""
        return getattr(self, name)(ctypes.addressof(self), *arguments)


def build(directory: Path, options: Sequence[str] = ()) -> Any:
    """The record of own_record.c as a capsule, and the library that it lives in."""
    library = directory / f"own{len(list(directory.iterdir()))}.so"
    options = [*WARNINGS, "-std=c11", *FLAGS, *options]
    loaded = ctypes.CDLL(str(compiled(library, HERE / "own_record.c", options=options)))
    return capsule(ctypes.addressof(Mechanism.in_dll(loaded, "own_record")))


def capsule(address: int, name: bytes = NAME) -> Any:
    """A capsule around an address; neither it nor `name` is ever freed."""
    new = ctypes.pythonapi.PyCapsule_New
    new.restype, new.argtypes = ctypes.py_object, (ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p)
    return new(address, name, None)


def opened(record: Any) -> Mechanism:
    """What a capsule holds."""
    pointer = ctypes.pythonapi.PyCapsule_GetPointer
    pointer.restype, pointer.argtypes = ctypes.c_void_p, (ctypes.py_object, ctypes.c_char_p)
    return Mechanism.from_address(pointer(record, NAME))


def doubles(values: Sequence[float]) -> Any:
    """A C array."""
    return (ctypes.c_double * len(values))(*values)


def bent(record: Any, model: Any, low: float, high: float) -> Any:
    """h and h_AAAA between two amplitudes of a piece, as a record encloses them: (2, 2), lower and upper ends."""
    found = (Interval * 2)()
    opened(record).ask("bent", Interval(low, high), doubles(model.parameters), found)
    return np.array([(one.lo, one.hi) for one in found])
