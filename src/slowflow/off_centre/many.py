"""Many designs off the centre: in go arrays of designs and loads that broadcast, out come the questions of `OffCentre`.

Each design is answered as a single one is, on NumPy, with the same digits: some hundredths to tenths of a second each.
One that has no answer, or is none, gets NaN and a status, as in `slowflow.averaged.many`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial
from types import MappingProxyType
from typing import Any, ClassVar, TypeVar

import numpy as np
import numpy.typing as npt

from slowflow import loads, loads_many, progress, validate
from slowflow.averaged import batches, many
from slowflow.averaged.asked import FOLD_KINDS, MORE_POINTS
from slowflow.averaged.batches import Codes, Told
from slowflow.averaged.questions import Averaged
from slowflow.exact import questions, shocks_many
from slowflow.exact.transient import NO_PULSE
from slowflow.gradient import Gradient
from slowflow.loaded import AT_CENTRE, off_centre_by
from slowflow.loads import Spectrum
from slowflow.loads_many import ManySpectra
from slowflow.mechanism import EquationOfMotion, Force, Mechanism, followed
from slowflow.model import THROUGHOUT, Floats
from slowflow.off_centre.flow import Flow
from slowflow.off_centre.means import NO_MEANS, NOT_SMOOTH
from slowflow.off_centre.questions import OffCentre
from slowflow.results import InDecibels, Remark
from slowflow.unchanging import Unchanging
from slowflow.validate import NotAvailable
from slowflow_kernels.conventions import MovesStatus, OnsetKind, Status
from slowflow_kernels.domains import DAMPING, DISSIPATION
from slowflow_support.errors import Refused

NO_GRADIENT = (
    "off the centre states, folds, onsets, detachments, peaks, isolation and places of rest have gradients: this "
    "answer has none"
)
#: designs that are kept with what is known of them, some 0.2 MB each
KEPT = 256
#: one design's answer by column, how it fared, and what to bear in mind with it
Found = tuple[dict[str, Any], Status, Remark]
One = Callable[..., Found]
Batched = TypeVar("Batched", bound="OffCentreBatch")


@dataclass(frozen=True, eq=False)
class OffCentreBatch(Told):
    """What answers off the centre share: `remarks` are those of the single answers."""

    _designs: Any = field(repr=False, kw_only=True)
    #: the question to one design, and the numbers that move; of an answer that has no gradient none
    asks: ClassVar[str] = ""
    moves: ClassVar[tuple[str, ...]] = ()

    def gradient(self) -> Gradient:
        """How the numbers of the answer move with the parameters, the load, and what was asked at, for each design.

        `.slopes` have shape (..., numbers, parameters), behind the shape of the columns; they are those of the single
        answers, design by design, of which those that are not at hand any more are asked for again. Where there is no
        answer, and where a single one has no gradient, `.status` and `.message` say so. Of a peak the slopes of `u_max`
        are NaN where another motion has that, and those by eta and c_2 of designs that have neither.

        Raises NotAvailable where it is not known how the force moves with the design, and of an answer without one.
        """
        if not self.asks:
            raise NotAvailable(NO_GRADIENT)
        asked = self._asked_at()
        numbers = {**self._designs.values, **asked}
        given = dict(zip(numbers, np.broadcast_arrays(*numbers.values()), strict=True))
        laws = DISSIPATION if any(one.name in numbers for one in DISSIPATION) else ()
        by = (*self._designs.mechanism.design_names, *(one.name for one in (*DAMPING, *laws)), "load", *asked)
        columns = tuple(getattr(self, name) for name in self.moves)
        several = columns[0].ndim > self.status.ndim
        slopes = np.full((*columns[0].shape, len(self.moves), len(by)), np.nan)
        status = np.full(columns[0].shape, MovesStatus.NOTHING, np.int8)
        for place in progress.each(np.ndindex(self.status.shape), self.status.size):
            if self.status[place] not in (Status.OK, Status.TOO_MANY):
                continue
            single = self._designs._single(tuple(float(given[name][place]) for name in self._designs.values))
            answer = getattr(single, self.asks)(**{name: float(given[name][place]) for name in asked})
            if getattr(answer, "_turns", False):  # the peak is on the balance of another mean, too
                status[place] = MovesStatus.MEETS
                continue
            found = answer.gradient()
            own = (*place, slice(0, len(found.status))) if several else place
            kept = slice(0, status.shape[-1]) if several else ...
            for row, name in enumerate(self.moves):
                if name in found.of:
                    told = [by.index(parameter) for parameter in found.by]
                    slopes[(*own, row)][..., told] = found[name][kept]
            status[own] = found.status[kept]
        none = np.zeros(self.status.shape)
        at = tuple(given.get(name, none)[..., np.newaxis] if several else given.get(name, none) for name in by)
        return Gradient(self.moves, by, slopes, status, columns, at)


@dataclass(frozen=True, eq=False)
class ManyDetachments(OffCentreBatch):
    """The lowest forcing at which the motion comes to a breakpoint, for each design, as `OffCentreDetachment`."""

    asks: ClassVar[str] = "detachment"
    moves: ClassVar[tuple[str, ...]] = ("F_cr", "Omega_cr", "A", "B")

    F_cr: Floats
    Omega_cr: Floats
    A: Floats
    B: Floats
    status: Codes


@dataclass(frozen=True, eq=False)
class ManyOnsets(OffCentreBatch):
    """The lowest forcing for which a stable motion ends at a fold, for each design, as `OffCentreOnset`.

    kind   -- a number of `slowflow_kernels.conventions.OnsetKind`
    status -- `Status.UNRESOLVED` where the onset is undecided, `Status.NONE` where none is found
    """

    asks: ClassVar[str] = "saddle_node_onset"
    moves: ClassVar[tuple[str, ...]] = ("F_SN", "Omega", "A", "B")

    F_SN: Floats
    Omega: Floats
    A: Floats
    B: Floats
    kind: Codes
    status: Codes


@dataclass(frozen=True, eq=False)
class ManyFolds(OffCentreBatch):
    """The folds at one forcing, for each design; Omega, A, B and kind have one more axis, with `places` places.

    Omega, A, B -- by rising Omega, then NaN
    kind        -- a number of `slowflow_kernels.conventions.FoldKind`; 0 in an empty place, and where the motions that
                   meet are both not stable
    count       -- how many folds there are, also where they are more than places
    undecided   -- 1 where it is undecided whether there are others
    """

    asks: ClassVar[str] = "saddle_nodes"
    moves: ClassVar[tuple[str, ...]] = ("Omega", "A", "B")
    inner: ClassVar[Mapping[str, str]] = MappingProxyType(dict.fromkeys(("Omega", "A", "B", "kind"), "place"))

    Omega: Floats
    A: Floats
    B: Floats
    kind: Codes
    count: Codes
    undecided: Codes
    status: Codes


@dataclass(frozen=True, eq=False)
class ManyStates(InDecibels, OffCentreBatch):
    """The steady states at one frequency and forcing, for each design, with one more axis for these.

    A, B, phi, transmissibility -- by rising A, then NaN; phase in radians
    stable    -- 1 where F_A along the balance of the mean is positive, and the mean stiffness too
    count     -- how many states there are, also where they are more than places
    undecided -- 1 where it is undecided how many there are
    """

    asks: ClassVar[str] = "amplitudes"
    moves: ClassVar[tuple[str, ...]] = ("A", "B", "phi", "transmissibility")
    inner: ClassVar[Mapping[str, str]] = MappingProxyType(
        dict.fromkeys(("A", "B", "phi", "transmissibility", "stable"), "place")
    )

    A: Floats
    B: Floats
    phi: Floats
    transmissibility: Floats
    stable: Codes
    count: Codes
    undecided: Codes
    status: Codes
    _Omega: Any = field(repr=False, kw_only=True)

    def _asked_at(self) -> dict[str, Any]:
        return {**super()._asked_at(), "Omega": np.asarray(self._Omega)}


@dataclass(frozen=True, eq=False)
class OffCentreCurves(OffCentreBatch, batches.Curves):
    """The response curve at one forcing, for each design, with every fold at that forcing, as `Curves`, and B.

    B, phi, transmissibility -- mean displacement, phase and what is passed on of each point, then NaN
    """

    inner: ClassVar[Mapping[str, str]] = MappingProxyType(
        {**batches.Curves.inner, **dict.fromkeys(("B", "phi", "transmissibility"), "point")}
    )

    B: Floats = field(kw_only=True)
    phi: Floats = field(kw_only=True)
    transmissibility: Floats = field(kw_only=True)


@dataclass(frozen=True, eq=False)
class ManyRests(OffCentreBatch):
    """Where the mass of each design stands, as `RestPositions`; u and stiffness have one more axis.

    count -- how many places there are, also where they are more than places of the axis
    """

    inner: ClassVar[Mapping[str, str]] = MappingProxyType(dict.fromkeys(("u", "stiffness"), "place"))
    asks: ClassVar[str] = "rest"
    moves: ClassVar[tuple[str, ...]] = ("u", "stiffness")

    u: Floats
    stiffness: Floats
    count: Codes
    status: Codes


@dataclass(frozen=True, eq=False)
class ManyPeaks(OffCentreBatch):
    """How far motions at one forcing go, for each design, as `OffCentrePeak`."""

    asks: ClassVar[str] = "peak"
    moves: ClassVar[tuple[str, ...]] = ("A", "B", "Omega", "u_max")

    A: Floats
    B: Floats
    Omega: Floats
    u_max: Floats
    Omega_max: Floats
    status: Codes


@dataclass(frozen=True, eq=False)
class OffCentreMargins(OffCentreBatch, loads_many.ManyMargins):
    """`slowflow.loads.Margins` of each design, as `ManyMargins`; F_SN is NaN where the onset is undecided."""


@dataclass(frozen=True, eq=False)
class OffCentreBands(OffCentreBatch, loads_many.ManyBands):
    """`slowflow.loads.Hysteresis` of each design, as `ManyBands`."""


@dataclass(frozen=True, eq=False)
class OffCentreIsolations(OffCentreBatch, loads_many.ManyIsolations):
    """`OffCentreIsolation` of each design, as `ManyIsolations`; B is the mean displacement there."""

    asks: ClassVar[str] = "isolation"
    moves: ClassVar[tuple[str, ...]] = ("Omega", "A", "B")

    B: Floats = field(kw_only=True)


@dataclass(frozen=True, eq=False)
class OffCentreShocks(OffCentreBatch, shocks_many.Shocks):
    """What a half sine of the base does to each design, as `Shocks`.

    stands -- number of stable places of rest: the mass begins at that nearest to the centre
    """

    stands: Codes = field(kw_only=True)


@dataclass(frozen=True, eq=False)
class OffCentreTransients(OffCentreBatch, shocks_many.Transients):
    """What a shock of the base does to each design, as `Transients`; stands as of `OffCentreShocks`."""

    stands: Codes = field(kw_only=True)


class OffCentreDesigns(Unchanging):
    """Arrays of designs of one mechanism under static loads, and the questions off the centre about them.

    values -- as of `slowflow.averaged.many.Designs`, with "load"
    excitation -- as there; friction acts throughout

    `workers` changes nothing: these searches are Python, of which one thread at a time runs. What is to be shared is
    cut by who asks, or a grid's blocks on dask's processes.

    Raises TypeError and ValueError as that does, ValueError for a force that is no piecewise polynomial.
    """

    rubs = THROUGHOUT
    mechanism: Mechanism
    excitation: str
    values: dict[str, npt.NDArray[Any]]
    shape: tuple[int, ...]
    _unloaded: many.Designs
    _singles: dict[tuple[float, ...], OffCentre]

    def __init__(self, mechanism: Mechanism, values: dict[str, Any], excitation: str = "force") -> None:
        check_polynomial(mechanism)
        own = {name: value for name, value in values.items() if name != "load"}
        unloaded = many.Designs(mechanism, own, excitation)
        numbers = {**unloaded.values, "load": validate.real_array("load", values["load"])}
        # not by attribute: these cannot be set
        self.__dict__.update(mechanism=mechanism, excitation=excitation, values=numbers)
        self.__dict__.update(shape=validate.common_shape(numbers), _unloaded=unloaded, _singles={})

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, OffCentreDesigns):
            return NotImplemented
        return self._unloaded == other._unloaded and np.array_equal(
            self.values["load"], other.values["load"], equal_nan=True
        )

    def __hash__(self) -> int:
        return hash((self._unloaded, self.values["load"].tobytes()))

    def __getattr__(self, name: str) -> Any:
        if name in CENTRED:
            raise validate.NoAttribute(AT_CENTRE.format(off_centre_by(self.mechanism, 0.0) or "with a load"))
        why = ", a single oscillator has it" if hasattr(OffCentre, name) else ""
        raise AttributeError(f"many designs off the centre have no {name}{why}")

    def spanned(self, x: str, y: str, of: str, values: Floats, beside: dict[str, Any]) -> Any:
        """As of `slowflow.averaged.many.Designs`."""
        return self._unloaded.spanned(x, y, of, values, {**beside, "load": self.values["load"]})

    def rest(self, *, places: int = 3, workers: int = 1) -> ManyRests:
        """Every place of rest of each design, with the stiffness there."""
        return self._answered(ManyRests, _rest, {}, workers, places)

    def detachment(self, *, workers: int = 1) -> ManyDetachments:
        """F_cr of every design with its Omega, A and B; `Status.NONE` where no breakpoint is reached from inside.

        `Status.UNRESOLVED` where that is undecided.
        """
        return self._answered(ManyDetachments, _detachment, {}, workers, centred=many.Designs.detachment)

    def saddle_node_onset(self, *, workers: int = 1) -> ManyOnsets:
        """F_SN of every design, with its Omega, A and B."""
        return self._answered(ManyOnsets, _onset, {}, workers, centred=many.Designs.saddle_node_onset)

    def saddle_nodes(self, F_0: Any, *, places: int = 6, workers: int = 1) -> ManyFolds:
        """Every fold at F_0, which broadcasts with the designs; `Status.TOO_MANY` where they exceed `places`."""
        return self._answered(
            ManyFolds, _folds, {"F_0": F_0}, workers, places, centred=partial(many.Designs.saddle_nodes, places=places)
        )

    def amplitudes(self, *, Omega: Any, F_0: Any, places: int = 6, workers: int = 1) -> ManyStates:
        """Every steady state at (Omega, F_0), which broadcast with the designs."""
        return self._answered(
            ManyStates,
            _states,
            {"F_0": F_0, "Omega": Omega},
            workers,
            places,
            centred=partial(many.Designs.amplitudes, places=places),
        )

    def frequency_response(
        self,
        F_0: Any,
        *,
        samples: int = 1000,
        Omega: tuple[float, float] = validate.WINDOW,
        places: int = 6,
        workers: int = 1,
    ) -> OffCentreCurves:
        """The response curve of every design at F_0, which broadcasts with them, in the window `Omega`.

        Arrays and statuses as of `slowflow.averaged.many.Designs.frequency_response`. A second or so a design.
        """
        samples, window = validate.curve(samples, Omega)
        points = samples + MORE_POINTS
        one = partial(_curve, samples, window, points)
        centred = partial(many.Designs.frequency_response, samples=samples, Omega=window, places=places)
        return self._answered(OffCentreCurves, one, {"F_0": F_0}, workers, places, points=points, centred=centred)

    def peak(self, F_0: Any, *, workers: int = 1) -> ManyPeaks:
        """The largest amplitude and the largest |u| at F_0, which broadcasts with the designs."""
        return self._answered(ManyPeaks, _peak, {"F_0": F_0}, workers, centred=many.Designs.peak)

    def margins(self, F_0: Any, *, workers: int = 1) -> OffCentreMargins:
        """How far F_0, which broadcasts with the designs, is from F_SN and F_cr of each; see `Oscillator.margins`."""
        return self._answered(OffCentreMargins, _margins, {"F_0": F_0}, workers, centred=loads_many.margins)

    def hysteresis(self, F_0: Any, *, places: int = 3, workers: int = 1) -> OffCentreBands:
        """Bands with several stable motions at F_0, of each design; `Status.TOO_MANY` where they exceed `places`."""
        return self._answered(
            OffCentreBands, _bands, {"F_0": F_0}, workers, places, centred=partial(loads_many.hysteresis, places=places)
        )

    def isolation(self, F_0: Any, *, workers: int = 1) -> OffCentreIsolations:
        """The frequency from which on less than F_0 is transmitted, of each design; see `Oscillator.isolation`."""
        return self._answered(OffCentreIsolations, _isolation, {"F_0": F_0}, workers, centred=loads_many.isolation)

    def spectrum(self, *, Omega: Any, F_0: Any, workers: int = 1) -> ManySpectra:
        """A load spectrum, of each design, one tone at a time; see `slowflow.designs.Designs.spectrum`.

        Rows with several forcings take some tenths of a second each.
        """
        validate.workers(workers)
        asked = {"Omega": validate.real_array("Omega", Omega), "F_0": validate.real_array("F_0", F_0)}
        by_rows = {name: value[..., np.newaxis] for name, value in self.values.items()}
        rows = OffCentreDesigns(self.mechanism, by_rows, self.excitation)
        shape = validate.common_shape({**rows.values, **asked})
        numbers = [np.broadcast_to(value, shape[:-1]) for value in self.values.values()]
        tones = [np.broadcast_to(value, shape).astype(float) for value in asked.values()]
        columns: dict[str, Any] = {name: np.full(shape, np.nan) for name in ("A", "transmissibility_dB")}
        columns |= {name: np.zeros(shape, np.int8) for name in ("motions", "crosses", "detaches", "sticks")}
        status, said = np.full(shape, Status.INVALID, np.int8), np.zeros(shape, np.uint16)
        for place in progress.each(np.ndindex(shape[:-1]), math.prod(shape[:-1])):
            own = tuple(float(value[place]) for value in numbers)
            for run in _runs(*(tone[place] for tone in tones)):
                found, status[place][run] = self._tones(own, *(tone[place][run] for tone in tones))
                if found is None:
                    continue
                for name, column in columns.items():
                    column[place][run] = getattr(found, name)
                said[place][run] = found._remarks
                if run.start:  # what is crossed on the way from a row that is none is not known
                    status[place][run.start] = Status.INVALID
        of_rows: Any = rows
        return ManySpectra(**columns, status=status, _designs=of_rows, _F_0=F_0, _Omega=Omega, _said=said)

    def _tones(self, numbers: tuple[float, ...], Omega: Floats, F_0: Floats) -> tuple[Spectrum | None, Any]:
        """The rows of one design, and how they fared."""
        try:
            if self.mechanism.odd and numbers[-1] == 0:
                found = loads.spectrum(self._about_centre(numbers), Omega, F_0)
                return found, np.where(found.sticks, Status.STICKS, np.where(found.motions > 0, Status.OK, Status.NONE))
            single = self._single(numbers)
            if not Flow.of(single.model.unloaded).damps:
                return None, Status.UNBOUNDED
            found = single.spectrum(Omega=Omega, F_0=F_0)
        except (ValueError, ArithmeticError) as error:
            return None, _failed(error)
        return found, np.where(found.sticks, Status.STICKS, np.where(found.motions > 0, Status.OK, Status.NONE))

    def transient(
        self,
        *,
        acceleration: Any,
        duration: Any = None,
        tau: Any = None,
        after: float | None = None,
        workers: int = 1,
    ) -> OffCentreTransients:
        """What a shock of the base does to each design, from where it rests; as of `slowflow.designs.Designs`.

        Some hundredths of a second a design.
        """
        self._of_no_frequency("transient")
        if (duration is None) == (tau is None):
            raise Refused(NO_PULSE)
        if after is not None:
            after = validate.number("after", after, least=0.0)
        if tau is None:
            pulse = shocks_many.numbers(acceleration=acceleration, duration=duration)
            one = partial(_transient, after)
            return self._answered(OffCentreTransients, one, pulse, workers, beside={"_pulse": pulse})
        times, samples = shocks_many.samples(tau, acceleration)
        times, samples = np.broadcast_arrays(times, samples)
        which = np.arange(math.prod(times.shape[:-1]), dtype=float).reshape(times.shape[:-1])
        one = partial(_record, after, times.reshape(-1, times.shape[-1]), samples.reshape(-1, times.shape[-1]))
        return self._answered(OffCentreTransients, one, {"which": which}, workers, beside={"_pulse": {}})

    def shock_spectrum(self, *, acceleration: Any, duration: Any, workers: int = 1) -> OffCentreShocks:
        """What a half sine of the base does to each design: .A .a_max .ratio .detaches; both broadcast with these.

        Some hundredths of a second a design.
        """
        self._of_no_frequency("shock_spectrum")
        pulse = shocks_many.numbers(acceleration=acceleration, duration=duration)
        return self._answered(OffCentreShocks, _shock, pulse, workers, beside={"_pulse": pulse})

    def _of_no_frequency(self, question: str) -> None:
        """Raises NotAvailable where structural damping, which is stated at one frequency, has no motion in time."""
        if "eta" in self.values:
            raise NotAvailable(f"{question} is not available with eta: structural damping is stated at one frequency")

    def _answered(
        self,
        kind: type[Batched],
        one: One,
        at: dict[str, Any],
        workers: int,
        places: int | None = None,
        beside: dict[str, Any] | None = None,
        points: int = 0,
        centred: Callable[..., Any] | None = None,
    ) -> Batched:
        """Columns by the answer's fields, design by design; the solvers off the centre use one thread.

        places, points -- lengths of the axes of these
        beside -- what the answer holds of what was asked; by default `at`
        centred -- the same question to designs about the centre, which those without a load are; None where a load of 0
                  is answered as any other
        """
        validate.workers(workers)
        several = 0 if places is None else validate.count("places", places, least=1)
        asked = {name: validate.real_array(name, value) for name, value in at.items()}
        values = {**self.values, **asked}
        shape = validate.common_shape(values)
        lengths = {"place": several, "point": points}
        columns = {
            name: np.full(
                (*shape, *(lengths[axis] for axis in column.inner)), -1 if name == "branch" else 0, column.kind
            )
            for name, column in kind.layout().items()
            if name != "remarks"
        }
        for column in columns.values():
            if column.dtype == float:
                column[...] = np.nan
        said = np.zeros(shape, np.uint16)
        given = np.broadcast_arrays(*values.values())
        at_centre = np.zeros(shape, dtype=bool)
        if centred is not None and self.mechanism.odd:
            at_centre = np.broadcast_to(self.values["load"] == 0, shape)
            self._at_centre(centred, at_centre, dict(zip(values, given, strict=True)), workers, columns, said)
        for place in progress.each(map(tuple, np.argwhere(~at_centre)), int((~at_centre).sum())):
            numbers = tuple(float(value[place]) for value in given)
            own, there = numbers[: len(self.values)], dict(zip(at, numbers[len(self.values) :], strict=True))
            found, columns["status"][place], said[place] = self._status(one, own, there, several)
            for name, value in found.items():
                if name in kind.inner:
                    length = lengths[kind.inner[name]]
                    columns[name][place][: min(length, len(value))] = value[:length]
                else:
                    columns[name][place] = value
        if beside is None:
            beside = {f"_{name}": value for name, value in at.items()}
        return kind(**columns, **beside, _designs=self, _said=said)

    def _at_centre(
        self,
        ask: Callable[..., Any],
        where: npt.NDArray[np.bool_],
        given: dict[str, Any],
        workers: int,
        columns: dict[str, Any],
        said: npt.NDArray[np.uint16],
    ) -> None:
        """Change the columns of designs without a load to their answers about the centre, of mean 0.

        The single answer of such a design is that: motions that leave the centre by themselves are `.off_centre`'s.
        """
        if not where.any():
            return
        own = {name: value[where] for name, value in given.items()}
        asked = {name: own.pop(name) for name in tuple(own) if name not in self.values}
        del own["load"]
        answer = ask(many.Designs(self.mechanism, own, self.excitation), **asked, workers=workers)
        for name, column in columns.items():
            told = name if hasattr(answer, name) else AS_CENTRED.get(name, "A")
            if name == "B":  # 0 where there is a motion
                told = told if hasattr(answer, told) else "u_cr"
                column[where] = np.where(np.isnan(getattr(answer, told)), np.nan, 0.0)
            else:
                column[where] = getattr(answer, told)
        said[where] = answer.remarks

    def _status(self, one: One, numbers: tuple[float, ...], at: dict[str, float], places: int) -> Found:
        """One design's answer by column, how it fared, and what to bear in mind with it."""
        none: dict[str, Any] = {}
        try:
            single = self._single(numbers)
            if "F_0" in at:
                validate.number("F_0", at["F_0"], above=0.0)
                if "Omega" in at:
                    validate.frequencies("Omega", at["Omega"])
            moves = "F_0" in at or one is _onset
            damps = not moves or Flow.of(single.model.unloaded).damps
            if "F_0" in at and single.model.sticks(at["F_0"]) and one not in ((_margins, _states) if damps else ()):
                return none, Status.STICKS, Remark(0)
            if not damps:
                return none, Status.UNBOUNDED, Remark(0)
            found, status, said = one(single, *at.values())
            return found, Status.TOO_MANY if places and found["count"] > places else status, said
        except (ValueError, ArithmeticError) as error:
            return none, _failed(error), Remark(0)

    def _about_centre(self, numbers: tuple[float, ...]) -> Averaged:
        """One design without its load, which is 0."""
        return Averaged(self._unloaded.model(dict(zip(self._unloaded.values, numbers[:-1], strict=True))))

    def _single(self, numbers: tuple[float, ...]) -> OffCentre:
        """One design, which keeps for a while what it has been asked already. Raises ValueError for what is none."""
        if (known := self._singles.get(numbers)) is None:
            *own, load = numbers
            model = self._unloaded.model(dict(zip(self._unloaded.values, own, strict=True)))
            known = self._singles[numbers] = OffCentre(model, validate.number("load", load))
            if len(self._singles) > KEPT:
                self._singles.pop(next(iter(self._singles)), None)
        return known


