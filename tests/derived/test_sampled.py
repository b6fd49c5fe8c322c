"""Forces that are Python functions: against certified answers, closed forms, derived forces and another integrator."""

from __future__ import annotations

import math
import pickle
from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from slowflow import derive
from slowflow.core import backend
from slowflow.core.validate import NotAvailable
from slowflow.support.errors import NotSettled
from tests.files import stored
from tests.native.records import bent
from tests.oracles import by_time

CASES = stored("stated")
DAMPING = {"mu": 0.01, "zeta": 0.03}
ABOVE_0 = {"above": 0}


def at_gap(gap, **_):
    return gap


def linear(u, **_):
    return u


def touching(u, k, c, gap):
    return u + c * np.tanh(k * (u - gap))


def one_by_one(u, k):
    """It takes no arrays."""
    return k * math.sin(u)


#: pieces and their parameters; those of stated.json by the same names
FORCES = {
    "wave": ([(lambda u, k, c: u + k * np.sin(c * u), None)], "kc"),
    "saturating": ([(lambda u, c, k: c * u + np.tanh(k * u), None)], "ck"),
    "oblique": ([(lambda u, k, c: u + 2 * k * u * (1 - c / np.sqrt(c**2 + u**2)), None)], "kc"),
    "preload": ([(lambda u, c, k: np.copysign(c + k * np.expm1(np.abs(u)), u), None)], "ck"),
    "soft_stop": ([(linear, at_gap), (touching, None)], ("c", "k", "gap")),
    "root_stop": (
        [(linear, at_gap), (lambda u, k, c, gap: u + k * (np.sqrt(1 + c * (u - gap)) - 1), None)],
        ("k", "c", "gap"),
    ),
    "pendulum": ([(one_by_one, None)], "k"),
    "quadratic": ([(lambda u, k: u + k * u * np.abs(u), None)], "k"),
    "cubic": ([(lambda u, k: k * u**3, None)], "k"),
    "play": ([(lambda u, **_: 0.0, at_gap), (lambda u, k, gap: k * (u - gap) ** 2, None)], ("k", "gap")),
}
#: their answers are not among the fast tests: some second each
SLOW = ("oblique", "preload", "saturating")


def mechanism(name, **options):
    pieces, numbers = FORCES[name]
    return derive.mechanism(name, pieces, {number: ABOVE_0 for number in numbers}, **{"reach": 3.1, **options})


def relative(found, text):
    return abs(mp.mpf(float(found)) / mp.mpf(text) - 1)


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[pytest.mark.slow] * (name in SLOW))
        for name in sorted({case["force"] for case in CASES} & set(FORCES))
    ],
)
def test_folds_states_and_onsets_are_the_certified_ones(name):
    """Of the formula, which these functions are to rounding; a fold's A moves most, by the root of an error of h."""
    for case in [case for case in CASES if case["force"] == name][:3]:
        numbers = {key: value[1] for key, value in case["parameters"].items()}
        one, F_0 = mechanism(name)(**numbers), case["F_0"][1]
        folds = one.saddle_nodes(F_0)
        assert [fold.kind for fold in folds] == [fold["kind"] for fold in case["folds"]]
        for found, sure in zip(folds, case["folds"], strict=True):
            kappa = sure["condition"]["A"] + sure["condition_kernel"]["A"]
            assert relative(found.Omega, sure["Omega"]) < 1e-12
            assert relative(found.A, sure["A"]) < 1e-14 * (10 + kappa)
        for at in case["amplitudes"]:
            found, sure = one.amplitudes(Omega=at["Omega"][1], F_0=F_0), at["steady"]
            assert found.stable.tolist() == [state["stable"] for state in sure]
            for A, known in zip(found.A, sure, strict=True):
                kappa = known["condition"]["A"] + known["condition_kernel"]["A"]
                assert relative(A, known["A"]) < 1e-14 * (10 + kappa)
        if case["onset"] is not None:
            assert relative(one.saddle_node_onset().F_SN, case["onset"]["F_SN"]) < 1e-12


@pytest.mark.parametrize(
    ("name", "numbers", "closed"),
    [
        ("pendulum", {"k": 1.3}, lambda A: -2 * mp.mpf(1.3) * mp.besselj(1, A)),
        ("quadratic", {"k": 0.7}, lambda A: -A - 8 * mp.mpf(0.7) / (3 * mp.pi) * A**2),
        ("cubic", {"k": 2.0}, lambda A: -3 * mp.mpf(2) / 4 * A**3),
    ],
)
def test_averages_are_those_of_a_closed_form(name, numbers, closed):
    model = mechanism(name)(**numbers, **DAMPING).model
    for A in (0.02, 0.3, 1.7, 3.0):
        with mp.workdps(40):
            expected = [float(mp.diff(closed, mp.mpf(A), order)) for order in range(4)]
        # of a polynomial of degree 30, which the third derivative magnifies
        for found, one, digits in zip(model.averaged(A), expected, (1e-15, 1e-14, 1e-12, 1e-11), strict=True):
            assert float(found) == pytest.approx(one, rel=4 * digits, abs=4 * digits)


