"""The figures and the page docs/validity.md. Takes the numbers that `benchmarks.validity` measured; returns files."""

from __future__ import annotations

import functools
import itertools
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np

from benchmarks import claims_page
from benchmarks.document import Columns, columns_of, table
from derivations.ledger import measured
from examples.paper import figures
from slowflow import example
from slowflow.answers import pictures

mpl.use("Agg")
import matplotlib.pyplot as plt

TEMPLATE = Path(__file__).with_name("validity_template.md")
#: error from which on every answer at that mu/F_0 gets a remark
REMARKED = 1 / 3
#: errors in per cent between which the colours of a map run; the numbers in the cells have no limit
COLOURS = mpl.colors.SymLogNorm(linthresh=0.5, vmin=-50, vmax=50, base=10)
TICKS = (-50, -10, -2, 0, 2, 10, 50)
MAP = "RdBu_r"
#: bins of mu/(A Omega^2) that the page speaks of, by the name they have there
BINS = (("1", 2), ("3", 4), ("5", 5))
#: of the bands of random vibration that in which linearization is worst
NARROWEST = 1.25
WINDOW_7A = (0.5, 1.3)
FORCES = ("untruncated", "truncated")
#: of mu/F_0, in tables
RANGES = ((0, 0.3), (0.4, 0.5), (0.55, 0.65), (0.7, 0.77))
NAMES = {"A": "largest amplitude", "jump-up": "Omega of the jump up", "jump-down": "Omega of the jump down"}


def write(numbers: dict[str, Any], folder: Path) -> None:
    """docs/validity*.png, docs/fig_2a.png, fig_2b.png, fig_7a_exact.png and docs/validity.md."""
    folder.mkdir(parents=True, exist_ok=True)
    drawings = {
        "validity_resonance": functools.partial(resonance, numbers),
        "validity_second": functools.partial(second, numbers),
        "validity_critical": functools.partial(critical, numbers),
        "validity_plane": functools.partial(plane, numbers),
        "validity_truncation": functools.partial(truncation, numbers),
        "validity_rest": functools.partial(rest, numbers),
        "fig_7a_exact": overlay_7a,
        "fig_2a": functools.partial(of_the_paper, "2a"),
        "fig_2b": functools.partial(of_the_paper, "2b"),
    }
    for name, draw in drawings.items():
        figure = draw()
        figure.savefig(folder / f"{name}.png", dpi=110, metadata={"Software": None})
        plt.close(figure)
    (folder / "validity.md").write_text(page(numbers), encoding="utf-8")


def cells(ax: Any, values: list[list[float | None]], x: Iterable[float], y: Iterable[float]) -> Any:
    """A map of errors in per cent: colour and number; a dot where nothing could be measured."""
    array = np.array([[np.nan if v is None else 100 * v for v in row] for row in values], dtype=float)
    image = ax.imshow(array, norm=COLOURS, cmap=MAP, aspect="auto", origin="lower")
    for (i, j), value in np.ndenumerate(array):
        text = (
            "·"
            if np.isnan(value)
            else f"{value:.0f}"
            if abs(value) >= 9.95
            else f"{value + 0.0:.1f}".replace("-0.0", "0.0")
        )
        dark = not np.isnan(value) and abs(COLOURS(value) - 0.5) > 0.36
        ax.text(j, i, text, ha="center", va="center", fontsize=7, color="white" if dark else "black")
    ax.set_xticks(range(array.shape[1]), [f"{v:g}" for v in x], fontsize=7)
    ax.set_yticks(range(array.shape[0]), [f"{v:g}" for v in y], fontsize=7)
    return image


def _axis(found: list[dict[str, Any]], name: str) -> list[float]:
    return sorted({cell[name] for cell in found})


def _lookup(found: list[dict[str, Any]], **values: float) -> dict[str, Any]:
    for cell in found:
        if all(cell[name] == value for name, value in values.items()):
            return cell
    return {}


