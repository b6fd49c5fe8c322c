"""Templates compiled once for all processes, as Python keeps its modules.

In:  a folder of templates.
Out: `kept_beside`: where Jinja keeps their bytecode, the folder in which Python would that of modules there; None where
     nothing can be kept. A template that has changed is compiled anew, and so are all where their environment has.
"""

from __future__ import annotations

import hashlib
import importlib.util
import os
import sys
from pathlib import Path

import jinja2


def kept_beside(folder: Path, environment: Path) -> jinja2.BytecodeCache | None:
    """A store of bytecode, made if it is not there.

    environment -- the file that makes the templates' environment: how its filters are called is part of the bytecode
    """
    kept = Path(importlib.util.cache_from_source(str(folder / "template.py"))).parent
    if sys.dont_write_bytecode:
        return None
    pattern = f"__jinja2_{hashlib.sha256(environment.read_bytes()).hexdigest()[:12]}_%s.cache"
    try:
        kept.mkdir(parents=True, exist_ok=True)
    except OSError:
        return None
    return jinja2.FileSystemBytecodeCache(str(kept), pattern) if os.access(kept, os.W_OK) else None
