"""Batches off the centre have the digits of single answers, and a status where there is none."""

from __future__ import annotations

import numpy as np
import pytest

from slowflow import Duffing, Isolator, derive
from slowflow.example import TABLE_1
from slowflow.results import Remark
from slowflow_kernels.conventions import FoldKind, MovesStatus, OnsetKind, Status


def alone(load):
    return Isolator(**TABLE_1, load=float(load))


@pytest.mark.slow
def test_gradients_of_margins_are_refused_in_words():
    found = Isolator.many(**TABLE_1, load=[0.01, 0.03])
    with pytest.raises(ValueError, match="this answer has none"):
        found.margins(0.02).gradient()


@pytest.mark.slow
@pytest.mark.parametrize(
    "ask",
    [
        lambda one: one.detachment(),
        lambda one: one.saddle_node_onset(),
        lambda one: one.saddle_nodes(0.04),
        lambda one: one.amplitudes(Omega=0.9, F_0=0.04),
        lambda one: one.peak(0.04),
        lambda one: one.isolation(0.04),
        lambda one: one.rest(),
    ],
    ids=["detachment", "onset", "folds", "states", "peak", "isolation", "rest"],
)
@pytest.mark.part(3)
def test_each_design_has_the_gradient_of_its_single_answer(ask):
    """One of them is none; the last comes to its springs' end at rest."""
    loads = np.array([0.01, 0.03, np.nan, 0.45])
    with np.errstate(invalid="ignore"):
        found = ask(Isolator.many(**TABLE_1, load=loads))
    moved = found.gradient()
    assert moved.slopes.shape == (*getattr(found, moved.of[0]).shape, len(moved.of), len(moved.by))
    assert (moved.status[2] == MovesStatus.NOTHING).all() and np.isnan(moved.slopes[2]).all()
    for row in (0, 1, 3):
        single = ask(alone(loads[row]))
        if found.status[row] != Status.OK:
            assert (moved.status[row] == MovesStatus.NOTHING).all()
            continue
        expected = single.gradient()
        assert moved.by == expected.by
        several = expected.status.ndim > 0
        for name in expected.of:
            here = moved[name][row]
            wanted = expected[name]
            assert np.array_equal(here[: len(wanted)] if several else here, wanted, equal_nan=True)
            condition, alone_ = moved.condition(name)[row], expected.condition(name)
            np.testing.assert_allclose(condition[: len(alone_)] if several else condition, alone_, rtol=1e-14)
        if several:
            assert (moved.status[row, len(single) :] == MovesStatus.NOTHING).all()


@pytest.mark.slow
def test_each_design_has_the_digits_of_its_single_answer():
    loads = np.array([[0.01], [0.03]])
    designs = Isolator.many(**TABLE_1, load=loads)
    detached, onset = designs.detachment(), designs.saddle_node_onset()
    folds, states = designs.saddle_nodes(0.04), designs.amplitudes(Omega=[0.9, 1.1], F_0=0.04)
    assert detached.F_cr.shape == onset.F_SN.shape == (2, 1) and states.A.shape == (2, 2, 6)
    for row, load in enumerate(loads.ravel()):
        single = alone(load).detachment()
        assert [getattr(detached, name)[row, 0] for name in ("F_cr", "Omega_cr", "A", "B")] == [
            single.F_cr, single.Omega_cr, single.A, single.B,
        ]  # fmt: skip
        single = alone(load).saddle_node_onset()
        assert [getattr(onset, name)[row, 0] for name in ("F_SN", "Omega", "A", "B")] == [
            single.F_SN, single.Omega, single.A, single.B,
        ]  # fmt: skip
        assert OnsetKind(onset.kind[row, 0]).name.lower() == single.kind
        single = alone(load).saddle_nodes(0.04)
        n = folds.count[row, 0]
        assert n == len(single) and np.array_equal(folds.Omega[row, 0, :n], single.Omega)
        assert np.array_equal(folds.B[row, 0, :n], single.B) and np.isnan(folds.A[row, 0, n:]).all()
        assert [FoldKind(kind).name for kind in folds.kind[row, 0, :n]] == ["JUMP_UP", "JUMP_DOWN"]
        for column, Omega in enumerate((0.9, 1.1)):
            single = alone(load).amplitudes(Omega=Omega, F_0=0.04)
            n = states.count[row, column]
            assert n == len(single) and np.array_equal(states.stable[row, column, :n], single.stable)
            for name in ("A", "B", "phi"):
                assert np.array_equal(getattr(states, name)[row, column, :n], getattr(single, name))
    assert not (states.status.any() or states.remarks.any() or states.undecided.any())


