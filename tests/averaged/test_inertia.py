"""Excitation by inertia: certified cusps, closed forms, the linear mount, exact motions, refusals."""

import math

import numpy as np
import pytest

from slowflow import Duffing, Isolator, derive, example
from slowflow.answers.results import Remark
from slowflow.averaged import solvers
from slowflow_kernels import den_hartog
from slowflow_kernels.conventions import Status
from tests.averaged.test_certified_cases import on_a_base
from tests.files import stored

CASES = stored("inertia")
#: relative errors
CUSP = 16 * 2.0**-53


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "numbers"),
    [
        ("elastic_stop", {"delta": 0.2, "kappa": 5.0}),
        ("bilinear", {"delta": 0.2, "kappa": 0.4}),
        ("dead_zone", {"delta": 0.2}),
    ],
)
@pytest.mark.parametrize("compile", [False, True])
def test_beside_a_kink_the_number_of_folds_is_known(name, numbers, compile):
    """There h_AA is infinite, but F_A > 0 at all frequencies: a cusp within a double of the kink was not ruled out."""
    made = derive.library(name, compile=compile)
    for excitation in ("base", "unbalance"):
        for damping in ({"mu": 0.0, "zeta": 0.02}, {"mu": 0.004, "zeta": 0.1}):
            one = made(**numbers, **damping, excitation=excitation)
            for found in (one.saddle_nodes(0.07), one.amplitudes(Omega=1.3, F_0=0.07), one.frequency_response(0.07)):
                assert Remark.UNDECIDED not in found.remarks
            many = made.many(**{**numbers, "delta": [0.2, 0.25]}, **damping, excitation=excitation)
            assert not (many.saddle_nodes(0.07).remarks & Remark.UNDECIDED).any()


def test_cusps_are_those_of_a_force_at_the_certified_level():
    compared = 0
    for case in CASES:
        osc, known = on_a_base(case, False), case["cusps"]
        A_max = 1.1 * max([float(cusp["A"]) for cusp in known] or [1.0])
        found, forced = osc.cusps(A_max=A_max), osc.replace(excitation="force").cusps(A_max=A_max)
        assert np.allclose(np.sort(found.A), np.sort(forced.A), rtol=1e-11, atol=0)
        assert np.allclose(np.sort(found.Omega), np.sort(forced.Omega), rtol=1e-11, atol=0)
        order = np.argsort(found.F_0)
        assert found.minimum[order].tolist() == [cusp["sense"] == "min" for cusp in known]
        for k, cusp in zip(order, known, strict=True):
            compared += 1
            assert found.F_0[k] == pytest.approx(float(cusp["F_0"]), rel=CUSP)
    assert compared > 30


def test_heavily_damped_corner_folds_come_down_with_frequency():
    design = {"lam": 3.0, "r": 2.9, "delta_h": 0.0912, "mu": 0.003, "zeta": 0.734, "excitation": "unbalance"}
    iso = Isolator(**design)
    assert iso.saddle_node_onset().F_SN is None
    assert Isolator.many(**design).saddle_node_onset().status == Status.UNBOUNDED
    assert "no lowest amplitude" in iso.saddle_node_onset().message
    found = [iso.saddle_nodes(iso.u_cr * (1 + above)) for above in (1e-1, 1e-2, 1e-3)]
    assert all(len(folds) == 2 and folds.corner.sum() == 1 for folds in found)
    assert found[0].Omega[0] < found[1].Omega[0] < found[2].Omega[0]
    assert len(iso.saddle_nodes(iso.u_cr * (1 - 1e-3))) == 0
    with np.errstate(all="ignore"):
        assert solvers.onset(iso.model).F_SN is None


