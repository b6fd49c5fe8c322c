"""Every generated kernel (NumPy, compiled, C) against 40-digit values from independent routes: `make_kernel_oracle`.

The measure is error/(u scale), where scale = |f| + sum |x df/dx| over the arguments: what rounding the arguments and
the result once each would cause. It is the error in units of u(1 + kappa), and stays finite where f vanishes.
"""

from __future__ import annotations

import ast
import functools
import importlib
import inspect
import os
import re
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest

from tests import backends
from tests.files import ROOT, stored
from tests.native import headers
from tests.native.compiler import COMPILER, WARNINGS, compiled

PACKAGE = ROOT / "generated" / "slowflow_kernels"
ORACLE = stored("kernel_oracle")
#: generated modules without kernels
TABLES = {
    "domains",
    "conventions",
    "exact_conventions",
    "program_conventions",
    "second_conventions",
    "quadrature_conventions",
    "scaling",
    "table_1",
}
# kernels on intervals and in balls hold these values: test_intervals.py and test_ball_kernels.py
MODULES = sorted({path.stem for path in PACKAGE.glob("*.py") if not path.stem.startswith("_")} - TABLES)
MODULES = [module for module in MODULES if not module.endswith(("_intervals", "_balls"))]
KERNELS = [(module, kernel) for module, kernels in ORACLE.items() for kernel in kernels]
U = Fraction(1, 2**53)
# measured: at most 2.4, of h_A well beyond u_cr; half of all kernels stay below 0.8
BOUND = 4
# T_5 = 16 s^5 - 20 s^3 + 5 s: the fifth harmonic is a difference; measured: at most 5.7, of h_5_AA at 1.25 u_cr,
# and 4.1 of what stands under its integral
# F_A along the balance and its slopes by the ends are sums of some fifty terms; measured: at most 5.3
BOUNDS = {"harmonics": 8, "harmonics_terms": 8, "ended_fold": 8}
INFINITE = {"inf": np.inf, "+inf": np.inf}


#: of digits of the oracle, which every backend is compared with
exact = functools.cache(Fraction)


def functions(module: str) -> set[str]:
    """Public functions that a generated module defines itself, or has from C."""
    tree = ast.parse((PACKAGE / f"{module}.py").read_text())
    own = {node.name for node in tree.body if isinstance(node, ast.FunctionDef) and not node.name.startswith("_")}
    return own | {*from_c(module)}


def from_c(module: str) -> dict[str, str]:
    """The functions that a generated module has from C, with their arguments."""
    return getattr(importlib.import_module(f"slowflow_kernels.{module}"), "FROM_C", {})


def worst(values: np.ndarray, row: dict) -> float:
    """The largest error/(u scale) of a kernel's outputs at one point; exact zeros and infinities have to be met."""
    assert len(values) == len(row["is"])
    ratios = [0.0]
    for value, expected, scale in zip(values, row["is"], row["scale"], strict=True):
        if expected in INFINITE:
            assert value == INFINITE[expected]
        elif exact(scale) == 0:
            assert value == 0
        else:
            assert np.isfinite(value)
            ratios.append(float(abs(Fraction(float(value)) - exact(expected)) / (U * exact(scale))))
    return max(ratios)


@pytest.fixture(scope="module", params=["numpy", "native"])
def package(request):
    """The kernels' modules by name, freshly imported on one backend."""

    return backends.load(request.param)


@pytest.mark.parametrize("module", MODULES)
def test_no_kernel_without_an_oracle(module):
    assert functions(module) == set(ORACLE[module])
    assert all(rows for rows in ORACLE[module].values())


PROTOTYPES = headers.prototypes()
MECHANISMS = {path.stem for path in (ROOT / "derivations" / "mechanisms").glob("[!_]*.py")}
IN_C = [one for one in KERNELS if "_".join(one) in PROTOTYPES]


def test_every_c_function_has_an_oracle():
    known = {f"{module}_{kernel}" for module, kernel in IN_C}
    prototypes, found = PROTOTYPES, set(PROTOTYPES)
    # what a mechanism has is listed in docs/kernels.md: all of it is in C, too
    assert {f"{module}_{kernel}" for module, kernel in KERNELS if module in MECHANISMS} <= known
    regimes = {name for name in found - known if name.rpartition("_passed_")[0] in known}
    forms = "_falling", "_rising", "_apart", "_over", "_inwards", "_outwards"
    regimes |= {name for name in found - known for form in forms if name.removesuffix(form) in known}
    # of what kernels repeat each output has a pointer of its own
    repeated = {
        name
        for name in found
        if any(one.startswith("double *") and one != "double *out" for one in prototypes[name][1])
    }
    assert not known & repeated
    assert found == known | regimes | repeated


