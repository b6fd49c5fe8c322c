"""The code of the site runs: tutorial, how-to pages, gallery; kernels give the same digits in every language."""

from __future__ import annotations

import importlib.util
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from docs.site import docstrings, printed
from slowflow import example
from slowflow.app import cli
from slowflow_kernels import rod_spring
from tests.files import ROOT

DOCS = ROOT / "docs"
PAGES = [
    *(DOCS / f"{name}.md" for name in ("index", "tutorial", "gallery")),
    DOCS / "mechanisms.md",
    *sorted((DOCS / "howto").glob("*.md")),
]
#: they derive mechanisms, or ask much
SLOW = ("mechanisms", "own_mechanism", "off_centre", "damping", "tutorial", "tolerances", "fit", "gallery")
PATHS, *LANGUAGES = (DOCS / "howto" / "languages.md").read_text(encoding="utf-8").split("\n## ")
#: what a language's lines need besides a C compiler: programs, and packages of Python
NEEDED = {
    "C": ((), ()),
    "C++": (("c++",), ()),
    "Fortran": (("gfortran",), ()),
    "JAX": ((), ("jax",)),
    "numba": ((), ("numba",)),
    "cffi": ((), ("cffi",)),
    "ctypes": ((), ()),
    "MATLAB and GNU Octave": (("octave-cli",), ()),
    "Julia": (("julia",), ()),
    "JavaScript": (("node",), ("ziglang",)),
}


@pytest.mark.parametrize(
    "page", [pytest.param(page, marks=[pytest.mark.slow] * (page.stem in SLOW), id=page.stem) for page in PAGES]
)
def test_the_code_of_a_page_runs(page: Path) -> None:
    blocks = re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    if page.stem in ("gallery", "mechanisms"):
        pytest.importorskip("matplotlib")
    if page.stem == "batches":
        pytest.importorskip("xarray", reason="the extra `grid` is not installed: xarray")
    if page.stem in ("own_mechanism", "mechanisms"):
        pytest.importorskip("flint", reason="what derives is not installed")
    exec("\n".join(blocks), {"__name__": page.stem})


@pytest.mark.slow
@pytest.mark.parametrize("section", LANGUAGES, ids=lambda text: text.split("\n")[0])
def test_another_language_computes_the_same(section: str, tmp_path: Path) -> None:
    language = section.split("\n")[0]
    programs, packages = NEEDED[language]
    missing = [name for name in ("cc", *programs) if shutil.which(name) is None]
    missing += [name for name in packages if importlib.util.find_spec(name) is None]
    if missing:
        pytest.skip(f"{language} is not tried: there is no {', '.join(missing)} here")
    for name, text in re.findall(r"`([\w.]+)`:\n\n```\w+\n(.*?)```", section, re.DOTALL):
        (tmp_path / name).write_text(text, encoding="utf-8")
    paths, commands = (text for part in (PATHS, section) for text in re.findall(r"```sh\n(.*?)```", part, re.DOTALL))
    # what this process imports is what the lines import
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    environment = {**os.environ, "PATH": path, "PYTHONPATH": os.pathsep.join(sys.path)}
    command = ["sh", "-ec", paths + commands]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    found = np.array(done.stdout.split(), float)
    h, h_A, _, _ = rod_spring.averaged(0.5, *rod_spring.coefficients(*example.DESIGN))
    # the same operations in the same order; NumPy's arctangent may differ in the last place
    np.testing.assert_array_max_ulp(found, np.array([h, h_A], float), maxulp=4)


@pytest.mark.slow
def test_the_commands_of_the_page_on_the_command_line_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("matplotlib")
    page = (DOCS / "howto" / "command_line.md").read_text(encoding="utf-8")
    (lines,) = re.findall(r"```sh\n(.*?)```", page, re.DOTALL)
    monkeypatch.chdir(tmp_path)
    for line in lines.splitlines():
        assert cli.main(line.split()[1:]) == 0, line
        assert line.removesuffix(" -o answers") in page.split("```")[2]
    assert (tmp_path / "answers" / "saddle_node_onset.csv").exists() and (tmp_path / "report.html").exists()
    # the part that is shown is a part of the file, but for its questions
    (shown,) = re.findall(r"```toml\n(.*?)```", page, re.DOTALL)
    scene = (tmp_path / "scene.toml").read_text(encoding="utf-8").splitlines()
    assert [line for line in shown.splitlines() if line not in scene] == [shown.splitlines()[-1]]
    capsys.readouterr()


def test_a_docstring_is_shown_as_it_stands() -> None:
    lines = [
        "What (1) gives: u*v, `A` of h_A.",
        "",
        "F_0 -- the force,",
        "       in k_v L",
        "A, B -- two",
        "",
        "    code(*x)",
    ]
    docstrings.as_rst(None, "class", "x", None, None, lines)
    shown = [
        "What (1) gives: u\\*v, ``A`` of h_A.",
        "",
        "``F_0``",
        "    the force, in k_v L",
        "``A, B``",
        "    two",
        "",
        "::",
        "",
    ]
    assert lines == [*shown, "        code(*x)", ""]


def test_the_site_has_what_a_block_prints_beneath_it() -> None:
    page = "```python\na = 20\n```\n\n```python\nprint(a + 1, end='  \\n')\nprint('[x](y)')\n```\n\n```sh\nls\n```\n"
    shown = printed.beneath(page, "a page")
    assert [line for line in shown.split("\n") if line not in page.split("\n")] == [
        "````{code-block} text", ":class: printed", "21", "[x](y)", "````",
    ]  # fmt: skip
    assert shown.index("21") > shown.index("print(a + 1")
    with pytest.raises(NameError):
        printed.beneath("```python\nprint(b)\n```\n", "a page")
