"""Step 1 once more, equation (3) as it is followed in time: friction's hold, the acceleration, and their derivatives.

In:  the equation of motion (1), the dimensionless groups (4); the whole restoring force stays an open f = u + F_k(u).
Out: `Formulas` in v = u', f, its slope f_u, friction mu sign(u'), and cosine, sine of theta = Omega tau; of (A1), (A2)
     too, the same equation with tanh for the sign and logistic steps for the piece's end.

The cosine is a name because each kind of number has its own function for it.
"""

from __future__ import annotations

import sympy as sp
from sympy.codegen.cfunctions import hypot

from ..claims import claim
from ..kernels import Formulas, Lets
from ..mechanisms import L, k_v
from ..paper.equation_of_motion import F, F_c, c, cos_forcing, groups, scaled_motion, sign_u_dot, u_ddot, u_dot
from ..symbols import F_0, A, Omega, c_3, eta, mu, phi, u, zeta, zeta_2

theta, v = sp.symbols("theta v", real=True)
cosine, sine = sp.symbols("cosine sine", real=True)
# the whole restoring force u + F_k(u) and its slope; mu sign(u')
f, f_u, friction = sp.symbols("f f_u friction", real=True)

#: c_2 times the sign of u'
quadratic = sp.Symbol("quadratic", real=True)
#: amplitude of the displacement's first harmonic
A_1 = sp.Symbol("A_1", real=True)

# (A2): sharpness; the logistic steps at -u_cr and at u_cr, and tanh(nu u'); the pieces of the force and their slopes
nu = sp.Symbol("nu", positive=True)
left, right, slip = sp.symbols("left right slip", real=True)
inner, outer, inner_u, outer_u = sp.symbols("inner outer inner_u outer_u", real=True)
weight, weight_u = sp.symbols("weight weight_u", real=True)
u_cr = sp.Symbol("u_cr", positive=True)


#: of arguments
ORDER = (
    *(cosine, sine, v, Omega, A_1, A, eta, F_0, phi, mu, zeta, f_u, friction, nu, f, quadratic, c_3, zeta_2, u),
    *(left, right, slip, inner, outer, inner_u, outer_u),
)


def equation_of_motion() -> sp.Expr:
    """(3) from (1) and (4): what vanishes."""
    scaled, definitions = scaled_motion(k_v, L), groups(k_v, L)
    named = ((zeta, c), (mu, F_c), (F_0, F))
    letters = {letter: sp.solve(definitions[group] - group, letter)[0] for group, letter in named}
    # (1) is what F_k adds to zero
    motion = sp.expand(sp.expand(scaled.subs(letters)) + f - u).subs({cos_forcing: cosine, u_dot: v})
    friction_share = motion.coeff(sign_u_dot) * sign_u_dot
    motion = motion - friction_share + friction
    if friction_share != mu * sign_u_dot or motion.free_symbols != {u_ddot, v, f, friction, cosine, F_0, zeta}:
        raise ArithmeticError(f"(3) is not dimensionless: {motion} with friction {friction_share}")
    return motion


