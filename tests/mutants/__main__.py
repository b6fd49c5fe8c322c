"""`make mutate`: each edit of `edits.txt` in a copy of the project, one at a time; what no test notices is printed.

The tests that an edit names run first, and where they pass all that a push runs. --quick leaves it at those named,
--only WORD takes the edits of files with that in their path, --sample N so many at random. Exit code 1: some survive,
or are no longer in their file.
"""

from __future__ import annotations

import argparse
import os
import queue
import random
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).parents[2]
EDITS = Path(__file__).parent / "edits.txt"
NOT_COPIED = shutil.ignore_patterns(".git", ".venv*", "build", "output", "__pycache__", "*.egg-info", ".*_cache")
#: what pytest ends with where none is selected; seconds after which a command is stopped: an error may search for ever
NO_TESTS, LONGEST = 5, 1800
PYTEST = ("-m", "pytest", "-x", "-q", "-p", "no:cacheprovider")
NOTICED, SURVIVES, STALE, BROKEN = "noticed", "SURVIVES", "STALE", "BROKEN: its tests fail without it"


@dataclass(frozen=True)
class Edit:
    """What stands in a file, what somebody writes instead, and the files of tests that notice it."""

    file: str
    old: str
    new: str
    tests: tuple[str, ...]

    @property
    def compiled(self) -> bool:
        """Whether the solvers are built with it."""
        return Path(self.file).suffix in (".c", ".h")

    def applies(self) -> bool:
        """Whether its text is in its file, once."""
        file = ROOT / self.file
        return file.exists() and file.read_text(encoding="utf-8").count(self.old) == 1


def edits() -> list[Edit]:
    """All of them."""
    files = {path.stem: str(path.relative_to(ROOT)) for path in (ROOT / "tests").rglob("test_*.py")}
    found = []
    for section in EDITS.read_text(encoding="utf-8").split("\n\n")[1:]:
        file, *of_file = re.split(r"\n@ ", section.rstrip("\n"))
        for one in of_file:
            tests, *lines = one.split("\n")
            old, new = ("\n".join(line[2:] for line in lines if line[0] == mark) for mark in "-+")
            found.append(Edit(file, old, new, tuple(files[f"test_{name}"] for name in tests.split())))
    return found


@dataclass
class Copy:
    """The project in a folder of its own, where one edit after the other is made and taken back."""

    folder: Path
    passed: dict[tuple[bool, tuple[str, ...]], bool] = field(default_factory=dict)
    built: bool = False

    def __post_init__(self) -> None:
        shutil.copytree(ROOT, self.folder, ignore=NOT_COPIED, symlinks=True, dirs_exist_ok=True)
        (self.folder / "src" / "slowflow.derivation").symlink_to(self.folder / "derivations")

    def run(self, *command: str) -> bool:
        """Whether a command of Python's ends well there, in time."""
        outside = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
        paths = os.pathsep.join(str(self.folder / part) for part in ("src", "generated", "."))
        # what it answers is asked, not how fast
        here = {"PYTHONPATH": paths, "CFLAGS": "-O0"}
        options = {"cwd": self.folder, "env": {**outside, **here}, "capture_output": True, "timeout": LONGEST}
        try:
            return subprocess.run([sys.executable, *command], **options).returncode in (0, NO_TESTS)
        except subprocess.TimeoutExpired:
            return False

    def build(self) -> bool:
        """The solvers, of the sources as they are."""
        return self.run("setup.py", "-q", "build_ext", "--inplace")

    def verdict(self, edit: Edit, quick: bool) -> str:
        """Whether it is noticed; a build that fails notices it too."""
        if not edit.applies():
            return STALE
        if edit.compiled and not self.built:
            self.built = self.build()
        file = self.folder / edit.file
        text = file.read_text(encoding="utf-8")
        file.write_text(text.replace(edit.old, edit.new), encoding="utf-8")
        try:
            if edit.compiled and not self.build():
                return NOTICED
            failing = next((tests for tests in _rounds(edit, quick) if not self.run(*tests)), None)
        finally:
            file.write_text(text, encoding="utf-8")
            if edit.compiled:
                self.build()
        if failing is None:
            return SURVIVES
        key = (self.built, failing)
        if key not in self.passed:
            self.passed[key] = self.run(*failing)
        return NOTICED if self.passed[key] else BROKEN


def _rounds(edit: Edit, quick: bool) -> Iterator[tuple[str, ...]]:
    """Fast tests of the files that it names, the slow ones, and all tests."""
    yield (*PYTEST, "-n", "0", "-m", "not slow and not night", *edit.tests)
    yield (*PYTEST, "-n", "0", "-m", "slow and not night", *edit.tests)
    if not quick:
        yield (*PYTEST, "-n", "auto", "-m", "not night")


def judged(chosen: list[Edit], quick: bool, jobs: int = 2) -> list[tuple[Edit, str]]:
    """Each edit with its verdict, in as many copies at a time."""
    with tempfile.TemporaryDirectory() as folder:
        copies: queue.SimpleQueue[Copy] = queue.SimpleQueue()
        for number in range(min(jobs, len(chosen))):
            copies.put(Copy(Path(folder) / str(number)))

        def verdict(edit: Edit) -> tuple[Edit, str]:
            copy = copies.get()
            try:
                found = copy.verdict(edit, quick)
            finally:
                copies.put(copy)
            print(f"{found:9} {edit.file}: {edit.new.splitlines()[0]}", flush=True)
            return edit, found

        with ThreadPoolExecutor(jobs) as pool:
            return list(pool.map(verdict, chosen))


def main(arguments: list[str] | None = None) -> int:
    """See above."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutants", description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="only the tests that an edit names")
    parser.add_argument("--only", default="", metavar="WORD", help="of files with this in their path")
    parser.add_argument("--sample", type=int, metavar="N", help="so many, at random")
    parser.add_argument("--jobs", type=int, default=2, metavar="N", help="copies at a time, default: %(default)s")
    options = parser.parse_args(arguments)
    chosen = [edit for edit in edits() if options.only in edit.file]
    if options.sample is not None:
        chosen = random.sample(chosen, min(options.sample, len(chosen)))
    found = judged(chosen, options.quick, options.jobs)
    left = [verdict for _, verdict in found if verdict != NOTICED]
    print(f"{len(found) - len(left)} of {len(found)} are noticed")
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main())
