"""All that is generated, in every language.

In:  `Module`s.
Out: a dict from file name (below `generated/`) to text.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..form import Module
from ..views import programs
from . import ball, bounded, c, generic, interval, numpy, pair, ufunc


def render(modules: Sequence[Module]) -> dict[str, str]:
    """All files but the manifest and the ledger."""
    code = {module.name: programs(module) for module in modules}
    languages = (numpy, c, generic, interval, ball)
    files = {name: text for language in languages for name, text in language.files(modules, code).items()}
    return files | pair.files() | bounded.files() | ufunc.files(modules)
