"""The interval arithmetic of the solvers as Python functions: a directory for the shared library in, callables out."""

from __future__ import annotations

import ctypes
import re
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tests.native.roots import FLAGS, HERE, INCLUDES, ROOT

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


#: generated functions on intervals: the module, its name, arguments, whether it fills an array of outputs
PROTOTYPE = re.compile(r"^static inline (sf_interval|void) (\w+_intervals)_(\w+)\(([^)]*)\)$", re.MULTILINE)
MOST_OUTPUTS = 24


def prototypes(modules: Sequence[str]) -> dict[tuple[str, str], list[str]]:
    """Names of arguments by module and function, of those that take intervals alone."""
    found = {}
    for module in modules:
        text = (ROOT / "generated" / "native" / f"{module}.h").read_text(encoding="utf-8")
        for _, prefix, name, arguments in PROTOTYPE.findall(text):
            declared = [one.split() for one in arguments.split(", ")]
            inputs = [names[-1] for names in declared if names[-1] != "*out"]
            if prefix == module and all(names[0] == "sf_interval" for names in declared):
                found[module, name] = inputs
    return found


def build_generated(directory: Path, modules: Sequence[str]) -> None:
    """The shared library of all generated functions on intervals of these modules."""
    lines = [f'#include "{header}"' for header in ("interval.h", *(f"{module}.h" for module in modules))]
    for (module, name), inputs in prototypes(modules).items():
        call = f"{module}_{name}({', '.join(f'in[{k}]' for k in range(len(inputs)))}"
        text = (ROOT / "generated" / "native" / f"{module}.h").read_text(encoding="utf-8")
        fills = f"static inline void {module}_{name}(" in text
        body = f"{call}, out);" if fills else f"out[0] = {call});"
        lines.append(f"void called_{module}_{name}(const sf_interval *in, sf_interval *out) {{ {body} }}")
    source = directory / "generated_intervals.c"
    source.write_text("\n".join(lines) + "\n", encoding="utf-8")
    command = ["gcc", "-std=c11", *FLAGS, "-O1", *INCLUDES, "-shared", "-fPIC", str(source), "-lm"]
    done = subprocess.run([*command, "-o", str(directory / "generated_intervals.so")], capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(done.stderr)


def generated(directory: Path) -> Any:
    """(module, function, boxes (arguments, 2)) -> intervals (outputs, 2), NaN behind the last."""
    loaded = ctypes.CDLL(str(directory / "generated_intervals.so"))

    def called(module: str, name: str, boxes: Any) -> np.ndarray:
        given = np.ascontiguousarray(boxes, dtype=np.float64)
        out = np.full((MOST_OUTPUTS, 2), np.nan)
        getattr(loaded, f"called_{module}_{name}")(_pointer(given), _pointer(out))
        return out

    return called
