"""What a motion passes on: the numbers of its whole wave, and what they may be of.

In:  waves of exact motions and of the second approximation.
Out: `Transmitted`, in ratio and in decibels; `OF`.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from slowflow import validate
from slowflow.support.errors import Refused

#: what may be asked for: the force that is passed on; the displacement, from the base and in space
OF = ("force", "relative", "absolute")

FIXED_BASE = (
    "of = 'absolute' is not allowed with excitation = 'force': the base stands still, and 'relative' is absolute"
)


class Transmitted(NamedTuple):
    """What a motion passes on over what drives it: at its frequency, at most, and root mean square.

    Numbers, or arrays with that of each point of a curve. Without harmonics peak is first, and rms that over sqrt(2).
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
    """Transmissibility of states, `ratio` of those that move: a mass at rest, A = 0, passes on all that drives it.

    What is transmitted is the excitation less the inertia of the mass, which has none then.
    """
    return np.where(np.asarray(A) == 0, 1.0, ratio)


def validated(of: str, *, inertial: bool) -> str:
    """`of`, one of `OF`. Raises ValueError for another one, and where the base stands still for "absolute"."""
    validate.choice("of", of, OF)
    if of == "absolute" and not inertial:
        raise Refused(FIXED_BASE)
    return of
