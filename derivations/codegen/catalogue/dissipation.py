"""The kernels of other laws of damping: functions of I_0, the part of I that knows no frequency, and of d.

In:  `Results`.
Out: `dissipation_module`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import sympy as sp

from ...extensions.dissipation import (
    I_0,
    I_A,
    R_A,
    REST,
    Dissipation,
    I_0_over_A,
    I_over_A,
    System,
    d,
    h_over_A,
    level,
    steepest,
    u_cr,
    x,
)
from ...paper.slow_flow import I, R, m
from ...results import Results
from ...symbols import F_0, A, Omega, c_2, eta, h, h_A, h_AA, h_AAA, zeta
from ...systems.slopes import DERIVATIVES, Slopes
from ..form import Kernel, Module, plain

#: arguments, in their order
KNOWN = (Omega, x, A, F_0, *REST, zeta, d, h, h_A, h_AA, h_AAA)
#: what the compiled search takes on numbers, and on intervals
IN_C = {
    *("quadratic", "restoring", "at_rest", "released", "I", "I_A", "far", "F", "F_A", "F_AA"),
    *("response_quartic", "fold_quartic", "far_by_inertia", "structural_bound", "quadratic_bound", "least_scaled"),
    *("static", "limit_envelope", "R_of_peak", "F_A_halved", "F_OmegaOmega", "Omega_A", "Omega_A_by_inertia"),
    *("full_by_inertia", "rest_moves", "released_moves", "F_AOmegaOmega"),
    *("cusp_bend", "isola_bend", "cusp_bend_by_inertia", "isola_bend_by_inertia"),
}
ENCLOSED = {
    *("at_rest", "released", "I", "I_A", "far", "R_of_response", "R_of_peak", "R_where_stationary"),
    *("far_by_inertia", "F_A_scaled", "I_scaled", "static", "turn_share"),
    *("rest_intercept", "released_intercept", "sine_intercept", "sine_intercept_far", "velocity"),
}
#: what each system of the search is, in words, see `Dissipation.searched`
SEARCHED = {
    "folds": ("F and F_A/2", "(24), (30)"),
    "peaks": ("F and what vanishes where the level is stationary", "(24)"),
    "cusps": ("F_A/2 and F_AA/2", "(30), (33)"),
    "isolas": ("F_A/2 and what vanishes where the level is stationary", "(30)"),
    "turns": ("F_A/2 and F_AOmega/(4 Omega)", "(30)"),
}


def needed(outputs: Sequence[sp.Expr], *more: sp.Symbol) -> list[sp.Symbol]:
    """The arguments of outputs, in their order."""
    symbols = set(more).union(*(output.free_symbols for output in outputs))
    return [symbol for symbol in KNOWN if symbol in symbols]


def dissipation_module(results: Results) -> Module:
    """The mechanism-free functions; R, and what contains I as a number, are those of `slow_flow`."""
    flow, of = results.flows[""], results.dissipation
    amplitude = "A > 0"

    def at_point(name: str, value: sp.Expr, doc: str, equation: str) -> Kernel:
        lets = [(symbol, whole) for symbol, whole in ((R, flow.R), (I, of.I)) if value.has(symbol)]
        arguments = needed([value, *(whole for _, whole in lets)])
        return plain(name, arguments, value, doc, equation, lets=lets)

    def in_derivatives(
        name: str, values: Sequence[sp.Expr], doc: str, others: dict[tuple[int, int], sp.Expr] | None = None
    ) -> Kernel:
        known = {DERIVATIVES[a, w]: one for (a, w), one in {**derivatives, **(others or {})}.items()}
        used = [(symbol, one) for symbol, one in known.items() if any(value.has(symbol) for value in values)]
        lets = [(R, flow.R), (I, of.I), *used]
        arguments = needed([*values, *(whole for _, whole in lets)])
        outputs = values if len(values) > 1 else values[0]
        return plain(name, arguments, outputs, doc, "from (24), (30)", lets=lets)

    slopes = results.slopes
    derivatives = {
        (2, 0): of.F_AA,
        (3, 0): of.F_AAA,
        (0, 1): of.F_Omega,
        (1, 1): of.F_AOmega,
        (0, 2): of.F_OmegaOmega,
    }
    found = Module(
        name="dissipation",
        title="Structural and quadratic damping, and dry friction of what is attached",
        inputs=("paper/averaging.py", "paper/slow_flow.py", "extensions/dissipation.py"),
        kernels=(
            plain(
                "quadratic", (c_2,), of.quadratic, "Quadratic damping's factor of A^2 Omega^2 in I.", "from (19)", "any"
            ),
            plain(
                "restoring",
                (A, F_0, d),
                of.restoring,
                "The largest |h| of a state with this amplitude, as quadratic damping bounds its frequency.",
                "from (23)",
                "A > 0, d > 0",
            ),
            plain(
                "at_rest",
                (A, m, eta),
                of.at_rest,
                "I_0, I at Omega = 0, and three derivatives by A: friction acts throughout.",
                "from (19)",
                amplitude,
            ),
            plain(
                "released",
                (A, m, eta, u_cr),
                of.released,
                "The same where friction acts for |u| < u_cr only.",
                "from (19)",
                "A >= u_cr > 0",
            ),
            plain(
                "rest_moves",
                (A,),
                of.rest_moves,
                "What m, then eta, does to I_0, I_0A and I_0AA: friction acts throughout.",
                "from (19)",
                amplitude,
            ),
            plain(
                "released_moves",
                (A, m, u_cr),
                of.released_moves,
                "What m, then eta, then u_cr does to them where friction acts for |u| < u_cr only.",
                "from (19)",
                "A >= u_cr > 0",
            ),
            at_point("I", of.I, "Sine balance, -F_0 sin phi at a fixed point.", "(23)"),
            at_point("I_A", of.I_A, "dI/dA.", "(23)"),
            plain(
                "far",
                (x, A, *REST[:2], zeta, d, h, h_A),
                of.far,
                "R, R_A, I and I_A over Omega^2, at x = 1/Omega.",
                "(23)",
                "x >= 0, A > 0",
            ),
            at_point("F", of.F, "Zero at a steady state.", "(24)"),
            at_point("F_A", of.F_A, "dF/dA; positive where stable.", "(24), (30)"),
            at_point("F_AA", of.F_AA, "d2F/dA2.", "(24)"),
            at_point("F_Omega", of.F_Omega, "dF/dOmega.", "(24)"),
            at_point("F_OmegaOmega", of.F_OmegaOmega, "d2F/dOmega2.", "(24)"),
            at_point("F_AOmega", of.F_AOmega, "d2F/dA dOmega.", "(24)"),
            at_point("F_AOmegaOmega", of.F_AOmegaOmega, "d3F/dA dOmega2.", "(24)"),
            at_point("Omega_A", of.Omega_A, "dOmega/dA along the response.", "from (24)"),
            at_point("Omega_A_by_inertia", of.Omega_A_by_inertia, "The same of an excitation by inertia.", "from (24)"),
            in_derivatives(
                "cusp_bend",
                (slopes.cusp,),
                "Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum.",
            ),
            isola_bend(of, flow.R, slopes),
            at_point("stability", of.stability, "4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.", "(30)"),
            plain(
                "static",
                (F_0, *REST[:2], h, h_A),
                of.static,
                "F at Omega = 0 by its halves h - c and h + c, c^2 = F_0^2 - I_0^2; and the slope of each.",
                "from (24)",
                "F_0 > I_0",
                lets=of.static_lets,
            ),
            plain(
                "response_quartic",
                needed(of.response_quartic),
                of.response_quartic,
                "F + F_0^2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^4.",
                "(24)",
                amplitude,
            ),
            plain(
                "fold_quartic",
                needed(of.fold_quartic),
                of.fold_quartic,
                "F_A/2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^4.",
                "(30)",
                amplitude,
            ),
            plain(
                "limit_envelope",
                (Omega, F_0, m, zeta, eta, d),
                of.limit_envelope,
                "Largest amplitude that the forcing can hold at this frequency, where friction acts throughout.",
                "(27)",
                "Omega > 0, F_0 > m, one of zeta, eta, d > 0",
            ),
            plain(
                "turn_share",
                (x, A, *REST[:2], zeta, d),
                of.turn_share,
                "D/Omega^2 at x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D.",
                "from (30)",
                "x >= 0, A > 0",
            ),
            *searched_kernels(of),
            *inertial_kernels(of, slopes, in_derivatives),
            *(searched_system(name, of.searched[name]) for name in of.searched),
        ),
    )
    return replace(
        found,
        kernels=tuple(
            replace(
                kernel,
                generic=True,
                in_c=kernel.name in {*IN_C, *of.searched},
                enclosed=kernel.name in {*ENCLOSED, *of.searched},
            )
            for kernel in found.kernels
        ),
        cells=intercept_kernels(of),
    )


def isola_bend(of: Dissipation, of_R: sp.Expr, slopes: Slopes) -> Kernel:
    """Second derivatives of F, whose squares cancel in the determinant."""
    F_AA = DERIVATIVES[2, 0]
    lets = [(R, of_R), (I, of.I), (F_AA, of.F_AA), *of.hessian_lets]
    by_it = sp.cancel(slopes.isola_by_it / slopes.determinant)
    return plain(
        "isola_bend",
        needed([whole for _, whole in lets]),
        (of.hessian, by_it * of.hessian),
        "At an isola point: negative at a saddle of F; and as `cusp_bend`.",
        "from (24), (30)",
        lets=lets,
    )


def inertial_kernels(of: Dissipation, slopes: Slopes, in_derivatives: Callable[..., Kernel]) -> list[Kernel]:
    """What an excitation by inertia takes from what vanishes at a point, and where its response ends."""
    return [
        plain(
            "far_by_inertia",
            (x, A, F_0, I_0, zeta, d, h),
            of.far_by_inertia,
            "F/Omega^4 at x = 1/Omega; and -Omega^3/4 dlevel^2/dOmega, less Omega times the third.",
            "(24)",
            "x >= 0, A > 0",
        ),
        in_derivatives(
            "cusp_bend_by_inertia",
            (of.cusp_bend_by_inertia,),
            "As `cusp_bend`, for an excitation by inertia.",
        ),
        in_derivatives(
            "isola_bend_by_inertia",
            (slopes.determinant, slopes.isola_by_it),
            "As `isola_bend`, for an excitation by inertia.",
            {(0, 2): of.F_OmegaOmega_by_inertia},
        ),
        plain(
            "full_by_inertia",
            (F_0, d),
            of.full_by_inertia,
            "The amplitude that the response tends to as Omega grows.",
            "from (24)",
            "F_0 > 0",
        ),
        plain(
            "structural_bound",
            (A, F_0, eta, h, steepest),
            of.structural_bound,
            "Both positive: no state above A, while |h| grows by steepest dA at most.",
            "from (23), (24)",
            "A > 0",
        ),
        plain(
            "quadratic_bound", (F_0, d), of.quadratic_bound, "What no amplitude exceeds.", "from (23), (24)", "d > 0"
        ),
    ]


def searched_kernels(of: Dissipation) -> list[Kernel]:
    """What the search in boxes takes from what vanishes at a point, and what excludes all points of a box."""
    stated = (
        (of.F_A_halved, "F_A_halved", (R, R_A, I, I_A), "F_A/2 by R, I and their slopes.", "(30)"),
        (of.R_of_response, "R_of_response", (F_0, I), "The size of R where F = 0.", "(24)"),
        (of.R_of_peak, "R_of_peak", (Omega, A, zeta, d, I), "R where F_Omega = 0.", "from (24)"),
        (
            of.R_where_stationary,
            "R_where_stationary",
            (x, A, I_0, zeta, d),
            "Where a level by inertia is stationary, x = 1/Omega: what is not negative, lower and higher R/Omega^2.",
            "from (24)",
        ),
        (of.I_scaled, "I_scaled", (Omega, A, I_0_over_A, zeta, d), "I/A, by I_0/A.", "(23)"),
        (of.F_A_scaled, "F_A_scaled", (Omega, h_over_A, h_A, I_over_A, I_A), "F_A/(2 A), by h/A and I/A.", "(30)"),
    )
    least = "Of what 4/A times the least F_A/2 is not below where |k| <= A^2 |h_AA|/2, friction throughout: 1, A^2."
    return [
        *(
            plain(name, arguments, value, doc, equation, "Omega >= 0, A > 0")
            for value, name, arguments, doc, equation in stated
        ),
        plain("least_scaled", (Omega, zeta, eta, d, h_AA), of.least_scaled, least, "from (30)", "Omega >= 0"),
    ]


def intercept_kernels(of: Dissipation) -> tuple[Kernel, ...]:
    """Where tangents of I along A meet A = 0, and A Omega by I: on intervals only."""
    rest = "I_0 - A I_0A: friction acts throughout."
    return (
        plain("rest_intercept", (m,), of.rest_intercept, rest, "from (19)", "A > 0"),
        plain(
            "released_intercept",
            (A, m, u_cr),
            of.released_intercept,
            "The same where friction acts for |u| < u_cr only.",
            "from (19)",
            "A >= u_cr > 0",
        ),
        plain(
            "sine_intercept",
            (Omega, A, level, d),
            of.sine_intercept,
            "I - A I_A, by that of I_0.",
            "from (23)",
            "Omega >= 0, A > 0",
        ),
        plain(
            "sine_intercept_far",
            (x, A, level, d),
            sp.expand((of.sine_intercept / Omega**2).subs(Omega, 1 / x)),
            "The same over Omega^2, at x = 1/Omega.",
            "from (23)",
            "x >= 0, A > 0",
        ),
        plain(
            "R_of_peak_by_rest",
            (Omega, A, I_0, zeta, d),
            of.R_of_peak_by_rest,
            "R where F_Omega = 0, by I at Omega = 0.",
            "from (24)",
            "Omega > 0, A > 0",
        ),
        plain("velocity", (I, I_0, zeta, d), of.velocity, "A Omega by I.", "from (23)", "I >= I_0"),
    )


def searched_system(name: str, system: System) -> Kernel:
    """The same arguments for all, so that the search has them in a table."""
    of, *rest = name.split("_")
    (doc, equation), unknown = SEARCHED[of], rest[-1]
    over = " of an excitation by inertia, over powers of Omega, x = 1/Omega" if "far" in rest else ""
    return plain(
        name,
        [x if "far" in rest else Omega, *KNOWN[2:], R, I, R_A, I_A],
        (*system.values, *system.slopes),
        f"{doc}{over}; derivatives by A and by {unknown} of the first, then of the second.",
        f"from {equation}",
        "Omega > 0, A > 0",
    )
