"""What the solvers of the second approximation find: curves, folds and states."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow.answer import joined
from slowflow.model import Floats
from slowflow.text import Sentence

LOST = Sentence(
    "left out: {some:d} of {all:d} points of the first approximation, at {Omega} from {Omega[0]:.3g} to "
    "{Omega[1]:.3g}; its harmonics are not small"
)
UNSOLVED = "left out: {} of {} folds, next to which the curve is lost"
NO_FOLD = Sentence("no saddle node at {F_0 = :g} in the second approximation")


@dataclass(frozen=True)
class Curve:
    """A response curve: points in order along each branch; whether each branch is closed; remarks.

    Omega, A        -- A as in the kernels, A_1 + a_3 + a_5
    u_max, A_1, phi -- largest displacement, first harmonic's amplitude and phase
    lost            -- whether points of the first approximation's are left out
    native          -- the same as the compiled solvers take it
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
    lost: bool
    native: Any


class Fold(NamedTuple):
    """Frequency, largest displacement, first harmonic; whether a sweep leaves it upwards, and whether on a corner."""

    Omega: float
    u_max: float
    A_1: float
    up: bool
    corner: bool


class Folds(NamedTuple):
    """Folds by rising Omega; how many were not found; what is to be said of them."""

    found: list[Fold]
    lost: int
    message: str


class State(NamedTuple):
    """Frequency, largest displacement, first harmonic's amplitude and phase, stability."""

    Omega: float
    u_max: float
    A_1: float
    phi: float
    stable: bool


def told(message: str, lost: int, of: int, low: float, high: float) -> str:
    """The first approximation's message of a curve, some of whose points move nowhere, between two frequencies."""
    return joined(message, LOST.format(lost, of, (low, high)) if lost else "")


def told_of_folds(found: list[Fold], lost: int, tried: int, of_curve: str, F_0: float) -> Folds:
    """Folds at F_0, and those that were not found of those tried, with the message of the curve that they lie on."""
    none = "" if found else NO_FOLD.format(F_0)
    return Folds(found, lost, joined(none, of_curve, UNSOLVED.format(lost, tried) if lost else ""))