def resonance(numbers: dict[str, Any]) -> Any:
    """Errors over mu/F_0 and zeta: a column of panels for each quantity, a row for each preload and level."""
    found = numbers["resonance"]
    ratios, zetas, levels, preloads = (_axis(found, name) for name in ("ratio", "zeta", "level", "delta_h"))
    rows = [(level, delta_h) for level in levels for delta_h in preloads]
    figure, axes = plt.subplots(len(rows), 3, figsize=(14, 13), layout="constrained")
    for line, (level, delta_h) in zip(axes, rows, strict=True):
        for ax, (quantity, title) in zip(line, NAMES.items(), strict=True):
            values = [
                [
                    _lookup(found, ratio=ratio, zeta=zeta, level=level, delta_h=delta_h).get("exact", {}).get(quantity)
                    for ratio in ratios
                ]
                for zeta in zetas
            ]
            image = cells(ax, values, ratios, zetas)
            ax.set_title(f"{title}; delta_h = {delta_h:.3g}, A/u_cr = {level:g}", fontsize=8)
            ax.set_ylabel("zeta", fontsize=8)
    for ax in axes[-1]:
        ax.set_xlabel("mu/F_0", fontsize=8)
    figure.colorbar(image, ax=axes, shrink=0.4, label="averaged / exact - 1, in per cent", ticks=TICKS, format="%g")
    return figure


def second(numbers: dict[str, Any]) -> Any:
    """Errors of averaging and of the second approximation over mu/F_0: half of the designs, and all."""
    found = numbers["resonance"]
    ratios = _axis(found, "ratio")
    figure, axes = plt.subplots(1, 3, figsize=(14, 4.2), layout="constrained", sharey=True)
    for ax, (quantity, title) in zip(axes, NAMES.items(), strict=True):
        for kind, name, colour in (
            ("exact", "averaging", "0.45"),
            ("second", "second approximation", pictures.COLOURS[0]),
        ):
            sizes = [
                [
                    abs(cell[kind][quantity])
                    for cell in found
                    if cell["ratio"] == ratio and quantity in cell.get(kind, {})
                ]
                for ratio in ratios
            ]
            for quantile, style in ((0.5, "-"), (1.0, ":")):
                values = [100 * float(np.quantile(some, quantile)) if some else np.nan for some in sizes]
                label = f"{name}, {'half' if quantile < 1 else 'all'} of the designs within"
                ax.plot(ratios, values, style, marker="o", markersize=3, color=colour, label=label)
        ax.set(yscale="log", xlabel="mu/F_0", title=title)
        ax.grid(alpha=0.3)
    axes[0].set_ylabel("|computed / exact - 1|, per cent")
    axes[0].legend(fontsize=7)
    return figure


def critical(numbers: dict[str, Any]) -> Any:
    """Errors of F_SN and F_cr over mu/F and zeta, a row of panels for each; an asterisk where F_SN is a corner's."""
    found = numbers["onsets"]
    ratios, zetas, preloads = (_axis(found, name) for name in ("ratio", "zeta", "delta_h"))
    figure, axes = plt.subplots(2, len(preloads), figsize=(13, 4.6), layout="constrained")
    for line, quantity in zip(axes, ("F_SN", "F_cr"), strict=True):
        for ax, delta_h in zip(line, preloads, strict=True):
            values = [
                [
                    (_lookup(found, ratio=ratio, zeta=zeta, delta_h=delta_h).get(quantity) or {}).get("exact")
                    for ratio in ratios
                ]
                for zeta in zetas
            ]
            image = cells(ax, values, ratios, zetas)
            for i, zeta in enumerate(zetas):
                for j, ratio in enumerate(ratios):
                    cell = _lookup(found, ratio=ratio, zeta=zeta, delta_h=delta_h)
                    if quantity == "F_SN" and cell.get("kind") == "corner":
                        ax.text(j + 0.4, i, "*", ha="center", va="center", fontsize=9)
            ax.set_title(f"{quantity}; delta_h = {delta_h:.3g}", fontsize=8)
            ax.set_ylabel("zeta", fontsize=8)
            ax.set_xlabel(f"mu/{quantity}", fontsize=8)
    figure.colorbar(image, ax=axes, shrink=0.8, label="averaged / exact - 1, in per cent", ticks=TICKS, format="%g")
    return figure


