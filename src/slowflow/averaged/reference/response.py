"""The response curve at one forcing: in go a model and F_0, out come every branch, and every state at a frequency.

For a given A the frequencies are the roots of a quartic. Their number changes only at peaks and at static states;
between those amplitudes each root is an arc, continuous in A, and the folds cut an arc into segments along which Omega
is monotone too. So a segment holds at most one state at any frequency, and has one stability. As in native/curve.h.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np

from slowflow.answer import joined
from slowflow.averaged import words
from slowflow.averaged.reference import dissipated, dissipated_points, doubt, inertia
from slowflow.averaged.reference.along import Asked, InertiaPeak, Peak, Rest
from slowflow.averaged.reference.arcs import Along, Event, Graph, Kind, Roots, merged
from slowflow.averaged.reference.bounds import amplitude_bound
from slowflow.averaged.reference.cells import amid, stretches_up_to
from slowflow.averaged.reference.folds import folds_up_to
from slowflow.averaged.reference.roots import Ints, Quartics
from slowflow.averaged.reference.search import find_zeros
from slowflow.intervals import Bools
from slowflow.model import Floats, Model
from slowflow.results import FrequencyResponse, Remark, SaddleNodes, SteadyStates
from slowflow_kernels import dissipation, frequencies, slow_flow
from slowflow_kernels.conventions import AT_ROOT, COINCIDE, HARDLY, LAST_STEP, SAME, SLOW, SPREAD
from slowflow_support.errors import NotSettled

#: A Omega^2 beside F_0 from which on rounding leaves nothing of R, as SF_SHARP in native/settle.h
SHARP = 2.0**25


@dataclass(frozen=True)
class Segment:
    """A stretch of curve monotone in A and Omega: root `index` of `count` by rising Omega, for low[0] <= A <= high[0].

    low, high -- (A, Omega) at both ends; Omega is inf at A = 0
    stable    -- the same all along
    """

    index: int
    count: int
    low: tuple[float, float]
    high: tuple[float, float]
    stable: bool = False

    @property
    def range(self) -> tuple[float, float]:
        """Lowest and highest Omega."""
        return min(self.low[1], self.high[1]), max(self.low[1], self.high[1])


@dataclass(frozen=True)
class Skeleton:
    """All of a response curve but its points.

    curves -- each a list of (segment, upward): segments in order along the curve, and whether A rises along it
    closed -- for each curve whether it is an isola
    undecided -- whether doubles leave open how many states or folds there are
    """

    roots: Along
    folds: SaddleNodes
    curves: list[list[tuple[Segment, bool]]]
    closed: list[bool]
    undecided: bool
    message: str

    @property
    def remarks(self) -> Remark:
        """Of a curve."""
        return words.beside(self.undecided, self.message)

    @property
    def segments(self) -> list[Segment]:
        return [segment for curve in self.curves for segment, _ in curve]


@lru_cache(maxsize=16)
@np.errstate(all="ignore")
def skeleton(model: Model, F_0: float, lowest: float = 0.0) -> Skeleton:
    """Segments and how they hang together, for F_0 > m; kept, as states at one frequency after another ask for it.

    lowest -- as in `amplitude_bound`
    """
    A_max, remark = amplitude_bound(model, F_0, lowest)
    roots = _along(model, F_0)
    folds = folds_up_to(model, F_0, A_max, remark)
    try:
        events, undecided = _events(model, F_0, A_max)
        graph = Graph.of(roots, events)
    except ArithmeticError as failure:
        raise NotSettled(words.unresolved(model, F_0)) from failure
    on_arc = _arcs_of_folds(roots, graph, folds)
    curves = []
    for tour in graph.tours:
        curve: list[tuple[Segment, bool]] = []
        for number, upward in tour.steps:
            arc = graph.arcs[number]
            corners = [(arc.A[0], arc.Omega[0]), *sorted(on_arc.get(number, [])), (arc.A[1], arc.Omega[1])]
            parts = [Segment(arc.index, arc.count, low, high) for low, high in pairwise(corners)]
            curve += [(part, upward) for part in (parts if upward else parts[::-1])]
        curves.append(curve)
    undecided |= Remark.UNDECIDED in folds.remarks
    closed = [tour.closed for tour in graph.tours]
    return Skeleton(roots, folds, _with_stability(roots, curves), closed, undecided, remark)


def _along(model: Model, F_0: float) -> Along:
    """The frequencies along the amplitude."""
    if model.laws.any:
        return dissipated.Roots(model, F_0)
    return inertia.Roots(model, F_0) if model.inertial else Roots(model, F_0)


def _peaks_and_rest(model: Model, F_0: Any) -> list[Asked]:
    return [Peak(model, F_0), Rest(model, F_0)]


def _events(model: Model, F_0: float, A_max: float) -> tuple[list[Event], bool]:
    """Where the number of roots may change, by rising A: peaks, static states, breakpoints.

    And whether doubles leave some open.
    """
    if model.laws.any:
        return dissipated_points.response_events(model, F_0, A_max)
    if model.inertial:
        return _events_of_inertia(model, F_0, A_max)
    pieces = stretches_up_to(model, A_max)
    peaks, static = find_zeros(model, _peaks_and_rest(model, F_0), pieces)
    # where F is biquadratic in Omega with a minimum inside, it is a second root that comes from Omega = 0
    with np.errstate(all="ignore"):
        (w1, _), _ = (at_rest := Quartics(static.A, *model.averaged(static.A)[:2], model.m, model.zeta, F_0)).critical
        second = at_rest.exist & (w1 == 0)
    found = [Event(0.0, np.inf, Kind.CUT)]
    for number, piece in enumerate(pieces):
        inside = []
        for i in np.flatnonzero(peaks.piece == number):
            up, low = (1 if peaks.rising[i] else -1), peaks.channel[i] == 0
            kind, gain = (Kind.PAIR_LOW, 2 * up) if low else (Kind.PAIR_HIGH, -2 * up)
            inside.append(Event(float(peaks.A[i]), float(peaks.Omega[i]), kind, gain))
        for i in np.flatnonzero(static.piece == number):
            # h^2 rises with h - c, and falls as h + c rises
            up = 1 if static.rising[i] else -1
            gain = up if bool(second[i]) == (static.channel[i] == 0) else -up
            inside.append(Event(float(static.A[i]), 0.0, Kind.TO_ZERO, gain))
        found += sorted(inside, key=lambda event: event.A)
        if number + 1 < len(pieces):
            found.append(Event(float(piece.last.A[0]), 0.0, Kind.THROUGH))
    close = _are_close(peaks.A) or _are_close(static.A)
    undecided = bool(peaks.undecided.any() or static.undecided.any() or close)
    return merged([*found, Event(A_max, 0.0, Kind.CUT)]), undecided


def _are_close(A: Floats) -> bool:
    """Whether two of them lie so close that between them there may be no double.

    What lies there, as a whole curve where h passes through 0 by steps larger than F_0, is lost then.
    """
    rising = np.sort(A)
    return bool((np.diff(rising) <= COINCIDE * rising[1:]).any())


def _events_of_inertia(model: Model, F_0: float, A_max: float) -> tuple[list[Event], bool]:
    """The same for an excitation by inertia: peaks, breakpoints, and A = F_0, where a frequency comes from inf."""
    pieces, at = stretches_up_to(model, A_max), np.array([F_0])
    (peaks,) = find_zeros(model, [InertiaPeak(model, F_0)], pieces)
    falls = bool(inertia.falls_to_least(model, at, model.averaged(at)[0])[0][0])
    inside = [Event(F_0, np.inf, Kind.TO_INFINITY, 1 if falls else -1)]
    # no level of an amplitude is above it: a peak is below F_0 by rounding alone
    A_at = np.maximum(peaks.A, F_0)
    for A, Omega, rising in zip(A_at.tolist(), peaks.Omega.tolist(), peaks.rising.tolist(), strict=True):
        inside.append(Event(A, Omega, Kind.PAIR_HIGH, -2 if rising else 2))
    inside += [Event(float(piece.last.A[0]), 0.0, Kind.THROUGH) for piece in pieces[:-1]]
    inside.sort(key=lambda event: event.A)
    start = inertia.Roots(model, F_0).start()
    return [Event(0.0, start, Kind.CUT), *inside, Event(A_max, 0.0, Kind.CUT)], bool(peaks.undecided.any())


@np.errstate(all="ignore")
def are_events_undecided(model: Model, F_0: float) -> bool:
    """Whether doubles leave open which peaks and static states a response curve has; of a force."""
    try:
        return _events(model, F_0, amplitude_bound(model, F_0)[0])[1]
    except ArithmeticError:
        return True


def _arcs_of_folds(roots: Along, graph: Graph, folds: SaddleNodes) -> dict[int, list[tuple[float, float]]]:
    """The folds (A, Omega) on each arc: of those that reach a fold's amplitude the one that is nearest."""
    pairs = [
        (f, number)
        for f in np.flatnonzero(~folds.corner)  # an arc ends at every breakpoint already
        for number, arc in enumerate(graph.arcs)
        if arc.A[0] <= folds.A[f] <= arc.A[1]
    ]
    if not pairs:
        return {}
    of, numbers = (np.array(column, dtype=np.intp) for column in zip(*pairs, strict=True))
    count, index = (np.array([getattr(graph.arcs[n], name) for n in numbers]) for name in ("count", "index"))
    off = np.abs(roots.at(folds.A[of], count, index) - folds.Omega[of])
    found: dict[int, list[tuple[float, float]]] = {}
    for f in np.unique(of):
        own = np.flatnonzero(of == f)
        found.setdefault(int(numbers[own[np.argmin(off[own])]]), []).append((float(folds.A[f]), float(folds.Omega[f])))
    return found


