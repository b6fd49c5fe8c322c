"""Pictures. Takes the arrays of an answer and a Matplotlib axes, or None for one of a new figure; returns the axes.

The same signs everywhere: stable is solid and unstable dashed; triangles point where a sweep jumps; a bar across a
curve says that the mass stops within the cycle; beyond a breakpoint the plane is tinted. Matplotlib is imported here
and by who draws the paper's figures, nowhere else: `import slowflow` does without it, and answers import this when they
are drawn.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import LogLocator, StrMethodFormatter

from slowflow_kernels import motion

Values = npt.NDArray[Any]

#: of things without an order, told apart with red-green blindness too, each with a contrast of 3 to white or more
COLOURS = ("#0072B2", "#C04000", "#007D5A", "#A2467E", "#111111")
STABLE: Any = "-"
UNSTABLE: Any = (0, (4, 2))
JUMP_UP, JUMP_DOWN = "^", "v"
STOPS = "|"
DETACHES = "D"
MARKERS = {JUMP_UP: "jump up", JUMP_DOWN: "jump down", STOPS: "the mass stops", DETACHES: "springs detach"}
#: what is tinted beyond a breakpoint, where a motion would stop, and where a state would be unstable
DETACHED, STOPPING, UNSTABLE_REGION = "#E8EEF4", "#F5EBDD", "#E6E6E6"
NO_ANSWER = "#D0D0D0"
#: axis labels by the name of what is drawn
LABELS = {
    "Omega": r"frequency $\Omega$",
    "A": "amplitude $A$",
    "B": "mean displacement $B$",
    "phi": r"phase $\varphi$",
    "transmissibility_dB": "transmissibility / dB",
    "F_0": "forcing $F_0$",
    "u": "displacement $u$",
    "u_max": "largest $|u|$",
    "x_max": "largest $|x|$",
    "lam": r"number of springs $\lambda$",
    "r": "stiffness ratio $r$",
    "delta_h": r"preload $\delta_h$",
    "mu": r"dry friction $\mu$",
    "zeta": r"damping ratio $\zeta$",
    "F_SN": "onset $F_{SN}$",
    "F_cr": "critical forcing $F_{cr}$",
    "of_SN": "margin to jumps",
    "of_cr": "margin to detachment",
    "of_SN_spectrum": "margin to jumps, spectrum",
    "of_cr_spectrum": "margin to detachment, spectrum",
    "of_cr_shock": "margin to detachment, shock",
    "break_loose": "break-loose force",
    "sticking": "sticking force",
    "rests_within": "at rest within",
    "ratio_e": "equivalent damping ratio",
    "beyond": "fraction of time beyond the breakpoint",
    "dry": "fraction of damping due to dry friction",
    "transmissibility_spectrum": "transmissibility, spectrum",
    "rows_several": "rows with several motions",
    "rows_cross": "rows that cross a fold",
    "rows_detach": "rows that detach",
    "rows_stick": "rows that stick",
    "Y_SN": "onset $Y_{SN}$",
    "Y_cr": "critical displacement of the base $Y_{cr}$",
    "a_SN": "onset $a_{SN}$",
    "a_cr": "critical acceleration of the base $a_{cr}$",
    "U_SN": "onset $U_{SN}$",
    "U_cr": "critical unbalance $U_{cr}$",
    "u_cr": "$u_{cr}$",
    "tau": r"time $\tau$",
    "f": "frequency $f$",
    "F": "force $F$",
    "Y": "displacement of the base $Y$",
    "U": "unbalance $U$",
    "x": "displacement $x$",
    "t": "time $t$",
    "k_h": "stiffness of the springs $k_h$",
    "duration": "duration of the pulse",
    "acceleration": "acceleration of the pulse",
    "ratio": "largest acceleration / acceleration of the pulse",
    "Omega_cr": r"$\Omega_{cr}$",
}
#: letters in front of "_" where `LABELS` has no name
LETTERS = {"Omega": r"\Omega", **{letter: letter for letter in "aAcfFkuxXYU"}}
#: where a legend stands: off the curves, but for "in"
LOCATIONS: Any = {
    "beside": {"loc": "center left", "bbox_to_anchor": (1.06, 0.5)},
    "below": {"loc": "upper center", "bbox_to_anchor": (0.5, -0.14)},
    "in": {"loc": "lower right"},
    "outside": {"loc": "outside lower center"},
}
#: letters of a name in a legend of three columns
SHORT = 16
#: width of a figure in inches, as of a column of a journal, that has no room for a legend beside the axes
NARROW = 5.0
#: bands beyond this many times the nominal value run out of the picture
WIDEST = 2.0
#: what the amplitude of the excitation is called
AMPLITUDES = ("F_0", "F", "Y", "U", "a")
#: what is a displacement over frequency
HEIGHTS = ("A", "u_max", "x_max")
#: how far signs along a curve are from each other, over the diagonal of the axes
APART = 0.03
#: points of a motion over time
HISTORY = 2000
#: numbers at the axis of durations, times powers of ten
ROUND = (1.0, 2.0, 5.0)
#: a fold locus is shown up to this many times its least forcing
LOCUS_SHOWN = 4.0


def axes(ax: Axes | None) -> Axes:
    """The axes that are given, or those of a new figure."""
    return plt.subplots(figsize=(6.4, 4.4), layout="constrained")[1] if ax is None else ax


def ramp(count: int) -> list[Any]:
    """Colours from light to dark, so that an order shows, of which the lightest still holds on white."""
    return [mpl.colormaps["viridis"](0.55 - 0.55 * k / max(count - 1, 1)) for k in range(count)]


def label(name: str) -> str:
    """What an axis is called: a letter with what stands below it, and after "/" a unit, if nothing else is said."""
    name, *unit = (part.strip() for part in name.split("/", 1))
    letter, _, below = name.partition("_")
    if name not in LABELS and below and letter in LETTERS:
        subscript = below.replace("_", r"\ ")
        name = rf"${LETTERS[letter]}_{{\mathrm{{{subscript}}}}}$"
    return " / ".join([LABELS.get(name, name), *unit])


def axis(found: Any, name: str) -> str:
    """The same for a number of an answer, with its unit if it has one."""
    return measured(name, found.units_of_columns().get(name, "rad" if name == "phi" else ""))


def measured(name: str, unit: str) -> str:
    """The same for a number in a unit, or in none."""
    return f"{label(name)} / {in_brackets(unit)}" if unit else label(name)


def in_brackets(unit: str) -> str:
    """A unit as it stands after a stroke: in brackets if it is put together of several."""
    unit = unit.replace("^2", "²")
    return f"({unit})" if {"/", " "} & set(unit) else unit


def height(found: Any) -> str:
    """The amplitude at which springs detach, and of offset motions the largest displacement."""
    return _has(found, "x_max", "u_max", "A")


def _has(found: Any, *names: str) -> str:
    """The first of the names that an answer has: it is dimensionless, or in units."""
    return next(name for name in names if hasattr(found, name))


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
    alpha: float = 1.0,
) -> None:
    """A curve through points in order, each branch for itself: stable stretches solid, unstable ones dashed."""
    runs = list(_runs(stable, branch))
    # a name stands at a solid line where there is one
    named = next((number for number, (_, steady) in enumerate(runs) if steady), 0)
    for number, (run, steady) in enumerate(runs):
        style = STABLE if steady else UNSTABLE
        drawn = {"color": colour, "linewidth": width, "alpha": alpha, "solid_capstyle": "butt"}
        ax.plot(x[run], y[run], linestyle=style, label=name if number == named else None, **drawn)


def jumps(ax: Any, x: Values, y: Values, kind: Values, *, colour: Any) -> None:
    """Folds: a triangle that points where a sweep goes."""
    for name, marker in (("jump-up", JUMP_UP), ("jump-down", JUMP_DOWN)):
        here = kind == name
        ax.plot(
            x[here], y[here], linestyle="none", marker=marker, color=colour, markersize=6.5, markeredgecolor="white"
        )


def breakpoints(ax: Any, amplitudes: Sequence[float], letter: str = "u") -> None:
    """The plane beyond the first breakpoint tinted, and each named at the right end, off the curves."""
    low, high = ax.get_ylim()
    for number, u_cr in enumerate(amplitudes):
        if not low < u_cr < high:
            continue
        if number == 0:
            ax.axhspan(u_cr, high, color=DETACHED, zorder=-3, linewidth=0, label=f"_beyond ${letter}_{{cr}}$")
        ax.axhline(u_cr, color="0.4", linewidth=0.8, zorder=-2)
        name = f"${letter}_{{cr}}$" if len(amplitudes) == 1 else f"${letter}_{{cr,{number + 1}}}$"
        ax.annotate(name, (1.01, u_cr), xycoords=("axes fraction", "data"), va="center", color="0.3")
    ax.set_ylim(low, high)


def stopping(ax: Any, mu: float, name: str = r"$A\,\Omega^2 < \mu$") -> None:
    """The plane of frequency and A tinted where A Omega^2 < mu: friction holds a mass that turns there."""
    if mu > 0:
        low, high = ax.get_xlim()
        bottom, top = ax.get_ylim()
        Omega = np.linspace(max(low, 1e-3 * high), high, 400)
        # the quotient at A = 1 is the A where it is 1
        edge = np.minimum(motion.stopping(Omega, 1.0, mu), top)
        ax.fill_between(Omega, bottom, edge, color=STOPPING, zorder=-3, linewidth=0, label=f"_stops: {name}")
        ax.set(xlim=(low, high), ylim=(bottom, top))


def legend(ax: Any, title: str = "", *, place: str = "beside", more: Sequence[tuple[Any, str]] = ()) -> None:
    """Add a legend of what was named and of the styles, signs and tints in use, "beside" or "below" the axes, or "in".

    place -- on figures narrower than `NARROW` always below
    more -- further entries: handles and their labels
    """
    handles, labels = ax.get_legend_handles_labels()
    entries = [*more, *_signs(ax)]
    if handles or entries:
        if ax.figure.get_figwidth() < NARROW:
            place = "outside"
        where = LOCATIONS[place]
        if place in ("below", "outside"):
            columns = 3 if max(map(len, (*labels, *(text for _, text in entries)))) <= SHORT else 2
            where = {**where, "ncols": columns}
            rows = math.ceil((len(handles) + len(entries)) / columns)
            if math.ceil(len(handles) / rows) + math.ceil(len(entries) / rows) <= columns:  # what was named by itself
                empty = -len(handles) % rows if entries else 0
                handles += [Line2D([], [], linestyle="none")] * empty
                labels += [""] * empty
        handles += [handle for handle, _ in entries]
        labels += [text for _, text in entries]
        owner = ax.figure if place == "outside" else ax
        owner.legend(handles, labels, title=title or None, frameon=False, handlelength=2.6, **where)


def responses(ax: Axes | None, found: Sequence[tuple[Any, Any]], of: str = "A", *, names: Sequence[str] = ()) -> Axes:
    """Response curves, each with its folds: `of` over frequency; `of` is "A", "phi", "transmissibility_dB", ...

    found -- for each the curve and its folds or None: records of `results`, or the same in units
    names -- of the curves; by default their forcings, which rise
    """
    ax = axes(ax)
    for number, ((points, folds), colour) in enumerate(zip(found, ramp(len(found)), strict=True)):
        over = _has(points, "Omega", "f")
        name = names[number] if names else f"{getattr(points, _has(points, *AMPLITUDES)):.4g}"
        if not len(points):
            ax.axhline(0.0, color=colour, linewidth=4, label=f"{name}, sticks", clip_on=False)
            continue
        curve(ax, getattr(points, over), getattr(points, of), points.stable, points.branch, colour=colour, name=name)
        if of in HEIGHTS and folds is not None:
            height = getattr(folds, of) if hasattr(folds, of) else np.abs(folds.B) + folds.A
            jumps(ax, getattr(folds, over), height, folds.kind, colour=colour)
    if found:
        points = found[0][0]
        ax.set(xlabel=axis(points, _has(points, "Omega", "f")), ylabel=axis(points, of))
    if of in HEIGHTS:
        ax.set_ylim(bottom=0.0)
    if of.startswith("transmissibility"):
        ax.axhline(float(of == "transmissibility"), color="0.4", linewidth=0.8, zorder=-2)
        ax.set_xscale("log")
        _round_ticks(ax)
    if of == "phi" and not (found and found[0][0].units_of_columns().get(of) == "deg"):
        ax.set(ylim=(-np.pi, 0.0))
        ax.set_yticks([-np.pi, -np.pi / 2, 0], [r"$-\pi$", r"$-\pi/2$", "0"])
    return ax


def _round_ticks(ax: Any) -> None:
    """Numbers such as 0.5, 1 and 2 along a logarithmic axis, not powers of ten."""
    ax.xaxis.set(major_locator=LogLocator(subs=ROUND), major_formatter=StrMethodFormatter("{x:g}"))
    ax.minorticks_off()


def window(ax: Any, low: float, high: float) -> None:
    """The limits of the frequency axis; a logarithmic one has two decades at most."""
    ax.set_xlim(max(low, 0.01 * high) if ax.get_xscale() == "log" else low, high)


def response(ax: Axes | None, found: Any, of: str = "A") -> Axes:
    """One curve, its forcing beside it."""
    ax = responses(ax, [(found, None)], of)
    if ax.get_xscale() == "log":
        window(ax, *ax.dataLim.intervalx)
    legend(ax, axis(found, _has(found, *AMPLITUDES)))
    return ax


def folds(ax: Axes | None, found: Any) -> Axes:
    """Folds at one forcing as points of the plane of frequency and A."""
    ax, over = axes(ax), _has(found, "Omega", "f")
    jumps(ax, getattr(found, over), found.A, found.kind, colour=COLOURS[0])
    ax.set(xlabel=axis(found, over), ylabel=axis(found, "A"))
    legend(ax)
    return ax


def locus(ax: Axes | None, found: Any) -> Axes:
    """The forcing over frequency along a fold locus, up to `LOCUS_SHOWN` times the least one; there lie its tips.

    What lies beyond is drawn too, outside the limits of the axes.
    """
    ax, over, force = axes(ax), _has(found, "Omega", "f"), _has(found, *AMPLITUDES)
    x, y = getattr(found, over), getattr(found, force)
    for number in np.unique(found.branch):
        on = found.branch == number
        ax.plot(x[on], y[on], color=COLOURS[0], linewidth=1.6)
    if y.size:
        most = LOCUS_SHOWN * float(y.min())
        shown = x[y <= most]
        margin = 0.05 * (float(np.ptp(shown)) or float(shown[0]))
        ax.set(xlim=(max(0.0, float(shown.min()) - margin), float(shown.max()) + margin), ylim=(0.0, most))
    ax.set(xlabel=axis(found, over), ylabel=axis(found, force))
    return ax


def motions(ax: Axes | None, found: Any) -> Axes:
    """The curve of the equation of motion with its folds; bars where the mass stops within the cycle."""
    ax, over, colour = axes(ax), _has(found, "Omega", "f"), COLOURS[1]
    x = getattr(found, over)
    curve(ax, x, found.A, found.stable, colour=colour)
    stops = found.stops > 0
    ax.plot(x[stops], found.A[stops], linestyle="none", marker=STOPS, color=colour, markersize=6, markevery=APART)
    for fold in found.folds:
        one = np.array([getattr(fold, over)]), np.array([fold.A]), np.array([fold.kind])
        jumps(ax, *one, colour=colour)
    ax.set(xlabel=axis(found, over), ylabel=axis(found, "A"))
    legend(ax)
    return ax


def sweep(ax: Axes | None, found: Any) -> Axes:
    """A stepped sweep: a dot at each frequency, an arrow from dot to dot where it jumps."""
    ax, over = axes(ax), _has(found, "Omega", "f")
    x = getattr(found, over)
    ax.plot(x, found.A, color=COLOURS[1], linewidth=0.8, marker="o", markersize=3.5)
    for before, after in np.reshape(found.jumps, (-1, 2)).tolist():
        ends = [(at, float(found.A[int(np.argmin(np.abs(x - at)))])) for at in (before, after)]
        ax.annotate("", ends[1], ends[0], arrowprops={"arrowstyle": "->", "color": COLOURS[1], "linewidth": 1.6})
    ax.set(xlabel=axis(found, over), ylabel=axis(found, "A"))
    ax.set_ylim(bottom=0.0)
    return ax


def history(ax: Axes | None, found: Any, place: str = "beside") -> Axes:
    """The motion in a shock over time; tinted where the springs have left, on either side."""
    ax = axes(ax)
    line = found.series(HISTORY) if hasattr(found, "series") else found
    time, spot = _has(line, "tau", "t"), _has(line, "u", "x")
    ax.plot(getattr(line, time), getattr(line, spot), color=COLOURS[0], linewidth=1.6)
    low, high = ax.get_ylim()
    stroke = getattr(found, _has(found, "u_cr", "x_cr"))
    for sign, end in ((1.0, high), (-1.0, low)) if stroke is not None else ():
        if sign * end > stroke:
            name = f"_beyond ${_has(found, 'u_cr', 'x_cr').replace('_cr', '')}_{{cr}}$"
            ax.axhspan(sign * stroke, end, color=DETACHED, zorder=-3, linewidth=0, label=name)
    ax.axhline(0.0, color="0.4", linewidth=0.8, zorder=-2)
    shown = getattr(line, time)
    ax.set(xlabel=axis(found, time), ylabel=axis(found, spot), xlim=(shown[0], shown[-1]), ylim=(low, high))
    legend(ax, place=place)
    return ax


def shocks(ax: Axes | None, found: Any, place: str = "beside") -> Axes:
    """Shock spectra: the share of a pulse's acceleration that the mass sees, over its duration, for each peak."""
    ax = axes(ax)
    values = np.unique(found.acceleration)
    for value, colour in zip(values, ramp(values.size), strict=True):
        here = np.flatnonzero(found.acceleration == value)
        here = here[np.argsort(found.duration[here])]
        ax.plot(found.duration[here], found.ratio[here], color=colour, linewidth=1.6, label=f"{value:.4g}")
        off = here[found.detaches[here]]
        some: dict[str, Any] = {"marker": DETACHES, "markersize": 3.5, "markevery": max(1, here.size // 20)}
        ax.plot(found.duration[off], found.ratio[off], linestyle="none", color=colour, **some)
    ax.set(xscale="log", xlabel=axis(found, "duration"), ylabel=axis(found, "ratio"))
    _round_ticks(ax)
    ax.set_ylim(bottom=0.0)
    legend(ax, axis(found, "acceleration"), place=place)
    return ax


def psd(ax: Axes | None, found: Any, place: str = "beside") -> Axes:
    """The spectral density of the displacement, a curve for each stationary motion; in SI units in mm^2/Hz over Hz."""
    ax = axes(ax)
    rms, scales = _has(found, "u_rms", "x_rms"), getattr(found, "scales", None)
    low, high = (found if scales is None else found.answer).window
    turns = 1.0 if scales is None else scales.sizes["frequency"]
    at = np.geomspace(low * turns, high * turns, HISTORY)
    density = found.response_psd(at) * (1.0 if scales is None else 1e6)
    values = getattr(found, rms)
    for one, value, colour in zip(density, values, ramp(len(values)), strict=True):
        ax.plot(at, one, color=colour, linewidth=1.6, label=f"{value:.3g}")
    xlabel, unit = (label("Omega"), "") if scales is None else (label("f / Hz"), " / (mm² / Hz)")
    ylabel = f"spectral density of {label(rms[0])}{unit}"
    ax.set(xscale="log", yscale="log", xlabel=xlabel, ylabel=ylabel, xlim=(at[0], at[-1]))
    if len(values) > 1:
        legend(ax, axis(found, rms), place=place)
    return ax


#: what draws an answer, by its `picture`
PICTURES: Mapping[str, Callable[[Any, Any], Axes]] = {
    "response": response,
    "folds": folds,
    "locus": locus,
    "motions": motions,
    "sweep": sweep,
    "history": history,
    "shocks": shocks,
    "psd": psd,
}


def depths(ax: Axes | None, found: Mapping[str, Any]) -> Axes:
    """One response by several depths, by their names; the last in the list lies on top.

    The largest displacement of each, which off the centre is more than averaging's A.
    """
    ax = axes(ax)
    of_all = ""
    for (name, one), colour, width in zip(found.items(), COLOURS, (3.2, 2.2, 1.2), strict=False):
        over = _has(one, "Omega", "f")
        branch = getattr(one, "branch", None)
        largest = height(one)
        of_all = of_all or axis(one, largest)
        curve(ax, getattr(one, over), getattr(one, largest), one.stable, branch, colour=colour, name=name, width=width)
        ax.set(xlabel=axis(one, over), ylabel=of_all)
    legend(ax, place="below")
    return ax


def bands(ax: Axes | None, found: Any) -> Axes:
    """Bands of answers over their nominal values: a bar from low to high, a stroke at the median."""
    ax = axes(ax)
    rows = [row for row in found if np.isfinite([row.low, row.high, row.nominal]).all() and row.nominal > 0]
    for place, row in enumerate(reversed(rows)):
        ends = np.array([row.low, row.median, row.high]) / row.nominal
        ax.plot(ends[[0, 2]], [place, place], color=COLOURS[0], linewidth=6, alpha=0.45, solid_capstyle="butt")
        ax.plot([ends[1]], [place], "|", color=COLOURS[0], markersize=11, markeredgewidth=2)
    ax.axvline(1.0, color="0.4", linewidth=0.8, zorder=-2)
    ax.set_yticks(range(len(rows)), [label(row.answer) for row in reversed(rows)])
    low, high = ax.get_xlim()
    ax.set(xlabel="over the nominal value", xlim=(max(low, 0.0), min(high, WIDEST)))
    return ax


def front(ax: Axes | None, x: Values, y: Values, names: tuple[str, str]) -> Axes:
    """A trade-off: a point for each design, in order."""
    ax = axes(ax)
    ax.plot(x, y, color=COLOURS[0], linewidth=1.0, marker="o", markersize=5)
    ax.set(xlabel=label(names[0]), ylabel=label(names[1]))
    return ax


def residuals(ax: Axes | None, x: Values, y: Values, deviation: float, names: tuple[str, str]) -> Axes:
    """What a fit leaves, over where it was measured; tinted within two standard deviations."""
    ax = axes(ax)
    ax.axhspan(-2 * deviation, 2 * deviation, color=DETACHED, zorder=-3, linewidth=0)
    ax.axhline(0.0, color="0.4", linewidth=0.8, zorder=-2)
    ax.plot(x, y, linestyle="none", marker="o", markersize=4, color=COLOURS[0])
    ax.set(xlabel=label(names[0]), ylabel=label(names[1]))
    return ax


def loop(ax: Axes | None, x: Values, F: Values, force: Values, names: tuple[str, str], of: str = "fitted") -> Axes:
    """A measured force-displacement loop and the force of a model, which `of` names."""
    ax = axes(ax)
    ax.plot(x, F, linestyle="none", marker=".", markersize=2, color="0.6", label="measured")
    ax.plot(x, force, color=COLOURS[0], label=of)
    ax.set(xlabel=label(names[0]), ylabel=label(names[1]))
    ax.legend()
    return ax


def design_map(ax: Axes | None, x: tuple[str, Values], y: tuple[str, Values], values: tuple[str, Values]) -> Axes:
    """A number of each design over two of its parameters: each a name and values; grey where there is no answer.

    x of shape (n,), y of shape (m,), values of shape (m, n).
    """
    ax = axes(ax)
    ax.set_facecolor(NO_ANSWER)
    known = np.ma.masked_invalid(values[1])
    drawn = ax.pcolormesh(x[1], y[1], known, cmap="cividis", shading="nearest", rasterized=True)
    ax.figure.colorbar(drawn, ax=ax, label=label(values[0]))
    if min(known.shape) > 1 and np.unique(known.compressed()).size > 1:
        ax.clabel(ax.contour(x[1], y[1], known, levels=5, colors="k", linewidths=0.6), fontsize="small")
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
    # a label that begins with an underscore is in no legend of its own
    tinted = {str(one.get_label()) for one in (*ax.patches, *ax.collections)}
    for start, tint in (("_beyond", DETACHED), ("_stops", STOPPING), ("_unstable", UNSTABLE_REGION)):
        yield from ((Patch(color=tint), one[1:]) for one in sorted(tinted) if one.startswith(start))
