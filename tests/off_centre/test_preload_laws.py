"""A preload with other laws of damping and excited by inertia: states on a grid, folds, onsets, exact motions."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy as sp

from slowflow import derive
from slowflow.answers.results import Remark
from tests.oracles.by_time import largest
from tests.oracles.by_work import assert_complete, balances, force_of

u, k, c, gap = sp.symbols("u k c gap")
ABOVE_0 = {"above": 0}
LAWS = {
    "structural": {"mu": 0.0, "zeta": 0.03, "eta": 0.04},
    "quadratic": {"mu": 0.01, "zeta": 0.0, "c_2": 0.3},
    "both": {"mu": 0.01, "zeta": 0.02, "eta": 0.01, "c_2": 0.1},
    "contact": {"mu": 0.02, "zeta": 0.03, "eta": 0.01, "contact": "attached"},
    "base": {"mu": 0.01, "zeta": 0.03, "excitation": "base"},
    "base and structural": {"mu": 0.0, "zeta": 0.01, "eta": 0.05, "excitation": "base"},
    "unbalance and quadratic": {"mu": 0.01, "zeta": 0.03, "c_2": 0.2, "excitation": "unbalance"},
}


@pytest.fixture(scope="module")
def springs():
    """A hardening one, and one with a stop."""
    return {
        "cubic": derive.mechanism("preloaded_cubic", [(c + u + k * u**3, None)], {"c": ABOVE_0, "k": ABOVE_0}),
        "stop": derive.mechanism(
            "preloaded_linear_stop",
            [(c + u, gap), (c + u + k * (u - gap), None)],
            {"c": ABOVE_0, "k": ABOVE_0, "gap": ABOVE_0},
        ),
    }


NUMBERS = {"cubic": {"c": 0.03, "k": 1.2}, "stop": {"c": 0.02, "k": 1.5, "gap": 0.3}}
CASES = [(spring, law) for spring in NUMBERS for law in LAWS if spring == "stop" or law != "contact"]


#: fast tests have one law of each spring
BRIEF = [pytest.param(case, marks=[pytest.mark.slow] * (case[1] != "quadratic")) for case in CASES]


@pytest.fixture(params=BRIEF, ids=lambda case: " ".join(case))
def oscillator(springs, request):
    spring, law = request.param
    return springs[spring](**NUMBERS[spring], **LAWS[law])


def forcings(one):
    """Below and above what holds a mass at rest; of inertia a weak and a strong one."""
    if one.model.inertial:
        return 0.01, 0.08
    return one.model.m + 0.6 * (one.model.break_loose - one.model.m), 1.5 * one.model.break_loose


@pytest.mark.slow
@pytest.mark.part(3)
def test_no_state_or_fold_is_missed_or_made_up(oscillator):
    for F_0 in forcings(oscillator):
        assert_complete(oscillator, F_0)


@pytest.mark.slow
@pytest.mark.part(3)
def test_onset_is_where_two_folds_come_or_they_end_at_rest(oscillator):
    onset = oscillator.saddle_node_onset()
    if oscillator.model.inertial:
        # R next to 0 at A Omega^2 = 4c/pi: with A its level m/Omega^2 tends to 0, too
        assert onset.F_SN is None and "folds occur at ever lower ones" in onset.message
        assert [len(oscillator.saddle_nodes(F_0)) % 2 for F_0 in (1e-3, 1e-4)] == [1, 1]
        return
    assert (onset.F_SN is None or onset.F_SN < oscillator.model.m) or "4 mu/pi" in onset.message
    if onset.F_SN is not None:
        below, above = (len(oscillator.saddle_nodes(onset.F_SN * (1 + offset))) for offset in (-1e-5, 1e-4))
        assert above == below + 2


def test_a_curve_has_states_of_its_own_frequencies(oscillator):
    F_0 = forcings(oscillator)[1]
    curve = oscillator.frequency_response(F_0, samples=40, Omega=(0.3, 3.0))
    level = np.hypot(*balances(oscillator, curve.Omega, curve.A))
    np.testing.assert_allclose(level, force_of(oscillator, curve.Omega, F_0), rtol=5e-10)
    peak = oscillator.peak(F_0)
    if peak.A is not None:
        assert peak.A >= curve.A.max() * (1 - 1e-12)


@pytest.mark.slow
@pytest.mark.parametrize(("law", "Omega", "F_0"), [("both", 1.1, 0.12), ("base and structural", 1.0, 0.1)])
def test_exact_motions_are_independent_and_near_averaged_ones(springs, law, Omega, F_0):
    one = springs["cubic"](c=0.01, k=0.5, **LAWS[law])
    state = one.steady_state(Omega=Omega, F_0=F_0)
    assert state.stable and state.stops == 0
    assert state.A == pytest.approx(largest(lambda u: u + 0.5 * u**3, one, Omega, F_0, 120, preload=0.01), rel=1e-6)
    found = one.amplitudes(Omega=Omega, F_0=F_0)
    assert np.min(np.abs(found.A[found.stable] / state.A - 1)) < 0.02


def test_a_preload_that_pushes_outwards_is_refused():
    outward = derive.mechanism("outward", [(-c + u + k * u**3, None)], {"c": ABOVE_0, "k": ABOVE_0})
    for laws in ({"eta": 0.02}, {"excitation": "base"}):
        with pytest.raises(ValueError, match="jumps at u = 0, and pushes outwards"):
            outward(c=0.02, k=1.0, mu=0.01, zeta=0.03, **laws)
    # a force has answers, which say that u = 0 is no place of rest: next to it the spring pushes on, by c
    numbers = {"c": 0.02, "k": 1.0, "mu": 0.01, "zeta": 0.03}
    assert Remark.NEGATIVE_STIFFNESS in outward(**numbers).saddle_nodes(0.1).remarks
    assert outward.many(**numbers).saddle_nodes(0.1).remarks & Remark.NEGATIVE_STIFFNESS


@pytest.mark.slow
def test_a_force_that_falls_at_a_breakpoint_does_not_harden():
    """f(u)/u rises on each piece, 1 and 1 - c/u, and falls by c/gap between them: motions may leave the centre."""
    falls = derive.mechanism("falls_at_gap", [(u, gap), (u - c, None)], {"gap": ABOVE_0, "c": ABOVE_0})
    assert not falls(gap=0.3, c=0.05, mu=0.0, zeta=0.05).model.stays_centred


@pytest.mark.slow
def test_inertia_at_low_frequencies_leaves_the_mass_at_rest(springs):
    one = springs["cubic"](c=0.03, k=1.2, **LAWS["base"])
    begin = math.sqrt(one.model.break_loose / 0.08)
    found = one.amplitudes(Omega=[0.5 * begin, 1.5], F_0=0.08)
    assert f"a mass at rest stays there up to Omega = {begin:g}" in found.message
    assert found.A[found.Omega == 0.5 * begin].tolist() == [0.0] and found.A[found.Omega == 1.5].all()
    # along the curve the amplitude tends to 0 there
    curve = one.frequency_response(0.08, Omega=(0.0, 2.0))
    assert curve.Omega[np.argmin(curve.A)] == pytest.approx(begin, rel=1e-3)
