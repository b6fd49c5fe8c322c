"""How far averaged answers are from the equation of motion: in go amplitudes and frequencies, out come sizes, words.

The sizes were measured on exact motions of the paper's isolator, see docs/validity.md; `validity_table` holds them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from slowflow.measured import table as measured
from slowflow.model import Floats, Model

#: from this size on an error is worth a remark
WORTH = 0.02
WORTH_TRUNCATION = 0.005

NEAR_STICKING = (
    "mu/F_0 = {0:.3g} is near pi/4, where averaging fails: amplitudes were measured to be off by up to {1:.0%}, "
    ".validity tells it for each"
)
STOPS_SECOND = (
    "in {} of {} states the mass stops within the cycle, or nearly so (mu/(A Omega^2) >= {:g}): their amplitudes were "
    "measured to be off by up to {:.0%}"
)

CORNER = (
    "a fold sits on the corner at u_cr, where the truncated force (6) jumps: it and its partner beside it are of the "
    "truncation's making, force='untruncated' has neither"
)


@dataclass(frozen=True)
class Validity:
    """What is known of the error of averaged states; arrays with one entry for each state.

    ratio      -- mu/F_0
    rest       -- mu/(A Omega^2), friction over the force of inertia where the mass turns: from about 1 on it rests
    typical    -- relative error of A within which half of the points measured with such `ratio` and `rest` had the
                  exact amplitude, at a frequency within 1 %
    error      -- the same for 95 of 100; beside a jump that averaging misplaces it is the height of the jump.
                  Figures below 1 % say no more than that the exact curve passes within that 1 %
    truncation -- the share of it that comes from the truncated force (6), nearest measured case; 0 where none was made
    message    -- remarks in words; empty if there is nothing to say
    """

    ratio: Floats
    rest: Floats
    typical: Floats
    error: Floats
    truncation: Floats
    message: str

    def __str__(self) -> str:
        return self.message or "nothing known against it"


def of_states(model: Model, Omega: Floats, A: Floats, *, corner: bool = False) -> Validity:
    """The validity of averaged steady states of that model; `corner` tells that a fold on a breakpoint is there."""
    h = model.averaged(A)[0]
    F_0 = np.hypot(model.flow.R(Omega, A, h), model.flow.I(Omega, A, model.m, model.zeta))
    with np.errstate(divide="ignore"):
        ratio, rest = model.mu / F_0, np.where(model.mu > 0, model.mu / (A * Omega**2), 0.0)
    chosen = _bin(measured.RATIOS, ratio), _bin(measured.RESTS, rest)
    typical, error = (np.array(sizes)[chosen] for sizes in (measured.TYPICAL, measured.ERROR))
    truncation = _truncation(model, A)
    remarks = []
    stopping = rest >= measured.STOPS_FROM
    if stopping.any():
        remarks.append(
            f"the mass stops within the cycle, or nearly so, in {np.count_nonzero(stopping)} of {A.size} states "
            f"(mu/(A Omega^2) >= {measured.STOPS_FROM:g}): {_sizes(typical[stopping], error[stopping])}"
        )
    moving = ~stopping & (typical >= WORTH)
    if moving.any():
        remarks.append(
            f"friction is large in {np.count_nonzero(moving)} of {A.size} states: "
            f"{_sizes(typical[moving], error[moving])}"
        )
    if A.size and truncation.max() >= WORTH_TRUNCATION:
        at = int(truncation.argmax())
        remarks.append(
            f"the truncated force (6) is off by {truncation[at]:.1%} at A = {A[at]:.3g}; force='untruncated' has none"
        )
    if corner and _is_truncated(model):
        remarks.append(CORNER)
    return Validity(ratio, rest, typical, error, truncation, "; ".join(remarks))


def near_sticking(mu: float, F_0: float) -> str:
    """The remark for a forcing that does not exceed friction by much; empty for others."""
    if not mu > measured.NEAR * F_0:
        return ""
    ratio = mu / F_0
    return NEAR_STICKING.format(ratio, measured.BY_RATIO[int(_bin(measured.RATIOS, np.array(ratio)))])


def of_second(mu: float, Omega: Floats, A: Floats) -> str:
    """The remark for states of the second approximation in which the mass stops; empty if there are none."""
    with np.errstate(divide="ignore"):
        rest = mu / (A * Omega**2)
    off = np.array(measured.SECOND_BY_REST)[_bin(measured.RESTS, rest)]
    stopping = off >= WORTH
    if not stopping.any():
        return ""
    least = next(edge for edge, size in zip(measured.RESTS, measured.SECOND_BY_REST, strict=True) if size >= WORTH)
    return STOPS_SECOND.format(np.count_nonzero(stopping), A.size, least, off.max())


def _bin(edges: tuple[float, ...], values: Floats) -> np.ndarray:
    """Number of the bin that begins at the last edge not above each value."""
    return np.clip(np.searchsorted(edges, values, side="right") - 1, 0, len(edges) - 1)


def _is_truncated(model: Model) -> bool:
    return model.kernels.__name__.rpartition(".")[2] in measured.TRUNCATED


def _truncation(model: Model, A: Floats) -> Floats:
    """The measured difference that (6) makes, between the cases measured over u_cr and A/u_cr."""
    if not _is_truncated(model):
        return np.zeros_like(A)
    u_cr = float(model.parameters[model.kernels.PARAMETERS.index("u_cr")])
    if u_cr == 0:
        return np.zeros_like(A)
    # preloads beyond those measured get the error of the last
    column = [np.interp(u_cr, measured.U_CRS, sizes) for sizes in zip(*measured.TRUNCATION, strict=True)]
    return np.asarray(np.interp(A / u_cr, (0.0, *measured.LEVELS), (0.0, *column)))


def _sizes(typical: Floats, error: Floats) -> str:
    return f"amplitudes typically off by {typical.max():.0%}, at worst by {error.max():.0%}"
