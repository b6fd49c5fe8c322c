"""Linear springs under every law of damping, excitation and load: one motion at each frequency, in closed form."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from slowflow import Duffing
from tests.oracles.by_work import force_of, lag

LAWS = {
    "viscous": {"zeta": 0.07},
    "friction": {"zeta": 0.05, "mu": 0.01},
    "structural": {"eta": 0.05},
    "structural and viscous": {"zeta": 0.06, "eta": 0.07},
    "quadratic": {"c_2": 0.7},
    "cubic": {"zeta": 0.02, "c_3": 3.0, "zeta_2": 5.0},
}
ALPHA, F_0, OMEGA = 0.8, 0.3, np.array([0.3, 0.9, 1.0, 1.7, 30.0])
D = 8 * LAWS["quadratic"]["c_2"] / (3 * np.pi)
#: frequencies of peaks, of a force or not
TOPS = {
    ("viscous", True): lambda A: np.sqrt(ALPHA - 2 * 0.07**2),
    ("viscous", False): lambda A: ALPHA / np.sqrt(ALPHA - 2 * 0.07**2),
    ("structural", True): lambda A: np.sqrt(ALPHA),
    ("quadratic", True): lambda A: np.sqrt(ALPHA / (1 + (D * A) ** 2)),
}
CASES = [
    (law, excitation, load)
    for law, excitation, load in itertools.product(LAWS, ("force", "base", "unbalance"), (0.0, 0.4))
    if law != "cubic" or (excitation, load) == ("force", 0.0)
]


def amplitude(osc, Omega):
    """The root of R^2 + I^2 = force^2, which rises with A, by Newton's method from above."""
    force, A = force_of(osc, Omega, F_0), 1e3

    def level(A):
        return np.hypot(A * (Omega**2 - ALPHA), lag(osc, Omega, A)) - force

    for _ in range(200):
        A -= level(A) * 1e-7 * A / (level(A * (1 + 1e-7)) - level(A))
    return A


@pytest.mark.parametrize(("law", "excitation", "load"), CASES)
def test_a_linear_spring_moves_in_closed_form(law, excitation, load):
    osc = Duffing(ALPHA, 0.0, **LAWS[law], load=load, excitation=excitation)
    states, force = osc.amplitudes(Omega=OMEGA, F_0=F_0), force_of(osc, OMEGA, F_0)
    A = np.array([amplitude(osc, Omega) for Omega in OMEGA])
    I, R = lag(osc, OMEGA, A), A * (OMEGA**2 - ALPHA)
    np.testing.assert_allclose(states.A, A, rtol=3e-14)
    np.testing.assert_allclose(states.phi, -np.arctan2(I, -R), rtol=1e-13)
    np.testing.assert_allclose(states.transmissibility, np.hypot(ALPHA * A, I) / force, rtol=1e-13)
    np.testing.assert_allclose(states.transmissibility_dB, 20 * np.log10(states.transmissibility), atol=1e-12)
    assert states.stable.all() and not len(osc.saddle_nodes(F_0)) and osc.saddle_node_onset().F_SN is None
    peak, isolation = osc.peak(F_0), osc.isolation(F_0)
    assert peak.A == pytest.approx(amplitude(osc, peak.Omega), rel=1e-13)
    assert max(amplitude(osc, peak.Omega * (1 + offset)) for offset in (-1e-4, 1e-4)) < peak.A
    if (law, excitation == "force") in TOPS:
        assert peak.Omega == pytest.approx(TOPS[law, excitation == "force"](peak.A), rel=1e-7 if load else 1e-13)
    assert isolation.Omega == pytest.approx(np.sqrt(2 * ALPHA), rel=1e-12)
    if excitation != "force":
        np.testing.assert_allclose(states.relative, A / F_0, rtol=1e-13)
    if load:
        assert peak.u_max == pytest.approx(peak.A + load / ALPHA, rel=1e-12)
        np.testing.assert_allclose(states.B, load / ALPHA, rtol=1e-13)
    else:
        np.testing.assert_allclose(osc.equivalent_damping(Omega=OMEGA, A=A), I / (2 * A * OMEGA), rtol=1e-13)
        envelope = osc.limit_envelope(Omega=OMEGA, F_0=F_0)
        np.testing.assert_allclose(lag(osc, OMEGA, envelope), force, rtol=1e-13)
