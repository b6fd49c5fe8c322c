"""The paper's example: the isolator of Table 1."""

from __future__ import annotations

from typing import Any

from slowflow.oscillators.isolator import Isolator
from slowflow_kernels.table_1 import TABLE_1

__all__ = ["isolator"]

#: lam, r and delta_h, as `slowflow_kernels.rod_spring.coefficients` takes them
DESIGN: tuple[float, float, float] = (TABLE_1["lam"], TABLE_1["r"], TABLE_1["delta_h"])


def isolator(**changes: Any) -> Isolator:
    """The isolator of Table 1, made anew at each call; keywords of `Isolator` replace its parameters."""
    return Isolator(**{**TABLE_1, **changes})
