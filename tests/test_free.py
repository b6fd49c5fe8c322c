"""A mass that no spring holds, f(u) = 0: its response against the positive root of (24), a polynomial in A."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

from slowflow import Duffing
from slowflow.results import Remark

U = 2.0**-53
LAWS = {
    "viscous": {"zeta": 0.05},
    "structural": {"eta": 0.05},
    "quadratic": {"c_2": 0.05},
    "all": {"zeta": 0.02, "eta": 0.01, "c_2": 0.3, "mu": 0.01},
    "friction": {"c_2": 0.05, "mu": 0.01},
}
OMEGA = [0.003, 0.2, 0.5, 1.0, 3.0]
F_0 = 0.05


def state(Omega, mu=0.0, zeta=0.0, eta=0.0, c_2=0.0):
    """The one positive root: all coefficients but the constant are positive."""
    with mp.workdps(40):
        Omega, mu, zeta, eta, c_2, F = map(mp.mpf, (Omega, mu, zeta, eta, c_2, F_0))
        m, linear, square = 4 * mu / mp.pi, 2 * zeta * Omega + eta, 8 * c_2 / (3 * mp.pi) * Omega**2
        powers = [square**2, 2 * linear * square, Omega**4 + linear**2 + 2 * m * square, 2 * m * linear, m**2 - F**2]
        first = next(i for i, one in enumerate(powers) if one != 0)
        roots = mp.polyroots(powers[first:], maxsteps=500, extraprec=300)
        (found,) = (root.real for root in roots if abs(root.imag) < 1e-30 * abs(root) and root.real > 0)
        return found


@pytest.mark.both_backends
@pytest.mark.parametrize("law", LAWS)
def test_states_are_the_roots(law):
    free = Duffing(0, 0, **LAWS[law])
    found = free.amplitudes(Omega=OMEGA, F_0=F_0)
    assert not found.message and found.stable.all() and Remark.UNDECIDED not in found.remarks
    for Omega, A in zip(OMEGA, found.A, strict=True):
        assert abs(float(A / state(Omega, **LAWS[law])) - 1) < 16 * U
    assert [float(free.amplitudes(Omega=one, F_0=F_0).A[0]) for one in OMEGA] == pytest.approx(found.A, rel=4 * U)


@pytest.mark.slow
@pytest.mark.both_backends
@pytest.mark.parametrize("law", LAWS)
def test_the_curve_begins_where_the_window_does_or_says_where_it_is_cut(law):
    free = Duffing(0, 0, **LAWS[law])
    curve = free.frequency_response(F_0, samples=50, Omega=(0.01, 2.0))
    assert not curve.message and curve.Omega.min() == 0.01
    for Omega, A in zip(curve.Omega, curve.A, strict=True):
        assert float(A / state(Omega, **LAWS[law])) == pytest.approx(1, rel=1e-14)
    whole = free.frequency_response(F_0, samples=50)
    if "eta" in LAWS[law]:
        assert whole.Omega.min() == 0 and not whole.message
        m = 4 * LAWS[law].get("mu", 0) / np.pi
        assert whole.A.max() == pytest.approx((F_0 - m) / LAWS[law]["eta"], rel=1e-14)
    else:
        assert "unbounded as Omega tends to 0, where no spring holds the mass: cut at A = 5" in whole.message
        assert whole.A.max() == 5 and Remark.CUT in whole.remarks


@pytest.mark.both_backends
@pytest.mark.parametrize("law", LAWS)
def test_its_amplitude_only_falls_with_the_frequency(law):
    free = Duffing(0, 0, **LAWS[law])
    peak = free.peak(F_0)
    if "eta" in LAWS[law]:
        assert peak.Omega == 0 and peak.A == free.frequency_response(F_0).A.max()
    else:
        assert peak.A is None and "unbounded as Omega tends to 0" in peak.message
    assert free.isolation(F_0).Omega == 0
    assert free.closes(F_0) == ("eta" in LAWS[law])
    assert len(free.saddle_nodes(F_0)) == 0 and free.saddle_node_onset().F_SN is None


def test_on_a_shaking_base_by_quadratic_damping_alone_it_has_one_amplitude_at_all_frequencies():
    """A^2 + (8 c_2/(3 pi) A^2)^2 = F_0^2."""
    free = Duffing(0, 0, c_2=0.05, excitation="base")
    d = 8 * 0.05 / (3 * np.pi)
    A = np.sqrt((np.sqrt(1 + 4 * d**2 * F_0**2) - 1) / (2 * d**2))
    for ask in (free.frequency_response, free.peak, lambda F_0: free.amplitudes(Omega=1.0, F_0=F_0)):
        with pytest.raises(ArithmeticError, match=r"no response curve: A = 0\.0499") as told:
            ask(F_0)
        assert float(str(told.value).split("A = ")[1].split()[0]) == pytest.approx(A, rel=1e-9)


def test_play_with_structural_damping_alone_has_a_static_state_within_the_play():
    """It was undecided: next to Omega = 0 F is flat to the fourth power where there is no spring."""
    from slowflow import derive

    play = derive.library("dead_zone")(delta=2.0, mu=0.0, zeta=0.0, eta=0.05)
    found = play.amplitudes(Omega=[0.5, 1.0], F_0=F_0)
    assert Remark.UNDECIDED not in found.remarks
    within = Duffing(0, 0, eta=0.05).amplitudes(Omega=[0.5, 1.0], F_0=F_0)
    np.testing.assert_allclose(found.A, within.A, rtol=1e-14)
    assert play.peak(F_0).A == pytest.approx(F_0 / 0.05, rel=1e-14)
