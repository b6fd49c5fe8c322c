"""Measured rows as tables: docs/benchmarks.md for users, benchmarks/results/README.md with all of them; JSON files."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

RESULTS = Path(__file__).resolve().parent / "results"
DOCS = Path(__file__).resolve().parents[1] / "docs"

HEAD = """# Benchmarks: speed, accuracy, other tools

Written by `make bench`. Times are medians of processor time on one machine. Comparisons were measured in turn in one
run, unless a row says otherwise. Errors are relative, or in u (1 + κ), u = 2^-53, with the condition number κ.
[All measurements](../benchmarks/results/README.md), with what limits them.
"""
DETAILS = """# All measurements

Written by `make bench`, from the JSON files in this folder. [For users](../../docs/benchmarks.md).
"""


#: of rows that are not from a quiet machine
BUSY = "measured in another run, while other work kept the machine busy"
#: parts of a second
SUBUNITS = ((1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns"))


def save(path: Path, content: Any) -> None:
    """Write JSON, keys in the order of writing."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def quantity(value: float, unit: str) -> str:
    """A number with three digits and its unit; seconds in a unit that fits."""
    if unit == "s" and abs(value) < 1:
        scale, unit = next((pair for pair in SUBUNITS if abs(value) >= pair[0]), SUBUNITS[-1])
        value /= scale
    if value and abs(value) >= 1e5:
        power = math.floor(math.log10(abs(value)))
        return f"{value / 10**power:.2f}e{power} {unit}".strip()
    return f"{value:.3g} {unit}".strip()


def table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> list[str]:
    """A Markdown table, its columns filled with blanks so that it reads well as text."""
    cells = [tuple(cell.replace("|", "\\|") for cell in row) for row in (head, *rows)]
    width = [max(map(len, column)) for column in zip(*cells, strict=True)]
    lines = [cells[0], tuple("-" * n for n in width), *cells[1:]]
    return ["| " + " | ".join(cell.ljust(n) for cell, n in zip(line, width, strict=True)) + " |" for line in lines]


def bench_table(rows: list[dict[str, Any]], targets: bool = True) -> list[str]:
    """Job, measured median, comparison, error; with targets these and whether they are reached."""
    cells = []
    for row in rows:
        others = [text or f"{name} is not installed here" for name, text in row.get("others", {}).items()]
        measured = (
            row["job"],
            quantity(row["measured"], row["unit"]),
            "; ".join(part for part in (row.get("ratio", ""), *others) if part),
            row.get("error", ""),
        )
        target = f"{'≤' if row['at_most'] else '≥'} {quantity(row['target'], row['unit'])}"
        cells.append((*measured, target, "yes" if row.get("reached") else "NO") if targets else measured)
    return table(("job", "median", "comparison", "error", *(("target", "reached") if targets else ())), cells)


def environment_lines(environment: dict[str, Any]) -> list[str]:
    """Topics and values in one paragraph."""
    return ["; ".join(f"{topic} {value}" for topic, value in environment.items()) + "."]


def exact_table(rows: list[dict[str, Any]]) -> list[str]:
    """Job, measured, bound, whether it is kept."""
    cells = [
        (
            row["job"],
            f"{row['measured']:.3g} {row['unit']}".strip(),
            "" if row["bound"] is None else f"≤ {row['bound']:g} {row['unit']}".strip(),
            "" if row["bound"] is None else "yes" if row["kept"] else "NO",
        )
        for row in rows
    ]
    return table(("job", "measured", "target", "reached"), cells)


def paper_table(rows: list[dict[str, Any]]) -> list[str]:
    """Step, time on the wall, processor's time, size of .venv."""
    cells = [
        (row["step"], quantity(row["seconds"], "s"), quantity(row["processor"], "s"), f"{row['disk']:.0f} MB")
        for row in rows
    ]
    return table(("command", "time", "processor's", ".venv"), cells)


