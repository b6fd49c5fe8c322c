"""The numbers to reach: each measured on the installed package, beside what it is compared with, in one run.

Out: one dictionary for each target: job, target, measured, reached; `ratio` and `error` are texts.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np
from mpmath import mpf, workdps

from benchmarks import bench_exact, bench_kernels, bench_roots, certified, footprint
from benchmarks.bench_solver import random_designs
from benchmarks.document import quantity
from benchmarks.remote import ROOT, Remote, in_turn
from slowflow.example import isolator


@dataclass(frozen=True)
class Size:
    """How much is measured."""

    quartics: int = 2000
    points: int = 10**6
    rounds: int = 7
    precision_rounds: int = 3
    detachments: int = 10**6
    onsets: int = 10**5
    imports: int = 15
    memory: int = 10**7


EARLIER = "measured earlier, on"
#: from this status on, a design was not solved although it has an answer
UNSOLVED = 5
#: designs whose curves are drawn at once, 30 kB each
CURVES = 1000
#: designs of a batch without compiled code, one of the powers of ten of `benchmarks.jobs`
SMALL = Size(200, 20000, 2, 1, 10**4, 10**3, 3, 10**6)


@dataclass(frozen=True)
class Target:
    """One line of the table; `limit` names what `benchmarks.limits` explains if it is not reached."""

    job: str
    target: float
    measured: float
    unit: str
    at_most: bool
    ratio: str
    error: str
    limit: str
    sound: bool = True
    #: others on the same scenes, by name: what was measured of them, None where they are not at hand
    others: dict[str, str | None] = field(default_factory=dict)
    #: nanoseconds, least and most, of the one whose times were known when the targets were set
    known: list[float] = field(default_factory=list)

    @property
    def reached(self) -> bool:
        """Whether the measured value is within the target and the answers are as right as they have to be."""
        within = self.measured <= self.target if self.at_most else self.measured >= self.target
        return within and self.sound


def measure(size: Size) -> list[dict[str, Any]]:
    """All targets."""
    found: list[Target] = []
    for part in GROUPS:
        print(f"{part.__name__} ...", file=sys.stderr, flush=True)
        found += part(size)
    return [{**asdict(row), "reached": row.reached} for row in found]


def with_earlier(rows: list[dict[str, Any]], before: dict[str, Any]) -> list[dict[str, Any]]:
    """The rows, in which others that are not at hand have what was last measured of them, which says so."""
    known = {row["job"]: row.get("others", {}) for row in before.get("rows", ())}
    for row in rows:
        for name, text in row["others"].items():
            old = known.get(row["job"], {}).get(name)
            if text is None and old is not None:
                note = "" if EARLIER in old else f" ({EARLIER} {before['environment']['processor']})"
                row["others"][name] = old + note
    return rows


def quartics(size: Size) -> list[Target]:
    """The installed solver in the scene where it does worst."""
    rows = bench_roots.rows(size.quartics, size.rounds)
    of = {(row["scene"], row["method"]): row for row in rows}
    ours = "installed"
    slowest = max((of[scene, ours] for scene in bench_roots.SCENES), key=lambda row: row["ns"])
    out = []
    job = "Ω roots of one quartic"
    wrong = sum(of[scene, ours]["wrong_counts"] for scene in bench_roots.SCENES)
    largest = max(of[scene, ours]["error_max"] for scene in bench_roots.SCENES)
    error = f"{largest:.2g} u(1+κ), {wrong} wrong counts"
    sound = wrong == 0 and largest <= 1
    out.append(
        Target(
            f"{job}, slowest of {len(bench_roots.SCENES)} families",
            *(40e-9, slowest["ns"] * 1e-9, "s", True),
            "",
            *(error, "quartic", sound),
        )
    )
    for method, least in (("numpy.roots loop", 60), ("companion eigenvalues, batched", 8)):
        ratios = {scene: of[scene, method]["ns"] / of[scene, ours]["ns"] for scene in bench_roots.SCENES}
        scene = min(ratios, key=ratios.__getitem__)
        theirs = [of[s, method] for s in bench_roots.SCENES]
        out.append(
            Target(
                f"{job}: time of {method} over slowflow's, smallest of {len(ratios)} families",
                *(least, ratios[scene], "×", False),
                f"{quantity(of[scene, method]['ns'] * 1e-9, 's')} ({scene})",
                f"theirs {max(row['error_max'] for row in theirs):.2g} u(1+κ), "
                f"{sum(row['wrong_counts'] for row in theirs)} wrong counts of {size.quartics * len(theirs)}",
                "quartic",
            )
        )
    for name in (bench_roots.BOOST, bench_roots.ACM):
        rows_of = [of[scene, name] for scene in bench_roots.SCENES if (scene, name) in of]
        text = _of_peer(name, rows_of, size) if rows_of else None
        out[0] = replace(out[0], others={**out[0].others, name: text})
        if name == bench_roots.BOOST and rows_of:
            out[0] = replace(out[0], known=[pick(row["ns"] for row in rows_of) for pick in (min, max)])
    return out


def _of_peer(name: str, rows: list[dict[str, Any]], size: Size) -> str:
    """Another quartic on the same scenes."""
    least, most = (quantity(pick(row["ns"] for row in rows) * 1e-9, "s") for pick in (min, max))
    wrong = sum(row["wrong_counts"] for row in rows)
    return f"{name} {least} to {most}, {wrong} wrong counts of {size.quartics * len(rows)}"


def kernels(size: Size) -> list[Target]:
    """H and H' together, attached and detached."""
    rows = bench_kernels.rows(size.points, size.rounds)
    ours = "native"
    out = []
    for regime, at_most in (("attached", 2e-9), ("detached", 20e-9)):
        of = {(row["scene"], row["method"]): row for row in rows if row["scene"].startswith(regime)}
        scenes = list(dict.fromkeys(scene for scene, _ in of))
        slowest = max(scenes, key=lambda scene: of[scene, ours]["ns"])
        ratios = [of[scene, "lambdify(cse=True)"]["ns"] / of[scene, ours]["ns"] for scene in scenes]
        error = f"{max(of[scene, ours]['error_max'] for scene in scenes):.2g} u(1+κ)"
        job = f"H and H′, {regime}, a point"
        out.append(
            Target(
                f"{job}, slowest of {len(scenes)} families" if len(scenes) > 1 else job,
                *(at_most, of[slowest, ours]["ns"] * 1e-9, "s", True),
                f"as NumPy has it {quantity(of[slowest, 'NumPy']['ns'] * 1e-9, 's')}",
                *(error, "kernel"),
            )
        )
        theirs = f"{max(of[scene, 'lambdify(cse=True)']['error_max'] for scene in scenes):.2g} u(1+κ)"
        out.append(
            Target(
                f"H and H′, {regime}: time of lambdify(cse=True) over slowflow's, smallest of {len(scenes)}",
                *(10, min(ratios), "×", False),
                f"{' to '.join(quantity(ratio, '×') for ratio in sorted({min(ratios), max(ratios)}))}; "
                f"theirs {quantity(of[slowest, 'lambdify(cse=True)']['ns'] * 1e-9, 's')}",
                *(f"theirs {theirs}", "kernel"),
            )
        )
    return out


