"""Numbers of folds and states that rounding may decide: right, or said to be undecided, in every kind of answer."""

from __future__ import annotations

import importlib.util
import math

import flint
import mpmath
import numpy as np
import pytest

from slowflow import Duffing, Isolator
from slowflow.answers.results import Remark
from slowflow.answers.table import DOUBLES
from slowflow.averaged import proofs, solvers
from slowflow.averaged.many import PROVED_FOLDS, PROVED_STATES, SADDLE_NODES
from slowflow.oscillators.oscillator import Oscillator
from slowflow.support.errors import NotSettled
from slowflow_kernels import duffing
from slowflow_kernels.conventions import Status
from tests.averaged.test_states_by_balls import exact
from tests.files import stored
from tests.oracles import counts
from tests.oracles.answers import Nearby
from tests.oracles.draws import batch, drawn_isolators, drawn_springs, forcings, oscillator
from tests.sampling import fewer

#: drawn oscillators and forcings; without compiled code there is nothing to hold them against
DRAWN = fewer(50_000, 5)
KINDS = {"duffing": Duffing, "rod_spring": Isolator}


def number_at(states, Omega):
    return int((states.Omega == Omega).sum())


# ---- cases that were wrong without a word ----------------------------------------------------------------------------


def test_state_next_to_a_fold_is_counted_or_undecided():
    """4 u (1 + kappa) from a level, delta_h an ulp or so from 1: 2 were given of 3."""
    iso = oscillator(
        Isolator, 2.0, 0.3826468676681486, 0.999999992613948, mu=0.010288595466119472, zeta=0.012760485593729996
    )
    Omega, F_0 = 2.228623128483206, 4.732572144286754
    found = iso.amplitudes(Omega=Omega, F_0=F_0)
    assert counts.States(exact(iso), Omega).count(F_0) == 3
    assert len(found) == 3 or Remark.UNDECIDED in found.remarks
    assert (Remark.UNDECIDED in found.remarks) == (found.Omega_undecided.tolist() == [Omega])
    assert ("is not resolved" in found.message and f"{Omega:.17g}" in found.message) == bool(found.Omega_undecided.size)


@pytest.mark.parametrize("delta_h", [1e-3, 3e-6, 1e-7, 1e-9, 1e-20, 1e-60])
def test_onset_of_a_small_jump_is_the_corner_on_the_backbone(delta_h):
    """It jumps up at u_cr by 1.5 lam r delta_h^3 of itself: there folds are born where R = 0, from F_0 = I on (24)."""
    iso = Isolator(lam=3, r=0.5, delta_h=delta_h, mu=0.012, zeta=0.02)
    many = Isolator.many(lam=3, r=0.5, delta_h=[delta_h], mu=0.012, zeta=0.02).saddle_node_onset()
    found = iso.saddle_node_onset()
    assert Remark.BY_BALLS not in found.remarks
    assert many.remarks == [int(found.remarks)]
    with mpmath.workdps(50):
        u_cr = mpmath.sqrt(2 * mpmath.mpf(delta_h) - mpmath.mpf(delta_h) ** 2)
        Omega = iso.backbone(iso.breakpoints[0])
        F_SN = 4 * mpmath.mpf(0.012) / mpmath.pi + 2 * mpmath.mpf(0.02) * u_cr * float(Omega)
    assert found.kind == "corner" and found.A == pytest.approx(float(u_cr), rel=4e-16)
    assert found.F_SN == pytest.approx(float(F_SN), rel=1e-15) and many.F_SN == [found.F_SN]
    assert Remark.OF_TRUNCATION in found.remarks
    assert len(iso.saddle_nodes(1.1 * found.F_SN)) == 2 and len(iso.saddle_nodes(0.999999 * found.F_SN)) == 0


def test_folds_within_rounding_of_the_corner_are_not_denied():
    """None of its amplitudes is a double, and yet there are folds, as balls say."""
    iso = Isolator(lam=3, r=2, delta_h=1e-5, mu=0.012, zeta=0.02)
    locus = iso.fold_locus()
    assert len(exact(iso).folds(0.04)) == 2
    assert len(locus) > 0 or f"within rounding of A = {iso.breakpoints[0]:g}, where the force jumps" in locus.message