@pytest.mark.parametrize("zeta", [1e-20, 1e-50, 1e-111])
def test_a_locus_that_begins_at_rest_has_no_folds_there(zeta):
    """Where damping is next to none it begins below any amplitude that is looked at: folds at Omega = inf, A = 1e-323.

    One of its branches stays at R = 0 but for damping; on the other Omega^2 = -h_A, so that R = h - A h_A.
    """
    parameters = {"lam": 3, "r": 4.56e-4, "delta_h": 0.2, "mu": 0, "zeta": zeta, "force": "untruncated"}
    F_0, one = 1.1e-16, Isolator(**parameters, excitation="base")
    folds = one.saddle_nodes(F_0)
    within = folds.A < one.model.reach
    assert folds.kind[within].tolist() == ["jump-up"]
    (A,), (Omega,) = folds.A[within], folds.Omega[within]
    h, h_A, *_ = one.model.averaged(A)
    assert Omega**2 == pytest.approx(-h_A, rel=1e-15)
    assert abs(h - A * h_A) / Omega**2 == pytest.approx(F_0, rel=1e-3)  # the difference of two has few digits


def test_curve_holds_the_level_and_ends_where_it_must():
    iso = Isolator(**example.TABLE_1, excitation="unbalance")
    curve = iso.frequency_response(0.03, Omega=(0.0, 1e3))
    assert curve.Omega[0] == pytest.approx(math.sqrt(iso.model.m / 0.03), rel=1e-3)
    assert curve.A[-1] == pytest.approx(0.03, rel=1e-5)
    off = iso.model.level(curve.Omega, curve.A) / 0.03 - 1
    assert np.abs(off).max() < 1e-12
    assert curve.isola == (False,)
    states = iso.amplitudes(Omega=[0.4, 2.0], F_0=0.03)
    assert states.Omega.tolist() == [0.4, 2.0] and states.A[0] == 0
    assert "sticks up to Omega = " in states.message


def test_detachment_is_the_least_amplitude_that_reaches_u_cr():
    iso = Isolator(**{**example.TABLE_1, "mu": 0.0}, force="untruncated", excitation="base")
    found = iso.detachment()
    Omega = np.linspace(0.5, 2.0, 40001)
    level = iso.model.level(Omega, np.full_like(Omega, iso.u_cr))
    assert found.F_cr == pytest.approx(level.min(), rel=1e-6)
    assert found.F_cr <= level.min()
    assert iso.peak(found.F_cr * (1 + 1e-9)).A > iso.u_cr > iso.peak(found.F_cr * (1 - 1e-9)).A
    # so much damping that the level only falls, to u_cr as Omega tends to inf
    heavy = iso.replace(zeta=0.9, mu=0.0)
    assert heavy.detachment().F_cr is None
    assert "tends to" in heavy.detachment().message
    assert "from below" in heavy.peak(0.1).message


def test_hardening_base_response_does_not_close_above_its_bound():
    zeta, beta = 0.05, 2.0
    osc = Duffing(1.0, beta, zeta=zeta, excitation="base")
    limit = 4 * zeta / math.sqrt(3 * beta)
    below, above = osc.frequency_response(0.98 * limit), osc.frequency_response(1.02 * limit)
    assert below.message == ""
    assert osc.peak(0.98 * limit).A > 0.98 * limit
    assert "does not close" in above.message
    assert osc.peak(1.02 * limit).A is None
    assert "does not close" in osc.peak(1.02 * limit).message
    # with negative stiffness the level falls all the way to that limit: folds of any amplitude come ever lower
    bistable = Duffing(-0.5, beta, zeta=zeta, excitation="base")
    assert bistable.saddle_node_onset().F_SN is None
    assert "no lowest amplitude" in bistable.saddle_node_onset().message
    assert len(bistable.saddle_nodes(0.99 * limit)) == 0
    assert len(bistable.saddle_nodes(1.01 * limit)) == 1


def test_transmission_of_an_exact_curve_is_that_of_its_motions():
    iso = Isolator(**example.TABLE_1, excitation="base")
    curve = iso.exact_response(0.04, Omega=(0.75, 1.05), step=0.1)
    passed = curve.transmitted()
    assert passed.first.shape == curve.Omega.shape
    # rms^2 is half the squares of all harmonics: more than that of the first, by little
    assert (passed.rms**2 >= passed.first**2 / 2 * (1 - 1e-12)).all()
    assert (passed.peak >= passed.rms).all()
    for k in range(0, len(curve), 7):
        motion = curve.steady_state(k)
        force = motion.force
        # of the wave the first harmonic is the force's plus inertia's
        c_1 = motion.harmonics(1)[1]
        assert passed.first[k] == pytest.approx(abs(force + motion.Omega**2 * c_1) / force, rel=1e-10)


