"""Seeds in; tests/data/sided.json and curved.json out: certified folds, onsets, states and their mean off the centre.

    python -m tests.oracles.make_sided

The forces are typed here: a u + k (u - g)_+, a stop on one side; the same with its bend at u = 0, two springs, under a
load; u + a u^2 + b u^3; k u + q (exp(u/d) - 1), also under a load; k u + q sinh(u/d), which is odd, under a load. Each
rises with u, so that to every amplitude A belongs one mean B, and h is a function of A. Of u = B + A cos(psi) it is
known from A = 0 on to all amplitudes:

* beyond a bend in closed form by the angle theta up to which u exceeds g, B = g - A cos(theta): with
  L = (sin - theta cos)/pi the balance a B + k A L = load says A = (a g - load)/(a cos(theta) - k L), and
  h = -A (a + k (theta - sin cos)/pi). A mass that rests in touch with the stop is the mirror image of one with the
  slope a + k that is free of another.
* of a force that is analytic by its means over a cycle, as functions of A and B: B follows from their balance by
  Newton's iteration, on series, from a number that an interval step has proved. Those of a polynomial are polynomials
  (a < 0 is the mirror image); with z = A/d and Bessel's I_0 and I_1 <exp(u/d)> = e^(B/d) I_0(z) and
  <exp(u/d) cos(psi)> = e^(B/d) I_1(z), and those of sinh are the same with sinh(B/d) I_0 and cosh(B/d) I_1. I_0 and
  I_1/z are power series of positive terms, summed here.

`averaged` then isolates every zero and decides by Krawczyk's test at 280 bits. No range is guessed: with p = -h/A and
q = -h_A folds have Omega^2 between p and q, and both are at least the least slope K of the force, as
2 <f' (cos - c)^2> is for any c. So F_0 >= m + 2 zeta A sqrt(K) bounds A, and there is no fold where
|h - A h_A| < 4 zeta A sqrt(K). The number of folds is found twice, by isolating them and by the extrema of the forcing
along their locus.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from typing import Any

from flint import arb, arb_series, ctx

from tests.files import store
from tests.oracles.averaged import ATTACHED, BITS, DETACHED, Jet, Point, digits, exact, with_slopes
from tests.oracles.certified_roots import isolate, precision
from tests.oracles.make_random_isolators import SEED, encoded, log_uniform
from tests.oracles.make_stated import HIGHEST, Bent, Stated, reference_case

#: cases of each force
EACH = {"stop": 12, "springs": 12, "even": 12}
CURVED = {"exponential": 17, "hyperbolic": 13}
#: terms of Bessel's series at most
TERMS = 400
#: coefficients of a Taylor series beyond those that are asked for
MORE = 3


class Parametrized(Stated):
    """An oscillator whose amplitude rises along a parameter x; a jet's h_AA is k/w there, w = 0 on an edge."""

    def _p(self, name: str) -> arb:
        return arb(self.parameters[name])

    @property
    def edge(self) -> arb | None:
        """The amplitude at which the mass comes to the bend; below it the spring is linear."""
        return None

    @property
    def u_cr(self) -> arb | None:
        return self.edge

    @property
    def slope(self) -> arb:
        """Of the force where the mass rests."""
        raise NotImplementedError

    def at(self, x: Any) -> tuple[Any, ...]:
        """A, h, h_A, h_AA w and w, of a ball or a series."""
        raise NotImplementedError

    def apart(self, x: arb_series) -> arb:
        """h/A - h_A."""
        A, h, h_A, *_ = self.at(x)
        return (h / A - h_A)[0]

    def mean(self, A: arb) -> arb:
        """B."""
        raise NotImplementedError

    def place(self, A: arb) -> arb:
        """The parameter of an amplitude, A a ball: an angle, from some one on which there is none."""
        ctx.cap = 2
        low, high = 0.0, math.pi
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if A.mid() / self.at(arb_series([arb(middle), 1]))[0][0] > 1 else (low, middle)
        x = arb(0.5 * (low + high))
        for _ in range(9):
            value = self.at(arb_series([x, 1]))[0]
            x = arb((x - (value[0] - arb(A.mid())) / value[1]).mid())
        value = self.at(arb_series([x, 1]))[0]
        box = arb(x, (4 * (arb(A.rad()) / value[1] + arb(2) ** (-BITS + 40))).upper())
        new = x - (value[0] - A) / self.at(arb_series([box, 1]))[0][1]
        if not box.contains_interior(new):
            raise ArithmeticError("the place of an amplitude is not known")
        return new

    def h(self, A: arb, regime: str) -> tuple[arb, arb, arb, arb]:
        if regime != DETACHED:
            return -self.slope * A, -self.slope, arb(0), arb(0)
        before, ctx.cap = ctx.cap, 2
        x = self.place(A)
        value, h, h_A, bend, w = self.at(arb_series([x, 1]))
        h_AA = bend / w
        ctx.cap = before
        return h[0], h_A[0], h_AA[0], h_AA[1] / value[1]

    def ask(self, F_0: float, frequencies: list[float]) -> None:
        with precision(BITS):
            self.level = forcing = arb(exact(F_0))
            slowest = min([self.least_slope.sqrt(), *(arb(exact(one)) for one in frequencies)], key=lambda x: x.mid())
            self.high = (forcing - self.m) / (2 * arb(self.zeta) * slowest) * arb("1.001")
            self.end = None if self.edge is not None and self.high < self.edge else arb(self.place(self.high).mid())

    def _zeros(
        self, function: Callable[[Jet], Any], t_max: arb | None, exclude: Callable[[arb], bool] | None = None
    ) -> list[tuple[arb, str]]:
        """All zeros up to `high`; with a t_max, only where there can be folds."""
        found = []

        def unfolded(x: arb) -> bool:
            ctx.cap = 1
            return bool(abs(self.apart(arb_series([x]))) < 4 * arb(self.zeta) * self.least_slope.sqrt())

        def bent(x: arb_series) -> Any:
            A, h, h_A, bend, w = self.at(x)
            jet = Bent(A, h, h_A, bend, arb_series([1]))
            jet.w = w
            return function(jet)

        def linear(A: arb_series) -> Any:
            one = arb_series([1])
            return function(Bent(A, -self.slope * A, -self.slope * one, 0 * one, one))

        if self.edge is not None and t_max is None:
            end = self.high if self.high < self.edge else self.edge
            found += [(A, ATTACHED) for A in isolate(linear, arb(0), end)]
        if self.end is not None:
            ends = isolate(bent, arb(0), self.end, exclude=None if t_max is None else unfolded)
            found += [(self.at(x)[0], DETACHED) for x in ends]
        return found

    def _corner_extrema(self) -> list[Point]:
        return []  # the spring is linear below the edge, and next above it h/A and h_A are too much alike for a fold


