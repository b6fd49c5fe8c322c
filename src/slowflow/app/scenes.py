"""Input files (scenes): TOML files with an oscillator, forces and the results to compute.

    [mount]                     # as Isolator.physical, in SI units; or [spring], as Duffing.physical; or [isolator],
                                # [duffing], dimensionless
    m = 12
    k_v = 2500
    k_h = 1700
    L = 0.080
    preload = 0.009
    friction = 0.4
    zeta = 0.02

    [ask]
    F = [3.0, "0.8 lbf"]        # N; F_0 for [isolator] and [duffing]; Y in m or a in m/s^2 with excitation = "base",
                                # U in kg m with excitation = "unbalance"
    f = [5.0]                   # Hz; Omega for [isolator] and [duffing]
    level_dB = [0, -20]         # for "isolation": levels below which the transmissibility is to stay
    A_max = 0.08                # m, for "fold_locus", "cusps" and "isola_points": the largest amplitude
    questions = ["saddle_nodes", "amplitudes", "spectrum"]

    [spectrum]                  # pairs, one tone at a time
    f = [2.0, 2.2, 5.0]
    F = [5.0, 5.0, 3.0]

    [tolerances]                # for the question "tolerances": relative half widths; answers at each F,
    k_h = 0.05                  # with each f, in the [spectrum] and in each half sine of the [shock], if specified

    [shock]                     # for "transient" and "shock_spectrum": half sines of the base, all combinations
    acceleration = [20.0]       # m/s^2; of either sign for "transient"
    duration = [0.011, 0.02]    # s; for a record of acceleration its times t instead (tau if dimensionless)

    [psd]                       # for "random": a one-sided power spectral density, linear in log-log
    f = [1, 5, 100]             # Hz; Omega for a dimensionless oscillator, without unit
    G = [1e-4, 1e-4, 2.5e-7]
    unit = "g^2/Hz"             # or "(m/s^2)^2/Hz", of the base; "N^2/Hz", of a force; needed in SI units

    [loop]                      # for the report: a force-displacement loop, measured on one mount
    file = "loop.csv"           # columns x in m, F in N; t in s, for viscous damping

    [require]                   # requirements: `run` and `report` give verdict and margins
    # jumps = "none"            # at each F of [ask]; detachment = "none" as well
    transmissibility_dB = { below = -10, from_f = 8 }
    relative_displacement = { below = "60 mm", under = ["peak", "shock", "random"], duration = "1 h" }
    absolute_acceleration = { below = "0.5 g", under = "random", rms = true }

    [free]                      # for `slowflow meet`: free parameters of the mount, with their ranges
    k_v = [2000, "3 N/mm"]
    zeta = [0.02, 0.1]

[spectrum], [shock], [psd] and [loop] may have `file = "columns.csv"` instead of lists; the path is relative to the
folder of the scene, and `slowflow.oscillators.measurements` describes the file. A scene contains numbers, strings and
lists, but no code and no expressions. An invalid scene raises `SceneError` with the line, the allowed values and the
closest valid name.
"""

from __future__ import annotations

import contextlib
import hashlib
import itertools
import os
import re
import tomllib
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

from slowflow.answers.answer import Answer, shown
from slowflow.answers.quantities import DENSITIES, EXCITED, OF_A_BASE, SI, si
from slowflow.answers.table import SHOCKS
from slowflow.app import costs
from slowflow.app.query import (
    FORCINGS,
    FREQUENCIES,
    KINDS,
    NO_NUMBERS,
    OF_A_LOOP,
    OF_A_PULSE,
    OF_MOUNT,
    QUESTIONS,
    Kind,
    Query,
)
from slowflow.app.verdict import AMOUNTS, NONE, REQUIREMENTS, TRANSMISSIBILITY, Requirement, kind_of
from slowflow.averaged import plan
from slowflow.averaged.plan import Plan
from slowflow.core import validate
from slowflow.oscillators import range_checks
from slowflow.oscillators.arguments import REMARKS
from slowflow.oscillators.isolator import Duffing, Isolator
from slowflow.oscillators.measurements import read_csv
from slowflow.oscillators.physical import Physical
from slowflow.support.errors import Refused, SceneError

