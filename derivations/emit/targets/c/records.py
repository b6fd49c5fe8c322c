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

from derivations.emit.form import Module
from derivations.emit.provenance import tools
from derivations.emit.targets.c.printer import CPrinter
from derivations.emit.targets.printing import literal
from derivations.mechanisms import DAMPING, FORCING, Parameter

#: the slow flow with all damping terms
FLOW = "slow_flow"
#: what `parameters_of` calls the numbers that it is given
DESIGN, DAMPING_GIVEN = "design[{}]", "given[{}]"


@dataclass(frozen=True)
class Record:
    """One record as the template needs it.

    prefix      -- of the functions that average the force
    whole       -- the module that holds the mechanism's data, the same unless this is the first piece alone
    attached    -- prefix of the record of the first piece alone, or ""
    breakpoints -- how many
    domain      -- C condition: the design lies inside its domain
    """

    prefix: str
    whole: Module
    attached: str
    breakpoints: int
    domain: str


def text(modules: Sequence[Module], environment: jinja2.Environment) -> str:
    """The file."""
    records = [record for module in modules if is_whole(module) for record in records_of(module, modules)]
    return environment.get_template("records.h.jinja").render(
        records=records,
        flow=FLOW,
        damping=[parameter.symbol for parameter in DAMPING],
        damping_domain=within(DAMPING, DAMPING_GIVEN),
        forcing_domain=within((FORCING,), FORCING.symbol.name),
        forcing=FORCING.symbol,
        show=CPrinter().doprint,
        tools=tools(),
    )


def is_whole(module: Module) -> bool:
    """Whether it is the general module of a mechanism: no scene, every amplitude."""
    return module.mechanism is not None and module.family == module.name and not module.reexports[0]


def records_of(whole: Module, modules: Sequence[Module]) -> list[Record]:
    """A mechanism's record, after that of its first piece alone where there is one."""
    mechanism = whole.mechanism
    first = [module.name for module in modules if module.family == module.name and module.reexports[0] == whole.name]
    domain = within(mechanism.design, DESIGN)
    attached = [Record(name, whole, "", 0, domain) for name in first]
    return [*attached, Record(whole.name, whole, first[0] if first else "", len(mechanism.breakpoints), domain)]


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
