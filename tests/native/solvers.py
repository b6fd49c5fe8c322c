"""The compiled solvers with another spacing of samples, as functions of arrays: a directory in, callables out."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np

from tests.native.roots import FLAGS, HEADERS, HERE, ROOT, WARNINGS

INCLUDES = [f"-I{folder}" for folder in (HEADERS, ROOT / "generated" / "c", ROOT / "generated" / "native")]
#: ten times as many samples as the package's, and nothing left out
THOROUGH = ["-DSF_MOST_NODES=20000", "-DSF_STEP_DOWN=0.99", "-DSF_STEP_UP=1.01", "-DSF_STEP_NEAR=1.02", "-DSF_SKIP=0"]

LIBRARY = "solvers.so"

Answers = tuple[np.ndarray, np.ndarray]


def build(directory: Path, options: list[str]) -> None:
    """Compile the driver into a library in a folder."""
    command = ["gcc", *WARNINGS, "-std=c11", *FLAGS, *options, *INCLUDES, "-shared", "-fPIC"]
    done = subprocess.run(
        [*command, str(HERE / "solver_driver.c"), "-o", str(directory / LIBRARY), "-lm"], capture_output=True, text=True
    )
    if done.returncode:
        raise RuntimeError(done.stderr)


def load(directory: Path) -> Callable[[str, np.ndarray], Answers]:
    """The library in a folder: a function of the question and of rows (lam, r, delta_h, mu, zeta, F_0).

    It gives numbers, shape (n, 12), and for each design a status and a kind or count, shape (n, 2).
    """
    loaded = ctypes.CDLL(str(directory / LIBRARY))

    def solve(question: str, rows: np.ndarray) -> Answers:
        rows = np.ascontiguousarray(rows, dtype=np.float64)
        numbers, codes = np.full((len(rows), 12), np.nan), np.zeros((len(rows), 2), np.int32)
        pointers = [array.ctypes.data_as(ctypes.c_void_p) for array in (rows, numbers, codes)]
        getattr(loaded, question)(pointers[0], ctypes.c_long(len(rows)), *pointers[1:])
        return numbers, codes

    return solve
