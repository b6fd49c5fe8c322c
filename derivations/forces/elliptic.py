"""Step 3 for a force that is not truncated, equations (5), (20), (31): averages that are elliptic integrals.

In:  two pieces of a force, u (a_1 + b (1/sqrt(1 - u^2) - 1)) up to |u| = u_cr and a_2 u beyond, continuous at u_cr, and
     u_cr in a parameter that says sqrt(1 - u_cr^2) without a difference.
Out: `Restoring`: H and its derivatives in closed form by Carlson's R_F and R_D, and the forms that are evaluated, each
     with the amplitudes and breakpoints for which it is meant.

With t = pi/2 - psi, m = A^2, Delta = sqrt(1 - m sin^2 t), c = sqrt(1 - u_cr^2) and sin(theta) = min(1, u_cr/A) the
average and its slope hold

    int sin^2 t/Delta   dt = (sin^3 theta/3) R_D(cos^2 theta, 1 - m sin^2 theta, 1)    and
    int sin^2 t/Delta^3 dt = (sin^3 theta/3) R_D(cos^2 theta, 1, 1 - m sin^2 theta)    over 0 < t < theta.

The closed form is a difference of nearly equal numbers wherever u is small: the force is u^3 there, the integrals are
not. And reducing the higher derivatives to the same two integrals divides by 1 - m, though nothing happens at A = 1.
What is evaluated instead has positive terms:

attached            theta = pi/2. K = pi/(2 M), M the limit of the arithmetic-geometric mean of 1 and sqrt(1 - m), and
                    with its differences c_n, B = int cos^2/Delta and D = int sin^2/Delta:
                    D - B = K sum 2^n c_n^2/m, 1 - M = sum c_n. So D - pi/4 is a sum without a difference.
detached            s = sin t is rational in tau = tan(t/2), and the integrands are even in it: Gauss's rule on
                    |tau| <= tan(theta/2). Their singularities tau = +-i and u = +-1 stay away for u_cr <= `MODERATE`,
                    and for u_cr <= `STEEPER` with more nodes.
steep               beyond, the duplication theorem of R_D, carried along with its derivatives by the second argument:
                    as R_D is completely monotone in it, each is a sum of terms of one sign, also across A = 1.
far                 where A^2 - u_cr^2 is no small part of 1 - u_cr^2 the derivatives differ little from their boundary
                    terms, unless A is varied where it stands beside u alone, in cos t: then all terms have one sign. By
                    either way.
at the end          the double next to u_cr stands for u_cr itself: what the corner is asked for is not what the force,
                    which is steep there, would be half a place beside it.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import sympy as sp
from flint import arb, ctx

from ..claims import claim
from ..paper.restoring_force import ORDERS, Case, Regime, Restoring, average, slope
from ..symbols import A, u
from .repeated import TURNS, Repeated

Let = tuple[sp.Symbol, sp.Expr]

#: amplitude up to which a mean of few steps serves
FEW = sp.Rational(7, 10)
#: breakpoint up to which Gauss's rule serves
MODERATE = sp.Rational(3, 4)
#: breakpoint up to which it serves with more nodes, where R_D would be a difference
STEEPER = sp.Rational(23, 25)
#: multiple of a breakpoint from which on it lies far below
AWAY = sp.Rational(21, 20)
#: and, for a steep one, the share of 1 - u_cr^2 which A^2 - u_cr^2 has there
AWAY_STEEP = sp.Rational(1, 4)
#: steps of the mean up to A = FEW, to the last double below 1, and to any u_cr: its differences fall quadratically
STEPS, STEPS_STEEP, STEPS_END = 4, 8, 9
#: nodes on 0 < tau < tan(theta/2); the worst point is A = u_cr = MODERATE, or STEEPER
NODES, NODES_STEEPER = 15, 24
#: duplications: each divides the spread of the arguments by 4, of which the sixth power is left out
DUPLICATIONS = 6
# digits of nodes and weights, more than a double holds
DIGITS = 40

#: Carlson's symmetric integrals of the first and of the second kind
R_F, R_D = sp.symbols("R_F R_D", cls=sp.Function)

ROOT = sp.sqrt(1 - u**2)


def coefficients(piece: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """a and b of a piece u (a + b (1/sqrt(1 - u^2) - 1)); an error if it is none."""
    inverse = sp.Symbol("inverse", positive=True)
    ratio = sp.expand(sp.expand(piece / u).subs(ROOT, 1 / inverse))
    if ratio.has(u) or sp.degree(ratio, inverse) > 1:
        raise ArithmeticError(f"no average is known for the force {piece}")
    b = ratio.coeff(inverse, 1)
    return sp.expand(ratio.coeff(inverse, 0) + b), b


def evaluable(piece: sp.Expr) -> sp.Expr:
    """A piece without the difference 1/sqrt(1 - u^2) - 1."""
    a, b = coefficients(piece)
    root = sp.sqrt((1 - u) * (1 + u))
    return u * (a + b * u**2 / (root * (1 + root))) if b != 0 else a * u


@dataclass(frozen=True)
class Corner:
    """Where the first piece ends, |u| = u_cr.

    name   -- u_cr
    value  -- u_cr in the parameter that says it
    height -- c = sqrt(1 - u_cr^2) in that parameter, without a root: no digit of it is lost as u_cr nears 1
    """

    name: sp.Symbol
    value: sp.Expr
    height: sp.Expr


def corner(name: sp.Symbol, value: sp.Expr) -> Corner:
    """From u_cr in a parameter, where 1 - u_cr^2 is a square, and 0 where u_cr is; an error otherwise."""
    base, exponent = sp.factor(1 - value**2).as_base_exp()
    if exponent != 2 or not base.is_polynomial():
        raise ArithmeticError(f"1 - {name}^2 has to be a square in the parameters, not {sp.factor(1 - value**2)}")
    (parameter,) = value.free_symbols
    height_0 = base.subs(parameter, 0)
    if value.subs(parameter, 0) != 0 or abs(height_0) != 1:
        raise ArithmeticError(f"{name} has to grow from 0 with {parameter}")
    return Corner(name, value, sp.expand(base * height_0))


# --- attached: the arithmetic-geometric mean ---


@functools.cache
def _mean() -> Repeated:
    """a_n, b_n and e_n = c_n/m from those before, e_1 + ... + e_n, and e_n^2 + e_(n-1)^2/2 + ... + e_1^2/2^(n-1)."""
    arguments = a, b, e, total, squares, quarter = sp.symbols("a b e total squares quarter", positive=True)
    mean, difference = sp.symbols("mean difference", positive=True)
    return Repeated(
        "means",
        "Steps of the arithmetic-geometric mean, with the sum of its differences and that of their squares by weight.",
        (*arguments, TURNS),
        ((mean, (a + b) / 2), (difference, quarter * e**2 / mean)),
        tuple(
            (sp.Symbol(f"next_{name}"), value)
            for name, value in (
                ("a", mean),
                ("b", sp.sqrt(a * b)),
                ("e", difference),
                ("total", total + difference),
                ("squares", squares / 2 + difference**2),
            )
        ),
    )


#: A^2 and 1 - A^2; the integrals of `attached`
_of_mean = sp.symbols("m k B C P", positive=True)


@functools.cache
def _of_attached() -> tuple[list[sp.Expr], sp.Expr]:
    """A^(order - 1) d^order/dA^order of A P, and the slope of A P less P, in closed form."""
    m, k, B, C, P = _of_mean

    def by_m(expression: sp.Expr) -> sp.Expr:
        """d/dm, where dD/dm = (B/(1 - m) - C)/2, dB/dm = C/2, dC/dm = (B/(1 - m)/2 - 2 C)/m."""
        B_m, P_m = C / 2, (B / (1 - m) - C) / 2
        C_m = (B / (2 * (1 - m)) - 2 * C) / m
        return sum(sp.diff(expression, x) * dx for x, dx in ((m, 1), (B, B_m), (C, C_m), (P, P_m)))

    def in_B_and_C(expression: sp.Expr) -> sp.Expr:
        """A sum of B, C and P, each times a polynomial in m over a power of k = 1 - m."""
        total = sp.Integer(0)
        for symbol in (B, C, P):
            numerator, denominator = sp.fraction(sp.cancel(sp.expand(expression).coeff(symbol, 1)))
            power = sp.degree(denominator, m)
            scale = sp.cancel(denominator / (1 - m) ** power)
            total += symbol * sp.horner(sp.expand(numerator / scale), m) / k**power
        return total

    # with d/dA = 2 A d/dm
    forms, current = [P], P
    for order in range(1, ORDERS + 1):
        # current stands for A^parity times a function of m
        odd = order % 2
        current = sp.cancel(current + 2 * m * by_m(current)) if odd else sp.cancel(2 * by_m(current))
        forms.append(in_B_and_C(current))
    return forms, 2 * m * in_B_and_C(by_m(P))


def attached(a: sp.Expr, b: sp.Expr, steps: int, end: Corner | None = None) -> Regime:
    """A <= u_cr: (4/pi) times B, C = (D - B)/m and P = D - pi/4 from the mean, and the derivatives in B and C.

    At the `end` A is u_cr.
    """
    m, k, B, C, P = _of_mean
    quarter, k_c, e, tau = sp.symbols("quarter k_c e tau", positive=True)
    a_1, b_1, e_1, square, total, squares = sp.symbols("a_1 b_1 e_1 square total squares", positive=True)
    last_a, last_b, last_e = (sp.Symbol(f"{name}_{steps - 1}", positive=True) for name in "abe")
    a_n, e_n = (sp.Symbol(f"{name}_{steps}", positive=True) for name in "ae")
    # up to FEW a rounding of m moves 1 - m by less than its own
    complement = 1 - m if steps == STEPS else (1 - A) * (1 + A)
    lets: list[Let] = [(m, A**2)]
    lets += [(k_c, end.height), (k, k_c**2)] if end else [(k_c, sp.sqrt(complement)), (k, complement)]
    # e_n = c_n/m; b_n is not called for
    lets += [(a_1, (1 + k_c) / 2), (b_1, sp.sqrt(k_c)), (e_1, 1 / (4 * a_1)), (square, e_1**2), (quarter, m / 4)]
    first, last = (a_1, b_1, e_1, e_1, square), (last_a, last_b, last_e, total, squares)
    lets += _mean().at((*first, quarter, sp.Integer(steps - 2)), last)
    lets += [
        (a_n, (last_a + last_b) / 2),
        (e_n, quarter * last_e**2 / a_n),
        (e, total + e_n),
        (tau, 2 ** (steps - 1) * squares + 2**steps * e_n**2),
        (P, m * (e + tau) / a_n),
        (B, (1 - m * tau) / a_n),
        (C, 2 * tau / a_n),
    ]
    forms, intercept = _of_attached()
    rest = [a * A, a, 0, 0]
    derivatives = [-(rest[n] + b * (forms[n] * A if n % 2 == 0 else forms[n])) for n in range(ORDERS + 1)]
    return Regime((), (), tuple(lets), tuple(derivatives), A * b * intercept)


# --- detached: Gauss's rule ---


def digits(ball: arb) -> sp.Rational:
    """A number that is known well enough, rounded to `DIGITS` digits."""
    scaled = (ball * arb(10) ** DIGITS + arb("0.5")).floor().unique_fmpz()
    return sp.Rational(int(scaled), 10**DIGITS)


@functools.cache
def gauss(nodes: int) -> tuple[tuple[sp.Rational, sp.Rational], ...]:
    """Positive nodes and their weights of Gauss's rule with 2 `nodes` on [-1, 1], to `DIGITS` digits."""
    with ctx.workprec(4 * DIGITS):
        pairs = [arb.legendre_p_root(2 * nodes, k, weight=True) for k in range(nodes)]
        return tuple((digits(x), digits(w)) for x, w in pairs)