@pytest.mark.slow
def test_what_an_engineer_asks_of_many_designs_has_the_digits_of_single_answers():
    designs = Duffing.many([1.0, 1.2], 0.5, 0.01, 0.05, load=[0.3, 0.2])
    F_0 = 0.2
    found = {name: getattr(designs, name)(F_0) for name in ("peak", "margins", "hysteresis", "isolation")}
    rests = designs.rest()
    for row, single in enumerate((Duffing(1.0, 0.5, 0.01, 0.05, load=0.3), Duffing(1.2, 0.5, 0.01, 0.05, load=0.2))):
        for question, names in {
            "peak": ("A", "B", "Omega", "u_max", "Omega_max"),
            "margins": ("F_SN", "of_SN", "folds", "detaches", "sticks", "Omega_sticks", "remarks"),
            "isolation": ("Omega", "A", "at_fold"),
        }.items():
            one = getattr(single, question)(F_0)
            assert [getattr(found[question], name)[row] for name in names] == [getattr(one, name) for name in names]
        (band,) = single.hysteresis(F_0)
        bands = found["hysteresis"]
        assert (bands.Omega_low[row, 0], bands.Omega_high[row, 0], bands.motions[row, 0], bands.count[row]) == (
            *band,
            1,
        )
        assert rests.u[row, 0] == single.rest().u[0] and rests.stiffness[row, 0] == pytest.approx(
            single.stiffness(rests.u[row, 0]), rel=1e-14
        )
    assert np.isposinf(found["margins"].F_cr).all() and np.isposinf(found["margins"].of_cr).all()
    assert designs.peak([0.2, 0.01]).status.tolist() == [Status.OK, Status.STICKS]
    assert designs.margins([0.2, 0.01]).sticks.tolist() == [0, 1]
    assert not any(answer.status.any() for answer in (*found.values(), rests))


@pytest.mark.slow
def test_curves_of_many_designs_have_the_points_of_single_ones():
    """The last has no points, as it sticks; the forcing broadcasts."""
    designs = Duffing.many([1.0, 1.2, 1.0], 0.5, 0.01, 0.05, load=[0.3, 0.2, 0.3])
    found = designs.frequency_response([0.2, 0.2, 0.01], samples=40, Omega=(0.5, 2.0))
    assert found.A.shape == (3, 104) and found.fold_A.shape == (3, 6)
    assert found.status.tolist() == [Status.OK, Status.OK, Status.STICKS]
    rows = found.columns()
    for row, single in enumerate((Duffing(1.0, 0.5, 0.01, 0.05, load=0.3), Duffing(1.2, 0.5, 0.01, 0.05, load=0.2))):
        curve, folds = single.frequency_response(0.2, samples=40, Omega=(0.5, 2.0)), single.saddle_nodes(0.2)
        n, m = found.points[row], found.count[row]
        assert n == len(curve) > 40 and m == len(folds) == 2
        for name in ("Omega", "A", "B", "stable", "branch"):
            assert np.array_equal(getattr(found, name)[row, :n], getattr(curve, name)), name
            assert np.array_equal(rows[name][rows["load"] == single.load], getattr(curve, name)), name
        assert not found.isola[row, :n].any() and np.array_equal(found.fold_Omega[row, :m], folds.Omega)
        assert np.isnan(found.B[row, n:]).all() and (found.branch[row, n:] == -1).all()
    assert np.isnan(found.A[2]).all() and found.points[2] == 0 and not found.remarks.any()
    short = designs.frequency_response(0.2, samples=40, Omega=(0.5, 2.0), places=1)
    assert short.status.tolist() == [Status.TOO_MANY] * 3