__all__ = ["Kind", "Query", "Scene", "from_tables", "read"]


#: tables whose columns a CSV file may have
OF_FILES = ("spectrum", "shock", "psd", "loop")
#: of a base that moves, in reports and above the tables of answers
RELATIVE = "displacements are relative to the base; transmissibility and acceleration are those of the absolute motion"


@dataclass(frozen=True)
class Scene:
    """A scene that can be run.

    path, text -- its source
    content    -- the same as plain Python
    loop       -- columns of a loop that was measured on one mount
    oscillator -- an `Isolator`, `Duffing` or, in physical units, `Physical`
    queries    -- the questions with their arguments, in order
    warnings   -- implausible numbers
    requirements -- the requirements
    given_forcings, cases -- forcings of [ask], and shocks and spectra, to which the requirements apply
    free       -- parameters of the oscillator that may change to meet them, each with its range
    answers    -- answers computed so far, by question and arguments
    """

    path: Path
    text: str
    content: Mapping[str, Any]
    oscillator: Isolator | Duffing | Physical
    queries: tuple[Query, ...]
    warnings: tuple[str, ...] = ()
    requirements: tuple[Requirement, ...] = ()
    given_forcings: tuple[float, ...] = ()
    cases: tuple[Query, ...] = ()
    free: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    loop: Mapping[str, list[float]] = field(default_factory=dict)
    answers: dict[Any, Any] = field(default_factory=dict, compare=False, repr=False)

    @property
    def frame(self) -> str:
        """What motions are relative to; empty where nothing but the mass moves."""
        of = self.oscillator.scales if isinstance(self.oscillator, Physical) else self.oscillator
        return RELATIVE if of.excitation in OF_A_BASE else ""

    def answer(self, query: Query) -> Answer:
        """The answer to one of its questions, for a mount in N, mm and Hz; computed on first use."""
        return shown(self.ask(query.question, **query.arguments))

    def ask(self, question: str, **arguments: Any) -> Any:
        """The oscillator's answer, for a mount in SI units; computed on first use."""
        if (key := (question, repr(sorted(arguments.items())))) not in self.answers:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", range_checks.Implausible)  # among `warnings` already
                self.answers[key] = self._method(question)(**arguments)
        return self.answers[key]

    def _method(self, question: str) -> Callable[..., Any]:
        """What answers a question."""
        if question != "tolerances":
            return getattr(self.oscillator, question)
        from slowflow.sizing import tolerances  # here, not above: it imports SciPy's statistics

        return partial(tolerances, self.oscillator)

    def explain(self, query: Query) -> Plan | None:
        """The plan of a question; None for a formula, or a combination of other questions."""
        if query.question not in plan.QUESTIONS:
            return None
        return self.oscillator.explain(query.question, query.forcing)

    def seconds(self, query: Query) -> float:
        """Estimated time, from measured times of such questions."""
        oscillator: Any = self.oscillator.oscillator if isinstance(self.oscillator, Physical) else self.oscillator
        plain, laws, load = costs.COSTS[query.cost]
        each = load if oscillator.load != 0 else laws if oscillator.model.laws.any else plain
        # what was not measured, as a shock with eta, which is refused, takes at most what the others take
        return (each or max(plain, laws, load)) * query.count()

    def forcings(self) -> list[float]:
        """The forcings of its questions and requirements, each once, in order."""
        own = (one.forcing for one in self.queries if one.forcing is not None)
        return list(dict.fromkeys((*own, *self.given_forcings)))

    def of(self, question: str) -> list[Query]:
        """Return the queries of one question in this scene."""
        return [query for query in self.queries if query.question == question]

    def of_design(self, design: Any) -> Scene:
        """The same scene with another oscillator."""
        return replace(self, oscillator=design, answers={})

    def with_numbers(self, numbers: Mapping[str, float], folder: Path | None = None) -> str:
        """Return its text with other parameters of the oscillator, for a file in `folder`, by default its own.

        Relative paths of CSV files are adapted. Raises SceneError if the text does not have one parameter per line.
        """
        lines, reader = self.text.splitlines(), _Reader(self.path, self.text, dict(self.content))
        (table,) = KINDS.keys() & self.content.keys()
        expected = tomllib.loads(self.text)
        changed: list[tuple[str, str, Any]] = [(table, key, value) for key, value in numbers.items()]
        here = self.path.parent
        for name in OF_FILES:
            if file := expected.get(name, {}).get("file"):
                there = here / file if Path(file).is_absolute() else os.path.relpath(here / file, folder or here)
                changed.append((name, "file", Path(there).as_posix()))
        for name, key, value in changed:
            k = reader._line(name, key) - 1
            value_of = rf"""(\b{re.escape(key)}\s*=\s*)("[^"]*"|'[^']*'|[^\s#]+)"""
            line, count = re.subn(value_of, rf"\g<1>{value!r}", lines[k], count=1)
            lines[k] = line if count else f"{lines[k]}\n{key} = {value!r}"
            expected[name][key] = value
        text = "\n".join(lines) + "\n"
        with contextlib.suppress(tomllib.TOMLDecodeError):
            if tomllib.loads(text) == expected:
                return text
        raise SceneError(f"{self.path}: [{table}] must have one parameter per line, so that its value can be replaced")

    @property
    def sha256(self) -> str:
        """Hash of the text."""
        return hashlib.sha256(self.text.encode()).hexdigest()


