"""Steps 1 and 4 once more: excitation by inertia, whose amplitude F_0 stands for a force F_0 Omega^2.

A base that moves by Y cos(omega t) pushes the mass, seen from the base, with m omega^2 Y cos(omega t); a mass m_u that
turns at the radius e with m_u e omega^2 cos(omega t). With u measured from the base and made dimensionless both are
F_0 Omega^2 cos(Omega tau), where F_0 is Y/L or m_u e/(m L).

In:  the dimensionless groups (4) and the slow flow with all damping; the mechanism stays an open h(A).
Out: `Formulas`: what differs from a force. F is R^2 + I^2 - F_0^2 Omega^4, so

    level        R^2 + I^2 = level^2 Omega^4; F_A does not contain it: folds and cusps lie where they lie for a force
    level_slope  Omega^5 dlevel^2/dOmega = Omega G_Omega - 4 G, G = R^2 + I^2: a quadratic in Omega, whose only positive
                 root is the lowest level of an amplitude. The level falls to it from inf at Omega = 0 and rises from it
                 to A, as Omega tends to inf; where the quadratic has no such root it falls to A
    states       so an amplitude below F_0 has one frequency, and one above it two or none
"""

from __future__ import annotations

import sympy as sp

from ..claims import claim
from ..kernels import Formulas, Lets
from ..mechanisms import EXCITATIONS as stated
from ..mechanisms import L, k_v
from ..paper.equation_of_motion import F, groups, m, omega, omega_n
from ..paper.slow_flow import I, R, reduction, removed, slope, turn
from ..paper.slow_flow import m as friction
from ..symbols import F_0, A, Omega, h, h_A, h_AA, h_AAA, zeta
from ..systems.along import T, k
from ..systems.slopes import hessian as hessian_of

#: displacement of the base; the mass that turns and its radius
Y, m_u, e = sp.symbols("Y m_u e", positive=True)
#: what is excited by inertia: the amplitude F_0 of each, and its force
EXCITATIONS = {"base": (Y / L, m * omega**2 * Y), "unbalance": (m_u * e / (m * L), m_u * e * omega**2)}

#: 1/Omega
x = sp.Symbol("x", positive=True)
#: (m + zeta A Omega)/Omega, which is I/Omega less half of its viscous part; its share of h; the root of x^2 + share^2
drag, ratio, root = sp.symbols("drag share root", real=True)
#: the quadratic 4 rest x^2 + linear x - 4 fall, which the level's slope is Omega^2 times of
fall, linear, rest = sp.symbols("fall linear rest", real=True)
#: 3 h - A h_A, which a force like A^3 has nothing of
cubic = sp.Symbol("cubic", real=True)
#: the level of a fold without its share of R
of_I = sp.Symbol("of_I", positive=True)
#: slopes of R on the fold locus; what a root is of, which rounding may take below 0
steep, other, part = sp.symbols("steep other part", real=True)
#: a force; what holds a mass at rest
excited, holds = sp.symbols("force holds", nonnegative=True)
#: what h/A may at most take from the bound of the level
lost = sp.Symbol("lost", real=True)

#: of arguments
ORDER = (
    *(x, Omega, A, F_0, excited, holds, reduction, fall, linear, rest, friction, zeta, h, h_A, h_AA, h_AAA),
    *(k, cubic, other, ratio, lost),
)


def amplitude_of(name: str) -> sp.Expr:
    """The group that F_0 is for an excitation, after a check that its force is F_0 Omega^2 in the sense of (4)."""
    amplitude, dimensional = EXCITATIONS[name]
    of_every = groups(k_v, L)
    force = of_every[F_0].subs(F, dimensional)
    claim(
        f"the dimensionless force of {name} excitation is `F_0 Omega^2`",
        force - amplitude * (of_every[Omega].subs(omega_n, of_every[omega_n])) ** 2,
    )
    return amplitude