def check_polynomial(mechanism: Mechanism) -> None:
    """Raises ValueError for a force that is not answered off the centre."""
    if mechanism.steps is None and mechanism.curved is None:
        raise validate.NotAvailable(f"load is not available for {mechanism.name}: {NO_MEANS.format(NOT_SMOOTH)}")


#: what a column is called of answers about the centre, where it has another name
AS_CENTRED = {"A": "u_cr", "u_max": "A", "Omega_max": "Omega"}
#: questions about the centre that many designs have
CENTRED = frozenset(("at_rest", "certify", "second_approximation"))


def _failed(error: Exception) -> Status:
    """How a design fared that was refused, or has no answer."""
    if isinstance(error, ValueError):
        return Status.INVALID
    return Status.NO_BOUND if isinstance(error, OverflowError) else Status.UNRESOLVED


def _runs(Omega: Floats, F_0: Floats) -> list[slice]:
    """Rows next to each other that are tones."""
    with np.errstate(invalid="ignore"):
        allowed = np.isfinite(Omega) & np.isfinite(F_0) & (Omega > 0) & (F_0 > 0)
    ends = np.flatnonzero(np.diff(np.concatenate(([False], allowed, [False])))).reshape(-1, 2)
    return [slice(*pair) for pair in ends.tolist()]