def test_cubic_and_play_have_no_stiffness_at_rest():
    """Rounding would make folds at rest of either."""
    cubic = mechanism("cubic")(k=2.0, **DAMPING)
    assert cubic.model.averaged(0.0)[1] == 0
    assert not cubic.saddle_node_onset().remarks
    loose = mechanism("play")(k=3.0, gap=0.1, **DAMPING)
    assert loose.model.averaged(0.1)[0] == loose.model.averaged(0.1)[1] == 0
    assert loose.saddle_node_onset().message == ""
    assert mechanism("quadratic")(k=1e-300, **DAMPING).saddle_node_onset().F_SN is None


def test_amplitude_interval_encloses_the_average_and_its_bend():
    for name, numbers in (("soft_stop", {"c": 3.0, "k": 6.0, "gap": 0.2}), ("wave", {"k": 0.2, "c": 3.0})):
        model = mechanism(name)(**numbers, **DAMPING).model
        samples = model.mechanism.samples(*model.parameters)
        record = backend.SOLVER.record(True, name, *samples, False, False)
        edges = [1e-3, 0.1, 0.2, 0.3, 0.31, 0.8, 1.5, 3.0]
        for low, high in pairwise(edges):
            of_h, bend = bent(record, model, low, high)
            inside = np.linspace(low, high, 14)[1:-1]
            h, _, _, h_AAA = model.averaged(inside)
            assert np.all((of_h[0] <= h) & (h <= of_h[1]))
            slopes = np.diff(h_AAA) / np.diff(inside)
            doubt = 1e-8 * np.abs(slopes).max()
            assert np.all((bend[0] <= slopes + doubt) & (slopes - doubt <= bend[1]))
        assert not np.isfinite(bent(record, model, 3.0, 3.2)[0]).any()  # beyond the reach


def test_a_piece_is_within_its_bounds():
    piece = mechanism("soft_stop").record.averaged.stated.force((3.0, 6.0, 0.2)).smooth[1]
    low, length = piece.edges[:-1], np.diff(piece.edges)
    for order in (0, 4):
        least, most = piece.ranges(order)
        for fraction in (0.0, 0.3, 1.0):
            (found,) = piece.at(low + fraction * length, (order,))
            assert np.all((least <= found) & (found <= most))


@pytest.mark.slow
def test_second_approximation_and_exact_motion_are_the_forces():
    """The one against the derived force's, the other against SciPy's integration of the function itself."""
    numbers = {"c": 3.0, "k": 2.0, "gap": 0.2}
    u, c, k, gap = sp.symbols("u c k gap")
    pieces = [(u, gap), (u + c * sp.tanh(k * (u - gap)), None)]
    other = derive.mechanism("soft_stop_too", pieces, dict.fromkeys(numbers, ABOVE_0), reach=3.1)(**numbers, **DAMPING)
    one = mechanism("soft_stop")(**numbers, **DAMPING)
    assert one.detachment().u_cr == 0.2
    second, same = (each.second_approximation.saddle_nodes(F_0=0.05) for each in (one, other))
    np.testing.assert_allclose(second.Omega, same.Omega, rtol=1e-9)
    state = one.steady_state(Omega=1.1, F_0=0.1)
    pull = lambda x: touching(x, **numbers) if x > 0.2 else x  # noqa: E731
    assert by_time.largest(by_time.odd_of(pull), one, 1.1, 0.1, 60) == pytest.approx(state.A, rel=1e-4)


def test_it_says_what_it_is():
    made = mechanism("pendulum", reach_reason="it stands on its head")
    assert repr(made).endswith("; a Python function: by its values")
    one = made(k=1.0, **DAMPING)
    assert "a Python function, interpolated at 32 points" in str(one.explain("saddle_nodes", 0.05))
    assert "a Python function, interpolated at 32 points" in str(one.explain("saddle_node_onset"))
    assert "it stands on its head" in one.amplitudes(Omega=0.5, F_0=2.5).message
    with pytest.raises(NotAvailable, match="whose derivatives with respect to the parameters are unknown"):
        one.saddle_node_onset().gradient()


def test_it_can_be_pickled_where_its_functions_can():
    one = mechanism("pendulum")(k=1.0, **DAMPING)
    again = pickle.loads(pickle.dumps(one))
    assert again == one
    assert again.saddle_node_onset().F_SN == one.saddle_node_onset().F_SN
    with pytest.raises(TypeError, match=r"wave cannot be pickled, as its functions cannot: .*a module defines can"):
        pickle.dumps(mechanism("wave")(k=0.1, c=2.0, **DAMPING))


