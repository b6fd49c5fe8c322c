"""Isolators in newtons, metres and hertz: against (1), (2) in SI units, the paper's (4), and a mount's data sheet."""

from __future__ import annotations

import dataclasses
import math
import pickle
import re

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

from slowflow import Duffing, Isolator
from slowflow.answers import results
from slowflow.answers.answer import SHOWN
from slowflow.answers.quantities import EXCITED, PER_MOUNT, UNITS, Scales, in_shown
from slowflow.answers.table import COLUMNS
from slowflow.averaged import checks
from slowflow.oscillators.range_checks import Implausible
from slowflow.sizing import fit, meet, tolerances
from slowflow.support.errors import SlowflowError
from slowflow.support.text import Sentence
from slowflow_kernels.scaling import SCALES
from tests.files import MOUNT, ROOT
from tests.sampling import slow

LETTER = {excitation: letter for excitation, (letter, _) in EXCITED.items()}


@pytest.fixture(scope="module")
def mount():
    return Isolator.physical(**MOUNT)


def test_mount_jumps_detaches_and_transmits_as_by_hand(mount):
    onset, detachment, folds = mount.saddle_node_onset(), mount.detachment(), mount.saddle_nodes(F=5)
    assert (round(onset.F_SN, 2), round(onset.f, 2), round(detachment.F_cr, 2)) == (2.67, 2.11, 4.08)
    assert [(fold.kind, round(fold.f, 2)) for fold in folds] == [("jump-up", 2.18), ("jump-down", 2.28)]
    (state,) = mount.amplitudes(f=5, F=5)
    assert round(state.transmissibility_dB, 1) == -12.8


def test_the_readme_says_the_same_of_it():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    (lines,) = re.findall(r"mount = Isolator\.physical.*?```", text, re.DOTALL)
    for number in ("2.67 N", "2.11 Hz", "4.08 N", "2.18", "2.28 Hz", "-12.8 dB"):
        assert number in lines, number


def test_scales_are_the_papers_groups():
    """(4), typed."""
    m, k_v, L = 7.0, 300.0, 0.11
    scales = Scales(m=m, k_v=k_v, L=L)
    expected = {
        "u": L,
        "tau": math.sqrt(m / k_v),
        "Omega": math.sqrt(k_v / m),
        "F_0": k_v * L,
        "mu": k_v * L,
        "zeta": 2 * math.sqrt(k_v * m),
        "c_2": m / L,
        "c_3": math.sqrt(m**3 / k_v) / L**2,
        "zeta_2": 2 * math.sqrt(k_v * m) / L**2,
        "eta": 1.0,
    }
    assert {name: scales.of(scale) for name, scale in SCALES.items()} == pytest.approx(expected, rel=1e-15)


def test_a_mount_with_every_law_of_damping_balances_in_newtons():
    """The first harmonic of (1) with the force (2) and each law's own, in SI units, by quadrature of one cycle."""
    laws = {"eta": 0.03, "c_2": 25.0, "c_3": 20.0, "c_xx": 900.0, "contact": "attached"}
    mount = Isolator.physical(**MOUNT, **laws, force="untruncated")
    m, k_v, L, preload = (MOUNT[name] for name in ("m", "k_v", "L", "preload"))
    F, f = 25.0, 2.1
    omega, c, found = math.tau * f, 2 * 0.02 * math.sqrt(k_v * m), mount.amplitudes(f=f, F=F)
    x_cr = math.sqrt(preload * (2 * L - preload))
    assert (found.A > x_cr).any() and (mount.amplitudes(f=5, F=5).A < x_cr).all()

    def left(theta, A):
        x, v = A * math.cos(theta), -A * omega * math.sin(theta)
        height = math.sqrt(L**2 - x**2)
        pushing = max(preload - (L - height), 0.0)
        friction = 0.4 * math.copysign(1.0, v) if abs(x) < x_cr else 0.0
        force = k_v * x - 3 * 1700 * pushing * x / height
        viscous = c + laws["eta"] * k_v / omega + laws["c_xx"] * x**2 + laws["c_2"] * abs(v) + laws["c_3"] * v**2
        return -m * omega**2 * x + viscous * v + friction + force

    for A, phi in zip(found.A, found.phi, strict=True):
        edge = math.acos(min(1.0, x_cr / A))
        breakpoints = {"points": [edge, math.pi - edge]} if A > x_cr else {}
        # over half a cycle, as the force is odd; F cos(omega t) is F cos(theta - phi)
        for part, pushed in ((math.cos, math.cos(phi)), (math.sin, math.sin(phi))):
            integral = quad(lambda theta, A=A, part=part: left(theta, A) * part(theta), 0, math.pi, **breakpoints)[0]
            assert integral * 2 / math.pi == pytest.approx(F * pushed, rel=1e-9, abs=1e-9 * F)


