"""In: rows, findings, Table 2, the cost of truncation. Out: the text of LEDGER.md, ledger.json and table_1.py."""

from __future__ import annotations

import json
from dataclasses import asdict
from fractions import Fraction
from itertools import groupby
from operator import attrgetter
from pathlib import Path
from typing import Any

import jinja2

from . import measured
from .findings import Finding, readings
from .rows import ALLOWED, LOOSE, TRUE, VOCABULARY, Row

#: letters of the rows of a kind on a page
MOST_SHOWN = 8000
TITLES = {"formula": "Formulas", "table": "Tables 1 and 2", "number": "Numbers", "claim": "Sentences"}
CITATION = (
    "G. Iarriccio, Primary Resonance Analysis of High-Static–Low-Dynamic Stiffness Isolators with Piecewise Stiffness, "
    "Viscous Damping, and Dry Friction, Appl. Sci. 2025, 15(8), 4187, doi:10.3390/app15084187"
)


def _cell(text: str) -> str:
    # a code span shows a backslash as it is
    spans = text.replace("|", "\\|").split("`")
    return "`".join(span if i % 2 else span.replace("*", "\\*").replace("_", "\\_") for i, span in enumerate(spans))


def _code(text: str) -> str:
    return "`" + text.replace("|", "\\|") + "`" if text else ""


def stretches(rows: list[Row], kind: str) -> list[tuple[str, list[Row]]]:
    """The rows of a kind, as many as fit on a page of the site, under their title and the first and last place."""
    pages: list[list[Row]] = []
    for _, place in groupby((row for row in rows if row.kind == kind), key=attrgetter("where")):
        these = list(place)
        if not pages or sum(map(_size, pages[-1] + these)) > MOST_SHOWN:
            pages.append([])
        pages[-1] += these
    if len(pages) == 1:
        return [(TITLES[kind], pages[0])]
    ends = [(page[0].where, page[-1].where) for page in pages]
    spans = [first if first == last else f"{first} to {last}" for first, last in ends]
    return [(f"{TITLES[kind]}: {span}", page) for span, page in zip(spans, pages, strict=True)]


def _size(row: Row) -> int:
    """Letters of a row, and as many as its lines and borders take."""
    return 60 + len(row.published + row.derived + row.difference + row.evidence)


def counts(rows: list[Row]) -> dict[str, dict[str, int]]:
    """Number of rows by kind and verdict."""
    return {
        kind: {verdict: sum(row.kind == kind and row.verdict == verdict for row in rows) for verdict in VOCABULARY}
        for kind in ALLOWED
    }


def environment(folder: Path) -> jinja2.Environment:
    """For the templates of a folder."""
    made = jinja2.Environment(
        loader=jinja2.FileSystemLoader(folder),
        undefined=jinja2.StrictUndefined,
        autoescape=False,
        keep_trailing_newline=True,
    )
    made.filters |= {"cell": _cell, "code": _code}
    return made


def markdown(
    rows: list[Row], findings: list[Finding], table_2: list[dict[str, dict[str, str]]], cost: list[dict[str, str]]
) -> str:
    """LEDGER.md."""
    return (
        environment(Path(__file__).parent)
        .get_template("LEDGER.md.jinja")
        .render(
            rows=rows,
            findings=findings,
            table_2=table_2,
            cost=cost,
            readings=readings(rows),
            counts=counts(rows),
            kinds=list(ALLOWED),
            stretches={kind: stretches(rows, kind) for kind in ALLOWED},
            vocabulary=VOCABULARY,
            citation=CITATION,
            criteria=measured.CRITERIA,
        )
    )


def machine_readable(
    rows: list[Row], findings: list[Finding], table_2: list[dict[str, dict[str, str]]], cost: list[dict[str, str]]
) -> str:
    """ledger.json, an entry a line."""
    record = {
        "paper": CITATION,
        "vocabulary": VOCABULARY,
        "counts": counts(rows),
        "table_2": table_2,
        "truncation": cost,
        "criteria": {claim: {TRUE: true, LOOSE: loose} for claim, (true, loose) in measured.CRITERIA.items()},
        "findings": [asdict(finding) for finding in findings],
        "rows": [asdict(row) for row in rows],
    }
    return "{\n" + ",\n".join(f"{_text(name)}: {_lines(entries)}" for name, entries in record.items()) + "\n}\n"


def table_1(published: dict[str, Fraction]) -> str:
    """The published numbers of the example, as doubles."""
    numbers = "".join(f'    "{name}": {float(value)!r},\n' for name, value in published.items())
    return f'''"""Table 1 of the paper: lam, r, delta_h, mu, zeta, each the double next to the published fraction.

Written by `make derive`; never edit.
"""

TABLE_1: dict[str, float] = {{
{numbers}}}
'''


def _lines(entries: Any) -> str:
    """The entries of a list or a dictionary below each other, anything else in a line."""
    if isinstance(entries, dict):
        return "{\n " + ",\n ".join(f"{_text(name)}: {_text(value)}" for name, value in entries.items()) + "\n}"
    if isinstance(entries, list):
        return "[\n " + ",\n ".join(map(_text, entries)) + "\n]"
    return _text(entries)


def _text(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False)