# At a node of the rule: x, x^2, 1 - x and x (1 - x), which as differences of doubles would lose digits, and the weight;
# sqrt(1 - u_cr^2), tan^2(theta/2) and (2 A tan(theta/2))^2.
ON_ARC = sp.symbols("x X2 less both K c T2 U2", positive=True)
_x, _X2, _less, _both, _K, _c, _T2, _U2 = ON_ARC
#: the weight times x^2
_K2 = sp.Symbol("K2", positive=True)
_g, _v2, _square, _delta, _f, _fall, _q = sp.symbols("g v2 square delta f fall q", positive=True)
#: u = 2 A T v, sin t = 2 T v, dt = 2 T g dx
ON_NODE: tuple[Let, ...] = (
    (_g, 1 / (1 + _X2 * _T2)),
    (_v2, _X2 * _g**2),
    (_square, 1 - _U2 * _v2),
    (_delta, sp.sqrt(_square)),
    (_f, _K * _g * _v2 / _delta),
)
#: u_cr - u and u_cr + u over u_cr: in this form nothing cancels at the end of the interval
LESS: sp.Expr = _f * (_less - _both * _T2) * _g * (1 + (_x + _x * _T2) * _g) / (_c + _delta)
#: tan t = 2 tau/(1 - tau^2)
TANGENT: Let = (_q, 4 * _X2 * _T2 / (1 - _X2 * _T2) ** 2)


