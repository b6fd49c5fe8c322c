"""On NumPy designs of one kind are answered abreast: each of them as it is answered alone, to the last bit."""

from __future__ import annotations

import dataclasses
import tracemalloc

import numpy as np
import pytest

from slowflow import Oscillator, derive
from slowflow.averaged import many
from slowflow.averaged.asked import AMPLITUDES, ONSET, PEAK, SADDLE_NODES
from slowflow.averaged.many import Designs
from slowflow.averaged.proofs import Allowance
from slowflow.averaged.questions import Averaged
from slowflow.averaged.reference import search
from slowflow.results import Remark
from slowflow_kernels import duffing, rod_spring, rod_spring_untruncated
from slowflow_kernels.conventions import Status
from tests.oracles import draws

pytestmark = pytest.mark.both_backends

#: of each kind
COUNT = 80


def on_numpy(record):
    """The same force by a record that is not the generated one: the compiled solvers have none of it."""
    return dataclasses.replace(record, title=f"{record.title} on NumPy")


def isolators(rng, count):
    return dict(zip(("lam", "r", "delta_h", "mu", "zeta"), draws.drawn_isolators(rng, count), strict=True))


def springs(rng, count):
    return dict(zip(("alpha", "beta", "mu", "zeta"), draws.drawn_springs(rng, count), strict=True))


def stops(rng, count):
    mu, zeta = (
        np.where(rng.random(count) < 0.3, 0.0, 10 ** rng.uniform(-5, -1, count)),
        10 ** rng.uniform(-5, -0.3, count),
    )
    return {"kappa": 10 ** rng.uniform(-2, 2, count), "delta": 10 ** rng.uniform(-3, 0, count), "mu": mu, "zeta": zeta}


KINDS = {
    "isolators": (lambda: on_numpy(rod_spring.MECHANISM), isolators),
    "untruncated isolators": (lambda: on_numpy(rod_spring_untruncated.MECHANISM), isolators),
    "Duffing's": (lambda: on_numpy(duffing.MECHANISM), springs),
    "elastic stops": (lambda: derive.library("elastic_stop").record, stops),
}
#: with what is asked beside designs, from forcings
QUESTIONS = {
    "folds": (SADDLE_NODES, lambda F_0: {"F_0": F_0, "places": 12}),
    "states": (AMPLITUDES, lambda F_0: {"F_0": F_0, "Omega": np.linspace(0.2, 2.0, F_0.size), "places": 5}),
    "peaks": (PEAK, lambda F_0: {"F_0": F_0}),
    "onsets": (ONSET, lambda F_0: {}),
}


def drawn(kind, count=COUNT, seed=3):
    """Designs of all scenes, some of them linear or none, and forcings: next to sticking, to F_cr, and anywhere."""
    record, draw = KINDS[kind]
    rng = np.random.default_rng(seed)
    values = draw(rng, count)
    values["zeta"] = np.where(rng.random(count) < 0.15, 0.0, values["zeta"])
    for name in values.keys() & {"delta_h", "beta"}:
        values[name][5] = 0.0
    values["mu"][7] = -1.0
    designs = Designs(record(), values)
    stuck = 4 / np.pi * np.maximum(values["mu"], 0.0)
    F_0 = stuck * (1 + 10 ** rng.uniform(-16, 2, count)) + np.where(
        rng.random(count) < 0.3, 0.0, 10 ** rng.uniform(-4, 1, count)
    )
    F_0 = np.where(F_0 > 0, F_0, 0.1)
    F_cr = designs.detachment().F_cr
    beside = F_cr * (1 + rng.choice([-1, 1], count) * 10 ** rng.uniform(-16.3, -1, count))
    return designs, np.where((rng.random(count) < 0.3) & (beside > stuck), beside, F_0)


def assert_as_each_alone(designs, question, asked):
    """The columns."""
    together = designs.ask(question, 1, **asked)
    alone = designs.ask(dataclasses.replace(question, abreast=None), 1, **asked)
    for one, other in zip(together, alone, strict=True):
        np.testing.assert_array_equal(one, other)
        assert one.tobytes() == other.tobytes()
    return together


@pytest.mark.slow
@pytest.mark.parametrize("question", QUESTIONS)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.part(4)
def test_designs_abreast_are_answered_as_each_alone(kind, question):
    """Of several scenes, in groups that are cut, beside designs that go alone or are none."""
    designs, F_0 = drawn(kind)
    asked, beside = QUESTIONS[question]
    *_, status = assert_as_each_alone(designs, asked, beside(F_0))
    assert (status == Status.OK).mean() > 0.3 and status[7] == Status.INVALID


@pytest.mark.slow
@pytest.mark.parametrize("question", QUESTIONS)
def test_how_many_go_together_changes_no_digit(question, monkeypatch):
    designs, F_0 = drawn("isolators")
    asked, beside = QUESTIONS[question]
    whole = designs.ask(asked, 1, **beside(F_0))
    monkeypatch.setattr(many, "ABREAST", 7)
    monkeypatch.setattr(many, "AT_ONCE", 50)
    for one, other in zip(whole, designs.ask(asked, 1, **beside(F_0)), strict=True):
        assert one.tobytes() == other.tobytes()


