"""Kernels on whole intervals of their arguments: those in C printed for `generic`, and modules in Python.

In:  `Module`s with the straight-line code of their kernels.
Out: `KernelView`s of C, and a dict from file name (below `generated/`) to text of Python.

The Python takes objects with operators, `square` and `sqrt`, and has what the search along the amplitude asks, and
proofs in balls. In C a let that stands for a series cut short is widened by the bound that the derivation gives. By how
much an amplitude exceeds the breakpoint where its piece begins is an argument of its own: the difference would lose its
digits next to a breakpoint that is known to a rounding only.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path

import sympy as sp

from ....symbols import A
from ...common import LEAST_SAVED
from ...form import Branch, Kernel, Module
from ...passes import Program
from ...views import BranchView, Code, KernelView, heading, templates, view
from ..calls import AS_OPERATORS, CALLS, CallPrinter
from ..printing import literal
from .printer import CEnclosurePrinter, PythonIntervalPrinter

#: how much an amplitude exceeds the breakpoint where its piece begins
BEYOND = sp.Symbol("beyond", nonnegative=True)
#: what the template says of them in Python
IN_PYTHON = {
    "how": "on whole intervals",
    "meaning": "Each output holds every value that the function of the same name takes on the arguments: objects with "
    "operators and the methods `square` and `sqrt`.",
}
#: of forces of any kind
ENCLOSED = CEnclosurePrinter()
PYTHON = PythonIntervalPrinter()


def files(modules: Sequence[Module], code: dict[str, Code]) -> dict[str, str]:
    """Every file in Python."""
    result = {}
    for module in modules:
        kernels = [view(kernel, code[module.name][kernel.name], PYTHON) for kernel in module.on("enclosures")]
        if kernels:
            result[f"slowflow_kernels/{name_of(module)}.py"] = module_of(module, kernels, imports=[], **IN_PYTHON)
    return result


def in_c(module: Module, code: Code) -> list[KernelView]:
    """The kernels in C, printed."""
    if module.enclosed:
        return [view(kernel, code[kernel.name], ENCLOSED) for kernel in module.enclosed.kernels]
    printer = AS_OPERATORS if as_doubles(module, code) else CALLS
    return [on_interval(kernel, code[kernel.name], printer) for kernel in module.on("intervals")]


def as_doubles(module: Module, code: Code) -> list[KernelView]:
    """The kernels as doubles have them, of a module without pairs: functions of numbers alone, if that saves lines."""
    if not module.in_c or module.on("pairs"):
        return []
    both = [one for one in module.kernels if one.in_c and "intervals" in one.arithmetics and not one.parameters]
    lines = sum(len(program.lets) + len(program.outputs) for one in both for program in code[one.name])
    return [view(one, code[one.name], AS_OPERATORS) for one in both] if lines >= LEAST_SAVED else []


def module_of(module: Module, kernels: Sequence[KernelView], imports: Sequence[str], **about: str) -> str:
    """A Python module of such kernels."""
    template = templates(Path(__file__).parent).get_template("module.py.jinja")
    known = {"module": module, "heading": heading(module), "in_doubles": in_doubles(module), **about}
    return template.render(kernels=kernels, imports=imports, **known)


def in_doubles(module: Module) -> set[str]:
    """The kernels whose equations and domains are stated where they are evaluated in doubles."""
    return {kernel.name for kernel in module.kernels}


def name_of(module: Module) -> str:
    """Of a module's functions on intervals, and of their file."""
    return f"{module.name}_intervals"


def on_interval(kernel: Kernel, code: Sequence[Program], printer: CallPrinter = CALLS) -> KernelView:
    """A kernel printed."""
    return widened(view(*(beyond_breakpoints(kernel, code) if len(kernel.branches) > 1 else (kernel, code)), printer))


def widened(printed: KernelView) -> KernelView:
    """A kernel's series widened by what they leave out."""
    branches = (widened_branch(*both) for both in zip(printed.branches, printed.kernel.branches, strict=True))
    return dataclasses.replace(printed, branches=tuple(branches))


def beyond_breakpoints(kernel: Kernel, code: Sequence[Program]) -> tuple[Kernel, list[Program]]:
    """The same with A less the last breakpoint that it exceeds as an argument."""
    ends = [right for branch in kernel.branches for _, right in branch.guards if right.is_Symbol]
    found = []
    for branch, program in zip(kernel.branches, code, strict=True):
        known = {A - ends[branch.passed - 1]: BEYOND} if branch.passed else {}
        lets = tuple((symbol, value.xreplace(known)) for symbol, value in program.lets)
        outputs = tuple(value.xreplace(known) for value in program.outputs)
        found.append(dataclasses.replace(program, lets=lets, outputs=outputs))
    return dataclasses.replace(kernel, arguments=(*kernel.plain, BEYOND, *kernel.packed)), found


def widened_branch(printed: BranchView, branch: Branch) -> BranchView:
    """The same of one branch."""
    # as multiples of 2^-60, which are doubles
    bounds = {symbol.name: literal(sp.ceiling(2**60 * bound) / 2**60) for symbol, bound in branch.remainders}
    if not bounds.keys() <= {line.name for line in printed.lets}:
        raise NotImplementedError(f"{branch.name}: a series cut short has no line of its own")
    lets = (
        dataclasses.replace(line, value=f"WITHIN({line.value}, {bounds[line.name]})") if line.name in bounds else line
        for line in printed.lets
    )
    return dataclasses.replace(printed, lets=tuple(lets))


def choice(printed: KernelView) -> list[tuple[str, str]]:
    """The condition and the name of each branch; the last holds where no other does.

    Branches are chosen by the number of breakpoints passed; a series far from these where all of the interval lies far.
    """
    show = CALLS.doprint
    found = []
    for branch in printed.kernel.branches:
        near = [f"{show(left)}.lo <= {show(right)}.hi" for left, right in branch.guards if not right.is_Symbol]
        found.append((" && ".join([f"passed == {branch.passed}", *near]), branch.name))
    return found
