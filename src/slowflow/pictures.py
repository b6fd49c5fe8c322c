"""Pictures: in go the arrays of an answer and a Matplotlib axes, or None for one of a new figure; out comes the axes.

The same signs everywhere: stable is solid and unstable dashed; triangles point where a sweep jumps; a bar across a
curve says that the mass stops within the cycle; beyond a breakpoint the plane is tinted. Matplotlib is imported here
and by who draws the paper's figures, nowhere else: `import slowflow` does without it, and answers import this when they
are drawn.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import numpy.typing as npt
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

Values = npt.NDArray[Any]

#: of things without an order, told apart with red-green blindness too, each with a contrast of 3 to white or more
COLOURS = ("#0072B2", "#C04000", "#007D5A", "#A2467E", "#111111")
STABLE: Any = "-"
UNSTABLE: Any = (0, (4, 2))
JUMP_UP, JUMP_DOWN = "^", "v"
STOPS = "|"
LEAVES = "D"
MARKERS = {JUMP_UP: "jump up", JUMP_DOWN: "jump down", STOPS: "the mass stops", LEAVES: "springs leave"}
#: what is tinted beyond a breakpoint, where a motion would stop, and where a state would be unstable
DETACHED, STOPPING, UNSTABLE_REGION = "#E8EEF4", "#F5EBDD", "#E6E6E6"
NO_ANSWER = "#D0D0D0"
#: axis labels by the name of what is drawn
LABELS = {
    "Omega": r"frequency $\Omega$",
    "A": "amplitude $A$",
    "phi": r"phase $\varphi$ / rad",
    "transmissibility_dB": "transmissibility / dB",
    "F_0": "forcing $F_0$",
    "u": "displacement $u$",
    "lam": r"number of springs $\lambda$",
    "r": "stiffness ratio $r$",
    "delta_h": r"preload $\delta_h$",
    "mu": r"dry friction $\mu$",
    "zeta": r"damping ratio $\zeta$",
    "F_SN": "onset $F_{SN}$",
    "F_cr": "critical forcing $F_{cr}$",
    "u_cr": "$u_{cr}$",
    "tau": r"time $\tau$",
    "duration": r"duration $\tau$ of the pulse",
    "acceleration": "acceleration of the pulse",
    "ratio": "largest acceleration over the pulse's",
    "Omega_cr": r"$\Omega_{cr}$",
}
#: a fold locus is shown up to this many times its least forcing
LOCUS_SHOWN = 4.0


def axes(ax: Any) -> Any:
    """The axes that are given, or those of a new figure."""
    return plt.subplots(figsize=(6.4, 4.4), layout="constrained")[1] if ax is None else ax


def ramp(count: int) -> list[Any]:
    """Colours from light to dark, so that an order shows, of which the lightest still holds on white."""
    return [mpl.colormaps["viridis"](0.55 - 0.55 * k / max(count - 1, 1)) for k in range(count)]


def label(name: str) -> str:
    """What an axis is called."""
    return LABELS.get(name, name)


def curve(
    ax: Any,
    x: Values,
    y: Values,
    stable: Values,
    branch: Values | None = None,
    *,
    colour: Any,
    name: str | None = None,
    width: float = 1.6,
) -> None:
    """A curve through points in order, each branch for itself: stable stretches solid, unstable ones dashed."""
    for number, (run, steady) in enumerate(_runs(stable, branch)):
        style = STABLE if steady else UNSTABLE
        ax.plot(x[run], y[run], linestyle=style, color=colour, linewidth=width, label=name if number == 0 else None)


def jumps(ax: Any, x: Values, y: Values, kind: Values, *, colour: Any) -> None:
    """Folds: a triangle that points where a sweep goes."""
    for name, marker in (("jump-up", JUMP_UP), ("jump-down", JUMP_DOWN)):
        here = kind == name
        ax.plot(
            x[here], y[here], linestyle="none", marker=marker, color=colour, markersize=6.5, markeredgecolor="white"
        )


def breakpoints(ax: Any, amplitudes: Sequence[float]) -> None:
    """The plane beyond the first breakpoint tinted, and each named at the right end, off the curves."""
    low, high = ax.get_ylim()
    for number, u_cr in enumerate(amplitudes):
        if not low < u_cr < high:
            continue
        if number == 0:
            ax.axhspan(u_cr, high, color=DETACHED, zorder=-3, linewidth=0)
        ax.axhline(u_cr, color="0.4", linewidth=0.8, zorder=-2)
        name = "$u_{cr}$" if len(amplitudes) == 1 else f"$u_{{cr,{number + 1}}}$"
        ax.annotate(name, (1.01, u_cr), xycoords=("axes fraction", "data"), va="center", color="0.3")
    ax.set_ylim(low, high)


def stopping(ax: Any, mu: float) -> None:
    """The plane of Omega and A tinted where A Omega^2 < mu: friction holds a mass that turns there."""
    if mu > 0:
        low, high = ax.get_xlim()
        bottom, top = ax.get_ylim()
        Omega = np.linspace(max(low, 1e-3 * high), high, 400)
        ax.fill_between(Omega, bottom, np.minimum(mu / Omega**2, top), color=STOPPING, zorder=-3, linewidth=0)
        ax.set(xlim=(low, high), ylim=(bottom, top))


def legend(ax: Any, title: str = "", *, beside: bool = True) -> None:
    """What was named, and what the styles, signs and tints mean that were used; beside the axes, off the curves."""
    handles, labels = ax.get_legend_handles_labels()
    for handle, text in _signs(ax):
        handles.append(handle)
        labels.append(text)
    if handles:
        place = {"loc": "center left", "bbox_to_anchor": (1.06, 0.5)} if beside else {"loc": "best"}
        ax.legend(handles, labels, title=title or None, frameon=False, handlelength=2.6, **place)


def responses(ax: Any, found: Sequence[tuple[Any, Any]], of: str = "A") -> Any:
    """Response curves, each with its folds, at rising forcings: `of` over Omega; `of` is "A", "phi", ...

    found -- for each forcing the curve and its folds, records of `results`
    """
    ax = axes(ax)
    for (points, folds), colour in zip(found, ramp(len(found)), strict=True):
        curve(
            ax, points.Omega, getattr(points, of), points.stable, points.branch, colour=colour, name=f"{points.F_0:.4g}"
        )
        if of == "A" and folds is not None:
            jumps(ax, folds.Omega, folds.A, folds.kind, colour=colour)
    ax.set(xlabel=label("Omega"), ylabel=label(of))
    if of == "A":
        ax.set_ylim(bottom=0.0)
    if of == "phi":
        ax.set(ylim=(-np.pi, 0.0))
        ax.set_yticks([-np.pi, -np.pi / 2, 0], [r"$-\pi$", r"$-\pi/2$", "0"])
    return ax


def folds(ax: Any, found: Any) -> Any:
    """Folds at one forcing as points of the plane of Omega and A."""
    ax = axes(ax)
    jumps(ax, found.Omega, found.A, found.kind, colour=COLOURS[0])
    ax.set(xlabel=label("Omega"), ylabel=label("A"))
    legend(ax)
    return ax


def locus(ax: Any, found: Any) -> Any:
    """The forcing over Omega along a fold locus, up to `LOCUS_SHOWN` times the least one; there lie its tips.

    What lies beyond is drawn too, outside the limits of the axes.
    """
    ax = axes(ax)
    for number in np.unique(found.branch):
        on = found.branch == number
        ax.plot(found.Omega[on], found.F_0[on], color=COLOURS[0], linewidth=1.6)
    if found.F_0.size:
        most = LOCUS_SHOWN * float(found.F_0.min())
        shown = found.Omega[found.F_0 <= most]
        margin = 0.05 * (float(np.ptp(shown)) or float(shown[0]))
        ax.set(xlim=(max(0.0, float(shown.min()) - margin), float(shown.max()) + margin), ylim=(0.0, most))
    ax.set(xlabel=label("Omega"), ylabel=label("F_0"))
    return ax


def motions(ax: Any, found: Any, *, colour: Any = COLOURS[1], name: str | None = None) -> Any:
    """The curve of the equation of motion with its folds; bars where the mass stops within the cycle."""
    ax = axes(ax)
    curve(ax, found.Omega, found.A, found.stable, colour=colour, name=name)
    stops = found.stops > 0
    ax.plot(found.Omega[stops], found.A[stops], linestyle="none", marker=STOPS, color=colour, markersize=6, markevery=3)
    for fold in found.folds:
        one = np.array([fold.Omega]), np.array([fold.A]), np.array([fold.kind])
        jumps(ax, *one, colour=colour)
    ax.set(xlabel=label("Omega"), ylabel="amplitude, largest $|u|$")
    return ax


def history(ax: Any, x: Values, y: Values, breakpoints: Sequence[float], names: tuple[str, str]) -> Any:
    """A motion over time; tinted where the springs have left, on either side."""
    ax = axes(ax)
    ax.plot(x, y, color=COLOURS[0], linewidth=1.6)
    low, high = ax.get_ylim()
    if breakpoints:
        for sign, end in ((1.0, high), (-1.0, low)):
            if sign * end > breakpoints[0]:
                ax.axhspan(sign * breakpoints[0], end, color=DETACHED, zorder=-3, linewidth=0)
    ax.axhline(0.0, color="0.4", linewidth=0.8, zorder=-2)
    ax.set(xlabel=label(names[0]), ylabel=label(names[1]), xlim=(x[0], x[-1]), ylim=(low, high))
    legend(ax)
    return ax


def shocks(ax: Any, columns: Mapping[str, Values], names: tuple[str, str, str]) -> Any:
    """Shock spectra: one column over another, a curve for each value of the third; columns by name."""
    ax = axes(ax)
    x, y, of = names
    values = np.unique(columns[of])
    for value, colour in zip(values, ramp(values.size), strict=True):
        here = np.flatnonzero(columns[of] == value)
        here = here[np.argsort(columns[x][here])]
        ax.plot(columns[x][here], columns[y][here], color=colour, linewidth=1.6, label=f"{value:.4g}")
        off = here[columns["detaches"][here].astype(bool)]
        ax.plot(columns[x][off], columns[y][off], linestyle="none", marker=LEAVES, color=colour, markersize=3.5)
    ax.set(xscale="log", xlabel=label(x), ylabel=label(y))
    ax.set_ylim(bottom=0.0)
    legend(ax, label(of))
    return ax


def front(ax: Any, x: Values, y: Values, names: tuple[str, str]) -> Any:
    """A trade-off: a point for each design, in order."""
    ax = axes(ax)
    ax.plot(x, y, color=COLOURS[0], linewidth=1.0, marker="o", markersize=5)
    ax.set(xlabel=label(names[0]), ylabel=label(names[1]))
    return ax


def residuals(ax: Any, x: Values, y: Values, deviation: float, names: tuple[str, str]) -> Any:
    """What a fit leaves, over where it was measured; tinted within two standard deviations."""
    ax = axes(ax)
    ax.axhspan(-2 * deviation, 2 * deviation, color=DETACHED, zorder=-3, linewidth=0)
    ax.axhline(0.0, color="0.4", linewidth=0.8, zorder=-2)
    ax.plot(x, y, linestyle="none", marker="o", markersize=4, color=COLOURS[0])
    ax.set(xlabel=label(names[0]), ylabel=label(names[1]))
    return ax


def design_map(ax: Any, x: tuple[str, Values], y: tuple[str, Values], values: tuple[str, Values]) -> Any:
    """A number of each design over two of its parameters: each a name and values; grey where there is no answer.

    x of shape (n,), y of shape (m,), values of shape (m, n).
    """
    ax = axes(ax)
    ax.set_facecolor(NO_ANSWER)
    drawn = ax.pcolormesh(
        x[1], y[1], np.ma.masked_invalid(values[1]), cmap="cividis", shading="nearest", rasterized=True
    )
    ax.figure.colorbar(drawn, ax=ax, label=label(values[0]))
    ax.set(xlabel=label(x[0]), ylabel=label(y[0]))
    if not np.all(np.isfinite(values[1])):
        ax.legend(handles=[Patch(color=NO_ANSWER, label="no answer")], loc="best")
    return ax


def _runs(stable: Values, branch: Values | None) -> Iterator[tuple[slice, bool]]:
    """Stretches of points of one branch and one stability; neighbours share the point between them."""
    number = np.zeros(stable.size, dtype=int) if branch is None else branch
    turns = np.flatnonzero((np.diff(number) != 0) | (np.diff(stable.astype(int)) != 0)) + 1
    for start, stop in pairwise([0, *turns.tolist(), stable.size]):
        if stop > start:
            joined = start > 0 and number[start] == number[start - 1]
            yield slice(start - joined, stop), bool(stable[start])


def _signs(ax: Any) -> Iterator[tuple[Any, str]]:
    """Of the signs that have a meaning, those that stand in the axes."""
    lines = ax.get_lines()
    if any(line.get_linestyle() == "--" and line.get_xdata().size for line in lines):
        yield Line2D([], [], color="0.2", linestyle=STABLE), "stable"
        yield Line2D([], [], color="0.2", linestyle=UNSTABLE), "unstable"
    for marker, text in MARKERS.items():
        if any(line.get_marker() == marker and line.get_xdata().size for line in lines):
            yield Line2D([], [], color="0.2", linestyle="none", marker=marker), text
    tints = {mpl.colors.to_hex(patch.get_facecolor()) for patch in ax.patches}
    tints |= {mpl.colors.to_hex(one) for drawn in ax.collections for one in drawn.get_facecolor()}
    for tint, text in (
        (DETACHED, "beyond $u_{cr}$"),
        (STOPPING, r"$A\,\Omega^2 < \mu$: stops"),
        (UNSTABLE_REGION, "would be unstable"),
    ):
        if tint.lower() in tints:
            yield Patch(color=tint), text