def inertia(flow: Formulas) -> Formulas:
    """Of any mechanism: what differs from a force."""
    if {"force", *EXCITATIONS} != set(stated):
        raise ValueError(f"the excitations stated are {list(stated)}, those derived {list(EXCITATIONS)} beside a force")
    for name in EXCITATIONS:
        amplitude_of(name)
    of = Formulas(ORDER, {R: flow.R, I: flow.I})
    equation, by_flow, on_locus = "beside (3)", "from (24)", "from (24), (30)"
    force = of.add("force", F_0 * Omega**2, "Amplitude of the force on the mass.", equation, "Omega >= 0")
    slopes = (sp.diff(force, Omega), sp.diff(force, F_0))
    of.add("force_slopes", slopes, "Its slopes by Omega, F_0.", equation, "Omega >= 0")
    (amplitude,) = sp.solve(force - excited, F_0)
    of.add("amplitude", amplitude, "The F_0 of a force at one frequency.", equation, "Omega > 0")

    @of.kernel(equation, "F_0 > 0, holds >= 0")
    def moves_from() -> Lets:
        """The Omega from which on the force exceeds what holds a mass at rest, 4 mu/pi on the average."""
        return Lets([(turn, sp.solve(force.subs(Omega**2, turn) - holds, turn)[0])], sp.sqrt(turn))

    @of.kernel("from (23)", "A > F_0 sqrt(reduction), 0 <= reduction < 1, h <= 0")
    def isolation() -> Lets:
        """Frequency of a state that transmits sqrt(1 - reduction) of what drives it, though it moves.

        R^2 - h^2 = reduction force^2 is linear in Omega^2 but for Omega = 0; without a reduction that is -2 h/A.
        """
        over = flow.R**2 - h**2 - (removed * force / F_0) ** 2
        (value,) = (root for root in sp.solve(sp.expand(over.subs(Omega, sp.sqrt(turn))), turn) if root != 0)
        apart = -2 * h / (A - removed**2 / A)
        claim(
            "`R^2 - h^2 = reduction F_0^2 Omega^4` has the positive root `Omega^2 = -2 h/(A - reduction F_0^2/A)`",
            value - apart,
        )
        return Lets([(removed, F_0 * sp.sqrt(reduction)), (turn, apart)], sp.sqrt(turn))

    whole = {R: flow.R, I: flow.I}
    G = sp.expand((flow.F + F_0**2).subs(whole))

    @of.kernel(by_flow)
    def level() -> sp.Expr:
        """The amplitude F_0 of the excitation for which (Omega, A) is a steady state."""
        return sp.sqrt(R**2 + I**2) / Omega**2

    F = of.add("F", flow.F.subs(F_0, force), "Zero at a steady state.", by_flow)
    claim("`F = 0` at `F_0 = sqrt(R^2 + I^2)/Omega^2`, the forcing of a steady state", F.subs(F_0, level))
    of_level = sp.expand(Omega * sp.diff(G, Omega) - 4 * G)
    claim(
        "`Omega^5 d(F_0^2)/dOmega` of this forcing is a polynomial in `Omega`",
        Omega**5 * sp.diff(G / Omega**4, Omega) - of_level,
    )

    @of.kernel(by_flow)
    def level_slope() -> sp.Expr:
        """Omega^5 times the derivative of level^2 by Omega.

        Without what cancels between G and the derivative.
        """
        value = -4 * (h * R + I * (friction + zeta * A * Omega))
        claim("the same derivative is `-4 (h R + I (m + zeta A Omega))`", value.subs(whole) - of_level)
        return value

    # on F = 0: dF/dOmega = G_Omega - 4 F_0^2 Omega^3 is the level's slope over Omega
    of.add("Omega_A", -Omega * flow.F_A / level_slope, "dOmega/dA along the response.", by_flow)
    quadratic = sp.Poly(of_level, Omega)
    if quadratic.degree() != 2 or sp.expand(G).coeff(Omega, 3) != 0:
        raise ArithmeticError(f"the level's slope is no quadratic in Omega: {of_level}")
    _least(of, quadratic)
    _peak(of, flow, level_slope, of_level)
    _fold(of, flow)
    _of_share(of, flow, level_slope)
    # along F_A = 0: dOmega/dA = -F_AA/F_AOmega
    F_AOmega, F_AA = flow.F_AOmega, flow.F_AA
    of.add(
        "cusp_bend",
        -level_slope * flow.F_AAA * F_AOmega,
        "Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum.",
        on_locus,
    )

    @of.kernel(on_locus)
    def hessian() -> Lets:
        """At an isola point: negative where the level has a saddle in (A, Omega)."""
        bend = sp.factor_terms(sp.diff(of_level, Omega))
        # bend/Omega is a force's F_OmegaOmega less 3 F_Omega/Omega; in the determinant of a force no squares cancel
        lets, of_force = hessian_of(F_AA * flow.F_OmegaOmega - F_AOmega**2, flow.R, flow.I)
        value = of_force - 3 * flow.F_Omega * F_AA / Omega
        claim(
            "Hessian determinant of the forcing at an isola point",
            (value.subs(lets) - (bend / Omega * F_AA - F_AOmega**2)).subs(whole),
        )
        return Lets([*whole.items(), *lets], value)

    _bound(of, G)
    return of


