"""The response curve at one forcing: in go a model and F_0, out come every branch, and every state at a frequency.

For a given A the frequencies are the roots of a quartic. Their number changes only where the level of the peak locus or
of the static locus crosses F_0; between those amplitudes each root is an arc, continuous in A, and the folds cut an arc
into segments along which Omega is monotone too. So a segment holds at most one state at any frequency, and has one
stability.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from slowflow.averaged.reference.bounds import amplitude_bound
from slowflow.averaged.reference.folds import F_A, saddle_nodes
from slowflow.averaged.reference.roots import peak_roots, response_roots
from slowflow.averaged.reference.spans import peak_locus, spans, static_locus
from slowflow.model import Floats, Model
from slowflow.results import FrequencyResponse, SaddleNodes, SteadyStates, joined
from slowflow_kernels import slow_flow
from slowflow_kernels.conventions import SAME


@dataclass(frozen=True)
class Segment:
    """A stretch of curve monotone in A and Omega: the `index`-th root by rising Omega, for low[0] <= A <= high[0].

    low, high -- (A, Omega) at both ends; Omega is inf at A = 0
    stable    -- the same all along
    """

    index: int
    count: int
    low: tuple[float, float]
    high: tuple[float, float]
    stable: bool

    @property
    def range(self) -> tuple[float, float]:
        """Lowest and highest Omega."""
        return min(self.low[1], self.high[1]), max(self.low[1], self.high[1])


@dataclass(frozen=True)
class Skeleton:
    """All of a response curve but its points.

    curves -- each a list of (segment, upward): segments in order along the curve, and whether A rises along it
    closed -- for each curve whether it is an isola
    """

    model: Model
    F_0: float
    curves: list[list[tuple[Segment, bool]]]
    closed: list[bool]
    folds: SaddleNodes
    message: str

    @property
    def segments(self) -> list[Segment]:
        return [segment for curve in self.curves for segment, _ in curve]


def _roots(model: Model, A: Floats, F_0: float) -> tuple[Floats, np.ndarray]:
    return response_roots(A, model.averaged(A)[0], model.m, model.zeta, F_0)


def _events(model: Model, F_0: float, A_max: float) -> list[tuple[float, float]]:
    """(A, Omega) where the number of roots may change, by rising A: peaks, static states, breakpoints (Omega = nan)."""
    found = [(b, np.nan) for b in model.breakpoints if b < A_max]
    for locus in (peak_locus(model), static_locus(model)):
        found += zip(*(array.tolist() for array in spans(locus, A_max).crossings(F_0)), strict=True)
    merged: list[tuple[float, float]] = []
    for A, Omega in sorted(found, key=lambda event: event[0]):
        if merged and A - merged[-1][0] <= SAME * A:
            merged[-1] = (merged[-1][0], Omega if np.isnan(merged[-1][1]) else merged[-1][1])
        else:
            merged.append((A, Omega))
    return merged


def skeleton(model: Model, F_0: float) -> Skeleton:
    """Pieces and how they hang together, for F_0 > m."""
    A_max, remark = amplitude_bound(model, F_0)
    folds = saddle_nodes(model, F_0)
    events = _events(model, F_0, A_max)
    edges = np.array([0.0, *(A for A, _ in events), A_max])
    _, counts = _roots(model, 0.5 * (edges[:-1] + edges[1:]), F_0)

    # Which arcs meet at each event: a pair that is born or dies there, the others one to one.
    arcs = [(k, i) for k in range(counts.size) for i in range(counts[k])]
    ends: dict[tuple[int, int, bool], tuple[float, float]] = {}
    joins: dict[tuple[int, int, bool], tuple[int, int, bool]] = {}

    def join(one: tuple[int, int, bool], other: tuple[int, int, bool], at: tuple[float, float]) -> None:
        joins[one], joins[other] = other, one
        ends[one] = ends[other] = at

    for k, (A, Omega) in enumerate(events):
        left, right = int(counts[k]), int(counts[k + 1])
        at_event, n_here = _roots(model, np.array([A]), F_0)
        here = at_event[0, : n_here[0]]
        richer, poorer, upper = (k, k + 1, True) if left > right else (k + 1, k, False)
        more, fewer = max(left, right), min(left, right)
        lost: set[int] = set()
        if (more - fewer) % 2:
            lost = {0}
            ends[richer, 0, upper] = (A, 0.0)
        if more - fewer >= 2:
            # the pair meets at Omega; the roots that stay lie on either side of it
            Omega = Omega if Omega > 0 else _stationary(model, A, F_0)
            below = len(lost) + int(np.searchsorted(_without_pair(here, Omega, fewer), Omega))
            lost |= {below, below + 1}
            join((richer, below, upper), (richer, below + 1, upper), (A, Omega))
        staying = [i for i in range(more) if i not in lost]
        at_staying = here if here.size == fewer else _without_pair(here, Omega, fewer)
        for place, (i, j) in enumerate(zip(staying, range(fewer), strict=True)):
            join((richer, i, upper), (poorer, j, not upper), (A, float(at_staying[place])))
    for i in range(int(counts[0])):
        ends[0, i, False] = (0.0, np.inf)
    last = counts.size - 1
    for i in range(int(counts[last])):
        ends[last, i, True] = (A_max, float(_roots(model, np.array([A_max]), F_0)[0][0, i]))

    segments = _cut_at_folds(model, arcs, counts, ends, edges, folds)
    curves, closed = _trace(arcs, joins, segments)
    return Skeleton(model, F_0, curves, closed, folds, remark)


def _stationary(model: Model, A: float, F_0: float) -> float:
    """Omega where a pair of roots meets at A: of the points with F_Omega = 0 the one whose level is nearest to F_0.

    For an event that is a breakpoint or a state at rest, and to rounding a peak as well.
    """
    at = np.array([A])
    h = model.averaged(at)[0]
    Omega = peak_roots(at, h, model.m, model.zeta)[0][0]
    level = model.flow.level(Omega, A, model.m, model.zeta, h)
    return float(Omega[np.nanargmin(np.abs(level - F_0))])


def _without_pair(roots: Floats, Omega: float, fewer: int) -> Floats:
    """The `fewer` roots that are left when those nearest to Omega are taken away."""
    if roots.size <= fewer:
        return roots
    order = np.argsort(np.abs(roots - Omega))
    return np.sort(roots[order[roots.size - fewer :]])


def _cut_at_folds(
    model: Model,
    arcs: list[tuple[int, int]],
    counts: np.ndarray,
    ends: dict[tuple[int, int, bool], tuple[float, float]],
    edges: Floats,
    folds: SaddleNodes,
) -> dict[tuple[int, int], list[Segment]]:
    """Each arc's segments by rising A."""
    cuts: dict[tuple[int, int], list[tuple[float, float]]] = {arc: [] for arc in arcs}
    roots, n = _roots(model, folds.A, folds.F_0)
    for f in range(len(folds)):
        if folds.corner[f]:
            continue  # an arc ends at every breakpoint already
        k = int(np.searchsorted(edges, folds.A[f])) - 1
        k -= int(k > 0 and not counts[k])  # a fold at the tip of the curve may lie beyond it by rounding
        at_fold = roots[f, : n[f]]
        if not n[f]:  # what lies next to the tip tells
            at_fold = _roots(model, np.array([0.5 * (edges[k] + edges[k + 1])]), folds.F_0)[0][0, : counts[k]]
        nearest = int(np.argmin(np.abs(at_fold - folds.Omega[f])))
        cuts[k, min(nearest, int(counts[k]) - 1)].append((float(folds.A[f]), float(folds.Omega[f])))
    segments: dict[tuple[int, int], list[Segment]] = {}
    for k, i in arcs:
        corners = [ends[k, i, False], *sorted(cuts[k, i]), ends[k, i, True]]
        A = np.array([0.5 * (low[0] + high[0]) for low, high in pairwise(corners)])
        Omega, _ = _roots(model, A, folds.F_0)
        stable = F_A(model, Omega[:, i], A) > 0
        segments[k, i] = [
            Segment(i, int(counts[k]), low, high, bool(sign))
            for (low, high), sign in zip(pairwise(corners), stable, strict=True)
        ]
    return segments


