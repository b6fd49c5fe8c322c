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


def common_shape(arguments: Sequence[Any]) -> tuple[int, ...]:
    """The shape to which all arguments broadcast; there is mostly one, and NumPy's own search takes microseconds."""
    shapes = {np.shape(argument) for argument in arguments} - {()}
    return np.broadcast_shapes(*shapes) if len(shapes) > 1 else next(iter(shapes), ())


def _in_shape(value: Any, shape: tuple[int, ...]) -> Any:
    """A copy of the value in a shape; `broadcast_to` takes microseconds."""
    if np.shape(value) == shape:
        return np.array(value)[()]
    copy = np.empty(shape, np.asarray(value).dtype)
    copy[...] = value
    return copy[()]


def full(value: Any, arguments: Sequence[Any]) -> Any:
    """A copy of the value in the common shape of all arguments, also of those it does not depend on."""
    return _in_shape(value, common_shape(arguments))


def stacked(values: Sequence[Any], arguments: Sequence[Any]) -> Floats:
    """Coefficients along a new first axis, each in the common shape of all arguments."""
    shape = common_shape(arguments)
    return np.stack([_in_shape(value, shape) for value in values])


def by_regime(
    guards: Sequence[Any], bodies: Sequence[Callable[..., Sequence[Any]]], arguments: Sequence[Floats], outputs: int
) -> tuple[Any, ...]:
    """Evaluates each body only where its guard holds and no earlier one does; the last body has no guard.

    A NaN fails every guard and reaches the last body, which hands it on.
    """
    shape = common_shape(arguments)
    left = np.ones(shape, dtype=bool)
    results: tuple[Floats, ...] = ()
    for guard, body in zip((*guards, True), bodies, strict=True):
        mask = left & guard
        if mask.all():
            return tuple(_in_shape(value, shape) for value in body(*arguments))
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
