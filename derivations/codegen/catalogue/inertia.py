"""The kernels of an excitation by inertia: what differs from those of a force.

In:  `Results`.
Out: `inertia_module`.
"""

from __future__ import annotations

from functools import partial

import sympy as sp

from ...extensions.inertia import cubic, excited, fall, holds, linear, lost, other, rest, share, x
from ...paper.slow_flow import I, R, m, reduction
from ...results import Results
from ...symbols import F_0, A, Omega, h, h_A, h_AA, h_AAA, zeta
from ...systems.along import k
from ..form import Branch, Kernel, Module, plain
from .flow import of_R_and_I


def inertia_module(results: Results) -> Module:
    """The mechanism-free functions; those of `slow_flow` that know no forcing hold here too."""
    flow, of = results.flows[""], results.inertia
    of_flow = partial(of_R_and_I, flow)
    damped = (m, zeta)
    wanted = {"enclosed": True}

    def on_locus(name: str, value: sp.Expr, doc: str) -> Kernel:
        needs = value.subs({R: flow.R, I: flow.I}).free_symbols
        arguments = [symbol for symbol in (Omega, A, *damped, h, h_A, h_AA, h_AAA) if symbol in needs]
        return of_flow(name, arguments, value, doc, "from (24), (30)")

    return Module(
        name="inertia",
        title="Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance",
        inputs=("paper/equation_of_motion.py", "paper/averaging.py", "paper/slow_flow.py", "extensions/inertia.py"),
        kernels=(
            plain("force", (Omega, F_0), of.force, "Amplitude of the force on the mass.", "beside (3)", "Omega >= 0"),
            plain(
                "force_slopes", (Omega, F_0), of.force_slopes, "Its slopes by Omega, F_0.", "beside (3)", "Omega >= 0"
            ),
            plain(
                "amplitude",
                (Omega, excited),
                of.amplitude,
                "The F_0 of a force at one frequency.",
                "beside (3)",
                "Omega > 0",
                looped=False,
            ),
            plain(
                "moves_from",
                (F_0, holds),
                of.moves_from,
                "The Omega from which on the force exceeds what holds a mass at rest, 4 mu/pi on the average.",
                "beside (3)",
                "F_0 > 0, holds >= 0",
                lets=of.moves_from_lets,
                looped=False,
            ),
            plain(
                "isolation",
                (A, F_0, reduction, h),
                of.isolation,
                "Frequency of a state that transmits sqrt(1 - reduction) of what drives it, though it moves.",
                "from (23)",
                "A > F_0 sqrt(reduction), 0 <= reduction < 1, h <= 0",
                lets=of.isolation_lets,
            ),
            of_flow(
                "level",
                (Omega, A, *damped, h),
                of.level,
                "The amplitude F_0 of the excitation for which (Omega, A) is a steady state.",
                "from (24)",
            ),
            of_flow("F", (Omega, A, F_0, *damped, h), of.F, "Zero at a steady state.", "from (24)"),
            of_flow(
                "level_slope",
                (Omega, A, *damped, h),
                of.level_slope,
                "Omega^5 times the derivative of level^2 by Omega.",
                "from (24)",
            ),
            of_flow("Omega_A", (Omega, A, *damped, h, h_A), of.Omega_A, "dOmega/dA along the response.", "from (24)"),
            Kernel(
                "outer",
                (A, F_0, *damped, h),
                (
                    Branch("falling", ((of.outer_falls, sp.S.Zero),), of.outer_lets, of.outer),
                    Branch("rising", (), of.outer_lets, of.outer_beyond),
                ),
                "1/Omega^2 below the low frequency of an amplitude, and above the high one, where it has that.",
                "from (24)",
                "A > 0, where F has a root",
                returns="tuple",
            ),
            plain(
                "terms",
                (A, *damped, h),
                of.terms,
                "What the least level of an amplitude follows from; it has one where the first, fall, is positive.",
                "from (24)",
                "A > 0",
                **wanted,
            ),
            plain(
                "least",
                (fall, linear, rest),
                of.least,
                "x = 1/Omega where the level of an amplitude is least, by its `terms`.",
                "from (24)",
                "fall > 0, linear >= 0, rest > 0",
            ),
            plain(
                "least_Omega_A",
                (x, A, *damped, h, h_A),
                of.least_Omega_A,
                "dOmega/dA where the level of an amplitude is least: what a rounding of A does to Omega there.",
                "from (24)",
                "x of `least`, h < 0",
            ),
            plain(
                "peak",
                (x, A, F_0, *damped, h, h_A),
                of.peak,
                "The least level of an amplitude less F_0, and its slope along A.",
                "from (24)",
                "x of `least`, h < 0",
                lets=of.peak_lets,
                **wanted,
            ),
            plain(
                "isola",
                (x, A, *damped, h, h_A, h_AA),
                of.isola,
                "Has the sign of F_A where an amplitude's level is least: zero at an isola point; its slope along A.",
                "from (24), (30)",
                "x of `least`, h < 0",
                lets=of.isola_lets,
                **wanted,
            ),
            plain(
                "isola_apart",
                (x, A, *damped, h, k, cubic),
                of.isola_apart,
                "The same without its slope by k = h - A h_A and cubic = 3 h - A h_A, small where h is like A^3.",
                "from (24), (30)",
                "x of `least`, h < 0",
                lets=of.isola_lets,
                **wanted,
            ),
            plain(
                "fold_slopes",
                (Omega, A, *damped, k),
                of.fold_slopes,
                "dR/dA at a fold by k = h - A h_A: of the two with F_A = 0 the larger, the other; -R/I with the first.",
                "from (30)",
                "Omega > 0, A > 0, zeta > 0, k other than 0",
                lets=of.fold_slopes_lets,
            ),
            plain(
                "fold_force",
                (Omega, A, *damped, other),
                of.fold_force,
                "The F_0 of a force at a fold, by the one of `fold_slopes` that is not its own.",
                "from (24), (30)",
                "Omega > 0, A > 0",
                lets=[(I, flow.I)],
            ),
            plain(
                "fold_level",
                (Omega, A, *damped, other),
                of.fold_level,
                "The F_0 of a fold, by the one of `fold_slopes` that is not its own.",
                "from (24), (30)",
                "Omega > 0, A > 0",
                lets=[(I, flow.I)],
            ),
            plain(
                "peak_share",
                (Omega, A, *damped),
                of.peak_share,
                "-R/I where the level is least and R small beside A Omega^2.",
                "from (24)",
                "Omega > 0, A > 0, zeta > 0",
                lets=of.peak_share_lets,
            ),
            plain(
                "Omega_of_share",
                (A, F_0, *damped, share),
                of.Omega_of_share,
                "Omega of a steady state with that -R/I.",
                "from (24)",
                "A > 0, F_0 > 0",
                lets=of.Omega_of_share_lets,
            ),
            on_locus(
                "level_rise",
                of.level_rise,
                "Positive where the level rises with A along the fold locus, negative where it falls.",
            ),
            on_locus(
                "cusp_bend",
                of.cusp_bend,
                "Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum.",
            ),
            plain(
                "hessian",
                (Omega, A, *damped, h, h_A, h_AA),
                of.hessian,
                "At an isola point: negative where the level has a saddle in (A, Omega).",
                "from (24), (30)",
                lets=[(R, flow.R), (I, flow.I), *of.hessian_lets],
            ),
            plain(
                "bound",
                (A, F_0, zeta, h, h_A, h_AA, h_AAA, lost),
                of.bound,
                "Positive where no state has an amplitude A > F_0, if zeta^2 A <= lost |h|; three derivatives by A.",
                "from (24)",
                "A > 0, h < 0, lost <= 1/2",
            ),
            plain(
                "share",
                (A, zeta, h),
                of.share,
                "What zeta^2 A is of |h|: `lost` of the `bound`.",
                "from (24)",
                "h < 0",
                lets=of.share_lets,
            ),
        ),
    )
