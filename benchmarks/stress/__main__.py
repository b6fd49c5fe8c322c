"""`make stress`: search for the worst errors, count what is missed, write docs/stability.md and the baseline.

Out: benchmarks/results/stability.json, docs/stability.md and its pictures, and results/worst_points.json, whose errors
`make derive` states in the headers of kernels. Less than twenty minutes on two slow cores. `--only answers counts`
measures these anew and keeps the rest of the last results, `--draw` keeps all; `--size 0.1` takes a tenth of the
points. Counts against proofs are ten million, a million isolators among them. What was measured is kept as soon as a
part is through.
"""

from __future__ import annotations

import argparse
import itertools
import json
import math
import multiprocessing
import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from benchmarks import environment
from benchmarks.document import DOCS, RESULTS
from benchmarks.stress import answers, baseline, counts, kernels, proofs, roots, scale

#: what can be measured separately
OF_COUNTS = ("counts", "counts against proofs")
#: of shares that are summed
AGAINST_PROOFS = ("counts against proofs",)
GROUPS = ("answers", *OF_COUNTS, "proofs", "roots", "kernels", "extremes")
#: shares into which answers and counts are cut
SHARES = 8
#: oscillators of each share of the counts against proofs: with one forcing, and with many frequencies
FOLDS = {
    "rod_spring": 100_000, "rod_spring, zeta = 0": 12_500, "rod_spring, alpha = 0": 6_500,
    "rod_spring_untruncated": 6_500, "duffing": 25_000, "duffing, zeta = 0": 125_000, "duffing, alpha = 0": 12_500,
}  # fmt: skip
STATES = {
    "rod_spring": 250, "rod_spring, zeta = 0": 50, "rod_spring, alpha = 0": 50,
    "rod_spring_untruncated": 50, "duffing": 3_200, "duffing, zeta = 0": 250, "duffing, alpha = 0": 250,
}  # fmt: skip
#: points shown of each kernel and kind in a picture
SHOWN = 40
Job = tuple[Callable[..., Any], tuple[Any, ...]]


def jobs(size: float) -> dict[str, list[Job]]:
    """All there is to measure, the longest first."""

    def many(count: int, least: int = 1) -> int:
        return max(least, round(count * size))

    return {
        "answers": [
            (answers.stress, (mechanism, part, many(8 if mechanism != "rod_spring_untruncated" else 3), 1, many(20)))
            for mechanism in answers.NAMES
            for part in range(SHARES)
        ],
        "counts": [
            (counts.stress, (mechanism, part, many(4 if mechanism == "rod_spring" else 12)))
            for mechanism in counts.ORACLES
            for part in range(SHARES)
        ],
        "counts against proofs": [
            (count, (kind, part, many(number)))
            for count, numbers in ((scale.folds, FOLDS), (scale.states, STATES))
            for kind, number in numbers.items()
            for part in range(SHARES)
        ],
        "proofs": [(proofs.stress, (part, many(125))) for part in range(SHARES)],
        "roots": [(roots.stress, (kind, family, many(4000, 50), many(1500))) for kind, family in roots.jobs()],
        "kernels": [(kernels.stress, (module, kernel, size)) for module, kernel in kernels.named()],
        "extremes": [(extremes, (module, kernel, many(4, 4))) for module, kernel in kernels.named()],
    }


def extremes(module: str, kernel: str, count: int) -> dict[str, Any]:
    """With the kernel's name."""
    return {"module": module, "kernel": kernel, "found": kernels.extremes(module, kernel, count)}


def run(job: tuple[str, Job]) -> tuple[str, Any, float]:
    """One job, with what it belongs to and the processor's seconds."""
    what, (function, arguments) = job
    start = processor_time()
    return what, function(*arguments), processor_time() - start


def processor_time() -> float:
    """Of this process, and of those that it started."""
    return sum(os.times()[:4])


def measure(size: float, only: list[str]) -> Iterator[tuple[str, list[Any], dict[str, Any]]]:
    """What each part found, as soon as it is through, in the order of the jobs; with its size and seconds."""
    listed = [(what, job) for what, group in jobs(size).items() if what in only for job in group]
    with multiprocessing.Pool() as pool:
        done = pool.imap(run, listed)
        for what, part in itertools.groupby(done, key=lambda one: one[0]):
            print(what, file=sys.stderr, flush=True)
            results = list(part)
            seconds = round(sum(cost for *_, cost in results))
            yield what, [result for _, result, _ in results], {"size": size, "seconds": seconds}


def joined(what: str, found: list[Any]) -> list[Any]:
    """Shares whose pieces are of no use apart as one."""
    if what == "proofs":
        return [proofs.summed(found)]
    return scale.summed(found) if what in AGAINST_PROOFS else found


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
    parser.add_argument("--only", nargs="*", choices=GROUPS, default=GROUPS, help="what to measure; the rest is kept")
    parser.add_argument("--draw", action="store_true", help="measure nothing")
    parser.add_argument("--docs", type=Path, default=DOCS, help="folder for stability.md and its pictures")
    options = parser.parse_args()
    results = RESULTS / "stability.json"
    known = json.loads(results.read_text(encoding="utf-8")) if results.exists() else {}
    if not options.draw:
        known["environment"] = environment.describe()
        for what, found, cost in measure(options.size, options.only):
            known[what] = plain(joined(what, found))
            known["cost"] = {**known.get("cost", {}), what: cost}
            baseline.save(results, known)
    baseline.write(known)
    from benchmarks.stress import page  # pyplot, which the processes that search do without

    page.write(known, options.docs)


if __name__ == "__main__":
    main()