def test_states_just_above_friction_are_proved_or_undecided():
    """Where I exceeds F_0 there is no state: F_0 - 4 mu/pi says up to where, and has six digits here."""
    iso = Duffing(0.30726528991668056, -0.3658785478804152, mu=2.701549008849204e-06, zeta=4.6374909032157274e-05)
    F_0, Omega = 3.4397190306415187e-06, 5.44729375421581e-12
    found, proof = iso.amplitudes(Omega=Omega, F_0=F_0), proofs.states.in_doubles(iso.model, F_0, Omega)
    decides = Remark.UNDECIDED if importlib.util.find_spec("flint") is None else Remark.BY_BALLS
    assert (decides in found.remarks) == (not proof.proved)
    assert decides is Remark.UNDECIDED or len(found) == counts.States(exact(iso), Omega).count(F_0)


def test_forcing_a_rounding_above_4_mu_over_pi_is_named():
    """A softening spring next to its static load: branches coincide; a hardening one: states, but not how many."""
    softening = Duffing(0.38995370142405467, -0.01719156821217771, 1e-12, 0.001066590401249237)
    hardening = Duffing(1.0, 0.5, 1e-9, 0.01)
    for iso in (softening, hardening):
        F_0 = math.nextafter(iso.sticking_forcing, 1)
        try:
            found = iso.amplitudes(Omega=0.62, F_0=F_0)
        except NotSettled as refusal:
            assert "exceeds 4 mu/pi" in str(refusal)
        else:
            assert Remark.BY_BALLS in found.remarks or "4 mu/pi" in found.message
            assert len(found) == counts.States(exact(iso), 0.62).count(F_0) or Remark.UNDECIDED in found.remarks


def test_a_curve_of_undecided_folds_says_so():
    iso = Duffing(1.0021174150372412, -0.7852683936675544, 0.03237752605590381, 1e-4)
    F_0 = 0.5048231197593197
    assert Remark.UNDECIDED not in iso.saddle_nodes(F_0).remarks and len(iso.saddle_nodes(F_0)) == 2
    assert Remark.UNDECIDED in iso.frequency_response(F_0, samples=10).remarks
    curves = Duffing.many(alpha=iso.alpha, beta=iso.beta, mu=iso.mu, zeta=iso.zeta).frequency_response(F_0, samples=10)
    assert Remark.UNDECIDED in Remark(int(curves.remarks))
    assert iso.amplitudes(Omega=[0.5, 1.0], F_0=F_0).Omega_undecided.tolist() in ([], [0.5, 1.0])


# ---- what doubles leave undecided balls decide -----------------------------------------------------------------------

CASES = stored("hard_counts")


@pytest.mark.parametrize(
    "case",
    [
        pytest.param(case, id=case["why"], marks=[pytest.mark.slow] if {"undecided", "isolated"} & set(case) else [])
        for case in CASES
    ],
)
def test_at_hard_places_folds_are_those_that_are_proved(case, monkeypatch):
    """Singly and in a batch, with kinds, order and remarks; without balls those left open are undecided."""
    kind, F_0, (*own, mu, zeta) = KINDS[case["mechanism"]], case["F_0"], case["numbers"].values()
    iso, designs = oscillator(kind, *own, mu=mu, zeta=zeta), batch(kind, (*own, mu, zeta))
    assert (Remark.UNDECIDED in solvers.folds(iso.model, F_0).remarks) == ("undecided" in case)  # in doubles
    found, many = iso.saddle_nodes(F_0, certify=True), designs.saddle_nodes([F_0, 2 * F_0])
    proof = found.proof
    assert proof.proved and "saddle_nodes gives" not in proof.message
    assert len(found) == many.count[0] == len(proof.A) == case["count"]
    assert Remark.UNDECIDED not in found.remarks and not many.undecided[0] and many.status[0] == Status.OK
    assert int(many.remarks[0]) == int(found.remarks) and ("no saddle node" in found.message) == (len(found) == 0)
    for one in (proof, proofs.folds.in_balls(iso.model, F_0)):
        assert (one.kind.tolist(), one.corner.tolist()) == (found.kind.tolist(), found.corner.tolist())
    assert np.lexsort((found.A, found.Omega)).tolist() == list(range(len(found)))
    assert (np.diff(proof.A.mean(axis=1))[np.diff(found.Omega) == 0] >= 0).all()
    folds = sorted(exact(iso).folds(F_0), key=lambda fold: float(fold.Omega.mid())) if "isolated" in case else None
    for name in ("Omega", "A"):
        values, enclosed, several = (getattr(one, name) for one in (found, proof, many))
        assert (enclosed[:, 0] <= values).all() and (values <= enclosed[:, 1]).all()
        assert several[0, : len(values)].tolist() == values.tolist() and np.isnan(several[0, len(values) :]).all()
        if folds is not None:
            sure = [getattr(fold, name) for fold in folds]
            assert values == pytest.approx([float(one.mid()) for one in sure], rel=4e-16, abs=0)
            ends = zip(*enclosed.T.tolist(), sure, strict=True)
            assert all(flint.arb(low) <= one <= flint.arb(high) for low, high, one in ends)
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    single, many = iso.saddle_nodes(F_0), designs.saddle_nodes(F_0)
    assert (Remark.UNDECIDED in single.remarks) == ("is not resolved" in single.message) == ("undecided" in case)
    assert (int(many.remarks), many.count, bool(many.undecided)) == (
        int(single.remarks),
        len(single),
        "undecided" in case,
    )


