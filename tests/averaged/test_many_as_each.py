"""Every question about many designs is answered of each as it is of that design alone, with the same remarks."""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
import pytest
import sympy as sp

from slowflow import Duffing, Isolator, derive
from slowflow.support.errors import Refused, SlowflowError
from slowflow_kernels.conventions import FoldKind, GradientStatus, OnsetKind, Status
from tests.batch_questions import ALL, OFF_CENTRE, ROWS, ask, columns
from tests.derived import test_sampled
from tests.sampling import fewer, slow

#: of an answer's status: there is one, also where it has no number
ANSWERED = (Status.OK, Status.NONE, Status.UNBOUNDED)
#: frequencies of rows of a load spectrum
OVER = (0.7, 1.2, 0.9, 0.9, 0.6)
#: designs of each kind, few enough to be asked alone; of those that take long
COUNT, FEW = fewer(40, 4), 5


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


def spoilt(draw, count):
    """Isolators: some without viscous damping, some without contact of the springs, some invalid."""
    designs = isolators(draw, count)
    designs["zeta"][:3], designs["delta_h"][3] = 0.0, 0.0
    for k, name in enumerate(("lam", "r", "mu", "zeta")):
        designs[name][4 + k] = -1.0
    designs["zeta"][8] = math.nan
    return designs


def in_blocks(draw, count):
    """Isolators more than a block of C has: next to its ends some that are invalid or never detach, others far out."""
    designs = {"lam": 10 ** draw.uniform(-0.5, 1, count), "delta_h": 10 ** draw.uniform(-6, -0.01, count)}
    designs["r"] = np.minimum(draw.uniform(0.2, 4, count), 0.95 / (designs["lam"] * designs["delta_h"]))
    designs["mu"] = np.where(draw.random(count) < 0.3, 0.0, draw.uniform(0, 0.03, count))
    designs["zeta"] = np.where(draw.random(count) < 0.2, 0.0, draw.uniform(0.004, 0.1, count))
    designs["delta_h"][[0, 63, 130]] = 0.0
    for name, row in (("mu", 1), ("lam", 64), ("zeta", 65), ("r", 131), ("mu", count - 1)):
        designs[name][row] = -1.0
    return designs


def weakly_damped(of):
    """So weakly, and forced so little, that a block leaves some to the search of one design."""

    def drawn(draw, count):
        designs = of(draw, count) | {"zeta": 10.0 ** draw.uniform(-5, 0, count)}
        above = 4 / np.pi * designs["mu"] * (1 + 10.0 ** draw.uniform(-4, 1, count))
        return designs | {"F_0": above + 10.0 ** draw.uniform(-5, 0, count)}

    return drawn


def with_few_digits(draw, count):
    """Isolators at whose onset slopes of Newton's method have few digits: its end depends on its beginning."""
    of = {
        "lam": [34.923373761186475, 8.182419049017573, 49.466564841656314, 618.0433851778122, 1.4649991649637566],
        "r": [0.027837731440404932, 0.012471942009670382, 34.95335225220813, 326.86681061919, 3.0016274311152924],
        "delta_h": [0.35146489, 0.0035537755295502456, 0.0005725779359160874, 4.9005565662e-06, 0.0082176349203449],
        "zeta": [1.792261301048228e-08, 2.845047221993845e-09, 1.2082005373961054e-08, 3.15e-09, 3.859392788880549e-09],
    }
    return {name: np.resize(value, count) * (1 + 1e-3 * draw.uniform(-1, 1, count)) for name, value in of.items()}


def with_laws(draw, count):
    """Every law of damping, some without viscous."""
    designs = duffings(draw, count)
    designs["zeta"] *= draw.random(count) < 0.7
    return designs | {"eta": draw.uniform(0.001, 0.1, count), "c_2": draw.uniform(0, 0.3, count)}


def rubbing(draw, count):
    return isolators(draw, count) | {"eta": draw.uniform(0.001, 0.02, count)}


def loaded(of, most):
    """Designs under loads, the last two without, and one that is none."""

    def drawn(draw, count):
        load = draw.uniform(0.1, 1, count) * draw.choice([-1, 1], count) * most
        load[-3:] = math.nan, 0.0, 0.0
        designs = of(draw, count)
        return {**designs, "mu": 0.5 * designs["mu"], "load": load}

    return drawn


