"""Step 3 for the higher harmonics of the restoring force, which averaging leaves out and the second approximation uses.

In:  the pieces of a force and their breakpoints, as in `restoring` and `elliptic`.
Out: `Harmonics`: for each harmonic n of `HARMONICS`

         h_n = -(1/pi) int_0^{2 pi} f(A cos psi) cos(n psi) dpsi

     and its derivatives with respect to A, in forms for each regime; h_1 is the averaged force h.

With s = cos psi = sin t the weight is Chebyshev's polynomial, cos(n psi) = T_n(s). A piece that holds up to |u| = b
differs from the next by g, and that difference is all that a passed breakpoint adds:

    h_n = -(4/pi) [int_0^(pi/2) f_last(A s) T_n dt + sum over passed b int_0^theta g(A s) T_n dt],  sin(theta) = b/A

    d/dA int g^(j)(A s) s^j T_n dt = int g^(j+1)(A s) s^(j+1) T_n dt - g^(j)(b) (b/A)^j T_n(b/A) b/(A root)

A linear piece has no higher harmonic: T_n is orthogonal to s. Where another piece than the last is linear it is the
one to stand for the whole cycle: differences beyond it count from theta to pi/2, with the other sign.

Where f is smooth over the whole cycle, n integrations by parts leave terms of one sign, for a force whose derivatives
have one:

    int_0^(pi/2) f(A s) T_n dt = A^n/(2n - 1)!! int_0^(pi/2) f^(n)(A s) cos^(2n) t dt
"""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import sympy as sp
from flint import arb, ctx, fmpq

from ..paper.restoring_force import (
    END,
    GAINED,
    ORDERS,
    ROOT,
    Case,
    End,
    Regime,
    at_breakpoint,
    at_end,
    forms,
    moment_parts,
    odd_moment,
    quarter_moment,
)
from ..symbols import A, u
from .elliptic import DIGITS, MODERATE, Corner, Let, coefficients, corner, digits, gauss
from .repeated import Repeated

#: the harmonics of the spring that are kept: with the next two as well the largest errors of jumps stayed the same
HARMONICS = (3, 5)
#: points of the midpoint rule on a quarter cycle; the worst point is A = u_cr = MODERATE
MIDPOINTS = 20
#: nodes of Gauss's rule on 0 < t < theta: more than averaging takes, as T_5 swings
NODES = 21


@dataclass(frozen=True)
class Harmonics:
    """The higher harmonics of a force.

    cases  -- forms to evaluate; `derivatives` of a regime list h_3, its derivatives to order `ORDERS`, then h_5, ...
    domain -- where they hold, in words
    most   -- largest breakpoint for which they do
    """

    cases: tuple[Case, ...]
    domain: str
    most: sp.Expr


def chebyshev(n: int, s: sp.Expr) -> sp.Expr:
    """cos(n psi) in s = cos psi."""
    return sp.chebyshevt(n, s)


@functools.cache
def powers_of(n: int, degree: int) -> list[tuple[int, sp.Integer]]:
    """s^degree T_n(s) as powers of s and their coefficients."""
    s = sp.Symbol("s")
    return [(power, coefficient) for (power,), coefficient in sp.Poly(s**degree * chebyshev(n, s), s).terms()]


@functools.cache
def weighted(n: int, degree: int) -> tuple[sp.Rational, sp.Poly]:
    """The rational a and the even polynomial P with int_0^theta s^degree T_n(s) dt = a theta - x y P(x), degree odd."""
    secular, polynomial = sp.Integer(0), sp.Poly(0, sp.Symbol("x", positive=True))
    for power, coefficient in powers_of(n, degree):
        factor, rest = moment_parts(power)
        secular += coefficient * factor
        polynomial += coefficient * rest
    return secular, polynomial


@functools.cache
def _degrees(piece: sp.Expr) -> list[tuple[int, sp.Expr]]:
    return [(degree, coefficient) for (degree,), coefficient in sp.Poly(piece, u).terms() if coefficient != 0]


def boundary(n: int, order: int, times: int, lost: sp.Expr, b: sp.Expr, root: sp.Symbol) -> sp.Expr:
    """What an order-th derivative gets from the end of the interval: g^(order)(b) (b/A)^order T_n(b/A) dtheta/dA.

    times -- how often that is derived by A
    """
    of_any_end = GAINED * (END / A) ** order * chebyshev(n, END / A) * END / (A * ROOT)
    return at_end(of_any_end, times, -lost, b, root)


