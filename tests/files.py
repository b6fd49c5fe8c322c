"""Where the project's files are, and the reference values that `tests/data` stores."""

from __future__ import annotations

import functools
import importlib
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
DATA = ROOT / "tests" / "data"
#: data sheet of the README's mount, sized by hand: three springs of 1700 N/m on rods of 80 mm
MOUNT = {"m": 12, "k_v": 2500, "k_h": 1700, "n": 3, "L": 0.080, "preload": 0.009, "friction": 0.4, "zeta": 0.02}


@functools.cache
def stored(name: str) -> Any:
    """The values of a file of `tests/data`, read once."""
    return json.loads((DATA / f"{name}.json").read_text(encoding="utf-8"))


def store(name: str, cases: Sequence[Any]) -> None:
    """Write one case to a line of a file of `tests/data`, and print how many there are."""
    lines = ",\n".join(json.dumps(case, separators=(",", ":")) for case in cases)
    (DATA / f"{name}.json").write_text(f"[\n{lines}\n]\n", encoding="utf-8")
    print(f"{name}: {len(cases)} cases")


def scene(folder: Path, **tables: Mapping[str, Any]) -> Path:
    """A scene of these tables, in a file of that folder."""
    path, text = folder / "scene.toml", ""
    for table, content in tables.items():
        text += "\n".join([f"[{table}]", *(f"{name} = {value!r}" for name, value in content.items()), ""])
    path.write_text(text, encoding="utf-8")
    return path


class Lazily:
    """A module that is imported when something of it is used first: collecting tests does without."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, attribute: str) -> Any:
        if attribute.startswith("_"):  # pytest looks for what marks a test or a wrapper in all that a file names
            raise AttributeError(attribute)
        return getattr(importlib.import_module(self._name), attribute)
