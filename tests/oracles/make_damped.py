"""Seeds in; tests/data/damped_*.json out: certified folds, onsets and states of oscillators with other laws of damping.

    python -m tests.oracles.make_damped

`averaged` does the work.
The number of folds at each forcing is found twice, by isolating them and by the extrema of the forcing on the fold
locus; where the two differ the run stops.
"""

import random

from tests.files import store
from tests.oracles.averaged import Duffing, RodSpring
from tests.oracles.conditioning import Conditioning
from tests.oracles.inertia import reference_case, shaken
from tests.oracles.make_random_isolators import (
    SEED,
    answered,
    draw_duffing,
    draw_isolator,
    encoded,
    log_uniform,
    row,
)

LAWS = ("eta", "c_2", "contact")
EACH = 30
#: on a base that shakes, of four combinations of laws
SHAKEN = 40


class ReleasedRod(RodSpring):
    """The isolator whose bearings rub while the rods are attached."""

    ends_at_u_cr = True


def drawn(law: str, index: int, rod: bool, bare: bool, rng: random.Random) -> dict[str, float]:
    """Numbers of an isolator, or of Duffing oscillator number `index`; a bare one has no viscous damping if it can."""
    design = draw_isolator(rng) if rod else draw_duffing(rng, index)
    bare = bare and law != "contact" and design.get("beta", 1.0) > 0
    parameters = {
        **design,
        "zeta": 0.0 if bare else design["zeta"],
        "eta": log_uniform(rng, 0.003, 0.15) if law in ("eta", "both") else 0.0,
        "c_2": log_uniform(rng, 0.01, 1) if law in ("c_2", "both") else 0.0,
    }
    if law == "contact":
        parameters["mu"] = log_uniform(rng, 0.001, 0.03)
    return parameters


def case(law: str, index: int) -> dict:
    """One oscillator: its onset, and its folds and states at one forcing."""
    rng = random.Random(f"{SEED} damped {law} {index}")
    rod = law == "contact" or index % 2 == 0
    parameters = drawn(law, index // 2, rod, index % 3 == 0, rng)
    oscillator = (ReleasedRod if law == "contact" else RodSpring if rod else Duffing)(**parameters)
    onset = oscillator.onset()
    m = float(oscillator.m.mid())
    if onset is None:
        F_0 = m + log_uniform(rng, 0.01, 1)
    else:
        F_SN = float(onset.F_0.mid())
        F_0 = F_SN * rng.choice([1.02, log_uniform(rng, 0.8, 6), log_uniform(rng, 1, 3)])
        F_0 = max(F_0, 1.05 * m)
    folds = oscillator.folds(F_0)
    if len(folds) != oscillator.fold_count(F_0):
        raise AssertionError(f"{len(folds)} folds found, {oscillator.fold_count(F_0)} counted: {parameters}, {F_0}")
    at = [float(p.Omega.mid()) for p in folds]
    among = rng.uniform(at[0], at[-1]) if len(at) > 1 else rng.uniform(0.9, 1.1)
    is_lowest = onset and all(onset.F_0 < level for level, trend, _ in oscillator.ends if trend > 0)
    condition = onset and Conditioning(oscillator).extremum(onset)
    lowest = onset and row(onset, "F_0 Omega A kind regime global", condition, **{"global": is_lowest})
    return {
        "mechanism": "duffing" if isinstance(oscillator, Duffing) else "rod_spring",
        "parameters": {k: encoded(v) for k, v in parameters.items()},
        "contact": "attached" if oscillator.ends_at_u_cr else "throughout",
        "onset": lowest and {"F_SN": lowest.pop("F_0"), **lowest},
        "F_0": encoded(F_0),
        **answered(oscillator, folds, F_0, (among, log_uniform(rng, 0.3, 3))),
    }


def shaken_case(index: int) -> dict:
    """Oscillator number `index` of the four combinations in turn, on a base that shakes."""
    rng = random.Random(f"{SEED} damped base {index}")
    law = ("eta", "c_2", "both", "contact")[index % 4]
    rod = law == "contact" or index // 4 % 2 == 0
    parameters = drawn(law, index // 4, rod, index // 4 % 3 == 0, rng)
    kind = ReleasedRod if law == "contact" else RodSpring if rod else Duffing
    oscillator = shaken(kind)(**parameters)
    cusps = oscillator.cusps
    F_0 = log_uniform(rng, 0.6, 3) * (float(cusps[0].F_0.mid()) if cusps else 0.05)
    return {
        "mechanism": "rod_spring" if rod else "duffing",
        "parameters": {k: encoded(v) for k, v in parameters.items()},
        "contact": "attached" if law == "contact" else "throughout",
        **reference_case(rng, oscillator, F_0),
    }


if __name__ == "__main__":
    for law in LAWS:
        store(f"damped_{law}", [case(law, index) for index in range(EACH)])
    store("damped_base", [shaken_case(index) for index in range(SHAKEN)])
