"""Random vibration about a mean: closed forms, roots of polynomials, other integrals, exact densities, records."""

import itertools
import math

import numpy as np
import pytest
import sympy as sp
from numpy.polynomial import Polynomial
from scipy.integrate import quad
from scipy.optimize import brentq

from slowflow import Duffing, Isolator, Refused, derive
from slowflow.app.scenes import read
from slowflow.core.mechanism import EquationOfMotion, Force
from slowflow.random_vibration.excitation import White
from slowflow.random_vibration.questions import stationary
from slowflow_kernels.table_1 import TABLE_1
from tests.files import scene
from tests.random_vibration.test_random_vibration import (
    FLOOR,
    MOUNT,
    PSD,
    ROAD,
    assert_measured,
    check_gradient,
    exact_moments,
    moment,
    report,
    spread,
)

DESIGN = {name: TABLE_1[name] for name in ("lam", "r", "delta_h")}


@pytest.fixture(scope="module")
def stop():
    """A stop on the right alone, behind a gap."""
    u, k, g = sp.symbols("u k g")
    pieces = [(u, g), (u + k * (u - g), None)]
    return derive.mechanism("one_sided_stop", pieces, {"k": {"above": 0}, "g": {}}, odd=False, compile=False)


# ---- other routes


def of_polynomial(alpha, beta, load, square):
    """Every (sigma, mean) of alpha u + beta u^3 with sigma^2 k = square: the mean is eliminated.

    S (alpha + 3 beta (m^2 + S)) = square gives m^2 by S = sigma^2, m (alpha + beta (m^2 + 3 S)) = load then is one
    equation in S.
    """
    S = Polynomial([0, 1])
    squares = (square - alpha * S) / (3 * beta) - S * S  # S m^2
    pulls = alpha * S + beta * squares + 3 * beta * S * S  # S load/m
    roots = (squares * pulls * pulls - load**2 * S**3).roots()
    real = roots[(abs(roots.imag) < 1e-9 * abs(roots)) & (roots.real > 0)].real
    return sorted((math.sqrt(s), load * s / pulls(s)) for s in real if squares(s) >= 0)


def averages(force, load, m, sigma):
    """E[f] - load and E[(u - m) f]/sigma^2 by quadrature, piece by piece."""
    ends = sorted({m - 10 * sigma, m, m + 10 * sigma, *(end for end in force.edges if abs(end - m) < 10 * sigma)})

    def mean(of):
        def integrand(u):
            return of(u) * math.exp(-0.5 * ((u - m) / sigma) ** 2) / (sigma * math.sqrt(2 * math.pi))

        return sum(quad(integrand, *pair, epsabs=1e-15, epsrel=1e-12)[0] for pair in itertools.pairwise(ends))

    return mean(force.value) - load, mean(lambda u: (u - m) * force.value(u)) / sigma**2


def scanned(one, level, low, high, wide, count=40):
    """All (sigma, mean) of a force that rises: at each sigma it has one mean; `level` is I_0 at a stiffness."""
    force = one.restoring_force()

    def mean(sigma):
        return brentq(lambda m: averages(force, one.load, m, sigma)[0], -wide, wide, xtol=1e-13)

    def excess(sigma):
        return math.log(level(averages(force, one.load, mean(sigma), sigma)[1])) - 2 * math.log(sigma)

    grid = np.geomspace(low, high, count).tolist()
    values = [excess(sigma) for sigma in grid]
    pairs = zip(itertools.pairwise(grid), itertools.pairwise(values), strict=True)
    roots = [brentq(excess, *ends, xtol=1e-13) for ends, (a, b) in pairs if (a > 0) != (b > 0)]
    return [(sigma, mean(sigma)) for sigma in roots]


# ---- stationary motions


