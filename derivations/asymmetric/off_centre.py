"""Beside (11)-(30): motions off the centre, u = B + A cos psi, under a static load or where a force is not odd.

In:  the equation of motion as `averaging` has it, with the load beside F_0 cos; the force f stays an open function.
Out: `Formulas`: the balance of the mean, h and its derivatives along it, and what vanishes at states and at folds, all
     in the means c_n of f^(n) and s_n of f^(n) cos psi over a cycle; what a parameter of the force or the load does to
     h along the balance, for the gradients of answers; these means of a piecewise polynomial in closed form, in every
     regime alike, with its `steps`.

Averaged as in (19), with B beside A cos psi, the equation of motion leaves the balance

    f_0(A, B) = c_0 - load = 0

and h = -2 s_0 in the place of (20). Under the integral sign, by parts in psi for the last of them,

    d c_n/dB = c_(n+1)    d c_n/dA = d s_n/dB = s_(n+1)    d s_n/dA = c_(n+1) - s_n/A

so that these means are closed under differentiation. Along the balance dB/dA = -s_1/c_1; where c_1 vanishes the balance
turns back, and what is asked there is multiplied by c_1.

A piecewise polynomial is the sum of its steps: a force that is 0 up to u = b and has the derivatives D_0, D_1, ... just
above it. With a = b - B it adds D_k to f^(k), and to c_n the sum of D_k L_(k-n), to s_n that of D_k M_(k-n), where

    L_k = (1/pi) int_0^psi (A cos t - a)^k/k! dt      M_k = the same with cos t      cos psi = a/A

for k >= 0; those for k < 0 are derivatives of L_0 and M_0 by B. psi = 0 where the motion stays below the step, pi where
it stays above: then they are polynomials. The first piece is a step at u = 0 that all of the motion is above.

Just past a step c_1 and s_1 go as 1/sqrt(distance). In coordinates of the motion's ends nothing does: of x for B + A
and y for B - A, each the root of how far that end is past a step, or the end itself,

    (B + A)_x = 2 X    (B - A)_y = -2 Y    c_x = X (c_1 + s_1)    c_y = -Y (c_1 - s_1)    A_x = X    A_y = Y

where X = x or 1/2. What vanishes at states and at folds is had in these too.

What dissipates and what excites has no part in the balance. It comes in as I and as the amplitude of the force G, which
is F_0, or F_2 Omega^2 of an excitation by inertia. With R for the frequency, A Omega^2 = R - h, nothing cancels next to
a resonance, where R is small:

    F = R^2 + I^2 - G^2    A F_A/2 = G^2 + I (A I_A - I) + R (A h_A - h) on F = 0

and A I_A - I is d (A Omega)^2 - m: neither viscous nor structural damping is in it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

import sympy as sp

from ..claims import claim
from ..extensions.dissipation import I_0, I_A, d, d_3
from ..kernels import Formulas, Let, Lets
from ..paper.averaging import Averaged, F_k, cycle_integral, psi
from ..paper.slow_flow import I, R, m, turn
from ..symbols import F_0, A, Omega, eta, h, mu, sigma, u, zeta

B, load = sp.symbols("B load", real=True)
#: what a fold needs of f: its first three derivatives
ORDERS = 3
c = sp.symbols(f"c_0:{ORDERS + 1}", real=True)
s = sp.symbols(f"s_0:{ORDERS + 1}", real=True)
#: amplitude of the force on the mass; what it is of an excitation by inertia over Omega^2
force, F_2 = sp.symbols("force F_2", nonnegative=True)
#: Omega^2, A Omega, A I_A - I
square, speed, drift = sp.symbols("square speed drift", real=True)

#: the step's place seen from B, sqrt(A^2 - a^2), the angle at which it is passed
a, root, angle = sp.symbols("a root angle", real=True)
#: A^2 - a^2: of how far both ends of a motion are past the step the product, which A and a, rounded, do not give there
span = sp.Symbol("span", real=True)
k = sp.Symbol("k", integer=True)
#: L_(k-2), L_(k-1), M_(k-2), M_(k-1)
L_2, L_1, M_2, M_1 = sp.symbols("L_2 L_1 M_2 M_1", real=True)
#: what resists along the balance, (c_1^2 - s_1^2)/c_1; h_A = 2 s_0/A - 2 resists
resists = sp.Symbol("resists", real=True)
L_k, M_k = sp.symbols("L_k M_k", real=True)

#: what a parameter does to the means and to the load at fixed A and B, and to an end of a piece
c_p = sp.symbols(f"c_0:{ORDERS}_p", real=True)
s_p = sp.symbols(f"s_0:{ORDERS}_p", real=True)
load_p, end_p = sp.symbols("load_p end_p", real=True)
#: 1 where a motion comes to an end at B + A, -1 where it does at B - A
side = sp.Symbol("side", real=True)

#: of coordinates x and y of a motion's ends: A_x and A_y, with their slopes; those of c_0, and of each by its own one
X, Y = sp.symbols("X Y", nonnegative=True)
X_x, Y_y, c_x, c_y, c_xx, c_yy = sp.symbols("X_x Y_y c_x c_y c_xx c_yy", real=True)

_f = sp.Function("f")
_DISPLACED = B + A * sp.cos(psi)


#: of arguments
ORDER = (
    *(Omega, R, k, side, A, B, force, F_0, F_2, I, I_A, m, eta, zeta, d, load, h, *c, *s),
    *(c_x, c_y, c_xx, c_yy, X, Y, X_x, Y_y, *c_p, *s_p, load_p, end_p),
    *(a, root, span, angle, L_2, L_1, L_k, M_2, M_1, M_k),
)


def _by_B(expression: sp.Expr) -> sp.Expr:
    """d/dB of an expression in c and s."""
    chain = (*pairwise(c), *pairwise(s), *pairwise(c_p), *pairwise(s_p))
    return sp.diff(expression, B) + sum(sp.diff(expression, mean) * slope for mean, slope in chain)


def _by_A(expression: sp.Expr) -> sp.Expr:
    """d/dA of the same."""
    chain = []
    for of_one, of_cosine in ((c, s), (c_p, s_p)):
        chain += zip(of_one, of_cosine[1:], strict=False)
        chain += ((mean, above - mean / A) for mean, above in zip(of_cosine, of_one[1:], strict=False))
    return sp.diff(expression, A) + sum(sp.diff(expression, mean) * slope for mean, slope in chain)


def check_means() -> None:
    """The four slopes above, from the integrals' own; what is a whole derivative by psi has no mean."""
    value, slope = _f(_DISPLACED), sp.diff(_f(_DISPLACED), B).doit()
    by_A = sp.diff(value, A).doit()
    claim("`d c_0/dA = s_1`", by_A - slope * sp.cos(psi))
    claim("`d s_0/dB = s_1`", sp.diff(value * sp.cos(psi), B).doit() - slope * sp.cos(psi))
    # A times (d s_0/dA - c_1) + s_0
    apart = A * (by_A * sp.cos(psi) - slope) + value * sp.cos(psi)
    apart -= sp.diff(value * sp.sin(psi), psi).doit()
    claim("`d s_0/dA = c_1 - s_0/A`", sp.expand_trig(apart).subs(sp.sin(psi) ** 2, 1 - sp.cos(psi) ** 2))


