"""The paper's figures. Takes Matplotlib axes; returns Figs. 1b to 7b with the parameters of their captions.

`FIGURES` has them by number, each with what was chosen where its caption leaves a value open; `draw` writes files.
Numbers come from the solvers and the equation of motion; tests/app/test_figures.py has what they are compared with.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.lines import Line2D

from slowflow import example
from slowflow.answers import pictures
from slowflow.answers.pictures import COLOURS, STABLE, label, ramp
from slowflow.core.mechanism import EquationOfMotion, linear
from slowflow.exact.response import exact_response
from slowflow.example import TABLE_1
from slowflow.oscillators.isolator import Duffing, Isolator
from slowflow.support import progress
from slowflow_kernels import den_hartog

#: as the captions have them; lam is 3 throughout
LAM, R_CAPTIONS = 3.0, 2.03
#: (6 r)^-1 with r as in Table 1, at which alpha = 1/2
PRELOAD = TABLE_1["delta_h"]
#: the forcing of Figs. 3 and 4, which Fig. 2b does not state
F_0 = 0.05
#: of Figs. 3 to 5
FRICTION_3, FRICTION_5 = 0.01, 0.012
ZETA = 0.02

#: what the captions leave open
PRELOADS_1B = (0.0, 0.04, PRELOAD, 2 * PRELOAD, 0.25)
RATIOS_2A = (0.2, 0.4, 0.6, 0.7)
RATIOS_2B = (0.1, 0.3, 0.5, 0.7)
STIFFNESS_3A = (1.0, TABLE_1["r"], 3.0, 4.0)
PRELOADS_3B = (0.04, 1 / (6 * R_CAPTIONS), 0.12, 1 / (3 * R_CAPTIONS))
FRICTIONS_4A = (0.0, 0.01, 0.02, 0.03, 0.04)
DAMPINGS_4B = ((0.02, 0.0), (0.02, 0.01), (0.02, 0.02), (0.05, 0.01))
ZETAS_5A = (0.01, 0.02, 0.05, 0.1)
FRICTIONS_5B = (0.0, 0.006, 0.012, 0.024)

#: windows of Omega and A
NEAR_RESONANCE = (0.3, 1.6)
EXAMPLE, A_EXAMPLE = (0.5, 1.3), 0.8
#: points along the preload, and along either axis of the region that would be unstable
POINTS, SHADING = 400, 400


@dataclass(frozen=True)
class Figure:
    """draw -- into axes; caption -- the parameters; chosen -- those that the paper's caption leaves open"""

    draw: Callable[[Any], None]
    caption: str
    chosen: str = ""


def figure_1b(ax: Any) -> None:
    """The static characteristic (5), untruncated; dots where the springs detach."""
    u = np.linspace(0.0, 0.8, 801)
    for delta_h, colour in zip(PRELOADS_1B, ramp(len(PRELOADS_1B)), strict=True):
        with warnings.catch_warnings():  # of the negative stiffness at rest, which this figure is to show
            warnings.simplefilter("ignore", UserWarning)
            isolator = example.isolator(delta_h=delta_h)
        force = isolator.restoring_force("untruncated")
        ax.plot(u, [force.value(one) for one in u.tolist()], color=colour, linewidth=1.6, label=f"{delta_h:.3g}")
        if delta_h > 0:
            (u_cr,) = isolator.breakpoints
            ax.plot([u_cr], [force.value(u_cr)], "o", color=colour, markeredgecolor="white")
    ax.set(xlim=(0.0, 0.8), xlabel=label("u"), ylabel=r"restoring force $u + F_k(u)$")
    pictures.legend(ax, r"$\delta_h$", more=[(_dot(), "springs detach")])


def figure_2a(ax: Any, ratios: tuple[float, ...] = RATIOS_2A) -> None:
    """Den Hartog's (35) where (36) holds, the exact motion, and the averaged amplitude, in units of F_0, over mu/F_0.

    Linear spring, dry friction alone; on both sides of Omega = 1, where every amplitude is infinite.
    """
    for ratio, colour in zip(ratios, COLOURS, strict=False):
        system = EquationOfMotion(linear(), ratio, 0.0)
        averaged = Duffing(1.0, 0.0, mu=ratio, zeta=0.0)
        for window in ((0.3, 0.96), (1.04, 2.0)):
            name = f"{ratio:g}" if window[0] < 1 else None
            band(ax, exact_response(system, 1.0, Omega=window), colour)
            curve = averaged.frequency_response(1.0, Omega=window)
            pictures.curve(ax, curve.Omega, curve.A, curve.stable, curve.branch, colour=colour, name=name)
            Omega = np.linspace(*window, 25)
            ax.plot(Omega, _continuous(Omega, ratio), color=colour, linestyle="none", marker="o", markersize=3)
    ax.set(xlim=(0.3, 2.0), ylim=(0.0, 8.0), xlabel=label("Omega"), ylabel="amplitude $A/F_0$")
    _methods(ax, r"$\mu/F_0$, averaged", closed=True)


