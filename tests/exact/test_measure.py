"""`answer.measure()`: averaged answers held against the equation of motion, and that against closed forms and SciPy."""

import pickle

import numpy as np
import pytest

from slowflow import Duffing, Isolator, derive
from slowflow.answers.results import NOT_ASKED, SteadyStates
from slowflow.averaged.questions import Averaged
from slowflow.exact import steady_state
from slowflow.exact.measure import AT_REST, BORN, NO_MOTION, TAKEN, states
from slowflow.example import isolator
from slowflow_kernels import den_hartog
from tests.oracles.by_time import last_turn, settled
from tests.oracles.exact_reference import again
from tests.sampling import slow


def test_linear_error_is_that_beside_den_hartogs_amplitude():
    """(35) is the exact amplitude where the mass does not stop."""
    averaged = Duffing(1.0, 0.0, 0.2, 0.0).amplitudes(Omega=np.array([0.7, 0.85, 1.2, 1.4]), F_0=1.0)
    exact = den_hartog.amplitude(averaged.Omega, 1.0, 0.2)
    measured = averaged.measure()
    assert measured.found.all() and not measured.stops.any() and measured.message == ""
    np.testing.assert_allclose(measured.A, exact, rtol=1e-13)
    np.testing.assert_allclose(measured.error, averaged.A / exact - 1.0, rtol=0, atol=1e-12)


@pytest.mark.slow
def test_states_are_measured_by_the_motion_scipy_finds():
    """Two stable states and the unstable one between them."""
    iso = isolator()
    averaged = iso.amplitudes(Omega=0.9, F_0=0.04)
    for force in ("truncated", "untruncated"):
        measured = averaged.measure(force)
        system = iso.equation_of_motion(force)
        assert measured.stable.tolist() == averaged.stable.tolist() == [True, False, True]
        for state, entry in zip(averaged, measured, strict=True):
            other = again(steady_state(system, (state.A, state.phi), Omega=0.9, F_0=0.04))
            assert abs(entry.A - other.A) <= 1e-9 and abs(entry.error - (state.A / other.A - 1.0)) <= 1e-8
    assert averaged.measure().A.tolist() == averaged.measure("truncated").A.tolist()


def test_folds_are_measured_by_those_of_the_exact_curve():
    for oscillator, F_0, window in ((isolator(), 0.04, (0.5, 1.5)), (Duffing(1.0, 0.1, 0.0, 0.025), 0.18, (0.5, 2.0))):
        folds = oscillator.saddle_nodes(F_0)
        measured = folds.measure()
        exact = oscillator.exact_response(F_0, Omega=window).folds
        assert measured.found.all() and len(exact) == len(measured)
        for fold, entry, averaged in zip(exact, measured, folds, strict=True):
            assert abs(entry.Omega - fold.Omega) <= 1e-10 and abs(entry.A - fold.A) <= 1e-6
            assert entry.error == averaged.Omega / entry.Omega - 1.0
            assert entry.error_of_A == averaged.A / entry.A - 1.0


def test_peaks_are_measured_by_linear_and_exact_ones():
    """F_0/(2 zeta sqrt(1 - zeta^2)) at sqrt(1 - 2 zeta^2); and within 10^-12 along the curve's top."""
    zeta, F_0 = 0.05, 0.3
    linear = Duffing(1.0, 0.0, 0.0, zeta).peak(F_0).measure()
    assert linear.A == pytest.approx(F_0 / (2 * zeta * np.sqrt(1 - zeta**2)), rel=1e-10)
    assert linear.Omega == pytest.approx(np.sqrt(1 - 2 * zeta**2), rel=1e-6)
    iso = isolator()
    averaged = iso.peak(0.04)
    measured, exact = averaged.measure(), iso.exact_response(0.04, Omega=(0.5, 1.5)).peak
    assert measured.A == pytest.approx(exact.A, rel=1e-10)
    assert measured.error == averaged.A / measured.A - 1.0
    assert measured.error_of_Omega == averaged.Omega / measured.Omega - 1.0


@pytest.mark.slow
def test_detachment_is_measured_by_that_of_the_first_piece():
    """The stop is reached where the linear peak is the gap; one that is not linear by the exact curve's peak."""
    zeta, gap = 0.03, 0.2
    stop = derive.library("elastic_stop", compile=True)(kappa=5.0, delta=gap, zeta=zeta)
    measured = stop.detachment().measure()
    assert measured.F_0 == pytest.approx(2 * zeta * np.sqrt(1 - zeta**2) * gap, rel=1e-8)
    assert measured.Omega == pytest.approx(np.sqrt(1 - 2 * zeta**2), rel=1e-6)
    iso = isolator()
    averaged = iso.detachment()
    for force in ("truncated", "untruncated"):
        measured = averaged.measure(force)
        assert measured.error == averaged.F_cr / measured.F_0 - 1.0
        for ratio, beyond in ((1 - 1e-4, False), (1 + 1e-4, True)):
            curve = iso.exact_response(ratio * measured.F_0, Omega=(0.6, 1.2), force=force)
            assert (curve.peak.A > averaged.u_cr) == beyond


