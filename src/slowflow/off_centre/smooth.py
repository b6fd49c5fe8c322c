"""Where a force of any kind ends. Takes its pieces on intervals; returns walls and how far the mean may go.

A piece has to be smooth on all of it. Where the outermost one grows beyond all bounds at some u, as a magnet's force
does, no motion passes: that is a wall.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from slowflow.core.model import Floats
from slowflow.off_centre.curved import Part
from slowflow.support.errors import Refused
from slowflow.support.text import Sentence

#: parts of an octave, octaves from the least to the most that is looked at, beside the size of the problem
DIVISIONS, LEAST, MOST = 8, -20, 40
#: |u| up to which a force is looked at: there its derivatives on intervals are numbers
FARTHEST = 2.0**1000
#: what is larger is beyond all numbers; how large a force is at a wall, and how near to it
GROWN = 2.0**24
HUGE, AT_WALL, NARROW = 2.0**120, 2.0**16, 2.0**-40
SINGULAR = Sentence("{name:s}: piece {number:d} of its force is not smooth at {u = :g}: it must end before that")


@dataclass(frozen=True)
class Beyond:
    """Of an outermost piece, outwards.

    wall    -- |u| that no motion passes, inf for none
    settled -- |u| from which on the force pushes back by more than the load, inf if it does not
    grown   -- |u| from which on it does so by `GROWN` times the load and 1, inf if it does not
    """

    wall: float
    settled: float
    grown: float


def outwards(
    part: Part, side: float, start: float, size: float, load: float, complain: Callable[[float], str]
) -> Beyond:
    """Along the last piece on one side, which begins at side u = start. Raises ValueError where it is not smooth.

    A wall is beyond u = 0 and all ends: on this side of it the mass is.
    """
    with np.errstate(over="ignore"):
        edges = start + size * 2.0 ** np.arange(LEAST, MOST + 0.5 / DIVISIONS, 1 / DIVISIONS)
    edges = np.minimum(edges, FARTHEST)

    def cells(edges: Floats) -> list[tuple[float, float, float, bool]]:
        """Between neighbours, from the last: where it is, the least that pushes back, whether all of it is known."""
        low, high = edges[:-1], edges[1:]
        with np.errstate(all="ignore"):
            on = part.between(*((low, high) if side > 0 else (-high, -low)))
            push = (on[:, 0, 0] if side > 0 else -on[:, 0, 1]) - side * load
        known = np.asarray(np.isfinite(on).all(axis=(1, 2)))
        return list(zip(low.tolist(), high.tolist(), push.tolist(), known.tolist(), strict=True))[::-1]

    pending = cells(np.concatenate(([start], edges)))
    settled, grown = start, np.inf
    while pending:
        low, high, push, known = pending.pop()
        if push > HUGE:
            return Beyond(np.inf, settled, min(grown, high))
        if not known:
            if high - low > NARROW * max(size, high):
                pending += cells(np.array((low, 0.5 * (low + high), high)))
                continue
            near = low - 4 * (high - low)
            force = part.between(side * near, side * near)[0, 0] * side
            if near > max(start, 0.0) and force.min() > AT_WALL * max(1.0, abs(load)):
                return Beyond(near, settled, min(grown, near))
            raise Refused(complain(side * low))
        if not push > 0:
            if high - low > 2.0**-6 * high and high > size * 2.0**LEAST * 2:
                pending += cells(np.array((low, 0.5 * (low + high), high)))
                continue
            settled = high
        if push > GROWN * max(1.0, abs(load)):
            grown = min(grown, high)
    return Beyond(np.inf, np.inf if settled == edges[-1] else settled, grown)


def check(part: Part, low: float, high: float, complain: Callable[[float], str]) -> None:
    """Raises ValueError where a piece is not smooth on all of it."""
    edges = np.linspace(low, high, DIVISIONS + 1)
    pending = list(zip(edges[:-1].tolist(), edges[1:].tolist(), strict=True))
    while pending:
        a, b = pending.pop()
        if np.isfinite(part.between(a, b)).all():
            continue
        if b - a < NARROW * max(abs(a), abs(b), high - low):
            raise Refused(complain(a))
        middle = 0.5 * (a + b)
        pending += [(a, middle), (middle, b)]
