"""Seeds in; tests/data/inertia.json out: certified reference values for oscillators on a base that shakes.

    python -m tests.oracles.inertia

`averaged` does the work, with F = R^2 + I^2 - (F_0 Omega^2)^2. A state at a frequency is one under the force
F_0 Omega^2, taken exactly.
"""

import random
from fractions import Fraction

from flint import arb

from tests.files import store
from tests.oracles.averaged import (
    Amplitude,
    Duffing,
    Number,
    Oscillator,
    RodSpring,
    digits,
    exact,
)
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


def shaken(kind: type[Oscillator]) -> type[Oscillator]:
    """That kind of oscillator on a base that shakes."""
    return type(kind.__name__, (ByInertia, kind), {})


def reference_case(rng: random.Random, oscillator: Oscillator, F_0: float) -> dict:
    """Its folds and states at one forcing, which is below u_cr."""
    if oscillator.u_cr is not None:
        F_0 = min(F_0, 0.9 * float(oscillator.u_cr.mid()))
    folds = oscillator.folds(F_0)
    around = float(folds[0].Omega.mid()) if folds else 1.0
    frequencies = around * rng.uniform(1.005, 1.05), log_uniform(rng, 0.3, 3)
    return {"F_0": encoded(F_0), **answered(oscillator, folds, F_0, frequencies)}


def case(mechanism: str, index: int) -> dict:
    """Random oscillator number `index`, at an F_0 of 0.3 to 3 times that of its lowest cusp."""
    rng = random.Random(f"{SEED} inertia {mechanism} {index}")
    is_rod = mechanism == "rod_spring"
    parameters = draw_isolator(rng) if is_rod else draw_duffing(rng, index)
    oscillator = shaken(RodSpring if is_rod else Duffing)(**parameters)
    cusps = oscillator.cusps
    F_0 = log_uniform(rng, 0.3, 3) * (float(cusps[0].F_0.mid()) if cusps else 0.05)
    known = reference_case(rng, oscillator, F_0)
    return {
        "mechanism": mechanism,
        "parameters": {k: encoded(v) for k, v in parameters.items()},
        "F_0": known.pop("F_0"),
        "cusps": [
            {name: digits(getattr(p, name)) for name in ("F_0", "Omega", "A")} | {"sense": p.sense} for p in cusps
        ],
        **known,
    }


if __name__ == "__main__":
    store("inertia", [case(name, index) for name in ("duffing", "rod_spring") for index in range(EACH)])
