"""How answers move with their parameters: in go answers and what they are, out come their gradients.

By the implicit function theorem, from generated kernels: what a number does to h, m and zeta, and what that does to the
answer. Compiled code where it is, one loop over all answers; elsewhere the same on NumPy.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow import backend, validate
from slowflow.gradient import Gradient
from slowflow.mechanism import Floats, Mechanism
from slowflow.model import THROUGHOUT, at_rest
from slowflow_kernels import dissipation, dissipation_by_inertia, inertia, slow_flow
from slowflow_kernels.conventions import CLOSE, COINCIDE, MEETING, SAME, MovesStatus, OnsetKind, Pinned
from slowflow_kernels.domains import DAMPING, DISSIPATION

Codes = npt.NDArray[np.int8]

OF_FUNCTIONS = (
    "gradient() is not available for {}: its force is stated by Python functions, which are known by their values, not "
    "by how these move with the parameters; stated by SymPy expressions it has gradients"
)
OF_RECORD = "gradient() is not available for {}: its record does not say how its average moves with the parameters"

#: answers on a breakpoint
ON_BREAK = (
    Pinned.CORNER_FOLD,
    Pinned.CORNER_TOP,
    Pinned.CORNER_END,
    Pinned.CORNER_BACKBONE,
    Pinned.CORNER_REST,
)


#: by whether there are other laws of damping, and whether inertia excites
KERNELS: dict[tuple[bool, bool], Any] = {
    (False, False): slow_flow,
    (False, True): inertia,
    (True, False): dissipation,
    (True, True): dissipation_by_inertia,
}


class Given(NamedTuple):
    """Whose answers these are: mechanism, numbers of the design and the damping, or arrays of them, and excitation.

    rubs -- where dry friction acts, if there are other laws of damping: the numbers then end with eta and c_2
    """

    mechanism: Mechanism
    numbers: tuple[Any, ...]
    excitation: str
    rubs: str | None = None

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
    by = (*_names(given.mechanism, given.rubs is not None), *asked)
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


#: rows of what `_moves` gives: A, Omega and forcing; A, phase and transmissibility, then Omega and forcing
SIMPLE, OF_STATES = 3, 5


@cache
def _names(mechanism: Mechanism, laws: bool) -> tuple[str, ...]:
    """What a user gives, with other laws of damping or without."""
    return tuple(one.name for one in (*mechanism.design, *DAMPING, *(DISSIPATION if laws else ())))


def _moves(given: Given, kind: Any, at: tuple[Any, Any, Any], rows: int, columns: int) -> tuple[Floats, Codes]:
    """Slopes of shape (..., rows, columns), and their status."""
    A, Omega, F_0 = at
    arrays = (*given.numbers, F_0, Omega, A, kind)
    shape = np.broadcast(*arrays).shape
    slopes, status = np.empty((*shape, rows, columns)), np.empty(shape, np.int8)
    if given.mechanism.by_parameter is None:
        raise validate.NotAvailable((OF_FUNCTIONS if given.mechanism.told else OF_RECORD).format(given.mechanism.name))
    record = backend.record_of(given.mechanism) if given.rubs is None else None
    if backend.SOLVER is not None and record is not None:
        forced = given.excitation == "force"
        asked = backend.SOLVER.many_gradients if forced else backend.SOLVER.many_inertial_gradients
        # an array without axes would come back as a number
        asked(record)(*arrays, out=(slopes, status))
    else:
        with np.errstate(all="ignore"):
            broadcast = np.broadcast_arrays(*(np.asarray(one, dtype=float) for one in arrays))
            _on_numpy(given, broadcast, slopes, status)
    return slopes, status


def _on_numpy(given: Given, arrays: Sequence[Floats], slopes: Floats, status: Codes) -> None:
    """`sf_gradient` of gradient.h, kind by kind."""
    kinds = arrays[-1]
    for kind in np.unique(kinds):
        here = kinds == kind
        chosen = [array[here] for array in arrays]
        slopes[here], status[here] = _of_kind(given, Pinned(int(kind)), chosen, slopes.shape[-2:])


class Dissipates(NamedTuple):
    """What dissipates, as kernels take it between F_0 and h.

    most, slower -- with all derivatives by A, and with the first
    causes -- what each number that answers move with does to it, shape (parts, numbers, n)
    of_phase -- which of these parts the phase asks for
    """

    most: tuple[Floats, ...]
    slower: tuple[Floats, ...]
    causes: Floats
    of_phase: tuple[int, ...]


def plainly(place: int, damping: Sequence[Floats], columns: int) -> Dissipates:
    """By mu and zeta, from number `place` on."""
    mu, zeta = damping
    causes = np.zeros((2, columns, zeta.size))
    causes[0, place], causes[1, place + 1] = slow_flow.friction(1.0), 1.0
    own = np.asarray(slow_flow.friction(mu)), zeta
    return Dissipates(own, own, causes, (0, 1))


def by_laws(
    place: int, damping: Sequence[Floats], columns: int, A: Floats, ends: tuple[Floats, Floats] | None, beyond: Any
) -> Dissipates:
    """By mu, zeta, eta and c_2, from number `place` on.

    ends   -- where friction ends, and how that moves with the design; None where it acts throughout
    beyond -- as in `model.at_rest`
    """
    mu, zeta, eta, c_2 = damping
    m, u_cr = np.asarray(slow_flow.friction(mu)), None if ends is None else ends[0]
    rest, d = at_rest(A, m, eta, u_cr, beyond), np.asarray(dissipation.quadratic(c_2))
    of_m, of_eta = _stacked(dissipation.rest_moves(A), A).reshape(2, 3, A.size)
    causes = np.zeros((5, columns, A.size))
    if ends is not None:
        u_cr, by_design = ends
        released = _stacked(dissipation.released_moves(np.maximum(A, u_cr), m, u_cr), A).reshape(3, 3, A.size)
        passed = A > u_cr if beyond is None else beyond
        of_m, of_eta = np.where(passed, released[0], of_m), np.where(passed, released[1], of_eta)
        causes[:3, :place] = np.where(passed, released[2], 0.0)[:, np.newaxis] * by_design
    causes[:3, place] = slow_flow.friction(1.0) * of_m
    causes[3, place + 1] = 1.0
    causes[:3, place + 2] = of_eta
    causes[4, place + 3] = dissipation.quadratic(1.0)
    return Dissipates((*rest, zeta, d), (*rest[:2], zeta, d), causes, (0, 3, 4))


def _of_kind(given: Given, kind: Pinned, arrays: list[Floats], inner: tuple[int, ...]) -> tuple[Floats, Codes]:
    """Slopes of shape (n, rows, parameters), and their status; for flat arrays."""
    mechanism, laws = given.mechanism, given.rubs is not None
    kernels: Any = KERNELS[laws, given.excitation != "force"]
    *numbers, F_0, Omega, A, _ = arrays
    n = len(mechanism.design)
    design, damping = numbers[:n], numbers[n:]
    rows, columns = inner
    status = np.full(A.shape, MovesStatus.OK, np.int8)
    parameters = [_in_shape(value, A.shape) for value in mechanism.coefficients(*design)]
    ends, jumps = (
        np.array([_in_shape(value, A.shape) for value in function(*parameters)]).reshape(-1, A.size)
        for function in (mechanism.breakpoints, mechanism.jumps)
    )
    leaves = given.rubs not in (None, THROUGHOUT)
    # of the breakpoints that are there, the first
    ends_friction = leaves & (ends > 0) & (np.cumsum(ends > 0, axis=0) == 1)
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
            comes &= (jumps != 0) | (ends_friction & (damping[0] > 0))
        status[comes.any(axis=0)] = MovesStatus.TURNS
    h, h_A, h_AA, h_AAA = mechanism.averaged(A, *parameters)
    assert mechanism.by_parameter is not None
    assert mechanism.by_design is not None
    by_parameter = _stacked(mechanism.by_parameter(A, h, h_A, h_AA, *parameters), A).reshape(len(parameters), 3, A.size)
    by_design = _stacked(mechanism.by_design(*design), A).reshape(len(parameters) + len(ends), n, A.size)
    of_ends = by_design[len(parameters) :]

    def dissipates(beyond: Any = None) -> Dissipates:
        if not laws:
            return plainly(n, damping, columns)
        if not (leaves and len(ends)):
            return by_laws(n, damping, columns, A, None, beyond)
        first, each = np.argmax(ends_friction, axis=0), np.arange(A.size)
        return by_laws(n, damping, columns, A, (ends[first, each], of_ends[first, :, each].T), beyond)

    own, past = dissipates(), np.zeros(A.shape, bool)
    beside = [np.asarray(value) for value in kernels.beside(Omega, A, F_0, *own.slower, h, h_A)]
    if kind >= Pinned.CUSP:  # those before are at a forcing
        force = F_0 if given.excitation == "force" else inertia.force(Omega, F_0)
        status[_vanishes(force, beside[5], MEETING)] = MovesStatus.BOUNDLESS
    kinds, beyond = np.full(A.shape, kind), None
    if kind in (Pinned.CORNER_FOLD, Pinned.CORNER_END) and leaves:
        # the force makes a corner that ends with R; what rubs no more one that ends with F_A beyond it, too
        beyond, bends = dissipates(True), (jumps == 0)[piece, np.arange(A.size)]
        beside += [np.asarray(value) for value in kernels.beside(Omega, A, F_0, *beyond.slower, h, h_A)[:2]]
        beside[4], beside[6] = np.where(bends, np.inf, beside[4]), np.where(bends, beside[6], np.inf)
    if kind is Pinned.CORNER_FOLD:
        ending = zip(beside[::2], beside[1::2], strict=True)
        turns = [_vanishes(*pair, CLOSE) for number, pair in enumerate(ending) if number != 1]
        status[np.any(turns, axis=0)] = MovesStatus.TURNS
    if kind is Pinned.CORNER_END:
        nearness = [np.abs(value) / size for value, size in zip(beside[::2], beside[1::2], strict=True)]
        which = np.array([Pinned.CORNER_END, Pinned.CORNER_TOP, Pinned.CORNER_BACKBONE, Pinned.CORNER_END])
        nearest = np.argmin(nearness, axis=0)
        kinds, past = which[nearest], nearest == 3
    # along the parameters, then the answers
    of_h, of_rest = np.zeros((3, columns, A.size)), np.zeros((3, columns, A.size))
    of_h[:, :n] = np.einsum("pin,pdn->idn", by_parameter, by_design[: len(parameters)])
    if len(ends):
        of_rest[0, :n] = of_ends[piece, :, np.arange(A.size)].T
    for number, k in enumerate(range(n + len(damping), columns)):
        of_rest[1 + number, k] = 1.0
    out = np.full((A.size, rows, columns), np.nan)
    for pinned, side in [(one, side) for one in np.unique(kinds) for side in np.unique(past[kinds == one])]:
        damps = beyond if side and beyond else own
        at = (Omega, A, F_0, *damps.most, h, h_A, h_AA, h_AAA)
        found, meets = solved(kernels, Pinned(pinned), at, (*of_h, *damps.causes, *of_rest), columns)
        if rows > 3:
            of_phase = (damps.causes[part] for part in damps.of_phase)
            found[1:1] = kernels.moves_of_phase(Omega, A, F_0, *damps.slower, h, h_A, of_h[0], *of_phase, *found[:3])
        here = (kinds == pinned) & (past == side)
        out[here] = np.moveaxis(np.array(found[:rows]), -1, 0)[here]
        status[here & meets & (status == MovesStatus.OK)] = MovesStatus.MEETS
    status[~np.isfinite(out).all(axis=(1, 2)) & (status == MovesStatus.OK)] = MovesStatus.BOUNDLESS
    status[~there] = MovesStatus.NOTHING
    out[status != MovesStatus.OK] = np.nan
    return out, status


def solved(
    kernels: Any, pinned: Pinned, at: Sequence[Any], causes: Sequence[Any], columns: int
) -> tuple[list[Any], Any]:
    """How answers of a kind move, A_p, Omega_p and F_0_p of shape (columns, n), and where they meet others.

    at     -- the points, as the kernels take them; causes -- what each number that they move with does there
    """
    found = kernels.MOVES[pinned](*at, *causes)
    one, size_of_one, other, size_of_other = found[-4:]
    meets = _vanishes(one, size_of_one, MEETING) | _vanishes(other, size_of_other, MEETING)
    shape = (columns, np.size(at[1]))
    return [_in_shape(value, shape) for value in found[:3]], _in_shape(meets, shape[1:])


def _vanishes(value: Any, size: Any, share: float) -> Any:
    """Whether a value has lost its sign to rounding, as far as a share of its size says."""
    return ~(np.abs(value) > share * size)


def _stacked(values: Sequence[Any], like: Floats) -> Floats:
    return np.array([_in_shape(value, like.shape) for value in values])


def _in_shape(value: Any, shape: tuple[int, ...]) -> Any:
    """The value in a shape, which it mostly has: NumPy takes eight microseconds to find that out."""
    return value if np.shape(value) == shape else np.broadcast_to(value, shape)


# ---- the answers


def of_states(given: Given, Omega: Any, A: Any, F_0: Any, phi: Any, transmissibility: Any) -> Gradient:
    """Of steady states at a forcing and a frequency."""
    by = (*_names(given.mechanism, given.rubs is not None), "F_0", "Omega")
    values, at = (A, phi, transmissibility), (*given.numbers, F_0, Omega)
    slopes, status = _of_places(given, (A, Omega, F_0), len(values), len(by))
    if (rests := np.broadcast_to(np.asarray(A) == 0, status.shape)).any():  # friction holds it there as well nearby
        slopes, status = np.array(slopes), np.array(status)
        slopes[rests], status[rests] = 0.0, MovesStatus.OK
    return Gradient(("A", "phi", "transmissibility"), by, slopes, status, values, at)


def _of_places(given: Given, at: tuple[Any, Any, Any], rows: int, columns: int) -> tuple[Floats, Codes]:
    """The first rows of what `_moves` gives of states, asked where there is one: a batch's places are mostly empty."""
    there = np.isfinite(at[0])
    state = float(Pinned.STATE)
    if there.all():
        slopes, status = _moves(given, state, at, OF_STATES, columns)
        return slopes[..., :rows, :], status
    arrays = np.broadcast_arrays(there, *given.numbers, *at)
    there, *numbers = arrays[: len(arrays) - len(at)]
    chosen = given._replace(numbers=tuple(number[there] for number in numbers))
    A, Omega, F_0 = (one[there] for one in arrays[-len(at) :])
    slopes, status = np.full((*there.shape, rows, columns), np.nan), np.full(there.shape, MovesStatus.NOTHING, np.int8)
    found, status[there] = _moves(chosen, state, (A, Omega, F_0), OF_STATES, columns)
    slopes[there] = found[..., :rows, :]
    return slopes, status


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


