"""Zeros of functions of one unknown, proved in balls. Takes numbers of an oscillator; returns intervals and doubts.

The search of native/proof.h on intervals between exact numbers of FLINT with as many digits as it takes: a cell is left
when a function is proved to have one sign on it, or to be monotone with proved signs at its ends; else it is cut. The
unknown is the amplitude, or the frequency at one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from functools import partial
from types import ModuleType
from typing import Any, NamedTuple

from flint import arb, ctx

from slowflow.core.mechanism import Mechanism
from slowflow.core.model import Model
from slowflow_kernels import slow_flow_balls
from slowflow_kernels import slow_flow_intervals as flow
from slowflow_kernels.conventions import ENDLESS

#: bits that a closed form may lose by each doubling of what `bits_lost` looks at, and at most
LOST, MOST_LOST = 12, 8_000
#: what is not decided after so many cells, or steps of Newton's method, is left in doubt
MOST_CELLS, MOST_STEPS = 4_000, 200
#: relative width of an interval that is cut only as long as that tells more, and of what lies between two in doubt that
#: are one, in digits
NARROW, TOUCH = 2 / 3, 0.55
#: how near to where its piece begins, relatively, no interval is cut
NEXT = arb(2) ** -960
#: what a function does on an interval is no more than what it is not known by at the ends, up to this
NOISE = 4
#: where an interval is cut, as a share: on no number that a zero may be exactly
CUT = arb(31) / 64 + arb(2) ** -20

INFINITE, ZERO = arb(math.inf), arb(0)


# ---- intervals -------------------------------------------------------------------------------------------------------


def _product(a: arb, b: arb) -> arb:
    product = a * b
    return ZERO if product.is_nan() and (a.is_zero() or b.is_zero()) else product


class Enclosure:
    """A closed interval between exact numbers, with the operators that generated kernels take.

    What is not known reaches to infinity, or is NaN: a test that asks whether something is proved fails there, and the
    other number stands first in `min` and `max`. 0 times infinity is 0. Balls would not do: one that reaches to
    infinity holds all numbers, the square of one about 0 negative ones.
    """

    __slots__ = ("hi", "lo")

    def __init__(self, lo: arb, hi: arb) -> None:
        self.lo, self.hi = lo, hi

    @classmethod
    def of(cls, value: Any) -> Enclosure:
        """What holds a number or a ball; all numbers, of a ball of which nothing is known."""
        if isinstance(value, Enclosure):
            return value
        ball = arb(value)
        return cls(ball.lower(), ball.upper()) if ball.is_exact() or ball.is_finite() else ALL

    @property
    def sign(self) -> int:
        """1 or -1 where it is proved, else 0."""
        return int(self.lo > 0) - int(self.hi < 0)

    @property
    def width(self) -> arb:
        """From end to end, rounded up."""
        return (self.hi - self.lo).upper()

    @property
    def middle(self) -> arb:
        """A number in it."""
        return ((self.lo + self.hi) / 2).mid()

    def __neg__(self) -> Enclosure:
        return Enclosure(-self.hi, -self.lo)

    def __add__(self, other: Any) -> Enclosure:
        lo, hi = (other.lo, other.hi) if isinstance(other, Enclosure) else (other, other)
        return Enclosure((self.lo + lo).lower(), (self.hi + hi).upper())

    def __sub__(self, other: Any) -> Enclosure:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> Enclosure:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> Enclosure:
        other = Enclosure.of(other)
        if not (self.lo <= self.hi and other.lo <= other.hi):
            return ALL
        ends = [_product(a, b) for a in (self.lo, self.hi) for b in (other.lo, other.hi)]
        return Enclosure(min(end.lower() for end in ends), max(end.upper() for end in ends))

    __radd__, __rmul__ = __add__, __mul__

    def __truediv__(self, other: Any) -> Enclosure:
        """0 may lie on the end of what is divided by; where it lies inside nothing is known."""
        other = Enclosure.of(other)
        if other.lo < 0 and other.hi <= 0:
            return (-self).__truediv__(-other)
        if not (other.lo >= 0 and other.hi > 0):
            return ALL
        return self.__mul__(Enclosure((1 / other.hi).lower(), (1 / other.lo).upper() if other.lo > 0 else INFINITE))

    def __rtruediv__(self, other: Any) -> Enclosure:
        return Enclosure.of(other).__truediv__(self)

    def square(self) -> Enclosure:
        """The square, which is not negative."""
        if not self.lo <= self.hi:
            return ALL
        lo, hi = max(ZERO, max(-self.hi, self.lo)), max(self.hi, -self.lo)
        return Enclosure((lo * lo).lower(), (hi * hi).upper())

    def sqrt(self) -> Enclosure:
        """The root of the part that is not negative."""
        lo = self.lo.sqrt().lower() if self.lo > 0 else ZERO
        return Enclosure(lo, self.hi.sqrt().upper() if not self.hi <= 0 else ZERO)

    def both(self, other: Enclosure) -> Enclosure:
        """What both hold, each being known to hold the value."""
        return Enclosure(max(self.lo, other.lo), min(self.hi, other.hi))


def hull(found: Sequence[Enclosure]) -> Enclosure:
    """What holds all of them."""
    return Enclosure(min(one.lo for one in found), max(one.hi for one in found))


ALL = Enclosure(-INFINITE, INFINITE)
AT_0 = Enclosure(ZERO, ZERO)
POSITIVE = Enclosure(ZERO, INFINITE)


# ---- the oscillator as it was given ----------------------------------------------------------------------------------


class Cell(NamedTuple):
    """What holds h, its derivatives and k = h - A h_A on all amplitudes between two, A.

    Of one amplitude that exceeds the beginning of its piece by A, exactly, `k_A` is not needed.
    """

    A: Any
    h: Enclosure
    h_A: Enclosure
    h_AA: Enclosure
    h_AAA: Enclosure
    k: Enclosure
    k_A: Enclosure = ALL


def averages_of(mechanism: Mechanism) -> ModuleType | None:
    """The module with the mechanism's averages in balls, None where there is none of this very one."""
    return mechanism.load_balls() if mechanism.load_balls is not None and mechanism.is_generated else None


