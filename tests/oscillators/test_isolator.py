"""The public interface: what it refuses and in which words, what it says at dead ends, and properties that hold."""

import math

import numpy as np
import pytest

from slowflow import Duffing, Isolator
from slowflow.averaged import solvers
from slowflow.example import isolator
from slowflow_kernels import motion, slow_flow

# ---- refusals ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("parameter", "value", "allowed"),
    [
        ("lam", 0, "> 0"),
        ("lam", math.nan, "finite"),
        ("lam", "3", "number"),
        ("lam", True, "number"),
        ("lam", [3.0], "number"),
        ("lam", 3 + 0j, "number"),
        ("r", -1.0, "> 0"),
        ("r", math.inf, "finite"),
        ("r", 10**400, "finite"),
        ("delta_h", -1e-9, ">= 0"),
        ("delta_h", 1.0, "< 1"),
        ("mu", -0.1, ">= 0"),
        ("mu", None, "number"),
        ("zeta", -1e-300, ">= 0"),
        ("zeta", math.nan, "finite"),
    ],
)
def test_a_bad_parameter_is_named_with_its_value_and_its_range(parameter, value, allowed):
    with pytest.raises(ValueError) as refusal:
        isolator(**{parameter: value})
    text = str(refusal.value)
    assert parameter in text and repr(value) in text and allowed in text


def test_numbers_not_allowed_together_are_named_together():
    with pytest.raises(ValueError, match=r"r = 1e\+300, .* not allowed together, beta would be beyond 1e\+300"):
        isolator(r=1e300)


FORCINGS = [0.0, -0.04, math.nan, math.inf, "0.04", None, np.array([0.04, 0.05])]
#: what lies under a mask was marked as wrong: it is neither computed with nor left out in silence
MASKED = np.ma.masked_array([0.5, 0.9], mask=[False, True])
#: what is said of values that a question does not take
REFUSED = [
    ("F_0 = .*must be a finite real number > 0", lambda bad: isolator().frequency_response(bad), FORCINGS),
    ("F_0 = .*must be a finite real number > 0", lambda bad: isolator().saddle_nodes(bad), FORCINGS),
    (
        "Omega",
        lambda bad: isolator().amplitudes(Omega=bad, F_0=0.04),
        [0.0, -1.0, math.nan, [0.9, math.inf], "0.9", [0.9, "x"], [[0.9], [0.8, 0.7]]],
    ),
    ("Omega = 2e", lambda bad: isolator().amplitudes(Omega=bad, F_0=0.04), [[0.9, 2e40]]),
    (
        "Omega",
        lambda bad: isolator().frequency_response(0.04, Omega=bad),
        [(1.0, 0.5), (0.5, 0.5), (-0.1, 1.0), 1.0, (0.5, math.nan), (0.1, 0.2, 0.3)],
    ),
    ("samples", lambda bad: isolator().frequency_response(0.04, samples=bad), [1, -5, 2.5, True, "100", 10**6 + 1]),
    ("masked", lambda bad: isolator().amplitudes(Omega=bad, F_0=0.04), [MASKED]),
    ("masked", lambda bad: isolator().saddle_nodes(bad), [np.ma.masked]),
    ("masked", lambda bad: isolator().limit_envelope(Omega=0.9, F_0=bad), [MASKED]),
    ("masked", lambda bad: Isolator.many(lam=3, r=bad, delta_h=0.1).detachment(), [MASKED]),
    ("masked", lambda bad: Isolator.many(lam=3, r=2, delta_h=0.1).peak(bad), [MASKED]),
]


@pytest.mark.parametrize(
    ("message", "ask", "bad"), [(message, ask, bad) for message, ask, values in REFUSED for bad in values]
)
def test_a_bad_argument_of_a_question_is_named(message, ask, bad):
    with pytest.raises(ValueError, match=message):
        ask(bad)


def test_an_array_of_which_nothing_is_masked_is_an_array():
    found = isolator().amplitudes(Omega=np.ma.masked_array([0.5, 0.9]), F_0=0.04)
    assert found == isolator().amplitudes(Omega=[0.5, 0.9], F_0=0.04)


def test_numpy_numbers_are_numbers():
    assert isolator(zeta=np.float32(0.5)).zeta == 0.5
    assert isolator(lam=np.int64(3)).alpha == isolator().alpha
    assert isolator().saddle_nodes(np.array(0.04)).A.size == 2


