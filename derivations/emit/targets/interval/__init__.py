"""Kernels on whole intervals of their arguments: a C header for each module that has any.

In:  `Module`s with the straight-line code of their kernels; of these the kernels that say `enclosed`, and `cells`.
Out: a dict from file name (below `generated/`) to text.

What is written calls native/interval.h, which is runtime code.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from derivations.emit.form import Module
from derivations.emit.provenance import tools
from derivations.emit.targets.interval.printer import IntervalPrinter
from derivations.emit.views import Code, Language, sources, templates, view

LANGUAGE = Language(IntervalPrinter(), conjunction=" && ", wrap_in_parentheses=False, names={"I": "I_"})


def files(modules: Sequence[Module], code: dict[str, Code]) -> dict[str, str]:
    """Every file of this language."""
    template = templates(Path(__file__).parent).get_template("header.h.jinja")
    result = {}
    for module in modules:
        enclosed = [*(kernel for kernel in module.kernels if kernel.enclosed), *module.cells]
        for kernel in enclosed:
            if len(kernel.branches) != 1 or kernel.parameters:
                raise NotImplementedError(f"{kernel.name}: a kernel by cases or of a mechanism, on intervals")
        if enclosed:
            result[f"native/{module.name}_intervals.h"] = template.render(
                module=module,
                kernels=[view(kernel, code[module.name][kernel.name], LANGUAGE) for kernel in enclosed],
                tools=tools(),
                **sources(module),
            )
    return result
