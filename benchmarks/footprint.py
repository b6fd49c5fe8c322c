"""What slowflow costs beside its work: seconds of its import beyond NumPy's, memory of a batch beyond its arrays."""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
from typing import Any

IMPORTING = """
import time
start = time.perf_counter()
import numpy
between = time.perf_counter()
from slowflow import Isolator
print(between - start, time.perf_counter() - between)
"""

LOADING = """
import importlib, time
import numpy
load = importlib.import_module
def timed(name, package=None):
    start = time.perf_counter()
    module = load(name, package)
    print(name, time.perf_counter() - start)
    return module
importlib.import_module = timed
start = time.perf_counter()
from slowflow import Isolator
print("all", time.perf_counter() - start)
"""

#: what of an import no order of modules saves: the bytecode of those that are loaded, read and made objects, and shared
#: libraries
READING = """
import importlib.machinery, marshal, sys, time
import numpy
before = set(sys.modules)
start = time.perf_counter()
from slowflow import Isolator
whole = time.perf_counter() - start
modules = [module for name, module in sys.modules.items() if name not in before]
kept = {module.__cached__ for module in modules if getattr(module, "__cached__", None)}
read, size, count = 0.0, 0, 0
for path in kept:
    start = time.perf_counter()
    try:
        with open(path, "rb") as file:
            code = file.read()
    except OSError:
        continue
    marshal.loads(code[16:])
    read += time.perf_counter() - start
    size, count = size + len(code), count + 1
suffixes = tuple(importlib.machinery.EXTENSION_SUFFIXES)
libraries = sum(str(getattr(module, "__file__", "")).endswith(suffixes) for module in modules)
print(whole, count, size, read, libraries)
"""

REMEMBERING = """
import sys
import numpy as np
from slowflow import Isolator

def pages(key):
    with open("/proc/self/status") as lines:
        return next(int(line.split()[1]) * 1024 for line in lines if line.startswith(key))

count = int(sys.argv[1])
r, zeta = np.empty(count), np.empty(count)
for column, low, high in ((r, 1.0, 2.0), (zeta, 0.005, 0.05)):
    for start in range(0, count, 100000):
        part = column[start:start + 100000]
        part[:] = np.linspace(low, high, part.size)
Isolator.many(lam=3, r=r[:10], delta_h=0.08, mu=0.012, zeta=zeta[:10]).detachment()
before = pages("VmRSS")
found = Isolator.many(lam=3, r=r, delta_h=0.08, mu=0.012, zeta=zeta).detachment()
beyond = pages("VmHWM") - before
answers = sum(value.nbytes for value in vars(found).values() if isinstance(value, np.ndarray))
assert not found.status.any()
print(max(0, beyond - answers), answers)
"""


def run(code: str, *arguments: str) -> list[float]:
    """Numbers printed by a fresh interpreter."""
    return [float(word) for word in fresh(code, *arguments).split()]


def fresh(code: str, *arguments: str) -> str:
    """What a fresh interpreter prints; bytecode is kept, as it is by default and in an installed package."""
    settings = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    done = subprocess.run(
        [sys.executable, "-c", code, *arguments], capture_output=True, text=True, check=True, env=settings
    )
    return done.stdout


def importing(times: int = 15) -> tuple[float, float]:
    """Median seconds of importing `slowflow.Isolator` after NumPy, and of NumPy itself, in the same fresh processes."""
    run(IMPORTING)  # bytecode written, files in the cache
    numpy, slowflow = zip(*(run(IMPORTING) for _ in range(times)), strict=True)
    return statistics.median(slowflow), statistics.median(numpy)


def modules(count: int = 4) -> list[tuple[str, float]]:
    """The generated modules that the import loads by name, which -X importtime does not see, and their seconds."""
    spent = [line.split() for line in fresh(LOADING).splitlines()]
    return sorted(((name, float(seconds)) for name, seconds in spent), key=lambda pair: -pair[1])[:count]


def bytecode(times: int = 7) -> list[float]:
    """Of the import beyond NumPy's: its seconds, modules, bytes of bytecode, seconds to read these, shared libraries.

    Times are the least of so many processes.
    """
    run(READING)
    found = [run(READING) for _ in range(times)]
    return [min(column) for column in zip(*found, strict=True)]


def memory(count: int) -> dict[str, Any]:
    """Bytes at the peak beyond inputs and answers of one batch, and those of the answers; Linux only."""
    beyond, answers = run(REMEMBERING, str(count))
    return {"designs": count, "beyond": beyond, "answers": answers}