def check_balance(averaged: Averaged) -> None:
    """Of the equation of motion nothing but f and the load has a mean over a cycle."""
    halves = ((averaged.perturbation[0], 0, sp.pi), (averaged.perturbation[1], sp.pi, 2 * sp.pi))
    others = sum(cycle_integral(half.subs({F_k: 0, sigma: 0}), start, end) for half, start, end in halves)
    claim("forcing, damping and friction have zero mean over a cycle", others)


def off_centre(averaged: Averaged, flow: Formulas, laws: Formulas) -> Formulas:
    """In the means c_n of f^(n) and s_n of f^(n) cos psi over a cycle, and what gives these of a step of the force."""
    check_means()
    check_balance(averaged)
    of = Formulas(ORDER)
    of_mean, of_state, of_fold = "the mean of (3)", "(24) and the mean of (3)", "(24), (30) and the mean of (3)"
    # (20): H = -(1/pi) int F_k cos psi, of which s_0 is half the negative
    claim("`h = -2 s_0`", averaged.restoring_integrand + F_k * sp.cos(psi) / sp.pi)
    of_h = {h: -2 * s[0]}
    f_0 = c[0] - load
    R_value = flow.R.subs(of_h)
    lets, chain = _along_balance(f_0, of_h[h])
    text = "h, h_A, h_AA, h_AAA along the balance of the mean."
    of.add("averaged", Lets(lets, chain), text, "(20), (31)", "A > 0, c_1 other than 0")

    F = R**2 + I**2 - force**2
    claim("`F = R^2 + I^2 - force^2`", (F - flow.F).subs(force, F_0))
    # in R, I and I_A, which a kernel has first
    slopes = tuple(2 * (R * by(R_value) + I * of_I) for by, of_I in ((_by_A, I_A), (_by_B, 0)))
    of.add(
        "state",
        Lets([(R, R_value)], (f_0, F, s[1], c[1], *slopes)),
        "What vanishes at a steady state: the balance of the mean and F; slopes of each by A and B.",
        of_state,
        "A > 0",
    )
    by_R = _by_R(laws)
    fold = _fold_by_R(by_R, f_0, c[1], c[1] * s[0] - A * (c[1] ** 2 - s[1] ** 2) / 2, (_by_A, _by_B))
    _check_fold_by_R(by_R, fold[1], (c[1], -s[1]), (_by_A, _by_B))
    at_fold = "What vanishes at a fold, by R, with the force F_0 + F_2 Omega^2"
    text = f"{at_fold}: the balance, F along it by c_1 A/2, and F; slopes of each by A, B and R."
    of.add("fold", Lets(by_R, fold), text, of_fold, "A > 0, R + 2 s_0 > 0")
    along_balance = 2 * s[0] / A - 2 * resists
    of_means = {resists: (c[1] ** 2 - s[1] ** 2) / c[1]}
    claim("derivative of `h` by `A` along the balance of the mean", along_balance.subs(of_means) - chain[1].subs(lets))

    # by the motion's ends as by A and B, by the chain rule
    both, by_ends = _by_ends(), "by coordinates x and y of the motion's ends"
    slopes = tuple(2 * (R * by(R_value) + I * I_A * by(A)) for by in both)
    of.add(
        "ended_state",
        Lets([(R, R_value)], (f_0, F, *(by(f_0) for by in both), *slopes)),
        f"What vanishes at a steady state, {by_ends}: the balance of the mean and F; slopes of each by x and y.",
        of_state,
        "A > 0",
    )
    A_t = -c_y * X + c_x * Y
    gain = s[0] * A_t + A * c_x * c_y
    of_ends = {c_x: X * (c[1] + s[1]), c_y: -Y * (c[1] - s[1])}
    claim("along the balance `dA` has the sign of `c_1`", A_t.subs(of_ends) - 2 * X * Y * c[1])
    # along the balance, which goes as (-c_y, c_x); c_1 has the sign of the first
    text = "Along the balance, by coordinates of the motion's ends: A's slope, and what F_A gains there by R."
    of.add("ended_along", (A_t, gain), text, "(30) and the mean of (3)", "A > 0")
    text = "Slopes of s_0 by coordinates x and y of the motion's ends, and of c_x by y."
    of.add("ended_slopes", (both[0](s[0]), both[1](s[0]), both[1](c_x)), text, of_mean, "A > 0")
    fold = _fold_by_R(by_R, f_0, A_t, gain, both)
    _check_fold_by_R(by_R, fold[1], (-c_y, c_x), both)
    text = f"{at_fold}, {by_ends}: the balance, F along it times A/2, and F; slopes of each by x, y and R."
    of.add("ended_fold", Lets(by_R, fold), text, of_fold, "A > 0, R + 2 s_0 > 0")

    @of.kernel("(23)", "A > 0, zeta > 0", arguments=(A, R, I, m, zeta, h))
    def frequency_by_phase() -> tuple[sp.Expr, sp.Expr]:
        """Omega of a motion by I; and its square by R."""
        return sp.solve(I - flow.I, Omega)[0], sp.solve(R - flow.R.subs(Omega**2, turn), turn)[0]

    @of.kernel(of_mean, "c_3 other than 0")
    def beside() -> sp.Expr:
        """(c_1^2 - s_1^2)/c_1 of an odd force without a load where f_0 = 0 and B is not 0, with c_3 and s_2 of some B
        between 0 and there.

        f_0 = B g(A, B^2) vanishes with g. Then c_1 = 2 B^2 dg/dB^2 and s_1 = B dg/dA. As f_0 = int c_1 dB from 0, g is
        the mean of c_1 over the B between, its slope by A that of s_2, and that by B^2 the mean of c_3 with weights
        whose sum is 1/6.
        """
        fraction, second = sp.symbols("share second", positive=True)
        # c_1 of B is even: its slope c_2 at B share is the integral of c_3 from 0
        weight = sp.integrate(fraction * sp.integrate(1, (second, 0, fraction)), (fraction, 0, 1)) / 2
        return sp.expand(of_means[resists].subs({c[1]: 2 * B**2 * weight * c[3], s[1]: B * s[2]}))

    _by_parameter(of, f_0, *chain[:2], lets[:2])
    _climb(of)
    return of