def _by_tangents(first: sp.Expr) -> tuple[tuple[Let, ...], tuple[Let, ...]]:
    """A let for a term, and it times powers of tan^2 t: W, Wq, Wq_2, Wq_3."""
    term = sp.Symbol("term", positive=True)
    names = ("W", "Wq", *(f"Wq_{n}" for n in range(2, ORDERS + 1)))
    return ((term, first),), tuple((sp.Symbol(name), term * _q**n) for n, name in enumerate(names))


def _node(name: str, doc: str, arguments: Sequence[sp.Symbol], lets: Sequence[Let], first: sp.Expr) -> Repeated:
    """A term at a node times powers of tan^2 t."""
    term, outputs = _by_tangents(first)
    return Repeated(name, doc, tuple(arguments), (*lets, *term, TANGENT), outputs)


NEAR = Repeated(
    "near_node",
    "Terms of int sin^2 (1/c - 1/Delta), sin^4/Delta^3, sin^4/Delta^5, sin^4 (1 + 4 u^2)/Delta^7 at a node.",
    ON_ARC,
    (*ON_NODE, (_fall, _f * _v2 / _square)),
    tuple(
        (sp.Symbol(name), value)
        for name, value in (
            ("W", LESS),
            ("V3", _fall),
            ("V5", _fall / _square),
            ("V7", _fall * (1 + 4 * _U2 * _v2) / _square**2),
        )
    ),
)
AFAR = _node("far_node", "Terms of int sin^2 tan^(2n) (1/c - 1/Delta) at a node, by n.", ON_ARC, ON_NODE, LESS)
OF_TANGENTS = {
    1: Repeated(
        "arc_node", "The term of int sin^2 at a node.", (_X2, _K2, _T2), ON_NODE[:1], ((sp.Symbol("W"), _K2 * _g**3),)
    ),
    ORDERS + 1: _node(
        "tangent_node", "Terms of int sin^2 tan^(2n) at a node, by n.", (_X2, _K2, _T2), ON_NODE[:1], _K2 * _g**3
    ),
}


