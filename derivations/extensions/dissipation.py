"""Steps 2 and 4 once more: dissipation by other laws beside viscous damping and dry friction on all of the cycle.

In:  the equation of motion (3), the averaged equations, the slow flow with all damping; the mechanism is an open h(A).
Out: `Formulas`: with the sine balance (23) of any of these laws together, in I_0, its part that knows no frequency,

    I = I_0 + 2 zeta(A) A Omega + d A^2 Omega^2 + d_3 A^3 Omega^3

    law                                       force on the mass          its share of I
    structural, loss factor eta on k_v        (eta/Omega) u'             eta A, in I_0
    viscous, growing with the displacement    2 zeta_2 u^2 u'            zeta(A) = zeta + zeta_2 A^2/4
    quadratic                                 c_2 |u'| u'                d A^2 Omega^2, d = 8 c_2/(3 pi)
    cubic                                     c_3 u'^3                   d_3 A^3 Omega^3, d_3 = 3 c_3/4
    dry friction of what is attached          mu sign(u'), |u| < u_cr    m min(1, u_cr/A), in I_0

    F_0^2 + F and F_A/2 are polynomials in Omega of degree 4, with cubic damping 6. Beside the constant only the
    coefficient of Omega^2 may be negative: so each has at most two positive critical points, as without these laws.
    The square of an excitation by inertia has the power 4: with cubic damping there may be more, it is not derived.
    The trace of the Jacobian (28), (29), is -(A I)_A/(2 A Omega). (A I)_A is a sum of terms of which none is negative,
    and only friction beyond u_cr has none: so (30) alone decides stability where something else dissipates too.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

import sympy as sp

from ..claims import claim
from ..kernels import Formulas, Lets
from ..paper.averaging import DISPLACEMENT, VELOCITY, Averaged, cycle_integral
from ..paper.averaging import H as averaged_force
from ..paper.slow_flow import I, R, m, slope
from ..symbols import F_0, A, Omega, c_2, c_3, eta, h, h_A, h_AA, h_AAA, mu, phi, psi, sigma, zeta, zeta_2
from ..systems.gradients import I_0AAp, I_0Ap, I_0p, d_3p, d_p, h_AAp, h_Ap, h_p, zeta_AAp, zeta_Ap, zeta_p
from ..systems.slopes import DERIVATIVES, hessian

#: the |u| up to which something is attached
u_cr = sp.Symbol("u_cr", positive=True)
#: what |h| grows by at most, over dA
steepest = sp.Symbol("steepest", nonnegative=True)
#: I at Omega = 0 and its derivatives by A; those of the viscous damping ratio of a cycle; 8 c_2/(3 pi)
#: and 3 c_3/4
I_0, I_0A, I_0AA, I_0AAA = REST = sp.symbols("I_0 I_0A I_0AA I_0AAA", real=True)
zeta_A, zeta_AA, zeta_AAA = sp.symbols("zeta_A zeta_AA zeta_AAA", nonnegative=True)
VISCOUS = zeta, zeta_A, zeta_AA, zeta_AAA
d, d_3 = sp.symbols("d d_3", nonnegative=True)
#: dI/dA and dR/dA
I_A, R_A = sp.symbols("I_A R_A", real=True)
#: 1/Omega
x = sp.Symbol("x", positive=True)
#: what I_0 less A I_0A is
level = sp.Symbol("level", nonnegative=True)
#: half the angle over which what is attached is not passed: cos(psi_0) = u_cr/A
psi_0 = sp.Symbol("psi_0", positive=True)

#: what the systems of the search take, after the frequency
KNOWN = (A, F_0, *REST, *VISCOUS, d, d_3, h, h_A, h_AA, h_AAA)
#: of arguments
ORDER = (
    *(Omega, x, A, F_0, m, *REST, level, *VISCOUS, zeta_2, eta, d, d_3, c_2, c_3, u_cr),
    *(h, h_A, h_AA, h_AAA, steepest, R, R_A, I, I_A),
)
#: the systems of the search, functions of (A, Omega) that vanish together, in words
SEARCHED = {
    "folds": ("F and F_A/2", "from (24), (30)"),
    "peaks": ("F and what vanishes where the level is stationary", "from (24)"),
    "cusps": ("F_A/2 and F_AA/2", "from (30), (33)"),
    "isolas": ("F_A/2 and what vanishes where the level is stationary", "from (30)"),
    "turns": ("F_A/2 and F_AOmega/(4 Omega)", "from (30)"),
}


def contribution(force: Callable[[int], sp.Expr], start: sp.Expr = sp.S.Zero) -> sp.Expr:
    """The share in I of a force on the left of (3), by the sign of u': -(1/pi) times its sine component over a cycle.

    start -- the force acts from this angle of each half of the cycle to as much before its end
    """
    halves = ((-1, start, sp.pi - start), (1, sp.pi + start, 2 * sp.pi - start))
    in_phase = sum(cycle_integral(force(sign) * sp.cos(psi), low, high) for sign, low, high in halves)
    claim("a damping force contributes nothing to `R`", in_phase)
    found = -sum(cycle_integral(force(sign) * sp.sin(psi), low, high) for sign, low, high in halves) / sp.pi
    return sp.factor(sp.expand(found, trig=True))


def by_A(expression: sp.Expr, slopes: dict[sp.Symbol, sp.Expr] | None = None) -> sp.Expr:
    """d/dA along h, I_0, zeta and their derivatives."""
    own = {symbol: rise for of in (REST, VISCOUS) for symbol, rise in pairwise(of)}
    return slope(expression, own | (slopes or {}))


def dissipation(averaged: Averaged, flow: Formulas, slopes: Formulas) -> Formulas:
    """Of any mechanism, in I_0 and its derivatives; R, and what contains I as a number, are those of the slow flow."""
    viscous = contribution(lambda _: 2 * zeta * VELOCITY)
    friction = contribution(lambda sign: mu * sp.Integer(sign))
    claim(
        "viscous damping and dry friction contribute `I = 2 zeta A Omega + m`",
        viscous + friction.subs(mu, sp.pi * m / 4) - flow.I,
    )
    structural = contribution(lambda _: eta / Omega * VELOCITY)
    growing = contribution(lambda _: 2 * (zeta + zeta_2 * DISPLACEMENT**2) * VELOCITY)
    attached = contribution(lambda sign: mu * sp.Integer(sign), psi_0).subs(sp.cos(psi_0), u_cr / A)
    if attached.has(psi_0):
        raise ArithmeticError(f"the share of friction on one piece: {attached}")
    of_friction = {mu: sp.solve(flow.friction - m, mu)[0]}
    value = I_0 + viscous + d * A**2 * Omega**2 + d_3 * A**3 * Omega**3
    slope_of_R, R_Omega = by_A(flow.R), sp.diff(flow.R, Omega)
    along_A = {R: slope_of_R, I: by_A(value)}
    whole = {R: flow.R, I: value}
    of = Formulas(ORDER, whole)

    def by_amplitude(expression: sp.Expr) -> sp.Expr:
        return by_A(expression, along_A)

    def by_Omega(expression: sp.Expr) -> sp.Expr:
        return (
            sp.diff(expression, Omega)
            + sp.diff(expression, R) * R_Omega
            + sp.diff(expression, I) * sp.diff(value, Omega)
        )

    def chain(of_share: sp.Expr) -> tuple[sp.Expr, ...]:
        return tuple(sp.diff(of_share.subs(of_friction), A, order) for order in range(4))

    def sensitivities(of_share: Sequence[sp.Expr], *by: sp.Symbol) -> tuple[sp.Expr, ...]:
        return tuple(sp.diff(one, symbol) for symbol in by for one in of_share[:3])

    for name, c, power in (("quadratic", c_2, 2), ("cubic", c_3, 3)):
        factor = sp.cancel(
            contribution(lambda sign, c=c, n=power: sign ** (n + 1) * c * VELOCITY**n) / (A * Omega) ** power
        )
        claim(
            f"the contribution of {name} damping to `I` is proportional to its coefficient",
            sp.diff(factor, c) * c - factor,
        )
        of.add(name, factor, f"The factor of A^{power} Omega^{power} in I of {name} damping.", "from (19)", "any")

    @of.kernel("from (23)", "A > 0, d > 0")
    def restoring() -> sp.Expr:
        """The largest |h| of a state with this amplitude, as quadratic damping bounds its frequency.

        |R| <= F_0, and d (A Omega)^2 <= F_0.
        """
        return F_0 + (flow.R - h).subs(Omega, sp.sqrt(F_0 / d) / A)

    beyond, only = "A >= u_cr > 0", "where friction acts for |u| < u_cr only."
    text = "I_0, I at Omega = 0, and three derivatives by A: friction acts throughout."
    at_rest = of.add("at_rest", chain(friction + structural), text, "from (19)", "A > 0")
    released = of.add("released", chain(attached + structural), f"The same {only}", "from (19)", beyond)
    text = "What m, then eta, does to I_0, I_0A and I_0AA: friction acts throughout."
    of.add("rest_moves", sensitivities(at_rest, m, eta), text, "from (19)", "A > 0")
    text = f"What m, then eta, then u_cr does to them {only}"
    of.add("released_moves", sensitivities(released, m, eta, u_cr), text, "from (19)", beyond)
    ratio = chain(sp.expand(growing * zeta / viscous))
    text = "The viscous damping ratio of a cycle, and three derivatives by A."
    viscous_ratio = of.add("viscous", ratio, text, "from (19)", "A > 0")
    text = "What zeta_2 does to the first three of `viscous`."
    of.add("viscous_moves", sensitivities(viscous_ratio, zeta_2), text, "from (19)", "A > 0")
    of.add("I", value, "Sine balance, -F_0 sin phi at a fixed point.", "(23)")
    of.add("I_A", by_A(value), "dI/dA.", "(23)")
    of.add("I_AA", by_A(by_A(value)), "d2I/dA2.", "(23)")
    # where all is over Omega^2, of an excitation by inertia, cubic damping is not derived
    lower = value.subs(d_3, 0)
    far = tuple(sp.expand((one / Omega**2).subs(Omega, 1 / x)) for one in (flow.R, slope_of_R, lower, by_A(lower)))
    of.add("far", far, "R, R_A, I and I_A over Omega^2, at x = 1/Omega.", "(23)", "x >= 0, A > 0")

    F = of.add("F", flow.F, "Zero at a steady state.", "(24)")
    F_A = sp.factor_terms(by_amplitude(F))
    of.add("F_A", F_A, "dF/dA; positive where stable.", "(24), (30)")
    F_AA = of.add("F_AA", sp.factor_terms(by_amplitude(F_A)), "d2F/dA2.", "(24)")
    F_Omega, F_AOmega = by_Omega(F), by_Omega(F_A)
    of.add("F_Omega", sp.factor_terms(F_Omega), "dF/dOmega.", "(24)")
    of.add("F_OmegaOmega", sp.factor_terms(by_Omega(F_Omega)), "d2F/dOmega2.", "(24)")
    of.F_AOmega = sp.factor_terms(F_AOmega)
    of.add("F_AOmegaOmega", sp.factor_terms(by_Omega(F_AOmega)), "d3F/dA dOmega2.", "(24)")
    of.add("Omega_A", -F_A / F_Omega, "dOmega/dA along the response.", "from (24)")

    # a product by parts would cancel where the forcing is small
    by_inertia = F.subs(F_0, F_0 * Omega**2)
    # -Omega^5/4 dlevel^2/dOmega of an excitation by inertia
    least = h * R + I * (I_0 + zeta * A * Omega - d_3 * A**3 * Omega**3 / 2)
    claim(
        "`Omega^5 d(F_0^2)/dOmega` under base excitation or unbalance",
        (4 * least + Omega**5 * sp.diff((F + F_0**2).subs(whole) / Omega**4, Omega)).subs(whole),
    )
    # on F = 0: dF/dOmega is Omega^4 times the slope of the squared level
    text = "The same of an excitation by inertia."
    of.add("Omega_A_by_inertia", Omega * F_A / (4 * least), text, "from (24)")

    derivatives = {
        DERIVATIVES[2, 0]: F_AA,
        DERIVATIVES[3, 0]: sp.factor_terms(by_amplitude(F_AA)),
        DERIVATIVES[0, 1]: of.F_Omega,
        DERIVATIVES[1, 1]: of.F_AOmega,
        DERIVATIVES[0, 2]: of.F_OmegaOmega,
    }

    def in_derivatives(*values: sp.Expr, others: dict[sp.Symbol, sp.Expr] | None = None) -> Lets:
        """With the values of the derivatives of F that are in them."""
        used = {one: known for one, known in (derivatives | (others or {})).items() if any(v.has(one) for v in values)}
        return Lets([*whole.items(), *used.items()], values if len(values) > 1 else values[0])

    both = "from (24), (30)"
    text = "Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum."
    of.add("cusp_bend", in_derivatives(slopes.cusp_bend), text, both)

    @of.kernel(both)
    def isola_bend() -> Lets:
        """At an isola point: negative at a saddle of F; and as `cusp_bend`.

        By second derivatives of F, whose squares cancel in the determinant.
        """
        lets, determinant = hessian(F_AA * by_Omega(F_Omega) - F_AOmega**2, flow.R, value, by_A)
        by_it = sp.cancel(slopes.isola_by_it / slopes.determinant)
        return Lets([*whole.items(), (DERIVATIVES[2, 0], F_AA), *lets], (determinant, by_it * determinant))

    text = "4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive."
    of.add("stability", sp.factor_terms(F_A / (2 * A)), text, "(30)")
    _trace(averaged, flow, value)

    @of.kernel("from (24)", "F_0 > I_0")
    def static() -> Lets:
        """F at Omega = 0 by its halves h - c and h + c, c^2 = F_0^2 - I_0^2; and the slope of each."""
        at_0 = F.subs(whole).subs(Omega, 0)
        product = sp.factor(h**2 - at_0)
        root = sp.Symbol("c", nonnegative=True)
        halves = (h - root, h + root)
        claim(
            "`F = (h - c) (h + c)` at `Omega = 0`, `c^2 = F_0^2 - I_0^2`",
            sp.expand(sp.Mul(*halves)).subs(root**2, product) - at_0,
        )
        root_A = sp.cancel(by_A(product) / (2 * root))
        return Lets([(root, sp.sqrt(product))], (*halves, h_A - root_A, h_A + root_A))

    text = "as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^6."
    of.add("response_polynomial", _coefficients((F + F_0**2).subs(whole)), f"F + F_0^2 {text}", "(24)", "A > 0")
    of.add("fold_polynomial", _coefficients((F_A / 2).subs(whole)), f"F_A/2 {text}", "(30)", "A > 0")

    @of.kernel("(27)", "Omega > 0, F_0 > m, one of zeta, eta, d > 0")
    def limit_envelope() -> sp.Expr:
        """Largest amplitude that the forcing can hold at this frequency, where friction acts throughout.

        The largest A with I = F_0 where I_0 = m + eta A, in the form in which nothing cancels; no less than it where
        more dissipates.
        """
        balance = sp.Poly(sp.expand(lower.subs(I_0, m + eta * A) - F_0), A)
        found = _root(balance)
        claim("stable form of the limit envelope `I = F_0`", balance.as_expr().subs(A, found))
        return found

    # F_Omega/(4 A Omega) and F_AOmega/Omega do not vanish at Omega = 0
    peak = R + zeta * I_0 / Omega + A * (2 * zeta**2 + d * I_0 + d * A * Omega * (3 * zeta + d * A * Omega))
    v = A * Omega
    peak += d_3 * A * v / 2 * (3 * I_0 + v * (8 * zeta + v * (5 * d + 3 * d_3 * v)))
    claim(
        "`F_Omega/(4 A Omega)` is a polynomial in `A`, `Omega` and `I_0/Omega`",
        (4 * A * Omega * peak - F_Omega).subs(whole),
    )

    # D, where F_AOmega/(4 Omega) = R + A R_A + D
    excess = sp.expand(sp.expand((F_AOmega / (4 * Omega)).subs(whole)) - flow.R - A * slope_of_R)
    claim("`F_AOmega/(4 Omega) - R - A R_A` does not depend on `h`", excess - excess.subs({h: 0, h_A: 0}))

    def over(one: sp.Expr, power: int) -> sp.Expr:
        """Over a power of Omega, at x = 1/Omega, in which it is a polynomial."""
        found = sp.expand(one.subs(Omega, 1 / x) * x**power)
        return sp.collect(sp.Poly(found, x).as_expr(), x)

    text = "D/Omega^2 at x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D without cubic damping."
    of.add("turn_share", over(excess.subs(d_3, 0), 2), text, "from (30)", "x >= 0, A > 0")
    powers = ((flow.R, 2), (excess, 4), (value, 3), (by_A(value), 3))
    text = "R x^2, D x^4, I x^3 and I_A x^3 at x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D."
    of.add("turn_terms", tuple(over(*one) for one in powers), text, "from (30)", "x >= 0, A > 0")

    halved = sp.expand((sp.diff(F, R) * R_A + sp.diff(F, I) * I_A) / 2)
    claim("`F_A/2 = R R_A + I I_A`", halved.subs({R_A: slope_of_R, I_A: by_A(value)}) - F_A / 2)
    R_of_peak = -sp.expand(sp.cancel(sp.diff(value, Omega) / R_Omega)) * I
    claim("`R` at `F_Omega = 0`", (peak - R + R_of_peak).subs(whole))
    # of numbers R and I
    quadrant = "Omega >= 0, A > 0"
    of.add("F_A_halved", Lets((), halved), "F_A/2 by R, I and their slopes.", "(30)", quadrant)
    of_response = sp.sqrt(R**2 - sp.expand(F))
    of.add("R_of_response", Lets((), of_response), "The size of R where F = 0.", "(24)", quadrant)
    of.add("R_of_peak", Lets((), R_of_peak), "R where F_Omega = 0.", "from (24)", quadrant)
    text = "Where a level by inertia is stationary, x = 1/Omega: what is not negative, lower and higher R/Omega^2."
    of.add("R_where_stationary", _R_where_stationary(flow.R, lower, least.subs(d_3, 0)), text, "from (24)", quadrant)

    text = "F/Omega^4 at x = 1/Omega; and -Omega^3/4 dlevel^2/dOmega, less Omega times the third."
    of_level = _far_by_inertia(flow.R, lower, *(one.subs(whole).subs(d_3, 0) for one in (by_inertia, least)))
    of.add("far_by_inertia", of_level, text, "(24)", "x >= 0, A > 0")
    # dlevel^2/dOmega takes the place of a force's F_Omega
    bend = in_derivatives(least * DERIVATIVES[3, 0] * DERIVATIVES[1, 1])
    of.add("cusp_bend_by_inertia", bend, "As `cusp_bend`, for an excitation by inertia.", both)
    # where the level is stationary
    there = {DERIVATIVES[0, 2]: -4 * by_Omega(least) / Omega}
    bend = in_derivatives(slopes.determinant, slopes.isola_by_it, others=there)
    of.add("isola_bend_by_inertia", bend, "As `isola_bend`, for an excitation by inertia.", both)
    text = "The amplitude that the response tends to as Omega grows."
    of.add("full_by_inertia", _full(by_inertia.subs(whole).subs(d_3, 0)), text, "from (24)", "F_0 > 0")

    @of.kernel("from (23), (24)", "A > 0")
    def structural_bound() -> tuple[sp.Expr, ...]:
        """Both positive: no state above A, while |h| grows by steepest dA at most.

        eta A <= I <= F_0 Omega^2, and A Omega^2 - |h| <= |R| <= F_0 Omega^2: so eta A (A - F_0) <= F_0 |h|.
        """
        excess = eta * A * (A - F_0) - F_0 * sp.Abs(h)
        return excess, sp.diff(excess.subs(h, 0), A) - F_0 * steepest

    @of.kernel("from (23), (24)", "d > 0")
    def quadratic_bound() -> sp.Expr:
        """What no amplitude exceeds.

        d (A Omega)^2 <= I <= F_0 Omega^2.
        """
        found = sp.sqrt(F_0 / d)
        claim(
            "`d A^2 = F_0` at the bound of the amplitude under quadratic damping",
            sp.Poly(value, Omega).coeff_monomial(Omega**2).subs(A, found) - F_0,
        )
        return found

    _searched(of, flow.R, value, F, halved, peak)

    # on intervals: where tangents of I along A meet A = 0, and A Omega by I
    text = "I_0 - A I_0A: friction acts throughout."
    of.add("rest_intercept", _intercept(at_rest), text, "from (19)", "A > 0")
    of.add("released_intercept", _intercept(released), f"The same {only}", "from (19)", beyond)
    of_I = sp.expand(value - A * by_A(value)).subs(I_0, level + A * I_0A)
    of.add("sine_intercept", of_I, "I - A I_A, by that of I_0.", "from (23)", quadrant)
    of_I = sp.expand((of_I.subs(d_3, 0) / Omega**2).subs(Omega, 1 / x))
    text = "The same over Omega^2, at x = 1/Omega."
    of.add("sine_intercept_far", of_I, text, "from (23)", "x >= 0, A > 0")
    of.add(
        "I_AA_far",
        sp.expand((of.I_AA.subs(d_3, 0) / Omega**2).subs(Omega, 1 / x)),
        "d2I/dA2 over it.",
        "(23)",
        "x >= 0, A > 0",
    )
    of.add("R_of_peak_by_rest", R - peak, "R where F_Omega = 0, by I at Omega = 0.", "from (24)")

    @of.kernel("from (23)", "I >= I_0", arguments=(I, I_0, zeta, d))
    def velocity() -> Lets:
        """A Omega by I; no less than it where cubic damping dissipates too."""
        v = sp.Symbol("v", nonnegative=True)
        balance = sp.Poly(sp.expand(lower.subs(Omega, v / A)) - I, v)
        found = _root(balance)
        claim(
            "stable form of the root `A Omega` of `I = I_0 + 2 zeta A Omega + d (A Omega)^2`",
            balance.as_expr().subs(v, found),
        )
        return Lets((), sp.simplify(found))

    # how answers move with the parameters is had from these too
    of.R, of.phase, of.transmissibility = flow.R, flow.phase, flow.transmissibility
    of.F_AAA, of.F_AAOmega = derivatives[DERIVATIVES[3, 0]], sp.factor_terms(by_amplitude(F_AOmega))
    of.by_parameter = dict(
        zip(
            (h, h_A, h_AA, *REST[:3], *VISCOUS[:3], d, d_3),
            (h_p, h_Ap, h_AAp, I_0p, I_0Ap, I_0AAp, zeta_p, zeta_Ap, zeta_AAp, d_p, d_3p),
            strict=True,
        )
    )
    of.rises = {symbol: rise for of_one in (REST, VISCOUS) for symbol, rise in pairwise(of_one)}
    return of


def _intercept(rest: tuple[sp.Expr, ...]) -> sp.Expr:
    return sp.expand(rest[0] - A * rest[1])


def _root(balance: sp.Poly) -> sp.Expr:
    """The positive root of a quadratic whose constant alone is negative, in the form in which nothing cancels."""
    constant, linear, second = (balance.coeff_monomial(balance.gen**power) for power in range(3))
    return -2 * constant / (linear + sp.sqrt(linear**2 - 4 * second * constant))


def _searched(of: Formulas, of_R: sp.Expr, value: sp.Expr, F: sp.Expr, halved: sp.Expr, peak: sp.Expr) -> None:
    """Systems of two functions, in R, I and their slopes R_A, I_A along A at a given Omega.

    `by_R`: A and R are the unknowns, Omega^2 = (R - h)/A, in which nothing cancels where R is small; `by_Omega`: A and
    Omega are. `far`: of an excitation by inertia, all over Omega^2, x = 1/Omega, x^2 = (R - A)/h. By implicit
    differentiation: on a line of constant R the frequency moves by -R_A/R_w along A.
    """
    for w in (Omega, x):

        def at(whole: sp.Expr, w: sp.Symbol = w) -> sp.Expr:
            lower = whole.subs(d_3, 0)
            return whole if w == Omega else sp.expand(sp.expand(lower / Omega**2).subs(Omega, 1 / x))

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
            of_Omega: sp.Expr,
            of_R: sp.Expr,
            by: sp.Expr,
            known: Sequence[dict[sp.Symbol, sp.Expr]] = (rises, by_frequency),
            w: sp.Symbol = w,
        ) -> sp.Expr:
            """Where the frequency changes by `of_Omega`, R by `of_R` and A by `by`."""
            found = sp.diff(expression, w) * of_Omega + sp.diff(expression, R) * of_R + by_A(expression) * by
            for symbol in (I, R_A, I_A):
                found += sp.diff(expression, symbol) * (known[0][symbol] * by + known[1][symbol] * of_Omega)
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
                doc, equation = SEARCHED[system]
                over = " of an excitation by inertia, over powers of Omega, x = 1/Omega" if w == x else ""
                unknown = named.removeprefix("by_")
                # the same arguments for all, so that the search has them in a table
                of.add(
                    f"{system}_{'far_' if w == x else ''}{named}",
                    Lets((), (*values, *slopes)),
                    f"{doc}{over}; derivatives by A and by {unknown} of the first, then of the second.",
                    equation,
                    arguments=[w, *KNOWN, R, I, R_A, I_A],
                )


def _far_by_inertia(R: sp.Expr, I: sp.Expr, F: sp.Expr, least: sp.Expr) -> tuple[sp.Expr, ...]:
    """The first as squares, of which nothing cancels but F_0^2."""
    at_x = {Omega: 1 / x}
    of_least = sp.expand(sp.expand(least).subs(at_x) * x**2)
    grows = of_least.coeff(x, -1)
    stays = sp.expand(of_least - grows / x)
    if grows != zeta * d * A**3 or sp.Poly(stays, x).degree() != 2:
        raise ArithmeticError(f"what vanishes where a level is least: {of_least}")
    whole = sum(sp.expand(one.subs(at_x) * x**2) ** 2 for one in (R, I)) - F_0**2
    claim("`F/Omega^4` as a sum of squares less `F_0^2`", whole - F.subs(at_x) * x**4)
    claim(
        "`F/Omega^4` tends to `A^2 + d^2 A^4 - F_0^2` as `Omega` grows",
        whole.subs(x, 0) - (A**2 + d**2 * A**4 - F_0**2),
    )
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
        claim("`R/Omega^2` where the forcing of an amplitude is stationary", scaled.subs(Omega, 1 / x).subs(r, one))
    return square, lower, higher


def _full(F: sp.Expr) -> sp.Expr:
    """The positive amplitude at which F/Omega^4 vanishes as Omega grows, in the form that stays for d = 0."""
    X = sp.Symbol("X", nonnegative=True)
    leading = sp.Poly(sp.expand(F), Omega).coeff_monomial(Omega**4).subs(A, sp.sqrt(X))
    found = 2 * F_0**2 / (1 + sp.sqrt(1 + 4 * d**2 * F_0**2))
    claim("root `A^2` of this limit", leading.subs(X, found))
    return sp.sqrt(found)


def _coefficients(expression: sp.Expr) -> tuple[sp.Expr, ...]:
    """By power of Omega, after a check of the signs that bound the number of roots."""
    polynomial = sp.Poly(sp.expand(expression), Omega)
    found = [polynomial.coeff_monomial(Omega**power) for power in range(7)]
    if polynomial.degree() != 6:
        raise ArithmeticError(f"not of degree 6 in Omega: {expression}")
    for power in (1, 3, 4, 5, 6):
        # (A I_0)_A is not negative for each law by itself, see `_trace`
        named = sp.expand(found[power]).subs(I_0A, (sp.Symbol("rise", nonnegative=True) - I_0) / A)
        positive = named.subs(I_0, sp.Symbol("I_0", nonnegative=True))
        if any(term.could_extract_minus_sign() for term in sp.Add.make_args(sp.expand(positive))):
            raise ArithmeticError(f"the coefficient of Omega^{power} may be negative: {found[power]}")
    return tuple(sp.collect(one, (h, h_A, A)) for one in found)


def _trace(averaged: Averaged, flow: Formulas, value: sp.Expr) -> sp.Expr:
    """(A I)_A, from the trace of the slow flow's Jacobian at a fixed point."""
    A_rate, A_phi_rate = (
        sp.expand(rate.subs({sigma: Omega**2 - 1, averaged_force: h + A, mu: sp.pi * m / 4}))
        for rate in averaged.slow_flow
    )
    # the dissipation of the amplitude's equation, by the law that it has there
    own = sp.expand(flow.I)
    A_rate = sp.expand(A_rate + (own - value) / (2 * Omega))
    claim(
        "slow flow of the amplitude: `-2 Omega A' = F_0 sin(phi) + I`", -2 * Omega * A_rate - F_0 * sp.sin(phi) - value
    )
    whole = by_A(A_rate) + sp.diff(A_phi_rate / A, phi)
    at_fixed_point = sp.expand(whole).subs(F_0 * sp.sin(phi), -value)
    rise = by_A(A * value)
    claim("trace of the Jacobian at a fixed point: `-(A I)_A/(2 A Omega)`", -2 * A * Omega * at_fixed_point - rise)
    return sp.collect(sp.expand(rise), (A, Omega))
