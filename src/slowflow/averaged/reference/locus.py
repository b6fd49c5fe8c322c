"""The fold locus as a result, on NumPy: in go a model and a range of A, out come its points, cusps and isola points.

Between neighbouring stations (cusps, isola points, turning points, ends at Omega = 0, breakpoints) the number of
branches is constant, and along each branch Omega and the level F_0 are monotone. As in native/locus.h.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from slowflow.averaged import words
from slowflow.averaged.reference.along import Asked, Cusp, InertiaIsola, Isola, Stiffness, Turn, Undamped
from slowflow.averaged.reference.arcs import Event, Graph, Kind, Roots, merged
from slowflow.averaged.reference.cells import Stretch, samples_at, stretches_up_to
from slowflow.averaged.reference.doubt import have_cusps_few_digits
from slowflow.averaged.reference.minima import cusp_is_minimum, is_saddle, isola_is_minimum
from slowflow.averaged.reference.search import Zeros, find_zeros
from slowflow.model import Floats, Model
from slowflow.results import Cusps, FoldLocus, IsolaPoints
from slowflow_kernels import inertia, slow_flow
from slowflow_kernels.conventions import SPREAD


def _with_force(model: Model, A_max: float) -> list[Stretch]:
    """Where there is no force, as in a dead zone, there is no fold."""
    return [piece for piece in stretches_up_to(model, A_max) if piece.has_force]


def _of_extrema(model: Model) -> list[Asked]:
    """Cusps and isola points, for zeta > 0."""
    return [Cusp(model), InertiaIsola(model) if model.inertial else Isola(model)]


@dataclass(frozen=True)
class Stations:
    """Zeros along the fold locus, by question; those of a question that its damping has not are None."""

    pieces: list[Stretch]
    stiffness: Zeros
    cusps: Zeros
    isolas: Zeros | None
    turns: Zeros | None

    @property
    def undecided(self) -> bool:
        """Whether rounding may hide some at which the level turns."""
        asked = [self.cusps] if self.isolas is None else [self.cusps, self.isolas]
        return any(zeros.undecided.any() for zeros in asked)

    @classmethod
    def of(cls, model: Model, A_max: float) -> Stations:
        pieces = _with_force(model, A_max)
        if model.zeta == 0:
            stiffness, cusps = find_zeros(model, [Stiffness(model), Undamped(model)], pieces)
            return cls(pieces, stiffness, cusps, None, None)
        questions = [Stiffness(model), *_of_extrema(model), Turn(model)]
        stiffness, cusps, isolas, turns = find_zeros(model, questions, pieces)
        return cls(pieces, stiffness, cusps, isolas, turns)

    def events(self) -> list[Event]:
        """By rising A."""
        found: list[Event] = []
        for number, piece in enumerate(self.pieces):
            inside: list[Event] = []
            for zeros in (self.stiffness, self.isolas, self.cusps, self.turns):
                own = zeros.take(zeros.piece == number) if zeros is not None else None
                for i in range(0 if own is None else len(own)):
                    assert own is not None
                    kind, gain = Kind.THROUGH, 0
                    if zeros is self.stiffness:
                        kind = Kind.TO_ZERO
                    elif zeros is self.turns:
                        # where a maximum of F_A over Omega rises above zero a pair is born
                        low = own.channel[i] == 0
                        kind, gain = (Kind.PAIR_LOW if low else Kind.PAIR_HIGH), 2 if own.rising[i] == low else -2
                    inside.append(Event(float(own.A[i]), float(own.Omega[i]), kind, gain))
            base = float(piece.base[0])
            first = base if base == 0 else float(np.nextafter(base, np.inf))
            ends = (Event(A, 0.0, Kind.CUT) for A in (first, float(piece.last.A[0])))
            found += [next(ends), *sorted(inside, key=lambda event: event.A), next(ends)]
        return merged(found)


def fold_locus(model: Model, A_max: float, samples: int) -> FoldLocus:
    """About `samples` points of the fold locus up to A_max, in order along each branch."""
    roots = Roots(model, -1.0)
    graph = Graph.of(roots, Stations.of(model, A_max).events())
    arcs = graph.arcs
    if not arcs:
        none = np.empty(0)
        return FoldLocus(none, none, none, np.empty(0, dtype=np.intp), words.no_locus(model, A_max))
    A, Omega = (np.array([getattr(arc, name) for arc in arcs]) for name in ("A", "Omega"))
    with np.errstate(all="ignore"):
        # of a force that jumps at u = 0 no Omega is known at A = 0, where the locus begins
        way = np.nan_to_num(np.abs(np.diff(Omega / (1 + Omega), axis=1)[:, 0]))
        weight = way + np.diff(A, axis=1)[:, 0] / A_max + SPREAD
        steps = np.ceil(samples * weight / weight.sum()).astype(int)
        of, share, branch = [], [], []
        for number, tour in enumerate(graph.tours):
            for place, (arc, upward) in enumerate(tour.steps):
                n = steps[arc]
                along = np.arange(n + (place + 1 == len(tour.steps))) / n
                share.append(0.5 - 0.5 * np.cos(np.pi * (along if upward else 1 - along)))
                of.append(np.full(along.size, arc))
                branch.append(np.full(along.size, number, dtype=np.intp))
        at, s = np.concatenate(of), np.concatenate(share)
        low, high = s == 0, s == 1
        A_at = np.where(high, A[at, 1], A[at, 0] + (A[at, 1] - A[at, 0]) * s)
        count, index = (np.array([getattr(arc, name) for arc in arcs])[at] for name in ("count", "index"))
        # the Omega of the ends is known; at A = 0 there is no quartic
        inside = roots.at(np.where(A_at > 0, A_at, A_max), count, index)
        Omega_at = np.where(low, Omega[at, 0], np.where(high, Omega[at, 1], inside))
        F_0 = of_locus(model, Omega_at, A_at)
    there = ~np.isnan(Omega_at)
    return FoldLocus(Omega_at[there], A_at[there], F_0[there], np.concatenate(branch)[there], "")


def of_locus(model: Model, Omega: Floats, A: Floats) -> Floats:
    """The level at points of the fold locus.

    By k and F_A = 0, as rounding of h and A Omega^2 may leave nothing of R, but where the two slopes that R may have
    all but meet and the root between them loses more; and under an excitation by inertia 0 at A = 0, where the locus
    begins without friction and no Omega is known.
    """
    level = np.asarray(model.level(Omega, A))
    if model.inertial:
        level = np.where(A > 0, level, 0.0)
    if model.zeta == 0:
        return level
    at = samples_at(model, A)
    steep, flat, _ = inertia.fold_slopes(Omega, at.A, model.m, model.zeta, at.k)
    slope = Omega**2 + at.h_A
    other = np.where(np.abs(slope - steep) <= np.abs(slope - flat), flat, steep)
    known = (Omega > 0) & (at.k**2 > 0) & (np.abs(at.k) < np.inf)
    known &= np.abs(steep - flat) * at.size_of_R(Omega) >= np.abs(at.k * other)
    by_slope = inertia.fold_level if model.inertial else inertia.fold_force
    return np.where(known, by_slope(Omega, at.A, model.m, model.zeta, other), level)


def of_cusps(model: Model, cusps: Zeros) -> Floats:
    """The level at zeros of `Cusp`, from the force there."""
    return inertia.amplitude(cusps.Omega, cusps.level) if model.inertial else cusps.level


def of_isolas(model: Model, Omega: Floats, A: Floats) -> Floats:
    """The level at isola points."""
    return model.level(Omega, A) if model.inertial else slow_flow.isola_level(Omega, A, model.m, model.zeta)


def extrema(model: Model, A_max: float) -> tuple[Cusps, IsolaPoints]:
    """The cusps and the isola points up to A_max."""
    # without the locus, whose turns are beyond doubles where damping is weak: there its two branches all but cross
    asked = _of_extrema(model) if model.zeta > 0 else [Undamped(model)]
    at, *isolas = find_zeros(model, asked, _with_force(model, A_max))
    with np.errstate(all="ignore"):
        Omega, A = at.Omega, at.A
        F_0 = of_cusps(model, at) if model.zeta > 0 else model.level(Omega, A)
        said = words.of_points(A, have_cusps_few_digits(model, Omega, A), words.NO_CUSP.format(A_max))
        cusps = Cusps(F_0, Omega, A, cusp_is_minimum(model, Omega, A), **said)
        Omega, A = (isolas[0].Omega, isolas[0].A) if isolas else (np.empty(0),) * 2
        F_0 = of_isolas(model, Omega, A)
        birth = np.where(isola_is_minimum(model, Omega, A), "birth", "death")
        kind = np.where(is_saddle(model, Omega, A), "merger", birth)
    return cusps, IsolaPoints(F_0, Omega, A, kind, "" if A.size else words.NO_ISOLA.format(A_max))
