"""Exact motions of Table 1 with F_0 = 0.04: times and residuals, and jobs for `benchmarks.questions`."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from benchmarks.document import Row, quantity
from benchmarks.remote import medians
from slowflow import example
from slowflow.exact import EquationOfMotion, Response, exact_response, linear, steady_state, sweep
from slowflow.exact.motion import TURN, Forced, advance, follow
from tests.oracles.exact_cases import table_1
from tests.oracles.exact_reference import drive_of, solved

NAMES = {False: "truncated (6)", True: "untruncated (5)"}


def median(job: Callable[[], object], rounds: int) -> float:
    """Median seconds of one call."""
    return medians({"": job}, rounds)[""]


def measure(rounds: int) -> list[dict[str, Any]]:
    """Rows for both forces."""
    rows = [row for exact in NAMES for row in (*one_frequency(exact, rounds), *whole_curve(exact, rounds))]
    return [asdict(row) for row in [*rows, *(row for exact in NAMES for row in sweeps(exact, rounds))]]


@dataclass(frozen=True)
class Job:
    """What a user waits for; `other`: the same by another integrator."""

    name: str
    rounds: int
    run: Callable[[], object]
    other: Callable[[Any], object] | None = None


def jobs() -> list[Job]:
    """On Table 1 with F_0 = 0.04, untruncated force, but for the linear oscillator with many stops."""
    system = table_1(True)
    free, stops = EquationOfMotion(system.force, 0.0, system.zeta), EquationOfMotion(linear(), 0.2, 0.0)
    near = steady_state(system, steady_state(system, Omega=0.9, F_0=0.04), Omega=0.901, F_0=0.04)
    forced = Forced(system, 0.9, 0.04)
    drive = drive_of(forced, -1, 0)
    frequencies = np.concatenate((np.linspace(0.5, 1.5, 300), np.linspace(1.5, 0.5, 300)))
    return [
        Job(
            "half a period of one piece with derivatives",
            101,
            lambda: advance(forced, -1, 0, 0.3, -0.25, 0.0, 3.4),
            lambda i: i.advance(system.force.pieces[0], drive, 0.3, -0.25, 0.0, 3.4),
        ),
        Job(
            "one periodic motion with Floquet multipliers, from a neighbouring one",
            51,
            lambda: steady_state(system, near, Omega=0.9, F_0=0.04),
            lambda i: solved(replace(near, Omega=0.9, unknowns=np.append(near.unknowns[:-1], 0.9)), i),
        ),
        Job("curve of 300 points, stability, stops, folds", 3, lambda: exact_response(system, 0.04, step=0.0265)),
        Job("curve without friction", 3, lambda: exact_response(free, 0.04, step=0.0265)),
        Job(
            "curve of a linear oscillator with up to ten stops per period, Omega from 0.07 to 0.5",
            3,
            lambda: exact_response(stops, 1.0, Omega=(0.07, 0.5)),
        ),
        Job(
            "integration of 200 periods with all events",
            5,
            lambda: follow(forced, 0.0, 0.0, 0.0, 200 * TURN),
        ),
        Job("sweep up and down, 600 frequencies", 1, lambda: sweep(system, Omega=frequencies, F_0=0.04)),
    ]


def by_job(rounds: int) -> list[Row]:
    """The jobs, `rounds` times at most, in turn with heyoka where that does them and is installed.

    All around heyoka's integration is Python; the first job is the integration alone.
    """
    other: Any = None
    if importlib.util.find_spec("heyoka"):
        from benchmarks.exact_heyoka import HeyokaIntegrator

        other = HeyokaIntegrator()
    rows = []
    for job in jobs():
        calls: dict[str, Callable[[], object]] = {"slowflow": job.run}
        if other is not None and job.other is not None:
            calls["heyoka"] = partial(job.other, other)
        ours, *theirs = medians(calls, min(job.rounds, rounds)).values()
        comparison = "".join(f"heyoka {quantity(seconds, 's')}, {seconds / ours:.3g} ×" for seconds in theirs)
        rows.append(Row(f"exact: {job.name}", ours, "s", comparison))
    return rows


def by_stops(rounds: int) -> list[dict[str, float]]:
    """Seconds of one periodic motion with multipliers by stops per period: linear, mu = 0.2, F_0 = 1, and ever slower.

    Each is taken at the middle of the frequencies that have so many, from the neighbouring motion.
    """
    system = EquationOfMotion(linear(), 0.2, 0.0)
    curve = exact_response(system, 1.0, Omega=(0.03, 0.5))
    out = []
    for count in np.unique(curve.stops):
        positions = np.flatnonzero(curve.stops == count)
        middle = int(positions[len(positions) // 2])
        Omega, near = float(curve.Omega[middle]), curve.steady_state(middle - 1)
        seconds = median(partial(steady_state, system, near, Omega=Omega, F_0=1.0), rounds)
        out.append({"stops": int(count), "Omega": Omega, "seconds": seconds})
    return out


def one_frequency(exact: bool, rounds: int) -> list[Row]:
    """From the steady state 0.1 % away, and from an amplitude and a phase."""
    system, name = table_1(exact), NAMES[exact]
    states = [steady_state(system, Omega=Omega, F_0=0.04) for Omega in (0.6, 0.8, 0.9, 0.95, 1.2)]
    top = steady_state(system, (0.6, -1.3), Omega=0.98, F_0=0.04)

    def slowest(starts: list[tuple[Any, Any]]) -> float:
        return max(
            median(partial(steady_state, system, start, Omega=state.Omega, F_0=0.04), rounds) for state, start in starts
        )

    near = [(state, steady_state(system, state, Omega=1.001 * state.Omega, F_0=0.04)) for state in (*states, top)]
    off = [(state, (1.05 * state.A, 0.05 - float(state.unknowns[1]))) for state in states]
    residual = max(state.residual for state in (*states, top))
    return [
        Row(f"{name}: one frequency, from a neighbouring steady state, slowest of 6", slowest(near), "s"),
        Row(f"{name}: one frequency from amplitude and phase 5 % off, slowest of 5", slowest(off), "s"),
        Row(f"{name}: residual of periodicity, largest of 6", residual, ""),
    ]


def residuals(curve: Response) -> tuple[float, float]:
    """Largest residual of periodicity elsewhere, and where the curve touches u_cr.

    Where the force jumps it is not Lipschitz there: a rounding grows to its square root at every touch.
    """
    touches = np.array([point.role in ("border", "corner") for point in curve.states])
    sizes = np.array([curve.steady_state(i).residual for i in range(curve.Omega.size)])
    return float(sizes[~touches].max()), float(sizes[touches].max())


def whole_curve(exact: bool, rounds: int) -> list[Row]:
    """Time, residuals and folds of the curve, and its approximations by averaging."""
    system, name = table_1(exact), NAMES[exact]
    curve, fine = exact_response(system, 0.04), exact_response(system, 0.04, step=0.007)
    seconds = median(lambda: exact_response(system, 0.04), rounds)
    elsewhere, touching = residuals(curve)
    by_step = max(max(abs(a.Omega - b.Omega), abs(a.A - b.A)) for a, b in zip(curve.folds, fine.folds, strict=True))
    at_folds = [i for i, point in enumerate(curve.states) if point.role == "fold"]
    multiplier = max(float(np.min(np.abs(curve.steady_state(i).half_multipliers - 1))) for i in at_folds)
    rows = [
        Row(f"{name}: curve of {curve.Omega.size} points with both folds", seconds, "s"),
        Row(f"{name}: curve with both folds, time for 300 points", seconds * 300 / curve.Omega.size, "s"),
        Row(f"{name}: residual of periodicity, largest on the curve except where it touches u_cr", elsewhere, ""),
        Row(f"{name}: residual of periodicity where the curve touches u_cr", touching, ""),
        Row(f"{name}: folds (Omega, A) against a curve of a third of the step", by_step, ""),
        Row(f"{name}: |multiplier - 1| at the folds", multiplier, ""),
    ]
    iso = example.isolator(force="untruncated" if exact else "truncated")
    for title, approximation in (("averaging", iso), ("second approximation", iso.second_approximation)):
        job = lambda a=approximation: (a.frequency_response(0.04), a.saddle_nodes(0.04))  # noqa: E731
        pairs = zip(approximation.saddle_nodes(0.04).Omega, sorted(fold.Omega for fold in curve.folds), strict=True)
        off = max(abs(a / b - 1) for a, b in pairs)
        rows.append(Row(f"{name}: {title}, curve of 1000 points with both folds", median(job, rounds), "s"))
        rows.append(Row(f"{name}: {title}, the jumps' frequencies, larger relative error", off, ""))
    return rows


def sweeps(exact: bool, rounds: int) -> list[Row]:
    """300 frequencies up and down."""
    system, Omega = table_1(exact), np.linspace(0.5, 1.5, 300)
    job = lambda: [sweep(system, Omega=at, F_0=0.04) for at in (Omega, Omega[::-1])]  # noqa: E731
    return [Row(f"{NAMES[exact]}: sweep up and down, 300 frequencies each, settled to 1e-9", median(job, rounds), "s")]
