"""The questions about many designs: the query of one design, and its answer in the columns of the table.

In doubles alone, with an allowance of 0: what these leave undecided a batch asks balls afterwards.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType, ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow.averaged import solvers
from slowflow.averaged.proofs import Allowance
from slowflow.results import Remark
from slowflow.table import AVERAGING, MORE_POINTS, QUESTIONS
from slowflow_kernels.conventions import FoldKind, OnsetKind, Status

#: of single answers, by their words and whether on a corner
FOLD_KINDS = {
    ("jump-up", False): FoldKind.JUMP_UP,
    ("jump-down", False): FoldKind.JUMP_DOWN,
    ("jump-up", True): FoldKind.JUMP_UP_AT_CORNER,
    ("jump-down", True): FoldKind.JUMP_DOWN_AT_CORNER,
}
#: what a batch counts to; where rounding makes more of a curve's folds or states these are no answer
MOST_COUNTED = int(np.iinfo(np.int8).max)


def kinds(found: Any) -> Any:
    """Codes of an onset, or of each fold."""
    if isinstance(found.kind, str):
        return OnsetKind[found.kind.upper() or "NO"]
    return [FOLD_KINDS.get((fold.kind, fold.corner), 0) for fold in found]


def failed(error: Exception) -> Status:
    """How a design fared that was refused, or has no answer."""
    if isinstance(error, ValueError):
        return Status.INVALID
    return Status.NO_BOUND if isinstance(error, OverflowError) else Status.UNRESOLVED


def _is_undecided(found: Any) -> bool:
    """Whether it is not known how many there are, or some are lost."""
    return bool(getattr(found, "_lost", False)) or Remark.UNDECIDED in getattr(found, "remarks", Remark(0))


#: columns that a single answer has in words, or as remarks
CODED: Mapping[str, Callable[[Any], Any]] = MappingProxyType(
    {
        "kind": kinds,
        "count": len,
        "points": len,
        "undecided": _is_undecided,
        "at_rest": lambda found: Remark.FOLDS_AT_REST in found.remarks,
        "isola": lambda found: np.asarray(found.isola, dtype=np.int8)[found.branch],
    }
)


@dataclass(frozen=True)
class Question:
    """A question about many designs.

    name    -- that of its row
    one     -- the single answer of an averaged oscillator, from an allowance of balls, F_0 and Omega; with a curve its
               folds; None of a proof, which only the compiled solvers give in doubles
    batch   -- from the compiled solvers what gives the generalised ufunc of a record; None where designs are asked
               one by one
    at_once -- designs that take no more than some tenths of a second: until then Ctrl-C is not heard
    system  -- by what it is answered
    points  -- of a curve
    empty   -- the status where there is nothing at a forcing
    """

    name: str
    one: Callable[..., Any] | None
    batch: Callable[[ModuleType], Callable[[Any], Callable[..., Any]]] | None
    at_once: int
    system: str = AVERAGING
    points: int = 0
    empty: Status = Status.OK

    def blank(self, places: int, status: Status, shape: tuple[int, ...] = ()) -> dict[str, npt.NDArray[Any]]:
        """The columns with nothing in them."""
        columns = QUESTIONS[self.name].blank(self.system, shape, place=places, point=self.points)
        columns["status"][...] = status
        return columns

    def columns(self, found: Any, places: int) -> dict[str, npt.NDArray[Any]]:
        """The columns of a single answer; of a curve with its folds those of both."""
        if isinstance(found, tuple):
            curve, folds = found
            columns, of_folds = self.columns(curve, places), SADDLE_NODES.columns(folds, places)
            columns |= {f"fold_{name}": of_folds.pop(name) for name in ("Omega", "A", "kind")}
            if columns["status"] == Status.TOO_MANY:
                del of_folds["status"]
            of_folds["undecided"] |= columns["undecided"]
            if Remark.BY_BALLS in curve.remarks:
                of_folds["undecided"][...] = 0
            return columns | of_folds
        columns, axes = self.blank(places, Status.OK), QUESTIONS[self.name].columns[self.system]
        size, room = len(found) if any(axes.values()) else None, self.points or places
        if size is not None and size > MOST_COUNTED and not self.points:
            return self.blank(places, Status.UNRESOLVED)
        for name in columns.keys() - {"status", *(OF_FOLDS if self.points else ())}:
            value = CODED[name](found) if name in CODED else getattr(found, name)
            if not axes[name]:
                columns[name][...] = np.nan if value is None else value
            elif size is not None and not (self.points and size > room):
                columns[name][:size] = value[:room]
        if size is None:
            known = getattr(found, next(iter(columns))) is not None
            columns["status"][...] = Status.OK if known else getattr(found, "_status", Status.NONE)
        else:
            columns["status"][...] = Status.TOO_MANY if size > room else Status.OK if size else self.empty
        return columns


#: what a curve's columns have of its folds
OF_FOLDS = ("fold_Omega", "fold_A", "fold_kind", "count")


def _saddle_nodes(oscillator: Any, allowance: Allowance, F_0: float) -> Any:
    return oscillator.folds(F_0, allowance=allowance)


def _amplitudes(oscillator: Any, allowance: Allowance, F_0: float, Omega: float) -> Any:
    return oscillator.states(Omega=Omega, F_0=F_0, allowance=allowance)


def _peak(oscillator: Any, _: Allowance, F_0: float) -> Any:
    """That of doubles; where the response goes on beyond a well a batch looks again."""
    found = solvers.peak(oscillator.model, F_0)
    return replace(found, _status=Status.NONE) if found._escapes else found


def curves(samples: int, window: tuple[float, float]) -> Question:
    """The question about response curves of so many samples in a window of Omega."""
    n = samples + MORE_POINTS[AVERAGING]

    def one(oscillator: Any, allowance: Allowance, F_0: float) -> Any:
        found = oscillator.curve(F_0, samples=samples, Omega=window, allowance=allowance)
        return found, _saddle_nodes(oscillator, Allowance(0), F_0)

    def batch(native: ModuleType) -> Callable[[Any], Callable[..., Any]]:
        def of_record(record: Any) -> Callable[..., Any]:
            solve = native.many_frequency_response(record)
            return lambda *columns, out: solve(*columns, float(samples), *window, out=out)

        return of_record

    at_once = min(2**12, max(1, 2**22 // n))
    return Question("frequency_response", one, batch, at_once, points=n)


DETACHMENT = Question("detachment", lambda one, _: one.detachment(), lambda native: native.many_detachment, 2**18)
ONSET = Question("saddle_node_onset", lambda one, left: one.onset(left), lambda native: native.many_onset, 2**14)
SADDLE_NODES = Question("saddle_nodes", _saddle_nodes, lambda native: native.many_saddle_nodes, 2**12)
AMPLITUDES = Question("amplitudes", _amplitudes, lambda native: native.many_amplitudes, 2**11)
PEAK = Question("peak", _peak, lambda native: native.many_peak, 2**13)
PROVED_FOLDS = Question("certify", None, lambda native: native.many_proved_saddle_nodes, 2**10)
PROVED_STATES = Question("certify", None, lambda native: native.many_proved_amplitudes, 2**10)
#: by name
BY_NAME = {one.name: one for one in (DETACHMENT, ONSET, SADDLE_NODES, AMPLITUDES, PEAK)}
