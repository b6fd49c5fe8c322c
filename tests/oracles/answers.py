"""One number that an oscillator gave in, the exact solution next to it and its condition out.

In:  an oscillator's parameters as doubles, and where the solution should be. Newton's method on the defining equations
     in several hundred bits goes to the solution nearby; it converges quadratically, so what it ends at has far more
     than thirty digits. Whether there are other solutions is not asked here: `averaged` proves that.

Condition numbers are those of `conditioning`: of the inputs, and of the values of the kernels.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from flint import arb, arb_mat, fmpq
from mpmath import mpf, workdps

from tests.oracles import averaged, kernels
from tests.oracles.averaged import ATTACHED, CORNER, DETACHED, SLOPES, Number, Point, exact, exact_ball
from tests.oracles.certified_roots import precision
from tests.oracles.conditioning import Condition, Conditioning
from tests.oracles.definitions.resultants import rational
from tests.oracles.errors import U
from tests.oracles.inertia import ByInertia

BITS = 420
#: relative size of Newton's last step, which the error left is the square of
SETTLED = arb(2) ** -120
STEPS = 40
#: what lies next to u_cr, relatively, and where what lies there is looked for from
NEXT, NEAR = arb(2) ** -48, arb(2) ** -100
#: what vanishes, by kind: names in `averaged.Oscillator.derivatives`; the first of a state, and at u_cr
EQUATIONS = {"cusp": ("A", "AA"), "isola": ("A", "O"), "detachment": ("O",)}
EQUATIONS |= {"fold": ("F", "A"), "peak": ("F", "O"), "state": ("F",)}
#: of which the forcing is a result
LEVELS = ("cusp", "isola", "detachment")


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

    def solution(self, kind: str, Omega: Number, A: float | None, F_0: Number) -> tuple[Point, Condition] | None:
        """The one of a kind next to these numbers, of which a state has its frequency; with A = u_cr if that is None.

        The double of an amplitude next to u_cr may lie on the other side.
        """
        u = self.oscillator.u_cr
        if A is None:
            return self._next(kind, Omega, u, F_0, CORNER)
        if u is None:  # at a sharp peak Newton's method leaves the place from one double, and not from the next
            starts = (A, math.nextafter(A, math.inf), math.nextafter(A, 0.0))
            tried = (self._next(kind, Omega, arb(start), F_0, ATTACHED) for start in starts)
            return next((found for found in tried if found is not None), None)
        found = self._next(kind, Omega, arb(A), F_0, ATTACHED if arb(A) <= u else DETACHED)
        if found is not None and not abs(arb(A) - u) < NEXT * u:
            return found
        # h_A may be infinite at u_cr: from either side of it too
        with precision(BITS):
            starts = [(u * (1 + offset)).mid() for offset in (-NEAR, NEAR)]
        around = map(self._next, [kind] * 2, [Omega] * 2, starts, [F_0] * 2, (ATTACHED, DETACHED))
        solutions = [one for one in (found, *around) if one is not None]
        return min(solutions, key=lambda one: abs(float(one[0].A - arb(A))), default=None)

    def _next(self, kind: str, Omega: Number, A: arb, F_0: Number, regime: str) -> tuple[Point, Condition] | None:
        """The same on one side of u_cr, or on it."""
        with precision(BITS):
            at, forcing = {"Omega": arb(exact(Omega)), "A": A}, arb(exact(F_0))
            unknowns = ["Omega"] if regime == CORNER else ["A"] if kind == "state" else ["Omega", "A"]
            vanish = EQUATIONS[kind][: len(unknowns)]

            def system(x: Sequence[arb]) -> tuple[list[arb], list[list[arb]]]:
                here = {**at, **dict(zip(unknowns, x, strict=True))}
                d = self.oscillator.derivatives(here["Omega"], here["A"], regime, forcing)
                by = [dict(zip(at, SLOPES[name], strict=True)) for name in vanish]
                return [d[name] for name in vanish], [[d[slopes[name]] for name in unknowns] for slopes in by]

            found = _newton(system, [at[name] for name in unknowns])
            if found is None:
                return None
            at |= zip(unknowns, found, strict=True)
            point = Point(at["Omega"], at["A"], regime, forcing, kind)
            if regime != CORNER and not self._stays(point.A, regime):
                return None
            if kind in LEVELS:
                point.F_0 = self.oscillator.forcing(point.Omega, point.A, regime)
                unknowns, vanish = [*unknowns, "F_0"], ("F", *vanish)
            return point, self.conditions.solved(point, unknowns, vanish, point.Omega, point.F_0)

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
    Omega = query["Omega"] if kind == "state" else one.Omega_cr if kind == "detachment" else one.Omega
    found = nearby.solution(kind or one.kind, Omega, None if kind == "detachment" else one.A, F_0)
    assert found is not None
    point, condition = found
    off = {key: float(abs(exact(getattr(one, name)) / getattr(point, key) - 1)) for key, name in names.items()}
    return {key: (off[key], off[key] / (U * (1 + condition.inputs[key] + condition.kernel[key]))) for key in off}
