"""The records that the compiled solvers take: one table of every mechanism's numbers and functions.

In:  `Module`s, whose headers hold the functions, and each mechanism's `Parameter`s.
Out: the text of `native/records.h`; the type `sf_mechanism` is written by hand in src/slowflow/native/mechanism.h.

No formula is printed here but the bounds of domains: the records call the headers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import sympy as sp

from ....mechanisms import DAMPING, FORCING, Mechanism, Parameter
from ...form import GENERAL, Module
from ...provenance import tools
from ...views import templates
from .. import interval, pair
from ..printing import literal
from .printer import CPrinter

#: what `parameters_of` calls the numbers that it is given
DESIGN, DAMPING_GIVEN = "design[{}]", "given[{}]"


@dataclass(frozen=True)
class Spring:
    """One record as the template needs it.

    name        -- of the mechanism
    mechanism   -- its design, parameters and reach
    breakpoints -- how many
    enclosed    -- what stands before the names of its functions on intervals, or "": a proof takes the whole force
    paired      -- and before those in double-double
    averaged_by_pieces -- whether these take the number of breakpoints passed
    domain      -- C condition: the design lies inside its domain
    harmonics_up_to -- the largest breakpoint for which its harmonics hold
    bent        -- what stands before the names of what holds h and h_AAAA between two amplitudes, or ""
    begins      -- of that the number of the breakpoint at which each contact begins
    """

    name: str
    mechanism: Mechanism
    breakpoints: int
    domain: str
    harmonics_up_to: sp.Expr
    enclosed: str = ""
    paired: str = ""
    averaged_by_pieces: bool = False
    bent: str = ""
    begins: tuple[int, ...] = ()


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
            show=CPrinter().doprint,
            tools=tools(),
        )
    )


def spring_of(module: Module) -> Spring:
    """A mechanism's record, from its module."""
    mechanism = module.record.mechanism
    domain = within(mechanism.design, DESIGN)
    exact = (interval.name_of(module), pair.name_of(module), len(mechanism.breakpoints) > 0) if module.cells else ()
    up_to = module.record.harmonics_up_to
    bent = interval.name_of(module) if module.enclosed else ""
    begins = module.enclosed.begins if module.enclosed else ()
    return Spring(module.name, mechanism, len(mechanism.breakpoints), domain, up_to, *exact, bent=bent, begins=begins)


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
