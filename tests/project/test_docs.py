"""What is written for readers runs, and says what the code is: README, examples, the list of signatures, decisions."""

from __future__ import annotations

import ast
import functools
import inspect
import json
import math
import re
import runpy
import tomllib
from importlib import import_module
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
from scipy.integrate import quad

import slowflow
from docs import api
from docs.site import docstrings
from slowflow import Remark
from slowflow.answers.results import SteadyStates
from slowflow.app import cli, starters
from slowflow.averaged.questions import Averaged
from slowflow_kernels.conventions import FoldKind, OnsetKind, Status
from tests.files import ROOT, stored

EXAMPLES = sorted((ROOT / "examples").glob("*.py"))
#: packages of extras, by example
NEEDED = {"stored_map": ("xarray", "dask", "zarr")}
#: those of examples in the list of signatures, by module
EXAMPLES_NEED = {
    "slowflow.answers.answer": ("pandas", "xarray"),
    "slowflow.averaged.batches": ("xarray",),
    "slowflow.derive": ("sympy", "flint"),
    **dict.fromkeys(("slowflow.grid.designs", "slowflow.oscillators.physical_grid"), ("xarray", "dask", "zarr")),
    "slowflow.sizing.tolerances": ("SALib",),
}
#: modules whose examples take seconds
SLOW = {
    "slowflow.derive",
    "slowflow.grid.designs",
    "slowflow.oscillators.physical_grid",
    *(f"slowflow.sizing.{room}" for room in ("fitting", "requirements", "tolerances")),
    *(f"slowflow.off_centre.{room}" for room in ("answers", "many", "questions")),
}
DECISIONS = ROOT / "docs" / "decisions"
LINK = re.compile(r"\]\(([^)#:]+)\)")
#: pages whose links must lead somewhere
PAGES = [
    *(ROOT / name for name in ("README.md", "CONTRIBUTING.md", "SECURITY.md")),
    *sorted((ROOT / "docs").rglob("*.md")),
]


