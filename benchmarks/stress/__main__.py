"""`make stress`: search for the worst errors, count what is missed, write docs/stability.md and the baseline.

Out: benchmarks/results/stability.json, docs/stability.md and its pictures, tests/data/stability.json. Some minutes on
two cores. `--only answers counts` measures these anew and keeps the rest of the last results, `--draw` keeps all;
`--size 0.1` takes a tenth of the points. Counts against proofs are ten million, a million isolators among them.
"""

from __future__ import annotations

import argparse
import json
import math
import multiprocessing
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from benchmarks import environment
from benchmarks.document import DOCS, RESULTS
from benchmarks.stress import answers, baseline, counts, instead, kernels, page, proofs, roots, scale
from tests.oracles.kernels import scene_of

#: what can be measured apart
OF_COUNTS = ("counts", "counts on NumPy", "counts against proofs")
PARTS = ("answers", *OF_COUNTS, "proofs", "roots", "instead", "kernels", "extremes")
#: shares into which answers and counts are cut
SHARES = 8
#: oscillators of each share of the counts against proofs: with one forcing, and with many frequencies
FOLDS = {"rod_spring": 126_000, "duffing": 200_000}
STATES = {"rod_spring": 500, "duffing": 5_000}
#: points shown of each kernel and kind in a picture
SHOWN = 40
Job = tuple[Callable[..., Any], tuple[Any, ...]]


def jobs(size: float) -> dict[str, list[Job]]:
    """All there is to measure, the longest first."""

    def many(count: int, least: int = 1) -> int:
        return max(least, round(count * size))

    return {
        "answers": [
            (answers.stress, (mechanism, part, many(24 if mechanism != "rod_spring_untruncated" else 8), 2, many(60)))
            for mechanism in answers.NAMES
            for part in range(SHARES)
        ],
        "counts": [
            (counts.stress, (mechanism, part, many(25 if mechanism == "rod_spring" else 80)))
            for mechanism in counts.ORACLES
            for part in range(SHARES)
        ],
        "counts on NumPy": [
            (counts.on_numpy, (mechanism, 100, many(4 if mechanism == "rod_spring" else 12)))
            for mechanism in counts.ORACLES
        ],
        "counts against proofs": [
            (count, (kind, part, many(number)))
            for count, numbers in ((scale.folds, FOLDS), (scale.states, STATES))
            for kind, number in numbers.items()
            for part in range(SHARES)
        ],
        "proofs": [(proofs.stress, (part, many(125))) for part in range(SHARES)],
        "roots": [(roots.stress, (kind, family, many(4000, 50), many(1500))) for kind, family in roots.jobs()],
        "instead": [(instead.quartics, (many(2000, 50), roots.SEED))],
        "kernels": [(kernels.stress, (module, kernel, size)) for module, kernel in kernels.named()],
        "extremes": [
            (extremes, (module, kernel, many(12, 4))) for module, kernel in kernels.named() if scene_of(module)[1] == ""
        ],
    }


def extremes(module: str, kernel: str, count: int) -> dict[str, Any]:
    """With the kernel's name."""
    return {"module": module, "kernel": kernel, "found": kernels.extremes(module, kernel, count)}


def run(job: tuple[str, Job]) -> tuple[str, Any, float]:
    """One job, with what it belongs to and the processor's seconds."""
    what, (function, arguments) = job
    start = time.process_time()
    return what, function(*arguments), time.process_time() - start


def measure(size: float, only: list[str]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Results by what they are about, in the order of the jobs; and for each the size and the processor's seconds."""
    listed = [(what, job) for what, group in jobs(size).items() if what in only for job in group]
    found: dict[str, list[Any]] = {}
    seconds = dict.fromkeys(only, 0.0)
    with multiprocessing.Pool() as pool:
        for k, (what, result, cost) in enumerate(pool.imap(run, listed)):
            found.setdefault(what, []).append(result)
            seconds[what] += cost
            if k % 50 == 0:
                print(f"{k} of {len(listed)} ({what})", file=sys.stderr, flush=True)
    return found, {what: {"size": size, "seconds": round(cost)} for what, cost in seconds.items()}


def plain(value: Any) -> Any:
    """JSON without infinities, numbers of pictures with three digits."""
    if isinstance(value, dict):
        return {k: thinned(v) if k == "drawn" else plain(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [plain(v) for v in value]
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    return value


def thinned(drawn: list[tuple[float, float]]) -> list[list[float]]:
    """Some of the points, the worst among them."""
    some = [*drawn[:: max(1, len(drawn) // SHOWN)], max(drawn, key=lambda p: p[1])] if drawn else []
    return [[float(f"{a:.3g}"), float(f"{b:.3g}")] for a, b in some if math.isfinite(a) and math.isfinite(b)]


def main() -> None:
    """Measure and write."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=float, default=1.0, help="factor on all numbers of points")
    parser.add_argument("--only", nargs="*", choices=PARTS, default=PARTS, help="what to measure; the rest is kept")
    parser.add_argument("--draw", action="store_true", help="measure nothing")
    parser.add_argument("--docs", type=Path, default=DOCS, help="folder for stability.md and its pictures")
    options = parser.parse_args()
    results = RESULTS / "stability.json"
    known = json.loads(results.read_text(encoding="utf-8")) if results.exists() else {}
    if not options.draw:
        found, cost = measure(options.size, options.only)
        if "proofs" in found:  # its pieces are of no use apart; and Table 2 is timed with nothing beside
            found["proofs"] = [proofs.summed(found["proofs"])]
        if "counts against proofs" in found:
            found["counts against proofs"] = scale.summed(found["counts against proofs"])
        about = {"environment": environment.describe(), "cost": {**known.get("cost", {}), **cost}}
        known = {**known, **about, **plain(found)}
        baseline.save(results, known)
    baseline.write(known)
    page.write(known, options.docs)


if __name__ == "__main__":
    main()