class _Detached:
    """The quarter cycle's part 0 < t < theta, u_cr = A sin(theta)."""

    def __init__(self, end: Corner, steep: bool, nodes: int) -> None:
        self.b = b = end.name
        self.rule = gauss(nodes)
        self.root = sp.Symbol("root", nonnegative=True)
        self.c, self.T, self.T2 = sp.symbols("c T T2", positive=True)
        self.lets: list[Let] = [(b, end.value), (self.c, end.height)]
        self.lets += self._root(steep)
        self.lets += [
            # tan(theta/2)
            (self.T, b / (A + self.root)),
            (self.T2, self.T**2),
        ]

    def _root(self, steep: bool) -> list[Let]:
        """sqrt(A^2 - u_cr^2). Where u_cr is steep c says what its double lacks of it.

        A^2 - u_cr^2 is that of the double and what this lacks, but no less than half of the first: next to u_cr the
        double stands for it.
        """
        excess = (A - self.b) * (A + self.b)
        if not steep:
            return [(self.root, sp.sqrt(excess))]
        lacking, half = sp.Symbol("lacking", real=True), sp.Symbol("half", positive=True)
        return [
            (lacking, self.c**2 - (1 - self.b) * (1 + self.b)),
            (half, excess / 2),
            (self.root, sp.sqrt(2 * half + (sp.Abs(lacking + half) - sp.Abs(lacking - half)) / 2)),
        ]

    def by_gauss(self) -> tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]:
        """int sin^2 (1/c - 1/Delta), int sin^4/Delta^3, int sin^4/Delta^5, int sin^4 (1 + 4 u^2)/Delta^7."""
        scale = 32 * self.T**5
        return tuple(self._over_nodes(NEAR, (8 * self.T**3 * self.b**2 / self.c, scale, scale, scale)))

    def far_by_gauss(self) -> list[sp.Expr]:
        """int sin^2 tan^(2n) (1/c - 1/Delta) for n = 0, 1, ..."""
        return self._over_nodes(AFAR, [8 * self.T**3 * self.b**2 / self.c] * (ORDERS + 1))

    def _over_nodes(self, terms: Repeated, scales: Sequence[sp.Expr]) -> list[sp.Expr]:
        """Scaled sums over all nodes."""
        known = {_c: self.c, _T2: self.T2, _U2: _U2}
        if _U2 in terms.arguments:
            self.lets.append((_U2, (2 * A * self.T) ** 2))
        sums = []
        for k, (x, weight) in enumerate(self.rule, start=1):
            at = known | {_x: x, _X2: x**2, _less: 1 - x, _both: x * (1 - x), _K: weight, _K2: weight * x**2}
            heads = [name.name.partition("_") for name, _ in terms.outputs]
            names = [sp.Symbol(f"{head}_{k}{line}{power}", positive=True) for head, line, power in heads]
            self.lets += terms.at([at[name] for name in terms.arguments], names)
            sums.append(names)
        return self._summed(list(zip(*sums, strict=True)), scales)

    def _tangents_near_pole(self) -> list[sp.Symbol]:
        """int sin^2 tan^(2n) dt for n = 0, 1, ..., where tan(theta) is large, and each term beside the one before it.

        int tan^(2n) = tan^(2n-1)/(2n - 1) - int tan^(2n-2), sin^2 tan^(2n) = tan^(2n) - sin^2 tan^(2n-2).
        """
        theta, tangent = sp.symbols("theta tangent", positive=True)
        self.lets += [(theta, sp.atan2(self.b, self.root)), (tangent, self.b / self.root)]
        of_tangents = [theta]
        sums = list(sp.symbols(f"sum_0:{ORDERS + 1}", positive=True))
        self.lets.append((sums[0], (theta - self.b * self.root / A**2) / 2))
        for n in range(1, ORDERS + 1):
            of_tangents.append(sp.Symbol(f"tangents_{n}", positive=True))
            self.lets.append((of_tangents[n], tangent ** (2 * n - 1) / (2 * n - 1) - of_tangents[n - 1]))
            self.lets.append((sums[n], of_tangents[n] - sums[n - 1]))
        return sums

    def _summed(self, sums: Sequence[Sequence[sp.Expr]], scales: Sequence[sp.Expr]) -> list[sp.Expr]:
        """Scaled sums; their smallest terms first, which are those next to zero."""
        names = sp.symbols(f"sum_0:{len(sums)}", positive=True)
        self.lets += [(name, sp.Add(*terms[::-1])) for name, terms in zip(names, sums, strict=True)]
        return [scale * name for scale, name in zip(scales, names, strict=True)]

    def by_duplication(self) -> tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]:
        """The same, from R_D and its derivatives by the second argument."""
        V = self._moments(by_second=True)
        (moment,) = self._tangents(1)
        m = A**2
        return (
            moment / self.c - V[0],
            V[1],
            V[1] + m * V[2],
            V[1] + m * (6 * V[2] + 5 * m * V[3]),
        )

    def far_by_duplication(self) -> list[sp.Expr]:
        """The same, from R_D and its derivatives by the first argument."""
        Q = self._moments(by_second=False)
        return [s / self.c - q for s, q in zip(self._tangents(ORDERS + 1), Q, strict=True)]

    def closer_by_duplication(self) -> list[sp.Expr]:
        """The same where theta is near pi/2."""
        Q = self._moments(by_second=False)
        return [s / self.c - q for s, q in zip(self._tangents_near_pole(), Q, strict=True)]

    def _moments(self, by_second: bool) -> list[sp.Symbol]:
        """int sin^(2n+2)/Delta^(2n+1), or int sin^(2n+2)/(cos^(2n) Delta), for n = 0, 1, ...

        As 1/sqrt(1 - k sin^2) stands for either factor, they are derivatives of R_D, whose argument falls with k by
        sin^2(theta) dk.
        """
        x2, y2, third = sp.symbols("x2 y2 third", positive=True)
        self.lets += [(x2, (self.b / A) ** 2), (y2, (self.root / A) ** 2), (third, x2 * self.b / (3 * A))]
        r = _Taylor(self.lets).duplicated(y2, self.c**2, by_second)
        V = [sp.Symbol(f"V{2 * n + 2}", positive=True) for n in range(ORDERS + 1)]
        for n in range(ORDERS + 1):
            weight = math.factorial(n) / sp.rf(sp.Rational(1, 2), n)
            self.lets.append((V[n], third * (-x2) ** n * weight * r[n]))
        return V

    def _tangents(self, count: int) -> list[sp.Symbol]:
        """int sin^2 tan^(2n) dt for n = 0, 1, ..., by Gauss's rule."""
        return self._over_nodes(OF_TANGENTS[count], [8 * self.T**3] * count)


