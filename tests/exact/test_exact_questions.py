"""What `Isolator` and `Duffing` ask of the equation of motion: interface, guesses, refusals."""

import re
import subprocess
import sys

import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import root

from slowflow import Duffing, Isolator, exact
from slowflow.exact import EquationOfMotion, linear
from slowflow.exact.motion import limited
from slowflow.example import isolator
from slowflow.support.errors import NotSettled
from tests.files import MOUNT
from tests.oracles import by_time
from tests.sampling import slow


def from_place(force, *, load, zeta, Omega, F_0, u, periods=200):
    """Largest |u| that u'' + 2 zeta u' + f(u) = load + F_0 cos(Omega tau) comes to from rest at u, by SciPy."""
    push = lambda tau: load + F_0 * np.cos(Omega * tau)  # noqa: E731
    return np.abs(by_time.settled(force, push, zeta, Omega, (u, 0.0), periods, last=4)[1]).max()


@pytest.mark.slow
def test_a_mass_at_rest_begins_where_load_and_spring_balance():
    """Under a load, on a force that is not odd, and between two wells; by SciPy from the place that is a root of f."""
    cubic = {"load": 0.3, "zeta": 0.05, "Omega": 0.9, "F_0": 0.25}
    equilibrium = root(lambda u: u + u**3 - 0.3, 0.3).x[0]
    loaded = Duffing(1.0, 1.0, zeta=0.05, load=0.3)
    expected = from_place(lambda u: u + u**3, u=equilibrium, **cubic)
    assert loaded.steady_state(Omega=0.9, F_0=0.25).A == pytest.approx(expected, rel=1e-5)
    well = {"load": 0.0, "zeta": 0.1, "Omega": 1.2, "F_0": 0.1}
    double = Duffing(-1.0, 1.0, zeta=0.1)
    right = from_place(lambda u: u**3 - u, u=1.0, **well)
    left = from_place(lambda u: u**3 - u, u=-1.0, **well)
    found = double.steady_state(Omega=1.2, F_0=0.1)
    assert found.A == pytest.approx(right, rel=1e-5) and found.harmonics(0)[0].real > 0
    assert "at u = -1, 1: the mass starts from u = 1" in found.message
    other = double.steady_state(Omega=1.2, F_0=0.1, u_0=-1.0)
    assert other.A == pytest.approx(left, rel=1e-5) and other.harmonics(0)[0].real < 0 and other.message == ""
    swept = double.sweep(Omega=[1.2], F_0=0.1), double.sweep(Omega=[1.2], F_0=0.1, u_0=-1.0)
    assert [one.A[0] for one in swept] == pytest.approx([right, left], rel=1e-5)
    assert swept[0].message == found.message and swept[1].message == ""
    with pytest.raises(ValueError, match="A selects a motion, u_0 and v_0 set the start"):
        double.steady_state(Omega=1.2, F_0=0.1, A=1.0, u_0=-1.0)


@pytest.mark.slow
def test_loaded_isolator_comes_to_the_motion_from_its_rest():
    """From u = 0, where it does not rest, it comes to one of A = 0.2485."""
    iso = Isolator(lam=3, r=2.03, delta_h=0.082, mu=0.0, zeta=0.02, load=0.0455)
    force = iso.restoring_force()
    equilibrium = root(lambda u: force.value(float(u[0])) - 0.0455, 0.09).x[0]

    def f(u):
        return np.copysign(force.value(abs(u)), u)

    expected = from_place(f, load=0.0455, zeta=0.02, Omega=0.9261, F_0=0.0434, u=equilibrium)
    assert expected == pytest.approx(0.5409, abs=1e-4)
    assert iso.steady_state(Omega=0.9261, F_0=0.0434).A == pytest.approx(expected, rel=1e-5)
    assert iso.sweep(Omega=[0.9261], F_0=0.0434).A[0] == pytest.approx(expected, rel=1e-5)
    assert iso.exact_response(0.0434, Omega=(0.9261, 0.94)).A[0] == pytest.approx(expected, rel=1e-5)
    assert iso.steady_state(Omega=0.9261, F_0=0.0434, u_0=0.0).A == pytest.approx(0.2485, abs=1e-4)


