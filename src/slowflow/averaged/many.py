"""Many designs at once: in go arrays of parameters that broadcast, out come critical forcings, folds, states and peaks.

Made by `Isolator.many(...)` and `Duffing.many(...)`. Nothing but the answers is allocated: inputs stay as they are,
broadcast views included. `workers` threads share the designs (-1: one for each processor) and give the same digits; the
NumPy solvers use one. Ctrl-C is heard within a second. A design that has no answer, or is none, gets NaN and nothing is
raised for it: `status` says why, by the numbers of `slowflow_kernels.conventions.Status`, 0 for an answer.
"""

from __future__ import annotations

import importlib.util
import math
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, fields
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow import backend, validate
from slowflow.answer import Answer, frozen, optional
from slowflow.averaged import proofs, remarks, words
from slowflow.averaged.asked import (
    AMPLITUDES,
    DETACHMENT,
    NO_PROOF,
    ONSET,
    PEAK,
    PROVED_FOLDS,
    PROVED_STATES,
    SADDLE_NODES,
    One,
    Question,
    curves,
)
from slowflow.averaged.questions import Averaged
from slowflow.certificate import DOUBLES
from slowflow.gradient import Gradient
from slowflow.mechanism import Mechanism
from slowflow.model import THROUGHOUT, Floats, Laws, Model, at_rest, check_names
from slowflow.moves import Given, of_detachment, of_folds, of_onset, of_peak, of_states
from slowflow.results import NOT_AVERAGED, Remark
from slowflow_kernels import dissipation, inertia, slow_flow
from slowflow_kernels.conventions import FoldKind, OnsetKind, Status
from slowflow_kernels.domains import DAMPING, DISSIPATION

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

    _averaged -- whether they are answers of averaging, whose gradients are known
    """

    inner: ClassVar[Mapping[str, str]] = MappingProxyType({})

    if TYPE_CHECKING:  # each has it as its last column
        status: Codes
    _designs: Designs = field(repr=False, kw_only=True)
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
            raise ValueError(NOT_AVERAGED)
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

    @cached_property
    def remarks(self) -> remarks.Codes:
        """What to bear in mind with each design's answer, sums of `slowflow.results.Remark`, as a single one has it."""
        asked = (self.status != Status.INVALID) & (self.status != Status.STICKS)
        return frozen(np.where(asked, self._designs.remarks(self._F_0, *self._found()), np.uint16(0)))


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

    @cached_property
    def remarks(self) -> remarks.Codes:
        """As of all batches, and `Remark.FOLDS_AT_REST`."""
        return frozen(super().remarks | np.where(self.at_rest, np.uint16(Remark.FOLDS_AT_REST), np.uint16(0)))

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

    @property
    def _are_cut(self) -> Any:
        """Whose response is cut: nothing bounds it, or nothing below the mechanism's reach."""
        designs = self._designs
        damping = (np.asarray(designs.values.get(name, 0.0)) for name in ("zeta", *(one.name for one in DISSIPATION)))
        undamped = np.all(np.broadcast_arrays(*(value == 0 for value in damping)), axis=0)
        if designs.excitation == "force" and designs.mechanism.enclosed is None:
            return undamped
        # what does not close has no peak
        return undamped | (designs.peak(self._F_0).status == Status.UNBOUNDED)

    @property
    def _may_be_cut(self) -> Any:
        """Whether what lies beyond a cut would be part of the answer."""
        return True

    @cached_property
    def remarks(self) -> remarks.Codes:
        """As of all batches, `Remark.UNDECIDED` and `Remark.CUT`."""
        undecided = np.where(self.undecided, np.uint16(Remark.UNDECIDED), np.uint16(0))
        asked = (self.status != Status.INVALID) & (self.status != Status.STICKS)
        cut = np.where(asked & self._may_be_cut & self._are_cut, np.uint16(Remark.CUT), np.uint16(0))
        return frozen(super().remarks | undecided | cut)


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
    undecided -- 1 where doubles do not tell whether there is another pair
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


