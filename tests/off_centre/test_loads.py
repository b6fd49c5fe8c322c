"""What an engineer asks under a load: against the states themselves, closed forms, and what holds for any isolator."""

from __future__ import annotations

import contextlib
import math
import random
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from slowflow import Duffing, Isolator, derive
from slowflow.averaged.checks import APART, ISOLA
from slowflow.example import isolator
from slowflow_kernels.conventions import Status
from tests.files import MOUNT


def some_isolators(count: int):
    """Isolators with a forcing above sticking."""
    draw = random.Random(7)
    for _ in range(count):
        lam, delta_h = draw.choice([1, 2, 3]), draw.uniform(0.02, 0.3)
        r = draw.uniform(0.05, 0.95) / (lam * delta_h)
        mu, zeta = draw.choice([0.0, draw.uniform(0, 0.02)]), draw.uniform(0.01, 0.2)
        yield Isolator(lam=lam, r=r, delta_h=delta_h, mu=mu, zeta=zeta), 4 * mu / math.pi + draw.uniform(0.005, 0.1)


# ---- margins -------------------------------------------------------------------------------------------------------


def test_margins_are_the_critical_forcings_over_the_load():
    iso = isolator()
    found = iso.margins(0.025)
    assert (found.of_SN, found.of_cr) == (iso.saddle_node_onset().F_SN / 0.025, iso.detachment().F_cr / 0.025)
    assert (found.folds, found.detaches, found.sticks) == (2, False, False)
    assert iso.margins(0.02).folds == 0 and iso.margins(0.04).detaches and iso.margins(0.01).sticks
    assert "sticks" in iso.margins(0.01).message
    linear = isolator(delta_h=0).margins(0.04)
    assert linear.F_cr is None and linear.of_SN is None and not linear.detaches and "no saddle node" in linear.message


def test_motion_detaches_just_above_the_lowest_forcing():
    for iso, _ in some_isolators(20):
        F_cr = iso.detachment().F_cr
        assert iso.margins(1.01 * F_cr).detaches and not iso.margins(0.99 * F_cr).detaches


def test_the_birth_of_an_isola_is_said_to_be_no_jump():
    """Of a softening spring."""
    softening = Duffing(1.9, -1.25, mu=0.006, zeta=0.58)
    assert softening.saddle_node_onset().kind == "isola" and ISOLA in softening.margins(1.0).message
    assert ISOLA not in isolator().margins(0.04).message


def test_motions_detached_below_F_cr_are_on_their_own_curves():
    iso = Isolator(lam=1, r=3.3935433280050518, delta_h=0.21463966757944564, mu=0.0148, zeta=0.2972, excitation="base")
    found, curve = iso.margins(0.41694), iso.frequency_response(0.41694, Omega=(0.0, 20.0))
    assert found.of_cr > 1 and found.detaches and APART in found.message
    ends = [(curve.A[curve.branch == k].min(), curve.A[curve.branch == k].max()) for k in np.unique(curve.branch)]
    assert len(ends) == 2 and ends[0][1] < iso.u_cr < ends[1][0] and curve.isola == (False, True)
    assert APART not in iso.margins(0.43).message


@pytest.mark.slow
def test_unstable_motions_beyond_the_first_end_detach_nothing():
    """Beyond it the spring pulls back less and less: up there nothing is stable, as long as the peak is below it."""
    falling = derive.library("bilinear")(kappa=-0.5, delta=1.0, mu=0.0, zeta=0.2)
    for F_0 in (0.2, 0.5):  # of a peak at F_0 / (2 zeta sqrt(1 - zeta^2))
        assert falling.frequency_response(F_0).A.max() > 1.0
        assert falling.margins(F_0).detaches == (F_0 / (0.4 * math.sqrt(0.96)) > 1.0)


# ---- at rest -------------------------------------------------------------------------------------------------------