def of_isolation(given: Given, Omega: Any, A: Any, F_0: Any, at_fold: Any) -> Gradient:
    """Of where isolation begins: of the state that transmits as much as drives it, or of a fold."""
    shape = np.broadcast(*given.numbers, Omega, A, F_0).shape
    Omega, A, on_fold = (np.broadcast_to(np.asarray(one), shape) for one in (_known(Omega), _known(A), at_fold))
    folds = of_folds(given, Omega, np.where(on_fold, A, np.nan), F_0, np.zeros(shape, bool))
    by = (*folds.by, "Omega")
    slopes, status = _moves(given, float(Pinned.STATE), (np.where(on_fold, np.nan, A), Omega, F_0), OF_STATES, len(by))
    kept, status = along_frequency(slopes[..., 0:3:2, :], status, Omega, A)
    slopes = np.where(on_fold[..., np.newaxis, np.newaxis], folds.slopes, kept)
    status = np.where(on_fold, folds.status, status).astype(np.int8)
    return Gradient(("Omega", "A"), folds.by, slopes, status, (Omega, A), (*given.numbers, F_0))


def _known(value: Any) -> Any:
    return np.nan if value is None else value


def along_frequency(slopes: Floats, status: Any, Omega: Floats, A: Floats) -> tuple[Floats, Any]:
    """How states move that keep what they transmit, as their frequency moves; `MovesStatus.MEETS` where none does.

    slopes -- of A first, of what is transmitted last, by all numbers, Omega the last: (..., rows, columns)

    Out come those of Omega, then of the rows but the last, by all numbers but Omega; and the status.
    """
    fixed, by_Omega = slopes[..., :-1], slopes[..., -1]
    with np.errstate(all="ignore"):
        # it is 1: its terms are as large as its frequency and its amplitude may change it relatively
        size = (1 + np.abs(Omega / A * by_Omega[..., 0])) / Omega
        meets = _vanishes(by_Omega[..., -1], size, MEETING)
        Omega_p = -fixed[..., -1:, :] / by_Omega[..., -1:, np.newaxis]
        moved = np.concatenate((Omega_p, fixed[..., :-1, :] + by_Omega[..., :-1, np.newaxis] * Omega_p), axis=-2)
    status = np.where(meets & (status == MovesStatus.OK), np.int8(MovesStatus.MEETS), status)
    moved[status != MovesStatus.OK] = np.nan
    return moved, status


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