@pytest.mark.parametrize(
    ("Omega", "excitation", "F_0"), [(0.35, "force", 0.04), (0.9, "force", 0.04), (1.4, "base", 0.03)]
)
def test_transmission_with_stops_is_the_force_less_inertia(Omega, excitation, F_0):
    iso = Isolator(**example.TABLE_1, excitation=excitation)
    motion = iso.steady_state(Omega=Omega, F_0=F_0)
    passed = motion.transmitted()
    # from the velocity alone: the force less the acceleration, by differences
    tau, _, v = motion.series(40000)
    step = tau[1] - tau[0]
    force = motion.force * np.cos(Omega * tau) - (np.roll(v, -1) - np.roll(v, 1)) / (2 * step)
    first = 2 * np.mean(force * np.exp(-1j * Omega * tau))
    assert passed.first == pytest.approx(abs(first) / motion.force, rel=1e-4)
    assert passed.rms == pytest.approx(math.sqrt(np.mean(force**2)) / motion.force, rel=1e-3)
    assert passed.peak == pytest.approx(np.abs(force).max() / motion.force, rel=1e-2)
    averaged = iso.amplitudes(Omega=Omega, F_0=F_0)
    nearest = np.argmin(np.abs(averaged.A - motion.A))
    assert averaged.transmissibility[nearest] == pytest.approx(passed.first, rel=0.05)


def test_exact_curve_point_is_a_motion_under_the_same_force():
    iso = Isolator(**example.TABLE_1, excitation="unbalance")
    forced, Y = iso.replace(excitation="force"), 0.05
    curve = iso.exact_response(Y, Omega=(0.7, 1.2))
    assert [fold.kind for fold in curve.folds] == ["jump-up", "jump-down"]
    for k in range(0, len(curve), 25):
        Omega = float(curve.Omega[k])
        motion = forced.steady_state(Omega=Omega, F_0=Y * Omega**2, A=float(curve.A[k]))
        assert motion.A == pytest.approx(curve.A[k], rel=1e-10)
        if abs(motion.A / iso.u_cr - 1) > 1e-3:  # next to it their slope has no bound: there the force jumps
            assert abs(motion.multipliers.sum() - curve.multipliers[k].sum()) < 1e-9
            assert abs(motion.multipliers.prod() - curve.multipliers[k].prod()) < 1e-9
    assert np.abs(iso.saddle_nodes(Y).measure().error).max() < 0.01


@pytest.mark.slow
def test_sweep_jumps_at_exact_folds_and_rests_when_held():
    iso, Y = Isolator(**example.TABLE_1, excitation="base"), 0.05
    up, down = (fold.Omega for fold in iso.exact_response(Y).folds)
    rising, falling = (iso.sweep(Omega=np.linspace(*ends, 41), F_0=Y) for ends in ((0.4, 1.2), (1.2, 0.4)))
    assert [low < down < high for low, high in rising.jumps] == [True]
    assert [low > up > high for low, high in falling.jumps] == [True]
    for found in (rising, falling):
        assert ((found.A < 2e-4) == (found.Omega < 1.02 * math.sqrt(iso.mu / Y))).all()
        assert found.settled.all()
    sticking = rising.Omega <= math.sqrt(iso.mu / Y)
    assert (rising.A[sticking] == 0).all()
    assert iso.sweep(Omega=[0.3, 0.4], F_0=Y).A.tolist() == [0.0, 0.0]


