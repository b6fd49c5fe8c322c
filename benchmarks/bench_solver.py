"""The solvers on the paper's isolator (Table 1, F_0 = 0.04) and on batches: jobs in, time and rate of each out.

    curve        whole response: 1000 amplitudes, all branches, stability, folds      target 0.5 ms
    fold locus   1000 points and the cusps, across u_cr                               target 0.5 ms
    F_cr         with Omega_cr and u_cr, a batch on one core                          target 2e6 a second
    F_SN         with Omega and A, a batch on one core                                target 1e6 a second
    folds, peak  at a forcing, batches                                                no target
    curves       1000 points, all branches, stability, folds, a batch on one core     target 15e3 a second

All are called from Python. The batches of Table 1 vary lam; the random ones draw every parameter, so that the onset
lies in either regime or on the corner. All jobs are timed in turn in every round. `python -m benchmarks.bench_solver`
prints the table; `rows` gives it.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from slowflow import Isolator
from slowflow.averaged.many import Designs
from slowflow.example import TABLE_1, isolator

F_0 = 0.04


def table_1_designs(count: int) -> Designs:
    """Table 1 with lam from 2 to 4: the onset is a cusp below u_cr."""
    return Isolator.many(**{**TABLE_1, "lam": np.linspace(2, 4, count)})


def random_designs(count: int, seed: int) -> Designs:
    """Designs of the size that the test suite's random isolators have."""
    rng = np.random.default_rng(seed)
    lam, r = rng.uniform(1, 4, count), rng.uniform(0.4, 4, count)
    delta_h = np.minimum(rng.uniform(0.02, 0.97, count) / (lam * r), 0.9)
    mu = np.where(rng.random(count) < 0.15, 0.0, rng.uniform(0, 0.03, count))
    zeta = np.exp(rng.uniform(np.log(0.004), np.log(0.1), count))
    return Isolator.many(lam=lam, r=r, delta_h=delta_h, mu=mu, zeta=zeta)


def single() -> dict[str, tuple[Callable[[], Any], float | None]]:
    """Questions to one isolator, made anew each time, and the target in seconds."""

    def curve() -> Any:
        return isolator().frequency_response(F_0, samples=1000)

    def locus() -> Any:
        iso = isolator()
        return iso.fold_locus(samples=1000), iso.cusps()

    def folds() -> Any:
        return isolator().saddle_nodes(F_0)

    def onset() -> Any:
        return isolator().saddle_node_onset()

    return {
        "curve, 1000 amplitudes": (curve, 0.5e-3),
        "fold locus, 1000 points, and cusps": (locus, 0.5e-3),
        "folds": (folds, None),
        "onset": (onset, None),
    }


def batches(count: int, seed: int) -> dict[str, tuple[Callable[[], Any], int, float | None]]:
    """Questions to many isolators, their number, and the target in designs a second."""
    jobs: dict[str, tuple[Callable[[], Any], int, float | None]] = {}
    drawn = min(count, 2000)  # some 25 kB each
    few = random_designs(drawn, seed)
    jobs["curves, 1000 points, random"] = (lambda: few.frequency_response(F_0), drawn, 15e3)
    for name, designs in (("Table 1", table_1_designs(count)), ("random", random_designs(count, seed))):
        jobs |= {
            f"F_cr and Omega_cr, {name}": (designs.detachment, count, 2e6),
            f"F_SN with Omega and A, {name}": (designs.saddle_node_onset, count, 1e6),
            f"folds, {name}": (lambda designs=designs: designs.saddle_nodes(F_0), count, None),
            f"peak, {name}": (lambda designs=designs: designs.peak(F_0), count, None),
        }
    return jobs


def rows(count: int = 100_000, repeats: int = 7, seed: int = 5) -> list[dict[str, Any]]:
    """One dictionary for each job: its median time, the spread, the rate and the target."""
    jobs: dict[str, tuple[Callable[[], Any], int, float | None]] = {}
    for name, (job, seconds) in single().items():
        jobs[name] = (job, 1, None if seconds is None else 1 / seconds)
    jobs |= batches(count, seed)
    taken: dict[str, list[float]] = {name: [] for name in jobs}
    for _ in range(repeats):
        for name, (job, number, _target) in jobs.items():
            job()
            calls = 20 if number == 1 else 1
            start = time.perf_counter()
            for _ in range(calls):
                job()
            taken[name].append((time.perf_counter() - start) / calls)
    return [
        {
            "job": name,
            "designs": number,
            "seconds": float(np.median(taken[name])),
            "fastest": min(taken[name]),
            "per_second": number / float(np.median(taken[name])),
            "target_per_second": target,
        }
        for name, (_job, number, target) in jobs.items()
    ]


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--count", type=int, default=100_000)
    parser.add_argument("--repeats", type=int, default=7)
    options = parser.parse_args()
    print(f"{'job':40}{'designs':>9}{'median':>12}{'fastest':>12}{'a second':>12}{'target':>10}")
    for row in rows(options.count, options.repeats):
        target = f"{row['target_per_second']:10.2g}" if row["target_per_second"] else f"{'-':>10}"
        print(
            f"{row['job']:40}{row['designs']:9}{row['seconds'] * 1e3:9.3f} ms{row['fastest'] * 1e3:9.3f} ms"
            f"{row['per_second']:12.4g}{target}"
        )


if __name__ == "__main__":
    main()
