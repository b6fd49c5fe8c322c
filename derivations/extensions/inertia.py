"""Steps 1 and 4 once more: excitation by inertia, whose amplitude F_0 stands for a force F_0 Omega^2.

A base that moves by Y cos(omega t) pushes the mass, seen from the base, with m omega^2 Y cos(omega t); a mass m_u that
turns at the radius e with m_u e omega^2 cos(omega t). With u measured from the base and made dimensionless both are
F_0 Omega^2 cos(Omega tau), where F_0 is Y/L or m_u e/(m L).

In:  the dimensionless groups (4) and `SlowFlow` with all damping; the mechanism stays an open h(A).
Out: `Inertia`: what differs from a force. F is R^2 + I^2 - F_0^2 Omega^4, so

    level        R^2 + I^2 = level^2 Omega^4; F_A does not contain it: folds and cusps lie where they lie for a force
    level_slope  Omega^5 dlevel^2/dOmega = Omega G_Omega - 4 G, G = R^2 + I^2: a quadratic in Omega, whose only positive
                 root is the lowest level of an amplitude. The level falls to it from inf at Omega = 0 and rises from it
                 to A, as Omega tends to inf; where the quadratic has no such root it falls to A
    states       so an amplitude below F_0 has one frequency, and one above it two or none
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..claims import claim
from ..mechanisms import EXCITATIONS as stated
from ..paper.equation_of_motion import F, groups, m, omega, omega_n
from ..paper.slow_flow import I, R, SlowFlow, reduction, removed, slope
from ..paper.slow_flow import m as friction
from ..symbols import F_0, A, Omega, h, h_A, h_AA, h_AAA, zeta
from ..systems.along import T, k
from ..systems.slopes import hessian

Let = tuple[sp.Symbol, sp.Expr]

#: displacement of the base; the mass that turns and its radius; the spring and the length that u is measured in
Y, m_u, e, k_v, L = sp.symbols("Y m_u e k_v L", positive=True)
#: what is excited by inertia: the amplitude F_0 of each, and its force
EXCITATIONS = {"base": (Y / L, m * omega**2 * Y), "unbalance": (m_u * e / (m * L), m_u * e * omega**2)}

#: 1/Omega
x = sp.Symbol("x", positive=True)
#: (m + zeta A Omega)/Omega, which is I/Omega less half of its viscous part; its share of h; the root of x^2 + share^2
drag, share, root = sp.symbols("drag share root", real=True)
#: the quadratic 4 rest x^2 + linear x - 4 fall, which the level's slope is Omega^2 times of
fall, linear, rest = sp.symbols("fall linear rest", real=True)
#: F over Omega^4 without its cubic term is square X^2 - 2 falls X + over, X = x^2; what its root is of, which rounding
#: may take below 0
square, falls, over, inner, spread = sp.symbols("square falls over inner spread", real=True)
#: 3 h - A h_A, which a force like A^3 has nothing of
cubic = sp.Symbol("cubic", real=True)
#: the level of a fold without its share of R
of_I = sp.Symbol("of_I", positive=True)
#: slopes of R on the fold locus; what a root is of, which rounding may take below 0
steep, other, part = sp.symbols("steep other part", real=True)
#: a force; what holds a mass at rest; Omega^2
excited, holds = sp.symbols("force holds", nonnegative=True)
turn = sp.Symbol("turn", nonnegative=True)
#: what h/A may at most take from the bound of the level
lost = sp.Symbol("lost", real=True)


@dataclass(frozen=True)
class Inertia:
    """Of any mechanism; outputs beside lets are in these.

    force       -- amplitude of the force
    force_slopes -- its derivatives by Omega and F_0
    amplitude   -- the F_0 of a force at one frequency
    moves_from  -- the Omega from which on the force exceeds what holds a mass at rest, in its let
    isolation   -- the Omega at which the square of what is transmitted is 1 - reduction of what drives, in its lets
    level       -- the F_0 for which (Omega, A) is a steady state, in R and I
    F           -- response, in R and I
    level_slope -- Omega^5 dlevel^2/dOmega, in R and I
    level_bend  -- its derivative by Omega, positive where it vanishes
    Omega_A     -- slope of the response, in R, I and F_A
    outer, outer_beyond -- roots, the larger first, of what is left of F over Omega^4 without its cubic term, which only
                   raises it: a quadratic in X = x^2; where it falls at X = 0, and where it does not
    outer_falls -- not positive where it falls
    terms, least -- fall, linear, rest; and the x at which an amplitude's level is least in these, for fall > 0
    least_Omega_A -- dOmega/dA there, along these
    peak        -- level there less F_0, and its slope along A: R follows from I, and nothing cancels
    isola       -- what that slope vanishes with, and its own slope along A
    isola_apart -- the same by k and `cubic`: of h like A^3, as it is far out, large terms cancel in the other form
    fold_slopes -- T = dR/dA on the fold locus, where F_A vanishes, by k, the larger of two first, and -R/I with that;
                   without h, which may be all rounding
    fold_force  -- the F_0 of a force there, by the T that is not its own
    fold_level  -- the level there, by the T that is not its own
    peak_share  -- -R/I where the level is least, without h
    Omega_of_share -- the frequency of a level with an -R/I
    level_rise, cusp_bend -- along the fold locus, as in `Slopes`
    hessian     -- as there, at an isola point, in its lets
    bound       -- 4 zeta^2 A^2 (1 - lost) - F_0^2 |h|/A and three derivatives, each times powers of A: while it is
                   positive no state above F_0 has the amplitude A if zeta^2 A is at most lost |h|
    share       -- that of |h| which zeta^2 A is, for h < 0, in its let
    """

    force: sp.Expr
    force_slopes: tuple[sp.Expr, ...]
    amplitude: sp.Expr
    moves_from_lets: tuple[Let, ...]
    moves_from: sp.Expr
    isolation_lets: tuple[Let, ...]
    isolation: sp.Expr
    level: sp.Expr
    F: sp.Expr
    level_slope: sp.Expr
    level_bend: sp.Expr
    Omega_A: sp.Expr
    outer_lets: tuple[Let, ...]
    outer: tuple[sp.Expr, ...]
    outer_beyond: tuple[sp.Expr, ...]
    outer_falls: sp.Expr
    terms: tuple[sp.Expr, ...]
    least: sp.Expr
    least_Omega_A: sp.Expr
    peak_lets: tuple[Let, ...]
    peak: tuple[sp.Expr, ...]
    isola_lets: tuple[Let, ...]
    isola: tuple[sp.Expr, ...]
    isola_apart: sp.Expr
    fold_slopes_lets: tuple[Let, ...]
    fold_slopes: tuple[sp.Expr, ...]
    fold_force: sp.Expr
    fold_level: sp.Expr
    peak_share_lets: tuple[Let, ...]
    peak_share: sp.Expr
    Omega_of_share_lets: tuple[Let, ...]
    Omega_of_share: sp.Expr
    level_rise: sp.Expr
    cusp_bend: sp.Expr
    hessian_lets: tuple[Let, ...]
    hessian: sp.Expr
    bound: tuple[sp.Expr, ...]
    share_lets: tuple[Let, ...]
    share: sp.Expr


def amplitude_of(name: str) -> sp.Expr:
    """The group that F_0 is for an excitation, after a check that its force is F_0 Omega^2 in the sense of (4)."""
    amplitude, dimensional = EXCITATIONS[name]
    of_every = groups(k_v, L)
    force = of_every[F_0].subs(F, dimensional)
    claim(f"the force of {name}", force - amplitude * (of_every[Omega].subs(omega_n, of_every[omega_n])) ** 2)
    return amplitude


def inertia(flow: SlowFlow) -> Inertia:
    """All of it."""
    if {"force", *EXCITATIONS} != set(stated):
        raise ValueError(f"the excitations stated are {list(stated)}, those derived {list(EXCITATIONS)} beside a force")
    for name in EXCITATIONS:
        amplitude_of(name)
    force = F_0 * Omega**2
    whole = {R: flow.R, I: flow.I}
    G = sp.expand((flow.F + F_0**2).subs(whole))
    F_value = flow.F.subs(F_0, force)
    level = sp.sqrt(R**2 + I**2) / Omega**2
    claim("F at the level", F_value.subs(F_0, level))
    of_level = sp.expand(Omega * sp.diff(G, Omega) - 4 * G)
    claim("the slope of the level", Omega**5 * sp.diff(G / Omega**4, Omega) - of_level)
    # without what cancels between G and the derivative
    slope_of_level = -4 * (h * R + I * (friction + zeta * A * Omega))
    claim("the slope of the level in R and I", slope_of_level.subs(whole) - of_level)
    bend = sp.factor_terms(sp.diff(of_level, Omega))
    quadratic = sp.Poly(of_level, Omega)
    if quadratic.degree() != 2 or sp.expand(G).coeff(Omega, 3) != 0:
        raise ArithmeticError(f"the level's slope is no quadratic in Omega: {of_level}")
    outer_lets, outer, outer_beyond, outer_falls = _outer(F_value.subs(whole))
    terms, least = _least(quadratic)
    peak_lets, peak, isola = _peak(flow, slope_of_level, of_level)
    fold_slopes_lets, fold_slopes, fold_force = _fold(flow)
    peak_share_lets, peak_share = _peak_share(flow, slope_of_level)
    Omega_of_share_lets, Omega_of_share = _Omega_of_share(flow)
    least_Omega_A = sp.factor_terms(-_x_A(of_level) / x**2)
    F_AOmega, F_AA = flow.F_AOmega, flow.F_AA
    # bend/Omega is a force's F_OmegaOmega less 3 F_Omega/Omega; in the determinant of a force no squares cancel
    bound, share_lets, share_of_h = _bound(G)
    hessian_lets, of_force = hessian(F_AA * flow.F_OmegaOmega - F_AOmega**2, flow.R, flow.I)
    determinant = of_force - 3 * flow.F_Omega * F_AA / Omega
    claim("the determinant", (determinant.subs(hessian_lets) - (bend / Omega * F_AA - F_AOmega**2)).subs(whole))
    return Inertia(
        force=force,
        force_slopes=(sp.diff(force, Omega), sp.diff(force, F_0)),
        amplitude=sp.solve(force - excited, F_0)[0],
        moves_from_lets=((turn, sp.solve(force.subs(Omega**2, turn) - holds, turn)[0]),),
        moves_from=sp.sqrt(turn),
        isolation_lets=_isolation(flow, force),
        isolation=sp.sqrt(turn),
        level=level,
        F=F_value,
        level_slope=slope_of_level,
        level_bend=bend,
        # on F = 0: dF/dOmega = G_Omega - 4 F_0^2 Omega^3 is the level's slope over Omega
        Omega_A=-Omega * flow.F_A / slope_of_level,
        outer_lets=outer_lets,
        outer=outer,
        outer_beyond=outer_beyond,
        outer_falls=outer_falls,
        terms=terms,
        least=least,
        least_Omega_A=least_Omega_A,
        peak_lets=peak_lets,
        peak=peak,
        isola_lets=((drag, friction * x + zeta * A),),
        isola=isola,
        isola_apart=_isola_apart(flow, isola[0], of_level),
        fold_slopes_lets=fold_slopes_lets,
        fold_slopes=fold_slopes,
        fold_force=fold_force,
        fold_level=fold_force / Omega**2,
        peak_share_lets=peak_share_lets,
        peak_share=peak_share,
        Omega_of_share_lets=Omega_of_share_lets,
        Omega_of_share=Omega_of_share,
        # along F_A = 0: dOmega/dA = -F_AA/F_AOmega
        level_rise=-slope_of_level * F_AA * F_AOmega,
        cusp_bend=-slope_of_level * flow.F_AAA * F_AOmega,
        hessian_lets=hessian_lets,
        hessian=determinant,
        bound=bound,
        share_lets=share_lets,
        share=share_of_h,
    )


def _isolation(flow: SlowFlow, force: sp.Expr) -> tuple[Let, ...]:
    """R^2 - h^2 = reduction force^2 is linear in Omega^2 but for Omega = 0; without a reduction that is -2 h/A."""
    over = flow.R**2 - h**2 - (removed * force / F_0) ** 2
    (value,) = (root for root in sp.solve(sp.expand(over.subs(Omega, sp.sqrt(turn))), turn) if root != 0)
    apart = -2 * h / (A - removed**2 / A)
    claim("the frequency of a transmissibility", value - apart)
    return (removed, F_0 * sp.sqrt(reduction)), (turn, apart)


def _outer(F_value: sp.Expr) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...], tuple[sp.Expr, ...], sp.Expr]:
    """Roots of the quadratic in the forms in which nothing cancels; those of F lie inside of them."""
    of_x = sp.Poly(sp.expand(sp.expand(F_value / Omega**4).subs(Omega, 1 / x)), x)
    constant, linear_term, second, cubic, fourth = (of_x.coeff_monomial(x**power) for power in range(5))
    if linear_term != 0 or of_x.degree() != 4 or cubic.could_extract_minus_sign():
        raise ArithmeticError(f"more than a cubic term that is not negative beside a quadratic in x^2: {of_x}")
    of_falls, of_over = sp.factor(-second / 2), (A - F_0) * (A + F_0)
    claim("F far above resonance", of_over - constant)
    # F_0^2 is put in by `square`: of A^2 (h + 2 zeta^2 A)^2 - A^2 square only small terms are left
    of_inner = sp.expand(of_falls**2 - fourth * constant)
    rest_of_it = sp.expand(of_inner - F_0**2 * fourth)
    viscous = sp.factor(rest_of_it - rest_of_it.coeff(zeta, 0))
    inner_value = F_0**2 * square + rest_of_it.coeff(zeta, 0) + viscous
    claim("what the root is of", inner_value.subs(square, fourth) - of_inner)
    roots = ((falls + spread) / square, over / (spread + falls)), (-over / (spread - falls), (falls - spread) / square)
    for larger, smaller in roots:
        product = (falls**2 - spread**2) / square
        claim("the sum of the roots", (larger + smaller).subs(over, product) - 2 * falls / square)
        claim("the product of the roots", (larger * smaller).subs(over, product) - product / square)
    lets = (
        (falls, of_falls),
        (square, fourth),
        (over, of_over),
        (inner, inner_value),
        (spread, sp.sqrt((inner + sp.Abs(inner)) / 2)),
    )
    return lets, *roots, sp.cancel(-of_falls / A)


def _least(quadratic: sp.Poly) -> tuple[tuple[sp.Expr, ...], sp.Expr]:
    """The positive root in the form in which nothing cancels."""
    constant, first, second = (quadratic.coeff_monomial(Omega**power) for power in range(3))
    terms = (sp.factor(second / 4), sp.expand(-first), sp.expand(-constant / 4))
    value = 8 * fall / (linear + sp.sqrt(linear**2 + 64 * fall * rest))
    claim("where the level is least", 4 * rest * value**2 + linear * value - 4 * fall)
    return terms, value


def _x_A(of_level: sp.Expr) -> sp.Expr:
    """Slope of x along A where the level's slope over Omega^2 stays as it is: 0 where the level is least."""
    of_x = sp.expand(of_level.subs(Omega, 1 / x) * x**2)
    return -slope(of_x) / sp.diff(of_x, x)


