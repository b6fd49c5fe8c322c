"""Figures 2a and 2b: in go Matplotlib axes and oscillators, out come averaged, exact and Den Hartog's response curves.

Matplotlib itself is not imported here. Exact curves are dotted where the mass stops within the cycle.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from slowflow.exact.continuation import exact_response
from slowflow.isolator import Duffing
from slowflow.mechanism import EquationOfMotion, linear
from slowflow_kernels import den_hartog


def figure_2a(ax: Any, ratios: tuple[float, ...] = (0.2, 0.4, 0.6, 0.7)) -> None:
    """Den Hartog's (35) where (36) holds, the exact motion, and the averaged amplitude, in units of F_0, over mu/F_0.

    Linear spring, dry friction alone. Each curve is drawn on both sides of Omega = 1, where it is unbounded for
    mu/F_0 < pi/4.
    """
    for k, ratio in enumerate(ratios):
        system = EquationOfMotion(linear(), ratio, 0.0)
        averaged = Duffing(1.0, 0.0, mu=ratio, zeta=0.0)
        colour = f"C{k}"
        for window in ((0.3, 0.96), (1.04, 2.0)):
            _exact(ax, system, 1.0, window, colour, f"mu/F_0 = {ratio:g}" if window[0] < 1 else None)
            curve = averaged.frequency_response(1.0, Omega=window)
            ax.plot(curve.Omega, curve.A, color=colour, linestyle="--", linewidth=0.8)
            Omega = np.linspace(*window, 25)
            ax.plot(Omega, _continuous(Omega, ratio), color=colour, linestyle="none", marker="o", markersize=3)
    ax.set(xlabel="Omega", ylabel="A/F_0")
    ax.legend()


def figure_2b(
    ax: Any, isolators: tuple[tuple[Any, EquationOfMotion], ...], F_0: float, Omega: tuple[float, float]
) -> None:
    """The averaged and the exact curve of each isolator, given as (averaged `Isolator`, `EquationOfMotion`)."""
    for k, (averaged, system) in enumerate(isolators):
        colour = f"C{k}"
        curve = averaged.frequency_response(F_0, Omega=Omega)
        for branch in np.unique(curve.branch):
            on = curve.branch == branch
            ax.plot(curve.Omega[on], curve.A[on], color=colour, linestyle="--", linewidth=0.8)
        _exact(ax, system, F_0, Omega, colour, f"mu/F_0 = {system.mu / F_0:.2g}")
    ax.set(xlabel="Omega", ylabel="A")
    ax.legend()


def _exact(
    ax: Any, system: EquationOfMotion, F_0: float, Omega: tuple[float, float], colour: str, label: str | None
) -> None:
    curve = exact_response(system, F_0, Omega)
    A = np.where(curve.stops == 0, curve.A, np.nan)
    ax.plot(curve.Omega, A, color=colour, linewidth=1.4, label=label)
    ax.plot(curve.Omega, np.where(curve.stops > 0, curve.A, np.nan), color=colour, linewidth=1.4, linestyle=":")


def _continuous(Omega: Any, ratio: float) -> Any:
    """(35) in units of F_0, NaN where (36) says that the mass stops."""
    out = np.full(Omega.shape, np.nan)
    for i, at in enumerate(Omega):
        times = np.linspace(0.0, np.pi / at, 2001)[1:-1]
        S = float(np.max(den_hartog.S_ratio(times, at)))
        with np.errstate(invalid="ignore"):
            A = float(den_hartog.amplitude(at, 1.0, ratio))
        if A > float(den_hartog.bound(at, 1.0, S)):
            out[i] = A
    return out
