"""The solvers against certified references, and where events coincide."""

import math
import tracemalloc

import numpy as np
import pytest

from slowflow import Duffing, Isolator
from slowflow.averaged import diagnostics
from slowflow.example import TABLE_1, isolator
from slowflow_kernels import slow_flow
from tests.averaged.test_certified_cases import ABOUT_CENTRE, ROUNDED, double, of_record
from tests.files import stored
from tests.oracles.errors import error

#: relative errors in u (1 + kappa)
UNITS = 4


@pytest.mark.parametrize(
    "record",
    [pytest.param(one, id=f"{file} {number}") for file in ABOUT_CENTRE for number, one in enumerate(stored(file))],
)
@pytest.mark.part(2)
def test_curves_peaks_and_extrema_are_the_certified_ones(record):
    """Folds, states and onsets of the same records: `test_certified_cases`."""
    oscillator = of_record(record)
    if record.get("detachment", {}).get("attained"):
        gradient = oscillator.detachment().gradient()
        for name, known in {"F_cr": "F_0", "Omega_cr": "Omega", "u_cr": "A"}.items():
            assert gradient.condition(name) == pytest.approx(record["detachment"]["condition"][known], rel=ROUNDED)
    check_extrema(oscillator, record["fold_locus"]["extrema"])
    for forcing in record["forcings"]:
        F_0 = double(forcing["F_0"])
        found = oscillator.frequency_response(F_0, samples=60, Omega=(1e-9, 2.0))
        assert np.isfinite(found.A).all() and np.isfinite(found.Omega).all()
        check_peak(oscillator, oscillator.peak(F_0), forcing["peaks"])


def check_extrema(oscillator, exact):
    A_max = 1.5 * max([float(point["A"]) for point in exact], default=1.0)
    cusps, isolas = oscillator.cusps(A_max=A_max), oscillator.isola_points(A_max=A_max)
    for kind, found in (("cusp", cusps), ("isola", isolas)):
        points = sorted((p for p in exact if p["kind"] == kind), key=lambda p: float(p["A"]))
        assert len(found) == len(points)
        for k, point in enumerate(points):
            assert error(found.F_0[k], point, "F_0") <= UNITS
            assert error(found.A[k], point, "A") <= UNITS
            if kind == "cusp":
                assert found.minimum[k] == (point["sense"] == "min")
            elif point["sense"] == "max":
                assert found.kind[k] != "birth"


def check_peak(oscillator, found, exact):
    """The reference has every top of the curve, those where F falls with A, and those beyond a well, too."""
    model = oscillator.model

    def ends_stable_motions(top):
        A, Omega = float(top["A"]), float(top["Omega"])
        beyond = diagnostics.turns_beyond(model, A)
        return top["sense"] == "max" and float(model.F_A(Omega, A)) > 0 and not beyond

    tops = [peak for peak in exact if ends_stable_motions(peak)]
    if tops:
        top = max(tops, key=lambda peak: float(peak["A"]))
        assert found.A == pytest.approx(float(top["A"]), rel=1e-11)
        assert found.Omega == pytest.approx(float(top["Omega"]), rel=1e-9)


def random_designs(seed, n):
    """lam, r, delta_h, mu, zeta, F_0: delta_h up to 1.6 times that of zero stiffness, F_0 from 4 mu/pi to far above."""
    rng = np.random.default_rng(seed)
    lam, r = rng.uniform(1, 4, n), rng.uniform(0.4, 4, n)
    ratio = np.where(rng.random(n) < 0.85, rng.uniform(0.02, 1, n), rng.uniform(1, 1.6, n))
    delta_h = np.minimum(ratio / (lam * r), 0.95)
    mu = np.where(rng.random(n) < 0.15, 0.0, 10 ** rng.uniform(-5, -1.5, n))
    zeta = 10 ** rng.uniform(-3, 0.3, n)
    F_0 = np.maximum(4 / np.pi * mu, 1e-4) * 10 ** rng.uniform(0.001, 2.5, n)
    return np.stack([lam, r, delta_h, mu, zeta, F_0], axis=-1)


# ---- many designs --------------------------------------------------------------------------------------------------


