"""The second approximation against exact motions, Den Hartog's closed form, and the order of its error."""

from __future__ import annotations

import copy
import os
import pickle
import platform
import subprocess
import sys
from typing import Any, NamedTuple

import numpy as np
import pytest
from mpmath import mp, mpf
from scipy.optimize import brentq

from derivations.extensions.second_approximation import friction_sum
from slowflow import Duffing, Isolator
from slowflow.answers.answer import joined
from slowflow.averaged.questions import Averaged
from slowflow.core import backend
from slowflow.example import isolator
from slowflow_kernels import den_hartog
from slowflow_kernels.conventions import Status
from slowflow_kernels.second_conventions import BEYOND, Wanted
from tests.files import stored
from tests.oracles.balance import Balance

FORCES = ("truncated", "untruncated")
SOLVER = backend.SOLVER


class Curve(NamedTuple):
    """Points as the compiled solvers have them, A as in the kernels."""

    Omega: Any
    u_max: Any
    A_1: Any
    phi: Any
    stable: Any
    A: Any
    branch: Any
    closed: Any
    lost: int


def curve_of(model, F_0, samples, window, request=Wanted.EVERY_POINT):
    status, *columns, _, _, _ = SOLVER.second_curve(model.native, F_0, request, samples, *window)
    assert status == Status.OK
    return Curve(*columns)


def folds_about(model, F_0, low=np.inf, high=np.inf):
    """Omega, u_max, A_1, up and corner of each; how many are lost, of how many; points of averaging's that are lost."""
    found = SOLVER.second_saddle_nodes(model.native, F_0, low, high)
    status, Omega, u_max, up, corner, _, A_1, undecided, *lost, of, _, _ = found
    columns = Omega, u_max, A_1, up, corner
    return None if status != Status.OK or undecided or not of else (*map(np.ndarray.tolist, columns), *lost)


def test_a_motion_that_leaves_the_centre_is_not_stable():
    """Between two wells, as averaging says: the exact one has a multiplier of 31, and falls into one of them."""
    one, at = Duffing(-0.5, 1.0, 0.0, 0.05), {"Omega": 1.2, "F_0": 0.05}
    states = one.second_approximation.amplitudes(**at)
    exact = one.steady_state(**at, A=float(states.A[0]))
    assert states.stable.tolist() == one.amplitudes(**at).stable.tolist() == [False]
    assert exact.A == pytest.approx(states.A[0], rel=1e-3) and not exact.stable
    curve = one.second_approximation.frequency_response(0.05, Omega=(1.1, 1.3))
    assert len(curve) and not curve.stable.any()
    assert not Duffing.many(-0.5, 1.0, 0.0, [0.05]).second_approximation.amplitudes(**at).stable.any()


@pytest.mark.parametrize("order", [0, 1, 2])
@pytest.mark.parametrize("kappa", ["-8.9", "0.3", "1", "8.5"])
def test_the_sum_over_frictions_harmonics(order, kappa):
    """pi tan(pi k/2)/(4 k) - 1/(1 - k^2), as a sum."""
    import sympy as sp

    symbol = sp.Symbol("kappa")
    with mp.workdps(30):
        value = mpf(kappa)
        expected = mp.nsum(lambda j: mp.factorial(order) / ((2 * j + 1) ** 2 - value) ** (order + 1), [1, mp.inf])
        found = friction_sum(symbol, order).subs(symbol, sp.Float(kappa, 30))
        assert abs(mpf(str(sp.N(found, 25))) / expected - 1) < mpf(10) ** -15


@pytest.mark.parametrize("Omega", [0.8, 1.3])
def test_the_largest_displacement_is_one_order_closer(Omega):
    """Of the nonlinearity, without friction: the error falls faster than averaging's by a power of beta."""
    for beta in (0.2, 0.1, 0.05, 0.025):
        oscillator = Duffing(1.0, beta, 0.0, 0.02)
        averaged = oscillator.amplitudes(Omega=Omega, F_0=0.3)
        exact = oscillator.steady_state(Omega=Omega, F_0=0.3, A=averaged.A[0]).A
        better = oscillator.second_approximation.amplitudes(Omega=Omega, F_0=0.3)
        assert better.A.size == averaged.A.size and not better.message
        assert 0.002 * beta < abs(averaged.A[0] / exact - 1) < 0.04 * beta
        assert abs(better.A[0] / exact - 1) < 0.03 * beta * abs(averaged.A[0] / exact - 1)


