"""Compiled kernels beside NumPy's: the same numbers, a ufunc's manners, one result on every processor.

How right both are, `test_kernels.py` says; here they are compared with one another.
"""

from __future__ import annotations

import ctypes
import importlib
import inspect
import math
import pickle
import platform
import pydoc
import shutil
import subprocess
import sys
import threading
import time
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest

from derivations.codegen.arctangent import series
from slowflow.core.backend import SOLVER as roots
from slowflow.example import DESIGN
from slowflow.support import backend as support
from slowflow_kernels import MODULES, dissipation, rod_spring, slow_flow
from tests import backends
from tests.native import clones
from tests.native.compiler import FLAGS, NATIVE, compiled
from tests.oracles.kernels import is_of_gradients

U = 2.0**-53
#: modules without compiled loops: they serve any kind of number, or arrays as they are, or NumPy's solvers alone
GENERIC = ("frequencies", "motion", "off_centre", "dissipation", "sensitivities", "sampled", "linearization")
#: of a mechanism: its own averages one by one, and the slow flow's functions with these put in
CALLS_ONLY = (
    *("h", "h_A", "h_AA", "h_AAA", "H", "H_A", "H_AA"),
    *("F", "F_A", "level", "phase", "jacobian", "stability", "transmissibility"),
    *("backbone", "limit_envelope", "equivalent_damping"),
    *("response_quartic", "fold_quartic", "peak_cubic", "detachment"),
)
#: asked once an answer, or of a batch as a whole
ONCE = ("held", "isolation", "amplitude", "moves_from")
RANGES = {
    "Omega": (0.1, 3), "A": (0.01, 1.5), "F_0": (0.01, 1), "m": (0, 0.1), "mu": (0, 0.1), "zeta": (0, 0.1),
    "h": (-2, 0.5), "h_A": (-2, 1), "h_AA": (-3, 3), "h_AAA": (-3, 3), "alpha": (-0.5, 1), "beta": (0, 3),
    "gamma": (0, 3), "u_cr": (0.2, 0.6), "lam": (0.5, 5), "r": (0.5, 5), "delta_h": (0.02, 0.4), "u": (-0.95, 0.95),
    "tau": (0, 3), "S": (0.1, 2),
}  # fmt: skip


@pytest.fixture(scope="module")
def on_numpy():
    """Every module of kernels, loaded once more without the compiled ones."""

    return backends.load("numpy")


def arguments(function, seed: int, size: int = 3001) -> dict[str, np.ndarray]:
    """Random arguments of a kernel, by name; a third of the amplitudes at or beside a change of regime."""
    rng = np.random.default_rng(seed)
    values = {name: rng.uniform(*RANGES.get(name, (0.5, 2)), size) for name in inspect.signature(function).parameters}
    if "A" in values and "u_cr" in values:
        some = np.arange(0, size, 3)
        values["A"][some] = values["u_cr"][some] * rng.choice(
            [1, 1 + 2**-52, 1 - 2**-53, 1.05, 1.05 + 2**-52], some.size
        )
    if "h_3" in values:  # within the domain: off the third harmonic's resonance
        values["h"] = values["A"] * values["Omega"] ** 2 * rng.uniform(-8, 8, size)
    return values


def kernels_of(module) -> list[str]:
    """Names of a module's functions with text in Python, but those for any kind of number and those of gradients."""
    if module.__name__.rpartition(".")[2] in GENERIC:
        return []
    record = getattr(module, "MECHANISM", None)
    apart = {function.__name__ for law in record.pieces for function in law[:2]} | {"steps"} if record else set()
    apart |= {*getattr(module, "FROM_C", ())}
    names = [name for name in module.__all__ if callable(getattr(module, name)) and name not in apart]
    return [name for name in names if not is_of_gradients(name)]


def outputs(result) -> list[np.ndarray]:
    """One array for each output."""
    return list(result) if isinstance(result, tuple) else [result]


