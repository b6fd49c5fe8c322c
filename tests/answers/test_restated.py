"""A force stated in other words has the same answers: in other pieces, by sums, in C, for all u, by numbers alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType, SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pytest
import sympy as sp

from slowflow import Duffing, derive
from tests.answers.test_agreement import snap
from tests.derived.test_forces import FORCES
from tests.sampling import slow

u, k, g, q, d, p, c = sp.symbols("u k g q d p c")
#: of an oscillator at a forcing and frequencies
QUESTIONS: dict[str, Callable[[Any, float, tuple[float, ...]], Any]] = {
    "rest": lambda of, *_: of.rest(),
    "states": lambda of, F_0, Omega: of.amplitudes(Omega=Omega, F_0=F_0),
    "folds": lambda of, F_0, _: of.saddle_nodes(F_0),
    "onset": lambda of, *_: of.saddle_node_onset(),
    "detachment": lambda of, *_: of.detachment(),
    "peak": lambda of, F_0, _: of.peak(F_0),
    "curves": lambda of, F_0, _: SimpleNamespace(isola=of.frequency_response(F_0).isola, message=""),
    "second": lambda of, F_0, _: of.second_approximation.amplitudes(Omega=0.9, F_0=F_0),
    "structural": lambda of, F_0, _: of.replace(eta=0.02).saddle_nodes(F_0),
    "on a base": lambda of, F_0, _: of.replace(excitation="base").amplitudes(Omega=1.1, F_0=F_0),
    "motion": lambda of, F_0, _: of.steady_state(Omega=0.8, F_0=F_0),
}
CENTRED = ("states", "folds", "onset", "detachment", "peak")
FEW, OFFSET = CENTRED[:2], ("rest", *CENTRED)
#: what is compared: numbers, of which a mirror image has the last with the other sign, and names
ALONG_u = ("B", "u")
NUMBERS = ("Omega", "A", "phi", "F_SN", "F_cr", "Omega_cr", "stiffness", "u_max", "Omega_max", *ALONG_u)
NAMES = ("kind", "stable", "corner", "isola")


class Stated(NamedTuple):
    """Pieces, their numbers, damping and load, and how they are derived."""

    pieces: list[Any]
    numbers: dict[str, float]
    damping: dict[str, Any]
    how: Mapping[str, Any] = MappingProxyType({})

    def make(self) -> Any:
        domains = dict.fromkeys(self.numbers, {} if self.how.get("odd") is False else {"above": 0})
        return derive.mechanism("restated", self.pieces, domains, **self.how)(**self.numbers, **self.damping)


class Pair(NamedTuple):
    """Two oscillators of one force, what they are asked, and how near their answers are; gradients to 1e-9."""

    one: Stated
    other: Stated | Callable[[], Any]
    F_0: float = 0.15
    Omega: tuple[float, ...] = (0.7, 1.1)
    near: float = 1e-12
    questions: tuple[str, ...] = CENTRED
    #: messages may name ends and pieces; the second may be the mirror image of the first
    same_messages: bool = True
    mirrored: bool = False


DAMPED, LIGHT, ONE_SIDED = {"mu": 0.005, "zeta": 0.03}, {"mu": 0.01, "zeta": 0.03}, {"odd": False}
STOP, END = {"k": 8.0, "g": 0.2}, sp.Rational(1, 5)
RIGHT, LEFT = (u, g), (u + k * (u + g), -g)


def without_parameters(pieces: Any, *more: Any, **options: Any) -> Pair:
    """Pieces in numbers and the same with parameters: all depths of approximation, if nothing else is asked for."""
    (bare, named, numbers), (damping, how) = pieces, more or (LIGHT, {})
    every = ("states", "folds", "onset", "peak", "second", "structural", "on a base", "motion")
    return Pair(Stated(bare, {}, damping, how), Stated(named, numbers, damping, how), **{"questions": every, **options})


#: pieces in numbers, the same with parameters, and these
CUBIC = [(u + u**3, None)], [(u + k * u**3, None)], {"k": 1.0}
AGAINST_A_STOP = [(u, END), (2 * u - END, None)], [(u, g), (2 * u - g, None)], {"g": 0.2}
PENDULUM = [(sp.sin(u), None)], [(k * sp.sin(u), None)], {"k": 1.0}
CURVED = *([(u, END), (u + factor * sp.sinh(u - END), None)] for factor in (1, k)), {"k": 1.0}
#: a stop on either side, between two, even powers, a jump; and a forcing
POLYNOMIALS = {
    "both": ([(u + k * (u + 2 * g), -2 * g), (u, g), (u + k * (u - g) + p * (u - g) ** 3, None)], 0.08),
    "within": ([(u + k * (u - g), g), (u, None)], 0.06),
    "even": ([(u + p * u**2 / 20 + 0.6 * u**3, None)], 0.12),
    "jump": ([(u, g), (u + p / 1000 + k * (u - g), None)], 0.05),
}


def by_sums(pieces: Any, F_0: float) -> Pair:
    """With a term q exp(u), q = 0: averaged by summation instead of steps."""
    numbers, damping = {"k": 3.0, "p": 15.0, "g": 0.1}, {"mu": 0.004, "zeta": 0.03, "load": 0.01}
    summed = [(force + q * sp.exp(u), end) for force, end in pieces]
    other = Stated(summed, {**numbers, "q": 0.0}, damping, ONE_SIDED)
    return Pair(Stated(pieces, numbers, damping, ONE_SIDED), other, F_0, (0.8, 1.2, 1.5), 1e-9, (*OFFSET, "curves"))


def stops(meets: list[float], springs: list[float]) -> Stated:
    """Springs that the mass meets one after the other."""
    gaps, stiffness = sp.symbols(f"gap_:{len(meets)}"), sp.symbols(f"spring_:{len(meets)}")
    pieces, force = [], u
    for gap, spring in zip(gaps, stiffness, strict=True):
        pieces.append((force, gap))
        force += spring * (u - gap)
    numbers = {str(name): value for name, value in zip((*gaps, *stiffness), (*meets, *springs), strict=True)}
    return Stated([*pieces, (force, None)], numbers, {"mu": 0.01, "zeta": 0.05})


def ended_by(end: Any, value: float) -> Pair:
    """A piece that ends at a power of a parameter, and at a parameter."""
    powers, plain = ([(u, one), (u + sp.tanh(k * (u - one)), None)] for one in (end, g))
    other = Stated(plain, {"g": value, "k": 8.0}, LIGHT)
    return Pair(Stated(powers, {"c": 0.5, "k": 8.0}, LIGHT), other.make, 0.08, near=1e-13)


HARD, LOW = q * (sp.exp((u - g) / d) - 1), 0.3 - 0.4 * k
CUSHION, LOADED = {"q": 0.2, "d": 0.1, "g": 0.1}, {**DAMPED, "load": 0.03}
FIVE = [(2 * (u + 0.7) - LOW, -0.7), (-0.3 - k * (u + 0.3), -0.3), (u, 0.3), (0.3 - k * (u - 0.3), 0.7)]
FIVE.append((LOW + 2 * (u - 0.7), None))
TWO_STOPS = [LEFT, RIGHT, (u + k * (u - g), None)]
SOFT_STOP = (*FORCES["soft_stop"], LIGHT)
#: a cubic spring of which only intervals are known: it was taken for one that has states of any amplitude
WIDE = Stated(
    [(u + k * u**3 + q * sp.tanh(u), None)], {"k": 1.8, "q": 1e-300}, {"mu": 0.05, "zeta": 0.5, "excitation": "base"}
)


def elastic_stop(**load: float) -> Any:
    return derive.library("elastic_stop")(kappa=8.0, delta=0.2, **DAMPED, **load)


PAIRS = {
    "cubic in numbers": without_parameters(CUBIC),
    "cubic in numbers, compiled": without_parameters(CUBIC, LIGHT, {"compile": True}),
    "stop in numbers": without_parameters(AGAINST_A_STOP),
    "stop in numbers, compiled": without_parameters(AGAINST_A_STOP, LIGHT, {"compile": True}),
    "pendulum in numbers": without_parameters(PENDULUM, LIGHT, {"reach": 3.1}),
    "pendulum in numbers, compiled": without_parameters(PENDULUM, LIGHT, {"reach": 3.1, "compile": True}),
    "one-sided in numbers": without_parameters(AGAINST_A_STOP, {"zeta": 0.04}, ONE_SIDED, F_0=0.06, questions=FEW),
    "loaded in numbers": without_parameters(CURVED, {"zeta": 0.02, "load": 0.1}, {}, questions=FEW),
    "one-sided curve in numbers": without_parameters(CURVED, {"zeta": 0.02, "load": 0.1}, ONE_SIDED, questions=FEW),
    "cubic": Pair(Stated([(c * u + k * u**3, None)], {"c": 0.5, "k": 1.0}, LIGHT),
                  lambda: Duffing(0.5, 1.0, **LIGHT), near=4e-15),
    **{f"{name} by sums": by_sums(*POLYNOMIALS[name]) for name in POLYNOMIALS},
    # odd forces stated for all u
    "five pieces": Pair(Stated(FIVE, {"k": 0.5}, {"zeta": 0.05, "load": 0.02}, ONE_SIDED),
                        lambda: snap(load=0.02), 0.12, (0.6, 0.9), 1e-11, CENTRED[:1], same_messages=False),
    "cushions": Pair(Stated([(u - HARD.subs(u, -u), -g), (u, g), (u + HARD, None)], CUSHION, LOADED, ONE_SIDED),
                     Stated([(u, g), (u + HARD, None)], CUSHION, LOADED).make,
                     0.03, (0.9, 1.3, 1.6), 1e-11, ("states", "folds", "detachment"), same_messages=False),
    "two stops": Pair(Stated(TWO_STOPS, STOP, {**DAMPED, "load": 0.05}, ONE_SIDED), lambda: elastic_stop(load=0.05),
                      0.03, (0.7, 1.05, 1.3), 1e-13, OFFSET, same_messages=False),
    "two stops without a load": Pair(Stated(TWO_STOPS, STOP, DAMPED, ONE_SIDED), elastic_stop,
                                     0.03, (1.05,), questions=CENTRED[:1], same_messages=False),
    "mirrored": Pair(Stated([RIGHT, (u + k * (u - g), None)], STOP, {**DAMPED, "load": 0.02}, ONE_SIDED),
                     Stated([LEFT, (u, None)], STOP, {**DAMPED, "load": -0.02}, ONE_SIDED).make,
                     0.03, near=1e-12, mirrored=True),
    "far stops": Pair(stops([0.1, 0.2], [0.5, 0.4]), stops([0.1, 0.2, 53, 54], [0.5, 0.4, 1, 1]).make,
                      0.05, near=1e-13),
    "ended by a square": ended_by((1 - c) ** 2, 0.25),
    "ended by a cube": ended_by(1 / (1 + c) ** 3, 1 / 1.5**3),
    "compiled": Pair(Stated(*SOFT_STOP), Stated(*SOFT_STOP, {"compile": True}), 0.3, near=1e-13),
    "wide": Pair(WIDE, lambda: Duffing(1.0, 1.8, **WIDE.damping), 0.4, questions=("peak",)),
}  # fmt: skip


def number(answer: Any, column: str) -> Any:
    """A column; about the centre the mean is 0, and the largest |u| the amplitude, neither of which is stated."""
    value = getattr(answer, column, None)
    if value is None and column in ("B", "u_max"):
        value = 0.0 if column == "B" else getattr(answer, "A", None)
    return np.array(value, dtype=float)


@pytest.mark.parametrize("name", ["cubic in numbers", *slow(*list(PAIRS)[1:])])
def test_a_force_in_other_words_has_the_same_answers(name: str) -> None:
    pair = PAIRS[name]
    one, other = pair.one.make(), pair.other() if callable(pair.other) else pair.other.make()
    for question in pair.questions:
        found, same = (QUESTIONS[question](of, pair.F_0, pair.Omega) for of in (one, other))
        assert (found.message == same.message or not pair.same_messages) and (question != "folds" or len(same))
        for column in NAMES:
            assert np.array_equal(*(getattr(answer, column, None) for answer in (found, same))), (question, column)
        for column in NUMBERS:
            a, b = (number(answer, column) for answer in (found, same))
            b = -b if pair.mirrored and column in ALONG_u else b
            near = {"rtol": pair.near, "atol": 1e-3 * pair.near}
            np.testing.assert_allclose(a, b, **near, err_msg=f"{question} {column}")
        if question in FEW and isinstance(pair.other, Stated):
            slopes, others, more = found.gradient(), same.gradient(), pair.other.numbers.keys() - pair.one.numbers
            assert slopes.by == tuple(by for by in others.by if by not in more)
            for of, by in ((of, by) for of in slopes.of for by in slopes.by):
                np.testing.assert_allclose(slopes[of, by], others[of, by], rtol=1e-9, atol=1e-14, err_msg=f"{of} {by}")


def test_a_force_without_parameters_is_known_by_its_damping() -> None:
    bare = derive.mechanism("restated", CUBIC[0], {})
    assert repr(bare(**LIGHT)).endswith("mu=0.01, zeta=0.03)") and bare(**LIGHT).replace(zeta=0.03) == bare(**LIGHT)
    singles = [Duffing(1.0, 1.0, mu=0.01, zeta=zeta).saddle_node_onset().F_SN for zeta in (0.03, 0.05)]
    assert bare.many(mu=0.01, zeta=[0.03, 0.05]).saddle_node_onset().F_SN == pytest.approx(singles, rel=1e-14)
