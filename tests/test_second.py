"""The second approximation against exact motions, Den Hartog's closed form, and the order of its error."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from mpmath import mp, mpf

from derivations.second_approximation import friction_sum
from slowflow import Duffing, Isolator
from slowflow.results import words
from slowflow_kernels import den_hartog, second_approximation

TABLE_1 = {"lam": 3, "r": 3747 / 1848, "delta_h": 1848 / (6 * 3747), "mu": 0.012, "zeta": 0.02}
FORCES = ("truncated", "exact")


def isolator(**changes):
    return Isolator(**{**TABLE_1, **changes})


def orders(sizes, errors):
    """Exponents p of errors that fall like size^p, from each size to the next."""
    return np.diff(np.log(np.abs(errors))) / np.diff(np.log(sizes))


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


@pytest.mark.parametrize(("Omega", "first", "second"), [(1.3, 1, 2), (0.8, 0.7, 1.5)])
def test_the_largest_displacement_is_one_order_closer(Omega, first, second):
    """Of the nonlinearity, without friction: errors fall like beta and beta^2, nearly so beside the resonance."""
    betas = (0.2, 0.1, 0.05, 0.025)
    errors = []
    for beta in betas:
        oscillator = Duffing(1.0, beta, 0.0, 0.02)
        averaged = oscillator.amplitudes(Omega, 0.3)
        exact = oscillator.steady_state(Omega, 0.3, averaged.A[0]).A
        better = oscillator.second_approximation.amplitudes(Omega, 0.3)
        assert better.A.size == averaged.A.size and not better.message
        errors.append((averaged.A[0] / exact - 1, better.u_max[0] / exact - 1))
    errors = np.array(errors).T
    assert np.all(orders(betas, errors[0]) < second)
    assert np.all(orders(betas, errors[0]) > first)
    assert np.all(orders(betas, errors[1]) > second)


@pytest.mark.parametrize("Omega", [0.5, 0.8, 1.2, 2.0])
def test_friction_alone_against_den_hartog(Omega):
    """(35) is exact without stops: the error falls with the fourth power of mu/F_0, averaging's with the second."""
    ratios = (0.2, 0.1, 0.05)
    errors = []
    for ratio in ratios:
        oscillator = Duffing(1.0, 0.0, ratio, 0.0)
        exact = float(den_hartog.amplitude(Omega, 1.0, ratio))
        (averaged,), (better,) = (
            oscillator.amplitudes(Omega, 1.0).A,
            oscillator.second_approximation.amplitudes(Omega, 1.0).u_max,
        )
        errors.append((averaged / exact - 1, better / exact - 1))
    errors = np.array(errors).T
    assert np.all(np.abs(orders(ratios, errors[0]) - 2) < 0.1)
    assert np.all(orders(ratios, errors[1]) > 3.8)
    assert abs(errors[1, 0]) < 1e-5


@pytest.mark.parametrize("force", FORCES)
def test_the_folds_of_table_1_come_closer_to_the_exact_ones(force):
    """Ten times at least, both jumps of Fig. 7a's forcing: frequencies and largest displacements."""
    iso = isolator(force=force)
    exact = iso.exact_response(0.04, (0.8, 1.05), step=0.05).folds
    exact = sorted(exact, key=lambda fold: fold.Omega)
    averaged, better = iso.saddle_nodes(0.04), iso.second_approximation.saddle_nodes(0.04)
    assert better.kind.tolist() == averaged.kind.tolist() == [fold.kind for fold in exact]
    Omega, A = (np.array([getattr(fold, name) for fold in exact]) for name in ("Omega", "A"))
    assert np.all(np.abs(better.Omega / Omega - 1) < 0.1 * np.abs(averaged.Omega / Omega - 1))
    assert np.all(np.abs(better.Omega / Omega - 1) < 2e-5)
    assert np.all(np.abs(better.u_max / A - 1) < 1e-3)


def test_the_critical_force_without_friction_comes_closer():
    """F_cr is where the exact motion just reaches u_cr: averaging says 2 % too much, as it leaves out a_3."""
    iso = isolator(mu=0.0, force="exact")
    averaged, better = iso.detachment(), iso.second_approximation.detachment()
    F_cr, u_cr = better.F_cr, better.u_cr

    def highest(F_0):
        return iso.exact_response(F_0, (0.6, 1.05), step=0.05).A.max()

    assert highest(F_cr * (1 - 0.003)) < u_cr < highest(F_cr * (1 + 0.003))
    assert averaged.F_cr > 1.015 * F_cr
    # what the averaged F_cr leads to is far beyond
    assert highest(averaged.F_cr) > 1.002 * u_cr


