"""Questions under a load of many designs: each row is what the design says that is asked alone."""

from __future__ import annotations

import math

import numpy as np
import pytest

from slowflow import Duffing, Isolator
from slowflow.answers.results import Remark
from slowflow_kernels.conventions import Status
from tests.sampling import slow


def test_margins_of_many_say_where_folds_end_at_rest():
    """There are folds below F_SN then, so that of_SN alone would promise too much."""
    numbers = {"alpha": 1.0, "beta": -1.0, "mu": 0.01, "zeta": [0.05, 0.2]}
    found = Duffing.many(**numbers).margins(0.3)
    for k, zeta in enumerate(numbers["zeta"]):
        single = Duffing(1.0, -1.0, 0.01, zeta).margins(0.3)
        assert found.remarks[k] == single.remarks and found.of_SN[k] == single.of_SN
        assert bool(single.remarks & Remark.FOLDS_AT_REST) == ("Omega = 0" in single.message)
    assert (found.remarks & Remark.FOLDS_AT_REST).any()


@pytest.mark.parametrize("force", ["truncated", "untruncated"])
def test_at_rest_many_have_a_stroke_that_no_base_motion_reaches(force):
    """It was NaN where the detachment has no forcing."""
    design = {"lam": 3.0, "r": 0.33366700033366703, "delta_h": 0.999, "zeta": 0.12, "excitation": "base"}
    many = Isolator.many(**design, force=force)
    assert many.detachment().status == Status.NONE
    assert many.at_rest().u_cr == Isolator(**design, force=force).u_cr == pytest.approx(math.sqrt(1 - 0.001**2))


@pytest.mark.slow
def test_friction_of_the_rod_does_not_always_hold_on_a_base():
    """Many designs were reported to stick, as under a force; at this acceleration every base makes the mass slip."""
    design = {"lam": 1.0, "r": 1.0, "delta_h": 0.1, "mu": 0.07, "zeta": 0.3}
    design |= {"excitation": "base", "contact": "attached"}
    many, single = Isolator.many(**design), Isolator(**design)
    for F_0 in (0.05, 0.2):
        found, margins = many.margins(F_0), single.margins(F_0)
        assert found.sticks == margins.sticks == 0 and found.remarks == margins.remarks
        assert found.Omega_sticks == margins.Omega_sticks == pytest.approx(math.sqrt(4 * 0.07 / math.pi / F_0))
        assert many.saddle_nodes(F_0).remarks == single.saddle_nodes(F_0).remarks
    sticking = Isolator.many(**{**design, "excitation": "force"}).margins(0.05)
    assert sticking.sticks == 1


@pytest.mark.slow
def test_spectrum_row_without_a_stable_motion_says_so():
    """Beside a row that is none, and after it: what crosses on the way there is not known either."""
    softens = Duffing.many(alpha=1.0, beta=-1.0, mu=0.0, zeta=0.05)
    found = softens.spectrum(Omega=[2.0, 0.1, 0.1, 2.0], F_0=[0.01, 5.0, -1.0, 0.01])
    single = Duffing(1.0, -1.0, zeta=0.05).spectrum(Omega=[2.0, 0.1], F_0=[0.01, 5.0])
    assert found.motions[:2].tolist() == single.motions.tolist() and np.isnan(single.A[1])
    assert found.status.tolist() == [Status.OK, Status.NONE, Status.INVALID, Status.INVALID]
    assert found.to_xarray()["A"].dims == ("row",) and found.columns()["Omega"].tolist() == [2.0, 0.1, 0.1, 2.0]
    assert softens.spectrum(Omega=0.9, F_0=0.1).A.shape == (1,)
    assert Isolator.many(lam=3, r=[[1.0], [2.0]], delta_h=[0.05, 0.06, 0.07]).spectrum(Omega=[], F_0=0.04).A.shape == (
        *(2, 3),
        0,
    )


def test_margins_have_the_status_of_an_unresolved_onset():
    """A single one raises; a number that is not known is no margin without an end."""
    numbers = {"lam": 3, "r": 1.4571468416058473, "delta_h": 0.0019600418551609547, "zeta": 0.028892122141866906}
    with pytest.raises(ArithmeticError, match="unresolved"):
        Isolator(**numbers, mu=0.0, excitation="base").margins(0.0383)
    found = Isolator.many(**numbers, mu=0.0, excitation="base").margins(0.0383)
    assert np.isnan(found.F_SN) and found.status == Status.UNRESOLVED


