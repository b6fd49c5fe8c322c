"""Double-double as the derivation prints it: against exact fractions, where plain doubles have cancelled to nothing."""

from __future__ import annotations

import operator
from fractions import Fraction
from functools import partial

import numpy as np
import pytest
import sympy as sp

from derivations.codegen import compensated
from derivations.codegen.compensated import Exact, magnitude
from slowflow.core.backend import SOLVER as roots
from slowflow_kernels import frequencies
from tests.sampling import fewer

a, b, c = sp.symbols("a b c", real=True)
x = sp.Symbol("x", positive=True)
a_low = sp.Symbol("a_low", real=True)


def exact(name, Omega, *others):
    """F or F_A/2 over the rationals; Omega is a fraction."""
    A, *x = (Fraction(float(value)) for value in others)
    F_0, m, zeta, h, h_A = (*x, 0) if name == "response" else (0, *x)
    R, I = A * Omega**2 + h, 2 * zeta * A * Omega + m
    return R**2 + I**2 - F_0**2 if name == "response" else R * (Omega**2 + h_A) + 2 * zeta * Omega * I


def near_roots(name, count):
    """Arguments of a quartic at its roots, at neighbouring doubles of these, and at random."""
    random = np.random.default_rng(8)
    A, zeta = np.exp(random.uniform(-6, 1, count)), np.exp(random.uniform(-9, 0, count))
    h, m = -np.exp(random.uniform(-6, 1, count)), np.exp(random.uniform(-9, -2, count))
    if name == "response":
        F_0 = m + np.exp(random.uniform(-7, 1, count))
        arguments, found = (A, F_0, m, zeta, h), roots.response_roots(A, h, m, zeta, F_0)[0][:, 0]
    else:
        h_A = random.uniform(-3, 1, count)
        arguments, found = (A, m, zeta, h, h_A), roots.fold_roots(A, h, h_A, m, zeta)[0][:, 0]
    Omega = np.where(np.isnan(found), random.uniform(0.1, 2, count), found)
    Omega = np.nextafter(Omega, random.choice([0, 9], count))
    return np.array((Omega, *arguments))


@pytest.mark.parametrize("name", ["response", "fold"])
def test_errors_stay_below_their_bounds_where_the_terms_cancel(name):
    rows = near_roots(name, fewer(2000, 5))
    tails = rows[0] * np.random.default_rng(9).uniform(-1, 1, rows.shape[1]) * 2.0**-54
    plain, size = getattr(frequencies, name)(*rows)
    fine, fine_size = getattr(frequencies, name + "_fine")(*rows)
    with_tails, _ = getattr(frequencies, name + "_beside")(rows[0], tails, *rows[1:])
    cancelled = 0
    for k, (Omega, *others) in enumerate(rows.T):
        value = exact(name, Fraction(Omega), *others)
        beyond = exact(name, Fraction(Omega) + Fraction(tails[k]), *others)
        assert abs(Fraction(plain[k]) - value) <= Fraction(frequencies.ROUGH) * Fraction(size[k])
        # rounded to a double at last
        bound = Fraction(frequencies.FINE) * Fraction(fine_size[k])
        assert abs(Fraction(fine[k]) - value) <= bound + abs(value) / 2**53
        assert abs(Fraction(with_tails[k]) - beyond) <= bound + abs(beyond) / 2**53
        cancelled += abs(value) < Fraction(size[k]) / 2**45
    # this was a test: most values are what rounding hides
    assert cancelled > rows.shape[1] / 2


def test_the_derivative_in_pairs_is_exact_to_double_double():
    for name in ("response", "fold"):
        rows = near_roots(name, 500)
        arguments = rows[[1, 3, 4, 5]] if name == "response" else rows[1:]
        p, p_low, q, q_low, k = (
            np.broadcast_to(x, rows.shape[1]) for x in getattr(frequencies, f"{name}_derivative")(*arguments)
        )
        for j, (A, *x) in enumerate(rows[1:].T):
            A, *x = (Fraction(value) for value in (A, *x))
            _, m, zeta, h, h_A = (*x, 0) if name == "response" else (0, *x)
            terms = (h, 2 * zeta**2 * A) if name == "response" else (h / 2, A * h_A / 2, 2 * zeta**2 * A)
            assert abs(Fraction(p[j]) + Fraction(p_low[j]) - sum(terms)) <= sum(map(abs, terms)) / 2**100
            assert p[j] == p[j] + p_low[j] and q[j] == q[j] + q_low[j]
            assert Fraction(q[j]) + Fraction(q_low[j]) == zeta * m / (1 if name == "response" else 2)
            # the quartic's derivative is k (A w^3 + p w + q), by an exact difference of the quartic itself
            w, step = Fraction(3, 2), Fraction(1, 2**80)
            slope = (exact(name, w + step, *rows[1:, j]) - exact(name, w - step, *rows[1:, j])) / (2 * step)
            cubic = Fraction(k[j]) * (A * w**3 + sum(terms) * w + zeta * m / (1 if name == "response" else 2))
            assert abs(slope - cubic) <= Fraction(k[j]) * A / 2**100 * 2**20


