"""Tolerances against single answers and gradients, inverse design against a root, fits against noise that is known."""

from __future__ import annotations

import functools
import sys

import numpy as np
import pytest
import scipy
from scipy.optimize import brentq

from slowflow import Duffing, Isolator, derive
from slowflow.example import isolator
from slowflow.off_centre import by_amplitudes
from slowflow.sizing import fit, from_loop, front, meet, sobol, tolerances
from slowflow.sizing.subject import Subject
from slowflow.support import progress
from slowflow.support.errors import NotSettled
from tests import files
from tests.oracles import by_time
from tests.sampling import fewer

MOUNT = Isolator.physical(**files.MOUNT, force="truncated")
SHAKEN = MOUNT.replace(excitation="base", zeta=0.05)
UNBALANCED = SHAKEN.replace(excitation="unbalance")
LOADED = MOUNT.replace(load=12.36)
CUBIC = Duffing.physical(m=12, k_1=2500, k_3=4e5, friction=0.4, zeta=0.02)
WITHIN = {"m": 0.02, "k_v": 0.03, "k_h": 0.05, "L": 0.01, "preload": 0.05, "friction": 0.3, "zeta": 0.2}
SHOCK = (20.0, 0.02)
TABLE = ([2.2, 5.0, 2.0, 2.2, 5.0], [5.0, 5.0, 3.0, 4.0, 0.3])


# ---- tolerances ----------------------------------------------------------------------------------------------------


def single_answers(one, shock=None, spectrum=None, f=None, **forcing):
    """By name what single questions say of a mount in a load case; of a forcing without end inf, else NaN for none."""
    one = one.replace(excitation="acceleration") if "a" in forcing else one
    letter = one.scales.symbol("F_0")
    onset, detaches = (
        getattr(found, f"{letter}_{of}") for found, of in ((one.saddle_node_onset(), "SN"), (one.detachment(), "cr"))
    )
    found = {f"{letter}_SN": onset, f"{letter}_cr": detaches, "sticking": 4 * one.given["friction"] / np.pi}
    if one.oscillator.load:
        (rest,) = one.rest()
        found["f_rest"] = (one.stiffness(rest.x) / one.scales.m) ** 0.5 / (2 * np.pi)
        found["break_loose"] = one.given["friction"]
    else:
        rest = one.at_rest()
        found |= {"f_rest": rest.f_0, "break_loose": rest.break_loose, "rests_within": rest.rests_within}
    if forcing:
        peak, folds, margins = one.peak(**forcing), one.saddle_nodes(**forcing), one.margins(**forcing)
        found |= {"A_peak": 0.0 if margins.sticks else peak.A, "f_peak": peak.f}
        found |= {"f_jump_up": min(folds.f, default=None), "f_jump_down": max(folds.f, default=None)}
        found |= {"of_SN": margins.of_SN, "of_cr": margins.of_cr, "f_isolation": one.isolation(**forcing).f}
        found["f_band"] = sum(band.f_high - band.f_low for band in one.hysteresis(**forcing))
        found |= {"stroke": peak.x_max} if one.oscillator.load else {}
        found |= {"f_sticks": margins.f_sticks} if letter in "YU" else {}
    if f is not None:
        states = one.amplitudes(f=f, **forcing)
        largest = states[int(np.flatnonzero(states.stable)[-1])]
        found |= {"A": largest.A, "transmissibility": 10 ** (largest.transmissibility_dB / 20)}
    if shock is not None:
        shock = one.transient(acceleration=shock[0], duration=shock[1])
        found |= {"A_shock": shock.A, "a_shock": shock.a_max, "of_cr_shock": shock.x_cr / shock.A}
    if spectrum is not None:
        rows, most = one.spectrum(f=spectrum[0], **{letter: spectrum[1]}), max(spectrum[1])
        found |= {"A_spectrum": rows.A.max(), "of_SN_spectrum": onset / most, "of_cr_spectrum": detaches / most}
        found["transmissibility_spectrum"] = 10 ** (np.nanmax(rows.transmissibility_dB) / 20)
        found |= {"rows_several": (rows.motions > 1).sum(), "rows_cross": rows.crosses.sum()}
        found |= {"rows_detach": rows.detaches.sum(), "rows_stick": rows.sticks.sum()}
    return {name: (np.nan if name[:2] == "f_" else np.inf) if one is None else one for name, one in found.items()}


