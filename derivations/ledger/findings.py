"""In: the rows and `Facts`. Out: everything that differs or is false, each with its proof in a paragraph."""

from __future__ import annotations

from dataclasses import dataclass

from .balls import rounded, significant
from .facts import MESH, Facts
from .rows import AMBIGUOUS, DIFFERS, FALSE, Row

#: the published formulas that differ from what is derived; each has its finding below
KNOWN_TO_DIFFER = {
    "F_cr_limit_literal",
    "H_i_integrand_minus",
    "H_i_integrand_plus",
    "smoothed_equation_of_motion_x",
}


class Contradiction(ArithmeticError):
    """The derivation and the published formulas part where no finding says so: most likely an error of derivation."""


@dataclass(frozen=True)
class Finding:
    """A title, the rows that it speaks of (kind and id), and the paragraph."""

    title: str
    rows: tuple[str, ...]
    paragraph: str


def key(row: Row) -> str:
    """kind:id. A number and a claim may share an id."""
    return f"{row.kind}:{row.id}"


def check_formulas(rows: list[Row]) -> None:
    """Raise `Contradiction` where rows of formulas differ or agree otherwise than is known.

    Called before any number is computed: from a wrong formula numbers follow that have no folds, or too many.
    """
    differences = [
        f"{row.where}, {row.quantity} ({row.id}):\n    published  {row.published}\n    derived    {row.derived}\n"
        + (f"    difference {row.difference}" if row.difference else "    they agree, where a finding says they differ")
        for row in rows
        if (row.verdict == DIFFERS) != (row.id in KNOWN_TO_DIFFER)
    ]
    _raise(differences)


def check_averages(facts: Facts) -> None:
    """Raise `Contradiction` where numbers would be computed by other averages than formulas were held against."""
    _raise(
        [
            f"{name}:\n    by H_i     {by_formula}\n    derived    {derived}\n    difference {difference}"
            for name, by_formula, derived, difference in facts.whole_differs()
        ]
    )


def _raise(differences: list[str]) -> None:
    if differences:
        raise Contradiction("\n".join(["the derivation does not give what is published:", *differences]))


def findings(facts: Facts, rows: list[Row]) -> list[Finding]:
    """Every finding, in the paper's order; an error if a row that differs belongs to none, or to two, or agrees."""
    by_key = {key(row): row for row in rows}
    found = _findings(facts, {name: row.evidence for name, row in by_key.items()})
    explained = [name for finding in found for name in finding.rows]
    due = [name for name, row in by_key.items() if row.verdict in (DIFFERS, FALSE)]
    if sorted(explained) != sorted(due):
        raise ArithmeticError(f"findings and rows part at {sorted(set(explained) ^ set(due))}")
    return found


