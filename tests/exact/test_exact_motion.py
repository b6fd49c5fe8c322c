"""The exact motion against SciPy from switch to switch, closed forms, and the compiled integrator against SciPy's."""

import collections
import itertools
import math
import pickle
import re

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from slowflow import Duffing, Isolator, derive
from slowflow.exact import (
    EquationOfMotion,
    Force,
    Law,
    Piece,
    half_sine,
    linear,
    record,
    steady_state,
    sweep,
    transient,
)
from slowflow.exact.motion import Forced, follow, sample
from slowflow_kernels import den_hartog
from tests.oracles import by_time, exact_reference
from tests.oracles.exact_cases import isolator, random_cases, random_motions

CASES = random_cases(60, seed=6)  # a seed with up to six stops and subharmonics: see the first test


@pytest.fixture(scope="module")
def states():
    return [steady_state(case.system, Omega=case.Omega, F_0=case.F_0) for case in CASES]


def test_random_isolators_cover_what_they_should(states):
    stops = collections.Counter(state.stops for state in states)
    assert stops[0] >= 10 and stops[2] >= 10 and stops[4] >= 2 and stops[6] >= 1
    assert sum(case.system.mu == 0 for case in CASES) >= 10 and all(state.stable for state in states)
    assert sum(max(abs(region) for _, region in state.cycle.signature) for state in states) >= 5


@pytest.mark.slow
def test_random_isolators_have_motions_of_scipy(states):
    """From switch to switch, with up to six stops."""
    for case, state in zip(CASES, states, strict=True):
        other = exact_reference.again(state)
        assert abs(other.A - state.A) <= 1e-9, case
        assert sum(phase.slip == 0 for phase in other.phases) * (1 + state.symmetric) == state.stops, case


def test_own_functions_are_followed_by_their_polynomials():
    """To the digits of the series of the same force."""
    law = Law(lambda u: u + u**3, lambda u: 1 + 3 * u**2)
    own = EquationOfMotion(Force((Piece(law, ()),), ()), 0.01, 0.02)
    other = Duffing(1.0, 1.0, 0.01, 0.02).equation_of_motion()
    for Omega in (0.5, 1.1, 1.6):
        found, expected = (steady_state(one, Omega=Omega, F_0=0.1) for one in (own, other))
        assert found.cycle.signature == expected.cycle.signature
        assert found.A == pytest.approx(expected.A, rel=1e-13)
        assert np.max(np.abs(found.multipliers - expected.multipliers)) <= 1e-12


@pytest.mark.parametrize("zeta", [0.01, 0.03, 0.07])
def test_viscous_linear_oscillator_in_closed_form(zeta):
    """Without friction and preload: u = Re F_0/(1 - Omega^2 + 2 i zeta Omega) exp(i Omega tau), multipliers known.

    Over its own period: a mass that settles by a third or a half of a turn in each is nearest to where it was before.
    """
    F_0, system = 0.05, EquationOfMotion(linear(), 0.0, zeta)
    for Omega in (0.4, 0.7, 0.97, 1.0, 1.3, 1.5, 1.525, 1.8, 2.0, 2.119, 2.3, 2.5, 2.9, 3.1, 5.0):
        state = steady_state(system, Omega=Omega, F_0=F_0)
        assert state.stops == 0 and state.stable and state.symmetric
        assert state.period == pytest.approx(2 * math.pi / Omega, rel=1e-15)
        response = F_0 / (1 - Omega**2 + 2j * zeta * Omega)
        harmonics = state.harmonics(5)
        assert abs(harmonics[1] - response) <= 1e-13
        assert np.max(np.abs(np.delete(harmonics, 1))) <= 1e-13
        assert abs(state.A - abs(response)) <= 1e-13
        tau, u, v = state.series(64)
        assert np.max(np.abs(u - (response * np.exp(1j * Omega * tau)).real)) <= 1e-12
        assert np.max(np.abs(v - (1j * Omega * response * np.exp(1j * Omega * tau)).real)) <= 1e-12
        expected = np.exp((-zeta + 1j * math.sqrt(1 - zeta**2)) * state.period)
        assert np.min(np.abs(state.multipliers - expected)) <= 1e-12
        passed_on = math.hypot(1, 2 * zeta * Omega) * abs(response) / F_0
        transmitted = state.transmitted()
        assert transmitted.first == pytest.approx(passed_on, rel=1e-12)
        # just before the end of each half turn, at whose ends the force has the same size
        assert transmitted.peak == pytest.approx(passed_on, rel=2e-12)


