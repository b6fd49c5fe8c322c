"""A mechanism is one record: what the derivation states, what its functions give, and one compiled elsewhere."""

from __future__ import annotations

import importlib
import math
import random
import re
import shutil

import numpy as np
import pytest

from derivations.mechanisms import DAMPING, FORCING, all_mechanisms
from slowflow import Duffing
from slowflow.core import backend
from slowflow.core.model import Model
from slowflow_kernels import duffing, slow_flow
from tests.native import records
from tests.oracles.stated import Stated

NATIVE = backend.SOLVER
MECHANISMS = {mechanism.name: mechanism for mechanism in all_mechanisms()}
INSIDE = {"lam": 3.0, "r": 2.0, "delta_h": 0.1, "alpha": 0.5, "beta": 0.7, "mu": 0.012, "zeta": 0.02, "F_0": 0.04}
INSIDE |= {
    parameter.symbol.name: Stated.within(parameter, random.Random(parameter.symbol.name))
    for mechanism in MECHANISMS.values()
    for parameter in mechanism.design
    if parameter.symbol.name not in INSIDE
}
OK, INVALID = 0, 1


def allowed(parameter, value: float) -> bool:
    """Whether a number lies in the domain that the mechanism's file states."""
    return (
        math.isfinite(value)
        and (parameter.above is None or value > parameter.above)
        and (parameter.least is None or value >= parameter.least)
        and (parameter.below is None or value < parameter.below)
        and (parameter.most is None or value <= parameter.most)
    )


def near_bounds(parameter) -> list[float]:
    """Numbers inside and outside the domain, on its bounds and one float to either side of them."""
    bounds = [b for b in (parameter.above, parameter.least, parameter.below, parameter.most) if b is not None]
    near = [v for b in map(float, bounds) for v in (np.nextafter(b, -np.inf), b, np.nextafter(b, np.inf))]
    return [*map(float, near), -1.0, math.nan, math.inf, -math.inf]


@pytest.fixture(scope="module")
def own(tmp_path_factory):
    """A builder of own_record.c."""
    if shutil.which("gcc") is None:
        pytest.skip("no gcc on the path")
    directory = tmp_path_factory.mktemp("records")
    return lambda *options: records.build(directory, options)


# ---- what the derivation states ----------------------------------------------------------------------------------


def test_every_mechanism_of_the_derivation_has_its_record():
    # programs of other tests in this process may have stated more, whose names end in a digest
    assert {name for name in NATIVE.RECORDS if not re.search("_[0-9a-f]{12}$", name)} == MECHANISMS.keys()


@pytest.mark.parametrize("name", MECHANISMS)
def test_record_refuses_only_what_lies_outside_its_domains(name):
    mechanism = MECHANISMS[name]
    parameters = (*mechanism.design, *DAMPING)
    inside = [INSIDE[parameter.symbol.name] for parameter in parameters]
    ask = NATIVE.many_detachment(NATIVE.RECORDS[name])
    assert ask(*inside)[-1] != INVALID
    for place, parameter in enumerate(parameters):
        for value in near_bounds(parameter):
            arguments = [*inside[:place], value, *inside[place + 1 :]]
            assert (ask(*arguments)[-1] != INVALID) == allowed(parameter, value), (parameter.symbol, value)
    forced = NATIVE.many_peak(NATIVE.RECORDS[name])
    for value in near_bounds(FORCING):
        assert (forced(*inside, value)[-1] != INVALID) == allowed(FORCING, value), value


