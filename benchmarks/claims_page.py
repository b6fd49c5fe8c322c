"""In: what `benchmarks.claims` measured, and the ledger. Out: their section of docs/validity.md."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from benchmarks.document import Columns, columns_of
from derivations.ledger import measured
from derivations.ledger.measured import percent

LEDGER = Path(__file__).resolve().parents[1] / "generated" / "slowflow_kernels" / "ledger.json"

Row = dict[str, Any]


def section() -> str:
    """The tables, from the committed numbers and verdicts."""
    numbers, ledger = measured.load(), json.loads(LEDGER.read_text(encoding="utf-8"))
    sentences = [row for row in ledger["rows"] if row["kind"] == "claim" and row["id"] in ledger["criteria"]]
    recipe = numbers["figure_2a"]["published way"]
    tables = (
        columns_of(SENTENCES, sentences),
        columns_of(figure_2a(recipe), numbers["figure_2a"]["rows"]),
        columns_of(FIGURE_2B, by_ratio(numbers["figure_2b"])),
        columns_of(FIGURE_7A, numbers["figure_7a"]["rows"]),
    )
    return "\n\n".join(map("\n".join, tables))


SENTENCES: Columns = {
    "where": lambda row: row["where"],
    "sentence": lambda row: row["published"].replace("_", "\\_"),
    "verdict": lambda row: row["verdict"],
}


def stops(row: Row) -> str:
    """Frequencies at which the mass stops."""
    below, above = row["stops below"], row["stops above"]
    return ("none" if not below else f"below {below:.2f}") + (f", above {above:.2f}" if above else "")


def figure_2a(recipe: list[Row]) -> Columns:
    """A row for each mu/F_0; recipe: what the paper's own gives there."""
    return {
        "Fig. 2a: mu/F_0": lambda row: f"{row['ratio']:g}",
        "sticks at Omega": stops,
        "(35) without sticking": lambda row: f"{row['moving']['off']:.0e}",
        "(35) with sticking": lambda row: percent(row["stopping"]["off"]) if row["stopping"] else "-",
        "recipe against (35)": lambda row: largest(
            [spot for spot in recipe if spot["ratio"] == row["ratio"]], lambda spot: abs(spot["sampled"])
        ),
        "averaged": lambda row: percent(row["averaged"]["off"]),
    }


def largest(rows: list[Row], error: Callable[[Row], float]) -> str:
    """In per cent; a dash where there is nothing to compare."""
    return percent(max(error(row) for row in rows)) if rows else "-"


def by_ratio(rows: list[Row]) -> list[Row]:
    """A row for each mu/F_0 over all forcings: those, those with as many folds, and those of them that jump."""
    out = []
    for ratio in sorted({row["ratio"] for row in rows}):
        here = [row for row in rows if row["ratio"] == ratio]
        same = [row for row in here if measured.same_folds(row)]
        jumping = [row for row in same if measured.kinds(row["exact"])]
        out.append({"ratio": ratio, "here": here, "same": same, "jumping": jumping})
    return out


FIGURE_2B: Columns = {
    "Fig. 2b: mu/F_0": lambda row: f"{row['ratio']:g}",
    "forcings": lambda row: f"{len(row['here'])}",
    "same folds": lambda row: f"{len(row['same'])}",
    "of these with jumps": lambda row: f"{len(row['jumping'])}",
    "largest amplitude": lambda row: largest(row["here"], measured.peak_error),
    "jumps": lambda row: largest(row["jumping"], lambda one: max(measured.jump_errors(one))),
    "points": lambda row: largest(row["here"], lambda one: one["point"]["off"]),
}
FIGURE_7A: Columns = {
    "Fig. 7a: F_0": lambda row: row["forcing"],
    "mu/F_0": lambda row: f"{row['ratio']:.2f}",
    "largest amplitude": lambda row: percent(measured.peak_error(row)),
    "jumps": lambda row: "-" if row["forcing"] == "F_SN" else percent(max(measured.jump_errors(row))),
    "points": lambda row: percent(row["point"]["off"]),
    "worst at Omega": lambda row: f"{row['point']['Omega']:.2f}",
    "relative to the peak": lambda row: percent(row["height"]["off"]),
}