def derivatives_of(
    n: int, under: Sequence[sp.Expr], ends: Sequence[tuple[sp.Expr, sp.Symbol, Sequence[sp.Expr]]]
) -> tuple[sp.Expr, ...]:
    """h_n and its derivatives from the integrals, and from each end, its root and what is lost there, by order."""
    result = []
    for order, integral in enumerate(under):
        total = integral
        for b, root, losses in ends:
            for lower in range(order):
                total += boundary(n, lower, order - 1 - lower, losses[lower], b, root)
        result.append(-4 * total / sp.pi)
    return tuple(result)


# --- polynomial pieces ---


def polynomial_regime(pieces: Sequence[sp.Expr], breakpoints: Sequence[sp.Symbol], count: int, far: int) -> Regime:
    """The harmonics where A exceeds `count` breakpoints, `far` of them by far: closed forms, and series there."""
    ends = [End(b, f"_{k + 1}" if count > 1 else "", k < far) for k, b in enumerate(breakpoints[:count])]
    jumps = [sp.expand(pieces[k] - pieces[k + 1]) for k in range(count)]
    # the piece that stands for the whole cycle: a linear one if there is any, the last one of these
    whole_cycle = max((k for k in range(count + 1) if sp.Poly(pieces[k], u).monoms() == [(1,)]), default=count)
    outward = [k >= whole_cycle for k in range(count)]
    degrees = sorted({degree for jump in jumps for degree, _ in _degrees(jump)})
    lets: list[Let] = []
    for end in ends:
        even = range(2, max(degrees) + max(HARMONICS) + 1, 2) if end.far else ()
        odd = {power for degree in degrees if degree % 2 == 0 for n in HARMONICS for power, _ in powers_of(n, degree)}
        lets += end.lets([*even, *sorted(odd)])
    for n in HARMONICS:
        for end, beyond in zip(ends, outward, strict=True):
            value = _moment_beyond if beyond else _moment_value
            lets += [(_moment(end, n, degree), value(end, n, degree)) for degree in degrees]
    near = tuple(replace(end, far=False) for end in ends)
    derivatives = _in_moments(pieces[whole_cycle], tuple(jumps), tuple(outward), near)
    return Regime(tuple(breakpoints[:count]), tuple(breakpoints[:far]), tuple(lets), derivatives)


@functools.cache
def _in_moments(
    whole_cycle: sp.Expr, jumps: tuple[sp.Expr, ...], outward: tuple[bool, ...], ends: tuple[End, ...]
) -> tuple[sp.Expr, ...]:
    """The derivatives of a `polynomial_regime`, in moments: these alone depend on which ends are exceeded by far."""
    derivatives: list[sp.Expr] = []
    of_ends = [
        (end.b, end.root, [at_breakpoint(sp.diff(jump, u, k), end.b) for k in range(ORDERS)])
        for end, jump in zip(ends, jumps, strict=True)
    ]
    for n in HARMONICS:

        def under(order: int, n: int = n) -> sp.Expr:
            whole = sum(c * sp.ff(d, order) * A ** (d - order) * _quarter(n, d) for d, c in _degrees(whole_cycle))
            passed = sum(
                (-c if beyond else c) * sp.ff(d, order) * A ** (d - order) * _moment(end, n, d)
                for end, jump, beyond in zip(ends, jumps, outward, strict=True)
                for d, c in _degrees(jump)
            )
            return whole + passed

        found = derivatives_of(n, [under(order) for order in range(ORDERS + 1)], of_ends)
        derivatives += [sp.factor_terms(value) if ends else sp.horner(sp.expand(value), A) for value in found]
    return tuple(derivatives)


def _moment(end: End, n: int, degree: int) -> sp.Symbol:
    """int s^degree T_n(s) dt on one side of theta"""
    return end.symbol(f"W{n}_{degree}")


@functools.cache
def _quarter(n: int, degree: int) -> sp.Expr:
    """int_0^(pi/2) s^degree T_n(s) dt"""
    return sp.Add(*(coefficient * quarter_moment(power) for power, coefficient in powers_of(n, degree)))


def _moment_beyond(end: End, n: int, degree: int) -> sp.Expr:
    """int_theta^(pi/2) s^degree T_n(s) dt"""
    x, y = end.symbol("x"), end.symbol("y")
    if degree % 2 == 0:
        polynomial = sum((c * odd_moment(power).as_expr() for power, c in powers_of(n, degree)), sp.Integer(0))
        return y * sp.horner(polynomial).subs(sp.Symbol("x", positive=True), x)
    secular, rest = weighted(n, degree)
    closed = x * y * sp.horner(rest.as_expr()).subs(rest.gen, x)
    if secular == 0:
        return closed
    if end.far:
        return _quarter(n, degree) - sum(c * end.from_zero(power) for power, c in powers_of(n, degree))
    return secular * end.symbol("psi_0") + closed


