"""The compiled equation of motion: its series against 30 digits, its motions against SciPy's, its refusals."""

import math
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest

from slowflow import Duffing, Isolator
from slowflow.core.backend import EXACT
from slowflow.core.mechanism import Force
from slowflow.exact import EquationOfMotion, exact_response, linear, steady_state, sweep
from slowflow.exact.motion import Forced, follow, recurrences
from slowflow.exact.shooting import converge, lengths
from slowflow.example import TABLE_1
from slowflow_kernels import rod_spring
from slowflow_kernels.exact_conventions import Event
from tests.oracles.exact_cases import random_cases, random_motions
from tests.oracles.exact_reference import Compiled, Drive, ScipyIntegrator, again
from tests.sampling import part

OURS = Compiled()

LAM, R, DELTA_H = 3.0, 0.6, 0.25
ISOLATOR = Isolator(lam=LAM, r=R, delta_h=DELTA_H)
# (7), as doubles: they are what the truncated force takes
ALPHA, BETA, GAMMA = ISOLATOR.alpha, ISOLATOR.beta, ISOLATOR.gamma
# a piece, the same force and its slope by hand for mpmath, and a state well inside of it
PIECES = {
    "linear": (ISOLATOR.restoring_force().pieces[1], lambda u: u, lambda u: 1, (0.3, -0.2)),
    "duffing": (
        Duffing(0.7, 1.3).restoring_force().pieces[0],
        lambda u: mp.mpf(0.7) * u + mp.mpf(1.3) * u**3,
        lambda u: mp.mpf(0.7) + 3 * mp.mpf(1.3) * u**2,
        (0.9, 0.4),
    ),
    "truncated": (
        ISOLATOR.restoring_force("truncated").pieces[0],
        lambda u: mp.mpf(ALPHA) * u + mp.mpf(BETA) * u**3 + mp.mpf(GAMMA) * u**5,
        lambda u: mp.mpf(ALPHA) + 3 * mp.mpf(BETA) * u**2 + 5 * mp.mpf(GAMMA) * u**4,
        (0.4, 0.3),
    ),
    "untruncated": (
        ISOLATOR.restoring_force("untruncated").pieces[0],
        lambda u: u + 3 * mp.mpf(R) * ((1 - mp.mpf(DELTA_H)) / mp.sqrt(1 - u * u) - 1) * u,
        lambda u: 1 + 3 * mp.mpf(R) * ((1 - mp.mpf(DELTA_H)) / mp.sqrt(1 - u * u) ** 3 - 1),
        (0.35, -0.2),
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("end", [2.9, -0.6])
@pytest.mark.parametrize("name", PIECES)
@pytest.mark.part(4)
def test_states_and_derivatives_against_twenty_five_digits(name, end):
    """Forwards and backwards in theta, and the derivatives from the equations of variation, typed by hand."""
    piece, force, slope, (u, v) = PIECES[name]
    Omega, F_0, zeta, friction, theta = 0.9, 0.11, 0.03, -0.02, 0.4
    with mp.workdps(25):
        sign = 1 if end > theta else -1  # mpmath goes forwards only
        Om, F, z = mp.mpf(Omega), mp.mpf(F_0), mp.mpf(zeta)

        def rates(s, y):
            at = mp.mpf(theta) + sign * s
            of_u = y[1] / Om
            of_v = (F * mp.cos(at) - force(y[0]) - 2 * z * y[1] - mp.mpf(friction)) / Om
            out = [of_u, of_v]
            for c in range(4):
                out.append(y[6 + c] / Om - (of_u / Om if c == 2 else 0))
            for c in range(4):
                U, V = y[2 + c], y[6 + c]
                own = -of_v / Om if c == 2 else mp.cos(at) / Om if c == 3 else 0
                out.append((-slope(y[0]) * U - 2 * z * V) / Om + own)
            return [sign * rate for rate in out]

        start = [mp.mpf(u), mp.mpf(v), 1, 0, 0, 0, 0, 1, 0, 0]
        y = mp.odefun(rates, 0, start, tol=mp.mpf(10) ** -20)(abs(mp.mpf(end) - mp.mpf(theta)))
    found_u, found_v, flow = OURS.advance(piece, Drive(Omega, F_0, zeta, friction), theta, u, v, end)
    assert max(abs(found_u - y[0]), abs(found_v - y[1])) <= 4e-16
    assert np.max(np.abs(flow.ravel() - np.array(y[2:], dtype=float))) <= 5e-15


@pytest.mark.parametrize("integrator", [OURS, ScipyIntegrator()], ids=lambda one: one.name)
def test_structural_damping_goes_with_the_frequency_in_gradients(integrator):
    """The derivative by Omega against a difference: zeta + eta/(2 Omega) is that of either frequency."""
    piece = PIECES["duffing"][0]

    def at(Omega):
        drive = Drive(Omega, 0.3, 0.02 + 0.3 / (2 * Omega), 0.0, 0.4, -0.3 / (2 * Omega**2))
        u, v, flow = integrator.advance(piece, drive, 0.7, 0.9, 0.4, 1.4)
        return np.array((u, v)), flow[:, 2]

    (above, _), (below, _), (_, slope) = at(0.8 + 1e-5), at(0.8 - 1e-5), at(0.8)
    assert slope == pytest.approx((above - below) / 2e-5, rel=1e-8)


@pytest.mark.parametrize("zeta", [0.0, 0.02, 0.7])
def test_a_stop_is_found_where_the_closed_form_has_it(zeta):
    """The linear oscillator released from rest: v = 0 again where the closed form says, to the last places."""
    Omega, F_0, friction, theta, u = 0.37, 0.2, 0.05, 1.1, 0.6
    at, _, v_end, event = OURS.until(
        linear().pieces[0], Drive(Omega, F_0, zeta, -friction), -1, -1e6, theta, u, 0.0, theta + 6.0
    )
    with mp.workdps(40):
        Om, z = mp.mpf(Omega), mp.mpf(zeta)
        response = mp.mpf(F_0) / (1 - Om**2 + 2j * z * Om)
        root = -z + mp.sqrt(z * z - 1) if z != 0 else mp.mpc(0, 1)
        other = -z - mp.sqrt(z * z - 1) if z != 0 else mp.mpc(0, -1)
        forced = lambda s: (response * mp.expj(theta + Om * s)).real + mp.mpf(friction)  # noqa: E731
        rate = (response * mp.mpc(0, 1) * Om * mp.expj(theta)).real
        b = (-rate - root * (mp.mpf(u) - forced(0))) / (other - root)
        a = mp.mpf(u) - forced(0) - b

        def velocity(s):
            return (response * mp.mpc(0, 1) * Om * mp.expj(theta + Om * s)).real + (
                a * root * mp.exp(root * s) + b * other * mp.exp(other * s)
            ).real

        first = mp.findroot(velocity, (mp.mpf(at) - theta) / Om)
        assert all(velocity(first * k / 400) < 0 for k in range(1, 400)), "an earlier stop was skipped"
        expected = theta + Om * first
    assert event == Event.STOP and v_end == 0.0
    assert abs(at - expected) <= 1e-15 * max(1.0, float(abs(expected)))


def test_a_graze_is_told_from_a_stop():
    """v(t) of u'' = F_0 cos theta - u comes within a depth d of zero and back: a stop for d < 0, none for d > 0.

    With u(0) = V F_0 and any v_0 > 0 the velocity is v_0 cos t - V F_0 Omega sin(Omega t); v_0 is chosen by 40 digits
    so that its first minimum is d.
    """
    Omega, F_0 = 5.3, 1.0
    V = 1 / (1 - mp.mpf(Omega) ** 2)
    with mp.workdps(40):

        def velocity(t, v_0):
            return v_0 * mp.cos(t) - V * F_0 * mp.mpf(Omega) * mp.sin(mp.mpf(Omega) * t)

        def lowest(v_0):
            at = mp.findroot(lambda t: mp.diff(lambda s: velocity(s, v_0), t), 3 * mp.pi / 2 / Omega)
            return at, velocity(at, v_0)

        touching = mp.findroot(lambda v_0: lowest(v_0)[1], mp.mpf("0.25"))
        where = lowest(touching)[0]
    drive, piece = Drive(Omega, F_0, 0.0, 0.0), linear().pieces[0]
    for depth in (1e-3, 1e-6, 1e-9, 1e-12, 1e-14):
        over = OURS.until(piece, drive, 1, 1e6, 0.0, float(V * F_0), float(touching) + depth, Omega * 1.3)
        under = OURS.until(piece, drive, 1, 1e6, 0.0, float(V * F_0), float(touching) - depth, Omega * 1.3)
        assert over[3] == Event.TIME, depth
        assert under[3] == Event.STOP and abs(under[0] / Omega - float(where)) <= 4 * math.sqrt(depth), depth

    # no double is nearer: whether the mass stops cannot be said, and it is said so
    for depth, undecided in ((0.0, True), (1e-9, False), (-1e-9, False)):
        forced = Forced(EquationOfMotion(linear(), 0.0, 1e-300), Omega, F_0)
        first = follow(forced, 0.0, float(V * F_0), float(touching) + depth, Omega * 1.3)[0]
        assert first.undecided is undecided, depth


def shipped():
    """Every force that is compiled with the package, with and without friction, below, at and above resonance."""
    forces = [
        *(ISOLATOR.restoring_force(which) for which in ("truncated", "untruncated")),
        *(Duffing(alpha, beta).restoring_force() for alpha, beta in ((1.0, 0.5), (0.0, 1.0), (1.0, -0.05))),
    ]
    damping = ((0.0, 0.05), (0.02, 0.03))
    return [(EquationOfMotion(f, *d), at, 0.1) for f in forces for d in damping for at in (0.2, 0.6, 1.4)]


@pytest.fixture(scope="module")
def motions():
    """200 random oscillators of every kind and the shipped ones: each query with its steady state.

    By other seeds some of those with static friction are chaotic.
    """
    queries = [*random_motions(200, seed=12), *shipped()]
    return [(one, steady_state(one[0], Omega=one[1], F_0=one[2])) for one in queries]


def condition(found):
    """What an error of the map over a period is enlarged by."""
    return 1.0 / (1.0 - np.max(np.abs(found.multipliers)))


@pytest.mark.slow
def test_motions_of_every_oscillator_are_scipys(motions):
    """Amplitude, multipliers and switches: to 1e-10 times the motion's condition; they close to 1e-14."""
    for one, found in motions:
        assert found.residual <= 1e-14, one
        other = again(found)
        assert abs(other.A - found.A) <= 1e-10 * condition(found) * found.A, one
        assert np.max(np.abs(other.multipliers - found.multipliers)) <= 1e-10 * condition(found), one


@pytest.mark.slow
def test_sixteen_threads_find_the_motions_that_one_finds(motions):
    """The same digits, equal to those that a sweep to that single frequency converges to."""

    def again(query):
        system, Omega, F_0 = query
        found = steady_state(system, Omega=Omega, F_0=F_0)
        return found.cycle.signature, found.A, found.multipliers.tolist(), sweep(system, Omega=[Omega], F_0=F_0).A[0]

    with ThreadPoolExecutor(16) as pool:
        for (case, found), there in zip(motions, pool.map(again, [one for one, _ in motions]), strict=True):
            assert there == (found.cycle.signature, found.A, found.multipliers.tolist(), found.A), case


@pytest.mark.slow
def test_sweeps_settle_to_motions_of_scipy(motions):
    """At a frequency that is come to from another one: the amplitude is that of a motion as SciPy finds it, to 1e-10.

    It begins where the motion of the sweep has its highest point.
    """
    apart, by_scipy = 0, set(part(range(len(motions)), 4))
    for k, ((system, Omega, F_0), from_rest) in enumerate(motions):
        forced = Forced(system, Omega, F_0)
        swept = sweep(system, Omega=[1.1 * Omega, Omega], F_0=F_0)
        assert swept.settled.all(), (system, Omega, F_0)
        before = converge(forced._replace(Omega=1.1 * Omega), 0.0, 0.0, 0.0, lengths(system), 2000)
        found = converge(forced, 0.0, before.u, before.v, lengths(system), 2000).found
        assert found.A == swept.A[1]
        if k in by_scipy:
            other = again(found)
            assert abs(other.A - swept.A[1]) <= 1e-10 * condition(found) * swept.A[1], (system, Omega, F_0)
        apart += abs(found.A - from_rest.A) > 1e-6 * found.A
    assert apart > 0


def test_motion_under_several_laws_of_damping_is_scipys():
    """With rests and beyond u_cr: amplitude, multipliers, switches."""
    damping = {"zeta": 0.02, "mu": 0.02, "mu_s": 0.03, "contact": "attached", "c_2": 0.3}
    found = steady_state(ISOLATOR.replace(**damping).equation_of_motion(), Omega=0.3, F_0=0.036)
    other = again(found)
    assert found.stops == 2 and found.residual <= 1e-14
    assert other.A == pytest.approx(found.A, rel=1e-11)
    assert np.max(np.abs(other.multipliers - found.multipliers)) <= 1e-11


@pytest.mark.parametrize(
    ("oscillator", "Omega", "F_0", "stops"),
    [
        (Isolator(**TABLE_1, excitation="base"), 0.7, 0.05, 0),
        (Duffing(1.0, 0.5, 0.02, 0.02, mu_s=0.045), 0.3, 0.05, 2),
        (Duffing(1.0, 0.5, 0.02, 0.02, load=-0.2), 0.6, 0.1, 0),
    ],
)
def test_derivatives_of_a_cycle_are_those_of_its_equations(oscillator, Omega, F_0, stops):
    """Under a load downwards the largest |u| is where u is least; the others are half-wave symmetric."""
    motion, step = oscillator.steady_state(Omega=Omega, F_0=F_0), 1e-5
    cycle = motion.cycle
    assert motion.stops == stops and motion.symmetric == oscillator.equation_of_motion().centred
    # away from the solution: on it two turning points have the same |u|, and A a kink
    at = np.append(motion.unknowns + 1e-3, F_0)

    def values(of):
        found = cycle.equations(of[:-1], of[-1])
        return np.array([*found.residual, found.A, *(border.margin for border in found.borders)])

    found = cycle.equations(at[:-1], F_0)
    derivatives = np.array([*found.jacobian, found.of_A, *(border.gradient for border in found.borders)])
    differences = [(values(at + step * e) - values(at - step * e)) / (2 * step) for e in np.eye(at.size)]
    assert np.allclose(derivatives, np.array(differences).T, rtol=0, atol=1e-6)


@pytest.mark.slow
def test_curve_is_nearly_straight_between_its_points():
    """Steps and angles as `exact_response` states them, in the norm in which tangents are of unit length."""
    cases = [(case.system, case.F_0, (0.3, 1.8), None) for case in random_cases(6, seed=11)]
    for system, F_0, window, start in [*cases, isola()]:
        curve = exact_response(system, F_0, Omega=window, start=start)
        assert curve.closed == (start is not None)
        points = [point for point in curve.states if not point.role]
        smooth = 0
        for one, other in pairwise(points):
            if one.cycle.signature != other.cycle.signature:
                continue
            smooth += 1
            weights = np.array([1 / one.z[0] ** 2, 1.0, *[0.1] * len(one.cycle.signature), 4.0])
            assert one.tangent @ (weights * one.tangent) == pytest.approx(1.0, rel=1e-12)
            assert one.tangent @ (weights * other.tangent) > 0.98
            assert np.sum(weights * (other.z - one.z) ** 2) < (2 * 0.02) ** 2
        assert smooth > 0.9 * len(points)


@pytest.mark.slow
def test_folds_next_to_a_border_do_not_depend_on_the_step():
    """A pair 6e-9 apart in Omega, where the mass touches the end of a piece: rounding decided whether it was found."""
    system, _, F_0 = random_motions(29, seed=101)[-1]
    curves = [exact_response(system, F_0, Omega=(1.0, 1.2), step=step) for step in (0.02, 0.01, 0.005)]
    for curve in curves:
        assert [(fold.kind, fold.corner) for fold in curve.folds] == 2 * [("jump-up", True), ("jump-down", False)]
        frequencies = [fold.Omega for fold in curve.folds]
        assert np.allclose(frequencies, [fold.Omega for fold in curves[0].folds], rtol=1e-12, atol=0.0)


def test_edge_and_stop_within_one_rounding_are_one_turn():
    """u'' = -u from rest at the top, by the cosine alone: it turns at -1, and the next piece begins within 8 ulps.

    An edge that the mass does not reach is a stop; one that it passes, however little, an edge with the velocity that
    the energy leaves; one at the place itself either of them, to rounding, and the motion goes on as if it were not.
    """
    drive, piece = Drive(0.37, 0.0, 0.0, 0.0), linear().pieces[0]
    turn = math.pi * 0.37
    for ulps in range(-8, 9):
        edge = -1.0 + ulps * 2.0**-53  # below -1 a double is every second of these
        at, u, v, event = OURS.until(piece, drive, -1, edge, 0.0, 1.0, 0.0, 2.0)
        left = (1.0 - edge) * (1.0 + edge)  # of the square of the velocity
        assert event in (Event.STOP, Event.EDGE), ulps
        assert u == edge or event == Event.STOP, ulps
        assert abs(u + 1.0) <= 2e-15 and abs(v * v - max(left, 0.0) * (event == Event.EDGE)) <= 1e-15, ulps
        # the time of either is known to the root of a rounding
        assert abs(at - turn) <= 1e-7, ulps
    assert OURS.until(piece, drive, -1, -1.0 - 1e-13, 0.0, 1.0, 0.0, 2.0)[3] == Event.STOP
    assert OURS.until(piece, drive, -1, -1.0 + 1e-13, 0.0, 1.0, 0.0, 2.0)[3] == Event.EDGE


@pytest.mark.parametrize("jump", [0.0, 0.2])
def test_motion_that_turns_at_a_breakpoint_goes_on(jump):
    """A free mass under friction: each turn is 2 mu lower, and the force's corner or jump is within 8 ulps of a turn.

    Beyond the breakpoint it would stick or be pushed back; a distance of one rounding there has no visible effect.
    """
    mu, Omega = 0.03, 0.37
    for ulps in range(-8, 9):
        # from 1 to -(1 - 2 mu), where it stops and slips back to 1 - 4 mu
        bend = (1.0 - 2.0 * mu) * (1.0 + ulps * 2.0**-52)
        outer = Duffing(1.0 + jump, 0.0).restoring_force().pieces[0]
        force = Force((linear().pieces[0], outer), (bend,))
        forced = Forced(EquationOfMotion(force, mu, 0.0), Omega, 1e-300)
        # it begins with no velocity below the top of the inner piece, thrown so that its energy is that of a start at 1
        start = 0.5
        speed = -math.sqrt((1.0 - mu) ** 2 - (start - mu) ** 2)
        phases = follow(forced, 0.0, start, speed, 2.0 * math.pi * Omega)
        stops = [phase for phase in phases if phase.event == Event.STOP]
        assert abs(stops[0].u_end + (1.0 - 2.0 * mu)) <= 4e-15, ulps
        # what is gone beyond a bend is a rounding, and its time the root of one
        assert abs(stops[1].u_end - (1.0 - 4.0 * mu)) <= 4e-15 + 1e-7 * jump, ulps


def isola():
    """A closed curve, which a spring has that softens and then hardens; and a motion on it."""
    spring = EquationOfMotion(Force.of(rod_spring.MECHANISM, (1.0, -1.0, 0.27, 50.0)), 0.0, 0.02)
    start = steady_state(spring, (1.3, -1.27), Omega=0.4, F_0=0.0264, half_turns=1)
    return spring, 0.0264, (0.1, 1.5), start


def test_every_shipped_force_is_compiled():
    for oscillator in (Isolator(lam=3, r=1.0, delta_h=0.1, mu=0.01, zeta=0.02), Duffing(1.0, 0.5, 0.01, 0.02)):
        for which in (None, "truncated", "untruncated") if isinstance(oscillator, Isolator) else (None,):
            assert all(piece.law.name in EXACT.LAWS for piece in oscillator.restoring_force(which).pieces)


def test_c_refuses_what_does_not_fit():
    damping = 0.0, 0.1, False, 0.0, 0.0, False, 0.0, 0.0, 0.0, 0.0
    piece = linear().pieces[0]
    number = recurrences(piece.law)
    with pytest.raises(ValueError, match="pieces of a force"):
        EXACT.system((number,), (), (), 0, True, *damping)
    with pytest.raises(ValueError, match="PyCapsule"):
        EXACT.system((10**6,), ((),), (), 0, True, *damping)
    for constants in ((), (1.0, 0.0), 3.0):
        with pytest.raises(ValueError, match="as many constants as it takes, 3"):
            EXACT.system((number,), (constants,), (), 0, True, *damping)
    with pytest.raises(TypeError, match="real number"):
        EXACT.system((number,), ((1.0, "0", 0.0),), (), 0, True, *damping)
    system = EXACT.system((number,), ((1.0, 0.0, 0.0),), (), 0, True, *damping)
    with pytest.raises(ValueError, match="room for too few"):
        EXACT.advance(system, 1.0, 1.0, 1, 0, 0.0, 0.0, 0.0, 1.0, 100, np.empty(7))
    with pytest.raises(ValueError, match="no piece of a force is number 1"):
        EXACT.advance(system, 1.0, 1.0, 1, 1, 0.0, 0.0, 0.0, 1.0, 100, np.empty(8))
    for rows in (np.empty(0), np.zeros(134), np.ones(133)):
        with pytest.raises(ValueError, match="no polynomials of a force"):
            EXACT.polynomials(rows, rows)
    with pytest.raises(ValueError, match="do not fit"):
        EXACT.newton(
            system, b"\0" * 8, 1, np.zeros(9), 0.1, 0, np.zeros(9), 0.0, 0, 5, 1e-13, 100, np.zeros(99), np.zeros(9)
        )
    with pytest.raises(ValueError, match="PyCapsule"):
        EXACT.follow(3, 1.0, 0.1, 0.0, 0.0, 0.0, 1.0, False, 0, 0, 100)
