"""Gradients in SI units: in go a dimensionless one and what its numbers are measured in, out comes that of a mount.

A number of a mount is its dimensionless number times powers of k_v, L and m (4), and so is each number that it moves
with: k_v, L and m move it through all of these.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np

from slowflow.gradient import Gradient
from slowflow.mechanism import Floats
from slowflow_kernels.domains import DAMPING, DISSIPATION
from slowflow_kernels.rod_spring import MECHANISM as ROD_SPRING
from slowflow_kernels.scaling import AMPLITUDES, SCALES
from slowflow_support.errors import Refused
from slowflow_support.record import Scale

#: a mount's words for the letters of the scales of its design and its damping
WORDS = {"lam": "n", "k_h": "k_h", "Delta_h": "preload", "F_c": "friction", "c": "c", "c_q": "c_2"}
#: what all scales are powers of, in their order
BASE = ("k_v", "L", "m")
#: standard gravity, m/s^2
g = 9.80665
#: of a number that is none
PURE = Scale("", 1.0, (0.0, 0.0, 0.0))
#: of a force over a displacement
STIFFNESS = Scale("k", 1.0, (1.0, 0.0, 0.0))
WITHOUT_PRELOAD = "without preload the springs never touch the push-rod: no number of theirs moves an answer"


class Scales(Protocol):
    """What of `quantities.Scales` is asked here."""

    @property
    def damping(self) -> str: ...
    @property
    def excitation(self) -> str: ...
    @property
    def sizes(self) -> Mapping[str, float]: ...
    def of(self, scale: Scale) -> float: ...
    def kind(self, name: str) -> tuple[str, str]: ...


def in_units(found: Gradient, scales: Scales) -> Gradient:
    """The same in SI units, by the numbers of a mount. Raises ValueError where these are not its design's."""
    design = {one.name: scale for one, scale in zip(ROD_SPRING.design, ROD_SPRING.scales, strict=True)}
    damping = {one.name: SCALES[one.name] for one in (*DAMPING, *DISSIPATION)}
    if found.by[: len(design)] != tuple(design):
        raise Refused(WITHOUT_PRELOAD)
    if scales.damping == "zeta":
        damping["zeta"] = PURE
    asked = {"F_0": AMPLITUDES[scales.excitation], "Omega": SCALES["Omega"], "load": SCALES["F_0"]}
    measures = [{**design, **damping, **asked}[name] for name in found.by]
    by = tuple(_word(name, scale, scales) for name, scale in zip(found.by, measures, strict=True))
    of, kinds = zip(*(scales.kind(name) for name in found.of), strict=True)
    answers = [_scale(kind) for kind in kinds]
    # a frequency is in turns, not in radians
    sizes = np.array([scales.sizes[kind] if kind else 1.0 for kind in kinds])
    units = np.array(
        [scales.sizes["frequency"] if name == "f" else scales.of(one) for name, one in zip(by, measures, strict=True)]
    )
    shape = found.status.shape
    values, at = (
        np.stack([np.broadcast_to(np.asarray(one, dtype=float), shape) for one in numbers], axis=-1)
        for numbers in (found._values, found._at)
    )
    base = np.array([getattr(scales, name) for name in BASE])
    own, others = (np.array([one.powers for one in measured]) for measured in (answers, measures))
    moved = (values[..., np.newaxis] * own - (found.slopes * at[..., np.newaxis, :]) @ others) / base
    slopes = np.concatenate((found.slopes / units, moved), axis=-1) * sizes[:, np.newaxis]
    numbers: tuple[Any, ...] = (*np.moveaxis(at * units, -1, 0), *base)
    names = (*by, *BASE)
    if "load" in by:
        slopes, numbers = _by_masses(names, slopes, numbers)
    return Gradient(of, names, slopes, found.status.copy(), tuple(np.moveaxis(values * sizes, -1, 0)), numbers)


def _by_masses(names: tuple[str, ...], slopes: Floats, numbers: tuple[Any, ...]) -> tuple[Floats, tuple[Any, ...]]:
    """Of a mount under a load by its masses: `load` is the one that moves, m what the vertical spring is preset for.

    Up to here `load` is a weight, g (load - m), and m the mass that moves.
    """
    weight, mass = names.index("load"), names.index("m")
    found, given = slopes.copy(), list(numbers)
    found[..., weight] = slopes[..., mass] + g * slopes[..., weight]
    found[..., mass] = -g * slopes[..., weight]
    given[weight], given[mass] = numbers[mass], numbers[mass] - numbers[weight] / g
    return found, tuple(given)


def _word(name: str, scale: Scale, scales: Scales) -> str:
    """What a mount calls a number that an answer moves with."""
    return WORDS.get(scale.letter) or scales.kind(name)[0]


def _scale(kind: str) -> Scale:
    """What numbers of a kind are measured in, but for the turn of a frequency."""
    known: dict[str, Scale] = {"length": SCALES["u"], "frequency": SCALES["Omega"], "angle": PURE, "": PURE}
    known |= {"force": SCALES["F_0"], "unbalance": AMPLITUDES["unbalance"], "stiffness": STIFFNESS}
    return known[kind]