@pytest.mark.parametrize("ratio", [0.05, 0.2, 0.3])
@pytest.mark.parametrize("Omega", [0.5, 0.8, 1.2, 2.0])
def test_for_a_linear_spring_it_is_den_hartogs_solution(Omega, ratio):
    """(35) is exact without stops, and far from what averaging says."""
    if float(den_hartog.bound(Omega, 1.0, slope(Omega))) > (exact := float(den_hartog.amplitude(Omega, 1.0, ratio))):
        pytest.skip("the motion has stops")
    oscillator = Duffing(1.0, 0.0, ratio, 0.0)
    (averaged,), (better,) = (
        one.amplitudes(Omega=Omega, F_0=1.0).A for one in (oscillator, oscillator.second_approximation)
    )
    assert abs(better / exact - 1) < 1e-13
    assert abs(averaged / exact - 1) > 1e-4


def slope(Omega):
    """S of (37), the maximum over half a cycle, by sampling."""
    return float(den_hartog.S_ratio(np.linspace(1e-3, 1, 2000)[:-1] * np.pi / Omega, Omega).max())


@pytest.mark.parametrize("force", FORCES)
def test_the_folds_of_table_1_come_closer_to_the_exact_ones(force):
    """Fifty times at least, both jumps of Fig. 7a's forcing; and the largest displacements."""
    iso = isolator(force=force)
    exact = iso.exact_response(0.04, Omega=(0.8, 1.05), step=0.05).folds
    exact = sorted(exact, key=lambda fold: fold.Omega)
    averaged, better = iso.saddle_nodes(0.04), iso.second_approximation.saddle_nodes(0.04)
    assert better.kind.tolist() == averaged.kind.tolist() == [fold.kind for fold in exact]
    Omega, A = (np.array([getattr(fold, name) for fold in exact]) for name in ("Omega", "A"))
    assert np.all(np.abs(better.Omega / Omega - 1) < 0.02 * np.abs(averaged.Omega / Omega - 1))
    assert np.all(np.abs(better.Omega / Omega - 1) < 2e-5)
    assert np.all(np.abs(better.A / A - 1) < 1e-3)


def test_the_critical_force_without_friction_comes_closer():
    """F_cr is where the exact motion just reaches u_cr: averaging says 2 % too much, as it leaves out a_3."""
    iso = isolator(mu=0.0, force="untruncated")
    averaged, better = iso.detachment(), iso.second_approximation.detachment()
    F_cr, u_cr = better.F_cr, better.u_cr

    def highest(F_0):
        return iso.exact_response(F_0, Omega=(0.6, 1.05), step=0.05).A.max()

    # a curve's highest point is read off its points, 1e-4 below the peak
    assert highest(F_cr * (1 - 0.001)) < u_cr < highest(F_cr * (1 + 0.001))
    assert averaged.F_cr > 1.015 * F_cr


@pytest.mark.parametrize(
    "design",
    [
        {"lam": 4, "r": 1.392, "delta_h": 0.0916, "mu": 0.0313, "zeta": 0.0713},
        {"lam": 1, "r": 2.898, "delta_h": 0.2074, "mu": 0.0255, "zeta": 0.056},
    ],
)
def test_the_critical_force_with_friction_comes_closer(design):
    """Where the truncated force jumps, and friction's harmonics leave the largest displacement below A."""
    iso = Isolator(**design)
    averaged, better = iso.detachment(), iso.second_approximation.detachment()
    window = (0.95 * better.Omega_cr, 1.05 * better.Omega_cr)

    def highest(F_0):
        """Of the curve through the resonance; a mass at rest may come to another one."""
        start = iso.steady_state(Omega=better.Omega_cr, F_0=F_0, A=better.u_cr)
        return iso.exact_response(F_0, Omega=window, start=start).peak.A

    off, far = (abs(highest(one.F_cr) / one.u_cr - 1) for one in (better, averaged))
    assert off < 5e-4 < 4e-3 < far