def test_largest_transmitted_force_is_that_of_dense_samples():
    """Also where the largest of few samples is the last but one of a phase, or its end is lower than what is before."""
    for system, Omega, F_0 in random_motions(18, seed=7):
        state = steady_state(system, Omega=Omega, F_0=F_0)
        forced = Forced(system, Omega, F_0)
        phases = [sample(forced, phase, np.linspace(phase.theta, phase.end, 20001)) for phase in state.phases]
        dense = max(float(np.abs(one[:, 2]).max()) for one in phases) / forced.force
        assert dense * (1 - 1e-14) <= state.transmitted().peak <= dense * (1 + 1e-7)


@pytest.mark.parametrize("ratio", [0.1, 0.3, 0.6])
def test_den_hartog_where_his_solution_holds(ratio):
    """(35) wherever the amplitude exceeds the bound (36), for zeta = 0 and no preload."""
    system = EquationOfMotion(linear(), ratio, 0.0)
    checked = 0
    for Omega in (0.57, 0.7, 0.83, 1.21, 1.5, 1.9):
        times = np.linspace(0, np.pi / Omega, 4001)[1:-1]
        S = float(np.max(den_hartog.S_ratio(times, Omega)))
        with np.errstate(invalid="ignore"):
            A = float(den_hartog.amplitude(Omega, 1.0, ratio))
        bound = float(den_hartog.bound(Omega, 1.0, S))
        if not A > 1.001 * bound:
            continue
        state = steady_state(system, (A, 0.3), Omega=Omega, F_0=1.0)
        assert abs(state.A - A) <= 1e-10
        assert state.stops == 0
        start = state.unknowns[1] / Omega
        tau, u, _ = state.series(50)
        after = np.mod(tau - start, 2 * np.pi / Omega)
        half = after <= np.pi / Omega
        expected = den_hartog.motion(after[half], Omega, A, ratio)
        assert np.max(np.abs(u[half] - expected)) <= 1e-10
        checked += 1
    assert checked >= 3


def test_den_hartog_sticks_below_the_bound():
    """Below (36) the mass stops, above it does not: the border of the exact curve lies where (35) meets (36)."""
    ratio = 0.8
    system = EquationOfMotion(linear(), ratio, 0.0)
    for Omega in (0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95, 0.98, 1.05, 1.2):
        times = np.linspace(0, np.pi / Omega, 4001)[1:-1]
        S = float(np.max(den_hartog.S_ratio(times, Omega)))
        with np.errstate(invalid="ignore"):
            A = float(den_hartog.amplitude(Omega, 1.0, ratio))
        continuous = A > float(den_hartog.bound(Omega, 1.0, S))
        assert (steady_state(system, Omega=Omega, F_0=1.0).stops == 0) == continuous, Omega


@pytest.mark.parametrize("fraction", [0.5, 0.95, 0.999])
def test_friction_holds_a_mass_where_the_spring_pulls_with_less(fraction):
    """At once, or after each turn that takes 2 mu off a free mass."""
    mu, Omega = 0.01, 0.37
    forced = Forced(EquationOfMotion(linear(), mu, 0.0), Omega, 1e-300)
    for turns in range(3):
        phases = follow(forced, 0.0, (fraction + 2 * turns) * mu, 0.0, 20 * Omega)
        assert [phase.slip for phase in phases] == [*(-1, 1)[:turns], 0]
        assert abs(phases[-1].u_end) == pytest.approx(fraction * mu, rel=1e-13)


