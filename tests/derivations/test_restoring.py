"""The averaged force's forms against quadrature, for a force that no mechanism has."""

from __future__ import annotations

import functools
import itertools

import pytest
import sympy as sp
from mpmath import mp, mpf

from derivations.forces.harmonics import HARMONICS, of_polynomials
from derivations.paper.restoring_force import FAR, moment_parts, moment_series, odd_moment, quarter_moment, restoring
from derivations.paper.restoring_force import average as average_of
from derivations.symbols import A, u
from tests.derivations.test_emit import evaluated

b_1, b_2 = sp.symbols("b_1 b_2", real=True)
#: three pieces, two breakpoints, jumps at both; even powers and constants, in the last force from rest on
FORCES = {
    "odd powers": (sp.Rational(1, 2) * u + 3 * u**3 - u**5, 2 * u - u**3, u + u**3 / 4),
    "even powers": (
        sp.Rational(1, 2) * u + 3 * u**3,
        sp.Rational(1, 5) + 2 * u - u**2,
        u**4 / 3 + u + u**3 / 4 - sp.Rational(2, 7),
    ),
    "linear, then not": (sp.Rational(3, 4) * u, 2 * u - sp.Rational(3, 8) + u**2, u**3 / 4 + 3 * u - sp.Rational(2, 7)),
    "a preload": (
        sp.Rational(1, 5) + u / 2 + 3 * u**2 - u**3,
        sp.Rational(1, 3) + 2 * u - u**2,
        u**4 / 3 + u - sp.Rational(2, 7),
    ),
}
ENDS = {b_1: mpf("0.3"), b_2: mpf("0.5")}
DIGITS = 30


@pytest.fixture(autouse=True)
def precise():
    with mp.workdps(36):
        yield


#: the fast tests have one of them: each is derived anew
SLOW = ("even powers", "linear, then not", "a preload")


@pytest.fixture(
    scope="module", params=[pytest.param(name, marks=[pytest.mark.slow] * (name in SLOW), id=name) for name in FORCES]
)
def pieces(request):
    return FORCES[request.param]


@pytest.fixture(scope="module")
def average(pieces):
    return restoring(pieces, (b_1, b_2))


#: cos(n x) by cos(x), which is the sine of what x lacks to a right angle
CHEBYSHEV = {1: lambda x: x, 3: lambda x: x * (4 * x**2 - 3), 5: lambda x: x * ((16 * x**2 - 20) * x**2 + 5)}


def by_quadrature(pieces, amplitude, count, harmonic=1):
    """A harmonic of the force and its derivatives, with `count` breakpoints exceeded; the first is the average."""
    forces = [sp.lambdify(u, piece, "mpmath") for piece in pieces]

    def of(a):
        cuts = [mpf(0), *(mp.asin(b / a) for b in list(ENDS.values())[:count]), mp.pi / 2]
        integrals = []
        for f, interval in zip(forces, itertools.pairwise(cuts), strict=False):

            def weighted(t, f=f):
                sine = mp.sin(t)
                return f(a * sine) * CHEBYSHEV[harmonic](sine)

            integrals.append(mp.quad(weighted, interval, method="gauss-legendre"))
        return -4 / mp.pi * mp.fsum(integrals)

    return [c * mp.factorial(k) for k, c in enumerate(mp.taylor(of, amplitude, 3))]


def values(regime, amplitude, jumps=None):
    """The average, its derivatives, and its intercept, which harmonics have not."""
    outputs = [value for value in (*regime.derivatives, regime.intercept) if value is not None]
    return evaluated(regime.lets, outputs, {A: amplitude, **ENDS, **(jumps or {})})


def by_quadrature_with_intercept(pieces, amplitude, count):
    found = by_quadrature(pieces, amplitude, count)
    return [*found, found[0] - amplitude * found[1]]


@pytest.mark.slow
@pytest.mark.parametrize(("count", "amplitude"), [(0, "0.2"), (1, "0.31"), (1, "0.49"), (2, "0.501"), (2, "2")])
@pytest.mark.part(3)
def test_closed_form(pieces, average, count, amplitude):
    exact = by_quadrature_with_intercept(pieces, mpf(amplitude), count)
    for one, other in zip(values(average.regimes[count], mpf(amplitude)), exact, strict=True):
        assert abs(one - other) <= mpf(10) ** -DIGITS * (1 + abs(other))


FAR_POINTS = [(1, 1, "0.376"), (2, 1, "0.55"), (2, 2, "0.626"), (2, 2, "40")]


@pytest.mark.slow
@pytest.mark.parametrize(("count", "far", "amplitude"), FAR_POINTS)
@pytest.mark.part(3)
def test_far_form_to_working_precision(pieces, average, count, far, amplitude):
    exact = by_quadrature_with_intercept(pieces, mpf(amplitude), count)
    for one, other in zip(values(average.far_regimes[count, far], mpf(amplitude)), exact, strict=True):
        assert abs(one - other) <= mpf(2) ** -54 * (1 + abs(other))


