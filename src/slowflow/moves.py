"""How answers move with their parameters: in go answers and what they are, out come their gradients.

By the implicit function theorem, from generated kernels: what a number does to h, m and zeta, and what that does to the
answer. Compiled code where it is, one loop over all answers; elsewhere the same on NumPy.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow import backend, validate
from slowflow.gradient import Gradient
from slowflow.mechanism import Floats, Mechanism
from slowflow.model import THROUGHOUT, at_rest
from slowflow_kernels import dissipation, sensitivities, slow_flow
from slowflow_kernels.conventions import CLOSE, COINCIDE, MEETING, SAME, SYSTEMS, MovesStatus, OnsetKind, Pinned
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
    if record is not None:
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
    """What dissipates: I_0 and its derivatives by A, zeta, d.

    causes -- what each number that answers move with does to I_0, I_0A, I_0AA, zeta and d, shape (5, numbers, n)
    """

    rest: tuple[Floats, ...]
    zeta: Floats
    d: Any
    causes: Floats


def plainly(place: int, damping: Sequence[Floats], columns: int) -> Dissipates:
    """By mu and zeta, from number `place` on."""
    mu, zeta = damping
    causes, none = np.zeros((5, columns, zeta.size)), np.zeros(zeta.size)
    causes[0, place], causes[3, place + 1] = slow_flow.friction(1.0), 1.0
    return Dissipates((np.asarray(slow_flow.friction(mu)), none, none, none), zeta, 0.0, causes)


def by_laws(
    place: int, damping: Sequence[Floats], columns: int, A: Floats, ends: tuple[Floats, Floats] | None, beyond: Any
) -> Dissipates:
    """By mu, zeta, eta and c_2, from number `place` on.

    ends   -- where friction ends, and how that moves with the design; None where it acts throughout
    beyond -- as in `model.at_rest`
    """
    mu, zeta, eta, c_2 = damping
    m, u_cr = np.asarray(slow_flow.friction(mu)), None if ends is None else ends[0]
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
    return Dissipates(at_rest(A, m, eta, u_cr, beyond), zeta, np.asarray(dissipation.quadratic(c_2)), causes)


@dataclass(frozen=True, eq=False)
class System:
    """The conditions of answers at A, Omega and F_0, in what their slopes are of; `gradient.h` has the same.

    h      -- and three derivatives
    moves  -- of what each of the numbers that answers move with does: to h, h_A and h_AA, (3, numbers, n); and to the
              forcing, the frequency and a breakpoint that are given
    """

    A: Floats
    Omega: Floats
    F_0: Floats
    inertial: bool
    damps: Dissipates
    h: Sequence[Floats]
    of_h: Floats
    given: Floats

    @cached_property
    def excited(self) -> tuple[Any, ...]:
        """The force's amplitude, its slopes, and those of its square."""
        return (sensitivities.by_inertia if self.inertial else sensitivities.by_force)(self.Omega, self.F_0)

    @cached_property
    def R(self) -> tuple[Any, Any]:
        """The cosine balance, and its size."""
        return slow_flow.R(self.Omega, self.A, self.h[0]), slow_flow.R(self.Omega, self.A, np.abs(self.h[0]))

    def slopes(self, R: Any) -> tuple[Floats, Floats]:
        """Of each condition by A, Omega and F_0, and their sizes: (conditions, 3, n)."""
        damps = self.damps
        at = (self.Omega, self.A, R, *damps.rest, damps.zeta, damps.d, *self.h, *self.excited[3:])
        both = _stacked(sensitivities.slopes(*at), self.A).reshape(2, -1, 3, self.A.size)
        return both[0], both[1]

    def beside(self) -> list[tuple[Any, Any]]:
        """F_A, F_Omega and R, each with its size."""
        values, sizes = self.slopes(self.R[0])
        return [(values[0, 0], sizes[0, 0]), (values[0, 1], sizes[0, 1]), self.R]

    def solved(self, kind: Pinned) -> tuple[Floats, Any]:
        """How answers of a kind move, (3, numbers, n), and where they meet others."""
        R = 0.0 if kind is Pinned.CORNER_BACKBONE else self.R[0]
        (slopes, sizes), damps = self.slopes(R), self.damps
        at = (self.Omega, self.A, R, *damps.rest[:3], damps.zeta, damps.d, *self.h[1:3])
        shape = self.given.shape[1:]
        right = [_in_shape(one, shape) for one in sensitivities.right(*at, *self.of_h, *damps.causes, *self.given)]
        system = SYSTEMS[kind]
        rows, unknowns, together = system[:3], system[3:6], system[6]
        for vanishing in system[7:]:
            slopes[divmod(vanishing, 3)] = 0.0
        moved, meets = np.zeros((3, *shape)), np.zeros(shape[1:], bool)
        for n, (row, x) in enumerate(zip(rows, unknowns, strict=True)):
            if together and n:
                break
            known = right[row] - sum(slopes[row, k] * moved[k] for k in unknowns[:n])
            moved[x] = known / slopes[row, x]
            meets |= _vanishes(slopes[row, x], sizes[row, x], MEETING)
        if together:
            (first, x, y), (_, a, b) = unknowns, rows
            of_a, of_b = (right[row] - slopes[row, first] * moved[first] for row in (a, b))
            determinant = slopes[a, x] * slopes[b, y] - slopes[a, y] * slopes[b, x]
            meets |= _vanishes(determinant, sizes[a, x] * sizes[b, y] + sizes[a, y] * sizes[b, x], MEETING)
            moved[x] = (of_a * slopes[b, y] - slopes[a, y] * of_b) / determinant
            moved[y] = (slopes[a, x] * of_b - of_a * slopes[b, x]) / determinant
        return moved, meets

    def of_state(self, moved: Floats) -> tuple[Any, Any]:
        """How the phase and the transmissibility of states move."""
        damps = self.damps
        at = (self.Omega, self.A, *damps.rest[:2], damps.zeta, damps.d, *self.h[:2], *self.excited[:3])
        # mypy takes a starred argument for all that are left
        return sensitivities.of_state(*at, self.of_h[0], *damps.causes[[0, 3, 4]], *moved)  # type: ignore[call-arg]


