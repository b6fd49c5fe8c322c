"""What an oscillator says, at hard designs and forcings: errors in u (1 + kappa) of each kind of answer.

In:  seeded oscillators, forcings and frequencies at hard places. Out: by kind the errors drawn, and the worst found.
kappa is the condition in the inputs plus the one in the kernels' values; exact are the solutions next to the answers.
"""

from __future__ import annotations

import contextlib
import dataclasses
import math
import warnings
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from benchmarks.stress import search
from benchmarks.stress.domains import few, ulps
from benchmarks.stress.search import Found, Point
from slowflow import Duffing, Isolator
from slowflow.support.errors import NotSettled, SlowflowError
from tests.oracles.answers import Nearby
from tests.oracles.averaged import exact
from tests.oracles.certified_roots import precision

U = 2.0**-53
TARGET = 1.0
SEED = 13
#: answers by what they are asked for; all arguments of a point are named by the mechanism's `NAMES`
NAMES = {
    "rod_spring": ("lam", "r", "delta_h", "mu", "zeta", "F_0", "Omega"),
    "rod_spring_untruncated": ("lam", "r", "delta_h", "mu", "zeta", "F_0", "Omega"),
    "duffing": ("alpha", "beta", "mu", "zeta", "F_0", "Omega"),
}
BOUNDS = {
    "lam": (1.0, 10.0), "r": (1e-3, 1e6), "delta_h": (1e-6, 1 - 1e-9), "alpha": (-2.0, 3.0), "beta": (-2.0, 10.0),
    "mu": (0.0, 0.1), "zeta": (1e-12, 0.5), "F_0": (1e-9, 1e3), "Omega": (1e-3, 1e2),
}  # fmt: skip
#: A value, its exact one, and kappa
Judged = tuple[float, Any, float]


class Unjudged(str):
    """Why the exact solution next to an answer could not be had: a failure of the oracle, not of the answer."""


def oscillator(mechanism: str, at: Point) -> Any:
    """The oscillator at a point."""
    parameters = dict(zip(NAMES[mechanism][:-2], at, strict=False))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        if mechanism == "duffing":
            return Duffing(**parameters)
        return Isolator(**parameters, force="untruncated" if mechanism.endswith("untruncated") else "truncated")


def design(mechanism: str, rng: np.random.Generator) -> tuple[str, list[float]]:
    """The oscillator's numbers at a hard place, and its name."""
    mu, zeta = float(10 ** rng.uniform(-4, -1.3)), float(10 ** rng.uniform(-3, -0.6))
    place = str(rng.choice(["anywhere", "mu to 0", "zeta to 0", "stiffness at rest", "preload"]))
    if place == "mu to 0":
        mu = float(rng.choice([0.0, 1e-12, 1e-9]))
    if place == "zeta to 0":
        zeta = float(rng.choice([1e-12, 1e-9, 1e-6, 1e-4]))
    if mechanism == "duffing":
        hard, alpha = (-0.5, 2.0**-53, 0.0, 1e-9), float(rng.uniform(0.05, 1.5))
        if place == "stiffness at rest":
            alpha = float(rng.choice(hard))
        return place, [alpha, float(rng.uniform(-1, 2)), mu, zeta]
    lam, delta_h = float(rng.integers(1, 5)), float(rng.uniform(0.02, 0.4))
    if place == "preload":
        delta_h = float(rng.choice([10 ** rng.uniform(-6, -2), 1 - 10 ** rng.uniform(-9, -0.5)]))
    r = float(rng.uniform(0.1, 0.95)) / (lam * delta_h)
    if place == "stiffness at rest":  # zero to the ulp, or negative
        r = ulps(1 / (lam * delta_h), few(rng)) if rng.random() < 0.5 else r * float(rng.uniform(1, 3))
    return place, [lam, r, delta_h, mu, zeta]


