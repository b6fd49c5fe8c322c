"""Beside (24)-(34): what vanishes along the amplitude where the response curve or its fold locus changes.

In:  `SlowFlow` of one scene; the mechanism stays an open h(A).
Out: `Along`: functions of A, h and its derivatives, with their slopes along A; `Damped` for zeta > 0, `Undamped` for 0.

The eliminations, each proved on the way:

    fold at F_0  F = F_A = 0         A F_A/2 - F = F_0^2 - k R - m I: in the plane of R and I the fold lies on a circle
                                     and on a line, which meet once where I >= m; R, I and with them Omega follow from A
    isola point  F_A = F_Omega = 0   I from F_Omega leaves F_A = 2 R (h_A - Omega^2); so Omega^2 = h_A, in F_Omega/(4 A)
    cusp         F_A = F_AA = 0      F_AA/2 is a quadratic in X = Omega^2; its discriminant without what cancels
    state        at an Omega         R by its tangent as well: where Omega^2 + h_A is small that varies less along A
    turn         F_A = F_AOmega = 0  T = dR/dA from F_AOmega, and R = k + A T: F_A has k and what damping adds, not h
    peak         F = F_Omega = 0     R from F_Omega, which leaves F_A = -2 R (Omega^2 - h_A)
    rest         F = Omega = 0       h^2 = c^2, one smooth function for each sign of h
    zeta = 0                         F_A has the factor R and another, on which F_AA is a product too
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy.codegen.cfunctions import hypot

from ..claims import claim
from ..paper.slow_flow import I, R, SlowFlow, m, slope
from ..symbols import F_0, A, Omega, h, h_A, h_AA, h_AAA, zeta

Let = tuple[sp.Symbol, sp.Expr]

#: Omega^2, R and dR/dA where F_AA = 0, and the root of the discriminant that gives them, with its sign
X_ = sp.Symbol("X", nonnegative=True)
R_, T, root = sp.symbols("R T root", real=True)
#: h - A h_A, where the tangent of h meets A = 0, and its slope along A
k, k_A = sp.symbols("k k_A", real=True)
#: numbers without scale, which on a cell of amplitudes vary by little where h is nearly a power of A:
#: k/(A^2 h_AA), A h_AAA/h_AA, dR/dA over A h_AA, and the root of its discriminant
kappa, rho, t, scaled_root = sp.symbols("kappa rho t root", real=True)

#: h/A, and h/A - h_A
over_A, apart = sp.symbols("over_A apart", real=True)

_w, _bracket, _bracket_A = sp.symbols("w bracket bracket_A", real=True)
_product = sp.Symbol("product", nonnegative=True)
_c, _X, _p = sp.symbols("c X p", real=True)
#: R less the R of F = F_A = 0
lacks = sp.Symbol("lacks", real=True)
_half_e, _drawn = sp.symbols("half_e drawn", real=True)
_excess, _least, _share, _J, _lag = sp.symbols("excess least share J lag", nonnegative=True)


@dataclass(frozen=True)
class Damped:
    """For zeta > 0; outputs beside lets are in these.

    fold      -- at a forcing: (23) less the R of F = F_A = 0, its slope along A, and Omega
    fold_square -- Omega^2 of the R that `fold` has of F = F_A = 0, by Omega and what `fold` is
    fold_least -- F_A/(2 A) at zero friction as X^2 + b X + c in X = Omega^2: b, and the discriminant b^2 - 4 c; both by
                 h/A and, where these cancel, by h/A - h_A. Friction only adds to F_A
    fold_moves -- by how much F and F_A change with that, at the amplitude and the Omega of `fold`
    isola_Omega -- Omega where F_A = F_Omega = 0
    isola_turns -- what vanishes there with it: F_A over 2 R with I from F_Omega = 0
    isola_excess -- and F with R from F_Omega = 0
    isola_level -- the forcing by that: of R from h rounding leaves nothing where damping is weak
    isola     -- F_Omega/(4 A) there and its slope; for m = 0 without the factor Omega, which then is common
    cusps     -- F_AA/2 as T^2 + 2 a T + b and as X^2 + 2 c X + d: a, b, c, d, and the discriminant a^2 - b of both
    cusp_R    -- R where F_AA = 0, by its tangent and from F_AA = 0 itself, where nothing cancels if h_AA has its sign
    cusp      -- where F_AA = 0: F_A/2, the same less A F_AA/2, its slope along A, and the forcing if it is 0
    cusp_balance -- Omega^2 and the forcing's square with R from F_A = 0
    cusps_scaled -- F_AA/2 over (A h_AA)^2 as t^2 + 2 a t + b: a, b, and the discriminant a^2 - b
    cusp_X    -- Omega^2 by t
    cusp_scaled -- as `cusp` in numbers without scale: F_A/2 less A F_AA/2, its slope along A, the forcing if it is 0
    turn      -- F_A/2 where F_AOmega = 0, an extremum of F_A over Omega, and its slope along A
    peak      -- F where F_Omega = 0, an extremum of F over Omega, and its slope along A
    peak_Omega_A -- dOmega/dA along F_Omega = 0
    """

    fold_lets: tuple[Let, ...]
    fold: tuple[sp.Expr, ...]
    fold_moves: tuple[sp.Expr, ...]
    fold_square: sp.Expr
    fold_least: tuple[sp.Expr, ...]
    isola_Omega: sp.Expr
    isola_turns: sp.Expr
    isola_excess: sp.Expr
    isola_level_lets: tuple[Let, ...]
    isola_level: sp.Expr
    isola_lets: tuple[Let, ...]
    isola: tuple[sp.Expr, ...]
    cusps_lets: tuple[Let, ...]
    cusps: tuple[sp.Expr, ...]
    cusp_R: tuple[sp.Expr, ...]
    cusp_lets: tuple[Let, ...]
    cusp: tuple[sp.Expr, ...]
    cusp_balance_lets: tuple[Let, ...]
    cusp_balance: tuple[sp.Expr, ...]
    cusps_scaled_lets: tuple[Let, ...]
    cusps_scaled: tuple[sp.Expr, ...]
    cusp_X: sp.Expr
    cusp_scaled_lets: tuple[Let, ...]
    cusp_scaled: tuple[sp.Expr, ...]
    turn_lets: tuple[Let, ...]
    turn: tuple[sp.Expr, ...]
    peak_lets: tuple[Let, ...]
    peak: tuple[sp.Expr, ...]
    peak_Omega_A: sp.Expr


@dataclass(frozen=True)
class Undamped:
    """For zeta = 0.

    Omega   -- where F_A = 0 off the backbone R = 0
    fold    -- at a forcing: R^2 + I^2 - F_0^2 there, and its slope along A
    level   -- the forcing of a fold
    rises   -- has the sign of the level's slope along A; and, where that vanishes, of the slope's own
    factors -- the two of F_AA/2 there, h_AA and R, each with its slope
    """

    Omega: sp.Expr
    fold_lets: tuple[Let, ...]
    fold: tuple[sp.Expr, ...]
    level: sp.Expr
    rises: tuple[sp.Expr, ...]
    factors: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Along:
    """Of one scene.

    level -- (24): the forcing for which (Omega, A) is a steady state, in R and I
    rest  -- F at Omega = 0 by its two halves h - c and h + c, and the slope of both
    least -- the size of h at Omega = 0, and the least size of k at a fold
    intercept -- k = h - A h_A, where R meets A = 0 along its tangent, and its slope
    F_Omega_reduced -- F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega
    state_R -- R by its definition, and by its tangent's intercept
    state -- F with two derivatives along A, in R
    damped, undamped -- of its own: one of them
    """

    level: sp.Expr
    rest_lets: tuple[Let, ...]
    rest: tuple[sp.Expr, ...]
    least: sp.Expr
    intercept: tuple[sp.Expr, ...]
    F_Omega_reduced_lets: tuple[Let, ...]
    F_Omega_reduced: tuple[sp.Expr, ...]
    state_R: tuple[sp.Expr, ...]
    state_lets: tuple[Let, ...]
    state: tuple[sp.Expr, ...]
    damped: Damped | None
    undamped: Undamped | None


def along(flow: SlowFlow) -> Along:
    """All of it, in the scene of the flow."""
    level = sp.sqrt(sp.expand(flow.F + F_0**2))
    claim("(24) at the forcing of a steady state", flow.F.subs(F_0, level))
    at_rest = flow.F.subs({R: flow.R, I: flow.I}).subs(Omega, 0)
    product = sp.factor(h**2 - at_rest)
    halves = (h - _c, h + _c)
    claim("the halves of F at Omega = 0", sp.Mul(*halves).expand().subs(_c**2, product) - at_rest)
    # factor by factor: the product may be too large for a double
    friction = flow.I.subs(Omega, 0)
    least = sp.sqrt(F_0 - friction) * sp.sqrt(F_0 + friction)
    claim("h^2 at Omega = 0", least**2 - product)
    slopes = {slope(half) for half in halves}
    if len(slopes) != 1:
        raise ArithmeticError(f"the halves of F at Omega = 0 have different slopes: {slopes}")
    reduced_lets, reduced = _F_Omega_reduced(flow)
    has_zeta = zeta in flow.I.free_symbols
    return Along(
        level=level,
        rest_lets=((_product, product), (_c, sp.sqrt(_product))),
        rest=(*halves, slopes.pop()),
        least=least,
        intercept=tuple(map(sp.expand, (of_tangent := _intercept(flow.R), slope(of_tangent)))),
        F_Omega_reduced_lets=reduced_lets,
        F_Omega_reduced=reduced,
        state_R=_state_R(flow),
        state_lets=((I, flow.I),),
        state=(flow.F, flow.F_A, flow.F_AA),
        damped=_damped(flow) if has_zeta else None,
        undamped=None if has_zeta else _undamped(flow),
    )


def _F_Omega_reduced(flow: SlowFlow) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...]]:
    """Omega (A Omega^2 + p) + q, or the bracket where q vanishes."""
    q_value, p_value, _, leading = flow.peak_cubic
    bracket = leading * Omega**2 + _p
    value = bracket if q_value == 0 else Omega * bracket + q_value
    whole = value.subs(_p, p_value) * (Omega if q_value == 0 else 1)
    claim("F_Omega/(4 A)", whole - flow.F_Omega.subs({R: flow.R, I: flow.I}) / (4 * A))
    return ((_p, p_value),), (value, sp.expand(sp.diff(value, Omega)))


def _state_R(flow: SlowFlow) -> tuple[sp.Expr, ...]:
    """R, and the same by the intercept of its tangent, which is k at any Omega."""
    by_tangent = k + A * slope(flow.R)
    claim("R by its tangent", by_tangent.subs(k, _intercept(flow.R)) - flow.R)
    return flow.R, by_tangent


def _damped(flow: SlowFlow) -> Damped:
    fold_lets, fold, fold_moves = _fold(flow)
    isola_turns, isola_Omega = _isola_Omega(flow)
    isola_excess, isola_level = _isola_level(flow)
    isola_lets, isola = _isola(flow, isola_Omega)
    cusps_lets, cusps, cusp_R, cusp_lets, cusp = _cusps(flow)
    cusp_balance_lets, cusp_balance = _cusp_balance(flow, cusp_lets, cusp)
    cusps_scaled_lets, cusps_scaled, cusp_X, cusp_scaled_lets, cusp_scaled = _scaled(flow, cusps_lets, cusps, cusp)
    turn_lets, turn = _turn(flow)
    peak_lets, peak = _peak(flow)
    return Damped(
        fold_lets=fold_lets,
        fold=fold,
        fold_square=_fold_square(flow),
        fold_least=_fold_least(flow),
        fold_moves=fold_moves,
        isola_Omega=isola_Omega,
        isola_turns=isola_turns,
        isola_excess=isola_excess,
        isola_level_lets=((I, flow.I),),
        isola_level=isola_level,
        isola_lets=isola_lets,
        isola=isola,
        cusps_lets=cusps_lets,
        cusps=cusps,
        cusp_R=cusp_R,
        cusp_lets=cusp_lets,
        cusp=cusp,
        cusp_balance_lets=cusp_balance_lets,
        cusp_balance=cusp_balance,
        cusps_scaled_lets=cusps_scaled_lets,
        cusps_scaled=cusps_scaled,
        cusp_X=cusp_X,
        cusp_scaled_lets=cusp_scaled_lets,
        cusp_scaled=cusp_scaled,
        turn_lets=turn_lets,
        turn=turn,
        peak_lets=peak_lets,
        peak=peak,
        peak_Omega_A=_peak_Omega_A(flow, peak_lets),
    )


def _intercept(value: sp.Expr) -> sp.Expr:
    """Where the tangent along A of a function of A and Omega meets A = 0."""
    return sp.expand(value - A * slope(value))


def _fold_square(flow: SlowFlow) -> sp.Expr:
    """R is linear in Omega^2."""
    square = sp.Symbol("square", positive=True)
    lacking = flow.R.subs(Omega, sp.sqrt(square)) - (flow.R - lacks)
    return sp.expand(sp.solve(lacking, square)[0])


def _fold_least(flow: SlowFlow) -> tuple[sp.Expr, ...]:
    """Of the fold quartic over its leading coefficient, without the odd term, which is not negative."""
    constant, odd, square, cubic, leading = flow.fold_quartic
    if cubic != 0 or not sp.cancel(odd / (m * zeta)).is_nonnegative:
        raise ArithmeticError(f"friction may lower F_A: {odd}")
    b, c = (sp.expand(sp.expand(value / leading).subs(h, A * over_A)) for value in (square, constant))
    discriminant = sp.factor(sp.expand(b**2 - 4 * c - (over_A - h_A) ** 2)) + apart**2
    whole = discriminant.subs(apart, over_A - h_A) - (b**2 - 4 * c)
    claim("the discriminant of the least F_A", whole)
    return b, discriminant


def _fold(flow: SlowFlow) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
    """The circle R^2 + I^2 = F_0^2 and the line k R + m I = F_0^2.

    They meet where |k| >= e = sqrt(F_0^2 - m^2), once with I >= m. With share = sqrt(1 - (e/k)^2) that is where
    I = m + share J and R = F_0 J/k, and J falls from e^2/F_0 at the least |k| to F_0 - m.
    """
    friction = _intercept(flow.I)
    line = k * R + friction * I - F_0**2
    of_flow = {R: flow.R, I: flow.I}
    off_line = A * flow.F_A / 2 - flow.F + line
    claim("A F_A/2 - F against the line", off_line.subs(k, _intercept(flow.R)).subs(of_flow))
    excess = (F_0 - friction) * (F_0 + friction)
    J = _excess / (F_0 + friction * _share)
    at_fold = {R: F_0 * J / k, I: friction + _share * J}
    claim("the line at a fold", line.subs(at_fold).subs(_excess, excess))
    # 1 - share^2 is excess/k^2
    on_circle = flow.F.subs(at_fold).subs(k, sp.sqrt(_excess / (1 - _share**2)))
    claim("the circle at a fold", on_circle.subs(_excess, excess))
    # I - m in the form that holds the share once
    lag = _excess / (F_0 / _share + friction)
    claim("I - m at a fold", lag - _share * J)
    w = sp.solve(flow.I - friction - _lag, Omega)[0]
    at_w = sp.expand(flow.R.subs(Omega, w))
    value = at_w - F_0 * _J / k
    spring = sp.cancel(sp.diff(at_w, _lag) / _lag)
    by_k = F_0 * _J**2 / k**2 * (spring * _J / k + (F_0 + friction / _share) / _excess)
    along = sp.diff(at_w, A) + h_A + by_k * k_A
    # the slopes of share and J, and 1/k^2 by the share
    share_A = _excess * k_A / (k**3 * _share)
    whole = value.subs({_lag: lag, _J: J})
    error = slope(whole, {k: k_A, _share: share_A}) - along.subs({_lag: lag, _J: J})
    claim("the slope along A at a fold", error.subs(_excess, k**2 * (1 - _share**2)))
    lets = (
        (_excess, excess),
        (_least, sp.sqrt(_excess)),
        (_share, sp.sqrt((1 - _least / k) * (1 + _least / k))),
        (_J, J),
        (_lag, lag),
    )
    # beside the fold, at its Omega and I, what is zero there is what R exceeds its own by: A F_A/2 is F less the line
    moves = sp.diff(flow.F, R), sp.factor(2 * (sp.diff(flow.F, R) - sp.diff(line, R)) / A)
    return lets, (value, along, w), moves


def _isola_Omega(flow: SlowFlow) -> tuple[sp.Expr, sp.Expr]:
    """With I from F_Omega = 0, F_A has the factors R and h_A - Omega^2; R = 0 would need I = 0: there is damping."""
    eliminated = sp.expand(flow.F_A.subs(I, sp.solve(flow.F_Omega, I)[0]))
    factor, remainder = sp.div(eliminated, 2 * R, R)
    if remainder != 0 or factor.has(R):
        raise ArithmeticError(f"F_A without I is not R times a function of Omega and h_A: {eliminated}")
    return factor, sp.sqrt(sp.solve(factor.subs(Omega, sp.sqrt(_X)), _X)[0])


def _isola_level(flow: SlowFlow) -> tuple[sp.Expr, sp.Expr]:
    """F with R from F_Omega = 0, and the F_0 for which it vanishes."""
    R_value = sp.solve(flow.F_Omega, R)[0]
    excess = flow.F.subs(R, R_value)
    claim("F at the forcing of an isola point", excess.subs(F_0, sp.sqrt(I**2 + R_value**2)))
    return excess, hypot(I, R_value)


def _isola(flow: SlowFlow, w: sp.Expr) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...]]:
    """F_Omega/(4 A) = Omega (A Omega^2 + p) + q at Omega = w."""
    q_value, p_value, _, leading = flow.peak_cubic
    bracket = sp.collect(sp.expand(leading * w**2 + p_value), A)
    lets = ((_bracket, bracket), (_bracket_A, slope(bracket)))
    value = _w * _bracket + q_value
    claim(
        "F_Omega/(4 A) at an isola point",
        value.subs(_bracket, bracket).subs(_w, w) - flow.F_Omega.subs({R: flow.R, I: flow.I}).subs(Omega, w) / (4 * A),
    )
    if q_value == 0:
        return lets, (_bracket, _bracket_A)
    return ((_w, w), *lets), (value, slope(value, {_bracket: _bracket_A, _w: slope(w).subs(w, _w)}))


def _square_of(flow: SlowFlow) -> sp.Expr:
    """Omega^2 by T."""
    return sp.solve(slope(flow.R).subs(Omega, sp.sqrt(X_)) - T, X_)[0]


def _cusps(
    flow: SlowFlow,
) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...], tuple[sp.Expr, ...], tuple[Let, ...], tuple[sp.Expr, ...]]:
    """F_AA/2 is a quadratic in X = Omega^2, and one in T = dR/dA, which is X + h_A; R is k + A T.

    Both have the same discriminant. In T the square of h_A, which cancels there, never enters it. Where F_AA vanishes
    F_A/2 may be taken less A F_AA/2, and its slope is -F_AOmega F_AAA/(2 F_AAOmega).
    """
    X = _square_of(flow)
    of_T = {R: R_, h_A: T - _w**2, Omega: _w, I: flow.I.subs(Omega, _w)}
    of_flow = {R_: flow.R, k: _intercept(flow.R), T: slope(flow.R), X_: Omega**2, _w: Omega}
    half_F_AA, half_F_A, half_F_AAA = (sp.expand((f / 2).subs(of_T)) for f in (flow.F_AA, flow.F_A, flow.F_AAA))
    by_Omega = sp.expand(flow.F_AOmega.subs(of_T) / (4 * _w))
    claim("R by k and T", (R_ - k - A * T).subs(of_flow))

    in_T, in_X = (
        sp.Poly(sp.expand(half_F_AA.subs(R_, R_value).subs(_w, sp.sqrt(square)).subs(T, unknown)), variable)
        for R_value, square, unknown, variable in ((k + A * T, X, T, T), (h + A * X_, X_, X_ + h_A, X_))
    )
    for quadratic in (in_T, in_X):
        if quadratic.degree() != 2 or quadratic.LC() != 1:
            raise ArithmeticError(f"F_AA/2 is not a monic quadratic: {quadratic}")
    half_e, half_c_1 = (quadratic.coeff_monomial(quadratic.gen) / 2 for quadratic in (in_T, in_X))
    discriminant = _half_e**2 - in_T.coeff_monomial(1)
    other = half_c_1**2 - in_X.coeff_monomial(1)
    claim("the discriminant of F_AA/2", discriminant.subs(_half_e, half_e).subs(k, _intercept(flow.R)) - other)
    quadratics = (_half_e, in_T.coeff_monomial(1), h_A + _half_e, in_X.coeff_monomial(1), discriminant)
    claim("the linear coefficients of F_AA/2", half_c_1 - h_A - half_e)

    # F_AAOmega is 8 Omega times the root of the discriminant, with its sign
    F_AAOmega = 8 * Omega * (slope(flow.R) + half_e)
    claim("F_AAOmega where F_AA = 0", (flow.F_AAOmega - F_AAOmega).subs({R: flow.R, I: flow.I}))
    less = sp.collect(sp.expand((half_F_A - A * half_F_AA).subs(R_, k + A * T)), T)
    along = -by_Omega * half_F_AAA / (2 * root)
    expected = -flow.F_AOmega * flow.F_AAA / (2 * F_AAOmega)
    level = sp.sqrt(k * R_ + sp.expand(_intercept(flow.I) * flow.I.subs(Omega, _w)))
    for one, whole, words in (
        (half_F_A, flow.F_A / 2, "F_A"),
        (less, (flow.F_A - A * flow.F_AA) / 2, "F_A less A F_AA"),
        (along.subs(root, T + half_e), expected, "the slope of F_A"),
        (level**2, flow.F + F_0**2 - A * flow.F_A / 2, "the forcing at a cusp"),
    ):
        claim(words, (one.subs(of_flow) - whole).subs({R: flow.R, I: flow.I}))
    of_R = sp.solve(half_F_AA, R_)[0].subs(_w**2, X_)
    return (
        ((_half_e, half_e),),
        quadratics,
        (k + A * T, of_R),
        ((_w, sp.sqrt(X_)),),
        (half_F_A.subs(_w**2, X_), less, along, level),
    )


def _cusp_balance(
    flow: SlowFlow, cusp_lets: tuple[Let, ...], cusp: tuple[sp.Expr, ...]
) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...]]:
    """Omega^2 and the forcing's square at a fold with R from F_A = 0: no h_AA, which may be steep along A."""
    half_F_A, _, _, level = cusp
    (balanced,) = sp.solve(half_F_A.subs(X_, _w**2), R_)
    (square,) = sp.solve((flow.R - R_).subs(Omega, sp.sqrt(_X)), _X)
    of_flow = {T: slope(flow.R), _w: Omega}
    claim("R where F_A = 0", ((R - balanced) * T).subs(of_flow) - flow.F_A.subs(I, flow.I) / 2)
    return (*cusp_lets, (R_, balanced)), (square, level**2)


