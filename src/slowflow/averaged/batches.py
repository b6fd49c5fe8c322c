"""Results of batches: columns, diagnostics, gradients and tables.

Invalid designs, and designs without a result, have NaN. Their `status` gives the reason, as a code of
`slowflow_kernels.conventions.Status`; it is 0 for a result.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property, partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from slowflow.answers.answer import Answer, frozen, optional
from slowflow.answers.gradient import NO_GRADIENT, Gradient
from slowflow.answers.results import Remark
from slowflow.answers.sensitivities import NOT_AVERAGED, Design, of_isolation, of_points, of_states
from slowflow.answers.table import AVERAGING, QUESTIONS, Columns, Question
from slowflow.answers.transmissibility import in_motion
from slowflow.averaged import diagnostics, messages, solvers
from slowflow.averaged.isolating import Level
from slowflow.core import validate
from slowflow.core.mechanism import Flags
from slowflow.core.model import THROUGHOUT, Floats, SlowFlow
from slowflow.support.errors import Refused
from slowflow_kernels import slow_flow
from slowflow_kernels.conventions import FoldKind, OnsetKind, Status
from slowflow_kernels.domains import DAMPING, DISSIPATION

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

    # which columns an answer has, its row tells; four of them some answers compute
    OfDesigns = Columns
else:
    OfDesigns = object


class Batch(Answer, OfDesigns):
    """The answer to one question about many designs: its columns are attributes, each of the designs' shape.

    question, system -- the row of the table, and the system that answers it
    arguments        -- the arguments of the query, by name
    remarks          -- flags of `slowflow.Remark`, as in a single answer; computed on first use

    Columns with an axis after those of the designs, of entries, points or rows, are filled with NaN and 0 after the
    last one.
    """

    has_rows = True

    question: Question
    system: str
    arguments: Mapping[str, Any]
    _values: Mapping[str, npt.NDArray[Any]]
    _designs: Any
    _extra: Mapping[str, Any]

    def __init__(
        self,
        question: str,
        values: Mapping[str, npt.NDArray[Any]],
        designs: Any,
        arguments: Mapping[str, Any] = MappingProxyType({}),
        system: str = AVERAGING,
        **extra: Any,
    ) -> None:
        """Make an answer from its columns, in any order; `extra` may contain

        remarks  -- those of composed or single answers
        by_balls -- which designs were resolved in ball arithmetic
        lowest   -- of states and curves: the lowest frequency, if above 0
        escapes  -- for peaks, which designs have none because the response continues beyond a well
        """
        row = QUESTIONS[question]
        values = {name: frozen(values[name]) for name in row.columns[system]}
        # a column precedes what is computed where there is none
        self.__dict__.update(values, question=row, system=system, arguments=MappingProxyType(dict(arguments)))
        self.__dict__.update(_values=MappingProxyType(values), _designs=designs, _extra=extra)

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"answers are immutable: {name!r} cannot be set")

    def __reduce__(self) -> tuple[Any, ...]:
        own = self.question.name, dict(self._values), self._designs, dict(self.arguments), self.system
        return partial(type(self), **self._extra), own

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            raise self._without(name)

    def _without(self, name: str) -> validate.NoAttribute:
        values = self.__dict__.get("_values", {})  # not there yet while it is made
        return validate.NoAttribute(f"{name!r} is not a column of this answer: it has {', '.join(values)}")

    def __repr__(self) -> str:
        columns = ", ".join(f"{name}={value!r}" for name, value in self._values.items())
        return f"{type(self).__name__}({self.question.name!r}, {columns})"

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Batch) and (self.question, self.system) != (other.question, other.system):
            return False
        return super().__eq__(other)

    def __hash__(self) -> int:
        return super().__hash__()

    def _content(self) -> dict[str, Any]:
        return dict(self._values)

    @property
    def inner(self) -> Mapping[str, str]:
        """Which columns have an additional axis after those of the designs, and its name."""
        return {name: axis for name, axis in self.question.columns[self.system].items() if axis}

    def plot_map(self, x: str, y: str, of: str, ax: Axes | None = None) -> Axes:
        """Plot a number of each design over two parameters; return the Matplotlib axes, new ones by default.

        x, y -- names of parameters, "F_0", or for states "Omega": each varies along one axis of the batch, and nothing
                else varies
        of   -- a column, such as "F_SN"

        Designs without a result are grey. Raises ValueError for another name, and for a batch that is not such a grid.
        """
        from slowflow.answers import pictures

        numbers = [name for name, value in self._values.items() if value.dtype == float]
        values = np.asarray(getattr(self, validate.choice("of", of, tuple(numbers))))
        return pictures.design_map(ax, *spanned(self._inputs, x, y, of, values))

    # ---- tables

    @property
    def _inputs(self) -> dict[str, Any]:
        """The parameters of the designs and the arguments of the query, by name."""
        return {**self._designs.values, **{name: np.asarray(value) for name, value in self.arguments.items()}}

    def columns(self) -> dict[str, npt.NDArray[Any]]:
        """A row for each design, in the order of the flattened arrays: its parameters, then the numbers of the answer.

        An answer with several entries has a column for each, such as Omega_0. Curves have a row for each point of each
        design;
        their folds are columns of `saddle_nodes`.
        """
        return in_rows(self._inputs, self._values, self.inner)

    def to_xarray(self) -> xarray.Dataset:
        """Make a Dataset with dimensions "design_0" and so on; parameters, F_0 and Omega are coordinates.

        Several entries of an answer are an additional dimension. All units are "1", dimensionless. Raises ImportError
        without xarray.
        """
        return in_dataset(self._inputs, self._values, self.inner, {}, {"mechanism": self._designs.mechanism.name})

    def about(self) -> dict[str, Any]:
        """Return the mechanism, the shape of the designs, and where friction acts if not throughout."""
        friction = {} if self._designs.contact == THROUGHOUT else {"contact": self._designs.contact}
        return {"mechanism": self._designs.mechanism.name, "shape": self.status.shape, **friction}

    # ---- what follows from the columns

    @property
    def _F_0(self) -> Any:
        return self.arguments.get("F_0", np.nan)

    @property
    def _forcing(self) -> Floats:
        """Along the axis of places."""
        return np.asarray(self._F_0, dtype=float)[..., np.newaxis]

    @property
    def _frequency(self) -> Floats:
        """Of each state or point."""
        if self.question.name == "amplitudes":
            return np.asarray(self.arguments["Omega"], dtype=float)[..., np.newaxis]
        return self.Omega

    @cached_property
    def remarks(self) -> diagnostics.Codes:  # type: ignore[override]
        """Diagnostics of each design's answer, flags of `slowflow.Remark`, as in a single answer."""
        if (known := self._extra.get("remarks")) is not None:
            return frozen(known)
        found = np.where(self._has_remarks, self._designs.remarks(self._F_0, *_states(self)), np.uint16(0))
        for flags, remark in self._more_remarks():
            found = found | np.where(flags, np.uint16(remark), np.uint16(0))
        return frozen(found)

    def _more_remarks(self) -> Any:
        """The remarks on the answer itself, other than on its states."""
        escapes = self._extra.get("escapes", False)
        if self.question.name == "peak":
            yield (self._has_remarks & self._designs.give_way) | escapes, Remark.BEYOND_WELL
        if "at_rest" in self._values:
            yield self.at_rest, Remark.FOLDS_AT_REST
        yield self._extra.get("by_balls", False), Remark.BY_BALLS
        if "undecided" in self._values:
            yield self.undecided, Remark.UNDECIDED
            yield self._has_remarks & self._are_cut, Remark.CUT

    @property
    def _has_remarks(self) -> Flags:
        """Which designs may have remarks: those whose mass moves, or may."""
        designs = self._designs
        always = designs.excitation != "force" or getattr(designs, "contact", THROUGHOUT) != THROUGHOUT
        # a preload holds a mass up to more than friction does, beside motions of other frequencies
        with np.errstate(over="ignore"):  # infinite friction holds all
            exceeds = always | (np.asarray(self._F_0) > slow_flow.friction(np.asarray(designs.values["mu"])))
        return np.asarray((self.status != Status.INVALID) & ((self.status != Status.STICKS) | exceeds))

    @property
    def _are_cut(self) -> Any:
        """Whose response is cut where what lies beyond would be part of the answer, as `solvers.remark_of` has it."""
        with np.errstate(all="ignore"):  # a number outside its domain has a status
            flow = self._designs._flow
            cut = flow.undamped
            if solvers.may_be_cut(flow, self._extra.get("lowest", 0.0)):
                # what does not close has no peak, as what passes the top of a well has none
                peaks = self._designs.peak(self._F_0)
                cut = cut | ((peaks.status == Status.UNBOUNDED) & ~peaks._extra["escapes"])
            if self.question.name == "saddle_nodes":
                cut = cut & ((self.count > 0) | (self.undecided != 0) | messages.leaves_out(flow))
        return cut

    def gradient(self) -> Gradient:
        """Differentiate the numbers of each design's answer with respect to the parameters, as for a single answer.

        `.slopes` have shape (..., numbers, parameters), after the shape of the columns. Raises ValueError for answers
        that are not averaged or that combine others.
        """
        if (of := GRADIENTS.get(self.question.name)) is None:
            raise validate.NotAvailable(NO_GRADIENT)
        if self.system != AVERAGING:
            raise Refused(NOT_AVERAGED)
        return of(self, self._whose())

    def _whose(self) -> Design:
        """Whose answers these are."""
        designs = self._designs
        names = [one.name for one in (*DAMPING, *(DISSIPATION if designs.laws else ()))]
        damping = (np.asarray(designs.values.get(name, 0.0), dtype=float) for name in names)
        contact = designs.contact if designs.laws else None
        return Design(designs.mechanism, (*designs.design, *damping), designs.excitation, contact)

    def _has(self, name: str, *questions: str) -> None:
        """Raises NoAttribute where the answer has nothing of this name."""
        if self.question.name not in questions:
            raise self._without(name)

    @cached_property
    def phi(self) -> Floats:  # type: ignore[override]
        """Phase of u = A cos(Omega tau + phi) in radians, in [-pi, 0] (25); NaN for empty entries.

        For states and points of curves; computed on first use.
        """
        self._has("phi", *OF_STATES)
        with np.errstate(all="ignore"):  # empty places
            flow, h = self._balance
            return frozen(flow.phase(self._frequency, self.A, h))

    @cached_property
    def transmissibility(self) -> Floats:  # type: ignore[override]
        """Transmissibility, as in `SteadyStates`; NaN for empty entries."""
        self._has("transmissibility", *OF_STATES)
        with np.errstate(all="ignore"):  # empty places
            flow, h = self._balance
            return frozen(in_motion(self.A, flow.transmissibility(self._frequency, self.A, self._forcing, h)))

    @cached_property
    def transmissibility_dB(self) -> Floats:  # type: ignore[override]
        """`transmissibility` in decibels, 20 log10; -inf where nothing is transmitted."""
        with np.errstate(divide="ignore"):
            return np.asarray(20.0 * np.log10(self.transmissibility))

    @property
    def relative(self) -> Floats:
        """A over F_0, as in `SteadyStates`; NaN for empty entries."""
        self._has("relative", *OF_STATES)
        return np.asarray(self.A / self._forcing)

    @cached_property
    def untruncated(self) -> Floats:
        """F_SN of the untruncated force where the onset lies on a corner due to the truncation alone; NaN elsewhere.

        NaN also if the untruncated force has no onset. Computed on first use.
        """
        self._has("untruncated", "saddle_node_onset")
        return frozen(self._designs.untruncated_onset((self.remarks & Remark.OF_TRUNCATION) != 0))

    @cached_property
    def _balance(self) -> tuple[SlowFlow, Floats]:
        """The slow flows of the designs, and h at each place."""
        with np.errstate(all="ignore"):  # empty places
            flow = self._designs._flow.each(lambda number: number[..., np.newaxis])
            return flow, flow.averaged(self.A)[0]


