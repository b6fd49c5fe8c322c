"""Results for motions with a mean: equilibria and gradients.

Other results are those of `slowflow.answers.results`, with the mean B and the load in addition.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NoReturn

from slowflow.answers.answer import Table
from slowflow.answers.gradient import Gradient
from slowflow.answers.results import NOT_MEASURED, Remark
from slowflow.answers.sensitivities import point_type
from slowflow.answers.table import QUESTIONS
from slowflow.averaged.isolating import Level
from slowflow.core import validate
from slowflow.core.mechanism import Flags
from slowflow.core.model import Floats, Model
from slowflow.off_centre import sensitivities
from slowflow.off_centre.sensitivities import Design

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
WITHIN = "no gradient is derived for a peak at a turning point of the mean"


@dataclass(frozen=True, eq=False)
class RestPositions(Table, entry="Rest"):
    """Equilibria without forcing and friction, f(u) = load, in ascending order of u; friction also holds the mass
    nearby.

    u      -- displacement
    stiffness -- df/du there over k_v; its square root is the frequency of small motions
    stable -- whether the stiffness is positive
    load   -- the static load over k_v L
    """

    u: Floats
    stiffness: Floats
    stable: Flags
    load: float
    message: str
    remarks: Remark = field(default=Remark(0), kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)

    def measure(self, force: str | None = None) -> NoReturn:
        """Raise Refused: an equilibrium is exact, nothing is averaged."""
        raise validate.NotAvailable(NOT_MEASURED)

    def gradient(self) -> Gradient:
        """Differentiate u and the stiffness of each equilibrium with respect to the parameters and the load.

        The derivatives are exact. Where two equilibria meet, or one lies on a breakpoint of the force, there is no
        gradient;
        `.status` and `.message` say so. Raises Refused if the derivatives of the force with respect to the design
        are not known.
        """
        return sensitivities.of_rest(Design.of(self._model, self.load), self.u)


def gradient(found: Any, question: str) -> Gradient:
    """The exact derivatives of the answer to a question by the parameters, the load and the arguments of the query.

    Raises NotAvailable if the derivatives of the force with respect to the design are not known, and for a peak at a
    turning point of the mean.
    """
    names = NUMBERS[question]
    if question == "peak":
        if found._turns:
            raise validate.NotAvailable(WITHIN)
        if found.Omega != found.Omega_max:  # u_max is that of another motion
            names = names[:-1]
    design, called = Design.of(found._model, found.load), {CALLED.get(name, name): name for name in names}
    point = tuple(getattr(found, called.get(one, one)) for one in ("A", "B", "Omega", "F_0"))
    if question == "isolation" and not found.at_fold:
        return sensitivities.of_isolation(design, point, Level.of(found.level_dB).ratio)
    of = {name: one for one, name in called.items()}
    kinds = point_type(question, point[2], getattr(found, "corner", getattr(found, "kind", None)))
    return sensitivities.gradient(design, kinds, point, of, QUESTIONS[question].takes)