#: lam, r, delta_h, mu, zeta of the untruncated force: a cusp between u_cr and the last double below it, which doubles
#: had by 1e-8 to 1e-4 without a word
CUSPS_NEXT_TO_U_CR = (
    (2.928289223287754, 0.013332282665816398, 0.999999999974466, 1.66e-4, 3.3e-3),
    (2.0, 0.11, 1 - 9 * 2.0**-53, 0.004, 0.001),
)


@pytest.mark.slow
@pytest.mark.parametrize("design", CUSPS_NEXT_TO_U_CR)
def test_cusps_next_to_u_cr_are_those_of_balls_or_said(design, monkeypatch):
    pytest.importorskip("flint")
    parameters = dict(zip(("lam", "r", "delta_h", "mu", "zeta"), design, strict=True))
    iso, nearby = Isolator(**parameters, force="untruncated"), Nearby("rod_spring_untruncated", **parameters)
    found = iso.cusps()
    assert found.remarks == Remark.BY_BALLS and "ball arithmetic" in found.message and len(found) > 0
    for cusp in found:
        point, _ = nearby.solution("cusp", cusp.Omega, cusp.A, cusp.F_0)
        for name in ("F_0", "Omega", "A"):
            assert getattr(cusp, name) == pytest.approx(float(getattr(point, name).mid()), rel=2e-16, abs=0)
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    in_doubles = iso.cusps()
    assert in_doubles.remarks == Remark.UNDECIDED and "those at A = 1 have few correct digits" in in_doubles.message


def test_what_is_quasi_zero_stiffness_to_rounding_stays_so():
    assert Isolator(lam=1.0, r=10.0, delta_h=0.1, mu=1e-4, zeta=0.01).alpha == 0


# ---- no answer differs from the proof without a word -----------------------------------------------------------------


@pytest.mark.parametrize(("kind", "draw"), [(Isolator, drawn_isolators), (Duffing, drawn_springs)])
@pytest.mark.slow
def test_folds_single_batched_and_proved_agree_or_say_so(kind, draw):
    rng = np.random.default_rng(2026)
    numbers = draw(rng, DRAWN)
    designs = batch(kind, numbers)
    F_0 = forcings(rng, designs, numbers[-2])
    *_, counted, undecided, status = designs.ask(SADDLE_NODES, -1, F_0, 12)  # by doubles alone
    number, all_proved, *_ = designs.ask(PROVED_FOLDS, -1, F_0)
    there = status == Status.OK
    decided = there & (undecided == 0)
    proved = all_proved == 1
    assert (number[decided & proved] == counted[decided & proved]).all()
    for k in np.flatnonzero(decided & ~proved)[:5]:  # next to none: there balls judge
        *own, mu, zeta = (float(column[k]) for column in numbers)
        assert len(exact(oscillator(kind, *own, mu=mu, zeta=zeta)).folds(float(F_0[k]))) == counted[k]
    assert (decided & ~proved).sum() < 5
    assert decided.sum() > 0.8 * DRAWN and (there & ~decided).sum() > 100
    some = rng.choice(np.flatnonzero(there), fewer(300, 6), replace=False)
    some = np.concatenate((some, np.flatnonzero(there & ~decided)[: fewer(50, 6)]))
    found = batch(kind, [column[some] for column in numbers]).saddle_nodes(F_0[some], max_count=12)
    for i, k in enumerate(some):
        *own, mu, zeta = (float(column[k]) for column in numbers)
        one = oscillator(kind, *own, mu=mu, zeta=zeta).saddle_nodes(float(F_0[k]))
        assert len(one) == found.count[i] and (Remark.UNDECIDED in one.remarks) == bool(found.undecided[i])
        assert int(one.remarks) == int(found.remarks[i])
        assert decided[k] <= (found.count[i] == counted[k])
    assert (found.undecided != 0).mean() < 0.01