@pytest.mark.parametrize(
    "example",
    [
        pytest.param(
            path,
            id=path.stem,
            marks=[pytest.mark.slow] if path.stem in {"derived", "mount", "own_force", "stored_map"} else [],
        )
        for path in EXAMPLES
    ],
)
def test_an_example_runs(example: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for package in NEEDED.get(example.stem, ()):
        pytest.importorskip(package, reason=f"an extra is not installed: {package}")
    runpy.run_path(str(example), run_name="__main__")
    assert len(capsys.readouterr().out.splitlines()) >= 5


def test_the_notebook_has_the_answers_of_its_cells() -> None:
    """Run anew, without plots: what each cell shows is what is stored."""
    pytest.importorskip("matplotlib")
    space: dict[str, Any] = {}
    for cell in json.loads((ROOT / "examples" / "mount.ipynb").read_text(encoding="utf-8"))["cells"]:
        outputs = [output["data"] for output in cell.get("outputs", []) if "text/html" in output["data"]]
        if cell["cell_type"] == "code":
            body = ast.parse("".join(cell["source"])).body
            last = ast.unparse(body.pop()) if outputs else "None"
            exec(ast.unparse(body), space)
            answer = eval(last, space)
            assert [(str(answer), answer._repr_html_().partition("<figure>")[0]) for _ in outputs] == [
                ("".join(one["text/plain"]), "".join(one["text/html"]).partition("<figure>")[0]) for one in outputs
            ]


def test_the_example_of_table_1_prints_the_certified_folds(capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(ROOT / "examples" / "table_1.py"))
    printed = capsys.readouterr().out
    case = stored("table_1")[1]
    (forcing,) = (record for record in case["forcings"] if record["F_0"][1] == 0.04)
    assert len(forcing["folds"]) == 2
    for fold in forcing["folds"]:
        assert f"{fold['kind']:9} at Omega = {float(fold['Omega']):.4f}, A = {float(fold['A']):.4f}" in printed


@functools.cache
def own_force() -> dict[str, Any]:
    """The names in that example."""
    return runpy.run_path(str(ROOT / "examples" / "own_force.py"))


@pytest.mark.slow
@pytest.mark.parametrize("A", [0.3, 0.5, 0.51, 0.9, 4.0])
def test_the_example_of_ones_own_force_averages_that_force(A: float) -> None:
    """h by quadrature of the pieces, the derivatives by differences of the next lower one."""
    example = own_force()
    inner, outer = (law.force for law in example["STOPS"].pieces)
    s, gap = 4.0, 0.5

    def integrand(psi: float) -> float:
        u = A * math.cos(psi)
        return (inner if abs(u) <= gap else outer)(u, s, gap) * math.cos(psi)

    edge = [math.acos(gap / A)] if A > gap else []
    expected = -4 / math.pi * quad(integrand, 0, math.pi / 2, points=edge, epsabs=1e-13)[0]
    found = example["averaged"](A, s, gap)
    assert found[0] == pytest.approx(expected, rel=1e-11)
    step = 1e-6 * A
    below, above = (example["averaged"](at, s, gap) for at in (A - step, A + step))
    for order in (0, 1, 2) if A != gap else ():
        assert (above[order] - below[order]) / (2 * step) == pytest.approx(found[order + 1], rel=1e-5, abs=1e-8)


def test_extras_stand_on_the_installation_page() -> None:
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    listed = re.findall(
        r"^\| `(\w+)` \|", (ROOT / "docs" / "howto" / "install.md").read_text(encoding="utf-8"), re.MULTILINE
    )
    assert set(listed) == set(extras) - {"paper", "explorer", "browser", "docs", "dev", "bench"}


def test_the_conda_recipe_asks_for_what_the_package_asks_for() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    recipe = (ROOT / "packaging" / "conda" / "recipe.yaml").read_text(encoding="utf-8")
    host, run = (re.search(rf"^  {part}:\n((?:    - .*\n)+)", recipe, re.MULTILINE) for part in ("host", "run"))
    assert host and run and f'version: "{slowflow.__version__}"' in recipe
    required = {line.removeprefix("    - ").replace(" ", "") for line in run[1].splitlines()}
    assert required == {*project["project"]["dependencies"], "python" + project["project"]["requires-python"]}
    required = {line.removeprefix("    - ").replace(" ", "") for line in host[1].splitlines()}
    assert required == {*project["build-system"]["requires"], "python", "pip"}
    # extras of those who do not derive, by the names that conda has for them; of two bounds the lower
    (bounds,) = re.findall(r"^  run_constraints:\n((?:    - .*\n)+)", recipe, re.MULTILINE)
    required = {line.removeprefix("    - ").replace(" ", "") for line in bounds.splitlines()}
    extras = project["project"]["optional-dependencies"]
    stated = sorted(
        one.lower() for extra in ("plot", "units", "proofs", "sizing", "tables", "grid") for one in extras[extra]
    )
    lowest = {re.split(r"\W*>=", one)[0].removesuffix("[array"): one.split(">=")[1] for one in reversed(stated)}
    names = {"matplotlib": "matplotlib-base", "dask": "dask-core"}
    assert required == {f"{names.get(name, name)}>={version}" for name, version in lowest.items()}


#: by page that answers what a newcomer types into the site's search, which wants all words
SEARCHED = {terms: page for page, all_of_it in stored("searches").items() for terms in all_of_it}


@pytest.mark.parametrize("terms", SEARCHED)
def test_the_words_of_a_newcomer_stand_on_the_page_that_answers(terms: str) -> None:
    text = (ROOT / "docs" / f"{SEARCHED[terms]}.md").read_text(encoding="utf-8").casefold()
    assert [word for word in terms.split() if word.casefold() not in text] == []


def test_codes_of_answers_are_explained_with_their_numbers() -> None:
    section = (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8").split("## Codes")[1]
    rows = [line.split("|")[1:-1] for line in section.splitlines() if re.match(r"\| \d", line)]
    explained = [(name, int(number)) for number, *cells in rows for name in re.findall(r"`([A-Z_]+)`", "".join(cells))]
    codes = [(one.name, one.value) for kind in (Status, Remark, FoldKind, OnsetKind) for one in kind]
    assert sorted(explained) == sorted(codes)


@pytest.mark.slow
def test_the_code_in_the_readme_runs() -> None:
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL)
    assert len(blocks) >= 2
    exec("\n".join(blocks), {})


def test_on_the_page_of_an_index_the_readme_has_no_path(monkeypatch: pytest.MonkeyPatch) -> None:
    setuptools = pytest.importorskip("setuptools")
    monkeypatch.setattr(setuptools, "setup", lambda **_: None)
    monkeypatch.chdir(ROOT)
    fitted = runpy.run_path("setup.py")["readme"]
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    paths = LINK.findall(text)
    assert sum(path.endswith(".png") for path in paths) >= 2
    without, there = fitted(text), fitted(text, "https://example.org/sources")
    assert not LINK.findall(without) and not LINK.findall(there) and "![" not in without
    for path in paths:
        kind = "raw" if path.endswith(".png") else "blob"
        assert f"](https://example.org/sources/{kind}/HEAD/{path})" in there
    # nothing else is touched
    assert re.sub(r"https://example.org/sources/(raw|blob)/HEAD/", "", there) == text


def test_addresses_of_the_metadata_follow_from_the_sources(monkeypatch: pytest.MonkeyPatch) -> None:
    setuptools = pytest.importorskip("setuptools")
    stated: dict[str, Any] = {}
    monkeypatch.setattr(setuptools, "setup", stated.update)
    monkeypatch.chdir(ROOT)
    build = runpy.run_path("setup.py")
    assert stated["project_urls"] == build["urls"](build["SOURCE"])
    (paper,) = build["urls"]().values()
    with_it = build["urls"]("https://example.org/sources")
    assert set(with_it) == {"Source", "Documentation", "Issues", "Changelog", "Paper"} and with_it.pop("Paper") == paper
    for address in with_it.values():
        path = address.removeprefix("https://example.org/sources").removeprefix("/blob/HEAD/")
        assert path in ("", "/issues") or (ROOT / path).exists(), address
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    repository = [build["SOURCE"]] if build["SOURCE"] else []
    assert re.findall(r"^repository-code: (.*)$", citation, re.MULTILINE) == repository
    assert f"doi: {paper.partition('org/')[2]}" in citation


def test_workflows_run_the_makefile_on_every_python_listed() -> None:
    workflows = [path.read_text(encoding="utf-8") for path in (ROOT / ".github" / "workflows").glob("*.yml")]
    targets = re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
    run = {target for text in workflows for target in re.findall(r"run: make ([\w-]+)", text)}
    assert {"test", "test-fast", "test-all", "check", "dist"} <= run <= set(targets)
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    versions = re.findall(r"Python :: (3\.\d+)", "\n".join(project["classifiers"]))
    (matrix,) = (found for text in workflows for found in re.findall(r"python: (\[.*\])", text))
    assert json.loads(matrix) == versions and f">={versions[0]}" == project["requires-python"]


#: docstrings of modules with code, and which of these need what deriving needs
DOCUMENTED = {"slowflow.derive": "sympy", "slowflow.support.progress": "", "slowflow.app.scenes": ""}


@pytest.mark.slow
def test_the_modules_with_code_in_their_docstrings_are_these() -> None:
    found = set()
    for path in (ROOT / "src" / "slowflow").rglob("*.py"):
        text = inspect.cleandoc(ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or "")
        if re.search(r"^    (import|from|with|\[)", text, re.MULTILINE):
            found.add(".".join(path.relative_to(ROOT / "src").with_suffix("").parts))
    assert found == set(DOCUMENTED)


@pytest.mark.parametrize("name", DOCUMENTED)
def test_the_code_in_a_docstring_runs(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    if DOCUMENTED[name]:
        pytest.importorskip(DOCUMENTED[name])
    docstring = inspect.getdoc(import_module(name)) or ""
    code = "\n".join(line[4:] for line in docstring.splitlines() if line.startswith("    ") or not line)
    if name != "slowflow.app.scenes":
        exec(code, {})
        return
    scene = tmp_path / "scene.toml"
    scene.write_text(code, encoding="utf-8")
    (tmp_path / "loop.csv").write_bytes((ROOT / "scenes" / "loop.csv").read_bytes())
    assert cli.main(["run", str(scene), "--quiet"]) == 0
    assert "# spectrum" in capsys.readouterr().out


def test_every_public_name_has_a_docstring() -> None:
    assert not [(path, name) for path, name, value in api.names() if not (inspect.getdoc(value) or "").strip()]


def test_every_public_name_has_an_example_and_no_other() -> None:
    stated = [(path, name) for path in api.MODULES for name in api.EXAMPLES.get(path, {}) if name != "begin"]
    assert sorted(stated) == sorted((path, name) for path, name, _ in api.names())


@pytest.mark.parametrize(
    "path",
    [pytest.param(path, marks=[pytest.mark.slow] if path in SLOW else []) for path in api.EXAMPLES if path != "begin"],
)
def test_examples_of_the_list_run(path: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An example of a class gives one, that of a function or a method names it; none warns."""
    for package in ("matplotlib", *EXAMPLES_NEED.get(path, ())):
        pytest.importorskip(package, reason=f"an extra is not installed: {package}")
    monkeypatch.chdir(tmp_path)
    Path("scene.toml").write_text(starters.STARTER, encoding="utf-8")
    examples = dict(api.EXAMPLES[path])
    begin = api.EXAMPLES["begin"] + examples.pop("begin", "")
    module = import_module(path)
    names = {name: getattr(module, name) for name in dir(module) if not name.startswith("_")}
    exec(begin, names)
    for name, code in examples.items():
        *before, last = ast.parse(code).body
        value, space = None, dict(names)
        exec(compile(ast.Module(before, []), name, "exec"), space)
        if isinstance(last, ast.Expr):
            value = eval(compile(ast.Expression(last.value), name, "eval"), space)
        else:
            exec(compile(ast.Module([last], []), name, "exec"), space)
        kind = getattr(module, name, None)
        if inspect.isclass(kind) and not issubclass(kind, Exception) and not getattr(kind, "_is_protocol", False):
            assert isinstance(value, kind), name
        elif "." in name:
            assert f".{name.partition('.')[2]}" in code, name
        elif inspect.isfunction(kind):
            assert f"{name}(" in code, name


def test_the_list_of_kernels_is_what_mechanisms_have() -> None:
    page = (ROOT / "docs" / "kernels.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (`.*?) \| .* \|$", page, re.MULTILINE)
    listed = {found for row in rows for found in re.findall(r"`([A-Za-z_0-9]+)(?:\([^`]*\))?`", row)}
    has = set()
    for path in (ROOT / "derivations" / "mechanisms").glob("[!_]*.py"):
        has |= set(import_module(f"slowflow_kernels.{path.stem}").__all__)
    assert listed == has - {"force_2_u"}


def test_each_section_of_the_gallery_has_a_picture() -> None:
    page = ROOT / "docs" / "gallery.md"
    sections = page.read_text(encoding="utf-8").split("\n## ")[1:]
    assert len(sections) >= 6
    for section in sections:
        (picture,) = re.findall(r"!\[[^\]]+\]\(([^)]+)\)", section)
        assert (page.parent / picture).stat().st_size > 5000


def test_decisions_have_date_status_reason_and_cost() -> None:
    index = (DECISIONS / "README.md").read_text(encoding="utf-8")
    pages = [page for page in sorted(DECISIONS.glob("*.md")) if page.name != "README.md"]
    records = []
    for page in pages:
        title, *found = page.read_text(encoding="utf-8").split("\n## ")
        assert f"- [{title.splitlines()[0].removeprefix('# ')}]({page.name})" in index
        records += found
    status = r"\d{4}-\d\d-\d\d, (in force|(changed|replaced) \d{4}-\d\d-\d\d|replaces [^.]*)\. "
    for record in records:
        name, _, text = record.partition("\n\n")
        assert re.match(status, text) and "**Why**: " in text and "**Cost**: " in text, name
    assert index.count("\n- [") == len(pages) == 6 and len(records) <= 30


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_links_lead_somewhere(page: Path) -> None:
    targets = LINK.findall(page.read_text(encoding="utf-8"))
    assert not [target for target in targets if not (page.parent / target).exists()]


def headings(page: Path) -> set[str]:
    """What a page's headings are called in addresses."""
    text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    found = re.findall(r"^#{1,3} (.*?) *$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", re.sub(r"[`*]", "", one)).lower().replace(" ", "-") for one in found}


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_links_into_a_page_lead_to_a_heading(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    for target, anchor in re.findall(r"\]\((?!\w+:)([^)#]*)#([^)]+)\)", text):
        assert anchor in headings(page.parent / target if target else page), f"{target}#{anchor}"


def test_files_that_pages_name_exist() -> None:
    """But those of which a page has the text, and what a user writes."""
    names = ("benchmarks", "derivations", "docs", "explorer", "generated", "scenes", "src", "tests")
    folders = (ROOT / name for name in names)
    here = {path.as_posix() for folder in folders for path in folder.rglob("*.*")} | {"/scene.toml"}
    here |= {path.as_posix() for path in ROOT.glob("*.*")}
    for page in (one for one in PAGES if "_made" not in one.parts):
        text = page.read_text(encoding="utf-8")
        named = re.findall(r"`([\w./-]+\.(?:py|h|c|md|toml|json|js))`(?!:\n)", text)
        named += [name for line in re.findall(r"pytest ((?:tests/\S+\.py ?)+)", text) for name in line.split()]
        shown = re.findall(r"^`([\w.]+)`:$", text, re.MULTILINE)
        missing = {name for name in named if not any(path.endswith(f"/{name}") for path in here)}
        assert missing <= set(shown), page


def test_addresses_on_the_web_are_whole() -> None:
    """Whether somebody answers there `make links` asks, which needs a network."""
    texts = [path.read_text(encoding="utf-8") for path in (*PAGES, ROOT / "pyproject.toml", ROOT / "CITATION.cff")]
    found = {address for text in texts for address in re.findall(r"\bhttps?:[^\s\"'<>`]*", text)}
    # brackets and full stops of the sentence around it
    found = {re.sub(r"[).,;:\]}]+$", "", address) for address in found}
    assert len(found) >= 2
    for address in found:
        address_parts = urlsplit(address)
        assert address_parts.scheme == "https" and re.fullmatch(
            r"([a-z0-9-]+\.)+[a-z]{2,}", address_parts.hostname or ""
        ), address
    stated = re.findall(r"\bdoi\.org/(\S+?)[)\s\"]", "\n".join(texts))
    assert stated and all(re.fullmatch(r"10\.\d{4,9}/[\w.()/-]+", one) for one in stated)


def test_fields_of_a_named_tuple_are_not_said_by_their_number() -> None:
    assert docstrings.unsaid(None, "class", "State.A", SteadyStates.entry.A, False, None) is True
    assert docstrings.unsaid(None, "class", "Isolator.peak", Averaged.peak, False, None) is None


@pytest.mark.slow
def test_letters_of_the_site_have_subscripts_but_not_in_code(browser: Any) -> None:
    script = (ROOT / "docs" / "site" / "static" / "site.js").read_text(encoding="utf-8")
    sentence = "k_v L, u_cr and Delta_h, F_SN; saddle_nodes, x_1y, iso.F_0, <code>F_0</code>"
    page = f"<title>Search - slowflow</title><article><p>{sentence}</p></article><script>{script}</script>"
    tab = browser.new_page()
    tab.set_content(page)
    shown, title = tab.inner_html("p"), tab.inner_text("h1")
    tab.close()
    set_ = "k<sub>v</sub> L, u<sub>cr</sub> and Δ<sub>h</sub>, F<sub>SN</sub>"
    assert shown == f"{set_}; saddle_nodes, x_1y, iso.F_0, <code>F_0</code>"
    assert title == "Search"
