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
from benchmarks.bench_roots import SCENES
from benchmarks.document import quantity
from benchmarks.remote import ROOT
from slowflow import backend
from slowflow.averaged.reference.roots import response_roots
from slowflow.paper import example
from slowflow.paper.example import TABLE_1
from slowflow.validate import WINDOW
from slowflow_kernels import slow_flow
from slowflow_kernels.second_conventions import BEYOND, Wanted
from slowflow_kernels.second_conventions import SAMPLES as FEWER
from tests.oracles.frequencies import stress_cases

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
#: the same of the second approximation's, and of the roots of one quartic
SECOND, QUARTIC = 0.4e-3, 40e-9
#: blocks of 64 quartics of each of the scenes that the target is measured on
QUARTICS = 4096
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
    known = [kind for kind in (*KINDS, "curve", *OTHERS) if kind in wanted]
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
        others = {"curve": _of_curve, **OTHERS}
        return [
            others[kind](library) if kind in others else _sentence(kind, library.count, inputs, asked[kind])
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


def _of_curve(library: Any) -> str:
    """A curve of Table 1 with its folds: what compiled code does of it, and what is left to Python."""
    ask, _ = jobs.prepare()["curve"]
    design, window, out = np.array(list(TABLE_1.values())), np.array(WINDOW), np.zeros(6)
    given, shown, found = (array.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for array in (design, window, out))
    F_0, samples, places = ctypes.c_double(certified.F_0), ctypes.c_double(SAMPLES), ctypes.c_long(PLACES)
    if not library.curve(b"rod_spring", given, F_0, shown, samples, places, found):
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


def _of_second(library: Any) -> str:
    """A curve of the second approximation of Table 1 and its folds, likewise."""
    ask, _ = jobs.prepare()["second curve"]
    first = example.isolator()
    marks = [*first.saddle_nodes(certified.F_0).Omega, first.peak(certified.F_0).Omega]
    around = (min(marks) / BEYOND, max(marks) * BEYOND)
    design, compiled, told = np.array(list(TABLE_1.values())), 0.0, []
    for name, wanted, drawn in (
        ("its points", Wanted.EVERY_POINT, first.frequency_response(certified.F_0, samples=SAMPLES)),
        ("its folds", Wanted.FOLDS_ONLY, first.frequency_response(certified.F_0, samples=FEWER, Omega=around)),
    ):
        out, columns = np.zeros(4), (drawn.Omega, drawn.A, drawn.branch.astype(np.int64))
        given, Omega, A, branch, found = (_pointer(array) for array in (design, *columns, out))
        places = ctypes.c_long(len(drawn))
        if not library.second(
            *(b"rod_spring", given, ctypes.c_double(certified.F_0), int(wanted), places, Omega, A, branch, found)
        ):
            raise RuntimeError("the second approximation of Table 1 is not drawn")
        averages, balances, average, balance = out
        asked = (*(first.model.native, certified.F_0, wanted), *columns, np.array(drawn.isola))
        whole = _seconds(lambda asked=asked: [backend.solver().second_follow(*asked) for _ in range(100)]) / 100
        told.append(
            f"{name} by {averages:.0f} averages with their harmonics of {quantity(average, 's')} and {balances:.0f} "
            f"balances of {quantity(balance, 's')}, {quantity(averages * average + balances * balance, 's')} of "
            f"{quantity(whole, 's')}"
        )
        compiled += whole
    whole = _seconds(lambda: [ask() for _ in range(100)]) / 100
    return (
        f"one curve of the second approximation with its folds takes {quantity(whole, 's')}, asked "
        f"{quantity(SECOND, 's')}: {', '.join(told)}, together {quantity(compiled, 's')}; the rest are averaging's two "
        "curves that these begin with, and Python's: an isolator made, arrays copied, remarks, answers named"
    )


def _of_quartics(library: Any) -> str:
    """Quartics of the scene that takes longest."""
    blocks = {name: np.ascontiguousarray(rows) for name, rows in stress_cases("response", QUARTICS, 3).items()}
    took = {name: _seconds(lambda rows=blocks[name]: response_roots(*rows.T)) / QUARTICS for name in SCENES}
    slowest = max(SCENES, key=took.__getitem__)
    out = np.zeros(7)
    library.quartics(ctypes.c_long(QUARTICS), *(_pointer(array) for array in (blocks[slowest], out)))
    roots, on, unsure, signs, root, further, alone = out
    parts = signs, roots * root, on * further, unsure * alone
    signs, root, further, alone = (quantity(cost, "s") for cost in (signs, root, further, alone))
    return (
        f"one quartic of the scene {slowest} takes {quantity(took[slowest], 's')}, asked {quantity(QUARTIC, 's')}: "
        f"its signs in lanes {signs}, {roots:.3g} roots in lanes of {root}, {on:.3g} of them that go on in "
        f"double-double of {further}, {unsure:.3g} quartics whose signs are unsure in double of {alone}: "
        f"{', '.join(quantity(part, 's') for part in parts)}, together {quantity(sum(parts), 's')}"
    )


#: kinds that are counted in ways of their own
OTHERS: dict[str, Callable[[Any], str]] = {"second": _of_second, "quartic": _of_quartics}


def _pointer(array: np.ndarray) -> Any:
    return array.ctypes.data_as(ctypes.c_void_p)


def _seconds(ask: Callable[[], Any]) -> float:
    ask()
    best = np.inf
    for _ in range(ROUNDS):
        start = time.process_time()
        ask()
        best = min(best, time.process_time() - start)
    return best


if __name__ == "__main__":
    print(*of([*KINDS, "curve", *OTHERS]), sep="\n")
