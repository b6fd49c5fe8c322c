"""The oscillator as it was given, in balls: in go its numbers, taken exactly, out comes what holds the averaged force.

As native/given.h and native/cells.h say it for doubles. Amplitudes of a piece are told by how much they exceed where it
begins, an exact number, so that one next to a breakpoint has all its digits.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from types import ModuleType
from typing import Any

from flint import arb, ctx

from slowflow.averaged.balls.enclosure import ALL, INFINITE, ZERO, Enclosure, least, most
from slowflow.mechanism import Mechanism
from slowflow.model import Model
from slowflow_kernels import slow_flow_balls, slow_flow_intervals

#: bits that a closed form may lose by each doubling of what `bits_lost` looks at, and at most
LOST, MOST_LOST = 12, 8_000


def averages_of(mechanism: Mechanism) -> ModuleType | None:
    """The module with the mechanism's averages in balls, None where there is none of this very one."""
    return mechanism.load_balls() if mechanism.load_balls is not None and mechanism.is_generated else None


def bits_lost(A: arb, ends: Sequence[arb]) -> int:
    """Bits that closed forms may lose at an amplitude: by powers of it and of where the first piece ends.

    Next to A = 1 too, where what elliptic integrals are multiplied by has powers of A - 1 below the line.
    """
    sizes = (abs(float(one)) for one in (A, A - 1, *ends[:1]))
    return min(MOST_LOST, LOST * sum(abs(math.frexp(size)[1]) for size in sizes if 0 < size < math.inf))


@dataclass(frozen=True)
class Known:
    """What holds h, its derivatives and k = h - A h_A at an amplitude that exceeds where its piece begins by A."""

    A: arb
    h: Enclosure
    h_A: Enclosure
    h_AA: Enclosure
    h_AAA: Enclosure
    k: Enclosure


@dataclass(frozen=True)
class Cell:
    """The same on all amplitudes between two; A holds these themselves."""

    A: Enclosure
    h: Enclosure
    h_A: Enclosure
    h_AA: Enclosure
    h_AAA: Enclosure
    k: Enclosure
    k_A: Enclosure


@dataclass(frozen=True)
class _Numbers:
    """What follows from a design: what the averages take, where pieces end, what the force and its slope lose there."""

    of_force: tuple[Any, ...]
    ends: tuple[arb, ...]
    jumps: tuple[Any, ...]
    kinks: tuple[Any, ...]


