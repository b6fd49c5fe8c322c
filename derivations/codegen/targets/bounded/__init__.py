"""Kernels in double-double with a bound of their error, printed for `generic`, and Carlson's series.

In:  `Module`s with the straight-line code of their kernels.
Out: `KernelView`s of C; the series' file by its name (below `generated/`).

Closed forms that divide by what may be small are evaluated so: a proof by doubles takes the doubles around the result,
an answer's last digits the result itself.
"""

from __future__ import annotations

from pathlib import Path

import sympy as sp

from ....forces.elliptic import Series, carlson
from ...form import Module
from ...passes import straight_line
from ...views import Code, KernelView, Line, templates, view
from ..c.printer import CPrinter
from ..calls import CALLS


def files() -> dict[str, str]:
    """The series."""
    integrals = templates(Path(__file__).parent).get_template("carlson.h.jinja")
    return {"native/bounded_carlson.h": integrals.render(series=[printed(one) for one in carlson()])}


def in_c(module: Module, code: Code) -> list[KernelView]:
    """The kernels in C, printed."""
    return [view(kernel, code[kernel.name], CALLS) for kernel in module.on("bounded")]


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
        "lets": [Line(symbol.name, CALLS.doprint(value)) for symbol, value in program.lets],
        "symmetric": [CALLS.doprint(value) for value in program.outputs[:-1]],
        "names": [symbol.name for symbol in in_doubles.values()],
        "first": CALLS.doprint(program.outputs[-1]),
        "rest_lets": [Line(symbol.name, show(value)) for symbol, value in rest.lets],
        "rest": show(rest.outputs[0]),
    }