def from_tables(content: Mapping[str, Any]) -> Scene:
    """Make a scene from tables in plain Python. Raises SceneError, without a file name, for errors."""
    return _Reader(Path(), "", dict(content)).scene()


def read(path: Path) -> Scene:
    """Read an input file. Raises SceneError for errors in it or a missing file, OSError if it cannot be read."""
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise SceneError(f"{path}: there is no such file; `slowflow new` writes an example") from None
    except IsADirectoryError:
        raise SceneError(f"{path}: this is a folder, not a scene") from None
    except UnicodeDecodeError as error:
        raise SceneError(f"{path}: this is not UTF-8: {error.reason} at byte {error.start}") from None
    try:
        content = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise SceneError(f"{path}: this is not TOML: {error}") from None
    return _Reader(path, text, {name: _with_columns(path, name, table) for name, table in content.items()}).scene()


def _with_columns(path: Path, name: str, table: Any) -> Any:
    """A table with the columns of its file in place of the file's name."""
    if name not in OF_FILES or not isinstance(table, dict) or "file" not in table:
        return table
    if not isinstance(table["file"], str):
        raise SceneError(
            f"{path}: file = {table['file']!r} in [{name}] is not allowed: it must be the name of a CSV file"
        )
    columns = read_csv(path.parent / table["file"])
    unit = {"unit": columns.units["G"]} if "G" in columns.units else {}
    own = {key: value for key, value in table.items() if key != "file"}
    return {**own, **unit, **{key: column.tolist() for key, column in columns.items()}}