def test_without_damping_any_force_reaches_the_breakpoint():
    iso = isolator(mu=0.0, zeta=0.0)
    averaged, better = iso.detachment(), iso.second_approximation.detachment()
    assert averaged.F_cr == 0 and better.F_cr < 1e-12
    assert 1e-3 < 1 - better.Omega_cr / averaged.Omega_cr < 1e-2


@pytest.mark.parametrize("force", FORCES)
@pytest.mark.parametrize(
    "changes", [{}, {"mu": 0.0}, {"zeta": 0.005, "delta_h": 0.13, "mu": 0.0}, {"zeta": 0.1, "delta_h": 0.03}]
)
def test_the_balance_is_met_on_the_curve(force, changes):
    """Its points solve the second approximation, each branch without a gap, also across u_cr."""
    iso = isolator(force=force, **changes)
    second, F_0 = iso.second_approximation, 1.3 * iso.detachment().F_cr
    shown = (0.8 * iso.backbone(0.1 * iso.u_cr), 1.2 * iso.backbone(1.4 * iso.u_cr))
    first = iso.curve(F_0, samples=1000, Omega=shown)
    balance = Balance(iso.model)
    curve = curve_of(iso.model, F_0, 1000, shown)
    _, _, _, _, F, *_ = balance.response(curve.Omega, curve.A, F_0)
    assert np.abs(F).max() < 1e-10 * F_0**2
    assert curve.lost == 0 and curve.A.size >= first.A.size
    x, y = np.diff(np.log(curve.Omega)), np.diff(np.log(curve.A))
    assert np.all(np.hypot(x, y)[np.diff(curve.branch) == 0] < 0.1)
    assert np.count_nonzero(curve.stable[1:] != curve.stable[:-1]) == len(second.saddle_nodes(F_0))


@pytest.mark.parametrize("zeta", [0.0, 1e-5])
def test_next_to_no_viscous_damping_the_points_keep_their_order(zeta):
    """Without a peak, or with one that is sharp as a needle."""
    iso = isolator(mu=0.0, zeta=zeta)
    first = iso.frequency_response(0.02, Omega=(0.6, 1.1))
    curve = iso.second_approximation.frequency_response(0.02, Omega=(0.6, 1.1))
    assert curve.A.size > 0.95 * first.A.size
    assert curve.isola == (first.isola if zeta else (False, False))
    for branch in np.unique(curve.branch):
        largest = []
        for one in (first, curve):
            x, y = (np.diff(np.log(values[one.branch == branch])) for values in (one.Omega, one.A))
            largest.append(np.hypot(x, y).max())
        assert largest[1] < 1.1 * largest[0]


#: designs on which points once overtook each other, or a curve went on across what had been left out; F_0, force
WITH_ORDER = (
    ({"lam": 1, "r": 1.761, "delta_h": 0.0456, "mu": 0.00758, "zeta": 0.01476}, 0.0174, "untruncated"),
    ({"lam": 2, "r": 1.31, "delta_h": 0.262, "mu": 0.0045, "zeta": 0.027}, 0.0753, "truncated"),
    ({"lam": 4, "r": 1.39, "delta_h": 0.092, "mu": 0.031, "zeta": 0.0713}, 0.1539, "truncated"),
    ({"lam": 1, "r": 2.71, "delta_h": 0.263, "mu": 0.0004, "zeta": 0.0351}, 0.0419, "truncated"),
)