def _scaled(
    flow: SlowFlow, cusps_lets: tuple[Let, ...], cusps: tuple[sp.Expr, ...], cusp: tuple[sp.Expr, ...]
) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...], sp.Expr, tuple[Let, ...], tuple[sp.Expr, ...]]:
    """The same as at cusps by kappa, rho and t, for h_AA other than 0.

    kappa stays between its value at one amplitude and -1/(2 + rho) as A rises from there, as A dkappa/dA = -1 -
    kappa (2 + rho).
    """
    unit, sum_ = A * h_AA, sp.Symbol("sum", real=True)
    along_A = slope(k / (A**2 * h_AA), {k: -A * h_AA}).subs({k: kappa * A**2 * h_AA, h_AAA: rho * h_AA / A})
    claim("the slope of kappa", A * along_A + 1 + kappa * (2 + rho))
    by_scale = {k: kappa * A * unit, T: t * unit, R_: sum_ * A * unit, h_AAA: rho * h_AA / A, root: scaled_root * unit}
    half, constant, discriminant = (
        sp.expand(value.subs(cusps_lets).subs(by_scale) / unit**power)
        for value, power in ((cusps[0], 1), (cusps[1], 2), (cusps[4], 2))
    )
    claim("the discriminant without scale", half**2 - constant - discriminant)
    _, less, along, level = (value.subs(by_scale) for value in cusp)
    # on a cell that is wide in A, t and kappa vary by little: what they stand in is put beside the rest over A h_AA
    rest = sp.expand(less.coeff(_w)) * _w
    scaled_half_F_A = A * unit**2 * (sp.expand((less - rest) / (A * unit**2)) + rest / (A * unit**2))
    claim("F_A without scale", scaled_half_F_A - less)
    factors = sp.Mul.make_args(sp.factor(along))
    bracket = next((factor for factor in factors if factor.is_Add and factor.has(_w)), sp.Integer(1))
    # w once only
    of_bracket = sp.expand(bracket / _w)
    leading = sp.expand(of_bracket.coeff(h_AA) / A**2)
    rest = sp.expand((of_bracket - A * unit * leading) / A)
    scaled_bracket = leading + rest / unit
    scaled_along = A * unit * scaled_bracket * sp.Mul(*(factor for factor in factors if factor != bracket)) * _w
    claim("the slope of F_A without scale", scaled_along - along)
    return (
        ((_half_e, half),),
        (_half_e, constant, _half_e**2 - constant),
        _square_of(flow).subs(by_scale),
        ((_w, sp.sqrt(X_)), (sum_, kappa + t)),
        (scaled_half_F_A, scaled_along, level),
    )


