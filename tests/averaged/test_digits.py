"""Answers at places where doubles lose digits: as many as there are, each right to its last digits.

`data/hard_places.json` has the places. Their counts were proved by isolating the roots of exact polynomials, or by
scans in 60 digits; exact are the solutions next to the answers, by Newton's method in 420 bits.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import mpmath
import numpy as np
import pytest

from slowflow import Duffing, Isolator
from slowflow.answers.results import Remark
from slowflow.averaged import solvers
from tests.files import stored
from tests.oracles.answers import VALUES, Nearby, errors
from tests.oracles.errors import U
from tests.sampling import slow

CASES = stored("hard_places")
#: relative error of any number; under a force it is no more than a rounding of its condition, too
WITHIN = 1e-15


def made(case: dict[str, Any], excitation: str) -> tuple[Any, Any, Nearby]:
    """The oscillator of a case, a batch of it, and the exact solutions next to its answers."""
    kind, mechanism = Duffing if case["mechanism"] == "duffing" else Isolator, case["mechanism"]
    parameters = case["numbers"] | {"excitation": excitation}
    if mechanism == "rod_spring_untruncated":
        parameters["force"] = "untruncated"
    if excitation != "force":
        mechanism += " by inertia"
    return kind(**parameters), kind.many(**parameters), Nearby(mechanism, **case["numbers"])


@pytest.mark.parametrize(
    ("case", "excitation"),
    [
        pytest.param(case, excitation, id=f"{case['question']} {excitation}: {case['why']}")
        for case in CASES
        for excitation in case.get("excitations", ["force"])
    ],
)
def test_answers_at_hard_places_are_complete_to_the_last_digit(case, excitation):
    question, query = case["question"], case["given"]
    one, many, nearby = made(case, excitation)
    found = getattr(one, question)(**query)
    each = list(found) if question in ("amplitudes", "saddle_nodes", "cusps", "isola_points") else [found]
    assert case["count"] == (0 if question == "saddle_node_onset" and found.F_SN is None else len(each))
    each = each[: case["count"]]
    for name in {"kind", "stable", "minimum", "corner"} & set(case):
        assert [getattr(answer, name) for answer in each] == case[name]
    for name, values in case.get("exact", {}).items():  # where Newton's method leaves the place
        assert getattr(found, name) == pytest.approx(values, rel=WITHIN, abs=0)
    if "by_balls" in case:
        assert Remark.BY_BALLS in found.remarks and Remark.UNDECIDED not in found.remarks
    if "proved" in case:
        proof = one.certify(**query).amplitudes
        assert proof.proved and len(proof.A) == case["count"]
    for answer in each if "exact" not in case else ():
        for name, (relative, rounding) in errors(answer, nearby, question, query).items():
            assert relative <= WITHIN and (rounding <= 1 or excitation != "force"), name
    if question in ("saddle_nodes", "saddle_node_onset", "amplitudes"):
        of_many = getattr(many, question)(**query)
        for name in VALUES[question][1].values():
            values = np.ravel(getattr(of_many, name))[: len(each)]
            assert values.tolist() == [getattr(answer, name) for answer in each]
        assert question == "saddle_node_onset" or (of_many.count == len(each) and not of_many.undecided)
        assert of_many.remarks == int(found.remarks) and not (each and of_many.status)


@pytest.mark.parametrize("zeta", [1e-14, 1e-12, 1e-10, 1e-8])
def test_isola_next_to_no_damping_is_off_by_its_rounding(zeta):
    """Newton's method in Omega and A divided by a difference of which nothing was left: A was off by 13 u."""
    rng = np.random.default_rng(1)
    designs = [(rng.uniform(0.1, 3), -(10 ** rng.uniform(-3, 1)), 10 ** rng.uniform(-6, -1)) for _ in range(12)]
    for alpha, beta, mu in (*designs, (1.4980195101765232, -0.062511901945525, 0.00045200404964629135)):
        numbers = {"alpha": alpha, "beta": beta, "mu": mu, "zeta": zeta}
        (point,) = (one for one in Duffing(**numbers).isola_points(A_max=200.0) if one.Omega > 1e-3)
        for relative, rounding in errors(point, Nearby("duffing", **numbers), "isola_points", {}).values():
            assert relative <= 1.5 * U and rounding <= 1


