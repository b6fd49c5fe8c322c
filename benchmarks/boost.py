"""Boost.Math's quartic_roots as a method of `bench_roots`, where a C++ compiler and its headers are at hand.

Takes rows of A, h, m, zeta, F_0; returns four roots of (24) each, NaN for those that are not real; (24) is expanded in
C++ too. The headers are the system's, or those of the package boost-headers.
"""

from __future__ import annotations

import ctypes
import importlib.util
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np

SOURCE = """
#include <boost/math/tools/quartic_roots.hpp>
extern "C" void solve(long n, const double *rows, double *out) {
    for (long i = 0; i < n; i++) {
        const double A = rows[5*i], h = rows[5*i + 1], m = rows[5*i + 2], zeta = rows[5*i + 3], F_0 = rows[5*i + 4];
        const auto found = boost::math::tools::quartic_roots(
            1.0, 0.0, 4*zeta*zeta + 2*h/A, 4*zeta*m/A, (m*m + h*h - F_0*F_0)/(A*A));
        for (int k = 0; k < 4; k++) out[4*i + k] = found[k]; } }
"""
FLAGS = ("-std=c++17", "-O3", "-march=native", "-ffp-contract=off", "-shared", "-fPIC", "-x", "c++")


def build(folder: Path) -> Callable[[np.ndarray], np.ndarray] | None:
    """What takes n rows of five parameters to n rows of four roots; None where it cannot be built."""
    if shutil.which("g++") is None:
        return None
    packaged = importlib.util.find_spec("boost_headers")
    folders = list(packaged.submodule_search_locations or ()) if packaged else []
    source, library = folder / "boost.cpp", folder / "boost.so"
    source.write_text(SOURCE)
    include = [f"-I{Path(name) / 'include'}" for name in folders]
    return solving(["g++", *FLAGS, *include, str(source), "-o", str(library)], library)


def solving(command: list[str], library: Path) -> Callable[[np.ndarray], np.ndarray] | None:
    """The function `solve` of a library that a command builds, as `build` gives it; None where it cannot be built."""
    if subprocess.run(command, capture_output=True, check=False).returncode:
        return None
    loaded = ctypes.CDLL(str(library))

    def solve(parameters: np.ndarray) -> np.ndarray:
        rows = np.ascontiguousarray(parameters, dtype=float)
        found = np.empty((len(rows), 4))
        pointers = (array.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for array in (rows, found))
        loaded.solve(ctypes.c_long(len(rows)), *pointers)
        return found

    return solve
