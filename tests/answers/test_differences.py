"""Gradients are what neighbouring answers differ by: of each question, force, law of damping, load and mount."""

from __future__ import annotations

import functools
from types import SimpleNamespace
from typing import Any, NamedTuple

import pytest
import sympy as sp

from slowflow import Duffing, Isolator, derive
from slowflow.example import TABLE_1
from tests.derived.test_forces import FORCES
from tests.files import MOUNT
from tests.oracles.pieces import AVERAGED
from tests.sampling import slow
from tests.slopes import assert_slopes_are_differences

u, k, g, p, q, d = sp.symbols("u k g p q d")
AT_ANY_FORCING = {"onset": "saddle_node_onset", "detachment": "detachment", "rest": "rest"}
AT_A_FORCING = {"folds": "saddle_nodes", "peak": "peak", "isolation": "isolation"}


class System(NamedTuple):
    """What makes it of its numbers, a forcing and a frequency by their names, and questions.

    questions -- names, separated by spaces
    constant  -- those of which no answer has a slope
    """

    make: Any
    numbers: dict[str, float]
    at: dict[str, float]
    questions: str
    constant: str


class Forced(NamedTuple):
    """An oscillator or a mount, with a forcing and a frequency."""

    one: Any
    at: dict[str, float]

    def ask(self, question: str) -> Any:
        (forcing, _), (name, *level) = self.at.values(), question.split(":")
        if name in AT_ANY_FORCING:
            return getattr(self.one, AT_ANY_FORCING[name])()
        if name in AT_A_FORCING:
            return getattr(self.one, AT_A_FORCING[name])(forcing, *map(float, level))
        states = self.one.amplitudes(**self.at)
        if "Omega" in self.at:
            return states
        ratio = 10 ** (states.transmissibility_dB / 20)
        return SimpleNamespace(gradient=states.gradient, A=states.A, phi=states.phi, transmissibility=ratio)


@functools.cache
def mechanism(name: str, *numbers: str) -> Any:
    pieces, how = DERIVED[name]
    return derive.mechanism(name, pieces, {number: {"above": 0} for number in numbers}, **how)


def made(name: str, **numbers: float) -> Any:
    return mechanism(name, *(number for number in numbers if number not in ("mu", "zeta", "load")))(**numbers)


ONE_SIDED, STOPS = {"odd": False}, ("stop", "stop_in_C")
#: pieces by rising u: what differs in all at an end that moves, and jumps there; an odd force whose slope jumps at an
#: end that moves; one that is free up to a gap, then ever stiffer; stops on either side, a stiffer side, even
#: powers, a jump; forces that are averaged by sums
DERIVED: dict[str, tuple[Any, dict[str, Any]]] = {
    "jumping": ([(sp.sinh(u / q) * q, g), (u + p * sp.tanh(u / q) + p, None)], ONE_SIDED),
    "bent": ([(u + k * sp.sinh(u), g), (u + k * sp.sinh(u) + q * (u - g) * sp.exp(u - g), None)], {}),
    "cushion": ([(u, g), (u + q * (sp.exp((u - g) / d) - 1), None)], ONE_SIDED),
    "right": ([(u, g), (u + k * (u - g) + q * (u - g) ** 2, None)], ONE_SIDED),
    "left": ([(u + k * (u + 2 * g), -2 * g), (u, None)], ONE_SIDED),
    "both": ([(u + k * (u + 2 * g), -2 * g), (u, g), (u + k * (u - g) + q * (u - g) ** 3, None)], ONE_SIDED),
    "within": ([(u + k * (u - g), g), (u, None)], ONE_SIDED),
    "even": ([(u + p * u**2 + q * u**3, None)], ONE_SIDED),
    "jump": ([(u, g), (u + p + k * (u - g), None)], ONE_SIDED),
    **{name: (FORCES[name][0], {}) for name in ("soft_stop", "power", "hertz")},
    "letting_go": (AVERAGED["letting_go"], {}),
    **{name: ([(k * u, g), (k * u + q * (u - g), None)], {"compile": name == "stop_in_C"}) for name in STOPS},
}