@pytest.mark.parametrize(("design", "F_0", "force"), WITH_ORDER)
def test_the_frequency_turns_only_at_folds(design, F_0, force):
    """Points in order along the curve, whatever way each was moved."""
    second = Isolator(**design, force=force).second_approximation
    curve = second.frequency_response(F_0)
    turns = 0
    for branch in np.unique(curve.branch):
        way = np.sign(np.diff(curve.Omega[curve.branch == branch]))
        turns += np.count_nonzero(np.diff(way[way != 0]))
    assert turns == len(second.saddle_nodes(F_0))


def test_a_branch_ends_where_points_are_left_out():
    """A part of the curve that the second approximation does not have is no straight line."""
    iso = isolator(delta_h=0.25)
    curve = iso.second_approximation.frequency_response(0.05)
    assert "left out" in curve.message
    assert len(curve.isola) == len(np.unique(curve.branch)) and curve.branch.max() == len(curve.isola) - 1
    same = np.diff(curve.branch) == 0
    assert np.hypot(np.diff(np.log(curve.Omega)), np.diff(np.log(curve.A)))[same].max() < 0.1


def test_harmonics_on_a_curve_are_small():
    """Also friction's: next to the third harmonic's resonance they once took nine tenths off u_max."""
    curve = Duffing(1.0, -0.3, 0.01, 0.05).second_approximation.frequency_response(0.2)
    assert np.all(np.abs(np.log(curve.A_1 / curve.A)) < 0.5)


def test_of_no_state_nothing_is_transmitted():
    passed = Duffing(1.0, 0.5, 0.01, 0.02).second_approximation.amplitudes(Omega=[], F_0=0.1).transmitted()
    assert passed.first.size == passed.peak.size == passed.rms.size == 0


def test_what_is_not_there_is_told_in_words():
    second = isolator().second_approximation
    stuck = second.frequency_response(0.01)
    assert stuck.A.size == 0 and "sticks" in stuck.message
    assert len(second.saddle_nodes(0.01)) == 0 and "sticks" in second.saddle_nodes(0.01).message
    assert second.amplitudes(Omega=0.9, F_0=0.01).A.tolist() == [0.0]
    single = isolator(delta_h=0).second_approximation.saddle_nodes(0.018)
    assert len(single) == 0 and all(remark in single.message for remark in ("no saddle node", "left out"))
    low = second.frequency_response(0.04, Omega=(0.05, 0.2))
    assert "left out" in low.message and low.A.size == 0
    linear = isolator(delta_h=0).second_approximation
    assert linear.detachment().F_cr is None and linear.detachment().message
    assert linear.saddle_node_onset().F_SN is None and linear.saddle_node_onset().message
    assert joined(linear.saddle_nodes(0.04).message)


def test_question_it_does_not_answer_is_refused():
    second = isolator().second_approximation
    unanswered = [name for name in dir(Averaged) if not name.startswith("_") and not hasattr(second, name)]
    facts = {"model", "mu", "zeta", "sticking_forcing", "breakpoints", "curve", "states", "folds", "onset", "closes"}
    for name in set(unanswered) - facts:
        with pytest.raises(AttributeError, match=f"no {name}: "):
            getattr(second, name)
    assert {"fold_locus", "backbone", "certify"} < set(unanswered)
    for name in ("many", "margins", "isolation", "steady_state", "transient", "rest"):
        with pytest.raises(AttributeError, match=f"no {name}: "):
            getattr(second, name)
    for answer in (second.amplitudes(Omega=0.9, F_0=0.04), second.saddle_nodes(0.04)):
        for name in ("validity", "measure", "gradient"):
            with pytest.raises(AttributeError, match=f"has no {name}: "):
                getattr(answer, name)
        with pytest.raises(AttributeError, match=r"has no nonsense$"):
            _ = answer.nonsense
    with pytest.raises(AttributeError, match=r"has no nonsense$"):
        _ = second.nonsense