def answers(mechanism: str, at: Point, only: str | None = None) -> Iterator[tuple[str, Judged | Unjudged | None]]:
    """Each answer at a point by kind, judged; None for an answer that no exact solution lies next to."""
    iso = oscillator(mechanism, at)
    *own, F_0, Omega = at
    exactly = Nearby(mechanism, **dict(zip(NAMES[mechanism], own, strict=False)))

    def of(
        sought: tuple[str, float, float | None, float], fields: dict[str, float], kind: str
    ) -> Iterator[tuple[str, Any]]:
        try:
            found = exactly.solution(*sought)
        except SlowflowError as failure:
            found = Unjudged(failure)
        for name, value in fields.items():
            if found is None or isinstance(found, Unjudged):
                yield f"{kind}, {name}", found
            else:
                point, condition = found
                key = {"F_SN": "F_0", "F_cr": "F_0"}.get(name, name)
                kappa = condition.inputs.get(key, 0.0) + condition.kernel.get(key, 0.0)
                yield f"{kind}, {name}", (value, getattr(point, key), kappa)

    def selected(kind: str) -> bool:
        return only is None or only.startswith(kind)

    if selected("state"):
        for state in iso.amplitudes(Omega=Omega, F_0=F_0):
            yield from of(("state", Omega, state.A, F_0), {"A": state.A}, "state at Omega")
    if selected("fold"):
        for fold in iso.saddle_nodes(F_0):
            if fold.corner:
                found = ("fold", fold.Omega, None, F_0)
                yield from of(found, {"Omega": fold.Omega}, "fold on the corner")
            else:
                found = ("fold", fold.Omega, fold.A, F_0)
                yield from of(found, {"Omega": fold.Omega, "A": fold.A}, "fold at F_0")
    if selected("peak"):
        peak = iso.peak(F_0)
        if peak.A is not None and peak.Omega:
            found = ("peak", peak.Omega, peak.A, F_0)
            yield from of(found, {"Omega": peak.Omega, "A": peak.A}, "peak")
    if selected("critical") and mechanism != "duffing":
        left = iso.detachment()
        if left.Omega_cr:
            found = ("detachment", left.Omega_cr, None, 1.0)
            yield from of(found, {"F_cr": left.F_cr}, "critical forcing")
    if selected("onset"):
        onset = iso.saddle_node_onset()
        if onset.F_SN is not None and onset.kind in ("cusp", "isola") and onset.Omega:
            found = (onset.kind, onset.Omega, onset.A, onset.F_SN)
            article = "an" if onset.kind == "isola" else "a"
            yield from of(found, {"F_SN": onset.F_SN}, f"onset at {article} {onset.kind}")
    A_max = {} if math.isfinite(iso.model.reach) else {"A_max": 5.0}
    if selected("cusp"):
        for cusp in iso.cusps(**A_max):
            found = ("cusp", cusp.Omega, cusp.A, cusp.F_0)
            yield from of(found, {"F_0": cusp.F_0, "Omega": cusp.Omega, "A": cusp.A}, "cusp")
    if selected("isola"):
        for point in iso.isola_points(**A_max):
            found = ("isola", point.Omega, point.A, point.F_0)
            yield from of(found, {"F_0": point.F_0, "Omega": point.Omega, "A": point.A}, "isola point")


def judged(answer: Judged) -> tuple[float, float]:
    """Error in u (1 + kappa), and 1 + kappa."""
    value, true, kappa = answer
    with precision(400):
        relative = float(abs(exact(value) / true - 1)) if math.isfinite(value) else math.inf
    return relative / (U * (1 + kappa)), 1 + kappa


def forcings(iso: Any, rng: np.random.Generator) -> Iterator[tuple[str, float]]:
    """Hard forcings of an oscillator, with their places."""
    yield "an ulp above 4 mu/pi", ulps(iso.model.m, 1) if iso.mu else 1e-6
    yield "anywhere", float(10 ** rng.uniform(-3, 0.5))
    onset = iso.saddle_node_onset().F_SN
    if onset is not None and onset > 0:
        yield "just above F_SN", onset * (1 + 10 ** rng.uniform(-15, -2))
        yield "above F_SN", onset * float(rng.uniform(1.02, 3))
    if iso.breakpoints:
        F_cr = iso.detachment().F_cr
        if F_cr:
            yield "next to F_cr", F_cr * (1 + float(rng.choice([-1, 1])) * 10 ** rng.uniform(-15, -2))


