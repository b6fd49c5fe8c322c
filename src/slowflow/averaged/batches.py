"""What many designs at once are answered with: in go columns, out come these with their remarks, gradients and tables.

A design that has no answer, or is none, has NaN and nothing was raised for it: `status` says why, by the numbers of
`slowflow_kernels.conventions.Status`, 0 for an answer. The questions are those of `slowflow.averaged.many`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow import validate
from slowflow.answer import Answer, frozen, optional
from slowflow.averaged import remarks
from slowflow.gradient import Gradient
from slowflow.mechanism import Mechanism
from slowflow.model import THROUGHOUT, Floats, at_rest
from slowflow.moves import Given, of_detachment, of_folds, of_onset, of_peak, of_states
from slowflow.results import NOT_AVERAGED, InDecibels, Remark
from slowflow.transmitted import in_motion
from slowflow_kernels import dissipation, inertia, slow_flow
from slowflow_kernels.conventions import FoldKind, OnsetKind, Status
from slowflow_kernels.domains import DAMPING, DISSIPATION
from slowflow_support.errors import Refused

Codes = npt.NDArray[np.int8]


#: of which type a column is, by its annotation
TYPES: dict[str, Any] = {"Floats": float, "Codes": np.int8}
TYPES |= {"npt.NDArray[np.int16]": np.int16, "npt.NDArray[np.intc]": np.intc}


class Column(NamedTuple):
    """A column of an answer: the axes that it has behind those of the designs, and its type."""

    inner: tuple[str, ...]
    kind: np.dtype[Any]


@dataclass(frozen=True, eq=False)
class Batch(Answer):
    """What all answers to a batch share: `remarks`, computed when first asked for.

    inner -- which columns have one more axis behind those of the designs, and what that is called

    _designs  -- the `slowflow.averaged.many.Designs` that they are answers for
    _averaged -- whether they are answers of averaging, whose gradients are known
    """

    inner: ClassVar[Mapping[str, str]] = MappingProxyType({})

    if TYPE_CHECKING:  # each has it as its last column
        status: Codes
    _designs: Any = field(repr=False, kw_only=True)
    _F_0: Any = field(repr=False, kw_only=True, default=np.nan)
    _averaged: Any = field(repr=False, kw_only=True, default=False)

    @classmethod
    def layout(cls) -> dict[str, Column]:
        """What each column is, by name; remarks last."""
        kinds = {field.name: TYPES[str(field.type)] for field in fields(cls) if field.repr}
        kinds["remarks"] = np.uint16
        axes = {name: (cls.inner[name],) if name in cls.inner else () for name in kinds}
        return {name: Column(axes[name], np.dtype(kind)) for name, kind in kinds.items()}

    def plot_map(self, x: str, y: str, of: str, ax: Any = None) -> Any:
        """Draw a number of each design over two parameters into Matplotlib axes, or new ones, and return these.

        x, y -- names of parameters, "F_0", or "Omega" of states: each varies along one axis of the batch, and nothing
                else varies
        of   -- which number: a column, as "F_SN"

        Grey is where there is no answer. Raises ValueError for another name, and for a batch that is no such grid.
        """
        from slowflow import pictures

        numbers = [name for name, value in vars(self).items() if not name.startswith("_") and value.dtype == float]
        values = np.asarray(getattr(self, validate.choice("of", of, tuple(numbers))))
        return pictures.design_map(ax, *self._designs.spanned(x, y, of, values, self._asked_at()))

    def _whose(self) -> Given:
        """Whose answers these are."""
        designs = self._designs
        names = [one.name for one in (*DAMPING, *(DISSIPATION if designs.laws else ()))]
        damping = (np.asarray(designs.values.get(name, 0.0), dtype=float) for name in names)
        rubs = designs.rubs if designs.laws else None
        return Given(designs.mechanism, (*designs.design, *damping), designs.excitation, rubs)

    def _given(self) -> Given:
        """The same for gradients. Raises ValueError for answers of another approximation."""
        if not self._averaged:
            raise Refused(NOT_AVERAGED)
        return self._whose()

    def _asked_at(self) -> dict[str, Any]:
        """What was asked for beside the designs, by name."""
        return {} if np.isnan(self._F_0).all() else {"F_0": np.asarray(self._F_0)}

    @property
    def _forcing(self) -> Floats:
        """Along the axis of places."""
        return np.asarray(self._F_0, dtype=float)[..., np.newaxis]

    def _force_at(self, Omega: Any) -> Any:
        """Amplitude of the force at these frequencies, which have the axis of places."""
        return self._forcing if self._designs.excitation == "force" else inertia.force(Omega, self._forcing)

    def _found(self) -> tuple[Any, Any, Any]:
        """Omega and A of each design's states along one more axis, NaN for none, and of folds which are on a corner.

        No states at all, but for those that say so, and None in the place of corners but for folds.
        """
        none = np.full((*self.status.shape, 1), np.nan)
        return none, none, None

    @property
    def has_rows(self) -> bool:
        """True."""
        return True

    def columns(self) -> dict[str, Any]:
        """A row for each design, in the order of the flattened arrays: its numbers, then the answer's.

        What has several places becomes a column for each, as Omega_0.
        """
        shape = self.status.shape
        given = {**self._designs.values, **self._asked_at()}
        found = {name: np.broadcast_to(value, shape).ravel() for name, value in given.items()}
        for name, value in self._content().items():
            several = value.ndim > len(shape)
            places = np.moveaxis(value, -1, 0) if several else [value]
            found |= {f"{name}_{k}" if several else name: place.ravel() for k, place in enumerate(places)}
        return found

    def _axes(self) -> tuple[str, ...]:
        """Names of the designs' dimensions."""
        return tuple(f"design_{k}" for k in range(self.status.ndim))

    def to_xarray(self) -> Any:
        """A Dataset along the designs' own dimensions, "design_0" and so on; their numbers, F_0, Omega as coordinates.

        Several places of an answer are a dimension more. Each has its units, all dimensionless: "1". Raises ImportError
        without xarray.
        """
        xarray = optional("xarray", "to_xarray")
        shape, designs = self.status.shape, self._axes()
        asked = {**self._designs.values, **self._asked_at()}
        units = {"units": "1"}
        given = {name: (designs, np.broadcast_to(value, shape), units) for name, value in asked.items()}
        found = {
            name: ((*designs, self.inner[name]) if value.ndim > len(shape) else designs, value, units)
            for name, value in self._content().items()
        }
        return xarray.Dataset(found, coords=given, attrs={"mechanism": self._designs.mechanism.name})

    def about(self) -> dict[str, Any]:
        """The mechanism, the shape of the designs, and where friction acts if not throughout."""
        said = {} if self._designs.rubs == THROUGHOUT else {"rubs": self._designs.rubs}
        return {"mechanism": self._designs.mechanism.name, "shape": self.status.shape, **said}

    @property
    def _has_remarks(self) -> npt.NDArray[np.bool_]:
        """Of which designs there is anything to say: of a force that does not move the mass there is not."""
        designs = self._designs
        moves = designs.excitation != "force" or getattr(designs, "rubs", THROUGHOUT) != THROUGHOUT
        # a preload holds a mass up to more than friction does, beside motions of other frequencies
        with np.errstate(over="ignore"):  # infinite friction holds all
            held = moves | (np.asarray(self._F_0) > slow_flow.friction(np.asarray(designs.values["mu"])))
        return np.asarray((self.status != Status.INVALID) & ((self.status != Status.STICKS) | held))

    @cached_property
    def remarks(self) -> remarks.Codes:
        """What to bear in mind with each design's answer, sums of `slowflow.results.Remark`, as a single one has it."""
        return frozen(np.where(self._has_remarks, self._designs.remarks(self._F_0, *self._found()), np.uint16(0)))