def _with_stability(roots: Along, curves: list[list[tuple[Segment, bool]]]) -> list[list[tuple[Segment, bool]]]:
    """The same with each segment's stability: a state is stable where F_A is positive (30)."""
    segments = [segment for curve in curves for segment, _ in curve]
    if not segments:
        return curves
    stable = iter(_are_stable(roots, segments).tolist())
    return [[(replace(segment, stable=next(stable)), upward) for segment, upward in curve] for curve in curves]


def _are_stable(own: Along, segments: Sequence[Segment]) -> Bools:
    """Which segments are stable."""
    count, index = _numbers(segments)
    A = np.array([0.5 * (segment.low[0] + segment.high[0]) for segment in segments])
    Omega = own.at(A, count, index)
    rises = np.asarray(own.model.F_A(Omega, A))
    if not (own.model.inertial or own.model.laws.any):
        sharp = np.flatnonzero(A * Omega**2 > SHARP * own.F_0)
        rises[sharp] = _rise_where_sharp(own.take(sharp), A[sharp], Omega[sharp], count[sharp], index[sharp])
    return rises > 0


def _rise_where_sharp(roots: Along, A: Floats, Omega: Floats, count: Any, index: Any) -> Floats:
    """F_A/2 where rounding of A Omega^2 leaves nothing of R.

    F has R up to its sign, which is that of F_Omega there: F rises at the last root.
    """
    model, F_0 = roots.model, roots.F_0
    I = slow_flow.I(Omega, A, model.m, model.zeta)
    R = np.sqrt(np.maximum(0.0, (F_0 - I) * (F_0 + I))) * np.where((count - index) % 2 == 1, 1.0, -1.0)
    R_A, I_A = model.averaged(A)[1] + Omega**2, dissipation.I_A(Omega, A, 0.0, model.zeta, 0.0)
    return np.asarray(dissipation.F_A_halved(R, R_A, I, I_A))


