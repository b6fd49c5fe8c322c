"""The paper's example: in goes Table 1 as `published` has it, out come its numbers as doubles and its isolator."""

from __future__ import annotations

from typing import Any

from slowflow.isolator import Isolator
from slowflow.paper import published

#: lam, r, delta_h, mu, zeta, each the double next to the published fraction
TABLE_1: dict[str, float] = {name: float(value) for name, value in published.TABLE_1.items()}

#: lam, r and delta_h, as `slowflow_kernels.rod_spring.coefficients` takes them
DESIGN: tuple[float, float, float] = (TABLE_1["lam"], TABLE_1["r"], TABLE_1["delta_h"])


def isolator(**changes: Any) -> Isolator:
    """The isolator of Table 1, made anew at each call; keywords as Isolator's take the place of what is given there."""
    return Isolator(**{**TABLE_1, **changes})
