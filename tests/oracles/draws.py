"""Oscillators, forcings and batches for counts at hard places: a seeded generator in, numbers out.

Isolators come with the usual numbers, next to delta_h = 1, at quasi-zero stiffness to the ulp, over many decades;
forcings lie next to those at which numbers of folds change, from an ulp on.
"""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow import Duffing, Isolator

Floats = npt.NDArray[np.float64]


def oscillator(kind: type, *numbers: float, zeta: float, mu: float) -> Any:
    """One of them, without the warning of negative stiffness."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        if kind is Duffing:
            return Duffing(*numbers, mu, zeta)
        return Isolator(**dict(zip(("lam", "r", "delta_h"), numbers, strict=True)), mu=mu, zeta=zeta)


def drawn_isolators(rng: np.random.Generator, count: int) -> tuple[Floats, ...]:
    """lam, r, delta_h, mu, zeta: usual ones, next to delta_h = 1 and quasi-zero stiffness, over many decades."""
    lam, r, delta_h = (
        rng.integers(1, 5, count).astype(float),
        10 ** rng.uniform(-2, 1.5, count),
        10 ** rng.uniform(-3, -0.02, count),
    )
    mu, zeta = 10 ** rng.uniform(-5, -1, count), 10 ** rng.uniform(-4, -0.3, count)
    kind = rng.integers(0, 10, count)
    delta_h = np.where(kind == 0, 1 - 10 ** rng.uniform(-12, -0.3, count), delta_h)
    delta_h = np.where(kind == 1, 10 ** rng.uniform(-9, 0, count), delta_h)
    r = np.where(
        kind == 2, (1 + rng.choice([-1, 0, 1], count) * 10 ** rng.uniform(-16, -1, count)) / (lam * delta_h), r
    )
    zeta = np.where(kind == 3, 10 ** rng.uniform(-9, 0, count), zeta)
    return lam, r, delta_h, np.where(kind == 4, 0.0, mu), zeta


def drawn_springs(rng: np.random.Generator, count: int) -> tuple[Floats, ...]:
    """alpha, beta, mu, zeta."""
    mu, zeta = 10 ** rng.uniform(-9, -1, count), 10 ** rng.uniform(-6, -0.3, count)
    return rng.uniform(-1, 3, count), rng.uniform(-1, 2, count), np.where(rng.random(count) < 0.1, 0.0, mu), zeta


def forcings(rng: np.random.Generator, designs: Any, mu: Floats) -> Floats:
    """Next to F_SN and F_cr from an ulp on, next to 4 mu/pi, and anywhere above that."""
    count = mu.size
    anywhere = np.where(mu > 0, 4 * mu / np.pi * (1 + 10 ** rng.uniform(-2, 3, count)), 10 ** rng.uniform(-4, 1, count))
    level = np.where(rng.random(count) < 0.5, designs.saddle_node_onset().F_SN, designs.detachment().F_cr)
    level = np.where(rng.random(count) < 0.1, 4 * mu / np.pi, level)
    near = level * (1 + rng.choice([-1, 1], count) * 10 ** rng.uniform(-16.3, -1, count))
    return np.where((rng.random(count) < 0.6) & (near > 4 * mu / np.pi), near, anywhere)


def batch(kind: Any, numbers: Any) -> Any:
    """All of them."""
    names = ("lam", "r", "delta_h", "mu", "zeta") if kind is Isolator else ("alpha", "beta", "mu", "zeta")
    return kind.many(**dict(zip(names, numbers, strict=True)))
