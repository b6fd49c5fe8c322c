"""The pipeline: `python -m derivations [--out DIR] [--check] [--from DIR]`.

    1. derive   mechanisms/*.py                  -> Results: exact expressions           (derivations.results)
    2. choose   Results                          -> Modules of Kernels                   (derivations.codegen.catalogue)
    3. passes   a kernel's lets and outputs      -> straight-line Programs               (derivations.codegen.passes)
    4. print    Programs                         -> NumPy and C source, loops in C       (derivations.codegen.targets)
    5. judge    Results, published.py            -> LEDGER.md, ledger.json               (derivations.ledger)
    6. record   Results, sources                 -> MANIFEST.json                        (derivations.codegen.write)
    7. write    file name -> text                -> files in DIR; stale files go         (derivations.codegen.write)

With --check, two fresh processes under different hash seeds do 1 to 7 in a temporary folder; both must equal DIR, first
in their set of files, then in every byte.
"""

from __future__ import annotations

import argparse
import gc
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from .codegen.write import MANIFEST, differences, manifest, on_disk, write

if TYPE_CHECKING:
    from .results import Results

ROOT = Path(__file__).parents[1]
HASH_SEEDS = ("0", "20250415")


def generate(results: Results | None = None) -> dict[str, str]:
    """Stages 1 to 6: every generated file, by name. Results that are there already are not derived once more."""
    # here, not above: who only writes or compares files does without SymPy, whose import takes longer
    from . import ledger
    from .codegen.catalogue.every_module import all_modules
    from .codegen.targets.render import render
    from .results import derive

    results = results or derive()
    modules = all_modules(results)
    files = render(modules) | ledger.files(results)
    return files | {MANIFEST: manifest(files, results)}


def regenerate(scratch: Path) -> None:
    """Fresh processes, one under each hash seed, write into folders named after it."""
    started = [
        subprocess.Popen(
            [sys.executable, "-m", "derivations", "--out", str(scratch / seed)],
            cwd=ROOT,
            env={**os.environ, "PYTHONHASHSEED": seed},
        )
        for seed in HASH_SEEDS
    ]
    for process in started:
        if process.wait():
            raise subprocess.CalledProcessError(process.returncode, process.args)


def report(folder: Path, scratch: Path) -> list[str]:
    """What differs between a folder and what was written anew: once if it is the same under each hash seed."""
    found = on_disk(folder)
    reports = [differences(on_disk(scratch / seed), found, folder.name) for seed in HASH_SEEDS]
    if all(report == reports[0] for report in reports):
        return reports[0]
    by_seed = zip(HASH_SEEDS, reports, strict=True)
    return [line for seed, report in by_seed for line in (f"hash seed {seed}:\n", *report)]


def main(arguments: list[str] | None = None) -> int:
    """0, or 1 if --check found a difference."""
    parser = argparse.ArgumentParser(prog="python -m derivations", description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "generated", metavar="DIR", help="default: %(default)s")
    parser.add_argument("--check", action="store_true", help="compare DIR with fresh derivations, do not write it")
    parser.add_argument("--from", type=Path, dest="made", metavar="DIR", help="write what is in DIR, derive nothing")
    options = parser.parse_args(arguments)
    if options.check:
        with tempfile.TemporaryDirectory() as scratch:
            regenerate(Path(scratch))
            differing = report(options.out, Path(scratch))
        sys.stdout.writelines(differing)
        return 1 if differing else 0
    write(on_disk(options.made) if options.made else generate(), options.out)
    return 0


if __name__ == "__main__":
    # before SymPy is imported: by itself it keeps 1000 results of each of its functions, too few for a derivation
    os.environ.setdefault("SYMPY_CACHE_SIZE", "None")
    # expressions are in no cycles, and most live to the end: looking for garbage takes a seventh of the time, and once
    # more where the interpreter ends
    gc.disable()
    status = main()
    gc.freeze()
    sys.exit(status)
