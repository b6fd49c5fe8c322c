"""The record of a mechanism whose force is stated by functions: in goes a `Stated`, out comes a `Mechanism`.

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
from slowflow_support.record import Law, Mechanism, Parameter

REACHED = "averaging does not ask the function for what lies beyond"


@dataclass(frozen=True)
class Asked:
    """One function of the record: of a piece by its number, where it is of one.

    what -- one of those below
    """

    stated: Stated
    what: Callable[..., Any]
    number: int = 0

    @property
    def __name__(self) -> str:
        return self.what.__name__

    def __call__(self, *arguments: Any) -> Any:
        return self.what(self, *arguments)

    def _numbers(self, given: Sequence[Any]) -> tuple[float, ...]:
        return tuple(float(one) for one in given)

    def _by_design(self, given: Sequence[Any], *beside: Any, of: Callable[..., Sequence[Any]]) -> tuple[Any, ...]:
        """What is of one design, of arrays of them: each once."""
        if all(np.ndim(one) == 0 for one in given):
            return tuple(of(self.stated.force(self._numbers(given)), *beside))
        *arrays, shaped = np.broadcast_arrays(*given, *(beside or (0.0,)))
        arrays.append(shaped)
        rows = np.stack([np.asarray(one, dtype=float).ravel() for one in arrays[: len(given)]], axis=-1)
        others = [np.asarray(one, dtype=float).ravel() for one in arrays[len(given) :]]
        designs, of_row = np.unique(rows, axis=0, return_inverse=True)
        found: list[Floats] = []
        for k, design in enumerate(designs):
            here = of_row.ravel() == k
            values = of(self.stated.force(self._numbers(design)), *((one[here] for one in others) if beside else ()))
            if not found:
                found = [np.empty(len(rows)) for _ in values]
            for whole, value in zip(found, values, strict=True):
                whole[here] = value
        return tuple(one.reshape(arrays[0].shape) for one in found)

    # --- of the parameters ---

    def coefficients(self, *design: Any) -> Any:
        """The parameters are the design; a force that is not allowed is told here, before any work."""
        self._by_design(design, of=lambda force: (0.0,))
        return tuple(design)

    def breakpoints(self, *given: Any) -> Any:
        return self._by_design(given, of=lambda force: force.ends[:-1])

    def jumps(self, *given: Any) -> Any:
        return self._by_design(given, of=lambda force: [lost[0] for lost in force.lost[:-1]])

    def kinks(self, *given: Any) -> Any:
        return self._by_design(given, of=lambda force: [one for lost in force.lost[:-1] for one in lost[1:3]])

    def hardening(self, *given: Any) -> Any:
        return self._by_design(given, of=lambda force: (-1.0,))

    def samples(self, *given: Any) -> tuple[bytes, bytes]:
        return self.stated.force(self._numbers(given)).samples

    def told(self, *given: Any) -> str:
        force = self.stated.force(self._numbers(given))
        by = f"by {force.points} of its values, error {force.error:.1g}"
        return f"a Python function, {by}; sums over polynomials"

    # --- of the amplitude ---

    def averaged(self, A: Any, *given: Any) -> Any:
        return self._averages(A, given, 4)

    def harmonics(self, A: Any, *given: Any) -> Any:
        return self._averages(A, given, 8)

    def intercept(self, A: Any, *given: Any) -> Any:
        (found,) = self._averages(A, given, 1)
        return found

    def _averages(self, A: Any, given: Sequence[Any], outputs: int) -> Any:
        return self._by_design(given, A, of=lambda force, A: force.averages(A, outputs))

    # --- of a piece ---

    def force(self, u: Any, *given: Any) -> Any:
        return self._value(u, given, 0)

    def slope(self, u: Any, *given: Any) -> Any:
        return self._value(u, given, 1)

    def force_throughout(self, u: Any, *given: Any) -> Any:
        return self._value(u, given, 0, Force.value_throughout)

    def slope_throughout(self, u: Any, *given: Any) -> Any:
        return self._value(u, given, 1, Force.value_throughout)

    def _value(self, u: Any, given: Sequence[Any], order: int, of: Callable[..., Any] = Force.value) -> Any:
        """The piece, or a derivative of it."""
        (found,) = self._by_design(given, u, of=lambda force, u: (of(force, self.number, u, order),))
        return found


def record(stated: Stated, title: str, design: tuple[Parameter, ...], reach_reason: str) -> Mechanism:
    """The record of a mechanism whose force is stated by functions."""
    count = len(stated.functions)
    last = count - 1
    whole = Law(Asked(stated, Asked.force_throughout, last), Asked(stated, Asked.slope_throughout, last))
    return Mechanism(
        name=stated.name,
        title=title,
        design=design,
        parameters=design,
        coefficients=Asked(stated, Asked.coefficients),
        pieces=tuple(
            Law(Asked(stated, Asked.force, k), Asked(stated, Asked.slope, k), whole=whole if k == last else None)
            for k in range(count)
        ),
        breakpoints=Asked(stated, Asked.breakpoints),
        jumps=Asked(stated, Asked.jumps),
        kinks=Asked(stated, Asked.kinks),
        hardening=Asked(stated, Asked.hardening),
        averaged=Asked(stated, Asked.averaged),
        intercept=Asked(stated, Asked.intercept),
        harmonics=Asked(stated, Asked.harmonics),
        harmonics_up_to=math.inf,
        reach=stated.reach,
        reach_reason=reach_reason or REACHED,
        truncated=False,
        load_untruncated=None,
        enclosed=(),
        told=Asked(stated, Asked.told),
        samples=Asked(stated, Asked.samples),
    )
