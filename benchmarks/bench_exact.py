"""The exact motion against its targets, on Table 1 with F_0 = 0.04 unless a row says otherwise.

`rows()` gives one `Row` per target: what was measured, the bound, whether it is kept.
`python -m benchmarks.bench_exact` prints them and writes benchmarks/results/exact.json and docs/benchmarks.md;
`--direct` adds Appendix A's direct integration, which takes a minute.
"""

from __future__ import annotations

import argparse
import importlib.util
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from functools import partial
from typing import Any

import mpmath as mp
import numpy as np
from scipy.optimize import minimize_scalar, root

from benchmarks import document, environment, footprint
from examples.paper.smoothed import direct_integration
from slowflow import example
from slowflow.exact import EquationOfMotion, Response, exact_response, linear, steady_state, sweep
from slowflow.exact.motion import TURN, Forced, advance, follow
from slowflow.example import TABLE_1
from slowflow_kernels import den_hartog
from tests.oracles import exact_linear, exact_reference
from tests.oracles.exact_cases import isolator, table_1
from tests.oracles.exact_reference import ScipyIntegrator, again, drive_of
from tests.oracles.exact_scipy import half_turn

FORCINGS = (0.025, 0.03, 0.0301, 0.04, 0.05)
#: a job that `benchmarks.counted` takes apart, and its frequency
TURNS, OMEGA = "200 periods of the forcing with all events", 0.9
NAMES = {False: "truncated (6)", True: "untruncated (5)"}


@dataclass(frozen=True)
class Row:
    """One figure: `bound` is None where there is no target."""

    job: str
    measured: float
    unit: str
    bound: float | None = None

    @property
    def kept(self) -> bool:
        return self.bound is None or self.measured <= self.bound


def best(job: Callable[[], object], repeats: int = 7) -> float:
    """Median time of a call in seconds of this process (the machine may be shared), after one that warms the caches."""
    job()
    times = []
    for _ in range(repeats):
        start = time.process_time()
        job()
        times.append(time.process_time() - start)
    return float(np.median(times))


def rows() -> list[Row]:
    """Everything but Appendix A."""
    out: list[Row] = []
    curves = {(exact, F_0): exact_response(table_1(exact), F_0) for exact in NAMES for F_0 in FORCINGS}
    for exact in NAMES:
        out += (
            one_frequency(exact) + whole_curve(exact, curves[exact, 0.04]) + approximations(exact, curves[exact, 0.04])
        )
    wrong = sum([f.kind for f in curve.folds] != ["jump-up", "jump-down"] for curve in curves.values())
    out.append(Row("curves of 10 (5 forcings, 2 forces) whose folds are not one of each kind", wrong, "", 0))
    out += fold_count_by_amplitude(curves)
    for exact in NAMES:
        out += sweeps(exact, curves[exact, 0.04])
    return [*out, *beside_heyoka(), *first_answer(), *closed_forms(), *turns()]


@dataclass(frozen=True)
class Job:
    """What a user waits for: `bound` in milliseconds, None where there is none; `other`: the same by an integrator."""

    name: str
    bound: float | None
    repeats: int
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
            *(None, 101),
            lambda: advance(forced, -1, 0, 0.3, -0.25, 0.0, 3.4),
            lambda i: i.advance(system.force.pieces[0], drive, 0.3, -0.25, 0.0, 3.4),
        ),
        Job(
            "one periodic motion with multipliers from the neighbouring one",
            *(0.1, 51),
            lambda: steady_state(system, near, Omega=0.9, F_0=0.04),
            lambda i: again(replace(near, Omega=0.9, unknowns=np.append(near.unknowns[:-1], 0.9)), i),
        ),
        Job(
            "curve of 300 points, stability, stops, folds",
            *(25.0, 3),
            lambda: exact_response(system, 0.04, step=0.0265),
        ),
        Job(
            "the same without friction",
            *(75.0, 3),
            lambda: exact_response(free, 0.04, step=0.0265),
        ),
        Job(
            "the same of the linear oscillator through ten stops, Omega from 0.07 to 0.5",
            *(75.0, 3),
            lambda: exact_response(stops, 1.0, Omega=(0.07, 0.5)),
        ),
        Job(
            TURNS,
            *(1.0, 5),
            lambda: follow(Forced(system, OMEGA, 0.04), 0.0, 0.0, 0.0, 200 * TURN),
            lambda i: exact_reference.follow(Forced(system, OMEGA, 0.04), i, 0.0, 0.0, 0.0, 200 * TURN),
        ),
        Job(
            "sweep up and down, 600 frequencies",
            *(200.0, 1),
            lambda: sweep(system, Omega=frequencies, F_0=0.04),
        ),
    ]