@pytest.mark.parametrize(
    ("design", "F_0"),
    [
        # F_cr is only tended to, and an isolated curve lies beyond u_cr
        ({"lam": 4, "r": 4.45, "delta_h": 0.3, "mu": 0.018, "zeta": 0.17, "excitation": "unbalance"}, 0.5),
        ({"lam": 5, "r": 6.8, "delta_h": 0.37, "mu": 0.0015, "zeta": 0.093, "excitation": "base"}, 0.45),
        # without viscous damping: no motion below |u| = 1, where a curve is cut, is stable
        ({"lam": 3, "r": 0.93, "delta_h": 0.99, "mu": 0.0, "zeta": 0.0}, 10.0),
    ],
)
def test_stable_motions_beyond_the_stroke_are_detached(design, F_0):
    assert Isolator(**design).margins(F_0).detaches and Isolator.many(**design).margins(F_0).detaches
    # with some damping it is seen
    damped = Isolator(**{**design, "zeta": max(design["zeta"], 1e-6)})
    states = damped.amplitudes(Omega=np.linspace(0.3, 1.5, 61), F_0=F_0)
    assert (states.A[states.stable] > damped.u_cr).any()


def test_folds_that_differ_by_rounding_have_no_band():
    """Both on the corner, one and two ulps apart."""
    for design, F_0 in (
        (
            {"lam": 2, "r": 0.4778512754002988, "delta_h": 0.07053832840043835}
            | {"mu": 0.00021943408712369537, "zeta": 0.14071260744854866},
            0.10315219523602766,
        ),
        (
            {"lam": 3, "r": 0.1026703065545021, "delta_h": 0.2110794412770953}
            | {"mu": 0.039439905240794944, "zeta": 0.2193201131082507},
            0.3167111233623252,
        ),
    ):
        designs = Isolator.many(**design)
        assert designs.saddle_nodes(F_0).count == 2 and designs.hysteresis(F_0).count == 0
        assert len(Isolator(**design).hysteresis(F_0)) == 0


def test_what_is_unresolved_has_that_status_in_every_batch():
    """A search that runs out of room is no answer with too few places."""
    design = {"lam": 3, "r": 4.56e-4, "delta_h": 0.2, "mu": 0.0, "zeta": 1e-150, "excitation": "base"}
    design["force"] = "untruncated"
    designs, F_0 = Isolator.many(**design), 1.1e-16
    with pytest.raises(ArithmeticError, match="unresolved"):
        Isolator(**design).amplitudes(Omega=0.5, F_0=F_0)
    answers = (designs.saddle_nodes(F_0), designs.amplitudes(Omega=0.5, F_0=F_0), designs.frequency_response(F_0))
    assert {int(found.status) for found in answers} == {Status.UNRESOLVED}
    assert designs.spectrum(Omega=[0.5, 1.2], F_0=F_0).status.tolist() == [Status.UNRESOLVED] * 2


def test_linear_mount_has_no_forcing_with_a_jump():
    """Its spring is one line: the lowest such forcing is beyond all numbers, and the load no part of it."""
    found = Duffing.many(alpha=[1.0, 2.0], beta=[0.0, 0.3], zeta=0.05).margins(0.1)
    assert found.F_SN.tolist() == [math.inf, pytest.approx(Duffing(2.0, 0.3, zeta=0.05).margins(0.1).F_SN)]
    assert found.of_SN[0] == math.inf and found.of_SN[1] < math.inf


def test_what_has_no_band_has_no_frequency_of_one():
    found = Duffing.many(alpha=1.0, beta=[0.0, 0.5], zeta=0.02).hysteresis(0.1)
    assert found.count.tolist() == [0, 1]
    assert np.isnan(found.Omega_low[0]).all() and np.isnan(found.Omega_high[0]).all()
    assert np.isfinite(found.Omega_low[1, 0]) and np.isnan(found.Omega_low[1, 1:]).all()


def test_on_a_base_margins_say_why_no_springs_detach():
    """A Duffing has one piece, and says so where the base shakes; of a force there is nothing to bear in mind."""
    shaken, pushed = (Duffing(1.0, 0.5, zeta=0.05, excitation=one).margins(0.1) for one in ("base", "force"))
    why = Duffing(1.0, 0.5, zeta=0.05, excitation="base").detachment().message
    assert why and why in shaken.message and why not in pushed.message


