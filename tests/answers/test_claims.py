"""What the ledger says of the paper's figures: committed numbers against SciPy's motions, criteria that can fail."""

import copy
import json

import numpy as np
import pytest

from derivations.ledger import measured
from derivations.ledger.rows import FALSE, LOOSE, TRUE
from slowflow import Isolator, example
from slowflow.exact import EquationOfMotion, exact_response, linear, steady_state
from tests.files import ROOT, Lazily
from tests.oracles.exact_reference import again

claims, validity, claims_page = map(Lazily, ("benchmarks.claims", "benchmarks.validity", "benchmarks.claims_page"))

NUMBERS = measured.load()
LINEAR = {row["ratio"]: row for row in NUMBERS["figure_2a"]["rows"]}
TABLE_2 = {row["forcing"]: row for row in NUMBERS["figure_7a"]["rows"]}


def isolator(row):
    return example.isolator(mu=row["ratio"] * row["F_0"])


def nearest(averaged, Omega, F_0, A):
    """Amplitude and phase of the averaged state nearest to A, as a guess of the exact one; None where there is none."""
    states = averaged.amplitudes(Omega=Omega, F_0=F_0)
    k = np.argmin(np.abs(states.A - A)) if states.A.size else None
    return None if k is None else (float(states.A[k]), float(states.phi[k]))


def state(averaged, Omega, F_0, A=None):
    """The exact motion, untruncated force, beside the averaged state nearest to A; without A from rest."""
    guess = None if A is None else nearest(averaged, Omega, F_0, A)
    return by_scipy(steady_state(averaged.equation_of_motion("untruncated"), guess, Omega=Omega, F_0=F_0))


def by_scipy(found):
    """A motion that SciPy's integrator finds too."""
    assert again(found).A == pytest.approx(found.A, rel=1e-8)
    return found


def curve(averaged, F_0, window, Omega, A=None):
    """A short piece of the exact curve, through that motion."""
    start = state(averaged, Omega, F_0, A)
    system = averaged.equation_of_motion("untruncated")
    return exact_response(system, F_0, Omega=window, start=start, step=claims.STEP)


# ---- the numbers --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("row", [*NUMBERS["figure_2b"], *TABLE_2.values()], ids=lambda row: f"{row['ratio']}")
def test_the_averaged_side_is_the_runtimes(row):
    found = claims.averaged_side(isolator(row), row["F_0"])
    assert found["A"] == pytest.approx(row["averaged"]["A"], rel=1e-4)
    if row.get("forcing") == "F_SN":
        return  # at the onset rounding decides whether there are folds
    assert measured.kinds(found) == measured.kinds(row["averaged"])
    for mine, theirs in zip(found["folds"], row["averaged"]["folds"], strict=True):
        assert (mine["Omega"], mine["A"]) == pytest.approx((theirs["Omega"], theirs["A"]), rel=1e-4)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("ratio", "part"),
    [(ratio, part) for ratio in (0.2, 0.5, 0.7) for part in ("moving", "stopping", "averaged") if LINEAR[ratio][part]],
)
def test_the_worst_points_of_figure_2a(ratio, part):
    spot = LINEAR[ratio][part]
    # not released from rest: the motion is neutral at Omega = 1/2
    guess = nearest(Isolator(lam=3, r=2, delta_h=0, mu=ratio, zeta=0), spot["Omega"], 1.0, spot["A"])
    exact = by_scipy(steady_state(EquationOfMotion(linear(), ratio, 0.0), guess, Omega=spot["Omega"], F_0=1.0))
    assert exact.A == pytest.approx(spot["A"], rel=1e-4)
    assert (exact.stops > 0) == (part == "stopping") or part == "averaged"
    other = (claims.averaged_linear if part == "averaged" else claims.closed_form)(spot["Omega"], ratio)
    assert abs(other / exact.A - 1) == pytest.approx(spot["off"], rel=1e-3, abs=1e-8)


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [0.2, 0.7])
def test_the_course_of_figure_2a(ratio):
    system = EquationOfMotion(linear(), ratio, 0.0)
    for side, expected in zip(((0.6, 0.7, 0.8, 0.9), (1.1, 1.2, 1.3, 1.45)), ("rises", "falls"), strict=True):
        A = [by_scipy(steady_state(system, Omega=Omega, F_0=1.0)).A for Omega in side]
        assert claims.course(A) == claims.course(claims.averaged_linear(np.array(side), ratio)) == [expected]
    assert LINEAR[ratio]["course"]["exact"] == [["rises"], ["falls"]]


