"""Compiled kernels where they are built, NumPy's otherwise: decided once, at the first import.

In:  the environment. SLOWFLOW_BACKEND=native demands the compiled kernels, SLOWFLOW_BACKEND=numpy leaves them alone;
     without it they are used if they are there, and a `BackendWarning` says so if they are not.
Out: `NATIVE`, the extension module or None, and wrappers that give its ufuncs the form of the kernels in Python.
"""

from __future__ import annotations

import importlib
import os
import warnings
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt

#: the compiled kernels: an extension module, which imports nothing but NumPy
EXTENSION = "slowflow_kernels._native"


class BackendWarning(RuntimeWarning):
    """The compiled kernels are not built."""


def _choose() -> ModuleType | None:
    """The extension module, or None."""
    wanted = os.environ.get("SLOWFLOW_BACKEND", "")
    if wanted not in ("", "native", "numpy"):
        raise ValueError(f"SLOWFLOW_BACKEND is {wanted!r}; it may be 'native' or 'numpy'")
    if wanted == "numpy":
        return None
    try:
        return importlib.import_module(EXTENSION)
    except ImportError as error:
        if wanted == "native":
            raise ImportError(f"SLOWFLOW_BACKEND=native, but the compiled kernels do not load: {error}") from error
        warnings.warn(
            "slowflow runs on NumPy: its compiled kernels are not built here (they need a C compiler at installation). "
            "The answers are the same and take longer. SLOWFLOW_BACKEND=numpy silences this.",
            BackendWarning,
            stacklevel=2,
        )
        return None


NATIVE = _choose()


def coefficients_of(ufunc: np.ufunc) -> Callable[..., npt.NDArray[np.float64]]:
    """A ufunc's outputs, which are a polynomial's coefficients, along a new first axis."""

    def stack(*arguments: Any) -> npt.NDArray[np.float64]:
        values = ufunc(*arguments)
        return np.stack(values if ufunc.nout > 1 else (values,))

    return _named(stack, ufunc)


def in_tuple(ufunc: np.ufunc) -> Callable[..., tuple[Any]]:
    """The one output of a ufunc as a tuple."""

    def one(*arguments: Any) -> tuple[Any]:
        return (ufunc(*arguments),)

    return _named(one, ufunc)


def _named(function: Callable[..., Any], ufunc: np.ufunc) -> Callable[..., Any]:
    function.__name__ = function.__qualname__ = ufunc.__name__
    function.__doc__ = ufunc.__doc__
    return function
