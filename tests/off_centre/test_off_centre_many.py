"""Batches off the centre have the digits of single answers, and a status where there is none."""

from __future__ import annotations

import numpy as np
import pytest

from slowflow import Duffing, Isolator, Oscillator
from slowflow.answers.results import Remark
from slowflow.example import TABLE_1
from slowflow.oscillators.isolator import ROD_SPRING
from slowflow_kernels.conventions import OnsetKind, Status


def loaded(load):
    return Isolator(**TABLE_1, load=float(load))


@pytest.mark.slow
def test_gradients_of_margins_are_refused_in_words():
    found = Isolator.many(**TABLE_1, load=[0.01, 0.03])
    with pytest.raises(ValueError, match="for offset motions, gradients are available"):
        found.margins(0.02).gradient()


@pytest.mark.slow
def test_a_design_without_an_answer_has_a_status_that_says_why():
    designs = Duffing.many([1.0, 1.0, 1.0, np.nan, -0.5, 1.0], 0.5, 0.01, [0.05, 0.0, 0.05, 0.05, 0.05, 0.05],
                           load=[0.3, 0.3, np.inf, 0.3, 0.02, 0.0])  # fmt: skip
    onset = designs.saddle_node_onset().status.tolist()
    ok, unbounded, invalid, unresolved = (Status[name] for name in ("OK", "UNBOUNDED", "INVALID", "UNRESOLVED"))
    assert onset == [ok, unbounded, invalid, invalid, unresolved, ok]
    states = designs.amplitudes(Omega=1.3, F_0=[0.2, 0.2, 0.2, 0.2, 0.2, 0.01])
    assert states.status.tolist() == [ok, unbounded, invalid, invalid, ok, Status.STICKS]
    assert designs.saddle_nodes(-1.0).status.tolist() == [invalid] * 6
    assert designs.amplitudes(Omega=1.3, F_0=0.2, max_count=1).status[0] == Status.TOO_MANY
    assert designs.frequency_response(0.2, samples=40, Omega=(0.5, 2.0), max_count=1).status[0] == Status.TOO_MANY
    # what is crossed on the way from a row that is none is not known
    rows = designs.spectrum(Omega=[1.25, -1.0, 1.6], F_0=0.2)
    assert rows.status[0].tolist() == [ok, invalid, invalid] and rows.to_xarray()["A"].dims[-1] == "row"
    assert designs.detachment().status.tolist() == [Status.NONE] * 2 + [invalid] * 2 + [Status.NONE] * 2
    # without a load the single answers of the centre stand in it
    last = designs.saddle_node_onset().F_SN[-1]
    assert last == Duffing(1.0, 0.5, 0.01, 0.05).saddle_node_onset().F_SN


def test_a_piece_without_extent_says_nothing_under_a_load():
    """Without preload the horizontal springs never touch the rod: a linear design, with its mean where it rests."""
    designs = Isolator.many(lam=3.0, r=2.0, delta_h=[0.0, 0.05], mu=0.01, zeta=0.05, load=0.05)
    linear = Duffing(1.0, 0.0, 0.01, 0.05)
    for found, expected in (
        (designs.amplitudes(Omega=0.9, F_0=0.1), linear.amplitudes(Omega=0.9, F_0=0.1)),
        (designs.peak(0.1), linear.peak(0.1)),
    ):
        assert found.status.tolist() == [Status.OK, Status.OK]
        assert np.ravel(found.A[0])[0] == pytest.approx(np.ravel(expected.A)[0], rel=1e-14)
        assert np.ravel(found.B[0])[0] == pytest.approx(0.05, rel=1e-13)
    assert designs.saddle_node_onset().status.tolist() == [Status.NONE, Status.OK]
    one = Oscillator(ROD_SPRING, lam=3.0, r=2.0, delta_h=0.0, zeta=0.05, load=0.05)
    assert "one piece only" in one.detachment().message
    assert designs.rest().u[0, 0] == pytest.approx(0.05, rel=1e-13)


@pytest.mark.slow
def test_what_the_message_of_a_single_answer_says_is_a_remark():
    designs = Isolator.many(**TABLE_1, load=[0.03, 0.1])
    onset = designs.saddle_node_onset()
    assert onset.remarks.tolist() == [0, Remark.OF_TRUNCATION]
    assert loaded(0.1).saddle_node_onset().kind == "corner"
    rows = onset.columns()
    assert rows["load"].tolist() == [0.03, 0.1] and rows["B"].tolist() == onset.B.tolist()
    table = designs.amplitudes(Omega=0.9, F_0=0.04).columns()
    assert {"load", "Omega", "F_0", "A_0", "B_0", "phi_0"} <= table.keys()


