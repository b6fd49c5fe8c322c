"""Step 4, equations (23)-(30) and (38): fixed points of the slow flow and what follows from them, for any mechanism.

In:  the averaged equations; the mechanism stays an open h(A) = H(A) - A.
Out: `Formulas` in A, Omega, F_0, zeta, m = 4 mu/pi, h, h_A, h_AA, h_AAA, structured (unexpanded), F and its derivatives
     in R and I:

    R = A Omega^2 + h        I = 2 zeta A Omega + m        F = R^2 + I^2 - F_0^2

`scene` substitutes the parameters that vanish before the last steps, so that each scene gets its own polynomials.
"""

from __future__ import annotations

import sympy as sp
from sympy.codegen.cfunctions import hypot

from ..claims import claim
from ..kernels import Branch, Formulas, Lets
from ..symbols import F_0, A, Omega, h, h_A, h_AA, h_AAA, mu, phi, sigma, zeta
from .averaging import Averaged, H

R, I = sp.symbols("R I", real=True)
m = sp.Symbol("m", nonnegative=True)
#: -h as A tends to 0, where it pulls inwards; Omega^2
preload, turn = sp.symbols("preload turn", nonnegative=True)
#: 1 less the square of a transmissibility; the root of it times F_0; sqrt(h^2 + removed^2)
reduction, removed, whole = sp.symbols("reduction removed whole", nonnegative=True)

#: the scenes that vanishing damping parameters give, by name
SCENES: dict[str, dict[sp.Symbol, sp.Expr]] = {
    "": {},
    "mu0": {mu: sp.Integer(0)},
    "zeta0": {zeta: sp.Integer(0)},
    "mu0_zeta0": {mu: sp.Integer(0), zeta: sp.Integer(0)},
}
#: of arguments
ORDER = (Omega, A, F_0, mu, m, reduction, zeta, h, h_A, h_AA, h_AAA, preload)


def slope(expression: sp.Expr, slopes: dict[sp.Symbol, sp.Expr] | None = None) -> sp.Expr:
    """d/dA along h, its derivatives and the symbols whose slopes are given."""
    chain = {**(slopes or {}), h: h_A, h_A: h_AA, h_AA: h_AAA}
    return sp.diff(expression, A) + sum(sp.diff(expression, symbol) * value for symbol, value in chain.items())


#: what has this degree, in claims
OF_DEGREE = {4: "each of `F` and `F_A/2` is", 3: "`F_Omega/(4 A)` is"}


def coefficients(expression: sp.Expr, degree: int) -> tuple[sp.Expr, ...]:
    """Coefficients by power of Omega, constant first, without the second-highest: an error unless that vanishes."""
    polynomial = sp.Poly(expression, Omega)
    claim(f"{OF_DEGREE[degree]} a polynomial of degree {degree} in `Omega`", polynomial.degree() == degree, eq="(24)")
    claim(
        "its second-highest coefficient vanishes (depressed polynomial)",
        polynomial.coeff_monomial(Omega ** (degree - 1)),
        eq="(24)",
    )
    return tuple(sp.collect(polynomial.coeff_monomial(Omega**k), (h, A)) for k in (*range(degree - 1), degree))


def _isolation(R_value: sp.Expr) -> tuple[tuple[tuple[sp.Symbol, sp.Expr], ...], ...]:
    """Lets of Omega^2 > 0 where h^2 + I^2 = (1 - reduction) F_0^2 on R^2 + I^2 = F_0^2: for h <= 0, and for h > 0.

    As a quadratic in Omega^2 it has one positive root, the product of both being negative. Each form adds numbers of
    one sign only: no digits cancel. Without a reduction that is -2 h/A, or 0.
    """
    balance = sp.Poly(sp.expand(R_value.subs(Omega**2, turn) ** 2 - h**2 - removed**2), turn)
    square, half, constant = (
        balance.coeff_monomial(turn**2),
        balance.coeff_monomial(turn) / 2,
        balance.coeff_monomial(1),
    )
    root = sp.sqrt(sp.factor(half**2 - square * constant) / A**2).subs(A**2, A * A)
    quadratic = balance.degree() == 2 and constant == -(removed**2)
    claim(
        "the condition of a given transmissibility is a quadratic in `Omega^2` with one positive root",
        quadratic,
        eq="from (23)",
    )
    claim(
        "the discriminant of this quadratic over `4 A^2` is `h^2 + reduction F_0^2`",
        root**2,
        h**2 + removed**2,
        eq="from (23)",
    )
    scale = A / square  # of Omega^2, of a force
    inwards, outwards = (whole - half / A) * scale, removed**2 / ((whole + half / A) * A)
    of_lets = ((removed, F_0 * sp.sqrt(reduction)), (whole, hypot(h, removed)))
    for found in (inwards, outwards):
        claim(
            "both stable forms of the root satisfy the quadratic",
            balance.as_expr().subs(turn, found).subs(whole, root),
            eq="from (23)",
        )
    return tuple((*of_lets, (turn, found)) for found in (inwards, outwards))


