"""Proofs at run time: enclosures hold certified values, nothing is left out, and what is in doubt is left in doubt."""

import dataclasses
import importlib.util
import itertools
import math
import shutil
from fractions import Fraction

import flint
import mpmath
import numpy as np
import pytest

from slowflow import Duffing, Isolator, example
from slowflow.answers.table import DOUBLES
from slowflow.app import cli
from slowflow.averaged import messages, proofs, solvers
from slowflow.averaged.balls.search import BallModel, averages_of
from tests.averaged.test_certified_cases import CENTRED, of_record
from tests.native.intervals import BOUNDED, ELEMENTARY, EXACT, OPERATIONS, Intervals
from tests.oracles import averaged
from tests.sampling import slow

#: without the balls that are asked where doubles do not decide, and without telling where folds are expected
IN_DOUBLES = {name: getattr(proofs, name).in_doubles for name in ("folds", "states")}


def holds(ends, digits):
    """Whether an enclosure holds a number given by its digits, exactly."""
    return Fraction(float(ends[0])) <= Fraction(digits) <= Fraction(float(ends[1]))


def check_folds(proof, folds):
    """What is said to be proved, against certified folds: raises where anything differs."""
    assert len(proof.A) == len(folds)
    for Omega, A, kind, corner, fold in zip(proof.Omega, proof.A, proof.kind, proof.corner, folds, strict=True):
        assert holds(Omega, fold["Omega"])
        assert holds(A, fold["A"])
        assert (kind, corner) == (fold["kind"], fold["corner"])


@pytest.mark.parametrize(("by", "step", "part"), [("in_doubles", 1, None), *slow(("in_balls", 25, 1))])
def test_enclosures_hold_certified_answers(by, step, part):
    """In doubles, and in balls throughout, not to fill gaps; in balls of few cases, at one forcing each."""
    proved = {name: getattr(getattr(proofs, name), by) for name in ("folds", "states", "onset", "detachment")}
    total = doubtful = 0
    for case in CENTRED[::step]:
        model, onset = of_record(case).model, case["onset"]
        for forcing in case["forcings"][:part]:
            F_0 = forcing["F_0"][1]
            proof = proved["folds"](model, F_0)
            total, doubtful = total + 1, doubtful + (not proof.proved)
            if proof.proved:
                assert proof.bounded
                check_folds(proof, forcing["folds"])
            for at in forcing["amplitudes"][: part and 2]:
                found = proved["states"](model, F_0, at["Omega"][1])
                total, doubtful = total + 1, doubtful + (not found.proved)
                if found.proved:
                    assert found.stable.tolist() == [state["stable"] for state in at["steady"]]
                    assert all(holds(A, state["A"]) for A, state in zip(found.A, at["steady"], strict=True))
        found = proved["onset"](model)
        assert found.proved
        assert found.kind == onset["kind"]
        assert holds(found.F_0, onset["F_SN"])
        assert holds(found.Omega, onset["Omega"])
        assert holds(found.A, onset["A"])
        if case["mechanism"] == "rod_spring":
            found = proved["detachment"](model)
            assert found.proved
            assert holds(found.F_0, case["detachment"]["F_cr"])
            assert holds(found.Omega, case["detachment"]["Omega_cr"])
            assert holds(found.A, case["u_cr"])
    assert total > (2500 if part is None else 20)
    assert doubtful < 0.01 * total


def test_enclosures_are_narrow():
    """In units of rounding times the condition number that the reference states."""
    widest = 0.0
    for case in CENTRED[:60]:
        model = of_record(case).model
        for forcing in case["forcings"]:
            proof = proofs.folds(model, forcing["F_0"][1])
            for A, fold in zip(proof.A, forcing["folds"], strict=proof.proved):
                if fold["condition"] is not None and proof.proved and not fold["corner"]:
                    condition = fold["condition"]["A"] + fold["condition_kernel"]["A"]
                    widest = max(widest, (A[1] - A[0]) / A[0] / (2**-53 * (1 + condition)))
    assert 0 < widest < 2000


