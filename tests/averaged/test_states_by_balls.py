"""Numbers of states that doubles leave undecided: as balls prove them, in single answers and in batches alike."""

from __future__ import annotations

import importlib.util
import math

import numpy as np
import pytest

from slowflow import Duffing, Isolator
from slowflow.answers.results import Remark
from slowflow.averaged import proofs, solvers
from slowflow.averaged.many import AMPLITUDES
from slowflow_kernels.conventions import Status
from tests.files import stored
from tests.oracles import averaged, counts
from tests.sampling import slow

flint = pytest.mark.skipif(importlib.util.find_spec("flint") is None, reason="balls are of python-flint")


def exact(one):
    kind = averaged.Duffing if isinstance(one, Duffing) else averaged.RodSpring
    names = (domain.name for domain in one.model.mechanism.design)
    return kind(**dict(zip(names, one.model.design, strict=True)), mu=one.mu, zeta=one.zeta)


def batch(one):
    names = (domain.name for domain in one.model.mechanism.design)
    return type(one).many(**dict(zip(names, one.model.design, strict=True)), mu=one.mu, zeta=one.zeta)


#: h = 0 at A = 263.85 by steps of 5e-13 from double to double, 1e5 times sqrt(F_0^2 - m^2): a whole isola lies between
#: two doubles, up to Omega = 1.27308305173502e-19, and was missing without a word
BETWEEN_DOUBLES = {"alpha": -5.967114315434874, "beta": 1.142814496402943e-4, "mu": 3.1874244168978207e-12}
BETWEEN_DOUBLES["zeta"] = 0.29001258439922
F_BETWEEN, TIP = 4.0583742969611374e-12, 1.27308305173502e-19


@flint
@pytest.mark.parametrize("ratio", [1e-6, 0.5, 1 - 5.4e-11])
def test_states_of_an_isola_between_two_doubles_are_found(ratio):
    one, Omega = Duffing(**BETWEEN_DOUBLES), ratio * TIP
    assert counts.States(exact(one), Omega).count(F_BETWEEN) == 3
    found = one.amplitudes(Omega=[Omega, 2 * TIP], F_0=F_BETWEEN)
    assert found.Omega.tolist() == [Omega] * 3 + [2 * TIP]
    h_is_0 = math.sqrt(-4 * one.alpha / (3 * one.beta))
    assert found.A[1:3].tolist() == pytest.approx([h_is_0] * 2, rel=1e-15)
    assert found.stable.tolist()[1:3] == [False, True]
    assert Remark.BY_BALLS in found.remarks and Remark.UNDECIDED not in found.remarks
    many = batch(one).amplitudes(Omega=Omega, F_0=F_BETWEEN)
    assert many.count == 3 and many.A[:3].tolist() == found.A[:3].tolist() and not many.undecided


def test_undecided_isola_of_a_curve_is_said():
    one = Duffing(**BETWEEN_DOUBLES)
    assert Remark.UNDECIDED in one.frequency_response(F_BETWEEN, samples=20).remarks
    many = batch(one).frequency_response(F_BETWEEN, samples=20)
    assert many.undecided and int(many.remarks) & Remark.UNDECIDED


@pytest.mark.parametrize("ratio", [1e-6, 0.5, 1 - 5.4e-11])
def test_without_flint_an_isola_between_two_doubles_is_undecided(ratio, monkeypatch):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    one, Omega = Duffing(**BETWEEN_DOUBLES), ratio * TIP
    found, many = (ask.amplitudes(Omega=Omega, F_0=F_BETWEEN) for ask in (one, batch(one)))
    assert found.Omega_undecided.tolist() == [Omega] and "is undecided at Omega" in found.message
    assert many.undecided and many.remarks == int(found.remarks) and Remark.UNDECIDED in found.remarks
    assert Remark.BY_BALLS not in found.remarks


#: an oscillator, and a forcing with folds: next to these doubles do not tell how many states there are
NEAR_FOLDS = {
    "hardening": (Duffing(1.0, 2.0, 0.01, 0.02), 0.04),
    "softening": (Duffing(1.0, -0.3, 0.01, 0.02), 0.08),
    "isolator": (Isolator(lam=3, r=2, delta_h=0.1, mu=0.01, zeta=0.02), 0.04),
}


