"""Beside (24)-(34): what vanishes along the amplitude where the response curve or its fold locus changes.

In:  the slow flow of one scene; the mechanism stays an open h(A).
Out: `Formulas`: functions of A, h and its derivatives, with their slopes along A; for zeta = 0 other ones.

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
    bound                            R^2 + I^2 = F_0^2: I <= F_0 bounds A Omega, and then |h| <= |R| + A Omega^2
"""

from __future__ import annotations

import sympy as sp
from sympy.codegen.cfunctions import hypot

from ..claims import claim
from ..kernels import Formulas, Lets
from ..paper.slow_flow import I, R, m, slope
from ..symbols import F_0, A, Omega, h, h_A, h_AA, h_AAA, zeta

#: Omega^2 and dR/dA where F_AA = 0, and the root of the discriminant that gives them, with its sign
X_ = sp.Symbol("X", nonnegative=True)
T, root = sp.symbols("T root", real=True)
#: h - A h_A, where the tangent of h meets A = 0, and its slope along A
k, k_A = sp.symbols("k k_A", real=True)
#: numbers without scale, which on a cell of amplitudes vary by little where h is nearly a power of A:
#: k/(A^2 h_AA), A h_AAA/h_AA, dR/dA over A h_AA
kappa, rho, t = sp.symbols("kappa rho t", real=True)

#: h/A, and h/A - h_A
over_A, apart = sp.symbols("over_A apart", real=True)

_w, _bracket, _bracket_A = sp.symbols("w bracket bracket_A", real=True)
_product = sp.Symbol("product", nonnegative=True)
_c, _X, _p = sp.symbols("c X p", real=True)
#: R less the R of F = F_A = 0
lacks = sp.Symbol("lacks", real=True)
_half_e, _drawn = sp.symbols("half_e drawn", real=True)
_excess, _least, _ratio, _J, _lag = sp.symbols("excess least share J lag", nonnegative=True)
#: the largest A Omega, and the highest Omega by it
_most, _fastest = sp.symbols("c fastest", nonnegative=True)

#: of arguments
ORDER = (
    *(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA),
    *(k, k_A, X_, T, R, root, over_A, apart, lacks),
)


