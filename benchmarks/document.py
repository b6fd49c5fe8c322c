"""Measured rows as tables: docs/benchmarks.md for users, benchmarks/results/README.md with the others; JSON files."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from operator import itemgetter
from pathlib import Path
from typing import Any

RESULTS = Path(__file__).resolve().parent / "results"
DOCS = Path(__file__).resolve().parents[1] / "docs"
#: parts of a second
SUBUNITS = ((1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns"))
#: a column's cell of a measured row, by the column's name
Columns = dict[str, Callable[[dict[str, Any]], str]]


@dataclass(frozen=True)
class Row:
    """One figure, what it is compared with, and how far the answers are from certified ones."""

    job: str
    measured: float
    unit: str
    comparison: str = ""
    error: str = ""
    #: other programs on the same cases, by name: what was measured of them, None where they are not installed
    others: dict[str, str | None] = field(default_factory=dict)


@dataclass(frozen=True)
class Section:
    """A table of a page: title, what was measured and how, columns."""

    title: str
    about: str
    columns: Columns


def save(path: Path, content: Any) -> None:
    """Write JSON, keys in the order of writing."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def earlier(path: Path) -> dict[str, Any]:
    """What was written there; empty where nothing was."""
    return dict(json.loads(path.read_text(encoding="utf-8"))) if path.exists() else {}


def with_earlier(rows: list[Any], before: list[Any], name: str, where: Any) -> list[Any]:
    """The rows; of a tool that could not be run those of before, which say so as `earlier` and on which processor.

    name: the key of a tool's name. Without a variant, a failure is the whole tool's.
    """
    kept = []
    for row in rows:
        missing = "failure" in row and "variant" not in row
        old = [one for one in before if missing and one[name] == row[name] and "seconds" in one]
        note = f"measured earlier, on {where}; now it {row.get('failure')}"
        kept += [{"earlier": note, **one} for one in old] or [row]
    return kept


def quantity(value: float, unit: str) -> str:
    """A number with three digits and its unit; seconds in a unit that fits."""
    if unit == "s" and abs(value) < 1:
        scale, unit = next((pair for pair in SUBUNITS if abs(value) >= pair[0]), SUBUNITS[-1])
        value /= scale
    if value and abs(value) >= 1e5:
        power = math.floor(math.log10(abs(value)))
        return f"{value / 10**power:.2f}e{power} {unit}".strip()
    return f"{value:.3g} {unit}".strip()


