"""Forces of any kind, stated in a program: averages by quadrature and what stands on them, against closed forms."""

from __future__ import annotations

import functools
import math

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from slowflow import Duffing, derive
from slowflow.answers.results import Remark
from slowflow.core import backend
from slowflow.core.model import break_loose
from slowflow_kernels import slow_flow
from slowflow_kernels.conventions import Status
from tests.files import stored
from tests.native.records import bent
from tests.oracles.by_work import assert_complete
from tests.oracles.forces import FORCES as NUMBERS
from tests.oracles.pieces import AVERAGED, c, gap, k, names_of, p, u
from tests.sampling import slow

ABOVE_0 = {"above": 0}
DAMPING = {"mu": 0.01, "zeta": 0.03}
#: pieces for u > 0 and their numbers: some whose averages have forty certified digits, and more
FORCES = {
    **{
        name: (AVERAGED[name], NUMBERS[name][0])
        for name in ("pendulum", "preload", "quadratic", "wave", "dead", "soft_stop", "two_stops", "hertz")
    },
    "power": ([(k * u**p, None)], {"k": 1.0, "p": 2.5}),
    "septic": ([(u - k * u**3 + c * u**5 - p * u**7 + u**9 / 50, None)], {"k": 1.0, "c": 0.6, "p": 0.15}),
    "numbers": ([(sp.sin(u), sp.Rational(1, 2)), (k * u, None)], {"k": 1.5}),
}
CASES = stored("forces")


@functools.cache
def derived(name, compile=False):
    """A mechanism, derived once."""
    pieces = FORCES[name][0] if name in FORCES else AVERAGED[name]
    reach = {"reach": 3.1} if name == "pendulum" else {}
    full = f"{name}_in_C" if compile else name
    return derive.mechanism(full, pieces, dict.fromkeys(names_of(pieces), ABOVE_0), compile=compile, **reach)


def oscillator(name, **damping):
    """One of them with its numbers."""
    return derived(name)(**FORCES[name][1], **(damping or DAMPING))


def closed(name, A, n=1):
    """h_n of two forces whose integrals have names."""
    if name == "pendulum":
        return -2 * mp.mpf(1.3) * (-1) ** ((n - 1) // 2) * mp.besselj(n, A)
    power = mp.mpf(2.5)
    return -2 / mp.sqrt(mp.pi) * A**power * mp.gamma(power / 2 + 1) / mp.gamma(power / 2 + 1.5)


@pytest.mark.slow
@pytest.mark.parametrize("compile", [False, True])
@pytest.mark.parametrize("name", sorted({case["force"] for case in CASES}))
@pytest.mark.part(4)
def test_an_average_and_its_slopes_are_right_to_rounding(name, compile):
    """Against certified values; error over u (1 + kappa), of which closed forms have less than 4 too."""
    record = derived(name, compile).record
    for case in CASES:
        if case["force"] != name:
            continue
        parameters = record.coefficients(*(case["numbers"][name] for name in record.design_names))
        found = record.averaged(case["A"], *parameters)
        with mp.workdps(45):
            for one, text, condition in zip(found, case["h"], case["condition"], strict=True):
                if text == "0":
                    assert one == 0
                    continue
                error = abs(mp.mpf(float(one)) / mp.mpf(text) - 1)
                assert error < 4 * 2.0**-53 * (1 + condition), (case, float(one))


@pytest.mark.parametrize("name", ["pendulum", "power"])
@pytest.mark.parametrize("A", [1e-3, 0.3, 1.7, 3.0])
def test_an_average_and_its_slopes_are_those_of_a_closed_form(name, A):
    found = oscillator(name).model.averaged(A)
    with mp.workdps(40):
        expected = [mp.diff(lambda a: closed(name, a), mp.mpf(A), order) for order in range(4)]
    for one, other in zip(found, expected, strict=True):
        assert float(one) == pytest.approx(float(other), rel=4e-15)


def test_harmonics_are_those_of_a_closed_form():
    found = oscillator("pendulum").model.harmonics(1.7)
    with mp.workdps(40):
        for n, values in ((3, found[:4]), (5, found[4:])):
            expected = [mp.diff(lambda a, n=n: closed("pendulum", a, n), mp.mpf(1.7), order) for order in range(4)]
            np.testing.assert_allclose(values, [float(one) for one in expected], rtol=1e-14, atol=1e-15)


@pytest.mark.parametrize("name", ["pendulum", *slow(*list(FORCES)[1:])])
def test_intercept_is_the_difference_it_stands_for(name):
    model = oscillator(name).model
    A = np.array([0.15, 0.7, 2.0])
    h, h_A, *_ = model.averaged(A)
    found = model.mechanism.intercept(A, *model.parameters)
    np.testing.assert_allclose(found, h - A * h_A, rtol=1e-12, atol=1e-14)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "excitation"), [*((name, "force") for name in FORCES), ("soft_stop", "base")])
def test_no_state_is_missed_or_made_up(name, excitation):
    """On a base far beyond what bounds the response."""
    one = oscillator(name).replace(excitation=excitation)
    for F_0 in (0.05, 0.3) if excitation == "force" else (0.3,):
        assert_complete(one, F_0, reach=one.model.reach)