def test_a_peak_by_inertia_beside_a_zero_of_h_is_found():
    """The branches that meet there are the ones that the states lie on."""
    mount = Duffing(0.5458758695736523, -0.001181373076817857, 0.0, 7.894001479905327e-12, excitation="unbalance")

    assert (
        mount.peak(8.298060153609718).A is None
    )  # it turns beyond the well, whose top is at sqrt(alpha/|beta|) = 21.5
    peak = solvers.peak(mount.model, 8.298060153609718)
    states = mount.amplitudes(Omega=0.2133004675098253, F_0=8.298060153609718)

    assert peak.A == pytest.approx(24.82120046422046, rel=1e-15)
    assert peak.Omega == pytest.approx(4.7940521170256493e-11, rel=1e-14, abs=0)
    assert states.A == pytest.approx([0.7552664571615544, 23.377677392673924, 24.132943849835478], rel=1e-14)


@pytest.mark.slow
@pytest.mark.parametrize("mu", [0.0, 1e-9])
@pytest.mark.parametrize("zeta", [1e-6, 1e-12, 1e-20, 1e-30, 1e-50])
@pytest.mark.part(3)
def test_the_fold_locus_of_a_force_has_the_digits_of_its_level(zeta, mu):
    """F_A = 0 as a polynomial in Omega by mpmath, at each A: on one branch R is far below rounding of A Omega^2."""
    alpha, beta = 2.0, 0.5
    found = Duffing(alpha, beta, mu=mu, zeta=zeta).fold_locus(A_max=3.0, samples=60)
    # what damping is too weak to hide begins at rest at the stiffness there
    assert found.Omega[found.A == 0] == pytest.approx(np.sqrt(alpha), rel=1e-15) and (found.Omega > 0.5).all()
    checked = set()
    with mpmath.workdps(150):
        m = 4 * mpmath.mpf(mu) / mpmath.pi
        for Omega, A, F_0 in zip(
            found.Omega.tolist(), map(mpmath.mpf, found.A.tolist()), found.F_0.tolist(), strict=True
        ):
            if not 0.05 < A < 3:
                continue
            h, h_A = -alpha * A - 0.75 * beta * A**3, -alpha - 2.25 * beta * A**2
            polynomial = [A, 0, h + A * h_A + 4 * mpmath.mpf(zeta) ** 2 * A, 2 * zeta * m, h * h_A]
            roots = mpmath.polyroots(polynomial, maxsteps=500, extraprec=1000)
            Omega = min((mpmath.re(root) for root in roots), key=lambda root: abs(root - Omega))
            level = mpmath.hypot(A * Omega**2 + h, 2 * mpmath.mpf(zeta) * A * Omega + m)
            assert F_0 == pytest.approx(float(level), rel=1e-13, abs=0)
            checked.add(bool(abs(A * Omega**2 + h) < 1e-3 * A))
    assert checked == {True, False}


@pytest.mark.parametrize("mu", [0.0, 0.0625])
@pytest.mark.parametrize("zeta", [1e-18, *slow(1e-16, 1e-17, 1e-20, 1e-25)])
def test_softening_fold_next_to_no_damping_has_all_branches(mu, zeta):
    """Neither I nor R gave the fold's frequency a digit: it was that of another state, and two states were missing.

    What such damping changes of the undamped closed forms is less than a rounding: 1.5 A^3 = k at the fold, where
    Omega^2 = 2 - 2.25 A^2, and Omega^2 = 2 - .75 A^2 -+ k/A at the states.
    """
    oscillator, k = Duffing(2.0, -1.0, mu, zeta), 0.25
    F_0 = float(np.hypot(k, oscillator.sticking_forcing))
    folds = oscillator.saddle_nodes(F_0)

    A = (k / 1.5) ** (1 / 3)
    assert folds.A == pytest.approx([A], rel=1e-14)
    assert folds.Omega == pytest.approx([np.sqrt(2 - 2.25 * A**2)], rel=1e-14)
    assert list(folds.kind) == ["jump-up"]
    curve = oscillator.frequency_response(F_0, samples=60)
    assert len(np.unique(curve.branch)) == 2
    for Omega, count in ((0.5, 3), (1.3, 1)):
        states = oscillator.amplitudes(Omega=Omega, F_0=F_0)
        at = np.array(states.A)
        assert len(at) == count
        np.testing.assert_allclose(np.abs((Omega**2 - 2 + 0.75 * at**2) * at), k, rtol=1e-13)


