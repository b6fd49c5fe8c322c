"""The oracle against routes that share nothing with it: quadrature of the force, and other resultants."""

import json
import random
from collections.abc import Callable
from fractions import Fraction
from functools import cache, partial
from itertools import pairwise

import numpy as np
import pytest
from flint import arb, fmpq, fmpq_poly
from mpmath import mp, mpf

from tests.files import stored
from tests.oracles import inertia, make_damped, make_sided
from tests.oracles import make_random_isolators as generator
from tests.oracles.averaged import BITS, CORNER, DETACHED, Oscillator, bezout
from tests.oracles.certified_roots import isolate, polynomial_roots, precision
from tests.oracles.definitions.averaged_force import doubles_at_ends, harmonic_by_quadrature
from tests.oracles.definitions.forces import rod_coefficients
from tests.oracles.definitions.points import DESIGNS, STEEP_DESIGNS, parameters_of
from tests.oracles.kernels import Truncated, averages


@cache
def cases(name: str) -> list[dict]:
    return stored(name)


def value(x: list | str) -> float | Fraction:
    return Fraction(x) if isinstance(x, str) else float.fromhex(x[0])


def oscillator(case: dict) -> Oscillator:
    return generator.MECHANISMS[case["mechanism"]](**{k: value(v) for k, v in case["parameters"].items()})


# ---- the model once more, from the force, by quadrature --------------------------------------------------------------


cached_harmonic = cache(harmonic_by_quadrature)


class Quadrature:
    """The balance of forces by quadrature of the piecewise force over the cycle."""

    def __init__(self, case: dict) -> None:
        exact = {k: Fraction(value(v)) for k, v in case["parameters"].items()}
        p = {k: mpf(v.numerator) / v.denominator for k, v in exact.items()}
        self.zeta, self.m, self.name = p.pop("zeta"), 4 * p.pop("mu") / mp.pi, case["mechanism"]
        self.coefficients = rod_coefficients(**p) if self.name == "rod_spring" else [*p.values(), mpf(0)]
        self.u_cr = self.coefficients[3] if self.name == "rod_spring" else None

    def F(self, Omega: mpf, A: mpf, F_0: mpf) -> tuple[mpf, mpf, mpf]:
        """F, F_A and F_AA."""
        passed = int(self.u_cr is not None and A > self.u_cr)
        h, h_A, h_AA, _ = cached_harmonic(self.name, 1, passed, A, *self.coefficients)
        # of the force less u
        R, R_A, I, I_A = (
            A * Omega**2 + h - A,
            Omega**2 + h_A - 1,
            self.m + 2 * self.zeta * A * Omega,
            2 * self.zeta * Omega,
        )
        return R**2 + I**2 - F_0**2, 2 * (R * R_A + I * I_A), 2 * (R_A**2 + R * h_AA + I_A**2)


FORCES = {
    "rod_spring": [parameters_of(design) for design in DESIGNS],
    "rod_spring_untruncated": [(*parameters_of(design)[:2], design[-1]) for design in STEEP_DESIGNS],
    "duffing": [(0.75, -1.3, 0.6)],
}


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [0.3, 0.999, 1 + 1e-12, 1.0000001, 1.01, 1.7, 20.0])
@pytest.mark.parametrize("name", FORCES)
def test_averages_are_those_of_the_force_by_quadrature(name: str, ratio: float) -> None:
    """h and three derivatives: closed forms, which the kernels' oracle takes, and Gauss's rule in balls."""
    with mp.workdps(60):
        for p in FORCES[name]:
            (end,) = doubles_at_ends(name, p) or [1.0]
            passed, at = int(ratio > 1 and name != "duffing"), [mpf(ratio * end), *map(mpf, p)]
            value, slope, *others = harmonic_by_quadrature(name, 1, passed, *at)
            terms = [1 + abs(at[0]), 2, *(1 + abs(other) for other in others)]
            found = averages(name, passed, *at)
            for one, other, size in zip(found, [value - at[0], slope - 1, *others], terms, strict=True):
                assert abs(one - other) < mpf(10) ** -45 * size


# ---- the parts -------------------------------------------------------------------------------------------------------


def test_the_determinant_of_bezouts_matrix_is_the_resultant() -> None:
    """Times a power of a leading coefficient, and a sign."""
    rng = random.Random(1)
    for degree in (2, 3, 4):
        for _ in range(10):
            f, g = ([fmpq(rng.randint(-9, 9), rng.randint(1, 9)) for _ in range(5)] for _ in range(2))
            f[4], g[degree], g[degree + 1 :] = fmpq(2, 3), fmpq(5), [fmpq(0)] * (4 - degree)
            exact = fmpq_poly(f).resultant(fmpq_poly(g)) * f[4] ** (4 - degree)
            assert bezout(f, g) in (exact, -exact)