def test_friction_holds_as_far_as_the_spring_pushes_less():
    for iso, _ in some_isolators(20):
        found, force = iso.at_rest(), iso.restoring_force("untruncated")
        u = found.rests_within * np.linspace(0, 1, 2000)
        if iso.mu:
            assert (np.abs(force(u)) <= iso.mu * (1 + 1e-12)).all() and force(1.000001 * u[-1:])[0] > iso.mu
        assert found.break_loose == iso.mu and found.sticking == pytest.approx(4 * iso.mu / math.pi)
        assert found.k_0 == pytest.approx(1 - iso.lam * iso.r * iso.delta_h) and found.Omega_0**2 == pytest.approx(
            found.k_0
        )
    assert Duffing(2.0, 0.0, mu=0.3, zeta=0.1).at_rest().rests_within == pytest.approx(0.15)
    assert Isolator(lam=3, r=2.0, delta_h=0.08, mu=0.01, zeta=0.02).replace(mu_s=0.02).at_rest().break_loose == 0.02
    released = Isolator(lam=3, r=2.0, delta_h=0.08, mu=1.0, zeta=0.02, contact="attached")
    assert released.at_rest().rests_within == released.u_cr
    with pytest.raises(ValueError, match="at_rest is not available with load"):
        Duffing(1.0, 0.5, 0.01, 0.05, load=0.1).at_rest()


def test_frequency_up_to_which_an_unbalance_leaves_rest():
    iso = Isolator(lam=3, r=2.0, delta_h=0.08, mu=0.012, zeta=0.02, excitation="unbalance")
    Omega = iso.margins(0.03).Omega_sticks
    below, above = iso.amplitudes(Omega=Omega * (1 - 1e-9), F_0=0.03), iso.amplitudes(Omega=Omega * 1.0001, F_0=0.03)
    assert below.A.tolist() == [0.0] and (above.A > 0).all()
    forced = iso.replace(excitation="force")
    assert forced.margins(0.01).Omega_sticks == math.inf and forced.margins(0.03).Omega_sticks == 0


# ---- hysteresis ----------------------------------------------------------------------------------------------------


def test_the_band_of_a_mount_lies_between_its_jumps():
    mount = Isolator.physical(**MOUNT)
    (band,), folds = mount.hysteresis(5), mount.saddle_nodes(5)
    assert [band.f_low, band.f_high] == folds.f.tolist() and band.motions == 2
    assert "at most one motion is stable" in mount.hysteresis(2).message and len(mount.hysteresis(2)) == 0


# ---- isolation -----------------------------------------------------------------------------------------------------


def test_small_amplitude_where_isolation_begins_has_all_digits():
    """It is that of the state there, which falls with the fourth power of its frequency."""
    of = Duffing(1.0, 7.0, 1e-5, 0.004)
    for F_0 in (5e-4, 7e-4, 8e-4, 9e-4):
        found = of.isolation(F_0)
        states = of.amplitudes(Omega=found.Omega, F_0=F_0)
        assert found.A < 2e-3 and len(states) == 1
        assert states.A[0] == pytest.approx(found.A, rel=1e-14)


def test_isolation_may_begin_at_a_fold():
    """Quasi-zero stiffness: small motions would isolate from far below on."""
    iso = Isolator(lam=2, r=1.0, delta_h=0.5, mu=0.001, zeta=0.04)
    found, (up, down) = iso.isolation(0.05), iso.saddle_nodes(0.05)
    assert found.at_fold and (found.Omega, found.A) == (down.Omega, down.A) and down.kind == "jump-down"
    low = iso.amplitudes(Omega=0.5 * (up.Omega + down.Omega), F_0=0.05)
    assert low.stable.tolist() == [True, False, True] and low.transmissibility[0] < 1 < low.transmissibility[-1]


def test_endless_motion_leaves_no_isolation_frequency():
    """A hardening spring without viscous damping: its resonance goes on to any frequency."""
    hardening = Duffing(1.0, 1.0, mu=0.01)
    found = hardening.isolation(0.1)
    assert found.Omega is None and "extends to arbitrarily high frequencies" in found.message
    (band,), (fold,) = hardening.hysteresis(0.1), hardening.saddle_nodes(0.1)
    assert (band.Omega_low, band.Omega_high, band.motions) == (fold.Omega, math.inf, 2)


