"""A question at pairs of a frequency and a forcing. Takes arrays that broadcast; returns columns in the pairs' order.

One query for each forcing, at all of its frequencies.
"""

from __future__ import annotations

import functools
import operator
from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np

from slowflow.answers.results import NOTHING
from slowflow.averaged import messages
from slowflow.core import validate
from slowflow.core.mechanism import Floats


class Pairs(NamedTuple):
    """What is found at pairs.

    columns -- by name, with the entries of each pair after those of the pair before
    F_0     -- the forcing of each entry
    message -- what the parts say, and that the pairs are not combined
    parts   -- the answers at single forcings that these are from
    """

    columns: dict[str, Any]
    F_0: Floats
    message: str
    answers: list[Any]

    def notes(self) -> dict[str, Any]:
        """Message, remarks and undecided frequencies of all parts."""
        undecided = np.unique(np.concatenate([np.empty(0), *(part.Omega_undecided for part in self.answers)]))
        remarks = functools.reduce(operator.or_, (part.remarks for part in self.answers), NOTHING)
        return {"message": self.message, "Omega_undecided": undecided, "remarks": remarks}


def with_rests(at: Floats, at_rest: Any, Omega: Floats, columns: Mapping[str, tuple[Any, Any]]) -> dict[str, Any]:
    """Columns of states with those at rest before the others of their frequency.

    at      -- the frequencies of the query, in their order; at_rest -- how many states at rest there are at each
    Omega   -- of each state, in the order of `at`
    columns -- by name what each state has, and what one at rest has: a number, or an array of one after the other
    """
    several, which, times = np.unique(at, return_inverse=True, return_counts=True)
    low, high = (np.searchsorted(np.sort(Omega), several, side) for side in ("left", "right"))
    count = ((high - low) // times)[which]
    before = np.repeat(np.cumsum(count) - count, at_rest)
    return {name: np.insert(column, before, value) for name, (column, value) in columns.items()}


def at_pairs(ask: Callable[[Floats, float], Any], Omega: Any, F_0: Any, names: Iterable[str]) -> Pairs:
    """The named columns of answers at (Omega, F_0), which broadcast.

    ask -- the answer at rising frequencies and one forcing: entries by rising .Omega

    Raises ValueError for Omega <= 0 or too high, F_0 <= 0, and shapes that do not broadcast.
    """
    arguments = {"Omega": validate.frequencies("Omega", Omega), "F_0": validate.positive_array("F_0", F_0)}
    shape = validate.common_shape(arguments)
    at, forcing = (np.broadcast_to(values, shape).ravel() for values in arguments.values())
    forcings = np.unique(forcing).tolist()
    answers, rows, pair = [], [], []
    for one in forcings or [1.0]:  # of no pairs the columns are empty, whatever the forcing
        here = np.flatnonzero(forcing == one)
        answers.append(ask(np.unique(at[here]), one))
        low, high = (np.searchsorted(answers[-1].Omega, at[here], side) for side in ("left", "right"))
        rows.append(np.concatenate([np.empty(0, np.intp), *map(np.arange, low, high)]))
        pair.append(np.repeat(here, high - low))
    pairs = np.concatenate(pair)
    order = np.argsort(pairs, kind="stable")
    columns = {
        name: np.concatenate([getattr(part, name)[row] for part, row in zip(answers, rows, strict=True)])[order]
        for name in names
    }
    answers = answers if forcings else []
    message = messages.at_pairs(at, (part.message for part in answers))
    return Pairs(columns, forcing[pairs[order]], message, answers)
