"""Parameters of an oscillator in; its averaged steady states, folds, onsets and branches out, to 40 certified digits.

The independent reference for the runtime's tests. It shares no code with `derivations/`, `generated/` or `src/`: the
restoring force is averaged here through the moments of sin^(2k), all arithmetic is FLINT's (exact rationals, and balls
that enclose the true value), and completeness is proved, not sampled:

* With R = A Omega^2 + h and I = n + 2 zeta A Omega + d A^2 Omega^2 the response curve is F = R^2 + I^2 - F_0^2 = 0.
  n = 4 mu/pi + eta A, or 4 mu u_cr/(pi A) beyond u_cr where friction ends there; d = 8 c_2/(3 pi).
  F, A F_A/2 - F and the like are quartics in Omega: each pair of them gives one function of A, the determinant of their
  Bezout matrix, which is the resultant times a power of a leading coefficient that is positive. Where both are even in
  Omega it is that of Omega^2. While the mass stays attached (A <= u_cr) it is a polynomial with rational coefficients:
  all its roots are isolated exactly. Beyond, with A = u_cr sqrt(1 + t^2), it is analytic in t down to and including the
  corner t = 0, and `certified_roots.isolate` encloses every zero on a range outside which no fold can be.
* Every zero is a candidate. Omega follows from the roots of a quartic, each enclosed; F and F_A decide; a Krawczyk step
  then proves that the enclosing box holds exactly one solution of the system itself.
* At A = u_cr the slope h_A jumps to -infinity (the truncated force is negative there), so F_A jumps to
  -sign(R) infinity: a response point on the corner is a fold where R and the attached F_A have the same sign.
* Independently, the number of folds at any F_0 is a Morse count on the fold locus: twice (minima of F_0 below, minus
  maxima below), plus the ends of the locus at Omega = 0. The extrema are the cusps (F_AA = 0), isola births
  (F_Omega = 0, where Omega^2 = h_A), and points on the corner. `fold_count` uses only these, `folds` none of them.

Numbers given as floats are taken exactly as their binary values; `fractions.Fraction` is exact too.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import zip_longest
from typing import Any

from flint import arb, arb_mat, arb_series, ctx, fmpq, fmpq_poly

from tests.oracles.certified_roots import isolate, polynomial_roots, precision

BITS = 280  # 84 digits to compute with; 40 are reported
DIGITS = 40
#: names of F and its derivatives by Omega and A; some of them with those of their own derivatives by either
DERIVATIVES = ("F", "A", "O", "AA", "AO", "OO", "AAA", "AAO")
SLOPES = {"F": ("O", "A"), "A": ("AO", "AA"), "AA": ("AAO", "AAA"), "O": ("OO", "AO")}
ATTACHED, DETACHED, CORNER = "attached", "detached", "corner"
Number = float | int | Fraction
Coefficients = Sequence[Any]


def exact(x: Number) -> fmpq:
    """The rational number that a float (or Fraction, or int) is."""
    q = Fraction(x)
    return fmpq(q.numerator, q.denominator)


def digits(x: arb) -> str:
    """Forty significant digits of a ball that is known to at least as many."""
    with precision(BITS):
        if x.is_zero():
            return "0"
        if not arb(x.rad()) < abs(x) * arb(10) ** (-DIGITS - 2):
            raise ArithmeticError(f"only known as {x}")
        return arb(x.mid()).str(DIGITS, radius=False)


def _sign(x: arb) -> int:
    if x > 0:
        return 1
    if x < 0:
        return -1
    raise ArithmeticError(f"the sign of {x} is not decided")


def exact_ball(x: arb) -> fmpq:
    """The rational number at the centre of a ball."""
    mantissa, exponent = x.mid().man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)


def _moments(t: arb_series) -> list[arb_series]:
    """int_0^theta sin^2k, k = 1, 2, 3, with cot(theta) = t.

    The closed form serves at the centre only. Around it the derivative by t, -sin^(2k+2) theta, is integrated: the
    closed form's terms cancel for large t and would make wide balls useless.
    """
    centre = arb(t[0].mid())
    sine_2 = 1 / (1 + centre * centre)
    product = centre * sine_2  # cos(theta) sin(theta)
    closed = [(arb.pi() / 2 - centre.atan() - product) / 2]
    closed.append((3 * closed[0] - product * sine_2) / 4)
    closed.append((5 * closed[1] - product * sine_2 * sine_2) / 6)
    square = 1 / (1 + t * t)
    return [
        value - square[0] ** power * (t[0] - centre) - (square**power * t.derivative()).integral()
        for power, value in enumerate(closed, start=2)
    ]


def determinant(rows: list[list[Any]]) -> Any:
    """By minors of the first row: no division."""
    if len(rows) == 1:
        return rows[0][0]
    total = None
    for k, entry in enumerate(rows[0]):
        term = entry * determinant([row[:k] + row[k + 1 :] for row in rows[1:]])
        term = -term if k % 2 else term
        total = term if total is None else total + term
    return total


def bezout(f: Coefficients, g: Coefficients) -> Any:
    """The determinant of the Bezout matrix of two polynomials of one formal degree, coefficients constant first."""
    n = len(f) - 1

    def entry(i: int, j: int) -> Any:
        pairs = [(i + j + 1 - k, k) for k in range(min(i, j) + 1) if i + j + 1 - k <= n]
        terms = [f[high] * g[low] - f[low] * g[high] for high, low in pairs]
        return sum(terms[1:], terms[0])

    return determinant([[entry(i, j) for j in range(n)] for i in range(n)])


def times(f: Coefficients, g: Coefficients) -> list[Any]:
    """The product of two polynomials, coefficients constant first."""
    found: list[Any] = [0] * (len(f) + len(g) - 1)
    for i, a in enumerate(f):
        for k, b in enumerate(g):
            found[i + k] = found[i + k] + a * b
    return found


def with_slopes(x: Any, function: Callable[[arb_series], Sequence[arb_series]]) -> tuple[Any, ...]:
    """A function that takes two derivatives by its argument, of a ball or a series x.

    It is given a series that begins where x does, and is two coefficients longer.
    """
    is_ball = isinstance(x, arb)
    start, step, length = (x, arb(1), 1) if is_ball else (x[0], x[1] if ctx.cap > 1 else arb(0), ctx.cap)
    before, ctx.cap = ctx.cap, length + 2
    found = function(arb_series([start, 1]))
    ctx.cap = before
    if is_ball:
        return tuple(one[0] for one in found)
    return tuple(arb_series([one[j] * step**j for j in range(length)]) for one in found)


def plus(*polynomials: Coefficients) -> list[Any]:
    """Their sum."""
    return [sum(terms) for terms in zip_longest(*polynomials, fillvalue=0)]


@dataclass
class Jet:
    """A and h with derivatives by A; h_A = g / s and h_AA = k / s^3, where s = t beyond the corner and 1 before it."""

    A: Any
    h: Any
    g: Any = None
    k: Any = None
    s: Any = 1

    @property
    def scales(self) -> tuple[Any, Any, Any]:
        """What h_AA, h_A and h_A^2 are multiplied by where h_AA is freed of its denominator."""
        return self.s * self.s * self.s, self.s * self.s, self.s


@dataclass
class Point:
    """A point of the (Omega, A) plane on one side of the corner or on it, with what is known about it."""

    Omega: arb
    A: arb
    regime: str
    F_0: arb | None = None
    kind: str = ""
    sense: str = ""  # "min" or "max" where that is the question


@dataclass
class Amplitude:
    """One steady state at a given frequency."""

    A: arb
    phi: arb
    stable: bool
    regime: str


class Oscillator:
    """Averaged oscillator with h(A) given piecewise; parameters by name as exact rationals, mu, zeta, eta, c_2 too."""

    #: whether friction acts on the attached piece only
    ends_at_u_cr = False
    #: the power of Omega next to F_0^2
    driven_by = 0

    def __init__(self, **parameters: Number | fmpq) -> None:
        self.parameters = {k: v if isinstance(v, fmpq) else exact(v) for k, v in parameters.items()}
        self.zeta, self.mu, self.eta, self.c_2 = (
            self.parameters.get(name, fmpq(0)) for name in ("zeta", "mu", "eta", "c_2")
        )
        if self.ends_at_u_cr and (self.zeta == 0 or self.eta + self.c_2 > 0):
            raise NotImplementedError("friction that ends goes with viscous damping only")
        with precision(2 * BITS):
            self._m_rational, self._d_rational = exact_ball(self.m), exact_ball(self.d)
        self.alpha, self.beta, self.gamma = self._stiffness()

    # ---- the mechanism -------------------------------------------------------------------------------------------

    def _stiffness(self) -> tuple[fmpq, fmpq, fmpq]:
        """Of the attached piece; of no force that is averaged in another way."""
        return fmpq(0), fmpq(0), fmpq(0)

    @property
    def u_cr(self) -> arb | None:
        """Where the springs detach; None when they never do."""
        return None

    @property
    def m(self) -> arb:
        """4 mu / pi."""
        return 4 * arb(self.mu) / arb.pi()

    @property
    def d(self) -> arb:
        """8 c_2/(3 pi)."""
        return 8 * arb(self.c_2) / (3 * arb.pi())

    def at_rest(self, A: arb, regime: str) -> tuple[arb, arb, arb, arb]:
        """n and three derivatives."""
        m, eta, zero = self.m, arb(self.eta), arb(0)
        if regime == DETACHED and self.ends_at_u_cr:
            n = m * self.u_cr / A
            return n + eta * A, eta - n / A, 2 * n / A**2, -6 * n / A**3
        return m + eta * A, eta, zero, zero

    def force(self, u: Any) -> Any:
        """The restoring force of the attached piece at u, vertical spring included."""
        return arb(self.alpha) * u + arb(self.beta) * u**3 + arb(self.gamma) * u**5

    def attached(self, A: Any) -> Any:
        """h for A <= u_cr; A a Taylor polynomial, or the variable of a rational one."""
        a, b, c = self.alpha, 3 * self.beta / 4, 5 * self.gamma / 8
        if not isinstance(A, fmpq_poly):
            a, b, c = arb(a), arb(b), arb(c)
        square = A * A
        return -A * (a + square * (b + square * c))

    def average(self, A: arb_series, t: arb_series) -> arb_series:
        """h for A = u_cr sqrt(1 + t^2).

        The force beyond the vertical spring's u acts for |sin| <= u_cr/A = sin(theta) only, so that
        h = -A - (4/pi) int_0^theta F_k(A sin x) sin x dx with moments M_2k = int_0^theta sin^2k.
        """
        a, b, c = arb(self.alpha) - 1, arb(self.beta), arb(self.gamma)
        square, (M_2, M_4, M_6) = A * A, _moments(t)
        return -A - (4 / arb.pi()) * A * (a * M_2 + square * (b * M_4 + square * (c * M_6)))

    def detached(self, t: Any) -> tuple[Any, Any, Any, Any]:
        """A, h, t h', t^3 h'' at A = u_cr sqrt(1 + t^2), analytic in t >= 0, as A' is u_cr t/sqrt(1 + t^2)."""

        def slopes(t: arb_series) -> tuple[arb_series, ...]:
            long = (1 + t * t).sqrt()
            h = self.average(self.u_cr * long, t)
            g = h.derivative() * long / self.u_cr
            return self.u_cr * long, h, g, (t * g.derivative() - g) * long / self.u_cr

        return with_slopes(t, slopes)

    def h(self, A: arb, regime: str) -> tuple[arb, arb, arb, arb]:
        """h, h', h'', h''' at a ball A on the given side of the corner (the corner itself counts as attached)."""
        before, ctx.cap = ctx.cap, 4
        at = arb_series([A, 1])
        h = self.average(at, self.t(at)) if regime == DETACHED else self.attached(at)
        ctx.cap = before
        return h[0], h[1], 2 * h[2], 6 * h[3]

    def t(self, A: Any) -> Any:
        """The parameter of A = u_cr sqrt(1 + t^2)."""
        return (A * A - self.u_cr**2).sqrt() / self.u_cr

    def regime(self, A: arb) -> str:
        """On which side of the corner A lies."""
        return ATTACHED if self.u_cr is None or A < self.u_cr else DETACHED if A > self.u_cr else CORNER

    # ---- F and its derivatives at a point ------------------------------------------------------------------------

    def derivatives(self, Omega: arb, A: arb, regime: str, F_0: arb) -> dict[str, arb]:
        """R, I and I_A; F and its derivatives by Omega (O) and by A."""
        before, ctx.cap = ctx.cap, 4
        a, zero, zeta = arb_series([A, 1]), arb_series([0]), arb(self.zeta)
        h, n = (
            arb_series([value / math.factorial(k) for k, value in enumerate(of(A, regime))])
            for of in (self.h, self.at_rest)
        )
        R, I = [h, zero, a], [n, 2 * zeta * a, self.d * a * a]
        F = plus(times(R, R), times(I, I), self._driven(F_0))

        def at(polynomial: Coefficients, by_Omega: int, by_A: int) -> arb:
            terms = (
                math.perm(k, by_Omega) * Omega ** (k - by_Omega) * polynomial[k][by_A]
                for k in range(by_Omega, len(polynomial))
            )
            return math.factorial(by_A) * sum(terms, arb(0))

        found = {"R": at(R, 0, 0), "I": at(I, 0, 0), "I_A": at(I, 0, 1)}
        found |= {name: at(F, name.count("O"), name.count("A")) for name in DERIVATIVES}
        ctx.cap = before
        return found

    def forcing(self, Omega: arb, A: arb, regime: str) -> arb:
        """The forcing whose response curve passes through (Omega, A)."""
        d = self.derivatives(Omega, A, regime, arb(0))
        return d["F"].sqrt() / Omega ** (self.driven_by // 2)

    # ---- polynomials in Omega, constant first -----------------------------------------------------------------------

    def _numbers(self, j: Jet) -> tuple[Any, Any, Any, Any, Any, Any]:
        """zeta, d, n and its derivatives (not multiplied by any s) at a jet."""
        A = j.A
        if isinstance(A, fmpq_poly):
            zero = fmpq_poly([0])
            return self.zeta, self._d_rational, self._m_rational + self.eta * A, zero + self.eta, zero, zero
        eta = arb(self.eta)
        if self.ends_at_u_cr and self._beyond(j):
            n = self.m * self.u_cr / A
            return arb(self.zeta), self.d, n + eta * A, eta - n / A, 2 * n / (A * A), 0 * A
        return arb(self.zeta), self.d, self.m + eta * A, 0 * A + eta, 0 * A, 0 * A

    @staticmethod
    def _beyond(j: Jet) -> bool:
        """Jets of balls and series stand for amplitudes beyond u_cr: those before it are rational polynomials."""
        return not isinstance(j.A, fmpq_poly)

    def _driven(self, F_0: Any) -> list[Any]:
        """What F has of the forcing."""
        return [0] * self.driven_by + [-F_0 * F_0]

    def _balances(self, j: Jet) -> tuple[list[Any], list[Any]]:
        """R and I."""
        zeta, d, n, *_ = self._numbers(j)
        return [j.h, 0, j.A], [n, 2 * zeta * j.A, d * j.A * j.A]

    def _response_polynomial(self, j: Jet, F_0: Any) -> list[Any]:
        """F."""
        R, I = self._balances(j)
        return plus(times(R, R), times(I, I), self._driven(F_0))

    def _lag_polynomial(self, j: Jet, F_0: Any) -> list[Any]:
        """s (A F_A/2 - F): of A R_A - R and A I_A - I inertia and viscous damping are gone."""
        (_, d, n, n_A, *_), (R, I) = self._numbers(j), self._balances(j)
        by_I = times([j.s], [j.A * n_A - n, 0, d * j.A * j.A])
        driven = times([-j.s], self._driven(F_0))
        return plus(times(R, [j.A * j.g - j.s * j.h]), times(I, by_I), driven)

    def _slope_polynomial(self, j: Jet) -> list[Any]:
        """s F_A/2."""
        (zeta, d, _, n_A, *_), (R, I) = self._numbers(j), self._balances(j)
        return plus(times(R, [j.g, 0, j.s]), times([j.s], times(I, [n_A, 2 * zeta, 2 * d * j.A])))

    def _bend_polynomial(self, j: Jet) -> list[Any]:
        """s^3 F_AA/2, or what a jet scales it by."""
        (zeta, d, _, n_A, n_AA, _), (R, I), (s3, s2, s) = self._numbers(j), self._balances(j), j.scales
        I_A = [n_A, 2 * zeta, 2 * d * j.A]
        by_I = plus(times(I_A, I_A), times(I, [n_AA, 0, 2 * d]))
        return plus([s * j.g * j.g, 0, 2 * s2 * j.g, 0, s3], times(R, [j.k]), times([s3], by_I))

    def _peak_polynomial(self, j: Jet) -> list[Any]:
        """F_Omega/2."""
        R, I = self._balances(j)
        return plus(times(R, [0, 2 * j.A]), times(I, [I[1], 2 * I[2]]))

    @property
    def _even(self) -> bool:
        """Whether all is even in Omega: a resultant would be a square."""
        return self.zeta == 0 or self.mu == self.eta == self.c_2 == 0

    def _resultant(self, f: Coefficients, g: Coefficients) -> Any:
        return bezout(f[::2], g[::2]) if self._even else bezout(f, g)

    @staticmethod
    def _value(f: Coefficients, x: Any) -> Any:
        return f[0] + x * (f[1] + x * (f[2] + x * (f[3] + x * f[4])))

    def _roots(self, coefficients: Coefficients) -> list[arb]:
        """Positive roots of a polynomial in Omega whose coefficients are balls, each enclosed."""
        centre = fmpq_poly([exact_ball(arb(c)) for c in coefficients])
        enclosed = []
        for root in polynomial_roots(centre, BITS):
            mid, value = arb(root.mid()), arb(0)
            for power in range(len(coefficients) - 1, -1, -1):
                value = value * mid + coefficients[power]
            for part in (2, 4, 8, 12, 16, 20, 24, 28):  # as wide as the coefficients ask for
                box, slope = arb(mid, arb(2) ** (-BITS // part) * abs(root).upper()), arb(0)
                for power in range(len(coefficients) - 1, 0, -1):
                    slope = slope * box + power * coefficients[power]
                new = mid - value / slope
                if box.contains_interior(new):
                    break
            else:
                raise ArithmeticError("nearly double root in Omega")
            enclosed.append(new)
        return enclosed

    def _at(self, A: arb, regime: str) -> "tuple[Oscillator, Jet]":
        """The oscillator whose n is the one there, and h there."""
        h, h_A, h_AA, _ = self.h(A, regime)
        own = self
        if self.ends_at_u_cr and regime != DETACHED:
            own = self._rubbing_throughout
        return own, Jet(A, h, h_A, h_AA, arb(1))

    @property
    def _rubbing_throughout(self) -> "Oscillator":
        other = object.__new__(type(self))
        other.__dict__.update(self.__dict__)
        other.ends_at_u_cr = False
        return other

    # ---- zeros on both sides of the corner ------------------------------------------------------------------------

    def _zeros(
        self, function: Callable[[Jet], Any], t_max: arb | None, exclude: Callable[[arb], bool] | None = None
    ) -> list[tuple[arb, str]]:
        """All zeros in A of function(jet): attached by exact polynomials, detached up to t_max by enclosure."""
        A = fmpq_poly([0, 1])
        h = self.attached(A)
        polynomial = function(Jet(A, h, h.derivative(), h.derivative().derivative(), fmpq_poly([1])))
        attached = []
        if polynomial.degree() > 0:
            for root in polynomial_roots(polynomial, BITS):
                if self.u_cr is None or root < self.u_cr:
                    attached.append((root, ATTACHED))
                elif not root > self.u_cr:
                    raise ArithmeticError("a root on the corner")
        if self.u_cr is None or t_max is None:
            return attached

        def at(t: Any) -> Any:
            A, h, g, k = self.detached(t)
            return function(Jet(A, h, g, k, t))

        return attached + [
            (self.u_cr * (1 + t * t).sqrt(), DETACHED) for t in isolate(at, arb(0), t_max, exclude=exclude)
        ]

    def _fold_bounds(self, A: arb) -> tuple[arb, arb]:
        """With h = -A + e: bounds of |e|/A and |e'| from A >= 2 u_cr on."""
        u, pi = self.u_cr, arb.pi()
        terms = [abs(arb(self.alpha) - 1), abs(arb(self.beta)) * u**2, abs(arb(self.gamma)) * u**4]
        force, slope = u * sum(terms, arb(0)), terms[0] + 3 * terms[1] + 5 * terms[2]
        s = u / A
        return (4 / pi) * force * s**2 / A, (4 / pi) * s**3 * (slope * pi / 2 + force / u / (arb(3) / 4).sqrt())

    @cached_property
    def _fold_range(self) -> arb | None:
        """t beyond which F_A > 0 for every Omega, whatever the forcing.

        F_A/(2 A) = (y + p)(y + q) + I I_A/A with y = Omega^2 - 1 and |p|, |q| <= e. The product is not below -e^2, and
        above e^2 for |y| > 2 e. I I_A/A is not below eta^2 + 4 zeta^2 Omega^2 + 2 (d A Omega^2)^2, less (m u_cr)^2/A^4
        where friction ends. All of these grow with A, and e falls.
        """
        if self.u_cr is None:
            return None
        if not self.zeta + self.eta + self.c_2 > 0:
            raise ValueError("the oracle wants damping beside friction")
        A = 2 * self.u_cr
        while True:
            lost = self.m * self.u_cr / A**2 if self.ends_at_u_cr else arb(0)
            e = max(*self._fold_bounds(A), lost, key=lambda x: x.mid()) * arb("1.0001")
            low = 1 - 2 * e
            if low > 0:
                gain = arb(self.eta) ** 2 + 4 * arb(self.zeta) ** 2 * low + 2 * (self.d * A * low) ** 2
                if gain - lost**2 > e**2:
                    return self.t(A)
            A *= arb(5) / 4

    def _response_range(self, F_0: arb) -> arb | None:
        """t beyond which F = 0 has no solution: 4 zeta^2 A (-h - F_0) <= (F_0 - m)^2 there, and -h >= A - c."""
        if self.u_cr is None:
            return None
        u, zeta = self.u_cr, arb(self.zeta)
        c = (4 / arb.pi()) * u * (abs(arb(self.alpha) - 1) + abs(arb(self.beta)) * u**2 + abs(arb(self.gamma)) * u**4)
        half = (c + F_0) / 2
        bound = half + (half**2 + ((F_0 - self.m) / (2 * zeta)) ** 2).sqrt()
        return self.t(bound.max(2 * u))

    def _state_range(self, Omega: arb, F_0: arb) -> arb | None:
        """The same at one frequency: I = F_0 at most."""
        if self.u_cr is None:
            return None
        linear, square = arb(self.eta) + 2 * arb(self.zeta) * Omega, self.d * Omega**2
        top = F_0 / linear if linear > 0 else (F_0 / square).sqrt()
        return self.t((top * arb("1.0001")).max(2 * self.u_cr))

    # ---- from a zero to a certified point -------------------------------------------------------------------------

    def _krawczyk(self, Omega: arb, A: arb, system: Callable[[arb, arb], tuple[list, list]]) -> tuple[arb, arb]:
        """A box with exactly one solution of the 2 x 2 system(Omega, A) -> values, rows of the Jacobian."""
        x, y = arb(Omega.mid()), arb(A.mid())
        for _ in range(12):
            values, rows = system(x, y)
            step = arb_mat(rows).solve(arb_mat(2, 1, values))
            x, y = arb((x - step[0, 0]).mid()), arb((y - step[1, 0]).mid())
        values, rows = system(x, y)
        inverse = arb_mat(rows).inv().mid()
        correction = inverse * arb_mat(2, 1, values)
        for bits in (BITS // 2, 5 * BITS // 8, 3 * BITS // 4):  # next to the corner slopes differ much within a box
            radius = arb(2) ** -bits
            box_x, box_y = arb(x, radius), arb(y, radius)
            spread = arb_mat([[1, 0], [0, 1]]) - inverse * arb_mat(system(box_x, box_y)[1])
            delta = spread * arb_mat(2, 1, [arb(0, radius), arb(0, radius)])
            new_x, new_y = x - correction[0, 0] + delta[0, 0], y - correction[1, 0] + delta[1, 0]
            if box_x.contains_interior(new_x) and box_y.contains_interior(new_y):
                break
        else:
            raise ArithmeticError("Krawczyk's test fails")
        if not (Omega.overlaps(new_x) and A.overlaps(new_y)):
            raise ArithmeticError("Newton's method left the enclosure")
        return new_x, new_y

    def _common(
        self,
        zeros: list[tuple[arb, str]],
        polynomial: Callable[["Oscillator", Jet], list[Any]],
        F_0: arb,
        names: tuple[str, str],
    ) -> list[Point]:
        """The candidates at which both named functions vanish; Omega from the roots of one polynomial."""
        points = []
        for A, regime in zeros:

            def system(x: arb, y: arb, regime: str = regime) -> tuple[list, list]:
                d = self.derivatives(x, y, regime, F_0)
                return [d[n] for n in names], [[d[k] for k in SLOPES[n]] for n in names]

            for Omega in self._roots(polynomial(*self._at(A, regime))):
                if all(value.contains(0) for value in system(Omega, A)[0]):
                    points.append(Point(*self._krawczyk(Omega, A, system), regime))
        return points

    def ask(self, F_0: Number, frequencies: Sequence[Number]) -> None:
        """Prepare for questions: for those that have to find a range of amplitudes first."""

    # ---- what is asked ----------------------------------------------------------------------------------------------

    def folds(self, F_0: Number) -> list[Point]:
        """Every (Omega, A) with F = F_A = 0 or on the corner between F_A of opposite signs, by rising Omega."""
        with precision(BITS):
            forcing, rational = arb(exact(F_0)), exact(F_0)

            def function(j: Jet) -> Any:
                force = rational if isinstance(j.A, fmpq_poly) else forcing
                return self._resultant(self._response_polynomial(j, force), self._lag_polynomial(j, force))

            points = self._common(
                self._zeros(function, self._fold_range),
                lambda own, j: own._response_polynomial(j, forcing),
                forcing,
                ("F", "A"),
            )
            for p in points:
                curvature = self.derivatives(p.Omega, p.A, p.regime, forcing)["AA"]
                p.kind = "jump-up" if _sign(curvature) < 0 else "jump-down"
            points += self._corner_folds(forcing)
            for p in points:
                p.F_0 = forcing
            return sorted(points, key=lambda p: p.Omega.mid())

    def _corner_folds(self, forcing: arb) -> list[Point]:
        points = []
        if self.u_cr is None:
            return points
        for Omega in self.frequencies(self.u_cr, forcing, CORNER):
            d = self.derivatives(Omega, self.u_cr, CORNER, forcing)
            if _sign(d["R"]) == _sign(d["A"]):
                kind = "jump-up" if d["A"] > 0 else "jump-down"
                points.append(Point(Omega, self.u_cr, CORNER, kind=kind))
        return points

    def frequencies(self, A: Number | arb, F_0: Number | arb, regime: str | None = None) -> list[arb]:
        """Every positive Omega with F = 0 at this amplitude, ascending."""
        with precision(BITS):
            A = A if isinstance(A, arb) else arb(exact(A))
            own, j = self._at(A, regime or self.regime(A))
            return self._roots(own._response_polynomial(j, F_0 if isinstance(F_0, arb) else arb(exact(F_0))))

    def fold_frequencies(self, A: arb) -> list[arb]:
        """Every positive Omega with F_A = 0 at this amplitude, ascending."""
        with precision(BITS):
            own, j = self._at(A, self.regime(A))
            return self._roots(own._slope_polynomial(j))

    def amplitudes(self, Omega: Number, F_0: Number) -> list[Amplitude]:
        """Every steady state at this frequency, by rising amplitude."""
        with precision(BITS):
            frequency, forcing = arb(exact(Omega)), arb(exact(F_0))

            def function(j: Jet) -> Any:
                x, force = (exact(Omega), exact(F_0)) if isinstance(j.A, fmpq_poly) else (frequency, forcing)
                return self._value(self._response_polynomial(j, force), x)

            found = []
            for A, regime in self._zeros(function, self._state_range(frequency, forcing)):
                A = self._newton_amplitude(frequency, A, regime, forcing)
                d = self.derivatives(frequency, A, regime, forcing)
                found.append(Amplitude(A, arb.atan2(-d["I"], -d["R"]), _sign(d["A"]) > 0, regime))
            return sorted(found, key=lambda a: a.A.mid())

    def _newton_amplitude(self, Omega: arb, A: arb, regime: str, forcing: arb) -> arb:
        x = arb(A.mid())
        for _ in range(8):
            d = self.derivatives(Omega, x, regime, forcing)
            x = arb((x - d["F"] / d["A"]).mid())
        box = arb(x, arb(2) ** (-BITS // 2))
        new = x - self.derivatives(Omega, x, regime, forcing)["F"] / self.derivatives(Omega, box, regime, forcing)["A"]
        if not (box.contains_interior(new) and A.overlaps(new)):
            raise ArithmeticError("interval Newton fails for an amplitude")
        return new

    # ---- extrema of the forcing on the fold locus -------------------------------------------------------------------

    @cached_property
    def extrema(self) -> list[Point]:
        """Every local minimum and maximum of F_0 along the fold locus, by rising F_0 (kind cusp, isola or corner)."""
        with precision(BITS):
            points = self.cusps + self._isolas() + self._corner_extrema()
            for p in points:
                p.F_0 = self.forcing(p.Omega, p.A, p.regime)
            return sorted(points, key=lambda p: p.F_0.mid())

    @cached_property
    def ends(self) -> list[tuple[arb, int, arb]]:
        """Where the fold locus runs into Omega = 0: F_A vanishes there, or is of one sign with h at the corner."""
        with precision(BITS):
            points = self._zeros(lambda j: self._slope_polynomial(j)[0], self._fold_range)
            if self.u_cr is not None:
                own, j = self._at(self.u_cr, CORNER)
                if _sign(own._slope_polynomial(j)[0]) == _sign(j.h):
                    points.append((self.u_cr, CORNER))
            found = []
            for A, regime in points:
                own, j = self._at(A, regime)
                constant, linear, *_ = own._peak_polynomial(j)
                n = self.at_rest(A, regime)[0]
                trend = _sign(linear) if self.zeta == 0 or constant == 0 else _sign(constant)
                found.append((n if j.h.contains(0) else (j.h * j.h + n * n).sqrt(), trend, A))
            return found

    def fold_count(self, F_0: Number) -> int:
        """The number of folds at F_0 from the extrema of the fold locus alone."""
        with precision(BITS):
            forcing = arb(exact(F_0))
            count = 0
            for p in self.extrema:
                if p.F_0 < forcing:
                    count += 2 if p.sense == "min" else -2
                elif not p.F_0 > forcing:
                    raise ArithmeticError("this forcing is critical")
            return count + sum(trend for level, trend, _ in self.ends if level < forcing)

    def onset(self) -> Point | None:
        """The lowest minimum of F_0 on the fold locus; None when it has none."""
        return next((p for p in self.extrema if p.sense == "min"), None)

    def _no_cusp(self, t: arb) -> bool:
        """A proof for a piece beyond the corner, down to it: the resultant vanishes there.

        Where I_A >= 0, F_A = 0 needs R R_A < 0, which for h_A < h/A leaves R > 0 only; then h_AA > 0 makes F_AA > 0, as
        I_AA >= 0. Where I_A < 0, R and R_A have one sign, and minus leaves Omega^2 < -h/A: there R = -I I_A/R_A narrows
        Omega, and F_AA R_A must not vanish.
        """
        if not t.lower() >= 0:
            t = arb(0).union(arb(t.upper()))
        A, h, g, k = self.detached(t)
        if not (k > 0 and A * g < t * h):
            return False
        if not self.ends_at_u_cr:
            return True
        n, n_A, n_AA, _ = self.at_rest(A, DETACHED)
        zeta, d, most = arb(self.zeta), self.d, (-h / A).upper()
        if not most > 0:
            return True
        W = arb(0).union(arb(most))
        for _ in range(6):
            least = arb(W.lower()) if W.lower() >= 0 else arb(0)  # a ball from 0 on reaches a little below it
            Omega, turn = least.sqrt().union(arb(W.upper()).sqrt()), t * W + g
            if not turn < 0:
                return False
            lag, lag_A = n + A * Omega * (2 * zeta + d * A * Omega), n_A + 2 * zeta * Omega + 2 * d * A * W
            low = (-h - t * lag * lag_A / turn) / A
            if low < W or low > W:
                return True
            W = low.intersection(W)
        return not (turn**3 - lag * lag_A * k + t * t * turn * (lag_A * lag_A + lag * (n_AA + 2 * d * W))).contains(0)

    @cached_property
    def cusps(self) -> list[Point]:
        """Where F_A = F_AA = 0, by rising F_0."""

        def function(j: Jet) -> Any:
            slope, bend = self._slope_polynomial(j), self._bend_polynomial(j)
            # A n does not depend on A beyond u_cr: no odd powers are left, and a resultant in Omega would be a square
            even = self._even or (self.ends_at_u_cr and self._beyond(j))
            return bezout(slope[::2], bend[::2]) if even else bezout(slope, bend)

        with precision(BITS):
            zeros = self._zeros(function, self._fold_range, self._no_cusp)
            points = self._common(zeros, lambda own, j: own._slope_polynomial(j), arb(0), ("A", "AA"))
            for p in points:
                p.F_0 = self.forcing(p.Omega, p.A, p.regime)
                d = self.derivatives(p.Omega, p.A, p.regime, p.F_0)
                p.kind, p.sense = "cusp", "min" if _sign(d["O"] * d["AAA"] * d["AO"]) < 0 else "max"
            return sorted(points, key=lambda p: p.F_0.mid())

    def _isolas(self) -> list[Point]:
        if self.zeta == 0 and self.c_2 == 0:  # F_Omega = 4 A Omega R then, and F_A > 0 where R = 0
            return []

        def function(j: Jet) -> Any:
            slope, peak = self._slope_polynomial(j), self._peak_polynomial(j)
            # less a multiple of Omega F_Omega, so that the leading power, which vanishes at the corner, is not there
            reduced = [peak[3] * one - slope[4] * below for one, below in zip(slope[1:4], peak[:3], strict=True)]
            reduced = [peak[3] * slope[0], *reduced]
            if self._even:  # F_Omega/Omega
                return bezout(reduced[::2], peak[1::2])
            return bezout(reduced, peak)

        zeros = self._zeros(function, self._fold_range)
        points = self._common(zeros, lambda own, j: own._peak_polynomial(j), arb(0), ("A", "O"))
        for p in points:
            d = self.derivatives(p.Omega, p.A, p.regime, arb(0))
            p.kind, p.sense = "isola", "min" if _sign(d["AA"] * (d["AA"] * d["OO"] - d["AO"] ** 2)) > 0 else "max"
        return points

    def _corner_extrema(self) -> list[Point]:
        u = self.u_cr
        if u is None:
            return []
        if not self.force(u) - u < 0:
            raise NotImplementedError("the corner analysis is for a force that jumps up where the springs detach")
        own, j = self._at(u, CORNER)
        points = []

        def of(Omega: arb) -> dict[str, arb]:
            return self.derivatives(Omega, u, CORNER, arb(0))

        if j.h < 0:
            # the joint with the detached locus is on the backbone, where F_Omega > 0. Along the corner Omega rises from
            # there. Beyond it h = h(u) + g u t + ..., and R = -I I_A t/g + ... from F_A = 0, with g < 0
            Omega = (-j.h / u).sqrt()
            n, n_A, *_ = self.at_rest(u, DETACHED)
            lag = n + u * Omega * (2 * arb(self.zeta) + self.d * u * Omega)
            lag_A = n_A + 2 * arb(self.zeta) * Omega + 2 * self.d * u * Omega**2
            g = self.detached(arb(0))[2]
            if _sign(g) < 0 < _sign(g * g * u + lag * lag_A):
                points.append(Point(Omega, u, CORNER, kind="corner", sense="min"))
        for Omega in self._roots(own._slope_polynomial(j)):
            d = of(Omega)
            trend = _sign(d["O"])
            along_corner = trend * _sign(d["AO"]) * _sign(d["R"])
            along_attached = trend * _sign(d["AA"] * d["AO"])
            if along_corner == along_attached:
                points.append(Point(Omega, u, CORNER, kind="corner", sense="min" if along_corner > 0 else "max"))
        undamped = self.zeta == 0 and self.c_2 == 0  # F_Omega = 4 A Omega R then: the joint on the backbone
        for Omega in [] if undamped else self._roots(own._peak_polynomial(j)):
            d = of(Omega)
            if _sign(d["R"]) == _sign(d["A"]):
                points.append(Point(Omega, u, CORNER, kind="corner", sense="min" if _sign(d["OO"]) > 0 else "max"))
        return points

    def detachment(self) -> Point:
        """The lowest forcing with a steady state of amplitude u_cr (sense "limit" when only Omega -> 0 attains it)."""
        with precision(BITS):
            u = self.u_cr
            own, j = self._at(u, CORNER)
            points = [Point(x, u, CORNER, sense="min") for x in self._roots(own._peak_polynomial(j))]
            points.append(Point(arb(0), u, CORNER, sense="limit"))
            for p in points:
                p.F_0 = self.forcing(p.Omega, u, CORNER)
            return min(points, key=lambda p: p.F_0.mid())

    # ---- the response curve as a whole -----------------------------------------------------------------------------

    def peaks(self, F_0: Number) -> list[Point]:
        """Every point with F = F_Omega = 0, by rising A: tops and bottoms of the curve F = 0."""
        with precision(BITS):
            forcing, rational = arb(exact(F_0)), exact(F_0)

            def peaked(j: Jet) -> Any:
                level = rational if isinstance(j.A, fmpq_poly) else forcing
                response, peak = self._response_polynomial(j, level), self._peak_polynomial(j)
                if self._even:  # F_Omega/Omega
                    return bezout(response[::2], [*peak[1::2], 0 * j.A])
                return bezout(response, [*peak, 0 * j.A])

            zeros = self._zeros(peaked, self._response_range(forcing))
            points = self._common(zeros, lambda own, j: own._peak_polynomial(j), forcing, ("F", "O"))
            for p in points:
                d = self.derivatives(p.Omega, p.A, p.regime, forcing)
                p.sense = "max" if _sign(d["OO"] * d["A"]) > 0 else "min"
                p.F_0 = forcing
            return sorted(points, key=lambda p: p.A.mid())


class RodSpring(Oscillator):
    """The isolator with the fifth-order force: lam, r, delta_h and damping."""

    def _stiffness(self) -> tuple[fmpq, fmpq, fmpq]:
        p = self.parameters
        stiffness, left = p["lam"] * p["r"], 1 - p["delta_h"]
        if not 0 < p["delta_h"] < 1:
            raise ValueError("the oracle wants 0 < delta_h < 1")
        return 1 - stiffness * p["delta_h"], stiffness * left / 2, 3 * stiffness * left / 8

    @property
    def u_cr(self) -> arb:
        """sqrt(1 - (1 - delta_h)^2)."""
        return arb(1 - (1 - self.parameters["delta_h"]) ** 2).sqrt()


class Duffing(Oscillator):
    """f(u) = alpha u + beta u^3: alpha, beta and damping."""

    def _stiffness(self) -> tuple[fmpq, fmpq, fmpq]:
        return self.parameters["alpha"], self.parameters["beta"], fmpq(0)