@pytest.mark.slow
def test_laws_of_damping_are_those_of_the_mount(mount):
    pint = pytest.importorskip("pint")
    u = pint.UnitRegistry()
    laws = {"eta": 0.03, "c_2": 30.0, "contact": "attached"}
    damped = mount.replace(**laws)
    assert (
        damped == Isolator.physical(**MOUNT, **laws) != mount
        and damped.replace(eta=0, c_2=0, contact="throughout") == mount
    )
    assert eval(repr(damped), {"Isolator": Isolator}) == damped and "c_2=30.0" in repr(damped)
    assert repr(mount.replace(eta=0.0)) == repr(mount)
    of_pint = mount.replace(c_2=u.Quantity(0.3, "N*s^2/cm/m"))
    assert of_pint.oscillator.c_2 == pytest.approx(damped.oscillator.c_2, rel=1e-15)
    assert "c_2 = 30 N s^2/m^2" in str(damped.explain("peak", 5))
    shaken = damped.replace(excitation="base")
    assert (shaken.oscillator.c_2, shaken.oscillator.eta) == (damped.oscillator.c_2, damped.oscillator.eta)
    assert shaken.peak(0.002).A == pytest.approx(shaken.oscillator.peak(0.002 / 0.08).A * 0.08, rel=1e-14)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("excitation", "amplitude", "friction", "f"),
    [
        ("force", 40.0, 0.4, 2.0),
        ("base", 0.015, 0.0, 2.2),
        ("unbalance", 0.18, 0.0, 2.2),
        ("acceleration", 2.9, 0.4, 2.2),
    ],
)
def test_a_motion_is_that_of_the_dimensional_equation(excitation, amplitude, friction, f):
    """(1) with the force (2), in SI units, by SciPy: nothing dimensionless.

    Absolute motion over a moving base; rotating unbalance by the force of its radius.
    """
    m, k_v, k_h, n, L, preload, c = 12.0, 2500.0, 1700.0, 3, 0.080, 0.009, 60.0
    parameters = {"m": m, "k_v": k_v, "k_h": k_h, "n": n, "L": L, "preload": preload, "c": c, "friction": friction}
    mount = Isolator.physical(**parameters, force="untruncated", excitation=excitation)
    omega = math.tau * f
    floor = {"base": amplitude, "acceleration": amplitude / omega**2}.get(excitation, 0.0)
    push = {"force": amplitude, "unbalance": amplitude * omega**2}.get(excitation, 0.0)
    excited = {LETTER[excitation]: amplitude}

    def rates(t, state):
        x, v = state  # of the mass, as seen by who stands still
        z, w = x - floor * math.cos(omega * t), v + floor * omega * math.sin(omega * t)
        height = math.sqrt(L**2 - z**2)
        pushing = max(preload - (L - height), 0.0)
        resists = c * w + friction * np.sign(w)
        return v, (push * math.cos(omega * t) - resists - k_v * z + n * k_h * pushing * z / height) / m

    periods = 20 if friction else 40
    t = np.linspace(periods - 1, periods, 400, endpoint=False) / f
    near = {"rtol": 1e-8, "atol": 1e-10} if friction else {"rtol": 1e-9, "atol": 1e-11}
    x = solve_ivp(rates, (0, periods / f), (floor, 0.0), t_eval=t, **near).y[0]
    deflection = x - floor * np.cos(omega * t)
    motion = mount.steady_state(f=f, **excited)
    assert np.abs(deflection).max() > mount.at_rest().x_cr  # the springs detach
    np.testing.assert_allclose(motion.x, deflection, atol=(2e-6 if friction else 3e-6) * motion.A)
    assert motion.t[-1] == pytest.approx(t[-1] - t[0]) and motion.period == pytest.approx(1 / f)
    # averaging has the deflection, and of a base the motion over the floor's as transmissibility
    (state,) = mount.amplitudes(f=f, **excited)
    first = 2 * np.mean(deflection * np.exp(-1j * omega * t))
    assert abs(first) == pytest.approx(state.A, rel=2e-3)
    if floor:
        transmissibility = abs(2 * np.mean(x * np.exp(-1j * omega * t))) / floor
        assert 10 ** (state.transmissibility_dB / 20) == pytest.approx(transmissibility, rel=5e-3)


def test_an_amplitude_is_called_and_measured_by_what_is_excited():
    by_base, by_unbalance = (
        Isolator.physical(**{**MOUNT, "zeta": 0.05, "excitation": word}) for word in ("base", "unbalance")
    )
    iso = by_base.oscillator
    assert iso.excitation == "base" and by_base.saddle_node_onset().units["Y_SN"] == "m"
    assert by_base.saddle_node_onset().Y_SN == iso.saddle_node_onset().F_SN * 0.080
    assert by_unbalance.detachment().U_cr == pytest.approx(iso.detachment().F_cr * 12 * 0.080, rel=1e-15)
    assert by_base.peak(0.002).in_units().Y == 2.0 and by_unbalance.margins(0.03).units["U"] == "kg m"
    assert by_base.saddle_nodes(0.002).message == "no saddle node at Y = 2 mm: the response is single-valued"
    assert str(by_unbalance.explain("peak", 0.03)).startswith("peak at U = 0.03 kg m")
    assert by_base.steady_state(f=5, Y=0.002).Y == 0.002
    with pytest.raises(ValueError, match="Y = -1"):
        by_base.peak(-1)
    with pytest.raises(ValueError, match="excitation = 'floor' is not allowed"):
        Isolator.physical(**{**MOUNT, "excitation": "floor"})


@pytest.mark.parametrize("excitation", ["force", "acceleration"])
def test_several_mounts_share_the_mass_and_add_springs(excitation):
    laws = {"c_2": 3.0, "c_3": 2.0, "c_xx": 400.0, "eta": 0.01, "static_friction": 0.6}
    one = Isolator.physical(**MOUNT, **laws, excitation=excitation)
    sheet = {**MOUNT, **laws} | {name: MOUNT[name] / 4 for name in ("k_v", "k_h", "friction")}
    sheet |= {name: laws[name] / 4 for name in laws if name != "eta"}
    four = Isolator.physical(**sheet, mounts=4, excitation=excitation)
    assert four.oscillator == one.oscillator and four.scales.sizes == one.scales.sizes
    assert four.peak(0.7) == one.peak(0.7) and four.replace(zeta=0.03).given["mounts"] == 4
    # the same as a mount that has its share of mass and force, and of everything
    quarter = Isolator.physical(**{**sheet, "m": MOUNT["m"] / 4}, excitation=excitation)
    assert quarter.peak(0.7 / 4 if excitation == "force" else 0.7).A == pytest.approx(one.peak(0.7).A, rel=1e-12)
    assert four.at_rest().preset == pytest.approx(quarter.at_rest().preset, rel=1e-14)
    # what each number of one of them moves
    slopes, whole = four.peak(0.7).gradient(), one.peak(0.7).gradient()
    for name in slopes.by:
        times = 4 if name in PER_MOUNT else 1
        assert slopes["A", name] == pytest.approx(times * whole["A", name], rel=1e-12), name
        step = 1e-4 * four.given.get(name, 0.7)
        if name not in ("n", LETTER[excitation]):
            ends = [four.replace(**{name: four.given[name] + k * step}).peak(0.7).A for k in (-1, 1)]
            assert slopes["A", name] == pytest.approx((ends[1] - ends[0]) / (2 * step), rel=1e-4), name
    found = tolerances(four, {"k_v": 0.05, "friction": 0.1}, answers=["f_rest"], samples=3)
    again = four.replace(**{name: values[1] for name, values in found.drawn.items()})
    assert found.samples["f_rest"][1] == pytest.approx(again.at_rest().f_0, rel=1e-12)
    with pytest.raises(ValueError, match="mounts = 0 is not allowed"):
        four.replace(mounts=0)
    sheet.pop("static_friction", None)
    for count in (0, 2.5, [1, 2]):
        with pytest.raises(ValueError, match=r"mounts = .* must be an integer >= 1"):
            Isolator.physical(**sheet).many(m=[1.0, 2.0], mounts=count)


