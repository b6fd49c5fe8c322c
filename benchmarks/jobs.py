"""What the targets are measured on, for `benchmarks.remote`: slowflow's public interface on whichever backend it loads.

Jobs on Table 1 answer with the numbers that `benchmarks.targets` checks against certified values; batches answer with a
rate's denominator only, and `certified` answers with the critical forcings of the 200 certified isolators.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from benchmarks import certified
from benchmarks.bench_solver import random_designs, table_1_designs
from benchmarks.remote import processor
from slowflow import Isolator
from slowflow.core.backend import SOLVER
from slowflow.example import isolator
from slowflow_kernels import rod_spring

Job = tuple[Callable[[], Any], Callable[[Any], dict[str, Any]]]
SAMPLES = 1000
CHECKED = 40
FAMILIES: dict[str, Callable[[int], Any]] = {"random": partial(random_designs, seed=5), "Table 1": table_1_designs}


def of_folds(found: tuple[Any, Any]) -> dict[str, Any]:
    """Points of the curve, and its folds."""
    curve, folds = found
    return {"points": len(curve.A), "folds": np.column_stack([folds.Omega, folds.A]).tolist()}


def of_locus(found: tuple[Any, Any]) -> dict[str, Any]:
    """Some points of the locus, evenly, and its lowest cusp."""
    locus, cusps = found
    some = np.linspace(0, len(locus) - 1, CHECKED).astype(int)
    return {
        "points": len(locus),
        "some": np.column_stack([locus.Omega, locus.A])[some].tolist(),
        "cusp": [float(cusps.F_0.min()), *(float(x[cusps.F_0.argmin()]) for x in (cusps.Omega, cusps.A))],
    }


def amplitudes(count: int) -> np.ndarray:
    """From above 0 to beyond the highest peak of Table 1 at F_0 = 0.04."""
    return np.linspace(0.0, 0.65, count + 1)[1:]


def of_rows(found: Any) -> dict[str, Any]:
    """Roots Omega of each amplitude."""
    return {"found": [list(map(float, row)) for row in found]}


def of_pairs(found: Any) -> dict[str, Any]:
    """(Omega, A) of each fold."""
    return {"found": [list(map(float, pair)) for pair in found]}


def of_pair(found: Any) -> dict[str, Any]:
    """F_SN, Omega, A."""
    return {"found": [list(map(float, found))]}


def of_response(found: tuple[np.ndarray, np.ndarray]) -> dict[str, Any]:
    """Roots of each amplitude without the unused places."""
    return {"found": [row[:count].tolist() for row, count in zip(*found, strict=True)]}


def of_saddle_nodes(found: Any) -> dict[str, Any]:
    """(Omega, A) of each fold."""
    return {"found": np.column_stack([found.Omega, found.A]).tolist()}


def of_batch(found: Any) -> dict[str, Any]:
    """The worst status; see `slowflow.averaged.many`."""
    return {"status": int(found.status.max())}


def of_onset(found: Any) -> dict[str, Any]:
    """F_SN, Omega, A."""
    return {"found": [[found.F_SN, found.Omega, found.A]]}


def response(at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Every Omega at each amplitude."""
    iso = isolator()
    h, _ = rod_spring.averaged_2(at, iso.alpha, iso.beta, iso.gamma, iso.u_cr)
    return SOLVER.response_roots(at, h, iso.sticking_forcing, iso.zeta, certified.F_0)


def clock(name: str) -> Callable[[], float]:
    """What a job is timed by: the processor's time, where it is not about how many of these there are."""
    return time.perf_counter if name.startswith("cores") else processor


def prepare() -> dict[str, Job]:
    """Jobs by name."""

    def curve() -> tuple[Any, Any]:
        iso = isolator()
        return iso.frequency_response(certified.F_0, samples=SAMPLES), iso.saddle_nodes(certified.F_0)

    def locus() -> tuple[Any, Any]:
        iso = isolator()
        return iso.fold_locus(samples=SAMPLES), iso.cusps()

    def second() -> tuple[Any, Any]:
        better = isolator().second_approximation
        return better.frequency_response(certified.F_0, samples=SAMPLES), better.saddle_nodes(certified.F_0)

    jobs: dict[str, Job] = {
        "curve": (curve, of_folds),
        "second curve": (second, of_folds),
        "locus": (locus, of_locus),
        "certified detachment": (
            lambda: Isolator.many(**certified.designs().parameters).detachment(),
            lambda found: {"found": np.column_stack([found.F_cr, found.Omega_cr]).tolist()},
        ),
        "certified onset": (
            lambda: Isolator.many(**certified.designs().parameters).saddle_node_onset(),
            lambda found: {"found": np.column_stack([found.F_SN, found.Omega, found.A]).tolist()},
        ),
    }
    jobs["response"] = partial(response, amplitudes(SAMPLES)), of_response
    jobs["folds"] = lambda: isolator().saddle_nodes(certified.F_0), of_saddle_nodes
    jobs["onset"] = lambda: isolator().saddle_node_onset(), of_onset
    for power in range(7):
        count = 10**power
        jobs[f"response {count}"] = partial(response, amplitudes(count)), lambda found: {"points": len(found[0])}
        for question in ("detachment", "saddle_node_onset"):
            for family in FAMILIES:
                jobs[f"{family} {question} {count}"] = batch(question, family, count), of_batch
        for workers in range(1, (os.cpu_count() or 1) + 1):
            jobs[f"cores saddle_node_onset {count} {workers}"] = (
                batch("saddle_node_onset", "random", count, workers=workers),
                of_batch,
            )
            for question in ("saddle_nodes", "peak"):
                job = batch(question, "random", count, above=0.03, workers=workers)
                jobs[f"cores {question} {count} {workers}"] = job, of_batch
            jobs[f"cores amplitudes {count} {workers}"] = states(count, workers), of_batch
        for question in ("saddle_nodes", "peak"):
            jobs[f"random {question} {count}"] = batch(question, "random", count, above=0.03), of_batch
            jobs[f"second {question} {count}"] = batch(question, "random", count, above=0.03, second=True), of_batch
        jobs[f"random amplitudes {count}"] = states(count), of_batch
        jobs[f"random frequency_response {count}"] = batch("frequency_response", "random", count, above=0.03), of_batch
        for question in ("detachment", "saddle_node_onset"):
            jobs[f"second {question} {count}"] = batch(question, "random", count, second=True), of_batch
    return jobs


def states(count: int, workers: int = 1) -> Callable[[], Any]:
    """The states of so many designs, each at a frequency of its own, 0.03 above sticking."""
    made: list[Any] = []

    def ask() -> Any:
        if not made:
            designs = FAMILIES["random"](count)
            Omega = np.random.default_rng(count).uniform(0.3, 1.5, count)
            F_0 = 4 / np.pi * designs.values["mu"] + 0.03
            made.append(partial(designs.amplitudes, Omega=Omega, F_0=F_0, workers=workers))
        return made[0]()

    return ask


def batch(
    question: str, family: str, count: int, *, above: float | None = None, second: bool = False, **arguments: Any
) -> Callable[[], Any]:
    """A question to so many designs, which are made at the first call; its forcing is so much above sticking.

    arguments -- further arguments of the question
    """
    made: list[Any] = []

    def ask() -> Any:
        if not made:
            designs = FAMILIES[family](count)
            made.append(designs.second_approximation if second else designs)
            if above is not None:
                made.append(4 / np.pi * designs.values["mu"] + above)
        return getattr(made[0], question)(*made[1:], **arguments)

    return ask
