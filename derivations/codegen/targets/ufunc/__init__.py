"""Compiled ufuncs: loops over the functions of the C headers, one for each regime of the force.

In:  `Module`s.
Out: a dict from file name (below `generated/`) to text: `native/*.c`.

No formula is printed here: the loops call the headers. A generic kernel takes more than floats, so it has none.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from ...form import Called, Composition, Kernel, Module, Selection, TwofoldKernel
from ...views import composition_view, templates
from ..c import calls
from ..c.records import guards_of

#: a space that no line ends with
UNBROKEN = "\xa0"


@dataclass(frozen=True)
class Ufunc:
    """A ufunc as the template needs it, with a loop for each regime. What it gives, its function in Python says.

    loop    -- the macro of kernels.h that makes its loops, and what that takes behind the regime and the ufunc's name
    regimes -- what stands behind the names of its loops, and of the functions that they call
    guards  -- those of all regimes but the last
    read    -- the arguments that these read, by their numbers
    chosen_by -- the ufunc whose function chooses: itself, or the first that chooses by the same arguments
    """

    name: str
    module: str
    inputs: int
    outputs: int
    loop: list[str]
    regimes: tuple[str, ...] = ("",)
    guards: tuple[str, ...] = ()
    read: dict[str, int] = field(default_factory=dict)
    chosen_by: str = ""

    @property
    def prefix(self) -> str:
        """What the names of its loops begin with."""
        return f"{self.module}_{self.name}"

    @property
    def listed(self) -> str:
        """How the list of kernels has one that has a function of its name and arguments; nothing of another."""
        arguments = [*map(element, range(self.inputs))]
        if not self.guards and self.loop == ["SF_SCALAR", self.prefix, *arguments]:
            return f"NUMBER(of, {self.name}, {self.inputs})"
        if not self.guards and self.loop == ["SF_TUPLE", str(self.outputs), self.prefix, *arguments]:
            return f"NUMBERS(of, {self.name}, {self.inputs}, {self.outputs})"
        return ""


def files(modules: Sequence[Module]) -> dict[str, str]:
    """Every file of this stage."""
    environment = templates(Path(__file__).parent)
    environment.filters["continued"] = lambda text: text.replace("\n", " \\\n").replace(UNBROKEN, " ")
    result, most = {}, 0
    looped = [module for module in modules if module.looped]
    for module in looped:
        ufuncs = sharing_choices([of(one, module) for one in module.looped])
        most = max(most, *(one.inputs + one.outputs for one in ufuncs))
        text = environment.get_template("module.c.jinja").render(
            module=module,
            ufuncs=ufuncs,
            listed=" ".join(one.listed.replace(" ", UNBROKEN) for one in ufuncs if one.listed),
            lists=list(dict.fromkeys(one.regimes for one in ufuncs if one.guards)),
            choice=choice,
        )
        result[f"native/{module.name}.c"] = text
    result["native/_native.c"] = environment.get_template("init.c.jinja").render(modules=looped, most=most)
    return result


def sharing_choices(ufuncs: Sequence[Ufunc]) -> list[Ufunc]:
    """The ufuncs with the one whose function chooses their regime, the same for all that choose alike."""
    known: dict[object, str] = {}
    return [
        replace(one, chosen_by=known.setdefault((one.guards, tuple(one.read.items())), one.prefix))
        if one.guards
        else one
        for one in ufuncs
    ]


def choice(ufunc: Ufunc) -> str:
    """What its function that chooses is made of: the number of the regime, and the arguments that it reads."""
    chosen = "".join(f"{guard} ? {k} : " for k, guard in enumerate(ufunc.guards))
    read = ", ".join(f"{name} = {element(k)}" for name, k in ufunc.read.items())
    return f"{chosen}{len(ufunc.guards)}, const double {read}"


def element(k: int) -> str:
    """Argument k of element i."""
    return f"X({k})"


def elements(function: Called) -> list[str]:
    """The arguments as the headers take them where several numbers come back: parameters as an array."""
    every = [*map(element, range(len(function.arguments)))]
    own, parameters = every[: len(function.plain)], every[len(function.plain) :]
    return [*own, *([f"(const double[]){{{', '.join(parameters)}}}"] if parameters else [])]


def of(one: Kernel | TwofoldKernel | Selection | Composition, module: Module) -> Ufunc:
    """Anything that is compiled as a ufunc: its regimes are those of the kernel that it is or calls."""
    inputs = len(one.arguments)
    if isinstance(one, TwofoldKernel):
        macro = ["SF_SCALAR"] if one.width == 1 else ["SF_TUPLE", str(one.width)]
        called, loop = None, [*macro, f"{module.name}_{one.name}", *map(element, range(inputs))]
    elif isinstance(one, Kernel):
        called, loop = one, of_kernel(one, module)
    elif isinstance(one, Selection):
        called, loop = one.source, of_selection(one, module)
    else:
        called, loop = one.average, of_composition(one, module)
    regimes = (named(called, module)[1], *guards_of(called, one.arguments)) if called else ()
    return Ufunc(one.name, module.name, inputs, one.width, loop, *regimes)


def named(kernel: Kernel, module: Module) -> tuple[str, tuple[str, ...]]:
    """What the header calls a kernel's functions: what they have in common, and what stands behind it by regime."""
    own = [branch.kernel or "_".join(filter(None, [kernel.name, branch.name])) for branch in kernel.branches]
    common = "" if any(branch.kernel for branch in kernel.branches) else kernel.name
    if len(own) == 1:
        return f"{module.name}_{own[0]}", ("",)
    if not all(name.startswith(common) for name in own):
        raise ArithmeticError(f"some regimes of {kernel.name} are kernels of their own, others are not")
    before = f"{module.name}_{common}" if common else module.name
    return before, tuple(f"_{name.removeprefix(common).removeprefix('_')}" for name in own)


