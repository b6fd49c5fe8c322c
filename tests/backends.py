"""The generated kernels compiled, or as NumPy has them, beside those in use: a name in, modules by name out."""

from __future__ import annotations

import importlib
import sys
from types import ModuleType
from typing import Any

import numpy as np

#: what depends on the backend
RELOADED = ("slowflow_kernels", "slowflow.support.backend")


def _forget() -> dict[str, ModuleType]:
    """Take the kernels' modules out of the interpreter's memory."""
    return {name: sys.modules.pop(name) for name in list(sys.modules) if name.startswith(RELOADED)}


def load(how: str) -> dict[str, ModuleType]:
    """Import all kernels once more, on "numpy" or "native"."""
    before = _forget()
    try:
        support = importlib.import_module("slowflow.support.backend")
        if how == "numpy":
            support.NATIVE = None
        names = importlib.import_module("slowflow_kernels").MODULES
        return {name: importlib.import_module(f"slowflow_kernels.{name}") for name in names}
    finally:
        _forget()
        sys.modules.update(before)


def as_rows(found: Any) -> list[np.ndarray]:
    """What a kernel returns, an array for each of its outputs."""
    return [np.asarray(one, dtype=float) for one in (found if isinstance(found, tuple | list) else [found])]