def test_a_design_without_an_answer_has_a_status_that_says_why():
    designs = Duffing.many([1.0, 1.0, 1.0, np.nan, -0.5, 1.0], 0.5, 0.01, [0.05, 0.0, 0.05, 0.05, 0.05, 0.05],
                           load=[0.3, 0.3, np.inf, 0.3, 0.02, 0.0])  # fmt: skip
    onset = designs.saddle_node_onset().status.tolist()
    ok, unbounded, invalid, unresolved = (Status[name] for name in ("OK", "UNBOUNDED", "INVALID", "UNRESOLVED"))
    assert onset == [ok, unbounded, invalid, invalid, unresolved, ok]
    states = designs.amplitudes(Omega=1.3, F_0=[0.2, 0.2, 0.2, 0.2, 0.2, 0.01])
    assert states.status.tolist() == [ok, unbounded, invalid, invalid, ok, Status.STICKS]
    assert designs.saddle_nodes(-1.0).status.tolist() == [invalid] * 6
    assert designs.amplitudes(Omega=1.3, F_0=0.2, places=1).status[0] == Status.TOO_MANY
    assert designs.detachment().status.tolist() == [Status.NONE] * 2 + [invalid] * 2 + [Status.NONE] * 2
    # without a load the single answers of the centre stand in it
    last = designs.saddle_node_onset().F_SN[-1]
    assert last == Duffing(1.0, 0.5, 0.01, 0.05).saddle_node_onset().F_SN


@pytest.mark.slow
def test_what_the_message_of_a_single_answer_says_is_a_remark():
    designs = Isolator.many(**TABLE_1, load=[0.03, 0.1])
    onset = designs.saddle_node_onset()
    assert onset.remarks.tolist() == [0, Remark.OF_TRUNCATION]
    assert alone(0.1).saddle_node_onset().kind == "corner"
    rows = onset.columns()
    assert rows["load"].tolist() == [0.03, 0.1] and rows["B"].tolist() == onset.B.tolist()
    table = designs.amplitudes(Omega=0.9, F_0=0.04).columns()
    assert {"load", "Omega", "F_0", "A_0", "B_0", "phi_0"} <= table.keys()


def test_shocks_of_many_designs_begin_where_each_rests():
    """The last two have two wells, and no place of rest."""
    loads, alpha = np.array([0.3, 0.0, 0.02, 0.6]), np.array([1.0, 1.0, -0.5, 1.0])
    designs = Duffing.many(alpha, [0.5, 0.5, 0.5, -0.5], 0.01, 0.05, load=loads)
    tau = np.linspace(0.0, 1.5, 30)
    pulse = 0.8 * np.sin(np.pi * tau / 1.5)
    half, record = designs.transient(acceleration=0.8, duration=1.5), designs.transient(acceleration=pulse, tau=tau)
    spectrum = designs.shock_spectrum(acceleration=0.8, duration=[[1.5], [3.0]])
    assert spectrum.A.shape == (2, 4) and half.stands.tolist() == [1, 1, 2, 0]
    for k in range(3):
        single = Duffing(alpha[k], 0.5, 0.01, 0.05, load=loads[k])
        for found, one in (
            (half, single.transient(acceleration=0.8, duration=1.5)),
            (record, single.transient(acceleration=pulse, tau=tau)),
        ):
            names = ("A", "tau_A", "a_max", "tau_a", "detaches", "rests", "u_end")
            assert [getattr(found, name)[k] for name in names] == [getattr(one, name) for name in names]
            assert ("several stable places" in one.message) == (found.stands[k] > 1)
        for row, pulse_of in enumerate(single.shock_spectrum(acceleration=0.8, duration=[1.5, 3.0])):
            names = ("A", "a_max", "ratio", "detaches")
            assert [getattr(spectrum, name)[row, k] for name in names] == [getattr(pulse_of, name) for name in names]
    assert half.status[3] == Status.UNRESOLVED and np.isnan(half.A[3])
    assert designs.transient(acceleration=0.8, duration=-1.0).status.tolist() == [Status.INVALID] * 4
    with pytest.raises(ValueError, match="either its duration"):
        designs.transient(acceleration=0.8)
    assert {"load", "acceleration", "duration", "ratio"} <= spectrum.columns().keys()