def test_an_exact_curve_begins_where_the_base_moves_the_mass():
    iso = Isolator(**example.TABLE_1, excitation="base")
    curve = iso.exact_response(0.05, Omega=(0.3, 0.6))
    assert curve.message.startswith("at this F_0 friction holds the mass up to Omega = 0.4899")
    assert curve.A[0] < 1e-3
    assert (curve.stops[:5] == 2).all()
    sticking = iso.exact_response(0.05, Omega=(0.3, 0.45))
    assert len(sticking) == 0 and "friction holds the mass" in sticking.message


def test_shock_does_not_depend_on_the_other_excitation():
    iso = Isolator(**example.TABLE_1)
    pulse = {"acceleration": 0.3, "duration": 2.0}
    assert iso.replace(excitation="base").transient(**pulse).A == iso.transient(**pulse).A


def test_second_approximation_folds_are_nearer_to_exact_ones():
    cases = stored("exact_motions")
    folds = [case for case in cases if case["fold"] and "excitation" in case["numbers"] and case["force"] != "duffing"]
    assert len(folds) == 3
    for case in folds:
        iso, exact = Isolator(**case["numbers"], force=case["force"]), float(case["Omega"])
        first, second = (
            min(abs(of.saddle_nodes(case["F_0"]).Omega / exact - 1)) for of in (iso, iso.second_approximation)
        )
        assert second < 0.2 * first
        assert second < 1e-4


def test_second_approximation_of_linear_friction_is_den_hartogs():
    osc = Duffing(1.0, 0.0, mu=0.02, zeta=1e-9, excitation="base").second_approximation
    Omega, Y = np.array([0.7, 1.4, 2.5]), 0.1
    known = den_hartog.amplitude(Omega, Y * Omega**2, 0.02)
    assert osc.amplitudes(Omega=Omega, F_0=Y).A == pytest.approx(known, rel=1e-7)


@pytest.mark.parametrize(("excitation", "F_0"), [("force", 0.04), ("base", 0.05), ("unbalance", 0.05)])
def test_second_approximation_transmission_is_nearer_to_exact(excitation, F_0):
    iso = Isolator(**example.TABLE_1, force="untruncated", excitation=excitation)
    for Omega in (1.2, 1.6):
        exact = iso.steady_state(Omega=Omega, F_0=F_0).transmitted().first
        first, second = (of.amplitudes(Omega=Omega, F_0=F_0) for of in (iso, iso.second_approximation))
        assert abs(second.transmissibility[0] / exact - 1) < 0.2 * abs(first.transmissibility[0] / exact - 1)
        assert second.transmissibility_dB[0] == pytest.approx(20 * math.log10(exact), abs=0.01)


def test_least_base_amplitude_to_detach_reaches_the_stroke():
    iso = Isolator(**{**example.TABLE_1, "zeta": 0.05}, force="untruncated", excitation="base")
    second = iso.second_approximation
    found = second.detachment()
    top = second.peak(found.F_cr)
    assert (top.A, top.Omega) == pytest.approx((iso.u_cr, found.Omega_cr), rel=1e-9)
    exact = iso.exact_response(found.F_cr, Omega=(0.8, 1.2)).peak
    # what is left out is quadratic in friction over the force of inertia
    order = (iso.mu / (iso.u_cr * found.Omega_cr**2)) ** 2
    assert (exact.A, exact.Omega) == pytest.approx((iso.u_cr, found.Omega_cr), rel=1.5 * order)


def test_transmissibility_tends_to_its_floor():
    iso = Isolator(**example.TABLE_1)
    far = iso.amplitudes(Omega=1e5, F_0=0.04).transmissibility
    assert far == pytest.approx(iso.transmissibility_floor(0.04), rel=1e-3)
    assert iso.transmissibility_floor(0.04) == pytest.approx(4 * iso.mu / (math.pi * 0.04), rel=1e-15)
    shaken = iso.replace(excitation="base")
    assert shaken.transmissibility_floor(0.04) == 0
    assert shaken.amplitudes(Omega=1e5, F_0=0.04).transmissibility < 1e-5


