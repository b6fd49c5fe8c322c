"""One number that an oscillator gave in, the exact solution next to it and its condition out.

In:  an oscillator's parameters as doubles, and where the solution should be. Newton's method on the defining equations
     in several hundred bits goes to the solution nearby; it converges quadratically, so what it ends at has far more
     than thirty digits. Whether there are other solutions is not asked here: `averaged` proves that.

Condition numbers are those of `conditioning`: of the inputs, and of the values of the kernels.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from flint import arb, arb_mat, fmpq
from mpmath import mpf, workdps

from tests.oracles import averaged, kernels
from tests.oracles.averaged import ATTACHED, CORNER, DETACHED, SLOPES, Amplitude, Point, exact, exact_ball
from tests.oracles.certified_roots import precision
from tests.oracles.conditioning import Condition, Conditioning
from tests.oracles.definitions.resultants import rational
from tests.oracles.errors import U
from tests.oracles.inertia import ByInertia

BITS = 420
T = TypeVar("T")
#: relative size of Newton's last step, which the error left is the square of
SETTLED = arb(2) ** -120
STEPS = 40
#: what lies next to u_cr, relatively, and where what lies there is looked for from
NEXT, NEAR = arb(2) ** -48, arb(2) ** -100
#: what vanishes, by what is asked: names in `averaged.Oscillator.derivatives`
EQUATIONS = {"fold": ("F", "A"), "cusp": ("A", "AA"), "isola": ("A", "O"), "peak": ("F", "O")}


#: the numbers of an answer to each question by their names in the oracle, and what the answer is there
VALUES = {
    "amplitudes": ("state", {"A": "A"}),
    "detachment": ("detachment", {"F_0": "F_cr"}),
    "peak": ("peak", {"Omega": "Omega", "A": "A"}),
    "saddle_nodes": ("fold", {"Omega": "Omega", "A": "A"}),
    "cusps": ("cusp", {"F_0": "F_0", "Omega": "Omega", "A": "A"}),
    "isola_points": ("isola", {"F_0": "F_0", "Omega": "Omega", "A": "A"}),
    "saddle_node_onset": ("", {"F_0": "F_SN", "Omega": "Omega", "A": "A"}),
}


class Anywhere(averaged.Oscillator):
    """Any damping, as nothing is bounded here; h from `kernels.averages`."""

    mechanism: str

    def h(self, A: arb, regime: str) -> tuple[arb, arb, arb, arb]:
        """h and three derivatives at the centre of a ball."""
        with workdps(int(BITS * 0.3)):
            p = [self.alpha, self.beta, self.gamma, self.u_cr]
            if self.mechanism == "duffing":
                p = p[:3]
            elif self.mechanism == "rod_spring_untruncated":
                p = [self.alpha, self.beta, self.parameters["delta_h"]]
            values = (_mpf(x if isinstance(x, fmpq) else exact_ball(x)) for x in (arb(A), *p))
            found = kernels.averages(self.mechanism, int(regime == DETACHED), *values)
            return tuple(arb(rational(x)) for x in found)


class Rod(Anywhere, averaged.RodSpring):
    """The isolator with the truncated force."""

    mechanism = "rod_spring"


class UntruncatedRod(Rod):
    """The isolator with the force as its geometry gives it."""

    mechanism = "rod_spring_untruncated"


class Cubic(Anywhere, averaged.Duffing):
    """One cubic piece."""

    mechanism = "duffing"


class CubicByInertia(ByInertia, Cubic):
    """The same, excited by inertia."""


MECHANISMS: dict[str, type[Anywhere]] = {kind.mechanism: kind for kind in (Rod, UntruncatedRod, Cubic)}
MECHANISMS["duffing by inertia"] = CubicByInertia


def _mpf(x: fmpq) -> Any:
    return mpf(int(x.p)) / int(x.q)


class Nearby:
    """Exact solutions next to given numbers, for one oscillator."""

    def __init__(self, mechanism: str, **parameters: float) -> None:
        with precision(BITS):
            self.oscillator = MECHANISMS[mechanism](**parameters)
            self.conditions = Conditioning(self.oscillator)

    def two(self, kind: str, Omega: float, A: float, F_0: float) -> tuple[Point, Condition] | None:
        """A fold, cusp, isola point or peak, by its two equations in Omega and A.

        The double of one next to u_cr may lie on the other side.
        """
        return self._nearest(A, lambda side, start: self._two(kind, Omega, start, F_0, side), lambda one: one[0].A)

    def _two(self, kind: str, Omega: float, start: arb, F_0: float, regime: str) -> tuple[Point, Condition] | None:
        with precision(BITS):
            forcing, names = arb(exact(F_0)), EQUATIONS[kind]

            def system(x: Sequence[arb]) -> tuple[list[arb], list[list[arb]]]:
                d = self.oscillator.derivatives(x[0], x[1], regime, forcing)
                return [d[n] for n in names], [[d[k] for k in SLOPES[n]] for n in names]

            found = _newton(system, [arb(Omega), start])
            if found is None or not self._stays(found[1], regime):
                return None
            point = Point(*found, regime, forcing, kind)
            if kind in ("cusp", "isola"):
                point.F_0 = self.oscillator.forcing(point.Omega, point.A, regime)
                condition = self.conditions.extremum(point)
            else:
                condition = self.conditions.solved(point, ("Omega", "A"), names, point.Omega, forcing)
            return None if condition is None else (point, condition)

    def on_corner(self, kind: str, Omega: float, F_0: float) -> tuple[Point, Condition] | None:
        """At A = u_cr: a fold at F_0, or the least forcing by Omega ("detachment")."""
        with precision(BITS):
            u, forcing = self.oscillator.u_cr, arb(exact(F_0))
            name, slope = ("F", "O") if kind == "fold" else ("O", "OO")

            def system(x: Sequence[arb]) -> tuple[list[arb], list[list[arb]]]:
                d = self.oscillator.derivatives(x[0], u, CORNER, forcing)
                return [d[name]], [[d[slope]]]

            found = _newton(system, [arb(Omega)])
            if found is None:
                return None
            point = Point(found[0], u, CORNER, forcing, kind)
            if kind == "fold":
                return point, self.conditions.fold(point)
            point.F_0 = self.oscillator.forcing(point.Omega, u, CORNER)
            condition = self.conditions.detachment(point)
            return None if condition is None else (point, condition)

    def state(self, Omega: float, A: float, F_0: float) -> tuple[Amplitude, Condition] | None:
        """The steady state at a frequency; next to u_cr its double may lie on the other side."""
        with precision(BITS):
            frequency, forcing = arb(exact(Omega)), arb(exact(F_0))

            def on(regime: str, start: arb) -> Amplitude | None:
                def system(x: Sequence[arb]) -> tuple[list[arb], list[list[arb]]]:
                    d = self.oscillator.derivatives(frequency, x[0], regime, forcing)
                    return [d["F"]], [[d["A"]]]

                found = _newton(system, [start])
                stays = found is not None and self._stays(found[0], regime)
                return Amplitude(found[0], arb(0), True, regime) if found is not None and stays else None

            state = self._nearest(A, on, lambda one: one.A)
            return None if state is None else (state, self.conditions.amplitude(state, Omega, F_0))

    def _nearest(self, A: float, on: Callable[[str, arb], T | None], amplitude: Callable[[T], arb]) -> T | None:
        """The solution next to a double, on its side; next to u_cr, or where there is none, of those on both."""
        u = self.oscillator.u_cr
        if u is None:  # at a sharp peak Newton's method leaves the place from one double, and not from the next
            starts = (A, math.nextafter(A, math.inf), math.nextafter(A, 0.0))
            return next((found for start in starts if (found := on(ATTACHED, arb(start))) is not None), None)
        own = ATTACHED if arb(A) <= u else DETACHED
        found = on(own, arb(A))
        if found is not None and not abs(arb(A) - u) < NEXT * u:
            return found
        # h_A may be infinite at u_cr: from either side of it too
        with precision(BITS):
            around = [on(side, (u * (1 + offset)).mid()) for side, offset in ((ATTACHED, -NEAR), (DETACHED, NEAR))]
        solutions = [one for one in (found, *around) if one is not None]
        return min(solutions, key=lambda one: abs(float(amplitude(one) - arb(A))), default=None)

    def _stays(self, A: arb, regime: str) -> bool:
        u = self.oscillator.u_cr
        return bool(A > 0) and (u is None or bool((A < u) if regime == ATTACHED else (A > u)))


def _newton(system: Any, x: list[arb]) -> list[arb] | None:
    """Where Newton's method settles; None if it does not, or goes far away."""
    start = x
    for _ in range(STEPS):
        try:
            values, rows = system(x)
            step = arb_mat(rows).mid().solve(arb_mat(len(x), 1, values).mid())
        except (ValueError, ZeroDivisionError):  # across the corner, where the formula ends; a double point
            return None
        x = [arb((a - step[k, 0]).mid()) for k, a in enumerate(x)]
        if not all(a > 0 for a in x) or not all(v.is_finite() for v in x):
            return None
        if all(abs(step[k, 0]) < SETTLED * a for k, a in enumerate(x)):
            near = all(abs(a - b) < abs(b) * arb("0.01") for a, b in zip(x, start, strict=True))
            return x if near else None
    return None


def errors(one: Any, nearby: Nearby, question: str, query: dict[str, float]) -> dict[str, tuple[float, float]]:
    """Relative errors of an answer's numbers, and these in u (1 + kappa)."""
    kind, names = VALUES[question]
    F_0 = query["F_0"] if "F_0" in query else getattr(one, names["F_0"])
    if kind == "state":
        found = nearby.state(query["Omega"], one.A, F_0)
    elif kind == "detachment":
        found = nearby.on_corner(kind, one.Omega_cr, F_0)
    else:
        found = nearby.two(kind or one.kind, one.Omega, one.A, F_0)
    assert found is not None
    point, condition = found
    off = {key: float(abs(exact(getattr(one, name)) / getattr(point, key) - 1)) for key, name in names.items()}
    return {key: (off[key], off[key] / (U * (1 + condition.inputs[key] + condition.kernel[key]))) for key in off}
