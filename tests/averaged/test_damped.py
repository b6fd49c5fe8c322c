"""Other laws of damping: averaged by quadrature, next to the onset on a base, of any size, and what is refused."""

from dataclasses import replace

import mpmath
import numpy as np
import pytest
import sympy as sp

from slowflow import Isolator, derive
from tests.averaged.test_certified_cases import (
    FAMILIES,
    cases,
    check_folds,
    check_onset,
    check_states,
    of_record,
    on_a_base,
)

#: one in so many belongs to the fast tests
FEW = 10


@pytest.fixture(scope="module")
def by_quadrature():
    """The same force, with a term without a closed average whose factor is zero."""
    u, alpha, beta, gamma, end, nothing = sp.symbols("u a b g end nothing")
    inside = alpha * u + beta * u**3 + gamma * u**5 + nothing * sp.sin(u) ** 3
    parameters = {name: {} for name in ("a", "b", "g")} | {"end": {"above": 0}, "nothing": {"least": 0}}
    made = derive.mechanism("damped_by_quadrature", [(inside, end), (u, None)], parameters)

    def get(case):
        closed = of_record(case)
        numbers = dict(zip(("a", "b", "g", "end"), closed.model.parameters, strict=True))
        damping = {name: getattr(closed, name) for name in ("mu", "zeta", "eta", "c_2")}
        return made(**numbers, nothing=0.0, contact=case["contact"], **damping)

    return get


@pytest.mark.slow
@pytest.mark.parametrize(("law", "number"), [("contact", 6), ("eta", 18), ("c_2", 6), ("contact", 24)])
@pytest.mark.part(2)
def test_force_averaged_by_quadrature_has_certified_answers(by_quadrature, law, number):
    case, family = cases(f"damped_{law}")[number], replace(FAMILIES[f"damped_{law}"], gradients=False)
    osc = by_quadrature(case)
    assert osc.model.mechanism.enclosed is not None
    found = osc.saddle_nodes(case["F_0"][1])
    assert "message" in vars(found), "words that ask for an average, which may not settle, are made with the answer"
    check_folds(osc, case, family, False)
    check_states(osc, case, family)
    check_onset(osc, case["onset"], family)


def test_laws_are_refused_at_infinite_stiffness_at_rest():
    u, k = sp.symbols("u k")
    root = derive.mechanism("damped_root", [(u + k * sp.sqrt(u), None)], {"k": {"above": 0}})
    with pytest.raises(ValueError, match="its stiffness is infinite at u = 0"):
        root(k=0.05, c_2=0.05, mu=0.01)


BASE = [*cases("damped_base"), *cases("inertia")[::3]]


def on_bases(first):
    """Cases on a base that shakes as parameters: those of the fast tests from number `first` on."""
    return [
        pytest.param(number, marks=[] if number % FEW == first else pytest.mark.slow) for number in range(len(BASE))
    ]


@pytest.mark.parametrize("number", on_bases(3))
@pytest.mark.part(4)
def test_folds_on_a_base_come_at_the_onset(number):
    """None below it, and above it there are some next to where it says."""
    osc = on_a_base(BASE[number], False)
    onset = osc.saddle_node_onset()
    if onset.F_SN is None:
        return
    below, above = (osc.saddle_nodes(onset.F_SN * factor) for factor in (1 - 1e-6, 1 + 1e-4))
    assert len(below) == 0 and len(above) >= (1 if onset.kind == "corner" else 2)
    assert min(abs(above.A - onset.A)) < 0.1 * onset.A


@pytest.mark.parametrize("excitation", ["base", "unbalance"])
@pytest.mark.parametrize("c_2", 10.0 ** np.linspace(-12, -5, 15))
def test_vanishing_quadratic_damping_changes_nothing(c_2, excitation):
    """A pair of frequencies that meets a few ulps below F_0 next to Omega = inf took the place of the states."""
    design = {"lam": 3.0, "r": 2.0, "delta_h": 0.05, "mu": 0.002, "zeta": 0.05, "excitation": excitation}
    found, limit = (Isolator(**design, c_2=value) for value in (c_2, 0.0))
    for Omega in (0.5, 0.8, 3.0, 1e3):
        states, expected = (osc.amplitudes(Omega=Omega, F_0=0.05) for osc in (found, limit))
        assert states.A == pytest.approx(expected.A, rel=10 * c_2 + 1e-12)
        assert np.array_equal(states.stable, expected.stable)
    curve, expected = (osc.frequency_response(0.05) for osc in (found, limit))
    assert len(set(curve.branch)) == len(set(expected.branch))
    assert curve.A.max() == pytest.approx(expected.A.max(), rel=10 * c_2 + 1e-12)
    jumps, expected = (osc.hysteresis(0.05) for osc in (found, limit))
    assert jumps.Omega_low == pytest.approx(expected.Omega_low, rel=1e-4)
    assert np.array_equal(jumps.motions, expected.motions)
    begins, expected = (osc.isolation(0.05, level_dB=-10).Omega for osc in (found, limit))
    assert begins == pytest.approx(expected, rel=1e-4)


@pytest.mark.parametrize("F_0", [1.0, 1e20, 1e60, 1e150])
@pytest.mark.parametrize("c_2", [1e20, 1e100, 1e150, 1e200, 1.7e308])
def test_quadratic_damping_of_any_size_is_answered_or_refused(c_2, F_0):
    """Far beyond resonance under inertia A^2 (1 + (8 c_2 A/3 pi)^2) = F_0^2; it was said to be 0, or a KeyError."""
    iso = Isolator(lam=1.3, r=1.0, delta_h=1.5e-4, mu=0.65, zeta=1.4, excitation="unbalance", c_2=c_2)
    with mpmath.workdps(400):  # some products have 300 digits before the point
        d = 8 * mpmath.mpf(c_2) / (3 * mpmath.pi)
        full = float(mpmath.sqrt(2 * mpmath.mpf(F_0) ** 2 / (1 + mpmath.sqrt(1 + 4 * (d * mpmath.mpf(F_0)) ** 2))))
    try:
        found = iso.frequency_response(F_0, samples=20, Omega=(0.0, 1e35))
    except OverflowError as refusal:
        assert "leave the range of doubles" in str(refusal)
        assert c_2 * F_0 > 1e70  # ordinary numbers are not refused
    else:
        assert found.A.max() == pytest.approx(full, rel=1e-6)