def plane(numbers: dict[str, Any]) -> Any:
    """Table 1 at F_0 = 0.02: error of the highest stable amplitude over frequency and mu/F_0, hatched with stops."""
    rows = [row for row in numbers["plane"] if "Omega" in row]
    Omega = np.array(rows[0]["Omega"])
    ratios = np.array([row["ratio"] for row in rows])
    error = 100 * np.array([row["error"] for row in rows], dtype=float)
    stops = np.array([row["stops"] for row in rows])
    figure, ax = plt.subplots(figsize=(8, 4.6), layout="constrained")
    bounds = [-60, -30, -10, -5, -2, -1, 1, 2, 5, 10, 30, 60]
    colours = mpl.colors.BoundaryNorm(bounds, 256, extend="both")
    image = ax.pcolormesh(Omega, ratios, error, norm=colours, cmap=MAP, shading="nearest")
    if (stops > 0).any():
        ax.contourf(Omega, ratios, stops > 0, levels=[0.5, 1.5], colors="none", hatches=["///"])
    ax.axhline(np.pi / 4, color="black", linewidth=1)
    ax.annotate("pi/4", (1.55, np.pi / 4), xytext=(0, 2), textcoords="offset points", fontsize=8)
    ax.set(xlabel="frequency Omega", ylabel="mu/F_0", ylim=(0, 0.83))
    figure.colorbar(image, label="amplitude: averaged / exact - 1, in per cent", ticks=bounds)
    return figure


def truncation(numbers: dict[str, Any]) -> Any:
    """What (6) costs against (5), and averaging (6) against the truth, over A/u_cr and u_cr."""
    found = numbers["truncation"]
    levels, ends = _axis(found, "level"), _axis(found, "u_cr")
    figure, axes = plt.subplots(1, 2, figsize=(13, 3.6), layout="constrained")
    titles = {
        "A": "largest amplitude: exact, truncated / untruncated - 1",
        "averaged": "largest amplitude: averaged truncated / exact untruncated - 1",
    }
    for ax, (quantity, title) in zip(axes, titles.items(), strict=True):
        values = [[_lookup(found, level=level, u_cr=u_cr).get(quantity) for level in levels] for u_cr in ends]
        image = cells(ax, values, levels, [round(u_cr, 2) for u_cr in ends])
        ax.set_title(title, fontsize=8)
        ax.set(xlabel="A/u_cr", ylabel="u_cr")
    figure.colorbar(image, ax=axes, shrink=0.8, label="per cent", ticks=TICKS, format="%g")
    return figure


def rest(numbers: dict[str, Any]) -> Any:
    """Error of the amplitude over mu/(A Omega^2), a line for each bin of mu/F_0."""
    pool = numbers["pool"]
    edges = np.array(pool["rests"])
    # bins on a logarithmic axis: each at its middle, the open ones one step out
    at = np.sqrt(np.maximum(edges, 0.025) * np.append(edges[1:], 2 * edges[-1]))
    figure, axes = plt.subplots(1, 2, figsize=(11, 4), layout="constrained", sharey=True)
    for ax, quantity, title in zip(axes, ("median", "q95"), ("median", "95th percentile"), strict=True):
        for k, (ratio, row) in enumerate(zip(pool["ratios"], pool["both"], strict=True)):
            values = [np.nan if cell[quantity] is None else 100 * cell[quantity] for cell in row]
            end = pool["ratios"][k + 1] if k + 1 < len(pool["ratios"]) else np.pi / 4
            colour = pictures.ramp(len(pool["ratios"]))[k]
            ax.plot(at, values, marker="o", markersize=3, color=colour, label=f"{ratio:.3g} to {end:.3g}")
        ax.axvline(1, color="0.6", linewidth=0.8)
        ax.set(xscale="log", yscale="log", xlabel="mu/(A Omega^2)", title=title)
        ax.grid(alpha=0.3)
    axes[0].set_ylabel("amplitude: |exact / averaged - 1|, per cent")
    axes[1].legend(title="mu/F_0", fontsize=7)
    return figure