@pytest.mark.slow
def test_a_curve_begins_in_the_well_that_is_chosen():
    """With a load the two wells differ: their motions do, and the curve says which of them it is."""
    oscillator = Duffing(-1.0, 1.0, zeta=0.1, load=0.1)
    wells = sorted(np.roots([1, 0, -1, -0.1]).real)[::2]
    curves = [oscillator.exact_response(0.05, Omega=(1.0, 1.2), u_0=u) for u in (None, *wells)]
    assert "the mass starts from u = -0.94" in curves[0].message
    for curve, u in zip(curves[1:], wells, strict=True):
        expected = from_place(lambda u: u**3 - u, load=0.1, zeta=0.1, Omega=1.0, F_0=0.05, u=u)
        assert curve.A[0] == pytest.approx(expected, rel=1e-5)
    assert curves[0].A[0] == pytest.approx(curves[1].A[0], rel=1e-12) != curves[2].A[0]


def test_a_mass_at_rest_comes_to_a_stable_motion():
    """Negative stiffness at rest: the averaged state about u = 0 leads to a motion, but an unstable one."""
    oscillator = isolator(delta_h=0.27, mu=0.00116, zeta=0.093, r=2.79)
    (A,) = oscillator.amplitudes(Omega=1.14, F_0=0.005844).A
    about_zero = oscillator.steady_state(Omega=1.14, F_0=0.005844, A=A)
    assert not about_zero.stable and about_zero.symmetric
    found = oscillator.steady_state(Omega=1.14, F_0=0.005844)
    assert found.stable and not found.symmetric
    assert abs(found.harmonics(0)[0].real) > 0.1


def test_a_motion_shows_its_series_and_harmonics():
    state = isolator().steady_state(Omega=0.9, F_0=0.04)
    tau, u, _ = state.series(256)
    assert tau[0] == 0 and tau[-1] < state.period == pytest.approx(2 * np.pi / 0.9)
    # by the trapezoidal rule, which converges like the motion is smooth: friction jumps twice a turn
    c = 2 * np.mean(u * np.exp(-1j * 0.9 * tau))
    assert state.harmonics(1)[1] == pytest.approx(c, abs=1e-5)
    assert np.abs(u).max() == pytest.approx(state.A, rel=1e-3)
    assert state.stops == 0 and np.all(np.abs(state.multipliers) < 1)


def test_force_is_the_averaged_one_or_the_one_requested():
    truncated = isolator().steady_state(Omega=0.95, F_0=0.04, A=0.5, force="truncated").A
    untruncated = isolator().steady_state(Omega=0.95, F_0=0.04, A=0.5, force="untruncated").A
    assert isolator().steady_state(Omega=0.95, F_0=0.04, A=0.5).A == truncated
    assert 1e-4 < abs(untruncated / truncated - 1) < 1e-2


def test_a_curve_may_start_anywhere_on_it():
    start = isolator().steady_state(Omega=0.95, F_0=0.04, A=0.5)
    curve = isolator().exact_response(0.04, Omega=(0.8, 1.05), start=start)
    whole = isolator().exact_response(0.04, Omega=(0.8, 1.05))
    assert [fold.Omega for fold in curve.folds] == pytest.approx([fold.Omega for fold in whole.folds], abs=1e-10)


# a softening spring with friction: above F_0 = 0.2247 the resonance has left the curve through the motions from rest
SOFTENING, SOFTENING_F_0, SOFTENING_WINDOW = Duffing(1.0, -0.5, 0.05, 0.1), 0.350001, (0.4, 1.5)


