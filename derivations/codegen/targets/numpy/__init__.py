"""NumPy: a Python module for each generated module, and the package around them.

In:  `Module`s with the straight-line code of their kernels.
Out: a dict from file name (below `generated/`) to text.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import jinja2
import sympy as sp

from ....mechanisms import CONTACTS, DAMPING, DISSIPATION, EXCITATIONS, Parameter
from ... import measured
from ...common import with_calls
from ...form import AVERAGED, Composition, Kernel, Module, Selection
from ...prose import in_python
from ...views import (
    WIDTH,
    Calls,
    Code,
    composition_view,
    heading,
    regimes,
    repeated_views,
    tables,
    templates,
    view,
    wrapped,
)
from ..interval.printer import EnclosurePrinter
from ..printing import stated
from .printer import NumpyPrinter

if TYPE_CHECKING:
    from ....extensions.scaling import Scale

PRINTER = NumpyPrinter()
ENCLOSED = EnclosurePrinter()
CALLS = Calls("flow.friction(mu)", "flow.{}".format, tuple("average" + symbol.name[1:] for symbol in AVERAGED))


def files(modules: Sequence[Module], code: dict[str, Code]) -> dict[str, str]:
    """Every file of this language."""
    # here, not above: one module does without
    from ....extensions.scaling import of_every_excitation, of_every_law, of_every_oscillator
    from ...conventions import CONVENTIONS

    environment = _environment()
    result = {f"slowflow_kernels/{module.name}.py": text(module, code[module.name]) for module in modules}
    # what type checkers look for, before they believe a package's annotations
    result["slowflow_kernels/py.typed"] = ""
    result["slowflow_kernels/domains.py"] = environment.get_template("domains.py.jinja").render(
        damping=DAMPING, dissipation=DISSIPATION, contact=CONTACTS, excitations=EXCITATIONS
    )
    result["slowflow_kernels/scaling.py"] = environment.get_template("scaling.py.jinja").render(
        scales={number.name: scale for number, scale in (of_every_oscillator() | of_every_law()).items()},
        excited=of_every_excitation(),
    )
    for conventions in CONVENTIONS:
        width = max((len(word.name) for table in conventions.tables for word in table.entries), default=0)
        result[f"slowflow_kernels/{conventions.name}.py"] = environment.get_template("conventions.py.jinja").render(
            conventions=conventions, width=width, show=stated
        )
    result["slowflow_kernels/__init__.py"] = environment.get_template("init.py.jinja").render(modules=modules)
    return result


def contained(module: Module) -> tuple[Kernel, ...]:
    """The kernels that a module's text has."""
    return (*module.kernels, *module.on_intervals)


def printed(module: Module) -> tuple[Kernel, ...]:
    """The kernels but those that C alone sums and closes, or calls."""
    summed = {kernel.name for one in module.sums for kernel in (*one.terms, one.closing)}
    return tuple(kernel for kernel in module.kernels if kernel.in_python and kernel.name not in summed)


def text(module: Module, code: Code) -> str:
    """One module."""
    named = (*printed(module), *module.selections, *module.compositions)
    calls = with_calls(printed(module), code, PRINTER)
    views = [view(kernel, code[kernel.name], PRINTER, calls[kernel.name]) for kernel in printed(module)]
    return (
        _environment()
        .get_template("module.py.jinja")
        .render(
            module=module,
            kernels=views,
            tables=tables(views),
            repeated=repeated_views(code | calls, PRINTER, views),
            compositions=[composition_view(composition, CALLS) for composition in module.compositions],
            exported=exported(module),
            typed={one.name: signature(one) for one in named},
            regimes=regimes(module),
            measured=measured.of(module),
            enclosed=[view(kernel, code[kernel.name], ENCLOSED) for kernel in module.on_intervals],
            has_balls=module.native and bool(module.on("balls")),
            constants={name: constant(value) for name, value in module.constants.items()},
            compiled=module.native and any(one not in module.from_c for one in module.looped),
            heading=heading(module),
        )
    )


def signature(function: Kernel | Selection | Composition) -> str:
    """What stands behind its name: arguments and result with their types, for type checkers and editors."""
    return f"({taken(function)}) -> {returned(function)}"


def taken(function: Kernel | Selection | Composition) -> str:
    """Its arguments with what they may be: generic ones take any kind of number."""
    what = "ArrayLike" if getattr(function, "looped", True) and not getattr(function, "generic", False) else "Any"
    return ", ".join(f"{argument.name}: {what}" for argument in function.arguments)


def returned(function: Kernel | Selection | Composition) -> str:
    """What it returns."""
    if function.returns == "stack":
        return "Floats"
    if function.returns == "scalar":
        return "Any"
    return f"tuple[{', '.join(['Any'] * function.width) or '()'}]"


def _environment() -> jinja2.Environment:
    environment = templates(Path(__file__).parent)
    environment.filters["constant"] = constant
    environment.filters["wrapped"] = lambda value: wrapped(value, len("return"), PRINTER)
    environment.filters["parameter"] = parameter
    environment.filters["scale"] = scale
    return environment


def exported(module: Module) -> list[str]:
    """Public names of a Python module, sorted as in an import."""
    own = [
        *module.constants,
        *(one.name for one in (*printed(module), *module.from_c, *module.selections, *module.compositions)),
        *(["MECHANISM"] if module.record else []),
    ]
    return sorted((name for name in own if not name.startswith("_")), key=in_import)


def in_import(name: str) -> tuple[bool, bool, str]:
    """Where a name stands in an import: constants, then what begins with a capital, then the rest."""
    return not (name.isupper() and len(name) > 1), not name[0].isupper(), name


def constant(value: object) -> str:
    """A constant as Python source."""
    if isinstance(value, sp.Expr):
        return 'float("inf")' if value == sp.oo else repr(float(value))
    if isinstance(value, tuple):
        items = ", ".join(map(constant, value))
        return f"({items}{',' if len(value) == 1 else ''})"
    return f'"{in_python(str(value))}"'


def parameter(stated: Parameter) -> str:
    """The arguments of a record's `Parameter`."""
    bounds = {bound: getattr(stated, bound) for bound in ("above", "least", "below", "most")}
    texts = [constant(text) for text in (stated.symbol.name, stated.doc, stated.unit)]
    limits = [f"{bound}={constant(sp.sympify(limit))}" for bound, limit in bounds.items() if limit is not None]
    line = ", ".join((*texts, *limits))
    return line if len(line) + len("    Parameter(),") <= WIDTH else ",\n        ".join((*texts, *limits))


def scale(derived: Scale) -> str:
    """A record's `Scale`."""
    powers = ", ".join(repr(float(power)) for power in derived.powers)
    return f'Scale("{derived.letter.name}", {float(derived.factor)!r}, ({powers}))'
