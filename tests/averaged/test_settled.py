"""Answers are settled to their last digit by Newton's method in double-double, from the oscillator as it was given."""

from __future__ import annotations

import math
import shutil
from fractions import Fraction

import flint
import mpmath
import numpy as np
import pytest

from benchmarks.stress import answers
from slowflow import Duffing, Isolator
from slowflow.support.errors import NotSettled
from slowflow_kernels.conventions import Status
from tests.native.intervals import EXACT, OPERATIONS, Pairs
from tests.oracles import averaged

#: of an operation in double-double, relatively
ERROR = Fraction(1, 2**100)


@pytest.fixture(scope="module")
def pairs(once):
    if shutil.which("gcc") is None:
        pytest.skip("no gcc on the path")
    return Pairs(once("pairs", Pairs.build))


def ball(x):
    return flint.arb(flint.fmpq(x.numerator, x.denominator))


@pytest.mark.slow
@pytest.mark.parametrize("name", OPERATIONS)
def test_an_operation_on_pairs_is_right_to_thirty_digits(pairs, name):
    rng = np.random.default_rng(3)
    high = rng.choice([-1, 1], (2000, 2)) * 10.0 ** rng.uniform(-6, 6, (2000, 2))
    high[::5, 1] = high[::5, 0] * (1 + rng.choice([-1, 1], 400) * 2.0 ** rng.uniform(-52, -1, 400))
    if name in ("sqrt", "atan2"):
        high = np.abs(high)
    low = high * rng.uniform(-1, 1, (2000, 2)) * 2.0**-54
    operands = np.stack([high[:, 0], low[:, 0], high[:, 1], low[:, 1]], axis=1)
    with flint.ctx.workprec(300):
        for row, found in zip(operands.tolist(), pairs.operate(name, operands), strict=True):
            a, b = (sum(map(flint.arb, of)) for of in (row[:2], row[2:]))
            value = EXACT[name](a, b)
            size = abs(a) + abs(b) if name in ("add", "sub") else abs(value)
            assert abs(ball(found) - value) <= ball(ERROR) * size


@pytest.mark.slow
def test_averages_in_pairs_have_twenty_digits_and_more(pairs):
    """Against the reference's own formulas in balls; A is a double on either side of u_cr, the design exact."""
    rng = np.random.default_rng(5)
    for _ in range(100):
        design = (float(rng.integers(1, 5)), 10 ** rng.uniform(-1, 1), 10 ** rng.uniform(-4, -0.02))
        with flint.ctx.workprec(500):
            exact = averaged.RodSpring(lam=design[0], r=design[1], delta_h=design[2], mu=0.0, zeta=0.01)
            u_cr = float(exact.u_cr.mid())
            above = (1 + 2.0**-40, 1.001, 1.5, 30.0, 2000.0)
            for piece, ratio in ((0, 1e-3), (0, 0.7), *((1, at) for at in above)):
                A = u_cr * ratio
                balls = exact.h(flint.arb(A), ("attached", "detached")[piece])
                found = pairs.known("rod_spring", design, piece, A)
                kept = 4 if ratio < 64 else 2
                for value, expected in list(zip(found, balls, strict=True))[:kept]:
                    scale = abs(balls[0]) / A if ratio > 64 else abs(expected)
                    assert abs(ball(value) - expected) <= scale * float(2.0**-62)


@pytest.mark.slow
@pytest.mark.parametrize("mechanism", ["rod_spring", "duffing"])
def test_answers_are_right_to_one_rounding_of_their_condition(mechanism):
    """Seeded oscillators and forcings at hard places, which `make stress` does not ask.

    Left out are amplitudes a few doubles from u_cr, and what a rounding of the input moves by thousands of its own.
    """
    rng, compared = np.random.default_rng(99), 0
    for _ in range(25):
        for _, at in answers.points(mechanism, rng):
            ends = answers.oscillator(mechanism, at).breakpoints
            try:
                found = [answer for answer in answers.answers(mechanism, at) if answer[1] is not None]
            except NotSettled:  # refused in words
                continue
            for kind, answer in found:
                error, condition = answers.judged(answer)
                if condition < 1e9 and all(abs(answer[0] / end - 1) > 1e-14 for end in ends):
                    compared += 1
                    # F_cr alone is as doubles have it, for the time that a step takes
                    assert error <= (4 if kind.startswith("critical forcing") else 1), (at, kind, answer)
    assert compared > 300


@pytest.mark.slow
@pytest.mark.parametrize("mechanism", ["rod_spring", "rod_spring_untruncated"])
def test_peaks_and_folds_next_to_a_breakpoint_are_rounded_once(mechanism):
    """From an ulp above F_cr on, where slopes are as steep as 1/sqrt(A - u_cr); seen 45,134 u (1 + kappa) off."""
    rng, compared = np.random.default_rng(5), 0
    known = [
        (4.0, 0.5420870022747798, 0.2870603613617843, 0.00019876134441345242, 1e-06, 0.00025428553329583814, 1.0),
        (2.0000000000000036, 296.604925754428, 0.0006476225284155476, 0.0002089718, 0.0461335947, 0.6492116947, 1.0),
        (1.0, 4.144227659036338, 0.24129948503662352, 0.002513681713525968, 0.003751740185398381, 0.0070897182235, 1.0),
    ]
    for k in range(15):
        own = answers.design(mechanism, rng)[1]
        F_cr = answers.oscillator(mechanism, (*own, 1.0, 1.0)).detachment().F_cr
        above = [(*own, F_cr * (1 + 10 ** rng.uniform(-15.5, -4)), 1.0) for _ in range(3)] if F_cr else []
        for at in (*above, *(known if k == 0 else ())):
            for kind in ("peak", "fold"):
                for _, answer in answers.answers(mechanism, at, kind):
                    if answer is not None:
                        compared += 1
                        assert answers.judged(answer)[0] <= 1, (at, kind, answer)
    assert compared > 60


