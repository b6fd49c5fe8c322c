"""Files on disk: write what is generated, delete what is stale, compare with what is there.

In:  a dict from file name to text.
Out: files in a folder, or the differences as unified diffs.
"""

from __future__ import annotations

import difflib
import json
import textwrap
from pathlib import Path
from typing import TYPE_CHECKING

from .provenance import digest, versions

if TYPE_CHECKING:
    from ..paper.critical_forcings import Elimination
    from ..results import Results

MANIFEST = "MANIFEST.json"
COMMAND = "make derive"
COMPILED = (".so", ".pyd")


def manifest(files: dict[str, str], results: Results) -> str:
    """The manifest's text: what the files were made from, and their names. What is in each says its history."""
    here = Path(__file__).parents[1]
    content = {
        "command": COMMAND,
        "versions": versions(),
        "mechanisms": {
            name: {"file": f"derivations/mechanisms/{name}.py", "sha256": digest(here / "mechanisms" / f"{name}.py")}
            for name in results.mechanisms
        },
        "resultants": {
            **{
                f"detachment_{scene}".removesuffix("_"): facts(found.resultant)
                for scene, found in results.detachment.items()
            },
            **{
                f"{name} {which}": facts(getattr(derived, which))
                for name, derived in results.mechanisms.items()
                if derived.saddle_nodes
                for which in ("saddle_node_onset", "saddle_nodes")
            },
        },
        "files": sorted(files),
    }
    return as_json(content)


def as_json(content: dict[str, object]) -> str:
    """JSON with a line for each entry of what is in it."""
    entries = []
    for name, value in content.items():
        inner = (
            {key: json.dumps(entry, ensure_ascii=False) for key, entry in value.items()}
            if isinstance(value, dict)
            else {}
        )
        lines = ",\n".join(f"  {json.dumps(key)}: {entry}" for key, entry in inner.items())
        text = (
            f"{{\n{lines}\n }}"
            if inner
            else textwrap.fill(json.dumps(value), 116, subsequent_indent="  ", break_long_words=False)
        )
        entries.append(f" {json.dumps(name)}: {text}")
    return "{\n" + ",\n".join(entries) + "\n}\n"


def facts(elimination: Elimination) -> dict[str, object]:
    """Degree, vanishing powers, content and factors of a resultant."""
    degree = elimination.degree
    return {
        "unknown": elimination.unknown.name,
        "degree": degree,
        "degree reduced": max(elimination.reduced),
        "vanishing powers": [power for power in range(degree + 1) if power not in elimination.coefficients],
        "content": str(elimination.content),
        "factors": [{"factor": str(factor), "multiplicity": count} for factor, count in elimination.factors],
    }


def on_disk(folder: Path) -> dict[str, str]:
    """Every file of a generated folder by name; caches of the interpreter and compiled extensions are none of ours."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes().decode(errors="replace")
        for path in sorted(folder.rglob("*"))
        if path.is_file() and "__pycache__" not in path.parts and path.suffix not in COMPILED
    }


def write(files: dict[str, str], folder: Path) -> None:
    """Write the files, and delete those that an earlier run wrote (its manifest says so) and this one does not."""
    earlier = folder / MANIFEST
    for name in json.loads(earlier.read_text())["files"] if earlier.exists() else ():
        if name not in files:
            (folder / name).unlink(missing_ok=True)
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_bytes() != text.encode():
            path.write_bytes(text.encode())


def differences(expected: dict[str, str], found: dict[str, str], folder: str) -> list[str]:
    """First the set of files, then the text of each."""
    report = [f"missing: {folder}/{name}\n" for name in sorted(expected.keys() - found.keys())]
    report += [f"stale: {folder}/{name}\n" for name in sorted(found.keys() - expected.keys())]
    for name in sorted(expected.keys() & found.keys()):
        report += difflib.unified_diff(
            found[name].splitlines(keepends=True),
            expected[name].splitlines(keepends=True),
            f"{folder}/{name}",
            f"regenerated/{name}",
        )
    return report
