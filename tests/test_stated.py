"""Forces averaged by sums against certified folds, states and onsets: none is left out, none invented, errors in u."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
import sympy as sp

from slowflow import derive
from slowflow.results import Remark
from tests.oracles.errors import U, error

CASES = json.loads((Path(__file__).parent / "data" / "stated.json").read_text())
#: errors in u (1 + kappa), of phi in u (1 + kappa) of A. kappa counts one unit in an average, which is good to
#: 4 u (1 + its own condition): where two derivatives have to vanish, that is felt
FOLD, STATE, ONSET, PHASE = 4.0, 4.0, 16.0, 50.0

u, k, c, p, gap = sp.symbols("u k c p gap")
#: pieces for u > 0 and their numbers
FORCES = {
    "wave": ([(u + k * sp.sin(c * u), None)], "kc"),
    "saturating": ([(c * u + sp.tanh(k * u), None)], "ck"),
    "exponential": ([(k * (sp.exp(c * u) - 1), None)], "kc"),
    "oblique": ([(u + 2 * k * u * (1 - c / sp.sqrt(c**2 + u**2)), None)], "kc"),
    "magnets": ([(u + k * (1 / (c - u) ** 2 - 1 / (c + u) ** 2), None)], "kc"),
    "power": ([(u + k * u**p, None)], "kp"),
    "root": ([(u + k * u**p, None)], "kp"),
    "preload": ([(c + k * (sp.exp(u) - 1), None)], "ck"),
    "preload_power": ([(c + u + k * u**p, None)], "ckp"),
    "soft_stop": ([(u, gap), (u + c * sp.tanh(k * (u - gap)), None)], ("c", "k", "gap")),
    "hard_stop": ([(u, gap), (u + k * (sp.exp(c * (u - gap)) - 1), None)], ("k", "c", "gap")),
    "root_stop": ([(u, gap), (u + k * (sp.sqrt(1 + c * (u - gap)) - 1), None)], ("k", "c", "gap")),
    "contact": ([(u, gap), (u + k * (u - gap) ** 1.5, None)], ("k", "gap")),
    "preloaded_stop": (
        [(c + u + k * sp.sin(u), gap), (c + u + k * sp.sin(u) + 3 * sp.tanh(u - gap), None)],
        ("c", "k", "gap"),
    ),
}
#: an exponential leaves the doubles before it is known to hold every motion
REACH = {name: {"reach": 8.0} for name in ("exponential", "preload", "hard_stop")}
#: magnets are 4 to 5 apart
REACH["magnets"] = {"reach": 3.9}
#: the force jumps at the centre
PRELOADED = ("preload", "preload_power", "preloaded_stop")
#: smooth behind a gap
STOPS = {"soft_stop": 10, "hard_stop": 7, "root_stop": 13}
#: solved on NumPy and compiled by the fast tests
FAST = {False: "root"}


@pytest.fixture(scope="module")
def derived():
    """A mechanism, derived once."""
    made = {}

    def get(name, compiled):
        if (name, compiled) not in made:
            pieces, numbers = FORCES[name]
            given = {number: {"above": 0} for number in numbers}
            called = f"{name}_compiled" if compiled else name
            made[name, compiled] = derive.mechanism(called, pieces, given, compile=compiled, **REACH.get(name, {}))
        return made[name, compiled]

    return get


def test_there_are_cases_of_each_force_with_folds_on_both_sides_of_an_edge():
    each = {name: sum(case["force"] == name for case in CASES) for name in FORCES}
    assert each == {**dict.fromkeys(FORCES, 3), "magnets": 12, "contact": 30, **dict.fromkeys(PRELOADED, 10), **STOPS}
    # behind a gap, and on one piece
    assert sum(STOPS.values()) == sum(each[name] for name in set(FORCES) - {"contact", *PRELOADED, *STOPS}) == 30
    assert sum(len(case["folds"]) for case in CASES) > 40
    assert sum(case["onset"] is not None for case in CASES) >= 15


def ways(question):
    """Each force on both solvers, as parameters."""
    marks = {True: [], False: [pytest.mark.slow]}
    return [
        pytest.param(
            name,
            compiled,
            id=f"{name}-{'compiled' if compiled else 'numpy'}",
            marks=marks[FAST.get(compiled) == name],
        )
        for compiled in (False, True)
        for name in FORCES
        if question == "states" or any(case["onset"] for case in CASES if case["force"] == name)
    ]


def oscillators(derived, name, compiled):
    """Those of a force with their cases."""
    for case in CASES:
        if case["force"] == name:
            numbers = {key: value[1] for key, value in case["parameters"].items()}
            yield derived(name, compiled)(**numbers), case["F_0"][1], case


@pytest.mark.parametrize(("name", "compiled"), ways("states"))
@pytest.mark.part(4)
def test_folds_and_states_are_the_certified_ones_and_no_others(derived, name, compiled):
    for one, F_0, case in oscillators(derived, name, compiled):
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
                assert phi == pytest.approx(float(known["phi"]), abs=PHASE * U * (1 + kappa))


@pytest.mark.parametrize(("name", "compiled"), ways("onset"))
@pytest.mark.part(4)
def test_onsets_are_the_certified_ones(derived, name, compiled):
    for one, _, case in oscillators(derived, name, compiled):
        if case["onset"] is not None:
            found, sure = one.saddle_node_onset(), case["onset"]
            for quantity in ("F_SN", "Omega", "A"):
                assert error(getattr(found, quantity), sure, quantity) < ONSET
