"""The kernels that the module of every force has, however it is averaged: design, breakpoints, pieces, steps.

In:  the `Formulas` of the module, and expressions in its parameters.
Out: kernels stated in these; the `Law`s of the pieces.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import sympy as sp

from ...asymmetric.off_centre import steps_by
from ...kernels import Formulas, Let, Lets
from ...symbols import A, u
from ..form import Law

ANY = "any parameters"


def formulas(parameters: Sequence[sp.Symbol]) -> Formulas:
    """Of a mechanism's module, none yet: its kernels take u or A, then the parameters."""
    return Formulas((u, A), domain=ANY, parameters=parameters)


def state_data(
    of: Formulas,
    design: Sequence[sp.Symbol],
    values: Sequence[sp.Expr],
    ends: Sequence[sp.Expr],
    jumps: Sequence[sp.Expr],
    *,
    ends_by_design: Sequence[sp.Expr] | None = None,
    equations: tuple[str, str, str],
    displacement: str = "|u|",
) -> None:
    """What parameters and breakpoints are in the numbers of the design and how they follow it; breakpoints, jumps.

    values         -- of the parameters, in the design
    ends_by_design -- of the breakpoints, where these are not in the design already
    equations      -- that the parameters, the breakpoints and the jumps are from
    """
    from_design, of_ends, of_jumps = equations
    followed = [*values, *(ends if ends_by_design is None else ends_by_design)]
    of.add(
        "by_design",
        [sp.factor(sp.diff(value, number)) for value in followed for number in design],
        "d/d of each number of the design: of each parameter in turn, then of each breakpoint.",
        from_design,
        "any design that has a breakpoint" if ends else "any design",
        arguments=design,
        packed=False,
        looped=False,
    )
    text = f"The parameters {', '.join(map(str, of.parameters))} from the design."
    of.add("coefficients", values, text, from_design, "any design", arguments=design, packed=False)
    of.add("breakpoints", ends, f"The {displacement} at which a piece of the force ends.", of_ends)
    of.add("jumps", jumps, "What the force loses at each breakpoint: f below less f above.", of_jumps)


#: rows of the steps of an odd force
STEPS = "f and its derivatives just above 0, their gains at each breakpoint, and the last piece's by its formula at 0."


def state_steps(
    of: Formulas,
    rows: Iterable[Sequence[sp.Expr]],
    pieces: Sequence[sp.Expr],
    ends: Sequence[sp.Expr],
    doc: str = STEPS,
) -> None:
    """A force of polynomials as a sum of steps, and what the parameters do to these."""
    of.add("steps", tuple(value for row in rows for value in row), doc, "(3), (5)", looped=False)
    doc = "What each parameter does to derivatives of each piece at u = 0, then to their gains at each breakpoint."
    of.add("steps_by", steps_by(pieces, ends, of.parameters), doc, "(3)", looped=False)


@dataclass(frozen=True)
class Printed:
    """A piece of a force as it is printed.

    value, slope -- f(u) and df/du, in these lets
    begins       -- where it begins as a broken power of what |u| exceeds that by; None elsewhere
    """

    value: sp.Expr
    slope: sp.Expr
    lets: Sequence[Let] = ()
    begins: sp.Expr | None = None


def state_pieces(
    of: Formulas, module: str, pieces: Iterable[Printed], equation: str, force: str = "whole restoring force u + F_k(u)"
) -> tuple[Law, ...]:
    """The pieces of the force and their slopes, one by one, for the equation of motion; the laws of a module."""
    about = {"arguments": (u, *of.parameters), "packed": False, "generic": True}
    laws = []
    for k, piece in enumerate(pieces, start=1):
        name, slope, what = f"force_{k}", f"force_{k}_u", f"iece {k} of the {force}."
        of.add(name, Lets(piece.lets, piece.value), "P" + what, equation, "where it holds", **about)
        of.add(slope, Lets(piece.lets, piece.slope), "d/du of p" + what, equation, "where it holds", **about)
        laws.append(Law(name, slope, f"{module}.{name}", piece.begins))
    return tuple(laws)
