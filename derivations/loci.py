"""Beside (24)-(34): what vanishes along the amplitude where the response curve or its fold locus changes.

In:  `SlowFlow` of one scene; the mechanism stays an open h(A).
Out: `Along`: functions of A, h and its derivatives, with their slopes along A; `Damped` for zeta > 0, `Undamped` for 0.

The eliminations, each proved on the way:

    isola point  F_A = F_Omega = 0   I from F_Omega leaves F_A = 2 R (h_A - Omega^2); so Omega^2 = h_A, in F_Omega/(4 A)
    cusp         F_A = F_AA = 0      F_AA/2 is a quadratic in X = Omega^2; its discriminant without what cancels
    extremum of F or F_A over Omega  F_Omega/(4 A) and F_AOmega/8 are cubics A w^3 + p w + q; they have positive roots
                                     below a critical p, where the discriminant vanishes
    rest         F = Omega = 0       h^2 = c^2, one smooth function for each sign of h
    zeta = 0                         F_A has the factor R and another, on which F_AA is a product too
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from derivations.slow_flow import I, R, SlowFlow, slope
from derivations.symbols import F_0, A, Omega, h, h_A, h_AA, zeta

Let = tuple[sp.Symbol, sp.Expr]

#: the linear and the constant coefficient of a depressed cubic with leading coefficient A, and the former's slope
p, q, p_A = sp.symbols("p q p_A", real=True)
#: X + c_1/2 at a root X = Omega^2 of F_AA/2 = X^2 + c_1 X + c_0, with its sign
root = sp.Symbol("root", real=True)

_w, _bracket, _bracket_A = sp.symbols("w bracket bracket_A", real=True)
_e, _e_A, _along, _along_A = sp.symbols("e e_A along along_A", real=True)
_product, _cube = sp.symbols("product cube", nonnegative=True)
_c, _X = sp.symbols("c X", real=True)


@dataclass(frozen=True)
class Damped:
    """For zeta > 0; outputs beside lets are in these.

    isola_Omega -- Omega where F_A = F_Omega = 0
    isola     -- F_Omega/(4 A) there and its slope; for m = 0 without the factor Omega, which then is common
    cusps     -- F_AA/2 = X^2 + c_1 X + c_0: -c_1/2, c_0, (c_1/2)^2 - c_0, and the slopes of the latter two
    cusp_F_AAOmega -- F_AAOmega at a root of F_AA, in Omega and `root`
    turn_p_A, peak_p_A -- slope of p in F_AOmega/8 and in F_Omega/(4 A)
    critical  -- of a cubic in p, q: what is positive where it has two positive roots, and its slope
    """

    isola_Omega: sp.Expr
    isola_lets: tuple[Let, ...]
    isola: tuple[sp.Expr, ...]
    cusps_lets: tuple[Let, ...]
    cusps: tuple[sp.Expr, ...]
    cusp_F_AAOmega: sp.Expr
    turn_p_A: sp.Expr
    peak_p_A: sp.Expr
    critical_lets: tuple[Let, ...]
    critical: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Undamped:
    """For zeta = 0.

    Omega   -- where F_A = 0 off the backbone R = 0
    factors -- the two of F_AA/2 there, h_AA and R, each with its slope
    """

    Omega: sp.Expr
    factors: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Along:
    """Of one scene.

    level -- (24): the forcing for which (Omega, A) is a steady state, in R and I
    rest  -- F at Omega = 0 by its two halves h - c and h + c, and the slope of both
    damped, undamped -- of its own: one of them
    """

    level: sp.Expr
    rest_lets: tuple[Let, ...]
    rest: tuple[sp.Expr, ...]
    damped: Damped | None
    undamped: Undamped | None


def _vanishes(expression: sp.Expr, words: str) -> None:
    if sp.cancel(sp.expand(expression)) != 0:
        raise ArithmeticError(f"{words}: {expression} is not zero")


def along(flow: SlowFlow) -> Along:
    """All of it, in the scene of the flow."""
    level = sp.sqrt(sp.expand(flow.F + F_0**2))
    _vanishes(flow.F.subs(F_0, level), "(24) at the forcing of a steady state")
    at_rest = flow.F.subs({R: flow.R, I: flow.I}).subs(Omega, 0)
    product = sp.factor(h**2 - at_rest)
    halves = (h - _c, h + _c)
    _vanishes(sp.Mul(*halves).expand().subs(_c**2, product) - at_rest, "the halves of F at Omega = 0")
    slopes = {slope(half) for half in halves}
    if len(slopes) != 1:
        raise ArithmeticError(f"the halves of F at Omega = 0 have different slopes: {slopes}")
    has_zeta = zeta in flow.I.free_symbols
    return Along(
        level=level,
        rest_lets=((_product, product), (_c, sp.sqrt(_product))),
        rest=(*halves, slopes.pop()),
        damped=_damped(flow) if has_zeta else None,
        undamped=None if has_zeta else _undamped(flow),
    )


def _damped(flow: SlowFlow) -> Damped:
    isola_lets, isola = _isola(flow)
    cusps_lets, cusps, cusp_F_AAOmega = _cusps(flow)
    critical_lets, critical = _critical()
    whole = {R: flow.R, I: flow.I}
    return Damped(
        isola_Omega=_isola_Omega(flow),
        isola_lets=isola_lets,
        isola=isola,
        cusps_lets=cusps_lets,
        cusps=cusps,
        cusp_F_AAOmega=cusp_F_AAOmega,
        turn_p_A=_slope_of_p(sp.expand(flow.F_AOmega.subs(whole) / 8)),
        peak_p_A=_slope_of_p(sp.expand(flow.F_Omega.subs(whole) / (4 * A))),
        critical_lets=critical_lets,
        critical=critical,
    )


def _isola_Omega(flow: SlowFlow) -> sp.Expr:
    """With I from F_Omega = 0, F_A has the factors R and h_A - Omega^2; R = 0 would need I = 0: there is damping."""
    eliminated = sp.expand(flow.F_A.subs(I, sp.solve(flow.F_Omega, I)[0]))
    factor, remainder = sp.div(eliminated, 2 * R, R)
    if remainder != 0 or factor.has(R):
        raise ArithmeticError(f"F_A without I is not R times a function of Omega and h_A: {eliminated}")
    return sp.sqrt(sp.solve(factor.subs(Omega, sp.sqrt(_X)), _X)[0])


def _isola(flow: SlowFlow) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...]]:
    """F_Omega/(4 A) = Omega (A Omega^2 + p) + q at Omega = w."""
    w = _isola_Omega(flow)
    q_value, p_value, _, leading = flow.peak_cubic
    bracket = sp.collect(sp.expand(leading * w**2 + p_value), A)
    lets = ((_bracket, bracket), (_bracket_A, slope(bracket)))
    value = _w * _bracket + q_value
    _vanishes(
        value.subs(_bracket, bracket).subs(_w, w) - flow.F_Omega.subs({R: flow.R, I: flow.I}).subs(Omega, w) / (4 * A),
        "F_Omega/(4 A) at an isola point",
    )
    if q_value == 0:
        return lets, (_bracket, _bracket_A)
    return ((_w, w), *lets), (value, slope(value, {_bracket: _bracket_A, _w: slope(w).subs(w, _w)}))


def _cusps(flow: SlowFlow) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...], sp.Expr]:
    """F_AA/2 in X, with c_1/2 = h_A + e/2: then (h_A)^2, which cancels in the discriminant, never enters it."""
    whole = {R: flow.R, I: flow.I}
    half_F_AA = sp.Poly(sp.expand(flow.F_AA.subs(whole) / 2), Omega)
    if half_F_AA.degree() != 4 or any(power % 2 for (power,) in half_F_AA.monoms()) or half_F_AA.LC() != 1:
        raise ArithmeticError(f"F_AA/2 is not a monic quadratic in Omega^2: {half_F_AA}")
    c_0, c_1 = (half_F_AA.coeff_monomial(Omega**k) for k in (0, 2))
    e = c_1 - 2 * h_A
    square = sp.expand((h_A + _e / 2) ** 2 - c_0)
    if square.has(h_A**2):
        raise ArithmeticError(f"the square of h_A is left in the discriminant of F_AA/2: {square}")
    # e stays whole in its square; elsewhere its value is put in, and what multiplies h_AA is gathered
    rest = sp.collect(sp.expand((square - square.coeff(_e, 2) * _e**2).subs(_e, e)), h_AA, evaluate=False)
    square = square.coeff(_e, 2) * _e**2 + h_AA * _along + rest[sp.S.One]
    values = {_along: rest[h_AA], _e: e}
    _vanishes(square.subs(values) - (c_1**2 / 4 - c_0), "the discriminant of F_AA/2")
    slopes = {_e: _e_A, _along: _along_A}
    lets = (*values.items(), *((slopes[let], slope(value)) for let, value in values.items()))
    outputs = (-h_A - _e / 2, c_0, square, slope(c_0), slope(square, slopes))
    # X = -c_1/2 + root
    at_cusp = sp.expand(flow.F_AAOmega.subs(whole).subs(h_A, sp.solve(Omega**2 + c_1 / 2 - root, h_A)[0]))
    if at_cusp.free_symbols != {Omega, root}:
        raise ArithmeticError(f"F_AAOmega at a root of F_AA is not a function of Omega and the root: {at_cusp}")
    return lets, outputs, at_cusp


def _slope_of_p(cubic: sp.Expr) -> sp.Expr:
    """d/dA of the linear coefficient of A w^3 + p w + q, given in w = Omega."""
    coefficients = sp.Poly(cubic, Omega)
    if coefficients.coeff_monomial(Omega**3) != A or coefficients.coeff_monomial(Omega**2) != 0:
        raise ArithmeticError(f"not a depressed cubic with leading coefficient A: {cubic}")
    if slope(coefficients.coeff_monomial(1)) != 0:
        raise ArithmeticError(f"the constant of the cubic varies with A: {cubic}")
    return slope(coefficients.coeff_monomial(Omega))


def _critical() -> tuple[tuple[Let, ...], tuple[sp.Expr, ...]]:
    """-p - c: at p = -c the discriminant of A w^3 + p w + q vanishes, and two positive roots meet if q > 0."""
    discriminant = sp.discriminant(A * Omega**3 + p * Omega + q, Omega)
    cube = sp.solve(discriminant.subs(p**3, -_cube), _cube)[0]
    _vanishes(discriminant.subs(p, -_c).subs(_c**3, cube), "the discriminant of the cubic where two roots meet")
    # c^3 is the cube, and q does not vary with A
    c_A = sp.cancel(_c * sp.diff(cube, A) / (3 * cube))
    return ((_cube, cube), (_c, sp.cbrt(_cube))), (-p - _c, -p_A - c_A)


def _undamped(flow: SlowFlow) -> Undamped:
    """F_A = 2 R (Omega^2 + h_A); on the second factor F_AA/2 = R h_AA."""
    factor, remainder = sp.div(sp.expand(flow.F_A), 2 * R, R)
    if remainder != 0 or factor.has(R):
        raise ArithmeticError(f"F_A has no factor R: {flow.F_A}")
    square = sp.solve(factor.subs(Omega, sp.sqrt(_X)), _X)[0]
    first, remainder = sp.div(sp.expand(flow.F_AA.subs(Omega, sp.sqrt(square)) / 2), R, R)
    if remainder != 0 or first.has(R):
        raise ArithmeticError(f"F_AA has no factor R where F_A = 0: {flow.F_AA}")
    second = flow.R.subs(Omega**2, square)
    # the level is stationary along the locus just where F_AA vanishes
    _vanishes(slope(second**2 + flow.I**2) + 2 * A * first * second, "the level's slope along the undamped folds")
    return Undamped(sp.sqrt(square), (first, slope(first), second, slope(second)))
