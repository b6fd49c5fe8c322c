"""The ledger: every published formula, table entry, number and sentence held against the derivation.

In:  the derivation's `Results`; published.py; benchmarks/results/claims.json, what was measured.
Out: LEDGER.md and ledger.json, and the numbers of Table 1 for the runtime.

    published  every formula, table, number and sentence, typed from the paper
    statements the form of a published formula and sentence
    source     an exact namespace for its functions
    proofs     an expression as a quotient of polynomials over the rationals: zero or not
    formulas   which derived expression stands against which published function
    judging    the verdict on one published function
    balls      enclosures of values, certified roots, certified digits
    example    folds, onset and detachment of an isolator
    facts      every number that the ledger quotes
    entries    rows of formulas, tables and numbers
    claims     rows of sentences
    measured   verdicts on sentences that judge figures, from what direct integration measured
    findings   what differs, with its proof
    truncation what the fifth-order force costs
    render     text
"""

from __future__ import annotations

from ..results import Results
from . import balls, claims, entries, published, render, truncation
from .facts import Facts
from .findings import check_averages, check_formulas, findings
from .rows import Row

__all__ = ["all_rows", "files"]


def all_rows(facts: Facts) -> list[Row]:
    """Every row, in the paper's order within its kind. Call it at the ledger's precision.

    Raises `findings.Contradiction` where a formula is not the published one, with both.
    """
    formulas = entries.formula_rows(facts)
    check_formulas(formulas)
    check_averages(facts)
    return formulas + entries.number_rows(facts) + claims.claim_rows(facts)


def files(results: Results) -> dict[str, str]:
    """LEDGER.md, ledger.json and table_1.py, by name."""
    with balls.precision():
        facts = Facts(results)
        rows = all_rows(facts)
        table_2 = entries.table_2(rows)
        found = findings(facts, rows)
        cost = truncation.cost(facts)
    return {
        "LEDGER.md": render.markdown(rows, found, table_2, cost),
        # beside the kernels, so that they ship with them
        "slowflow_kernels/ledger.json": render.machine_readable(rows, found, table_2, cost),
        "slowflow_kernels/table_1.py": render.table_1(published.TABLE_1),
    }
