"""Step 1 once more, equation (3) as it is followed in time: friction's hold, the acceleration, and their derivatives.

In:  the equation of motion (1), the dimensionless groups (4); the whole restoring force stays an open f = u + F_k(u).
Out: `Motion`: expressions in v = u', f, its slope f_u, friction mu sign(u'), and cosine, sine of theta = Omega tau;
     `Smoothed`: (A1), (A2), the same equation with tanh for the sign and logistic steps for the piece's end.

The cosine is a name because each kind of number has its own function for it.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy.codegen.cfunctions import hypot

from ..paper.equation_of_motion import F, F_c, c, cos_forcing, groups, scaled_motion, sign_u_dot, u_ddot, u_dot
from ..symbols import F_0, A, Omega, eta, mu, phi, u, zeta

Let = tuple[sp.Symbol, sp.Expr]

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


@dataclass(frozen=True)
class Motion:
    """(3); primes by tau in the first four, by theta in the rest.

    equation     -- what vanishes, in u'' and the symbols of this module
    push         -- what friction has to hold at rest
    cosine       -- cos theta at which the mass breaks away against that friction
    acceleration -- u'' of a slipping mass
    resistance   -- mu sign(u') + c_2 |u'|u' in one direction of slip, for friction, and the zeta by which rates depend
                    on u'
    transmissibility -- fundamental harmonic of what spring, damper and friction pass on, over F_0, in its let: that of
                    inertia, likewise
    push_slopes  -- of the push by theta, u, F_0
    rates        -- u', v' by theta
    by_state     -- derivatives of the rates by u, v: row by row
    stopping     -- friction over the largest force of inertia of A cos theta, in its let
    structural   -- the zeta whose damper is (eta/Omega) u', and its slope by Omega
    by_parameter -- by Omega, F_0, zeta, friction and f, which any parameter of the force enters by: row by row
    """

    equation: sp.Expr
    push: sp.Expr
    cosine: sp.Expr
    acceleration: sp.Expr
    resistance: tuple[sp.Expr, sp.Expr]
    transmissibility_lets: tuple[Let, ...]
    transmissibility: sp.Expr
    push_slopes: tuple[sp.Expr, ...]
    stopping_lets: tuple[Let, ...]
    stopping: sp.Expr
    structural: tuple[sp.Expr, sp.Expr]
    rates: tuple[sp.Expr, ...]
    by_state: tuple[sp.Expr, ...]
    by_parameter: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Smoothed:
    """(A1); primes by tau.

    lets     -- Phi_2, the weight of the inner piece, and its slope by u
    rates    -- u', v'
    by_state -- derivatives of the rates by u, v: row by row
    """

    lets: tuple[Let, ...]
    rates: tuple[sp.Expr, ...]
    by_state: tuple[sp.Expr, ...]


def equation_of_motion() -> sp.Expr:
    """(3) from (1) and (4): what vanishes."""
    k_v, length = sp.symbols("k_v L", positive=True)
    scaled = scaled_motion(k_v, length)
    definitions = groups(k_v, length)
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


def _resistance(rates: tuple[sp.Expr, ...]) -> tuple[sp.Expr, sp.Expr]:
    """What stands for friction in (3) while the mass slips one way, and the zeta by which its rates depend on u'."""
    resists = friction + quadratic * v**2
    damps = zeta + sp.diff(resists, v) / 2
    for rate in rates:
        whole = sp.diff(rate.subs(friction, resists), v) - _by(rate, v).subs(zeta, damps)
        if sp.expand(whole) != 0:
            raise ArithmeticError(f"the slope of the rates by u': {whole} is not zero")
    return resists, damps


def _check_linear(acceleration: sp.Expr) -> None:
    """In all that depends on time, so that it gives each coefficient of its Taylor series from theirs."""
    varies = (cosine, v, f, friction)
    if sp.Poly(acceleration, *varies).total_degree() != 1 or acceleration.subs(dict.fromkeys(varies, 0)) != 0:
        raise ArithmeticError(f"not linear in what depends on time: {acceleration}")


def _transmissibility(equation: sp.Expr) -> tuple[tuple[Let, ...], sp.Expr]:
    """Of u whose first harmonic is A_1 cos(theta + phi): what is passed on is the force less that of inertia."""
    passed = -equation.subs({f: 0, v: 0, friction: 0})
    if passed.free_symbols != {F_0, cosine, u_ddot}:
        raise ArithmeticError(f"what is passed on depends on more than force and acceleration: {passed}")
    # as complex amplitudes
    of_inertia = sp.Symbol("of_inertia", real=True)
    parts = ((1, sp.cos), (0, sp.sin))
    both = (sp.expand(passed.subs({cosine: a, u_ddot: -F_0 * of_inertia * b(phi)}) / F_0) for a, b in parts)
    return ((of_inertia, Omega**2 * A_1 / F_0),), hypot(*both)


def _stopping() -> tuple[tuple[Let, ...], sp.Expr]:
    """Near a turning point friction stops the mass the longer, the more of the force of inertia it is."""
    turn = sp.Symbol("turn", positive=True)
    largest = -(Omega**2) * sp.diff(A * sp.cos(theta), theta, 2).subs(theta, 0)
    return ((turn, Omega**2),), mu / largest.subs(Omega, sp.sqrt(turn))


def _structural(equation: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Of what (3) has for zeta, and how that goes with Omega along a curve."""
    damper = equation - equation.subs(zeta, 0)
    (found,) = sp.solve(damper - eta / Omega * v, zeta)
    return found, sp.diff(found, Omega)


def motion() -> Motion:
    """All of it."""
    equation = equation_of_motion()
    acceleration = sp.solve(equation, u_ddot)[0]
    _check_linear(acceleration)
    # at rest the acceleration is zero too: friction is what keeps it so
    push = sp.solve(equation.subs({u_ddot: 0, v: 0}), friction)[0]
    rates = (v / Omega, acceleration / Omega)
    transmissibility_lets, transmissibility = _transmissibility(equation)
    stopping_lets, stopping = _stopping()
    return Motion(
        equation=equation,
        push=push,
        cosine=sp.solve(push - friction, cosine)[0],
        acceleration=acceleration,
        resistance=_resistance(rates),
        transmissibility_lets=transmissibility_lets,
        transmissibility=transmissibility,
        stopping_lets=stopping_lets,
        stopping=stopping,
        structural=_structural(equation),
        push_slopes=tuple(_by(push, symbol) for symbol in (theta, u, F_0)),
        rates=rates,
        by_state=tuple(_by(rate, symbol) for rate in rates for symbol in (u, v)),
        by_parameter=tuple(_by(rate, symbol) for rate in rates for symbol in (Omega, F_0, zeta, friction, f)),
    )


def smoothed(sharp: Motion) -> Smoothed:
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
    acceleration = sharp.acceleration.subs({f: force, friction: mu * slip})
    along_u = {inner: inner_u, outer: outer_u, weight: weight_u}
    weight_slope = sum(sp.diff(phi_2, step) * value for step, value in slopes.items())
    by_u = sum(sp.diff(force, name) * value for name, value in along_u.items()) * sp.diff(sharp.acceleration, f)
    by_v = sp.diff(acceleration, v) + sp.diff(acceleration, slip) * of_slip
    return Smoothed(
        lets=((weight, phi_2), (weight_u, sp.factor(weight_slope).subs(phi_2, weight))),
        rates=(v, acceleration),
        by_state=(sp.Integer(0), sp.Integer(1), by_u, by_v),
    )