def _by(expression: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """The derivative along theta (in the cosine), u (in f) or any other symbol."""
    through = {theta: (cosine, -sine), u: (f, f_u)}
    inner_symbol, factor = through.get(symbol, (symbol, sp.Integer(1)))
    return sp.diff(expression, inner_symbol) * factor


def _check_linear(acceleration: sp.Expr) -> None:
    """In all that depends on time, so that it gives each coefficient of its Taylor series from theirs."""
    varies = (cosine, v, f, friction)
    if sp.Poly(acceleration, *varies).total_degree() != 1 or acceleration.subs(dict.fromkeys(varies, 0)) != 0:
        raise ArithmeticError(f"not linear in what depends on time: {acceleration}")


def motion() -> Formulas:
    """(3) in v = u' and the whole restoring force and its slope, f and f_u."""
    of = Formulas(ORDER, domain="any")
    equation = equation_of_motion()
    (acceleration,) = sp.solve(equation, u_ddot)
    _check_linear(acceleration)
    # at rest the acceleration is zero too: friction is what keeps it so
    (push,) = sp.solve(equation.subs({u_ddot: 0, v: 0}), friction)
    rates = (v / Omega, acceleration / Omega)
    of.add("push", push, "What friction has to hold at rest; cosine of theta = Omega tau.", "(3)")
    by_each = tuple(_by(push, symbol) for symbol in (theta, u, F_0))
    of.add("push_slopes", by_each, "Derivatives of the push by theta, u, F_0.", "(3)")
    text = "The cosine of theta at which a mass at rest breaks away against friction mu or -mu."
    of.add("breakaway", sp.solve(push - friction, cosine)[0], text, "(3)", "F_0 > 0")
    of.add("acceleration", acceleration, "u'' of a slipping mass; friction is mu sign(u').", "(3)")

    @of.kernel("(3)")
    def resistance() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        """Friction, quadratic damping, both times the sign of u', and the others; zeta by the slope of all by u'; and
        what the slope by u adds to f_u.
        """
        resists = friction + quadratic * v**2 + c_3 * v**3 + 2 * zeta_2 * u**2 * v
        damps, stiffens = zeta + sp.diff(resists, v) / 2, sp.diff(resists, u)
        for rate in rates:
            of_all = rate.subs(friction, resists)
            for by, known in ((v, {zeta: damps}), (u, {f_u: f_u + stiffens})):
                whole = sp.diff(of_all, by) + sp.diff(rate, f) * (f_u if by == u else 0) - _by(rate, by).subs(known)
                claim("derivatives of the power-series rates by `u` and `u'` with every damping law", whole)
        return resists, damps, stiffens

    @of.kernel("(3)", "F_0 > 0")
    def transmissibility() -> Lets:
        """Fundamental harmonic of what is passed on over F_0, where that of u is A_1 cos(theta + phi).

        What is passed on is the force less that of inertia, as complex amplitudes.
        """
        passed = -equation.subs({f: 0, v: 0, friction: 0})
        if passed.free_symbols != {F_0, cosine, u_ddot}:
            raise ArithmeticError(f"what is passed on depends on more than force and acceleration: {passed}")
        of_inertia = sp.Symbol("of_inertia", real=True)
        components = ((1, sp.cos), (0, sp.sin))
        both = (sp.expand(passed.subs({cosine: a, u_ddot: -F_0 * of_inertia * b(phi)}) / F_0) for a, b in components)
        return Lets([(of_inertia, Omega**2 * A_1 / F_0)], hypot(*both))

    @of.kernel("(3)", "Omega > 0, A > 0")
    def stopping() -> Lets:
        """Friction over the largest force of inertia of A cos(theta), by which the mass stops within the cycle.

        Near a turning point friction stops the mass the longer, the more of the force of inertia it is.
        """
        turn = sp.Symbol("turn", positive=True)
        largest = -(Omega**2) * sp.diff(A * sp.cos(theta), theta, 2).subs(theta, 0)
        return Lets([(turn, Omega**2)], mu / largest.subs(Omega, sp.sqrt(turn)))

    @of.kernel("beside (3)", "Omega > 0")
    def structural() -> tuple[sp.Expr, sp.Expr]:
        """The zeta of structural damping at one frequency, and its slope by Omega."""
        damper = equation - equation.subs(zeta, 0)
        (found,) = sp.solve(damper - eta / Omega * v, zeta)
        return found, sp.diff(found, Omega)

    of.add("rates", rates, "u and v by theta.", "(3)", "Omega > 0")
    by_state = tuple(_by(rate, symbol) for rate in rates for symbol in (u, v))
    text = "Derivatives of the rates by u, v: of the first, then of the second."
    of.add("rates_by_state", by_state, text, "(3)", "Omega > 0")
    by_parameter = tuple(_by(rate, symbol) for rate in rates for symbol in (Omega, F_0, zeta, friction, f))
    text = "Derivatives of the rates by Omega, F_0, zeta, friction, f: of the first, then of the second."
    of.add("rates_by_parameter", by_parameter, text, "(3)", "Omega > 0")
    _smoothed(of)
    return of


def _smoothed(of: Formulas) -> None:
    """(A1), (A2) in the values of tanh and of the logistic steps."""
    steps = {left: 1 / (1 + sp.exp(-nu * (u + u_cr))), right: 1 / (1 + sp.exp(-nu * (u - u_cr)))}
    slopes = {step: nu * step * (1 - step) for step in steps}
    for step, value in steps.items():
        if sp.simplify(sp.diff(value, u) - slopes[step].subs(step, value)) != 0:
            raise ArithmeticError(f"the slope of a logistic step is not {slopes[step]}")
    tanh, of_slip = sp.tanh(nu * v), nu * (1 - slip**2)
    if sp.expand(sp.diff(tanh, v) - of_slip.subs(slip, tanh)) != 0:
        raise ArithmeticError(f"the slope of tanh is not {of_slip}")
    # the inner piece holds between the steps, the outer one beyond
    phi_2 = left - right
    force = outer + weight * (inner - outer)
    acceleration = of.acceleration.subs({f: force, friction: mu * slip})
    along_u = {inner: inner_u, outer: outer_u, weight: weight_u}
    weight_slope = sum(sp.diff(phi_2, step) * value for step, value in slopes.items())
    by_u = sum(sp.diff(force, name) * value for name, value in along_u.items()) * sp.diff(of.acceleration, f)
    by_v = sp.diff(acceleration, v) + sp.diff(acceleration, slip) * of_slip
    lets = ((weight, phi_2), (weight_u, sp.factor(weight_slope).subs(phi_2, weight)))
    text = "u and v by tau, smoothed: slip = tanh(nu v), left and right are logistic functions of nu (u +- u_cr)."
    of.add("smoothed", Lets(lets[:1], (v, acceleration)), text, "(A1), (A2)")
    by_state = (sp.Integer(0), sp.Integer(1), by_u, by_v)
    text = "Derivatives of these rates by u, v: of the first, then of the second."
    of.add("smoothed_by_state", Lets(lets, by_state), text, "(A1), (A2)")
