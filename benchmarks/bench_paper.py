"""The first run: `make paper` on a clone in a folder of its own, and once more, where all is made.

A minute or two; needs git, a compiler and a network. What is not committed is not in the clone.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from benchmarks.remote import ROOT, processor

STEPS = ("make paper", "make paper again")


def size(folder: Path) -> float:
    """MB of the files in a folder."""
    return sum(path.lstat().st_size for path in folder.rglob("*") if not path.is_dir()) / 1e6


def measure() -> list[dict[str, Any]]:
    """One row for each step."""
    out = []
    with tempfile.TemporaryDirectory() as folder:
        clone = Path(folder) / "slowflow"
        subprocess.run(["git", "clone", "--quiet", "--depth", "1", ROOT.as_uri(), str(clone)], check=True)
        # the interpreter of this environment would be made one of the clone's
        settings = {key: value for key, value in os.environ.items() if key not in ("MAKEFLAGS", "MAKELEVEL")}
        command = ["make", f"PYTHON={sys.base_prefix}/bin/python3", "paper"]
        for step in STEPS:
            start, worked = time.perf_counter(), processor()
            done = subprocess.run(command, cwd=clone, env=settings, capture_output=True, text=True, check=False)
            if done.returncode:
                raise RuntimeError(f"{step} failed: {done.stderr[-500:]}")
            seconds, used = time.perf_counter() - start, processor() - worked
            out.append({"step": step, "seconds": seconds, "processor": used, "disk": size(clone / ".venv")})
    return out
