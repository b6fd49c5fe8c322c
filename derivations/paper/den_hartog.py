"""Step 6, equations (35)-(37): the linear oscillator with dry friction alone, exactly over half a cycle (Den Hartog).

In:  the equation of motion at zeta = 0 with F_k = 0.
Out: `DenHartog`: the motion, the amplitude, and the condition that the mass does not stop within the half-cycle;
     `Formulas` of the same for numbers.

Put the time origin at a maximum u = A, u' = 0. Until the next minimum the velocity is negative and friction a constant:

    u'' + u - mu = F_0 cos(Omega tau + phi),     u(pi/Omega) = -A,  u'(pi/Omega) = 0

Four conditions, linear in the two constants of the free motion and in F_0 cos phi, F_0 sin phi.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy.simplify.fu import TR9

from ..claims import claim
from ..kernels import Formulas
from ..symbols import F_0, A, Omega, mu, tau

V, U, S = sp.symbols("V U S", real=True)


@dataclass(frozen=True)
class DenHartog:
    """Exact symmetric motion without stops."""

    response: sp.Expr  #: V(Omega), the response function (37)
    damping: sp.Expr  #: U(Omega), the damping function (37)
    motion: sp.Expr  #: u(tau) on the half-cycle 0 <= tau <= pi/Omega that follows the maximum, in A, mu, U
    amplitude: sp.Expr  #: A in F_0, mu, V, U (35)
    slope_ratio: sp.Expr  #: S is the maximum of this over 0 < tau < pi/Omega (37); in U
    bound: sp.Expr  #: no stop while A exceeds this, in F_0, V, U, S (36)


def den_hartog() -> DenHartog:
    """All of step 6."""
    B, C, p, q, v = sp.symbols("B C p q v", real=True)  # free motion; p = F_0 cos phi, q = F_0 sin phi
    forced = sp.cos(Omega * tau) * p - sp.sin(Omega * tau) * q
    response = sp.solve(sp.diff(v * forced, tau, 2) + v * forced - forced, v)[0]

    motion = mu + V * forced + B * sp.cos(tau) + C * sp.sin(tau)
    velocity = sp.diff(motion, tau)
    half = sp.pi / Omega
    conditions = [
        motion.subs(tau, 0) - A,
        velocity.subs(tau, 0),
        motion.subs(tau, half) + A,
        velocity.subs(tau, half),
    ]
    sine, cosine = sp.symbols("sine cosine", real=True)  # of pi/Omega
    algebraic = [c.subs({sp.sin(half): sine, sp.cos(half): cosine}) for c in conditions]
    solution = sp.solve(algebraic, [B, C, p, q], dict=True)[0]
    on_circle = {sine**2: 1 - cosine**2}
    solution = {key: sp.factor(sp.expand(sp.together(value)).subs(on_circle)) for key, value in solution.items()}
    solution = {key: _reduce(value, sine, cosine) for key, value in solution.items()}

    # U is friction's share of the sine component of the forcing, per unit of mu/V
    damping = sp.cancel(-solution[q] * V / mu)
    named = {B: solution[B], C: sp.cancel(solution[C] / damping) * U, p: solution[p], q: -mu * U / V}
    motion = sp.expand(motion.subs(named))
    # F_0^2 = p^2 + q^2
    A_squared = sp.solve(named[p] ** 2 + named[q] ** 2 - F_0**2, A**2)[0]
    # u' < 0: A exceeds mu/Omega^2 times the ratio below, everywhere in the half-cycle
    velocity = sp.expand(sp.diff(motion, tau))
    friction_share = velocity.coeff(mu)
    ratio = sp.factor_terms(sp.expand(Omega * friction_share)) / sp.sin(Omega * tau)
    claim(
        "the forced part of the velocity is `-A Omega sin(Omega tau)`",
        velocity - mu * friction_share + A * Omega * sp.sin(Omega * tau),
        eq="(37)",
    )
    # at the bound mu = A Omega^2/S; put into (35) and solved for A
    bound_squared = sp.solve(A**2 - A_squared.subs(mu, A * Omega**2 / S), A**2)[0]
    return DenHartog(
        response=response,
        damping=damping.subs({sine: sp.sin(half), cosine: sp.cos(half)}),
        motion=motion,
        amplitude=sp.sqrt(A_squared),
        slope_ratio=ratio,
        bound=sp.sqrt(sp.factor(bound_squared)),
    )


def without_cancellation(exact: DenHartog) -> Formulas:
    """The same functions in forms that keep their digits near resonance and near tau = 0; `exact` is there too.

    There V and U grow as 1/(Omega - 1), and what they multiply vanishes as a difference of nearly equal terms.
    """
    # pi/Omega = pi - 2 theta, where theta vanishes with Omega - 1; sine and cosine of 2 theta by the tangent of theta
    theta = sp.factor(sp.pi / 2 - sp.pi / (2 * Omega))
    double, tangent = sp.symbols("double tangent", real=True)
    turned = exact.damping.subs(sp.pi / Omega, sp.pi - double)
    halved = {sp.sin(double): 2 * tangent / (1 + tangent**2), sp.cos(double): (1 - tangent**2) / (1 + tangent**2)}
    response, damping = sp.factor(exact.response), sp.cancel(turned.subs(halved)).subs(tangent, sp.tan(theta))
    away = "Omega > 0, Omega not 1, 1/3, 1/5 and so on"
    of = Formulas((tau, Omega, A, F_0, mu, S), {V: response, U: damping}, away)
    of.exact = exact
    of.add("V", response, "Response function.", "(37)", "Omega > 0, Omega != 1")
    of.add("U", damping, "Damping function.", "(37)")
    text = "S is the maximum of this over 0 < tau < pi/Omega."
    of.add("S_ratio", _by_detuning(exact.slope_ratio), text, "(37)", f"0 < tau < pi/Omega, {away}")
    amplitude = sp.sqrt(sp.factor(exact.amplitude**2))
    of.add("amplitude", amplitude, "Amplitude of the motion.", "(35)", f"F_0 |V| > mu |U|, {away}")
    of.add("bound", exact.bound, "The motion has no stops while its amplitude exceeds this.", "(36)")
    motion = _by_detuning(exact.motion)
    of.add("motion", motion, "Displacement tau after a maximum.", "from (37)", f"0 <= tau <= pi/Omega, {away}")
    return of


def _by_detuning(expression: sp.Expr) -> sp.Expr:
    """What U multiplies, a wave of Omega tau and one of tau, as a product and a remainder of size Omega - 1."""
    numerator, denominator = sp.fraction(expression)
    numerator = sp.expand(numerator)
    multiplier = numerator.coeff(U)
    slow, fast = sorted(multiplier.atoms(sp.sin, sp.cos), key=lambda wave: wave.has(Omega))
    scale = multiplier.coeff(fast)
    product = TR9(fast - slow).replace(sp.sin, lambda x: sp.sin(sp.factor(x)))
    remainder = sp.factor(multiplier.coeff(slow) / scale + 1) * slow
    return (numerator - sp.expand(U * multiplier) + U * scale * (product + remainder)) / denominator


def _reduce(expression: sp.Expr, sine: sp.Symbol, cosine: sp.Symbol) -> sp.Expr:
    """A rational expression in sine, cosine with sine^2 + cosine^2 = 1, without common factors."""
    numerator, denominator = sp.fraction(sp.together(expression))
    relation = sp.Poly(sine**2 + cosine**2 - 1, sine)
    numerator, denominator = (sp.rem(sp.Poly(part, sine), relation).as_expr() for part in (numerator, denominator))
    return sp.factor(sp.cancel(numerator / denominator))
