"""Error against time, and time against size: methods on the same scenes in one run.

Out: scenes with one row for each method and variant, and times by size. Errors are relative, to
values certified at 40 digits; the error of a fold is the larger of its Omega's and its A's, that of the onset the
largest of F_SN, Omega and A. A value that is not found to 1 % counts as missed, one that matches none as false.
"""

from __future__ import annotations

import statistics
import sys
from collections.abc import Sequence
from typing import Any

import numpy as np

from benchmarks import certified, jobs
from benchmarks.baselines import METHODS
from benchmarks.bench_exact import by_stops
from benchmarks.document import with_earlier
from benchmarks.peers import bifpy
from benchmarks.peers.measure import interpreter
from benchmarks.remote import Failure, Remote, in_turn

MISSED = 0.01
OURS = "slowflow"
TITLES = {
    "response": "response at 1000 amplitudes: {} roots Ω",
    "folds": "both folds at F₀ = 0.04",
    "onset": "onset: lowest F₀ that has a fold",
}
#: how far a method's time is followed, in amplitudes and in designs
AMPLITUDES = {OURS: 6, METHODS[0]: 4, METHODS[1]: 4}
DESIGNS = {"detachment": 6, "saddle_node_onset": 5}
QUESTIONS = {"detachment": "F_cr", "saddle_node_onset": "F_SN"}


def judge(found: Sequence[Sequence[float]], expected: Sequence[Sequence[Any]]) -> tuple[list[float], int, int]:
    """Errors of the vectors found, how many were missed, how many are false."""
    errors, left = [], list(found)
    for exact in expected:
        distances = [
            max(certified.relative_error(value, digits) for value, digits in zip(vector, exact, strict=True))
            for vector in left
        ]
        if distances and min(distances) < MISSED:
            errors.append(min(distances))
            left.pop(int(np.argmin(distances)))
    return errors, len(expected) - len(errors), len(left)


def reference(samples: int) -> dict[str, list[list[list[Any]]]]:
    """By scene: lists of certified vectors, one list for each amplitude of the response."""
    table_1 = certified.Table1()
    return {
        "response": [[[Omega] for Omega in table_1.response(A)] for A in jobs.amplitudes(samples).tolist()],
        "folds": [[list(fold) for fold in certified.folds()]],
        "onset": [[list(certified.onset())]],
    }


def measure(rounds: int, before: dict[str, Any]) -> dict[str, Any]:
    """Scenes and scaling. before: what was measured last, for methods that cannot be run here."""
    remotes = {name: Remote(f"benchmarks.{name}") for name in ("jobs", "baselines")}
    try:
        sizes: dict[str, Any] = {**scaling(remotes, 1), "stops": by_stops(7 * rounds)}
        return {"scenes": [*precision(remotes, rounds), motion(before)], "scaling": sizes}
    finally:
        for remote in remotes.values():
            remote.stop()


def answers_to(requests: dict[str, tuple[Remote, str]], rounds: int) -> dict[str, dict[str, Any]]:
    """Answers in turn, by the keys of the requests."""
    answers, failures = in_turn(requests, rounds)
    if failures:
        raise RuntimeError(f"jobs failed: {failures}")
    return answers


def precision(remotes: dict[str, Remote], rounds: int) -> list[dict[str, Any]]:
    """One dictionary for each scene."""
    ours, others = remotes["jobs"], remotes["baselines"]
    requests = {f"{scene} | {OURS} | ": (ours, scene) for scene in TITLES}
    requests |= {job: (others, job) for job in others.jobs if job.split(" | ")[0] in TITLES}
    answers = answers_to(requests, rounds)
    certain = reference(jobs.SAMPLES)
    scenes = []
    for scene, title in TITLES.items():
        rows = []
        for key, answer in answers.items():
            of, method, variant = key.split(" | ")
            if of != scene:
                continue
            found = [[[x] for x in row] for row in answer["found"]] if scene == "response" else [answer["found"]]
            judged = [judge(f, w) for f, w in zip(found, certain[scene], strict=True)]
            errors = [error for each, _, _ in judged for error in each]
            rows.append(
                {
                    **{"method": method, "variant": variant, "seconds": answer["seconds"]},
                    "error": statistics.median(errors) if errors else None,
                    "error_max": max(errors, default=None),
                    "missed": sum(missed for _, missed, _ in judged),
                    "false": sum(false for _, _, false in judged),
                }
            )
        sought = sum(map(len, certain[scene]))
        scenes.append({"scene": scene, "title": title.format(sought), "sought": sought, "rows": rows})
    return scenes


def motion(before: dict[str, Any]) -> dict[str, Any]:
    """The scene of the equation of motion itself, in one round: some integrators take half a minute."""
    remotes, rows = [Remote("benchmarks.motions")], []
    missing: list[dict[str, Any]] = []
    try:
        remotes.append(Remote("benchmarks.peers.bifpy_motion", interpreter("bifpy", bifpy.PACKAGES)))
    except Failure as failure:
        missing.append({"method": bifpy.NAME, "failure": str(failure)})
        print(f"{bifpy.NAME}, exact motion: not measured here: {failure}", file=sys.stderr, flush=True)
    try:
        answers = answers_to({job: (remote, job) for remote in remotes for job in remote.jobs}, 1)
    finally:
        for remote in remotes:
            remote.stop()
    exact = certified.motion()
    for key, answer in answers.items():
        _, method, variant = key.split(" | ")
        (error,) = (certified.relative_error(A, exact) for A in answer["found"])
        row = {"method": method, "variant": variant, "seconds": answer["seconds"], "error": error, "error_max": error}
        rows.append({**row, "missed": int(error > MISSED), "false": 0})
    old = [row for scene in before.get("scenes", ()) if scene["scene"] == "motion" for row in scene["rows"]]
    kept = with_earlier([*rows, *missing], old, "method", before.get("environment", {}).get("processor"))
    shown = [row for row in kept if "seconds" in row]
    return {"scene": "motion", "title": "exact motion: its amplitude", "sought": 1, "rows": shown}


def scaling(remotes: dict[str, Remote], rounds: int) -> dict[str, list[dict[str, Any]]]:
    """Seconds by number of amplitudes (the response at them), and by number of designs (F_cr, F_SN)."""
    ours, others = remotes["jobs"], remotes["baselines"]
    requests: dict[str, tuple[Remote, str]] = {}
    for method, last in AMPLITUDES.items():
        for size in (10**power for power in range(last + 1)):
            job = (ours, f"response | {size}") if method == OURS else (others, f"response {size} | {method}")
            requests[f"amplitudes | {method} | {size}"] = job
    for question, last in DESIGNS.items():
        for size in (10**power for power in range(last + 1)):
            requests[f"designs | {QUESTIONS[question]}: {OURS} | {size}"] = ours, f"random | {question} | {size}"
    out: dict[str, list[dict[str, Any]]] = {"amplitudes": [], "designs": []}
    for key, answer in answers_to(requests, rounds).items():
        panel, method, size = key.split(" | ")
        out[panel].append({"method": method, "size": int(size), "seconds": answer["seconds"]})
    return out