def test_states_in_which_the_mass_stops_are_named():
    """By what was measured; the exact motion has stops where friction is largest beside inertia, none where least."""
    iso, F_0 = isolator(), 0.018
    curve = iso.second_approximation.frequency_response(F_0, Omega=(0.5, 1.3))
    rest = iso.mu / (curve.A * curve.Omega**2)
    assert f"in {np.count_nonzero(rest >= 1)} of {curve.A.size} states the mass stops" in curve.message
    least, most = curve.Omega[[rest.argmin(), rest.argmax()]]
    assert iso.steady_state(Omega=least, F_0=F_0).stops == 0 and iso.steady_state(Omega=most, F_0=F_0).stops > 0
    assert "stops" not in iso.second_approximation.frequency_response(0.05, Omega=(0.5, 1.3)).message


def test_a_breakpoint_that_is_too_large_is_refused():
    """Only for the untruncated force, whose harmonics are quadratures."""
    design = {"lam": 1, "r": 0.5, "delta_h": 0.4, "mu": 0.01, "zeta": 0.02}
    with pytest.raises(ValueError, match=r"u_cr = 0\.8 is not allowed here.*u_cr <= 0\.75"):
        _ = Isolator(**design, force="untruncated").second_approximation
    assert Isolator(**design).second_approximation.frequency_response(0.04, Omega=(0.5, 1.5)).A.size > 900


def test_corner_of_the_truncated_force_keeps_its_two_folds():
    """Just above F_cr the first approximation has a fold on the corner, and one close above it."""
    iso = isolator(zeta=0.1, delta_h=0.03)
    F_0 = 1.4 * iso.detachment().F_cr
    averaged, better = iso.saddle_nodes(F_0), iso.second_approximation.saddle_nodes(F_0)
    assert averaged.corner.tolist() == better.corner.tolist() and averaged.corner.sum() == 1
    assert averaged.kind.tolist() == better.kind.tolist()
    assert len(isolator(zeta=0.1, delta_h=0.03, force="untruncated").second_approximation.saddle_nodes(F_0)) == 0


@pytest.mark.parametrize(
    ("oscillator", "F_0"), [(Duffing(4.0, 1.0, 0.01, 0.0), 0.0128), (isolator(mu=0.0, zeta=1e-6), 1e-6)]
)
def test_a_peak_as_sharp_as_a_needle_makes_no_folds(oscillator, F_0):
    """Its two sides are one amplitude's: slipping from one to the other passed for a change of the slope's sign."""
    second = oscillator.second_approximation
    folds = second.saddle_nodes(F_0)
    assert folds.kind.tolist() == ["jump-up", "jump-down"]
    # on either side of a fold there are two states more or less
    for Omega in folds.Omega:
        below, above = (second.amplitudes(Omega=Omega * (1 + side * 1e-5), F_0=F_0).A.size for side in (-1, 1))
        assert abs(below - above) == 2


def test_folds_as_close_as_the_corner_are_of_two_kinds():
    """4e-8 apart, and by rising Omega, then by rising A."""
    design = {"lam": 4, "r": 1.0300431, "delta_h": 0.020223232, "mu": 0.0207183129, "zeta": 0.0885677}
    folds = Isolator(**design).second_approximation.saddle_nodes(0.09701705)
    assert folds.corner.tolist() == [True, False]
    assert folds.kind.tolist() == ["jump-up", "jump-down"]


def test_bad_input_is_refused_as_in_the_first():
    second = isolator().second_approximation
    for call in (
        lambda: second.frequency_response(-1.0),
        lambda: second.frequency_response(0.04, samples=1),
        lambda: second.amplitudes(Omega=-0.5, F_0=0.04),
        lambda: second.saddle_nodes(float("nan")),
    ):
        with pytest.raises(ValueError, match="is not allowed"):
            call()


@pytest.mark.parametrize("mu", [0.0, 0.012])
def test_states_next_to_a_fold_are_found_between_far_points(mu):
    """Most points of a curve that reaches A = 200 lie above u_cr."""
    iso = isolator(mu=mu, zeta=1e-4)
    for Omega in (0.888, 0.89, 0.9):
        states = iso.second_approximation.amplitudes(Omega=Omega, F_0=0.04)
        assert states.stable.tolist() == [True, False, True] and not states.message