def bits_lost(A: arb, ends: Sequence[arb]) -> int:
    """Bits that closed forms may lose at an amplitude: by powers of it and of where the first piece ends.

    Next to A = 1 too, where what elliptic integrals are multiplied by has powers of A - 1 below the line.
    """
    sizes = (abs(float(one)) for one in (A, A - 1, *ends[:1]))
    return min(MOST_LOST, LOST * sum(abs(math.frexp(size)[1]) for size in sizes if 0 < size < math.inf))


class BallModel:
    """A model's numbers in balls, to the digits of `flint.ctx` when it was made.

    Amplitudes of a piece are given by their distance from where it begins, so that one next to a breakpoint has all
    its digits.
    """

    def __init__(self, model: Model, averages: ModuleType) -> None:
        self.model, self.averages, self.digits = model, averages, ctx.prec
        self.design, self.count = [arb(number) for number in model.design], len(model.breakpoints)
        self._kept: dict[int, tuple[Any, ...]] = {}
        self.m, self.zeta = Enclosure.of(slow_flow_balls.friction(arb(model.mu))), Enclosure.of(model.zeta)
        _, *at_ends = self._numbers()
        self.b, self.jumps, self.kinks = ([Enclosure.of(value) for value in values] for values in at_ends)

    def _numbers(self) -> tuple[Any, ...]:
        """What averages take, where pieces end, what the force and its slope lose there: to the digits now."""
        if ctx.prec not in self._kept:
            found = tuple(self.averages.given(*self.design))
            parameters, jumps = found[: len(found) - self.count], found[len(found) - self.count :]
            ends = tuple(self.averages.breakpoints(*parameters)) if self.count else ()
            # a force that nowhere jumps has averages without its jumps
            kinked = hasattr(self.averages, "kinks")
            kinks = tuple(self.averages.kinks(*parameters)) if kinked else (arb.nan(),) * self.count
            self._kept[ctx.prec] = parameters if kinked else found, ends, jumps, kinks
        return self._kept[ctx.prec]

    def jumps_at(self, i: int) -> bool:
        """Whether the force may jump at breakpoint i."""
        return not self.jumps[i].lo == self.jumps[i].hi == 0

    def beyond(self, piece: int, x: Enclosure) -> Enclosure:
        """The amplitudes that exceed the beginning of a piece by so much."""
        return self.b[piece - 1] + x if piece else x

    def at(self, piece: int, x: arb, end: int | None = None) -> Cell:
        """What holds the averages: where x exceeds the piece's beginning, or at the breakpoint `end`."""
        lost = bits_lost(self.beyond(piece, Enclosure(x, x)).hi, [one.hi for one in self.b])
        with ctx.workprec(self.digits + lost):
            of_force, ends, *_ = self._numbers()
            begins = ends[piece - 1] if piece else ZERO
            A = begins + x if end is None else ends[end]
            if A == 0 and hasattr(self.averages, "at_rest"):
                found = self.averages.at_rest(*of_force)
            elif self.count:
                found = self.averages.known(piece, A, x if end is None else A - begins, *of_force)
            else:
                found = self.averages.known(A, *of_force)
        return Cell(x, *map(Enclosure.of, found))

    def below(self, i: int) -> Cell:
        """At breakpoint i, as the piece has it that ends there."""
        return self.at(i, (self.b[i] - (self.b[i - 1] if i else AT_0)).hi, i)

    def above(self, i: int) -> Cell:
        """The limit from above at breakpoint i: a jump of the force makes h_A infinite there, one of its slope h_AA."""
        at, jump, kink = self.below(i), self.jumps[i].sign, self.kinks[i].sign
        end = INFINITE * (jump or kink or 1)
        infinite = Enclosure(end, end)
        if jump:
            return Cell(ZERO, at.h, infinite, -infinite, infinite, -infinite)
        if kink and not self.jumps_at(i):
            return Cell(ZERO, at.h, at.h_A, infinite, -infinite, at.k)
        return Cell(ZERO, at.h, ALL, ALL, ALL, ALL)

    def between(self, piece: int, a: Cell, b: Cell) -> Cell:
        """On each piece h_AAA is monotone, as the derivation proves: what two amplitudes have bounds it."""
        A, width = self.beyond(piece, Enclosure(a.A, b.A)), (b.A - a.A).upper()
        h_AAA = hull([a.h_AAA, b.h_AAA])
        h_AA = between_values(a.h_AA, b.h_AA, h_AAA, width)
        h_A = between_values(a.h_A, b.h_A, h_AA, width)
        h = between_values(a.h, b.h, h_A, width)
        _, k_A = flow.intercept(A, h, h_A, h_AA)
        return Cell(A, h, h_A, h_AA, h_AAA, between_values(a.k, b.k, k_A, width), k_A)

    def on(self, i: int) -> Cell:
        """Breakpoint i as its lower side has it."""
        at = self.below(i)
        return self.between(i, at, at)._replace(A=self.b[i])

    def is_bounded(self, F_0: arb, A: float) -> bool:
        """Whether no amplitude from A on, up to one that stands for all, is that of a state at F_0 or less."""
        at, piece, begins = arb(A), self.count, self.b[-1] if self.count else AT_0
        if self.zeta.lo == 0 or (self.count and not at > begins.hi):
            return False
        here = self.at(piece, (at - begins.hi).lower())
        cell = self.between(piece, here, self.at(piece, (ENDLESS * max(A, 1.0) - begins.lo).upper()))
        limit = flow.most_restoring(Enclosure(at, at), Enclosure(F_0, F_0), self.m, self.zeta)
        h, h_A = (here.h, cell.h_A) if here.h.lo > 0 else (-here.h, -cell.h_A)
        return bool(h.lo > limit.hi and h_A.lo >= 0)


