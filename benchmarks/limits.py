"""Why a target is not reached: what was measured of each is in, sentences with measured limits out.

Single libm calls, a triad and fused multiply-adds are timed in C; instructions are counted by valgrind, evaluations by
`counted`. Where gcc or valgrind is not there, the sentence says so.
"""

from __future__ import annotations

import ctypes
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks import counted, footprint
from benchmarks.document import quantity
from benchmarks.remote import ROOT

CALLS = 2_000_000
FUNCTIONS = ("sqrt", "cbrt", "atan2", "acos", "cos")
SOURCE = """
#include <math.h>
#include <time.h>
#define CALL_sqrt(x) sqrt(x)
#define CALL_cbrt(x) cbrt(x)
#define CALL_atan2(x) atan2(x, 0.7)
#define CALL_acos(x) acos(x)
#define CALL_cos(x) cos(x)
#define TIME(f) double time_##f(long n) { \\
    struct timespec a, b; volatile double sink; double x = 0.1, step = 0.8 / n; \\
    clock_gettime(CLOCK_MONOTONIC, &a); \\
    for (long i = 0; i < n; i++) { sink = CALL_##f(x); x += step; } \\
    clock_gettime(CLOCK_MONOTONIC, &b); (void)sink; \\
    return ((b.tv_sec - a.tv_sec) + 1e-9 * (b.tv_nsec - a.tv_nsec)) / n; }
"""
#: a triad over arrays that no cache holds, and chains of fused multiply-adds of which none waits for another
MACHINE = """
#include <stdlib.h>
#include <time.h>
static double since(struct timespec a) {
    struct timespec b; clock_gettime(CLOCK_MONOTONIC, &b);
    return (b.tv_sec - a.tv_sec) + 1e-9 * (b.tv_nsec - a.tv_nsec); }
double triad(long n) {
    double *x = calloc(n, 8), *y = calloc(n, 8), *z = calloc(n, 8), best = 1e9; struct timespec a;
    for (long i = 0; i < n; i++) x[i] = i, y[i] = 1, z[i] = 2;
    for (int round = 0; round < 5; round++) {
        clock_gettime(CLOCK_MONOTONIC, &a);
        for (long i = 0; i < n; i++) z[i] = x[i] + 3 * y[i];
        if (since(a) < best) best = since(a); }
    free(x), free(y), free(z);
    return 24.0 * n / best; }
double fused(long n) {
    typedef double eight __attribute__((vector_size(64)));
    eight v[10]; double sum = 0, taken; struct timespec a;
    for (int k = 0; k < 80; k++) v[k / 8][k % 8] = k;
    clock_gettime(CLOCK_MONOTONIC, &a);
    for (long i = 0; i < n; i++) {
        #pragma GCC unroll 10
        for (int k = 0; k < 10; k++) v[k] = v[k] * 0.999 + 0.001; }
    taken = since(a);
    for (int k = 0; k < 80; k++) sum += v[k / 8][k % 8];
    return sum < 0 ? 0 : 80.0 * n / taken; }
"""
COUNTED = """
import sys
from benchmarks import jobs
from slowflow import example
iso, count = example.isolator(), int(sys.argv[1])
many = jobs.FAMILIES["random"](200)
for _ in range(count):
    {}
"""
#: by kind: what is done, in words and code, and how many answers it gives
WORK = {
    "curve": ("one response curve with folds", "iso.frequency_response(0.04), iso.saddle_nodes(0.04)", 1),
    "locus": ("one fold locus with cusps", "iso.fold_locus(samples=1000), iso.cusps()", 1),
    "detachment": ("one F_cr", "many.detachment()", 200),
    "saddle_node_onset": ("one F_SN", "many.saddle_node_onset()", 200),
    "saddle_nodes": ("all folds of one design", "many.saddle_nodes(0.07)", 200),
    "peak": ("one peak", "many.peak(0.07)", 200),
    "amplitudes": ("the states of one design", "many.amplitudes(Omega=0.9, F_0=0.07)", 200),
    "second": ("one curve of the second approximation", "iso.second_approximation.frequency_response(0.04)", 1),
}


