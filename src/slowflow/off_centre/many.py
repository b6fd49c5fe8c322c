"""Batches of oscillators whose motions have a mean.

The functions are those of `OffCentre`. Each design is computed like a single one, with the same digits
and in the same time. Invalid designs, and designs without a result, have NaN and a status.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np

from slowflow.answers.gradient import Gradient
from slowflow.answers.results import Remark
from slowflow.answers.table import AVERAGING, MORE_POINTS, OFFSET, QUESTIONS, SHOCKS, ManyQuestions, Unanswered
from slowflow.averaged import batch_checks, checks, many
from slowflow.averaged.batches import Batch
from slowflow.averaged.checks import Spectrum
from slowflow.averaged.many import Question, failed, kinds
from slowflow.averaged.questions import Averaged
from slowflow.core import validate
from slowflow.core.mechanism import Mechanism
from slowflow.core.model import CENTRED, WITH_MEAN, Floats, Model, off_centre_by
from slowflow.core.validate import NotAvailable
from slowflow.exact import shocks_many
from slowflow.off_centre import by_amplitudes
from slowflow.off_centre.answers import NUMBERS
from slowflow.off_centre.flow import Flow
from slowflow.off_centre.means import NO_MEANS, NOT_SMOOTH, Steps
from slowflow.off_centre.questions import OffCentre
from slowflow.random_vibration import many as random_many
from slowflow_kernels.conventions import GradientStatus, Status
from slowflow_kernels.domains import DAMPING

NO_GRADIENT = (
    "for offset motions, gradients are available for states, folds, onsets, detachments, peaks, isolation and "
    "equilibria only"
)
#: designs that are kept with what is known of them, some 0.2 MB each
KEPT = 256
#: one design's answer by column, and what to bear in mind with it
Found = tuple[dict[str, Any], Remark]


class OffCentreBatch(Batch):
    """An answer about offset motions: `remarks` and gradients are those of the single answers."""

    def gradient(self) -> Gradient:
        """The exact gradients with respect to the parameters, the load and the arguments of the query, for each design.

        `.slopes` have shape (..., numbers, parameters), after the shape of the columns; they are those of the single
        answers, which are computed again if no longer cached. `.status` and `.message` say which designs have no answer
        or no gradient. For a peak, the slopes of `u_max` are NaN if it belongs to another motion; so are slopes with
        respect to eta and c_2 for designs that have neither.

        Raises Refused if the derivatives of the force with respect to the design are not known, and for an answer
        without gradient.
        """
        if (names := NUMBERS.get(self.question.name)) is None:
            raise NotAvailable(NO_GRADIENT)
        arguments, numbers = self.arguments, self._inputs
        known = dict(zip(numbers, np.broadcast_arrays(*numbers.values()), strict=True))
        laws = WITH_MEAN if any(name in numbers for name in WITH_MEAN) else ()
        moving = (name for name in arguments if name != "level_dB")  # of which no answer has a gradient
        by = (*self._designs.mechanism.design_names, *(one.name for one in DAMPING), *laws, "load", *moving)
        columns = tuple(getattr(self, name) for name in names)
        several = columns[0].ndim > self.status.ndim
        slopes = np.full((*columns[0].shape, len(names), len(by)), np.nan)
        status = np.full(columns[0].shape, GradientStatus.NOTHING, np.int8)
        answered = np.isin(self.status, (Status.OK, Status.TOO_MANY))
        for place, own_numbers, at in self._designs._each(answered, *arguments.values()):
            single = self._designs._single(tuple(own_numbers))
            answer = getattr(single, self.question.name)(**dict(zip(arguments, at, strict=True)))
            if getattr(answer, "_turns", False):  # the peak is on the balance of another mean, too
                status[place] = GradientStatus.MEETS
                continue
            found = answer.gradient()
            own = (*place, slice(0, len(found.status))) if several else place
            kept = slice(0, status.shape[-1]) if several else ...
            for row, name in enumerate(names):
                if name in found.of:
                    indices = [by.index(parameter) for parameter in found.by]
                    slopes[(*own, row)][..., indices] = found[name][kept]
            status[own] = found.status[kept]
        none = np.zeros(self.status.shape)
        at = tuple(known.get(name, none)[..., np.newaxis] if several else known.get(name, none) for name in by)
        return Gradient(names, by, slopes, status, columns, at)


class OffCentreDesigns(many.Designs):
    """Arrays of designs of one mechanism under static loads, and the questions about their offset motions.

    values     -- as in `slowflow.averaged.many.Designs`, with "load"
    excitation -- as in `slowflow.averaged.many.Designs`; friction acts throughout

    `workers` has no effect: these searches run in Python, in one thread at a time. To use several processes, divide the
    designs, or use the blocks of a grid with dask's processes.

    Raises TypeError and ValueError as that class, and ValueError for a force that is not a piecewise polynomial.
    """

    _singles: dict[tuple[float, ...], OffCentre]

    def __init__(self, mechanism: Mechanism, values: dict[str, Any], excitation: str = "force") -> None:
        check_polynomial(mechanism)
        super().__init__(mechanism, {name: value for name, value in values.items() if name != "load"}, excitation)
        numbers = {**self.values, "load": validate.real_array("load", values["load"])}
        # not by attribute: these cannot be set
        self.__dict__.update(values=numbers, shape=validate.common_shape(numbers), _singles={})

    @property
    def _settings(self) -> dict[str, str]:
        """What is the same for all designs, by name; friction acts throughout."""
        return {"excitation": self.excitation}

    rest = ManyQuestions.rest
    at_rest = certify = Unanswered("of motions about the centre")

    def __getattr__(self, name: str) -> Any:
        if name in ("at_rest", "certify", "second_approximation"):  # which designs without a load have
            raise validate.NoAttribute(CENTRED.format(name, off_centre_by(self.mechanism, 0.0) or "a load"))
        why = ", a single oscillator has it" if hasattr(OffCentre, name) else ""
        raise AttributeError(f"the offset motions of many designs have no {name}{why}")

    def model(self, numbers: dict[str, float]) -> Model:
        """Model of one design without its load, from numbers by name. Raises ValueError for one outside its domain."""
        return super().model({name: value for name, value in numbers.items() if name != "load"})

    def _ask(self, question: str, /, *, workers: int = 1, **kwargs: Any) -> Batch:
        """The answer to a question by its name, from what its method takes."""
        validate.workers(workers)
        if question == "random":
            return random_many.answer(self, **kwargs, workers=workers)
        if question == "spectrum":
            return self._spectrum(**kwargs)
        if question in SHOCKS:
            batch = partial(OffCentreBatch, system=OFFSET)
            return shocks_many.answer(
                self, question, **kwargs, at_rest=lambda one: self._single(tuple(one.values())), batch=batch
            )
        row, points = QUESTIONS[question], 0
        one: Callable[..., Found] = _margins if question == "margins" else _columns
        arguments = {name: kwargs.pop(name) for name in (*row.takes, *row.may) if kwargs[name] is not None}
        options = {name: value for name, value in kwargs.items() if name not in row.may}
        if question == "frequency_response":
            options["samples"], options["Omega"] = window = validate.curve(kwargs["samples"], kwargs["Omega"])
            one, points = partial(_curve, *window), options["samples"] + MORE_POINTS[OFFSET]
        return self._answered(Question(question, one, None, 1, OFFSET, points), arguments, workers, options)

    def _by_doubles(self, question: str, *, max_count: int, **at: Any) -> Batch:
        """Folds or states; where the force of a design rises with u, without a proof."""
        tones = {name: np.asarray(value, dtype=float) for name, value in at.items()}
        shape = validate.common_shape({**self.values, **tones})
        columns = QUESTIONS[question].blank(OFFSET, shape, place=max_count)
        columns["status"][...] = Status.INVALID
        others = (slice(None),) * (len(shape) - len(self.shape))
        for place, numbers, _ in self._each(np.ones(self.shape, dtype=bool)):
            here = (*others, *(slice(None) if n == 1 else k for k, n in zip(place, self.shape, strict=True)))
            own = {name: np.broadcast_to(tone, shape)[here] for name, tone in tones.items()}
            for name, column in self._of_design(question, tuple(numbers), max_count, own).items():
                columns[name][here] = column
        return OffCentreBatch(question, columns, self, at, OFFSET, remarks=np.zeros(shape, np.uint16))

    def _of_design(
        self, question: str, numbers: tuple[float, ...], max_count: int, at: Mapping[str, Any]
    ) -> Mapping[str, Any]:
        """Columns of all folds, or states, of one design."""
        try:
            model, load = self._model(numbers), numbers[-1]
            steps, flow = Steps(model.mechanism, model.parameters, load), Flow.of(model)
            solve = by_amplitudes.states if question == "amplitudes" else by_amplitudes.folds
            found = solve(steps, flow, **{name: tone.ravel() for name, tone in at.items()}) if load else None
        except (ValueError, ArithmeticError) as error:
            return {"status": failed(error)}
        if found is None:
            one = OffCentreDesigns(self.mechanism, dict(zip(self.values, numbers, strict=True)), self.excitation)
            return one._ask(question, max_count=max_count, **at)._values
        of, values = found
        shape = at["F_0"].shape
        columns = QUESTIONS[question].blank(OFFSET, (at["F_0"].size,), place=max_count)
        place = np.arange(of.size) - np.searchsorted(of, of)
        there = place < max_count
        for name, value in values.items():
            columns[name][of[there], place[there]] = value[there]
        columns["count"][...] = np.bincount(of, minlength=at["F_0"].size)
        columns["status"][...] = np.where(columns["count"] > max_count, Status.TOO_MANY, Status.OK)
        return {name: column.reshape((*shape, *column.shape[1:])) for name, column in columns.items()}

    def _spectrum(self, Omega: Any, F_0: Any) -> Batch:
        """Rows with several forcings take some tenths of a second each."""
        arguments = {"Omega": validate.real_array("Omega", Omega), "F_0": validate.real_array("F_0", F_0)}
        by_rows = {name: value[..., np.newaxis] for name, value in self.values.items()}
        rows = OffCentreDesigns(self.mechanism, by_rows, self.excitation)
        shape = validate.common_shape({**rows.values, **arguments})
        tones = [np.broadcast_to(value, shape).astype(float) for value in arguments.values()]
        columns = QUESTIONS["spectrum"].blank(OFFSET, shape[:-1], row=shape[-1])
        remarks = np.zeros(shape, np.uint16)
        (status := columns.pop("status"))[...] = Status.INVALID
        for place, own, _ in self._each(np.ones(shape[:-1], dtype=bool)):
            for run in _runs(*(tone[place] for tone in tones)):
                found, status[place][run] = self._tones(tuple(own), *(tone[place][run] for tone in tones))
                if found is None:
                    continue
                for name, column in columns.items():
                    column[place][run] = getattr(found, name)
                remarks[place][run] = found._remarks
                if run.start:  # what is crossed on the way from a row that is none is not known
                    status[place][run.start] = Status.INVALID
        at = {"F_0": F_0, "Omega": Omega}
        return OffCentreBatch("spectrum", {**columns, "status": status}, rows, at, OFFSET, remarks=remarks)

    def _tones(self, numbers: tuple[float, ...], Omega: Floats, F_0: Floats) -> tuple[Spectrum | None, Any]:
        """The rows of one design, and how they fared."""
        try:
            single: Any
            if self.mechanism.odd and numbers[-1] == 0:
                single = Averaged(self._model(numbers))
            elif not Flow.of((single := self._single(numbers)).model.unloaded).damps:
                return None, Status.UNBOUNDED
            found = checks.spectrum(single, Omega, F_0)
        except (ValueError, ArithmeticError) as error:
            return None, failed(error)
        return found, np.where(found.sticks, Status.STICKS, np.where(found.motions > 0, Status.OK, Status.NONE))

    def _answered(self, question: Question, at: dict[str, Any], workers: int, options: Mapping[str, Any]) -> Batch:
        """Columns by the table, design by design; the solvers of offset motion use one thread.

        options -- what the question takes that is the same for all designs
        """
        max_count = validate.count("max_count", options["max_count"], least=1) if "max_count" in options else 0
        arguments = {name: validate.real_array(name, value) for name, value in at.items()}
        values = {**self.values, **arguments}
        shape = validate.common_shape(values)
        columns, remarks = question.blank(max_count, Status.INVALID, shape), np.zeros(shape, np.uint16)
        at_centre = np.zeros(shape, dtype=bool)
        if self.mechanism.odd and AVERAGING in QUESTIONS[question.name].columns:
            at_centre = np.broadcast_to(self.values["load"] == 0, shape)
        if at_centre.any():
            known = zip(values, np.broadcast_arrays(*values.values()), strict=True)
            centred = self._centred(question.name, {name: one[at_centre] for name, one in known}, workers, options)
            for name, column in columns.items():
                column[at_centre] = _of_centred(centred, name)
            remarks[at_centre] = centred.remarks
        for place, own, numbers in self._each(~at_centre, *arguments.values()):
            found, remarks[place] = self._of_one(question, tuple(own), dict(zip(at, numbers, strict=True)), max_count)
            many._put(list(columns.values()), place, found)
        return OffCentreBatch(question.name, columns, self, at, OFFSET, remarks=remarks)

    def _centred(self, question: str, numbers: dict[str, Any], workers: int, options: Mapping[str, Any]) -> Batch:
        """The answer of designs without a load about the centre, as the single one is.

        Motions that leave it by themselves are `.off_centre`'s.
        """
        own = {name: numbers[name] for name in self.values if name != "load"}
        options = {**options, **{name: value for name, value in numbers.items() if name not in self.values}}
        return batch_checks.Designs(self.mechanism, own, self.excitation)._ask(question, **options, workers=workers)

    def _of_one(self, question: Question, numbers: tuple[float, ...], at: dict[str, float], max_count: int) -> Found:
        """One design's answer, with a status in place of an exception."""
        assert question.one is not None
        name, F_0 = question.name, at.get("F_0")
        try:
            single = self._single(numbers)
            if F_0 is not None:
                validate.number("F_0", F_0, above=0.0)
                if "Omega" in at:
                    validate.frequencies("Omega", at["Omega"])
            dynamic = F_0 is not None or name == "saddle_node_onset"
            damps = not dynamic or Flow.of(single.model.unloaded).damps
            if F_0 is not None and single.model.sticks(F_0) and not (damps and name in ("margins", "amplitudes")):
                return question.blank(max_count, Status.STICKS), Remark(0)
            if not damps:
                return question.blank(max_count, Status.UNBOUNDED), Remark(0)
            found: Found = question.one(question, max_count, single, *at.values())
            return found
        except (ValueError, ArithmeticError) as error:
            return question.blank(max_count, failed(error)), Remark(0)

    def _single(self, numbers: tuple[float, ...]) -> OffCentre:
        """One design, which keeps for a while what it has been asked already. Raises ValueError for what is none."""
        if (known := self._singles.get(numbers)) is None:
            model = self._model(numbers)
            known = self._singles[numbers] = OffCentre(model, validate.number("load", numbers[-1]))
            if len(self._singles) > KEPT:
                self._singles.pop(next(iter(self._singles)), None)
        return known


