"""Beside (24), (30): how frequency and forcing change along the response and along the fold locus.

In:  the slow flow; the mechanism stays an open h(A).
Out: `Formulas` in R, I and the derivatives of F, whose values are lets.

By implicit differentiation of an open F(A, Omega), with the level L^2 = F + F_0^2 of a state:

    response     F = 0      dOmega/dA = -F_A/F_Omega
    fold locus   F_A = 0    dOmega/dA = -F_AA/F_AOmega, with it d L^2/dA, and d^2 L^2/dA^2: at a cusp, where F_AA = 0,
                            and at an isola point, where F_Omega = 0, it says whether L has a minimum
    tail         A -> 0     the branch from A = 0, Omega = inf: F = 0 with I = m, and h no farther from 0 than A
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import sympy as sp

from ..claims import claim
from ..kernels import Formulas, Let, Lets
from ..paper.slow_flow import ORDER, I, R, m, slope
from ..symbols import F_0, A, Omega, h, h_A
from .along import T

_F = sp.Function("F")(A, Omega)
_square = sp.Symbol("square", real=True)


def _named(a: int, w: int) -> sp.Symbol:
    """The symbol of a derivative of F."""
    return sp.Symbol("F" + ("_" if a + w else "") + "A" * a + "Omega" * w, real=True)


#: the derivatives of F up to the third by their orders in A and in Omega
DERIVATIVES = {(a, w): _named(a, w) for a in range(4) for w in range(4 - a)}


def slopes(flow: Formulas) -> Formulas:
    """All of it."""
    F_A, F_AA, F_AAA = (DERIVATIVES[a, 0] for a in range(1, 4))
    F_Omega, F_OmegaOmega, F_AOmega = DERIVATIVES[0, 1], DERIVATIVES[0, 2], DERIVATIVES[1, 1]
    on_locus = -sp.diff(_F, A, 2) / sp.diff(_F, A, Omega)
    of, both = Formulas((*ORDER, T)), "from (24), (30)"

    def along_locus(expression: sp.Expr) -> sp.Expr:
        return sp.diff(expression, A) + sp.diff(expression, Omega) * on_locus

    def in_derivatives(value: sp.Expr, there: Mapping[sp.Symbol, sp.Expr] = {}) -> Lets:
        """there: what R, I and h_A are at the points where it is asked, as far as it is more than anywhere else"""
        known = {symbol: whole for symbol, whole in there.items() if symbol != R}
        of_flow = {one: getattr(flow, one.name) for one in (F_A, F_AA, F_AAA, F_Omega, F_AOmega, F_OmegaOmega)}
        values = {symbol: whole for symbol, whole in of_flow.items() if value.has(symbol)}
        if known:
            values = {symbol: sp.factor(whole.subs(h_A, known[h_A]).subs(known)) for symbol, whole in values.items()}
        anywhere = {R: flow.R, I: flow.I} if R not in there else {I: flow.I, R: there[R]}
        lets = {symbol: whole for symbol, whole in anywhere.items() if symbol not in known} | values
        return Lets([*lets.items()], value)

    on_response = _in_symbols(-sp.diff(_F, A) / sp.diff(_F, Omega))
    of.add("Omega_A", in_derivatives(on_response), "dOmega/dA along the response.", "from (24)")

    # of L^2 along the fold locus: first and second derivative, times F_AOmega^2 (and over A)
    rise, bend = (_in_symbols(value).subs(F_A, 0) for value in (along_locus(_F), along_locus(along_locus(_F))))
    text = "Positive where the level rises with A along the fold locus, negative where it falls."
    of.add("level_rise", in_derivatives(rise * F_AOmega**2), text, both)
    of_cusp = in_derivatives(sp.factor(bend.subs(F_AA, 0) * F_AOmega**2 / A), _at_cusp(flow))
    text = "Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum; T = dR/dA."
    of.add("cusp_bend", of_cusp, text, both)

    # F's second derivatives, negative at a saddle; at an isola point this has the factors R and I
    of.determinant = _in_symbols(sp.hessian(_F, (A, Omega)).det())
    lets, value = hessian(flow.F_AA * flow.F_OmegaOmega - flow.F_AOmega**2, flow.R, flow.I)
    at_isola = _at_isola(flow)
    value = sp.factor(value.subs(lets).subs(at_isola).subs(I, flow.I))
    isola = sp.factor(bend.subs(F_Omega, 0) * F_AOmega**2)
    of_hessian, remainder = sp.div(isola, of.determinant, F_AA)
    claim(
        "the curvature of the fold locus at an isola point is a multiple of the Hessian determinant of `F`",
        remainder,
        eq="from (24)",
    )
    of.isola_by_it = of_hessian * of.determinant
    of.add("isola_bend", in_derivatives(of_hessian * value, at_isola), "The same at an isola point.", both)
    text = "F_AA F_OmegaOmega - F_AOmega^2 at an isola point: negative at a saddle."
    of.add("isola_hessian", value, text, both)

    @of.kernel("from (24)", "Omega > 0, F_0 >= m")
    def tail() -> Lets:
        """An amplitude of the size of that far above resonance."""
        amplitude = sp.Symbol("amplitude", nonnegative=True)
        (value,) = sp.solve(flow.R.subs(h, A).subs(A, amplitude) - R, amplitude)
        # the root of a product, which SymPy would take apart
        return Lets([(_square, (F_0 - m) * (F_0 + m))], value.subs(R, sp.sqrt(_square)))

    return of


def _at_isola(flow: Formulas) -> dict[sp.Symbol, sp.Expr]:
    """R from F_Omega = 0, and h_A with it from F_A = 0: if damping is weak h and Omega have few digits of R."""
    (of_R,) = sp.solve(flow.F_Omega, R)
    (of_h_A,) = sp.solve(flow.F_A.subs(R, of_R), h_A)
    return {R: of_R, h_A: sp.cancel(of_h_A)}


def _at_cusp(flow: Formulas) -> dict[sp.Symbol, sp.Expr]:
    """R from F_AA = 0, I with it from F_A = 0, and h_A from T, for the same reason."""
    (of_T,) = sp.solve(slope(flow.R) - T, h_A)
    (of_R,) = sp.solve(flow.F_AA.subs(h_A, of_T), R)
    (of_I,) = sp.solve(flow.F_A.subs(h_A, of_T), I)
    return {R: of_R, I: of_I, h_A: of_T}


def hessian(
    whole: sp.Expr, of_R: sp.Expr, of_I: sp.Expr, by_A: Callable[[sp.Expr], sp.Expr] = slope
) -> tuple[tuple[Let, ...], sp.Expr]:
    """The determinant `whole` of F's second derivatives without the squares that cancel where R is small.

    F/2 has the second derivatives G + S: G of the slopes of R and I alone, whose determinant is the square of theirs,
    and S of R and I themselves.
    """
    ways = (by_A, lambda value: sp.diff(value, Omega))
    gradients = [[way(value) for way in ways] for value in (of_R, of_I)]
    jacobian = sp.factor(sp.Matrix(gradients).det())
    pairs = ((0, 0), (0, 1), (1, 1))
    G = [sum(row[i] * row[j] for row in gradients) for i, j in pairs]
    S = [sum(name * ways[i](ways[j](value)) for name, value in ((R, of_R), (I, of_I))) for i, j in pairs]
    names = sp.symbols("G_AA G_AOmega G_OmegaOmega S_AA S_AOmega S_OmegaOmega", real=True)
    G_AA, G_AO, G_OO, S_AA, S_AO, S_OO = names
    determinant = 4 * (jacobian**2 + (G_AA * S_OO - 2 * G_AO * S_AO + G_OO * S_AA) + (S_AA * S_OO - S_AO**2))
    lets = tuple(zip(names, (*G, *S), strict=True))
    # whatever R and I are
    claim("Hessian determinant of `F` in a form without cancellation", determinant.subs(lets) - whole, eq="from (24)")
    return lets, determinant


def _in_symbols(expression: sp.Expr) -> sp.Expr:
    """The derivatives of F by their symbols, the highest first."""
    for (a, w), symbol in sorted(DERIVATIVES.items(), key=lambda one: -sum(one[0])):
        derivative = sp.diff(_F, *([(A, a)] if a else []), *([(Omega, w)] if w else [])) if a + w else _F
        expression = expression.subs(derivative, symbol)
    return expression
