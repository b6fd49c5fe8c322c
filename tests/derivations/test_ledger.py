"""In: the derivation, published.py and every single mutant of it. Out: whether the ledger is complete, right and bites.

The numbers are held against `oracles/averaged.py`, which shares no code with the derivation or the ledger.
"""

import ast
import copy
import json
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath
import pytest
import sympy as sp
from flint import arb

from derivations import ledger, symbols
from derivations.ledger import balls, entries, proofs, render
from derivations.ledger import published as PUBLISHED
from derivations.ledger.facts import Facts
from derivations.ledger.findings import Contradiction, check_averages, check_formulas, key
from derivations.ledger.formulas import Subject
from derivations.ledger.judging import judge
from derivations.ledger.rows import ALLOWED, AMBIGUOUS, DIFFERS, FALSE, IDENTICAL, VOCABULARY, Row
from derivations.results import Results
from tests.oracles.averaged import RodSpring

SOURCE = ast.parse(Path(PUBLISHED.__file__).read_text(encoding="utf-8"))
FUNCTIONS = {node.name: node for node in SOURCE.body if isinstance(node, ast.FunctionDef) and node.name[0] != "_"}
NAMES = [formula.name for formula in PUBLISHED.FORMULAS]


@pytest.fixture(scope="module")
def against(results: Results) -> dict[str, Subject]:
    return Facts(results).subjects


@pytest.fixture(scope="module")
def facts(results: Results) -> Iterator[Facts]:
    with balls.precision():
        yield Facts(results)


@pytest.fixture(scope="module")
def files(results: Results) -> dict[str, str]:
    return ledger.files(results)


@pytest.fixture(scope="module")
def written(files: dict[str, str]) -> dict[str, Any]:
    return json.loads(files["slowflow_kernels/ledger.json"])


@pytest.fixture(scope="module")
def rows(written: dict[str, Any]) -> list[Row]:
    return [Row(**row) for row in written["rows"]]


# ---- mutation -----------------------------------------------------------------------------------------------------


def operands(function: ast.FunctionDef) -> list[ast.expr]:
    """Every sign and every integer of a formula, the docstring apart."""
    return [
        node
        for statement in function.body[1:]
        for node in ast.walk(statement)
        if (isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub))
        or (isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub))
        or (isinstance(node, ast.Constant) and isinstance(node.value, int))
    ]


def is_sign(node: ast.expr) -> bool:
    return not isinstance(node, ast.Constant)


def change(node: ast.expr) -> None:
    """Flip the sign, or add one to the number."""
    if isinstance(node, ast.BinOp):
        node.op = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
    elif isinstance(node, ast.UnaryOp):
        node.op = ast.UAdd()
    elif isinstance(node, ast.Constant):
        node.value += 1


def compiled(function: ast.FunctionDef) -> Callable[..., Any]:
    """The function, in the namespace of published.py."""
    namespace = dict(vars(PUBLISHED))
    exec(compile(ast.Module([function], []), "mutant", "exec"), namespace)
    return namespace[function.name]


def mutants(name: str) -> Iterator[tuple[str, Callable[..., Any]]]:
    """Every formula that differs from the published one in one sign or one number; and psi_0 with a product."""
    original = FUNCTIONS[name]
    for k in range(len(operands(original))):
        mutant = copy.deepcopy(original)
        change(operands(mutant)[k])
        yield ast.unparse(mutant.body[-1]), compiled(mutant)
    if not operands(original):
        mutant = copy.deepcopy(original)
        (quotient,) = (n for n in ast.walk(mutant) if isinstance(n, ast.BinOp) and isinstance(n.op, ast.Div))
        quotient.op = ast.Mult()
        yield ast.unparse(mutant.body[-1]), compiled(mutant)


# Published readings that are wrong in a single place, with the change that puts it right: by the ledger's own findings,
# (20) wants 1/pi, and two readings of (37) have the sign of U's other term wrong.
REPAIRS = {
    "H_i_integrand_minus": "return -2 / (2 * xp.pi) * f_k * xp.cos(psi)",
    "S_maximand_plus_plus": "return (Omega * xp.sin(tau) + U * Omega ** 2 * (xp.cos(Omega * tau) - xp.cos(tau))) / "
    "xp.sin(Omega * tau)",
    "S_maximand_plus_minus": "return (Omega * xp.sin(tau) - U * Omega ** 2 * (-xp.cos(Omega * tau) + xp.cos(tau))) / "
    "xp.sin(Omega * tau)",
}


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_every_mutant_differs(name: str, against: dict[str, Subject]) -> None:
    published = judge(vars(PUBLISHED)[name], against[name])
    seen = 0
    for text, mutant in mutants(name):
        seen += 1
        judgement = judge(mutant, against[name])
        if REPAIRS.get(name) == text:
            assert published.verdict == DIFFERS
            assert judgement.verdict != DIFFERS
        else:
            assert judgement.verdict == DIFFERS, text
            assert judgement.difference not in {"", published.difference}, text
    assert seen


