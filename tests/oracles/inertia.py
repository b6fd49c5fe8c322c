"""Seeds in; tests/data/inertia.json out: certified reference values for oscillators on a base that shakes.

    python -m tests.oracles.inertia

`averaged` does the work, with F = R^2 + I^2 - (F_0 Omega^2)^2. A state at a frequency is one under the force
F_0 Omega^2, taken exactly.
"""

import random
from fractions import Fraction
from functools import cached_property

from flint import arb

from tests.files import store
from tests.oracles.averaged import (
    BITS,
    Amplitude,
    Duffing,
    Number,
    Oscillator,
    Point,
    RodSpring,
    _sign,
    digits,
    exact,
)
from tests.oracles.certified_roots import precision
from tests.oracles.make_random_isolators import SEED, answered, draw_duffing, draw_isolator, encoded, log_uniform

EACH = 20


class ByInertia(Oscillator):
    """In place of a force F_0 one of F_0 Omega^2; to be mixed into a kind of oscillator."""

    driven_by = 4

    def amplitudes(self, Omega: Number, F_0: Number) -> list[Amplitude]:
        force = Fraction(F_0) * Fraction(Omega) ** 2
        if not arb(exact(force)) > self.m:
            return []
        other = type(self).__bases__[1](**self.parameters)  # what this is mixed into
        other.ask(force, [Omega])
        return other.amplitudes(Omega, force)

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


def shaken(kind: type[Oscillator]) -> type[Oscillator]:
    """That kind of oscillator on a base that shakes."""
    return type(kind.__name__, (ByInertia, kind), {})


def case(mechanism: str, index: int) -> dict:
    """Random oscillator number `index`, at an F_0 of 0.3 to 3 times that of its lowest cusp, below u_cr."""
    rng = random.Random(f"{SEED} inertia {mechanism} {index}")
    is_rod = mechanism == "rod_spring"
    parameters = draw_isolator(rng) if is_rod else draw_duffing(rng, index)
    oscillator = shaken(RodSpring if is_rod else Duffing)(**parameters)
    cusps = oscillator.cusps
    F_0 = log_uniform(rng, 0.3, 3) * (float(cusps[0].F_0.mid()) if cusps else 0.05)
    if is_rod:
        F_0 = min(F_0, 0.9 * float(oscillator.u_cr.mid()))
    folds = oscillator.folds(F_0)
    around = float(folds[0].Omega.mid()) if folds else 1.0
    frequencies = around * rng.uniform(1.005, 1.05), log_uniform(rng, 0.3, 3)
    with precision(BITS):
        shown = [{"F_0": digits(p.F_0), "Omega": digits(p.Omega), "A": digits(p.A), "sense": p.sense} for p in cusps]
    return {
        "mechanism": mechanism,
        "parameters": {k: encoded(v) for k, v in parameters.items()},
        "F_0": encoded(F_0),
        "cusps": shown,
        **answered(oscillator, folds, F_0, frequencies),
    }


if __name__ == "__main__":
    store("inertia", [case(name, index) for name in ("duffing", "rod_spring") for index in range(EACH)])
