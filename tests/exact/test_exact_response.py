"""The exact response curve and the stepped sweep: folds, borders, stability, jumps."""

import itertools
import math

import numpy as np
import pytest
from scipy.optimize import root

from slowflow import Duffing, Isolator, derive
from slowflow.exact import EquationOfMotion, exact_response, linear, response, steady_state, sweep
from slowflow.exact.continuation import FOLDS
from slowflow.exact.sweep import _is_stable as is_stable_branch
from slowflow.example import TABLE_1
from tests.oracles import by_time
from tests.oracles.exact_cases import isolator, random_cases, table_1
from tests.oracles.exact_reference import again
from tests.sampling import part

FORCINGS = (0.025, 0.03, 0.0301, 0.04, 0.05)
# (untruncated force?, F_0): each force once by SciPy, with and without detachment
CURVES = [(exact, F_0) for exact in (False, True) for F_0 in FORCINGS]


@pytest.fixture(scope="module")
def curves():
    return {(exact, F_0): exact_response(table_1(exact), F_0) for exact, F_0 in CURVES}


def test_two_folds_and_no_other(curves):
    """Every curve of Table 1 has one fold each way; stability changes there and nowhere else."""
    for key, curve in curves.items():
        assert [fold.kind for fold in curve.folds] == ["jump-up", "jump-down"], key
        assert curve.folds[0].Omega < curve.folds[1].Omega
        assert curve.folds[0].A < curve.folds[1].A
        changes = np.flatnonzero(np.diff(curve.stable.astype(int)))
        assert changes.size == 2, key
        assert not curve.stable[[point.role in FOLDS for point in curve.states]].any()  # one multiplier is 1
        assert curve.Omega[0] == pytest.approx(0.5, abs=1e-12) and curve.Omega[-1] == pytest.approx(1.5, abs=1e-12)
        # all frequencies rise but between the folds
        assert np.flatnonzero(np.diff(np.sign(np.diff(curve.Omega)))).size == 2


def test_points_are_motions_and_stability_is_theirs(curves):
    """Some points of a curve, stable or not, and all folds and borders, come back when followed over a period."""
    for (exact, _), curve in curves.items():
        special = [i for i, point in enumerate(curve.states) if point.role]
        for index in (*range(0, curve.Omega.size, 40), *special):
            state, point = curve.steady_state(index), curve.states[index]
            assert np.max(np.abs(point.cycle.equations(point.z, curve.F_0).residual)) <= 1e-13
            # Just touching a jump of the force, the motion followed is not Lipschitz in its start: a rounding of u
            # grows to its square root at every touch. There only the equations can be checked.
            touching = point.role in ("border", "corner") and not exact
            assert touching or state.residual <= 1e-12
            assert state.A == pytest.approx(curve.A[index], abs=1e-12)


def test_middle_one_of_three_motions_is_unstable(curves):
    """As the averaged balance has it; a saddle has one multiplier inside the unit circle, which is not enough."""
    seen = 0
    for (exact, F_0), curve in curves.items():
        low, high = (fold.Omega for fold in curve.folds)
        Omega = 0.5 * (low + high)
        averaged = Isolator(**TABLE_1).amplitudes(Omega=Omega, F_0=F_0)
        if exact or len(averaged) != 3:
            continue
        seen += 1
        points = list(curve.states)
        (saddle,) = averaged.A[~averaged.stable]
        below, above = sorted(response._stable_at(Omega, points))
        assert below < saddle < above
        up, down = sorted(i for i, point in enumerate(points) if point.role in FOLDS)
        assert is_stable_branch(points[: up + 1]) and is_stable_branch(points[down:])
        # stable up to the fold, not beyond it
        assert not is_stable_branch(points[: up + 3]) and not is_stable_branch(points[up : down + 1])
    assert seen


def unlike_mirrored(A, theta, Omega, F_0, exact):
    """By what a motion of Table 1's isolator misses its mirror image half a turn later: SciPy, the force typed in."""
    by_hand, damping = isolator(**TABLE_1, exact=exact)[1], (TABLE_1["mu"], TABLE_1["zeta"])
    (u, v), _, _ = by_time.turns_of(by_hand, damping, Omega, F_0, (theta / Omega, A, 0.0), 0.5)
    return u + A, v


