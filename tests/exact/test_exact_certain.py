"""Motions and folds of the equation of motion against 40 digits that were found by other means, and their residuals."""

import pytest

from slowflow import Duffing, Isolator
from slowflow.exact import exact_response, steady_state
from tests.files import stored
from tests.oracles.exact_cases import table_1

CASES = stored("exact_motions")


def system_of(case):
    oscillator = (Duffing if case["force"] == "duffing" else Isolator)(**case["numbers"])
    return oscillator.equation_of_motion(None if case["force"] == "duffing" else case["force"])


@pytest.mark.parametrize("case", [case for case in CASES if not case["fold"]], ids=str)
def test_a_motion_has_the_amplitude_of_forty_digits(case):
    found = steady_state(
        system_of(case), (float(case["A"]), -float(case["theta"])), Omega=case["Omega"], F_0=case["F_0"]
    )
    assert abs(found.A - float(case["A"])) <= 4e-15
    assert found.residual <= 1e-14


@pytest.mark.parametrize("case", [case for case in CASES if case["fold"]], ids=str)
def test_a_fold_has_the_frequency_of_forty_digits(case):
    """A fold's A is a maximum's place: it is known to the root of what Omega is known to, times its own steepness."""
    curve = exact_response(system_of(case), case["F_0"], Omega=(0.5, 1.5))
    fold = min(curve.folds, key=lambda fold: abs(fold.Omega - float(case["Omega"])))
    assert abs(fold.Omega - float(case["Omega"])) <= 1e-14
    assert abs(fold.A - float(case["A"])) <= 1e-10


@pytest.mark.parametrize("exact", [False, True])
def test_residuals_along_a_curve_stay_within_rounding(exact):
    """But where the curve touches u_cr: there a force that jumps is not Lipschitz."""
    curve = exact_response(table_1(exact), 0.04)
    for i, point in enumerate(curve.states):
        if point.role not in ("border", "corner"):
            assert curve.steady_state(i).residual <= 1e-14
