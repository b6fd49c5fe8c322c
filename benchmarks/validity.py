"""How far averaging is from the equation of motion: measured over mu/F_0, zeta, delta_h, and under random excitation.

A quarter of an hour of one core.

`python -m benchmarks.validity` measures, writes benchmarks/results/validity.json and
src/slowflow/answers/validity_table.py, and lets `validity_page` draw the figures and write docs/validity.md; `--draw`
does all but measure.
"""

from __future__ import annotations

import argparse
import functools
import itertools
import json
import math
import time
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import brentq

from benchmarks import validity_page
from slowflow import Isolator, derive, example
from slowflow.core.mechanism import EquationOfMotion, Force
from slowflow.exact import Response, SteadyState, exact_response
from slowflow.example import TABLE_1
from slowflow.second import SecondApproximation
from slowflow.support.errors import NotSettled
from slowflow_kernels import linearization, slow_flow

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "benchmarks/results/validity.json"
TABLE = ROOT / "src/slowflow/answers/validity_table.py"

#: Table 1, but for what a map varies
RATIOS = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.55, 0.6, 0.65, 0.7, 0.74, 0.77)
ZETAS = (0.005, 0.02, 0.05, 0.1)
PRELOADS = (0.03, TABLE_1["delta_h"], 0.13)
LEVELS = (0.8, 1.4)  # amplitude on the backbone over u_cr: attached, and as in the middle of Fig. 7a
ONSET_RATIOS = (0.0, 0.2, 0.4, 0.5, 0.6, 0.65, 0.7)
ONSET_ZETAS = (0.005, 0.02, 0.05)
PLANE_RATIOS = (0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.65, 0.7, 0.74, 0.77)
PLANE_FORCING = 0.02
PLANE_WINDOW = (0.2, 1.6)
TRUNCATION_LEVELS = (0.4, 0.6, 0.8, 0.9, 0.97, 1.05, 1.2, 1.5, 2.0)
TRUNCATION_PRELOADS = (0.03, 0.06, 0.1, 0.15, 0.2, 0.3, 0.4)  # lam r delta_h = 1/2 throughout: alpha as in Table 1
# bins of the table: edges of mu/F_0 and of mu/(A Omega^2)
BINS = (0.0, 0.25, 0.35, 0.45, 0.525, 0.575, 0.625, 0.675, 0.72)
REST_BINS = (0.0, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 3.0)
SHIFT = 0.01  # relative change of frequency that a misfit leaves free
# statistical linearization: springs by name, each with means of u and sigma_u over its breakpoint; how far the
# spectrum, flat in a band, reaches below and above the equivalent natural frequency, infinitely of white noise;
# friction's share of the damping
RANDOM_MAPS = (
    ("isolator", (0.0,), (0.25, 0.5, 1.0), (math.inf, 4.0, 2.0, 1.25)),
    ("stops", (0.0,), (0.5, 1.0), (math.inf, 4.0, 2.0, 1.25)),
    ("isolator", (0.5, 1.0), (0.25, 0.5, 1.0), (math.inf, 2.0, 1.25)),
    ("one stop", (0.0,), (0.5, 1.0, 2.0), (math.inf, 2.0, 1.25)),
)
RANDOM_SHARES = (0.0, 0.3, 0.6, 0.8, 0.9, 0.95)
RANDOM_ZETA = 0.05
RANDOM_SAMPLES = 4_000_000
RANDOM_STOPS = {"kappa": 8.0, "delta": 0.2}
FEW = 25  # points, below which a bin is not its own
STEP = 0.05
POINTS = 60  # of an averaged curve, compared with the exact one
#: what results are filed under: the force of the equation of motion; "exact" has nothing truncated
FORCES = {"truncated": "truncated", "exact": "untruncated"}


def isolator(ratio: float, zeta: float, delta_h: float, F_0: float) -> Isolator:
    """Table 1 with other damping and preload."""
    return example.isolator(delta_h=delta_h, mu=ratio * F_0, zeta=zeta)


