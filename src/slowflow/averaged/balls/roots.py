"""Positive frequencies at one amplitude, proved in balls: a function of Omega and its slope in, intervals out.

Each holds exactly one root, or is said to hold any number; elsewhere there is none. As native/proved_roots.h.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb, ctx

from slowflow.averaged.balls.enclosure import INFINITE, ZERO, Enclosure, least
from slowflow.averaged.balls.given import along
from slowflow.averaged.balls.search import MOST_STEPS, NOISE, amid

#: a function of Omega, and its slope
OfOmega = Callable[[Enclosure], tuple[Enclosure, Enclosure]]
MOST_CELLS = 5_000
#: relative width of an interval in which a root may be double, and of what lies between two that are one, in digits
NARROW, TOUCH = 0.6, 0.55


@dataclass
class Roots:
    """Intervals by rising Omega, and whether each may hold no root, or several.

    full -- whether there is anything that was not looked at
    """

    at: list[Enclosure]
    doubtful: list[bool]
    full: bool = False
    cells: int = 0


def narrowed(function: OfOmega, w: Enclosure) -> Enclosure:
    """The one root in an interval on which the slope has a sign."""
    for _ in range(MOST_STEPS):
        x = Enclosure(w.middle, w.middle)
        following = w.both(x - function(x)[0] / function(w)[1])
        if not following.lo <= following.hi or not following.width < 0.75 * w.width:
            break
        w = following
    return w


def between(function: OfOmega, low: arb, high: arb, out: Roots) -> None:
    """Those between two frequencies."""
    w, middle = Enclosure(low, high), amid(low, high)
    out.cells += 1
    y, dy = function(w)
    if y.sign:
        return
    at_low, at_high = function(Enclosure(low, low))[0], function(Enclosure(high, high))[0]
    if along(at_low, at_high, dy, w.width).sign:
        return
    if dy.sign and at_low.sign and at_high.sign:
        if at_low.sign != at_high.sign:
            out.at.append(narrowed(function, w))
            out.doubtful.append(False)
        return
    last = not low < middle < high or out.cells > MOST_CELLS
    if not last and w.width <= arb(2) ** -int(NARROW * ctx.prec) * high:
        # where it only rises or falls its root lies next to an end
        noise = NOISE * least(at_low.width, at_high.width)
        last = bool(dy.sign) or not (at_low.sign or at_high.sign or y.width > noise)
    if not last:
        between(function, low, middle, out)
        between(function, middle, high, out)
        return
    near = arb(2) ** -int(TOUCH * ctx.prec) * low
    if out.at and out.doubtful[-1] and low - out.at[-1].hi <= near:
        out.at[-1] = Enclosure(out.at[-1].lo, high)
    else:
        out.at.append(w)
        out.doubtful.append(True)


def up_to(function: OfOmega, most: arb) -> Roots:
    """All of them, none of which is above `most`."""
    found = Roots([], [])
    if not most < INFINITE:
        found.full = True
    else:  # twice: no root lies on the end of the search
        between(function, ZERO, 2 * most, found)
    return found