def test_what_c_never_calls_is_not_printed_in_c():
    left = set(PROTOTYPES) - headers.called()
    solvers = "".join(path.read_text() for path in headers.NATIVE.rglob("*.h"))
    # a module's generic text is called on intervals, and has no other on doubles
    left -= {
        f"{module}_{kernel}"
        for module, kernel in KERNELS
        if (headers.HEADERS / f"{module}_generic.h").exists() and f"{module}_intervals_{kernel}(" in solvers
    }
    assert left <= {f"{module}_{kernel}" for module, kernel in KERNELS if module in MECHANISMS}


@pytest.mark.slow
def test_what_python_never_calls_is_listed():
    """Whether a name is called is told by its being an attribute, an import or a word of another generated function."""
    page = (ROOT / "docs" / "kernels.md").read_text()
    listed = set(re.findall(r"`([A-Za-z_0-9]+)(?:\([^`]*\))?`", page))
    trees = [ast.parse(path.read_text()) for part in ("src", "examples") for path in (ROOT / part).rglob("*.py")]
    named = {one for tree in trees for node in ast.walk(tree) for one in names_of(node)}
    for path in PACKAGE.glob("[!_]*.py"):
        tree = ast.parse(path.read_text())
        own = {name for node in tree.body for name in defined_by(node) if not name.startswith("_")}
        inside = {one.id for one in ast.walk(tree) if isinstance(one, ast.Name) and is_load(one)}
        assert own <= named | inside | listed, path.stem


def is_load(node: ast.Name) -> bool:
    return isinstance(node.ctx, ast.Load)


def defined_by(node: ast.AST) -> set[str]:
    if isinstance(node, ast.FunctionDef):
        return {node.name}
    targets = node.targets if isinstance(node, ast.Assign) else []
    return {one.id for target in targets for one in ast.walk(target) if isinstance(one, ast.Name)}


def names_of(node: ast.AST) -> set[str]:
    """What a node of runtime code calls by name."""
    if isinstance(node, ast.Attribute):
        return {node.attr}
    return {alias.name for alias in node.names} if isinstance(node, ast.ImportFrom) else set()


@pytest.mark.parametrize("module", MODULES)
def test_kernels_at_points_and_on_arrays(package, module):
    """All points in one call too: every regime by its mask, without a warning from the others."""
    for kernel, rows in ORACLE[module].items():
        function = getattr(package[module], kernel)
        result = function(*np.array([row["at"] for row in rows]).T)
        outputs = [result] if not isinstance(result, tuple) and np.ndim(result) < 2 else list(result)
        # a kernel for any kind of number knows no shape: its constants come back as numbers
        outputs = [np.full(len(rows), output) if isinstance(output, float) else output for output in outputs]
        assert all(output.shape == (len(rows),) for output in outputs), kernel
        for k, row in enumerate(rows):
            for values in ([output[k] for output in outputs], np.ravel(np.array(function(*row["at"])))):
                assert worst(values, row) <= BOUNDS.get(kernel, BOUND), kernel


@pytest.mark.slow
def test_kernels_in_c(c_kernels):
    for module, kernel in IN_C:
        for row in ORACLE[module][kernel]:
            values = c_kernels(f"{module}_{kernel}", row["at"], len(row["is"]))
            assert worst(values, row) <= BOUNDS.get(kernel, BOUND), (module, kernel)


@pytest.mark.parametrize(
    "header",
    sorted({*headers.HEADERS.glob("*.h")} - {*headers.HEADERS.glob("*_generic.h")}),
    ids=lambda header: header.name,
)
def test_header_compiles_alone(header, tmp_path):
    if COMPILER is None:
        pytest.skip("no C compiler (cc) on the path: the C headers are not tried")
    source = tmp_path / "alone.c"
    source.write_text(f'#include "{header.name}"\nint main(void) {{ return 0; }}\n')
    compiled(tmp_path / "alone", source, options=WARNINGS, compiler=COMPILER)


ISOLATOR = (0.5, 2.7914, 2.0935, 0.397)


def test_scalars_give_scalars(package):
    value = package["rod_spring"].h(0.5, *ISOLATOR)
    assert isinstance(value, np.float64)
    assert all(isinstance(part, np.float64) for part in package["rod_spring"].averaged(0.3, *ISOLATOR))
    assert isinstance(package["slow_flow"].equivalent_damping(0.9, 0.3, 0.01, 0.02), np.float64)