def of_kernel(kernel: Kernel, module: Module) -> list[str]:
    """A call of a kernel."""
    if kernel.returns == "scalar":  # the headers take the parameters one by one where a single number comes back
        return ["SF_SCALAR", named(kernel, module)[0], *map(element, range(len(kernel.arguments)))]
    return ["SF_TUPLE", str(kernel.width), named(kernel, module)[0], *elements(kernel)]


def through(
    average: Kernel | Selection, module: Module, outputs: int, arguments: Sequence[str], *then: str
) -> list[str]:
    """A call of a function whose results, `all`, are taken further."""
    call = f"({', '.join((*arguments, 'all'))})"
    taken = " ".join(f"{one};" for one in then)
    return ["SF_PART", str(outputs), str(average.width), named(average, module)[0], call, taken]


def of_selection(selection: Selection, module: Module) -> list[str]:
    """A call of its source, of which the compiler leaves out what is not taken."""
    taken = (f"values[{k}] = all[{number}]" for k, number in enumerate(selection.chosen))
    return through(selection.source, module, selection.width, elements(selection), *taken)


def of_composition(composition: Composition, module: Module) -> list[str]:
    """A call of the slow flow's function, within each regime of the average."""
    number = {argument.name: element(k) for k, argument in enumerate(composition.arguments)}
    in_C = calls(module)
    friction = in_C.friction.replace("(mu)", f"({number.get('mu', '')})")
    averages = tuple(f"all[{k}]" for k in range(len(in_C.averages)))
    seen = composition_view(composition, replace(in_C, friction=friction, averages=averages))
    passed = [number.get(one, one) for one in seen["passed"]]
    if composition.average is None:
        if composition.returns == "scalar":
            return ["SF_SCALAR", seen["inner"], *passed]
        return ["SF_TUPLE", str(composition.width), seen["inner"], *passed]
    inner = f"{seen['inner']}({', '.join(passed)}"
    last = f"values[0] = {inner})" if composition.returns == "scalar" else f"{inner}, values)"
    arguments = (number["A"], *elements(composition)[len(composition.plain) :])
    return through(composition.average, module, composition.width, arguments, last)