def _turn(flow: SlowFlow) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...]]:
    """R = k/2 - drawn and A T = -k/2 - drawn: of the two factors h + A Omega^2 and h_A + Omega^2, which nearly cancel
    where damping is weak, only their difference k is left.
    """
    of_T = {R: k + A * T, h_A: T - Omega**2, I: flow.I}
    (balanced,) = sp.solve(flow.F_AOmega.subs(of_T), T)
    drawn = sp.factor(sp.expand(-A * balanced - k / 2))
    if drawn.has(k):
        raise ArithmeticError(f"what damping adds where F_AOmega = 0 depends on the spring: {drawn}")
    of_R, of_slope = k / 2 - _drawn, -(k / 2 + _drawn) / A
    damped = sp.factor((flow.F_A / 2).subs(R, 0))
    value = of_R * of_slope + damped
    along = of_slope**2 + h_AA * of_R + sp.expand((flow.F_AA / 2).subs(R, 0) - slope(flow.R) ** 2)
    for one, whole in ((value, flow.F_A), (along, flow.F_AA)):
        left = one.subs(_drawn, drawn) - (whole / 2).subs(of_T).subs(T, balanced)
        claim("F_A and its slope where F_AOmega = 0", left.subs(I, flow.I))
    return ((I, flow.I), (_drawn, drawn)), (value, along)


