"""The records that the compiled solvers take: one table of every mechanism's numbers and functions.

In:  `Module`s, whose headers hold the functions, and each mechanism's `Parameter`s.
Out: the text of `native/records.h`; the type `sf_mechanism` is written by hand in src/slowflow/native/mechanism.h.

No formula is printed here but the bounds of domains: the records call the headers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import sympy as sp

from ....forces.elliptic import FEW
from ....mechanisms import DAMPING, FORCING, Mechanism, Parameter
from ...form import GENERAL, Kernel, Module
from ...views import templates
from .. import bounded, interval, pair
from ..printing import literal
from .printer import CPrinter

#: what `parameters_of` calls the numbers that it is given
DESIGN, DAMPING_GIVEN = "design[{}]", "given[{}]"


#: sums over the force that a record has of many amplitudes at once
SUMS = ("averaged", "averaged_2", "harmonics")


@dataclass(frozen=True)
class Sums:
    """One of these, with a loop for each regime of the force.

    name, width -- of the function, and how many numbers it gives
    functions   -- what the header calls its regimes; itself alone where a loop over it is all that there is
    guards      -- C conditions of all regimes but the last
    read        -- numbers of the parameters that the guards read, by name
    chosen_by   -- the first of the sums with these guards, whose function chooses for all
    """

    name: str
    width: int
    functions: tuple[str, ...]
    guards: tuple[str, ...] = ()
    read: dict[str, int] = field(default_factory=dict)
    chosen_by: str = ""


@dataclass(frozen=True)
class Spring:
    """One record as the template needs it.

    name        -- of the mechanism
    mechanism   -- its design, parameters and reach
    breakpoints -- how many
    enclosed    -- what stands before the names of its functions on intervals, or "": a proof takes the whole force,
                   and h_AAA to be monotone
    paired      -- and before those in double-double
    averaged_by_pieces -- whether these take the number of breakpoints passed
    domain      -- C condition: the design lies inside its domain
    sums        -- `SUMS` as they are for this force
    harmonics_up_to -- the largest breakpoint for which its harmonics hold
    bent        -- what stands before the names of what holds h and h_AAAA between two amplitudes, or ""
    summed      -- whether the average is a quadrature
    begins      -- of that the number of the breakpoint at which each contact begins
    bounded     -- and before those in double-double with a bound of the error, or "": there the average has a form
                   of its own on each side of its breakpoint
    """

    name: str
    mechanism: Mechanism
    breakpoints: int
    domain: str
    sums: tuple[Sums, ...]
    harmonics_up_to: sp.Expr
    enclosed: str = ""
    paired: str = ""
    averaged_by_pieces: bool = False
    bent: str = ""
    summed: bool = False
    begins: tuple[int, ...] = ()
    bounded: str = ""


def text(modules: Sequence[Module]) -> str:
    """The file."""
    return _rendered("records.h.jinja", records=[spring_of(module) for module in modules if module.record])


def of_one(module: Module) -> str:
    """A source with the record of one mechanism, for a library of its own."""
    return _rendered("record.c.jinja", records=[spring_of(module)])


def _rendered(template: str, **content: object) -> str:
    return (
        templates(Path(__file__).parent)
        .get_template(template)
        .render(
            **content,
            flow=GENERAL,
            damping=[parameter.symbol for parameter in DAMPING],
            damping_domain=within(DAMPING, DAMPING_GIVEN),
            forcing_domain=within((FORCING,), FORCING.symbol.name),
            forcing=FORCING.symbol,
            few=literal(FEW),
            show=CPrinter().doprint,
        )
    )


def spring_of(module: Module) -> Spring:
    """A mechanism's record, from its module."""
    mechanism = module.record.mechanism
    domain = within(mechanism.design, DESIGN)
    proved = "" if module.enclosed else interval.name_of(module)
    exact = (proved, pair.name_of(module), len(mechanism.breakpoints) > 0) if module.is_proved else ()
    up_to = module.record.harmonics_up_to
    bent = interval.name_of(module) if module.enclosed else ""
    every = [sums_of(name, width, module) for name, width in zip(SUMS, (4, 2, 8), strict=True)]
    first: dict[object, str] = {}
    sums = tuple(replace(one, chosen_by=first.setdefault(one.guards, one.name)) for one in every)
    begins = module.enclosed.begins if module.enclosed else ()
    of_bounded = bounded.name_of(module) if module.on("bounded") else ""
    numbers = (module.name, mechanism, len(mechanism.breakpoints), domain, sums, up_to)
    return Spring(*numbers, *exact, bent=bent, summed=bool(module.sums), begins=begins, bounded=of_bounded)


def sums_of(name: str, width: int, module: Module) -> Sums:
    """One of `SUMS`: regime by regime where the header has it so, by the amplitude and parameters."""
    kernel = next((one for one in module.kernels if one.name == name), None)
    if kernel is None or not all(branch.name and not branch.kernel for branch in kernel.branches):
        return Sums(name, width, (f"{module.name}_{name}",))
    functions = (f"{module.name}_{name}_{branch.name}" for branch in kernel.branches)
    return Sums(name, width, tuple(functions), *guards_of(kernel, module.record.mechanism.parameters))


def guards_of(kernel: Kernel, arguments: Sequence[sp.Symbol]) -> tuple[tuple[str, ...], dict[str, int]]:
    """Guards of a kernel's regimes in C but the last, and the numbers of the arguments that they read, by name."""
    show = CPrinter().doprint
    guarded = [branch.guards for branch in kernel.branches[:-1]]
    texts = (" && ".join(f"{show(left)} <= {show(right)}" for left, right in pairs) for pairs in guarded)
    read = set().union(*(side.free_symbols for pairs in guarded for pair in pairs for side in pair))
    return tuple(texts), {symbol.name: number for number, symbol in enumerate(arguments) if symbol in read}


def within(parameters: Sequence[Parameter], name: str) -> str:
    """A C condition: every number is finite and within its bounds; `name` is formatted with the number's place."""
    conditions = []
    for place, parameter in enumerate(parameters):
        here = name.format(place)
        lower = [(">", parameter.above), (">=", parameter.least)]
        upper = [("<", parameter.below), ("<=", parameter.most)]
        for sides, strict, infinite in ((lower, ">", f"-{CPrinter.infinity}"), (upper, "<", CPrinter.infinity)):
            bounds = [
                f"{here} {relation} {literal(sp.Rational(bound))}" for relation, bound in sides if bound is not None
            ]
            conditions.extend(bounds or [f"{here} {strict} {infinite}"])
    return " && ".join(conditions) or "1"