def level_ulps(F_SN):
    """Doubles around a number given by its digits, and on which side of it each lies."""
    nearest = float(F_SN)
    for steps in (-1000, -30, -3, -2, -1, 0, 1, 2, 3, 30, 1000):
        F_0 = nearest + steps * math.ulp(nearest)
        yield F_0, Fraction(F_0) > Fraction(F_SN)


@pytest.mark.slow
@pytest.mark.parametrize(("prove", "step"), [(IN_DOUBLES["folds"], 4), (proofs.folds, 45)], ids=["doubles", "balls"])
def test_beside_a_double_fold_what_is_proved_is_true(prove, step):
    """At F_SN two folds meet: a few ulps above there are two, below none; balls prove all that doubles do not."""
    decided = undecided = by_balls = 0
    for case in CENTRED[::step]:
        onset = case["onset"]
        if onset is None or not onset["global"]:
            continue
        model = of_record(case).model
        for F_0, above in level_ulps(onset["F_SN"]):
            proof = prove(model, F_0)
            by_balls += proof.bits > DOUBLES
            if proof.proved:
                assert len(proof.A) == (2 if above else 0)
            else:
                assert len(proof.doubt) > 0 or not proof.bounded
            decided, undecided = decided + proof.proved, undecided + (not proof.proved)
    assert decided > 50
    assert (undecided > 100, by_balls > 10) == ((True, False) if step == 4 else (False, True))
    assert step == 4 or not undecided


def test_a_fold_that_the_solvers_miss_is_noticed(monkeypatch):
    found = example.isolator().saddle_nodes(0.04, certify=True)
    assert found.proof.proved
    assert not found.proof.message
    one = dataclasses.replace(found, Omega=found.Omega[:1], A=found.A[:1], kind=found.kind[:1], corner=found.corner[:1])
    monkeypatch.setattr(solvers, "folds", lambda model, F_0: one)
    assert (
        example.isolator().saddle_nodes(0.04, certify=True).proof.message == "2 folds are proved, saddle_nodes gives 1"
    )


def test_a_tampered_enclosure_is_noticed():
    case = CENTRED[-1]
    forcing = case["forcings"][0]
    proof = proofs.folds(of_record(case).model, forcing["F_0"][1])
    check_folds(proof, forcing["folds"])
    wide = proof.A[:, 1:] - proof.A[:, :1]
    for A in (proof.A + 2 * wide, proof.A - 2 * wide, proof.A[:1]):
        with pytest.raises((AssertionError, ValueError)):
            check_folds(dataclasses.replace(proof, A=A), forcing["folds"])


@pytest.mark.parametrize("steps", [0, 1, -1, 7, -100])
def test_given_numbers_are_certified_not_rounded_parameters(steps):
    """alpha = 1 - lam r delta_h next to 0: doubles lose most digits on the way, the enclosure holds the exact fold."""
    lam, r = 3.0, 2.7
    delta_h = 1 / (lam * r) * (1 - 1e-13)
    delta_h += steps * math.ulp(delta_h)
    iso = Isolator(lam=lam, r=r, delta_h=delta_h, mu=1e-9, zeta=1e-7)
    exact = [Fraction(value) for value in (lam, r, delta_h, iso.mu, iso.zeta)]
    alpha = 1 - exact[0] * exact[1] * exact[2]
    assert abs(Fraction(1 - lam * r * delta_h) - alpha) > Fraction(1, 10**5) * alpha
    assert iso.alpha == float(alpha)
    F_0 = 2 * proofs.onset(iso.model).F_0[1]
    proof = iso.saddle_nodes(F_0, certify=True).proof
    assert proof.proved
    assert len(proof.A) == 2
    with mpmath.workdps(60):
        beta = exact[0] * exact[1] * (1 - exact[2]) / 2
        number = [mpmath.mpf(x.numerator) / x.denominator for x in (alpha, beta, 3 * beta / 4, exact[3], exact[4])]
        al, be, ga, mu, zeta = number

        def both(w, A):
            h, h_A = -al * A - 3 * be * A**3 / 4 - 5 * ga * A**5 / 8, -al - 9 * be * A**2 / 4 - 25 * ga * A**4 / 8
            R, sine = A * w**2 + h, 2 * zeta * A * w + 4 * mu / mpmath.pi
            return R**2 + sine**2 - mpmath.mpf(float(F_0)) ** 2, R * (w**2 + h_A) + 2 * zeta * w * sine

        for Omega, A in zip(proof.Omega, proof.A, strict=True):
            w, a = mpmath.findroot(both, (mpmath.mpf(Omega.mean()), mpmath.mpf(A.mean())))
            assert mpmath.mpf(Omega[0]) <= w <= mpmath.mpf(Omega[1])
            assert mpmath.mpf(A[0]) <= a <= mpmath.mpf(A[1])