@pytest.mark.slow
def test_a_fold_does_not_leave_its_piece_of_the_force():
    """Next to F_SN at the corner, zeta all but 0: by the formula below u_cr a fold would lie above it."""
    oscillator = Isolator(lam=3, r=2, delta_h=0.2, mu=0.012, zeta=1e-9)
    u_cr = oscillator.detachment().u_cr
    for F_0 in (oscillator.saddle_node_onset().F_SN, oscillator.detachment().F_cr):
        for forcing in (math.nextafter(F_0, 0), F_0, math.nextafter(F_0, 1)):
            for fold in oscillator.saddle_nodes(forcing):
                Omega = oscillator.frequency_response(forcing, samples=20).Omega
                assert fold.corner == (fold.A == u_cr) or abs(fold.A / u_cr - 1) > 1e-15
                assert np.isclose(Omega, fold.Omega, rtol=1e-13).any()


def test_states_at_a_peak_lie_between_the_doubles_beside_them():
    """There the curve's segments end, whose ends are not states at that very frequency; exact where mu = 0."""
    rng = np.random.default_rng(7)
    alpha, beta, zeta, F_0 = rng.uniform((0.2, 0.1, 0.01, 0.01), (2, 3, 0.3, 1), (300, 4)).T
    designs = Duffing.many(alpha=alpha, beta=beta, mu=0.0, zeta=zeta)
    peak = designs.peak(F_0)
    found = designs.amplitudes(Omega=peak.Omega, F_0=F_0)
    checked = 0
    for row in zip(alpha, beta, zeta, F_0, peak.Omega, found.A, strict=True):
        a, b, z, force, w = (Fraction(float(x)) for x in row[:5])

        def F(A, a=a, b=b, z=z, force=force, w=w):
            return (A * w * w - a * A - b * A**3 * Fraction(3, 4)) ** 2 + (2 * z * A * w) ** 2 - force**2

        for A in row[5][~np.isnan(row[5])].tolist():
            checked += 1
            assert F(Fraction(math.nextafter(A, 0))) * F(Fraction(math.nextafter(A, math.inf))) < 0
    assert checked > 300


def test_unpreloaded_peak_is_the_exact_one_rounded():
    """A piece that ends at u = 0 is none: in batches pairs were not asked then, every other peak was a double off."""
    rng = np.random.default_rng(2)
    numbers = {"lam": rng.uniform(1, 4, 20), "r": rng.uniform(0.5, 3, 20)}
    mu, zeta = 10 ** rng.uniform(-6, -1, 20), 10 ** rng.uniform(-5, -1, 20)
    F_0 = 4 * mu / math.pi * rng.uniform(1.1, 5, 20)
    found = Isolator.many(**numbers, delta_h=0.0, mu=mu, zeta=zeta).peak(F_0)
    with mpmath.workdps(40):
        for i in range(20):
            m, damping, forcing = 4 * mpmath.mpf(mu[i]) / mpmath.pi, mpmath.mpf(zeta[i]), mpmath.mpf(F_0[i])

            def equations(A, Omega, m=m, damping=damping, forcing=forcing):
                R, I = (1 - Omega**2) * A, 2 * damping * Omega * A + m
                return [R**2 + I**2 - forcing**2, -Omega * R + damping * I]

            A, Omega = mpmath.findroot(equations, (mpmath.mpf(found.A[i]), mpmath.mpf(found.Omega[i])))
            assert (found.A[i], found.Omega[i]) == (float(A), float(Omega))


def test_unpreloaded_states_are_the_exact_ones_rounded():
    """A breakpoint at 0 was taken for one that can't be told from 0: 29 of 300 states of a batch were a double off."""
    rng = np.random.default_rng(5)
    numbers = {"lam": rng.uniform(1, 4, 300), "r": rng.uniform(0.5, 3, 300)}
    mu, zeta = 10 ** rng.uniform(-6, -1, 300), 10 ** rng.uniform(-5, -1, 300)
    F_0, Omega = 4 * mu / math.pi * rng.uniform(1.1, 5, 300), rng.uniform(0.5, 1.5, 300)
    found = Isolator.many(**numbers, delta_h=0.0, mu=mu, zeta=zeta).amplitudes(Omega=Omega, F_0=F_0)
    assert (found.count == 1).all() and not found.undecided.any()
    with mpmath.workdps(40):
        for i in range(300):
            m, w = 4 * mpmath.mpf(mu[i]) / mpmath.pi, mpmath.mpf(Omega[i])
            a = (1 - w**2) ** 2 + 4 * mpmath.mpf(zeta[i]) ** 2 * w**2
            half_b, c = 2 * mpmath.mpf(zeta[i]) * w * m, m**2 - mpmath.mpf(F_0[i]) ** 2
            assert found.A[i, 0] == float((mpmath.sqrt(half_b**2 - a * c) - half_b) / a)


def test_a_linear_oscillator_has_no_folds_in_batches_either():
    """Next to 4 mu/pi a batch said that doubles don't tell, of what a single answer knows to have none."""
    sticks = 4 * np.float64(0.01) / math.pi
    for F_0 in (np.nextafter(sticks, 1), sticks * (1 + 1e-14), 0.3):
        for oscillators in (
            Isolator.many(lam=2, r=2, delta_h=[0.0], mu=0.01, zeta=0.02),
            Duffing.many(alpha=[1.0], beta=0.0, mu=0.01, zeta=0.02),
        ):
            found = oscillators.saddle_nodes(F_0)
            assert found.count[0] == 0 and not found.undecided[0] and found.status[0] == Status.OK
