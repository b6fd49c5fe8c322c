"""Results of the second approximation.

They have the attributes of averaged results, and the amplitude A_1 of the first harmonic.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt

from slowflow.answers.answer import Drawn, Table, frozen
from slowflow.answers.results import DRAWN, InDecibels
from slowflow.answers.transmissibility import Transmitted, in_motion, validated
from slowflow.core.mechanism import Flags, Ints
from slowflow.core.model import Floats, Model
from slowflow_kernels import motion

#: why averaging's answers have these, and those of the second approximation have not
NOT_OF_SECOND = {
    "validity": "it has no table of errors; docs/validity.md has the measured ones",
    "measure": "the averaged answer has it, and steady_state gives the exact motion",
    "gradient": "its derivatives are not available; the averaged answer has them",
}


class SecondTable(Table):
    """Common part of answers of the second approximation: reasons for attributes that only averaged answers have."""

    def __getattr__(self, name: str) -> Any:
        """Raise AttributeError, with the reason if averaged answers have the attribute."""
        why = f": {NOT_OF_SECOND[name]}" if name in NOT_OF_SECOND else ""
        raise AttributeError(f"an answer of the second approximation has no {name}{why}")


@dataclass(frozen=True, eq=False)
class SecondStates(InDecibels, SecondTable, entry="SecondState", columns="Omega A A_1 phi stable"):
    """Steady states in the second approximation, one entry each: flat arrays of one length.

    Omega, A -- frequency, and largest displacement; A = 0 where friction holds the mass at rest
    A_1, phi -- amplitude of the first harmonic, and its phase in radians, in [-pi, 0]
    stable   -- True where the steady state is stable
    message  -- diagnostics as text; empty if there are none
    F_0      -- the forcing, a number; an array with the forcing of each state if there were several
    force    -- amplitude of the force on the mass in each state
    """

    extra_columns: ClassVar[tuple[str, ...]] = ("transmissibility_dB",)

    Omega: Floats
    A: Floats
    A_1: Floats
    phi: Floats
    stable: Flags
    message: str
    F_0: float | Floats = field(kw_only=True)
    force: Floats = field(kw_only=True, repr=False)
    _model: Model = field(kw_only=True, repr=False)
    #: whether the message says that some are left out which averaging has
    _lost: bool = field(default=False, kw_only=True, repr=False)

    @property
    def transmissibility(self) -> Floats:
        """First harmonic of the force of spring, damper and friction over `.force`."""
        with np.errstate(divide="ignore", invalid="ignore"):  # of a mass at rest on a base that hardly shakes
            passed = motion.transmissibility(self.Omega, self.A_1, self.force, self.phi)
        return frozen(in_motion(self.A, passed))

    def transmitted(self, of: str = "force") -> Transmitted:
        """Transmissibility of the waveform: first harmonic, peak, root mean square.

        of -- "force", "relative" or "absolute", as for exact motions, see `slowflow.exact.SteadyState.transmitted`

        The motion has harmonics 3 and 5 of the spring and all harmonics of friction; `first` is `transmissibility`, or
        A_1 over F_0. It takes about 0.1 ms per state. Raises ValueError for another `of`, and for "absolute" under a
        force.
        """
        from slowflow.second.wave import Waves

        validated(of, inertial=self._model.inertial)
        F_0 = np.broadcast_to(np.asarray(self.F_0, dtype=float), self.Omega.shape)
        return Waves(self._model, self.Omega, self.A, self.phi, F_0).transmitted(of)


@dataclass(frozen=True, eq=False)
class SecondResponse(Drawn, SecondStates, entry="SecondCurvePoint", columns="Omega A A_1 phi stable branch"):
    """A response curve in the second approximation: points in order along each branch.

    branch, isola, F_0 -- as in `FrequencyResponse`
    """

    F_0: float = field(kw_only=True)
    branch: Ints
    isola: tuple[bool, ...]
    picture: ClassVar[str] = "response"

    @property
    def can_draw(self) -> tuple[str, ...]:
        """Quantities that `plot` may draw over Omega."""
        return ("A_1", *DRAWN)


@dataclass(frozen=True, eq=False)
class SecondFolds(Drawn, SecondTable, entry="SecondFold"):
    """Folds of the response curve in the second approximation, sorted by Omega: arrays of one length.

    Omega, A, A_1 -- as in `SecondStates`; kind and corner as in `SaddleNodes`
    """

    Omega: Floats
    A: Floats
    A_1: Floats
    kind: npt.NDArray[np.str_]
    corner: Flags
    F_0: float
    message: str
    #: folds that the message says are left out
    _lost: int = field(default=0, kw_only=True, repr=False)
    picture: ClassVar[str] = "folds"
