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

from slowflow.averaged.reference.along import NOWHERE, THROUGHOUT, Asked, Channels, Ranges
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
    """Intervals that hold just one zero of a channel of a question each.

    A, rows -- arrays (2, n), (2, 7, n): the ends and what the channel is there, as `Channels` has it
    edge    -- the sign with which the channel ends there, if that is not 0
    """

    question: Ints
    channel: Ints
    piece: Ints
    A: Floats
    rows: Floats
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
    starts = joined(*(one.first for one in pieces))
    values = [question.ask(joined(a, b)) for question in questions]
    is_open = [_opened(answers, a) for answers in values]
    brackets: list[_Brackets] = []
    undecided = [question.is_close(joined(a, b), answers) for question, answers in zip(questions, values, strict=True)]
    looked_at = 0
    while len(a):
        looked_at += len(a)
        if looked_at > MOST_CELLS:
            raise ArithmeticError(
                "the response is unresolved: too many intervals of the amplitude stay undecided, as where numbers "
                "leave the range of doubles"
            )
        n, middle = len(a), amid(base[piece], a.A, b.A)
        last = ~((middle > a.A) & (middle < b.A)) | (b.A - a.A <= NARROW * b.A)
        cells = cells_of(model, a, b, starts.take(piece))
        for number, question in enumerate(questions):
            some = np.flatnonzero(is_open[number].any(axis=0))
            if not some.size:
                continue
            part = cells if some.size == n else cells.take(some)
            at_a, at_b = values[number].take(some), values[number].take(n + some)
            settled, holds, edge, unknown = _settle(at_a, at_b, question.range(part), part.A.ends, last[some])
            wanted = is_open[number][:, some]
            undecided[number] |= bool((unknown & wanted).any())
            channel, place = (holds & wanted).nonzero()
            if channel.size:
                rows = np.array((at_a.rows[:, channel, place], at_b.rows[:, channel, place]))
                of = np.full(channel.size, number), channel, piece[some[place]]
                brackets.append(_Brackets(*of, part.A.ends[:, place], rows, edge[channel, place]))
            is_open[number][:, some] = wanted & ~settled
        piece, a, b, values, is_open, close = _cut(model, questions, base, piece, a, b, values, is_open)
        undecided = [one or other for one, other in zip(undecided, close, strict=True)]
    return _solved(model, questions, base, brackets, undecided)


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


def _opened(answers: Channels, a: Samples) -> Bools:
    """Which intervals are looked at, a row for each channel: next to A = 0 none of what vanishes there."""
    at_a = answers.take(slice(0, len(a)))
    vanishes = (at_a.exists & (at_a.y == 0)).any(axis=0) & (a.A == 0)
    return np.array([~vanishes] * len(answers.y))


def _settle(a: Channels, b: Channels, found: Ranges, A: Floats, last: Bools) -> tuple[Bools, Bools, Ints, Bools]:
    """Whether channels are settled on intervals, whether they have a zero there, the sign where they end, and whether
    they are settled without a proof; `last`: they are settled anyway.
    """
    in_a, in_b, falls_a, falls_b = a.exists, b.exists, a.y < 0, b.y < 0
    both, throughout, monotone = in_a & in_b, found.where == THROUGHOUT, found.dy.has_sign | found.once
    passes = both & (falls_a != falls_b)
    known = found.y.both(between(a.y, b.y, found.dy, A[1] - A[0]))
    # values on both sides of zero may differ by roundings more than slopes allow
    y = known.where(throughout & both & ~passes, found.y)
    empty = (found.where == NOWHERE) | y.has_sign
    decided = ~empty & (last | monotone)
    by_ends = decided & both & (last | throughout)
    edge = np.where((found.edge == 0) & last & (a.edge == b.edge), a.edge, found.edge).astype(np.intp)
    one_ends = decided & ~by_ends & (edge != 0) & (in_a != in_b)
    negative_a, negative_b = np.where(in_a, falls_a, edge < 0), np.where(in_b, falls_b, edge < 0)
    holds = (by_ends | one_ends) & (negative_a != negative_b)
    # they end where their sign there turns, which doubles do not tell apart
    turns = decided & ~by_ends & ~one_ends & (in_a != in_b) & (a.edge * b.edge < 0)
    unknown = ~empty & last & (~monotone | turns)
    return empty | by_ends | one_ends | last, holds, np.where(one_ends, edge, 0), unknown