@pytest.mark.parametrize("force", FORCES)
@pytest.mark.parametrize("mu", [0.0, 0.012])
def test_answers_belong_together(force, mu):
    """Folds and states lie on the curve; below the onset there is no fold, above it there are two."""
    iso = isolator(mu=mu, force=force)
    second = iso.second_approximation
    curve = second.frequency_response(0.04, Omega=(0.6, 1.2))
    assert np.all(curve.u_max > 0) and np.all((curve.phi <= 0) & (curve.phi >= -np.pi))
    folds = second.saddle_nodes(0.04)
    x, y = np.log(curve.Omega), np.log(curve.A)
    for Omega, A in zip(folds.Omega, folds.A, strict=True):
        distance = np.hypot(x - np.log(Omega), y - np.log(A))
        assert distance.min() < 0.01
    states = second.amplitudes([0.9, 0.95], 0.04)
    assert states.stable.tolist() == [True, False, True] * 2
    assert np.all(np.diff(states.A[:3]) > 0)
    F_SN = second.saddle_node_onset().F_SN
    assert len(second.saddle_nodes(0.999 * F_SN)) == 0
    assert len(second.saddle_nodes(1.002 * F_SN)) == 2
    F_cr, Omega_cr, u_cr = (getattr(second.detachment(), name) for name in ("F_cr", "Omega_cr", "u_cr"))
    near = (0.97 * Omega_cr, 1.03 * Omega_cr)
    low, high = (second.frequency_response(share * F_cr, 4000, near).u_max.max() for share in (0.999, 1.001))
    assert low < u_cr < high


def test_the_balance_is_met_on_the_curve():
    """R and I of the moved points are those of the forcing, and their phase is the one reported."""
    iso = isolator()
    second, F_0 = iso.second_approximation, 0.04
    curve = second.frequency_response(F_0, Omega=(0.6, 1.2))
    _, phi, R, I, F, *_ = second._response(curve.Omega, curve.A, F_0)
    assert np.abs(np.hypot(R, I) / F_0 - 1).max() < 1e-11
    assert np.abs(F).max() < 1e-11 * F_0**2
    assert np.array_equal(phi, curve.phi)


@pytest.mark.parametrize("zeta", [0.0, 1e-5])
def test_next_to_no_viscous_damping_the_points_keep_their_order(zeta):
    """Without a peak, or with one that is sharp as a needle."""
    iso = isolator(mu=0.0, zeta=zeta)
    first = iso.frequency_response(0.02, Omega=(0.6, 1.1))
    curve = iso.second_approximation.frequency_response(0.02, Omega=(0.6, 1.1))
    assert curve.A.size > 0.95 * first.A.size
    for branch in np.unique(curve.branch):
        steps = []
        for one in (first, curve):
            x, y = (np.diff(np.log(values[one.branch == branch])) for values in (one.Omega, one.A))
            steps.append(np.hypot(x, y))
        assert steps[0].size == steps[1].size
        assert np.all(steps[1] < 1.2 * steps[0] + 0.02)


def test_what_is_not_there_is_told_in_words():
    second = isolator().second_approximation
    stuck = second.frequency_response(0.01)
    assert stuck.A.size == 0 and "sticks" in stuck.message
    assert len(second.saddle_nodes(0.01)) == 0 and "sticks" in second.saddle_nodes(0.01).message
    assert second.amplitudes(0.9, 0.01).A.size == 0
    low = second.frequency_response(0.04, Omega=(0.05, 0.2))
    assert "left out" in low.message and low.A.size == 0
    linear = isolator(delta_h=0).second_approximation
    assert linear.detachment().F_cr is None and linear.detachment().message
    assert linear.saddle_node_onset().F_SN is None and linear.saddle_node_onset().message
    assert words(linear.saddle_nodes(0.04).message)


def test_a_breakpoint_that_is_too_large_is_refused():
    iso = Isolator(lam=1, r=0.5, delta_h=0.4, mu=0.01, zeta=0.02)
    with pytest.raises(ValueError, match=r"delta_h = 0\.4 is not allowed here.*u_cr = 0\.8"):
        _ = iso.second_approximation


def test_bad_input_is_refused_as_in_the_first():
    second = isolator().second_approximation
    for call in (
        lambda: second.frequency_response(-1.0),
        lambda: second.frequency_response(0.04, 1),
        lambda: second.amplitudes(-0.5, 0.04),
        lambda: second.saddle_nodes(float("nan")),
    ):
        with pytest.raises(ValueError, match="is not allowed"):
            call()


def test_kernels_agree_with_one_another():
    """R, I and u_max of `response` and `detachment`, F and F_A of `response` and `folds`."""
    rng = np.random.default_rng(3)
    Omega, A, F_0, m, zeta = (
        rng.uniform(*ends, 50) for ends in ((0.7, 1.5), (0.1, 0.9), (0.02, 0.1), (0, 0.02), (0, 0.1))
    )
    h = -A * Omega**2 * rng.uniform(0.5, 3, 50)
    rest = [rng.uniform(-0.3, 0.3, 50) for _ in range(11)]
    three = [h, *rest[:2], *rest[3:6], *rest[7:10]]
    four = [h, *rest]
    u_max, _, R, I, F, F_A, *_ = second_approximation.response(Omega, A, F_0, m, zeta, *three)
    assert np.allclose((R, I, u_max), second_approximation.detachment(Omega, A, m, zeta, *three)[:3], rtol=1e-13)
    assert np.allclose((F, F_A), second_approximation.folds(Omega, A, F_0, m, zeta, *four)[:2], rtol=1e-9, atol=1e-14)


def test_states_at_many_frequencies_are_those_at_each():
    second = isolator().second_approximation
    frequencies = [0.95, 0.85, 1.1, 0.9]
    together = second.amplitudes(frequencies, 0.04)
    apart = [second.amplitudes(Omega, 0.04) for Omega in frequencies]
    assert np.allclose(together.A, list(itertools.chain(*(one.A for one in apart))), rtol=1e-9)
    assert together.Omega.tolist() == list(itertools.chain(*(one.Omega for one in apart)))
