"""`python -m derivations.ledger.against`: all publications judged, as docs/literature.md."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from .. import balls, render
from ..literature import all_publications
from . import VOCABULARY, Derived, judged

PAGE = Path(__file__).parents[3] / "docs" / "literature.md"


def page() -> str:
    """The page's text."""
    derived = Derived()
    with balls.precision():
        verdicts = [judged(publication, derived) for publication in all_publications()]
    counts = Counter(
        verdict
        for on in verdicts
        for verdict in (*(row.verdict for row in on.formulas.values()), *(verdict for verdict, _ in on.claims.values()))
    )
    template = render.environment(Path(__file__).parent).get_template("LITERATURE.md.jinja")
    return template.render(verdicts=verdicts, vocabulary=VOCABULARY, counts=counts)


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