def _least_between(f_a: arb, f_b: arb, slope: Enclosure, width: arb) -> arb:
    """The least value of a function between two of its values whose slope is known, as native/cells.h."""
    lo, hi = slope.lo, slope.hi
    if lo >= 0 or hi <= 0:
        return min(f_b, f_a)
    if not (lo < 0 and hi > 0) or (lo == -INFINITE and hi == INFINITE):
        return -INFINITE
    if lo == -INFINITE or hi == INFINITE:
        return (f_b - hi * width if lo == -INFINITE else f_a + lo * width).lower()
    x = max(min(((f_b - f_a - hi * width) / (lo - hi)).mid(), width), ZERO)
    return min((f_b - hi * (width - x)).lower(), (f_a + lo * x).lower())


def between_values(f_a: Enclosure, f_b: Enclosure, slope: Enclosure, width: arb) -> Enclosure:
    """An enclosure of a function between two of its values, from enclosures of these and of its slope."""
    low = _least_between(f_a.lo, f_b.lo, slope, width)
    return Enclosure(low, -_least_between(-f_a.hi, -f_b.hi, -slope, width))


# ---- the search ------------------------------------------------------------------------------------------------------

#: where a function is defined, on a cell
NOWHERE, PARTLY, THROUGHOUT = range(3)