@pytest.mark.parametrize("excitation", ({"S_0": 0.01}, {"psd": FLOOR}))
def test_load_shifts_a_linear_oscillator_and_nothing_else(excitation):
    laws = {"mu": 0.01, "zeta": 0.05, "c_2": 0.1}
    centred = Duffing(2.0, 0.0, **laws).random(**excitation)
    found = Duffing(2.0, 0.0, **laws, load=0.3).random(**excitation)
    assert centred.B.tolist() == [0.0]
    assert found.B[0] == pytest.approx(0.15, rel=1e-13)
    for name in ("u_rms", "v_rms", "a_rms", "stiffness", "damping", "dry"):
        assert getattr(found, name)[0] == pytest.approx(getattr(centred, name)[0], rel=1e-11)


def test_every_motion_of_a_loaded_cubic_spring_is_a_root():
    """Of one equation of degree six, in single and double wells: up to five."""
    random, counts, size = np.random.default_rng(2), set(), 300
    alpha, beta = random.uniform(-1, 1, size), 10 ** random.uniform(-1, 1, size)
    load, square = (
        random.choice([-1, 1], size) * 10 ** random.uniform(-3, 0.3, size),
        10 ** random.uniform(-4, 0.5, size),
    )
    found = Duffing.many(alpha, beta, 0.0, 0.05, load=load).random(S_0=0.1 / math.pi * square, max_count=6)
    for n in range(size):
        expected = of_polynomial(alpha[n], beta[n], load[n], square[n])
        assert found.count[n] == len(expected)
        own = np.stack((found.u_rms[n], found.B[n]), axis=1)[: len(expected)]
        np.testing.assert_allclose(own, expected, rtol=1e-7, atol=1e-9)
        stiffness = alpha[n] + 3 * beta[n] * (own**2).sum(axis=1)
        np.testing.assert_allclose(found.stiffness[n][: len(expected)], stiffness, rtol=1e-9, atol=1e-9)
        counts.add(len(expected))
    assert counts == {1, 3, 5}


@pytest.mark.parametrize("excitation", ({"S_0": 4e-4}, {"psd": spread(3e-3)}))
def test_without_load_motions_are_those_about_the_centre(excitation):
    one = Isolator(**DESIGN, mu=0.005, zeta=0.02)
    centred, found = one.random(**excitation), one.replace(load=1e-12).random(**excitation)
    assert abs(found.B[0]) < 1e-11
    for name in ("u_rms", "v_rms", "a_rms", "stiffness", "damping", "beyond", "crossing_rate"):
        assert getattr(found, name)[0] == pytest.approx(getattr(centred, name)[0], rel=1e-9)


def test_loaded_truncated_force_has_its_averages():
    """It jumps at u_cr; a load of .03 is some half of the way there."""
    one, S_0 = Isolator(**DESIGN, zeta=0.02, load=0.03), 4e-4
    found = one.random(S_0=S_0)
    B, u, force = float(found.B[0]), float(found.u_rms[0]), one.restoring_force()
    excess, stiffness = averages(force, one.load, B, u)
    assert excess == pytest.approx(0.0, abs=1e-12)
    assert stiffness == pytest.approx(found.stiffness[0], rel=1e-12)
    assert stiffness * u**2 == pytest.approx(math.pi * S_0 / (2 * one.zeta), rel=1e-12)
    sides = [math.erfc((one.u_cr - side * B) / u / math.sqrt(2)) / 2 for side in (1, -1)]
    assert found.beyond[0] == pytest.approx(sum(sides), rel=1e-12)
    rates = [math.exp(-(((one.u_cr - side * B) / u) ** 2) / 2) for side in (1, -1)]
    assert found.crossing_rate[0] == pytest.approx(found.v_rms[0] / u / math.tau * sum(rates), rel=1e-12)


@pytest.mark.parametrize("case", range(3))
def test_motions_about_a_mean_are_those_of_a_scan(case, stop):
    one = (
        Isolator(**DESIGN, zeta=0.03, load=0.05),
        stop(k=8.0, g=0.1, zeta=0.03),
        Duffing(1.0, 1.0, zeta=0.03, load=0.05),
    )[case]
    narrow = [1.15, 1.2], [0.05, 0.05]
    for psd in (spread(2e-3), narrow if case else spread(0.02)):
        found = one.random(psd=psd)
        low, high = 0.5 * found.u_rms[0], 2 * found.u_rms[-1]
        expected = scanned(one, lambda k, psd=psd: moment(psd, k, 2 * one.zeta, 0), low, high, 3.0)
        np.testing.assert_allclose(np.stack((found.u_rms, found.B), axis=1), expected, rtol=1e-8, atol=1e-10)
    assert case != 2 or len(found) == 3


