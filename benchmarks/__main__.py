"""`make bench`: what slowflow takes, beside other programs, and how cost grows.

Out: tables on the terminal, benchmarks/results/*.json and README.md, docs/benchmarks.md, docs/work_precision.png and
scaling.png. Half an hour; `python -m benchmarks bench grid` measures some of it, `--small` tries it out.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from benchmarks import (
    bench_derive,
    bench_exact,
    bench_grid,
    bench_paper,
    diagrams,
    document,
    environment,
    questions,
    work_precision,
)
from benchmarks.peers import measure as peers

#: what is measured, by the name of its JSON file: from whether it shall be small, and from what was measured last
GROUPS: dict[str, Callable[[bool, dict[str, Any]], Any]] = {
    "bench": lambda small, before: questions.measure(questions.SMALL if small else questions.Size(), before),
    "work_precision": lambda small, before: work_precision.measure(1 if small else 3, before),
    "derive": lambda small, before: bench_derive.measure(),
    "exact": lambda small, before: bench_exact.measure(1 if small else 7),
    "grid": lambda small, before: bench_grid.measure(10**5 if small else 10**7),
    "paper": lambda small, before: bench_paper.measure(),
    "peers": lambda small, before: peers.measure(1 if small else 5, before),
}


def main() -> None:
    """Measure, print, write."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__.splitlines()[0])
    parser.add_argument("groups", nargs="*", metavar="group", help=f"some of {', '.join(GROUPS)}; all by default")
    parser.add_argument("--small", action="store_true", help="few and small measurements, to try the commands")
    parser.add_argument("--results", type=Path, default=document.RESULTS, help="folder for the JSON files")
    parser.add_argument("--docs", type=Path, default=document.DOCS, help="folder for diagrams and benchmarks.md")
    options = parser.parse_args()
    if unknown := set(options.groups) - GROUPS.keys():
        parser.error(f"unknown group {', '.join(sorted(unknown))}: it is one of {', '.join(GROUPS)}")
    start = time.monotonic()
    for name in options.groups or GROUPS:
        print(f"{name} ...", file=sys.stderr, flush=True)
        path = options.results / f"{name}.json"
        found = GROUPS[name](options.small, document.earlier(path))
        content = {"environment": environment.describe(), **(found if isinstance(found, dict) else {"rows": found})}
        document.save(path, content)
        if name == "work_precision":
            diagrams.draw(content, options.docs)
            print(*document.precision(content), sep="\n")
        else:
            print(*document.section(name, content), sep="\n")
    document.write(options.results, options.docs)
    print(f"{time.monotonic() - start:.0f} s; tables in {options.docs.name}/benchmarks.md")


if __name__ == "__main__":
    main()