def between_stops(draw, count):
    """Springs that level off, gaps without a spring and free masses; some that all but stick, by a double or less."""
    designs = {"kappa": draw.uniform(0, 2, count) * (draw.random(count) < 0.5), "delta": draw.uniform(0.02, 0.3, count)}
    designs["mu"] = draw.choice([0, 0.01, 0.03], count)
    sticks, by = 4 / np.pi * designs["mu"], draw.random(count)
    F_0 = np.where((by < 0.2) & (sticks > 0), np.nextafter(sticks, 1), 10.0 ** draw.uniform(-2.5, 0.5, count))
    F_0 = np.where((by > 0.8) & (sticks > 0), draw.uniform(0.5, 1, count) * sticks, F_0)
    return designs | {"zeta": 10.0 ** draw.uniform(-2.5, -0.3, count), "F_0": F_0}


def gaps(draw, count):
    designs = between_stops(draw, count)
    return {name: value for name, value in designs.items() if name != "kappa"}


def free(draw, count):
    designs = between_stops(draw, count) | {"alpha": np.zeros(count), "beta": np.zeros(count)}
    return {name: value for name, value in designs.items() if name not in ("kappa", "delta")}


def linear(draw, count):
    return free(draw, count) | {"alpha": draw.uniform(0.5, 2, count)}


def near(numbers, damping=(0.01, 0.03)):
    """Designs of a derived mechanism with about these numbers; the last one is none."""

    def drawn(draw, count):
        designs = {name: value * draw.uniform(0.9, 1.1, count) for name, value in numbers.items()}
        designs[next(iter(numbers))][-1] = -1.0
        return designs | {name: np.full(count, value) for name, value in zip(("mu", "zeta"), damping, strict=True)}

    return drawn


LIBRARY = ("bilinear", "dead_zone", "elastic_stop")
u = sp.Symbol("u")
ABOVE = {"above": 0}


@functools.cache
def derived(name: str) -> Any:
    """A derived mechanism, or one of Python functions."""
    if name in LIBRARY:
        return derive.library(name)
    if name == "sampled stop":
        return test_sampled.mechanism("soft_stop")
    k, c, g, d = sp.symbols("k c g d")
    pieces, compiled = {
        "wave": ([(u + k * sp.sin(c * u), None)], False),
        "soft stop": ([(u, g), (u + c * sp.tanh(k * (u - g)), None)], True),
        "preload": ([(c + u + k * u**3, None)], False),
        "preload in C": ([(c + u + k * u**3, None)], True),
        "sided stop": ([(u, g), (u + k * (u - g), None)], False),
        "cushion": ([(u, g), (u + k * (sp.exp((u - g) / d) - 1), None)], True),
    }[name]
    numbers = sorted({str(s) for piece, _ in pieces for s in piece.free_symbols} - {"u"})
    odd = name not in ("sided stop", "cushion")
    domains = {number: ABOVE if odd or number != "g" else {} for number in numbers}
    return derive.mechanism(name.replace(" ", "_"), pieces, domains, odd=odd, compile=compiled)


class Kind(NamedTuple):
    """Designs: what makes one, or the name of a mechanism that is derived; their numbers; what they have in common."""

    make: Any
    draw: Any
    same: Mapping[str, Any] = MappingProxyType({})
    questions: tuple[str, ...] = ALL
    count: int = COUNT

    @property
    def is_sampled(self) -> bool:
        """Of Python functions, whose derivatives are not known."""
        return self.make == "sampled stop"


