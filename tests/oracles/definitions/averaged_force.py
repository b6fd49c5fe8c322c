"""The averaged force by quadrature of the pieces, its derivatives by numerical differentiation, and its harmonics."""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Callable, Sequence

from flint import arb, arb_series, ctx
from mpmath import mp, mpf

from derivations.mechanisms import all_mechanisms
from tests.oracles.definitions.along import LOCI
from tests.oracles.definitions.forces import rod_coefficients, untruncated_coefficients
from tests.oracles.definitions.points import Definitions, Function
from tests.oracles.definitions.resultants import detachment, of_reals
from tests.oracles.definitions.slow_flow import SLOW_FLOW
from tests.oracles.stated import Stated

#: mechanisms whose definitions are typed here
TYPED = ("duffing", "rod_spring", "rod_spring_untruncated")
ASIDE = mpf(10) ** -40


@functools.cache
def stated(name: str) -> Stated | None:
    """What the file of another mechanism says."""
    return None if name in TYPED else Stated(next(one for one in all_mechanisms() if one.name == name))


def pieces(name: str, p: Sequence):
    """The whole restoring force, piece by piece, and where the pieces end."""
    if other := stated(name):
        return other.pieces(p)
    if name == "duffing":
        alpha, beta, gamma = p
        return [lambda u: alpha * u + beta * u**3 + gamma * u**5], []
    if name == "rod_spring_untruncated":
        alpha, beta, delta_h = p
        # the rod's end has drawn back by delta_h
        u_cr = mp.sqrt(delta_h * (2 - delta_h))
        return [lambda u: alpha * u + 2 * beta * u * (1 / mp.sqrt(1 - u**2) - 1), lambda u: u], [u_cr]
    alpha, beta, gamma, u_cr = p
    return [lambda u: alpha * u + beta * u**3 + gamma * u**5, lambda u: u], [u_cr]


def joined(name: str, p: Sequence):
    """The pieces once their end is exceeded. The untruncated force is continuous there: alpha follows from the rest."""
    forces, ends = pieces(name, p)
    if name == "rod_spring_untruncated":
        beta, (u_cr,) = p[1], ends
        below = lambda u: u + 2 * beta * u * (1 / mp.sqrt(1 - u**2) - 1 / mp.sqrt(1 - u_cr**2))  # noqa: E731
        forces = [below, *forces[1:]]
    return forces, ends


@functools.cache
def gauss(count: int) -> list[tuple[arb, arb]]:
    """Nodes and weights on [0, 1]."""
    pairs = [arb.legendre_p_root(count, k, weight=True) for k in range(count)]
    return [((1 + x) / 2, w / 2) for x, w in pairs]


def derivatives(taylor: arb_series) -> list:
    """The value and three derivatives from a Taylor series."""
    values = []
    for k in range(4):
        man, exp = (int(part) for part in taylor[k].mid().man_exp())
        values.append(mp.factorial(k) * mp.ldexp(man, exp))
    return values


def ball(x) -> arb:
    """A number of mpmath, exactly."""
    sign, man, exp, _ = mpf(x)._mpf_
    return arb((-int(man) if sign else int(man), int(exp)))


def harmonic_by_quadrature(name: str, n: int, passed: int, A, *p) -> list:
    """-(1/pi) int_0^{2 pi} f(A cos psi) cos(n psi) dpsi and derivatives, f less u where it is typed here.

    By Gauss's rule on Taylor series in A, on panels that get finer towards u_cr, where the untruncated force is steep;
    in balls, because mpmath takes seconds for these.
    """
    before, ctx.cap = ctx.cap, 4
    amplitude = arb_series([ball(A), 1])
    if other := stated(name):
        taylor = harmonic_of_polynomials(other, n, passed, amplitude, [ball(x) for x in p])
        ctx.cap = before
        # what rounding leaves of a zero: a linear piece has no harmonics
        return [value * (not taylor[k].contains(0)) for k, value in enumerate(derivatives(taylor))]
    forces = {
        **dict.fromkeys(("duffing", "rod_spring"), lambda u, q: q[0] * u + q[1] * u**3 + q[2] * u**5),
        "rod_spring_untruncated": lambda u, q: (q[0] - 2 * q[1]) * u + 2 * q[1] * u / (1 - u**2).sqrt(),
    }
    q = [ball(x) for x in p]
    if name == "rod_spring_untruncated" and passed:  # continuous at its end
        q[0] = 1 + 2 * q[1] - 2 * q[1] / (1 - q[2])
        q[2] = (q[2] * (2 - q[2])).sqrt()
    end = (q[-1] / amplitude).asin() if passed else arb_series([arb.pi() / 2])
    total = arb_series([0])
    panels = [*(1 - arb(4) ** -k for k in range(7)), arb(1)]
    for low, high in itertools.pairwise(panels):
        for x, w in gauss(64):
            t = end * (low + (high - low) * x)
            u = amplitude * t.sin()
            # u itself holds beyond the end
            total += end * ((high - low) * w) * (forces[name](u, q) - u) * (n * (arb.pi() / 2 - t)).cos()
    taylor = -4 / arb.pi() * total
    ctx.cap = before
    return derivatives(taylor)