def answered(jobs: Iterable[str], rounds: int) -> dict[str, dict[str, Any]]:
    """Answers to jobs, by name, from a process of its own that is asked in turn."""
    remote = Remote("benchmarks.jobs")
    try:
        answers, failures = in_turn({name: (remote, name) for name in jobs}, rounds)
    finally:
        remote.stop()
    if failures:
        raise RuntimeError(f"jobs failed: {failures}")
    return answers


def curves(size: Size) -> list[Target]:
    """The response curve with its folds, the fold locus with its cusps."""
    answers = answered(["curve", "locus"], size.rounds)
    curve, locus = answers["curve"], answers["locus"]
    folds = [
        certified.relative_error(value, exact)
        for found, expected in zip(curve["folds"], certified.folds(), strict=True)
        for value, exact in zip(found, expected, strict=True)
    ]
    table_1 = certified.Table1()
    on_locus = [table_1.fold_error(Omega, A) for Omega, A in locus["some"]]
    cusp = [
        certified.relative_error(value, exact) for value, exact in zip(locus["cusp"], certified.onset(), strict=True)
    ]
    return [
        Target(
            f"whole response curve, {curve['points']} points, stability, folds",
            *(0.5e-3, curve["seconds"], "s", True),
            "",
            f"folds {max(folds):.1e} relative",
            "curve",
            max(folds) <= 1e-13,
        ),
        Target(
            f"fold locus, {locus['points']} points, and cusps",
            *(0.5e-3, locus["seconds"], "s", True),
            "",
            f"points {max(on_locus):.2g} u(1+κ), cusp {max(cusp):.1e} relative",
            "locus",
        ),
    ]


