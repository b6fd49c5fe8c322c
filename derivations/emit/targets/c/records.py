"""The records that the compiled solvers take: one table of every mechanism's numbers and functions.

In:  `Module`s, whose headers hold the functions, and each mechanism's `Parameter`s.
Out: the text of `native/records.h`; the type `sf_mechanism` is written by hand in src/slowflow/native/mechanism.h.

No formula is printed here but the bounds of domains: the records call the headers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import jinja2
import sympy as sp

from derivations.emit.form import GENERAL, Module
from derivations.emit.provenance import tools
from derivations.emit.targets import interval
from derivations.emit.targets.c.printer import CPrinter
from derivations.emit.targets.printing import literal
from derivations.mechanisms import DAMPING, FORCING, Parameter

#: what `parameters_of` calls the numbers that it is given
DESIGN, DAMPING_GIVEN = "design[{}]", "given[{}]"


@dataclass(frozen=True)
class Spring:
    """One record as the template needs it.

    prefix      -- of the record, and its name
    whole       -- the module that holds the mechanism's functions
    averaged, averaged_2 -- what averages the force
    intercept   -- what gives h - A h_A, or ""
    attached    -- prefix of the record of the first piece alone, or ""
    breakpoints -- how many
    enclosed    -- what stands before the names of its functions on intervals, or "": a proof takes the whole force
    averaged_by_pieces -- whether these take the number of breakpoints passed
    domain      -- C condition: the design lies inside its domain
    """

    prefix: str
    whole: Module
    averaged: str
    averaged_2: str
    intercept: str
    attached: str
    breakpoints: int
    domain: str
    enclosed: str = ""
    averaged_by_pieces: bool = False


def text(modules: Sequence[Module], environment: jinja2.Environment) -> str:
    """The file."""
    records = [spring for module in modules if module.record for spring in springs_of(module)]
    return environment.get_template("records.h.jinja").render(
        records=records,
        flow=GENERAL,
        damping=[parameter.symbol for parameter in DAMPING],
        damping_domain=within(DAMPING, DAMPING_GIVEN),
        forcing_domain=within((FORCING,), FORCING.symbol.name),
        forcing=FORCING.symbol,
        show=CPrinter().doprint,
        tools=tools(),
    )


def springs_of(whole: Module) -> list[Spring]:
    """A mechanism's record, after that of its first piece alone where there is one."""
    name, mechanism = whole.name, whole.record.mechanism
    first = f"{name}_attached" if whole.record.attached else ""
    domain = within(mechanism.design, DESIGN)
    own = any(kernel.name == "intercept" for kernel in whole.kernels)
    functions = (f"{name}_averaged", f"{name}_averaged_2", f"{name}_intercept" if own else "")
    enclosed = (interval.name_of(whole), len(mechanism.breakpoints) > 0) if whole.cells else ("", False)
    found = [Spring(name, whole, *functions, first, len(mechanism.breakpoints), domain, *enclosed)]
    if first:
        # the first regime's functions
        regime = next(kernel for kernel in whole.kernels if kernel.name == "averaged").branches[0].name
        found.insert(
            0, Spring(first, whole, *(function and f"{function}_{regime}" for function in functions), "", 0, domain)
        )
    return found


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
    return " && ".join(conditions)
