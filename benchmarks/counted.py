"""Why a batch is no faster: in go the kinds of a question, out come sentences that add up what an answer is made of.

Counts and costs are measured by `counted.c`, which gcc builds around the solvers as they are: evaluations of the
averages, these in double-double, values of the function that is searched, its ranges on cells. What is left over are
the parameters of a design, the pieces of its force, and what the search does in between.
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

from benchmarks import jobs
from benchmarks.document import quantity
from benchmarks.remote import ROOT
from slowflow_kernels import slow_flow

DESIGNS = 4096
ROUNDS = 5
FLAGS = ("-std=gnu11", "-O3", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=off", "-fno-tree-slp-vectorize")
FOLDERS = ("src/slowflow/native", "generated/c", "generated/native")
SOURCES = ("benchmarks/counted.c", *(f"src/slowflow/native/solver/{name}_lanes.c" for name in ("root", "second")))
#: by kind: its number in counted.c, the seconds that are asked of a design, its name
KINDS = {
    "amplitudes": (0, 0.5e-6, "the states of one design"),
    "saddle_nodes": (1, 1e-6 / 0.3, "all folds of one design"),
    "peak": (2, 1e-6, "one peak"),
    "saddle_node_onset": (3, 1e-6, "one F_SN"),
}
PARTS = ("averages h to h_AAA", "the same in double-double", "values of what is searched", "ranges of it on cells")


def of(kinds: Iterable[str]) -> list[str]:
    """One sentence for each kind that is known here."""
    known = [kind for kind in KINDS if kind in set(kinds)]
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
        count = _built(Path(folder)).count
        return [_sentence(kind, count, inputs, asked[kind]) for kind in known]


def _built(folder: Path) -> ctypes.CDLL:
    library = folder / "counted.so"
    include = [f"-I{ROOT / name}" for name in FOLDERS]
    sources = [str(ROOT / name) for name in SOURCES]
    command = ["gcc", *FLAGS, "-shared", "-fPIC", *include, *sources, "-o", str(library), "-lm"]
    subprocess.run(command, check=True)
    return ctypes.CDLL(str(library))


def _sentence(kind: str, count: Any, inputs: np.ndarray, ask: Callable[[], Any]) -> str:
    number, wanted, name = KINDS[kind]
    out = np.zeros(8)
    pointers = (array.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for array in (inputs, out))
    if not count(number, b"rod_spring", ctypes.c_long(inputs.shape[1]), *pointers):
        raise RuntimeError("the record of the isolator is not compiled in")
    times, costs = out[:4], out[4:]
    whole = _seconds(ask) / inputs.shape[1]
    parts = [f"{n:.3g} {part} of {quantity(cost, 's')}" for n, part, cost in zip(times, PARTS, costs, strict=True) if n]
    least = ", ".join(quantity(n * cost, "s") for n, cost in zip(times, costs, strict=True) if n)
    return (
        f"{name} takes {quantity(whole, 's')}, asked {quantity(wanted, 's')}: {', '.join(parts)}: "
        f"{least}, together {quantity(float(times @ costs), 's')}"
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
    print(*of(KINDS), sep="\n")
