"""All solutions of a few equations in boxes: none is missed, and each that is given is proved to be there, once.

In:  equations that give values and slopes on boxes, as intervals, and at points; boxes.
Out: `Solutions`: points, and the boxes in which doubles do not decide.

The search and its proof are native/boxes.h's; equations are evaluated for all boxes of a sweep at a time.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from slowflow.core.backend import SOLVER
from slowflow.core.mechanism import Floats, Ints
from slowflow.support.errors import NotSettled

#: boxes that are looked at for one system: usual questions take hundreds, hard ones some ten thousand; this many take
#: some seconds. And for each of many, on the average
MOST_BOXES, MOST_EACH = 150_000, 4_000
#: a box as C has it, `sf_box` of native/boxes.h
BOX = np.dtype([*((name, float, 3) for name in ("low", "high", "least", "most", "error")), ("of", np.intp)], align=True)
TOO_MANY = "the states are unresolved: too many boxes stay undecided"


#: values in the middle of boxes, then values on them, slopes and between which ends solutions are: rows (n, 36), as
#: `sf_values` of native/boxes.h, from lower and upper ends (d, n) and from which of several systems each box belongs to
OnBoxes = Callable[[Floats, Floats, Ints], Floats]


@dataclass(frozen=True, eq=False)
class Solutions:
    """Points (d, n), by their first unknown, and which system each solves.

    undecided, undecided_of -- centres (d, k) of boxes that may hold others, and their systems
    """

    x: Floats
    of: Ints
    undecided: Floats
    undecided_of: Ints


def solve(on: OnBoxes, low: Floats, high: Floats, of: Ints, limits: tuple[Any, Any] = (-np.inf, np.inf)) -> Solutions:
    """All solutions of as many equations as unknowns in the boxes from low to high, shape (d, n).

    limits -- lower and upper ends of all that there is, which broadcast to (d, n): no box is made larger beyond

    Raises ArithmeticError where too many stay open.
    """
    boxes = np.zeros(of.size, BOX)
    for name, ends in zip(("low", "high", "least", "most"), (low, high, *limits), strict=True):
        boxes[name][:, : len(low)] = np.broadcast_to(ends, low.shape).T
    boxes["of"] = of
    count = max(MOST_BOXES, MOST_EACH * np.unique(of).size)
    with np.errstate(all="ignore"):
        found = SOLVER.solve_boxes(on, len(low), boxes, count)
    if found is None:
        raise NotSettled(TOO_MANY)
    return Solutions(*found)