@pytest.mark.parametrize(("kind", "draw"), [(Isolator, drawn_isolators), (Duffing, drawn_springs)])
@pytest.mark.slow
def test_states_and_proofs_do_not_differ_without_a_word(kind, draw):
    """10^5 frequencies, most of them next to folds, solved in doubles only.

    Where only the proof is inconclusive balls agree with the answer; where doubles are, the answer is that of balls.
    """
    rng = np.random.default_rng(2027)
    numbers, most = draw(rng, 700), fewer(40, 4)
    total = undecided = unproved = judged = decided = 0
    forced = forcings(rng, batch(kind, numbers), numbers[-2])
    for k, F_0 in enumerate(forced[: fewer(700, 4)].tolist()):
        *own, mu, zeta = (float(column[k]) for column in numbers)
        iso = oscillator(kind, *own, mu=mu, zeta=zeta)
        try:
            folds = iso.saddle_nodes(F_0)
            near_folds = folds.Omega[:, np.newaxis] * (1 + rng.choice([-1, 1], 60) * 10 ** rng.uniform(-16.3, -2, 60))
            Omega = np.unique(np.concatenate((10 ** rng.uniform(-1, 0.5, 30), near_folds.ravel())))
            Omega = Omega[Omega > 0]
            states = iso.states(Omega=Omega, F_0=F_0, allowance=proofs.Allowance(0))
        except NotSettled as refusal:
            assert "unresolved" in str(refusal)
            continue
        number = np.searchsorted(states.Omega, Omega, "right") - np.searchsorted(states.Omega, Omega)
        reported = np.isin(Omega, states.Omega_undecided)
        counted, all_proved, *_ = batch(kind, (*own, mu, zeta)).ask(PROVED_STATES, 1, F_0, Omega=Omega)
        proved = all_proved == 1
        assert (number[proved & ~reported] == counted[proved & ~reported]).all(), (iso, F_0)
        assert not (proved & reported).any(), (iso, F_0)
        total, undecided = total + Omega.size, undecided + int(reported.sum())
        unproved += int((~proved & ~reported).sum())
        for w in Omega[~proved & ~reported][:1]:
            if judged < most and zeta >= 1e-6:
                judged += 1
                assert counts.States(exact(iso), float(w)).count(F_0) == number_at(states, w), (iso, F_0, w)
        for w in Omega[reported][:1]:
            if decided < most and zeta >= 1e-6:
                decided += 1
                answer = iso.amplitudes(Omega=w, F_0=F_0)
                known = answer.Omega_undecided.tolist() == [w] or counts.States(exact(iso), w).count(F_0) == len(answer)
                assert known, (iso, F_0, w)
    assert total > fewer(50_000, 4)
    assert decided == most
    assert 0 < undecided < 0.08 * total
    assert unproved <= 1e-4 * total


