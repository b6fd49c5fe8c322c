"""How answers move with their parameters. Takes answers and what they are; returns their gradients.

By the implicit function theorem, compiled (native/gradient.h): what a number does to h and to what dissipates, and what
that does to the answer, in one loop over all answers.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow.answers.gradient import Gradient
from slowflow.core import backend, validate
from slowflow.core.mechanism import Floats, Mechanism
from slowflow.core.model import THROUGHOUT, Model
from slowflow.support.errors import Refused
from slowflow_kernels.conventions import MEETING, GradientStatus, OnsetKind, PointType
from slowflow_kernels.domains import DAMPING, DISSIPATION

Codes = npt.NDArray[np.int8]

NOT_AVERAGED = "only averaged answers of an oscillator with design parameters have gradients"
OF_FUNCTIONS = (
    "gradient() is not available for {}: its force is defined by Python functions, whose derivatives with respect to "
    "the parameters are unknown; SymPy expressions have gradients"
)
OF_RECORD = (
    "gradient() is not available for {}: its record has no derivatives of its average with respect to the parameters"
)


class Design(NamedTuple):
    """Whose answers these are: mechanism, numbers of the design and the damping, or arrays of them, and excitation.

    contact -- where dry friction acts, if there are other laws of damping: numbers then end with those of `DISSIPATION`
    """

    mechanism: Mechanism
    numbers: tuple[Any, ...]
    excitation: str
    contact: str | None = None

    @classmethod
    def of(cls, model: Model | None) -> Design:
        """The design of an answer's oscillator. Raises ValueError where it is not known."""
        if model is None or not model.has_design:
            raise Refused(NOT_AVERAGED)
        laws, numbers = model.laws, (*model.design, model.mu, model.zeta)
        if not laws.any:
            return cls(model.mechanism, numbers, model.excitation)
        return cls(model.mechanism, (*numbers, *laws.numbers.values()), model.excitation, laws.contact)

    def with_places(self) -> Design:
        """The same with one more axis behind those of the designs."""
        return self._replace(numbers=tuple(number[..., np.newaxis] for number in self.numbers))


def gradient(
    design: Design, kind: Any, point: tuple[Any, Any, Any], of: Mapping[str, int], arguments: tuple[str, ...] = ()
) -> Gradient:
    """The gradient of answers.

    design    -- whose they are; all arrays here broadcast
    kind      -- what the answers are, numbers of `PointType`; CORNER_END for any onset on a breakpoint
    point     -- A, Omega and forcing of each, None or NaN where there is none
    of        -- the rows of the numbers, by name: 0 for A, 1 Omega, 2 forcing; evenly spaced
    arguments -- of the query: "F_0" and "Omega", or less
    """
    A, Omega, F_0 = at = tuple(math.nan if one is None else one for one in point)
    by = (*_names(design.mechanism, design.contact is not None), *arguments)
    slopes, status = _slopes(design, kind, (A, Omega, F_0), SIMPLE, len(by))
    rows = tuple(of.values())
    selected = slopes[..., rows[0] :: -1, :][..., : len(rows), :] if rows[0] else slopes[..., : len(rows), :]
    known = {"F_0": F_0, "Omega": Omega}
    return Gradient(
        tuple(of),
        by,
        selected,
        status,
        tuple(at[row] for row in rows),
        (*design.numbers, *(known[name] for name in arguments)),
    )


#: rows of what `_moves` gives: A, Omega and forcing; A, phase and transmissibility, then Omega and forcing
SIMPLE, OF_STATES = 3, 5


@cache
def _names(mechanism: Mechanism, laws: bool) -> tuple[str, ...]:
    """What a user gives, with other laws of damping or without."""
    return tuple(one.name for one in (*mechanism.design, *DAMPING, *(DISSIPATION if laws else ())))


