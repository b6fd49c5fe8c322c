"""Mechanisms that were derived on this machine: modules in a folder of the user's, made by `slowflow.derive`.

In:  the environment: SLOWFLOW_DERIVED names the folder; without it, the user's folder for what programs keep.
Out: modules with the names of what they were derived from, as `slowflow.derived.stop_0123456789ab`: what is pickled
     finds its functions here, in another process too. Nothing is kept here that cannot be made again.

On POSIX a folder that others own or may write to is refused: what they put there would run.
"""

from __future__ import annotations

import os
from pathlib import Path

from platformdirs import user_cache_path

from slowflow.support.ownership import check_own

FOLDER = Path(os.environ.get("SLOWFLOW_DERIVED") or user_cache_path("slowflow") / "derived")
check_own(FOLDER)
__path__ = [str(FOLDER)]
