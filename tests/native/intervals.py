"""The interval arithmetic of the solvers as Python functions: a directory for the shared library in, callables out."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tests.native.roots import FLAGS, HERE, INCLUDES

ELEMENTARY = (
    *("exp", "log", "root", "cbrt", "sin", "cos", "tan", "sinh", "cosh", "tanh"),
    *("asin", "acos", "atan", "asinh", "acosh", "atanh", "log1p", "power"),
)
OPERATIONS = ("add", "sub", "mul", "div", "square", "sqrt", "atan2", "tenth")
#: on pairs that know how far they may be off
HELD = (*OPERATIONS, "R_F", "R_D")


LIBRARY = "intervals.so"


def build(directory: Path) -> None:
    """The shared library, for one worker of a test run or several."""
    # arithmetic is strict: -O1 gives the same digits as -O3, which takes twice the time
    command = ["gcc", "-std=c11", *FLAGS, "-O1", *INCLUDES, "-shared", "-fPIC"]
    done = subprocess.run(
        [*command, str(HERE / "intervals_driver.c"), "-o", str(directory / LIBRARY), "-lm"],
        capture_output=True,
        text=True,
    )
    if done.returncode:
        raise RuntimeError(done.stderr)


class Intervals:
    """operate(name, pairs of intervals (n, 4)), operate_held, known(mechanism, design, piece, beyond)."""

    def __init__(self, directory: Path) -> None:
        self.loaded = ctypes.CDLL(str(directory / LIBRARY))

    def operate(self, name: str, pairs: np.ndarray) -> np.ndarray:
        pairs = np.ascontiguousarray(pairs, dtype=np.float64)
        out = np.empty((len(pairs), 2))
        self.loaded.operate(
            (*OPERATIONS, *ELEMENTARY).index(name), ctypes.c_long(len(pairs)), _pointer(pairs), _pointer(out)
        )
        return out

    def operate_held(self, name: str, numbers: np.ndarray) -> np.ndarray:
        """Three numbers (n, 9), each a pair and what it may be off, to one with the doubles around it (n, 5)."""
        numbers = np.ascontiguousarray(numbers, dtype=np.float64)
        out = np.empty((len(numbers), 5))
        self.loaded.operate_held(HELD.index(name), ctypes.c_long(len(numbers)), _pointer(numbers), _pointer(out))
        return out

    def known(self, mechanism: str, design: Sequence[float], piece: int, beyond: float) -> np.ndarray:
        out, numbers = np.empty((6, 2)), np.array(design, dtype=np.float64)
        if not self.loaded.known(mechanism.encode(), _pointer(numbers), piece, ctypes.c_double(beyond), _pointer(out)):
            raise ValueError(f"no intervals for {mechanism}")
        return out


def _pointer(array: np.ndarray) -> Any:
    return array.ctypes.data_as(ctypes.c_void_p)
