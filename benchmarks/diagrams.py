"""Pictures of what `benchmarks.work_precision` measured: its rows in, PNG out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib import pyplot as plt
from matplotlib.axes import Axes

from benchmarks.document import quantity

U = 2.0**-53
#: colour-blind safe; a method keeps its colour in every picture
COLOURS = {
    "slowflow": "#0072B2",
    "numpy.roots": "#D55E00",
    "bracketing": "#009E73",
    "the paper's recipe": "#CC79A7",
    "heyoka, events": "#E69F00",
    "DOP853, events": "#D55E00",
    "LSODA, events": "#009E73",
    "Radau, events": "#000000",
    "AUTO-07p via bifpy": "#882255",
}
MARKERS = dict(zip(COLOURS, "oo^DvPsdX", strict=True))
#: offset of a text in points, and which of its ends is there
BELOW, ABOVE = ((0, -7), "center", "top"), ((0, 7), "center", "bottom")
LEFT, RIGHT = ((-8, 0), "right", "center"), ((9, 0), "left", "center")
#: position of a method's name at its most accurate point, if not below it
NAME_POSITIONS = {
    ("response", "numpy.roots"): ((-28, -3), "right", "top"),
    ("folds", "numpy.roots"): LEFT,
    ("onset", "numpy.roots"): RIGHT,
    ("motion", "DOP853, events"): LEFT,
    ("motion", "LSODA, events"): ((4, -14), "left", "top"),
    ("motion", "the paper's recipe"): RIGHT,
    ("motion", "AUTO-07p via bifpy"): ((0, -17), "center", "top"),
}
#: methods named above their least accurate point
ON_TOP = ("bracketing",)
#: the same for the pictures of cost against size, if not to the right of the last point
SIDES = {
    "bracketing": ((-8, 3), "right", "center"),
    "numpy.roots": ((4, 18), "center", "bottom"),
    "F_SN: slowflow": ((-8, 2), "right", "bottom"),
}
STYLE = {"font.size": 9, "axes.spines.top": False, "axes.spines.right": False}


def draw(results: dict[str, Any], folder: Path) -> None:
    """work_precision.png, of error against time, and scaling.png, of cost against size."""
    folder.mkdir(parents=True, exist_ok=True)
    with matplotlib.rc_context(STYLE):
        scenes = results["scenes"]
        figure, axes = plt.subplots(1, len(scenes), figsize=(4.6 * len(scenes), 4.4), layout="constrained", sharey=True)
        for scene, ax in zip(scenes, axes, strict=True):
            _scene(ax, scene)
        axes[0].set_ylabel("relative error: largest (marker) down to median (bar)")
        _save(figure, folder / "work_precision")
        figure, axes = plt.subplots(1, 3, figsize=(13.8, 4.4), layout="constrained")
        _sizes(axes[0], results["scaling"]["amplitudes"], "amplitudes", "every Ω of the response at each amplitude")
        _sizes(
            axes[1],
            results["scaling"]["designs"],
            "designs",
            "critical forcings of random designs: F_cr solid, F_SN dashed",
        )
        _stops(axes[2], results["scaling"]["stops"])
        axes[0].set_ylabel("seconds")
        _save(figure, folder / "scaling")


def _save(figure: Any, path: Path) -> None:
    figure.savefig(path.with_suffix(".png"), dpi=150, metadata={"Software": None})
    plt.close(figure)


def _scene(ax: Axes, scene: dict[str, Any]) -> None:
    ax.set(xscale="log", yscale="log", ylim=(1e-19, 10), xlabel="seconds", title=scene["title"])
    ax.title.set_fontsize(10)
    ax.axhline(U, color="0.8", lw=0.8, zorder=0)
    ax.annotate("u = 2⁻⁵³", (1, U), xycoords=("axes fraction", "data"), ha="right", va="bottom", color="0.5", size=7.5)
    for method in dict.fromkeys(row["method"] for row in scene["rows"]):
        rows = [row for row in scene["rows"] if row["method"] == method]
        colour, marker = COLOURS[method], MARKERS[method]
        leftmost, labelled = rows[0]["variant"].split(",")[0], list[str]()
        for row in rows:
            if row["error"] is None:
                # nothing right was found: there is no error to show
                ax.plot(row["seconds"], 1, "x", color=colour, ms=8, mew=2)
                _label(ax, row["seconds"], 1, f"{row['variant'].split(',')[0]}: wrong", colour, RIGHT)
                continue
            low, high = _shown(row["error"]), _shown(row["error_max"])
            ax.plot([row["seconds"]] * 2, [low, high], color=colour, lw=1.2)
            whole, setting = row["missed"] == 0, row["variant"].split(",")[0]
            ax.plot(row["seconds"], high, marker, color=colour, mfc=colour if whole else "white", ms=6.5)
            if not whole and setting not in labelled:
                labelled.append(setting)
                side = ABOVE if len(rows) == 1 else LEFT if setting == leftmost else RIGHT
                _label(ax, row["seconds"], high, f"{setting}: {row['missed']} missed", colour, side)
        found = sorted((row for row in rows if row["error"] is not None), key=lambda row: row["error_max"])
        if method in ON_TOP:
            row, place = found[-1], ABOVE
        else:
            row, place = found[0], NAME_POSITIONS.get((scene["scene"], method), BELOW)
        y = row["error"] if place is BELOW else row["error_max"]
        _label(ax, row["seconds"], _shown(y), method.replace(", ", ",\n"), colour, place, weight="bold", size=9)
    low, high = ax.get_xlim()
    ax.set_xlim(low / 3, high * 12)


def _shown(error: float) -> float:
    """An error of nothing is drawn at the bottom."""
    return max(error, 2e-17)


def _label(ax: Axes, x: float, y: float, text: str, colour: str, place: Any, **font: Any) -> None:
    offset, ha, va = place
    font = {"size": 7.5, **font}
    ax.annotate(text, (x, y), xytext=offset, textcoords="offset points", color=colour, ha=ha, va=va, **font)


def _sizes(ax: Axes, rows: list[dict[str, Any]], unit: str, title: str) -> None:
    ax.set(xscale="log", yscale="log", xlabel=f"number of {unit}", title=title)
    ax.title.set_fontsize(10)
    for name in dict.fromkeys(row["method"] for row in rows):
        size, seconds = np.array([(row["size"], row["seconds"]) for row in rows if row["method"] == name]).T
        method = name.split(": ")[-1]
        dashed = name.startswith("F_SN")
        ax.plot(size, seconds, "--" if dashed else "-", marker=MARKERS[method], color=COLOURS[method], ms=4, lw=1.3)
        text = f"{name.replace('slowflow, ', '')}, {quantity(seconds[-1] / size[-1], 's')} each"
        place = SIDES.get(name, ((7, 3), "left", "center"))
        _label(ax, size[-1], seconds[-1], text.replace(", ", "\n").replace(": ", "\n"), COLOURS[method], place, size=8)
    low, high = ax.get_xlim()
    ax.set_xlim(low, high * 30)
    low, high = ax.get_ylim()
    ax.set_ylim(low, high * 10)  # room for the names above the ends


def _stops(ax: Axes, rows: list[dict[str, Any]]) -> None:
    ax.set(xlabel="stops per period", ylabel="microseconds", title="one periodic motion of a linear spring")
    ax.title.set_fontsize(10)
    method = "slowflow"
    stops, seconds = np.array([(row["stops"], row["seconds"]) for row in rows]).T
    ax.plot(stops, 1e6 * seconds, "-", marker=MARKERS[method], color=COLOURS[method], ms=4, lw=1.3)
    ax.set_ylim(bottom=0)
