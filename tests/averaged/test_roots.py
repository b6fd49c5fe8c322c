"""Omega at a given amplitude: exact counts and errors in u (1 + kappa) against certified roots."""

from __future__ import annotations

import functools

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from slowflow.core.backend import SOLVER
from tests.oracles.frequencies import KINDS, U, relative_error, roots, stress_cases
from tests.sampling import fewer

# Less than the promised u (1 + kappa), so that a correction that has become useless is seen.  Rounding the exact root
# costs up to u, which is 2/3 u (1 + kappa), as kappa >= 1/2 (change the unit of frequency); sqrt(-h/A), with kappa = 1,
# may reach 3/4.
BOUND = 0.75 * U

SOLVE = {"response": SOLVER.response_roots, "fold": SOLVER.fold_roots, "peak": SOLVER.peak_roots}
FAMILIES = [(kind, name) for kind in KINDS for name in stress_cases(kind, 1, 0)]


def solved(kind: str, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Omega and counts."""
    return SOLVE[kind](*rows.T)


@functools.cache
def certified(kind, name):
    """Stress rows of a family and their certified roots, found once for all solvers."""
    rows = stress_cases(kind, fewer(300, 4), 20240)[name]
    return rows, [roots(kind, tuple(map(float, row))) for row in rows]


@pytest.mark.parametrize(("kind", "name"), FAMILIES)
def test_every_root_and_no_other(kind, name):
    rows, expected = certified(kind, name)
    Omega, count = solved(kind, rows)
    np.testing.assert_array_equal(count, [len(e) for e in expected])
    np.testing.assert_array_equal(np.isnan(Omega), np.arange(Omega.shape[1]) >= count[:, None])
    assert sum(len(e) for e in expected) > fewer(20, 4)
    for values, exact in zip(Omega, expected, strict=True):
        for value, (root, kappa) in zip(values, exact, strict=False):
            assert relative_error(float(value), root) <= BOUND * (1 + kappa)


def test_a_quartic_has_the_same_roots_alone_and_among_others():
    rows = np.concatenate([*stress_cases("response", 40, 3).values()])
    Omega, count = SOLVER.response_roots(*rows.T)
    for row, found, number in zip(rows, Omega, count, strict=True):
        single, one = SOLVER.response_roots(*row)
        assert one == number and np.array_equal(single, found, equal_nan=True)


def test_the_stress_cases_reach_three_roots():
    for kind, name in (("response", "three roots"), ("fold", "three roots")):
        assert sum(len(e) == 3 for e in certified(kind, name)[1]) > fewer(30, 4)


# Exactly representable tangencies.  With F_Omega = 0 at w: R = -zeta I/w, so zeta/w = 3/4 makes F_0 = 5/4 I.
# kind, parameters, roots
TOUCHING = {
    "minimum of F touches": ("response", (1.0, -2.875, 1.0, 0.75, 3.125), [0.5 / (np.sqrt(1.5) + 1), 1.0, 1.0]),
    "maximum of F touches": ("response", (1.0, -5.125, 4.0, 0.75, 6.875), [1.0, 1.0, np.sqrt(6) - 1]),
    "three roots of F meet": ("response", (1.0, -27 / 16 - 2, 27 / 32, 1.0, 125 / 32), [0.75, 0.75, 0.75]),
    "zeta = 0, F_0 = m": ("response", (2.0, -4.5, 0.5, 0.0, 0.5), [1.5, 1.5]),
    "nothing but inertia and spring": ("response", (4.0, -1.0, 0.0, 0.0, 0.0), [0.5, 0.5]),
    "m = 0, F_0^2 = -4 zeta^2 A (h + zeta^2 A)": ("response", (1.0, -4.0625, 0.0, 0.25, 1.0), [np.sqrt(3.9375)] * 2),
    "sticks at F_0 = m": ("response", (1.0, -1.0, 0.5, 0.1, 0.5), []),
    "sticks below": ("response", (1.0, -1.0, 0.5, 0.0, 0.25), []),
    "root at w = 0 is not counted": ("response", (1.0, 3.0, 4.0, 0.1, 5.0), []),
    "zeta = 0, both factors of F_A": ("fold", (2.0, -4.5, -2.25, 0.3, 0.0), [1.5, 1.5]),
    "no static stiffness left": ("fold", (1.0, 0.0, 0.0, 0.1, 0.1), []),
    "cubic touches": ("peak", (1.0, -3 - 2 * 0.25, 4.0, 0.5), [1.0, 1.0]),
    "zeta = 0": ("peak", (4.0, -1.0, 0.2, 0.0), [0.5]),
}


@pytest.mark.parametrize("name", TOUCHING)
def test_touching_roots_count_with_multiplicity(name):
    kind, parameters, expected = TOUCHING[name]
    exact = roots(kind, parameters)
    assert len(exact) == len(expected), "the case itself"
    Omega, count = solved(kind, np.array([parameters]))
    assert count == len(expected)
    np.testing.assert_allclose(Omega[0, : len(expected)], expected, rtol=4 * U, atol=0)
    for value, (root, _) in zip(Omega[0], exact, strict=False):
        assert relative_error(float(value), root) <= 4 * U


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_outside_the_domain_the_count_is_minus_one(kind, bad):
    good = np.array([1.0, -1.0, 0.1, 0.1, 0.5])[: len(KINDS[kind])]
    rows = np.array([np.where(np.arange(good.size) == i, bad, good) for i in range(good.size)])
    Omega, count = solved(kind, rows)
    assert (count == -1).all()
    assert np.isnan(Omega).all()


@pytest.mark.parametrize("kind", KINDS)
def test_negative_parameters(kind):
    good = np.array([1.0, -1.0, 0.1, 0.1, 0.5])[: len(KINDS[kind])]
    for i, name in enumerate(KINDS[kind]):
        row = np.where(np.arange(good.size) == i, -np.abs(good), good)[None]
        assert (solved(kind, row)[1] == -1) == (name not in ("h", "h_A"))
    assert solved(kind, np.where(np.arange(good.size) == 0, 0.0, good)[None])[1] == -1  # A = 0


@pytest.mark.parametrize("kind", KINDS)
def test_broadcasting_and_chunks(kind):
    rng = np.random.default_rng(5)
    A = rng.uniform(0.1, 2, (7, 1, 401))
    h = rng.uniform(-2, 0.5, (9, 1))
    rest = (-1.5, 0.02, 0.05) if kind == "fold" else (0.02, 0.05, 0.3)[: len(KINDS[kind]) - 2]
    Omega, count = SOLVE[kind](A, h, *rest)
    max_count = 2 if kind == "peak" else 3
    assert Omega.shape == (7, 9, 401, max_count) and count.shape == (7, 9, 401)  # several chunks
    assert count.dtype == np.int32
    for index in [(0, 0, 0), (3, 8, 17), (6, 8, 400)]:
        one, number = SOLVE[kind](A[index[0], 0, index[2]], h[index[1], 0], *rest)
        assert one.shape == (max_count,) and number.shape == ()
        np.testing.assert_array_equal(one, Omega[index])
        assert number == count[index]
    empty, none = SOLVE[kind](np.empty((0, 4)), -1.0, *rest)
    assert empty.shape == (0, 4, max_count) and none.shape == (0, 4)


def numbers(low: int, high: int, zero: bool) -> st.SearchStrategy[float]:
    """Doubles between 2^low and 2^high, with mantissas from one bit to all of them, and perhaps 0."""
    full = st.builds(lambda f, e: (1 + f) * 2.0**e, st.floats(0, 1, exclude_max=True), st.integers(low, high - 1))
    short = st.builds(lambda f, e: f * 2.0**e, st.integers(1, 9), st.integers(low, high - 4))
    return full | short | st.just(0.0) if zero else full | short


def signed(strategy: st.SearchStrategy[float]) -> st.SearchStrategy[float]:
    return st.builds(lambda x, s: s * x, strategy, st.sampled_from([-1.0, 1.0]))


SIZES = {"A": numbers(-12, 12, False), "h": signed(numbers(-20, 12, True)), "h_A": signed(numbers(-20, 40, True))}
ROWS = {kind: st.tuples(*(SIZES.get(name, numbers(-20, 8, True)) for name in names)) for kind, names in KINDS.items()}
ANY = st.one_of(*(st.tuples(st.just(kind), row) for kind, row in ROWS.items()))


@pytest.mark.slow
@settings(max_examples=fewer(400, 4))
@given(ANY)
@example(("response", (1.0, -3.0, 4.0, 2.0**-60, 5.0)))  # F(0) = 0, and F hardly rises to its maximum
def test_any_case_agrees_with_the_certified_roots(case):
    kind, parameters = case
    exact = roots(kind, parameters)
    Omega, count = SOLVE[kind](*parameters)
    assert count == len(exact)
    for value, (root, kappa) in zip(Omega, exact, strict=False):
        assert relative_error(float(value), root) <= BOUND * (1 + kappa)
    assert (np.diff(Omega[:count]) >= 0).all()


@pytest.mark.slow
@settings(max_examples=fewer(200, 4))
@given(ANY, st.integers(-8, 8), st.integers(-8, 8))
def test_units_of_frequency_and_of_force_do_not_matter(case, i, j):
    # w -> w/s with A -> A s^2, zeta -> zeta/s, h_A -> h_A/s^2, and A, h, m, F_0 in a common unit: exact in powers of 2
    kind, parameters = case
    s, t = 2.0**i, 2.0**j
    factors = {"A": s * s * t, "h": t, "m": t, "F_0": t, "zeta": 1 / s, "h_A": 1 / (s * s)}
    Omega, count = SOLVE[kind](*parameters)
    other, number = SOLVE[kind](*(x * factors[name] for name, x in zip(KINDS[kind], parameters, strict=True)))
    assert number == count
    np.testing.assert_array_equal(other * s, Omega)


def test_two_roots_appear_where_the_forcing_passes_a_peak_locus():
    A, h, m, zeta = stress_cases("peak", 4000, 7)["mild"].T
    peaks, _ = SOLVER.peak_roots(A, h, m, zeta)
    needed = np.hypot(A[:, None] * peaks**2 + h[:, None], 2 * zeta[:, None] * A[:, None] * peaks + m[:, None])
    use = (needed[:, 0] - needed[:, 1] > 1e-3 * needed[:, 0]) & (needed[:, 1] > 1e-3)
    use &= needed[:, 0] > np.hypot(h, m) * (1 + 1e-6)  # there F(0) = 0 changes the number too
    assert use.sum() > 1000
    A, h, m, zeta, needed = A[use], h[use], m[use], zeta[use], needed[use]
    for place, change in ((0, -2), (1, 2)):  # the first is a maximum of the forcing needed, the second a minimum
        above = SOLVER.response_roots(A, h, m, zeta, needed[:, place] * (1 + 1e-9))[1]
        below = SOLVER.response_roots(A, h, m, zeta, needed[:, place] * (1 - 1e-9))[1]
        assert (above - below == change).all()
