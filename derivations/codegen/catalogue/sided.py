"""The kernels of a force that is not odd: its pieces, its data, its steps, or what its means are summed from.

In:  a `Sided`; of an odd force a `Curved`.
Out: `sided_module`; `state_curved`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import sympy as sp

from ...asymmetric.curved import Curved
from ...asymmetric.off_centre import ORDERS
from ...asymmetric.sided import Sided
from ...forces.quadrature import nested, v
from ...kernels import Formulas, Kernel
from ...symbols import u
from ..form import Module, OffCentreTerms, Record
from .force import Printed, formulas, state_data, state_pieces, state_steps


def sided_module(name: str, force: Sided) -> Module:
    """The module of one force that is stated in a program."""
    stated = force
    force = renamed(force)
    of = formulas(force.parameters)
    state_data(
        of,
        force.parameters,
        force.parameters,
        force.ends,
        force.jumps,
        equations=("(4)", "(3)", "(3)"),
        displacement="u, by rising u,",
    )
    if force.is_polynomial:
        text = "Each piece and its derivatives by its formula at u = 0; then their gains at each breakpoint."
        state_steps(of, force.steps, force.pieces, force.ends, text)
    laws = state_pieces(of, name, map(printed, force.pieces), "(3)", "restoring force f(u)")
    terms = None if force.is_polynomial else state_curved(of, force.curved)
    return Module(
        name=name,
        title=stated.title[0].upper() + stated.title[1:],
        inputs=("runtime.py", "asymmetric/sided.py", *(["asymmetric/curved.py"] if terms else [])),
        stated=tuple(of.kernels.values()),
        record=Record(stated, stated.design, laws, sp.oo, False, "", (), stepped=force.is_polynomial, odd=False),
        native=False,
        off_centre=terms,
    )


def printed(piece: sp.Expr) -> Printed:
    """A piece and its slope, polynomials after Horner."""
    value, slope = (
        sp.horner(sp.expand(one), u) if one.has(u) and one.is_polynomial(u) else one
        for one in (piece, sp.diff(piece, u))
    )
    return Printed(value, slope)


def state_curved(of: Formulas, curved: Curved) -> OffCentreTerms:
    """Each piece with its derivatives, at numbers and on intervals; and what each parameter does to it."""
    about = {"arguments": (v,), "generic": True, "in_c": False}

    def term(of: Formulas, name: str, values: tuple[sp.Expr, ...], what: str) -> Kernel:
        of.add(f"_{name}", values, what, "(3)", "where it holds", **about)
        return of.kernels[f"_{name}"]

    def terms(of: Formulas, name: str, pieces: Iterable[tuple[sp.Expr, ...]]) -> tuple[Kernel, ...]:
        what = f"Piece {{}} of the force at u, and {ORDERS} derivatives."
        return tuple(term(of, f"{name}_{k}", values, what.format(k)) for k, values in enumerate(pieces, start=1))

    def at_ends(name: str, rows: Iterable[tuple[sp.Expr, ...]], doc: str) -> Kernel:
        of.add(f"_{name}", tuple(value for row in rows for value in row), doc, "(3)", generic=True, in_c=False)
        return of.kernels[f"_{name}"]

    on_intervals = formulas(of.parameters)
    return OffCentreTerms(
        at_ends("gained", curved.gains, "What the force and two derivatives gain at each breakpoint."),
        terms(of, "curved", curved.pieces),
        terms(on_intervals, "held", (tuple(map(nested, values)) for values in curved.pieces)),
        at_ends(
            "gained_by",
            (gains for end in curved.gained_by for gains in end),
            "At each breakpoint, by each parameter in turn: what the force and its slope gain more.",
        ),
        tuple(
            tuple(
                term(of, f"moved_{k}_{p}", values, f"Piece {k} by parameter {p} at u, and two derivatives.")
                if any(values)
                else None
                for p, values in enumerate(of_piece, start=1)
            )
            for k, of_piece in enumerate(curved.by_parameter, start=1)
        ),
    )


def renamed(force: Sided) -> Sided:
    """The same with a line behind the names of parameters, which are users' and may be those that printed code has."""
    names = {old: sp.Symbol(f"{old.name}_", **old.assumptions0) for old in force.parameters}
    return replace(
        force,
        pieces=tuple(piece.xreplace(names) for piece in force.pieces),
        ends=tuple(end.xreplace(names) for end in force.ends),
        design=tuple(replace(parameter, symbol=names[parameter.symbol]) for parameter in force.design),
    )