def test_the_message_leads_to_a_curve_apart():
    """Numbers read from the message start the other curve, whose message leads back."""
    one = SOFTENING.exact_response(SOFTENING_F_0, Omega=SOFTENING_WINDOW)
    other = one
    for _ in range(2):
        numbers = re.search(r"start = steady_state\(Omega=(.*), F_0=\.\.\., A=(.*)\) leads", other.message).groups()
        Omega, A = (float(number) for number in numbers)
        start = SOFTENING.steady_state(Omega=Omega, F_0=SOFTENING_F_0, A=A)
        assert start.A == pytest.approx(A, rel=0.1)
        last, other = other, SOFTENING.exact_response(SOFTENING_F_0, Omega=SOFTENING_WINDOW, start=start)
    # back on the first one, which turns round at a fold; the resonance is the other
    assert [fold.Omega for fold in other.folds] == pytest.approx([fold.Omega for fold in one.folds], abs=1e-9)
    assert one.Omega.max() < 0.7 and last.Omega.max() == pytest.approx(1.5)
    assert SOFTENING.sweep(F_0=SOFTENING_F_0, Omega=[0.5]).A[0] == pytest.approx(
        one.A[np.argmin(abs(one.Omega - 0.5))], rel=0.05
    )


def test_no_message_where_one_curve_is_all():
    assert isolator().exact_response(0.04).message == ""
    assert isolator(mu=0.028).exact_response(0.04, Omega=(0.5, 1.3)).message == ""
    # but a window that ends between the folds cuts the curve in two
    cut = isolator().exact_response(0.04, Omega=(0.5, 0.95))
    assert "steady_state(Omega=0.8896, F_0=..., A=0.1373)" in cut.message and cut.A[-1] > 0.5
    rest = isolator().exact_response(
        0.04, Omega=(0.5, 0.95), start=isolator().steady_state(Omega=0.8896, F_0=0.04, A=0.1373)
    )
    assert [fold.kind for fold in rest.folds] == ["jump-up"]


def test_near_a_fold_of_averaging_the_branch_asked_for_is_found():
    """Averaging's fold lies at Omega = 1.26754, that of the motion at 1.26960: between them averaging has one state."""
    oscillator = Duffing(1.0, 0.1, 0.0, 0.025)
    assert oscillator.amplitudes(Omega=1.2687, F_0=0.18).A == pytest.approx([0.297], abs=1e-3)
    found = oscillator.steady_state(Omega=1.2687, F_0=0.18, A=2.83)
    assert not found.stable and found.residual <= 1e-11
    assert oscillator.steady_state(Omega=1.2687, F_0=0.18, A=0.3).A == pytest.approx(0.297, rel=0.01)
    assert oscillator.steady_state(Omega=1.2687, F_0=0.18).A == pytest.approx(0.297, rel=0.01)


@pytest.mark.slow
def test_motions_beside_a_fold_are_those_scipy_finds():
    """Half a turn by SciPy, force and variations typed in, closed by SciPy's root: the lower one is not stable."""
    oscillator = Duffing(1.0, 0.1, 0.0, 0.025)

    def half_a_turn(highest, theta):
        def rates(tau, y):
            stiffness = 1.0 + 0.3 * y[0] ** 2
            push = 0.18 * np.cos(1.2687 * tau + theta) - y[0] - 0.1 * y[0] ** 3 - 0.05 * y[1]
            bent = [-stiffness * y[i] - 0.05 * y[i + 1] for i in (2, 4)]
            return [y[1], push, y[3], bent[0], y[5], bent[1]]

        start = [highest, 0.0, 1.0, 0.0, 0.0, 1.0]
        return solve_ivp(rates, (0.0, np.pi / 1.2687), start, method="DOP853", rtol=1e-13, atol=1e-14).y[:, -1]

    for A, stable, largest in ((2.83, False, 1.0597), (2.9, True, 0.8835)):
        found = oscillator.steady_state(Omega=1.2687, F_0=0.18, A=A)
        near = [A, float(found.unknowns[1]) + 1e-3]
        closed = root(lambda x: half_a_turn(*x)[:2] + np.array([x[0], 0.0]), near, tol=1e-13)
        multipliers = np.linalg.eigvals(half_a_turn(*closed.x)[2:].reshape(2, 2).T) ** 2
        assert np.abs(multipliers).max() == pytest.approx(largest, abs=1e-4)
        assert found.stable is stable is bool(np.abs(multipliers).max() < 1.0)
        # SciPy's own error, times the condition beside a fold
        assert found.A == pytest.approx(closed.x[0], rel=1e-10)
        assert np.sort_complex(found.multipliers) == pytest.approx(np.sort_complex(multipliers), abs=1e-9)


