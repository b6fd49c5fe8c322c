"""Seeds in; tests/data/inertia.json out: certified reference values for oscillators on a base that shakes.

    python -m tests.oracles.inertia

`averaged` does the work, with F = R^2 + I^2 - (F_0 Omega^2)^2. What changes: A F_A/2 - F is a quartic in Omega now,
from which F takes the leading power, so the folds are the zeros of the resultant of a quadratic and F. That holds the
factor A^2 - F_0^2 once or twice, which is divided out exactly where h is a polynomial, and vanishes nowhere else, as
F_0 stays below u_cr. A state at a frequency is one under the force F_0 Omega^2, taken exactly.
"""

import json
import random
from collections.abc import Callable
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import Any

from flint import arb, fmpq_poly

from tests.oracles.averaged import (
    BITS,
    DETACHED,
    Amplitude,
    Duffing,
    Jet,
    Number,
    Oscillator,
    Point,
    RodSpring,
    _res_quadratic_quartic,
    _sign,
    digits,
    exact,
)
from tests.oracles.certified_roots import precision
from tests.oracles.conditioning import Conditioning
from tests.oracles.make_random_isolators import (
    SEED,
    conditions,
    draw_duffing,
    draw_isolator,
    given,
    log_uniform,
    write,
)

EACH = 20


class ByInertia(Oscillator):
    """In place of a force F_0 one of F_0 Omega^2; to be mixed into a kind of oscillator."""

    plain: type[Oscillator]

    def derivatives(self, Omega: arb, A: arb, regime: str, F_0: arb) -> dict[str, arb]:
        d = super().derivatives(Omega, A, regime, arb(0))
        square = Omega * Omega
        d["F"] = d["F"] - (F_0 * square) ** 2
        d["O"] = d["O"] - 4 * F_0 * F_0 * Omega * square
        d["OO"] = d["OO"] - 12 * F_0 * F_0 * square
        return d

    def forcing(self, Omega: arb, A: arb, regime: str) -> arb:
        return super().forcing(Omega, A, regime) / (Omega * Omega)


class Shaken(ByInertia):
    """With viscous damping and friction."""

    def _fold_quadratic(self, j: Jet, F_0: Any) -> tuple[Any, Any, Any]:
        zeta, m = self._constants(j.A)
        lag = j.s * j.h - j.A * j.g
        square = F_0 * F_0
        over = j.A * j.A - square
        f2, f1, f0 = 2 * j.A * j.h + 4 * zeta * zeta * j.A * j.A, 4 * zeta * m * j.A, j.h * j.h + m * m
        return (
            over * j.A * lag + j.s * f2 * square,
            j.s * (over * (2 * zeta * m * j.A) + f1 * square),
            over * (j.h * lag + j.s * m * m) + j.s * f0 * square,
        )

    def _fold_resultant(self, j: Jet, F_0: Any) -> Any:
        zeta, m = self._constants(j.A)
        a, b, c = self._fold_quadratic(j, F_0)
        f4, f2 = j.A * j.A - F_0 * F_0, 2 * j.A * j.h + 4 * zeta * zeta * j.A * j.A
        f0 = j.h * j.h + m * m
        if self.mu == 0:
            value = f4 * c * c - f2 * a * c + f0 * a * a
        else:
            value = _res_quadratic_quartic(a, b, c, f4, f2, 4 * zeta * m * j.A, f0)
        factor = f4 if self.mu == 0 else f4 * f4
        if not isinstance(value, fmpq_poly):
            return value / factor
        quotient, remainder = divmod(value, factor)
        if remainder != 0:
            raise ArithmeticError("the resultant of the folds does not have its factor")
        return quotient

    def _omegas(self, quadratic: Callable[[Jet], tuple], A: arb, regime: str) -> list[arb]:
        h, h_A, h_AA, _ = self.h(A, regime)
        if self.mu == 0 and h.contains(0):  # the quadratic is a Omega^2 + c with the factor h in c
            if quadratic(Jet(A, h, h_A, h_AA, arb(1)))[0].contains(0):
                raise ArithmeticError("the quadratic in Omega vanishes")
            return []
        return super()._omegas(quadratic, A, regime)

    def folds(self, F_0: Number) -> list[Point]:
        if self.u_cr is not None and not arb(exact(F_0)) < self.u_cr:
            raise ValueError("F_0 must be below u_cr")
        return super().folds(F_0)

    def frequencies(self, A: Number | arb, F_0: Number | arb, regime: str | None = None) -> list[arb]:
        with precision(BITS):
            A = A if isinstance(A, arb) else arb(exact(A))
            F_0 = F_0 if isinstance(F_0, arb) else arb(exact(F_0))
            h = self.h(A, regime or self.regime(A))[0]
            zeta, m = arb(self.zeta), self.m
            return self._quartic(
                (A - F_0) * (A + F_0), 2 * A * h + 4 * zeta**2 * A * A, 4 * zeta * m * A, h * h + m * m
            )

    def amplitudes(self, Omega: Number, F_0: Number) -> list[Amplitude]:
        force = Fraction(F_0) * Fraction(Omega) ** 2
        return [] if not arb(exact(force)) > self.m else self.plain(**self.parameters).amplitudes(Omega, force)

    @cached_property
    def cusps(self) -> list[Point]:
        """Where F_A = F_AA = 0, with the F_0 there."""
        with precision(BITS):
            points = self._cusps()
            for p in points:
                p.F_0 = self.forcing(p.Omega, p.A, p.regime)
                d = self.derivatives(p.Omega, p.A, p.regime, p.F_0)
                p.sense = "min" if _sign(d["O"] * d["AAA"] * d["AO"]) < 0 else "max"
            return sorted(points, key=lambda p: p.F_0.mid())


