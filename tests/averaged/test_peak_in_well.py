"""A peak of a spring that gives way lies within its well: found by quadrature of the force and a scan of the plane."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy as sp

from slowflow import Duffing, derive
from slowflow.answers.results import Remark
from slowflow_kernels.conventions import Status
from tests.sampling import slow

A, W = np.linspace(2e-3, 1, 500), np.linspace(0.0, 1.3, 521)
#: midpoints of a quarter of a turn: of an even periodic function their mean is exact but for rounding
NODES = (np.arange(64) + 0.5) * math.pi / 128


def scanned(force, top, F_0, mu, zeta, eta=0.0, c_2=0.0, power=0):
    """The highest A below `top`, and its Omega, at which the least level over Omega rises through F_0; None without.

    The plane is scanned in cells of 1/500 of the well, the amplitude bisected between two rows. `force` is a function.
    """

    def least(a, w=W):
        push = force(np.multiply.outer(np.cos(NODES), a))
        h = -2 * (push * np.cos(NODES)[:, None]).mean(axis=0)
        turn = (8 / (3 * math.pi)) * c_2 * np.multiply.outer(a, w) ** 2
        R = np.multiply.outer(a, w**2) + h[:, None]
        lag = 2 * zeta * np.multiply.outer(a, w) + 4 * mu / math.pi + eta * a[:, None] + turn
        with np.errstate(divide="ignore"):
            level = np.hypot(R, lag) / w**power
        return level.min(axis=1), w[level.argmin(axis=1)]

    rows = top * A
    levels, at = least(rows)
    crossings = np.flatnonzero((levels[:-1] <= F_0) & (levels[1:] > F_0))
    if not crossings.size:
        return None
    last = int(crossings[-1])  # by a row or two, as the frequencies of the scan are coarse
    low, high, first = rows[max(last - 2, 0)], rows[min(last + 3, rows.size - 1)], at[last]
    for _ in range(30):
        middle, center = 0.5 * (low + high), first
        for width in (1e-2, 1e-3, 1e-4, 1e-5):
            w = np.linspace(max(center - width, 0.0 if power == 0 else 1e-9), center + width, 41)
            (level,), (center,) = least(np.array([middle]), w)
        low, high = (middle, high) if level <= F_0 else (low, middle)
    return 0.5 * (low + high), center


def cubic(u):
    return u - u**3


def draw(rng, power):
    """mu, zeta and a forcing of the order at which the response leaves the well of u - u^3, whose top is at 1."""
    mu, zeta = (rng.random() < 0.7) * 10 ** rng.uniform(-6, -1.5), 10 ** rng.uniform(-2, -0.4)
    F_0 = (4 * mu / math.pi + 2 * zeta) * rng.uniform(0.1, 1.3) * (2 if power else 1) + 1e-3
    return mu, zeta, min(F_0, 0.6) if power else F_0  # under inertia A tends to F_0, which is to lie in the well


def assert_is_scanned(peak, expected):
    if expected is None:
        assert peak.A is None and "no peak within the well" in peak.message and Remark.BEYOND_WELL in peak.remarks
    else:
        assert peak.A == pytest.approx(expected[0], rel=1e-6)
        assert peak.Omega == pytest.approx(expected[1], abs=2e-3)


@pytest.mark.parametrize("mu", [0.0, 1e-6, 0.005, 0.01, 0.02])
def test_softening_peak_moves_with_friction_without_a_jump(mu):
    """It was 0.313, 1.123, 1.125 and 0.176 at mu of 0, 1e-6, 0.01 and 0.02: a top of the curve that is not stable."""
    one = Duffing(1.0, -1.0, mu=mu, zeta=0.1)
    peak, expected = one.peak(0.06), scanned(cubic, 1.0, 0.06, mu, 0.1)
    assert_is_scanned(peak, expected)
    (stable,) = one.stability(Omega=[peak.Omega], A=[peak.A * (1 - 1e-6)])
    assert stable > 0
    assert Duffing.many(1.0, -1.0, mu=[mu], zeta=0.1).peak(0.06).A == pytest.approx([peak.A], rel=1e-12)


@pytest.mark.parametrize("excitation", ["force", *slow("unbalance")])
def test_peaks_within_a_well_are_those_of_a_scan_and_of_a_batch(excitation):
    rng, power = np.random.default_rng(35), 2 * (excitation != "force")
    drawn = np.array([draw(rng, power) for _ in range(20)])
    mu, zeta, F_0 = drawn.T
    peaks = Duffing.many(1.0, -1.0, mu=mu, zeta=zeta, excitation=excitation).peak(F_0)
    for k, (m, z, F) in enumerate(drawn):
        single = Duffing(1.0, -1.0, mu=m, zeta=z, excitation=excitation).peak(F)
        assert_is_scanned(single, scanned(cubic, 1.0, F, m, z, power=power))
        expected = (np.nan, Status.UNBOUNDED) if single.A is None else (single.A, Status.OK)
        assert (peaks.A[k], peaks.status[k]) == pytest.approx(expected, nan_ok=True, rel=1e-12)
        assert int(peaks.remarks[k]) == int(single.remarks)
    assert 0 < np.isnan(peaks.A).sum() < 20


def test_where_the_well_holds_no_top_there_is_none():
    """2.785 was answered, at Omega = 0: the average is 0 at A = sqrt(4/(3*0.175)) = 2.760, and pushes beyond."""
    one = Duffing(1.0, -0.175, zeta=0.001)
    peak = one.peak(0.05)
    assert peak.A is None and peak.Omega is None and "no peak within the well" in peak.message
    for force in (0.002, 0.05):
        expected = scanned(lambda u: u - 0.175 * u**3, math.sqrt(1 / 0.175), force, 0.0, 0.001)
        assert (one.peak(force).A is None) == (expected is None)
    assert np.isnan(peak.gradient()["A"]).all()


@pytest.mark.parametrize(("damping", "F_0"), [({"eta": 0.1}, 0.05), ({"eta": 0.1}, 0.105), ({"c_2": 0.2}, 0.03)])
def test_by_other_laws_of_damping_too(damping, F_0):
    """By structural damping alone the level rises with A up to where the average is 0, beyond the well's top."""
    laws = {"mu": 0.005, "zeta": 0.0, **damping}
    assert_is_scanned(Duffing(1.0, -1.0, **laws).peak(F_0), scanned(cubic, 1.0, F_0, **laws))
    assert_is_scanned(Duffing(1.0, -1.0, **laws).peak(0.02), scanned(cubic, 1.0, 0.02, **laws))