def test_where_the_mass_sticks_there_is_no_isolation():
    found = isolator().isolation(0.01)
    assert found.Omega is None and "sticks" in found.message


# ---- a load spectrum -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("load", [0.0, 0.03])
def test_load_spectrum_rows_say_what_states_and_folds_say(load):
    iso = isolator(load=load)
    Omega, F_0 = [0.5, 0.7, 0.95, 1.2, 0.6, 0.93, 0.9], [*[0.04] * 6, 0.012]
    found, folds = iso.spectrum(Omega=Omega, F_0=F_0), iso.saddle_nodes(0.04).Omega
    for row, at, F in zip(found, Omega, F_0, strict=True):
        states = iso.amplitudes(Omega=at, F_0=F)
        in_motion = states.stable & (states.A > 0)
        A, mean = states.A[in_motion], states.B[in_motion] if load else 0.0
        assert (row.Omega, row.F_0, row.motions, row.sticks) == (at, F, A.size, F == 0.012)
        assert row.A == A.max(initial=0.0) and row.detaches == bool((np.abs(mean) + A > iso.u_cr).any())
    between = [bool(((folds > min(way)) & (folds < max(way))).any()) for way in pairwise(Omega[:6])]
    assert found.crosses[:6].tolist() == [False, *between] and {*between} == {*found.detaches.tolist()} == {True, False}
    assert found.motions.tolist()[3:] == [1, 1, 2, 0] and found.transmissibility_dB[-1] == 0
    stuck = iso.spectrum(Omega=0.9, F_0=0.012)
    assert (stuck[0].A, stuck[0].motions, stuck[0].sticks) == (0.0, 0, True) and "sticks" in stuck.message


def test_fold_of_a_narrow_band_is_crossed():
    iso = isolator()
    F_0 = 1.05 * iso.saddle_node_onset().F_SN
    assert iso.spectrum(Omega=[0.5, 1.5], F_0=F_0).crosses.tolist() == [False, True]
    for iso, F_0 in some_isolators(60):
        folds = iso.saddle_nodes(F_0).Omega
        crossed = iso.spectrum(Omega=[0.5, 1.5, 0.5], F_0=F_0).crosses[1:]
        assert (crossed == bool(((folds > 0.5) & (folds < 1.5)).any())).all()


def test_fold_is_crossed_where_the_number_of_states_changes():
    draw, seen = random.Random(11), set()
    for iso, F_0 in some_isolators(40):
        ends = [(draw.uniform(0.6, 1.4), F_0 * draw.uniform(0.5, 1.5)) for _ in range(2)]
        way = np.linspace(*ends, 1500)
        F = way[:, 1]
        slips = F > iso.sticking_forcing
        states = Isolator.many(**{name: getattr(iso, name) for name in ("lam", "r", "delta_h", "mu", "zeta")})
        changes = np.diff(states.amplitudes(Omega=way[slips, 0], F_0=F[slips]).count).any()
        crossed = bool(iso.spectrum(Omega=way[[0, -1], 0], F_0=F[[0, -1]]).crosses[1])
        assert crossed or not changes
        if crossed and not changes:  # between two of these points, then: a fold is near both
            folds = [np.abs(iso.saddle_nodes(f).Omega - O).min(initial=1) for O, f in way[slips]]
            assert min(folds) < 3 / 1500
        seen.add(crossed)
    assert seen == {False, True}