def batches(size: Size) -> list[Target]:
    """Critical forcings of many designs on one core."""
    count = {"detachment": size.detachments, "saddle_node_onset": size.onsets}
    names = [f"{kind} {name} {n}" for kind in ("random", "Table 1") for name, n in count.items()]
    answers = answered([*names, "certified detachment", "certified onset"], min(size.rounds, 3))
    known = certified.designs()
    out = []
    for (name, n), (title, least, key, exact) in zip(
        count.items(),
        (
            ("F_cr and Ω_cr", 2e6, "certified detachment", known.detachment),
            ("F_SN with (Ω, A)", 1e6, "certified onset", known.onset),
        ),
        strict=True,
    ):
        answer, near = answers[f"random {name} {n}"], answers[f"Table 1 {name} {n}"]
        rate = n / answer["seconds"]
        errors = [
            max(certified.relative_error(value, digits) for value, digits in zip(found, row, strict=True))
            for found, row in zip(answers[key]["found"], exact, strict=True)
        ]
        out.append(
            Target(
                f"{title}, {n} random designs, one core",
                *(least, rate, "per second", False),
                f"Table 1 with λ from 2 to 4 {quantity(n / near['seconds'], 'per second')}",
                f"{max(errors):.1e} relative, {len(exact)} certified isolators",
                *(name, answer["status"] < UNSOLVED),
            )
        )
    return out


def cores(size: Size) -> list[Target]:
    """How much more so many workers do than one, question by question, by the clock on the wall, at their best."""
    there = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    titles = {"saddle_node_onset": "F_SN", "saddle_nodes": "folds", "peak": "peaks", "amplitudes": "states"}
    workers = sorted({1, *(2**power for power in range(there.bit_length())), there})
    names = {(question, n): f"cores {question} {size.onsets} {n}" for question in titles for n in workers}
    answers = answered(names.values(), min(size.rounds, 5))
    out = []
    for question, title in titles.items():
        taken = {n: answers[names[question, n]]["least"] for n in workers}
        each = ", ".join(f"{n}: {quantity(size.onsets / seconds, 'per second')}" for n, seconds in taken.items())
        out.append(
            Target(
                f"speed-up of {title}, {size.onsets} designs, {there} cores",
                *(0.8 * there, taken[1] / taken[there], "×", False),
                f"workers {each}",
                *("", "cores"),
            )
        )
    return out


def rates(size: Size) -> list[Target]:
    """Answers a second on one core, of random designs: folds, peaks, states, whole curves."""
    targets = {
        "saddle_nodes": ("every fold at F_0", 3e5),
        "peak": ("highest peak at F_0", 1e6),
        "amplitudes": ("states at (Ω, F_0)", 2e6),
    }
    names = [f"random {name} {size.onsets}" for name in targets]
    drawn = min(size.onsets, CURVES)
    drawing = f"random frequency_response {drawn}"
    answers = answered([*names, drawing, "curve"], min(size.rounds, 3))
    out = []
    for name, (title, least) in targets.items():
        answer = answers[f"random {name} {size.onsets}"]
        out.append(
            Target(
                f"{title}, {size.onsets} random designs, one core",
                *(least, size.onsets / answer["seconds"], "per second", False),
                "",
                *("", name, answer["status"] < UNSOLVED),
            )
        )
    curve, curves = answers["curve"], answers[drawing]
    out.append(
        Target(
            f"whole curves of {drawn} random designs, 1000 points, stability, folds, one core",
            *(15e3, drawn / curves["seconds"], "per second", False),
            f"one at a time {quantity(1 / curve['seconds'], 'per second')}",
            *("", "curve", curves["status"] < UNSOLVED),
        )
    )
    return out


#: what gradients are asked of; F_0 first, then Omega
ANSWERS: dict[str, dict[str, float]] = {
    "saddle_node_onset": {},
    "saddle_nodes": {"F_0": 0.04},
    "peak": {"F_0": 0.04},
    "amplitudes": {"F_0": 0.04, "Omega": 0.6},
    "frequency_response": {"F_0": 0.04},
}


