"""Isolators with force="untruncated": folds, onset and detachment against solutions in 420 bits and proofs."""

from __future__ import annotations

import importlib.util

import numpy as np
import pytest
from mpmath import mp, mpf

from slowflow import Isolator
from slowflow.answers.results import Remark
from slowflow_kernels import rod_spring_untruncated
from tests.oracles import kernels
from tests.oracles.answers import Nearby, errors
from tests.sampling import slow

DIGITS = 30


def designs(count: int) -> list[dict[str, float]]:
    """Seeded isolators: up to 2 in stiffness taken away, small and large preload."""
    rng = np.random.default_rng(20250408)
    found = []
    for _ in range(count):
        delta_h = float(rng.uniform(0.02, 0.6))
        lam = int(rng.integers(1, 5))
        r = float(rng.uniform(0.2, 1.1)) / (lam * delta_h)
        found.append(
            {
                "lam": lam,
                "r": r,
                "delta_h": delta_h,
                "mu": float(rng.uniform(0, 0.012)),
                "zeta": float(rng.uniform(0.01, 0.04)),
            }
        )
    return found


DESIGNS = designs(20)


def forcing(F_cr: float, F_SN: float | None, m: float) -> list[float]:
    return [F_0 for F_0 in (0.9 * F_cr, 1.1 * F_cr, 1.6 * F_cr) if F_SN and F_0 > max(F_SN, m)]


@pytest.mark.slow
@pytest.mark.parametrize("k", range(len(DESIGNS)))
@pytest.mark.part(3)
def test_untruncated_answers_are_exact_and_complete(k):
    """Against solutions in 420 bits, whose averages `test_stability` holds against quadratures; as many as proved."""
    design = DESIGNS[k]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("warnings.warn", lambda *_, **__: None)  # of a negative stiffness at rest
        isolator, nearby = Isolator(**design, force="untruncated"), Nearby("rod_spring_untruncated", **design)
        detachment, onset = isolator.detachment(), isolator.saddle_node_onset()
        least, _ = nearby.solution("detachment", detachment.Omega_cr, None, detachment.F_cr)
        assert detachment.Omega_cr == pytest.approx(float(least.Omega.mid()), rel=1e-12)
        assert detachment.u_cr == pytest.approx(float(least.A.mid()), rel=4e-16)
        found = [(detachment, "detachment", {}), (onset, "saddle_node_onset", {})]
        for F_0 in forcing(detachment.F_cr, onset.F_SN, isolator.sticking_forcing):
            folds = isolator.saddle_nodes(F_0, certify=True)
            assert not folds.corner.any()
            assert folds.proof.proved and len(folds) == len(folds.proof.A)
            found += [(fold, "saddle_nodes", {"F_0": F_0}) for fold in folds]
        for one, question, query in found:
            assert max(rounding for _, rounding in errors(one, nearby, question, query).values()) <= 2, question


def test_no_preload_is_linear():
    isolator = Isolator(lam=3, r=2.0, delta_h=0.0, mu=0.01, zeta=0.02, force="untruncated")
    A = np.array([1e-3, 0.4, 2.0])
    np.testing.assert_allclose(isolator.backbone(A), 1.0, rtol=1e-15)
    assert isolator.saddle_node_onset().F_SN is None


def test_quasi_zero_stiffness_keeps_its_digits():
    """lam r delta_h = 1: h falls as A^3, -(3/4) beta A^3 (1 + (5/8) A^2 (1 + ...))."""
    alpha, beta, delta_h = rod_spring_untruncated.coefficients(4.0, 2.0, 0.125)
    assert alpha == 0
    A = np.array([1e-8, 1e-5, 1e-3])
    np.testing.assert_allclose(
        rod_spring_untruncated.h(A, alpha, beta, delta_h), -0.75 * beta * A**3 * (1 + 0.625 * A**2), rtol=1e-12
    )


def test_the_force_must_be_known():
    with pytest.raises(ValueError, match="force"):
        Isolator(lam=3, r=2.0, delta_h=0.1, force="exact")
    with pytest.raises(ValueError, match="force"):
        Isolator.many(lam=3, r=2.0, delta_h=0.1, force="")


#: where 1 - u_cr, which is (1 - delta_h)^2/2, is next to nothing
STEEP = (0.98, 0.99, 1 - 1e-4, 1 - 1e-6, 1 - 1e-9, 1 - 2.0**-52)
#: of these, the fast tests have one next to the length of the rod
STEEP_FEW = [*slow(*STEEP[:4]), STEEP[4], *slow(*STEEP[5:])]
ROUNDING = 2.0**-53


