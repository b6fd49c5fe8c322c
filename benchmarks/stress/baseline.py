"""The worst points as tests: measured results in, benchmarks/results/worst_points.json out, which the tests replay.

Kernels keep their points with exact values as `kernel_oracle.json` does; roots and answers keep points, exact values
and conditions; beside each stands the error measured: it may not grow. Counts keep the cases next to a level whose
number was right, by doubles or by balls, with the proved number, and those that doubles had wrong without a word.
`make derive` states the errors in the headers of kernels, with the boxes in which they were searched for.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from benchmarks.document import RESULTS
from benchmarks.stress import domains

OUT = RESULTS / "worst_points.json"
#: wrong counts kept of each mechanism and kind of each share
CASES = 20


def of(found: dict[str, Any]) -> dict[str, list[dict[str, Any]]]:
    """What is kept."""
    return {
        "kernels": [
            {"module": k["module"], "kernel": k["kernel"], **row} for k in found["kernels"] for row in k["rows"]
        ],
        "roots": [{"kind": r["kind"], "at": w["at"], "error": w["error"]} for r in found["roots"] for w in r["worst"]],
        "answers": [
            {"mechanism": a["mechanism"], "kind": a["kind"], "at": w["at"], "error": w["error"]}
            for group in found["answers"]
            for a in group
            for w in a["worst"]
        ],
        "counts": [
            {"mechanism": c["mechanism"], "kind": kind, "by": by, "at": at, "proved": number}
            for c in found["counts"]
            for kind in ("states", "folds")
            for by, at, number in (
                *((by, at, number) for _, by, at, number in c[kind]["hard"]),
                *(("nothing", at, number) for at, _, number, *_ in c[kind]["wrong"][:CASES]),
            )
        ],
        "boxes": [
            {"module": module, "where": domains.in_words(module, sorted(names))}
            for module, names in arguments(found["kernels"]).items()
        ],
    }


def arguments(kernels: list[dict[str, Any]]) -> dict[str, set[str]]:
    """The names that the kernels of each module take."""
    names: dict[str, set[str]] = {}
    for k in kernels:
        names.setdefault(k["module"], set()).update(k["names"])
    return names


def stored() -> dict[str, list[dict[str, Any]]]:
    """The baseline as it stands."""
    kept: dict[str, list[dict[str, Any]]] = json.loads(OUT.read_text(encoding="utf-8"))
    return kept


def write(found: dict[str, Any]) -> None:
    """Write the baseline."""
    save(OUT, of(found))


def save(path: Path, content: dict[str, Any]) -> None:
    """JSON, each row of a list on a line of its own."""
    entries = []
    for name, value in content.items():
        text = json.dumps(value, ensure_ascii=False)
        if isinstance(value, list):
            text = "[\n" + ",\n".join("  " + json.dumps(row, ensure_ascii=False) for row in value) + "\n ]"
        entries.append(f' "{name}": {text}')
    path.write_text("{\n" + ",\n".join(entries) + "\n}\n", encoding="utf-8")