def points(mechanism: str, rng: np.random.Generator) -> Iterator[tuple[str, Point]]:
    """One oscillator with its hard forcings, and a hard frequency of each."""
    place, own = design(mechanism, rng)
    iso = oscillator(mechanism, (*own, 1.0, 1.0))
    for at_forcing, F_0 in forcings(iso, rng):
        Omega, where = float(10 ** rng.uniform(-0.5, 0.3)), "anywhere"
        if rng.random() < 0.7:
            with contextlib.suppress(NotSettled):  # a refusal, which the questions themselves meet again
                folds, peak = iso.saddle_nodes(F_0), iso.peak(F_0)
                if len(folds) and rng.random() < 0.6:
                    factor = 1 + float(rng.choice([-1, 1])) * 10 ** rng.uniform(-15, -3)
                    Omega, where = float(rng.choice(folds.Omega)) * factor, "next to a fold"
                elif peak.Omega:
                    Omega, where = ulps(peak.Omega, few(rng)), "at the peak"
        if inside(mechanism, (*own, F_0, Omega)):
            yield f"{place}; F_0 {at_forcing}; Omega {where}", (*own, F_0, Omega)


def inside(mechanism: str, at: Point) -> bool:
    """Whether a point keeps to the bounds."""
    return all(BOUNDS[name][0] <= x <= BOUNDS[name][1] for name, x in zip(NAMES[mechanism], at, strict=True))


def measure(mechanism: str, kind: str) -> Callable[[Point], tuple[float, float] | None]:
    """The worst answer of one kind at a point; None where there is none, or outside the bounds."""

    def of(at: Point) -> tuple[float, float] | None:
        if not inside(mechanism, at):
            return None
        try:
            found = [judged(a) for k, a in answers(mechanism, at, kind) if k == kind and isinstance(a, tuple)]
        except SlowflowError:
            return None
        return max(found, default=None)

    return of


def stress(mechanism: str, part: int, count: int, restarts: int, steps: int) -> list[dict[str, Any]]:
    """A share of the oscillators of a mechanism: by kind the errors, what nothing exact lies next to, the worst."""
    rng = np.random.default_rng([SEED, part, len(mechanism)])
    seen: dict[str, list[Found]] = {}
    unmatched: dict[str, list[Point]] = {}
    unjudged: dict[str, list[tuple[str, Point]]] = {}
    failed: list[tuple[str, Point]] = []
    for _ in range(count):
        try:
            cases = list(points(mechanism, rng))
        except NotSettled as failure:
            failed.append((str(failure), ()))
            continue
        for place, at in cases:
            try:
                for kind, answer in answers(mechanism, at):
                    if answer is None:
                        unmatched.setdefault(kind, []).append(at)
                    elif isinstance(answer, Unjudged):
                        unjudged.setdefault(kind, []).append((answer, at))
                    else:
                        seen.setdefault(kind, []).append(Found(*judged(answer), at, place))
            except SlowflowError as failure:
                failed.append((str(failure), at))
    table = []
    for kind, found in seen.items():
        worst = search.worst(measure(mechanism, kind), found, restarts, steps, rng)
        table.append(
            {
                "mechanism": mechanism,
                "kind": kind,
                "names": NAMES[mechanism],
                "answers": len(found),
                "alone": unmatched.get(kind, []),
                "unjudged": unjudged.get(kind, []),
                "failed": failed,
                "drawn": [(f.condition, f.error) for f in found],
                "worst": [dataclasses.asdict(f) for f in worst[:1]],
            }
        )
    return table
