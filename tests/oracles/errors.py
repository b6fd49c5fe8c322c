"""Certified points of `data` and answers in; errors of the answers out, in u (1 + kappa)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

U = 2.0**-53


def error(found: float, sure: Mapping[str, Any], name: str) -> float:
    """Of one quantity of a certified point; kappa is its condition by the inputs and by the kernels' values."""
    key = "F_0" if name == "F_SN" else name
    kappa = sum((sure[which] or {}).get(key, 0.0) for which in ("condition", "condition_kernel"))
    known = float(sure[name])
    return abs(found - known) / abs(known) / (U * (1 + kappa))