def first_ends(module, values):
    """Where the first piece of the force ends, at each point; None where there is no end, or no parameter of it."""
    mechanism = getattr(module, "MECHANISM", None)
    parameters = [] if mechanism is None else [values.get(parameter.name) for parameter in mechanism.parameters]
    if mechanism is None or any(value is None for value in parameters):
        return None
    ends = mechanism.breakpoints(*parameters)
    return ends[0] if ends else None


@pytest.mark.parametrize("name", MODULES)
def test_same_numbers_as_numpy(on_numpy, name):
    """Without an angle, a sine, a cosine or a cube root in it, to the last bit; with one, as far as these may differ.

    Both angles of the detached regimes have an error below 2^-52 each way, and every later rounding may differ once; so
    has the cube root, which NumPy takes from a library of its own.
    """
    module, reference = importlib.import_module(f"slowflow_kernels.{name}"), on_numpy[name]
    for seed, kernel in enumerate(kernels_of(reference)):
        drawn = arguments(getattr(reference, kernel), seed)
        values = tuple(drawn.values())
        with np.errstate(all="ignore"):
            new, old = (outputs(getattr(m, kernel)(*values)) for m in (module, reference))
        assert len(new) == len(old)
        exact = np.ones(values[0].shape, bool)
        if name in ("den_hartog", "second_approximation") or kernel in ("phase", "critical"):
            exact[:] = False
        elif "A" in drawn and (ends := first_ends(module, drawn)) is not None:
            exact = drawn["A"] <= ends
        for k, (x, y) in enumerate(zip(new, old, strict=True)):
            assert x.shape == y.shape
            assert np.array_equal(x[..., exact], y[..., exact], equal_nan=True), (kernel, k)
            if kernel in ("averaged", "averaged_2", "averaged_H", "h", "h_A", "h_AA", "h_AAA", "H", "H_A", "H_AA"):
                order = k + kernel.count("A")
                A, alpha, beta, gamma = (np.abs(drawn.get(n, 0.0)) for n in ("A", "alpha", "beta", "gamma"))
                # what the moments multiply, over A^order; a moment is at most pi/2
                terms = 2 * (1 + alpha + 20 * beta * A**2 + 60 * gamma * A**4) * A ** (1 - order)
                terms = terms + np.abs(y)
                assert np.all(np.abs(x - y) <= 8 * U * terms), (kernel, k, np.max(np.abs(x - y) / (U * terms)))
            elif kernel == "critical":
                c = np.cbrt(6.75 * drawn["A"] * drawn["q"] ** 2)
                root = c if k == 0 else c / (3 * drawn["A"])
                # two errors of the root's and a rounding of its multiple each, and then of the sum
                assert np.all(np.abs(x - y) <= U * (8 * root + 2 * np.abs(y))), (kernel, k)
            else:
                assert np.allclose(x, y, rtol=1e-9, atol=1e-12, equal_nan=True), (kernel, k)


def test_every_kernel_is_compiled(on_numpy):
    """All but those without outputs, that are asked once an answer, or that only call others."""
    for name, reference in on_numpy.items():
        module = importlib.import_module(f"slowflow_kernels.{name}")
        thin = {*CALLS_ONLY} if hasattr(reference, "MECHANISM") else set()
        if hasattr(reference, "averaged_all"):
            thin |= {"averaged", "averaged_2", "averaged_H", "intercept"}
        for kernel in set(kernels_of(reference)) - thin - {*ONCE}:
            one_each = [0.5 for _ in inspect.signature(getattr(reference, kernel)).parameters]
            with np.errstate(all="ignore"):
                found = outputs(getattr(reference, kernel)(*one_each))
            if len(found):
                code = getattr(module, kernel).__code__
                assert code.co_filename.endswith("backend.py"), f"{name}.{kernel} runs on NumPy"


