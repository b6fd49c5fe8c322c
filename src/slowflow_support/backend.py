"""Compiled kernels where they are built, NumPy's otherwise: decided once, at the first import.

In:  the environment. SLOWFLOW_BACKEND=native demands the compiled kernels, SLOWFLOW_BACKEND=numpy leaves them alone;
     without it they are used if they are there, and a `BackendWarning` says so if they are not.
Out: `NATIVE`, the extension module or None, and wrappers that give its ufuncs the names and forms of the kernels.
"""

from __future__ import annotations

import functools
import importlib
import os
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from types import ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow_support.errors import Refused, WrongType

#: the compiled kernels: an extension module, which imports nothing but NumPy
EXTENSION = "slowflow_kernels._native"


class BackendWarning(RuntimeWarning):
    """The compiled kernels are not built."""


def _choose() -> ModuleType | None:
    """The extension module, or None."""
    wanted = os.environ.get("SLOWFLOW_BACKEND", "")
    if wanted not in ("", "native", "numpy"):
        raise Refused(f"SLOWFLOW_BACKEND is {wanted!r}; it may be 'native' or 'numpy'")
    if wanted == "numpy":
        return None
    try:
        return importlib.import_module(EXTENSION)
    except ImportError as error:
        if wanted == "native":
            raise ImportError(f"SLOWFLOW_BACKEND=native, but the compiled kernels do not load: {error}") from error
        # a build for another processor says so by itself
        why = "are not built here (they need a C compiler at installation)"
        if not isinstance(error, ModuleNotFoundError):
            why = f"do not load here ({error})"
        warnings.warn(
            f"slowflow runs on NumPy: its compiled kernels {why}. "
            "The answers are the same and take longer. SLOWFLOW_BACKEND=numpy silences this.",
            BackendWarning,
            stacklevel=2,
        )
        return None


NATIVE = _choose()


def compiled(kernels: Sequence[Callable[..., Any]], ufuncs: Sequence[np.ufunc]) -> tuple[Callable[..., Any], ...]:
    """Each kernel by its ufunc: with the name, arguments and docstring that it has on NumPy, which is `__wrapped__`."""
    return tuple(map(_called, kernels, ufuncs))


def coefficients_of(kernel: Callable[..., Any]) -> Callable[..., npt.NDArray[np.float64]]:
    """A compiled kernel's outputs, which are a polynomial's coefficients, along a new first axis."""

    @functools.wraps(kernel)
    def stack(*arguments: Any, **named: Any) -> npt.NDArray[np.float64]:
        values = kernel(*arguments, **named)
        return np.stack(values if isinstance(values, tuple) else (values,))

    return stack


def in_tuple(kernel: Callable[..., Any]) -> Callable[..., tuple[Any]]:
    """The one output of a compiled kernel as a tuple."""

    @functools.wraps(kernel)
    def one(*arguments: Any, **named: Any) -> tuple[Any]:
        return (kernel(*arguments, **named),)

    return one


def _called(kernel: Callable[..., Any], ufunc: np.ufunc) -> Callable[..., Any]:
    """A ufunc knows its arguments by place only."""
    names = kernel.__code__.co_varnames[: kernel.__code__.co_argcount]

    @functools.wraps(kernel)
    def called(*arguments: Any, **named: Any) -> Any:
        if named:
            # what is no argument of the kernel is NumPy's: out, where, ...
            given = {name: named.pop(name) for name in names if name in named}
            if given:
                arguments = (*arguments, *_in_order(kernel.__name__, names[len(arguments) :], given))
        return ufunc(*arguments, **named)

    return called


def _in_order(kernel: str, names: Sequence[str], given: Mapping[str, Any]) -> Iterator[Any]:
    """The arguments given by name, in the order of the names that are left; TypeError as a function raises it."""
    for name in given:
        if name not in names:
            raise WrongType(f"{kernel}() got multiple values for argument {name!r}")
    for name in names:
        if name not in given:
            raise WrongType(f"{kernel}() missing 1 required positional argument: {name!r}")
        yield given[name]
