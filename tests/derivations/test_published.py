"""In: the transcription `derivations.ledger.published`. Out: whether it is complete, consistent and evaluates alike.

Nothing here judges the paper: that is the ledger's work. No derivation is used.
"""

import ast
import inspect
import math
import re
from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import sympy

from derivations.ledger import published
from derivations.ledger.published import FORMULAS
from derivations.ledger.statements import Formula

SYMPY = SimpleNamespace(
    sin=sympy.sin, cos=sympy.cos, sqrt=sympy.sqrt, arccos=sympy.acos, exp=sympy.exp, sign=sympy.sign, pi=sympy.pi
)

# Multiples of 2^-7 within every function's domain, all different from 0 and 1, so that doubles hold them exactly.
SAMPLE = {name: Fraction(int(numerator), 128) for name, numerator in re.findall(r"(\w+)=(\S+)", """
    A=75 A_c=61 A_dot=-19 Delta_h=21 F=33 F_0=67 F_0_bar=9 F_c=29 F_k=-37 F_k_bar=-7 F_k_u=17 F_k_x=39 G=27 H_i=41
    L=261 Omega=115 Phi_1=111 Phi_2=107 S=135 U=145 V=155 alpha=63 beta=353 c=53 dH_i_dA=87 delta_h=11
    determinant=31 eigenvalue=23 epsilon=3 f_k=43 gamma=265 k_h=519 k_v=257 lam=384 m=133 mu=5 mu_bar=2 nu_1=640
    nu_2=896 omega=59 omega_n=149 p=91 phi=-71 phi_dot=47 psi=97 psi_0=103 q=-501 r=259 sigma=-25 t=227 tau=173
    trace=-13 u=35 u_cr=51 u_ddot=-55 u_dot=45 x=57 x_ddot=-65 x_dot=49 zeta=7 zeta_bar=4
""")}  # fmt: skip


def label(formula: Formula) -> str:
    return f"{formula.where} {formula.quantity} {formula.reading}".strip()


def arguments(formula: Formula) -> list[str]:
    return [name for name in inspect.signature(formula.function).parameters if name != "xp"]


def flat(value: Any) -> Iterator[Any]:
    if isinstance(value, tuple):
        for entry in value:
            yield from flat(entry)
    else:
        yield value


NUMERIC = [f for f in FORMULAS if not f.quantity.startswith("resultant")]


def source_tree() -> ast.Module:
    return ast.parse(Path(inspect.getfile(published)).read_text(encoding="utf-8"))


def test_every_numbered_equation_is_there_in_order() -> None:
    numbered = [f.where for f in FORMULAS if re.fullmatch(r"\(A?\d+\)", f.where)]
    expected = [f"({i})" for i in range(1, 39)] + ["(A1)", "(A2)"]
    assert list(dict.fromkeys(numbered)) == expected
    assert numbered == sorted(numbered, key=expected.index)


def test_entries_are_told_apart_and_readings_come_in_groups() -> None:
    assert len({(f.where, f.quantity, f.reading) for f in FORMULAS}) == len(FORMULAS)
    assert len({f.function for f in FORMULAS}) == len(FORMULAS)
    for formula in FORMULAS:
        group = [f for f in FORMULAS if (f.where, f.quantity) == (formula.where, formula.quantity)]
        assert (len(group) > 1) == bool(formula.reading), label(formula)


@pytest.mark.parametrize("formula", FORMULAS, ids=label)
def test_xp_comes_last(formula: Formula) -> None:
    *_, last = inspect.signature(formula.function).parameters.values()
    assert last.name == "xp"
    assert last.default is np


@pytest.mark.parametrize("formula", NUMERIC, ids=label)
def test_numpy_and_sympy_evaluate_the_same(formula: Formula) -> None:
    exact = {name: sympy.Rational(SAMPLE[name]) for name in arguments(formula)}
    floats = {name: float(value) for name, value in exact.items()}
    expected = [sympy.N(entry, 30) for entry in flat(formula.function(**exact, xp=SYMPY))]
    values = list(flat(formula.function(**floats)))
    assert len(values) == len(expected)
    for value, reference in zip(values, expected, strict=True):
        assert math.isfinite(value)
        # Inputs are exact, so what is left is the rounding of a few dozen operations on numbers of order ten.
        assert abs(sympy.Float(float(value), 30) - reference) <= 2e-14 * max(1, abs(reference))