@dataclass(frozen=True, eq=False)
class States(AtFrequency):
    """The steady states at one frequency and forcing, for each design; A, stable and phi have one more axis, of places.

    A      -- by rising A, then NaN
    stable -- 1 where both eigenvalues of the Jacobian (28) have a negative real part
    count  -- how many states there are, also where they are more than places
    undecided -- 1 where doubles do not tell whether there is another pair
    """

    inner: ClassVar[Mapping[str, str]] = MappingProxyType(dict.fromkeys(("A", "stable"), "place"))

    A: Floats
    stable: Codes
    count: Codes
    undecided: Codes
    status: Codes

    @cached_property
    def phi(self) -> Floats:
        """Phase of u = A cos(Omega tau + phi) in radians, in [-pi, 0] (25); NaN in an empty place.

        Computed when first asked for.
        """
        with np.errstate(all="ignore"):  # empty places
            return frozen(slow_flow.phase(self._frequency, self.A, *self._of_designs))

    @cached_property
    def transmissibility(self) -> Floats:
        """As of single `SteadyStates`; NaN in an empty place. Computed when first asked for."""
        with np.errstate(all="ignore"):
            force = self._force_at(self._frequency)
            return frozen(slow_flow.transmissibility(self._frequency, self.A, force, *self._of_designs))

    def gradient(self) -> Gradient:
        """As of single `SteadyStates`, of each design; `.slopes` of shape (..., places, 3, parameters)."""
        given = self._given().with_places()
        return of_states(given, self._frequency, self.A, self._forcing, self.phi, self.transmissibility)

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
class Curves(AlongCurves):
    """The response curve at one forcing, for each design, with every fold at that forcing.

    Omega, A, stable, branch and isola have one more axis, of points, in order along each branch; the curves of designs
    have different numbers of points, and behind the last one Omega and A are NaN, branch is -1, and the others are 0.

    stable -- 1 where both eigenvalues of the Jacobian (28) have a negative real part
    branch -- number of the connected curve that a point lies on, from 0; isolated curves come last
    isola  -- 1 where that curve is closed
    points -- how many points there are
    fold_Omega, fold_A, fold_kind, count -- `Omega`, `A`, `kind` and `count` of `Folds`, with `places` places
    undecided -- 1 where doubles do not tell whether there is another pair of folds
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
    """The highest peak at one forcing, for each design, isolas included; Omega = 0 where A only falls with Omega."""

    A: Floats
    Omega: Floats
    status: Codes

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


class Designs:
    """Arrays of designs of one mechanism, and the questions about them.

    mechanism -- record of the mechanism
    values    -- the numbers of its design by name, mu, zeta, and eta and c_2 where they are given; real arrays that
                 broadcast
    excitation -- what F_0 is the amplitude of, the same for all: "force", "base" or "unbalance"
    rubs      -- where dry friction acts, the same for all: "throughout" or "attached"

    With eta, c_2 or rubs="attached" designs are answered one by one on NumPy, as single ones are: some tenths of a
    second each. Raises TypeError for a name that is missing or unknown, ValueError for such laws with another
    excitation.
    """

    def __init__(
        self, mechanism: Mechanism, values: dict[str, Any], excitation: str = "force", rubs: str = THROUGHOUT
    ) -> None:
        names = check_names(mechanism, values, DISSIPATION)
        self.mechanism, self.excitation, self.rubs = mechanism, excitation, rubs
        self.values = {name: validate.real_array(name, values[name]) for name in names}
        self.shape = validate.common_shape(self.values)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Designs) or (self.mechanism, *self.values) != (other.mechanism, *other.values):
            return NotImplemented if not isinstance(other, Designs) else False
        pairs = zip(self.values.values(), other.values.values(), strict=True)
        same = (self.excitation, self.rubs) == (other.excitation, other.rubs)
        return same and all(np.array_equal(one, two, equal_nan=True) for one, two in pairs)

    def __hash__(self) -> int:
        return hash((self.mechanism, *(value.tobytes() for value in self.values.values())))

    @property
    def design(self) -> list[Floats]:
        """The numbers that the mechanism's parameters follow from, in its order."""
        return [np.asarray(self.values[domain.name], dtype=float) for domain in self.mechanism.design]

    @cached_property
    def laws(self) -> str:
        """The laws of damping beside mu and zeta, in words; empty without."""
        given = ((one.name, self.values[one.name]) for one in DISSIPATION if one.name in self.values)
        told = [f"{name} = {value}" if value.ndim == 0 else f"an array of {name}" for name, value in given]
        return ", ".join(told if self.rubs == THROUGHOUT else [*told, f"rubs = {self.rubs!r}"])

    def model(self, numbers: dict[str, float]) -> Model:
        """One design, from its numbers by name. Raises ValueError for one outside its domain."""
        own = dict(numbers)
        eta, c_2 = (own.pop(one.name, 0.0) for one in DISSIPATION)
        laws = Laws.of(eta, c_2, self.rubs)
        return Model.of(self.mechanism, own, self.excitation, laws)

    def only_for_a_force(self, question: str) -> None:
        """Raises ValueError where the question is asked of another excitation, for which it has no answer yet."""
        validate.is_force(question, self.excitation)

    def only_for_plain_damping(self, question: str) -> None:
        """Raises ValueError where other laws of damping than mu and zeta leave the question without an answer yet."""
        validate.is_plain(question, self.laws)

    def detachment(self, *, workers: int = 1) -> Detachments:
        """F_cr, Omega_cr and u_cr of every design; `Status.NONE` for a mechanism without breakpoints."""
        return Detachments(*self.ask(DETACHMENT, workers), _designs=self, _averaged=True)

    def saddle_node_onset(self, *, workers: int = 1) -> Onsets:
        """F_SN of every design, with its Omega and A."""
        return Onsets(*self.ask(ONSET, workers), _designs=self, _averaged=True)

    def saddle_nodes(self, F_0: Any, *, places: int = 6, workers: int = 1) -> Folds:
        """Every fold at F_0, which broadcasts with the designs; `Status.TOO_MANY` where they exceed `places`."""
        places = validate.count("places", places, least=1)
        return Folds(*self.ask(SADDLE_NODES, workers, F_0, places), _designs=self, _F_0=F_0, _averaged=True)

    def amplitudes(self, *, Omega: Any, F_0: Any, places: int = 6, workers: int = 1) -> States:
        """Every steady state at (Omega, F_0), which broadcast with the designs (24), (30).

        `Status.TOO_MANY` where they exceed `places`.
        """
        places = validate.count("places", places, least=1)
        A, stable, *rest = self.ask(AMPLITUDES, workers, F_0, places, Omega=Omega)
        self._leave_out_what_drifts(np.asarray(Omega, dtype=float)[..., np.newaxis], A, stable)
        return States(A, stable, *rest, _designs=self, _F_0=F_0, _Omega=Omega, _averaged=True)

    def _leave_out_what_drifts(self, Omega: Floats, A: Floats, stable: Codes) -> None:
        """States, along one more axis, are stable only if they stay about u = 0 as well."""
        with np.errstate(all="ignore"):  # a number outside its domain has a status, and no amplitude
            parameters = tuple(np.asarray(value) for value in self.mechanism.coefficients(*self.design))
            stable &= remarks.keep_centre(self.mechanism, parameters, Omega, A)

    def frequency_response(
        self,
        F_0: Any,
        *,
        samples: int = 1000,
        Omega: tuple[float, float] = validate.WINDOW,
        places: int = 6,
        workers: int = 1,
    ) -> Curves:
        """The response curve of every design at F_0, which broadcasts with them, in the window `Omega` (24), (30).

        `samples` as of a single `frequency_response`. The arrays are that long and 64 more: `Status.TOO_MANY` where a
        curve has more points, which has none then, or more folds than `places`. Some 25 bytes a point.
        """
        places = validate.count("places", places, least=1)
        question = curves(*validate.curve(samples, Omega))
        found, A, stable, *rest = self.ask(question, workers, F_0, places)
        self._leave_out_what_drifts(found, A, stable)
        return Curves(found, A, stable, *rest, _designs=self, _F_0=F_0, _averaged=True)

    def peak(self, F_0: Any, *, workers: int = 1) -> Peaks:
        """The highest peak at F_0, which broadcasts with the designs."""
        return Peaks(*self.ask(PEAK, workers, F_0), _designs=self, _F_0=F_0, _averaged=True)

    def certify(self, F_0: Any, *, Omega: Any = None, workers: int = 1) -> Proofs:
        """How many folds at F_0, or states at (Omega, F_0), are proved; both broadcast with the designs.

        What intervals of doubles leave undecided is asked of balls, as of single designs: one by one, with python-flint
        (`pip install 'slowflow[proofs]'`), some hundredths of a second each; these do not share `workers`.
        """
        self.only_for_a_force("certify")
        self.only_for_plain_damping("certify")
        columns = self.ask(PROVED_FOLDS if Omega is None else PROVED_STATES, workers, F_0, Omega=Omega)
        self._decide_in_balls(F_0, Omega, *columns)
        return Proofs(*columns, _designs=self, _F_0=F_0)

    def _decide_in_balls(
        self, F_0: Any, Omega: Any, count: Codes, proved: Codes, bits: npt.NDArray[np.int16], status: Codes
    ) -> None:
        """Change the columns where doubles do not decide, and balls are there."""
        left = (proved == 0) & (status != Status.INVALID) & (status != Status.NO_MEMORY)
        if importlib.util.find_spec("flint") is None or not left.any():
            return
        asked = [F_0] if Omega is None else [F_0, Omega]
        values = [np.broadcast_to(value, left.shape) for value in (*self.values.values(), *asked)]
        for at in map(tuple, np.argwhere(left)):
            *numbers, F = (float(value[at]) for value in values[: len(self.values) + 1])
            try:
                model = self.model(dict(zip(self.values, numbers, strict=True)))
                validate.number("F_0", F, above=0.0)
                found: Any
                if Omega is None:
                    found = proofs.saddle_nodes(model, F, np.empty(0))
                else:
                    (w,) = validate.frequencies("Omega", float(values[-1][at])).ravel()
                    found = proofs.amplitudes(model, float(w), F)
            except ValueError:
                status[at] = Status.INVALID
                continue
            if found.bits > DOUBLES:
                sticks = found.proved and found.message == words.sticks(model, F)
                count[at], proved[at], bits[at] = len(found.A), found.proved, found.bits
                status[at] = Status.STICKS if sticks else Status.OK

    def untruncated_onset(self, wanted: npt.NDArray[np.bool_]) -> Floats:
        """F_SN of the force that the truncated one stands for, for the designs that are wanted; NaN for others."""
        F_SN = np.full(self.shape, np.nan)
        load = self.mechanism.load_untruncated
        if load is not None and wanted.any():
            chosen = {name: np.broadcast_to(value, self.shape)[wanted] for name, value in self.values.items()}
            F_SN[wanted] = Designs(load(), chosen, self.excitation, self.rubs).saddle_node_onset().F_SN
        return F_SN

    def remarks(self, F_0: Any, Omega: Any, A: Any, corner: Any) -> remarks.Codes:
        """What to bear in mind with states of each design, along one more axis; see `remarks.of_designs`."""
        mu = np.asarray(self.values["mu"], dtype=float)
        with np.errstate(all="ignore"):  # a number outside its domain has a status, and no amplitude
            parameters = tuple(np.asarray(value) for value in self.mechanism.coefficients(*self.design))
            force = np.asarray(F_0)[..., np.newaxis]
            if self.excitation != "force":
                force = inertia.force(np.where(np.asarray(A) > 0, Omega, np.inf), force)
            return remarks.of_designs(self.mechanism, parameters, mu, force, Omega, A, corner, self.rubs)

    def spanned(
        self, x: str, y: str, of: str, values: Floats, beside: dict[str, Any]
    ) -> tuple[tuple[str, Floats], tuple[str, Floats], tuple[str, Floats]]:
        """Two parameters that span the designs and values over these, each with its name, for a map."""
        given = {**self.values, **beside}
        if values.ndim != 2 or x == y:
            raise ValueError(f"{of} over {x!r} and {y!r} is no map: a batch of two axes spanned by them is wanted")
        spread = {name: np.broadcast_to(np.asarray(value, dtype=float), values.shape) for name, value in given.items()}
        lines = {}
        for name in (x, y):
            along = spread[validate.choice("a parameter of the map", name, tuple(spread))]
            axis = 1 if np.array_equal(along, np.broadcast_to(along[:1], values.shape), equal_nan=True) else 0
            line = along[0] if axis == 1 else along[:, 0]
            if not np.array_equal(along, np.broadcast_to(line if axis else line[:, np.newaxis], values.shape)):
                raise ValueError(f"{name} is no axis of the map: it varies along both axes of the batch")
            lines[name] = axis, np.asarray(line)
        if lines[x][0] == lines[y][0]:
            raise ValueError(f"{x} and {y} vary along the same axis of the batch, or one of them does not vary")
        for name, value in spread.items():
            if name not in lines and not np.all((value == value.flat[0]) | np.isnan(value)):
                raise ValueError(f"{name} varies too: a map is over two parameters")
        return (x, lines[x][1]), (y, lines[y][1]), (of, values if lines[x][0] == 1 else values.T)

    def ask(
        self, question: Question, workers: int, F_0: Any = None, places: int = 0, Omega: Any = None
    ) -> list[npt.NDArray[Any]]:
        """The columns of the answer to a question; a question of its own is another depth's."""
        threads = validate.workers(workers)
        at = {name: value for name, value in (("F_0", F_0), ("Omega", Omega)) if value is not None}
        for name, value in at.items():
            if validate.is_labelled(value):
                raise ValueError(
                    f"{name} has named axes, or is cut into blocks: at least one number of the designs must too"
                )
        values = {**self.values, **{name: validate.real_array(name, value) for name, value in at.items()}}
        shape = validate.common_shape(values)
        outputs: list[npt.NDArray[Any]] = [np.empty((*shape, *inner), kind) for inner, kind in question.outputs(places)]
        told = outputs
        if question.one is None:  # a proof: bits of its arithmetic, before the status
            outputs[-2][...] = DOUBLES
            told = [*outputs[:-2], outputs[-1]]
        record = None
        if not self.laws and (self.excitation == "force" or question.by_inertia):
            record = backend.record_of(self.mechanism, inertial=self.excitation != "force")
        if question.batch is not None and backend.SOLVER is not None and record is not None:
            solve = question.batch(backend.SOLVER)(record)
            # what the solvers do not take as it is, long doubles
            doubles = (value if np.can_cast(value.dtype, float) else value.astype(float) for value in values.values())
            given = [np.broadcast_to(value, shape) for value in doubles]

            def part(block: tuple[slice | int, ...]) -> None:
                out = tuple(output[block] for output in told)
                solve(*(value[block] for value in given), out=out)

            share(part, _blocks(shape, question.at_once), threads)
        elif question.one is None:
            for output, value in zip(told, NO_PROOF, strict=True):
                output[...] = value
        else:
            self._loop(question.one, list(np.broadcast_arrays(*values.values())), len(at), places, outputs)
        return outputs

    def _loop(
        self, one: One, values: list[npt.NDArray[Any]], beside: int, places: int, outputs: list[npt.NDArray[Any]]
    ) -> None:
        """Design by design, on NumPy; the last `beside` of the values are F_0 and Omega."""
        for at in np.ndindex(values[0].shape):
            numbers = [float(value[at]) for value in values]
            size = len(numbers) - beside
            found = self._one(one, numbers[:size], numbers[size:], places)
            for output, value in zip(outputs, found, strict=True):
                output[at] = value

    def _one(self, one: One, given: list[float], asked: list[float], places: int) -> tuple[Any, ...]:
        """One design's answer, with the status of its failure in place of an exception."""
        blank = one(None, *asked, places)[:-1]
        try:
            model = self.model(dict(zip(self.values, given, strict=True)))
            oscillator = Averaged(model)
            if len(asked) > 1:
                validate.frequencies("Omega", asked[1])
            if asked and model.sticks(validate.number("F_0", asked[0], above=0.0)):
                return (*blank, Status.STICKS)
            return one(oscillator, *asked, places)
        except ValueError:
            return (*blank, Status.INVALID)
        except OverflowError:
            return (*blank, Status.NO_BOUND)
        except ArithmeticError:
            return (*blank, Status.UNRESOLVED)