@pytest.mark.parametrize("ratio", [0.8, 0.95, 0.99])
def test_drift_near_sticking_ends_where_integration_stays(ratio):
    """No stiffness at u = 0 and friction near the forcing: from rest the motion drifts for 10^5 turns and more.

    It is found nevertheless, SciPy comes back to it, and a sweep says the same amplitude.
    """
    mu, zeta, Omega, F_0 = 0.1 * ratio, 0.05, 0.9, 0.1
    oscillator = Duffing(0.0, 1.0, mu, zeta)
    found = oscillator.steady_state(Omega=Omega, F_0=F_0)
    assert found.stable and found.symmetric and found.stops == 2
    tau, u, v = found.series(64)
    at = int(np.argmax(np.abs(v)))
    force = ((lambda x: x**3,), ())
    end, _, stops = by_time.turns_of(force, (mu, zeta), Omega, F_0, (tau[at], u[at], v[at]), 1)
    assert stops == 2
    assert np.max(np.abs(np.subtract(end, (u[at], v[at])))) <= 1e-9 * found.A
    swept = oscillator.sweep(Omega=[0.8, 0.9, 1.0, 0.9], F_0=F_0)
    assert swept.settled.all()
    assert swept.A[[1, 3]] == pytest.approx(found.A, rel=1e-9)


def slips_without_a_spring(mu, zeta, Omega, F_0):
    """Half the way of a mass that friction holds but about the forcing's peaks, and no spring: its amplitude."""
    with mp.workdps(30):
        mu, damps, Om, F = mp.mpf(mu), 2 * mp.mpf(zeta), mp.mpf(Omega), mp.mpf(F_0)
        begins = -mp.acos(mu / F) / Om
        forced = lambda t: (F / (damps + 1j * Om) * mp.expj(Om * t)).real - mu / damps  # noqa: E731
        velocity = lambda t: forced(t) - forced(begins) * mp.exp(damps * (begins - t))  # noqa: E731
        ends = mp.findroot(velocity, -2 * begins)
        return float(mp.quad(velocity, mp.linspace(begins, ends, 5)) / 2)


@pytest.mark.parametrize(
    "oscillator", [Duffing(0.0, 1.0, 0.0, 0.05), Isolator(lam=3, r=1, delta_h=1 / 3, zeta=0.05, mu=0)]
)
@pytest.mark.parametrize("ratio", [0.98, 0.99, 0.995, 0.999])
def test_without_a_spring_motion_and_sweep_have_closed_forms(oscillator, ratio):
    """Quasi-zero stiffness next to sticking: the mean drifts by 1e-18 and less in a turn, and was never seen to settle.

    The spring adds a share (A^2 over the part of F_0 that exceeds friction) to the amplitude: 1e-11 at most.
    """
    oscillator = oscillator.replace(mu=0.05 * ratio)
    found = oscillator.steady_state(Omega=1.5, F_0=0.05)
    assert found.A == pytest.approx(slips_without_a_spring(0.05 * ratio, 0.05, 1.5, 0.05), rel=1e-11)
    assert found.stable and found.stops == 2 and found.residual <= 1e-17
    assert oscillator.steady_state(Omega=1.5, F_0=0.05, A=found.A).A == pytest.approx(found.A, rel=1e-12)
    swept = oscillator.sweep(Omega=[1.4, 1.5, 1.6, 1.5], F_0=0.05)
    assert swept.settled.all() and swept.A[[1, 3]] == pytest.approx(found.A, rel=1e-12)


