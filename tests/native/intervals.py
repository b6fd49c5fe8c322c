"""The arithmetics of the solvers as Python functions, intervals and double-double: a directory for the library in."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import flint
import numpy as np

from tests.native.compiler import HERE, ROOT, STRICT, compiled, pointer
from tests.native.headers import expanded

ELEMENTARY = (
    *("exp", "log", "root", "cbrt", "sin", "cos", "tan", "sinh", "cosh", "tanh"),
    *("asin", "acos", "atan", "asinh", "acosh", "atanh", "log1p", "power"),
)
#: on balls
EXACT = {
    "add": lambda x, y, *_: x + y,
    "sub": lambda x, y, *_: x - y,
    "mul": lambda x, y, *_: x * y,
    "div": lambda x, y, *_: x / y,
    "square": lambda x, *_: x * x,
    "sqrt": lambda x, *_: x.sqrt(),
    "atan2": lambda x, y, *_: flint.arb.atan2(x, y),
    "tenth": lambda x, *_: flint.arb(0.1) * x,
    "R_F": lambda *xyz: flint.acb.elliptic_rf(*xyz).real,
    "R_D": lambda *xyz: flint.acb.elliptic_rd(*xyz).real,
}
#: all of them on pairs that know how far they may be off, others on all
BOUNDED = tuple(EXACT)
OPERATIONS = BOUNDED[:-2]


class Arithmetic:
    """operate(name, numbers (n, ...)) and known(mechanism, design, piece, at): a number is two doubles."""

    driver: str
    operations: tuple[str, ...]
    #: how many averages there are
    averages: int

    def __init__(self, directory: Path) -> None:
        self.loaded = ctypes.CDLL(str(directory / f"{self.driver}.so"))

    @classmethod
    def build(cls, directory: Path) -> None:
        """The shared library, for one worker of a test run or several."""
        compiled(directory / f"{cls.driver}.so", HERE / f"{cls.driver}_driver.c", options=STRICT)

    def _filled(self, function: str, number: int, numbers: np.ndarray, width: int) -> np.ndarray:
        rows, out = np.ascontiguousarray(numbers, dtype=np.float64), np.empty((len(numbers), width))
        getattr(self.loaded, function)(number, ctypes.c_long(len(rows)), pointer(rows), pointer(out))
        return out

    def operate(self, name: str, numbers: np.ndarray) -> Any:
        return self._filled("operate", self.operations.index(name), numbers, 2)

    def known(self, mechanism: str, design: Sequence[float], piece: int, at: float) -> Any:
        out, numbers = np.empty((self.averages, 2)), np.array(design, dtype=np.float64)
        if not self.loaded.known(mechanism.encode(), pointer(numbers), piece, ctypes.c_double(at), pointer(out)):
            raise ValueError(f"no {self.driver} for {mechanism}")
        return out


class Intervals(Arithmetic):
    """Two intervals in a row; averages at a piece and how far beyond its begin."""

    driver, operations, averages = "intervals", (*OPERATIONS, *ELEMENTARY), 6

    def operate_bounded(self, name: str, numbers: np.ndarray) -> np.ndarray:
        """Three numbers (n, 9), each a pair and what it may be off, to one with the doubles around it (n, 5)."""
        return self._filled("operate_bounded", BOUNDED.index(name), numbers, 5)


class Pairs(Arithmetic):
    """Two double-double numbers in a row; averages at an amplitude. Both are returned as fractions."""

    driver, operations, averages = "pairs", OPERATIONS, 4

    def operate(self, name: str, numbers: np.ndarray) -> list[Fraction]:
        return exactly(super().operate(name, numbers))

    def known(self, mechanism: str, design: Sequence[float], piece: int, at: float) -> list[Fraction]:
        return exactly(super().known(mechanism, design, piece, at))


def exactly(pairs: np.ndarray) -> list[Fraction]:
    """Their sums."""
    return [Fraction(high) + Fraction(low) for high, low in pairs.tolist()]


#: generated functions on intervals: what they return, the module, their names, arguments
PROTOTYPE = re.compile(r"^static inline (sf_interval|void) (\w+_intervals)_(\w+)\(([^)]*)\) \{$", re.MULTILINE)
MOST_OUTPUTS = 24


def prototypes(modules: Sequence[str]) -> dict[tuple[str, str], tuple[int, bool]]:
    """By module and function, of those that take intervals alone: how many, and whether an array takes the outputs."""
    found = {}
    for module in modules:
        text = expanded(ROOT / "generated" / "native" / f"{module}.h", "static inline", "sf_interval")
        for returned, prefix, name, arguments in PROTOTYPE.findall(text):
            declared = [one.split() for one in arguments.split(", ")]
            if prefix == module and all(kind == "sf_interval" for kind, _ in declared):
                fills = returned == "void"
                found[module, name] = len(declared) - fills, fills
    return found


def build_generated(directory: Path, modules: Sequence[str]) -> None:
    """The shared library of all generated functions on intervals of these modules."""
    lines = [f'#include "{header}"' for header in ("interval.h", *(f"{module}.h" for module in modules))]
    for (module, name), (count, fills) in prototypes(modules).items():
        call = f"{module}_{name}({', '.join(f'in[{k}]' for k in range(count))}"
        body = f"{call}, out);" if fills else f"out[0] = {call});"
        lines.append(f"void called_{module}_{name}(const sf_interval *in, sf_interval *out) {{ {body} }}")
    source = directory / "generated_intervals.c"
    source.write_text("\n".join(lines) + "\n", encoding="utf-8")
    compiled(directory / "generated_intervals.so", source, options=STRICT)


def generated(directory: Path) -> Any:
    """(module, function, boxes (arguments, 2)) -> intervals (outputs, 2), NaN behind the last."""
    loaded = ctypes.CDLL(str(directory / "generated_intervals.so"))

    def called(module: str, name: str, boxes: Any) -> np.ndarray:
        rows = np.ascontiguousarray(boxes, dtype=np.float64)
        out = np.full((MOST_OUTPUTS, 2), np.nan)
        getattr(loaded, f"called_{module}_{name}")(pointer(rows), pointer(out))
        return out

    return called