#: random designs: isolators whose springs come off, and cubic springs, soft ones too
def random_oscillators(count=12, excitation="force"):
    rng = np.random.default_rng(11)
    how = {"excitation": excitation}
    for _ in range(count):
        lam, r = rng.uniform(1, 4), rng.uniform(0.5, 3)
        mu, zeta = rng.uniform(0.0, 0.03), rng.uniform(0.005, 0.1)
        delta_h = rng.uniform(0.1, 0.9) / (lam * r)
        yield Isolator(lam=lam, r=r, delta_h=delta_h, mu=mu, zeta=zeta, **how), 4 * mu / np.pi + 0.03
        yield Duffing(1.0, rng.uniform(-0.2, 2.0), mu, zeta, **how), 4 * mu / np.pi + rng.uniform(0.02, 0.2)


def at_displacement(balance, Omega, u_max):
    """The A of the kernels with a largest displacement."""
    return brentq(lambda A: float(balance.response(Omega, A, 1.0).u_max) - u_max, 0.7 * u_max, 1.4 * u_max, xtol=1e-15)


@pytest.mark.parametrize("excitation", ["force", "base"])
def test_curves_folds_states_and_peaks_meet_the_balance(excitation):
    """As its kernels on NumPy have it: F = 0, F_A = 0 at a fold too, and nothing turns at a peak."""
    seen = 0
    for oscillator, F_0 in random_oscillators(excitation=excitation):
        model, balance = oscillator.model, Balance(oscillator.model)
        curve = curve_of(model, F_0, 600, (0.5, 2.0))
        met, force = balance.response(curve.Omega, curve.A, F_0), model.force(F_0, curve.Omega)
        # a step of a point's way that is small enough ends it
        assert np.all(np.abs(met.F) < (1e-9 if model.inertial else 1e-11) * force**2)
        assert np.allclose(curve.u_max, met.u_max, rtol=1e-12, atol=0) and np.array_equal(curve.stable, met.F_A > 0)
        for Omega, u_max, _, _, corner in zip(*folds_about(model, F_0, 0.5 * BEYOND, 2.0 / BEYOND)[:5], strict=True):
            here = balance.response(Omega, at_displacement(balance, Omega, u_max), F_0)
            scale = model.force(F_0, Omega) ** 2
            assert abs(here.F) < 1e-9 * scale and (corner or abs(here.F_A) * u_max < 1e-6 * scale)
            seen += 1
        status, *states = SOLVER.second_states(model.native, F_0, np.linspace(0.55, 1.9, 9))
        assert status == Status.OK
        for Omega, u_max, _, _, stable in zip(*states, strict=True):
            here = balance.response(Omega, at_displacement(balance, Omega, u_max), F_0)
            assert abs(here.F) < 1e-9 * model.force(F_0, Omega) ** 2 and stable == (here.F_A > 0)
        near = oscillator.peak(F_0).Omega
        status, u_max, Omega, *_ = SOLVER.second_peak(model.native, F_0, near) if near else (Status.NONE, 0.0, 0.0)
        if status == Status.OK:
            level, _, turning = balance.detachment(Omega, at_displacement(balance, Omega, u_max))
            assert level == pytest.approx(F_0, rel=1e-8) and abs(turning) < 1e-5 * model.force(F_0, Omega) ** 2
            assert u_max >= curve.u_max.max() * (1 - 1e-12)
    assert seen > 20


def test_folds_at_once_are_those_found_step_by_step():
    """Their numbers, what is lost and what is said; where doubles do not tell averaging's there is no short way."""
    seen = 0
    for oscillator, F_0 in random_oscillators(20):
        marks = [*oscillator.folds(F_0).Omega, oscillator.peak(F_0).Omega]
        at_once = folds_about(oscillator.model, F_0)
        assert at_once == folds_about(oscillator.model, F_0, min(marks), max(marks))
        seen += len(at_once[0])
    assert seen > 30
    undecided = isolator(mu=0.0, delta_h=0.03)
    F_0 = undecided.saddle_node_onset().F_SN
    doubtful = SOLVER.saddle_nodes(undecided.model.native, F_0)[-1]
    assert doubtful == (folds_about(undecided.model, F_0) is None)


