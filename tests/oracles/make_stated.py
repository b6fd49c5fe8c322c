"""Seeds in; tests/data/stated.json out: certified folds, onsets and states under forces that are averaged by sums.

    python -m tests.oracles.make_stated

The forces are those of `pieces`, f(u) for u > 0, on one piece or on two. With u = A cos(y) and A = b sqrt(1 + t^2)
beyond the first piece's end b, which y = atan(t) reaches, each piece of

    h = -(4/pi) int_0^(pi/2) f(A cos y) cos(y) dy

is an integral from 0 to 1 that is analytic in A, or in t down to t = 0. Around a centre all its Taylor coefficients
come from one Gauss sum; a bound M of the integrand on complex boxes that hold a disc of amplitudes and an ellipse
around [0, 1] bounds the error of the sum and, by Cauchy, the coefficients that were left off. `averaged` then isolates
every zero on these series, and Krawczyk's test decides at 280 bits, with h and its derivatives by FLINT's own
quadrature. Powers of u are averaged by gamma functions. Beyond the gap of a contact k (u - b)^(3/2), with sin(y/2) =
sqrt(d/(2 A)) sin(w) and d = A - b, u - b is d cos(w)^2 and both roots of d are gone: it is d^2 times an integral over w
that is analytic in A, also at A = b.

No range is guessed. With p = -h/A and q = -h_A folds have Omega^2 between p and q, since R R_A < 0 there; both are at
least the least slope k of the force, which is typed. So F_0 >= m + 2 zeta A sqrt(k) bounds A; and as A -> 0 there is no
fold where (h - A h_A)^2 + I^2 < F_0^2, and none at any forcing where |h - A h_A| < 4 zeta A sqrt(k).
A stop turns h_A on its edge: there the fold locus may turn too, which `_corner_extrema` decides by signs.
The number of folds is found twice, by isolating them and by the extrema of the forcing along their locus, where that
does not begin at rest.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import product
from typing import Any

from flint import acb, acb_series, arb, arb_series, ctx

from tests.files import store
from tests.oracles.averaged import (
    ATTACHED,
    BITS,
    CORNER,
    DETACHED,
    Jet,
    Oscillator,
    Point,
    _sign,
    exact,
    with_slopes,
)
from tests.oracles.certified_roots import isolate, precision
from tests.oracles.conditioning import Conditioning
from tests.oracles.make_random_isolators import SEED, answered, encoded, log_uniform, row
from tests.oracles.pieces import STATED, Pieces, arctangent, c, k, on_series, p, root, u

#: of each force
EACH = 3
MORE = {
    **{"contact": 30, "preload": 10, "preload_power": 10, "preloaded_stop": 10},
    **{"magnets": 12, "soft_stop": 10, "hard_stop": 7, "root_stop": 13},
}
#: above 4 mu/pi: up to there onsets are looked for
HIGHEST = 0.15
#: bits and length of the series that zeros are isolated on; ellipses, and what their sum's error is below, in bits
SERIES_BITS, LENGTH, ELLIPSES, SURE = 160, 72, (2.0, 1.5, 1.2, 1.1), 96
#: how the square around a disc and the rectangle around an ellipse are cut
DISC, ELLIPSE = 3, (32, 4)
#: of an integrand on a disc: beyond it another is tried
LARGEST = 2**14


@dataclass(frozen=True)
class Force:
    """Its pieces; draws; its least slope, at any u; whether folds begin at rest.

    power   -- factor and exponent of a power beside a single piece
    contact -- factor of what begins where the first piece ends, as a power 3/2
    """

    stated: Pieces
    draw: Callable[[random.Random], dict[str, float]]
    least_slope: Any = 1
    power: tuple[str, str] | None = None
    contact: str | None = None
    at_rest: bool = False

    @cached_property
    def pieces(self) -> list[Callable[..., Any]]:
        """On series, but for the power and what a contact adds."""
        forces = [force for force, _ in self.stated][: 1 if self.contact else None]
        return [on_series(force - k * u**p if self.power else force) for force in forces]

    @property
    def end(self) -> str | None:
        """Where the first piece ends."""
        return None if len(self.stated) == 1 else str(self.stated[0][1])


def _uniform(**ranges: tuple[float, float]) -> Callable[[random.Random], dict[str, float]]:
    return lambda rng: {name: rng.uniform(*ends) for name, ends in ranges.items()}


_POWER = {"power": ("k", "p")}
#: what is drawn of each, and more about it
DRAWN: dict[str, tuple[dict[str, tuple[float, float]], dict[str, Any]]] = {
    "wave": ({"k": (0.1, 0.25), "c": (2.0, 3.8)}, {"least_slope": 1 - k * c}),
    "saturating": ({"c": (0.6, 1.2), "k": (0.8, 2.0)}, {"least_slope": c}),
    "exponential": ({"k": (0.3, 1.0), "c": (0.8, 2.0)}, {"least_slope": k * c}),
    "oblique": ({"k": (0.4, 2.0), "c": (0.3, 1.0)}, {}),
    "magnets": ({"k": (5.0, 30.0), "c": (4.0, 5.0)}, {"least_slope": 1 + 4 * k / c**3}),
    "power": ({"k": (0.3, 1.5), "p": (1.3, 2.8)}, _POWER),
    "root": ({"k": (0.02, 0.2), "p": (0.4, 0.8)}, {**_POWER, "at_rest": True}),
    "preload": ({"c": (0.005, 0.04), "k": (0.5, 1.5)}, {"least_slope": k, "at_rest": True}),
    "preload_power": (
        {"c": (0.005, 0.04), "k": (0.3, 1.5), "p": (1.3, 2.8)},
        {**_POWER, "at_rest": True},
    ),
    "soft_stop": ({"c": (0.3, 3.0), "k": (0.5, 2.0), "gap": (0.1, 0.5)}, {}),
    "hard_stop": ({"k": (0.3, 2.0), "c": (0.5, 2.0), "gap": (0.1, 0.5)}, {}),
    "root_stop": ({"k": (0.5, 3.0), "c": (0.5, 2.0), "gap": (0.1, 0.5)}, {}),
    "contact": ({"k": (1.0, 8.0), "gap": (0.1, 0.5)}, {"contact": "k"}),
    "preloaded_stop": (
        {"c": (0.005, 0.03), "k": (0.1, 0.6), "gap": (0.15, 0.5)},
        {"least_slope": 1 - k, "at_rest": True},
    ),
}
FORCES = {name: Force(STATED[name], _uniform(**ranges), **more) for name, (ranges, more) in DRAWN.items()}


class Bent(Jet):
    """A jet beyond a stop's edge: h_A = g there, h_AA = k/w with w = t; at an edge, w = 0, w F_AA/2 is R k."""

    w: Any = 1

    @property
    def scales(self) -> tuple[Any, Any, Any]:
        return self.w, self.w, self.w


