"""Maps of designs in stores: time, memory and disk against the number of designs, each map in a process of its own."""

from __future__ import annotations

import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.remote import fresh
from slowflow import Isolator

#: along r, share of the preload that leaves no stiffness, and mu
MAPS = {10**5: (10, 100, 100), 10**6: (25, 200, 200), 10**7: (250, 200, 200)}
QUESTIONS: dict[str, dict[str, float]] = {
    "detachment": {},
    "saddle_node_onset": {},
    "peak": {"F_0": 0.04},
    "saddle_nodes": {"F_0": 0.04},
}


def axis(name: str, low: float, high: float, count: int) -> Any:
    """Equidistant numbers along an axis of their own name."""
    import xarray

    numbers = np.linspace(low, high, count)
    return xarray.DataArray(numbers, dims=name, coords={name: numbers})


def peak_memory() -> float:
    """The most memory that this process ever had, in MB."""
    import resource

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def one(question: str, designs: int) -> dict[str, Any]:
    """Store one map, by one thread, in this process."""
    import dask
    import zarr

    lengths = MAPS[designs]
    r, fraction, mu = (
        axis("r", 0.5, 3.0, lengths[0]),
        axis("share", 0.05, 0.95, lengths[1]),
        axis("mu", 0, 0.02, lengths[2]),
    )
    grid = Isolator.many(lam=3, r=r, delta_h=fraction / (3 * r), mu=mu, zeta=0.02)
    with tempfile.TemporaryDirectory() as folder, dask.config.set(scheduler="threads", num_workers=1):
        start, worked, before = time.perf_counter(), time.process_time(), peak_memory()
        found = grid.store(folder, question, **QUESTIONS[question])
        seconds, processor, after = time.perf_counter() - start, time.process_time() - worked, peak_memory()
        disk = sum(path.stat().st_size for path in Path(folder).rglob("*") if path.is_file()) / 2**20
        blocks = int(zarr.open_group(folder, mode="r")["done"].size)
        complete = found.attrs["complete"] == 1 and not bool((found["status"] == -1).any())
    return {
        "question": question,
        "designs": designs,
        "blocks": blocks,
        "complete": complete,
        "seconds": seconds,
        "processor": processor,
        "before": before,
        "peak": after,
        "disk": disk,
    }


def measure(largest: int) -> list[dict[str, Any]]:
    """One row for each question and number of designs up to the largest."""
    code = "import json\nfrom benchmarks.bench_grid import one\nprint(json.dumps(one({!r}, {})))"
    return [fresh(code.format(question, designs)) for question in QUESTIONS for designs in MAPS if designs <= largest]
