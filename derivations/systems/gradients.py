"""Beside (23)-(34): how answers move with the parameters, by the implicit function theorem.

In:  the response by what dissipates; the mechanism stays an open h(A).
Out: `Formulas`: the slopes of what may vanish at an answer, and what one parameter p does to it; `SYSTEMS`, by the
     kind of answer which of these conditions hold, and in which order they are solved for its moves A_p, Omega_p and
     F_0_p.

An answer is a point (A, Omega, F_0) where three conditions hold; what each says of the moves is linear. F stands for
R^2 + I^2 less the force's square S, and its derivatives by Omega with it; of S by F_0 the moves take account of
themselves. A slope that is itself a condition of the answer vanishes there and is left out: what then is left of a
system is solved one unknown after the other, but at an isola point, where two remain together. Each number by which is
divided comes with its size, the sum of its terms without their signs: where one vanishes the answer has no derivative,
as it meets another.
"""

from __future__ import annotations

from itertools import permutations

import sympy as sp

from ..kernels import Formulas, Lets
from ..paper.slow_flow import I, R, slope
from ..symbols import F_0, A, Omega, h, h_A

#: what the parameter does: to h, h_A, h_AA at a fixed A; to what dissipates, see `dissipation`; to the forcing and the
#: frequency that are given, and to the breakpoint that the answer lies on
OF_PARAMETER = sp.symbols(
    "h_p h_Ap h_AAp I_0p I_0Ap I_0AAp zeta_p zeta_Ap zeta_AAp d_p d_3p forcing_p frequency_p end_p", real=True
)
h_p, h_Ap, h_AAp, I_0p, I_0Ap, I_0AAp, zeta_p, zeta_Ap, zeta_AAp, d_p, d_3p, *_ = OF_PARAMETER
*_, forcing_p, frequency_p, end_p = OF_PARAMETER
#: what the answer does
A_p, Omega_p, F_0_p = SENSITIVITIES = sp.symbols("A_p Omega_p F_0_p", real=True)
#: the force's amplitude and its square, and their derivatives by Omega and F_0
force, force_Omega, force_F = sp.symbols("force force_Omega force_F", real=True)
S_Omega, S_OmegaOmega, S_F, S_FOmega = OF_SQUARE = sp.symbols("S_Omega S_OmegaOmega S_F S_FOmega", real=True)

#: the conditions: what vanishes, none where a number is given; and its slopes by A, Omega and F_0 that are not 0
CONDITIONS: dict[str, tuple[str, tuple[str, str, str]]] = {
    "level": ("F", ("F_A", "F_Omega", "S_F")),
    "fold": ("F_A", ("F_AA", "F_AOmega", "")),
    "cusp": ("F_AA", ("F_AAA", "F_AAOmega", "")),
    "top": ("F_Omega", ("F_AOmega", "F_OmegaOmega", "S_FOmega")),
    "backbone": ("R", ("R_A", "R_Omega", "")),
    "forcing": ("", ("", "", "1")),
    "frequency": ("", ("", "1", "")),
    "breakpoint": ("", ("1", "", "")),
}
#: the kinds of answers: the conditions beside "level", and what it is
KINDS: dict[str, tuple[tuple[str, str], str]] = {
    "state": (("forcing", "frequency"), "a steady state; with Omega = 0 a peak at rest"),
    "fold": (("forcing", "fold"), "a fold at a forcing"),
    "corner_fold": (("forcing", "breakpoint"), "a fold at a forcing, on a breakpoint"),
    "peak": (("forcing", "top"), "a peak at a forcing"),
    "cusp": (("fold", "cusp"), "where two folds meet"),
    "isola": (("fold", "top"), "where an isolated curve is born"),
    "corner_top": (("breakpoint", "top"), "the least forcing on a breakpoint"),
    "corner_end": (("breakpoint", "fold"), "where the fold locus meets a breakpoint"),
    "corner_backbone": (("breakpoint", "backbone"), "where the backbone meets a breakpoint"),
    "corner_rest": (("breakpoint", "frequency"), "at Omega = 0 on a breakpoint"),
}


def _system(conditions: tuple[str, str]) -> tuple[int, ...]:
    """Rows of `CONDITIONS` in the order in which they are solved; of the unknowns A, Omega, F_0 the one that each is
    solved for; whether the last two have to be solved together; and which slopes, by 3 row + unknown, vanish.

    Two of these, the same one twice where there are fewer, one that is 0 anyway where there is none.
    """
    names, vanishing = list(CONDITIONS), {CONDITIONS[name][0] for name in conditions} - {""}
    rows = [names.index(name) for name in ("level", *conditions)]
    slopes = {row: CONDITIONS[names[row]][1] for row in rows}
    gone = [3 * row + k for row in rows for k in range(3) if slopes[row][k] in vanishing]
    left = {row: {k for k in range(3) if slopes[row][k] and 3 * row + k not in gone} for row in rows}
    for together in (False, True):
        for order in permutations(rows):
            for unknowns in permutations(range(3)):
                known = [left[row] - set(unknowns[:n]) for n, row in enumerate(order)]
                own = [{unknown} for unknown in unknowns]
                if together:
                    own[1:] = [set(unknowns[1:])] * 2
                    known[2] = left[order[2]] - {unknowns[0]}
                if known == own:
                    padded = [*gone, *(gone or [3 * names.index("fold") + 2]) * 2][:2]
                    return (*order, *unknowns, int(together), *padded)
    raise ArithmeticError(f"the conditions {conditions} do not pin an answer")


