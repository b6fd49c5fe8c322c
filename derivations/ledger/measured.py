"""In: benchmarks/results/claims.json, from direct integration. Out: verdict and evidence of sentences on figures.

The measuring needs the runtime and is done by `python -m benchmarks.claims`; here its numbers are data. What a word
such as "excellent" asks for is in `CRITERIA`, and each verdict follows from it. The sizes in it were settled before
anything was measured; three readings were not, and LEDGER.md names them. The words are written for `DECIDED`: a
measurement that leads elsewhere is an error, and has to be thought over.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

from .rows import FALSE, LOOSE, TRUE

RESULTS = Path(__file__).parents[2] / "benchmarks" / "results" / "claims.json"

EXCELLENT = 0.01  # what a reader of a plot no longer sees
ACCEPTABLE = 0.05
THRESHOLD = math.pi / 4
LOW = THRESHOLD / 2  # of mu/F_0: the paper's low and high are far from and close to pi/4
SEVERAL = 3

Rows = list[dict[str, Any]]

#: by claim: what makes it true, what imprecise; otherwise it is false
CRITERIA: dict[str, tuple[str, str]] = {
    "den_hartog_agreement": (
        "for at least three values of μ/F_0, (35) is within 1 % of the exact amplitude in the whole window, and the "
        "result of the paper's own recipe is within 1 % of (35) wherever the recipe was run",
        "(35) is within 1 % wherever the mass does not stop, and the recipe for at least one value",
    ),
    "kbm_qualitative": (
        "for every μ/F_0 below π/4 the averaged curve rises and falls where the exact one does",
        "for every μ/F_0 below π/8",
    ),
    "kbm_low_friction": (
        "for every μ/F_0 below π/8 and every forcing, both curves have the same kinds of folds in the same order",
        "for every forcing up to some lower μ/F_0",
    ),
    "agreement_acceptable": (
        "at every forcing the same kinds of folds; the largest amplitude, the jumps' frequencies and amplitudes, and "
        "every stable point of the curve within 5 % of their own size. At F_SN, the border between no fold and two, "
        "F_SN itself within 5 % in place of the jumps",
        "the points of the curve only at some of the forcings",
    ),
    "reliability": (
        "`agreement_acceptable` and `kbm_low_friction` are true; the limitation is μ/F_0 close to π/4 (Section 4.1)",
        "neither of them is false",
    ),
    "conclusion_kbm": (
        "`den_hartog_agreement`, `kbm_qualitative` and `kbm_low_friction` are true, and the last also for every μ/F_0 "
        "below π/4, since the sentence does not ask for low friction",
        "none of them is false",
    ),
}


def load() -> dict[str, Any]:
    """The committed measurement."""
    found: dict[str, Any] = json.loads(RESULTS.read_text(encoding="utf-8"))
    return found


def verdicts(numbers: dict[str, Any]) -> dict[str, str]:
    """The verdict on each claim of `CRITERIA`."""
    two_b = numbers["figure_2b"]
    out = {
        "den_hartog_agreement": den_hartog(numbers["figure_2a"]),
        "kbm_qualitative": qualitative(numbers["figure_2a"]["rows"]),
        "kbm_low_friction": _verdict(same_up_to(two_b) >= _highest(two_b, LOW), same_up_to(two_b) > 0),
        "agreement_acceptable": acceptable(numbers["figure_7a"]),
    }
    premises = [out["agreement_acceptable"], out["kbm_low_friction"]]
    out["reliability"] = _verdict(set(premises) == {TRUE}, FALSE not in premises)
    premises = [out["den_hartog_agreement"], out["kbm_qualitative"], out["kbm_low_friction"]]
    everywhere = same_up_to(two_b) >= _highest(two_b, THRESHOLD)
    out["conclusion_kbm"] = _verdict(everywhere and set(premises) == {TRUE}, FALSE not in premises)
    return out


def _verdict(true: bool, loose: bool) -> str:
    return TRUE if true else LOOSE if loose else FALSE


def _highest(rows: Rows, below: float) -> float:
    return float(max(row["ratio"] for row in rows if row["ratio"] < below))


def den_hartog(figure: dict[str, Any]) -> str:
    """Fig. 2a: (35) against the exact motion, and the paper's own integration against (35)."""
    rows = figure["rows"]
    return _verdict(
        len(set(excellent_throughout(rows)) & set(excellent_as_read(figure))) >= SEVERAL,
        all(row["moving"]["off"] <= EXCELLENT for row in rows) and excellent_as_read(figure) != [],
    )


