"""Properties of oscillators that hypothesis draws: scaling, counts, continuity, and one answer by every way to it."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pytest
from flint import arb, ctx
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from slowflow import Duffing, Isolator
from slowflow.averaged import messages
from slowflow_kernels import duffing, duffing_balls, rod_spring, rod_spring_balls
from slowflow_kernels import rod_spring_untruncated as untruncated
from slowflow_kernels import rod_spring_untruncated_balls as untruncated_balls

#: averages of an oscillator by its force, and the same in balls
AVERAGES = {
    "": (duffing, duffing_balls),
    "truncated": (rod_spring, rod_spring_balls),
    "untruncated": (untruncated, untruncated_balls),
}
#: near a cusp a fold moves by the root of a rounding
NEARLY = 1e-7
drawn = settings(max_examples=40)

duffings = st.builds(
    dict,
    alpha=st.floats(0.1, 3.0),
    beta=st.floats(0.05, 5.0) | st.floats(-5.0, -0.05),
    mu=st.just(0.0) | st.floats(1e-4, 0.1),
    zeta=st.floats(1e-3, 0.5),
)


def close(a, b):
    return a == b or math.isclose(a, b, rel_tol=1e-11)


def scaled_alike(one, other, length, frequency, F_0, Omega):
    """Both oscillators say the same, the second in units in which lengths and frequencies are so many times larger."""
    force = length * frequency**2
    a, b = one.saddle_node_onset(), other.saddle_node_onset()
    assert (a.F_SN is None) == (b.F_SN is None)
    if a.F_SN is not None:
        assert close(a.F_SN * force, b.F_SN) and close(a.A * length, b.A) and close(a.Omega * frequency, b.Omega)
    one_s, other_s = one.saddle_nodes(F_0), other.saddle_nodes(F_0 * force)
    assert [fold.kind for fold in one_s] == [fold.kind for fold in other_s]
    # near a cusp a fold moves by the root of a rounding
    np.testing.assert_allclose(one_s.Omega * frequency, other_s.Omega, rtol=1e-7)
    states = one.amplitudes(Omega=Omega, F_0=F_0)
    others = other.amplitudes(Omega=Omega * frequency, F_0=F_0 * force)
    assert states.stable.tolist() == others.stable.tolist()
    np.testing.assert_allclose(states.A * length, others.A, rtol=1e-7)


def assert_alike(one, other, fields, tolerance):
    """As many, at the same places: their digits are held elsewhere, to what they are conditioned."""
    for field in fields:
        a, b = getattr(one, field), getattr(other, field)
        if a is None or b is None:
            assert a is b, (one, other)
        else:
            np.testing.assert_allclose(a, b, rtol=tolerance, atol=1e-2 * tolerance, err_msg=f"{one} {other}")


@pytest.mark.slow
@drawn
@given(duffings, st.floats(0.01, 1.0), st.floats(0.2, 2.5), st.integers(-20, 20), st.integers(-10, 10))
def test_units_of_length_and_time_are_free(numbers, F_0, Omega, p, q):
    """u -> s u and tau -> tau/c, by powers of two so that no number is rounded."""
    s, c = 2.0**p, 2.0**q
    other = Duffing(
        alpha=numbers["alpha"] * c**2,
        beta=numbers["beta"] * c**2 / s**2,
        mu=numbers["mu"] * s * c**2,
        zeta=numbers["zeta"] * c,
    )
    scaled_alike(Duffing(**numbers), other, s, c, F_0, Omega)


@settings(drawn, max_examples=20)
@given(st.floats(1.0, 5.0), st.floats(0.5, 3.0), st.floats(0.1, 0.9), st.floats(0.002, 0.05), st.floats(0.01, 0.1))
def test_nothing_jumps_at_the_untruncated_detachment(lam, r, fraction, mu, zeta):
    """The lowest forcing, its frequency and the backbone on either side of u_cr: a float apart, a rounding apart."""
    oscillator = Isolator(lam=lam, r=r, delta_h=min(fraction / (lam * r), 0.9), mu=mu, zeta=zeta, force="untruncated")
    end = oscillator.detachment().u_cr
    below, above = oscillator.backbone([np.nextafter(end, 0), np.nextafter(end, 2)])
    assert close(below, above)
    F_cr = oscillator.detachment().F_cr
    assert math.isclose(oscillator.peak(F_cr * (1 - 1e-9)).A, oscillator.peak(F_cr * (1 + 1e-9)).A, rel_tol=1e-6)


# --- one answer by every way to it -----------------------------------------------------------------------------------

isolators = st.builds(
    dict,
    lam=st.floats(1.0, 5.0),
    r=st.floats(0.3, 3.0),
    delta_h=st.floats(0.02, 0.6),
    mu=st.just(0.0) | st.floats(1e-4, 0.05),
    zeta=st.floats(3e-3, 0.5),
    force=st.sampled_from(["truncated", "untruncated"]),
)


class Numbers(NamedTuple):
    """Some of an answer's states."""

    A: np.ndarray
    stable: np.ndarray


def made(numbers):
    """The oscillator of drawn numbers, its negative stiffness without a word."""
    return Duffing(**numbers) if "alpha" in numbers else Isolator(**numbers)


