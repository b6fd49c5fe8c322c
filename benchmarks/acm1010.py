"""ACM's Algorithm 1010 (Orellana, De Michele) as a method of `bench_roots`, where a user has put its source.

Its C source comes with the article, doi:10.1145/3386241, in no package that pip installs; its licence keeps it out of
this repository. SLOWFLOW_ACM_1010 is the path of the file that defines `oqs_quartic_solver`. In and out as in `boost`.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np

from benchmarks import boost

VARIABLE = "SLOWFLOW_ACM_1010"
SOURCE = """
#include <complex.h>
#include <math.h>
void oqs_quartic_solver(double coeff[5], complex double roots[4]);
void solve(long n, const double *rows, double *out) {
    for (long i = 0; i < n; i++) {
        const double A = rows[5*i], h = rows[5*i + 1], m = rows[5*i + 2], zeta = rows[5*i + 3], F_0 = rows[5*i + 4];
        double given[5] = {(m*m + h*h - F_0*F_0)/(A*A), 4*zeta*m/A, 4*zeta*zeta + 2*h/A, 0.0, 1.0};
        complex double found[4];
        oqs_quartic_solver(given, found);
        for (int k = 0; k < 4; k++) out[4*i + k] = cimag(found[k]) == 0 ? creal(found[k]) : NAN; } }
"""
FLAGS = ("-std=gnu11", "-O3", "-march=native", "-ffp-contract=off", "-shared", "-fPIC")


def build(folder: Path) -> Callable[[np.ndarray], np.ndarray] | None:
    """What takes n rows of five parameters to n rows of four roots; None where there is no source or no compiler."""
    theirs = os.environ.get(VARIABLE)
    if theirs is None or shutil.which("gcc") is None:
        return None
    source, library = folder / "acm1010.c", folder / "acm1010.so"
    source.write_text(SOURCE)
    return boost.solving(["gcc", *FLAGS, str(source), theirs, "-o", str(library), "-lm"], library)