def _of_kind(given: Given, kind: Pinned, arrays: list[Floats], inner: tuple[int, ...]) -> tuple[Floats, Codes]:
    """Slopes of shape (n, rows, parameters), and their status; for flat arrays."""
    mechanism, laws = given.mechanism, given.rubs is not None
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

    # along the parameters, then the answers
    of_h, given_p = np.zeros((3, columns, A.size)), np.zeros((3, columns, A.size))
    of_h[:, :n] = np.einsum("pin,pdn->idn", by_parameter, by_design[: len(parameters)])
    for number, k in enumerate(range(n + len(damping), columns)):
        given_p[number, k] = 1.0
    if len(ends):
        given_p[2, :n] = of_ends[piece, :, np.arange(A.size)].T

    def system(beyond: Any = None) -> System:
        inertial = given.excitation != "force"
        return System(A, Omega, F_0, inertial, dissipates(beyond), (h, h_A, h_AA, h_AAA), of_h, given_p)

    own, past = system(), np.zeros(A.shape, bool)
    if kind >= Pinned.CUSP:  # those before are at a forcing
        status[_vanishes(own.excited[0], own.R[1], MEETING)] = MovesStatus.BOUNDLESS
    kinds, other = np.full(A.shape, kind), None
    if kind in (Pinned.CORNER_FOLD, Pinned.CORNER_END):
        beside = own.beside()
        if leaves:
            # the force makes a corner that ends with R; what rubs no more one that ends with F_A beyond it, too
            other, bends = system(True), (jumps == 0)[piece, np.arange(A.size)]
            beside.append(other.beside()[0])
            beside[2:] = (
                (np.where(ends_there, value, np.inf), np.where(ends_there, size, 1.0))
                for ends_there, (value, size) in zip((~bends, bends), beside[2:], strict=True)
            )
        if kind is Pinned.CORNER_FOLD:
            turns = [_vanishes(*pair, CLOSE) for number, pair in enumerate(beside) if number != 1]
            status[np.any(turns, axis=0)] = MovesStatus.TURNS
        else:
            nearness = [np.abs(value) / size for value, size in beside]
            which = np.array([Pinned.CORNER_END, Pinned.CORNER_TOP, Pinned.CORNER_BACKBONE, Pinned.CORNER_END])
            nearest = np.argmin(nearness, axis=0)
            kinds, past = which[nearest], nearest == 3
    out = np.full((A.size, rows, columns), np.nan)
    for pinned, side in [(one, side) for one in np.unique(kinds) for side in np.unique(past[kinds == one])]:
        of = other if side and other else own
        found, meets = of.solved(Pinned(pinned))
        every = [found[0], *of.of_state(found), *found[1:]] if rows > 3 else found
        here = (kinds == pinned) & (past == side)
        out[here] = np.moveaxis(np.stack([_in_shape(one, found.shape[1:]) for one in every]), -1, 0)[here]
        status[here & meets & (status == MovesStatus.OK)] = MovesStatus.MEETS
    status[~np.isfinite(out).all(axis=(1, 2)) & (status == MovesStatus.OK)] = MovesStatus.BOUNDLESS
    status[~there] = MovesStatus.NOTHING
    out[status != MovesStatus.OK] = np.nan
    return out, status


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


def of_isolation(given: Given, Omega: Any, A: Any, F_0: Any, at_fold: Any, ratio: Any) -> Gradient:
    """Of where isolation begins: of the state that transmits that share of what drives it, or of a fold."""
    shape = np.broadcast(*given.numbers, Omega, A, F_0).shape
    Omega, A, on_fold = (np.broadcast_to(np.asarray(one), shape) for one in (_known(Omega), _known(A), at_fold))
    folds = of_folds(given, Omega, np.where(on_fold, A, np.nan), F_0, np.zeros(shape, bool))
    by = (*folds.by, "Omega")
    slopes, status = _moves(given, float(Pinned.STATE), (np.where(on_fold, np.nan, A), Omega, F_0), OF_STATES, len(by))
    kept, status = along_frequency(slopes[..., 0:3:2, :], status, Omega, A, ratio)
    slopes = np.where(on_fold[..., np.newaxis, np.newaxis], folds.slopes, kept)
    status = np.where(on_fold, folds.status, status).astype(np.int8)
    return Gradient(("Omega", "A"), folds.by, slopes, status, (Omega, A), (*given.numbers, F_0))


def _known(value: Any) -> Any:
    return np.nan if value is None else value


def along_frequency(slopes: Floats, status: Any, Omega: Floats, A: Floats, ratio: Any) -> tuple[Floats, Any]:
    """How states move that keep what they transmit, as their frequency moves; `MovesStatus.MEETS` where none does.

    slopes -- of A first, of what is transmitted last, by all numbers, Omega the last: (..., rows, columns)
    ratio  -- what is transmitted

    Out come those of Omega, then of the rows but the last, by all numbers but Omega; and the status.
    """
    fixed, by_Omega = slopes[..., :-1], slopes[..., -1]
    with np.errstate(all="ignore"):
        # its terms are as large as its frequency and its amplitude may change it relatively
        size = ratio * (1 + np.abs(Omega / A * by_Omega[..., 0])) / Omega
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