@pytest.mark.slow
@pytest.mark.parametrize("compiled", [False, True])
def test_of_a_force_of_ones_own_in_pieces_too(compiled):
    """A spring that a second one pulls apart beyond u = 0.4, with the top at 0.4 + 0.4/0.5 = 1.2."""
    u, k = sp.symbols("u k", positive=True)
    stated = [(k * u, sp.Rational(2, 5)), (sp.Rational(3, 5) - u / 2, None)]
    made = derive.mechanism(f"pulled_apart_{compiled}", stated, {"k": {"above": 0}}, compile=compiled)

    def force(x):
        return np.sign(x) * np.where(np.abs(x) < 0.4, np.abs(x), 0.6 - np.abs(x) / 2)

    for mu, zeta, F_0 in ((0.0, 0.05, 0.03), (0.004, 0.05, 0.03), (0.004, 0.05, 0.055), (0.01, 0.05, 0.2)):
        peak, expected = made(k=1.0, mu=mu, zeta=zeta).peak(F_0), scanned(force, 1.2, F_0, mu, zeta)
        if expected is None:
            assert peak.A is None and "no peak within the well" in peak.message
        else:  # the force has corners, of which a mean of 64 values has four digits
            assert peak.A == pytest.approx(expected[0], rel=2e-3)