def test_multipliers_against_finite_differences(states):
    """The monodromy matrix with saltation against differences of the motion followed over a turn."""
    seen = set()
    for case, state in zip(CASES, states, strict=True):
        kind = (state.stops, len(state.cycle.signature))
        if kind in seen:
            continue
        seen.add(kind)
        forced = Forced(case.system, case.Omega, case.F_0)
        phase = max(state.phases, key=lambda p: (p.slip != 0) * (p.end - p.theta))
        theta = 0.5 * (phase.theta + phase.end)
        u, v, _ = sample(forced, phase, np.array([theta]))[0]
        end = theta + state.period * case.Omega
        columns = []
        size = 1e-6
        for du, dv in ((size, 0.0), (0.0, size)):
            ends = [follow(forced, theta, u + s * du, v + s * dv, end, (phase.slip, phase.region))[-1] for s in (1, -1)]
            difference = np.array(ends[0][6:8]) - np.array(ends[1][6:8])
            columns.append(difference / (2 * size))
        matrix = np.column_stack(columns)
        # a multiplier that stops make zero is compared through trace and determinant
        assert abs(np.trace(matrix) - np.sum(state.multipliers).real) <= 1e-6
        assert abs(np.linalg.det(matrix) - np.prod(state.multipliers).real) <= 1e-6
    assert len(seen) >= 4


def test_a_cycle_starts_at_any_of_its_turning_points(states):
    """The same motion, followed through its switches from there; upside down from where it turns upwards."""
    slips = collections.Counter()
    for case, state in zip(CASES, states, strict=True):
        cycle = state.cycle
        for i, (before, phase) in enumerate(itertools.pairwise(state.phases), 1):
            if phase.v or before.region != phase.region or phase.slip not in (-1, -cycle.sign):
                continue
            turned, z = cycle.restart(state.unknowns, case.F_0, i)
            assert turned.holds(z, case.F_0), case
            found = turned.equations(z, case.F_0)
            assert found.A == pytest.approx(state.A, rel=1e-12) and np.max(np.abs(found.residual)) <= 1e-12
            multipliers = turned.multipliers(found.monodromy) ** (1 if cycle.sign == 1 else 2)
            assert np.sort_complex(multipliers) == pytest.approx(np.sort_complex(state.multipliers), abs=1e-9)
            slips[phase.slip] += 1
    assert slips[-1] >= 5 and slips[1]


def test_released_asymmetric_motion():
    """Negative stiffness at the centre: the motion about one side is not half-wave symmetric, and is found."""
    system = isolator(2, 2.0, 0.3, 0.0, 0.05, exact=False)[0]
    state = steady_state(system, Omega=1.3, F_0=0.01, half_turns=2)
    assert not state.symmetric
    assert state.half_multipliers is None
    _, u, _ = state.series(100)
    assert abs(np.mean(u)) > 0.1
    assert abs(state.harmonics(2)[0].real - np.mean(u)) <= 1e-6


def test_a_slip_that_turns_round_unseen_is_no_motion():
    """The equations of an order of switches may be solved with a velocity that passes zero within a phase: refused.

    Duffing(1, -0.3, 0.01, 0.05), F_0 = 0.05, from what averaging guesses at Omega = 0.3; from rest there is one motion.
    """
    system = Duffing(1.0, -0.3, 0.01, 0.05).equation_of_motion()
    from_rest = steady_state(system, Omega=0.3, F_0=0.05)
    states = Duffing(1.0, -0.3, 0.01, 0.05).amplitudes(Omega=0.3, F_0=0.05)
    found = steady_state(system, (float(states.A[0]), float(states.phi[0])), Omega=0.3, F_0=0.05)
    assert found.residual <= 1e-11
    assert found.A == pytest.approx(from_rest.A, rel=1e-9) and found.stops == from_rest.stops == 2


def test_escape_in_words():
    """A softening spring that pulls outwards beyond |u| = 1.83 lets the mass go: said, not looped over for ever."""
    system = Duffing(1.0, -0.3, 0.01, 0.05).equation_of_motion()
    with pytest.raises(ArithmeticError, match="motion escapes"):
        steady_state(system, Omega=0.7, F_0=0.6)
    with pytest.raises(ArithmeticError, match="motion escapes"):
        steady_state(system, (1.9, -1.0), Omega=0.7, F_0=0.3)
    with pytest.raises(ArithmeticError, match="motion escapes"):
        sweep(system, Omega=[0.7], F_0=0.6)
    with pytest.raises(ArithmeticError, match=r"does not hold it; at Omega = 0.7, F_0 = 0.6$") as lost:
        sweep(system, Omega=[0.7], F_0=0.6)
    assert str(pickle.loads(pickle.dumps(lost.value))) == str(lost.value)


