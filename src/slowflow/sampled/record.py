"""The record of a mechanism whose force is stated by functions. Takes a `Stated`; returns a `Mechanism`.

What a record has as functions of arrays of designs is asked here of the force of each.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from slowflow.sampled.force import Force, Stated
from slowflow.sampled.polynomial import Floats
from slowflow.support.record import Law, Mechanism, Parameter

REACHED = "averaging does not ask the function for what lies beyond"


#: what a force says of a design: tuples of numbers that may be of arrays of designs, and what is of one design only
OF_DESIGNS: dict[str, Callable[[Force], Sequence[float]]] = {
    "coefficients": lambda force: force.numbers,
    "breakpoints": lambda force: force.ends[:-1],
    "jumps": lambda force: [lost[0] for lost in force.lost[:-1]],
    "kinks": lambda force: [one for lost in force.lost[:-1] for one in lost[1:3]],
    "hardening": lambda force: (-1.0,),
}
OF_ONE: dict[str, Callable[[Force], Any]] = {
    "samples": lambda force: force.samples,
    "told": lambda force: (
        f"a Python function, by {force.points} of its values, error {force.error:.1g}; sums over polynomials"
    ),
}
#: how many outputs averages have; of a piece the method that gives it, and which derivative
AVERAGES = {"averaged": 4, "harmonics": 8, "intercept": 1}
OF_PIECE = {
    "force": (Force.value, 0),
    "slope": (Force.value, 1),
    "force_throughout": (Force.value_throughout, 0),
    "slope_throughout": (Force.value_throughout, 1),
}


@dataclass(frozen=True)
class Asked:
    """One function of the record, by its name in these tables: of a piece by its number, where it is of one."""

    stated: Stated
    what: str
    number: int = 0

    @property
    def __name__(self) -> str:
        return self.what

    def __call__(self, *arguments: Any) -> Any:
        what = self.what
        if what in OF_ONE:
            return OF_ONE[what](self.stated.force(tuple(map(float, arguments))))
        if what in OF_DESIGNS:
            return self._by_design(arguments, of=OF_DESIGNS[what])
        first, *given = arguments
        if what in AVERAGES:
            found = self._by_design(given, first, of=lambda force, A: force.averages(A, AVERAGES[what]))
            return found if what != "intercept" else found[0]
        method, order = OF_PIECE[what]
        return self._by_design(given, first, of=lambda force, u: (method(force, self.number, u, order),))[0]

    def _by_design(self, given: Sequence[Any], *beside: Any, of: Callable[..., Sequence[Any]]) -> tuple[Any, ...]:
        """What is of one design, of arrays of them: each once."""
        if all(np.ndim(one) == 0 for one in given):
            return tuple(of(self.stated.force(tuple(map(float, given))), *beside))
        *arrays, shaped = np.broadcast_arrays(*given, *(beside or (0.0,)))
        arrays.append(shaped)
        rows = np.stack([np.asarray(one, dtype=float).ravel() for one in arrays[: len(given)]], axis=-1)
        others = [np.asarray(one, dtype=float).ravel() for one in arrays[len(given) :]]
        designs, of_row = np.unique(rows, axis=0, return_inverse=True)
        found: list[Floats] = []
        for k, design in enumerate(designs):
            here = of_row.ravel() == k
            values = of(self.stated.force(tuple(design.tolist())), *((one[here] for one in others) if beside else ()))
            if not found:
                found = [np.empty(len(rows)) for _ in values]
            for whole, value in zip(found, values, strict=True):
                whole[here] = value
        return tuple(one.reshape(arrays[0].shape) for one in found)


def record(stated: Stated, title: str, design: tuple[Parameter, ...], reach_reason: str) -> Mechanism:
    """The record of a mechanism whose force is stated by functions."""
    count = len(stated.functions)
    last = count - 1
    whole = Law(Asked(stated, "force_throughout", last), Asked(stated, "slope_throughout", last))
    functions: dict[str, Any] = {name: Asked(stated, name) for name in (*OF_DESIGNS, *OF_ONE, *AVERAGES)}
    return Mechanism(
        **functions,
        name=stated.name,
        title=title,
        design=design,
        parameters=design,
        pieces=tuple(
            Law(Asked(stated, "force", k), Asked(stated, "slope", k), whole=whole if k == last else None)
            for k in range(count)
        ),
        harmonics_up_to=math.inf,
        reach=stated.reach,
        reach_reason=reach_reason or REACHED,
        truncated=False,
        load_untruncated=None,
        enclosed=(),
    )
