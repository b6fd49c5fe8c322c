"""The rows of the ledger and the closed vocabulary of its verdicts.

In:  what is published and what is derived, as text.
Out: `Row`, one judged entry of the paper, and the verdicts.
"""

from __future__ import annotations

from dataclasses import dataclass

IDENTICAL = "identical"
REWRITTEN = "equal after a stated rewriting"
DIFFERS = "differs"
AMBIGUOUS = "not decidable: our text is ambiguous"
INPUT = "input"
TRUE = "true"
FALSE = "false"
LOOSE = "imprecise"
DEFINITION = "definition"

#: what each verdict says, in the order of the summary
VOCABULARY: dict[str, str] = {
    IDENTICAL: "formulas are proved to be the same expression up to the order of terms; for numbers, the derived value "
    "rounds to the printed digits",
    REWRITTEN: "formulas are proved equal over the rationals with the relations named in the row",
    DIFFERS: "the exact difference is not zero, or the printed digits are not the rounding of the derived value",
    AMBIGUOUS: "our plain-text copy of the paper lost a sign or a bracket; this reading differs, and another one is "
    "proved",
    INPUT: "a value that the author chose, so that there is nothing to derive",
    TRUE: "the sentence holds, by the evidence given",
    FALSE: "the sentence does not hold, by the evidence given",
    LOOSE: "the sentence holds only with a condition, or in a sense, that it does not state",
    DEFINITION: "the sentence introduces a name, a convention or a choice of method: there is nothing to decide",
}

#: the kinds of rows, with the verdicts that each may have
ALLOWED: dict[str, tuple[str, ...]] = {
    "formula": (IDENTICAL, REWRITTEN, DIFFERS, AMBIGUOUS),
    "table": (IDENTICAL, DIFFERS, AMBIGUOUS, INPUT),
    "number": (IDENTICAL, DIFFERS, AMBIGUOUS, INPUT),
    "claim": (TRUE, FALSE, LOOSE, DEFINITION),
}


@dataclass(frozen=True)
class Row:
    """One entry of the paper, judged."""

    id: str  #: of a formula: the name of its function in published.py; of the rest: its id there
    kind: str  #: formula, table, number or claim
    where: str  #: equation number, section or table
    quantity: str  #: what it gives; of a formula with several readings: the reading in brackets
    published: str  #: as the paper has it
    derived: str  #: what the derivation has in its place; of a claim: empty
    verdict: str  #: one of `ALLOWED[kind]`
    difference: str = ""  #: published less derived where it is not zero
    evidence: str = ""  #: the rewriting used, the proof, or what the published value is the value of
    mathml: tuple[str, ...] = ()  #: of a formula: as the paper has it, set, each of its expressions

    def __post_init__(self) -> None:
        if self.verdict not in ALLOWED[self.kind]:
            raise ValueError(f"{self.id}: a {self.kind} cannot be {self.verdict!r}")
