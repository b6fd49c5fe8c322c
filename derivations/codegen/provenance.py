"""Where generated text comes from, for headers and the manifest: versions of the tools, hashes of the inputs."""

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


def tools() -> str:
    """The same in words."""
    return ", ".join(f"{tool} {version}" for tool, version in versions().items())


def digest(path: Path) -> str:
    """SHA-256 of a file."""
    return hashlib.sha256(path.read_bytes()).hexdigest()