def peers_table(rows: list[dict[str, Any]]) -> list[str]:
    """Peer, variant, time, ratio, points, folds, error; or why not."""
    cells = []
    for row in rows:
        name = f"{row['peer']} ({', '.join(f'{k} {v}' for k, v in row.get('versions', {}).items())})"
        name = name.removesuffix(" ()") + (f"; {row['earlier']}" if "earlier" in row else "")
        if "failure" in row:
            cells.append((name, row.get("variant", ""), "-", "-", "-", "-", row["failure"]))
            continue
        error = "-" if row["fold_error"] is None else f"{row['fold_error']:.1e}"
        folds = f"{row['folds_found']} of 2" + (
            f", {row['folds_reported'] - row['folds_found']} elsewhere"
            if row["folds_reported"] > row["folds_found"]
            else ""
        )
        cells.append(
            (
                name,
                row["variant"],
                quantity(row["seconds"], "s"),
                f"{row['ratio']:.3g}" if "ratio" in row else "-",
                str(row["points"]),
                folds,
                error,
            )
        )
    return table(
        ("tool", "variant", "time", "relative to slowflow", "points", "folds", "error of the folds' Omega"), cells
    )


def grid_table(rows: list[dict[str, Any]]) -> list[str]:
    """Question, designs, blocks, time of the processor, designs a second, memory, disk."""
    cells = [
        (
            row["question"],
            f"{row['designs']:.0e}".replace("e+0", "e"),
            str(row["blocks"]),
            quantity(row["processor"], "s"),
            quantity(row["designs"] / row["processor"], "/s"),
            f"{row['before']:.0f} MB",
            f"{row['peak']:.0f} MB",
            f"{row['disk']:.3g} MB",
        )
        for row in rows
    ]
    head = ("question", "designs", "blocks", "time", "designs", "before", "peak memory", "on disk")
    return table(head, cells)


def derive_table(rows: list[dict[str, Any]]) -> list[str]:
    """Force, how it is solved, time of each step."""
    steps = ("start", "derive", "first folds", "curve")
    cells = [(row["force"], row["how"], *(quantity(row[step], "s") for step in steps)) for row in rows]
    return table(("force", "solved", *steps), cells)


def stops_table(rows: list[dict[str, Any]]) -> list[str]:
    """Stops a turn, Omega, time."""
    cells = [(str(row["stops"]), f"{row['Omega']:.3g}", quantity(row["seconds"], "s")) for row in rows]
    return table(("stops per period", "Omega", "time"), cells)


def precision_table(scene: dict[str, Any]) -> list[str]:
    """Method, time, error and what was missed of one scene of the work-precision diagram."""
    cells = [
        (
            row["method"] + (f"; {row['earlier']}" if "earlier" in row else ""),
            row["variant"],
            quantity(row["seconds"], "s"),
            "-" if row["error"] is None else f"{row['error']:.1e}",
            "-" if row["error_max"] is None else f"{row['error_max']:.1e}",
            f"{row['missed']} of {scene['sought']}",
            str(row["false"]),
        )
        for row in scene["rows"]
    ]
    return table(("method", "variant", "time", "median error", "largest error", "missed", "false"), cells)


def write(results: Path = RESULTS, docs: Path = DOCS) -> None:
    """Write docs/benchmarks.md and the page of all measurements from whatever results there are."""
    found = {path.stem: earlier(path) for path in results.glob("*.json")}
    for page, text in ((docs / "benchmarks.md", users(found)), (results / "README.md", details(found))):
        page.parent.mkdir(parents=True, exist_ok=True)
        page.write_text(text, encoding="utf-8")


def users(found: dict[str, Any]) -> str:
    """One page: times, other tools in the same run, error against time."""
    lines = [HEAD]
    if bench := found.get("bench"):
        lines += [*environment_lines(bench["environment"]), "", "## Time and error of each question", ""]
        lines += [*bench_table(bench["rows"], targets=False), ""]
    if peers := found.get("peers"):
        ways = dict.fromkeys((row["peer"], row["what"]) for row in peers["rows"])
        lines += ["## Other tools", "", *PEERS_WORDS, "", *peers_table(peers["rows"]), ""]
        lines += ["Methods:", "", *(f"- {peer}: {what}." for peer, what in ways), ""]
    if "work_precision" in found:
        lines += ["## Error against time", "", "![Error against time](work_precision.png)", ""]
    return "\n".join(lines)