def test_a_batch_of_proofs_is_that_of_single_ones():
    numbers = {"lam": 3.0, "r": np.array([0.5, 2.0]), "delta_h": 0.08, "mu": 0.01, "zeta": 0.02}
    F_0, Omega = np.array([[0.012], [0.04]]), np.array([0.7, 0.9])
    for force in ("truncated", "untruncated"):
        designs = Isolator.many(**numbers, force=force)
        folds, states = designs.certify(F_0), designs.certify(F_0, Omega=Omega, workers=2)
        assert folds.count.shape == states.proved.shape == (2, 2)
        for (i, j), count in np.ndenumerate(folds.count):
            one = oscillator(Isolator, 3.0, float(numbers["r"][j]), 0.08, mu=0.01, zeta=0.02).replace(force=force)
            single = proofs.folds(one.model, float(F_0[i, 0]))
            assert (folds.proved[i, j], count, folds.bits[i, j]) == (single.proved, len(single.A), single.bits)
            assert folds.status[i, j] == (Status.STICKS if one.model.sticks(float(F_0[i, 0])) else Status.OK)
            at = proofs.states(one.model, float(F_0[i, 0]), float(Omega[j]))
            assert (states.proved[i, j], states.count[i, j], states.bits[i, j]) == (at.proved, len(at.A), at.bits)
        assert (folds.bits == DOUBLES).all()
    assert (Isolator.many(**numbers).certify(-1.0).status == Status.INVALID).all()
    assert (Isolator.many(**numbers).certify(0.04, Omega=np.array([0.0, np.inf])).status == Status.INVALID).all()


def test_batch_says_what_balls_prove_of_undecided_folds():
    """At F_SN, to an ulp of it, and where F_0 exceeds 4 mu/pi by a rounding: a single answer has it proved."""
    iso = Duffing(1.0, 2.0, mu=0.01, zeta=0.02)
    F_SN, m = iso.saddle_node_onset().F_SN, iso.sticking_forcing
    F_0 = np.array([np.nextafter(F_SN, side) for side in (0, 1)] + [np.nextafter(m, side) for side in (0, 1)])
    many = batch(Duffing, (1.0, 2.0, 0.01, 0.02))
    assert not many.ask(PROVED_FOLDS, 1, F_0)[1].all()
    found = many.certify(F_0)
    assert found.proved.all()
    assert (found.bits > DOUBLES).any()
    sticks = found.status == Status.STICKS
    exactly = [0 if stuck else len(exact(iso).folds(F)) for F, stuck in zip(F_0, sticks, strict=True)]
    assert found.count.tolist() == exactly
    with mpmath.workdps(40):
        assert sticks.tolist() == [mpmath.mpf(F) <= 4 * mpmath.mpf(0.01) / mpmath.pi for F in F_0]


def test_a_batch_without_flint_is_that_of_doubles(monkeypatch):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    iso = Duffing(1.0, 2.0, mu=0.01, zeta=0.02)
    found = batch(Duffing, (1.0, 2.0, 0.01, 0.02)).certify([np.nextafter(iso.saddle_node_onset().F_SN, 1)])
    assert (found.proved, found.bits) == (0, DOUBLES)


@pytest.mark.parametrize("delta_h", [1e-85, 1e-200, 5e-324])
def test_onset_on_a_tiny_jump_is_refused_without_flint(delta_h, monkeypatch):
    """The force jumps at u_cr by some r u_cr^7: it was 0 in doubles, and "no saddle node" was said."""
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    design = {"lam": 2.0, "r": 3.43e-83, "delta_h": delta_h, "mu": 1e-12, "zeta": 0.02}
    iso, many = Isolator(**design), Isolator.many(**design).saddle_node_onset()
    with pytest.raises(ArithmeticError, match="the onset is unresolved"):
        iso.saddle_node_onset()
    assert many.status == Status.UNRESOLVED and np.isnan(many.F_SN)


@pytest.mark.slow
@pytest.mark.parametrize("delta_h", [1e-85, 5e-324])
def test_balls_give_the_onset_on_a_tiny_jump(delta_h):
    """There it jumps up, and folds are born where R = 0, from F_0 = I on (24); single and in a batch."""
    pytest.importorskip("flint")
    design = {"lam": 2.0, "r": 3.43e-83, "delta_h": delta_h, "mu": 1e-12, "zeta": 0.02}
    found, many = Isolator(**design).saddle_node_onset(), Isolator.many(**design).saddle_node_onset()
    u_cr = float(mpmath.sqrt(2 * mpmath.mpf(delta_h)))
    assert found.kind == "corner" and [found.Omega, found.A] == pytest.approx([1.0, u_cr], rel=1e-15, abs=0)
    assert found.F_SN == pytest.approx(4e-12 / math.pi, rel=1e-15, abs=0)
    assert found.remarks == Remark.BY_BALLS | Remark.OF_TRUNCATION and many.remarks == int(found.remarks)
    assert [many.F_SN, many.Omega, many.A] == [found.F_SN, found.Omega, found.A] and many.status == Status.OK