#: with a power of u that is a number; by whether it is compiled
STIFF = [False, True]


def stiff_at_rest(compile):
    return derive.mechanism(
        "stiff_at_rest", [(c * u + k * u**p, None)], {"c": {}, "k": ABOVE_0, "p": ABOVE_0}, compile=compile
    )


@pytest.mark.slow
@pytest.mark.parametrize("compile", STIFF)
@pytest.mark.parametrize(("power", "mu"), [(0.5, 0.0), (0.8, 0.0), (0.2, 0.01)])
def test_under_a_power_below_1_folds_come_down_to_rest(power, mu, compile):
    """Without friction, or below 1/3 with it: at any forcing, however low above friction's, there are some."""
    made = stiff_at_rest(compile)
    one = made(c=1.0, k=1.0, p=power, mu=mu, zeta=0.03)
    found = one.saddle_node_onset()
    assert found.F_SN is None and "the stiffness is infinite at u = 0" in found.message
    assert [len(one.saddle_nodes(one.model.m + F_0)) for F_0 in (1e-2, 1e-4, 1e-6)] == [2, 2, 2]
    several = made.many(c=1.0, k=1.0, p=np.array([power, power]), mu=mu, zeta=0.03).saddle_node_onset()
    assert several.status.tolist() == [Status.UNBOUNDED] * 2


@pytest.mark.slow
@pytest.mark.parametrize("compile", STIFF)
@pytest.mark.parametrize(
    ("slope", "power", "mu"), [(0.0, 0.5, 0.01), (1.0, 0.5, 0.2), (0.0, 0.8, 0.01), (1.0, 0.8, 0.001)]
)
def test_friction_gives_an_onset_under_a_power_above_a_third(slope, power, mu, compile):
    """The lowest level of all folds on a fine grid of amplitudes, by the roots of F_A and h in closed form."""
    made, zeta = stiff_at_rest(compile), 0.03
    one = made(c=slope, k=1.0, p=power, mu=mu, zeta=zeta)
    onset, m = one.saddle_node_onset(), one.model.m
    of_power = float(2 / mp.sqrt(mp.pi) * mp.gamma(power / 2 + 1) / mp.gamma(power / 2 + mp.mpf(1.5)))
    lowest = math.inf
    for A in np.concatenate([np.geomspace(1e-16, 10, 4000), onset.A * np.linspace(0.99, 1.01, 201)]):
        h, h_A = -slope * A - of_power * A**power, -slope - power * of_power * A ** (power - 1)
        # of Omega over the resonance's: all of one size
        w = math.sqrt(-h_A)
        roots = np.roots([A, 0, (h + A * h_A + 4 * zeta**2 * A) / w**2, 2 * zeta * m / w**3, h * h_A / w**4]) * w
        for Omega in roots[np.abs(roots.imag) < 1e-9 * np.abs(roots)].real:
            if Omega > 0:
                lowest = min(lowest, math.hypot(A * Omega**2 + h, 2 * zeta * A * Omega + m))
    assert onset.kind == "cusp"
    assert onset.F_SN == pytest.approx(lowest, rel=1e-7)
    assert onset.F_SN - m == pytest.approx(lowest - m, rel=2e-3)
    several = made.many(c=slope, k=1.0, p=np.array([power, power]), mu=mu, zeta=zeta).saddle_node_onset()
    assert several.F_SN == pytest.approx(onset.F_SN, rel=1e-14)


@pytest.mark.slow
@pytest.mark.parametrize("compile", STIFF)
@pytest.mark.parametrize("zeta", [0.03, 0.1])
def test_preload_alone_has_the_onset_of_ever_softer_springs(zeta, compile):
    """h is constant up to the gap, where F_A vanishes at Omega = 0 whatever A is: the onset was unresolved."""
    pieces = [(c + p * u, gap), (c + p * u + k * (u - gap), None)]
    parameters = {"c": ABOVE_0, "p": {}, "k": ABOVE_0, "gap": ABOVE_0}
    made = derive.mechanism("preload_alone", pieces, parameters, compile=compile)
    found, softer = (made(c=0.01, k=2.0, gap=0.1, p=p, mu=0.01, zeta=zeta) for p in (0.0, 1e-9))
    onset, near = found.saddle_node_onset(), softer.saddle_node_onset()
    assert onset.kind == near.kind == "cusp" and onset.message == near.message
    assert onset.F_SN == pytest.approx(near.F_SN, rel=1e-7)
    below, above = (len(found.saddle_nodes(onset.F_SN * (1 + offset))) for offset in (-1e-5, 1e-5))
    assert above == below + 2
    (again,) = made.many(c=0.01, k=2.0, gap=0.1, p=np.zeros(1), mu=0.01, zeta=zeta).saddle_node_onset().F_SN
    assert again == pytest.approx(onset.F_SN, rel=1e-14)


