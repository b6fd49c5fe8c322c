"""The compiled kernels, in place of NumPy's, loaded at the first import.

`NATIVE` is the extension module; wrappers give its ufuncs the names and forms of the kernels.
"""

from __future__ import annotations

import functools
import importlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from inspect import Parameter, Signature
from types import ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow.support.errors import WrongType

#: the compiled kernels: an extension module, which imports nothing but NumPy
EXTENSION = "slowflow_kernels._native"


@functools.cache
def loaded(name: str) -> ModuleType:
    """An extension module of slowflow. Raises ImportError where it is not built, or not for this processor."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(f"{NOT_BUILT} ({error})", name=name) from error


NOT_BUILT = (
    "slowflow is not compiled here: `make derive` compiles a checkout, `pip install` a package; either takes a C "
    "compiler, on Linux from PyPI where there is none"
)
#: tests leave it out, to compare with the kernels as NumPy has them
NATIVE: ModuleType | None = loaded(EXTENSION)
_BY_NAME = Parameter.POSITIONAL_OR_KEYWORD


def compiled(module: Mapping[str, Any], ufuncs: Sequence[np.ufunc]) -> dict[str, Callable[..., Any]]:
    """A module's kernels by their ufuncs: with name, arguments and docstring as on NumPy, which is `__wrapped__`."""
    found = {}
    for ufunc in ufuncs:
        if (kernel := module.get(ufunc.__name__)) is None:  # by `from_c`
            continue
        names = kernel.__code__.co_varnames[: kernel.__code__.co_argcount]
        called = functools.wraps(kernel)(_called(names, ufunc))
        form = FORMS.get(kernel.__annotations__["return"])
        found[ufunc.__name__] = _formed(called, form) if form else called
    return found


def _formed(kernel: Callable[..., Any], form: Callable[[Any], Any]) -> Callable[..., Any]:
    """A compiled kernel whose outputs have a form."""

    @functools.wraps(kernel)
    def formed(*arguments: Any, **named: Any) -> Any:
        return form(kernel(*arguments, **named))

    return formed


def _stacked(values: Any) -> npt.NDArray[np.float64]:
    """Outputs that are a polynomial's coefficients, along a new first axis."""
    return np.stack(values if isinstance(values, tuple) else (values,))


#: of outputs, by what a kernel returns
FORMS: Mapping[str, Callable[[Any], Any]] = {"Floats": _stacked, "tuple[Any]": lambda value: (value,)}


def from_c(module: str, names: Mapping[str, str], stacked: Sequence[str] = ()) -> dict[str, Callable[..., Any]]:
    """The kernels of a generated module that have no text in Python: by name, with the names of their arguments.

    Those `stacked` give a polynomial's coefficients, along a new first axis.
    """
    ufuncs = {ufunc.__name__: ufunc for ufunc in getattr(loaded(EXTENSION), module)()}
    found = {}
    for kernel, arguments in names.items():
        called = _called(arguments.split(), ufuncs[kernel])
        called.__module__, called.__name__, called.__qualname__ = f"slowflow_kernels.{module}", kernel, kernel
        called.__doc__ = f"In C alone; generated/c/{module}.h documents it."
        results = ["Any"] * ufuncs[kernel].nout
        several = f"tuple[{', '.join(results)}]" if len(results) > 1 else "Any"
        returns = "Floats" if kernel in stacked else several
        called.__annotations__ = dict.fromkeys(arguments.split(), "ArrayLike") | {"return": returns}
        of_type = [Parameter(name, _BY_NAME, annotation="ArrayLike") for name in arguments.split()]
        called.__signature__ = Signature(of_type, return_annotation=returns)  # type: ignore[attr-defined]
        found[kernel] = _formed(called, _stacked) if kernel in stacked else called
    return found


def _called(names: Sequence[str], ufunc: np.ufunc) -> Callable[..., Any]:
    """A ufunc, which takes positional arguments only, with a kernel's keywords."""

    def called(*arguments: Any, **named: Any) -> Any:
        if named:
            # what is no argument of the kernel is NumPy's: out, where, ...
            by_name = {name: named.pop(name) for name in names if name in named}
            if by_name:
                arguments = (*arguments, *_in_order(ufunc.__name__, names[len(arguments) :], by_name))
        return ufunc(*arguments, **named)

    return called


def _in_order(kernel: str, names: Sequence[str], by_name: Mapping[str, Any]) -> Iterator[Any]:
    """The arguments given by name, in the order of the names that are left; TypeError as a function raises it."""
    for name in by_name:
        if name not in names:
            raise WrongType(f"{kernel}() got multiple values for argument {name!r}")
    for name in names:
        if name not in by_name:
            raise WrongType(f"{kernel}() missing 1 required positional argument: {name!r}")
        yield by_name[name]