@pytest.mark.parametrize("load", [None, *slow(12.2)])
def test_a_base_is_given_by_its_acceleration_in_every_question(load):
    by_base, by_a = (Isolator.physical(**MOUNT, load=load, excitation=one) for one in ("base", "acceleration"))
    a, f = 0.5, np.array([1.8, 2.4, 6.0])
    Y = a / (math.tau * f) ** 2  # at a frequency it is this displacement
    for question in ("amplitudes", "spectrum"):
        at, of_Y = (getattr(by_base, question)(f=f, **one) for one in ({"a": a}, {"Y": Y}))
        assert at == getattr(by_a, question)(f=f, a=a) and at.units["a"] == "m/s^2"
        np.testing.assert_allclose(at.A, of_Y.A, rtol=1e-10)
        np.testing.assert_allclose(at.transmissibility_dB, of_Y.transmissibility_dB, atol=1e-9)
    # over all frequencies it is a force m a
    pushed, m = by_base.replace(excitation="force"), by_base.scales.m
    assert by_base.peak(a=a).A == pytest.approx(pushed.peak(m * a).A, rel=1e-12)
    assert by_base.peak(a=a).a == a and by_base.peak(0.002) == by_a.peak(Y=0.002)
    assert by_a.saddle_node_onset().a_SN == pytest.approx(pushed.saddle_node_onset().F_SN / m, rel=1e-12)
    motion = by_base.steady_state(f=2.4, a=a)
    assert motion.A == pytest.approx(by_base.steady_state(f=2.4, Y=Y[1]).A, rel=1e-9) and motion.a == a
    for named in ({"F": 0.5}, {"a": 0.5, "Y": 0.002}, {}):
        with pytest.raises(TypeError, match="is needed once, Y in m or a in m/s\\^2: got"):
            by_base.peak(**named)
    if load is None:
        second = by_base.second_approximation.peak(a=a)
        assert second == by_a.second_approximation.peak(a) and second.a == a


def test_numbers_are_given_with_units_in_words():
    texts = {"m": "12 kg", "k_v": "2.5 N/mm", "L": "80 mm", "friction": "0.1 lbf", "preload": "9 mm"}
    mount = Isolator.physical(**{**MOUNT, **texts}, excitation="base")
    assert mount.scales == Isolator.physical(**MOUNT, excitation="base").scales
    assert mount.oscillator.mu * mount.scales.sizes["force"] == pytest.approx(0.1 * 4.4482216152605, rel=1e-14)
    assert mount.peak(a="0.03 g") == mount.peak(a=0.03 * 9.80665)
    assert mount.amplitudes(f="120 rpm", Y="1 mm") == mount.amplitudes(f=2.0, Y=0.001)
    assert mount.shock_spectrum(acceleration="2 g", duration="11 ms").duration[0] == pytest.approx(0.011, rel=1e-15)
    for wrong in ("0.3 furlong", "0.3", "g", "x g", "0.3 mm"):
        with pytest.raises(ValueError, match=f"a = '{wrong}' is not allowed: a must be a number in m/s"):
            mount.peak(a=wrong)


def test_questions_in_si_units_are_the_dimensionless_ones(mount):
    iso, size = mount.oscillator, mount.scales.sizes
    F, L, f = (size[kind] for kind in ("force", "length", "frequency"))
    F_0 = 5 / F
    pairs = [
        (mount.saddle_node_onset(), iso.saddle_node_onset()),
        (mount.detachment(), iso.detachment()),
        (mount.saddle_nodes(5), iso.saddle_nodes(F_0)),
        (mount.peak(5), iso.peak(F_0)),
        (mount.amplitudes(f=[1.0, 2.2], F=5), iso.amplitudes(Omega=np.array([1.0, 2.2]) / f, F_0=F_0)),
        (mount.frequency_response(5, f=(1, 3)), iso.frequency_response(F_0, Omega=(1 / f, 3 / f))),
        (mount.fold_locus(samples=20), iso.fold_locus(samples=20)),
        (mount.cusps(), iso.cusps()),
        (mount.isola_points(), iso.isola_points()),
        (mount.second_approximation.saddle_nodes(5), iso.second_approximation.saddle_nodes(F_0)),
    ]
    named = {"Omega": ("f", f), "Omega_cr": ("f_cr", f), "u_cr": ("x_cr", L), "A": ("A", L), "F_0": ("F", F)}
    named |= {"F_SN": ("F_SN", F), "F_cr": ("F_cr", F)}
    for twin, answer in pairs:
        assert twin.answer == answer
        for name, (shown, scale) in named.items():
            if getattr(answer, name, None) is not None:
                np.testing.assert_allclose(getattr(twin, shown), getattr(answer, name) * scale, rtol=1e-15)
    assert mount.explain("peak", 5).F_0 == F_0 and str(mount.explain("peak", 5)).startswith("peak at F = 5 N")
    assert mount.backbone(0.01) == iso.backbone(0.01 / L) * f
    assert mount.limit_envelope(f=2, F=5) == iso.limit_envelope(Omega=2 / f, F_0=F_0) * L
    assert mount.force([0.01]) == iso.force([0.01 / L]) * F
    assert mount.stiffness([0.01]) == iso.stiffness([0.01 / L]) * mount.scales.k_v


