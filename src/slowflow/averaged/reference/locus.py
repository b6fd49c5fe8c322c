"""The fold locus as a result, on NumPy: in go a model and a range of A, out come its points, cusps and isola points."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from slowflow.averaged.reference.folds import NO_CUSP, NO_ISOLA, NO_LOCUS
from slowflow.averaged.reference.minima import cusp_is_minimum, is_saddle, isola_is_minimum
from slowflow.averaged.reference.spans import Ints, Spans, _on_span, spans
from slowflow.averaged.reference.spans import fold_locus as locus_of_folds
from slowflow.model import Floats, Model
from slowflow.results import Cusps, FoldLocus, IsolaPoints

#: Newton steps at isola points, and the relative size from which on a step is none
NEWTON_STEPS, NEAR = 3, 1e-4


def fold_locus(model: Model, A_max: float, samples: int) -> FoldLocus:
    """About `samples` points of the fold locus up to A_max."""
    located = spans(locus_of_folds(model), A_max)
    rows, branch = _in_order(located)
    if not rows.size:
        return FoldLocus(np.empty(0), np.empty(0), np.empty(0), branch, NO_LOCUS.format(A_max))
    per_row = max(1, round(samples / rows.size))
    share = np.linspace(0.0, 1.0, per_row, endpoint=False)
    s = (located.s[rows, :1] + (located.s[rows, 1:] - located.s[rows, :1]) * share).ravel()
    A, Omega = _on_span(located, np.repeat(rows, per_row), s)
    last = np.flatnonzero(np.append(branch[1:] != branch[:-1], True))
    at = (last + 1) * per_row
    A, Omega = np.insert(A, at, located.A[rows[last], 1]), np.insert(Omega, at, located.Omega[rows[last], 1])
    number = np.insert(np.repeat(branch, per_row), at, branch[last]).astype(np.intp)
    return FoldLocus(Omega, A, located.locus.level(A, Omega), number, "")


def _in_order(located: Spans) -> tuple[Ints, npt.NDArray[np.intp]]:
    """Rows of spans, those that follow each other on one branch side by side, and the number of the branch."""
    keys = np.stack([located.index, located.count, located.chart])
    order = np.lexsort((located.s[:, 0], *keys))
    new = (keys[:, order[1:]] != keys[:, order[:-1]]).any(axis=0) | (
        located.s[order[1:], 0] != located.s[order[:-1], 1]
    )
    return order, np.cumsum(np.concatenate([[0] if order.size else [], new]).astype(np.intp))


def extrema(model: Model, A_max: float) -> tuple[Cusps, IsolaPoints]:
    """The cusps and the isola points up to A_max."""
    located = spans(locus_of_folds(model), A_max)
    cusp, isola = (_by_amplitude(located, mark) for mark in ("cusp", "isola"))
    F_0, Omega, A = _points(located, cusp)
    cusps = Cusps(F_0, Omega, A, cusp_is_minimum(model, Omega, A), "" if A.size else NO_CUSP.format(A_max))
    Omega, A = _sharpened(model, _points(located, isola)[2])
    F_0 = located.locus.level(A, Omega)
    kind = np.where(is_saddle(model, Omega, A), "merger", np.where(isola_is_minimum(model, Omega, A), "birth", "death"))
    return cusps, IsolaPoints(F_0, Omega, A, kind, "" if A.size else NO_ISOLA.format(A_max))


def _by_amplitude(located: Spans, mark: str) -> Ints:
    rows = located.marked(mark)
    return rows[np.argsort(located.A[rows, 1], kind="stable")]


def _points(located: Spans, rows: Ints) -> tuple[Floats, Floats, Floats]:
    return located.level[rows, 1], located.Omega[rows, 1], located.A[rows, 1]


def _sharpened(model: Model, A: Floats) -> tuple[Floats, Floats]:
    """Omega and A of isola points, from amplitudes that are nearly theirs.

    F_A = 0 and F_Omega = 0 leave a function of A alone, whose Newton steps are better conditioned than those on both.
    """
    flow, m, zeta = model.flow, model.m, model.zeta
    if not A.size:
        return A, A
    for _ in range(NEWTON_STEPS):
        h, h_A, h_AA, _ = model.averaged(A)
        with np.errstate(divide="ignore", invalid="ignore"):
            value, slope = flow.isola(A, m, zeta, h, h_A, h_AA)
            step = value / slope
        A = A - np.where(np.abs(step) < NEAR * A, step, 0.0)
    return flow.isola_Omega(np.maximum(model.averaged(A)[1], 0.0)), A
