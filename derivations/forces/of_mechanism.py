"""The steps of the derivation that need a mechanism.

In:  a `Mechanism`; for resultants the slow flow.
Out: `OfMechanism`, with steps that not everybody asks for derived at the first question.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from ..kernels import Formulas
from ..mechanisms import Mechanism
from ..paper import critical_forcings
from ..paper.critical_forcings import Elimination
from ..paper.equation_of_motion import Dimensionless, oscillator
from ..paper.restoring_force import Case, Restoring, restoring
from ..symbols import u
from . import elliptic
from .by_parameter import by_parameter
from .harmonics import Harmonics, of_polynomials, of_untruncated
from .monotone import prove_monotone


@dataclass(frozen=True)
class OfMechanism:
    """What is derived for one mechanism.

    oscillator        -- dimensionless force, coefficients, breakpoints
    whole             -- h and its derivatives: the average of the whole restoring force u + F_k
    saddle_node_onset -- (33), with all damping terms; None where h is no polynomial, or where it was not asked for
    saddle_nodes      -- Res_Omega(F, F_A); likewise
    """

    oscillator: Dimensionless
    whole: Restoring
    saddle_node_onset: Elimination | None
    saddle_nodes: Elimination | None

    @cached_property
    def beside_vertical(self) -> Restoring:
        """H and H_A, untruncated with further derivatives: the average of F_k alone; no solver asks for it."""
        pieces, ends = [piece - u for piece in self.oscillator.polynomials], self.oscillator.breakpoints
        if all(piece.is_polynomial(u) for piece in pieces):
            return restoring(pieces, tuple(ends), orders=1)
        return elliptic.restoring(pieces, ends)

    @cached_property
    def harmonics(self) -> Harmonics:
        """h_3, h_5 and their derivatives, of the whole restoring force; the ledger does without."""
        pieces, breakpoints = self.oscillator.polynomials, self.oscillator.breakpoints
        if all(piece.is_polynomial(u) for piece in pieces):
            return of_polynomials(pieces, tuple(breakpoints))
        return of_untruncated(pieces, breakpoints)

    @cached_property
    def by_parameter(self) -> tuple[Case, ...]:
        """How the average of the whole force changes with each parameter; the ledger does without."""
        return by_parameter(self.whole, self.oscillator.breakpoints, self.oscillator.mechanism.parameters)


def of_mechanism(mechanism: Mechanism, flow: Formulas | None = None, *, enclosed: bool = False) -> OfMechanism:
    """Steps that need the mechanism; resultants, which no solver asks, only with the slow flow.

    Raises ArithmeticError where it is not proved how h goes between two amplitudes, unless that is `enclosed`.
    """
    dimensionless = oscillator(mechanism)
    if not enclosed:
        prove_monotone(dimensionless)
    pieces, ends = dimensionless.polynomials, dimensionless.breakpoints
    polynomial = all(piece.is_polynomial(u) for piece in pieces)
    eliminated = flow is not None and polynomial
    whole = restoring(pieces, tuple(ends)) if polynomial else elliptic.restoring(pieces, ends)
    return OfMechanism(
        dimensionless,
        whole,
        critical_forcings.saddle_node_onset(flow, whole) if eliminated else None,
        critical_forcings.saddle_nodes(flow, whole) if eliminated else None,
    )
