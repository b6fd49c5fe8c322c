"""Averages of forces of any kind between two amplitudes: in go intervals of A, out comes what h and h_AAAA are there.

The quarter cycle is divided at displacements, each piece of the force for itself: at fixed ones where the amplitude
exceeds the piece, at fixed shares of the last piece. The first share of a long piece is halved again and again, down to
displacements of the size of the spring: all that a force does lies there. On each part u, sine and the angle that it
takes are known on an interval of A by their values at its ends, as each is monotone in A; what stands under the
integrals is generated. A contact's are over shares of what A exceeds its begin by, whose weight is known.
"""

from __future__ import annotations

import numpy as np

from slowflow.averaged.defined import interval_like
from slowflow.intervals import Elementary, Interval
from slowflow.model import Floats, Model
from slowflow_kernels.quadrature_conventions import ANGLE, CONTACT_SUMS, HALVED, LARGEST_SUM, PARTS

#: shares of a piece at which it is divided: of equal angles where it begins at u = 0
_SHARES = np.sin(np.linspace(0.0, 0.5 * np.pi, PARTS + 1))
_SHARES[-1] = 1.0


def enclosed(model: Model, low: Floats, high: Floats) -> tuple[Interval, Interval]:
    """h and h_AAAA on intervals of A, arrays (n,), each on one piece of the force; infinite or NaN where not known."""
    n = low.size
    h, bend = np.full((2, n), np.nan), np.full((2, n), np.nan)
    ends = np.array([float(end) for end in model.mechanism.breakpoints(*model.parameters)])
    passed = np.sum(low >= ends[:, np.newaxis], axis=0)
    with np.errstate(all="ignore"):
        for count in np.unique(passed):
            here = passed == count
            h[:, here], bend[:, here] = _enclosed(model, ends[:count], low[here], high[here])
    return Interval(h), Interval(bend)


def _enclosed(model: Model, ends: Floats, low: Floats, high: Floats) -> tuple[Floats, Floats]:
    """The same where the amplitudes exceed these breakpoints."""
    record = model.mechanism.enclosed
    assert record is not None
    given = [Elementary.point(value) for value in model.parameters]
    sums = [Interval(np.zeros((2, low.size))) for _ in range(2)]
    starts = np.concatenate(([0.0], ends))
    for number, start in enumerate(starts):
        last = number == len(ends)
        if last:
            shares = _shares(np.max(high) - start)
            beyond, sine, angle = _last_piece(shares, start, low, high)
        elif ends[number] > start:
            shares = _shares(ends[number] - start)
            beyond, sine, angle = _passed_piece(shares, start, ends[number], low, high)
        else:
            continue
        parts_of = shares.size - 1
        amplitudes = Elementary.of(np.tile(low, parts_of), np.tile(high, parts_of))
        values = record.terms[number](Elementary.point, amplitudes, beyond, sine, *given)
        for k, value in enumerate(values):
            parts = interval_like(value, angle) * angle
            added = sums[k] + Interval(parts.ends.reshape(2, parts_of, -1).sum(axis=1))
            # a sum that is too large for a double is at least this large
            sums[k] = Interval(np.clip(added.ends, [[-np.inf], [-LARGEST_SUM]], [[LARGEST_SUM], [np.inf]]))
    for contact, begin in zip(record.contacts, record.begins, strict=True):
        if begin < len(ends):
            shares = _shares(np.max(high) - ends[begin])
            parts_of = shares.size - 1
            amplitudes = Elementary.of(np.tile(low, parts_of), np.tile(high, parts_of))
            over = np.ones(low.size)
            share = _parts(shares[:-1, np.newaxis] * over, np.minimum(shares[1:, np.newaxis] * over, 1.0))
            wide = -np.diff(2 * np.sqrt(1 - shares))[:, np.newaxis] * over
            weight = _widths(wide, wide)
            for value in contact(Elementary.point, amplitudes, share, *given):
                parts = interval_like(value, weight) * weight
                sums.append(Interval(parts.ends.reshape(2, parts_of, -1).sum(axis=1)))
        else:
            sums += [Interval(np.zeros((2, low.size)))] * CONTACT_SUMS
    roots = [_root(end, low, high) for end in ends]
    A = Elementary.of(low, high)
    h, bend = record.closing[len(ends)](Elementary.point, A, *roots, *sums, *given)
    return interval_like(h, A).ends, interval_like(bend, A).ends


def _shares(length: float) -> Floats:
    """Of a piece of that length."""
    halved = int(np.clip(np.ceil(np.log2(length)), 0, HALVED)) if length > 0 else 0
    return np.concatenate(([0.0], _SHARES[1] * 0.5 ** np.arange(halved, 0, -1), _SHARES[1:]))


def _root(end: float, low: Floats, high: Floats) -> Elementary:
    """sqrt(A^2 - b^2)"""
    A = Interval.of(low, high)
    return Elementary(((A - float(end)) * (A + float(end))).ends).root()


def _angles(sines: Floats) -> Floats:
    return np.asarray(np.arcsin(np.minimum(sines, 1.0)))


def _parts(lower: Floats, upper: Floats) -> Elementary:
    """Flat intervals, part by part."""
    wider = Elementary.of(lower.ravel(), upper.ravel()).ends
    return Elementary(wider + np.array([[-ANGLE], [ANGLE]]) * np.abs(wider))


def _passed_piece(
    shares: Floats, start: float, end: float, low: Floats, high: Floats
) -> tuple[Elementary, Elementary, Interval]:
    """u less its begin, sine and angles on the parts of a piece that the amplitude exceeds: angles fall as it rises."""
    beyond = ((end - start) * shares)[:, np.newaxis]
    at = start + beyond
    at[-1] = end
    whole = np.ones(low.size)
    lowest, highest = _angles(at / high), _angles(at / low)
    return (
        _parts(beyond[:-1] * whole, beyond[1:] * whole),
        _parts(at[:-1] / high, np.minimum(at[1:] / low, 1.0)),
        _widths(np.diff(lowest, axis=0), np.diff(highest, axis=0)),
    )


def _last_piece(shares: Floats, start: float, low: Floats, high: Floats) -> tuple[Elementary, Elementary, Interval]:
    """The same on the piece that the amplitude ends in: there the angles rise with it."""
    share = shares[:, np.newaxis]

    def sines(A: Floats) -> Floats:
        return np.asarray(np.where(A > 0, share + (1 - share) * start / A, share))

    from_low, from_high = sines(low), sines(high)
    return (
        _parts(((low - start) * share)[:-1], ((high - start) * share)[1:]),
        _parts(from_high[:-1], np.minimum(from_low[1:], 1.0)),
        _widths(np.diff(_angles(from_low), axis=0), np.diff(_angles(from_high), axis=0)),
    )


def _widths(one: Floats, other: Floats) -> Interval:
    """Angles between two values, which are differences of others."""
    least, most = np.minimum(one, other) - ANGLE, np.maximum(one, other) + ANGLE
    return Interval.of(np.maximum(least, 0.0).ravel(), most.ravel())