def _cut(
    model: Model,
    questions: Sequence[Asked],
    base: Floats,
    piece: Ints,
    a: Samples,
    b: Samples,
    values: list[Channels],
    is_open: list[Bools],
) -> tuple[Ints, Samples, Samples, list[Channels], list[Bools], list[bool]]:
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
    fresh, opened, close = [], [], []
    for question, answers, part in zip(questions, values, is_open, strict=True):
        # a question is asked on the intervals that are open for it
        own = np.flatnonzero(part[:, left].any(axis=0))
        rows = np.zeros((*answers.rows.shape[:2], parts + 1, left.size))
        close.append(False)
        if own.size:
            asked = (
                inner
                if own.size == left.size
                else inner.take(np.add.outer(left.size * np.arange(parts - 1), own).ravel())
            )
            found = question.ask(asked)
            close[-1] = question.is_close(asked, found)
            rows[..., 1:-1, own] = found.rows.reshape(*rows.shape[:2], parts - 1, own.size)
            rows[..., 0, :], rows[..., -1, :] = answers.rows[..., left], answers.rows[..., n + left]
        fresh.append(Channels(rows.reshape(*rows.shape[:2], -1)[..., np.concatenate((low, high))]))
        opened.append(part[:, left[of]])
    return piece[of], ends.take(low), ends.take(high), fresh, opened, close


def _solved(
    model: Model, questions: Sequence[Asked], base: Floats, found: list[_Brackets], undecided: list[bool]
) -> list[Zeros]:
    """The zeros in the brackets, of each question by rising A."""
    if not found:
        none, numbers = np.empty(0), np.empty(0, dtype=np.intp)
        nothing = Zeros(numbers, numbers, none, none, none, np.empty(0, dtype=bool))
        return [replace(nothing, undecided=unknown) for unknown in undecided]
    brackets = _Brackets(
        *(np.concatenate([getattr(one, name) for one in found], axis=-1) for name in _Brackets.__dataclass_fields__)
    )
    zeros = _solve(model, questions, base[brackets.piece], brackets)
    order = np.lexsort((zeros.A, zeros.piece))
    return [
        replace(zeros.take(order[brackets.question[order] == number]), undecided=unknown)
        for number, unknown in enumerate(undecided)
    ]


def _asked(questions: Sequence[Asked], of: Ints, channel: Ints, at: Samples) -> Floats:
    """At each sample (n,) the answer of its own channel of its own question: rows (7, n)."""
    rows = np.empty((7, len(at)))
    for number, question in enumerate(questions):
        own = np.flatnonzero(of == number)
        if own.size:
            rows[:, own] = question.ask(at.take(own)).rows[:, channel[own], np.arange(own.size)]
    return rows


def _solve(model: Model, questions: Sequence[Asked], base: Floats, brackets: _Brackets) -> Zeros:
    """Newton's steps, kept in the brackets."""
    question, channel, edge = brackets.question, brackets.channel, brackets.edge
    ends_A, ends = brackets.A.copy(), brackets.rows.copy()
    at_low, at_high = Channels(ends[0]), Channels(ends[1])
    rising = np.where(at_low.exists, at_low.y < 0, edge < 0)
    # begin where the value is the lesser, of those that exist
    from_low = at_low.exists & ~(at_high.exists & ~(np.abs(at_low.y) < np.abs(at_high.y)))
    A, state = np.where(from_low, ends_A[0], ends_A[1]), np.where(from_low, ends[0], ends[1])
    last = ends_A[1] - ends_A[0]
    active = np.arange(A.size)
    for step in range(400):
        x, (below, above), (exists, y, dy) = A[active], ends_A[:, active], state[:3, active]
        following = np.where(exists != 0, x - y / dy, np.nan)
        moved = np.abs(following - x)
        near = (moved <= 2.0**-52 * x) if step else np.zeros(active.size, dtype=bool)
        outside = ~((following > below) & (following < above)) | (moved > SLOW * last[active])
        if outside.any():
            following = np.where(outside, amid(base[active], below, above), following)
            near |= outside & ~((following > below) & (following < above))
        active, following = active[~near], following[~near]
        if not active.size:
            break
        last[active] = np.abs(following - A[active])
        answer = _asked(questions, question[active], channel[active], samples_at(model, following))
        A[active], state[:, active] = following, answer
        negative = np.where(answer[0] != 0, answer[1] < 0, edge[active] < 0)
        # the end that it takes the place of: the lower one has the sign that the channel rises from
        end = (negative != rising[active]).astype(np.intp)
        ends_A[end, active], ends[end, :, active] = following, answer.T
    # the channel may end an ulp before the zero: the end that it is defined at stands for it
    for end in (0, 1):
        ended = (state[0] == 0) & (ends[end, 0] != 0)
        A, state = np.where(ended, ends_A[end], A), np.where(ended, ends[end], state)
    # Omega at the zero itself, which lies within roundings of A: where h_A is large, but no limit, that moves
    # Omega by much
    at = Channels(state)
    beyond = at.y / at.dy
    moves = (at.Omega_A != 0) & np.isfinite(at.Omega_A) & (np.abs(beyond) <= AT_ROOT * A)
    Omega = np.where(moves, at.Omega - at.Omega_A * np.where(moves, beyond, 0.0), at.Omega)
    return Zeros(brackets.piece, channel, A, Omega, at.level, rising)