def test_points_far_from_folds_and_peak_are_not_needed_for_them():
    """Those of the whole curve come of a fraction of its points: where its stability changes, and above all of them."""
    seen = 0
    for oscillator, F_0 in random_oscillators(30):
        model = oscillator.model
        whole, beside_folds, beside_top = (curve_of(model, F_0, 600, (0.4, 2.5), request) for request in Wanted)
        assert beside_folds.A.size < whole.A.size and beside_top.A.size < whole.A.size
        turns = np.flatnonzero((np.diff(whole.stable.astype(int)) != 0) & (np.diff(whole.branch) == 0))
        Omega, u_max, *_, lost, tried, _ = folds_about(model, F_0, 0.4 * BEYOND, 2.5 / BEYOND)
        assert lost == 0 and len(Omega) == tried == turns.size
        sides = np.sort([whole.u_max[turns], whole.u_max[turns + 1]], axis=0)
        order = np.argsort(sides[0])
        assert np.all((sides[0][order] <= np.sort(u_max)) & (np.sort(u_max) <= sides[1][order]))
        status, top, *_ = SOLVER.second_peak(model.native, F_0, oscillator.peak(F_0).Omega)
        assert status != Status.OK or top >= whole.u_max.max() * (1 - 1e-13)
        seen += turns.size + (status == Status.OK)
    assert seen > 100


@pytest.mark.slow
@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="fresh memory is filled by glibc")
def test_a_curve_does_not_depend_on_what_memory_held():
    """Points still to be sought passed for settled where their places held huge numbers, and were left out."""
    code = (
        "from slowflow import Isolator\n"
        "second = Isolator(lam=1.05, r=2.87, delta_h=0.117, mu=0.0, zeta=0.00456).second_approximation\n"
        "for curve in map(second.frequency_response, (0.0118, 0.0085)):\n"
        "    print(curve.message, curve.A.tolist())"
    )
    outputs = {
        subprocess.run(
            [sys.executable, "-c", code],
            env={**os.environ, "MALLOC_PERTURB_": filled},
            capture_output=True,
            check=True,
        ).stdout
        for filled in ("1", "128")
    }
    assert len(outputs) == 1


@pytest.mark.parametrize("excitation", ["force", "base"])
def test_critical_forcings_meet_the_balance(excitation):
    """At a cusp F_A and F_AA vanish; where the springs detach u_max is u_cr and no other frequency takes less."""
    found = 0
    for oscillator, _ in random_oscillators(20, excitation):
        model, balance = oscillator.model, Balance(oscillator.model)
        onset, lift = oscillator.saddle_node_onset(), oscillator.detachment()
        start = (onset.F_SN, onset.Omega, onset.A) if onset.kind == "cusp" else (np.nan, np.nan, np.nan)
        status, F_SN, Omega, u_max, *_ = SOLVER.second_onset(model.native, *start)
        if status == Status.OK:
            A, scale = at_displacement(balance, Omega, u_max), model.force(F_SN, Omega) ** 2
            F, F_A, F_AA = balance.folds(Omega, A, F_SN)
            assert max(abs(F), A * abs(F_A), A * A * abs(F_AA)) < 1e-6 * scale
            found += 1
        start = (lift.F_cr, lift.Omega_cr, lift.u_cr) if lift.F_cr else (np.nan, np.nan, np.nan)
        status, F_cr, Omega, _ = SOLVER.second_detachment(model.native, *start)
        if status == Status.OK:
            level, _, turning = balance.detachment(Omega, at_displacement(balance, Omega, lift.u_cr))
            assert level == pytest.approx(F_cr, rel=1e-10) and abs(turning) < 1e-8
            found += 1
    assert found > 20


