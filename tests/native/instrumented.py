"""A plugin of pytest: the session's extension modules are those in the folder that SLOWFLOW_MODULES names.

Run by `tests/native/test_sanitized.py` with modules that report what C must not do.
"""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path

FOLDER = Path(os.environ["SLOWFLOW_MODULES"])


class Finder:
    """Finds the package's extension modules in the folder."""

    @staticmethod
    def find_spec(name, path=None, target=None):
        file = FOLDER / f"{name}.so"
        return importlib.util.spec_from_file_location(name, file) if file.exists() else None


sys.meta_path.insert(0, Finder)
sys.modules["flint"] = None  # what balls are asked takes minutes, and nothing of it is compiled here

from slowflow.core import backend  # noqa: E402

assert Path(backend.SOLVER.__file__).parent == Path(backend.EXACT.__file__).parent == FOLDER
