"""Every function of the headers has a symbol in a library of `exported.c`; so called it is the same."""

from __future__ import annotations

import ctypes
import importlib
import re
import shlex
import shutil
import subprocess
import sysconfig

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from slowflow import derive, include
from tests.files import ROOT

FOLDER = ROOT / "generated" / "c"
COMPILER = shlex.split(sysconfig.get_config_var("CC") or "cc")
pytestmark = pytest.mark.skipif(not shutil.which(COMPILER[0]), reason="there is no C compiler")


def compiled(folder, place):
    """A library of a folder's `exported.c`."""
    library = place / "kernels.so"
    flags = ["-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-shared", "-fPIC"]
    headers = [f"-I{path}" for path in (folder, *include())]
    source = str(folder / "exported.c")
    done = subprocess.run(
        [*COMPILER, *flags, *headers, source, "-o", str(library), "-lm"], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return library


def listed(folder):
    """Prototypes by name, of the headers that its `exported.c` includes."""
    included = re.findall(r'#include "(.*)"', (folder / "exported.c").read_text())
    text = "".join((folder / header).read_text() for header in included)
    found = re.findall(r"^(?:SF_KERNEL|SF_TWOFOLD) (\w+ (\w+)\([^()]*\))\n{", text, re.MULTILINE)
    return {name: " ".join(prototype.split()) for prototype, name in found}


def symbols(library):
    if not shutil.which("nm"):
        pytest.skip("there is no nm")
    done = subprocess.run(["nm", "-D", "--defined-only", str(library)], capture_output=True, text=True, check=True)
    return {line.split()[2] for line in done.stdout.splitlines() if line.split()[1] == "T"}


@pytest.mark.slow
def test_what_is_listed_is_what_the_library_exports(tmp_path):
    """And it is every function that a header defines."""
    defined = set()
    for header in FOLDER.glob("*.h"):
        if header.name != "angles.h":
            defined |= {
                f"{header.stem}_{name}"
                for name in re.findall(rf"^(?!SF_COMMON)\w[\w ]* {header.stem}_(\w+)\(.*", header.read_text(), re.M)
            }
    names = set(listed(FOLDER))
    assert names == defined - {"_"} and len(names) > 300
    assert symbols(compiled(FOLDER, tmp_path)) >= names


@pytest.mark.slow
def test_a_function_called_by_its_symbol_is_that_of_python(tmp_path):
    """Every function of numbers alone that Python has too, at numbers within its domain."""
    library = ctypes.CDLL(str(compiled(FOLDER, tmp_path)))
    tried = 0
    modules = sorted((header.stem for header in FOLDER.glob("*.h")), key=len, reverse=True)
    for name, prototype in listed(FOLDER).items():
        module = next(one for one in modules if name.startswith(f"{one}_"))
        arguments = re.findall(r"[(,] ?double (\w+)", prototype)
        python = getattr(importlib.import_module(f"slowflow_kernels.{module}"), name.removeprefix(f"{module}_"), None)
        if not prototype.startswith("double") or "*" in prototype or python is None:
            continue
        function = getattr(library, name)
        function.restype, function.argtypes = ctypes.c_double, [ctypes.c_double] * len(arguments)
        numbers = [0.3 + 0.0625 * k for k in range(len(arguments))]
        with np.errstate(all="ignore"):
            expected = np.float64(python(*numbers))
        # NumPy's elementary functions may differ in the last places
        np.testing.assert_allclose(function(*numbers), expected, rtol=1e-13, err_msg=name)
        tried += 1
    assert tried > 60


@pytest.mark.slow
def test_a_mechanism_of_ones_own_is_exported(tmp_path):
    """Its average by the symbol, against a quadrature of the force."""
    u, k, gap = sp.symbols("u k gap")
    made = derive.mechanism("stop", [(u, gap), (u + k * (u - gap), None)], {"k": {"above": 0}, "gap": {"above": 0}})
    names = made.write(tmp_path)
    assert "exported.c" in names
    library = ctypes.CDLL(str(compiled(tmp_path, tmp_path)))
    prefix = made.record.name
    assert set(listed(tmp_path)) >= {f"{prefix}_averaged", f"{prefix}_coefficients"}
    p, out = (ctypes.c_double * 8)(), (ctypes.c_double * 4)()
    getattr(library, f"{prefix}_coefficients")(ctypes.c_double(6.0), ctypes.c_double(0.25), p)
    getattr(library, f"{prefix}_averaged")(ctypes.c_double(0.5), p, out)

    def whole(t):
        x = 0.5 * mp.cos(t)
        return (x + 6 * max(x - mp.mpf(0.25), 0)) * mp.cos(t)

    expected = -4 / mp.pi * mp.quad(whole, [0, mp.acos(0.5), mp.pi / 2])
    assert out[0] == pytest.approx(float(expected), rel=1e-14)
    folder = tmp_path / "side"
    derive.mechanism("side", [(u, 0), (2 * u, None)], {}, odd=False).write(folder)
    assert not (folder / "exported.c").exists()
