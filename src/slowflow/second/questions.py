"""The second approximation: in goes an averaged oscillator, out come its answers with what the higher harmonics change.

The first approximation is complete and certain; the second starts from it and follows its points by Newton's iteration
on the generated balance of `slowflow_kernels.second_approximation`. It holds where the change is small. What does not
survive is left out, and `message` says so.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from slowflow import validate
from slowflow.answer import joined
from slowflow.averaged import remarks, words
from slowflow.averaged.pairs import at_pairs, with_rests
from slowflow.averaged.plan import Plan, Step
from slowflow.measured import validity
from slowflow.model import Floats
from slowflow.results import Detachment, Peak, Remark, SaddleNodeOnset, SteadyStates
from slowflow.second import compiled
from slowflow.second.answers import SecondFolds, SecondResponse, SecondStates
from slowflow.second.found import Curve, Folds, State
from slowflow.text import Sentence, text
from slowflow_kernels.second_conventions import BEYOND, SAMPLES, Wanted
from slowflow_support.errors import Refused

if TYPE_CHECKING:
    from slowflow.averaged.questions import Averaged

FEWER = "fewer states than in the first approximation at {} of {} frequencies"
NO_CUSP = "the onset of the first approximation is of kind {}: the second follows a cusp only"
FAR = "the second approximation does not come near the first: its harmonics are not small"
NOT_DERIVED = Sentence("{u_cr = :g} is not allowed here: the harmonics of this force are derived for {u_cr} <= {A:g}")
STATIC = text("the static amplitude reaches {u_cr} first: there is no motion whose harmonics could be told")
NO_PEAK = "no peak of the second approximation beside the first's: {}"
AT_REST = "the first's is the static amplitude, which has no harmonics"
LEFT_OUT = "the curve ends before it turns"

#: a peak is put between the points of a curve where it exceeds all of them by more
HIGHER = 1 + 2.0**-40

#: what is made of averaging's answer to a question
SECOND = {
    "frequency_response": "each point moves to the balance of harmonics 1, 3 and 5 beside it",
    "amplitudes": "the curve is followed, and crossed at each frequency",
    "saddle_nodes": "the curve is followed, and turns between two of its points",
    "peak": "the curve is followed about averaging's highest peak",
    "saddle_node_onset": "the cusp is followed",
    "detachment": text("the lowest forcing whose largest displacement is {u_cr}"),
}
#: why a question of averaging's is none of the second approximation's
UNANSWERED = {
    **dict.fromkeys(
        ("fold_locus", "cusps", "isola_points"),
        text("its folds are not explicit in A, as averaging's are; saddle_nodes({F_0}) finds those of a forcing"),
    ),
    **dict.fromkeys(
        ("backbone", "limit_envelope", "transmissibility_floor", "equivalent_damping", "stability"),
        "it is a formula of the slow flow alone; averaging has it",
    ),
    **dict.fromkeys(("margins", "hysteresis", "isolation", "spectrum"), "it is put together from averaging's answers"),
    **dict.fromkeys(
        ("steady_state", "exact_response", "sweep", "transient", "shock_spectrum"),
        "it is asked of the oscillator, whose equation of motion answers it",
    ),
    **dict.fromkeys(("rest", "off_centre"), "its motions are about the centre"),
    "validity": "what is measured of it stands in the .message of its answers",
    "many": "batches begin with the designs, as Isolator.many(...).second_approximation",
    "certify": "what is proved is proved of the averaged equations",
    "plot": text(
        "its answers are drawn by their own .plot(); beside {u_cr} and where the mass stops by the oscillator's"
    ),
}


@dataclass(frozen=True)
class SecondApproximation:
    """The questions of an oscillator in the second approximation; `.second_approximation` of an oscillator makes it.

    Answers have the largest displacement as A, and the amplitude of the first harmonic as A_1. Arguments and errors are
    the oscillator's. Inside, as in the kernels, A is A_1 + a_3 + a_5: friction's harmonics take a little off it.
    Raises ValueError where these harmonics are not derived.

    Averaging's curve is complete, and the branches of the second approximation are those that come of it where the
    harmonics are small; what is lost on the way is told in words. Nothing here is proved beyond that.

    first -- the oscillator, averaged
    """

    first: Averaged

    def __post_init__(self) -> None:
        mechanism = self.first.model.mechanism
        for u_cr in self.first.breakpoints:
            if u_cr > mechanism.harmonics_up_to:
                raise Refused(NOT_DERIVED.format(u_cr, mechanism.harmonics_up_to))

    def __getattr__(self, name: str) -> Any:
        """Raises AttributeError, with the reason where averaging answers the question of that name."""
        why = f": {UNANSWERED[name]}" if name in UNANSWERED else ""
        raise AttributeError(f"the second approximation has no {name}{why}")

    def explain(self, question: str, F_0: float | None = None) -> Plan:
        """What runs for a question: averaging's plan, and what is made of its answer; see `Averaged.explain`.

        Raises ValueError as that, and for a question that the second approximation does not answer.
        """
        if question not in SECOND:
            why = f"; {question}: {UNANSWERED[question]}" if question in UNANSWERED else ""
            allowed = f"{', '.join(SECOND)}{why or validate.meant(question, SECOND)}"
            raise Refused(f"question = {question!r} is not allowed: it must be one of {allowed}")
        first = self.first.explain(question, F_0)
        skipped = first.sticks or (question == "saddle_nodes" and not first.folds)
        after = Step("harmonics", not skipped, "nothing to begin with" if skipped else SECOND[question])
        return replace(first, steps=(*first.steps, after))

    def frequency_response(
        self, F_0: float, *, samples: int = 1000, Omega: tuple[float, float] = validate.WINDOW
    ) -> SecondResponse:
        """The response curve, as the first approximation's points move to it, with its peak among them."""
        F_0 = validate.number("F_0", F_0, above=0.0)
        samples, window = validate.curve(samples, Omega)
        model = self.first.model
        if model.sticks(F_0):
            none = np.empty(0)
            columns = (none, none, none, none, np.empty(0, bool))
            said, rest = self._remarked(words.sticks(model, F_0), none, none), (np.empty(0, np.intp), ())
            return SecondResponse(*columns, said, *rest, F_0=F_0, force=none, _model=model)
        curve = compiled.along(self.first.model, F_0, samples, window)
        Omega_, u_max, A_1, phi, stable, branch = self._with_peak(curve, F_0, samples)
        if not model.stays_centred:
            stable = stable & self._stay(Omega_, u_max)
        return SecondResponse(
            *(Omega_, u_max, A_1, phi, stable, self._remarked(curve.message, Omega_, u_max)),
            *(branch, curve.isola),
            F_0=F_0,
            force=self._force(F_0, Omega_),
            _model=model,
            _lost=curve.lost,
        )

    def amplitudes(self, *, Omega: Any, F_0: Any) -> SecondStates:
        """Every steady state at the frequency Omega, or at each of an array of frequencies: where the curve crosses.

        F_0 may be an array that broadcasts with Omega, as in `Averaged.amplitudes`; as there A = 0 is a steady state
        where friction holds the mass.
        """
        if not validate.is_single(F_0):
            names = ("Omega", "A", "A_1", "phi", "stable", "force")
            several = at_pairs(lambda at, one: self.amplitudes(Omega=at, F_0=one), Omega, F_0, names)
            return SecondStates(**several.columns, F_0=several.F_0, message=several.message(), _model=self.first.model)
        first = self.first.states(Omega=Omega, F_0=F_0)
        wanted = np.asarray(Omega, dtype=float).ravel()
        found: list[State] = []
        if wanted.size and first.A.size:
            curve = self._around(F_0, wanted, Wanted.EVERY_POINT)
            found = compiled.states(self.first.model, curve, wanted, float(F_0))
        at, u_max, A_1, phi, stable = np.array(found).reshape(-1, 5).T
        fewer = int(np.count_nonzero(_counts(wanted, at) < _counts(wanted, first.Omega)))
        message = joined(first.message, FEWER.format(fewer, wanted.size) if fewer else "")
        stays = (stable != 0) & self._stay(at, u_max)
        columns, message = self._with_rests(first, wanted, (at, u_max, A_1, phi, stays), message)
        return SecondStates(
            **columns,
            message=self._remarked(message, at, u_max) if found else message,
            F_0=first.F_0,
            force=self._force(F_0, columns["Omega"]),
            _model=self.first.model,
            _lost=fewer > 0,
        )

    def _with_rests(
        self, first: SteadyStates, wanted: Floats, moving: tuple[Any, ...], message: str
    ) -> tuple[dict[str, Any], str]:
        """Columns and message of the states with those at which friction holds the mass: these have no harmonics."""
        model, averaged = self.first.model, self.first._with_rests(first, wanted)
        rest = averaged.A == 0
        at_rest = (averaged.Omega[rest], 0.0, 0.0, averaged.phi[rest], True)
        pairs = zip(("Omega", "A", "A_1", "phi", "stable"), zip(moving, at_rest, strict=True), strict=True)
        columns = with_rests(wanted, model.rests(first.F_0, wanted), moving[0], dict(pairs))
        return columns, joined(message, words.moves_exactly(model, model.force(first.F_0, wanted)))

    def saddle_nodes(self, F_0: float) -> SecondFolds:
        """Every fold of the response curve between two of its points, by rising Omega.

        Averaging's curve is complete, and so are the branches that are followed from it; folds are searched for along
        them, in 600 points, not proved. What lies where the harmonics are not small is left out, in words.
        """
        F_0 = validate.number("F_0", F_0, above=0.0)
        of_curve = None if self.first.model.sticks(F_0) else compiled.saddle_nodes(self.first.model, F_0)
        found, lost, message = of_curve or self._folds_by_steps(F_0)
        at, u_max, A_1, up, corner = np.array(found).reshape(-1, 5).T
        # what a sweep leaves for a larger amplitude has its stable side below
        kind = np.where(up != 0, "jump-up", "jump-down")
        message = self._remarked(message, at, u_max)
        return SecondFolds(at, u_max, A_1, kind, corner != 0, F_0, message, _lost=lost)

    def peak(self, F_0: float) -> Peak:
        """The highest point of the curve about the first approximation's highest peak: its largest displacement A."""
        first = self.first.peak(F_0)
        if first.Omega is None:
            return first
        if first.Omega == 0:
            return Peak(None, None, first.F_0, NO_PEAK.format(AT_REST))
        curve = self._around(first.F_0, np.array([first.Omega]), Wanted.TOP_ONLY)
        found = compiled.peak(self.first.model, curve, first.F_0)
        if found is None:
            return Peak(None, None, first.F_0, joined(NO_PEAK.format(LEFT_OUT), curve.message))
        u_max, Omega = found
        return Peak(u_max, Omega, first.F_0, self._remarked("", np.array([Omega]), np.array([u_max])))

    def saddle_node_onset(self) -> SaddleNodeOnset:
        """The lowest forcing that has a fold, where that is a cusp."""
        first = self.first.saddle_node_onset()
        if first.F_SN is None or first.Omega is None or first.A is None:
            return first
        if first.kind != "cusp":
            return SaddleNodeOnset(None, None, None, "", NO_CUSP.format(first.kind))
        found = compiled.cusp(self.first.model, first.F_SN, first.Omega, first.A)
        if found is None:
            return SaddleNodeOnset(None, None, None, "", FAR)
        F_SN, Omega, u_max = found
        return SaddleNodeOnset(F_SN, Omega, u_max, first.kind, first.message)

    def detachment(self) -> Detachment:
        """The lowest forcing whose largest displacement is u_cr."""
        first = self.first.detachment()
        if first.F_cr is None or first.Omega_cr is None or first.u_cr is None:
            return first
        if first.Omega_cr == 0:
            return Detachment(None, None, first.u_cr, STATIC)
        found = compiled.detachment(self.first.model, first.F_cr, first.Omega_cr, first.u_cr)
        if found is None:
            return Detachment(None, None, first.u_cr, FAR)
        F_cr, Omega_cr = found
        return Detachment(F_cr, Omega_cr, first.u_cr, first.message)

    def _folds_by_steps(self, F_0: float) -> Folds:
        """Folds, where averaging's and its peak are asked for first: balls may have to tell these."""
        first, peak = self.first.folds(F_0), self.first.peak(F_0)
        marks = [*first.Omega.tolist(), *([peak.Omega] if peak.Omega else [])]
        if not marks:
            return Folds([], 0, first.message)
        curve = self._around(F_0, np.array(marks), Wanted.FOLDS_ONLY)
        return compiled.folds(self.first.model, curve, F_0)

    def _with_peak(self, curve: Curve, F_0: float, samples: int) -> tuple[Any, ...]:
        """The columns of a curve, with its highest point where few samples leave that between two of them.

        It is that of the curve in which `peak` looks for it, which takes longer than few points do.
        """
        columns = curve.Omega, curve.u_max, curve.A_1, curve.phi, curve.stable, curve.branch
        first = self.first.peak(F_0).Omega if samples < SAMPLES else None
        if not (first and curve.Omega.size and curve.Omega.min() < first < curve.Omega.max()):
            return columns
        beside = self._around(F_0, np.array([first]), Wanted.TOP_ONLY)
        u_max, Omega = compiled.peak(self.first.model, beside, F_0) or (0.0, 0.0)
        highest = int(curve.u_max.argmax())
        behind = highest > 0 and (curve.Omega[highest - 1] < Omega) == (Omega < curve.Omega[highest])
        ends = curve.Omega[max(highest - 1, 0) : highest + 2]
        if not (u_max > HIGHER * curve.u_max[highest] and ends.min() < Omega < ends.max()):
            return columns
        there = compiled.states(self.first.model, beside, np.array([Omega]), F_0)
        top = min(there, key=lambda one: abs(one.u_max - u_max), default=None)
        if top is None or not top.u_max > HIGHER * curve.u_max[highest]:
            return columns
        point = *top, curve.branch[highest]
        return tuple(
            np.insert(column, highest + (not behind), value) for column, value in zip(columns, point, strict=True)
        )

    def _stay(self, Omega: Floats, A: Floats) -> remarks.Flags:
        """Which states stay about u = 0, as averaging has it: others are not stable."""
        model = self.first.model
        if model.stays_centred:
            return np.ones(A.size, dtype=bool)
        return remarks.keeps_centre(model.mechanism, model.parameters, Omega, A)

    def _remarked(self, message: str, Omega: Floats, A: Floats) -> str:
        """The message with what there is to say of amplitudes beyond the reach, and of motions that stop."""
        model = self.first.model
        beside = remarks.of_one(model, math.nan, Omega, A) & ~Remark.OF_TRUNCATION
        return joined(message, *remarks.in_words(beside, model, math.nan), validity.of_second(model, Omega, A))

    def _force(self, F_0: float, Omega: Floats) -> Floats:
        """The amplitude of the force at each frequency."""
        force = self.first.model.force(F_0, Omega)
        return np.asarray(force) if self.first.model.inertial else np.full(Omega.shape, force)

    def _around(self, F_0: float, Omega: Floats, wanted: Wanted) -> Curve:
        """The curve that holds some frequencies and what may lie beside them."""
        shown = (float(Omega.min()) / BEYOND, float(Omega.max()) * BEYOND)
        return compiled.along(self.first.model, F_0, SAMPLES, shown, wanted)


def _counts(wanted: Floats, values: Floats) -> npt.NDArray[np.intp]:
    """How often each wanted value is among the values."""
    known = np.sort(values)
    return np.searchsorted(known, wanted, "right") - np.searchsorted(known, wanted, "left")
