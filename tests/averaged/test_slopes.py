"""What the lanes of folds and cusps state in C of derived functions: their terms, by the kernels."""

from __future__ import annotations

import pytest

from slowflow_kernels import slow_flow


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