@pytest.mark.parametrize("name", MECHANISMS)
def test_record_averages_many_amplitudes_as_the_kernels_do(name):
    kernels = importlib.import_module(f"slowflow_kernels.{name}")
    record = records.opened(NATIVE.RECORDS[name])
    mechanism = MECHANISMS[name]
    design, p = records.doubles([INSIDE[d.symbol.name] for d in mechanism.design]), records.doubles([0.0] * 16)
    assert record.ask("parameters_of", design, p)
    parameters = list(p)[: record.parameters]
    stated = kernels.MECHANISM
    assert record.parameters == len(stated.parameters) and record.reach == stated.reach
    b, jump = records.doubles([0.0] * 4), records.doubles([0.0] * 4)
    record.ask("ends", p, b), record.ask("jumps", p, jump)
    assert list(b)[: record.breakpoints] == [float(end) for end in kernels.breakpoints(*parameters)]
    assert list(jump)[: record.breakpoints] == [float(step) for step in kernels.jumps(*parameters)]
    A = [0.1, 0.3, 0.5, 0.7, 0.9]
    for name, kernel in (("averaged", kernels.averaged), ("averaged_2", kernels.averaged_2)):
        for amplitudes in ([], A[:1], A):
            expected = np.array(kernel(np.array(amplitudes), *parameters)).ravel()
            out = records.doubles([math.nan] * expected.size)
            record.ask(name, len(amplitudes), records.doubles(amplitudes), p, out)
            assert np.allclose(list(out), expected, rtol=1e-14, atol=0)


@pytest.mark.parametrize("name", MECHANISMS)
def test_record_knows_damping_excitation_and_odd_forces(name):
    record = records.opened(NATIVE.RECORDS[name])
    damping, p = records.doubles([0.0] * 2), records.doubles([0.5] * 16)
    assert record.damping_of(records.doubles([0.012, 0.02]), damping)
    m, zeta = damping
    assert m == slow_flow.friction(0.012)
    assert record.dissipation(0.9, 0.4, damping) == slow_flow.I(0.9, 0.4, m, zeta)
    assert record.dissipation(0.0, 0.0, damping) == m
    assert record.level(0.9, 0.4, damping, -0.3) == slow_flow.level(0.9, 0.4, m, zeta, -0.3)
    assert record.inertial == 0
    assert record.mean_offset(0.4, p) == 0


def test_a_ufunc_of_a_record_is_made_once():
    record = NATIVE.RECORDS["duffing"]
    assert NATIVE.many_onset(record) is NATIVE.many_onset(record)
    assert NATIVE.many_onset(record) is not NATIVE.many_onset(NATIVE.RECORDS["rod_spring"])
    assert NATIVE.many_onset(record) is not NATIVE.many_peak(record)


# ---- a record compiled elsewhere ------------------------------------------------------------------------------------


def same(one, other) -> None:
    """Answers of the extension, to the last digit, which only an oscillator whose design is known has settled."""
    for left, right in zip(one, other, strict=True):
        np.testing.assert_allclose(np.array(left, dtype=float), np.array(right, dtype=float), rtol=1e-13)


@pytest.mark.parametrize(("alpha", "beta"), [(1.0, 0.5), (0.4, 2.0), (1.0, -0.2), (-0.1, 1.0)])
def test_a_record_compiled_elsewhere_is_solved_like_our_own(own, alpha, beta):
    record, damping = own(), (0.012, 0.02)
    mine = NATIVE.model(record, (beta, alpha, 0.0), damping)
    ours = Model(duffing.MECHANISM, (alpha, beta, 0.0), *damping).native
    same(NATIVE.onset(mine), NATIVE.onset(ours))
    same(NATIVE.detachment(mine), NATIVE.detachment(ours))
    same(NATIVE.fold_locus(mine, 2.0, 50), NATIVE.fold_locus(ours, 2.0, 50))
    same(NATIVE.extrema(mine, 2.0), NATIVE.extrema(ours, 2.0))
    for F_0 in (0.02, 0.06, 0.3):
        same(NATIVE.saddle_nodes(mine, F_0), NATIVE.saddle_nodes(ours, F_0))
        same(NATIVE.peak(mine, F_0, np.inf), NATIVE.peak(ours, F_0, np.inf))
        same(NATIVE.frequency_response(mine, F_0, 80, 0.0, 2.0), NATIVE.frequency_response(ours, F_0, 80, 0.0, 2.0))
        Omega = np.linspace(0.2, 2, 9)
        same(NATIVE.steady_states(mine, F_0, Omega), NATIVE.steady_states(ours, F_0, Omega))
    F_0 = np.array([0.005, 0.05, 0.5])
    many = Duffing.many(alpha=alpha, beta=beta, mu=damping[0], zeta=damping[1])
    columns = (
        *(np.empty((3, 6)) for _ in range(2)),
        np.empty((3, 6), np.int8),
        *(np.empty(3, np.int8) for _ in range(3)),
    )
    NATIVE.many_saddle_nodes(record)(beta, alpha, 0.0, *damping, F_0, out=columns)
    folds = many.saddle_nodes(F_0)
    same(columns, (folds.Omega, folds.A, folds.kind, folds.count, folds.undecided, folds.status))
    found = many.saddle_node_onset()
    expected = (found.F_SN, found.Omega, found.A, found.kind, found.at_rest, found.status)
    same(NATIVE.many_onset(record)(beta, alpha, 0.0, *damping), expected)


