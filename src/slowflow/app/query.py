"""Oscillators and questions of a scene: which tables define an oscillator, and one question with its arguments."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from slowflow.answers.answer import Answer
from slowflow.answers.quantities import EXCITED, LETTERS, SHOWN, SI, UNITS
from slowflow.answers.table import COLUMNS
from slowflow.answers.table import QUESTIONS as ROWS
from slowflow.oscillators.isolator import Duffing, Isolator

__all__ = ["Kind", "Query"]


def _takes(question: str) -> frozenset[str]:
    """What the method of this name takes without dimensions, but of a frequency that it need not be given "window"."""
    parameters = inspect.signature(getattr(Isolator, question)).parameters.values()
    return frozenset(
        "window" if one.name == "Omega" and one.default is not one.empty else one.name for one in parameters
    )


#: what a scene may ask, and what that takes: those of the table but proofs, which a certificate has, tolerances, and
#: what many designs are not asked
QUESTIONS: Mapping[str, frozenset[str]] = {
    **{name: _takes(name) for name in ROWS if name != "certify"},
    "tolerances": frozenset(),
    **{name: _takes(name) for name in ("exact_response", "fold_locus", "cusps", "isola_points")},
}


@dataclass(frozen=True)
class Kind:
    """A table that defines an oscillator.

    make               -- function of its keys that makes the oscillator
    forcing, frequency -- names of the keys in [ask], and of the methods' arguments
    time               -- name of the times of a record
    """

    make: Callable[..., Any]
    forcing: str = "F_0"
    frequency: str = "Omega"
    time: str = "tau"

    @property
    def in_si(self) -> bool:
        """Whether its numbers are in SI units."""
        return self.frequency == "f"

    @property
    def keys(self) -> tuple[str, ...]:
        """The allowed keys."""
        return tuple(inspect.signature(self.make).parameters)

    @property
    def needed(self) -> tuple[str, ...]:
        """The required keys."""
        parameters = inspect.signature(self.make).parameters
        return tuple(name for name, one in parameters.items() if one.default is inspect.Parameter.empty)


KINDS = {
    "mount": Kind(Isolator.physical, "F", "f", "t"),
    "spring": Kind(Duffing.physical, "F", "f", "t"),
    "isolator": Kind(Isolator),
    "duffing": Kind(Duffing),
}
#: keys of these that are no numbers with a tolerance
NO_NUMBERS = ("load", "force", "excitation", "contact", "mu_s", "static_friction")
#: what the amplitude of an excitation is called
FORCINGS = (*LETTERS, "F_0")
#: of which kind the arguments of a mount's questions are
OF_MOUNT = {one.si or one.name: one.kind for one in COLUMNS.values()}
OF_MOUNT |= {**dict(EXCITED.values()), "x": "length", "A_max": "length"}
#: names of the frequency
FREQUENCIES = ("f", "Omega")
#: columns of a measured loop, of which the times may be left out
OF_A_LOOP = ("x", "F", "t")
#: what a half sine of the base is given by
OF_A_PULSE = ("acceleration", "duration")


@dataclass(frozen=True)
class Query:
    """One question of a scene, with forcing and frequencies by the names of the arguments.

    kinds -- for a mount, the kinds of unit of these: keys of `quantities.UNITS`
    """

    question: str
    arguments: Mapping[str, Any]
    kinds: Mapping[str, str] = field(default_factory=dict)

    @property
    def forcing(self) -> float | None:
        """The forcing, if it has one."""
        known = (value for name, value in self.arguments.items() if name in FORCINGS and isinstance(value, float))
        return next(known, None)

    def numbers(self) -> dict[str, float]:
        """The arguments that are single numbers (forcing, pulse), in the units of printed answers."""
        pulse = zip(OF_A_PULSE, self.arguments.get("shock", ()), strict=False)
        found = {name: value for name, value in (*self.arguments.items(), *pulse) if isinstance(value, float)}
        sizes = {name: UNITS[kind][SHOWN[kind]] for name, kind in self.kinds.items()}
        return {name: value / sizes.get(name, 1.0) for name, value in found.items()}

    def units(self) -> dict[str, str]:
        """Units of `numbers`, by the names of the arguments."""
        return {name: SHOWN[kind] for name, kind in self.kinds.items()}

    def given_in(self) -> dict[str, str]:
        """SI units of the arguments, by name; the two arguments of a pair have one each."""
        pairs = {"shock": OF_A_PULSE, "spectrum": [name for name in self.kinds if name in (*LETTERS, "f")]}
        names = [part for name in self.arguments for part in pairs.get(name, [name])]
        return {name: SI[self.kinds[name]] for name in names if name in self.kinds}

    def count(self) -> int:
        """Number of answers: one for each frequency, row of a spectrum, pulse of a shock spectrum."""
        if self.question == "amplitudes":
            return next(len(values) for name, values in self.arguments.items() if name in FREQUENCIES)
        if self.question == "shock_spectrum":
            return len(self.arguments["acceleration"]) * len(self.arguments["duration"])
        rows = self.arguments.get("spectrum", self.arguments.values() if self.question == "spectrum" else [[None]])
        return len(next(iter(rows)))

    @property
    def cost(self) -> str:
        """Key of its measured time in `costs.COSTS`: the question, and for tolerances the load case."""
        if self.question != "tolerances":
            return self.question
        of = {"spectrum": "in a spectrum", "shock": "in a shock", **dict.fromkeys(FREQUENCIES, "at a frequency")}
        return next((f"tolerances {case}" for name, case in of.items() if name in self.arguments), "tolerances")

    def content(self, answer: Answer) -> dict[str, Any]:
        """Query and answer, as plain Python."""
        what = {"question": self.question, "arguments": dict(self.arguments), "units_of_arguments": self.given_in()}
        return {**what, **answer.to_dict()}

    def __str__(self) -> str:
        units = self.units()
        text = ", ".join(f"{name} = {value:g} {units.get(name, '')}".rstrip() for name, value in self.numbers().items())
        if "spectrum" in self.arguments:
            return f"{self.question} in the load spectrum"
        return f"{self.question} at {text}" if text else self.question