def test_the_discriminant_tells_double_roots_apart():
    """A (w - s)^2 (w + 2 s) has a double root: p = -3 A s^2, q = 2 A s^3; q an ulp more or less decides."""
    random = np.random.default_rng(10)
    for _ in range(500):
        A, s = random.uniform(0.1, 2), Fraction(random.uniform(0.1, 2))
        exact_p, exact_q = -3 * Fraction(A) * s**2, 2 * Fraction(A) * s**3
        p, q = float(exact_p), float(exact_q)
        p_low, q_low = float(exact_p - Fraction(p)), float(exact_q - Fraction(q))
        value, first = frequencies.discriminant(A, p, p_low, q, q_low)
        assert abs(value) <= frequencies.FINE * first
        for sign in (1, -1):
            changed, _ = frequencies.discriminant(A, p, p_low, q, q_low + sign * q * 2.0**-80)
            assert changed * sign < 0


def test_value_at_rest_has_its_sign_where_it_all_but_vanishes():
    random = np.random.default_rng(11)
    for _ in range(500):
        h, m = random.uniform(-1, 1), random.uniform(0, 1)
        for F_0 in (np.hypot(h, m), np.nextafter(np.hypot(h, m), 0)):
            value = Fraction(h) ** 2 + Fraction(m) ** 2 - Fraction(F_0) ** 2
            found = Fraction(float(frequencies.response_exactly_at_0(F_0, m, h)))
            assert abs(found - value) <= abs(value) / 2**50


# --- the pass ---------------------------------------------------------------------------------------------------------


def with_error(operation, x, y):
    """A sum or product as a double, and what rounding takes from it."""
    exactly = operation(Fraction(x), Fraction(y))
    return float(exactly), float(exactly - Fraction(float(exactly)))


EXACTLY = {"two_sum": partial(with_error, operator.add), "two_product": partial(with_error, operator.mul)}


def compiled(code, symbols):
    """A `Twofold` as a function of doubles, printed by no target."""
    steps, known = [], list(symbols)

    def function(expression):
        plain = expression.replace(compensated.fma, lambda x, y, z: x * y + z)
        return sp.lambdify(list(known), plain)

    for line in code.lines:
        if isinstance(line, Exact):
            steps.append((EXACTLY[line.op], function(line.left), function(line.right)))
            known += [line.high, line.low]
        else:
            steps.append((function(line[1]),))
            known.append(line[0])
    outputs = [function(output) for output in code.outputs]

    def run(*values):
        values = list(values)
        for step in steps:
            values += step[0](*(side(*values) for side in step[1:])) if len(step) > 1 else [step[0](*values)]
        return [output(*values) for output in outputs]

    return run


@pytest.mark.parametrize(
    "expression",
    [a * b - c, a**2 - b * c, (a + b) * (a - c), 27 * a * b**2 - 4 * c**3, (a * b + c) ** 2, 4 * a * b - b**3],
)
def test_any_sum_of_products_is_rounded_once(expression):
    random = np.random.default_rng(12)
    run = compiled(compensated.rounded((), expression, {a: a_low}), (a, b, c, a_low))
    over_fractions = sp.lambdify((a, b, c), expression, modules=[])
    for _ in range(300):
        values = (*random.uniform(-1, 1, 3), random.uniform(-1, 1) * 2.0**-55)
        first, second, third, low = map(Fraction, values)
        exactly = over_fractions(first + low, second, third)
        (found,) = run(*values)
        assert abs(Fraction(found) - exactly) <= abs(exactly) / 2**53 + Fraction(1, 2**98)


@pytest.mark.parametrize("expression", [a / 3, a / b, sp.sqrt(a), sp.sin(a), a * 3 + sp.Rational(1, 5)])
def test_what_has_no_double_double_code_is_refused(expression):
    with pytest.raises(ArithmeticError):
        compensated.rounded((), expression, {})


def test_a_magnitude_is_never_below_the_value():
    random = np.random.default_rng(13)
    for expression in (a * b - c, (a + b) * (a - c), (a + x) ** 2 + x, x * (a - x) + 3 * x, (a**2 + x) * b):
        size = magnitude((), expression, sp.Rational(1, 2**50)).doit()
        values = sp.lambdify((a, b, c, x), (expression, size))
        for row in random.uniform(-1, 1, (100, 3)):
            value, bound = values(*row, random.uniform())
            assert abs(value) <= bound * (1 + 2.0**-40)
