"""In: `Facts`. Out: the rows of formulas, tables and numbers, each with its verdict."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from itertools import groupby

import sympy as sp
from flint import arb

from ..mechanisms.rod_spring import delta_h
from ..symbols import mu, zeta
from .balls import evaluate, rounded, significant
from .facts import MESH, Facts
from .formulas import Subject, stiffness
from .proofs import canonical
from .rows import AMBIGUOUS, DIFFERS, IDENTICAL, INPUT, Row
from .typeset import mathml

# ---- formulas -----------------------------------------------------------------------------------------------------


def formula_rows(facts: Facts) -> list[Row]:
    """One row for each entry of FORMULAS, in the paper's order."""
    rows = []
    for _, group in groupby(facts.published.FORMULAS, key=lambda f: (f.where, f.quantity)):
        readings = list(group)
        agreeing = [f for f in readings if facts.judgements[f.name].verdict != DIFFERS]
        for formula in readings:
            judgement, subject = facts.judgements[formula.name], facts.subjects.get(formula.name, Subject(()))
            verdict, evidence = judgement.verdict, [judgement.evidence]
            if verdict == DIFFERS and agreeing and not subject.literal:
                verdict = AMBIGUOUS
                evidence.append(f"The proved reading: {agreeing[0].reading}.")
            if judgement.factor:
                evidence.append(f"It is the derived expression times {judgement.factor}.")
            rows.append(
                Row(
                    id=formula.name,
                    kind="formula",
                    where=formula.where,
                    quantity=formula.quantity + (f" [{formula.reading}]" if formula.reading else ""),
                    published=judgement.published,
                    derived=judgement.derived,
                    mathml=tuple(map(mathml, judgement.printed)),
                    verdict=verdict,
                    difference=judgement.difference,
                    evidence=" ".join(filter(None, evidence)),
                )
            )
    return rows


# ---- Table 2 ------------------------------------------------------------------------------------------------------

COLUMNS = ("F_0", "jump_up_Omega", "jump_up_A", "jump_down_Omega", "jump_down_A")


@dataclass(frozen=True)
class Entry:
    """An entry of Table 2: derived to 12 digits, and what the printed value is the value of where it differs."""

    verdict: str
    derived: str
    difference: str = ""
    evidence: str = ""


def decimals(printed: str) -> int:
    """Digits after the point."""
    return len(printed.partition(".")[2])


def _truncated(value: arb, digits: int) -> str:
    return rounded(value - arb(10) ** -digits / 2, digits)


def _halfway(value: arb, digits: int) -> str:
    """The middle between the two printable values around a value."""
    return _truncated(value, digits) + "5"


def table_2_entry(facts: Facts, row: int, column: str) -> Entry:
    """The verdict on one entry, rows counted from 1."""
    label = facts.published.TABLE_2[row - 1].F_0
    printed = getattr(facts.published.TABLE_2[row - 1], column)
    if column == "F_0":
        if label.replace(".", "").isdigit():
            return Entry(INPUT, label)
        return Entry(IDENTICAL, significant(facts.forcing(label)), evidence="The name of the forcing.")
    if label == "F_SN":
        return Entry(IDENTICAL, "-", evidence="At the onset the two folds are one point, and nothing jumps.")
    kind, quantity = column.rsplit("_", 1)
    kind = kind.replace("_", "-")
    value = getattr(facts.fold(label, kind), quantity)
    derived = significant(value)
    target = facts.example.u_cr if printed == "u_cr" else arb(printed)
    if printed != "u_cr" and rounded(value, decimals(printed)) == printed:
        return Entry(IDENTICAL, derived)
    difference = significant(target - value, 3)
    return Entry(DIFFERS, derived, difference, _explained(facts, label, kind, quantity, printed, value))