def by_stops(repeats: int) -> list[dict[str, float]]:
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
        seconds = best(partial(steady_state, system, near, Omega=Omega, F_0=1.0), repeats)
        out.append({"stops": int(count), "Omega": Omega, "seconds": seconds})
    return out


def in_turn(most: int = 101) -> list[tuple[Job, float, float | None]]:
    """The jobs that users wait for, and their seconds by the compiled integrator and by heyoka, repeats `most` at most.

    None where that is not done by heyoka, or it has no wheels. All around its integration is Python; the first job is
    the integration alone.
    """
    other: Any = None
    if importlib.util.find_spec("heyoka"):
        from benchmarks.exact_heyoka import HeyokaIntegrator

        other = HeyokaIntegrator()
    out = []
    for job in jobs():
        count, by = min(job.repeats, most), job.other
        theirs = None if other is None or by is None else best(partial(by, other), count)
        out.append((job, best(job.run, count), theirs))
    return out


def beside_heyoka() -> list[Row]:
    """The same in rows."""
    out = []
    for job, ours, theirs in in_turn():
        out.append(Row(job.name, 1e3 * ours, "ms", job.bound))
        if theirs is not None:
            out.append(Row(f"{job.name}: time of heyoka over that of slowflow", theirs / ours, ""))
    return [*out, *measured()]


def measured() -> list[Row]:
    """`answer.measure()`: a state's averaged amplitude compared with the motion that it leads to."""
    states = example.isolator(force="untruncated").amplitudes(Omega=np.linspace(0.5, 1.5, 300), F_0=0.04)
    return [
        Row(
            "error of an averaged result by the equation of motion, per state",
            1e3 * best(states.measure, 3) / len(states),
            "ms",
            0.2,
        )
    ]


def first_answer() -> list[Row]:
    """A fresh process, from its start to a periodic motion."""
    code = "from slowflow.example import isolator; isolator().steady_state(Omega=0.9, F_0=0.04)"
    footprint.fresh(code)  # bytecode written, files in the cache
    times = []
    for _ in range(3):
        start = time.perf_counter()
        footprint.fresh(code)
        times.append(time.perf_counter() - start)
    return [Row("first answer of a fresh process, import included", min(times), "s", 0.15)]


def one_frequency(exact: bool) -> list[Row]:
    """From the steady state 0.1 % away, and from an amplitude and a phase."""
    system, name = table_1(exact), NAMES[exact]
    out, residuals = [], []
    times, cold = [], []
    for Omega in (0.6, 0.8, 0.9, 0.95, 1.2):
        state = steady_state(system, Omega=Omega, F_0=0.04)
        near = steady_state(system, state, Omega=1.001 * Omega, F_0=0.04)
        times.append(best(lambda near=near, Omega=Omega: steady_state(system, near, Omega=Omega, F_0=0.04)))
        guess = (1.05 * state.A, 0.05 - float(state.unknowns[1]))
        cold.append(best(lambda guess=guess, Omega=Omega: steady_state(system, guess, Omega=Omega, F_0=0.04)))
        residuals.append(state.residual)
    top = steady_state(system, (0.6, -1.3), Omega=0.98, F_0=0.04)
    near = steady_state(system, top, Omega=0.981, F_0=0.04)
    times.append(best(lambda: steady_state(system, near, Omega=0.98, F_0=0.04)))
    residuals.append(top.residual)
    out.append(
        Row(f"{name}: one frequency from the neighbouring steady state, slowest of 6", 1e3 * max(times), "ms", 2)
    )
    out.append(Row(f"{name}: one frequency from amplitude and phase 5 % off, slowest of 5", 1e3 * max(cold), "ms", 2))
    out.append(Row(f"{name}: residual of periodicity, largest of 6", max(residuals), "", 1e-12))
    return out


