"""Gradients of answers against differences of answers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np

from tests.sampling import directions

#: a step's share of a number, of which the square is the error of a central difference
STEP, LEAST = 1e-5, 0.01


def assert_slopes_are_differences(
    make: Callable[..., Any],
    numbers: Mapping[str, float],
    asks: Mapping[str, Callable[[Any], Any]],
    by: Iterable[str],
    within: float = 1e-7,
) -> set[str]:
    """Of what is made of the numbers, along each direction of some of them; which questions have slopes at all.

    `within` is the part of all that the numbers do to an answer, beside 1e-12 of itself.
    """
    made, moving = make(**numbers), set()
    answers = {question: (ask, answer := ask(made), answer.gradient()) for question, ask in asks.items()}
    for way in directions(by):
        step = {name: STEP * max(abs(numbers[name]), LEAST) * weight for name, weight in way.items()}
        # each is asked all questions: it keeps what several of them need
        neighbours = [
            make(**{**numbers, **{name: numbers[name] + k * far for name, far in step.items()}}) for k in (-1, 1)
        ]
        for question, (ask, answer, gradient) in answers.items():
            there = [ask(one) for one in neighbours]
            for of in gradient.of:
                values = [np.atleast_1d(np.asarray(getattr(one, of), dtype=float)) for one in (answer, *there)]
                expected = (values[2] - values[1]) / 2
                varied = sorted(step.keys() & {*gradient.by})
                terms = np.array([np.atleast_1d(gradient[of, name]) * step[name] for name in varied])
                known = np.isfinite(terms).all(axis=0)
                doubt = within * np.abs(terms).sum(axis=0) + 1e-12 * np.abs(values[0]).max(initial=0, where=known)
                assert (np.abs(expected - terms.sum(axis=0)) <= doubt)[known].all(), (question, of, way)
                moving |= {question} if known.any() else set()
    return moving
