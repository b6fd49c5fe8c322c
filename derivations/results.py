"""All steps of the derivation, run once for every mechanism and scene.

In:  the mechanisms.
Out: `Results`, what `codegen/` prints and `ledger/` judges.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from .asymmetric.off_centre import off_centre
from .asymmetric.offset import offset
from .extensions.dissipation import dissipation
from .extensions.inertia import inertia
from .extensions.linearization import linearization
from .extensions.motion import motion
from .extensions.second_approximation import second_approximation
from .extensions.switching import switching
from .extensions.wave import wave
from .forces.of_mechanism import OfMechanism, of_mechanism
from .forces.sampled import sampled
from .kernels import Formulas
from .mechanisms import Mechanism, all_mechanisms
from .paper.averaging import Averaged, averaged
from .paper.critical_forcings import detached
from .paper.den_hartog import den_hartog, without_cancellation
from .paper.slow_flow import SCENES, slow_flow
from .systems.along import along
from .systems.frequencies import Frequencies, frequencies
from .systems.gradients import gradients
from .systems.newton import steps
from .systems.slopes import slopes


@dataclass(frozen=True)
class Results:
    """The whole derivation."""

    motion: Formulas  #: the equation of motion (3), and (A1), (A2)
    switching: Formulas  #: what a deviation from a motion becomes where (3) switches
    averaged: Averaged  #: steps (8)-(20)
    flows: dict[str, Formulas]  #: slow flow and its polynomials, by scene
    frequencies: Frequencies  #: the quartics whose roots are the frequencies at an amplitude
    inertia: Formulas  #: what an excitation by inertia has in place of a force
    dissipation: Formulas  #: what other laws of damping have in place of viscous damping and dry friction
    linearization: Formulas  #: stationary random vibration
    along: dict[str, Formulas]  #: what vanishes along the amplitude, by scene
    slopes: Formulas  #: along the response and the fold locus
    gradients: Formulas  #: how answers move with the parameters
    offset: Formulas  #: whether a motion about the centre stays there
    off_centre: Formulas  #: motions about another place than the centre, and the means that these are made of
    sampled: Formulas  #: the average of a force that is known by its values
    steps: Formulas  #: of Newton's method on the equations of each answer
    detachment: dict[str, Formulas]  #: (34), by scene
    second: Formulas  #: the second approximation
    wave: Formulas  #: its motion over half a cycle
    den_hartog: Formulas  #: (35)-(37)
    mechanisms: dict[str, OfMechanism]  #: by name


def derive(mechanisms: Sequence[Mechanism] | None = None) -> Results:
    """Everything, for the given mechanisms or for all of `mechanisms/`."""
    equations = averaged()
    flows = {scene: slow_flow(equations, scene) for scene in SCENES}
    by_inertia = inertia(flows[""])
    of_slopes = slopes(flows[""])
    by_laws = dissipation(equations, flows[""], of_slopes)
    of_scenes = {scene: along(flow) for scene, flow in flows.items()}
    return Results(
        motion(),
        switching(),
        equations,
        flows,
        frequencies(flows[""]),
        by_inertia,
        by_laws,
        linearization(),
        of_scenes,
        of_slopes,
        gradients(by_laws, by_inertia.force),
        offset(),
        off_centre(equations, flows[""], by_laws),
        sampled(),
        steps(flows[""], of_scenes[""]),
        {scene: detached(flow) for scene, flow in flows.items()},
        second_approximation(equations, flows[""]),
        wave(),
        without_cancellation(den_hartog()),
        {mechanism.name: of_mechanism(mechanism, flows[""]) for mechanism in mechanisms or all_mechanisms()},
    )