def figure_2b(ax: Any, ratios: tuple[float, ...] = RATIOS_2B) -> None:
    """The averaged curve on top of the exact one, both of the truncated force."""
    for ratio, colour in zip(ratios, COLOURS, strict=False):
        isolator = example.isolator(mu=ratio * F_0, zeta=ZETA)
        band(ax, isolator.exact_response(F_0, Omega=(0.4, 1.4), force="truncated"), colour)
        curve = isolator.frequency_response(F_0, Omega=(0.4, 1.4))
        pictures.curve(ax, curve.Omega, curve.A, curve.stable, curve.branch, colour=colour, name=f"{ratio:g}")
    ax.set(xlim=(0.4, 1.4), xlabel=label("Omega"), ylabel=label("A"))
    ax.set_ylim(bottom=0.0)
    pictures.breakpoints(ax, example.isolator().breakpoints)
    _methods(ax, r"$\mu/F_0$, averaged", closed=False)


def figure_3a(ax: Any) -> None:
    """The response for several stiffness ratios; u_cr does not depend on them."""
    _responses(ax, ((f"{r:.3g}", isolator(r=r)) for r in STIFFNESS_3A), "$r$")


def figure_3b(ax: Any) -> None:
    """The response for several preloads; a dotted line at the u_cr of each."""
    these = [(f"{delta_h:.3g}", isolator(delta_h=delta_h)) for delta_h in PRELOADS_3B]
    _responses(ax, these, r"$\delta_h$", beyond=False, more=[(_dotted(), "$u_{cr}$")])
    for (_, one), colour in zip(these, ramp(len(these)), strict=True):
        ax.axhline(one.breakpoints[0], color=colour, linewidth=0.8, linestyle=":")


def figure_4a(ax: Any) -> None:
    """The response with dry friction alone, unbounded for any friction below pi F_0/4."""
    _responses(ax, ((f"{mu:g}", isolator(mu=mu, zeta=0.0)) for mu in FRICTIONS_4A), r"$\mu$")
    ax.set_ylim(0.0, 1.0)


def figure_4b(ax: Any) -> None:
    """The response with viscous damping and dry friction, and the limit envelope (27) of each, dotted."""
    these = [(rf"{zeta:g}, {mu:g}", isolator(mu=mu, zeta=zeta)) for zeta, mu in DAMPINGS_4B]
    _responses(ax, these, r"$\zeta$, $\mu$", more=[(_dotted(), "limit envelope (27)")])
    Omega, top = np.linspace(*NEAR_RESONANCE, POINTS), ax.get_ylim()[1]
    for (_, one), colour in zip(these, ramp(len(these)), strict=True):
        ax.plot(Omega, one.limit_envelope(Omega=Omega, F_0=F_0), color=colour, linewidth=0.8, linestyle=":")
    ax.set_ylim(0.0, top)


def figure_5a(ax: Any) -> None:
    """F_cr over the preload up to quasi-zero stiffness for several damping ratios."""
    _detachments(ax, ((f"{zeta:g}", {"mu": FRICTION_5, "zeta": zeta}) for zeta in ZETAS_5A), r"$\zeta$")


def figure_5b(ax: Any) -> None:
    """The same for several friction forces."""
    _detachments(ax, ((f"{mu:g}", {"mu": mu, "zeta": ZETA}) for mu in FRICTIONS_5B), r"$\mu$")


def figure_6a(ax: Any) -> None:
    """u_cr over the preload, with that of Table 1 marked; beyond it the springs detach."""
    delta_h = _preloads(TABLE_1["r"])
    found = Isolator.many(**{**TABLE_1, "delta_h": delta_h}).detachment()
    _critical(ax, delta_h, found.u_cr, example.isolator().u_cr, "critical displacement $u_{cr}$")


def figure_6b(ax: Any) -> None:
    """F_cr over the preload, with that of Table 1 marked; beyond it the springs detach."""
    delta_h = _preloads(TABLE_1["r"])
    found = Isolator.many(**{**TABLE_1, "delta_h": delta_h}).detachment()
    _critical(ax, delta_h, found.F_cr, example.isolator().detachment().F_cr, label("F_cr"))