@pytest.mark.parametrize("load", (0.1, -0.3))
def test_one_stop_shifts_the_mean_by_tails(load, stop):
    """E[(u - g)+] = sigma (phi(x) - x Q(x)), x = (g - m)/sigma, and E[f'] = 1 + k Q(x)."""
    k, g, S_0, zeta = 5.0, 0.2, 1e-3, 0.05
    found = stop(k=k, g=g, zeta=zeta, load=load).random(S_0=S_0)
    m, sigma = float(found.B[0]), float(found.u_rms[0])
    x = (g - m) / sigma
    Q, phi = math.erfc(x / math.sqrt(2)) / 2, math.exp(-x * x / 2) / math.sqrt(2 * math.pi)
    assert m + k * sigma * (phi - x * Q) == pytest.approx(load, rel=1e-12)
    assert sigma**2 * (1 + k * Q) == pytest.approx(math.pi * S_0 / (2 * zeta), rel=1e-12)


def test_a_force_in_many_pieces_is_that_of_their_union():
    line = Duffing(1.0, 0.3).restoring_force().pieces[0]
    cut = Force((line,) * 801, tuple(np.geomspace(0.02, 20.0, 800)))
    system = EquationOfMotion(cut, 0.01, 0.05, load=0.4)
    found = stationary(system, White(0.01))
    whole = Duffing(1.0, 0.3, mu=0.01, zeta=0.05, load=0.4).random(S_0=0.01)
    assert found["u_rms"] == pytest.approx(whole.u_rms, rel=1e-12)
    assert found["B"] == pytest.approx(whole.B, rel=1e-12)


@pytest.mark.parametrize("cut", [0, sp.Rational(1, 1000)])
def test_a_motion_in_a_narrow_stiff_zone_is_found(cut):
    """All of the zone lies in one cell of the search's range, whose mean slope is a quarter of that at the motion.

    A narrow piece of the spring beyond it is joined with it: the steeper slope is that of the cell.
    """
    u, half = sp.Symbol("u"), sp.Rational(65, 1000)
    beyond = 2 - 2 * half + u
    pieces = [(u, 1), (2 + ((u - 1 - half) / half) ** 3, 1 + 2 * half)]
    pieces += [*([(beyond, 1 + 2 * half + cut)] if cut else []), (beyond, None)]
    zone = derive.mechanism("narrow_stiff_zone", pieces, {}, odd=False, compile=False)
    x, sigma = 0.9, 1e-3
    k, load = 3 * x**2 / 0.065, 2 + x**3
    found = zone(zeta=0.05, load=load).random(S_0=2 * 0.05 * k * sigma**2 / math.pi)
    assert found.u_rms == pytest.approx([sigma], rel=1e-3)
    assert found.B == pytest.approx([1.065 + 0.065 * x], rel=1e-4)


def test_a_motion_is_found_although_narrow_pieces_pull_outwards():
    """Each is joined with the narrow piece after it to one cell, which pushes back as little as either of them."""
    u, w = sp.Symbol("u"), sp.Rational(3, 100)
    left, right = [(u, -1 - 2 * w), (u + 133, -1 - w), (u, -1)], [(u, 1), (u - 133, 1 + w), (u, 1 + 2 * w)]
    one = derive.mechanism("narrow_pulls", [*left, *right, (u, None)], {}, odd=False, compile=False)(zeta=0.05)
    found = one.random(S_0=0.1)
    excess, stiffness = averages(one.restoring_force(), 0.0, float(found.B[0]), float(found.u_rms[0]))
    assert excess == pytest.approx(0.0, abs=1e-9)
    assert found.u_rms**2 * stiffness == pytest.approx([math.pi], rel=1e-9)


