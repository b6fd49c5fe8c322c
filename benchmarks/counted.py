"""Why a batch is no faster. Takes the kinds of a question; returns sentences that add up what an answer is made of.

Counts and costs are measured by `counted.c`, which gcc builds around the solvers as they are: evaluations of the
averages, these in double-double, values of the function that is searched, its enclosures on cells, of loops over many
designs cells and amplitudes, quartics solved by themselves, the parameters of a design and its answer written. What
Python and NumPy take is the answer's time less that of the compiled loop on the same arrays. What is left is told as
unexplained: what the search does in between, as carrying samples into cells and back, and Newton's steps.
"""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks import bench_exact, certified, jobs
from benchmarks.bench_roots import SCENES
from benchmarks.document import quantity
from benchmarks.remote import ROOT
from slowflow import example
from slowflow.answers.table import QUESTIONS
from slowflow.averaged.many import AMPLITUDES, ONSET, PEAK, SADDLE_NODES, Question
from slowflow.core import backend
from slowflow.core.backend import SOLVER
from slowflow.core.validate import WINDOW
from slowflow.exact.motion import TURN, handle
from slowflow.example import TABLE_1
from slowflow_kernels import slow_flow
from slowflow_kernels.second_conventions import BEYOND, Wanted
from slowflow_kernels.second_conventions import SAMPLES as FEWER
from tests.oracles.frequencies import stress_cases