@dataclass(frozen=True, eq=False)
class Told(Batch):
    """Answers that are made of others, or of single ones, and have their remarks from these."""

    _said: remarks.Codes = field(repr=False, kw_only=True)

    @cached_property
    def remarks(self) -> remarks.Codes:
        """Sums of `slowflow.results.Remark`, as a single answer has them."""
        return frozen(self._said)


@dataclass(frozen=True, eq=False)
class Detachments(Batch):
    """The lowest forcing that reaches u_cr, its frequency, and u_cr, for each design (34)."""

    F_cr: Floats
    Omega_cr: Floats
    u_cr: Floats
    status: Codes

    def _found(self) -> tuple[Any, Any, Any]:
        return self.Omega_cr[..., np.newaxis], self.u_cr[..., np.newaxis], None

    def gradient(self) -> Gradient:
        """As of a single `Detachment`, of each design; `.slopes` of shape (..., 3, parameters)."""
        return of_detachment(self._given(), self.F_cr, self.Omega_cr, self.u_cr)


@dataclass(frozen=True, eq=False)
class Onsets(Batch):
    """The lowest forcing that has a fold, for each design (33).

    kind    -- a number of `slowflow_kernels.conventions.OnsetKind`: a cusp, an isola's birth, on a breakpoint
    at_rest -- 1 where there are folds below it, or without it, that end at Omega = 0
    """

    F_SN: Floats
    Omega: Floats
    A: Floats
    kind: Codes
    at_rest: Codes
    status: Codes
    _by_balls: Any = field(repr=False, kw_only=True, default=False)

    @cached_property
    def remarks(self) -> remarks.Codes:
        """As of all batches, `Remark.FOLDS_AT_REST` and `Remark.BY_BALLS`."""
        at_rest = np.where(self.at_rest, np.uint16(Remark.FOLDS_AT_REST), np.uint16(0))
        by_balls = np.where(self._by_balls, np.uint16(Remark.BY_BALLS), np.uint16(0))
        return frozen(super().remarks | at_rest | by_balls)

    @cached_property
    def untruncated(self) -> Floats:
        """F_SN of the untruncated force where the onset is on a corner that only the truncation makes; NaN elsewhere.

        NaN there too if it has none. Computed when first asked for.
        """
        return frozen(self._designs.untruncated_onset((self.remarks & Remark.OF_TRUNCATION) != 0))

    def _found(self) -> tuple[Any, Any, Any]:
        return (
            self.Omega[..., np.newaxis],
            self.A[..., np.newaxis],
            (self.kind == OnsetKind.CORNER)[..., np.newaxis],
        )

    def gradient(self) -> Gradient:
        """As of a single `SaddleNodeOnset`, of each design; `.slopes` of shape (..., 3, parameters)."""
        return of_onset(self._given(), self.F_SN, self.Omega, self.A, self.kind)