@pytest.mark.parametrize("formula", [f for f in NUMERIC if arguments(f)], ids=label)
def test_arrays_broadcast(formula: Formula) -> None:
    first, *rest = arguments(formula)
    fixed = {name: float(SAMPLE[name]) for name in rest}
    points = float(SAMPLE[first]) * np.array([[1.0], [1.0]])
    for array, scalar in zip(
        flat(formula.function(**{first: points}, **fixed)),
        flat(formula.function(**{first: points[0, 0]}, **fixed)),
        strict=True,
    ):
        assert np.shape(array) in {(2, 1), ()}
        np.testing.assert_array_max_ulp(np.asarray(array, float), np.broadcast_to(float(scalar), np.shape(array)), 8)


def test_literals_are_exact() -> None:
    assert not [n for n in ast.walk(source_tree()) if isinstance(n, ast.Constant) and isinstance(n.value, float)]
    for node in ast.walk(source_tree()):
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div):
            sides = (node.left, node.right)
            assert not all(isinstance(s, ast.Constant) for s in sides), f"inexact quotient in line {node.lineno}"


def test_module_stands_alone() -> None:
    imported: set[str] = set()
    for node in ast.walk(source_tree()):
        if isinstance(node, ast.Import):
            imported |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            imported.add("." * node.level + (node.module or ""))
    assert imported == {"dataclasses", "fractions", "numpy", "pathlib", "tomllib", ".statements"}


def test_namespace_is_small() -> None:
    used = {
        node.attr
        for node in ast.walk(source_tree())
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "xp"
    }
    assert used == set(vars(SYMPY))


def test_table_1_is_exact_and_follows_its_reading() -> None:
    assert set(published.TABLE_1) == {"lam", "r", "delta_h", "mu", "zeta"}
    assert all(isinstance(value, Fraction) for value in published.TABLE_1.values())
    assert published.TABLE_1["delta_h"] == published.delta_h_table_inverse(published.TABLE_1["r"])
    for name in ("lam", "r", "mu", "zeta"):
        (number,) = (n for n in published.NUMBERS if n.id == f"table_1_{name}")
        assert Fraction(number.printed) == published.TABLE_1[name]


def test_table_2_has_the_digits_that_are_printed() -> None:
    for row in published.TABLE_2:
        for column, entry in vars(row).items():
            if entry not in {"-", "F_SN", "F_cr", "u_cr"}:
                assert Decimal(entry).as_tuple().exponent == (-3 if column == "F_0" else -4)
    assert len(published.TABLE_2) == 5


def test_numbers_parse_unless_symbolic() -> None:
    symbolic = {"4/π", "π/2", "π/4", "πμ/4", "6 r^-1", "1/6 r", "F_SN", "F_cr", "u_cr", "-"}
    for number in published.NUMBERS:
        if number.printed not in symbolic:
            Fraction(number.printed)
    assert symbolic <= {number.printed for number in published.NUMBERS}


def test_numbers_quoted_twice_agree() -> None:
    numbers = {n.id: n.printed for n in published.NUMBERS}
    sentences = {c.id: c.sentence for c in published.CLAIMS}
    assert numbers["Omega_cr"] == numbers["table_2_row_3_jump_down_Omega"]
    assert numbers["u_cr"] in sentences["example_u_cr_F_cr"]
    assert numbers["F_cr"] in sentences["example_u_cr_F_cr"]
    assert numbers["Omega_cr"] in sentences["example_Omega_cr"]
    assert numbers["F_SN"] in sentences["F_SN_prevents"]
    assert numbers["Omega_SN"] in sentences["inflection_point"]
    assert numbers["A_SN"] in sentences["inflection_point"]


@pytest.mark.parametrize("entries", [published.NUMBERS, published.CLAIMS], ids=["numbers", "claims"])
def test_ids_are_unique_and_every_entry_is_quoted(entries: tuple[Any, ...]) -> None:
    assert len({entry.id for entry in entries}) == len(entries)
    assert all(re.fullmatch(r"[A-Za-z0-9_]+", entry.id) for entry in entries)
    assert all(entry.where and entry.sentence for entry in entries)
