"""Forces of any kind, compiled: averages against certified values, answers against those of NumPy's solvers."""

from __future__ import annotations

import dataclasses
import json
import math
import subprocess
import sys
from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from slowflow import backend, derive, exact, include
from slowflow_kernels.conventions import Status
from slowflow_support.quadrature import COMPILED
from tests.native.headers import COMPILER
from tests.native.records import Interval, doubles, opened
from tests.oracles import exact_reference
from tests.test_forces import ABOVE_0, CASES, DAMPING, FORCES, MORE, c, k, u


def on_numpy(made):
    """The same force by a record that is not the generated one, which nothing in C answers for."""
    COMPILED.pop(getattr(sys.modules[made.record.pieces[0].force.__module__], "averaged_of", None), None)
    made.record = dataclasses.replace(made.record, title=f"{made.record.title} on NumPy")
    return made


@pytest.fixture(scope="module")
def derived():
    """Each mechanism, derived once: compiled, and under another name as only NumPy's solvers and sums know it."""
    made = {}

    def get(name, compile=True):
        if (name, compile) not in made:
            pieces, numbers = {**FORCES, **MORE}[name]
            reach = {"reach": 3.1} if name == "pendulum" else {}
            full = f"{name}_in_C" if compile else name
            one = derive.mechanism(full, pieces, dict.fromkeys(numbers, ABOVE_0), compile=compile, **reach)
            made[name, compile] = one if compile else on_numpy(one)
        return made[name, compile]

    return get


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted({case["force"] for case in CASES}))
@pytest.mark.part(4)
def test_a_compiled_average_and_its_slopes_are_right_to_rounding(derived, name, monkeypatch):
    """Error over u (1 + kappa), as on NumPy, which is not asked."""
    monkeypatch.setattr("slowflow_support.quadrature._sums", None)
    record = derived(name).record
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
                assert abs(mp.mpf(float(one)) / mp.mpf(text) - 1) < 4 * 2.0**-53 * (1 + condition), (case, float(one))


#: of an answer: what is a number, to roundings of the search, and what is not
NUMBERS, WORDS = ("F_SN", "F_cr", "Omega", "A"), ("kind", "corner", "stable", "message", "remarks")


def same(one, other):
    """Whether two answers are one to some roundings of the averages."""
    for field in NUMBERS:
        here, there = getattr(one, field, None), getattr(other, field, None)
        assert (here is None) == (there is None), (field, one, other)
        if here is not None:
            np.testing.assert_allclose(there, here, rtol=1e-12, err_msg=field)
    for field in WORDS:
        np.testing.assert_array_equal(getattr(one, field, None), getattr(other, field, None), err_msg=field)


@pytest.mark.slow
@pytest.mark.parametrize("name", FORCES)
@pytest.mark.part(4)
def test_compiled_solvers_give_the_answers_of_those_on_numpy(derived, name):
    one, other = (derived(name, compile)(**FORCES[name][1], **DAMPING) for compile in (False, True))
    assert one.model.native is None
    assert other.model.native is not None
    for F_0 in (0.05, 0.3):
        same(one.saddle_nodes(F_0), other.saddle_nodes(F_0))
        same(one.peak(F_0), other.peak(F_0))
    same(one.saddle_node_onset(), other.saddle_node_onset())
    same(one.detachment(), other.detachment())
    same(one.cusps(A_max=2.5), other.cusps(A_max=2.5))
    frequencies = [0.3, 0.8, 1.0, 1.4, 2.3]
    same(one.amplitudes(Omega=frequencies, F_0=0.3), other.amplitudes(Omega=frequencies, F_0=0.3))
    if name != "preload" and name != "wave":  # which jumps at rest, and which has more folds than there are places in C
        same(*(each.replace(excitation="base").saddle_nodes(0.3) for each in (one, other)))
    for curve in (one.frequency_response(0.3), other.frequency_response(0.3)):
        assert len(curve) > 900
        H = -derived(name, False).record.averaged(curve.A, *one.model.parameters)[0]
        balance = np.hypot(curve.A * curve.Omega**2 - H, 2 * 0.03 * curve.A * curve.Omega + one.model.m)
        np.testing.assert_allclose(balance, 0.3, rtol=1e-9)
    assert one.frequency_response(0.3).message == other.frequency_response(0.3).message


