"""All steps of the derivation, run once for every mechanism and scene.

In:  the mechanisms.
Out: `Results`, what `codegen/` prints and `ledger/` judges.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from .asymmetric.off_centre import off_centre
from .extensions.dissipation import dissipation
from .extensions.inertia import inertia
from .extensions.motion import motion
from .extensions.second_approximation import SecondApproximation, second_approximation
from .extensions.switching import switching
from .extensions.wave import Wave, wave
from .forces.of_mechanism import OfMechanism, of_mechanism
from .forces.sampled import sampled
from .kernels import Formulas
from .mechanisms import Mechanism, all_mechanisms
from .paper import critical_forcings
from .paper.averaging import Averaged, averaged
from .paper.critical_forcings import Elimination
from .paper.den_hartog import DenHartog, den_hartog
from .paper.slow_flow import SCENES, SlowFlow, slow_flow
from .systems.along import Along, along
from .systems.bounds import Bounds, bounds
from .systems.frequencies import Frequencies, frequencies
from .systems.gradients import Gradients, gradients
from .systems.newton import Step, steps
from .systems.slopes import Slopes, slopes


@dataclass(frozen=True)
class Results:
    """The whole derivation.

    motion     -- the equation of motion (3), and (A1), (A2)
    switching  -- what a deviation from a motion becomes where (3) switches
    averaged   -- steps (8)-(20)
    flows      -- slow flow and its polynomials, by scene
    frequencies -- the quartics whose roots are the frequencies at an amplitude
    inertia    -- what an excitation by inertia has in place of a force
    dissipation -- what other laws of damping have in place of viscous damping and dry friction
    along      -- what vanishes along the amplitude, by scene
    slopes     -- along the response and the fold locus
    bounds     -- what no state at a forcing exceeds
    gradients  -- how answers move with the parameters
    off_centre -- motions about another place than the centre, and the means that these are made of
    sampled    -- the average of a force that is known by its values
    steps      -- of Newton's method on the equations of each answer
    detachment -- (34), by scene
    second     -- the second approximation
    wave       -- its motion over half a cycle
    den_hartog -- (35)-(37)
    mechanisms -- by name
    """

    motion: Formulas
    switching: Formulas
    averaged: Averaged
    flows: dict[str, SlowFlow]
    frequencies: Frequencies
    inertia: Formulas
    dissipation: Formulas
    along: dict[str, Along]
    slopes: Slopes
    bounds: Bounds
    gradients: Gradients
    off_centre: Formulas
    sampled: Formulas
    steps: dict[str, Step]
    detachment: dict[str, Elimination]
    second: SecondApproximation
    wave: Wave
    den_hartog: DenHartog
    mechanisms: dict[str, OfMechanism]


def derive(mechanisms: Sequence[Mechanism] | None = None) -> Results:
    """Everything, for the given mechanisms or for all of `mechanisms/`."""
    equations = averaged()
    flows = {scene: slow_flow(equations, scene) for scene in SCENES}
    by_inertia = inertia(flows[""])
    of_slopes = slopes(flows[""])
    by_laws = dissipation(equations, flows[""], of_slopes)
    of_scenes = {scene: along(flow) for scene, flow in flows.items()}
    damped = of_scenes[""].damped
    assert damped is not None
    return Results(
        motion(),
        switching(),
        equations,
        flows,
        frequencies(flows[""]),
        by_inertia,
        by_laws,
        of_scenes,
        of_slopes,
        bounds(flows[""]),
        gradients(by_laws.curve, by_inertia.force),
        off_centre(equations, flows[""], by_laws),
        sampled(),
        steps(flows[""], damped),
        {scene: critical_forcings.detachment(flow) for scene, flow in flows.items()},
        second_approximation(equations, flows[""]),
        wave(),
        den_hartog(),
        {mechanism.name: of_mechanism(mechanism, flows[""]) for mechanism in mechanisms or all_mechanisms()},
    )