def test_kernels_keep_their_names_arguments_and_words():
    """The same signature, docstring and keywords, compiled or not; and the same errors."""
    assert [*inspect.signature(slow_flow.F).parameters] == ["Omega", "A", "F_0", "m", "zeta", "h"]
    assert slow_flow.F.__module__ == "slowflow_kernels.slow_flow"
    shown = pydoc.render_doc(slow_flow.F, renderer=pydoc.plaintext)
    assert all(word in shown for word in ("F(Omega: 'ArrayLike', A: 'ArrayLike',", "Equation (24).", "Operations: "))
    p = rod_spring.coefficients(3.0, 2.0, 0.08)
    named = dict(zip((one.name for one in rod_spring.MECHANISM.parameters), p, strict=True))
    assert rod_spring.averaged(A=0.3, **named) == rod_spring.averaged(0.3, *p)
    assert slow_flow.R(0.9, h=-0.2, A=0.3) == slow_flow.R(0.9, 0.3, -0.2)
    assert np.array_equal(
        slow_flow.detachment(0.3, h=-0.2, m=0.01, zeta=0.02), slow_flow.detachment(0.3, 0.01, 0.02, -0.2)
    )
    assert pickle.loads(pickle.dumps(slow_flow.F)) is slow_flow.F
    assert pickle.loads(pickle.dumps(dissipation.F_A_halved)) is dissipation.F_A_halved
    assert dissipation.F_A_halved(R=1, R_A=2, I=3, I_A=4) == dissipation.F_A_halved(1, 2, 3, 4) == 14
    with pytest.raises(TypeError, match="missing 1 required positional argument: 'A'"):
        slow_flow.R(0.9, h=-0.2)
    with pytest.raises(TypeError, match="multiple values for argument 'Omega'"):
        slow_flow.R(0.9, 0.3, Omega=0.9, h=-0.2)
    with pytest.raises(TypeError, match="unexpected keyword argument 'f'"):
        slow_flow.R(0.9, 0.3, -0.2, f=1)


@pytest.mark.parametrize("name", MODULES)
def test_kernels_give_as_many_results_of_a_shape_as_they_say(name):
    """By their annotations and their module's docstring; arguments of shapes (2, 1) and (3,) in turn."""
    module = importlib.import_module(f"slowflow_kernels.{name}")
    broadcast = "each output has their common shape" in (module.__doc__ or "")
    for kernel in kernels_of(module) or module.__all__:
        function = getattr(module, kernel)
        if not inspect.isfunction(function) or "return" not in function.__annotations__:
            continue
        annotation = function.__annotations__["return"]
        drawn = arguments(function, 3, 6)
        shaped = [value[:2, np.newaxis] if i % 2 else value[:3] for i, value in enumerate(drawn.values())]
        common = np.broadcast_shapes(*(np.shape(value) for value in shaped))
        with np.errstate(all="ignore"):
            found = function(*shaped)
        assert isinstance(found, tuple) == annotation.startswith("tuple"), kernel
        docstring = " ".join((function.__doc__ or "").split())
        assert ("along its first axis" in docstring) == (annotation == "Floats"), kernel
        results = found if isinstance(found, tuple) or annotation == "Floats" else (found,)
        assert annotation == "Floats" or len(results) == annotation.count("Any"), kernel
        shapes = [np.shape(value) for value in results]
        if broadcast and "ArrayLike" in function.__annotations__.values():
            assert shapes == [common] * len(results), kernel
        else:
            assert all(np.broadcast_shapes(shape, common) == common for shape in shapes), kernel


def test_arguments_broadcast():
    p = rod_spring.coefficients(*DESIGN)
    A, beta = np.linspace(0.05, 1, 7)[:, None], np.linspace(0.5, 2, 5)
    table = rod_spring.h(A, p[0], beta, *p[2:])
    assert table.shape == (7, 5)
    assert all(table[i, j] == rod_spring.h(A[i, 0], p[0], beta[j], *p[2:]) for i in range(7) for j in range(5))
    assert np.array_equal(rod_spring.h(A.astype(np.float32), *p), rod_spring.h(A.astype(np.float32).astype(float), *p))
    assert (
        rod_spring.saddle_nodes(0.04, A, 0.02, *p)[:, 3, 0].shape == rod_spring.saddle_nodes(0.04, 0.1, 0.02, *p).shape
    )
    assert isinstance(rod_spring.breakpoints(*p), tuple)
    with pytest.raises(ValueError, match="broadcast"):
        rod_spring.h(np.ones(3), np.ones(4), *p[1:])