def excellent_throughout(rows: Rows) -> list[float]:
    """The values of mu/F_0 at which (35) is excellent in the whole window, stops or not."""
    return [
        row["ratio"]
        for row in rows
        if max(row[part]["off"] for part in ("moving", "stopping") if row[part]) <= EXCELLENT
    ]


def excellent_as_read(figure: dict[str, Any]) -> list[float]:
    """The values of mu/F_0 at which the samples of the paper's own integration are excellent wherever it was run."""
    spots = figure["published way"]
    return sorted(
        ratio
        for ratio in {spot["ratio"] for spot in spots}
        if all(abs(spot["sampled"]) <= EXCELLENT for spot in spots if spot["ratio"] == ratio)
    )


def qualitative(rows: Rows) -> str:
    """Fig. 2a: the averaged curve rises and falls as the exact one."""
    same = {row["ratio"]: row["course"]["averaged"] == row["course"]["exact"] for row in rows}
    return _verdict(all(same.values()), all(agrees for ratio, agrees in same.items() if ratio < LOW))


def same_up_to(rows: Rows) -> float:
    """Fig. 2b: the largest mu/F_0 measured up to which folds agree in kind and order at every forcing; 0 if at none."""
    apart = min((row["ratio"] for row in rows if not same_folds(row)), default=math.inf)
    return float(max((row["ratio"] for row in rows if row["ratio"] < apart), default=0.0))


def same_folds(row: dict[str, Any]) -> bool:
    """Whether both curves have the same kinds of folds in the same order."""
    return kinds(row["averaged"]) == kinds(row["exact"])


def kinds(curve: dict[str, Any]) -> list[str]:
    """Of the folds of a curve, by rising frequency."""
    return [fold["kind"] for fold in curve["folds"]]


def acceptable(figure: dict[str, Any]) -> str:
    """Fig. 7a: peaks, jumps and points of the curves."""
    rows = figure["rows"]
    coarse = abs(figure["F_SN"]["off"]) <= ACCEPTABLE and all(
        peak_error(row) <= ACCEPTABLE
        and (row["forcing"] == "F_SN" or (same_folds(row) and max(jump_errors(row)) <= ACCEPTABLE))
        for row in rows
    )
    points = [row["point"]["off"] <= ACCEPTABLE for row in rows]
    return _verdict(coarse and all(points), coarse and any(points))


def peak_error(row: dict[str, Any]) -> float:
    """Of the largest amplitude, relative."""
    return abs(float(row["averaged"]["A"] / row["exact"]["A"] - 1))


def jump_errors(row: dict[str, Any]) -> list[float]:
    """Of the frequencies and amplitudes of the jumps, relative; both curves have the same ones."""
    pairs = zip(row["averaged"]["folds"], row["exact"]["folds"], strict=True)
    return [abs(float(mine[name] / theirs[name] - 1)) for mine, theirs in pairs for name in ("Omega", "A")]


# ---- evidence -------------------------------------------------------------------------------------------------------

#: the verdicts that the evidence below is written for
DECIDED = {
    "den_hartog_agreement": TRUE,
    "kbm_qualitative": TRUE,
    "kbm_low_friction": TRUE,
    "agreement_acceptable": LOOSE,
    "reliability": LOOSE,
    "conclusion_kbm": LOOSE,
}
HERE = "By direct integration (docs/validity.md, last section)"