@pytest.mark.slow
def test_margins_and_isolation_on_a_base_are_those_of_states():
    rng, kinds = np.random.default_rng(3), set()
    Omega = np.geomspace(0.1, 50.0, 400)
    for _ in range(60):
        parameters = {"lam": 3.0, "r": rng.uniform(0.5, 3), "delta_h": rng.uniform(0.01, 0.15)}
        parameters |= {"mu": rng.choice([0, 0.003, 0.01]), "zeta": rng.uniform(0.03, 0.85) ** 1.5}
        one, Y = Isolator(**parameters, excitation="base"), 10 ** rng.uniform(-2.3, 0)
        margins, begins, states = one.margins(Y), one.isolation(Y), one.amplitudes(Omega=Omega, F_0=Y)
        kinds.add((margins.detaches, one.peak(Y).A is None))
        # a sharp peak may pass between these frequencies
        assert margins.detaches >= bool((states.A[states.stable] > one.u_cr).any())
        assert margins.detaches == (Y > margins.F_cr)
        if begins.Omega is not None:
            transmits = states.transmissibility[states.stable & (states.Omega > begins.Omega)]
            assert (transmits < 1).all()
    assert len(kinds) >= 3


@pytest.mark.parametrize("F_0", [0.6, 0.7, 0.74, 0.75])
def test_quadratic_damping_keeps_an_unbalance_from_detaching(F_0):
    """The amplitude only rises, up to less than F_0: up to u_cr where c_2 A^2 and A balance F_0."""
    numbers = {"lam": 1.5, "r": 3.5, "delta_h": 0.18, "zeta": 0.6, "c_2": 1.7, "excitation": "unbalance"}
    one = Isolator(**numbers, force="untruncated")
    F_cr = one.u_cr * math.hypot(1, 1.7 * 8 / (3 * math.pi) * one.u_cr)
    A = one.frequency_response(F_0, Omega=(0.0, 1e4)).A
    many = Isolator.many(**numbers, force="untruncated").margins(F_0)
    assert one.peak(F_0).A is None and one.margins(F_0).F_cr == pytest.approx(F_cr, rel=1e-12)
    assert one.margins(F_0).detaches == bool(many.detaches) == (A.max() > one.u_cr) == (F_0 > F_cr)


def test_a_response_cut_at_the_reach_claims_nothing_beyond():
    cut = derive.library("three_spring")(alpha=0.9, ell=1.5, zeta=0.02, excitation="base")
    for found in (cut.hysteresis(2.5), cut.isolation(2.5)):
        assert Remark.CUT in found.remarks
        assert found.message == cut.saddle_nodes(2.5).message


def test_what_is_not_available_is_refused_in_words():
    iso = Isolator(**example.TABLE_1, excitation="base")
    refused = [
        lambda: iso.certify(0.03),
        lambda: iso.saddle_nodes(0.03, certify=True),
        lambda: Isolator.many(**example.TABLE_1, excitation="base").certify(0.03),
    ]
    for ask in refused:
        with pytest.raises(ValueError, match="is not available with excitation = 'base', only with 'force'"):
            ask()
    with pytest.raises(ValueError, match="excitation = 'bass' is not allowed"):
        iso.replace(excitation="bass")
    with pytest.raises(ValueError, match="with zeta = 0"):
        iso.replace(zeta=0.0)


def test_an_oscillator_keeps_its_excitation():
    iso = Isolator(**example.TABLE_1, excitation="base")
    assert iso == iso.replace() != iso.replace(excitation="unbalance")
    assert "excitation='base'" in repr(iso)
    assert "excitation" not in repr(iso.replace(excitation="force"))


def test_base_that_hardly_shakes_sticks_without_a_warning():
    """Omega^2 = 4 mu/(pi F_0) is beyond the range of doubles."""
    iso = Isolator(lam=3, r=2, delta_h=0.08, mu=0.01, zeta=0.05, excitation="base")
    for ask in (iso.amplitudes, iso.second_approximation.amplitudes):
        found = ask(Omega=0.9, F_0=5e-324)
        assert not found.A.any() and "sticks up to Omega = inf" in found.message
