"""The modules whose kernels a step of the derivation states by itself.

In:  `Results`.
Out: `stated_module`, by name.
"""

from __future__ import annotations

import sympy as sp

from ...extensions.second_approximation import RESONANCE
from ...results import Results
from ..form import Module
from ..requests import requested

#: by module: the steps, by their names in `Results`; title; files that it is derived from
MODULES = {
    "inertia": (
        ("inertia",),
        "Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance",
        ("paper/equation_of_motion.py", "paper/averaging.py", "paper/slow_flow.py", "extensions/inertia.py"),
    ),
    "off_centre": (
        ("off_centre",),
        "Motions off the centre, u = B + A cos psi, by the means of the force and its derivatives over a cycle",
        ("paper/averaging.py", "paper/slow_flow.py", "asymmetric/off_centre.py"),
    ),
    "dissipation": (
        ("dissipation",),
        "Structural and quadratic damping, and dry friction of what is attached",
        ("paper/averaging.py", "paper/slow_flow.py", "extensions/dissipation.py"),
    ),
    "linearization": (
        ("linearization",),
        "Stationary random vibration by statistical linearization",
        ("paper/equation_of_motion.py", "extensions/linearization.py"),
    ),
    "sensitivities": (
        ("gradients",),
        "How answers move with the parameters: what the implicit function theorem asks for",
        (
            *("paper/averaging.py", "paper/slow_flow.py", "extensions/dissipation.py"),
            *("extensions/inertia.py", "systems/gradients.py"),
        ),
    ),
    "sampled": (
        ("sampled",),
        "The average of a force that is known by its values and those of its derivatives, u = A sine",
        ("forces/quadrature.py", "forces/sampled.py"),
    ),
    "motion": (
        ("motion", "switching"),
        "The equation of motion of any mechanism, in the values of its force",
        ("paper/equation_of_motion.py", "extensions/motion.py", "extensions/switching.py"),
    ),
    "second_approximation": (
        ("second", "wave"),
        "Second approximation of any mechanism, with higher harmonics, in A = A_1 + a_3 + a_5",
        ("paper/averaging.py", "paper/slow_flow.py", "extensions/second_approximation.py", "extensions/wave.py"),
    ),
    "den_hartog": (
        ("den_hartog",),
        "Den Hartog's exact solution of the linear oscillator with dry friction, without stops",
        ("paper/den_hartog.py",),
    ),
}
#: constants that go with their kernels
CONSTANTS = {"second_approximation": {"RESONANCE": sp.Integer(RESONANCE)}}


def stated_module(name: str, results: Results) -> Module:
    """All kernels of its steps, as `requests` has them; what contains R and I as numbers is of `slow_flow`."""
    steps, title, inputs = MODULES[name]
    kernels = [kernel for step in steps for kernel in getattr(results, step).kernels.values()]
    constants = CONSTANTS.get(name, {})
    stated = requested(name, kernels)
    in_c = any(kernel.in_c for kernel in stated)
    return Module(name=name, title=title, inputs=inputs, stated=stated, constants=constants, in_c=in_c)