@pytest.mark.part(3)
def test_a_wall_within_reach():
    """u_cr = 0.99995: Newton's trials run against the force (5) near |u| = 1, where it has no bound."""
    system = Isolator(lam=3, r=0.1, delta_h=0.99, mu=0.012, zeta=0.02).equation_of_motion("untruncated")
    state = steady_state(system, (1.3187, -0.04), Omega=0.5, F_0=0.9)
    assert state.stable and state.residual <= 1e-9
    again = steady_state(system, state, Omega=0.5, F_0=0.9)
    assert again.A == pytest.approx(state.A, rel=1e-9) and again.stops == state.stops
    with pytest.raises(ArithmeticError, match=r"the integration|passes 1e\+06"):
        steady_state(system, Omega=0.5, F_0=1e9)


def passes(level, force, push, zeta, end, **options):
    """When |u| first reaches a level, by SciPy from rest at u = 0."""

    def arrives(_, y):
        return abs(y[0]) - level

    arrives.terminal = True
    (at,) = by_time.motion(force, push, zeta, (0, end), (0.0, 0.0), events=arrives, **options).t_events[0]
    return at


#: tan(u), u/(1 - u^2), and u - u/(2 (1 - u^2)), which draws the mass towards |u| = 1: force, slope, place of the pole
POLES = {
    "tangent": (np.tan, lambda u: 1 / np.cos(u) ** 2, math.pi / 2),
    "stop": (lambda u: u / (1 - u * u), lambda u: (1 + u * u) / (1 - u * u) ** 2, 1.0),
    "magnet": (lambda u: u - u / (2 - 2 * u * u), lambda u: 1 - (1 + u * u) / (2 * (1 - u * u) ** 2), 1.0),
}


@pytest.mark.parametrize("name", POLES)
def test_force_without_bound_is_named_where_integration_stalls(name):
    """The place is the pole, not the angle at which a phase began; the time is that of an integration up to it."""
    force, slope, pole = POLES[name]
    system = EquationOfMotion(Force((Piece(Law(force, slope), ()),), ()), 0.0, 0.05)

    at = passes(pole * (1 - 1e-6), force, lambda tau: -50 * math.sin(math.pi / 2 * tau), 0.05, 2, rtol=1e-9)
    with pytest.raises(ArithmeticError, match="the restoring force grows without bound; at tau = ") as stalled:
        transient(system, half_sine(50.0, 2.0))
    near, tau = re.search(
        r"near u = (\S+), .* tau = (\S+), while the base is accelerated$", str(stalled.value)
    ).groups()
    assert float(near) == pytest.approx(-pole, rel=1e-5) and float(tau) == pytest.approx(at, rel=1e-4)
    if name == "magnet":
        with pytest.raises(ArithmeticError, match=r"near u = 1, .* without bound; at Omega = 0.9, F_0 = 2"):
            steady_state(system, Omega=0.9, F_0=2.0)


@pytest.mark.slow
def test_a_shock_or_a_release_that_escapes_is_told_with_its_time():
    """When |u| passes 10^6: of a release without damping by quadrature of du/u', of a record by another integrator."""
    duffing = Duffing(1.0, -0.5)
    whole = mp.quad(lambda u: 1 / mp.sqrt(9 - u**2 + (u**4 - 81) / 4), [3, 4, 10, 100, 1e6])
    with pytest.raises(ArithmeticError, match=r"the motion escapes.*; at tau = \S+, in the free motion$") as lost:
        transient(duffing.equation_of_motion(), np.empty((0, 4)), at=3.0)
    assert float(re.search(r"tau = (\S+),", str(lost.value))[1]) == pytest.approx(float(whole), rel=1e-5)
    times = np.linspace(0.0, 5.0, 26)
    samples = 3.0 * np.sin(times) * np.exp(-0.1 * times)
    at = passes(1e6, lambda u: u - 0.5 * u**3, lambda tau: -np.interp(tau, times, samples), 0.0, 5, max_step=0.05)
    with pytest.raises(ArithmeticError, match=r"the motion escapes.*, while the base is accelerated$") as lost:
        transient(duffing.equation_of_motion(), record(times, samples))
    assert float(re.search(r"tau = (\S+),", str(lost.value))[1]) == pytest.approx(float(at), rel=1e-5)
    assert "Omega" not in str(lost.value) and "F_0" not in str(lost.value)