def check_polynomial(mechanism: Mechanism) -> None:
    """Raise ValueError for a force whose offset motions are not supported."""
    if mechanism.steps is None and mechanism.curved is None:
        raise validate.NotAvailable("load is not available for " + NO_MEANS.format(mechanism.name, NOT_SMOOTH))


#: what a column is called of answers about the centre, where it has another name
AS_CENTRED = {"A": "u_cr", "u_max": "A", "Omega_max": "Omega"}


def _of_centred(found: Batch, name: str) -> Any:
    """A column of an answer about the centre, by its name off it: B is 0 where there is a motion."""
    source = name if hasattr(found, name) else AS_CENTRED.get(name, "A")
    if name == "B":
        return np.where(np.isnan(getattr(found, source if hasattr(found, source) else "u_cr")), np.nan, 0.0)
    return getattr(found, source)


def _runs(Omega: Floats, F_0: Floats) -> list[slice]:
    """Rows next to each other that are tones."""
    with np.errstate(invalid="ignore"):
        allowed = np.isfinite(Omega) & np.isfinite(F_0) & (Omega > 0) & (F_0 > 0)
    ends = np.flatnonzero(np.diff(np.concatenate(([False], allowed, [False])))).reshape(-1, 2)
    return [slice(*pair) for pair in ends.tolist()]


