"""The form of what is published: a formula is a function whose docstring says first where it stands and what it gives.

    (31): dH_2/dA [fourth term 6 q A^-1 u_cr]. Derivative of (22).

In:  a module that states formulas; of several readings of a damaged text each is a function, its reading in brackets.
Out: `Formula`, `Claim`; `formulas` and `claims`, all that are stated, in their order.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

HEAD = re.compile(r"(.+?): (.+?)(?: \[(.+?)\])?\.(?=\s|$)")


@dataclass(frozen=True)
class Formula:
    """Where it stands, what it gives, the transcription, and which reading of the text it is."""

    where: str
    quantity: str
    function: Callable[..., Any]
    reading: str = ""

    @property
    def name(self) -> str:
        """Of the function."""
        return str(self.function.__name__)


@dataclass(frozen=True)
class Claim:
    """A sentence that a computation can decide; '...' marks an omission."""

    id: str
    where: str
    sentence: str


def formulas(module: Mapping[str, Any]) -> tuple[Formula, ...]:
    """Every public function of a module, by its names."""
    found = []
    for name, function in module.items():
        if inspect.isfunction(function) and function.__module__ == module["__name__"] and not name.startswith("_"):
            head = HEAD.match(inspect.getdoc(function) or "")
            if not head:
                raise ValueError(f"{name}: the docstring must begin with 'where: quantity [reading].'")
            found.append(Formula(head[1], head[2], function, head[3] or ""))
    return tuple(found)


def claims(sentences: Mapping[str, Mapping[str, str]]) -> tuple[Claim, ...]:
    """Sentences by place and id."""
    return tuple(Claim(name, where, sentence) for where, of in sentences.items() for name, sentence in of.items())
