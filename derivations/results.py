"""All steps of the derivation, run once for every mechanism and scene.

In:  the mechanisms.
Out: `Results`, what `emit/` prints and `ledger/` judges.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from . import elliptic, resultants
from .along import Along, along
from .averaging import Averaged, averaged
from .bounds import Bounds, bounds
from .by_parameter import by_parameter
from .den_hartog import DenHartog, den_hartog
from .dissipation import Dissipation, dissipation
from .frequencies import Frequencies, frequencies
from .gradients import Curve, Gradients, gradients
from .harmonics import Harmonics, of_polynomials, of_untruncated
from .inertia import Inertia, inertia
from .mechanisms import Mechanism, all_mechanisms
from .monotone import prove_monotone
from .motion import Motion, Smoothed, motion, smoothed
from .newton import Step, steps
from .off_centre import Climb, OffCentre, climb, off_centre
from .oscillator import Dimensionless, oscillator
from .restoring import Case, Restoring, restoring
from .resultants import Elimination
from .sampled import Sampled, sampled
from .second_approximation import SecondApproximation, second_approximation
from .slopes import Slopes, slopes
from .slow_flow import SCENES, SlowFlow, slow_flow
from .switching import Switching, switching
from .symbols import u
from .wave import Wave, wave


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
        beside, ends = [piece - u for piece in self.oscillator.polynomials], self.oscillator.breakpoints
        if all(piece.is_polynomial(u) for piece in beside):
            return restoring(beside, tuple(ends), orders=1)
        return elliptic.restoring(beside, ends)

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


@dataclass(frozen=True)
class Results:
    """The whole derivation.

    motion     -- the equation of motion (3)
    smoothed   -- (A1), (A2)
    switching  -- what a deviation from a motion becomes where (3) switches
    averaged   -- steps (8)-(20)
    flows      -- slow flow and its polynomials, by scene
    frequencies -- the quartics whose roots are the frequencies at an amplitude
    inertia    -- what an excitation by inertia has in place of a force
    dissipation -- what other laws of damping have in place of viscous damping and dry friction
    along      -- what vanishes along the amplitude, by scene
    slopes     -- along the response and the fold locus
    bounds     -- what no state at a forcing exceeds
    gradients, inertia_gradients -- how answers move with the parameters, for a force and for an excitation by inertia
    laws_gradients, laws_inertia_gradients -- the same with other laws of damping
    off_centre, climb -- motions about another place than the centre, and the means that these are made of
    sampled    -- the average of a force that is known by its values
    steps      -- of Newton's method on the equations of each answer
    detachment -- (34), by scene
    second     -- the second approximation
    wave       -- its motion over half a cycle
    den_hartog -- (35)-(37)
    mechanisms -- by name
    """

    motion: Motion
    smoothed: Smoothed
    switching: Switching
    averaged: Averaged
    flows: dict[str, SlowFlow]
    frequencies: Frequencies
    inertia: Inertia
    dissipation: Dissipation
    along: dict[str, Along]
    slopes: Slopes
    bounds: Bounds
    gradients: Gradients
    inertia_gradients: Gradients
    laws_gradients: Gradients
    laws_inertia_gradients: Gradients
    off_centre: OffCentre
    climb: Climb
    sampled: Sampled
    steps: dict[str, Step]
    detachment: dict[str, Elimination]
    second: SecondApproximation
    wave: Wave
    den_hartog: DenHartog
    mechanisms: dict[str, OfMechanism]


def of_mechanism(mechanism: Mechanism, flow: SlowFlow | None = None, *, enclosed: bool = False) -> OfMechanism:
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
        resultants.saddle_node_onset(flow, whole) if eliminated else None,
        resultants.saddle_nodes(flow, whole) if eliminated else None,
    )


def derive(mechanisms: Sequence[Mechanism] | None = None) -> Results:
    """Everything, for the given mechanisms or for all of `mechanisms/`."""
    sharp = motion()
    equations = averaged()
    flows = {scene: slow_flow(equations, scene) for scene in SCENES}
    by_inertia, curve = inertia(flows[""]), Curve.of(flows[""])
    by_laws = dissipation(equations, flows[""])
    of_scenes = {scene: along(flow) for scene, flow in flows.items()}
    damped = of_scenes[""].damped
    assert damped is not None
    return Results(
        sharp,
        smoothed(sharp),
        switching(),
        equations,
        flows,
        frequencies(flows[""]),
        by_inertia,
        by_laws,
        of_scenes,
        slopes(flows[""]),
        bounds(flows[""]),
        gradients(curve),
        gradients(curve, by_inertia.force),
        gradients(by_laws.curve),
        gradients(by_laws.curve, by_inertia.force),
        off_centre(equations, flows[""], by_laws),
        climb(),
        sampled(),
        steps(flows[""], damped),
        {scene: resultants.detachment(flow) for scene, flow in flows.items()},
        second_approximation(equations, flows[""]),
        wave(),
        den_hartog(),
        {mechanism.name: of_mechanism(mechanism, flows[""]) for mechanism in mechanisms or all_mechanisms()},
    )