# ---- dead ends in words --------------------------------------------------------------------------------------------


def test_sticking_is_said():
    stuck = isolator()
    F_0 = stuck.sticking_forcing
    states = stuck.amplitudes(Omega=0.9, F_0=F_0)
    assert states.A.tolist() == [0.0] and states.transmissibility.tolist() == [1.0]
    assert states.message.startswith(stuck.saddle_nodes(F_0).message)
    for answer in (stuck.frequency_response(F_0), stuck.saddle_nodes(F_0)):
        assert answer.A.size == 0
        assert answer.message == "sticks: F_0 = 0.0152789 does not exceed 4 mu/pi = 0.0152789 by more than rounding"
    assert not stuck.limit_envelope(Omega=0.9, F_0=F_0)
    # just above, it moves
    assert stuck.amplitudes(Omega=0.9, F_0=1.001 * F_0).A.size == 1


@pytest.mark.filterwarnings("error")
def test_negative_stiffness_works_with_a_warning():
    with pytest.warns(UserWarning, match="negative stiffness at rest"):
        soft = isolator(delta_h=0.3)
    assert isolator(delta_h=0.16).alpha > 0 > soft.alpha
    assert soft.frequency_response(0.05).A.size > 100


def test_no_fold_is_said():
    answer = isolator().saddle_nodes(0.02)
    assert len(answer) == 0 and "no saddle node" in answer.message


def test_a_linear_oscillator_has_no_onset_and_no_detachment():
    linear = isolator(delta_h=0)
    assert linear.saddle_node_onset().F_SN is None and "no saddle node" in linear.saddle_node_onset().message
    assert linear.detachment().F_cr is None and linear.detachment().message


def test_without_viscous_damping_the_response_is_cut_and_says_so():
    curve = isolator(zeta=0).frequency_response(0.04)
    assert curve.A.max() == 1 and "unbounded" in curve.message and "vertical" in curve.message


@pytest.mark.parametrize("mu", [0.0, 0.012])
def test_without_viscous_damping_there_is_no_isola_point(mu):
    """F_A = F_Omega = 0 leaves R = 0 there, the whole backbone, and no point of it is one."""
    answer = isolator(mu=mu, zeta=0).isola_points(A_max=0.9)
    assert len(answer) == 0 and "no isola" in answer.message


def test_a_rod_past_vertical_is_said():
    assert "push-rod stands vertical" in isolator().frequency_response(0.2).message
    assert not isolator().frequency_response(0.04).message


# ---- closed forms and properties ------------------------------------------------------------------------------------


def test_duffing_backbone_and_onset_tend_to_their_closed_forms():
    """Weak damping: with Omega = 1 + s, F = 4 A^2 [(s - 3/8 beta A^2)^2 + zeta^2], whose cusp is elementary."""
    beta, zeta = 0.5, 1e-5
    duffing = Duffing(1.0, beta, 0.0, zeta)
    A = np.linspace(0.1, 2, 7)
    assert np.allclose(duffing.backbone(A), np.sqrt(1 + 0.75 * beta * A**2), rtol=1e-15)
    onset = duffing.saddle_node_onset()
    q = 0.375 * beta  # y = A^2: s = sqrt(3) zeta, q y = 2 zeta/sqrt(3), F_0^2 = 4 y [(s - q y)^2 + zeta^2]
    y = 2 * zeta / np.sqrt(3) / q
    assert onset.kind == "cusp"
    assert onset.A == pytest.approx(np.sqrt(y), rel=20 * zeta)
    assert onset.Omega - 1 == pytest.approx(np.sqrt(3) * zeta, rel=20 * zeta)
    assert onset.F_SN == pytest.approx(np.sqrt(4 * y * (zeta**2 / 3 + zeta**2)), rel=20 * zeta)


