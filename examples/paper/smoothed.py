"""The paper's own direct integration (Appendix A): friction and detachment smoothed, time stepping by a stiff solver.

In:  an oscillator, Omega, F_0; the smoothing nu, the number of turns, the tolerances.
Out: `Direct`: the amplitude read off the last turns, as the paper reads it and from the turning points themselves.

Kept to measure what the smoothing costs: `steady_state` answers the same question without it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.special import expit

from slowflow.core.mechanism import EquationOfMotion
from slowflow.exact.motion import check_forcing
from slowflow.support.errors import NotSettled, Refused
from slowflow_kernels import motion

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Direct:
    """What direct integration shows.

    A         -- largest |u| at a turning point of the last turns
    A_sampled -- largest |u| among the samples of the last turns, which is what the paper plots
    spread    -- largest less smallest turning point per turn over the last turns: how far the motion has settled
    """

    A: float
    A_sampled: float
    spread: float


def direct_integration(
    system: EquationOfMotion,
    Omega: float,
    F_0: float,
    *,
    nu: float = 1000.0,
    turns: int = 200,
    kept: int = 100,
    samples: int = 40,
    rtol: float = 1e-3,
    atol: float = 1e-6,
) -> Direct:
    """(A1), (A2) from rest over `turns` turns of the forcing, `samples` a turn, the last `kept` of them evaluated.

    nu -- nu_1 = nu_2 of (A2). SciPy's Radau stands for the paper's ode23s, with the same default tolerances.
    Raises ValueError for parameters out of range or a force with more than one breakpoint, ArithmeticError if the
    solver fails.
    """
    check_forcing(system, Omega, F_0)
    if not 0 < kept <= turns:
        raise Refused(f"kept = {kept} must lie between 1 and turns = {turns}")
    if not nu > 0:
        raise Refused(f"nu = {nu} must be positive")
    field, jacobian = _smoothed(system, Omega, F_0, nu)
    turn = 2.0 * math.pi / Omega

    def at_rest(_: float, y: Array) -> float:
        return float(y[1])

    options = {"method": "Radau", "rtol": rtol, "atol": atol, "jac": jacobian}
    before = solve_ivp(field, (0.0, (turns - kept) * turn), [0.0, 0.0], **options)
    start = before.t[-1]
    grid = np.linspace(start, turns * turn, kept * samples + 1)
    grid[-1] = turns * turn
    run = solve_ivp(field, (start, turns * turn), before.y[:, -1], t_eval=grid, events=at_rest, **options)
    if not (before.success and run.success):
        raise NotSettled(f"the stiff solver failed at Omega = {Omega}, F_0 = {F_0}: {run.message}")
    turning = np.abs(run.y_events[0][:, 0])
    number = np.floor((run.t_events[0] - start) / turn).astype(int)
    peaks = [float(np.max(turning[number == n])) for n in range(kept) if np.any(number == n)]
    return Direct(A=max(peaks), A_sampled=float(np.max(np.abs(run.y[0]))), spread=max(peaks) - min(peaks))


def _smoothed(system: EquationOfMotion, Omega: float, F_0: float, nu: float):  # type: ignore[no-untyped-def]
    """The right-hand side of (A1) as a first-order system in tau, and its Jacobian."""
    pieces, breakpoints = system.force.pieces, system.force.breakpoints
    if len(breakpoints) > 1:
        raise Refused(f"the smoothing (A2) knows one breakpoint, not {len(breakpoints)}")
    u_cr = breakpoints[0] if breakpoints else 0.0
    inner, outer = pieces[0], pieces[-1]

    def steps(u: float, v: float) -> tuple[float, float, float]:
        """Both steps at the breakpoint, and the smoothed sign of v."""
        return float(expit(nu * (u + u_cr))), float(expit(nu * (u - u_cr))), math.tanh(nu * v)

    def field(tau: float, y: Array) -> Any:
        u, v = float(y[0]), float(y[1])
        left, right, slip = steps(u, v)
        # far beyond the breakpoint the inner piece may have no force
        inside = inner if left != right else outer
        arguments = (math.cos(Omega * tau), v, F_0, system.mu, system.zeta, left, right, slip)
        return motion.smoothed(*arguments, inside.value(u), outer.value(u))

    def jacobian(_: float, y: Array) -> Any:
        u, v = float(y[0]), float(y[1])
        left, right, slip = steps(u, v)
        inside = inner if left != right else outer
        arguments = (system.mu, system.zeta, nu, left, right, slip, inside.value(u), outer.value(u))
        return np.reshape(motion.smoothed_by_state(*arguments, inside.slope(u), outer.slope(u)), (2, 2))

    return field, jacobian
