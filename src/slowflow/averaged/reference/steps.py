"""Answers in steps: in go generators that say what they search for, out come their answers.

An answer that searches again and again, and decides by what it has found where to search next, cannot look at designs
abreast. It yields what it wants and is sent what is found: of one design that is searched for at once, of designs
abreast all together that want the same.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Generator, Hashable, Sequence
from typing import Any, Self, TypeVar

import numpy as np

from slowflow.averaged.reference.abreast import Abreast
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
        # some were quicker to come to it than others before them
        numbers, same = zip(*sorted(wanted.pop(kind), key=lambda one: one[0]), strict=True)
        whole = model if len(numbers) == model.abreast else Abreast([model.each[number] for number in numbers])
        for number, found in zip(numbers, same[0].together(whole, same), strict=True):
            go_on(number, found)
    return answers