@pytest.mark.parametrize(
    "oscillator", [isolator(), *slow(Duffing(1.0, 0.1, 0.0, 0.025), Duffing(1.0, -0.05, 0.0, 0.05))]
)
def test_onset_is_measured_by_the_first_fold_of_exact_curves(oscillator):
    """By finer steps, to 10^-4; and the second approximation is nearer to it than averaging."""
    averaged = oscillator.saddle_node_onset()
    measured = averaged.measure()
    assert averaged.kind == "cusp" and measured.error == averaged.F_SN / measured.F_0 - 1.0
    assert measured.error_of_Omega == averaged.Omega / measured.Omega - 1.0
    window = measured.Omega / 1.5, 1.2 * measured.Omega
    for ratio, count in ((1 - 1e-4, 0), (1 + 1e-4, 2)):
        assert len(oscillator.exact_response(ratio * measured.F_0, Omega=window, step=0.005).folds) == count
    second = oscillator.second_approximation.saddle_node_onset().F_SN / measured.F_0 - 1.0
    assert abs(second) < 0.05 * abs(measured.error)


def test_missing_peak_onset_or_detachment_is_not_measured():
    plain = Duffing(1.0, 0.1, 0.0, 0.025)
    assert "one piece only" in plain.detachment().measure().message
    assert "the mass does not move" in Duffing(1.0, 0.0, 0.0, 0.8).peak(0.1).measure().message
    assert "without viscous damping" in Duffing(1.0, 0.1, 0.02, 0.0).peak(0.1).measure().message
    assert "no saddle node" in Duffing(1.0, 0.0, 0.0, 0.1).saddle_node_onset().measure().message
    numbers = {"lam": 5, "r": 0.5152307809931513, "delta_h": 0.2813440740415054, "mu": 0.0457149750553505}
    shaken = Isolator(**numbers, zeta=0.026253034237872036, excitation="base", force="untruncated")
    born = shaken.saddle_node_onset()
    assert born.kind == "isola" and born.measure().message == BORN


def test_states_without_a_motion_say_so_in_words():
    """Between the exact fold and the averaged one, which lies beyond it; and at rest."""
    iso = isolator()
    folds = iso.saddle_nodes(0.04)
    exact, averaged = folds.measure().Omega[1], folds.Omega[1]
    assert averaged > exact
    averaged_states = iso.amplitudes(Omega=0.5 * (exact + averaged), F_0=0.04)
    measured = averaged_states.measure()
    assert averaged_states.A.size == 3 and measured.found.tolist() == [True, False, False]
    assert np.isnan(measured.A[1:]).all() and measured.reason.tolist() == ["", NO_MOTION, NO_MOTION]
    assert measured.message == f"2 of 3 states: {NO_MOTION}"
    static = iso.frequency_response(0.04, samples=20, Omega=(0.0, 0.4)).measure()
    assert static.reason[0] == AT_REST and static.found[-1]


def test_one_motion_is_measured_for_one_state_only():
    """The one as stable as it is, else the nearest."""
    iso = isolator()
    (low, _, high) = iso.amplitudes(Omega=0.9, F_0=0.04)
    A, stable = np.array([low.A, high.A, 1.01 * high.A]), np.array([True, True, False])
    averaged = SteadyStates(np.full(3, 0.9), A, stable, 0.04, "", iso.model)
    found = states(iso.equation_of_motion(), averaged)
    assert found.found.tolist() == [True, True, False] and found.reason[2] == TAKEN
    averaged = SteadyStates(np.full(2, 0.9), 1.01 * A[1:], np.array([True, True]), 0.04, "", iso.model)
    found = states(iso.equation_of_motion(), averaged)
    assert found.found.tolist() == [True, False]


def test_what_cannot_be_measured_is_refused_or_empty():
    iso = isolator()
    standalone = Averaged(iso.model).amplitudes(Omega=0.9, F_0=0.04)
    with pytest.raises(ValueError, match=NOT_ASKED):
        standalone.measure()
    of = Averaged(iso.model)
    for answer in (of.saddle_nodes(0.04), of.peak(0.04), of.saddle_node_onset(), of.detachment()):
        with pytest.raises(ValueError, match=NOT_ASKED):
            answer.measure()
    with pytest.raises(ValueError, match=NOT_ASKED):
        iso.second_approximation.peak(0.04).measure()
    with pytest.raises(ValueError, match="force"):
        iso.amplitudes(Omega=0.9, F_0=0.04).measure("exact")
    with pytest.raises(ValueError, match="without any damping"):
        Isolator(lam=3.0, r=0.6, delta_h=0.25).amplitudes(Omega=0.9, F_0=0.04).measure()
    sticking = iso.amplitudes(Omega=0.9, F_0=0.01)
    assert "sticks" in sticking.message and sticking.measure().A.tolist() == [0.0] and sticking.measure().message == ""
    assert len(iso.saddle_nodes(0.02).measure()) == len(iso.saddle_nodes(0.02)) == 0