@pytest.mark.parametrize("load", [0.0, 0.05])
def test_pairs_are_said_to_be_single_tones(load):
    """By integration, the response to two tones together is neither single response nor their sum."""
    duffing = Duffing(1.0, 0.3, mu=0.01, zeta=0.05, load=load)
    pairs, several = {"Omega": [0.8, 1.2], "F_0": [0.2, 0.3]}, "simultaneous tones are not covered"
    depths = [duffing.spectrum, duffing.amplitudes]
    depths += [] if load else [duffing.second_approximation.amplitudes]
    for ask in depths:
        assert several in ask(**pairs).message
        assert several not in ask(Omega=0.8, F_0=[0.2, 0.3]).message  # a number of forcings, at one frequency
    assert several not in duffing.amplitudes(Omega=[0.8, 1.2], F_0=0.2).message  # a curve
    if not load:
        apart = duffing.amplitudes(**pairs).A

        def both(tau, y):
            force = 0.2 * np.cos(0.8 * tau) + 0.3 * np.cos(1.2 * tau)
            return [y[1], force - 0.1 * y[1] - 0.01 * np.tanh(y[1] / 1e-3) - y[0] - 0.3 * y[0] ** 3]

        path = solve_ivp(both, (0.0, 200.0), [0.0, 0.0], method="LSODA", rtol=1e-6, t_eval=np.linspace(100, 200, 2001))
        together = np.abs(path.y[0]).max()
        assert min(abs(together / one - 1) for one in (*apart, apart.sum())) > 0.05


def test_a_spectrum_of_a_mount_says_so_in_its_letters():
    message = Isolator.physical(**MOUNT).spectrum(f=[2.2, 5.0], F=[5.0, 3.0]).message
    assert message.startswith("each pair of f and F is a single tone")


def test_a_spectrum_of_a_mount_is_in_its_units():
    mount = Isolator.physical(**MOUNT)
    found = mount.spectrum(f=[2.2, 5.0], F=[5.0, 3.0])
    assert found.units == {"f": "Hz", "F": "N", "A": "m"} and found.motions.tolist() == [2, 1]
    with pytest.raises(ValueError, match="F = -1"):
        mount.spectrum(f=2.2, F=-1)
    assert len(isolator().spectrum(Omega=[], F_0=[])) == 0


def test_isolation_begins_where_a_new_isola_ends():
    """It has two folds, 2e-8 apart, and points of one stability beside either; it has no end at high frequencies."""
    numbers = {"lam": 5, "r": 0.5152307809931513, "delta_h": 0.2813440740415054, "mu": 0.0457149750553505}
    shaken = Isolator(**numbers, zeta=0.026253034237872036, excitation="base", force="untruncated")
    F_0 = shaken.saddle_node_onset().F_SN * (1 + 1e-15)
    found, folds = shaken.isolation(F_0), shaken.saddle_nodes(F_0)
    assert found.at_fold and found.Omega == pytest.approx(folds.Omega.max(), rel=1e-8)


def test_isolation_beyond_answered_frequencies_is_left_out():
    """A number that nobody gave is not refused; and what has no answer is one of a batch."""
    stiff = Duffing(1.0, 0.06, mu=0.0, zeta=0.0)
    designs = Duffing.many(alpha=1.0, beta=0.06, mu=0.0, zeta=0.0)
    for question in ("hysteresis", "isolation"):
        with contextlib.suppress(ArithmeticError):
            getattr(stiff, question)(5.5e62)
        assert getattr(designs, question)(5.5e62).status in (Status.OK, Status.NONE, Status.UNRESOLVED)


def test_spectrum_without_lines_has_no_rows_under_a_load():
    for load in (0.0, 0.3):
        assert len(Duffing(1.0, 0.5, 0.01, 0.02, load=load).spectrum(Omega=[], F_0=0.1).Omega) == 0


def test_a_peak_that_is_also_the_farthest_motion_is_one():
    """Found by its amplitude and by its largest displacement it differs in last digits, which must not matter."""
    loaded = Duffing(1.0, 0.395665597422618, zeta=0.17316220242649727, load=-0.40459542057412246)
    peak = loaded.peak(0.31937250949095286)
    assert (peak.Omega_max, peak.u_max) == (peak.Omega, peak.A + abs(peak.B))
    assert "u_max" in peak.gradient().of