@dataclass
class Piece:
    """Taylor coefficients of h around a centre, good for arguments from low to high; a bound on a disc of radius R.

    The argument is t beyond a stop's edge, A before it and beyond a contact's.
    """

    low: arb
    high: arb
    centre: arb
    radius: arb
    bound: arb
    coefficients: list[arb]
    in_t: bool
    beyond: bool


@cache
def gauss(count: int) -> list[tuple[arb, arb]]:
    """Nodes and weights on [0, 1]."""
    with precision(SERIES_BITS):
        pairs = [arb.legendre_p_root(count, k, weight=True) for k in range(count)]
        return [((1 + x) / 2, weight / 2) for x, weight in pairs]


def square(centre: acb, half: arb | tuple[arb, arb], cut: int | tuple[int, int]) -> Iterator[acb]:
    """Boxes that cover a rectangle of the complex plane."""
    (a, b), (n, k) = (
        (half if isinstance(half, tuple) else (half, half)),
        (cut if isinstance(cut, tuple) else (cut, cut)),
    )
    for i, j in product(range(n), range(k)):
        x, y = centre.real + a * (arb(2 * i + 1) / n - 1), centre.imag + b * (arb(2 * j + 1) / k - 1)
        yield acb(x + arb(0, (a / n).upper()), y + arb(0, (b / k).upper()))


