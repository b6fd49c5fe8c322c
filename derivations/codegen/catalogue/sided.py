"""The kernels of a force that is not odd: its pieces, its data, its steps, or what its means are summed from.

In:  a `Sided`; of an odd force a `Curved`.
Out: `sided_module`; `curved_kernels`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from ...asymmetric.curved import Curved
from ...asymmetric.off_centre import ORDERS, steps_by
from ...asymmetric.sided import Sided
from ...forces.quadrature import nested, v
from ...kernels import Kernel, plain
from ...symbols import u
from ..form import Law, Module, OffCentreTerms, Record
from .mechanism import DOC_OF_STEPS_BY

ANY = "any parameters"


def sided_module(name: str, force: Sided) -> Module:
    """The module of one force that is stated in a program."""
    stated = force
    force = renamed(force)
    pieces, laws = piece_kernels(force, name)
    terms = None if force.is_polynomial else curved_kernels(force.curved, force.parameters)
    return Module(
        name=name,
        title=stated.title[0].upper() + stated.title[1:],
        inputs=("runtime.py", "asymmetric/sided.py", *(["asymmetric/curved.py"] if terms else [])),
        kernels=(*data_kernels(force), *pieces, *(terms.kernels if terms else ())),
        record=Record(stated, stated.design, laws, sp.oo, False, "", (), stepped=force.is_polynomial, odd=False),
        native=False,
        off_centre=terms,
    )


def curved_kernels(curved: Curved, parameters: tuple[sp.Symbol, ...]) -> OffCentreTerms:
    """Each piece with its derivatives, at numbers and on intervals; and what each parameter does to it."""
    given = (v, *parameters)

    def kernel(name: str, values: tuple[sp.Expr, ...], doc: str) -> Kernel:
        return plain(
            name, given, values, doc, "(3)", "where it holds", parameters=len(parameters), generic=True, in_c=False
        )

    def kernels(name: str, pieces: Sequence[tuple[sp.Expr, ...]]) -> tuple[Kernel, ...]:
        return tuple(
            kernel(f"{name}_{k}", values, f"Piece {k} of the force at u, and {ORDERS} derivatives.")
            for k, values in enumerate(pieces, start=1)
        )

    held = [tuple(map(nested, values)) for values in curved.pieces]
    gained = _at_ends("gained", curved.gains, parameters, "What the force and two derivatives gain at each breakpoint.")
    gained_by = _at_ends(
        "gained_by",
        [gains for end in curved.gained_by for gains in end],
        parameters,
        "At each breakpoint, by each parameter in turn: what the force and its slope gain more.",
    )
    moved = tuple(
        tuple(
            kernel(f"moved_{k}_{j}", values, f"Piece {k} by parameter {j} at u, and two derivatives.")
            for j, values in enumerate(by_parameter, start=1)
        )
        for k, by_parameter in enumerate(curved.moved, start=1)
    )
    return OffCentreTerms(gained, kernels("curved", curved.pieces), kernels("held", held), gained_by, moved)


def _at_ends(name: str, rows: Sequence[tuple[sp.Expr, ...]], parameters: tuple[sp.Symbol, ...], doc: str) -> Kernel:
    values = tuple(value for row in rows for value in row)
    return plain(name, parameters, values, doc, "(3)", ANY, parameters=len(parameters), in_c=False)


def renamed(force: Sided) -> Sided:
    """The same with a line behind the names of parameters, which are users' and may be those that printed code has."""
    names = {given: sp.Symbol(f"{given.name}_", **given.assumptions0) for given in force.parameters}
    return replace(
        force,
        pieces=tuple(piece.xreplace(names) for piece in force.pieces),
        ends=tuple(end.xreplace(names) for end in force.ends),
        design=tuple(replace(parameter, symbol=names[parameter.symbol]) for parameter in force.design),
    )


def data_kernels(force: Sided) -> list[Kernel]:
    """Parameters from the design, breakpoints, jumps, steps."""
    given = force.parameters
    told = (
        ("breakpoints", force.ends, "The u at which a piece of the force ends, by rising u."),
        ("jumps", force.jumps, "What the force loses at each breakpoint: f below less f above."),
        *(
            (
                (
                    "steps",
                    tuple(value for row in force.steps for value in row),
                    "Each piece and its derivatives by its formula at u = 0; then their gains at each breakpoint.",
                ),
                ("steps_by", steps_by(force.pieces, force.ends, given), DOC_OF_STEPS_BY),
            )
            if force.is_polynomial
            else ()
        ),
        (
            "by_design",
            tuple(sp.diff(value, parameter) for value in (*given, *force.ends) for parameter in given),
            "d/d(design) of the parameters, then of the breakpoints: of each by every number of the design in turn.",
        ),
    )
    return [
        plain("coefficients", given, given, "The parameters are the design.", "(4)", "any design"),
        *(plain(name, given, values, doc, "(3)", ANY, parameters=len(given)) for name, values, doc in told),
    ]


def piece_kernels(force: Sided, module: str) -> tuple[list[Kernel], tuple[Law, ...]]:
    """The pieces of the force and their slopes, for the equation of motion; laws of a module."""
    kernels, laws = [], []
    for k, piece in enumerate(force.pieces, start=1):
        name, slope = f"force_{k}", f"force_{k}_u"
        what = f"iece {k} of the restoring force f(u)."
        for one, value, text in ((name, piece, "P" + what), (slope, sp.diff(piece, u), "d/du of p" + what)):
            printed = sp.horner(sp.expand(value), u) if value.has(u) and value.is_polynomial(u) else value
            kernels.append(plain(one, (u, *force.parameters), printed, text, "(3)", "where it holds", generic=True))
        laws.append(Law(name, slope, f"{module}.{name}"))
    return kernels, tuple(laws)
