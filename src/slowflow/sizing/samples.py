"""Samples of a measured motion and of the force along it: checked, and their velocities."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from slowflow.answers.quantities import si
from slowflow.core import validate
from slowflow.core.mechanism import Flags, Floats
from slowflow.support.errors import Refused

#: where |v| is less than this share of the largest the motion reverses: the sign of friction is uncertain there
REVERSES = 0.1
#: one in so many samples belongs to a polynomial whose slope is the velocity; the degree of these
WINDOW, DEGREE = 40, 3
CONSTANT = "the loop does not determine a spring: x does not change"


def in_time(rows: Mapping[str, Any], least: int, *, in_si: bool = True) -> dict[str, Floats]:
    """Rows of x, F and t of one length, of at least so many samples. Raises ValueError for others."""
    units = {"x": "m", "F": "N", "t": "s"}
    known = {
        name: validate.finite_array(name, si(name, row, units[name]) if in_si else row) for name, row in rows.items()
    }
    if any(row.shape != (known["x"].size,) for row in known.values()) or known["x"].size < least:
        raise Refused(f"{', '.join(known)} must be rows of one length, of at least {least} samples")
    if "t" in known and (np.diff(known["t"]) <= 0).any():
        raise Refused("t is not allowed: the times must be ascending")
    return known


def velocity(x: Floats, t: Floats | None) -> tuple[Floats, Flags]:
    """Velocity at each sample, by sample where there are no times, and where the motion does not reverse.

    The slopes of polynomials through neighbours (Savitzky and Golay) keep noise from reversing the motion.
    """
    from scipy.signal import savgol_filter

    def slopes(row: Floats) -> Floats:
        return np.asarray(savgol_filter(row, max(DEGREE + 2, row.size // WINDOW) | 1, DEGREE, deriv=1))

    v = slopes(x) / (1.0 if t is None else slopes(t))
    return v, np.abs(v) > REVERSES * np.abs(v).max()
