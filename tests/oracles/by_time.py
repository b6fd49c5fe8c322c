"""The equation of motion (3) by SciPy, the spring typed by hand. Takes its pull, an oscillator's damping and F_0.

Out come motions, or settled ones: means over a turn of the forcing, or the largest |u|. Shares no integrator and no
switching with the package.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

Pull = Callable[[float], float]


def motion(pull: Pull, push: Pull, zeta: float, span: tuple[float, float], state: Any, **options: Any) -> Any:
    """u'' + 2 zeta u' + pull(u) = push(tau) over a span of tau from a state (u, u'), as SciPy has it."""

    def rates(tau: float, y: Any) -> Any:
        return y[1], push(tau) - 2 * zeta * y[1] - pull(y[0])

    return solve_ivp(rates, span, state, **{"method": "DOP853", "rtol": 1e-10, "atol": 1e-12, **options})


def settled(
    pull: Pull, push: Pull, zeta: float, Omega: float, state: Any, turns: float, last: int = 1, **options: Any
) -> Any:
    """Times, u and u' over the last turns, `turns` after a state, with which the forcing begins anew."""
    turn = 2 * np.pi / Omega
    begun = motion(pull, push, zeta, (0, turns * turn), state, **options).y[:, -1]
    grid = np.linspace(0, last * turn, 2000 * last + 1)
    return grid, *motion(pull, push, zeta, (0, last * turn), begun, t_eval=grid, **options).y


def _force(osc: Any, Omega: float, F_0: float) -> float:
    return F_0 * Omega**2 if osc.model.inertial else F_0


def last_turn(pull: Pull, osc: Any, Omega: float, F_0: float, start: Any, turns: int, samples: int = 1024) -> Any:
    """Times and u over one turn after many; friction turns round within a step."""
    period, force, zeta = 2 * np.pi / Omega, _force(osc, Omega, F_0), osc.zeta + osc.eta / (2 * Omega)

    def rates(tau: float, y: Any) -> Any:
        drag = 2 * zeta * y[1] + osc.mu * np.sign(y[1]) + osc.c_2 * abs(y[1]) * y[1]
        return y[1], force * np.cos(Omega * tau) + (osc.load or 0.0) - drag - pull(y[0])

    options = {"method": "LSODA", "rtol": 1e-10, "atol": 1e-12}
    last = solve_ivp(rates, (0, turns * period), start, max_step=period / 60, **options).y[:, -1]
    grid = period * (np.arange(samples) + 0.5) / samples
    return grid, solve_ivp(rates, (0, period), last, t_eval=grid, max_step=period / 200, **options).y[0]


def mean_and_first(pull: Pull, osc: Any, Omega: float, F_0: float, start: Any, turns: int) -> tuple[float, float]:
    """The mean and the first harmonic of that turn."""
    grid, u = last_turn(pull, osc, Omega, F_0, start, turns)
    return u.mean(), abs(2 * (u * np.exp(-1j * Omega * grid)).mean())


def largest(pull: Pull, osc: Any, Omega: float, F_0: float, turns: int, preload: float = 0.0) -> float:
    """The largest |u| in the last tenth of many turns, from switch to switch: for motions that never rest.

    A preload times the sign of u is added to the pull; friction may end at the first breakpoint.
    """
    force, edge = _force(osc, Omega, F_0), osc.breakpoints[0] if osc.breakpoints else np.inf
    state, t, end, most = np.array([preload > 0, preload > 0]) * 1e-3, 0.0, turns * 2 * np.pi / Omega, 0.0
    slip, side, inside = 1.0, 1.0, True
    while t < end:
        mu = osc.mu if inside or osc.rubs == "throughout" else 0.0

        def resting(tau: float, u: float, side: float = side) -> float:
            return force * np.cos(Omega * tau) - pull(u) - side * preload

        def field(tau: float, y: Any, slip: float = slip, mu: float = mu, resting: Any = resting) -> Any:
            viscous = 2 * (osc.zeta + osc.zeta_2 * y[0] ** 2) + osc.eta / Omega + osc.c_3 * y[1] ** 2
            resists = viscous * y[1] + slip * (osc.c_2 * y[1] ** 2 + mu)
            return [y[1], resting(tau, y[0]) - resists]

        events = [lambda tau, y: y[1], lambda tau, y: abs(y[0]) - edge, lambda tau, y: y[0] if preload else 1.0]
        # at a start on a switch the value is a rounding: only the way back across it counts
        for event, way in zip(events, (-slip, 1 if inside else -1, -side), strict=True):
            event.terminal, event.direction = True, way  # type: ignore[attr-defined]
        solution = solve_ivp(field, (t, end), state, rtol=1e-9, atol=1e-12, events=events, method="DOP853")
        t, state = float(solution.t[-1]), solution.y[:, -1].copy()
        if t > 0.9 * end:
            most = max(most, np.abs(solution.y[0]).max())
        if solution.t_events[0].size:
            assert preload or abs(resting(t, state[0])) > mu
            slip = -slip
            state[1] = slip * 1e-13
        elif solution.t_events[1].size:
            inside = not inside
        elif solution.t_events[2].size:
            side, state[0] = -side, -side * 1e-15
    return most