def along(flow: Formulas) -> Formulas:
    """All of it, in the scene of the flow."""
    of = Formulas(ORDER, {R: flow.R, I: flow.I})

    @of.kernel("(24)", "Omega >= 0, A > 0")
    def level() -> sp.Expr:
        """The forcing F_0 for which (Omega, A) is a steady state."""
        value = sp.sqrt(sp.expand(flow.F + F_0**2))
        claim("`F = 0` at `F_0 = sqrt(R^2 + I^2)`", flow.F.subs(F_0, value))
        return value

    at_rest = flow.F.subs(of.lets).subs(Omega, 0)
    product = sp.factor(h**2 - at_rest)

    @of.kernel("from (24)", "F_0 >= m")
    def rest() -> Lets:
        """F at Omega = 0 as a product: h - c, h + c, and the slope of both along A."""
        halves = (h - _c, h + _c)
        claim(
            "`F = (h - c) (h + c)` at `Omega = 0`, `c^2 = F_0^2 - m^2`",
            sp.Mul(*halves).expand().subs(_c**2, product) - at_rest,
        )
        slopes = {slope(half) for half in halves}
        claim("both factors have the same derivative by `A`", len(slopes) == 1)
        return Lets([(_product, product), (_c, sp.sqrt(_product))], (*halves, slopes.pop()))

    @of.kernel("from (24), (30)", "F_0 >= m")
    def least_restoring() -> sp.Expr:
        """The |h| of a state at Omega = 0, and the least |h - A h_A| of a fold.

        Factor by factor: the product may be too large for a double.
        """
        friction = flow.I.subs(Omega, 0)
        value = sp.sqrt(F_0 - friction) * sp.sqrt(F_0 + friction)
        claim("`F = 0` at `Omega = 0` where `h^2 = (F_0 - m) (F_0 + m)`", value**2 - product)
        return value

    @of.kernel("from (24), (30)", "A >= 0")
    def intercept() -> tuple[sp.Expr, ...]:
        """k = h - A h_A, where the tangent of h meets A = 0, and its slope along A."""
        of_tangent = _intercept(flow.R)
        return of_tangent, sp.expand(slope(of_tangent))

    @of.kernel("(34)")
    def F_Omega_reduced() -> Lets:
        """F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega.

        Omega (A Omega^2 + p) + q, or the bracket where q vanishes.
        """
        q_value, p_value, leading = flow.peak_cubic
        bracket = leading * Omega**2 + _p
        value = bracket if q_value == 0 else Omega * bracket + q_value
        whole = value.subs(_p, p_value) * (Omega if q_value == 0 else 1)
        claim("`F_Omega/(4 A)` is a depressed cubic in `Omega`", whole - flow.F_Omega.subs(of.lets) / (4 * A))
        return Lets([(_p, p_value)], (value, sp.expand(sp.diff(value, Omega))))

    @of.kernel("(24)")
    def state_R() -> tuple[sp.Expr, ...]:
        """R by its definition, and by its tangent along A, which meets A = 0 at k = h - A h_A.

        That is k at any Omega.
        """
        by_tangent = k + A * slope(flow.R)
        claim("`R = h - A h_A + A dR/dA`", by_tangent.subs(k, _intercept(flow.R)) - flow.R)
        return flow.R, by_tangent

    # of R both forms are taken first, and what both hold
    state = Lets([(I, flow.I)], (flow.F, flow.F_A, flow.F_AA))
    of.add("state", state, "F and its first two derivatives along A, by R (`state_R`).", "(24), (30), (33)")
    if zeta in flow.I.free_symbols:
        _bound(of, flow)
        _fold(of, flow)
        _isola(of, flow)
        _cusps(of, flow)
        _turn(of, flow)
        _peak(of, flow)
    else:
        _undamped(of, flow)
    return of


def _intercept(value: sp.Expr) -> sp.Expr:
    """Where the tangent along A of a function of A and Omega meets A = 0."""
    return sp.expand(value - A * slope(value))


def _bound(of: Formulas, flow: Formulas) -> None:
    """A Omega <= c, |h| <= F_0 + c^2/A."""

    @of.kernel("from (23)", "A > 0, F_0 >= m, zeta > 0")
    def most_restoring() -> Lets:
        """The largest |h| of a state with this amplitude: F_0 + (A Omega)^2/A at the highest Omega.

        That is c/A; c^2 may be too large for a double.
        """
        (highest,) = sp.solve(flow.I - F_0, Omega)
        c = sp.factor(A * highest)
        claim("the bound of `A Omega` does not depend on `A`", not c.has(A))
        claim("`R - h = A Omega^2`", flow.R - h, A * Omega**2)
        return Lets([(_most, c), (_fastest, _most / A)], F_0 + _most * _fastest)