def _moment_value(end: End, n: int, degree: int) -> sp.Expr:
    """int_0^theta s^degree T_n(s) dt"""
    moments = sum(coefficient * end.from_zero(power) for power, coefficient in powers_of(n, degree))
    if degree % 2 == 0:
        return moments
    secular, polynomial = weighted(n, degree)
    if end.far and secular != 0:
        return moments
    x, y = end.symbol("x"), end.symbol("y")
    return secular * end.symbol("theta") - x * y * sp.horner(polynomial.as_expr()).subs(polynomial.gen, x)


def of_polynomials(pieces: Sequence[sp.Expr], breakpoints: Sequence[sp.Symbol]) -> Harmonics:
    """The harmonics of a piecewise odd polynomial."""
    cases = tuple(
        Case(name, guards, polynomial_regime(pieces, breakpoints, count, far))
        for name, guards, count, far in forms(breakpoints)
    )
    return Harmonics(cases, "A >= 0", sp.oo)


# --- the untruncated force ---


def _rational(order: int) -> tuple[sp.Expr, int]:
    """P and q of the order-th derivative P(u)/Delta^q of u/Delta, Delta = sqrt(1 - u^2)."""
    numerator, q = sp.Poly(u, u), 1
    for _ in range(order):
        numerator, q = sp.Poly(sp.diff(numerator, u) * (1 - u**2) + q * u * numerator, u), q + 2
    if any(sign < 0 for sign in numerator.coeffs()):
        raise ArithmeticError("the derivatives of u/sqrt(1 - u^2) have terms of both signs")
    return sp.horner(numerator.as_expr(), u), q


@functools.cache
def midpoints(nodes: int) -> tuple[tuple[sp.Rational, sp.Rational], ...]:
    """sin t and cos t at the midpoints of `nodes` equal parts of 0 < t < pi/2, to `DIGITS` digits."""
    angles = [fmpq(2 * k + 1, 4 * nodes) for k in range(nodes)]
    with ctx.workprec(4 * DIGITS):
        return tuple((digits(arb.sin_pi_fmpq(angle)), digits(arb.cos_pi_fmpq(angle))) for angle in angles)


def _moment_of(n: int, j: int) -> sp.Symbol:
    """int f^(n + j)(A s) s^j cos^(2n) t dt"""
    return sp.Symbol(f"moment_{n}_{j}", positive=True)


@functools.cache
def _at_midpoint() -> Repeated:
    """The terms of all these integrals at one point."""
    s, cosine, v, delta = sp.symbols("s cosine v delta", positive=True)
    outputs = []
    for n in HARMONICS:
        for j in range(ORDERS + 1):
            numerator, q = _rational(n + j)
            outputs.append((_moment_of(n, j), s**j * cosine ** (2 * n) * numerator.subs(u, v) / delta**q))
    return Repeated(
        "midpoint",
        "Terms of int f^(n + j)(A s) s^j cos^(2n) t dt at a point, by n, then by j.",
        (s, cosine, A),
        ((v, s * A), (delta, sp.sqrt((1 - v) * (1 + v)))),
        tuple(outputs),
    )


def untruncated_attached(b: sp.Expr) -> Regime:
    """A <= u_cr: f is smooth over the cycle, and every derivative of u/Delta is positive for u > 0.

    The integrand is periodic: the midpoint rule leaves out harmonics of `MIDPOINTS` times four and above only.
    """
    terms = _at_midpoint()
    lets: list[Let] = []
    sums = []
    for k, point in enumerate(midpoints(MIDPOINTS), start=1):
        sums.append([sp.Symbol(f"{name}_{k}", positive=True) for name, _ in terms.outputs])
        lets += terms.at((*point, A), sums[-1])
    lets += [(name, sp.Add(*column)) for (name, _), column in zip(terms.outputs, zip(*sums, strict=True), strict=True)]
    derivatives = []
    for n in HARMONICS:
        moments = [_moment_of(n, j) for j in range(ORDERS + 1)]
        scale = -2 * b / (MIDPOINTS * sp.factorial2(2 * n - 1))
        for order in range(ORDERS + 1):
            # Leibniz's rule on A^n times the integral
            derivatives.append(
                scale
                * sum(
                    math.comb(order, j) * sp.ff(n, order - j) * A ** (n - order + j) * moments[j]
                    for j in range(order + 1)
                )
            )
    return Regime((), (), tuple(lets), tuple(derivatives))


