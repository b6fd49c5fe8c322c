"""The worst of a function over points of doubles: random points in, the worst that small moves lead to out.

Moves change one coordinate: by a few ulps, by a factor, to a power of two nearby. The function is an error and as
rough as rounding is, so nothing cleverer pays.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

Point = tuple[float, ...]
#: error in units and condition of a point, None outside the domain
Measure = Callable[[Point], tuple[float, float] | None]


@dataclass(frozen=True)
class Found:
    """A measured point: its error in u (1 + kappa), 1 + kappa, and the place where the search began."""

    error: float
    condition: float
    at: Point
    place: str


def neighbour(x: Point, rng: np.random.Generator) -> Point:
    """One coordinate a little elsewhere."""
    k = int(rng.integers(len(x)))
    value, kind = x[k], rng.integers(4)
    if kind == 0:
        value += int(rng.integers(-8, 9)) * math.ulp(value)
    elif kind == 1:
        value *= 1 + 10 ** rng.uniform(-14, -2) * rng.choice([-1, 1])
    elif kind == 2:
        value *= 10 ** rng.uniform(-0.5, 0.5)
    else:  # roundings are largest just above a power of two
        mantissa, exponent = math.frexp(value)
        value = math.ldexp(math.copysign(0.5 + rng.uniform(0, 1e-3), mantissa), exponent) if value else value
    return (*x[:k], float(value), *x[k + 1 :])


def climb(measure: Measure, start: Found, steps: int, rng: np.random.Generator) -> Found:
    """Accept what is worse, `steps` times."""
    best = start
    for _ in range(steps):
        if not math.isfinite(best.error):
            break
        at = neighbour(best.at, rng)
        value = measure(at)
        if value is not None and value[0] > best.error:
            best = Found(*value, at, start.place)
    return best


def worst(measure: Measure, seen: list[Found], restarts: int, steps: int, rng: np.random.Generator) -> list[Found]:
    """The worst points of `seen`, one of a place, climbed from; the worst first."""
    starts: dict[str, Found] = {}
    for found in sorted(seen, key=lambda f: -f.error):
        starts.setdefault(found.place, found)
    climbed = [climb(measure, found, steps, rng) for found in list(starts.values())[:restarts]]
    return sorted(climbed, key=lambda f: -f.error)