class Stop(Parametrized):
    """a u + k (u - g)_+ under a load, of a mass that rests free of the stop: a g > load."""

    @property
    def least_slope(self) -> arb:
        a, k = self._p("a"), self._p("k")
        return a if k > 0 else a + k

    @property
    def slope(self) -> arb:
        return self._p("a")

    @property
    def edge(self) -> arb:
        return self._p("g") - self._p("load") / self._p("a")

    def at(self, x: Any) -> tuple[Any, ...]:
        a, k, pi = self._p("a"), self._p("k"), arb.pi()
        sine, cosine = x.sin(), x.cos()
        slope = a + k / pi * (x - sine * cosine)
        D, E = a * cosine - k / pi * (sine - x * cosine), a + k / pi * x
        G = a * self._p("g") - self._p("load")
        A = G / D
        h_A = -slope - 2 * k / pi * sine * D / E
        turn = -2 * k / pi * (sine * sine + (cosine * D - sine * sine * E) / E - k / pi * sine * D / (E * E))
        return A, -A * slope, h_A, turn * D * D / (G * E), sine

    def mean(self, A: arb) -> arb:
        with precision(BITS):
            if A < self.edge:
                return self._p("load") / self._p("a")
            return self._p("g") - A * self.place(A).cos()


def bessel(z: arb_series) -> tuple[arb_series, arb_series]:
    """I_0(z) and I_1(z)/z: their series have positive coefficients, and on balls derivatives are between ends."""
    first = z[0]
    if first.rad() < arb(2) ** (60 - ctx.prec):
        if not first > 1:
            return _powers(z)
        if ctx.cap == 1:
            return arb_series([first.bessel_i(0)]), arb_series([first.bessel_i(1) / first])
        at_first, own = _taylor(first), arb_series([0, *(z[j] for j in range(1, ctx.cap))])
        return at_first[0](own), at_first[1](own)
    ends = [arb(first.lower()), arb(first.upper()), *([arb(0)] if first.contains(0) else [])]
    taylor = [_taylor(end) for end in ends]
    found = []
    for pick in (0, 1):
        value = arb_series([0])
        for j in reversed(range(ctx.cap)):
            hull = taylor[0][pick][j]
            for other in taylor[1:]:
                hull = hull.union(other[pick][j])
            value = value * (z - first) + hull
        found.append(value)
    return found[0], found[1]


