"""Other laws of damping against certified folds, states and onsets: none is left out, none invented, errors in u.

Their gradients are held to the same files: a condition number is the sum of what all parameters do.
"""

import json
import warnings
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy as sp

from slowflow import Duffing, Isolator, derive
from slowflow.results import Remark
from slowflow_kernels.conventions import MovesStatus
from tests.oracles.errors import U, error

DATA = Path(__file__).parent / "data"
CASES = {law: json.loads((DATA / f"damped_{law}.json").read_text()) for law in ("eta", "c_2", "rubs")}
#: errors in u (1 + kappa), of phi in u (1 + kappa) of A
FOLD, STATE, ONSET, PHASE = 2.0, 2.0, 4.0, 50.0
#: of the reference's condition numbers, which have three digits
ROUNDED = 5.01e-3
#: relative distance of a fold from u_cr below which counts may be said to be undecided
NEAR = 1e-8
#: one in so many belongs to the fast tests
FEW = 10


def singles(laws, first):
    """Cases as parameters: those of the fast tests from number `first` on, the others marked slow."""
    return [
        pytest.param(law, number, id=f"{law}-{number}", marks=[] if number % FEW == first else pytest.mark.slow)
        for law in laws
        for number in range(len(CASES[law]))
    ]


def oscillator(case):
    values = {name: value[1] for name, value in case["parameters"].items()}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return Duffing(**values) if case["mechanism"] == "duffing" else Isolator(**values, rubs=case["rubs"])


@pytest.fixture(scope="module")
def by_quadrature():
    """The same force, with a term without a closed average that its factor leaves out."""
    u, alpha, beta, gamma, end, nothing = sp.symbols("u a b g end nothing")
    inside = alpha * u + beta * u**3 + gamma * u**5 + nothing * sp.sin(u) ** 3
    given = {name: {} for name in ("a", "b", "g")} | {"end": {"above": 0}, "nothing": {"least": 0}}
    made = derive.mechanism("damped_by_quadrature", [(inside, end), (u, None)], given)

    def get(case):
        alone = oscillator(case)
        numbers = dict(zip(("a", "b", "g", "end"), alone.model.parameters, strict=True))
        damping = {name: getattr(alone, name) for name in ("mu", "zeta", "eta", "c_2")}
        return made(**numbers, nothing=0.0, rubs=case["rubs"], **damping)

    return get


@pytest.mark.slow
@pytest.mark.parametrize(
    ("law", "number"),
    [("rubs", 6), ("eta", 18), ("c_2", 6), ("rubs", 24)],
)
@pytest.mark.part(2)
def test_a_force_that_is_averaged_by_quadrature_has_the_certified_answers(by_quadrature, law, number):
    case = CASES[law][number]
    osc = by_quadrature(case)
    assert osc.model.mechanism.enclosed is not None
    found = osc.saddle_nodes(case["F_0"][1])
    assert "message" in vars(found), "words that ask for an average, which may not settle, are made with the answer"
    assert [(fold.kind, fold.corner) for fold in found] == [(fold["kind"], fold["corner"]) for fold in case["folds"]]
    for fold, known in zip(found, case["folds"], strict=True):
        assert error(fold.Omega, known, "Omega") < FOLD
        assert error(fold.A, known, "A") < FOLD
    for at in case["amplitudes"]:
        states = osc.amplitudes(Omega=at["Omega"][1], F_0=case["F_0"][1])
        for A, known in zip(states.A, at["steady"], strict=True):
            assert error(A, known, "A") < STATE
    assert error(osc.saddle_node_onset().F_SN, case["onset"], "F_SN") < ONSET


def test_laws_are_refused_where_the_stiffness_at_rest_is_infinite():
    u, k = sp.symbols("u k")
    root = derive.mechanism("damped_root", [(u + k * sp.sqrt(u), None)], {"k": {"above": 0}})
    with pytest.raises(ValueError, match="its stiffness is infinite at u = 0"):
        root(k=0.05, c_2=0.05, mu=0.01)


def is_hard(osc, case):
    """Whether a fold lies next to u_cr, so that answers at this forcing may say that they are undecided."""
    beside = [float(fold["A"]) for fold in case["folds"] if not fold["corner"]]
    return any(abs(A / u_cr - 1) < NEAR for A in beside for u_cr in osc.breakpoints)


