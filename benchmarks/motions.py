"""The motion that a mass at rest comes to, by integrators, for the work-precision diagram: Table 1, Omega = 0.9.

    slowflow            Newton's iteration on the periodic motion; or 200 turns of the forcing followed, every switch
    heyoka, events      Taylor series, the friction turned round by a terminal event
    DOP853, LSODA, Radau  SciPy's, begun anew where an event tells that the velocity vanishes
    the paper's recipe  (A1), (A2): friction and detachment smoothed, a stiff solver

All but Newton's iteration follow 200 turns and read the amplitude off the last ones. This motion has no rest and keeps
to the first piece of the force, untruncated, so that each integrator has the simplest problem. `prepare` makes jobs for
`benchmarks.remote`, named "motion | method | variant".
"""

from __future__ import annotations

import importlib.util
import math
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from examples.paper.smoothed import direct_integration
from slowflow.exact import steady_state
from slowflow.exact.motion import TURN, Forced, follow
from slowflow.example import TABLE_1, isolator

OMEGA, F_0, TURNS, LAST = 0.9, 0.04, 200, 4
MU, ZETA = TABLE_1["mu"], TABLE_1["zeta"]
ISOLATOR = isolator(force="untruncated")
SYSTEM = ISOLATOR.equation_of_motion()
END = TURNS * TURN / OMEGA
RTOLS = {"DOP853": (1e-4, 1e-7, 1e-10), "LSODA": (1e-4, 1e-7, 1e-10), "Radau": (1e-4, 1e-7)}


def followed() -> float:
    """By the package's own integrator."""
    forced = Forced(SYSTEM, OMEGA, F_0)
    return max(abs(phase.u_end) for phase in follow(forced, 0.0, 0.0, 0.0, TURNS * TURN)[-LAST:-1])


def by_scipy(method: str, rtol: float) -> float:
    """By one of SciPy's integrators, from stop to stop."""
    alpha, beta = ISOLATOR.alpha, ISOLATOR.beta

    def field(t: float, y: np.ndarray, friction: float) -> tuple[float, float]:
        u, v = y
        force = u * (alpha + 2.0 * beta * (1.0 / math.sqrt(1.0 - u * u) - 1.0))
        return v, F_0 * math.cos(OMEGA * t) - force - 2.0 * ZETA * v - friction

    def stop(t: float, y: np.ndarray, friction: float) -> float:
        return float(y[1])

    stop.terminal = True  # type: ignore[attr-defined]
    t, y, slip = 0.0, np.zeros(2), 1.0
    heights = []
    while True:
        stop.direction = -slip  # type: ignore[attr-defined]
        run = solve_ivp(field, (t, END), y, method, events=stop, args=(slip * MU,), rtol=rtol, atol=1e-2 * rtol)
        t, y = float(run.t[-1]), run.y[:, -1]
        if run.status != 1:
            return max(heights[-LAST:])
        heights.append(abs(float(y[0])))
        y[1], slip = 0.0, -slip


def by_heyoka(tolerance: float) -> Callable[[], float]:
    """By heyoka with a terminal event; what it compiles is compiled before the clock runs."""
    import heyoka as hy

    u, v = hy.make_vars("u", "v")
    force = u * (ISOLATOR.alpha + 2.0 * ISOLATOR.beta * (1.0 / hy.sqrt(1.0 - u * u) - 1.0))
    rate = F_0 * hy.cos(OMEGA * hy.time) - force - 2.0 * ZETA * v - hy.par[0]
    heights: list[float] = []

    def turned(integrator: Any, sign: int) -> bool:
        heights.append(abs(float(integrator.state[0])))
        integrator.pars[0] = math.copysign(MU, sign)
        return True

    integrator = hy.taylor_adaptive(
        [(u, v), (v, rate)], [0.0, 0.0], pars=[MU], tol=tolerance, t_events=[hy.t_event(v, callback=turned)]
    )

    def job() -> float:
        heights.clear()
        integrator.time, integrator.state[:], integrator.pars[0] = 0.0, (0.0, 0.0), MU
        integrator.reset_cooldowns()
        integrator.propagate_until(END)
        return max(heights[-LAST:])

    return job


def of_amplitude(found: float) -> dict[str, Any]:
    """The amplitude."""
    return {"found": [float(found)]}


def prepare() -> dict[str, tuple[Callable[[], Any], Callable[[Any], dict[str, Any]]]]:
    """Jobs by name."""
    jobs: dict[str, Callable[[], float]] = {
        "slowflow | Newton": lambda: steady_state(SYSTEM, Omega=OMEGA, F_0=F_0).A,
        "slowflow | 200 periods": followed,
    }
    if importlib.util.find_spec("heyoka"):
        jobs |= {f"heyoka, events | tol {tol:.0e}": by_heyoka(tol) for tol in (1e-6, 1e-10, 2e-16)}
    for method, rtols in RTOLS.items():
        jobs |= {f"{method}, events | rtol {rtol:.0e}": partial(by_scipy, method, rtol) for rtol in rtols}
    for nu in (1e2, 1e3):
        recipe = partial(direct_integration, SYSTEM, OMEGA, F_0, nu=nu)
        jobs[f"the paper's recipe | nu = {nu:g}"] = lambda recipe=recipe: recipe().A
    return {f"motion | {name}": (job, of_amplitude) for name, job in jobs.items()}