def _least(of: Formulas, quadratic: sp.Poly) -> None:
    """The positive root in the form in which nothing cancels."""
    constant, first, second = (quadratic.coeff_monomial(Omega**power) for power in range(3))
    of.add(
        "terms",
        (sp.factor(second / 4), sp.expand(-first), sp.expand(-constant / 4)),
        "What the least level of an amplitude follows from; it has one where the first, fall, is positive.",
        "from (24)",
        "A > 0",
    )

    @of.kernel("from (24)", "fall > 0, linear >= 0, rest > 0")
    def least() -> sp.Expr:
        """x = 1/Omega where the level of an amplitude is least, by its `terms`."""
        value = 8 * fall / (linear + sp.sqrt(linear**2 + 64 * fall * rest))
        claim(
            "stable form of the root `1/Omega` at which the forcing of an amplitude is least",
            4 * rest * value**2 + linear * value - 4 * fall,
        )
        return value


def _peak(of: Formulas, flow: Formulas, slope_of_level: sp.Expr, of_level: sp.Expr) -> None:
    """R = -I drag/(h x) where the level is least: then level = I x root, and F_A/2 = I (2 zeta - share (...))/x."""
    at_x = {Omega: 1 / x}
    of_drag = {drag: friction * x + zeta * A}
    there = "x of `least`, h < 0"
    vanishing = sp.expand(of_level.subs(at_x) * x**2)
    # slope of x along A where the level's slope over Omega^2 stays as it is: 0 where the level is least
    x_A = -slope(vanishing) / sp.diff(vanishing, x)
    slow = sp.expand(flow.I.subs(at_x) * x)

    @of.kernel("from (24)", there)
    def least_Omega_A() -> sp.Expr:
        """dOmega/dA where the level of an amplitude is least: what a rounding of A does to Omega there."""
        return sp.factor_terms(-x_A / x**2)

    @of.kernel("from (24)", there)
    def peak() -> Lets:
        """The least level of an amplitude less F_0, and its slope along A.

        R follows from I, and nothing cancels: dlevel/dA = F_A/(2 level Omega^4), as its derivative by Omega vanishes.
        """
        (balanced,) = sp.solve(slope_of_level, R)
        claim(
            "at the least forcing `R = -I (m/Omega + zeta A)/(h/Omega)`",
            (balanced.subs(at_x) + I * drag / (h * x)).subs(of_drag),
        )
        squared = (R**2 + I**2).subs(R, balanced).subs(at_x) * x**4
        claim(
            "least forcing of an amplitude, squared",
            squared - (I * x * root).subs(root, sp.sqrt(x**2 + (drag / h) ** 2)).subs(of_drag) ** 2,
        )
        half_F_A = (flow.F_A / 2).subs(R, balanced).subs(at_x)
        rises = 2 * zeta * x**2 - ratio * (1 + h_A * x**2)
        claim(
            "`F_A` at the least forcing of an amplitude",
            half_F_A * x**3 - (I * rises).subs(ratio, drag / h).subs(of_drag),
        )
        lets = (*of_drag.items(), (ratio, drag / h), (root, sp.sqrt(x**2 + ratio**2)))
        return Lets(lets, (slow * root - F_0, rises / root))

    @of.kernel("from (24), (30)", there)
    def isola() -> Lets:
        """Has the sign of F_A where an amplitude's level is least: zero at an isola point; its slope along A.

        It is -h F_A x^3/(2 I), h < 0.
        """
        value = drag * (1 + h_A * x**2) - 2 * zeta * h * x**2
        whole = value.subs(of_drag)
        return Lets(of_drag.items(), (value, slope(whole) + sp.diff(whole, x) * x_A))

    @of.kernel("from (24), (30)", there)
    def isola_apart() -> Lets:
        """The same without its slope by k = h - A h_A and cubic = 3 h - A h_A, small where h is like A^3.

        A times it less what vanishes where the level is least: what is left of A + h x^2 there is -I x drag/h.
        """
        apart = -slow * drag**2 / h - zeta * A * cubic * x**2 - friction * k * x**3
        of_h = {cubic: 3 * h - A * h_A, k: h - A * h_A, **of_drag}
        left = (apart - A * isola[0]).subs(of_h)
        claim("the same by `h - A h_A` and `3 h - A h_A`", left - of_h[drag] * vanishing / (4 * h))
        return Lets(of_drag.items(), apart / A)


