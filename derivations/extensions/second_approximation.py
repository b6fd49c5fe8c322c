"""Step 5, beyond the paper: the second approximation, what the higher harmonics do to the first one.

In:  the averaged equations; the slow flow's R, I and backbone; the mechanism stays an open h(A), h_3(A), h_5(A).
Out: `Formulas`: R, I and F with the first-order effect of the harmonics, in A = A_1 + sum a_n.

The first approximation u = A cos psi leaves the harmonics of the spring, -h_n cos(n psi), and of friction,
-(m/n) sin(n psi), n = 3, 5, ..., unbalanced. The second lets them drive the linear oscillator that averaging has put in
the spring's place, whose stiffness K is the backbone's Omega^2:

    u = A_1 cos psi + sum a_n cos(n psi) + sum b_n sin(n psi),      n^2 Omega^2 - K divides both

and puts this motion back into the balance of the first harmonic. It is varied about A cos psi with A = A_1 + sum a_n,

    u = A cos psi + sum a_n (cos(n psi) - cos psi) + sum b_n sin(n psi),

where the brackets vanish with their slope at psi = 0: their effect stays finite where the force has a corner. (About
A_1 cos psi it would not, as the slope of h_n' has no bound next to u_cr.)

    cosine  the spring's share is h plus a_n (h_n' - h'): for f(A cos psi) the share of cos(n psi) in the first harmonic
            is that of a change of A in the n-th. Odd terms have none. Friction changes sign where the mass turns, at
            psi = delta, which turns its first harmonic by delta.
    sine    the work of a cycle: friction takes 4 mu u_max, viscous damping is quadratic in each harmonic.

For a linear spring this is Den Hartog's solution itself, (35).

The b_n add up: sum of 1/(n^2 - kappa), kappa = K/Omega^2, is Den Hartog's U (37) less its first term. It is
printed with its poles at the resonances of the first harmonics and the rest as a power series.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import sympy as sp
from flint import arb, ctx
from sympy.codegen.cfunctions import hypot

from ..claims import claim
from ..forces.elliptic import DIGITS, Let, digits
from ..forces.harmonics import HARMONICS
from ..kernels import Formulas, Lets
from ..paper.averaging import Averaged, F_k, psi
from ..paper.slow_flow import I as I_1
from ..paper.slow_flow import R as R_1
from ..paper.slow_flow import m
from ..symbols import F_0, A, Omega, h, h_A, h_AA, h_AAA, mu, sigma, zeta

#: h_n and its derivatives with respect to A
OF_HARMONIC: dict[int, tuple[sp.Symbol, ...]] = {
    n: sp.symbols(f"h_{n} h_{n}_A h_{n}_AA h_{n}_AAA", real=True) for n in HARMONICS
}
OF_FIRST = (h, h_A, h_AA, h_AAA)

#: kappa = K/Omega^2 of the third harmonic's resonance, up to which the answer holds
RESONANCE = 9
#: harmonics of friction whose resonances are poles of their own; the series is in kappa/(next)^2
POLES = (3, 5, 7)
# share of the sum that the series may leave out
NEGLIGIBLE = sp.Rational(1, 2**56)


class _Chain:
    """Quantities in order; each is defined in earlier ones, and brings its derivatives by A, twice, and by Omega."""

    def __init__(self) -> None:
        self.lets: list[Let] = []
        self.by_A: dict[sp.Symbol, sp.Expr] = {A: sp.Integer(1)}
        self.by_Omega: dict[sp.Symbol, sp.Expr] = {Omega: sp.Integer(1)}

    def known(self, family: Sequence[sp.Symbol]) -> None:
        """A function of A that comes with its derivatives."""
        self.by_A |= dict(pairwise(family))

    def slope(self, expression: sp.Expr, by: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
        """Derivative along the chain."""
        return sp.Add(*(sp.diff(expression, symbol) * slope for symbol, slope in by.items() if expression.has(symbol)))

    def function(self, name: str, derivatives: Sequence[sp.Expr], argument: sp.Symbol) -> sp.Symbol:
        """A function of an earlier quantity, given with its first two derivatives."""
        value, slope, curvature = (sp.Symbol(name + mark, real=True) for mark in ("", "_1", "_2"))
        self.lets += list(zip((value, slope, curvature), derivatives, strict=True))
        for by in (self.by_A, self.by_Omega):
            by |= {value: slope * by[argument], slope: curvature * by[argument]}
        return value

    def define(self, name: str, value: sp.Expr) -> sp.Symbol:
        """A new quantity."""
        symbol, symbol_A, symbol_AA, symbol_Omega = (
            sp.Symbol(name + suffix, real=True) for suffix in ("", "_A", "_AA", "_Omega")
        )
        first = self.slope(value, self.by_A)
        self.lets += [
            (symbol, value),
            (symbol_A, first),
            (symbol_AA, self.slope(first, self.by_A)),
            (symbol_Omega, self.slope(value, self.by_Omega)),
        ]
        self.by_A |= {symbol: symbol_A, symbol_A: symbol_AA}
        self.by_Omega[symbol] = symbol_Omega
        return symbol


def friction_sum(kappa: sp.Symbol, order: int) -> sp.Expr:
    """Sum of 1/(n^2 - kappa) over n = 3, 5, ..., or its derivative by kappa, for |kappa| < RESONANCE."""
    beyond = max(POLES) + 2
    ratio = sp.Rational(RESONANCE, beyond**2)
    tail = []
    with ctx.workprec(4 * DIGITS):
        while ratio ** len(tail) > NEGLIGIBLE:
            power = 2 * len(tail) + 2
            # sum of n^(-power) over the odd n that are left: Hurwitz's zeta function
            rest = arb(power).zeta(arb(beyond) / 2) / arb(2) ** power
            # scaled so that every coefficient has all its digits
            tail.append(digits(rest * arb(beyond) ** power) / beyond**power)
    series = sp.horner(sp.diff(sp.Poly(tail[::-1], kappa).as_expr(), kappa, order))
    return sum(sp.diff(1 / (n**2 - kappa), kappa, order) for n in POLES) + series


def friction_harmonic(averaged: Averaged, n: sp.Symbol) -> sp.Expr:
    """Sine component n, odd, of what friction leaves of (9), for any n at once."""
    over_halves = [
        sp.integrate(half.subs({F_k: 0, F_0: 0, zeta: 0, sigma: 0}) * sp.sin(n * psi), (psi, start, end))
        for half, start, end in zip(averaged.perturbation, (0, sp.pi), (sp.pi, 2 * sp.pi), strict=True)
    ]
    return sp.simplify(sum(over_halves) / sp.pi)


def second_approximation(averaged: Averaged, flow: Formulas) -> Formulas:
    """All of step 5."""
    # (23) calls 4 mu/pi m: friction's harmonics are m/n, and n b_n = -m/(n^2 Omega^2 - K)
    n = sp.Symbol("n", odd=True, positive=True)
    claim(
        "the n-th harmonic of friction is `m/n`, n odd",
        n * friction_harmonic(averaged, n) - 4 * mu / sp.pi,
        eq="from (19)",
    )
    chain = _Chain()
    for family in (OF_FIRST, *OF_HARMONIC.values()):
        chain.known(family)
    # stiffness of the linear oscillator of the first approximation, over Omega^2
    kappa = chain.define("kappa", flow.backbone**2 / Omega**2)
    a = {n: chain.define(f"a_{n}", -family[0] / (Omega**2 * (n**2 - kappa))) for n, family in OF_HARMONIC.items()}
    higher = chain.define("share", sum(a.values()))
    A_1 = chain.define("A_1", A - higher)
    # u' = 0 at psi = delta: -A_1 sin(delta) + sum n b_n = 0
    total = chain.function("total", [friction_sum(kappa, order) for order in range(3)], kappa)
    sine = chain.define("sine", -m * total / (A_1 * Omega**2))
    c = sp.Symbol("cosine", real=True)
    cosine = chain.function("cosine", [sp.sqrt((1 - sine) * (1 + sine)), -sine / c, -1 / c**3], sine)
    u_max = chain.define("u_max", A_1 * cosine + higher)
    spring = chain.define("spring", h + sum(a[n] * (family[1] - h_A) for n, family in OF_HARMONIC.items()))
    of_R = flow.R.subs({A: A_1, h: spring}, simultaneous=True) - m * sine
    R = chain.define("R", of_R)
    # work of the forcing over a cycle: -pi A_1 F_0 sin(phi) = pi A_1 I
    viscous = A_1 + sum(n**2 * a[n] ** 2 for n in HARMONICS) / A_1
    of_I = flow.I.subs({A: viscous, m: m * u_max / A_1}, simultaneous=True)
    I = chain.define("I", of_I)
    F_A = 2 * (R * chain.by_A[R] + I * chain.by_A[I])
    F_Omega = 2 * (R * chain.by_Omega[R] + I * chain.by_Omega[I])
    # Omega^5 d(level^2)/dOmega, level = sqrt(R^2 + I^2)/Omega^2, without the force of inertia, which cancels
    R_falls, I_falls = (sp.expand(Omega * chain.slope(of, chain.by_Omega) - 2 * of) for of in (of_R, of_I))
    level_slope = 2 * (R * R_falls + I * I_falls)
    response, level = R**2 + (I - F_0) * (I + F_0), hypot(R, I)
    claim(
        "`F = 0` at `F_0 = sqrt(R^2 + I^2)`",
        response.subs(F_0, sp.sqrt(sum(part**2 for part in level.args))),
        eq="(24)",
    )
    # dF_0/dOmega = 0 along u_max = const
    turning = F_Omega * chain.by_A[u_max] - F_A * chain.by_Omega[u_max]
    of_inertia = level_slope / Omega * chain.by_A[u_max] - F_A * chain.by_Omega[u_max]
    of = Formulas((), domain=f"Omega > 0, A > 0, |h| < {RESONANCE} A Omega^2")
    families = (OF_FIRST, *OF_HARMONIC.values())

    def state(name: str, outputs: tuple[sp.Expr, ...], text: str, *forcing: sp.Symbol, derivatives: int = 2) -> None:
        averages = (symbol for family in families for symbol in family[: derivatives + 1])
        arguments = (Omega, A, *forcing, m, zeta, *averages)
        of.add(name, Lets(chain.lets, outputs), text, "beyond (23)", arguments=arguments)

    slopes = (F_A, F_Omega, chain.by_A[R], chain.by_Omega[R])
    text = "Largest displacement, A_1 and phase, R, F, and dF/dA, dF/dOmega, dR/dA, dR/dOmega."
    state("response", (u_max, A_1, flow.phase.subs({R_1: R, I_1: I}), R, response, *slopes), text, F_0)
    text = "The forcing (24), largest displacement, and what vanishes where the forcing that reaches it is least."
    state("detachment", (level, u_max, turning), text)
    text = "The same of an excitation by inertia."
    state("detachment_by_inertia", (level / Omega**2, u_max, of_inertia), text)
    text = "F and its derivatives: a fold has F = F_A = 0, a cusp all three."
    state("folds", (response, F_A, chain.slope(F_A, chain.by_A)), text, F_0, derivatives=3)
    components = Lets(chain.lets, (u_max, A_1, sine, cosine, *a.values(), kappa))
    arguments = (Omega, A, m, h, *(family[0] for family in OF_HARMONIC.values()))
    text = "Largest displacement and what `wave` takes."
    of.add("components", components, text, "beyond (23)", arguments=arguments)
    return of
