"""What each skip of a scene saves, for Table 1: rows with the time with and without it, taken in turn in one run.

    python -m benchmarks.bench_scenes

A ratio below 1 pays. `slowflow.averaged.plan` decides the skips; a skip that does not pay is taken out there.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from slowflow.averaged import solvers
from slowflow.core.model import Model
from slowflow.example import TABLE_1, isolator
from slowflow_kernels import duffing, rod_spring

WINDOW = (0.0, 2.0)


def paired(general: Callable[[], Any], scene: Callable[[], Any], repeats: int) -> tuple[float, float, float]:
    """Median seconds of both, taken in turn, and the median of their ratios scene/general."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        general()
        middle = time.perf_counter()
        scene()
        times.append((middle - start, time.perf_counter() - middle))
    without, with_ = zip(*times, strict=True)
    return (
        statistics.median(without),
        statistics.median(with_),
        statistics.median(b / a for a, b in times),
    )


def rows(repeats: int | None = None) -> list[dict[str, Any]]:
    """One row for each skip and question: names, seconds without and with it, ratio."""
    repeats = repeats or 300
    whole = isolator().model
    mu, zeta = whole.mu, whole.zeta
    no_preload = Model(rod_spring.MECHANISM, rod_spring.coefficients(TABLE_1["lam"], TABLE_1["r"], 0.0), mu, zeta)
    linear = Model(duffing.MECHANISM, (1.0, 0.0), mu, zeta)
    uninformed, informed = isolator(), isolator()
    informed.saddle_node_onset()
    Omega = np.array([0.8])

    def curve(model: Model, F_0: float) -> Callable[[], Any]:
        return lambda: solvers.frequency_response(model, F_0, 1000, WINDOW)

    def folds(model: Model, F_0: float) -> Callable[[], Any]:
        return lambda: solvers.folds(model, F_0)

    def states(model: Model, F_0: float) -> Callable[[], Any]:
        return lambda: solvers.states(model, Omega, F_0)

    pairs = [
        ("delta_h = 0: linear", "frequency_response", curve(no_preload, 0.04), curve(linear, 0.04)),
        ("delta_h = 0: linear", "amplitudes", states(no_preload, 0.04), states(linear, 0.04)),
        (
            "F_0 < F_SN, known",
            "saddle_nodes",
            lambda: uninformed.saddle_nodes(0.02),
            lambda: informed.saddle_nodes(0.02),
        ),
        (
            "F_0 < 4 mu/pi: sticks",
            "frequency_response",
            lambda: informed.frequency_response(0.0153),
            lambda: informed.frequency_response(0.0152),
        ),
        (
            "phase not asked for",
            "frequency_response",
            lambda: solvers.frequency_response(whole, 0.04, 1000, WINDOW).phi,
            curve(whole, 0.04),
        ),
    ]
    for name, m, z in (("mu = 0", 0.0, zeta), ("zeta = 0", mu, 0.0), ("mu = zeta = 0", 0.0, 0.0)):
        scene = Model(rod_spring.MECHANISM, whole.parameters, m, z)
        pairs.append((name, "frequency_response", curve(whole, 0.04), curve(scene, 0.04)))
    return [
        {
            "skip": skip,
            "question": question,
            **dict(zip(("without", "with", "ratio"), paired(a, b, repeats), strict=True)),
        }
        for skip, question, a, b in pairs
    ]


def main() -> None:
    print(f"{'skip':24}{'question':20}{'without':>10}{'with':>10}{'ratio':>7}")
    for row in rows():
        without, with_ = (f"{1e6 * row[key]:.0f} us" for key in ("without", "with"))
        print(f"{row['skip']:24}{row['question']:20}{without:>10}{with_:>10}{row['ratio']:7.2f}")


if __name__ == "__main__":
    main()
