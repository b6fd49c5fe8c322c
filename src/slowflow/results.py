"""What the questions are answered with: plain records of arrays; where there is no answer, `message` says why."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow.measured.validity import Validity, of_states
from slowflow.model import Floats, Model


@dataclass(frozen=True)
class SteadyStates:
    """Steady states, one entry each: flat arrays of one length.

    Omega, A -- frequency and amplitude, dimensionless
    stable   -- True where both eigenvalues of the Jacobian (28) have a negative real part
    message  -- remarks in words; empty if there is nothing to say
    """

    Omega: Floats
    A: Floats
    stable: npt.NDArray[np.bool_]
    message: str
    _model: Model = field(repr=False)

    @cached_property
    def phi(self) -> Floats:
        """Phase of u = A cos(Omega tau + phi) in radians, in [-pi, 0] (25); computed when first asked for."""
        h = self._model.averaged(self.A)[0]
        phase = self._model.flow.phase(self.Omega, self.A, self._model.m, self._model.zeta, h)
        return np.asarray(phase) + 0 * self.A

    @cached_property
    def validity(self) -> Validity:
        """How far each state may be from the equation of motion, by measurement; looked up when first asked for."""
        return of_states(self._model, self.Omega, self.A)


@dataclass(frozen=True)
class FrequencyResponse(SteadyStates):
    """A response curve: points in order along each branch.

    branch -- number of the connected curve that a point lies on, from 0; isolated curves come last
    isola  -- for each branch, whether it is closed
    F_0    -- the forcing
    """

    branch: npt.NDArray[np.intp]
    isola: tuple[bool, ...]
    F_0: float


@dataclass(frozen=True)
class SaddleNodes:
    """Folds of the response curve at one forcing, by rising Omega: arrays of one length.

    kind   -- "jump-up": a sweep leaves the fold for a larger amplitude; "jump-down": for a smaller one
    corner -- True where the fold sits on a breakpoint of the force
    """

    Omega: Floats
    A: Floats
    kind: npt.NDArray[np.str_]
    corner: npt.NDArray[np.bool_]
    F_0: float
    message: str
    _model: Model = field(repr=False)

    def __len__(self) -> int:
        return self.A.size

    @cached_property
    def validity(self) -> Validity:
        """How far each fold may be from the equation of motion, by measurement; looked up when first asked for."""
        return of_states(self._model, self.Omega, self.A, corner=bool(self.corner.any()))


@dataclass(frozen=True)
class SecondStates:
    """Steady states in the second approximation, one entry each: flat arrays of one length.

    Omega, A -- frequency, and largest displacement
    A_1, phi -- amplitude of the first harmonic, and its phase in radians, in [-pi, 0]
    stable   -- True where the steady state is stable
    message  -- remarks in words; empty if there is nothing to say
    """

    Omega: Floats
    A: Floats
    A_1: Floats
    phi: Floats
    stable: npt.NDArray[np.bool_]
    message: str


@dataclass(frozen=True)
class SecondResponse(SecondStates):
    """A response curve in the second approximation: points in order along each branch.

    branch, isola, F_0 -- as in `FrequencyResponse`
    """

    branch: npt.NDArray[np.intp]
    isola: tuple[bool, ...]
    F_0: float


@dataclass(frozen=True)
class SecondFolds:
    """Folds of the response curve in the second approximation, by rising Omega: arrays of one length.

    Omega, A, A_1 -- as in `SecondStates`; kind and corner as in `SaddleNodes`
    """

    Omega: Floats
    A: Floats
    A_1: Floats
    kind: npt.NDArray[np.str_]
    corner: npt.NDArray[np.bool_]
    F_0: float
    message: str

    def __len__(self) -> int:
        return self.A.size


@dataclass(frozen=True)
class SaddleNodeOnset:
    """The lowest forcing that has a fold; None and a message where there is none.

    kind -- "cusp" (the response gets a vertical inflection), "isola" (an isolated curve is born), "corner" (at a
            breakpoint)
    """

    F_SN: float | None
    Omega: float | None
    A: float | None
    kind: str
    message: str


@dataclass(frozen=True)
class FoldLocus:
    """The saddle nodes of every forcing: points in order along each branch, in arrays of one length.

    Omega, A, F_0 -- a fold and the forcing that has it
    branch        -- number of the connected branch that a point lies on, from 0; breakpoints separate branches
    """

    Omega: Floats
    A: Floats
    F_0: Floats
    branch: npt.NDArray[np.intp]
    message: str

    def __len__(self) -> int:
        return self.A.size


@dataclass(frozen=True)
class Cusps:
    """Cusps of the fold locus, F = F_A = F_AA = 0, by rising amplitude: arrays of one length.

    minimum -- True where two folds come into being as the forcing rises; False where two meet and vanish
    """

    F_0: Floats
    Omega: Floats
    A: Floats
    minimum: npt.NDArray[np.bool_]
    message: str

    def __len__(self) -> int:
        return self.A.size


@dataclass(frozen=True)
class IsolaPoints:
    """Points with F = F_A = F_Omega = 0, by rising amplitude: arrays of one length.

    kind -- what happens there as the forcing rises: an isolated curve's "birth", its "death", or a "merger" of two
            parts of the response curve (or their separation)
    """

    F_0: Floats
    Omega: Floats
    A: Floats
    kind: npt.NDArray[np.str_]
    message: str

    def __len__(self) -> int:
        return self.A.size


@dataclass(frozen=True)
class Peak:
    """The highest peak of the response at one forcing, isolas included; None and a message where there is none."""

    A: float | None
    Omega: float | None
    F_0: float
    message: str


@dataclass(frozen=True)
class Detachment:
    """The lowest forcing that reaches u_cr, its frequency, and u_cr; None and a message where there is no u_cr."""

    F_cr: float | None
    Omega_cr: float | None
    u_cr: float | None
    message: str


def joined(*remarks: Any) -> str:
    """Remarks joined into one message."""
    return "; ".join(str(remark) for remark in remarks if remark)