DESIGNS = 2**15
ROUNDS = 5
FLAGS = ("-std=gnu11", "-O3", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=off", "-fno-tree-slp-vectorize")
FOLDERS = ("src/slowflow/native", "generated/c", "generated/native")
LANES = ("cusp", "fold", "peak", "root", "second", "state")
SOURCES = {
    "counted": (
        "benchmarks/counted.c",
        *(f"src/slowflow/native/solver/{name}.c" for name in ("shipped_baseline", *(f"{one}_lanes" for one in LANES))),
    ),
    "counted_motion": ("benchmarks/counted_motion.c",),
}
#: by kind: its number in counted.c, the target in seconds for a design, its name, the compiled loop
KINDS = {
    "amplitudes": (0, 0.5e-6, "the search for the states of one design", AMPLITUDES),
    "saddle_nodes": (1, 1e-6 / 0.3, "the search for all folds of one design", SADDLE_NODES),
    "peak": (2, 1e-6, "one peak", PEAK),
    "saddle_node_onset": (3, 1e-6, "one F_SN", ONSET),
}
#: target for a curve of so many points with its folds, in seconds
CURVE, SAMPLES, MAX_POINTS = 1 / 15e3, 1000, 4096
#: the same of the second approximation's, and of the roots of one quartic
SECOND, QUARTIC = 0.4e-3, 40e-9
#: blocks of 64 quartics of each of the scenes that the target is measured on
QUARTICS = 4096
#: coefficients of u along a step, and of v
SERIES = 2 * 25
#: of a design's folds or states, as by default
PLACES_OF_ONE = 6
OPERATIONS = (
    "averages h to h_AAA",
    "of these in double-double",
    "values of the searched function",
    "enclosures of it on cells",
    "cells tested in vector lanes",
    "amplitudes solved in vector lanes",
    "quartics solved singly",
    "designs' parameters and pieces",
    "the same on intervals, for jumps of the force",
    "the same in double-double",
    "results written",
)


def of(kinds: Iterable[str]) -> list[str]:
    """One sentence for each kind that is known here."""
    requests = set(kinds)
    known = [kind for kind in (*KINDS, "curve", *OTHERS) if kind in requests]
    if not known or shutil.which("gcc") is None:
        return ["what batches are made of was not counted: there is no gcc"] if known else []
    designs = jobs.FAMILIES["random"](DESIGNS)
    parameters = list(designs.values.values())
    F_0 = slow_flow.friction(designs.values["mu"]) + 0.03
    Omega = np.random.default_rng(DESIGNS).uniform(0.3, 1.5, DESIGNS)
    inputs = np.array([*parameters, F_0, Omega])
    calls: dict[str, Callable[[], Any]] = {
        "amplitudes": lambda: designs.amplitudes(Omega=Omega, F_0=F_0),
        "saddle_nodes": lambda: designs.saddle_nodes(F_0),
        "peak": lambda: designs.peak(F_0),
        "saddle_node_onset": designs.saddle_node_onset,
    }
    with tempfile.TemporaryDirectory() as folder:
        others = {"curve": _of_curve, **OTHERS}
        built = {name: _built(Path(folder), name) for name in SOURCES if name == "counted" or "motion" in known}
        return [
            others[kind](built["counted_motion" if kind == "motion" else "counted"])
            if kind in others
            else _sentence(kind, built["counted"].count, inputs, designs, calls[kind])
            for kind in known
        ]


def _built(folder: Path, name: str) -> ctypes.CDLL:
    library = folder / f"{name}.so"
    include = [f"-I{ROOT / name}" for name in FOLDERS]
    sources = [str(ROOT / name) for name in SOURCES[name]]
    command = ["gcc", *FLAGS, "-shared", "-fPIC", *include, *sources, "-o", str(library), "-lm"]
    subprocess.run(command, check=True)
    return ctypes.CDLL(str(library))


def _sentence(kind: str, count: Any, inputs: np.ndarray, designs: Any, ask: Callable[[], Any]) -> str:
    number, target, name, question = KINDS[kind]
    out = np.zeros(2 * len(OPERATIONS))
    pointers = (array.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for array in (inputs, out))
    if not count(number, b"rod_spring", ctypes.c_long(inputs.shape[1]), *pointers):
        raise RuntimeError("the record of the isolator is not compiled in")
    times, costs = np.split(out, 2)
    whole, in_c = np.array(_in_turn(ask, _loop(question, inputs, designs))) / inputs.shape[1]
    terms = [
        f"{n:.3g} {part} of {quantity(cost, 's')}" for n, part, cost in zip(times, OPERATIONS, costs, strict=True) if n
    ]
    each = [n * cost for n, cost in zip(times, costs, strict=True) if n]
    return (
        f"{name} takes {quantity(whole, 's')}, target {quantity(target, 's')}: {', '.join(terms)}, Python and NumPy "
        f"{quantity(whole - in_c, 's')}: {_added(whole, [*each, whole - in_c])}"
    )


def _added(whole: float, terms: list[float]) -> str:
    """The terms of a time, their sum, and what they leave unexplained."""
    left = whole - sum(terms)
    return (
        f"{', '.join(quantity(part, 's') for part in terms)}, together {quantity(sum(terms), 's')}; unexplained "
        f"{quantity(left, 's')}, {100 * left / whole:.0f} %"
    )


def _loop(question: Question, inputs: np.ndarray, designs: Any) -> Callable[[], Any]:
    """The compiled loop of a question alone, on arrays that are there."""
    assert question.batch is not None  # all of these are compiled
    solve = question.batch(backend.record_of(designs.mechanism, inertial=False))
    size = inputs.shape[1]
    rows = inputs[: solve.nin]
    out = tuple(QUESTIONS[question.name].blank(question.system, (size,), place=PLACES_OF_ONE).values())

    def blocks() -> None:
        for start in range(0, size, question.at_once):
            part = slice(start, start + question.at_once)
            solve(*rows[:, part], out=tuple(column[part] for column in out))

    return blocks


def _of_curve(library: Any) -> str:
    """A curve of Table 1 with its folds: what compiled code does of it, and what is left to Python."""
    ask, _ = jobs.prepare()["curve"]
    design, window, out = np.array(list(TABLE_1.values())), np.array(WINDOW), np.zeros(6)
    numbers, shown, found = (array.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for array in (design, window, out))
    F_0, samples, max_count = ctypes.c_double(certified.F_0), ctypes.c_double(SAMPLES), ctypes.c_long(MAX_POINTS)
    if not library.curve(b"rod_spring", numbers, F_0, shown, samples, max_count, found):
        raise RuntimeError("the curve of Table 1 is not drawn")
    points, averages, ranges, *seconds = out
    whole = _seconds(lambda: [ask() for _ in range(100)]) / 100
    made = _seconds(lambda: [example.isolator() for _ in range(100)]) / 100
    segments, on_segments, folds, each = (quantity(part, "s") for part in (*seconds, seconds[1] / points))
    return (
        f"one curve of {points:.0f} points with its folds takes {quantity(whole, 's')}, target {quantity(CURVE, 's')}: "
        f"its segments by {averages:.0f} averages and {ranges:.0f} enclosures on cells {segments}, the points on them "
        f"{on_segments}, of each {each}, its folds {folds}, construction of an isolator {quantity(made, 's')}: "
        f"{_added(whole, [*seconds, made])}, in Python: array copies, remarks, construction of results"
    )


def _of_second(library: Any) -> str:
    """A curve of the second approximation of Table 1 and its folds, likewise."""
    ask, _ = jobs.prepare()["second curve"]
    first = example.isolator()
    marks = [*first.saddle_nodes(certified.F_0).Omega, first.peak(certified.F_0).Omega]
    around = (min(marks) / BEYOND, max(marks) * BEYOND)
    design, compiled, sentences = np.array(list(TABLE_1.values())), 0.0, []
    solver, arguments = backend.SOLVER, (first.model.native, certified.F_0)
    for name, request, drawn, ask_compiled in (
        (
            "its points",
            Wanted.EVERY_POINT,
            first.frequency_response(certified.F_0, samples=SAMPLES),
            lambda: solver.second_curve(*arguments, Wanted.EVERY_POINT, SAMPLES, *WINDOW),
        ),
        (
            "its folds",
            Wanted.FOLDS_ONLY,
            first.frequency_response(certified.F_0, samples=FEWER, Omega=around),
            lambda: solver.second_saddle_nodes(*arguments, np.inf, np.inf),
        ),
    ):
        out, columns = np.zeros(4), (drawn.Omega, drawn.A, drawn.branch.astype(np.int64))
        parameters, Omega, A, branch, found = (_pointer(array) for array in (design, *columns, out))
        count = ctypes.c_long(len(drawn))
        if not library.second(
            *(b"rod_spring", parameters, ctypes.c_double(certified.F_0), int(request), count, Omega, A, branch, found)
        ):
            raise RuntimeError("the second approximation of Table 1 is not drawn")
        averages, balances, average, balance = out
        whole = _seconds(lambda ask=ask_compiled: [ask() for _ in range(100)]) / 100
        sentences.append(
            f"{name} by {averages:.0f} averages with their harmonics of {quantity(average, 's')} and {balances:.0f} "
            f"balances of {quantity(balance, 's')}, {quantity(averages * average + balances * balance, 's')} of "
            f"{quantity(whole, 's')}, including the averaged curve from which they start"
        )
        compiled += whole
    better = first.second_approximation
    curve, folds = better.frequency_response(certified.F_0, samples=SAMPLES), better.saddle_nodes(certified.F_0)
    extras: dict[str, Callable[[], Any]] = {
        "construction of an isolator": example.isolator,
        "validity messages": lambda: [better._remarked("", x.Omega, x.A) for x in (curve, folds)],
        "immutable results": lambda: [replace(x, message="") for x in (curve, folds)],
    }
    whole, *others = (
        seconds / 100
        for seconds in _in_turn(*(lambda of=of: [of() for _ in range(100)] for of in (ask, *extras.values())))
    )
    each = ", ".join(f"{name} {quantity(taken, 's')}" for name, taken in zip(extras, others, strict=True))
    return (
        f"one curve of the second approximation with its folds takes {quantity(whole, 's')}, target "
        f"{quantity(SECOND, 's')}: {', '.join(sentences)}, {each}: {_added(whole, [compiled, *others])}"
    )


def _of_quartics(library: Any) -> str:
    """Quartics of the scene that takes longest."""
    blocks = {name: np.ascontiguousarray(rows) for name, rows in stress_cases("response", QUARTICS, 3).items()}
    took = {name: _seconds(lambda rows=blocks[name]: SOLVER.response_roots(*rows.T)) / QUARTICS for name in SCENES}
    slowest = max(SCENES, key=took.__getitem__)
    out = np.zeros(7)
    library.quartics(ctypes.c_long(QUARTICS), *(_pointer(array) for array in (blocks[slowest], out)))
    roots, on, unsure, signs, root, further, single = out
    terms = signs, roots * root, on * further, unsure * single
    signs, root, further, single = (quantity(cost, "s") for cost in (signs, root, further, single))
    return (
        f"one quartic of the case {slowest} takes {quantity(took[slowest], 's')}, target {quantity(QUARTIC, 's')}: "
        f"its signs in vector lanes {signs}, {roots:.3g} roots in vector lanes of {root}, {on:.3g} of them continued "
        f"in double-double of {further}, {unsure:.3g} quartics with signs uncertain in double precision of {single}: "
        f"{_added(took[slowest], list(terms))}"
    )


def _of_motion(library: Any) -> str:
    """Turns of the forcing with every switch."""
    (job,) = (job for job in bench_exact.jobs() if job.name == bench_exact.TURNS)
    system = bench_exact.table_1(True)
    pieces, edges = (*system.force.pieces[:0:-1], *system.force.pieces), system.force.edges
    names = (ctypes.c_char_p * len(pieces))(*(piece.law.name.encode() for piece in pieces))
    sizes = np.array([len(piece.constants) for piece in pieces], dtype=np.intc)
    constants, ends = np.array([x for piece in pieces for x in piece.constants]), np.array(edges)
    numbers, out, end = (system.mu, system.zeta, bench_exact.OMEGA, certified.F_0), np.zeros(5), 200 * TURN
    if not library.turns(
        *(len(pieces), -system.force.region_of(-np.inf), names, _pointer(sizes), _pointer(constants), _pointer(ends)),
        *map(ctypes.c_double, (*numbers, end)),
        _pointer(out),
    ):
        raise RuntimeError("the motion of Table 1 is not followed")
    arguments = handle(system), bench_exact.OMEGA, certified.F_0, 0.0, 0.0, 0.0, end, False, 0, 0, 10**6
    whole, in_c = _in_turn(
        job.run,
        lambda: backend.EXACT.follow(*arguments),
    )
    phases, steps, searches, step, search = out
    return (
        f"{job.name} take {quantity(whole, 's')}, target {quantity(1e-3 * (job.bound or 0), 's')}: {phases:.0f} phases "
        f"by {steps:.0f} steps of {SERIES} coefficients, computed one after another, of "
        f"{quantity(step, 's')}, {searches:.0f} searches for a stop on a step of {quantity(search, 's')}, Python, a "
        f"record of each phase, {quantity(whole - in_c, 's')}: "
        f"{_added(whole, [steps * step, searches * search, whole - in_c])}"
    )


#: kinds that are counted in ways of their own
OTHERS: dict[str, Callable[[Any], str]] = {"second": _of_second, "quartic": _of_quartics, "motion": _of_motion}


def _pointer(array: np.ndarray) -> Any:
    return array.ctypes.data_as(ctypes.c_void_p)


def _seconds(ask: Callable[[], Any]) -> float:
    return _in_turn(ask)[0]


def _in_turn(*calls: Callable[[], Any]) -> list[float]:
    """The least seconds of each call; every round runs all of them."""
    best = [np.inf] * len(calls)
    for ask in calls:
        ask()
    for _ in range(ROUNDS):
        for i, ask in enumerate(calls):
            start = time.process_time()
            ask()
            best[i] = min(best[i], time.process_time() - start)
    return best


if __name__ == "__main__":
    print(*of([*KINDS, "curve", *OTHERS]), sep="\n")