@dataclass
class _Reader:
    """Reads the tables of a scene, each once, whether or not a question needs it."""

    path: Path
    text: str
    content: dict[str, Any]
    kind: Kind = field(init=False)
    tables: dict[str, Any] = field(init=False)

    def scene(self) -> Scene:
        reads = {"ask": self._ask, "spectrum": self._spectrum, "tolerances": self._within, "shock": self._pulses}
        reads |= {"psd": self._psd, "loop": self._loop}
        self._known("", self.content, (*KINDS, *reads, "require", "free"))
        stated = [name for name in KINDS if name in self.content]
        if len(stated) != 1:
            one_of = ", ".join(f"[{name}]" for name in KINDS)
            raise self._error(stated[-1] if stated else "", "", f"needs one of {one_of}, has {len(stated)}")
        (name,) = stated
        self.kind, table = KINDS[name], self._table(name)
        self._known(name, table, self.kind.keys)
        if self.kind.in_si and table.get("excitation") == "base" and self._accelerates():
            table = {**table, "excitation": "acceleration"}
        if self.kind.in_si and table.get("excitation") in tuple(EXCITED):
            self.kind = replace(self.kind, forcing=EXCITED[table["excitation"]][0])
        kind = self.kind
        self._complete(name, table, kind.needed)
        # first: what it refuses, as a word for the excitation, decides which keys [ask] has
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            oscillator = self._tried(name, table, lambda: kind.make(**table))
        self._table("ask")
        self.tables = {name: read(self._table(name)) for name, read in reads.items() if name in self.content}
        names = (kind.forcing, kind.frequency, *OF_A_PULSE, kind.time, "A_max")
        kinds = {key: OF_MOUNT[key] for key in names if kind.in_si}
        queries = tuple(replace(one, kinds=kinds) for one in self._queries())
        remarks = dict.fromkeys((*(str(one.message) for one in caught), *_implausible(oscillator, queries)))
        cases = [*self._shocks("transient")] if "shock" in self.tables else []
        cases += [Query("random", self.tables["psd"])] if "psd" in self.tables else []
        required: dict[str, Any] = {"cases": tuple(replace(one, kinds=kinds) for one in cases)}
        required["given_forcings"] = tuple(self.tables["ask"].get(kind.forcing, ()))
        if "require" in self.content:
            required["requirements"] = tuple(self._required())
        if "free" in self.content:
            required["free"] = self._free(oscillator)
        loop = self.tables.get("loop", {})
        return Scene(self.path, self.text, self.content, oscillator, queries, tuple(remarks), **required, loop=loop)

    def _accelerates(self) -> bool:
        """Whether a base is given by its acceleration."""
        return any(isinstance(table := self.content.get(name), dict) and "a" in table for name in ("ask", "spectrum"))

    # ---- tables, each as its questions take it

    def _ask(self, table: Mapping[str, Any]) -> dict[str, Any]:
        """What questions take, by the names here, and the questions."""
        reads: dict[str, Callable[[str], Any]] = dict.fromkeys((self.kind.forcing, self.kind.frequency), self._positive)
        reads |= {"window": self._window, "samples": self._samples, "level_dB": partial(self._numbers, most=0.0)}
        reads |= {"A_max": self._positive, "questions": self._questions}
        self._asks("ask", table, tuple(reads)[2:])
        if "require" not in self.content:
            self._complete("ask", table, ("questions",))
        return {key: reads[key](key) for key in table}

    def _spectrum(self, table: Mapping[str, Any]) -> dict[str, Any]:
        """The pairs of a load spectrum."""
        names = (self.kind.frequency, self.kind.forcing)
        self._asks("spectrum", table)
        self._complete("spectrum", table, names)
        pairs = {name: self._positive(name, "spectrum") for name in names}
        lengths = [len(values) for values in pairs.values()]
        if lengths[0] != lengths[1]:
            message = f"has {lengths[1]} numbers, and {names[0]} has {lengths[0]}: they are pairs"
            raise self._error("spectrum", names[1], message)
        return pairs

    def _pulses(self, table: Mapping[str, Any]) -> dict[str, Any]:
        """Peaks and durations of half sines, or the samples of a record and their times."""
        time = self.kind.time
        self._known("shock", table, (*OF_A_PULSE, time))
        names = ("acceleration", time) if time in table else OF_A_PULSE
        self._complete("shock", table, names)
        rows = {key: (self._positive if key == "duration" else self._numbers)(key, "shock") for key in table}
        if time in table and ("duration" in table or len(rows["acceleration"]) != len(rows[time])):
            message = "must have one time for each sample of acceleration, and no duration"
            raise self._error("shock", time, message)
        return rows

    def _psd(self, table: Mapping[str, Any]) -> dict[str, Any]:
        """A spectral density, of a mount in a unit."""
        names = (self.kind.frequency, "G", *["unit"] * self.kind.in_si)
        self._known("psd", table, names)
        self._complete("psd", table, names)
        rows = {"psd": tuple(self._positive(key, "psd") for key in names[:2])}
        if not self.kind.in_si:
            return rows
        unit = self._tried("psd", table, lambda: validate.choice("unit", table["unit"], tuple(DENSITIES)))
        return {**rows, "unit": unit}

    def _within(self, table: Mapping[str, Any]) -> dict[str, float]:
        """Shares of numbers of the oscillator by which these may be off."""
        self._known("tolerances", table, tuple(key for key in self.kind.keys if key not in NO_NUMBERS))
        bounds = {"least": 0.0, "below": 1.0}
        return self._tried(
            "tolerances", table, lambda: {key: validate.number(key, value, **bounds) for key, value in table.items()}
        )

    def _loop(self, table: Mapping[str, Any]) -> dict[str, list[float]]:
        """A measured force-displacement loop, in SI units."""
        # here, not above: it imports SciPy
        from slowflow.sizing.fitting import LEAST_SAMPLES
        from slowflow.sizing.samples import in_time

        if not self.kind.in_si:
            raise self._error("loop", "", "needs [mount] or [spring]: a loop is in SI units")
        self._known("loop", table, OF_A_LOOP)
        self._complete("loop", table, OF_A_LOOP[:2])
        rows = {key: self._numbers(key, "loop") for key in table}
        self._tried("loop", table, lambda: in_time(rows, LEAST_SAMPLES))
        return rows

    def _free(self, oscillator: Any) -> dict[str, tuple[float, float]]:
        """The numbers that may change to meet what is required, each with its ends."""
        # here, not above: it imports SciPy
        from slowflow.sizing.subject import Subject

        table = self._table("free")
        if not self.content.get("require"):
            raise self._error("free", "", "needs [require], the requirements to meet")
        self._known("free", table, tuple(key for key in self.kind.keys if key not in NO_NUMBERS))
        subject = self._tried("free", table, lambda: Subject(oscillator, table))
        return self._tried("free", table, lambda: {key: subject.ends(key, value) for key, value in table.items()})

    def _required(self) -> Iterator[Requirement]:
        """What must hold."""
        table = self._table("require")
        self._known("require", table, REQUIREMENTS)
        if not table:
            raise self._error("require", "", f"is empty: it must have some of {', '.join(REQUIREMENTS)}")
        for name, value in table.items():
            yield self._tried("require", table, partial(self._requirement, name, value))

    def _requirement(self, name: str, value: Any) -> Requirement:
        """One of them. Raises ValueError for what it must not be, or where its load case is missing."""
        kind, at_forcings = self.kind, self.kind.forcing in self.tables["ask"]
        if name in NONE:
            validate.choice(name, value, ("none",))
        if name not in AMOUNTS and not at_forcings:
            raise Refused(f"{name} is required at forcings: {kind.forcing} is missing in [ask]")
        if name in NONE:
            return Requirement(name)
        start = f"from_{kind.frequency}"
        keys = ("below", start) if name == TRANSMISSIBILITY else ("below", "under", "rms", "duration")
        if not isinstance(value, dict) or not set(keys[:2]) <= set(value) <= set(keys):
            raise Refused(f"{name} must be a table with {' and '.join(keys[:2])}; it may have {', '.join(keys)}")
        if name == TRANSMISSIBILITY:
            start_at = validate.number(start, si(start, value[start], SI["frequency"] if kind.in_si else ""), above=0.0)
            return Requirement(name, validate.number("below", value["below"], most=0.0), {"from": start_at})
        under = value["under"] if isinstance(value["under"], list) else [value["under"]]
        if not under:
            raise Refused(f"{name} has no load case: under must have some of {', '.join(AMOUNTS[name])}")
        needs = {"peak": at_forcings, "shock": "shock" in self.tables, "random": "psd" in self.tables}
        for one in under:
            validate.choice("under", one, tuple(AMOUNTS[name]))
            if not needs[one]:
                table = {"peak": f"{kind.forcing} in [ask]", "shock": "[shock]", "random": "[psd]"}[one]
                raise Refused(f"{name} under {one!r} needs {table}")
        rms, is_timed = value.get("rms", False), "duration" in value
        if not isinstance(rms, bool):
            raise Refused(f"{name}: rms = {rms!r} is not allowed: rms must be true or false")
        if (rms or is_timed) and ("random" not in under or rms == is_timed):
            raise Refused(f"{name}: rms = true or a duration, one of them, is of 'random' only")
        if "random" in under and not rms and (name != "relative_displacement" or not is_timed):
            raise Refused(
                f"{name} under 'random' needs rms = true, or for a displacement the duration whose maximum counts"
            )
        more = {"under": under, "rms": rms}
        if is_timed:
            duration = si("duration", value["duration"], SI["time"] if kind.in_si else "")
            more["duration"] = validate.number("duration", duration, above=0.0)
        below = si("below", value["below"], SI[kind_of(name)]) if kind.in_si else value["below"]
        return Requirement(name, validate.number("below", below, above=0.0), more)

    # ---- questions with their arguments

    def _queries(self) -> Iterator[Query]:
        """The questions with their arguments."""
        of_tables = {"spectrum": "spectrum", "tolerances": "tolerances", "random": "psd"}
        of_tables |= dict.fromkeys(SHOCKS, "shock")
        for name in self.tables["ask"].get("questions", ()):
            if (table := of_tables.get(name)) not in (None, *self.tables):
                raise self._error("ask", "questions", f"= {name!r} needs a table [{table}], which is missing")
            if name == "tolerances":
                yield from self._tolerances()
            elif name in SHOCKS:
                yield from self._shocks(name)
            else:
                yield from [Query(name, self.tables[table])] if table else self._plain(name)

    def _plain(self, name: str) -> Iterator[Query]:
        """A question at what [ask] has of that which it takes, at each forcing, each level and each A_max."""
        ask, takes = self.tables["ask"], QUESTIONS[name]
        forcing, frequency = self.kind.forcing, self.kind.frequency
        for key, symbol in ((forcing, "F_0"), (frequency, "Omega")):
            if symbol in takes and key not in ask:
                raise self._error("ask", "", f"{key} is missing: {name} needs it")
        names = {"F_0": forcing, "Omega": frequency, **{one: one for one in ("level_dB", "A_max", "window", "samples")}}
        found = {key: ask[key] for symbol, key in names.items() if symbol in takes and key in ask}
        several = [key for key in (forcing, "level_dB", "A_max") if key in found]
        for values in itertools.product(*map(found.pop, several)):
            at = {frequency if key == "window" else key: value for key, value in found.items()}
            yield Query(name, {**dict(zip(several, values, strict=True)), **at})

    def _shocks(self, name: str) -> Iterator[Query]:
        """The pulses of a shock: every pair of a peak and a duration, or a record."""
        pulses = self.tables["shock"]
        if name == "shock_spectrum":
            self._complete("shock", pulses, OF_A_PULSE)
            peaks = self._positive("acceleration", "shock")
            yield Query(name, {"acceleration": [[peak] for peak in peaks], "duration": pulses["duration"]})
        elif "duration" not in pulses:
            yield Query(name, pulses)
        else:
            for pair in itertools.product(*(pulses[key] for key in OF_A_PULSE)):
                yield Query(name, dict(zip(OF_A_PULSE, pair, strict=True)))

    def _tolerances(self) -> Iterator[Query]:
        """Shares by which numbers may be off: at each forcing, then with each frequency, in the spectrum, in shocks."""
        # here, not above: it imports SciPy
        from slowflow.sizing.subject import AT_A_FREQUENCY, IN_A_SHOCK, IN_A_SPECTRUM

        name, kind, ask, within = "tolerances", self.kind, self.tables["ask"], {"within": self.tables["tolerances"]}
        cases: list[dict[str, Any]] = []
        for forcing in ask.get(kind.forcing, []):
            cases.append({kind.forcing: forcing, **within})
            for at in ask.get(kind.frequency, []):
                cases.append({kind.forcing: forcing, kind.frequency: at, **within, "answers": [*AT_A_FREQUENCY]})
        if pairs := self.tables.get("spectrum"):
            cases.append({"spectrum": tuple(pairs.values()), **within, "answers": [*IN_A_SPECTRUM]})
        if "duration" in self.tables.get("shock", {}):
            pulses = (tuple(one.arguments.values()) for one in self._shocks("transient"))
            cases += [{"shock": pulse, **within, "answers": [*IN_A_SHOCK]} for pulse in pulses]
        return (Query(name, case) for case in cases or [within])

    def _positive(self, key: str, table: str = "ask") -> list[float]:
        """A list of numbers > 0."""
        return self._numbers(key, table, above=0.0)

    def _numbers(self, key: str, table: str = "ask", **bounds: float) -> list[float]:
        """A list of numbers within bounds, of a mount in SI units."""
        unit = self._unit(key)
        values = self._list(table, key, (int, float, str) if unit else (int, float))
        return self._tried(
            table, self.content[table], lambda: [validate.number(key, si(key, one, unit), **bounds) for one in values]
        )

    def _window(self, key: str) -> tuple[float, float]:
        """Ends of frequencies, of a mount in SI units."""
        ask, unit = self.content["ask"], self._unit(self.kind.frequency)
        ends = ask[key] if isinstance(ask[key], list) else [ask[key]]
        return self._tried("ask", ask, lambda: validate.window(key, [si(key, one, unit) for one in ends]))

    def _samples(self, key: str) -> int:
        """A number of points."""
        ask = self.content["ask"]
        return self._tried("ask", ask, lambda: validate.count(key, ask[key], least=2, most=validate.MOST_SAMPLES))

    def _questions(self, key: str) -> list[str]:
        """Names of questions."""
        names = self._list("ask", key, str)
        for name in names:
            if name not in QUESTIONS:
                message = f"= {name!r} is not allowed: it must be one of {', '.join(QUESTIONS)}"
                raise self._error("ask", key, message, name, QUESTIONS)
        return names

    def _unit(self, key: str) -> str:
        """In which unit a mount has it; empty where it has none."""
        in_si = any(kind.in_si for name, kind in KINDS.items() if name in self.content)
        return SI.get(OF_MOUNT.get(key, ""), "") if in_si else ""

    def _table(self, name: str) -> dict[str, Any]:
        """A table, which must be there."""
        value = self.content.get(name)
        if not isinstance(value, dict):
            raise self._error(name, "", "a table is missing" if value is None else "must be a table")
        return value

    def _list(self, table: str, key: str, kind: Any) -> list[Any]:
        """A list of numbers or words, or a single one."""
        value = self.content[table][key]
        values = value if isinstance(value, list) else [value]
        if not values or not all(isinstance(one, kind) and not isinstance(one, bool) for one in values):
            what = "words" if kind is str else "numbers"
            quoted = "" if kind is str else next(filter(None, map(_quoted, values)), "")
            raise self._error(table, key, f"= {value!r} is not allowed: {key} must be a list of {what}{quoted}")
        return values

    def _known(self, table: str, values: Mapping[str, Any], known: tuple[str, ...]) -> None:
        for key in values:
            if key not in known:
                where = (table, key) if table else (key, "")
                what = f"is not a key of [{table}]" if table else "is not a table of a scene"
                raise self._error(*where, f"{what}: it must be one of {', '.join(known)}", key, known)

    def _asks(self, table: str, values: Mapping[str, Any], more: tuple[str, ...] = ()) -> None:
        """As `_known`; for a forcing or frequency of another oscillator the message names the one to use here."""
        kind, known = self.kind, (self.kind.forcing, self.kind.frequency, *more)
        for key in values:
            if key in (*FORCINGS, *FREQUENCIES) and key not in known:
                right, of = (kind.forcing, kind.forcing) if key in FORCINGS else (kind.frequency, "f")
                unit = f", in {SI[OF_MOUNT[of]]}" if kind.in_si else ", dimensionless"
                what = "the frequency"
                if key in FORCINGS:
                    excited = next((name for name, (letter, *_) in EXCITED.items() if letter == right), "")
                    what = f"the amplitude of the excitation{f' = {excited!r}' if excited else ''}"
                message = (
                    f"is not a key of [{table}] here: it must be one of {', '.join(known)}; {what} is {right}{unit}"
                )
                raise self._error(table, key, message)
        self._known(table, values, known)

    def _complete(self, table: str, values: Mapping[str, Any], needed: tuple[str, ...]) -> None:
        for key in needed:
            if key not in values:
                raise self._error(table, "", f"{key} is missing: [{table}] needs {', '.join(needed)}")

    def _tried(self, table: str, values: Mapping[str, Any], make: Callable[[], Any]) -> Any:
        """What is made of a table; the reason for a refusal begins with the key."""
        try:
            return make()
        except ValueError as error:
            key = re.split(r"[ \[]", str(error), maxsplit=1)[0]
            at = self._at(table, key if key in values else "")
            raise SceneError(f"{at}{error}{_quoted(values.get(key))}") from None

    def _error(self, table: str, key: str, message: str, word: str = "", known: Any = ()) -> SceneError:
        name = key or (f"[{table}]" if table else "the scene")
        return SceneError(f"{self._at(table, key)}{name} {message}{validate.meant(word, known or ())}")

    def _at(self, table: str, key: str) -> str:
        """Where that stands in the file, if there is one."""
        return f"{self.path}:{self._line(table, key)}: " if self.path.name else ""

    def _line(self, table: str, key: str) -> int:
        """Where a table or a key of it stands; 1 where that cannot be told, as in a table on one line."""
        inside, found = "", 1
        for number, line in enumerate(self.text.splitlines(), start=1):
            if head := re.match(r"\s*\[\s*([\w-]+)\s*\]", line):
                inside = head[1]
                if inside == table:
                    found = number
            elif key and inside == table and re.match(rf"\s*{re.escape(key)}\s*=", line):
                return number
            elif not inside and re.match(rf"\s*{re.escape(table)}\s*=", line):
                return number
        return found


def _implausible(of: Any, queries: Iterable[Query]) -> Iterator[str]:
    """Remarks on frequencies and durations of a mount that look as if they were in another unit."""
    if not isinstance(of, Physical):
        return
    f_n = of.scales.sizes["frequency"]
    for one in queries:
        values = [("f", one.arguments.get("f")), ("f", one.arguments.get("spectrum", [None])[0])]
        values += [("duration", one.arguments.get("duration")), ("duration", one.arguments.get("shock", [None])[-1])]
        for name, value in values:
            if value is not None:
                yield from REMARKS[name](value, f_n)


def _quoted(value: Any) -> str:
    """What to do with a number that was written as a word; empty for anything else."""
    try:
        return f". Remove the quotes: {float(value):g} is a number" if isinstance(value, str) else ""
    except ValueError:
        return ""
