"""Validity: measured errors of averaging for similar results.

The errors were measured for the paper's isolator (docs/validity.md). For a spring model for which nothing was measured,
the message states this.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow.answers import validity_table as measured
from slowflow.answers.answer import Answer, Single, Table, joined
from slowflow.core.mechanism import Flags, Ints
from slowflow.core.model import THROUGHOUT, Floats, Model
from slowflow.support.text import Sentence, text
from slowflow_kernels import motion, slow_flow

#: from this size on an error is worth a remark
WORTH = 0.02
WORTH_TRUNCATION = 0.005

NOT_MEASURED = (
    "not measured: the error of averaging is known for the paper's isolator under a force only (docs/validity.md); "
    ".measure() computes it"
)
NOT_MEASURED_LAWS = (
    "not measured: the error of averaging is known for viscous damping and dry friction only (docs/validity.md); "
    ".measure() computes it"
)
NOT_MEASURED_OFF_CENTRE = (
    "not measured: the error of averaging is known for motions about the centre only (docs/validity.md); "
    "measure() of states and folds computes it"
)
NEAR_STICKING = Sentence("{mu}/{F_0} = {ratio:.3g} is near pi/4, where averaging fails: amplitudes ")
NEAR_STICKING_ATTACHED = Sentence(
    "{mu}/{F_0} = {ratio:.3g} is {where:s} pi/4: friction acts only while the springs are attached, and there "
    "averaging fails: amplitudes "
)
#: and where that stands in Python
IN_PYTHON = ", .validity has the error of each"
OFF_BY = f"were measured to be off by up to {{:.0%}}{IN_PYTHON}"
OFF_UNKNOWN = "are wrong by an amount that was not measured for this mechanism"
STOPPING = "{mu/(A Omega^2)|friction/(m A omega^2)} >= {rest:g}"
STOPS_SECOND = Sentence(
    f"in {{some:d}} of {{all:d}} states the mass stops within the cycle, or nearly so ({STOPPING}): their amplitudes "
)
STOPS_WITHIN = Sentence(
    f"the mass stops within the cycle, or nearly so, in {{some:d}} of {{all:d}} states ({STOPPING}): {{sizes:s}}"
)
TRUNCATED = Sentence("the truncated force (6) is off by {truncation:.1%} at {A = :.3g}; force='untruncated' has none")
OFF_SECOND = "were measured to be off by up to {:.0%}"
#: edges of the bins of mu/(A Omega^2), errors of the second approximation there, and the edge from which on to say so
_STOPPING, _SECOND = np.array(measured.STOPPING), np.array(measured.SECOND_BY_REST)
_SECOND_FROM = next(edge for edge, size in zip(_STOPPING.tolist(), _SECOND.tolist(), strict=True) if size >= WORTH)

CORNER = text(
    "a fold sits on the corner at {u_cr}, where the truncated force (6) jumps: it and its neighbour are due "
    "to the truncation, force='untruncated' has neither"
)


@dataclass(frozen=True, eq=False)
class Validity(Answer):
    """Known errors of averaged states; arrays with one entry for each state.

    ratio      -- mu/F_0
    rest       -- mu/(A Omega^2), friction over inertia force at the turning points: from about 1 on the mass stops
            there
    typical    -- median of the relative errors of A that were measured for points with similar `ratio` and `rest`; each
            is the smallest error within 1 % of the point's frequency
    error      -- 95th percentile of these errors; next to a jump that averaging misplaces it is the height of the jump
    truncation -- the part of `error` due to the truncated force (6), from the nearest measured case; 0 if not measured
    message    -- diagnostics as text; empty if there are none

    `typical`, `error` and `truncation` are nan for a mechanism that was not measured.
    """

    ratio: Floats
    rest: Floats
    typical: Floats
    error: Floats
    truncation: Floats
    message: str

    def __str__(self) -> str:
        return self.message or "no known limitation"


@dataclass(frozen=True, eq=False)
class Measured(Table, entry="MeasuredState"):
    """Motions of the equation of motion (3), found from averaged states: arrays with one entry for each state.

    Omega, A -- frequency, and largest |u| of the motion
    error    -- relative error of the averaged amplitude
    stable, stops -- whether the motion is stable; its stops in one period
    found    -- whether such a motion was found; otherwise A and error are nan
    reason   -- why none was found
    message  -- for how many states none was found, and why; empty if one was found for each
    """

    Omega: Floats
    A: Floats
    error: Floats
    stable: Flags
    stops: Ints
    found: Flags
    reason: npt.NDArray[np.str_]
    message: str


@dataclass(frozen=True, eq=False)
class MeasuredFolds(Table, entry="MeasuredFold"):
    """Folds of the equation of motion (3), found from averaged ones: arrays with one entry for each fold.

    Omega, A   -- frequency and amplitude of the exact fold
    error      -- relative error of the averaged frequency
    error_of_A -- relative error of the averaged amplitude
    found      -- whether such a fold was found; otherwise the other columns are nan
    reason     -- why none was found
    message    -- for how many folds none was found, and why; empty if one was found for each
    """

    Omega: Floats
    A: Floats
    error: Floats
    error_of_A: Floats
    found: Flags
    reason: npt.NDArray[np.str_]
    message: str


@dataclass(frozen=True, eq=False)
class MeasuredPoint(Single):
    """The peak, onset, detachment or isolation of the equation of motion (3), found from the averaged one.

    The numbers are None if none was found.

    F_0, Omega, A -- forcing, frequency, and largest |u| of the motion
    error    -- relative error of the averaged result: A of a peak, F_SN of an onset, F_cr of a detachment, Omega of
            isolation
    error_of_Omega -- relative error of the averaged frequency
    message  -- why none was found; empty otherwise
    """

    F_0: float | None
    Omega: float | None
    A: float | None
    error: float | None
    error_of_Omega: float | None
    message: str


def of_states(model: Model, Omega: Floats, A: Floats, *, corner: bool = False) -> Validity:
    """The validity of averaged steady states of the model; `corner` marks folds on a breakpoint."""
    h = model.averaged(A)[0]
    F_0 = slow_flow.level(Omega, A, *model.equivalent_damping(Omega, A), h)
    with np.errstate(divide="ignore", invalid="ignore"):  # at Omega = 0
        ratio, rest = model.mu / F_0, np.where(model.mu > 0, motion.stopping(Omega, A, model.mu), 0.0)
    if not is_measured(model):
        unknown = np.full(np.shape(A), np.nan)
        truncation = unknown if model.mechanism.truncated else np.zeros_like(unknown)
        return Validity(
            ratio, rest, unknown, unknown, truncation, NOT_MEASURED_LAWS if model.laws.any else NOT_MEASURED
        )
    chosen = _bin(measured.RATIOS, ratio), _bin(measured.STOPPING, rest)
    # a mass that friction holds is not averaged: its state is exact
    typical, error = (np.where(A > 0, np.array(sizes)[chosen], 0.0) for sizes in (measured.TYPICAL, measured.ERROR))
    truncation = _truncation(model, A)
    remarks: list[str] = []
    stopping = (rest >= measured.STOPS_FROM) & (A > 0)
    if stopping.any():
        remarks.append(
            STOPS_WITHIN.format(
                np.count_nonzero(stopping), A.size, measured.STOPS_FROM, _sizes(typical[stopping], error[stopping])
            )
        )
    moving = ~stopping & (typical >= WORTH)
    if moving.any():
        remarks.append(
            f"friction is large in {np.count_nonzero(moving)} of {A.size} states: "
            f"{_sizes(typical[moving], error[moving])}"
        )
    if A.size and truncation.max() >= WORTH_TRUNCATION:
        at = int(truncation.argmax())
        remarks.append(TRUNCATED.format(truncation[at], A[at]))
    if corner and model.mechanism.truncated:
        remarks.append(CORNER)
    return Validity(ratio, rest, typical, error, truncation, joined(*remarks))


def off_centre(mu: float, F_0: Any, Omega: Any, A: Any) -> Validity:
    """The validity of averaged offset motions: nothing was measured for these. None if there is no motion."""
    arrays = [np.asarray([] if A is None else value, dtype=float).ravel() for value in (F_0, Omega, A)]
    F_0, Omega, A = np.broadcast_arrays(*arrays)
    with np.errstate(divide="ignore", invalid="ignore"):  # at Omega = 0
        ratio, rest = mu / F_0, np.where(mu > 0, motion.stopping(Omega, A, mu), 0.0)
    unknown = np.full(A.shape, np.nan)
    return Validity(ratio, rest, unknown, unknown, unknown, NOT_MEASURED_OFF_CENTRE)


def near_sticking(model: Model, F_0: float) -> str:
    """The message for a forcing that barely exceeds friction."""
    ratio = model.mu / F_0
    off = OFF_BY.format(measured.BY_RATIO[int(_bin(measured.RATIOS, np.array(ratio)))])
    if model.laws.contact != THROUGHOUT:
        return NEAR_STICKING_ATTACHED.format(ratio, "near" if ratio <= math.pi / 4 else "above") + OFF_UNKNOWN
    return NEAR_STICKING.format(ratio) + (off if is_measured(model) else OFF_UNKNOWN)


def of_second(model: Model, Omega: Floats, A: Floats) -> str:
    """The message for states of the second approximation in which the mass stops; empty if there are none."""
    if model.mu == 0:
        return ""
    with np.errstate(divide="ignore"):
        rest = motion.stopping(Omega, A, model.mu)
    above = rest[~(rest < _SECOND_FROM)]
    off = _SECOND[_STOPPING.searchsorted(above, side="right") - 1]  # none lies below the first edge
    stopping = off >= WORTH
    if not stopping.any():
        return ""
    size = OFF_SECOND.format(off.max()) if is_measured(model) else OFF_UNKNOWN
    return STOPS_SECOND.format(np.count_nonzero(stopping), A.size, _SECOND_FROM) + size


def _bin(edges: tuple[float, ...], values: Floats) -> np.ndarray:
    """Number of the bin that begins at the last edge not above each value."""
    return np.clip(np.searchsorted(edges, values, side="right") - 1, 0, len(edges) - 1)


def is_measured(model: Model) -> bool:
    """Whether errors of averaging were measured for such oscillators, when their motions are about the centre."""
    mechanism = model.mechanism
    return not (model.laws.any or model.inertial) and mechanism.is_generated and mechanism.name in measured.MECHANISMS


def _truncation(model: Model, A: Floats) -> Floats:
    """The measured difference that (6) makes, between the cases measured over u_cr and A/u_cr."""
    if not model.mechanism.truncated:
        return np.zeros_like(A)
    u_cr = float(model.mechanism.breakpoints(*model.parameters)[0])
    if u_cr == 0:
        return np.zeros_like(A)
    # preloads beyond those measured get the error of the last
    column = [np.interp(u_cr, measured.U_CRS, sizes) for sizes in zip(*measured.TRUNCATION, strict=True)]
    return np.asarray(np.interp(A / u_cr, (0.0, *measured.LEVELS), (0.0, *column)))


def _sizes(typical: Floats, error: Floats) -> str:
    return f"amplitudes typically off by {typical.max():.0%}, 95th percentile {error.max():.0%}"