def _trace(
    arcs: list[tuple[int, int]],
    joins: dict[tuple[int, int, bool], tuple[int, int, bool]],
    segments: dict[tuple[int, int], list[Segment]],
) -> tuple[list[list[tuple[Segment, bool]]], list[bool]]:
    """Curves from arcs: open ones from one loose end to the other, at the lower Omega first, then the closed ones."""
    loose = [(k, i, end) for k, i in arcs for end in (False, True) if (k, i, end) not in joins]
    # the main curve first: it is the one that reaches A = 0
    loose.sort(key=lambda end: (end[0] != 0 or end[2], end))
    visited: set[tuple[int, int]] = set()
    curves: list[list[tuple[Segment, bool]]] = []
    closed: list[bool] = []
    for start in [*loose, *((k, i, False) for k, i in arcs)]:
        if start[:2] in visited:
            continue
        curve: list[tuple[Segment, bool]] = []
        end: tuple[int, int, bool] | None = start
        while end is not None and end[:2] not in visited:
            k, i, at_high = end
            visited.add((k, i))
            upward = not at_high
            curve += [(segment, upward) for segment in (segments[k, i] if upward else segments[k, i][::-1])]
            end = joins.get((k, i, upward))
        is_closed = start not in loose
        first, final = _end(curve[0], first=True), _end(curve[-1], first=False)
        if not is_closed and first[1] > final[1]:
            curve = [(segment, not upward) for segment, upward in reversed(curve)]
        curves.append(curve)
        closed.append(is_closed)
    return curves, closed