@pytest.mark.slow
@pytest.mark.parametrize("mu", [0.0, 1e-3])
def test_an_onset_by_balls_says_that_lower_folds_end_at_rest(mu):
    """Of a softening spring they do where h vanishes at Omega = 0, from the level of friction on."""
    pytest.importorskip("flint")
    iso = Duffing(678.8564034128265, -0.0005845965970001937, mu=mu, zeta=1e-6)
    found = proofs.decided_onset(iso.model, proofs.Allowance())
    assert Remark.FOLDS_AT_REST in found.remarks and f"from F_0 = {4 * mu / math.pi:g} on" in found.message
    in_doubles = solvers.onset(iso.model)
    assert [found.F_SN, found.Omega, found.A] == pytest.approx(
        [in_doubles.F_SN, in_doubles.Omega, in_doubles.A], rel=1e-12
    )


@pytest.mark.parametrize("zeta", [1e-6, 1e-7, 1.3e-8, 1e-10])
def test_folds_at_rest_do_not_depend_on_earlier_questions(zeta):
    """Where a softening spring's h is 0 away from the centre: rounding hid them, and below F_SN none were reported."""
    numbers = {"alpha": 678.8564034128265, "beta": -0.0005845965970001937, "mu": 0.0, "zeta": zeta}
    fresh, used = Duffing(**numbers), Duffing(**numbers)
    onset, many = used.saddle_node_onset(), Duffing.many(**numbers).saddle_node_onset()
    assert Remark.FOLDS_AT_REST in onset.remarks and many.remarks == int(onset.remarks)
    F_0 = 0.2 * onset.F_SN
    # the static equilibria: alpha A + 3/4 beta A^3 = F_0 next to h = 0, two of them, meet in one fold
    assert len(fresh.saddle_nodes(F_0)) == len(used.saddle_nodes(F_0)) == 1
    assert fresh.saddle_nodes(F_0).A == pytest.approx(math.sqrt(-numbers["alpha"] / (0.75 * numbers["beta"])), rel=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("lam", "r", "delta_h", "mu", "zeta", "F_0"),
    [
        (
            *(2.429109917792496, 0.011053847616397007, 3.5335601879105854e-10),
            9.954520715652437e-39,
            2.4243479850013053e-11,
            1.2889800556245529e-15,
        ),
        (
            *(0.11251792784845768, 0.05504602459316973, 9.701667031832272e-09),
            2.0822771943681876e-59,
            3.864625161106583e-11,
            1.0766524974392935e-14,
        ),
        (3.0, 2.0, 0.1, 0.01, 0.02, 0.0),
    ],
)
def test_folds_at_the_onset_are_there_whatever_was_asked_before(lam, r, delta_h, mu, zeta, F_0):
    """F_SN, off by 3e-12 where damping is weak, is rounded: below it folds were denied once the onset was known."""
    pytest.importorskip("flint")
    fresh, used = (Isolator(lam=lam, r=r, delta_h=delta_h, mu=mu, zeta=zeta) for _ in range(2))
    F_SN = used.saddle_node_onset().F_SN
    low, high = fresh.certify(F_0 or F_SN).saddle_node_onset.F_0
    assert low * (1 - 4e-16) <= F_SN <= high * (1 + 4e-16)
    for F in (F_0 or F_SN, F_SN, math.nextafter(F_SN, 0), math.nextafter(F_SN, 1), F_SN * (1 - 1e-15)):
        assert used.saddle_nodes(F) == fresh.saddle_nodes(F)
        proof = fresh.certify(F).saddle_nodes
        assert not proof.proved or len(proof.A) == len(used.saddle_nodes(F))


def test_quadratic_damping_alone_has_folds_that_end_at_rest():
    numbers = {"alpha": 2.1, "beta": -0.7, "gamma": 0.0, "zeta": 0.0, "mu": 0.0, "c_2": 0.1}
    fresh, used = (Oscillator(duffing.MECHANISM, **numbers) for _ in range(2))
    onset = used.saddle_node_onset()
    assert Remark.FOLDS_AT_REST in onset.remarks and "from F_0 = 0 on" in onset.message
    assert len(fresh.saddle_nodes(0.2 * onset.F_SN)) == len(used.saddle_nodes(0.2 * onset.F_SN)) == 1