def in_rows(
    numbers: Mapping[str, Any], values: Mapping[str, npt.NDArray[Any]], inner: Mapping[str, str]
) -> dict[str, npt.NDArray[Any]]:
    """Columns with a row for each design, or for each point of a curve, from parameters and from columns of an answer.

    inner -- which columns have an additional axis after those of the designs, and its name
    """
    shape = values["status"].shape
    if "point" in inner.values():
        here = ~np.isnan(values["A"])
        several = {name: np.asarray(value)[..., np.newaxis] for name, value in numbers.items()}
        found = {name: np.broadcast_to(value, here.shape)[here] for name, value in several.items()}
        return found | {name: values[name][here] for name, axis in inner.items() if axis == "point"}
    found = {name: np.broadcast_to(value, shape).ravel() for name, value in numbers.items()}
    for name, value in values.items():
        if value.ndim == len(shape):
            found[name] = value.ravel()
        else:
            found |= {f"{name}_{k}": place.ravel() for k, place in enumerate(np.moveaxis(value, -1, 0))}
    return found


def in_dataset(
    numbers: Mapping[str, Any],
    values: Mapping[str, npt.NDArray[Any]],
    inner: Mapping[str, str],
    units: Mapping[str, str],
    attributes: Mapping[str, Any],
) -> Any:
    """A Dataset of these columns, with the parameters as coordinates; without a unit they are dimensionless."""
    xarray = optional("xarray", "to_xarray")
    shape = values["status"].shape
    designs = tuple(f"design_{k}" for k in range(len(shape)))
    if "row" in inner.values():
        designs = (*designs[:-1], "row")
    of = {name: {"units": units.get(name, "1")} for name in (*numbers, *values)}
    coordinates = {name: (designs, np.broadcast_to(value, shape), of[name]) for name, value in numbers.items()}
    found = {
        name: ((*designs, inner[name]) if value.ndim > len(shape) else designs, value, of[name])
        for name, value in values.items()
    }
    return xarray.Dataset(found, coords=coordinates, attrs=attributes)


