"""Peers on the same problem in one run, each in an environment of its own; a peer that fails is a row with the reason.

In:  the adapters of this folder, and pip. Out: rows.
All that run are asked in turn in every round, so that medians and ratios come from the same minutes.
"""

from __future__ import annotations

import importlib
import json
import re
import shutil
import subprocess
import sys
import tempfile
import venv
from typing import Any

from benchmarks import certified
from benchmarks.document import with_earlier
from benchmarks.remote import ROOT, Failure, Remote, in_turn

ENVIRONMENTS = ROOT / ".venv-peers"
PEERS = ("slowflow", "numba", "bifpy", "scipy", "pyharm", "mousai", "oscilate", "pydstool", "skhippr")
#: the longest that an installation may take, in seconds
PATIENCE = 900
#: a fold is found if its Omega is right to this part
FOUND = 0.01


def plain(text: str) -> str:
    """The telling line of an error, without folders and addresses."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    telling = [line for line in lines if re.match(r"(ERROR|error|\w*Error)\b", line)] or lines or ["no message"]
    return re.sub(r"\s*\(?(\w+://|/)[\w./+:-]{3,}\)?", "", telling[-1])[:300]


def interpreter(name: str, packages: tuple[str, ...]) -> str:
    """The Python of a peer's environment, its packages installed; slowflow has none and runs in the present one."""
    if not packages:
        return sys.executable
    python = ENVIRONMENTS / name / "bin" / "python"
    if not python.exists():
        venv.create(ENVIRONMENTS / name, with_pip=True)
    command = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *packages]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        raise Failure(f"does not install within {PATIENCE} s") from None
    if done.returncode:
        raise Failure(f"does not install: {plain(done.stderr)}")
    return str(python)


def versions(python: str, packages: tuple[str, ...]) -> dict[str, str]:
    """What is installed there of these packages."""
    names = [re.split(r"[<>=]", package)[0] for package in packages]
    code = "import importlib.metadata as m, json, sys; print(json.dumps({n: m.version(n) for n in sys.argv[1:]}))"
    done = subprocess.run([python, "-c", code, *names], capture_output=True, text=True, check=True)
    return dict(json.loads(done.stdout))


def judged(folds: list[list[float]]) -> tuple[int, float | None]:
    """How many of the certified folds were found, and the largest relative error of their Omega."""
    errors = []
    for Omega, _ in certified.folds():
        nearest = min((certified.relative_error(found[0], Omega) for found in folds), default=1.0)
        errors += [nearest] if nearest < FOUND else []
    return len(errors), max(errors, default=None)


def measure(rounds: int, before: dict[str, Any]) -> list[dict[str, Any]]:
    """One row for each variant of each peer, or for each peer that does not take part, with the reason.

    before: what was measured last, which is kept of a peer that cannot be run.
    """
    rows: dict[str, dict[str, Any]] = {}
    jobs: dict[str, tuple[Remote, str]] = {}
    with tempfile.TemporaryDirectory() as home:
        for name in PEERS:
            adapter = importlib.import_module(f"benchmarks.peers.{name}")
            row = {"peer": adapter.NAME, "what": adapter.WHAT}
            print(f"{adapter.NAME} ...", file=sys.stderr, flush=True)
            try:
                for program in getattr(adapter, "PROGRAMS", ()):
                    if shutil.which(program) is None:
                        raise Failure(f"does not install: there is no {program}")
                python = interpreter(name, adapter.PACKAGES)
                row["versions"] = versions(python, adapter.PACKAGES)
                # some peers write settings into the home folder
                remote = Remote(f"benchmarks.peers.{name}", python, HOME=home)
            except Failure as failure:
                rows[adapter.NAME] = {**row, "failure": plain(str(failure))}
                continue
            for variant in remote.jobs:
                rows[f"{adapter.NAME}, {variant}"] = {**row, "variant": variant}
                jobs[f"{adapter.NAME}, {variant}"] = remote, variant
        answers, failures = in_turn(jobs, rounds)
        for remote, _ in jobs.values():
            remote.stop()
    for key, failure in failures.items():
        rows[key]["failure"] = plain(failure)
    for key, answer in answers.items():
        found, error = judged(answer["folds"])
        rows[key] |= {
            "seconds": answer["seconds"],
            "points": answer["points"],
            "folds_found": found,
            "folds_reported": len(answer["folds"]),
            "fold_error": error,
        }
    ours = [row["seconds"] for row in rows.values() if row["peer"] == "slowflow" and "seconds" in row]
    for row in rows.values():
        if ours and "seconds" in row:
            row["ratio"] = row["seconds"] / ours[-1]
    where = before.get("environment", {}).get("processor")
    return with_earlier(list(rows.values()), before.get("rows", []), "peer", where)