def _fold(of: Formulas, flow: Formulas) -> None:
    """The circle R^2 + I^2 = F_0^2 and the line k R + m I = F_0^2.

    They meet where |k| >= e = sqrt(F_0^2 - m^2), once with I >= m. With share = sqrt(1 - (e/k)^2) that is where
    I = m + share J and R = F_0 J/k, and J falls from e^2/F_0 at the least |k| to F_0 - m.
    """
    friction = _intercept(flow.I)
    line = k * R + friction * I - F_0**2
    off_line = A * flow.F_A / 2 - flow.F + line
    claim("`A F_A/2 - F = F_0^2 - (k R + m I)`, `k = h - A h_A`", off_line.subs(k, _intercept(flow.R)).subs(of.lets))
    excess = (F_0 - friction) * (F_0 + friction)
    J = _excess / (F_0 + friction * _ratio)
    at_fold = {R: F_0 * J / k, I: friction + _ratio * J}
    claim("a fold lies on the line `k R + m I = F_0^2`", line.subs(at_fold).subs(_excess, excess))
    # 1 - share^2 is excess/k^2
    on_circle = flow.F.subs(at_fold).subs(k, sp.sqrt(_excess / (1 - _ratio**2)))
    claim("a fold lies on the circle `R^2 + I^2 = F_0^2`", on_circle.subs(_excess, excess))
    # I - m in the form that holds the share once
    lag = _excess / (F_0 / _ratio + friction)
    claim("`I - m` at a fold in a form without cancellation", lag - _ratio * J)
    w = sp.solve(flow.I - friction - _lag, Omega)[0]
    at_w = sp.expand(flow.R.subs(Omega, w))
    value = at_w - F_0 * _J / k
    spring = sp.cancel(sp.diff(at_w, _lag) / _lag)
    by_k = F_0 * _J**2 / k**2 * (spring * _J / k + (F_0 + friction / _ratio) / _excess)
    derivative = sp.diff(at_w, A) + h_A + by_k * k_A
    # the slopes of share and J, and 1/k^2 by the share
    share_A = _excess * k_A / (k**3 * _ratio)
    whole = value.subs({_lag: lag, _J: J})
    error = slope(whole, {k: k_A, _ratio: share_A}) - derivative.subs({_lag: lag, _J: J})
    claim("derivative of the fold condition by `A`", error.subs(_excess, k**2 * (1 - _ratio**2)))
    lets = (
        (_excess, excess),
        (_least, sp.sqrt(_excess)),
        (_ratio, sp.sqrt((1 - _least / k) * (1 + _least / k))),
        (_J, J),
        (_lag, lag),
    )
    of.add(
        "fold",
        Lets(lets, (value, derivative, w)),
        "Zero at a fold at F_0: R of (23) less the R of F = F_A = 0; its slope along A, and Omega.",
        "from (24), (30)",
        "A > 0, F_0 > m, k^2 >= F_0^2 - m^2",
    )

    @of.kernel("from (23)", "A > 0")
    def fold_square() -> sp.Expr:
        """Omega^2 beside a fold by the R of F = F_A = 0, from the Omega by I and what R lacks of agreeing (`fold`).

        R is linear in Omega^2.
        """
        square = sp.Symbol("square", positive=True)
        lacking = flow.R.subs(Omega, sp.sqrt(square)) - (flow.R - lacks)
        return sp.expand(sp.solve(lacking, square)[0])

    @of.kernel("from (24), (30)", "A > 0")
    def fold_moves() -> Lets:
        """What F and F_A change by beside a fold, per what vanishes there (`fold`), at its A, Omega and I.

        What is zero there is what R exceeds its own by: A F_A/2 is F less the line.
        """
        by_R = sp.diff(flow.F, R)
        return Lets((), (by_R, sp.factor(2 * (by_R - sp.diff(line, R)) / A)))

    @of.kernel("from (30)", "A > 0")
    def fold_least() -> tuple[sp.Expr, ...]:
        """F_A/(2 A) without friction as X^2 + b X + c in X = Omega^2, by h/A and h/A - h_A: b, and b^2 - 4 c.

        Of the fold quartic over its leading coefficient, without the odd term: friction only adds to F_A.
        """
        constant, odd, square, leading = flow.fold_quartic
        claim("friction does not decrease `F_A`", bool(sp.cancel(odd / (m * zeta)).is_nonnegative))
        b, c = (sp.expand(sp.expand(value / leading).subs(h, A * over_A)) for value in (square, constant))
        discriminant = sp.factor(sp.expand(b**2 - 4 * c - (over_A - h_A) ** 2)) + apart**2
        claim(
            "discriminant of `F_A` without friction, a quadratic in `Omega^2`",
            discriminant.subs(apart, over_A - h_A) - (b**2 - 4 * c),
        )
        return b, discriminant