class Stated(Oscillator):
    """An oscillator with one of the forces; `level` is the forcing up to which extrema are wanted."""

    force_: Force
    level: arb

    @property
    def u_cr(self) -> arb | None:
        return None if self.force_.end is None else arb(self.parameters[self.force_.end])

    def _number(self, name: str) -> acb:
        return acb(arb(self.parameters[name]))

    @property
    def least_slope(self) -> arb:
        """Of the force, at any u."""
        return arb(on_series(self.force_.least_slope)(0, lambda name: arb(self.parameters[name])))

    # ---- the average ----------------------------------------------------------------------------------------------

    def _integrand(self, A: Any, turn: Any, v: Any) -> Any:
        """What is integrated over 0 < v < 1: A and the angle of the edge (None before it) as boxes or series."""
        first = self.force_.pieces[0]
        half = acb(arb.pi() / 2)
        if turn is not None and self.force_.contact is not None:
            sine, cosine, b = (half * v).sin(), (half * v).cos(), acb(self.u_cr)
            inner = (A - b) / (2 * A) * sine * sine
            whole = first(A * cosine, self._number) * cosine
            touching = (A - b) ** 2 * cosine**4 * (1 - 2 * inner) * 2 / (root(2 * A) * root(1 - inner))
            return half * (whole + self._number(self.force_.contact) * touching)
        if turn is None:
            ranges = [(first, half * v + 0 * A, half)]
        else:
            ranges = [(self.force_.pieces[1], turn * v, turn), (first, turn + (half - turn) * v, half - turn)]
        total = None
        for f, y, width in ranges:
            cosine = y.cos()
            term = f(A * cosine, self._number) * cosine * width
            total = term if total is None else total + term
        return total

    def _power(self, A: Any) -> Any:
        """The average of k u^p."""
        if self.force_.power is None:
            return 0 * A
        k, p = (arb(self.parameters[name]) for name in self.force_.power)
        factor = -2 / arb.pi().sqrt() * k * (p / 2 + 1).gamma() / (p / 2 + arb(3) / 2).gamma()
        return factor * (p * A.log()).exp()

    def h(self, A: arb, regime: str) -> tuple[arb, arb, arb, arb]:
        """By FLINT's quadrature; the edge itself counts as before it."""
        before, ctx.cap = ctx.cap, 4
        at = acb_series([acb(A), 1])
        turn = None
        if regime == DETACHED and self.force_.contact is not None:
            turn = at
        elif regime == DETACHED:
            b = acb(self.u_cr)
            turn = (root(at * at - b * b) / b).atan()
        found = []
        for order in range(4):

            def coefficient(v: acb, _: bool, order: int = order) -> acb:
                try:
                    return self._integrand(at, turn, acb_series([v]))[order]
                except (ValueError, ZeroDivisionError):
                    return acb("nan")

            total = acb.integral(coefficient, 0, 1, rel_tol=arb(2) ** (20 - BITS), abs_tol=arb(2) ** (20 - BITS))
            power = self._power(arb_series([A, 1]))[order]
            found.append((-4 / arb.pi() * total.real + power) * math.factorial(order))
        ctx.cap = before
        return tuple(found)

    def _bound(self, centre: arb, radius: arb, rho: arb, in_t: bool, beyond: bool) -> arb | None:
        """Of the integrand, for arguments of the disc and v in the ellipse; None where it has a singularity."""
        half = ((rho + 1 / rho) / 4, (rho - 1 / rho) / 4)
        most = arb(0)
        ctx.cap = 1
        ellipse = [acb_series([v]) for v in square(acb(arb(1) / 2), half, ELLIPSE)]
        for x in square(acb(centre), radius, DISC):
            try:
                A, turn = self._argument(acb_series([x]), in_t, beyond)
                for v in ellipse:
                    size = abs(self._integrand(A, turn, v)[0])
                    if not size.is_finite():
                        return None
                    most = most.max(arb(size.upper()))
            except (ValueError, ZeroDivisionError):
                return None
        return most

    def _argument(self, x: acb_series, in_t: bool, beyond: bool) -> tuple[acb_series, acb_series | None]:
        """A and the angle of the edge; beyond that of a contact, which does not ask for it, A."""
        if beyond and not in_t:
            return x, x
        return (acb(self.u_cr) * root(1 + x * x), arctangent(x)) if in_t else (x, None)

    def _piece(self, low: arb, most: arb, in_t: bool, beyond: bool) -> Piece:
        """From low on, as far as the integrand is analytic around and not beyond `most`."""
        with precision(SERIES_BITS):
            low, most, cap = arb(low.mid()), arb(most.mid()), ctx.cap
            # centre and radius: the piece is a quarter of the disc on each side
            fraction = arb(1)
            while True:
                r = (arb("0.18") if in_t else low / 8) * fraction
                if in_t:
                    r *= (1 + low * low).sqrt()
                first = in_t and low == 0
                r = arb(r.mid())
                centre, high = (arb(0), r) if first else (arb((low + r).mid()), arb((low + 2 * r).mid()))
                radius = arb((r * arb("4.2")).upper())
                for rho in map(arb, ELLIPSES):
                    bound = self._bound(centre, radius, rho, in_t, beyond)
                    if bound is not None and bound < LARGEST:
                        break
                else:
                    bound = None
                if bound is not None:
                    break
                fraction /= 2
                if fraction < arb(2) ** -12:
                    raise ArithmeticError(f"no disc around {low}")
            ctx.cap = LENGTH
            A, turn = self._argument(acb_series([acb(centre), 1]), in_t, beyond)
            total = acb_series([0])
            count = math.ceil(SURE * math.log(2) / (2 * math.log(float(rho))))
            for node, weight in gauss(count):
                total += self._integrand(A, turn, acb_series([acb(node)])) * acb(weight)
            off = arb(64) / 15 * bound * rho ** (2 - 2 * count) / (1 - rho**-2)
            scale = 4 / arb.pi()
            coefficients = [-scale * (total[k].real + arb(0, (off / radius**k).upper())) for k in range(LENGTH)]
            ctx.cap = cap
            end = high if high < most else most
            return Piece(low, end, centre, radius, scale * bound, coefficients, in_t, beyond)

    @cached_property
    def _pieces(self) -> list[Piece]:
        """That cover all amplitudes from `low` to `high`."""
        found: list[Piece] = []

        def cover(start: arb, end: arb, in_t: bool, beyond: bool) -> None:
            while start < end:
                found.append(self._piece(start, end, in_t, beyond))
                start = found[-1].high

        low, high, edge = arb(self.low.mid()), arb(self.high.mid()), self.u_cr
        if edge is None or high < edge:
            cover(low, high, False, False)
        else:
            cover(low, edge, False, False)
            if self.force_.contact is not None:
                cover(edge, high, False, True)
            else:
                cover(arb(0), arb(self.t(high).mid()), True, True)
        return found

    def _jet(self, piece: Piece, x: arb_series) -> Jet:
        """A, h and its derivatives as series, from those of the piece and a bound of what was left off."""
        at_0 = piece.in_t and piece.centre == 0
        left = 2 * piece.bound * arb(2) ** -LENGTH

        def value(own: arb_series, coefficients: list[arb], left: arb) -> arb_series:
            total = arb_series([0])
            for one in reversed(coefficients):
                total = total * (own - piece.centre) + one
            return total + arb_series([arb(0, (left * (4 / piece.radius) ** j).upper()) for j in range(ctx.cap)])

        def slopes(own: arb_series) -> tuple[arb_series, ...]:
            h = value(own, piece.coefficients, left)
            if not piece.in_t:
                h = h + self._power(own)
                return own, h, h.derivative(), h.derivative().derivative(), arb_series([1])
            long = (1 + own * own).sqrt()
            if at_0:  # h_t/t, whose first coefficient is that of t^2: h_A is finite at t = 0
                turned = [(j + 2) * piece.coefficients[j + 2] for j in range(LENGTH - 2)]
                quotient = value(own, turned, 4 * (LENGTH + 1) * left / piece.radius**2)
            else:
                quotient = h.derivative() / own
            g = quotient * long / self.u_cr
            return self.u_cr * long, h, g, g.derivative() * long / self.u_cr, own

        *known, w = with_slopes(x, slopes)
        jet = Bent(*known, arb_series([1]))
        jet.w = w
        return jet

    # ---- where zeros can be ---------------------------------------------------------------------------------------

    def ask(self, F_0: float, frequencies: list[float]) -> None:
        """Sets the range of amplitudes that holds every fold, cusp below F_0 and state of the questions to come."""
        with precision(BITS):
            self.level = forcing = arb(exact(F_0))
            zeta, k = arb(self.zeta), self.least_slope
            slowest = min([k.sqrt(), *(arb(exact(Omega)) for Omega in frequencies)], key=lambda x: x.mid())
            fastest = max(frequencies)
            self.high = (forcing - self.m) / (2 * zeta * slowest) * arb("1.001")
            low = min([arb(1) / 8, *([self.u_cr / 2] if self.u_cr is not None else []), self.high / 4], key=float)
            while not self._nothing_below(low, arb(exact(fastest)), forcing):
                low /= 2
                if low < arb(2) ** -60:
                    raise ArithmeticError("no least amplitude")
            self.low = low
            self.__dict__.pop("_pieces", None)

    def _nothing_below(self, A: arb, Omega: arb, forcing: arb) -> bool:
        """No state up to A at frequencies up to Omega, no fold, and no cusp unless folds begin at rest."""
        ctx.cap = 3
        bent = self.force_.pieces[0](acb_series([acb(arb(A / 2, (A / 2).upper())), 1]), self._number)
        bend, preload = 2 * abs(bent[2]), abs(self.force_.pieces[0](acb_series([acb(0)]), self._number)[0])
        h, zeta = abs(self.h(A, ATTACHED)[0]), arb(self.zeta)  # |h| rises with A
        turning = 4 / (3 * arb.pi()) * bend * A * A  # |h - A h_A| less what it is at rest
        if self.force_.power is not None:
            turning += abs((self.parameters[self.force_.power[1]] - 1) * self._power(A))
        lag = turning + 4 / arb.pi() * preload
        quiet = h.max(A * Omega**2) ** 2 + (2 * zeta * A * Omega + self.m) ** 2 < forcing**2
        fast = (A * h + A * lag).sqrt()  # A Omega at most, of a fold
        unfolded = lag**2 + (2 * zeta * fast + self.m) ** 2 < forcing**2
        smooth = self.force_.at_rest or turning < 4 * zeta * A * self.least_slope.sqrt()
        return bool(quiet and unfolded and smooth)

    @property
    def _fold_range(self) -> arb:
        return self.high

    def _state_range(self, Omega: arb, F_0: arb) -> None:
        return None

    def _zeros(
        self, function: Callable[[Jet], Any], t_max: arb | None, exclude: Callable[[arb], bool] | None = None
    ) -> list[tuple[arb, str]]:
        """All zeros between `low` and `high`; with a t_max, only where there can be folds."""
        found = []
        for piece in self._pieces:

            def unfolded(x: arb, piece: Piece = piece) -> bool:
                ctx.cap = 1
                return self._unfolded(self._jet(piece, arb_series([x])), piece)

            without = None if t_max is None else unfolded
            for x in isolate(
                lambda x, piece=piece: function(self._jet(piece, x)), piece.low, piece.high, exclude=without
            ):
                A = self.u_cr * (1 + x * x).sqrt() if piece.in_t else x
                found.append((A, DETACHED if piece.beyond else ATTACHED))
        return found

    def _unfolded(self, j: Jet, piece: Piece) -> bool:
        """Whether no fold is there at any forcing."""
        A = j.A[0]
        return bool(abs(j.h[0] - A * j.g[0]) < 4 * arb(self.zeta) * A * self.least_slope.sqrt())

    def _corner_folds(self, forcing: arb) -> list[Point]:
        return []  # the force does not jump

    # ---- extrema of the forcing on the fold locus, up to the forcing asked -----------------------------------------

    def _isolas(self) -> list[Point]:
        return []  # Omega^2 = h_A there, and h_A < 0

    def _corner_extrema(self) -> list[Point]:
        """On a stop's edge, beyond which h_AA comes from -infinity: the locus turns where F_AA changes its sign."""
        if self.force_.end is None or self.high < self.u_cr:
            return []
        u, points = self.u_cr, []
        for Omega in self._roots(self._slope_polynomial(self._at(u, CORNER)[1])):
            d = self.derivatives(Omega, u, CORNER, arb(0))
            if _sign(d["AA"]) == _sign(d["R"]):
                sense = "min" if _sign(d["O"] * d["AA"] * d["AO"]) > 0 else "max"
                points.append(Point(Omega, u, CORNER, kind="corner", sense=sense))
        return points

    @property
    def ends(self) -> list[tuple[arb, int, arb]]:
        """None: Omega^2 is at least the least slope."""
        return []


