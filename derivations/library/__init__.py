"""Mechanisms from the literature, one file each, derived when a program asks for one: `slowflow.derive.library(name)`.

In:  the files of this folder, each in the form of `mechanisms/`, or a `Sided` where the force is not odd.
Out: `names()`, and `stated(name)`, the `Mechanism` or `Sided`.

Nothing of them is generated or compiled beforehand: those in `mechanisms/` come with the package, these take a second.
"""

from __future__ import annotations

import importlib
import pkgutil

from slowflow.support.errors import Refused

from ..asymmetric.sided import Sided
from ..mechanisms import Mechanism


def names() -> list[str]:
    """Of all that is here."""
    return sorted(module.name for module in pkgutil.iter_modules(__path__))


def stated(name: str) -> Mechanism | Sided:
    """The mechanism of that name; ValueError if there is none, with the names that there are."""
    if name not in names():
        raise Refused(f"{name!r} is not in the library: it has {', '.join(names())}")
    mechanism: Mechanism | Sided = importlib.import_module(f"{__name__}.{name}").MECHANISM
    return mechanism