def spanned(
    known: Mapping[str, Any], x: str, y: str, of: str, values: Floats
) -> tuple[tuple[str, Floats], tuple[str, Floats], tuple[str, Floats]]:
    """Two parameters that span the designs, and values over these, each with its name, for a map."""
    if values.ndim != 2 or x == y:
        raise Refused(f"{of} over {x!r} and {y!r} is not a map: the batch must have two axes, spanned by them")
    spread = {name: np.broadcast_to(np.asarray(value, dtype=float), values.shape) for name, value in known.items()}
    lines = {}
    for name in (x, y):
        array = spread[validate.choice("a parameter of the map", name, tuple(spread))]
        axis = 1 if np.array_equal(array, np.broadcast_to(array[:1], values.shape), equal_nan=True) else 0
        line = array[0] if axis == 1 else array[:, 0]
        if not np.array_equal(array, np.broadcast_to(line if axis else line[:, np.newaxis], values.shape)):
            raise Refused(f"{name} is not an axis of the map: it varies along both axes of the batch")
        lines[name] = axis, np.asarray(line)
    if lines[x][0] == lines[y][0]:
        raise Refused(f"{x} and {y} vary along the same axis of the batch, or one of them does not vary")
    for name, value in spread.items():
        if name not in lines and not np.all((value == value.flat[0]) | np.isnan(value)):
            raise Refused(f"{name} varies too: a map is over two parameters")
    return (x, lines[x][1]), (y, lines[y][1]), (of, values if lines[x][0] == 1 else values.T)