def _taylor(z: arb) -> tuple[arb_series, arb_series]:
    """Around a number: of y = I_0 by z y'' + y' - z y = 0, of I_1/z as y'/z."""
    if not z > 1:
        return _powers(arb_series([z, 1]))
    a = [z.bessel_i(0), z.bessel_i(1)]
    for n in range(ctx.cap - 1):
        a.append((z * a[n] + (a[n - 1] if n else 0) - (n + 1) ** 2 * a[n + 1]) / (z * (n + 2) * (n + 1)))
    slope = arb_series([(n + 1) * a[n + 1] for n in range(ctx.cap)])
    return arb_series(a[: ctx.cap]), slope / arb_series([z, 1])


def _powers(z: arb_series) -> tuple[arb_series, arb_series]:
    """Summed; from where terms fall by halves on what is left off is less than twice the first of it."""
    quarter = z * z / 4
    term, I_0, I_1, n = arb_series([1]), arb_series([0]), arb_series([0]), 0
    least = arb(2) ** (-ctx.prec - 20)
    while not (abs(quarter[0]) < (n - ctx.cap) ** 2 / 4 and all(abs(term[j]) < least for j in range(ctx.cap))):
        I_0 += term
        I_1 += term / (2 * (n + 1))
        n += 1
        term = term * quarter / n**2
        if n > TERMS:
            raise ArithmeticError("more terms")
    rest = arb_series([arb(0, 2 * least)] * ctx.cap)
    return I_0 + rest, I_1 + rest


def exponential(x: arb_series) -> arb_series:
    """e^x, whose first coefficient is positive on any ball."""
    first = x[0]
    ends = arb(first.lower()).exp().union(arb(first.upper()).exp())
    return ends * (x - first).exp()


