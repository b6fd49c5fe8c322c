"""The solvers' double-double arithmetic as Python functions: a directory for the shared library in, callables out."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path

import numpy as np

from tests.native.compiler import HERE, STRICT, compiled, pointer

OPERATIONS = ("add", "sub", "mul", "div", "square", "sqrt", "atan2", "tenth")
LIBRARY = "pairs.so"


def build(directory: Path) -> None:
    """The shared library, for one worker of a test run or several."""
    compiled(directory / LIBRARY, HERE / "pairs_driver.c", options=STRICT)


class Pairs:
    """operate(name, two pairs (n, 4)) and known(mechanism, design, piece, A), each number a pair."""

    def __init__(self, directory: Path) -> None:
        self.loaded = ctypes.CDLL(str(directory / LIBRARY))

    def operate(self, name: str, pairs: np.ndarray) -> list[Fraction]:
        pairs = np.ascontiguousarray(pairs, dtype=np.float64)
        out = np.empty((len(pairs), 2))
        self.loaded.operate(OPERATIONS.index(name), ctypes.c_long(len(pairs)), pointer(pairs), pointer(out))
        return [Fraction(high) + Fraction(low) for high, low in out.tolist()]

    def known(self, mechanism: str, design: Sequence[float], piece: int, A: float) -> list[Fraction]:
        out, numbers = np.empty((4, 2)), np.array(design, dtype=np.float64)
        if not self.loaded.known(mechanism.encode(), pointer(numbers), piece, ctypes.c_double(A), pointer(out)):
            raise ValueError(f"no pairs for {mechanism}")
        return [Fraction(high) + Fraction(low) for high, low in out.tolist()]