def test_equilibria_are_not_measured(mount):
    with pytest.raises(ValueError, match="only states and folds can be compared"):
        mount.rest().measure()


def test_what_is_measured_is_in_physical_units(mount):
    f, L, F = (mount.scales.sizes[kind] for kind in ("frequency", "length", "force"))
    for twin in (mount.amplitudes(f=2.2, F=5), mount.saddle_nodes(5), mount.peak(5), mount.detachment()):
        exact, found = twin.answer.measure(), twin.measure()
        assert found.answer == exact
        assert np.array_equal(found.f, exact.Omega * f) and np.array_equal(found.A, exact.A * L)
        assert np.array_equal(found.error, exact.error)
    assert found.error_of_f == exact.error_of_Omega
    assert found.F == exact.F_0 * F and found.units["F"] == "N"


def test_exact_answers_are_physical_too(mount):
    f, L = mount.scales.sizes["frequency"], mount.scales.sizes["length"]
    curve = mount.exact_response(5, f=(2.1, 2.3))
    assert [round(fold.f, 2) for fold in curve.folds] == [2.18, 2.28]
    assert np.array_equal(curve.A, curve.answer.A * L) and len(curve) == len(curve.f)
    sweep = mount.sweep(f=[2.1, 2.2, 2.3], F=5)
    assert sweep.jumps == pytest.approx(np.array([[2.2, 2.3]])) and sweep.units["jumps"] == "Hz"
    assert np.array_equal(sweep.f, sweep.answer.Omega * f)


def test_a_certificate_holds_its_parts_in_units(mount):
    found = mount.certify(5, f=2.2)
    low, high = found.saddle_nodes.f[0]
    assert low <= mount.saddle_nodes(5).f[0] <= high
    assert found.saddle_nodes.units["f"] == "Hz" and found.amplitudes.units["A"] == "m"
    assert f"f/Hz          {float(low)!r} to {float(high)!r}" in str(found)
    assert found.in_units("mm").amplitudes.A[0, 0] == pytest.approx(1e3 * found.amplitudes.A[0, 0])


def test_at_rest_a_mount_has_what_its_data_sheet_says(mount):
    rest = mount.at_rest()
    assert mount.second_approximation.at_rest() == rest  # the springs are the same at each depth
    stiffness = 2500 - 3 * 1700 * 0.009 / 0.080  # what the preload takes off
    assert rest.k_0 == pytest.approx(stiffness)
    assert rest.f_n == pytest.approx(math.sqrt(2500 / 12) / math.tau)
    assert rest.f_0 == pytest.approx(math.sqrt(stiffness / 12) / math.tau)
    assert rest.x_cr == pytest.approx(math.sqrt(0.080**2 - 0.071**2))
    assert rest.preset == pytest.approx(12 * 9.80665 / 2500)
    assert (rest.lightest, rest.heaviest) == pytest.approx([12 - 2500 * rest.x_cr / 9.80665, 24 - rest.lightest])
    assert (rest.break_loose, rest.sticking) == pytest.approx((0.4, 1.6 / math.pi))
    with pytest.warns(UserWarning, match="negative stiffness") as warned:
        assert mount.replace(preload=0.05).at_rest().f_0 is None
    assert [one.filename for one in warned] == [__file__]
    assert mount.replace(preload=0).at_rest().x_cr is None


def test_a_load_off_the_centre_rests_where_it_sags(mount):
    """12 kg above the preset mass sag by 47 mm, beyond the stroke, where only k_v carries."""
    assert mount.replace(load=12.0) == mount.replace(load=12) and mount.replace(load=12.0).oscillator.load == 0
    heavy = mount.replace(load=24)
    equilibrium = heavy.rest()
    assert equilibrium.x == pytest.approx(12 * 9.80665 / 2500) and (equilibrium.load, equilibrium.units["load"]) == (
        24.0,
        "kg",
    )
    assert heavy.detachment().F_cr is None and "beyond" in heavy.detachment().message
    assert mount.replace(load=11).rest().x[0] < 0
    assert equilibrium.units["stiffness"] == "N/m" and equilibrium.stiffness == pytest.approx(
        heavy.stiffness(equilibrium.x)
    )
    assert equilibrium.in_units("N/mm").stiffness == pytest.approx(1e-3 * heavy.stiffness(equilibrium.x))
    with pytest.raises(ValueError, match="at_rest is not available with load"):
        heavy.at_rest()
    x = mount.sag(14)  # of the force as the geometry gives it
    height = math.sqrt(0.080**2 - x**2)
    assert 2500 * x - 5100 * (height - 0.071) * x / height == pytest.approx(2 * 9.80665)
    assert mount.sag(10) == pytest.approx(-x)


def test_viscous_damping_is_a_coefficient_or_a_ratio(mount):
    c = 0.02 * 2 * math.sqrt(2500 * 12)
    assert mount.replace(c=c).oscillator.zeta == pytest.approx(0.02)
    assert Isolator.physical(**{**MOUNT, "zeta": None}).oscillator.zeta == 0
    with pytest.raises(ValueError, match="c and zeta both define"):
        Isolator.physical(**MOUNT, c=c)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"m": 0}, "m = 0 is not allowed: m must be a finite real number > 0"),
        ({"L": "80 cm"}, "L = '80 cm' is not allowed: L must be a number in m, or one with a unit of m, mm, um, in"),
        ({"k_h": -1}, "k_h = -1 is not allowed: k_h must be a finite real number > 0"),
        ({"preload": 0.09}, "preload = 0.09 is not allowed: preload must be a finite real number >= 0 and < 0.08"),
        ({"friction": -0.4}, "friction = -0.4 is not allowed"),
        ({"c": -1.0}, "c = -1.0 is not allowed"),
        ({"c_2": -1.0}, "c_2 = -1.0 is not allowed: c_2 must be a finite real number >= 0"),
        ({"load": -1.0}, "load = -1.0 is not allowed"),
    ],
)
def test_what_is_not_allowed_is_refused_in_the_given_terms(mount, change, message):
    with pytest.raises(ValueError) as refused:
        mount.replace(**change)
    assert str(refused.value).startswith(message)


