"""The package as a user gets it: a wheel, in an environment of its own, run in an empty folder."""

from __future__ import annotations

import functools
import importlib.metadata
import json
import math
import os
import shutil
import subprocess
import sys
import venv
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.conftest import Once
from tests.files import ROOT
from tests.oracles.by_time import odd_of

pytestmark = pytest.mark.slow
SOURCES = ("pyproject.toml", "setup.py", "README.md", "LICENSE")
NEEDED = ("numpy", "scipy")
#: Matplotlib and what it imports
PLOTTING = ("matplotlib", "contourpy", "cycler", "fonttools", "kiwisolver", "packaging", "pillow", "pyparsing",
            "python-dateutil", "six")  # fmt: skip


#: what the derivation imports
DERIVING = ("sympy", "mpmath", "python-flint", "jinja2", "markupsafe", "platformdirs")
#: a force that the project has not, from its name, its numbers and its pieces; prints what it answers
TRIAL = """
import json
import os
os.environ["SLOWFLOW_DERIVED"] = "derived"
import sympy as sp
from slowflow import derive
from slowflow.core import backend

u, b, k, d = sp.symbols("u b k d")
about = {name: {"above": 0} for name in ("b", "k", "d")}
PIECES
how = {"reach": 1.0} if hasattr(pieces[0][0], "__code__") else {"compile": True}
made = derive.mechanism("pad", pieces, about, **how)
numbers = {"k": 3.0, "d": 0.2, "zeta": 0.02}
one = made(b=2.0, mu=0.005, **numbers)
told = {
    "compiled": getattr(made, "compiled", False),
    "A": one.steady_state(Omega=0.5, F_0=0.05).A,
    "F_SN": one.saddle_node_onset().F_SN,
    "folds": one.saddle_nodes(0.05).Omega.tolist(),
    "of many": [row[:2] for row in made.many(b=[2.0, 2.5], mu=0.005, **numbers).saddle_nodes(0.05).Omega.tolist()],
}
shaken = made(b=2.0, c_2=0.8, excitation="base", **numbers)
told["shaken"] = shaken.steady_state(Omega=0.8, F_0=0.1).A, *shaken.amplitudes(Omega=0.8, F_0=0.1).A.tolist()
if told["compiled"]:  # by SciPy a sweep takes long
    swept = one.sweep(Omega=[share * told["folds"][0] for share in (1.06, 1.05, 1.04, 0.98, 0.97, 0.96)], F_0=0.05)
    told["jumps"], told["last"] = swept.jumps, swept[-1][:2]
print(json.dumps(told))
"""
#: a stop on one side only, which the mass meets off its centre; a program that `slowflow derive` runs
SIDED = """
import sympy as sp
from slowflow import derive

u, k, d = sp.symbols("u k d")
stop = derive.mechanism("sided", [(u, d), (u + k*(u - d), None)], {"k": {"above": 0}, "d": {"above": 0}}, odd=False)
if __name__ == "__main__":
    one = stop(k=3.0, d=0.2, zeta=0.02)
    state, motion = one.amplitudes(Omega=0.8, F_0=0.1), one.steady_state(Omega=0.8, F_0=0.1)
    print(*state.u_max, *state.B, motion.A, motion.harmonics(0)[0].real)
"""
#: hardening from the centre, stiffer beyond a gap; a sine within it, a saturating pad beyond: pieces in SymPy, or
#: functions of Python; and the force for u > 0 typed once more
PADS = {
    "polynomial": (
        "pieces = [(u + b*u**3, d), (u + b*u**3 + k*(u - d), None)]",
        lambda u, b: u + b * u**3 + 3 * np.maximum(u - 0.2, 0),
    ),
    "elementary": (
        "pieces = [(u + sp.sin(b*u)/b, d), (u + sp.sin(b*d)/b + k*sp.tanh(2*(u - d))*sp.sqrt(1 + u), None)]",
        lambda u, b: np.where(
            u < 0.2,
            u + np.sin(b * u) / b,
            u + math.sin(0.2 * b) / b + 3 * np.tanh(2 * (u - 0.2)) * np.sqrt(1 + u),
        ),
    ),
    "functions of Python": (
        """import numpy as np
inner = lambda u, b, k, d: u + b * u**3
pieces = [(inner, lambda b, k, d: d), (lambda u, b, k, d: inner(u, b, k, d) + k * np.tanh(u - d), None)]""",
        lambda u, b: u + b * u**3 + 3 * np.tanh(np.maximum(u - 0.2, 0)),
    ),
}


