"""C sources in, a program or a shared library out, with the flags and headers of the package."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from slowflow import include

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
NATIVE, GENERATED = ROOT / "src" / "slowflow" / "native", ROOT / "generated"
INCLUDES = [f"-I{folder}" for folder in include()]
WARNINGS = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic"]
FLAGS = ["-O3", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=off"]
#: arithmetic is strict: -O1 gives the same digits as -O3, which takes twice the time
STRICT = ["-std=c11", *FLAGS, "-O1"]
COMPILER = shutil.which("cc")


def compiled(out: Path, *sources: Path, options: Iterable[str], compiler: str | None = "gcc") -> Path:
    """The program, or what is loaded as a library where its name ends in .so; RuntimeError: what the compiler says."""
    shared = ["-shared", "-fPIC"] if out.suffix == ".so" else []
    command = [compiler or "cc", *options, *INCLUDES, *shared, *map(str, sources), "-o", str(out), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(done.stderr)
    return out


def pointer(array: np.ndarray) -> Any:
    """To its first number."""
    return array.ctypes.data_as(ctypes.c_void_p)