EVERY, SOME = "states folds onset peak isolation detachment rest", "states folds onset peak detachment"
LAWS = ({"excitation": "base"}, {"excitation": "unbalance", "c_2": 0.02}, {"eta": 0.02}, {"c_2": 0.03, "eta": 0.01})
RELEASED = {"contact": "attached", "force": "untruncated"}
LOOSE = {"lam": 3.0, "r": 0.5, "delta_h": 0.02, "mu": 0.03, "zeta": 0.03}
HARDENING = {"alpha": 1.0, "beta": 2.0, "zeta": 0.01, "eta": 0.01, "zeta_2": 0.5}
LOADED = {"mu": 0.005, "zeta": 0.05, "load": 0.02}
SHEET = {name: value for name, value in MOUNT.items() if name not in ("n", "zeta")}
WITH_LAWS = {"m": 12, "k_v": 2500, "L": 0.08, "c": 8.0, "eta": 0.01, "c_2": 5.0, "c_3": 9.0, "c_xx": 500.0}


def at(F_0: float, Omega: float = 1.0) -> dict[str, float]:
    return {"F_0": F_0, "Omega": Omega}


def system(kind: Any, numbers: Any, at: dict[str, float], questions: str, constant: str = "", **options: Any) -> System:
    """From numbers, some of which are options such as an excitation, and options that stay constant."""
    options |= {name: value for name, value in numbers.items() if isinstance(value, str)}
    kind = functools.partial(made, kind) if isinstance(kind, str) else functools.partial(kind, **options)
    numbers = {name: value for name, value in numbers.items() if name not in options}
    return System(kind, numbers, at, questions, constant)


def loaded(law: dict[str, Any]) -> dict[str, System]:
    """Springs under a load, and isolators, of which some answers take seconds."""
    spring = {"alpha": 1.0, "beta": 1.0, "mu": 0.01, "zeta": 0.03, "load": 0.1, **law}
    return {
        f"loaded spring, {law}": system(Duffing, spring, at(0.1), "onset folds"),
        f"peak of a loaded spring, {law}": system(Duffing, spring, at(0.06), "peak"),
        f"loaded isolator, {law}": system(
            Isolator, {**TABLE_1, "load": 0.1, **law}, at(0.06, 0.8), "states detachment"
        ),
    }


