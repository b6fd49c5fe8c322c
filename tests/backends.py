"""The generated kernels on a backend of one's choice, beside those in use: its name in, modules by name out."""

from __future__ import annotations

import importlib
import os
import sys
from types import ModuleType

#: what depends on the backend
RELOADED = ("slowflow_kernels", "slowflow_support.backend")


def _forget() -> dict[str, ModuleType]:
    """Take the kernels' modules out of the interpreter's memory."""
    return {name: sys.modules.pop(name) for name in list(sys.modules) if name.startswith(RELOADED)}


def load(backend: str) -> dict[str, ModuleType]:
    """Import all kernels once more, on "numpy" or "native". Raises ImportError where the latter is not built."""
    before, wanted = _forget(), os.environ.get("SLOWFLOW_BACKEND")
    os.environ["SLOWFLOW_BACKEND"] = backend
    try:
        names = importlib.import_module("slowflow_kernels").MODULES
        return {name: importlib.import_module(f"slowflow_kernels.{name}") for name in names}
    finally:
        _forget()
        sys.modules.update(before)
        del os.environ["SLOWFLOW_BACKEND"]
        if wanted is not None:
            os.environ["SLOWFLOW_BACKEND"] = wanted
