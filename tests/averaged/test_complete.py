"""No fold, onset, peak or point of a curve is missed: where folds begin, by hand, and for cases once missed."""

import math
from fractions import Fraction

import numpy as np
import pytest

from slowflow import Duffing, Isolator, example
from slowflow.answers.results import Remark
from slowflow.example import TABLE_1
from tests.averaged.test_solver_paths import random_designs
from tests.oracles.by_work import assert_complete
from tests.sampling import slow

#: designs
MANY = 1000


# ---- where (33) names the onset --------------------------------------------------------------------------------------


def named_by_33(isolator):
    """The ledger's two conditions, by hand from h_1 = -alpha A - 3/4 beta A^3 - 5/8 gamma A^5 at u_cr.

    Whether F_A < 0 at the least Omega with F_AA = 0, and the forcing at which the backbone reaches u_cr.
    """
    alpha, beta, gamma, A = isolator.model.parameters
    m, zeta = isolator.sticking_forcing, isolator.zeta
    h = -alpha * A - 3 / 4 * beta * A**3 - 5 / 8 * gamma * A**5
    h_A = -alpha - 9 / 4 * beta * A**2 - 25 / 8 * gamma * A**4
    h_AA = -9 / 2 * beta * A - 25 / 2 * gamma * A**3
    # F_AA/2 = X^2 + (2 h_A + A h_AA + 4 zeta^2) X + h h_AA + h_A^2, X = Omega^2
    roots = np.roots([1, 2 * h_A + A * h_AA + 4 * zeta**2, h * h_AA + h_A**2])
    bends = np.sort(roots[(roots.imag == 0) & (roots.real > 0)].real)
    corner = m + 2 * zeta * math.sqrt(-A * h)
    if not bends.size:
        return False, corner
    Omega = math.sqrt(bends[0])
    F_A = (A * Omega**2 + h) * (Omega**2 + h_A) + 2 * zeta * Omega * (2 * zeta * A * Omega + m)
    return F_A < 0, corner


@pytest.mark.slow
def test_onset_is_that_of_33_under_the_conditions_of_the_ledger():
    rng, seen = np.random.default_rng(33), set()
    for _ in range(MANY):
        stiffness, mu = 10 ** rng.uniform(-1, 1), rng.choice([0.0, 10 ** rng.uniform(-5, -1.3)])
        delta_h = min(rng.uniform(0.002, 1) if rng.random() < 0.5 else 10 ** rng.uniform(-3, 0), 0.9 * stiffness)
        isolator = Isolator(lam=1, r=stiffness, delta_h=delta_h / stiffness, mu=mu, zeta=10 ** rng.uniform(-3, 0))
        onset, cusps = isolator.saddle_node_onset(), isolator.cusps(A_max=isolator.u_cr)
        attached, corner = named_by_33(isolator)
        assert cusps.minimum.sum() == attached, isolator
        named = attached and cusps.F_0[cusps.minimum][0] <= corner
        assert named == (onset.kind == "cusp" and onset.A < isolator.u_cr), isolator
        assert named or onset.F_SN == pytest.approx(corner, rel=1e-12)
        seen.add((attached, named))
    assert seen == {(False, False), (True, False), (True, True)}


def test_least_preload_for_which_33_holds_is_the_ledgers():
    """Shares of 1/(lam r) in LEDGER.md, four digits each, Table 1 otherwise."""
    lam_r = TABLE_1["lam"] * TABLE_1["r"]
    for fraction, attached, named in ((0.1106, 0, False), (0.1108, 1, False), (0.14395, 1, False), (0.14405, 1, True)):
        isolator = example.isolator(delta_h=fraction / lam_r)
        assert isolator.cusps(A_max=isolator.u_cr).minimum.sum() == attached
        assert (isolator.saddle_node_onset().kind == "cusp") == named


# ---- a pair of isola points between two samples ----------------------------------------------------------------------

SOFTENING = (3.0, -0.7317705776395018, 0.029025484740650885, 0.8847453384171343)
F_0 = 2.6904551098096063