def _columns(found: Any, *names: str) -> dict[str, Any]:
    return {name: getattr(found, name) for name in names}


def _rest(single: OffCentre) -> Found:
    found = single.rest()
    return {**_columns(found, "u", "stiffness"), "count": len(found)}, Status.OK, found.remarks


def _detachment(single: OffCentre) -> Found:
    found = single.detachment()
    if found.F_cr is None:
        return {}, _none(found), found.remarks
    return _columns(found, "F_cr", "Omega_cr", "A", "B"), Status.OK, found.remarks


def _onset(single: OffCentre) -> Found:
    found = single.saddle_node_onset()
    if found.F_SN is None:
        return {}, _none(found), found.remarks
    columns = _columns(found, "F_SN", "Omega", "A", "B")
    return {**columns, "kind": OnsetKind[found.kind.upper()]}, Status.OK, found.remarks


def _none(found: Any) -> Status:
    """Of an onset or a detachment without a forcing."""
    return Status.UNRESOLVED if Remark.UNDECIDED in found.remarks else Status.NONE


def _folds(single: OffCentre, F_0: float) -> Found:
    found = single.saddle_nodes(F_0)
    columns = _columns(found, "Omega", "A", "B")
    columns["kind"] = [FOLD_KINDS.get((fold.kind, fold.corner), 0) for fold in found]
    columns |= {"count": len(found), "undecided": Remark.UNDECIDED in found.remarks}
    return columns, Status.OK, found.remarks


