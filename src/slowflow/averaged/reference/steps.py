"""Answers in steps: in go generators that say what they search for, out come their answers.

An answer that searches again and again, and decides by what it has found where to search next, cannot look at designs
abreast. It yields what it wants and is sent what is found: of one design that is searched for at once, of designs
abreast all together that want the same.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Generator, Hashable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Self, TypeVar

import numpy as np

from slowflow.averaged import words
from slowflow.averaged.reference.abreast import Abreast
from slowflow.averaged.reference.along import Asked
from slowflow.averaged.reference.bounds import amplitude_bound, amplitude_bounds
from slowflow.averaged.reference.cells import Samples, Stretch, sample_above, samples_at, stretches_up_to
from slowflow.averaged.reference.search import GIVEN_UP, Zeros, find_zeros, find_zeros_abreast
from slowflow.model import Model

Answer = TypeVar("Answer")


class Wanted(ABC):
    """What one step searches for."""

    @property
    def kind(self) -> Hashable:
        """What is the same of all that are searched for together."""
        return type(self)

    @abstractmethod
    def alone(self, model: Model) -> Any:
        """What is found of one design."""

    @abstractmethod
    def together(self, model: Abreast, all_of_them: Sequence[Self]) -> list[Any]:
        """What is found of each of designs abreast, or the ArithmeticError that is raised for it."""


Steps = Generator[Wanted, Any, Answer]


@dataclass(frozen=True)
class Bound(Wanted):
    """`amplitude_bound` at a forcing; of designs abreast, which springs hold, `lowest` has no part in it."""

    F_0: float
    lowest: float = 0.0

    def alone(self, model: Model) -> tuple[float, str]:
        return amplitude_bound(model, self.F_0, self.lowest)

    def together(self, model: Abreast, all_of_them: Sequence[Self]) -> list[Any]:
        bounds = amplitude_bounds(model, np.array([wanted.F_0 for wanted in all_of_them]))
        return [
            bound if bound[0] < np.inf else OverflowError(words.unbounded(one, wanted.F_0))
            for bound, one, wanted in zip(bounds, model.each, all_of_them, strict=True)
        ]


@dataclass(frozen=True)
class At(Wanted):
    """A sample at an amplitude."""

    A: float

    def alone(self, model: Model) -> Samples:
        return samples_at(model, self.A)

    def together(self, model: Abreast, all_of_them: Sequence[Self]) -> list[Any]:
        return _each(samples_at(model, [one.A for one in all_of_them], np.arange(model.abreast)))


@dataclass(frozen=True)
class Above(Wanted):
    """The limit from above at breakpoint i."""

    i: int

    @property
    def kind(self) -> Hashable:
        return Above, self.i

    def alone(self, model: Model) -> Samples:
        return sample_above(model, self.i)

    def together(self, model: Abreast, all_of_them: Sequence[Self]) -> list[Any]:
        return _each(sample_above(model, self.i, np.arange(model.abreast)))


@dataclass(frozen=True)
class Pieces(Wanted):
    """`stretches_up_to` an amplitude."""

    A_max: float

    def alone(self, model: Model) -> list[Stretch]:
        return stretches_up_to(model, self.A_max)

    def together(self, model: Abreast, all_of_them: Sequence[Self]) -> list[Any]:
        found: list[list[Stretch]] = [[] for _ in all_of_them]
        for piece in stretches_up_to(model, np.array([one.A_max for one in all_of_them])):
            of = piece.first.of.tolist()
            for k, first, last in zip(of, _each(piece.first), _each(piece.last), strict=True):
                found[k].append(Stretch(first, last, first.A))
        return found


def _each(samples: Samples) -> list[Samples]:
    """One of each of designs abreast, as it has it alone."""
    samples.rows[-1] = 0
    return [samples.take([k]) for k in range(len(samples))]


@dataclass(frozen=True)
class Search(Wanted):
    """`find_zeros`: of the questions that `asked` makes of a model and numbers, on pieces."""

    asked: Callable[..., list[Asked]]
    numbers: tuple[float, ...]
    pieces: Sequence[Stretch]

    @property
    def kind(self) -> Hashable:
        return self.asked

    def alone(self, model: Model) -> list[Zeros]:
        return find_zeros(model, self.asked(model, *self.numbers), self.pieces)

    def together(self, model: Abreast, all_of_them: Sequence[Self]) -> list[Any]:
        numbers = map(np.array, zip(*(one.numbers for one in all_of_them), strict=True))
        number = [len(one.pieces) for one in all_of_them]
        of, pieces = np.repeat(np.arange(len(number)), number), [piece for one in all_of_them for piece in one.pieces]
        first, last = (
            np.concatenate([ends.rows for ends in side], axis=1)
            for side in ([piece.first for piece in pieces], [piece.last for piece in pieces])
        )
        first[-1] = last[-1] = of
        whole = Stretch(Samples(first), Samples(last), np.concatenate([piece.base for piece in pieces]))
        found, given_up = find_zeros_abreast(model, self.asked(model, *numbers), [whole])
        begins = np.cumsum(number) - number
        cut = [np.searchsorted(zeros.of, np.arange(len(number) + 1)).tolist() for zeros in found]
        answers: list[Any] = []
        for k, begin in enumerate(begins.tolist()):
            if given_up[k]:
                answers.append(ArithmeticError(GIVEN_UP))
                continue
            own = [zeros.take(slice(*at[k : k + 2])) for zeros, at in zip(found, cut, strict=True)]
            answers.append(
                [
                    replace(one, of=one.of - k, piece=one.piece - begin, undecided=one.undecided[k : k + 1])
                    for one in own
                ]
            )
        return answers


@np.errstate(all="ignore")
def alone(model: Model, steps: Steps[Answer]) -> Answer:
    """The answer of one design."""
    try:
        wanted = next(steps)
        while True:
            try:
                found = wanted.alone(model)
            except ArithmeticError as failure:
                wanted = steps.throw(failure)
            else:
                wanted = steps.send(found)
    except StopIteration as end:
        answer: Answer = end.value
        return answer


@np.errstate(all="ignore")
def together(model: Abreast, all_of_them: Sequence[Steps[Answer]]) -> list[Answer | ArithmeticError]:
    """The answer of each of designs abreast, or what is raised for it."""
    answers: list[Any] = [None] * len(all_of_them)
    wanted: dict[Hashable, list[tuple[int, Wanted]]] = {}

    def go_on(number: int, found: Any) -> None:
        steps = all_of_them[number]
        try:
            one = steps.throw(found) if isinstance(found, ArithmeticError) else steps.send(found)
        except StopIteration as end:
            answers[number] = end.value
        except ArithmeticError as failure:
            answers[number] = failure
        else:
            wanted.setdefault(one.kind, []).append((number, one))

    for number in range(len(all_of_them)):
        go_on(number, None)
    while wanted:
        # what most want comes last, so that others that will want it come to it first
        kind = min(wanted, key=lambda one: len(wanted[one]))
        numbers, same = zip(*wanted.pop(kind), strict=True)
        whole = model if len(numbers) == model.abreast else Abreast([model.each[number] for number in numbers])
        for number, found in zip(numbers, same[0].together(whole, same), strict=True):
            go_on(number, found)
    return answers