def libm() -> list[str]:
    """What one call costs."""
    if shutil.which("gcc") is None:
        return ["the cost of a libm call was not measured: there is no gcc"]
    with tempfile.TemporaryDirectory() as folder:
        source, library = Path(folder) / "calls.c", Path(folder) / "calls.so"
        source.write_text(SOURCE + "\n".join(f"TIME({name})" for name in FUNCTIONS))
        flags = ["-O2", "-fno-math-errno", "-shared", "-fPIC"]
        subprocess.run(["gcc", *flags, str(source), "-o", str(library), "-lm"], check=True)
        loaded = ctypes.CDLL(str(library))
        costs = []
        for name in FUNCTIONS:
            time = getattr(loaded, f"time_{name}")
            time.restype = ctypes.c_double
            costs.append(f"{name} {quantity(min(time(ctypes.c_long(CALLS)) for _ in range(3)), 's')}")
    return [f"one call of libm: {', '.join(costs)}"]


def machine(cores: bool) -> list[str]:
    """What memory and arithmetic of one core allow, and of all of them beside each other."""
    if shutil.which("gcc") is None:
        return ["the machine's own limits were not measured: there is no gcc"]
    with tempfile.TemporaryDirectory() as folder:
        source, library = Path(folder) / "machine.c", Path(folder) / "machine.so"
        source.write_text(MACHINE)
        flags = ["-O3", "-march=native", "-ffp-contract=fast", "-shared", "-fPIC"]
        subprocess.run(["gcc", *flags, str(source), "-o", str(library)], check=True)
        loaded = ctypes.CDLL(str(library))
        calls = {"triad": (loaded.triad, 1 << 25), "fused": (loaded.fused, CALLS)}
        for function, _ in calls.values():
            function.restype = ctypes.c_double
        rates = {name: max(function(ctypes.c_long(n)) for _ in range(3)) for name, (function, n) in calls.items()}
        out = [
            f"one core of this machine: triad {rates['triad'] / 1e9:.3g} GB/s, "
            f"{rates['fused'] / 1e9:.3g} vectorized fused multiply-adds of doubles per ns"
        ]
        if cores:
            threads = os.cpu_count() or 1
            with ThreadPoolExecutor(threads) as pool:
                both = {
                    # calls long enough that all of them are under way together for most of the time
                    name: max(sum(pool.map(function, [ctypes.c_long(4 * n)] * threads)) for _ in range(3))
                    for name, (function, n) in calls.items()
                }
            times = ", ".join(f"{name} {both[name] / rates[name]:.3g} times" for name in calls)
            out.append(f"{threads} independent threads relative to one, by wall time: {times}")
    return out


def instructions(kinds: set[str]) -> list[str]:
    """Instructions of an answer of each kind, on average, beyond those of a run that asks once."""
    if kinds and shutil.which("valgrind") is None:
        return ["instructions were not counted: there is no valgrind"]
    if not kinds:
        return []
    out = []
    with tempfile.TemporaryDirectory() as folder:
        # a checkout's loops may be of a processor that valgrind does not know; those of a wheel choose theirs
        build = [sys.executable, "setup.py", "--quiet", "build", "--build-base", folder, "--build-lib", f"{folder}/lib"]
        subprocess.run(build, capture_output=True, check=True, cwd=ROOT)
        # or what the first process takes to compile modules would count as its answers'
        subprocess.run([sys.executable, "-m", "compileall", "-q", f"{folder}/lib"], check=True)
        for kind in sorted(kinds):
            name, code, answers = WORK[kind]
            beyond = _counted(f"{folder}/lib", code, 11) - _counted(f"{folder}/lib", code, 1)
            out.append(f"{name}: {beyond / (10 * answers):,.0f} instructions on the processor that valgrind emulates")
    return out