@pytest.mark.slow
@pytest.mark.parametrize("compile", STIFF)
def test_peak_does_not_need_an_average_that_does_not_settle(compile):
    """A rod behind a gap, whose root is u but for what is lost in u^2 from |u| = 1e9 on."""
    rod = u + k * (u - gap) * (1 - c / sp.sqrt(c**2 + (u - gap) ** 2))
    made = derive.mechanism(
        "rod_gap", [(u, gap), (rod, None)], dict.fromkeys(("k", "gap", "c"), ABOVE_0), compile=compile
    )
    numbers = {"k": 9.0, "gap": 0.15, "c": 0.3}
    one = made(**numbers, **DAMPING)
    with pytest.raises(ArithmeticError, match="does not converge"):
        one.model.averaged(1e12)
    peak = one.peak(0.1)
    assert peak.message == "" and peak.A == max(one.saddle_nodes(0.1).A.max(), peak.A)
    found = made.many(**{**numbers, "k": np.array([9.0])}, **DAMPING).peak(0.1)
    assert found.A[0] == pytest.approx(peak.A, rel=1e-14)


@pytest.mark.slow
def test_quotients_that_cancel_at_rest_keep_their_digits():
    """Two magnets, as one would type them; and a quotient that is not odd, whose |u| is u."""
    pieces = {"magnets": u + k * (1 / (c - u) ** 2 - 1 / (c + u) ** 2), "one_sided": u + k / (c - u) - k / c}
    for name, force in pieces.items():
        one = derive.mechanism(name, [(force, None)], {"k": ABOVE_0, "c": ABOVE_0}, reach=0.9)(k=0.05, c=1.1, **DAMPING)
        exact = sp.lambdify(u, force.subs({k: sp.Rational(0.05), c: sp.Rational(1.1)}), "mpmath")
        for A in (1e-13, 1e-9, 1e-4, 0.5):
            with mp.workdps(40):
                average = mp.quad(lambda t, A=A, f=exact: f(A * mp.sin(t)) * mp.sin(t), [0, mp.pi / 2])
                assert one.model.averaged(A)[0] == pytest.approx(float(-4 / mp.pi * average), rel=1e-15)


@pytest.mark.slow
def test_answers_at_all_depths_agree():
    """The second approximation lies between averaging and the motion by SciPy."""
    one = oscillator("soft_stop")
    (A,) = one.amplitudes(Omega=0.9, F_0=0.1).A
    motion = one.steady_state(Omega=0.9, F_0=0.1)
    near = one.second_approximation.amplitudes(Omega=0.9, F_0=0.1)
    assert abs(near.A[0] / motion.A - 1) < abs(A / motion.A - 1) < 0.1
    assert "not measured" in str(one.amplitudes(Omega=0.9, F_0=0.1).validity)


@pytest.mark.slow
def test_stiffnesses_that_cancel_leave_what_rounding_allows():
    """Three springs without stiffness at rest: an error as of some roundings of the parameters."""
    pieces = [(u + 2 * k * u * (1 - c / sp.sqrt(1 + u**2)), None)]
    springs = derive.mechanism("three", pieces, {"k": ABOVE_0, "c": ABOVE_0}, reach=3)
    A, numbers = 1e-4, (1.0, 1.5)
    h, h_A, *_ = springs.record.averaged(A, *numbers)
    # 3/2 u^3 and beyond
    np.testing.assert_allclose(h, -9 / 8 * A**3, rtol=1e-7)
    np.testing.assert_allclose(h_A, -27 / 8 * A**2, rtol=1e-7)
    assert len(springs(k=1.0, c=1.5, **DAMPING).saddle_nodes(0.05)) == 2


@pytest.mark.slow
def test_what_it_is_and_how_it_is_derived_is_said():
    made = derived("soft_stop")
    assert repr(made).endswith("interpreted, by quadrature")
    text = made.document()
    assert text.count("$$") % 2 == 0
    assert r"\int_0^{\pi/2} f''(A \sin t) \sin^3 t" in text and "For $u_{1} < A$:" in text


@pytest.mark.slow
def test_derivation_of_a_contact_is_complete():
    document = derived("hertz").document()
    assert "sum_" not in document and r"\frac{(A - u_{1})^{2}}{\sqrt{A + u_{1}}} \int_0^1" in document
    assert (
        document.count(r"\Gamma_{1,3} &=") == 1 and r"excludes the fractional power that begins at $u_{1}$" in document
    )


@pytest.mark.slow
def test_parameter_names_may_be_those_of_printed_code():
    """Each name stands for the same number: what else is called so is kept apart."""
    as_k = derive.mechanism("named", [(k * sp.sin(u), None)], {"k": ABOVE_0}).record.averaged(0.7, 1.3)
    for name in ("L", "k_v", "sine", "np", "sum_0", "t0"):
        other = derive.mechanism("named", [(sp.Symbol(name) * sp.sin(u), None)], {name: ABOVE_0})
        assert other.record.averaged(0.7, 1.3) == as_k, name
    polynomial = derive.mechanism("named", [(sp.Symbol("L") * u + u**3, None)], {"L": ABOVE_0})
    assert polynomial(L=2.0, **DAMPING).force(0.5) == 2.0 * 0.5 + 0.5**3


def test_the_fold_locus_of_a_preload_passes_through_its_folds():
    """It begins at A = 0, where no frequency is known."""
    one = oscillator("preload")
    locus = one.fold_locus(A_max=2.5)
    folds = one.saddle_nodes(0.3)
    assert len(folds) == 2
    for Omega, A in zip(folds.Omega, folds.A, strict=True):
        near = np.argmin(np.hypot(locus.Omega - Omega, locus.A - A))
        assert locus.Omega[near] == pytest.approx(Omega, rel=5e-3)
        assert locus.A[near] == pytest.approx(A, rel=5e-3)
        assert locus.F_0[near] == pytest.approx(0.3, rel=1e-2)


