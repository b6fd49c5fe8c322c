"""A mass that friction holds is a steady state: against the equation of motion from switch to switch."""

from __future__ import annotations

import math

import numpy as np
import pytest

from slowflow import Duffing, Isolator
from tests.oracles import by_time

MOUNT = Isolator.physical(
    m=25, k_v=9000, k_h=4000, n=3, L=0.08, preload=0.006, friction=3.6, zeta=0.03, excitation="base"
)


@pytest.mark.parametrize("excitation", ["force", "base", "unbalance"])
def test_friction_holds_the_mass_up_to_the_break_loose_force(excitation):
    mu, zeta, alpha, Omega = 0.01, 0.05, 1.0, 0.8
    iso = Duffing(alpha, 0.0, mu=mu, zeta=zeta, excitation=excitation)
    for ratio in (0.5, 0.999, 1.02, 1.2, 1.5):
        F_0 = ratio * mu / (Omega**2 if excitation != "force" else 1.0)
        push, span = lambda tau, force=ratio * mu: force * math.cos(Omega * tau), (0.0, 6 * math.pi / Omega)
        ways = by_time.stretches(iso, lambda u: alpha * u, push, span, (0.0, 0.0))
        slip = max(np.abs(one.u).max() for one in ways)
        assert (slip == 0) == (ratio < 1)
        found = iso.steady_state(Omega=Omega, F_0=F_0)
        assert (found.A == 0) == (slip == 0) and found.stable
        sweep = iso.sweep(Omega=[Omega, Omega * 0.999], F_0=F_0)
        assert sweep.A[0] == found.A and sweep.settled.all()
        # averaging has it at rest up to 4 mu/pi, and says so where it is not
        states = iso.amplitudes(Omega=Omega, F_0=F_0)
        assert (states.A[0] == 0) == (ratio < 4 / math.pi)
        assert ("in the equation of motion" in states.message) == (1 < ratio < 4 / math.pi)
        if ratio < 1:
            assert states.transmissibility.tolist() == [1.0] and states.stable.all()
            assert np.array(found.transmitted()[:2]) == pytest.approx([1.0, 1.0], rel=1e-12)
            assert states.measure().A.tolist() == [0.0] and states.measure().error.tolist() == [0.0]


def test_a_mass_that_friction_holds_rides_with_the_floor():
    """At 1 Hz and 1 mm the floor's acceleration asks for m (2 pi f)^2 Y = 0.99 N of the 3.6 N that friction has."""
    states = MOUNT.amplitudes(f=[4.0, 1.0], Y=0.001)
    assert states.f.tolist() == [4.0, 1.0] and states.A[1] == 0 and states.stable.all()
    assert states.transmissibility_dB[1] == 0 and states.transmissibility_dB[0] > 0
    assert "no steady state" not in states.message
    assert "the inertia force does not exceed 4 friction/pi = 4.5837 N" in states.message
    found = MOUNT.steady_state(f=1.0, Y=0.001)
    assert found.A == 0 and found.answer.transmitted("absolute").first == pytest.approx(1.0, rel=1e-12)
    rows = MOUNT.spectrum(f=[1.0, 4.0], Y=[0.001, 0.001])
    assert rows.transmissibility_dB[0] == 0 and rows.A[0] == 0 and rows.sticks.tolist() == [True, False]
    slopes = states.gradient().slopes[1]
    assert not slopes.any()
    curve = MOUNT.exact_response(Y=0.001, f=(0.5, 1.0))
    assert not curve.A.size and "the inertia force 0.98696" in curve.message and "N at f = 1 Hz" in curve.message
    averaged = MOUNT.frequency_response(Y=0.001, f=(0.5, 1.0))
    assert not averaged.A.size and "sticks up to f = 2.155 Hz" in averaged.message
    assert "no steady state" not in averaged.message


