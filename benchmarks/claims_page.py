"""In: what `benchmarks.claims` measured, and the ledger. Out: their section of docs/validity.md."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from derivations.ledger import measured
from derivations.ledger.figures import percent

LEDGER = Path(__file__).resolve().parents[1] / "generated" / "slowflow_kernels" / "ledger.json"

Row = dict[str, Any]


def section() -> str:
    """The tables, from the committed numbers and verdicts."""
    numbers, ledger = measured.load(), json.loads(LEDGER.read_text(encoding="utf-8"))
    return "\n\n".join(
        "\n".join(table)
        for table in (
            sentences(ledger),
            figure_2a(numbers["figure_2a"]),
            figure_2b(numbers["figure_2b"]),
            figure_7a(numbers["figure_7a"]),
        )
    )


def lines(head: str, rows: Iterable[Iterable[str]]) -> list[str]:
    """A table: its head, cells between bars."""
    return [head, "|---" * (head.count("|") - 1) + "|", *("| " + " | ".join(row) + " |" for row in rows)]


def sentences(ledger: dict[str, Any]) -> list[str]:
    """The sentences of the paper and their verdicts."""
    found = [row for row in ledger["rows"] if row["kind"] == "claim" and row["id"] in ledger["criteria"]]
    return lines(
        "| where | sentence | verdict |",
        ((row["where"], row["published"].replace("_", "\\_"), row["verdict"]) for row in found),
    )


def figure_2a(figure: dict[str, Any]) -> list[str]:
    """A row for each mu/F_0."""

    def recipe(ratio: float) -> str:
        return percent(max(abs(spot["sampled"]) for spot in figure["published way"] if spot["ratio"] == ratio))

    def stops(row: Row) -> str:
        below, above = row["stops below"], row["stops above"]
        return ("none" if not below else f"below {below:.2f}") + (f", above {above:.2f}" if above else "")

    def off(spot: Row | None) -> str:
        return percent(spot["off"]) if spot else "-"

    rows = (
        (
            f"{row['ratio']:g}",
            stops(row),
            f"{row['moving']['off']:.0e}",
            off(row["stopping"]),
            recipe(row["ratio"]),
            off(row["averaged"]),
        )
        for row in figure["rows"]
    )
    head = (
        "| Fig. 2a: mu/F_0 | stops at Omega | (35) without stops | (35) with stops | recipe against (35) | averaged |"
    )
    return lines(head, rows)


def largest(rows: list[Row], error: Callable[[Row], float]) -> str:
    """In per cent; a dash where there is nothing to compare."""
    return percent(max(error(row) for row in rows)) if rows else "-"


def figure_2b(rows: list[Row]) -> list[str]:
    """A row for each mu/F_0, over all forcings."""
    out = []
    for ratio in sorted({row["ratio"] for row in rows}):
        here = [row for row in rows if row["ratio"] == ratio]
        same = [row for row in here if measured.same_folds(row)]
        jumping = [row for row in same if measured.kinds(row["exact"])]
        out.append(
            (
                f"{ratio:g}",
                f"{len(here)}",
                f"{len(same)}",
                f"{len(jumping)}",
                largest(here, measured.peak_error),
                largest(jumping, lambda row: max(measured.jump_errors(row))),
                largest(here, lambda row: row["point"]["off"]),
            )
        )
    head = "| Fig. 2b: mu/F_0 | forcings | same folds | of these with jumps | largest amplitude | jumps | points |"
    return lines(head, out)


def figure_7a(figure: dict[str, Any]) -> list[str]:
    """A row for each forcing."""
    rows = (
        (
            row["forcing"],
            f"{row['ratio']:.2f}",
            percent(measured.peak_error(row)),
            "-" if row["forcing"] == "F_SN" else percent(max(measured.jump_errors(row))),
            percent(row["point"]["off"]),
            f"{row['point']['Omega']:.2f}",
            percent(row["height"]["off"]),
        )
        for row in figure["rows"]
    )
    head = "| Fig. 7a: F_0 | mu/F_0 | largest amplitude | jumps | points | worst at Omega | relative to the peak |"
    return lines(head, rows)
