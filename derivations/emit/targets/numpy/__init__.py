"""NumPy: a Python module for each generated module, and the package around them.

In:  `Module`s with the straight-line code of their kernels.
Out: a dict from file name (below `generated/`) to text.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import sympy as sp

from derivations.emit.form import AVERAGED, Module
from derivations.emit.provenance import tools
from derivations.emit.targets.numpy.printer import NumpyPrinter
from derivations.emit.views import Calls, Code, Language, composition_view, regimes, sources, templates, view

LANGUAGE = Language(NumpyPrinter(), conjunction=" & ", wrap_in_parentheses=True, names={})
CALLS = Calls("flow.friction(mu)", "flow.{}".format, tuple("average" + symbol.name[1:] for symbol in AVERAGED))
#: of the package itself, by template
PACKAGE = {"__init__.py": "init.py.jinja", "_broadcast.py": "broadcast.py.jinja", "_backend.py": "backend.py.jinja"}


def files(modules: Sequence[Module], code: dict[str, Code]) -> dict[str, str]:
    """Every file of this language."""
    environment = templates(Path(__file__).parent)
    result = {}
    for module in modules:
        result[f"slowflow_kernels/{module.name}.py"] = environment.get_template("module.py.jinja").render(
            module=module,
            kernels=[view(kernel, code[module.name][kernel.name], LANGUAGE) for kernel in module.kernels],
            compositions=[composition_view(composition, CALLS) for composition in module.compositions],
            exported=exported(module),
            regimes=regimes(module),
            imported=sorted(module.reexports[1], key=in_import),
            constants={name: constant(value) for name, value in module.constants.items()},
            tools=tools(),
            **sources(module),
        )
    for name, template in PACKAGE.items():
        result[f"slowflow_kernels/{name}"] = environment.get_template(template).render(modules=modules)
    return result


def exported(module: Module) -> list[str]:
    """Public names of a Python module, sorted as in an import."""
    own = [
        *module.constants,
        *module.pieces,
        *(kernel.name for kernel in module.kernels),
        *(c.name for c in module.compositions),
    ]
    return sorted({*module.reexports[1], *own}, key=in_import)


def in_import(name: str) -> tuple[bool, bool, str]:
    """Where a name stands in an import: constants, then what begins with a capital, then the rest."""
    return not (name.isupper() and len(name) > 1), not name[0].isupper(), name


def constant(value: object) -> str:
    """A module constant as Python source."""
    if isinstance(value, sp.Expr):
        return 'float("inf")' if value == sp.oo else repr(float(value))
    if isinstance(value, tuple):
        items = ", ".join(f'"{item}"' for item in value)
        return f"({items}{',' if len(value) == 1 else ''})"
    return f'"{value}"'
