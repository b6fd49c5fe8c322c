"""The second approximation. Takes an averaged oscillator; returns its answers with higher harmonics.

The first approximation is complete and proved; the second starts from its points and corrects them by Newton's
iteration on the generated balance of `slowflow_kernels.second_approximation`. It is valid where the correction is
small. Points that do not converge are left out, and `message` reports them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.answers import validity
from slowflow.answers.answer import joined
from slowflow.answers.questions import Questions
from slowflow.answers.results import Detachment, Peak, Remark, SaddleNodeOnset, SteadyStates
from slowflow.averaged import diagnostics, messages, solvers
from slowflow.averaged.composed import ComposedQuestions
from slowflow.averaged.pairs import at_pairs, with_rests
from slowflow.averaged.plan import Plan, Step
from slowflow.core import validate
from slowflow.core.backend import SOLVER
from slowflow.core.mechanism import Flags, Ints
from slowflow.core.model import Floats
from slowflow.second.answers import SecondFolds, SecondResponse, SecondStates
from slowflow.support.errors import Refused
from slowflow.support.text import Sentence, text
from slowflow_kernels.conventions import Status
from slowflow_kernels.second_conventions import BEYOND, SAMPLES, Wanted

if TYPE_CHECKING:
    from slowflow.averaged.questions import Averaged

LOST = Sentence(
    "left out: {some:d} of {all:d} points of the first approximation, at {Omega} from {Omega[0]:.3g} to "
    "{Omega[1]:.3g}; its harmonics are not small"
)
UNSOLVED = "left out: {} of {} folds, next to which the curve is lost"
NO_FOLD = Sentence("no saddle node at {F_0 = :g} in the second approximation")
FEWER = "fewer states than in the first approximation at {} of {} frequencies"
NO_CUSP = "the onset of the first approximation is of kind {}: the second follows a cusp only"
FAR = "the second approximation does not converge near the first: its harmonics are not small"
NOT_DERIVED = Sentence("{u_cr = :g} is not allowed here: the harmonics of this force are derived for {u_cr} <= {A:g}")
STATIC = text("the static amplitude reaches {u_cr} first: there is no motion with harmonics to evaluate")
NO_PEAK = "no peak of the second approximation near that of the first: {}"
AT_REST = "that one is the static amplitude, which has no harmonics"
LEFT_OUT = "the curve ends before it turns"

#: a peak is put between the points of a curve where it exceeds all of them by more
HIGHER = 1 + 2.0**-40

#: what is made of averaging's answer to a question
SECOND = {
    "frequency_response": "each point is corrected to the balance of harmonics 1, 3 and 5",
    "amplitudes": "the curve is followed, and crossed at each frequency",
    "saddle_nodes": "the curve is followed, and turns between two of its points",
    "peak": "the curve is followed about averaging's highest peak",
    "saddle_node_onset": "the cusp is followed",
    "detachment": text("the lowest forcing whose largest displacement is {u_cr}"),
}
#: why a question of an oscillator, or of many designs, is none of the second approximation's
UNANSWERED = {
    **dict.fromkeys(
        ("fold_locus", "cusps", "isola_points"),
        text("its folds are not explicit in A, as averaging's are; saddle_nodes({F_0}) finds those of a forcing"),
    ),
    **dict.fromkeys(
        ("backbone", "limit_envelope", "transmissibility_floor", "equivalent_damping", "stability"),
        "it is a formula of the slow flow alone; averaging has it",
    ),
    **dict.fromkeys((name for name in vars(ComposedQuestions) if name[0] != "_"), "it combines averaged answers"),
    **dict.fromkeys(
        ("at_rest", "steady_state", "exact_response", "sweep", "transient", "shock_spectrum", "random"),
        "it does not depend on the approximation: call it on the oscillator, or on the designs",
    ),
    **dict.fromkeys(("rest", "off_centre", "at_centre"), "its motions are about the centre"),
    "validity": "measured errors are in the .message of its answers",
    "many": "batches begin with the designs, as Isolator.many(...).second_approximation",
    "certify": "proofs concern the averaged equations",
    "plot": text(
        "its answers have their own .plot(); that of the oscillator also shows {u_cr} and where the mass stops"
    ),
}


@dataclass(frozen=True)
@validate.methods_check_arguments()
class SecondApproximation(Questions[SecondStates, SecondResponse, SecondFolds]):
    """The questions about an oscillator in the second approximation, made by its `.second_approximation`.

    Answers have the largest displacement as A, and the amplitude of the first harmonic as A_1. Arguments and errors are
    those of the oscillator. Raises ValueError if the harmonics of the force are not derived.

    The averaged curve is complete. The second approximation follows from its points where the harmonics are small; a
    message reports points that have none. That there are no other branches is not proved.

    first -- the averaged oscillator
    """

    first: Averaged

    def __post_init__(self) -> None:
        mechanism = self.first.model.mechanism
        for u_cr in self.first.breakpoints:
            if u_cr > mechanism.harmonics_up_to:
                raise validate.NotAvailable(NOT_DERIVED.format(u_cr, mechanism.harmonics_up_to))

    def _check_proof(self) -> None:
        raise validate.NotAvailable(f"certify is not available: {UNANSWERED['certify']}")

    def __getattr__(self, name: str) -> Any:
        """Raise AttributeError, with the reason if averaging answers the question of that name."""
        why = f": {UNANSWERED[name]}" if name in UNANSWERED else ""
        raise AttributeError(f"the second approximation has no {name}{why}")

    def explain(self, question: str, F_0: float | None = None) -> Plan:
        """List the steps of a question: those of averaging, then the corrections; see `Averaged.explain`.

        Raises ValueError as that method, and for a question that the second approximation does not answer.
        """
        if question not in SECOND:
            why = f"; {question}: {UNANSWERED[question]}" if question in UNANSWERED else ""
            allowed = f"{', '.join(SECOND)}{why or validate.meant(question, SECOND)}"
            raise Refused(f"question = {question!r} is not allowed: it must be one of {allowed}")
        first = self.first.explain(question, F_0)
        skipped = first.sticks or (question == "saddle_nodes" and not first.steps[-1].runs)
        after = Step("harmonics", not skipped, "no starting point" if skipped else SECOND[question])
        return first._replace(steps=(*first.steps, after))

    def _frequency_response(self, F_0: float, samples: int, window: tuple[float, float]) -> SecondResponse:
        # as the first approximation's points move to it, with its peak among them
        model = self.first.model
        if model.sticks(F_0):
            none = np.empty(0)
            columns = (none, none, none, none, np.empty(0, bool))
            text, rest = self._remarked(messages.sticks(model, F_0), none, none), (np.empty(0, np.intp), ())
            return SecondResponse(*columns, text, *rest, F_0=F_0, force=none, _model=model)
        answer = SOLVER.second_curve(model.native, F_0, Wanted.EVERY_POINT, samples, *window)
        status, *columns, _, branch, closed, lost, of, low, high = answer
        solvers.check(status, model, F_0)
        Omega_, u_max, A_1, phi, stable, branch = self._with_peak((*columns, branch), F_0, samples)
        if not model.stays_centred:
            stable = stable & self._stay(Omega_, u_max)
        message = self._of_curve(F_0, (lost, of, low, high), window)
        return SecondResponse(
            *(Omega_, u_max, A_1, phi, stable, self._remarked(message, Omega_, u_max)),
            *(branch, tuple(closed.tolist())),
            F_0=F_0,
            force=self._force(F_0, Omega_),
            _model=model,
            _lost=lost > 0,
        )

    def _at_pairs(self, Omega: Any, F_0: Any) -> SecondStates:
        found = at_pairs(self._amplitudes, Omega, F_0, ("Omega", "A", "A_1", "phi", "stable", "force"))
        return SecondStates(**found.columns, F_0=found.F_0, message=found.message, _model=self.first.model)

    def _amplitudes(self, frequencies: Floats, F_0: float) -> SecondStates:
        first = self.first.states(Omega=frequencies, F_0=F_0)
        at, u_max, A_1, phi, stable = (*(np.empty(0) for _ in range(4)), np.empty(0, bool))
        if frequencies.size and first.A.size:
            model = self.first.model
            status, at, u_max, A_1, phi, stable = SOLVER.second_states(model.native, float(F_0), frequencies)
            solvers.check(status, model, F_0)
        fewer = int(np.count_nonzero(_counts(frequencies, at) < _counts(frequencies, first.Omega)))
        message = joined(first.message, FEWER.format(fewer, frequencies.size) if fewer else "")
        stays = stable & self._stay(at, u_max)
        columns, message = self._with_rests(first, frequencies, (at, u_max, A_1, phi, stays), message)
        return SecondStates(
            **columns,
            message=self._remarked(message, at, u_max) if at.size else message,
            F_0=first.F_0,
            force=self._force(F_0, columns["Omega"]),
            _model=self.first.model,
            _lost=fewer > 0,
        )

    def _with_rests(
        self, first: SteadyStates, frequencies: Floats, moving: tuple[Any, ...], message: str
    ) -> tuple[dict[str, Any], str]:
        """Columns and message of the states with those at which friction holds the mass: these have no harmonics."""
        model, averaged = self.first.model, self.first._with_rests(first, frequencies)
        rest = averaged.A == 0
        at_rest = (averaged.Omega[rest], 0.0, 0.0, averaged.phi[rest], True)
        pairs = zip(("Omega", "A", "A_1", "phi", "stable"), zip(moving, at_rest, strict=True), strict=True)
        columns = with_rests(frequencies, model.sticks_at(first.F_0, frequencies), moving[0], dict(pairs))
        return columns, joined(message, messages.moves_exactly(model, model.force(first.F_0, frequencies)))

    def _saddle_nodes(self, F_0: float) -> SecondFolds:
        """Every fold between two points of the curve.

        Averaging's curve is complete, and so are the branches that are followed from it; folds are searched for along
        them, in 600 points, not proved. What lies where the harmonics are not small is left out, in words.
        """
        model, ask, window = self.first.model, SOLVER.second_saddle_nodes, (0.0, math.inf)
        answer: Any = (Status.STICKS,) if model.sticks(F_0) else ask(model.native, F_0, math.inf, math.inf)
        if answer[0] != Status.OK or answer[7] or not answer[-3]:
            # balls may have to tell averaging's folds and its peak
            first, peak = self.first.folds(F_0), self.first.peak(F_0)
            marks = [*first.Omega.tolist(), *([peak.Omega] if peak.Omega else [])]
            if not marks:
                none, no = np.empty(0), np.empty(0, bool)
                message = self._remarked(first.message, none, none)
                return SecondFolds(none, none, none, solvers.FOLD_KINDS.take(no), no, F_0, message)
            window = _around(min(marks), max(marks))
            answer = ask(model.native, F_0, min(marks), max(marks))
            solvers.check(answer[0], model, F_0)
        Omega, u_max, up, corner, _, A_1, _, lost, tried, *left = answer[1:]
        message = joined("" if Omega.size else NO_FOLD.format(F_0), self._of_curve(F_0, left, window))
        message = self._remarked(joined(message, UNSOLVED.format(lost, tried) if lost else ""), Omega, u_max)
        return SecondFolds(Omega, u_max, A_1, solvers.FOLD_KINDS.take(up), corner, F_0, message, _lost=lost)

    def _peak(self, F_0: float) -> Peak:
        """The highest point of the curve about the first approximation's highest peak: its largest displacement A."""
        first = self.first.peak(F_0)
        if first.Omega is None:
            return first
        if first.Omega == 0:
            return Peak(None, None, first.F_0, NO_PEAK.format(AT_REST))
        status, u_max, Omega, _, left = self._peak_about(first.F_0, first.Omega)
        if status != Status.OK:
            of_curve = self._of_curve(first.F_0, left, _around(first.Omega, first.Omega))
            return Peak(None, None, first.F_0, joined(NO_PEAK.format(LEFT_OUT), of_curve))
        return Peak(u_max, Omega, first.F_0, self._remarked("", np.array([Omega]), np.array([u_max])))

    def _saddle_node_onset(self) -> SaddleNodeOnset:
        """The lowest forcing that has a fold, where that is a cusp."""
        first = self.first.saddle_node_onset()
        if first.F_SN is None or first.Omega is None or first.A is None:
            return first
        if first.kind != "cusp":
            return SaddleNodeOnset(None, None, None, "", NO_CUSP.format(first.kind))
        at = first.F_SN, first.Omega, first.A
        status, F_SN, Omega, u_max, *_ = SOLVER.second_onset(self.first.model.native, *at)
        if status != Status.OK:
            return SaddleNodeOnset(None, None, None, "", FAR)
        return SaddleNodeOnset(F_SN, Omega, u_max, first.kind, first.message)

    def _detachment(self) -> Detachment:
        """The lowest forcing whose largest displacement is u_cr."""
        first = self.first.detachment()
        if first.F_cr is None or first.Omega_cr is None or first.u_cr is None:
            return first
        if first.Omega_cr == 0:
            return Detachment(None, None, first.u_cr, STATIC)
        at = first.F_cr, first.Omega_cr, first.u_cr
        status, F_cr, Omega_cr, _ = SOLVER.second_detachment(self.first.model.native, *at)
        if status != Status.OK:
            return Detachment(None, None, first.u_cr, FAR)
        return Detachment(F_cr, Omega_cr, first.u_cr, first.message)

    def _peak_about(self, F_0: float, Omega: float) -> tuple[Any, ...]:
        """The highest point about a frequency: status, its A and Omega, states at that, what of the curve is lost."""
        model = self.first.model
        status, u_max, at, *states, lost, of, low, high = SOLVER.second_peak(model.native, F_0, Omega)
        solvers.check(status, model, F_0)
        return status, u_max, at, states, (lost, of, low, high)

    def _with_peak(self, columns: tuple[Any, ...], F_0: float, samples: int) -> tuple[Any, ...]:
        """The columns of a curve, with its highest point where few samples leave that between two of them.

        It is that of the curve in which `peak` looks for it, which takes longer than few points do.
        """
        Omega, A, *_, branch = columns
        first = self.first.peak(F_0).Omega if samples < SAMPLES else None
        if not (first and Omega.size and Omega.min() < first < Omega.max()):
            return columns
        _, u_max, at, states, _ = self._peak_about(F_0, first)
        highest = int(A.argmax())
        behind = highest > 0 and (Omega[highest - 1] < at) == (at < Omega[highest])
        ends = Omega[max(highest - 1, 0) : highest + 2]
        if not (u_max > HIGHER * A[highest] and ends.min() < at < ends.max() and states[0].size):
            return columns
        top = int(np.abs(states[1] - u_max).argmin())
        if not states[1][top] > HIGHER * A[highest]:
            return columns
        point = (*(column[top] for column in states), branch[highest])
        place = highest + (not behind)
        return tuple(np.insert(column, place, value) for column, value in zip(columns, point, strict=True))

    def _of_curve(self, F_0: float, left: Any, window: tuple[float, float]) -> str:
        """What is to be said of a curve in a window: how many of how many points are left out, and between where."""
        lost, of, low, high = left
        message = solvers.remark_of(self.first.model, F_0, window[0])
        empty = "" if of else messages.empty_window(self.first.model, F_0, window)
        return joined(message, empty, LOST.format(lost, of, (low, high)) if lost else "")

    def _stay(self, Omega: Floats, A: Floats) -> Flags:
        """Which states stay about u = 0, as averaging has it: others are not stable."""
        model = self.first.model
        if model.stays_centred:
            return np.ones(A.size, dtype=bool)
        return diagnostics.keeps_centre(model, Omega, A)

    def _remarked(self, message: str, Omega: Floats, A: Floats) -> str:
        """The message with remarks on amplitudes beyond the reach, and on motions that stop."""
        model = self.first.model
        remarks = diagnostics.of_one(model, math.nan, Omega, A) & ~Remark.OF_TRUNCATION
        return joined(message, *diagnostics.messages(remarks, model, math.nan), validity.of_second(model, Omega, A))

    def _force(self, F_0: float, Omega: Floats) -> Floats:
        """The amplitude of the force at each frequency."""
        force = self.first.model.force(F_0, Omega)
        return np.asarray(force) if self.first.model.inertial else np.full(Omega.shape, force)


def _around(low: float, high: float) -> tuple[float, float]:
    """The window of the curve that holds some frequencies and what may lie beside them."""
    return low / BEYOND, high * BEYOND


def _counts(targets: Floats, values: Floats) -> Ints:
    """How often each target is among the values."""
    known = np.sort(values)
    return np.searchsorted(known, targets, "right") - np.searchsorted(known, targets, "left")