class _Taylor:
    """Truncated Taylor series in the second argument of R_D, as symbols; every operation adds lets."""

    def __init__(self, lets: list[Let]) -> None:
        self.lets = lets

    def named(self, name: str, values: Sequence[sp.Expr]) -> list[sp.Expr]:
        """Lets for coefficients that are no numbers."""
        result = []
        for k, value in enumerate(values):
            if value.is_number or value.is_Symbol:
                result.append(value)
                continue
            symbol = sp.Symbol(f"{name}_{k}", real=True)
            self.lets.append((symbol, value))
            result.append(symbol)
        return result

    def sqrt(self, name: str, f: Sequence[sp.Expr]) -> list[sp.Expr]:
        if f[1:] == [0] * ORDERS:
            return [*self.named(name, [sp.sqrt(f[0])]), *f[1:]]
        roots = self.named(name, [sp.sqrt(f[0])])
        (half,) = self.named(name + "_half", [1 / (2 * roots[0])])
        for k in range(1, ORDERS + 1):
            inner = sum(roots[i] * roots[k - i] for i in range(1, k))
            roots += [self.named(f"{name}{k}", [(f[k] - inner) * half])[0]]
        return roots

    def reciprocal(self, name: str, f: Sequence[sp.Expr]) -> list[sp.Expr]:
        result = self.named(name, [1 / f[0]])
        for k in range(1, ORDERS + 1):
            inner = sum(f[i] * result[k - i] for i in range(1, k + 1))
            result += [self.named(f"{name}{k}", [-result[0] * inner])[0]]
        return result

    def duplicated(self, x: sp.Expr, y: sp.Expr, by_second: bool) -> list[sp.Expr]:
        """Taylor coefficients of R_D(x, y, 1) by y or by x (DLMF 19.26.20, 19.36.2)."""
        zeros = [sp.Integer(0)] * ORDERS
        varied = [sp.Integer(1), *zeros[1:]]
        X = self.named("X", [x]) + (zeros if by_second else varied)
        Y = self.named("Y", [y]) + (varied if by_second else zeros)
        # in the first duplication most coefficients are 0 or 1
        X, Y, Z, term = self.once_duplicated(X, Y, [sp.Integer(1), *zeros], "0")
        R = _series("R")
        self.lets += _duplications().at((*X, *Y, *Z, *term), R)
        return R

    def once_duplicated(
        self, X: Sequence[sp.Expr], Y: Sequence[sp.Expr], Z: Sequence[sp.Expr], n: str = ""
    ) -> tuple[list[sp.Expr], ...]:
        """The arguments after a duplication, and what it takes off, over 3; `n` stands behind all names."""
        a, b, c = self.sqrt(f"a{n}", X), self.sqrt(f"b{n}", Y), self.sqrt(f"c{n}", Z)
        lam = self.named(f"lam{n}", _plus(_times(a, b), _times(c, _plus(a, b))))
        below = self.named(f"below{n}", _times(c, self.named(f"q{n}", _plus(Z, lam))))
        term = self.reciprocal(f"term{n}", below)
        X, Y, Z = (
            self.named(f"{name}{n}", [(p + q) / 4 for p, q in zip(values, lam, strict=True)])
            for name, values in (("X", X), ("Y", Y), ("Z", Z))
        )
        return X, Y, Z, term

    def remainder(self, X: Sequence[sp.Expr], Y: Sequence[sp.Expr], Z: Sequence[sp.Expr]) -> list[sp.Expr]:
        """R_D of arguments that are nearly equal, by its Taylor polynomial about their mean."""
        mean = self.named("mean", [(p + q + 3 * s) / 5 for p, q, s in zip(X, Y, Z, strict=True)])
        over = self.reciprocal("over", mean)
        dx, dy = (self.named(name, _times(_minus(mean, f), over)) for name, f in (("dx", X), ("dy", Y)))
        dz = self.named("dz", [-(p + q) / 3 for p, q in zip(dx, dy, strict=True)])
        xy, zz = self.named("xy", _times(dx, dy)), self.named("zz", _times(dz, dz))
        E2 = self.named("E2", [p - 6 * q for p, q in zip(xy, zz, strict=True)])
        E3 = self.named("E3", _times([3 * p - 8 * q for p, q in zip(xy, zz, strict=True)], dz))
        E4 = self.named("E4", _times([3 * (p - q) for p, q in zip(xy, zz, strict=True)], zz))
        E5 = self.named("E5", _times(_times(xy, zz), dz))
        numbers = ((-3, 14, E2), (1, 6, E3), (9, 88, _times(E2, E2)), (-3, 22, E4), (-9, 52, _times(E2, E3)))
        series = [sp.Integer(1), *[sp.Integer(0)] * ORDERS]
        for p, q, values in (*numbers, (3, 26, E5)):
            series = _plus(series, [sp.Rational(p, q) * value for value in values])
        series = self.named("series", series)
        return _times(series, self.named("power", _times(over, self.sqrt("sq", over))))


def _series(name: str) -> list[sp.Symbol]:
    """Coefficients of a series."""
    return [sp.Symbol(f"{name}_{k}", real=True) for k in range(ORDERS + 1)]


def _repeated(
    name: str, doc: str, arguments: Sequence[Sequence[sp.Expr]], lets: list[Let], **out: Sequence[sp.Expr]
) -> Repeated:
    """What is computed from series of these names, and which series that gives, by their names."""
    named = (let for series, value in out.items() for let in zip(_series(series), value, strict=True))
    return Repeated(name, doc, tuple(one for f in arguments for one in f), tuple(lets), tuple(named))


@functools.cache
def _duplication() -> Repeated:
    lets: list[Let] = []
    arguments = x, y, z, total = [_series(name) for name in ("x", "y", "z", "total")]
    X, Y, Z, term = _Taylor(lets).once_duplicated(x, y, z)
    # what the n-th takes off weighs 4^-n: so the sum stands for 4^n of it
    total = _plus([4 * value for value in total], term)
    doc = "Duplications of the arguments of R_D, and the sum of what they take off over 3, as Taylor series."
    return _repeated("duplication", doc, (*arguments, [TURNS]), lets, next_X=X, next_Y=Y, next_Z=Z, next_total=total)


@functools.cache
def _duplications() -> Repeated:
    lets: list[Let] = []
    first = [_series(name) for name in ("X0", "Y0", "Z0", "term0")]
    X, Y, Z, total, last = (_series(name) for name in ("X", "Y", "Z", "total", "last"))
    arguments = [one for f in first for one in f]
    lets += _duplication().at((*arguments, sp.Integer(DUPLICATIONS - 1)), (*X, *Y, *Z, *total))
    lets += _remainder().at((*X, *Y, *Z), last)
    R = [sp.Rational(3, 4 ** (DUPLICATIONS - 1)) * p + q / 4**DUPLICATIONS for p, q in zip(total, last, strict=True)]
    doc = "R_D by what one duplication has made of its arguments and has taken off, as a Taylor series."
    return _repeated("duplications", doc, first, lets, R=R)


@functools.cache
def _remainder() -> Repeated:
    lets: list[Let] = []
    arguments = tuple(map(_series, "xyz"))
    value = _Taylor(lets).remainder(*arguments)
    doc = "R_D of arguments that are nearly equal, as a Taylor series."
    return _repeated("remainder", doc, arguments, lets, last=value)


def _times(f: Sequence[sp.Expr], g: Sequence[sp.Expr]) -> list[sp.Expr]:
    return [sum(f[i] * g[k - i] for i in range(k + 1)) for k in range(ORDERS + 1)]


def _plus(f: Sequence[sp.Expr], g: Sequence[sp.Expr]) -> list[sp.Expr]:
    return [p + q for p, q in zip(f, g, strict=True)]


def _minus(f: Sequence[sp.Expr], g: Sequence[sp.Expr]) -> list[sp.Expr]:
    return [p - q for p, q in zip(f, g, strict=True)]


@functools.cache
def _integrals(end: Corner, way: str, steep: bool, nodes: int) -> tuple[_Detached, Sequence[sp.Expr]]:
    """The lets, and what one of the methods above gives in them."""
    quarter = _Detached(end, steep, nodes)
    return quarter, getattr(quarter, way)()