@drawn
@given(duffings | isolators, st.floats(1e-3, 1.0), st.floats(0.2, 2.5), st.sampled_from(["mu", "zeta"]))
def test_case_without_a_damper_is_the_limit_of_the_general_one(numbers, above, Omega, without):
    """Without damping other kernels are used; so little friction or damping changes far less than a rounding."""
    scene, general = (made({**numbers, without: value}) for value in (0.0, 1e-20))
    F_0 = general.model.m + above
    states = [one.amplitudes(Omega=Omega, F_0=F_0) for one in (scene, general)]
    # without viscous damping, which alone bounds motions at resonance, an answer is cut, and says where
    A_max = messages.cut(scene.model, F_0)[0] if without == "zeta" else math.inf
    assert_alike(*(Numbers(one.A[one.A < A_max], one.stable[one.A < A_max]) for one in states), ("A", "stable"), NEARLY)


def in_balls(balls, A, beyond, parameters, passed):
    """h to h_AAA, on the side of the breakpoint that is told."""
    if balls is duffing_balls:
        return balls.known(A, *parameters)[:4]
    jump = []
    if balls is rod_spring_balls:
        alpha, beta, gamma, u_cr = parameters
        jump = [(alpha - 1) * u_cr + beta * u_cr**3 + gamma * u_cr**5]
    return balls.known(passed, A, beyond, *parameters, *jump)[:4]


@pytest.mark.slow
@settings(drawn, max_examples=150)
@given(duffings | isolators, st.floats(1e-3, 1.5))
def test_derivatives_of_an_average_are_those_of_its_ball(numbers, A):
    """Against differences of h alone in balls of 1,500 bits, a few times what rounding each argument moves them by."""
    one = made(numbers)
    plain, balls = AVERAGES[numbers.get("force", "")]
    (end,) = [*plain.breakpoints(*one.model.parameters), math.inf][:1]
    # what is widened by a rounding has a side, a slope there that is finite, and is not 1, where quotients are 0/0
    assume(abs(A - end) > 1e-9 * A and abs(A - 1) > 1e-9)
    found, passed, step = plain.averaged(A, *one.model.parameters), int(A > end), arb(2) ** -300
    with ctx.workprec(1500):
        p = [arb(float(number)) for number in one.model.parameters]
        u_cr = [*(balls.breakpoints(*p) if hasattr(balls, "breakpoints") else ()), arb(0)][0]
        h = {k: in_balls(balls, A + k * step, A + k * step - u_cr, p, passed)[0] for k in range(-2, 3)}
        exact = (
            h[0],
            (h[1] - h[-1]) / (2 * step),
            (h[1] - 2 * h[0] + h[-1]) / step**2,
            (h[2] - 2 * h[1] + 2 * h[-1] - h[-2]) / (2 * step**3),
        )
        widened = [number * arb(1, 2.0**-53) for number in (A, *p)]
        u_cr = [*(balls.breakpoints(*widened[1:]) if hasattr(balls, "breakpoints") else ()), arb(0)][0]
        near = in_balls(balls, widened[0], widened[0] - u_cr, widened[1:], passed)
        for k, (value, derivative, ball) in enumerate(zip(found, exact, near, strict=True)):
            assert ball.rad().is_finite(), k
            assert abs(arb(float(value)) - derivative) <= 4 * (ball.rad() + abs(derivative) * arb(2) ** -53), (k, value)


@pytest.mark.parametrize("law", [{}, {"eta": 0.05}])
@pytest.mark.parametrize("octaves", [-150, 50, 70, 150])
def test_an_onset_goes_with_the_unit_of_length(law, octaves):
    """By a power of two nothing is rounded otherwise: a stiffening spring has folds, however large it is."""
    s = 2.0**octaves
    one = Duffing(0.5, 2.25, 0.0, 0.0954, **law).saddle_node_onset()
    other = Duffing(0.5, 2.25 / s / s, 0.0, 0.0954, **law).saddle_node_onset()
    assert [other.F_SN / s, other.Omega, other.A / s] == pytest.approx([one.F_SN, one.Omega, one.A], rel=1e-12)


def test_what_is_too_small_or_too_large_for_doubles_is_refused():
    for s in (2.0**-400, 2.0**420):
        for law in ({}, {"eta": 0.05}):
            tiny = Duffing(0.5, 2.25 / s / s, 0.0, 0.0954, **law)
            with pytest.raises(ArithmeticError, match="unresolved"):
                tiny.saddle_node_onset()
    tiny = Duffing(0.5, 2.25 * 2.0**800, 0.0, 0.0954, eta=0.05)
    F_0 = 0.2 * 2.0**-400
    for question in (lambda: tiny.saddle_nodes(F_0), lambda: tiny.amplitudes(Omega=1.0, F_0=F_0)):
        with pytest.raises(ArithmeticError, match="unresolved"):
            question()


def test_forcing_next_to_the_largest_double_is_answered():
    """By NumPy it is refused, in words too."""
    assert "unbounded" in Duffing(0.0, 1.0).amplitudes(Omega=1.0, F_0=1.7e308).message
