"""Seeds in; tests/data/off_centre_laws.json out: certified folds and states off the centre, of other laws, on a base.

    python -m tests.oracles.make_off_centre_laws

`make_sided` has the forces, their mean balanced in closed form along a parameter, `averaged` structural and quadratic
damping, and `inertia` a base that shakes; they are put together here. Bounds beside these: with y
for Omega^2 + h/A a fold has y (e - y) = I I_A/A >= 4 zeta^2 Omega^2, by all laws, so |h - A h_A| >= 4 zeta A sqrt(K) as
there. On a base F_0 Omega^2 >= I bounds A by F_0 Omega/(2 zeta), and Omega at a fold by the largest slope of the force:
the forces on a base are those whose slope has a bound.
"""

from __future__ import annotations

import random

from flint import arb

from tests.files import store
from tests.oracles.averaged import BITS, exact
from tests.oracles.certified_roots import precision
from tests.oracles.inertia import ByInertia
from tests.oracles.make_random_isolators import SEED, answered, encoded, log_uniform
from tests.oracles.make_sided import Parametrized, Stop, drawn, with_mean

#: excitation, laws, force, and how many of these
COUNTS = (
    ("base", (), "stop", 8),
    ("base", (), "springs", 7),
    ("base", ("eta",), "stop", 3),
    ("base", ("c_2",), "springs", 3),
    ("base", ("eta", "c_2"), "stop", 4),
    ("force", ("eta",), "stop", 4),
    ("force", ("eta",), "even", 3),
    ("force", ("c_2",), "springs", 4),
    ("force", ("c_2",), "even", 3),
    ("force", ("eta", "c_2"), "stop", 3),
)


class ShakenStop(ByInertia, Stop):
    """A stop on one side, or two springs, on a base that shakes."""

    def ask(self, F_0: float, frequencies: list[float]) -> None:
        with precision(BITS):
            self.level = forcing = arb(exact(F_0))
            steepest = self._p("a") + (self._p("k") if self._p("k") > 0 else 0)
            self.high = forcing * steepest.sqrt() / (2 * arb(self.zeta)) * arb("1.001")
            self.end = None if self.high < self.edge else arb(self.place(self.high).mid())


def case(excitation: str, laws: tuple[str, ...], force: str, index: int) -> dict:
    """One oscillator: its folds and states at one forcing."""
    rng = random.Random(f"{SEED} laws {excitation} {laws} {force} {index}")
    user, of, sign = drawn(force, rng, index)
    damping = {"eta": log_uniform(rng, 0.005, 0.08), "c_2": log_uniform(rng, 0.02, 0.6)}
    damping = {name: value if name in laws else 0.0 for name, value in damping.items()}
    kind = ShakenStop if excitation == "base" else type(of)
    oscillator: Parametrized = kind(**of.parameters, **damping)
    base = float(oscillator.least_slope.sqrt().mid())
    size = float(oscillator.edge.mid()) if oscillator.edge is not None else 0.4
    damped = 2 * user["zeta"] * base + damping["eta"] + damping["c_2"] * size * base**2
    F_0 = float(oscillator.m.mid()) + size * damped * base * rng.uniform(1.2, 5)
    if excitation == "base":
        F_0 /= base**2
    oscillator.ask(F_0, [base])
    folds = oscillator.folds(F_0)
    at = [float(p.Omega.mid()) for p in folds]
    among = rng.uniform(at[0], at[-1]) if len(at) > 1 else base * rng.uniform(0.9, 1.3)

    frequencies = among, base * rng.uniform(0.8, 2)
    oscillator.ask(F_0, frequencies)
    return {
        "excitation": excitation,
        "force": force,
        "parameters": {name: encoded(value) for name, value in {**user, **damping}.items()},
        "F_0": encoded(F_0),
        **answered(oscillator, folds, F_0, frequencies, "Omega kind", "phi stable", with_mean(oscillator, sign)),
    }


if __name__ == "__main__":
    store("off_centre_laws", [case(*rest, index) for *rest, count in COUNTS for index in range(count)])
