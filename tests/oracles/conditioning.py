"""Certified points of `averaged` in; relative condition numbers out, as floats good to a few digits.

Two numbers for each quantity x: `inputs`, the sum of |dx/dp p/x| over the oscillator's parameters and the forcing, and
`kernel`, the same over h, h_A (and h_AA, where the point needs it), taken as free: what relative errors of one unit in
the kernels' values do to x. An algorithm that is backward stable in both senses errs by at most their sum, in units.
The derivatives are implicit: J dx = -(dr/dp) dp, with dr/dp by a difference quotient in 280-bit arithmetic.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

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


class Conditioning:
    """Condition numbers of the points of one oscillator."""

    def __init__(self, oscillator: Oscillator) -> None:
        self.oscillator = oscillator
        self.neighbours = perturbed(oscillator)

    def _solve(
        self,
        names: Sequence[str],
        values: Sequence[arb],
        jacobian: list[list[arb]],
        residual: Callable[[Oscillator, arb], list[arb]],
        F_0: arb,
        kernel: list[list[arb]],
        by_forcing: bool = True,
    ) -> Condition:
        inverse = arb_mat([[arb(x.mid()) for x in row] for row in jacobian]).inv()
        size = len(values)

        def total(changes: list[list[arb]]) -> dict[str, float]:
            sums = [arb(0)] * size
            for change in changes:
                shift = inverse * arb_mat(size, 1, [arb(c.mid()) for c in change])
                sums = [s + abs(shift[i, 0]) for i, s in enumerate(sums)]
            return {n: float((s / abs(v)).mid()) for n, s, v in zip(names, sums, values, strict=True)}

        base, step = residual(self.oscillator, F_0), arb(STEP)
        others = [residual(o, F_0) for o in self.neighbours]
        if by_forcing:
            others.append(residual(self.oscillator, F_0 * (1 + step)))
        changes = [[(b - a) / step for a, b in zip(base, other, strict=True)] for other in others]
        return Condition(total(changes), total(kernel))

    def _terms(self, p: Any, Omega: arb, F_0: arb) -> tuple[dict[str, arb], tuple, arb]:
        d = self.oscillator.derivatives(Omega, p.A, p.regime, F_0)
        h = self.oscillator.h(p.A, p.regime)
        return d, h, Omega**2 + h[1]

    def fold(self, p: Point) -> Condition:
        """Omega and A of a fold at given forcing."""
        with precision(BITS):
            d, h, R_A = self._terms(p, p.Omega, p.F_0)
            if p.regime == CORNER:
                return self._on_corner(("Omega",), (p.Omega,), [[d["O"]]], ("F",), p, [[2 * d["R"] * h[0]]])

            def residual(o: Oscillator, F_0: arb) -> list[arb]:
                e = o.derivatives(p.Omega, p.A, p.regime, F_0)
                return [e["F"], e["A"]]

            zero = arb(0)
            kernel = [[2 * d["R"] * h[0], 2 * R_A * h[0]], [zero, 2 * d["R"] * h[1]]]
            jacobian = [[d["O"], zero], [d["AO"], d["AA"]]]
            return self._solve(("Omega", "A"), (p.Omega, p.A), jacobian, residual, p.F_0, kernel)

    def amplitude(self, a: Amplitude, Omega: Number, F_0: Number) -> Condition:
        """A steady state's amplitude at given frequency and forcing (the frequency counts as an input)."""
        with precision(BITS):
            forcing, frequency = arb(exact(F_0)), arb(exact(Omega))
            d, h, _ = self._terms(a, frequency, forcing)

            def residual(o: Oscillator, F_0: arb) -> list[arb]:
                return [o.derivatives(frequency, a.A, a.regime, F_0)["F"]]

            c = self._solve(("A",), (a.A,), [[d["A"]]], residual, forcing, [[2 * d["R"] * h[0]]])
            c.inputs["A"] += float(abs(d["O"] * frequency / (d["A"] * a.A)).mid())
            return c

    def extremum(self, p: Point) -> Condition | None:
        """F_0, Omega and A of an extremum of the forcing on the fold locus; None for a joint of the corner."""
        with precision(BITS):
            d, h, R_A = self._terms(p, p.Omega, p.F_0)
            zero, forcing = arb(0), -2 * p.F_0
            names, values = ("Omega", "A", "F_0"), (p.Omega, p.A, p.F_0)
            R = d["R"]
            if p.kind == "cusp":
                keys = ("F", "A", "AA")
                jacobian = [
                    [d["O"], zero, forcing],
                    [d["AO"], zero, zero],
                    [d["AAO"], d["AAA"], zero],
                ]
                kernel = [
                    [2 * R * h[0], 2 * R_A * h[0], 2 * h[2] * h[0]],
                    [zero, 2 * R * h[1], 4 * R_A * h[1]],
                    [zero, zero, 2 * R * h[2]],
                ]
            elif p.kind == "isola":
                keys = ("F", "A", "O")
                jacobian = [[zero, zero, forcing], [d["AO"], d["AA"], zero], [d["OO"], d["AO"], zero]]
                kernel = [
                    [2 * R * h[0], 2 * R_A * h[0], 4 * p.A * p.Omega * h[0]],
                    [zero, 2 * R * h[1], zero],
                ]
            elif R.contains(0):
                keys = ("F", "R")
                jacobian = [[d["O"], forcing], [2 * p.A * p.Omega, zero]]
                return self._on_corner(("Omega", "F_0"), (p.Omega, p.F_0), jacobian, keys, p, [[zero, h[0]]])
            else:
                return None

            def residual(o: Oscillator, F_0: arb) -> list[arb]:
                e = o.derivatives(p.Omega, p.A, p.regime, p.F_0)
                return [e[k] for k in keys]

            return self._solve(names, values, jacobian, residual, p.F_0, kernel, by_forcing=False)

    def detachment(self, p: Point) -> Condition | None:
        """F_cr and Omega_cr; None for the limit Omega -> 0."""
        if p.sense == "limit":
            return None
        with precision(BITS):
            d, h, _ = self._terms(p, p.Omega, p.F_0)
            jacobian = [[d["O"], -2 * p.F_0], [d["OO"], arb(0)]]
            kernel = [[2 * d["R"] * h[0], 4 * p.A * p.Omega * h[0]]]
            return self._on_corner(("Omega", "F_0"), (p.Omega, p.F_0), jacobian, ("F", "O"), p, kernel)

    def _on_corner(
        self,
        names: tuple[str, ...],
        values: tuple[arb, ...],
        jacobian: list[list[arb]],
        keys: tuple[str, ...],
        p: Point,
        kernel: list[list[arb]],
    ) -> Condition:
        """Points tied to A = u_cr, which moves with the parameters; F_0 is an input only where it is no unknown."""

        def residual(o: Oscillator, F_0: arb) -> list[arb]:
            e = o.derivatives(p.Omega, o.u_cr, CORNER, F_0)
            return [e[k] for k in keys]

        c = self._solve(names, values, jacobian, residual, p.F_0, kernel, by_forcing="F_0" not in names)
        base, step = self.oscillator.u_cr, arb(STEP)
        c.inputs["A"] = float(sum((abs(o.u_cr - base) / (base * step) for o in self.neighbours), arb(0)).mid())
        c.kernel["A"] = 0.0
        return c