@pytest.mark.slow
def test_compiled_onsets_are_those_of_numpy_where_h_bends_without_bound_at_rest(derived):
    """And where there is no stiffness at rest."""
    for damping in (DAMPING, {"mu": 0.01, "zeta": 0.2}):
        one, other = (derived("power", compile)(k=0.5, p=1.5, **damping) for compile in (False, True))
        same(one.saddle_node_onset(), other.saddle_node_onset())


@pytest.mark.slow
def test_many_designs_are_single_ones_and_have_their_gradients(derived):
    """Those of NumPy's solvers."""
    numbers = {**FORCES["soft_stop"][1], "k": np.array([2.5, 3.0])}
    many = derived("soft_stop").many(**numbers, **DAMPING)
    one = derived("soft_stop", compile=False)(**FORCES["soft_stop"][1], **DAMPING)
    assert many.saddle_node_onset().F_SN[1] == pytest.approx(one.saddle_node_onset().F_SN, rel=1e-13)
    folds, there = one.saddle_nodes(0.3), many.saddle_nodes(0.3)
    np.testing.assert_allclose(there.Omega[1][: len(folds)], folds.Omega, rtol=1e-13)
    moves, other = (
        folds.gradient(),
        derived("soft_stop")(**FORCES["soft_stop"][1], **DAMPING).saddle_nodes(0.3).gradient(),
    )
    for by in FORCES["soft_stop"][1]:
        np.testing.assert_allclose(other["Omega", by], moves["Omega", by], rtol=1e-10)


@pytest.mark.slow
@pytest.mark.parametrize("name", FORCES)
def test_in_C_an_interval_of_amplitudes_encloses_the_average_and_what_bends_it(derived, name):
    """Between any two amplitudes of a piece; h_AAAA by differences of h_AAA."""
    one = derived(name)(**FORCES[name][1], **DAMPING)
    record, p = opened(backend.record_of(derived(name).record)), doubles(one.model.parameters)
    edges = sorted({1e-3, *one.model.breakpoints, 0.1, 0.3, 0.31, 0.8, 1.5, 3.0})
    for low, high in pairwise(edges):
        found = (Interval * 2)()
        record.ask("bent", Interval(low, high), p, found)
        inside = np.linspace(low, high, 12)[1:-1]
        h, _, _, h_AAA = one.model.averaged(inside)
        assert np.all(found[0].lo <= h) and np.all(h <= found[0].hi)
        slopes = np.diff(h_AAA) / np.diff(inside)
        slack = 1e-9 * (1 + np.abs(slopes))
        assert np.all(found[1].lo <= slopes + slack) and np.all(slopes - slack <= found[1].hi)
        if low not in (1e-3, *one.model.breakpoints):  # at a breakpoint it is infinite
            assert np.isfinite([found[1].lo, found[1].hi]).all()


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(FORCES))
def test_exact_motions_are_those_of_another_integrator(derived, name):
    """Below resonance and above: switches, amplitude, multipliers; interpreted, with the same bits."""
    numbers = FORCES[name][1]
    system, plain = (derived(name, how)(**numbers, **DAMPING).equation_of_motion() for how in (True, False))
    for Omega in (0.5, 1.4):
        found, same = (exact.steady_state(one, Omega=Omega, F_0=0.2) for one in (system, plain))
        assert found.A == same.A and np.array_equal(found.multipliers, same.multipliers)
        other = exact_reference.again(found, exact_reference.ScipyIntegrator())
        assert found.residual <= 1e-13
        assert other.A == pytest.approx(found.A, rel=1e-9)
        assert np.max(np.abs(other.multipliers - found.multipliers)) <= 1e-8


