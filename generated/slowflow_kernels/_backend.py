"""Compiled kernels where they are built, NumPy's otherwise: decided once, at the first import.

Written by `make derive`; never edit.

SLOWFLOW_BACKEND=native demands the compiled ones, SLOWFLOW_BACKEND=numpy leaves them alone; without it they are used
if they are there, and a `BackendWarning` says so if they are not.
"""

import os
import warnings

import numpy as np


class BackendWarning(RuntimeWarning):
    """The compiled kernels are not built."""


def _choose():
    """The extension module, or None."""
    wanted = os.environ.get("SLOWFLOW_BACKEND", "")
    if wanted not in ("", "native", "numpy"):
        raise ValueError(f"SLOWFLOW_BACKEND is {wanted!r}; it may be 'native' or 'numpy'")
    if wanted == "numpy":
        return None
    try:
        from slowflow_kernels import _native
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
    return _native


NATIVE = _choose()


def _stacked(ufunc):
    def stacked(*arguments):
        values = ufunc(*arguments)
        return np.stack(values if ufunc.nout > 1 else (values,))

    return stacked


def _in_tuple(ufunc):
    def in_tuple(*arguments):
        return (ufunc(*arguments),)

    return in_tuple


def compiled(module):
    """Name -> compiled kernel of one generated module; nothing on NumPy."""
    if NATIVE is None:
        return {}
    kernels = {}
    for name, (ufunc, returns) in NATIVE.load(module).items():
        if returns == "c":
            kernel = _stacked(ufunc)
        elif returns == "t" and ufunc.nout == 1:
            kernel = _in_tuple(ufunc)
        else:
            kernels[name] = ufunc
            continue
        kernel.__name__ = kernel.__qualname__ = name
        kernel.__doc__ = ufunc.__doc__
        kernels[name] = kernel
    return kernels
