"""Certified cases off the centre. Takes an oscillator and its case; AssertionError where an answer is another."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp

from slowflow import derive
from tests.oracles.errors import U, error

u, k, g, a, b = sp.symbols("u k g a b")
ABOVE = {"above": 0}
#: errors in u (1 + kappa): of folds, states, their phase, onsets; of B over A + |B|, by kappa of A
FOLD, STATE, PHASE, ONSET, MEAN = 4.0, 4.0, 20.0, 4.0, 1.0


def made(force: str) -> Any:
    """The mechanism of a polynomial with an even part, or of a force in two pieces that bends on one side."""
    if force == "even":
        return derive.mechanism("even", [(u + a * u**2 + b * u**3, None)], {"a": {}, "b": ABOVE}, odd=False)
    pieces = [(a * u, g), (a * u + k * (u - g), None)]
    return derive.mechanism("bends", pieces, {"a": ABOVE, "k": {}, "g": {}}, odd=False)


def _kappa(sure: Any) -> float:
    return sum(sure[which]["A"] for which in ("condition", "condition_kernel"))


def error_of_mean(found: Any, sure: Any) -> float:
    """Of B, over A + |B|."""
    return abs(found.B - float(sure["B"])) / (found.A + abs(found.B)) / (U * (1 + _kappa(sure)))


def check_folds_and_states(one: Any, case: Any, *, fold_A: float = FOLD, mean: float = MEAN) -> None:
    """All that there are, with their mean, and no others."""
    F_0 = case["F_0"][1]
    folds = one.saddle_nodes(F_0)
    assert [fold.kind for fold in folds] == [fold["kind"] for fold in case["folds"]]
    for found, sure in zip(folds, case["folds"], strict=True):
        assert error(found.Omega, sure, "Omega") < FOLD
        assert error(found.A, sure, "A") < fold_A
        assert error_of_mean(found, sure) < mean
    for at in case["amplitudes"]:
        states, known = one.amplitudes(Omega=at["Omega"][1], F_0=F_0), at["steady"]
        moving = [state for state in states if state.A > 0]  # beside a mass that friction holds
        assert [state.stable for state in moving] == [state["stable"] for state in known]
        for found, sure in zip(moving, known, strict=True):
            assert error(found.A, sure, "A") < STATE
            assert error_of_mean(found, sure) < mean
            assert found.phi == pytest.approx(float(sure["phi"]), abs=PHASE * U * (1 + _kappa(sure)))


def check_onset(one: Any, case: Any, *, mean: float = MEAN) -> None:
    """The lowest forcing that has a fold."""
    onset, sure = one.saddle_node_onset(), case["onset"]
    if sure is None:
        assert onset.F_SN is None or onset.F_SN > one.sticking_forcing + 0.15
        return
    for quantity in ("F_SN", "Omega", "A"):
        assert error(getattr(onset, quantity), sure, quantity) < ONSET
    assert error_of_mean(onset, sure) < mean
