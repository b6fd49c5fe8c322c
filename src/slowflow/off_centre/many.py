"""Many designs off the centre: in go arrays of designs and loads that broadcast, out come the questions of `OffCentre`.

Each design is answered as a single one is, on NumPy, with the same digits: some hundredths to tenths of a second each.
One that has no answer, or is none, gets NaN and a status, as in `slowflow.averaged.many`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow import validate
from slowflow.answer import frozen
from slowflow.averaged import many, remarks
from slowflow.averaged.many import FOLD_KINDS, Batch, Codes
from slowflow.loaded import AT_CENTRE, off_centre_by
from slowflow.mechanism import Mechanism
from slowflow.model import THROUGHOUT, Floats
from slowflow.off_centre.questions import UNRESOLVED, OffCentre
from slowflow.results import Remark
from slowflow_kernels.conventions import OnsetKind, Status

#: a column's shape behind the designs', and its type
Column = tuple[tuple[int, ...], type]
One = Callable[..., tuple[Any, ...]]


@dataclass(frozen=True, eq=False)
class OffCentreBatch(Batch):
    """What answers off the centre share: `remarks` says of a design what the message of its single answer does."""

    _designs: Any = field(repr=False, kw_only=True)

    @cached_property
    def remarks(self) -> remarks.Codes:
        """`Remark.UNDECIDED` where it is undecided whether there are others."""
        undecided = np.broadcast_to(getattr(self, "undecided", False), self.status.shape)
        return frozen(np.where(undecided, np.uint8(Remark.UNDECIDED), np.uint8(0)))


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

    @cached_property
    def remarks(self) -> remarks.Codes:
        """`Remark.OF_TRUNCATION` where the onset is on a corner that only the truncation makes."""
        corner = (self.kind == OnsetKind.CORNER) & self._designs.mechanism.truncated
        return frozen(np.where(corner, np.uint8(Remark.OF_TRUNCATION), np.uint8(0)))


@dataclass(frozen=True, eq=False)
class ManyFolds(OffCentreBatch):
    """The folds at one forcing, for each design; Omega, A, B and kind have one more axis, with `places` places.

    Omega, A, B -- by rising Omega, then NaN
    kind        -- a number of `slowflow_kernels.conventions.FoldKind`; 0 in an empty place, and where the motions that
                   meet are both not stable
    count       -- how many folds there are, also where they are more than places
    undecided   -- 1 where it is undecided whether there are others
    """

    Omega: Floats
    A: Floats
    B: Floats
    kind: Codes
    count: Codes
    undecided: Codes
    status: Codes


@dataclass(frozen=True, eq=False)
class ManyStates(OffCentreBatch):
    """The steady states at one frequency and forcing, for each design; A, B, phi and stable have one more axis.

    A, B, phi -- by rising A, then NaN; phase in radians
    stable    -- 1 where F_A along the balance of the mean is positive, and the mean stiffness too
    count     -- how many states there are, also where they are more than places
    undecided -- 1 where it is undecided how many there are
    """

    A: Floats
    B: Floats
    phi: Floats
    stable: Codes
    count: Codes
    undecided: Codes
    status: Codes
    _Omega: Any = field(repr=False, kw_only=True)

    def _asked_at(self) -> dict[str, Any]:
        return {**super()._asked_at(), "Omega": np.asarray(self._Omega)}


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

    def __getattr__(self, name: str) -> Any:
        if name in CENTRED:
            raise validate.NotAvailable(AT_CENTRE.format(off_centre_by(self.mechanism, 0.0) or "with a load"))
        raise AttributeError(name)

    def spanned(self, x: str, y: str, of: str, values: Floats, beside: dict[str, Any]) -> Any:
        """As of `slowflow.averaged.many.Designs`."""
        return self._unloaded.spanned(x, y, of, values, {**beside, "load": self.values["load"]})

    def detachment(self, *, workers: int = 1) -> ManyDetachments:
        """F_cr of every design with its Omega, A and B; `Status.NONE` where no breakpoint is reached from inside."""
        return ManyDetachments(*self._asked(_detachment, [FLOAT] * 4, {}, workers), _designs=self)

    def saddle_node_onset(self, *, workers: int = 1) -> ManyOnsets:
        """F_SN of every design, with its Omega, A and B."""
        return ManyOnsets(*self._asked(_onset, [*[FLOAT] * 4, CODE], {}, workers), _designs=self)

    def saddle_nodes(self, F_0: Any, *, places: int = 6, workers: int = 1) -> ManyFolds:
        """Every fold at F_0, which broadcasts with the designs; `Status.TOO_MANY` where they exceed `places`."""
        places = validate.count("places", places, least=1)
        columns = [*[((places,), float)] * 3, ((places,), np.int8), CODE, CODE]
        found = self._asked(_folds, columns, {"F_0": F_0}, workers, places)
        return ManyFolds(*found, _designs=self, _F_0=F_0)

    def amplitudes(self, *, Omega: Any, F_0: Any, places: int = 6, workers: int = 1) -> ManyStates:
        """Every steady state at (Omega, F_0), which broadcast with the designs."""
        places = validate.count("places", places, least=1)
        columns = [*[((places,), float)] * 3, ((places,), np.int8), CODE, CODE]
        found = self._asked(_states, columns, {"F_0": F_0, "Omega": Omega}, workers, places)
        return ManyStates(*found, _designs=self, _F_0=F_0, _Omega=Omega)

    def _asked(
        self, one: One, columns: list[Column], at: dict[str, Any], workers: int, places: int = 0
    ) -> list[npt.NDArray[Any]]:
        """The columns of an answer, the status last; the solvers off the centre use one thread."""
        validate.workers(workers)
        values = {**self.values, **{name: validate.real_array(name, value) for name, value in at.items()}}
        shape = validate.common_shape(values)
        outputs: list[npt.NDArray[Any]] = [np.empty((*shape, *inner), kind) for inner, kind in (*columns, CODE)]
        for kept, (_, kind) in zip(outputs, columns, strict=False):
            kept[...] = np.nan if kind is float else 0
        given = list(np.broadcast_arrays(*values.values()))
        for place in np.ndindex(shape):
            *numbers, load = (float(value[place]) for value in given[: len(self.values)])
            asked = [float(value[place]) for value in given[len(self.values) :]]
            found, outputs[-1][place] = self._status(one, numbers, load, asked, places)
            for output, value in zip(outputs, found, strict=False):
                if output.ndim > len(shape):
                    output[place][: min(places, len(value))] = value[:places]
                else:
                    output[place] = value
        return outputs

    def _status(
        self, one: One, numbers: list[float], load: float, asked: list[float], places: int
    ) -> tuple[tuple[Any, ...], Status]:
        """One design's answer, and how it fared."""
        try:
            model = self._unloaded.model(dict(zip(self._unloaded.values, numbers, strict=True)))
            single = OffCentre(model, validate.number("load", load))
            if asked:
                validate.number("F_0", asked[0], above=0.0)
                validate.frequencies("Omega", asked[1:])
                if model.sticks(asked[0]):
                    return (), Status.STICKS
            if model.zeta == 0 and one is not _detachment:
                return (), Status.UNBOUNDED
            *found, status = one(single, *asked)
            too_many = places and len(found[0]) > places
            return tuple(found), Status.TOO_MANY if too_many else status
        except ValueError:
            return (), Status.INVALID
        except OverflowError:
            return (), Status.NO_BOUND
        except ArithmeticError:
            return (), Status.UNRESOLVED


