"""Parameters of an oscillator in; its averaged steady states, folds, onsets and branches out, to 40 certified digits.

The independent reference for the runtime's tests. It shares no code with `derivations/`, `generated/` or `src/`: the
restoring force is averaged here through the moments of sin^(2k), all arithmetic is FLINT's (exact rationals, and balls
that enclose the true value), and completeness is proved, not sampled:

* With m = 4 mu/pi, R = A Omega^2 + h, I = 2 zeta A Omega + m the response curve is F = R^2 + I^2 - F_0^2 = 0.
  A F_A/2 - F is a *quadratic* in Omega, so the folds are the zeros in A of an explicit resultant of a quadratic and
  the quartic F. While the mass stays attached (A <= u_cr) it is a polynomial with rational coefficients: all its roots
  are isolated exactly. Beyond, with A = u_cr sqrt(1 + t^2), it is analytic in t down to and including the corner t = 0,
  and `certified_roots.isolate` encloses every zero on a range outside which no fold can be.
* Every zero is a candidate. Omega follows from the quadratic; F and F_A decide; a Krawczyk step then proves that the
  enclosing box holds exactly one solution of the system itself.
* At A = u_cr the slope h_A jumps to -infinity (the truncated force is negative there), so F_A jumps to
  -sign(R) infinity: a response point on the corner is a fold where R and the attached F_A have the same sign.
* Independently, the number of folds at any F_0 is a Morse count on the fold locus: twice (minima of F_0 below, minus
  maxima below), plus the ends of the locus at Omega = 0. The extrema are the cusps (F_AA = 0), isola births
  (F_Omega = 0, where Omega^2 = h_A), and points on the corner. `fold_count` uses only these, `folds` none of them.

Numbers given as floats are taken exactly as their binary values; `fractions.Fraction` is exact too.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import Any

from flint import arb, arb_mat, arb_series, fmpq, fmpq_poly

from tests.oracles.certified_roots import isolate, polynomial_roots, precision

BITS = 280  # 84 digits to compute with; 40 are reported
DIGITS = 40
ATTACHED, DETACHED, CORNER = "attached", "detached", "corner"
Number = float | int | Fraction


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


def _moments(t: Any) -> list:
    """int_0^theta sin^2k, k = 1, 2, 3, with cot(theta) = t; t a ball or a Taylor polynomial.

    The closed form serves at the centre only. Around it the derivative by t, -sin^(2k+2) theta, is integrated: the
    closed form's terms cancel for large t and would make wide balls useless.
    """
    series = isinstance(t, arb_series)
    ball = t[0] if series else t
    centre = arb(ball.mid())
    sine_2 = 1 / (1 + centre * centre)
    product = centre * sine_2  # cos(theta) sin(theta)
    closed = [(arb.pi() / 2 - centre.atan() - product) / 2]
    closed.append((3 * closed[0] - product * sine_2) / 4)
    closed.append((5 * closed[1] - product * sine_2 * sine_2) / 6)
    square = 1 / (1 + t * t)
    square_of_ball = square[0] if series else square
    moments = []
    for k, value in enumerate(closed, start=1):
        moment = value - square_of_ball ** (k + 1) * (ball - centre)
        if series:
            moment = moment - (square ** (k + 1) * t.derivative()).integral()
        moments.append(moment)
    return moments


def _res_quadratic_quartic(a: Any, b: Any, c: Any, f4: Any, f2: Any, f1: Any, f0: Any) -> Any:
    """Res_x(a x^2 + b x + c, f4 x^4 + f2 x^2 + f1 x + f0), by the symmetric functions of the quadratic's roots."""
    power_2 = b * b - 2 * a * c
    return (
        f4 * f4 * c**4
        + f4 * f2 * c * c * power_2
        + f4 * f1 * b * c * (3 * a * c - b * b)
        + f4 * f0 * (power_2 * power_2 - 2 * a * a * c * c)
        + f2 * f2 * a * a * c * c
        - f2 * f1 * a * a * b * c
        + f2 * f0 * a * a * power_2
        + f1 * f1 * a * a * a * c
        - f1 * f0 * a * a * a * b
        + f0 * f0 * a**4
    )


def _res_quadratic_cubic(a: Any, b: Any, c: Any, f3: Any, f1: Any, f0: Any) -> Any:
    """Res_x(a x^2 + b x + c, f3 x^3 + f1 x + f0)."""
    power_2 = b * b - 2 * a * c
    return (
        f3 * f3 * c**3
        + f3 * f1 * c * power_2
        + f3 * f0 * b * (3 * a * c - b * b)
        + f1 * f1 * a * a * c
        - f1 * f0 * a * a * b
        + f0 * f0 * a**3
    )


