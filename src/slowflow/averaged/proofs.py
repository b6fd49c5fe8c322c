"""Proofs. Takes a model with the numbers that it was made from; returns enclosures, and what is proved of them.

The compiled solvers compute in intervals of doubles (native/proof.h). What is certified is the oscillator whose numbers
are the given doubles, exactly: parameters that follow from them, as alpha, u_cr and m, are intervals. Where these do
not decide, or the solvers have no proof, balls of more digits do (averaged/balls), if python-flint is there.
"""

from __future__ import annotations

import dataclasses
import importlib.util
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Generic, TypeVar

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
    from slowflow.averaged.balls.questions import ProvedCusps

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
#: how many bits are tried in balls, in turn
BITS = (128, 512)
#: relative width of an enclosure whose middle is right to a unit in the last place of doubles
SHARP = 2.0**-51


@dataclasses.dataclass
class Allowance:
    """How often an answer, single or of a batch, may ask balls yet."""

    left: int = MOST_IN_BALLS

    def take(self) -> bool:
        """Whether it may once more."""
        self.left -= 1
        return self.left >= 0


def ball_questions() -> Any:
    """What proves in balls, `slowflow.averaged.balls.questions`; None without python-flint."""
    if importlib.util.find_spec("flint") is None:
        return None
    from slowflow.averaged.balls import questions

    return questions


@dataclasses.dataclass(frozen=True)
class Proof(Generic[Answer]):
    """A question that is proved in intervals of doubles, and where these do not decide in balls.

    name -- of the question, of the compiled solvers and of `balls.questions.ask`, which give alike tuples
    make -- the answer, from the model, the bits, that tuple (None where there is no proof) and the numbers of the query
    """

    name: str
    make: Callable[..., Answer]

    def __call__(self, model: Model, *numbers: float) -> Answer:
        """What is proved."""
        found = self.in_doubles(model, *numbers)
        if found.proved or not model.has_design:
            return found
        if ball_questions() is None:
            return dataclasses.replace(found, message=joined(found.message, messages.NO_BALLS))
        decided = self.in_balls(model, *numbers)
        return found if decided is None else decided

    def in_doubles(self, model: Model, *numbers: float) -> Answer:
        """What intervals of doubles prove."""
        found = getattr(backend.SOLVER, self.name)(model.native, *numbers) if model.has_design else None
        return self.make(model, DOUBLES, found, *numbers)

    def in_balls(self, model: Model, *numbers: float) -> Answer | None:
        """What balls of as few bits as it takes for it to be sharp prove, or those of the most; None without them."""
        best, balls = None, ball_questions()
        for bits in BITS if balls is not None and model.has_design else ():
            if (found := balls.ask(self.name, model, bits, *numbers)) is None:
                break
            answer = self.make(model, bits, found, *numbers)
            best = answer if best is None or answer.proved or not best.proved else best
            if answer.proved and _is_sharp(answer):
                break
        return best


def _is_sharp(found: Proved) -> bool:
    """Whether enclosures tell each value to a unit in the last place."""
    ends = [getattr(found, name).reshape(-1, 2) for name in ("F_0", "Omega", "A") if hasattr(found, name)]
    return all(bool((high - low <= SHARP * high).all()) for low, high in (one.T for one in ends))


def _in_doubt(bits: int, in_doubles: str, where: str = "") -> str:
    return in_doubles if bits == DOUBLES else messages.BALLS_IN_DOUBT.format(bits, where)


def _why_not(model: Model) -> str:
    return messages.NO_INTERVALS if model.has_design else messages.NO_DESIGN


def _at_forcing(
    model: Model, bits: int, found: tuple[Any, ...] | None, F_0: float
) -> tuple[tuple[bool, str, int], tuple[Any, ...], tuple[Any, ...]]:
    """Of folds or states at a forcing: whether all is proved, a message and the bits; columns; and the rest."""
    if found is None:
        return (False, _why_not(model), bits), (_NONE, _NONE, _NO_FLAG, np.empty(0, int)), (0.0, False, _NONE)
    status, *columns, doubt, A_max, bounded, room = found
    if status == Status.STICKS:
        unknown = _in_doubt(bits, messages.NEAR_STICKING, " on whether the mass moves")
        proved, message = bounded, messages.sticks(model, F_0) if bounded else unknown
    elif status != Status.OK:
        proved, message = False, messages.FAILED
    else:
        proved, where = not len(doubt) and room, messages.intervals(doubt) if len(doubt) else ""
        undecided = _in_doubt(bits, messages.IN_DOUBT.format(where), f" for A in {where}") if where else ""
        limit = "" if bounded else messages.NOT_BOUNDED.format(A_max)
        message = joined(undecided, "" if room else messages.NO_ROOM, limit)
    return (proved, message, bits), tuple(columns), (A_max, bounded, doubt)


