"""`make corpus`: every family against `tests/data/corpus.json`; exit code 1 where an answer differs.

python -m tests.corpus                      compare with the record; numbers go to output/corpus.npz
python -m tests.corpus --record             write the record
python -m tests.corpus --against FILE.npz   say how far numbers are from those of another checkout
python -m tests.corpus --only "single"      families whose name has the word
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np

from slowflow.app.cli import info
from tests.corpus.families import FAMILIES
from tests.corpus.record import differences, reduced

RECORD = Path(__file__).parents[1] / "data" / "corpus.json"
NUMBERS = Path("output") / "corpus.npz"


def machine() -> str:
    """Bits are promised for one machine and one build: other libraries of elementary functions round otherwise."""
    runs = info()
    levels = ", ".join(runs[f"{part} run"].partition(";")[0] for part in ("kernels", "solvers"))
    return f"{platform.machine()}, {levels}, libc {platform.libc_ver()[1]}, NumPy {np.__version__}"


def of(name: str, size: int) -> tuple[str, dict[str, Any], dict[str, np.ndarray], float]:
    """A family's record and numbers, and the processor time that they took, in s."""
    start = time.process_time()
    record, numbers = reduced(FAMILIES[name].pairs(size))
    return name, record, numbers, time.process_time() - start


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.corpus", description="Compare all answers with the record.")
    parser.add_argument("--record", action="store_true", help="write tests/data/corpus.json instead of comparing")
    parser.add_argument("--against", type=Path, help="numbers of another checkout, as output/corpus.npz holds them")
    parser.add_argument("--only", default="", help="families whose name has this word")
    options = parser.parse_args()
    if not (RECORD.exists() or options.record):
        parser.error(f"there is no record {RECORD}: python -m tests.corpus --record writes one")
    old = json.loads(RECORD.read_text()) if RECORD.exists() else {"machine": machine(), "full": {}, "sample": {}}
    before = dict(np.load(options.against)) if options.against else {}
    jobs = [(name, size) for name, family in FAMILIES.items() for size in {family.size, family.sample} - {0}]
    jobs = [(name, size) for name, size in jobs if options.only in name]
    new: dict[str, Any] = {"machine": machine(), "full": dict(old["full"]), "sample": dict(old["sample"])}
    after: dict[str, np.ndarray] = {}
    bad = 0
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        for (_, size), (name, record, numbers, seconds) in zip(
            jobs, pool.map(of, *zip(*jobs, strict=True)), strict=True
        ):
            kind = "full" if size == FAMILIES[name].size else "sample"
            new[kind][name] = record
            after |= {f"{kind}/{name}/{path}": value for path, value in numbers.items()}
            prefix = f"{kind}/{name}/"
            previous = {path.removeprefix(prefix): value for path, value in before.items() if path.startswith(prefix)}
            lines = [] if options.record else differences(old[kind].get(name, {}), record, previous, numbers)
            answers = sum(count["answers"] + count["refusals"] for count in record.values())
            if kind == "full":
                print(f"{name:20}{size:>10,} designs{answers:>9,} answers{seconds:8.1f} s", flush=True)
            print(*(f"    {kind}: {line}" for line in lines), sep="\n", end="\n" if lines else "")
            bad += len(lines)
    NUMBERS.parent.mkdir(exist_ok=True)
    np.savez_compressed(NUMBERS, **after)
    if options.record:
        RECORD.write_text(json.dumps(new, indent=1, sort_keys=True) + "\n")
    elif old["machine"] != machine():
        print(f"the record is of another machine, whose bits may differ: {old['machine']}; here {machine()}")
    return int(bad > 0)


if __name__ == "__main__":
    sys.exit(main())