@pytest.mark.parametrize("zeta", [1e-7, 1e-9, 1e-12])
def test_all_of_a_resonance_without_digits_of_R_is_stable(zeta):
    """A linear mount has one motion at each frequency, which is stable, and the closed form's height."""
    found = Duffing(1.0, 0.0, zeta=zeta).frequency_response(1e-2, samples=400, Omega=(0.5, 1.5))
    assert found.stable.all() and len(found) > 400
    assert found.A.max() == pytest.approx(1e-2 / (2 * zeta), rel=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("excitation", ["force", "base"])
@pytest.mark.parametrize("law", ["eta", "c_2", "zeta_2"])
def test_cusps_and_folds_by_other_laws_have_their_digits(law, excitation):
    """F_SN came from A Omega^2 + h, of which weak damping leaves little: it was off by up to 4,000 roundings."""

    def squared(Omega, A):
        """R^2 + I^2 (24)."""
        R = A * Omega**2 - A - beta * A**3 * 3 / 4
        viscous = zeta + of_law * A**2 / 4 if law == "zeta_2" else zeta
        other = {"eta": A, "c_2": 8 * (A * Omega) ** 2 / (3 * mpmath.pi), "zeta_2": 0}[law]
        return R**2 + (4 * mu / mpmath.pi + 2 * viscous * Omega * A + of_law * other) ** 2

    def slope(Omega, A, order=1):
        """F_A (30), or F_AA."""
        return mpmath.diff(lambda at: squared(Omega, at), A, order)

    def level(Omega, A):
        return mpmath.sqrt(squared(Omega, A)) / (Omega**2 if excitation == "base" else 1)

    rng, cusps, points = np.random.default_rng(5), 0, 0
    for powers in rng.uniform((-1, -4, -4, -4), (1.5, -1.3, -0.7, -0.5), (12, 4)):
        numbers = dict(zip(("beta", "mu", "zeta", law), (10**powers).tolist(), strict=True))
        mount = Duffing(1.0, excitation=excitation, **numbers)
        onset = mount.saddle_node_onset()
        if onset.kind != "cusp":
            continue
        F_0, cusps = 1.5 * onset.F_SN, cusps + 1
        beta, mu, zeta, of_law = map(mpmath.mpf, numbers.values())
        with mpmath.workdps(80):
            at_fold = (lambda *at, F_0=F_0: level(*at) - F_0, slope)
            for answer in (onset, *mount.saddle_nodes(F_0)):
                system = (slope, lambda *at: slope(*at, 2)) if answer is onset else at_fold
                exact = mpmath.findroot(system, (answer.Omega, answer.A), tol=1e-90)
                found = [*zip((answer.Omega, answer.A), exact, strict=True)]
                if answer is onset:
                    found.append((onset.F_SN, level(*exact)))
                assert all(abs(value - at) <= 32 * U * at for value, at in found)
            locus = mount.fold_locus(A_max=2.0, samples=12)
            for Omega, A, F_0 in zip(locus.Omega.tolist(), locus.A.tolist(), locus.F_0.tolist(), strict=True):
                near = [Omega, Omega * (1 + mpmath.mpf(2) ** -40)]
                exact = mpmath.findroot(partial(slope, A=mpmath.mpf(A)), near, verify=False, maxsteps=60)
                if A > 0 and abs(exact / Omega - 1) < 1e-13:  # where branches meet Omega has half of the digits
                    points += 1
                    assert abs(F_0 - level(exact, A)) <= 32 * U * level(exact, A)
    assert cusps > 4 and points > 60