def _curve(samples: int, window: tuple[float, float], most: int, single: OffCentre, F_0: float) -> Found:
    """A curve with more points than that has none."""
    folds, status, said = _folds(single, F_0)
    columns = {name if name in ("count", "undecided") else f"fold_{name}": value for name, value in folds.items()}
    del columns["fold_B"]
    found = single.frequency_response(F_0, samples=samples, Omega=window)
    columns["points"] = len(found)
    if len(found) > most:
        return columns, Status.TOO_MANY, said
    columns |= _columns(found, "Omega", "A", "B", "phi", "transmissibility", "stable", "branch")
    columns["isola"] = np.asarray(found.isola, dtype=np.int8)[found.branch]
    return columns, status, said | found.remarks


def _states(single: OffCentre, F_0: float, Omega: float) -> Found:
    found = single.amplitudes(Omega=Omega, F_0=F_0)
    columns = _columns(found, "A", "B", "phi", "transmissibility", "stable")
    columns |= {"count": len(found), "undecided": Remark.UNDECIDED in found.remarks}
    return columns, Status.OK if found.A.any() or not len(found) else Status.STICKS, found.remarks


def _peak(single: OffCentre, F_0: float) -> Found:
    found = single.peak(F_0)
    if found.A is None:  # as an excitation by inertia may have it
        return {}, Status.NONE, found.remarks
    return _columns(found, "A", "B", "Omega", "u_max", "Omega_max"), Status.OK, found.remarks