def beside_folds(one, F_0):
    """Doubles next to the folds' frequencies, out of order, one of them twice."""
    at = [math.nextafter(w, side) for w in one.saddle_nodes(F_0).Omega.tolist() for side in (w, 0, 9)]
    return [*at[::-1], 1.4, at[0], 1.4]


@pytest.mark.slow
@flint
@pytest.mark.parametrize("name", NEAR_FOLDS)
def test_states_next_to_a_fold_are_as_many_as_proved(name):
    one, F_0 = NEAR_FOLDS[name]
    frequencies = beside_folds(one, F_0)
    number = [counts.States(exact(one), w).count(F_0) for w in frequencies]
    assert solvers.states(one.model, np.array(frequencies), F_0).Omega_undecided.size or name == "isolator"
    found, many = one.amplitudes(Omega=frequencies, F_0=F_0), batch(one).amplitudes(Omega=frequencies, F_0=F_0)
    assert found.Omega.tolist() == [w for w, n in zip(frequencies, number, strict=True) for _ in range(n)]
    ends = np.cumsum([0, *number]).tolist()
    singles = [one.amplitudes(Omega=w, F_0=F_0) for w in frequencies]
    for k, (state, low, high) in enumerate(zip(singles, ends, ends[1:], strict=False)):
        assert found.A[low:high].tolist() == state.A.tolist() == many.A[k, : high - low].tolist()
        assert found.stable[low:high].tolist() == state.stable.tolist() == (many.stable[k, : high - low] != 0).tolist()
        assert (np.diff(state.A) >= 0).all() and state.stable.tolist() == [True, False, True][: len(state)]
    assert many.count.tolist() == number and not many.undecided.any()
    assert many.remarks.tolist() == [int(state.remarks) for state in singles]
    assert not found.Omega_undecided.size and Remark.UNDECIDED not in found.remarks
    assert (Remark.BY_BALLS in found.remarks) == ("resolved in ball arithmetic" in found.message)
    pairs = one.amplitudes(Omega=frequencies, F_0=np.full(len(frequencies), F_0))
    assert pairs.A.tolist() == found.A.tolist() and pairs.remarks == found.remarks


@flint
def test_folds_that_balls_decided_say_so_in_batches_too():
    one = Duffing(1.0021174150372412, -0.7852683936675544, 0.03237752605590381, 1e-4)
    F_0 = [0.5048231197593197, 0.2]
    many = batch(one).saddle_nodes(F_0)
    for k, F in enumerate(F_0):
        found = one.saddle_nodes(F)
        assert many.remarks[k] == int(found.remarks)
        assert (Remark.BY_BALLS in found.remarks) == ("resolved in ball arithmetic" in found.message) == (k == 0)


@flint
def test_mass_moved_to_rounding_only_sticks_or_moves():
    one = Duffing(1.0, 0.5, 1e-9, 0.01)
    for F_0 in (math.nextafter(one.sticking_forcing, 1), one.sticking_forcing * (1 + 1e-14)):
        found = one.amplitudes(Omega=[0.62, 0.9], F_0=F_0)
        number = [counts.States(exact(one), w).count(F_0) for w in (0.62, 0.9)]
        assert found.Omega.tolist() == [0.62] * number[0] + [0.9] * number[1]
        assert not found.Omega_undecided.size and ("sticks" in found.message) == (not any(number))


@flint
def test_balls_are_bounded_and_the_rest_is_undecided(monkeypatch):
    one, F_0 = NEAR_FOLDS["hardening"]
    frequencies = sorted(set(beside_folds(one, F_0)[:-1]))
    model = one.model
    open_ = solvers.states(model, np.array(frequencies), F_0).Omega_undecided.tolist()
    monkeypatch.setattr(proofs, "MOST_IN_BALLS", 2)
    monkeypatch.setattr(proofs.Allowance.__init__, "__defaults__", (2,))
    found, many = one.amplitudes(Omega=frequencies, F_0=F_0), batch(one).amplitudes(Omega=frequencies, F_0=F_0)
    assert len(open_) > 2 and found.Omega_undecided.tolist() == open_[2:]
    assert "ball arithmetic was used for 2 points" in found.message
    assert {Remark.BY_BALLS, Remark.UNDECIDED} <= set(found.remarks)
    assert many.undecided.tolist() == [w in open_[2:] for w in frequencies]
    by_balls, undecided = ((many.remarks & remark != 0).tolist() for remark in (Remark.BY_BALLS, Remark.UNDECIDED))
    assert by_balls == [w in open_[:2] for w in frequencies] and undecided == many.undecided.tolist()
    pairs = one.amplitudes(Omega=frequencies, F_0=[[F_0], [F_0 * (1 + 1e-15)]])
    assert set(open_[2:]) <= set(pairs.Omega_undecided.tolist())