#: asked of mechanisms that are derived here
SOME = ("saddle_node_onset", "saddle_nodes", "amplitudes", "peak")
LOADED = (*OFF_CENTRE, "random")
PRELOADED = near({"c": 0.03, "k": 1.2})
DETACHED = ("detachment", "saddle_node_onset")
ON_A_BASE = {"excitation": "base"}
#: of which remarks on cuts, on friction and on what no spring holds are of motions elsewhere than an answer is
AT_LEVELS = (
    *("saddle_nodes", "amplitudes", "frequency_response", "peak"),
    *("margins", "hysteresis", "isolation", "isolation at a level"),
)
KINDS = {
    "isolators": Kind(Isolator, isolators),
    "isolators without viscous damping": Kind(Isolator, isolators, {"zeta": 0.0}),
    "isolators on a base": Kind(Isolator, isolators, {"excitation": "base"}),
    "isolators of which some are none": Kind(Isolator, spoilt),
    "the same with an unbalance": Kind(Isolator, spoilt, {"excitation": "unbalance"}),
    "untruncated isolators": Kind(Isolator, isolators, {"force": "untruncated"}),
    "isolators in blocks": Kind(Isolator, in_blocks, {}, DETACHED, 200),
    "untruncated isolators in blocks": Kind(Isolator, in_blocks, {"force": "untruncated"}, DETACHED, 200),
    "weakly damped isolators": Kind(Isolator, weakly_damped(isolators), {}, ("saddle_nodes",), 1500),
    "weakly damped Duffing's": Kind(Duffing, weakly_damped(duffings), {}, ("saddle_nodes",), 1500),
    "isolators with few digits": Kind(Isolator, with_few_digits, {"mu": 0.0}, DETACHED[1:], 300),
    "rubbing isolators": Kind(Isolator, rubbing, {"contact": "attached"}, ALL, FEW),
    "rubbing isolators on a base": Kind(Isolator, rubbing, {"contact": "attached", "excitation": "base"}, count=FEW),
    "rubbing untruncated isolators": Kind(
        *(Isolator, rubbing, {"contact": "attached", "force": "untruncated"}, ALL, FEW)
    ),
    "Duffing's": Kind(Duffing, duffings),
    "Duffing's with an unbalance": Kind(Duffing, duffings, {"excitation": "unbalance"}),
    "Duffing's with every law": Kind(Duffing, with_laws, count=FEW),
    "Duffing's with every law on a base": Kind(Duffing, with_laws, {"excitation": "base"}, count=FEW),
    "bilinear springs": Kind("bilinear", between_stops, {}, AT_LEVELS),
    "bilinear springs on a base": Kind("bilinear", between_stops, ON_A_BASE, AT_LEVELS),
    "rubbing bilinear springs": Kind("bilinear", between_stops, {"contact": "attached"}, AT_LEVELS),
    "rubbing stops": Kind("elastic_stop", between_stops, {"contact": "attached"}, AT_LEVELS),
    "gaps": Kind("dead_zone", gaps, {}, AT_LEVELS),
    "gaps with an unbalance": Kind("dead_zone", gaps, {"excitation": "unbalance"}, AT_LEVELS),
    "free masses": Kind(Duffing, free, {}, AT_LEVELS),
    "linear springs with quadratic damping": Kind(Duffing, linear, {"c_2": 0.2}, AT_LEVELS),
    "loaded isolators": Kind(Isolator, loaded(isolators, 0.1), {}, LOADED, FEW),
    "loaded isolators on a base": Kind(Isolator, loaded(isolators, 0.1), {"excitation": "base"}, SOME, FEW),
    "loaded Duffing's": Kind(Duffing, loaded(duffings, 0.3), {}, LOADED, FEW),
    "loaded Duffing's with an unbalance": Kind(
        *(Duffing, loaded(duffings, 0.3), {"excitation": "unbalance"}, LOADED, FEW)
    ),
    "loaded Duffing's with every law": Kind(Duffing, loaded(with_laws, 0.3), {}, LOADED, FEW),
    "waves": Kind("wave", near({"k": 0.25, "c": 2.0}), {}, SOME, FEW),
    "soft stops": Kind("soft stop", near({"c": 2.0, "k": 2.0, "g": 0.2}), {}, SOME, FEW),
    "sampled stops": Kind("sampled stop", near({"c": 2.0, "k": 2.0, "gap": 0.2}), {}, SOME, FEW),
    "sampled stops on a base": Kind("sampled stop", near({"c": 1.0, "k": 2.0, "gap": 0.2}), ON_A_BASE, SOME[:2], FEW),
    "preloaded": Kind("preload", PRELOADED, {"excitation": "base"}, SOME, FEW),
    "preloaded in C": Kind("preload in C", PRELOADED, {"eta": 0.02}, SOME, FEW),
    "stops on one side": Kind("sided stop", near({"k": 4.0, "g": 0.2}), {}, SOME, FEW),
    "cushions": Kind("cushion", near({"k": 0.2, "d": 0.1, "g": 0.1}), {}, SOME[1:3], FEW),
}


def drawn(kind, seed=7):
    """Designs of a kind as arrays, their common arguments, and a forcing for each."""
    make, draw, same, _, count = KINDS[kind]
    generator = np.random.default_rng(seed)
    designs = {name: value for name, value in draw(generator, count).items() if name not in same}
    make = derived(make) if isinstance(make, str) else make
    F_0 = 10.0 ** generator.uniform(-2, 0, count)
    return make, designs, same, designs.pop("F_0", F_0)