def _margins(single: OffCentre, F_0: float) -> Found:
    found, onset = single.margins(F_0), single.saddle_node_onset()
    missing = {
        "F_SN": math.nan if Remark.UNDECIDED in onset.remarks else math.inf,
        "F_cr": math.inf,
    }
    missing |= {f"of_{name[2:]}": value for name, value in missing.items()}
    columns = {name: known if (known := getattr(found, name)) is not None else one for name, one in missing.items()}
    columns |= _columns(found, "folds", "detaches", "sticks", "Omega_sticks")
    columns["kind"] = OnsetKind[found.kind.upper()] if found.kind else OnsetKind.NO
    columns["onset"] = Status.OK if onset.F_SN is not None else _none(onset)
    return columns, Status.OK, found.remarks


def _bands(single: OffCentre, F_0: float) -> Found:
    found = single.hysteresis(F_0)
    columns = _columns(found, "Omega_low", "Omega_high", "motions")
    return {**columns, "count": len(found)}, Status.OK, single.saddle_nodes(F_0).remarks


def _isolation(single: OffCentre, F_0: float) -> Found:
    found = single.isolation(F_0)
    if found.Omega is None:
        return {}, Status.NONE, found.remarks
    A, B = (math.nan if one is None else one for one in (found.A, found.B))
    return {"Omega": found.Omega, "A": A, "B": B, "at_fold": found.at_fold}, Status.OK, found.remarks


