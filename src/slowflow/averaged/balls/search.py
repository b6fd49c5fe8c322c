"""Zeros along the amplitude, proved in balls: in go an oscillator as it was given and a question, out come intervals.

Each holds exactly one zero, or is said to be in doubt, where these digits do not decide; elsewhere there is none.

The search is that of native/proof.h: an interval of A is left when the function is proved to have one sign on it, or to
be monotone with proved signs at its ends; else it is cut, until that tells no more.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from enum import Enum

from flint import arb, ctx

from slowflow.averaged.balls.enclosure import ALL, INFINITE, ZERO, Enclosure, least, most
from slowflow.averaged.balls.given import Cell, Given, Known, along, cell_between

#: what is not decided after so many cells is left in doubt
MOST_CELLS = 4000
#: relative width of an interval that is cut only as long as that tells more, in digits; and how near to where its piece
#: begins, relatively, none is cut
NARROW, NEXT = 2 / 3, arb(2) ** -960
#: what a function does on an interval is no more than what it is not known by at the ends, up to this
NOISE = 4
#: of Newton's method on intervals, and of halving them
MOST_STEPS = 200
#: how often what is in doubt is looked at once more, each time with so much more around it
AROUND, WIDER = 4, 16


class Where(Enum):
    """Where a function is defined, on a cell."""

    NOWHERE = 0
    PARTLY = 1
    THROUGHOUT = 2


@dataclass(frozen=True)
class Range:
    """A function on a cell: where it is defined, what holds it, its slope and that slope's slope there.

    edge -- its sign at the end of where it is defined, if there is one end in the cell and its sign is known; else 0
    """

    where: Where
    y: Enclosure = ALL
    dy: Enclosure = ALL
    ddy: Enclosure = ALL
    edge: int = 0


NOWHERE = Range(Where.NOWHERE)

#: the functions of a question on a cell, its channels
Question = Callable[[Cell], Sequence[Range]]


@dataclass(frozen=True)
class Zero:
    """One zero: by how much it exceeds where its piece begins, the cell that holds it, whether the function rises."""

    beyond: Enclosure
    on: Cell
    piece: int
    channel: int
    rising: bool


@dataclass(frozen=True)
class Doubt:
    """Amplitudes of a piece between which these digits do not decide."""

    low: arb
    high: arb
    piece: int
    channel: int


@dataclass
class _Checked:
    """What is known at an amplitude, and the functions there, once they have been asked for."""

    known: Known
    ranges: Sequence[Range] | None = None

    @property
    def A(self) -> arb:
        return self.known.A


@dataclass
class Search:
    """All zeros of a question up to an amplitude.

    zeros, doubts -- what was found, in no order
    """

    given: Given
    question: Question
    zeros: list[Zero] = field(default_factory=list)
    doubts: list[Doubt] = field(default_factory=list)
    cells: int = 0

    def up_to(self, A_max: float, start: float = 0.0) -> Search:
        """Of all pieces; start: the first amplitude."""
        given, limit = self.given, arb(A_max)
        for piece in range(given.count + 1):
            before = len(self.doubts)
            first = given.above(piece - 1) if piece else given.at(0, arb(start))
            ends = piece < given.count and bool(given.b[piece].lo < limit)
            last = given.below(piece) if ends else given.at(piece, (limit - given.beginning(piece).lo).upper())
            low, high = _Checked(first), _Checked(last)
            self._between(piece, low, high, tuple(range(len(self._ranges(piece, high)))))
            self._look_again(piece, low, high, before)
            if not ends:
                break
        return self

    # ---- functions at amplitudes and between them -------------------------------------------------------------------

    def _at(self, piece: int, x: arb) -> _Checked:
        return _Checked(self.given.at(piece, x))

    def _ranges(self, piece: int, at: _Checked) -> Sequence[Range]:
        if at.ranges is None:
            A = self.given.beyond(piece, Enclosure(at.A, at.A))
            at.ranges = self.question(cell_between(A, at.known, at.known))
        return at.ranges

    def _on(self, piece: int, a: _Checked, b: _Checked) -> tuple[Cell, Sequence[Range]]:
        cell = cell_between(self.given.beyond(piece, Enclosure(a.A, b.A)), a.known, b.known)
        return cell, self.question(cell)

    def _crossing(
        self, piece: int, a: _Checked, b: _Checked, c: int, on: Range, last: bool
    ) -> tuple[int | None, Range]:
        """1: one zero, from below; -1: one, from above; 0: none; None: not known. The range with a narrower slope.

        last -- whether it need not be told from the end of what is asked, which smaller cells may do
        """
        if on.where is Where.NOWHERE or on.y.sign:
            return 0, on
        if on.where is Where.PARTLY and on.edge == 0:
            return None, on
        at_a, at_b = self._ranges(piece, a)[c], self._ranges(piece, b)[c]
        if on.edge and last and on.dy.sign:
            # it ends in between, with a sign that is known
            for ends, other, turned in ((at_a, at_b, -1), (at_b, at_a, 1)):
                if ends.where is Where.NOWHERE and other.where is Where.THROUGHOUT and other.y.sign:
                    return (0 if other.y.sign == on.edge else turned * on.edge), on
        if not on.where is at_a.where is at_b.where is Where.THROUGHOUT:
            return None, on
        width = (b.A - a.A).upper()
        on = replace(on, dy=on.dy.both(along(at_a.dy, at_b.dy, on.ddy, width)))
        if on.y.both(along(at_a.y, at_b.y, on.dy, width)).sign:
            return 0, on
        if not (on.dy.sign and at_a.y.sign and at_b.y.sign):
            return None, on
        return (0 if at_a.y.sign == at_b.y.sign else at_b.y.sign), on

    def _is_cut_enough(self, piece: int, a: _Checked, b: _Checked, c: int, on: Range) -> bool:
        """Whether smaller cells tell no more of a function; one that rises or falls has its zero next to an end."""
        width, share = b.A - a.A, arb(2) ** -int(NARROW * ctx.prec)
        if not width <= share * (self.given.beginning(piece).lo + b.A):
            return False
        narrow = bool(width <= share * b.A)
        at_a, at_b = self._ranges(piece, a)[c], self._ranges(piece, b)[c]
        if on.dy.sign or not on.where is at_a.where is at_b.where is Where.THROUGHOUT:
            return narrow
        noise = NOISE * least(at_a.y.width, at_b.y.width)
        return not (at_a.y.sign or at_b.y.sign or on.y.width > noise)

    # ---- the search -------------------------------------------------------------------------------------------------

    def _between(self, piece: int, a: _Checked, b: _Checked, wanted: tuple[int, ...]) -> None:
        x = amid(a.A, b.A)
        self.cells += 1
        begins = self.given.beginning(piece).lo
        end = not a.A < x < b.A or bool(b.A <= NEXT * begins) or self.cells > MOST_CELLS
        cell, ranges = self._on(piece, a, b)
        left = []
        for c in wanted:
            last = end or self._is_cut_enough(piece, a, b, c, ranges[c])
            crossing, on = self._crossing(piece, a, b, c, ranges[c], last)
            if crossing:
                self._add(piece, a, b, c, on, cell, crossing > 0)
            elif crossing is None and last:
                self._doubt(Doubt(a.A, b.A, piece, c))
            elif crossing is None:
                left.append(c)
        if left:
            middle = self._at(piece, x)
            # what is hard lies above a breakpoint more often than not: it comes last
            self._between(piece, middle, b, tuple(left))
            self._between(piece, a, middle, tuple(left))

    def _doubt(self, doubt: Doubt) -> None:
        """Enters it; neighbours are one."""
        for i, one in enumerate(self.doubts):
            if (one.channel, one.piece) == (doubt.channel, doubt.piece) and one.low == doubt.high:
                self.doubts[i] = replace(one, low=doubt.low)
                return
        self.doubts.append(doubt)

    def _look_again(self, piece: int, first: _Checked, last: _Checked, before: int) -> None:
        """What is in doubt once more, with something around it: a zero may have lain on a cell's end."""
        kept = self.doubts[:before]
        for doubt in self.doubts[before:]:
            around, settled = doubt.high - doubt.low, False
            for _ in range(AROUND):
                around = (around * WIDER).mid()
                low, high = (doubt.low - around).mid(), (doubt.high + around).mid()
                if not (low > first.A and high < last.A):
                    break
                a, b = self._at(piece, low), self._at(piece, high)
                cell, ranges = self._on(piece, a, b)
                crossing, on = self._crossing(piece, a, b, doubt.channel, ranges[doubt.channel], True)
                settled = crossing is not None
                if crossing and not self._holds(piece, doubt.channel, low, high):
                    self._add(piece, a, b, doubt.channel, on, cell, crossing > 0)
                if settled:
                    break
            if not settled:
                kept.append(doubt)
        self.doubts = kept

    def _holds(self, piece: int, c: int, low: arb, high: arb) -> bool:
        """Whether a zero that was found lies there."""
        return any(
            (one.piece, one.channel) == (piece, c) and one.beyond.hi >= low and one.beyond.lo <= high
            for one in self.zeros
        )

    def _add(self, piece: int, a: _Checked, b: _Checked, c: int, on: Range, cell: Cell, rising: bool) -> None:
        """Enters the one zero between two amplitudes, made narrow by Newton's method on intervals."""
        beyond, halved = Enclosure(a.A, b.A), False
        for step in range(MOST_STEPS):
            x = amid(beyond.lo, beyond.hi) if step == 0 or halved else beyond.middle
            if not beyond.lo < x < beyond.hi:
                break
            there = self._ranges(piece, self._at(piece, x))[c]
            if there.where is not Where.THROUGHOUT:
                break
            following = beyond.both(Enclosure(x, x) - there.y / on.dy)
            halved = not (following.lo <= following.hi and following.width < 0.75 * beyond.width)
            if halved and there.y.sign == 0:
                break
            if halved:  # as next to another zero, where slopes turn
                following = Enclosure(x, beyond.hi) if (there.y.sign < 0) == rising else Enclosure(beyond.lo, x)
            a = self._at(piece, following.lo) if following.lo > beyond.lo else a
            b = self._at(piece, following.hi) if following.hi < beyond.hi else b
            beyond = following
            cell, ranges = self._on(piece, a, b)
            if ranges[c].where is Where.THROUGHOUT and ranges[c].dy.sign:
                on = ranges[c]
        self.zeros.append(Zero(beyond, cell, piece, c, rising))


def amid(low: arb, high: arb) -> arb:
    """A number well inside: halfway in orders of magnitude if there are many."""
    if low == ZERO:
        return (high / 8).mid()
    if high > 4 * low:
        return (low * high).sqrt().mid()
    return ((low + high) / 2).mid()


def positive(x: Enclosure) -> Where:
    """Where something is positive."""
    return Where.THROUGHOUT if x.lo > 0 else Where.NOWHERE if x.hi <= 0 else Where.PARTLY


def clipped(x: Enclosure, low: arb = -INFINITE, high: arb = INFINITE) -> Enclosure:
    """The part between two numbers."""
    return Enclosure(most(x.lo, low), least(x.hi, high))
