"""Step 1, equations (1)-(7): the equation of motion made dimensionless, the force's Taylor polynomial, its breakpoints.

In:  a `Mechanism`.
Out: `Dimensionless`: the equation of motion without dimensions, the exact pieces of the force, the pieces to average
     in named coefficients (polynomials, unless the force is not to be truncated), and those coefficients and
     breakpoints in the mechanism's dimensionless ratios.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..claims import claim
from ..mechanisms import Mechanism
from ..symbols import F_0, Omega, mu, u, zeta
from ..vanishing import vanishes

# the letters of (1), dimensional
m, c, F_c, F, omega, t, omega_n = sp.symbols("m c F_c F omega t omega_n", positive=True)
# u', u'' and sign(u') as plain symbols: the equation of motion is linear in them
u_dot, u_ddot, sign_u_dot, cos_forcing = sp.symbols("u_dot u_ddot sign_u_dot cos_forcing", real=True)


@dataclass(frozen=True)
class Dimensionless:
    """Dimensionless oscillator u'' + 2 zeta u' + u + mu sign(u') + F_k(u) = F_0 cos(Omega tau)."""

    mechanism: Mechanism  #: where it comes from
    groups: dict[sp.Symbol, sp.Expr]  #: the dimensionless groups by their definitions (4)
    exact: tuple[sp.Expr, ...]  #: F_k(u) of each piece, untruncated (5)
    exact_ends: tuple[sp.Expr, ...]  #: |u| at which each piece but the last ends, in the ratios (5)
    #: u + F_k(u) of each piece in named coefficients: a polynomial (6), or all of it where `order` is oo
    polynomials: tuple[sp.Expr, ...]
    definitions: dict[sp.Symbol, sp.Expr]  #: those coefficients and breakpoints in the ratios (7)

    @property
    def breakpoints(self) -> dict[sp.Symbol, sp.Expr]:
        """The breakpoints in the parameters of the kernels, one of which each may be itself."""
        if not self.mechanism.instead:
            return {name: name for name in self.mechanism.breakpoints}
        # one root of 2 x - x^2 rounds less than the product of the roots of x and 2 - x, and doubles of A lie near it
        return {name: sp.sqrt(sp.expand(self.definitions[name] ** 2)) for name in self.mechanism.breakpoints}


def equation_of_motion(k_v: sp.Expr, x: sp.Expr, x_dot: sp.Expr, x_ddot: sp.Expr) -> sp.Expr:
    """(1): what F_k(x) adds to zero; sign(x') and cos(omega t) as symbols."""
    return m * x_ddot + c * x_dot + k_v * x + F_c * sign_u_dot - F * cos_forcing


def scaled_motion(k_v: sp.Expr, length: sp.Expr) -> sp.Expr:
    """(1) with x = L u and d/dt = omega_n d/dtau, over k_v L: what F_k/(k_v L) adds to zero."""
    natural = sp.sqrt(k_v / m)
    motion = equation_of_motion(k_v, length * u, length * natural * u_dot, length * natural**2 * u_ddot)
    scaled = sp.expand(motion / (k_v * length))
    claim("the coefficient of `u''` is 1 after the scaling", scaled.coeff(u_ddot), sp.S.One, eq="(3)")
    claim("the coefficient of `u` is 1 after the scaling", scaled.coeff(u), sp.S.One, eq="(3)")
    return scaled


def groups(k_v: sp.Expr, length: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
    """(4): the dimensionless groups of every mechanism, read off the scaled motion's coefficients."""
    scaled = scaled_motion(k_v, length)
    return {
        omega_n: sp.sqrt(k_v / m),
        Omega: omega / omega_n,
        zeta: sp.powdenest(scaled.coeff(u_dot) / 2, force=True),
        mu: scaled.coeff(sign_u_dot),
        F_0: -scaled.coeff(cos_forcing),
    }


def dimensionless_groups(mechanism: Mechanism) -> dict[sp.Symbol, sp.Expr]:
    """(4): those of every mechanism, and its own ratios."""
    return groups(mechanism.k_v, mechanism.length) | mechanism.ratios


def dimensionless_force(mechanism: Mechanism, dimensional: sp.Expr) -> sp.Expr:
    """(5): F_k(L u)/(k_v L) in the mechanism's ratios."""
    length = mechanism.length
    ratio = dimensional.subs(mechanism.x, length * u).subs(mechanism.dimensional) / (mechanism.k_v * length)
    return _without_length(ratio, mechanism)


def _without_length(expression: sp.Expr, mechanism: Mechanism) -> sp.Expr:
    """The expression at length = k_v = 1, after a check that it depends on neither (it is dimensionless)."""
    scales = {mechanism.length: 1, mechanism.k_v: 1}
    for scale in scales if sp.expand(expression).has(*scales) else ():
        changes = sp.diff(expression, scale)
        if not vanishes(changes):
            raise ArithmeticError(f"{mechanism.name}: {expression} still depends on {scale}: it is not dimensionless")
    return expression.subs(scales)


def piece_end(mechanism: Mechanism, until: sp.Expr) -> sp.Expr:
    """(5): the u > 0 at which a piece ends, in the ratios."""
    condition = until.subs(mechanism.x, mechanism.length * u).subs(mechanism.dimensional) / mechanism.length
    roots = _roots(_without_length(condition, mechanism))
    positive = roots if len(roots) == 1 else [root for root in roots if not root.could_extract_minus_sign()]
    if len(positive) != 1:
        raise ArithmeticError(f"{mechanism.name}: a piece must end at one |u|; {condition} vanishes at {roots}")
    # as a product under the root: sqrt(1 - (1 - delta_h)^2) loses every digit for a small preload; a difference of
    # parameters keeps its sign, which tells whether the piece is there
    rooted = sp.sqrt(sp.factor(sp.expand(positive[0] ** 2)))
    return positive[0] if rooted.has(sp.Abs) else rooted


def _roots(condition: sp.Expr) -> list[sp.Expr]:
    """The u at which it vanishes."""
    if condition.is_polynomial(u) and sp.degree(condition, u) == 1:
        slope, constant = sp.Poly(condition, u).all_coeffs()
        return [sp.cancel(-constant / slope)]
    # check=False: SymPy would have to know delta_h < 1 to confirm the root, and drops it otherwise
    return list(sp.solve(condition, u, check=False, simplify=False))


def without_cancellation(force: sp.Expr) -> sp.Expr:
    """The same with sqrt(s) - 1 as (s - 1)/(sqrt(s) + 1), which keeps the digits of a small displacement."""

    def rationalised(total: sp.Expr) -> sp.Expr:
        roots = [term for term in total.args if term.is_Pow and term.exp == sp.Rational(1, 2)]
        if len(roots) != 1 or -1 not in total.args:
            return total
        root = roots[0]
        return total - root + 1 + sp.expand(root.base - 1) / (root + 1)

    return force.replace(lambda part: part.is_Add, rationalised)


def without_poles_that_cancel(force: sp.Expr) -> sp.Expr:
    """The same with quotients that only together vanish at u = 0 as one, which keeps the digits next to rest.

    1/(d - u)^2 - 1/(d + u)^2, as of two magnets, is 4 d u/(d^2 - u^2)^2: where it is odd, u times a function of u^2, of
    which derivatives keep their digits too.
    """
    terms = sp.Add.make_args(force)
    quotients = [one for one in terms if not one.has(u) or (one.is_rational_function(u) and not one.is_polynomial(u))]
    together = sp.Add(*quotients)
    expanded = [part for one in quotients for part in sp.Add.make_args(sp.expand(one))]
    if together.subs(u, 0).has(sp.zoo, sp.nan) or all(part.subs(u, 0) == 0 for part in expanded):
        return force
    over, square = sp.cancel(together / u), sp.Dummy("square")
    if over.subs(u, 0).has(sp.zoo, sp.nan):
        return force  # a preload
    halves = [sp.Poly(one, u) for one in sp.fraction(over)]
    if any(power % 2 for half in halves for (power,) in half.monoms()):
        whole = u * sp.factor(over)
    else:
        in_square = [sum(value * square ** (power // 2) for (power,), value in half.terms()) for half in halves]
        whole = u * sp.factor(in_square[0] / in_square[1]).subs(square, u**2)
    return whole + sp.Add(*(one for one in terms if one not in quotients))


def taylor_polynomial(force: sp.Expr, order: int) -> dict[int, sp.Expr]:
    """(6), (7): coefficients of F_k(u) by power of u, up to `order`."""
    coefficients: dict[int, sp.Expr] = {}
    derivative = force
    for power in range(order + 1):
        value = sp.expand(derivative.subs(u, 0) / sp.factorial(power))
        if value != 0:
            coefficients[power] = value
        derivative = sp.diff(derivative, u)
    return coefficients


def by_continuity(mechanism: Mechanism, number: int, exact: tuple[sp.Expr, ...], ends: tuple[sp.Expr, ...]) -> None:
    """Proof that a piece of the force begins where the one below it ends, both being polynomials of no higher order."""
    below, above = exact[number - 1 : number + 1]
    if not all(force.is_polynomial(u) and sp.degree(force, u) <= mechanism.order for force in (below, above)):
        raise ArithmeticError(f"{mechanism.name}: the constant in piece {number + 1} of a truncated force needs a name")
    if not vanishes((below - above).subs(u, ends[number - 1])):
        raise ArithmeticError(
            f"{mechanism.name}: the force jumps where piece {number} ends; power 0 of the next piece needs a name"
        )


def untruncated(mechanism: Mechanism, force: sp.Expr, names: dict[int, sp.Symbol]) -> tuple[sp.Expr, dict]:
    """u + F_k(u) in the names of its first two coefficients, and their definitions, for F_k = u (a + b/sqrt(1 - u^2)).

    (5) has this form: a spring's force that turns with a rod of length 1.
    """
    root = sp.sqrt(1 - u**2)
    constant, inverse = sp.symbols("constant inverse")
    ratio = sp.expand(sp.expand(1 + force / u).subs(root, 1 / inverse))
    if ratio.has(u) or sp.degree(ratio, inverse) != 1 or set(names) != {1, 3}:
        raise ArithmeticError(f"{mechanism.name}: {force} is not u (a + b/sqrt(1 - u^2)) with names for powers 1 and 3")
    form = u * (constant + inverse / root)
    taylor = taylor_polynomial(form, 3)
    in_names = sp.solve([taylor[power] - name for power, name in names.items()], [constant, inverse])
    coefficients = {constant: ratio.coeff(inverse, 0), inverse: ratio.coeff(inverse, 1)}
    definitions = {name: sp.factor(taylor[power].subs(coefficients)) for power, name in names.items()}
    return form.subs(in_names), definitions


def check_continuous(mechanism: Mechanism) -> None:
    """Proof that an untruncated force does not jump: where a piece ends it is that of the next."""
    root = sp.sqrt(mechanism.length**2 - mechanism.x**2)
    height = sp.Symbol("height", positive=True)
    for piece, following in zip(mechanism.pieces, mechanism.pieces[1:], strict=False):
        jump, until = (e.subs(root, height) for e in (piece.force - following.force, piece.until))
        if any(sp.cancel(jump.subs(height, end)) != 0 for end in sp.solve(until, height, check=False)):
            raise ArithmeticError(f"{mechanism.name}: the force jumps where a piece ends")


def oscillator(mechanism: Mechanism) -> Dimensionless:
    """All of step 1 for one mechanism."""
    exact = tuple(dimensionless_force(mechanism, piece.force) for piece in mechanism.pieces)
    ends = tuple(piece_end(mechanism, piece.until) for piece in mechanism.pieces[:-1])

    definitions: dict[sp.Symbol, sp.Expr] = {}
    polynomials = []
    whole_force = mechanism.order == sp.oo
    if whole_force:
        check_continuous(mechanism)
    for number, (force, names) in enumerate(zip(exact, mechanism.coefficients, strict=True)):
        if whole_force and names:
            piece, named = untruncated(mechanism, force, names)
            polynomials.append(piece)
            definitions |= named
            continue
        if whole_force and force != 0:
            raise ArithmeticError(f"{mechanism.name}: an untruncated force {force} without names")
        taylor = {} if whole_force else taylor_polynomial(force, mechanism.order)
        continuous = number > 0 and 0 in taylor and 0 not in names
        if continuous:
            by_continuity(mechanism, number, exact, ends)
            del taylor[0]
        whole = {power: taylor.get(power, sp.Integer(0)) + (1 if power == 1 else 0) for power in (1, *taylor)}
        unnamed = sorted(set(taylor) - set(names)) if names else sorted(taylor)
        if unnamed:
            raise ArithmeticError(f"{mechanism.name}: powers {unnamed} of u have no named coefficient")
        definitions |= {name: sp.factor(whole[power]) for power, name in names.items()}
        piece = sum((name * u**power for power, name in names.items()), sp.Integer(0)) if names else u
        if continuous:
            # not a parameter of its own: rounding would make the force jump
            piece += sp.expand(polynomials[-1] - piece).subs(u, mechanism.breakpoints[number - 1])
        polynomials.append(piece)
    definitions |= dict(zip(mechanism.breakpoints, ends, strict=True))
    return Dimensionless(mechanism, dimensionless_groups(mechanism), exact, ends, tuple(polynomials), definitions)
