"""A force that is not odd: a stop on one side only, springs that differ on both sides, a spring with even powers.

In:  pieces of the whole force f(u) by rising u, from below all of them to above all: polynomials; where each ends.
Out: `Sided`; `steps`, the force as a sum of steps, of which `off_centre` has the means over u = B + A cos psi.

There is no motion about the centre to be averaged: f_0(A, B) = c_0 - load and h(A, B) = -2 s_0 are all there is, in the
means c_n of f^(n) and s_n of f^(n) cos psi (`off_centre`), and these are sums over the steps.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import sympy as sp

from .mechanisms import Parameter
from .restoring import at_breakpoint
from .symbols import u


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
        return tuple(at_breakpoint(below - above, end) for (below, above), end in self._met)

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
    def _met(self) -> Sequence[tuple[tuple[sp.Expr, sp.Expr], sp.Expr]]:
        return tuple(zip(pairwise(self.pieces), self.ends, strict=True))


def check(force: Sided) -> None:
    """That the means of a force are known: raises ArithmeticError with the reason where they are not."""
    for number, piece in enumerate(force.pieces, start=1):
        if piece.has(sp.Abs, sp.sign):
            raise ArithmeticError(
                f"{force.name}: piece {number} has |u|: with odd=False each side is a piece of its own"
            )
        if not piece.is_polynomial(u):
            raise ArithmeticError(
                f"{force.name}: piece {number} is no polynomial in u, and with odd=False it has to be"
            )
    for number, (low, high) in enumerate(pairwise(force.ends), start=2):
        if (high - low).is_nonpositive or high.is_real is False:
            raise ArithmeticError(f"{force.name}: piece {number} ends at u = {high}, which is not above {low}")
