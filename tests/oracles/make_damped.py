"""Seeds in; tests/data/damped_*.json out: certified folds, onsets and states of oscillators with other laws of damping.

    python -m tests.oracles.make_damped

`averaged` does the work, with I = n + 2 zeta A Omega + d A^2 Omega^2 typed here: n = m + eta A, or m u_cr/A beyond u_cr
where only what is attached rubs; d = 8 c_2/(3 pi). With quadratic damping nothing is a quadratic in Omega any more: so
each pair of functions of Omega gives one of A, the determinant of their Bezout matrix, which is the resultant times a
power of a leading coefficient that is positive. Omega follows from the roots of a quartic, each enclosed, and
Krawczyk's test decides. Without viscous damping all is even in Omega: then the same in Omega^2.
The number of folds at each forcing is found twice, by isolating them and by the extrema of the forcing on the fold
locus; where the two differ the run stops.
"""

import json
import random
from collections.abc import Callable, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from flint import arb, fmpq, fmpq_poly

from tests.oracles.averaged import (
    BITS,
    CORNER,
    DETACHED,
    Amplitude,
    Duffing,
    Jet,
    Number,
    Oscillator,
    Point,
    RodSpring,
    _sign,
    digits,
    exact,
    exact_ball,
)
from tests.oracles.certified_roots import polynomial_roots, precision
from tests.oracles.conditioning import Conditioning
from tests.oracles.inertia import ByInertia
from tests.oracles.make_random_isolators import SEED, conditions, draw_duffing, draw_isolator, given, log_uniform, write

LAWS = ("eta", "c_2", "rubs")
EACH = 30
#: on a base that shakes, of four combinations of laws
SHAKEN = 40
DATA = Path(__file__).parents[1] / "data"
Coefficients = Sequence[Any]


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