def _peak(
    flow: SlowFlow, slope_of_level: sp.Expr, of_level: sp.Expr
) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
    """R = -I drag/(h x) where the level is least: then level = I x root, and F_A/2 = I (2 zeta - share (...))/x."""
    at_x = {Omega: 1 / x}
    of_drag = {drag: friction * x + zeta * A}
    (balanced,) = sp.solve(slope_of_level, R)
    claim("R where the level is least", (balanced.subs(at_x) + I * drag / (h * x)).subs(of_drag))
    squared = (R**2 + I**2).subs(R, balanced).subs(at_x) * x**4
    claim("the least level", squared - (I * x * root).subs(root, sp.sqrt(x**2 + (drag / h) ** 2)).subs(of_drag) ** 2)
    half_F_A = (flow.F_A / 2).subs(R, balanced).subs(at_x)
    rises = 2 * zeta * x**2 - share * (1 + h_A * x**2)
    claim("F_A where the level is least", half_F_A * x**3 - (I * rises).subs(share, drag / h).subs(of_drag))
    # dlevel/dA = F_A/(2 level Omega^4), as its derivative by Omega vanishes
    slow = sp.expand(flow.I.subs(at_x) * x)
    lets = ((drag, of_drag[drag]), (share, drag / h), (root, sp.sqrt(x**2 + share**2)))
    peak = (slow * root - F_0, rises / root)
    # -h F_A x^3/(2 I), h < 0
    value = drag * (1 + h_A * x**2) - 2 * zeta * h * x**2
    whole = value.subs(of_drag)
    return lets, peak, (value, slope(whole) + sp.diff(whole, x) * _x_A(of_level))


