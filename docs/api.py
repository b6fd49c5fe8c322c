"""The public modules, their names, and the example of each (docs/api.toml): from these the site's reference is made."""

from __future__ import annotations

import inspect
import tomllib
from collections.abc import Iterator
from functools import cached_property
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

#: examples by module and name, and under "begin" the lines that they begin with
EXAMPLES: dict[str, Any] = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))

#: the public modules, in the order of the reference
MODULES = (
    "slowflow",
    "slowflow.oscillators.physical",
    "slowflow.oscillators.physical_designs",
    "slowflow.oscillators.physical_grid",
    "slowflow.answers.quantities",
    "slowflow.oscillators.measurements",
    "slowflow.oscillators.oscillator",
    "slowflow.answers.table",
    "slowflow.grid.many",
    "slowflow.answers.questions",
    "slowflow.averaged.composed",
    "slowflow.averaged.questions",
    "slowflow.answers.results",
    "slowflow.answers.certificate",
    "slowflow.off_centre.questions",
    "slowflow.off_centre.many",
    "slowflow.off_centre.answers",
    "slowflow.answers.gradient",
    "slowflow.answers.answer",
    "slowflow.averaged.checks",
    "slowflow.answers.validity",
    "slowflow.averaged.many",
    "slowflow.averaged.batches",
    "slowflow.grid.designs",
    "slowflow.sizing",
    "slowflow.sizing.tolerances",
    "slowflow.sizing.requirements",
    "slowflow.sizing.fitting",
    "slowflow.sizing.loops",
    "slowflow.support.progress",
    "slowflow.app.scenes",
    "slowflow_kernels.conventions",
    "slowflow.averaged.plan",
    "slowflow.random_vibration.answers",
    "slowflow.second",
    "slowflow.second.answers",
    "slowflow.second.many",
    "slowflow.exact",
    "slowflow.answers.transmissibility",
    "slowflow.core.mechanism",
    "slowflow.derive",
    "slowflow.languages",
    "slowflow.example",
)


def public(module: ModuleType) -> Iterator[tuple[str, Any]]:
    """The classes and functions that a module lists, or, without a list, the classes that it defines."""
    listed = getattr(module, "__all__", None)
    for name in listed or vars(module):
        value = getattr(module, name)
        if inspect.isclass(value) and (listed or value.__module__ == module.__name__) and name[0] != "_":
            yield name, value
        elif inspect.isfunction(value) and listed:
            yield name, value


def home(name: str, value: Any) -> str:
    """The module on whose page a public name is: that which defines it, or the first that lists it."""
    modules = (path for path in (value.__module__, *MODULES) if path in MODULES)
    return next(path for path in modules if (name, value) in public(import_module(path)))


def members(kind: type) -> Iterator[tuple[str, Any]]:
    """The public methods and properties that a class adds to its bases."""
    for name, value in sorted(vars(kind).items()):
        if isinstance(value, (property, cached_property, classmethod, staticmethod)) or inspect.isfunction(value):
            if not name.startswith("_"):
                yield name, value


def names() -> Iterator[tuple[str, str, Any]]:
    """Module, name and value of all that is public, once each; a class's methods as "Class.method"."""
    for path in MODULES:
        for name, value in public(import_module(path)):
            if home(name, value) == path:
                yield path, name, value
                if inspect.isclass(value):
                    yield from ((path, f"{name}.{member}", of) for member, of in members(value))


def block(code: str) -> list[str]:
    """Lines of Python in Markdown."""
    return ["```python", code.strip(), "```", ""]