def _isola(of: Formulas, flow: Formulas) -> None:
    """With I from F_Omega = 0, F_A has the factors R and h_A - Omega^2; R = 0 would need I = 0: there is damping."""
    eliminated = sp.expand(flow.F_A.subs(I, sp.solve(flow.F_Omega, I)[0]))
    # what vanishes at an isola point, F_A over 2 R; and F with R from F_Omega = 0
    of.isola_turns, remainder = sp.div(eliminated, 2 * R, R)
    claim(
        "at `F_Omega = 0`, `F_A` is `R` times a function of `Omega` and `h_A`",
        remainder == 0 and not of.isola_turns.has(R),
    )
    w = sp.sqrt(sp.solve(of.isola_turns.subs(Omega, sp.sqrt(_X)), _X)[0])
    of.add("isola_Omega", w, "Omega at an isola point.", "from (30), (34)", "h_A >= 0")
    R_value = sp.solve(flow.F_Omega, R)[0]
    of.isola_excess = flow.F.subs(R, R_value)
    claim("`F = 0` at the forcing of an isola point", of.isola_excess.subs(F_0, sp.sqrt(I**2 + R_value**2)))
    text = "The forcing at an isola point: of R from h rounding leaves nothing where damping is weak."
    of.add("isola_level", Lets([(I, flow.I)], hypot(I, R_value)), text, "from (24), (30)", "Omega > 0")

    @of.kernel("from (30), (34)", "A > 0, h_A > 0; for m = 0 any h_A")
    def isola() -> Lets:
        """Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A.

        F_Omega/(4 A) = Omega (A Omega^2 + p) + q at Omega = w.
        """
        q_value, p_value, leading = flow.peak_cubic
        bracket = sp.collect(sp.expand(leading * w**2 + p_value), A)
        lets = ((_bracket, bracket), (_bracket_A, slope(bracket)))
        value = _w * _bracket + q_value
        at_w = flow.F_Omega.subs(of.lets).subs(Omega, w) / (4 * A)
        claim("`F_Omega/(4 A)` at the frequency of an isola point", value.subs(_bracket, bracket).subs(_w, w) - at_w)
        if q_value == 0:
            return Lets(lets, (_bracket, _bracket_A))
        derivative = slope(value, {_bracket: _bracket_A, _w: slope(w).subs(w, _w)})
        return Lets([(_w, w), *lets], (value, derivative))