def frequency_of(point, F_0, exact, off):
    """Of the motion with the amplitude of a curve's point, solved for from beside that."""
    A, theta, Omega = float(point.z[0]), point.z[1] + off, point.z[-1] + off
    return root(lambda x: unlike_mirrored(A, *x, F_0, exact), (theta, Omega), tol=1e-13).x[1]


@pytest.mark.parametrize("zeta", [0.05, 0.3, 0.9])
def test_peak_of_the_linear_oscillator(zeta):
    """F_0/(2 zeta sqrt(1 - zeta^2)) at sqrt(1 - 2 zeta^2), or the lower end where the amplitude only falls."""
    peak = exact_response(EquationOfMotion(linear(), 0.0, zeta), 0.1, Omega=(0.5, 1.5), step=0.3).peak
    if zeta < 0.7:
        assert peak.A == pytest.approx(0.1 / (2 * zeta * math.sqrt(1 - zeta**2)), rel=1e-12)
        assert peak.Omega == pytest.approx(math.sqrt(1 - 2 * zeta**2), rel=1e-11)
    else:
        assert peak.Omega == 0.5 and peak.A == pytest.approx(0.1 / abs(1 - 0.25 + 0.9j), rel=1e-12)


@pytest.mark.parametrize("ratio", [0.0, 0.3, 0.6])
def test_a_peak_does_not_depend_on_the_step(ratio):
    """Light damping, a sharp peak, stops on the flanks: the points miss it by up to 9e-4, the peak does not."""
    system = isolator(3, TABLE_1["r"], 0.03, ratio * 0.005, 0.005, exact=True)[0]
    curves = [exact_response(system, 0.005, Omega=(0.7, 1.1), step=step) for step in (0.3, 0.1, 0.02)]
    finest = curves[-1].peak
    assert curves[0].A.max() < (1 - 1e-5) * finest.A
    for curve in curves:
        assert curve.peak.A == pytest.approx(finest.A, rel=1e-10)
        assert curve.peak.Omega == pytest.approx(finest.Omega, rel=1e-10)


@pytest.mark.parametrize("zeta", [0.001, 0.05, 0.4])
def test_linear_oscillator_never_jumps_at_any_spacing(zeta):
    linear_one = Duffing(1.0, 0.0, zeta=zeta)
    for Omega in ([0.8, 0.9], [0.5, 0.99, 1.0, 1.01, 2.0], [1.4, 0.999, 0.3]):
        assert linear_one.sweep(Omega=Omega, F_0=0.1).jumps == ()


#: by `settled_by_scipy`: amplitudes before and after a fold at which A changes by less than 3 %
REFINED = {(0.3784, 0.3786): (1.7559427, 1.7266846)}


@pytest.mark.slow
def test_jump_is_a_change_of_branch_and_a_pitchfork_is_none():
    """u'' + 0.04 u' + u + u^3 = 3 cos: at 0.325 and 0.499 a motion becomes symmetric, at others it ceases to be."""
    swept = Duffing(1.0, 1.0, zeta=0.02).sweep(Omega=np.arange(300, 500) / 1000, F_0=3.0)
    assert swept.jumps == ((0.378, 0.379), (0.477, 0.478))
    finer = Duffing(1.0, 1.0, zeta=0.02).sweep(Omega=[*np.arange(300, 379) / 1000, 0.3784, 0.3786], F_0=3.0)
    assert finer.jumps == ((0.3784, 0.3786),)
    assert finer.A[-2:] == pytest.approx(REFINED[0.3784, 0.3786], rel=2e-5)


def test_jump_in_coarse_steps_is_where_the_fold_is(curves):
    """The frequencies of docs/howto/exact_motions.md."""
    down = curves[False, 0.04].folds[1]
    assert 0.95 < down.Omega < 1.0
    assert sweep(table_1(False), Omega=[0.8, 0.9, 0.95, 1.0], F_0=0.04).jumps == ((0.95, 1.0),)