def test_a_bad_design_gets_a_status_and_spoils_no_other():
    many = Isolator.many(**{**TABLE_1, "lam": [3, -1, math.nan, 3, 3], "zeta": [0.02, 0.02, 0.02, -1, 0]})
    assert many.detachment().status.tolist() == [0, 1, 1, 1, 0]
    assert many.saddle_node_onset().status.tolist() == [0, 1, 1, 1, 4]
    assert many.peak([0.04, 0.04, 0.04, 0.04, 0.04]).status.tolist() == [0, 1, 1, 1, 4]
    assert many.saddle_nodes(0.015).status.tolist() == [2, 1, 1, 1, 2]
    assert Isolator.many(**TABLE_1).saddle_nodes([0.04, -1, math.inf]).status.tolist() == [0, 1, 1]
    crowded = Isolator.many(**TABLE_1).saddle_nodes(0.04, max_count=1)
    assert crowded.status == 6 and crowded.count == 2 and crowded.kind.tolist() == [1]
    assert Duffing.many(1.0, [0.0, 0.5], 0.01, 0.1).saddle_node_onset().status.tolist() == [3, 0]
    assert Duffing.many(1.0, 1.0).detachment().status == 3


@pytest.mark.parametrize("wrong", ["three", [1, "x"], None, [[1, 2], [3]], 1j])
def test_what_is_no_array_of_numbers_is_refused(wrong):
    with pytest.raises(ValueError, match="lam"):
        Isolator.many(**{**TABLE_1, "lam": wrong})


def test_shapes_that_do_not_broadcast_are_named():
    with pytest.raises(ValueError, match=r"lam \(2,\).*zeta \(3,\)"):
        Isolator.many(**{**TABLE_1, "lam": [1, 2], "zeta": [0.1, 0.2, 0.3]})
    with pytest.raises(ValueError, match="F_0"):
        Isolator.many(**{**TABLE_1, "lam": [1, 2]}).peak([0.1, 0.2, 0.3])


def test_a_batch_allocates_its_answers_and_no_more():
    n = 1_000_000
    lam = np.broadcast_to(np.linspace(1, 4, 1000), (1000, 1000))
    many = Isolator.many(**{**TABLE_1, "lam": lam})
    tracemalloc.start()
    found = many.detachment()
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    answers = sum(array.nbytes for array in (found.F_cr, found.Omega_cr, found.u_cr, found.status))
    assert answers == 25 * n and most <= answers + 1_000_000


# ---- where events coincide -----------------------------------------------------------------------------------------


def neighbours(value):
    return [np.nextafter(value, 0), value, np.nextafter(value, np.inf)]


@pytest.mark.slow
@pytest.mark.parametrize("zeta", [1e-9, 1e-4, 0.02, 1.5])
@pytest.mark.parametrize("mu", [0.0, 0.012])
@pytest.mark.parametrize("ratio", [0.5, 1.0, 1.2])
def test_a_curve_at_a_critical_forcing_is_whole(ratio, mu, zeta):
    oscillator = Isolator(lam=3, r=2, delta_h=ratio / 6, mu=mu, zeta=zeta)
    forcings = [oscillator.detachment().F_cr, oscillator.saddle_node_onset().F_SN]
    for forcing in forcings:
        for F_0 in neighbours(forcing):
            curve = oscillator.frequency_response(F_0, samples=60)
            assert_on_curve(oscillator, curve)
            for branch, closed in enumerate(curve.isola):
                ends = np.flatnonzero(curve.branch == branch)[[0, -1]]
                at_edge = (curve.Omega[ends] == 0) | (curve.Omega[ends] == 2)
                assert closed or at_edge.all()


def assert_on_curve(oscillator, curve):
    """Every point is a steady state: the forcing that it needs is F_0 to rounding of its terms."""
    model = oscillator.model
    h = model.averaged(curve.A)[0]
    R, I = slow_flow.R(curve.Omega, curve.A, h), slow_flow.I(curve.Omega, curve.A, model.m, model.zeta)
    terms = curve.A * (1 + curve.Omega**2) + np.abs(I)  # h has terms of the size of A, which may cancel
    # an ulp above u_cr h has a vertical tangent: amplitudes that are u_cr to rounding are left out
    away = np.abs(curve.A - np.array(model.breakpoints)) > 1e-14 * curve.A
    assert (np.abs(np.hypot(R, I) - curve.F_0)[away] <= 1e-12 * (terms + curve.F_0)[away]).all()


def test_softening_has_folds_down_to_the_friction_limit():
    oscillator = Duffing(1.0, -0.3, mu=0.01, zeta=0.05)
    m, onset = oscillator.sticking_forcing, oscillator.saddle_node_onset()
    assert "folds that end at Omega = 0" in onset.message
    zero_of_h = math.sqrt(4 / 0.9)  # h = -A + 0.225 A^3
    low = oscillator.saddle_nodes(1.0001 * m)
    assert len(low) % 2 == 1 and low.A[0] == pytest.approx(zero_of_h, rel=1e-2)
    assert np.isfinite(oscillator.frequency_response(1.0001 * m).A).all()