def test_units_have_the_sizes_of_their_prefixes():
    """Those of the International System by their definition, a prefix being a power of ten; a gram is not its unit."""
    others = {"rpm": 1 / 60, "rad/s": 1 / (2 * math.pi), "g": 9.80665, "deg": math.pi / 180, "min": 60.0, "h": 3600.0}
    prefixes = {"mN": 1e-3, "kN": 1e3, "mm": 1e-3, "um": 1e-6, "ms": 1e-3, "mm/s": 1e-3, "N/mm": 1e3, "N/mm^3": 1e9}
    prefixes |= {"N/mm^5": 1e15}
    pound = 0.45359237
    others |= {"in": 0.0254, "lb": pound, "lbf": pound * 9.80665, "lbf/in": pound * 9.80665 / 0.0254}
    sizes = {unit: size for units in UNITS.values() for unit, size in units.items() if size != 1}
    assert sizes == pytest.approx({**others, **prefixes, "kg mm": 1e-3, "g mm": 1e-6}, rel=1e-15)


def test_units_are_those_that_were_asked_for(mount):
    folds = mount.saddle_nodes(5)
    assert folds.units == {"f": "Hz", "A": "m", "F": "N"}
    other = folds.in_units("rpm", "um")
    assert other.units == {"f": "rpm", "A": "um", "F": "N"}
    np.testing.assert_allclose(other.f, 60 * folds.f)
    np.testing.assert_allclose(other.A, 1e6 * folds.A)
    np.testing.assert_allclose(folds.in_units("rad/s").f, math.tau * folds.f)
    assert other.in_units("m", "Hz").f == pytest.approx(folds.f)
    for kind, units in UNITS.items():
        assert next(iter(units.values())) == 1.0, kind
    with pytest.raises(ValueError, match="unit = 'furlong' is not allowed"):
        folds.in_units("furlong")


def test_an_answer_is_printed_in_the_units_that_were_chosen(mount):
    onset = mount.saddle_node_onset()
    assert "2.106 Hz" in str(onset) and "2665 mN" not in str(onset)
    assert "126.3 rpm" in str(onset.in_units("rpm")) and "0.0206 m\n" in str(onset.in_units("m"))
    chosen = pickle.loads(pickle.dumps(onset.in_units("rpm")))
    assert str(chosen) == str(onset.in_units("rpm")) and "Hz" in str(chosen.in_units())
    folds = str(mount.saddle_nodes(5).in_units("kN", "rpm", "m"))
    assert folds.startswith("f/rpm") and "A/m " in folds


def test_an_answer_in_units_is_printed_with_them(mount):
    text = str(mount.saddle_nodes(5))
    assert text.splitlines()[0].split() == ["f/Hz", "A/mm", "kind", "corner"] and "jump-up" in text
    assert re.search(r"F_SN +2\.665 N\n", str(mount.saddle_node_onset()))
    curve = mount.frequency_response(5)
    assert str(curve).splitlines()[1 + SHOWN] == f"and {len(curve) - SHOWN} more"
    assert "sticks" in str(mount.peak(0.1))


def test_quantities_are_compared_and_read_by_entry(mount):
    folds = mount.saddle_nodes(5)
    assert folds != mount.saddle_nodes(4.5)
    assert [fold.kind for fold in folds] == ["jump-up", "jump-down"] and folds[-1].f == folds.f[1]
    assert folds.to_dict()["units"]["A"] == "m" and folds.to_dict()["A"] == folds.A.tolist()
    assert mount != mount.replace(m=13) and mount != mount.replace(k_h=1701)
    with pytest.raises(AttributeError, match="'Omega' is not part of this answer: it has f, A"):
        _ = folds.Omega
    with pytest.raises(TypeError, match="no entries"):
        len(mount.peak(5))
    assert eval(repr(mount), {"Isolator": Isolator}) == mount


def test_quantities_of_pint_are_taken(mount):
    pint = pytest.importorskip("pint")
    u = pint.UnitRegistry()
    parameters = {
        "m": u.Quantity(12000, "gram"),
        "k_v": u.Quantity(2.5, "N/mm"),
        "k_h": u.Quantity(1.7, "kN/m"),
        "L": u.Quantity(80, "mm"),
        "preload": u.Quantity(9, "mm"),
        "friction": u.Quantity(400, "mN"),
    }
    other = Isolator.physical(**parameters, zeta=0.02)
    assert other.saddle_nodes(u.Quantity(5, "N")).f == pytest.approx(mount.saddle_nodes(5).f)
    expected = mount.amplitudes(f=5, F=5).A
    for f in (u.Quantity(5, "Hz"), u.Quantity(300, "rpm"), u.Quantity(10 * math.pi, "rad/s"), u.Quantity(5, "turn/s")):
        assert other.amplitudes(f=f, F=5).A == pytest.approx(expected), f
    with pytest.raises(ValueError, match="f must be in Hz, rpm, or rad/s"):
        other.amplitudes(f=u.Quantity(5, "1/s"), F=5)
    with pytest.raises(ValueError, match="F = 5 kilogram is not allowed: F must be measured in N"):
        other.peak(u.Quantity(5, "kg"))