@pytest.mark.slow
def test_a_piece_without_extent_says_nothing_of_the_rest():
    """With its gap closed a spring is linear, whatever it does in the gap; single and in a batch with open ones."""
    for name, inside in (("pushes", -u), ("pulls", u + 1 - u**3)):
        closing = derive.mechanism(name, [(inside, gap), (3 * u, None)], {"gap": {"least": 0, "below": 0.5}}, reach=2)
        for damping in (DAMPING, {"mu": 0.0, "zeta": 0.0}):
            one, linear = closing(gap=0.0, **damping), Duffing(3.0, 0.0, **damping)
            states, expected = (which.amplitudes(Omega=1.5, F_0=4.0) for which in (one, linear))
            assert states.A == pytest.approx(expected.A) and states.remarks == (0 if damping["zeta"] else Remark.CUT)
            onset = one.saddle_node_onset()
            assert (onset.F_SN, onset.remarks) == (None, 0) and not one.model.negative_stiffness
            many = closing.many(gap=[0.0, 0.1], **damping)
            assert many.amplitudes(Omega=1.5, F_0=4.0).A[0, 0] == pytest.approx(states.A[0])
            assert many.saddle_node_onset().status[0] == Status.NONE and many.margins(4.0).F_SN[0] == np.inf


def test_a_response_is_cut_at_the_reach():
    """A pendulum that is driven over the top has no steady state there; below it the response is whole."""
    pendulum = derive.mechanism(
        "to_the_top", [(k * sp.sin(u), None)], {"k": ABOVE_0}, reach=3.1, reach_reason="it stands on its head"
    )
    one = pendulum(k=1.3, **DAMPING)
    curve = one.frequency_response(0.2)
    assert "cut at A = 3.1, it stands on its head" in curve.message
    assert curve.A.max() <= 3.1
    assert one.peak(0.2).A is None
    assert one.frequency_response(0.05).message == ""
    assert one.peak(0.05).A < 3.1


@pytest.mark.parametrize("excitation", ["base", "unbalance"])
def test_a_base_response_below_the_reach_closes(excitation):
    """Of a linear spring of one's own, whose peak Y/(2 zeta sqrt(1 - zeta^2)) has a closed form."""
    zeta, Y = 0.04, 0.12
    A = Y / (2 * zeta * np.sqrt(1 - zeta**2))
    for fraction in (0.5, 0.95, 1.05):
        spring = derive.mechanism(f"linear_{round(100 * fraction)}", [(lambda u: u, None)], {}, reach=A / fraction)
        one = spring(zeta=zeta, excitation=excitation)
        closes = fraction < 1
        assert one.closes(Y) == closes and one.peak(Y).message.startswith("cut at") != closes
        assert one.peak(Y).A == (pytest.approx(A, rel=1e-9) if closes else None)
        # from sqrt(2) times its natural frequency on a linear spring transmits less
        assert one.isolation(Y).Omega == pytest.approx(np.sqrt(2), rel=1e-9)
        assert one.isolation(Y).message.startswith("cut at") != closes
        many = spring.many(zeta=[zeta], excitation=excitation)
        assert many.isolation(Y).Omega[0] == one.isolation(Y).Omega


def test_folds_beyond_the_reach_are_said_to_be_cut():
    """The lower fold of this hardening spring is at A = 0.589."""
    below, above = (
        derive.mechanism(f"hardens_{round(10 * reach)}", [(lambda u: u + u**3, None)], {}, reach=reach)
        for reach in (0.5, 1.5)
    )
    expected = Duffing(1.0, 1.0, zeta=0.04).saddle_nodes(0.3)
    for spring, known in ((below, 0), (above, 1)):
        found = spring(zeta=0.04).saddle_nodes(0.3)
        np.testing.assert_allclose(found.A, expected.A[:known], rtol=1e-9)
        assert "cut at A" in found.message and found.remarks == Remark.CUT
        assert spring.many(zeta=[0.04]).saddle_nodes(0.3).remarks == [Remark.CUT]


def test_a_reach_without_a_reason_is_where_the_force_ends():
    u = sp.Symbol("u")
    one = derive.mechanism("ends", [(sp.sinh(u), None)], {}, reach=0.5)(zeta=0.04)
    assert one.saddle_nodes(0.3).message == "cut at A = 0.5, the force is valid up to there only"


@pytest.mark.parametrize("compiled", [False, *slow(True)])
def test_it_is_told_whether_the_response_to_a_force_closes(compiled):
    """A force that gives way: the response closes where a peak ends it below the reach, and not where none does."""
    stated = f"gives_way_{compiled}", [(k * sp.sin(u), None)], {"k": ABOVE_0}
    one = derive.mechanism(*stated, reach=3.1, compile=compiled)(k=1.3, **DAMPING)
    for F_0 in (0.05, 0.2):
        assert one.closes(F_0) == (one.peak(F_0).A is not None) == (one.frequency_response(F_0).message == "")
    assert one.closes(0.5 * one.sticking_forcing)
    endless = derive.mechanism(*stated, compile=compiled)(k=1.3, **DAMPING)
    assert not endless.closes(0.2)


