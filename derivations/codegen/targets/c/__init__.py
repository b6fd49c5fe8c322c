"""C99: a header of inline functions for each generated module, the arctangent that they share, records and series.

In:  `Module`s with the straight-line code of their kernels.
Out: a dict from file name (below `generated/`) to text.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

import sympy as sp

from ....forces.quadrature import rule
from ... import measured
from ...arctangent import estrin, series
from ...common import with_calls
from ...conventions import CONVENTIONS
from ...form import Module
from ...views import (
    Calls,
    Code,
    KernelView,
    RepeatedView,
    composition_view,
    heading,
    regimes,
    repeated_views,
    tables,
    templates,
    twofold_view,
    view,
)
from ..printing import literal, stated
from ..shared import in_both
from . import records, taylor
from .printer import CPrinter

PRINTER = CPrinter()

#: of text on numbers of any kind: what arithmetic_*.h defines for a kind, and OF
MACROS = (
    "OF REAL KERNEL POINT CONSTANT ADD SUB MUL DIV TIMES NEG INVERSE SQUARE BY_SQUARE SQRT ATAN2 ATAN2_SWAPPED WITHIN"
).split()


def files(modules: Sequence[Module], code: dict[str, Code]) -> dict[str, str]:
    """Every file of this language."""
    environment = templates(Path(__file__).parent)
    result = {
        f"c/{name}.h": environment.get_template(f"{name}.h.jinja").render(macros=MACROS)
        for name in ("inline", "arithmetic_begin", "arithmetic_doubles", "arithmetic_end")
    }
    result["c/angles.h"] = environment.get_template("angles.h.jinja").render(**angles())
    with_symbols = headers(modules, code)
    result |= with_symbols | exported(with_symbols)
    # one text, whichever mechanism it is printed of
    (result["c/mechanism_generic.h"],) = {
        environment.get_template("mechanism_generic.h.jinja").render(
            selections=[one for one in module.selections if one.name in in_every_mechanism(modules)],
            compositions=[composition_view(composition, calls(module)) for composition in module.compositions],
        )
        for module in modules
        if module.compositions
    }
    for conventions in CONVENTIONS:
        result[f"native/{conventions.name}.h"] = environment.get_template("conventions.h.jinja").render(
            conventions=conventions, show=stated
        )
    result["native/records.h"] = records.text(modules)
    result["native/taylor.h"] = taylor.text(modules, environment)
    return result


def headers(modules: Sequence[Module], code: dict[str, Code]) -> dict[str, str]:
    """The header of each module."""
    environment, in_every = templates(Path(__file__).parent), in_every_mechanism(modules)
    result = {}
    for module in (one for one in modules if one.in_c):
        of_module = code[module.name]
        folder, both = in_both(module, of_module)
        included = {one.kernel.name for one in both} if folder == "c" else set()
        kernels = [one for one in module.kernels if one.in_c and one.name not in included]
        shared = with_calls(kernels, of_module, PRINTER)
        views = [view(one, of_module[one.name], PRINTER, shared[one.name]) for one in kernels]
        repeated = repeated_views(of_module | shared, PRINTER, views)
        result[f"c/{module.name}.h"] = environment.get_template("header.h.jinja").render(
            module=module,
            includes_generic=bool(included),
            kernels=views,
            repeated=repeated,
            twofolds=[twofold_view(kernel, PRINTER) for kernel in module.twofolds],
            selections=[one for one in module.selections if one.name not in in_every],
            includes=includes(module, views, repeated),
            regimes=regimes(module),
            numbers=numbers(module),
            tables=tables(views),
            measured=measured.of(module),
            rule=[(literal(node), literal(weight)) for node, weight in rule()] if module.sums else [],
            heading=heading(module),
        )
    return result


def in_every_mechanism(modules: Iterable[Module]) -> set[str]:
    """The names of what each module with compositions selects as one number of a tuple."""
    names = [{one.name for one in module.selections if one.width == 1} for module in modules if module.compositions]
    return set.intersection(*names) if names else set()


def exported(printed: Iterable[str]) -> dict[str, str]:
    """A source that gives each function of these headers a symbol, by file name."""
    names = [Path(file).stem for file in printed]
    template = templates(Path(__file__).parent).get_template("exported.c.jinja")
    return {str(Path(next(iter(printed))).with_name("exported.c")): template.render(names=names)}


def motion(module: Module) -> str:
    """A source with the recurrences of one force, for a library of its own."""
    return taylor.of_one(module, templates(Path(__file__).parent))


def calls(module: Module) -> Calls:
    """How a header's compositions call other functions."""
    return Calls(f"{module.flow}_friction(mu)", f"{module.flow}_{{}}".format, tuple(f"average[{k}]" for k in range(4)))


def includes(module: Module, views: Iterable[KernelView], repeated: Iterable[RepeatedView]) -> list[str]:
    """Headers of ours that a C header needs."""
    branches = [branch for view in views for branch in view.branches]
    lines = (line.value for one in (*branches, *repeated) for line in one.lets)
    outputs = (output for branch in branches for output in branch.outputs)
    angles = "angles" if any("angles_" in text for text in (*lines, *outputs)) else ""
    twofold = "twofold" if module.twofolds else ""
    quarter = "quarter" if module.sums else ""
    return [name for name in ("inline", angles, twofold, quarter, module.flow) if name]


def numbers(module: Module) -> dict[str, str]:
    """Numbers that every caller of a header needs; what a mechanism has of them stands in its record."""
    return {name: literal(value) for name, value in module.constants.items() if isinstance(value, sp.Expr)}


def angles() -> dict[str, object]:
    """What the arctangent's template needs."""
    polynomial = series()
    constants: dict[str, str] = {}
    for name, value in (("pi", sp.pi), ("half_pi", sp.pi / 2)):
        constants[name] = literal(value)
        constants[name + "_low"] = literal(value - sp.Rational(float(constants[name])))
    lines = estrin(tuple(literal(coefficient) for coefficient in polynomial.coefficients), "w")
    return {"lines": lines, "bound": f"{float(polynomial.bound):.2g}", **constants}
