"""In: the public modules. Out: docs/api.md, every public name with its signature and what it says of itself.

    python -m docs.api

Annotations of arguments are left out: a docstring says what an argument is.
"""

from __future__ import annotations

import dataclasses
import inspect
from collections.abc import Iterator
from enum import Enum
from functools import cached_property
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

PAGE = Path(__file__).with_name("api.md")

#: the public modules, in the order of the page
MODULES = (
    "slowflow",
    "slowflow.physical",
    "slowflow.oscillator",
    "slowflow.averaged.questions",
    "slowflow.results",
    "slowflow.off_centre.questions",
    "slowflow.off_centre.many",
    "slowflow.off_centre.answers",
    "slowflow.gradient",
    "slowflow.answer",
    "slowflow.loads",
    "slowflow.loads_many",
    "slowflow.measured.validity",
    "slowflow.averaged.many",
    "slowflow.grid.designs",
    "slowflow.sizing",
    "slowflow.sizing.tolerances",
    "slowflow.sizing.requirements",
    "slowflow.sizing.fitting",
    "slowflow.progress",
    "slowflow.scenes",
    "slowflow_kernels.conventions",
    "slowflow.averaged.plan",
    "slowflow.second",
    "slowflow.second.many",
    "slowflow.exact",
    "slowflow.exact.shocks",
    "slowflow.mechanism",
    "slowflow.derive",
    "slowflow.paper.example",
)
HEAD = """# API

Every public name, its signature, and the first lines of its docstring; `help(name)` has the rest. All quantities are
dimensionless but in `slowflow.physical`. Written by `python -m docs.api`, and held to the code by a test.
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
    shown = "" if returned in (inspect.Signature.empty, "None") else f" -> {returned}"
    return str(told.replace(parameters=arguments[bound:], return_annotation=inspect.Signature.empty)) + shown


def summary(thing: Any) -> str:
    """The first paragraph of a docstring, on one line."""
    return " ".join((inspect.getdoc(thing) or "").partition("\n\n")[0].split())


def members(kind: type) -> Iterator[tuple[str, str]]:
    """The public methods and properties that a class adds to its bases: how they are called, what they say."""
    for name, value in sorted(vars(kind).items()):
        if name.startswith("_"):
            continue
        if isinstance(value, (property, cached_property)):
            yield name, summary(value)
        elif isinstance(value, (classmethod, staticmethod)):
            yield name + signature(value.__func__, isinstance(value, classmethod)), summary(value.__func__)
        elif inspect.isfunction(value):
            yield name + signature(value, True), summary(value)


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


def text() -> str:
    """The page."""
    lines = [HEAD]
    for path in MODULES:
        module = import_module(path)
        lines += [f"## {path}", "", summary(module), ""]
        own = [
            (name, value)
            for name, value in public(module)
            if value.__module__ == path or value.__module__ not in MODULES
        ]
        others = [name for name, value in public(module) if (name, value) not in own]
        lines += [f"Also here: {', '.join(f'`{name}`' for name in others)}.", ""] if others else []
        for name, value in own:
            lines += [f"### {name}", "", *heading(name, value)]
            listed = [f"- `{called}`: {said}" for called, said in members(value)] if inspect.isclass(value) else []
            lines += [*listed, ""] if listed else []
    return "\n".join(lines).rstrip() + "\n"


if __name__ == "__main__":
    PAGE.write_text(text(), encoding="utf-8")