def _cusps(of: Formulas, flow: Formulas) -> None:
    """F_AA/2 is a quadratic in X = Omega^2, and one in T = dR/dA, which is X + h_A; R is k + A T.

    Both have the same discriminant. In T the square of h_A, which cancels there, never enters it. Where F_AA vanishes
    F_A/2 may be taken less A F_AA/2, and its slope is -F_AOmega F_AAA/(2 F_AAOmega).
    """
    (X,) = sp.solve(slope(flow.R).subs(Omega, sp.sqrt(X_)) - T, X_)
    of_T = {h_A: T - _w**2, Omega: _w, I: flow.I.subs(Omega, _w)}
    of_flow = {R: flow.R, k: _intercept(flow.R), T: slope(flow.R), X_: Omega**2, _w: Omega}
    half_F_AA, half_F_A, half_F_AAA = (sp.expand((f / 2).subs(of_T)) for f in (flow.F_AA, flow.F_A, flow.F_AAA))
    by_Omega = sp.expand(flow.F_AOmega.subs(of_T) / (4 * _w))
    claim("`R = k + A T`, `T = dR/dA`", (R - k - A * T).subs(of_flow))

    in_T, in_X = (
        sp.Poly(sp.expand(half_F_AA.subs(R, R_value).subs(_w, sp.sqrt(square)).subs(T, unknown)), variable)
        for R_value, square, unknown, variable in ((k + A * T, X, T, T), (h + A * X_, X_, X_ + h_A, X_))
    )
    for quadratic in (in_T, in_X):
        claim(
            f"`F_AA/2` is a monic quadratic in `{quadratic.gen}` (`T = dR/dA`, `X_ = Omega^2`)",
            quadratic.degree() == 2 and quadratic.LC() == 1,
        )
    half_e, half_c_1 = (quadratic.coeff_monomial(quadratic.gen) / 2 for quadratic in (in_T, in_X))
    discriminant = _half_e**2 - in_T.coeff_monomial(1)
    other = half_c_1**2 - in_X.coeff_monomial(1)
    claim(
        "both quadratics have the same discriminant",
        discriminant.subs(_half_e, half_e).subs(k, _intercept(flow.R)) - other,
    )
    claim("their linear coefficients differ by `2 h_A`", half_c_1 - h_A - half_e)
    quadratics = Lets(
        [(_half_e, half_e)],
        (_half_e, in_T.coeff_monomial(1), h_A + _half_e, in_X.coeff_monomial(1), discriminant),
    )
    text = "F_AA/2 = T^2 + 2 a T + b = X^2 + 2 c X + d, T = dR/dA, X = Omega^2: a, b, c, d, and a^2 - b = c^2 - d."
    of.add("cusps", quadratics, text, "from (33)", "A > 0")
    # where h_AA has the sign of R nothing cancels in the second
    (of_R,) = sp.solve(half_F_AA, R)
    text = "R where F_AA = 0 (`cusps`), in two forms: by its tangent, and from F_AA itself."
    of.add("cusp_R", (k + A * T, of_R.subs(_w**2, X_)), text, "from (33)", "A > 0, X >= 0")

    # F_AAOmega is 8 Omega times the root of the discriminant, with its sign
    F_AAOmega = 8 * Omega * (slope(flow.R) + half_e)
    claim(
        "`F_AAOmega` is `8 Omega` times the square root of the discriminant", (flow.F_AAOmega - F_AAOmega).subs(of.lets)
    )
    less = sp.collect(sp.expand((half_F_A - A * half_F_AA).subs(R, k + A * T)), T)
    derivative = -by_Omega * half_F_AAA / (2 * root)
    expected = -flow.F_AOmega * flow.F_AAA / (2 * F_AAOmega)
    level = sp.sqrt(k * R + sp.expand(_intercept(flow.I) * flow.I.subs(Omega, _w)))
    for one, whole, what in (
        (half_F_A, flow.F_A / 2, "`F_A/2` in `R`, `T` and `Omega`"),
        (less, (flow.F_A - A * flow.F_AA) / 2, "`(F_A - A F_AA)/2` in `T`"),
        (derivative.subs(root, T + half_e), expected, "derivative of `F_A` along `F_AA = 0`"),
        (level**2, flow.F + F_0**2 - A * flow.F_A / 2, "`F_0^2` at a cusp"),
    ):
        claim(what, (one.subs(of_flow) - whole).subs(of.lets))
    half_F_A = half_F_A.subs(_w**2, X_)
    of_X = [(_w, sp.sqrt(X_))]
    of.add(
        "cusp",
        Lets(of_X, (half_F_A, less, derivative, level)),
        "Where F_AA = 0 (`cusps`; root = a + T): F_A/2, the same less A F_AA/2, its slope along A, F_0 if it is 0.",
        "from (33)",
        "A > 0, X > 0",
    )

    @of.kernel("from (30)", "A > 0, X > 0, T not 0")
    def cusp_balance() -> Lets:
        """Omega^2 and F_0^2 at a cusp with R from F_A = 0, by an X = Omega^2 that is nearly right, and T (`cusps`).

        No h_AA, which may be steep along A.
        """
        (balanced,) = sp.solve(half_F_A.subs(X_, _w**2), R)
        (square,) = sp.solve((flow.R - R).subs(Omega, sp.sqrt(_X)), _X)
        of_flow = {T: slope(flow.R), _w: Omega}
        claim("`R` at `F_A = 0`", ((R - balanced) * T).subs(of_flow) - flow.F_A.subs(I, flow.I) / 2)
        return Lets([*of_X, (R, balanced)], (square, level**2))

    _scaled(of, flow, quadratics, X)