def _findings(facts: Facts, evidence: dict[str, str]) -> list[Finding]:
    example = facts.example
    rounded_row = {kind: facts.fold("0.0300", kind) for kind in ("jump-up", "jump-down")}
    printed = ", ".join(
        f"{mesh.k}/{MESH} = {rounded(mesh.A, 4)}"
        for label in ("0.025", "0.0300", "0.040", "0.050")
        for mesh in (facts.mesh_point(label, kind) for kind in ("jump-up", "jump-down"))
        if (label, mesh.k) != ("0.0300", 395)
    )
    entry = "table:table_2_row_{}_{}".format

    def judged(title: str, *rows: str) -> Finding:
        """A finding whose paragraph is the evidence of the first of its rows."""
        return Finding(title, rows, evidence[rows[0]])

    return [
        Finding(
            "(20): the prefactor is half of what (21) and (22) need",
            ("formula:H_i_integrand_plus", "formula:H_i_integrand_minus"),
            "The derived integrand is −(1/π) f_k cos ψ. Integrated over the cycle it gives the published (21), and "
            "over the four intervals between detachments the published (22) "
            f"({'both are proved' if facts.integrals_agree else 'not proved'}). (19) is correct with (21) and (22). "
            "Our plain-text copy of the paper lost the sign in front of (20): with a minus sign (20) gives H_i/2, with "
            "a plus sign −H_i/2. So (20) should be H_i = −(1/π)∫. The error does not affect (21) and later equations.",
        ),
        judged("Section 3.1: a nonzero μ does not require a numerical solution", "claim:numerical_only"),
        judged(
            "Section 3.2: a negative trace does not make every eigenvalue's real part negative", "claim:trace_negative"
        ),
        judged(
            "Section 3.2: at a saddle node an eigenvalue is zero, not purely imaginary", "claim:imaginary_eigenvalue"
        ),
        Finding(
            "(33): the least positive real root is not A_s",
            ("claim:minimum_root", "claim:one_positive_root"),
            "(33) itself is right: degree 36, even powers, one irreducible factor. "
            + evidence["claim:minimum_root"]
            + " Elimination does not distinguish the signs of Ω, so a root of the resultant is a candidate that must "
            "be checked in F_A = F_AA = 0. The printed F_SN = 0.0217 belongs to the second root. (34) also has several "
            "roots. "
            + evidence["claim:resultant_even_6"].partition("Three")[1]
            + evidence["claim:resultant_even_6"].partition("Three")[2]
            + " With a small preload, (33) does not give the onset at all: there is an inflection point below u_cr o"
            + evidence["claim:inflection"][1:],
        ),
        Finding(
            "(37): S is not close to 1 below Ω = 1/2",
            ("claim:S_below_half",),
            evidence["claim:S_below_half"] + " (S = 1 for Ω > 1/2 is right; the proof is under Section 4.1.)",
        ),
        judged("Section 4.2: λ changes the stiffness at fixed u_cr as r does", "claim:r_only_method"),
        judged(
            "Section 4.2: friction's equivalent damping is not negligible near resonance",
            "claim:zeta_eq_near_resonance",
        ),
        Finding(
            "Section 4.2: F_cr tends to 4μ/π, not πμ/4",
            ("formula:F_cr_limit_literal", "number:F_cr_limit", "claim:F_cr_limit"),
            evidence["claim:F_cr_limit"] + " The fraction is inverted: μ/F_0 = π/4 is the sticking threshold.",
        ),
        judged(
            "Section 4.3: Ω_cr = 0.9288 is the frequency of another point", "number:Omega_cr", "claim:example_Omega_cr"
        ),
        Finding(
            "Table 2, row F_cr: computed at F_0 = 0.0300, and its jump-down is not at u_cr",
            (entry(3, "jump_up_Omega"), entry(3, "jump_down_Omega"), entry(3, "jump_down_A")),
            f"F_cr is {significant(example.detachment.F_0)}. The row contains the folds at 0.0300: Ω = "
            f"{rounded(rounded_row['jump-up'].Omega, 6)} and {rounded(rounded_row['jump-down'].Omega, 6)}; at F_cr "
            f"they are {rounded(facts.fold('F_cr', 'jump-up').Omega, 6)} and "
            f"{rounded(facts.fold('F_cr', 'jump-down').Omega, 6)}. " + evidence[entry(3, "jump_down_A")],
        ),
        Finding(
            f"Table 2: the amplitudes were read off a mesh of step 1/{MESH}",
            (entry(4, "jump_up_A"), entry(5, "jump_up_A")),
            f"Every printed amplitude is a point of the mesh: {printed}. It is the point at which Ω along the "
            "response is extremal. Near a fold Ω depends on A only quadratically, so the frequencies are correct to "
            "four digits, but the amplitudes have an error of up to half a step. Two amplitudes therefore round "
            f"differently: {evidence_pair(facts)}.",
        ),
        judged("Table 2, 0.040: the jump-down frequency is 0.99385, printed 0.9938", entry(4, "jump_down_Omega")),
        Finding(
            "Table 2, 0.050: no parameter tried gives the jump-down frequency 1.0175",
            (entry(5, "jump_down_Omega"), "claim:jump_points"),
            f"The fold is at Ω = {significant(facts.fold('0.050', 'jump-down').Omega)}. "
            + evidence[entry(5, "jump_down_Omega")]
            + f" In all, {facts.table_2_differing} of Table 2's 16 frequencies and amplitudes are not roundings of the "
            "folds.",
        ),
        judged("Section 5 (3): viscous damping raises F_cr at low preload too", "claim:conclusion_3_zeta"),
        Finding(
            "(A1): the spring force is printed as x",
            ("formula:smoothed_equation_of_motion_x",),
            "(A1) is an equation for u, but its spring force is printed as x. With u in place of x, (A1) is identical "
            "to the derived equation.",
        ),
    ]


def evidence_pair(facts: Facts) -> str:
    """The two amplitudes of Table 2 whose mesh values do not round to the fold's."""
    pairs = []
    for label in ("0.040", "0.050"):
        mesh, fold = facts.mesh_point(label, "jump-up"), facts.fold(label, "jump-up")
        pairs.append(f"{rounded(mesh.A, 4)} for {rounded(fold.A, 4)} at {label}")
    return " and ".join(pairs)


def readings(rows: list[Row]) -> list[tuple[str, str, str]]:
    """Passages that our text leaves open: where, what, and the reading that is proved."""
    found = []
    ambiguous = {
        (row.where, row.quantity.split(" [")[0]) for row in rows if row.verdict == AMBIGUOUS and row.kind == "formula"
    }
    for row in rows:
        passage = (row.where, row.quantity.split(" [")[0])
        if row.kind == "formula" and passage in ambiguous and row.verdict != AMBIGUOUS:
            found.append((*passage, row.quantity.partition(" [")[2].rstrip("]")))
    return found
