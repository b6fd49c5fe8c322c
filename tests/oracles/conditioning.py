"""Certified points of `averaged` in; relative condition numbers out, as floats good to a few digits.

Two numbers for each quantity x: `inputs`, the sum of |dx/dp p/x| over the oscillator's parameters and what is given of
the frequency and the forcing, and `kernel`, the same over h, h_A and h_AA, taken as free: what relative errors of one
unit in the kernels' values do to x. An algorithm that is backward stable in both senses errs by at most their sum, in
units. The derivatives are implicit: J dx = -(dr/dp) dp, with all of J and dr/dp by quotients of differences of the
residuals r, over relative changes of 2^-100 in 280-bit arithmetic.
"""

import copy
from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_mat, fmpq

from tests.oracles.averaged import BITS, CORNER, Amplitude, Number, Oscillator, Point, exact
from tests.oracles.certified_roots import precision

STEP = fmpq(1, 2**100)


@dataclass
class Condition:
    """Relative condition numbers of the named quantities."""

    inputs: dict[str, float]
    kernel: dict[str, float]


def perturbed(oscillator: Oscillator) -> list[Oscillator]:
    """The oscillator with each nonzero parameter in turn larger by the relative amount STEP."""
    p = oscillator.parameters
    return [type(oscillator)(**{**p, name: p[name] * (1 + STEP)}) for name in p if p[name] != 0]


def with_kernels(oscillator: Oscillator, A: arb, regime: str) -> list[Oscillator]:
    """The oscillator with h, h_A or h_AA at this amplitude larger by that."""
    h, found = oscillator.h(A, regime), []
    for order in range(3):
        values = tuple(value * (1 + arb(STEP)) if n == order else value for n, value in enumerate(h))
        other = copy.copy(oscillator)
        other.h = lambda A, regime, values=values: values  # type: ignore[method-assign]
        found.append(other)
    return found


class Conditioning:
    """Condition numbers of the points of one oscillator."""

    def __init__(self, oscillator: Oscillator) -> None:
        self.oscillator = oscillator
        self.neighbours = perturbed(oscillator)

    def solved(
        self, p: Point | Amplitude, unknowns: Sequence[str], vanish: Sequence[str], Omega: arb, F_0: arb
    ) -> Condition:
        """Of unknowns among Omega, A and F_0, which these of the oscillator's `derivatives` vanish at.

        On the corner A is u_cr, which moves with the parameters.
        """
        on_corner, step = p.regime == CORNER, arb(STEP)
        known = {"Omega": Omega, "A": p.A, "F_0": F_0}

        def residual(of: Oscillator, larger: str = "") -> list[arb]:
            at = {name: value * (1 + step) if name == larger else value for name, value in known.items()}
            values = of.derivatives(at["Omega"], of.u_cr if on_corner else at["A"], p.regime, at["F_0"])
            return [values[name] for name in vanish]

        base = residual(self.oscillator)

        def changes(*others: list[arb]) -> list[list[arb]]:
            return [[arb(((b - a) / step).mid()) for a, b in zip(base, other, strict=True)] for other in others]

        by_unknowns = changes(*(residual(self.oscillator, name) for name in unknowns))
        inverse = arb_mat(by_unknowns).transpose().inv()

        def total(changed: list[list[arb]]) -> dict[str, float]:
            shifts = [inverse * arb_mat(len(vanish), 1, change) for change in changed]
            return {
                name: float(sum((abs(shift[k, 0]) for shift in shifts), arb(0)).mid())
                for k, name in enumerate(unknowns)
            }

        fixed = [name for name in known if name not in unknowns and name != "A"]
        inputs = [*map(residual, self.neighbours), *(residual(self.oscillator, name) for name in fixed)]
        kernels = map(residual, with_kernels(self.oscillator, p.A, p.regime))
        found = Condition(total(changes(*inputs)), total(changes(*kernels)))
        if on_corner:
            of_corner = (abs(of.u_cr / self.oscillator.u_cr - 1) for of in self.neighbours)
            found.inputs["A"], found.kernel["A"] = float((sum(of_corner, arb(0)) / step).mid()), 0.0
        return found

    def fold(self, p: Point) -> Condition:
        """Omega and A of a fold at given forcing."""
        with precision(BITS):
            unknowns, vanish = (("Omega",), ("F",)) if p.regime == CORNER else (("Omega", "A"), ("F", "A"))
            return self.solved(p, unknowns, vanish, p.Omega, p.F_0)

    def amplitude(self, a: Amplitude, Omega: Number, F_0: Number) -> Condition:
        """A steady state's amplitude at given frequency and forcing."""
        with precision(BITS):
            return self.solved(a, ("A",), ("F",), arb(exact(Omega)), arb(exact(F_0)))

    def extremum(self, p: Point) -> Condition | None:
        """F_0, Omega and A of an extremum of the forcing on the fold locus; None for a joint of the corner."""
        with precision(BITS):
            unknowns = ("Omega", "A", "F_0")
            if p.kind in ("cusp", "isola"):
                return self.solved(p, unknowns, ("F", "A", "AA" if p.kind == "cusp" else "O"), p.Omega, p.F_0)
            if not self.oscillator.derivatives(p.Omega, p.A, p.regime, p.F_0)["R"].contains(0):
                return None
            return self.solved(p, unknowns[::2], ("F", "R"), p.Omega, p.F_0)

    def detachment(self, p: Point) -> Condition | None:
        """F_cr and Omega_cr; None for the limit Omega -> 0."""
        if p.sense == "limit":
            return None
        with precision(BITS):
            return self.solved(p, ("Omega", "F_0"), ("F", "O"), p.Omega, p.F_0)