def _explained(facts: Facts, label: str, kind: str, quantity: str, printed: str, value: arb) -> str:
    """What the printed value would be the value of."""
    if printed == "u_cr":
        peak = facts.example.detachment
        if not facts.example.stability(peak.Omega, peak.A) > 0:
            raise ArithmeticError("the peak at u_cr is a fold")
        return (
            f"At F_cr the fold lies below u_cr = {significant(facts.example.u_cr)}. The point of the response at u_cr "
            f"is its peak, at Ω = {significant(peak.Omega)}, where F_Ω = 0 and F_A > 0: stable, no saddle node."
        )
    digits = decimals(printed)
    if label == "F_cr":
        other = facts.fold("0.0300", kind)
        if rounded(getattr(other, quantity), digits) == printed:
            return (
                "It is the value at F_0 = 0.0300, the rounded F_cr: there the fold is at Ω = "
                f"{significant(other.Omega)}, A = {significant(other.A)}."
            )
    mesh = facts.mesh_point(label, kind)
    if quantity == "A" and rounded(mesh.A, digits) == printed:
        return (
            f"It is {mesh.k}/{MESH}, the point with the extremal Ω, {significant(mesh.Omega)}, among those of the "
            f"response at A = k/{MESH} (1000 points on [0, 1]). Near a fold Ω depends on A by its square only, so the "
            "printed Ω is right and the printed A is off by up to half a step of the mesh."
        )
    if _truncated(value, digits) == printed:
        return (
            f"The derived value is {significant(value - arb(_halfway(value, digits)), 2)} above the midpoint of two "
            "four-digit values. The printed value is this number truncated, or read off a mesh as the amplitudes are: "
            f"linear interpolation of F between frequencies 1/{MESH} apart lowers this Ω by up to "
            f"{significant(facts.chord_shortfall, 2)}."
        )
    tried = "; ".join(f"{name}: {rounded(p.Omega, 6)}" for name, p in facts.variants.items())
    return (
        f"No parameter or formula tried gives it, while A = {rounded(facts.fold(label, kind).A, 4)} is as printed, and "
        f"the response has Ω = {rounded(mesh.Omega, 6)} at this A. Tried: {tried}; peak: "
        f"{rounded(facts.peaks[label].Omega, 4)}. The digits suggest a misprint for {_truncated(value, digits)}; that "
        "cannot be proved."
    )


# ---- numbers ------------------------------------------------------------------------------------------------------

#: printed strings that are no decimals
SYMBOLIC: dict[str, sp.Expr] = {"4/π": 4 / sp.pi, "π/4": sp.pi / 4, "π/2": sp.pi / 2, "πμ/4": sp.pi * mu / 4}


def _measured(value: Callable[[Facts], arb], remark: Callable[[Facts], str] = lambda facts: "") -> Callable:
    def entry(facts: Facts, printed: str) -> Entry:
        x = value(facts)
        if rounded(x, decimals(printed)) == printed:
            return Entry(IDENTICAL, significant(x), evidence=remark(facts))
        return Entry(DIFFERS, significant(x), significant(arb(printed) - x, 3), remark(facts))

    return entry


def _exact(value: Callable[[Facts], sp.Expr], remark: str = "") -> Callable:
    def entry(facts: Facts, printed: str) -> Entry:
        derived = sp.sympify(value(facts))
        stated = SYMBOLIC[printed] if printed in SYMBOLIC else sp.Rational(*Fraction(printed).as_integer_ratio())
        difference = canonical(stated - derived)
        if difference.is_zero:
            return Entry(IDENTICAL, sp.sstr(derived), evidence=remark)
        return Entry(DIFFERS, sp.sstr(derived), difference.text(), remark)

    return entry


def _omega_cr(facts: Facts) -> str:
    fold, at = facts.fold("0.0300", "jump-down"), facts.example.detachment
    other = facts.example.frequencies(facts.example.u_cr, arb("0.03003"))[-1]
    return (
        f"The lowest force at A = u_cr is {significant(at.F_0)}, at the frequency Ω_cr. 0.9288 is the frequency of the "
        f"jump-down fold at F_0 = 0.0300, {significant(fold.Omega)}, where A = {significant(fold.A)}, as in Table 2. "
        f"(24) with A = u_cr has no real Ω at F_0 = 0.0300; at 0.03003 it has {significant(other, 5)}."
    )


def _stiffness_at(preload: str) -> Callable[[Facts], sp.Expr]:
    def value(facts: Facts) -> sp.Expr:
        alpha = stiffness(facts.results)
        quasi_zero = sp.solve(alpha, delta_h)[0]
        return alpha.subs(delta_h, {"none": sp.Integer(0), "quasi-zero": quasi_zero}[preload])

    return value


def _ratio(facts: Facts) -> sp.Expr:
    return facts.results.flows[""].friction / mu


def _degree(which: str) -> Callable[[Facts], sp.Expr]:
    return lambda facts: sp.Integer(
        facts.rod.saddle_node_onset.degree if which == "A_s" else facts.results.detachment[""].resultant.degree
    )


