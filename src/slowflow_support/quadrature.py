"""Integrals over the quarter cycle by Gauss's rule, piece by piece: integrands of a generated module in, sums out.

A piece that ends at |u| = b ends at t = asin(b/A), 0 <= t <= pi/2. Its part of the quarter is divided into 1, 2, 4, ...
equal panels until twice as many change no sum by more than `AGREED` of the integral of its size. As halving the panels
divides a rule's error by 2^12 at least, what is left then is below 2^-58 of that integral: less than rounding. Where
the force is a difference rounding changes more than that; it may change as much as some roundings of A and of the
parameters do.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from slowflow_kernels.quadrature_conventions import (
    AGREED,
    FEWEST_PANELS,
    MOST_PANELS,
    MOVED_BY,
    NEXT_TO_ZERO,
    SHORT_PART,
)
from slowflow_support.broadcast import Floats
from slowflow_support.errors import NotSettled

#: numbers that are held at a time
TOGETHER = 1 << 20

UNSETTLED = (
    "the average at A = {:.17g} does not settle: the force is all but singular there, or a difference in which its "
    "digits are lost; what lies beyond a `reach` that is stated with it is not asked for"
)

Terms = Callable[..., Sequence[Any]]

#: the same integrals in C, by the generated function that closes them: at flat arrays, the outputs along a first axis
COMPILED: dict[Callable[..., Sequence[Any]], Callable[[list[Floats]], Floats]] = {}


def over_quarter(
    A: Any,
    parameters: Sequence[Any],
    breakpoints: Callable[..., Sequence[Any]],
    terms: Sequence[Terms],
    closing: Callable[..., Sequence[Any]],
    width: int,
    graded: Sequence[int],
    rule: Sequence[tuple[float, float]],
    begins: Sequence[int] = (),
) -> tuple[Any, ...]:
    """The outputs of `closing` at A and parameters that broadcast.

    terms  -- of each piece at (u less where it begins, sine, cosine, *parameters), u = A sine: `width` integrands; then
              of each contact, which goes on from where it begins up to A
    graded -- of each of these the power of what is divided into panels that its angle, from where it begins, is
    rule   -- positive nodes on [-1, 1], which stand for their negatives too, and weights
    begins -- the number of the breakpoint at which each contact begins

    Raises ArithmeticError where a sum does not settle: the force is all but singular.
    """
    arrays = np.broadcast_arrays(*(np.asarray(one, dtype=float) for one in (A, *parameters)))
    shape, flat = arrays[0].shape, [one.reshape(-1) for one in arrays]
    if width == 0:  # slopes by parameters, of a force that has none
        return tuple(closing(*arrays))
    if closing in COMPILED:
        found = COMPILED[closing](flat)
        # what is not known in C is told here: why
        if not np.isnan(found).any():
            return tuple(found.reshape(len(found), *shape))
    at = np.array([x for node, _ in reversed(rule) for x in (-node,)] + [node for node, _ in rule])
    weights = np.array([weight for _, weight in reversed(rule)] + [weight for _, weight in rule])
    sums = np.zeros((width, flat[0].size))
    size = max(1, TOGETHER // (width * at.size * MOST_PANELS // 8))
    with np.errstate(all="ignore"):
        for first in range(0, flat[0].size, size):
            part = slice(first, first + size)
            some = [one[part] for one in flat]
            sums[:, part] = found = _sums(some, breakpoints, terms, width, graded, (at, weights), begins)
            # a slope at rest that is a quotient of zeros, as of a broken power, is what it is next to it
            lost = np.isnan(found).any(axis=0) & (some[0] == 0)
            if lost.any():
                beside = [np.full(int(lost.sum()), NEXT_TO_ZERO), *(one[lost] for one in some[1:])]
                near = _sums(beside, breakpoints, terms, width, graded, (at, weights), begins)
                sums[:, np.flatnonzero(lost) + first] = np.where(np.isnan(found[:, lost]), near, found[:, lost])
    return tuple(closing(arrays[0], *(one.reshape(shape) for one in sums), *arrays[1:]))


def _sums(
    numbers: list[Floats],
    breakpoints: Callable[..., Sequence[Any]],
    terms: Sequence[Terms],
    width: int,
    graded: Sequence[int],
    rule: tuple[Floats, Floats],
    begins: Sequence[int],
) -> Floats:
    """The sums over the pieces and the contacts, an array (width, n)."""
    A, *parameters = numbers
    total = np.zeros((width, A.size))
    ends = [np.broadcast_to(np.asarray(end, dtype=float), A.shape) for end in breakpoints(*parameters)]
    nowhere, everywhere = np.zeros(A.shape, dtype=bool), np.ones(A.shape, dtype=bool)
    low, begin = np.zeros(A.shape), np.zeros(A.shape)
    for number, piece in enumerate(terms):
        if number > 0:
            begin = ends[begins[number - len(ends) - 1] if number > len(ends) else number - 1]
        passed = A > ends[number] if number < len(ends) else nowhere
        high = np.full(A.shape, np.pi / 2)
        if number < len(ends):
            high = np.where(passed, np.arctan2(ends[number], _root(A, ends[number])), high)
        # where the cycle ends in the piece the angle is counted from there: next to the beginning it is the complement
        # of the angle that keeps its digits, and so does the cosine
        from_low = passed if number > 0 else everywhere
        spans = (
            (False, from_low, high - low),
            (True, ~from_low & (A > begin), np.arctan2(_root(A, begin), begin)),
        )
        for from_top, there, span in spans:
            wide = there & (span > 0)
            if wide.any():
                own = _Piece(piece, width, graded[number], from_top, rule)
                total[:, wide] += own.settled([one[wide] for one in numbers], low[wide], span[wide])
        low = high
    return total


def _root(A: Floats, end: Floats) -> Floats:
    """sqrt(A^2 - b^2) of a breakpoint."""
    return np.sqrt((A - end) * (A + end))


@dataclass(frozen=True)
class _Piece:
    """One piece of the force, to be integrated over low < t < low + span, or over the `span` below t = pi/2.

    terms, width, graded, rule -- as in `over_quarter`
    from_top -- whether the angle is counted downwards from pi/2
    """

    terms: Terms
    width: int
    graded: int
    from_top: bool
    rule: tuple[Floats, Floats]

    def settled(self, numbers: list[Floats], low: Floats, span: Floats) -> Floats:
        """The integrals."""
        found = np.empty((self.width, span.size))
        left, before, panels = np.arange(span.size), None, 1
        while left.size:
            if panels > MOST_PANELS:
                raise NotSettled(UNSETTLED.format(numbers[0][left[0]]))
            some, at = [one[left] for one in numbers], (low[left], span[left])
            value, sizes = self._by(panels, some, *at)
            if before is not None:
                moved = np.abs(value - before)
                # an infinite sum stays so
                apart = (moved > AGREED * sizes) & ~(span[left] <= SHORT_PART)
                if panels >= FEWEST_PANELS and apart.any():
                    moves = np.zeros_like(value)
                    for k in range(len(some)):
                        beside = [one * (1 + MOVED_BY) if k == number else one for number, one in enumerate(some)]
                        there, _ = self._by(panels, beside, *at)
                        moves += np.abs(there - value)
                    apart &= ~(moved <= moves)
                settled = ~apart.any(axis=0)
                found[:, left[settled]] = value[:, settled]
                left, value = left[~settled], value[:, ~settled]
            before, panels = value, 2 * panels
        return found

    def _by(self, panels: int, numbers: list[Floats], low: Floats, span: Floats) -> tuple[Floats, Floats]:
        """The integrals by that many panels, and those of the integrands' sizes."""
        at, weights = self.rule
        x = ((np.arange(panels)[:, np.newaxis] + 0.5 * (1 + at)) / panels).ravel()
        w = np.tile(0.5 * weights / panels, panels)
        x, w = x**self.graded, w * self.graded * x ** (self.graded - 1)
        wide, start = span[:, np.newaxis], low[:, np.newaxis]
        t = wide * (1 - x) if self.from_top else start + wide * x
        sine, cosine = (np.cos(t), np.sin(t)) if self.from_top else (np.sin(t), np.cos(t))
        A, *parameters = (one[:, np.newaxis] for one in numbers)
        # u less where the piece begins: a difference of sines
        middle = np.sin(wide * (1 - 0.5 * x)) if self.from_top else np.cos(start + 0.5 * wide * x)
        beyond = 2 * A * middle * np.sin(0.5 * wide * x)
        values = self.terms(beyond, sine, cosine, *parameters)
        weighted = [np.broadcast_to(value, sine.shape) * w for value in values]
        sums = np.array([one.sum(axis=-1) for one in weighted]) * span
        sizes = np.array([np.abs(one).sum(axis=-1) for one in weighted]) * span
        return sums.reshape(self.width, -1), sizes.reshape(self.width, -1)