@pytest.mark.parametrize("case", range(3))
def test_small_motions_have_the_mean_of_the_exact_density(case, stop):
    """What a mean is off its equilibrium, -f'' sigma^2/(2 f'), and sigma next to it; a quadratic force about a load."""
    one, S_0 = (
        (Duffing(1.0, 1.0, zeta=0.05, load=0.8), 2e-5),
        (Isolator(**DESIGN, zeta=0.05, load=0.06), 1e-5),
        (stop(k=0.1, g=0.05, zeta=0.05, load=0.05), 2e-4),
    )[case]
    found, (mean, rms) = one.random(S_0=S_0), exact_moments(one, S_0)
    rest = float(one.rest().u[0])
    assert found.B[0] - rest == pytest.approx(mean - rest, rel=0.03)
    assert found.u_rms[0] == pytest.approx(rms, rel=2e-3)


@pytest.mark.parametrize("S_0", (1e-10, 1e-13, 1e-16))
def test_smallest_motions_are_those_about_the_equilibrium(S_0):
    """u + u^3 = load: u_rms^2 is pi S_0/(c k) but for terms of 1 + 3 u_rms^2/u^2, and digits that the mean takes."""
    one = Duffing(1.0, 1.0, zeta=0.05, load=0.3)
    rest = brentq(lambda u: u + u**3 - 0.3, 0.0, 0.3, xtol=1e-16)
    k = 1 + 3 * rest**2
    rms = math.sqrt(math.pi * S_0 / (0.1 * k))
    found = one.random(S_0=S_0)
    near = 10 * (rms / rest) ** 2 + 1e-15 * rest / rms
    assert found.u_rms == pytest.approx([rms], rel=near)
    assert found.B == pytest.approx([rest], rel=near)
    with pytest.raises(ArithmeticError, match="too small compared with its mean"):
        one.random(S_0=1e-12 * S_0)
    assert one.many(alpha=1.0, beta=1.0, mu=0.0, zeta=0.05, load=0.3).random(S_0=[S_0, 1e-12 * S_0]).count.tolist() == [
        1,
        0,
    ]


@pytest.mark.parametrize("excitation", ({"S_0": 1e-3}, {"psd": FLOOR}))
@pytest.mark.parametrize("case", range(2))
def test_gradient_about_a_mean_is_that_of_its_answers(case, excitation, stop):
    one = (
        stop(k=5.0, g=0.2, mu=0.005, zeta=0.05, load=0.1)
        if case
        else Isolator(**DESIGN, mu=0.005, zeta=0.02, load=0.04)
    )
    gradient = check_gradient(one, step=1e-5, rel=1e-5, **excitation)
    assert gradient.of == ("u_rms", "v_rms", "a_rms", "B")


def test_largest_displacement_about_a_mean_is_absolute():
    """Far from the centre it is on one side: half as many passages, |B| + sigma (sqrt(2 ln n) + .5772/sqrt(2 ln n))."""
    one, tau = Duffing(1.0, 0.0, zeta=0.5), 1e6
    found = one.replace(load=-5.0).random(S_0=0.01)
    root = math.sqrt(2 * math.log(tau / math.tau))
    assert (found.largest(tau)[0] - 5.0) / found.u_rms[0] == pytest.approx(root + 0.5772 / root, rel=2e-3)
    near = one.replace(load=1e-9).random(S_0=0.01).largest(tau)
    assert near[0] == pytest.approx(one.random(S_0=0.01).largest(tau)[0], rel=1e-6)


def test_a_force_that_is_not_linear_about_its_mean_is_named(stop):
    """A stop nine times as stiff: root mean squares 8 % below the exact density's; a double well: 66 %."""
    one, S_0 = stop(k=1.0, g=0.2, zeta=0.05), 0.1 / math.pi * 0.04
    assert one.random(S_0=S_0).message == ""
    assert one.random(S_0=S_0).u_rms[0] == pytest.approx(exact_moments(one, S_0)[1], rel=0.01)
    stiff = one.replace(k=9.0)
    found, (_, rms) = stiff.random(S_0=S_0), exact_moments(stiff, S_0)
    assert "0.35 of the mean square of the force is not linear" in found.message
    assert found.u_rms[0] / rms == pytest.approx(0.916, abs=2e-3)
    well = Duffing(-1.0, 1.0, zeta=0.05, load=0.1)
    found, (_, rms) = well.random(S_0=4e-3), exact_moments(well, 4e-3)
    assert len(found) == 1
    assert "several equilibria" in found.message
    assert found.u_rms[0] / rms == pytest.approx(0.34, abs=2e-3)
    assert "several equilibria" not in well.replace(load=0.5).random(S_0=8e-3).message


