"""Off the centre, forces of any kind: what their means over u = B + A cos psi are summed from.

In:  the pieces of a force by rising u, and where each ends.
Out: `Curved`: each piece with three derivatives, and what f, f', f'' gain at each end.

The means c_n of f^(n) and s_n of f^(n) cos psi (`off_centre`) of a piecewise polynomial are sums over steps. Of any
other force only what it and its slope gain at its ends are steps, D_0 + D_1 (u - b) beyond b; what is left has a slope
that is continuous, so that its means and theirs by A and B to the second order have no terms from moving angles:

    r(u) = f(u) - sum of D_0 + D_1 (u - b) over the ends that are passed from u = 0 on

and r'' jumps by D_2 where f'' does, which adds D_2 L_-1 and D_2 M_-1 to c_3 and s_3.

What a parameter does to f at a fixed u is a force of the same kind: its means are what it does to c_n and s_n, beside
what a step adds whose end moves.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import sympy as sp

from ..forces.elliptic import Corner
from ..forces.quadrature import Quadrature, derivatives, lost_at, v
from ..symbols import u
from .off_centre import ORDERS


@dataclass(frozen=True)
class Curved:
    """A force of any kind, for all u or, of an odd one, for u > 0.

    pieces -- f, f', f'', f''' of each by rising u, in `v` for u
    gains  -- of f, f', f'' at each end
    by_parameter -- of each piece, by each parameter in turn: the derivative of f by it, and its first two by u
    gained_by -- at each end, by each parameter in turn: the gains of that derivative and of its slope
    """

    pieces: tuple[tuple[sp.Expr, ...], ...]
    gains: tuple[tuple[sp.Expr, ...], ...]
    by_parameter: tuple[tuple[tuple[sp.Expr, ...], ...], ...]
    gained_by: tuple[tuple[tuple[sp.Expr, ...], ...], ...]


def of_odd(average: Quadrature, parameters: Sequence[sp.Symbol]) -> Curved | None:
    """Of an odd force, stated for u > 0, that is summed about the centre; None where it is not summed off it.

    Its first piece has to be odd by its formula, so that nothing happens at u = 0.
    """
    first = average.pieces[0]
    polynomial = all(piece.is_polynomial(u) for piece in average.pieces)
    if polynomial or average.is_broken or average.contacts or sp.expand(first.subs(u, -u) + first) != 0:
        return None
    return curved(average.pieces, tuple(average.breakpoints.values()), parameters)


def curved(pieces: Sequence[sp.Expr], ends: Sequence[sp.Expr], parameters: Sequence[sp.Symbol]) -> Curved:
    """Of pieces that are smooth up to their ends."""
    met = tuple(zip(pairwise(pieces), ends, strict=True))
    return Curved(
        tuple(tuple(derivatives(piece.subs(u, v), ORDERS)) for piece in pieces),
        tuple(tuple(-lost_at(below - above, end, order) for order in range(ORDERS)) for (below, above), end in met),
        tuple(
            tuple(tuple(derivatives(sp.diff(piece, by).subs(u, v), ORDERS - 1)) for by in parameters)
            for piece in pieces
        ),
        tuple(
            tuple(tuple(-lost_at(sp.diff(below - above, by), end, order) for order in range(2)) for by in parameters)
            for (below, above), end in met
        ),
    )


def of_untruncated(pieces: Sequence[sp.Expr], end: Corner, parameters: Sequence[sp.Symbol]) -> Curved:
    """Of the force as the geometry gives it (5), whose first piece ends where the springs detach.

    It has no jump there: the compression is 0. Gains are stated in the height c = sqrt(1 - u_cr^2), of which no digit
    is lost as u_cr nears 1.
    """
    c = sp.Symbol("c", positive=True)
    force = curved(pieces, (sp.sqrt(1 - c**2),), parameters)
    ((_, *gains),) = force.gains

    def in_parameters(gain: sp.Expr) -> sp.Expr:
        return gain.subs(sp.sqrt(1 - c**2), end.value).subs(c, end.height)

    return replace(
        force,
        gains=((sp.Integer(0), *map(in_parameters, gains)),),
        gained_by=tuple(tuple(tuple(map(in_parameters, row)) for row in rows) for rows in force.gained_by),
    )
