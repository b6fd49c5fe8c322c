"""Records put together or changed by hand: they answer for themselves, and stay what they are through pickle."""

from __future__ import annotations

import dataclasses
import pickle

import numpy as np
import pytest
from numpy.testing import assert_allclose

from slowflow.core.mechanism import Law, Mechanism
from slowflow.oscillators.oscillator import Oscillator
from slowflow_kernels import duffing, rod_spring, rod_spring_untruncated
from slowflow_kernels.conventions import Status


def _doubled(A, alpha, beta, gamma):
    return duffing.MECHANISM.averaged(A, alpha, 2 * beta, gamma)


def _doubled_harmonics(A, alpha, beta, gamma):
    return duffing.MECHANISM.harmonics(A, alpha, 2 * beta, gamma)


def _doubled_intercept(A, alpha, beta, gamma):
    return duffing.MECHANISM.intercept(A, alpha, 2 * beta, gamma)


def _doubled_coefficients(alpha, beta, gamma):
    return alpha, 2 * beta, gamma


def test_a_record_that_was_changed_answers_for_itself():
    """Of the same name as a compiled one; its own functions count, singly, in batches and after pickle."""
    of_force = {"averaged": _doubled, "harmonics": _doubled_harmonics, "intercept": _doubled_intercept}
    for changed in (
        dataclasses.replace(duffing.MECHANISM, **of_force),
        dataclasses.replace(duffing.MECHANISM, coefficients=_doubled_coefficients),
    ):
        numbers = {"beta": 0.3, "gamma": 0.1, "mu": 0.01, "zeta": 0.05}
        expected = Oscillator(duffing.MECHANISM, alpha=1.0, **{**numbers, "beta": 0.6})
        kept = pickle.loads(pickle.dumps(changed))
        assert kept == changed != duffing.MECHANISM
        assert hash(kept) == hash(changed)
        for mechanism in (changed, kept):
            found = Oscillator(mechanism, alpha=1.0, **numbers).saddle_nodes(0.4)
            assert_allclose(found.Omega, expected.saddle_nodes(0.4).Omega, rtol=1e-13)
            assert "not measured" in str(found.validity)
            many = Oscillator.many(mechanism, alpha=np.array([1.0]), **numbers).saddle_node_onset()
            assert_allclose(many.F_SN, [expected.saddle_node_onset().F_SN], rtol=1e-13)


def test_a_record_of_ones_own_is_pickled_by_its_functions():
    """It needs no module that states it, as long as its functions have names there."""
    stated = {field.name: getattr(duffing.MECHANISM, field.name) for field in dataclasses.fields(Mechanism)}
    law = Law(_doubled_coefficients, _doubled_coefficients)
    named = ("averaged", "harmonics", "intercept", "breakpoints", "jumps", "hardening")
    own = Mechanism(**{**stated, "pieces": (law,), **dict.fromkeys(named, _doubled), "load_untruncated": None})
    assert pickle.loads(pickle.dumps(own)) == own
    assert pickle.loads(pickle.dumps(duffing.MECHANISM)) is duffing.MECHANISM


def _zero_over_zero(A, *parameters):
    """Right wherever A > 0."""
    A = np.asarray(A, dtype=float)
    with np.errstate(invalid="ignore"):
        own = A / A
    return tuple(own * value for value in duffing.MECHANISM.averaged(A, *parameters))


def _without_alpha_at_rest(A, alpha, *others):
    """As where the limit is stated as a special case, wrong."""
    at = np.asarray(A, dtype=float) > 0
    return duffing.MECHANISM.averaged(A, np.where(at, alpha, 0.0), *others)


def _with_a_step_at_rest(A, *parameters):
    h, *slopes = duffing.MECHANISM.averaged(A, *parameters)
    return h - np.where(np.asarray(A, dtype=float) > 0, 0.0, 0.25), *slopes


@pytest.mark.parametrize(
    ("averaged", "message"),
    [
        (_zero_over_zero, "h = nan there"),
        (_without_alpha_at_rest, "h_A = -0 there, while .* df/du = 1"),
        (_with_a_step_at_rest, r"h = -0.25 there, while its force has f\(0\) = 0"),
    ],
)
def test_a_record_that_does_not_hold_at_rest_is_refused(averaged, message):
    """Its folds and onsets were computed with a wrong stiffness at rest."""
    wrong = dataclasses.replace(duffing.MECHANISM, averaged=averaged)
    numbers = {"alpha": 1.0, "beta": 0.3, "gamma": 0.1, "mu": 0.01, "zeta": 0.05}
    with pytest.raises(ValueError, match=f"the record of duffing does not hold at A = 0: averaged gives {message}"):
        Oscillator(wrong, **numbers)
    assert Oscillator.many(wrong, **numbers).saddle_node_onset().status == Status.INVALID


@pytest.mark.parametrize("delta_h", [0.0, 1e-300, 0.3, 1 - 1e-12])
def test_a_record_that_was_changed_elsewhere_is_not_refused(delta_h):
    """Of delta_h = 0 the first piece has no extent; next to 1 that piece is as steep as 1/(1 - delta_h)."""
    for shipped in (rod_spring.MECHANISM, rod_spring_untruncated.MECHANISM):
        changed, numbers = dataclasses.replace(shipped, title="another"), {"lam": 1.0, "r": 0.3, "delta_h": delta_h}
        assert Oscillator(changed, **numbers, mu=0.01, zeta=0.05).model.preload == 0