def test_where_there_is_no_proof_the_answer_says_why():
    iso = example.isolator()
    on_a_base = iso.replace(excitation="base").model
    assert IN_DOUBLES["folds"](on_a_base, 0.04).message == messages.NO_INTERVALS
    undamped = iso.replace(zeta=0.0).certify(0.04)
    assert undamped.saddle_node_onset.message == messages.OF_NO_LOWEST[True]
    assert not undamped.saddle_nodes.bounded
    stuck = iso.certify(0.9 * iso.sticking_forcing).saddle_nodes
    assert stuck.proved
    assert len(stuck.A) == 0
    linear = iso.replace(delta_h=0.0).certify(0.04)
    assert linear.saddle_nodes.proved
    assert len(linear.saddle_nodes.A) == 0
    assert linear.saddle_node_onset.message == messages.OF_NO_ONSET[True]
    assert str(iso.certify(0.04, Omega=0.9)).count("proved") == 4


@pytest.mark.parametrize(
    "bad", [{"F_0": 0.0}, {"F_0": math.nan}, {"F_0": 0.04, "Omega": 0.0}, {"F_0": 0.04, "Omega": [1]}]
)
def test_bad_input_is_refused(bad):
    with pytest.raises(ValueError, match="is not allowed"):
        example.isolator().certify(**bad)


@pytest.mark.parametrize("mu", [0.0, 1e-3])
def test_the_state_far_above_resonance_is_proved(mu):
    """There R = A Omega^2 + h is next to A Omega^2, so that A is next to sqrt(F_0^2 - m^2)/Omega^2 (23)."""
    found = Duffing(1.0, 0.5, mu, 0.02).certify(1.0, Omega=1e40).amplitudes
    expected = math.sqrt(1 - (4 * mu / math.pi) ** 2) / 1e80
    assert found.proved
    assert found.A.shape == (1, 2)
    assert found.A[0] == pytest.approx([expected, expected], rel=1e-12)


def test_the_command_line_prints_the_certificate(capsys, monkeypatch):
    assert cli.main(["certify", "0.04", "--Omega", "0.9"]) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed == [repr(example.isolator()), *str(example.isolator().certify(0.04, Omega=0.9)).splitlines()]
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    assert cli.main(["certify", repr(example.isolator().saddle_node_onset().F_SN)]) == 1
    assert "not proved" in capsys.readouterr().out
    assert cli.main(["certify", "-1"]) == 2
    assert "F_0 = -1.0 is not allowed" in capsys.readouterr().err


# ---- the arithmetic underneath --------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def intervals(once):
    if shutil.which("gcc") is None:
        pytest.skip("no gcc on the path")
    return Intervals(once("intervals", Intervals.build))


def sizes(rng, count):
    """Numbers of all sizes and both signs, some next to the least normal number, some 0."""
    values = rng.choice([-1, 1], count) * 10.0 ** rng.uniform(-8, 8, count)
    values[::7] *= 1e-300
    values[::11] = 0
    return values


