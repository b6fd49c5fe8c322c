"""Stops, bilinear springs, play, even powers and preloads: folds, states and onsets against certified ones, in u."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
import sympy as sp

from slowflow import derive
from slowflow.results import Remark
from tests.oracles.errors import U, error

CASES = json.loads((Path(__file__).parent / "data" / "closed.json").read_text())
EACH = 30
#: errors in u (1 + kappa), of phi in u (1 + kappa) of A times what it moves phi by
FOLD, STATE, ONSET, PHASE = 4.0, 4.0, 16.0, 4.0

u, a, b, c = sp.symbols("u a b c")
#: of the library, with the design that a case's parameters are
LIBRARY = {
    "stop": ("elastic_stop", lambda given: {"kappa": given["k"], "delta": given["gap"]}),
    "bilinear": ("bilinear", lambda given: {"kappa": given["k"], "delta": given["gap"]}),
    "play": ("dead_zone", lambda given: {"delta": given["gap"]}),
}
STATED = {
    "even": ([(u + a * u**2 + b * u**3, None)], {"a": {}, "b": {"above": 0}}),
    "preload": ([(c + u + b * u**3, None)], {"c": {"above": 0}, "b": {"above": 0}}),
}
COMPILED = [
    pytest.param(False, id="interpreted"),
    pytest.param(
        True,
        id="compiled",
        marks=pytest.mark.slow,
    ),
]


def mechanism(name, compiled):
    if name in LIBRARY:
        return derive.library(LIBRARY[name][0], compile=compiled)
    return derive.mechanism(f"{name}_closed", *STATED[name], compile=compiled)


def oscillators(name, compiled):
    """Those of a force with their cases."""
    made = mechanism(name, compiled)
    for case in CASES:
        if case["force"] == name:
            given = {key: value[1] for key, value in case["parameters"].items()}
            damping = {key: given.pop(key) for key in ("mu", "zeta")}
            design = LIBRARY[name][1](given) if name in LIBRARY else given
            yield made(**design, **damping), case["F_0"][1], case


def test_there_are_cases_of_each_force_and_all_have_folds():
    for name in (*LIBRARY, *STATED):
        cases = [case for case in CASES if case["force"] == name]
        assert len(cases) == EACH and all(len(case["folds"]) >= 2 for case in cases)


@pytest.mark.slow
@pytest.mark.parametrize("compiled", COMPILED)
@pytest.mark.parametrize("name", [*LIBRARY, *STATED])
@pytest.mark.part(3)
def test_folds_and_states_are_the_certified_ones_and_no_others(name, compiled):
    for one, F_0, case in oscillators(name, compiled):
        folds = one.saddle_nodes(F_0)
        assert Remark.UNDECIDED not in folds.remarks
        assert [fold.kind for fold in folds] == [fold["kind"] for fold in case["folds"]]
        for found, sure in zip(folds, case["folds"], strict=True):
            assert error(found.Omega, sure, "Omega") < FOLD
            assert error(found.A, sure, "A") < FOLD
        for at in case["amplitudes"]:
            found, sure = one.amplitudes(Omega=at["Omega"][1], F_0=F_0), at["steady"]
            assert Remark.UNDECIDED not in found.remarks
            assert found.stable.tolist() == [state["stable"] for state in sure]
            for A, phi, known in zip(found.A, found.phi, sure, strict=True):
                assert error(A, known, "A") < STATE
                kappa = known["condition"]["A"] + known["condition_kernel"]["A"]
                # of tan(phi) = I/R, of which R = A Omega^2 + h moves by A R_A with A
                moved = A * (at["Omega"][1] ** 2 + abs(one.model.averaged(A)[1])) / F_0
                assert phi == pytest.approx(float(known["phi"]), abs=PHASE * U * (1 + kappa) * (1 + moved))


@pytest.mark.parametrize("compiled", COMPILED)
@pytest.mark.parametrize(
    "name", ["bilinear", *(pytest.param(one, marks=pytest.mark.slow) for one in ("stop", "play", "even"))]
)
def test_onsets_are_the_certified_ones(name, compiled):
    for one, _, case in oscillators(name, compiled):
        found, sure = one.saddle_node_onset(), case["onset"]
        for quantity in ("F_SN", "Omega", "A"):
            assert error(getattr(found, quantity), sure, quantity) < ONSET
