"""`make bench`: the table of targets, the work-precision diagram and how cost grows, in one run.

Out: the table on the terminal, benchmarks/results/bench.json and work_precision.json, docs/work_precision.png and
docs/scaling.png, docs/benchmarks.md. About ten minutes; `--small` tries it out.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

from benchmarks import diagrams, document, environment, limits, targets, work_precision


def main() -> None:
    """Measure, print, write."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--small", action="store_true", help="few and small measurements, to try the commands")
    parser.add_argument("--results", type=Path, default=document.RESULTS, help="folder for the JSON files")
    parser.add_argument("--docs", type=Path, default=document.DOCS, help="folder for diagrams and benchmarks.md")
    options = parser.parse_args()
    size = targets.SMALL if options.small else targets.Size()
    start = time.monotonic()

    kept = {name: document.earlier(options.results / f"{name}.json") for name in ("bench", "work_precision")}
    rows = targets.with_earlier(targets.measure(size), kept["bench"])
    about = environment.describe()
    explained = limits.of(rows)
    document.save(options.results / "bench.json", {"environment": about, "rows": rows, "limits": explained})

    print("work-precision ...", file=sys.stderr, flush=True)
    precision = {"environment": about, **work_precision.measure(size.precision_rounds, kept["work_precision"])}
    document.save(options.results / "work_precision.json", precision)
    diagrams.draw(precision, options.docs)
    document.write(options.results, options.docs)

    print("\n".join(document.bench_table(rows)))
    print(*(f"limit: {sentence}" for sentence in explained), *document.environment_lines(about), sep="\n")
    print(f"{time.monotonic() - start:.0f} s; diagrams and tables in {options.docs.name}/benchmarks.md")


if __name__ == "__main__":
    main()
