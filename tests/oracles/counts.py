"""How many states at a frequency, or folds, there are at any forcing: an oscillator in, levels of the forcing out.

Both numbers change only where the forcing passes a level: the forcing sqrt(F + F_0^2) of a state with F_A = 0 at that
frequency, or an extremum of the forcing on the fold locus. `averaged` encloses all of them, so that a count at any
forcing is proved by comparing numbers, a thousand times cheaper than by isolating roots at each.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

from flint import arb, fmpq_poly

from tests.oracles.averaged import ATTACHED, BITS, CORNER, DETACHED, Jet, Oscillator, Point, exact
from tests.oracles.certified_roots import precision
from tests.oracles.conditioning import Conditioning

U = 2.0**-53


class States:
    """The steady states at one frequency. Raises ArithmeticError where the isolation does not settle."""

    def __init__(self, oscillator: Oscillator, Omega: float) -> None:
        with precision(BITS):

            def half_F_A(j: Jet) -> Any:
                w = exact(Omega) if isinstance(j.A, fmpq_poly) else arb(exact(Omega))
                return oscillator._value(oscillator._slope_polynomial(j), w)

            # A itself is no factor of F_A where there is friction
            nodes = [(A, regime) for A, regime in oscillator._zeros(half_F_A, oscillator._fold_range)]
            if oscillator.u_cr is not None:
                nodes.append((oscillator.u_cr, CORNER))
            nodes.sort(key=lambda node: node[0].mid())
            for (a, _), (b, _) in pairwise(nodes):
                if a.overlaps(b):
                    raise ArithmeticError("two turns at one amplitude")
            frequency = arb(exact(Omega))
            #: forcings along A, from A = 0 on; beyond the last they rise
            self.levels = [oscillator.m, *(oscillator.forcing(frequency, A, _side(regime)) for A, regime in nodes)]
            #: what a relative unit in every input and in h does to each
            self.Omega = [Omega for _ in range(len(nodes) + 1)]
            self.conditions = [1.0, *(_condition(oscillator, frequency, A, regime) for A, regime in nodes)]

    def count(self, F_0: float) -> int:
        """How many at this forcing. Raises ArithmeticError where it is a level to 80 digits."""
        with precision(BITS):
            above = [_above(level, arb(exact(F_0))) for level in self.levels]
            return sum(a != b for a, b in pairwise([*above, True]))


class Folds:
    """The folds of one oscillator."""

    def __init__(self, oscillator: Oscillator) -> None:
        self.oscillator = oscillator
        with precision(BITS):
            self.levels = [p.F_0 for p in oscillator.extrema] + [level for level, _, _ in oscillator.ends]
            known = [Conditioning(oscillator).extremum(p) for p in oscillator.extrema]
            self.conditions = [0.0 if c is None else c.inputs["F_0"] + c.kernel["F_0"] for c in known]
            sides = [(A, oscillator.regime(A)) for _, _, A in oscillator.ends]
            self.conditions += [_condition(oscillator, arb(0), A, regime) for A, regime in sides]
            #: where each lies
            self.Omega = [float(p.Omega.mid()) for p in oscillator.extrema] + [0.0 for _ in oscillator.ends]

    def count(self, F_0: float) -> int:
        """How many at this forcing. Raises ArithmeticError where it is a level."""
        return self.oscillator.fold_count(F_0)


def _side(regime: str) -> str:
    return DETACHED if regime == DETACHED else ATTACHED


def _above(level: arb, forcing: arb) -> bool:
    if level > forcing:
        return True
    if level < forcing:
        return False
    raise ArithmeticError("a forcing at a level")


def _condition(oscillator: Oscillator, Omega: arb, A: arb, regime: str) -> float:
    """Of a level of the states in the oscillator's numbers, Omega and h: where F_A = 0, A may stay as it is."""
    level = oscillator.forcing(Omega, A, _side(regime))
    try:
        found = Conditioning(oscillator).solved(Point(Omega, A, regime), ("F_0",), ("F",), Omega, level)
    except ValueError:  # u_cr passes the amplitude as a parameter changes by 2^-100
        return math.nan
    return found.inputs["F_0"] + found.kernel["F_0"]


def distance(counted: States | Folds, F_0: float) -> tuple[float, float, float]:
    """Of a forcing to the nearest level, in u (1 + kappa) of the level; relative; and that level's frequency."""
    with precision(BITS):
        forcing = arb(exact(F_0))
        relative = [float(abs(level / forcing - 1).mid()) for level in counted.levels]
    units = [x / (U * (1 + kappa)) for x, kappa in zip(relative, counted.conditions, strict=True)]
    return min(zip(units, relative, counted.Omega, strict=True), default=(math.inf, math.inf, math.inf))
