"""Every public question, put to compiled modules under address and undefined-behaviour sanitizers."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import numpy as np
import pytest

from slowflow.core import backend
from tests.files import ROOT

NATIVE = ROOT / "src" / "slowflow" / "native"
FLAGS = ["-std=c11", "-O1", "-g1", "-fno-omit-frame-pointer", "-ffp-contract=off", "-fPIC", "-shared"]
SANITIZED = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
INCLUDES = [
    NATIVE,
    ROOT / "generated" / "c",
    ROOT / "generated" / "native",
    np.get_include(),
    sysconfig.get_path("include"),
]
MODULES = {"slowflow._native": "solver", "slowflow._exact": "exact"}


def runtime():
    """The library of the address sanitizer, which has to be loaded before Python; "" where there is none."""
    if shutil.which("gcc") is None:
        return ""
    found = subprocess.run(["gcc", "-print-file-name=libasan.so"], capture_output=True, text=True).stdout.strip()
    return found if Path(found).is_absolute() else ""


@pytest.mark.slow
@pytest.mark.night
@pytest.mark.skipif(not runtime(), reason="gcc without its address sanitizer")
def test_no_question_does_in_c_what_c_does_not_define(tmp_path):
    command = ["gcc", *FLAGS, *SANITIZED, "-DPy_LIMITED_API=0x030B0000", *(f"-I{path}" for path in INCLUDES)]
    # the solvers for any processor are left out where the checkout has done so
    without = "baseline" not in backend.SOLVER.BUILD["builds"]
    command += ["-DSF_WITHOUT_BASELINE"] * without
    builds = []
    for name, folder in MODULES.items():
        sources = [path for path in sorted((NATIVE / folder).glob("*.c"))]
        sources = [path for path in sources if not (without and path.stem.endswith("_baseline"))]
        builds.append(subprocess.Popen([*command, *sources, "-o", tmp_path / f"{name}.so", "-lm"]))
    assert [build.wait() for build in builds] == [0, 0]
    # Matplotlib throws exceptions of C++, which the sanitizer of C does not know
    chosen = "-k", "test_there_is_an_answer and not pictures"
    options = "-q", "-s", "-n0", "-p", "no:cacheprovider", "-p", "tests.native.instrumented", *chosen
    done = subprocess.run(
        [sys.executable, "-m", "pytest", *options, "tests/oscillators/test_any_input.py"],
        cwd=ROOT,
        env={
            **os.environ,
            **{"LD_PRELOAD": runtime(), "ASAN_OPTIONS": "detect_leaks=0", "PYTHONMALLOC": "malloc"},
            **{"SLOWFLOW_MODULES": str(tmp_path), "SLOWFLOW_TESTS": "0"},
        },
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