def forcing(ratio: float, zeta: float, delta_h: float, A: float) -> tuple[float, float]:
    """(F_0, Omega) that hold the amplitude A on the backbone: F_0 = I of (23)."""
    Omega = float(isolator(0.0, zeta, delta_h, 1.0).backbone(A))
    # I is the viscous part and the friction, which is proportional to F_0 here
    return float(slow_flow.I(Omega, A, 0.0, zeta) / (1 - slow_flow.friction(ratio))), Omega


def window(averaged: Isolator, Omega: float) -> tuple[float, float]:
    """The frequencies around the resonance: from below the linear one to beyond the one of the backbone."""
    return 0.8 * math.sqrt(averaged.alpha), 1.25 * Omega


def attempt(job: Callable[[], Any]) -> Any:
    """The answer, or None where a curve cannot be followed; these are counted."""
    try:
        return job()
    except NotSettled:
        return None


def whole(curve: Response) -> Response:
    """A curve that was followed to its ends; of a part neither folds nor a peak are known."""
    if not curve.complete:
        raise ArithmeticError(curve.message)
    return curve


def logs(Omega: Any, A: Any) -> np.ndarray:
    return np.column_stack((np.log(Omega), np.log(A)))


def misfit(points: np.ndarray, line: np.ndarray) -> np.ndarray:
    """|A of the curve / A of the point - 1| for each point, least within SHIFT of its frequency; both as logarithms.

    At one frequency alone it would tell of the steepness of the curve beside a resonance, not of averaging.
    """
    fraction = np.linspace(0, 1, 20, endpoint=False)[:, None]
    fine = np.concatenate([a + fraction * (b - a) for a, b in pairwise(line)])
    near = np.abs(points[:, None, 0] - fine[:, 0]) <= SHIFT
    off = np.abs(np.expm1(fine[:, 1] - points[:, None, 1]))
    return np.where(near, off, np.inf).min(axis=1)


def second_approximation(averaged: Isolator) -> SecondApproximation:
    """Of the same design, with the force (5)."""
    design = {name: getattr(averaged, name) for name in ("lam", "r", "delta_h", "mu", "zeta")}
    return Isolator(**design, force="untruncated").second_approximation