@pytest.fixture(scope="module")
def preloaded():
    """A preload on a linear spring, whose folds have a closed form."""
    return derive.mechanism("preloaded", [(c + k * u, None)], {"c": ABOVE_0, "k": ABOVE_0})


@pytest.mark.slow
@pytest.mark.parametrize("fraction", [0.3, 0.8, 0.99])
@pytest.mark.parametrize("mu", [0.0, 0.01])
def test_preloaded_linear_spring_has_the_fold_of_closed_form(preloaded, mu, fraction):
    """With p = 4c/pi, a = Omega^2 - 1, b = 2 zeta Omega F is quadratic in A; with tan t = b/a its discriminant vanishes
    where m cos t + p sin t = F_0, for which m < F_0 < sqrt(m^2 + p^2) have one t with a positive double root.
    """
    zeta, m, p_ = 0.02, 4 * mp.mpf(mu) / mp.pi, 4 * mp.mpf("0.05") / mp.pi
    one = preloaded(c=0.05, k=1.0, mu=mu, zeta=zeta)
    level = mp.hypot(m, p_)
    F_0 = float(m + fraction * (level - m))
    t = mp.findroot(lambda t: m * mp.cos(t) + p_ * mp.sin(t) - F_0, (0, mp.atan2(p_, m)), solver="anderson", tol=1e-30)
    Omega = (zeta + mp.hypot(zeta, mp.tan(t))) / mp.tan(t)
    a, b = Omega**2 - 1, 2 * zeta * Omega
    folds = one.saddle_nodes(F_0)
    assert folds.Omega == pytest.approx([float(Omega)], rel=1e-12)
    assert folds.A == pytest.approx([float((p_ * a - b * m) / (a**2 + b**2))], rel=1e-9)
    assert not len(one.saddle_nodes(1.01 * float(level)))
    assert one.saddle_node_onset().F_SN is None and "no lowest forcing" in one.saddle_node_onset().message


def test_holding_force_is_the_derived_level_at_no_amplitude():
    """Of any frequency, and of numbers whose squares are beyond doubles too."""
    m, preload, Omega = np.random.default_rng(1).uniform(0.001, 1.0, (3, 1000))
    found = break_loose(m, preload)
    np.testing.assert_array_max_ulp(found, slow_flow.level(Omega, 0.0, m, 0.02, -preload), 2)
    np.testing.assert_array_equal(break_loose(m * 2.0**-700, preload * 2.0**-700), found * 2.0**-700)
    np.testing.assert_array_equal(break_loose(m, -preload), m)
    assert [float(break_loose(*pair)) for pair in zip(m, preload, strict=True)] == found.tolist()


@pytest.mark.slow
def test_mass_held_by_a_preload_is_said_beside_the_motions(preloaded):
    """Next to rest a state has R = -4c/pi and I = 4 mu/pi: below that level no state starts from rest."""
    one = preloaded(c=0.05, k=1.0, mu=0.01, zeta=0.02)
    level = 4 / np.pi * np.hypot(0.05, 0.01)
    assert one.sticking_forcing == pytest.approx(level, rel=1e-15)
    many = preloaded.many(c=0.05, k=1.0, mu=0.01, zeta=0.02)
    for F_0, sticks in ((0.999 * level, True), (1.001 * level, False)):
        states = one.amplitudes(Omega=0.6, F_0=F_0)
        assert bool(states.A.any()) != sticks  # below resonance the mass moves where it is not held, and there only
        assert one.margins(F_0).sticks == sticks == bool(many.margins(F_0).sticks)
        assert (Remark.HELD_AT_REST in states.remarks) == sticks == ("a mass at rest stays there" in states.message)
        assert many.amplitudes(Omega=0.6, F_0=F_0).remarks == states.remarks
        band = one.hysteresis(F_0)
        assert len(band) == sticks == int(many.hysteresis(F_0).count)
        assert not sticks or (band[0].Omega_low, *band[0][1:]) == (one.saddle_nodes(F_0).Omega[0], np.inf, 2)
        row = one.spectrum(Omega=[0.6, 1.1], F_0=F_0)
        assert row.sticks.tolist() == [sticks, False]
    # at high frequencies the amplitude vanishes, and friction and preload are passed on
    assert one.amplitudes(Omega=1e4, F_0=0.2).transmissibility[-1] == pytest.approx(level / 0.2, rel=1e-4)
    assert one.transmissibility_floor(0.2) == pytest.approx(level / 0.2, rel=1e-15)