def slow_flow(averaged: Averaged, scene: str = "") -> Formulas:
    """All of step 4, in one scene of `SCENES`."""
    vanishing = SCENES[scene]
    friction = sp.expand(-2 * Omega * averaged.slow_flow[0]).coeff(mu) * mu
    of_m = {mu: vanishing.get(mu, sp.solve(friction - m, mu)[0])}
    A_rate, A_phi_rate = (
        sp.expand(rate.subs({sigma: Omega**2 - 1, H: h + A}).subs(of_m).subs(vanishing)) for rate in averaged.slow_flow
    )
    phi_rate = A_phi_rate / A

    # (23): each averaged equation is (its forcing term) + (the rest) = 0, scaled so that the former has factor F_0
    sine = sp.expand(-2 * Omega * A_rate)
    cosine = sp.expand(-2 * Omega * A_phi_rate)
    I_value = sp.collect(sp.expand(sine - F_0 * sp.sin(phi)), A)
    R_value = sp.collect(sp.expand(cosine - F_0 * sp.cos(phi)), A)
    whole = {R: R_value, I: I_value}
    of = Formulas(ORDER, whole)
    of.add("friction", friction.subs(vanishing), "Dry friction's share of I.", "(23)", "mu >= 0")
    of.add("R", R_value, "Cosine balance, -F_0 cos phi at a fixed point.", "(23)")
    of.add("I", I_value, "Sine balance, -F_0 sin phi at a fixed point.", "(23)")

    # (24): square and add; the products keep the digits that an expansion would cancel
    F = R**2 + (I - F_0) * (I + F_0)
    along_A = {R: slope(R_value), I: slope(I_value)}

    def by_Omega(expression: sp.Expr) -> sp.Expr:
        return sp.diff(expression, Omega) + sum(
            sp.diff(expression, symbol) * sp.diff(value, Omega) for symbol, value in whole.items()
        )

    F_A = slope(F, along_A)
    F_AA = slope(F_A, along_A)
    F_Omega = by_Omega(F)
    of.add("F", F, "Frequency response; zero at a steady state.", "(24)")
    of.add("F_A", sp.factor_terms(F_A), "dF/dA; positive where stable.", "(24), (30)")
    every = (Omega, A, m, zeta, h, h_A, h_AA)
    of.add("F_AA", sp.factor_terms(F_AA), "d2F/dA2.", "(24), (33)", arguments=every)
    of.F_AAA = sp.factor_terms(slope(F_AA, along_A))
    of.add("F_Omega", sp.factor_terms(F_Omega), "dF/dOmega.", "(24), (34)")
    of.add("F_AOmega", sp.factor_terms(by_Omega(F_A)), "d2F/dA dOmega.", "(24)")
    of.F_AAOmega = sp.factor_terms(by_Omega(F_AA))
    of.add("F_OmegaOmega", sp.factor_terms(by_Omega(F_Omega)), "d2F/dOmega2.", "(24)")
    # (25): tan phi = I/R. I stays a name even where it is zero: the sign of that zero keeps phi in [-pi, 0]
    phase = Lets([*whole.items()], sp.atan2(-I, -R))
    of.add("phase", phase, "Phase phi of a steady state, from -pi to 0.", "(25)")

    # (26): cos phi = 0 leaves R = 0, Omega^2 = -h/A: the root of a quotient, which SymPy would take apart
    backbone = sp.sqrt(sp.solve(R_value.subs(Omega**2, R), R)[0])
    root = Lets([(turn, backbone**2)], sp.sqrt(turn))
    of.add("backbone", root, "Frequency on the backbone.", "(26)", "A > 0, h <= 0")
    of.backbone = backbone

    @of.kernel("(27)", "Omega > 0, F_0 > m; sticks otherwise")
    def limit_envelope() -> sp.Expr:
        """Largest amplitude that the forcing can hold at this frequency.

        sin phi = -1 leaves I = F_0, A_L = (F_0 - m)/(2 zeta Omega).
        """
        return (*sp.solve(I_value - F_0, A), sp.oo)[0]

    @of.kernel("(38)")
    def equivalent_damping() -> sp.Expr:
        """Viscous damping ratio that dissipates as much as zeta and friction together.

        The one whose term in (23) equals both, zeta + m/(2 A Omega).
        """
        viscous = sp.Symbol("viscous")
        return sp.expand(sp.solve(2 * viscous * Omega * A - I_value, viscous)[0])

    # the base feels F_0 cos(Omega tau) - u'': at a fixed point its harmonics are h and I
    text = "Fundamental harmonic of the force on the base over F_0, at a steady state."
    of.add("transmissibility", hypot(h, I) / F_0, text, "from (23)", "Omega > 0, A > 0, F_0 > 0")
    inwards, outwards = _isolation(R_value)
    of.add(
        "isolation",
        (
            Branch("inwards", ((h, sp.S.Zero),), inwards, (sp.sqrt(turn),)),
            Branch("outwards", (), outwards, (sp.sqrt(turn),)),
        ),
        "Frequency of a state that transmits sqrt(1 - reduction) of what drives it, though it moves.",
        "from (23)",
        "A > 0, F_0 > 0, 0 <= reduction < 1",
    )

    @of.kernel("(24)", "preload >= 0, -h as A tends to 0")
    def held() -> sp.Expr:
        """The forcing up to which a mass at rest stays there: that of a state as A tends to 0."""
        return hypot(I_value.subs(A, 0), -R_value.subs({A: 0, h: -preload}))

    # (28): D_q Gamma = [-zeta, R/(2 Omega); -(Omega^2 + h_A)/(2 A Omega), -I/(2 A Omega)]
    jacobian = sp.Matrix([[slope(rate), sp.diff(rate, phi)] for rate in (A_rate, phi_rate)])
    at_fixed_point = {F_0 * sp.cos(phi): -R_value, F_0 * sp.sin(phi): -I_value}
    jacobian = jacobian.applyfunc(lambda entry: sp.cancel(sp.expand(entry).subs(at_fixed_point)))
    text = "Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22."
    of.add("jacobian", jacobian, text, "(28)")
    # (30): 2 A det = F_A / (4 Omega^2): the boundary of stability is the fold locus
    determinant = sp.expand(4 * Omega**2 * jacobian.det())
    claim("`F_A = 8 A Omega^2 det(D_q Gamma)`", determinant, F_A.subs(whole) / (2 * A), eq="(30)")
    text = "4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive."
    of.add("stability", sp.factor_terms(F_A / (2 * A)), text, "(30)")

    @of.kernel("(24)", "A > 0")
    def response_quartic() -> tuple[sp.Expr, ...]:
        """F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.

        h^2 + (m - F_0)(m + F_0) loses no digits where m is near F_0.
        """
        constant, *others = coefficients((F + F_0**2).subs(whole), 4)
        rest = constant.coeff(h, 0)
        moving, root = constant - rest, sp.sqrt(rest)
        products = (h - F_0) * (h + F_0) if rest == 0 else moving + (root - F_0) * (root + F_0)
        return products, *others

    @of.kernel("(24), (30)", "A > 0")
    def fold_quartic() -> tuple[sp.Expr, ...]:
        """F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4."""
        return coefficients((F_A / 2).subs(whole), 4)

    @of.kernel("(34)", "A > 0")
    def peak_cubic() -> tuple[sp.Expr, ...]:
        """F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3."""
        return coefficients(sp.cancel(F_Omega.subs(whole) / (4 * A)), 3)

    return of