def table(head: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> list[str]:
    """A Markdown table, its columns filled with blanks so that it reads well as text."""
    cells = [tuple(cell.replace("|", "\\|") for cell in row) for row in (head, *rows)]
    width = [max(map(len, column)) for column in zip(*cells, strict=True)]
    lines = [cells[0], tuple("-" * n for n in width), *cells[1:]]
    return ["| " + " | ".join(cell.ljust(n) for cell, n in zip(line, width, strict=True)) + " |" for line in lines]


def columns_of(columns: Columns, rows: Iterable[dict[str, Any]]) -> list[str]:
    """The table of these columns."""
    return table(tuple(columns), [tuple(cell(row) for cell in columns.values()) for row in rows])


def environment_lines(environment: dict[str, Any]) -> list[str]:
    """Topics and values in one paragraph."""
    return ["; ".join(f"{topic} {value}" for topic, value in environment.items()) + "."]


# ---- cells


def in_unit(key: str, unit: str = "s") -> Callable[[dict[str, Any]], str]:
    """The cell of a quantity; "-" where there is none."""
    return lambda row: "-" if row.get(key) is None else quantity(row[key], unit)


def as_error(key: str) -> Callable[[dict[str, Any]], str]:
    """The cell of an error; "-" where nothing right was found."""
    return lambda row: "-" if row.get(key) is None else f"{row[key]:.1e}"


def comparison(row: dict[str, Any]) -> str:
    """What a figure is compared with."""
    others = [text or f"{name} is not installed here" for name, text in row["others"].items()]
    return "; ".join(part for part in (row["comparison"], *others) if part)


def tool(row: dict[str, Any]) -> str:
    """Name and versions of another tool, and when it was measured if not now."""
    versions = ", ".join(f"{name} {version}" for name, version in row.get("versions", {}).items())
    return row["peer"] + (f" ({versions})" if versions else "") + (f"; {row['earlier']}" if "earlier" in row else "")


def folds_found(row: dict[str, Any]) -> str:
    """How many of the two folds another tool found, and how many that are none."""
    if "failure" in row:
        return "-"
    elsewhere = row["folds_reported"] - row["folds_found"]
    return f"{row['folds_found']} of 2" + (f", {elsewhere} elsewhere" if elsewhere > 0 else "")


MEASURED: Columns = {"job": itemgetter("job"), "median": lambda row: quantity(row["measured"], row["unit"])}
SECTIONS = {
    "bench": Section(
        "Time and error of each function", "", {**MEASURED, "comparison": comparison, "error": itemgetter("error")}
    ),
    "peers": Section(
        "Other tools",
        """The task is the averaged response of Table 1's isolator with F_0 = 0.04, from Omega = 0.3 to 2, with
its two folds. The tools ran in turn, each in its own environment; `benchmarks/peers/` has an adapter for each. A tool
that was measured earlier is compared with the slowflow of that run. A fold counts as found if its error is below 1 %;
other folds that a tool reports count as *elsewhere*. The last column has the larger error of the folds found.""",
        {
            "tool": tool,
            "variant": lambda row: row.get("variant", ""),
            "time": in_unit("seconds"),
            "relative to slowflow": in_unit("ratio", ""),
            "points": lambda row: str(row.get("points", "-")),
            "folds": folds_found,
            "error of the folds' Omega": lambda row: row.get("failure") or as_error("fold_error")(row),
        },
    ),
    "exact": Section(
        "The equation of motion",
        """Processor times for exact motions of Table 1's isolator with F_0 = 0.04, compared with averaging and
the second approximation (`python -m benchmarks exact`).""",
        MEASURED,
    ),
    "derive": Section(
        "Custom restoring forces",
        """Processor times for forces that are SymPy expressions, each in a separate process with an empty cache
(`python -m benchmarks derive`). The columns are: start of Python with NumPy, SymPy and slowflow; `derive.mechanism`,
including the compiler; the first folds, including preparation; and a later response curve. Stops and the septic force
are averaged in closed form; the soft stop, with tanh beyond its gap, is averaged by quadrature. Python modules and
templates were already compiled to bytecode.""",
        {
            "force": itemgetter("force"),
            "solved": itemgetter("how"),
            **{step: in_unit(step) for step in ("start", "derive", "first folds", "curve")},
        },
    ),
    "grid": Section(
        "Maps in stores",
        """Maps of isolators over r, preload and mu, written block by block into a Zarr store on a local disk
(`python -m benchmarks grid`). Each map is computed by one thread of a separate process. Times are processor times. The
column *before* has the memory used before the computation. The peak memory grows with the size of a block, not with
that of the map.""",
        {
            "function": itemgetter("question"),
            "designs": lambda row: f"{row['designs']:.0e}".replace("e+0", "e"),
            "blocks": lambda row: str(row["blocks"]),
            "time": in_unit("processor"),
            "rate": lambda row: quantity(row["designs"] / row["processor"], "per second"),
            "before": in_unit("before", "MB"),
            "peak memory": in_unit("peak", "MB"),
            "on disk": in_unit("disk", "MB"),
        },
    ),
    "paper": Section(
        "The first run",
        """The command `make paper` in a new clone, and again when everything is built
(`python -m benchmarks paper`). Packages come from pip's index or its cache.""",
        {
            "command": itemgetter("step"),
            "time": in_unit("seconds"),
            "processor time": in_unit("processor"),
            ".venv": in_unit("disk", "MB"),
        },
    ),
}
STOPS: Columns = {
    "stops per period": lambda row: str(row["stops"]),
    "Omega": in_unit("Omega", ""),
    "time": in_unit("seconds"),
}


def section(name: str, found: dict[str, Any]) -> list[str]:
    """The heading, text and table of one part."""
    of = SECTIONS[name]
    about = [of.about, ""] if of.about else []
    lines = [f"## {of.title}", "", *about, *environment_lines(found["environment"]), ""]
    return [*lines, *columns_of(of.columns, found["rows"]), ""]


def precision(found: dict[str, Any]) -> list[str]:
    """Tables of the work-precision diagram, and of the cost of stops."""
    lines = ["## Error over computing time", "", *environment_lines(found["environment"]), ""]
    lines += ["The tasks are for Table 1's isolator with F_0 = 0.04.", ""]
    lines += ["Errors are relative, with respect to values certified to 40 digits.", ""]
    for scene in found["scenes"]:
        columns: Columns = {
            "method": lambda row: row["method"] + (f"; {row['earlier']}" if "earlier" in row else ""),
            "variant": itemgetter("variant"),
            "time": in_unit("seconds"),
            "median error": as_error("error"),
            "largest error": as_error("error_max"),
            "missed": lambda row, scene=scene: f"{row['missed']} of {scene['sought']}",
            "false": lambda row: str(row["false"]),
        }
        lines += [f"### {scene['title']}", "", *columns_of(columns, scene["rows"]), ""]
    lines += [COSTS, *columns_of(STOPS, found["scaling"]["stops"]), ""]
    return lines


COSTS = """## Cost against size

![Cost against size](../../docs/scaling.png)

## Cost against stops

The table has the time of one periodic motion with its Floquet multipliers, from a neighbouring motion, for a linear
spring with mu = 0.2 and F_0 = 1.
"""
HEAD = """# Benchmarks: speed, accuracy, other tools

This page compares the speed and accuracy of slowflow with other tools. Times are medians of processor time. Tools that
are compared ran in turn, unless the row states otherwise. The tables come from different runs, so the same task may
take a quarter longer in one than in another.

Errors are relative, or in units of u (1 + κ), where u = 2^-53 and κ is the relative condition number. `make bench`
writes the page. [Further measurements](../benchmarks/results/README.md) cover exact motions, custom forces, maps and
the numbers of the work-precision diagram.
"""
DETAILS = """# Further measurements

`make bench` writes this page from the JSON files in the folder. [Benchmarks](../../docs/benchmarks.md) is the page for
users; [history](history.md) explains what limits the speed.
"""


def users(found: dict[str, Any]) -> str:
    """One page: times, other tools in the same run, error against time."""
    lines = [HEAD]
    for name in ("bench", "peers"):
        lines += section(name, found[name]) if name in found else []
    if "peers" in found:
        ways = dict.fromkeys((row["peer"], row["what"]) for row in found["peers"]["rows"])
        lines += ["Methods:", "", *(f"- {peer}: {what}." for peer, what in ways), ""]
    if "work_precision" in found:
        lines += ["## Error over computing time", "", "![Error over computing time](work_precision.png)", ""]
    return "\n".join(lines)


def details(found: dict[str, Any]) -> str:
    """The measurements that are not on the users' page."""
    lines = [DETAILS, *(precision(found["work_precision"]) if "work_precision" in found else ())]
    for name in ("exact", "derive", "grid", "paper"):
        lines += section(name, found[name]) if name in found else []
    return "\n".join(lines)


def write(results: Path = RESULTS, docs: Path = DOCS) -> None:
    """Write both pages from whatever results there are."""
    found = {path.stem: earlier(path) for path in results.glob("*.json")}
    for page, text in ((docs / "benchmarks.md", users(found)), (results / "README.md", details(found))):
        page.parent.mkdir(parents=True, exist_ok=True)
        page.write_text(text, encoding="utf-8")