@pytest.mark.slow
@pytest.mark.parametrize("compiled", [False, True])
def test_small_motions_with_a_preload_are_not_missed(compiled):
    """Where h is not 0 at rest h/A has no bound: without friction the peak is a root of (k - zeta^2) A^2 + 4c/pi A =
    (F_0/(2 zeta))^2; a preload that pushes outwards balances the spring at A = -4c/(pi k), from where folds begin.
    """
    made = derive.mechanism(f"pushed_{compiled}", [(c + k * u, None)], {"c": {}, "k": ABOVE_0}, compile=compiled)
    for p_, zeta, F_0 in ((0.01, 0.2, 0.002), (0.05, 0.05, 1e-4), (0.1, 0.5, 0.03), (0.001, 0.02, 0.02)):
        one = made(c=math.pi / 4 * p_, k=1.0, zeta=zeta)
        square = (F_0 / (2 * zeta)) ** 2
        A = 2 * square / (p_ + math.sqrt(p_**2 + 4 * (1 - zeta**2) * square))
        peak = one.peak(F_0)
        assert peak.A == pytest.approx(A, rel=1e-12)
        assert peak.Omega == pytest.approx(math.sqrt(1 + p_ / A - 2 * zeta**2), rel=1e-9)
        # (a^2 - 1)^2 A^2 - 2 p (a^2 - 1) A + p^2 + b^2 A^2 = F_0^2
        a, b = 1.1 * peak.Omega, 2 * zeta * 1.1 * peak.Omega
        roots = np.roots([(a * a - 1) ** 2 + b * b, -2 * p_ * (a * a - 1), p_**2 - F_0**2])
        roots = np.sort(roots[(roots.imag == 0) & (roots.real > 0)].real)
        states = one.amplitudes(Omega=a, F_0=F_0)
        assert states.A[states.A > 0] == pytest.approx(roots, rel=1e-9)  # beside a mass that is held
    outward = made(c=-0.006, k=1.0, mu=0.004, zeta=0.04).saddle_node_onset()
    assert outward.F_SN is None and Remark.FOLDS_AT_REST in outward.remarks
    assert f"from F_0 = {4 * 0.004 / math.pi:g} on" in outward.message


@pytest.mark.slow
def test_within_a_play_no_mean_is_singled_out_and_that_is_said():
    """There u = B + F_0/(Omega sqrt(Omega^2 + 4 zeta^2)) cos(...) is a motion for every B that keeps u in the gap."""
    loose = derive.mechanism("a_play", [(0, gap), (k * (u - gap), None)], {"k": ABOVE_0, "gap": ABOVE_0})
    Omega, F_0, zeta = 0.6, 0.05, 0.1
    one = loose(k=2.0, gap=1.0, zeta=zeta)
    A = F_0 / (Omega * np.hypot(Omega, 2 * zeta))
    with pytest.raises(ArithmeticError, match=f"amplitude {A:.6g} stays within .* no force restores its mean"):
        one.steady_state(Omega=Omega, F_0=F_0)
    assert one.steady_state(Omega=Omega, F_0=F_0, A=A).A == pytest.approx(A, rel=1e-12)
    # u' + 2 zeta u = F_0 sin(Omega tau)/Omega from rest on, and goes on so where the frequency steps: its mean is 0
    swept = one.sweep(Omega=[Omega, 0.7], F_0=F_0)
    assert swept.settled.all()
    assert swept.A == pytest.approx([A, F_0 / (0.7 * np.hypot(0.7, 2 * zeta))], rel=1e-7)


