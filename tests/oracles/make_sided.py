"""Seeds in; tests/data/sided.json out: certified folds, onsets and states, with their mean, of forces that are not odd.

    python -m tests.oracles.make_sided

Three forces are typed here: a u + k (u - g)_+, a stop on one side; the same with its bend at u = 0, two springs, under
a load; u + a u^2 + b u^3. Each rises with u, so that to every amplitude A belongs one mean B, and h is a function of A.
Of u = B + A cos(psi) it is known along a parameter, from A = 0 on to all amplitudes, in closed form:

* beyond the bend by the angle theta up to which u exceeds g, B = g - A cos(theta): with L = (sin - theta cos)/pi the
  balance a B + k A L = load says A = (a g - load)/(a cos(theta) - k L), and h = -A (a + k (theta - sin cos)/pi).
  A mass that rests in touch with the stop is the mirror image of one with the slope a + k that is free of another.
* of the polynomial by y = -B, A^2 = y (1 - a y + b y^2)/(a/2 - 3 b y/2) for a > 0, and x = sqrt(y), in which A is
  analytic; a < 0 is the mirror image.

`averaged` then isolates every zero along the parameter and decides by Krawczyk's test at 280 bits. No range is guessed:
with p = -h/A and q = -h_A folds have Omega^2 between p and q, and both are at least the least slope K of the force, as
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

from tests.oracles.averaged import ATTACHED, BITS, DETACHED, Jet, Point, digits, exact
from tests.oracles.certified_roots import isolate, precision
from tests.oracles.conditioning import Conditioning
from tests.oracles.make_random_isolators import SEED, answered, encoded, log_uniform, row, write
from tests.oracles.make_stated import Bent, Stated

#: cases of each force
EACH = {"stop": 12, "springs": 12, "even": 12}
#: above 4 mu/pi: up to there onsets are looked for
HIGHEST = 0.15


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

    @property
    def last(self) -> arb:
        """The parameter tends to it as A grows."""
        raise NotImplementedError

    def at(self, x: Any) -> tuple[Any, ...]:
        """A, h, h_A, h_AA w and w, of a ball or a series."""
        raise NotImplementedError

    def apart(self, x: arb_series) -> arb:
        """h/A - h_A."""
        raise NotImplementedError

    def mean(self, A: arb) -> arb:
        """B."""
        raise NotImplementedError

    def place(self, A: arb) -> arb:
        """The parameter of an amplitude, A a ball."""
        ctx.cap = 2
        low, high = 0.0, float(self.last.mid()) * (1 - 1e-12)
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self.at(arb_series([arb(middle), 1]))[0][0] < A.mid() else (low, middle)
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

    @property
    def last(self) -> arb:
        """Where a cos(theta) = k L."""
        low, high = 0.0, math.pi
        a, k = float(self._p("a").mid()), float(self._p("k").mid())
        for _ in range(200):
            theta = 0.5 * (low + high)
            rises = a * math.cos(theta) - k * (math.sin(theta) - theta * math.cos(theta)) / math.pi > 0
            low, high = (theta, high) if rises else (low, theta)
        return arb(low)

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

    def apart(self, x: arb_series) -> arb:
        a, k, pi = self._p("a"), self._p("k"), arb.pi()
        slope = a + k / pi * (x - x.sin() * x.cos())
        return (-slope - self.at(x)[2])[0]

    def mean(self, A: arb) -> arb:
        with precision(BITS):
            if A < self.edge:
                return self._p("load") / self._p("a")
            return self._p("g") - A * self.place(A).cos()


class Even(Parametrized):
    """u + a u^2 + b u^3 with 0 < a^2 < 3 b."""

    @property
    def least_slope(self) -> arb:
        a, b = self._p("a"), self._p("b")
        return 1 - a * a / (3 * b)

    @property
    def last(self) -> arb:
        return (self._p("a") / (3 * self._p("b"))).sqrt()

    def at(self, x: Any) -> tuple[Any, ...]:
        a, b = self._p("a"), self._p("b")
        is_ball = isinstance(x, arb)
        start, step, length = (x, arb(1), 1) if is_ball else (x[0], x[1] if ctx.cap > 1 else arb(0), ctx.cap)
        before, ctx.cap = ctx.cap, length + 3
        own = arb_series([start, 1])
        y = own * own
        A = own * ((1 - a * y + b * y * y) / (a / 2 - 3 * b / 2 * y)).sqrt()
        h = -A * (1 - 2 * a * y + 3 * b * y * y) - 3 * b / 4 * A * A * A
        h_A = h.derivative() / A.derivative()
        h_AA = h_A.derivative() / A.derivative()
        found = [A, h, h_A, h_AA, arb_series([1])]
        ctx.cap = before
        if is_ball:
            return tuple(one[0] for one in found)
        return tuple(arb_series([one[j] * step**j for j in range(length)]) for one in found)

    def apart(self, x: arb_series) -> arb:
        a, b, y = self._p("a"), self._p("b"), x[0] ** 2
        square = y * (1 - a * y + b * y * y) / (a / 2 - 3 * b / 2 * y)
        return -(1 - 2 * a * y + 3 * b * y * y) - 3 * b / 4 * square - self.at(x)[2][0]

    def mean(self, A: arb) -> arb:
        with precision(BITS):
            return -(self.place(A) ** 2)


def drawn(force: str, rng: random.Random, index: int) -> tuple[dict[str, float], Parametrized, int]:
    """Numbers as a user gives them, the oscillator that is solved, and the sign of B in it."""
    damping = {"mu": 0.0 if index % 3 == 0 else rng.uniform(0.001, 0.015), "zeta": log_uniform(rng, 0.015, 0.05)}
    if force == "even":
        b = rng.uniform(0.5, 3.0)
        a = rng.choice([-1, 1]) * rng.uniform(0.2, 0.95) * math.sqrt(3 * b)
        return {"a": a, "b": b, **damping}, Even(a=abs(a), b=b, **damping), -1 if a < 0 else 1
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


def reference_case(
    rng: random.Random, oscillator: Parametrized, base: float, above: tuple[float, float], sign: int = 1
) -> dict:
    """Its onset, and its folds and states at one forcing that is drawn.

    base, above -- a frequency, and between which multiples of it one is drawn where there is no pair of folds
    sign        -- of B where the oscillator is the mirror image of what a user gives
    """
    m = float(oscillator.m.mid())
    oscillator.ask(m + HIGHEST, [1.0])
    extrema = [p for p in oscillator.extrema if p.F_0 < oscillator.level]
    onset = next((p for p in extrema if p.sense == "min"), None)
    F_0 = m + log_uniform(rng, 0.02, HIGHEST)
    if onset is not None:
        F_0 = min(float(onset.F_0.mid()) * rng.choice([1.02, rng.uniform(1.1, 3), rng.uniform(1.1, 3)]), m + HIGHEST)
    folds = oscillator.folds(F_0)
    if len(folds) != oscillator.fold_count(F_0):
        raise AssertionError(f"{oscillator.parameters} {F_0}: {len(folds)} folds, not {oscillator.fold_count(F_0)}")
    at = [float(p.Omega.mid()) for p in folds]
    frequencies = [
        rng.uniform(at[0], at[-1]) if len(at) > 1 else base * rng.uniform(*above),
        base * rng.uniform(0.8, 2),
    ]
    oscillator.ask(F_0, frequencies)

    def mean(p: Any) -> dict:
        with precision(BITS):
            return {"A": digits(p.A), "B": digits(sign * oscillator.mean(p.A))}

    lowest = onset and row(onset, "F_0 Omega", Conditioning(oscillator).extremum(onset))
    return {
        "F_0": encoded(F_0),
        "onset": lowest and {**mean(onset), "F_SN": lowest.pop("F_0"), **lowest},
        **answered(oscillator, folds, F_0, frequencies, "Omega kind", "phi stable", mean),
    }


def case(force: str, index: int) -> dict:
    """One oscillator: its onset, and its folds and states at one forcing."""
    rng = random.Random(f"{SEED} sided {force} {index}")
    user, oscillator, sign = drawn(force, rng, index)
    base = float(oscillator.least_slope.sqrt().mid())
    parameters = {k: encoded(v) for k, v in user.items()}
    return {"force": force, "parameters": parameters, **reference_case(rng, oscillator, base, (0.9, 1.3), sign)}


if __name__ == "__main__":
    write("sided", [case(force, index) for force, count in EACH.items() for index in range(count)])
