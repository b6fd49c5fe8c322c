"""Proofs. Takes a model with the numbers that it was made from; returns enclosures, and what is proved of them.

The compiled solvers compute in intervals of doubles (native/proof.h). What is certified is the oscillator whose numbers
are the given doubles, exactly: parameters that follow from them, as alpha, u_cr and m, are intervals. Where these do
not decide, or the solvers have no proof, balls of more digits do (averaged/balls), if python-flint is there.
"""

from __future__ import annotations

import dataclasses
import functools
import importlib.util
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from slowflow.answers.answer import joined
from slowflow.answers.results import (
    NOTHING,
    Cusps,
    FrequencyResponse,
    Remark,
    SaddleNodeOnset,
    SaddleNodes,
    SteadyStates,
)
from slowflow.answers.table import DOUBLES
from slowflow.averaged import messages, solvers
from slowflow.core import backend
from slowflow.core.mechanism import Flags
from slowflow.core.model import Floats, Model
from slowflow_kernels.conventions import SAME, Status

if TYPE_CHECKING:
    from slowflow.answers.certificate import Proved, ProvedFolds, ProvedForcing, ProvedStates

Answer = TypeVar("Answer", bound="Proved")

_NONE = np.empty((0, 2))
_NOTHING = np.empty(0)
_NO_FLAG = np.empty(0, bool)
#: by the sign of F_AA: 0, 1, -1
_KINDS = np.array(["", "jump-down", "jump-up"])
#: relative width of an enclosure whose middle may be an answer
_NARROW = 2.0**-40
#: folds at a forcing, or states at a frequency, that one answer asks balls for at most: tens of seconds
MOST_IN_BALLS = 200
#: the same of onsets, which take some seconds each
MOST_ONSETS_IN_BALLS = 20


@dataclasses.dataclass
class Allowance:
    """How often an answer, single or of a batch, may ask balls yet."""

    left: int = MOST_IN_BALLS

    def take(self) -> bool:
        """Whether it may once more."""
        self.left -= 1
        return self.left >= 0


def _prove(proof: Callable[..., Any], model: Model, *numbers: Any) -> Any:
    """The result of one of the compiled solvers' proofs, None where they have none: `_why_not` says why."""
    return proof(model.native, *numbers) if model.has_design else None


def _why_not(model: Model) -> str:
    return messages.NO_INTERVALS if model.has_design else messages.NO_DESIGN


def _prove_at(
    proof: Callable[..., Any], model: Model, F_0: float, *more: Any
) -> tuple[tuple[bool, str, int], tuple[Any, ...], tuple[Any, ...]]:
    """The result of a proof at a forcing: whether it is all proved, and a message; columns; and the rest."""
    if (answer := _prove(proof, model, F_0, *more)) is None:
        return (False, _why_not(model), DOUBLES), (_NONE, _NONE, _NO_FLAG, np.empty(0, int)), (0.0, False, _NONE)
    status, *columns, doubt, A_max, bounded, room = answer
    if status == Status.STICKS:
        proved, message = bounded, messages.sticks(model, F_0) if bounded else messages.NEAR_STICKING
    elif status != Status.OK:
        proved, message = False, messages.FAILED
    else:
        proved = not len(doubt) and room
        in_doubt = messages.IN_DOUBT.format(messages.intervals(doubt)) if len(doubt) else ""
        limit = "" if bounded else messages.NOT_BOUNDED.format(A_max)
        message = joined(in_doubt, "" if room else messages.NO_ROOM, limit)
    return (proved, message, DOUBLES), tuple(columns), (A_max, bounded, doubt)


def in_balls() -> Any:
    """What proves in balls, `slowflow.averaged.balls.questions`; None without python-flint."""
    if importlib.util.find_spec("flint") is None:
        return None
    from slowflow.averaged.balls import questions

    return questions