def test_two_isola_points_close_to_each_other_are_both_found():
    """By hand: Omega^2 = h_A, and F_Omega/(4 A) = Omega R + zeta I = 0 there, scanned with 10^6 amplitudes."""
    alpha, beta, mu, zeta = SOFTENING
    A = np.linspace(1e-3, 10, 1_000_001)
    h, h_A = -alpha * A - 0.75 * beta * A**3, -alpha - 2.25 * beta * A**2
    A, h, h_A = A[h_A > 0], h[h_A > 0], h_A[h_A > 0]
    Omega = np.sqrt(h_A)
    value = Omega * (A * Omega**2 + h) + zeta * (2 * zeta * A * Omega + 4 * mu / math.pi)
    at = np.flatnonzero((value[1:] < 0) != (value[:-1] < 0))
    assert at.size == 2
    for A_max in (2, 6, 6.3, 7, 8, 1e3, 1e6):
        found = Duffing(*SOFTENING).isola_points(A_max=A_max)
        assert found.A.tolist() == pytest.approx(A[at].tolist(), abs=2e-5)


def test_folds_states_and_stability_next_to_them_are_all_there():
    oscillator = Duffing(*SOFTENING)
    assert_complete(oscillator, F_0, (0.7203394583836413,))
    assert len(oscillator.saddle_nodes(F_0)) == 3
    curve = oscillator.frequency_response(F_0)
    F_A = oscillator.model.F_A(curve.Omega, curve.A)
    # beyond the well no motion comes back
    within = curve.A < math.sqrt(SOFTENING[0] / -SOFTENING[1])
    clear = np.abs(F_A) > 1e-6
    assert (curve.stable[clear] == ((F_A > 0) & within)[clear]).all()
    assert {*curve.stable[clear & within].tolist()} == {True, False}


def test_an_onset_at_weak_damping_is_not_the_corner_above_it():
    """The cusp's forcing as balls prove it; the corner's was given, 10^5 times as high, and folds below it denied."""
    numbers = {"lam": 0.00042405072756133977, "r": 0.011652400350826778, "delta_h": 0.1727202645945281}
    damping = {"mu": 2.6813677269197822e-27, "zeta": 5.132908214161428e-18}
    iso = Isolator(**numbers, **damping)
    assert iso.saddle_node_onset().F_SN == pytest.approx(3.29681068098481e-23, rel=1e-9)
    assert Isolator.many(**numbers, **damping).saddle_node_onset().F_SN == iso.saddle_node_onset().F_SN
    assert len(iso.saddle_nodes(5.711780110584607e-18)) == 2


# ---- where folds begin -----------------------------------------------------------------------------------------------