def detached(a: sp.Expr, b: sp.Expr, corner_: Corner, way: str, nodes: int = NODES) -> Regime:
    """A > u_cr, where u (a + b (1/Delta - 1/c)) is averaged over 0 < t < theta, a u beyond."""
    # more nodes are for a breakpoint whose double says too little of A^2 - u_cr^2 next to it
    steep = way != "by_gauss" or nodes > NODES
    quarter, (W, V3, V5, V7) = _integrals(corner_, way, steep, nodes)
    end, root, c = quarter.b, quarter.root, quarter.c
    whole = u * (1 / ROOT - 1 / c)

    def boundary(order: int) -> sp.Expr:
        """jump of f^(order) at u_cr over b, times sin^(order + 1) theta dtheta/dA, where dtheta/dA = -u_cr/(A root)"""
        power = 2 * order + 1
        jump = sp.expand(c**power * sp.diff(whole, u, order).subs(ROOT, c).subs(u, end))
        numerator = sp.factor(sp.rem(sp.Poly(jump, c), sp.Poly(c**2 + end**2 - 1, c)).as_expr())
        return -numerator * end ** (order + 2) / (c**power * A ** (order + 2) * root)

    if boundary(0) != 0:
        raise ArithmeticError("the force jumps at the breakpoint")
    # f'' = 3 u/Delta^5 and f''' = 3 (1 + 4 u^2)/Delta^7, times sin^3 and sin^4
    for order, expected in ((2, 3 * u / ROOT**5), (3, 3 * (1 + 4 * u**2) / ROOT**7)):
        claim("derivatives of `u/sqrt(1 - u^2)`", sp.diff(whole, u, order) - expected, eq="(5)")
    forms = (
        -A * W,
        -(W - A**2 * V3),
        3 * A * V5 + boundary(1),
        3 * V7 + boundary(2) + slope(boundary(1), root),
    )
    rest = [a * A, a, 0, 0]
    derivatives = tuple(-(r + 4 / sp.pi * b * form) for r, form in zip(rest, forms, strict=True))
    intercept = 4 / sp.pi * b * A**3 * V3
    claim("`h - A h_A` beyond detachment", derivatives[0] - A * derivatives[1] - intercept, eq="(31)")
    return Regime((end,), (), tuple(quarter.lets), derivatives, intercept)


def far_detached(a: sp.Expr, b: sp.Expr, end: Corner, way: str, nodes: int = NODES) -> Regime:
    """The same where A exceeds u_cr by far: A is varied where it stands beside u, in A^-1 (A^2 - u^2)^(-1/2) u^2 du.

    That leaves the force undifferentiated, and all terms have one sign.
    """
    quarter, W = _integrals(end, way, way != "far_by_gauss", nodes)
    q = sp.Symbol("q", positive=True)
    # over the kernel itself, by log-derivative: -1/A - A/(A^2 - u^2), where 1/(A^2 - u^2) = (1 + q)/A^2, q = tan^2 t
    logarithmic = -(2 + q) / A
    q_A = -2 * q * (1 + q) / A
    rest = [a * A, a, 0, 0]
    derivatives, ratio, totals = [], sp.Integer(1), []
    for order in range(ORDERS + 1):
        polynomial = sp.Poly(sp.expand(ratio * A**order), q)
        total = sum(c * W[n] for (n,), c in polynomial.terms())
        totals.append(total)
        derivatives.append(-rest[order] + 4 / sp.pi * b * A ** (1 - order) * total)
        ratio = sp.expand(ratio * logarithmic + sp.diff(ratio, A) + sp.diff(ratio, q) * q_A)
    intercept = 4 / sp.pi * b * A * sp.expand(totals[0] - totals[1])
    return Regime((end.name,), (end.name,), tuple(quarter.lets), tuple(derivatives), intercept)


# --- both, in closed form ---


