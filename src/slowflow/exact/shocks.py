"""Shock spectra: in go half sines of the base and an equation of motion, out come deflections and accelerations."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt

from slowflow.answer import Drawn, Table, entry
from slowflow.exact.transient import half_sine, transient
from slowflow.mechanism import EquationOfMotion, Floats

Flags = npt.NDArray[np.bool_]


Shock = entry("Shock", "acceleration duration A a_max ratio detaches", "One pulse of a `ShockSpectrum`.")


@dataclass(frozen=True, eq=False)
class ShockSpectrum(Drawn, Table):
    """What half sines of the base do, pulse by pulse.

    acceleration, duration -- of the pulse, over k_v L/m and in tau
    A        -- the largest deflection of the springs, during the pulse or later, under a load with that at rest
    a_max    -- the largest acceleration of the mass; ratio -- this over the pulse's
    detaches -- whether the springs leave
    message  -- what to bear in mind
    """

    entry: ClassVar[Any] = Shock

    acceleration: Floats
    duration: Floats
    A: Floats
    a_max: Floats
    ratio: Floats
    detaches: Flags
    message: str
    picture: ClassVar[str] = "shocks"


def shock_spectrum(system: EquationOfMotion, acceleration: Floats, duration: Floats, at: float = 0.0) -> ShockSpectrum:
    """Pulse by pulse, from rest at u = `at`; shapes (n,)."""
    found = [transient(system, arcs, after=0.0, at=at) for arcs in half_sine(acceleration, duration)]
    A, a_max, detaches = (np.array([getattr(one, name) for one in found]) for name in ("A", "a_max", "detaches"))
    return ShockSpectrum(acceleration, duration, A, a_max, a_max / acceleration, detaches.astype(np.bool_), "")
