"""What a custom force costs: deriving it, compiling it, and its first and its later answers, each in a process.

The clock is the processor's, children included; `start` is Python with NumPy, SymPy and slowflow.
"""

from __future__ import annotations

import tempfile
from typing import Any

from benchmarks.remote import fresh, processor

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


def one(name: str, compiled: bool) -> dict[str, float]:
    """Seconds of each step, in a process that has done nothing else."""
    from slowflow import derive

    force = pieces(name)
    used = {str(symbol) for piece in force for part in piece if part is not None for symbol in part.free_symbols}
    names = [number for number in NUMBERS if number in used]
    start = processor()
    made = derive.mechanism(name, force, {number: {"above": 0} for number in names}, compile=compiled)
    derived = processor()
    mount = made(**{number: NUMBERS[number] for number in names}, mu=0.01, zeta=0.03)
    mount.saddle_nodes(0.1)
    answered = processor()
    times = []
    for F_0 in (0.11, 0.12, 0.13):
        before = processor()
        mount.frequency_response(F_0)
        times.append(processor() - before)
    return {"start": start, "derive": derived - start, "first folds": answered - derived, "curve": min(times)}


def measure() -> list[dict[str, Any]]:
    """One row for each case, in an empty folder, by its second run: the first leaves bytecode of modules in another."""
    found = []
    with tempfile.TemporaryDirectory() as bytecode:
        for name, compiled in CASES:
            code = f"import json\nfrom benchmarks.bench_derive import one\nprint(json.dumps(one({name!r}, {compiled})))"
            for _ in range(2):
                with tempfile.TemporaryDirectory() as folder:
                    measured = fresh(code, PYTHONPYCACHEPREFIX=bytecode, SLOWFLOW_DERIVED=folder)
            found.append({"force": name, "how": "compiled" if compiled else "interpreted", **measured})
    return found