def by_second_parameter(F: sp.Expr, D: sp.Expr, m: sp.Expr, xy: sp.Expr, c: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """d/dm of F = int dt/Delta and of D = int sin^2 t/Delta dt over 0 < t < theta; xy = sin theta cos theta, c = Delta.

    An error where the derivatives by theta of both sides are not the same; at theta = 0 both vanish.
    """
    _proved_by_second_parameter()
    return _of_second_parameter(F, D, m, xy, c)


def _of_second_parameter(F: sp.Expr, D: sp.Expr, m: sp.Expr, xy: sp.Expr, c: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    F_m = (F - D - xy / c) / (2 * (1 - m))
    return F_m, (F_m - D / 2) / m


@functools.cache
def _proved_by_second_parameter() -> None:
    theta, k, f, d = sp.symbols("theta k f d", positive=True)
    delta = sp.sqrt(1 - k * sp.sin(theta) ** 2)
    forms = _of_second_parameter(f, d, k, sp.sin(theta) * sp.cos(theta), delta)
    for form, power in zip(forms, (2, 4), strict=True):
        slope_ = sp.diff(form, theta) + (sp.diff(form, f) + sp.diff(form, d) * sp.sin(theta) ** 2) / delta
        difference = slope_ - sp.sin(theta) ** power / (2 * delta**3)
        claim(
            "derivative of an elliptic integral by its parameter `m`",
            difference.subs(sp.cos(theta), sp.sqrt(1 - sp.sin(theta) ** 2)),
        )


def closed_forms(a: sp.Expr, b: sp.Expr, rest: sp.Expr, end: Corner) -> tuple[Regime, Regime]:
    """The average with three derivatives, attached and detached: for as many digits as it takes."""
    found = [
        replace(regime, derivatives=tuple(derivatives), intercept=intercept)
        for regime, slope_ in zip(of_springs(end), (-a, -rest), strict=True)
        for *derivatives, intercept in [with_linear(slope_, b, (*regime.derivatives, regime.intercept))]
    ]
    return found[0], found[1]


def with_linear(slope_: sp.Expr, b: sp.Expr, averages: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """h, h_A, h_AA, h_AAA, h - A h_A of a linear force and of b times another one, whose averages are given."""
    return tuple(linear + b * value for linear, value in zip((slope_ * A, slope_, 0, 0, 0), averages, strict=True))


@functools.cache
def of_springs(end: Corner) -> tuple[Regime, Regime]:
    """As `closed_forms` of the springs' force over b, which is 0 beyond the breakpoint.

    What cancels in it is no matter there, and neither is that it divides by 1 - A^2.
    """
    F, D, x, y, c, theta = sp.symbols("F D x y c theta", positive=True)
    root = sp.Symbol("root", nonnegative=True)
    m = A**2

    def on_circle(value: sp.Expr) -> sp.Expr:
        """In factors, x^2 + y^2 being 1; what vanishes with y at x = 1 is a power of y."""
        above, below = sp.fraction(sp.cancel(value))
        above = sp.Poly(sp.rem(sp.Poly(above, y), sp.Poly(y**2 + x**2 - 1, y)).as_expr(), x)
        while not above.is_zero and above.rem(sp.Poly(1 - x**2, x)).is_zero:
            above, below = above.quo(sp.Poly(1 - x**2, x)), below / y**2
        return sp.factor(above.as_expr() / below)

    def regime(passed: int, inner: sp.Expr, rates: Mapping[sp.Symbol, sp.Expr], lets: Sequence[Let]) -> Regime:
        """h = A inner with derivatives, by those of the names in it."""
        slopes = [inner]
        for _ in range(ORDERS):
            last = slopes[-1]
            value = sp.diff(last, A) + sum(sp.diff(last, name) * slope_ for name, slope_ in rates.items())
            value = sp.expand(value)
            gathered = [value.coeff(name, 1) for name in (F, D)]
            none, _ = value.as_independent(F, D, as_Add=True)
            slopes.append(sp.factor(gathered[0]) * F + sp.factor(gathered[1]) * D + on_circle(none))
        derivatives = [A * inner, inner + A * slopes[1]]
        derivatives += [n * slopes[n - 1] + A * slopes[n] for n in range(2, ORDERS + 1)]
        return Regime((end.name,) * passed, (), tuple(lets), tuple(derivatives), -m * slopes[1])

    F_m, D_m = by_second_parameter(F, D, m, 0, 1)
    attached_form = regime(
        0,
        1 - 4 / sp.pi * D,
        {F: 2 * A * F_m, D: 2 * A * D_m},
        ((F, R_F(0, 1 - m, 1)), (D, R_D(0, 1 - m, 1) / 3)),
    )
    F_m, D_m = by_second_parameter(F, D, m, x * y, c)
    angle_A = -x / (A * y)
    detached_form = regime(
        1,
        4 / sp.pi * ((theta - x * y) / (2 * c) - D),
        {
            theta: angle_A,
            x: -x / A,
            y: x**2 / (A * y),
            F: 2 * A * F_m + angle_A / c,
            D: 2 * A * D_m + angle_A * x**2 / c,
        },
        (
            (end.name, end.value),
            (c, end.height),
            (root, sp.sqrt((A - end.name) * (A + end.name))),
            (x, end.name / A),
            (y, root / A),
            (theta, sp.atan2(end.name, root)),
            (F, x * R_F(y**2, c**2, 1)),
            (D, x**3 / 3 * R_D(y**2, c**2, 1)),
        ),
    )
    return attached_form, detached_form


# --- in double-double: the mean with more steps, and the same closed forms ---

#: steps of the mean for 32 digits, up to A = FEW and at any u_cr
STEPS_CLOSE, STEPS_CLOSE_STEEP = 5, 10
#: the powers of what Carlson's arguments differ by that his series keep
KEPT = 7


def mean_left_out(steps: int, least: sp.Expr) -> sp.Expr:
    """What the mean's sums leave out after so many steps, relatively, and its limit, for sqrt(1 - m) >= `least`.

    c_n/a_n falls as sqrt(1 - m) rises, and c_(n+1)/c_n = c_n/(4 a_(n+1)) <= c_n/(2 a_n) with it: so the worst is at
    the least. The sums are no less than their first terms; what they leave out, 2^n c_n^2 and c_n, falls faster than
    by halves.
    """
    with ctx.workprec(2000):
        a, b = arb(1), (arb(int((least**2).p)) / int((least**2).q)).sqrt()
        first = (a - b) / 2
        for _ in range(steps):
            c, a, b = (a - b) / 2, (a + b) / 2, (a * b).sqrt()
        following = c**2 / (4 * a)
        bound = 2 * following / first * 2**steps
        exponent = int(float(bound.upper().log() / arb(2).log())) + 1
    return sp.Integer(2) ** exponent


def attached_closely(a: sp.Expr, b: sp.Expr) -> tuple[Regime, Regime]:
    """The average where A <= u_cr by the mean, for A <= `FEW` and any; what its sums and its limit leave out."""
    found = []
    # at the end sqrt(1 - A^2) is the height of the corner, no less than half an ulp of 1
    for steps, least in ((STEPS_CLOSE, sp.sqrt(1 - FEW**2)), (STEPS_CLOSE_STEEP, sp.Rational(1, 2**53))):
        regime, ends, left_out = attached(a, b, steps), ("e", "tau", f"a_{steps}"), mean_left_out(steps, least)
        found.append(
            replace(regime, remainders=tuple((name, left_out) for name, _ in regime.lets if name.name in ends))
        )
    return found[0], found[1]


@dataclass(frozen=True)
class SplitAverage:
    """The average where A > u_cr, in closed form, split at the breakpoint.

    ends     -- A, sqrt(1 - u_cr^2), sine, cosine and angle of where the first piece ends, in `beyond`; with their lets
    integral -- h, h_A, h_AA, h_AAA and h - A h_A over b of the first piece, without the last piece, in the ends' names
                and Carlson's integrals of cosine^2, 1 - u_cr^2 and 1
    whole    -- the same of all of the force, in A and in names for these
    """

    beyond: sp.Symbol
    lets: tuple[Let, ...]
    ends: tuple[sp.Symbol, ...]
    carlson: tuple[sp.Symbol, sp.Symbol]
    integral_lets: tuple[Let, ...]
    integral: tuple[sp.Expr, ...]
    names: tuple[sp.Symbol, ...]
    whole: tuple[sp.Expr, ...]


@functools.cache
def detached_closely(b: sp.Expr, rest: sp.Expr, end: Corner) -> SplitAverage:
    """As `closed_forms` where A > u_cr, with b and the last piece apart: they are no exact numbers."""
    beyond = sp.Symbol("beyond", nonnegative=True)
    first, second = sp.symbols("of_first of_second", positive=True)
    names = sp.symbols("part_0:5", real=True)
    _, regime = of_springs(end)
    lets = {name.name: (name, value) for name, value in regime.lets}
    F, D = lets.pop("F"), lets.pop("D")
    called = {R_F: first, R_D: second}
    of_integrals = [
        (name, value.replace(lambda part: part.func in called, lambda part: called[part.func]))
        for name, value in (F, D)
    ]
    before = [lets[end.name.name], lets["c"], (A, end.name + beyond)]
    after = [
        (name, value.subs(A - end.name, beyond) if name.name == "root" else value)
        for name, value in lets.values()
        if name not in (end.name, lets["c"][0])
    ]
    ends = (A, *(lets[name][0] for name in ("c", "x", "y", "theta")))
    return SplitAverage(
        beyond,
        (*before, *after),
        ends,
        (first, second),
        tuple(of_integrals),
        (*regime.derivatives, regime.intercept),
        names,
        with_linear(-rest, b, names),
    )


@dataclass(frozen=True)
class Series:
    """R_F or R_D of nearly equal arguments, times a power of their mean.

    arguments -- what the first two arguments differ from the mean by
    lets      -- the elementary symmetric functions of what all of them do
    symmetric -- their names, from that of degree 2 on
    first     -- terms of degree 3 and less
    rest      -- the others
    """

    name: str
    power: sp.Rational
    arguments: tuple[sp.Symbol, sp.Symbol]
    lets: tuple[Let, ...]
    symmetric: tuple[sp.Symbol, ...]
    first: sp.Expr
    rest: sp.Expr


def carlson() -> tuple[Series, Series]:
    """Both series (DLMF 19.19.7, 19.36.1, 19.36.2).

    R = mean^-a sum over N of (a)_N/(c)_N T_N, where sum T_N t^N = product (1 - t x_i)^(-1/2) over the arguments, each
    as often as it stands there, c is half their number, and the x_i are what they lack of the mean, over it: their
    sum is 0.
    """
    x, y, z, t = sp.symbols("x y z t", real=True)
    found = []
    for name, times, a in (("R_F", 1, sp.Rational(1, 2)), ("R_D", 3, sp.Rational(3, 2))):
        count = 2 + times
        all_of_them = [x, y, *[z] * times]
        symmetric = sp.symbols(f"E2:{count + 1}", real=True)
        product = sp.expand(sp.prod(1 + t * one for one in all_of_them)).subs(z, -(x + y) / times)
        values = [sp.expand(product).coeff(t, degree) for degree in range(1, count + 1)]
        claim("the deviations of the arguments from their mean sum to 0", values[0])
        lets = [(z, -(x + y) / times)]
        lets += [
            (symbol, sp.factor(sp.expand(sp.prod(1 + t * one for one in all_of_them)).coeff(t, degree)))
            for degree, symbol in enumerate(symmetric, start=2)
        ]
        below = 1 + sum((-t) ** degree * symbol for degree, symbol in enumerate(symmetric, start=2))
        terms = sp.expand(sp.series(1 / sp.sqrt(below), t, 0, KEPT + 1).removeO())
        weights = [sp.rf(a, N) / sp.rf(sp.Rational(count, 2), N) * terms.coeff(t, N) for N in range(KEPT + 1)]
        found.append(Series(name, -a, (x, y), tuple(lets), symmetric, sum(weights[:4]), sp.expand(sum(weights[4:]))))
    return found[0], found[1]


def at_rest(piece: sp.Expr) -> tuple[sp.Expr, ...]:
    """The average, its derivatives and `Regime.intercept` at A = 0: those of the force's first terms there."""
    first = sp.series(piece, u, 0, ORDERS + 1).removeO()
    regime = average((sp.expand(first),), (), 0)
    return tuple(sp.sympify(value).subs(A, 0) for value in (*regime.derivatives, regime.intercept))


def restoring(pieces: Sequence[sp.Expr], breakpoints: Mapping[sp.Symbol, sp.Expr]) -> Restoring:
    """All of step 3 for the pieces of a force and their ends in a parameter.

    Give u + F_k for h (the whole force), F_k for H.
    """
    if len(pieces) != 2:
        raise ArithmeticError("an untruncated force is averaged for one breakpoint only")
    (a, b), (rest, none) = (coefficients(piece) for piece in pieces)
    if none != 0:
        raise ArithmeticError("an untruncated force is averaged only if it is linear beyond the breakpoint")
    ((name, value),) = breakpoints.items()
    end = corner(name, value)
    # A^2 - u_cr^2 >= AWAY_STEEP (1 - u_cr^2)
    away = (sp.sqrt(AWAY_STEEP + (1 - AWAY_STEEP) * value**2), A)
    cases = (
        Case("passed_0_end", ((A, value), (value, A)), attached(a, b, STEPS_END, end)),
        Case("passed_0", ((A, value), (A, FEW)), attached(a, b, STEPS)),
        Case("passed_0_steep", ((A, value),), attached(a, b, STEPS_STEEP)),
        Case("passed_1_far", ((value, MODERATE), (AWAY * value, A)), far_detached(rest, b, end, "far_by_gauss")),
        Case("passed_1", ((value, MODERATE),), detached(rest, b, end, "by_gauss")),
        Case(
            "passed_1_steeper_far",
            ((value, STEEPER), (AWAY * value, A)),
            far_detached(rest, b, end, "far_by_gauss", NODES_STEEPER),
        ),
        Case("passed_1_steeper", ((value, STEEPER),), detached(rest, b, end, "by_gauss", NODES_STEEPER)),
        Case("passed_1_steep_far", ((AWAY * value, A),), far_detached(rest, b, end, "far_by_duplication")),
        Case("passed_1_steep_away", (away,), far_detached(rest, b, end, "closer_by_duplication")),
        Case("passed_1_steep", (), detached(rest, b, end, "by_duplication")),
    )
    return Restoring(tuple(pieces), (name,), (sp.Integer(0),), closed_forms(a, b, rest, end), {}, cases)
