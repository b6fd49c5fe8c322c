"""The response curve of offset motions. Takes cells of the balance, all folds and states at a few frequencies.

Along the balance of the mean, whatever way it goes, frequencies of states are explicit in A and h: roots of F, three at
most. So the response is traced along the balance: roots of one number are on one arc as long as there are as many;
where two are lost they meet, as at the peak of a resonance.

What may be lost between two points of the balance is missed by what is proved: a curve turns back at folds only, passes
a frequency between two folds at states that are known there, and ends at those at the ends of the window. Where a curve
contradicts this cells are cut.
"""

from __future__ import annotations

from itertools import combinations
from typing import NamedTuple

import numpy as np

from slowflow.core.mechanism import Flags, Ints
from slowflow.core.model import Floats
from slowflow.off_centre.flow import Slow
from slowflow.off_centre.means import BALANCED
from slowflow.off_centre.solution_sheets import Cells, Sheets, walks
from slowflow.support.errors import NotSettled
from slowflow.support.text import Sentence

#: how often cells are cut on which the mean may turn back, and all of them
CUTS = 3
#: steps of Newton's method to a peak
STEPS = 8
#: by how much a frequency differs, beside the largest one, from what A and B of its state leave of it
ROUNDED = 2.0**-20

UNRESOLVED = Sentence(
    "the response is unresolved between {Omega} = {Omega[0]:.6g} and {Omega[1]:.6g}: which states are on one curve is "
    "undecided"
)


class Curve(NamedTuple):
    """Omega, A and B in order along a curve, (3, n), and whether it is closed.

    is_fold, is_kept -- which points are folds; which are these, peaks or ends
    """

    place: Floats
    closed: bool
    is_fold: Flags = np.empty(0, dtype=bool)
    is_kept: Flags = np.empty(0, dtype=bool)


class _Line(NamedTuple):
    """Points in order along the balance, with a row of NaN before and behind each connected part of it.

    x       -- A and B, (2, n)
    Omega   -- of states there, by rising frequency, (n, k), with NaN behind these
    is_fold -- which of these are folds
    """

    x: Floats
    Omega: Floats
    is_fold: Flags


@np.errstate(all="ignore")  # next to jumps slopes have no bound, and there are fewer frequencies than places for them
def curves(
    of: Slow, sheets: Sheets, cells: Cells, folds: Floats, states: Floats, window: tuple[float, float], points: int
) -> list[Curve]:
    """All curves in a window of frequencies.

    cells  -- of the balance, all on which there may be states
    folds  -- Omega, A, B of every fold in the window, (3, k)
    states -- of every state at both ends of the window and at a frequency between any two folds
    points -- about how many there are to be

    Raises ArithmeticError where it is not decided which states are on one curve.
    """
    if not (folds.size or states.size):
        return []
    for _ in range(CUTS):
        if not (turns := (cells.rising.lo <= 0) & (cells.rising.hi >= 0)).any():
            break
        cells = Cells.joined([cells.take(~turns), sheets.cut(cells.take(turns))])
    doubt: tuple[float, float] | None = window
    for _ in range(CUTS):
        if (line := _line(of, sheets, cells, folds, states)) is not None:
            found = _traced(of, line, window)
            if (doubt := _doubt(found, states, window)) is None:
                return _drawn(of, found, points)
        cells = sheets.cut(cells)
    raise NotSettled(UNRESOLVED.format(doubt))