def test_the_solvers_ask_the_record_what_forcing_a_state_takes(own):
    plain, doubled = (NATIVE.model(own(*options), (0.5, 1.0, 0.0), (0.012, 0.02)) for options in ((), ("-DLEVEL=2.0",)))
    _, Omega, A, F_0, _ = NATIVE.fold_locus(plain, 2.0, 50)
    _, same_Omega, same_A, twice, _ = NATIVE.fold_locus(doubled, 2.0, 50)
    assert (same_Omega == Omega).all() and (same_A == A).all() and (twice == 2 * F_0).all()
    levels, doubled_levels = (NATIVE.extrema(model, 2.0)[1] for model in (plain, doubled))
    assert levels.size > 0 and (doubled_levels == 2 * levels).all()


def test_the_solvers_ask_the_record_whether_the_mass_sticks(own):
    sticks, m = 2, slow_flow.friction(0.012)
    plain, rough = (NATIVE.model(own(*o), (0.5, 1.0, 0.0), (0.012, 0.02)) for o in ((), ("-DTHRESHOLD=2.0",)))
    for model, threshold in ((plain, m), (rough, 2 * m)):
        assert NATIVE.saddle_nodes(model, threshold)[0] == NATIVE.peak(model, threshold, np.inf)[0] == sticks
        above = np.nextafter(threshold, 1)
        assert sticks not in (NATIVE.saddle_nodes(model, above)[0], NATIVE.peak(model, above, np.inf)[0])


def test_an_offset_motion_reaches_farther_than_its_amplitude(own):
    centred, off = (NATIVE.model(own(*o), (0.5, 1.0, 0.25), (0.0, 0.02)) for o in ((), ("-DOFFSET=-0.125",)))
    assert NATIVE.detachment(centred)[3] == 0.25 and NATIVE.detachment(off)[3] == 0.375
    assert NATIVE.detachment(centred)[1:3] == NATIVE.detachment(off)[1:3]


def test_a_record_of_another_form_is_refused(own):
    record = own("-DFORM=99")
    for ask in (NATIVE.many_onset, lambda one: NATIVE.model(one, (0.5, 1.0, 0.0), (0.0, 0.02))):
        with pytest.raises(ValueError, match="the record was compiled for another form"):
            ask(record)


@pytest.mark.parametrize("value", [None, "duffing", records.capsule(1, b"somebody.else")])
def test_what_is_no_record_is_refused(value):
    for ask in (NATIVE.many_onset, lambda one: NATIVE.model(one, (1.0, 0.5), (0.0, 0.02)), NATIVE.onset):
        with pytest.raises(ValueError, match="PyCapsule_GetPointer"):
            ask(value)


def test_too_few_parameters_are_refused():
    record = NATIVE.RECORDS["duffing"]
    with pytest.raises(ValueError, match="duffing takes 3 parameters, not 1"):
        NATIVE.model(record, (1.0,), (0.0, 0.02))
    with pytest.raises(ValueError, match="duffing takes 2 numbers of damping, not 3"):
        NATIVE.model(record, (1.0, 0.5, 0.1), (0.0, 0.02, 0.1))
    with pytest.raises(ValueError, match="the damping is outside its domain"):
        NATIVE.model(record, (1.0, 0.5, 0.1), (-0.1, 0.02))
