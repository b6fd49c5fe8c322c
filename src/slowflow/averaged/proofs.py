"""Proofs: in goes a model with the numbers that it was made from, out come enclosures, and what is proved of them.

The compiled solvers compute in intervals of doubles (native/proof.h). What is certified is the oscillator whose numbers
are the given doubles, exactly: parameters that follow from them, as alpha, u_cr and m, are intervals.
"""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np

from slowflow import backend
from slowflow.averaged import words
from slowflow.model import Floats, Model
from slowflow.results import ProvedFolds, ProvedForcing, ProvedStates
from slowflow_kernels.conventions import OnsetKind, Status

NO_SOLVERS = "not certified: that needs the compiled solvers"
NO_DESIGN = "not certified: the numbers that the parameters follow from are not known"
NO_INTERVALS = "not certified: the average of this force is not known on intervals"
FAILED = "not certified: the response is unresolved"
IN_DOUBT = "doubles do not decide for A in {}"
NO_ROOM = "there are more of them than places"
UNBOUNDED = "only amplitudes up to {:.6g} are looked at"
NO_LOWEST = "not certified: that no forcing is the lowest that has a fold is not proved"
PROVED_NO_LOWEST = "no lowest forcing: zeta = 0, and there are folds as near above 4 mu/pi as one asks"
NO_ONSET = "not certified: that no fold is born at any forcing is not proved"
PROVED_NO_ONSET = "no saddle node is born at any forcing"
ONSET_IN_DOUBT = "doubles do not decide whether a lower forcing has a fold"
NEAR_STICKING = "F_0 is so near to 4 mu/pi that doubles do not decide whether the mass moves"

_NONE = np.empty((0, 2))
_NOTHING = np.empty(0)
_NO_FLAG = np.empty(0, bool)
#: by the sign of F_AA: 0, 1, -1
_KINDS = np.array(["", "jump-down", "jump-up"])


def _asked(proof: Callable[[ModuleType], Callable[..., Any]], model: Model, *numbers: Any) -> tuple[Any, str]:
    """What one of the compiled solvers' proofs gives, or why there is none."""
    if backend.SOLVER is None or model.native is None:
        return None, NO_SOLVERS
    if not model.design:
        return None, NO_DESIGN
    answer = proof(backend.SOLVER)(model.native, *numbers)
    return answer, "" if answer is not None else NO_INTERVALS


def _remarks(
    model: Model, F_0: float, status: int, doubt: Floats, A_max: float, bounded: bool, room: bool
) -> tuple[bool, str]:
    """Whether it is all proved, and what to say beside it."""
    if status == Status.STICKS:
        return bounded, words.sticks(model, F_0) if bounded else NEAR_STICKING
    if status != Status.OK:
        return False, FAILED
    said = []
    if len(doubt):
        said.append(IN_DOUBT.format(", ".join(f"[{low:.17g}, {high:.17g}]" for low, high in doubt)))
    if not room:
        said.append(NO_ROOM)
    if not bounded:
        said.append(UNBOUNDED.format(A_max))
    return not len(doubt) and room, "; ".join(said)


def saddle_nodes(model: Model, F_0: float, expected: Floats) -> ProvedFolds:
    """Every fold at F_0, with what is proved of it; `expected`: amplitudes where some are, which saves time."""
    answer, reason = _asked(lambda solver: solver.certify_folds, model, F_0, expected)
    if answer is None:
        return ProvedFolds(False, reason, _NONE, _NONE, _KINDS[:0], _NO_FLAG, 0.0, False, _NONE)
    status, Omega, A, corner, sign, doubt, A_max, bounded, room = answer
    proved, message = _remarks(model, F_0, status, doubt, A_max, bounded, room)
    return ProvedFolds(proved, message, Omega, A, _KINDS[sign], corner, A_max, bounded, doubt)


def amplitudes(model: Model, Omega: float, F_0: float) -> ProvedStates:
    """Every state at (Omega, F_0), with what is proved of it."""
    answer, reason = _asked(lambda solver: solver.certify_states, model, F_0, Omega)
    if answer is None:
        return ProvedStates(False, reason, _NONE, _NO_FLAG, 0.0, False, _NONE)
    status, _, A, _, sign, doubt, A_max, bounded, room = answer
    order = np.argsort(A[:, 0])
    proved, message = _remarks(model, F_0, status, doubt, A_max, bounded, room)
    return ProvedStates(proved, message, A[order], sign[order] > 0, A_max, bounded, doubt)


def onset(model: Model) -> ProvedForcing:
    """F_SN, and that no fold is born at a lower forcing."""
    answer, reason = _asked(lambda solver: solver.certify_onset, model)
    if answer is None:
        return _no_forcing(reason)
    status, *ends, proved = answer
    if status != Status.OK:
        said = {Status.UNBOUNDED: (NO_LOWEST, PROVED_NO_LOWEST), Status.NONE: (NO_ONSET, PROVED_NO_ONSET)}
        return _no_forcing(said.get(status, (FAILED, FAILED))[proved], proved=proved)
    *ends, kind = ends
    F_SN, Omega, A = map(np.array, ends)
    word = OnsetKind(kind).name.lower() if kind != OnsetKind.NO else ""
    return ProvedForcing(proved, "" if proved else ONSET_IN_DOUBT, F_SN, Omega, A, word)


def detachment(model: Model) -> ProvedForcing:
    """F_cr: an enclosure of the lowest forcing that reaches the first breakpoint."""
    answer, reason = _asked(lambda solver: solver.certify_detachment, model)
    if answer is None:
        return _no_forcing(reason)
    if answer[0] == Status.NONE:
        return _no_forcing(words.NO_DETACHMENT, proved=True)
    if answer[0] != Status.OK:
        return _no_forcing(FAILED)
    F_cr, Omega_cr, u_cr = map(np.array, answer[1:])
    return ProvedForcing(True, "", F_cr, Omega_cr, u_cr, "")


def _no_forcing(reason: str, *, proved: bool = False) -> ProvedForcing:
    return ProvedForcing(proved, reason, _NOTHING, _NOTHING, _NOTHING, "")
