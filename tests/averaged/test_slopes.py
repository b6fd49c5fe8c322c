"""The level along the fold locus: its derived second derivative against the locus itself, traced as roots."""

from __future__ import annotations

import pytest
from mpmath import mp, mpf

from slowflow_kernels import slow_flow

OMEGA, A, M, ZETA = mpf(0.75), mpf(0.625), mpf(0.015625), mpf(0.0625)


def squared_level(w, a, h):
    """R^2 + I^2 (23)."""
    return (a * w**2 + h(a)) ** 2 + (2 * ZETA * a * w + M) ** 2


def taylor(values):
    return lambda a: sum(value * (a - A) ** k / mp.factorial(k) for k, value in enumerate(values))


def at_a_cusp() -> list:
    """h and its derivatives at A for which F_A = F_AA = 0."""
    h, h_AAA = mpf("-0.3"), mpf("1.3")

    def slopes(h_A, h_AA):
        return [mp.diff(lambda a: squared_level(OMEGA, a, taylor((h, h_A, h_AA))), A, n) for n in (1, 2)]

    return [h, *mp.findroot(slopes, (mpf(-1), mpf(0))), h_AAA]


def at_an_isola_point() -> list:
    """The same for F_A = F_Omega = 0."""

    def slopes(h, h_A):
        return [mp.diff(lambda a, w: squared_level(w, a, taylor((h, h_A))), (A, OMEGA), by) for by in ((1, 0), (0, 1))]

    return [*mp.findroot(slopes, (mpf("-0.4"), mpf(1))), mpf("0.7"), mpf("1.3")]


def traced(h):
    """The squared level along the fold locus as a function of A, and F_AOmega at the point."""

    def level(a):
        Omega = mp.findroot(lambda w: mp.diff(lambda b: squared_level(w, b, h), a), OMEGA)
        return squared_level(Omega, a, h)

    return level, mp.diff(lambda a, w: squared_level(w, a, h), (A, OMEGA), (1, 1))


@pytest.mark.parametrize(("point", "kernel"), [(at_a_cusp, "cusp"), (at_an_isola_point, "isola")])
def test_second_level_derivative_along_the_fold_locus(point, kernel):
    with mp.workdps(60):
        values = point()
        level, F_AOmega = traced(taylor(values))
        expected = mp.diff(level, A, 2) * F_AOmega**2
        if kernel == "cusp":
            T = OMEGA**2 + values[1]
            found = slow_flow.cusp_bend(*map(float, (OMEGA, A, ZETA, *values[2:], T))) * float(A)
        else:
            found = slow_flow.isola_bend(*map(float, (OMEGA, A, M, ZETA, values[2])))
    assert found == pytest.approx(float(expected), rel=1e-12)


def test_level_slope_along_the_fold_locus():
    """At a fold that is neither a cusp nor an isola point."""
    with mp.workdps(60):
        h, h_AA = mpf(-0.3), mpf(0.7)
        h_A = mp.findroot(lambda x: mp.diff(lambda a: squared_level(OMEGA, a, taylor((h, x))), A), mpf(-1))
        values = [h, h_A, h_AA]
        level, F_AOmega = traced(taylor(values))
        expected = mp.diff(level, A) * F_AOmega**2
        found = slow_flow.level_rise(*map(float, (OMEGA, A, M, ZETA, *values)))
    assert abs(expected) > 1e-4
    assert found == pytest.approx(float(expected), rel=1e-12)


@pytest.mark.parametrize(("h", "h_AA"), [(-0.3, -0.4), (-0.9, 0.4)])
def test_lane_bounds_of_a_cusp_are_the_derived_terms(h, h_AA):
    """The forms that solver/cusp_lanes.c states of F_A/2, of its slope's factors and of the forcing, where F_AA = 0."""
    a, m, zeta, h_A, h_AAA = 0.625, 0.015625, 0.0625, -0.9, 1.3
    k = h - a * h_A
    half_e, _, _, _, square = slow_flow.cusps(a, zeta, h, h_A, h_AA, k)
    roots = [sign * square**0.5 for sign in (1, -1)]
    seen = 0
    for root in roots:
        T = root - half_e
        X = T - h_A
        if X <= 0:
            continue
        seen += 1
        value, _, slope, level = slow_flow.cusp(a, m, zeta, h_AA, h_AAA, k, X, T, k + a * T, root)
        t, kappa, rho, w = T / (a * h_AA), k / (a**2 * h_AA), a * h_AAA / h_AA, X**0.5
        P, Q = a**3 * h_AA**2, 2 * m * zeta * w
        assert value == pytest.approx(P * ((kappa - 1) * (t - 1) - 1) + Q, rel=1e-12)
        assert level**2 == pytest.approx(m**2 + a * Q + a * P * kappa * (kappa + t), rel=1e-12)
        factors = (rho * (kappa + t) + 3 * t) * (kappa + 2 * t + (m * zeta / (a * w) + 4 * zeta**2) / (a * h_AA))
        assert slope == pytest.approx(-(a**3) * h_AA**3 * factors / (2 * root), rel=1e-12)
    assert seen > 0


@pytest.mark.parametrize("m", [0.0, 0.015625])
@pytest.mark.parametrize("k", [-0.25, 0.25])
def test_lane_bounds_of_a_fold_are_the_derived_terms(m, k):
    """The forms that solver/fold_lanes.c states of the function whose zeros are folds and of its slope; k at a fold."""
    a, F_0, zeta, h, h_A, k_A = 0.625, 0.1875, 0.0625, -0.3, -0.9, 1.3
    value, slope, Omega = slow_flow.fold(a, F_0, m, zeta, h, h_A, k, k_A)
    excess = F_0**2 - m**2
    cosine = (1 - excess / k**2) ** 0.5
    J, of_zeta = excess / (F_0 + m * cosine), 1 / zeta**2
    lag = J * cosine
    inert, rate, force = of_zeta * lag**2 / (4 * a), of_zeta * J / (2 * k * a), (F_0 + m / cosine) / excess
    assert value == pytest.approx(h - F_0 * J / k + inert, rel=1e-12)
    assert slope == pytest.approx(h_A - inert / a + F_0 * (J / k) ** 2 * (rate + force) * k_A, rel=1e-12)
    found = 2 * zeta * a * Omega
    by_Omega = F_0 * found / (excess - m * found)
    assert excess**0.5 / (1 - by_Omega**2) ** 0.5 == pytest.approx(abs(k), rel=1e-12)