def _or_in_balls(in_doubles: Callable[..., Answer]) -> Callable[..., Answer]:
    """A proof by doubles, and where these do not decide what balls say instead, by their question of the same name."""

    @functools.wraps(in_doubles)
    def proof(model: Model, *numbers: float) -> Answer:
        found = in_doubles(model, *numbers)
        if found.proved or not model.has_design:
            return found
        balls = in_balls()
        if balls is None:
            return dataclasses.replace(found, message=joined(found.message, messages.NO_BALLS))
        decided: Answer | None = getattr(balls, in_doubles.__name__)(model, *numbers)
        return found if decided is None else decided

    return proof


def is_plain(model: Model) -> bool:
    """Whether proofs cover the model: a force, mu and zeta alone."""
    return bool(model.design) and not model.inertial and not model.laws.any


def _by_balls(question: str, model: Model, allowance: Allowance | None, *numbers: float) -> Any:
    """What balls prove of a question, None where they are not available, not allowed any more, or inconclusive."""
    balls = in_balls() if is_plain(model) else None
    allowed = balls is not None and (allowance or Allowance()).take()
    proof = getattr(balls, question)(model, *numbers) if allowed else None
    return proof if proof is not None and proof.proved else None


def decided(found: SaddleNodes, model: Model, allowance: Allowance | None) -> SaddleNodes:
    """Folds whose number doubles leave undecided, as balls prove them; as they are where these do not decide either."""
    if found.remarks is NOTHING:  # of most, and to look for one code takes longer
        return found
    proof = _by_balls("folds", model, allowance, found.F_0) if Remark.UNDECIDED in found.remarks else None
    if proof is None:
        return found
    # doubles may have more digits of one that lies next to a breakpoint
    same = proof.corner.tolist() == found.corner.tolist()
    Omega, A = (
        _middle(enclosed, known if same else None)
        for enclosed, known in ((proof.Omega, found.Omega), (proof.A, found.A))
    )
    if np.isnan(Omega).any() or np.isnan(A).any():
        return found
    # which way a sweep leaves doubles say where the proof does not
    with np.errstate(all="ignore"):  # folds of any size
        by_doubles = np.where(model.F_AA(Omega, A) < 0, "jump-up", "jump-down")
    kind, corner = np.where(proof.kind == "", by_doubles, proof.kind), proof.corner
    order = np.lexsort((~corner, A, Omega))
    Omega, A, kind, corner = Omega[order], A[order], kind[order], corner[order]
    message, cut = messages.of_folds(model, found.F_0, A.size > 0, found.message if Remark.CUT in found.remarks else "")
    codes = messages.codes(False, cut) | Remark.BY_BALLS
    columns = {"Omega": Omega, "A": A, "kind": kind, "corner": corner}
    return SaddleNodes._made(**columns, F_0=found.F_0, message=message, remarks=codes, _model=model)


def decided_states(
    found: SteadyStates, model: Model, frequencies: Floats, F_0: float, allowance: Allowance
) -> SteadyStates:
    """States at `frequencies`, where doubles leave their number undecided as balls prove them.

    In the order of `frequencies`, repeated ones too. Unchanged where balls do not decide either, or have been used too
    often already.
    """
    proved: dict[float, ProvedStates] = {}
    for w in np.unique(found.Omega_undecided).tolist() if found.Omega_undecided.size else ():
        proof = _by_balls("states", model, allowance, w, F_0)
        if proof is not None and not np.isnan(_middle(proof.A, None)).any():
            proved[w] = proof
    if not proved:
        return found
    Omega, A, stable = _with_proved(found, frequencies, proved)
    undecided = found.Omega_undecided[~np.isin(found.Omega_undecided, list(proved))]
    cut = solvers.remark_of(model, F_0) if Remark.CUT in found.remarks else ""
    message = messages.of_states(model, F_0, cut, frequencies, Omega, undecided)
    if messages.sticks(model, F_0) in (proof.message for proof in proved.values()):
        message = messages.sticks(model, F_0)
    if allowance.left < 0:
        message = joined(message, messages.ENOUGH_BALLS.format(MOST_IN_BALLS))
    codes = messages.codes(undecided.size > 0, cut) | Remark.BY_BALLS
    return SteadyStates(Omega, A, stable, F_0, message, model, Omega_undecided=undecided, remarks=codes)