@pytest.mark.parametrize("samples", [20, *slow(300)])
def test_a_response_has_about_as_many_points_as_samples(samples):
    """States at which its arcs were told apart were all points: 477 of 20, and a batch had no room for them."""
    design = {"lam": 1.4, "r": 3.5, "delta_h": 0.39, "mu": 0.00053, "zeta": 0.013, "load": -0.033}
    many, one = (made(**design, excitation="unbalance") for made in (Isolator.many, Isolator))
    single, folds = one.frequency_response(0.049, samples=samples), one.saddle_nodes(0.049)
    assert abs(len(single) - samples) <= 64
    assert set(zip(folds.Omega, folds.A, strict=True)) <= set(zip(single.Omega, single.A, strict=True))
    assert single.Omega.max() == 2.0
    found = many.frequency_response(0.049, samples=samples, max_count=16)
    assert found.status == Status.OK and found.points == len(single)
    assert np.array_equal(found.A[: len(single)], single.A)


#: designs whose force rises, the forcing, and excitations
RISING = {
    "hardening": (Duffing.many, {"alpha": 1.0, "beta": [[0.0], [0.3], [1.0]], "mu": 0.01}, 0.15, "force"),
    "light damping": (Duffing.many, {"alpha": 1.0, "beta": [[0.3], [1.0]], "zeta": 0.002}, 0.15, "force"),
    "structural": (Duffing.many, {"alpha": 1.0, "beta": [[0.3], [1.0]], "zeta": 0.0, "eta": 0.01}, 0.15, "force"),
    "base": (Duffing.many, {"alpha": 1.0, "beta": [[0.3], [1.0]], "mu": 0.0, "eta": 0.02}, 0.1, "base"),
    "truncated": (
        Isolator.many,
        {"lam": 3, "r": 2.03, "delta_h": [[0.05], [0.06], [0.09]], "mu": 0.012, "force": "truncated"},
        0.08,
        "force",
    ),
    "untruncated": (Isolator.many, {"lam": 3, "r": 2.03, "delta_h": 0.09, "mu": 0.012}, 0.08, "force"),
}


@pytest.mark.parametrize("case", [*(case for case in RISING if case != "untruncated"), *slow("untruncated")])
def test_states_and_folds_without_a_proof_are_those_with_one(case):
    """Several at a tone among them; each of their columns."""
    many, numbers, F_0, excitation = RISING[case]
    designs = many(**{"zeta": 0.02} | numbers, load=0.03, excitation=excitation)
    at = {"Omega": np.linspace(0.6, 1.6, 30), "F_0": F_0}
    found, proved = designs._by_doubles("amplitudes", max_count=6, **at), designs.amplitudes(**at)
    assert (proved.count > 1).any() and np.array_equal(found.count, proved.count)
    for name in ("A", "B", "phi", "transmissibility", "stable", "status"):
        np.testing.assert_allclose(getattr(found, name), getattr(proved, name), rtol=1e-12, err_msg=name)
    at = {"F_0": F_0 * np.array([0.1, 0.7, 1.0, 1.3])}
    found, proved = designs._by_doubles("saddle_nodes", max_count=6, **at), designs.saddle_nodes(**at)
    assert (proved.count > 1).any() and np.array_equal(found.count, proved.count)
    for name in ("Omega", "A", "B", "kind", "status"):
        np.testing.assert_allclose(getattr(found, name), getattr(proved, name), rtol=1e-9, err_msg=name)
    first = designs._by_doubles("saddle_nodes", max_count=1, **at)
    assert np.array_equal(first.status, np.where(proved.count > 1, Status.TOO_MANY, proved.status))


@pytest.mark.parametrize("case", [*(case for case in RISING if case != "untruncated"), *slow("untruncated")])
def test_states_next_to_folds_are_found_without_a_proof(case):
    """Of two that meet in a fold both were lost where they differed by less than what amplitudes are sampled at."""
    many, numbers, F_0, excitation = RISING[case]
    designs = many(**{"zeta": 0.02} | numbers, load=0.03, excitation=excitation)
    folds = designs.saddle_nodes(F_0)
    at = np.geomspace(1e-9, 1e-3, 7)
    Omega = np.unique(folds.Omega[np.isfinite(folds.Omega)][:, np.newaxis] * (1 + np.append(-at, at)))
    found = designs._by_doubles("amplitudes", Omega=Omega, F_0=F_0, max_count=6)
    proved = designs.amplitudes(Omega=Omega, F_0=F_0)
    assert (proved.count > 1).any() and np.array_equal(found.count, proved.count)
    # next to a fold amplitudes change with the root of the frequency
    np.testing.assert_allclose(found.A, proved.A, rtol=1e-10)