def amplitudes_about(u_cr: float, c: float) -> list[float]:
    """Below u_cr, next to it, between it and 1, and above; the last where A^2 - u_cr^2 is a fraction of 1 - u_cr^2."""
    below = [u_cr * ratio for ratio in (1e-3, 0.3, 0.69, 0.71, 0.99, 1 - 1e-6, 1 - 1e-9)]
    above = [u_cr * (1 + ratio) for ratio in (1e-14, 1e-12, 1e-9, 1e-6, 1e-3, 0.049, 0.051, 0.5, 3.0)]
    between = [float(np.sqrt(1 - c**2 * (1 - ratio))) for ratio in (0.01, 0.1, 0.24, 0.26, 0.9, 1.1, 3.0)]
    neighbours = [float(np.nextafter(u_cr, end)) for end in (0.0, 2.0)]
    return [*below, *neighbours, *between, *above]


@pytest.mark.parametrize("delta_h", STEEP_FEW)
def test_averages_keep_digits_as_preload_nears_the_rods_length(delta_h):
    """h to 13 places at amplitudes that are not next to u_cr; with its derivatives to the target of all kernels."""
    p = tuple(float(value) for value in rod_spring_untruncated.coefficients(1.0, 1.25, delta_h))
    (u_cr,) = map(float, rod_spring_untruncated.breakpoints(*p))
    names = ("A", "alpha", "beta", "delta_h")
    for A in (u_cr, *amplitudes_about(u_cr, 1 - delta_h)):
        exact, scales = kernels.values("rod_spring_untruncated", "averaged", names, (A, *p))
        found = rod_spring_untruncated.averaged(A, *p)
        for value, true, scale in zip(found, exact, scales, strict=True):
            assert abs(mpf(float(value)) - true) <= 4 * ROUNDING * scale, A
        if abs(A - u_cr) > 2.0**-51:
            assert abs(mpf(float(found[0])) - exact[0]) <= 1e-13 * abs(exact[0]), A


@pytest.mark.parametrize("delta_h", STEEP)
def test_the_double_next_to_u_cr_stands_for_u_cr(delta_h):
    """h there is that of an amplitude which no double is, by the complete elliptic integrals at c = 1 - delta_h."""
    p = rod_spring_untruncated.coefficients(1.0, 1.25, delta_h)
    with mp.workdps(DIGITS):
        alpha, beta, c = mpf(float(p[0])), mpf(float(p[1])), 1 - mpf(delta_h)
        m = (1 - c) * (1 + c)
        steep = (mp.ellipk(m) - mp.ellipe(m)) / m
        exact = -mp.sqrt(m) * (alpha - 2 * beta + 8 * beta / mp.pi * steep)
        found = rod_spring_untruncated.h(rod_spring_untruncated.breakpoints(*p)[0], *p)
        assert abs(mpf(float(found)) - exact) <= 1e-14 * abs(exact)


def steep_isolator(delta_h: float) -> Isolator:
    """With folds, an onset and a detachment on either side of u_cr."""
    return Isolator(lam=1, r=0.3, delta_h=delta_h, mu=0.01, zeta=0.02, force="untruncated")


@pytest.mark.slow
@pytest.mark.parametrize("delta_h", [1 - 1e-9, 1 - 2.0**-52])
def test_onset_between_doubles_is_proved_in_balls_or_refused(delta_h, monkeypatch):
    """About 20 (1 - delta_h)^2 below 1: neither a wrong onset nor none.

    Its level is the least along the fold locus, which goes through A = u_cr = 1 but for that: bisecting F_A there.
    """
    if importlib.util.find_spec("flint") is not None:
        found, iso = steep_isolator(delta_h).saddle_node_onset(), steep_isolator(delta_h)
        assert found.kind == "cusp" and Remark.BY_BALLS in found.remarks
        assert found.A == pytest.approx(iso.breakpoints[0], rel=4e-16)
        assert len(iso.saddle_nodes(found.F_SN * (1 - 1e-9))) == 0
        assert len(iso.saddle_nodes(found.F_SN * (1 + 1e-6))) == 2
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    with pytest.raises(ArithmeticError, match="unresolved"):
        steep_isolator(delta_h).saddle_node_onset()
