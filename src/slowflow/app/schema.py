"""JSON schema of input files (scenes), from the tables by which scenes are read; plain Python.

Editors use it for completion and validation (`slowflow schema`), and tools for their arguments (`slowflow.app.tools`).
Names, units and meanings are those of the data sheet, the columns and the questions. Conditions that need a
computation, such as the domain of a dimensionless number, are checked when the scene is read.
"""

from __future__ import annotations

import inspect
from collections.abc import Iterable, Mapping
from typing import Any

from slowflow.answers.quantities import DATA_SHEET, DENSITIES, EXCITED, OF_A_BASE, SI
from slowflow.answers.table import COLUMNS, QUOTED, SHOCKS
from slowflow.app.query import FREQUENCIES, KINDS, NO_NUMBERS, OF_A_LOOP, OF_A_PULSE, OF_MOUNT, QUESTIONS
from slowflow.app.scenes import OF_FILES
from slowflow.app.verdict import AMOUNTS, NONE, TRANSMISSIBILITY
from slowflow.oscillators.oscillator import FORCES
from slowflow.oscillators.physical import Physical
from slowflow_kernels.domains import CONTACTS, DAMPING, DISSIPATION, EXCITATIONS
from slowflow_kernels.duffing import MECHANISM as DUFFING
from slowflow_kernels.rod_spring import MECHANISM as ROD_SPRING

Schema = dict[str, Any]

DRAFT = "https://json-schema.org/draft/2020-12/schema"
#: words that a key of an oscillator may be
CHOICES = {"force": FORCES, "contact": tuple(CONTACTS), "excitation": tuple(EXCITATIONS)}
#: which table beside the oscillator and [ask] a question reads
TABLES = {"spectrum": "spectrum", "tolerances": "tolerances", "random": "psd", **dict.fromkeys(SHOCKS, "shock")}
POSITIVE: Schema = {"type": "number", "exclusiveMinimum": 0}
#: a number in SI units, or a word with a unit, as "0.3 g"
QUANTITY: Schema = {"type": ["number", "string"], "pattern": r"^\s*[-+.0-9eE]+ +\S"}
AMPLITUDE: Schema = {**QUANTITY, "exclusiveMinimum": 0}


def scene() -> Schema:
    """The schema of a scene that contains all its tables."""
    tables = {name: _oscillator(name) for name in KINDS}
    tables |= {"ask": _ask((*_arguments(QUESTIONS), "questions")), **{name: _table(name) for name in _tables()}}
    tables["require"] = _requirements()
    ranges = {"type": "array", "items": QUANTITY, "minItems": 2, "maxItems": 2}
    tables["free"] = _object(
        "Free parameters to meet the requirements: lowest, highest", dict.fromkeys(_numbers(), ranges)
    )
    of_loop = {key: _list(QUANTITY, f"samples, in {SI[OF_MOUNT[key]]}") for key in OF_A_LOOP}
    tables["loop"] = _object("A force-displacement loop, measured on one mount", of_loop, OF_A_LOOP[:2])
    one_of = [{"required": [name]} for name in KINDS]
    return {"$schema": DRAFT, "title": "slowflow scene", **_object("", tables, ["ask"]), "oneOf": one_of}


def scene_file() -> Schema:
    """The schema of a scene in a file, whose columns may be in other files."""
    found = scene()
    for name in OF_FILES:
        table = found["properties"][name]
        table["properties"]["file"] = {"type": "string", "description": "CSV file of the columns, with units"}
        table.pop("required", None)
    return found


def question(name: str) -> Schema:
    """The schema of the input of one question: an oscillator, and [ask] or the table it needs."""
    tables = {kind: _oscillator(kind) for kind in KINDS}
    needed = [TABLES[name]] if name in TABLES else []
    if arguments := _arguments([name]):
        tables["ask"] = _ask(arguments)
    tables |= {one: _table(one) for one in (_tables() if name == "tolerances" else needed)}
    return {**_object("", tables, needed), "oneOf": [{"required": [kind]} for kind in KINDS]}


def description(name: str) -> str:
    """Description of a question, from its docstring; units are those of the arguments."""
    of_mount = getattr(Physical, name, None)
    if of_mount is None:
        return "Spread of the answers under relative tolerances of the parameters."
    return inspect.cleandoc(of_mount.__doc__ or "").partition("\n\n")[0]


def _object(text: str, properties: Mapping[str, Schema], required: Iterable[str] = ()) -> Schema:
    found = {"type": "object", "properties": dict(properties), "additionalProperties": False}
    return ({"description": text} if text else {}) | found | ({"required": list(required)} if required else {})


def _list(of: Schema, text: str = "") -> Schema:
    """One of these, or a list."""
    return ({"description": text} if text else {}) | {"anyOf": [of, {"type": "array", "items": of, "minItems": 1}]}


