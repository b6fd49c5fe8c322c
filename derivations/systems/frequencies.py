"""Step 4 once more: the frequencies at an amplitude, as roots of two quartics that share the form of their derivative.

In:  the slow flow with all damping; the mechanism stays an open h(A).
Out: `Frequencies`: both quartics in Omega with what a solver needs to count and to refine their positive roots.

F = 0 and F_A/2 = 0 are depressed quartics, and so their derivatives are k times a depressed cubic A w^3 + p w + q in
w = Omega, with q >= 0: at most two positive critical points, between which a quartic is monotone. F_Omega/(4 A), whose
roots are the peaks, is the first of these cubics.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..kernels import Formulas
from ..paper.slow_flow import I, R
from ..symbols import A, Omega, h

#: factor of the cubic in a quartic's derivative
k = sp.Symbol("k", positive=True)
#: its linear and its constant coefficient
p, q = sp.symbols("p q", real=True)


@dataclass(frozen=True)
class Quartic:
    """A quartic in Omega.

    value     -- in R and I, structured
    at_0      -- its constant
    k, p, q   -- its derivative is k (A w^3 + p w + q)
    """

    value: sp.Expr
    at_0: sp.Expr
    k: sp.Expr
    p: sp.Expr
    q: sp.Expr


@dataclass(frozen=True)
class Frequencies:
    """Both quartics and what they share.

    R, I          -- (23), in Omega
    response, fold -- (24) F, and (30) F_A/2
    cubic, slope  -- A w^3 + p w + q and its derivative
    rise          -- of a quartic from 0 to a critical point, where q = -A w^3 - p w
    discriminant  -- of the cubic, over A: negative where it has fewer than two positive roots
    """

    R: sp.Expr
    I: sp.Expr
    response: Quartic
    fold: Quartic
    cubic: sp.Expr
    slope: sp.Expr
    rise: sp.Expr
    discriminant: sp.Expr


def frequencies(flow: Formulas) -> Frequencies:
    """All of it."""
    cubic = A * Omega**3 + p * Omega + q
    primitive = sp.integrate(cubic, (Omega, 0, Omega)).subs(q, sp.solve(cubic, q)[0])
    return Frequencies(
        R=flow.R,
        I=flow.I,
        response=_quartic(flow, flow.F),
        fold=_quartic(flow, sp.collect(sp.expand(flow.F_A / 2), R)),
        cubic=sp.horner(cubic, Omega),
        slope=sp.diff(cubic, Omega),
        rise=k * Omega**2 * sp.expand(primitive / Omega**2),
        discriminant=sp.expand(sp.discriminant(cubic, Omega) / A),
    )


def _quartic(flow: Formulas, value: sp.Expr) -> Quartic:
    def whole(expression: sp.Expr) -> sp.Expr:
        return expression.subs({R: flow.R, I: flow.I})

    derivative = sp.Poly(sp.diff(whole(value), Omega), Omega)
    factor = sp.cancel(derivative.LC() / A)
    constant, linear, *others = [
        sp.expand(sp.cancel(derivative.coeff_monomial(Omega**power) / factor)) for power in range(4)
    ]
    if others != [0, A] or factor.has(h):
        raise ArithmeticError(f"the derivative of {value} is not k (A w^3 + p w + q)")
    at_0 = value.subs({R: flow.R.subs(Omega, 0), I: flow.I.subs(Omega, 0)}).subs(Omega, 0)
    return Quartic(value, at_0, factor, linear, constant)
