"""The kernels on JAX: values are those on NumPy, and its derivatives those that the derivation gives."""

import importlib
import inspect
import pkgutil

import numpy as np
import pytest

import slowflow_kernels
from slowflow.support.errors import Refused
from slowflow.support.in_jax import in_jax
from slowflow_kernels import duffing, rod_spring, rod_spring_untruncated
from tests.backends import as_rows

jax = pytest.importorskip("jax", reason="JAX is not installed")
MODULES = [
    module
    for found in pkgutil.iter_modules(slowflow_kernels.__path__, "slowflow_kernels.")
    if not found.name.rpartition(".")[2].startswith("_")
    and not found.name.endswith(("_balls", "_intervals"))
    and hasattr(module := importlib.import_module(found.name), "__all__")
]


@pytest.fixture(autouse=True)
def doubles():
    with jax.enable_x64(True):
        yield


def test_32_bits_are_refused():
    with jax.enable_x64(False), pytest.raises(Refused, match="32 bits"):
        in_jax(duffing).h(0.5, 1.0, 2.0, 0.1)


@pytest.mark.night
@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.__name__.rpartition(".")[2])
@np.errstate(all="ignore")
def test_values_on_jax_are_those_on_numpy(module):
    rng = np.random.default_rng(1)
    for name, kernel in vars(in_jax(module)).items():
        arguments = rng.uniform(0.1, 0.9, (len(inspect.signature(kernel).parameters), 3))
        try:
            expected = getattr(module, name)(*arguments)
        except (TypeError, ValueError):  # of other things than numbers
            continue
        for ours, one in zip(as_rows(kernel(*arguments)), as_rows(expected), strict=True):
            np.testing.assert_allclose(ours, one, rtol=1e-9, atol=1e-12, err_msg=name)


@pytest.mark.parametrize(
    ("module", "design"),
    [(duffing, (1.0, 2.0, 0.5)), (rod_spring, (3.0, 2.0, 0.08)), (rod_spring_untruncated, (3.0, 2.0, 0.08))],
    ids=["duffing", "rod_spring", "untruncated"],
)
def test_derivatives_are_those_of_the_derivation(module, design):
    """In every regime: no other one's root of a negative number makes them NaN."""
    p = [float(one) for one in module.coefficients(*design)]
    A = np.array([0.05, 0.3, 0.395, 0.41, 0.6, 0.9])
    slopes = jax.grad(lambda A: in_jax(module).h(A, *p).sum())(A)
    np.testing.assert_allclose(slopes, module.h_A(A, *p), rtol=1e-11)
