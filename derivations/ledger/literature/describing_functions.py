"""Describing functions: what a nonlinearity answers to a sine of amplitude A, by its first harmonic, over A."""

from typing import Any


def ideal_relay(M: Any, A: Any, *, xp: Any) -> Any:
    """relay: relay without hysteresis. Output M with the sign of the input."""
    return 4 * M / (xp.pi * A)


def dead_zone(delta: Any, A: Any, *, xp: Any) -> Any:
    """dead zone: dead zone. A >= delta: no output up to delta, slope 1 beyond."""
    return 1 - 2 / xp.pi * (xp.arcsin(delta / A) + delta / A * xp.sqrt(1 - (delta / A) ** 2))


def saturation(k: Any, a: Any, A: Any, *, xp: Any) -> Any:
    """saturation: saturation. A >= a/k: slope k up to the output a, no more beyond."""
    limit = a / (k * A)
    return 2 * k / xp.pi * (xp.arcsin(limit) + limit * xp.sqrt(1 - limit**2))


TITLE = "Dead zone, saturation and relay: describing functions"
CITATION = (
    "A. Gelb, W. E. Vander Velde, Multiple-Input Describing Functions and Nonlinear System Design (McGraw-Hill, 1968); "
    "J.-J. E. Slotine, W. Li, Applied Nonlinear Control (Prentice Hall, 1991), ch. 5"
)
READ_IN = (
    "A C program, Describing function analysis for nonlinear systems, which has the formulas and cites both books."
)
