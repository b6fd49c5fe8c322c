"""What others published, one file a publication, typed by hand from a text that is named there, errors included.

In:  published texts, typed by hand; a file here imports nothing of the project. What was measured is a table of the
     same name, whose head has its source.
Out: `Publication`, one for each file; `all_publications()`, every one of this folder.

A file has TITLE, what it is about, for a heading; CITATION; READ_IN, the text that it was typed from, where that is
another; CLAIMS, sentences by place and id; and its formulas, each a function over a namespace `xp` with integer
literals only, as in published.py: a relation returns lhs - rhs. Correct nothing here: `ledger/against` has what the
derivation has in its place, and the verdict follows. A formula for which no text was found is not typed in.
"""

from __future__ import annotations

import importlib
import pkgutil
from dataclasses import dataclass
from types import ModuleType

from ..statements import Claim, Formula, claims, formulas


@dataclass(frozen=True)
class Publication:
    """What a file states, in its order."""

    module: ModuleType

    @property
    def name(self) -> str:
        """The file's."""
        return self.module.__name__.rpartition(".")[2]

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """All of them."""
        return formulas(vars(self.module))

    @property
    def claims(self) -> tuple[Claim, ...]:
        """All of them."""
        return claims(getattr(self.module, "CLAIMS", {}))


def all_publications() -> list[Publication]:
    """By name."""
    names = sorted(module.name for module in pkgutil.iter_modules(__path__))
    return [Publication(importlib.import_module(f"{__name__}.{name}")) for name in names]