@pytest.mark.slow
def test_neutral_mean_that_is_driven_off_is_not_settled_on():
    """The same with negative stiffness too small to be felt in a turn: the motion about u = 0 is not stable."""
    oscillator = Duffing(-1e-9, 1.0, 0.0495, 0.05)
    about_zero = oscillator.steady_state(Omega=1.5, F_0=0.05, A=4.95e-6)
    assert abs(about_zero.harmonics(0)[0]) <= 1e-12
    try:
        found = oscillator.steady_state(Omega=1.5, F_0=0.05)
    except NotSettled as refusal:
        assert "does not converge to it" in str(refusal)
    else:
        assert abs(found.harmonics(0)[0]) >= 1e-6


@pytest.mark.slow
def test_no_trial_runs_off_to_zero_frequency():
    """A Newton trial at Omega = 4.9e-7, where a turn takes 10^7 units of time, asked for 3e9 steps.

    At the lower end the motion switches 330 times a turn, to and fro where the force jumps; the whole curve is found.
    """
    oscillator = Isolator(lam=1.8394265078429055, r=1.0, delta_h=0.732703332558386, mu=0, zeta=0.1)
    F_0, window = 0.06964032577753064, (0.1, 1.1)
    curve = oscillator.exact_response(F_0, Omega=window, force="truncated")
    assert curve.complete and curve.Omega[[0, -1]] == pytest.approx(window, rel=1e-12)
    inner = lambda u: u * (oscillator.alpha + u**2 * (oscillator.beta + u**2 * oscillator.gamma))  # noqa: E731
    force = (inner, lambda u: u), (oscillator.u_cr,)
    stable = np.flatnonzero(curve.stable)
    for Omega in (0.45, 0.8, 1.05):
        found = curve.steady_state(int(stable[np.argmin(np.abs(curve.Omega[stable] - Omega))]))
        tau, u, v = found.series(64)
        end, *_ = by_time.turns_of(force, (0.0, 0.1), found.Omega, F_0, (tau[5], u[5], v[5]), 1)
        assert np.max(np.abs(np.subtract(end, (u[5], v[5])))) <= 1e-9
    # what is given up in between is given as far as it was reached
    with limited(200_000):
        part = oscillator.exact_response(F_0, Omega=window, force="truncated")
    last = f"at Omega = {part.Omega[-1]:.9g}, A = {part.A[-1]:.9g}"
    assert not part.complete and "only part of the curve: stopped after 200000 integration" in part.message
    assert part.message.endswith(last) and 1 < len(part) < len(curve)
    assert part.Omega == pytest.approx(curve.Omega[: len(part)], rel=1e-9)


def test_a_curve_that_is_given_up_keeps_its_points():
    """By the count of steps within the part that C traces, too; nothing but the start is no curve."""
    whole = isolator().exact_response(0.04)
    for most in (3_000, 9_000):
        start = isolator().steady_state(Omega=0.5, F_0=0.04)
        with limited(most):
            part = isolator().exact_response(0.04, start=start)
        assert not part.complete and f"stopped after {most} integration steps" in part.message
        assert 50 < len(part) < len(whole) and part.A == pytest.approx(whole.A[: len(part)], rel=1e-9)
    with pytest.raises(ArithmeticError, match="stopped after 10 integration steps"), limited(10):
        isolator().exact_response(0.04, start=start)
    assert whole.complete and whole.message == ""


def test_work_is_bounded_and_said_so():
    """Each integration, and each question as a whole, is stopped after a stated number of steps."""
    slow = exact.EquationOfMotion(isolator().restoring_force(), 0.012, 0.02)
    with pytest.raises(ArithmeticError, match="stopped after 100 integration steps"), limited(100):
        exact.steady_state(slow, Omega=0.9, F_0=0.04)
    with pytest.raises(ArithmeticError, match=r"the integration stalls near u = .*: its steps become too many"):
        exact.steady_state(slow, Omega=1e-9, F_0=0.04)


