"""The C root solvers as Python functions: a directory for the shared library in, a callable out."""

from __future__ import annotations

import ctypes
import platform
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np

from tests.native.compiler import FLAGS, HERE, WARNINGS, compiled, pointer

Solver = Callable[[str, np.ndarray], tuple[np.ndarray, np.ndarray]]


def why_not(clones: bool) -> str | None:
    """The reason why the library cannot be built here, or None."""
    if shutil.which("gcc") is None:
        return "no gcc on the path"
    if clones and (platform.system(), platform.machine()) != ("Linux", "x86_64"):
        return "target_clones is used on x86-64 Linux only"
    return None


def build(directory: Path, clones: bool) -> Solver:
    """Compile the driver; the function returned takes the kind and rows of parameters, and gives Omega and counts."""
    library = directory / f"roots{'_clones' if clones else ''}.so"
    options = [*WARNINGS, *FLAGS, *(["-DSF_CLONES"] if clones else [])]
    loaded = ctypes.CDLL(str(compiled(library, HERE / "roots_driver.c", options=options)))

    def solve(kind: str, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        rows = np.ascontiguousarray(rows, dtype=np.float64)
        Omega = np.empty((len(rows), 2 if kind == "peak" else 3))
        count = np.empty(len(rows), np.int32)
        getattr(loaded, kind)(pointer(rows), ctypes.c_long(len(rows)), pointer(Omega), pointer(count))
        return Omega, count

    return solve
