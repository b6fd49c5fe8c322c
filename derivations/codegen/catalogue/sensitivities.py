"""The kernels by which answers move with the parameters: one system for every kind of answer, damping and excitation.

In:  `Results`.
Out: `sensitivities_module`.
"""

from __future__ import annotations

from ...extensions.dissipation import REST, d
from ...kernels import plain
from ...paper.slow_flow import R
from ...results import Results
from ...symbols import F_0, A, Omega, h, h_A, h_AA, h_AAA, zeta
from ...systems.gradients import MOVES, OF_PARAMETER, OF_SQUARE, I_0p, d_p, force, force_F, force_Omega, h_p, zeta_p
from ..form import Module


def sensitivities_module(results: Results) -> Module:
    """Asked once an answer, they have no compiled loops in Python."""
    of, equation = results.gradients, "from (23)-(34)"
    excited = "Force, its slopes by Omega and F_0; of its square S_Omega, S_OmegaOmega, S_F, S_FOmega: {}."
    return Module(
        name="sensitivities",
        title="How answers move with the parameters: what the implicit function theorem asks for",
        inputs=(
            "paper/averaging.py",
            "paper/slow_flow.py",
            "extensions/dissipation.py",
            "extensions/inertia.py",
            "systems/gradients.py",
        ),
        kernels=(
            plain(
                "slopes",
                (Omega, A, R, *REST, zeta, d, h, h_A, h_AA, h_AAA, *OF_SQUARE),
                (*of.slopes, *of.sizes),
                "By A, Omega and F_0, of what vanishes by `conventions.SYSTEMS`; then the sizes of these.",
                equation,
                lets=of.lets,
                generic=True,
            ),
            plain(
                "right",
                (Omega, A, R, *REST[:3], zeta, d, h_A, h_AA, *OF_PARAMETER),
                of.right,
                "What a parameter does to what vanishes, with the opposite sign.",
                equation,
                lets=of.lets,
                generic=True,
            ),
            plain(
                "of_state",
                (Omega, A, *REST[:2], zeta, d, h, h_A, force, force_Omega, force_F, h_p, I_0p, zeta_p, d_p, *MOVES),
                of.of_state,
                "d/dp of the phase (25) and of the transmissibility of a state that moves by A_p, Omega_p, F_0_p.",
                equation,
                lets=of.of_state_lets,
                generic=True,
            ),
            plain("by_force", (Omega, F_0), of.by_force, excited.format("a force"), "(3)", "Omega >= 0", generic=True),
            plain(
                "by_inertia",
                (Omega, F_0),
                of.by_inertia,
                excited.format("an excitation by inertia"),
                "beside (3)",
                "Omega >= 0",
                generic=True,
            ),
        ),
    )
