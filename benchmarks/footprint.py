"""What slowflow costs beside its work: seconds of its import beyond NumPy's, memory of a batch beyond its arrays."""

from __future__ import annotations

import statistics
import time

from benchmarks.remote import fresh

IMPORTING = """
import time
start = time.perf_counter()
import numpy
between = time.perf_counter()
from slowflow import Isolator
print([between - start, time.perf_counter() - between])
"""
REMEMBERING = """
import numpy as np
from slowflow import Isolator

def pages(key):
    with open("/proc/self/status") as lines:
        return next(int(line.split()[1]) * 1024 for line in lines if line.startswith(key))

count = {count}
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
print([max(0, beyond - answers), answers])
"""
ANSWERING = "from slowflow.example import isolator; isolator().steady_state(Omega=0.9, F_0=0.04); print(0)"


def importing(times: int = 15) -> tuple[float, float]:
    """Median seconds of importing `slowflow.Isolator` after NumPy, and of NumPy itself, in the same fresh processes."""
    fresh(IMPORTING)  # bytecode written, files in the cache
    numpy, slowflow = zip(*(fresh(IMPORTING) for _ in range(times)), strict=True)
    return statistics.median(slowflow), statistics.median(numpy)


def memory(count: int) -> tuple[float, float]:
    """Bytes at the peak beyond inputs and answers of one batch, and those of the answers; Linux only."""
    beyond, answers = fresh(REMEMBERING.format(count=count))
    return beyond, answers


def answering(times: int = 3) -> float:
    """Least seconds of a process from its start to the end of its first periodic motion."""
    fresh(ANSWERING)
    seconds = []
    for _ in range(times):
        start = time.perf_counter()
        fresh(ANSWERING)
        seconds.append(time.perf_counter() - start)
    return min(seconds)