@pytest.mark.slow
@pytest.mark.parametrize("name", OPERATIONS)
@pytest.mark.part(2)
def test_interval_operation_encloses_exact_arithmetic(intervals, name):
    rng = np.random.default_rng(7)
    a, b = (np.sort(np.stack([sizes(rng, 3000), sizes(rng, 3000)], axis=1), axis=1) for _ in range(2))
    narrow = rng.random(3000) < 0.5
    a[narrow, 1], b[narrow, 1] = np.nextafter(a[narrow, 0], np.inf), np.nextafter(b[narrow, 0], np.inf)
    if name in ("sqrt", "atan2"):
        a, b = np.sort(np.abs(a), axis=1), np.sort(np.abs(b), axis=1)
    out = intervals.operate(name, np.hstack([a, b]))
    with flint.ctx.workprec(2400):  # in which sums are exact
        for first, second, (low, high) in zip(a.tolist(), b.tolist(), out.tolist(), strict=True):
            if name == "div" and second[0] <= 0 <= second[1]:
                continue
            for x, y in itertools.product(first, second):
                if not (name == "atan2" and x == y == 0):
                    assert flint.arb(low) <= EXACT[name](flint.arb(x), flint.arb(y)) <= flint.arb(high)


@pytest.mark.slow
def test_averages_on_intervals_hold_their_balls(intervals):
    """Design exact, A = u_cr + d above u_cr, d a double: the reference's own formulas in balls of 400 bits."""
    rng = np.random.default_rng(11)
    flint.ctx.prec = 400
    for _ in range(150):
        design = (float(rng.integers(1, 5)), 10 ** rng.uniform(-1, 1), 10 ** rng.uniform(-4, -0.02))
        exact = averaged.RodSpring(lam=design[0], r=design[1], delta_h=design[2], mu=0.0, zeta=0.01)
        u_cr = math.sqrt(design[2] * (2 - design[2]))
        for ratio in (1e-3, 0.5, 1 - 1e-12):
            A = flint.arb(ratio * u_cr)
            h = exact.h(A, "attached")
            for (low, high), value in zip(
                intervals.known("rod_spring", design, 0, ratio * u_cr), (*h, h[0] - A * h[1], A), strict=True
            ):
                assert flint.arb(low) <= value <= flint.arb(high)
        for ratio in (1e-60, 1e-18, 1e-12, 1e-3, 0.2, 0.26, 2.0, 1e3):
            A = exact.u_cr + flint.arb(ratio * u_cr)
            h = exact.h(A, "detached")
            for (low, high), value in zip(
                intervals.known("rod_spring", design, 1, ratio * u_cr), (*h, h[0] - A * h[1], A), strict=True
            ):
                assert flint.arb(low) <= value <= flint.arb(high)


@pytest.mark.slow
@pytest.mark.parametrize("name", BOUNDED)
def test_bounded_number_encloses_the_exact_result(intervals, name):
    """Of exact pairs, and of some that are off, at both ends; exact ones lose no more than a few units in 2^-100."""
    rng, count = np.random.default_rng(5), 1500
    positive = name in ("sqrt", "atan2", "R_F", "R_D")
    high = (1 if positive else rng.choice([-1, 1], (count, 3))) * 10.0 ** rng.uniform(-6, 6, (count, 3))
    high[::5, 1] = high[::5, 0] * (
        1 + rng.choice([-1, 1], len(high[::5])) * 2.0 ** rng.uniform(-52, -1, len(high[::5]))
    )
    if name.startswith("R_"):
        high, high[:, 2] = 10.0 ** rng.uniform(-4, 0, (count, 3)), 1.0
        high[::7, 0] = 0
    low = high * rng.uniform(-1, 1, (count, 3)) * 2.0**-54
    off = np.abs(high) * 2.0 ** rng.uniform(-110, -2, (count, 3)) * (np.arange(count)[:, None] % 2)
    found = intervals.operate_bounded(name, np.stack([high, low, off], axis=2).reshape(count, 9))
    known = 0
    with flint.ctx.workprec(400):
        for numbers, (middle, rest, radius, least, most) in zip(
            np.stack([high, low, off], axis=2).tolist(), found.tolist(), strict=True
        ):
            if not radius < math.inf:
                assert (least, most) == (-math.inf, math.inf)
                continue
            known += 1
            for side in (-1, 1) if numbers[2][2] else (0,):
                x, y, z = (flint.arb(one[0]) + flint.arb(one[1]) + side * flint.arb(one[2]) for one in numbers)
                exact = EXACT[name](x, y, z)
                if not exact.is_finite():
                    continue
                assert abs(exact - flint.arb(middle) - flint.arb(rest)) <= flint.arb(radius)
                assert flint.arb(least) <= exact <= flint.arb(most)
                if side == 0:
                    size = abs(x) + abs(y) if name in ("add", "sub") else abs(exact)
                    assert flint.arb(radius) <= size * flint.arb(2) ** -88
    assert known > 0.8 * count


