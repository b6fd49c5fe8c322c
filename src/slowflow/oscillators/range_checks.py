"""What an engineer would look at twice. Takes numbers of a mount in SI units; returns remarks in words.

Nothing is refused for it: these are numbers that are allowed, but that a slip of units makes, as 80 for a rod of 80 mm.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterable, Iterator

#: a push-rod as long as a house is none, nor one thinner than a sheet of metal
LONGEST, SHORTEST = 5.0, 1e-3
#: by how much a vertical spring is compressed at most, in m: at 0.25 Hz; and a natural frequency that no mount has
MOST_PRESET, HIGHEST = 4.0, 1000.0
#: shares of the horizontal springs in the stiffness beyond which one of the two would be negligible
WEAKEST, STRONGEST = 0.01, 100.0
#: frequencies over the natural one at which springs vibrate by themselves, and a half sine that lasts for many turns
FASTEST, SLOWEST = 100.0, 20.0


class Implausible(UserWarning):
    """A number that is allowed, and looks as if it were in another unit."""


def of_mount(
    *, m: float, k_v: float, k_h: float, n: float, L: float, preload: float, friction: float, zeta: float, g: float
) -> Iterator[str]:
    """Remarks on a data sheet; m is the larger of the masses that it names, g standard gravity."""
    if L > LONGEST:
        yield f"L = {L:g} m is a push-rod as long as a house: is it in mm? Lengths are in m"
    elif L < SHORTEST:
        yield f"L = {L:g} m is a push-rod of less than 1 mm: lengths are in m"
    if (preset := m * g / k_v) > MOST_PRESET:
        yield (
            f"k_v = {k_v:g} N/m is compressed by {preset:.4g} m under {m:g} kg: is it in N/mm, or the mass in g? "
            "Stiffness is in N/m, mass in kg"
        )
    elif (k_v / m) ** 0.5 > math.tau * HIGHEST:
        yield f"k_v = {k_v:g} N/m under {m:g} kg gives a natural frequency above {HIGHEST:g} Hz: mass is in kg"
    ratio = n * k_h / k_v
    if preload > 0 and ratio < WEAKEST:
        yield f"k_h = {k_h:g} N/m is negligible compared with k_v = {k_v:g} N/m: is it in N/mm? Stiffness is in N/m"
    elif preload > 0 and ratio > STRONGEST:
        yield f"k_h = {k_h:g} N/m dominates k_v = {k_v:g} N/m: is it in N/mm? Stiffness is in N/m"
    if friction > m * g:
        yield f"friction = {friction:g} N is more than the weight, {m * g:.4g} N: is it in mN?"
    if zeta > 1:
        yield f"zeta = {zeta:.4g} is more than critical damping: is it in per cent? 2 % are 0.02"


def of_frequency(highest: float, f_n: float) -> Iterator[str]:
    """Of the highest frequency asked for, in Hz, and that of the mass on the vertical spring."""
    if highest > FASTEST * f_n:
        yield (
            f"f = {highest:g} Hz is {highest / f_n:.3g} times f_n = {f_n:.4g} Hz, where springs resonate themselves: "
            "is it in rpm? Frequencies are in Hz"
        )


def of_duration(longest: float, f_n: float) -> Iterator[str]:
    """Of the longest half sine, in s."""
    if longest * f_n > SLOWEST:
        yield f"duration = {longest:g} s lasts for {longest * f_n:.3g} natural periods: is it in ms? Times are in s"


def warn(remarks: Iterable[str], stacklevel: int) -> None:
    """Each remark as a warning at the caller, so many calls up."""
    for remark in remarks:
        warnings.warn(remark, Implausible, stacklevel=stacklevel + 1)