def reference_case(
    rng: random.Random,
    oscillator: Stated,
    F_0: float,
    base: float,
    above: tuple[float, float],
    names: tuple[str, str, str] = ("Omega A kind", "Omega A kind", "A phi stable"),
    before: Callable[[Any], dict[str, Any]] = lambda one: {},
    at_rest: bool = False,
) -> dict[str, Any]:
    """Its onset, and its folds and states at one forcing, which is drawn next to the onset where there is one.

    base, above   -- a frequency, and between which multiples of it one is drawn where there is no pair of folds
    names, before -- what is recorded of the onset, folds and states, and before that of each
    at_rest       -- whether folds begin at rest, so that there is no onset
    """
    most, onset = float(oscillator.m.mid()) + HIGHEST, None
    oscillator.ask(F_0 if at_rest else most, [1.0])
    if not at_rest:
        onset = next((p for p in oscillator.extrema if p.sense == "min" and p.F_0 < oscillator.level), None)
    if onset is not None:
        F_0 = min(float(onset.F_0.mid()) * rng.choice([1.02, rng.uniform(1.1, 3), rng.uniform(1.1, 3)]), most)
    folds = oscillator.folds(F_0)
    if not at_rest and len(folds) != oscillator.fold_count(F_0):
        raise AssertionError(f"{oscillator.parameters} {F_0}: {len(folds)} folds, not {oscillator.fold_count(F_0)}")
    at = [float(p.Omega.mid()) for p in folds]
    among = rng.uniform(at[0], at[-1]) if len(at) > 1 else base * rng.uniform(*above)
    frequencies = [among, base * rng.uniform(0.8, 2)]
    oscillator.ask(F_0, frequencies)
    lowest = onset and row(onset, f"F_0 {names[0]}", Conditioning(oscillator).extremum(onset))
    return {
        "F_0": encoded(F_0),
        "onset": lowest and {**before(onset), "F_SN": lowest.pop("F_0"), **lowest},
        **answered(oscillator, folds, F_0, frequencies, *names[1:], before),
    }


def case(name: str, force: Force, index: int, kind: type[Stated] = Stated) -> dict:
    """One oscillator: its onset, and its folds and states at one forcing."""
    rng = random.Random(f"{SEED} stated {name} {index}")
    parameters = force.draw(rng)
    parameters |= {
        "mu": 0.0 if index % EACH == EACH - 1 else rng.uniform(0.001, 0.02),
        "zeta": log_uniform(rng, 0.02, 0.06),
    }
    oscillator = type(name, (kind,), {"force_": force})(**parameters)
    F_0 = float(oscillator.m.mid()) + log_uniform(rng, 0.03, 0.2)
    if "preload" in name:
        F_0 += 4 / math.pi * parameters["c"]
    base = float(oscillator.least_slope.sqrt().mid())
    return {
        "force": name,
        "parameters": {k: encoded(v) for k, v in parameters.items()},
        **reference_case(rng, oscillator, F_0, base, (0.9, 1.3), at_rest=force.at_rest),
    }


if __name__ == "__main__":
    store("stated", [case(n, force, index) for n, force in FORCES.items() for index in range(MORE.get(n, EACH))])