def run(command: list[str | Path], folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run a command in a folder, without anything in the environment that could lead it to the sources."""
    ours = ("PYTHON", "SLOWFLOW", "VIRTUAL_ENV")
    kept = {name: value for name, value in os.environ.items() if not name.startswith(ours)} | environment
    return subprocess.run(command, cwd=folder, env=kept, capture_output=True, text=True)


def copied(folder: Path) -> Path:
    """The sources as they are, aside, so that nothing of an earlier build gets into a wheel."""
    sources = folder / "sources"
    for name in ("src", "generated", "derivations"):
        shutil.copytree(ROOT / name, sources / name, ignore=shutil.ignore_patterns("*.so", "__pycache__", "*.egg-info"))
    for name in SOURCES:
        shutil.copy(ROOT / name, sources)
    return sources


def built(folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """A wheel of the sources, built in a folder."""
    command = [sys.executable, "-m", "pip", "wheel", "--no-deps", "--no-index", "--no-build-isolation", "."]
    return run([*command, "--wheel-dir", folder], copied(folder), **environment)


@pytest.fixture(scope="module")
def wheel(once: Once) -> Path:
    """A wheel of the sources."""

    def build(folder: Path) -> None:
        # what is in it is asked here, not how fast it is
        done = built(folder, CFLAGS="-O0")
        assert done.returncode == 0, done.stdout + done.stderr

    (found,) = once("wheel", build).glob("*.whl")
    return found


@pytest.mark.night
def test_without_a_compiler_no_wheel_is_built(tmp_path: Path) -> None:
    (tmp_path / "none").mkdir()
    done = built(tmp_path / "none", CC="false")
    assert done.returncode != 0 and not list((tmp_path / "none").glob("*.whl"))
    assert "needs a C compiler" in done.stdout + done.stderr


def environment(folder: Path, wheel: Path, distributions: tuple[str, ...]) -> Path:
    """A fresh environment with the wheel, and with these distributions as they are installed here; its programs."""
    venv.create(folder, symlinks=True)
    site = next(folder.glob("lib/python*/site-packages"))
    for distribution in distributions:
        try:
            files = importlib.metadata.distribution(distribution).files or ()
        except importlib.metadata.PackageNotFoundError:
            continue
        for top in {file.parts[0] for file in files} - {"..", "__pycache__"}:
            (site / top).symlink_to(Path(str(files[0].locate())).parents[len(files[0].parts) - 1] / top)
    command = [sys.executable, "-m", "pip", "--python", folder / "bin" / "python", "install", "--no-deps", "--no-index"]
    done = run([*command, wheel], folder)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder / "bin"


@pytest.fixture(scope="module")
def installed(once: Once, wheel: Path) -> Path:
    """The programs of an environment with NumPy, SciPy and the wheel."""
    return once("plain", lambda folder: environment(folder, wheel, NEEDED)) / "bin"


def test_a_scene_runs_in_any_folder(installed: Path, tmp_path: Path) -> None:
    assert run([installed / "slowflow", "new"], tmp_path).returncode == 0
    done = run([installed / "python", "-m", "slowflow", "run", "scene.toml", "-o", "answers"], tmp_path)
    assert done.returncode == 0, done.stderr
    assert "1700.0" in (tmp_path / "answers" / "answers.json").read_text()
    folds = (tmp_path / "answers" / "saddle_nodes.csv").read_text().splitlines()
    assert folds[0] == "F/N,f/Hz,A/mm,kind,corner" and len(folds) == 5
    done = run([installed / "python", "-c", "from slowflow.sizing import tolerances; print(tolerances)"], tmp_path)
    assert done.returncode == 0, done.stderr


def test_a_wheel_has_the_solvers_for_any_processor(installed: Path, tmp_path: Path) -> None:
    """A checkout may leave them out."""
    code = "from slowflow.core import backend; print(backend.SOLVER and backend.SOLVER.BUILD['builds'])"
    done = run([installed / "python", "-c", code], tmp_path)
    assert done.stdout.split(", ")[0].strip() in ("baseline", "one", "None"), done.stderr


@pytest.mark.night
def test_what_is_proved_of_table_1_is_printed_in_any_folder(installed: Path, tmp_path: Path) -> None:
    done = run([installed / "slowflow", "certify", "0.04"], tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stderr == "" and "F_SN" in done.stdout
    assert list(tmp_path.iterdir()) == []


@pytest.mark.night
def test_with_matplotlib_scenes_and_reports_are_made(wheel: Path, tmp_path: Path) -> None:
    programs = environment(tmp_path / "environment", wheel, NEEDED + PLOTTING)
    (tmp_path / "empty").mkdir()
    # in one program, which starts once
    scenes = sorted((ROOT / "scenes").glob("*.toml"))
    code = "import sys; from slowflow.app.cli import main; print([main(command.split()) for command in sys.argv[1:]])"
    commands = [f"run {scene} -o {scene.stem} --quiet" for scene in scenes]
    commands += [f"report {scene} -o {scene.stem}.html --quiet" for scene in scenes[:2]]
    done = run([programs / "python", "-c", code, *commands], tmp_path / "empty")
    assert done.stdout.splitlines()[-1] == str([0] * len(commands)), done.stderr
    assert all((tmp_path / "empty" / scene.stem / "answers.json").exists() for scene in scenes)
    assert len(list((tmp_path / "empty").glob("*.html"))) == 2


@pytest.fixture(scope="module")
def stranger(once: Once, wheel: Path) -> Path:
    """The programs of an environment with what the derivation imports as well."""
    return once("deriving", lambda folder: environment(folder, wheel, NEEDED + DERIVING)) / "bin"


@pytest.mark.night
@pytest.mark.parametrize("kind", PADS)
def test_a_stranger_derives_a_mechanism_in_an_empty_folder(stranger: Path, tmp_path: Path, kind: str) -> None:
    pieces, force = PADS[kind]
    done = run([stranger / "python", "-W", "ignore", "-c", TRIAL.replace("PIECES", pieces)], tmp_path)
    assert done.returncode == 0, done.stderr
    printed = json.loads(done.stdout)
    assert printed["compiled"] == (kind != "functions of Python")
    folds, others = turns(functools.partial(force, b=2.0)), turns(functools.partial(force, b=2.5))
    assert folds(printed["F_SN"] * 0.97) == []
    assert len(printed["folds"]) == 2
    np.testing.assert_allclose(folds(0.05), printed["folds"], atol=2e-3)
    np.testing.assert_allclose([folds(0.05), others(0.05)], printed["of many"], atol=2e-3)
    odd = odd_of(functools.partial(force, b=2.0))
    # with smoothed friction a mass that sticks creeps at 1e-6
    assert integrated(odd, Omega=0.5, F_0=0.05, mu=0.005)[0] == pytest.approx(printed["A"], rel=1e-4)
    motion, *states = printed["shaken"]
    settled, _ = integrated(odd, Omega=0.8, F_0=0.1 * 0.8**2, c_2=0.8)
    assert motion == pytest.approx(settled, rel=1e-6)
    assert states == pytest.approx([settled], rel=5e-3)  # what averaging may be off here
    if printed["compiled"]:
        ((before, after),) = printed["jumps"]
        assert after < folds(0.05)[0] < before
        Omega, A = printed["last"]
        assert integrated(odd, Omega=Omega, F_0=0.05, mu=0.005)[0] == pytest.approx(A, rel=1e-4)


@pytest.mark.night
def test_stranger_derives_and_writes_a_one_sided_stop(stranger: Path, tmp_path: Path) -> None:
    (tmp_path / "sided.py").write_text(SIDED)
    kept = str(tmp_path / "kept")
    done = run([stranger / "python", "-W", "ignore", "sided.py"], tmp_path, SLOWFLOW_DERIVED=kept)
    assert done.returncode == 0, done.stderr
    u_max, B, A, mean = map(float, done.stdout.split())
    settled, centre = integrated(lambda u: u + 3 * max(u - 0.2, 0.0), Omega=0.8, F_0=0.1)
    assert A == pytest.approx(settled, rel=1e-6)
    assert mean == pytest.approx(centre, rel=1e-4)
    # averaging without even harmonics: some percent of the stroke, a fifth of the small mean
    assert u_max == pytest.approx(settled, rel=0.05)
    assert B == pytest.approx(centre, rel=0.2)
    done = run([stranger / "slowflow", "derive", "sided.py", "-o", "out"], tmp_path, SLOWFLOW_DERIVED=kept)
    assert done.returncode == 0, done.stderr
    folder = tmp_path / "out" / "sided"
    listed = json.loads((folder / "MANIFEST.json").read_text())["files"]
    assert {path.name for path in folder.iterdir()} == {*listed, "MANIFEST.json"}
    assert any(name.endswith(".py") for name in listed)
    assert "Equation of motion" in (folder / "derivation.md").read_text()


def turns(force: Callable[[Any], Any]) -> Callable[[float], list[float]]:
    """Of a forcing, where Omega along the amplitude turns: more than one state or not.

    By brute force: A over Omega from (24) with the describing function by quadrature.
    """
    t = (np.arange(1000) + 0.5) * math.pi / 2000
    A = np.linspace(2e-4, 0.7, 3500)
    h = -4 / math.pi * np.sum(force(A[:, np.newaxis] * np.cos(t)) * np.cos(t), axis=1) * (t[1] - t[0])

    def folds(F_0: float) -> list[float]:
        Omega = np.linspace(0.9, 3.5, 5201)[:, np.newaxis]
        above = np.hypot(A * Omega**2 + h, 2 * 0.02 * A * Omega + 4 * 0.005 / math.pi) > F_0
        crossings = np.count_nonzero(above[:, 1:] != above[:, :-1], axis=1)
        return [float(Omega[k, 0]) for k in np.flatnonzero(np.diff(crossings))]

    return folds


def integrated(
    force: Callable[[float], float], Omega: float, F_0: float, mu: float = 0.0, c_2: float = 0.0
) -> tuple[float, float]:
    """The largest |u| and the mean of what the equation of motion settles to, by SciPy; zeta is 0.02."""

    def motion(tau: float, state: Any) -> tuple[float, float]:
        u, v = state
        resists = 0.04 * v + c_2 * abs(v) * v + (mu * math.tanh(v / 1e-6) if mu else 0.0)
        return v, F_0 * math.cos(Omega * tau) - force(u) - resists

    turn = 2 * math.pi / Omega
    at = np.linspace(118 * turn, 120 * turn, 8001)
    found = solve_ivp(motion, (0, 120 * turn), (0.0, 0.0), method="LSODA", rtol=1e-9, atol=1e-12, t_eval=at)
    return float(np.abs(found.y[0]).max()), float(found.y[0][:-1].mean())


def test_the_wheel_is_compiled_and_typed(installed: Path, tmp_path: Path) -> None:
    code = "import slowflow, pathlib; folder = pathlib.Path(slowflow.__file__).parents[1]\n"
    listing = "print(folder, *folder.glob('slowflow*/py.typed'))"
    done = run([installed / "python", "-W", "ignore", "-c", code + listing], tmp_path)
    folder, *typed = done.stdout.split()
    assert Path(folder).is_relative_to(installed.parent)
    marked = {Path(path).parent.name for path in typed if path.endswith("py.typed")}
    assert marked == {"slowflow", "slowflow_kernels"}
