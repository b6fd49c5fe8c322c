"""On NumPy designs of one kind are answered abreast: each of them as it is answered alone, to the last bit."""

from __future__ import annotations

import dataclasses
import tracemalloc

import numpy as np
import pytest

from slowflow import derive
from slowflow.averaged import many
from slowflow.averaged.asked import PEAK, SADDLE_NODES
from slowflow.averaged.many import Designs
from slowflow.averaged.reference import search
from slowflow_kernels import duffing, rod_spring, rod_spring_untruncated
from slowflow_kernels.conventions import Status
from tests.oracles import draws

pytestmark = pytest.mark.both_backends

#: of each kind
COUNT = 120


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
QUESTIONS = {"folds": SADDLE_NODES, "peaks": PEAK}


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


def assert_as_each_alone(designs, question, *asked):
    """The columns."""
    together = designs.ask(question, 1, *asked)
    alone = designs.ask(dataclasses.replace(question, abreast=None), 1, *asked)
    for one, other in zip(together, alone, strict=True):
        np.testing.assert_array_equal(one, other)
        assert one.tobytes() == other.tobytes()
    return together


@pytest.mark.parametrize("question", QUESTIONS)
@pytest.mark.parametrize("kind", KINDS)
def test_designs_abreast_are_answered_as_each_alone(kind, question):
    """Of several scenes, in groups that are cut, beside designs that go alone or are none."""
    designs, F_0 = drawn(kind)
    *_, status = assert_as_each_alone(designs, QUESTIONS[question], F_0, 12)
    assert (status == Status.OK).mean() > 0.5 and status[7] == Status.INVALID


@pytest.mark.parametrize("kind", KINDS)
def test_how_many_go_together_changes_no_digit(kind, monkeypatch):
    designs, F_0 = drawn(kind)
    whole = designs.ask(SADDLE_NODES, 1, F_0, 12)
    monkeypatch.setattr(many, "ABREAST", 7)
    monkeypatch.setattr(many, "AT_ONCE", 50)
    for one, other in zip(whole, designs.ask(SADDLE_NODES, 1, F_0, 12), strict=True):
        assert one.tobytes() == other.tobytes()


def test_folds_beyond_the_places_are_counted():
    designs, F_0 = drawn("isolators")
    *_, count, _, status = assert_as_each_alone(designs, SADDLE_NODES, F_0, 1)
    assert ((status == Status.TOO_MANY) == (count > 1)).all() and (count > 1).any()


@pytest.mark.parametrize("question", QUESTIONS)
def test_a_design_that_nothing_bounds_or_whose_search_is_given_up_spoils_no_other(question, monkeypatch):
    """Powers of the second one's numbers leave the range of doubles; few intervals may be looked at of each."""
    alpha, beta, zeta, F_0 = 5.606793145963986e-165, 8.671754066100369e-116, 6.603238163424822e-186, 1.6766505645178e122
    given = {
        "alpha": [1.0, alpha, 0.1, -0.5],
        "beta": [0.1, beta, 1.0, 1.0],
        "mu": 0.0,
        "zeta": [0.02, zeta, 0.01, 0.003],
    }
    designs, forcing = Designs(on_numpy(duffing.MECHANISM), given), np.array([0.1, F_0, 0.02, 0.05])
    *_, status = assert_as_each_alone(designs, QUESTIONS[question], forcing, 6)
    assert status.tolist() == [Status.OK, Status.NO_BOUND, Status.OK, Status.OK]
    designs, forcing = drawn("isolators")
    looked_at = designs.ask(QUESTIONS[question], 1, forcing, 12)[-1]
    monkeypatch.setattr(search, "MOST_CELLS", 100)
    *_, status = assert_as_each_alone(designs, QUESTIONS[question], forcing, 12)
    given_up = (looked_at == Status.OK) & (status == Status.UNRESOLVED)
    assert given_up.any() and (status == Status.OK).any()


def test_memory_does_not_grow_with_the_number_of_designs():
    def peak_of(count):
        designs, F_0 = drawn("Duffing's", count)
        tracemalloc.start()
        designs.ask(SADDLE_NODES, 1, F_0, 6)
        _, most = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        return most

    few = peak_of(many.AT_ONCE)
    assert peak_of(4 * many.AT_ONCE) < 1.5 * few
