"""In: the public modules, docs/api.toml. Out: docs/api.md, every public name with its signature, its words, an example.

    python -m docs.api

Annotations of arguments are left out: a docstring says what an argument is.
"""

from __future__ import annotations

import dataclasses
import inspect
import re
import tomllib
from collections.abc import Iterator
from enum import Enum
from functools import cached_property
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

PAGE = Path(__file__).with_name("api.md")
#: examples by module and name, and under "begin" the lines that they begin with
EXAMPLES: dict[str, Any] = tomllib.loads(PAGE.with_suffix(".toml").read_text(encoding="utf-8"))

#: the public modules, in the order of the page
MODULES = (
    "slowflow",
    "slowflow.physical",
    "slowflow.quantities",
    "slowflow.oscillator",
    "slowflow.table",
    "slowflow.designs",
    "slowflow.questions",
    "slowflow.composed",
    "slowflow.averaged.questions",
    "slowflow.results",
    "slowflow.certificate",
    "slowflow.off_centre.questions",
    "slowflow.off_centre.many",
    "slowflow.off_centre.answers",
    "slowflow.gradient",
    "slowflow.answer",
    "slowflow.checks",
    "slowflow.batch_checks",
    "slowflow.measured.validity",
    "slowflow.averaged.many",
    "slowflow.averaged.batches",
    "slowflow.averaged.queries",
    "slowflow.grid",
    "slowflow.grid.designs",
    "slowflow.sizing",
    "slowflow.sizing.tolerances",
    "slowflow.sizing.requirements",
    "slowflow.sizing.fitting",
    "slowflow.progress",
    "slowflow.scenes",
    "slowflow_kernels.conventions",
    "slowflow.averaged.plan",
    "slowflow.random_vibration.answers",
    "slowflow.second",
    "slowflow.second.answers",
    "slowflow.second.many",
    "slowflow.exact",
    "slowflow.exact.shocks_many",
    "slowflow.transmissibility",
    "slowflow.mechanism",
    "slowflow.derive",
    "slowflow.example",
)
HEAD = """# API

Every public name, its signature, first lines of its docstring, an example; `help(name)` has the rest. All quantities
are dimensionless but in `slowflow.physical`. Written by `python -m docs.api`, and held to the code by a test.

Examples begin with these lines, those of their module, and `from module import` what they use of it:
"""


def public(module: ModuleType) -> Iterator[tuple[str, Any]]:
    """The classes and functions that a module lists, or, without a list, that it defines."""
    listed = getattr(module, "__all__", None)
    for name in listed or vars(module):
        value = getattr(module, name)
        here = listed or getattr(value, "__module__", "") == module.__name__
        if here and not name.startswith("_") and (inspect.isclass(value) or inspect.isfunction(value)):
            yield name, value


def signature(function: Any, bound: bool) -> str:
    """Arguments with their defaults, and the annotation of what is returned."""
    told = inspect.signature(function)
    arguments = [one.replace(annotation=inspect.Parameter.empty) for one in told.parameters.values()]
    returned = told.return_annotation
    # where a class lives within its module differs from Python to Python
    shown = (
        ""
        if returned in (inspect.Signature.empty, "None")
        # of the types that say which numbers it has, an answer in SI units is none when a program runs
        else re.sub(r"\banswers\.\w+", "Quantities", f" -> {returned}".replace("pathlib._local.", "pathlib."))
    )
    return str(told.replace(parameters=arguments[bound:], return_annotation=inspect.Signature.empty)) + shown


def summary(thing: Any) -> str:
    """The first paragraph of a docstring, on one line."""
    return " ".join((inspect.getdoc(thing) or "").partition("\n\n")[0].split())


def members(kind: type) -> Iterator[tuple[str, str, str]]:
    """The public methods and properties that a class adds to its bases: name, how it is called, what it says."""
    for name, value in sorted(vars(kind).items()):
        if name.startswith("_"):
            continue
        if isinstance(value, (property, cached_property)):
            yield name, name, summary(value)
        elif isinstance(value, (classmethod, staticmethod)):
            yield name, name + signature(value.__func__, isinstance(value, classmethod)), summary(value.__func__)
        elif inspect.isfunction(value):
            yield name, name + signature(value, True), summary(value)


def heading(name: str, value: Any) -> Iterator[str]:
    """How a function or class is called, or what a record or a table has; what it is a case of and says of itself."""
    if dataclasses.is_dataclass(value):
        yield f"{name}: " + ", ".join(f"`{field.name}`" for field in dataclasses.fields(value) if field.name[0] != "_")
    elif inspect.isclass(value) and issubclass(value, Enum):
        yield f"{name}: " + ", ".join(f"`{member.name}` {member.value}" for member in value)
    elif inspect.isclass(value) and issubclass(value, Exception):
        yield f"`{name}`"
    else:
        yield f"`{name}{signature(value, False)}`"
    bases = [base.__name__ for base in getattr(value, "__bases__", ()) if base.__module__.startswith("slowflow")]
    yield from ("", f"Also all of {' and '.join(bases)}.") if bases else ()
    yield from ("", summary(value), "")


def own(path: str) -> Iterator[tuple[str, Any]]:
    """What is told of at this module: its names but those of another public module."""
    for name, value in public(import_module(path)):
        if value.__module__ == path or value.__module__ not in MODULES:
            yield name, value


def told() -> Iterator[tuple[str, str]]:
    """Module and name of all that the page tells of, a class's methods as "Class.method"."""
    for path in MODULES:
        for name, value in own(path):
            yield path, name
            yield from ((path, f"{name}.{member}") for member, *_ in (members(value) if inspect.isclass(value) else ()))


def block(code: str) -> list[str]:
    """Lines of Python, as Markdown has them."""
    return ["```python", code.strip(), "```", ""]


def text() -> str:
    """The page."""
    lines = [HEAD, *block(EXAMPLES["begin"])]
    for path in MODULES:
        module = import_module(path)
        lines += [f"## {path}", "", summary(module), ""]
        examples = EXAMPLES.get(path, {})
        lines += block(examples["begin"]) if "begin" in examples else []
        here = dict(own(path))
        others = [name for name, _ in public(module) if name not in here]
        lines += [f"Also here: {', '.join(f'`{name}`' for name in others)}.", ""] if others else []
        for name, value in here.items():
            lines += [f"### {name}", "", *heading(name, value), *block(examples[name])]
            for member, called, said in members(value) if inspect.isclass(value) else ():
                lines.append(f"- `{called}`: {said} Example: `{examples[f'{name}.{member}']}`")
            lines += [""] if lines[-1] else []
    return "\n".join(lines).rstrip() + "\n"


if __name__ == "__main__":
    PAGE.write_text(text(), encoding="utf-8")