def is_plain(model: Model) -> bool:
    """Whether proofs cover the model: a force, mu and zeta alone."""
    return bool(model.design) and not model.inertial and not model.laws.any


def _by_balls(question: Proof[Answer], model: Model, allowance: Allowance | None, *numbers: float) -> Answer | None:
    """What balls prove of a question, None where they are not available, not allowed any more, or inconclusive."""
    allowed = is_plain(model) and ball_questions() is not None and (allowance or Allowance()).take()
    proof = question.in_balls(model, *numbers) if allowed else None
    return proof if proof is not None and proof.proved else None


def decided(found: SaddleNodes, model: Model, allowance: Allowance | None) -> SaddleNodes:
    """Folds whose number doubles leave undecided, as balls prove them; as they are where these do not decide either."""
    if found.remarks is NOTHING:  # of most, and to look for one code takes longer
        return found
    proof = _by_balls(folds, model, allowance, found.F_0) if Remark.UNDECIDED in found.remarks else None
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
        proof = _by_balls(states, model, allowance, F_0, w)
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
    proof = _by_balls(onset, model, allowance)
    # that none is born is proved of amplitudes up to one that stands for infinite ones, and no forcing bounds them
    if proof is None or not proof.kind:
        return None
    # whether folds at rest lie below it has to be proved as well
    low, high = ball_questions().ask("at_rest", model, BITS[-1], proof.F_0[1])
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
    proof = _by_balls(cusps, model, None, A_max) if asks else None
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


def _folds(model: Model, bits: int, found: Any, F_0: float) -> ProvedFolds:
    head, (Omega, A, corner, sign), others = _at_forcing(model, bits, found, F_0)
    from slowflow.answers.certificate import ProvedFolds

    return ProvedFolds(*head, Omega, A, _KINDS[sign], corner, *others)


def _states(model: Model, bits: int, found: Any, F_0: float, _: float) -> ProvedStates:
    head, (_Omega, A, _corner, sign), others = _at_forcing(model, bits, found, F_0)
    from slowflow.answers.certificate import ProvedStates

    return ProvedStates(*head, A, sign > 0, *others)


def _onset(model: Model, bits: int, found: Any) -> ProvedForcing:
    if found is None:
        return _forcing(False, _why_not(model), bits)
    status, *at, kind, proved = found
    if status != Status.OK:
        texts = {Status.UNBOUNDED: messages.OF_NO_LOWEST, Status.NONE: messages.OF_NO_ONSET}
        return _forcing(proved, texts.get(status, (messages.FAILED, messages.FAILED))[proved], bits)
    doubt = "" if proved else _in_doubt(bits, messages.ONSET_IN_DOUBT)
    return _forcing(proved, doubt, bits, at, solvers.ONSET_KINDS[kind])


def _detachment(model: Model, bits: int, found: Any) -> ProvedForcing:
    if found is None:
        return _forcing(False, _why_not(model), bits)
    status, *at = found
    if status == Status.NONE:
        return _forcing(True, messages.NO_DETACHMENT, bits)
    return _forcing(True, "", bits, at) if status == Status.OK else _forcing(False, messages.FAILED, bits)


def _forcing(proved: bool, message: str, bits: int, at: Any = (_NOTHING,) * 3, kind: str = "") -> ProvedForcing:
    """A critical forcing, or that there is none; at: bounds of F_0, Omega and A."""
    from slowflow.answers.certificate import ProvedForcing

    F_0, Omega, A = at
    return ProvedForcing(proved, message, bits, F_0, Omega, A, kind)


def _cusps(_model: Model, bits: int, found: Any, _A_max: float) -> ProvedCusps:
    from slowflow.averaged.balls.questions import ProvedCusps

    proved, *columns = found
    return ProvedCusps(proved, "" if proved else _in_doubt(bits, ""), bits, *columns)


#: every fold at F_0; every state at F_0 and Omega; F_SN, and that no fold is born at a lower forcing; F_cr
folds, states = Proof("certify_folds", _folds), Proof("certify_states", _states)
onset, detachment = Proof("certify_onset", _onset), Proof("certify_detachment", _detachment)
#: every cusp up to an amplitude, in balls alone
cusps = Proof("certify_cusps", _cusps)
