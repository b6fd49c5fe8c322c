"""Kernels in balls, for proofs with as many digits as they take: a Python module for each module that has any.

In:  `Module`s with the straight-line code of their kernels.
Out: a dict from file name (below `generated/`) to text.

The Python calls python-flint, which not everyone has: nothing else imports these modules. A series cut short for a
double is left out, as with pairs; so is the choice between regimes, which a caller makes.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...form import Module
from ...views import Code, view
from .. import interval
from ..pair import closed
from .printer import BallPrinter

#: what the template, which is that of intervals, says of balls
ABOUT = {
    "how": "in balls",
    "meaning": "Arguments are `flint.arb`, or numbers that are exact; each output holds the value of the function of "
    "the same name, to the digits of `flint.ctx`. passed_n is meant where A exceeds n breakpoints; beyond: by how much "
    "it exceeds the last of these.",
}
PYTHON = BallPrinter()


def files(modules: Sequence[Module], code: dict[str, Code]) -> dict[str, str]:
    """Every file."""
    integrals = "from slowflow.support.balls import R_D, R_F"
    return {
        f"slowflow_kernels/{module.name}_balls.py": interval.module_of(
            module,
            [view(*closed(kernel, code[module.name]), PYTHON) for kernel in module.on("balls")],
            imports=["from flint import arb", *([integrals] if module.on("bounded") else [])],
            **ABOUT,
        )
        for module in modules
        if module.on("balls")
    }