@pytest.mark.slow
@pytest.mark.night
def test_the_motion_that_scipy_follows_jumps_there():
    begun = (0.33, 0.34, 0.35, 0.36, 0.37, 0.375, 0.378, 0.3782)
    assert settled_by_scipy(3.0, 0.02, (*begun, 0.3784, 0.3786))[-2:] == pytest.approx(
        REFINED[0.3784, 0.3786], rel=2e-5
    )
    begun = (0.47, 0.475, 0.477, 0.4774, 0.4776, 0.4777)
    steps = settled_by_scipy(3.0, 0.02, (*begun, 0.47772, 0.47776, 0.4778))
    # not before, where it hardly moves, but then it does
    assert abs(steps[-3] - steps[-4]) < 0.004 and steps[-1] - steps[-3] > 0.04


#: folds of the second resonance of u'' + 0.01 u' + u + u^3 = cos, and largest |u| beyond them by `settled_by_scipy`
SECOND = {0.45478: (1.289, 0.981), 0.49743: (1.535, 1.027)}


def test_a_fold_is_of_the_kind_that_a_sweep_sees_there():
    """At both ends of the second resonance a sweep falls, at the lower one as the frequency falls."""
    curve = Duffing(1.0, 1.0, zeta=0.005).exact_response(1.0, Omega=(0.3, 1.0))
    for Omega, (before, after) in SECOND.items():
        fold = min(curve.folds, key=lambda fold, at=Omega: abs(fold.Omega - at))
        assert (fold.Omega, fold.A) == pytest.approx((Omega, before), rel=1e-3)
        assert fold.kind == "jump-down" and after < before


def test_fold_kind_is_told_without_a_motion_beyond_its_part():
    """As an isola has none: what the mass comes to is followed in time."""
    oscillator = Duffing(1.0, 1.0, zeta=0.005)
    start = oscillator.steady_state(Omega=0.48, F_0=1.0, A=1.45)
    part = oscillator.exact_response(1.0, Omega=(0.475, 0.52), start=start)
    assert part.Omega.max() < 0.4975 and [fold.kind for fold in part.folds] == ["jump-down"]


@pytest.mark.slow
@pytest.mark.night
def test_scipys_motion_falls_beyond_the_second_resonance():
    curve = Duffing(1.0, 1.0, zeta=0.005).exact_response(1.0, Omega=(0.3, 1.0))
    for (Omega, (before, after)), side in zip(SECOND.items(), (-1, 1), strict=True):
        away = np.abs(curve.Omega / Omega - 1) + np.abs(curve.A / before - 1)
        last = curve.steady_state(int(np.argmin(np.where(curve.stable, away, np.inf))))
        assert last.A == pytest.approx(before, rel=0.02) and side * (Omega - last.Omega) > 0
        found = settled_by_scipy(1.0, 0.005, (Omega + side * 2e-4,), last._state(0.0), turns=250)
        assert found[0] == pytest.approx(after, rel=2e-3)


def settled_by_scipy(F_0, zeta, frequencies, state=(0.0, 0.0), turns=60):
    """Largest |u| of u'' + 2 zeta u' + u + u^3 = F_0 cos(Omega tau), each from where the one before ends."""
    found = []
    for Omega in frequencies:
        push = lambda tau, Omega=Omega: F_0 * np.cos(Omega * tau)  # noqa: E731
        _, u, v = by_time.settled(lambda u: u + u**3, push, zeta, Omega, state, turns, rtol=1e-9, atol=1e-10)
        state = u[-1], v[-1]
        found.append(np.abs(u).max())
    return found


