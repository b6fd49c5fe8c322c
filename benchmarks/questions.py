"""The table of docs/benchmarks.md: each question on the installed package, with what it is compared with, in one run.

An answer that is not right has no time worth knowing: that is an error.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass
from functools import partial
from typing import Any

import numpy as np
from mpmath import mpf, workdps

from benchmarks import bench_exact, bench_kernels, bench_roots, certified, footprint
from benchmarks.document import Row, quantity
from benchmarks.jobs import random_designs
from benchmarks.quartics import ACM, BOOST
from benchmarks.remote import ROOT, Remote, in_turn
from slowflow import example
from slowflow.example import isolator
from slowflow_kernels.conventions import Status


@dataclass(frozen=True)
class Size:
    """How much is measured."""

    quartics: int = 2000
    points: int = 10**6
    rounds: int = 7
    detachments: int = 10**6
    designs: int = 10**5
    imports: int = 15
    memory: int = 10**7


SMALL = Size(200, 20000, 2, 10**4, 10**3, 3, 10**6)
EARLIER = "measured earlier, on"
#: from this status on, a design was not solved although it has an answer
UNSOLVED = Status.NO_BOUND
#: designs whose curves are drawn at once, 30 kB each
CURVES = 1000


def measure(size: Size, before: dict[str, Any]) -> list[dict[str, Any]]:
    """All rows. before: what was measured last."""
    found: list[Row] = []
    for part in GROUPS:
        print(f"{part.__name__} ...", file=sys.stderr, flush=True)
        found += part(size)
    return with_others([asdict(row) for row in found], before)


def with_others(rows: list[dict[str, Any]], before: dict[str, Any]) -> list[dict[str, Any]]:
    """The rows, in which other programs that are not installed have what was last measured of them, which says so."""
    known = {row["job"]: row.get("others", {}) for row in before.get("rows", ())}
    for row in rows:
        for name, text in row["others"].items():
            old = known.get(row["job"], {}).get(name)
            if text is None and old is not None:
                note = "" if EARLIER in old else f" ({EARLIER} {before['environment']['processor']})"
                row["others"][name] = old + note
    return rows


def check(right: bool, job: str) -> None:
    """Raise RuntimeError unless the answers are right."""
    if not right:
        raise RuntimeError(f"{job}: the answers are wrong")


def rate(count: int, seconds: float) -> str:
    """So many a second."""
    return quantity(count / seconds, "per second")


def quartics(size: Size) -> list[Row]:
    """The installed solver on the families where it does worst."""
    job, found = "Ω roots of one quartic", bench_roots.measure(size.quartics, size.rounds)

    def spread(name: str, between: str) -> str:
        times = [result.seconds for result in found[name].values()]
        return between.join(quantity(pick(times), "s") for pick in (min, max))

    def wrong(name: str) -> str:
        number = sum(result.wrong for result in found[name].values())
        return f"{number} wrong counts" if name == bench_roots.OURS else f"{number} wrong counts of {total}"

    ours, total = found.pop(bench_roots.OURS), size.quartics * len(bench_roots.FAMILIES)
    error, count = max(result.error for result in ours.values()), sum(result.wrong for result in ours.values())
    check(count == 0 and error <= 1, job)
    others = {name: f"{name} {spread(name, ' to ')}, {wrong(name)}" if name in found else None for name in (BOOST, ACM)}
    slowest = max(result.seconds for result in ours.values())
    title = f"{job}, slowest of {len(ours)} families"
    rows = [Row(title, slowest, "s", "", f"{error:.2g} u(1+κ), {count} wrong counts", others)]
    for name in [name for name in found if name not in others]:
        family = min(ours, key=lambda family: found[name][family].seconds / ours[family].seconds)
        theirs = found[name][family].seconds
        rows.append(
            Row(
                f"{job}: time of {name} relative to slowflow, smallest of {len(ours)} families",
                *(theirs / ours[family].seconds, "×", f"{quantity(theirs, 's')} ({family})"),
                f"other tool {max(result.error for result in found[name].values()):.2g} u(1+κ), {wrong(name)}",
            )
        )
    return rows


def kernels(size: Size) -> list[Row]:
    """H and H' together, attached and detached."""
    found = bench_kernels.measure(size.points, size.rounds)
    rows = []
    for regime in ("attached", "detached"):
        of = [result for family, result in found.items() if family.startswith(regime)]
        slowest = max(of, key=lambda result: result.seconds)
        ratios = sorted(result.by_sympy / result.seconds for result in of)
        between = " to ".join(quantity(ratio, "×") for ratio in dict.fromkeys((ratios[0], ratios[-1])))
        several = f" of {len(of)} families" if len(of) > 1 else ""
        slow, least = (f", {which}{several}" if several else "" for which in ("slowest", "smallest"))
        error, theirs = max(result.error for result in of), max(result.error_by_sympy for result in of)
        rows += [
            Row(f"H and H′, {regime}, per point{slow}", slowest.seconds, "s", "", f"{error:.2g} u(1+κ)"),
            Row(
                f"H and H′, {regime}: time of lambdify(cse=True) relative to slowflow{least}",
                *(ratios[0], "×", f"{between}; lambdify {quantity(slowest.by_sympy, 's')}"),
                f"lambdify {theirs:.2g} u(1+κ)",
            ),
        ]
    return rows