def test_there_are_thirty_cases_of_each_law_with_many_folds_on_both_sides_of_u_cr():
    for law, cases in CASES.items():
        assert len(cases) == 30
        assert sum(len(case["folds"]) for case in cases) > 50
        assert any(fold["corner"] for case in cases for fold in case["folds"])
        assert {bool(case["parameters"]["zeta"][1]) for case in cases} == ({True} if law == "rubs" else {True, False})


@pytest.mark.parametrize(("law", "number"), singles(CASES, 0))
@pytest.mark.part(4)
def test_folds_are_the_certified_ones_and_no_others(law, number):
    case = CASES[law][number]
    osc, sure = oscillator(case), case["folds"]
    found = osc.saddle_nodes(case["F_0"][1])
    if Remark.UNDECIDED in found.remarks:
        assert is_hard(osc, case)
        return
    assert [(fold.kind, fold.corner) for fold in found] == [(fold["kind"], fold["corner"]) for fold in sure]
    for fold, known in zip(found, sure, strict=True):
        assert error(fold.Omega, known, "Omega") < FOLD
        assert error(fold.A, known, "A") < FOLD
    moves = found.gradient()
    for name in moves.of:
        np.testing.assert_allclose(moves.condition(name), [known["condition"][name] for known in sure], rtol=ROUNDED)


def in_its_well(osc, A):
    """Whether a motion turns where the spring pulls back: what averaging holds for stable beyond it is not."""
    return not (isinstance(osc, Duffing) and osc.beta < 0 < osc.alpha < -osc.beta * A**2)


@pytest.mark.parametrize(("law", "number"), singles(CASES, 0))
@pytest.mark.part(4)
def test_states_are_the_certified_ones_and_no_others(law, number):
    case = CASES[law][number]
    osc, F_0 = oscillator(case), case["F_0"][1]
    for at in case["amplitudes"]:
        found, sure = osc.amplitudes(Omega=at["Omega"][1], F_0=F_0), at["steady"]
        if Remark.UNDECIDED in found.remarks:
            assert is_hard(osc, case)
            continue
        stable = [state["stable"] and in_its_well(osc, A) for state, A in zip(sure, found.A, strict=True)]
        if Remark.LEAVES_CENTRE in found.remarks:  # not stable for another reason, which softening gives
            assert osc.beta < 0
            assert all(known or not said for said, known in zip(found.stable, stable, strict=True))
        else:
            assert found.stable.tolist() == stable
        for A, phi, known in zip(found.A, found.phi, sure, strict=True):
            assert error(A, known, "A") < STATE
            kappa = known["condition"]["A"] + known["condition_kernel"]["A"]
            assert phi == pytest.approx(float(known["phi"]), abs=PHASE * U * (1 + kappa))
        known = [state["condition"]["A"] for state in sure]
        np.testing.assert_allclose(found.gradient().condition("A"), known, rtol=ROUNDED)


@pytest.mark.parametrize(("law", "number"), singles(CASES, 2))
@pytest.mark.part(4)
def test_onsets_are_the_certified_ones(law, number):
    """Where folds that end at Omega = 0 lie lower, that is said.

    Next to u_cr, where friction ends, boxes do not tell the signs of F_A and F_AA: a cusp there is not looked for where
    the level is above that of another onset.
    """
    case = CASES[law][number]
    found, sure = oscillator(case).saddle_node_onset(), case["onset"]
    assert found.kind == sure["kind"]
    assert (Remark.FOLDS_AT_REST in found.remarks) == (not sure["global"])
    for name in ("F_SN", "Omega", "A"):
        assert error(getattr(found, name), sure, name) < ONSET
        known = sure["condition"]["F_0" if name == "F_SN" else name]
        assert found.gradient().condition(name) == pytest.approx(known, rel=ROUNDED)


BASE = json.loads((DATA / "damped_base.json").read_text())
#: c_2 A is some 10^-5 and nothing else damps: folds lie so near to the backbone that gradients count as singular
UNDAMPED = 1


def on_a_base(case):
    return oscillator(case).replace(excitation="base")


def on_bases(first):
    """Cases on a base that shakes as parameters, as `singles`."""
    return [
        pytest.param(number, marks=[] if number % FEW == first else pytest.mark.slow) for number in range(len(BASE))
    ]


