"""Many designs off the centre: in go arrays of designs and loads that broadcast, out come the questions of `OffCentre`.

Each design is answered as a single one is, on NumPy, with the same digits: some hundredths to tenths of a second each.
One that has no answer, or is none, gets NaN and a status, as in `slowflow.averaged.many`.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, ClassVar, TypeVar

import numpy as np

from slowflow import loads_many, validate
from slowflow.answer import frozen
from slowflow.averaged import many, remarks
from slowflow.averaged.asked import FOLD_KINDS
from slowflow.averaged.many import Batch, Codes
from slowflow.loaded import AT_CENTRE, off_centre_by
from slowflow.mechanism import Mechanism
from slowflow.model import THROUGHOUT, Floats
from slowflow.off_centre.questions import OffCentre
from slowflow.results import Remark
from slowflow_kernels.conventions import OnsetKind, Status

#: one design's answer by column, how it fared, and what to bear in mind with it
Found = tuple[dict[str, Any], Status, Remark]
One = Callable[..., Found]
Batched = TypeVar("Batched", bound="OffCentreBatch")


@dataclass(frozen=True, eq=False)
class OffCentreBatch(Batch):
    """What answers off the centre share: `remarks` are those of the single answers.

    placed -- which columns have one more axis, with a place for each state, fold or band
    """

    placed: ClassVar[tuple[str, ...]] = ()

    _remarks: remarks.Codes = field(repr=False, kw_only=True)
    _designs: Any = field(repr=False, kw_only=True)

    @cached_property
    def remarks(self) -> remarks.Codes:
        """What to bear in mind with each design's answer, sums of `slowflow.results.Remark`."""
        return frozen(self._remarks)


@dataclass(frozen=True, eq=False)
class ManyDetachments(OffCentreBatch):
    """The lowest forcing at which the motion comes to a breakpoint, for each design, as `OffCentreDetachment`."""

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

    placed: ClassVar[tuple[str, ...]] = ("Omega", "A", "B", "kind")

    Omega: Floats
    A: Floats
    B: Floats
    kind: Codes
    count: Codes
    undecided: Codes
    status: Codes


@dataclass(frozen=True, eq=False)
class ManyStates(OffCentreBatch):
    """The steady states at one frequency and forcing, for each design, with one more axis for these.

    A, B, phi, transmissibility -- by rising A, then NaN; phase in radians
    stable    -- 1 where F_A along the balance of the mean is positive, and the mean stiffness too
    count     -- how many states there are, also where they are more than places
    undecided -- 1 where it is undecided how many there are
    """

    placed: ClassVar[tuple[str, ...]] = ("A", "B", "phi", "transmissibility", "stable")

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
class ManyRests(OffCentreBatch):
    """Where the mass of each design stands, as `RestPositions`; u and stiffness have one more axis.

    count -- how many places there are, also where they are more than places of the axis
    """

    placed: ClassVar[tuple[str, ...]] = ("u", "stiffness")

    u: Floats
    stiffness: Floats
    count: Codes
    status: Codes


@dataclass(frozen=True, eq=False)
class ManyPeaks(OffCentreBatch):
    """How far motions at one forcing go, for each design, as `OffCentrePeak`."""

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

    placed: ClassVar[tuple[str, ...]] = ("Omega_low", "Omega_high", "motions")


@dataclass(frozen=True, eq=False)
class OffCentreIsolations(OffCentreBatch, loads_many.ManyIsolations):
    """`slowflow.loads.Isolation` of each design, as `ManyIsolations`."""


