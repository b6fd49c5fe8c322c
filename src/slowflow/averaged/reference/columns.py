"""Answers of designs abreast, on NumPy: in go designs of one kind and what is asked, out come the columns of a batch.

Each entry is what `slowflow.averaged.asked` makes of a single answer by doubles, to the last bit.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from slowflow.averaged.reference.abreast import Abreast
from slowflow.averaged.reference.bounds import amplitude_bounds
from slowflow.averaged.reference.folds import folds_abreast
from slowflow.model import Floats
from slowflow_kernels.conventions import FoldKind, Status

Columns = tuple[Any, ...]


def saddle_nodes(model: Abreast, F_0: Floats, places: int) -> Columns:
    """Every fold at F_0 > m of each."""
    A_max = amplitude_bounds(model, F_0)
    bounded = np.isfinite(A_max)
    # a design that nothing bounds is looked at to where it may be, and its answer is none
    found = folds_abreast(model, F_0, np.where(bounded, A_max, F_0))
    number = np.bincount(found.of, minlength=model.abreast)
    place = np.arange(found.of.size) - (np.cumsum(number) - number)[found.of]
    status = np.where(number > places, Status.TOO_MANY, Status.OK)
    status = np.where(found.given_up, Status.UNRESOLVED, status)
    status = np.where(bounded, status, Status.NO_BOUND)
    answered = (status == Status.OK) | (status == Status.TOO_MANY)
    kept = (place < places) & answered[found.of]
    Omega, A = np.full((2, model.abreast, places), np.nan)
    kind = np.zeros((model.abreast, places), np.int8)
    at = found.of[kept], place[kept]
    Omega[at], A[at] = found.Omega[kept], found.A[kept]
    up, on_corner = (FoldKind.JUMP_UP, FoldKind.JUMP_DOWN), (FoldKind.JUMP_UP_AT_CORNER, FoldKind.JUMP_DOWN_AT_CORNER)
    kinds = np.where(found.corner, np.where(found.up, *on_corner), np.where(found.up, *up))
    kind[at] = kinds[kept]
    return Omega, A, kind, np.where(answered, number, 0), found.undecided & answered, status
