"""In: the path of published.py. Out: that file as a module of its own, and the namespace that makes it exact.

The runtime package is not imported: the ledger must not depend on what it is there to judge.
"""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType, SimpleNamespace

import sympy as sp

PUBLISHED = Path(__file__).parents[2] / "src" / "slowflow" / "paper" / "published.py"

#: the functions that published.py asks its namespace for
EXACT = SimpleNamespace(sin=sp.sin, cos=sp.cos, sqrt=sp.sqrt, arccos=sp.acos, exp=sp.exp, sign=sp.sign, pi=sp.pi)


def load() -> ModuleType:
    """published.py."""
    name = "published_standalone"
    spec = importlib.util.spec_from_file_location(name, PUBLISHED)
    if spec is None or spec.loader is None:
        raise ImportError(f"{PUBLISHED} cannot be loaded")
    module = importlib.util.module_from_spec(spec)
    # dataclasses look their module up by name while they are being made
    sys.modules[name] = module
    try:
        spec.loader.exec_module(module)
    finally:
        del sys.modules[name]
    return module