def test_quantities_of_pint_without_a_unit_are_numbers(mount):
    """A damping ratio in percent, too; and tolerances, limits and ranges are as those of a mount in plain numbers."""
    pint = pytest.importorskip("pint")
    u = pint.UnitRegistry()
    assert mount.replace(zeta=u.Quantity(2, "percent"), n=u.Quantity(3, "dimensionless")).oscillator == mount.oscillator
    rubber = mount.replace(eta=u.Quantity(5, "percent"))
    assert rubber.given["eta"] == 0.05 or rubber.oscillator.eta == 0.05
    with pytest.raises(ValueError, match="zeta = 2 newton is not allowed: zeta must be a plain number"):
        mount.replace(zeta=u.Quantity(2, "N"))
    force = u.Quantity(5000, "mN")
    shown = tolerances(mount, {"k_h": u.Quantity(5, "percent")}, F=force, f=u.Quantity(300, "rpm"), samples=20)
    assert shown == tolerances(mount, {"k_h": 0.05}, F=5.0, f=5.0, samples=20)
    free, limits = {"preload": (u.Quantity(8, "mm"), u.Quantity(1, "cm"))}, {"f_jump_up": u.Quantity(129.3, "rpm")}
    found = meet(mount, free, at_most=limits, F=force)
    assert found == meet(mount, {"preload": (0.008, 0.01)}, at_most={"f_jump_up": 2.155}, F=5.0) and found.feasible
    jumps = {"jump_up": u.Quantity([130, 129], "rpm"), "free": ["preload"]}
    assert (
        fit(mount, F=u.Quantity([5, 6], "N"), **jumps).value
        == fit(mount, F=[5, 6], jump_up=[130 / 60, 129 / 60], free=["preload"]).value
    )


def test_a_table_says_which_mount_it_is_of_and_in_which_units(mount):
    """Of xarray and pandas: the numbers of the data sheet, as they were given, beside the dimensionless ones."""
    pytest.importorskip("xarray")
    states = mount.amplitudes(f=5, F=5)
    for attributes in (states.to_xarray().attrs, states.in_units().to_xarray().attrs):
        assert {name: attributes[name] for name in MOUNT} == MOUNT and attributes["lam"] == 3
        units = {"m": "kg", "k_v": "N/m", "k_h": "N/m", "L": "m", "preload": "m", "friction": "N", "F": "N"}
        assert {name: attributes[f"{name}_units"] for name in units} == units
        assert "zeta_units" not in attributes and "n_units" not in attributes
    assert states.to_pandas().attrs["units"]["preload"] == "m"


def test_a_number_that_is_no_argument_is_said_with_the_nearest():
    with pytest.raises(TypeError, match=r"Isolator.physical has no argument 'prelod': .*\. Did you mean 'preload'\?"):
        Isolator.physical(**{**MOUNT, "prelod": 0.009})
    with pytest.raises(TypeError, match=r"Isolator has no argument 'zetta': .*\. Did you mean 'zeta'\?"):
        Isolator(lam=3, r=0.68, delta_h=0.1, zetta=0.02)


def test_force_is_of_the_geometry_unless_the_truncated_is_named(mount):
    assert mount == mount.replace(force="untruncated") != mount.replace(force="truncated")
    for load in (None, 12.3):
        one = mount.replace(load=load)
        iso = Isolator(
            lam=3,
            r=0.68,
            delta_h=0.1125,
            mu=0.002,
            zeta=one.oscillator.zeta,
            load=one.oscillator.load,
            force="untruncated",
        )
        folds = iso.saddle_nodes(0.025)
        assert one.saddle_nodes(5).f == pytest.approx(folds.Omega * one.scales.sizes["frequency"], rel=1e-12)


def test_mounts_know_sticking_and_the_transmissibility_floor(mount):
    """By the formulas of the slow flow (27), in newtons; on a base that shakes each amplitude moves the mass."""
    assert mount.sticking_forcing == pytest.approx(4 * 0.4 / math.pi)
    assert mount.transmissibility_floor(5) == pytest.approx(4 * 0.4 / (math.pi * 5))
    assert mount.replace(excitation="base").sticking_forcing == 0


def test_sticking_up_to_no_or_any_frequency_is_said(mount):

    assert "f_sticks      at no frequency" in str(mount.margins(5))
    assert "f_sticks      at every frequency" in str(mount.margins(0.3))
    assert re.search(r"f_sticks +0\.\d+ Hz", str(mount.replace(excitation="base").margins(0.004)))


def test_missing_answer_in_units_is_said_as_without_units(mount):
    with pytest.raises(AttributeError, match="second approximation has no validity: it has no table of errors"):
        mount.second_approximation.saddle_nodes(5).validity  # noqa: B018
    with pytest.raises(AttributeError, match=r"\.answer\.validity is dimensionless"):
        mount.saddle_nodes(5).validity  # noqa: B018


def test_a_linear_oscillator_can_be_physical_too():
    """Any dimensionless oscillator with its scales."""
    from slowflow.oscillators.physical import Physical

    scales = Scales(m=2.0, k_v=800.0, L=0.1)
    mount = Physical(Duffing(1.0, 0.0, zeta=0.1), scales, {})
    peak = mount.peak(3.0)
    assert peak.A == pytest.approx(3 / 800 / (2 * 0.1 * math.sqrt(1 - 0.01)))
    assert peak.f == pytest.approx(math.sqrt(400 * (1 - 0.02)) / math.tau)


def test_numbers_of_an_answer_have_a_unit_or_none_by_list():
    """A field that is added has to be entered here or among the kinds."""
    without = {"phi", "error", "error_of_A", "of_SN", "of_cr", "transmissibility_dB", "level_dB"}
    for module in (results, checks):
        for kind in vars(module).values():
            if dataclasses.is_dataclass(kind) and kind.__module__ == module.__name__:
                numbers = [one.name for one in dataclasses.fields(kind) if "loat" in str(one.type) and one.repr]
                assert set(numbers) <= {name for name, one in COLUMNS.items() if one.kind} | without, kind