@pytest.mark.slow
def test_a_chaotic_motion_is_called_so_with_its_exponent():
    """Ueda's oscillator, u'' + 0.05 u' + u^3 = 7.5 cos tau: its Lyapunov exponent is 0.10 (Sprott 2003, appendix A)."""
    with pytest.raises(ArithmeticError, match="the motion is chaotic") as refused:
        Duffing(0.0, 1.0, zeta=0.025).steady_state(Omega=1.0, F_0=7.5)
    factor = float(re.search(r"by a factor of ([\d.]+) in each", str(refused.value)).group(1))
    assert np.log(factor) / (2 * np.pi) == pytest.approx(0.10, rel=0.25)  # of 30 turns only


@pytest.mark.parametrize("ratio", [0.98, 0.99, 0.995, 0.999, 0.9999])
@pytest.mark.parametrize("Omega", [0.9, *slow(2.0)])
def test_a_drift_below_rounding_is_refused_not_settled(ratio, Omega):
    """So near sticking that a turn's drift is lost in rounding: one amplitude wherever one comes from, or none."""
    oscillator = Duffing(0.0, 1.0, 0.1 * ratio, 0.05)
    swept = oscillator.sweep(Omega=[1.01 * Omega, Omega], F_0=0.1)
    try:
        found = oscillator.steady_state(Omega=Omega, F_0=0.1)
    except NotSettled as refusal:
        assert "drifts" in str(refusal)
    else:
        assert not swept.settled[1] or swept.A[1] == pytest.approx(found.A, rel=1e-5)


REFUSED = [
    (lambda o: o.steady_state(Omega=-1, F_0=0.04), r"Omega = -1 is not allowed.*> 0"),
    (lambda o: o.steady_state(Omega="0.9", F_0=0.04), r"Omega = '0.9'"),
    (lambda o: o.steady_state(Omega=0.9, F_0=0), r"F_0 = 0 is not allowed.*> 0"),
    (lambda o: o.steady_state(Omega=0.9, F_0=0.04, A=-0.2), r"A = -0.2"),
    (
        lambda o: o.steady_state(Omega=0.9, F_0=0.04, force="whole"),
        r"force = 'whole' is not allowed.*'truncated' or 'untruncated'",
    ),
    (lambda o: o.exact_response(np.nan), r"F_0 = nan"),
    (lambda o: o.exact_response(0.04, Omega=(0, 1)), r"Omega\[0\] = 0.0 is not allowed.*> 0"),
    (lambda o: o.exact_response(0.04, Omega=(1, 0.5)), r"Omega\[1\] = 0.5 is not allowed.*> 1"),
    (lambda o: o.exact_response(0.04, step=0), r"step = 0 is not allowed"),
    (lambda o: o.exact_response(0.04, start=0.9), r"start = 0.9 is not allowed"),
    (lambda o: o.sweep(F_0=0.04, Omega=[]), r"Omega must be a non-empty list"),
    (lambda o: o.sweep(F_0=0.04, Omega=[0.9, 0]), r"Omega = .*0.0.* is not allowed"),
]


@pytest.mark.parametrize(("question", "message"), REFUSED)
@pytest.mark.parametrize("oscillator", [isolator(), Duffing(1.0, 0.5, 0.012, 0.05)])
def test_refusals_name_parameter_value_and_range(question, message, oscillator):
    with pytest.raises(ValueError, match=message):
        question(oscillator)


