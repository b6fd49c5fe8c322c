"""In: benchmarks/results/claims.json, measured by direct integration. Out: verdicts on sentences that judge figures.

The measuring needs the runtime and is done by `python -m benchmarks.claims`; here its numbers are data. What a word
such as "excellent" asks for is in `CRITERIA`, and each verdict follows from it. The sizes in it were settled before
anything was measured; three readings were not, and LEDGER.md names them.
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

#: by claim: what makes it true, what imprecise; otherwise it is false
CRITERIA: dict[str, tuple[str, str]] = {
    "den_hartog_agreement": (
        "for at least three values of μ/F_0, (35) is within 1 % of the exact amplitude in the whole window, and the "
        "result of the paper's own recipe is within 1 % of (35) wherever the recipe was run",
        "(35) within 1 % only where the mass does not stop, or the recipe for fewer values",
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


def _highest(rows: list[dict[str, Any]], below: float) -> float:
    return float(max(row["ratio"] for row in rows if row["ratio"] < below))


def den_hartog(figure: dict[str, Any]) -> str:
    """Fig. 2a: (35) against the exact motion, and the paper's own integration against (35)."""
    rows = figure["rows"]
    return _verdict(
        len(set(excellent_throughout(rows)) & set(excellent_as_read(figure))) >= SEVERAL,
        all(row["moving"]["off"] <= EXCELLENT for row in rows) and excellent_as_read(figure) != [],
    )


def excellent_throughout(rows: list[dict[str, Any]]) -> list[float]:
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


def qualitative(rows: list[dict[str, Any]]) -> str:
    """Fig. 2a: the averaged curve rises and falls as the exact one."""
    same = {row["ratio"]: row["course"]["averaged"] == row["course"]["exact"] for row in rows}
    return _verdict(all(same.values()), all(agrees for ratio, agrees in same.items() if ratio < LOW))


def same_up_to(rows: list[dict[str, Any]]) -> float:
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