def _fold(of: Formulas, flow: Formulas) -> None:
    """F_A/2 is R T + I dI/dA, and R = k + A T: a quadratic in T, whose roots are T and -R/A, for a force as well."""
    of_T = {R: k + A * T, h_A: T - Omega**2}
    quadratic = sp.Poly(sp.expand((flow.F_A / 2).subs(of_T)), T)
    leading, middle, constant = quadratic.all_coeffs()
    if (leading, middle) != (A, k):
        raise ArithmeticError(f"F_A/2 is no quadratic of the sum -k/A of its roots: {quadratic}")

    @of.kernel("from (30)", "Omega > 0, A > 0, zeta > 0, k other than 0")
    def fold_slopes() -> Lets:
        """dR/dA at a fold by k = h - A h_A: of the two with F_A = 0 the larger, the other; -R/I with the first.

        Without h, which may be all rounding.
        """
        larger = -k * (1 + root) / (2 * A)
        at_larger = sp.expand(quadratic.as_expr().subs(T, larger))
        claim("`F_A = 0` for the larger root `dR/dA`", at_larger.subs(root**2, 1 - 4 * A * constant / k**2))
        inner = 1 - 4 * A * constant / k**2
        lets = ((I, flow.I), (part, inner), (root, sp.sqrt((part + sp.Abs(part)) / 2)), (steep, larger))
        return Lets(lets, (steep, constant / (A * steep), constant / (I * steep)))

    by_other = "by the one of `fold_slopes` that is not its own."
    level = sp.sqrt((A * other) ** 2 + I**2)
    of.add("fold_force", level, f"The F_0 of a force at a fold, {by_other}", "from (24), (30)")
    of.add("fold_level", level / Omega**2, f"The F_0 of a fold, {by_other}", "from (24), (30)")


def _of_share(of: Formulas, flow: Formulas, slope_of_level: sp.Expr) -> None:
    """h is R - A Omega^2: the level is least where a quadratic in R vanishes; of its roots that which is 0 with I."""

    @of.kernel("from (24)", "Omega > 0, A > 0, zeta > 0")
    def peak_share() -> Lets:
        """-R/I where the level is least and R small beside A Omega^2."""
        of_R = slope_of_level.subs(h, R - flow.R + h).subs(R, -ratio * I) / (-4 * I)
        quadratic = sp.Poly(sp.expand(of_R), ratio)
        leading, middle, constant = (sp.factor(term) for term in quadratic.all_coeffs())
        value = -2 * constant / (middle + root)
        square = (middle**2 - root**2) / (4 * constant)
        claim("stable form of the root `-R/I` at the least forcing", square * value**2 + middle * value + constant)
        inner = middle**2 - 4 * leading * constant
        return Lets([(I, flow.I), (part, inner), (root, sp.sqrt((part + sp.Abs(part)) / 2))], value)

    @of.kernel("from (24)", "A > 0, F_0 > 0")
    def Omega_of_share() -> Lets:
        """Omega of a steady state with that -R/I.

        The level is I sqrt(1 + share^2)/Omega^2.
        """
        viscous = zeta * A
        value = (viscous + sp.sqrt(viscous**2 + of_I * friction)) / of_I
        claim("root `Omega` of `I = F_0 Omega^2/sqrt(1 + (R/I)^2)`", (of_I * Omega**2 - flow.I).subs(Omega, value))
        return Lets([(of_I, F_0 / sp.sqrt(1 + ratio**2))], value)


def _bound(of: Formulas, G: sp.Expr) -> None:
    """Friction only raises the level, which without it is least at 4 zeta^2 A^3 (|h| - zeta^2 A)/h^2 = level^2."""
    smooth = sp.expand(G.subs(friction, 0))
    square = sp.Symbol("square", positive=True)
    of_square = sp.expand(sp.expand(smooth / Omega**4).subs(Omega, 1 / sp.sqrt(square)))
    (where,) = sp.solve(sp.diff(of_square, square), square)
    least = of_square.subs(square, where)
    claim(
        "without friction the least forcing is `F_0^2 = 4 zeta^2 A^3 (-h - zeta^2 A)/h^2`",
        least - 4 * zeta**2 * A**3 * (-h - zeta**2 * A) / h**2,
    )
    if any(term.could_extract_minus_sign() for term in sp.Add.make_args(sp.expand(G - smooth))):
        raise ArithmeticError("friction does not raise the level everywhere")

    @of.kernel("from (24)", "A > 0, h < 0, lost <= 1/2")
    def bound() -> tuple[sp.Expr, ...]:
        """Positive where no state has an amplitude A > F_0, if zeta^2 A <= lost |h|; three derivatives by A.

        It is 4 zeta^2 A^2 (1 - lost) - F_0^2 |h|/A, each derivative times powers of A: (|h| - zeta^2 A)/|h| >= 1 - lost
        leaves level^2 >= 4 zeta^2 (1 - lost) A^3/|h|.
        """
        chain = [4 * zeta**2 * (1 - lost) * A**3 + F_0**2 * h]
        for _ in range(3):
            chain.append(slope(chain[-1]))
        if h_AAA not in chain[-1].free_symbols or h_AA in chain[-1].free_symbols:
            raise ArithmeticError("the third derivative of the bound")
        return tuple(chain)

    twice = sp.Symbol("twice", nonnegative=True)
    taken = sp.cancel(1 - least * -h / (4 * zeta**2 * A**3))
    fraction = Lets([(twice, zeta**2)], taken.subs(zeta, sp.sqrt(twice)))
    of.add("share", fraction, "What zeta^2 A is of |h|: `lost` of the `bound`.", "from (24)", "h < 0")
