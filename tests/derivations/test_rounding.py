"""Proved bounds of rounding errors: against errors measured at the worst points that a search found; what has none."""

from __future__ import annotations

import dataclasses

import pytest
import sympy as sp

from benchmarks.stress import baseline
from derivations.codegen import measured, proved, rounding
from derivations.codegen.passes import straight_line
from tests.oracles import kernels as exact

A, B = sp.symbols("A B", real=True)


@pytest.fixture(scope="module")
def of_kernels(modules, code):
    """The largest stored bound of each kernel whose outputs are all proved in every branch."""
    found = {}
    for module in modules:
        for kernel in module.kernels:
            of_kernel = code[module.name][kernel.name]
            stored = [proved.stored().get(proved.digest(one, kernel.arguments)) for one in of_kernel]
            shown = [k for one in stored for k in (one["k"] if one else [None])]
            if None not in shown:
                found[module.name, kernel.name] = max(map(float, shown))
    return found


@pytest.mark.slow
def test_stored_bounds_are_of_the_programs_that_there_are(modules, code):
    digests = {
        proved.digest(program, kernel.arguments)
        for module in modules
        for kernel in module.kernels
        for program in code[module.name][kernel.name]
    }
    assert proved.stored().keys() <= digests


@pytest.mark.slow
@pytest.mark.parametrize("name", ["slow_flow", "duffing"])
def test_stored_bounds_are_what_is_proved(modules, name):
    (module,) = (module for module in modules if module.name == name)
    for key, value in rounding.proved_of(module).items():
        kept = proved.stored()[key]
        for k, known in zip(value["k"], kept["k"], strict=True):
            assert (k is None) == (known is None), kept["kernel"]
            # another version of the linear program's solver may end a hundredth away
            assert k is None or float(k) <= float(known) + 0.02, kept["kernel"]


@pytest.mark.slow
def test_no_error_that_was_found_exceeds_a_proved_bound(of_kernels):
    """The worst points of `make stress`, compiled and NumPy, against another oracle and by another way."""
    rows = baseline.stored()["kernels"]
    compared = 0
    for row in rows:
        if (row["module"], row["kernel"]) not in of_kernels:
            continue
        for error in row["errors"].values():
            # exact values are stored with 40 digits
            assert error is None or float(error) <= of_kernels[row["module"], row["kernel"]] + 1e-20, row
            compared += 1
    assert compared > 100


def test_a_form_that_cancels_has_no_bound():
    """The square of a difference, expanded: next to A = B all digits are lost, though it is well-conditioned there."""
    expanded = straight_line([], [A**2 - 2 * A * B + B**2], (A, B))
    whole = straight_line([], [(A - B) ** 2], (A, B))
    assert rounding.bounds(expanded, (A, B)) == [None]
    (k,) = rounding.bounds(whole, (A, B))
    assert k is None or k > 1


def test_the_bound_of_a_sum_is_no_more_than_its_terms():
    """fl(A + B) errs by u |A + B|, which is counted as |A| + |B|: what rounding the arguments may cost."""
    (k,) = rounding.bounds(straight_line([], [A + B], (A, B)), (A, B))
    assert k == pytest.approx(1, abs=0.02)


def test_a_quotient_counts_its_division():
    (k,) = rounding.bounds(straight_line([], [1 / A], (A, B)), (A, B))
    assert k == pytest.approx(0.5, abs=0.02)


@pytest.mark.slow
def test_every_kernel_has_a_bound_that_is_proved_or_measured(modules, of_kernels):
    # integrals over densities define these, which no search for the worst point affords: the oracle's points hold them
    for module in (one for one in modules if one.name != "linearization"):
        named = (*module.kernels, *module.twofolds, *module.selections, *module.compositions)
        # private ones are what the means of offset motion are sums of, which are judged as such
        named = tuple(one for one in named if getattr(one, "width", 1) > 0 and not one.name.startswith("_"))
        # kernels of gradients are judged by differences of answers
        bounded = of_kernels.keys() | {(module.name, kernel) for kernel in measured.of(module).kernels}
        lacking = {kernel.name for kernel in named if (module.name, kernel.name) not in bounded}
        assert all(exact.is_of_gradients(kernel) for kernel in lacking), lacking


@pytest.mark.slow
def test_oscillator_derived_at_run_time_has_no_measured_bounds(modules):
    (module,) = (module for module in modules if module.name == "duffing")
    assert measured.of(module).kernels
    assert not measured.of(dataclasses.replace(module, inputs=(measured.AT_RUNTIME,))).kernels


@pytest.mark.parametrize(("error", "shown"), [(0.0, "0"), (1.01, "1.1"), (1.1, "1.1"), (0.0123, "0.013"), (18.2, "19")])
def test_errors_in_headers_are_rounded_up(error, shown):
    assert measured.shown(error) == shown
