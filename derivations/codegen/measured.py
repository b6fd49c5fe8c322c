"""Worst rounding errors that a search found. Takes a module; returns k of its kernels, and where it was searched for.

`make stress` stores the points with their errors, of the kernels in `generated/`: what is derived at run time has none.
They stand in the headers of kernels for which `proved` has no bound.
"""

from __future__ import annotations

import decimal
import functools
import json
from dataclasses import dataclass, field
from pathlib import Path

from .form import Module

DATA = Path(__file__).parents[2] / "benchmarks" / "results" / "worst_points.json"
#: what an oscillator is from that is derived at run time
AT_RUNTIME = "runtime.py"
TWO_DIGITS = decimal.Context(prec=2, rounding=decimal.ROUND_UP)


@dataclass(frozen=True)
class Measured:
    """k of kernels by name, and the ranges of arguments that were searched."""

    where: str = ""
    kernels: dict[str, str] = field(default_factory=dict)


@functools.cache
def stored() -> dict[str, Measured]:
    """All that was measured, by module: of each kernel the worst point, NumPy's or compiled."""
    data = json.loads(DATA.read_text(encoding="utf-8"))
    worst: dict[tuple[str, str], float] = {}
    for row in data["kernels"]:
        name = row["module"], row["kernel"]
        worst[name] = max(
            worst.get(name, 0.0), *(float(error) for error in row["errors"].values() if error is not None)
        )
    found = {box["module"]: Measured(box["where"]) for box in data["boxes"]}
    for (module, kernel), error in worst.items():
        found[module].kernels[kernel] = shown(error)
    return found


def shown(error: float) -> str:
    """Two digits, rounded up."""
    return format(TWO_DIGITS.create_decimal(repr(error)).normalize(), "f")


def of(module: Module) -> Measured:
    """What was measured of a module's kernels, if it is one of those in `generated/`."""
    return Measured() if AT_RUNTIME in module.inputs else stored().get(module.name, Measured())