def test_mutants_reach_every_place_of_every_formula() -> None:
    assert set(NAMES) == set(FUNCTIONS)
    total = sum(len(operands(FUNCTIONS[name])) for name in NAMES)
    assert total == 456
    without = {name for name in NAMES if not operands(FUNCTIONS[name])}
    assert without == {"psi_0"}
    signs = sum(is_sign(node) for name in NAMES for node in operands(FUNCTIONS[name]))
    assert 0 < signs < total


@pytest.mark.slow
def test_repairs_belong_to_rows_that_differ(against: dict[str, Subject]) -> None:
    for name, text in REPAIRS.items():
        assert judge(vars(PUBLISHED)[name], against[name]).verdict == DIFFERS
        assert text in [mutant for mutant, _ in mutants(name)]


@pytest.mark.slow
def test_a_swapped_formula_is_found(against: dict[str, Subject]) -> None:
    assert judge(PUBLISHED.alpha, against["alpha"]).verdict == IDENTICAL
    assert judge(PUBLISHED.alpha, against["beta"]).verdict == DIFFERS
    assert judge(PUBLISHED.saddle_node_resultant, against["detachment_resultant"]).verdict == DIFFERS


# ---- errors of the derivation -------------------------------------------------------------------------------------


def mistaken(results: Results, change: Callable[[Any], Any]) -> Results:
    """The derivation's results with one of the paper's averages changed, that below the breakpoint."""
    rod = copy.copy(results.mechanisms["rod_spring"])
    first, *others = rod.beside_vertical.regimes
    regimes = (replace(first, derivatives=change(first.derivatives)), *others)
    # kept from its first use on
    rod.__dict__["beside_vertical"] = replace(rod.beside_vertical, regimes=regimes)
    return replace(results, mechanisms={**results.mechanisms, "rod_spring": rod})


@pytest.mark.slow
@pytest.mark.parametrize(
    "change",
    [lambda found: tuple(-value for value in found), lambda found: found[:0]],
    ids=["a wrong sign", "nothing derived"],
)
def test_error_of_the_derivation_is_told_by_its_equation(results: Results, change: Callable[[Any], Any]) -> None:
    with balls.precision(), pytest.raises(Contradiction) as raised:
        ledger.all_rows(Facts(mistaken(results, change)))
    message = str(raised.value)
    assert "(21)" in message and "(H_1)" in message
    for word in ("published", "derived", "difference"):
        assert word in message


@pytest.mark.parametrize("regime", [0, 1])
def test_average_that_formulas_do_not_show_is_told(results: Results, regime: int) -> None:
    """A sign in the rest of the force, which F_k has nothing of: all published formulas agree."""
    rod = copy.copy(results.mechanisms["rod_spring"])
    regimes = list(rod.whole.regimes)
    value, *slopes = regimes[regime].derivatives
    regimes[regime] = replace(regimes[regime], derivatives=(value + 2 * symbols.A, *slopes))
    rod.__dict__["whole"] = replace(rod.whole, regimes=tuple(regimes))
    facts = Facts(replace(results, mechanisms={**results.mechanisms, "rod_spring": rod}))
    with pytest.raises(Contradiction) as raised:
        check_averages(facts)
    message = str(raised.value)
    assert f"h = H_{regime + 1} - A:" in message and "difference 2*A" in message
    assert "by H_i" in message and "derived" in message


def test_agreement_against_a_finding_is_told() -> None:
    row = Row("F_cr_limit_literal", "formula", "4.2", "limit", "x", "x", IDENTICAL)
    with pytest.raises(Contradiction, match="they agree, where a finding says they differ"):
        check_formulas([row])