@pytest.mark.slow
def test_folds_beyond_the_places_are_counted():
    designs, F_0 = drawn("isolators")
    *_, count, _, status = assert_as_each_alone(designs, SADDLE_NODES, {"F_0": F_0, "places": 1})
    assert ((status == Status.TOO_MANY) == (count > 1)).all() and (count > 1).any()


def test_more_folds_than_a_batch_counts_are_no_answer():
    """Next to F_SN, where the force softens: rounding makes 140 of them, which the single answer says."""
    r, delta_h, mu, zeta = 0.032690746817792105, 0.8618186751864456, 1.2876267050203011e-05, 0.0017769850062564225
    given = {"lam": [4.0, 3.0], "r": [r, 1.0], "delta_h": [delta_h, 0.1], "mu": [mu, 0.0], "zeta": [zeta, 0.02]}
    designs, F_0 = Designs(on_numpy(rod_spring_untruncated.MECHANISM), given), np.array([0.0022647785409106095, 0.05])
    first = Averaged(designs.model({name: value[0] for name, value in given.items()} | {"zeta": zeta}))
    alone = first.folds(F_0[0], allowance=Allowance(0))
    assert len(alone) > 127 and Remark.UNDECIDED in alone.remarks
    *_, count, _, status = assert_as_each_alone(designs, SADDLE_NODES, {"F_0": F_0, "places": 3})
    assert (status[0], count[0]) == (Status.UNRESOLVED, 0) and status[1] == Status.OK


@pytest.mark.parametrize("question", ["folds", "states", "peaks"])
def test_a_design_that_nothing_bounds_spoils_no_other(question):
    """Powers of the second one's numbers leave the range of doubles."""
    given = {
        "alpha": [1.0, 5.606793145963986e-165, 0.1, -0.5],
        "beta": [0.1, 8.671754066100369e-116, 1.0, 1.0],
        "mu": 0.0,
        "zeta": [0.02, 6.603238163424822e-186, 0.01, 0.003],
    }
    designs, F_0 = Designs(on_numpy(duffing.MECHANISM), given), np.array([0.1, 1.6766505645178e122, 0.02, 0.05])
    asked, beside = QUESTIONS[question]
    *_, status = assert_as_each_alone(designs, asked, beside(F_0))
    assert status.tolist() == [Status.OK, Status.NO_BOUND, Status.OK, Status.OK]


@pytest.mark.slow
@pytest.mark.parametrize("question", QUESTIONS)
def test_a_design_whose_search_is_given_up_spoils_no_other(question, monkeypatch):
    """Where few intervals may be looked at of each."""
    designs, F_0 = drawn("isolators")
    asked, beside = QUESTIONS[question]
    *_, before = designs.ask(asked, 1, **beside(F_0))
    monkeypatch.setattr(search, "MOST_CELLS", 100)
    *_, status = assert_as_each_alone(designs, asked, beside(F_0))
    given_up = (before == Status.OK) & (status == Status.UNRESOLVED)
    assert given_up.any() and (status == Status.OK).any()


@pytest.mark.parametrize("question", ["detachment", "saddle_node_onset", "saddle_nodes", "amplitudes", "peak"])
def test_the_second_approximation_does_not_answer_as_averaging(question):
    """Its questions are averaging's but for what answers them."""
    record, values = on_numpy(duffing.MECHANISM), {"alpha": [0.0, 0.5], "beta": 1.0, "mu": 0.0, "zeta": 0.02}
    designs = Oscillator.many(record, **values)
    beside = {"saddle_nodes": (0.3,), "amplitudes": (), "peak": (0.3,)}.get(question, ())
    named = {"Omega": 1.0, "F_0": 0.3} if question == "amplitudes" else {}
    found = getattr(designs.second_approximation, question)(*beside, **named)
    for k in range(2):
        one = Oscillator(record, alpha=values["alpha"][k], beta=1.0, mu=0.0, zeta=0.02)
        single = getattr(one.second_approximation, question)(*beside, **named)
        for name in {"A", "Omega"} & found._content().keys():
            alone = np.atleast_1d(np.asarray(getattr(single, name), dtype=float))
            column = np.atleast_1d(getattr(found, name)[k])
            np.testing.assert_array_equal(column[: alone.size], alone)


@pytest.mark.slow
def test_memory_does_not_grow_with_the_number_of_designs():
    def peak_of(count):
        designs, F_0 = drawn("Duffing's", count)
        tracemalloc.start()
        designs.ask(SADDLE_NODES, 1, F_0, places=6)
        _, most = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        return most

    few = peak_of(many.AT_ONCE)
    assert peak_of(4 * many.AT_ONCE) < 1.5 * few