def first_end(mechanism: Mechanism, parameters: tuple[Any, ...]) -> Floats:
    """The lowest |u| at which a piece of the force ends, of each of many designs; inf where there is one piece only."""
    found = np.full(np.broadcast_shapes(*(np.shape(value) for value in parameters)), math.inf)
    for end in reversed(mechanism.breakpoints(*parameters)):
        found = np.where(np.asarray(end) > 0, end, found)
    return found


# ---- designs in parts

#: designs of the first part, few enough where each takes as long as any, and seconds that a part is to take at most
FIRST_PART, TOO_LONG = 16, 0.4


def _blocks(shape: tuple[int, ...], most: int) -> Iterator[tuple[slice | int, ...]]:
    """Indices of parts of at most so many entries that make up an array of that shape.

    Who takes long over a part gets fewer entries next: between parts Ctrl-C is heard.
    """
    if not shape:
        yield (...,)  # type: ignore[misc]  # a view, where () would be the number itself
        return
    beyond = math.prod(shape[1:])
    if beyond > most:
        for k in range(shape[0]):
            for inner in _blocks(shape[1:], most):
                yield (k, *inner)
        return
    most_rows = most // max(beyond, 1)
    start, rows = 0, min(FIRST_PART, most_rows)
    while start < shape[0]:
        began = time.perf_counter()
        yield (slice(start, start + rows),)
        start += rows
        took = time.perf_counter() - began
        if took > TOO_LONG:
            rows = max(rows // 4, 1)
        elif took < TOO_LONG / 8:
            rows = min(4 * rows, most_rows)


def share(work: Callable[[Any], None], parts: Iterator[Any], threads: int) -> None:
    """The work on each part, which does not hold the interpreter's lock, by so many threads."""
    if threads == 1:
        for one in parts:
            work(one)
        return
    from concurrent.futures import ThreadPoolExecutor  # one thread is what most ask for

    with ThreadPoolExecutor(threads) as pool:
        try:
            for _ in pool.map(work, parts):
                pass
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