def _along_balance(f_0: sp.Expr, value: sp.Expr) -> tuple[tuple[Let, ...], tuple[sp.Expr, ...]]:
    """B_A, B_AA, B_AAA from f_0 = 0 by implicit differentiation; a value and its derivatives in A with these."""
    slopes = sp.symbols("B_A B_AA B_AAA", real=True)

    def derivative(expression: sp.Expr) -> sp.Expr:
        chain = pairwise(slopes)
        known = sum(sp.diff(expression, one) * following for one, following in chain)
        return _by_A(expression) + slopes[0] * _by_B(expression) + known

    lets, balance, derivatives = [], f_0, [value]
    for slope in slopes:
        balance = derivative(balance)
        derivatives.append(sp.expand(derivative(derivatives[-1])))
        (solved,) = sp.solve(balance, slope)
        lets.append((slope, solved))
    return tuple(lets), tuple(derivatives)


def _by_parameter(of: Formulas, f_0: sp.Expr, value: sp.Expr, value_A: sp.Expr, of_B: Sequence[Let]) -> None:
    """By implicit differentiation of the balance, once by the parameter and then in A along the balance."""

    def by_p(expression: sp.Expr) -> sp.Expr:
        """At fixed A and B."""
        direct = (*zip(c, c_p, strict=False), *zip(s, s_p, strict=False), (load, load_p))
        return sum(sp.diff(expression, symbol) * move for symbol, move in direct)

    slopes = sp.symbols("B_A B_AA", real=True)
    sensitivities = sp.symbols("B_p B_Ap B_AAp", real=True)

    def derivative(expression: sp.Expr) -> sp.Expr:
        chain = (*pairwise(slopes), *pairwise(sensitivities))
        known = sum(sp.diff(expression, one) * following for one, following in chain)
        return _by_A(expression) + slopes[0] * _by_B(expression) + known

    lets = [*of_B]
    balance = by_p(f_0) + sensitivities[0] * _by_B(f_0)
    values = [by_p(value) + sensitivities[0] * _by_B(value)]
    for move in sensitivities:
        (solved,) = sp.solve(balance, move)
        lets.append((move, solved))
        balance = derivative(balance)
        if move is not sensitivities[-1]:
            values.append(sp.expand(derivative(values[-1])))
    # the other way: h_A along the balance, then by the parameter
    explicit = value_A.subs(of_B[:1])
    by_parameter = by_p(explicit) + sensitivities[0] * _by_B(explicit)
    claim("derivative of `h_A` by a parameter along the balance", (by_parameter - values[1]).subs(reversed(lets)))
    at_end = sp.Symbol("A_p")
    (edge,) = sp.solve(by_p(f_0) + at_end * _by_A(f_0) + side * (end_p - at_end) * _by_B(f_0), at_end)
    text = "B_p, h_p, h_Ap, h_AAp along the balance at a fixed A, by what a parameter does to means and load."
    of.add("moved", Lets(lets, (sensitivities[0], *values)), text, "(20), (31)", "A > 0, c_1 other than 0")
    text = "A_p of a motion that comes to an end of a piece: at B + A for side = 1, at B - A for side = -1."
    of.add("moved_at_end", (edge,), text, "the mean of (3)", "side c_1 other than s_1")