def test_answer_that_knows_its_oscillator_is_unchanged():
    iso = isolator()
    answer, standalone = iso.amplitudes(Omega=0.9, F_0=0.04), Averaged(iso.model).amplitudes(Omega=0.9, F_0=0.04)
    assert answer == standalone and hash(answer) == hash(standalone) and answer.to_dict() == standalone.to_dict()
    back = pickle.loads(pickle.dumps(answer))
    assert back == answer and back.measure() == answer.measure()


OFF_CENTRE = [
    (Duffing(1.0, 0.6, 0.0, 0.03, load=0.3), 0.12),
    (Duffing(1.0, 0.6, 0.0, 0.03, load=0.3, c_2=0.2, excitation="base"), 0.12),
]


@pytest.mark.slow
@pytest.mark.parametrize(("osc", "F_0"), OFF_CENTRE, ids=repr)
def test_states_under_a_load_are_measured_by_settled_motions(osc, F_0):
    averaged = osc.amplitudes(Omega=[0.8, 1.5, 1.8], F_0=F_0)
    measured = averaged.measure()
    assert len(averaged) == 3 and averaged.stable.all() and measured.found.all() and measured.stable.all()
    for state, entry in zip(averaged, measured, strict=True):
        _, u = last_turn(lambda u: u + 0.6 * u**3, osc, state.Omega, F_0, (state.B, 0.0), 160, 8000)
        largest = np.abs(u).max()
        assert entry.A == pytest.approx(largest, rel=1e-6)
        assert entry.error == pytest.approx((abs(state.B) + state.A) / largest - 1.0, abs=2e-6)
    assert 1e-4 < np.abs(measured.error).max() < 0.1


def test_folds_under_a_load_are_measured_by_exact_folds():
    osc, F_0 = Duffing(1.0, 0.6, 0.0, 0.03, load=0.3), 0.16
    folds = osc.saddle_nodes(F_0)
    measured, exact = folds.measure(), osc.exact_response(F_0, Omega=(0.9, 1.8)).folds
    assert len(folds) == 2 and measured.found.all()
    for fold, entry in zip(folds, measured, strict=True):
        (same,) = (one for one in exact if one.kind == fold.kind and abs(one.Omega / fold.Omega - 1) < 0.05)
        assert (entry.Omega, entry.A) == pytest.approx((same.Omega, same.A), rel=1e-8)
        assert entry.error == fold.Omega / entry.Omega - 1.0
        assert entry.error_of_A == (abs(fold.B) + fold.A) / entry.A - 1.0


def test_motions_in_either_well_are_two():
    """They have one largest |u|, and opposite means."""
    averaged = Duffing(-0.5, 1.0, 0.0, 0.05).off_centre.amplitudes(Omega=1.2, F_0=0.05)
    measured = averaged.measure()
    assert averaged.B[1:] == pytest.approx([averaged.B[1], -averaged.B[1]])
    assert measured.found.tolist() == [True] * 3 and measured.stable.tolist() == [False, True, True]
    assert measured.A[1] == pytest.approx(measured.A[2], rel=1e-12)


@pytest.mark.slow
def test_what_is_no_asymmetric_state_or_fold_is_not_measured():
    osc = Duffing(1.0, 0.6, 0.0, 0.03, load=0.3)
    for answer in (osc.peak(0.1), osc.rest(), osc.saddle_node_onset()):
        with pytest.raises(ValueError, match="only states and folds can be compared with the equation of motion"):
            answer.measure()


@pytest.mark.slow
def test_a_fold_leads_to_the_exact_one_that_is_nearest():
    """u + 1.6 u^2 + u^3, about its centre of symmetry: the third fold was said to lead to another one's."""
    linear, centre = 11 / 75, 8 / 15
    load = linear * centre + centre**3
    folds = Duffing(linear, 1.0, zeta=0.05, load=load).saddle_nodes(0.1)
    measured = folds.measure()
    assert measured.found.all() and (np.diff(measured.Omega) > 0).all()
    assert folds.Omega[2] == pytest.approx(0.8965, abs=1e-4) and folds.kind[2] == "jump-up"
    # SciPy's motion, stepped down in frequency on the lower branch, goes up between the last two
    state, heights = (centre, 0.0), {}
    for Omega in (0.95, 0.92, 0.911, 0.908):
        push = lambda tau, Omega=Omega: load + 0.1 * np.cos(Omega * tau)  # noqa: E731
        _, u, v = settled(lambda u: linear * u + u**3, push, 0.05, Omega, state, 99, rtol=1e-9, atol=1e-10)
        state, heights[Omega] = (u[-1], v[-1]), np.ptp(u) / 2
    assert 1.3 * heights[0.911] < heights[0.908]
    assert 0.908 < measured.Omega[2] < 0.911