def harmonic_of_polynomials(other: Stated, n: int, passed: int, amplitude: arb_series, q: list[arb]) -> arb_series:
    """The same for polynomial pieces, each over its part of the cycle."""
    polynomials, ends = other.polynomials(q), other.pieces(q)[1]
    cuts = [arb_series([0]), *((b / amplitude).asin() for b in ends[:passed]), arb_series([arb.pi() / 2])]
    total = arb_series([0])
    for polynomial, start, end in zip(polynomials, cuts, cuts[1:], strict=False):
        for x, w in gauss(64):
            t = start + (end - start) * x
            u = amplitude * t.sin()
            force = sum((c * u**k for k, c in polynomial.items()), arb_series([0]))
            total += (end - start) * w * force * (n * (arb.pi() / 2 - t)).cos()
    return -4 / arb.pi() * total


def changes(name: str, passed: int, A, averaged: Sequence, *p) -> list:
    """By quadratures for parameters on either side. The untruncated force is linear but for what beta multiplies:
    of beta by its term of the averages, which the kernel is a function of.
    """
    found = []
    for k, value in enumerate(p):
        if name == "rod_spring_untruncated" and k == 1:
            rest = [-(1 if passed else p[0]) * linear for linear in (A, 1, 0)]
            found += [(whole - own) / value for whole, own in zip(averaged, rest, strict=True)]
            continue
        with mp.workdps(200):
            before, ctx.prec = ctx.prec, 600
            step = ASIDE * (abs(value) or 1)
            low, high = (
                harmonic_by_quadrature(name, 1, passed, A, *p[:k], value + side, *p[k + 1 :])[:3]
                for side in (-step, step)
            )
            ctx.prec = before
            # what rounding leaves of a zero
            found += [
                (b - a) / (2 * step) if abs(b - a) > abs(a) * mpf(10) ** -130 else mpf(0)
                for a, b in zip(low, high, strict=True)
            ]
    return found


def doubles_at_ends(name: str, p: Sequence[float]) -> list[float]:
    """The doubles next to the breakpoints, which stand for them."""
    if name == "rod_spring_untruncated":
        return [math.sqrt(2 * p[2] - p[2] ** 2)]
    return list(map(float, pieces(name, p)[1]))


def steps(name: str, *q) -> list:
    """The force and its derivatives at 0, what they gain at each end of a piece, and those of the last piece at 0."""
    forces, ends = pieces(name, q)
    gains = [(forces[0], mpf(0))]
    gains += [(lambda u, k=k: forces[k + 1](u) - forces[k](u), end) for k, end in enumerate(ends)]
    return [value for gain, at in [*gains, (forces[-1], mpf(0))] for value in slopes_at(name, q, gain, at)]


def steps_by(name: str, *q) -> list:
    """What each parameter does to the derivatives of each piece at 0, and to their gains at the ends, which stay."""
    ends, found = pieces(name, q)[1], []
    for i in range(len(q)):

        def by_parameter(u, k, i=i):
            return mp.diff(lambda value: pieces(name, (*q[:i], value, *q[i + 1 :]))[0][k](u), q[i])

        for k in range(len(ends) + 1):
            found += slopes_at(name, q, lambda u, k=k: by_parameter(u, k), mpf(0))
        for k, end in enumerate(ends):
            found += slopes_at(name, q, lambda u, k=k: by_parameter(u, k + 1) - by_parameter(u, k), end)
    return found