def _isola_apart(flow: SlowFlow, value: sp.Expr, of_level: sp.Expr) -> sp.Expr:
    """A times it less what vanishes where the level is least: what is left of A + h x^2 there is -I x drag/h."""
    slow = sp.expand(flow.I.subs(Omega, 1 / x) * x)
    apart = -slow * drag**2 / h - zeta * A * cubic * x**2 - friction * k * x**3
    of_h = {cubic: 3 * h - A * h_A, k: h - A * h_A, drag: friction * x + zeta * A}
    vanishing = sp.expand(of_level.subs(Omega, 1 / x) * x**2)
    left = (apart - A * value).subs(of_h)
    claim("F_A where the level is least, by k and cubic", left - of_h[drag] * vanishing / (4 * h))
    return apart / A


def _fold(flow: SlowFlow) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...], sp.Expr]:
    """F_A/2 is R T + I dI/dA, and R = k + A T: a quadratic in T, whose roots are T and -R/A, for a force as well."""
    of_T = {R: k + A * T, h_A: T - Omega**2}
    quadratic = sp.Poly(sp.expand((flow.F_A / 2).subs(of_T)), T)
    leading, middle, constant = quadratic.all_coeffs()
    if (leading, middle) != (A, k):
        raise ArithmeticError(f"F_A/2 is no quadratic of the sum -k/A of its roots: {quadratic}")
    larger = -k * (1 + root) / (2 * A)
    at_larger = sp.expand(quadratic.as_expr().subs(T, larger))
    claim("dR/dA on the fold locus", at_larger.subs(root**2, 1 - 4 * A * constant / k**2))
    inner = 1 - 4 * A * constant / k**2
    lets = ((I, flow.I), (part, inner), (root, sp.sqrt((part + sp.Abs(part)) / 2)), (steep, larger))
    force = sp.sqrt((A * other) ** 2 + I**2)
    return lets, (steep, constant / (A * steep), constant / (I * steep)), force