@pytest.mark.parametrize("size", [1, 2, 7, 255, 256, 257, 1000])
def test_strides(size):
    """Reversed, sliced and transposed arrays give what contiguous copies give."""
    p = rod_spring.coefficients(*DESIGN)
    wide = np.random.default_rng(size).uniform(0.01, 1.2, (size, 3))
    for view in (wide[:, 1], wide[::-1, 0], wide[:, ::2], wide.T, np.broadcast_to(wide[:, :1], (size, 4))):
        for new, old in zip(rod_spring.averaged(view, *p), rod_spring.averaged(view.copy(), *p), strict=True):
            assert np.array_equal(new, old)


@pytest.mark.parametrize("size", [1, 100, 1000])
def test_out_and_in_place(size):
    p = rod_spring.coefficients(*DESIGN)
    A = np.random.default_rng(size).uniform(0.01, 1.2, size)
    h, h_A = rod_spring.averaged_2(A, *p)
    both = np.full((size, 2), np.nan)
    rod_spring.averaged_2(A, *p, out=(both[:, 0], both[:, 1]))
    assert np.array_equal(both, np.stack([h, h_A], axis=1))
    for order in (1, -1):  # the result over its own argument, and over its neighbour's
        place = A.copy()[::order].copy()
        other = np.empty(size)
        rod_spring.averaged_2(place, *p, out=(place, other))
        assert np.array_equal(place, h[::order])
        assert np.array_equal(other, h_A[::order])
    shifted = np.concatenate([A, [0.0]])
    expected = rod_spring.force(A, *p)
    rod_spring.force(shifted[:-1], *p, out=shifted[1:])
    assert np.array_equal(shifted[1:], expected)
    where = A > 0.5
    assert np.array_equal(rod_spring.force(A, *p, out=np.zeros(size), where=where), np.where(where, expected, 0))


def test_nan_passes_in_silence_and_invalid_arguments_do_not():
    """A NaN is no reason to warn, in any place of a block; the root of a negative number is."""
    p = rod_spring.coefficients(*DESIGN)
    A = np.random.default_rng(1).uniform(0.01, 1.2, 600)
    A[::7] = np.nan
    for values in (*rod_spring.averaged(A, *p), rod_spring.phase(0.9, A, 0.01, 0.02, *p)):
        assert np.array_equal(np.isnan(values), np.isnan(A))
    with pytest.raises(RuntimeWarning, match="invalid"):
        slow_flow.backbone(np.array([0.1, np.nan]), np.array([1.0, np.nan]))
    with pytest.raises(RuntimeWarning, match="divide"):
        slow_flow.backbone(0.0, -1.0)


def test_subnormal_numbers_stay():
    """A library built with fast-math would flush them for the whole process, or for threads started later."""
    seen = []

    def compute() -> None:
        tiny = np.full(4, 2.0**-1040)
        seen.append(bool(np.all(tiny * 2.0**-20 > 0) and np.all(tiny / 4 * 4 == tiny)))
        seen.append(float(slow_flow.R(1.0, 2.0**-1060, 0.0)) == 2.0**-1060)

    compute()
    thread = threading.Thread(target=compute)
    thread.start()
    thread.join()
    assert seen == [True] * 4


@pytest.mark.slow
@pytest.mark.parametrize("call", ["kernels", "solver"])
def test_others_run_meanwhile(call):
    """The interpreter is free during a call: this thread goes on counting while another one computes."""
    p = rod_spring.coefficients(*DESIGN)
    A = np.random.default_rng(0).uniform(0.01, 1.2, 2_000_000)
    h, h_A = rod_spring.averaged_2(A, *p)

    def compute() -> None:
        if call == "kernels":
            rod_spring.averaged(A, *p)
        else:
            roots.fold_roots(A, h, h_A, 0.01, 0.02)

    start = time.perf_counter()
    compute()
    single = time.perf_counter() - start
    other = threading.Thread(target=compute)
    other.start()
    longest, last = 0.0, time.perf_counter()
    while other.is_alive():
        now = time.perf_counter()
        longest, last = max(longest, now - last), now
    assert longest < 0.7 * single


