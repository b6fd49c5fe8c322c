"""Off the centre on a base that shakes, by an unbalance, with structural and quadratic damping: cases and limits."""

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from scipy.optimize import brentq

from slowflow import Duffing, Isolator
from slowflow.core.model import Laws
from slowflow.core.validate import NotAvailable
from slowflow.example import TABLE_1
from slowflow.off_centre.flow import Flow
from slowflow.sizing import tolerances
from slowflow.support.errors import NotSettled
from slowflow_kernels.duffing import MECHANISM
from tests.files import MOUNT
from tests.oracles.by_time import mean_and_first

u, k, g, a, b = sp.symbols("u k g a b", real=True)
#: one of each law and excitation
LAWS = ({"excitation": "base"}, {"excitation": "unbalance", "c_2": 0.02}, {"eta": 0.02}, {"c_2": 0.03, "eta": 0.01})


#: what is asked at a forcing, and how near answers under a load of 1e-9 are to those without
NEARLY_CENTRED = {
    "amplitudes": (("A", "phi", "transmissibility"), 1e-10),
    "saddle_nodes": (("Omega",), 1e-9),
    "saddle_node_onset": (("F_SN", "Omega", "A"), 1e-7),
    "peak": (("A", "Omega"), 1e-6),
    "detachment": (("F_cr",), 1e-6),
    "margins": (("F_SN", "F_cr", "of_SN", "of_cr", "Omega_sticks"), 1e-6),
    "hysteresis": (("Omega_low", "Omega_high"), 1e-9),
    "isolation": (("Omega",), 1e-9),
}
CENTRED = {
    **{f"law {n}": (Duffing(1.0, 1.0, **{"zeta": 0.04, "mu": 0.002, **law}), 0.085) for n, law in enumerate(LAWS)},
    "truncated": (Isolator(**TABLE_1), 0.04),
    "on a base": (Isolator(**TABLE_1, excitation="base"), 0.05),
    "untruncated": (Isolator(**TABLE_1, force="untruncated"), 0.04),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", CENTRED)
def test_a_vanishing_load_leaves_the_answers_about_the_centre(name):
    centred, F_0 = CENTRED[name]
    loaded = centred.replace(load=1e-9)
    for question, (names, near) in NEARLY_CENTRED.items():
        if question == "detachment" and isinstance(centred, Duffing):
            continue
        at = {} if question in ("saddle_node_onset", "detachment") else {"F_0": F_0}
        at |= {"Omega": [0.4, 1.15, 1.3, 1.8]} if question == "amplitudes" else {}
        one, other = (getattr(of, question)(**at) for of in (centred, loaded))
        for column in names:
            values = [np.array(getattr(found, column), dtype=float) for found in (other, one)]
            np.testing.assert_allclose(*values, rtol=near, err_msg=f"{question} {column}")
        for column in {"kind", "stable", "folds", "detaches", "sticks"} & {*vars(one)}:
            assert np.array_equal(getattr(one, column), getattr(other, column)), (question, column)
    assert np.abs(loaded.amplitudes(Omega=1.3, F_0=F_0).B).max() < (2e-9 if isinstance(centred, Duffing) else 2e-8)


@pytest.mark.slow
@pytest.mark.parametrize("law", LAWS)
def test_states_of_a_loaded_isolator_are_averages_by_sums(law):
    """The mean is solved for at each amplitude, and F on a grid of them: all its zeros are the states."""
    isolator = Isolator(**TABLE_1, load=0.05, **law)
    F_0, Omega = 0.06, 0.85
    psi = 2 * np.pi * (np.arange(20000) + 0.5) / 20000
    force, eta, c_2 = isolator.restoring_force(), isolator.eta, isolator.c_2
    level = F_0 * Omega**2 if "excitation" in law else F_0

    def at(A):
        def mean(B):
            return force(B + A * np.cos(psi)).mean() - 0.05

        B = brentq(mean, -1.0, 1.0, xtol=1e-14)
        h = -2 * (force(B + A * np.cos(psi)) * np.cos(psi)).mean()
        I = 4 * isolator.mu / np.pi + eta * A + 2 * isolator.zeta * A * Omega + 8 * c_2 / (3 * np.pi) * (A * Omega) ** 2
        return (A * Omega**2 + h) ** 2 + I**2 - level**2

    grid = np.geomspace(1e-3, 3.0, 150)
    values = np.array([at(A) for A in grid])
    roots = [brentq(at, grid[i], grid[i + 1], xtol=1e-12) for i in np.flatnonzero(values[:-1] * values[1:] < 0)]
    found = isolator.amplitudes(Omega=Omega, F_0=F_0)
    np.testing.assert_allclose(found.A, roots, rtol=1e-4)
    assert len(roots) >= 1


@pytest.mark.slow
@pytest.mark.parametrize("law", LAWS)
def test_exact_motions_under_a_load_are_integration_by_time(law):
    mount = Duffing(1.0, 1.0, zeta=0.08, load=0.2, **law)
    Omega, F_0 = 1.0, 0.04
    motion = mount.steady_state(Omega=Omega, F_0=F_0)
    middle, first = motion.harmonics(1)
    B, A = mean_and_first(lambda u: u + u**3, mount, Omega, F_0, (0.19, 0.0), 150)
    assert middle.real == pytest.approx(B, abs=1e-7) and abs(first) == pytest.approx(A, abs=1e-7)
    (state,) = mount.amplitudes(Omega=Omega, F_0=F_0)
    assert state.A == pytest.approx(A, rel=0.03) and state.B == pytest.approx(B, rel=0.02)


def test_friction_holds_a_mount_on_a_base_up_to_a_frequency():
    mount = Duffing(1.0, 0.5, zeta=0.05, mu=0.01, load=0.2, excitation="base")
    begin = np.sqrt(4 * 0.01 / np.pi / 0.05)
    states = mount.amplitudes(Omega=[0.9 * begin, 1.001 * begin, 1.2], F_0=0.05)
    assert (
        states.Omega[states.A > 0].tolist() == [1.001 * begin, 1.2]
        and states.A[0] == 0
        and f"sticks up to Omega = {begin:g}" in states.message
    )
    curve = mount.frequency_response(0.05)
    assert begin < curve.Omega.min() < 1.002 * begin and curve.A[0] < 1e-3
    assert mount.amplitudes(Omega=0.5 * begin, F_0=0.05).A.tolist() == [0.0]


@pytest.mark.slow
def test_small_forcings_have_small_motions():
    """Boxes beyond A = 0 are left, and do not pile up."""
    for law in ({}, *LAWS):
        mount = Duffing(1.0, 1.0, zeta=0.03, load=0.2, **{name: one for name, one in law.items() if name != "c_2"})
        one, other = (mount.amplitudes(Omega=0.5, F_0=F_0) for F_0 in (1e-6, 1e-9))
        assert other.A == pytest.approx(1e-3 * one.A, rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("law", [{"eta": 0.04}, {"c_2": 0.05}, {"excitation": "base", "c_2": 0.05}])
def test_damping_without_viscous_part_is_the_limit(law):
    """Answers are analytic in zeta: extrapolated from two small ones to 0, they are off by its square."""
    of = Duffing(1.0, 1.0, mu=0.01, load=0.1, **law)
    steps = 1e-6, 2e-6

    def answers(one):
        top, folds = one.peak(0.06), one.saddle_nodes(0.1)
        return np.concatenate(((top.A, top.B, top.Omega), folds.Omega, folds.A, one.amplitudes(Omega=0.8, F_0=0.06).A))

    near, far = (answers(of.replace(zeta=zeta)) for zeta in steps)
    found = answers(of)
    assert len(found) == 3 + 4 + 1
    np.testing.assert_allclose(found, 2 * near - far, rtol=1e-6)


def test_without_damping_that_grows_the_reason_is_said():
    with pytest.raises(ValueError, match=r"needs zeta > 0, eta > 0 or c_2 > 0 for offset motions"):
        Duffing(1.0, 1.0, mu=0.01, load=0.1).peak(0.1)


@pytest.mark.slow
@pytest.mark.parametrize("zeta", [0.0, 1e-9])
@pytest.mark.part(2)
def test_an_onset_that_only_falls_as_motions_grow_is_none(zeta):
    """A hardening spring on a base, with structural damping: levels of the backbone go as eta/A."""
    onset = Duffing(1.0, 1.0, zeta=zeta, eta=0.04, load=0.1, excitation="base").saddle_node_onset()
    assert onset.F_SN is None and "undecided" in onset.message


@pytest.mark.slow
def test_what_a_base_does_without_an_end_is_said():
    hard = Duffing(1.0, 1.0, zeta=0.03, load=0.2, excitation="base")
    assert "may not close" in hard.peak(0.1).message and hard.peak(0.1).A is None
    with pytest.raises(NotSettled, match="isolation is unresolved"):
        hard.isolation(0.1)
    overdamped = Duffing(1.0, 0.0, zeta=0.9, load=0.2, excitation="base").peak(0.1)
    assert overdamped.A is None and "tends to 0.1 from below" in overdamped.message


@pytest.mark.slow
def test_margins_know_a_forcing_that_only_fast_motions_approach():
    """An overdamped base: above it curves pass the breakpoint at high frequencies, below it at none."""
    mount = Isolator(**TABLE_1 | {"zeta": 0.9}, excitation="base", load=0.05)
    assert "tends to the first breakpoint" in mount.detachment().message
    F_cr = mount.margins(0.05).F_cr
    assert Isolator.many(**TABLE_1 | {"zeta": [0.9]}, excitation="base", load=0.05).margins(0.05).F_cr == F_cr
    for ratio, passes in ((0.99, False), (1.01, True)):
        curve = mount.frequency_response(ratio * F_cr, Omega=(0.0, 200.0))
        assert (np.max(np.abs(curve.B) + curve.A) > mount.breakpoints[0]) == passes
        assert mount.margins(ratio * F_cr).detaches == passes


def test_what_is_not_answered_off_the_centre_is_refused_in_words():
    well = Duffing(-0.5, 1.0, zeta=0.05, excitation="base")
    for ask in (well.off_centre.saddle_nodes, well.off_centre.peak, well.off_centre.frequency_response):
        with pytest.raises(NotAvailable, match="excitation = 'base' for motions that leave the centre"):
            ask(0.1)
    assert len(well.off_centre.rest()) == 3
    assert well.replace(load=0.05).amplitudes(Omega=1.0, F_0=0.1).A.size
    with pytest.raises(NotAvailable, match="contact = 'attached'"):
        Isolator(**TABLE_1, load=0.05, contact="attached")


@pytest.mark.slow
def test_gradients_by_an_absent_law_are_limits():
    """eta and c_2 at 0, one of which is there: one-sided differences."""
    with_eta = Duffing(1.0, 1.0, zeta=0.05, eta=0.02, load=0.1)
    slope = with_eta.saddle_node_onset().gradient()["F_SN", "c_2"]
    ends = [with_eta.replace(c_2=c_2).saddle_node_onset().F_SN for c_2 in (1e-5, 0.0)]
    assert slope == pytest.approx((ends[0] - ends[1]) / 1e-5, rel=1e-4)


@pytest.mark.slow
def test_tolerances_on_a_shaking_floor_are_single_answers():
    mount = Isolator.physical(**MOUNT, load=12.36, excitation="base")
    found = tolerances(mount, {"load": 0.02}, Y=0.004, answers=["Y_cr", "of_SN", "A_peak"], samples=4)
    margins = mount.margins(Y=0.004)
    assert found.nominal.tolist() == pytest.approx([margins.Y_cr, margins.of_SN, mount.peak(Y=0.004).A], rel=1e-12)


@pytest.mark.parametrize("load", [1e-9, 1e-6, 1e-3])
def test_onset_on_a_base_tends_to_the_centred_one_with_the_load(load):
    """Levels of folds that nearly meet were not known well enough next to the cusp: the onset was called undecided."""
    at_centre = Duffing(1.0, 0.5, zeta=0.05, excitation="base").saddle_node_onset()
    found = Duffing(1.0, 0.5, zeta=0.05, load=load, excitation="base").saddle_node_onset()
    assert found.kind == "cusp"
    assert found.F_SN == pytest.approx(at_centre.F_SN, rel=1e-12 + 2 * load**2)


@pytest.mark.parametrize("inertial", [False, True])
def test_the_level_rises_with_the_frequency_as_its_square_does(inertial):
    """F_Omega at a state is d(level^2)/dOmega, of an excitation by inertia times Omega^4, with each law of damping."""
    zeta, eta = 0.04, 0.05
    flow = Flow(MECHANISM, (1.0, 0.0), 0.03, zeta, "base" if inertial else "force", Laws(eta, 0.06))
    m, d = flow.m, flow.d
    A, h, at = 0.4, -0.3, 0.9

    def squared(w):
        R, I = A * w**2 + h, m + eta * A + 2 * zeta * A * w + d * (A * w) ** 2
        return (R**2 + I**2) / (w**4 if inertial else 1)

    expected = mp.diff(squared, at) * (at**4 if inertial else 1)
    assert float(flow.F_Omega(at, A, h)) == pytest.approx(float(expected), rel=1e-13)