@pytest.mark.slow
def test_a_curve_goes_on_where_the_mass_first_touches_a_contact(derived):
    """The order of switches changes there; between the folds motions are unstable by SciPy too."""
    one = derived("hertz")(k=5.0, gap=0.2, mu=0.0, zeta=0.03)
    curve = one.exact_response(F_0=0.05, Omega=(0.5, 1.8))
    touches = [place for place in curve.borders if place[1] == pytest.approx(0.2, abs=1e-12)]
    assert len(touches) == 2 and [fold.kind for fold in curve.folds] == ["jump-up", "jump-down"]
    # up to the contact the spring is linear
    for Omega, _ in touches:
        assert math.hypot(1 - Omega**2, 0.06 * Omega) == pytest.approx(0.05 / 0.2, rel=1e-9)
    scipy = exact_reference.ScipyIntegrator()
    between = np.flatnonzero(~curve.stable)
    for state in map(curve.steady_state, (int(between[1]), int(between[between.size // 2]))):
        other = exact_reference.again(state, scipy)
        assert other.A == pytest.approx(state.A, rel=1e-10) and max(other.multipliers.real) > 1
        np.testing.assert_allclose(np.sort(other.multipliers), np.sort(state.multipliers), atol=1e-9)


@pytest.mark.slow
def test_an_average_that_does_not_settle_is_no_answer():
    """A step that is steeper than any panel: both kinds of solvers refuse, and the average says why."""
    pieces = [(u + sp.tanh(k * (u - c)), None)]
    step = derive.mechanism("step", pieces, {"k": ABOVE_0, "c": ABOVE_0}, compile=True)
    with pytest.raises(ArithmeticError, match=r"the average at A = 0.5\d* does not settle"):
        step.record.averaged(0.5, 1e9, 0.3)
    with pytest.raises(ArithmeticError, match=r"the average .*does not settle"):
        step(k=1e9, c=0.3, **DAMPING).saddle_nodes(1.5)


def test_what_is_written_for_other_programs_compiles_alone(derived, tmp_path):
    """The headers, and a table of what is there: C only."""
    names = derived("wave", compile=False).write(tmp_path)
    header = next(name for name in names if name.endswith(".h") and "intervals" not in name)
    prefix = header.removesuffix(".h")
    (tmp_path / "user.c").write_text(
        f'#include <stdio.h>\n#include "{header}"\n'
        "int main(void) {\n    double p[2] = {0.3, 5.0}, h[4];\n"
        f"    {prefix}_averaged(0.9, p, h);\n"
        '    printf("%.17g\\n", h[0]);\n    return 0;\n}\n'
    )
    includes = [f"-I{place}" for place in (tmp_path, *include())]
    command = [COMPILER, "-std=c11", "-Wall", "-Wextra", "-Werror", "-O1", "-ffp-contract=off", *includes, "user.c"]
    subprocess.run([*command, "-o", "user", "-lm"], check=True, cwd=tmp_path)
    found = float(subprocess.run([tmp_path / "user"], check=True, capture_output=True, text=True).stdout)
    case = next(case for case in CASES if case["force"] == "wave" and case["A"] == 0.9)
    assert found == pytest.approx(float(case["h"][0]), rel=1e-14)
    assert json.loads((tmp_path / "MANIFEST.json").read_text())["files"].keys() >= {header}


@pytest.mark.slow
def test_batches_refuse_a_pole_within_the_reach_as_single_designs_do():
    """Magnets that are nearer than the reach: compiled batches summed over the pole, and said OK."""
    pieces = [(u + k * (1 / (c - u) ** 2 - 1 / (c + u) ** 2), None)]
    magnets = derive.mechanism("near_magnets", pieces, {"k": {"above": 0}, "c": {"above": 0}}, reach=3.9, compile=True)
    with pytest.raises(ValueError, match=r"infinite or no number at \|u\| = 3"):
        magnets(k=10.0, c=3.0, mu=0.01, zeta=0.03)
    several = magnets.many(k=10.0, c=np.array([4.5, 3.0, 3.8999, 4.0, -1.0]), mu=0.01, zeta=0.03)
    expected = [Status.OK, Status.INVALID, Status.INVALID, Status.OK, Status.INVALID]
    for found in (several.saddle_nodes(0.1), several.amplitudes(Omega=1.0, F_0=0.1), several.saddle_node_onset()):
        assert found.status.tolist() == expected
    found, alone = several.amplitudes(Omega=1.0, F_0=0.1), magnets(k=10.0, c=4.5, mu=0.01, zeta=0.03)
    assert np.isnan(found.A[[1, 2, 4]]).all()
    assert found.A[0, 0] == alone.amplitudes(Omega=1.0, F_0=0.1).A[0]
