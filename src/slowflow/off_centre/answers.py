"""What is off the centre of an answer: places of rest, and how numbers with a mean displacement B move.

The answers are those of `slowflow.results`, with B and the load.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, ClassVar, NoReturn

import numpy as np
import numpy.typing as npt

from slowflow import validate
from slowflow.answer import Table, entry
from slowflow.gradient import Gradient
from slowflow.loads import Isolation, Level
from slowflow.model import Floats, Model
from slowflow.off_centre import moves
from slowflow.off_centre.moves import Given
from slowflow.results import NOT_MEASURED, Detachment, Peak, Remark, SaddleNodeOnset, SaddleNodes, SteadyStates
from slowflow_kernels.conventions import Pinned

WITHIN = "no gradient is derived where the mean turns back at the peak"


Rest = entry("Rest", "u stiffness stable", "A place of rest, as in `RestPositions`.")


@dataclass(frozen=True, eq=False)
class RestPositions(Table):
    """Where the mass stands without forcing and friction, f(u) = load, by rising u; friction holds it near by too.

    u      -- displacement
    stiffness -- df/du there over k_v: its square root is the frequency of small motions about it
    stable -- where that is positive
    load   -- the static load over k_v L
    """

    entry: ClassVar[Any] = Rest

    u: Floats
    stiffness: Floats
    stable: npt.NDArray[np.bool_]
    load: float
    message: str
    remarks: Remark = field(default=Remark(0), kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)

    def measure(self) -> NoReturn:
        """Raises NotAvailable: a place of rest is one of the equation of motion itself."""
        raise validate.NotAvailable(NOT_MEASURED)

    def gradient(self) -> Gradient:
        """How u and the stiffness of each place move with the parameters and the load, exactly.

        Where two places meet, and where one is a breakpoint of the force, there is none, and `.status` and `.message`
        say so. Raises NotAvailable where it is not known how the force moves with the design.
        """
        return moves.of_rest(Given.of(self._model, self.load), self.u)


# ---- how the numbers of answers move with the parameters, the load, and what was asked at, exactly; each raises
# NotAvailable where it is not known how the force moves with the design


def states_move(found: SteadyStates) -> Gradient:
    """A, B, phi and transmissibility of each state, by F_0 and Omega too."""
    of = {name: name for name in ("A", "B", "phi", "transmissibility")}
    return _moved(found, Pinned.STATE, (found.Omega, found.F_0), of, ("F_0", "Omega"))


def folds_move(found: SaddleNodes) -> Gradient:
    """Omega, A and B of each fold, by F_0 too; on a corner that a jump of the force makes there is none."""
    kinds = np.where(found.corner, int(Pinned.CORNER_FOLD), int(Pinned.FOLD))
    return _moved(found, kinds, (found.Omega, found.F_0), {name: name for name in ("Omega", "A", "B")}, ("F_0",))


def detachment_moves(found: Detachment) -> Gradient:
    """F_cr, Omega_cr, A and B; one at rest stays there."""
    kind = Pinned.CORNER_REST if found.Omega_cr == 0 else Pinned.CORNER_TOP
    of = {"F_cr": "F_0", "Omega_cr": "Omega", "A": "A", "B": "B"}
    return _moved(found, kind, (found.Omega_cr, found.F_cr), of, first=True)


def peak_moves(found: Peak) -> Gradient:
    """A, B and Omega, by F_0 too, and u_max if it is that motion's; a peak at Omega = 0 stays there."""
    if found._turns:
        raise validate.NotAvailable(WITHIN)
    kind = Pinned.STATE if found.Omega == 0 else Pinned.PEAK
    named = ("A", "B", "Omega", *(["u_max"] if found.Omega == found.Omega_max else []))
    return _moved(found, kind, (found.Omega, found.F_0), {name: name for name in named}, ("F_0",))


def onset_moves(found: SaddleNodeOnset) -> Gradient:
    """F_SN, Omega, A and B; nothing where more than two folds are born together, or on a jump of the force."""
    kinds = {"cusp": Pinned.CUSP, "isola": Pinned.ISOLA}
    of = {"F_SN": "F_0", "Omega": "Omega", "A": "A", "B": "B"}
    return _moved(found, kinds.get(found.kind, Pinned.CORNER_END), (found.Omega, found.F_SN), of)


def isolation_moves(found: Isolation) -> Gradient:
    """Omega, A and B, by F_0 too."""
    if found.at_fold:
        of = {name: name for name in ("Omega", "A", "B")}
        return _moved(found, Pinned.FOLD, (found.Omega, found.F_0), of, ("F_0",))
    assert found.load is not None
    point = found.A, found.B, found.Omega, found.F_0
    return moves.of_isolation(Given.of(found._model, found.load), point, Level.of(found.level_dB).ratio)


def _moved(
    found: Any,
    kind: Any,
    at: tuple[Any, Any],
    of: dict[str, str],
    asked: tuple[str, ...] = (),
    first: bool = False,
) -> Gradient:
    """The gradient of an answer at (Omega, F_0), of the first piece of the force alone where it comes to its end."""
    given = Given.of(found._model, found.load)
    return moves.gradient(given.first() if first else given, kind, (found.A, found.B, *at), of, asked)
