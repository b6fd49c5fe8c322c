"""Batches of averaged oscillators: critical forces, folds, states, peaks and curves.

Batches are made by `Isolator.many(...)` and `Duffing.many(...)` from arrays that broadcast. Designs that double
precision leaves undecided are resolved in ball arithmetic, if python-flint is installed. With `workers`, several
threads share the designs (-1: one thread for each processor) and give the same digits. Ctrl-C takes effect within a
second.

Invalid designs, and designs without a result, have NaN. Their `status` gives the reason, as a code of
`slowflow_kernels.conventions.Status`; it is 0 for a result.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice
from operator import attrgetter
from types import MappingProxyType
from typing import Any, Self

import numpy as np
import numpy.typing as npt

from slowflow.answers.answer import same
from slowflow.answers.results import Remark
from slowflow.answers.table import AVERAGING, DOUBLES, MORE_POINTS, QUESTIONS, Codes, ManyQuestions, Unanswered
from slowflow.averaged import diagnostics, messages, proofs, solvers
from slowflow.averaged.batches import Batch
from slowflow.averaged.chunks import blocks, map_chunks
from slowflow.averaged.defined import check_defined, may_be_undefined
from slowflow.averaged.questions import Averaged
from slowflow.core import backend, validate
from slowflow.core.mechanism import Flags, Mechanism, Reals
from slowflow.core.model import THROUGHOUT, Floats, Laws, Model, SlowFlow, check_names
from slowflow.support import progress
from slowflow.support.errors import Refused
from slowflow.support.immutable import Unchanging
from slowflow.support.text import text, together
from slowflow_kernels import inertia
from slowflow_kernels.conventions import FoldKind, OnsetKind, Status
from slowflow_kernels.domains import DAMPING, DISSIPATION

__all__ = ["Designs"]

#: what a batch counts to; where rounding makes more of a curve's folds or states these are no answer
MOST_COUNTED = int(np.iinfo(np.int8).max)


def kinds(found: Any) -> Any:
    """Codes of the kind of an onset, or of each fold."""
    if isinstance(found.kind, str):
        return OnsetKind[found.kind.upper() or "NO"]
    names = (f"{fold.kind}{'-at-corner' * fold.corner}".upper().replace("-", "_") for fold in found)
    return [FoldKind.__members__.get(name, FoldKind.EMPTY) for name in names]


def failed(error: Exception) -> Status:
    """Status of a design that was refused or has no answer."""
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
    one     -- the answer of a single averaged oscillator, from an allowance of ball computations, F_0 and Omega; a
            curve comes with its folds; None for a proof, which only the compiled solvers give in double precision
    batch   -- generalized ufunc of the compiled solvers for a record; None if designs are evaluated one by one
    at_once -- number of designs that take some tenths of a second, after which Ctrl-C takes effect
    system  -- the system that answers it
    points  -- number of points of a curve
    empty   -- the status if there is nothing at a forcing
    """

    name: str
    one: Callable[..., Any] | None
    batch: Callable[[Any], Callable[..., Any]] | None
    at_once: int
    system: str = AVERAGING
    points: int = 0
    empty: Status = Status.OK

    def blank(self, max_count: int, status: Status, shape: tuple[int, ...] = ()) -> dict[str, npt.NDArray[Any]]:
        """Empty columns."""
        columns = QUESTIONS[self.name].blank(self.system, shape, place=max_count, point=self.points)
        columns["status"][...] = status
        return columns

    def columns(self, found: Any, max_count: int) -> dict[str, npt.NDArray[Any]]:
        """The columns of a single answer; for a curve with its folds, those of both."""
        if isinstance(found, tuple):
            curve, folds = found
            columns, of_folds = self.columns(curve, max_count), SADDLE_NODES.columns(folds, max_count)
            columns |= {f"fold_{name}": of_folds.pop(name) for name in ("Omega", "A", "kind")}
            if columns["status"] == Status.TOO_MANY:
                del of_folds["status"]
            of_folds["undecided"] |= columns["undecided"]
            if Remark.BY_BALLS in curve.remarks:
                of_folds["undecided"][...] = 0
            return columns | of_folds
        columns, axes = self.blank(max_count, Status.OK), QUESTIONS[self.name].columns[self.system]
        size, room = len(found) if any(axes.values()) else None, self.points or max_count
        if size is not None and size > MOST_COUNTED and not self.points:
            return self.blank(max_count, Status.UNRESOLVED)
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