def _shocked(single: OffCentre) -> tuple[EquationOfMotion, int]:
    """The equation of motion of a design, and how many stable places of rest it has."""
    model = single.model
    force = followed(Force.of(model.mechanism, model.parameters), model.mechanism.name)
    system = EquationOfMotion(force, model.mu, model.zeta, load=single.load, c_2=model.laws.c_2)
    begins_at_centre = system.centred and questions.rests_at_centre(system)
    return system, 1 if begins_at_centre else int(single.rest().stable.sum())


def _of_shock(single: OffCentre, found: Any, stands: int, *names: str) -> Found:
    columns = {name: np.nan if (value := getattr(found, name)) is None else value for name in names}
    beyond = found.A > single.model.reach
    return {**columns, "stands": stands}, Status.OK, Remark.BEYOND_REACH if beyond else Remark(0)


def _transient(after: float | None, single: OffCentre, acceleration: float, duration: float) -> Found:
    system, stands = _shocked(single)
    found = questions.transient(single, system, acceleration, duration, None, after)
    return _of_shock(single, found, stands, *TRANSIENT)


def _record(after: float | None, tau: Floats, acceleration: Floats, single: OffCentre, which: float) -> Found:
    system, stands = _shocked(single)
    row = int(which)
    found = questions.transient(single, system, acceleration[row], None, tau[row], after)
    return _of_shock(single, found, stands, *TRANSIENT)


def _shock(single: OffCentre, acceleration: float, duration: float) -> Found:
    system, stands = _shocked(single)
    (pulse,) = questions.shocks(single, system, acceleration, duration)
    return _of_shock(single, pulse, stands, "A", "a_max", "ratio", "detaches")


#: columns of `Transients`
TRANSIENT = ("A", "tau_A", "a_max", "tau_a", "detaches", "tau_detaches", "rests", "u_end")