def targets() -> list[str]:
    """Targets of gcc that this processor runs."""
    if (platform.system(), platform.machine()) != ("Linux", "x86_64") or shutil.which("gcc") is None:
        return []
    flags = set(Path("/proc/cpuinfo").read_text().split())
    wider = {"x86-64-v3": {"avx2", "fma", "bmi2"}, "x86-64-v4": {"avx512f", "avx512bw", "avx512vl", "avx512dq"}}
    return ["x86-64", *(target for target, needs in wider.items() if needs <= flags)]


@pytest.mark.slow
@pytest.mark.skipif(len(targets()) < 2, reason="one target only")
def test_every_clone_gives_the_same_bits(tmp_path):
    """Each target alone: without contraction wide vectors round as narrow ones do."""
    rng = np.random.default_rng(11)
    A, gamma, Omega = rng.uniform(0.01, 1.2, 1003), rng.uniform(0, 2.1, 1003), rng.uniform(0.1, 3, 1003)
    A[::50] = np.nan
    p = (0.5, 2.8, gamma, 0.4)
    calls = {
        **{("rod_spring", name): (A, *p) for name in ("averaged", "averaged_2", "harmonics", "force")},
        ("rod_spring", "coefficients"): (A, 2.0, rng.uniform(0.01, 0.3, 1003)),
        ("rod_spring", "saddle_nodes"): (0.04, 0.01, A, *p),
        ("slow_flow", "phase"): (Omega, A, 0.01, 0.02, -gamma),
        ("slow_flow", "jacobian"): (Omega, A, 0.01, 0.02, -gamma, 0.3),
    }
    modules = {module for module, _ in calls}
    built = {module: [clones.build(tmp_path, target, module) for target in targets()] for module in modules}
    for (module, name), columns in calls.items():
        first, *others = built[module]
        expected = first(name, columns)
        for clone in others:
            for x, y in zip(clone(name, columns), expected, strict=True):
                # a NaN's sign is nobody's
                assert np.array_equal(np.isnan(x), np.isnan(y)), name
                assert np.array_equal(x.view(np.int64)[~np.isnan(x)], y.view(np.int64)[~np.isnan(y)]), name


@pytest.mark.skipif(len(targets()) < 2, reason="one target only")
def test_clones_are_built_whatever_is_included_before():
    """glibc tells of itself in its own headers only: a file that includes none before had no clones."""
    source = '#include "clones.h"\nSF_WIDE void loop(void);'
    command = ["gcc", "-E", f"-I{NATIVE}", "-x", "c", "-"]
    assert "target_clones" in subprocess.run(command, input=source, capture_output=True, text=True, check=True).stdout


@pytest.mark.slow
def test_the_installed_clone_is_one_of_them(tmp_path):
    """The extension module's choice gives the bits of the baseline, built here."""
    if not targets():
        pytest.skip("no gcc for x86-64 Linux")
    baseline = clones.build(tmp_path, "x86-64")
    p = (0.5, 2.8, 2.1, 0.4)
    A = np.random.default_rng(12).uniform(0.01, 1.2, 1003)
    for x, y in zip(rod_spring.averaged(A, *p), baseline("averaged", (A, *p)), strict=True):
        assert np.array_equal(x, y)


@pytest.mark.parametrize("n", [1, 2, 3, 8, 17])
def test_large_numbers_raise_no_false_alarm(n):
    """Vectorised code may compute what it then leaves: no flag of it is NumPy's to report."""
    A = 10.0 ** np.linspace(0, 60, n)
    with np.errstate(all="raise"):
        for h in (-2.0, -1.0, -0.5, 0.0):
            phi = slow_flow.phase(0.8, A, 0.0, 0.02, h * A)
            np.testing.assert_allclose(phi, np.arctan2(-0.032, -(0.64 + h)), rtol=1e-15)