@dataclass
class Jet:
    """A and h with derivatives by A; h_A = g / s and h_AA = k / s^3, where s = t beyond the corner and 1 before it."""

    A: Any
    h: Any
    g: Any = None
    k: Any = None
    s: Any = 1


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


@dataclass
class Response:
    """The curve F = 0 at one forcing: its connected components in 0 < Omega <= 2 and its amplitude extrema."""

    components: int
    peaks: list[Point] = field(default_factory=list)


class Oscillator:
    """Averaged oscillator with h(A) given piecewise; parameters by name as exact rationals."""

    inputs: tuple[str, ...]

    def __init__(self, **parameters: Number | fmpq) -> None:
        self.parameters = {k: v if isinstance(v, fmpq) else exact(v) for k, v in parameters.items()}
        self.zeta, self.mu = self.parameters["zeta"], self.parameters["mu"]
        if not self.zeta > 0 or self.mu < 0:
            raise ValueError("the oracle wants zeta > 0 and mu >= 0")
        with precision(2 * BITS):
            self._m_rational = exact_ball(4 * arb(self.mu) / arb.pi())
        self.alpha, self.beta, self.gamma = self._stiffness()

    # ---- the mechanism -------------------------------------------------------------------------------------------

    def _stiffness(self) -> tuple[fmpq, fmpq, fmpq]:
        raise NotImplementedError

    @property
    def u_cr(self) -> arb | None:
        """Where the springs leave the rod; None when they never do."""
        return None

    @property
    def m(self) -> arb:
        """4 mu / pi."""
        return 4 * arb(self.mu) / arb.pi()

    def force(self, u: Any) -> Any:
        """The restoring force of the attached piece at u, vertical spring included."""
        return arb(self.alpha) * u + arb(self.beta) * u**3 + arb(self.gamma) * u**5

    def attached(self, A: Any) -> tuple[Any, Any, Any, Any]:
        """h, h', h'', h''' for A <= u_cr; A a ball, a Taylor polynomial, or the variable of a rational polynomial."""
        a, b, c = self.alpha, 3 * self.beta / 4, 5 * self.gamma / 8
        if not isinstance(A, fmpq_poly):
            a, b, c = arb(a), arb(b), arb(c)
        A2 = A * A
        return (
            -A * (a + A2 * (b + A2 * c)),
            -(a + A2 * (3 * b + A2 * (5 * c))),
            -A * (6 * b + A2 * (20 * c)),
            -(6 * b + A2 * (60 * c)),
        )

    def detached(self, t: Any) -> tuple[Any, Any, Any, Any]:
        """A, h, t h', t^3 h'' at A = u_cr sqrt(1 + t^2), analytic in t >= 0.

        The force beyond the vertical spring's u acts for |sin| <= u_cr/A = sin(theta) only, so that
        h = -A - (4/pi) int_0^theta F_k(A sin x) sin x dx with moments M_2k = int_0^theta sin^2k.
        """
        u, pi = self.u_cr, arb.pi()
        a, b, c = arb(self.alpha) - 1, arb(self.beta), arb(self.gamma)
        t2 = t * t
        A = u * (1 + t2).sqrt()
        A2 = A * A
        M_2, M_4, M_6 = _moments(t)
        force, slope = u * (a + u**2 * (b + u**2 * c)), a + u**2 * (3 * b + u**2 * (5 * c))
        h = -A - (4 / pi) * A * (a * M_2 + A2 * (b * M_4 + A2 * (c * M_6)))
        moments = a * M_2 + A2 * (3 * b * M_4 + A2 * (5 * c * M_6))
        g = -t - (4 / pi) * (t * moments - force * u / A2)
        k = -(4 / pi) * (
            t2 * t * A * (6 * b * M_4 + 20 * c * A2 * M_6)
            - slope * u * u * t2 / (A2 * A)
            + force * (2 * u * t2 / (A2 * A) + 1 / (u * A))
        )
        return A, h, g, k

    def third_derivative(self, A: arb) -> arb:
        """h''' for A > u_cr."""
        u, pi = self.u_cr, arb.pi()
        a, b, c = arb(self.alpha) - 1, arb(self.beta), arb(self.gamma)
        w = (A * A - u * u).sqrt()
        _, M_4, M_6 = _moments(w / u)
        force, slope = u * (a + u**2 * (b + u**2 * c)), a + u**2 * (3 * b + u**2 * (5 * c))
        return -(4 / pi) * (
            6 * b * M_4
            + 60 * c * A**2 * M_6
            - (u / (w * A)) * (6 * b * u**4 / A**3 + 20 * c * u**6 / A**3)
            + slope * u**3 * (3 / (A**4 * w) + 1 / (A**2 * w**3))
            - force * u**2 * (6 / (A**4 * w) + 3 / (A**2 * w**3) + 3 / w**5)
        )

    def h(self, A: arb, regime: str) -> tuple[arb, arb, arb, arb]:
        """h, h', h'', h''' at a ball A on the given side of the corner (the corner itself counts as attached)."""
        if regime != DETACHED:
            return self.attached(A)
        t = self.t(A)
        _, h, g, k = self.detached(t)
        return h, g / t, k / t**3, self.third_derivative(A)

    def t(self, A: arb) -> arb:
        """The parameter of A = u_cr sqrt(1 + t^2)."""
        return (A * A - self.u_cr**2).sqrt() / self.u_cr

    def regime(self, A: arb) -> str:
        """On which side of the corner A lies."""
        return ATTACHED if self.u_cr is None or A < self.u_cr else DETACHED if A > self.u_cr else CORNER

    # ---- F and its derivatives at a point ------------------------------------------------------------------------

    def derivatives(self, Omega: arb, A: arb, regime: str, F_0: arb) -> dict[str, arb]:
        """F and its partial derivatives up to what cusps need, with R and I, at a ball."""
        zeta, m = arb(self.zeta), self.m
        h, h_A, h_AA, h_AAA = self.h(A, regime)
        W = Omega * Omega
        R, damping = A * W + h, 2 * zeta * A * Omega + m
        R_A, R_Omega, I_A, I_Omega = W + h_A, 2 * A * Omega, 2 * zeta * Omega, 2 * zeta * A
        return {
            "R": R,
            "I": damping,
            "F": R * R + (damping - F_0) * (damping + F_0),
            "A": 2 * (R * R_A + damping * I_A),
            "O": 2 * (R * R_Omega + damping * I_Omega),
            "AA": 2 * (R_A * R_A + R * h_AA + I_A * I_A),
            "AO": 2 * (R_Omega * R_A + 2 * R * Omega + I_Omega * I_A + 2 * damping * zeta),
            "OO": 2 * (R_Omega * R_Omega + 2 * R * A + I_Omega * I_Omega),
            "AAA": 2 * (3 * R_A * h_AA + R * h_AAA),
            "AAO": 2 * (4 * Omega * R_A + R_Omega * h_AA + 4 * zeta * I_A),
        }

    def forcing(self, Omega: arb, A: arb, regime: str) -> arb:
        """The forcing whose response curve passes through (Omega, A)."""
        d = self.derivatives(Omega, A, regime, arb(0))
        return d["F"].sqrt()

    # ---- one-variable functions whose zeros are candidates ---------------------------------------------------------

    def _constants(self, A: Any) -> tuple[Any, Any]:
        if isinstance(A, fmpq_poly):
            return self.zeta, self._m_rational
        return arb(self.zeta), self.m

    def _fold_quadratic(self, j: Jet, F_0: Any) -> tuple[Any, Any, Any]:
        """s (A F_A/2 - F) as a quadratic in Omega."""
        zeta, m = self._constants(j.A)
        lag = j.s * j.h - j.A * j.g
        return j.A * lag, 2 * zeta * m * j.A * j.s, j.h * lag + j.s * (m * m - F_0 * F_0)

    def _fold_resultant(self, j: Jet, F_0: Any) -> Any:
        zeta, m = self._constants(j.A)
        a, b, c = self._fold_quadratic(j, F_0)
        f4, f2 = j.A * j.A, 2 * j.A * j.h + 4 * zeta * zeta * j.A * j.A
        f0 = j.h * j.h + m * m - F_0 * F_0
        if self.mu == 0:  # everything is even in Omega: the resultant in Omega would be a square
            return f4 * c * c - f2 * a * c + f0 * a * a
        return _res_quadratic_quartic(a, b, c, f4, f2, 4 * zeta * m * j.A, f0)

    def _cusp_quadratic(self, j: Jet) -> tuple[Any, Any, Any]:
        """s^3 (F_A/2 - A F_AA/2) as a quadratic in Omega."""
        zeta, m = self._constants(j.A)
        s2 = j.s * j.s
        lag = j.s * j.h - j.A * j.g
        return (
            s2 * lag - j.A * j.A * j.k,
            2 * zeta * m * s2 * j.s,
            j.g * j.s * lag - j.A * j.h * j.k,
        )

    def _cusp_resultant(self, j: Jet) -> Any:
        zeta, _ = self._constants(j.A)
        a, b, c = self._cusp_quadratic(j)
        s2 = j.s * j.s
        f4, f2, f0 = (
            s2 * j.s,
            2 * j.g * s2 + j.A * j.k + 4 * zeta * zeta * s2 * j.s,
            j.g * j.g * j.s + j.h * j.k,
        )
        if self.mu == 0:
            return f4 * c * c - f2 * a * c + f0 * a * a
        return _res_quadratic_quartic(a, b, c, f4, f2, 0 * f4, f0)

    def _peak_quadratic(self, j: Jet, F_0: Any) -> tuple[Any, Any, Any]:
        """F - Omega F_Omega/4 as a quadratic in Omega."""
        zeta, m = self._constants(j.A)
        e = j.h + 2 * zeta * zeta * j.A
        return j.A * e, 3 * zeta * m * j.A, j.h * j.h + m * m - F_0 * F_0

    def _peak_resultant(self, j: Jet, F_0: Any) -> Any:
        zeta, m = self._constants(j.A)
        e = j.h + 2 * zeta * zeta * j.A
        a, b, c = self._peak_quadratic(j, F_0)
        if self.mu == 0:
            return c - e * e
        return _res_quadratic_cubic(a, b, c, j.A, e, j.A * 0 + zeta * m)

    def _isola_function(self, j: Jet) -> Any:
        """On F_A = 0, F_Omega = 0 exactly where Omega^2 = h_A: then Omega (A h_A + h + 2 zeta^2 A) + zeta m = 0."""
        zeta, m = self._constants(j.A)
        return j.g * (j.A * j.g + j.h + 2 * zeta * zeta * j.A) ** 2 - zeta * zeta * m * m

    # ---- zeros on both sides of the corner ------------------------------------------------------------------------

    def _zeros(
        self,
        function: Callable[[Jet], Any],
        t_max: arb | None,
        exclude: Callable[[arb], bool] | None = None,
    ) -> list[tuple[arb, str]]:
        """All zeros in A of function(jet): attached by exact polynomials, detached up to t_max by enclosure."""
        A = fmpq_poly([0, 1])
        h, h_A, h_AA, _ = self.attached(A)
        polynomial = function(Jet(A, h, h_A, h_AA, fmpq_poly([1])))
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

    @cached_property
    def _fold_range(self) -> arb | None:
        """t beyond which F_A > 0 for every Omega, whatever the forcing.

        With h = -A + e and |e|/A, |e'| <= zeta/2 the quartic F_A/(2A) stays above
        4 zeta^2 - zeta^2/2 - 2 zeta^3 - 4 zeta^4.
        """
        if self.u_cr is None:
            return None
        zeta, u, pi = arb(self.zeta), self.u_cr, arb.pi()
        if not zeta < arb("0.6"):
            raise ValueError("the range of folds is only bounded for zeta < 0.6")
        parts = [abs(arb(self.alpha) - 1), abs(arb(self.beta)) * u**2, abs(arb(self.gamma)) * u**4]
        force, slope = u * sum(parts, arb(0)), parts[0] + 3 * parts[1] + 5 * parts[2]
        A = 2 * u
        while True:
            s = u / A
            e = (4 / pi) * force * s**2 / A
            e_A = (4 / pi) * (slope * pi / 2 * s**3 + force * s**3 / u / (arb(3) / 4).sqrt())
            if e < zeta / 2 and e_A < zeta / 2:
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

    # ---- from a zero to a certified point -------------------------------------------------------------------------

    def _omegas(self, quadratic: Callable[[Jet], tuple], A: arb, regime: str) -> list[arb]:
        """Positive roots of a quadratic in Omega at the ball A."""
        h, h_A, h_AA, _ = self.h(A, regime)
        a, b, c = quadratic(Jet(A, h, h_A, h_AA, arb(1)))
        discriminant = b * b - 4 * a * c
        if discriminant < 0:
            return []
        root = discriminant.sqrt()
        if not root > 0:
            raise ArithmeticError("double root of the quadratic in Omega")
        q = -(b + root) / 2 if self.mu else None
        candidates = [root / (2 * abs(a))] if q is None else [q / a, c / q]
        return [x for x in candidates if not x < 0]

    def _krawczyk(self, Omega: arb, A: arb, system: Callable[[arb, arb], tuple[list, list]]) -> tuple[arb, arb]:
        """A box with exactly one solution of the 2 x 2 system(Omega, A) -> values, rows of the Jacobian."""
        x, y = arb(Omega.mid()), arb(A.mid())
        for _ in range(12):
            values, rows = system(x, y)
            step = arb_mat(rows).solve(arb_mat(2, 1, values))
            x, y = arb((x - step[0, 0]).mid()), arb((y - step[1, 0]).mid())
        radius = arb(2) ** (-BITS // 2)
        box_x, box_y = arb(x, radius), arb(y, radius)
        values, rows = system(x, y)
        _, box_rows = system(box_x, box_y)
        inverse = arb_mat(rows).inv().mid()
        correction = inverse * arb_mat(2, 1, values)
        spread = arb_mat([[1, 0], [0, 1]]) - inverse * arb_mat(box_rows)
        delta = spread * arb_mat(2, 1, [arb(0, radius), arb(0, radius)])
        new_x, new_y = x - correction[0, 0] + delta[0, 0], y - correction[1, 0] + delta[1, 0]
        if not (box_x.contains_interior(new_x) and box_y.contains_interior(new_y)):
            raise ArithmeticError("Krawczyk's test fails")
        if not (Omega.overlaps(new_x) and A.overlaps(new_y)):
            raise ArithmeticError("Newton's method left the enclosure")
        return new_x, new_y

    def _accept(
        self,
        zeros: list[tuple[arb, str]],
        quadratic: Callable[[Jet], tuple],
        F_0: arb,
        names: tuple[str, str],
    ) -> list[Point]:
        """The candidates (A from a resultant, Omega from a quadratic) at which both named functions vanish."""
        points = []
        jacobian = {"F": ("O", "A"), "A": ("AO", "AA"), "AA": ("AAO", "AAA"), "O": ("OO", "AO")}
        for A, regime in zeros:

            def system(x: arb, y: arb, regime: str = regime) -> tuple[list, list]:
                d = self.derivatives(x, y, regime, F_0)
                return [d[n] for n in names], [[d[k] for k in jacobian[n]] for n in names]

            hits = []
            for Omega in self._omegas(quadratic, A, regime):
                values, _ = system(Omega, A)
                if all(v.contains(0) for v in values):
                    hits.append(self._krawczyk(Omega, A, system))
            if len(hits) > 1:
                raise ArithmeticError("two points at one amplitude")
            points += [Point(x, y, regime) for x, y in hits if x > 0]
        return points

    # ---- what is asked ----------------------------------------------------------------------------------------------

    def folds(self, F_0: Number) -> list[Point]:
        """Every (Omega, A) with F = F_A = 0 or on the corner between F_A of opposite signs, by rising Omega."""
        with precision(BITS):
            forcing, rational = arb(exact(F_0)), exact(F_0)
            zeros = self._zeros(
                lambda j: self._fold_resultant(j, rational if isinstance(j.A, fmpq_poly) else forcing),
                self._fold_range,
            )
            points = self._accept(zeros, lambda j: self._fold_quadratic(j, forcing), forcing, ("F", "A"))
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
            F_0 = F_0 if isinstance(F_0, arb) else arb(exact(F_0))
            h = self.h(A, regime or self.regime(A))[0]
            zeta, m = arb(self.zeta), self.m
            return self._quartic(
                A * A, 2 * A * h + 4 * zeta**2 * A * A, 4 * zeta * m * A, h * h + (m - F_0) * (m + F_0)
            )

    def _quartic(self, f4: arb, f2: arb, f1: arb, f0: arb) -> list[arb]:
        """Positive roots of a depressed quartic whose coefficients are balls of relative radius ~ 2^-BITS.

        Isolated exactly for the balls' centres; then each is enclosed for the balls by an interval Newton step.
        """
        centre = [exact_ball(x) for x in (f0, f1, f2)]
        roots = polynomial_roots(fmpq_poly([*centre, 0, exact_ball(f4)]), BITS)
        enclosed = []
        for root in roots:
            box = arb(root.mid(), arb(2) ** (-BITS // 2) * abs(root).upper())
            slope = f1 + box * (2 * f2 + box * box * 4 * f4)
            mid = arb(root.mid())
            new = mid - (f0 + mid * (f1 + mid * (f2 + mid * mid * f4))) / slope
            if not box.contains_interior(new):
                raise ArithmeticError("nearly double root of a quartic")
            enclosed.append(new)
        return enclosed

    def amplitudes(self, Omega: Number, F_0: Number) -> list[Amplitude]:
        """Every steady state at this frequency, by rising amplitude."""
        with precision(BITS):
            W, forcing = exact(Omega) ** 2, arb(exact(F_0))

            def function(j: Jet) -> Any:
                zeta, m = self._constants(j.A)
                polynomial = isinstance(j.A, fmpq_poly)
                R = j.A * (W if polynomial else arb(W)) + j.h
                friction = 2 * zeta * j.A * (exact(Omega) if polynomial else arb(exact(Omega))) + m
                return R * R + friction * friction - (exact(F_0) if polynomial else forcing) ** 2

            found = []
            for A, regime in self._zeros(function, self._response_range(forcing)):
                A = self._newton_amplitude(arb(exact(Omega)), A, regime, forcing)
                d = self.derivatives(arb(exact(Omega)), A, regime, forcing)
                phi = arb.atan2(-d["I"], -d["R"])
                found.append(Amplitude(A, phi, _sign(d["A"]) > 0, regime))
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
            points = self._cusps() + self._isolas() + self._corner_extrema()
            for p in points:
                p.F_0 = self.forcing(p.Omega, p.A, p.regime)
            return sorted(points, key=lambda p: p.F_0.mid())

    @cached_property
    def ends(self) -> list[tuple[arb, int, arb]]:
        """Where the fold locus runs into Omega = 0: the forcing there, its trend along the locus (+1, -1), and A.

        F_A/2 is h h_A at Omega = 0, so these are the zeros of h and of h_A; and the corner, where h_A > 0 before it.
        """
        with precision(BITS):
            found = []
            points = self._zeros(lambda j: j.h * j.g, self._fold_range)
            if self.u_cr is not None and self.h(self.u_cr, CORNER)[1] > 0:
                points.append((self.u_cr, CORNER))
            for A, regime in points:
                h = self.h(A, regime)[0]
                trend = 1 if self.mu else _sign(h + 2 * arb(self.zeta) ** 2 * A)
                found.append((self.m if h.contains(0) else (h * h + self.m**2).sqrt(), trend, A))
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

    def _cusps(self) -> list[Point]:
        def exclude(t: arb) -> bool:
            # F_A = 0 needs R (Omega^2 + h_A) < 0, which for h_A < h/A leaves R > 0 only; then h_AA > 0 makes F_AA > 0.
            if not t.lower() >= 0:
                t = arb(0).union(arb(t.upper()))
            A, h, g, k = self.detached(t)
            return k > 0 and A * g < t * h

        zeros = self._zeros(self._cusp_resultant, self._fold_range, exclude)
        points = self._accept(zeros, self._cusp_quadratic, arb(0), ("A", "AA"))
        for p in points:
            d = self.derivatives(p.Omega, p.A, p.regime, arb(0))
            p.kind, p.sense = "cusp", "min" if _sign(d["O"] * d["AAA"] * d["AO"]) < 0 else "max"
        return points

    def _isolas(self) -> list[Point]:
        # just beyond the corner h_A is -infinity: without a zero it stays negative, and Omega^2 = h_A impossible
        if any(regime == DETACHED for _, regime in self._zeros(lambda j: j.g, self._fold_range)):
            raise NotImplementedError("isola births beyond the corner")
        points = []
        for A, regime in self._zeros(self._isola_function, None):
            h, h_A, _, _ = self.h(A, regime)
            if not h_A > 0:
                continue
            Omega = h_A.sqrt()
            if not (Omega * (A * h_A + h + 2 * arb(self.zeta) ** 2 * A) + arb(self.zeta) * self.m).contains(0):
                continue

            def system(x: arb, y: arb, regime: str = regime) -> tuple[list, list]:
                d = self.derivatives(x, y, regime, arb(0))
                return [d["A"], d["O"]], [[d["AO"], d["AA"]], [d["OO"], d["AO"]]]

            Omega, A = self._krawczyk(Omega, A, system)
            d = self.derivatives(Omega, A, regime, arb(0))
            sense = "min" if _sign(d["AA"] * (d["AA"] * d["OO"] - d["AO"] ** 2)) > 0 else "max"
            points.append(Point(Omega, A, regime, kind="isola", sense=sense))
        return points

    def _corner_extrema(self) -> list[Point]:
        """Extrema on {A = u_cr, R and the attached F_A of one sign}, joints with the locus on either side included."""
        u = self.u_cr
        if u is None:
            return []
        if not self.force(u) - u < 0:
            raise NotImplementedError("the corner analysis is for a force that jumps up where the springs leave")
        zeta, m = arb(self.zeta), self.m
        h, h_A, _, _ = self.h(u, CORNER)
        points = []

        def trend(Omega: arb) -> int:
            return _sign(self.derivatives(Omega, u, CORNER, arb(0))["O"])

        # the joint with the detached locus is on the backbone, and a minimum: both ways lead to larger Omega, and
        # F_Omega > 0 there
        if h < 0:
            points.append(Point((-h / u).sqrt(), u, CORNER, kind="corner", sense="min"))
        # the joints with the attached locus
        for Omega in self._quartic(u, h + u * h_A + 4 * zeta**2 * u, 2 * zeta * m, h * h_A):
            d = self.derivatives(Omega, u, CORNER, arb(0))
            rising = _sign(u * (4 * Omega**3) + 2 * (h + u * h_A + 4 * zeta**2 * u) * Omega + 2 * zeta * m)
            along_corner = trend(Omega) * rising * _sign(d["R"])
            along_attached = trend(Omega) * _sign(d["AA"] * d["AO"])  # -A direction: dOmega = +F_AA/F_AO
            if along_corner == along_attached:
                sense = "min" if along_corner > 0 else "max"
                points.append(Point(Omega, u, CORNER, kind="corner", sense=sense))
        # the interior: F_Omega = 0
        for Omega in self._peak_frequencies(u, h):
            d = self.derivatives(Omega, u, CORNER, arb(0))
            if _sign(d["R"]) == _sign(d["A"]):
                sense = "min" if _sign(d["OO"]) > 0 else "max"
                points.append(Point(Omega, u, CORNER, kind="corner", sense=sense))
        return points

    def _peak_frequencies(self, A: arb, h: arb) -> list[arb]:
        """Positive roots of the depressed cubic F_Omega/(4A) = 0."""
        e = h + 2 * arb(self.zeta) ** 2 * A
        if self.mu == 0:
            return [(-e / A).sqrt()] if e < 0 else []
        cubic = fmpq_poly([exact_ball(arb(self.zeta) * self.m), exact_ball(e), 0, exact_ball(A)])
        enclosed = []
        for root in polynomial_roots(cubic, BITS):
            box = arb(root.mid(), arb(2) ** (-BITS // 2))
            mid = arb(root.mid())
            new = mid - (mid * (A * mid * mid + e) + arb(self.zeta) * self.m) / (3 * A * box * box + e)
            if not box.contains_interior(new):
                raise ArithmeticError("nearly double root of the cubic")
            enclosed.append(new)
        return enclosed

    def detachment(self) -> Point:
        """The lowest forcing with a steady state of amplitude u_cr (sense "limit" when only Omega -> 0 attains it)."""
        with precision(BITS):
            u = self.u_cr
            h = self.h(u, CORNER)[0]
            points = [Point(x, u, CORNER, sense="min") for x in self._peak_frequencies(u, h)]
            points.append(Point(arb(0), u, CORNER, sense="limit"))
            for p in points:
                p.F_0 = self.forcing(p.Omega, u, CORNER)
            return min(points, key=lambda p: p.F_0.mid())

    # ---- the response curve as a whole -----------------------------------------------------------------------------

    def response(self, F_0: Number, Omega_max: int | None = 2) -> Response:
        """Connected components of {F = 0, 0 < Omega <= Omega_max, A > 0}, and the points with F = F_Omega = 0.

        Omega_max = None: no upper limit.

        Between the amplitudes where a root passes 0 or Omega_max, or two roots meet, the number of Omega is constant
        and the roots keep their order; so the components follow from the roots at one amplitude in each gap.
        """
        with precision(BITS):
            forcing, rational = arb(exact(F_0)), exact(F_0)
            t_max = self._response_range(forcing)

            def given(j: Jet) -> Any:
                return rational if isinstance(j.A, fmpq_poly) else forcing

            def through(Omega: int) -> Callable[[Jet], Any]:
                def function(j: Jet) -> Any:
                    zeta, m = self._constants(j.A)
                    R, friction = j.A * Omega**2 + j.h, 2 * zeta * j.A * Omega + m
                    return R * R + friction * friction - given(j) ** 2

                return function

            peak_zeros = self._zeros(lambda j: self._peak_resultant(j, given(j)), t_max)
            if self.mu == 0:
                extremes = self._peaks_without_friction(peak_zeros, forcing)
            else:
                extremes = self._accept(peak_zeros, lambda j: self._peak_quadratic(j, forcing), forcing, ("F", "O"))
            for p in extremes:
                d = self.derivatives(p.Omega, p.A, p.regime, forcing)
                p.sense = "max" if _sign(d["OO"] * d["A"]) > 0 else "min"
                p.F_0 = forcing
            events = [(A, "zero", None) for A, _ in self._zeros(through(0), t_max)]
            limit = arb.pos_inf() if Omega_max is None else arb(Omega_max)
            if Omega_max is not None:
                events += [(A, "edge", None) for A, _ in self._zeros(through(Omega_max), t_max)]
            events += [(p.A, "meet", p.Omega) for p in extremes if p.Omega < limit]
            events.sort(key=lambda e: e[0].mid())
            for (a, _, _), (b, _, _) in pairwise(events):
                if a.overlaps(b):
                    raise ArithmeticError("two events at one amplitude")
            return Response(self._components(events, forcing, limit), sorted(extremes, key=lambda p: p.A.mid()))

    def _peaks_without_friction(self, zeros: list[tuple[arb, str]], forcing: arb) -> list[Point]:
        points = []
        for A, regime in zeros:
            W = -self.h(A, regime)[0] / A - 2 * arb(self.zeta) ** 2
            if not W > 0:
                continue

            def system(x: arb, y: arb, regime: str = regime) -> tuple[list, list]:
                d = self.derivatives(x, y, regime, forcing)
                return [d["F"], d["O"]], [[d["O"], d["A"]], [d["OO"], d["AO"]]]

            points.append(Point(*self._krawczyk(W.sqrt(), A, system), regime))
        return points

    def _components(self, events: list[tuple], forcing: arb, limit: arb) -> int:
        if not events:
            return 0
        cuts = [arb(e[0].mid()) for e in events]
        middles = [cuts[0] / 2, *((a + b) / 2 for a, b in pairwise(cuts)), cuts[-1] * 2]
        rows = [[x for x in self.frequencies(arb(A.mid()), forcing) if x < limit] for A in middles]
        parent = {(i, j): (i, j) for i, row in enumerate(rows) for j in range(len(row))}

        def find(x: tuple[int, int]) -> tuple[int, int]:
            while parent[x] != x:
                x = parent[x]
            return x

        for i, (_, what, Omega) in enumerate(events):
            below, above = list(range(len(rows[i]))), list(range(len(rows[i + 1])))
            change = len(above) - len(below)
            many, row = (below, i) if change < 0 else (above, i + 1)
            if what == "zero" and abs(change) == 1:
                many.pop(0)
            elif what == "edge" and abs(change) == 1:
                many.pop()
            elif what == "meet" and abs(change) == 2:
                first = self._roots_below_double(Omega, events[i][0])
                parent[find((row, first))] = find((row, first + 1))
                del many[first : first + 2]
            else:
                raise ArithmeticError(f"{what}: {len(below)} roots below, {len(above)} above")
            for a, b in zip(below, above, strict=True):
                parent[find((i, a))] = find((i + 1, b))
        return len({find(x) for x in parent})

    def _roots_below_double(self, Omega: arb, A: arb) -> int:
        """How many positive Omega lie below a double root of F = f4 (x - Omega)^2 (x^2 + 2 Omega x + q)."""
        h = self.h(A, self.regime(A))[0]
        q = 2 * h / A + 4 * arb(self.zeta) ** 2 + 3 * Omega**2
        if q > 0:
            return 0
        return 1 if (Omega**2 - q).sqrt() - Omega < Omega else 0


class RodSpring(Oscillator):
    """The isolator with the fifth-order force: lam, r, delta_h, mu, zeta."""

    inputs = ("lam", "r", "delta_h", "mu", "zeta")

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
    """f(u) = alpha u + beta u^3 with friction and viscous damping: alpha, beta, mu, zeta."""

    inputs = ("alpha", "beta", "mu", "zeta")

    def _stiffness(self) -> tuple[fmpq, fmpq, fmpq]:
        return self.parameters["alpha"], self.parameters["beta"], fmpq(0)
