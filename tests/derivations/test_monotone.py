"""h_AAA is monotone on each piece of a force: proved for every mechanism, refused where it is not so."""

import dataclasses

import mpmath
import pytest
import sympy as sp

from derivations.forces.monotone import prove_monotone
from derivations.mechanisms import L, Mechanism, Parameter, Piece, all_mechanisms, k_v, x
from derivations.paper.equation_of_motion import oscillator

b_1, b_2, k = sp.symbols("b_1 b_2 k", positive=True)
alpha, beta, gamma, gap_1, gap_2 = sp.symbols("alpha beta gamma gap_1 gap_2", real=True)
KAPPA, GAP_1, GAP_2 = sp.symbols("kappa g_1 g_2", positive=True)


def h_AAA(force, cuts, A):
    """Of a force on u > 0 by quadrature, from 15 digits of h: differences of the quarter-cycle integral."""
    with mpmath.workdps(45):

        def h(a):
            ends = [mpmath.mpf(0), *(mpmath.asin(b / a) for b in cuts if b < a), mpmath.pi / 2]
            total = mpmath.quad(lambda t: force(a * mpmath.sin(t)) * mpmath.sin(t), ends, method="gauss-legendre")
            return -4 / mpmath.pi * total

        return mpmath.diff(h, mpmath.mpf(A), 3, h=mpmath.mpf(10) ** -12)


@pytest.mark.slow
@pytest.mark.parametrize("mechanism", all_mechanisms(), ids=lambda one: one.name)
def test_every_mechanism_is_proved(mechanism):
    prove_monotone(oscillator(mechanism))


@pytest.mark.slow
@pytest.mark.parametrize(("r", "delta_h"), [(2.0, 0.08), (0.5, 0.9), (1.0, 0.01)])
def test_what_is_proved_of_the_isolator_shows(r, delta_h):
    lam, u_cr = 3, mpmath.sqrt(delta_h * (2 - delta_h))
    alpha, beta = 1 - lam * r * delta_h, lam * r * (1 - delta_h) / 2

    def force(u):
        return alpha * u + beta * u**3 + beta * 3 / 4 * u**5 if u <= u_cr else u

    for ratios in ((0.1, 0.5, 0.9), (1.02, 1.1, 1.5, 3.0, 10.0)):
        values = [h_AAA(force, [u_cr], u_cr * ratio) for ratio in ratios]
        assert values in (sorted(values), sorted(values, reverse=True))


def spring(*forces):
    """Pieces that end at gap_1, gap_2."""
    ends = [*(b_1 - x, b_2 - x)[: len(forces) - 1], None]
    gaps = {GAP_1: b_1 / L, GAP_2: b_2 / L}
    return Mechanism(
        name="spring",
        title="pieces of straight lines",
        pieces=tuple(Piece(force, until=end) for force, end in zip(forces, ends, strict=True)),
        design=tuple(Parameter(symbol, "", "1", above=0) for symbol in (KAPPA, *gaps)),
        ratios={KAPPA: k / k_v, **gaps},
        order=1,
        coefficients=tuple({1: sp.Symbol(f"alpha_{number}", real=True)} for number in range(len(forces))),
        breakpoints=(gap_1, gap_2)[: len(forces) - 1],
    )


def test_a_stop_behind_a_gap_is_proved():
    prove_monotone(oscillator(spring(sp.Integer(0), k * (x - b_1))))


@pytest.mark.slow
def test_force_that_softens_again_is_refused():
    with pytest.raises(ArithmeticError, match="spring: not shown that h_AAA is monotone on piece 3 of the force"):
        prove_monotone(oscillator(spring(sp.Integer(0), k * (x - b_1), k * (x - b_1) - k * (x - b_2) / 10)))
    values = [h_AAA(lambda u: u + max(u - 1, 0) - max(u - 2, 0) / 10, [1, 2], A) for A in (2.001, 2.1, 10.0, 100.0)]
    assert values not in (sorted(values), sorted(values, reverse=True))


def test_a_force_with_a_smooth_breakpoint_is_refused():
    parabola = spring(sp.Integer(0), k * (x - b_1) ** 2 / L)
    smooth = dataclasses.replace(parabola, order=2, coefficients=({1: alpha}, {2: beta, 1: gamma}))
    with pytest.raises(ArithmeticError, match="neither the force nor its slope jumps at gap_1"):
        prove_monotone(oscillator(smooth))