def _by_ends() -> tuple[Callable[[sp.Expr], sp.Expr], Callable[[sp.Expr], sp.Expr]]:
    """d/dx and d/dy, for coordinates of a motion's ends, of an expression in A, c_0, s_0 and the slopes of c_0."""
    c_xy = -(Y * c_x + X * c_y) / (2 * A)
    chains = (
        ((A, X), (X, X_x), (c[0], c_x), (s[0], c_x - X * s[0] / A), (c_x, c_xx), (c_y, c_xy)),
        ((A, Y), (Y, Y_y), (c[0], c_y), (s[0], -c_y - Y * s[0] / A), (c_x, c_xy), (c_y, c_yy)),
    )
    # by A and B: B + A and B - A move by 2 X and by -2 Y
    of_means = {c_x: X * (c[1] + s[1]), c_y: -Y * (c[1] - s[1])}
    for chain, by_A, by_B in zip(chains, (X, Y), (X, -Y), strict=True):
        for value, slope in chain:
            if value in (c[0], s[0]):
                claim(
                    "derivatives by the turning points of the motion follow from those by `A` and `B`",
                    slope.subs(of_means) - by_A * _by_A(value) - by_B * _by_B(value),
                )
    mixed = of_means[c_x]
    claim(
        "mixed second derivative of `c_0` by the turning points",
        c_xy.subs(of_means) - Y * (_by_A(mixed) - _by_B(mixed)),
    )

    def by(chain: tuple[tuple[sp.Symbol, sp.Expr], ...]) -> Callable[[sp.Expr], sp.Expr]:
        return lambda expression: sum(sp.diff(expression, value) * slope for value, slope in chain)

    return by(chains[0]), by(chains[1])