def test_ever_faster_motion_is_given_up():
    """A trial may end where the mass swings a million times a turn: an error, not a wait."""
    stiff, drive = Duffing(1.0, 1e12).restoring_force().pieces[0], exact_reference.Drive(0.5, 0.1, 0.02, 0.0)
    with pytest.raises(ArithmeticError, match="the integration from theta = 0"):
        exact_reference.Compiled().advance(stiff, drive, 0.0, 1.0, 0.0, 3.0)


def of_duffing(alpha, beta, zeta, Omega, F_0, turns, state=(0.0, 0.0)):
    """States of u'' + 2 zeta u' + alpha u + beta u^3 = F_0 cos(Omega tau) at the start of each turn, by SciPy."""
    tau = 2.0 * math.pi / Omega * np.arange(turns + 1)
    force = lambda u: (alpha + beta * u**2) * u, lambda tau: F_0 * math.cos(Omega * tau)
    return by_time.motion(*force, zeta, (0.0, tau[-1]), state, t_eval=tau, atol=1e-11).y.T


#: oscillators whose mass at rest comes to a motion of that many turns, though one of the forcing's period is stable
SUBHARMONICS = [
    (4, 0.0, 1.0, 0.0165, 2.0728, 8.299),
    (5, 1.0, 1.0, 0.023445493449886168, 1.8718700791064578, 13.930319776119541),
    (9, 1.0, 1.0, 0.012621976287343788, 1.2951689005020457, 14.742921937607141),
    (2, 1.0, 1.0, 0.004654737533130629, 2.2502135050903855, 8.827226224864216),
]


@pytest.mark.slow
@pytest.mark.parametrize("turns, alpha, beta, zeta, Omega, F_0", SUBHARMONICS)
def test_motion_is_the_one_the_mass_comes_to(turns, alpha, beta, zeta, Omega, F_0):
    followed = of_duffing(alpha, beta, zeta, Omega, F_0, math.ceil(12.0 * Omega / (2.0 * math.pi * zeta)))
    found = Duffing(alpha, beta, zeta=zeta).steady_state(Omega=Omega, F_0=F_0)
    assert found.period * Omega / (2.0 * math.pi) == pytest.approx(turns)
    assert found.stable and not found.message
    # of a motion of so many turns it is in one of them
    _, u, v = found.series(turns)
    away = np.abs(np.column_stack((u, v)) - followed[-1]).max(axis=1)
    assert away.min() < 1e-3 * found.A
    assert np.abs(followed[-1] - followed[-1 - turns]).max() < 1e-3 * found.A
    shorter = [np.abs(followed[-1] - followed[-1 - fewer]).max() for fewer in range(1, turns)]
    assert min(shorter) > 0.01 * found.A


def test_motion_other_than_the_one_seen_says_so(monkeypatch):
    monkeypatch.setattr("slowflow.exact.shooting.MOST_TURNS", 12)
    found = Duffing(1.0, 0.1, zeta=0.001).steady_state(Omega=0.8, F_0=0.1)
    assert "the mass was not found to reach it from rest" in found.message and "after 12 periods" in found.message
    mount = Isolator.physical(m=25, k_v=9000, k_h=4000, n=3, L=0.08, preload=0.0, zeta=0.001)
    assert "the mass was not found to reach it" in mount.steady_state(f=3.3, F=2.0).message