#: questions about the centre that many designs have
CENTRED = frozenset(
    ("peak", "certify", "second_approximation", "margins", "hysteresis", "isolation", "spectrum", "shock_spectrum")
)
FLOAT: Column = ((), float)
CODE: Column = ((), np.int8)


def _detachment(single: OffCentre) -> tuple[Any, ...]:
    found = single.detachment()
    if found.F_cr is None:
        return (Status.NONE,)
    return found.F_cr, found.Omega_cr, found.A, found.B, Status.OK


def _onset(single: OffCentre) -> tuple[Any, ...]:
    found = single.saddle_node_onset()
    if found.F_SN is None:
        return (Status.UNRESOLVED if found.message == UNRESOLVED else Status.NONE,)
    return found.F_SN, found.Omega, found.A, found.B, OnsetKind[found.kind.upper()], Status.OK


def _folds(single: OffCentre, F_0: float) -> tuple[Any, ...]:
    found = single.saddle_nodes(F_0)
    kinds = [FOLD_KINDS.get((fold.kind, fold.corner), 0) for fold in found]
    return found.Omega, found.A, found.B, kinds, len(found), "undecided" in found.message, Status.OK


def _states(single: OffCentre, F_0: float, Omega: float) -> tuple[Any, ...]:
    found = single.amplitudes(Omega=Omega, F_0=F_0)
    return found.A, found.B, found.phi, found.stable, len(found), found.Omega_undecided.size > 0, Status.OK