@dataclass(frozen=True, eq=False)
class Counted(Batch):
    """What answers share whose number rounding may decide."""

    if TYPE_CHECKING:  # each has it as a column
        undecided: Codes
    _by_balls: Any = field(repr=False, kw_only=True, default=False)

    @property
    def _are_cut(self) -> Any:
        """Whose response is cut: nothing bounds it, or nothing below the mechanism's reach."""
        designs = self._designs
        damping = (np.asarray(designs.values.get(name, 0.0)) for name in ("zeta", *(one.name for one in DISSIPATION)))
        undamped = np.all(np.broadcast_arrays(*(value == 0 for value in damping)), axis=0)
        if designs.excitation == "force" and designs.mechanism.enclosed is None:
            return undamped
        # what does not close has no peak, as what passes the top of a well has none
        peaks = designs.peak(self._F_0)
        return undamped | ((peaks.status == Status.UNBOUNDED) & ~peaks._escapes)

    @property
    def _may_be_cut(self) -> Any:
        """Whether what lies beyond a cut would be part of the answer."""
        return True

    @cached_property
    def remarks(self) -> remarks.Codes:
        """As of all batches, `Remark.UNDECIDED`, `Remark.BY_BALLS` and `Remark.CUT`."""
        undecided = np.where(self.undecided, np.uint16(Remark.UNDECIDED), np.uint16(0))
        cut = np.where(self._has_remarks & self._may_be_cut & self._are_cut, np.uint16(Remark.CUT), np.uint16(0))
        by_balls = np.where(self._by_balls, np.uint16(Remark.BY_BALLS), np.uint16(0))
        return frozen(super().remarks | undecided | by_balls | cut)


@dataclass(frozen=True, eq=False)
class AtFrequency(Counted):
    """What answers share that were asked for at one frequency of each design."""

    if TYPE_CHECKING:
        A: Floats
    _Omega: Any = field(repr=False, kw_only=True)

    def _asked_at(self) -> dict[str, Any]:
        return {**super()._asked_at(), "Omega": np.asarray(self._Omega)}

    @property
    def _frequency(self) -> Floats:
        """Along the axis of places."""
        return np.asarray(self._Omega, dtype=float)[..., np.newaxis]

    def _found(self) -> tuple[Any, Any, Any]:
        return self._frequency, self.A, None