def of_single(answer, name, question):
    """A single answer's number or array in the batch's form; None if it has none."""
    if question == "certify":
        answer = answer.saddle_nodes
    value = getattr(answer, name, None)
    if name == ("points" if question.endswith("frequency_response") else "count"):
        return len(answer.A if question == "certify" else answer)
    if name == "isola":
        return np.asarray(value)[answer.branch]
    if name == "kind" and question.endswith("saddle_nodes"):
        corners = answer.corner if hasattr(answer, "corner") else np.zeros(len(value), bool)
        codes = [
            kind.upper().replace("-", "_") + "_AT_CORNER" * int(at) for kind, at in zip(value, corners, strict=True)
        ]
        # off the centre a fold may have no stable side
        return np.array([FoldKind.__members__.get(one, FoldKind.EMPTY) for one in codes])
    if name == "kind":
        return OnsetKind[value.upper() or "NO"]
    about_centre = getattr(answer, "load", 0.0) is None and name in ("A", "B", "u_max", "Omega_max")
    if about_centre and name == "B" and answer.A is not None:
        return 0.0 * answer.A
    return math.nan if value is None and hasattr(answer, name) and not about_centre else value


def assert_is_that_of_each(found, singles, question):
    """Assert that columns and remarks are those of the single answers, with a status where these are refused."""
    batch_columns = columns(found)
    for k, single in enumerate(singles):
        status = np.atleast_1d(found.status[k])
        if isinstance(single, Exception):
            assert not np.isin(status, ANSWERED).any(), (k, single)
            continue
        if (status == Status.UNRESOLVED).all():
            assert "undecided" in single.message
            continue
        if (status == Status.TOO_MANY).all():
            assert found.count[k] > found.fold_Omega.shape[-1]
            continue
        assert np.isin(status, (*ANSWERED, Status.STICKS)).all(), (k, status)
        remarks = getattr(single, "_remarks", getattr(single, "remarks", None))
        # the second approximation has them in words
        assert getattr(single, "message", "") or not np.any(remarks), (k, remarks)
        if remarks is not None and "." not in question:
            np.testing.assert_array_equal(found.remarks[k], remarks, err_msg=f"{question} {k}: remarks")
        for name, column in batch_columns.items():
            value = of_single(single, name, question)
            if value is None or name == "status":
                continue
            value, here = np.asarray(value, dtype=float), np.asarray(column[k], dtype=float)
            if here.ndim < value.ndim:  # of one pulse
                (value,) = value
            size = value.shape[0] if value.ndim else None
            if size is not None and here.shape[0] > size:
                assert np.isnan(here[size:]).all() or not here[size:].any() or (here[size:] == -1).all(), (k, name)
                here = here[:size]
            if question == "margins" and np.isnan(value):  # a number that is none, or one beyond all others
                beyond = name.endswith("cr") or found.onset[k] == Status.NONE
                value = np.where(beyond, math.inf, value)
            near = NEAR.get(question, 0.0)
            np.testing.assert_allclose(here, value, rtol=near, err_msg=f"{question} {k}: {name}")


#: what is summed in another order in a batch, or found by another iteration; all others have every bit
NEAR = {
    **dict.fromkeys(("isolation", "isolation at a level"), 1e-10),
    "at_rest": 1e-13,
    **dict.fromkeys(("spectrum", "transient", "transient of a record", "shock_spectrum", "random"), 1e-12),
}


def asked_alone(make, designs, same, F_0, question, **more):
    for k in range(F_0.size):
        try:
            one = make(**{name: float(value[k]) for name, value in designs.items()}, **same)
            yield ask(one, question, float(F_0[k]), **{name: float(value[k]) for name, value in more.items()})
        except SlowflowError as refusal:
            yield refusal


SLOW = pytest.mark.slow


def cases(which, fast=tuple(KINDS)):
    """Kinds and questions; those that take long are not among the fast tests."""
    return [
        pytest.param(kind, question, marks=() if kind in fast and of.count > FEW and of.draw is not spoilt else SLOW)
        for kind, of in KINDS.items()
        for question in of.questions
        if which(question, of)
    ]


FAST = ("isolators", "isolators without viscous damping", "Duffing's with an unbalance")


@pytest.mark.parametrize(("kind", "question"), cases(lambda *_: True, FAST))
def test_many_are_answered_as_each_alone(kind, question):
    make, designs, same, F_0 = drawn(kind)
    try:
        found = ask(make.many(**designs, **same), question, F_0)
    except Refused as refusal:  # of all of them, as proofs by inertia
        assert all(isinstance(one, ValueError) for one in asked_alone(make, designs, same, F_0, question)), refusal
        return
    assert_is_that_of_each(found, asked_alone(make, designs, same, F_0, question), question)
    # further remarks are those of other questions
    if question == "frequency_response":
        folds = make.many(**designs, **same).saddle_nodes(F_0)
        for name, column in zip(("fold_Omega", "fold_A", "fold_kind"), (folds.Omega, folds.A, folds.kind), strict=True):
            here = found.points > 0
            np.testing.assert_array_equal(getattr(found, name)[here], column[here])
    if question == "spectrum":
        states = make.many(**{name: value[:, np.newaxis] for name, value in designs.items()}, **same)
        remarks = states.amplitudes(Omega=np.array(ROWS), F_0=F_0[:, np.newaxis]).remarks
        np.testing.assert_array_equal(found.remarks, remarks)


