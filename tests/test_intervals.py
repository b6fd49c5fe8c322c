"""Kernels on intervals: what they return holds the exact values at a point, and the values all over a box."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from slowflow.averaged.reference.intervals import Interval
from slowflow_kernels import (
    slow_flow,
    slow_flow_intervals,
    slow_flow_mu0,
    slow_flow_mu0_intervals,
    slow_flow_zeta0,
    slow_flow_zeta0_intervals,
)

ORACLE = json.loads((Path(__file__).parent / "data" / "kernel_oracle.json").read_text())
PAIRS = {
    "slow_flow": (slow_flow_intervals, slow_flow),
    "slow_flow_mu0": (slow_flow_mu0_intervals, slow_flow_mu0),
    "slow_flow_zeta0": (slow_flow_zeta0_intervals, slow_flow_zeta0),
}
KERNELS = [(module, kernel) for module, (own, _) in PAIRS.items() for kernel in own.__all__]


def enclosures(module, kernel, boxes):
    found = getattr(PAIRS[module][0], kernel)(*boxes)
    return found if isinstance(found, tuple) else (found,)


@pytest.mark.parametrize(("module", "kernel"), KERNELS)
def test_the_exact_values_at_a_point_are_held(module, kernel):
    for row in ORACLE[module][kernel]:
        found = enclosures(module, kernel, [Interval.point(x) for x in row["at"]])
        assert len(found) == len(row["is"])
        for interval, value, scale in zip(found, row["is"], row["scale"], strict=True):
            lo, hi = Fraction(float(interval.lo[0])), Fraction(float(interval.hi[0]))
            printed = Fraction(scale) / 10**38  # the oracle has 40 digits
            assert lo - printed <= Fraction(value) <= hi + printed
            # and little else: as many roundings as there are operations
            assert hi - lo <= Fraction(1, 2**44) * Fraction(scale)


@pytest.mark.parametrize(("module", "kernel"), KERNELS)
def test_the_values_all_over_a_box_are_held(module, kernel):
    rng = np.random.default_rng(20261121)
    plain = getattr(PAIRS[module][1], kernel)
    for row in ORACLE[module][kernel]:
        at = np.array(row["at"])
        for width in (1e-6, 1e-2, 0.3):
            other = at * (1 + width)
            boxes = [Interval.hull(np.array([a]), np.array([b])) for a, b in zip(at, other, strict=True)]
            inside = at[:, np.newaxis] + (other - at)[:, np.newaxis] * rng.random((len(at), 40))
            with np.errstate(all="ignore"):  # outside of its domain a value is NaN
                values = np.atleast_2d(np.asarray(plain(*inside)))
            for interval, value, size in zip(enclosures(module, kernel, boxes), values, row["scale"], strict=True):
                rounding = 2.0**-48 * (np.abs(value) + float(size))
                held = (interval.lo[0] <= value + rounding) & (value - rounding <= interval.hi[0])
                assert (held | np.isnan(value)).all()


@np.errstate(all="ignore")
def test_an_unknown_interval_proves_nothing():
    unknown, one = Interval.point(np.nan), Interval.point(1.0)
    for result in (unknown + one, one * unknown, unknown.square(), one / unknown, unknown.sqrt(), -unknown):
        assert not result.has_sign.any()
    wide = Interval.of(-np.inf, np.inf)
    assert not (wide * Interval.point(0.0)).has_sign.any() and not (one / Interval.of(-1.0, 1.0)).has_sign.any()