@dataclass(frozen=True, eq=False)
class AlongCurves(Counted):
    """What answers share that have points along a curve of each design."""

    if TYPE_CHECKING:
        Omega: Floats
        A: Floats

    @property
    def _frequency(self) -> Floats:
        """Of each point."""
        return self.Omega

    def _found(self) -> tuple[Any, Any, Any]:
        return self.Omega, self.A, None

    def columns(self) -> dict[str, Any]:
        """A row for each point of each design, in the order of the flattened arrays: the design's numbers, the point's.

        The folds are columns of `saddle_nodes`.
        """
        here = ~np.isnan(self.A)
        given = {**self._designs.values, **self._asked_at()}
        several = {name: np.asarray(value)[..., np.newaxis] for name, value in given.items()}
        found = {name: np.broadcast_to(value, self.A.shape)[here] for name, value in several.items()}
        return found | {name: value[here] for name, value in self._content().items() if self.inner.get(name) == "point"}


@dataclass(frozen=True, eq=False)
class Folds(Counted):
    """The folds at one forcing, for each design; Omega, A and kind have one more axis, with `places` places.

    Omega, A -- by rising Omega, then NaN
    kind     -- a number of `slowflow_kernels.conventions.FoldKind`: where a sweep goes that leaves the fold, and
                whether it sits on a corner at a breakpoint; 0 is an empty place
    count    -- how many folds there are, also where they are more than places
    undecided -- 1 where neither doubles nor balls tell whether there is another pair, or where one lies
    """

    inner: ClassVar[Mapping[str, str]] = MappingProxyType(dict.fromkeys(("Omega", "A", "kind"), "place"))

    Omega: Floats
    A: Floats
    kind: Codes
    count: Codes
    undecided: Codes
    status: Codes

    def _found(self) -> tuple[Any, Any, Any]:
        return self.Omega, self.A, self._corner

    @property
    def _may_be_cut(self) -> Any:
        return (self.count > 0) | (self.undecided != 0) | (self._designs.excitation != "force")

    @property
    def _corner(self) -> Any:
        return self.kind >= FoldKind.JUMP_UP_AT_CORNER

    def gradient(self) -> Gradient:
        """As of single `SaddleNodes`, of each design; `.slopes` of shape (..., places, 2, parameters)."""
        return of_folds(self._given().with_places(), self.Omega, self.A, self._forcing, self._corner)


class Passing(InDecibels):
    """What states and points of curves share: phase, and what is passed on."""

    if TYPE_CHECKING:
        A: Floats
        _forcing: Floats
        _frequency: Floats
        _force_at: Any
        _whose: Any

    @cached_property
    def phi(self) -> Floats:
        """Phase of u = A cos(Omega tau + phi) in radians, in [-pi, 0] (25); NaN in an empty place.

        Computed when first asked for.
        """
        with np.errstate(all="ignore"):  # empty places
            return frozen(slow_flow.phase(self._frequency, self.A, *self._of_designs))

    @cached_property
    def transmissibility(self) -> Floats:
        """As of single `SteadyStates`; NaN in an empty place, and behind the last point. Computed when asked for."""
        with np.errstate(all="ignore"):
            force = self._force_at(self._frequency)
            passed = slow_flow.transmissibility(self._frequency, self.A, force, *self._of_designs)
            return frozen(in_motion(self.A, passed))

    @property
    def relative(self) -> Floats:
        """As of single `SteadyStates`: A over F_0; NaN in an empty place."""
        return np.asarray(self.A / self._forcing)

    @cached_property
    def _of_designs(self) -> tuple[Floats, Floats, Floats]:
        """m, zeta and h at each place; for other laws of damping the m that alone has the same I, as `Model.alike`."""
        mechanism, numbers, _, rubs = self._whose().with_places()
        n = len(mechanism.design)
        design, (mu, zeta, *laws) = numbers[:n], numbers[n:]
        with np.errstate(all="ignore"):
            m, parameters = slow_flow.friction(mu), mechanism.coefficients(*design)
            h = mechanism.averaged(self.A, *parameters)[0]
            if not laws:
                return m, zeta, h
            eta, c_2 = laws
            u_cr = None
            if rubs != THROUGHOUT:
                u_cr = first_end(mechanism, parameters)
            I_0 = at_rest(self.A, m, eta, u_cr)[0]
            return dissipation.I(self._frequency, self.A, I_0, zeta, dissipation.quadratic(c_2)), np.zeros(()), h


