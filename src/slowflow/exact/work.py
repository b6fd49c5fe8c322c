"""How long a question about motions may take. Takes steps of integration; returns a refusal of too many."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from contextvars import ContextVar

from slowflow.support.errors import NotSettled

MOST_STEPS = 200_000  # of one integration: a slip takes some tens, hundreds at low frequency
#: steps of one question, 240 times what a curve of 390 points takes: ten to twenty seconds
MOST_WORK = 3_000_000
GIVEN_UP = "given up after {} integration steps, more than an answer should take"


class OutOfWork(Exception):
    """The question has used up its steps. No ArithmeticError: a trial that fails is replaced by another."""

    def __init__(self, most: int) -> None:
        super().__init__(GIVEN_UP.format(most))


_remaining: ContextVar[list[int] | None] = ContextVar("steps that the question has left", default=None)


@contextlib.contextmanager
def limited(most: int = MOST_WORK) -> Iterator[None]:
    """Bounds the steps of one question, inner questions included. Raises ArithmeticError where they do not suffice."""
    if _remaining.get() is not None:
        yield
        return
    token = _remaining.set([most, most])
    try:
        yield
    except OutOfWork as used_up:
        raise NotSettled(str(used_up)) from None
    finally:
        _remaining.reset(token)


def steps_left() -> int:
    """The steps that one integration may take now."""
    remaining = _remaining.get()
    return MOST_STEPS if remaining is None else max(0, min(MOST_STEPS, remaining[0] + 1))


def spend(steps: int, *, keep: bool = False) -> None:
    """Counts steps of an integrator against what the question has left.

    keep -- what was found with them is good: not this call is refused but the next
    """
    remaining = _remaining.get()
    if remaining is not None:
        remaining[0] -= steps
        if remaining[0] < 0 and not keep:
            raise OutOfWork(remaining[1])