def _columns(question: Question, max_count: int, single: OffCentre, *at: float) -> Found:
    """A single answer in the columns of a batch."""
    name, row = question.name, QUESTIONS[question.name]
    found = getattr(single, name)(**dict(zip((*row.takes, *row.may), at, strict=False)))
    columns = question.columns(found, max_count)
    status = columns["status"]
    if name in ("detachment", "saddle_node_onset") and status == Status.NONE and Remark.UNDECIDED in found.remarks:
        status[...] = Status.UNRESOLVED
    if name == "amplitudes" and status == Status.OK and len(found) and not found.A.any():
        status[...] = Status.STICKS
    return columns, found.remarks


def _curve(
    samples: int, window: tuple[float, float], question: Question, max_count: int, single: OffCentre, F_0: float
) -> Found:
    found, folds = single.frequency_response(F_0, samples=samples, Omega=window), single.saddle_nodes(F_0)
    return question.columns((found, folds), max_count), folds.remarks | found.remarks


def _margins(question: Question, max_count: int, single: OffCentre, F_0: float) -> Found:
    found, onset, columns = single.margins(F_0), single.saddle_node_onset(), question.blank(max_count, Status.OK)
    unknown = Remark.UNDECIDED in onset.remarks
    for name in ("F_SN", "of_SN", "F_cr", "of_cr", "folds", "detaches", "sticks", "Omega_sticks"):
        missing = math.nan if unknown and name.endswith("_SN") else math.inf
        columns[name][...] = missing if (value := getattr(found, name)) is None else value
    columns["kind"][...] = kinds(found)
    if onset.F_SN is None:
        columns["onset"][...] = Status.UNRESOLVED if unknown else Status.NONE
    return columns, found.remarks
