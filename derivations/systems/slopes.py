"""Beside (24), (30): how frequency and forcing change along the response and along the fold locus.

In:  `SlowFlow`; the mechanism stays an open h(A).
Out: `Slopes`, in R, I and the derivatives of F, whose values are `lets`.

By implicit differentiation of an open F(A, Omega), with the level L^2 = F + F_0^2 of a state:

    response     F = 0      dOmega/dA = -F_A/F_Omega
    fold locus   F_A = 0    dOmega/dA = -F_AA/F_AOmega, with it d L^2/dA, and d^2 L^2/dA^2: at a cusp, where F_AA = 0,
                            and at an isola point, where F_Omega = 0, it says whether L has a minimum
    tail         A -> 0     the branch from A = 0, Omega = inf: F = 0 with I = m, and h no farther from 0 than A
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

from ..claims import claim
from ..paper.slow_flow import I, R, SlowFlow, m, slope
from ..symbols import F_0, A, Omega, h, h_A
from .along import T

Let = tuple[sp.Symbol, sp.Expr]

_F = sp.Function("F")(A, Omega)
_square = sp.Symbol("square", real=True)


def _named(a: int, w: int) -> sp.Symbol:
    """The symbol of a derivative of F."""
    return sp.Symbol("F" + ("_" if a + w else "") + "A" * a + "Omega" * w, real=True)


#: the derivatives of F up to the third by their orders in A and in Omega
DERIVATIVES = {(a, w): _named(a, w) for a in range(4) for w in range(4 - a)}


@dataclass(frozen=True)
class Slopes:
    """In the derivatives of F.

    values  -- of these derivatives, in R, I, h and the derivatives of h
    Omega_A -- slope of the response
    level   -- d L^2/dA along the fold locus, times F_AOmega^2
    cusp, isola -- d^2 L^2/dA^2 along the fold locus at a cusp and at an isola point, times F_AOmega^2 (and over A)
    determinant, isola_by_it -- of F's second derivatives, negative at a saddle; and `isola` by these
    hessian -- the determinant at an isola point, where it has the factors R and I
    at_isola -- what R and h_A are there: if damping is weak h and Omega have few digits of R
    at_cusp -- what R, I and h_A are at a cusp, by T = dR/dA, for the same reason
    tail    -- an amplitude on the branch that comes from A = 0, in its lets
    """

    values: dict[sp.Symbol, sp.Expr]
    Omega_A: sp.Expr
    level: sp.Expr
    cusp: sp.Expr
    isola: sp.Expr
    determinant: sp.Expr
    isola_by_it: sp.Expr
    hessian: sp.Expr
    at_isola: dict[sp.Symbol, sp.Expr]
    at_cusp: dict[sp.Symbol, sp.Expr]
    tail_lets: tuple[Let, ...]
    tail: sp.Expr


def slopes(flow: SlowFlow) -> Slopes:
    """All of it."""
    F_A, F_AA, F_AAA = (DERIVATIVES[a, 0] for a in range(1, 4))
    F_Omega, F_OmegaOmega, F_AOmega = DERIVATIVES[0, 1], DERIVATIVES[0, 2], DERIVATIVES[1, 1]
    on_response = -sp.diff(_F, A) / sp.diff(_F, Omega)
    on_locus = -sp.diff(_F, A, 2) / sp.diff(_F, A, Omega)

    def along_locus(expression: sp.Expr) -> sp.Expr:
        return sp.diff(expression, A) + sp.diff(expression, Omega) * on_locus

    rise, bend = (_in_symbols(value).subs(F_A, 0) for value in (along_locus(_F), along_locus(along_locus(_F))))
    hessian_lets, of_flow = hessian(flow.F_AA * flow.F_OmegaOmega - flow.F_AOmega**2, flow.R, flow.I)
    determinant = _in_symbols(sp.hessian(_F, (A, Omega)).det())
    at_isola = _at_isola(flow)
    of_flow = sp.factor(of_flow.subs(hessian_lets).subs(at_isola).subs(I, flow.I))
    isola = sp.factor(bend.subs(F_Omega, 0) * F_AOmega**2)
    of_hessian, remainder = sp.div(isola, determinant, F_AA)
    claim("the bend at an isola point is a multiple of the determinant", remainder, eq="from (24)")
    amplitude = sp.Symbol("amplitude", nonnegative=True)
    (tail,) = sp.solve(flow.R.subs(h, A).subs(A, amplitude) - R, amplitude)
    return Slopes(
        values={
            F_A: flow.F_A,
            F_AA: flow.F_AA,
            F_AAA: flow.F_AAA,
            F_Omega: flow.F_Omega,
            F_AOmega: flow.F_AOmega,
            F_OmegaOmega: flow.F_OmegaOmega,
        },
        Omega_A=_in_symbols(on_response),
        level=rise * F_AOmega**2,
        cusp=sp.factor(bend.subs(F_AA, 0) * F_AOmega**2 / A),
        isola=of_hessian * of_flow,
        determinant=determinant,
        isola_by_it=of_hessian * determinant,
        hessian=of_flow,
        at_isola=at_isola,
        at_cusp=_at_cusp(flow),
        # the root of a product, which SymPy would take apart
        tail_lets=((_square, (F_0 - m) * (F_0 + m)),),
        tail=tail.subs(R, sp.sqrt(_square)),
    )


def _at_isola(flow: SlowFlow) -> dict[sp.Symbol, sp.Expr]:
    """R from F_Omega = 0, and h_A with it from F_A = 0."""
    (of_R,) = sp.solve(flow.F_Omega, R)
    (of_h_A,) = sp.solve(flow.F_A.subs(R, of_R), h_A)
    return {R: of_R, h_A: sp.cancel(of_h_A)}


def _at_cusp(flow: SlowFlow) -> dict[sp.Symbol, sp.Expr]:
    """R from F_AA = 0, I with it from F_A = 0, and h_A from T."""
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
    error = determinant.subs(lets) - whole
    claim("the determinant of F's second derivatives", error.subs({R: of_R, I: of_I}), eq="from (24)")
    return lets, determinant


def _in_symbols(expression: sp.Expr) -> sp.Expr:
    """The derivatives of F by their symbols, the highest first."""
    for (a, w), symbol in sorted(DERIVATIVES.items(), key=lambda one: -sum(one[0])):
        derivative = sp.diff(_F, *([(A, a)] if a else []), *([(Omega, w)] if w else [])) if a + w else _F
        expression = expression.subs(derivative, symbol)
    return expression
