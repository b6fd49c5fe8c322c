"""What the solvers of the second approximation find: curves, folds, states, as both paths give them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow.answer import joined
from slowflow.model import Floats
from slowflow.results import FrequencyResponse

LOST = (
    "left out: {} of {} points of the first approximation, at Omega from {:.3g} to {:.3g}; its harmonics are not small"
)


@dataclass(frozen=True)
class Curve:
    """A response curve: points in order along each branch; whether each branch is closed; remarks.

    Omega, A        -- A as in the kernels, A_1 + a_3 + a_5
    u_max, A_1, phi -- largest displacement, first harmonic's amplitude and phase
    native          -- the same as the compiled solvers take it, None on NumPy
    """

    Omega: Floats
    A: Floats
    u_max: Floats
    A_1: Floats
    phi: Floats
    stable: npt.NDArray[np.bool_]
    branch: npt.NDArray[np.intp]
    isola: tuple[bool, ...]
    message: str
    native: Any = None


class Fold(NamedTuple):
    """Frequency, largest displacement, first harmonic; whether a sweep leaves it upwards, and whether on a corner."""

    Omega: float
    u_max: float
    A_1: float
    up: bool
    corner: bool


class State(NamedTuple):
    """Frequency, largest displacement, first harmonic's amplitude and phase, stability."""

    Omega: float
    u_max: float
    A_1: float
    phi: float
    stable: bool


def told(first: FrequencyResponse, lost: int, of: int, low: float, high: float) -> str:
    """The message of a curve that some of the first approximation's points do not move to, between two frequencies."""
    return joined(first.message, LOST.format(lost, of, low, high) if lost else "")