def _peak_share(flow: SlowFlow, slope_of_level: sp.Expr) -> tuple[tuple[Let, ...], sp.Expr]:
    """h is R - A Omega^2: the level is least where a quadratic in R vanishes; of its roots that which is 0 with I."""
    of_R = slope_of_level.subs(h, R - flow.R + h).subs(R, -share * I) / (-4 * I)
    quadratic = sp.Poly(sp.expand(of_R), share)
    leading, middle, constant = (sp.factor(term) for term in quadratic.all_coeffs())
    value = -2 * constant / (middle + root)
    square = (middle**2 - root**2) / (4 * constant)
    claim("R where the level is least", square * value**2 + middle * value + constant)
    inner = middle**2 - 4 * leading * constant
    return ((I, flow.I), (part, inner), (root, sp.sqrt((part + sp.Abs(part)) / 2))), value


def _Omega_of_share(flow: SlowFlow) -> tuple[tuple[Let, ...], sp.Expr]:
    """The level is I sqrt(1 + share^2)/Omega^2."""
    viscous = zeta * A
    value = (viscous + sp.sqrt(viscous**2 + of_I * friction)) / of_I
    claim("the frequency of a level", (of_I * Omega**2 - flow.I).subs(Omega, value))
    return ((of_I, F_0 / sp.sqrt(1 + share**2)),), value