def _slopes(design: Design, kind: Any, at: tuple[Any, Any, Any], rows: int, columns: int) -> tuple[Floats, Codes]:
    """Slopes of shape (..., rows, columns), and their status."""
    A, Omega, F_0 = at
    # compiled code asks where friction acts too
    ends = () if design.contact is None else (float(design.contact != THROUGHOUT),)
    arrays = (*design.numbers, *ends, F_0, Omega, A, kind, float(design.excitation != "force"))
    shape = np.broadcast(*arrays).shape
    slopes, status = np.empty((*shape, rows, columns)), np.empty(shape, np.int8)
    record = backend.record_of(design.mechanism, laws=design.contact is not None)
    if design.mechanism.by_parameter is None or record is None:
        raise validate.NotAvailable(
            (OF_FUNCTIONS if design.mechanism.told else OF_RECORD).format(design.mechanism.name)
        )
    # an array without axes would come back as a number
    backend.SOLVER.many_gradients(record)(*arrays, out=(slopes, status))
    return slopes, status


def vanishes(value: Any, size: Any, fraction: float) -> Any:
    """Whether a value has lost its sign to rounding, relative to a fraction of its size."""
    return ~(np.abs(value) > fraction * size)


# ---- the answers


def of_states(design: Design, Omega: Any, A: Any, F_0: Any, phi: Any, transmissibility: Any) -> Gradient:
    """Of steady states at a forcing and a frequency."""
    by = (*_names(design.mechanism, design.contact is not None), "F_0", "Omega")
    values, at = (A, phi, transmissibility), (*design.numbers, F_0, Omega)
    slopes, status = _of_places(design, (A, Omega, F_0), len(values), len(by))
    if (sticks := np.broadcast_to(np.asarray(A) == 0, status.shape)).any():  # friction holds it there as well nearby
        slopes, status = np.array(slopes), np.array(status)
        slopes[sticks], status[sticks] = 0.0, GradientStatus.OK
    return Gradient(("A", "phi", "transmissibility"), by, slopes, status, values, at)


def _of_places(design: Design, at: tuple[Any, Any, Any], rows: int, columns: int) -> tuple[Floats, Codes]:
    """The first rows of `_slopes` of states, computed where there is one: a batch's places are mostly empty."""
    there = np.isfinite(at[0])
    state = float(PointType.STATE)
    if there.all():
        slopes, status = _slopes(design, state, at, OF_STATES, columns)
        return slopes[..., :rows, :], status
    arrays = np.broadcast_arrays(there, *design.numbers, *at)
    there, *numbers = arrays[: len(arrays) - len(at)]
    chosen = design._replace(numbers=tuple(number[there] for number in numbers))
    A, Omega, F_0 = (one[there] for one in arrays[-len(at) :])
    slopes, status = (
        np.full((*there.shape, rows, columns), np.nan),
        np.full(there.shape, GradientStatus.NOTHING, np.int8),
    )
    found, status[there] = _slopes(chosen, state, (A, Omega, F_0), OF_STATES, columns)
    slopes[there] = found[..., :rows, :]
    return slopes, status


#: of points, by question: the rows of their numbers
NUMBERS: Mapping[str, Mapping[str, int]] = {
    "saddle_nodes": {"Omega": 1, "A": 0},
    "peak": {"A": 0, "Omega": 1},
    "detachment": {"F_cr": 2, "Omega_cr": 1, "u_cr": 0},
    "saddle_node_onset": {"F_SN": 2, "Omega": 1, "A": 0},
    **{question: {"F_0": 2, "Omega": 1, "A": 0} for question in ("cusps", "isola_points")},
}
#: what they are: of an onset by the number of its kind, of the first of which there is none; of others the second is
#: that of a fold on a corner, and of a peak and a detachment at rest, which stay there
_KINDS: Mapping[str, tuple[PointType, ...]] = {
    "amplitudes": (PointType.STATE,),
    "saddle_nodes": (PointType.FOLD, PointType.CORNER_FOLD),
    "peak": (PointType.PEAK, PointType.STATE),
    "detachment": (PointType.CORNER_TOP, PointType.CORNER_REST),
    "saddle_node_onset": (PointType.CUSP, PointType.CUSP, PointType.ISOLA, PointType.CORNER_END),
    "isolation": (PointType.FOLD,),
    "cusps": (PointType.CUSP,),
    "isola_points": (PointType.ISOLA,),
}