class Damped(Oscillator):
    """Other laws of damping, to be mixed into a kind of oscillator: eta, c_2; friction on one piece only."""

    ends_at_u_cr = False

    def __init__(self, **parameters: Number | fmpq) -> None:
        self.parameters = {k: v if isinstance(v, fmpq) else exact(v) for k, v in parameters.items()}
        self.zeta, self.mu, self.eta, self.c_2 = (self.parameters[k] for k in ("zeta", "mu", "eta", "c_2"))
        if not self.zeta + self.eta + self.c_2 > 0:
            raise ValueError("the oracle wants damping beside friction")
        if self.ends_at_u_cr and (self.zeta == 0 or self.eta + self.c_2 > 0):
            raise NotImplementedError("friction that ends goes with viscous damping only")
        with precision(2 * BITS):
            self._m_rational, self._d_rational = exact_ball(4 * arb(self.mu) / arb.pi()), exact_ball(self.d)
        self.alpha, self.beta, self.gamma = self._stiffness()

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

    def derivatives(self, Omega: arb, A: arb, regime: str, F_0: arb) -> dict[str, arb]:
        zeta, d = arb(self.zeta), self.d
        h, h_A, h_AA, h_AAA = self.h(A, regime)
        n, n_A, n_AA, n_AAA = self.at_rest(A, regime)
        W = Omega * Omega
        R, R_A, R_O = A * W + h, W + h_A, 2 * A * Omega
        lag = n + A * Omega * (2 * zeta + d * A * Omega)
        lag_A, lag_O = n_A + 2 * zeta * Omega + 2 * d * A * W, 2 * zeta * A + 2 * d * A * A * Omega
        lag_AA, lag_AO, lag_OO, lag_AAO = n_AA + 2 * d * W, 2 * zeta + 4 * d * A * Omega, 2 * d * A * A, 4 * d * Omega
        return {
            "R": R,
            "I": lag,
            "I_A": lag_A,
            "F": R * R + (lag - F_0) * (lag + F_0),
            "A": 2 * (R * R_A + lag * lag_A),
            "O": 2 * (R * R_O + lag * lag_O),
            "AA": 2 * (R_A * R_A + R * h_AA + lag_A * lag_A + lag * lag_AA),
            "AO": 2 * (R_O * R_A + 2 * R * Omega + lag_O * lag_A + lag * lag_AO),
            "OO": 2 * (R_O * R_O + 2 * R * A + lag_O * lag_O + lag * lag_OO),
            "AAA": 2 * (3 * R_A * h_AA + R * h_AAA + 3 * lag_A * lag_AA + lag * n_AAA),
            "AAO": 2 * (4 * R_A * Omega + R_O * h_AA + 2 * lag_A * lag_AO + lag_O * lag_AA + lag * lag_AAO),
        }

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

    def _response_polynomial(self, j: Jet, F_0: Any) -> list[Any]:
        """F."""
        zeta, d, n, *_ = self._numbers(j)
        z, D = 2 * zeta * j.A, d * j.A * j.A
        return [
            j.h * j.h + n * n - F_0 * F_0,
            2 * z * n,
            2 * j.A * j.h + z * z + 2 * n * D,
            2 * z * D,
            j.A * j.A + D * D,
        ]

    def _lag_polynomial(self, j: Jet, F_0: Any) -> list[Any]:
        """s (A F_A/2 - F)."""
        zeta, d, n, n_A, *_ = self._numbers(j)
        z, D = 2 * zeta * j.A, d * j.A * j.A
        v, turn = j.A * n_A - n, j.A * j.g - j.s * j.h
        return [
            j.s * (n * v + F_0 * F_0) + turn * j.h,
            j.s * z * v,
            j.s * D * (v + n) + turn * j.A,
            j.s * z * D,
            j.s * D * D,
        ]

    def _slope_polynomial(self, j: Jet) -> list[Any]:
        """s F_A/2."""
        zeta, d, n, n_A, *_ = self._numbers(j)
        z, D, A = 2 * zeta * j.A, d * j.A * j.A, j.A
        return [
            j.h * j.g + j.s * n * n_A,
            j.s * (2 * zeta * n + z * n_A),
            j.s * (j.h + 2 * zeta * z + 2 * d * A * n + D * n_A) + A * j.g,
            j.s * (2 * d * A * z + 2 * zeta * D),
            j.s * (A + 2 * d * A * D),
        ]

    def _bend_polynomial(self, j: Jet) -> list[Any]:
        """s^3 F_AA/2."""
        zeta, d, n, n_A, n_AA, _ = self._numbers(j)
        z, D, A, s = 2 * zeta * j.A, d * j.A * j.A, j.A, j.s
        s3 = s * s * s
        return [
            s * j.g * j.g + j.h * j.k + s3 * (n_A * n_A + n * n_AA),
            s3 * (4 * zeta * n_A + z * n_AA),
            2 * s * s * j.g + A * j.k + s3 * (4 * zeta * zeta + 4 * d * A * n_A + 2 * d * n + D * n_AA),
            s3 * (8 * zeta * d * A + 2 * d * z),
            s3 * (1 + 4 * d * d * A * A + 2 * d * D),
        ]

    def _peak_polynomial(self, j: Jet) -> list[Any]:
        """F_Omega/2."""
        zeta, d, n, *_ = self._numbers(j)
        z, D = 2 * zeta * j.A, d * j.A * j.A
        return [n * z, 2 * j.A * j.h + z * z + 2 * n * D, 3 * z * D, 2 * (j.A * j.A + D * D)]

    def _resultant(self, f: Coefficients, g: Coefficients) -> Any:
        return bezout(f[::2], g[::2]) if self.zeta == 0 else bezout(f, g)

    def _roots(self, coefficients: Coefficients) -> list[arb]:
        """Positive roots of a polynomial in Omega whose coefficients are balls, each enclosed."""
        centre = fmpq_poly([exact_ball(arb(c)) for c in coefficients])
        enclosed = []
        for root in polynomial_roots(centre, BITS):
            mid = arb(root.mid())
            box = arb(mid, arb(2) ** (-BITS // 2) * abs(root).upper())
            value, slope = arb(0), arb(0)
            for power in range(len(coefficients) - 1, -1, -1):
                value = value * mid + coefficients[power]
            for power in range(len(coefficients) - 1, 0, -1):
                slope = slope * box + power * coefficients[power]
            new = mid - value / slope
            if not box.contains_interior(new):
                raise ArithmeticError("nearly double root in Omega")
            enclosed.append(new)
        return enclosed

    def _at(self, A: arb, regime: str) -> "tuple[Damped, Jet]":
        """The oscillator whose n is the one there, and h there."""
        h, h_A, h_AA, _ = self.h(A, regime)
        own = self
        if self.ends_at_u_cr and regime != DETACHED:
            own = self._rubbing_throughout
        return own, Jet(A, h, h_A, h_AA, arb(1))

    @property
    def _rubbing_throughout(self) -> "Damped":
        other = object.__new__(type(self))
        other.__dict__.update(self.__dict__)
        other.ends_at_u_cr = False
        return other

    # ---- what is asked ----------------------------------------------------------------------------------------------

    def _fold_bounds(self, A: arb) -> tuple[arb, arb]:
        """With h = -A + e: bounds of |e|/A and |e'| from A >= 2 u_cr on."""
        u, pi = self.u_cr, arb.pi()
        parts = [abs(arb(self.alpha) - 1), abs(arb(self.beta)) * u**2, abs(arb(self.gamma)) * u**4]
        force, slope = u * sum(parts, arb(0)), parts[0] + 3 * parts[1] + 5 * parts[2]
        s = u / A
        return (4 / pi) * force * s**2 / A, (4 / pi) * s**3 * (slope * pi / 2 + force / u / (arb(3) / 4).sqrt())

    @property
    def _fold_range(self) -> arb | None:
        """t beyond which F_A > 0 for every Omega, whatever the forcing.

        F_A/(2 A) = (y + p)(y + q) + I I_A/A with y = Omega^2 - 1 and |p|, |q| <= e. The product is not below -e^2, and
        above e^2 for |y| > 2 e. I I_A/A is not below eta^2 + 4 zeta^2 Omega^2 + 2 (d A Omega^2)^2, less (m u_cr)^2/A^4
        where friction ends. All of these grow with A, and e falls.
        """
        if self.u_cr is None:
            return None
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

    def _common(
        self,
        zeros: list[tuple[arb, str]],
        polynomial: Callable[["Damped", Jet], list[Any]],
        F_0: arb,
        names: tuple[str, str],
    ) -> list[Point]:
        """The candidates at which both named functions vanish; Omega from the roots of one polynomial."""
        rows = {"F": ("O", "A"), "A": ("AO", "AA"), "AA": ("AAO", "AAA"), "O": ("OO", "AO")}
        points = []
        for A, regime in zeros:

            def system(x: arb, y: arb, regime: str = regime) -> tuple[list, list]:
                d = self.derivatives(x, y, regime, F_0)
                return [d[n] for n in names], [[d[k] for k in rows[n]] for n in names]

            for Omega in self._roots(polynomial(*self._at(A, regime))):
                if all(value.contains(0) for value in system(Omega, A)[0]):
                    points.append(Point(*self._krawczyk(Omega, A, system), regime))
        return points

    def folds(self, F_0: Number) -> list[Point]:
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

    def frequencies(self, A: Number | arb, F_0: Number | arb, regime: str | None = None) -> list[arb]:
        with precision(BITS):
            A = A if isinstance(A, arb) else arb(exact(A))
            own, j = self._at(A, regime or self.regime(A))
            return self._roots(own._response_polynomial(j, F_0 if isinstance(F_0, arb) else arb(exact(F_0))))

    def amplitudes(self, Omega: Number, F_0: Number) -> list[Amplitude]:
        with precision(BITS):
            frequency, forcing = arb(exact(Omega)), arb(exact(F_0))

            def function(j: Jet) -> Any:
                rational = isinstance(j.A, fmpq_poly)
                x, force = (exact(Omega), exact(F_0)) if rational else (frequency, forcing)
                f = self._response_polynomial(j, force)
                return f[0] + x * (f[1] + x * (f[2] + x * (f[3] + x * f[4])))

            t_max = None
            if self.u_cr is not None:  # I = F_0 at most
                linear, square = arb(self.eta) + 2 * arb(self.zeta) * frequency, self.d * frequency**2
                top = forcing / linear if linear > 0 else (forcing / square).sqrt()
                t_max = self.t((top * arb("1.0001")).max(2 * self.u_cr))
            found = []
            for A, regime in self._zeros(function, t_max):
                A = self._newton_amplitude(frequency, A, regime, forcing)
                d = self.derivatives(frequency, A, regime, forcing)
                found.append(Amplitude(A, arb.atan2(-d["I"], -d["R"]), _sign(d["A"]) > 0, regime))
            return sorted(found, key=lambda a: a.A.mid())

    # ---- extrema of the forcing on the fold locus --------------------------------------------------------------------

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

    def _cusps(self) -> list[Point]:
        def function(j: Jet) -> Any:
            slope, bend = self._slope_polynomial(j), self._bend_polynomial(j)
            # A n does not depend on A beyond u_cr: no odd powers are left, and a resultant in Omega would be a square
            even = self.zeta == 0 or (self.ends_at_u_cr and self._beyond(j))
            return bezout(slope[::2], bend[::2]) if even else bezout(slope, bend)

        zeros = self._zeros(function, self._fold_range, self._no_cusp)
        points = self._common(zeros, lambda own, j: own._slope_polynomial(j), arb(0), ("A", "AA"))
        for p in points:
            d = self.derivatives(p.Omega, p.A, p.regime, arb(0))
            p.kind, p.sense = "cusp", "min" if _sign(d["O"] * d["AAA"] * d["AO"]) < 0 else "max"
        return points

    def _isolas(self) -> list[Point]:
        if self.zeta == 0 and self.c_2 == 0:  # F_Omega = 4 A Omega R then, and F_A > 0 where R = 0
            return []

        def function(j: Jet) -> Any:
            slope, peak = self._slope_polynomial(j), self._peak_polynomial(j)
            # less a multiple of Omega F_Omega, so that the leading power, which vanishes at the corner, is not there
            reduced = [peak[3] * one - slope[4] * below for one, below in zip(slope[1:4], peak[:3], strict=True)]
            reduced = [peak[3] * slope[0], *reduced]
            if self.zeta == 0:  # F_Omega/Omega
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
            raise NotImplementedError("the corner analysis is for a force that jumps up where the springs leave")
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

    @property
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


class DampedRod(Damped, RodSpring):
    """The isolator."""

    inputs = (*RodSpring.inputs, "eta", "c_2")


class ReleasedRod(DampedRod):
    """The isolator whose bearings rub while the rods are attached."""

    ends_at_u_cr = True


class DampedDuffing(Damped, Duffing):
    """One cubic piece."""

    inputs = (*Duffing.inputs, "eta", "c_2")


class ShakenDamped(ByInertia, Damped):
    """On a base that shakes; to be mixed into a kind of oscillator."""

    def _response_polynomial(self, j: Jet, F_0: Any) -> list[Any]:
        *lower, leading = super()._response_polynomial(j, 0 * F_0)
        return [*lower, leading - F_0 * F_0]

    def _lag_polynomial(self, j: Jet, F_0: Any) -> list[Any]:
        *lower, leading = super()._lag_polynomial(j, 0 * F_0)
        return [*lower, leading + j.s * F_0 * F_0]

    def amplitudes(self, Omega: Number, F_0: Number) -> list[Amplitude]:
        force = Fraction(F_0) * Fraction(Omega) ** 2
        return [] if not arb(exact(force)) > self.m else self.plain(**self.parameters).amplitudes(Omega, force)


class ShakenRod(ShakenDamped, DampedRod):
    """The isolator."""

    plain = DampedRod


class ShakenReleased(ShakenDamped, ReleasedRod):
    """The isolator whose bearings rub while the rods are attached."""

    plain = ReleasedRod


class ShakenDuffing(ShakenDamped, DampedDuffing):
    """One cubic piece."""

    plain = DampedDuffing


def drawn(law: str, index: int, rng: random.Random) -> tuple[Damped, dict[str, float]]:
    """Random oscillator number `index` of a law; every third has no viscous damping where it can do without."""
    rod = law == "rubs" or index % 2 == 0
    given = draw_isolator(rng, lambda: rng.uniform(0.02, 0.97)) if rod else draw_duffing(rng, index // 2)
    bare = index % 3 == 0 and law != "rubs" and given.get("beta", 1.0) > 0
    parameters = {
        **given,
        "zeta": 0.0 if bare else given["zeta"],
        "eta": log_uniform(rng, 0.003, 0.15) if law == "eta" else 0.0,
        "c_2": log_uniform(rng, 0.01, 1) if law == "c_2" else 0.0,
    }
    if law == "rubs":
        parameters["mu"] = log_uniform(rng, 0.001, 0.03)
        return ReleasedRod(**parameters), parameters
    return (DampedRod if rod else DampedDuffing)(**parameters), parameters


def case(law: str, index: int) -> dict:
    """One oscillator: its onset, and its folds and states at one forcing."""
    rng = random.Random(f"{SEED} damped {law} {index}")
    oscillator, parameters = drawn(law, index, rng)
    conditioning, onset = Conditioning(oscillator), oscillator.onset()
    m = float(oscillator.m.mid())
    if onset is None:
        F_0 = m + log_uniform(rng, 0.01, 1)
    else:
        F_SN = float(onset.F_0.mid())
        F_0 = F_SN * rng.choice([1.02, log_uniform(rng, 0.8, 6), log_uniform(rng, 1, 3)])
        F_0 = max(F_0, 1.05 * m)
    folds = oscillator.folds(F_0)
    if len(folds) != oscillator.fold_count(F_0):
        raise AssertionError(f"{len(folds)} folds found, {oscillator.fold_count(F_0)} counted: {parameters}, {F_0}")
    record: dict[str, Any] = {
        "mechanism": "duffing" if isinstance(oscillator, Duffing) else "rod_spring",
        "parameters": {k: given(v) for k, v in parameters.items()},
        "rubs": "attached" if oscillator.ends_at_u_cr else "throughout",
        "onset": onset
        and {
            "F_SN": digits(onset.F_0),
            "Omega": digits(onset.Omega),
            "A": digits(onset.A),
            "kind": onset.kind,
            "regime": onset.regime,
            "global": all(onset.F_0 < level for level, trend, _ in oscillator.ends if trend > 0),
            **conditions(conditioning.extremum(onset)),
        },
        "F_0": given(F_0),
        "folds": [
            {
                "Omega": digits(p.Omega),
                "A": digits(p.A),
                "kind": p.kind,
                "corner": p.regime == CORNER,
                **conditions(conditioning.fold(p)),
            }
            for p in folds
        ],
        "amplitudes": [],
    }
    at = [float(p.Omega.mid()) for p in folds]
    among = rng.uniform(at[0], at[-1]) if len(at) > 1 else rng.uniform(0.9, 1.1)
    for Omega in (among, log_uniform(rng, 0.3, 3)):
        steady = [
            {
                "A": digits(state.A),
                "phi": digits(state.phi),
                "stable": state.stable,
                **conditions(conditioning.amplitude(state, Omega, F_0)),
            }
            for state in oscillator.amplitudes(Omega, F_0)
        ]
        record["amplitudes"].append({"Omega": given(Omega), "steady": steady})
    return record


def shaken(index: int) -> dict:
    """Oscillator number `index` of the four combinations in turn, on a base that shakes."""
    rng = random.Random(f"{SEED} damped base {index}")
    law = ("eta", "c_2", "both", "rubs")[index % 4]
    rod = law == "rubs" or index // 4 % 2 == 0
    numbers = draw_isolator(rng, lambda: rng.uniform(0.02, 0.97)) if rod else draw_duffing(rng, index // 4)
    bare = index // 4 % 3 == 0 and law != "rubs" and numbers.get("beta", 1.0) > 0
    parameters = {
        **numbers,
        "zeta": 0.0 if bare else numbers["zeta"],
        "eta": log_uniform(rng, 0.003, 0.15) if law in ("eta", "both") else 0.0,
        "c_2": log_uniform(rng, 0.01, 1) if law in ("c_2", "both") else 0.0,
    }
    if law == "rubs":
        parameters["mu"] = log_uniform(rng, 0.001, 0.03)
    kind = ShakenReleased if law == "rubs" else ShakenRod if rod else ShakenDuffing
    oscillator = kind(**parameters)
    with precision(BITS):
        levels = [float(oscillator.forcing(p.Omega, p.A, p.regime).mid()) for p in oscillator._cusps()]
    F_0 = log_uniform(rng, 0.6, 3) * min(levels, default=0.05)
    if rod:
        F_0 = min(F_0, 0.9 * float(oscillator.u_cr.mid()))
    conditioning, folds = Conditioning(oscillator), oscillator.folds(F_0)
    around = float(folds[0].Omega.mid()) if folds else 1.0
    return {
        "mechanism": "rod_spring" if rod else "duffing",
        "parameters": {k: given(v) for k, v in parameters.items()},
        "rubs": "attached" if law == "rubs" else "throughout",
        "F_0": given(F_0),
        "folds": [
            {
                **{"Omega": digits(p.Omega), "A": digits(p.A), "kind": p.kind, "corner": p.regime == CORNER},
                **conditions(conditioning.fold(p)),
            }
            for p in folds
        ],
        "amplitudes": [
            {
                "Omega": given(Omega),
                "steady": [
                    {
                        **{"A": digits(state.A), "phi": digits(state.phi), "stable": state.stable},
                        **conditions(conditioning.amplitude(state, Omega, F_0)),
                    }
                    for state in oscillator.amplitudes(Omega, F_0)
                ],
            }
            for Omega in (around * rng.uniform(1.005, 1.05), log_uniform(rng, 0.3, 3))
        ],
    }


def main() -> None:
    for law in LAWS:
        cases = [case(law, index) for index in range(EACH)]
        write(DATA / f"damped_{law}.json", cases)
        print(json.dumps({"law": law, "cases": len(cases), "folds": sum(len(one["folds"]) for one in cases)}))
    cases = [shaken(index) for index in range(SHAKEN)]
    write(DATA / "damped_base.json", cases)
    print(json.dumps({"base": len(cases), "folds": sum(len(one["folds"]) for one in cases)}))


if __name__ == "__main__":
    main()