def test_a_small_loop_of_the_fold_locus_keeps_its_cusp():
    # alpha slightly below 0: the locus leaves Omega = 0 where h_A = 0, turns at a cusp and comes back where h = 0
    oscillator = Isolator(
        lam=1.6172314899701874, r=2.002654154370871, delta_h=0.31049204594233715, zeta=0.0922908151530438
    )
    cusps = oscillator.cusps()
    assert cusps.minimum.tolist() == [False, True]
    for ratio, count in ((0.9, 2), (0.999, 2), (1.001, 0)):
        assert len(oscillator.saddle_nodes(ratio * cusps.F_0[0])) == count


def test_without_damping_the_folds_are_those_of_the_closed_form():
    oscillator = Duffing(1.0, 0.5)
    F_0 = 0.3
    found = oscillator.saddle_nodes(F_0)
    # Omega^2 = -h_A = 1 + 9/8 A^2, and R = h - A h_A = 3/4 A^3 is F_0
    A = (4 * F_0 / 3) ** (1 / 3)
    assert found.A.tolist() == pytest.approx([A], rel=1e-14)
    assert found.Omega.tolist() == pytest.approx([math.sqrt(1 + 9 / 8 * A * A)], rel=1e-14)


def test_fold_locus_passes_an_amplitude_without_force():
    """Where h = 0 a fold at Omega = 0 is born beside the one that the locus follows, which is not there."""
    one = Isolator(lam=2, r=1.9814162218754052, delta_h=0.2722727716275526, mu=0.001944368707139919)
    locus = one.fold_locus(samples=400)
    for branch in np.unique(locus.branch):
        Omega = locus.Omega[(locus.branch == branch) & (locus.A < 0.6)]
        assert np.abs(np.diff(Omega)).max(initial=0.0) < 0.02


def test_the_fold_locus_passes_the_folds_of_every_forcing():
    oscillator = isolator()
    points = oscillator.fold_locus(samples=200)
    assert points.A.min() < oscillator.u_cr < points.A.max() and points.branch.max() >= 1
    model = oscillator.model
    h, h_A, _, _ = model.averaged(points.A)
    slope = slow_flow.F_A(points.Omega, points.A, model.m, model.zeta, h, h_A)
    steep = np.abs(h_A) > 1e3  # next to u_cr an ulp of A moves F_A
    assert (np.abs(slope[~steep]) <= 1e-9).all()
    cusp = np.abs(points.F_0 / oscillator.saddle_node_onset().F_SN - 1) <= 1e-12  # no fold yet, or two
    corner = points.A == oscillator.u_cr  # where the branch below u_cr ends, its fold meets one on the corner
    for k in np.flatnonzero(~steep & ~cusp & ~corner)[::25]:
        folds_there = oscillator.saddle_nodes(points.F_0[k])
        assert np.abs(folds_there.A / points.A[k] - 1).min() <= 1e-6
    assert oscillator.cusps().F_0.min() == pytest.approx(oscillator.saddle_node_onset().F_SN, rel=1e-13)


def test_undamped_fold_locus_is_that_of_the_closed_form():
    """Omega^2 = -h_A = 1 + 9/8 A^2 from A = 0 on, at the forcing R = h - A h_A = 3/4 A^3."""
    locus = Duffing(1.0, 0.5).fold_locus(samples=20, A_max=1.0)
    assert len(locus) >= 20 and locus.A[0] == 0 and locus.A[-1] == 1
    np.testing.assert_allclose(locus.Omega, np.sqrt(1 + 9 / 8 * locus.A**2), rtol=1e-14)
    np.testing.assert_allclose(locus.F_0, 0.75 * locus.A**3, rtol=1e-12, atol=1e-16)


def test_a_mechanism_without_end_needs_an_amplitude():
    with pytest.raises(ValueError, match="A_max"):
        Duffing(1.0, 0.5, 0.01, 0.02).fold_locus()
    nothing = Duffing(1.0, 0.0, 0.01, 0.02)
    assert len(nothing.cusps(A_max=1.0)) == 0 and "no cusp" in nothing.cusps(A_max=1.0).message
    locus = nothing.fold_locus(samples=10, A_max=1.0)
    assert len(locus) == 0 and "no saddle node" in locus.message