@pytest.mark.parametrize("exact", [False, True])
@pytest.mark.parametrize("F_0", [0.03, 0.04])
def test_sweeps_jump_at_the_folds(curves, exact, F_0):
    """Stepped up, the motion jumps down at the upper fold; stepped down, it jumps up at the lower one."""
    up, down = curves[exact, F_0].folds
    frequencies = np.linspace(0.7, 1.1, 101)
    rising = sweep(table_1(exact), Omega=frequencies, F_0=F_0)
    falling = sweep(table_1(exact), Omega=frequencies[::-1], F_0=F_0)
    assert rising.settled.all() and falling.settled.all()
    assert len(rising.jumps) == len(falling.jumps) == 1
    assert rising.jumps[0][0] <= down.Omega <= rising.jumps[0][1]
    assert falling.jumps[0][1] <= up.Omega <= falling.jumps[0][0]
    assert abs(np.diff([*rising.jumps, *falling.jumps])) == pytest.approx(frequencies[1] - frequencies[0])
    for found in (rising, falling):
        for Omega, A in list(zip(found.Omega, found.A, strict=True))[::10]:
            curve = curves[exact, F_0]
            assert abs(steady_state(table_1(exact), (A, _phase(curve, Omega, A)), Omega=Omega, F_0=F_0).A - A) <= 1e-7


def _phase(curve, Omega, A):
    index = int(np.argmin(np.abs(curve.Omega - Omega) + np.abs(curve.A - A)))
    return -float(curve.states[index].z[1])


def test_curve_with_stops_and_loops():
    """Down to Omega = 0.1 the mass stops up to four times a turn; the curve goes through every change of order."""
    curve = exact_response(table_1(exact=True), 0.04, Omega=(0.1, 1.5))
    assert set(curve.stops.tolist()) == {0, 2, 4}
    assert [fold.kind for fold in curve.folds] == ["jump-up", "jump-down"]
    assert len(curve.borders) >= 4
    for index in range(0, curve.Omega.size, 25):
        state = curve.steady_state(index)
        again = steady_state(state.cycle.system, Omega=state.Omega, F_0=0.04)
        if state.Omega < 0.8:  # one motion only
            assert abs(again.A - state.A) <= 1e-9
            on_border = curve.states[index].role == "border"  # with a rest of no length, or without it
            assert again.stops == state.stops or on_border
    # neighbouring points stay neighbours across the borders
    assert np.max(np.abs(np.diff(np.log(curve.A)))) <= 0.05


def test_border_to_sticking_is_den_hartogs():
    """Linear, zeta = 0: the first stop appears where (35) meets (36), which for S = 1 reads A Omega^2 = mu."""
    curve = exact_response(EquationOfMotion(linear(), 0.8, 0.0), 1.0, Omega=(0.6, 0.99))
    for Omega, A in curve.borders:
        assert abs(A * Omega**2 - 0.8) <= 1e-10
    assert len(curve.borders) == 2
    assert not curve.folds


@pytest.mark.slow
@pytest.mark.parametrize(("exact", "F_0"), [(False, 0.0301), (False, 0.04), (True, 0.04)])
def test_points_of_a_curve_are_motions_by_scipy(curves, exact, F_0):
    """Stable and unstable, with and without detachment: amplitude and multipliers, to 1e-11 over what folds enlarge."""
    curve = curves[exact, F_0]
    ordinary = [k for k in range(0, len(curve), 5) if not curve.states[k].role]
    for state in (curve.peak, *map(curve.steady_state, part(ordinary, 4, f"{exact} {F_0}"))):
        other, enlarged = again(state), 1 / np.min(np.abs(1 - state.multipliers))
        assert abs(other.A - state.A) <= 1e-11 * enlarged
        apart = np.sort_complex(other.multipliers) - np.sort_complex(state.multipliers)
        assert np.max(np.abs(apart)) <= 1e-10 * enlarged
        assert state.A <= curve.peak.A and state.residual <= 1e-12


def test_unbounded_resonance_in_words():
    with pytest.raises(ArithmeticError, match="resonance is unbounded"):
        exact_response(EquationOfMotion(linear(), 0.3, 0.0), 1.0, Omega=(0.6, 1.4))