class ShakenRod(Shaken, RodSpring):
    """The isolator."""

    plain = RodSpring


class ShakenDuffing(Shaken, Duffing):
    """One cubic piece."""

    plain = Duffing


def case(mechanism: str, index: int) -> dict:
    """Random oscillator number `index`, at an F_0 of 0.3 to 3 times that of its lowest cusp, below u_cr."""
    rng = random.Random(f"{SEED} inertia {mechanism} {index}")
    is_rod = mechanism == "rod_spring"
    parameters = draw_isolator(rng, lambda: rng.uniform(0.02, 0.97)) if is_rod else draw_duffing(rng, index)
    oscillator = ShakenRod(**parameters) if is_rod else ShakenDuffing(**parameters)
    cusps = oscillator.cusps
    F_0 = log_uniform(rng, 0.3, 3) * (float(cusps[0].F_0.mid()) if cusps else 0.05)
    if is_rod:
        F_0 = min(F_0, 0.9 * float(oscillator.u_cr.mid()))
    conditioning = Conditioning(oscillator)
    folds = oscillator.folds(F_0)
    around = float(folds[0].Omega.mid()) if folds else 1.0
    with precision(BITS):
        record: dict[str, Any] = {
            "mechanism": mechanism,
            "parameters": {k: given(v) for k, v in parameters.items()},
            "F_0": given(F_0),
            "cusps": [
                {"F_0": digits(p.F_0), "Omega": digits(p.Omega), "A": digits(p.A), "sense": p.sense} for p in cusps
            ],
            "folds": [
                {
                    "Omega": digits(p.Omega),
                    "A": digits(p.A),
                    "kind": p.kind,
                    "corner": p.regime not in ("attached", DETACHED),
                    **conditions(conditioning.fold(p)),
                }
                for p in folds
            ],
            "amplitudes": [],
        }
    for Omega in (around * rng.uniform(1.005, 1.05), log_uniform(rng, 0.3, 3)):
        found = oscillator.amplitudes(Omega, F_0)
        record["amplitudes"].append({"Omega": given(Omega), "steady": []})
        for state in found:
            condition = conditioning.amplitude(state, Omega, F_0)
            with precision(BITS):
                record["amplitudes"][-1]["steady"].append(
                    {"A": digits(state.A), "phi": digits(state.phi), "stable": state.stable, **conditions(condition)}
                )
    return record


def main() -> None:
    cases = [case(mechanism, index) for mechanism in ("duffing", "rod_spring") for index in range(EACH)]
    write(Path(__file__).parents[1] / "data" / "inertia.json", cases)
    print(json.dumps({"cases": len(cases), "folds": sum(len(one["folds"]) for one in cases)}))


if __name__ == "__main__":
    main()