def test_every_changed_number_differs(facts: Facts, monkeypatch: pytest.MonkeyPatch) -> None:
    """Numbers of the text that the derivation confirms, each with another last digit."""
    confirmed = {row.id for row in entries.number_rows(facts) if row.verdict == IDENTICAL}
    plain = [one for one in PUBLISHED.NUMBERS if one.id in confirmed and not one.entry and "π" not in one.printed]
    changed = [replace(one, printed=one.printed[:-1] + str((int(one.printed[-1]) + 2) % 10)) for one in plain]
    monkeypatch.setattr(PUBLISHED, "NUMBERS", changed)
    rows = entries.number_rows(facts)
    assert len(rows) > 10 and {row.verdict for row in rows} == {DIFFERS}


# ---- completeness -------------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_every_entry_has_exactly_one_row(rows: list[Row]) -> None:
    expected = (
        [f"formula:{name}" for name in NAMES]
        + [f"{'table' if n.id.startswith('table_') else 'number'}:{n.id}" for n in PUBLISHED.NUMBERS]
        + [f"claim:{claim.id}" for claim in PUBLISHED.CLAIMS]
    )
    assert [key(row) for row in rows] == expected
    assert len(set(expected)) == len(expected)


@pytest.mark.slow
def test_table_2_has_a_row_for_every_entry(rows: list[Row], written: dict[str, Any]) -> None:
    by_id = {row.id: row for row in rows if row.kind == "table"}
    assert len(written["table_2"]) == len(PUBLISHED.TABLE_2)
    for k, (row, record) in enumerate(zip(PUBLISHED.TABLE_2, written["table_2"], strict=True), start=1):
        assert tuple(record) == PUBLISHED.COLUMNS
        for column, entry in record.items():
            assert entry["published"] == getattr(row, column)
            assert entry["verdict"] == by_id[f"table_2_row_{k}_{column}"].verdict


@pytest.mark.slow
def test_verdicts_are_of_the_vocabulary(rows: list[Row], written: dict[str, Any]) -> None:
    assert {verdict for allowed in ALLOWED.values() for verdict in allowed} == set(VOCABULARY)
    assert all(row.verdict in ALLOWED[row.kind] for row in rows)
    assert written["counts"] == render.counts(rows)
    assert sum(sum(counts.values()) for counts in written["counts"].values()) == len(rows)
    with pytest.raises(ValueError, match="cannot be 'true'"):
        Row("x", "formula", "", "", "", "", "true")


@pytest.mark.slow
def test_every_verdict_is_backed(rows: list[Row]) -> None:
    for row in rows:
        if row.verdict == DIFFERS:
            assert row.difference, row.id
        if row.kind == "claim" or row.verdict == AMBIGUOUS:
            assert row.evidence, row.id
        if row.verdict == IDENTICAL:
            assert not row.difference, row.id


@pytest.mark.slow
def test_findings_hold_everything_that_differs_once(rows: list[Row], written: dict[str, Any]) -> None:
    named = Counter(name for finding in written["findings"] for name in finding["rows"])
    assert set(named.values()) == {1}
    assert set(named) == {key(row) for row in rows if row.verdict in (DIFFERS, FALSE)}
    assert all(finding["paragraph"] for finding in written["findings"])


@pytest.mark.slow
def test_markdown_shows_every_row(files: dict[str, str], rows: list[Row]) -> None:
    text = files["LEDGER.md"]
    for line in text.splitlines():
        if line.startswith("| "):
            assert line.rstrip().endswith("|")
    assert sum(line.startswith("| ") for line in text.splitlines()) >= len(rows)


# ---- numbers against the independent oracle -----------------------------------------------------------------------


@pytest.fixture(scope="module")
def isolator() -> RodSpring:
    return RodSpring(**PUBLISHED.TABLE_1)


def close(printed: str, reference: Any) -> bool:
    """Whether twelve printed digits are those of the reference."""
    return abs(Decimal(printed) / Decimal(arb(reference.mid()).str(30, radius=False)) - 1) < Decimal("5e-12")


@pytest.mark.slow
def test_table_2_against_the_oracle(isolator: RodSpring, written: dict[str, Any]) -> None:
    critical = isolator.detachment().F_0
    for record in written["table_2"][1:]:
        printed = record["F_0"]["published"]
        level = Fraction(arb(critical.mid()).str(40, radius=False)) if printed == "F_cr" else Fraction(printed)
        folds = {point.kind: point for point in isolator.folds(level)}
        assert set(folds) == {"jump-up", "jump-down"}
        for kind, point in folds.items():
            name = kind.replace("-", "_")
            assert close(record[f"{name}_Omega"]["derived"], point.Omega)
            assert close(record[f"{name}_A"]["derived"], point.A)