class Range(NamedTuple):
    """A function on a cell: where it is defined, what holds it, its slope and that slope's slope there.

    edge -- its sign at the end of where it is defined, if there is one end in the cell and its sign is known; else 0
    """

    where: int = NOWHERE
    y: Enclosure = ALL
    dy: Enclosure = ALL
    ddy: Enclosure = ALL
    edge: int = 0


class Zero(NamedTuple):
    """The only zero of a function, number `channel` of its question, in a cell; x: the unknown."""

    x: Enclosure
    on: Any
    channel: int
    rising: bool


class Place(NamedTuple):
    """A value of the unknown, what is known there, and the functions."""

    x: arb
    known: Any
    ranges: Sequence[Range]


@dataclass
class Search:
    """All zeros of functions of one unknown.

    at       -- what is known at a value of the unknown
    between  -- what is known between two of these: a cell
    question -- the functions on a cell
    begins   -- the origin of the unknown
    zeros, doubts -- what was found, by falling unknown; a doubt: where these digits do not decide
    """

    at: Callable[[arb], Any]
    between: Callable[[Any, Any], Any]
    question: Callable[[Any], Sequence[Range]]
    begins: arb = ZERO
    zeros: list[Zero] = field(default_factory=list)
    doubts: list[Enclosure] = field(default_factory=list)
    cells: int = 0

    def run(self, low: arb, high: arb, ends: tuple[Any, Any] | None = None) -> Search:
        """From one value of the unknown to another, of which what is known may be at hand."""
        a, b = (self._place(x, known) for x, known in zip((low, high), ends or (None, None), strict=True))
        self._search(a, b, range(len(b.ranges)))
        return self

    def positions(self) -> list[tuple[Enclosure, bool]]:
        """Where zeros are, and whether each may be none, or several."""
        return [*((zero.x, False) for zero in self.zeros), *((doubt, True) for doubt in self.doubts)]

    def _place(self, x: arb, known: Any = None) -> Place:
        known = self.at(x) if known is None else known
        return Place(x, known, self.question(self.between(known, known)))

    def _search(self, a: Place, b: Place, indices: Iterable[int]) -> None:
        self.cells += 1
        x = _cut(a.x, b.x)
        end = not a.x < x < b.x or bool(b.x <= NEXT * self.begins) or self.cells > MOST_CELLS
        cell, left = self.between(a.known, b.known), []
        ranges = self.question(cell)
        for c in indices:
            last = end or self._is_cut_enough(a, b, c, ranges[c])
            crossing, on = self._crossing(a, b, c, ranges[c], last)
            if crossing:
                self._enter(a, b, c, on, cell, crossing > 0)
            elif crossing is None and last:
                near = self.doubts and self.doubts[-1].lo - b.x <= arb(2) ** -int(TOUCH * ctx.prec) * b.x
                self.doubts.append(Enclosure(a.x, self.doubts.pop().hi if near else b.x))
            elif crossing is None:
                left.append(c)
        if left:
            middle = self._place(x)
            # what is hard lies above a breakpoint more often than not: it comes last
            self._search(middle, b, left)
            self._search(a, middle, left)

    def _crossing(self, a: Place, b: Place, c: int, on: Range, last: bool) -> tuple[int | None, Range]:
        """1: one zero, from below; -1: one, from above; 0: none; None: not known. The range with a narrower slope.

        last -- whether it need not be distinguished from the end of the range, which smaller cells may do
        """
        if on.where == NOWHERE or on.y.sign:
            return 0, on
        if on.where == PARTLY and on.edge == 0:
            return None, on
        at_a, at_b = a.ranges[c], b.ranges[c]
        if on.edge and last and on.dy.sign:
            # it ends in between, with a sign that is known
            for ends, other, turned in ((at_a, at_b, -1), (at_b, at_a, 1)):
                if ends.where == NOWHERE and other.where == THROUGHOUT and other.y.sign:
                    return (0 if other.y.sign == on.edge else turned * on.edge), on
        if not on.where == at_a.where == at_b.where == THROUGHOUT:
            return None, on
        width = (b.x - a.x).upper()
        on = on._replace(dy=on.dy.both(between_values(at_a.dy, at_b.dy, on.ddy, width)))
        if on.y.both(between_values(at_a.y, at_b.y, on.dy, width)).sign:
            return 0, on
        if not (on.dy.sign and at_a.y.sign and at_b.y.sign):
            return None, on
        return (0 if at_a.y.sign == at_b.y.sign else at_b.y.sign), on

    def _is_cut_enough(self, a: Place, b: Place, c: int, on: Range) -> bool:
        """Whether smaller cells tell no more of a function; one that rises or falls has its zero next to an end."""
        width, fraction = b.x - a.x, arb(2) ** -int(NARROW * ctx.prec)
        if not width <= fraction * (self.begins + b.x):
            return False
        at_a, at_b = a.ranges[c], b.ranges[c]
        if on.dy.sign or not on.where == at_a.where == at_b.where == THROUGHOUT:
            return bool(width <= fraction * b.x)
        return not (at_a.y.sign or at_b.y.sign or on.y.width > NOISE * min(at_b.y.width, at_a.y.width))

    def _enter(self, a: Place, b: Place, c: int, on: Range, cell: Any, rising: bool) -> None:
        """Enters the one zero between two values, made narrow by Newton's method on intervals."""
        x, halved = Enclosure(a.x, b.x), True
        for _ in range(MOST_STEPS):
            middle = _cut(x.lo, x.hi) if halved else x.middle
            if not x.lo < middle < x.hi:
                break
            there = self._place(middle).ranges[c]
            following = x.both(Enclosure(middle, middle) - there.y / on.dy)
            halved = not (following.lo <= following.hi and following.width < 0.75 * x.width)
            if there.where != THROUGHOUT or (halved and there.y.sign == 0):
                break
            if halved:  # as next to another zero, where slopes turn
                following = Enclosure(middle, x.hi) if (there.y.sign < 0) == rising else Enclosure(x.lo, middle)
            a = self._place(following.lo) if following.lo > x.lo else a
            b = self._place(following.hi) if following.hi < x.hi else b
            x, cell = following, self.between(a.known, b.known)
            narrower = self.question(cell)[c]
            on = narrower if narrower.where == THROUGHOUT and narrower.dy.sign else on
        self.zeros.append(Zero(x, cell, c, rising))