@dataclass(frozen=True, eq=False)
class States(Passing, AtFrequency):
    """The steady states at one frequency and forcing, for each design; A, stable and phi have one more axis, of places.

    A      -- by rising A, then NaN; 0 where friction holds the mass at rest, with `Status.STICKS` if nothing else is
              there
    stable -- 1 where both eigenvalues of the Jacobian (28) have a negative real part
    count  -- how many states there are, also where they are more than places
    undecided -- 1 where neither doubles nor balls tell whether there is another pair
    """

    inner: ClassVar[Mapping[str, str]] = MappingProxyType(dict.fromkeys(("A", "stable"), "place"))

    A: Floats
    stable: Codes
    count: Codes
    undecided: Codes
    status: Codes

    def gradient(self) -> Gradient:
        """As of single `SteadyStates`, of each design; `.slopes` of shape (..., places, 3, parameters)."""
        given = self._given().with_places()
        return of_states(given, self._frequency, self.A, self._forcing, self.phi, self.transmissibility)


@dataclass(frozen=True, eq=False)
class Curves(Passing, AlongCurves):
    """The response curve at one forcing, for each design, with every fold at that forcing.

    Omega, A, stable, branch and isola have one more axis, of points, in order along each branch; the curves of designs
    have different numbers of points, and behind the last one Omega and A are NaN, branch is -1, and the others are 0.

    stable -- 1 where both eigenvalues of the Jacobian (28) have a negative real part
    branch -- number of the connected curve that a point lies on, from 0; isolated curves come last
    isola  -- 1 where that curve is closed
    points -- how many points there are
    fold_Omega, fold_A, fold_kind, count -- `Omega`, `A`, `kind` and `count` of `Folds`, with `places` places
    undecided -- 1 where neither doubles nor balls tell whether there are other folds, peaks or static states
    """

    inner: ClassVar[Mapping[str, str]] = MappingProxyType(
        dict.fromkeys(("Omega", "A", "stable", "branch", "isola"), "point")
        | dict.fromkeys(("fold_Omega", "fold_A", "fold_kind"), "place")
    )

    Omega: Floats
    A: Floats
    stable: Codes
    branch: npt.NDArray[np.int16]
    isola: Codes
    points: npt.NDArray[np.intc]
    fold_Omega: Floats
    fold_A: Floats
    fold_kind: Codes
    count: Codes
    undecided: Codes
    status: Codes


@dataclass(frozen=True, eq=False)
class Peaks(Batch):
    """The highest peak at one forcing, for each design, isolas included; Omega = 0 where A only falls with Omega.

    Of a spring that gives way it is that within the well, with `Status.UNBOUNDED` where none is there.
    """

    A: Floats
    Omega: Floats
    status: Codes
    #: which have none because the response goes on beyond a well
    _escapes: Any = field(repr=False, kw_only=True, default=False)

    @cached_property
    def remarks(self) -> remarks.Codes:
        """As of all batches, and `Remark.BEYOND_WELL` where there are states beyond the well."""
        has_states = (self._has_remarks & self._designs.give_way) | self._escapes
        beyond = np.where(has_states, np.uint16(Remark.BEYOND_WELL), np.uint16(0))
        return frozen(super().remarks | beyond)

    def _found(self) -> tuple[Any, Any, Any]:
        return self.Omega[..., np.newaxis], self.A[..., np.newaxis], None

    def gradient(self) -> Gradient:
        """As of a single `Peak`, of each design; `.slopes` of shape (..., 2, parameters)."""
        return of_peak(self._given(), self.A, self.Omega, np.asarray(self._F_0, dtype=float))


@dataclass(frozen=True, eq=False)
class Proofs(Batch):
    """How many folds at a forcing, or states at a frequency, each design is proved to have.

    count  -- how many are enclosed
    proved -- 1 where these are proved to be all, with amplitudes as in `certify`; 0 where that is not decided
    bits   -- of the arithmetic, as in `certify`: 53 of intervals of doubles, more of balls
    status -- `Status.UNRESOLVED` where no proof is possible: of a force whose averages are known in neither
    """

    count: Codes
    proved: Codes
    bits: npt.NDArray[np.int16]
    status: Codes


def first_end(mechanism: Mechanism, parameters: tuple[Any, ...]) -> Floats:
    """The lowest |u| at which a piece of the force ends, of each of many designs; inf where there is one piece only."""
    found = np.full(np.broadcast_shapes(*(np.shape(value) for value in parameters)), math.inf)
    for end in reversed(mechanism.breakpoints(*parameters)):
        found = np.where(np.asarray(end) > 0, end, found)
    return found