def figure_7a(ax: Any) -> None:
    """A(Omega) at the forcings of Table 2, folds, and the region that would be unstable, whatever the forcing (30)."""
    isolator = example.isolator()
    pictures.responses(
        ax, [(isolator.frequency_response(F, Omega=EXAMPLE), isolator.saddle_nodes(F)) for F in forcings()]
    )
    w = np.linspace(*EXAMPLE, SHADING)[np.newaxis, :]
    A = np.linspace(A_EXAMPLE / SHADING, A_EXAMPLE, SHADING)[:, np.newaxis]
    unstable = isolator.stability(Omega=w, A=A)
    region = ax.contourf(w[0], A[:, 0], unstable, levels=[-np.inf, 0], colors=[pictures.UNSTABLE_REGION], zorder=-2)
    region.set_label("_unstable region")
    ax.set(xlim=EXAMPLE, ylim=(0.0, A_EXAMPLE))
    pictures.breakpoints(ax, isolator.breakpoints)
    pictures.legend(ax, "$F_0$")


def figure_7b(ax: Any) -> None:
    """The phase of the same."""
    isolator = example.isolator()
    pictures.responses(ax, [(isolator.frequency_response(F, Omega=EXAMPLE), None) for F in forcings()], "phi")
    ax.set_xlim(EXAMPLE)
    pictures.legend(ax, "$F_0$")


def band(ax: Any, found: Any, colour: Any) -> None:
    """A curve of the equation of motion as a broad band, so that another on top of it shows; bars where it stops."""
    pictures.curve(ax, found.Omega, found.A, found.stable, colour=colour, width=5.0, alpha=0.3)
    stops = found.stops > 0
    ax.plot(
        found.Omega[stops],
        found.A[stops],
        linestyle="none",
        marker=pictures.STOPS,
        color=colour,
        markevery=pictures.APART,
    )


def isolator(**changes: Any) -> Isolator:
    """That of the captions of Figs. 3 and 4."""
    parameters: dict[str, Any] = {"lam": LAM, "r": R_CAPTIONS, "delta_h": PRELOAD, "mu": FRICTION_3, "zeta": ZETA}
    return Isolator(**{**parameters, **changes})


def forcings() -> list[float]:
    """Those of Table 2 from F_SN on."""
    one = example.isolator()
    found = (one.saddle_node_onset().F_SN, 0.025, one.detachment().F_cr, 0.04, 0.05)
    return [value for value in found if value is not None]


FIGURES = {
    "1b": Figure(
        figure_1b, "lam and r of Table 1", "preloads 0 to 0.25, among them those of alpha = 1/2 and alpha = 0"
    ),
    "2a": Figure(figure_2a, "delta_h = 0, zeta = 0", "mu/F_0"),
    "2b": Figure(figure_2b, "lam = 3, delta_h = (6 r)^-1, zeta = 0.02", "Table 1's r, F_0 = 0.05, mu/F_0"),
    "3a": Figure(figure_3a, "lam = 3, zeta = 0.02, mu = 0.01, F_0 = 0.05", "r, at Table 1's delta_h, for u_cr to stay"),
    "3b": Figure(figure_3b, "lam = 3, r = 2.03, zeta = 0.02, mu = 0.01, F_0 = 0.05", "delta_h"),
    "4a": Figure(figure_4a, "lam = 3, r = 2.03, delta_h = (6 r)^-1, zeta = 0, F_0 = 0.05", "mu"),
    "4b": Figure(figure_4b, "lam = 3, r = 2.03, delta_h = (6 r)^-1, F_0 = 0.05", "zeta and mu"),
    "5a": Figure(figure_5a, "lam = 3, r = 2.03, mu = 0.012", "zeta"),
    "5b": Figure(figure_5b, "lam = 3, r = 2.03, zeta = 0.02", "mu"),
    "6a": Figure(figure_6a, "Table 1"),
    "6b": Figure(figure_6b, "Table 1"),
    "7a": Figure(figure_7a, "Table 1, forcings of Table 2"),
    "7b": Figure(figure_7b, "Table 1, forcings of Table 2"),
}


#: what each format records of itself that would differ between two runs
UNDATED = {"png": "Software", "svg": "Date", "pdf": "CreationDate", "pgf": None}


