"""Batches in the second approximation.

Results are those of `slowflow.averaged.batches`, with the largest displacement as A. `Status.NONE` marks designs
without a result in the second approximation, for example because the harmonics are not small; averaging may have a
result. `Status.INVALID` also marks designs with a force whose harmonics are not derived. States and curves are computed
one by one, in some milliseconds each.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow.answers.answer import frozen
from slowflow.answers.table import MORE_POINTS, QUESTIONS, SECOND, ManyQuestions, Unanswered
from slowflow.answers.transmissibility import Transmitted, in_motion, validated
from slowflow.averaged.batches import OF_STATES, Batch
from slowflow.averaged.many import Designs, Question
from slowflow.averaged.questions import Averaged
from slowflow.core import validate
from slowflow.core.backend import SOLVER
from slowflow.core.mechanism import Floats, Reals
from slowflow.second.questions import UNANSWERED, SecondApproximation
from slowflow_kernels import motion
from slowflow_kernels.conventions import Status


class SecondBatch(Batch):
    """An answer of the second approximation, with the transmissibility of the waveform for states and curves."""

    @cached_property
    def transmissibility(self) -> Floats:  # type: ignore[override]
        """As in `SecondStates`; NaN for empty entries. Computed on first use."""
        self._has("transmissibility", *OF_STATES)
        with np.errstate(all="ignore"):  # empty places
            force = self._designs._flow.force(self._forcing, self._frequency)
            passed = motion.transmissibility(self._frequency, self.A_1, force, self.phi)
            return frozen(in_motion(self.A, passed))

    def transmitted(self, of: str = "force") -> Transmitted:
        """As in `SecondStates`; NaN for empty entries. It takes about 0.1 ms per state, one design after another."""
        from slowflow.second.wave import Waves

        self._has("transmitted", *OF_STATES)
        designs, Omega = self._designs, np.broadcast_to(self._frequency, self.A.shape)
        validated(of, inertial=designs.excitation != "force")
        columns = Transmitted(*(np.full(self.A.shape, np.nan) for _ in Transmitted._fields))
        here = ~np.isnan(self.A)
        for at, numbers, (F_0,) in designs._each(here.any(axis=-1), self._F_0):
            model, rows = designs._model(numbers), (*at, here[at])
            forcing = np.full(np.count_nonzero(here[at]), F_0)
            passed = Waves(model, Omega[rows], self.A[rows], self.phi[rows], forcing).transmitted(of)
            for column, value in zip(columns, passed, strict=True):
                column[rows] = value
        return Transmitted(*map(frozen, columns))


@dataclass(frozen=True)
class SecondDesigns(ManyQuestions[SecondBatch, Reals]):
    """The questions about many designs in the second approximation, made by `.second_approximation` of designs.

    `workers` as for the designs.

    first -- the averaged designs
    """

    first: Designs

    @property
    def _settings(self) -> dict[str, str]:
        """Those of the averaged designs."""
        return self.first._settings

    def _with_values(self, values: dict[str, Any]) -> SecondDesigns:
        """The same kind of designs with other numbers."""
        return SecondDesigns(self.first._with_values(values))

    def _ask(self, question: str, /, *, workers: int = 1, **kwargs: Any) -> SecondBatch:
        """The answer to a question by its name, from what its method takes."""
        row = QUESTIONS[question]
        at = {name: kwargs[name] for name in row.takes}
        max_count = validate.count("max_count", kwargs.get("max_count", 1), least=1)
        if question == "frequency_response":
            columns = self.first.ask(_curves(*validate.curve(kwargs["samples"], kwargs["Omega"])), 1, **at)
        else:
            threads = 1 if question == "amplitudes" else workers
            columns = self.first.ask(BY_NAME[question], threads, max_count=max_count, **at)
        if question == "amplitudes":
            self._insert_states_at_rest(columns, **at)
        values = dict(zip(row.columns[SECOND], columns, strict=True))
        return SecondBatch(question, values, self.first, at, SECOND)

    def _insert_states_at_rest(self, columns: list[npt.NDArray[Any]], F_0: Any, Omega: Any) -> None:
        """States at rest first, as of averaging, with the phase that these have."""
        A, A_1, phi, stable, count, _, status = columns
        with np.errstate(all="ignore"):  # a number outside its domain has a status
            flow = self.first._flow
            phase = flow.phase(np.asarray(Omega, dtype=float), 0.0, flow.averaged(0.0)[0])
        pairs = ((A, 0.0), (A_1, 0.0), (phi, phase), (stable, 1))
        self.first._insert_states_at_rest(Omega, F_0, pairs, count, status)


for _name, _row in QUESTIONS.items():
    if SECOND not in _row.columns:
        _why = f"the second approximation of many designs has no {_name}: {UNANSWERED[_name]}"
        setattr(SecondDesigns, _name, Unanswered(_why))


def _second(question: str) -> Callable[..., Any]:
    """The single answer of an averaged oscillator; from doubles only, whatever the allowance."""

    def one(oscillator: Averaged, _: Any, *at: float) -> Any:
        arguments = dict(zip(QUESTIONS[question].takes, at, strict=True))
        return getattr(SecondApproximation(oscillator), question)(**arguments)

    return one


def _onset(oscillator: Averaged, _: Any) -> Any:
    remarks = oscillator.saddle_node_onset().remarks
    return replace(SecondApproximation(oscillator).saddle_node_onset(), remarks=remarks)


def _amplitudes(oscillator: Averaged, _: Any, F_0: float, Omega: float) -> Any:
    found = SecondApproximation(oscillator).amplitudes(Omega=Omega, F_0=F_0)
    moving = found.A > 0  # those at rest are put in for all designs together
    return replace(found, **{name: getattr(found, name)[moving] for name in ("Omega", "A", "A_1", "phi", "stable")})


def _curves(samples: int, window: tuple[float, float]) -> Question:
    """The question about response curves of so many samples in a window of Omega."""

    def one(oscillator: Averaged, _: Any, F_0: float) -> Any:
        return SecondApproximation(oscillator).frequency_response(F_0, samples=samples, Omega=window)

    return Question("frequency_response", one, None, 1, SECOND, samples + MORE_POINTS[SECOND], Status.NONE)


#: by name
BY_NAME: Mapping[str, Question] = {
    "amplitudes": Question("amplitudes", _amplitudes, None, 1, SECOND, empty=Status.NONE),
    **{
        name: Question(name, one, getattr(SOLVER, f"many_second_{of}"), at_once, SECOND)
        for name, one, of, at_once in (
            ("detachment", _second("detachment"), "detachment", 2**13),
            ("saddle_node_onset", _onset, "onset", 2**13),
            ("saddle_nodes", _second("saddle_nodes"), "saddle_nodes", 2**9),
            ("peak", _second("peak"), "peak", 2**9),
        )
    },
}