def _numbers(segments: Sequence[Segment]) -> tuple[Any, Any]:
    """Of how many roots each segment has which."""
    return np.array([segment.count for segment in segments]), np.array([segment.index for segment in segments])


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
    A = solve_segments(found.roots, [segment for _, segment in hits], Omega[which])
    stable = np.array([segment.stable for _, segment in hits], dtype=bool)
    is_end = np.array([Omega[q] in segment.range for q, segment in hits], dtype=bool)
    order = np.lexsort((A, which))
    which, A, stable, is_end = which[order], A[order], stable[order], is_end[order]
    # a point where two segments meet belongs to both: it is one state, and a fold is not stable; inside segments two
    # are two, even where their amplitudes are the same double
    same = (np.diff(which) == 0) & (np.diff(A) <= SAME * A[1:]) & (is_end[1:] | is_end[:-1])
    stable[:-1] &= stable[1:] | ~same
    keep = np.concatenate([[True], ~same]) if which.size else np.empty(0, dtype=bool)
    stable[1:] &= stable[:-1] | ~same
    keep &= A > 0  # where the response begins the mass is at rest
    which, A, stable = which[keep], A[keep], stable[keep]
    _order_same(which, A, stable)
    return Omega[which], A, stable


def _order_same(which: Any, A: Floats, stable: Any) -> None:
    """Of two states that rounding does not tell apart the lower one is stable if the next below is not.

    F crosses 0 upward and downward in turn along the amplitude, beginning below 0.
    """
    same = (np.diff(which) == 0) & (np.diff(A) <= SAME * A[1:]) & (stable[1:] != stable[:-1])
    for i in np.flatnonzero(same):
        lowest = i == 0 or which[i - 1] != which[i]
        stable[i] = lowest or not stable[i - 1]
        stable[i + 1] = not stable[i]