def _scaled(of: Formulas, flow: Formulas, quadratics: Lets, X: sp.Expr) -> None:
    """What bounds cusps in lanes (solver/cusp_lanes.c): kappa, rho and t, for h_AA other than 0, which vary by little.

    kappa stays between its value at one amplitude and -1/(2 + rho) as A rises from there, as A dkappa/dA = -1 -
    kappa (2 + rho).
    """
    unit, friction, ratio = A * h_AA, flow.I.subs(Omega, 0), sp.diff(flow.I, Omega) / (2 * A)
    P, Q = A * unit**2, 2 * friction * ratio * _w
    along_A = slope(k / (A**2 * h_AA), {k: -A * h_AA}).subs({k: kappa * A**2 * h_AA, h_AAA: rho * h_AA / A})
    by_scale = {k: kappa * A * unit, T: t * unit, R: (kappa + t) * A * unit, h_AAA: rho * h_AA / A}
    quadratic = (t**2 + 2 * quadratics.value[0] * t / unit + quadratics.value[1] / unit**2).subs(quadratics.lets)
    damped = 2 * ratio**2 / unit
    _, less, derivative, level = (value.subs(by_scale) for value in of.cusp)
    factors = (rho * (kappa + t) + 3 * t, kappa + 2 * t + (friction * ratio / (A * _w) + 4 * ratio**2) / unit)
    for what, one, other in (
        (
            "`A dkappa/dA = -1 - kappa (2 + rho)`, `kappa = k/(A^2 h_AA)`, `rho = A h_AAA/h_AA`",
            A * along_A,
            -1 - kappa * (2 + rho),
        ),
        (
            "`F_AA = 0` in `kappa` and `t = T/(A h_AA)`",
            quadratic.subs(by_scale),
            t**2 + (2 * damped + 1) * t + kappa - 2 * damped * h_A / unit,
        ),
        ("`Omega^2 = A h_AA t - h_A`", X.subs(by_scale), unit * t - h_A),
        ("`F_A` at a cusp in `kappa` and `t`", less, P * ((kappa - 1) * (t - 1) - 1) + Q),
        ("`F_0^2` at a cusp in `kappa` and `t`", level**2, friction**2 + A * Q + A * P * kappa * (kappa + t)),
        (
            "derivative of `F_A` along `F_AA = 0` in `kappa`, `rho` and `t`",
            derivative * root,
            -(unit**3) * sp.Mul(*factors) / 2,
        ),
    ):
        claim(what, one - other)


def _turn(of: Formulas, flow: Formulas) -> None:
    """R = k/2 - drawn and A T = -k/2 - drawn: of the two factors h + A Omega^2 and h_A + Omega^2, which nearly cancel
    where damping is weak, only their difference k is left.
    """
    of_T = {R: k + A * T, h_A: T - Omega**2, I: flow.I}
    (balanced,) = sp.solve(flow.F_AOmega.subs(of_T), T)
    drawn = sp.factor(sp.expand(-A * balanced - k / 2))
    claim("at `F_AOmega = 0`, `-R + k/2` does not depend on the spring", not drawn.has(k))
    of_R, of_slope = k / 2 - _drawn, -(k / 2 + _drawn) / A
    damped = sp.factor((flow.F_A / 2).subs(R, 0))
    value = of_R * of_slope + damped
    derivative = of_slope**2 + h_AA * of_R + sp.expand((flow.F_AA / 2).subs(R, 0) - slope(flow.R) ** 2)
    for one, whole in ((value, flow.F_A), (derivative, flow.F_AA)):
        left = one.subs(_drawn, drawn) - (whole / 2).subs(of_T).subs(T, balanced)
        claim("`F_A` and `F_AA` at `F_AOmega = 0`", left.subs(I, flow.I))
    turn = Lets([(I, flow.I), (_drawn, drawn)], (value, derivative))
    text = "F_A/2 where F_AOmega = 0, an extremum of F_A over Omega, and its slope along A."
    of.add("turn", turn, text, "from (30)", "Omega > 0, A > 0")


