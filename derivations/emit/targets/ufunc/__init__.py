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

from derivations.emit.form import AVERAGED, Composition, Kernel, Module
from derivations.emit.provenance import tools
from derivations.emit.targets.c.printer import CPrinter
from derivations.emit.views import AVERAGE_FUNCTION, templates
from derivations.slow_flow import m

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
class Chain:
    """A composition in one regime, a block at a time: friction's and the averages' loops, then the slow flow's.

    friction, average, inner -- names of these loops; friction may be ""
    mu                       -- which input is mu
    averages                 -- how many averages there are
    average_inputs, inner_inputs -- C expressions
    """

    name: str
    friction: str
    mu: int
    average: str
    averages: int
    average_inputs: tuple[str, ...]
    inner: str
    inner_inputs: tuple[str, ...]


@dataclass(frozen=True)
class Ufunc:
    """A ufunc as the template needs it: loops or chains. `guards` are those of all regimes but the last."""

    name: str
    prefix: str
    doc: str
    inputs: tuple[str, ...]
    outputs: int
    loops: tuple[Loop, ...]
    chains: tuple[Chain, ...]
    guards: tuple[str, ...]
    guard_names: tuple[str, ...]


def files(modules: Sequence[Module]) -> dict[str, str]:
    """Every file of this stage."""
    environment = templates(Path(__file__).parent)
    by_name = {module.name: module for module in modules}
    result = {}
    looped = [module for module in modules if module.loops]
    for module in looped:
        ufuncs = [of_kernel(kernel, module) for kernel in module.kernels if kernel.width and not kernel.generic]
        ufuncs += [of_composition(c, module, by_name[module.family]) for c in module.compositions]
        for ufunc in ufuncs:
            if len(ufunc.inputs) + ufunc.outputs > MOST_OPERANDS:
                raise ArithmeticError(f"{ufunc.prefix} has more than {MOST_OPERANDS} arguments and results")
        text = environment.get_template("module.c.jinja").render(
            module=module, ufuncs=ufuncs, foreign=foreign_loops(ufuncs), tools=tools()
        )
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
    for function, loop in zip(functions(prefix, kernel), loop_names(prefix, kernel), strict=True):
        body = call(function, names[:split], names[split:], kernel.width, kernel.returns)
        loops.append(Loop(loop, body, names))
    doc = f"{kernel.doc} Equation {kernel.equation}. Domain: {kernel.domain}."
    return Ufunc(kernel.name, prefix, doc, names, kernel.width, tuple(loops), (), *guards_of(kernel))


def functions(prefix: str, kernel: Kernel) -> list[str]:
    """The header's functions, one for each regime."""
    return [f"{prefix}_{branch.name}" if len(kernel.branches) > 1 else prefix for branch in kernel.branches]


def loop_names(prefix: str, kernel: Kernel) -> list[str]:
    """The loops over these."""
    return [f"{function}_loop" for function in functions(prefix, kernel)]


def of_composition(composition: Composition, module: Module, family: Module | None) -> Ufunc:
    """A composition as a ufunc: a chain for each regime of the averages that it needs."""
    prefix = f"{module.name}_{composition.name}"
    inner = composition.inner
    names = tuple(argument.name for argument in composition.arguments)
    count = composition.derivatives
    averaged = next((kernel for kernel in family.kernels if kernel.name == AVERAGE_FUNCTION[count]), None)
    place = {name: f"in[{k}]" for k, name in enumerate(names)}
    local = {symbol.name: f"average_{k}" for k, symbol in enumerate(AVERAGED)} | {"m": "m"} | place
    friction = f"{module.flow}_friction_loop" if "mu" in names and m in inner.arguments else ""
    parameters = names[len(names) - composition.parameters :] if composition.parameters else ()
    chains = [
        Chain(
            name=f"{prefix}_chain_{k}",
            friction=friction,
            mu=names.index("mu") if friction else -1,
            average=average,
            averages=count,
            average_inputs=tuple(place[name] for name in ("A", *parameters)) if count else (),
            inner=f"{module.flow}_{inner.name}_loop",
            inner_inputs=tuple(local[argument.name] for argument in inner.arguments),
        )
        for k, average in enumerate(loop_names(f"{module.family}_{averaged.name}", averaged) if averaged else [""])
    ]
    doc = f"{inner.doc} Equation {inner.equation}. Domain: {inner.domain}."
    guards, guard_names = guards_of(averaged) if averaged else ((), ())
    return Ufunc(composition.name, prefix, doc, names, inner.width, (), tuple(chains), guards, guard_names)


def foreign_loops(ufuncs: Sequence[Ufunc]) -> list[str]:
    """Loops of other modules that the chains call."""
    own = {loop.name for ufunc in ufuncs for loop in ufunc.loops}
    called = {
        name for ufunc in ufuncs for chain in ufunc.chains for name in (chain.friction, chain.average, chain.inner)
    }
    return sorted(called - own - {""})