def decided(numbers: dict[str, Any]) -> dict[str, tuple[str, str]]:
    """Verdict and evidence by claim. Raises ArithmeticError where a verdict is not that of the evidence."""
    found = verdicts(numbers)
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
            f"on friction, and beyond μ/F_0 = {same_up_to(two_b):g} even the number of folds "
            f"may differ: {_first_apart(two_b)}.",
        }.items()
    }


def percent(fraction: float) -> str:
    """Two digits."""
    return f"{100 * fraction:.0f} %" if fraction >= 0.1 else f"{100 * fraction:.2g} %"


def _den_hartog(figure: dict[str, Any]) -> str:
    rows, spots = figure["rows"], figure["published way"]
    read = excellent_as_read(figure)
    strayed = {
        ratio: max(abs(spot["sampled"]) for spot in spots if spot["ratio"] == ratio)
        for ratio in sorted({spot["ratio"] for spot in spots} - set(read))
    }
    moving = max(row["moving"]["off"] for row in rows)
    return (
        f"{HERE}: for {_span(rows)} and Ω = 0.5 to 0.98, 1.02 to 1.5 the exact motion is (35) within {moving:.0e} "
        f"wherever it does not stop; in the whole window, stops included, within {percent(EXCELLENT)} up to "
        f"{excellent_throughout(rows)[-1]:g}. Appendix A's recipe with F_0 = 0.05 is within "
        f"{percent(EXCELLENT)} of (35) up to {read[-1]:g}, and differs by "
        f"{', '.join(f'{percent(off)} at {ratio:g}' for ratio, off in strayed.items())}."
    )


def _qualitative(rows: Rows) -> str:
    stopping = next(row for row in rows if row["stops below"])
    errors = ", ".join(f"{percent(row['averaged']['off'])} at {row['ratio']:g}" for row in rows)
    return (
        f"{HERE}: for {_span(rows)} both curves rise up to Ω = 1 and fall beyond. The averaged amplitude "
        f"is off by up to {errors}. That the mass stops within the cycle (at {stopping['ratio']:g} below Ω = "
        f"{stopping['stops below']:.2g}, with more friction on both sides) is not captured."
    )


def _low_friction(rows: Rows) -> str:
    low = [row for row in rows if row["ratio"] < LOW]
    same = [row for row in rows if row["ratio"] <= same_up_to(rows)]
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
    row = next(row for row in rows if not same_folds(row))
    counts = [len(kinds(row[side])) for side in ("averaged", "exact")]
    return f"at {row['ratio']:g} and F_0 = {row['F_0']:.2g} averaging finds {counts[0]}, direct integration {counts[1]}"


def _acceptable(figure: dict[str, Any]) -> str:
    rows = figure["rows"]
    fine = [row for row in rows if row["point"]["off"] <= ACCEPTABLE]
    coarse = ", ".join(
        f"{percent(row['point']['off'])} at {row['forcing']} ({percent(row['height']['off'])} of the peak)"
        for row in rows
        if row not in fine
    )
    jumps = _jumps([row for row in rows if row["forcing"] != "F_SN"])
    return (
        f"{HERE}: with Table 1 and the forcings of Table 2 the largest amplitudes are accurate to {_peaks(rows)}, the "
        f"jumps' frequencies and amplitudes to {jumps}, F_SN to {percent(abs(figure['F_SN']['off']))}. Every "
        f"point of the curve is within {percent(ACCEPTABLE)} only at {', '.join(row['forcing'] for row in fine)} "
        f"(μ/F_0 ≤ {max(row['ratio'] for row in fine):.2g}). Elsewhere amplitudes far from resonance are off by up to "
        f"{coarse}."
    )


def _span(rows: Rows) -> str:
    return f"μ/F_0 = {rows[0]['ratio']:g} to {rows[-1]['ratio']:g}"


def _peaks(rows: Rows) -> str:
    return percent(max(map(peak_error, rows)))


def _jumps(rows: Rows) -> str:
    return percent(max(error for row in rows for error in jump_errors(row)))