def test_integers_are_taken_as_floats(package):
    assert package["den_hartog"].V(2) == package["den_hartog"].V(2.0)
    assert package["rod_spring"].h(1, 1, 0, 0, 0) == -1.0


def test_unused_arguments_count_for_the_shape(package):
    mu = np.zeros((3, 1))
    assert package["rod_spring"].F_A(0.9, np.full(2, 0.3), mu, 0.02, *ISOLATOR).shape == (3, 2)
    jacobian = package["slow_flow"].jacobian(0.9, np.full(2, 0.3), mu, 0.02, -0.1, -0.5)
    assert [entry.shape for entry in jacobian] == [(3, 2)] * 4
    assert package["rod_spring"].saddle_node_onset(mu, 0.02, *ISOLATOR).shape == (19, 3, 1)
    assert package["slow_flow"].fold_quartic(0.3, mu, 0.02, -0.1, -0.5)[3].shape == (3, 1)


def test_outputs_are_not_the_arguments(package):
    A = np.array([0.1, 0.2])
    *_, leading = package["slow_flow"].fold_quartic(A, 0.01, 0.02, -0.1, -0.5)
    leading[0] = 7.0
    beyond = package["rod_spring"].force(A, 0.5, 2.0, 2.0, 0.05)
    beyond[0] = 7.0
    assert A[0] == 0.1


def test_nan_in_nan_out(package):
    A = np.array([0.1, np.nan, 0.5])
    for values in package["rod_spring"].averaged(A, *ISOLATOR):
        assert list(np.isnan(values)) == [False, True, False]
    assert np.isnan(package["rod_spring"].h(np.nan, *ISOLATOR))
    assert np.isnan(package["rod_spring"].h(0.1, np.nan, *ISOLATOR[1:]))


def test_empty_arrays(package):
    values = package["rod_spring"].averaged(np.empty((0, 3)), *ISOLATOR)
    assert [value.shape for value in values] == [(0, 3)] * 4


def test_no_piece_without_preload(package):
    """delta_h = 0 leaves a linear oscillator: h = -A, without a warning."""
    A = np.array([0.0, 1e-3, 0.5])
    h, h_A, h_AA, h_AAA = package["rod_spring"].averaged(A, 1.0, 3.0, 2.25, 0.0)
    np.testing.assert_allclose(h, -A, rtol=4e-16)
    np.testing.assert_allclose(h_A[1:], -1.0, rtol=4e-16)
    assert not h_AA[1:].any() and not h_AAA[1:].any()


@pytest.mark.parametrize("module", MODULES)
def test_what_type_checkers_are_told_holds(package, module):
    """Arguments and results that the signatures of a module's public functions state, as loops are compiled of them."""
    tree = ast.parse((PACKAGE / f"{module}.py").read_text())
    public = {*package[module].__all__}.difference(from_c(module))
    stubs = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name in public}
    assert all(node.returns is not None for node in stubs.values())
    borrowed = {alias.name for node in tree.body if isinstance(node, ast.ImportFrom) for alias in node.names}
    assert all(not callable(getattr(package[module], name)) for name in public - borrowed - stubs.keys())
    for name, node in stubs.items():
        function = getattr(package[module], name)
        assert list(inspect.signature(function).parameters) == [argument.arg for argument in node.args.args]
        with np.errstate(all="ignore"):
            values = function(*np.linspace(0.2, 0.9, len(node.args.args)))
        result = ast.unparse(node.returns)
        if result == "Any":
            assert np.ndim(values) == 0
        elif result == "Floats":
            assert isinstance(values, np.ndarray) and values.ndim == 1
        else:
            assert isinstance(values, tuple)
            assert result == (f"tuple[{', '.join(['Any'] * len(values))}]" if values else "tuple[()]")


def test_type_checkers_believe_the_package():
    assert (PACKAGE / "py.typed").exists()


def test_package_imports_nothing_before_it_is_asked():
    code = "import sys, slowflow_kernels; print(*sorted(m for m in sys.modules if m.startswith('slowflow_kernels')))"
    assert run_python(code) == "slowflow_kernels"
    code = "import slowflow_kernels; print(slowflow_kernels.duffing.MECHANISM.name, *slowflow_kernels.MODULES)"
    assert run_python(code).startswith("duffing slow_flow ")


def test_package_needs_numpy_only():
    code = "import sys; from slowflow_kernels import rod_spring; print('sympy' in sys.modules, 'scipy' in sys.modules)"
    assert run_python(code) == "False False"


def run_python(code: str) -> str:
    """What a fresh interpreter prints."""
    environment = {**os.environ, "PYTHONPATH": str(PACKAGE.parent)}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment, check=True)
    return done.stdout.strip()
