"""Shocks of the base: against closed forms, another integrator, energy, and what a record of the same pulse says."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import cumulative_trapezoid
from scipy.optimize import brentq

from slowflow import Duffing, Isolator, derive, exact
from slowflow.exact import EquationOfMotion, half_sine, linear, record, transient
from slowflow.example import isolator
from slowflow_kernels.conventions import Status
from tests.files import MOUNT
from tests.oracles import by_time


def undamped(acceleration, duration):
    """Largest |u| of u'' + u = -a sin(p tau) up to the duration, free after it: closed forms in each span."""
    p = math.pi / duration
    if abs(p - 1) < 1e-12:  # at resonance the pulse ends with the largest swing
        return acceleration * math.pi / 2
    after = abs(2 * p / (1 - p * p) * math.cos(math.pi / (2 * p)))
    # u' = 0 where cos(p tau) = cos(tau)
    turns = (2 * math.pi * k / (1 + sign * p) for k in range(1, 50) for sign in (1, -1) if sign * p != -1)
    during = [
        (math.sin(p * tau) - p * math.sin(tau)) / (1 - p * p)
        for tau in map(abs, turns)
        if tau <= duration * (1 + 1e-12)
    ]
    return acceleration * max([after, *map(abs, during)])


@pytest.mark.parametrize("duration", [0.01, 0.3, 1.0, 2.0, math.pi, 4.0, 7.0, 12.0, 25.0])
def test_undamped_linear_shock_spectrum_is_the_closed_form(duration):
    found = Duffing(1.0, 0.0).shock_spectrum(acceleration=0.3, duration=duration)
    expected = undamped(0.3, duration)
    assert found.A[0] == pytest.approx(expected, rel=1e-11)
    # without damping the spring alone moves the mass
    assert found.a_max[0] == pytest.approx(expected, rel=1e-11) and found.ratio[0] == found.a_max[0] / 0.3


def stops(found):
    """Places where the mass turns, in order, and whether it rests in the end."""
    phases = [stretch.phase for stretch in found.stretches if stretch.phase.slip]
    return [phase.u_end for phase in phases if phase.v_end == 0.0]


def test_friction_takes_off_4_mu_over_k_in_each_cycle():
    mu, k = 0.01, 2.5
    system = EquationOfMotion(Duffing(k, 0.0, mu=mu).restoring_force(), mu, 0.0)
    found = transient(system, half_sine(0.4, 1.0), after=200.0)
    turning = np.abs([u for u in stops(found)])
    first = int(turning.argmax())
    free = turning[first:]
    assert free.size > 5 and free[0] == found.A
    np.testing.assert_allclose(free[2:] - free[:-2], -4 * mu / k, rtol=0, atol=1e-13)
    # it is held at the first turn that the spring cannot leave
    assert found.rests and abs(found.u_end) <= mu / k < free[-2] and abs(found.u_end) == free[-1]


def pulsed(force, acceleration, duration, zeta, end, state):
    """u and v of a mass without friction from a state on, under a half sine and after it, by SciPy."""
    found = []
    for span, a in ((np.linspace(0, duration, 20_001), acceleration), (np.linspace(duration, end, 80_001), 0.0)):
        push = lambda tau, a=a: -a * math.sin(math.pi * tau / duration)  # noqa: E731
        way = by_time.motion(force, push, zeta, span[[0, -1]], state, t_eval=span, rtol=1e-11, atol=1e-13).y
        found.append(way)
        state = way[:, -1]
    return np.concatenate(found, axis=1)


@pytest.mark.parametrize(("acceleration", "duration"), [(0.05, 2.0), (0.4, 1.5), (-0.3, 6.0)])
def test_shock_peaks_are_those_of_another_integrator(acceleration, duration):
    iso = isolator()
    found = iso.transient(acceleration=acceleration, duration=duration)
    pull = by_time.odd_of(iso.restoring_force().value)
    A, a_max = by_time.shock(iso, pull, acceleration, duration, duration + 8.0)
    assert found.A == pytest.approx(A, rel=1e-6) and found.a_max == pytest.approx(a_max, rel=2e-4)
    assert found.detaches == (A > iso.u_cr)


def test_a_record_of_a_pulse_does_what_the_pulse_does():
    """Between samples it is straight: what is missing shrinks with the square of their distance."""
    iso = isolator()
    pulse = iso.transient(acceleration=0.4, duration=1.5)
    away = []
    for samples in (101, 201):
        tau = np.linspace(0, 1.5, samples)
        found = iso.transient(tau=tau + 3.0, acceleration=0.4 * np.sin(math.pi * tau / 1.5))
        away.append(abs(found.A / pulse.A - 1))
        assert found.tau_A - 3.0 == pytest.approx(pulse.tau_A, rel=1e-3)
        assert found.series().tau[0] == 3.0
    assert away[0] < 2e-4 and away[1] == pytest.approx(away[0] / 4, rel=0.05)


def test_a_record_is_straight_between_its_samples():
    """A ramp and a step that stays, on a linear undamped spring: u = -(tau - sin tau)/10 on the ramp."""
    system = EquationOfMotion(linear(), 0.0, 0.0)
    found = transient(system, record(np.array([0.0, 2.0, 3.0]), np.array([0.0, 0.2, 0.2])), after=0.0)
    tau, u, v, a, base = found.series(301)
    ramp = tau <= 2.0
    np.testing.assert_allclose(u[ramp], -0.1 * (tau - np.sin(tau))[ramp], atol=1e-7)
    np.testing.assert_allclose(base[tau <= 3.0], np.interp(tau[tau <= 3.0], [0, 2, 3], [0, 0.2, 0.2]), atol=1e-7)
    np.testing.assert_allclose(a, -u, atol=1e-12)
    assert np.all(base[tau > 3.0] == 0) and v[0] == 0


def test_a_record_goes_through_its_samples():
    """The arcs begin and end at them, but for rounding."""
    tau, samples = np.array([0.0, 2.0, 3.0, 3.5, 9.0]), np.array([0.3, -0.7, 0.2, 0.2, -1.1])
    span, Omega, F, theta = record(tau, samples).T
    np.testing.assert_allclose(-F * np.cos(theta), samples[:-1], rtol=0, atol=1e-11)
    np.testing.assert_allclose(-F * np.cos(theta + Omega * span), samples[1:], rtol=0, atol=1e-11)


@pytest.mark.parametrize("zeta", [1.0, 2.0])
def test_overdamped_mass_is_followed_until_it_is_back(zeta):
    """A linear one: against another integrator; without friction it never rests, and turns once."""
    found = Duffing(1.0, 0.0, zeta=zeta).transient(acceleration=0.3, duration=2.0)
    u, v = pulsed(lambda u: u, 0.3, 2.0, zeta, 20.0, (0.0, 0.0))
    assert found.A == pytest.approx(np.abs(u).max(), rel=1e-6)
    assert found.a_max == pytest.approx(np.abs(u + 2 * zeta * v).max(), rel=1e-6)
    assert not found.rests and abs(found.u_end) < 1e-8
    many = Duffing.many(1.0, 0.0, 0.0, [zeta, 0.1]).transient(acceleration=0.3, duration=2.0)
    assert (many.A[0], many.status.tolist()) == (pytest.approx(found.A, rel=1e-13), [0, 0])


def test_a_mass_that_friction_holds_moves_with_its_base():
    found = isolator().transient(acceleration=0.011, duration=5.0)
    assert (found.A, found.rests, found.detaches) == (0.0, True, False)
    assert found.a_max == pytest.approx(0.011, rel=1e-9) and found.tau_a == pytest.approx(2.5, rel=1e-4)


def test_motion_over_time_loses_energy_to_dampers_alone():
    """Free motion of a cubic spring: kinetic and potential energy fall by what 2 zeta v^2 + mu |v| takes."""
    iso = Duffing(1.0, 2.0, mu=0.01, zeta=0.03)
    found = iso.transient(acceleration=0.5, duration=1.0)
    tau, u, v, *_ = found.series(20001)
    free = tau >= 1.0
    tau, u, v = tau[free], u[free], v[free]
    energy = v**2 / 2 + u**2 / 2 + 2 * u**4 / 4
    lost = cumulative_trapezoid(0.06 * v**2 + 0.01 * np.abs(v), tau, initial=0.0)
    np.testing.assert_allclose(energy, energy[0] - lost, atol=1e-7)
    assert abs(found.A - np.abs(found.series(20001).u).max()) < 1e-6 and found.rests


def test_rows_of_a_shock_spectrum_are_single_shocks():
    iso = isolator()
    found = iso.shock_spectrum(acceleration=[[0.1], [0.5]], duration=[1.0, 2.0, 4.0])
    assert len(found) == 6
    for row in found:
        one = iso.transient(acceleration=row.acceleration, duration=row.duration)
        assert (row.A, row.a_max, row.detaches) == (one.A, pytest.approx(one.a_max, rel=1e-12), one.detaches)


def test_a_shock_in_si_units_is_that_of_the_mount():
    """A stiff pulse, far shorter than the period: the mass keeps still while the base moves on by a speed."""
    mount = Isolator.physical(**{**MOUNT, "friction": 0, "zeta": 0, "preload": 0})  # linear, 2500 N/m
    a, T = 50.0, 1e-4
    found = mount.transient(acceleration=a, duration=T)
    speed, rate = 2 * a * T / math.pi, math.sqrt(2500 / 12)
    assert found.A == pytest.approx(speed / rate, rel=1e-5) and found.a_max == pytest.approx(speed * rate, rel=1e-5)
    assert found.t_A == pytest.approx(math.pi / 2 / rate, rel=1e-3)
    assert found.units["a_max"] == "m/s^2" and found.in_units("g").a_max == pytest.approx(found.a_max / 9.80665)
    mount = Isolator.physical(**MOUNT)
    rows = mount.shock_spectrum(acceleration=20.0, duration=[0.011, 0.1])
    assert [row.A for row in rows] == [mount.transient(acceleration=20.0, duration=T).A for T in (0.011, 0.1)]
    t = np.linspace(0, 0.011, 200)
    again = mount.transient(acceleration=20 * np.sin(math.pi * t / 0.011), t=t)
    assert again.A == pytest.approx(rows.A[0], rel=1e-4) and again.t.shape == again.x.shape == (400,)


@pytest.mark.parametrize("friction", [{}, {"mu": 0.05}, {"mu": 0.05, "mu_s": 0.08}])
def test_linear_shock_under_a_load_is_that_about_its_rest(friction):
    centred = Duffing(1.0, 0.0, zeta=0.05, **friction)
    found, plain = (one.transient(acceleration=0.5, duration=2.0) for one in (centred.replace(load=0.3), centred))
    assert np.abs(found.series().u - 0.3 - plain.series().u).max() < 1e-14
    assert found.a_max == pytest.approx(plain.a_max, rel=1e-14) and found.rests == plain.rests == bool(friction)
    spectrum = centred.replace(load=0.3).shock_spectrum(acceleration=0.5, duration=2.0)
    assert (spectrum.A[0], spectrum.a_max[0]) == (found.A, found.a_max)


@pytest.mark.parametrize("zeta", [0.6, 0.9, 1.0, 1.3, 2.0])
def test_a_damped_mass_under_a_load_comes_back(zeta):
    """Where it has come back but for rounding nothing moves it: the linear mass moves about its equilibrium."""
    pulse = {"acceleration": 0.5, "duration": 2.0}
    for load in (0.05, 0.3, -0.1):
        found, plain = (Duffing(1.0, 0.0, zeta=zeta, load=one).transient(**pulse) for one in (load, 0.0))
        assert np.abs(found.series().u - load - plain.series().u).max() < 1e-14 and not found.rests
        well = Duffing(1.0, 0.5, zeta=zeta, load=load).transient(**pulse)
        assert not well.rests and well.u_end + 0.5 * well.u_end**3 == pytest.approx(load, abs=1e-8)
        many = Duffing.many(1.0, 0.5, zeta=zeta, load=load).transient(**pulse)
        assert (many.status, many.A, many.rests, many.u_end) == (0, well.A, 0, well.u_end)


def test_shock_under_a_load_is_another_integrators_and_mirrored():
    mount = isolator(mu=0.0, load=0.03)
    found = mount.transient(acceleration=0.5, duration=3.0)
    force, begins = mount.restoring_force(), mount.rest().u[0]
    u, _ = pulsed(lambda u: force.value(u) - mount.load, 0.5, 3.0, mount.zeta, 12.0, (begins, 0.0))
    assert found.detaches and found.A == pytest.approx(np.abs(u).max(), rel=1e-4)
    mirrored = mount.replace(load=-0.03).transient(acceleration=-0.5, duration=3.0)
    assert mirrored.series().u == pytest.approx(-found.series().u, abs=1e-12)


def test_a_shock_under_a_load_begins_where_the_mass_rests():
    still = Duffing(1.0, 0.5, zeta=0.05, mu=0.01, load=0.3).transient(acceleration=0.0, duration=1.0)
    assert still.A == still.u_end == pytest.approx(brentq(lambda u: u + 0.5 * u**3 - 0.3, 0, 1), rel=1e-15)
    # of the force that is followed
    mount, other = isolator(load=0.3), isolator().restoring_force("untruncated")
    still = mount.transient(acceleration=0.0, duration=1.0, force="untruncated")
    assert other.value(still.u_end) == pytest.approx(0.3, rel=1e-14) and still.u_end != mount.rest().u[0]
    well = Duffing(-1.0, 1.0, zeta=0.05, load=0.05).transient(acceleration=0.1, duration=2.0)
    assert "several stable equilibria" in well.message
    # as it never comes back as far, the largest deflection is that at rest
    assert Duffing(1.0, 0.0, zeta=2.0, load=0.3).transient(acceleration=0.1, duration=2.0).tau_A == 0.0
    with pytest.raises(ArithmeticError, match="no stable equilibrium to start from"):
        Duffing(1.0, -1.0, zeta=0.05, load=0.5).transient(acceleration=0.1, duration=1.0)


def test_released_block_turns_where_the_energy_balance_says():
    """SDND100 of code_aster: each turn is nearer by 2 mu/k; 1 kg on 10^4 N/m, friction 1 N, released at 0.85 mm."""
    block = Isolator.physical(m=1.0, k_v=1e4, k_h=1.0, L=1.0, preload=0.0, friction=1.0, zeta=0.0)
    found = block.transient(x_0=0.85e-3)
    assert stops(found.answer) == pytest.approx([-0.65e-3, 0.45e-3, -0.25e-3, 0.05e-3], abs=1e-15)
    assert found.rests and found.x_end == pytest.approx(0.05e-3, rel=1e-11) and found.A == 0.85e-3
    # the first half of a turn lasts pi sqrt(m/k)
    first = found.answer.stretches[0].phase
    assert (first.end - first.theta) / 100 == pytest.approx(math.pi / 100, rel=1e-12)
    still = block.transient(x_0=0.05e-3)
    assert still.rests and still.A == still.x_end == pytest.approx(0.05e-3, rel=1e-15)


def test_thrown_mass_turns_where_both_springs_have_its_energy():
    """SDND101 of code_aster: 100 kg on 10^4 N/m at 1 m/s against a stop of 10^6 N/m, v_0 sqrt(m/(k + K)) = 9.95 mm."""
    u = sp.Symbol("u")
    mechanism = derive.mechanism("stop_at_rest", [(u, 0), (101 * u, None)], {}, odd=False)
    length, rate = 0.1, 10.0
    found = mechanism(mu=0.0, zeta=0.0).transient(v_0=1.0 / (length * rate), after=1.0)
    assert stops(found)[0] * length == pytest.approx(math.sqrt(100 / 1.01e6), rel=1e-12)
    # and then back as far as all of its energy takes the one spring: half a turn on both, a quarter on that
    assert found.A * length == pytest.approx(0.1, rel=1e-12)
    assert found.tau_A / rate == pytest.approx(math.pi * math.sqrt(100 / 1.01e6) + 0.5 * math.pi / rate, rel=1e-12)


def test_released_mass_swings_as_the_closed_form_says():
    """Under a load, with damping, from a displacement and a velocity; and a pulse beside them."""
    zeta, load, u_0, v_0 = 0.1, 0.3, -0.4, 0.7
    found = Duffing(1.0, 0.0, zeta=zeta, load=load).transient(u_0=u_0, v_0=v_0, after=20.0)
    tau, u, v, *_ = found.series(200)
    fast = math.sqrt(1 - zeta**2)
    a, b = u_0 - load, (v_0 + zeta * (u_0 - load)) / fast
    expected = load + np.exp(-zeta * tau) * (a * np.cos(fast * tau) + b * np.sin(fast * tau))
    np.testing.assert_allclose(u, expected, rtol=0, atol=1e-13)
    assert (u[0], v[0]) == (u_0, v_0)
    linear = Duffing(1.0, 0.0, zeta=zeta)
    pulse = {"acceleration": 0.2, "duration": 1.5, "after": 10.0}
    both, shock = linear.transient(**pulse, u_0=u_0, v_0=v_0), linear.transient(**pulse)
    free = linear.transient(u_0=u_0, v_0=v_0, after=11.5)
    np.testing.assert_allclose(both.series(50).u, shock.series(50).u + free.series(50).u, rtol=0, atol=1e-12)


def test_shock_between_two_wells_begins_in_one():
    """By SciPy, from the well with u > 0."""
    pulse = {"acceleration": 0.3, "duration": 2.0}
    found = Duffing(-1.0, 1.0, zeta=0.1).transient(**pulse)
    assert "at u = -1, 1: the mass starts from u = 1" in found.message
    u, _ = pulsed(lambda u: u**3 - u, 0.3, 2.0, 0.1, 20.0, (1.0, 0.0))
    assert found.A == pytest.approx(np.abs(u).max(), rel=1e-5)
    many = Duffing.many([-1.0, 1.0], 1.0, zeta=0.1).transient(**pulse)
    assert many.A[0] == found.A and many.u_end[0] == found.u_end
    spectrum = Duffing.many([-1.0, 1.0], 1.0, zeta=0.1).shock_spectrum(**pulse)
    assert spectrum.A[0] == Duffing(-1.0, 1.0, zeta=0.1).shock_spectrum(**pulse).A[0]


def test_what_is_no_shock_is_refused():
    iso, mount = isolator(), Isolator.physical(**MOUNT)
    for call, message in (
        (lambda: iso.transient(acceleration=0.1), "either its duration"),
        (lambda: iso.transient(acceleration=0.1, duration=1.0, tau=[0, 1]), "either its duration"),
        (lambda: iso.transient(acceleration=0.1, duration=-1.0), r"duration = -1\.0 .* finite real number > 0$"),
        (lambda: iso.transient(acceleration=[0.1, 0.2], tau=[1.0, 0.5]), "tau ascending"),
        (lambda: iso.transient(acceleration=[0.1, 0.2, 0.1], tau=[1.0, 1.5]), r"\(2,\) and \(3,\)"),
        (lambda: Isolator.many(lam=3, r=2, delta_h=0.1).transient(acceleration=0.1), "either its duration"),
        (
            lambda: Isolator.many(lam=3, r=2, delta_h=0.1).transient(acceleration=0.1, tau=[0, 1]),
            "same number of samples",
        ),
        (lambda: iso.shock_spectrum(acceleration=-0.1, duration=1.0), "acceleration = -0.1"),
        (lambda: mount.transient(acceleration=20.0, duration="11 mm"), "duration = '11 mm'"),
    ):
        with pytest.raises(ValueError, match=message):
            call()
    with pytest.raises(ArithmeticError, match="escapes"):
        Duffing(1.0, -1.0, zeta=0.05).transient(acceleration=3.0, duration=3.0)
    assert "push-rod stands vertical" in iso.transient(acceleration=3.0, duration=3.0).message
    assert "push-rod stands vertical" in iso.shock_spectrum(acceleration=[0.1, 3.0], duration=3.0).message


def test_a_shock_and_a_spectrum_are_drawn():
    pytest.importorskip("matplotlib")
    found = isolator().transient(acceleration=0.5, duration=2.0)
    labels = {text.get_text() for text in found.plot().get_legend().get_texts()}
    assert labels == {"beyond $u_{cr}$"}
    ax = isolator().shock_spectrum(acceleration=[[0.1], [0.5]], duration=[1.0, 2.0]).plot()
    assert {"0.1", "0.5", "springs detach"} <= {text.get_text() for text in ax.get_legend().get_texts()}
    assert exact.Transient is type(found)


def test_rounding_of_a_load_does_not_keep_a_shock_from_beginning():
    """Without friction the mass goes where the pulse pushes it, on a linear spring as without the load."""
    draw = np.random.default_rng(0)
    for _ in range(40):
        load, peak = 10 ** draw.uniform(-6, 2, 2) * draw.choice([-1, 1], 2)
        duration = 10 ** draw.uniform(-1, 1)
        centred = Duffing(1.0, 0.0, zeta=0.01)
        found, plain = (
            one.transient(acceleration=peak, duration=duration, after=10.0)
            for one in (centred.replace(load=load), centred)
        )
        assert found.series().u - load == pytest.approx(plain.series().u, abs=1e-9 * plain.A + 1e-12 * abs(load))


@pytest.mark.parametrize("load", [0.01, 0.1])
def test_shock_hidden_by_rounding_of_the_load_is_refused(load):
    """Small motions about a place of rest are linear: it was said to be 93 times, or inf times, what it is."""
    loaded = Isolator(lam=3, r=2, delta_h=0.08, zeta=0.02, load=load)
    ratio = (
        Duffing(float(loaded.rest().stiffness[0]), 0.0, zeta=0.02).shock_spectrum(acceleration=1.0, duration=1.0).ratio
    )
    for peak in (1e-7, 1e-9, 1e-11):
        found = loaded.shock_spectrum(acceleration=peak, duration=1.0).ratio
        assert found == pytest.approx(ratio, rel=1e-5 + 1e-14 / peak)
    for peak in (1e-14, 1e-17, 5e-324):
        with pytest.raises(ArithmeticError, match="too weak compared with the equilibrium u = 0"):
            loaded.shock_spectrum(acceleration=peak, duration=1.0)
    many = Isolator.many(lam=3, r=2, delta_h=0.08, zeta=0.02, load=[load, load])
    status = many.shock_spectrum(acceleration=[1e-17, 1e-7], duration=1.0).status
    assert status.tolist() == [Status.UNRESOLVED, Status.OK]
    # what friction holds moves with its base, however weakly that is shaken
    motion = loaded.replace(mu=0.01).transient(acceleration=1e-17, duration=1.0)
    assert motion.rests and motion.a_max == pytest.approx(1e-17)


def test_a_pulse_whose_frequency_is_beyond_doubles_is_refused():
    """It warned of an overflow; a batch has a status."""
    mount = isolator()
    for ask in (mount.transient, mount.shock_spectrum):
        with pytest.raises(
            ValueError, match=r"duration = 1e-310 is not allowed: duration must be a finite real number >"
        ):
            ask(acceleration=0.1, duration=1e-310)
    with pytest.raises(ValueError, match="tau ascending"):
        mount.transient(acceleration=[0.1, 0.2], tau=[0.0, 1e-310])
    many = Isolator.many(lam=3, r=2, delta_h=0.08, zeta=0.02).shock_spectrum(acceleration=0.1, duration=[1e-310, 1.0])
    assert many.status.tolist() == [Status.INVALID, Status.OK]


def test_shocks_without_an_answer_have_a_status():
    """A force that softens, a duration below zero, a load under which nothing rests, times that do not rise."""
    softens = Duffing.many(1.0, [-1.0, 0.0], 0.0, 0.05).transient(acceleration=3.0, duration=[[3.0], [-1.0]])
    assert softens.status.tolist() == [[Status.UNRESOLVED, Status.OK], [Status.INVALID] * 2]
    designs = Duffing.many([1.0, -0.5, 1.0], [0.5, 0.5, -0.5], 0.01, 0.05, load=[0.3, 0.02, 0.6])
    loaded = designs.transient(acceleration=0.8, duration=1.5)
    assert loaded.stands.tolist() == [1, 2, 0] and loaded.status.tolist() == [0, 0, Status.UNRESOLVED]
    flat = designs.transient(acceleration=[0.1, 0.2, 0.1], tau=[0.0, 1.0, 1.0])
    assert (flat.status == Status.INVALID).all()
    with pytest.raises(ValueError, match="either its duration"):
        designs.transient(acceleration=0.8)
