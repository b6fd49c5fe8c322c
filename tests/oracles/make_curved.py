"""Seeds in; tests/data/curved.json out: certified folds, onsets and states of curved forces off the centre.

    python -m tests.oracles.make_curved

Two forces are typed here: k u + q (exp(u/d) - 1), which is not odd, also under a load; k u + q sinh(u/d), which is odd,
under a load. Each rises with u, so that to every amplitude A belongs one mean B. With z = A/d and Bessel's I_0 and I_1
the means over u = B + A cos(psi) are

    <exp(u/d)> = e^(B/d) I_0(z)     <exp(u/d) cos(psi)> = e^(B/d) I_1(z)

and those of sinh the same with sinh(B/d) I_0 and cosh(B/d) I_1. I_0 and I_1/z are power series of positive terms,
summed here; B as a function of A follows from the balance by Newton's iteration, on series, from a number that an
interval step has proved. `averaged` then isolates every zero along A and decides by Krawczyk's test at 280 bits, with
the bounds of `make_sided`: K is the least slope of the force, k or k + q/d.
"""

from __future__ import annotations

import math
import random
from typing import Any

from flint import arb, arb_series, ctx

from tests.oracles.averaged import BITS, DETACHED
from tests.oracles.certified_roots import precision
from tests.oracles.make_random_isolators import SEED, encoded, log_uniform, write
from tests.oracles.make_sided import Parametrized, reference_case

#: cases of each force
EACH = {"exponential": 17, "hyperbolic": 13}
#: terms of Bessel's series at most
TERMS = 400
#: coefficients of a Taylor series beyond those that are asked for
MORE = 3


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

    @property
    def last(self) -> arb:
        return arb(2) ** 10

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
        is_ball = isinstance(x, arb)
        start, step, length = (x, arb(1), 1) if is_ball else (x[0], x[1] if ctx.cap > 1 else arb(0), ctx.cap)
        before, ctx.cap = ctx.cap, length + 2
        A = arb_series([start, 1])
        h = -2 * A * self.stiffness(start)
        h_A = h.derivative()
        found = [A, h, h_A, h_A.derivative(), arb_series([1])]
        ctx.cap = before
        if is_ball:
            return tuple(one[0] for one in found)
        return tuple(arb_series([one[j] * step**j for j in range(length)]) for one in found)

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


def drawn(force: str, rng: random.Random, index: int) -> Curved:
    """An oscillator."""
    damping = {"mu": 0.0 if index % 3 == 0 else rng.uniform(0.001, 0.015), "zeta": log_uniform(rng, 0.015, 0.05)}
    numbers = {"k": rng.uniform(0.5, 1.2), "q": log_uniform(rng, 0.01, 0.1), "d": rng.uniform(0.08, 0.3)}
    if force == "exponential":
        load = 0.0 if index % 2 else rng.uniform(-0.2, 0.2)
        return Exponential(**numbers, load=load, **damping)
    return Hyperbolic(**numbers, load=rng.choice([-1, 1]) * log_uniform(rng, 0.01, 0.3), **damping)


def case(force: str, index: int) -> dict:
    """One oscillator: its onset, and its folds and states at one forcing."""
    rng = random.Random(f"{SEED} curved {force} {index}")
    oscillator = drawn(force, rng, index)
    base = math.sqrt(float(oscillator.least_slope.mid()))
    parameters = {name: encoded(float(value)) for name, value in oscillator.parameters.items()}
    return {"force": force, "parameters": parameters, **reference_case(rng, oscillator, base, (1.0, 1.4))}


if __name__ == "__main__":
    write("curved", [case(force, index) for force, count in EACH.items() for index in range(count)])