@pytest.mark.parametrize("case", stored("second"), ids=lambda case: case["of"])
def test_states_and_folds_have_independent_digits(case):
    """Of tests/oracles/second.py, which knows no derivation: h_n by quadrature, friction's sum in closed form."""
    oscillator = isolator() if case["of"] == "table 1" else Duffing(1.0, 0.5, 0.01, 0.02)
    second = oscillator.second_approximation
    states = second.amplitudes(Omega=case["Omega"], F_0=case["F_0"])
    assert len(states) == len(case["states"]) == 3
    for found, digits in zip(zip(states.A, states.A_1, strict=True), case["states"], strict=True):
        assert all(abs(mpf(one) / mpf(text) - 1) < 1e-14 for one, text in zip(found, digits, strict=True))
    folds = second.saddle_nodes(case["F_0"])
    assert len(folds) == len(case["folds"]) == 2
    for fold, (Omega, u_max) in zip(folds, case["folds"], strict=True):
        assert abs(mpf(fold.Omega) / mpf(Omega) - 1) < 1e-14
        assert abs(mpf(fold.A) / mpf(u_max) - 1) < 1e-13


def test_a_sharp_peak_is_a_point_of_the_curve():
    """It lies between points that few samples leave, which took off 8e-4; where there is none the message says why."""
    numbers = {"lam": 1.8, "r": 2.284, "delta_h": 0.1072, "mu": 0.0133, "zeta": 0.00315, "force": "untruncated"}
    second = Isolator(**numbers).second_approximation
    peak = second.peak(0.2553)
    for samples in (40, 60, 100, 599):
        curve = second.frequency_response(0.2553, samples=samples)
        top = curve.A.argmax()
        assert abs(curve.A[top] / peak.A - 1) < 1e-12 and curve.force.size == curve.branch.size == curve.A.size
        assert (curve.Omega[top - 1] - curve.Omega[top]) * (curve.Omega[top + 1] - curve.Omega[top]) < 0
    assert "sticks" in isolator().second_approximation.peak(0.01).message
    unbounded = isolator(zeta=0.0).second_approximation.peak(0.03)
    assert unbounded.A is None and unbounded.message


def test_batches_of_the_second_approximation_say_what_lacks():
    second = Isolator.many(lam=3, r=2.0, delta_h=[0.05, 0.08], mu=0.01, zeta=0.02).second_approximation
    for name in ("certify", "margins", "spectrum", "transient"):
        with pytest.raises(AttributeError, match=f"has no {name}: "):
            getattr(second, name)
    assert pickle.loads(pickle.dumps(second)) == second and copy.deepcopy(second) == second
    few, states = (second.amplitudes(Omega=0.9, F_0=0.04, max_count=max_count) for max_count in (1, 6))
    assert (few.status == Status.TOO_MANY).any() and np.array_equal(few.A[:, 0], states.A[:, 0], equal_nan=True)
    curves = second.frequency_response(0.04, samples=60, Omega=(0.7, 1.1))
    assert len(curves.columns()["A_1"]) == curves.points.sum()


def test_states_missing_beside_the_first_approximation_are_told():
    """Beside a fold of averaging its own may lie on the other side: there it has two states less."""
    iso = Isolator(lam=1.0394108387827414, r=1.1845, delta_h=0.2713, mu=0.0085, zeta=0.0136)
    folds = iso.saddle_nodes(0.10874)
    Omega = [0.9, folds.Omega[0] * (1 + 1e-4), folds.Omega[-1] * (1 - 1e-4), 1.2]
    first, second = (one.amplitudes(Omega=Omega, F_0=0.10874) for one in (iso, iso.second_approximation))
    counts = [[int((found.Omega == at).sum()) for at in Omega] for found in (first, second)]
    lacking = [two < one for one, two in zip(*counts, strict=True)]
    assert 0 < sum(lacking) < len(Omega)
    assert (
        f"fewer states than in the first approximation at {sum(lacking)} of {len(Omega)} frequencies" in second.message
    )
    design = {name: getattr(iso, name) for name in ("lam", "r", "delta_h", "mu", "zeta")}
    many = Isolator.many(**design).second_approximation.amplitudes(Omega=Omega, F_0=0.10874)
    assert many.undecided.astype(bool).tolist() == lacking
    assert many.count.tolist() == counts[1]