def whole_curve(exact: bool, curve: Response) -> list[Row]:
    """Time, residual on every point, and the folds three ways."""
    system, name = table_1(exact), NAMES[exact]
    elapsed = best(lambda: exact_response(system, 0.04), 5)
    states = [curve.steady_state(i) for i in range(curve.Omega.size)]
    touching = [i for i, point in enumerate(curve.states) if point.role in ("border", "corner")]
    elsewhere = max(state.residual for i, state in enumerate(states) if i not in touching)
    fine = exact_response(system, 0.04, step=0.007)
    by_step = max(max(abs(a.Omega - b.Omega), abs(a.A - b.A)) for a, b in zip(curve.folds, fine.folds, strict=True))
    multiplier = max(
        float(np.min(np.abs(state.half_multipliers - 1)))
        for state, point in zip(states, curve.states, strict=True)
        if point.role == "fold"
    )
    independent = max(abs(fold_by_amplitude(exact, 0.04, fold.A, curve) - fold.Omega) for fold in curve.folds)
    return [
        Row(f"{name}: whole curve of {curve.Omega.size} points with both folds", elapsed, "s", 0.5),
        Row(f"{name}: the same, for 300 points", elapsed * 300 / curve.Omega.size, "s", 0.5),
        Row(
            f"{name}: residual of periodicity, largest on the curve except where it touches u_cr", elsewhere, "", 1e-12
        ),
        # not Lipschitz there if the force jumps: a rounding grows to its square root at every touch
        Row(f"{name}: the same where it touches u_cr", max(states[i].residual for i in touching), ""),
        Row(f"{name}: folds (Omega, A) against a curve of a third of the step", by_step, "", 1e-8),
        Row(f"{name}: |multiplier - 1| at the folds", multiplier, ""),
        Row(f"{name}: Omega of the folds against SciPy's extremum of Omega(A)", independent, "", 1e-8),
    ]


def approximations(exact: bool, curve: Response) -> list[Row]:
    """Averaging and the second approximation beside that curve: time, and the jumps' frequencies."""
    name = NAMES[exact]
    iso = example.isolator(force="untruncated" if exact else "truncated")
    out = []
    for title, approximation in (("averaging", iso), ("second approximation", iso.second_approximation)):
        job = lambda a=approximation: (a.frequency_response(0.04), a.saddle_nodes(0.04))  # noqa: E731
        folds = approximation.saddle_nodes(0.04)
        pairs = zip(folds.Omega, sorted(fold.Omega for fold in curve.folds), strict=True)
        out += [
            Row(f"{name}: {title}, curve of 1000 points with both folds", 1e3 * best(job), "ms"),
            Row(
                f"{name}: {title}, the jumps' frequencies, larger relative error",
                max(abs(a / b - 1) for a, b in pairs),
                "",
            ),
        ]
    return out


def frequency_at(exact: bool, F_0: float, A: float, guess: tuple[float, float]) -> float:
    """Omega of the motion of amplitude A near the guess (theta, Omega): no continuation, no C in it."""
    force, (u_cr,) = isolator(**TABLE_1, exact=exact)[1]

    def mirrored(x: np.ndarray) -> tuple[float, float]:
        u, v = half_turn(A, x[0], x[1], F_0, TABLE_1["mu"], TABLE_1["zeta"], force, u_cr)
        return u + A, v

    return float(root(mirrored, guess, tol=1e-13).x[1])


def fold_by_amplitude(exact: bool, F_0: float, A: float, curve: Response) -> float:
    """The extremum of Omega(A) next to A."""
    index = int(np.argmin(np.abs(curve.A - A) + np.array([p.role != "fold" for p in curve.states])))
    z = curve.states[index].z
    sign = 1 if curve.folds[0].A == curve.A[index] else -1
    found = minimize_scalar(
        lambda at: sign * frequency_at(exact, F_0, at, (float(z[1]), float(z[-1]))),
        bounds=(0.99 * A, 1.01 * A),
        method="bounded",
        options={"xatol": 1e-7},
    )
    return sign * float(found.fun)


def fold_count_by_amplitude(curves: dict[tuple[bool, float], Response]) -> list[Row]:
    """Turns of Omega(A), solved for at the amplitudes of every second point, against the folds that were found."""
    wrong, worst = 0, 0.0
    for (exact, F_0), curve in curves.items():
        top, count = int(np.argmax(curve.A)), 0
        for part in (slice(0, top - 1), slice(top + 2, None)):
            points = [p for p in curve.states[part] if p.A > 0.12][::2]
            found = [
                frequency_at(exact, F_0, float(p.z[0]), (float(p.z[1]) + 1e-5, float(p.z[-1]) + 1e-5)) for p in points
            ]
            worst = max(worst, *(abs(a - float(p.z[-1])) for a, p in zip(found, points, strict=True)))
            count += np.flatnonzero(np.diff(np.sign(np.diff(found)))).size
        wrong += count != len(curve.folds)
    return [
        Row("curves of 10 with another number of folds when solved amplitude by amplitude with SciPy", wrong, "", 0),
        Row("largest difference of Omega between the two, on all ten curves", worst, "", 1e-9),
    ]


