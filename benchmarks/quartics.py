"""Boost.Math's quartic_roots and ACM's Algorithm 1010 as methods of `bench_roots`, where they are installed.

Boost's headers are the system's, or those of the package boost-headers. Algorithm 1010 (Orellana, De Michele) comes
with its article, doi:10.1145/3386241, in no package that pip installs; its licence keeps it out of this repository:
SLOWFLOW_ACM_1010 is the path of the file that defines `oqs_quartic_solver`.
"""

from __future__ import annotations

import ctypes
import importlib.util
import os
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np

BOOST, ACM = "Boost.Math", "ACM Algorithm 1010"
#: (24) is expanded in C: rows of A, h, m, zeta, F_0 to four roots each, NaN for those that are not real
LOOP = """
void solve(long n, const double *rows, double *out) {
    for (long i = 0; i < n; i++, rows += 5, out += 4) {
        const double A = rows[0], h = rows[1], m = rows[2], zeta = rows[3], F_0 = rows[4];
        const double c_0 = (m*m + h*h - F_0*F_0)/(A*A), c_1 = 4*zeta*m/A, c_2 = 4*zeta*zeta + 2*h/A;
        SOLVE } }
"""
BY_BOOST = """
        const auto found = boost::math::tools::quartic_roots(1.0, 0.0, c_2, c_1, c_0);
        for (int k = 0; k < 4; k++) out[k] = found[k];
"""
BY_ACM = """
        double coefficients[5] = {c_0, c_1, c_2, 0.0, 1.0};
        complex double found[4];
        oqs_quartic_solver(coefficients, found);
        for (int k = 0; k < 4; k++) out[k] = cimag(found[k]) == 0 ? creal(found[k]) : NAN;
"""
ACM_HEAD = """
#include <complex.h>
#include <math.h>
void oqs_quartic_solver(double coeff[5], complex double roots[4]);
"""
SOURCES = {
    BOOST: '#include <boost/math/tools/quartic_roots.hpp>\nextern "C"' + LOOP.replace("SOLVE", BY_BOOST),
    ACM: ACM_HEAD + LOOP.replace("SOLVE", BY_ACM),
}
FLAGS = ("-O3", "-march=native", "-ffp-contract=off", "-shared", "-fPIC")


def build(folder: Path) -> dict[str, Callable[[np.ndarray], np.ndarray]]:
    """What takes n rows of five parameters to n rows of four roots, by name, of those that can be built."""
    packaged = importlib.util.find_spec("boost_headers")
    folders = packaged.submodule_search_locations or () if packaged else ()
    headers = [f"-I{Path(name) / 'include'}" for name in folders]
    commands = {BOOST: ["g++", "-std=c++17", *headers, "-x", "c++", "-"]}
    if source := os.environ.get("SLOWFLOW_ACM_1010"):
        commands[ACM] = ["gcc", "-std=gnu11", "-x", "c", "-", "-x", "none", source, "-lm"]
    solvers = {}
    for name, (compiler, *arguments) in commands.items():
        library = folder / f"{compiler}.so"
        try:
            command = [compiler, *FLAGS, "-o", str(library), *arguments]
            subprocess.run(command, input=SOURCES[name], capture_output=True, check=True, text=True)
        except (OSError, subprocess.CalledProcessError):
            continue
        solvers[name] = solving(ctypes.CDLL(str(library)))
    return solvers


def solving(library: ctypes.CDLL) -> Callable[[np.ndarray], np.ndarray]:
    """The function `solve` of a library over arrays."""

    def solve(parameters: np.ndarray) -> np.ndarray:
        rows = np.ascontiguousarray(parameters, dtype=float)
        found = np.empty((len(rows), 4))
        pointers = (array.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for array in (rows, found))
        library.solve(ctypes.c_long(len(rows)), *pointers)
        return found

    return solve
