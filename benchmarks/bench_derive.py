"""What a force of one's own costs: deriving it, compiling it, and its first and its later answers, each in a process.

    python -m benchmarks.bench_derive

Out: a table on the terminal, benchmarks/results/derive.json, docs/benchmarks.md. The clock is the processor's, children
included; `start` is Python with NumPy, SymPy and slowflow.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from typing import Any

from benchmarks import document, environment

NUMBERS = {"k": 3.0, "c": 0.6, "gap": 0.2, "further": 0.1}
#: name, and whether it is compiled
CASES = (
    ("stop", False),
    ("stop", True),
    ("two_stops", False),
    ("septic", False),
    ("soft_stop", False),
    ("soft_stop", True),
)


def pieces(name: str) -> list[tuple[Any, Any]]:
    """Of the forces that are derived."""
    import sympy as sp

    u, k, c, gap, further = sp.symbols("u k c gap further")
    stopped = u + k * (u - gap)
    return {
        "stop": [(u, gap), (stopped, None)],
        "two_stops": [(u, gap), (stopped, gap + further), (stopped + c * (u - gap - further), None)],
        "septic": [(u - k * u**3 + c * u**5 + u**7, None)],
        "soft_stop": [(u, gap), (u + c * sp.tanh(k * (u - gap)), None)],
    }[name]


def clock() -> float:
    """Seconds of processor time, of this process and of the compilers that it called."""
    import resource  # os.times counts by hundredths

    both = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(used.ru_utime + used.ru_stime for used in both)


def one(name: str, compiled: bool) -> dict[str, float]:
    """Seconds of each step, in a process that has done nothing else."""
    from slowflow import derive

    force = pieces(name)
    used = {str(symbol) for piece in force for part in piece if part is not None for symbol in part.free_symbols}
    names = [number for number in NUMBERS if number in used]
    start = clock()
    made = derive.mechanism(name, force, {number: {"above": 0} for number in names}, compile=compiled)
    derived = clock()
    mount = made(**{number: NUMBERS[number] for number in names}, mu=0.01, zeta=0.03)
    mount.saddle_nodes(0.1)
    answered = clock()
    times = []
    for F_0 in (0.11, 0.12, 0.13):
        before = clock()
        mount.frequency_response(F_0)
        times.append(clock() - before)
    return {"start": start, "derive": derived - start, "first folds": answered - derived, "curve": min(times)}


def in_a_process(name: str, compiled: bool, bytecode: str) -> dict[str, float]:
    """`one` in an empty folder, and with bytecode of modules in another."""
    with tempfile.TemporaryDirectory() as folder:
        # whatever the environment says: a user's modules were compiled when they were installed
        kept = {"PYTHONPYCACHEPREFIX": bytecode, "PYTHONDONTWRITEBYTECODE": "", "SLOWFLOW_DERIVED": folder}
        command = [sys.executable, "-m", "benchmarks.bench_derive", "--one", name, str(int(compiled))]
        done = subprocess.run(command, capture_output=True, text=True, check=True, env={**os.environ, **kept})
    return json.loads(done.stdout)


def rows() -> list[dict[str, Any]]:
    """One row for each case, by its second run: the first leaves bytecode."""
    found = []
    with tempfile.TemporaryDirectory() as bytecode:
        for name, compiled in CASES:
            _, measured = (in_a_process(name, compiled, bytecode) for _ in range(2))
            found.append({"force": name, "how": "compiled" if compiled else "NumPy", **measured})
    return found


def main() -> None:
    """Measure, print, write."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--busy", action="store_true", help="say on the page that other work kept the machine busy")
    parser.add_argument("--one", nargs=2, metavar=("FORCE", "COMPILED"), help="one force, in this process, as JSON")
    options = parser.parse_args()
    if options.one:
        print(json.dumps(one(options.one[0], bool(int(options.one[1])))))
        return
    found = rows()
    print("\n".join(document.derive_table(found)))
    busy = {"earlier": document.BUSY} if options.busy else {}
    conditions = {"environment": environment.describe(), "bytecode": True, **busy}
    document.save(document.RESULTS / "derive.json", {**conditions, "rows": found})
    document.write()


if __name__ == "__main__":
    main()
