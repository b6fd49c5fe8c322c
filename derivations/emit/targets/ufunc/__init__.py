"""Compiled ufuncs: loops over the functions of the C headers, one for each regime of the force.

In:  `Module`s.
Out: a dict from file name (below `generated/`) to text: `native/*.c`.

No formula is printed here: the loops call the headers. A generic kernel takes more than floats, so it has none.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from derivations.emit.form import Kernel, Module
from derivations.emit.provenance import tools
from derivations.emit.targets.c.printer import CPrinter
from derivations.emit.views import templates

# SF_MOST_OPERANDS in kernels.h
MOST_OPERANDS = 32


@dataclass(frozen=True)
class Loop:
    """The loop of one regime: its name and the statements for element i."""

    name: str
    body: tuple[str, ...]
    inputs: tuple[str, ...]

    @property
    def used(self) -> tuple[str, ...]:
        """Arguments that it reads."""
        text = " ".join(self.body)
        return tuple(name for name in self.inputs if re.search(rf"\b{name}\[i\]", text))


@dataclass(frozen=True)
class Ufunc:
    """A ufunc as the template needs it, with a loop for each regime; `guards` are those of all regimes but the last."""

    name: str
    prefix: str
    doc: str
    inputs: tuple[str, ...]
    outputs: int
    loops: tuple[Loop, ...]
    guards: tuple[str, ...]
    guard_names: tuple[str, ...]


def files(modules: Sequence[Module]) -> dict[str, str]:
    """Every file of this stage."""
    environment = templates(Path(__file__).parent)
    result = {}
    looped = [module for module in modules if module.loops]
    for module in looped:
        ufuncs = [of_kernel(kernel, module) for kernel in module.kernels if kernel.compiled]
        for ufunc in ufuncs:
            if len(ufunc.inputs) + ufunc.outputs > MOST_OPERANDS:
                raise ArithmeticError(f"{ufunc.prefix} has more than {MOST_OPERANDS} arguments and results")
        text = environment.get_template("module.c.jinja").render(module=module, ufuncs=ufuncs, tools=tools())
        result[f"native/{module.name}.c"] = text
    result["native/_native.c"] = environment.get_template("init.c.jinja").render(modules=looped)
    return result


def call(function: str, plain: Sequence[str], packed: Sequence[str], outputs: int, returns: str) -> tuple[str, ...]:
    """Statements that call a function of a header for element i and store its outputs."""
    arguments = [f"{name}[i]" for name in plain]
    before: list[str] = []
    if packed:
        before.append(f"const double p[] = {{{', '.join(f'{name}[i]' for name in packed)}}};")
        arguments.append("p")
    if returns == "scalar":
        return (*before, f"out_0[i] = {function}({', '.join(arguments)});")
    before.append(f"double values[{outputs}];")
    stores = [f"out_{k}[i] = values[{k}];" for k in range(outputs)]
    return (*before, f"{function}({', '.join([*arguments, 'values'])});", *stores)


def guards_of(kernel: Kernel) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Guards of a kernel's regimes in C, and the arguments that they read."""
    show = CPrinter().doprint
    texts, symbols = [], set()
    for branch in kernel.branches[:-1]:
        texts.append(" && ".join(f"{show(left)} <= {show(right)}" for left, right in branch.guards))
        symbols |= set().union(*(side.free_symbols for pair in branch.guards for side in pair))
    return tuple(texts), tuple(argument.name for argument in kernel.arguments if argument in symbols)


def of_kernel(kernel: Kernel, module: Module) -> Ufunc:
    """A kernel as a ufunc."""
    prefix = f"{module.name}_{kernel.name}"
    names = tuple(argument.name for argument in kernel.arguments)
    # the headers take the parameters one by one where a single number comes back
    split = len(names) if kernel.returns == "scalar" else len(names) - kernel.parameters
    loops = []
    for branch in kernel.branches:
        loop = f"{prefix}_{branch.name}" if branch.name else prefix
        function = f"{module.name}_{branch.kernel}" if branch.kernel else loop
        body = call(function, names[:split], names[split:], kernel.width, kernel.returns)
        loops.append(Loop(f"{loop}_loop", body, names))
    doc = f"{kernel.doc} Equation {kernel.equation}. Domain: {kernel.domain}."
    return Ufunc(kernel.name, prefix, doc, names, kernel.width, tuple(loops), *guards_of(kernel))