def close(found, row):
    """Whether these folds are those of the row, Omega and A within 1e-4."""
    assert [fold.kind for fold in found] == [fold["kind"] for fold in row]
    for mine, theirs in zip(found, row, strict=True):
        assert (mine.Omega, mine.A) == pytest.approx((theirs["Omega"], theirs["A"]), rel=1e-4)


@pytest.mark.slow
@pytest.mark.parametrize("forcing", ["0.025", "0.040"])
@pytest.mark.part(2)
def test_exact_jumps_of_figure_7a(forcing):
    """On a short piece around each fold, begun on the stable side of the fold."""
    row = TABLE_2[forcing]
    for fold in row["exact"]["folds"]:
        window = (fold["Omega"] / 1.004, fold["Omega"] * 1.004)
        at = window[1] if fold["kind"] == "jump-up" else window[0]
        close(curve(isolator(row), row["F_0"], window, at, fold["A"]).folds, [fold])


@pytest.mark.slow
def test_exact_jumps_where_averaging_has_none():
    """The first case of Figure 2b in which the folds differ: the curve from below the lower one to above the upper."""
    row = next(row for row in NUMBERS["figure_2b"] if not measured.same_folds(row))
    low, high = (fold["Omega"] for fold in row["exact"]["folds"])
    averaged, F_0 = isolator(row), row["F_0"]
    assert len(averaged.saddle_nodes(F_0)) == 0
    system, window = averaged.equation_of_motion("untruncated"), (0.995 * low, 1.005 * high)
    close(exact_response(system, F_0, Omega=window, step=claims.STEP).folds, row["exact"]["folds"])