def gradients(size: Size) -> list[Target]:
    """Gradients over their answers, each asked of an oscillator made anew, on Table 1 and on random designs."""
    count = max(size.onsets // 10, 100)
    designs = random_designs(count, 5)
    out = []
    for where, made in (
        *((f"Table 1, {excited}", partial(isolator, excitation=excited)) for excited in ("force", "base")),
        (f"{count} random designs", lambda: designs),
    ):
        ratios = {}
        for question, at in ANSWERS.items():
            if made() is designs and question == "frequency_response":
                continue  # curves of many designs have no gradient of each point
            answering, moving = [], []
            for _ in range(20 * size.rounds if made() is not designs else size.rounds):
                start = time.perf_counter()
                answer = getattr(made(), question)(**at)
                answered = time.perf_counter()
                answer.gradient()
                answering.append(answered - start)
                moving.append(time.perf_counter() - answered)
            ratios[question] = float(np.median(moving) / np.median(answering))
        worst = max(ratios, key=lambda question: ratios[question])
        each = ", ".join(f"{question} {ratio:.2g} ×" for question, ratio in ratios.items())
        out.append(
            Target(
                f"time of a gradient over that of its result, {where}, largest",
                *(2.0, ratios[worst], "×", True),
                each,
                "",
                "",
            )
        )
    return out


def second(size: Size) -> list[Target]:
    """The second approximation: a curve with its folds, and batches."""
    fractions = {"saddle_node_onset": 1.0, "detachment": 1.0, "saddle_nodes": 0.01, "peak": 0.01}
    counts = {name: 10 ** round(np.log10(size.onsets * fraction)) for name, fraction in fractions.items()}
    names = [f"second {name} {count}" for name, count in counts.items()]
    answers = answered(["second curve", "curve", *names], min(size.rounds, 3))
    curve, first = answers["second curve"], answers["curve"]
    known = json.loads((ROOT / "tests" / "data" / "second.json").read_text())["table 1"]["folds"]
    with workdps(certified.DIGITS):
        errors = [
            certified.relative_error(value, mpf(digits))
            for found, expected in zip(curve["folds"], known, strict=True)
            for value, digits in zip(found, expected, strict=True)
        ]
    many = ", ".join(
        f"{name} {quantity(count / answers[f'second {name} {count}']['seconds'], 'per second')}"
        for name, count in counts.items()
    )
    return [
        Target(
            f"second approximation: curve, {curve['points']} points, stability, folds",
            *(0.4e-3, curve["seconds"], "s", True),
            f"averaging {quantity(first['seconds'], 's')}; random designs: {many}",
            *(f"folds {max(errors):.1e} relative, 30 digits", "second", max(errors) <= 1e-13),
        )
    ]


def motions(size: Size) -> list[Target]:
    """The equation of motion itself: times, residuals and folds."""
    system = bench_exact.table_1(True)
    out = []
    for job, seconds, by_heyoka in bench_exact.in_turn(5 * size.rounds):
        if job.bound is None:
            continue
        comparison = (
            f"heyoka {quantity(by_heyoka, 's')}, {by_heyoka / seconds:.3g} ×" if by_heyoka else "heyoka has no wheels"
        )
        limit = "motion" if job.name == bench_exact.TURNS else ""
        out.append(Target(f"exact: {job.name}", *(1e-3 * job.bound, seconds, "s", True), comparison, "", limit))
    for row in (*bench_exact.measured(), *bench_exact.first_answer()):
        scale = 1e-3 if row.unit == "ms" else 1.0
        out.append(Target(f"exact: {row.job}", *(scale * row.bound, scale * row.measured, "s", True), "", *("", "")))
    curve = bench_exact.exact_response(system, certified.F_0)
    smooth = [i for i, point in enumerate(curve.states) if point.role not in ("border", "corner")]
    residual = max(curve.steady_state(i).residual for i in smooth)
    exact = certified.exact_folds()
    error = max(certified.relative_error(fold.Omega, Omega) for fold, Omega in zip(curve.folds, exact, strict=True))
    out += [
        Target("exact: residual of periodicity, largest on the curve", *(1e-14, residual, "", True), "", *("", "")),
        Target("exact: Omega of the folds against 40 digits", *(1e-13, error, "", True), "", *("", "")),
    ]
    return out


def starting(size: Size) -> list[Target]:
    """The import."""
    ours, numpy = footprint.importing(size.imports)
    return [
        Target(
            "import of slowflow, without that of NumPy",
            *(30e-3, ours, "s", True, f"NumPy {quantity(numpy, 's')}", "", "import"),
        )
    ]


def remembering(size: Size) -> list[Target]:
    """Memory of a batch of F_cr; a tenth of the designs should need as much."""
    tenth, whole = (footprint.memory(n) for n in (size.memory // 10, size.memory))
    megabyte: Callable[[float], str] = partial(quantity, unit="MB")
    return [
        Target(
            f"memory of a batch of {size.memory:.0e} designs, beyond inputs and answers",
            *(1.0, whole["beyond"] / 1e6, "MB", True),
            f"a tenth of the designs {megabyte(tenth['beyond'] / 1e6)}; answers {megabyte(whole['answers'] / 1e6)}",
            *("", "memory"),
        )
    ]


GROUPS = (quartics, kernels, curves, batches, rates, cores, gradients, second, motions, starting, remembering)