#: of answers that are no frequencies
UNITS = {
    **dict.fromkeys(("F_SN", "F_cr", "break_loose", "sticking"), "N"),
    **dict.fromkeys(("Y_SN", "Y_cr", "A_peak", "A", "A_shock", "A_spectrum", "stroke", "rests_within"), "m"),
    **dict.fromkeys(("U_SN", "U_cr"), "kg m"),
    **dict.fromkeys(("a_SN", "a_cr", "a_shock"), "m/s^2"),
}
LAWS = {"eta": 0.02, "c_2": 8.0, "contact": "attached"}
#: mounts, tolerances, load cases; numbers of samples, and how near their answers are to single ones
SAMPLED = {
    "force": (MOUNT, WITHIN, {"F": 5.0, "f": 2.25, "shock": SHOCK, "spectrum": TABLE}, 12, 1e-11),
    "base": (SHAKEN, {**WITHIN, "zeta": 0.02}, {"Y": 0.004, "f": 2.3, "shock": SHOCK}, 6, 1e-11),
    "acceleration of the base": (SHAKEN, {"friction": 0.3}, {"a": 0.5}, 5, 1e-12),
    "unbalance": (UNBALANCED, {**WITHIN, "zeta": 0.02}, {"U": 0.048, "shock": SHOCK}, 6, 1e-11),
    "held by friction": (MOUNT, {"k_h": 0.05}, {"F": 0.3, "f": 5.0}, 5, 1e-12),
    "cubic spring": (CUBIC, {"m": 0.1, "k_1": 0.1, "k_3": 0.2, "friction": 0.1, "zeta": 0.3}, {"F": 20.0}, 8, 1e-12),
    "static friction": (
        *(MOUNT.replace(static_friction=0.6), {"m": 0.02, "friction": 0.2, "static_friction": 0.1}),
        *({"F": 5.0, "shock": SHOCK}, 4, 1e-11),
    ),
    "structural": (MOUNT.replace(eta=0.01), dict.fromkeys(("k_h", "friction", "eta"), 0.1), {"F": 5.0}, 2, 1e-11),
    "quadratic": (
        *(MOUNT.replace(c_2=8.0), dict.fromkeys(("k_h", "friction", "c_2"), 0.1)),
        *({"F": 5.0, "shock": SHOCK}, 2, 1e-11),
    ),
    "attached": (
        *(MOUNT.replace(contact="attached"), dict.fromkeys(("k_h", "friction"), 0.1)),
        *({"F": 5.0, "shock": SHOCK}, 2, 1e-11),
    ),
    "laws on a base": (
        *(SHAKEN.replace(**LAWS), dict.fromkeys(("k_h", "friction", "eta", "c_2"), 0.1)),
        *({"Y": 0.002, "f": 2.2}, 2, 1e-9),
    ),
    "load": (
        *(LOADED, {"load": 0.02, "preload": 0.05}),
        *({"F": 3.0, "shock": SHOCK, "spectrum": ([2.2, 5.0], [5.0, 5.0])}, 2, 1e-11),
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", SAMPLED)
def test_each_sample_has_the_single_answers_of_that_mount(name):
    mount, within, case, count, near = SAMPLED[name]
    found = tolerances(mount, within, **case, samples=count)
    nominal = single_answers(mount, **case)
    assert {*found.answer} == {*nominal}
    for row in found:
        assert row.nominal == pytest.approx(nominal[row.answer], rel=near, nan_ok=True)
        assert row.share == (not np.isnan(row.nominal))
        assert row.unit == UNITS.get(row.answer, "Hz" if row.answer.startswith("f_") else "")
    for k in range(count):
        one = mount.replace(**{name: float(values[k]) for name, values in found.drawn.items()})
        for answer, value in single_answers(one, **case).items():
            assert found.samples[answer][k] == pytest.approx(value, rel=near, nan_ok=True), answer


@pytest.mark.slow
def test_fit_finds_damping_and_friction_on_a_base():
    f = np.linspace(2.0, 4.0, 14)  # the force is ten times friction and more: averaging errs little
    motions = [SHAKEN.steady_state(f=one, Y=0.002) for one in f]
    found = fit(
        SHAKEN.replace(zeta=0.03, friction=0.2), A=[one.A for one in motions], Y=0.002, f=f, free=["zeta", "friction"]
    )
    assert found.value == pytest.approx([0.05, 0.4], rel=0.05)
    jumps = [0.0045, 0.005, 0.006]
    seen = [(folds.f[0], folds.f[-1]) for folds in map(SHAKEN.saddle_nodes, jumps)]
    up, down = np.transpose(seen)
    again = fit(SHAKEN.replace(zeta=0.055), Y=jumps, jump_up=up, jump_down=down, free=["zeta"])
    assert again.value == pytest.approx([0.05], rel=1e-8)
    assert again.names[0] == "Y/m"


@pytest.mark.slow
@pytest.mark.parametrize("name", WITHIN)
def test_the_band_of_a_small_tolerance_is_that_of_the_gradient(name):
    part, nominal = 1e-4, MOUNT.given
    found = tolerances(MOUNT, {name: part}, F=5, samples=2000)
    ends = [single_answers(MOUNT.replace(**{name: nominal[name] * (1 + s * part)}), F=5) for s in (-1, 1)]
    for row in found:
        width = 0.95 * abs(ends[1][row.answer] - ends[0][row.answer])
        assert row.high - row.low == pytest.approx(width, rel=2e-3, abs=1e-9 * row.nominal)
        assert row.median == pytest.approx(row.nominal, rel=1e-3)


def test_bands_are_printed_in_millimetres_and_kept_in_metres():
    found = tolerances(MOUNT, {"k_h": 0.05}, F=5, samples=20)
    _, unit, nominal, *_ = next(line.split() for line in str(found).splitlines() if "A_peak" in line)
    kept = next(row for row in found if row.answer == "A_peak")
    assert (unit, kept.unit) == ("mm", "m") and float(nominal) == pytest.approx(1e3 * kept.nominal, rel=1e-3)


def test_samples_follow_from_the_seed_and_the_distribution():
    within = {"friction": scipy.stats.norm(0.4, 0.02), "zeta": 0.1}
    one, same, other = (tolerances(MOUNT, within, samples=4000, seed=seed) for seed in (1, 1, 2))
    assert one == same and one != other
    assert {row.answer for row in one} == {"F_SN", "F_cr", "f_rest", "break_loose", "sticking", "rests_within"}
    assert (one.drawn["friction"].mean(), one.drawn["friction"].std()) == pytest.approx((0.4, 0.02), rel=2e-3)
    assert one.drawn["zeta"].min() >= 0.018 and one.drawn["zeta"].max() <= 0.022


def test_an_answer_that_some_samples_have_not_says_so():
    found = tolerances(
        isolator(), {"mu": scipy.stats.norm(0.03, 0.01)}, F_0=0.04, answers=["Omega_jump_up"], samples=400
    )
    (row,) = found
    assert 0.05 < row.share < 0.95 and "Omega_jump_up has no answer for" in found.message and row.unit == ""
    assert np.isnan(found.samples["Omega_jump_up"]).mean() == pytest.approx(1 - row.share)


def test_indices_say_which_tolerance_matters_as_gradients_do():
    """Of small tolerances the variance is the sum of the squares of slope times deviation."""
    pytest.importorskip("SALib")
    within = {"k_v": 0.01, "friction": 0.03, "zeta": 0.02}
    found = sobol(MOUNT, within, answers=["F_SN"], samples=1024)
    slopes = {}
    for name, part in within.items():
        ends = [MOUNT.replace(**{name: MOUNT.given[name] * (1 + s * part)}).saddle_node_onset().F_SN for s in (-1, 1)]
        slopes[name] = (ends[1] - ends[0]) ** 2
    for row in found:
        assert row.total == pytest.approx(slopes[row.parameter] / sum(slopes.values()), abs=0.02)
        assert row.first == pytest.approx(row.total, abs=0.05)


@pytest.mark.slow
def test_an_index_that_is_not_defined_is_nan_and_said():
    pytest.importorskip("SALib")
    found = sobol(
        isolator(), {"mu": scipy.stats.norm(0.03, 0.01), "zeta": 0.1}, F_0=0.04, answers=["Omega_jump_up"], samples=64
    )
    assert np.isnan(found.total).all() and "Omega_jump_up is not finite" in found.message


def test_what_is_not_allowed_is_refused_in_words(monkeypatch):
    rubber, backbone = MOUNT.replace(eta=0.02), {"A": 0.01, "backbone": [2.1] * 9}
    refused = [
        (lambda: tolerances(Duffing, {"beta": 0.1}), "must be an oscillator, or a mount in SI units"),
        (lambda: tolerances(MOUNT, {"kh": 0.1}), "'kh' cannot be varied: it must be one of m, k_v, L, n, k_h"),
        (lambda: tolerances(MOUNT, {"k_h": 1.5}), r"within\['k_h'\] = 1.5 is not allowed"),
        (lambda: tolerances(MOUNT, {}), "at least one parameter"),
        (lambda: tolerances(MOUNT, ["k_h"]), "within must be a mapping from names to tolerances"),
        (
            lambda: tolerances(MOUNT.replace(friction=0), {"friction": 0.3}),
            "is relative to the nominal value 0: give a distribution",
        ),
        (lambda: tolerances(MOUNT, {"k_h": 0.1}, F_0=0.1), "the forcing of a mount is F"),
        (lambda: tolerances(isolator(), {"r": 0.1}, F=0.1), "the forcing of an oscillator is F_0"),
        (lambda: tolerances(MOUNT, {"k_h": 0.1}, answers=["A_peak"]), "A_peak needs a forcing: give F"),
        (lambda: tolerances(MOUNT, {"k_h": 0.1}, F=5, answers=["A"]), "A needs a frequency: give f"),
        (lambda: tolerances(MOUNT, {"k_h": 0.1}, Omega=1.0), "the frequency of a mount is f"),
        (lambda: tolerances(MOUNT, {"k_h": 0.1}, answers=["peak"]), "'peak' is not an answer: it must be one of F_SN"),
        (lambda: sobol(MOUNT, {"k_h": 0.1}, samples=1000), "samples must be a power of two"),
        (lambda: meet(MOUNT, {"k_h": (1, 2)}), "at least one requirement"),
        (lambda: meet(MOUNT, ["k_h"], at_least={"F_SN": 1}), "free must be a mapping from names to pairs"),
        (lambda: meet(MOUNT, {"k_h": (1, 2)}, at_most=["F_SN"]), "at_most must be a mapping from names to limits"),
        (lambda: meet(MOUNT, {"k_h": (2, 1)}, at_least={"F_SN": 1}), r"k_h\[1\] = 1 is not allowed"),
        (lambda: fit(MOUNT, A=[0.1] * 3, F=5, f=[1, 2, 3]), "3 points are too few for 4 parameters"),
        (lambda: fit(MOUNT, A=[0.1] * 3, F=5, f=[1, 2, 3], free=[]), r"free = \[\] is not allowed"),
        (lambda: tolerances(MOUNT, {"k_h": 0.1}, seed=1.5), "seed = 1.5 is not allowed: seed must be an integer >= 0"),
        (lambda: meet(MOUNT, {"k_h": (1, 2)}, at_least={"F_SN": 1}, seed=-1), "seed = -1 is not allowed"),
        (lambda: fit(MOUNT, A=[0.1] * 9), "f and F are needed"),
        (lambda: fit(MOUNT, F=[4, 5]), "either measured amplitudes A, or phases phi, or jump_up or jump_down"),
        (lambda: fit(MOUNT, F=5, f=2, A=[0.1] * 9, phi=[-1.0] * 9), "either measured amplitudes A, or phases phi"),
        (lambda: fit(MOUNT, backbone=[2.1] * 9), "A is needed, the amplitudes of the backbone"),
        (lambda: fit(MOUNT, {"A": 0.01, "backbone": [2.1] * 9}), "deviation = None is not allowed"),
        (lambda: fit(MOUNT, {"A": 0.01, "backbone": [2.1] * 9, "deviation": "2 mm"}), "must be a number in Hz"),
        (lambda: fit(MOUNT, {"A": 0.01, "backbone": [2.1] * 9, "deviation": 0}), "deviation = 0 is not allowed"),
        (lambda: fit(MOUNT, {"A": 0.01, "backbone": [2.1]}, F=3.0), "either data sets or keyword arguments"),
        (lambda: fit(MOUNT, F=5, f=2, phi=[-1.0] * 8 + [np.nan]), "phi = nan is not allowed"),
        (lambda: fit(MOUNT, F=[4, 5], jump_up=[2.1]), "jump_up is not allowed: it must have a frequency"),
        (lambda: fit(MOUNT, jump_up=[2.1]), "F is needed"),
        (lambda: tolerances(MOUNT, {"k_h": 0.1}, answers=["A_shock"]), "A_shock needs a shock of the base: give shock"),
        (
            lambda: tolerances(MOUNT, {"k_h": 0.1}, answers=["rows_cross"]),
            "rows_cross needs a load spectrum: give spectrum",
        ),
        (
            lambda: tolerances(SHAKEN, {"k_h": 0.1}, spectrum=3),
            r"spectrum = 3 is not allowed: .* must be a pair \(f, Y\)",
        ),
        (lambda: tolerances(MOUNT, {"k_h": 0.1}, shock=20), "shock must be a pair"),
        (
            lambda: tolerances(MOUNT, {"k_h": 0.1}, shock={"acceleration": 20.0, "duration": 0.011}),
            r"shock = {'acceleration': 20.0, .* is not allowed: shock must be a pair \(acceleration, duration\)",
        ),
        (lambda: front(MOUNT, {"k_h": (1, 2)}, high=["F_SN"]), "front needs two answers"),
        # names that are none have the nearest beside them
        (lambda: tolerances(MOUNT, {"prelod": 0.05}), r"must be one of .*\. Did you mean 'preload'\?$"),
        (lambda: tolerances(MOUNT, {"preload": 0.05}, answers=["FSN"]), r"must be one of .* Did you mean 'F_SN'\?$"),
        (
            lambda: meet(MOUNT, {"zetta": (0.01, 0.1)}, at_least={"F_SN": 4}),
            r"must be one of .* Did you mean 'zeta'\?$",
        ),
        (lambda: meet(MOUNT, {"zeta": (0.01, 0.1)}, at_least={"f_sn": 4}), r"must be one of .* Did you mean 'F_SN'\?$"),
        # motions in time
        (lambda: fit(MOUNT, x=TIMES), "x needs t, the times of a free decay, or F"),
        (lambda: fit(MOUNT, x=TIMES[:5], t=TIMES[:5]), "of at least 10 samples"),
        (lambda: fit(MOUNT, x=TIMES, t=TIMES[::-1]), "the times must be ascending"),
        (lambda: fit(MOUNT, x=TIMES, t=TIMES), "must begin with a displacement"),
        (lambda: fit(MOUNT, x=TIMES, t=TIMES, A=[1.0]), "needs either"),
        (lambda: fit(MOUNT, t=TIMES, A=TIMES, f=1.0, F=1.0), "t needs x"),
        (lambda: fit(MOUNT.replace(eta=0.1), x=0.01 * np.cos(TIMES), t=TIMES), "defined at one frequency"),
        (
            lambda: fit(MOUNT.replace(contact="attached"), x=0.01 * np.cos(TIMES), F=np.cos(TIMES)),
            "a fit to a loop is not available with contact = 'attached'$",
        ),
        (
            lambda: fit(MOUNT, *[{"x": 0.01 * np.cos(TIMES), "t": TIMES, "deviation": 1e-4}] * 2),
            "more than one free decay",
        ),
        # what laws of damping and a load leave without an answer
        (
            lambda: tolerances(rubber, {"k_h": 0.1}, shock=(20, 0.01), answers=["A_shock"]),
            "A_shock is not available",
        ),
        (
            lambda: meet(LOADED, {"eta": (0.0, 0.1)}, at_least={"F_cr": 5.0}),
            "'eta' cannot be varied",
        ),
        (lambda: tolerances(LOADED, {"k_h": 0.1}, answers=["rests_within"]), "'rests_within' is not an answer"),
        (lambda: fit(LOADED, **backbone, free=["k_h"]), "a fit to a backbone is not available with a load"),
    ]
    for call, message in refused:
        with pytest.raises(ValueError, match=message):
            call()
    with pytest.raises(TypeError, match="'G' is not an argument: a load case has F, Y, a, U, F_0, f"):
        tolerances(SHAKEN, {"k_h": 0.1}, G=1.0)
    monkeypatch.setitem(sys.modules, "SALib", None)
    monkeypatch.setitem(sys.modules, "SALib.sample.sobol", None)
    with pytest.raises(ImportError, match=r"sobol needs SALib: pip install 'slowflow\[sizing\]'"):
        sobol(MOUNT, {"k_h": 0.1})


# ---- inverse design ------------------------------------------------------------------------------------------------


def test_nearest_of_two_free_numbers_lies_along_the_gradient():
    """A condition of the least distance along the edge of what is allowed, by differences of single answers."""
    free, start = {"k_h": (500.0, 2500.0), "zeta": (0.005, 0.1)}, {"k_h": 1700.0, "zeta": 0.02}
    found = meet(MOUNT, free, at_least={"F_SN": 4.0})
    assert found.reached["F_SN"] == pytest.approx(4.0, rel=1e-13)
    ratio = {}
    for name, (low, high) in free.items():
        step = 1e-4 * found.numbers[name]
        ends = [
            MOUNT.replace(**{**found.numbers, name: found.numbers[name] + s * step}).saddle_node_onset().F_SN
            for s in (-1, 1)
        ]
        away = (found.numbers[name] - start[name]) / (high - low) ** 2
        ratio[name] = (ends[1] - ends[0]) / (2 * step) / away
    assert ratio["k_h"] == pytest.approx(ratio["zeta"], rel=1e-6)


def test_a_design_that_meets_all_already_is_left_as_it_is():
    found = meet(
        MOUNT, {"zeta": (0.005, 0.1), "k_h": (500, 2500)}, at_least={"F_SN": 2.0}, at_most={"A_peak": 0.05}, F=5
    )
    assert found.numbers == pytest.approx({"zeta": 0.02, "k_h": 1700}, rel=1e-3)


@pytest.mark.parametrize("lowest", [0.02, 0.05])
def test_present_design_may_be_a_bound_or_outside(lowest):
    found = meet(MOUNT, {"zeta": (lowest, 0.1)}, at_least={"F_SN": 4.0})
    least = brentq(lambda zeta: MOUNT.replace(zeta=zeta).saddle_node_onset().F_SN - 4.0, 0.02, 0.05, xtol=1e-14)
    assert found.feasible and found.numbers["zeta"] == pytest.approx(max(least, lowest), rel=1e-9)
    assert found.design == MOUNT.replace(**found.numbers) and found.message == found.binding == ""


@pytest.mark.slow
def test_several_requirements_are_met_as_single_ones_see_them():
    found = meet(
        MOUNT,
        {"k_h": (500, 2500), "preload": (0.002, 0.02), "zeta": (0.01, 0.1)},
        at_least={"F_SN": 4.0},
        at_most={"f_rest": 1.9, "A_peak": 0.03},
        F=5,
    )
    one = found.design
    assert found.feasible and one.saddle_node_onset().F_SN >= 4 * (1 - 1e-8)
    assert one.at_rest().f_0 <= 1.9 * (1 + 1e-8) and one.peak(5).A <= 0.03 * (1 + 1e-8)
    assert found.reached["A_peak"] == pytest.approx(one.peak(5).A)


#: mounts, free numbers, a requirement (at most if negative), load cases; how near to it the design found is
REQUIRED = {
    "cubic spring": (CUBIC, {"zeta": (0.01, 0.3)}, {"F_SN": 30.0}, {}, 1e-6),
    "base": (SHAKEN, {"zeta": (0.02, 0.2)}, {"Y_SN": 2 * SHAKEN.saddle_node_onset().Y_SN}, {}, 1e-9),
    "unbalance": (UNBALANCED, {"zeta": (0.02, 0.2)}, {"U_SN": 2 * UNBALANCED.saddle_node_onset().U_SN}, {}, 1e-9),
    "load spectrum": (MOUNT, {"zeta": (0.01, 0.2)}, {"of_SN_spectrum": 1.1}, {"spectrum": TABLE}, 1e-6),
    "margin, by its gradient": (MOUNT, {"zeta": (0.01, 0.2)}, {"of_SN": 1.1}, {"F": 5.0}, 1e-12),
    "transmissibility": (MOUNT, {"k_h": (1000, 2500)}, {"transmissibility": -0.22}, {"F": 5.0, "f": 5.0}, 1e-6),
    "isolation": (MOUNT, {"preload": (0.002, 0.03)}, {"f_isolation": -2.6}, {"F": 2.0}, 1e-4),
    "eta": (MOUNT, {"eta": (0.0, 0.1)}, {"F_SN": 4.0}, {}, 1e-7),
    "c_2": (MOUNT, {"c_2": (0.0, 30.0)}, {"F_SN": 4.0}, {}, 1e-7),
    "load": (LOADED, {"preload": (0.005, 0.012)}, {"F_cr": 4.0}, {}, 1e-7),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", REQUIRED)
def test_the_nearest_design_just_meets_what_is_required(name):
    """By its single answers; the present design does not."""
    mount, free, required, case, near = REQUIRED[name]
    ((answer, limit),) = required.items()
    found = meet(mount, free, **{"at_least" if limit > 0 else "at_most": {answer: abs(limit)}}, **case)
    assert found.feasible and found.reached[answer] == pytest.approx(abs(limit), rel=near)
    assert single_answers(found.design, **case)[answer] == pytest.approx(abs(limit), rel=near)
    assert single_answers(mount, **case)[answer] * limit < limit * abs(limit)


def test_what_cannot_be_met_names_the_binding_requirement():
    found = meet(MOUNT, {"k_h": (500, 2500)}, at_least={"F_SN": 8.0}, at_most={"f_rest": 2.3})
    assert not found.feasible and found.binding == "F_SN >= 8 N"
    lines = str(found).splitlines()
    assert lines[0].split() == ["feasible", "False"] and lines[-1].endswith(found.message)
    assert f"F_SN          {found.reached['F_SN']:.4g} N" in lines
    assert "infeasible: the binding requirement is F_SN >= 8 N, whose closest achievable value is" in found.message
    for k_h in np.linspace(500, 2500, 50):  # none does
        assert MOUNT.replace(k_h=k_h).saddle_node_onset().F_SN < 8


@pytest.mark.parametrize("target", [5.0, 4e3, 1e300])
def test_unmeetable_requirement_is_approached_as_far_as_allowed(target):
    found = meet(MOUNT, {"zeta": (0.01, 0.03)}, at_least={"F_SN": target})  # the more damping the higher
    assert not found.feasible and found.numbers["zeta"] == pytest.approx(0.03, rel=1e-6)


def test_requirements_met_and_binding_print_in_millimetres():
    found = meet(MOUNT, {"preload": (0.001, 0.01)}, at_most={"A_peak": 0.03}, F=5)
    shown = found.in_units()
    assert found.binding == "A_peak <= 30 mm" and found.units == {"A_peak": "m", "preload": "m"}
    assert shown.reached["A_peak"] == pytest.approx(1000 * found.reached["A_peak"], rel=1e-14)
    assert shown.numbers == found.numbers and str(shown) == str(found) and shown.in_units() == shown
    assert f"A_peak        {shown.reached['A_peak']:.4g} mm" in str(found).splitlines()
    assert found.message.endswith(f"{shown.reached['A_peak']:.4g}")


# ---- trade-offs -----------------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_no_design_is_better_than_one_of_the_front():
    """Against designs drawn at random between the same ends."""
    free = {"k_h": (500.0, 2500.0), "preload": (0.002, 0.02)}
    found = front(MOUNT, free, high=["F_SN"], low=["f_rest"], at_least={"F_cr": 3.0}, points=5)
    draw = np.random.default_rng(2)
    k_h, preload = draw.uniform(500, 2500, 20_000), draw.uniform(0.002, 0.02, 20_000)
    tried = tolerances(
        MOUNT, {"k_h": Fixed(k_h), "preload": Fixed(preload)}, answers=["F_SN", "F_cr", "f_rest"], samples=20_000
    )
    F_SN, F_cr, f_rest = tried.samples.values()
    allowed = F_cr >= 3.0
    assert len(found) >= 4 and (np.diff(found.one) > 0).all() and (np.diff(found.other) > 0).all()
    assert str(found).splitlines()[0].split() == ["F_SN/N", "f_rest/Hz", "k_h/(N/m)", "preload/m"]
    for k, (one, other) in enumerate(found):
        design = found.design(k)
        assert (one, other) == pytest.approx((design.saddle_node_onset().F_SN, design.at_rest().f_0), rel=1e-11)
        assert design.detachment().F_cr >= 3.0 * (1 - 1e-8)
        assert not (allowed & (F_SN > one * 1.002) & (f_rest < other * 0.998)).any(), k
    # and it goes as far as any
    assert found.one[-1] >= 0.998 * F_SN[allowed].max() and found.other[0] <= 1.002 * f_rest[allowed].min()
    assert found.columns().keys() == {"F_SN", "f_rest", "k_h", "preload"} and str(found).startswith("F_SN/N")


class Fixed:
    """Values as they are, in place of a distribution."""

    def __init__(self, values):
        self.values = values

    def ppf(self, probability):
        return self.values


class OneByOne(Subject):
    """Designs that are evaluated one by one, as on NumPy or under a load, and counted."""

    count = 0

    def __init__(self, of, varied, at):
        super().__init__(of, varied, at)
        self.one_by_one = True

    def ask(self, values, names, load):
        names = list(names)
        OneByOne.count += len(names) * max((np.size(value) for value in values.values()), default=1)
        return super().ask(values, names, load)


@pytest.mark.slow
def test_slow_designs_are_found_by_gradient_steps(monkeypatch):
    """A front on NumPy took minutes, of tens of thousands of designs."""
    free = {"k_h": (500.0, 2500.0), "preload": (0.002, 0.02)}
    arguments = {"high": ["F_SN"], "low": ["f_rest"], "at_least": {"F_cr": 3.0}, "points": 4}
    many = front(MOUNT, free, **arguments)
    safe = meet(MOUNT, free, at_least={"F_SN": 3.5}, at_most={"f_rest": 2.0})
    monkeypatch.setattr("slowflow.sizing.requirements.Subject", OneByOne)
    few, OneByOne.count = front(MOUNT, free, **arguments), 0
    assert few.one == pytest.approx(many.one, rel=2e-3) and few.other == pytest.approx(many.other, rel=2e-3)
    again = front(MOUNT, free, **arguments)
    assert again == few and OneByOne.count < 3000  # numbers of designs, three of each
    one = meet(MOUNT, free, at_least={"F_SN": 3.5}, at_most={"f_rest": 2.0})
    assert one.feasible and one.numbers == pytest.approx(safe.numbers, rel=1e-9)
    nothing = front(MOUNT, {"k_h": (500, 2500)}, high=["F_SN"], low=["f_rest"], at_least={"F_cr": 80.0})
    assert len(nothing) == 0 and "the binding requirement is F_cr >= 80 N" in nothing.message


@pytest.mark.slow
def test_front_without_a_trade_off_is_one_design():
    """Damping and friction raise F_SN and lower the peak: the most of both is the best in both."""
    free = {"zeta": (0.01, 0.1), "friction": (0.1, 1.0)}
    found = front(MOUNT, free, high=["F_SN"], low=["A_peak"], F=5, points=5)
    assert len(found) == 1 and "no trade-off" in found.message
    assert [value[0] for value in found.numbers.values()] == pytest.approx([0.1, 1.0], rel=1e-6)


@pytest.mark.slow
def test_number_unknown_to_one_answer_is_best_for_the_other():
    """f_rest does not know the damping, which the peak is the lower for."""
    found = front(MOUNT, {"zeta": (0.01, 0.1), "k_h": (500, 2500)}, low=["A_peak", "f_rest"], F=5, points=5)
    shown = found.in_units()  # millimetres, and of these again millimetres
    assert found.units == ("m", "Hz") and shown.units == shown.in_units().units == ("mm", "Hz")
    assert shown.one == pytest.approx(1000 * found.one, rel=1e-14) and np.array_equal(shown.in_units().one, shown.one)
    assert str(shown) == str(found) and found.plot().get_xlabel().endswith("mm")
    assert len(found) == 5 and found.numbers["zeta"] == pytest.approx(0.1, rel=1e-2)


# ---- progress -------------------------------------------------------------------------------------------------------


def test_tolerances_log_how_far_they_are(monkeypatch, caplog):
    monkeypatch.setattr(progress, "EVERY", 0.0)
    monkeypatch.setattr(progress, "FRACTION", 0.0)
    with caplog.at_level("INFO", "slowflow"):
        tolerances(MOUNT, {"k_h": 0.05}, answers=["F_cr"], samples=6000)
    own = [one for one in caplog.messages if one.startswith("tolerances")]
    assert own == ["tolerances: 2000 of 6000", "tolerances: 4000 of 6000"]


# ---- fits ----------------------------------------------------------------------------------------------------------

START = {"friction": 0.3, "zeta": 0.03, "k_h": 1500, "preload": 0.010}
TRUE = {"friction": 0.4, "zeta": 0.02, "k_h": 1700, "preload": 0.009}


@pytest.mark.slow
def test_a_fit_recovers_the_numbers_behind_a_noisy_exact_sweep():
    """The sweep is one of the equation of motion, up and down: nothing averaged is in it."""
    f = np.concatenate([np.linspace(1.2, 2.25, 30), np.linspace(2.3, 4.0, 20), np.linspace(2.18, 1.2, 20)])
    forces = [4.0, 6.0]
    A = np.array([MOUNT.sweep(f=f, F=force).A for force in forces])
    noise = 1e-4 * np.random.default_rng(3).standard_normal(A.shape)
    found = fit(MOUNT.replace(**START), f=f, F=[[force] for force in forces], A=A + noise)
    for row in found:  # friction says least of itself; averaging misplaces k_h and preload by 1 %
        assert row.value == pytest.approx(TRUE[row.parameter], rel=0.1 if row.parameter == "friction" else 0.02), row
    assert found.deviation < 3e-4 and found.design.given["k_h"] == found.value[2] and found.message == ""


@pytest.mark.slow
def test_intervals_hold_the_true_numbers_in_95_of_100_fits():
    f = np.linspace(1.2, 4.0, 40)
    A = np.array([MOUNT.amplitudes(f=x, F=2.5).A[0] for x in f])
    random, covered = np.random.default_rng(0), []
    for _ in range(fewer(20, 4)):
        found = fit(MOUNT, f=f, F=2.5, A=A + 2e-5 * random.standard_normal(f.size))
        covered += [row.low < TRUE[row.parameter] < row.high for row in found]
    assert 0.87 < np.mean(covered) <= 1.0


def measured_together(random):
    """Points below the onset, jumps and a backbone of `MOUNT` with noise, each with its standard deviation."""
    f, F, A = np.linspace(1.2, 3.0, 25), np.array([3.5, 4.0, 5.0, 6.0]), np.linspace(0.004, 0.03, 8)
    up, down = np.transpose([MOUNT.saddle_nodes(force).f[[0, -1]] for force in F])
    points = np.array([MOUNT.amplitudes(f=x, F=2.5).A[0] for x in f])
    noise = random.standard_normal
    return (
        {"f": f, "F": 2.5, "A": points + 1e-4 * noise(25), "deviation": "0.1 mm"},
        {"F": F, "jump_up": up + 0.004 * noise(4), "jump_down": down + 0.004 * noise(4), "deviation": 0.004},
        {"A": A, "backbone": MOUNT.backbone(A) + 0.002 * noise(8), "deviation": 0.002},
    )


@pytest.mark.slow
def test_several_kinds_of_data_say_more_together():
    """The same noise in each kind's unit: intervals hold the truth and are narrower than those of the points alone."""
    random, covered, deviations = np.random.default_rng(1), [], []
    free = ["friction", "zeta", "k_h"]
    for _ in range(fewer(12, 3)):
        sets = measured_together(random)
        found = fit(MOUNT, *sets, free=free)
        covered += [row.low < TRUE[row.parameter] < row.high for row in found]
        deviations.append(found.deviation)
        assert found.residuals.size == 25 + 8 + 8 and not found.message
    assert np.mean(covered) > 0.8 and 0.8 < np.mean(deviations) < 1.2
    single = fit(MOUNT, **{name: value for name, value in sets[0].items() if name != "deviation"}, free=free)
    assert (found.high - found.low < 0.95 * (single.high - single.low)).all()
    assert found.plot().get_xlabel() == "point"


def test_a_backbone_without_noise_has_the_numbers_of_its_spring():
    A = np.linspace(0.004, 0.03, 8)
    found = fit(MOUNT.replace(k_h=1500, preload=0.010), A=A, backbone=MOUNT.backbone(A), free=["k_h", "preload"])
    assert found.value == pytest.approx([1700, 0.009], rel=1e-9)


def test_a_cubic_spring_is_found_from_its_backbone():
    """(2 pi f)^2 m = k_1 + 3/4 k_3 A^2; without a spring at the centre too."""
    A = np.linspace(0.005, 0.05, 12)
    for k_1, k_3 in ((2500.0, 4e5), (2500.0, -1e5), (0.0, 4e5)):
        f = np.sqrt((k_1 + 0.75 * k_3 * A**2) / 12) / (2 * np.pi)
        start = Duffing.physical(m=12, k_1=0.8 * k_1, k_3=1.3 * k_3)
        free = ["k_1", "k_3"] if k_1 else ["k_3"]
        found = fit(start, A=A, backbone=f, free=free)
        np.testing.assert_allclose(found.value, [k_1, k_3] if k_1 else [k_3], rtol=1e-9)


SPRING = {"friction": 0.4, "c": 8.0, "k_1": 2500.0, "k_3": 4e5}
TIMES = np.linspace(0.0, 4.0, 200)


def resisting_force(x, v):
    return SPRING["k_1"] * x + SPRING["k_3"] * x**3 + SPRING["friction"] * np.sign(v) + SPRING["c"] * v


@functools.cache
def decay():
    """12 kg on `SPRING`, released from 40 mm: by SciPy, from stop to stop; all forces over the mass."""
    own = {"mu": SPRING["friction"] / 12, "zeta": SPRING["c"] / 24}
    of_unit_mass = Duffing(SPRING["k_1"] / 12, SPRING["k_3"] / 12, **own)
    pull, options = lambda x: resisting_force(x, 0.0) / 12, {"rtol": 1e-10, "atol": 1e-12, "max_step": 1e-3}
    ways = list(by_time.stretches(of_unit_mass, pull, lambda t: 0.0, TIMES[[0, -1]], (0.04, 0.0), **options))
    t, x = (np.concatenate([getattr(one, name) for one in ways]) for name in "tu")
    return scipy.interpolate.CubicSpline(*(column[np.unique(t, return_index=True)[1]] for column in (t, x)))(TIMES)


def in_time(random):
    """A loop with a mean force, and a decay, with noise of their deviations."""
    x, v = 0.03 * np.sin(2 * np.pi * TIMES), 0.06 * np.pi * np.cos(2 * np.pi * TIMES)
    F = resisting_force(x, v) + 3.0 + 0.05 * random.standard_normal(TIMES.size)
    released = decay() + 1e-4 * random.standard_normal(TIMES.size)
    return {"x": x, "F": F, "t": TIMES, "deviation": 0.05}, {"x": released, "t": TIMES, "deviation": "0.1 mm"}


def of_spring(found):
    """Which intervals hold the truth."""
    truth = {**SPRING, "x_0": 0.04}
    return [row.low < truth[row.parameter] < row.high for row in found]


@pytest.mark.slow
def test_a_decay_and_a_loop_have_the_numbers_of_their_spring():
    """Each by itself, and together with narrower intervals; a loop's by the linear equations of `from_loop` too."""
    start = Duffing.physical(m=12, k_1=2400, k_3=3.5e5, friction=0.5, c=6)
    loop, free = in_time(np.random.default_rng(2))
    own = [{name: value for name, value in one.items() if name != "deviation"} for one in (loop, free)]
    by_loop, by_decay, together = fit(start, **own[0]), fit(start, **own[1]), fit(start, loop, free)
    assert by_decay.parameter.tolist() == ["friction", "c", "k_1", "k_3", "x_0"]
    linear = from_loop(**own[0])
    for row in linear:
        (same,) = (one for one in by_loop if one.parameter == row.parameter)
        assert same.value == pytest.approx(row.value, rel=1e-6) and same.error == pytest.approx(row.error, rel=0.01)
    assert np.mean(of_spring(by_loop) + of_spring(by_decay) + of_spring(together)) > 0.8
    for single in (by_loop, by_decay):
        for row in single:
            (both,) = (one for one in together if one.parameter == row.parameter)
            assert both.error < row.error * 1.05
    assert 0.85 < together.deviation < 1.15 and not by_decay.message


@pytest.mark.slow
def test_a_decay_that_begins_in_motion_has_a_message():
    """Without its first samples a decay does not begin at rest, as the fit assumes; alone, and beside a loop."""
    start = Duffing.physical(m=12, **SPRING)
    loop, free = in_time(np.random.default_rng(2))
    begun = {**free, "x": free["x"][25:], "t": TIMES[25:]}
    for sets in ([begun], [loop, begun]):
        assert "neighbouring residuals are correlated" in fit(start, *sets, free=["k_1", "c"]).message
        assert not fit(start, *sets[:-1], free, free=["k_1", "c"]).message


@pytest.mark.night
def test_intervals_of_decays_hold_the_truth_in_95_of_100():
    start = Duffing.physical(m=12, k_1=2500, k_3=4e5, friction=0.4, c=8)
    random, covered = np.random.default_rng(0), []
    for _ in range(200):
        covered += of_spring(fit(start, x=decay() + 1e-4 * random.standard_normal(TIMES.size), t=TIMES))
    assert 0.93 < np.mean(covered) < 0.97


def test_a_loop_across_the_stroke_has_the_springs_of_its_mount():
    """Quasi-static, without noise: the untruncated force of the push-rods, detached beyond the stroke."""
    x = 0.05 * np.sin(np.linspace(0, 4 * np.pi, 400))
    F = MOUNT.force(x) + 0.4 * np.sign(np.gradient(x))
    found = fit(MOUNT.replace(**START), x=x, F=F, free=["friction", "k_h", "preload"])
    assert found.value == pytest.approx([0.4, 1700, 0.009], rel=1e-6)


@pytest.mark.slow
def test_every_mechanism_is_fitted_by_its_own_numbers():
    """One that is derived at run time, from single answers on both sides of its breakpoint."""
    made = derive.library("bilinear")
    one = made(kappa=0.4, delta=0.2, mu=0.005, zeta=0.03)
    Omega = np.linspace(0.5, 1.5, 25)
    A = [one.amplitudes(Omega=at, F_0=0.05).A.max() for at in Omega]
    found = fit(made(kappa=0.5, delta=0.25, mu=0.004, zeta=0.04), Omega=Omega, F_0=0.05, A=A)
    assert found.parameter.tolist() == ["mu", "zeta", "kappa", "delta"]
    np.testing.assert_allclose(found.value, [0.005, 0.03, 0.4, 0.2], rtol=1e-9)


def test_one_data_set_is_weighted_by_nothing():
    """Its deviation cancels in all but the residuals."""
    A = np.linspace(0.004, 0.03, 8)
    one = {"A": A, "backbone": MOUNT.backbone(A) + 0.002 * np.cos(5 * np.arange(8))}
    plain, weighted = fit(MOUNT, **one, free=["k_h"]), fit(MOUNT, {**one, "deviation": 0.01}, free=["k_h"])
    np.testing.assert_allclose(
        [weighted.value, weighted.low, weighted.high], [plain.value, plain.low, plain.high], rtol=1e-6
    )
    np.testing.assert_allclose(weighted.residuals, plain.residuals / 0.01, rtol=1e-6)
    assert plain.names == ("A/m", "measured minus fitted f/Hz")


def test_interval_ends_by_students_t():
    """Of one number, with the sums of squares of this test's own residuals."""
    iso, Omega = isolator(), np.linspace(0.5, 1.5, 12)
    A = np.array([iso.amplitudes(Omega=x, F_0=0.021).A[0] for x in Omega])
    noisy = A * (1 + 0.05 * np.cos(7.0 * np.arange(12)))
    found = fit(iso, Omega=Omega, F_0=0.021, A=noisy, free=["zeta"])

    def square(zeta):
        states = iso.replace(zeta=float(zeta)).amplitudes(Omega=Omega, F_0=0.021)
        return float(np.sum((states.A - noisy) ** 2))

    least = square(found.value[0])
    for end in (found.low[0], found.high[0]):
        assert (square(end) / least - 1) * 11 == pytest.approx(scipy.stats.t.ppf(0.975, 11) ** 2, rel=0.05)
    assert found.message == ""


@pytest.mark.slow
@pytest.mark.parametrize(("fraction", "noise", "seed"), [(0.8, 0.01, 3), (1.3, 0.02, 0)])
def test_intervals_hold_every_design_that_the_points_allow(fraction, noise, seed):
    """Below the onset r and delta_h make up for each other; above it the sum of squares jumps as a fold passes a point.

    Allowed is what leaves no more than the least sum of squares times 1 + t^2/26, by this test's own residuals.
    """
    iso, random, free = isolator(), np.random.default_rng(seed), ["zeta", "mu", "delta_h", "r"]
    F_0 = fraction * iso.saddle_node_onset().F_SN
    Omega, true = np.linspace(0.6, 1.5, 30) * iso.peak(F_0).Omega, np.array([iso.given[name] for name in free])

    def amplitudes(designs):
        many = Isolator.many(lam=3, **dict(zip(free, designs.T[..., np.newaxis], strict=True)))
        found = many.amplitudes(Omega=Omega, F_0=F_0)
        return np.where(found.stable == 1, found.A, np.nan)

    A = np.nanmax(amplitudes(true[np.newaxis])[0], axis=-1)
    noisy = A + noise * A.max() * random.standard_normal(A.size)
    start = dict(zip(free, true * np.exp(random.uniform(-0.3, 0.3, 4)), strict=True))
    found = fit(iso.replace(**start), Omega=Omega, F_0=F_0, A=noisy, free=free)
    # along the product r delta_h, which is the preload's share of the stiffness, and about the truth
    steps = np.exp(10 ** random.uniform(-4.0, -1.5, (4000, 1)) * random.standard_normal((4000, 4)))
    steps[:2000, 2:] *= np.exp(random.uniform(-1.0, 1.0, (2000, 1))) ** [1, -1]
    designs = np.concatenate((true[np.newaxis], true * steps, found.value * steps))
    square = np.nansum(np.nanmin((amplitudes(designs) - noisy[:, np.newaxis]) ** 2, axis=-1), axis=-1)
    allowed = designs[square <= np.sum(found.residuals**2) * (1 + scipy.stats.t.ppf(0.975, 26) ** 2 / 26)]
    assert len(allowed) > 20
    middle, half = 0.5 * (found.low + found.high), 0.5 * (found.high - found.low)
    assert (np.abs(allowed - middle) <= 1.03 * half).all()


@pytest.mark.slow
def test_undetermined_numbers_have_endless_intervals():
    """At one point friction and damping stand for each other: F_0^2 = R^2 + (2 zeta A Omega + 4 mu/pi)^2."""
    iso = isolator()
    (A,) = iso.amplitudes(Omega=0.6, F_0=0.021).A
    noisy = A * (1 + 1e-3 * np.cos(7.0 * np.arange(8)))
    try:
        found = fit(iso, Omega=0.6, F_0=0.021, A=noisy, free=["mu", "zeta"])
    except NotSettled as error:
        assert "the points do not determine mu, zeta" in str(error)
    else:
        assert "the points do not determine" in found.message and (found.low == 0).any()


@pytest.mark.slow
def test_a_fit_leaves_a_local_minimum_and_says_so():
    """On the upper branch of a curve that jumps; a fit is no worse than the known truth."""
    iso, random, local = isolator(), np.random.default_rng(7), 0
    free = ["mu", "zeta", "r", "delta_h"]
    for _ in range(5):
        F_0 = iso.saddle_node_onset().F_SN * random.uniform(1.0, 1.6)
        peak = iso.peak(F_0)
        Omega = np.linspace(0.6, 1.5, 30) * peak.Omega
        A = np.array([one.A[one.stable].max() for one in (iso.amplitudes(Omega=x, F_0=F_0) for x in Omega)])
        noise = 0.01 * A.max() * random.standard_normal(A.size)
        start = {name: iso.given[name] * np.exp(random.uniform(-0.7, 0.7)) for name in free}
        found = fit(iso.replace(**start), Omega=Omega, F_0=F_0, A=A + noise, free=free)
        assert np.sum(found.residuals**2) <= np.sum(noise**2)  # the truth is no worse than what is found
        local += "a search from the given start ends" in found.message
    assert local


@pytest.mark.slow
def test_fit_to_exact_jumps_recovers_the_numbers():
    """Folds of the exact curve, which no averaging is in; and of averaging itself, without noise, exactly."""
    forces = [3.0, 3.5, 4.0, 5.0, 7.0]
    rate = MOUNT.scales.sizes["frequency"]
    exact = np.array([MOUNT.saddle_nodes(force).answer.measure().Omega for force in forces]) * rate
    found = fit(MOUNT.replace(**START), F=forces, jump_up=exact[:, 0], jump_down=exact[:, -1])
    for row in found:  # friction says least of itself
        assert row.value == pytest.approx(TRUE[row.parameter], rel=0.25 if row.parameter == "friction" else 0.05), row
    assert found.residuals.size == 10 and found.names == ("F/N", "measured minus fitted f/Hz")
    averaged = np.array([MOUNT.saddle_nodes(force).f for force in forces])
    seen = np.where(np.arange(5) == 2, np.nan, averaged[:, 1])
    found = fit(MOUNT.replace(**START), F=forces, jump_up=averaged[:, 0], jump_down=seen)
    assert found.value.tolist() == pytest.approx(list(TRUE.values()), rel=1e-6) and found.residuals.size == 9


def test_a_fit_to_numbers_in_other_units_says_that_it_is_none():
    forces = [3.5, 4.0, 5.0, 6.0]
    message = fit(MOUNT, F=forces, jump_up=[20.0, 21.0, 22.0, 23.0], jump_down=[20.1, 21.2, 22.3, 23.4]).message
    assert message.startswith("no fit: ") and "preload left the range" in message and "units" in message


def test_residuals_of_a_fit_are_drawn_at_their_frequencies():
    pytest.importorskip("matplotlib")
    f = np.linspace(1.2, 4.0, 12)
    A = np.array([MOUNT.amplitudes(f=x, F=2.5).A[0] for x in f])
    found = fit(MOUNT, f=f, F=2.5, A=A * (1 + 1e-3 * np.sin(np.arange(12))), free=["zeta"])
    ax = found.plot()
    points = ax.get_lines()[-1].get_xydata()
    assert points[:, 0].tolist() == f.tolist() and points[:, 1] == pytest.approx(1000 * found.residuals, rel=1e-15)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("frequency $f$ / Hz", "measured minus fitted A / mm")


@pytest.mark.slow
@pytest.mark.parametrize("of", ["A", "phi"])
def test_a_fit_without_dimensions_and_without_noise_is_exact(of):
    """Phases may differ by whole cycles."""
    iso, Omega = isolator(), np.linspace(0.3, 2.0, 40)
    cycles = np.arange(40) % 3 - 1 if of == "phi" else 0
    measured = getattr(iso.amplitudes(Omega=Omega, F_0=0.021), of) + 2 * np.pi * cycles
    found = fit(iso.replace(mu=0.01, zeta=0.025, r=1.9), Omega=Omega, F_0=0.021, **{of: measured})
    assert found.parameter.tolist() == ["mu", "zeta", "r", "delta_h"]
    assert found.value.tolist() == pytest.approx([iso.mu, iso.zeta, iso.r, iso.delta_h], rel=1e-6)
    assert found.names == ("Omega", f"measured minus fitted {of}") and np.abs(found.residuals).max() < 1e-7
    assert np.diag(found.correlation) == pytest.approx(1.0)


def test_an_isolator_without_preload_is_sized():
    iso = Isolator(lam=3, r=2.0, delta_h=0, mu=0.03, zeta=0.01)
    (row,) = tolerances(iso, {"zeta": 0.1}, F_0=0.1, answers=["A_peak"], samples=100)
    assert row.nominal == iso.peak(0.1).A and row.low < row.nominal < row.high


def test_fit_to_linear_phases_finds_friction_and_damping():
    """(1 - Omega^2)^2 A^2 + I^2 = F_0^2 with I = 2 zeta A Omega + 4 mu/pi, and sin phi = -I/F_0."""
    Omega, F_0, m = np.array([0.6, 0.9, 1.1, 1.5]), 0.1, 0.12 / np.pi
    viscous, square = 0.02 * Omega, (1 - Omega**2) ** 2 + (0.02 * Omega) ** 2
    A = (np.sqrt((viscous * m) ** 2 + square * (F_0**2 - m**2)) - viscous * m) / square
    lag = np.arcsin((viscous * A + m) / F_0)
    start = Isolator(lam=3, r=2.0, delta_h=0, mu=0.02, zeta=0.02)
    found = fit(start, Omega=Omega, F_0=F_0, phi=-np.where(Omega < 1, lag, np.pi - lag), free=["mu", "zeta"])
    assert found.value.tolist() == pytest.approx([0.03, 0.01], rel=1e-9)


def test_designs_under_a_load_stick_where_they_stand():
    found = tolerances(isolator(load=0.03), {"load": 0.1}, F_0=0.01, answers=["stroke", "A_peak"], samples=2)
    assert found.samples["A_peak"].tolist() == [0.0, 0.0]
    equilibria = [isolator(load=float(load)).rest().u[0] for load in found.drawn["load"]]
    assert found.samples["stroke"].tolist() == pytest.approx(equilibria, rel=1e-14)


@pytest.mark.slow
def test_a_fit_under_a_load_has_the_numbers_of_its_design():
    """Amplitudes, phases and jumps of one design without noise, from another load too."""
    one, Omega = Duffing(1.0, 0.5, mu=0.01, zeta=0.03, load=0.2), np.linspace(0.6, 1.6, 4)
    folds, states = one.saddle_nodes(0.12), [one.amplitudes(Omega=at, F_0=0.06) for at in Omega]
    sets = [
        {name: [getattr(found, name)[found.stable][0] for found in states], "Omega": Omega, "F_0": 0.06}
        for name in ("A", "phi")
    ]
    sets += [
        {name: folds.Omega[folds.kind == name.replace("_", "-")], "F_0": 0.12} for name in ("jump_up", "jump_down")
    ]
    free = ["load", "zeta", "beta"]
    start = one.replace(load=0.19, zeta=0.035, beta=0.55)
    found = fit(start, *({**each, "deviation": 0.001} for each in sets), free=free)
    assert found.value == pytest.approx([one.given[name] for name in free], rel=1e-7)
    assert found.design.load == found.value[0] and not found.message


def of_linear_spring(load):
    """A fit of its damping; the load moves the mean alone."""
    one, Omega = Duffing(1.0, 0.0, mu=0.01, zeta=0.05), np.linspace(0.7, 1.4, 15)
    A = one.amplitudes(Omega=Omega, F_0=0.05).A * (1 + 0.02 * np.cos(np.arange(15) ** 2))
    return fit(one.replace(zeta=0.03, load=load), A=A, Omega=Omega, F_0=0.05, free=["zeta"])


@pytest.mark.slow
def test_a_load_on_a_linear_spring_leaves_its_fit_alone():
    """With as many starts, and intervals of the same likelihood, whose ends are looked for to a hundredth."""
    without, found = of_linear_spring(0.0), of_linear_spring(0.3)
    np.testing.assert_allclose(found.value, without.value, rtol=1e-6)
    for end in (found.low - without.low, found.high - without.high):
        assert (np.abs(end) < 0.02 * (without.high - without.low)).all()
    assert not found.message and not np.allclose(found.high - found.value, found.value - found.low, rtol=0.01)


@pytest.mark.slow
def test_states_that_a_search_misses_are_reported(monkeypatch):
    """The residuals are those of the motions that are proved: here the search sees two amplitudes alone."""
    one, Omega = Duffing(1.0, 0.6, zeta=0.02, load=0.2), np.linspace(1.0, 1.5, 8)
    states = [one.amplitudes(Omega=at, F_0=0.1) for at in Omega]
    A = np.array([found.A[found.stable].max() for found in states])
    monkeypatch.setattr(by_amplitudes, "NODES", 2)
    monkeypatch.setattr(by_amplitudes, "FINE", 1)
    found = fit(one, A=A, Omega=Omega, F_0=0.1, free=["zeta"])
    assert "points the motions of the fitted design, which are proved" in found.message


@pytest.mark.slow
def test_a_mass_at_rest_has_no_phase_in_a_fit():
    """Its proved state has one by definition, which the search does not miss: friction holds it at three points."""
    one, Omega = Duffing(1.0, 0.5, mu=0.02, zeta=0.03, excitation="base"), np.linspace(0.4, 1.6, 14)
    phi = [states.phi[states.stable][-1] for states in (one.amplitudes(Omega=at, F_0=0.06) for at in Omega)]
    found = fit(one, phi=phi, Omega=Omega, F_0=0.06, free=["zeta"])
    assert found.message.endswith("the fitted design has no such motion, or jump, at 3 of the 14 points")
    assert "proved" not in found.message


def test_a_decay_under_a_load_has_the_numbers_of_its_spring():
    """u'' + 2 zeta u' + alpha u + beta u^3 = load, by SciPy, from rest at .5."""
    alpha, beta, zeta, load, t = 1.0, 0.6, 0.03, 0.2, np.linspace(0, 40, 150)
    options = {"t_eval": t, "rtol": 1e-11, "atol": 1e-12}
    pulls = lambda _, y: (y[1], load - 2 * zeta * y[1] - alpha * y[0] - beta * y[0] ** 3)  # noqa: E731
    x = scipy.integrate.solve_ivp(pulls, t[[0, -1]], (0.5, 0.0), **options).y[0]
    found = fit(Duffing(1.02, 0.55, zeta=0.04, load=0.21), x=x, t=t, free=["alpha", "beta", "zeta", "load"])
    assert found.value == pytest.approx([alpha, beta, zeta, load, 0.5], rel=1e-7)


def test_static_friction_is_sized_and_changes_no_average():
    grips = MOUNT.replace(static_friction=0.6)
    one, other = (tolerances(mount, {"k_h": 0.05, "friction": 0.2}, F=5, samples=200) for mount in (grips, MOUNT))
    averaged = [name not in ("break_loose", "rests_within") for name in other.answer]
    assert np.array_equal(one.low[averaged], other.low[averaged])
    assert np.array_equal(one.high[averaged], other.high[averaged])
    found = meet(grips, {"zeta": (0.01, 0.1)}, at_least={"F_SN": 4.0})
    assert found.feasible and found.design.given["static_friction"] == 0.6
    assert found.numbers == meet(MOUNT, {"zeta": (0.01, 0.1)}, at_least={"F_SN": 4.0}).numbers
    plain = tolerances(isolator(mu_s=0.02), {"mu_s": 0.1}, answers=["break_loose"], samples=9)
    assert np.array_equal(plain.samples["break_loose"], plain.drawn["mu_s"])


@pytest.mark.parametrize("static", [0.5, 0.0])
def test_less_static_than_kinetic_friction_is_no_design(static):
    mount = MOUNT.replace(friction=min(static, 0.4), static_friction=static)
    found = tolerances(mount, {"friction": scipy.stats.uniform(0.3, 0.4)}, answers=["F_SN", "break_loose"], samples=100)
    for name in found.answer:
        assert np.array_equal(np.isnan(found.samples[name]), found.drawn["friction"] > static)
    if static:  # with as much friction as that it is not met
        assert not meet(mount, {"friction": (0.1, 0.6)}, at_least={"F_SN": 4.0}).feasible
        with pytest.raises(ValueError, match=r"static_friction = 0.5 is not allowed: .* >= 0.6"):
            mount.replace(friction=0.6)


@pytest.mark.parametrize("laws", [{"eta": 0.5}, {"c_2": 0.5}])
def test_other_laws_are_sized_on_a_base_with_rising_amplitude(laws):
    """Over-damped: what lifts the springs, and the amplitude, are only tended to, with quadratic damping more slowly.

    What is tended to has inertia and quadratic damping, with 8/(3 pi) of its amplitude, against the base's.
    """
    design = {"lam": 3, "r": 0.68, "delta_h": 0.1125, "mu": 0.002, "zeta": 0.9, "excitation": "base", **laws}
    shaken = Isolator(**design)
    found = tolerances(shaken, dict.fromkeys(laws, 0.1), F_0=0.2, answers=["F_cr", "A_peak"], samples=2)
    for k in range(2):
        d = 8 * found.drawn.get("c_2", np.zeros(2))[k] / (3 * np.pi)
        A = found.samples["A_peak"][k]
        assert np.hypot(A, d * A**2) == pytest.approx(0.2, rel=1e-12)
        assert found.samples["F_cr"][k] == pytest.approx(np.hypot(shaken.u_cr, d * shaken.u_cr**2), rel=1e-12)