class Given:
    """A model's numbers in balls, to the digits of `flint.ctx` when it was made."""

    def __init__(self, model: Model, averages: ModuleType) -> None:
        self.averages, self.digits = averages, ctx.prec
        self.design = [arb(number) for number in model.design]
        self.count = len(model.breakpoints)
        self._kept: dict[int, _Numbers] = {}
        numbers = self._numbers()
        self.m = Enclosure.of(slow_flow_balls.friction(arb(model.mu)))
        self.zeta = Enclosure.of(model.zeta)
        self.b, self.jumps, self.kinks = (
            [Enclosure.of(value) for value in values] for values in (numbers.ends, numbers.jumps, numbers.kinks)
        )

    def _numbers(self) -> _Numbers:
        """To the digits of `flint.ctx` now."""
        if ctx.prec not in self._kept:
            found = tuple(self.averages.given(*self.design))
            parameters, jumps = found[: len(found) - self.count], found[len(found) - self.count :]
            ends = tuple(self.averages.breakpoints(*parameters)) if self.count else ()
            # a force that nowhere jumps has averages without its jumps
            kinked = hasattr(self.averages, "kinks")
            kinks = tuple(self.averages.kinks(*parameters)) if kinked else (arb.nan(),) * self.count
            self._kept[ctx.prec] = _Numbers(parameters if kinked else found, ends, jumps, kinks)
        return self._kept[ctx.prec]

    def beginning(self, piece: int) -> Enclosure:
        """Where a piece begins."""
        return self.b[piece - 1] if piece else Enclosure(ZERO, ZERO)

    def beyond(self, piece: int, x: Enclosure) -> Enclosure:
        """The amplitudes that exceed it by so much."""
        return self.b[piece - 1] + x if piece else x

    def at(self, piece: int, x: arb) -> Known:
        """At the amplitude that exceeds the beginning of its piece by x."""
        found = self._held(piece, x, None)
        return Known(x, *found)

    def below(self, i: int) -> Known:
        """At breakpoint i, as the piece has it that ends there; to be told by how much that exceeds its beginning."""
        x = (self.b[i] - self.beginning(i)).hi
        return Known(x, *self._held(i, x, i))

    def _held(self, piece: int, x: arb, end: int | None) -> list[Enclosure]:
        """What holds the averages: where x exceeds the piece's beginning, or at the breakpoint `end`."""
        lost = bits_lost(self.beginning(piece).hi + x, [end.hi for end in self.b])
        with ctx.workprec(self.digits + lost):
            numbers = self._numbers()
            begins = numbers.ends[piece - 1] if piece else ZERO
            A = begins + x if end is None else numbers.ends[end]
            if A == 0 and hasattr(self.averages, "at_rest"):
                found = self.averages.at_rest(*numbers.of_force)
            elif self.count:
                found = self.averages.known(piece, A, x if end is None else A - begins, *numbers.of_force)
            else:
                found = self.averages.known(A, *numbers.of_force)
        return [Enclosure.of(value) for value in found]

    def above(self, i: int) -> Known:
        """The limit from above at breakpoint i: a jump of the force makes h_A infinite there, one of its slope h_AA."""
        at, jump = self.below(i), self.jumps[i]
        if jump.sign:
            h_A = _infinite(jump.sign)
            return Known(ZERO, at.h, h_A, -h_A, h_A, -h_A)
        if jump.lo == jump.hi == 0 and self.kinks[i].sign:
            h_AA = _infinite(self.kinks[i].sign)
            return Known(ZERO, at.h, at.h_A, h_AA, -h_AA, at.k)
        return Known(ZERO, at.h, ALL, ALL, ALL, ALL)


def _infinite(sign: int) -> Enclosure:
    end = INFINITE if sign > 0 else -INFINITE
    return Enclosure(end, end)


def _least_between(f_a: arb, f_b: arb, lo: arb, hi: arb, width: arb) -> arb:
    """The least value between two of what falls by lo < 0 and rises by hi > 0 at most, as native/cells.h."""
    x = most(ZERO, least(width, ((f_b - f_a - hi * width) / (lo - hi)).mid()))
    return least((f_a + lo * x).lower(), (f_b - hi * (width - x)).lower())


def _between(f_a: arb, f_b: arb, slope: Enclosure, width: arb) -> Enclosure:
    """A function between two of its values whose slope is known."""
    lo, hi = slope.lo, slope.hi
    if lo >= 0 or hi <= 0:
        return Enclosure(least(f_a, f_b), most(f_a, f_b))
    if not (lo < 0 and hi > 0) or (lo == -INFINITE and hi == INFINITE):
        return ALL
    if lo == -INFINITE:
        return Enclosure((f_b - hi * width).lower(), (f_a + hi * width).upper())
    if hi == INFINITE:
        return Enclosure((f_a + lo * width).lower(), (f_b - lo * width).upper())
    return Enclosure(_least_between(f_a, f_b, lo, hi, width), -_least_between(-f_a, -f_b, -hi, -lo, width))


def along(f_a: Enclosure, f_b: Enclosure, slope: Enclosure, width: arb) -> Enclosure:
    """The same between two values that are known to lie in intervals."""
    return Enclosure(_between(f_a.lo, f_b.lo, slope, width).lo, _between(f_a.hi, f_b.hi, slope, width).hi)


def cell_between(A: Enclosure, a: Known, b: Known) -> Cell:
    """On each piece of the force h_AAA is monotone, as the derivation proves: what two amplitudes have bounds it."""
    width = (b.A - a.A).upper()
    h_AAA = a.h_AAA.hull(b.h_AAA)
    h_AA = along(a.h_AA, b.h_AA, h_AAA, width)
    h_A = along(a.h_A, b.h_A, h_AA, width)
    h = along(a.h, b.h, h_A, width)
    _, k_A = slow_flow_intervals.intercept(A, h, h_A, h_AA)
    return Cell(A, h, h_A, h_AA, h_AAA, along(a.k, b.k, k_A, width), k_A)
