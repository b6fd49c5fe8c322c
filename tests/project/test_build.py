"""A build in a checkout: what does not compile fails, nothing of an earlier build stays, PyPI has a compiler.

On a copy of Makefile and setup.py with three small modules in place of the solvers.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.files import ROOT
from tests.native.compiler import COMPILER

MODULES = {
    "src/slowflow/native/kernels.c": "generated/slowflow_kernels/_native",
    "src/slowflow/native/solver/_native.c": "src/slowflow/_native",
    "src/slowflow/native/exact/_exact.c": "src/slowflow/_exact",
}
STAMP = ".venv/compiled"

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(COMPILER is None or not shutil.which("make"), reason="no C compiler, or no make"),
]


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A checkout whose extension modules have nothing in them, with those of an earlier build and its stamp."""
    for name in ("Makefile", "setup.py", "pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, tmp_path)
    for name in ("derivations/constraints.txt", "src/slowflow/version.py"):
        (tmp_path / name).parent.mkdir(parents=True)
        shutil.copy(ROOT / name, tmp_path / name)
    for source, module in MODULES.items():
        for path in (tmp_path / source, tmp_path / module):
            path.parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / source).write_text("int slowflow_nothing;\n")
        (tmp_path / f"{module}.abi3.so").write_text("of an earlier build")
    (tmp_path / ".venv").mkdir()
    (tmp_path / ".venv" / "pyvenv.cfg").touch()
    (tmp_path / STAMP).touch()
    os.utime(tmp_path / STAMP, (0, 0))
    return tmp_path


def make(checkout: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """`make .venv/compiled`, with the Python that runs this test."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("SLOWFLOW", "MAKE", "MFLAGS"))}
    command = ["make", f"BIN={Path(sys.executable).parent}", STAMP]
    return subprocess.run(command, cwd=checkout, env=kept | environment, capture_output=True, text=True)


def built(checkout: Path) -> dict[str, bytes]:
    """The extension modules that are there to be imported."""
    return {path.name: path.read_bytes() for path in checkout.rglob("*.so") if not {"build", ".venv"} & {*path.parts}}


def test_what_compiles_replaces_what_was_there(checkout: Path) -> None:
    done = make(checkout)
    assert done.returncode == 0, done.stdout + done.stderr
    assert (checkout / STAMP).exists()
    assert len(list(checkout.rglob("_exact*.so"))) == 2  # where it is made, and where it is imported
    assert b"of an earlier build" not in built(checkout).values()


@pytest.mark.parametrize("source", MODULES)
def test_broken_build_fails_and_leaves_nothing_to_import(checkout: Path, source: str) -> None:
    (checkout / source).write_text("this is no C\n")
    done = make(checkout)
    assert done.returncode != 0
    assert "could not be compiled" in done.stderr
    assert not built(checkout) and not (checkout / STAMP).exists()


def test_a_compiler_that_is_asked_for_and_absent_fails(checkout: Path) -> None:
    done = make(checkout, CC="no-such-compiler")
    assert done.returncode != 0
    assert "could not be compiled" in done.stderr and "ziglang" in done.stderr
    assert not built(checkout) and not (checkout / STAMP).exists()


@pytest.mark.night
def test_without_a_compiler_that_of_pypi_compiles(checkout: Path, tmp_path: Path) -> None:
    """In an environment of its own, whose PATH has no compiler: as in a slim container."""
    programs = tmp_path / "programs"
    programs.mkdir()
    for name in ("sh", "env", "rm", "nice", "grep", "find", "touch", "make", "uname"):
        if found := shutil.which(name):
            (programs / name).symlink_to(found)
    shutil.rmtree(checkout / ".venv")
    subprocess.run([sys.executable, "-m", "venv", checkout / ".venv"], check=True)
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("SLOWFLOW", "MAKE", "MFLAGS"))}
    kept |= {"PATH": str(programs), "ZIG_GLOBAL_CACHE_DIR": str(tmp_path / "cache")}
    python = checkout / ".venv" / "bin" / "python"
    subprocess.run([python, "-m", "pip", "--quiet", "install", "--upgrade", "setuptools", "numpy"], check=True)
    (checkout / ".venv" / "pyvenv.cfg").touch()
    done = subprocess.run(["make", STAMP], cwd=checkout, env=kept, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "installing ziglang" in done.stdout and "compiled by ziglang" in done.stderr
    assert set(built(checkout)) == {"_native.abi3.so", "_exact.abi3.so"} and (checkout / STAMP).exists()
