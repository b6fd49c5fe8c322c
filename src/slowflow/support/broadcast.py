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


def common_shape(arguments: Sequence[Floats]) -> tuple[int, ...]:
    """The shape to which all arguments broadcast; there is mostly one, and NumPy's own search takes microseconds."""
    shapes = {argument.shape for argument in arguments} - {()}
    return np.broadcast_shapes(*shapes) if len(shapes) > 1 else next(iter(shapes), ())


def full(value: Any, shape: tuple[int, ...]) -> Any:
    """A copy of the value in a shape, a NumPy scalar for (); `broadcast_to` takes microseconds."""
    value = np.asarray(value)
    if value.shape == shape:
        return value.copy()[()]
    copy = np.empty(shape, value.dtype)
    copy[...] = value
    return copy


def broadcast_outputs(arguments: Sequence[Floats], *values: Any) -> tuple[Any, ...]:
    """Each value in the shape to which the arguments broadcast, whichever of them it depends on."""
    shape = common_shape(arguments)
    return tuple([full(value, shape) for value in values])


def stacked(arguments: Sequence[Floats], *values: Any) -> Floats:
    """Coefficients along a new first axis, each in the shape to which the arguments broadcast."""
    stack = np.empty((len(values), *common_shape(arguments)))
    for number, value in enumerate(values):
        stack[number] = value
    return stack


def by_regime(
    guards: Sequence[Any], bodies: Sequence[Callable[..., Sequence[Any]]], arguments: Sequence[Floats], outputs: int
) -> tuple[Any, ...]:
    """Evaluates each body only where its guard holds and no earlier one does; the last body has no guard.

    A NaN fails every guard and reaches the last body, which hands it on.
    """
    shape = common_shape(arguments)
    remaining = np.ones(shape, dtype=bool)
    results = np.empty((outputs, 0))
    for guard, body in zip((*guards, True), bodies, strict=True):
        mask = remaining & guard
        count = np.count_nonzero(mask)
        if count == remaining.size:
            return tuple([full(value, shape) for value in body(*arguments)])
        if count:
            results = results if results.size else np.empty((outputs, *shape))
            which = mask.nonzero()
            selected = [
                a if a.ndim == 0 else (a if a.shape == shape else np.broadcast_to(a, shape))[which] for a in arguments
            ]
            for result, value in zip(results, body(*selected), strict=True):
                result[which] = value
            remaining = remaining ^ mask
    return tuple(results)


def number_by_regime(guards: Sequence[Any], bodies: Sequence[Callable[..., Any]], arguments: Sequence[Floats]) -> Any:
    """The same for bodies that give one number."""
    tuples = [lambda *selected, body=body: (body(*selected),) for body in bodies]
    return by_regime(guards, tuples, arguments, 1)[0]
