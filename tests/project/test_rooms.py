"""The rooms of src/slowflow and of derivations: imports run one way, down, and what is heavy is not imported below."""

import ast
import functools
import graphlib
import re
import tomllib

import pytest

from tests.files import ROOT

SOURCE = ROOT / "src"
#: from the top floor down; a room imports only from floors below its own, or from itself
FLOORS = (
    ("__main__",),
    ("app",),
    ("sizing", "__init__", "example", "derive", "languages"),
    ("oscillators",),
    ("grid",),
    ("off_centre",),
    ("random_vibration",),
    ("exact", "second"),
    ("averaged",),
    ("answers",),
    ("core", "sampled", "derived"),
    ("support", "version"),
)
FLOOR = {room: number for number, rooms in enumerate(reversed(FLOORS)) for room in rooms}
#: the same of the derivation: the paper needs mechanisms and symbols, and nothing that comes after it
DERIVING = (
    ("__main__",),
    ("walkthrough",),
    ("ledger", "runtime"),
    ("document",),
    ("page",),
    ("codegen",),
    ("results", "library"),
    ("asymmetric",),
    ("extensions",),
    ("systems", "forces"),
    ("paper",),
    ("mechanisms",),
    ("claims",),
    ("symbols", "vanishing", "given", "kernels", "__init__"),
)
DERIVATION = SOURCE.parent / "derivations"
FILES = sorted((SOURCE / "slowflow").rglob("*.py"))


def room_of(path):
    return path.relative_to(SOURCE / "slowflow").with_suffix("").parts[0]


def name_of(path):
    """Of a module."""
    return ".".join(path.relative_to(SOURCE).with_suffix("").parts).removesuffix(".__init__")


@functools.cache
def imported(path):
    """Every module that a file imports, at its top or inside a function, type checking included."""
    found = []
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found += [name.name for name in node.names]
        elif isinstance(node, ast.ImportFrom):
            found += [f"{node.module}.{name.name}" for name in node.names]
    return found


@pytest.mark.slow
@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(SOURCE)))
def test_imports_run_down(path):
    here = room_of(path)
    for module in imported(path):
        package, _, rest = module.partition(".")
        if package == "slowflow" and rest:
            # a name of the package itself, such as __version__, is its face's
            room = rest.split(".")[0] if rest.split(".")[0] in FLOOR else "__init__"
            assert room == here or FLOOR[room] < FLOOR[here], f"{path.name} imports {module}"


@pytest.mark.slow
@pytest.mark.parametrize("path", sorted(DERIVATION.rglob("*.py")), ids=lambda path: str(path.relative_to(DERIVATION)))
def test_the_derivation_needs_only_what_comes_before(path):
    """At the top of a file, inside a function, or for types alone."""
    floor = {room: number for number, rooms in enumerate(reversed(DERIVING)) for room in rooms}
    folders = path.relative_to(DERIVATION).parts
    here = folders[0].removesuffix(".py")
    found = [node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, ast.ImportFrom)]
    for node in found:
        if node.level == len(folders):  # of the package itself
            rooms = [node.module.split(".")[0]] if node.module else [name.name for name in node.names]
            assert all(room == here or floor[room] < floor[here] for room in rooms), f"{path.name}: {ast.unparse(node)}"


def test_no_import_goes_round():
    """Not within a room either, nor by what is imported for types only."""
    names = {name_of(path): path for path in FILES}
    arrows = {}
    for name, path in names.items():
        rooms = {module if module in names else module.rpartition(".")[0] for module in imported(path)}
        arrows[name] = rooms & set(names) - {name}
    assert sum(map(len, arrows.values())) > len(FILES)
    graphlib.TopologicalSorter(arrows).prepare()  # names a circle, if there is one


def test_what_derives_is_not_imported_by_what_runs():
    """Not even by `slowflow.derive`, the door that a program opens by asking; FLINT is imported by proofs in balls."""
    heavy = {"sympy", "jinja2", "derivations"}
    for path in FILES:
        in_balls = "balls" in (path.stem, path.parent.name)
        for module in imported(path):
            assert module.split(".")[0] not in (heavy if in_balls else {*heavy, "flint"}), f"{path.name}: {module}"
            assert not module.startswith("slowflow.derivation"), f"{path.name}: {module}"
        lazily = path.name == "proofs.py" or in_balls
        assert lazily or not [module for module in imported(path) if ".balls" in module], path.name


def test_foundations_of_the_kernels_import_only_tables():
    """Numbers that C has too, from modules that import nothing themselves."""
    for path in (SOURCE / "slowflow" / "support").glob("*.py"):
        ours = [m for m in imported(path) if m.startswith(("slowflow.", "slowflow_kernels."))]
        allowed = ("slowflow.support.", "slowflow_kernels.quadrature_conventions")
        assert all(m.startswith(allowed) for m in ours), path.name
    tables = SOURCE.parent / "generated" / "slowflow_kernels" / "quadrature_conventions.py"
    assert not [m for m in imported(tables) if m.partition(".")[0] not in {"enum"}]


def test_wheel_has_every_package_and_template_but_the_ledger():
    """Without a room it imports until somebody asks for what is in it. The ledger is proved where it is written."""
    stated = tomllib.loads((SOURCE.parent / "pyproject.toml").read_text())["tool"]["setuptools"]
    for name, folder in stated["package-dir"].items():
        for init in (SOURCE.parent / folder).rglob("__init__.py"):
            folders = init.parent.relative_to(SOURCE.parent / folder).parts
            package = ".".join((name, *folders))
            assert package in stated["packages"] or "ledger" in folders, package
            if (init.parent / "templates").is_dir():
                assert stated["package-data"][package] == ["templates/*.jinja"], package


def test_names_of_tests_have_at_most_60_characters():
    texts = (path.read_text() for path in (ROOT / "tests").rglob("test_*.py"))
    assert not [name for text in texts for name in re.findall(r"def (test_\w{56,})\(", text)]
