"""Forces off the centre that are no polynomials: against integrals, certified cases, polynomials, and exact motions."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy as sp

from slowflow import backend, derive
from slowflow.averaged.reference.intervals import Interval
from slowflow.off_centre.means import Steps
from slowflow.validate import NotAvailable
from tests.off_centre_cases import check_folds_and_states, check_onset

u, k, g, q, d, p, z = sp.symbols("u k g q d p z")
ABOVE = {"above": 0}
DAMPED = {"mu": 0.005, "zeta": 0.03}
COMPILED = backend.EXACT is not None


@pytest.fixture(scope="module")
def cushion():
    """Free on the left and up to a gap, then ever stiffer."""
    pieces = [(u, g), (u + q * (sp.exp((u - g) / d) - 1), None)]
    return derive.mechanism("cushion", pieces, {"q": ABOVE, "d": ABOVE, "g": {}}, odd=False, compile=COMPILED)


@pytest.fixture(scope="module")
def magnet():
    """A magnet that repels at u = d, which no motion comes to."""
    pieces = [(u + q / (d - u) ** 2 - q / d**2, None)]
    return derive.mechanism("magnet", pieces, {"q": ABOVE, "d": ABOVE}, odd=False, compile=COMPILED)


@pytest.fixture(scope="module")
def patched():
    """Four pieces that differ in all: roots, a jump, bends, a saturating spring."""
    pieces = [
        (2 * u + p, -0.4),
        (sp.sqrt(1 + u * q) - 1, -0.1),
        (sp.sinh(u / q) * q / 2, 0.25),
        (u + p * sp.tanh((u - 0.25) / q), None),
    ]
    return derive.mechanism("patched_curves", pieces, {"p": {}, "q": ABOVE}, odd=False)


@pytest.mark.slow
@pytest.mark.parametrize(("A", "B"), [(0.05, 0.1), (0.3, 0.0), (0.6, 0.1), (0.3, -0.25), (4.0, 0.3)])
def test_means_are_those_of_exact_integrals(patched, A, B):
    """The mean, the first harmonic, and their slopes as differences of these integrals at 30 digits."""
    oscillator = patched(p=0.1, q=0.7, **DAMPED)
    steps = Steps(oscillator.model.mechanism, oscillator.model.parameters, 0.0)
    at = steps.at(np.array([A]), np.array([B]), 3)
    box = steps.on(Interval.of([A * (1 - 1e-9)], [A * (1 + 1e-9)]), Interval.of([B - 1e-9], [B + 1e-9]), 2)
    with mpmath.workdps(30):
        p_, q_ = mpmath.mpf(0.1), mpmath.mpf(0.7)
        pieces = (
            lambda x: 2 * x + p_,
            lambda x: mpmath.sqrt(1 + x * q_) - 1,
            lambda x: mpmath.sinh(x / q_) * q_ / 2,
            lambda x: x + p_ * mpmath.tanh((x - mpmath.mpf(1) / 4) / q_),
        )
        ends = [mpmath.mpf(-2) / 5, mpmath.mpf(-1) / 10, mpmath.mpf(1) / 4]

        def law(x):
            return pieces[sum(x > end for end in ends)](x)

        def whole(b, w):
            cuts = sorted(mpmath.acos((end - b) / A) for end in (*ends, mpmath.mpf(0)) if abs(end - b) < A)
            edges = [mpmath.mpf(0), *cuts, mpmath.pi]
            return mpmath.quad(lambda y: law(b + A * mpmath.cos(y)) * mpmath.cos(y) ** w, edges) / mpmath.pi

        for family, weight, held in ((at.c, 0, box.c), (at.s, 1, box.s)):
            for n in range(3):
                exact = mpmath.diff(lambda b, w=weight: whole(b, w), mpmath.mpf(B), n, h=1e-8)
                assert family[n][0] == pytest.approx(float(exact), rel=1e-11, abs=1e-13 * 20**n)
                assert held[n].lo[0] <= family[n][0] <= held[n].hi[0]


@pytest.mark.parametrize("size", [1e-6, 1e-3, 0.05, 0.5])
def test_boxes_hold_all_that_motions_within_them_have(patched, size):
    """Means and their slopes by the ends of the motion, at random motions in random boxes of each chart."""
    oscillator, rng = patched(p=0.1, q=0.7, **DAMPED), np.random.default_rng(1)
    steps = Steps(oscillator.model.mechanism, oscillator.model.parameters, 0.0)
    top, depth = rng.uniform(-0.6, 1.2, 40), rng.uniform(0.0, 1.5, 40)
    high, low = Interval.of(top, top + size), Interval.of(top - depth - size, top - depth)
    held = steps.curved.by_ends(high, low)
    for _ in range(20):
        share = rng.uniform(0, 1, (2, 40))
        ends = high.lo + share[0] * size, low.lo + share[1] * size
        A, B = 0.5 * (ends[0] - ends[1]), 0.5 * (ends[0] + ends[1])
        (c_0, c_1, c_2), (s_0, s_1, s_2) = steps.curved.at(A, B, 2)
        turned = s_1 / A
        values = c_0, s_0, c_1 + s_1, c_1 - s_1, 2 * (c_2 + s_2) - turned, 2 * (c_2 - s_2) - turned
        for value, one in zip(values, held, strict=True):
            doubt = 1e-15 + 1e-12 * np.abs(value)
            assert (one.lo <= value + doubt).all() and (value - doubt <= one.hi).all()


def test_what_boxes_add_goes_with_the_square_of_their_size(patched):
    oscillator = patched(p=0.1, q=0.7, **DAMPED)
    steps = Steps(oscillator.model.mechanism, oscillator.model.parameters, 0.0)

    def beyond(size: float) -> float:
        """How much wider the mean is than it moves by, as its slopes are positive."""
        high, low = (np.array([[at], [at + size]]) for at in (0.6, -0.7))
        c_0 = steps.curved.by_ends(Interval(high), Interval(low)).c_0
        A, B = 0.5 * (high - low).ravel(), 0.5 * (high + low).ravel()
        moves = float(np.diff(steps.curved.at(A, B, 0)[0][0])[0])
        return float((c_0.hi - c_0.lo)[0]) - moves

    assert 0 < beyond(1e-3) < 0.02 * beyond(1e-2) < 1e-7


#: forces as `test_sided` has them, polynomials: a stop on either side, between two, even powers, a jump
POLYNOMIALS = {
    "both": ([(u + k * (u + 2 * g), -2 * g), (u, g), (u + k * (u - g) + p * (u - g) ** 3, None)], 0.08),
    "within": ([(u + k * (u - g), g), (u, None)], 0.06),
    "even": ([(u + p * u**2 / 20 + 0.6 * u**3, None)], 0.12),
    "jump": ([(u, g), (u + p / 1000 + k * (u - g), None)], 0.05),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(POLYNOMIALS))
def test_a_polynomial_that_is_stated_as_another_force_has_the_same_answers(name):
    """z exp(u) beside it, with z = 0: summed, not steps."""
    pieces, F_0 = POLYNOMIALS[name]
    numbers = {"k": 3.0, "p": 15.0, "g": 0.1}
    stated = derive.mechanism(f"same_{name}", pieces, {one: {} for one in numbers}, odd=False)
    curved = [(force + z * sp.exp(u), end) for force, end in pieces]
    summed = derive.mechanism(f"summed_{name}", curved, {one: {} for one in (*numbers, "z")}, odd=False)
    given = {**numbers, "mu": 0.004, "zeta": 0.03, "load": 0.01}
    one, other = stated(**given), summed(**given, z=0.0)
    for ask, names in (
        (lambda of: of.rest(), ("u", "stiffness")),
        (lambda of: of.amplitudes(Omega=[0.8, 1.2, 1.5], F_0=F_0), ("Omega", "A", "B", "phi")),
        (lambda of: of.saddle_nodes(F_0), ("Omega", "A", "B")),
        (lambda of: of.saddle_node_onset(), ("F_SN", "Omega", "A", "B")),
        (lambda of: of.detachment(), ("F_cr", "Omega_cr", "A", "B")),
        (lambda of: of.peak(F_0), ("A", "B", "Omega", "u_max", "Omega_max")),
    ):
        found, same = ask(other), ask(one)
        assert found.message == same.message
        for quantity in names:
            values = [np.array(getattr(answer, quantity), dtype=float) for answer in (found, same)]
            np.testing.assert_allclose(*values, rtol=1e-9, atol=1e-12)
    curves = [of.frequency_response(F_0) for of in (other, one)]
    assert curves[0].isola == curves[1].isola


@pytest.mark.slow
def test_an_odd_force_under_a_load_is_the_same_stated_for_all_u():
    hard = q * (sp.exp((u - g) / d) - 1)
    one = derive.mechanism("two_cushions", [(u, g), (u + hard, None)], {"q": ABOVE, "d": ABOVE, "g": ABOVE})
    pieces = [(u - hard.subs(u, -u), -g), (u, g), (u + hard, None)]
    other = derive.mechanism("both_cushions", pieces, {"q": ABOVE, "d": ABOVE, "g": ABOVE}, odd=False)
    given = {"q": 0.2, "d": 0.1, "g": 0.1, "load": 0.03, **DAMPED}
    for ask, names in (
        (lambda of: of.amplitudes(Omega=[0.9, 1.3, 1.6], F_0=0.03), ("Omega", "A", "B", "phi")),
        (lambda of: of.saddle_nodes(0.03), ("Omega", "A", "B")),
        (lambda of: of.detachment(), ("F_cr", "A", "B")),
    ):
        found, same = ask(one(**given)), ask(other(**given))
        for name in names:
            np.testing.assert_allclose(getattr(found, name), getattr(same, name), rtol=1e-11, atol=1e-15)


@pytest.mark.slow
def test_no_motion_passes_a_wall(magnet):
    oscillator = magnet(q=0.01, d=0.5, load=0.05, **DAMPED)
    model = oscillator.model.unloaded
    (above, below) = Steps(model.mechanism, model.parameters, 0.05).beyond
    assert above.wall == pytest.approx(0.5, rel=1e-9) and below.wall == np.inf
    found = oscillator.peak(0.05)
    assert found.A + found.B < 0.5 < found.u_max and (oscillator.rest().u < 0.5).all()


def test_what_is_not_smooth_is_refused_with_where_it_is():
    """A pole and a root between the ends of a piece; a root that a piece begins with."""
    pole = derive.mechanism("pole", [(u + q / (d - u), 1), (u, None)], {"q": ABOVE, "d": ABOVE}, odd=False)
    with pytest.raises(ValueError, match=r"piece 1 of its force is not smooth at u = 0.5"):
        pole(q=0.1, d=0.5, **DAMPED)
    ended = derive.mechanism("ended", [(u - q * sp.sqrt(d - u), None)], {"q": ABOVE, "d": ABOVE}, odd=False)
    with pytest.raises(ValueError, match=r"piece 1 of its force is not smooth at u = 0.5"):
        ended(q=0.1, d=0.5, **DAMPED)
    with pytest.raises(ArithmeticError, match="singular at u = g"):
        derive.mechanism("hertz", [(u, g), (u + k * (u - g) ** sp.Rational(3, 2), None)], {"k": {}, "g": {}}, odd=False)
    with pytest.raises(ArithmeticError, match="which no average is known for"):
        derive.mechanism("gamma", [(sp.gamma(u), None)], {}, odd=False)


def test_of_its_answers_no_gradient_is_known(cushion):
    with pytest.raises(NotAvailable, match="piecewise polynomials"):
        cushion(q=0.2, d=0.1, g=0.1, **DAMPED).detachment().gradient()


@pytest.mark.slow
@pytest.mark.skipif(not COMPILED, reason="SciPy's integrator takes long")
@pytest.mark.parametrize("Omega", [1.15, 1.3])
def test_exact_motions_are_what_averaging_says_to_its_order(cushion, Omega):
    """Every stable state has a motion of the equation of motion next to it, with its mean."""
    oscillator = cushion(q=0.05, d=0.2, g=0.05, **DAMPED)
    states = oscillator.amplitudes(Omega=Omega, F_0=0.02)
    assert states.stable.any()
    for state in (one for one in states if one.stable):
        motion = oscillator.steady_state(Omega=Omega, F_0=0.02, A=state.A + abs(state.B))
        assert motion.A == pytest.approx(state.A + abs(state.B), rel=0.1)
        assert motion.stable


@pytest.mark.slow
@pytest.mark.skipif(not COMPILED, reason="SciPy's integrator takes long")
def test_motions_against_a_magnet_are_those_of_its_average(magnet):
    oscillator = magnet(q=0.01, d=0.5, load=0.05, **DAMPED)
    (state,) = (one for one in oscillator.amplitudes(Omega=0.9, F_0=0.03) if one.stable)
    motion = oscillator.steady_state(Omega=0.9, F_0=0.03, A=state.A + abs(state.B))
    assert motion.A == pytest.approx(state.A + abs(state.B), rel=0.03)


@pytest.mark.slow
def test_batches_and_margins_have_the_single_answers(cushion):
    given = {"q": 0.2, "d": 0.1, "g": 0.1, **DAMPED}
    many = cushion.many(**{**given, "g": np.array([0.1, 0.15])})
    found = many.saddle_nodes(0.03)
    for at, gap in enumerate((0.1, 0.15)):
        one = cushion(**{**given, "g": gap}).saddle_nodes(0.03)
        np.testing.assert_array_equal(found.Omega[at][: len(one)], one.Omega)
    one = cushion(**given)
    assert one.margins(0.02).of_cr == pytest.approx(one.detachment().F_cr / 0.02, rel=1e-12)


#: errors in u (1 + kappa): of a fold's A, where sums are not as near as their last digits, and of B over A + |B|
FOLD_A, MEAN = 32.0, 16.0
CASES = json.loads((Path(__file__).parent / "data" / "curved.json").read_text())
#: what is certified, and the same force as it is stated
CERTIFIED = {"exponential": (k * u + q * (sp.exp(u / d) - 1), False), "hyperbolic": (k * u + q * sp.sinh(u / d), True)}


def test_there_are_certified_cases_of_each_force():
    assert set(CERTIFIED) == set(Counter(case["force"] for case in CASES)) and len(CASES) >= 30
    assert sum(case["onset"] is not None for case in CASES) >= 25


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(CERTIFIED))
def test_folds_states_and_onsets_are_the_certified_ones_and_no_others(name):
    """All folds and states that there are, with their mean; and the lowest forcing that has a fold."""
    force, odd = CERTIFIED[name]
    made = derive.mechanism(f"certified_{name}", [(force, None)], {"k": ABOVE, "q": ABOVE, "d": ABOVE}, odd=odd)
    for case in (case for case in CASES if case["force"] == name):
        one = made(**{key: value[1] for key, value in case["parameters"].items()})
        check_folds_and_states(one, case, fold_A=FOLD_A, mean=MEAN)
        check_onset(one, case, mean=MEAN)