SYSTEMS = {
    "jumping": system("jumping", {"p": 0.1, "q": 0.7, "g": 0.25, **LOADED}, at(0.1, 1.28), EVERY, "onset"),
    "bent": system("bent", {"k": 0.5, "q": 2.0, "g": 0.2, **LOADED, "load": 0.1}, at(0.1, 1.28), EVERY),
    "cushion": system("cushion", {"q": 0.5, "d": 0.3, "g": 0.2, **LOADED}, at(0.1, 1.28), EVERY),
    "cubic": system(Duffing, {"alpha": 1.0, "beta": 0.5, **LOADED, "load": 0.3}, at(0.1, 1.28), EVERY, "detachment"),
    **{
        name: system(name, {**numbers, "mu": 0.004, "zeta": 0.03, "load": 0.0}, at(F_0, 1.2), SOME, constant)
        for name, F_0, numbers, constant in (
            ("right", 0.05, {"k": 5.0, "q": 8.0, "g": 0.1}, ""),
            ("left", 0.05, {"k": 5.0, "g": 0.05}, ""),
            ("both", 0.08, {"k": 3.0, "q": 20.0, "g": 0.1}, ""),
            ("within", 0.06, {"k": 2.0, "g": 0.05}, "folds"),
            ("even", 0.12, {"p": 0.8, "q": 0.6}, "detachment"),
            ("jump", 0.05, {"p": 0.01, "k": 4.0, "g": 0.12}, "onset"),
        )
    },
    **{name: one for law in LAWS for name, one in loaded(law).items()},
    # an onset where only the slope of the force jumps; folds at a jump, and an onset where the folds before it end
    "kink": system(Isolator, {"lam": 3.0, "r": 1.0, "delta_h": 0.1, "mu": 0.005, "zeta": 0.085, "load": -0.04},
                   at(0.11), "onset", force="untruncated"),
    "folds at a jump": system(Isolator, TABLE_1 | {"load": 0.1}, at(0.06), "folds"),
    "untruncated": system(Isolator, TABLE_1 | {"load": 0.01}, at(0.04), "detachment", force="untruncated"),
    "steep": system(Isolator, {"lam": 2.0, "r": 0.6, "delta_h": 0.7, "mu": 0.02, "zeta": 0.05, "load": -0.2}, at(0.15),
                    "detachment", force="untruncated"),
    "released": system(Isolator, LOOSE | {"eta": 0.001, "c_2": 0.02, **RELEASED}, at(0.0502, 1.02), "detachment"),
    # folds on the corner that friction makes, where it ends; an isola's birth
    "on a corner": system(Isolator, LOOSE | {"eta": 5e-4, "c_2": 1e-3, **RELEASED}, at(0.0502, 1.02), "folds onset"),
    "rubbing": system(Isolator, {"lam": 3.0, "r": 2.0, "delta_h": 0.08, "mu": 0.02, "zeta": 0.04}, at(0.0502, 1.02),
                      "folds states", contact="attached"),
    "every law": system(Duffing, {**HARDENING, "mu": 0.003, "c_2": 0.05, "c_3": 0.3}, at(0.0502, 1.02), "states peak"),
    "on a base": system(Isolator, LOOSE | {"eta": 5e-4, "c_2": 1e-3, **RELEASED}, at(0.0502, 1.02), "onset detachment",
                        excitation="base"),
    "unbalance": system(Duffing, HARDENING, at(0.0502, 1.02), "states peak onset", excitation="unbalance"),
    **{
        f"isolation, {excitation}": system(Duffing, {"alpha": 0.8, "beta": 0.6, "mu": 1e-3, "zeta": 0.08}, at(0.05),
                                           "isolation:-6 isolation:-20", excitation=excitation)
        for excitation in ("force", "base")
    },
    **{name: system(name, {**FORCES[name][1], "mu": 0.01, "zeta": 0.03}, at(0.1), "folds")
       for name in ("soft_stop", "power", "hertz")},
    **{name: system(name, {"k": 1.2, "q": 3.0, "g": 0.2, "mu": 0.01, "zeta": 0.05}, at(0.1, 1.2), SOME)
       for name in STOPS},
    "letting_go": system("letting_go", {"k": 1.5, "gap": 0.5, "mu": 0.01, "zeta": 0.03}, at(0.1), "folds"),
    # mounts: a number of springs is whole
    **{
        f"mount, {excitation}, {f} Hz": system(Isolator.physical, SHEET | damping, {letter: size, "f": f}, "states",
                                               n=3, excitation=excitation)
        for excitation, letter, size, damping in (
            ("force", "F", 5.0, {"c": 10.0}),
            ("base", "Y", 0.004, {"zeta": 0.05}),
            ("acceleration", "a", 0.5, {"zeta": 0.05}),
        )
        for f in (2.5, 3.0)
    },
    **{
        f"cubic mount, {k_1} {damping}": system(Duffing.physical, {"m": 12.0, **springs, "friction": 0.4, **damping},
                                                {"F": 5.0, "f": 2.0}, "peak", **({} if k_1 else {"k_1": 0.0}))
        for k_1, k_3 in ((2500.0, 4e5), (-600.0, 4e6), (0.0, 4e5))
        for springs in ({"k_1": k_1, "k_3": k_3},)
        # also where a ratio of damping refers to a stiffness that changes
        for damping in ({"c": 8.0}, {"zeta": 0.03}, {"zeta": 0.02, "eta": 0.05})
    },
    "loaded mount": system(Isolator.physical, {**SHEET, "zeta": 0.02, "load": 12.12}, {"F": 5.0, "f": 2.0},
                           "rest isolation peak detachment onset", n=3),
    "kink of a loaded mount": system(Isolator.physical, {**SHEET, "zeta": 0.078, "load": 12.12}, {"F": 5.0, "f": 2.0},
                                     "onset", n=3),
    "folds of a loaded mount": system(Isolator.physical, {**SHEET, "zeta": 0.02, "load": 12.12}, {"F": 3.0, "f": 2.0},
                                      "folds", n=3),
    "mount with laws": system(Isolator.physical, WITH_LAWS, {"F": 5.0, "f": 2.0}, "peak", k_h=600, preload=0.002, n=2),
}  # fmt: skip


@pytest.mark.parametrize("name", ["isolation, force", *slow(*(name for name in SYSTEMS if name != "isolation, force"))])
def test_gradients_are_differences_of_answers(name: str) -> None:
    make, numbers, at, questions, constant = SYSTEMS[name]

    def forced(**values: float) -> Forced:
        forcing = {one: values.pop(one) for one in at}
        return Forced(make(**values), forcing)

    asks = {question: lambda one, question=question: one.ask(question) for question in questions.split()}
    found = assert_slopes_are_differences(forced, {**numbers, **at}, asks, {**numbers, **at})
    assert found == {*questions.split()} - {*constant.split()}