def _bound(G: sp.Expr) -> tuple[tuple[sp.Expr, ...], tuple[Let, ...], sp.Expr]:
    """Friction only raises the level, which without it is least at 4 zeta^2 A^3 (|h| - zeta^2 A)/h^2 = level^2."""
    smooth = sp.expand(G.subs(friction, 0))
    square = sp.Symbol("square", positive=True)
    of_square = sp.expand(sp.expand(smooth / Omega**4).subs(Omega, 1 / sp.sqrt(square)))
    (where,) = sp.solve(sp.diff(of_square, square), square)
    least = of_square.subs(square, where)
    claim("the least level without friction", least - 4 * zeta**2 * A**3 * (-h - zeta**2 * A) / h**2)
    if any(term.could_extract_minus_sign() for term in sp.Add.make_args(sp.expand(G - smooth))):
        raise ArithmeticError("friction does not raise the level everywhere")
    # (|h| - zeta^2 A)/|h| >= 1 - lost leaves level^2 >= 4 zeta^2 (1 - lost) A^3/|h|
    value = 4 * zeta**2 * (1 - lost) * A**3 + F_0**2 * h
    chain = [value]
    for _ in range(3):
        chain.append(slope(chain[-1]))
    if h_AAA not in chain[-1].free_symbols or h_AA in chain[-1].free_symbols:
        raise ArithmeticError("the third derivative of the bound")
    twice = sp.Symbol("twice", nonnegative=True)
    taken = sp.cancel(1 - least * -h / (4 * zeta**2 * A**3))
    return tuple(chain), ((twice, zeta**2),), taken.subs(zeta, sp.sqrt(twice))