def answered(jobs: Iterable[str], rounds: int) -> dict[str, dict[str, Any]]:
    """Answers to jobs, by name, from a process of its own, in turn."""
    remote = Remote("benchmarks.jobs")
    try:
        answers, failures = in_turn({name: (remote, name) for name in jobs}, rounds)
    finally:
        remote.stop()
    if failures:
        raise RuntimeError(f"jobs failed: {failures}")
    for name, answer in answers.items():
        check(answer.get("status", 0) < UNSOLVED, name)
    return answers


def largest_error(found: Iterable[Iterable[float]], exact: Iterable[Iterable[Any]]) -> float:
    """The largest relative error of vectors."""
    return max(
        certified.relative_error(value, digits)
        for vector, expected in zip(found, exact, strict=True)
        for value, digits in zip(vector, expected, strict=True)
    )


def curves(size: Size) -> list[Row]:
    """The response curve with its folds, the fold locus with its cusps."""
    answers = answered(["curve", "locus"], size.rounds)
    curve, locus = answers["curve"], answers["locus"]
    folds, cusp = largest_error(curve["found"], certified.folds()), largest_error([locus["cusp"]], [certified.onset()])
    check(folds <= 1e-13, "folds of Table 1")
    table_1 = certified.Table1()
    on_locus = max(table_1.fold_error(Omega, A) for Omega, A in locus["found"])
    return [
        Row(
            f"response curve with stability and folds, {curve['points']} points",
            *(curve["seconds"], "s", "", f"folds {folds:.1e} relative"),
        ),
        Row(
            f"fold locus, {locus['points']} points, and cusps",
            *(locus["seconds"], "s", "", f"points {on_locus:.2g} u(1+κ), cusp {cusp:.1e} relative"),
        ),
    ]


def batches(size: Size) -> list[Row]:
    """Questions about many designs on one core: critical forcings, folds, peaks, states, whole curves."""
    known = certified.designs()
    critical = (
        ("F_cr and Ω_cr", f"detachment | {size.detachments}", size.detachments, "detachment", known.detachment),
        ("F_SN with (Ω, A)", f"saddle_node_onset | {size.designs}", size.designs, "onset", known.onset),
    )
    questions = {"saddle_nodes": "folds at F_0", "peak": "peak at F_0", "amplitudes": "states at (Ω, F_0)"}
    drawn = min(size.designs, CURVES)
    drawing = f"random | frequency_response | {drawn}"
    names = [f"{kind} | {batch}" for kind in ("random", "Table 1") for _, batch, *_ in critical]
    names += [f"random | {question} | {size.designs}" for question in questions]
    requests = [*names, drawing, "curve", "certified detachment", "certified onset"]
    answers = answered(requests, min(size.rounds, 3))
    rows = []
    for title, batch, count, key, exact in critical:
        error = largest_error(answers[f"certified {key}"]["found"], exact)
        rows.append(
            Row(
                f"{title}, {count} random designs, one core",
                *(count / answers[f"random | {batch}"]["seconds"], "per second"),
                f"Table 1 with λ from 2 to 4: {rate(count, answers[f'Table 1 | {batch}']['seconds'])}",
                f"{error:.1e} relative, {len(exact)} certified isolators",
            )
        )
    for question, title in questions.items():
        seconds = answers[f"random | {question} | {size.designs}"]["seconds"]
        rows.append(Row(f"{title}, {size.designs} random designs, one core", size.designs / seconds, "per second"))
    title = f"response curves with stability and folds, {drawn} random designs, 1000 points each, one core"
    single = f"single calls {rate(1, answers['curve']['seconds'])}"
    return [*rows, Row(title, drawn / answers[drawing]["seconds"], "per second", single)]


def cores(size: Size) -> list[Row]:
    """How much more so many workers do than one, question by question, by the clock on the wall, at their best."""
    there = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    titles = {"saddle_node_onset": "F_SN", "saddle_nodes": "folds", "peak": "peaks", "amplitudes": "states"}
    workers = sorted({1, *(2**power for power in range(there.bit_length())), there})
    names = {(question, n): f"workers {n} | {question} | {size.designs}" for question in titles for n in workers}
    answers = answered(names.values(), min(size.rounds, 5))
    rows = []
    for question, title in titles.items():
        least = {n: answers[names[question, n]]["least"] for n in workers}
        each = ", ".join(f"{n}: {rate(size.designs, seconds)}" for n, seconds in least.items())
        job = f"speed-up of {title}, {size.designs} designs, {there} cores"
        rows.append(Row(job, least[1] / least[there], "×", f"workers {each}"))
    return rows


