"""Templates compiled once for all processes, as Python keeps its modules.

In:  a folder of templates.
Out: `kept_beside`: where Jinja keeps their bytecode, the folder in which Python would that of modules there; None where
     nothing can be kept. A template that has changed is compiled anew.
"""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path

import jinja2


def kept_beside(folder: Path) -> jinja2.BytecodeCache | None:
    """A store of bytecode, made if it is not there."""
    kept = Path(importlib.util.cache_from_source(str(folder / "template.py"))).parent
    if sys.dont_write_bytecode:
        return None
    try:
        kept.mkdir(parents=True, exist_ok=True)
    except OSError:
        return None
    return jinja2.FileSystemBytecodeCache(str(kept)) if os.access(kept, os.W_OK) else None
