"""A force that is not odd: a stop on one side only, springs that differ on both sides, a spring with even powers.

In:  pieces of the whole force f(u) by rising u, from below all of them to above all; where each ends.
Out: `Sided`; `steps`, a piecewise polynomial as a sum of steps, of which `off_centre` has the means over
     u = B + A cos psi; `curved`, what those of any other force are summed from.

There is no motion about the centre to be averaged: f_0(A, B) = c_0 - load and h(A, B) = -2 s_0 are all there is, in the
means c_n of f^(n) and s_n of f^(n) cos psi (`off_centre`), and these are sums over the steps, or by quadrature.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import sympy as sp

from slowflow.support.errors import NotSettled

from ..forces.quadrature import FUNCTIONS, lost_at, singular_at
from ..given import in_text
from ..mechanisms import Parameter
from ..paper.restoring_force import at_breakpoint
from ..symbols import u
from .curved import Curved, curved

#: what a force may be made of
KNOWN = (sp.Add, sp.Mul, sp.Pow, sp.Symbol, sp.Number, sp.NumberSymbol, *FUNCTIONS)


@dataclass(frozen=True)
class Sided:
    """A force of any kind of symmetry, dimensionless.

    name, title -- of the generated module, and one line
    pieces      -- f(u), piece by piece by rising u
    ends        -- the u at which each piece but the last ends
    design      -- what a user gives beside the damping; the kernels take just these
    reach, reach_reason -- largest |u| that it can take, or `sp.oo`, and what happens there
    """

    name: str
    title: str
    pieces: tuple[sp.Expr, ...]
    ends: tuple[sp.Expr, ...]
    design: tuple[Parameter, ...]
    reach: sp.Expr = sp.oo
    reach_reason: str = ""

    @property
    def parameters(self) -> tuple[sp.Symbol, ...]:
        """The design's symbols."""
        return tuple(parameter.symbol for parameter in self.design)

    @property
    def jumps(self) -> tuple[sp.Expr, ...]:
        """What the force loses at each end: f below less f above, 0 where it only bends."""
        lost = at_breakpoint if self.is_polynomial else partial(lost_at, order=0)
        return tuple(lost(below - above, end) for (below, above), end in self._met)

    @property
    def steps(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """Derivatives of each piece by its formula at u = 0, as many as the force has; then their gains at each end."""
        orders = range(max(sp.degree(piece, u) if piece.has(u) else 0 for piece in self.pieces) + 1)
        formulas = tuple(tuple(sp.diff(piece, u, order).subs(u, 0) for order in orders) for piece in self.pieces)
        gains = tuple(
            tuple(-at_breakpoint(sp.diff(below - above, u, order), end) for order in orders)
            for (below, above), end in self._met
        )
        return formulas + gains

    @property
    def is_polynomial(self) -> bool:
        """Whether all of its pieces are polynomials."""
        return all(piece.is_polynomial(u) for piece in self.pieces)

    @property
    def curved(self) -> Curved:
        """What its means are summed from, where it is no polynomial in pieces."""
        return curved(self.pieces, self.ends, self.parameters)

    @property
    def _met(self) -> Sequence[tuple[tuple[sp.Expr, sp.Expr], sp.Expr]]:
        return tuple(zip(pairwise(self.pieces), self.ends, strict=True))


def check(force: Sided) -> None:
    """That the means of a force are known: raises ArithmeticError with the reason where they are not."""
    for number, piece in enumerate(force.pieces, start=1):
        if piece.has(sp.Abs, sp.sign):
            raise NotSettled(f"{force.name}: piece {number} has |u|: with odd=False each side is a piece of its own")
        strange = [part for part in sp.preorder_traversal(piece) if not isinstance(part, KNOWN)]
        if strange:
            names = ", ".join(function.__name__ for function in FUNCTIONS)
            raise NotSettled(
                f"{force.name}: piece {number} contains {strange[0].func.__name__}, whose average is not known; "
                f"allowed are {names} and powers; a change of formula at some u needs a piece of its own"
            )
        for end in force.ends[max(number - 2, 0) : number]:
            value, singular = sp.simplify(piece.subs(u, end)), singular_at(piece, end)
            if value.is_infinite or value is sp.nan or value.has(sp.zoo, sp.oo):
                raise NotSettled(f"{force.name}: piece {number} is infinite at u = {in_text(end)}")
            if singular:
                raise NotSettled(
                    f"{force.name}: piece {number} has {in_text(singular[0])}, which is singular at u = {in_text(end)}"
                )
    for number, (low, high) in enumerate(pairwise(force.ends), start=2):
        if (high - low).is_nonpositive or high.is_real is False:
            raise NotSettled(
                f"{force.name}: piece {number} ends at u = {in_text(high)}, which is not above {in_text(low)}"
            )