def _end(step: tuple[Segment, bool], first: bool) -> tuple[float, float]:
    segment, upward = step
    return segment.low if upward == first else segment.high


def states_at(found: Skeleton, Omega: Floats) -> tuple[Floats, Floats, np.ndarray]:
    """Every state at each of the given frequencies: Omega, A, stable; by the order of `Omega`, then by rising A."""
    hits: list[tuple[int, Segment]] = []
    for segment in found.segments:
        low, high = segment.range
        hits += [(int(q), segment) for q in np.flatnonzero((low <= Omega) & (Omega <= high))]
    which = np.array([q for q, _ in hits], dtype=np.intp)
    A = solve_segments(found.model, found.F_0, [segment for _, segment in hits], Omega[which])
    stable = np.array([segment.stable for _, segment in hits], dtype=bool)
    order = np.lexsort((A, which))
    which, A, stable = which[order], A[order], stable[order]
    # a point where two segments meet belongs to both: it is one state, and a fold is not stable
    same = (np.diff(which) == 0) & (np.diff(A) <= SAME * A[1:])
    stable[:-1] &= stable[1:] | ~same
    keep = np.concatenate([[True], ~same]) if which.size else np.empty(0, dtype=bool)
    stable[1:] &= stable[:-1] | ~same
    return Omega[which][keep], A[keep], stable[keep]


def solve_segments(model: Model, F_0: float, segments: list[Segment], Omega: Floats) -> Floats:
    """The amplitude at which each segment has the given Omega, which must lie in its range."""
    if not segments:
        return np.empty(0)
    from scipy.optimize import elementwise

    index = np.array([segment.index for segment in segments])
    low = np.array([segment.low[0] for segment in segments])
    high = np.array([segment.high[0] for segment in segments])
    # At A = 0 Omega is infinite: the least amplitude that balances F_0 there is below F_0/(Omega^2 + ...).
    low = np.where(low == 0, np.minimum(0.5 * high, _tail_amplitude(model, F_0, Omega)), low)

    def off(A: Floats, which: np.ndarray, target: Floats) -> Floats:
        roots, count = _roots(model, A, F_0)
        i = index[which.astype(np.intp)]
        picked = np.take_along_axis(roots, np.minimum(i, 2)[:, np.newaxis], axis=-1)[:, 0]
        return np.where(i < count, picked - target, np.nan)

    # inside an event the roots that meet there are lost to rounding: the ends' values are known, not computed
    step = SAME * high
    places = np.arange(index.size)
    result = elementwise.find_root(off, (low + step, high - step), args=(places, Omega))
    at_low, at_high = (_segment_end(segments, side) for side in ("low", "high"))
    near_low = np.abs(at_low - Omega) <= np.abs(at_high - Omega)
    A = np.where(result.success, result.x, np.where(near_low, low, high))
    A = _newton_in_A(model, F_0, Omega, A)
    # an end is known better than it can be solved for: A is a square root of Omega there
    return np.asarray(np.where(at_low == Omega, low, np.where(at_high == Omega, high, A)))