def _oscillator(name: str) -> Schema:
    """The table that states one: of each key its meaning, unit, words, bounds and default."""
    kind = KINDS[name]
    meanings = {key: ", ".join(filter(None, (text, unit))) for key, (unit, text) in DATA_SHEET.items()}
    bounds: dict[str, Schema] = {}
    if not kind.in_si:
        meanings |= {one.name: one.text for one in QUOTED} | {"load": "static load, over k_v L"}
        for number in (*DUFFING.design, *ROD_SPRING.design, *DAMPING, *DISSIPATION):
            meanings[number.name] = number.doc
            limits = {"exclusiveMinimum": number.above, "minimum": number.least}
            limits |= {"exclusiveMaximum": number.below, "maximum": number.most}
            bounds[number.name] = {key: bound for key, bound in limits.items() if bound is not None}
    keys: dict[str, Schema] = {}
    for key, one in inspect.signature(kind.make).parameters.items():
        of: Schema = {"type": "number", **bounds.get(key, {})}
        if key in CHOICES:
            of = {"enum": list(EXCITED if kind.in_si and key == "excitation" else CHOICES[key])}
        elif kind.in_si and DATA_SHEET[key][0]:
            of = QUANTITY
        default = {} if one.default in (None, one.empty) else {"default": one.default}
        keys[key] = {"description": meanings[key], **of, **default}
    what = "data sheet, in SI units" if kind.in_si else "dimensionless numbers"
    return _object(f"{what[0].upper()}{what[1:]}", keys, kind.needed)


def _amplitudes() -> dict[str, str]:
    """Names of the excitation's amplitude, and of the frequency, with what each is."""
    found = {
        letter: f"amplitude of the excitation, {SI[kind]}, where it is {'base' if word in OF_A_BASE else word!r}"
        for word, (letter, kind) in EXCITED.items()
    }
    found["F_0"] = "dimensionless amplitude of the excitation of [isolator] and [duffing]"
    return found | {
        "f": f"frequency of a [mount] or [spring], {SI['frequency']}",
        "Omega": "frequency over that of the mass on k_v",
    }


def _arguments(questions: Iterable[str]) -> tuple[str, ...]:
    """Keys of [ask] that some questions read; of tolerances amplitudes and frequencies."""
    takes = frozenset[str]().union(*(QUESTIONS[name] for name in questions if name not in TABLES))
    if "tolerances" in questions:
        takes |= {"F_0", "Omega"}
    forcing = [key for key in _amplitudes() if key not in FREQUENCIES] if "F_0" in takes else []
    return (
        *forcing,
        *(FREQUENCIES if "Omega" in takes else ()),
        *(key for key in ("window", "samples", "level_dB", "A_max") if key in takes),
    )


def _ask(keys: Iterable[str]) -> Schema:
    amplitudes = {key: _list(AMPLITUDE if key in OF_MOUNT else POSITIVE, text) for key, text in _amplitudes().items()}
    ends = {"type": "array", "items": {**QUANTITY, "minimum": 0}, "minItems": 2, "maxItems": 2}
    known = amplitudes | {
        "window": {"description": "ends of the frequencies of a response, in the unit of these", **ends},
        "samples": {"description": "approximate number of points of a response", "type": "integer", "minimum": 2},
        "level_dB": _list({"type": "number", "maximum": 0}, COLUMNS["level_dB"].text),
        "A_max": {**AMPLITUDE, "description": "largest amplitude of fold locus, cusps and isola points"},
        "questions": _list({"enum": list(QUESTIONS)}, "questions to compute; nothing else is computed"),
    }
    return _object("Forcings and frequencies of the questions", {key: known[key] for key in keys})


def _tables() -> tuple[str, ...]:
    return tuple(dict.fromkeys(TABLES.values()))


def _numbers() -> tuple[str, ...]:
    """Numbers of oscillators that may vary."""
    return tuple(dict.fromkeys(key for kind in KINDS.values() for key in kind.keys if key not in NO_NUMBERS))


def _table(name: str) -> Schema:
    """One of those that a question needs."""
    if name == "tolerances":
        fraction: Schema = {"type": "number", "minimum": 0, "exclusiveMaximum": 1}
        return _object("Relative tolerances of parameters", dict.fromkeys(_numbers(), fraction))
    if name == "spectrum":
        return _object(
            "Tones, one at a time: pairs", {key: _list(AMPLITUDE, one) for key, one in _amplitudes().items()}
        )
    if name == "psd":
        keys = {key: _list(POSITIVE, one) for key, one in _amplitudes().items() if key in FREQUENCIES}
        keys["G"] = _list(POSITIVE, "one-sided spectral density at these, linear in log-log between them")
        keys["unit"] = {"description": "of a mount's G", "enum": list(DENSITIES)}
        return _object("A power spectral density", keys, ["G"])
    texts = {key: f"{COLUMNS[key].text}; of a mount in {SI[OF_MOUNT[key]]}" for key in OF_A_PULSE}
    texts |= dict.fromkeys(("t", "tau"), "instead of a duration: times of samples of the acceleration")
    keys = {key: _list(QUANTITY, text) for key, text in texts.items()}
    return _object("Half sines of the base, every pair of these, or a record", keys, ["acceleration"])


def _requirements() -> Schema:
    limit = {"type": ["number", "string"], "description": "a number in SI units, or one with a unit, as '20 mm'"}
    known: dict[str, Schema] = {name: {"const": "none"} for name in NONE}
    starts = {f"from_{key}": AMPLITUDE for key in FREQUENCIES}
    known[TRANSMISSIBILITY] = _object("", {"below": {"type": "number", "maximum": 0}, **starts}, ["below"])
    for name, cases in AMOUNTS.items():
        keys = {"below": limit, "under": _list({"enum": list(cases)}), "rms": {"type": "boolean"}}
        known[name] = _object("", {**keys, "duration": AMPLITUDE}, ["below", "under"])
    return _object("What must hold", known)