@pytest.mark.slow
def test_the_arctangent_polynomial_is_as_good_as_derived():
    """The derived bound against 50 digits, at 400 points."""
    polynomial = series()
    with mpmath.workdps(50):
        coefficients = [mpmath.mpf(str(coefficient.evalf(60))) for coefficient in polynomial.coefficients]
        worst = mpmath.mpf(0)
        for k in range(1, 401):
            t = mpmath.mpf(k) / 400
            value = t + t * mpmath.polyval(coefficients[::-1], t * t - mpmath.mpf(1) / 2)
            worst = max(worst, abs(value / mpmath.atan(t) - 1) * 2**53)
    assert 0 < worst <= float(polynomial.bound)
    assert polynomial.bound < Fraction(1, 16)


@pytest.fixture(scope="module")
def atan2(tmp_path_factory):
    """The generated arctangent, by itself: it has no symbol."""
    source = tmp_path_factory.mktemp("angles") / "angles.c"
    source.write_text('#include "angles.h"\ndouble called(double y, double x) { return angles_atan2(y, x); }\n')
    called = ctypes.CDLL(str(compiled(source.with_suffix(".so"), source, options=FLAGS))).called
    called.restype, called.argtypes = ctypes.c_double, [ctypes.c_double] * 2
    return called


def error_in_ulps(value: float, y: float, x: float) -> float:
    """Distance from the true angle in units of the value's last place."""
    with mpmath.workdps(50):
        return float(abs(mpmath.mpf(value) - mpmath.atan2(mpmath.mpf(y), mpmath.mpf(x))) / np.spacing(abs(value)))


@pytest.mark.slow
def test_arctangent_of_an_exact_quotient_is_within_one_unit(atan2):
    """x = 1: the quotient is exact, and what is left is the polynomial's error and four roundings."""
    rng = np.random.default_rng(3)
    points = [*rng.uniform(0, 1, 1500), *(1 - 10.0 ** rng.uniform(-16, -1, 300)), *(10.0 ** rng.uniform(-300, 0, 300))]
    assert max(error_in_ulps(atan2(t, 1.0), t, 1.0) for t in points) < 1


@pytest.mark.slow
def test_the_angle_is_right_to_one_and_a_half_units(atan2):
    """Half a unit more, for the quotient; in all quadrants."""
    rng = np.random.default_rng(4)
    points = rng.normal(size=(3000, 2)) * 10.0 ** rng.uniform(-3, 3, (3000, 2))
    assert max(error_in_ulps(atan2(y, x), y, x) for y, x in points) < 1.5


@pytest.mark.slow
def test_the_angle_of_zeros_infinities_and_nan(atan2):
    """As C99 says, signs of zeros included."""
    special = (0.0, -0.0, 1.0, -1.0, np.inf, -np.inf, 5e-324, -5e-324, 1e308, np.nan)
    for y in special:
        for x in special:
            new, old = atan2(y, x), math.atan2(y, x)
            if math.isnan(old):
                assert np.isnan(new)
            else:
                assert abs(new - old) <= np.spacing(abs(old))
                assert np.signbit(new) == np.signbit(old)


@pytest.mark.parametrize("module", ["slowflow_kernels._native", "slowflow._native", "slowflow._exact"])
def test_without_compiled_code_the_import_says_what_to_do(module):
    """Simulated: an extension module is not found."""
    code = f"import sys; sys.modules['{module}'] = None; from slowflow import Isolator"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 1
    assert "slowflow is not compiled here" in done.stderr and "make derive" in done.stderr


def test_a_build_for_another_processor_is_told(monkeypatch):
    """As of a checkout that was copied: what is wrong is not that nothing was compiled."""
    why = "they were compiled for a processor of x86-64-v4"

    def refused(name):
        raise ImportError(why)

    monkeypatch.setattr(support.importlib, "import_module", refused)
    with pytest.raises(ImportError, match=why):
        support.loaded.__wrapped__("slowflow._native")
