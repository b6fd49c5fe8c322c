"""Zeros along the amplitude: in go pieces of the force and questions, out come all zeros of the questions' channels.

None is missed: an interval of A is left only when it is proved to hold no zero of a channel, because the function has
one sign on all of it, or exactly one, because it is monotone and its ends lie on both sides of zero. Otherwise it is
cut. What bounds a function and its slope on the interval is said in cells and along. Where that goes on until no
amplitude lies between the ends (a double zero to rounding), the signs at the ends decide, and that it was undecided is
said. As in native/scan.h; here all intervals of all pieces and questions are looked at together, and those of all
designs that go abreast. How an interval is cut does not depend on those of other designs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from slowflow.averaged.reference.along import NOWHERE, THROUGHOUT, Asked, Channels, Ranges
from slowflow.averaged.reference.cells import Samples, Stretch, amid, between, cells_of, joined, samples_at
from slowflow.averaged.reference.roots import Ints
from slowflow.intervals import Bools
from slowflow.model import Floats, Model
from slowflow_kernels.conventions import AT_ROOT, FIRST, MOST_CELLS, NARROW, SLOW
from slowflow_support.errors import NotSettled

#: NumPy looks at many intervals in the time that one takes: into how many orders a piece from A = 0 on is divided
#: before the first look, how often all is halved before it; and about how many intervals are made of what is left
ORDERS, HALVED_FIRST, TOGETHER = 6, 3, 256
GIVEN_UP = (
    "the response is unresolved: too many intervals of the amplitude stay undecided, as where numbers leave the range "
    "of doubles"
)


@dataclass(frozen=True, eq=False)
class Zeros:
    """Zeros of one question, by rising A.

    of        -- of which of the designs abreast
    piece     -- on which of the pieces
    channel   -- of which of its functions
    A, Omega  -- where
    level     -- of cusps: the forcing
    rising    -- whether the function goes from below zero to above it with rising A
    undecided -- of each design, whether some interval holds a number of zeros that doubles do not tell, or rounding may
                 decide it
    """

    of: Ints
    piece: Ints
    channel: Ints
    A: Floats
    Omega: Floats
    level: Floats
    rising: Bools
    undecided: Bools

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
    found, given_up = find_zeros_abreast(model, questions, pieces)
    if given_up.any():
        raise NotSettled(GIVEN_UP)
    return found


@np.errstate(all="ignore")
def find_zeros_abreast(
    model: Model, questions: Sequence[Asked], pieces: Sequence[Stretch]
) -> tuple[list[Zeros], Bools]:
    """The same, of designs abreast; and of which of them the search was given up, whose zeros are none."""
    starts, base = joined(*(one.first for one in pieces)), np.concatenate([one.base for one in pieces])
    piece, a, b = _first_intervals(model, starts, joined(*(one.last for one in pieces)), base)
    ends = joined(a, b)
    values = [question.ask(ends) for question in questions]
    is_open = [_opened(answers, a) for answers in values]
    brackets: list[_Brackets] = []
    undecided = np.zeros((len(questions), model.abreast), dtype=bool)
    for number, (question, answers) in enumerate(zip(questions, values, strict=True)):
        undecided[number, ends.of[question.is_close(ends, answers)]] = True
    looked_at = np.zeros(model.abreast, dtype=np.intp)
    while len(a):
        n, of, middle = len(a), a.of, amid(base[piece], a.A, b.A)
        looked_at += np.bincount(of, minlength=looked_at.size)
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
            undecided[number, of[some[(unknown & wanted).any(axis=0)]]] = True
            channel, place = (holds & wanted).nonzero()
            if channel.size:
                rows = np.array((at_a.rows[:, channel, place], at_b.rows[:, channel, place]))
                whose = np.full(channel.size, number), channel, piece[some[place]]
                brackets.append(_Brackets(*whose, part.A.ends[:, place], rows, edge[channel, place]))
            is_open[number][:, some] = wanted & ~settled
        for opened in is_open:
            opened[:, (looked_at > MOST_CELLS)[of]] = False
        piece, a, b, values, is_open = _cut(model, questions, base, piece, a, b, values, is_open, undecided)
    return _solved(model, questions, starts, base, brackets, undecided), looked_at > MOST_CELLS


def _first_intervals(model: Model, starts: Samples, ends: Samples, base: Floats) -> tuple[Ints, Samples, Samples]:
    """Numbers of pieces, and samples at both ends of each of the intervals that are looked at first."""
    first, last = starts.A, ends.A
    from_0 = np.flatnonzero(first == 0)
    orders = 0.125 ** np.arange(ORDERS, 0, -1)
    nodes = np.concatenate((first, last, np.full(from_0.size, FIRST), np.outer(last[from_0], orders).ravel()))
    every = np.arange(first.size)
    piece = np.concatenate((every, every, from_0, np.repeat(from_0, ORDERS)))
    for halving in range(HALVED_FIRST + 1):
        order = np.lexsort((nodes, piece))
        nodes, piece = nodes[order], piece[order]
        kept = (nodes == first[piece]) | ((nodes >= FIRST) & (nodes < last[piece])) | (nodes == last[piece])
        kept[1:] &= (nodes[1:] != nodes[:-1]) | (piece[1:] != piece[:-1])
        nodes, piece = nodes[kept], piece[kept]
        low = np.flatnonzero(piece[1:] == piece[:-1])
        if halving < HALVED_FIRST:
            nodes = np.concatenate((nodes, amid(base[piece[low]], nodes[low], nodes[low + 1])))
            piece = np.concatenate((piece, piece[low]))
    at_first, at_last = (np.append(True, piece[1:] != piece[:-1]), np.append(piece[1:] != piece[:-1], True))
    inner = ~(at_first | at_last)
    at = np.empty((starts.rows.shape[0], nodes.size))
    at[:, inner] = samples_at(model, nodes[inner], starts.of[piece[inner]]).rows
    at[:, at_last] = ends.rows[:, piece[at_last]]
    at[:, at_first] = starts.rows[:, piece[at_first]]
    return piece[low], Samples(at[:, low]), Samples(at[:, low + 1])


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
    undecided: Bools,
) -> tuple[Ints, Samples, Samples, list[Channels], list[Bools]]:
    """The intervals that are open for some channel, cut in two or more; what is close there is put into `undecided`."""
    n = len(a)
    left = np.flatnonzero(np.any([opened.any(axis=0) for opened in is_open], axis=0))
    piece, a, b = piece[left], a.take(left), b.take(left)
    if not left.size:
        return piece, a, b, values, is_open
    # of one design as many as are looked at in the time that one takes, whoever goes with it
    crowd = np.bincount(a.of)[a.of]
    halvings = np.clip(np.log2(TOGETHER / crowd), 1, 5).astype(np.intp)
    inside, cut, lows, highs, parents = [], [], [], [], []
    begin = 2 * left.size
    for count in np.unique(halvings):
        own = np.flatnonzero(halvings == count)
        nodes = np.stack((a.A[own], b.A[own]))
        for _ in range(count):
            both = np.empty((2 * nodes.shape[0] - 1, own.size))
            middle = amid(base[piece[own]], nodes[:-1], nodes[1:])
            # next to a breakpoint rounding may put it outside
            both[::2], both[1::2] = nodes, np.clip(middle, nodes[:-1], nodes[1:])
            nodes = both
        parts = nodes.shape[0] - 1
        inside.append(nodes[1:-1].ravel())
        cut.append(np.tile(own, parts - 1))
        # where each node stands among the ends of all intervals and what is inside of them
        within = begin + np.arange((parts - 1) * own.size).reshape(parts - 1, own.size)
        begin += within.size
        place = np.concatenate((own[np.newaxis], within, left.size + own[np.newaxis]))
        # a part that begins where its interval does has the same first sample, which may be the limit above a
        # breakpoint
        lows.append(np.where(nodes[:-1] == nodes[0], own, place[:-1]).ravel())
        highs.append(place[1:].ravel())
        parents.append(np.tile(own, parts))
    of_inner = np.concatenate(cut)
    inner = samples_at(model, np.concatenate(inside), a.of[of_inner])
    ends = joined(a, b, inner)
    low, high, of = (np.concatenate(one) for one in (lows, highs, parents))
    # one without width is none
    kept = np.flatnonzero(ends.A[low] < ends.A[high])
    low, high, of = low[kept], high[kept], of[kept]
    fresh, opened = [], []
    for number, (question, answers, part) in enumerate(zip(questions, values, is_open, strict=True)):
        rows = np.zeros((*answers.rows.shape[:2], len(ends)))
        rows[..., : 2 * left.size] = answers.rows[..., np.concatenate((left, n + left))]
        # a question is asked on the intervals that are open for it
        asked = np.flatnonzero(part[:, left[of_inner]].any(axis=0))
        if asked.size:
            at = inner if asked.size == len(inner) else inner.take(asked)
            found = question.ask(at)
            undecided[number, at.of[question.is_close(at, found)]] = True
            rows[..., 2 * left.size + asked] = found.rows
        fresh.append(Channels(rows[..., np.concatenate((low, high))]))
        opened.append(part[:, left[of]])
    return piece[of], ends.take(low), ends.take(high), fresh, opened


def _solved(
    model: Model, questions: Sequence[Asked], starts: Samples, base: Floats, found: list[_Brackets], undecided: Bools
) -> list[Zeros]:
    """The zeros in the brackets, of each question by rising A."""
    if not found:
        none, numbers = np.empty(0), np.empty(0, dtype=np.intp)
        nothing = (numbers, numbers, numbers, none, none, none, np.empty(0, dtype=bool))
        return [Zeros(*nothing, unknown) for unknown in undecided]
    brackets = _Brackets(
        *(np.concatenate([getattr(one, name) for one in found], axis=-1) for name in _Brackets.__dataclass_fields__)
    )
    zeros = _solve(model, questions, starts.of[brackets.piece], base[brackets.piece], brackets)
    order = np.lexsort((zeros.A, zeros.piece, zeros.of))
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


def _solve(model: Model, questions: Sequence[Asked], of: Ints, base: Floats, brackets: _Brackets) -> Zeros:
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
        answer = _asked(questions, question[active], channel[active], samples_at(model, following, of[active]))
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
    return Zeros(of, brackets.piece, channel, A, Omega, at.level, rising, np.empty(0, dtype=bool))