#: of an equation of motion, of which these functions are asked directly
REFUSED_OF_SYSTEMS = [
    (lambda o: exact.steady_state(o, Omega=-1, F_0=0.04), "Omega = -1"),
    (lambda o: exact.steady_state(o, Omega=0.9, F_0=0.01), "friction holds the mass, which never moves"),
    (lambda o: exact.steady_state(o, (-0.1, 0.0), Omega=0.9, F_0=0.04), "guess"),
    (lambda o: exact.exact_response(o, 0.04, Omega=(1.5, 0.5)), r"Omega = \(1.5, 0.5\)"),
    (lambda o: exact.exact_response(o, 0.04, step=-1.0), "step"),
    (lambda o: exact.exact_response(o, 0.012), "does not exceed mu"),
    (lambda o: exact.sweep(o, Omega=[], F_0=0.04), "Omega must be a non-empty list"),
    (lambda o: EquationOfMotion(linear(), -0.1, 0.1), r"mu = -0\.1"),
    (lambda o: exact.steady_state(EquationOfMotion(linear(), 0.0, 0.0), Omega=0.9, F_0=0.04), "without any damping"),
    (lambda o: exact.Force(linear().pieces * 2, (-0.3,)), "breakpoints"),
]


@pytest.mark.parametrize(("question", "message"), REFUSED_OF_SYSTEMS)
def test_refusals_of_an_equation_of_motion_say_why(question, message):
    with pytest.raises(ValueError, match=message):
        question(isolator().equation_of_motion())


@pytest.mark.parametrize(
    ("forcing", "message"),
    [({"F_0": 0.031}, "at F_0 = 0.031"), ({"F_0": 0.03, "Omega": (0.9, 1.2)}, "at F_0 = 0.03, Omega from 0.9")],
)
def test_a_curve_does_not_start_from_a_motion_of_another_forcing(forcing, message):
    start = isolator().steady_state(Omega=0.8, F_0=0.03)
    with pytest.raises(ValueError, match=f"start must be a steady state {message}"):
        isolator().exact_response(start=start, **forcing)


def test_a_start_of_another_forcing_is_refused_in_its_units():
    start = Isolator.physical(**MOUNT).steady_state(f=2.2, F=5)
    with pytest.raises(ValueError, match=r"start at f = 2.2 Hz, F = 5 N is .* at F = 4 N, f from 1 Hz to 2 Hz"):
        Isolator.physical(**MOUNT).exact_response(4, f=(1, 2), start=start)
    for wrong in (3, "rest"):
        with pytest.raises(ValueError, match="start must be a result of steady_state"):
            isolator().exact_response(0.03, start=wrong)


@pytest.mark.parametrize("load", [0.0, 0.03])
def test_motions_where_averaging_rests_are_found_by_amplitude(load):
    """A base moves the mass from mu on, by averaging from 4 mu/pi on: between them it slips and sticks."""
    base = isolator(zeta=0.05, excitation="base", load=load)
    Omega, Y = 0.6, 1.1 * base.mu / 0.6**2
    assert not (base.amplitudes(Omega=Omega, F_0=Y).A > 0).any()
    slips = base.steady_state(Omega=Omega, F_0=Y)
    assert slips.stops and base.steady_state(Omega=Omega, F_0=Y, A=slips.A).A == pytest.approx(slips.A, rel=1e-9)


@pytest.mark.parametrize("samples", [0, -3, 2.5, "4", None])
def test_a_series_has_a_whole_number_of_samples(samples):
    state, shock = isolator().steady_state(Omega=0.9, F_0=0.04), isolator().transient(acceleration=0.1, duration=1.0)
    for series in (
        state.series,
        shock.series,
        lambda samples: Isolator.physical(**MOUNT).steady_state(f=2.2, F=5, samples=samples),
        lambda samples: Isolator.physical(**MOUNT).transient(acceleration=20, duration=0.011, samples=samples),
    ):
        with pytest.raises(ValueError, match=r"samples must be an integer >= 1"):
            series(samples)
    with pytest.raises(ValueError, match=r"most must be an integer >= 0"):
        state.harmonics(-1)


def test_no_damping_at_all_is_refused():
    with pytest.raises(ValueError, match="without any damping"):
        isolator(mu=0, zeta=0).steady_state(Omega=0.9, F_0=0.04)