@flint
def test_a_batch_asks_balls_once(monkeypatch):
    one, F_0 = NEAR_FOLDS["hardening"]
    frequencies = beside_folds(one, F_0)[:2]
    balls, tried = proofs.ball_questions(), []
    ask = balls.ask
    monkeypatch.setattr(balls, "ask", lambda *arguments: tried.append(arguments) or ask(*arguments))
    batch(one).amplitudes(Omega=frequencies, F_0=F_0)
    columns = batch(one).ask(AMPLITUDES, 1, F_0, 6, Omega=frequencies)
    assert len(tried) == (columns[-2] != 0).sum()
    assert len(tried) > 0


def test_coinciding_branches_are_refused_without_flint(monkeypatch):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    (case,) = (one for one in stored("hard_places") if one["why"].startswith("it was refused: branches coincide"))
    with pytest.raises(ArithmeticError, match="branches coincide"):
        Duffing(**case["numbers"]).amplitudes(**case["given"])
    assert Duffing.many(**case["numbers"]).amplitudes(**case["given"]).status == Status.UNRESOLVED


#: Duffing oscillators and forcings next to levels at which folds are born, of so many as are proved
NEXT_TO_LEVELS = (
    ((0.48142232365018633, 9.788661688263335, 0.0, 1.0564987447954073), 10.365586243652253, 2),
    ((17.403023028802444, -0.0012316003355198357, 5.861465155805233e-10, 1.1195404367675672), 593.8396952349344, 1),
    ((0.11012827209751788, -0.11242638519274138, 0.0, 0.12291587747807577), 0.0402214821341839, 3),
    ((0.37626339128722736, 8.177922744698371, 0.10756759764482636, 1.5532233127001491), 35.19007969500994, 0),
)


@pytest.mark.parametrize(("design", "F_0", "number"), [NEXT_TO_LEVELS[0], *slow(*NEXT_TO_LEVELS[1:])])
def test_curve_is_decided_where_balls_prove_its_folds(design, F_0, number, monkeypatch):
    one = Duffing(*design)
    assert averaged.Duffing(**dict(zip(("alpha", "beta", "mu", "zeta"), design, strict=True))).fold_count(F_0) == number
    decided, many = (ask.frequency_response(F_0, samples=50) for ask in (one, batch(one)))
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    found, in_doubles = (ask.frequency_response(F_0, samples=50) for ask in (one, batch(one)))
    assert Remark.UNDECIDED in found.remarks and in_doubles.undecided
    for single, several in ((found, in_doubles), (decided, many)):
        assert (int(single.remarks), single.A.tolist()) == (several.remarks, several.A[: len(single)].tolist())
    by_balls, folds = Remark.BY_BALLS in decided.remarks, solvers.folds(one.model, F_0)
    assert by_balls == (Remark.UNDECIDED not in decided.remarks) == (not many.undecided)
    assert by_balls  # whose folds have fewer digits
    assert not by_balls or len(folds) == number
    assert decided.A.tolist() == found.A.tolist()


@pytest.mark.slow
def test_a_curve_whose_fold_has_few_digits_says_so():
    """F_0 exceeds 4 mu/pi by two ulps: the fold lies at Omega = 5.93e-17, as balls say, and not at 4.42e-17."""
    one = Duffing(0.0018877757998804665, -135.1962285773889, 1.3170412018428775e-05, 0.017745655026123557)
    curve, many = (ask.frequency_response(1.6769089402318778e-05, samples=20) for ask in (one, batch(one)))
    assert Remark.UNDECIDED in curve.remarks and many.undecided and many.remarks == int(curve.remarks)
