"""The worst points as tests: measured results in, tests/data/stability.json out, which the tests replay.

Kernels keep their points with exact values as `kernel_oracle.json` does; roots and answers keep points, exact values
and conditions; counts keep wrong cases with the proved number, and whether the answer says that it is undecided. Beside
each stands the error measured: it may not grow.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

OUT = Path(__file__).resolve().parents[2] / "tests" / "data" / "stability.json"
#: wrong counts kept of each mechanism and kind
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
            {
                "mechanism": c["mechanism"],
                "kind": kind,
                "at": at,
                "found": number,
                "proved": proved,
                "said": name != "wrong",
            }
            for c in found["counts"]
            for kind in ("states", "folds")
            for name in ("wrong", "wrong, said")
            for at, number, proved, *_ in c[kind][name][:CASES]
        ],
    }


def write(found: dict[str, Any]) -> None:
    """Write the baseline."""
    save(OUT, of(found))


def save(path: Path, content: dict[str, Any]) -> None:
    """JSON, each row of a list on a line of its own."""
    parts = []
    for name, value in content.items():
        text = json.dumps(value, ensure_ascii=False)
        if isinstance(value, list):
            text = "[\n" + ",\n".join("  " + json.dumps(row, ensure_ascii=False) for row in value) + "\n ]"
        parts.append(f' "{name}": {text}')
    path.write_text("{\n" + ",\n".join(parts) + "\n}\n", encoding="utf-8")