def _cut(low: arb, high: arb) -> arb:
    """A number well inside: halfway in orders of magnitude if there are many."""
    if low == 0:
        return (high * CUT / 4).mid()
    return ((low * high).sqrt() if high > 4 * low else low + (high - low) * CUT).mid()


def amplitudes_of(
    balls: BallModel, question: Callable[[Cell], Sequence[Range]], A_max: float, start: float = 0.0
) -> tuple[list[Zero], list[Enclosure]]:
    """Zeros along the amplitude, by rising amplitude, and amplitudes in doubt."""
    zeros, doubts, limit = [], [], arb(A_max)
    for piece in range(balls.count + 1):
        begins = balls.b[piece - 1].lo if piece else ZERO
        ends = piece < balls.count and bool(balls.b[piece].lo < limit)
        first = balls.above(piece - 1) if piece else balls.at(0, arb(start))
        last = balls.below(piece) if ends else balls.at(piece, (limit - begins).upper())
        search = Search(partial(balls.at, piece), partial(balls.between, piece), question, begins)
        search.run(first.A, last.A, (first, last))
        zeros += reversed(search.zeros)
        doubts += [balls.beyond(piece, one) for one in search.doubts]
        if not ends:
            break
    return zeros, doubts


def frequencies_of(function: Callable[[Enclosure], tuple[Any, Any]], low: arb, high: arb) -> Search:
    """Zeros along Omega between two frequencies; function: its values on an interval and those of its slope."""

    def question(w: Enclosure) -> Sequence[Range]:
        y, dy = function(w)
        return (Range(THROUGHOUT, Enclosure.of(y), Enclosure.of(dy)),)

    search = Search(lambda w: w, Enclosure, question)
    if high < INFINITE:
        return search.run(low, high)
    search.doubts.append(Enclosure(low, high))
    return search


def defined(x: Enclosure) -> int:
    """Where something is positive."""
    return THROUGHOUT if x.lo > 0 else NOWHERE if x.hi <= 0 else PARTLY