#: by the numbers of the kinds
SYSTEMS = tuple(_system(conditions) for conditions, _ in KINDS.values())


def gradients(curve: Formulas, inertial: sp.Expr) -> Formulas:
    """All of it, for a force and for an excitation by inertia, whose force is given in F_0 and Omega.

    curve -- the response (24) with its derivatives; `by_parameter`, what a parameter does at a fixed A to each symbol
             of these; `rises`, derivatives by A of their symbols, beside those of h
    """
    excited = (*OF_SQUARE, force, force_Omega, force_F)
    of = Formulas([*dict.fromkeys((Omega, A, R, *curve.order, *excited, *OF_PARAMETER, *SENSITIVITIES))])
    known = {
        "": sp.Integer(0),
        "1": sp.Integer(1),
        **{name: getattr(curve, name) for name in ("F_A", "F_AA", "F_AAA", "F_AOmega", "F_AAOmega")},
        "F_Omega": curve.F_Omega - S_Omega,
        "F_OmegaOmega": curve.F_OmegaOmega - S_OmegaOmega,
        "S_F": -S_F,
        "S_FOmega": -S_FOmega,
        "R_A": slope(curve.R),
        "R_Omega": sp.diff(curve.R, Omega),
    }
    own = {"forcing": forcing_p, "frequency": frequency_p, "breakpoint": end_p}
    slopes = [known[name] for _, names in CONDITIONS.values() for name in names]
    sizes = [size(value, {R: curve.R, I: curve.I}) for value in slopes]
    lets, equation = [(I, curve.I)], "from (23)-(34)"
    text = "By A, Omega and F_0, of what vanishes by `conventions.SYSTEMS`; then the sizes of these."
    of.add("slopes", Lets(lets, (*slopes, *sizes)), text, equation)
    right = [
        -_by_parameter(curve, getattr(curve, name)) if name else own[condition]
        for condition, (name, _) in CONDITIONS.items()
    ]
    text = "What a parameter does to what vanishes, with the opposite sign."
    of.add("right", Lets(lets, right), text, equation)
    text = "d/dp of the phase (25) and of the transmissibility of a state that moves by A_p, Omega_p, F_0_p."
    of.add("of_state", _of_state(curve), text, equation)
    text = "Force, its slopes by Omega and F_0; of its square S_Omega, S_OmegaOmega, S_F, S_FOmega: {}."
    for name, by, what, where in (
        ("by_force", F_0, "a force", "(3)"),
        ("by_inertia", inertial, "an excitation by inertia", "beside (3)"),
    ):
        of.add(name, _excited(by), text.format(what), where, "Omega >= 0", arguments=(Omega, F_0))
    return of


def _excited(by: sp.Expr) -> tuple[sp.Expr, ...]:
    """A force's amplitude, its slopes by Omega and F_0, and S_Omega, ... of its square."""
    S = by**2
    of_square = (sp.diff(S, Omega), sp.diff(S, Omega, 2), sp.diff(S, F_0), sp.diff(S, F_0, Omega))
    return (by, sp.diff(by, Omega), sp.diff(by, F_0), *of_square)


def _by_parameter(curve: Formulas, expression: sp.Expr) -> sp.Expr:
    """d/dp of an expression in R, I and what they are made of, at fixed A, Omega and F_0."""
    direct = curve.by_parameter
    of_R_and_I = {
        name: sum(sp.diff(value, symbol) * move for symbol, move in direct.items())
        for name, value in ((R, curve.R), (I, curve.I))
    }
    chain = direct | of_R_and_I
    return sp.factor_terms(sum(sp.diff(expression, symbol) * move for symbol, move in chain.items()))


def _of_state(curve: Formulas) -> Lets:
    """d phi/dp and d transmissibility/dp of a state, from its own sensitivities."""
    R_moved, I_moved = sp.symbols("R_moved I_moved", real=True)

    def total(value: sp.Expr) -> sp.Expr:
        return sp.expand(
            _by_parameter(curve, value) + slope(value, curve.rises) * A_p + sp.diff(value, Omega) * Omega_p
        )

    phase = sp.diff(curve.phase, R) * R_moved + sp.diff(curve.phase, I) * I_moved
    value = curve.transmissibility.subs(F_0, force)
    changes = {h: h_p + h_A * A_p, I: I_moved, force: force_Omega * Omega_p + force_F * F_0_p}
    transmitted = sum(sp.diff(value, symbol) * move for symbol, move in changes.items())
    lets = ((R, curve.R), (I, curve.I), (R_moved, total(curve.R)), (I_moved, total(curve.I)))
    return Lets(lets, (sp.factor_terms(sp.simplify(phase)), sp.factor_terms(transmitted)))


def size(expression: sp.Expr, of: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    """The sum of an expression's terms without their signs, those of the symbols in `of` put in."""
    if expression in of:
        return size(of[expression], of)
    if expression.is_Add or expression.is_Mul:
        return expression.func(*(size(term, of) for term in expression.args))
    if expression.is_Pow:
        return size(expression.base, of) ** expression.exp
    return sp.Abs(expression)