def _line(of: Slow, sheets: Sheets, cells: Cells, folds: Floats, states: Floats) -> _Line | None:
    """A point of the balance in each cell, all folds and states, in order; None where cells do not tell the order."""
    if (ranks := sheets.ranks(cells)) is None:
        return None
    (rank, side), known = ranks, np.concatenate((folds, states), axis=1)
    middles, own = of.steps.balanced(sheets.middles(cells))
    # not where a cell holds none of the balance, or the mean stiffness has no sign
    own &= (side != 0) & (sheets.apart(cells, middles) <= BALANCED * middles[0])
    x, cells, rank, side = np.concatenate((middles[:, own], known[1:]), 1), cells.take(own), rank[:, own], side[own]
    signs = np.sign(of.steps.at(known[1], known[2], 1).c[1])
    apart = np.where(side == signs[:, np.newaxis], sheets.apart(cells, known[1:, :, np.newaxis]), np.inf)
    rank, side = np.append(rank, rank[:, np.argmin(apart, axis=1)], axis=1), np.append(side, signs)
    h = -2 * of.steps.at(x[0], x[1], 0).s[0]
    Omega = np.sort(of.flow.frequencies(x[0], h, of.F_0), axis=1)
    Omega = np.append(Omega, np.full((len(Omega), 1), np.nan), axis=1)
    is_fold, size = np.zeros(Omega.shape, dtype=bool), known[0].max(initial=0.0)
    for k, at in enumerate(known[0].tolist(), start=len(Omega) - known.shape[1]):
        row = Omega[k]
        near = np.abs(row - at)
        # of a state its frequency has more digits; at Omega = 0 there may be no root
        row[int(np.nanargmin(near)) if np.nanmin(near, initial=np.inf) <= ROUNDED * size else -1] = at
        row.sort()
        is_fold[k] = (row == at) & (k < len(Omega) - states.shape[1])
    order = np.lexsort((side * x[0], rank[1], rank[0]))
    part = rank[0, order]
    ends = np.flatnonzero(np.append(True, np.append(part[1:] != part[:-1], True)))
    apart, roots = np.insert(x[:, order], ends, np.nan, axis=1), np.insert(Omega[order], ends, np.nan, axis=0)
    return _Line(apart, roots, np.insert(is_fold[order], ends, False, axis=0))


def _traced(of: Slow, line: _Line, window: tuple[float, float]) -> list[Curve]:
    """Every curve, open ones first, from its lowest frequency on."""
    columns, count = line.Omega.shape[1], np.isfinite(line.Omega).sum(axis=1)
    place = np.stack(np.broadcast_arrays(line.Omega, *line.x[..., np.newaxis])).reshape(3, -1)
    step = np.diff(count)
    links = [
        (columns * row + j, columns * (row + 1) + j) for row in np.flatnonzero(step == 0) for j in range(count[row])
    ]
    pairs: list[tuple[int, int]] = []
    for row in np.flatnonzero(step):
        rich, poor = (row, row + 1) if step[row] < 0 else (row + 1, row)
        kept, pair = _meeting(line.Omega[rich, : count[rich]], line.Omega[poor, : count[poor]])
        links += [(columns * rich + j, columns * poor + i) for i, j in enumerate(kept)]
        pairs += [(columns * rich + j, columns * rich + j + 1) for j in pair]
    if pairs:
        ends = place[:, np.array(pairs).T]
        tops = _peaks(of, ends[1:, 0], ends[0].mean(axis=0))
        there = (tops[0] >= ends[0, 0]) & (tops[0] <= ends[0, 1])
        number = place.shape[1] + np.cumsum(there) - 1
        for (a, b), top, is_there in zip(pairs, number.tolist(), there.tolist(), strict=True):
            links += [(a, top), (top, b)] if is_there else [(a, b)]
        place = np.concatenate((place, tops[:, there]), axis=1)
    is_fold = np.append(line.is_fold, np.zeros(place.shape[1] - line.is_fold.size, dtype=bool))
    is_kept = is_fold | np.isin(place[0], window)
    is_kept[line.is_fold.size :] = True
    nodes = set(np.flatnonzero((place[0] >= window[0]) & (place[0] <= window[1])).tolist())
    found = []
    for tour, closed in walks(sorted(nodes), [link for link in links if nodes.issuperset(link)]):
        lowest = int(np.argmin(place[0, tour]))
        if closed:
            tour = tour[lowest:-1] + tour[: lowest + 1]
        elif tuple(place[:, tour[0]]) > tuple(place[:, tour[-1]]):
            tour = tour[::-1]
        found.append(Curve(place[:, tour], closed, is_fold[tour], is_kept[tour]))
    return sorted(found, key=lambda curve: (curve.closed, *curve.place[:, 0]))


def _meeting(rich: Floats, poor: Floats) -> tuple[list[int], list[int]]:
    """Which of some roots go on as some fewer ones, and the lower one of a pair that meets, if there is one."""
    lost, ways = rich.size - poor.size, []
    for gone in combinations(range(rich.size), lost):
        # neighbours meet; one by itself is the lowest or the highest, and goes to Omega = 0 or infinity
        pairs = sorted((j for j in gone if j + 1 in gone), key=lambda j: rich[j + 1] - rich[j])
        if pairs or lost == 0 or (lost == 1 and gone[0] in (0, rich.size - 1)):
            kept = [j for j in range(rich.size) if j not in gone]
            ways.append((float(np.abs(rich[kept] - poor).sum()), kept, pairs[:1]))
    _, kept, pair = min(ways)
    return kept, pair