def decided_curve(
    found: FrequencyResponse, model: Model, window: tuple[float, float], allowance: Allowance | None
) -> FrequencyResponse:
    """A response curve in a window of which doubles leave open how many folds it has: not where balls prove its own.

    As it is where they prove others, or the same with other digits, and where doubles do not tell its peaks or static
    states either.
    """
    F_0 = float(found.F_0)
    if Remark.UNDECIDED not in found.remarks or not is_plain(model):
        return found
    folds = solvers.folds(model, F_0)
    known = folds if Remark.UNDECIDED not in folds.remarks else decided(folds, model, allowance)
    if known is folds or len(known) != len(folds) or not (_same(known.A, folds.A) and _same(known.Omega, folds.Omega)):
        return found
    inside = (window[0] < folds.Omega) & (folds.Omega < window[1])
    points = set(zip(found.Omega.tolist(), found.A.tolist(), strict=True))
    if not points.issuperset(zip(folds.Omega[inside].tolist(), folds.A[inside].tolist(), strict=True)):
        return found
    if solvers.are_events_close(model, F_0):
        return found
    return dataclasses.replace(found, remarks=(found.remarks & ~Remark.UNDECIDED) | Remark.BY_BALLS)


def _same(one: Floats, other: Floats) -> bool:
    """Whether numbers are the same but for a few roundings."""
    return bool((np.abs(one - other) <= SAME * one).all())


def decided_onset(model: Model, allowance: Allowance | None) -> SaddleNodeOnset | None:
    """The onset that doubles refuse, as balls prove it, with the level of lower folds that end at rest.

    None where they do not: of an excitation by inertia, of other laws of damping, with a preload, without viscous
    damping, and of a force that is infinitely stiff at rest.
    """
    if model.zeta == 0 or model.preload > 0 or not np.isfinite(model.averaged(0.0)[1]):
        return None
    proof = _by_balls("onset", model, allowance)
    # that none is born is proved of amplitudes up to one that stands for infinite ones, and no forcing bounds them
    if proof is None or not proof.kind:
        return None
    # whether folds at rest lie below it has to be proved as well
    low, high = in_balls().at_rest(model, proof.F_0[1])
    on_end = [b for b in model.breakpoints if proof.kind == "corner" and proof.A[0] <= b <= proof.A[1]]
    ends = np.array((proof.F_0, proof.Omega, proof.A))
    F_SN, Omega, A = _middle(ends, np.array((np.nan, np.nan, on_end[0])) if on_end else None).tolist()
    if (low <= proof.F_0[1] and proof.F_0[0] <= high) or np.isnan((F_SN, Omega, A)).any():
        return None
    found = SaddleNodeOnset(F_SN, Omega, A, proof.kind, "")
    found = messages.with_folds_at_rest(model, found, 0.5 * (low + high))
    return dataclasses.replace(found, remarks=found.remarks | Remark.BY_BALLS)


def decided_cusps(found: Cusps, model: Model, A_max: float) -> Cusps:
    """Cusps of which doubles have few digits, as balls prove them; as they are where these do not decide either."""
    asks = Remark.UNDECIDED in found.remarks and model.zeta > 0
    proof = _by_balls("cusps", model, None, A_max) if asks else None
    if proof is None:
        return found
    F_0, Omega, A = (_middle(enclosed, None) for enclosed in (proof.F_0, proof.Omega, proof.A))
    if np.isnan((F_0, Omega, A)).any():
        return found
    message = messages.CUSPS_BY_BALLS if A.size else messages.NO_CUSP.format(A_max)
    return Cusps(F_0, Omega, A, proof.minimum, message, remarks=Remark.BY_BALLS)


def nothing_decided(model: Model, frequencies: Floats, F_0: float) -> SteadyStates:
    """States of which doubles tell nothing."""
    none, cut = np.empty(0), solvers.remark_of(model, F_0)
    at, codes = np.unique(frequencies), messages.codes(True, cut)
    message = messages.of_states(model, F_0, cut, frequencies, none, at)
    return SteadyStates(none, none, _NO_FLAG, F_0, message, model, Omega_undecided=at, remarks=codes)


