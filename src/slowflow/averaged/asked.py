"""The questions about many designs: what an answer is made of, and how one design is asked.

In:  an averaged oscillator, None for a blank answer, with F_0, Omega and places. Out: a number, or an array of places,
     for each column, a status last. By doubles alone: what these leave undecided a batch asks balls afterwards.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from types import ModuleType
from typing import Any

import numpy as np

from slowflow.averaged import solvers
from slowflow.averaged.proofs import Allowance
from slowflow.results import Remark
from slowflow.table import AVERAGING, MORE_POINTS
from slowflow_kernels.conventions import FoldKind, OnsetKind, Status

One = Callable[..., tuple[Any, ...]]


def _detachment(oscillator: Any, _: int) -> tuple[Any, ...]:
    found = oscillator and oscillator.detachment()
    if not found or found.F_cr is None:
        return np.nan, np.nan, np.nan, Status.NONE
    return found.F_cr, found.Omega_cr, found.u_cr, Status.OK


def _onset(oscillator: Any, _: int) -> tuple[Any, ...]:
    return onset_in_columns(oscillator and oscillator.onset(Allowance(0)))


def onset_in_columns(found: Any) -> tuple[Any, ...]:
    """A single answer, None for a blank one, as a batch has it."""
    if not found or found.F_SN is None:
        at_rest = bool(found) and Remark.FOLDS_AT_REST in found.remarks
        return np.nan, np.nan, np.nan, 0, at_rest, found._status if found else Status.NONE
    at_rest = Remark.FOLDS_AT_REST in found.remarks
    return found.F_SN, found.Omega, found.A, OnsetKind[found.kind.upper()], at_rest, Status.OK


#: of single answers, by their words and whether on a corner
FOLD_KINDS = {
    ("jump-up", False): FoldKind.JUMP_UP,
    ("jump-down", False): FoldKind.JUMP_DOWN,
    ("jump-up", True): FoldKind.JUMP_UP_AT_CORNER,
    ("jump-down", True): FoldKind.JUMP_DOWN_AT_CORNER,
}


def _saddle_nodes(oscillator: Any, F_0: float, places: int) -> tuple[Any, ...]:
    found = None if oscillator is None else oscillator.folds(F_0, allowance=Allowance(0))
    return in_places(found, places, found is not None and Remark.UNDECIDED in found.remarks)


#: what a batch counts to; where rounding makes more of a curve's folds or states these are no answer
MOST_COUNTED = int(np.iinfo(np.int8).max)


def in_places(found: Any, places: int, undecided: bool) -> tuple[Any, ...]:
    """A single answer's folds, None for a blank one, in the places of a batch."""
    Omega, A, kind = np.full(places, np.nan), np.full(places, np.nan), np.zeros(places, np.int8)
    if found is None or len(found) > MOST_COUNTED:
        return Omega, A, kind, 0, False, Status.NONE if found is None else Status.UNRESOLVED
    n = min(places, len(found))
    Omega[:n], A[:n] = found.Omega[:n], found.A[:n]
    kind[:n] = [FOLD_KINDS[fold.kind, fold.corner] for fold in found][:n]
    return Omega, A, kind, len(found), undecided, Status.OK if n == len(found) else Status.TOO_MANY


def _amplitudes(oscillator: Any, F_0: float, Omega: float, places: int) -> tuple[Any, ...]:
    return states_in_places(oscillator and oscillator.states(Omega=Omega, F_0=F_0, allowance=Allowance(0)), places)


def states_in_places(found: Any, places: int) -> tuple[Any, ...]:
    """A single answer's states at one frequency, None for a blank one, in the places of a batch."""
    A, stable = np.full(places, np.nan), np.zeros(places, np.int8)
    if found is None or len(found.A) > MOST_COUNTED:
        return A, stable, 0, False, Status.NONE if found is None else Status.UNRESOLVED
    n = min(places, len(found.A))
    A[:n], stable[:n] = found.A[:n], found.stable[:n]
    fits = n == len(found.A)
    return A, stable, len(found.A), Remark.UNDECIDED in found.remarks, Status.OK if fits else Status.TOO_MANY


def _peak(oscillator: Any, F_0: float, _: int) -> tuple[Any, ...]:
    found = oscillator and solvers.peak(oscillator.model, F_0)
    if not found or found.A is None:
        return np.nan, np.nan, Status.NONE if not found or found._escapes else found._status
    return found.A, found.Omega, Status.OK


def curves(samples: int, window: tuple[float, float] | None = None) -> Question:
    """The question about response curves of so many samples in a window of Omega; without, up to an Omega of each."""
    n = samples + MORE_POINTS[AVERAGING]

    def one(oscillator: Any, F_0: float, *last: Any) -> tuple[Any, ...]:
        *up_to, places = last
        shown = window or (0.0, *up_to)
        found = oscillator and oscillator.curve(F_0, samples=samples, Omega=shown, allowance=Allowance(0))
        *folds, undecided, status = _saddle_nodes(oscillator, F_0, places)
        undecided = undecided or (bool(found) and Remark.UNDECIDED in found.remarks)
        size = len(found) if found else 0
        Omega, A, branch = np.full(n, np.nan), np.full(n, np.nan), np.full(n, -1, np.int16)
        stable, isola = np.zeros(n, np.int8), np.zeros(n, np.int8)
        if size > n:
            return Omega, A, stable, branch, isola, size, *folds, undecided, Status.TOO_MANY
        if size:
            Omega[:size], A[:size], stable[:size], branch[:size] = found.Omega, found.A, found.stable, found.branch
            isola[:size] = np.array(found.isola)[found.branch]
        return Omega, A, stable, branch, isola, size, *folds, undecided, status

    def batch(native: ModuleType) -> Callable[[Any], Callable[..., Any]]:
        def of_record(record: Any) -> Callable[..., Any]:
            solve = native.many_frequency_response(record)
            if window is None:
                return lambda *given, out: solve(*given[:-1], float(samples), 0.0, given[-1], out=out)
            return lambda *given, out: solve(*given, float(samples), *window, out=out)

        return of_record

    at_once = min(2**12, max(1, 2**22 // n))
    return Question("frequency_response", one, batch, at_once, points=n)


#: count, whether it is proved, status, without the compiled solvers
NO_PROOF = (0, 0, Status.UNRESOLVED)


@dataclass(frozen=True)
class Question:
    """A question about many designs.

    name    -- that of its row
    one     -- the answer of one design; None of a proof, which only the compiled solvers give in doubles
    batch   -- from the compiled solvers what gives the generalised ufunc of a record; None where designs are asked
               one by one
    at_once -- designs that take no more than some tenths of a second: until then Ctrl-C is not heard
    system  -- by what it is answered
    points  -- of a curve
    """

    name: str
    one: One | None
    batch: Callable[[ModuleType], Callable[[Any], Callable[..., Any]]] | None
    at_once: int
    system: str = AVERAGING
    points: int = 0


DETACHMENT = Question("detachment", _detachment, lambda native: native.many_detachment, 2**18)
ONSET = Question("saddle_node_onset", _onset, lambda native: native.many_onset, 2**14)
SADDLE_NODES = Question("saddle_nodes", _saddle_nodes, lambda native: native.many_saddle_nodes, 2**12)
AMPLITUDES = Question("amplitudes", _amplitudes, lambda native: native.many_amplitudes, 2**11)
PEAK = Question("peak", _peak, lambda native: native.many_peak, 2**13)
PROVED_FOLDS = Question("certify", None, lambda native: native.many_proved_saddle_nodes, 2**10)
PROVED_STATES = Question("certify", None, lambda native: native.many_proved_amplitudes, 2**10)
