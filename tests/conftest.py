"""What several tests share, also across the workers of pytest-xdist: what is made once, and the generated C.

Profiles of Hypothesis: "push" draws the same few examples every time; "all", of `make test-all`, draws more, others in
each run, and prints the seed that --hypothesis-seed repeats it by.
"""

from __future__ import annotations

import gc
import importlib.util
import os
import secrets
import shutil
import sys
import tempfile
from collections.abc import Callable, Generator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from filelock import FileLock
from hypothesis import settings

import slowflow.derive
from tests import sampling
from tests.native import headers
from tests.sampling import part

if TYPE_CHECKING:
    from derivations.codegen.form import Module
    from derivations.codegen.views import Code
    from derivations.results import Results

# what is derived in tests and examples: once for all workers, which have it from the process that starts them
if "PYTEST_XDIST_WORKER" not in os.environ:
    os.environ["SLOWFLOW_DERIVED"] = tempfile.mkdtemp(prefix="slowflow-derived-")

# figures are drawn, none is shown
os.environ.setdefault("MPLBACKEND", "Agg")

settings.register_profile("push", deadline=None, derandomize=True)
settings.register_profile("all", deadline=None, derandomize=False, print_blob=True)
settings.load_profile("all" if sampling.ALL else "push")

if not sampling.ALL:
    # a third of the time for each force that is compiled, and the same bits; `make test-all` compiles as users do
    slowflow.derive.FLAGS = tuple("-O0" if flag == "-O2" else flag for flag in slowflow.derive.FLAGS)

Once = Callable[[str, Callable[[Path], object]], Path]


@pytest.hookimpl(tryfirst=True)
def pytest_configure(config: pytest.Config) -> None:
    """One fresh seed for all workers, before Hypothesis reads the option."""
    if sampling.ALL and config.getoption("--hypothesis-seed") is None:
        config.option.hypothesis_seed = str(secrets.randbits(32))


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    """What repeats the part that was run, or the seed of a run of all."""
    seed = f"--hypothesis-seed={config.getoption('--hypothesis-seed')}"
    turn = f"part of the cases: SLOWFLOW_TESTS={sampling.TURN} repeats it, SLOWFLOW_TESTS=all runs all"
    terminalreporter.write_line(f"again: {seed}" if sampling.ALL else turn)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """A fifth of the time went into searching for garbage among modules and items, which stay to the end.

    Then a search follows after more new objects than by default: trees and expressions are made by the thousand.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.enable()
        gc.freeze()
        gc.set_threshold(50_000)


def pytest_itemcollected(item: pytest.Item) -> None:
    """What asks for the derivation is slow."""
    if "results" in getattr(item, "fixturenames", ()):
        item.add_marker(pytest.mark.slow)


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Of cases marked `part` one in so many, of each family that the mark names.

    Files that ask for the derivation come first: one worker has all of them, and derives for all of them.
    """
    cases: dict[tuple[str, int, *tuple[str, ...]], list[pytest.Item]] = {}
    for item in items:
        if (marked := item.get_closest_marker("part")) is not None:
            cases.setdefault((item.nodeid.partition("[")[0], *marked.args), []).append(item)
    kept = {item for (name, of, *more), every in cases.items() for item in part(every, of, " ".join((name, *more)))}
    left_out = {item for every in cases.values() for item in every if item not in kept}
    items[:] = [item for item in items if item not in left_out]
    derive = {item.path for item in items if "results" in getattr(item, "fixturenames", ())}
    items.sort(key=lambda item: item.path not in derive)


def pytest_runtest_teardown() -> None:
    """pyplot keeps what it has made, and warns of it after twenty."""
    if "matplotlib.pyplot" in sys.modules:
        sys.modules["matplotlib.pyplot"].close("all")


@pytest.fixture(scope="session")
def once(tmp_path_factory: pytest.TempPathFactory) -> Once:
    """once(name, fill): a folder that `fill` was called with, by the first worker that asked; the others waited for it.

    For what takes long and can be kept in files: every worker of pytest-xdist is a process of its own.
    """
    base = tmp_path_factory.getbasetemp()
    shared = base.parent if "PYTEST_XDIST_WORKER" in os.environ else base

    def once(name: str, fill: Callable[[Path], object]) -> Path:
        folder, filled = shared / name, shared / f"{name}.filled"
        with FileLock(shared / f"{name}.lock"):
            if not filled.exists():
                folder.mkdir(exist_ok=True)
                fill(folder)
                filled.touch()
        return folder

    return once


@pytest.fixture(scope="module")
def browser() -> Generator[Any, None, None]:
    """Chromium, once for all tests of a file: while it runs no other event loop can."""
    chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if chromium is None or importlib.util.find_spec("playwright") is None:
        pytest.skip("no Chromium or no Playwright (slowflow[browser]) here: nothing is tried in a browser")
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        yield opened
        opened.close()


@pytest.fixture(scope="session")
def results() -> Results:
    """What the derivation gives: expressions, which are not kept in files, so once for each worker."""
    from derivations.results import derive

    return derive()


@pytest.fixture(scope="session")
def modules(results: Results) -> list[Module]:
    """Modules of kernels as the derivation states them."""
    from derivations.codegen.catalogue.every_module import all_modules

    return all_modules(results)


@pytest.fixture(scope="session")
def code(modules: list[Module]) -> dict[str, Code]:
    """The programs of each kernel, by module and kernel."""
    from derivations.codegen.views import programs

    return {module.name: programs(module) for module in modules}


@pytest.fixture(scope="session")
def c_kernels(once: Once) -> Callable[..., np.ndarray]:
    """The functions of the generated C headers, by name."""
    if headers.COMPILER is None:
        pytest.skip("no C compiler (cc) on the path: the C headers are not tried")
    return headers.load(once("headers", headers.build))
