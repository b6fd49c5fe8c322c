"""In: what others published, and every single mutant of it. Out: whether the judgements are current, and bite."""

from __future__ import annotations

import ast
import copy
import importlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

from derivations.ledger import against, balls
from derivations.ledger.against import marino_cicirello_2020
from derivations.ledger.against.__main__ import PAGE, page
from derivations.ledger.literature import Publication, all_publications
from derivations.symbols import F_0, Omega, mu
from slowflow import Duffing, Isolator
from slowflow.sizing import fit
from tests.derivations.test_ledger import change, operands
from tests.sampling import part

#: mutants of a formula beyond which a push makes a part of them
MANY = 40
PUBLICATIONS = all_publications()


@pytest.mark.slow
def test_the_page_is_what_the_judgements_are_now() -> None:
    assert page() == PAGE.read_text(encoding="utf-8"), "python -m derivations.ledger.against writes it anew"


@pytest.mark.parametrize("publication", PUBLICATIONS, ids=lambda on: on.name)
def test_what_is_published_comes_from_nothing_that_is_derived(publication: Publication) -> None:
    tree = ast.parse(Path(publication.module.__file__).read_text(encoding="utf-8"))
    imports = [node for node in ast.walk(tree) if isinstance(node, ast.Import | ast.ImportFrom)]
    assert (
        {node.module for node in imports} <= {"typing"} and publication.module.CITATION and publication.module.READ_IN
    )


@pytest.mark.slow
@pytest.mark.parametrize("publication", [on for on in PUBLICATIONS if on.formulas], ids=lambda on: on.name)
def test_every_mutant_of_a_formula_is_judged_otherwise(publication: Publication) -> None:
    tree = ast.parse(Path(publication.module.__file__).read_text(encoding="utf-8"))
    functions = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
    assert set(functions) == {formula.name for formula in publication.formulas}
    seen = 0
    with balls.precision():
        judges = importlib.import_module(f"derivations.ledger.against.{publication.name}").formulas(against.Derived())
        for name, original in functions.items():
            published = judges[name](getattr(publication.module, name))
            found = len(operands(original))
            for k in part(range(found), 1 + found // MANY, name):
                mutant = copy.deepcopy(original)
                change(operands(mutant)[k])
                namespace: dict[str, Any] = dict(vars(publication.module))
                exec(compile(ast.Module([mutant], []), "mutant", "exec"), namespace)
                seen += 1
                try:
                    judged = judges[name](namespace[name])
                except (ArithmeticError, ValueError):
                    continue  # not even an approximation
                after, before = ((one.verdict, one.difference, one.evidence) for one in (judged, published))
                assert after != before, ast.unparse(mutant.body[-1])
    assert seen


@pytest.mark.slow
def test_measured_phases_are_exact_ones_within_scatter() -> None:
    rig = np.genfromtxt(marino_cicirello_2020.MEASURED, delimiter=",", names=True, skip_header=3)
    exact, averaged, _ = (
        sp.lambdify((F_0, mu, Omega), lag)(1.0, rig["beta"], rig["Omega"])
        for lag in marino_cicirello_2020.lags(against.Derived())
    )
    for row, of_exact, of_averaged in zip(rig, exact, averaged, strict=True):
        frame = Duffing(alpha=1, beta=0, mu=row["beta"])
        motion = frame.steady_state(Omega=row["Omega"], F_0=1)
        assert motion.stops == 0 and -np.angle(motion.harmonics(1)[1]) == pytest.approx(of_exact, rel=1e-9)
        assert -frame.amplitudes(Omega=row["Omega"], F_0=1).phi[0] == pytest.approx(of_averaged, rel=1e-12)
    off = np.degrees([exact, averaged]) - rig["phase_deg"]
    assert np.sqrt(np.mean(off**2, axis=1)) == pytest.approx([2.591, 2.645], abs=1e-3)
    assert np.abs(off).max(axis=1) == pytest.approx([5.081, 5.476], abs=1e-3)


@pytest.mark.slow
def test_nine_measured_phases_tell_friction() -> None:
    rig = np.genfromtxt(marino_cicirello_2020.MEASURED, delimiter=",", names=True, skip_header=3)
    frame = Isolator.physical(m=1, k_v=400, k_h=1, L=1, preload=0, friction=0.5)
    for of in rig.reshape(4, 9):
        row = fit(frame, F=2.5, f=of["Omega"] * 10 / np.pi, phi=-np.radians(of["phase_deg"]), free=["friction"])[0]
        assert row.low < of["friction_N"][0] < row.high and row.high - row.low < 0.15


@pytest.mark.parametrize("zeta", [0.001, 0.03, 0.4])
def test_onset_of_a_cubic_spring_has_its_closed_form(zeta: float) -> None:
    """Omega^2 - 1 = 2 sqrt(3) zeta Omega, A^2 = 8 (Omega^2 - 1)/(9 beta), F_SN^2 = 32 (Omega^2 - 1)^3/(81 beta)."""
    beta = 2.5
    Omega = np.sqrt(3) * zeta + np.sqrt(1 + 3 * zeta**2)
    onset = Duffing(alpha=1, beta=beta, mu=0, zeta=zeta).saddle_node_onset()
    over = 2 * np.sqrt(3) * zeta * Omega
    assert onset.Omega == pytest.approx(Omega, rel=1e-14)
    assert onset.A == pytest.approx(np.sqrt(8 * over / (9 * beta)), rel=1e-14)
    assert onset.F_SN == pytest.approx(np.sqrt(32 * over**3 / (81 * beta)), rel=1e-14)
