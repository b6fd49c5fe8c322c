"""A design whose load is 0, in a batch with loads, is answered as that design alone: about the centre."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

from slowflow import Duffing
from slowflow_kernels.conventions import Status
from tests.batch_questions import OFF_CENTRE, ask, columns
from tests.test_many_as_each import ANSWERED, of_single

#: what dissipates, by what excites: an excitation by inertia takes some damping beside friction
DAMPING = {"viscous": {}, "friction alone": {"zeta": 0.0}, "structural": {"eta": 0.05}, "quadratic": {"c_2": 0.2}}
CASES = [(excitation, told) for excitation in ("force", "base", "unbalance") for told in DAMPING]
CASES = [case for case in CASES if case == ("force", "friction alone") or case[1] != "friction alone"]
#: which mean the motion of least damping answers there, and what no single oscillator has
NOT_OF_ONE = ("status", "B")


def drawn(count):
    rng = np.random.default_rng(12)
    given = {"alpha": rng.uniform(-0.5, 2, count), "beta": rng.uniform(-1, 3, count)}
    given |= {"mu": rng.uniform(0, 0.02, count) * (np.arange(count) % 2), "zeta": rng.uniform(0.01, 0.2, count)}
    return given, 10 ** rng.uniform(-1.7, 0, count)


@pytest.mark.parametrize("question", OFF_CENTRE)
@pytest.mark.parametrize(("excitation", "damping"), CASES)
@pytest.mark.part(5)
def test_a_load_of_0_is_no_load(excitation, damping, question):
    if question in ("transient", "shock_spectrum") and damping == "structural":
        pytest.skip("structural damping is stated at one frequency")
    count = 2 if damping in ("structural", "quadratic") else 5
    given, F_0 = drawn(count)
    given |= {name: np.full(count, value) for name, value in DAMPING[damping].items()}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = ask(Duffing.many(**given, excitation=excitation, load=np.zeros(count)), question, F_0)
        for k in range(count):
            try:
                numbers = {name: float(value[k]) for name, value in given.items()}
                single = ask(Duffing(**numbers, excitation=excitation), question, float(F_0[k]))
            except (ValueError, ArithmeticError):
                assert not np.isin(np.atleast_1d(found.status[k]), ANSWERED).any()
                continue
            if question != "spectrum":
                assert int(found.remarks[k]) == int(getattr(single, "remarks", 0))
            for name, column in columns(found).items():
                value = None if name in NOT_OF_ONE else of_single(single, name, question)
                if value is None:
                    continue
                expected = np.atleast_1d(np.asarray(value, dtype=float))
                told = np.atleast_1d(np.asarray(column[k], dtype=float))[: expected.size]
                np.testing.assert_allclose(told, expected, rtol=1e-12, err_msg=f"{name} of design {k}")
            if "B" in columns(found):
                told = np.atleast_1d(found.B[k])
                assert (told[~np.isnan(told)] == 0).all()


@pytest.mark.slow
def test_designs_with_loads_beside_are_answered_as_before():
    """Of the second R^2 + m^2 = F_0^2 is a cubic in A, as there is no viscous damping."""
    onsets = Duffing.many(1.0, -0.3, zeta=0.02, excitation="unbalance", load=[0.0, 0.05]).saddle_node_onset()
    assert onsets.F_SN[0] == pytest.approx(0.0212923, rel=1e-5) and onsets.B[0] == 0
    states = Duffing.many(1.0, 0.3, mu=0.01, zeta=0.0, load=[0.0, 0.05]).amplitudes(Omega=0.9, F_0=0.05)
    A = np.roots([0.225, 0.0, 1 - 0.81, -np.sqrt(0.05**2 - (0.04 / np.pi) ** 2)])
    assert states.A[0, 0] == pytest.approx(A[abs(A.imag) < 1e-12].real.max(), rel=1e-12)
    assert states.status.tolist() == [Status.OK, Status.UNBOUNDED]
