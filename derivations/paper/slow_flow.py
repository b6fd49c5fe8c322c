"""Step 4, equations (23)-(30) and (38): fixed points of the slow flow and what follows from them, for any mechanism.

In:  the averaged equations; the mechanism stays an open h(A) = H(A) - A.
Out: `SlowFlow`: expressions in A, Omega, F_0, zeta, m = 4 mu/pi, h, h_A, h_AA, h_AAA, in structured (unexpanded) form:

    R = A Omega^2 + h        I = 2 zeta A Omega + m        F = R^2 + I^2 - F_0^2

`scene` substitutes the parameters that vanish before the last steps, so that each scene gets its own polynomials.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy.codegen.cfunctions import hypot

from ..claims import claim
from ..symbols import F_0, A, Omega, h, h_A, h_AA, h_AAA, mu, phi, sigma, zeta
from .averaging import Averaged, H

R, I = sp.symbols("R I", real=True)
m = sp.Symbol("m", nonnegative=True)
#: -h as A tends to 0, where it pulls inwards; Omega^2
preload, turn = sp.symbols("preload turn", nonnegative=True)
#: 1 less the square of a transmissibility; the root of it times F_0; sqrt(h^2 + removed^2)
reduction, removed, whole = sp.symbols("reduction removed whole", nonnegative=True)

#: the scenes that vanishing damping parameters give, by name
SCENES: dict[str, dict[sp.Symbol, sp.Expr]] = {
    "": {},
    "mu0": {mu: sp.Integer(0)},
    "zeta0": {zeta: sp.Integer(0)},
    "mu0_zeta0": {mu: sp.Integer(0), zeta: sp.Integer(0)},
}


@dataclass(frozen=True)
class SlowFlow:
    """Fixed points, response, stability; the equation each belongs to in brackets.

    m             -- (23): friction's share of I, 4 mu/pi; everything else is in the symbol m
    R, I          -- (23): R = A Omega^2 + h = -F_0 cos phi, I = 2 zeta A Omega + m = -F_0 sin phi
    F             -- (24): response, R^2 + (I - F_0)(I + F_0) = 0, in R and I
    F_A, F_AA, F_AAA, F_Omega, F_AOmega, F_AAOmega, F_OmegaOmega -- its derivatives, in R, I, h and
        the derivatives of h
    phase         -- (25): tan phi = I/R, phi in its quadrant
    backbone      -- (26): R = 0, Omega^2 = -h/A
    limit_envelope -- (27): I = F_0, A_L = (F_0 - m)/(2 zeta Omega)
    jacobian      -- (28): D_q Gamma = [-zeta, R/(2 Omega); -(Omega^2 + h_A)/(2 A Omega), -I/(2 A Omega)]
    stability     -- (30): 4 Omega^2 det(D_q Gamma) = F_A/(2 A); stable where positive
    equivalent_damping -- (38): zeta + m/(2 A Omega)
    transmissibility -- amplitude of the transmitted force's fundamental harmonic over F_0
    isolation      -- the frequency at which the square of that is 1 - reduction though the mass moves, by its lets:
        where h pulls inwards, and where it pushes outwards
    held           -- the level where A tends to 0 under a preload, below which a mass stays at rest
    response_quartic, fold_quartic, peak_cubic -- coefficients by power of Omega, constant first, of F + F_0^2,
        of F_A/2 and of F_Omega/(4 A); all three lack their second-highest power
    """

    m: sp.Expr
    R: sp.Expr
    I: sp.Expr
    F: sp.Expr
    F_A: sp.Expr
    F_AA: sp.Expr
    F_AAA: sp.Expr
    F_Omega: sp.Expr
    F_AOmega: sp.Expr
    F_AAOmega: sp.Expr
    F_OmegaOmega: sp.Expr
    phase: sp.Expr
    backbone: sp.Expr
    limit_envelope: sp.Expr
    jacobian: sp.Matrix
    stability: sp.Expr
    equivalent_damping: sp.Expr
    transmissibility: sp.Expr
    isolation_lets: tuple[tuple[tuple[sp.Symbol, sp.Expr], ...], ...]
    isolation: sp.Expr
    held: sp.Expr
    response_quartic: tuple[sp.Expr, ...]
    fold_quartic: tuple[sp.Expr, ...]
    peak_cubic: tuple[sp.Expr, ...]


def slope(expression: sp.Expr, slopes: dict[sp.Symbol, sp.Expr] | None = None) -> sp.Expr:
    """d/dA along h, its derivatives and the symbols whose slopes are given."""
    chain = {**(slopes or {}), h: h_A, h_A: h_AA, h_AA: h_AAA}
    return sp.diff(expression, A) + sum(sp.diff(expression, symbol) * value for symbol, value in chain.items())


def _coefficients(expression: sp.Expr, degree: int) -> tuple[sp.Expr, ...]:
    """Coefficients by power of Omega, constant first; an error unless the second-highest one vanishes."""
    polynomial = sp.Poly(expression, Omega)
    claim(f"a polynomial of degree {degree} in Omega", polynomial.degree() == degree, eq="(24)")
    claim("without its second-highest power", polynomial.coeff_monomial(Omega ** (degree - 1)), eq="(24)")
    return tuple(sp.collect(polynomial.coeff_monomial(Omega**k), (h, A)) for k in range(degree + 1))


def _isolation(R_value: sp.Expr) -> tuple[tuple[tuple[sp.Symbol, sp.Expr], ...], ...]:
    """Lets of Omega^2 > 0 where h^2 + I^2 = (1 - reduction) F_0^2 on R^2 + I^2 = F_0^2: for h <= 0, and for h > 0.

    As a quadratic in Omega^2 it has one positive root, the product of both being negative. Each form adds numbers of
    one sign only: no digits cancel. Without a reduction that is -2 h/A, or 0.
    """
    balance = sp.Poly(sp.expand(R_value.subs(Omega**2, turn) ** 2 - h**2 - removed**2), turn)
    square, half, constant = (
        balance.coeff_monomial(turn**2),
        balance.coeff_monomial(turn) / 2,
        balance.coeff_monomial(1),
    )
    root = sp.sqrt(sp.factor(half**2 - square * constant) / A**2).subs(A**2, A * A)
    quadratic = balance.degree() == 2 and constant == -(removed**2)
    claim("Omega^2 of a transmissibility solves a quadratic with one positive root", quadratic, eq="from (23)")
    claim("the square of what its root takes is h^2 + removed^2", root**2, h**2 + removed**2, eq="from (23)")
    share = A / square  # of Omega^2, of a force
    inwards, outwards = (whole - half / A) * share, removed**2 / ((whole + half / A) * A)
    of_lets = ((removed, F_0 * sp.sqrt(reduction)), (whole, hypot(h, removed)))
    for found in (inwards, outwards):
        claim("both forms of it solve that", balance.as_expr().subs(turn, found).subs(whole, root), eq="from (23)")
    return tuple((*of_lets, (turn, found)) for found in (inwards, outwards))


def slow_flow(averaged: Averaged, scene: str = "") -> SlowFlow:
    """All of step 4, in one scene of `SCENES`."""
    vanishing = SCENES[scene]
    friction = sp.expand(-2 * Omega * averaged.slow_flow[0]).coeff(mu) * mu
    of_m = {mu: vanishing.get(mu, sp.solve(friction - m, mu)[0])}
    A_rate, A_phi_rate = (
        sp.expand(rate.subs({sigma: Omega**2 - 1, H: h + A}).subs(of_m).subs(vanishing)) for rate in averaged.slow_flow
    )
    phi_rate = A_phi_rate / A

    # (23): each averaged equation is (its forcing term) + (the rest) = 0, scaled so that the former has factor F_0
    sine = sp.expand(-2 * Omega * A_rate)
    cosine = sp.expand(-2 * Omega * A_phi_rate)
    I_value = sp.collect(sp.expand(sine - F_0 * sp.sin(phi)), A)
    R_value = sp.collect(sp.expand(cosine - F_0 * sp.cos(phi)), A)

    # (24): square and add; the products keep the digits that an expansion would cancel
    F = R**2 + (I - F_0) * (I + F_0)
    R_A, I_A = sp.diff(R_value, A) + sp.diff(R_value, h) * h_A, sp.diff(I_value, A)
    R_Omega, I_Omega = sp.diff(R_value, Omega), sp.diff(I_value, Omega)
    along_A = {R: R_A, I: I_A}
    F_A = slope(F, along_A)
    F_AA = slope(F_A, along_A)
    F_AAA = slope(F_AA, along_A)

    def by_Omega(expression: sp.Expr) -> sp.Expr:
        return sp.diff(expression, Omega) + sp.diff(expression, R) * R_Omega + sp.diff(expression, I) * I_Omega

    F_Omega = by_Omega(F)

    whole = {R: R_value, I: I_value}
    jacobian = sp.Matrix([A_rate, phi_rate]).jacobian([A, phi])
    jacobian[0, 0] = jacobian[0, 0] + sp.diff(A_rate, h) * h_A
    jacobian[1, 0] = jacobian[1, 0] + sp.diff(phi_rate, h) * h_A
    at_fixed_point = {F_0 * sp.cos(phi): -R_value, F_0 * sp.sin(phi): -I_value}
    jacobian = jacobian.applyfunc(lambda entry: sp.cancel(sp.expand(entry).subs(at_fixed_point)))
    determinant = sp.expand(4 * Omega**2 * jacobian.det())
    # 2 A det = F_A / (4 Omega^2): the boundary of stability is the fold locus
    claim("F_A = 8 A Omega^2 det(D_q Gamma)", determinant, F_A.subs(whole) / (2 * A), eq="(30)")

    # (27): sin phi = -1 leaves I = F_0
    envelope = sp.solve(I_value - F_0, A)
    # (26): cos phi = 0 leaves R = 0
    backbone = sp.sqrt(sp.solve(R_value.subs(Omega**2, R), R)[0])
    # (38): the viscous damping whose term in (23) equals both
    viscous = sp.Symbol("viscous")
    equivalent = sp.expand(sp.solve(2 * viscous * Omega * A - I_value, viscous)[0])
    return SlowFlow(
        m=friction.subs(vanishing),
        R=R_value,
        I=I_value,
        F=F,
        F_A=sp.factor_terms(F_A),
        F_AA=sp.factor_terms(F_AA),
        F_AAA=sp.factor_terms(F_AAA),
        F_Omega=sp.factor_terms(F_Omega),
        F_AOmega=sp.factor_terms(by_Omega(F_A)),
        F_AAOmega=sp.factor_terms(by_Omega(F_AA)),
        F_OmegaOmega=sp.factor_terms(by_Omega(F_Omega)),
        phase=sp.atan2(-I, -R),
        backbone=backbone,
        limit_envelope=envelope[0] if envelope else sp.oo,
        jacobian=jacobian,
        stability=sp.factor_terms(F_A / (2 * A)),
        equivalent_damping=equivalent,
        # the base feels F_0 cos(Omega tau) - u'': at a fixed point its harmonics are h and I
        transmissibility=hypot(h, I) / F_0,
        isolation_lets=_isolation(R_value),
        isolation=sp.sqrt(turn),
        held=hypot(I_value.subs(A, 0), -R_value.subs({A: 0, h: -preload})),
        response_quartic=_coefficients((F + F_0**2).subs(whole), 4),
        fold_quartic=_coefficients((F_A / 2).subs(whole), 4),
        peak_cubic=_coefficients(sp.cancel(F_Omega.subs(whole) / (4 * A)), 3),
    )