def _by_R(laws: Formulas) -> tuple[Let, ...]:
    """What is known at a given R, in order."""
    known = sp.expand(laws.I.subs({I_0: laws.at_rest[0].subs(mu, sp.pi * m / 4), d_3: 0}))  # not asked for
    value = sp.expand(known.subs(Omega, speed / A))
    drift_value = sp.expand(sp.expand(A * sp.diff(known, A) - known).subs(Omega, speed / A))
    return (
        (square, (R + 2 * s[0]) / A),
        (speed, sp.sqrt(A * (R + 2 * s[0]))),
        (force, F_0 + F_2 * square),
        (I, value),
        (drift, drift_value),
    )


By = Callable[[sp.Expr], sp.Expr]


def _along_R(by_R: tuple[Let, ...], by: By) -> By:
    """A slope, of an expression in what is known at R too, by what `by` is the slope by."""
    chain = {}
    for one, value in by_R:
        inside = sp.expand(value**2) if one is speed else value
        slope = by(inside) + sum(sp.diff(inside, known) * change for known, change in chain.items())
        chain[one] = sp.expand(slope) / (2 * speed) if one is speed else slope
    return lambda expression: by(expression) + sum(sp.diff(expression, one) * slope for one, slope in chain.items())


def _fold_by_R(by_R: tuple[Let, ...], f_0: sp.Expr, A_t: sp.Expr, gain: sp.Expr, by: tuple[By, By]) -> Any:
    """What vanishes at a fold, and its slopes by two coordinates and R.

    A_t, gain -- along the balance A's slope, and that of (A h_A - h)/4, which A_t is a factor of
    """
    values = (f_0, A_t * (force**2 + I * drift) + 4 * gain * R, R**2 + I**2 - force**2)
    by_each = [_along_R(by_R, one) for one in (*by, lambda expression: sp.diff(expression, R))]
    return (*values, *(one(value) for value in values for one in by_each))


def _check_fold_by_R(by_R: tuple[Let, ...], turns: sp.Expr, to: Any, by: tuple[By, By]) -> None:
    """On F = 0 the second is A/2 times the slope of F at a given Omega, where the balance goes `to`."""
    of_Omega = {one: value.subs(speed, A * Omega) for one, value in by_R}
    R_value = A * Omega**2 - 2 * s[0]
    slope = A * (to[0] * by[0](R_value**2 + of_Omega[I] ** 2) + to[1] * by[1](R_value**2 + of_Omega[I] ** 2)) / 2
    on_F = turns.subs(force**2, R**2 + I**2).subs({I: of_Omega[I], drift: of_Omega[drift]}).subs(R, R_value)
    claim("derivative of `F` along the balance of the mean, at given `R`", slope - on_F)


