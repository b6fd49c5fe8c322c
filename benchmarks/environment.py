"""What a measurement ran on: versions, processor; nothing that names a machine or a folder."""

from __future__ import annotations

import importlib.metadata
import os
import platform
from pathlib import Path

from slowflow import __version__
from slowflow.core import backend


def processor() -> str:
    """The processor's model in words."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), platform.machine())


def describe() -> dict[str, str | int]:
    """Topics and their values."""
    versions = {name: importlib.metadata.version(name) for name in ("numpy", "scipy", "sympy")}
    build = {"compiler": backend.KERNELS.BUILD["compiler"], "instruction set": backend.KERNELS.BUILD["chosen"]}
    return {
        "slowflow": __version__,
        "python": platform.python_version(),
        **versions,
        **build,
        "processor": processor(),
        "cores": os.cpu_count() or 0,
        "system": f"{platform.system()} {platform.machine()}",
    }