@pytest.mark.parametrize("kind", ["isolators in blocks", *slow("untruncated isolators in blocks", "Duffing's")])
def test_many_next_to_a_fold_have_the_states_of_each(kind):
    """From where a proof decides."""
    make, designs, same, F_0 = drawn(kind)
    many, draw = make.many(**designs, **same), np.random.default_rng(11)
    fold = many.saddle_nodes(F_0).Omega[:, 0]
    offset = 10 ** draw.uniform(-15, -1, F_0.size) * draw.choice([-1, 1], F_0.size)
    at = {"Omega": np.where(fold > 0, fold * (1 + offset), draw.uniform(0.1, 2, F_0.size))}
    together = many.amplitudes(F_0=F_0, **at)
    assert {1, 3} <= set(together.count)
    assert_is_that_of_each(together, asked_alone(make, designs, same, F_0, "amplitudes", **at), "amplitudes")


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["isolators", "isolators on a base", "loaded Duffing's"])
def test_many_cross_folds_where_each_does(kind):
    make, designs, same, F_0 = drawn(kind)
    ways = np.random.default_rng(3).uniform(0.5, 2, (F_0.size, 5)) * F_0[:, np.newaxis]
    found = make.many(**designs, **same).spectrum(Omega=OVER, F_0=ways)
    for k in range(F_0.size):
        numbers = {name: float(value[k]) for name, value in designs.items()}
        if not any(map(math.isnan, numbers.values())):
            single = make(**numbers, **same).spectrum(Omega=OVER, F_0=ways[k])
            np.testing.assert_array_equal(found.crosses[k], single.crosses)
            np.testing.assert_allclose(found.A[k], single.A, rtol=1e-12)
    assert found.crosses.any()


#: of which some are none
SPOILT = (spoilt, in_blocks)
#: what moves with the numbers of mechanisms that are derived, and of others
OF_DERIVED = ("saddle_nodes", "amplitudes")
MOVING = ("detachment", "saddle_node_onset", *OF_DERIVED, "peak", "isolation", "isolation at a level", "rest")


@pytest.mark.parametrize(
    ("kind", "question"),
    cases(
        lambda question, of: (
            question in (OF_DERIVED if isinstance(of.make, str) else MOVING)
            and not (of.draw in SPOILT or of.is_sampled)
        ),
        ("Duffing's",),
    ),
)
def test_many_have_the_gradient_of_each_alone(kind, question):
    make, designs, same, F_0 = drawn(kind)
    found = ask(make.many(**designs, **same), question, F_0)
    gradient = found.gradient()
    assert gradient.slopes.shape == (*getattr(found, gradient.of[0]).shape, len(gradient.of), len(gradient.by))
    for k, single in enumerate(asked_alone(make, designs, same, F_0, question)):
        if isinstance(single, Exception) or np.isin(found.status[k], (Status.INVALID, Status.UNRESOLVED)).all():
            assert (gradient.status[k] == GradientStatus.NOTHING).all() and np.isnan(gradient.slopes[k]).all()
            continue
        if "load" in designs and (single.load is None or np.all(found.status[k] == Status.STICKS)):
            continue  # about the centre nothing is moved by it, nor is a mass that friction holds
        expected = single.gradient()
        size = expected.status.size if expected.status.ndim else None
        near = 10 * NEAR.get(question, 0.0)
        np.testing.assert_array_equal(
            gradient.status[k, :size] if size is not None else gradient.status[k], expected.status
        )
        for name in expected.of:
            for of_many, of_one, close in (
                (gradient[name], expected[name], near),
                (gradient.condition(name), expected.condition(name), near or 1e-13),
            ):
                here = of_many[k, :size] if size is not None else of_many[k]
                size_of = close * np.max(np.abs(np.nan_to_num(of_one)), initial=0.0) if near else 0.0
                np.testing.assert_allclose(here, of_one, rtol=close, atol=size_of, err_msg=f"{question} {k}: {name}")
        assert size is None or (gradient.status[k, size:] == GradientStatus.NOTHING).all()
