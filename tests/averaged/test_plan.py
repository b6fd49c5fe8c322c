"""Scenes: what the plan says, that it is obeyed, and that a scene's answer is the general path's."""

import dataclasses

import numpy as np
import pytest

from slowflow import Duffing
from slowflow.averaged import plan, solvers
from slowflow.core import backend
from slowflow.core.model import Model
from slowflow.example import TABLE_1, isolator
from slowflow_kernels import duffing, rod_spring


def runs(made):
    return {step.name: step.runs for step in made.steps}


def same_folds(one, other):
    assert len(one) == len(other)
    assert (one.kind == other.kind).all() and (one.corner == other.corner).all()
    assert np.allclose(one.Omega, other.Omega, rtol=1e-12, atol=0) and np.allclose(one.A, other.A, rtol=1e-12, atol=0)


# ---- the plan -------------------------------------------------------------------------------------------------------


def test_nothing_runs_where_the_mass_sticks():
    plan = isolator().explain("frequency_response", 0.015)
    assert plan.sticks and not any(runs(plan).values())
    assert "sticks" in str(plan)


def test_fold_search_is_skipped_below_a_known_onset():
    oscillator = isolator()
    assert runs(oscillator.explain("saddle_nodes", 0.02))["folds"]
    oscillator.saddle_node_onset()
    assert not runs(oscillator.explain("saddle_nodes", 0.02))["folds"]
    assert runs(oscillator.explain("saddle_nodes", 0.022))["folds"]
    same_folds(oscillator.saddle_nodes(0.02), isolator().saddle_nodes(0.02))
    # folds at rest lie below the onset of a softening spring: there the search must go on
    softening = Duffing(1.0, -1.0, 0.0, 0.05)
    before = softening.saddle_nodes(0.02)
    softening.saddle_node_onset()
    same_folds(softening.saddle_nodes(0.02), before)
    assert len(before) == 1


def test_no_preload_is_a_linear_oscillator():
    plan = isolator(delta_h=0).explain("saddle_nodes", 0.04)
    assert "linear" in str(plan) and not runs(plan)["folds"]


@pytest.mark.parametrize(("mu", "zeta", "what"), [(0, 0.02, "mu"), (0.012, 0, "zeta"), (0, 0, "mu = zeta")])
def test_without_friction_or_zeta_roots_have_a_closed_form(mu, zeta, what):
    plan = isolator(mu=mu, zeta=zeta).explain("amplitudes", 0.04)
    assert f"{what} = 0: F is a quadratic in Omega^2, roots in closed form" in str(plan)


def test_a_phase_nobody_reads_is_not_computed():
    states = isolator().amplitudes(Omega=0.9, F_0=0.04)
    assert "phi" not in states.__dict__
    assert states.phi.shape == states.A.shape and "phi" in states.__dict__


def test_undecided_fold_counts_plan_balls():
    assert "ball arithmetic" in str(isolator().explain("saddle_nodes", 0.04))
    assert "ball arithmetic" not in str(isolator(excitation="base").explain("saddle_nodes", 0.04))


def test_questions_about_all_forcings_are_explained():
    whole, linear, undamped = isolator(), isolator(delta_h=0), isolator(zeta=0)
    assert "explicit in A" in str(whole.explain("saddle_node_onset"))
    assert not runs(linear.explain("saddle_node_onset"))["folds"]
    assert linear.explain("saddle_node_onset").model is None and linear.saddle_node_onset().F_SN is None
    assert "Omega^2 = -h_A" in str(undamped.explain("saddle_node_onset"))
    assert "lowest forcing" in undamped.saddle_node_onset().message
    assert not runs(linear.explain("detachment"))["detachment"] and linear.detachment().F_cr is None
    assert "A = u_cr only" in str(whole.explain("detachment"))
    assert runs(whole.explain("fold_locus"))["fold locus"]
    assert not runs(whole.explain("cusps"))["fold locus"] and not runs(whole.explain("isola_points"))["fold locus"]
    with pytest.raises(ValueError, match=r"F_0 = 0\.04 is not allowed: cusps takes no forcing"):
        whole.explain("cusps", 0.04)
    with pytest.raises(ValueError, match="F_0 = None is not allowed"):
        whole.explain("peak")


def test_an_unknown_question_is_named():
    with pytest.raises(ValueError, match="question = 'isolas' is not allowed"):
        isolator().explain("isolas", 0.04)


# ---- the answers ----------------------------------------------------------------------------------------------------


