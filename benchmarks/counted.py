"""Why a batch is no faster: in go the kinds of a question, out come sentences that add up what an answer is made of.

Counts and costs are measured by `counted.c`, which gcc builds around the solvers as they are: evaluations of the
averages, these in double-double, values of the function that is searched, its ranges on cells, and of loops over many
designs cells and amplitudes. What is left over are the parameters of a design, the pieces of its force, roots of
quartics on its breakpoints, and what the search does in between.
"""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks import certified, jobs
from benchmarks.document import quantity
from benchmarks.remote import ROOT
from slowflow.paper.example import TABLE_1
from slowflow.validate import WINDOW
from slowflow_kernels import slow_flow

DESIGNS = 4096
ROUNDS = 5
FLAGS = ("-std=gnu11", "-O3", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=off", "-fno-tree-slp-vectorize")
FOLDERS = ("src/slowflow/native", "generated/c", "generated/native")
LANES = ("cusp", "peak", "root", "second", "state")
SOURCES = ("benchmarks/counted.c", *(f"src/slowflow/native/solver/{name}_lanes.c" for name in LANES))
#: by kind: its number in counted.c, the seconds that are asked of a design, its name
KINDS = {
    "amplitudes": (0, 0.5e-6, "the states of one design"),
    "saddle_nodes": (1, 1e-6 / 0.3, "all folds of one design"),
    "peak": (2, 1e-6, "one peak"),
    "saddle_node_onset": (3, 1e-6, "one F_SN"),
}
#: what is asked of a curve of so many points with its folds, in seconds
CURVE, SAMPLES, PLACES = 1 / 15e3, 1000, 4096
PARTS = (
    "averages h to h_AAA",
    "the same in double-double",
    "values of what is searched",
    "ranges of it on cells",
    "cells judged in lanes",
    "amplitudes asked in lanes",
)


def of(kinds: Iterable[str]) -> list[str]:
    """One sentence for each kind that is known here."""
    wanted = set(kinds)
    known = [kind for kind in (*KINDS, "curve") if kind in wanted]
    if not known or shutil.which("gcc") is None:
        return ["what batches are made of was not counted: there is no gcc"] if known else []
    designs = jobs.FAMILIES["random"](DESIGNS)
    given = list(designs.values.values())
    F_0 = slow_flow.friction(designs.values["mu"]) + 0.03
    Omega = np.random.default_rng(DESIGNS).uniform(0.3, 1.5, DESIGNS)
    inputs = np.array([*given, F_0, Omega])
    asked: dict[str, Callable[[], Any]] = {
        "amplitudes": lambda: designs.amplitudes(Omega=Omega, F_0=F_0),
        "saddle_nodes": lambda: designs.saddle_nodes(F_0),
        "peak": lambda: designs.peak(F_0),
        "saddle_node_onset": designs.saddle_node_onset,
    }
    with tempfile.TemporaryDirectory() as folder:
        library = _built(Path(folder))
        return [
            _of_curve(library.curve) if kind == "curve" else _sentence(kind, library.count, inputs, asked[kind])
            for kind in known
        ]


def _built(folder: Path) -> ctypes.CDLL:
    library = folder / "counted.so"
    include = [f"-I{ROOT / name}" for name in FOLDERS]
    sources = [str(ROOT / name) for name in SOURCES]
    command = ["gcc", *FLAGS, "-shared", "-fPIC", *include, *sources, "-o", str(library), "-lm"]
    subprocess.run(command, check=True)
    return ctypes.CDLL(str(library))


def _sentence(kind: str, count: Any, inputs: np.ndarray, ask: Callable[[], Any]) -> str:
    number, wanted, name = KINDS[kind]
    out = np.zeros(2 * len(PARTS))
    pointers = (array.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for array in (inputs, out))
    if not count(number, b"rod_spring", ctypes.c_long(inputs.shape[1]), *pointers):
        raise RuntimeError("the record of the isolator is not compiled in")
    times, costs = np.split(out, 2)
    whole = _seconds(ask) / inputs.shape[1]
    parts = [f"{n:.3g} {part} of {quantity(cost, 's')}" for n, part, cost in zip(times, PARTS, costs, strict=True) if n]
    least = ", ".join(quantity(n * cost, "s") for n, cost in zip(times, costs, strict=True) if n)
    return (
        f"{name} takes {quantity(whole, 's')}, asked {quantity(wanted, 's')}: {', '.join(parts)}: "
        f"{least}, together {quantity(float(times @ costs), 's')}"
    )


def _of_curve(curve: Any) -> str:
    """A curve of Table 1 with its folds: what compiled code does of it, and what is left to Python."""
    ask, _ = jobs.prepare()["curve"]
    design, window, out = np.array(list(TABLE_1.values())), np.array(WINDOW), np.zeros(6)
    given, shown, found = (array.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for array in (design, window, out))
    F_0, samples, places = ctypes.c_double(certified.F_0), ctypes.c_double(SAMPLES), ctypes.c_long(PLACES)
    if not curve(b"rod_spring", given, F_0, shown, samples, places, found):
        raise RuntimeError("the curve of Table 1 is not drawn")
    points, averages, ranges, *seconds = out
    whole = _seconds(lambda: [ask() for _ in range(100)]) / 100
    segments, along, folds, each = (quantity(part, "s") for part in (*seconds, seconds[1] / points))
    return (
        f"one curve of {points:.0f} points with its folds takes {quantity(whole, 's')}, asked {quantity(CURVE, 's')}: "
        f"its segments by {averages:.0f} averages and {ranges:.0f} ranges on cells {segments}, the points on them "
        f"{along}, of each {each}, its folds {folds}, together {quantity(sum(seconds), 's')}; the rest is Python's: an "
        "isolator made, arrays copied, answers named"
    )


def _seconds(ask: Callable[[], Any]) -> float:
    ask()
    best = np.inf
    for _ in range(ROUNDS):
        start = time.process_time()
        ask()
        best = min(best, time.process_time() - start)
    return best


if __name__ == "__main__":
    print(*of([*KINDS, "curve"]), sep="\n")
