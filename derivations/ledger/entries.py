"""In: `Facts`. Out: the rows of formulas, tables and numbers, each with its verdict."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import groupby

import sympy as sp
from flint import arb

from ..mechanisms.rod_spring import delta_h
from ..symbols import mu, u, zeta
from . import published
from .balls import evaluate, rounded, significant
from .facts import MESH, Facts
from .formulas import Subject, stiffness
from .judging import Judgement
from .proofs import canonical
from .rows import AMBIGUOUS, DIFFERS, IDENTICAL, INPUT, Row
from .typeset import mathml


def row_of(name: str, kind: str, where: str, quantity: str, judged: Judgement) -> Row:
    """What is published somewhere, with its verdict."""
    found = (judged.published, judged.derived, judged.verdict, judged.difference, judged.evidence)
    return Row(name, kind, where, quantity, *found, mathml=tuple(map(mathml, judged.printed)))


# ---- formulas -----------------------------------------------------------------------------------------------------


def formula_rows(facts: Facts) -> list[Row]:
    """One row for each entry of FORMULAS, in the paper's order."""
    rows = []
    for _, group in groupby(published.FORMULAS, key=lambda f: (f.where, f.quantity)):
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
            judged = replace(judgement, verdict=verdict, evidence=" ".join(filter(None, evidence)))
            quantity = formula.quantity + (f" [{formula.reading}]" if formula.reading else "")
            rows.append(row_of(formula.name, "formula", formula.where, quantity, judged))
    return rows


# ---- Table 2 ------------------------------------------------------------------------------------------------------


def decimals(printed: str) -> int:
    """Digits after the point."""
    return len(printed.partition(".")[2])


def _truncated(value: arb, digits: int) -> str:
    return rounded(value - arb(10) ** -digits / 2, digits)


def _halfway(value: arb, digits: int) -> str:
    """The middle between the two printable values around a value."""
    return _truncated(value, digits) + "5"


def _in_table_2(facts: Facts, label: str, column: str, printed: str) -> Judgement:
    """The verdict on one entry: derived to 12 digits, and what the printed value is the value of where it differs."""
    if column == "F_0":
        if printed.replace(".", "").isdigit():
            return Judgement(INPUT, printed, printed)
        return Judgement(IDENTICAL, printed, significant(facts.forcing(label)), evidence="The name of the forcing.")
    if label == "F_SN":
        onset = "At the onset the two folds are one point, and nothing jumps."
        return Judgement(IDENTICAL, printed, "-", evidence=onset)
    kind, quantity = column.rsplit("_", 1)
    kind = kind.replace("_", "-")
    value = getattr(facts.fold(label, kind), quantity)
    if printed != "u_cr" and rounded(value, decimals(printed)) == printed:
        return Judgement(IDENTICAL, printed, significant(value))
    target = facts.example.u_cr if printed == "u_cr" else arb(printed)
    evidence = _explained(facts, label, kind, quantity, printed, value)
    return Judgement(DIFFERS, printed, significant(value), significant(target - value, 3), evidence=evidence)


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
#: printed with a bracket or a fraction bar that our text lost; the formula rows try both readings
BRACKETS = {"6 r^-1": "captions of Figures 2, 3, 4", "1/6 r": "Table 1"}


