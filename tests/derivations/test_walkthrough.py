"""In: the derivation. Out: whether the walkthrough has every equation of the paper, in order, with its verdict."""

import re
from collections.abc import Iterator

import pytest
import sympy as sp

from derivations import walkthrough
from derivations.claims import PROVED, Unproved, claim
from derivations.claims import page as proved_page
from derivations.ledger import balls, entries, published
from derivations.ledger.facts import Facts
from derivations.ledger.findings import Contradiction
from derivations.results import Results
from tests.derivations.test_ledger import mistaken


@pytest.fixture(scope="module")
def facts(results: Results) -> Iterator[Facts]:
    with balls.precision():
        yield Facts(results)


@pytest.fixture(scope="module")
def page(facts: Facts) -> str:
    return walkthrough.walkthrough(facts)


def test_every_equation_stands_on_the_page_once_and_in_order(page: str) -> None:
    titles = re.findall(r"^### \((\d+)\)$", page, re.MULTILINE)
    assert titles == [str(number) for number in range(1, 39)]
    steps = [where for section in walkthrough.SECTIONS for where in section.steps]
    stated = [formula.where for formula in published.FORMULAS]
    assert set(steps) <= set(stated)
    assert set(stated) - set(steps) == {"(A1)", "(A2)", "Table 1", "captions of Figures 2, 3, 4", "text of Section 4.3"}


def test_each_verdict_is_the_ledgers(page: str, facts: Facts) -> None:
    rows = entries.formula_rows(facts)
    for where in (where for section in walkthrough.SECTIONS for where in section.steps):
        part = page.split(f"\n### {where[0].upper()}{where[1:]}\n")[1].split("\n### ")[0].split("\n## ")[0]
        verdicts = {row.verdict for row in rows if row.where == where}
        stated = {verdict.lower() for verdict in re.findall(r"^\*\*([^*]+)\.\*\*", part, re.MULTILINE)}
        assert stated and stated <= verdicts, where
        if all(verdict == "differs" for verdict in verdicts):
            assert "Published minus derived" in part, where


def test_expressions_are_set_in_the_papers_letters(page: str) -> None:
    for equation in re.findall(r"\$\$\n(.*?)\$\$", page, re.DOTALL):
        assert equation.count("{") == equation.count("}")
        assert equation.count(r"\left") == equation.count(r"\right")
        assert not re.search(r"lam\b(?<!\\lam)|_dot|_bar|dH_i|acos|asin|atan\b(?<!arctan)", equation), equation


def test_the_left_sides_are_as_many_as_the_expressions(facts: Facts) -> None:
    for name, left in walkthrough.LEFT.items():
        assert len(left) == len(facts.judgements[name].printed), name


def test_it_ends_with_the_papers_numbers(page: str) -> None:
    assert "| $F_{SN}$ | 0.0217 | 0.0217075842289 | identical |" in page
    last = page.rstrip().split("\n")
    assert last[-3].startswith("| 0.050 | 0.8976 = 0.897636120607 | 0.2222 **≠** 0.221731039877 |")


def test_a_wrong_derivation_is_told_by_its_equation(results: Results) -> None:
    wrong = mistaken(results, lambda found: tuple(-value for value in found))
    with (
        balls.precision(),
        pytest.raises(Contradiction, match=r"\(21\)(.|\n)*published(.|\n)*derived(.|\n)*difference"),
    ):
        walkthrough.walkthrough(Facts(wrong))


def test_a_name_is_set_as_the_paper_has_it() -> None:
    assert walkthrough.symbols(sp.Symbol("u_ddot") + sp.Symbol("lam")) == r"\lambda + u''"


def test_failed_claim_names_equation_sides_and_difference() -> None:
    x = sp.Symbol("x")
    with pytest.raises(
        Unproved, match=r"\(30\): not shown: a wrong square\n +left +x\*\*2\n +right +x\n +difference x\*\(x - 1\)"
    ):
        claim("a wrong square", x**2, x, eq="(30)")
    with pytest.raises(Unproved, match="beside the paper: not shown: a sign"):
        claim("a sign", False)
    assert "a wrong square" not in proved_page()


def test_what_is_proved_on_the_way_is_kept(results: Results) -> None:
    assert PROVED["paper.slow_flow"]["`F_A = 8 A Omega^2 det(D_q Gamma)`"] == "(30)"
    assert {"paper.equation_of_motion", "systems.along", "extensions.inertia"} <= PROVED.keys()
    assert "- (30): `F_A = 8 A Omega^2 det(D_q Gamma)`" in proved_page()