@pytest.mark.slow
@pytest.mark.parametrize("Omega", [1.495, 1.5, 1.52])
def test_motion_that_turns_once_in_two_turns_is_closed(Omega):
    """Two springs of which one leaves at u = 4, under a load: by SciPy, from a mass at rest where it rests."""
    u, al, b = sp.Symbol("u", real=True), sp.Symbol("al", positive=True), sp.Symbol("b", positive=True)
    made = derive.mechanism("two_springs", [(al * u, b), (u - (1 - al) * b, None)], {"al": {}, "b": {}})
    found = made(al=0.25, b=4.0, zeta=0.02, load=1.2).steady_state(Omega=Omega, F_0=1.0)
    period, tau = 2.0 * math.pi / Omega, found.series(2)[0]

    def turns(span, state, fraction, **options):
        spring = lambda u: 0.25 * u if abs(u) <= 4.0 else u - math.copysign(3.0, u)  # noqa: E731
        push = lambda tau: math.cos(Omega * tau) + 1.2  # noqa: E731
        near = {"rtol": 1e-9, "atol": 1e-9, "max_step": fraction * period}
        return by_time.motion(spring, push, 0.02, (0.0, span * period), state, **near, **options)

    last = turns(160.0, (4.2, 0.0), 0.1)
    (turned,) = turns(2.0, last.y[:, -1], 0.02, events=lambda _, y: y[1]).y_events
    assert turned[:, 0].max() == pytest.approx(found.A, rel=1e-5)
    assert tau[1] == pytest.approx(period)
    if Omega == 1.5:
        assert found.A == pytest.approx(6.11521, abs=1e-5)
        assert np.abs(found.multipliers) == pytest.approx(0.846, abs=1e-3)


@pytest.mark.slow
def test_motion_is_stable_where_both_multipliers_are_small():
    """Of three motions at one frequency only the middle one is unstable: by SciPy, a perturbation of it grows.

    The product of the multipliers is exp(-2 zeta times the period), whatever the motion: one of them is always small.
    """
    oscillator, query = Duffing(1.0, 1.0, zeta=0.05), {"Omega": 1.6, "F_0": 0.3}
    motions = [oscillator.steady_state(**query, A=A) for A in (0.2, 1.2, 1.5)]
    curve = oscillator.exact_response(0.3, Omega=(1.2, 2.5), step=0.1)
    for motion in motions:
        ((_,), (u,), (v,)) = motion.series(1)
        perturbed = of_duffing(1.0, 1.0, 0.05, **query, turns=30, state=(u + 1e-4, v))
        stays = bool(np.hypot(*(perturbed[-1] - (u, v))) < 1e-4)
        assert motion.stable == stays
        assert np.prod(motion.multipliers).real == pytest.approx(math.exp(-0.1 * motion.period))
    assert [motion.stable for motion in motions] == [True, False, True]
    first, last = sorted(int(np.argmin(np.hypot(curve.Omega - fold.Omega, curve.A - fold.A))) for fold in curve.folds)
    assert last > first + 3 and not curve.stable[first : last + 1].any()
    assert curve.stable[:first].all() and curve.stable[last + 1 :].all()


def test_static_friction_holds_where_it_hardly_suffices():
    """The mass turns where the force on it is more than nine tenths of it: by SciPy from switch to switch."""
    spring, Omega, F_0 = Duffing(1.15, 0.5, 0.0392, 0.024, mu_s=0.0462), 0.614, 0.1
    found = spring.steady_state(Omega=Omega, F_0=F_0)
    u, theta = found.unknowns[:2]
    span, push = (theta / Omega, (theta + 2 * math.pi) / Omega), lambda tau: F_0 * math.cos(Omega * tau)
    ways = list(by_time.stretches(spring, lambda u: 1.15 * u + 0.5 * u**3, push, span, (u, 0.0)))
    assert ways[-1].u[-1] == pytest.approx(u, rel=1e-6) and found.A == pytest.approx(abs(u), rel=1e-12)
    held_by = [abs(push(one.t[0]) - 1.15 * one.u[0] - 0.5 * one.u[0] ** 3) for one in ways if one.slip == 0]
    assert found.stops == 2 <= len(held_by) and min(held_by) > 0.9 * spring.mu_s