NUMBERS: dict[str, Callable] = {
    "rod_angle": _exact(
        lambda facts: sp.asin(facts.rod.oscillator.exact[0].subs(sp.Symbol("u", real=True), 0)),
        "The force is odd: u = sin θ = 0 is an equilibrium.",
    ),
    "alpha_linear": _exact(_stiffness_at("none")),
    "alpha_qzs": _exact(_stiffness_at("quasi-zero"), "At δ_h = 1/(λ r)."),
    "envelope_threshold": _exact(_ratio),
    "resultant_A_s_degree": _exact(_degree("A_s")),
    "resultant_F_cr_degree": _exact(_degree("F_cr")),
    "amplitude_limit": _exact(
        lambda facts: facts.rod.oscillator.mechanism.reach, "The push-rod stands vertical at u = 1."
    ),
    "rod_angle_vertical": _exact(lambda facts: sp.asin(facts.rod.oscillator.mechanism.reach)),
    "S_threshold": _exact(
        lambda facts: sp.Rational(1, 2) if facts.S_is_one else sp.nan,
        "S = 1 above it, proved; below it S > 1, see (37).",
    ),
    "S_value": _exact(lambda facts: sp.Integer(1) if facts.S_is_one else sp.nan, "For Ω > 1/2, Ω ≠ 1."),
    "sticking_threshold": _exact(lambda facts: 1 / _ratio(facts)),
    "sticking_exceeded": _exact(lambda facts: 1 / _ratio(facts)),
    "conclusion_threshold": _exact(lambda facts: 1 / _ratio(facts)),
    "F_cr_limit": _exact(
        lambda facts: facts.results.flows[""].friction, "See the formula row: the fraction is inverted."
    ),
    "u_cr": _measured(lambda facts: facts.example.u_cr),
    "F_cr": _measured(lambda facts: facts.example.detachment.F_0),
    "Omega_cr": _measured(lambda facts: facts.example.detachment.Omega, _omega_cr),
    "delta_h_limit": _measured(
        lambda facts: evaluate(1 / (3 * sp.Rational(*facts.published.TABLE_1["r"].as_integer_ratio())), {}),
        lambda facts: "(3 r)^-1 with Table 1's r.",
    ),
    "peak_shift": _measured(
        lambda facts: evaluate(sp.sqrt(1 - 2 * zeta**2), {zeta: facts.example.zeta}),
        lambda facts: (
            "√(1 − 2ζ²), the root of the peak cubic for h = −A, to which h tends as A grows. At 0.040 and 0.050 the "
            "peaks are at Ω = " + ", ".join(rounded(p.Omega, 4) for p in facts.peaks.values()) + "."
        ),
    ),
    "F_SN": _measured(lambda facts: facts.example.onset.F_0),
    "Omega_SN": _measured(lambda facts: facts.example.onset.Omega),
    "A_SN": _measured(lambda facts: facts.example.onset.A),
}

#: printed with a bracket or a fraction bar that our text lost; the formula rows try both readings
BRACKETS = {"6 r^-1": "captions of Figures 2, 3, 4", "1/6 r": "Table 1"}


def number_rows(facts: Facts) -> list[Row]:
    """One row for each entry of NUMBERS: those of Tables 1 and 2 as tables, the rest as numbers."""
    rows = []
    for number in facts.published.NUMBERS:
        entry = _number(facts, number.id, number.printed)
        kind = "table" if number.id.startswith("table_") else "number"
        rows.append(
            Row(
                id=number.id,
                kind=kind,
                where=number.where,
                quantity=_quantity(facts, number.id) or number.symbol or number.id,
                published=number.printed,
                derived=entry.derived,
                verdict=entry.verdict,
                difference=entry.difference,
                evidence=entry.evidence,
            )
        )
    return rows


def _quantity(facts: Facts, name: str) -> str:
    """Which entry of Table 2 this is, in words."""
    if not name.startswith("table_2_row_"):
        return ""
    row, column = name.removeprefix("table_2_row_").split("_", 1)
    kind, _, quantity = column.rpartition("_")
    label = facts.published.TABLE_2[int(row) - 1].F_0
    return "F_0" if column == "F_0" else f"{kind.replace('_', '-')} {quantity} at {label}"


def _number(facts: Facts, name: str, printed: str) -> Entry:
    if name in NUMBERS:
        return NUMBERS[name](facts, printed)
    if name.startswith("table_2_row_"):
        row, column = name.removeprefix("table_2_row_").split("_", 1)
        return table_2_entry(facts, int(row), column)
    if printed in BRACKETS:
        return Entry(AMBIGUOUS, "", evidence=f"Both readings are listed among the formulas, under {BRACKETS[printed]}.")
    if name.endswith("_r") and printed == "2.03":
        return Entry(INPUT, "", evidence="Table 1's 3747/1848 = 2.0276, rounded.")
    return Entry(INPUT, "")


def table_2(rows: list[Row], facts: Facts) -> list[dict[str, dict[str, str]]]:
    """Table 2 for programs: for each row and column what is published, derived, and the verdict."""
    by_id = {row.id: row for row in rows}
    return [
        {
            column: {
                "published": by_id[f"table_2_row_{k}_{column}"].published,
                "derived": by_id[f"table_2_row_{k}_{column}"].derived,
                "verdict": by_id[f"table_2_row_{k}_{column}"].verdict,
            }
            for column in COLUMNS
        }
        for k in range(1, len(facts.published.TABLE_2) + 1)
    ]
