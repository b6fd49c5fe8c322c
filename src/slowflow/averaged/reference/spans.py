"""Loci that are explicit in the amplitude: in go a model and a range of A, out come monotone spans of a forcing level.

For each A the folds (F_A = 0), the peaks (F_Omega = 0) and the static state (Omega = 0) are roots of a low-degree
polynomial in Omega that holds no F_0; the forcing for which they are steady states is F_0 = sqrt(R^2 + I^2). A question
"where, at this F_0?" is then a level crossing of a function of A, whose extrema are the cusps and the isola points.

A locus is followed on a chart s -> A for each piece of the force, and split into spans on which the number of roots is
constant and the level monotone: a span holds a crossing if and only if its ends lie on both sides of the level.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow.averaged.reference.roots import fold_roots, peak_roots
from slowflow.model import Floats, Model

Ints = npt.NDArray[np.integer[Any]]

#: nodes of a chart
NODES = 257
#: parts into which an interval is cut in search of a change
SECTIONS = 64
#: e-foldings of the spacing of the nodes: towards A = 0, and towards a breakpoint from above
GRADING_FROM_ZERO = 7.0
GRADING_FROM_BREAKPOINT = 16.0


@dataclass(frozen=True)
class Chart:
    """A parametrisation of one piece, s in [0, 1] -> A in (start, end].

    Above a breakpoint b, A = b cosh(x): h is analytic in x there, not in A.
    """

    start: float
    end: float

    def amplitude(self, s: Floats) -> Floats:
        if self.start == 0:
            A = self.end * np.expm1(GRADING_FROM_ZERO * s) / np.expm1(GRADING_FROM_ZERO)
            # one place beyond the end the next piece holds
            return np.asarray(np.minimum(A, self.end))
        top = np.arccosh(self.end / self.start)
        x = top * np.expm1(GRADING_FROM_BREAKPOINT * s) / np.expm1(GRADING_FROM_BREAKPOINT)
        return np.asarray(np.clip(self.start * np.cosh(x), np.nextafter(self.start, np.inf), self.end))

    def nodes(self) -> Floats:
        """Values of s by rising A, all with A of their own."""
        s = np.linspace(0.0, 1.0, NODES)
        s = s[1:] if self.start == 0 else s
        _, distinct = np.unique(self.amplitude(s), return_index=True)
        return s[distinct]


def charts(model: Model, A_max: float) -> list[Chart]:
    """The pieces of the force up to A_max, each with its chart."""
    starts = [0.0, *(end for end in model.breakpoints if end < A_max)]
    return [Chart(start, end) for start, end in zip(starts, [*starts[1:], A_max], strict=True)]


@dataclass(frozen=True)
class Locus:
    """One locus of a model.

    roots  -- A -> (Omega of shape (n, k), number of roots), by rising Omega, NaN behind the last
    extrema -- signs that change where the level has an extremum along the locus: name -> function of (A, Omega)
    """

    model: Model
    roots: Callable[[Floats], tuple[Floats, Ints]]
    extrema: dict[str, Callable[[Floats, Floats], Floats]]

    def level(self, A: Floats, Omega: Floats) -> Floats:
        """The forcing F_0 for which (Omega, A) is a steady state."""
        model, flow = self.model, self.model.flow
        h = model.averaged(A)[0]
        return np.asarray(flow.level(Omega, A, model.m, model.zeta, h))


def fold_locus(model: Model) -> Locus:
    """F_A = 0. Its level has extrema at cusps (F_AA = 0) and, with viscous damping, at isola points (F_Omega = 0)."""
    flow, m, zeta = model.flow, model.m, model.zeta

    def roots(A: Floats) -> tuple[Floats, Ints]:
        h, h_A, _, _ = model.averaged(A)
        return fold_roots(A, h, h_A, m, zeta)

    def F_AA(A: Floats, Omega: Floats) -> Floats:
        h, h_A, h_AA, _ = model.averaged(A)
        return np.asarray(flow.F_AA(Omega, A, m, zeta, h, h_A, h_AA))

    def F_Omega(A: Floats, Omega: Floats) -> Floats:
        return np.asarray(flow.F_Omega(Omega, A, m, zeta, model.averaged(A)[0]))

    # for zeta = 0 both F_A and F_Omega vanish all along the backbone R = 0, which is no point
    return Locus(model, roots, {"cusp": F_AA, "isola": F_Omega} if zeta > 0 else {"cusp": F_AA})


def peak_locus(model: Model) -> Locus:
    """F_Omega = 0. Its level has extrema at isola points (F_A = 0)."""
    flow, m, zeta = model.flow, model.m, model.zeta

    def roots(A: Floats) -> tuple[Floats, Ints]:
        return peak_roots(A, model.averaged(A)[0], m, zeta)

    def F_A(A: Floats, Omega: Floats) -> Floats:
        h, h_A, _, _ = model.averaged(A)
        return np.asarray(flow.F_A(Omega, A, m, zeta, h, h_A))

    return Locus(model, roots, {"isola": F_A})


def static_locus(model: Model) -> Locus:
    """Omega = 0. Its level has extrema where F_A = 0."""

    def roots(A: Floats) -> tuple[Floats, Ints]:
        return np.zeros((*A.shape, 1)), np.ones(A.shape, dtype=np.intp)

    def F_A(A: Floats, Omega: Floats) -> Floats:
        h, h_A, _, _ = model.averaged(A)
        return np.asarray(model.flow.F_A(Omega, A, model.m, model.zeta, h, h_A))

    return Locus(model, roots, {"static": F_A})


@dataclass(frozen=True)
class Spans:
    """Monotone spans of a locus, one row each; low and high by rising A.

    chart -- the chart each lies on
    count, index -- number of roots along the span, and which of them by rising Omega
    s, A, Omega, level -- arrays of shape (rows, 2): at the low end and at the high end
    mark -- (rows, 2): what each end is: "cusp", "isola", "static" (extrema of the level), "turning" (of the locus in
            A), "zero" (Omega = 0), or "" (a node or an end of the chart)
    """

    locus: Locus
    charts: list[Chart]
    chart: Ints
    count: Ints
    index: Ints
    s: Floats
    A: Floats
    Omega: Floats
    level: Floats
    mark: npt.NDArray[np.str_]

    def crossed(self, F_0: float) -> Ints:
        """Rows whose ends lie on both sides of the level."""
        off = self.level - F_0
        return np.flatnonzero((off[:, 0] < 0) != (off[:, 1] < 0))

    def crossings(self, F_0: float, rows: Ints | None = None) -> tuple[Floats, Floats]:
        """A and Omega of every point of the locus with this level, or of those on the given rows, by rising A."""
        rows = self.crossed(F_0) if rows is None else rows
        s = _solve(self, rows, lambda A, Omega: self.locus.level(A, Omega) - F_0)
        A, Omega = _on_span(self, rows, s)
        order = np.argsort(A, kind="stable")
        return A[order], Omega[order]

    def marked(self, mark: str) -> Ints:
        """Rows whose high end carries the mark."""
        return np.flatnonzero(self.mark[:, 1] == mark)


def spans(locus: Locus, A_max: float) -> Spans:
    """Follow a locus over 0 < A <= A_max."""
    pieces = charts(locus.model, A_max)
    rows: list[tuple[Any, ...]] = []
    for number, chart in enumerate(pieces):
        rows += _chart_rows(locus, chart, number)
    columns: list[Any] = list(zip(*rows, strict=True)) if rows else [()] * 8
    chart_, count, index = (np.array(column, dtype=np.intp) for column in columns[:3])
    s, A, Omega, level = (np.array(column, dtype=float).reshape(-1, 2) for column in columns[3:7])
    raw = Spans(
        locus, pieces, chart_, count, index, s, A, Omega, level, np.array(columns[7], dtype="U7").reshape(-1, 2)
    )
    return _split_at_extrema(raw)


def _chart_rows(locus: Locus, chart: Chart, number: int) -> list[tuple[Any, ...]]:
    """Spans between neighbouring nodes of one chart; where the number of roots changes, a pair of nodes is put in."""
    s = chart.nodes()
    A = chart.amplitude(s)
    Omega, count = locus.roots(A)
    marks: dict[float, str] = {}
    changes = np.flatnonzero(count[1:] != count[:-1])
    for k in changes:
        for below, above, n in _changes_of_count(locus, chart, s[k], s[k + 1], int(count[k]), int(count[k + 1])):
            marks[below] = marks[above] = "turning" if abs(n) == 2 else "zero"
    if marks:
        s = np.unique(np.concatenate([s, list(marks)]))
        A = chart.amplitude(s)
        Omega, count = locus.roots(A)
    _close_pairs(Omega, count, [k for k in range(s.size) if marks.get(s[k]) == "turning"])
    level = locus.level(A[:, np.newaxis], Omega)
    rows: list[tuple[Any, ...]] = []
    for place in range(s.size - 1):
        if count[place] != count[place + 1]:
            continue
        for j in range(int(count[place])):
            ends = (place, place + 1)
            rows.append(
                (
                    number,
                    count[place],
                    j,
                    tuple(s[e] for e in ends),
                    tuple(A[e] for e in ends),
                    tuple(Omega[e, j] for e in ends),
                    tuple(level[e, j] for e in ends),
                    tuple(marks.get(s[e], "") for e in ends),
                )
            )
    return rows


def _close_pairs(Omega: Floats, count: Ints, turning: list[int]) -> None:
    """Let the two nearest roots at each turning point meet, in place: a level between theirs would be lost there."""
    for k in turning:
        if count[k] >= 2:
            j = int(np.argmin(np.diff(Omega[k, : count[k]])))
            Omega[k, j : j + 2] = Omega[k, j : j + 2].mean()


def _changes_of_count(
    locus: Locus, chart: Chart, low: float, high: float, count_low: int, count_high: int
) -> list[tuple[float, float, int]]:
    """Neighbouring s between which the number of roots changes, and by how many, for s in [low, high]."""
    found = []
    while count_low != count_high:
        below, above, count_above = low, high, count_high
        while True:
            # many points at once cost as much as one
            inner = np.unique(np.linspace(below, above, SECTIONS + 1))
            inner = inner[(inner > below) & (inner < above)]
            if not inner.size:
                break
            _, counts = locus.roots(chart.amplitude(inner))
            first = int(np.argmax(counts != count_low)) if (counts != count_low).any() else inner.size
            if first > 0:
                below = float(inner[first - 1])
            if first < inner.size:
                above, count_above = float(inner[first]), int(counts[first])
        found.append((below, above, count_above - count_low))
        low, count_low = above, count_above
    return found


def _on_span(spans: Spans, rows: Ints, s: Floats) -> tuple[Floats, Floats]:
    """A and Omega at s on the given spans."""
    A = np.empty_like(s)
    for number, chart in enumerate(spans.charts):
        here = spans.chart[rows] == number
        A[here] = chart.amplitude(s[here])
    Omega, count = spans.locus.roots(A)
    index = np.minimum(spans.index[rows], Omega.shape[-1] - 1)
    picked = np.take_along_axis(Omega, index[:, np.newaxis], axis=-1)[:, 0]
    # Within rounding of a turning point the number of roots may flicker: the ends of the span say where to look then.
    lost = count != spans.count[rows]
    if lost.any():
        ends = spans.s[rows]
        part = (s - ends[:, 0]) / (ends[:, 1] - ends[:, 0])
        guess = spans.Omega[rows, 0] * (1 - part) + spans.Omega[rows, 1] * part
        distance = np.where(np.isnan(Omega), np.inf, np.abs(Omega - guess[:, np.newaxis]))
        nearest = np.take_along_axis(Omega, distance.argmin(axis=-1)[:, np.newaxis], axis=-1)[:, 0]
        picked = np.where(lost, np.where(count > 0, nearest, guess), picked)
    return A, picked


def _solve(spans: Spans, rows: Ints, function: Callable[[Floats, Floats], Floats]) -> Floats:
    """s of the sign change of a function of (A, Omega) on each of the given spans."""
    if not rows.size:
        return np.empty(0)
    from scipy.optimize import elementwise

    def along(s: Floats, which: Ints) -> Floats:
        return function(*_on_span(spans, rows[which.astype(np.intp)], s))

    result = elementwise.find_root(along, (spans.s[rows, 0], spans.s[rows, 1]), args=(np.arange(rows.size),))
    # A zero on an end itself gives no bracket: the end is the answer.
    at_low = np.abs(along(spans.s[rows, 0], np.arange(rows.size)))
    at_high = np.abs(along(spans.s[rows, 1], np.arange(rows.size)))
    ends = np.where(at_low <= at_high, spans.s[rows, 0], spans.s[rows, 1])
    return np.asarray(np.where(result.success, result.x, ends))


def _split_at_extrema(spans: Spans) -> Spans:
    """The same spans, split where the level has an extremum inside."""
    locus = spans.locus
    for mark, sign in locus.extrema.items():
        if not spans.s.size:
            break
        values = np.stack([sign(spans.A[:, end], spans.Omega[:, end]) for end in (0, 1)], axis=-1)
        rows = np.flatnonzero((values[:, 0] < 0) != (values[:, 1] < 0))
        if not rows.size:
            continue
        s = _solve(spans, rows, sign)
        A, Omega = _on_span(spans, rows, s)
        level = locus.level(A, Omega)
        take = np.sort(np.concatenate([np.arange(spans.s.shape[0]), rows]))
        first = np.searchsorted(take, rows, side="left")
        new = {name: getattr(spans, name)[take].copy() for name in ("s", "A", "Omega", "level", "mark")}
        for name, value in (("s", s), ("A", A), ("Omega", Omega), ("level", level), ("mark", np.full(rows.size, mark))):
            new[name][first, 1] = value
            new[name][first + 1, 0] = value
        spans = Spans(locus, spans.charts, spans.chart[take], spans.count[take], spans.index[take], **new)
    return spans