def _with_proved(
    found: SteadyStates, frequencies: Floats, proved: dict[float, ProvedStates]
) -> tuple[Floats, Floats, Flags]:
    """Omega, A, stable with proved states in the place of those found, in the order of `frequencies`."""
    Omega, of = np.unique(frequencies, return_inverse=True)
    # as many at each of repeated frequencies
    count = np.bincount(np.searchsorted(Omega, found.Omega), minlength=Omega.size) // np.bincount(of)
    place = np.repeat(np.arange(frequencies.size), count[of])
    kept = ~np.isin(found.Omega, list(proved))
    positions, A, stable = [place[kept]], [found.A[kept]], [found.stable[kept]]
    for i, w in enumerate(frequencies.tolist()):
        if (proof := proved.get(w)) is not None:
            known = found.A[place == i]
            positions.append(np.full(len(proof.A), i))
            A.append(_middle(proof.A, known if known.size == len(proof.A) else None))
            stable.append(proof.stable)
    joint = np.concatenate(positions)
    order = np.argsort(joint, kind="stable")
    return frequencies[joint[order]], np.concatenate(A)[order], np.concatenate(stable)[order]


def _middle(enclosed: Floats, known: Floats | None) -> Floats:
    """What was known, where enclosures hold it, else their middles; NaN where they are too wide for that."""
    low, high = enclosed.T
    narrow = np.isfinite(high) & (high - low <= _NARROW * high)
    middle = np.where(narrow, enclosed.mean(axis=1), np.nan)
    return middle if known is None else np.where((low <= known) & (known <= high), known, middle)


@_or_in_balls
def folds(model: Model, F_0: float) -> ProvedFolds:
    """Every fold at F_0, with what is proved of it."""
    head, (Omega, A, corner, sign), others = _prove_at(backend.SOLVER.certify_folds, model, F_0)
    from slowflow.answers.certificate import ProvedFolds

    return ProvedFolds(*head, Omega, A, _KINDS[sign], corner, *others)


@_or_in_balls
def states(model: Model, Omega: float, F_0: float) -> ProvedStates:
    """Every state at (Omega, F_0), with what is proved of it."""
    head, (_, A, _, sign), others = _prove_at(backend.SOLVER.certify_states, model, F_0, Omega)
    from slowflow.answers.certificate import ProvedStates

    return ProvedStates(*head, A, sign > 0, *others)


@_or_in_balls
def onset(model: Model) -> ProvedForcing:
    """F_SN, and that no fold is born at a lower forcing."""
    if (answer := _prove(backend.SOLVER.certify_onset, model)) is None:
        return _no_forcing(_why_not(model))
    status, F_SN, Omega, A, kind, proved = answer
    if status != Status.OK:
        texts = {Status.UNBOUNDED: messages.OF_NO_LOWEST, Status.NONE: messages.OF_NO_ONSET}
        return _no_forcing(texts.get(status, (messages.FAILED, messages.FAILED))[proved], proved=proved)
    doubt = "" if proved else messages.ONSET_IN_DOUBT
    return _forcing(proved, doubt, F_SN, Omega, A, solvers.ONSET_KINDS[kind])


@_or_in_balls
def detachment(model: Model) -> ProvedForcing:
    """F_cr: an enclosure of the lowest forcing that reaches the first breakpoint."""
    if (answer := _prove(backend.SOLVER.certify_detachment, model)) is None:
        return _no_forcing(_why_not(model))
    if answer[0] == Status.NONE:
        return _no_forcing(messages.NO_DETACHMENT, proved=True)
    if answer[0] != Status.OK:
        return _no_forcing(messages.FAILED)
    _, F_cr, Omega_cr, u_cr = answer
    return _forcing(True, "", F_cr, Omega_cr, u_cr)


def _no_forcing(reason: str, *, proved: bool = False) -> ProvedForcing:
    return _forcing(proved, reason, _NOTHING, _NOTHING, _NOTHING)


def _forcing(proved: bool, message: str, F_0: Floats, Omega: Floats, A: Floats, kind: str = "") -> ProvedForcing:
    from slowflow.answers.certificate import ProvedForcing

    return ProvedForcing(proved, message, DOUBLES, F_0, Omega, A, kind)