@pytest.mark.slow
def test_load_spectra_of_many_designs_have_the_digits_of_single_ones():
    loads = np.array([0.3, 0.2])
    designs = Duffing.many([1.0, 1.2], 0.5, 0.01, 0.05, load=loads)
    Omega, F_0 = [1.25, 1.6, 1.25, -1.0, 1.6], [0.2, 0.2, 0.2, 0.2, 0.01]
    found = designs.spectrum(Omega=Omega, F_0=F_0)
    assert found.A.shape == (2, 5) and found.crosses.any()
    for k, alpha in enumerate((1.0, 1.2)):
        single = Duffing(alpha, 0.5, 0.01, 0.05, load=loads[k])
        rows = single.spectrum(Omega=Omega[:3], F_0=F_0[:3])
        for name in ("A", "transmissibility_dB", "motions", "crosses", "detaches", "sticks"):
            assert getattr(found, name)[k, :3].tolist() == getattr(rows, name).tolist(), name
        assert found.sticks[k, 4] == 1 and found.A[k, 4] == 0
        # what is crossed on the way from a row that is none is not known
        assert found.status[k].tolist() == [*[Status.OK] * 3, Status.INVALID, Status.INVALID]
        said = [single.amplitudes(Omega=O, F_0=F).remarks for O, F in zip(Omega[:3], F_0[:3], strict=True)]
        assert found.remarks[k, :3].tolist() == said
    assert found.columns()["load"].tolist() == [0.3] * 5 + [0.2] * 5 and found.to_xarray()["A"].dims[-1] == "row"


@pytest.mark.slow
def test_a_force_that_is_not_odd_has_batches_too():
    import sympy as sp

    u, k, g = sp.symbols("u k g")
    stop = derive.mechanism(
        "one_sided_stop", [(u, g), (u + k * (u - g), None)], {"k": {"above": 0}, "g": {}}, odd=False
    )
    found = stop.many(k=[2.0, 8.0], g=0.2, mu=0.005, zeta=0.03).amplitudes(Omega=1.1, F_0=0.03)
    for row, k in enumerate((2.0, 8.0)):
        single = stop(k=k, g=0.2, mu=0.005, zeta=0.03).amplitudes(Omega=1.1, F_0=0.03)
        assert np.array_equal(found.A[row, : found.count[row]], single.A) and len(single) == 3


def test_what_batches_have_no_answer_to_off_the_centre_is_refused_in_words():
    designs = Isolator.many(**TABLE_1, load=[0.03, 0.1])
    for name in ("at_rest", "certify", "second_approximation"):
        with pytest.raises(ValueError, match="motions about the centre"):
            getattr(designs, name)
    with pytest.raises(ValueError, match="load is not available with rubs = 'attached'"):
        Isolator.many(**TABLE_1, load=0.1, rubs="attached")
    with pytest.raises(ValueError, match="stated at one frequency"):
        Isolator.many(**TABLE_1, load=0.1, eta=0.02).shock_spectrum(acceleration=0.1, duration=2.0)
    with pytest.raises(ValueError, match="no polynomial"):
        Isolator.many(**TABLE_1, load=0.1, force="untruncated")
    with pytest.raises(ValueError, match="shapes"):
        Isolator.many(**TABLE_1, load=[0.1, 0.2]).saddle_nodes([0.03, 0.04, 0.05])
    assert not hasattr(designs, "nothing_of_the_kind")


@pytest.mark.parametrize(
    "given",
    [{"beta": 1e-310, "load": -0.09}, {"beta": 0.0, "load": 1.7e308}, {"beta": 0.1, "load": 1.7e308}],
    ids=["hardly a spring", "linear", "Duffing"],
)
def test_motions_beyond_the_range_of_doubles_are_refused_in_words(given):
    """In a batch by a status; words of Python about its integers were passed on."""
    given = {"alpha": 1.0, **given, "mu": 0.01, "zeta": 0.05}
    one, many = Duffing(**given), Duffing.many(**given)
    for asked in (
        lambda of: of.saddle_nodes(0.05),
        lambda of: of.amplitudes(Omega=0.9, F_0=0.05),
        lambda of: of.peak(0.05),
    ):
        with pytest.raises(OverflowError, match=r"off the centre are unresolved: .* beyond the range of doubles"):
            asked(one)
        assert asked(many).status == Status.NO_BOUND
    assert "beyond the range of doubles" in one.saddle_node_onset().message


def test_a_question_about_the_centre_is_no_attribute_and_says_why():
    """`hasattr` and `getattr` with a default are how a program finds out, and raised instead."""
    designs = Isolator.many(**TABLE_1, load=[0.01])
    for name in ("certify", "at_rest", "second_approximation", "cusps", "what"):
        assert not hasattr(designs, name) and getattr(designs, name, None) is None
    with pytest.raises(ValueError, match="not available, this question is about motions about the centre"):
        getattr(designs, "certify")  # noqa: B009  a bare expression would be one without use
    assert hasattr(designs, "peak") and not hasattr(Isolator(**TABLE_1, load=0.01).model, "averaged")