def test_under_a_load_the_mass_rests_where_the_spring_carries_it():
    """f(u) = u + 0.3 u^3 = 0.2 at u = 0.1977, by Cardano."""
    iso = Duffing(1.0, 0.3, mu=0.02, zeta=0.05, load=0.2)
    half = 0.2 / 0.3 / 2
    root = math.sqrt(half**2 + (1 / 0.3 / 3) ** 3)
    u = float(np.cbrt(half + root) + np.cbrt(half - root))
    states = iso.amplitudes(Omega=[0.7, 0.9], F_0=0.01)
    assert states.A.tolist() == [0.0, 0.0] and states.B == pytest.approx([u, u], rel=1e-12)
    assert states.transmissibility.tolist() == [1.0, 1.0] and states.stable.all()
    found = iso.steady_state(Omega=0.7, F_0=0.01)
    assert found.A == pytest.approx(u, rel=1e-12) and found.harmonics(1)[1] == pytest.approx(0.0, abs=1e-13)


def test_a_softly_thrown_mass_comes_to_rest_elsewhere():
    found = Duffing(1.0, 0.0, mu=0.05, zeta=0.05).steady_state(Omega=0.8, F_0=0.01, u_0=0.5)
    assert 0 < found.A <= 0.05 + 0.01 and found.stops == 1


@pytest.mark.parametrize("excitation", ["force", "base"])
@pytest.mark.parametrize("load", [0.0, 0.1])
def test_curve_of_a_held_mass_has_no_point_and_says_why(excitation, load):
    """Up to Omega = 0.2 a base of 0.1 asks for a force of 0.004, mu being 0.02."""
    iso = Duffing(1.0, 0.3, mu=0.02, zeta=0.02, load=load, excitation=excitation)
    F_0 = 0.01 if excitation == "force" else 0.1
    curves = [iso.frequency_response(F_0, Omega=(0.05, 0.2)), iso.exact_response(F_0, Omega=(0.05, 0.2))]
    curves += [iso.second_approximation.frequency_response(F_0, Omega=(0.05, 0.2))] if load == 0 else []
    for curve in curves:
        assert len(curve) == 0 and "does not exceed" in curve.message and "no steady state" not in curve.message
    with pytest.raises(ArithmeticError, match=r"no peak, as there is no motion: .* friction holds the mass"):
        _ = curves[1].peak
    assert curves[1].transmitted().first.size == 0


def test_curve_begun_in_static_friction_has_no_point():
    """At F_0 = 0.03 the mass would slip under kinetic friction 0.02 but sticks under static friction 0.05."""
    iso = Duffing(1.0, 0.3, mu=0.02, mu_s=0.05, zeta=0.02)
    sticking, moving = iso.steady_state(Omega=0.9, F_0=0.03), iso.steady_state(Omega=0.9, F_0=0.03, A=0.3)
    for start in (None, sticking):
        curve = iso.exact_response(0.03, Omega=(0.8, 1.2), start=start)
        assert len(curve) == 0 and "does not exceed mu_s = 0.05" in curve.message
    curve_of_moving = iso.exact_response(0.03, Omega=(0.85, 0.95), start=moving)
    assert np.interp(0.9, curve_of_moving.Omega, curve_of_moving.A) == pytest.approx(moving.A, rel=1e-3)


@pytest.mark.parametrize(("excitation", "F_0", "low"), [("force", 0.02, 0.79), ("base", 0.03, 0.6)])
def test_second_approximation_has_the_masses_at_rest(excitation, F_0, low):
    """At rest there are no harmonics: the transmissibility is 1."""
    Omega = np.array([0.9, low, 1.1])
    static = 0
    for one in (0.01, 0.03):
        iso = Duffing(1.0, 0.3, mu=one, zeta=0.05, excitation=excitation)
        first = iso.amplitudes(Omega=Omega, F_0=F_0)
        found = iso.second_approximation.amplitudes(Omega=Omega, F_0=F_0)
        assert found.Omega.tolist() == first.Omega.tolist() and (found.A == 0).tolist() == (first.A == 0).tolist()
        rest = found.A == 0
        static += rest.sum()
        assert not found.A_1[rest].any() and found.stable[rest].all() and (found.transmissibility[rest] == 1).all()
        assert np.array_equal(found.phi[rest], first.phi[rest])
        assert np.array([column[rest] for column in found.transmitted()]).T == pytest.approx(
            np.tile([1.0, 1.0, math.sqrt(0.5)], (rest.sum(), 1)), rel=1e-15
        )
    assert static >= 3