def _segment_end(segments: list[Segment], side: str) -> Floats:
    return np.array([getattr(segment, side)[1] for segment in segments])


def _tail_amplitude(model: Model, F_0: float, Omega: Floats) -> Floats:
    """An amplitude below the state of the branch that comes from A = 0, Omega = inf."""
    A = np.asarray(slow_flow.tail(Omega, F_0, model.m))
    for _ in range(200):
        roots, count = _roots(model, A, F_0)
        top = np.take_along_axis(roots, np.maximum(count - 1, 0)[:, np.newaxis], axis=-1)[:, 0]
        if np.all(top > Omega):
            break
        A = np.where(top > Omega, A, 0.25 * A)
    return np.asarray(A)


def _newton_in_A(model: Model, F_0: float, Omega: Floats, A: Floats) -> Floats:
    """A last Newton step on F at fixed Omega, where F_A leaves one."""
    h, h_A, _, _ = model.averaged(A)
    F = model.flow.F(Omega, A, F_0, model.m, model.zeta, h)
    slope = model.flow.F_A(Omega, A, model.m, model.zeta, h, h_A)
    with np.errstate(divide="ignore", invalid="ignore"):
        step = F / slope
    return np.asarray(np.where(np.abs(step) < 1e-8 * A, A - step, A))


def _clipped(found: Skeleton, window: tuple[float, float]) -> list[tuple[list[tuple[Segment, bool]], bool]]:
    """The curves inside a frequency window: segments cut at its edges, a curve that leaves it split there."""
    low, high = window
    cut: list[Segment] = []
    edges: list[float] = []
    for segment in found.segments:
        for edge in window:
            if segment.range[0] < edge < segment.range[1]:
                cut.append(segment)
                edges.append(edge)
    A_cut = dict(
        zip(
            ((id(segment), edge) for segment, edge in zip(cut, edges, strict=True)),
            solve_segments(found.model, found.F_0, cut, np.array(edges)).tolist(),
            strict=True,
        )
    )

    def clip(segment: Segment) -> Segment | None:
        if segment.range[1] <= low or segment.range[0] >= high:
            return None
        ends = []
        for A, Omega in (segment.low, segment.high):
            edge = min(max(Omega, low), high)
            ends.append((A, Omega) if edge == Omega else (A_cut[id(segment), edge], edge))
        return Segment(segment.index, segment.count, ends[0], ends[1], segment.stable)

    out: list[tuple[list[tuple[Segment, bool]], bool]] = []
    for curve, closed in zip(found.curves, found.closed, strict=True):
        runs: list[list[tuple[Segment, bool]]] = [[]]
        for segment, upward in curve:
            inside = clip(segment)
            if inside is None:
                runs.append([])
                continue
            runs[-1].append((inside, upward))
            if _end((inside, upward), first=False) != _end((segment, upward), first=False):
                runs.append([])
        if closed and len(runs) > 1 and runs[0] and runs[-1]:  # the start of a closed curve is no end
            runs[0] = runs.pop() + runs[0]
        whole = len([run for run in runs if run]) == 1 and len(runs) == 1
        out += [(run, closed and whole) for run in runs if run]
    return out


