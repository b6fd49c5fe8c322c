"""The interval arithmetic of the solvers as Python functions: a directory for the shared library in, callables out."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tests.native.compiler import HERE, ROOT, STRICT, compiled, pointer

ELEMENTARY = (
    *("exp", "log", "root", "cbrt", "sin", "cos", "tan", "sinh", "cosh", "tanh"),
    *("asin", "acos", "atan", "asinh", "acosh", "atanh", "log1p", "power"),
)
OPERATIONS = ("add", "sub", "mul", "div", "square", "sqrt", "atan2", "tenth")
#: on pairs that know how far they may be off
BOUNDED = (*OPERATIONS, "R_F", "R_D")
LIBRARY = "intervals.so"


def build(directory: Path) -> None:
    """The shared library, for one worker of a test run or several."""
    compiled(directory / LIBRARY, HERE / "intervals_driver.c", options=STRICT)


class Intervals:
    """operate(name, pairs of intervals (n, 4)), operate_bounded, known(mechanism, design, piece, beyond)."""

    def __init__(self, directory: Path) -> None:
        self.loaded = ctypes.CDLL(str(directory / LIBRARY))

    def operate(self, name: str, pairs: np.ndarray) -> np.ndarray:
        pairs = np.ascontiguousarray(pairs, dtype=np.float64)
        out = np.empty((len(pairs), 2))
        self.loaded.operate(
            (*OPERATIONS, *ELEMENTARY).index(name), ctypes.c_long(len(pairs)), pointer(pairs), pointer(out)
        )
        return out

    def operate_bounded(self, name: str, numbers: np.ndarray) -> np.ndarray:
        """Three numbers (n, 9), each a pair and what it may be off, to one with the doubles around it (n, 5)."""
        numbers = np.ascontiguousarray(numbers, dtype=np.float64)
        out = np.empty((len(numbers), 5))
        self.loaded.operate_bounded(BOUNDED.index(name), ctypes.c_long(len(numbers)), pointer(numbers), pointer(out))
        return out

    def known(self, mechanism: str, design: Sequence[float], piece: int, beyond: float) -> np.ndarray:
        out, numbers = np.empty((6, 2)), np.array(design, dtype=np.float64)
        if not self.loaded.known(mechanism.encode(), pointer(numbers), piece, ctypes.c_double(beyond), pointer(out)):
            raise ValueError(f"no intervals for {mechanism}")
        return out


#: generated functions on intervals: what they return, the module, their names, arguments
PROTOTYPE = re.compile(r"^static inline (sf_interval|void) (\w+_intervals)_(\w+)\(([^)]*)\)$", re.MULTILINE)
MOST_OUTPUTS = 24


def prototypes(modules: Sequence[str]) -> dict[tuple[str, str], tuple[int, bool]]:
    """By module and function, of those that take intervals alone: how many, and whether an array takes the outputs."""
    found = {}
    for module in modules:
        text = (ROOT / "generated" / "native" / f"{module}.h").read_text(encoding="utf-8")
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
