"""Steps 2 and 4 once more: dissipation by other laws beside viscous damping and dry friction on all of the cycle.

In:  the equation of motion (3), the averaged equations, `SlowFlow` with all damping; the mechanism stays an open h(A).
Out: `Dissipation`: with the sine balance (23) of any of these laws together, in I_0, its part that knows no frequency,

    I = I_0 + 2 zeta A Omega + d A^2 Omega^2

    law                                       force on the mass          its share of I
    structural, loss factor eta on k_v        (eta/Omega) u'             eta A, in I_0
    quadratic                                 c_2 |u'| u'                d A^2 Omega^2, d = 8 c_2/(3 pi)
    dry friction of what is attached          mu sign(u'), |u| < u_cr    m min(1, u_cr/A), in I_0

    F_0^2 + F and F_A/2 stay quartics in Omega. Their leading coefficients are positive, and those of Omega and Omega^3
    not negative: so each has at most two positive critical points, as without these laws. The third power is there
    where viscous and quadratic damping meet.
    The trace of the Jacobian (28), (29), is -(A I)_A/(2 A Omega). (A I)_A is a sum of terms of which none is negative,
    and only friction beyond u_cr has none: so (30) alone decides stability where something else dissipates too.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import sympy as sp

from ..claims import claim
from ..paper.averaging import VELOCITY, Averaged, cycle_integral
from ..paper.averaging import H as averaged_force
from ..paper.slow_flow import I, R, SlowFlow, m, slope
from ..symbols import F_0, A, Omega, c_2, eta, h, h_A, h_AA, mu, phi, psi, sigma, zeta
from ..systems.along import k
from ..systems.gradients import Curve, I_0AAp, I_0Ap, I_0p, d_p, h_AAp, h_Ap, h_p, zeta_p
from ..systems.slopes import DERIVATIVES, Let, hessian

#: the |u| up to which something is attached
u_cr = sp.Symbol("u_cr", positive=True)
#: what |h| grows by at most, over dA
steepest = sp.Symbol("steepest", nonnegative=True)
#: I at Omega = 0 and its derivatives by A; 8 c_2/(3 pi)
I_0, I_0A, I_0AA, I_0AAA = REST = sp.symbols("I_0 I_0A I_0AA I_0AAA", real=True)
d = sp.Symbol("d", nonnegative=True)
#: dI/dA and dR/dA; h/A, I_0/A and I/A
I_A, R_A = sp.symbols("I_A R_A", real=True)
h_over_A, I_0_over_A, I_over_A = sp.symbols("h_over_A I_0_over_A I_over_A", real=True)
#: 1/Omega
x = sp.Symbol("x", positive=True)
#: what I_0 less A I_0A is
level = sp.Symbol("level", nonnegative=True)
#: half the angle over which what is attached is not passed: cos(psi_0) = u_cr/A
psi_0 = sp.Symbol("psi_0", positive=True)


@dataclass(frozen=True)
class System:
    """Functions of (A, Omega) that vanish together, and their derivatives: by A, by Omega.

    values -- in R, I and the derivatives of h and I_0: two, or one that vanishes at Omega = 0
    slopes -- of the first, then of the second
    """

    values: tuple[sp.Expr, ...]
    slopes: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Dissipation:
    """Of any mechanism, in I_0 and its derivatives.

    quadratic -- d
    at_rest, released -- I_0 and three derivatives: friction acts throughout, or beyond u_cr nothing rubs any more
    I, I_A    -- sine balance (23), and its slope
    far       -- R, R_A, I and I_A over Omega^2, in x = 1/Omega
    F         -- response (24), in R and I
    F_A, ...  -- its derivatives
    F_A_halved -- F_A/2 by R, I and their slopes
    R_of_response, R_of_peak -- what R, or its size, is where F or F_Omega vanishes, in I;
                 R_of_peak_by_rest, in I_0
    I_scaled, F_A_scaled -- I/A, and F_A/(2 A) by I/A and h/A, which stay as A falls to 0
    least_scaled -- what 4/A times the least F_A/2 is not below there: a number and the factor of A^2, where
                 |k| <= A^2 |h_AA|/2
    Omega_A   -- slope of the response
    trace     -- -2 A Omega times the trace of the Jacobian (28)
    stability -- 4 Omega^2 times its determinant (30)
    peak      -- F_Omega/(4 A Omega), which does not vanish at Omega = 0
    fold_bend -- F_AOmega/Omega, likewise
    response_quartic, fold_quartic -- coefficients of F and F_A/2 by power of Omega, constant first
    limit_envelope -- (27) while friction acts throughout
    restoring -- the largest |h| of a state, by d: |R| <= F_0, and d (A Omega)^2 <= F_0
    turn_share -- D/Omega^2 in x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D
    least_by_inertia -- -Omega^5/4 dlevel^2/dOmega of an excitation by inertia, in R, I and h
    far_by_inertia -- F/Omega^4 of such an excitation in x = 1/Omega, and `least_by_inertia`/Omega^2 in two parts: the
                 second, which is not negative, grows with Omega
    R_where_stationary -- R/Omega^2 where the level of such an excitation is stationary, in x: a square that is not
                 negative there, and the lower and the higher value
    hessian  -- as `Slopes.determinant`, in its lets
    cusp_bend_by_inertia -- `Slopes.cusp` of such an excitation, less positive factors, in R, I and derivatives of F
    Omega_A_by_inertia -- slope of such a response
    F_OmegaOmega_by_inertia -- F_OmegaOmega of such an excitation where the level is stationary
    full_by_inertia -- the amplitude that a response tends to as Omega grows
    structural_bound -- above A, where |h| grows by s dA at most, no state lies where these are positive: and its slope
    quadratic_bound -- the amplitude that no state under an excitation by inertia exceeds, by d
    searched  -- systems of two functions, by what they are, in R, I and their slopes R_A, I_A along A at a given
                 Omega. `by_R`: A and R are the
                 unknowns, Omega^2 = (R - h)/A, in which nothing cancels where R is small; `by_Omega`: A and Omega are.
                 `far`: of an excitation by inertia, all over Omega^2, x = 1/Omega, x^2 = (R - A)/h
    sine_intercept -- I - A I_A, where the tangent of I at a given Omega meets A = 0, by that of I_0
    velocity  -- A Omega by I
    static -- F at Omega = 0 by its two halves h - c and h + c, and the slope of each
    rest_intercept, released_intercept -- I_0 - A I_0A
    curve     -- the response, for how answers move
    rest_moves, released_moves -- what m, eta and, where friction ends there, u_cr do to I_0, I_0A and I_0AA
    """

    quadratic: sp.Expr
    at_rest: tuple[sp.Expr, ...]
    released: tuple[sp.Expr, ...]
    I: sp.Expr
    I_A: sp.Expr
    far: tuple[sp.Expr, ...]
    F: sp.Expr
    F_A: sp.Expr
    F_AA: sp.Expr
    F_AAA: sp.Expr
    F_A_halved: sp.Expr
    R_of_response: sp.Expr
    R_of_peak: sp.Expr
    R_of_peak_by_rest: sp.Expr
    I_scaled: sp.Expr
    F_A_scaled: sp.Expr
    least_scaled: tuple[sp.Expr, sp.Expr]
    F_Omega: sp.Expr
    F_AOmega: sp.Expr
    F_OmegaOmega: sp.Expr
    F_AOmegaOmega: sp.Expr
    Omega_A: sp.Expr
    trace: sp.Expr
    stability: sp.Expr
    peak: sp.Expr
    response_quartic: tuple[sp.Expr, ...]
    fold_quartic: tuple[sp.Expr, ...]
    limit_envelope: sp.Expr
    restoring: sp.Expr
    turn_share: sp.Expr
    least_by_inertia: sp.Expr
    far_by_inertia: tuple[sp.Expr, ...]
    R_where_stationary: tuple[sp.Expr, ...]
    hessian_lets: tuple[Let, ...]
    hessian: sp.Expr
    cusp_bend_by_inertia: sp.Expr
    Omega_A_by_inertia: sp.Expr
    F_OmegaOmega_by_inertia: sp.Expr
    full_by_inertia: sp.Expr
    structural_bound: tuple[sp.Expr, ...]
    quadratic_bound: sp.Expr
    searched: dict[str, System]
    sine_intercept: sp.Expr
    velocity: sp.Expr
    static_lets: tuple[tuple[sp.Symbol, sp.Expr], ...]
    static: tuple[sp.Expr, ...]
    rest_intercept: sp.Expr
    released_intercept: sp.Expr
    curve: Curve
    rest_moves: tuple[sp.Expr, ...]
    released_moves: tuple[sp.Expr, ...]


def share(force: Callable[[int], sp.Expr], start: sp.Expr = sp.S.Zero) -> sp.Expr:
    """The share in I of a force on the left of (3), by the sign of u': -(1/pi) times its sine component over a cycle.

    start -- the force acts from this angle of each half of the cycle to as much before its end
    """
    halves = ((-1, start, sp.pi - start), (1, sp.pi + start, 2 * sp.pi - start))
    beside = sum(cycle_integral(force(sign) * sp.cos(psi), low, high) for sign, low, high in halves)
    claim("the share in R of a dissipating force", beside)
    found = -sum(cycle_integral(force(sign) * sp.sin(psi), low, high) for sign, low, high in halves) / sp.pi
    return sp.factor(sp.expand(found, trig=True))


def by_A(expression: sp.Expr, slopes: dict[sp.Symbol, sp.Expr] | None = None) -> sp.Expr:
    """d/dA along h, I_0 and their derivatives."""
    return slope(expression, {I_0: I_0A, I_0A: I_0AA, I_0AA: I_0AAA, **(slopes or {})})


def dissipation(averaged: Averaged, flow: SlowFlow) -> Dissipation:
    """All of it."""
    viscous = share(lambda _: 2 * zeta * VELOCITY)
    friction = share(lambda sign: mu * sp.Integer(sign))
    claim("the shares of viscous damping and dry friction", viscous + friction.subs(mu, sp.pi * m / 4) - flow.I)
    structural = share(lambda _: eta / Omega * VELOCITY)
    of_quadratic = share(lambda sign: sign * c_2 * VELOCITY**2)
    attached = share(lambda sign: mu * sp.Integer(sign), psi_0).subs(sp.cos(psi_0), u_cr / A)
    if attached.has(psi_0):
        raise ArithmeticError(f"the share of friction on one piece: {attached}")
    of_friction = {mu: sp.solve(flow.m - m, mu)[0]}

    def chain(value: sp.Expr) -> tuple[sp.Expr, ...]:
        return tuple(sp.diff(value, A, order) for order in range(4))

    factor = sp.cancel(of_quadratic / (A * Omega) ** 2)
    value = I_0 + viscous + d * A**2 * Omega**2
    slope_of_R, R_Omega = by_A(flow.R), sp.diff(flow.R, Omega)
    along_A = {R: slope_of_R, I: by_A(value)}

    def by_amplitude(expression: sp.Expr) -> sp.Expr:
        return by_A(expression, along_A)

    def by_Omega(expression: sp.Expr) -> sp.Expr:
        return (
            sp.diff(expression, Omega)
            + sp.diff(expression, R) * R_Omega
            + sp.diff(expression, I) * sp.diff(value, Omega)
        )

    whole = {R: flow.R, I: value}
    F = flow.F
    F_A, F_Omega = sp.factor_terms(by_amplitude(F)), by_Omega(F)
    F_AA, F_AOmega = sp.factor_terms(by_amplitude(F_A)), by_Omega(F_A)
    hessian_lets, determinant = hessian(F_AA * by_Omega(F_Omega) - F_AOmega**2, flow.R, value, by_A)
    peak = R + zeta * I_0 / Omega + A * (2 * zeta**2 + d * I_0 + d * A * Omega * (3 * zeta + d * A * Omega))
    claim("F_Omega over 4 A Omega", (4 * A * Omega * peak - F_Omega).subs(whole))
    linear = sp.Symbol("linear", real=True)
    of_linear = 2 * zeta * by_A(A * I_0)
    bend = sp.Poly(sp.expand((F_AOmega / 2).subs(whole)), Omega)
    claim("F_AOmega at Omega = 0", bend.coeff_monomial(1) - of_linear)
    bend_over = sp.expand((bend.as_expr() - bend.coeff_monomial(1)) / Omega)
    bend_over = sp.collect(bend_over, Omega) + linear / Omega
    turn = bend_over.subs(linear, of_linear)
    # where it vanishes R_A is -R/A less this over A
    share_of_turn = sp.expand(sp.expand(turn / 2 - flow.R - A * slope_of_R).subs(Omega, 1 / x) * x**2)
    if share_of_turn.has(h, h_A) or any(power.exp < 0 for power in share_of_turn.atoms(sp.Pow) if power.base == x):
        raise ArithmeticError(f"what F_AOmega has beside R and R_A: {share_of_turn}")
    halved = sp.expand((sp.diff(F, R) * R_A + sp.diff(F, I) * I_A) / 2)
    claim("F_A by R, I and their slopes", halved.subs({R_A: slope_of_R, I_A: by_A(value)}) - F_A / 2)
    R_of_peak = -sp.expand(sp.cancel(sp.diff(value, Omega) / R_Omega)) * I
    claim("R where F_Omega vanishes", (peak - R + R_of_peak).subs(whole))
    least_F_A = _least_F_A(halved)
    trace = _trace(averaged, flow, value)
    # a product by parts would cancel where the forcing is small
    by_inertia = F.subs(F_0, F_0 * Omega**2)
    static = F.subs(whole).subs(Omega, 0)
    product = sp.factor(h**2 - static)
    root = sp.Symbol("c", nonnegative=True)
    halves = (h - root, h + root)
    claim("the halves of F at Omega = 0", sp.expand(sp.Mul(*halves)).subs(root**2, product) - static)
    root_A = sp.cancel(by_A(product) / (2 * root))
    least = h * R + I * (I_0 + zeta * A * Omega)
    claim(
        "the slope of the level of an excitation by inertia",
        (4 * least + Omega**5 * sp.diff((F + F_0**2).subs(whole) / Omega**4, Omega)).subs(whole),
    )
    at_rest, released = (chain((one + structural).subs(of_friction)) for one in (friction, attached))
    if sp.diff(factor, c_2) * c_2 != factor:
        raise ArithmeticError("quadratic damping's share of I is not proportional to c_2")

    def moves(share: tuple[sp.Expr, ...], *by: sp.Symbol) -> tuple[sp.Expr, ...]:
        return tuple(sp.diff(one, symbol) for symbol in by for one in share[:3])

    return Dissipation(
        quadratic=factor,
        at_rest=at_rest,
        released=released,
        I=value,
        I_A=by_A(value),
        far=tuple(sp.expand((one / Omega**2).subs(Omega, 1 / x)) for one in (flow.R, slope_of_R, value, by_A(value))),
        F=F,
        F_A=F_A,
        F_AA=F_AA,
        F_AAA=sp.factor_terms(by_amplitude(F_AA)),
        F_A_halved=halved,
        R_of_response=sp.sqrt(R**2 - sp.expand(F)),
        R_of_peak=R_of_peak,
        R_of_peak_by_rest=R - peak,
        I_scaled=sp.expand(value.subs(I_0, A * I_0_over_A) / A),
        F_A_scaled=_F_A_scaled(halved, flow.R),
        least_scaled=_least_scaled(least_F_A, value),
        F_Omega=sp.factor_terms(F_Omega),
        F_AOmega=sp.factor_terms(F_AOmega),
        F_OmegaOmega=sp.factor_terms(by_Omega(F_Omega)),
        F_AOmegaOmega=sp.factor_terms(by_Omega(F_AOmega)),
        Omega_A=-F_A / F_Omega,
        trace=trace,
        stability=sp.factor_terms(F_A / (2 * A)),
        peak=peak,
        response_quartic=_coefficients((F + F_0**2).subs(whole)),
        fold_quartic=_coefficients((F_A / 2).subs(whole)),
        limit_envelope=_envelope(value),
        restoring=F_0 + (flow.R - h).subs(Omega, sp.sqrt(F_0 / d) / A),
        turn_share=sp.collect(share_of_turn, x),
        least_by_inertia=least,
        far_by_inertia=_far_by_inertia(flow.R, value, by_inertia.subs(whole), least.subs(whole)),
        R_where_stationary=_R_where_stationary(flow.R, value, least),
        hessian_lets=hessian_lets,
        hessian=determinant,
        # dlevel^2/dOmega takes the place of a force's F_Omega
        cusp_bend_by_inertia=least * DERIVATIVES[3, 0] * DERIVATIVES[1, 1],
        # on F = 0: dF/dOmega is Omega^4 times the slope of the squared level
        Omega_A_by_inertia=Omega * F_A / (4 * least),
        F_OmegaOmega_by_inertia=-4 * by_Omega(least) / Omega,
        full_by_inertia=_full(by_inertia.subs(whole)),
        structural_bound=_structural_bound(),
        quadratic_bound=_quadratic_bound(value),
        searched=_searched(flow.R, value, F, halved, peak),
        sine_intercept=sp.expand(value - A * by_A(value)).subs(I_0, level + A * I_0A),
        velocity=_velocity(value),
        static_lets=((root, sp.sqrt(product)),),
        static=(*halves, h_A - root_A, h_A + root_A),
        rest_intercept=_intercept(at_rest),
        released_intercept=_intercept(released),
        curve=Curve(
            R=flow.R,
            I=value,
            F=F,
            F_A=F_A,
            F_AA=F_AA,
            F_AAA=sp.factor_terms(by_amplitude(F_AA)),
            F_Omega=sp.factor_terms(F_Omega),
            F_AOmega=sp.factor_terms(F_AOmega),
            F_AAOmega=sp.factor_terms(by_amplitude(F_AOmega)),
            F_OmegaOmega=sp.factor_terms(by_Omega(F_Omega)),
            phase=flow.phase,
            transmissibility=flow.transmissibility,
            moved={h: h_p, h_A: h_Ap, h_AA: h_AAp, I_0: I_0p, I_0A: I_0Ap, I_0AA: I_0AAp, zeta: zeta_p, d: d_p},
            rises={I_0: I_0A, I_0A: I_0AA, I_0AA: I_0AAA},
        ),
        rest_moves=moves(at_rest, m, eta),
        released_moves=moves(released, m, eta, u_cr),
    )


def _intercept(rest: tuple[sp.Expr, ...]) -> sp.Expr:
    return sp.expand(rest[0] - A * rest[1])


def _velocity(value: sp.Expr) -> sp.Expr:
    """A Omega where I is known, in the form in which nothing cancels."""
    v = sp.Symbol("v", nonnegative=True)
    balance = sp.Poly(sp.expand(value.subs(Omega, v / A)) - I, v)
    constant, linear, second = (balance.coeff_monomial(v**power) for power in range(3))
    found = -2 * constant / (linear + sp.sqrt(linear**2 - 4 * second * constant))
    claim("the velocity by I", balance.as_expr().subs(v, found))
    return sp.simplify(found)


def _searched(of_R: sp.Expr, value: sp.Expr, F: sp.Expr, halved: sp.Expr, peak: sp.Expr) -> dict[str, System]:
    """By implicit differentiation: on a line of constant R the frequency moves by -R_A/R_w along A."""
    result = {}
    for w in (Omega, x):

        def at(whole: sp.Expr, w: sp.Symbol = w) -> sp.Expr:
            return whole if w == Omega else sp.expand(sp.expand(whole / Omega**2).subs(Omega, 1 / x))

        known = {symbol: at(whole) for symbol, whole in ((R, of_R), (I, value), (R_A, by_A(of_R)), (I_A, by_A(value)))}
        # along A at a constant frequency
        rises = {R: R_A, I: I_A, R_A: by_A(known[R_A]), I_A: by_A(known[I_A])}
        by_frequency = {symbol: sp.factor_terms(sp.diff(whole, w)) for symbol, whole in known.items()}
        bend = sp.expand(sum(sp.diff(halved, symbol) * rises[symbol] for symbol in rises))
        # where R^2 + I^2 is over its slope by R; by w in the form that does not vanish at w = 0
        stationary = {
            "by_R": R + sp.expand(by_frequency[I] / by_frequency[R]) * I,
            f"by_{w}": peak if w == Omega else R * h + I_0 * I + A * zeta * sp.expand(known[I] / x),
        }
        for one, scale in zip(
            stationary.values(), (2 * by_frequency[R], 4 * A * Omega if w == Omega else 4 * x), strict=True
        ):
            if sp.expand(sp.expand((one * scale).subs(known)) - sp.diff(F.subs(known), w)) != 0:
                raise ArithmeticError(f"where the level is stationary: {one}")

        def slope_of(
            expression: sp.Expr,
            moved: sp.Expr,
            of_R: sp.Expr,
            by: sp.Expr,
            known: Sequence[dict[sp.Symbol, sp.Expr]] = (rises, by_frequency),
            w: sp.Symbol = w,
        ) -> sp.Expr:
            """Where the frequency moves by `moved`, R by `of_R` and A by `by`."""
            found = sp.diff(expression, w) * moved + sp.diff(expression, R) * of_R + by_A(expression) * by
            for symbol in (I, R_A, I_A):
                found += sp.diff(expression, symbol) * (known[0][symbol] * by + known[1][symbol] * moved)
            return sp.factor_terms(found)

        by_R, none, one = 1 / by_frequency[R], sp.S.Zero, sp.S.One
        directions = {
            "by_R": ((-R_A * by_R, none, one), (by_R, one, none)),
            f"by_{w}": ((none, R_A, one), (one, by_frequency[R], none)),
        }
        for named, lines in directions.items():
            found = {
                "folds": (F, halved),
                "peaks": (F, stationary[named]),
                "cusps": (halved, bend),
                "isolas": (halved, stationary[named]),
            }
            if w == Omega:
                turn = sp.expand(sum(sp.diff(halved, one) * rise for one, rise in by_frequency.items()) / (2 * Omega))
                found["turns"] = (halved, turn)
            for system, values in found.items():
                slopes = tuple(slope_of(each, *line) for each in values for line in lines)
                if system == "turns":  # in which R_A less R_A is left otherwise
                    slopes = tuple(sp.factor_terms(sp.expand(one)) for one in slopes)
                result[f"{system}_{'far_' if w == x else ''}{named}"] = System(values, slopes)
    return result


def _far_by_inertia(R: sp.Expr, I: sp.Expr, F: sp.Expr, least: sp.Expr) -> tuple[sp.Expr, ...]:
    """The first as squares, of which nothing cancels but F_0^2."""
    at_x = {Omega: 1 / x}
    of_least = sp.expand(sp.expand(least).subs(at_x) * x**2)
    grows = of_least.coeff(x, -1)
    stays = sp.expand(of_least - grows / x)
    if grows != zeta * d * A**3 or sp.Poly(stays, x).degree() != 2:
        raise ArithmeticError(f"what vanishes where a level is least: {of_least}")
    whole = sum(sp.expand(one.subs(at_x) * x**2) ** 2 for one in (R, I)) - F_0**2
    claim("F over Omega^4", whole - F.subs(at_x) * x**4)
    claim("the leading coefficient of F", whole.subs(x, 0) - (A**2 + d**2 * A**4 - F_0**2))
    return whole, sp.collect(stays, x), grows


def _R_where_stationary(R_of: sp.Expr, I_of: sp.Expr, least: sp.Expr) -> tuple[sp.Expr, ...]:
    """Of R = r Omega^2 without h = R - A Omega^2, which may vanish there: by what r (A - r) is."""
    r = sp.Symbol("r", real=True)
    scaled = sp.expand(least.subs(h, R - (R_of - h)).subs({R: r * Omega**2, I: I_of}) / Omega**4)
    product = sp.factor((scaled - r**2 + A * r).subs(Omega, 1 / x))
    if product.has(r):
        raise ArithmeticError(f"R where a level is stationary: {scaled}")
    square = A**2 - 4 * product
    higher = (A + sp.sqrt(square)) / 2
    lower = product / higher
    for one in (lower, higher):
        claim("R where a level is stationary", scaled.subs(Omega, 1 / x).subs(r, one))
    return square, lower, higher


def _full(F: sp.Expr) -> sp.Expr:
    """The positive amplitude at which F/Omega^4 vanishes as Omega grows, in the form that stays for d = 0."""
    X = sp.Symbol("X", nonnegative=True)
    leading = sp.Poly(sp.expand(F), Omega).coeff_monomial(Omega**4).subs(A, sp.sqrt(X))
    found = 2 * F_0**2 / (1 + sp.sqrt(1 + 4 * d**2 * F_0**2))
    claim("the amplitude as Omega grows", leading.subs(X, found))
    return sp.sqrt(found)


def _structural_bound() -> tuple[sp.Expr, ...]:
    """eta A <= I <= F_0 Omega^2, and A Omega^2 - |h| <= |R| <= F_0 Omega^2: so eta A (A - F_0) <= F_0 |h|."""
    excess = eta * A * (A - F_0) - F_0 * sp.Abs(h)
    return excess, sp.diff(excess.subs(h, 0), A) - F_0 * steepest


def _quadratic_bound(value: sp.Expr) -> sp.Expr:
    """d (A Omega)^2 <= I <= F_0 Omega^2."""
    found = sp.sqrt(F_0 / d)
    claim("quadratic damping at its bound", sp.Poly(value, Omega).coeff_monomial(Omega**2).subs(A, found) - F_0)
    return found


def _least_F_A(halved: sp.Expr) -> sp.Expr:
    """R = k + A R_A: F_A/2 is least in R where its own slope by R vanishes."""
    by_R = halved.subs(R_A, (R - k) / A)
    if not sp.diff(by_R, R, 2).is_positive:
        raise ArithmeticError(f"F_A/2 has no least value in R: {by_R}")
    return sp.expand(4 * A * by_R.subs(R, sp.solve(sp.diff(by_R, R), R)[0]))


def _F_A_scaled(halved: sp.Expr, value: sp.Expr) -> sp.Expr:
    """F_A/(2 A) by what stays as A falls to 0."""
    over, slope_of_R = sp.expand(value.subs(h, A * h_over_A) / A), by_A(value)
    found = over * slope_of_R + I_over_A * I_A
    claim("F_A over 2 A", found - halved.subs({R: A * over, R_A: slope_of_R, I: A * I_over_A}) / A)
    return found


def _least_scaled(least_F_A: sp.Expr, value: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Friction raises I by a number, and the first power of A raises the whole: both are left out."""
    without = value.subs(I_0, eta * A)
    whole = least_F_A.subs({I: without, I_A: sp.diff(without, A), k: A**2 * h_AA / 2})
    scaled = sp.Poly(sp.expand(whole / A**2), A)
    constant, first, second = (scaled.coeff_monomial(A**power) for power in range(3))
    if scaled.degree() != 2 or any(term.could_extract_minus_sign() for term in sp.Add.make_args(first)):
        raise ArithmeticError(f"what F_A is not below as A falls to 0: {scaled}")
    return sp.factor(constant), second


