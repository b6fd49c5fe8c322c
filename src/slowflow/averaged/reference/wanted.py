"""What answers in steps search for, see `steps`: numbers in, what is found of one design or of several abreast out."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np

from slowflow.averaged import words
from slowflow.averaged.reference.abreast import Abreast
from slowflow.averaged.reference.along import Asked
from slowflow.averaged.reference.bounds import amplitude_bound, amplitude_bounds
from slowflow.averaged.reference.cells import Samples, Stretch, sample_above, samples_at, stretches_up_to
from slowflow.averaged.reference.search import GIVEN_UP, Zeros, find_zeros, find_zeros_abreast
from slowflow.averaged.reference.steps import Wanted
from slowflow.model import Model
from slowflow_support.errors import NotSettled, OutOfRange


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
            bound if bound[0] < np.inf else OutOfRange(words.unbounded(one, wanted.F_0))
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
                answers.append(NotSettled(GIVEN_UP))
                continue
            own = [zeros.take(slice(*at[k : k + 2])) for zeros, at in zip(found, cut, strict=True)]
            answers.append(
                [
                    replace(one, of=one.of - k, piece=one.piece - begin, undecided=one.undecided[k : k + 1])
                    for one in own
                ]
            )
        return answers