def slopes_at(name: str, q: Sequence, polynomial, at) -> list:
    """A polynomial of the force and its derivatives, from as many values as they need, by exact interpolation."""
    other = stated(name)
    degree = max(map(max, other.polynomials(q))) if other else 5
    nodes = [mpf(j) / 4 for j in range(1, degree + 2)]
    rows = mp.matrix([[node**k / mp.factorial(k) for k in range(degree + 1)] for node in nodes])
    found = mp.lu_solve(rows, mp.matrix([polynomial(at + node) for node in nodes]))
    return [mpf(0) if abs(value) < mpf(10) ** -45 else value for value in found]


def jumps(name: str, *q) -> list:
    """f below each breakpoint less f above."""
    forces, ends = joined(name, q)
    return [below(b) - above(b) for below, above, b in zip(forces, forces[1:], ends, strict=False)]


def hardening(name: str, *q) -> list:
    """f(u)/u rises where none is negative: coefficients of its slope, but the first, or the steep part's."""
    if other := stated(name):
        return other.hardening(q)
    if name == "rod_spring_untruncated":
        return [2 * q[1]]
    return [*q[1:3], *(-jump for jump in jumps(name, *q))]


def of_force(name: str, kernel: str, passed: int = 0) -> Function:
    """What a mechanism says of its force, from the pieces as defined; `force` with so many ends exceeded."""
    if kernel == "coefficients":
        return coefficients(name)
    if kernel == "breakpoints":
        return lambda *q: list(pieces(name, q)[1])
    if kernel in BY_PARAMETERS:
        return functools.partial(BY_PARAMETERS[kernel], name)
    _, piece, *slope = (f"force_{passed + 1}" if kernel == "force" else kernel).split("_")

    def f(u, *q):
        return pieces(name, q)[0][int(piece) - 1](u)

    return (lambda u, *q: [mp.diff(lambda x: f(x, *q), u)]) if slope else (lambda *x: [f(*x)])


def coefficients(name: str) -> Function:
    """Parameters from a design."""
    other = stated(name)
    return other.coefficients if other else COEFFICIENTS[name]


def by_design(name: str, *design) -> list:
    """Derivatives of each parameter, then of each breakpoint, by each number of a design."""

    def all_of(*x):
        parameters = coefficients(name)(*x)
        return [*parameters, *pieces(name, parameters)[1]]

    orders = [tuple(int(k == n) for n in range(len(design))) for k in range(len(design))]
    return [
        mp.chop(mp.diff(lambda *x, j=j: all_of(*x)[j], design, order), tol=mpf(10) ** -42)
        for j in range(len(all_of(*design)))
        for order in orders
    ]


BY_PARAMETERS = {"jumps": jumps, "hardening": hardening, "steps": steps, "steps_by": steps_by, "by_design": by_design}
COEFFICIENTS = {
    "rod_spring": rod_coefficients,
    "rod_spring_untruncated": untruncated_coefficients,
    "duffing": lambda *design: [*design],
}


def composed(kernel: str, names: Sequence[str], averages: Callable) -> Function:
    """A function of the slow flow with the mechanism put in: its averages at an amplitude and the parameters."""
    arguments, f = COMPOSED[kernel]

    def of(*x):
        known = dict(zip(names, x, strict=False))
        known["m"] = 4 * known.get("mu", mpf(0)) / mp.pi
        if "h" in arguments.split():
            found = averages(known["A"], *x[len(names) :])
            known |= zip(("h", "h_A", "h_AA", "h_AAA"), found, strict=True)
        return f(*(known[argument] for argument in arguments.split()))

    return of


#: functions of the slow flow that mechanisms have
COMPOSED: Definitions = SLOW_FLOW | {"level": LOCI["level"], "detachment": ("A m zeta h", of_reals(detachment))}
#: several averages at once
TOGETHER = {
    "averaged": ("h", "h_A", "h_AA", "h_AAA"),
    "averaged_2": ("h", "h_A"),
    "averaged_H": ("H", "H_A"),
    "averaged_all": ("h", "h_A", "h_AA", "h_AAA", "H", "H_A", "intercept"),
}
