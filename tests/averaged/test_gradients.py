"""Gradients of answers: against certified differences and condition numbers, and by what scaling says of them."""

import random
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from mpmath import mp

from slowflow import Duffing, Isolator, derive, example
from slowflow.core.backend import SOLVER
from slowflow_kernels.conventions import GradientStatus, PointType
from tests.averaged.test_certified_cases import CENTRED, of_record
from tests.oracles.answers import Nearby
from tests.oracles.definitions import points as drawn
from tests.oracles.definitions import sensitivities
from tests.sampling import fewer, slow

F_0 = 0.04


def random_oscillators(count):
    """Isolators of either force and Duffing oscillators, with folds at 0.04."""
    random = np.random.default_rng(20261122)
    found = []
    while len(found) < 3 * count:
        mu, zeta = random.uniform(0.001, 0.015), random.uniform(0.01, 0.03)
        lam, r = 3.0, random.uniform(1.2, 3)
        delta_h = random.uniform(0.3, 0.9) / (lam * r)
        made = [
            Isolator(lam=lam, r=r, delta_h=delta_h, mu=mu, zeta=zeta, force=f) for f in ("truncated", "untruncated")
        ]
        made.append(Duffing(random.uniform(0.2, 1), random.uniform(0.5, 2), mu, zeta))
        if all(len(one.saddle_nodes(F_0)) for one in made):
            found += made
    return found


# ---- certified


#: relative, of a parameter: the error of a difference quotient is its square
STEP = Fraction(1, 2**120)


def perturbed(mechanism, kind, at, numbers):
    """Omega, A and F_0 of the certified answer next to given ones, in hundreds of bits; numbers exact, F_0 last."""
    near = Nearby(mechanism, **{name: value for name, value in numbers.items() if name not in ("F_0", "Omega")})
    Omega, A, _ = at
    frequency = numbers["Omega"] if kind == "state" else Omega
    on_corner, of = kind in ("corner", "detachment"), "fold" if kind == "corner" else kind
    found, _ = near.solution(of, frequency, None if on_corner else A, numbers["F_0"])
    if kind == "state":
        return None, found.A, None
    return found.Omega, found.A, found.F_0


@pytest.mark.parametrize("force", ["force", *slow("inertia")])
@pytest.mark.parametrize("kind", sensitivities.ANSWERS)
def test_one_rule_solves_the_conditions_of_every_answer(kind, force):
    """At random points, which are no answers: the residuals of the conditions are subtracted."""
    names, point_type = f"{sensitivities.AT} {sensitivities.CAUSES}", PointType[kind.upper()]
    at = drawn.points(random.Random(kind + force), names, fewer(6, 6))
    Omega, A, F_0, *x = np.array(at).T
    known = A, Omega, F_0, float(point_type), float(force == "inertia"), *x[10:14], *x[:10], *x[14:]
    solved = SOLVER.moved(np.stack(np.broadcast_arrays(*known), axis=-1))
    assert solved[:, 5].all()
    for k, point in enumerate(at):
        with mp.workdps(drawn.DIGITS):
            exact, scales = drawn.measured(sensitivities.implicit(kind, force), point)
            for value, sure, scale in zip(solved[k, [0, 3, 4]], exact, scales, strict=True):
                assert abs(mp.mpf(value) - sure) <= 8 * 2**-53 * scale


ROW = {"Omega": 0, "A": 1, "F_0": 2, "F_SN": 2, "Omega_cr": 0, "u_cr": 1, "F_cr": 2}


def check(of, kind, gradient, at, entry=()):
    """Every slope that Newton's method knows, against a quotient of certified answers; relative to all p dx/dp."""
    mechanism = of.model.mechanism.name
    query = {"F_0": at[2] or 1.0, "Omega": at[0]}
    numbers = {name: Fraction(query.get(name) or getattr(of, name)) for name in gradient.by}
    if "F_0" not in numbers:
        numbers["F_0"] = Fraction(1)
    rows = [x for x in gradient.of if x in ROW]
    for by in (name for name in gradient.by if numbers[name]):  # steps are relative
        ends = []
        for sign in (1, -1):
            ends.append(perturbed(mechanism, kind, at, {**numbers, by: numbers[by] * (1 + sign * STEP)}))
        for x in rows:
            one, other = (end[ROW[x]] for end in ends)
            width = 2 * STEP * numbers[by]
            certified = float((one - other) * width.denominator / width.numerator)
            # all that the parameters can do to it, over this one
            most = sum(abs(gradient[x, p][entry] * float(numbers[p])) for p in gradient.by) / abs(float(numbers[by]))
            assert abs(gradient[x, by][entry] - certified) < 1e-12 * most, (of, kind, x, by)


