"""Figures: in go an oscillator and forcings, out come Matplotlib axes with its response curves or phases (Fig. 7).

Matplotlib is imported here and nowhere else; `import slowflow` does not import this module.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import matplotlib as mpl
import numpy as np

from slowflow.oscillator import Oscillator
from slowflow.results import FrequencyResponse

#: a light-to-dark ramp, so that the order of the forcings shows; the lightest end is left out
RAMP = mpl.colormaps["viridis_r"]
JUMP_UP, JUMP_DOWN = "^", "v"
#: points along either axis of the unstable region
SHADING = 500


def _colours(forcings: Sequence[float]) -> list[Any]:
    return [RAMP(0.15 + 0.8 * k / max(len(forcings) - 1, 1)) for k in range(len(forcings))]


def _runs(curve: FrequencyResponse) -> list[tuple[slice, bool]]:
    """Stretches of points of one branch and one stability; neighbours share the point between them."""
    turns = np.flatnonzero((np.diff(curve.branch) != 0) | (np.diff(curve.stable) != 0)) + 1
    runs = []
    for start, stop in pairwise([0, *turns.tolist(), curve.A.size]):
        joined = start > 0 and curve.branch[start] == curve.branch[start - 1]
        runs.append((slice(start - joined, stop), bool(curve.stable[start])))
    return runs


def _draw(ax: Any, curve: FrequencyResponse, values: Any, colour: Any, label: str) -> None:
    for number, (run, stable) in enumerate(_runs(curve)):
        style = "-" if stable else (0, (3, 1.5))
        ax.plot(
            curve.Omega[run],
            values[run],
            linestyle=style,
            color=colour,
            linewidth=1.6,
            label=label if number == 0 else None,
        )


def amplitude_curves(
    ax: Any, oscillator: Oscillator, forcings: Sequence[float], Omega: tuple[float, float], A_max: float
) -> None:
    """Fig. 7a: A(Omega) for each forcing, folds, the unstable region, u_cr. `ax` is a Matplotlib axes."""
    shade_unstable(ax, oscillator, Omega, A_max)
    for F_0, colour in zip(forcings, _colours(forcings), strict=True):
        curve = oscillator.frequency_response(F_0, Omega=Omega)
        _draw(ax, curve, curve.A, colour, f"{F_0:.4g}")
        folds = oscillator.saddle_nodes(F_0)
        for kind, marker in (("jump-up", JUMP_UP), ("jump-down", JUMP_DOWN)):
            these = folds.kind == kind
            ax.plot(folds.Omega[these], folds.A[these], marker, color=colour, markersize=6, markeredgecolor="white")
    for u_cr in oscillator.breakpoints:
        ax.axhline(u_cr, color="0.35", linewidth=0.8)
        ax.annotate("$u_{cr}$", (Omega[1], u_cr), xytext=(-4, 3), textcoords="offset points", ha="right", color="0.35")
    ax.set(xlim=Omega, ylim=(0, A_max), xlabel=r"frequency $\Omega$", ylabel="amplitude $A$")
    ax.legend(title="$F_0$", frameon=False, loc="upper left")


def phase_curves(ax: Any, oscillator: Oscillator, forcings: Sequence[float], Omega: tuple[float, float]) -> None:
    """Fig. 7b: the phase phi(Omega) in radians for each forcing. `ax` is a Matplotlib axes."""
    for F_0, colour in zip(forcings, _colours(forcings), strict=True):
        curve = oscillator.frequency_response(F_0, Omega=Omega)
        _draw(ax, curve, curve.phi, colour, f"{F_0:.4g}")
    ax.set(xlim=Omega, ylim=(-np.pi, 0), xlabel=r"frequency $\Omega$", ylabel=r"phase $\varphi$ / rad")
    ax.set_yticks([-np.pi, -np.pi / 2, 0], [r"$-\pi$", r"$-\pi/2$", "0"])
    ax.legend(title="$F_0$", frameon=False, loc="lower left")


def shade_unstable(ax: Any, oscillator: Oscillator, Omega: tuple[float, float], A_max: float) -> None:
    """The region of (Omega, A) in which a steady state would be unstable (30), whatever its forcing."""
    w = np.linspace(max(Omega[0], 1e-6), Omega[1], SHADING)[np.newaxis, :]
    A = np.linspace(A_max / SHADING, A_max, SHADING)[:, np.newaxis]
    unstable = oscillator.stability(Omega=w, A=A)
    ax.contourf(w[0], A[:, 0], unstable, levels=[-np.inf, 0], colors=["0.90"])
