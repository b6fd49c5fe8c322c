"""`Duffing` with a quintic term: against closed forms, roots in 50 digits, SciPy, and its own cubic limit."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mp, mpf
from numpy.testing import assert_allclose
from scipy.integrate import solve_ivp

from slowflow import Duffing
from slowflow.app.scenes import from_tables
from slowflow.sizing import fit, from_loop

#: softens, and then hardens: four folds
BENT = {"alpha": 1.0, "beta": -0.5, "gamma": 0.1, "mu": 0.01, "zeta": 0.02}
SPRING = {"m": 12.0, "k_1": 2500.0, "k_3": -3e6, "k_5": 2e10, "friction": 0.3, "c": 8.0}
SIGNS = [(1.0, -0.5, 0.1), (1.0, 0.4, -0.02), (-0.3, 0.2, 0.5), (0.0, 0.0, 1.0), (0.0, -1.0, 2.0), (1.0, 0.0, 0.3)]


def response(Omega, A, F_0, alpha, beta, gamma, mu, zeta):
    """F (24) and F_A."""
    m = 4 * mpf(mu) / mp.pi
    R = A * (Omega**2 - alpha) - mpf(3) / 4 * mpf(beta) * A**3 - mpf(5) / 8 * mpf(gamma) * A**5
    R_A = Omega**2 - alpha - mpf(9) / 4 * mpf(beta) * A**2 - mpf(25) / 8 * mpf(gamma) * A**4
    I, I_A = m + 2 * mpf(zeta) * A * Omega, 2 * mpf(zeta) * Omega
    return R**2 + I**2 - mpf(F_0) ** 2, R * R_A + I * I_A


@pytest.mark.parametrize(("alpha", "beta", "gamma"), SIGNS)
def test_quintic_backbone_is_its_closed_form(alpha, beta, gamma):
    A = np.geomspace(0.8, 3.0, 7)
    square = alpha + 0.75 * beta * A**2 + 0.625 * gamma * A**4
    A, square = A[square > 0], square[square > 0]
    assert_allclose(Duffing(alpha, beta, gamma=gamma).backbone(A), np.sqrt(square), rtol=1e-14)


@pytest.mark.parametrize("F_0", [0.1, 0.06])
@pytest.mark.parametrize(("alpha", "beta", "gamma"), SIGNS)
def test_quintic_folds_and_states_are_roots_in_50_digits(alpha, beta, gamma, F_0):
    numbers = {**BENT, "alpha": alpha, "beta": beta, "gamma": gamma}
    of = Duffing(**numbers)
    with mp.workdps(50):
        for fold in of.saddle_nodes(F_0):
            near = mpf(fold.Omega), mpf(fold.A)
            Omega, A = mp.findroot(lambda Omega, A: response(Omega, A, F_0, **numbers), near)
            assert abs(fold.A / A - 1) < 1e-13 and abs(fold.Omega / Omega - 1) < 1e-13
        states = of.amplitudes(Omega=0.9, F_0=F_0)
        for A in states.A:
            assert abs(A / mp.findroot(lambda x: response(mpf(0.9), x, F_0, **numbers)[0], mpf(A)) - 1) < 1e-12
        # R^2 + I^2 - F_0^2 is a polynomial in A: no state is missing
        R = np.polynomial.Polynomial([0, 0.81 - alpha, 0, -0.75 * beta, 0, -0.625 * gamma])
        I = np.polynomial.Polynomial([4 * 0.01 / math.pi, 0.036])
        roots = (R**2 + I**2 - F_0**2).roots()
        assert len(states.A) == sum(abs(root.imag) < 1e-9 and root.real > 0 for root in roots)


def test_spring_that_softens_and_hardens_has_four_folds():
    folds = Duffing(**BENT).saddle_nodes(0.1)
    assert folds.kind.tolist() == ["jump-down", "jump-up", "jump-up", "jump-down"]
    assert Duffing(**{**BENT, "gamma": 0.0}).saddle_nodes(0.1) != folds


def test_quintic_batch_is_each_oscillator():
    gamma = np.array([-0.1, 0.0, 0.05, 0.1, 0.4])
    many = Duffing.many(**{**BENT, "gamma": gamma})
    for name, at in {"saddle_nodes": {"F_0": 0.1}, "saddle_node_onset": {}, "peak": {"F_0": 0.1}}.items():
        found = getattr(many, name)(**at)
        for k, one in enumerate(gamma):
            single = np.atleast_1d(getattr(Duffing(**{**BENT, "gamma": float(one)}), name)(**at).A)
            if single[0] is not None:
                assert_allclose(np.atleast_1d(found.A[k])[: single.size], single, rtol=1e-13)


def force_of(x):
    return SPRING["k_1"] * x + SPRING["k_3"] * x**3 + SPRING["k_5"] * x**5


def test_quintic_mount_in_si_moves_as_scipy_integrates():
    mount, f, F = Duffing.physical(**SPRING), 2.6, 6.0
    x = np.linspace(-0.02, 0.02, 9)
    assert_allclose(mount.force(x), force_of(x), rtol=1e-13, atol=1e-10)
    omega = 2 * math.pi * f

    def slope(t, y):
        return y[1], (F * math.cos(omega * t) - SPRING["c"] * y[1] - force_of(y[0])) / SPRING["m"]

    smooth = mount.replace(friction=0.0)
    end = 150 / f
    run = solve_ivp(slope, (0, end), (0.0, 0.0), rtol=1e-10, atol=1e-13, dense_output=True, method="DOP853")
    largest = np.abs(run.sol(np.linspace(end - 1 / f, end, 4001))[0]).max()
    assert_allclose(smooth.steady_state(f=f, F=F).A, largest, rtol=1e-6)
    assert_allclose(smooth.amplitudes(f=f, F=F).A.min(), largest, rtol=0.02)


def test_quintic_mounts_in_arrays_are_each_mount():
    k_5 = np.array([0.0, 1e10, 2e10])
    found = Duffing.physical(**{**SPRING, "k_5": 0.0}).many(k_5=k_5).peak(F=2.0)
    each = [Duffing.physical(**{**SPRING, "k_5": float(one)}).peak(F=2.0).A for one in k_5]
    assert_allclose(found.A, each, rtol=1e-13)


@pytest.mark.parametrize(
    "sheet",
    [
        {},
        {"k_1": 0.0, "k_3": 2e5, "c": None, "zeta": 0.02},
        {"k_1": 0.0, "k_3": 0.0, "k_5": 1e8, "c": None, "zeta": 0.02},
    ],
)
def test_quintic_gradient_is_that_of_differences(sheet):
    sheet = {name: value for name, value in {**SPRING, **sheet}.items() if value is not None}
    slopes = Duffing.physical(**sheet).peak(F=2.0).gradient()
    for name in ("k_5", "m", *(name for name in ("k_1", "k_3", "zeta") if sheet.get(name))):
        step = 1e-5 * sheet[name]
        above, below = (Duffing.physical(**{**sheet, name: sheet[name] + d}).peak(F=2.0).A for d in (step, -step))
        assert_allclose(slopes["A", name], (above - below) / (2 * step), rtol=1e-5, atol=1e-12 / sheet[name])


def test_quintic_stiffness_has_units_and_a_scene():
    text = Duffing.physical(m=12, k_1="2.5 N/mm", k_3="-0.003 N/mm^3", k_5="2e-5 N/mm^5")
    plain = Duffing.physical(m=12, k_1=2500.0, k_3=-3e6, k_5=2e10)
    assert_allclose(text.force([0.01]), plain.force([0.01]), rtol=1e-13)
    scene = from_tables({"spring": SPRING, "ask": {"F": 2.0, "questions": ["peak"]}})
    assert scene.oscillator == Duffing.physical(**SPRING)
    with pytest.raises(ValueError, match="k_1 = k_3 = k_5 = 0 is not allowed"):
        Duffing.physical(m=12, k_1=0.0)


def test_quintic_mount_at_random_has_the_mean_slope_of_its_force():
    """E[f'(u)] = alpha + 3 beta s^2 + 15 gamma s^4 for a Gaussian u of deviation s."""
    for row in Duffing(1.0, -0.5, zeta=0.05, gamma=0.3).random(S_0=0.002):
        s = row.u_rms**2
        assert_allclose(row.stiffness, 1.0 - 1.5 * s + 4.5 * s**2, rtol=1e-12)


def test_quintic_rest_positions_are_roots_of_its_force():
    found = Duffing(-1.0, -0.5, zeta=0.05, gamma=0.3, load=0.1).rest()
    roots = np.roots([0.3, 0.0, -0.5, 0.0, -1.0, -0.1])
    assert_allclose(found.u, np.sort(roots[np.abs(roots.imag) < 1e-12].real), rtol=1e-12)


def test_quintic_spring_is_fitted_and_identified_from_a_loop():
    A = np.geomspace(2e-3, 15e-3, 12)
    square = SPRING["k_1"] + 0.75 * SPRING["k_3"] * A**2 + 0.625 * SPRING["k_5"] * A**4
    start = Duffing.physical(**{**SPRING, "k_1": 2400.0, "k_3": -2.5e6, "k_5": 1.5e10})
    found = fit(start, A=A, backbone=np.sqrt(square / SPRING["m"]) / (2 * math.pi), free=["k_1", "k_3", "k_5"])
    assert_allclose(found.value, [SPRING[name] for name in ("k_1", "k_3", "k_5")], rtol=1e-8)
    t = np.linspace(0, 2, 2000)
    x, v = 0.015 * np.sin(2 * math.pi * t), 0.03 * math.pi * np.cos(2 * math.pi * t)
    F = force_of(x) + 0.3 * np.sign(v) + 8.0 * v
    loop = from_loop(x, F, t=t, degree=5)
    assert loop.parameter.tolist() == ["k_1", "k_3", "k_5", "friction", "c"]
    assert_allclose(loop.value[:3], [SPRING[name] for name in ("k_1", "k_3", "k_5")], rtol=1e-3)
    assert_allclose(loop.oscillator(m=12).force(x), force_of(x), rtol=1e-3, atol=1e-3)
    with pytest.raises(ValueError, match="degree = 4 is not allowed"):
        from_loop(x, F, degree=4)