def _counted(package: str, code: str, times: int) -> int:
    """Instructions of a process that asks so many times, of what is built in a folder."""
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", sys.executable, "-c"]
    # threads of a linear algebra library wait by counting
    found = os.pathsep.join((package, str(ROOT)))
    env = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "PYTHONPATH": found}
    done = subprocess.run(
        [*command, COUNTED.format(code), str(times)], capture_output=True, text=True, check=True, cwd=package, env=env
    )
    return int(re.search(r"Collected : (\d+)", done.stderr)[1])


def imports() -> list[str]:
    """The generated modules that an import spends longest on, and what of it reading alone takes."""
    own = ", ".join(f"{name} {quantity(seconds, 's')}" for name, seconds in footprint.modules(5))
    whole, modules, size, read, libraries = footprint.bytecode()
    return [
        f"import slowflow, what takes longest (each module with those that it loads first): {own}",
        f"import slowflow beyond NumPy's, at its best {quantity(whole, 's')}: {modules:.0f} modules, whose "
        f"{size / 1e3:.0f} kB of bytecode are read and unmarshalled in {quantity(read, 's')}, and {libraries:.0f} "
        f"shared libraries; the rest is finding these files, loading the libraries and executing the modules",
    ]


def traffic(count: int = 10**6) -> list[str]:
    """What a point costs that is only moved: one double read, two written, as a kernel does."""
    amplitudes, results = np.linspace(0.1, 0.3, count), np.empty((2, count))
    times = []
    for _ in range(20):
        start = time.perf_counter()
        np.modf(amplitudes, out=(results[0], results[1]))
        times.append(time.perf_counter() - start)
    return [
        f"reading one double and writing two, numpy.modf on 10⁶ points: {quantity(min(times) / count, 's')} per point"
    ]


#: nanoseconds of Boost.Math's quartics, least and most of the same scenes, where the targets were set
BOOST = (112.0, 134.0)


def pace(rows: list[dict[str, Any]]) -> list[str]:
    """How long compiled code of others takes here against where the targets were set, and what is missed by less.

    And what is missed by more and has no sentence of its own.
    """
    here = next((row["known"] for row in rows if row["known"]), None)
    slower = sum(here) / sum(BOOST) if here else 1.0
    missed = [(row["job"], _missed_by(row), row["limit"]) for row in rows if not row["reached"]]
    by_less = [f"{job} (by {factor:.2g})" for job, factor, _ in missed if factor <= slower]
    silent = [job for job, factor, limit in missed if factor > slower and not limit]
    message = "what this machine does beside the one of the targets was not measured: Boost.Math is not at hand"
    if here:
        message = (
            f"where the targets were set Boost.Math took {BOOST[0]:g} to {BOOST[1]:g} ns per quartic, and "
            f"{here[0]:.3g} to {here[1]:.3g} ns here, {slower:.2g} times as long"
        )
    return [
        f"{message}; missed by less than that: {', '.join(by_less)}" if by_less else message,
        *([f"missed, and not known why: {', '.join(silent)}"] if silent else []),
    ]


def _missed_by(row: dict[str, Any]) -> float:
    """By what factor a time or a rate misses its target; infinite for what has no time in it."""
    if row["unit"] not in ("s", "per second"):
        return math.inf
    return row["measured"] / row["target"] if row["at_most"] else row["target"] / row["measured"]


def of(rows: list[dict[str, Any]]) -> list[str]:
    """Sentences about the limits of the targets that are missed."""
    kinds = {row["limit"] for row in rows if not row["reached"]}
    out = [*machine(cores="cores" in kinds), *pace(rows)]
    if "import" in kinds:
        out += imports()
    if "kernel" in kinds:
        out += traffic()
    if kinds & {"quartic", "kernel", *WORK}:
        out += libm()
    return [*out, *counted.of(kinds), *instructions(kinds & WORK.keys())]
