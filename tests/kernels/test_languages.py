"""The kernels in MATLAB, Fortran and Julia: values are those on NumPy, and no exported function is missing."""

import inspect
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest

import slowflow_kernels
from slowflow import languages
from tests.backends import as_rows
from tests.native.headers import expanded

MODULES = {name: getattr(slowflow_kernels, name) for name in slowflow_kernels.MODULES}


def own_kernels(module):
    """The public kernels of which a module has the text, by name."""
    every = {name: getattr(module, name) for name in module.__all__ if callable(getattr(module, name))}
    return {name for name, one in every.items() if inspect.unwrap(one).__code__.co_filename == module.__file__}


def methods(module):
    """The public kernels in a module's MATLAB class."""
    written = re.findall(r"^ {8}function (?:\[.*?\] = )?(\w+)\(", languages.matlab(module), re.MULTILINE)
    return [name for name in own_kernels(module) if name in written]


@pytest.mark.parametrize("name", MODULES)
def test_matlab_has_every_kernel_of_a_module(name):
    assert set(methods(MODULES[name])) == own_kernels(MODULES[name])


@pytest.mark.parametrize("name", MODULES)
@np.errstate(all="ignore")
def test_values_in_octave_are_those_on_numpy(name, tmp_path):
    if shutil.which("octave-cli") is None:
        pytest.skip("GNU Octave is not installed")
    module, rng = MODULES[name], np.random.default_rng(1)
    for needed in {name, "slow_flow"}:
        (tmp_path / f"{needed}.m").write_text(languages.matlab(MODULES[needed]), encoding="utf-8")
    lines, expected = [], {}
    for kernel in methods(module):
        arguments = rng.uniform(0.1, 0.9, (len(inspect.signature(getattr(module, kernel)).parameters), 8))
        rows = as_rows(getattr(module, kernel)(*arguments)) if arguments.size else []
        expected |= {f"{kernel} {k}": row.ravel() for k, row in enumerate(rows)}
        taken = ", ".join(str(list(map(float, row))) for row in arguments)
        if rows:
            lines.append(f"found = cell(1, {len(rows)}); [found{{:}}] = {name}.{kernel}({taken});")
            # row by row, as NumPy has them
            lines.append(f"for k = 1:numel(found) printf('{kernel} %d:', k - 1), printf(' %.17g', found{{k}}.'),")
            lines.append("printf('\\n'), end")
    script = tmp_path / "script.m"
    script.write_text("\n".join(lines), encoding="utf-8")
    command = ["octave-cli", "--no-gui", "--quiet", str(script)]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    found = dict(line.split(":") for line in done.stdout.splitlines())
    assert found.keys() == expected.keys()
    for kernel, row in expected.items():
        np.testing.assert_allclose(np.array(found[kernel].split(), float), row, rtol=1e-9, atol=1e-12, err_msg=kernel)


def test_a_derived_mechanism_is_written_too():
    """Averages by quadrature are left out, and what needs them."""
    sp, derive = pytest.importorskip("sympy"), pytest.importorskip("slowflow.derive")
    pytest.importorskip("flint", reason="what derives is not installed")
    u, gap = sp.symbols("u gap")
    stop = derive.mechanism("stop", [(u, gap), (u + 9 * (u - gap), None)], {"gap": {"above": 0}})
    soft = derive.mechanism("soft", [(sp.tanh(u), None)], {})
    written, by_quadrature = (methods(sys.modules[one.record.coefficients.__module__]) for one in (stop, soft))
    assert {"averaged", "force", "coefficients"} <= set(written)
    assert "averaged" not in by_quadrature and "force_1" in by_quadrature


def test_interfaces_have_every_exported_function():
    """The library has a symbol for each name; Fortran's names are apart without regard to case."""
    text = "".join(expanded(path) for path in languages.headers())
    exported = re.findall(r"^SF_(?:KERNEL|TWOFOLD)\s+\w+\s+(\w+)\(", text, re.MULTILINE)
    interface = languages.fortran(languages.headers()).replace("&\n", "")
    fortran = re.findall(r"(\w+)\([^()]*\)\s*bind\(c,\s*name=\"(\w+)\"\)", interface)
    assert [name for _, name in fortran] == exported
    assert len({name.lower() for name, _ in fortran}) == len(exported)
    calls = re.findall(r"ccall\(\(:(\w+), library\), \w+, \((.*?)\)", languages.julia(languages.headers()))
    assert [name for name, _ in calls] == exported


def test_a_julia_call_has_types_in_order():
    (path,) = (one for one in languages.headers() if one.stem == "rod_spring")
    julia = languages.julia([path])
    assert "rod_spring_averaged!(A, p, out) =" in julia
    assert "Cvoid, (Cdouble, Ptr{Cdouble}, Ptr{Cdouble},), A, p, out)" in julia
    assert "rod_spring_force(u, alpha, beta, gamma, u_cr) =" in julia