class OffCentreDesigns:
    """Arrays of designs of one mechanism under static loads, and the questions off the centre about them.

    values -- as of `slowflow.averaged.many.Designs`, with "load"

    Raises TypeError and ValueError as that does, ValueError for an excitation by inertia, for other laws of damping
    than mu and zeta, and for a force that is no piecewise polynomial.
    """

    excitation, rubs = "force", THROUGHOUT

    def __init__(self, mechanism: Mechanism, values: dict[str, Any]) -> None:
        if mechanism.steps is None:
            raise validate.NotAvailable(f"load is not available for {mechanism.name}: its force is no polynomial")
        self._unloaded = many.Designs(mechanism, {name: value for name, value in values.items() if name != "load"})
        self.mechanism = mechanism
        self.values = {**self._unloaded.values, "load": validate.real_array("load", values["load"])}
        self.shape = validate.common_shape(self.values)
        self._singles: dict[tuple[float, ...], OffCentre] = {}

    def __getattr__(self, name: str) -> Any:
        if name in CENTRED:
            raise validate.NotAvailable(AT_CENTRE.format(off_centre_by(self.mechanism, 0.0) or "with a load"))
        why = ", a single oscillator has it" if hasattr(OffCentre, name) else ""
        raise AttributeError(f"many designs off the centre have no {name}{why}")

    def spanned(self, x: str, y: str, of: str, values: Floats, beside: dict[str, Any]) -> Any:
        """As of `slowflow.averaged.many.Designs`."""
        return self._unloaded.spanned(x, y, of, values, {**beside, "load": self.values["load"]})

    def rest(self, *, places: int = 3, workers: int = 1) -> ManyRests:
        """Every place of rest of each design, with the stiffness there."""
        return self._answered(ManyRests, _rest, {}, workers, places)

    def detachment(self, *, workers: int = 1) -> ManyDetachments:
        """F_cr of every design with its Omega, A and B; `Status.NONE` where no breakpoint is reached from inside."""
        return self._answered(ManyDetachments, _detachment, {}, workers)

    def saddle_node_onset(self, *, workers: int = 1) -> ManyOnsets:
        """F_SN of every design, with its Omega, A and B."""
        return self._answered(ManyOnsets, _onset, {}, workers)

    def saddle_nodes(self, F_0: Any, *, places: int = 6, workers: int = 1) -> ManyFolds:
        """Every fold at F_0, which broadcasts with the designs; `Status.TOO_MANY` where they exceed `places`."""
        return self._answered(ManyFolds, _folds, {"F_0": F_0}, workers, places)

    def amplitudes(self, *, Omega: Any, F_0: Any, places: int = 6, workers: int = 1) -> ManyStates:
        """Every steady state at (Omega, F_0), which broadcast with the designs."""
        return self._answered(ManyStates, _states, {"F_0": F_0, "Omega": Omega}, workers, places)

    def peak(self, F_0: Any, *, workers: int = 1) -> ManyPeaks:
        """The largest amplitude and the largest |u| at F_0, which broadcasts with the designs."""
        return self._answered(ManyPeaks, _peak, {"F_0": F_0}, workers)

    def margins(self, F_0: Any, *, workers: int = 1) -> OffCentreMargins:
        """How far F_0, which broadcasts with the designs, is from F_SN and F_cr of each; see `Oscillator.margins`."""
        return self._answered(OffCentreMargins, _margins, {"F_0": F_0}, workers)

    def hysteresis(self, F_0: Any, *, places: int = 3, workers: int = 1) -> OffCentreBands:
        """Bands with several stable motions at F_0, of each design; `Status.TOO_MANY` where they exceed `places`."""
        return self._answered(OffCentreBands, _bands, {"F_0": F_0}, workers, places)

    def isolation(self, F_0: Any, *, workers: int = 1) -> OffCentreIsolations:
        """The frequency from which on less than F_0 is transmitted, of each design; see `Oscillator.isolation`."""
        return self._answered(OffCentreIsolations, _isolation, {"F_0": F_0}, workers)

    def _answered(
        self, kind: type[Batched], one: One, at: dict[str, Any], workers: int, places: int | None = None
    ) -> Batched:
        """Columns by the answer's fields, design by design; the solvers off the centre use one thread."""
        validate.workers(workers)
        several = 0 if places is None else validate.count("places", places, least=1)
        asked = {name: validate.real_array(name, value) for name, value in at.items()}
        values = {**self.values, **asked}
        shape = validate.common_shape(values)
        columns = {
            field.name: np.zeros((*shape, several) if field.name in kind.placed else shape, TYPES[str(field.type)])
            for field in dataclasses.fields(kind)
            if str(field.type) in TYPES and field.name != "_remarks"
        }
        for column in columns.values():
            if column.dtype == float:
                column[...] = np.nan
        said = np.zeros(shape, np.uint8)
        given = np.broadcast_arrays(*values.values())
        for place in np.ndindex(shape):
            numbers = tuple(float(value[place]) for value in given)
            found, columns["status"][place], said[place] = self._status(one, numbers, several)
            for name, value in found.items():
                if name in kind.placed:
                    columns[name][place][: min(several, len(value))] = value[:several]
                else:
                    columns[name][place] = value
        beside = {f"_{name}": value for name, value in at.items()}
        return kind(**columns, **beside, _designs=self, _remarks=said)

    def _status(self, one: One, numbers: tuple[float, ...], places: int) -> Found:
        """One design's answer by column, how it fared, and what to bear in mind with it."""
        none: dict[str, Any] = {}
        count = len(self.values)
        try:
            single, asked = self._single(numbers[:count]), numbers[count:]
            if asked:
                validate.number("F_0", asked[0], above=0.0)
                validate.frequencies("Omega", asked[1:])
                if single.model.sticks(asked[0]) and one is not _margins:
                    return none, Status.STICKS, Remark(0)
            if single.model.zeta == 0 and one not in (_detachment, _rest):
                return none, Status.UNBOUNDED, Remark(0)
            found, status, said = one(single, *asked)
            return found, Status.TOO_MANY if places and found["count"] > places else status, said
        except ValueError:
            return none, Status.INVALID, Remark(0)
        except OverflowError:
            return none, Status.NO_BOUND, Remark(0)
        except ArithmeticError:
            return none, Status.UNRESOLVED, Remark(0)

    def _single(self, numbers: tuple[float, ...]) -> OffCentre:
        """One design, which keeps what it has been asked already. Raises ValueError for what is none."""
        if (known := self._singles.get(numbers)) is None:
            *own, load = numbers
            model = self._unloaded.model(dict(zip(self._unloaded.values, own, strict=True)))
            known = self._singles[numbers] = OffCentre(model, validate.number("load", load))
        return known