@pytest.mark.slow
def test_slopes_are_those_of_certified_answers_at_forty_digits():
    for of in random_oscillators(2):
        folds = of.saddle_nodes(F_0)
        gradient = folds.gradient()
        for k, fold in enumerate(folds):
            check(of, "fold", gradient, (fold.Omega, fold.A, F_0), k)
        states = of.amplitudes(Omega=0.95, F_0=F_0)
        gradient = states.gradient()
        for k, state in enumerate(states):
            check(of, "state", gradient, (state.Omega, state.A, F_0), k)
        peak = of.peak(F_0)
        check(of, "peak", peak.gradient(), (peak.Omega, peak.A, F_0))
        for kind, points in (("cusp", of.cusps(A_max=1.0)), ("isola", of.isola_points(A_max=1.0))):
            gradient = points.gradient()
            for k, point in enumerate(points):
                check(of, kind, gradient, (point.Omega, point.A, None), k)
        onset, detachment = of.saddle_node_onset(), of.detachment()
        points = {"cusp": of.cusps(A_max=1.0), "isola": of.isola_points(A_max=1.0)}.get(onset.kind)
        if points is not None:
            lowest = np.argmin(points.F_0)
            np.testing.assert_allclose(onset.gradient().slopes, points.gradient().slopes[lowest], rtol=1e-9)
        if detachment.F_cr:
            check(of, "detachment", detachment.gradient(), (detachment.Omega_cr, detachment.u_cr, None))


def test_a_fold_on_a_breakpoint_moves_with_it():
    tried = 0
    for case in CENTRED:
        for forcing in case["forcings"]:
            if tried < 4 and any(fold["corner"] for fold in forcing["folds"]):
                of, at = of_record(case), forcing["F_0"][1]
                folds = of.saddle_nodes(at)
                (k,) = np.flatnonzero(folds.corner)
                gradient = folds.gradient()
                check(of, "corner", gradient, (folds.Omega[k], folds.A[k], at), k)
                assert gradient["A", "delta_h"][k] == of.detachment().gradient()["u_cr", "delta_h"]
                tried += 1
    assert tried == 4


def isolated(Omega, A, numbers):
    """What vanishes where a Duffing oscillator transmits as much as drives it: (24), and the square that is left."""
    h = -numbers["alpha"] * A - mp.mpf(3) / 4 * numbers["beta"] * A**3 - mp.mpf(5) / 8 * numbers["gamma"] * A**5
    quadratic = 8 / (3 * mp.pi) * numbers["c_2"] * A**2 * Omega**2
    rising = (numbers["zeta_2"] * Omega / 2 + 3 * numbers["c_3"] * Omega**3 / 4) * A**3
    I = 4 * numbers["mu"] / mp.pi + 2 * numbers["zeta"] * A * Omega + numbers["eta"] * A + quadratic + rising
    force = numbers["F_0"] * Omega ** numbers["power"]
    return [(A * Omega**2 + h) ** 2 + I**2 - force**2, h**2 + I**2 - force**2]


@pytest.mark.parametrize(
    ("excitation", "laws", "F_0"),
    [
        ("force", {}, 0.2),
        ("force", {"eta": 0.02, "c_2": 0.1, "c_3": 0.1, "zeta_2": 0.2}, 0.2),
        ("unbalance", {"gamma": 0.0}, 0.02),  # with gamma > 0 the response does not close
        ("base", {"c_2": 0.2}, 0.05),
    ],
)
def test_where_isolation_begins_moves_as_a_root_at_forty_digits(excitation, laws, F_0):
    """In a batch as singly."""
    parameters = {"alpha": 1.0, "beta": 0.5, "gamma": 0.1, "mu": 0.004, "zeta": 0.12, **laws}
    found = Duffing(**parameters, excitation=excitation).isolation(F_0)
    gradient = found.gradient()
    assert not found.at_fold and not gradient.message and set(gradient.by) >= {*parameters, "F_0"}
    with mp.workdps(50):
        numbers = {"eta": 0, "c_2": 0, "c_3": 0, "zeta_2": 0, "power": 0 if excitation == "force" else 2}
        numbers = {name: mp.mpf(value) for name, value in {**numbers, **parameters, "F_0": F_0}.items()}
        step = mp.mpf(10) ** -16
        for by in gradient.by:
            high, low = (
                mp.findroot(
                    lambda *x, by=by, sign=sign: isolated(*x, {**numbers, by: numbers[by] + sign * step}),
                    (found.Omega, found.A),
                    tol=1e-80,
                )
                for sign in (1, -1)
            )
            for of, slope in zip(("Omega", "A"), (high - low) / (2 * step), strict=True):
                assert gradient[of, by] == pytest.approx(float(slope), rel=1e-11), (of, by)
    many = Duffing.many(**{**parameters, "zeta": [-1.0, parameters["zeta"]]}, excitation=excitation).isolation(F_0)
    together = many.gradient()
    assert together.by == gradient.by and together.status.tolist() == [GradientStatus.NOTHING, GradientStatus.OK]
    np.testing.assert_allclose(together.slopes[1], gradient.slopes, rtol=1e-9)