def point_type(question: str, Omega: Any, what: Any) -> Any:
    """The `PointType` of results: `what` is whether folds are on a corner, the kind of an onset, or its number."""
    kinds = np.array(_KINDS[question], dtype=float)
    if isinstance(what, str):
        what = OnsetKind[what.upper() or "NO"]
    return kinds[np.asarray((Omega == 0) & (kinds.size > 1) if what is None else what, dtype=int)]


def of_points(design: Design, question: str, Omega: Any, A: Any, F_0: Any, what: Any = None) -> Gradient:
    """The gradient of the results of a question; `what` as in `point_type`."""
    kind, by = point_type(question, Omega, what), ("F_0",) if question in ("saddle_nodes", "peak") else ()
    return gradient(design, kind, (A, Omega, F_0), NUMBERS[question], by)


def of_isolation(design: Design, Omega: Any, A: Any, F_0: Any, at_fold: Any, ratio: Any) -> Gradient:
    """Of where isolation begins: of the state that transmits that share of what drives it, or of a fold."""
    shape = np.broadcast(*design.numbers, Omega, A, F_0).shape
    Omega, A, on_fold = (np.broadcast_to(np.asarray(one), shape) for one in (_known(Omega), _known(A), at_fold))
    folds = of_points(design, "saddle_nodes", Omega, np.where(on_fold, A, np.nan), F_0, np.zeros(shape, bool))
    by = (*folds.by, "Omega")
    slopes, status = _slopes(
        design, float(PointType.STATE), (np.where(on_fold, np.nan, A), Omega, F_0), OF_STATES, len(by)
    )
    kept, status = along_frequency(slopes[..., 0:3:2, :], status, Omega, A, ratio)
    slopes = np.where(on_fold[..., np.newaxis, np.newaxis], folds.slopes, kept)
    status = np.where(on_fold, folds.status, status).astype(np.int8)
    return Gradient(("Omega", "A"), folds.by, slopes, status, (Omega, A), (*design.numbers, F_0))


def of_answer(model: Model | None, question: str, *numbers: Any) -> Gradient:
    """The gradient of a single answer to a question."""
    of: Any = {"amplitudes": of_states, "isolation": of_isolation}.get(question)
    design = Design.of(model)
    return of(design, *numbers) if of else of_points(design, question, *numbers)


def _known(value: Any) -> Any:
    return np.nan if value is None else value


def along_frequency(slopes: Floats, status: Any, Omega: Floats, A: Floats, ratio: Any) -> tuple[Floats, Any]:
    """How states move that keep what they transmit, as their frequency moves; `GradientStatus.MEETS` where none does.

    slopes -- of A first, of what is transmitted last, by all numbers, Omega the last: (..., rows, columns)
    ratio  -- what is transmitted

    Out come those of Omega, then of the rows but the last, by all numbers but Omega; and the status.
    """
    fixed, by_Omega = slopes[..., :-1], slopes[..., -1]
    with np.errstate(all="ignore"):
        # its terms are as large as its frequency and its amplitude may change it relatively
        size = ratio * (1 + np.abs(Omega / A * by_Omega[..., 0])) / Omega
        meets = vanishes(by_Omega[..., -1], size, MEETING)
        Omega_p = -fixed[..., -1:, :] / by_Omega[..., -1:, np.newaxis]
        found = np.concatenate((Omega_p, fixed[..., :-1, :] + by_Omega[..., :-1, np.newaxis] * Omega_p), axis=-2)
    status = np.where(meets & (status == GradientStatus.OK), np.int8(GradientStatus.MEETS), status)
    found[status != GradientStatus.OK] = np.nan
    return found, status
