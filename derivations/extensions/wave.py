"""Step 5, its motion over half a cycle: displacement and velocity of the second approximation, every harmonic of it.

In:  the amplitudes of the second approximation: A_1, the turn delta by its sine and cosine, a_3, a_5, and kappa.
Out: `Formulas`: u and u' at an angle `turned` after the mass turned at its largest displacement.

Friction changes its sign where the mass turns, at psi = delta: the harmonics count from there, turned = psi - delta,

    u = A_1 cos(turned + delta) + sum a_n cos(n turned) + sum b_n sin(n turned),   b_n = -m/(n Omega^2 (n^2 - kappa))

so that u' vanishes at turned = 0, and u is u_max there: -A_1 sin(delta) + sum n b_n = 0. What is passed on, spring,
damper and friction of this motion, has friction's jump at that place.

The b_n fall with n^3. What their sum has more slowly than 1/n^(2 CLOSED) is closed, powers of kappa times polynomials
in turned, which are the integrals of the square wave,

    sum of sin(n turned)/(n (n^2 - kappa)) = sum over k < CLOSED of kappa^k [sum of sin(n turned)/n^(2k + 3)]
                                             + kappa^CLOSED sum of sin(n turned)/(n^(2 CLOSED + 1) (n^2 - kappa))

over n = 3, 5, ...; of the rest harmonics up to `LAST` count. The first harmonic is no term of it: it is taken off the
polynomials as a power series, by which their coefficients become small, and nothing cancels.
"""

from __future__ import annotations

import sympy as sp

from ..claims import claim
from ..forces.elliptic import DIGITS, Let
from ..forces.harmonics import HARMONICS
from ..kernels import Formulas, Lets
from ..paper.slow_flow import m
from ..symbols import Omega
from .second_approximation import RESONANCE

#: angle from where the mass turned at its largest displacement
turned = sp.Symbol("turned", nonnegative=True)
A_1, sine, cosine, kappa = sp.symbols("A_1 sine cosine kappa", real=True)
of_spring = {n: sp.Symbol(f"a_{n}", real=True) for n in HARMONICS}

#: powers of kappa whose sums over all harmonics are closed
CLOSED = 8
#: the last harmonic that counts in what is left; at kappa = 9, the resonance, it leaves out 1e-15 of the first one
LAST = 15
#: the power series of sine and cosine over a quarter cycle, to 1e-18
DEGREE = 24


def closed_sums() -> list[tuple[sp.Expr, sp.Expr]]:
    """Sums of cos(n turned)/n^(2k + 2) and of sin(n turned)/n^(2k + 3), n = 1, 3, 5, ...; of `turned` in 0 to pi."""
    n = sp.Symbol("n", odd=True, positive=True)
    square = sp.pi / 4
    coefficient = sp.integrate(square * sp.sin(n * turned), (turned, 0, sp.pi)) * 2 / sp.pi
    claim("the odd harmonics of a square wave of height `pi/4` are `1/n`", coefficient - 1 / n)
    found, of_sines = [], square
    for _ in range(CLOSED):
        # cosines of odd multiples vanish at pi/2, sines at 0
        of_cosines = -sp.Poly(of_sines, turned).integrate().as_expr()
        of_cosines = sp.expand(of_cosines - of_cosines.subs(turned, sp.pi / 2))
        of_sines = sp.Poly(of_cosines, turned).integrate().as_expr()
        found.append((of_cosines, of_sines))
    return found


def _without_first(total: sp.Expr, x2: sp.Symbol, *, odd: bool) -> sp.Expr:
    """A closed sum less its term n = 1, as a polynomial in (pi/2 - turned)^2, over pi/2 - turned where it is odd."""
    about = sp.Poly(total, turned).compose(sp.Poly(sp.pi / 2 - turned, turned))
    powers = {power: value for (power,), value in about.terms()}
    # of cos(turned) = sin(x), and of sin(turned) = cos(x)
    first = {power: sp.Integer(-1) ** (power // 2) / sp.factorial(power) for power in range(odd, DEGREE + 1, 2)}
    if not set(powers) <= set(first):
        raise ArithmeticError(f"a closed sum about pi/2 is not {'odd' if odd else 'even'}: powers {sorted(powers)}")
    coefficients = {
        ((power - odd) // 2,): sp.Rational(str(sp.N(powers.get(power, 0) - first[power], DIGITS))) for power in first
    }
    return sp.horner(sp.Poly(coefficients, x2).as_expr())


def wave() -> Formulas:
    """All of it."""
    c, s, double = sp.symbols("c_1 s_1 twice", real=True)
    lets: list[Let] = [(c, sp.cos(turned)), (s, sp.sin(turned)), (double, 2 * (c - s) * (c + s))]
    cosines, sines = {-1: c, 1: c}, {-1: -s, 1: s}
    for n in range(3, LAST + 1, 2):
        for known, letter in ((cosines, "c"), (sines, "s")):
            known[n] = sp.Symbol(f"{letter}_{n}", real=True)
            lets.append((known[n], double * known[n - 2] - known[n - 4]))
    # about pi/2 the closed sums are odd or even, which halves their terms
    x, x2 = sp.symbols("x x2", real=True)
    lets += [(x, sp.pi / 2 - turned), (x2, x**2)]
    numbers = range(3, LAST + 1, 2)
    left = {n: sp.Symbol(f"left_{n}", real=True) for n in numbers}
    lets += [(left[n], kappa**CLOSED / (sp.Integer(n) ** (2 * CLOSED) * (n**2 - kappa))) for n in numbers]
    by_cosines, by_sines = (sp.Integer(0), sp.Integer(0))
    closed_cosines, closed_sines = sp.symbols("closed_cosines closed_sines", real=True)
    for of_cosines, of_sines in reversed(closed_sums()):
        by_cosines = kappa * by_cosines + x * _without_first(of_cosines, x2, odd=True)
        by_sines = kappa * by_sines + _without_first(of_sines, x2, odd=False)
    lets += [(closed_cosines, by_cosines), (closed_sines, by_sines)]
    # smallest first
    rest = list(numbers)[::-1]
    of_velocity = closed_cosines + sp.Add(*(left[n] * cosines[n] for n in rest))
    of_displacement = closed_sines + sp.Add(*(left[n] * sines[n] / n for n in rest))
    friction = sp.Function("friction")(turned)
    delta = sp.Symbol("delta", real=True)
    u = A_1 * sp.cos(turned + delta) - m * friction / Omega**2
    u += sum(a * sp.cos(n * turned) for n, a in of_spring.items())
    v = Omega * sp.diff(u, turned)

    def in_lets(expression: sp.Expr) -> sp.Expr:
        for n in of_spring:
            expression = expression.subs({sp.cos(n * turned): cosines[n], sp.sin(n * turned): sines[n]})
        expression = sp.expand_trig(expression).subs({sp.sin(delta): sine, sp.cos(delta): cosine})
        expression = expression.subs({sp.cos(turned): c, sp.sin(turned): s})
        return expression.subs({sp.diff(friction, turned): of_velocity}).subs(friction, of_displacement)

    of = Formulas((turned, Omega, m, A_1, sine, cosine, *of_spring.values(), kappa))
    text = "u and u' at an angle after the mass turned at its largest displacement."
    domain = f"Omega > 0, 0 <= turned <= pi, |kappa| < {RESONANCE}"
    of.add("wave", Lets(lets, (in_lets(u), in_lets(v))), text, "beyond (23)", domain)
    return of