@pytest.mark.slow
def test_random_curves_go_through():
    """Whole curves of random isolators, with stops, detachment and superharmonic loops: folds come in pairs."""
    borders = 0
    for case in random_cases(15, seed=100):
        curve = exact_response(case.system, case.F_0, Omega=(0.2, 2.0))
        assert curve.Omega[0] == pytest.approx(0.2, abs=1e-12) and curve.Omega[-1] == pytest.approx(2.0, abs=1e-12)
        assert len(curve.folds) % 2 == 0
        assert np.max(np.abs(np.diff(np.log(curve.A)))) <= 0.1
        for point in curve.states[::60]:
            assert np.max(np.abs(point.cycle.equations(point.z, case.F_0).residual)) <= 1e-12
        borders += len(curve.borders)
    assert borders >= 20


def test_a_trial_beyond_zero_frequency_is_none():
    """Negative stiffness: a step of Newton's went to Omega < 0 and never came back; the curve can be followed."""
    system = isolator(3, 1.7799765049665899, 0.30647249977631186, 0.005296695821561307, 0.02370128262012328, False)[0]
    start = steady_state(system, (0.02, -0.1), Omega=0.3, F_0=0.026979642127992823)
    curve = exact_response(system, 0.026979642127992823, Omega=(0.3, 1.5), step=0.05, start=start)
    assert np.isfinite(curve.A).all() and curve.Omega.min() == 0.3


@pytest.mark.parametrize("step", [0.01, 0.02, 0.05, 0.1])
def test_kinds_of_folds_beside_a_sharp_peak(step):
    """Light damping: the curve folds just behind its peak, and a coarse step passes both at once."""
    system = isolator(3, TABLE_1["r"], 0.13, 0.0, 0.005, exact=True)[0]
    curve = exact_response(system, 0.00292, Omega=(0.4, 0.9), step=step)
    assert [fold.kind for fold in curve.folds] == ["jump-up", "jump-down"]


@pytest.mark.slow
def test_corner_fold_of_the_truncated_force():
    """Just above the forcing that detaches the springs, the jump of the force (6) adds a corner and two folds.

    The same count and frequencies when solved amplitude by amplitude, independently.
    """
    F_0, (_, (u_cr,)) = 0.03006, isolator(**TABLE_1, exact=False)[1]
    curve = exact_response(table_1(exact=False), F_0, Omega=(0.8, 1.0), step=0.002)
    assert [fold.corner for fold in curve.folds] == [False, True, False, False]
    corner = curve.folds[1]
    assert abs(corner.A - u_cr) <= 1e-14
    near = [p for p in curve.states if p.z[-1] > 0.9258 and 0.3955 < p.A < 0.3975]
    past = [p for p in near if p.z[1] > near[int(np.argmax([q.A for q in near]))].z[1] + 1e-3]
    frequencies = []
    for point in past:
        frequencies.append(frequency_of(point, F_0, False, 1e-6))
        # touching the jump, a rounding of u is worth its square root
        assert abs(frequencies[-1] - point.z[-1]) <= (1e-6 if abs(point.z[0] - u_cr) < 1e-9 else 1e-9)
    turns = np.flatnonzero(np.diff(np.sign(np.diff(frequencies))))
    assert turns.size == 3


def test_multipliers_have_the_product_of_a_whole_period():
    """exp(-2 zeta T) without friction, by Liouville's formula, however many half turns a cycle is followed for."""
    curve = Duffing(1.0, 0.5, 0.0, 0.05).exact_response(0.1, Omega=(0.6, 0.9))
    expected = np.exp(-2 * 0.05 * 2 * np.pi / curve.Omega)
    assert np.prod(curve.multipliers, axis=1) == pytest.approx(expected, rel=1e-10)


@pytest.mark.slow
def test_curve_is_followed_across_a_border_of_its_cycle():
    """Restarted at the highest turning point it was given up there, after 16 points; the other end leads through it."""
    mount = Isolator(lam=2.372, r=1.75, delta_h=0.1458, mu=0.0, zeta=0.0371, load=-0.0715)
    curve = mount.exact_response(0.05, Omega=(0.4, 1.6), step=0.05)
    end = mount.steady_state(Omega=1.6, F_0=0.05)
    back = mount.exact_response(0.05, Omega=(0.4, 1.6), step=0.05, start=end)
    assert curve.complete and back.complete and len(curve.folds) == len(back.folds) == 2
    for one, other in zip(curve.folds, back.folds, strict=True):
        assert one.Omega == pytest.approx(other.Omega, rel=1e-12) and one.kind == other.kind
    assert curve.peak.A == pytest.approx(back.peak.A, rel=1e-12)


