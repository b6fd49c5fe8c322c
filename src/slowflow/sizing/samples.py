"""Samples of a measured motion and of the force along it: checked, and their velocities."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from slowflow.answers.quantities import si
from slowflow.core import validate
from slowflow.core.mechanism import Flags, Floats
from slowflow.support.errors import Refused

#: where |v| is less than this share of the largest the motion reverses: the sign of friction is uncertain there. It is
#: noise where x goes back by less than this share of its range
REVERSES = 0.1
#: of the samples between two reversals one in so many belongs to a polynomial whose slope is the velocity; its degree
WINDOW, DEGREE = 8, 3
#: correlation of neighbouring residuals above which something else than noise is left, where they are more than this
#: share of what was measured
LEFT, ROUNDING = 0.5, 1e-3
SYSTEMATIC = (
    "neighbouring residuals are correlated ({:.2f}): the model lacks an effect that the data have, as `plot` shows"
)
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

    The slopes of polynomials through neighbours (Savitzky and Golay) keep noise from reversing the motion. They are
    wrong across a reversal at constant speed, where x has a kink, so samples near reversals do not count either.
    """
    from scipy.signal import find_peaks, savgol_filter

    turns = np.sort(np.concatenate([find_peaks(side, prominence=REVERSES * np.ptp(x))[0] for side in (x, -x)]))
    size = max(DEGREE + 2, int(np.diff(turns).min(initial=x.size)) // WINDOW) | 1

    def slopes(row: Floats) -> Floats:
        return np.asarray(savgol_filter(row, size, DEGREE, deriv=1))

    v = slopes(x) / (1.0 if t is None else slopes(t))
    goes = np.ones(x.size, dtype=np.bool_)
    for turn in turns:
        goes[max(turn + 1 - size // 2, 0) : turn + size // 2] = False
    return v, goes & (np.abs(v) > REVERSES * np.abs(v[goes]).max(initial=0.0))


def systematic(residuals: Floats, measured: Floats) -> str:
    """Message about residuals of neighbouring samples that are correlated, beyond rounding; empty if they are not."""
    if np.sqrt(np.mean(residuals**2)) <= ROUNDING * np.abs(measured).max():
        return ""
    correlation = float(residuals[1:] @ residuals[:-1] / (residuals @ residuals))
    return SYSTEMATIC.format(correlation) if correlation > LEFT else ""