@pytest.mark.slow
def test_a_first_exact_motion_is_found_without_scipy():
    query = "Isolator(lam=3.0, r=2.0, delta_h=0.08, mu=0.012, zeta=0.02).steady_state(Omega=0.9, F_0=0.04)"
    code = (
        f"import sys; from slowflow import Isolator; {query}; print('scipy' in sys.modules, 'numpy.ma' in sys.modules)"
    )
    printed = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert printed == "False False\n"


def test_motion_with_static_friction_is_found_by_its_amplitude():
    """Averaging leads to another one, which is not stable; a long run from elsewhere comes to this one."""
    numbers = {"lam": 4, "r": 0.3642999918575798, "delta_h": 0.1218203045967167, "mu": 0.006930182403527397}
    grips = Isolator(**numbers, zeta=0.023715239224332777, mu_s=0.01677457063343336)
    F_0, Omega = 0.039136819446978534, 0.46166958703120337
    curve = grips.exact_response(F_0, Omega=(Omega, Omega + 0.02))
    found = grips.steady_state(Omega=Omega, F_0=F_0, A=float(curve.A[0]))
    assert found.A == pytest.approx(curve.A[0], rel=1e-9) and found.stable and found.stops == 1
    assert grips.sweep(Omega=[0.44, Omega], F_0=F_0).A[1] == pytest.approx(found.A, rel=1e-6)
    # of the motions there are the nearest is taken still
    other = grips.steady_state(Omega=Omega, F_0=F_0, A=0.0647)
    assert not other.stable and other.A == pytest.approx(0.06471, rel=1e-3)


@pytest.mark.slow
def test_asymmetric_state_settles_where_newton_fails():
    numbers = {"lam": 4, "r": 0.5567583726242005, "delta_h": 0.24291497227695394, "mu": 0.0035586068196308378}
    loaded = Isolator(**numbers, zeta=0.030883306833416314, load=0.017411128934160736)
    F_0, Omega = 0.10123289194313603, 0.820731195984093
    (state,) = loaded.amplitudes(Omega=Omega, F_0=F_0)
    found = loaded.steady_state(Omega=Omega, F_0=F_0, A=state.A)
    assert found.stable and found.A == pytest.approx(loaded.steady_state(Omega=Omega, F_0=F_0).A, rel=1e-9)


def test_curve_goes_on_where_the_highest_place_passes_the_centre():
    """Under a load, which pulls the whole motion to one side where its amplitude is little."""
    numbers = {"lam": 2, "r": 0.8555935232516407, "delta_h": 0.11116695737395142, "mu": 0.0033268222931048283}
    loaded, F_0 = Isolator(**numbers, zeta=0.052619698513897945, load=-0.03684908305690246), 0.06544331813808045
    curve = loaded.exact_response(F_0, Omega=(1.45, 1.55))
    highest = []
    for k in (0, len(curve.A) - 1):
        found = loaded.steady_state(Omega=float(curve.Omega[k]), F_0=F_0)
        assert found.A == pytest.approx(curve.A[k], rel=1e-9)
        highest.append(found.series()[1].max())
    assert highest[0] > 0 > highest[1] and curve.Omega[-1] == pytest.approx(1.55)


def test_a_sweep_begins_with_the_velocity_that_is_given():
    """Of two motions at one frequency that which the state leads to, as integration of it does."""
    oscillator, at = Duffing(1.0, 0.5, 0.0, 0.05), {"Omega": 1.25, "F_0": 0.2}
    led = {}
    for v_0 in np.linspace(-2.0, 2.0, 9):
        led[v_0] = oscillator.steady_state(**at, u_0=0.0, v_0=float(v_0)).A
        found = oscillator.sweep(F_0=0.2, Omega=[1.25], u_0=0.0, v_0=float(v_0))
        assert found.A[0] == pytest.approx(led[v_0], rel=1e-6) and found.settled.all()
    assert any(abs(led[v_0] / led[-v_0] - 1) > 0.1 for v_0 in led)
