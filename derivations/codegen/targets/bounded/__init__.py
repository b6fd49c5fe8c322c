"""Kernels in double-double with a bound of their error: a C header for each module with any, and Carlson's series.

In:  `Module`s with the straight-line code of their kernels; of these the kernels that are `bounded`.
Out: a dict from file name (below `generated/`) to text.

The C calls native/bounded.h and native/carlson.h, which are runtime code. Closed forms that divide by what may be small
are evaluated so: a proof by doubles takes the doubles around the result, an answer's last digits the result itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import sympy as sp

from ....forces.elliptic import Series, carlson
from ...form import Module
from ...passes import straight_line
from ...views import Code, Line, templates, view
from .. import interval
from ..c.printer import CPrinter
from .printer import BoundedPrinter

C = BoundedPrinter()
#: what the template, which is that of intervals, says of them
ABOUT = {
    "number": "sf_bounded",
    "inline": "static inline",
    "arithmetic": "carlson",
    "how": "in double-double with a bound of the error",
    "meaning": "`out` takes the outputs, where there are several.",
}


def files(modules: Sequence[Module], code: dict[str, Code]) -> dict[str, str]:
    """Every file."""
    integrals = templates(Path(__file__).parent).get_template("carlson.h.jinja")
    result = {"native/bounded_carlson.h": integrals.render(series=[printed(one) for one in carlson()])}
    for module in modules:
        if module.bounded:
            kernels = [view(kernel, code[module.name][kernel.name], C) for kernel in module.bounded]
            name = name_of(module)
            result[f"native/{name}.h"] = interval.header_of(module, name, kernels, {}, **ABOUT)
    return result


def name_of(module: Module) -> str:
    """Of a module's functions, and of their file."""
    return f"{module.name}_bounded"


def printed(series: Series) -> dict[str, object]:
    """A series for the template."""
    names = series.symmetric
    in_doubles = {symbol: sp.Symbol(f"e{number}") for number, symbol in enumerate(names, start=2)}
    program = straight_line(series.lets, [*names, series.first], series.arguments)
    rest = straight_line([], [series.rest.subs(in_doubles)], in_doubles.values())
    show = CPrinter().doprint
    return {
        "name": series.name,
        "power": str(series.power),
        "lets": [Line(symbol.name, C.doprint(value)) for symbol, value in program.lets],
        "symmetric": [C.doprint(value) for value in program.outputs[:-1]],
        "names": [symbol.name for symbol in in_doubles.values()],
        "first": C.doprint(program.outputs[-1]),
        "rest_lets": [Line(symbol.name, show(value)) for symbol, value in rest.lets],
        "rest": show(rest.outputs[0]),
    }