class Curved(Parametrized):
    """A force that rises, along its amplitude."""

    #: a mean that was found last
    _near = 0

    def __init__(self, **parameters: Any) -> None:
        super().__init__(**parameters)
        self._known: dict[Any, arb] = {}

    def place(self, A: arb) -> arb:
        return A

    def means(self, A: arb_series, B: arb_series) -> tuple[arb_series, arb_series, arb_series]:
        """c_0, s_0/A and c_1."""
        raise NotImplementedError

    def _mean(self, A: arb) -> arb:
        """B at a ball of amplitudes: that falls, or rises, with |A|, as f'' has the sign of B all along."""
        if A.rad() < abs(A.mid()) * arb(2) ** (60 - ctx.prec):
            return self._thin(A)
        ends = [self._thin(abs(arb(one))) for one in (A.lower(), A.upper())]
        if A.contains(0):
            ends.append(self._thin(arb(0)))
        found = ends[0]
        for one in ends[1:]:
            found = found.union(one)
        return found

    def _thin(self, A: arb) -> arb:
        """The same of next to a number; those of a few are kept, as neighbouring balls share their ends."""
        key = (A.mid().man_exp(), A.rad().man_exp(), ctx.prec)
        if key not in self._known:
            self._known[key] = self._solved(A)
        return self._known[key]

    def _solved(self, A: arb) -> arb:
        """The same, proved by a step of Newton's on an interval."""
        before, ctx.cap = ctx.cap, 1
        load, middle, B = self._p("load"), arb(A.mid()), arb(self._near)

        def value(A: arb, B: arb) -> tuple[arb, arb]:
            c_0, _, c_1 = self.means(arb_series([A]), arb_series([B]))
            return (c_0[0] - load), c_1[0]

        bits = ctx.prec
        for ctx.prec in (64, bits):
            for _ in range(200):
                f, slope = value(middle, B)
                step = (f / slope).mid()
                B = arb((B - step).mid())
                if abs(step) < arb(2) ** (12 - ctx.prec):
                    break
        self._near = B
        radius = arb(2) ** (20 - ctx.prec)
        for _ in range(60):
            box = B + arb(0, 1) * radius
            new = B - value(A, B)[0] / value(A, box)[1]
            if box.contains_interior(new):
                ctx.cap = before
                return new
            radius = 2 * max((new - B).abs_upper(), radius, key=float)
        raise ArithmeticError("the mean is not known")

    def on_balance(self, A: arb_series) -> tuple[arb_series, arb_series]:
        """B and s_0/A of an amplitude that is a series."""
        length = ctx.cap
        B = arb_series([self._mean(A[0])])
        known = 1
        while known < length:
            before, known = known, min(2 * known, length)
            ctx.cap = known
            B = arb_series([B[j] for j in range(before)])
            c_0, _, c_1 = self.means(A, B)
            first = B[0]
            B = B - (c_0 - self._p("load")) / c_1
            # the number itself is proved already
            B = arb_series([first, *(B[j] for j in range(1, known))])
        ctx.cap = length
        return B, self.means(A, B)[1]

    def stiffness(self, A: arb) -> arb_series:
        """s_0/A around an amplitude, by Taylor's series at the middle of a ball and a last term on all of it."""
        length = ctx.cap
        if A.rad() < arb(2) ** (60 - ctx.prec):
            return self.on_balance(arb_series([A, 1]))[1]
        ctx.cap = length + MORE
        inside = self.on_balance(arb_series([arb(A.mid()), 1]))[1]
        last = self.on_balance(arb_series([A, 1]))[1][length + MORE - 1]
        terms = [*(inside[j] for j in range(length + MORE - 1)), last]
        ctx.cap = length
        off, value = arb_series([A - arb(A.mid()), 1]), arb_series([0])
        for term in reversed(terms):
            value = value * off + term
        return value

    def at(self, x: Any) -> tuple[Any, ...]:
        def slopes(A: arb_series) -> tuple[arb_series, ...]:
            h = -2 * A * self.stiffness(A[0])
            return A, h, h.derivative(), h.derivative().derivative(), arb_series([1])

        return with_slopes(x, slopes)

    def apart(self, x: arb_series) -> arb:
        before, ctx.cap = ctx.cap, 2
        # h/A - h_A = -A (h/A)'
        found = 2 * x[0] * self.stiffness(x[0])[1]
        ctx.cap = before
        return found

    def mean(self, A: arb) -> arb:
        with precision(BITS):
            return self._mean(A)

    def h(self, A: arb, regime: str) -> tuple[arb, arb, arb, arb]:
        assert regime == DETACHED
        before, ctx.cap = ctx.cap, 4
        h = -2 * arb_series([A, 1]) * self.on_balance(arb_series([A, 1]))[1]
        ctx.cap = before
        return h[0], h[1], 2 * h[2], 6 * h[3]


class Even(Curved):
    """u + a u^2 + b u^3 with 0 < a^2 < 3 b."""

    @property
    def least_slope(self) -> arb:
        a, b = self._p("a"), self._p("b")
        return 1 - a * a / (3 * b)

    def means(self, A: arb_series, B: arb_series) -> tuple[arb_series, arb_series, arb_series]:
        a, b = self._p("a"), self._p("b")
        square = A * A / 2
        slope = 1 + a * B * 2 + b * 3 * (B * B + square)
        return B + a * (B * B + square) + b * B * (B * B + 3 * square), (slope - b * 3 * square / 2) / 2, slope


class Exponential(Curved):
    """k u + q (exp(u/d) - 1)."""

    @property
    def least_slope(self) -> arb:
        return self._p("k")

    def means(self, A: arb_series, B: arb_series) -> tuple[arb_series, arb_series, arb_series]:
        k, q, d = (self._p(name) for name in ("k", "q", "d"))
        I_0, I_1 = bessel(A / d)
        E = q * exponential(B / d)
        return k * B + E * I_0 - q, k / 2 + E * I_1 / d, k + E * I_0 / d


