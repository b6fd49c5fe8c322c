"""Steps 4 and on: Newton's method on the equations that define an answer, one step in closed form.

In:  the slow flow, and isola points (`along`); the mechanism stays an open h(A).
Out: `Formulas`, by the kind of answer what its unknowns change by, in R, I and the derivatives of h: J step = -f, where
     f is what should vanish and J its Jacobian. Beside it `turn`, the share by which the slope of one of the equations
     changes along the step: where that is no small number the step is not the last; 0 where it is no equation's.

    state        F = 0               A at Omega and F_0
    fold         F = F_A = 0         Omega and A at F_0
    peak         F = F_Omega = 0     Omega and A at F_0
    cusp         F_A = F_AA = 0      Omega and A, and F_0 from F = 0
    isola        F_A = F_Omega = 0   Omega and A, and F_0 from F = 0: by F_A without I, which is 2 R times `turns`, and
                                     by F without R, or what rounding leaves of R decides where damping is next to none
    corner       F = 0               Omega at F_0, A being a breakpoint
    ridge        F_Omega = 0         Omega at an amplitude
    level        F = 0               F_0 at Omega and A: Omega need be right to first order only where F_Omega = 0

With f to more digits than a double has, a step from an answer that is nearly right leaves its rounding alone; of J a
few digits are enough.
"""

from __future__ import annotations

import sympy as sp

from ..kernels import Formulas, Lets
from ..paper.slow_flow import I, R, m, slope
from ..symbols import F_0, A, Omega, h, h_A, h_AA, h_AAA, zeta

#: of every step, of which most need few
ARGUMENTS = (Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA)

#: by the answer: what vanishes, that from which F_0 is had last; in which unknowns; which of it turns first
EQUATIONS = {
    "state": (("F",), (A,), "F"),
    "fold": (("F", "F_A"), (Omega, A), "F_A"),
    "peak": (("F", "F_Omega"), (Omega, A), "F"),
    "cusp": (("F_A", "F_AA", "F"), (Omega, A, F_0), "F_AA"),
    "isola": (("turns", "F_Omega", "excess"), (Omega, A, F_0), "F_A"),
    "corner": (("F",), (Omega,), "F"),
    "ridge": (("F_Omega",), (Omega,), "F_Omega"),
    "level": (("F",), (F_0,), ""),
}
#: derivatives of these along A and along Omega
SLOPES = {
    "F": ("F_A", "F_Omega"),
    "F_A": ("F_AA", "F_AOmega"),
    "F_AA": ("F_AAA", "F_AAOmega"),
    "F_Omega": ("F_AOmega", "F_OmegaOmega"),
    "turns": ("turns_A", "turns_Omega"),
    "excess": ("excess_A", "excess_Omega"),
}


def steps(flow: Formulas, loci: Formulas) -> Formulas:
    """All of them."""
    of, known = Formulas(ARGUMENTS, {R: flow.R, I: flow.I}), _known(flow, loci)
    for kind, (_, unknowns, _) in EQUATIONS.items():
        changed = ", ".join(str(unknown) for unknown in unknowns)
        text = f"By what {changed} change at a {kind}, and how far that is from linear."
        values, step = _step(known, *EQUATIONS[kind])
        step = Lets([*of.lets.items(), *step.lets], step.value)
        of.add(f"{kind}_step", step, text, "from (24)", arguments=ARGUMENTS, to_pairs=values)
    return of


def _known(flow: Formulas, loci: Formulas) -> dict[str, sp.Expr]:
    """F, what stands for it and for F_A at an isola point, which are free of R, and their derivatives, by name."""

    def derivative(expression: sp.Expr, unknown: sp.Symbol) -> sp.Expr:
        if unknown == A:
            return slope(expression, {I: sp.diff(flow.I, A)})
        return sp.diff(expression, Omega) + sp.diff(expression, I) * sp.diff(flow.I, Omega)

    known = {"turns": loci.isola_turns, "excess": loci.isola_excess}
    for name, expression in list(known.items()):
        for unknown, slope_of_it in zip((A, Omega), SLOPES[name], strict=True):
            known[slope_of_it] = sp.factor_terms(derivative(expression, unknown))
    return {**vars(flow), **known}


def _step(
    known: dict[str, sp.Expr], equations: tuple[str, ...], unknowns: tuple[sp.Symbol, ...], turning: str
) -> tuple[tuple[sp.Symbol, ...], Lets]:
    """What should vanish; and the step by Cramer's rule, the derivatives being names. F_0 is in one equation alone."""

    def slope_of(equation: str, unknown: sp.Symbol) -> str:
        return SLOPES[equation][unknown == Omega]

    names: dict[str, sp.Symbol] = {}

    def named(name: str) -> sp.Symbol:
        return names.setdefault(name, sp.Symbol(name, real=True))

    varied = [unknown for unknown in unknowns if unknown != F_0]
    values = sp.Matrix([named(name) for name in equations[: len(varied)]])
    jacobian = sp.Matrix([[named(slope_of(name, unknown)) for unknown in varied] for name in equations[: len(varied)]])
    determinant = jacobian.det()
    changes = []
    for column in range(len(varied)):
        replaced = jacobian.copy()
        replaced[:, column] = -values
        changes.append(replaced.det() / determinant)
    vanish = [*values]
    if F_0 in unknowns:
        last = equations[-1]
        vanish.append(named(last))
        left = vanish[-1] + sum(named(slope_of(last, x)) * change for x, change in zip(varied, changes, strict=True))
        changes.append(-left / sp.diff(known[last], F_0))
    first = slope_of(turning, varied[-1]) if turning else ""
    turn = sp.Integer(0)
    if first in SLOPES:
        turned = sum(named(slope_of(first, x)) * change for x, change in zip(varied, changes, strict=False))
        turn = turned / named(first)
    return tuple(vanish), Lets([(symbol, known[name]) for name, symbol in names.items()], (*changes, turn))