def overlay_7a() -> Any:
    """Fig. 7a: bands are the equation of motion with the untruncated force, in colour that with the truncated one."""
    isolator, forcings = example.isolator(), figures.forcings()
    figure, axes = plt.subplots(1, 2, figsize=(14, 6), layout="constrained")
    for ax in axes:
        for F_0, colour in zip(forcings, pictures.ramp(len(forcings)), strict=True):
            exact = {force: isolator.exact_response(F_0, Omega=WINDOW_7A, force=force) for force in FORCES}
            averaged = isolator.frequency_response(F_0, Omega=WINDOW_7A)
            figures.band(ax, exact["untruncated"], colour)
            one = exact["truncated"]
            pictures.curve(ax, one.Omega, one.A, one.stable, colour=colour, name=f"{F_0:.4g}")
            pictures.curve(
                ax, averaged.Omega, averaged.A, averaged.stable, averaged.branch, colour=pictures.COLOURS[1], width=0.8
            )
        ax.set(xlabel=pictures.label("Omega"), ylabel=pictures.label("A"))
    axes[0].set(xlim=WINDOW_7A, ylim=(0, 0.75), title="bands: (5); in their colours: (6); red: averaged, (6)")
    axes[1].set(xlim=(0.86, 1.03), ylim=(0.3, 0.68), title="the same near resonance")
    for ax in axes:
        pictures.breakpoints(ax, isolator.breakpoints)
    pictures.legend(axes[1], "$F_0$")
    return figure


def of_the_paper(name: str) -> Any:
    """A figure of the paper, as `make figures` draws it."""
    figure, ax = plt.subplots(figsize=(8, 5), layout="constrained")
    figures.FIGURES[name].draw(ax)
    return figure


def _largest(values: Iterable[float | None]) -> str:
    """The largest size among some errors, in per cent."""
    return _percent(max(abs(value) for value in values if value is not None))


def _percent(value: float) -> str:
    return f"{100 * value:.0f} %" if value >= 0.1 else f"{100 * value:.2g} %"


def remarked_from(pool: dict[str, Any]) -> float:
    """mu/F_0 from which on 95 of 100 amplitudes no longer lie within `REMARKED`."""
    both = zip(pool["ratios"], pool["by ratio"], strict=True)
    return float(min(edge for edge, cell in both if cell["q95"] > REMARKED))


def _at_resonance(numbers: dict[str, Any], quantity: str, ratios: tuple[float, float], force: str = "exact") -> str:
    return _largest(
        cell[force][quantity]
        for cell in numbers["resonance"]
        if ratios[0] <= cell["ratio"] <= ratios[1] and quantity in cell.get(force, {})
    )


def _critical(numbers: dict[str, Any], quantity: str, ratios: tuple[float, float], kind: str = "exact") -> str:
    """Without the onsets at a corner, which are not those of the force (5)."""
    return _largest(
        (cell.get(quantity) or {}).get(kind)
        for cell in numbers["onsets"]
        if ratios[0] <= cell["ratio"] <= ratios[1] and not (quantity == "F_SN" and cell.get("kind") == "corner")
    )


def _by_ratio(numbers: dict[str, Any], kind: str) -> str:
    """The table of largest errors of averaging ("exact") or of the second approximation."""
    rows = []
    for low, high in RANGES:
        sizes = [_at_resonance(numbers, quantity, (low, high), kind) for quantity in NAMES]
        sizes += [_critical(numbers, quantity, (low, high), kind) for quantity in ("F_SN", "F_cr")]
        rows.append((f"{low:g} to {high:g}", *sizes))
    head = ("mu/F_0", "largest amplitude", "jump up, Omega", "jump down, Omega", "F_SN", "F_cr")
    return "\n".join(table(head, rows))


def _second(numbers: dict[str, Any]) -> dict[str, Any]:
    """The tables of errors, and how often the number of folds is the exact one."""
    early = [cell for cell in numbers["resonance"] if "second" in cell and cell["ratio"] <= 0.65]
    wrong = {
        kind: sum(cell[kind]["folds"][0] != cell[kind]["folds"][1] for cell in early) for kind in ("exact", "second")
    }
    by_rest, pool = [], numbers["pool"]
    for edge, one, other in zip(pool["rests"], pool["by rest"], pool["second by rest"], strict=True):
        cells = [cell[kind] for cell in (one, other) for kind in ("median", "q95")]
        by_rest.append((f"{edge:g}", *("-" if v is None else _percent(v) for v in cells)))
    head = (
        "mu/(A Omega^2) from",
        *("averaging: median", "95th percentile", "second: median", "95th percentile"),
    )
    return {
        "second_by_ratio": _by_ratio(numbers, "second"),
        "second_by_rest": "\n".join(table(head, by_rest)),
        "second_q95": _percent(
            max(
                cell["q95"]
                for edge, cell in zip(pool["rests"], pool["second by rest"], strict=True)
                if edge < 1 and cell["q95"] is not None
            )
        ),
        "early_designs": len(early),
        "wrong_folds": wrong,
    }


