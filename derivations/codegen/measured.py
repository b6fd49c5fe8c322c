"""Worst rounding errors that a search found, as data. Takes a module; returns k of its kernels, and where they hold.

`make stress` stores them, of the kernels in `generated/`: what is derived at run time has none. They stand in the
headers of kernels for which `proved` has no bound.
"""

from __future__ import annotations

import functools
import json
from dataclasses import dataclass
from pathlib import Path

from .form import Module

DATA = Path(__file__).with_name("measured.json")
#: what an oscillator is from that is derived at run time
AT_RUNTIME = "runtime.py"


@dataclass(frozen=True)
class Measured:
    """k of kernels by name, and the arguments they are of, in words."""

    where: str
    kernels: dict[str, str]


NOTHING = Measured("", {})


@functools.cache
def stored() -> dict[str, Measured]:
    """All that was measured, by module."""
    return {name: Measured(**one) for name, one in json.loads(DATA.read_text(encoding="utf-8")).items()}


def of(module: Module) -> Measured:
    """What was measured of a module's kernels, if it is one of those in `generated/`."""
    return NOTHING if AT_RUNTIME in module.inputs else stored().get(module.name, NOTHING)


def write(found: dict[str, Measured]) -> None:
    """A kernel a line."""
    content = {name: vars(one) for name, one in sorted(found.items())}
    DATA.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