def _peak(of: Formulas, flow: Formulas) -> None:
    """With R from F_Omega = 0, which is negative, F_A is -2 R (Omega^2 - h_A)."""
    balanced = sp.expand(sp.solve(flow.F_Omega, R)[0].subs(I, flow.I))
    derivative = -2 * R * (Omega**2 - h_A)
    claim("`F_A = -2 R (Omega^2 - h_A)` at `F_Omega = 0`", (flow.F_A - derivative).subs(R, balanced).subs(I, flow.I))
    peak = Lets([(R, balanced), (I, flow.I)], (flow.F, derivative))
    text = "F where F_Omega = 0: an extremum of F over Omega, and its slope along A."
    of.add("peak", peak, text, "from (24), (34)")

    @of.kernel("from (34)")
    def peak_Omega_A() -> sp.Expr:
        """dOmega/dA along F_Omega = 0: what a rounding of A does to Omega at a peak.

        -F_AOmega/F_OmegaOmega, in which m zeta cancels once R is the one of F_Omega = 0.
        """
        quotient = -flow.F_AOmega / flow.F_OmegaOmega
        numerator, denominator = sp.fraction(sp.cancel(quotient.subs(R, balanced).subs(I, flow.I)))
        return sp.factor(numerator) / denominator


def _undamped(of: Formulas, flow: Formulas) -> None:
    """F_A = 2 R (Omega^2 + h_A); on the second factor F_AA/2 = R h_AA."""
    factor, remainder = sp.div(sp.expand(flow.F_A), 2 * R, R)
    claim("without damping `F_A = 2 R (Omega^2 + h_A)`", remainder == 0 and not factor.has(R))
    (square,) = sp.solve(factor.subs(Omega, sp.sqrt(_X)), _X)
    first, remainder = sp.div(sp.expand(flow.F_AA.subs(Omega, sp.sqrt(square)) / 2), R, R)
    claim("without damping `F_AA = 2 R h_AA` at `F_A = 0`", remainder == 0 and not first.has(R))
    second = flow.R.subs(Omega**2, square)
    at_fold = flow.F.subs({R: second, I: flow.I})
    both = "from (24), (30)"
    of.add("undamped_Omega", sp.sqrt(square), "Omega of the folds.", "from (30)", "h_A <= 0")

    @of.kernel(both, "F_0 > m")
    def fold() -> Lets:
        """Zero at a fold at F_0, where h_A < 0: R^2 + I^2 - F_0^2 on the undamped folds, and its slope along A."""
        lets = [(_excess, (F_0 - flow.I) * (F_0 + flow.I)), (_least, sp.sqrt(_excess))]
        value = (k - _least) * (k + _least)
        claim(
            "`F = (k - e) (k + e)` on the undamped folds, `e^2 = F_0^2 - m^2`",
            value.subs(reversed(lets)).subs(k, second) - at_fold,
        )
        return Lets(lets, (value, slope(value, {k: k_A})))

    # the level is stationary along the locus just where F_AA vanishes
    level = sp.sqrt(k**2 + flow.I**2)
    claim("forcing of the undamped folds: `F_0^2 = k^2 + m^2`", level.subs(k, second) ** 2 - at_fold - F_0**2)
    of.add("undamped_level", level, "The forcing of a fold, whose R is k.", both, "h_A <= 0")

    @of.kernel(both, "h_A <= 0")
    def undamped_rises() -> tuple[sp.Expr, ...]:
        """The sign of the level's slope along A on the undamped folds; and, where that is 0, of the slope's own."""
        rises = -first * k
        along_A = slope(level**2, {k: -A * h_AA})
        claim("derivative of `F_0^2` by `A` along the undamped folds", along_A - 2 * A * rises)
        return rises, slope(along_A, {k: -A * h_AA}).subs(h_AA, 0) / (2 * A)

    factors = (first, slope(first), second, slope(second))
    text = "The factors of F_AA/2 at the folds, each with its slope along A: h_AA, R."
    of.add("undamped", factors, text, "from (30), (33)", "A > 0")
