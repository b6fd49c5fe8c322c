"""How answers move with their parameters: in go answers and what they are, out come their gradients.

By the implicit function theorem, from generated kernels: what a number does to h, m and zeta, and what that does to the
answer. Compiled code where it is, one loop over all answers; elsewhere the same on NumPy.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cache
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow import backend
from slowflow.gradient import Gradient
from slowflow.mechanism import Floats, Mechanism
from slowflow_kernels import inertia, slow_flow
from slowflow_kernels.conventions import CLOSE, COINCIDE, MEETING, SAME, MovesStatus, OnsetKind, Pinned
from slowflow_kernels.domains import DAMPING

Codes = npt.NDArray[np.int8]

#: answers on a breakpoint
ON_BREAK = (
    Pinned.CORNER_FOLD,
    Pinned.CORNER_TOP,
    Pinned.CORNER_END,
    Pinned.CORNER_BACKBONE,
    Pinned.CORNER_REST,
)


class Given(NamedTuple):
    """Whose answers these are: mechanism, the numbers of the design, mu and zeta, or arrays of them, and excitation."""

    mechanism: Mechanism
    numbers: tuple[Any, ...]
    excitation: str

    def with_places(self) -> Given:
        """The same with one more axis behind those of the designs."""
        return self._replace(numbers=tuple(number[..., np.newaxis] for number in self.numbers))


def gradient(
    given: Given,
    kind: Any,
    point: tuple[Any, Any, Any],
    of: Mapping[str, int],
    asked: tuple[str, ...] = (),
) -> Gradient:
    """The gradient of answers.

    given -- whose they are; all arrays here broadcast
    kind  -- what the answers are, numbers of `Pinned`; CORNER_END for any onset on a breakpoint
    point -- A, Omega and forcing of each, None or NaN where there is none
    of    -- the rows of the numbers wanted, by name: 0 for A, 1 Omega, 2 forcing; evenly spaced
    asked -- what was asked at beside the design: "F_0" and "Omega", or less
    """
    A, Omega, F_0 = at = tuple(math.nan if one is None else one for one in point)
    by = (*_names(given.mechanism), *asked)
    slopes, status = _moves(given, kind, (A, Omega, F_0), SIMPLE, len(by))
    rows = tuple(of.values())
    wanted = slopes[..., rows[0] :: -1, :][..., : len(rows), :] if rows[0] else slopes[..., : len(rows), :]
    known = {"F_0": F_0, "Omega": Omega}
    return Gradient(
        tuple(of),
        by,
        wanted,
        status,
        tuple(at[row] for row in rows),
        (*given.numbers, *(known[name] for name in asked)),
    )


#: rows of what `_moves` gives: A, Omega and forcing; phase and transmissibility too
SIMPLE, OF_STATES = 3, 5


@cache
def _names(mechanism: Mechanism) -> tuple[str, ...]:
    """What a user gives."""
    return tuple(one.name for one in (*mechanism.design, *DAMPING))


def _moves(given: Given, kind: Any, at: tuple[Any, Any, Any], rows: int, columns: int) -> tuple[Floats, Codes]:
    """Slopes of shape (..., rows, columns), and their status."""
    A, Omega, F_0 = at
    arrays = (*given.numbers, F_0, Omega, A, kind)
    shape = np.broadcast(*arrays).shape
    slopes, status = np.empty((*shape, rows, columns)), np.empty(shape, np.int8)
    if given.mechanism.by_parameter is None:
        raise ValueError(f"{given.mechanism.name} does not say how its average changes: there are no gradients")
    record = backend.record_of(given.mechanism) if given.excitation == "force" else None
    if backend.SOLVER is not None and record is not None:
        # an array without axes would come back as a number
        backend.SOLVER.many_gradients(record)(*arrays, out=(slopes, status))
    else:
        with np.errstate(all="ignore"):
            broadcast = np.broadcast_arrays(*(np.asarray(one, dtype=float) for one in arrays))
            kernels = slow_flow if given.excitation == "force" else inertia
            _on_numpy(given.mechanism, kernels, broadcast, slopes, status)
    return slopes, status


def _on_numpy(
    mechanism: Mechanism, kernels: ModuleType, arrays: Sequence[Floats], slopes: Floats, status: Codes
) -> None:
    """`sf_gradient` of gradient.h, kind by kind."""
    kinds = arrays[-1]
    for kind in np.unique(kinds):
        here = kinds == kind
        chosen = [array[here] for array in arrays]
        slopes[here], status[here] = _of_kind(mechanism, kernels, Pinned(int(kind)), chosen, slopes.shape[-2:])


def _of_kind(
    mechanism: Mechanism, kernels: ModuleType, kind: Pinned, arrays: list[Floats], inner: tuple[int, ...]
) -> tuple[Floats, Codes]:
    """Slopes of shape (n, rows, parameters), and their status; for flat arrays."""
    *given, F_0, Omega, A, _ = arrays
    *design, mu, zeta = given
    rows, columns = inner
    m = np.asarray(slow_flow.friction(mu))
    status = np.full(A.shape, MovesStatus.OK, np.int8)
    parameters = [np.broadcast_to(value, A.shape) for value in mechanism.coefficients(*design)]
    ends, jumps = (
        np.array([np.broadcast_to(value, A.shape) for value in function(*parameters)]).reshape(-1, A.size)
        for function in (mechanism.breakpoints, mechanism.jumps)
    )
    there = (A > 0) & (A < np.inf) & (Omega >= 0) & (Omega < np.inf) & (F_0 >= 0) & (F_0 < np.inf)
    piece = np.zeros(A.shape, int)
    if kind in ON_BREAK:
        there &= (ends > 0).any(axis=0)
        if len(ends):
            piece = np.abs(np.where(ends > 0, ends, np.inf) - A).argmin(axis=0)
            A = ends[piece, np.arange(A.size)]
    else:
        first = kind in (Pinned.STATE, Pinned.PEAK)
        comes = (ends > 0) & (np.abs(A - ends) <= (SAME if first else COINCIDE) * ends)
        if first:
            comes &= jumps != 0
        status[comes.any(axis=0)] = MovesStatus.TURNS
    h, h_A, h_AA, h_AAA = mechanism.averaged(A, *parameters)
    beside = [np.asarray(value) for value in kernels.beside(Omega, A, F_0, m, zeta, h, h_A)]
    if kind >= Pinned.CUSP:  # those before are at a forcing
        force = F_0 if kernels is slow_flow else inertia.force(Omega, F_0)
        status[_vanishes(force, beside[5], MEETING)] = MovesStatus.BOUNDLESS
    if kind is Pinned.CORNER_FOLD:
        turns = _vanishes(beside[0], beside[1], CLOSE) | _vanishes(beside[4], beside[5], CLOSE)
        status[turns] = MovesStatus.TURNS
    kinds = np.full(A.shape, kind)
    if kind is Pinned.CORNER_END:
        nearness = [np.abs(value) / size for value, size in zip(beside[::2], beside[1::2], strict=True)]
        which = np.array([Pinned.CORNER_END, Pinned.CORNER_TOP, Pinned.CORNER_BACKBONE])
        kinds = which[np.argmin(nearness, axis=0)]
    assert mechanism.by_parameter is not None
    assert mechanism.by_design is not None
    by_parameter = _stacked(mechanism.by_parameter(A, h, h_A, h_AA, *parameters), A).reshape(len(parameters), 3, A.size)
    by_design = _stacked(mechanism.by_design(*design), A).reshape(-1, len(design), A.size)
    # along the parameters, then the answers
    cause = np.zeros((8, columns, A.size))
    n = len(design)
    cause[:3, :n] = np.einsum("pin,pdn->idn", by_parameter, by_design[: len(parameters)])
    if len(ends):
        cause[5, :n] = by_design[len(parameters) :][piece, :, np.arange(A.size)].T
    cause[3, n] = slow_flow.friction(1.0)
    cause[4, n + 1] = 1.0
    for k in range(n + 2, columns):
        cause[k + 4 - n, k] = 1.0
    out = np.full((A.size, rows, columns), np.nan)
    for one in np.unique(kinds):
        function = getattr(kernels, f"moves_of_{Pinned(one).name.lower()}")
        at = (Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA)
        found = [np.broadcast_to(value, (columns, A.size)) for value in function(*at, *cause)]
        if rows > 3:
            found[3:3] = kernels.moves_of_phase(
                Omega, A, F_0, m, zeta, h, h_A, cause[0], cause[3], cause[4], *found[:3]
            )
        here = kinds == one
        out[here] = np.moveaxis(np.array(found[:rows]), -1, 0)[here]
        meets = _vanishes(found[-4][0], found[-3][0], MEETING) | _vanishes(found[-2][0], found[-1][0], MEETING)
        status[here & meets & (status == MovesStatus.OK)] = MovesStatus.MEETS
    status[~np.isfinite(out).all(axis=(1, 2)) & (status == MovesStatus.OK)] = MovesStatus.BOUNDLESS
    status[~there] = MovesStatus.NOTHING
    out[status != MovesStatus.OK] = np.nan
    return out, status


def _vanishes(value: Any, size: Any, share: float) -> Any:
    """Whether a value has lost its sign to rounding, as far as a share of its size says."""
    return ~(np.abs(value) > share * size)


def _stacked(values: Sequence[Any], like: Floats) -> Floats:
    return np.array([np.broadcast_to(value, like.shape) for value in values])


# ---- the answers


def of_states(given: Given, Omega: Any, A: Any, F_0: Any, phi: Any, transmissibility: Any) -> Gradient:
    """Of steady states at a forcing and a frequency."""
    by = (*_names(given.mechanism), "F_0", "Omega")
    slopes, status = _moves(given, float(Pinned.STATE), (A, Omega, F_0), OF_STATES, len(by))
    values, at = (A, phi, transmissibility), (*given.numbers, F_0, Omega)
    return Gradient(("A", "phi", "transmissibility"), by, slopes[..., (0, 3, 4), :], status, values, at)


def of_folds(given: Given, Omega: Any, A: Any, F_0: Any, corner: Any) -> Gradient:
    """Of folds at a forcing."""
    kind = _either(corner, Pinned.CORNER_FOLD, Pinned.FOLD)
    return gradient(given, kind, (A, Omega, F_0), {"Omega": 1, "A": 0}, ("F_0",))


def of_peak(given: Given, A: Any, Omega: Any, F_0: Any) -> Gradient:
    """Of the highest peak; one at rest stays there."""
    kind = _either(Omega == 0, Pinned.STATE, Pinned.PEAK)
    return gradient(given, kind, (A, Omega, F_0), {"A": 0, "Omega": 1}, ("F_0",))


def of_detachment(given: Given, F_cr: Any, Omega_cr: Any, u_cr: Any) -> Gradient:
    """Of the lowest forcing that reaches u_cr; one at rest stays there."""
    kind = _either(Omega_cr == 0, Pinned.CORNER_REST, Pinned.CORNER_TOP)
    return gradient(given, kind, (u_cr, Omega_cr, F_cr), {"F_cr": 2, "Omega_cr": 1, "u_cr": 0})


def of_onset(given: Given, F_SN: Any, Omega: Any, A: Any, kind: Any) -> Gradient:
    """Of the lowest forcing that has a fold; kind a number of `OnsetKind`."""
    pinned = _ONSETS[kind]
    return gradient(given, pinned, (A, Omega, F_SN), {"F_SN": 2, "Omega": 1, "A": 0})


#: what an onset is, by the number of its kind; of the first there is none
_PINNED = {OnsetKind.CUSP: Pinned.CUSP, OnsetKind.ISOLA: Pinned.ISOLA, OnsetKind.CORNER: Pinned.CORNER_END}
_ONSETS = np.array([float(_PINNED.get(kind, Pinned.CUSP)) for kind in OnsetKind])


def of_cusps(given: Given, F_0: Any, Omega: Any, A: Any) -> Gradient:
    """Of cusps of the fold locus."""
    return gradient(given, float(Pinned.CUSP), (A, Omega, F_0), _EXTREMA)


def of_isola_points(given: Given, F_0: Any, Omega: Any, A: Any) -> Gradient:
    """Of its isola points."""
    return gradient(given, float(Pinned.ISOLA), (A, Omega, F_0), _EXTREMA)


_EXTREMA = {"F_0": 2, "Omega": 1, "A": 0}


def _either(flag: Any, one: Pinned, other: Pinned) -> Any:
    """One where the flag holds, else the other."""
    return np.where(flag, float(one), float(other)) if isinstance(flag, np.ndarray) else float(one if flag else other)