@np.errstate(all="ignore")
def solve_segments(roots: Along, segments: Sequence[Segment], Omega: Floats, of: Ints | None = None) -> Floats:
    """The amplitude at which each segment has the given Omega, which must lie in its range: Newton, bracketed.

    of -- of which of the designs abreast they are, if there are several
    """
    if not len(segments):
        return np.empty(0)
    of = np.zeros(len(segments), np.intp) if of is None else of
    count, index = _numbers(segments)
    (low, at_low), (high, at_high) = (
        np.array([getattr(segment, side) for segment in segments]).T for side in ("low", "high")
    )
    falls, tail = at_low > at_high, (low == 0) & np.isinf(at_low)
    lo, hi = low.copy(), high.copy()
    lo[tail] = _tail_amplitudes(roots.take(of[tail]), high[tail], count[tail], index[tail], Omega[tail])
    A = np.where(tail, lo, lo + (hi - lo) * ((Omega - at_low) / (at_high - at_low)))
    last, x = hi - lo, A.copy()
    active = np.flatnonzero((Omega != at_low) & (Omega != at_high))
    for _ in range(200):
        below, above, at = lo[active], hi[active], A[active]
        inside = (at > below) & (at < above)
        if not inside.all():
            at = np.where(inside, at, amid(np.zeros(1), below, above))
        own = roots.take(of[active])
        w = own.at(at, count[active], index[active])
        left = (w > Omega[active]) == falls[active]
        below, above = np.where(left, at, below), np.where(left, above, at)
        following = at - (w - Omega[active]) / own.model.Omega_A(w, at)
        moved = np.abs(following - at)
        x[active], lo[active], hi[active] = at, below, above
        done = (moved <= AT_ROOT * at) | ~(below < above)
        outside = ~((following > below) & (following < above)) | (moved > SLOW * last[active])
        if outside.any():
            following = np.where(outside, amid(np.zeros(1), below, above), following)
            done |= outside & ~((following > below) & (following < above))
        last[active], A[active] = np.abs(following - at), following
        active = active[~done]
        if not active.size:
            break
    x = np.clip(_polished(roots.take(of), Omega, x), low, high)
    # an end is known better than it can be solved for: A is a square root of Omega there
    return np.where(at_low == Omega, low, np.where(at_high == Omega, high, x))


def _tail_amplitudes(roots: Along, high: Floats, count: Any, index: Any, Omega: Floats) -> Floats:
    """An amplitude below the state of the branch that comes from A = 0, Omega = inf."""
    A = np.minimum(slow_flow.tail(Omega, roots.F_0, roots.model.m), 0.5 * high)
    for _ in range(500 if A.size else 0):
        beyond = roots.at(A, count, index) > Omega
        if beyond.all():
            break
        A = np.where(beyond, A, 0.25 * A)
    return np.asarray(A)


def _polished(roots: Along, Omega: Floats, A: Floats) -> Floats:
    """A last Newton step on F at fixed Omega, where F_A leaves one; the residual is in double-double."""
    model = roots.model
    force, h = model.force(roots.F_0, Omega), model.averaged(A)[0]
    residual, _ = frequencies.response_fine(Omega, A, force, *model.alike(Omega, A), h)[:2]
    step = residual / model.F_A(Omega, A)
    return np.asarray(np.where(np.abs(step) < LAST_STEP * A, A - step, A))


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
            solve_segments(found.roots, cut, np.array(edges)).tolist(),
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
        return replace(segment, low=ends[0], high=ends[1])

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
    found = skeleton(model, F_0, window[0] if model.lets_go else 0.0)
    curves = _clipped(found, window)
    steps = [(number, segment, upward) for number, (curve, _) in enumerate(curves) for segment, upward in curve]
    weights = _weights([segment for _, segment, _ in steps])
    inner = np.ceil(samples * weights / weights.sum()).astype(int) if steps else np.empty(0, dtype=int)

    drawn = _points_inside(found.roots, [segment for _, segment, _ in steps], inner.tolist())

    Omega: list[Any] = []
    A: list[Any] = []
    stable: list[Any] = []
    branch: list[Any] = []
    for k, ((number, segment, upward), (at, own)) in enumerate(zip(steps, drawn, strict=True)):
        first, final = _end((segment, upward), True), _end((segment, upward), False)
        along = slice(None, None, 1 if upward else -1)
        starts = k == 0 or steps[k - 1][0] != number
        Omega += [[first[1]] if starts else [], at[along], [final[1]]]
        A += [[first[0]] if starts else [], own[along], [final[0]]]
        points = int(starts) + at.size + 1
        stable.append(np.full(points, segment.stable))
        branch.append(np.full(points, number))
    if not steps:
        empty = np.empty(0)
        message = joined(found.message, words.empty_window(model, F_0, window))
        none = np.empty(0, np.intp)
        return FrequencyResponse(empty, empty, empty > 0, F_0, message, model, none, (), remarks=found.remarks)
    moves = np.concatenate(A) > 0  # where the response begins the mass is at rest
    return FrequencyResponse(
        np.concatenate(Omega)[moves],
        np.concatenate(A)[moves],
        np.concatenate(stable)[moves],
        F_0,
        found.message,
        model,
        np.concatenate(branch)[moves],
        tuple(closed for _, closed in curves),
        remarks=found.remarks,
    )


