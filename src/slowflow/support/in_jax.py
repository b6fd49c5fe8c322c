"""The kernels on JAX. Takes a generated module; returns its functions on `jax.numpy`, which JAX differentiates."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Sequence
from types import FunctionType, ModuleType, SimpleNamespace
from typing import Any

from slowflow.support import broadcast
from slowflow.support.errors import Refused

DOUBLES = "JAX computes in 32 bits: call jax.config.update('jax_enable_x64', True) first"


@functools.cache
def in_jax(module: ModuleType) -> SimpleNamespace:
    """Rebuild the kernels of a module on `jax.numpy`: the same formulas, as functions that JAX transforms.

    Parameters
    ----------
    module : module
        One of `slowflow_kernels`, or a module that `slowflow derive` wrote.

    Returns
    -------
    SimpleNamespace
        The public functions by name, without those in C alone (`FROM_C`); dimensionless: arguments
        broadcast; results are arrays of JAX. They can be compiled by `jax.jit` and differentiated by `jax.grad` with
        respect to any argument. Where there are several regimes each amplitude is evaluated in its own one, in turn:
        pass arrays instead of applying `jax.vmap`.

    Raises
    ------
    ImportError
        Without JAX (`pip install jax`).
    ValueError
        When a kernel is called while JAX computes in 32 bits.

    Examples
    --------
    >>> import jax                                                        # doctest: +SKIP
    >>> jax.config.update("jax_enable_x64", True)                         # doctest: +SKIP
    >>> from slowflow_kernels import duffing                              # doctest: +SKIP
    >>> float(jax.grad(in_jax(duffing).h)(0.5, 1.0, 2.0, 0.0))            # doctest: +SKIP
    -2.125
    """
    import jax.numpy as jnp

    shared: dict[str, Any] = {one.__name__: one for one in (floats, broadcast_outputs, stacked, by_regime)}
    shared["number_by_regime"] = FunctionType(broadcast.number_by_regime.__code__, shared)  # by this `by_regime`
    own = {**vars(module), "np": jnp}
    from_c = getattr(module, "FROM_C", {})
    for name, value in vars(module).items():
        kernel = inspect.unwrap(value) if callable(value) else value
        if name in shared:
            own[name] = shared[name]
        elif isinstance(value, ModuleType) and "Written by `make derive`" in (value.__doc__ or ""):
            own[name] = in_jax(value)
        elif name not in from_c and isinstance(kernel, FunctionType) and kernel.__module__ == module.__name__:
            own[name] = functools.update_wrapper(FunctionType(kernel.__code__, own, name), kernel)
    printed = (name for name in module.__all__ if name not in from_c)
    return SimpleNamespace(**{name: own[name] for name in printed if isinstance(own[name], FunctionType)})


# What generated modules take from `slowflow.support.broadcast`, on JAX.


def floats(*arguments: Any) -> tuple[Any, ...]:
    """The arguments as arrays of doubles."""
    import jax.numpy as jnp

    if jnp.zeros(()).dtype.itemsize < 8:
        raise Refused(DOUBLES)
    return tuple(jnp.asarray(argument, dtype=float) for argument in arguments)


def broadcast_outputs(arguments: Sequence[Any], *values: Any) -> tuple[Any, ...]:
    """Each value in the shape to which the arguments broadcast."""
    import jax.numpy as jnp

    shape = jnp.broadcast_shapes(*(argument.shape for argument in arguments))
    return tuple(jnp.broadcast_to(value, shape) for value in values)


def stacked(arguments: Sequence[Any], *values: Any) -> Any:
    """Coefficients along a new first axis."""
    import jax.numpy as jnp

    return jnp.stack(broadcast_outputs(arguments, *values))


def by_regime(
    guards: Sequence[Any], bodies: Sequence[Callable[..., Any]], arguments: Sequence[Any], outputs: int
) -> tuple[Any, ...]:
    """Evaluate each amplitude in the first regime whose guard holds, or in the last, one after another.

    A choice between values of all regimes would have the gradient of each, NaN times 0 where another one's root is of
    a negative number.
    """
    import jax
    import jax.numpy as jnp

    shape = jnp.broadcast_shapes(*(argument.shape for argument in arguments))
    first = jnp.zeros(shape, int)
    for guard in reversed(guards):
        first = jnp.where(guard, 0, first + 1)
    rows = [jnp.broadcast_to(one, shape).ravel() for one in (first, *arguments)]
    each = [functools.partial(_doubles_of, body) for body in bodies]
    found = jax.lax.map(lambda row: jax.lax.switch(row[0], each, *row[1:]), rows)
    return tuple(one.reshape(shape) for one in found)


def _doubles_of(body: Callable[..., Any], *numbers: Any) -> list[Any]:
    import jax.numpy as jnp

    return [jnp.asarray(one, dtype=float) for one in body(*numbers)]
