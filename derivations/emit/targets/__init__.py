"""The target languages, one folder each: a printer, templates, and `files`, which fills them.

In:  `Module`s.
Out: a dict from file name (below `generated/`) to text, and for the manifest the operation counts of each kernel.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..form import Module
from ..views import operations, programs
from . import c, interval, numpy, pair, ufunc


def render(modules: Sequence[Module]) -> tuple[dict[str, str], dict[str, dict[str, object]]]:
    """All files but the manifest and the ledger, and the kernels' entries in the manifest."""
    code = {module.name: programs(module) for module in modules}
    counts = {
        module.name: {kernel.name: operations(kernel, code[module.name][kernel.name]) for kernel in module.kernels}
        for module in modules
    }
    languages = (numpy, c, interval, pair)
    files = {name: text for language in languages for name, text in language.files(modules, code).items()}
    return files | ufunc.files(modules), counts