#: whose gradients are measured; F_0 first, then Omega
ANSWERS: dict[str, dict[str, float]] = {
    "saddle_node_onset": {},
    "saddle_nodes": {"F_0": 0.04},
    "peak": {"F_0": 0.04},
    "amplitudes": {"F_0": 0.04, "Omega": 0.6},
    "frequency_response": {"F_0": 0.04},
}


def gradients(size: Size) -> list[Row]:
    """Gradients over their answers, each of an oscillator made anew, on Table 1 and on random designs."""
    count = max(size.designs // 10, 100)
    designs = random_designs(count)
    rows = []
    for where, made, rounds in (
        *((f"Table 1, {excited}", partial(isolator, excitation=excited), 20) for excited in ("force", "base")),
        (f"{count} random designs", lambda: designs, 1),
    ):
        ratios = {}
        for question, at in ANSWERS.items():
            if made() is designs and question == "frequency_response":
                continue  # curves of many designs have no gradient of each point
            answering, differentiating = [], []
            for _ in range(rounds * size.rounds):
                start = time.perf_counter()
                answer = getattr(made(), question)(**at)
                between = time.perf_counter()
                answer.gradient()
                answering.append(between - start)
                differentiating.append(time.perf_counter() - between)
            ratios[question] = float(np.median(differentiating) / np.median(answering))
        each = ", ".join(f"{question} {ratio:.2g} ×" for question, ratio in ratios.items())
        rows.append(
            Row(f"time of a gradient relative to its result, {where}, largest ratio", max(ratios.values()), "×", each)
        )
    return rows


def second(size: Size) -> list[Row]:
    """The second approximation: a curve with its folds, and batches."""
    fractions = {"saddle_node_onset": 1.0, "detachment": 1.0, "saddle_nodes": 0.01, "peak": 0.01}
    counts = {name: round(size.designs * fraction) for name, fraction in fractions.items()}
    names = {name: f"second | {name} | {count}" for name, count in counts.items()}
    answers = answered(["second curve", "curve", *names.values()], min(size.rounds, 3))
    curve, first = answers["second curve"], answers["curve"]
    known = json.loads((ROOT / "tests" / "data" / "second.json").read_text())["table 1"]["folds"]
    with workdps(certified.DIGITS):
        error = largest_error(curve["found"], [[mpf(digits) for digits in fold] for fold in known])
    check(error <= 1e-13, "folds of the second approximation")
    many = ", ".join(f"{name} {rate(count, answers[names[name]]['seconds'])}" for name, count in counts.items())
    return [
        Row(
            f"second approximation: curve, {curve['points']} points, stability, folds",
            *(curve["seconds"], "s", f"averaging {quantity(first['seconds'], 's')}; random designs: {many}"),
            f"folds {error:.1e} relative, 30 digits",
        )
    ]


def motions(size: Size) -> list[Row]:
    """The equation of motion itself: times, residuals and folds."""
    states = example.isolator(force="untruncated").amplitudes(Omega=np.linspace(0.5, 1.5, 300), F_0=0.04)
    per_state = bench_exact.median(states.measure, min(size.rounds, 3)) / len(states)
    curve = bench_exact.exact_response(bench_exact.table_1(True), certified.F_0)
    residual, _ = bench_exact.residuals(curve)
    error = largest_error([[fold.Omega for fold in curve.folds]], [certified.exact_folds()])
    check(residual <= 1e-12 and error <= 1e-13, "the exact curve of Table 1")
    return [
        *bench_exact.by_job(5 * size.rounds),
        Row("exact: error of an averaged state by `.measure()`", per_state, "s"),
        Row("exact: first result of a new process, import included", footprint.answering(), "s"),
        Row("exact: residual of periodicity, largest on the curve", residual, ""),
        Row("exact: error of the fold frequencies, against 40 digits", error, ""),
    ]


def starting(size: Size) -> list[Row]:
    """The import."""
    ours, numpy = footprint.importing(size.imports)
    return [Row("import of slowflow, without the import of NumPy", ours, "s", f"NumPy {quantity(numpy, 's')}")]


def remembering(size: Size) -> list[Row]:
    """Memory of a batch of F_cr; a tenth of the designs should need as much."""
    (tenth, _), (whole, answers) = (footprint.memory(n) for n in (size.memory // 10, size.memory))
    megabytes: Callable[[float], str] = lambda size: quantity(size / 1e6, "MB")  # noqa: E731
    return [
        Row(
            f"memory of a batch of {size.memory:.0e} designs, besides arguments and results",
            *(whole / 1e6, "MB", f"with a tenth of the designs {megabytes(tenth)}; results {megabytes(answers)}"),
        )
    ]


GROUPS = (quartics, kernels, curves, batches, cores, gradients, second, motions, starting, remembering)
