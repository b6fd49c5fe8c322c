"""Shock spectra: in go half sines of the base, and an oscillator or many, out come deflections and accelerations."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow import validate
from slowflow.answer import Table
from slowflow.averaged.many import Batch, Codes, Designs
from slowflow.exact.transient import half_sine, transient
from slowflow.mechanism import EquationOfMotion, Floats, Force
from slowflow.model import Model
from slowflow_kernels.conventions import Status

Flags = npt.NDArray[np.bool_]


class Shock(NamedTuple):
    """One pulse of a `ShockSpectrum`."""

    acceleration: float
    duration: float
    A: float
    a_max: float
    ratio: float
    detaches: bool


@dataclass(frozen=True, eq=False)
class ShockSpectrum(Table):
    """What half sines of the base do, pulse by pulse.

    acceleration, duration -- of the pulse, over k_v L/m and in tau
    A        -- the largest deflection of the springs, during the pulse or later
    a_max    -- the largest acceleration of the mass; ratio -- this over the pulse's
    detaches -- whether the springs leave
    """

    entry: ClassVar[Any] = Shock

    acceleration: Floats
    duration: Floats
    A: Floats
    a_max: Floats
    ratio: Floats
    detaches: Flags
    picture: ClassVar[str] = "shocks"

    def plot(self, ax: Any = None) -> Any:
        """Draw the ratio over the duration into Matplotlib axes, or new ones, and return these."""
        from slowflow import pictures

        return pictures.shocks(ax, self)


@dataclass(frozen=True, eq=False)
class Shocks(Batch):
    """What a half sine of the base does to each design: the columns of `ShockSpectrum`; detaches is 0 or 1."""

    A: Floats
    a_max: Floats
    ratio: Floats
    detaches: Codes
    status: Codes


def shock_spectrum(system: EquationOfMotion, acceleration: Floats, duration: Floats) -> ShockSpectrum:
    """Pulse by pulse; shapes (n,)."""
    rows = [_one(system, *pulse) for pulse in zip(acceleration.tolist(), duration.tolist(), strict=True)]
    A, a_max, ratio, detaches = np.array(rows, dtype=float).reshape(-1, 4).T
    return ShockSpectrum(acceleration, duration, A, a_max, ratio, detaches.astype(np.bool_))


def _one(system: EquationOfMotion, acceleration: float, duration: float) -> tuple[float, float, float, bool]:
    found = transient(system, half_sine(acceleration, duration), after=0.0)
    return found.A, found.a_max, found.a_max / acceleration, found.detaches


def of_designs(designs: Designs, acceleration: Any, duration: Any) -> Shocks:
    """See `slowflow.oscillator.Designs.shock_spectrum`."""
    pulse = {"acceleration": acceleration, "duration": duration}
    given = {**designs.values, **{name: validate.real_array(name, value) for name, value in pulse.items()}}
    shape = validate.common_shape(given)
    columns = [np.broadcast_to(value, shape).ravel().tolist() for value in given.values()]
    found = np.array([_of_design(designs, *one) for one in zip(*columns, strict=True)], dtype=float).reshape(*shape, 5)
    A, a_max, ratio, detaches, status = np.moveaxis(found, -1, 0)
    codes = (detaches.astype(np.int8), status.astype(np.int8))
    return Shocks(A.copy(), a_max.copy(), ratio.copy(), *codes, _designs=designs)


def _of_design(designs: Designs, *values: float) -> tuple[Any, ...]:
    """A row of `Shocks`, with the status of a failure in place of an exception."""
    *own, acceleration, duration = values
    blank = (np.nan, np.nan, np.nan, False)
    try:
        validate.number("acceleration", acceleration, above=0.0)
        validate.number("duration", duration, above=0.0)
        model = Model.of(designs.mechanism, dict(zip(designs.values, own, strict=True)))
        system = EquationOfMotion(Force.of(designs.mechanism, model.parameters), model.mu, model.zeta)
    except ValueError:
        return (*blank, Status.INVALID)
    try:
        return (*_one(system, acceleration, duration), Status.OK)
    except ArithmeticError:
        return (*blank, Status.UNRESOLVED)
