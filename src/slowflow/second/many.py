"""Many designs in the second approximation: in go arrays of designs, out come critical forcings, folds and peaks.

The answers are those of `slowflow.averaged.many`, with the largest displacement as A. A design has the status
`Status.NONE` where the second approximation has no answer though averaging may have one, as where its harmonics are not
small, and `Status.INVALID` also where the harmonics of its force are not derived. Designs that are excited by inertia
are answered one by one, on NumPy.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from slowflow import validate
from slowflow.averaged import asked
from slowflow.averaged.many import Designs, Detachments, Folds, Onsets, Peaks
from slowflow.averaged.questions import Averaged
from slowflow.results import Remark
from slowflow.second.questions import SecondApproximation
from slowflow_kernels.conventions import OnsetKind, Status

#: why a question about designs has no answer here, where it has one of averaging
UNANSWERED = {
    "certify": "nothing is proved of the second approximation",
    "amplitudes": "a batch has no states of the second approximation, ask a single oscillator",
    "frequency_response": "a batch has no curves of the second approximation, ask a single oscillator",
    **dict.fromkeys(("margins", "hysteresis", "isolation", "spectrum"), "it is put together from averaging's answers"),
    **dict.fromkeys(("at_rest", "transient", "shock_spectrum"), "it is asked of the designs, at each depth the same"),
}


@dataclass(frozen=True)
class SecondDesigns:
    """The questions of many designs in the second approximation; `.second_approximation` of designs makes it.

    `workers` as of the designs.

    first -- the designs, averaged
    """

    first: Designs

    def __getattr__(self, name: str) -> Any:
        """Raises AttributeError, with the reason where averaging answers the question of that name."""
        why = f": {UNANSWERED[name]}" if name in UNANSWERED else ""
        raise AttributeError(f"the second approximation of many designs has no {name}{why}")

    def detachment(self, *, workers: int = 1) -> Detachments:
        """The lowest forcing whose largest displacement is u_cr, and its frequency, of every design."""
        return Detachments(*self.first.ask(DETACHMENT, workers), _designs=self.first)

    def saddle_node_onset(self, *, workers: int = 1) -> Onsets:
        """F_SN of every design whose onset is a cusp, with its Omega and largest displacement."""
        return Onsets(*self.first.ask(ONSET, workers), _designs=self.first)

    def saddle_nodes(self, F_0: Any, *, places: int = 6, workers: int = 1) -> Folds:
        """Every fold at F_0 that is found along the curve; `undecided` where one was lost.

        F_0 and places as of the designs.
        """
        places = validate.count("places", places, least=1)
        return Folds(*self.first.ask(SADDLE_NODES, workers, F_0, places), _designs=self.first, _F_0=F_0)

    def peak(self, F_0: Any, *, workers: int = 1) -> Peaks:
        """The highest peak at F_0 beside averaging's: its largest displacement and frequency."""
        return Peaks(*self.first.ask(PEAK, workers, F_0), _designs=self.first, _F_0=F_0)


def _second(one: Callable[..., tuple[Any, ...]]) -> Callable[..., tuple[Any, ...]]:
    """The answer of one design, from its averaged oscillator or from None for a blank one."""

    def ask(oscillator: Averaged | None, *arguments: Any) -> tuple[Any, ...]:
        return one(None if oscillator is None else SecondApproximation(oscillator), *arguments)

    return ask


def _onset(second: SecondApproximation | None, _: int) -> tuple[Any, ...]:
    if second is None:
        return np.nan, np.nan, np.nan, 0, 0, Status.NONE
    found = second.saddle_node_onset()
    at_rest = Remark.FOLDS_AT_REST in second.first.saddle_node_onset().remarks
    if found.F_SN is None:
        return np.nan, np.nan, np.nan, 0, at_rest, found._status
    return found.F_SN, found.Omega, found.A, OnsetKind.CUSP, at_rest, Status.OK


def _saddle_nodes(second: SecondApproximation | None, F_0: float, places: int) -> tuple[Any, ...]:
    found = None if second is None else second.saddle_nodes(F_0)
    return asked.in_places(found, places, found is not None and found._lost > 0)


def _peak(second: SecondApproximation | None, F_0: float, _: int) -> tuple[Any, ...]:
    found = second and second.peak(F_0)
    if not found or found.A is None:
        return np.nan, np.nan, found._status if found else Status.NONE
    return found.A, found.Omega, Status.OK


def _detachment(second: SecondApproximation | None, _: int) -> tuple[Any, ...]:
    found = second and second.detachment()
    if not found or found.F_cr is None:
        return np.nan, np.nan, np.nan if not found or found.u_cr is None else found.u_cr, Status.NONE
    return found.F_cr, found.Omega_cr, found.u_cr, Status.OK


DETACHMENT = replace(
    asked.DETACHMENT,
    one=_second(_detachment),
    batch=lambda native: native.many_second_detachment,
    at_once=2**13,
    by_inertia=False,
)
ONSET = replace(
    asked.ONSET, one=_second(_onset), batch=lambda native: native.many_second_onset, at_once=2**13, by_inertia=False
)
SADDLE_NODES = replace(
    asked.SADDLE_NODES,
    one=_second(_saddle_nodes),
    batch=lambda native: native.many_second_saddle_nodes,
    at_once=2**9,
    by_inertia=False,
)
PEAK = replace(
    asked.PEAK, one=_second(_peak), batch=lambda native: native.many_second_peak, at_once=2**9, by_inertia=False
)