def frequency_response(model: Model, F_0: float, samples: int, window: tuple[float, float]) -> FrequencyResponse:
    """About `samples` points along every branch in the window; ends, folds, peaks, corners are among them exactly."""
    found = skeleton(model, F_0)
    curves = _clipped(found, window)
    steps = [(number, segment, upward) for number, (curve, _) in enumerate(curves) for segment, upward in curve]
    weights = _weights([segment for _, segment, _ in steps])
    inner = np.ceil(samples * weights / weights.sum()).astype(int) if steps else np.empty(0, dtype=int)

    grids, indices = [], []
    for (_, segment, upward), n in zip(steps, inner, strict=True):
        grid = _inside(segment, int(n))
        grids.append(grid if upward else grid[::-1])
        indices.append(np.full(grid.size, segment.index))
    A_inner = np.concatenate(grids) if grids else np.empty(0)
    roots, _ = _roots(model, A_inner, F_0)
    index = np.concatenate(indices) if indices else np.empty(0, dtype=int)
    Omega_inner = np.take_along_axis(roots, index[:, np.newaxis], axis=-1)[:, 0] if index.size else np.empty(0)

    Omega: list[Any] = []
    A: list[Any] = []
    stable: list[Any] = []
    branch: list[Any] = []
    at = 0
    for k, ((number, segment, upward), n) in enumerate(zip(steps, inner, strict=True)):
        first, final = _end((segment, upward), True), _end((segment, upward), False)
        inside = slice(at, at + max(n - 1, 0))
        at = inside.stop
        resolved = ~np.isnan(Omega_inner[inside])
        starts = k == 0 or steps[k - 1][0] != number
        Omega += [[first[1]] if starts else [], Omega_inner[inside][resolved], [final[1]]]
        A += [[first[0]] if starts else [], A_inner[inside][resolved], [final[0]]]
        points = int(starts) + int(resolved.sum()) + 1
        stable.append(np.full(points, segment.stable))
        branch.append(np.full(points, number))
    if not steps:
        empty = np.empty(0)
        message = joined(found.message, f"no steady state for Omega in [{window[0]:g}, {window[1]:g}]")
        return FrequencyResponse(empty, empty, np.empty(0, bool), message, model, np.empty(0, np.intp), (), F_0)
    return FrequencyResponse(
        np.concatenate(Omega),
        np.concatenate(A),
        np.concatenate(stable),
        found.message,
        model,
        np.concatenate(branch),
        tuple(closed for _, closed in curves),
        F_0,
    )


def _inside(segment: Segment, n: int) -> Floats:
    """n - 1 rising amplitudes inside a segment; they crowd towards its ends, where A or Omega may stand still.

    Where it spans orders of magnitude half of them are shared out among these, as Omega changes with each; the others
    follow its top.
    """
    low, high = segment.low[0], segment.high[0]
    orders = n // 2 if low > 0 and high > 100 * low else 1
    plain = n + 1 - orders
    shares, of_orders = (0.5 - 0.5 * np.cos(np.pi * np.arange(1, count) / count) for count in (plain, max(orders, 1)))
    return np.sort(np.concatenate((low + (high - low) * shares, low * np.exp(of_orders * np.log(high / (low or 1.0))))))


def _weights(segments: list[Segment]) -> Floats:
    """Weights of segments in the sharing out of points: their extents in Omega and A, with a floor for short ones.

    A frequency and an amplitude of 1 count as much, or half the highest frequency and the highest amplitude of all.
    """
    A, Omega = (np.array([(segment.low[k], segment.high[k]) for segment in segments]).reshape(-1, 2) for k in (0, 1))
    of_Omega, of_A = np.ptp(Omega, axis=1) / max(1.0, 0.5 * Omega.max(initial=0)), np.ptp(A, axis=1) / A.max(initial=1)
    return np.asarray(of_Omega + of_A + 1e-3)


def amplitudes(model: Model, Omega: Floats, F_0: float) -> SteadyStates:
    """Every steady state at each frequency, by the order of Omega, then by rising A."""
    found = skeleton(model, F_0)
    at, A, stable = states_at(found, Omega)
    missing = np.setdiff1d(Omega, at)
    remark = "" if not missing.size else "no steady state at Omega = " + ", ".join(f"{value:g}" for value in missing)
    return SteadyStates(at, A, stable, joined(found.message, remark), model)