def drawn():
    """Isolators, a seventh of them of negative stiffness at rest; and without viscous damping, half of them of that."""
    for force, count in (("truncated", MANY), ("untruncated", MANY // 10)):
        for *design, _ in random_designs(1, count):
            yield Isolator(**dict(zip(("lam", "r", "delta_h", "mu", "zeta"), design, strict=True)), force=force)
    rng = np.random.default_rng(15)
    for k in range(MANY // 4):
        mu = float(rng.choice([0.0, 10 ** rng.uniform(-4, -1)]))
        if k % 2:
            yield Duffing(float(rng.uniform(-1, 1)), float(rng.uniform(-1, 2)), mu, 0.0)
        else:
            design = {"lam": float(rng.integers(1, 5)), "r": 10 ** rng.uniform(-1, 1)}
            delta_h = min(0.95, rng.uniform(0.05, 2) / (design["lam"] * design["r"]))
            force = ("truncated", "untruncated")[k % 4 // 2]
            yield Isolator(**design, delta_h=delta_h, mu=mu, zeta=0.0, force=force)


@pytest.mark.slow
def test_folds_begin_where_the_onset_says():
    """Next to 4 mu/pi, if only at ever larger amplitudes, at F_SN, or where they end at Omega = 0; below is none."""
    seen = set()
    for oscillator in drawn():
        onset, least = oscillator.saddle_node_onset(), oscillator.sticking_forcing

        def count(F_0, oscillator=oscillator):
            return len(oscillator.saddle_nodes(F_0))

        if "no lowest forcing" in onset.message:
            seen.add("none is lowest" if oscillator.alpha > 0 else "none beyond reach")
            assert oscillator.alpha <= 0 or count(least * (1 + 1e-9) + (1e-9 if least == 0 else 0)) > 0, oscillator
            h, h_A, *_ = oscillator.model.averaged(1e3)
            assert oscillator.alpha > 0 or (h_A < 0 and abs(h - 1e3 * h_A) < 1e-4), oscillator
            continue
        at_rest = float(onset.message.partition("from F_0 = ")[2].partition(" on")[0] or "inf")
        first = min(at_rest, math.inf if onset.F_SN is None else onset.F_SN)
        seen.add("lowest" if first == onset.F_SN else "at rest" if first < math.inf else "none")
        for fraction in (1e-6, 1e-3, 0.1, 0.5, 0.9):  # six digits of it are said
            F_0 = least + fraction * (min(first, 10.0) - least)
            assert F_0 >= first * (1 - 1e-5) or count(F_0) == 0, oscillator
        assert first == math.inf or count(first * (1 + 1e-5) or 1e-9) > 0, oscillator
        if onset.F_SN is not None:
            before, after = (count(onset.F_SN * ratio) for ratio in (1 - 1e-6, 1 + 1e-6))
            assert after == before + 2, oscillator
    assert seen == {"none is lowest", "none beyond reach", "lowest", "at rest", "none"}


def test_undamped_softening_spring_has_folds_from_friction_on():
    """By hand: Omega^2 = 1 - 9/8 A^2 and R = 3/4 A^3 in size, so that A^6 = (F_0^2 - m^2) 16/9, up to F_0 = 0.63."""
    spring = Duffing(1.0, -0.5, 0.01, 0.0)
    onset, F_0 = spring.saddle_node_onset(), 0.1
    assert onset.F_SN is None and "no lowest forcing" in onset.message and "every F_0" not in onset.message
    A = (16 / 9 * (F_0**2 - spring.sticking_forcing**2)) ** (1 / 6)
    assert spring.saddle_nodes(F_0).A.tolist() == pytest.approx([A], rel=1e-14)
    assert len(spring.saddle_nodes(0.7)) == 0
    buckled = Duffing(-0.5, 1.0, 0.01, 0.0).saddle_node_onset()
    level = math.hypot(0.04 / math.pi, 1.5 * (0.5 / 2.25) ** 1.5)
    assert buckled.F_SN is None and f"that end at Omega = 0, from F_0 = {level:g} on" in buckled.message


# ---- points along a curve --------------------------------------------------------------------------------------------


def test_a_tall_peak_is_followed_down_to_its_foot():
    """At zeta = 1e-4 it is 200 high: points shared out by A leave out its foot, where it is 1/50 of that and less."""
    curve = example.isolator(mu=0.0, zeta=1e-4).frequency_response(0.04)
    above = curve.Omega > 1.2
    steps = np.diff(np.sort(np.unique(curve.Omega[above])))
    assert steps.max() < 0.1 and curve.A.max() > 100


@pytest.mark.parametrize("Omega", [1e3, 1e10, 1e20, 1e40])
def test_far_above_resonance_the_mass_alone_holds_the_forcing(Omega):
    """A Omega^2 tends to sqrt(F_0^2 - m^2), but for terms that are smaller by 1/Omega."""
    oscillator = Isolator(lam=3, r=2, delta_h=0.08, mu=0.01, zeta=0.1)
    inertia = math.sqrt(0.04**2 - oscillator.sticking_forcing**2)
    states = oscillator.amplitudes(Omega=Omega, F_0=0.04)
    assert states.A.tolist() == pytest.approx([inertia / Omega**2], rel=3 / Omega + 1e-14)
    curve = oscillator.frequency_response(0.04, Omega=(0.0, Omega))
    assert curve.Omega.max() == Omega and curve.A.min() == pytest.approx(inertia / Omega**2, rel=3 / Omega + 1e-14)


def _off_the_curve(alpha, gamma, mu, zeta, F_0, Omega, A):
    """F of a cubic spring in fractions, over the change that a relative change of 1 of any of its terms makes."""
    m, (alpha, gamma, zeta, F_0, Omega, A) = (
        Fraction(4 * mu / math.pi),
        map(Fraction, (alpha, gamma, zeta, F_0, Omega, A)),
    )
    h = alpha * A + Fraction(3, 4) * gamma * A**3
    R, I = h - Omega**2 * A, 2 * zeta * Omega * A + m
    R_A, I_A = alpha + Fraction(9, 4) * gamma * A**2 - Omega**2, 2 * zeta * Omega
    F_A, F_Omega = 2 * R * R_A + 2 * I * I_A, -4 * R * Omega * A + 4 * I * zeta * A
    return float(abs(R**2 + I**2 - F_0**2) / (abs(F_A) * A + abs(F_Omega) * Omega + abs(R * h) + I**2))


@pytest.mark.parametrize(
    ("alpha", "gamma", "mu", "zeta", "F_0", "window"),
    [
        (2.2e13, 1.0, 0.0, 0.01, 1.0, (0.5, 2.0)),
        (8.9e13, 5.4e9, 0.6, 5.7e-6, 66.0, (0.08, 1.67)),
        (0.0, -1222797.0, 0.0, 8.3e-8, 1.5e16, (0.283, 0.842)),
        (-40341386164432.41, 6.658e21, 0.0, 15.3, 7537065.9, (2.53, 6.68)),
        (0.0, -2.38, 0.0, 1.1e-11, 1.06e20, (0.0038, 0.103)),
    ],
)
def test_curve_keeps_to_its_window_at_degenerate_frequencies(alpha, gamma, mu, zeta, F_0, window):
    curve = Duffing(alpha, gamma, mu, zeta).frequency_response(F_0, samples=60, Omega=window)
    assert curve.Omega.min() == window[0] and curve.Omega.max() == window[1]
    for at, A in zip(curve.Omega, curve.A, strict=True):
        assert _off_the_curve(alpha, gamma, mu, zeta, F_0, at, A) < 1e-14


@pytest.mark.parametrize(
    ("oscillator", "F_0"),
    [
        # two branches are one in doubles: half of the curve was missing
        (Duffing(0.0, 8.427993301202146e25, 0.0002189816747832573, 2.009615344372806e-14), 0.002189816747832573),
        (Duffing(0.0, 8.1e24, zeta=1.7e-132, excitation="base"), 5.2e92),  # h^2 overflows: NaN, or A = F_0
        (Duffing(0.0, 8.1e24, zeta=0.01, excitation="base"), 5.2e40),
    ],
)
def test_what_doubles_do_not_hold_is_refused(oscillator, F_0):
    with pytest.raises(ArithmeticError, match="unresolved"):
        oscillator.frequency_response(F_0, Omega=(0.05, 0.4))


def test_few_samples_lie_on_their_own_branches():
    """Without a point inside a part that spans orders of magnitude the next part's were taken for its own, on NumPy."""
    oscillator = Duffing(1.0, 0.05, 0.0, 0.02)
    for samples in range(2, 40):
        curve = oscillator.frequency_response(1.0, samples=samples, Omega=(0.01, 50.0))
        for at, A in zip(curve.Omega[curve.A < 40], curve.A[curve.A < 40], strict=True):
            assert _off_the_curve(1.0, 0.05, 0.0, 0.02, 1.0, at, A) < 1e-14


def test_more_than_can_be_shown_is_refused_by_its_name():
    oscillator = Isolator(lam=3, r=2, delta_h=0.08, mu=0.01, zeta=0.1)
    for query in (
        lambda: oscillator.frequency_response(0.04, samples=2**33),
        lambda: oscillator.fold_locus(samples=10**12),
    ):
        with pytest.raises(ValueError, match=r"samples = \d+ is not allowed: samples must be an integer >= 2 and <= 1"):
            query()
    with pytest.raises(ValueError, match=r"Omega\[1\] = 1e\+308 is not allowed"):
        oscillator.frequency_response(0.04, Omega=(0, 1e308))
    with pytest.raises(ValueError, match=r"Omega = 1e\+200 is not allowed"):
        oscillator.amplitudes(Omega=1e200, F_0=0.04)


# ---- at the ends of the range ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("F_0", [1e-10, 1e-16, 1e-30, 1e-60, 1e-100])
def test_a_softening_spring_has_its_fold_at_rest_at_any_forcing(F_0):
    """h = 0 at A^2 = 8/3; next to it F_A = 0 leaves R of second order, so that I = 2 zeta A Omega is F_0."""
    folds = Duffing(1, -0.5, 0, 0.1).saddle_nodes(F_0)
    A = math.sqrt(8 / 3)
    assert folds.A.tolist() == pytest.approx([A], rel=1e-9)
    assert folds.Omega.tolist() == pytest.approx([F_0 / (0.2 * A)], rel=1e-9)


@pytest.mark.parametrize("F_0", [1e-100, 1e100, *slow(1e-58, 1e43, 1e60)])
def test_forcings_far_from_1_are_answered(F_0):
    """Weak ones leave A = F_0/(2 zeta) at resonance, the peak of the linear oscillator to first order; strong ones a
    peak on the backbone, where 2 zeta A Omega = F_0 and Omega^2 = 3/4 beta A^2."""
    oscillator = Duffing(1, 0.5, 0, 0.1)
    peak = oscillator.peak(F_0).A
    if F_0 < 1:
        assert peak == pytest.approx(F_0 / (0.2 * math.sqrt(1 - 0.01)), rel=1e-12)
        assert len(oscillator.saddle_nodes(F_0)) == 0
    else:
        assert peak == pytest.approx(math.sqrt(F_0 / (0.2 * math.sqrt(0.375))), rel=1e-6)
        assert oscillator.saddle_nodes(F_0).kind.tolist() == ["jump-up", "jump-down"]


@pytest.mark.parametrize("delta_h", [1e-60, *slow(1e-120)])
def test_next_to_no_preload_the_oscillator_is_linear(delta_h):
    """But for folds at u_cr, where the truncated force jumps: doubles do not tell two from none, balls may."""
    oscillator = Isolator(lam=3, r=2, delta_h=delta_h, mu=0.01, zeta=0.1)
    folds = oscillator.saddle_nodes(0.1)
    assert len(folds) == 0 or (len(folds) == 2 and Remark.OF_TRUNCATION in folds.remarks)
    assert folds.A.tolist() == pytest.approx([oscillator.u_cr] * len(folds), rel=1e-15)
    linear = Isolator(lam=3, r=2, delta_h=0, mu=0.01, zeta=0.1)
    assert oscillator.peak(0.1).A == pytest.approx(linear.peak(0.1).A, rel=1e-12)


@pytest.mark.parametrize("zeta", [1e-9, 1e-11, 1e-12, 1e-14])
def test_next_to_no_damping_no_corner_fold_is_made_up(zeta):
    """The folds tend to those at zeta = 0, off the peak, which goes to infinity and is none."""
    values = {"lam": 3, "r": 2, "delta_h": 0.08, "mu": 0.012}
    folds = Isolator(**values, zeta=zeta).saddle_nodes(0.04)
    limit = Isolator(**values, zeta=0).saddle_nodes(0.04)
    assert not folds.corner.any() and len(folds) == len(limit)
    assert np.abs(folds.A[:, np.newaxis] / limit.A - 1).min(axis=0).max() < 1e-8


@pytest.mark.parametrize("zeta", [0.9, 1.0, 1.2, 1.5])
@pytest.mark.parametrize("delta_h", [0.02, 0.05, 0.08])
def test_the_peak_at_the_detachment_is_the_higher_static_state(delta_h, zeta):
    """The response only falls with Omega: at rest -h = F_0 holds on u_cr, and perhaps above it."""
    oscillator = example.isolator(delta_h=delta_h, mu=0.0, zeta=zeta)
    F_cr = oscillator.detachment().F_cr
    peak = oscillator.peak(F_cr)
    A = np.linspace(oscillator.u_cr * (1 + 1e-9), 2, 100_000)
    above = A[-oscillator.model.averaged(A)[0] <= F_cr]
    highest = above.max() if above.size else oscillator.u_cr
    assert peak.Omega == 0 and peak.A == pytest.approx(highest, rel=1e-4)
    assert len(oscillator.second_approximation.saddle_nodes(F_cr)) == 0


def test_motions_beyond_a_softening_well_are_above_its_peak():
    # at Omega = 0: A (1 - 3/4 A^2) = -F_0 beyond A = sqrt(4/3); at the top 2 zeta Omega A = F_0 but for R^2 ~ zeta^4
    F_0, zeta = 0.008, 0.01
    soft = Duffing(1.0, -1.0, 0.0, zeta)
    beyond = max(np.roots([-0.75, 0.0, 1.0, F_0]).real)
    top = soft.peak(F_0)
    assert top.A == pytest.approx(F_0 / (2 * zeta * top.Omega), rel=1e-3)
    assert top.A < 0.5 < beyond
    assert soft.amplitudes(Omega=1e-6, F_0=F_0).A[-1] == pytest.approx(beyond, rel=1e-10)
    assert soft.frequency_response(F_0, Omega=(0.0, 2.0)).A.max() == pytest.approx(beyond, rel=1e-10)
