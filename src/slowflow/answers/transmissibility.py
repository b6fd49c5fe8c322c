"""Transmissibility of the waveform: first harmonic, peak and RMS.

`transmitted` of exact motions and of the second approximation returns `Transmitted`, for the force or for the relative
or absolute displacement.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from slowflow.core import validate
from slowflow.support.errors import Refused

#: what may be asked for: the force that is passed on; the displacement, from the base and in space
OF = ("force", "relative", "absolute")

FIXED_BASE = (
    "of = 'absolute' is not allowed with excitation = 'force': the base stands still, and 'relative' is absolute"
)


class Transmitted(NamedTuple):
    """Transmissibility by first harmonic (`first`), peak and root mean square (`rms`).

    Numbers, or arrays along a curve. Without higher harmonics, peak = first and rms = first/sqrt(2).
    """

    first: Any
    peak: Any
    rms: Any

    @property
    def dB(self) -> Transmitted:
        """The same in decibels, 20 log10."""
        with np.errstate(divide="ignore"):
            return Transmitted(*(20.0 * np.log10(ratio) for ratio in self))


def in_motion(A: Any, ratio: Any) -> Any:
    """Transmissibility of states, `ratio` of those that move; a mass at rest, A = 0, transmits the whole excitation."""
    return np.where(np.asarray(A) == 0, 1.0, ratio)


def validated(of: str, *, inertial: bool) -> str:
    """Return `of`, one of `OF`. Raises ValueError for another value, and for "absolute" if no inertia excites."""
    validate.choice("of", of, OF)
    if of == "absolute" and not inertial:
        raise Refused(FIXED_BASE)
    return of
