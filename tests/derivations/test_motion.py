"""The generated equation of motion (3): any kind of number, and derivatives that are its own."""

import math

import numpy as np
import pytest

from slowflow.core.mechanism import Force
from slowflow_kernels import duffing, motion, rod_spring, rod_spring_untruncated

COMPLEX_STEP = 1e-100  # the derivative of an analytic expression is exact to rounding for any step this small
EXACT = {"rtol": 1e-14, "atol": 1e-15}

FORCES = (
    Force.of(duffing.MECHANISM, (-0.2, 1.7)),
    Force.of(rod_spring.MECHANISM, (0.3, 2.5, 1.9, 0.4)),
    Force.of(rod_spring_untruncated.MECHANISM, rod_spring_untruncated.coefficients(3.0, 2.03, 0.08)),
)
PIECES = [piece for force in FORCES for piece in force.pieces]


def drawn(random):
    """Omega, F_0, zeta, friction, theta, u, v."""
    return random.uniform(0.1, 2.0, 7)


@pytest.mark.parametrize("piece", PIECES)
def test_the_slope_of_a_piece_is_the_derivative_of_its_force(piece):
    for u in (-0.3, 1e-9, 0.1, 0.39):
        step = complex(u, COMPLEX_STEP)
        np.testing.assert_allclose(piece.slope(u), piece(step).imag / COMPLEX_STEP, **EXACT)


@pytest.mark.parametrize("piece", PIECES)
def test_derivatives_are_those_of_the_rates(piece):
    random = np.random.default_rng(3)
    for _ in range(50):
        Omega, F_0, zeta, friction, theta, u, v = drawn(random)
        u = 0.2 * u  # within the reach

        def rates(u, v, Omega, F_0, zeta, friction, theta=theta):
            return np.array(motion.rates(math.cos(theta), v, Omega, F_0, zeta, friction, piece(u)))

        point = (u, v, Omega, F_0, zeta, friction)
        columns = [
            rates(*(complex(x, COMPLEX_STEP * (k == j)) for j, x in enumerate(point))).imag / COMPLEX_STEP
            for k in range(6)
        ]
        by_state = np.reshape(motion.rates_by_state(Omega, zeta, piece.slope(u)), (2, 2))
        by_parameter = np.reshape(
            motion.rates_by_parameter(math.cos(theta), v, Omega, F_0, zeta, friction, piece(u)), (2, 5)
        )
        np.testing.assert_allclose(by_state, np.transpose(columns[:2]), **EXACT)
        np.testing.assert_allclose(by_parameter[:, :4], np.transpose(columns[2:]), **EXACT)
        # a parameter of the force enters through f alone
        np.testing.assert_allclose(by_parameter[:, 4] * piece.slope(u), columns[0], **EXACT)


def test_push_at_rest_is_the_acceleration_without_friction():
    random = np.random.default_rng(4)
    for _ in range(50):
        _, F_0, zeta, friction, theta, f, f_u = drawn(random)
        cosine, sine = math.cos(theta), math.sin(theta)
        push = motion.push(cosine, F_0, f)
        assert push == motion.acceleration(cosine, 0.0, F_0, zeta, 0.0, f)
        by_theta, by_u, by_F_0 = motion.push_slopes(cosine, sine, F_0, f_u)
        turned = motion.push(np.cos(complex(theta, COMPLEX_STEP)), F_0, f).imag / COMPLEX_STEP
        np.testing.assert_allclose(by_theta, turned, **EXACT)
        assert (by_u, by_F_0) == (-f_u, cosine)
        # at break-away the push is what friction can hold
        there = motion.breakaway(F_0, friction, f)
        np.testing.assert_allclose(motion.push(there, F_0, f), friction, rtol=1e-14, atol=1e-15)


def test_one_text_serves_arrays_as_it_serves_numbers():
    random = np.random.default_rng(5)
    columns = random.uniform(0.1, 2.0, (7, 20))
    together = np.array(motion.rates(*columns))
    for k in range(20):
        assert tuple(together[:, k]) == motion.rates(*map(float, columns[:, k]))


def test_an_integrators_symbols_pass_through():
    heyoka = pytest.importorskip("heyoka")
    names = ("cosine", "v", "Omega", "F_0", "zeta", "friction", "f")
    symbols = heyoka.make_vars(*names)
    random = np.random.default_rng(6)
    values = random.uniform(0.1, 2.0, 7)
    evaluate = heyoka.cfunc(list(motion.rates(*symbols)), symbols)
    np.testing.assert_allclose(evaluate(values), motion.rates(*values), rtol=1e-15)


def test_smoothed_equation_has_derivatives_and_becomes_sharp():
    random = np.random.default_rng(7)
    inner, outer = FORCES[1].pieces
    u_cr, nu = 0.4, 50.0

    def step(x):
        return 1.0 / (1.0 + np.exp(-nu * x))

    def rates(u, v, F_0, mu, zeta, theta):
        blend = step(u + u_cr), step(u - u_cr), np.tanh(nu * v), inner(u), outer(u)
        return np.array(motion.smoothed(math.cos(theta), v, F_0, mu, zeta, *blend))

    for _ in range(50):
        _, F_0, zeta, mu, theta, u, v = drawn(random)
        u = 0.3 * u  # on both sides of the breakpoint
        v = 0.01 * v
        numeric = [
            rates(complex(u, COMPLEX_STEP), v, F_0, mu, zeta, theta).imag / COMPLEX_STEP,
            rates(u, complex(v, COMPLEX_STEP), F_0, mu, zeta, theta).imag / COMPLEX_STEP,
        ]
        blend = step(u + u_cr), step(u - u_cr), np.tanh(nu * v), inner(u), outer(u), inner.slope(u), outer.slope(u)
        by_state = np.reshape(motion.smoothed_by_state(mu, zeta, nu, *blend), (2, 2))
        np.testing.assert_allclose(by_state, np.transpose(numeric), rtol=1e-13, atol=1e-13)
        # steps at their ends: the sharp equation of the piece that holds
        for left, right, force in ((1.0, 0.0, inner(u)), (1.0, 1.0, outer(u))):
            _, acceleration = motion.smoothed(math.cos(theta), v, F_0, mu, zeta, left, right, 1.0, inner(u), outer(u))
            sharp = motion.acceleration(math.cos(theta), v, F_0, zeta, mu, force)
            np.testing.assert_allclose(acceleration, sharp, rtol=1e-13, atol=1e-14)
