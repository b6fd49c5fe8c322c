"""Appendix A's smoothed equation tends to the exact motion as the smoothing sharpens."""

import pytest

from examples.paper.smoothed import direct_integration
from slowflow.exact import EquationOfMotion, linear, steady_state
from tests.oracles.exact_cases import table_1


@pytest.mark.slow
def test_bias_falls_with_the_smoothing():
    """The amplitude's error is of first order in 1/nu, and the paper's nu leaves less than 2e-3 of it."""
    system = EquationOfMotion(linear(), 0.3, 0.1)
    exact = steady_state(system, Omega=0.8, F_0=1.0).A
    bias = [
        abs(direct_integration(system, 0.8, 1.0, nu=nu, turns=20, kept=2, rtol=1e-6, atol=1e-9).A / exact - 1)
        for nu in (10, 20, 40)
    ]
    assert bias[0] > bias[1] > bias[2]
    assert bias[2] < 0.6 * bias[1] < 0.6 * 0.6 * bias[0]


@pytest.mark.slow
def test_as_published():
    """nu = 1000 and the solver's default tolerances, untruncated force: fewer turns, the same reading."""
    system = table_1(exact=True)
    exact = steady_state(system, Omega=0.95, F_0=0.04).A
    found = direct_integration(system, 0.95, 0.04, turns=50, kept=5)
    assert abs(found.A / exact - 1) <= 5e-3
    assert found.A_sampled <= found.A
    assert found.spread <= 1e-3


def test_errors_in_words():
    system = table_1(exact=True)
    with pytest.raises(ValueError, match="kept"):
        direct_integration(system, 0.95, 0.04, turns=10, kept=20)
    with pytest.raises(ValueError, match="nu"):
        direct_integration(system, 0.95, 0.04, nu=0.0)
