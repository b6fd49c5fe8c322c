"""What each push runs of what is too much for it: a part that changes with the commit. `make test-all` runs all of it.

SLOWFLOW_TESTS is "all", or the number that the part is drawn by; without it that is the commit's. The first lines of a
run print it, so that another commit can repeat the part.
"""

from __future__ import annotations

import os
import random
import subprocess
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import pytest

T = TypeVar("T")
ALL = os.environ.get("SLOWFLOW_TESTS") == "all"


def _turn() -> int:
    """The number that the part is drawn by; 0 where there is no repository."""
    if "SLOWFLOW_TESTS" in os.environ:
        return 0 if ALL else int(os.environ["SLOWFLOW_TESTS"])
    command = ["git", "rev-parse", "HEAD"]
    try:
        commit = subprocess.run(command, cwd=Path(__file__).parent, capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return 0
    return int(commit[:6], 16)


TURN = _turn()


def part(cases: Sequence[T], of: int, salt: str = "") -> list[T]:
    """One in `of` of the cases, in their order, at least one of them; all of them in `make test-all`."""
    if ALL:
        return list(cases)
    drawn = random.Random(f"{TURN} {salt}").sample(range(len(cases)), -(-len(cases) // of))
    return [cases[k] for k in sorted(drawn)]


def fewer(count: int, of: int) -> int:
    """One in `of` of a number of random cases; all of them in `make test-all`."""
    return count if ALL else -(-count // of)


def directions(names: Iterable[str]) -> list[dict[str, float]]:
    """Along what gradients are compared with differences: all parameters at once, each in `make test-all`.

    Every weight lies between 1/2 and 1 of either sign, so that no slope is left out.
    """
    names = sorted(names)
    if ALL:
        return [{name: 1.0} for name in names]
    drawn = random.Random(f"{TURN} {names}")
    return [{name: drawn.choice((-1, 1)) * drawn.uniform(0.5, 1.0) for name in names}]


def slow(*cases: Any) -> list[Any]:
    """Cases of a test that `make test-fast` leaves out."""
    return [pytest.param(*(one if isinstance(one, tuple) else (one,)), marks=pytest.mark.slow) for one in cases]