# ---- words ---------------------------------------------------------------------------------------------------------


def text_of(mount):
    """All that is said beside answers of a mount, and where there is none; plans too."""
    for F in (0.3, 0.509, 0.51, 2.0, 5.0, 30.0):
        for question in ("saddle_nodes", "peak", "frequency_response", "margins", "hysteresis", "isolation"):
            yield getattr(mount, question)(F).message
            yield str(mount.explain(question, F))
        yield mount.amplitudes(f=[0.01, 2.2], F=F).message
        yield mount.spectrum(f=[0.01, 2.2], F=F).message
        yield mount.frequency_response(F, f=(3.0, 4.0)).message
    for question in ("saddle_node_onset", "detachment", "cusps", "isola_points", "fold_locus"):
        up_to = {} if question in ("saddle_node_onset", "detachment") else {"A_max": 0.08}
        yield getattr(mount, question)(**up_to).message
        yield str(mount.explain(question))


@pytest.mark.parametrize(
    "changes", [{}, {"zeta": 0.0}, {"friction": 0.0}, {"preload": 0.04}, {"preload": 0.0}, {"k_h": 2500, "n": 2}]
)
def test_words_about_a_mount_are_in_its_letters_and_units(changes):
    mount = Isolator.physical(**{**MOUNT, **changes})
    messages = [text for text in text_of(mount) if text]
    for text in messages:
        # what scenes of the slow flow are called has the paper's letters
        checked = re.sub(r"runs .*", "", text)
        assert not re.search(r"F_0|Omega|\bmu\b|u_cr|\btau\b", checked), text


def test_numbers_in_messages_about_a_mount_are_those_given():
    mount = Isolator.physical(**MOUNT)
    assert mount.peak(0.3).message == f"sticks: F = 0.3 N does not exceed 4 friction/pi = {1.6 / math.pi:.6g} N"
    assert mount.saddle_nodes(2).message == "no saddle node at F = 2 N: the response is single-valued"
    assert "amplitudes above 80 mm are not reached" in mount.peak(30).message
    assert "sticks: F = 0.3 N" in str(mount.explain("saddle_nodes", 0.3))
    curve = mount.exact_response(F=0.3, f=(1.0, 2.2))
    assert curve.A.size == 0 and curve.message.startswith("F = 0.3 N does not exceed friction = 0.4 N")
    unit = mount.scales.sizes
    pattern = Sentence("here at {Omega = :.8g}; steady_state({Omega_0=:g}, {F_0=:g}, {A=:g})")
    message = pattern.format((0.5, 1e-5, 0.12345678), 0.5, 0.025, 0.5)
    assert message == "here at Omega = 0.5, 1e-05, 0.12345678; steady_state(Omega_0=0.5, F_0=0.025, A=0.5)"
    message = message.in_units(mount.scales)
    first, second, third = (x * unit["frequency"] for x in (0.5, 1e-5, 0.12345678))
    numbers = f"{first:.4g}, {second:.4g}, {third:.8g}"
    assert message == f"here at f = {numbers} Hz; steady_state(f_0={first:.4g}, F=5, A=0.04)"


@pytest.mark.parametrize(
    "ask, message",
    [
        (lambda mount: mount.saddle_nodes([3, 5]), "F = [3, 5] is not allowed: F must be a finite real number > 0"),
        (lambda mount: mount.certify(5, f=[2.2, 2.3]), "f = [2.2, 2.3] is not allowed"),
        (lambda mount: mount.backbone(-0.1), "A = -100 mm is not allowed"),
        (lambda mount: mount.saddle_nodes(1e300), "no amplitude bounds the response at F = 1e+300 N"),
        (lambda mount: mount.transient(acceleration=20), "or t, the times of a record"),
        (lambda mount: mount.transient(acceleration=2, duration=-0.1), "duration = -100 ms is not allowed"),
        (lambda mount: mount.shock_spectrum(acceleration=2, duration=[-0.1]), "duration = -100 ms is not allowed"),
        (lambda mount: mount.transient(acceleration=2, duration=0.1, after=-1), "after = -1000 ms is not allowed"),
        (lambda mount: mount.spectrum(f=[1, 2, 3], F=[1, 2]), "shapes do not broadcast: f (3,), F (2,)"),
        (
            lambda mount: mount.transient(acceleration=1e9, duration=0.01),
            "the motion escapes: |x| passes 8e+07 mm, the restoring force",
        ),
        (lambda mount: mount.exact_response(5, start=9.0), "start must be a result of steady_state"),
        (lambda mount: mount.frequency_response(5, f=3), "f must be a pair"),
        (
            lambda mount: mount.shock_spectrum(acceleration=[1], duration=[1.7e308]),
            "duration = [1.7e+308] is too",
        ),
        (lambda mount: mount.replace(load=10, contact="attached"), "load = 10 kg is not available with contact = "),
        (lambda mount: mount.replace(zeta=0, c_3=2), "c_3 = 2 N s^3/m^3 is not allowed with zeta = 0"),
        (lambda mount: mount.replace(zeta=0, c_xx=30), "c_xx = 30 N s/m^3 is not allowed with zeta = 0"),
        (
            lambda mount: mount.replace(preload=9),
            "preload = 9 is not allowed: preload must be",
        ),
        (lambda mount: mount.sweep(f=[2.1], F=5).measure(), "only averaged answers can be compared"),
        (lambda mount: mount.replace(friction=0, zeta=0).amplitudes(f=1.5, F=5).measure(), "friction = 0"),
        (lambda mount: mount.at_rest().gradient(), "only averaged answers"),
        (lambda mount: mount.second_approximation.peak(5).gradient(), "only averaged answers"),
        (lambda mount: mount.replace(preload=0.0).peak(5).gradient(), "without preload the springs never touch"),
        (lambda mount: mount.explain("peek", 5), "Did you mean 'peak'?"),
        (lambda mount: mount.plot([]), "F = [] is not allowed: F must be at least one number > 0"),
        (
            lambda mount: mount.plot("5 mm"),
            "F = '5 mm' is not allowed: F must be a number in N, or one with a unit of N, mN, kN",
        ),
    ],
)
def test_refusals_of_a_mount_use_its_letters_and_units(ask, message):
    with pytest.raises(SlowflowError) as refused:
        ask(Isolator.physical(**MOUNT))
    assert message in str(refused.value)