def _coefficients(expression: sp.Expr) -> tuple[sp.Expr, ...]:
    """By power of Omega, after a check of the signs that bound the number of roots."""
    polynomial = sp.Poly(sp.expand(expression), Omega)
    found = [polynomial.coeff_monomial(Omega**power) for power in range(5)]
    if polynomial.degree() != 4:
        raise ArithmeticError(f"not a quartic in Omega: {expression}")
    for power in (1, 3, 4):
        # (A I_0)_A is not negative for each law by itself, see `_trace`
        named = sp.expand(found[power]).subs(I_0A, (sp.Symbol("rise", nonnegative=True) - I_0) / A)
        positive = named.subs(I_0, sp.Symbol("I_0", nonnegative=True))
        if any(term.could_extract_minus_sign() for term in sp.Add.make_args(sp.expand(positive))):
            raise ArithmeticError(f"the coefficient of Omega^{power} may be negative: {found[power]}")
    return tuple(sp.collect(one, (h, h_A, A)) for one in found)


def _trace(averaged: Averaged, flow: SlowFlow, value: sp.Expr) -> sp.Expr:
    """(A I)_A, from the trace of the slow flow's Jacobian at a fixed point."""
    A_rate, A_phi_rate = (
        sp.expand(rate.subs({sigma: Omega**2 - 1, averaged_force: h + A, mu: sp.pi * m / 4}))
        for rate in averaged.slow_flow
    )
    # the dissipation of the amplitude's equation, by the law that it has there
    own = sp.expand(flow.I)
    A_rate = sp.expand(A_rate + (own - value) / (2 * Omega))
    claim("the amplitude's equation", -2 * Omega * A_rate - F_0 * sp.sin(phi) - value)
    whole = by_A(A_rate) + sp.diff(A_phi_rate / A, phi)
    at_fixed_point = sp.expand(whole).subs(F_0 * sp.sin(phi), -value)
    rise = by_A(A * value)
    claim("the trace of the Jacobian", -2 * A * Omega * at_fixed_point - rise)
    return sp.collect(sp.expand(rise), (A, Omega))


def _envelope(value: sp.Expr) -> sp.Expr:
    """The largest A with I = F_0 where I_0 = m + eta A, in the form in which nothing cancels."""
    balance = sp.Poly(sp.expand(value.subs(I_0, m + eta * A) - F_0), A)
    constant, linear, second = (balance.coeff_monomial(A**power) for power in range(3))
    found = -2 * constant / (linear + sp.sqrt(linear**2 - 4 * second * constant))
    claim("the limit envelope", balance.as_expr().subs(A, found))
    return found
