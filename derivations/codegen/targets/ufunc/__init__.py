"""Compiled ufuncs: loops over the functions of the C headers, one for each regime of the force.

In:  `Module`s.
Out: a dict from file name (below `generated/`) to text: `native/*.c`.

No formula is printed here: the loops call the headers. A generic kernel takes more than floats, so it has none.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from ...form import Branch, Composition, Kernel, Module, Selection
from ...provenance import tools
from ...views import composition_view, templates
from ..c import calls
from ..c.printer import CPrinter

# SF_MOST_OPERANDS in kernels.h
MOST_OPERANDS = 32


@dataclass(frozen=True)
class Loop:
    """The loop of one regime: its name and the statements that give the values of element i."""

    name: str
    body: tuple[str, ...]


@dataclass(frozen=True)
class Ufunc:
    """A ufunc as the template needs it, with a loop for each regime. What it gives, its function in Python says.

    guards     -- those of all regimes but the last
    guarded_by -- the arguments that they read, by their numbers
    regime     -- the function that chooses; where another ufunc chooses by the same arguments, it is that one's
    """

    name: str
    prefix: str
    inputs: tuple[str, ...]
    outputs: int
    loops: tuple[Loop, ...]
    guards: tuple[str, ...]
    guarded_by: dict[str, int]
    regime: str = "NULL"

    @property
    def chooses(self) -> bool:
        """Whether the function that chooses is printed with it."""
        return self.regime == f"{self.prefix}_regime"


def files(modules: Sequence[Module]) -> dict[str, str]:
    """Every file of this stage."""
    environment = templates(Path(__file__).parent)
    result = {}
    looped = [module for module in modules if module.looped]
    for module in looped:
        ufuncs = sharing_choices([of(one, module) for one in module.looped])
        for ufunc in ufuncs:
            if len(ufunc.inputs) + ufunc.outputs > MOST_OPERANDS:
                raise ArithmeticError(f"{ufunc.prefix} has more than {MOST_OPERANDS} arguments and results")
        text = environment.get_template("module.c.jinja").render(module=module, ufuncs=ufuncs, tools=tools())
        result[f"native/{module.name}.c"] = text
    result["native/_native.c"] = environment.get_template("init.c.jinja").render(modules=looped)
    return result


def sharing_choices(ufuncs: Sequence[Ufunc]) -> list[Ufunc]:
    """The ufuncs with the function that chooses their regime, one for all that choose alike."""
    known: dict[object, str] = {}
    return [
        replace(
            ufunc,
            regime=known.setdefault((ufunc.guards, tuple(ufunc.guarded_by.items())), f"{ufunc.prefix}_regime"),
        )
        if ufunc.guards
        else ufunc
        for ufunc in ufuncs
    ]


def read(names: Sequence[str], plain: Sequence[str], packed: Sequence[str]) -> list[str]:
    """Statements that read the arguments of element i, some of them packed as the headers take them."""
    lines = []
    if plain:
        lines.append(f"const double {', '.join(f'{name} = in[{names.index(name)}][i]' for name in plain)};")
    if packed:
        lines.append(f"const double p[] = {{{', '.join(f'in[{names.index(name)}][i]' for name in packed)}}};")
    return lines


def give(call: str, returns: str) -> list[str]:
    """The statement that calls a function of a header, its last argument left open, for the values of element i."""
    return [f"values[0] = {call});" if returns == "scalar" else f"{call}, values);"]


def guards_of(kernel: Kernel, names: Sequence[str]) -> tuple[tuple[str, ...], dict[str, int]]:
    """Guards of a kernel's regimes in C, and which of the named arguments they read."""
    show = CPrinter().doprint
    texts, symbols = [], set()
    for branch in kernel.branches[:-1]:
        texts.append(" && ".join(f"{show(left)} <= {show(right)}" for left, right in branch.guards))
        symbols |= {side.name for pair in branch.guards for part in pair for side in part.free_symbols}
    return tuple(texts), {name: number for number, name in enumerate(names) if name in symbols}


def of(one: Kernel | Selection | Composition, module: Module) -> Ufunc:
    """Anything that is compiled as a ufunc: its regimes are those of the kernel that it is or calls."""
    names = tuple(argument.name for argument in one.arguments)
    if isinstance(one, Kernel):
        regimes, bodies = one, of_kernel(one, module)
    elif isinstance(one, Selection):
        regimes, bodies = one.source, of_selection(one, module)
    else:
        regimes, bodies = one.average, of_composition(one, module)
    prefix = f"{module.name}_{one.name}"
    branches = regimes.branches if regimes else (Branch("", (), (), ()),)
    loops = tuple(
        Loop("_".join([prefix, *filter(None, [branch.name]), "loop"]), tuple(body))
        for branch, body in zip(branches, bodies, strict=True)
    )
    guards = guards_of(regimes, names) if regimes else ((), {})
    return Ufunc(one.name, prefix, names, one.width, loops, *guards)


def functions(kernel: Kernel, module: Module) -> list[str]:
    """What the header calls the kernel's regimes."""
    return [
        "_".join([module.name, *([branch.kernel] if branch.kernel else filter(None, [kernel.name, branch.name]))])
        for branch in kernel.branches
    ]


def of_kernel(kernel: Kernel, module: Module) -> list[list[str]]:
    """Calls of a kernel, regime by regime."""
    names = [argument.name for argument in kernel.arguments]
    # the headers take the parameters one by one where a single number comes back
    split = len(names) if kernel.returns == "scalar" else len(names) - kernel.parameters
    passed = ", ".join([*names[:split], *(["p"] if names[split:] else [])])
    given = read(names, names[:split], names[split:])
    return [[*given, *give(f"{function}({passed}", kernel.returns)] for function in functions(kernel, module)]


def of_selection(selection: Selection, module: Module) -> list[list[str]]:
    """Calls of its source, of which the compiler leaves out what is not taken."""
    names = [argument.name for argument in selection.arguments]
    split = len(names) - selection.parameters
    given = [*read(names, names[:split], names[split:]), f"double all[{selection.source.width}];"]
    taken = [f"values[{k}] = all[{number}];" for k, number in enumerate(selection.chosen)]
    return [
        [*given, f"{function}({', '.join(names[:split])}, p, all);", *taken]
        for function in functions(selection.source, module)
    ]


def of_composition(composition: Composition, module: Module) -> list[list[str]]:
    """Calls of the slow flow's function, within each regime of the average."""
    names = [argument.name for argument in composition.arguments]
    split = len(names) - composition.parameters
    given = read(names, names[:split], names[split:])
    seen = composition_view(composition, calls(module))
    last = give(f"{seen['inner']}({', '.join(seen['passed'])}", composition.returns)
    if composition.average is None:
        return [[*given, *last]]
    before = f"double average[{composition.average.width}];"
    return [
        [*given, before, f"{function}(A, p, average);", *last] for function in functions(composition.average, module)
    ]