def test_exact_curve_begins_at_a_motion_of_the_mount():
    mount = Isolator.physical(**MOUNT)
    state = mount.steady_state(f=2.2, F=5.0, A=0.040)
    curve = mount.exact_response(5.0, f=(2.15, 2.3), start=state)
    assert np.abs(curve.A - state.A).min() < 1e-12


def test_gradients_in_si_units_are_by_what_was_given(mount):
    """Of the data sheet, not of scales; with condition numbers."""
    states = mount.amplitudes(f=2.5, F=5.0)
    found, arguments = states.gradient(), {**MOUNT, "F": 5.0, "f": 2.5}
    assert found.of == ("A", "phi", "transmissibility") and set(found.by) == set(arguments)
    change = np.abs(found["A"][0] * [arguments[name] for name in found.by]).sum()
    assert found.condition("A")[0] == pytest.approx(change / states.A[0], rel=1e-13)
    sheet = {"m": 12.0, "k_1": 2500.0, "k_3": 4e5, "k_5": 1e8, "friction": 0.4, "c": 8.0}
    assert set(Duffing.physical(**sheet).peak(5.0).gradient().by) == {*sheet, "F"}


def test_angles_are_shown_in_degrees_gradients_in_si_units(mount):
    states = mount.amplitudes(f=2.0, F=4.0)
    np.testing.assert_allclose(states.in_units("deg").phi, np.degrees(states.phi))
    assert mount.peak(5).in_units().gradient()["A"].tolist() == mount.peak(5).gradient()["A"].tolist()


def test_a_velocity_is_how_fast_the_displacement_moves(mount):
    found = mount.transient(x_0=0.004, v_0=0.03, samples=4001)
    assert found.v[0] == pytest.approx(0.03, rel=1e-12)
    np.testing.assert_allclose(np.gradient(found.x, found.t)[1:-1], found.v[1:-1], rtol=0, atol=1e-3)


@pytest.mark.parametrize(("unit", "shown"), [("m", ("mm", 1e-3)), ("N", ("N", 1.0)), ("rad/s", ("Hz", math.tau))])
def test_numbers_are_shown_over_the_size_of_the_usual_unit(unit, shown):
    assert in_shown(unit) == (shown[0], pytest.approx(shown[1], rel=1e-15))


#: slips of units: what is changed in the mount, and what is said of it
SLIPS = {
    "L in mm": ({"L": 80, "preload": 9}, r"L = 80 m is a push-rod as long as a house: is it in mm\?"),
    "k_v in N/mm": ({"k_v": 2.5, "k_h": 1.7, "friction": 0.0}, r"k_v = 2.5 N/m is compressed by 47.07 m under 12 kg"),
    "m in g": ({"m": 12000}, r"is compressed by 47.07 m under 12000 kg: is it in N/mm, or the mass in g\?"),
    "load in g": ({"load": 12360}, r"is compressed by 48.48 m under 12360 kg"),
    "k_h in N/mm": ({"k_h": 1.7}, r"k_h = 1.7 N/m is negligible compared with k_v = 2500 N/m: is it in N/mm\?"),
    "friction in mN": ({"friction": 400}, r"friction = 400 N is more than the weight, 117.7 N: is it in mN\?"),
    "zeta in per cent": ({"zeta": 2}, r"zeta = 2 is more than critical damping: is it in per cent\?"),
}


@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_of_units_is_told_when_a_mount_is_made(slip, mount):
    changes, message = SLIPS[slip]
    second = {name: [mount.given[name] or 12, value] for name, value in changes.items()}
    for make in (lambda: mount.replace(**changes), lambda: mount.many(**second)):
        with pytest.warns(Implausible, match=message) as warned:
            make()
        assert [one.filename for one in warned] == [__file__]


def test_frequencies_in_rpm_and_shocks_in_ms_are_told(mount):
    with pytest.warns(Implausible, match=r"f = 1500 Hz is 653 times f_n = 2.297 Hz, .*: is it in rpm\?") as warned:
        mount.amplitudes(f=[5.0, 1500.0], F=5)
    assert [one.filename for one in warned] == [__file__]
    with pytest.warns(Implausible, match=r"duration = 11 s lasts for 25.3 natural periods: is it in ms\?"):
        mount.transient(acceleration=0.1, duration=11)


@pytest.mark.parametrize(
    "sheet",
    [
        {"m": 0.05, "k_v": 500, "k_h": 300, "L": 0.02, "preload": 0.002, "friction": 0.01, "zeta": 0.05},
        {"m": 200, "k_v": 78480, "k_h": 2e4, "L": 0.15, "preload": 0.02, "friction": 20, "c": 800},
        {"m": 5000, "k_v": 2e6, "k_h": 4e6, "L": 0.3, "preload": 0.02, "zeta": 0.1},
        {"m": 50, "k_v": 500, "k_h": 250, "n": 4, "L": 0.5, "preload": 0.2, "zeta": 0.02},
        {"m": 12, "k_v": 2500, "k_h": 1700, "L": 0.08, "preload": 0, "zeta": 0.9},
    ],
    ids=("a sensor", "a fan", "a press", "a table of half a hertz", "springs that are not preloaded"),
)
def test_sensible_mounts_are_not_nagged(sheet):
    """Warnings are errors here."""
    mount = Isolator.physical(**sheet)
    f_n = mount.scales.sizes["frequency"]
    mount.amplitudes(f=[0.5 * f_n, 50 * f_n], F=0.1 * sheet["m"])
    mount.transient(acceleration=1.0, duration=2 / f_n)
