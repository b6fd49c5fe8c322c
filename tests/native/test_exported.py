"""Every function of the headers has a symbol in a library of `exported.c`, by which `test_kernels.py` calls it."""

from __future__ import annotations

import re
import shutil
import subprocess

import mpmath as mp
import pytest
import sympy as sp

from slowflow import derive
from tests.native import headers
from tests.native.compiler import COMPILER, compiled

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")


def symbols(library):
    if not shutil.which("nm"):
        pytest.skip("there is no nm")
    done = subprocess.run(["nm", "-D", "--defined-only", str(library)], capture_output=True, text=True, check=True)
    return {line.split()[2] for line in done.stdout.splitlines() if line.split()[1] == "T"}


@pytest.mark.slow
def test_every_function_of_the_headers_has_a_symbol(once):
    library = once("headers", headers.build) / headers.LIBRARY
    defined = set()
    for header in headers.HEADERS.glob("*.h"):
        name = rf"^(?!SF_COMMON|static inline)\w[\w ]* ({header.stem}_\w+)\(.*"
        defined |= {*re.findall(name, headers.expanded(header), re.MULTILINE)}
    names = set(headers.prototypes())
    assert names == defined and len(names) > 300
    assert symbols(library) >= names


def test_headers_leave_macros_of_the_program(tmp_path):
    """REAL, ADD, ... of a program that includes the headers are what they were."""
    headers_of_numbers = [*headers.HEADERS.glob("arithmetic_*.h"), *headers.NATIVE.glob("arithmetic_*.h")]
    printed = "".join(path.read_text() for path in headers_of_numbers)
    names = sorted({"OF", *re.findall(r"#define (\w+)", printed)})
    lines = [f"#define {name} 1" for name in names]
    lines.append('#include "dissipation.h"')
    lines.append(f"int main(void) {{ return {' + '.join(names)} - {len(names)}; }}")
    (source := tmp_path / "program.c").write_text("\n".join([*lines, ""]))
    program = compiled(
        tmp_path / "program", source, options=["-std=c99", "-w", f"-I{headers.HEADERS}"], compiler=COMPILER
    )
    subprocess.run([program], check=True)


@pytest.mark.slow
def test_a_mechanism_of_ones_own_is_exported(tmp_path):
    """Its average by the symbol, against a quadrature of the force."""
    u, k, gap = sp.symbols("u k gap")
    made = derive.mechanism("stop", [(u, gap), (u + k * (u - gap), None)], {"k": {"above": 0}, "gap": {"above": 0}})
    assert "exported.c" in made.write(tmp_path)
    headers.build(tmp_path, tmp_path)
    call, prefix = headers.load(tmp_path, tmp_path), made.record.name
    parameters = call(f"{prefix}_coefficients", [6.0, 0.25], len(made.record.parameters))
    found = call(f"{prefix}_averaged", [0.5, *parameters], 4)

    def whole(t):
        x = 0.5 * mp.cos(t)
        return (x + 6 * max(x - mp.mpf(0.25), 0)) * mp.cos(t)

    expected = -4 / mp.pi * mp.quad(whole, [0, mp.acos(0.5), mp.pi / 2])
    assert found[0] == pytest.approx(float(expected), rel=1e-14)
    folder = tmp_path / "side"
    derive.mechanism("side", [(u, 0), (2 * u, None)], {}, odd=False).write(folder)
    assert not (folder / "exported.c").exists()
