"""What an engineer would look at twice. Takes numbers of a mount or of many in SI units; returns remarks in words.

Nothing is refused for it: these are numbers that are allowed, but that a slip of units makes, as 80 for a rod of 80 mm.
Of many mounts a remark quotes the one that is farthest beyond the limit.
"""

from __future__ import annotations

import math
import sys
import traceback
import warnings
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np

from slowflow.answers.quantities import g

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


def of_mount(sheet: Mapping[str, Any], zeta: Any, mounts: int) -> Iterator[str]:
    """Remarks on the data sheet of an isolator, of which `mounts` equal ones share the masses."""
    names = ("k_v", "k_h", "n", "L", "preload", "friction")
    k_v, k_h, n, L, preload, friction = (np.asarray(sheet[name], dtype=float) for name in names)
    m = np.maximum(sheet["m"], sheet.get("load", 0.0)) / mounts
    with np.errstate(all="ignore"):
        weight, ratio = m * g, np.where(preload > 0, n * k_h / k_v, 1.0)
        preset = weight / k_v
        beyond = {
            "L = {L:g} m is a push-rod as long as a house: is it in mm? Lengths are in m": L / LONGEST,
            "L = {L:g} m is a push-rod of less than 1 mm: lengths are in m": SHORTEST / L,
            "k_v = {k_v:g} N/m is compressed by {preset:.4g} m under {m:g} kg: is it in N/mm, or the mass in g? "
            "Stiffness is in N/m, mass in kg": preset / MOST_PRESET,
            f"k_v = {{k_v:g}} N/m under {{m:g}} kg gives a natural frequency above {HIGHEST:g} Hz: mass is in kg": (
                np.sqrt(k_v / m) / (math.tau * HIGHEST)
            ),
            "k_h = {k_h:g} N/m is negligible compared with k_v = {k_v:g} N/m: is it in N/mm? Stiffness is in N/m": (
                WEAKEST / ratio
            ),
            "k_h = {k_h:g} N/m dominates k_v = {k_v:g} N/m: is it in N/mm? Stiffness is in N/m": ratio / STRONGEST,
            "friction = {friction:g} N is more than the weight, {weight:.4g} N: is it in mN?": friction / weight,
            "zeta = {zeta:.4g} is more than critical damping: is it in per cent? 2 % are 0.02": np.asarray(zeta),
        }
    yield from _remarks(beyond, m=m, k_v=k_v, k_h=k_h, L=L, friction=friction, zeta=zeta, preset=preset, weight=weight)


def of_frequency(f: Any, f_n: Any) -> Iterator[str]:
    """Of frequencies in Hz, and that of the mass on the vertical spring."""
    with np.errstate(all="ignore"):
        ratio = np.asarray(f) / f_n
    sentence = (
        "f = {f:g} Hz is {ratio:.3g} times f_n = {f_n:.4g} Hz, where springs resonate themselves: is it in rpm? "
        "Frequencies are in Hz"
    )
    yield from _remarks({sentence: ratio / FASTEST}, f=f, ratio=ratio, f_n=f_n)


def of_duration(duration: Any, f_n: Any) -> Iterator[str]:
    """Of the durations of half sines, in s."""
    with np.errstate(all="ignore"):
        periods = np.asarray(duration) * f_n
    sentence = "duration = {duration:g} s lasts for {periods:.3g} natural periods: is it in ms? Times are in s"
    yield from _remarks({sentence: periods / SLOWEST}, duration=duration, periods=periods)


def _remarks(beyond: Mapping[str, Any], **numbers: Any) -> Iterator[str]:
    """The sentences whose numbers over their limit exceed 1, with the numbers of the mount where that is largest."""
    for sentence, over in beyond.items():
        implausible = (over > 1) & (over < np.inf)  # infinite ones are no mounts, which have a status
        if implausible.any():
            measure, *values = np.broadcast_arrays(np.where(implausible, over, 0.0), *numbers.values())
            at = np.unravel_index(np.argmax(measure), measure.shape)
            yield sentence.format(**{name: value[at] for name, value in zip(numbers, values, strict=True)})


def warn(remarks: Iterable[str], category: type[Warning] = Implausible) -> None:
    """Each remark as a warning at the line that called the package."""
    for remark in remarks:
        calls = (frame.f_globals.get("__name__", "") for frame, _ in traceback.walk_stack(sys._getframe()))
        inside = [k for k, module in enumerate(calls, start=1) if module.partition(".")[0] == "slowflow"]
        warnings.warn(remark, category, stacklevel=inside[-1] + 1)
