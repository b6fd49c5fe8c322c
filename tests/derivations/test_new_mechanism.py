"""A mechanism of the library as one of the package: its file, then what `make derive` does, then every question."""

from __future__ import annotations

import functools
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import sympy as sp

from derivations.forces.of_mechanism import of_mechanism
from derivations.library import bilinear
from derivations.mechanisms import Piece
from derivations.paper.averaging import averaged
from derivations.paper.critical_forcings import saddle_node_onset
from derivations.paper.equation_of_motion import oscillator
from derivations.paper.restoring_force import restoring
from derivations.paper.slow_flow import SCENES, slow_flow
from tests.files import ROOT

NOT_COPIED = shutil.ignore_patterns(".*", "build", "output", "*.egg-info", "__pycache__", "*.so")
COPIED = ["benchmarks", "derivations", "generated", "src", "tests", "README.md", "pyproject.toml", "setup.py"]


def derived(folder: Path) -> None:
    """A copy with the bilinear spring's file, derived and built: without a virtual environment, so step by step."""
    for part in COPIED:
        if (ROOT / part).is_dir():
            shutil.copytree(ROOT / part, folder / part, ignore=NOT_COPIED)
        else:
            shutil.copy(ROOT / part, folder / part)
    shutil.copy(Path(bilinear.__file__), folder / "derivations" / "mechanisms")
    run(folder, "-m", "derivations")
    # what it answers is asked here, not how fast
    run(folder, "setup.py", "-q", "build_ext", "--inplace", CFLAGS="-O0")


@pytest.fixture(scope="module")
def project(once):
    """The folder of that copy, which no test changes but by files that the others do not read."""
    return once("project", derived)


def run(folder: Path, *command: str, **environment: str) -> str:
    """What Python prints in that project."""
    paths = os.pathsep.join(str(folder / part) for part in ("src", "generated", "."))
    # a pytest within takes itself for a worker of this one otherwise, and its C for its own
    outside = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    done = subprocess.run(
        [sys.executable, *command],
        cwd=folder,
        env={**outside, "PYTHONPATH": paths, **environment},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-3000:]
    return done.stdout


@pytest.mark.slow
@pytest.mark.night
def test_every_question_is_answered_by_the_compiled_solvers(project):
    assert run(project, "-m", "tests.mechanisms.questions") == "compiled\n"


@pytest.mark.slow
@pytest.mark.night
def test_its_kernels_and_its_record_pass_the_tests_of_all_others(project):
    run(project, "-m", "tests.oracles.make_kernel_oracle", "bilinear")
    # pytest fails where it finds no test
    run(
        project,
        *("-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", "bilinear"),
        *("tests/kernels/test_kernels.py", "tests/native/test_native_kernels.py", "tests/native/test_records.py"),
    )


# ---- what a file may state


def changed(**changes):
    """The bilinear spring, stated otherwise."""
    return bilinear.MECHANISM.__class__(**{**vars(bilinear.MECHANISM), **changes})


def test_constant_for_continuity_needs_no_name_and_no_jump():
    stated = oscillator(bilinear.MECHANISM)
    assert restoring(stated.polynomials, bilinear.MECHANISM.breakpoints).jumps == (0,)


def test_a_force_that_jumps_needs_a_name_for_its_constant():
    x, k_v, k_2, d = bilinear.x, bilinear.k_v, bilinear.k_2, bilinear.d
    pieces = (bilinear.MECHANISM.pieces[0], Piece((k_2 - k_v) * (x - 2 * d)))
    with pytest.raises(ArithmeticError, match="jumps where piece 1 ends"):
        oscillator(changed(pieces=pieces))
    named = changed(pieces=pieces, coefficients=({}, {0: sp.Symbol("c"), 1: bilinear.alpha_2}))
    (jump,) = restoring(oscillator(named).polynomials, named.breakpoints).jumps
    assert jump != 0


def test_even_powers_in_the_first_piece_are_refused():
    x, d = bilinear.x, bilinear.d
    pieces = (Piece(bilinear.k_v * d, until=x - d), bilinear.MECHANISM.pieces[1])
    named = ({0: sp.Symbol("c"), 1: sp.Symbol("alpha_1")}, {0: sp.Symbol("e"), 1: bilinear.alpha_2})
    with pytest.raises(ArithmeticError, match=r"powers \[0\] of u in the first piece"):
        of_mechanism(changed(pieces=pieces, coefficients=named))


@functools.cache
def of_bilinear():
    return restoring(oscillator(bilinear.MECHANISM).polynomials, bilinear.MECHANISM.breakpoints)


@pytest.mark.slow
@pytest.mark.parametrize("scene", SCENES)
def test_a_linear_first_piece_has_no_candidate_for_an_onset(scene):
    """F_A and F_AA vanish together nowhere, or, without friction, where one vanishes: no amplitude stands out."""
    found = saddle_node_onset(slow_flow(averaged(), scene), of_bilinear())
    assert list(found.reduced) == [0]