@pytest.mark.parametrize(
    ("pieces", "message"),
    [
        (
            [(lambda u: u + max(abs(u) - 0.2, 0) * np.sign(u), None)],
            r"is not resolved: with .* points .* where the function is not smooth",
        ),
        ([(lambda u: np.sign(u) * abs(u) ** 1.5, None)], "define a fractional power by a formula"),
        ([(lambda u: u + 0.3 * u**2, None)], r"0\.708 at u = 0\.6 and -0\.492 at u = -0\.6: it is not odd"),
        ([(lambda u: float("nan"), None)], r"is nan at u = .*finite"),
        ([(lambda u: [u, u], None)], "must be a real number"),
        ([(lambda u: "3", None)], "'3': it must be a real number"),
        ([(lambda u: u + 1j, None)], "must be a real number"),
        ([(lambda u: 1 / 0, None)], r"raises ZeroDivisionError at u = .*division"),
        ([(lambda u: u + 1e-9 * np.random.rand(), None)], "is not resolved: with"),
        ([(lambda u: np.tanh(3000 * u), None)], "is not resolved"),
        ([(linear, lambda: math.nan), (linear, None)], "end of piece 1 of bad is nan: it must be finite"),
        ([(linear, 0.3), (linear, 0.2), (linear, None)], r"\|u\| = 0\.3, 0\.2, 3: must ascend up to the reach"),
        ([(linear, 4), (linear, None)], "must ascend up to the reach"),
    ],
)
def test_function_that_is_no_force_is_refused_before_work(pieces, message):
    made = derive.mechanism("bad", pieces, {}, reach=3.0)
    with pytest.raises(ValueError, match=message):
        made(**DAMPING)


def test_what_cannot_be_had_is_refused_when_it_is_stated():
    def stated(*pieces, **options):
        return derive.mechanism("bad", [*pieces], {}, **{"reach": 3.0, **options})

    with pytest.raises(TypeError, match=r"piece 1 cannot be called as f\(u\): missing a required argument: 'k'"):
        stated((one_by_one, None))
    with pytest.raises(TypeError, match="piece 2 is not a Python function"):
        stated((linear, 0.1), (sp.Symbol("u"), None))
    with pytest.raises(ValueError, match="piece 1 must say where it ends"):
        stated((linear, None), (linear, None))
    for changes, message in (
        ({"reach": None}, "is sampled up to its reach"),
        ({"odd": False}, "SymPy expressions"),
        ({"compile": True}, "compiled"),
    ):
        with pytest.raises(ValueError, match=message):
            stated((linear, None), **changes)


@pytest.mark.slow
def test_motions_beyond_the_reach_are_those_of_the_function():
    """Own integration with the function itself: A = 3.4150, largest u of a half sine 3.5441."""
    pull = lambda u: u + 0.5 * np.arctan(u / 0.1)  # noqa: E731
    made = derive.mechanism("arctan", [(pull, None)], {}, reach=1.0)
    oscillator = made(**DAMPING)
    motion = oscillator.steady_state(Omega=1.2, F_0=0.6)
    assert motion.A == pytest.approx(by_time.largest(pull, oscillator, 1.2, 0.6, 90), rel=1e-5)
    assert oscillator.sweep(Omega=[1.2], F_0=0.6).A[0] == pytest.approx(motion.A)
    # a half sine of the base, and the turn after it
    shock = oscillator.transient(acceleration=3.0, duration=4.0)
    assert (shock.A, shock.a_max) == pytest.approx(by_time.shock(oscillator, pull, 3.0, 4.0, 8.0), abs=2e-3)
    assert "averaging does not evaluate the function" in shock.message
    assert oscillator.shock_spectrum(acceleration=3.0, duration=[4.0]).A[0] == pytest.approx(shock.A)
    several = made.many(**DAMPING)
    assert several.transient(acceleration=3.0, duration=4.0).A == pytest.approx(shock.A)


def test_beyond_the_reach_motions_meet_the_function_itself():
    """Beyond it force and slope are the function's; a body thrown through it turns where its energy says."""

    def force(u):
        return u + 0.5 * np.arctan(u / 0.1)

    made = derive.mechanism("arctan_too", [(force, None)], {}, reach=1.0)
    system = made(**DAMPING).equation_of_motion()
    for u in (0.5, 1.0, 1.3, 2.0, 3.5444, 40.0, -1.3, -7.0):
        piece = system.force.piece(system.force.region_of(u))
        assert piece.value(u) == pytest.approx(force(u), rel=1e-13)
        assert piece.slope(u) == pytest.approx(1.0 + 5.0 / (1.0 + (u / 0.1) ** 2), rel=1e-10)
    assert system.force(np.array([0.5, 1.5])) == pytest.approx(force(np.array([0.5, 1.5])), rel=1e-13)


def test_motions_end_where_the_function_does():
    def to_a_pole(u):
        if abs(u) > 1.0:
            raise ValueError("beyond the pole")
        return u / np.sqrt(1.0001 - u * u)

    oscillator = derive.mechanism("pole", [(to_a_pole, None)], {}, reach=0.9)(**DAMPING)
    assert oscillator.steady_state(Omega=1.2, F_0=0.02).A < 0.9
    for ask in (
        lambda: oscillator.steady_state(Omega=1.2, F_0=0.6),
        lambda: oscillator.sweep(Omega=[1.2], F_0=0.6),
        lambda: oscillator.transient(acceleration=3.0, duration=4.0),
    ):
        with pytest.raises(NotSettled, match=r"near u = -?0\.\d+: .*, or the force is not defined there"):
            ask()