#: questions about states
OF_STATES = ("amplitudes", "frequency_response")


def _states(found: Batch) -> tuple[Any, Any, Any]:
    """Omega and A of each design's states along one more axis, NaN for none, and of folds which are on a corner."""
    name, one = found.question.name, (..., np.newaxis)
    if name in OF_STATES:
        return found._frequency, found.A, None
    if name == "saddle_nodes":
        return found.Omega, found.A, _corner(found)
    if name == "detachment":
        return found.Omega_cr[one], found.u_cr[one], None
    if name in ("saddle_node_onset", "peak"):
        corner = None if name == "peak" else (found.kind == OnsetKind.CORNER)[one]
        return found.Omega[one], found.A[one], corner
    none = np.full((*found.status.shape, 1), np.nan)
    return none, none, None


def _corner(folds: Batch) -> Any:
    return folds.kind >= FoldKind.JUMP_UP_AT_CORNER


#: of averaged answers, by question
GRADIENTS: Mapping[str, Callable[[Batch, Design], Gradient]] = MappingProxyType(
    {
        "detachment": lambda one, of: of_points(of, "detachment", one.Omega_cr, one.u_cr, one.F_cr),
        "saddle_node_onset": lambda one, of: of_points(of, "saddle_node_onset", one.Omega, one.A, one.F_SN, one.kind),
        "saddle_nodes": lambda one, of: of_points(
            of.with_places(), "saddle_nodes", one.Omega, one.A, one._forcing, _corner(one)
        ),
        "amplitudes": lambda one, of: of_states(
            of.with_places(), one._frequency, one.A, one._forcing, one.phi, one.transmissibility
        ),
        "peak": lambda one, of: of_points(of, "peak", one.Omega, one.A, np.asarray(one._F_0, dtype=float)),
        "isolation": lambda one, of: of_isolation(
            *(of, one.Omega, one.A, np.asarray(one._F_0, dtype=float), one.at_fold == 1),
            Level.of(one.arguments.get("level_dB", 0.0)).ratio,
        ),
    }
)
