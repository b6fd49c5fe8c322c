"""Forces that are not odd against exact integrals, closed forms, odd forces stated twice, and integration by time."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
import sympy as sp

from slowflow import Duffing, derive, exact
from slowflow.answers.results import Remark
from slowflow.core.validate import NotAvailable
from slowflow.exact.motion import Forced, follow
from slowflow_kernels.conventions import Status
from tests.off_centre.test_curved import PATCHED
from tests.oracles import exact_reference
from tests.oracles.by_time import mean_and_first

u, k, g, p, q, a, b = sp.symbols("u k g p q a b")
ABOVE = {"above": 0}
DAMPED = {"mu": 0.005, "zeta": 0.03}


@pytest.fixture(scope="module")
def stop():
    """A stop on the right alone, behind a gap."""
    pieces = [(u, g), (u + k * (u - g), None)]
    return derive.mechanism("one_sided_stop", pieces, {"k": ABOVE, "g": {}}, odd=False, compile=True)


@pytest.fixture(scope="module")
def patched():
    return derive.mechanism("patched", PATCHED["powers"], {"p": {}, "q": {}}, odd=False, compile=True)


@pytest.mark.slow
def test_linear_and_bilinear_force_rest_at_the_centre():
    """Whose bound of a place of rest is 0 itself."""
    two = derive.mechanism("two_springs", [(k * u, 0), (u, None)], {"k": ABOVE}, odd=False)(k=3.0, **DAMPED)
    for rest in (two.rest(), Duffing(1.0, 0.0, **DAMPED).off_centre.rest()):
        assert rest.u.tolist() == [0.0] and rest.stable.all()
    assert "is already at the first breakpoint" in two.detachment().message
    assert two.saddle_node_onset().message.startswith("no saddle node at any forcing")
    assert two.replace(load=-0.3).rest().u == pytest.approx([-0.1], rel=1e-14)


def test_a_stop_is_reached_by_the_linear_motion_that_just_does(stop):
    """Up to contact the mass is on one spring: the gap is the peak of its response, from the place of rest."""
    found = stop(k=8.0, g=0.2, mu=0.0, zeta=0.03, load=0.05).detachment()
    A = 0.2 - 0.05
    assert found.A == pytest.approx(A, rel=1e-14) and found.B == pytest.approx(0.05, rel=1e-13)
    assert found.F_cr == pytest.approx(A * 2 * 0.03 * np.sqrt(1 - 0.03**2), rel=1e-13)
    assert found.Omega_cr == pytest.approx(np.sqrt(1 - 2 * 0.03**2), rel=1e-13)
    assert stop(k=8.0, g=-0.1, **DAMPED).detachment().message == ""
    assert "at rest the mass is already" in stop(k=8.0, g=0.1, load=0.3, **DAMPED).detachment().message


def test_exact_motions_against_a_stop_are_integration_by_time(stop):
    soft = stop(k=0.3, g=0.1, mu=0.0, zeta=0.05)
    (state,) = soft.amplitudes(Omega=1.05, F_0=0.03)
    motion = soft.steady_state(Omega=1.05, F_0=0.03)
    B, A = mean_and_first(lambda x: x + 0.3 * max(x - 0.1, 0.0), soft, 1.05, 0.03, (0.0, 0.0), 70)
    middle, first = motion.harmonics(1)
    assert middle.real == pytest.approx(B, abs=1e-7) and abs(first) == pytest.approx(A, abs=1e-7)
    assert motion.stable and motion.residual < 1e-10 and B < -0.005
    assert state.A == pytest.approx(A, rel=0.02) and state.B == pytest.approx(B, rel=0.1)


@pytest.mark.slow
def test_a_force_of_four_pieces_is_followed_through_all_of_them(patched):
    oscillator = patched(p=0.0, q=0.3, mu=0.002, zeta=0.06)
    grid = np.array([-0.5, -0.4, -0.3, -0.1, 0.0, 0.2, 0.25, 0.5])
    expected = [-1.0, -0.8, -0.3135, -0.1005, 0.0, 0.196, 0.246875, 0.621875]
    assert oscillator.force(grid) == pytest.approx(expected, rel=1e-14)
    (state,) = oscillator.amplitudes(Omega=0.8, F_0=0.12)
    assert state.B + state.A > 0.25 and state.B - state.A < -0.1
    motion = oscillator.steady_state(Omega=0.8, F_0=0.12)
    law = oscillator.restoring_force()
    B, A = mean_and_first(law.value, oscillator, 0.8, 0.12, (0.0, 0.0), 40)
    middle, first = motion.harmonics(1)
    assert middle.real == pytest.approx(B, abs=1e-5) and abs(first) == pytest.approx(A, abs=1e-5)
    assert state.A == pytest.approx(A, rel=0.05)


@pytest.mark.slow
def test_compiled_motions_off_the_centre_are_scipys(stop, patched):
    """Switches, amplitudes, multipliers of pieces on both sides of the centre and on one; a start at a jump."""
    for oscillator, Omega, F_0 in (
        (stop(k=8.0, g=0.02, **DAMPED), 0.9, 0.05),
        (patched(p=0.1, q=0.3, **DAMPED), 0.8, 0.12),
    ):
        system = oscillator.equation_of_motion()
        found = exact.steady_state(system, Omega=Omega, F_0=F_0)
        other = exact_reference.again(found)
        assert other.A == pytest.approx(found.A, rel=1e-10)
        assert np.max(np.abs(other.multipliers - found.multipliers)) <= 1e-9
        for edge in system.force.breakpoints:
            forced = Forced(system, Omega, F_0)
            exact_reference.assert_followed(forced, follow(forced, 0.3, edge, 0.0, 2.0))


@pytest.mark.slow
def test_exact_asymmetric_curve_jumps_as_sweeps_and_mirrors(stop):
    """The stop on the other side too, whose pieces are numbered the other way; near the averaged folds."""
    pieces = [(u + k * (u + g), -g), (u, None)]
    left = derive.mechanism("stop_on_the_left", pieces, {"k": ABOVE, "g": {}}, odd=False, compile=True)
    parameters = {"k": 8.0, "g": 0.1, **DAMPED}
    curve, image = (of(**parameters).exact_response(0.05, Omega=(0.7, 1.6)) for of in (stop, left))
    up, down = curve.folds
    for fold, other in zip(curve.folds, image.folds, strict=True):
        assert fold.kind == other.kind and [fold.Omega, fold.A] == pytest.approx([other.Omega, other.A], rel=1e-9)
    folds = stop(**parameters).saddle_nodes(0.05)
    assert [fold.Omega for fold in curve.folds] == pytest.approx(folds.Omega, rel=0.05)
    for swept, at in ((np.linspace(1.2, 1.5, 31), down.Omega), (np.linspace(1.5, 1.2, 31), up.Omega)):
        ((before, after),) = stop(**parameters).sweep(Omega=swept, F_0=0.05).jumps
        assert min(before, after) < at < max(before, after)


def test_exact_asymmetric_curve_says_averaging_knows_no_other(stop):
    found = stop(k=8.0, g=0.5, mu=0.005, zeta=0.0).exact_response(0.05, Omega=(0.4, 0.42), step=0.2)
    assert found.stable.all() and "averaging does not give them: frequency_response needs zeta > 0" in found.message


def test_asymmetric_force_is_refused_centred_questions(stop):
    oscillator = stop(k=8.0, g=0.2, **DAMPED)
    for ask in (lambda: oscillator.cusps(A_max=1.0), lambda: oscillator.backbone([0.1])):
        with pytest.raises(ValueError, match="a force that is not odd"):
            ask()
    for ask in (
        lambda: oscillator.second_approximation,
        lambda: oscillator.saddle_nodes(0.03, certify=True),
        lambda: oscillator.certify(0.03),
        lambda: oscillator.explain("cusps"),
    ):
        with pytest.raises(ValueError, match="not odd"):
            ask()
    with pytest.raises(NotAvailable, match="a force that is not odd is not available with contact = 'attached"):
        oscillator.replace(contact="attached")
    with pytest.raises(ValueError, match="does not grow"):
        derive.mechanism("bounce", [(0 * u, 0), (k * u, None)], {"k": ABOVE}, odd=False)(k=2.0, **DAMPED).rest()
    assert pickle.loads(pickle.dumps(oscillator)) == oscillator


@pytest.mark.slow
def test_a_force_that_is_not_odd_cannot_be_stated_as_anything():
    with pytest.raises(ArithmeticError, match="each side is a piece of its own"):
        derive.mechanism("sizes", [(sp.Abs(u), None)], {"k": ABOVE}, odd=False)
    with pytest.raises(ValueError, match="does not grow"):
        derive.mechanism("waves", [(k * sp.sin(u), None)], {"k": ABOVE}, odd=False)(k=1.0, **DAMPED).rest()
    with pytest.raises(ArithmeticError, match="which is not above g"):
        derive.mechanism("order", [(u, g), (2 * u, g - 1), (u, None)], {"g": {}}, odd=False)
    crossing = derive.mechanism("cross", [(u, g), (2 * u, p), (u, None)], {"g": {}, "p": {}}, odd=False)
    with pytest.raises(ValueError, match=r"end at u = 0.3, 0.1, which must be ascending"):
        crossing(g=0.3, p=0.1, **DAMPED)


@pytest.mark.slow
def test_its_derivation_is_told(stop, tmp_path):
    text = stop.document()
    assert "The force is not odd" in text and r"B + A \cos\psi" in text and "D_1" in text
    assert "derivation.md" in stop.write(tmp_path)


def test_asymmetric_play_does_not_single_out_a_mean():
    """Boxes of equivalent means were bisected for up to 16 s; a load beyond the dead zone has an answer."""
    pieces = [(k * (u + g), -g), (0, 2 * g), (k * (u - 2 * g), None)]
    loose = derive.mechanism("sided_play", pieces, {"k": ABOVE, "g": ABOVE}, odd=False)(k=1.0, g=0.2, **DAMPED)
    for ask in (loose.rest, lambda: loose.amplitudes(Omega=0.8, F_0=0.05), lambda: loose.saddle_nodes(0.05)):
        with pytest.raises(ArithmeticError, match=r"in a dead zone the mean is arbitrary: .* for all -0.2 < u < 0.4"):
            ask()
    assert loose.replace(load=0.05).rest().u == pytest.approx([0.45])


def test_larger_motions_of_an_asymmetric_play_are_refused():
    """The mass is in equilibrium anywhere in the dead zone, so that no mean is singled out."""
    pieces = [(u + g, -g), (0 * u, 2 * g), (k * (u - 2 * g), None)]
    loose = derive.mechanism("wide_play", pieces, {"k": ABOVE, "g": ABOVE}, odd=False)(k=1.0, g=0.2, **DAMPED)
    for ask in (lambda: loose.amplitudes(Omega=0.8, F_0=5.0), lambda: loose.peak(5.0), loose.detachment):
        with pytest.raises(ArithmeticError, match="in a dead zone the mean is arbitrary"):
            ask()
    assert "in a dead zone the mean is arbitrary" in loose.saddle_node_onset().message


@pytest.mark.slow
def test_preload_stated_as_asymmetric_has_the_odd_ones_motions():
    """What it does to a mass at rest, which stands where the force jumps, is undecided in words."""
    sided = derive.mechanism("sided_preload", [(u - g, 0), (u + g, None)], {"g": ABOVE}, odd=False)
    odd = derive.mechanism("odd_preload", [(u + g, None)], {"g": ABOVE})
    one, other = (made(g=0.05, mu=0.005, zeta=0.03) for made in (sided, odd))
    found, expected = (of.amplitudes(Omega=[0.9, 1.2], F_0=0.1) for of in (one, other))
    assert found.A == pytest.approx(expected.A, rel=1e-12) and np.abs(found.B).max() < 1e-12
    assert one.peak(0.1).A == pytest.approx(other.peak(0.1).A, rel=1e-9)
    assert "undecided" in one.rest().message and "undecided" in one.saddle_nodes(0.1).message
    assert "undecided" in one.saddle_node_onset().message and "undecided" in one.detachment().message
    with pytest.raises(ArithmeticError, match="undecided"):
        one.margins(0.1)
    many = sided.many(g=[0.05], mu=0.005, zeta=0.03).detachment()
    assert many.status.tolist() == [Status.UNRESOLVED] and many.remarks.tolist() == [Remark.UNDECIDED]