def test_isolation_that_begins_at_a_fold_moves_as_that():
    iso = Isolator(lam=3, r=2, delta_h=0.1, mu=0.012, zeta=0.02)
    found = iso.isolation(F_0)
    assert found.at_fold
    gradient = found.gradient()
    (k,) = np.flatnonzero(iso.saddle_nodes(F_0).Omega == found.Omega)
    np.testing.assert_array_equal(gradient.slopes, iso.saddle_nodes(F_0).gradient().slopes[k])
    check(iso, "fold", gradient, (found.Omega, found.A, F_0))


# ---- by what scaling says


def scaled(gradient, powers):
    """sum of n p dx/dp over the parameters p with powers n, less n x, for each number x; over its condition."""
    rows = []
    for x, value in zip(gradient.of, gradient._values, strict=True):
        terms = [powers.get(p, 0) * at * gradient[x, p] for p, at in zip(gradient.by, gradient._at, strict=True)]
        size = sum(map(abs, terms)) + abs(np.asarray(value))
        rows.append((sum(terms) - powers.get(x, 0) * np.asarray(value)) / size)
    return np.array(rows)


#: powers of the unit of length, and of the unit of frequency, in each number
LENGTH = {"beta": -2, "mu": 1, "F_0": 1, "A": 1, "F_SN": 1}
FREQUENCY = {"alpha": 2, "beta": 2, "mu": 2, "zeta": 1, "F_0": 2, "Omega": 1, "F_SN": 2}
#: a base moves by a length
OF_BASE = {**FREQUENCY, "F_0": 0, "F_SN": 0}


@pytest.mark.parametrize(("excitation", "count"), [*slow(("force", 60)), ("base", 3)])
def test_gradients_hold_what_other_units_of_length_and_time_say(excitation, count):
    """Euler's theorem: a Duffing oscillator in other units is a Duffing oscillator."""
    random = np.random.default_rng(7)
    tried = 0
    for _ in range(count):
        alpha, beta = random.uniform(0.1, 2), 10 ** random.uniform(-1, 1)
        of = Duffing(alpha, beta, 10 ** random.uniform(-6, -4), 10 ** random.uniform(-2.5, -1), excitation=excitation)
        onset = of.saddle_node_onset()
        answers = [onset]
        for forcing in onset.F_SN * np.array([0.7, 1.1, 1.5]):
            answers += [of.saddle_nodes(forcing), of.peak(forcing)]
            answers.append(of.amplitudes(Omega=[0.5, 1.0, 2.0], F_0=forcing))
            if excitation == "force":
                answers.append(of.isolation(forcing))
        for answer in answers:
            gradient = answer.gradient()
            assert gradient.message == ""
            for powers in (LENGTH, FREQUENCY if excitation == "force" else OF_BASE):
                found = scaled(gradient, powers)
                assert np.all(np.abs(found) < 1e-11)
                tried += found.size
    assert tried > 60 * count


@pytest.mark.parametrize("size", [1.0, 2.0**-70, 2.0**70])
def test_onset_where_the_force_jumps_moves_as_its_closed_form(size):
    """There R = 0 and F_SN = 4 mu/pi + 2 zeta gap sqrt(k): what is 0 but for rounding is told in any unit of length."""
    u, k, gap, step = sp.symbols("u k gap step")
    made = derive.mechanism("step_up", [(k * u, gap), (k * u + step, None)], {"k": {"above": 0}, "gap": {}, "step": {}})
    gradient = made(k=2.0, gap=0.3 * size, step=0.1 * size, mu=0.01 * size, zeta=0.02).saddle_node_onset().gradient()
    rate = np.sqrt(2)
    known = {"k": 0.02 * 0.3 * size / rate, "gap": 0.04 * rate, "step": 0, "mu": 4 / np.pi, "zeta": 0.6 * size * rate}
    assert {by: gradient["F_SN", by] for by in gradient.by} == pytest.approx(known, rel=1e-14, abs=1e-14 * size)


# ---- where there is none


def test_what_meets_another_answer_has_no_gradient_and_says_so():
    iso = example.isolator()
    onset, curve = iso.saddle_node_onset(), iso.frequency_response(F_0)
    folds = iso.saddle_nodes(onset.F_SN * (1 + 4e-16)).gradient()
    assert len(folds.status) == 2
    assert np.all(folds.status == GradientStatus.MEETS)
    assert np.isnan(folds.slopes).all()
    assert "merges with another answer" in folds.message
    gradient = curve.gradient()
    at_folds = np.isin(curve.A, iso.saddle_nodes(F_0).A)
    assert at_folds.sum() == 2
    assert np.all(gradient.status[at_folds] == GradientStatus.MEETS)