def test_isolation_of_known_roots() -> None:
    roots = isolate(lambda t: (20 * (1 + t)).sin(), arb(0), arb(3))
    expected = [k * float(np.pi) / 20 - 1 for k in range(7, 26)]
    assert [float(r.mid()) for r in roots] == pytest.approx(expected)
    close = arb(10) ** -12
    assert len(isolate(lambda t: ((t - arb(1) / 3) ** 2 - close**2) * (1 + t * t), arb(0), arb(2))) == 2
    assert isolate(lambda t: (t - arb(1) / 3) ** 2 + close**2, arb(0), arb(2)) == []
    with pytest.raises(ArithmeticError):
        isolate(lambda t: (t - arb(1) / 3) ** 2, arb(0), arb(2))
    polynomial = fmpq_poly([0, -2, 0, 1]) * fmpq_poly([1, 0, 1]) * fmpq_poly([-1, 3])
    assert [float(r.mid()) for r in polynomial_roots(polynomial)] == pytest.approx([1 / 3, 2**0.5])


@pytest.mark.slow
def test_folds_and_their_count_agree_for_a_wild_force() -> None:
    """It jumps up at u_cr: up to ten folds, extrema of every kind. The two ways to count share only h."""
    model = Truncated(alpha=-0.929, beta=182.9, gamma=-2176.5, u=0.28626, mu=0.0315, zeta=0.1612)
    levels = [float(p.F_0.mid()) for p in model.extrema]
    assert {(p.kind, p.regime) for p in model.extrema} == {
        ("cusp", "attached"),
        ("cusp", DETACHED),
        ("corner", CORNER),
        ("isola", "attached"),
    }
    counts = []
    for F_0 in [0.9 * levels[0], *((a + b) / 2 for a, b in pairwise(levels)), 1.1 * levels[-1]]:
        counts.append(len(model.folds(F_0)))
        assert counts[-1] == model.fold_count(F_0)
    assert max(counts) == 10


# ---- the recorded values --------------------------------------------------------------------------------------------


def some_folds() -> list[tuple]:
    """Folds of Table 1 (both ways), and one forcing each of some random oscillators, with every kind among them."""
    rows = []
    for name, indices, forcings in (
        ("table_1", (0, 1), (2, 4)),
        ("random_isolators", range(0, 200, 29), (0,)),
        ("random_duffing", range(0, 20, 5), (1,)),
    ):
        for index in indices:
            rows += [(name, index, k) for k in forcings]
    return rows


@pytest.mark.slow
@pytest.mark.parametrize(("name", "index", "forcing"), some_folds())
def test_recorded_folds_satisfy_the_system_by_quadrature(name: str, index: int, forcing: int) -> None:
    """F and F_A with h from quadrature of the force: what is left is rounding at 40 digits."""
    case = cases(name)[index]
    record, model = case["forcings"][forcing], oscillator(case)
    with mp.workdps(75), precision(BITS):
        reference, F_0 = Quadrature(case), mpf(ratio(record["F_0"])[0]) / ratio(record["F_0"])[1]
        for fold in record["folds"]:
            Omega, A = mpf(fold["Omega"]), mpf(fold["A"])
            d = model.derivatives(arb(fold["Omega"]), arb(fold["A"]), fold["regime"], arb(mp.nstr(F_0, 60)))
            rounding = mpf(10) ** -39
            size = {k: abs(mpf(d[k].mid().str(20, radius=False))) for k in ("A", "O", "AA", "AO")}
            if fold["corner"]:
                assert abs(reference.u_cr - A) <= rounding * A
                A = reference.u_cr
                slopes = [reference.F(Omega, at, F_0)[1] for at in (A, A * (1 + mpf(10) ** -12))]
                assert [mp.sign(s) for s in slopes] == ([1, -1] if fold["kind"] == "jump-up" else [-1, 1])
                assert abs(reference.F(Omega, A, F_0)[0]) <= size["O"] * Omega * rounding
                continue
            F, F_A, F_AA = reference.F(Omega, A, F_0)
            assert abs(F) <= size["O"] * Omega * rounding + mpf(10) ** -60
            assert abs(F_A) <= (size["AA"] * A + size["AO"] * Omega) * rounding
            assert (F_AA < 0) == (fold["kind"] == "jump-up")


def ratio(x: list | str) -> tuple[int, int]:
    q = Fraction(value(x))
    return q.numerator, q.denominator


@pytest.mark.slow
@pytest.mark.parametrize(
    ("file", "index", "case"),
    [
        *((file, 8, partial(generator.drawn_case, file)) for file in generator.FILES),
        ("random_isolators", 17, partial(generator.drawn_case, "random_isolators")),
        ("damped_contact", 7, partial(make_damped.case, "contact")),
        ("damped_base", 3, make_damped.shaken_case),
        ("inertia", 8, partial(inertia.case, "duffing")),
        ("sided", 8, partial(make_sided.case, "sided", "stop")),
    ],
)
def test_one_case_again(file: str, index: int, case: Callable[[int], dict]) -> None:
    """The committed files are what their generators write."""
    assert json.loads(json.dumps(case(index))) == cases(file)[index]


def test_all_kinds_are_among_the_data() -> None:
    folds = [f for c in cases("random_isolators") for r in c["forcings"] for f in r["folds"]]
    assert len(cases("random_isolators")) == 200
    assert {(f["kind"], f["regime"]) for f in folds} >= {
        ("jump-up", "attached"),
        ("jump-up", CORNER),
        ("jump-down", "attached"),
        ("jump-down", DETACHED),
    }
    assert {c["onset"]["regime"] for c in cases("random_isolators")} >= {"attached", CORNER}