def test_loaded_linear_curve_is_the_unloaded_one_shifted():
    """Through all points where the mass breaks away from a stop, whose acceleration there is zero up to rounding."""
    for F_0, mu, zeta, load, Omega in (
        (0.05844, 0.01327, 0.0468, -0.5, (0.12, 0.36)),
        (0.0106, 0.0051, 0.0156, 0.246, (0.466, 1.4)),
        (0.01197, 0.00393, 0.0234, 0.45, (0.18, 0.54)),
        (0.0108, 0.00774, 0.0322, 0.18, (0.16, 0.48)),
        (0.066, 0.01396, 0.0821, -0.42, (0.13, 0.39)),
        (0.01064, 0.00823, 0.0999, 0.3, (0.38, 1.14)),
    ):
        linear_case = {"alpha": 1.0, "beta": 0.0, "gamma": 0.0, "mu": mu, "zeta": zeta}
        shifted = Duffing(**linear_case, load=load).exact_response(F_0, Omega=Omega)
        assert shifted.complete and not shifted.folds, shifted.message
        for i in range(0, len(shifted), 25):
            state = Duffing(**linear_case).steady_state(Omega=float(shifted.Omega[i]), F_0=F_0)
            assert shifted.A[i] == pytest.approx(abs(load) + state.A, rel=1e-11)
            assert shifted.stops[i] == state.stops


@pytest.mark.parametrize(
    ("name", "design", "F_0", "Omega"),
    [
        ("elastic_stop", {"kappa": 3.17, "delta": 0.254, "mu": 0.629, "zeta": 0.009}, 0.796, (0.156, 0.4)),
        ("bilinear", {"kappa": 8.45, "delta": 0.061, "mu": 0.319, "zeta": 0.1226}, 0.349, (0.06, 0.25)),
        ("elastic_stop", {"kappa": 8.32, "delta": 0.3615, "mu": 0.154, "zeta": 0.0107}, 0.4556, (0.15, 0.19)),
    ],
)
def test_curve_goes_on_where_a_stop_passes_a_breakpoint(name, design, F_0, Omega):
    """The mass rests at its farthest place, which comes to lie beyond the breakpoint; points are SciPy's motions."""
    curve = derive.library(name)(**design).exact_response(F_0, Omega=Omega)
    assert curve.complete, curve.message
    side = np.sign(curve.A - design["delta"])
    assert side.min() < 0 < side.max()
    for i in np.flatnonzero(side[1:] > side[:-1]).tolist():
        for state in (curve.steady_state(i - 3), curve.steady_state(i + 3)):
            assert state.stops >= 2
            assert abs(again(state).A - state.A) <= 1e-9


def test_curve_ends_where_static_friction_just_stops_the_mass():
    """There velocity and acceleration vanish together, and the motion beyond is another one; it is no fold."""
    mount = Isolator(lam=1, r=2.414, delta_h=0.389, mu=0.2219, mu_s=0.2656, zeta=0.2339)
    curve = mount.exact_response(0.649, Omega=(0.25, 0.5))
    assert curve.complete and not curve.folds and "ends at" in curve.message
    last = curve.steady_state(len(curve) - 1)
    other = again(last)
    assert abs(other.A - last.A) <= 1e-9 and last.stops == 2 and last.stable
    stop = next(phase for phase, after in itertools.pairwise(last.phases) if after.slip == 0)
    rate = last.force * math.cos(stop.end) - mount.force(np.array([stop.u_end]))[0] - stop.slip * mount.mu
    assert abs(rate) <= 1e-4 * last.force
    assert curve.Omega.max() == pytest.approx(last.Omega, rel=1e-12)
    (u, v), Omega = last._state(0.0), last.Omega * (1 + 1e-6)
    beyond = mount.steady_state(Omega=Omega, F_0=0.649, u_0=u, v_0=v)
    assert beyond.stops == 0 and beyond.A - last.A > 1e-5