def details(found: dict[str, Any]) -> str:
    """Every measurement, with targets and what limits each."""
    lines = [DETAILS]
    if bench := found.get("bench"):
        lines += ["## Targets", "", *environment_lines(bench["environment"]), "", *bench_table(bench["rows"]), ""]
        if bench["limits"]:
            lines += ["Where the limits are:", "", *(f"- {limit}" for limit in bench["limits"]), ""]
    if precision := found.get("work_precision"):
        lines += ["## Error against time", ""]
        lines += ["Case: Table 1 with F_0 = 0.04. Errors are relative, against values certified to 40 digits.", ""]
        for scene in precision["scenes"]:
            lines += [f"### {scene['title']}", "", *precision_table(scene), ""]
        lines += ["## Cost against size", "", "![Cost against size](../../docs/scaling.png)", ""]
        lines += ["## Cost against stops", "", *STOPS_WORDS, "", *stops_table(precision["scaling"]["stops"]), ""]
    if exact := found.get("exact"):
        about = [f"{exact['earlier'].capitalize()}."] if "earlier" in exact else []
        lines += ["## The equation of motion", "", *EXACT_WORDS, *about, ""]
        lines += [*environment_lines(exact["environment"]), "", *exact_table(exact["rows"]), ""]
    if derive := found.get("derive"):
        about = ["Modules and templates are already compiled to bytecode."] if "bytecode" in derive else []
        about += [f"{derive['earlier'].capitalize()}."] if "earlier" in derive else []
        lines += ["## Custom restoring forces", "", *DERIVE_WORDS, *about, ""]
        lines += [*environment_lines(derive["environment"]), "", *derive_table(derive["rows"]), ""]
    if grid := found.get("grid"):
        lines += ["## Maps in stores", "", *GRID_WORDS, "", *environment_lines(grid["environment"]), ""]
        lines += [*grid_table(grid["rows"]), ""]
    if paper := found.get("paper"):
        lines += ["## The first run", "", *PAPER_WORDS, "", *environment_lines(paper["environment"]), ""]
        lines += [*paper_table(paper["rows"]), ""]
    return "\n".join(lines)


STOPS_WORDS = (
    "One periodic motion with its multipliers, started from the neighbouring one, by the number of stops per period:",
    "linear spring, mu = 0.2, F_0 = 1.",
)
EXACT_WORDS = (
    "Exact motions of Table 1 with F_0 = 0.04 unless a row says otherwise (`python -m benchmarks.bench_exact`), by the",
    "processor's time, compared with heyoka, SciPy, averaging, closed forms and digits from mpmath.",
)
PAPER_WORDS = (
    "In a fresh clone (`python -m benchmarks.bench_paper`): the first command",
    "of the README, and the same again when everything is built. Packages come from pip's index or its cache.",
)
DERIVE_WORDS = (
    "Forces given as SymPy expressions (`python -m benchmarks.bench_derive`), each in a separate process with an",
    "empty cache. Time is processor time, the compiler's included: Python's start with NumPy, SymPy and",
    "slowflow; `derive.mechanism`; the first folds, preparation included; and one later curve,",
    "`frequency_response`. Stops and the septic are derived in closed form; the soft stop, with tanh beyond its gap,",
    "is averaged by quadrature.",
)
GRID_WORDS = (
    "Designs of the isolator over r, preload and mu, written block by block into a Zarr store on a local disk by one",
    "thread (`python -m benchmarks.bench_grid`), each map by a process of its own. Time is the processor's. Before:",
    "memory before the first question. The peak grows with the size of a block, not with that of the map.",
)
PEERS_WORDS = (
    "Table 1 with F_0 = 0.04: the averaged response from Omega = 0.3 to 2 and both folds, all in one run and in turn.",
    "A fold counts as found within 1 %; the error is the larger of the two found. Each tool runs in an environment of",
    "its own; `benchmarks/peers/` has an adapter for each.",
)


def earlier(path: Path) -> dict[str, Any]:
    """What was written there; empty where nothing was."""
    return dict(json.loads(path.read_text(encoding="utf-8"))) if path.exists() else {}