def test_the_linear_scene_gives_what_the_whole_force_gives():
    linear = isolator(delta_h=0)
    whole = Model(
        rod_spring.MECHANISM, rod_spring.coefficients(TABLE_1["lam"], TABLE_1["r"], 0.0), linear.mu, linear.zeta
    )
    Omega = np.linspace(0.3, 1.5, 25)
    one, other = linear.amplitudes(Omega=Omega, F_0=0.04), solvers.states(whole, Omega, 0.04)
    assert np.allclose(one.A, other.A, rtol=1e-13, atol=0) and np.allclose(one.phi, other.phi, rtol=1e-12, atol=0)


def test_derived_but_not_compiled_mechanism_is_solved():
    mechanism = dataclasses.replace(duffing.MECHANISM, name="fresh")
    fresh, known = Model(mechanism, (1.0, 0.5, 0.0), 0.01, 0.02), Model(duffing.MECHANISM, (1.0, 0.5, 0.0), 0.01, 0.02)
    same_folds(solvers.folds(fresh, 0.1), solvers.folds(known, 0.1))
    assert solvers.onset(fresh).F_SN == pytest.approx(solvers.onset(known).F_SN, rel=1e-13)


def test_error_in_the_compiled_path_is_no_missing_mechanism(monkeypatch):
    def broken(*_):
        return [][0]

    monkeypatch.setattr(backend.SOLVER, "onset", broken)
    with pytest.raises(IndexError):
        solvers.onset(Model(duffing.MECHANISM, (1.0, 0.5, 0.0), 0.01, 0.02))


@pytest.mark.parametrize("question", ["frequency_response", "amplitudes"])
def test_the_plan_of_a_curve_does_not_claim_a_skip_that_is_none(question):
    """A curve is cut at its folds: they are searched for whether or not there are any."""
    oscillator = isolator()
    oscillator.saddle_node_onset()
    assert runs(oscillator.explain(question, 0.02))["folds"]
    assert runs(isolator(delta_h=0).explain(question, 0.04))["folds"]


def test_the_plan_of_a_peak_has_no_curve():
    assert runs(isolator().explain("peak", 0.04)) == {"force": True, "slow flow": True, "peaks": True, "folds": False}


def test_every_question_has_a_plan():
    """At each depth: whatever takes numbers and gives an answer."""
    iso = isolator()
    questions = {name: 0.04 if name in plan.AT_ONE else None for name in plan.QUESTIONS}
    for name, F_0 in questions.items():
        assert callable(getattr(iso, name))
        assert len(iso.explain(name, F_0).steps) >= 2 and iso.explain(name, F_0).question == name
    # the others prove, draw and describe
    others = {"explain", "plot", "replace", "many", "restoring_force", "equation_of_motion"}
    others |= {"measured", "states", "curve", "folds", "onset", "closes", "at_centre"}
    public = {name for name in dir(type(iso)) if not name.startswith("_") and callable(getattr(type(iso), name))}
    assert public - others - {"physical"} == set(questions)


#: questions that ask averaging for nothing
NOT_AVERAGED = ("force", "stiffness", "sweep", "transient", "shock_spectrum", "random")


def test_every_question_off_the_centre_has_a_plan():
    """Of what a load has no answer to there is none; a plan says where the mass sticks."""
    loaded = isolator(load=0.03)
    for name in plan.OFF_CENTRE:
        F_0 = 0.04 if name in plan.AT_ONE else None
        found = loaded.explain(name, F_0)
        assert callable(getattr(loaded, name)) and found.question == name
        assert all(runs(found).values()) or name in NOT_AVERAGED
    assert (
        "sticks: F_0 = 0.01" in str(loaded.explain("saddle_nodes", 0.01)) and loaded.explain("peak", 0.04).F_0 == 0.04
    )
    for name in ("certify", "fold_locus", "cusps"):
        with pytest.raises(ValueError, match=rf"{name} is not available with load = 0\.03"):
            loaded.explain(name)
    with pytest.raises(ValueError, match="detachment takes no forcing"):
        loaded.explain("detachment", 0.04)
    with pytest.raises(ValueError, match="certify is not available with excitation = 'base'"):
        isolator(excitation="base").explain("certify", 0.04)


def test_second_approximation_says_how_it_uses_averaging():
    second = isolator().second_approximation
    for question, F_0 in (("saddle_nodes", 0.04), ("peak", 0.04), ("saddle_node_onset", None)):
        *before, last = second.explain(question, F_0).steps
        first = isolator().explain(question, F_0)
        assert (tuple(before), last.name, last.runs) == (first.steps, "harmonics", True)
    assert not second.explain("peak", 0.01).steps[-1].runs  # it sticks
    with pytest.raises(ValueError, match=r"question = 'cusps' is not allowed.*not explicit in A"):
        second.explain("cusps")