def _peaks(of: Slow, x: Floats, Omega: Floats) -> Floats:
    """Omega, A, B where two frequencies meet, from points near by; NaN where Newton's method does not come there."""
    for _ in range(STEPS):
        means = of.steps.at(x[0], x[1], 1)
        found = of.flow.stationary(x[0], -2 * means.s[0])
        nearest = np.argmin(np.nan_to_num(np.abs(found - Omega[:, np.newaxis]), nan=np.inf), axis=1)
        Omega = found[np.arange(Omega.size), nearest]
        change = of.step(of.state(Omega, x, means))
        x = x - change
        if (np.abs(change) <= BALANCED * x[0]).all():
            break
    there = (np.abs(change) <= BALANCED * x[0]).all(axis=0)
    return np.where(there, np.stack((Omega, *x)), np.nan)


def _doubt(found: list[Curve], states: Floats, window: tuple[float, float]) -> tuple[float, float] | None:
    """Between which frequencies a curve contradicts what is known, None where none does."""
    known = np.unique(states[0])
    for place, closed, is_fold, _ in found:
        Omega = np.append(place[0], place[0, 1:2] if closed else place[0, -1:])
        step, (low, high) = np.diff(Omega), np.sort(np.stack((Omega[1:], Omega[:-1])), axis=0)
        # it passes a frequency where there is no state
        wrong = np.searchsorted(known, low, side="right") < np.searchsorted(known, high, side="left")
        # it turns back elsewhere than at a fold, or goes on there
        is_clear = np.minimum(np.abs(step[1:]), np.abs(step[:-1])) > ROUNDED**2 * Omega[1:-1]
        wrong[1:] |= is_clear & ((step[1:] * step[:-1] < 0) != is_fold[1 : Omega.size - 1])
        # it ends within the window
        if not closed:
            wrong[[0, -1]] |= ~np.isin(Omega[[0, -1]], window)
        if wrong.any():
            return float(low[k := int(np.argmax(wrong))]), float(high[k])
    return None


def _drawn(of: Slow, found: list[Curve], points: int) -> list[Curve]:
    """Curves with about so many points in all."""
    density = points / (sum(float(_lengths(curve).sum()) for curve in found) or 1.0)
    drawn = []
    for curve in found:
        # where points of the balance are far apart, between them: towards both ends, where it or Omega may stand still
        inner = np.ceil(density * _lengths(curve)).astype(int) - 1
        step = np.repeat(np.arange(inner.size), inner)
        part = np.arange(1, step.size + 1) - np.repeat(np.cumsum(inner) - inner, inner)
        curve = _with(of, curve, step, 0.5 - 0.5 * np.cos(np.pi * part / (inner[step] + 1)), kept=False)
        # then as far apart as they are to be
        length = np.append(0.0, np.cumsum(_lengths(curve)))
        at = np.arange(0.5, length[-1] * density) / density
        step = np.searchsorted(length, at, side="right") - 1
        curve = _with(of, curve, step, (at - length[step]) / np.diff(length)[step], kept=True)
        drawn.append(Curve(curve.place[:, curve.is_kept], curve.closed))
    return drawn


def _lengths(curve: Curve) -> Floats:
    """How long each step along a curve is drawn: a frequency, an amplitude and a mean of 1 count as much."""
    return np.asarray(np.abs(np.diff(curve.place, axis=1)).sum(axis=0) + 1e-6)


def _with(of: Slow, curve: Curve, step: Ints, fraction: Floats, kept: bool) -> Curve:
    """With points between others, by number of the step and how far that is gone, where these are told apart."""
    place, is_kept = curve.place, curve.is_kept
    start, end = place[:, step], place[:, step + 1]
    x, own = of.steps.balanced(start[1:] + (end[1:] - start[1:]) * fraction)
    low, high = np.sort(np.stack((start[0], end[0])), axis=0)
    Omega = of.flow.frequencies(x[0], -2 * of.steps.at(x[0], x[1], 0).s[0], of.F_0)
    between = (Omega >= low[:, np.newaxis]) & (Omega <= high[:, np.newaxis])
    own &= between.sum(axis=1) == 1
    new = np.stack((np.where(between, Omega, 0.0).sum(axis=1), *x))[:, own]
    order = np.argsort(np.append(np.arange(is_kept.size), (step + fraction)[own]), kind="stable")
    is_kept = np.append(is_kept, np.full(new.shape[1], kept))[order]
    return Curve(np.concatenate((place, new), axis=1)[:, order], curve.closed, is_kept=is_kept)
