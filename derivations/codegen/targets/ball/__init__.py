"""Kernels in balls, for proofs with as many digits as they take: a Python module for each module that has any.

In:  `Module`s with the straight-line code of their kernels; of these the kernels that say `paired`, and `balls`.
Out: a dict from file name (below `generated/`) to text.

The Python calls python-flint, which not everyone has: nothing else imports these modules. A series cut short for a
double is left out, as with pairs; so is the choice between regimes, which a caller makes.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from ...form import Module
from ...provenance import tools
from ...views import Code, Language, sources, templates, view
from ..pair import closed
from .printer import BallPrinter

PYTHON = Language(BallPrinter(), conjunction=" and ", wrap_in_parentheses=True, names={})


def files(modules: Sequence[Module], code: dict[str, Code]) -> dict[str, str]:
    """Every file."""
    template = templates(Path(__file__).parent).get_template("module.py.jinja")
    result = {}
    for module in modules:
        if module.in_balls:
            result[f"slowflow_kernels/{module.name}_balls.py"] = template.render(
                kernels=[view(*closed(kernel, code[module.name]), PYTHON) for kernel in module.in_balls],
                module=module,
                tools=tools(),
                **sources(module),
            )
    return result
