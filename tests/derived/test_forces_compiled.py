"""Forces of any kind, compiled: averages against certified values, curves against averages."""

from __future__ import annotations

import json
import math
import subprocess
from itertools import pairwise

import numpy as np
import pytest
import sympy as sp

from slowflow import derive, exact, include
from slowflow.core import backend
from slowflow_kernels.conventions import Status
from tests.derived.test_forces import ABOVE_0, CASES, DAMPING, FORCES, c, derived, k, names_of, u
from tests.native.compiler import COMPILER
from tests.native.records import bent
from tests.oracles import exact_reference


@pytest.mark.slow
@pytest.mark.parametrize("name", FORCES)
@pytest.mark.part(4)
def test_a_curve_lies_where_the_average_has_it(name):
    one = derived(name, True)(**FORCES[name][1], **DAMPING)
    curve = one.frequency_response(0.3)
    assert len(curve) > 900
    H = -one.model.averaged(curve.A)[0]
    balance = np.hypot(curve.A * curve.Omega**2 - H, 2 * 0.03 * curve.A * curve.Omega + one.model.m)
    np.testing.assert_allclose(balance, 0.3, rtol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("name", FORCES)
@pytest.mark.part(3)
def test_compiled_interval_encloses_the_average_and_its_bend(name):
    """Between any two amplitudes of a piece; h_AAAA by differences of h_AAA."""
    one = derived(name, True)(**FORCES[name][1], **DAMPING)
    record = backend.record_of(derived(name, True).record)
    edges = sorted({1e-3, *one.model.breakpoints, 0.1, 0.3, 0.31, 0.8, 1.5, 3.0})
    for low, high in pairwise(edges):
        of_h, bend = bent(record, one.model, low, high)
        inside = np.linspace(low, high, 12)[1:-1]
        h, _, _, h_AAA = one.model.averaged(inside)
        assert np.all(of_h[0] <= h) and np.all(h <= of_h[1])
        slopes = np.diff(h_AAA) / np.diff(inside)
        slack = 1e-9 * (1 + np.abs(slopes))
        assert np.all(bend[0] <= slopes + slack) and np.all(slopes - slack <= bend[1])
        if low not in (1e-3, *one.model.breakpoints):  # at a breakpoint it is infinite
            assert np.isfinite(bend).all()


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(FORCES))
def test_exact_motions_are_those_of_another_integrator(name):
    """Below resonance and above: switches, amplitude, multipliers; interpreted, with the same bits."""
    numbers = FORCES[name][1]
    system, plain = (derived(name, how)(**numbers, **DAMPING).equation_of_motion() for how in (True, False))
    for Omega in (0.5, 1.4):
        found, same = (exact.steady_state(one, Omega=Omega, F_0=0.2) for one in (system, plain))
        assert found.A == same.A and np.array_equal(found.multipliers, same.multipliers)
        other = exact_reference.again(found)
        assert found.residual <= 1e-13
        assert other.A == pytest.approx(found.A, rel=1e-9)
        assert np.max(np.abs(other.multipliers - found.multipliers)) <= 1e-8


@pytest.mark.slow
def test_a_curve_goes_on_where_the_mass_first_touches_a_contact():
    """The order of switches changes there; between the folds motions are unstable by SciPy too."""
    one = derived("hertz", True)(k=5.0, gap=0.2, mu=0.0, zeta=0.03)
    curve = one.exact_response(F_0=0.05, Omega=(0.5, 1.8))
    touches = [place for place in curve.borders if place[1] == pytest.approx(0.2, abs=1e-12)]
    assert len(touches) == 2 and [fold.kind for fold in curve.folds] == ["jump-up", "jump-down"]
    # up to the contact the spring is linear
    for Omega, _ in touches:
        assert math.hypot(1 - Omega**2, 0.06 * Omega) == pytest.approx(0.05 / 0.2, rel=1e-9)
    between = np.flatnonzero(~curve.stable)
    for state in map(curve.steady_state, (int(between[1]), int(between[between.size // 2]))):
        other = exact_reference.again(state)
        assert other.A == pytest.approx(state.A, rel=1e-10) and max(other.multipliers.real) > 1
        np.testing.assert_allclose(np.sort(other.multipliers), np.sort(state.multipliers), atol=1e-9)


@pytest.mark.slow
def test_an_average_that_does_not_settle_is_no_answer():
    """A step that is steeper than any panel: both kinds of solvers refuse, and the average says why."""
    pieces = [(u + sp.tanh(k * (u - c)), None)]
    step = derive.mechanism("step", pieces, {"k": ABOVE_0, "c": ABOVE_0}, compile=True)
    with pytest.raises(ArithmeticError, match=r"the average at A = 0.5\d* does not converge"):
        step.record.averaged(0.5, 1e9, 0.3)
    with pytest.raises(ArithmeticError, match=r"the average .*does not converge"):
        step(k=1e9, c=0.3, **DAMPING).saddle_nodes(1.5)


@pytest.mark.slow
def test_what_is_written_for_other_programs_compiles_alone(tmp_path):
    """The headers, and a table of what is there: C only."""
    names = derived("wave").write(tmp_path)
    header = next(name for name in names if name.endswith(".h") and "intervals" not in name)
    prefix = header.removesuffix(".h")
    pieces, numbers = FORCES["wave"]
    values = ", ".join(str(numbers[name]) for name in names_of(pieces))
    (tmp_path / "user.c").write_text(
        f'#include <stdio.h>\n#include "{header}"\n'
        f"int main(void) {{\n    double p[2] = {{{values}}}, h[4];\n"
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
def test_batches_refuse_a_pole_within_the_reach():
    """Magnets that are nearer than the reach: compiled batches summed over the pole and returned status OK."""
    pieces = [(u + k * (1 / (c - u) ** 2 - 1 / (c + u) ** 2), None)]
    magnets = derive.mechanism("near_magnets", pieces, {"k": {"above": 0}, "c": {"above": 0}}, reach=3.9, compile=True)
    with pytest.raises(ValueError, match=r"infinite or NaN at \|u\| = 3"):
        magnets(k=10.0, c=3.0, mu=0.01, zeta=0.03)
    several = magnets.many(k=10.0, c=np.array([4.5, 3.0, 3.8999, 4.0, -1.0]), mu=0.01, zeta=0.03)
    expected = [Status.OK, Status.INVALID, Status.INVALID, Status.OK, Status.INVALID]
    for found in (several.saddle_nodes(0.1), several.amplitudes(Omega=1.0, F_0=0.1), several.saddle_node_onset()):
        assert found.status.tolist() == expected
    found, single = several.amplitudes(Omega=1.0, F_0=0.1), magnets(k=10.0, c=4.5, mu=0.01, zeta=0.03)
    assert np.isnan(found.A[[1, 2, 4]]).all()
    assert found.A[0, 0] == single.amplitudes(Omega=1.0, F_0=0.1).A[0]
