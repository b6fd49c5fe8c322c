"""The kernels beside the slow flow: the second approximation, and Den Hartog's exact solution.

In:  `Results`.
Out: `second_approximation_module`, `den_hartog_module`.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ...extensions.second_approximation import OF_HARMONIC, RESONANCE
from ...extensions.wave import A_1, cosine, kappa, of_spring, sine, turned
from ...kernels import Kernel, plain
from ...paper import den_hartog as dh
from ...paper.den_hartog import S
from ...paper.slow_flow import m
from ...results import Results
from ...symbols import F_0, A, Omega, h, mu, tau, zeta
from ..form import AVERAGED, Module


def second_approximation_module(results: Results) -> Module:
    """The mechanism-free functions of the second approximation."""
    second = results.second
    families = (AVERAGED, *OF_HARMONIC.values())
    reached = f"Omega > 0, A > 0, |h| < {RESONANCE} A Omega^2"

    def kernel(name: str, forcing: Sequence[sp.Symbol], derivatives: int, outputs: Sequence[str], doc: str) -> Kernel:
        averages = (symbol for family in families for symbol in family[: derivatives + 1])
        values = [second.outputs[output] for output in outputs]
        arguments = (Omega, A, *forcing, m, zeta, *averages)
        return plain(name, arguments, values, doc, "beyond (23)", reached, lets=second.lets)

    return Module(
        name="second_approximation",
        title="Second approximation of any mechanism, with higher harmonics, in A = A_1 + a_3 + a_5",
        inputs=("paper/averaging.py", "paper/slow_flow.py", "extensions/second_approximation.py", "extensions/wave.py"),
        kernels=(
            kernel(
                "response",
                (F_0,),
                2,
                ("u_max", "A_1", "phi", "R", "F", "F_A", "F_Omega", "R_A", "R_Omega"),
                "Largest displacement, A_1 and phase, R, F, and dF/dA, dF/dOmega, dR/dA, dR/dOmega.",
            ),
            kernel(
                "detachment",
                (),
                2,
                ("level", "u_max", "turning"),
                "The forcing (24), largest displacement, and what vanishes where the forcing that reaches it is least.",
            ),
            kernel(
                "detachment_by_inertia",
                (),
                2,
                ("level_by_inertia", "u_max", "turning_by_inertia"),
                "The same of an excitation by inertia.",
            ),
            kernel(
                "folds",
                (F_0,),
                3,
                ("F", "F_A", "F_AA"),
                "F and its derivatives: a fold has F = F_A = 0, a cusp all three.",
            ),
            plain(
                "components",
                (Omega, A, m, h, *(family[0] for family in OF_HARMONIC.values())),
                [second.outputs[name] for name in ("u_max", "A_1", "sine", "cosine", "a_3", "a_5", "kappa")],
                "Largest displacement and what `wave` takes.",
                "beyond (23)",
                reached,
                lets=second.lets,
            ),
            plain(
                "wave",
                (turned, Omega, m, A_1, sine, cosine, *of_spring.values(), kappa),
                results.wave.outputs,
                "u and u' at an angle after the mass turned at its largest displacement.",
                "beyond (23)",
                f"Omega > 0, 0 <= turned <= pi, |kappa| < {RESONANCE}",
                lets=results.wave.lets,
            ),
        ),
        constants={"RESONANCE": sp.Integer(RESONANCE)},
    )


def den_hartog_module(results: Results) -> Module:
    """The linear oscillator with dry friction."""
    exact = dh.without_cancellation(results.den_hartog)
    named = [(dh.V, exact.response), (dh.U, exact.damping)]
    away = "Omega > 0, Omega not 1, 1/3, 1/5 and so on"
    return Module(
        name="den_hartog",
        title="Den Hartog's exact solution of the linear oscillator with dry friction, without stops",
        inputs=("paper/den_hartog.py",),
        kernels=(
            plain("V", (Omega,), exact.response, "Response function.", "(37)", "Omega > 0, Omega != 1"),
            plain("U", (Omega,), exact.damping, "Damping function.", "(37)", away),
            plain(
                "S_ratio",
                (tau, Omega),
                exact.slope_ratio,
                "S is the maximum of this over 0 < tau < pi/Omega.",
                "(37)",
                f"0 < tau < pi/Omega, {away}",
                lets=named,
            ),
            plain(
                "amplitude",
                (Omega, F_0, mu),
                exact.amplitude,
                "Amplitude of the motion.",
                "(35)",
                f"F_0 |V| > mu |U|, {away}",
                lets=named,
            ),
            plain(
                "bound",
                (Omega, F_0, S),
                exact.bound,
                "The motion has no stops while its amplitude exceeds this.",
                "(36)",
                away,
                lets=named,
            ),
            plain(
                "motion",
                (tau, Omega, A, mu),
                exact.motion,
                "Displacement tau after a maximum.",
                "from (37)",
                f"0 <= tau <= pi/Omega, {away}",
                lets=named,
            ),
        ),
    )