class Hyperbolic(Curved):
    """k u + q sinh(u/d)."""

    @property
    def least_slope(self) -> arb:
        return self._p("k") + self._p("q") / self._p("d")

    def means(self, A: arb_series, B: arb_series) -> tuple[arb_series, arb_series, arb_series]:
        k, q, d = (self._p(name) for name in ("k", "q", "d"))
        I_0, I_1 = bessel(A / d)
        up, down = exponential(B / d), exponential(-B / d)
        sinh, cosh = q * (up - down) / 2, q * (up + down) / 2
        return k * B + sinh * I_0, k / 2 + cosh * I_1 / d, k + cosh * I_0 / d


def drawn(force: str, rng: random.Random, index: int) -> tuple[dict[str, float], Parametrized, int]:
    """Numbers as a user gives them, the oscillator that is solved, and the sign of B in it."""
    damping = {"mu": 0.0 if index % 3 == 0 else rng.uniform(0.001, 0.015), "zeta": log_uniform(rng, 0.015, 0.05)}
    if force == "even":
        b = rng.uniform(0.5, 3.0)
        a = rng.choice([-1, 1]) * rng.uniform(0.2, 0.95) * math.sqrt(3 * b)
        return {"a": a, "b": b, **damping}, Even(a=abs(a), b=b, load=0.0, **damping), -1 if a < 0 else 1
    if force in CURVED:
        numbers = {"k": rng.uniform(0.5, 1.2), "q": log_uniform(rng, 0.01, 0.1), "d": rng.uniform(0.08, 0.3)}
        if force == "exponential":
            numbers["load"] = 0.0 if index % 2 else rng.uniform(-0.2, 0.2)
        else:
            numbers["load"] = rng.choice([-1, 1]) * log_uniform(rng, 0.01, 0.3)
        user = {**numbers, **damping}
        return user, (Exponential if force == "exponential" else Hyperbolic)(**user), 1
    if force == "stop":
        numbers = {"a": 1.0, "k": log_uniform(rng, 0.5, 12.0), "g": rng.uniform(0.05, 0.4)}
        load = 0.0 if index % 2 else rng.uniform(-0.1, 0.03)
        if index % 4 == 3:  # in touch with the stop
            numbers["g"] = -rng.uniform(0.005, 0.05)
    else:
        numbers = {"a": rng.uniform(0.4, 1.5), "k": 0.0, "g": 0.0}
        numbers["k"] = rng.choice([-0.6, 1.0, 3.0, 6.0]) * numbers["a"] * rng.uniform(0.5, 1.0)
        load = rng.choice([-1, 1]) * rng.uniform(0.01, 0.15)
    user = {**numbers, "load": load, **damping}
    a, k, g, pull = (exact(user[name]) for name in ("a", "k", "g", "load"))
    sign = 1
    if not a * g > pull:
        a, k, g, pull, sign = a + k, -k, -g, -pull - k * g, -1
    return user, Stop(a=a, k=k, g=g, load=pull, **damping), sign


def with_mean(oscillator: Parametrized, sign: int) -> Callable[[Any], dict[str, str]]:
    """What is recorded first of a point: A and B, whose sign is another where a user has the mirror image."""

    def both(p: Any) -> dict[str, str]:
        with precision(BITS):
            return {"A": digits(p.A), "B": digits(sign * oscillator.mean(p.A))}

    return both


def case(file: str, force: str, index: int) -> dict:
    """One oscillator: its onset, and its folds and states at one forcing."""
    rng = random.Random(f"{SEED} {file} {force} {index}")
    user, oscillator, sign = drawn(force, rng, index)
    parameters, slope = {k: encoded(v) for k, v in user.items()}, oscillator.least_slope
    # both roots may be an ulp apart: what is stored was drawn with these
    if file == "curved":
        base, above = math.sqrt(float(slope.mid())), (1.0, 1.4)
    else:
        base, above = float(slope.sqrt().mid()), (0.9, 1.3)
    F_0, names = float(oscillator.m.mid()) + log_uniform(rng, 0.02, HIGHEST), ("Omega", "Omega kind", "phi stable")
    known = reference_case(rng, oscillator, F_0, base, above, names, with_mean(oscillator, sign))
    return {"force": force, "parameters": parameters, **known}


if __name__ == "__main__":
    for file, each in (("sided", EACH), ("curved", CURVED)):
        store(file, [case(file, force, index) for force, count in each.items() for index in range(count)])
