"""States of averaging that no exact motion sustains: `Remark.UNSUSTAINED`, against exact motions and energy."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import quad

from slowflow import Duffing, derive
from slowflow.answers.results import Remark
from slowflow.averaged.sustained import free_motions, unsustained
from slowflow.core.model import SlowFlow
from slowflow.exact import shooting
from slowflow.oscillators.isolator import DUFFING

SOFTENING = Duffing(1.0, -0.1, zeta=0.022)


def least_force(a, zeta, alpha=1.0, beta=-0.1):
    """Below it no motion like the free one of amplitude a is sustained: 2 zeta J/(pi A_1), by adaptive quadrature."""

    def speed(theta):  # u' over cos(theta), u = a sin(theta)
        return np.sqrt(alpha + beta * a * a * (1 + np.sin(theta) ** 2) / 2)

    quarter = quad(lambda theta: 1 / speed(theta), 0, np.pi / 2, epsabs=0, epsrel=1e-10)[0]
    J = 4 * quad(lambda theta: a * a * np.cos(theta) ** 2 * speed(theta), 0, np.pi / 2, epsabs=0, epsrel=1e-10)[0]

    def first(theta):
        tau = quad(lambda one: 1 / speed(one), 0, theta)[0]
        return a * np.sin(theta) * np.sin(np.pi / 2 * tau / quarter) / speed(theta)

    A_1 = 2 * quad(first, 0, np.pi / 2, epsrel=1e-8)[0] / quarter
    return np.pi / 2 / quarter, J, A_1, 2 * zeta * J / (np.pi * A_1)


def test_sustained_free_motions_are_those_of_adaptive_quadrature():
    for a in (0.5, 2.0, 2.936, 3.1):
        omega, J, A_1, _ = least_force(a, 0.022)
        found = np.array(free_motions(DUFFING, (1.0, -0.1, 0.0), np.array([a]))).ravel()
        np.testing.assert_allclose(found, [omega, J, A_1], rtol=2e-3)


def test_sustained_states_beside_the_top_of_a_well_are_told():
    """Of the state that was called stable the free motions of amplitudes like it need more than is supplied there."""
    for a in np.linspace(2.5, 3.15, 14):
        omega, _, _, least = least_force(a, 0.022)
        assert np.hypot(a * (np.clip(omega, 0.57, 0.63) ** 2 - omega**2), least) > 0.08
    folds, states = SOFTENING.saddle_nodes(0.08), SOFTENING.amplitudes(Omega=0.6, F_0=0.08)
    assert folds.Omega.min() == pytest.approx(0.6758, abs=1e-4) and states.A.max() == pytest.approx(2.936, abs=1e-3)
    for answer in (folds, states):
        assert Remark.UNSUSTAINED in answer.remarks and "next to the top of the well" in answer.message
    many = Duffing.many(1.0, -0.1, zeta=[0.022, 0.044])
    assert many.saddle_nodes(0.08).remarks.tolist() == [folds.remarks, Remark.BEYOND_WELL]
    assert many.amplitudes(Omega=0.6, F_0=0.08).remarks.tolist() == [states.remarks, Remark(0)]


@pytest.mark.parametrize(("zeta", "inertial"), [(0.3, False), (0.01, True)])
def test_sustained_states_beside_resonance_balance(zeta, inertial):
    """At another frequency velocities scale with it, and the work of an unbalance with its square."""
    A, Omega = 2.9, np.sqrt(1 - 0.075 * 2.9**2)  # on the backbone: all that is supplied is taken by damping
    shares = []
    for a in np.linspace(0.8 * A, 3.155, 40):
        omega, J, A_1, _ = least_force(a, zeta)
        frequency = np.clip(omega, 0.95 * Omega, 1.05 * Omega)
        taken = 2 * zeta * J * frequency / omega / (np.pi * A_1)
        supplied = 2 * zeta * Omega * A * ((frequency / Omega) ** 2 if inertial else 1)
        shares.append(np.hypot(a * (frequency**2 - omega**2), taken) / supplied)
    assert 0.95 < min(shares) < 0.99
    flow = SlowFlow(DUFFING, (1.0, -0.1, 0.0), 0.0, zeta, "base" if inertial else "force")
    assert unsustained(flow, np.array([Omega]), np.array([A])).tolist() == [False]


@pytest.mark.parametrize("more", [{}, {"excitation": "unbalance"}, {"c_2": 0.02}, {"mu": 0.005}])
def test_sustained_states_far_from_the_top_are_not_told(more):
    one = Duffing(1.0, -0.1, zeta=0.022, **more)
    assert Remark.UNSUSTAINED not in one.amplitudes(Omega=0.95, F_0=0.03).remarks
    assert Remark.UNSUSTAINED not in Duffing(1.0, 0.5, zeta=0.022, **more).amplitudes(Omega=1.1, F_0=0.08).remarks


def test_sustained_states_below_a_top_at_the_reach_are_told():
    """Of sin(u), its reach the top of its well: by quadrature no free motion of that amplitude is sustained."""
    u = sp.Symbol("u")
    pendulum = derive.mechanism("pendulum_to_its_top", [(sp.sin(u), None)], {}, reach=math.pi)(zeta=0.0089)
    states = pendulum.amplitudes(Omega=0.4954, F_0=0.0261)
    assert states.A.max() == pytest.approx(2.944, abs=1e-3) and Remark.UNSUSTAINED in states.remarks
    for a in np.linspace(2.36, 3.1, 20):
        theta = (np.arange(4000) + 0.5) * np.pi / 8000
        x = a * np.sin(theta)
        speed = np.sqrt(2 * (np.cos(x) - np.cos(a)))
        time = a * np.cos(theta) / speed * np.pi / 8000
        omega = np.pi / 2 / time.sum()
        A_1 = 2 * np.sum(x * np.sin(omega * (np.cumsum(time) - time / 2)) * time) / time.sum()
        least = 2 * 0.0089 * 4 * np.sum(speed**2 * time) / (np.pi * A_1)
        assert np.hypot(a * (np.clip(omega, 0.471, 0.52) ** 2 - omega**2), least) > 0.0261


def test_sustained_motions_across_two_wells_have_no_top():
    """The remark was made of a stable state of two wells, near which Newton finds an exact motion, stable too."""
    one = Duffing(-1.0, 1.0, mu=0.0102, zeta=0.1901)
    states = one.amplitudes(Omega=0.5379, F_0=0.3492)
    measured = states.measure()
    assert states.stable[-1] and measured.found[-1] and measured.stable[-1]
    assert Remark.UNSUSTAINED not in states.remarks


@pytest.mark.slow
def test_sustained_states_alone_have_exact_motions():
    """Random softening springs: motions by shooting from many phases; few are reported that have one nearby."""
    rng = np.random.default_rng(35)
    outcome = {(reported, exists): 0 for reported in (False, True) for exists in (False, True)}
    for _ in range(150):
        zeta = 10 ** rng.uniform(-2.5, -1.3)
        F_0 = 2 * zeta * rng.uniform(0.35, 0.6)
        one = Duffing(1.0, -1.0, zeta=zeta)
        for Omega in rng.uniform(0.5, 0.9, 3):
            states = one.amplitudes(Omega=Omega, F_0=F_0)
            system = one.equation_of_motion()
            for state in states:
                if not state.stable or state.A < 0.5:
                    continue
                near = (
                    shooting.near(system, Omega * (1 + off), F_0, (ratio * state.A, state.phi + phase))
                    for off in (0.0, -0.05, 0.05)
                    for ratio in (1.0, 0.93)
                    for phase in (0.0, 0.6, -0.6, 1.2)
                )
                exists = any(motion is not None and abs(motion.A / state.A - 1) < 0.15 for motion in near)
                outcome[Remark.UNSUSTAINED in states.remarks, exists] += 1
    assert (
        outcome[True, False] > 5 and outcome[False, False] <= 1 and outcome[True, True] <= 0.03 * sum(outcome.values())
    )
