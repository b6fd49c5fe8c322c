"""Every question about many designs is answered of each as it is of that design alone, with the same remarks."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

from slowflow import Duffing, Isolator
from slowflow_kernels.conventions import FoldKind, OnsetKind, Status
from slowflow_support.errors import Refused, SlowflowError
from tests.batch_questions import ALL, ask, columns

# on NumPy a batch is single answers, in seconds each

#: of an answer's status: there is one, also where it has no number
ANSWERED = (Status.OK, Status.NONE, Status.UNBOUNDED)
#: designs of each kind, few enough to be asked alone
COUNT = 12


def isolators(draw, count):
    """Paper's ones and stiffer, softer, undamped, sticking and rubbing ones, quasi-zero and negative stiffness."""
    lam, delta_h = draw.integers(1, 5, count).astype(float), draw.uniform(0.01, 0.5, count)
    slack = np.where(draw.random(count) < 0.25, draw.uniform(1.0, 1.4, count), draw.uniform(0.02, 1.0, count))
    mu = draw.uniform(0, 0.04, count) * (draw.random(count) < 0.7)
    zeta = 10.0 ** draw.uniform(-2.5, -0.3, count)
    return {"lam": lam, "r": slack / (lam * delta_h), "delta_h": delta_h, "mu": mu, "zeta": zeta}


def duffings(draw, count):
    alpha, beta = draw.uniform(-0.5, 2, count), draw.uniform(-1, 3, count)
    return {"alpha": alpha, "beta": beta, "mu": draw.uniform(0, 0.02, count), "zeta": draw.uniform(0.005, 0.3, count)}


KINDS = {
    "isolators": (Isolator, isolators, {}),
    "isolators without viscous damping": (Isolator, isolators, {"zeta": 0.0}),
    "isolators on a base": (Isolator, isolators, {"excitation": "base"}),
    "untruncated isolators": (Isolator, isolators, {"force": "untruncated"}),
    "Duffing's": (Duffing, duffings, {}),
    "Duffing's with an unbalance": (Duffing, duffings, {"excitation": "unbalance"}),
}


def drawn(kind, seed=7):
    """Designs of a kind as arrays, what they have in common, and a forcing of each."""
    make, draw, same = KINDS[kind]
    generator = np.random.default_rng(seed)
    given = {name: value for name, value in draw(generator, COUNT).items() if name not in same}
    return make, given, same, 10.0 ** generator.uniform(-2, 0, COUNT)


def of_single(answer, name, question):
    """A number or an array of a single answer as the batch has it, None for what it has not."""
    if question == "certify":
        answer = answer.saddle_nodes
    value = getattr(answer, name, None)
    if name == ("points" if question.endswith("frequency_response") else "count"):
        return len(answer.A if question == "certify" else answer)
    if name == "isola":
        return np.asarray(value)[answer.branch]
    if name == "kind" and question.endswith("saddle_nodes"):
        corners = answer.corner if hasattr(answer, "corner") else np.zeros(len(value), bool)
        told = zip(value, corners, strict=True)
        return np.array([FoldKind[kind.upper().replace("-", "_") + "_AT_CORNER" * int(at)] for kind, at in told])
    if name == "kind":
        return OnsetKind[value.upper() or "NO"]
    return value


def assert_is_that_of_each(found, singles, question):
    """Columns, and remarks, where single answers have the like; where these are refused there is a status."""
    told = columns(found)
    for k, single in enumerate(singles):
        status = np.atleast_1d(found.status[k])
        if isinstance(single, Exception):
            assert not np.isin(status, ANSWERED).any(), (k, single)
            continue
        sticks = (status == Status.STICKS).all()
        assert np.isin(status, (*ANSWERED, Status.STICKS)).all(), (k, status)
        said = getattr(single, "_remarks", getattr(single, "remarks", None))
        # the second approximation has them in words
        if said is not None and "." not in question:
            np.testing.assert_array_equal(found.remarks[k], said, err_msg=f"{question} {k}: remarks")
        for name, column in told.items():
            value = of_single(single, name, question)
            if value is None or name == "status" or sticks:
                continue
            value, here = np.asarray(value, dtype=float), np.asarray(column[k], dtype=float)
            if here.ndim < value.ndim:  # of one pulse
                (value,) = value
            size = value.shape[0] if value.ndim else None
            if size is not None and here.shape[0] > size:
                assert np.isnan(here[size:]).all() or not here[size:].any() or (here[size:] == -1).all(), (k, name)
                here = here[:size]
            np.testing.assert_allclose(here, value, rtol=1e-9, atol=1e-12, err_msg=f"{question} {k}: {name}")


def asked_alone(make, given, same, F_0, question):
    for k in range(F_0.size):
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", message=".*negative stiffness at rest")
            one = make(**{name: float(value[k]) for name, value in given.items()}, **same)
        try:
            yield ask(one, question, float(F_0[k]))
        except SlowflowError as refusal:
            yield refusal


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("question", ALL)
def test_many_are_answered_as_each_alone(question, kind):
    make, given, same, F_0 = drawn(kind)
    try:
        found = ask(make.many(**given, **same), question, F_0)
    except Refused as refusal:  # of all of them, as proofs by inertia
        assert all(isinstance(one, ValueError) for one in asked_alone(make, given, same, F_0, question)), refusal
        return
    assert_is_that_of_each(found, asked_alone(make, given, same, F_0, question), question)


@pytest.mark.slow
@pytest.mark.parametrize("make", [Isolator, Duffing])
def test_folds_of_many_have_every_bit_of_single_ones(make):
    """Also next to where damping is so weak, or F_0 so small, that a block leaves them to the search of one design."""
    draw, n = np.random.default_rng(31), 1500
    given = isolators(draw, n) if make is Isolator else duffings(draw, n)
    given["zeta"] = 10.0 ** draw.uniform(-5, 0, n)
    F_0 = 4 / np.pi * given["mu"] * (1 + 10.0 ** draw.uniform(-4, 1, n)) + 10.0 ** draw.uniform(-5, 0, n)
    found = make.many(**given).saddle_nodes(F_0)
    for k in range(n):
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", message=".*negative stiffness at rest")
            one = make(**{name: float(value[k]) for name, value in given.items()}).saddle_nodes(float(F_0[k]))
        told = zip(one.kind, one.corner, strict=True)
        kinds = [FoldKind[kind.upper().replace("-", "_") + "_AT_CORNER" * int(at)] for kind, at in told]
        assert found.count[k] == len(one), k
        np.testing.assert_array_equal(found.Omega[k, : len(one)], one.Omega)
        np.testing.assert_array_equal(found.A[k, : len(one)], one.A)
        assert found.kind[k, : len(one)].tolist() == kinds
    assert np.all(np.bincount(found.count)[[0, 2]] > 100)
