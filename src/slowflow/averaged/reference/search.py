"""Zeros along the amplitude: in go pieces of the force and questions, out come all zeros of the questions' channels.

None is missed: an interval of A is left only when it is proved to hold no zero of a channel, because the function has
one sign on all of it, or exactly one, because it is monotone and its ends lie on both sides of zero. Otherwise it is
cut. What bounds a function and its slope on the interval is said in cells and along. Where that goes on until no
amplitude lies between the ends (a double zero to rounding), the signs at the ends decide, and that it was undecided is
said. As in native/scan.h; here all intervals of all pieces and questions are looked at together.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slowflow.averaged.reference.along import NOWHERE, THROUGHOUT, Asked, Channel, Range
from slowflow.averaged.reference.cells import Samples, Stretch, amid, between, cells_of, joined, samples_at
from slowflow.averaged.reference.intervals import Bools
from slowflow.model import Floats, Model
from slowflow_kernels.conventions import AT_ROOT, FIRST, MOST_CELLS, NARROW, SLOW

Ints = NDArray[np.intp]

#: NumPy looks at many intervals in the time that one takes: into how many orders a piece from A = 0 on is divided
#: before the first look, how often all is halved before it; and about how many intervals are made of what is left
ORDERS, HALVED_FIRST, TOGETHER = 6, 3, 256


@dataclass(frozen=True, eq=False)
class Zeros:
    """Zeros of one question, by rising A.

    piece     -- on which of the pieces
    channel   -- of which of its functions
    A, Omega  -- where
    level     -- of cusps: the forcing
    rising    -- whether the function goes from below zero to above it with rising A
    undecided -- whether some interval holds a number of zeros that doubles do not tell, or rounding may decide it
    """

    piece: Ints
    channel: Ints
    A: Floats
    Omega: Floats
    level: Floats
    rising: Bools
    undecided: bool = False

    def take(self, which: Any) -> Zeros:
        """Some of them."""
        return replace(self, **{name: value[which] for name, value in vars(self).items() if name != "undecided"})

    def __len__(self) -> int:
        return self.A.size


@dataclass(eq=False)
class _Brackets:
    """Intervals that hold just one zero of a channel each, which ends there with the sign `edge` if that is not 0."""

    piece: Ints
    low: Samples
    high: Samples
    channel: Ints
    edge: Ints


def find_zeros(model: Model, questions: Sequence[Asked], pieces: Sequence[Stretch]) -> list[Zeros]:
    """All zeros of each question's channels on the pieces; one at the last amplitude counts, one at A = 0 does not.

    Raises ArithmeticError where too many intervals stay undecided: numbers overflow.
    """
    with np.errstate(all="ignore"):
        return _find_zeros(model, questions, pieces)


def _find_zeros(model: Model, questions: Sequence[Asked], pieces: Sequence[Stretch]) -> list[Zeros]:
    piece, a, b = _first_intervals(model, pieces)
    base = np.array([one.base for one in pieces])
    values = [question.ask(joined(a, b)) for question in questions]
    is_open = [_opened(answers, a) for answers in values]
    brackets: list[list[_Brackets]] = [[] for _ in questions]
    undecided = [question.is_close(joined(a, b), answers) for question, answers in zip(questions, values, strict=True)]
    looked_at = 0
    while len(a):
        looked_at += len(a)
        if looked_at > MOST_CELLS:
            raise ArithmeticError("the response is unresolved: too many intervals of the amplitude stay undecided")
        n, middle = len(a), amid(base[piece], a.A, b.A)
        last = ~((middle > a.A) & (middle < b.A)) | (b.A - a.A <= NARROW * b.A)
        cells = cells_of(model, a, b)
        for number, question in enumerate(questions):
            some = np.flatnonzero(is_open[number].any(axis=0))
            if not some.size:
                continue
            part = cells if some.size == n else cells.take(some)
            for c, found in enumerate(question.range(part)):
                answer = values[number][c]
                settled, holds, edge, unknown = _settle(
                    answer.take(some), answer.take(n + some), found, part.A.ends, last[some]
                )
                wanted = is_open[number][c, some]
                undecided[number] |= bool((unknown & wanted).any())
                hits = some[holds & wanted]
                if hits.size:
                    of_hits = edge[holds & wanted]
                    channel = np.full(hits.size, c)
                    brackets[number].append(_Brackets(piece[hits], a.take(hits), b.take(hits), channel, of_hits))
                is_open[number][c, some] = wanted & ~settled
        piece, a, b, values, is_open, close = _cut(model, questions, base, piece, a, b, values, is_open)
        undecided = [one or other for one, other in zip(undecided, close, strict=True)]
    return [
        replace(_solved(model, question, base, found), undecided=unknown)
        for question, found, unknown in zip(questions, brackets, undecided, strict=True)
    ]


def _first_intervals(model: Model, pieces: Sequence[Stretch]) -> tuple[Ints, Samples, Samples]:
    """Numbers of pieces, and samples at both ends of each of the intervals that are looked at first."""
    numbers, lows, highs, inner = [], [], [], []
    for number, piece in enumerate(pieces):
        base, first, last = piece.base, piece.first.A[0], piece.last.A[0]
        nodes = np.array([first, last])
        if first == 0:
            nodes = np.concatenate(([0.0, FIRST], nodes[1] * 0.125 ** np.arange(ORDERS, -1, -1)))
        for _ in range(HALVED_FIRST):
            nodes = np.unique(np.concatenate((nodes, amid(np.asarray(base), nodes[:-1], nodes[1:]))))
            nodes = nodes[(nodes == first) | ((nodes >= FIRST) & (nodes < last)) | (nodes == last)]
        inner.append(nodes[1:-1])
        numbers.append(np.full(nodes.size - 1, number))
    at = samples_at(model, np.concatenate(inner))
    place = 0
    for piece, nodes in zip(pieces, inner, strict=True):
        own = at.take(slice(place, place + nodes.size))
        place += nodes.size
        lows.append(joined(piece.first, own))
        highs.append(joined(own, piece.last))
    return np.concatenate(numbers), joined(*lows), joined(*highs)


def _opened(answers: list[Channel], a: Samples) -> Bools:
    """Which intervals are looked at, a row for each channel: next to A = 0 none of what vanishes there."""
    n = len(a)
    vanishes = np.any([answer.exists[:n] & (answer.y[:n] == 0) for answer in answers], axis=0) & (a.A == 0)
    return np.tile(~vanishes, (len(answers), 1))


def _settle(a: Channel, b: Channel, found: Range, A: Floats, last: Bools) -> tuple[Bools, Bools, Ints, Bools]:
    """Whether a channel is settled on intervals, whether it has a zero there, the sign where it ends, and whether it is
    settled without a proof; `last`: it is settled anyway.
    """
    both = a.exists & b.exists
    passes = both & ((a.y < 0) != (b.y < 0))
    known = found.y.both(between(a.y, b.y, found.dy, A[1] - A[0]))
    # values on both sides of zero may differ by roundings more than slopes allow
    y = known.where((found.where == THROUGHOUT) & both & ~passes, found.y)
    empty = (found.where == NOWHERE) | y.has_sign
    decided = ~empty & (last | found.dy.has_sign)
    by_ends = decided & both & (last | (found.where == THROUGHOUT))
    edge = np.where((found.edge == 0) & last & (a.edge == b.edge), a.edge, found.edge).astype(np.intp)
    one_ends = decided & ~by_ends & (edge != 0) & (a.exists != b.exists)
    negative_a = np.where(a.exists, a.y < 0, edge < 0)
    negative_b = np.where(b.exists, b.y < 0, edge < 0)
    holds = (by_ends | one_ends) & (negative_a != negative_b)
    # it ends where its sign there turns, which doubles do not tell apart
    turns = decided & ~by_ends & ~one_ends & (a.exists != b.exists) & (a.edge * b.edge < 0)
    unknown = ~empty & last & (~found.dy.has_sign | turns)
    return empty | by_ends | one_ends | last, holds, np.where(one_ends, edge, 0), unknown


def _cut(
    model: Model,
    questions: Sequence[Asked],
    base: Floats,
    piece: Ints,
    a: Samples,
    b: Samples,
    values: list[list[Channel]],
    is_open: list[Bools],
) -> tuple[Ints, Samples, Samples, list[list[Channel]], list[Bools], list[bool]]:
    """The intervals that are open for some channel, cut in two or more; and whether a question is close."""
    n = len(a)
    left = np.flatnonzero(np.any([opened.any(axis=0) for opened in is_open], axis=0))
    if not left.size:
        return piece[left], a.take(left), b.take(left), values, is_open, [False for _ in questions]
    piece, a, b = piece[left], a.take(left), b.take(left)
    nodes = np.stack((a.A, b.A))
    for _ in range(int(np.clip(np.log2(TOGETHER / left.size), 1, 5))):
        both = np.empty((2 * nodes.shape[0] - 1, left.size))
        # next to a breakpoint rounding may put it outside
        both[::2], both[1::2] = nodes, np.clip(amid(base[piece], nodes[:-1], nodes[1:]), nodes[:-1], nodes[1:])
        nodes = both
    parts = nodes.shape[0] - 1
    inner = samples_at(model, nodes[1:-1].ravel())
    ends = joined(a, inner, b)
    # where the ends of each part stand among `ends`; a part that begins where its interval does has the same first
    # sample, which may be the limit above a breakpoint; one without width is none
    row, of = np.divmod(np.arange(parts * left.size), left.size)
    low, high = np.where(nodes[row, of] == a.A[of], of, row * left.size + of), (row + 1) * left.size + of
    kept = np.flatnonzero(ends.A[low] < ends.A[high])
    low, high, of = low[kept], high[kept], of[kept]
    fresh, of_inner = [], [question.ask(inner) for question in questions]
    close = [question.is_close(inner, asked) for question, asked in zip(questions, of_inner, strict=True)]
    for answers, asked in zip(values, of_inner, strict=True):
        table = [
            _joined_channels(answer.take(left), one, answer.take(n + left))
            for answer, one in zip(answers, asked, strict=True)
        ]
        fresh.append([one.take(np.concatenate((low, high))) for one in table])
    opened = [part[:, left][:, of] for part in is_open]
    return piece[of], ends.take(low), ends.take(high), fresh, opened, close


def _joined_channels(*parts: Channel) -> Channel:
    return Channel(*(np.concatenate([getattr(part, name) for part in parts]) for name in Channel.__dataclass_fields__))


def _solved(model: Model, question: Asked, base: Floats, found: list[_Brackets]) -> Zeros:
    """The zeros in the brackets, by rising A."""
    if not found:
        none, numbers = np.empty(0), np.empty(0, dtype=np.intp)
        return Zeros(numbers, numbers, none, none, none, np.empty(0, dtype=bool))
    brackets = _Brackets(
        np.concatenate([one.piece for one in found]),
        joined(*(one.low for one in found)),
        joined(*(one.high for one in found)),
        np.concatenate([one.channel for one in found]),
        np.concatenate([one.edge for one in found]),
    )
    zeros = _solve(model, question, base[brackets.piece], brackets)
    return zeros.take(np.lexsort((zeros.A, zeros.piece)))


def _of_channel(answers: list[Channel], channel: Ints) -> Channel:
    """At each sample the answer of its own channel."""
    if len(answers) == 1:
        return answers[0]
    first, second = answers
    return Channel(
        *(np.where(channel == 0, getattr(first, n), getattr(second, n)) for n in Channel.__dataclass_fields__)
    )


def _solve(model: Model, question: Asked, base: Floats, brackets: _Brackets) -> Zeros:
    """Newton's steps, kept in the brackets."""
    channel, edge = brackets.channel, brackets.edge
    lo, hi = brackets.low.A.copy(), brackets.high.A.copy()
    n = lo.size
    ends = _of_channel(question.ask(joined(brackets.low, brackets.high)), np.tile(channel, 2))
    at_low, at_high = ends.take(slice(0, n)), ends.take(slice(n, None))
    rising = np.where(at_low.exists, at_low.y < 0, edge < 0)
    # begin where the value is the lesser, of those that exist
    from_low = at_low.exists & ~(at_high.exists & ~(np.abs(at_low.y) < np.abs(at_high.y)))
    A = np.where(from_low, lo, hi)
    state = {name: np.where(from_low, getattr(at_low, name), getattr(at_high, name)) for name in at_low.__dict__}
    lo_state = {name: getattr(at_low, name).copy() for name in at_low.__dict__}
    hi_state = {name: getattr(at_high, name).copy() for name in at_high.__dict__}
    last = hi - lo
    active = np.arange(n)
    for step in range(400):
        x = A[active]
        following = np.where(state["exists"][active], x - state["y"][active] / state["dy"][active], np.nan)
        moved = np.abs(following - x)
        near = (moved <= 2.0**-52 * x) if step else np.zeros(active.size, dtype=bool)
        below, above = lo[active], hi[active]
        outside = ~((following > below) & (following < above)) | (moved > SLOW * last[active])
        following = np.where(outside, amid(base[active], below, above), following)
        near |= outside & ~((following > below) & (following < above))
        active, following = active[~near], following[~near]
        if not active.size:
            break
        last[active] = np.abs(following - A[active])
        answer = _of_channel(question.ask(samples_at(model, following)), channel[active])
        A[active] = following
        for name, column in state.items():
            column[active] = getattr(answer, name)
        negative = np.where(answer.exists, answer.y < 0, edge[active] < 0)
        same = negative == rising[active]
        for keep, ends_A, end_state in ((same, lo, lo_state), (~same, hi, hi_state)):
            ends_A[active[keep]] = following[keep]
            for name, column in end_state.items():
                column[active[keep]] = getattr(answer, name)[keep]
    # the channel may end an ulp before the zero: the end that it is defined at stands for it
    for ends_A, end_state in ((lo, lo_state), (hi, hi_state)):
        ended = ~state["exists"] & end_state["exists"]
        A = np.where(ended, ends_A, A)
        state = {name: np.where(ended, end_state[name], column) for name, column in state.items()}
    # Omega at the zero itself, which lies within roundings of A: where h_A is large, but no limit, that moves
    # Omega by much
    beyond = state["y"] / state["dy"]
    moves = (state["Omega_A"] != 0) & np.isfinite(state["Omega_A"]) & (np.abs(beyond) <= AT_ROOT * A)
    Omega = np.where(moves, state["Omega"] - state["Omega_A"] * np.where(moves, beyond, 0.0), state["Omega"])
    return Zeros(brackets.piece, channel, A, Omega, state["level"], rising)