@pytest.mark.parametrize("excitation", ["force", "unbalance"])
def test_without_a_spring_no_mean_is_singled_out_either(excitation):
    """It was an IndexError: there is no breakpoint that the words could name."""
    free, Omega, F_0, zeta = Duffing(0.0, 0.0, zeta=0.1, excitation=excitation), 0.9, 0.05, 0.1
    A = F_0 * (1.0 if excitation == "force" else Omega**2) / (Omega * np.hypot(Omega, 2 * zeta))
    for ask in (free.steady_state, lambda Omega, F_0: free.exact_response(F_0, Omega=(Omega, 1.1))):
        with pytest.raises(ArithmeticError, match=f"amplitude {A:.6g} stays where no force restores its mean"):
            ask(Omega=Omega, F_0=F_0)
    assert free.steady_state(Omega=Omega, F_0=F_0, A=A).A == pytest.approx(A, rel=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("compiled", [False, True])
def test_ends_that_do_not_rise_are_refused(compiled):
    """The second stop inside the first, both at one place, and a gap below 0: no piece lies there."""
    stops = derive.mechanism(
        f"two_stops_{compiled}", [(u, gap - k), (2 * u, c), (3 * u, None)], dict.fromkeys(("gap", "k", "c"), ABOVE_0),
        compile=compiled,
    )  # fmt: skip
    for numbers in (
        {"gap": 2.5, "k": 0.5, "c": 1.0},
        {"gap": 2.5, "k": 1.5, "c": 1.0},
        {"gap": 1.0, "k": 2.0, "c": 3.0},
    ):
        end = numbers["gap"] - numbers["k"]
        with pytest.raises(
            ValueError, match=rf"gap = .*: not allowed together, .* end at \|u\| = {end:g}, .* must be ascending"
        ):
            stops(**numbers, zeta=0.02)
        assert stops.many(**numbers, mu=0.0, zeta=0.02).saddle_node_onset().status == Status.INVALID
    assert stops(gap=1.0, k=0.5, c=1.0, zeta=0.02).breakpoints == (0.5, 1.0)
    assert stops(gap=1.0, k=1.0, c=1.0, zeta=0.02).breakpoints == (1.0,)


def test_missing_breakpoint_is_refused_by_its_piece():
    end = sp.sqrt(gap - c)
    made = derive.mechanism(
        "lost_end", [(u, end), (u + k * (u - end), None)], dict.fromkeys(("gap", "k", "c"), ABOVE_0)
    )
    assert made(gap=0.5, k=2.0, c=0.25, zeta=0.02).breakpoints == (0.5,)
    with pytest.raises(
        ValueError, match=r"gap = 0\.1, .*: not allowed together, there is no real u at which piece 1 .* ends"
    ):
        made(gap=0.1, k=2.0, c=0.25, zeta=0.02)


@pytest.mark.slow
def test_compiled_solvers_know_the_onset_of_a_preload(preloaded):
    """Of a linear spring folds come down to 4 mu/pi; of a hardening one next to a cusp; without zeta k passes 0."""
    numbers = {"c": ABOVE_0, "k": ABOVE_0}
    for pieces in ([(c + k * u, None)], [(c + u + k * u**3, None)]):
        both = [derive.mechanism(f"c{one}", pieces, numbers, compile=one) for one in (False, True)]
        for damping in ({"mu": 0.01, "zeta": 0.02}, {"zeta": 0.0133}):
            plain, compiled = (made(c=0.0077, k=1.883, **damping).saddle_node_onset() for made in both)
            assert plain.message == compiled.message and plain.remarks == compiled.remarks == Remark.FOLDS_AT_REST
            assert (plain.F_SN or 0) == pytest.approx(compiled.F_SN or 0, rel=1e-14)
            many = [made.many(c=0.0077, k=1.883, **{"mu": 0.0} | damping).saddle_node_onset() for made in both]
            assert many[0].at_rest == many[1].at_rest == 1 and many[0].status == many[1].status
        states = [made(c=0.0077, k=1.883, zeta=0.02).amplitudes(Omega=0.5, F_0=0.005) for made in both]
        assert all(one.A.tolist() == [0.0] for one in states)
    for made in both:
        assert "no lowest forcing: without viscous damping" in made(c=0.0077, k=1.883).saddle_node_onset().message
    with pytest.raises(ArithmeticError, match="with a preload, and without viscous damping"):
        preloaded(c=0.05, k=1.0).saddle_node_onset()


@pytest.mark.slow
def test_where_a_hyperbolic_tangent_saturates_nothing_cancels():
    """1 - tanh^2 in its derivatives is 1/cosh^2: as a difference it kept sums from settling at all at A = 3."""
    pad = derive.mechanism("saturates", [(c * u + k * sp.tanh(3 * u), None)], {"k": {}, "c": ABOVE_0})
    found = pad(k=0.99, c=1.41).model.averaged(3.0)
    with mp.workdps(30):
        force = lambda x: mp.mpf(1.41) * x + mp.mpf(0.99) * mp.tanh(3 * x)  # noqa: E731
        for order, value in enumerate(found):
            exact = mp.quad(
                lambda t, n=order: mp.diff(force, 3 * mp.sin(t), n) * mp.sin(t) ** (n + 1),
                [0, 0.05, 0.1, 0.2, 0.4, 0.8, mp.pi / 2],
            )
            assert float(value) == pytest.approx(float(-4 / mp.pi * exact), rel=1e-13)


@pytest.mark.parametrize(
    ("force", "value"),
    [
        (sp.exp(u) - 1, mp.expm1),
        (sp.log(1 + u), mp.log1p),
        (sp.sqrt(1 + u) - 1, lambda x: mp.sqrt(1 + x) - 1),
        (sp.cosh(u) - 1, lambda x: mp.cosh(x) - 1),
    ],
    ids=["exp(u) - 1", "log(1 + u)", "sqrt(1 + u) - 1", "cosh(u) - 1"],
)
def test_force_that_cancels_at_rest_keeps_its_digits(force, value):
    """exp(u) - 1 for u > 0, and the like: as a difference no sum settled next to rest, and no question was answered."""
    made = derive.mechanism("cancels", [(k * force, None)], {"k": ABOVE_0}, reach=5, reach_reason="it is no longer")
    one = made(k=1.0, mu=0.01, zeta=0.05)
    with mp.workdps(40):
        for A in (2.0**-40, 2.0**-10, 0.7):
            h = -4 / mp.pi * mp.quad(lambda t, A=A: value(A * mp.sin(t)) * mp.sin(t), [0, mp.pi / 2])
            assert float(one.model.averaged(A)[0]) == pytest.approx(float(h), rel=1e-14)
    assert len(one.amplitudes(Omega=0.9, F_0=0.05)) == 1


@pytest.mark.slow
@pytest.mark.parametrize("compile", [False, True])
def test_a_logarithmic_spring_holds_motions_of_any_size(compile):
    """c u + k log(1 + u): far out the logarithm lost its digits, or was infinite, and no amplitude was a bound."""
    made = derive.mechanism(
        "logarithmic", [(c * u + k * sp.log(1 + u), None)], {"c": ABOVE_0, "k": ABOVE_0}, compile=compile
    )
    one = made(c=0.2, k=1.2, **DAMPING)
    with mp.workdps(40):
        soft, stiff = mp.mpf(0.2), mp.mpf(1.2)
        for A in (1e-6, 1.0, 1e4, 1e8, 1e20, 1e100):
            at = [0, *sorted(mp.mpf(10) ** n / A for n in range(-3, 101, 3) if 10.0**n < A), mp.pi / 2]
            bend = mp.quad(lambda t, A=A: mp.log1p(A * mp.sin(t)) * mp.sin(t), at)
            h = -soft * A - 4 * stiff / mp.pi * bend
            assert float(one.model.averaged(A)[0]) == pytest.approx(float(h), rel=1e-14)
    assert [fold.kind for fold in one.saddle_nodes(0.1)] == ["jump-down", "jump-up"]
    assert one.saddle_node_onset().kind == "cusp"


@pytest.mark.parametrize("force", [sp.sin(u), sp.tan(u)], ids=str)
def test_force_that_cannot_hold_any_motion_needs_a_reach(force):
    stated = "endless", [(k * force, None)], {"k": ABOVE_0}
    with pytest.raises(OverflowError, match=r"does not bound motions of any size.*`reach`, a number > 0"):
        derive.mechanism(*stated)(k=1.0, zeta=0.05).saddle_nodes(0.05)
    assert derive.mechanism(*stated, reach=1.5)(k=1.0, zeta=0.05).saddle_node_onset().kind == "cusp"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("force", "fits", "reaches", "place"),
    [
        (sp.tan(k * u), 1.5, 2.0, math.pi / 4),
        (sp.asin(k * u), 0.9, 2.0, 0.5),
        (u * sp.sqrt(1 - k * u), 0.9, 1.25, 0.8),
        (u + (1 / (k - u) ** 2 - 1 / (k + u) ** 2) / 20, 1.1, 0.5, 0.5),
    ],
    ids=["tan", "asin", "root", "magnets"],
)
def test_force_not_finite_within_its_reach_is_refused(force, fits, reaches, place):
    """It was built, and every question ended in a sum that does not settle."""
    made = derive.mechanism("ends_early", [(force, None)], {"k": ABOVE_0}, reach=1)
    assert made(k=fits, **DAMPING).saddle_nodes(0.05).F_0 == 0.05
    with pytest.raises(ValueError, match=rf"k = {reaches}: not allowed.* at \|u\| = {place:.6g}, within its reach 1"):
        made(k=reaches, **DAMPING)
    many = made.many(k=np.array([fits, reaches]), **DAMPING).saddle_nodes(0.05)
    assert many.status.tolist() == [Status.OK, Status.INVALID]


