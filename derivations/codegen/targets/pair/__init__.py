"""Kernels in double-double, printed for `generic`, and their arctangent's series.

In:  `Module`s with the straight-line code of their kernels.
Out: `KernelView`s of C; the series' file by its name (below `generated/`).

A kernel that says which lets are to be pairs computes what follows from these in doubles. Where a kernel has a series
cut short for a double far from a breakpoint, the closed form is taken until the series has a pair's digits.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import sympy as sp

from ....paper.restoring_force import FAR_IN_PAIRS, OF_A_PAIR
from ....symbols import A
from ...arctangent import PAIRS_CUT, in_pairs
from ...form import Kernel, Module
from ...passes import Program
from ...views import BranchView, Code, KernelView, Line, templates, view, wrapped
from .. import interval
from ..c.printer import CPrinter
from ..calls import CALLS, high_and_low
from ..printing import literal

DOUBLES = CPrinter()


def files() -> dict[str, str]:
    """The series."""
    angle = templates(Path(__file__).parent).get_template("angles.h.jinja").render(**angles())
    return {"native/pair_angle_series.h": angle}


def in_c(module: Module, code: Code) -> list[KernelView]:
    """The kernels in C, printed."""
    # on intervals what a series leaves out is more than nothing
    return [interval.widened(near(kernel, code)) for kernel in module.on("pairs")]


def name_of(module: Module) -> str:
    """Of a module's functions on pairs, and of their file."""
    return f"{module.name}_pairs"


def choice(printed: KernelView) -> list[tuple[str, str]]:
    """The condition and the name of each branch; the last holds where no other does."""
    found = []
    for shown, branch in zip(printed.branches, printed.kernel.branches, strict=True):
        far = [f"{right}.high > {literal(FAR_IN_PAIRS)} * {left}.high" for left, right in branch.guards]
        found.append((" && ".join([f"passed == {branch.passed}", *far]), shown.name))
    return found


def by_far(kernel: Kernel, code: Code) -> tuple[Kernel, list[Program]]:
    """As `closed`, after the branches of each number of breakpoints whose series have a pair's digits."""
    nearer, programs = closed(kernel, code)
    ends = [right for branch in kernel.branches for _, right in branch.guards if right.is_Symbol]
    all_far = {f"passed_{count}_far_{count}": end for count, end in enumerate(ends, start=1)}
    beyond, other = interval.beyond_breakpoints(kernel, code[kernel.name])
    both = [*zip(nearer.branches, programs, strict=True)]
    for branch, program in zip(beyond.branches, other, strict=True):
        if branch.name in all_far:
            guarded = replace(branch, guards=((all_far[branch.name], A),))
            place = next(k for k, (one, _) in enumerate(both) if one.passed == branch.passed)
            both.insert(place, (guarded, program))
    return replace(nearer, branches=tuple(one for one, _ in both)), [one for _, one in both]


def closed(kernel: Kernel, code: Code) -> tuple[Kernel, list[Program]]:
    """A kernel without branches in which a series is cut short; the others differ in breakpoints passed."""
    kept = [k for k, one in enumerate(kernel.branches) if all(bound <= OF_A_PAIR for _, bound in one.remainders)]
    programs = [code[kernel.name][k] for k in kept]
    kernel = replace(kernel, branches=tuple(kernel.branches[k] for k in kept))
    if len(kept) > 1:
        kernel, programs = interval.beyond_breakpoints(kernel, programs)
    return replace(kernel, branches=tuple(replace(branch, guards=()) for branch in kernel.branches)), programs


def near(kernel: Kernel, code: Code) -> KernelView:
    """The same printed."""
    kernel, programs = by_far(kernel, code)
    printed = view(kernel, programs, CALLS)
    if not kernel.to_pairs:
        return printed
    branches = (rest_in_doubles(*both, kernel) for both in zip(printed.branches, programs, strict=True))
    return replace(printed, branches=tuple(branches))


def rest_in_doubles(printed: BranchView, program: Program, kernel: Kernel) -> BranchView:
    """The same branch, but what the lets that are to be pairs do not need."""
    needed = set(kernel.to_pairs)
    for symbol, value in reversed(program.lets):
        if symbol in needed:
            needed |= value.free_symbols
    pairs = {*kernel.arguments, *needed}
    high = {symbol: sp.Symbol(f"{CALLS.doprint(symbol)}.high") for symbol in pairs}
    show = DOUBLES.doprint

    def line(one: Line, symbol: sp.Symbol, value: sp.Expr) -> Line:
        if symbol in needed:
            return one
        return Line(one.name, wrapped(show(value.xreplace(high)), len(one.name) + 3, CALLS), "double")

    lets = tuple(line(one, *let) for one, let in zip(printed.lets, program.lets, strict=True))
    outputs = tuple(show(output.xreplace(high)) for output in program.outputs)
    return replace(printed, lets=lets, outputs=outputs)


def angles() -> dict[str, object]:
    """What the arctangent's template needs."""
    table, first, others = in_pairs()
    return {
        "cut": PAIRS_CUT,
        "table": [high_and_low(angle) for angle in table],
        "first": [high_and_low(coefficient) for coefficient in reversed(first)],
        "others": [high_and_low(coefficient)[0] for coefficient in reversed(others)],
        "half_pi": high_and_low(sp.pi / 2),
    }