def test_onset_where_the_slope_of_the_force_jumps():
    """It was a cusp, whose slopes were up to five times too small there."""
    numbers = {"lam": 3.0, "r": 1.0, "delta_h": 0.1, "mu": 0.005, "load": -0.04}
    many = Isolator.many(**numbers, zeta=[0.07, 0.09], force="untruncated").saddle_node_onset()
    one = Isolator(**numbers, zeta=0.09, force="untruncated").saddle_node_onset()
    assert many.kind.tolist() == [OnsetKind.CUSP, OnsetKind.CORNER] and one.kind == "corner" and not one.message
    assert one.A - one.B == pytest.approx(Isolator(**numbers, zeta=0.09).breakpoints[0], rel=1e-15)
    slopes = many.gradient()
    assert slopes.status.tolist() == [0, 0] and slopes["F_SN"][1].tolist() == one.gradient()["F_SN"].tolist()


def test_batch_questions_without_asymmetric_answer_are_refused():
    with pytest.raises(ValueError, match="load is not available with contact = 'attached'"):
        Isolator.many(**TABLE_1, load=0.1, contact="attached")
    with pytest.raises(ValueError, match="defined at one frequency"):
        Isolator.many(**TABLE_1, load=0.1, eta=0.02).shock_spectrum(acceleration=0.1, duration=2.0)
    with pytest.raises(ValueError, match="shapes"):
        Isolator.many(**TABLE_1, load=[0.1, 0.2]).saddle_nodes([0.03, 0.04, 0.05])


@pytest.mark.parametrize(
    "parameters",
    [{"beta": 1e-310, "load": -0.09}, {"beta": 0.0, "load": 1.7e308}, {"beta": 0.1, "load": 1.7e308}],
    ids=["hardly a spring", "linear", "Duffing"],
)
def test_motions_beyond_doubles_are_refused(parameters):
    """By a status in a batch; Python's message about its integers was passed on."""
    parameters = {"alpha": 1.0, **parameters, "mu": 0.01, "zeta": 0.05}
    one, many = Duffing(**parameters), Duffing.many(**parameters)
    for query in (
        lambda of: of.saddle_nodes(0.05),
        lambda of: of.amplitudes(Omega=0.9, F_0=0.05),
        lambda of: of.peak(0.05),
    ):
        with pytest.raises(OverflowError, match=r"offset motions are unresolved: .* beyond the range of doubles"):
            query(one)
        assert query(many).status == Status.NO_BOUND
    assert "beyond the range of doubles" in one.saddle_node_onset().message


def test_centred_question_is_no_attribute_and_says_why():
    """`hasattr` and `getattr` with a default are how a program finds out, and raised instead."""
    designs = Isolator.many(**TABLE_1, load=[0.01])
    assert not hasattr(designs, "what") and not hasattr(designs, "cusps")
    for name in ("certify", "at_rest", "second_approximation"):
        assert not hasattr(designs, name) and getattr(designs, name, None) is None
        with pytest.raises(ValueError, match="it assumes motion about the centre"):
            getattr(designs, name)
    assert hasattr(designs, "peak") and not hasattr(Isolator(**TABLE_1, load=0.01).model, "averaged")


@pytest.mark.slow
def test_designs_with_loads_beside_are_answered_as_before():
    """Of the second R^2 + m^2 = F_0^2 is a cubic in A, as there is no viscous damping."""
    onsets = Duffing.many(1.0, -0.3, zeta=0.02, excitation="unbalance", load=[0.0, 0.05]).saddle_node_onset()
    assert onsets.F_SN[0] == pytest.approx(0.0212923, rel=1e-5) and onsets.B[0] == 0
    states = Duffing.many(1.0, 0.3, mu=0.01, zeta=0.0, load=[0.0, 0.05]).amplitudes(Omega=0.9, F_0=0.05)
    A = np.roots([0.225, 0.0, 1 - 0.81, -np.sqrt(0.05**2 - (0.04 / np.pi) ** 2)])
    assert states.A[0, 0] == pytest.approx(A[abs(A.imag) < 1e-12].real.max(), rel=1e-12)
    assert states.status.tolist() == [Status.OK, Status.UNBOUNDED]


def test_a_force_at_the_end_of_doubles_leaves_others_gradients():
    """Its gains are infinite, and their product with what vanishes is no number: nobody is warned of that."""
    found = Isolator.many(lam=[1e-160, 0.5], r=[1.7e308, 0.5], delta_h=0.5, mu=0.8, zeta=1.0, load=1.0).rest()
    single = Isolator.many(lam=[0.5], r=[0.5], delta_h=0.5, mu=0.8, zeta=1.0, load=1.0).rest().gradient()
    assert np.array_equal(found.gradient().slopes[1], single.slopes[0], equal_nan=True)