@pytest.mark.slow
def test_onset_and_detachment_against_the_oracle(isolator: RodSpring, rows: list[Row]) -> None:
    derived = {row.id: row.derived for row in rows if row.kind == "number"}
    onset, detachment = isolator.onset(), isolator.detachment()
    assert onset is not None
    assert close(derived["F_SN"], onset.F_0)
    assert close(derived["Omega_SN"], onset.Omega)
    assert close(derived["A_SN"], onset.A)
    assert close(derived["F_cr"], detachment.F_0)
    assert close(derived["Omega_cr"], detachment.Omega)


@pytest.mark.slow
@pytest.mark.parametrize("forcing", ["0.016", "0.0217", "0.025", "0.0302", "0.035", "0.045", "0.1"])
def test_number_of_folds_against_the_oracle(forcing: str, isolator: RodSpring, facts: Facts) -> None:
    inside = [point for point in isolator.folds(Fraction(forcing)) if point.A < 1]
    found = facts.example.folds(arb(forcing))
    assert len(found) == len(inside)
    for ours, reference in zip(found, inside, strict=True):
        assert ours.kind == reference.kind
        assert ours.Omega.overlaps(reference.Omega)
        assert ours.A.overlaps(reference.A)


# ---- the judge itself ---------------------------------------------------------------------------------------------

x, y = sp.symbols("x y", positive=True)


@pytest.mark.parametrize(
    "zero",
    [
        sp.sin(3 * x) - 3 * sp.sin(x) + 4 * sp.sin(x) ** 3,
        sp.cos(x + y) - sp.cos(x) * sp.cos(y) + sp.sin(x) * sp.sin(y),
        sp.tan(x / 2) - sp.sin(x) / (1 + sp.cos(x)),
        1 / sp.sqrt(1 + x) - sp.sqrt(1 + x) / (1 + x),
        sp.exp(x + 2 * y) - sp.exp(x) * sp.exp(y) ** 2,
        (x**2 - y**2) / (x - y) - x - y,
        sp.sqrt(x**2 + 2 * x * y + y**2 - (2 * x * y + y**2)) - x,
    ],
)
def test_identities_are_proved(zero: sp.Expr) -> None:
    assert proofs.canonical(zero).is_zero


@pytest.mark.parametrize(
    "expression",
    [
        sp.sin(3 * x) - 3 * sp.sin(x) + 5 * sp.sin(x) ** 3,
        sp.sqrt(1 + x) / (x + sp.pi) + sp.cos(2 * x),
        sp.exp(-x) / (1 + sp.exp(x)) - sp.pi * x,
        sp.tan(x / 2) * sp.sin(x) - y,
        (1 + sp.sqrt(x)) ** 3 / sp.sqrt(x),
    ],
)
def test_canonical_form_keeps_the_value(expression: sp.Expr) -> None:
    quotient = proofs.canonical(expression)
    assert not quotient.is_zero
    assert proofs.nonzero_somewhere(quotient)
    at = {x: sp.Rational(7, 5), y: sp.Rational(3, 11)}
    with mpmath.workdps(40):
        assert abs(sp.N((quotient.numerator / quotient.denominator - expression).subs(at), 40)) < 1e-35


def test_dependent_roots_are_not_taken_for_a_difference() -> None:
    product = sp.Mul(sp.sqrt(1 + x), sp.sqrt(1 + y), evaluate=False) - sp.sqrt((1 + x) * (1 + y))
    quotient = proofs.canonical(product)
    assert quotient.is_zero or not proofs.nonzero_somewhere(quotient)


def test_digits_are_printed_only_if_known() -> None:
    with balls.precision():
        assert balls.significant(arb(2).sqrt()) == "1.41421356237"
        assert balls.rounded(arb("0.99385"), 3) == "0.994"
        with pytest.raises(ArithmeticError):
            balls.rounded(arb(2, "0.01"), 4)
        with pytest.raises(ArithmeticError):
            balls.sign(arb(0, 1))


def test_isolation_finds_every_zero() -> None:
    with balls.precision():
        zeros = balls.isolate(lambda t: t.sin(), arb(1), arb(20))
        assert [float(zero.mid()) for zero in zeros] == pytest.approx([k * float(mpmath.pi) for k in range(1, 7)])
        assert all(zero.overlaps(k * arb.pi()) for k, zero in enumerate(zeros, start=1))
        roots = balls.polynomial_zeros({0: arb(-6), 1: arb(11), 2: arb(-6), 3: arb(1)})
        assert [root.contains(k) for k, root in enumerate(roots, start=1)] == [True] * 3
