"""A mechanism's record as data: what `c/templates/records.h.jinja` prints as C, for the solvers to interpret.

In:  the `Module` of one mechanism with what solvers ask of it, and the straight-line code of its kernels.
Out: `text`, JSON: two flat lists, `words` (integers) and `numbers` (doubles), in the order in which
     src/slowflow/native/program.h reads and checks them.

The operations are those of the printed C, in its order: an interpreter gives the bits of the compiled record.
"""

from __future__ import annotations

import json
import math
from collections.abc import Sequence

from ....forces.quadrature import rule
from ....mechanisms import Parameter
from ....paper.restoring_force import FAR_IN_PAIRS
from ...conventions import PROGRAM_FORM
from ...form import Kernel, Module, Selection, Sums
from ...views import Code, KernelView, view
from .. import interval, pair
from ..c import PRINTER as C
from ..c.records import SUMS
from ..calls import CALLS
from ..printing import literal
from . import motion as motion
from .assembler import DOUBLES, INTERVALS, PAIRS, Function, Program, function
from .encoder import Encoder


def name_of(module: str) -> str:
    """Of the file."""
    return f"{module}.json"


def text(module: Module, code: Code) -> str:
    """The file."""
    encoder = Recorder(module, code)
    encoder.record()
    return json.dumps({"words": encoder.integers, "numbers": encoder.numbers}, separators=(",", ":")) + "\n"


class Recorder(Encoder):
    """What writes a record to the two lists."""

    def __init__(self, module: Module, code: Code) -> None:
        super().__init__()
        self.module, self.code = module, code

    def record(self) -> None:
        """Sizes, domains, then each function of the record in turn."""
        module = self.module
        assert module.record is not None
        mechanism = module.record.mechanism
        exact, bent = module.is_proved, module.enclosed is not None
        self.integers += [PROGRAM_FORM, len(mechanism.design), len(mechanism.parameters), len(mechanism.breakpoints)]
        self.integers += [bool(module.sums), bent, exact, exact and not bent]
        self.numbers += [float(mechanism.reach), float(module.record.harmonics_up_to)]
        self.domains(mechanism.design)
        for name in ("coefficients", "breakpoints", "jumps", *(["kinks"] if bent else []), "by_design"):
            self.function(self.in_doubles(name))
        if module.sums:
            self.summed(module.sums)
        else:
            for name in (*SUMS, "intercept", "by_parameter"):
                self.function(self.in_doubles(name))
        if bent:
            self.enclosed()
        if exact:
            for name in ("given", *(["breakpoints"] if mechanism.breakpoints else []), "known"):
                self.function(self.in_pairs(name))
                if not bent:
                    self.function(self.on_intervals(name))

    def domains(self, design: Sequence[Parameter]) -> None:
        """Conditions on the design: the number's place, 0 for above, 1 for at least, 2 for below, 3 for at most."""
        conditions = []
        for place, parameter in enumerate(design):
            bounds = [(parameter.above, parameter.least), (parameter.below, parameter.most)]
            for (strict, weak), first, infinite in zip(bounds, (0, 2), (-math.inf, math.inf), strict=True):
                stated = [
                    (relation, bound) for relation, bound in ((first, strict), (first + 1, weak)) if bound is not None
                ]
                conditions += [(place, relation, float(bound)) for relation, bound in stated or [(first, infinite)]]
        self.integers.append(len(conditions))
        for place, relation, bound in conditions:
            self.integers += [place, relation]
            self.numbers.append(bound)

    def function(self, one: Function) -> None:
        """How many branches, what chooses each, and the programs."""
        self.integers.append(len(one.branches))
        for passed, guards in zip(one.passed, one.guards, strict=True):
            self.integers += [passed, guards]
        for program in (one.sides, *one.branches):
            self.program(program)

    def summed(self, averages: Sequence[Sums]) -> None:
        """The rule; of each average its integrands, how they are graded, and what closes them."""
        nodes = rule()
        self.integers.append(len(nodes))
        for node, weight in nodes:
            self.numbers += [float(literal(node)), float(literal(weight))]
        self.integers += [len(averages[0].begins), *averages[0].begins, *averages[0].graded]
        for one in averages:
            self.integers.append(one.terms[0].width)
            for kernel in (*one.terms, one.closing):
                self.function(self.in_doubles(kernel.name))

    def enclosed(self) -> None:
        """What holds the average on an interval of amplitudes."""
        enclosed = self.module.enclosed
        assert enclosed is not None
        self.integers += [len(enclosed.begins), *enclosed.begins]
        for kernel in (*enclosed.terms, *enclosed.contacts, *enclosed.closing):
            self.function(function(view(kernel, self.code[kernel.name], interval.ENCLOSED), INTERVALS, ONE))

    def in_doubles(self, name: str) -> Function:
        """A kernel, or some outputs of one."""
        for selection in self.module.selections:
            if selection.name == name:
                return chosen(self.in_doubles(selection.source.name), selection)
        kernel = named(self.module.kernels, name)
        sides = [
            (-1, [(C.doprint(one), C.doprint(other)) for one, other in branch.guards]) for branch in kernel.branches
        ]
        found = function(view(kernel, self.code[name], C), DOUBLES, sides)
        if not any(branch.kernel for branch in kernel.branches):
            return found
        # a branch that another kernel computes
        others = (branch.kernel and self.in_doubles(branch.kernel).branches[0] for branch in kernel.branches)
        own = zip(others, found.branches, strict=True)
        return Function(found.passed, found.guards, found.sides, tuple(other or one for other, one in own))

    def in_pairs(self, name: str) -> Function:
        """A kernel in double-double."""
        printed = pair.near(named(self.module.on("pairs"), name), self.code)
        show, far = CALLS.doprint, literal(FAR_IN_PAIRS)
        sides = [
            [(f"TIMES({far}, {show(one)})", show(other)) for one, other in branch.guards]
            for branch in printed.kernel.branches
        ]
        return function(printed, PAIRS, by_passed(printed, sides))

    def on_intervals(self, name: str) -> Function:
        """A kernel on intervals."""
        printed = interval.on_interval(named(self.module.on("intervals"), name), self.code[name])
        show = CALLS.doprint
        sides = [
            [(show(one), show(other)) for one, other in branch.guards if not other.is_Symbol]
            for branch in printed.kernel.branches
        ]
        return function(printed, INTERVALS, by_passed(printed, sides))


#: conditions of a kernel of one branch
ONE: tuple[tuple[int, Sequence[tuple[str, str]]], ...] = ((-1, ()),)


def by_passed(
    printed: KernelView, sides: Sequence[Sequence[tuple[str, str]]]
) -> list[tuple[int, Sequence[tuple[str, str]]]]:
    """Conditions of branches that hold by the number of breakpoints passed, and by comparisons."""
    return [(branch.passed, one) for branch, one in zip(printed.kernel.branches, sides, strict=True)]


def chosen(source: Function, selection: Selection) -> Function:
    """Some outputs of a function."""
    programs = [
        Program(one.arguments, one.registers, one.constants, one.code, tuple(one.outputs[k] for k in selection.chosen))
        for one in source.branches
    ]
    return Function(source.passed, source.guards, source.sides, tuple(programs))


def named(kernels: Sequence[Kernel], name: str) -> Kernel:
    """The kernel of that name."""
    return next(one for one in kernels if one.name == name)
