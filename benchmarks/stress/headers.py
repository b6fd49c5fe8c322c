"""What headers say of kernels that are measured: the worst points in, derivations/codegen/measured.json out.

`make derive` puts it beside the kernels that have no proved bound. Errors are rounded up to two digits.
"""

from __future__ import annotations

import decimal
import json

from benchmarks.stress import baseline, domains, kernels
from derivations.codegen import measured
from derivations.codegen.measured import Measured


def shown(error: float) -> str:
    """Two digits, rounded up."""
    return format(decimal.Context(prec=2, rounding=decimal.ROUND_UP).create_decimal(repr(error)).normalize(), "f")


def searched() -> dict[str, Measured]:
    """By either backend at the worst points of the last search."""
    worst: dict[str, dict[str, float]] = {}
    for row in json.loads(baseline.OUT.read_text(encoding="utf-8"))["kernels"]:
        of_module = worst.setdefault(row["module"], {})
        errors = (float(error) for error in row["errors"].values() if error is not None)
        of_module[row["kernel"]] = max(of_module.get(row["kernel"], 0.0), *errors)
    found = {}
    for module, of_module in worst.items():
        names = sorted({name for kernel in of_module for name in kernels.named()[module, kernel]})
        where = f"by a search for it with {domains.in_words(module, names)}"
        found[module] = Measured(where, {kernel: shown(error) for kernel, error in sorted(of_module.items())})
    return found


def write() -> None:
    """All of them."""
    measured.write(searched())


if __name__ == "__main__":
    write()
