"""What is off the centre of an answer: places of rest, and how numbers with a mean displacement B move.

The answers are those of `slowflow.results`, with B and the load.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, NoReturn

import numpy as np
import numpy.typing as npt

from slowflow import validate
from slowflow.answer import Table, entry
from slowflow.gradient import Gradient
from slowflow.isolating import Level
from slowflow.loads import Isolation
from slowflow.model import Floats, Model
from slowflow.off_centre import moves
from slowflow.off_centre.moves import Given
from slowflow.results import NOT_MEASURED, Detachment, Peak, Remark, SaddleNodeOnset, SaddleNodes, SteadyStates
from slowflow_kernels.conventions import Pinned

#: the numbers of an answer that move with the parameters, by question
NUMBERS: Mapping[str, tuple[str, ...]] = {
    "rest": ("u", "stiffness"),
    "detachment": ("F_cr", "Omega_cr", "A", "B"),
    "saddle_node_onset": ("F_SN", "Omega", "A", "B"),
    "saddle_nodes": ("Omega", "A", "B"),
    "amplitudes": ("A", "B", "phi", "transmissibility"),
    "peak": ("A", "B", "Omega", "u_max"),
    "isolation": ("Omega", "A", "B"),
}
#: what some of them are elsewhere
CALLED = {"F_cr": "F_0", "F_SN": "F_0", "Omega_cr": "Omega"}
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
    return _moved(found, Pinned.STATE, NUMBERS["amplitudes"], ("F_0", "Omega"))


def folds_move(found: SaddleNodes) -> Gradient:
    """Omega, A and B of each fold, by F_0 too; on a corner that a jump of the force makes there is none."""
    kinds = np.where(found.corner, int(Pinned.CORNER_FOLD), int(Pinned.FOLD))
    return _moved(found, kinds, NUMBERS["saddle_nodes"], ("F_0",))


def detachment_moves(found: Detachment) -> Gradient:
    """F_cr, Omega_cr, A and B; one at rest stays there."""
    kind = Pinned.CORNER_REST if found.Omega_cr == 0 else Pinned.CORNER_TOP
    return _moved(found, kind, NUMBERS["detachment"], first=True)


def peak_moves(found: Peak) -> Gradient:
    """A, B and Omega, by F_0 too, and u_max if it is that motion's; a peak at Omega = 0 stays there."""
    if found._turns:
        raise validate.NotAvailable(WITHIN)
    names = NUMBERS["peak"] if found.Omega == found.Omega_max else NUMBERS["peak"][:-1]
    return _moved(found, Pinned.STATE if found.Omega == 0 else Pinned.PEAK, names, ("F_0",))


def onset_moves(found: SaddleNodeOnset) -> Gradient:
    """F_SN, Omega, A and B; nothing where more than two folds are born together, or on a jump of the force."""
    kinds = {"cusp": Pinned.CUSP, "isola": Pinned.ISOLA}
    return _moved(found, kinds.get(found.kind, Pinned.CORNER_END), NUMBERS["saddle_node_onset"])


def isolation_moves(found: Isolation) -> Gradient:
    """Omega, A and B, by F_0 too."""
    if found.at_fold:
        return _moved(found, Pinned.FOLD, NUMBERS["isolation"], ("F_0",))
    assert found.load is not None
    point = found.A, found.B, found.Omega, found.F_0
    return moves.of_isolation(Given.of(found._model, found.load), point, Level.of(found.level_dB).ratio)


def _moved(found: Any, kind: Any, names: tuple[str, ...], asked: tuple[str, ...] = (), first: bool = False) -> Gradient:
    """The gradient of an answer's numbers, of the first piece of the force alone where it comes to its end."""
    given, called = Given.of(found._model, found.load), {CALLED.get(name, name): name for name in names}
    point = tuple(getattr(found, called.get(one, one)) for one in ("A", "B", "Omega", "F_0"))
    of = {name: one for one, name in called.items()}
    return moves.gradient(given.first() if first else given, kind, point, of, asked)
