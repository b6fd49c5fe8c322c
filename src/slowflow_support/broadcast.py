"""What the generated modules share: arguments as floats, one shape for all outputs, regimes by mask."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]


def floats(*arguments: Any) -> tuple[Floats, ...]:
    """The arguments as float64 arrays; a scalar becomes a 0-d array, so that NumPy's rules hold for it too."""
    return tuple(np.asarray(argument, dtype=float) for argument in arguments)


def full(value: Any, arguments: Sequence[Any]) -> Any:
    """A copy of the value in the common shape of all arguments, also of those it does not depend on."""
    shape = np.broadcast_shapes(*(np.shape(argument) for argument in arguments))
    return np.array(np.broadcast_to(value, shape))[()]


def stacked(values: Sequence[Any], arguments: Sequence[Any]) -> Floats:
    """Coefficients along a new first axis, each in the common shape of all arguments."""
    return np.stack([full(value, arguments) for value in values])


def by_regime(
    guards: Sequence[Any], bodies: Sequence[Callable[..., Sequence[Any]]], arguments: Sequence[Floats], outputs: int
) -> tuple[Any, ...]:
    """Evaluates each body only where its guard holds and no earlier one does; the last body has no guard.

    A NaN fails every guard and reaches the last body, which hands it on.
    """
    shape = np.broadcast_shapes(*(argument.shape for argument in arguments))
    left = np.ones(shape, dtype=bool)
    results: tuple[Floats, ...] = ()
    for guard, body in zip((*guards, True), bodies, strict=True):
        mask = left & guard
        if mask.all():
            return tuple(full(value, arguments) for value in body(*arguments))
        if mask.any():
            results = results or tuple(np.empty(shape) for _ in range(outputs))
            chosen = [a if a.ndim == 0 else np.broadcast_to(a, shape)[mask] for a in arguments]
            for result, value in zip(results, body(*chosen), strict=True):
                result[mask] = value
            left = left & ~mask
    return results


def number_by_regime(guards: Sequence[Any], bodies: Sequence[Callable[..., Any]], arguments: Sequence[Floats]) -> Any:
    """The same for bodies that give one number."""
    tuples = [lambda *chosen, body=body: (body(*chosen),) for body in bodies]
    return by_regime(guards, tuples, arguments, 1)[0]
