"""The paper's example compared with slowflow's results. Takes the ledger; returns Table 2 with verdicts.

The numbers are the runtime's; the verdicts are the ledger's, which has the same numbers certified. Where the two
disagree the report fails.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from slowflow import example
from slowflow.answers.results import SaddleNodes
from slowflow.oscillators.isolator import Isolator
from slowflow.support.errors import NotSettled

#: the ledger prints 12 significant digits
LEDGER_DIGITS = 12
#: numbers of Section 4.3 that Table 2 rests on, by their names in the ledger
QUOTED = ("u_cr", "F_cr", "Omega_cr", "F_SN", "Omega_SN", "A_SN")
ENTRIES = (("jump-up", "jump_up"), ("jump-down", "jump_down"))


@dataclass(frozen=True)
class Row:
    """One published number and ours: `printed` as in the paper, `derived` the runtime's, `verdict` the ledger's."""

    what: str
    printed: str
    derived: float
    verdict: str


def rows(isolator: Isolator, ledger: dict[str, Any]) -> Iterator[Row]:
    """Section 4.3's numbers and Table 2, entry by entry.

    Raises ArithmeticError where the runtime's number is not the one that the ledger certifies.
    """
    detachment, onset = isolator.detachment(), isolator.saddle_node_onset()
    ours = (isolator.u_cr, detachment.F_cr, detachment.Omega_cr, onset.F_SN, onset.Omega, onset.A)
    numbers = {row["id"]: row for row in ledger["rows"] if row["kind"] == "number"}
    for name, value in zip(QUOTED, ours, strict=True):
        yield _row(name, value, numbers[name])
    levels = {"F_SN": onset.F_SN, "F_cr": detachment.F_cr}
    for entry in ledger["table_2"]:
        printed = entry["F_0"]["published"]
        if entry["jump_up_Omega"]["published"] == "-":
            continue
        folds = isolator.saddle_nodes(levels.get(printed) or float(printed))
        for kind, key in ENTRIES:
            Omega, A = _fold(folds, kind)
            yield _row(f"F_0 = {printed}, {kind} Omega", Omega, entry[f"{key}_Omega"])
            yield _row(f"F_0 = {printed}, {kind} A", A, entry[f"{key}_A"])


def _fold(folds: SaddleNodes, kind: str) -> tuple[float, float]:
    (k,) = (k for k in range(len(folds)) if folds.kind[k] == kind)
    return float(folds.Omega[k]), float(folds.A[k])


def _row(what: str, value: float | None, judged: dict[str, str]) -> Row:
    certified = float(judged["derived"])
    if value is None or not math.isclose(value, certified, rel_tol=10.0 ** (1 - LEDGER_DIGITS)):
        raise NotSettled(f"{what}: the runtime has {value!r}, the ledger {judged['derived']}")
    return Row(what, judged["published"], value, judged["verdict"])


def report(ledger: dict[str, Any]) -> Iterator[str]:
    """Lines: Table 2 published / derived / verdict, the ledger's counts, its findings."""
    table = list(rows(example.isolator(), ledger))
    width = max(len(row.what) for row in table)
    yield f"{'':{width}}  {'published':>9}  {'derived':>15}  verdict"
    for row in table:
        derived = f"{row.derived:#.{LEDGER_DIGITS}g}"
        verdict = "rounds to it" if row.verdict == "identical" else row.verdict
        yield f"{row.what:{width}}  {row.printed:>9}  {derived:>15}  {verdict}"
    yield ""
    yield "The ledger: everything published, compared with the derivation (sources: generated/LEDGER.md)"
    for kind, counts in ledger["counts"].items():
        numbers = ", ".join(f"{number} {verdict}" for verdict, number in counts.items() if number)
        yield f"  {kind + 's:':10} {numbers}"
    yield "Findings:"
    for number, finding in enumerate(ledger["findings"], start=1):
        yield f"  {number:2d}. {finding['title']}"