def test_friction_about_a_mean_is_named_from_a_lower_fraction():
    one, S_0 = Isolator(**DESIGN, mu=0.02, zeta=0.02), 1e-3
    centred, found = one.random(S_0=S_0), one.replace(load=0.04).random(S_0=S_0)
    assert 0.6 < found.dry[0] < 0.8 and centred.dry[0] < 0.8
    assert centred.message == "" and "above 0.6 root mean squares" in found.message
    assert "fokker_planck has the exact density" in found.message


# ---- motions in time


@pytest.mark.slow
def test_records_about_a_mean_have_the_exact_density(stop):
    one, S_0 = stop(k=5.0, g=0.2, zeta=0.05, load=0.1), 2e-3
    mean, rms = exact_moments(one, S_0)
    answer, v_rms = one.random(S_0=S_0), math.sqrt(math.pi * S_0 / (2 * one.zeta))
    density = answer.fokker_planck
    assert (density.B, density.u_rms, density.v_rms) == pytest.approx((mean, rms, v_rms), rel=1e-4)
    found = answer.measure(samples=400_000, records=8, seed=3)
    assert_measured(found, B=mean, u_rms=rms, v_rms=v_rms)
    assert 1.5 * found.B_margin < 0.1 * rms > 1.5 * found.u_margin


def test_records_of_a_loaded_linear_oscillator_are_its_answer():
    found = Duffing(1.0, 0.0, zeta=0.05, load=0.7).random(psd=FLOOR)
    record = found.measure(samples=200_000, records=8, seed=4)
    assert_measured(record, B=0.7, **{f"{name}_rms": getattr(found, f"{name}_rms")[0] for name in "uva"})
    assert record.kurtosis == pytest.approx(3.0, abs=0.5)


# ---- mounts and scenes


@pytest.mark.slow
def test_a_mount_that_carries_another_mass_is_answered(tmp_path):
    mount = Isolator.physical(**MOUNT, load=12.5)
    found = mount.random(psd=ROAD)
    omega = math.sqrt(2500 / 12.5)
    Omega, G = np.array(ROAD[0]) * math.tau / omega, np.array(ROAD[1]) * 9.80665**2
    plain = mount.oscillator.random(psd=(Omega, G * omega / math.tau / (0.080 * omega**2) ** 2))
    assert found.B[0] == pytest.approx(0.080 * plain.B[0], rel=1e-11)
    assert found.x_rms[0] == pytest.approx(0.080 * plain.u_rms[0], rel=1e-11)
    assert found.units["B"] == "m"
    one = read(scene(tmp_path, mount={**MOUNT, "load": 12.5}, ask={"questions": ["random"]}, psd=PSD))
    assert one.answer(one.queries[0]).B[0] == pytest.approx(1e3 * found.B[0], rel=1e-11)
    assert "Random vibration" in report.html(one)
    assert "linearization" in str(mount.explain("random"))


# ---- what is refused


def test_random_motions_about_a_mean_say_what_they_have_not(stop):
    with pytest.raises(ArithmeticError, match="exceeds the load far from the centre, on both sides"):
        Duffing(1.0, -0.1, zeta=0.05, load=0.1).random(S_0=1e-3)
    with pytest.raises(Refused, match="defined at one frequency"):
        Duffing(1.0, 1.0, zeta=0.05, eta=0.1, load=0.1).random(S_0=1e-3)
    with pytest.raises(ArithmeticError, match="friction holds"):
        Duffing(1.0, 1.0, mu=0.5, zeta=0.02, load=0.1).random(psd=spread(1e-3))