@pytest.mark.slow
def test_far_form_with_jumps_that_have_names(pieces):
    """As of a kernel to which the jumps are given."""
    names = sp.symbols("jump_1 jump_2", real=True)
    ends, count = (b_1, b_2), 2
    jumps = {
        name: mpf(sp.N((below - above).subs(u, sp.Rational(str(ENDS[b]))), 40))
        for name, below, above, b in zip(names, pieces, pieces[1:], ends, strict=False)
    }
    exact = by_quadrature_with_intercept(pieces, mpf("0.626"), count)
    found = values(average_of(pieces, ends, count, 2, names), mpf("0.626"), jumps)
    for one, other in zip(found, exact, strict=True):
        assert abs(one - other) <= mpf(2) ** -54 * (1 + abs(other))


@functools.cache
def harmonics(pieces):
    """Its regimes by name, derived once."""
    return {case.name: case.regime for case in of_polynomials(pieces, (b_1, b_2)).cases}


@pytest.mark.slow
@pytest.mark.parametrize(("count", "far", "amplitude"), [(0, 0, "0.2"), (1, 0, "0.31"), (2, 0, "0.501"), *FAR_POINTS])
@pytest.mark.part(7)
def test_higher_harmonics(pieces, count, far, amplitude):
    """Every form of h_3 and h_5; the series leave out less than rounding does."""
    regime = harmonics(pieces)[f"passed_{count}" + (f"_far_{far}" if far else "")]
    exact = [value for n in HARMONICS for value in by_quadrature(pieces, mpf(amplitude), count, n)]
    bound = mpf(2) ** -54 if far else mpf(10) ** -DIGITS
    for one, other in zip(values(regime, mpf(amplitude)), exact, strict=True):
        assert abs(one - other) <= bound * (1 + abs(other))


def test_harmonics_that_vanish():
    """A linear force has none; a cubic one has a third, beta A^3/4, and no fifth."""
    (case,) = of_polynomials((3 * u,), ()).cases
    assert set(case.regime.derivatives) == {0}
    (case,) = of_polynomials((u**3,), ()).cases
    assert case.regime.derivatives[:4] == (-(A**3) / 4, -3 * A**2 / 4, -3 * A / 2, -sp.Rational(3, 2))
    assert set(case.regime.derivatives[4:]) == {0}


def at(polynomial, point):
    return mp.polyval([mpf(c.p) / c.q for c in polynomial.all_coeffs()], point)


@pytest.mark.parametrize("power", [2, 4, 6, 8])
def test_moments(power):
    theta = sp.Symbol("theta", positive=True)
    secular, polynomial = moment_parts(power)
    x, y = sp.sin(theta), sp.cos(theta)
    closed = secular * theta - x * y * polynomial.as_expr().subs(polynomial.gen, x)
    assert sp.expand(sp.diff(closed, theta).rewrite(sp.exp) - (sp.sin(theta) ** power).rewrite(sp.exp)).expand() == 0
    for fraction in (mpf("0.999"), mpf("0.3"), mpf("1e-6")):
        angle = mp.asin(fraction / mpf(FAR.p) * FAR.q)
        half = mp.sin(angle / 2)
        series = half ** (power + 1) * at(moment_series(power), half**2)
        exact = mp.quad(lambda t: mp.sin(t) ** power, [0, angle], method="gauss-legendre")
        assert abs(series / exact - 1) < mpf(2) ** -54


@pytest.mark.parametrize("power", [1, 3, 5, 7])
def test_moments_of_odd_powers(power):
    """Both ends of the quarter cycle, at any angle: the series ends."""
    rest, series = odd_moment(power), moment_series(power)
    assert all(c >= 0 for c in rest.all_coeffs()) and quarter_moment(power) == rest.eval(0)
    for angle in (mpf("1e-6"), mpf("0.9"), mp.pi / 2):
        x, y, half = mp.sin(angle), mp.cos(angle), mp.sin(angle / 2)
        from_zero = half ** (power + 1) * at(series, half**2)
        exact = mp.quad(lambda t: mp.sin(t) ** power, [0, angle], method="gauss-legendre")
        assert abs(from_zero / exact - 1) < mpf(10) ** -DIGITS
        to_quarter = y * at(rest, x)
        exact = mp.quad(lambda t: mp.sin(t) ** power, [angle, mp.pi / 2], method="gauss-legendre")
        assert abs(to_quarter - exact) < mpf(10) ** -DIGITS


def test_no_breakpoint_no_lets():
    assert restoring((u + u**3,), ()).regimes[0].lets == ()
    assert restoring((u + u**3,), ()).far_regimes == {}