def approximate(
    iso: Isolator | SecondApproximation, mu: float, F_0: float, low_high: tuple[float, float], samples: int
) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """What an approximation says: largest amplitude and folds; and some points of its curve."""
    curve, folds = iso.frequency_response(F_0, samples=samples, Omega=low_high), iso.saddle_nodes(F_0)
    inside = (curve.Omega > 1.02 * low_high[0]) & (curve.Omega < 0.98 * low_high[1])
    some = np.flatnonzero(inside)[:: max(1, int(inside.sum()) // POINTS)]
    Omega, A = curve.Omega[some], curve.A[some]
    summary = {"A": float(curve.A.max(initial=0.0)), "kinds": folds.kind.tolist(), "Omega": folds.Omega.tolist()}
    return summary, {"Omega": Omega, "A": A, "stable": curve.stable[some], "rest": mu / (A * Omega**2)}


def compared(
    averaged: Isolator, F_0: float, low_high: tuple[float, float], second: SecondApproximation | None = None
) -> dict[str, Any]:
    """One averaged curve against the exact ones with both forces, the second approximation against that with (5)."""
    out: dict[str, Any]
    out, points = approximate(averaged, averaged.mu, F_0, low_high, 600)
    out["points"] = points
    if second is not None:
        # the first approximation's curves hold their peaks, the second's do not
        out["second"], out["second points"] = approximate(second, averaged.mu, F_0, low_high, 4000)
    for force in FORCES:
        exact = attempt(
            lambda force=force: whole(averaged.exact_response(F_0, Omega=low_high, step=STEP, force=FORCES[force]))
        )
        if exact is None:
            out[force] = None
            continue
        line = logs(exact.Omega, exact.A)
        at = logs(points["Omega"], points["A"])
        nearest = ((at[:, None, :] - line) ** 2).sum(axis=2).argmin(axis=1)
        out[force] = {
            "A": exact.peak.A,
            "kinds": [fold.kind for fold in exact.folds],
            "Omega": [fold.Omega for fold in exact.folds],
            "stops": int(exact.stops.max()),
            "stops at top": exact.peak.stops,
        }
        points[force] = misfit(at, line)
        points["stops"] = exact.stops[nearest]
        if second is not None and force == "exact":
            improved = out["second points"]
            improved["exact"] = misfit(logs(improved["Omega"], improved["A"]), line)
    return out


def jumps(found: dict[str, Any]) -> dict[str, float] | None:
    """The frequency of the one jump of each kind; None if there is another number of folds."""
    if sorted(found["kinds"]) != ["jump-down", "jump-up"]:
        return None
    return dict(zip(found["kinds"], found["Omega"], strict=True))


def resonance() -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """Errors of the largest amplitude and of both jumps, and the points of the curves."""
    cells, pool = [], []
    for delta_h in PRELOADS:
        u_cr = isolator(0, TABLE_1["zeta"], delta_h, 1.0).u_cr
        for zeta in ZETAS:
            for level in LEVELS:
                for ratio in RATIOS:
                    F_0, Omega = forcing(ratio, zeta, delta_h, level * u_cr)
                    averaged = isolator(ratio, zeta, delta_h, F_0)
                    found = compared(averaged, F_0, window(averaged, Omega), second_approximation(averaged))
                    cell = {"delta_h": delta_h, "zeta": zeta, "level": level, "ratio": ratio, "F_0": F_0}
                    for force in FORCES:
                        exact = found[force]
                        if exact is None:
                            continue
                        cell[force] = {"A": found["A"] / exact["A"] - 1, "stops": exact["stops"]}
                        cell[force]["folds"] = [len(found["kinds"]), len(exact["kinds"])]
                        mine, theirs = jumps(found), jumps(exact)
                        if mine and theirs:
                            cell[force] |= {kind: mine[kind] / theirs[kind] - 1 for kind in mine}
                    if found["exact"]:
                        cell["second"] = against(found["second"], found["exact"])
                    cells.append(cell)
                    pool.append({**cell, "u_cr": u_cr, **found["points"], "second points": found["second points"]})
    return cells, pool


def against(found: dict[str, Any], exact: dict[str, Any]) -> dict[str, Any]:
    """Errors of the second approximation, as those of averaging."""
    cell: dict[str, Any] = {"A": found["A"] / exact["A"] - 1, "folds": [len(found["kinds"]), len(exact["kinds"])]}
    mine, theirs = jumps(found), jumps(exact)
    return cell | {kind: mine[kind] / theirs[kind] - 1 for kind in mine} if mine and theirs else cell


def steepness(curve: Response) -> float:
    """Least Omega component of the unit tangent, by a parabola: negative where the curve folds.

    Raises ArithmeticError where that is at an end of the curve or at a change in the order of switches: no cusp nearby.
    """
    rate = np.array([point.tangent[-1] for point in curve.states])
    i = int(rate.argmin())
    if not 2 <= i < rate.size - 2 or any(point.role in ("border", "corner") for point in curve.states[i - 2 : i + 3]):
        raise ArithmeticError("no point of least steepness")
    # a fold is a point of its own beside its neighbours
    keep = [k for k in range(i - 2, i + 3) if k == i or curve.states[k].role != "fold"]
    s = np.array([float(curve.states[k].z[1]) for k in keep]) - float(curve.states[i].z[1])
    c, b, a = np.polynomial.polynomial.polyfit(s, rate[keep], 2)
    return float(c - b * b / (4 * a)) if a > 0 else float(rate[i])


def zero_near(function: Callable[[float], float], at: float) -> float | None:
    """The zero nearest to `at` of a function that rises with the forcing; it may jump there. None if none is found."""
    last, before = 1.0, attempt(lambda: function(at))
    if before is None:
        return None
    for factor in (0.985, 0.97, 0.94, 0.88, 0.8, 0.7) if before > 0 else (1.015, 1.03, 1.06, 1.12, 1.3, 1.7):
        there = attempt(lambda factor=factor: function(factor * at))
        if there is None:
            continue
        if before * there <= 0:
            return attempt(lambda: float(brentq(function, last * at, factor * at, xtol=1e-5 * at, rtol=1e-5)))  # noqa: B023
        last, before = factor, there
    return None


def with_ratio(critical: Callable[[float], float | None], ratio: float) -> tuple[float, float] | None:
    """(mu, critical forcing) where mu is that share of the averaged critical forcing."""
    if ratio == 0:
        value = critical(0.0)
        return None if value is None else (0.0, value)

    def excess(mu: float) -> float:
        value = critical(mu)
        return math.nan if value is None else mu - ratio * value

    high = 1e-5
    while excess(high) < 0:
        high *= 2
    if not math.isfinite(excess(high)):
        return None
    mu = brentq(excess, high / 2 if high > 1e-5 else 0.0, high, rtol=1e-12)
    value = critical(mu)
    return None if value is None else (mu, value)


def onsets() -> list[dict[str, Any]]:
    """Errors of F_SN and F_cr, mu being a share of the averaged one."""
    out = []
    for delta_h in PRELOADS:
        for zeta in ONSET_ZETAS:
            for ratio in ONSET_RATIOS:
                cell: dict[str, Any] = {"delta_h": delta_h, "zeta": zeta, "ratio": ratio}
                make = lambda mu, z=zeta, d=delta_h: example.isolator(delta_h=d, mu=mu, zeta=z)  # noqa: E731
                reached = with_ratio(lambda mu, make=make: make(mu).detachment().F_cr, ratio)
                if reached is not None:
                    cell["F_cr"] = detachment(make(reached[0]), reached[1])
                found = with_ratio(lambda mu, make=make: make(mu).saddle_node_onset().F_SN, ratio)
                if found is not None:
                    averaged = make(found[0])
                    cell["kind"] = averaged.saddle_node_onset().kind
                    cell["F_SN"] = onset(averaged, found[1])
                out.append(cell)
    return out


def onset(averaged: Isolator, F_SN: float) -> dict[str, float | None]:
    """Averaged F_SN over the exact one, less 1: where the exact curve becomes vertical, or gets folds at a corner."""
    Omega = float(averaged.saddle_node_onset().Omega or 1)
    out: dict[str, float | None] = {}
    for force in FORCES:

        def folded(F_0: float, force: str = force) -> float:
            window = (0.4 * Omega, 1.3 * Omega)
            curve = whole(averaged.exact_response(F_0, Omega=window, step=STEP, force=FORCES[force]))
            try:
                return -steepness(curve)
            except NotSettled:
                return 1.0 if curve.folds else -1.0

        exact = zero_near(folded, F_SN)
        out[force] = None if exact is None else F_SN / exact - 1
        if force == "exact" and exact is not None:
            better = second_approximation(averaged).saddle_node_onset().F_SN
            out["second"] = None if better is None else better / exact - 1
    return out


def detachment(averaged: Isolator, F_cr: float) -> dict[str, Any]:
    """Averaged F_cr over the exact one, less 1: where the peak of the exact curve without detachment is u_cr.

    The peak may be far from the resonance, where the mass stops within the cycle: stops there, with either force.
    """
    Omega = float(averaged.detachment().Omega_cr or 1)
    out: dict[str, Any] = {"stops": 0}
    for force in FORCES:
        attached = Force(averaged.restoring_force(FORCES[force]).pieces[:1], ())
        system = EquationOfMotion(attached, averaged.mu, averaged.zeta)

        def peak(F_0: float, system: EquationOfMotion = system) -> SteadyState:
            window = (0.5 * math.sqrt(averaged.alpha), 1.25 * Omega)
            return whole(exact_response(system, F_0, Omega=window, step=STEP)).peak

        exact = zero_near(lambda F_0, peak=peak: peak(F_0).A / averaged.u_cr - 1, F_cr)
        out[force] = None if exact is None else F_cr / exact - 1
        if exact is not None:
            out["stops"] = max(out["stops"], peak(exact).stops)
        if force == "exact" and exact is not None:
            better = second_approximation(averaged).detachment().F_cr
            out["second"] = None if better is None else better / exact - 1
    return out


def plane() -> list[dict[str, Any]]:
    """Table 1 at F_0 = 0.02 over frequency, down to low ones, and mu/F_0: amplitudes on the highest stable branch."""
    out = []
    Omega = np.linspace(*PLANE_WINDOW, 141)[1:-1]
    for ratio in PLANE_RATIOS:
        averaged = isolator(ratio, TABLE_1["zeta"], TABLE_1["delta_h"], PLANE_FORCING)
        row: dict[str, Any] = {"ratio": ratio}
        curve = attempt(
            lambda averaged=averaged: whole(
                averaged.exact_response(PLANE_FORCING, Omega=PLANE_WINDOW, step=STEP, force="untruncated")
            )
        )
        if curve is None:
            out.append(row)
            continue
        error, stops = [], []
        for at in Omega:
            highest, stop_count = upper(curve, float(at))
            states = averaged.amplitudes(Omega=at, F_0=PLANE_FORCING)
            A = states.A[states.stable]
            error.append(float(A.max()) / highest - 1 if A.size else math.nan)
            stops.append(stop_count)
        out.append({**row, "Omega": Omega.tolist(), "error": error, "stops": stops})
    return out


def upper(curve: Response, Omega: float) -> tuple[float, int]:
    """Highest stable amplitude of the exact curve at a frequency, and its stops."""
    best = (math.nan, 0)
    rising = curve.Omega
    for i in np.flatnonzero((rising[:-1] - Omega) * (rising[1:] - Omega) <= 0):
        if curve.stable[i] or curve.stable[i + 1]:
            fraction = (Omega - rising[i]) / (rising[i + 1] - rising[i]) if rising[i + 1] != rising[i] else 0.0
            A = float(curve.A[i] + fraction * (curve.A[i + 1] - curve.A[i]))
            if not A <= best[0]:
                best = (A, int(curve.stops[i]))
    return best


def truncation() -> list[dict[str, Any]]:
    """What (6) costs against (5), both exact, mu/F_0 = 0.3: largest amplitude and jump-down over u_cr and level.

    alpha = 1/2 as in Table 1 while the preload grows and the springs get softer: u_cr grows with it. Amplitudes < 1.
    """
    out = []
    for delta_h in TRUNCATION_PRELOADS:
        r = 0.5 / (TABLE_1["lam"] * delta_h)
        free = example.isolator(r=r, delta_h=delta_h, mu=0.0)
        for level in TRUNCATION_LEVELS:
            A = level * free.u_cr
            if A >= 1:
                continue
            Omega = float(free.backbone(A))
            F_0 = 2 * TABLE_1["zeta"] * A * Omega / (1 - 4 * 0.3 / math.pi)
            averaged = example.isolator(r=r, delta_h=delta_h, mu=0.3 * F_0)
            found = compared(averaged, F_0, window(averaged, Omega))
            cell: dict[str, Any] = {"delta_h": delta_h, "level": level, "u_cr": free.u_cr}
            if found["truncated"] and found["exact"]:
                cell["A"] = found["truncated"]["A"] / found["exact"]["A"] - 1
                cell["averaged"] = found["A"] / found["exact"]["A"] - 1
                one, other = jumps(found["truncated"]), jumps(found["exact"])
                if one and other:
                    cell["Omega"] = one["jump-down"] / other["jump-down"] - 1
            out.append(cell)
    return out


def table_2() -> list[dict[str, Any]]:
    """The paper's critical forcings and Table 2 by averaging, by the second approximation, and exact, with (5)."""
    design = TABLE_1
    averaged = Isolator(**design)
    ways = {"averaged (6)": averaged, "averaged (5)": Isolator(**design, force="untruncated")}
    ways["second (5)"] = second_approximation(averaged)
    onsets = {way: iso.saddle_node_onset().F_SN for way, iso in ways.items()}
    reached = {way: iso.detachment().F_cr for way, iso in ways.items()}
    out: list[dict[str, Any]] = []
    for name, values, measure in (("F_SN", onsets, onset), ("F_cr", reached, detachment)):
        first = values["averaged (6)"]
        off = measure(averaged, first)["exact"]
        out.append({"what": name, **values, "exact (5)": None if off is None else first / (1 + off)})
    for printed, F_0 in (("0.025", 0.025), ("0.030", 0.03), ("0.040", 0.04), ("0.050", 0.05)):
        found: dict[str, Any] = {way: iso.saddle_nodes(F_0) for way, iso in ways.items()}
        curve = averaged.exact_response(F_0, force="untruncated")
        for kind in ("jump-up", "jump-down"):
            for quantity in ("Omega", "A"):
                row = {"what": f"F_0 = {printed}, {kind}, {quantity}"}
                row |= {way: float(getattr(folds, quantity)[folds.kind == kind][0]) for way, folds in found.items()}
                (exact,) = (getattr(fold, quantity) for fold in curve.folds if fold.kind == kind)
                out.append({**row, "exact (5)": float(exact)})
    return out


def random() -> list[dict[str, Any]]:
    """Errors of mean and root mean squares of u, v under random excitation, and the margins of the records of motion.

    About a mean, which a load holds where it is; its error is in root mean squares of u.
    """
    stops = {
        name: functools.partial(derive.library(name), **RANDOM_STOPS) for name in ("elastic_stop", "one_sided_stop")
    }
    springs = {"isolator": example.isolator, "stops": stops["elastic_stop"], "one stop": stops["one_sided_stop"]}
    x, step = np.linspace(-10.0, 10.0, 40_001, retstep=True)
    density = np.exp(-0.5 * x**2) / math.sqrt(2 * math.pi) * step
    out = []
    for spring, means, levels, bands in RANDOM_MAPS:
        force = springs[spring](mu=0.0, zeta=RANDOM_ZETA).restoring_force()
        for mean, level, band, dry in itertools.product(means, levels, bands, RANDOM_SHARES):
            B, u = mean * force.first_ends[1], level * force.first_ends[1]
            f = force(B + u * x) * density
            k, load = float((x * f).sum()) / u, {} if force.odd and not mean else {"load": float(f.sum())}
            c = 2 * RANDOM_ZETA / (1 - dry)
            v, excitation = _exciting(u, k, c, band)
            mu = math.sqrt(math.pi / 2) * dry * c * v
            found = springs[spring](mu=mu, zeta=RANDOM_ZETA, **load).random(**excitation)
            record = found.measure(samples=RANDOM_SAMPLES, records=24)
            cell = {"spring": spring, "mean": mean, "level": level, "band": band, "dry": dry, "motions": len(found)}
            near = int(np.hypot(found.B - B, found.u_rms - u).argmin())
            # white noise has an exact density, which tells how far off the records are as well
            true, of = (found.fokker_planck if band == math.inf else record), found[near]
            for way, one in {"linearized": of, **({} if true is record else {"records": record})}.items():
                cell[way] = [one.u_rms / true.u_rms - 1, one.v_rms / true.v_rms - 1]
                if load:
                    cell[way].insert(0, (one.B - true.B) / true.u_rms)
            cell["margin"] = [record.u_margin / record.u_rms, record.v_margin / record.v_rms]
            if load:
                cell["margin"].insert(0, record.B_margin / record.u_rms)
                cell["marked"] = bool(found.message)
            out.append({**cell, "beyond": [of.beyond, true.beyond]})
    return out


def _exciting(u: float, k: float, c: float, band: float) -> tuple[float, dict[str, Any]]:
    """The root mean square of v, and the excitation of a linear oscillator in which that of u is what it is."""
    if band == math.inf:
        return math.sqrt(k) * u, {"S_0": c * k * u**2 / math.pi}
    Omega = math.sqrt(k) * np.geomspace(1 / band, band, 20_001)
    over_Z = 1 / linearization.response(Omega, k, c)[0]
    power, of_v = (float(np.trapezoid(over_Z * Omega**n, Omega)) for n in (0, 2))
    return u * math.sqrt(of_v / power), {"psd": (Omega[[0, -1]], [u**2 / power] * 2)}


def pooled(pool: list[dict[str, Any]]) -> dict[str, Any]:
    """Quantiles of the misfit of averaged points, by mu/F_0 and by mu/(A Omega^2)."""

    def flat(name: str) -> np.ndarray:
        return np.concatenate(
            [np.broadcast_to(p[name], p["A"].shape) for p in pool if "exact" in p and "truncated" in p]
        )

    ratio, rest, stops = flat("ratio"), flat("rest"), flat("stops") > 0
    size = {force: flat(force) for force in FORCES}
    row, column = (
        np.searchsorted(edges, values, side="right") - 1 for edges, values in ((BINS, ratio), (REST_BINS, rest))
    )

    def quantiles(chosen: np.ndarray, force: str = "exact") -> dict[str, Any]:
        return spread(size[force][chosen])

    followed = [p["second points"] for p in pool if "exact" in p["second points"]]
    again, sizes = (np.concatenate([points[name] for points in followed]) for name in ("rest", "exact"))
    again = np.searchsorted(REST_BINS, again, side="right") - 1

    return {
        "ratios": list(BINS),
        "rests": list(REST_BINS),
        "both": [[quantiles((row == i) & (column == j)) for j in range(len(REST_BINS))] for i in range(len(BINS))],
        "by ratio": [quantiles(row == i) for i in range(len(BINS))],
        "by rest": [
            {**quantiles(column == j), "stopping": float(stops[column == j].mean())} for j in range(len(REST_BINS))
        ],
        "second by rest": [spread(sizes[again == j]) for j in range(len(REST_BINS))],
        "moving": {force: quantiles(~stops, force) for force in FORCES},
        "stopping": {force: quantiles(stops, force) for force in FORCES},
        "least rest with stops": float(rest[stops].min()),
    }


def spread(sizes: np.ndarray) -> dict[str, Any]:
    """How many, and within what half and 95 of 100 of them lie."""
    found = [None, None] if sizes.size < FEW else np.quantile(sizes, (0.5, 0.95)).tolist()
    return {"points": int(sizes.size), "median": found[0], "q95": found[1]}


def table(numbers: dict[str, Any]) -> str:
    """What `slowflow.answers.validity` looks up, as a Python module."""
    pool = numbers["pool"]
    errors = {
        name: [[_filled(row, j, pool["by rest"][j], name) for j in range(len(REST_BINS))] for row in pool["both"]]
        for name in ("median", "q95")
    }
    by_ratio = [cell["q95"] for cell in pool["by ratio"]]
    cells = numbers["truncation"]
    u_crs = sorted({cell["u_cr"] for cell in cells})
    levels = [level for level in TRUNCATION_LEVELS if all(_size(cells, u_cr, level) is not None for u_cr in u_crs)]
    sizes = [[_size(cells, u_cr, level) for level in levels] for u_cr in u_crs]

    measured = [json.dumps(example.isolator(force=force).model.mechanism.name) for force in FORCES.values()]

    def line(name: str, values: Any) -> str:
        return f"{name} = ({', '.join(f'{value:.3g}' for value in values)})"

    def lines(name: str, rows: Any) -> list[str]:
        return [f"{name} = (", *(f"    ({', '.join(f'{value:.3g}' for value in row)})," for row in rows), ")"]

    return "\n".join(
        [
            '"""Measured errors of averaging, for `validity`: a bin begins at its edge and ends at the next.',
            "",
            "Written by `make validity` from benchmarks/results/validity.json; never edit. Method: docs/validity.md.",
            '"""',
            "",
            "# fmt: off",
            "",
            "# the mechanisms that were measured, by name",
            f"MECHANISMS = ({', '.join(measured)})",
            "# edges of mu/F_0 and of mu/(A Omega^2)",
            line("RATIOS", BINS),
            line("STOPPING", REST_BINS),
            "# the exact amplitude of half and of 95 in 100 points lies within this; rows: RATIOS, columns: STOPPING",
            *lines("TYPICAL", errors["median"]),
            *lines("ERROR", errors["q95"]),
            "# the same whatever mu/(A Omega^2)",
            line("BY_RATIO", by_ratio),
            "# the same whatever mu/F_0, in the second approximation",
            line("SECOND_BY_REST", [_known(pool["second by rest"], j) for j in range(len(REST_BINS))]),
            "# mu/F_0 from which on every answer is remarked on; mu/(A Omega^2) from which on stops were found",
            f"NEAR = {validity_page.remarked_from(pool):g}",
            f"STOPS_FROM = {math.floor(10 * pool['least rest with stops']) / 10:g}",
            "# what (6) costs against (5): a row for each of U_CRS, a column for each A/u_cr of LEVELS",
            line("U_CRS", u_crs),
            line("LEVELS", levels),
            *lines("TRUNCATION", sizes),
            "",
        ]
    )


def _known(row: list[dict[str, Any]], column: int) -> float:
    """A bin's error, or where it has few points that of the last bin before it that has not."""
    return float(next(cell["q95"] for cell in row[column::-1] if cell["q95"] is not None))


def _filled(row: list[dict[str, Any]], column: int, whole: dict[str, Any], name: str) -> float:
    """A bin's error; one with few points gets the larger of its nearest neighbour's and what all ratios have there."""
    known = [j for j, cell in enumerate(row) if cell[name] is not None]
    nearest = min(known, key=lambda j: abs(j - column))
    return float(row[column][name] if nearest == column else max(row[nearest][name], whole[name]))


def _size(cells: list[dict[str, Any]], u_cr: float, level: float) -> float | None:
    for cell in cells:
        if cell["u_cr"] == u_cr and cell["level"] == level and "A" in cell:
            return max(abs(cell["A"]), abs(cell.get("Omega", 0.0)))
    return None


def measure() -> dict[str, Any]:
    """Everything."""
    start = time.process_time()
    cells, pool = resonance()
    numbers = {
        "integrator": "taylor",
        "resonance": cells,
        "pool": pooled(pool),
        "onsets": onsets(),
        "plane": plane(),
        "truncation": truncation(),
        "table 2": table_2(),
        "random": random(),
    }
    print(f"measured in {time.process_time() - start:.0f} s of processor time")
    return numbers


def rounded(value: Any) -> Any:
    """Six digits are more than the maps need, and keep the file small; nan becomes null."""
    if isinstance(value, dict):
        return {key: rounded(inner) for key, inner in value.items()}
    if isinstance(value, list | tuple | np.ndarray):
        return [rounded(inner) for inner in value]
    if isinstance(value, float | np.floating):
        return float(f"{value:.6g}") if math.isfinite(value) else None
    return value.item() if isinstance(value, np.generic) else value


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--draw", action="store_true", help="from the numbers that are there")
    if not parser.parse_args().draw:
        RESULTS.write_text(json.dumps(rounded(measure()), indent=1) + "\n")
    numbers = json.loads(RESULTS.read_text())
    TABLE.write_text(table(numbers))
    validity_page.write(numbers, ROOT / "docs")


if __name__ == "__main__":
    main()
