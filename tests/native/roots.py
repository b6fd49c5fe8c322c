"""The C root solvers as Python functions: a directory for the shared library in, a callable out."""

from __future__ import annotations

import ctypes
import platform
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
HEADERS = ROOT / "src" / "slowflow" / "native"
INCLUDES = [f"-I{folder}" for folder in (HEADERS, ROOT / "generated" / "c", ROOT / "generated" / "native")]
WARNINGS = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic"]
FLAGS = ["-O3", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=off"]

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
    command = ["gcc", *WARNINGS, *FLAGS, *(["-DSF_CLONES"] if clones else []), *INCLUDES, "-shared", "-fPIC"]
    done = subprocess.run(
        [*command, str(HERE / "roots_driver.c"), "-o", str(library), "-lm"], capture_output=True, text=True
    )
    if done.returncode:
        raise RuntimeError(done.stderr)
    loaded = ctypes.CDLL(str(library))

    def solve(kind: str, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        rows = np.ascontiguousarray(rows, dtype=np.float64)
        Omega = np.empty((len(rows), 2 if kind == "peak" else 3))
        count = np.empty(len(rows), np.int32)
        getattr(loaded, kind)(
            rows.ctypes.data_as(ctypes.c_void_p),
            ctypes.c_long(len(rows)),
            Omega.ctypes.data_as(ctypes.c_void_p),
            count.ctypes.data_as(ctypes.c_void_p),
        )
        return Omega, count

    return solve