def test_nothing_is_asked_beyond_the_reach():
    """u/(1 - u), infinite at 1: whether it is linear was asked there."""
    made = derive.mechanism("pole", [(k * u / (1 - u), None)], {"k": ABOVE_0}, reach=0.95)
    assert made(k=1.0, mu=0.01, zeta=0.05).saddle_node_onset().kind == "cusp"


def test_motions_without_finite_stiffness_at_rest_are_refused():
    root = derive.mechanism("root", [(k * sp.sqrt(u), None)], {"k": ABOVE_0})(k=1.0, zeta=0.05)
    with pytest.raises(ValueError, match="its stiffness is infinite at u = 0"):
        root.steady_state(Omega=0.6, F_0=0.05)


@pytest.mark.parametrize(
    ("slope", "power", "zeta"), [(1.0, 1.5, 0.03), (1.0, 1.2, 0.03), (0.01, 1.5, 0.2), (0.0, 1.5, 0.03)]
)
def test_an_onset_is_found_where_h_bends_without_bound_at_rest(slope, power, zeta):
    """It satisfies F = F_A = F_AA = 0, and two folds are born there; also where damping outweighs the slope at rest."""
    made = derive.mechanism("bends", [(c * u + k * u**p, None)], {"c": {}, "k": ABOVE_0, "p": ABOVE_0})
    one = made(c=slope, k=0.5, p=power, mu=0.01, zeta=zeta)
    onset = one.saddle_node_onset()
    h, h_A, h_AA, _ = one.model.averaged(onset.A)
    R, X, T = onset.A * onset.Omega**2 + h, onset.Omega**2, onset.Omega**2 + h_A
    sine = 2 * one.zeta * onset.A * onset.Omega + one.model.m
    assert np.hypot(R, sine) == pytest.approx(onset.F_SN, rel=1e-12)
    assert R * T + 2 * one.zeta * onset.Omega * sine == pytest.approx(0, abs=1e-12)
    assert T**2 + R * h_AA + 4 * one.zeta**2 * X == pytest.approx(0, abs=1e-11)
    assert [len(one.saddle_nodes(onset.F_SN * factor)) for factor in (1 - 1e-6, 1 + 1e-6)] == [0, 2]


def test_far_out_an_enclosure_narrows_as_what_it_encloses():
    """1 - tanh takes (4/pi) pi^2/24/(k A)^2 off h, to the order of A^-4; cosh in its derivatives exceeds doubles."""
    stiffness, A = 3.0, 2.0 ** np.array([7, 13])
    model = derived("saturating")(k=stiffness, **DAMPING).model
    scaled = []
    for at in A:
        scaled.append(bent(backend.record_of(model.mechanism), model, at, 1.001 * at)[1] * at**6)
        assert scaled[-1][0] < 20 * np.pi / stiffness**2 < scaled[-1][1]
    np.testing.assert_allclose(*scaled, rtol=0.01)
