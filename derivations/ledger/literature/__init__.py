"""What others published, one file a publication, typed by hand from a text that is named there, errors included.

In:  published texts, typed by hand; a file here imports this one and nothing else of the project. What was measured is
     a table of the same name, whose head has its source.
Out: `Publication`, `Formula` and `Claim`, its form; `all_publications()`, every one of this folder.

A formula is a function over a namespace `xp` with integer literals only, as in published.py: a relation returns
lhs - rhs. Correct nothing here: `ledger/against` has what the derivation has in its place, and the verdict follows.
A formula for which no text was found is not typed in.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Formula:
    """Where it stands, what it gives, and the transcription."""

    where: str
    quantity: str
    function: Callable[..., Any]


@dataclass(frozen=True)
class Claim:
    """A sentence that a computation can decide; '...' marks an omission."""

    id: str
    where: str
    sentence: str


@dataclass(frozen=True)
class Publication:
    """What a file states.

    name     -- the file's
    title    -- what it is about, for a heading
    citation -- of the publication
    read_in  -- the text that it was typed from, where that is another
    formulas, claims -- in its order
    """

    name: str
    title: str
    citation: str
    read_in: str
    formulas: tuple[Formula, ...]
    claims: tuple[Claim, ...] = ()


def all_publications() -> list[Publication]:
    """By name."""
    names = sorted(module.name for module in pkgutil.iter_modules(__path__))
    return [importlib.import_module(f"{__name__}.{name}").PUBLICATION for name in names]