def sweeps(exact: bool, curve: Response) -> list[Row]:
    """300 frequencies up and down; a jump must happen within the step that holds the fold."""
    system, name = table_1(exact), NAMES[exact]
    Omega = np.linspace(0.5, 1.5, 300)
    start = time.perf_counter()
    rising, falling = sweep(system, Omega=Omega, F_0=0.04), sweep(system, Omega=Omega[::-1], F_0=0.04)
    elapsed = time.perf_counter() - start
    up, down = curve.folds
    astray = 0
    for found, fold in ((rising, down), (falling, up)):
        astray += len(found.jumps) != 1
        astray += not any(min(jump) <= fold.Omega <= max(jump) for jump in found.jumps)
    return [
        Row(f"{name}: sweep up and down, 300 frequencies each, settled to 1e-9", elapsed, "s"),
        Row(f"{name}: jumps that miss the step with the fold", astray, "", 0),
    ]


def closed_forms() -> list[Row]:
    """Den Hartog's (35) where (36) holds, and closed forms between the switches where it does not."""
    continuous, count = 0.0, 0
    for ratio in np.linspace(0.05, 0.95, 19):
        system = EquationOfMotion(linear(), float(ratio), 0.0)
        for Omega in np.linspace(0.52, 1.98, 40):
            S = float(np.max(den_hartog.S_ratio(np.linspace(0, np.pi / Omega, 2001)[1:-1], Omega)))
            with np.errstate(invalid="ignore"):
                A = float(den_hartog.amplitude(Omega, 1.0, ratio))
            if A > 1.0001 * float(den_hartog.bound(Omega, 1.0, S)):
                continuous = max(continuous, abs(steady_state(system, Omega=float(Omega), F_0=1.0).A - A) / max(A, 1.0))
                count += 1
    stopping, most = 0.0, 0
    for Omega, mu in ((0.75, 0.85), (0.45, 0.7), (0.21, 0.3), (0.12, 0.2), (0.06, 0.2), (0.06, 0.25)):
        state = steady_state(EquationOfMotion(linear(), mu, 0.0), Omega=Omega, F_0=1.0)
        with mp.workdps(40):
            start = mp.mpf(float(state.unknowns[1])) / mp.mpf(Omega)
            u, _, _ = exact_linear.one_turn(
                mp.mpf(Omega), mp.mpf(1), mp.mpf(mu), start, mp.mpf(float(state.unknowns[0])), -1
            )
        stopping, most = max(stopping, abs(float(u) - float(state.unknowns[0]))), max(most, state.stops)
    return [
        Row(f"Den Hartog's (35) where (36) holds, {count} points", continuous, "", 1e-10),
        Row(f"linear with 2 to {most} stops per period against 40 digits", stopping, "", 1e-10),
    ]


def turns() -> list[Row]:
    """200 turns at one frequency, with events."""
    forced = Forced(table_1(False), 0.9, 0.04)
    out = [
        Row("200 periods at Omega = 0.9, events", 1e3 * best(lambda: follow(forced, 0.0, 0.0, 0.0, 200 * TURN)), "ms")
    ]
    state = steady_state(table_1(False), Omega=0.9, F_0=0.04)
    other = again(state, ScipyIntegrator())
    out.append(Row("one frequency by SciPy", 1e3 * best(lambda: again(state, ScipyIntegrator()), 3), "ms"))
    out.append(Row("amplitude by SciPy less that by the compiled integrator", abs(other.A - state.A), "", 1e-9))
    return out


def direct() -> list[Row]:
    """Appendix A: nu = 1000, 200 turns, the last 100; untruncated force."""
    out = []
    system = table_1(True)
    for Omega in (0.6, 0.85, 0.95, 1.1):
        exact = steady_state(system, Omega=Omega, F_0=0.04)
        start = time.perf_counter()
        loose = direct_integration(system, Omega, 0.04)
        elapsed = time.perf_counter() - start
        tight = direct_integration(system, Omega, 0.04, rtol=1e-6, atol=1e-9, turns=100, kept=5)
        out += [
            Row(f"Appendix A at Omega = {Omega}: time", elapsed, "s"),
            Row(f"Appendix A at Omega = {Omega}: largest sample / A - 1", loose.A_sampled / exact.A - 1, ""),
            Row(f"Appendix A at Omega = {Omega}: turning points / A - 1", loose.A / exact.A - 1, ""),
            Row(f"Appendix A at Omega = {Omega}: bias of the smoothing alone", tight.A / exact.A - 1, ""),
        ]
    return out


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--direct", action="store_true", help="Appendix A's direct integration too")
    parser.add_argument("--busy", action="store_true", help="say on the page that other work kept the machine busy")
    arguments = parser.parse_args()
    found = [{**asdict(row), "kept": row.kept} for row in rows() + (direct() if arguments.direct else [])]
    print("\n".join(document.exact_table(found)))
    busy = {"earlier": document.BUSY} if arguments.busy else {}
    document.save(document.RESULTS / "exact.json", {"environment": environment.describe(), **busy, "rows": found})
    document.write()


if __name__ == "__main__":
    main()