def _derived(facts: Facts) -> dict[str, tuple[sp.Expr | arb, str]]:
    """What is derived in the place of numbers of the text, exact or certified, and a remark."""
    example, rod = facts.example, facts.rod
    force, reach = rod.oscillator.exact[0], rod.oscillator.mechanism.reach
    alpha, friction = stiffness(facts.results), facts.results.flows[""].friction
    fold, at = facts.fold("0.0300", "jump-down"), example.detachment
    just_above = example.frequencies(example.u_cr, arb("0.03003"))[-1]
    r = sp.Rational(*published.TABLE_1["r"].as_integer_ratio())
    peaks = ", ".join(rounded(p.Omega, 4) for p in facts.peaks.values())
    S, border = (sp.Integer(1), sp.Rational(1, 2)) if facts.S_is_one else (sp.nan, sp.nan)
    sticking = (mu / friction, "")
    return {
        "rod_angle": (sp.asin(force.subs(u, 0)), "The force is odd: u = sin θ = 0 is an equilibrium."),
        "alpha_linear": (alpha.subs(delta_h, 0), ""),
        "alpha_qzs": (alpha.subs(delta_h, sp.solve(alpha, delta_h)[0]), "At δ_h = 1/(λ r)."),
        "envelope_threshold": (friction / mu, ""),
        "resultant_A_s_degree": (sp.Integer(rod.saddle_node_onset.degree), ""),
        "resultant_F_cr_degree": (sp.Integer(facts.results.detachment[""].resultant.degree), ""),
        "amplitude_limit": (reach, "The push-rod stands vertical at u = 1."),
        "rod_angle_vertical": (sp.asin(reach), ""),
        "S_threshold": (border, "S = 1 above it, proved; below it S > 1, see (37)."),
        "S_value": (S, "For Ω > 1/2, Ω ≠ 1."),
        "sticking_threshold": sticking,
        "sticking_exceeded": sticking,
        "conclusion_threshold": sticking,
        "F_cr_limit": (friction, "See the formula row: the fraction is inverted."),
        "u_cr": (example.u_cr, ""),
        "F_cr": (at.F_0, ""),
        "Omega_cr": (
            at.Omega,
            f"The lowest force at A = u_cr is {significant(at.F_0)}, at the frequency Ω_cr. 0.9288 is the frequency of "
            f"the jump-down fold at F_0 = 0.0300, {significant(fold.Omega)}, where A = {significant(fold.A)}, as in "
            "Table 2. (24) with A = u_cr has no real Ω at F_0 = 0.0300; at 0.03003 it has "
            f"{significant(just_above, 5)}.",
        ),
        "delta_h_limit": (evaluate(1 / (3 * r), {}), "(3 r)^-1 with Table 1's r."),
        "peak_shift": (
            evaluate(sp.sqrt(1 - 2 * zeta**2), {zeta: example.zeta}),
            "√(1 − 2ζ²), the root of the peak cubic for h = −A, to which h tends as A grows. At 0.040 and 0.050 the "
            f"peaks are at Ω = {peaks}.",
        ),
        "F_SN": (example.onset.F_0, ""),
        "Omega_SN": (example.onset.Omega, ""),
        "A_SN": (example.onset.A, ""),
    }


def _compared(printed: str, derived: sp.Expr | arb, remark: str) -> Judgement:
    """Whether an exact number is the printed one, and a certified one rounds to it."""
    if isinstance(derived, arb):
        same, shown = rounded(derived, decimals(printed)) == printed, significant(derived)
        difference = "" if same else significant(arb(printed) - derived, 3)
    else:
        stated = SYMBOLIC[printed] if printed in SYMBOLIC else sp.Rational(*Fraction(printed).as_integer_ratio())
        left, shown = canonical(stated - derived), sp.sstr(derived)
        same, difference = left.is_zero, "" if left.is_zero else left.text()
    return Judgement(IDENTICAL if same else DIFFERS, printed, shown, difference, evidence=remark)


def _input(name: str, printed: str) -> Judgement:
    """The verdict on a value that the author chose."""
    if printed in BRACKETS:
        both = f"Both readings are listed among the formulas, under {BRACKETS[printed]}."
        return Judgement(AMBIGUOUS, printed, "", evidence=both)
    rounding = "Table 1's 3747/1848 = 2.0276, rounded." if name.endswith("_r") and printed == "2.03" else ""
    return Judgement(INPUT, printed, "", evidence=rounding)


def number_rows(facts: Facts) -> list[Row]:
    """One row for each entry of NUMBERS: those of Tables 1 and 2 as tables, the rest as numbers."""
    derived, rows = _derived(facts), []
    for one in published.NUMBERS:
        kind = "table" if one.id.startswith("table_") else "number"
        if one.id in derived:
            judged = _compared(one.printed, *derived[one.id])
        elif one.entry:
            judged = _in_table_2(facts, *one.entry, one.printed)
        else:
            judged = _input(one.id, one.printed)
        rows.append(row_of(one.id, kind, one.where, one.symbol or one.id, judged))
    return rows


def table_2(rows: list[Row]) -> list[dict[str, dict[str, str]]]:
    """Table 2 for programs: for each row and column what is published, derived, and the verdict."""
    shown = [
        {"published": row.published, "derived": row.derived, "verdict": row.verdict}
        for row in rows
        if row.where == "Table 2"
    ]
    width = len(published.COLUMNS)
    return [dict(zip(published.COLUMNS, shown[k : k + width], strict=True)) for k in range(0, len(shown), width)]
