"""A mass that no spring holds, f(u) = 0: its response against the positive root of (24), a polynomial in A."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from scipy.optimize import brentq

from slowflow import Duffing, derive
from slowflow.answers.results import Remark
from tests.oracles.by_work import assert_complete

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


@pytest.mark.parametrize("law", LAWS)
def test_states_are_the_roots(law):
    free = Duffing(0, 0, **LAWS[law])
    found = free.amplitudes(Omega=OMEGA, F_0=F_0)
    assert not found.message and found.stable.all() and Remark.UNDECIDED not in found.remarks
    for Omega, A in zip(OMEGA, found.A, strict=True):
        assert abs(float(A / state(Omega, **LAWS[law])) - 1) < 16 * U
    assert [float(free.amplitudes(Omega=one, F_0=F_0).A[0]) for one in OMEGA] == pytest.approx(found.A, rel=4 * U)


@pytest.mark.slow
@pytest.mark.parametrize("law", LAWS)
def test_curve_begins_at_its_window_or_says_where_it_is_cut(law):
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


def test_quadratic_damping_alone_on_a_base_has_one_amplitude():
    """A^2 + (8 c_2/(3 pi) A^2)^2 = F_0^2."""
    free = Duffing(0, 0, c_2=0.05, excitation="base")
    d = 8 * 0.05 / (3 * np.pi)
    A = np.sqrt((np.sqrt(1 + 4 * d**2 * F_0**2) - 1) / (2 * d**2))
    for ask in (free.frequency_response, free.peak, lambda F_0: free.amplitudes(Omega=1.0, F_0=F_0)):
        with pytest.raises(ArithmeticError, match=r"no response curve: A = 0\.0499") as refusal:
            ask(F_0)
        assert float(str(refusal.value).split("A = ")[1].split()[0]) == pytest.approx(A, rel=1e-9)


def test_play_with_structural_damping_has_a_static_state():
    """It was undecided: next to Omega = 0 F is flat to the fourth power where there is no spring."""
    from slowflow import derive

    loose = derive.library("dead_zone")(delta=2.0, mu=0.0, zeta=0.0, eta=0.05)
    found = loose.amplitudes(Omega=[0.5, 1.0], F_0=F_0)
    assert Remark.UNDECIDED not in found.remarks
    within = Duffing(0, 0, eta=0.05).amplitudes(Omega=[0.5, 1.0], F_0=F_0)
    np.testing.assert_allclose(found.A, within.A, rtol=1e-14)
    assert loose.peak(F_0).A == pytest.approx(F_0 / 0.05, rel=1e-14)


# ---- a spring whose force levels off: it does not hold the mass as Omega tends to 0 beyond some forcing -------------

K, G = 1.0, 0.1
DAMPED = {"zeta": 0.05}


@pytest.fixture(scope="module")
def yielding():
    """f = k u up to |u| = g, and k g beyond."""
    u, k, g = sp.symbols("u k g")
    return derive.mechanism("yielding", [(k * u, g), (k * g, None)], {"k": {"above": 0}, "g": {"above": 0}})


def restoring(A):
    """-h of it, in closed form."""
    sine = np.minimum(G / np.asarray(A), 1.0)
    return 2 * K / np.pi * A * (np.arcsin(sine) + sine * np.sqrt(1 - sine**2))


def off_balance(Omega, A, F, mu, zeta=0.05):
    """F of (24) over F_0^2."""
    return ((A * Omega**2 - restoring(A)) ** 2 + (4 * mu / np.pi + 2 * zeta * A * Omega) ** 2) / F**2 - 1


@pytest.mark.slow
@pytest.mark.parametrize("mu", [0.0, 0.02, 0.03, 0.05])
def test_onset_lies_below_the_forcing_the_spring_does_not_hold(yielding, mu):
    """F = F_A = F_AA = 0 there, by 40 digits; a hundredth lower there is one state at each frequency, higher three."""
    mount = yielding(k=K, g=G, mu=mu, **DAMPED)
    found = mount.saddle_node_onset()

    def F(Omega, A, level):
        sine = mp.mpf(G) / A
        h = 2 * mp.mpf(K) / mp.pi * A * (mp.asin(sine) + sine * mp.sqrt(1 - sine**2))
        I = 4 * mp.mpf(mu) / mp.pi + 2 * mp.mpf(0.05) * A * Omega
        return (A * Omega**2 - h) ** 2 + I**2 - level**2

    with mp.workdps(40):
        conditions = [
            lambda Omega, A, level, n=n: mp.diff(lambda a: F(Omega, a, level), A, n) if n else F(Omega, A, level)
            for n in range(3)
        ]
        Omega, A, level = mp.findroot(conditions, (found.Omega, found.A, found.F_SN), tol=1e-24)
    assert [found.F_SN, found.Omega, found.A] == pytest.approx([float(level), float(Omega), float(A)], rel=1e-12)
    window = found.Omega * np.linspace(0.97, 1.03, 61)
    for ratio, most in ((0.99, 1), (1.01, 3)):
        every = (*window, *np.geomspace(0.02, 3, 60))
        assert_complete(mount, ratio * found.F_SN, every)
        states = mount.amplitudes(Omega=every, F_0=ratio * found.F_SN)
        assert max(np.count_nonzero((states.Omega == one) & (states.A > 0)) for one in every) == most
    assert yielding.many(k=K, g=G, mu=[mu], **DAMPED).saddle_node_onset().F_SN[0] == found.F_SN


@pytest.mark.parametrize("level_dB", [0.0, -1.0, -3.0])
@pytest.mark.parametrize(("zeta", "F"), [(0.01, 0.2), (0.003, 0.3), (0.1, 0.2)])
def test_slow_motions_beyond_the_cut_count_for_isolation(yielding, zeta, F, level_dB):
    """Where R^2 - h^2 = (1 - kappa^2) F_0^2, A Omega^2 is a function of A: one equation, whose zero is far out."""
    mu, rest = 0.02, -math.expm1(level_dB / 10 * math.log(10)) * F**2

    def Omega(A):
        return math.sqrt((restoring(A) + math.sqrt(restoring(A) ** 2 + rest)) / A)

    A = brentq(lambda A: off_balance(Omega(A), A, F, mu, zeta), 1e-6, 1e8, xtol=1e-300, rtol=1e-15)
    design = {"k": K, "g": G, "mu": mu, "zeta": zeta}
    found, many = yielding(**design).isolation(F, level_dB), yielding.many(**design).isolation(F, level_dB=level_dB)
    assert (found.Omega, found.A) == pytest.approx((Omega(A), A), rel=1e-12)
    assert (float(many.Omega), float(many.A)) == pytest.approx((Omega(A), A), rel=1e-12)
    assert not found.message and found.remarks == many.remarks == 0
    assert A > 100 * F or zeta == 0.1 or level_dB == -3.0


@pytest.mark.parametrize("level_dB", [-1.0, -10.0])
@pytest.mark.parametrize("damping", [{"mu": 0.03, "zeta": 0.1}, {"mu": 0.0, "zeta": 0.1}, {"mu": 0.01, "c_2": 0.2}])
@pytest.mark.parametrize("gap", [None, 10.0])
def test_damping_alone_transmits_a_moving_base(gap, damping, level_dB):
    """Without a spring force A Omega^2 and I balance F_0 Omega^2, of which I is transmitted."""
    of, design = Duffing, {"alpha": 0.0, "beta": 0.0}
    if gap is not None:
        of, design = derive.library("dead_zone"), {"delta": gap}
    design = {**design, "zeta": 0.0, "excitation": "base", **damping}
    found, many = of(**design).isolation(0.05, level_dB), of.many(**design).isolation(0.05, level_dB=level_dB)
    speed, kappa = found.A * found.Omega, 10 ** (level_dB / 20)
    I = 4 / math.pi * damping["mu"] + 2 * design["zeta"] * speed + 8 / (3 * math.pi) * damping.get("c_2", 0) * speed**2
    assert I / (0.05 * found.Omega**2) == pytest.approx(kappa, rel=1e-12)
    assert found.A / 0.05 == pytest.approx(math.sqrt(1 - kappa**2), rel=1e-12)
    assert (many.Omega, many.A, many.status) == (found.Omega, found.A, 0)


def test_curves_beyond_it_are_drawn_in_a_window_and_cut(yielding):
    mount = yielding(k=K, g=G, mu=0.0, **DAMPED)
    curve = mount.frequency_response(0.2, Omega=(0.3, 1.5), samples=100)
    assert not curve.message and curve.Omega.min() == 0.3 and curve.Omega.max() == 1.5
    assert np.abs(off_balance(curve.Omega, curve.A, 0.2, 0.0)).max() < 1e-12
    states = mount.amplitudes(Omega=[0.01, 0.5, 1.0], F_0=0.2)
    assert np.abs(off_balance(states.Omega, states.A, 0.2, 0.0)).max() < 1e-12 and len(states) == 3
    for answer in (mount.peak(0.2), mount.saddle_nodes(0.2), mount.frequency_response(0.2)):
        assert "the spring force levels off and does not hold the mass: cut at A = 20" in answer.message
    assert Remark.CUT in mount.saddle_nodes(0.2).remarks
    with pytest.raises(OverflowError, match="no amplitude bounds the response"):
        yielding(k=K, g=G, mu=0.09, **DAMPED).saddle_node_onset()