def test_answer_at_a_breakpoint_turns_where_the_force_jumps():
    """Only then: h_A of the untruncated force goes on."""
    for force, status in (("truncated", GradientStatus.TURNS), ("untruncated", GradientStatus.OK)):
        iso = Isolator(lam=3, r=2, delta_h=0.1, mu=0.012, zeta=0.02, force=force)
        curve = iso.frequency_response(F_0)
        on_break = curve.A == iso.u_cr if force == "truncated" else curve.A == iso.breakpoints[0]
        assert on_break.sum() == 2
        assert np.all(curve.gradient().status[on_break] == status)


def test_no_answer_has_no_gradient_and_says_so():
    gradient = Isolator(lam=3, r=2, delta_h=0.1, mu=0.012, zeta=0.02).peak(0.001).gradient()
    assert gradient.status == GradientStatus.NOTHING
    assert "no answer" in gradient.message
    assert np.isnan(gradient["A", "zeta"])


def test_infinite_slope_at_the_end_of_a_domain_is_said():
    """u_cr grows like the root of the preload."""
    gradient = Isolator.many(lam=3, r=[2.0], delta_h=0.0, mu=0.012, zeta=0.02).peak(F_0).gradient()
    assert gradient.status == [GradientStatus.BOUNDLESS]


def test_composed_answers_have_no_gradient_and_say_of_what():
    iso, many = example.isolator(), Isolator.many(lam=3, r=[2.0], delta_h=0.1, mu=0.012, zeta=0.02)
    for of in (iso, many):
        spectrum = of.spectrum(Omega=[0.8, 0.9], F_0=F_0)
        for answer in (of.margins(F_0), of.hysteresis(F_0), spectrum, of.at_rest()):
            with pytest.raises(ValueError, match="no gradient, as it combines others"):
                answer.gradient()


def test_a_forcing_of_zero_has_no_gradient_and_says_so():
    """Without friction and damping the backbone needs none; with either it does."""
    gradient = Isolator(lam=3, r=2, delta_h=0.1).detachment().gradient()
    assert gradient.status == GradientStatus.BOUNDLESS
    assert "a forcing is 0" in gradient.message


def test_fold_next_to_a_breakpoint_keeps_no_spoilt_gradient():
    """Of two folds so near to each other that A - u_cr has two digits."""
    numbers = {"lam": 3.0, "r": 3.005406622627307, "delta_h": 0.0017304662034615412, "mu": 0.001032537769234336}
    corner, smooth = Isolator(**numbers).saddle_nodes(0.04869972786923327).gradient().status
    assert (corner, smooth) == (GradientStatus.OK, GradientStatus.TURNS)


def test_other_approximations_have_no_gradient_of_averaging():
    iso = example.isolator()
    with pytest.raises(ValueError, match="averaged answers"):
        iso.second_approximation.peak(F_0).gradient()
    many = Isolator.many(lam=3, r=[2.0], delta_h=0.1, mu=0.012, zeta=0.02).second_approximation
    with pytest.raises(ValueError, match="averaged answers"):
        many.peak(F_0).gradient()


def test_a_gradient_is_an_answer_like_others():
    gradient = example.isolator().saddle_nodes(F_0).gradient()
    assert gradient.by == ("lam", "r", "delta_h", "mu", "zeta", "F_0")
    np.testing.assert_array_equal(gradient["A"][:, 2], gradient["A", "delta_h"])
    with pytest.raises(ValueError, match="read-only"):
        gradient.slopes[0] = 0
    with pytest.raises(KeyError, match="the numbers are Omega, A"):
        gradient["phi"]


def test_a_gradient_is_read_row_by_row_and_is_a_table():
    """A slope for each number and each parameter; of an answer with several entries that of each, in rows too."""
    folds = example.isolator().saddle_nodes(0.04)
    gradient = folds.gradient()
    rows = list(gradient)
    assert len(rows) == len(gradient) == len(gradient.of) * len(gradient.by)
    assert all(np.array_equal(row.slope, gradient[row.of, row.by]) for row in rows)
    columns = gradient.columns()
    for entry, of, by, slope in zip(*(columns[name].tolist() for name in ("entry", "of", "by", "slope")), strict=True):
        assert slope == gradient[of, by][entry]
    assert len(columns["slope"]) == len(folds) * len(gradient)
    single = example.isolator().saddle_node_onset().gradient()
    assert list(single.columns()) == ["of", "by", "slope"] and str(single).splitlines()[1].split()[:2] == [
        "F_SN",
        "lam",
    ]
