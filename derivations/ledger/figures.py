"""In: benchmarks/results/claims.json. Out: verdict and evidence of each sentence that judges a figure.

The words are written for `DECIDED`: a measurement that leads elsewhere is an error, and has to be thought over.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from . import measured
from .measured import ACCEPTABLE, EXCELLENT, LOW
from .rows import LOOSE, TRUE

DECIDED = {
    "den_hartog_agreement": TRUE,
    "kbm_qualitative": TRUE,
    "kbm_low_friction": TRUE,
    "agreement_acceptable": LOOSE,
    "reliability": LOOSE,
    "conclusion_kbm": LOOSE,
}
HERE = "By direct integration (docs/validity.md, last section)"

Rows = list[dict[str, Any]]


def decided(numbers: dict[str, Any]) -> dict[str, tuple[str, str]]:
    """Verdict and evidence by claim. Raises ArithmeticError where a verdict is not that of the evidence."""
    found = measured.verdicts(numbers)
    if found != DECIDED:
        raise ArithmeticError(f"what was measured leads to other verdicts: {sorted(found.items() - DECIDED.items())}")
    two_b = numbers["figure_2b"]
    return {
        claim: (found[claim], evidence)
        for claim, evidence in {
            "den_hartog_agreement": _den_hartog(numbers["figure_2a"]),
            "kbm_qualitative": _qualitative(numbers["figure_2a"]["rows"]),
            "kbm_low_friction": _low_friction(two_b),
            "agreement_acceptable": _acceptable(numbers["figure_7a"]),
            "reliability": "The sentence of Section 4.1 on low μ/F_0 holds; that of Section 4.3 on the agreement "
            "holds at resonance and, with little friction, everywhere. The limitation is μ/F_0 close to π/4 "
            "(Section 4.1); away from resonance it begins well below π/4.",
            "conclusion_kbm": "What Section 4.1 states on Figs. 2a and 2b holds. But this sentence has no condition "
            f"on friction, and beyond μ/F_0 = {measured.same_up_to(two_b):g} even the number of folds "
            f"may differ: {_first_apart(two_b)}.",
        }.items()
    }


def percent(fraction: float) -> str:
    """Two digits."""
    return f"{100 * fraction:.0f} %" if fraction >= 0.1 else f"{100 * fraction:.2g} %"


def listed(items: Iterable[str]) -> str:
    """One after the other."""
    return ", ".join(items)


def _den_hartog(figure: dict[str, Any]) -> str:
    rows, spots = figure["rows"], figure["published way"]
    read = measured.excellent_as_read(figure)
    strayed = {
        ratio: max(abs(spot["sampled"]) for spot in spots if spot["ratio"] == ratio)
        for ratio in sorted({spot["ratio"] for spot in spots} - set(read))
    }
    moving = max(row["moving"]["off"] for row in rows)
    return (
        f"{HERE}: for {_span(rows)} and Ω = 0.5 to 0.98, 1.02 to 1.5 the exact motion is (35) within {moving:.0e} "
        f"wherever it does not stop; in the whole window, stops included, within {percent(EXCELLENT)} up to "
        f"{measured.excellent_throughout(rows)[-1]:g}. Appendix A's recipe with F_0 = 0.05 is within "
        f"{percent(EXCELLENT)} of (35) up to {read[-1]:g}, and differs by "
        f"{listed(f'{percent(off)} at {ratio:g}' for ratio, off in strayed.items())}."
    )


def _qualitative(rows: Rows) -> str:
    stopping = next(row for row in rows if row["stops below"])
    errors = listed(f"{percent(row['averaged']['off'])} at {row['ratio']:g}" for row in rows)
    return (
        f"{HERE}: for {_span(rows)} both curves rise up to Ω = 1 and fall beyond. The averaged amplitude "
        f"is off by up to {errors}. That the mass stops within the cycle (at {stopping['ratio']:g} below Ω = "
        f"{stopping['stops below']:.2g}, with more friction on both sides) is not captured."
    )


def _low_friction(rows: Rows) -> str:
    low = [row for row in rows if row["ratio"] < LOW]
    same = [row for row in rows if row["ratio"] <= measured.same_up_to(rows)]
    ratios = sorted({row["ratio"] for row in rows})
    good = [
        ratio for ratio in ratios if all(row["point"]["off"] <= ACCEPTABLE for row in rows if row["ratio"] <= ratio)
    ]
    return (
        f"{HERE}: Table 1's r and {len({row['F_0'] for row in low})} forcings; the paper states neither. In all "
        f"{len(low)} cases below π/8 both curves have the same folds in the same order; the largest amplitude is "
        f"accurate to {_peaks(low)}, the jumps to {_jumps(low)}, every point to "
        f"{percent(max(row['point']['off'] for row in low))}. Every point stays within {percent(ACCEPTABLE)} up to "
        f"μ/F_0 = {good[-1]:g}, the folds stay the same up to {same[-1]['ratio']:g}, where the jumps are off by up to "
        f"{_jumps([row for row in same if row['ratio'] == same[-1]['ratio']])}."
    )


def _first_apart(rows: Rows) -> str:
    row = next(row for row in rows if not measured.same_folds(row))
    counts = [len(measured.kinds(row[side])) for side in ("averaged", "exact")]
    return f"at {row['ratio']:g} and F_0 = {row['F_0']:.2g} averaging finds {counts[0]}, direct integration {counts[1]}"


def _acceptable(figure: dict[str, Any]) -> str:
    rows = figure["rows"]
    fine = [row for row in rows if row["point"]["off"] <= ACCEPTABLE]
    coarse = listed(
        f"{percent(row['point']['off'])} at {row['forcing']} ({percent(row['height']['off'])} of the peak)"
        for row in rows
        if row not in fine
    )
    jumps = _jumps([row for row in rows if row["forcing"] != "F_SN"])
    return (
        f"{HERE}: with Table 1 and the forcings of Table 2 the largest amplitudes are accurate to {_peaks(rows)}, the "
        f"jumps' frequencies and amplitudes to {jumps}, F_SN to {percent(abs(figure['F_SN']['off']))}. Every "
        f"point of the curve is within {percent(ACCEPTABLE)} only at {listed(row['forcing'] for row in fine)} (μ/F_0 ≤ "
        f"{max(row['ratio'] for row in fine):.2g}). Elsewhere amplitudes far from resonance are off by up to {coarse}."
    )


def _span(rows: Rows) -> str:
    return f"μ/F_0 = {rows[0]['ratio']:g} to {rows[-1]['ratio']:g}"


def _peaks(rows: Rows) -> str:
    return percent(max(map(measured.peak_error, rows)))


def _jumps(rows: Rows) -> str:
    return percent(max(error for row in rows for error in measured.jump_errors(row)))
