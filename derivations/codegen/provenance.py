"""Where generated text comes from, for the manifest: versions of the tools, hashes of the inputs."""

from __future__ import annotations

import functools
import hashlib
import importlib.metadata
from pathlib import Path

TOOLS = ("sympy", "python-flint", "jinja2")


@functools.cache
def versions() -> dict[str, str]:
    """Of the tools that shape the output."""
    return {tool: importlib.metadata.version(tool) for tool in TOOLS}


def digest(path: Path) -> str:
    """SHA-256 of a file."""
    return hashlib.sha256(path.read_bytes()).hexdigest()