#: questions about the centre that many designs have
CENTRED = frozenset(("certify", "second_approximation", "spectrum", "transient", "shock_spectrum"))
#: of which type a column is
TYPES = {"Floats": float, "Codes": np.int8}


def _columns(found: Any, *names: str) -> dict[str, Any]:
    return {name: getattr(found, name) for name in names}


def _rest(single: OffCentre) -> Found:
    found = single.rest()
    return {**_columns(found, "u", "stiffness"), "count": len(found)}, Status.OK, found.remarks


def _detachment(single: OffCentre) -> Found:
    found = single.detachment()
    if found.F_cr is None:
        return {}, Status.NONE, found.remarks
    return _columns(found, "F_cr", "Omega_cr", "A", "B"), Status.OK, found.remarks


def _onset(single: OffCentre) -> Found:
    found = single.saddle_node_onset()
    if found.F_SN is None:
        return {}, Status.UNRESOLVED if Remark.UNDECIDED in found.remarks else Status.NONE, found.remarks
    columns = _columns(found, "F_SN", "Omega", "A", "B")
    return {**columns, "kind": OnsetKind[found.kind.upper()]}, Status.OK, found.remarks


def _folds(single: OffCentre, F_0: float) -> Found:
    found = single.saddle_nodes(F_0)
    columns = _columns(found, "Omega", "A", "B")
    columns["kind"] = [FOLD_KINDS.get((fold.kind, fold.corner), 0) for fold in found]
    columns |= {"count": len(found), "undecided": Remark.UNDECIDED in found.remarks}
    return columns, Status.OK, found.remarks


def _states(single: OffCentre, F_0: float, Omega: float) -> Found:
    found = single.amplitudes(Omega=Omega, F_0=F_0)
    columns = _columns(found, "A", "B", "phi", "transmissibility", "stable")
    columns |= {"count": len(found), "undecided": Remark.UNDECIDED in found.remarks}
    return columns, Status.OK, found.remarks


def _peak(single: OffCentre, F_0: float) -> Found:
    found = single.peak(F_0)
    return _columns(found, "A", "B", "Omega", "u_max", "Omega_max"), Status.OK, found.remarks


def _margins(single: OffCentre, F_0: float) -> Found:
    found, onset = single.margins(F_0), single.saddle_node_onset()
    missing = {
        "F_SN": math.nan if Remark.UNDECIDED in onset.remarks else math.inf,
        "F_cr": math.inf,
    }
    missing |= {f"of_{name[2:]}": value for name, value in missing.items()}
    columns = {name: known if (known := getattr(found, name)) is not None else one for name, one in missing.items()}
    return {**columns, **_columns(found, "folds", "detaches", "sticks")}, Status.OK, onset.remarks


def _bands(single: OffCentre, F_0: float) -> Found:
    found = single.hysteresis(F_0)
    columns = _columns(found, "Omega_low", "Omega_high", "motions")
    return {**columns, "count": len(found)}, Status.OK, single.saddle_nodes(F_0).remarks


def _isolation(single: OffCentre, F_0: float) -> Found:
    found = single.isolation(F_0)
    if found.Omega is None:
        return {}, Status.NONE, Remark(0)
    A = math.nan if found.A is None else found.A
    return {"Omega": found.Omega, "A": A, "at_fold": found.at_fold}, Status.OK, Remark(0)