@pytest.mark.slow
@pytest.mark.parametrize("forcing", ["F_SN", "0.025", "F_cr", "0.040", "0.050"])
def test_the_worst_points_of_figure_7a(forcing):
    row = TABLE_2[forcing]
    averaged, F_0, Omega, A = isolator(row), row["F_0"], row["point"]["Omega"], row["point"]["A"]
    states = averaged.amplitudes(Omega=Omega, F_0=F_0)
    assert np.abs(states.A / A - 1).min() < 1e-5
    found = curve(averaged, F_0, (Omega / 1.012, Omega * 1.012), Omega, A)
    off = validity.misfit(validity.logs([Omega], [A]), validity.logs(found.Omega, found.A))[0]
    assert off == pytest.approx(row["point"]["off"], abs=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("forcing", ["F_SN", "0.040", "0.050"])
@pytest.mark.part(3)
def test_the_largest_amplitudes_of_figure_7a(forcing):
    row = TABLE_2[forcing]
    averaged, F_0 = isolator(row), row["F_0"]
    peak = averaged.peak(F_0)
    found = curve(averaged, F_0, (0.985 * peak.Omega, 1.015 * peak.Omega), 0.99 * peak.Omega, 0.98 * peak.A)
    assert found.A.max() == pytest.approx(row["exact"]["A"], rel=1e-3)


@pytest.mark.slow
def test_the_exact_onset_of_figure_7a():
    """The exact curve becomes vertical between forcings 0.2 per cent apart."""
    averaged = example.isolator()
    onset = NUMBERS["figure_7a"]["F_SN"]
    assert averaged.saddle_node_onset().F_SN == pytest.approx(onset["averaged"], rel=1e-5)
    exact = onset["averaged"] / (1 + onset["off"])
    rates = [validity.steepness(curve(averaged, F_0, (0.755, 0.795), 0.76)) for F_0 in (0.999 * exact, 1.001 * exact)]
    assert rates[0] > 0 > rates[1]


@pytest.mark.slow
def test_the_recipe_at_one_frequency():
    """As published but for the number of periods: forty are enough at this friction."""
    spot = next(s for s in NUMBERS["figure_2a"]["published way"] if (s["ratio"], s["Omega"]) == (0.6, 1.4))
    F_0 = claims.PUBLISHED_F_0
    found = claims.direct_integration(EquationOfMotion(linear(), 0.6 * F_0, 0.0), 1.4, F_0, turns=40, kept=5)
    assert found.A_sampled / (F_0 * claims.closed_form(1.4, 0.6)) - 1 == pytest.approx(spot["sampled"], abs=2e-3)


# ---- the verdicts -------------------------------------------------------------------------------------------------


def test_the_ledger_has_the_verdicts_of_the_measurement():
    rows = {row["id"]: row for row in json.loads(claims_page.LEDGER.read_text(encoding="utf-8"))["rows"]}
    for claim, (verdict, evidence) in measured.decided(NUMBERS).items():
        assert (rows[claim]["verdict"], rows[claim]["evidence"]) == (verdict, evidence)


def test_the_page_has_the_tables_of_the_measurement():
    assert claims_page.section() in (ROOT / "docs" / "validity.md").read_text(encoding="utf-8")


def without_agreement_with_35(numbers, above, size):
    for row in numbers["figure_2a"]["rows"]:
        if row["ratio"] > above:
            row["moving"]["off"] = size


def other_course(numbers, above):
    for row in numbers["figure_2a"]["rows"]:
        if row["ratio"] > above:
            row["course"]["exact"][0] = ["falls", "rises"]


def other_folds(numbers, ratio):
    for row in numbers["figure_2b"]:
        if row["ratio"] == ratio:
            row["exact"]["folds"] = []


def all_folds_alike(numbers):
    for row in numbers["figure_2b"]:
        row["exact"] = row["averaged"]


def points_of_7a(numbers, off):
    for row in numbers["figure_7a"]["rows"]:
        row["point"]["off"] = off


@pytest.mark.parametrize(
    ("claim", "change", "verdict"),
    [
        ("den_hartog_agreement", lambda n: without_agreement_with_35(n, 0.35, 0.011), TRUE),
        ("den_hartog_agreement", lambda n: without_agreement_with_35(n, 0.25, 0.011), FALSE),
        ("den_hartog_agreement", lambda n: n["figure_2a"]["published way"][0].update(sampled=-0.02), TRUE),
        ("den_hartog_agreement", lambda n: [s.update(sampled=-0.02) for s in n["figure_2a"]["published way"]], FALSE),
        ("kbm_qualitative", lambda n: other_course(n, 0.75), LOOSE),
        ("kbm_qualitative", lambda n: other_course(n, 0.25), FALSE),
        ("kbm_low_friction", lambda n: other_folds(n, 0.35), LOOSE),
        ("kbm_low_friction", lambda n: other_folds(n, 0.05), FALSE),
        ("kbm_low_friction", lambda n: other_folds(n, 0.4), TRUE),
        ("agreement_acceptable", lambda n: points_of_7a(n, 0.05), TRUE),
        ("agreement_acceptable", lambda n: points_of_7a(n, 0.051), FALSE),
        ("agreement_acceptable", lambda n: n["figure_7a"]["F_SN"].update(off=-0.06), FALSE),
        ("agreement_acceptable", lambda n: n["figure_7a"]["rows"][3]["averaged"].update(A=1.06), FALSE),
        ("agreement_acceptable", lambda n: n["figure_7a"]["rows"][3]["averaged"]["folds"][0].update(Omega=0.95), FALSE),
        ("agreement_acceptable", lambda n: n["figure_7a"]["rows"][3]["exact"]["folds"].pop(), FALSE),
        ("reliability", lambda n: points_of_7a(n, 0.05), TRUE),
        ("reliability", lambda n: other_folds(n, 0.05), FALSE),
        ("conclusion_kbm", all_folds_alike, TRUE),
        ("conclusion_kbm", lambda n: other_course(n, 0.25), FALSE),
    ],
)
def test_verdicts_follow_the_numbers(claim, change, verdict):
    numbers = copy.deepcopy(NUMBERS)
    change(numbers)
    found = measured.verdicts(numbers)
    assert found[claim] == verdict
    if found != measured.DECIDED:
        with pytest.raises(ArithmeticError, match="other verdicts"):
            measured.decided(numbers)


def test_every_claim_on_a_figure_is_asked_for_something():
    assert set(measured.CRITERIA) == set(measured.DECIDED) == set(measured.verdicts(NUMBERS))
    assert (measured.EXCELLENT, measured.ACCEPTABLE, measured.SEVERAL) == (0.01, 0.05, 3)