def _saddle_nodes(oscillator: Any, allowance: proofs.Allowance, F_0: float) -> Any:
    return oscillator.folds(F_0, allowance=allowance)


def _amplitudes(oscillator: Any, allowance: proofs.Allowance, F_0: float, Omega: float) -> Any:
    return oscillator.states(Omega=Omega, F_0=F_0, allowance=allowance)


def _peak(oscillator: Any, _: proofs.Allowance, F_0: float) -> Any:
    """That of doubles; where the response goes on beyond a well a batch looks again."""
    found = solvers.peak(oscillator.model, F_0)
    return replace(found, _status=Status.NONE) if found._escapes else found


def curves(samples: int, window: tuple[float, float]) -> Question:
    """The question about response curves with a number of samples in a window of Omega."""
    n = samples + MORE_POINTS[AVERAGING]

    def one(oscillator: Any, allowance: proofs.Allowance, F_0: float) -> Any:
        found = oscillator.curve(F_0, samples=samples, Omega=window, allowance=allowance)
        return found, _saddle_nodes(oscillator, proofs.Allowance(0), F_0)

    def batch(record: Any) -> Callable[..., Any]:
        solve = backend.SOLVER.many_frequency_response(record)
        return lambda *columns, out: solve(*columns, float(samples), *window, out=out)

    at_once = min(2**12, max(1, 2**22 // n))
    return Question("frequency_response", one, batch, at_once, points=n)


DETACHMENT = Question("detachment", lambda one, _: one.detachment(), backend.SOLVER.many_detachment, 2**18)
ONSET = Question("saddle_node_onset", lambda one, left: one.onset(left), backend.SOLVER.many_onset, 2**14)
SADDLE_NODES = Question("saddle_nodes", _saddle_nodes, backend.SOLVER.many_saddle_nodes, 2**12)
AMPLITUDES = Question("amplitudes", _amplitudes, backend.SOLVER.many_amplitudes, 2**11)
PEAK = Question("peak", _peak, backend.SOLVER.many_peak, 2**13)
PROVED_FOLDS = Question("certify", None, backend.SOLVER.many_proved_saddle_nodes, 2**10)
PROVED_STATES = Question("certify", None, backend.SOLVER.many_proved_amplitudes, 2**10)
#: by name
BY_NAME = {one.name: one for one in (DETACHMENT, ONSET, SADDLE_NODES, AMPLITUDES, PEAK)}


class Designs(Unchanging, ManyQuestions[Batch, Reals]):
    """Arrays of designs of one mechanism, and the questions about them.

    mechanism -- record of the mechanism
    values    -- the parameters of its design by name, mu, zeta, and those of `DISSIPATION` that are used; real arrays
            that broadcast
    excitation -- kind of excitation with the amplitude F_0, the same for all: "force", "base" or "unbalance"
    contact   -- where dry friction acts, the same for all: "throughout" or "attached"

    Raises TypeError for a name that is missing or unknown.
    """

    mechanism: Mechanism
    values: dict[str, npt.NDArray[Any]]
    shape: tuple[int, ...]
    excitation: str
    contact: str

    def __init__(
        self, mechanism: Mechanism, values: dict[str, Any], excitation: str = "force", contact: str = THROUGHOUT
    ) -> None:
        names = check_names(mechanism, values, DISSIPATION)
        numbers = {name: validate.real_array(name, values[name]) for name in names}
        # not by attribute: these cannot be set
        self.__dict__.update(mechanism=mechanism, excitation=excitation, contact=contact, values=numbers)
        self.__dict__["shape"] = validate.common_shape(numbers)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Designs):
            return NotImplemented
        settings = attrgetter("mechanism", "excitation", "contact")
        return settings(self) == settings(other) and same(self.values, other.values)

    def __hash__(self) -> int:
        return hash((self.mechanism, *(value.tobytes() for value in self.values.values())))

    @property
    def _settings(self) -> dict[str, str]:
        """What is the same for all designs, by name."""
        return {"excitation": self.excitation, "contact": self.contact}

    def _with_values(self, values: dict[str, Any]) -> Self:
        """The same kind of designs with other numbers."""
        return type(self)(self.mechanism, values, **self._settings)

    @property
    def design(self) -> list[Floats]:
        """The parameters of the design, in the mechanism's order."""
        return [np.asarray(self.values[domain.name], dtype=float) for domain in self.mechanism.design]

    @cached_property
    def laws(self) -> str:
        """A description of the damping laws other than mu and zeta; empty without."""
        values = ((one.name, self.values[one.name]) for one in DISSIPATION if one.name in self.values)
        texts = [text(f"an array of {{{name}}}" if value.ndim else f"{{{name} = :r}}", value) for name, value in values]
        return together(", ", texts if self.contact == THROUGHOUT else [*texts, f"contact = {self.contact!r}"])

    @cached_property
    def _flow(self) -> SlowFlow:
        """The slow flow of all designs; a number outside its domain, which has a status, may warn."""
        damping = {
            one.name: np.asarray(self.values.get(one.name, 0.0), dtype=float) for one in (*DAMPING, *DISSIPATION)
        }
        mu, zeta = (damping.pop(one.name) for one in DAMPING)
        laws = Laws(contact=self.contact, **damping)  # type: ignore[arg-type]
        return SlowFlow(self.mechanism, self._parameters, mu, zeta, self.excitation, laws)

    def model(self, numbers: dict[str, float]) -> Model:
        """Model of one design, from numbers by name. Raises ValueError for one outside its domain."""
        own = dict(numbers)
        laws = Laws.of(self.contact, **{one.name: own.pop(one.name, 0.0) for one in DISSIPATION})
        return Model.of(self.mechanism, own, self.excitation, laws)

    def _ask(self, question: str, /, *, workers: int = 1, **kwargs: Any) -> Batch:
        """The answer to a question by its name, from what its method takes."""
        if question == "certify":
            return self._certify(**kwargs, workers=workers)
        at = {name: kwargs[name] for name in QUESTIONS[question].takes}
        max_count = validate.count("max_count", kwargs["max_count"], least=1) if "max_count" in kwargs else 0
        extra: dict[str, Any] = {}
        if question == "frequency_response":
            samples, window = validate.curve(kwargs["samples"], kwargs["Omega"])
            own, extra["lowest"] = curves(samples, window), window[0]
        else:
            own = BY_NAME[question]
        columns = self.ask(own, workers, max_count=max_count, **at)
        if question == "peak":
            extra["escapes"] = self._leave_out_what_escapes(*columns, **at)
        elif question != "detachment":
            extra["by_balls"] = self._decide(own, columns, max_count, *at.values())
        if question == "frequency_response":
            self._leave_out_what_drifts(*columns[:3])
        elif question == "amplitudes":
            extra["lowest"] = math.inf
            A, stable, count, _, status = columns
            self._leave_out_what_drifts(np.asarray(at["Omega"], dtype=float)[..., np.newaxis], A, stable)
            self._insert_states_at_rest(at["Omega"], at["F_0"], ((A, 0.0), (stable, 1)), count, status)
        return self._batch(question, columns, extra, **at)

    def _by_doubles(self, question: str, *, max_count: int, **at: Any) -> Batch:
        """Folds or states as `_ask` has them, without balls, and without those of a mass at rest."""
        columns = self.ask(BY_NAME[question], 1, max_count=max_count, **at)
        if question == "amplitudes":
            self._leave_out_what_drifts(at["Omega"][..., np.newaxis], *columns[:2])
        return self._batch(question, columns, {}, **at)

    rest = Unanswered(
        text(
            "rest is not available for many designs without a load: the equilibrium is {u} = 0; for a double well "
            "use {.off_centre|.oscillator.off_centre} of a single one"
        )
    )

    def _batch(self, question: str, columns: Sequence[npt.NDArray[Any]], extra: dict[str, Any], **at: Any) -> Batch:
        """An averaged answer from its columns in their order."""
        values = dict(zip(QUESTIONS[question].columns[AVERAGING], columns, strict=True))
        return Batch(question, values, self, at, **extra)

    def _decide(self, question: Question, columns: list[npt.NDArray[Any]], max_count: int, *arguments: Any) -> Flags:
        """Change the columns to those of single answers where balls decide what doubles do not; where that is."""
        named = dict(zip(QUESTIONS[question.name].columns[AVERAGING], columns, strict=True))
        left = (named["status"] == Status.UNRESOLVED) | np.asarray(named.get("undecided", 0) != 0)
        by_balls = np.zeros(left.shape, dtype=bool)
        if self.excitation != "force" or self.laws or not left.any() or proofs.ball_questions() is None:
            return by_balls
        assert question.one is not None  # of a proof `_certify` asks balls
        most = proofs.MOST_ONSETS_IN_BALLS if question.name == "saddle_node_onset" else proofs.MOST_IN_BALLS
        for at, numbers, own in islice(self._each(left, *arguments), most):
            try:
                found = question.one(Averaged(self._model(numbers)), proofs.Allowance(), *own)
            except ArithmeticError:  # what single answers refuse stays refused
                continue
            by_balls[at] = Remark.BY_BALLS in (found[0] if isinstance(found, tuple) else found).remarks
            _put(columns, at, question.columns(found, max_count))
        return by_balls

    def _model(self, numbers: Sequence[float]) -> Model:
        """One design, from its numbers in their order."""
        return self.model(dict(zip(self.values, numbers, strict=True)))

    def _each(self, selected: Flags, *arguments: Any) -> Iterator[tuple[Any, list[float], list[float]]]:
        """The index, the numbers and the arguments of each selected design, one by one."""
        values = [np.broadcast_to(value, selected.shape) for value in (*self.values.values(), *arguments)]
        chosen = np.argwhere(selected)
        for at in progress.each(map(tuple, chosen), len(chosen), "designs asked singly"):
            numbers = [float(value[at]) for value in values]
            yield at, numbers[: len(self.values)], numbers[len(self.values) :]

    def _insert_states_at_rest(
        self, Omega: Any, F_0: Any, columns: Sequence[tuple[npt.NDArray[Any], Any]], count: Codes, status: Codes
    ) -> None:
        """States at rest first, of the designs whose mass friction holds, see `Model.rests`.

        columns -- what states have, with one more axis of places, and what one at rest has: a number, or one a design
        """
        with np.errstate(all="ignore"):  # a number outside its domain has a status
            sticks = self._flow.sticks_at(np.asarray(F_0), np.asarray(Omega))
        if not sticks.any():
            return
        sticks = sticks & np.isin(status, (Status.OK, Status.STICKS, Status.NONE, Status.TOO_MANY))
        empty, full = sticks & (count == 0), sticks & (count >= columns[0][0].shape[-1])
        for column, value in columns:
            column[sticks, 1:] = column[sticks, :-1]
            column[sticks, 0] = np.broadcast_to(value, sticks.shape)[sticks]
        count += sticks
        status[empty], status[full] = Status.STICKS, Status.TOO_MANY

    def _leave_out_what_drifts(self, Omega: Floats, A: Floats, stable: Codes) -> None:
        """States, along one more axis, are stable only if they stay about u = 0, and within its well, as well."""
        with np.errstate(all="ignore"):  # a number outside its domain has a status, and no amplitude
            kept, beyond = diagnostics.look_at(self._flow, Omega, A)
            stable &= kept & ~beyond

    def _leave_out_what_escapes(self, A: Floats, Omega: Floats, status: Codes, *, F_0: Any) -> Flags:
        """Peaks are those within a well; of which designs the response goes on beyond it."""
        escapes = np.array((status == Status.NONE) & (self.excitation == "force"))
        status[escapes] = Status.UNBOUNDED
        with np.errstate(all="ignore"):  # a number outside its domain has a status, and no amplitude
            state = Omega[..., np.newaxis], A[..., np.newaxis]
            _, beyond = diagnostics.look_at(self._flow, *state)
        for at, numbers, (F,) in self._each(beyond[..., 0], F_0):
            found = Averaged(self._model(numbers)).peak(F)
            escapes[at] = found._escapes
            none = found.A is None
            A[at], Omega[at], status[at] = (
                (np.nan, np.nan, found._status) if none else (found.A, found.Omega, Status.OK)
            )
        return escapes

    def _certify(self, F_0: Any, *, Omega: Any, workers: int) -> Batch:
        validate.has_proof(self.excitation, self.laws)
        columns = self.ask(PROVED_FOLDS if Omega is None else PROVED_STATES, workers, F_0, Omega=Omega)
        self._decide_in_balls(F_0, Omega, *columns)
        return self._batch("certify", columns, {}, F_0=F_0)

    def _decide_in_balls(
        self, F_0: Any, Omega: Any, count: Codes, proved: Codes, bits: npt.NDArray[np.int16], status: Codes
    ) -> None:
        """Change the columns where doubles do not decide, and balls are there."""
        left = (proved == 0) & (status != Status.INVALID) & (status != Status.NO_MEMORY)
        if not left.any() or proofs.ball_questions() is None:
            return
        for at, numbers, (F, *frequency) in self._each(left, F_0, *([] if Omega is None else [Omega])):
            try:
                model = self._model(numbers)
                validate.number("F_0", F, above=0.0)
                for one in frequency:
                    validate.frequencies("Omega", one)
                found: Any = proofs.states(model, F, *frequency) if frequency else proofs.folds(model, F)
            except ValueError:
                status[at] = Status.INVALID
                continue
            if found.bits > DOUBLES:
                sticks = found.proved and found.message == messages.sticks(model, F)
                count[at], proved[at], bits[at] = len(found.A), found.proved, found.bits
                status[at] = Status.STICKS if sticks else Status.OK

    def untruncated_onset(self, selected: Flags) -> Floats:
        """F_SN of the untruncated force, for the selected designs; NaN for others."""
        F_SN = np.full(self.shape, np.nan)
        load = self.mechanism.load_untruncated
        if load is not None and selected.any():
            chosen = {name: np.broadcast_to(value, self.shape)[selected] for name, value in self.values.items()}
            F_SN[selected] = Designs(load(), chosen, self.excitation, self.contact).saddle_node_onset().F_SN
        return F_SN

    @property
    def give_way(self) -> Flags:
        """Whether states beyond the well exist for any force that moves the mass, for each design."""
        if self.excitation != "force":
            return np.zeros(self.shape, dtype=bool)
        with np.errstate(all="ignore"):  # a number outside its domain has a status
            may = ~self._flow.stays_centred
            return np.asarray(may & diagnostics.gives_way(self._flow) if may.any() else may)

    def remarks(self, F_0: Any, Omega: Any, A: Any, corner: Any) -> diagnostics.Codes:
        """Diagnostics of the states of each design, along an additional axis; see `diagnostics.of_designs`."""
        with np.errstate(all="ignore"):  # a number outside its domain has a status, and no amplitude
            force = np.asarray(F_0)[..., np.newaxis]
            if self.excitation != "force":
                force = inertia.force(np.where(np.asarray(A) > 0, Omega, np.inf), force)
            return diagnostics.of_designs(self._flow, force, Omega, A, corner)

    def ask(
        self, question: Question, workers: int, F_0: Any = None, max_count: int = 0, Omega: Any = None
    ) -> list[npt.NDArray[Any]]:
        """The columns of the answer to a question; `question` may be that of another level of approximation."""
        threads = validate.workers(workers)
        at = {name: value for name, value in (("F_0", F_0), ("Omega", Omega)) if value is not None}
        for name, value in at.items():
            if validate.is_labelled(value):
                raise Refused(
                    f"{name} has named axes, or is divided into blocks: at least one parameter of the designs must too"
                )
        values = {**self.values, **{name: validate.real_array(name, value) for name, value in at.items()}}
        shape = validate.common_shape(values)
        record = backend.record_of(self.mechanism, self.excitation != "force", bool(self.laws))
        solve = question.batch(record) if question.batch is not None and record is not None else None
        blank = question.blank(max_count, Status.UNRESOLVED).values()
        outputs = [np.empty((*shape, *one.shape), one.dtype) for one in blank]
        if solve is None:  # compiled solvers write each entry themselves
            for output, one in zip(outputs, blank, strict=True):
                output[...] = one
        solved = outputs
        if question.one is None:  # a proof: bits of its arithmetic, before the status
            outputs[-2][...] = DOUBLES
            solved = [*outputs[:-2], outputs[-1]]
        if solve is not None:
            numbers = self._with_all_laws(values) if self.laws else list(values.values())
            # what the solvers do not take as it is, long doubles
            doubles = (value if np.can_cast(value.dtype, float) else value.astype(float) for value in numbers)
            arguments = [np.broadcast_to(value, shape) for value in doubles]

            def part(block: tuple[slice | int, ...]) -> None:
                out = tuple(output[block] for output in solved)
                solve(*(value[block] for value in arguments), out=out)

            places_of = np.broadcast_to(np.uint8(0), shape)
            map_chunks(part, blocks(shape, question.at_once), threads, lambda one: places_of[one].size, places_of.size)
            if question.one is not None and self.mechanism.enclosed is not None:
                self._refuse_undefined(question, max_count, outputs)
        if question.one is not None and (self.laws or solve is None):
            # single answers know of masses that no spring holds, and of what boxes leave unresolved
            left = np.isin(outputs[-1], (Status.NO_BOUND, Status.UNRESOLVED))
            for index, design, own in self._each(left, *(values[name] for name in at)):
                _put(outputs, index, self._one(question, design, own, max_count))
        return outputs

    def _with_all_laws(self, values: dict[str, npt.NDArray[Any]]) -> list[npt.NDArray[Any]]:
        """What a record with laws of damping takes: design, mu, zeta, the others, whether friction ends; then F_0."""
        names = [domain.name for domain in (*self.mechanism.design, *DAMPING, *DISSIPATION)]
        ends = np.array(float(self.contact != THROUGHOUT))
        arguments = (value for name, value in values.items() if name not in self.values)
        return [*(values.get(name, np.zeros(())) for name in names), ends, *arguments]

    @property
    def _parameters(self) -> tuple[npt.NDArray[Any], ...]:
        """What the force takes, of all designs; a number outside its domain, which has a status, may warn."""
        return tuple(np.asarray(value) for value in self.mechanism.coefficients(*self.design))

    def _refuse_undefined(self, question: Question, max_count: int, outputs: list[Any]) -> None:
        """A status for designs whose force is infinite within its reach, of which the compiled solvers do not know."""
        with np.errstate(all="ignore"):  # a number outside its domain has a status already
            doubtful = may_be_undefined(self.mechanism, self._parameters)
        for index, numbers, _ in self._each(doubtful & (outputs[-1] != Status.INVALID)):
            try:
                check_defined(self._model(numbers))
            except ValueError:
                _put(outputs, index, question.blank(max_count, Status.INVALID))

    def _one(self, question: Question, numbers: list[float], arguments: list[float], max_count: int) -> dict[str, Any]:
        """One design's answer, with a status in place of an exception."""
        assert question.one is not None
        try:
            oscillator = Averaged(model := self._model(numbers))
            if len(arguments) > 1:
                validate.frequencies("Omega", arguments[1])
            if arguments and model.sticks(validate.number("F_0", arguments[0], above=0.0)):
                return question.blank(max_count, Status.STICKS)
            return question.columns(question.one(oscillator, proofs.Allowance(0), *arguments), max_count)
        except (ValueError, ArithmeticError) as error:
            return question.blank(max_count, failed(error))


def _put(columns: list[npt.NDArray[Any]], at: tuple[int, ...], found: dict[str, Any]) -> None:
    """Put one design's columns into those of all."""
    for column, value in zip(columns, found.values(), strict=True):
        column[at] = value
