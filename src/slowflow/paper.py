"""The paper's Table 2 beside slowflow's, and Fig. 7: in goes a folder for figures and the ledger, out comes a report.

`slowflow paper` prints the report; the numbers are the runtime's, the verdicts on the equations are the ledger's.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path
from typing import Any

from slowflow import published
from slowflow.isolator import Isolator
from slowflow.results import SaddleNodes

#: frequencies and amplitudes shown in Fig. 7
WINDOW = (0.6, 1.2)
A_MAX = 1.0


@dataclass(frozen=True)
class Row:
    """One published number beside ours: `printed` as in the paper, `derived` ours, `verdict` in words."""

    what: str
    printed: str
    derived: float | None
    verdict: str


def table_1_isolator() -> Isolator:
    """The isolator of Table 1."""
    values = {name: float(value) for name, value in published.TABLE_1.items()}
    return Isolator(**values)


def rounds_to(derived: float, printed: str) -> bool:
    """Whether `printed` is `derived` rounded to as many decimals."""
    places = Decimal(1).scaleb(Decimal(printed).as_tuple().exponent)  # type: ignore[arg-type]
    return Decimal(derived).quantize(places, ROUND_HALF_UP) == Decimal(printed)


def judged(what: str, printed: str, derived: float | None) -> Row:
    """A row with its verdict."""
    if derived is None:
        return Row(what, printed, None, "no such point")
    if rounds_to(derived, printed):
        return Row(what, printed, derived, "rounds to it")
    return Row(what, printed, derived, f"differs by {float(printed) - derived:+.5f}")


def _fold(folds: SaddleNodes, kind: str) -> tuple[float | None, float | None]:
    these = [k for k in range(len(folds)) if folds.kind[k] == kind]
    return (float(folds.Omega[these[0]]), float(folds.A[these[0]])) if len(these) == 1 else (None, None)


def table_2(isolator: Isolator) -> Iterator[Row]:
    """Table 2, entry by entry, and the numbers of Section 4.3 that it rests on."""
    detachment, onset = isolator.detachment(), isolator.saddle_node_onset()
    quoted = {number.id: number.printed for number in published.NUMBERS}
    yield judged("u_cr", quoted["u_cr"], detachment.u_cr)
    yield judged("F_cr", quoted["F_cr"], detachment.F_cr)
    yield judged("Omega_cr", quoted["Omega_cr"], detachment.Omega_cr)
    yield judged("F_SN", quoted["F_SN"], onset.F_SN)
    yield judged("Omega_SN", quoted["Omega_SN"], onset.Omega)
    yield judged("A_SN", quoted["A_SN"], onset.A)
    levels = {"F_SN": onset.F_SN, "F_cr": detachment.F_cr}
    for row in published.TABLE_2:
        if row.jump_up_Omega == "-":
            continue
        F_0 = levels[row.F_0] if row.F_0 in levels else float(row.F_0)
        if F_0 is None:
            raise ArithmeticError(f"Table 1 has no {row.F_0}")
        folds = isolator.saddle_nodes(F_0)
        for kind, Omega, A in (
            ("jump-up", row.jump_up_Omega, row.jump_up_A),
            ("jump-down", row.jump_down_Omega, row.jump_down_A),
        ):
            ours = _fold(folds, kind)
            yield judged(f"F_0 = {row.F_0}, {kind} Omega", Omega, ours[0])
            yield judged(f"F_0 = {row.F_0}, {kind} A", quoted.get(A, A), ours[1])


def report(ledger: Path) -> Iterator[str]:
    """Lines of the report."""
    isolator = table_1_isolator()
    rows = list(table_2(isolator))
    width = max(len(row.what) for row in rows)
    yield f"{'':{width}}  {'published':>9}  {'slowflow':>14}  verdict"
    for row in rows:
        derived = "" if row.derived is None else f"{row.derived:.12f}"
        yield f"{row.what:{width}}  {row.printed:>9}  {derived:>14}  {row.verdict}"
    yield ""
    yield from _summary(json.loads(ledger.read_text()))


def _summary(ledger: dict[str, Any]) -> Iterator[str]:
    """How many published equations, numbers and sentences hold."""
    yield "Ledger (generated/LEDGER.md): what was published, held against what is derived"
    for verdict, rows in ledger["summary"].items():
        yield f"  {rows:4d}  {verdict}"


def draw(folder: Path) -> list[Path]:
    """Fig. 7a and 7b as PNG and SVG; the files written."""
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    from slowflow import plot

    isolator = table_1_isolator()
    onset, detachment = isolator.saddle_node_onset(), isolator.detachment()
    forcings = [value for value in (onset.F_SN, 0.025, detachment.F_cr, 0.04, 0.05) if value is not None]
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    # the same picture has the same bytes
    with mpl.rc_context({"svg.hashsalt": "slowflow", "svg.fonttype": "path"}):
        for name in ("fig_7a", "fig_7b"):
            figure, ax = plt.subplots(figsize=(6.4, 4.4), layout="constrained")
            if name == "fig_7a":
                plot.amplitude_curves(ax, isolator, forcings, WINDOW, A_MAX)
            else:
                plot.phase_curves(ax, isolator, forcings, WINDOW)
            for suffix in ("png", "svg"):
                path = folder / f"{name}.{suffix}"
                figure.savefig(path, dpi=160, metadata={"Date": None} if suffix == "svg" else {"Software": None})
                written.append(path)
            plt.close(figure)
    return written