def _table_2(rows: list[dict[str, Any]]) -> str:
    """Table 2 by each way."""
    ways = [way for way in rows[0] if way != "what"]
    cells = [(row["what"], *("-" if row[way] is None else f"{row[way]:.5f}" for way in ways)) for row in rows]
    return "\n".join(table(("result", *ways), cells))


def _random_table(rows: list[dict[str, Any]], *numbers: str) -> str:
    """Errors of random vibration by friction's share of the damping; lines are named by these numbers of a cell."""
    what = "mean and sigma_u over its" if "mean" in numbers else "sigma_u over its"
    shares = (f"{dry:g}" for dry in sorted({row["dry"] for row in rows}))
    head = (f"spring, {what} breakpoint", "excitation", *shares)
    lines: list[tuple[str, ...]] = []

    def errors(cells: Iterable[dict[str, Any]], way: str) -> Iterable[str]:
        # an asterisk: several equivalent oscillators
        for cell in cells:
            yield " / ".join(f"{100 * error:+.1f}" for error in cell[way]) + "*" * (cell["motions"] > 1)

    for (name, band), cells in itertools.groupby(
        rows, lambda row: (", ".join([row["spring"], *(f"{row[name]:g}" for name in numbers)]), row["band"])
    ):
        some = list(cells)
        within = "white noise" if band is None else f"Omega_e/{band:g} to {band:g} Omega_e"
        lines.append((name, within, *errors(some, "linearized")))
        if "records" in some[0]:
            lines.append(("", "simulated", *errors(some, "records")))
    return "\n".join(table(head, lines))


def _random(rows: list[dict[str, Any]]) -> dict[str, Any]:
    """Errors of random vibration about the centre and about a mean, and the largest of some of these."""
    offset = [row for row in rows if "marked" in row]
    rows = [row for row in rows if "marked" not in row]

    def largest(way: str, dry: float, *springs: str, narrow: bool = False) -> str:
        chosen = [row for row in rows if row["spring"] in springs and row["dry"] <= dry]
        return _largest(error for row in chosen if (row["band"] == NARROWEST) == narrow for error in row.get(way, ()))

    def largest_about(spring: str, *numbers: int, shares: tuple[float, ...], narrow: bool = False) -> str:
        """Of the mean (0), u_rms (1), v_rms (2)."""
        chosen = [row for row in offset if row["spring"] == spring and row["dry"] in shares]
        some = [row["linearized"] for row in chosen if (row["band"] == NARROWEST) == narrow]
        return _largest(errors[number] for errors in some for number in numbers)

    few, more = (0.0, 0.3, 0.6), (0.0, 0.3, 0.6, 0.8)
    rare = next(row for row in rows if (row["level"], row["band"], row["dry"]) == (0.25, None, 0.8))
    return {
        "random": _random_table(rows, "level"),
        "random_about": _random_table(offset, "mean", "level"),
        "random_margin": _largest(margin for row in rows for margin in row["margin"]),
        "random_about_margin": _largest(margin for row in offset for margin in row["margin"]),
        "random_about_isolator": largest_about("isolator", 1, 2, shares=few),
        "random_about_mean": largest_about("isolator", 0, shares=few),
        "random_about_dry": largest_about("isolator", 1, shares=(0.8,)),
        "random_about_dry_narrow": largest_about("isolator", 1, shares=(0.8,), narrow=True),
        "random_about_stop": largest_about("one stop", 1, shares=more),
        "random_about_stop_v": largest_about("one stop", 2, shares=more),
        "random_about_stop_v_narrow": largest_about("one stop", 2, shares=more, narrow=True),
        "random_about_stop_mean": largest_about("one stop", 0, shares=more, narrow=True),
        "random_at_6": largest("linearized", 0.6, "isolator"),
        "random_at_8": largest("linearized", 0.8, "isolator"),
        "random_narrow": largest("linearized", 0.8, "isolator", narrow=True),
        "random_stops": largest("linearized", 0.8, "stops"),
        "random_simulated": largest("records", 0.95, "isolator", "stops"),
        "random_simulated_margin": _largest(margin for row in rows if "records" in row for margin in row["margin"]),
        "random_rare": tuple(_percent(beyond) for beyond in rare["beyond"]),
    }