def _under(n: int, order: int) -> sp.Symbol:
    """int g^(order)(A s) s^order T_n dt"""
    return sp.Symbol(f"sum_{n}_{order}", real=True)


@functools.cache
def _at_node(end: sp.Symbol) -> Repeated:
    """The terms of all these integrals at a node x of Gauss's rule over 0 < t < theta, in tan(t/2)."""
    arguments = sp.symbols("x x2 less weight T T2 c", positive=True)
    x, x2, less, weight, T, T2, c = arguments
    g, s, v, square, delta, below, above, scale = sp.symbols("g s v square delta below above scale", positive=True)
    inverse = sp.Symbol("inverse", real=True)
    lets = (
        (g, 1 / (1 + x2 * T2)),
        (s, 2 * x * T * g),
        (v, A * s),
        (square, (1 - v) * (1 + v)),
        (delta, sp.sqrt(square)),
        # u_cr - u and u_cr + u over u_cr: in this form nothing cancels at the end of the interval
        (below, less * (1 - x * T2) * g),
        (above, 1 + x * (1 + T2) * g),
        # 1/Delta - 1/c
        (inverse, -(end**2) * below * above / (c * delta * (c + delta))),
        (scale, 2 * weight * T * g),
    )
    # the slope is 1/Delta^3 - 1/c = u^2/Delta^3 + 1/Delta - 1/c
    values = [v * inverse, s * (v**2 / (square * delta) + inverse)]
    for order in range(2, ORDERS + 1):
        numerator, q = _rational(order)
        values.append(s**order * numerator.subs(u, v) / (square ** ((q - 1) // 2) * delta))
    return Repeated(
        "harmonic_node",
        "Terms of int g^(j)(A s) s^j T_n dt at a node, by n, then by j.",
        (*arguments, A, end),
        lets,
        tuple(
            (_under(n, order), scale * value * sp.horner(chebyshev(n, s)))
            for n in HARMONICS
            for order, value in enumerate(values)
        ),
    )


def untruncated_detached(b: sp.Expr, corner_: Corner) -> Regime:
    """A > u_cr: b u (1/Delta - 1/c), c = sqrt(1 - u_cr^2), over 0 < t < theta."""
    end = corner_.name
    root = sp.Symbol("root", nonnegative=True)
    c, T, T2 = sp.symbols("c T T2", positive=True)
    lets: list[Let] = [
        (end, corner_.value),
        (c, corner_.height),
        (root, sp.sqrt((A - end) * (A + end))),
        (T, end / (A + root)),
        (T2, T**2),
    ]
    terms = _at_node(end)
    known = {symbol.name: symbol for symbol in (A, T, T2, c, end)}
    sums = []
    for k, (x, weight) in enumerate(gauss(NODES), start=1):
        at = known | {"x": x, "x2": x**2, "less": 1 - x, "weight": weight}
        sums.append([sp.Symbol(f"{name}_{k}", real=True) for name, _ in terms.outputs])
        lets += terms.at([at[name.name] for name in terms.arguments], sums[-1])
    lets += [
        (name, sp.Add(*column[::-1])) for (name, _), column in zip(terms.outputs, zip(*sums, strict=True), strict=True)
    ]
    derivatives: list[sp.Expr] = []
    for n in HARMONICS:
        names = [_under(n, order) for order in range(ORDERS + 1)]
        # of the force, of its slope 1/c^3 - 1/c = u_cr^2/c^3, and of its second derivative
        curvature, q = _rational(2)
        jumps = [sp.Integer(0), end**2 / c**3, curvature.subs(u, end) / c**q]
        derivatives += [b * value for value in derivatives_of(n, names, [(end, root, jumps)])]
    return Regime((end,), (), tuple(lets), tuple(derivatives))


def of_untruncated(pieces: Sequence[sp.Expr], breakpoints: Mapping[sp.Symbol, sp.Expr]) -> Harmonics:
    """The harmonics of the force of `elliptic`, by Gauss's rule; its pieces' ends come in a parameter."""
    _, b = coefficients(pieces[0])
    ((name, value),) = breakpoints.items()
    cases = (
        Case("passed_0", ((A, value),), untruncated_attached(b)),
        Case("passed_1", (), untruncated_detached(b, corner(name, value))),
    )
    return Harmonics(cases, f"A >= 0, {name} <= {MODERATE}", MODERATE)