def draw(
    folder: Path,
    names: Iterable[str] = tuple(FIGURES),
    formats: Iterable[str] = ("png", "svg"),
    *,
    width: float = 7.2,
    style: Sequence[str] = (),
) -> list[Path]:
    """Draw figures by number; return the files written. Without a display, and the same bytes each time.

    formats -- keys of `UNDATED`; pgf needs XeLaTeX, or a style sheet with "pgf.texsystem: pdflatex"
    width   -- in inches; text is 10 points high on figures of the default width, and 7 in a column of a journal
    style   -- style sheets of Matplotlib, applied last
    """
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    narrow = width < pictures.NARROW  # the legend is below the axes then
    column = {"font.size": 7.0, "axes.linewidth": 0.5} if narrow else {}
    fixed = {"svg.hashsalt": "slowflow", "svg.fonttype": "path", **column}
    with plt.rc_context(fixed), plt.style.context(list(style)):
        for name in names:
            figure = mpl.figure.Figure(figsize=(width, width * (0.9 if narrow else 4.4 / 7.2)), layout="constrained")
            with progress.named(f"Fig. {name}"):
                FIGURES[name].draw(figure.subplots())
            for suffix in formats:
                path = folder / f"fig_{name}.{suffix}"
                undated = {"metadata": {UNDATED[suffix]: None}} if UNDATED[suffix] else {}  # pgf takes no metadata
                figure.savefig(path, dpi=160, **undated)
                written.append(path)
    return written


def _methods(ax: Any, title: str, *, closed: bool) -> None:
    """What a band and a dot stand for, as curves without points for the legend."""
    ax.plot([], [], color="0.4", linewidth=5.0, alpha=0.3, label="equation of motion")
    if closed:
        ax.plot([], [], "o", color="0.4", markersize=3, label="Den Hartog (35)")
    pictures.legend(ax, title)


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


def _dotted() -> Any:
    """A dotted line for a legend."""
    return Line2D([], [], color="0.4", linewidth=0.8, linestyle=":")


def _dot() -> Any:
    """A dot for a legend."""
    return Line2D([], [], color="0.4", linestyle="none", marker="o")


def _responses(
    ax: Any,
    these: Iterable[tuple[str, Isolator]],
    title: str,
    *,
    beyond: bool = True,
    more: Sequence[tuple[Any, str]] = (),
) -> None:
    """Response curves at F_0 with their folds, each isolator under its name."""
    listed = list(these)
    found = [(one.frequency_response(F_0, Omega=NEAR_RESONANCE), one.saddle_nodes(F_0)) for _, one in listed]
    pictures.responses(ax, found, names=[name for name, _ in listed])
    ax.set(xlim=NEAR_RESONANCE)
    if beyond:
        pictures.breakpoints(ax, listed[0][1].breakpoints)
    pictures.legend(ax, title, more=more)


def _preloads(r: float) -> Any:
    """From near 0 to quasi-zero stiffness, more of them where u_cr rises steeply."""
    return np.linspace(1e-3, 1.0, POINTS) ** 2 / (LAM * r)


def _detachments(ax: Any, these: Iterable[tuple[str, dict[str, Any]]], title: str) -> None:
    """F_cr over the preload, and its limit 4 mu/pi as that vanishes, a dot on the left."""
    listed = list(these)
    delta_h = _preloads(R_CAPTIONS)
    for (name, damping), colour in zip(listed, ramp(len(listed)), strict=True):
        found = Isolator.many(lam=LAM, r=R_CAPTIONS, delta_h=delta_h, **damping).detachment()
        ax.plot(delta_h, found.F_cr, linestyle=STABLE, color=colour, linewidth=1.6, label=name)
        ax.plot([0.0], [4 * damping["mu"] / math.pi], "o", color=colour, markeredgecolor="white", clip_on=False)
    ax.set(xlim=(0.0, delta_h[-1]), xlabel=label("delta_h"), ylabel=label("F_cr"))
    ax.set_ylim(bottom=0.0)
    pictures.legend(ax, title, more=[(_dot(), r"limit $4\mu/\pi$")])


def _critical(ax: Any, delta_h: Any, values: Any, marked: float | None, name: str) -> None:
    """A critical value over the preload, hatched beyond, Table 1's as a dot."""
    top = 1.15 * float(np.max(values))
    ax.fill_between(delta_h, values, top, facecolor="none", edgecolor="0.75", hatch="///", linewidth=0)
    ax.plot(delta_h, values, color="black", linewidth=2.4)
    ax.plot([TABLE_1["delta_h"]], [marked], "o", color="#C00000", markersize=8, label=f"Table 1: {marked:.4f}")
    ax.set(xlim=(0.0, delta_h[-1]), ylim=(0.0, top), xlabel=label("delta_h"), ylabel=name)
    pictures.legend(ax, place="in")