@np.errstate(all="ignore")
def _points_inside(roots: Along, segments: list[Segment], numbers: list[int]) -> list[tuple[Floats, Floats]]:
    """Omega and A of n - 1 points inside each segment, by rising A: at amplitudes, or where it is steep at frequencies.

    Rounding takes none beyond a segment's ends, between which Omega is monotone.
    """
    if not segments:
        return []
    steep = [_is_steep(segment) for segment in segments]
    A, Omega = [], []
    for segment, n, by_Omega in zip(segments, numbers, steep, strict=True):
        low, high = segment.range
        if by_Omega:
            frequencies = _between(low, high, n)
            Omega.append(frequencies if segment.low[1] < segment.high[1] else frequencies[::-1])
            A.append(solve_segments(roots, [segment] * (n - 1), Omega[-1]))
        else:
            A.append(_between(segment.low[0], segment.high[0], n))
            Omega.append(np.full(n - 1, np.nan))
    of = np.repeat(np.arange(len(segments)), [n - 1 for n in numbers])
    at = np.flatnonzero(~np.array(steep)[of])
    joined_Omega = np.concatenate(Omega)
    count, index = (column[of[at]] for column in _numbers(segments))
    low, high = np.array([segment.range for segment in segments]).T
    joined_Omega[at] = np.clip(roots.at(np.concatenate(A)[at], count, index), low[of[at]], high[of[at]])
    return list(zip(np.split(joined_Omega, np.cumsum([n - 1 for n in numbers])[:-1]), A, strict=True))


def _is_steep(segment: Segment) -> bool:
    """Whether A hardly changes while Omega does, where Omega^2 is small beside h_A: doubles of A do not tell Omega."""
    low, high = segment.range
    return segment.high[0] - segment.low[0] < float(HARDLY) * segment.high[0] * ((high - low) / high)


def _between(low: float, high: float, n: int) -> Floats:
    """n - 1 rising numbers between two; they crowd towards the ends, where A or Omega may stand still.

    Where they span orders of magnitude half of them are shared out among these, as Omega changes with each of A's; the
    others follow the top.
    """
    orders = max(n // 2, 1) if low > 0 and high > 100 * low else 1
    plain = n + 1 - orders
    shares, of_orders = (0.5 - 0.5 * np.cos(np.pi * np.arange(1, count) / count) for count in (plain, orders))
    return np.sort(np.concatenate((low + (high - low) * shares, low * np.exp(of_orders * np.log(high / (low or 1.0))))))


def _weights(segments: list[Segment]) -> Floats:
    """Weights of segments in the sharing out of points: their extents in Omega and A, with a floor for short ones.

    A frequency and an amplitude of 1 count as much, or half the highest frequency and the highest amplitude of all.
    """
    A, Omega = (np.array([(segment.low[k], segment.high[k]) for segment in segments]).reshape(-1, 2) for k in (0, 1))
    of_Omega, of_A = np.ptp(Omega, axis=1) / max(1.0, 0.5 * Omega.max(initial=0)), np.ptp(A, axis=1) / A.max(initial=1)
    return np.asarray(of_Omega + of_A + SPREAD)


def amplitudes(model: Model, Omega: Floats, F_0: float) -> SteadyStates:
    """Every steady state at each frequency, by the order of Omega, then by rising A."""
    found = skeleton(model, F_0, float(Omega.min(initial=np.inf)) if model.lets_go else 0.0)
    at, A, stable = states_at(found, Omega)
    with np.errstate(all="ignore"):
        in_doubt = doubt.is_at_fold(model, F_0, Omega, found.folds.Omega, found.folds.A)
    undecided = Omega if found.undecided else Omega[in_doubt]
    message = words.of_states(model, F_0, found.message, Omega, at, undecided)
    codes = words.beside(undecided.size > 0, found.message)
    return SteadyStates(at, A, stable, F_0, message, model, Omega_undecided=undecided, remarks=codes)