@pytest.mark.slow
def test_untruncated_averages_on_intervals_enclose_their_balls(intervals):
    """Against closed forms in balls; narrow at both ends, and near A = 1, where the forms divide by 0."""
    rng, widest = np.random.default_rng(13), 0.0
    for k in range(80):
        delta_h = 10 ** rng.uniform(-5, -0.005) if k % 2 else 1 - 10 ** rng.uniform(-9, -1)
        design = {"lam": float(rng.integers(1, 5)), "r": 10 ** rng.uniform(-1, 1), "delta_h": delta_h}
        model = Isolator(**design, mu=0.0, zeta=0.01, force="untruncated").model
        u_cr = math.sqrt(delta_h * (2 - delta_h))
        shares = [(0, at) for at in (1e-4, 0.3, 0.699 / u_cr, 0.9, 1 - 1e-12) if at < 1]
        shares += [(1, at) for at in (1e-60, 1e-18, 1e-9, 1e-3, 0.2, abs(1.001 / u_cr - 1) + 1e-6, 9.0, 1e3)]
        with flint.ctx.workprec(300):
            balls = BallModel(model, averages_of(model.mechanism))
            for piece, ratio in shares:
                expected = balls.at(piece, flint.arb(ratio * u_cr))
                found = intervals.known("rod_spring_untruncated", tuple(design.values()), piece, ratio * u_cr)
                for (low, high), ball in zip(
                    found, (expected.h, expected.h_A, expected.h_AA, expected.h_AAA, expected.k), strict=False
                ):
                    assert flint.arb(low) <= ball.lo
                    assert ball.hi <= flint.arb(high)
                    if ratio <= 1e3 and delta_h < 0.9:
                        widest = max(widest, float((high - low) / abs(ball.lo)))
    assert widest < 1e-7


@pytest.mark.slow
@pytest.mark.parametrize("name", ELEMENTARY)
def test_an_elementary_function_of_an_interval_holds_its_values(intervals, name):
    """At both ends and inside, against 30 digits; arguments of all sizes, which leave domains and pass poles."""
    rng, count = np.random.default_rng(7), 300
    low = rng.choice([-1, 1, 1], count) * 10.0 ** rng.uniform(-4, 2.5, count)
    low[::9] = 0
    args = np.stack([low, low + np.abs(low) * rng.choice([0, 1e-14, 0.1, 3], count)], axis=1)
    least = rng.choice([-1.5, -1, 0.5, 2.5], count)
    exponents = np.stack([least, least + rng.choice([0, 0.25], count)], axis=1)
    found = intervals.operate(name, np.hstack([args, exponents]))
    known = 0
    with mpmath.workdps(30):
        for (a, b), (p, q), (low_end, high_end) in zip(args.tolist(), exponents.tolist(), found.tolist(), strict=True):
            for fraction in (0, 1, 0.37):
                x, y = (mpmath.mpf(one) + fraction * (mpmath.mpf(other) - one) for one, other in ((a, b), (p, q)))
                if x == 0 and (name == "log" or y < 0):
                    continue  # infinite
                value = exact_elementary(name, x, y)
                if value is None:
                    assert math.isnan(low_end)
                elif not math.isnan(low_end):
                    known += 1
                    assert low_end <= value <= high_end, (name, a, b, p, q)
    assert known > count // 6


def exact_elementary(name, x, y):
    """The value, or None outside of the domain."""
    if name in ("root", "cbrt", "power"):
        return x ** {"root": mpmath.mpf(1) / 2, "cbrt": mpmath.mpf(1) / 3, "power": y}[name] if x >= 0 else None
    value = getattr(mpmath, name)(x)
    return value if isinstance(value, mpmath.mpf) else None