@pytest.mark.parametrize(
    "make", [lambda: Duffing(0.0, 1.0, 0.05, 0.0), lambda: isolator(r=4.0, delta_h=1 / 12, zeta=0)]
)
def test_undamped_folds_without_stiffness_begin_at_friction(make):
    """Omega^2 = 9 beta A^2/4 there, and 2 k = 3 beta A^3 for small A: a fold is where k^2 = F_0^2 - m^2."""
    spring = make()
    assert spring.alpha == 0
    onset = spring.saddle_node_onset()
    assert onset.F_SN is None
    assert "arbitrarily close above 4 mu/pi" in onset.message
    m = spring.sticking_forcing
    folds = spring.saddle_nodes(m * (1 + 1e-9))
    beta = spring.model.parameters[1]
    assert folds.A[0] == pytest.approx(np.cbrt(2 / (3 * beta) * m * np.sqrt(2e-9)), rel=1e-3)


@pytest.mark.parametrize("more", [{}, {"c_2": 0.1}, {"zeta": 0.02, "excitation": "base"}], ids=str)
def test_a_fold_itself_is_one_state_and_not_stable(more):
    """To doubles; balls tell whether the double is above the fold's frequency or below, see test_states_by_balls."""
    folds = isolator(**more).saddle_nodes(0.04)
    assert len(folds) == 2
    for Omega, A in zip(folds.Omega, folds.A, strict=True):
        states = solvers.states(isolator(**more).model, np.array([Omega]), 0.04)
        assert states.A.size == 2
        at = np.argmin(np.abs(states.A - A))
        assert states.A[at] == pytest.approx(A, rel=1e-7) and not states.stable[at] and states.stable[1 - at]


@pytest.mark.parametrize("of", ["averaging", "second", "load"])
def test_amplitudes_at_pairs_are_those_of_each_pair(of):
    """Omega and F_0 broadcast; the states come in the order of the points, each with its forcing."""
    iso = isolator(load=0.01 if of == "load" else 0.0)
    query = iso.second_approximation if of == "second" else iso
    Omega, F_0 = np.array([0.9, 0.7, 0.9]), np.array([[0.05], [0.01], [0.03]])
    found = query.amplitudes(Omega=Omega, F_0=F_0)
    singles = [query.amplitudes(Omega=O, F_0=F) for F in F_0.ravel() for O in Omega]
    own = {"averaging": [], "second": ["A_1"], "load": ["B"]}[of]
    for name in ("Omega", "A", "stable", "phi", "transmissibility", *own):
        together = np.concatenate([getattr(one, name) for one in singles])
        near = 0.0 if of == "averaging" else 1e-11
        np.testing.assert_allclose(getattr(found, name), together, rtol=near, err_msg=name)
    assert found.F_0.tolist() == [one.F_0 for one in singles for _ in one]
    assert found.message.startswith(f"{singles[3].message}; each pair") and "sticks" in found.message
    if of == "averaging":
        measured = np.concatenate([one.measure().A for one in singles])
        assert np.array_equal(found.measure().A, measured, equal_nan=True)
    with pytest.raises(ValueError, match="shapes do not broadcast"):
        query.amplitudes(Omega=Omega, F_0=[0.03, 0.04])
    assert len(query.amplitudes(Omega=0.9, F_0=[])) == 0


def test_the_limit_envelope_broadcasts_over_forcings():
    iso = isolator()
    found = iso.limit_envelope(Omega=[0.5, 0.9], F_0=[[0.01], [0.04]])
    assert found.tolist() == [[0.0, 0.0], [iso.limit_envelope(Omega=O, F_0=0.04) for O in (0.5, 0.9)]]


def test_transmissibility_survives_squares_beyond_doubles():
    for size in (1e-250, 1e250):
        assert slow_flow.transmissibility(1.0, size, size, 3 * size, 0.0, -4 * size) == pytest.approx(5, rel=1e-15)
        assert motion.transmissibility(1.0, 1e250, 2.0, 0.0) == pytest.approx(0.5e250, rel=1e-15)


def test_state_at_u_cr_is_one_at_that_very_frequency():
    """Two pieces of the curve end there: neither omits it or continues to its other end."""
    iso = isolator()
    curve = iso.frequency_response(0.04)
    passed = curve.Omega[curve.A == iso.u_cr]
    assert passed.size == 2
    for Omega in passed:
        near, at = (iso.amplitudes(Omega=Omega * (1 + off), F_0=0.04).A for off in (1e-9, 0.0))
        assert np.abs(at - iso.u_cr).min() < 1e-14
        np.testing.assert_allclose(at, near, rtol=1e-6)