def _climb(of: Formulas) -> None:
    """L and M by recursion: what is integrated is a whole derivative, which vanishes at both ends of its range."""
    theta, power = sp.symbols("theta power", positive=True)
    over = A * sp.cos(theta) - a
    # A sin(theta) (A cos(theta) - a)^(k-1), its derivative over (A cos(theta) - a)^(k-2)
    derivative = A * sp.cos(theta) * over - (power - 1) * A**2 * sp.sin(theta) ** 2
    found = power * over**2 + (2 * power - 1) * a * over - (power - 1) * (A**2 - a**2)
    claim(
        "recursion of the integrals of `(A cos(theta) - a)^k`",
        (derivative - found).subs(sp.sin(theta) ** 2, 1 - sp.cos(theta) ** 2),
    )
    # with the factorials: k^2 L_k = -(2 k - 1) a L_(k-1) + (A^2 - a^2) L_(k-2); M_(k-1) is the slope of L_k by A
    up = (
        (span * L_2 - (2 * k - 1) * a * L_1) / k**2,
        (span * M_2 - (2 * k + 1) * a * M_1 + 2 * A * L_1) / (k + 1) ** 2,
    )
    # the same two the other way: of L for k, of M for k with L_(k-1) known
    down = (
        (k**2 * L_k + (2 * k - 1) * a * L_1) / root**2,
        ((k + 1) ** 2 * M_k + (2 * k + 1) * a * M_1 - 2 * A * L_1) / root**2,
    )
    passes = sp.sqrt(A**2 - a**2)
    first = sp.acos(a / A) / sp.pi
    other = sp.integrate(sp.cos(theta), (theta, 0, angle)).subs(angle, sp.acos(a / A)) / sp.pi
    begin = (1 / (sp.pi * root), angle / sp.pi, a / (sp.pi * A * root), root / (sp.pi * A))
    inside = {A: sp.Rational(7, 5), a: sp.Rational(2, 3)}
    for value, exact in zip(begin, (-sp.diff(first, a), first, -sp.diff(other, a), other), strict=True):
        apart = value.subs({angle: sp.acos(a / A), root: passes}) - exact
        if sp.simplify(apart.subs(inside)) != 0:
            raise ArithmeticError(f"{value} is not where the recursion begins")
    of_mean = "the mean of (3)"
    text = "L_-1, L_0, M_-1, M_0 of a step at B + a that the motion passes at psi = angle."
    of.add("begin", begin, text, of_mean, "root = sqrt(A^2 - a^2)")
    of.add("up", up, "L_k and M_k from the two below each; span = A^2 - a^2.", of_mean, "k >= 1")
    of.add("down", down, "L_(k-2) and M_(k-2) from the two above each.", of_mean, "root > 0")


def steps(
    pieces: Sequence[sp.Expr], breakpoints: Sequence[sp.Symbol], jumps: Sequence[sp.Expr]
) -> tuple[tuple[sp.Expr, ...], ...]:
    """Of the pieces of a force f and its derivatives: the first at 0, gains at each breakpoint, the last at 0.

    What f itself gains is its jump with the other sign: 0 for one that is continuous, not a difference of its pieces.
    By the last a motion is bounded that is large beside the breakpoints: the others cancel there.
    """
    highest = _highest(pieces)
    gains = [
        (-jump, *_derivatives(above - below, b, highest)[1:])
        for below, above, b, jump in zip(pieces, pieces[1:], breakpoints, jumps, strict=False)
    ]
    first, last = (tuple(_derivatives(piece, sp.Integer(0), highest)) for piece in (pieces[0], pieces[-1]))
    return first, *gains, last


def steps_by(
    pieces: Sequence[sp.Expr], ends: Sequence[sp.Expr], parameters: Sequence[sp.Symbol]
) -> tuple[sp.Expr, ...]:
    """What each parameter in turn does to the derivatives of each piece at u = 0, then to their gains at each end.

    u is held fixed: of an end that moves something else is made.
    """
    highest, found = _highest(pieces), []
    for parameter in parameters:
        changes = [sp.diff(piece, parameter) for piece in pieces]
        for piece in changes:
            found += _derivatives(piece, sp.Integer(0), highest)
        for (below, above), end in zip(pairwise(changes), ends, strict=True):
            found += _derivatives(above - below, end, highest)
    return tuple(found)


def _highest(pieces: Sequence[sp.Expr]) -> int:
    """The highest power of u."""
    return max(0, *(int(sp.degree(piece, u)) for piece in pieces if piece.has(u)))


def _derivatives(f: sp.Expr, at: sp.Expr, highest: int) -> list[sp.Expr]:
    return [sp.horner(sp.diff(f, u, order), u).subs(u, at) for order in range(highest + 1)]