def _corners(numbers: dict[str, Any]) -> dict[str, Any]:
    """What the page says of the onsets at a corner, and of the motions that stop where they reach u_cr."""
    found = [cell["F_SN"] for cell in numbers["onsets"] if cell.get("kind") == "corner"]
    return {
        "corners": len(found),
        "corner_truncated": _largest(cell["truncated"] for cell in found),
        "corner_exact": _largest(cell["exact"] for cell in found),
        "without_fold": sum(cell["exact"] is None for cell in found),
        "reached_with_stops": sum(cell.get("F_cr", {}).get("stops", 0) > 0 for cell in numbers["onsets"]),
    }


def page(numbers: dict[str, Any]) -> str:
    """docs/validity.md: method, maps, what they show."""
    pool, found = numbers["pool"], numbers["resonance"]
    compared = [cell["exact"] for cell in found if "exact" in cell]
    other = sum(cell["folds"][0] != cell["folds"][1] for cell in compared)
    early = [
        cell
        for cell in found
        if "exact" in cell and cell["exact"]["folds"][0] != cell["exact"]["folds"][1] and cell["ratio"] <= 0.65
    ]
    spread: Columns = {
        "median": lambda cell: _percent(cell["median"]),
        "95th percentile": lambda cell: _percent(cell["q95"]),
    }
    by_rest: Columns = {
        "mu/(A Omega^2) from": lambda cell: f"{cell['from']:g}",
        "points": lambda cell: str(cell["points"]),
        "with sticking": lambda cell: f"{100 * cell['stopping']:.0f} %",
        **spread,
    }
    bins = [{"from": edge, **cell} for edge, cell in zip(pool["rests"], pool["by rest"], strict=True)]
    shares: Columns = {
        "motion": lambda cell: cell["motion"],
        "points": lambda cell: str(cell["points"]),
        "force of the exact curve: errors": lambda cell: cell["meant"],
        **spread,
    }
    motions = [
        {"motion": description, "meant": meant, **pool[kind][force]}
        for kind, description in (("moving", "without sticking"), ("stopping", "with sticking"))
        for force, meant in (("truncated", "truncated: one harmonic"), ("exact", "untruncated: harmonic, truncation"))
    ]
    truncated = _largest(cell.get("A") for cell in numbers["truncation"])
    at_table_1 = _largest(
        cell.get("A") for cell in numbers["truncation"] if cell["u_cr"] < 0.44 and cell["level"] > 0.9
    )
    return TEMPLATE.read_text(encoding="utf-8").format(
        integrator=numbers["integrator"],
        by_ratio=_by_ratio(numbers, "exact"),
        by_rest="\n".join(columns_of(by_rest, bins)),
        shares="\n".join(columns_of(shares, motions)),
        least_rest=pool["least rest with stops"],
        near=remarked_from(pool),
        **_second(numbers),
        table_2=_table_2(numbers["table 2"]),
        designs=len(compared),
        lost=sum("truncated" not in cell for cell in found),
        points=sum(cell["points"] for cell in pool["by rest"]),
        other=other,
        **{f"at_{name}": {kind: _percent(pool["by rest"][j][kind]) for kind in ("median", "q95")} for name, j in BINS},
        early=len(early),
        corner=sum(cell["exact"]["folds"] == [2, 0] for cell in early),
        truncated=truncated,
        at_table_1=at_table_1,
        claims=claims_page.section(),
        F_SN=measured.percent(abs(measured.load()["figure_7a"]["F_SN"]["off"])),
        **_corners(numbers),
        **_random(numbers["random"]),
    )
