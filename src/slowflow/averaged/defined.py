"""Whether a force of any kind is finite within its reach. Takes its pieces on intervals; returns a refusal.

At a pole within the reach no average converges, and beyond a function's domain there is no force: an error of the
parameters, which is reported with its position before any query.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np

from slowflow.core.intervals import Elementary, Interval
from slowflow.core.mechanism import Flags, Mechanism
from slowflow.core.model import Floats, Model
from slowflow.support.errors import Refused
from slowflow.support.text import Sentence, listed

INFINITE = Sentence(
    "{numbers:s}: not allowed for {name:s}, whose force is infinite or NaN at |{u}| = {u:.6g}, within its reach "
    "{reach:g}"
)
#: into how many parts a piece is divided first; how short one is, over the reach, that is not cut again
DIVISIONS, NARROW = 64, 2.0**-40
#: how large a force is next to a pole; how often intervals are cut
AT_POLE = 2.0**16
MOST_CUTS = 2000
#: how many designs are looked at together
TOGETHER = 1024


def check_defined(model: Model) -> None:
    """Raises ValueError where a piece of an odd force is infinite, or no number, within the reach that is stated."""
    record = model.mechanism.enclosed
    if not record or not model.mechanism.odd or not math.isfinite(model.reach):
        return
    reach = model.reach
    parameters = [Elementary.point(value) for value in model.parameters]
    ends = [0.0, *(min(float(end), reach) for end in model.mechanism.breakpoints(*model.parameters)), reach]
    one = Elementary.point(1.0)
    for number, (begin, end) in enumerate(pairwise(ends)):

        def are_known(edges: Floats, number: int = number, begin: float = begin) -> Flags:
            beyond = Elementary(np.array([edges[:-1] - begin, edges[1:] - begin]))
            found = record[number](Elementary.point, one, beyond, one, *parameters)[0]
            return np.asarray(np.isfinite(Interval.like(found, beyond).ends).all(axis=0))

        def at(u: float, number: int = number) -> float:
            return float(model.mechanism.pieces[number].force(u, *model.parameters))

        with np.errstate(all="ignore"):
            place = _infinite_at(are_known, at, begin, end, reach)
        if place is not None:
            raise Refused(INFINITE.format(listed(model.numbers) or "reach", model.mechanism.name, place, reach))


def may_be_undefined(mechanism: Mechanism, parameters: tuple[Any, ...]) -> Flags:
    """Of which of many designs, parameters of shapes that broadcast, intervals do not tell that the force is finite.

    By as many of them as are tried at first: `check_defined` tells of each of these whether it is.
    """
    reach = np.asarray(mechanism.reach_at(*parameters), dtype=float)
    ends = [np.asarray(end, dtype=float) for end in mechanism.breakpoints(*parameters)]
    shape = np.broadcast_shapes(reach.shape, *(np.shape(one) for one in (*parameters, *ends)))
    found = np.zeros(math.prod(shape), dtype=bool)
    if not mechanism.enclosed or not mechanism.odd:
        return found.reshape(shape)
    values, bounds, (most,) = (
        [np.broadcast_to(np.asarray(one, dtype=float), shape).reshape(-1, 1) for one in some]
        for some in (parameters, ends, (reach,))
    )
    shares = np.linspace(0.0, 1.0, DIVISIONS + 1)
    with np.errstate(all="ignore"):
        for first in range(0, found.size, TOGETHER):
            part = slice(first, first + TOGETHER)
            last = most[part]
            edges = [np.zeros_like(last), *(np.minimum(end[part], last) for end in bounds), last]
            of = [Elementary(np.tile(np.repeat(one[part], DIVISIONS), (2, 1))) for one in values]
            one = Elementary.point(1.0)
            for number, (begin, end) in enumerate(pairwise(edges)):
                at = (end - begin) * shares
                beyond = Elementary(np.array([at[:, :-1].ravel(), at[:, 1:].ravel()]))
                force = mechanism.enclosed[number](Elementary.point, one, beyond, one, *of)[0]
                known = np.isfinite(Interval.like(force, beyond).ends).all(axis=0).reshape(-1, DIVISIONS)
                found[part] |= (~known & (end > begin)).any(axis=1) & np.isfinite(last[:, 0])
    return found.reshape(shape)


def _infinite_at(
    are_known: Callable[[Floats], Flags], at: Callable[[float], float], begin: float, end: float, reach: float
) -> float | None:
    """The least u of a piece where its force is not finite; None where it is so on all of it, or that is not seen soon.

    An interval that holds it is not known, but neither is one where intervals are too wide: numbers next to it decide.
    Where the piece begins, a quotient of zeros may be a number next to it.
    """
    pending = [(begin, end, DIVISIONS)] if end > begin else []
    for _ in range(MOST_CUTS):
        if not pending:
            break
        low, high, divisions = pending.pop()
        edges = np.linspace(low, high, divisions + 1)
        for k in np.flatnonzero(~are_known(edges))[::-1]:
            a, b = float(edges[k]), float(edges[k + 1])
            if b - a > NARROW * reach:
                pending.append((a, b, 2))
            elif begin < a and b < end and not all(abs(at(u)) < AT_POLE for u in (a, b, 2 * b - a)):
                return a
    return None