def test_there_are_forty_cases_on_a_base_of_laws_alone_and_together():
    assert len(BASE) == 40
    laws = {(*(bool(case["parameters"][name][1]) for name in ("zeta", "eta", "c_2")), case["rubs"]) for case in BASE}
    assert {(True, True, True, "throughout"), (False, True, False, "throughout")} < laws
    assert (True, False, False, "attached") in laws
    assert any(fold["corner"] for case in BASE for fold in case["folds"])
    assert sum(len(case["folds"]) for case in BASE) > 50


@pytest.mark.parametrize("number", on_bases(1))
@pytest.mark.part(4)
def test_folds_on_a_base_are_the_certified_ones_and_no_others(number):
    case = BASE[number]
    found, sure = on_a_base(case).saddle_nodes(case["F_0"][1]), case["folds"]
    assert [(fold.kind, fold.corner) for fold in found] == [(fold["kind"], fold["corner"]) for fold in sure]
    for fold, known in zip(found, sure, strict=True):
        assert error(fold.Omega, known, "Omega") < FOLD
        assert error(fold.A, known, "A") < FOLD
    moves = found.gradient()
    if number == UNDAMPED:
        assert set(moves.status) == {MovesStatus.MEETS}
        return
    for name in moves.of:
        np.testing.assert_allclose(moves.condition(name), [known["condition"][name] for known in sure], rtol=ROUNDED)


@pytest.mark.parametrize("number", on_bases(2))
@pytest.mark.part(4)
def test_states_on_a_base_are_the_certified_ones_and_no_others(number):
    case = BASE[number]
    osc, F_0 = on_a_base(case), case["F_0"][1]
    for at in case["amplitudes"]:
        found, sure = osc.amplitudes(Omega=at["Omega"][1], F_0=F_0), at["steady"]
        moves = found.A > 0  # beside a mass that friction holds
        stable, As = found.stable[moves], found.A[moves]
        assert all(known["stable"] or not said for said, known in zip(stable, sure, strict=True))
        if Remark.LEAVES_CENTRE not in found.remarks:
            inside = [in_its_well(osc, A) for A in As]
            assert stable.tolist() == [known["stable"] and well for known, well in zip(sure, inside, strict=True)]
        for A, phi, known in zip(As, found.phi[moves], sure, strict=True):
            assert error(A, known, "A") < STATE
            kappa = known["condition"]["A"] + known["condition_kernel"]["A"]
            assert phi == pytest.approx(float(known["phi"]), abs=PHASE * U * (1 + kappa))
        known = [state["condition"]["A"] for state in sure]
        np.testing.assert_allclose(found.gradient().condition("A")[moves], known, rtol=ROUNDED)


@pytest.mark.parametrize("number", on_bases(3))
@pytest.mark.part(4)
def test_folds_on_a_base_come_at_the_onset(number):
    """None below it, and above it there are some next to where it says."""
    osc = on_a_base(BASE[number])
    onset = osc.saddle_node_onset()
    if onset.F_SN is None:
        return
    below, above = (osc.saddle_nodes(onset.F_SN * factor) for factor in (1 - 1e-4, 1 + 1e-4))
    assert len(below) == 0
    assert min(abs(above.A - onset.A)) < 0.1 * onset.A


@pytest.mark.parametrize("F_0", [1.0, 1e20, 1e60, 1e150])
@pytest.mark.parametrize("c_2", [1e20, 1e100, 1e150, 1e200, 1.7e308])
def test_quadratic_damping_of_any_size_is_answered_or_refused_as_beyond_doubles(c_2, F_0):
    """Far beyond resonance under inertia A^2 (1 + (8 c_2 A/3 pi)^2) = F_0^2; it was said to be 0, or a KeyError."""
    iso = Isolator(lam=1.3, r=1.0, delta_h=1.5e-4, mu=0.65, zeta=1.4, excitation="unbalance", c_2=c_2)
    with mpmath.workdps(400):  # some products have 300 digits before the point
        d = 8 * mpmath.mpf(c_2) / (3 * mpmath.pi)
        full = float(mpmath.sqrt(2 * mpmath.mpf(F_0) ** 2 / (1 + mpmath.sqrt(1 + 4 * (d * mpmath.mpf(F_0)) ** 2))))
    try:
        found = iso.frequency_response(F_0, samples=20, Omega=(0.0, 1e35))
    except OverflowError as refusal:
        assert "leave the range of doubles" in str(refusal)
        assert c_2 * F_0 > 1e70  # ordinary numbers are not refused
    else:
        assert found.A.max() == pytest.approx(full, rel=1e-6)