def _peak(flow: SlowFlow) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...]]:
    """F, and F_A, which is -2 R (Omega^2 - h_A), with R from F_Omega = 0: R is negative."""
    balanced = sp.expand(sp.solve(flow.F_Omega, R)[0].subs(I, flow.I))
    along = -2 * R * (Omega**2 - h_A)
    claim("F_A at an extremum of F over Omega", (flow.F_A - along).subs(R, balanced).subs(I, flow.I))
    return ((R, balanced), (I, flow.I)), (flow.F, along)


def _peak_Omega_A(flow: SlowFlow, lets: tuple[Let, ...]) -> sp.Expr:
    """-F_AOmega/F_OmegaOmega, in which m zeta cancels once R is the one of F_Omega = 0."""
    numerator, denominator = sp.fraction(sp.cancel((-flow.F_AOmega / flow.F_OmegaOmega).subs(lets[:1]).subs(lets[1:])))
    return sp.factor(numerator) / denominator


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
    level = sp.sqrt(k**2 + flow.I**2)
    claim("the undamped folds' level", level.subs(k, second) ** 2 - flow.F.subs({R: second, I: flow.I}) - F_0**2)
    rises = -first * k
    along_A = slope(level**2, {k: -A * h_AA})
    claim("the level's slope along the undamped folds", along_A - 2 * A * rises)
    bends = slope(along_A, {k: -A * h_AA}).subs(h_AA, 0) / (2 * A)
    value = (k - _least) * (k + _least)
    lets = ((_excess, (F_0 - flow.I) * (F_0 + flow.I)), (_least, sp.sqrt(_excess)))
    at_fold = flow.F.subs({R: second, I: flow.I})
    claim("F on the undamped folds", value.subs(reversed(lets)).subs(k, second) - at_fold)
    fold = (value, slope(value, {k: k_A}))
    return Undamped(sp.sqrt(square), lets, fold, level, (rises, bends), (first, slope(first), second, slope(second)))
