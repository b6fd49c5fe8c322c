"""Certified cases of every family: all folds and states that there are, no others, and onsets; errors in u (1 + kappa).

tests/data/README.md says what the files hold. One item answers the cases of one force, or five of a family that has one
force; a part of the items runs per push, all in `make test-all`.
"""

from __future__ import annotations

import functools
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import sympy as sp

from slowflow import Duffing, Isolator, derive
from slowflow.answers.results import Remark
from slowflow.averaged import diagnostics
from slowflow_kernels.conventions import GradientStatus
from tests.files import stored
from tests.oracles.errors import U, error
from tests.oracles.pieces import CLOSED, STATED, a, k, names_of, u

Case = dict[str, Any]
#: of the reference's condition numbers, which have three digits
ROUNDED = 5.01e-3
#: relative distance of a fold from u_cr below which counts may be said to be undecided
NEAR = 1e-8
ABOVE = {"above": 0}
#: cases of an item where a family has one force
TOGETHER = 5

q, d, g = sp.symbols("q d g")
#: an exponential leaves the doubles before it is known to hold every motion; magnets are 4 to 5 apart
REACH = {name: {"reach": 8.0} for name in ("exponential", "preload", "hard_stop")} | {"magnets": {"reach": 3.9}}
#: of the library, with the design that a case's parameters are
LIBRARY = {
    "stop": ("elastic_stop", lambda parameters: {"kappa": parameters["k"], "delta": parameters["gap"]}),
    "bilinear": ("bilinear", lambda parameters: {"kappa": parameters["k"], "delta": parameters["gap"]}),
    "play": ("dead_zone", lambda parameters: {"delta": parameters["gap"]}),
}
DOMAINS = {"even": {"a": {}, "b": ABOVE}, "preload": {"c": ABOVE, "b": ABOVE}}
BENT = ([(a * u, g), (a * u + k * (u - g), None)], {"a": ABOVE, "k": {}, "g": {}})
CURVED = dict.fromkeys("kqd", ABOVE)
#: off the centre: that bend on one side, have an even part, or are odd under a load
OFF_CENTRE = {
    "stop": BENT,
    "springs": BENT,
    "even": (CLOSED["even"], DOMAINS["even"]),
    "exponential": ([(k * u + q * (sp.exp(u / d) - 1), None)], CURVED),
    "hyperbolic": ([(k * u + q * sp.sinh(u / d), None)], CURVED),
}


def double(value: Any) -> float:
    """A number of a file: its bits and itself, or a fraction."""
    return value[1] if isinstance(value, list) else float(Fraction(value))


def numbers(case: Case) -> dict[str, float]:
    """Its parameters as doubles."""
    return {name: double(value) for name, value in case["parameters"].items()}


@functools.cache
def stated(name: str, compiled: bool) -> Any:
    """A force that is averaged by sums."""
    called, domains = f"{name}_compiled" if compiled else name, dict.fromkeys(names_of(STATED[name]), ABOVE)
    return derive.mechanism(called, STATED[name], domains, compile=compiled, **REACH.get(name, {}))


@functools.cache
def closed(name: str, compiled: bool) -> Any:
    """One with closed averages."""
    if name in LIBRARY:
        return derive.library(LIBRARY[name][0], compile=compiled)
    return derive.mechanism(f"{name}_closed", CLOSED[name], DOMAINS[name], compile=compiled)


@functools.cache
def off_centre(name: str) -> Any:
    """One with a mean."""
    return derive.mechanism(f"certified_{name}", *OFF_CENTRE[name], odd=name == "hyperbolic")


def of_closed(case: Case, compiled: bool) -> Any:
    """The oscillator of a case of `closed.json`."""
    parameters = numbers(case)
    damping = {key: parameters.pop(key) for key in ("mu", "zeta")}
    design = LIBRARY[case["force"]][1](parameters) if case["force"] in LIBRARY else parameters
    return closed(case["force"], compiled)(**design, **damping)


def of_record(case: Case, **more: Any) -> Any:
    """Of an isolator's or a Duffing oscillator's."""
    if case["mechanism"] == "duffing":
        return Duffing(**numbers(case), **more)
    return Isolator(**numbers(case), contact=case.get("contact", "throughout"), **more)


def on_a_base(case: Case, _: bool) -> Any:
    """The same, excited by inertia."""
    return of_record(case, excitation="base")


def with_a_mean(case: Case, _: bool) -> Any:
    """Of a force that is not odd, or under a load."""
    return off_centre(case["force"])(**numbers(case), excitation=case.get("excitation", "force"))


@dataclass(frozen=True)
class Family:
    """Cases of a file: the oscillator of each, and bounds of errors in u (1 + kappa), of phi by kappa of A."""

    oscillator: Callable[[Case, bool], Any]
    fold: float = 4.0
    state: float = 4.0
    onset: float = 4.0
    phase: float = 50.0
    #: whether its force is derived, and asked interpreted and compiled
    derived: bool = False
    #: whether folds are told apart that lie on a corner; whether their amplitude there has a bound
    corners: bool = True
    A_on_corner: bool = True
    #: whether answers next to a corner may be undecided
    hard: bool = False
    #: whether condition numbers are compared with those of gradients; cases in which these are singular
    gradients: bool = False
    singular: tuple[int, ...] = ()
    #: whether phi is known as well as what A moves it by
    by_A: bool = False
    #: whether the mass may stick where it also has motions
    sticks: bool = False
    #: of how many items a push runs one
    part: int = 4
    #: off the centre: bounds of a fold's A, and of B over A + |B|
    mean: tuple[float, float] | None = None


#: files of isolators and Duffing oscillators about the centre, each at several forcings; the paper's is the last
ABOUT_CENTRE = ("random_isolators", "random_duffing", "negative_stiffness", "table_1")
FAMILIES = {
    **{name: Family(lambda case, _: of_record(case), gradients=True, by_A=True, part=2) for name in ABOUT_CENTRE},
    "stated": Family(lambda case, compiled: stated(case["force"], compiled)(**numbers(case)), onset=16.0, derived=True,
                     corners=False),
    "closed": Family(of_closed, onset=16.0, phase=4.0, derived=True, corners=False, by_A=True),
    **{
        f"damped_{law}": Family(lambda case, _: of_record(case), 2.0, 2.0, hard=True, gradients=True)
        for law in ("eta", "c_2", "contact")
    },
    # of the second c_2 A is some 10^-5 and nothing else damps: folds lie so near to the backbone that gradients count
    # as singular
    "damped_base": Family(on_a_base, 2.0, 2.0, gradients=True, singular=(1,), sticks=True),
    "inertia": Family(on_a_base, state=2.0, phase=100.0, A_on_corner=False, gradients=True, sticks=True),
    **{
        name: Family(with_a_mean, phase=20.0, corners=False, sticks=True, mean=mean)
        for name, mean in (("sided", (4.0, 1.0)), ("curved", (16.0, 8.0)), ("off_centre_laws", (4.0, 1.0)))
    },
}  # fmt: skip


#: those whose parameters are doubles
CENTRED = [
    case
    for name in ABOUT_CENTRE
    for case in stored(name)
    if not any(isinstance(value, str) for value in case["parameters"].values())
]


@functools.cache
def cases(name: str) -> list[Case]:
    """Those of a file, each at one forcing."""
    return [{**case, **forcing} for case in stored(name) for forcing in case.get("forcings", ({},))]


#: by the fast tests: of each family whose force need not be derived, and one that is
FAST = {"stated-root", "closed-bilinear", "inertia-0", "damped_eta-0", "damped_c_2-5", "damped_contact-10",
        "damped_base-0", "off_centre_laws-even"}  # fmt: skip


def items() -> Iterator[Any]:
    """A family's name, numbers of cases, and whether they are compiled, as parameters."""
    for name, family in FAMILIES.items():
        groups: dict[str, list[int]] = {}
        for number, case in enumerate(cases(name)):
            groups.setdefault(str(case.get("force", number // TOGETHER * TOGETHER)), []).append(number)
        for compiled in (False, True) if family.derived else (False,):
            for group, of_it in groups.items():
                called = f"{name}-{group}" + ("-compiled" if compiled else "")
                marks = [pytest.mark.part(family.part, name), *([] if called in FAST else [pytest.mark.slow])]
                yield pytest.param(name, of_it, compiled, id=called, marks=marks)


@pytest.mark.parametrize(("name", "of_it", "compiled"), list(items()))
def test_folds_states_and_onsets_are_the_certified_ones(name, of_it, compiled):
    family = FAMILIES[name]
    for number in of_it:
        case = cases(name)[number]
        one = family.oscillator(case, compiled)
        check_folds(one, case, family, number in family.singular)
        check_states(one, case, family)
        if case.get("onset") is not None:
            check_onset(one, case["onset"], family)
        elif family.mean is not None and "onset" in case:
            F_SN = one.saddle_node_onset().F_SN
            assert F_SN is None or F_SN > one.sticking_forcing + 0.15


def is_hard(one: Any, case: Case) -> bool:
    """Whether a fold lies next to u_cr, so that answers at this forcing may say that they are undecided."""
    amplitudes = [float(fold["A"]) for fold in case["folds"] if not fold["corner"]]
    return any(abs(A / u_cr - 1) < NEAR for A in amplitudes for u_cr in one.breakpoints)


def kappa_of(sure: Case) -> float:
    """Of A, by the inputs and by the kernels' values."""
    return sure["condition"]["A"] + sure["condition_kernel"]["A"]


def has_mean(found: Any, sure: Case, family: Family) -> bool:
    """Whether B is the certified one, where there is one."""
    if family.mean is None:
        return True
    return abs(found.B - float(sure["B"])) < family.mean[1] * U * (1 + kappa_of(sure)) * (found.A + abs(found.B))


def check_folds(one: Any, case: Case, family: Family, is_singular: bool) -> None:
    """All folds, with their condition numbers."""
    found, known = one.saddle_nodes(double(case["F_0"])), case["folds"]
    if Remark.UNDECIDED in found.remarks:
        assert family.hard and is_hard(one, case)
        return
    assert [fold.kind for fold in found] == [fold["kind"] for fold in known]
    assert not family.corners or [fold.corner for fold in found] == [fold["corner"] for fold in known]
    for fold, sure in zip(found, known, strict=True):
        assert error(fold.Omega, sure, "Omega") < family.fold
        of_A = family.fold if family.mean is None else family.mean[0]
        assert (fold.corner and not family.A_on_corner) or error(fold.A, sure, "A") < of_A
        assert has_mean(fold, sure, family)
    if is_singular:
        assert set(found.gradient().status) == {GradientStatus.MEETS}
    elif family.gradients:
        gradient = found.gradient()
        for name in gradient.of:
            expected = [sure["condition"][name] for sure in known]
            np.testing.assert_allclose(gradient.condition(name), expected, rtol=ROUNDED)


def in_its_well(one: Any, A: float) -> bool:
    """Whether a motion turns where the spring pulls back: what averaging holds for stable beyond it is not."""
    return not (isinstance(one, Duffing) and one.beta < 0 < one.alpha < -one.beta * A**2)


def keeps_centre(one: Any, states: Any, family: Family) -> Any:
    """Whether motions stay about the centre, which the certified stability (30) does not know."""
    if family.mean is not None:
        return np.full(len(states), True)
    return diagnostics.keeps_centre(one.model, states.Omega, states.A)


def check_states(one: Any, case: Case, family: Family) -> None:
    """All states at each frequency."""
    F_0 = double(case["F_0"])
    for at in case["amplitudes"]:
        Omega, sure = at["Omega"][1], at["steady"]
        found = one.amplitudes(Omega=Omega, F_0=F_0)
        if Remark.UNDECIDED in found.remarks:
            assert family.hard and is_hard(one, case)
            continue
        moving = found.A > 0
        assert moving.all() or family.sticks
        within = np.array([in_its_well(one, A) for A in found.A[moving]], dtype=bool)
        kept = keeps_centre(one, found, family)[moving]
        expected = np.array([state["stable"] for state in sure], dtype=bool) & within & kept
        assert found.stable[moving].tolist() == expected.tolist()
        assert (Remark.LEAVES_CENTRE in found.remarks) == (not kept.all())
        assert (Remark.BEYOND_WELL in found.remarks) == (not within.all())
        for state, known in zip((state for state in found if state.A > 0), sure, strict=True):
            assert error(state.A, known, "A") < family.state
            assert has_mean(state, known, family)
            # of tan(phi) = I/R, of which R = A Omega^2 + h moves by A R_A with A
            by_A = state.A * (Omega**2 + abs(one.model.averaged(state.A)[1])) / F_0 if family.by_A else 0.0
            bound = family.phase * U * (1 + kappa_of(known)) * (1 + by_A)
            assert state.phi == pytest.approx(float(known["phi"]), abs=bound)
        if family.gradients:
            known = [state["condition"]["A"] for state in sure]
            np.testing.assert_allclose(found.gradient().condition("A")[moving], known, rtol=ROUNDED)


def check_onset(one: Any, sure: Case, family: Family) -> None:
    """The lowest forcing with a fold; a remark where folds that end at Omega = 0 are lower."""
    found = one.saddle_node_onset()
    for name in ("F_SN", "Omega", "A"):
        assert error(getattr(found, name), sure, name) < family.onset
    assert has_mean(found, sure, family)
    if family.gradients:
        assert found.kind == sure["kind"]
        assert (Remark.FOLDS_AT_REST in found.remarks) == (not sure["global"])
        gradient = found.gradient()
        for name in ("F_SN", "Omega", "A") if sure["global"] else ():
            known = sure["condition"]["F_0" if name == "F_SN" else name]
            assert gradient.condition(name) == pytest.approx(known, rel=ROUNDED)


#: of each file: folds and onsets that its cases have at least, and how many there are of each force or law
HELD_BY_FILES = {
    "stated": (41, 15, {**dict.fromkeys(STATED, 3), "magnets": 12, "contact": 30, "preload": 10, "preload_power": 10,
                        "preloaded_stop": 10, "soft_stop": 10, "hard_stop": 7, "root_stop": 13}),
    "closed": (300, 0, dict.fromkeys(CLOSED, 30)),
    "sided": (58, 31, dict.fromkeys(("stop", "springs", "even"), 12)),
    "curved": (1, 25, {"exponential": 17, "hyperbolic": 13}),
    "off_centre_laws": (56, 0, {"stop": 22, "springs": 14, "even": 6}),
    **{f"damped_{law}": (51, 0, {"": 40 if law == "base" else 30}) for law in ("eta", "c_2", "contact", "base")},
}  # fmt: skip


@pytest.mark.parametrize("name", HELD_BY_FILES)
def test_certified_cases_have_folds_of_each_force(name):
    folds, onsets, each = HELD_BY_FILES[name]
    assert Counter(case.get("force", "") for case in cases(name)) == each
    assert sum(len(case["folds"]) for case in cases(name)) >= folds
    assert sum(case.get("onset") is not None for case in cases(name)) >= onsets
    assert name != "closed" or all(len(case["folds"]) >= 2 for case in cases(name))
    assert "damped" not in name or any(fold["corner"] for case in cases(name) for fold in case["folds"])


def laws_of(case):
    """What excites it, where friction acts, whether zeta, eta and c_2 are there."""
    has = (bool(numbers(case)[law]) for law in ("zeta", "eta", "c_2"))
    return case.get("excitation"), case.get("contact"), *has


def test_certified_cases_have_each_law_with_and_without_others():
    files = ("damped_eta", "damped_c_2", "damped_contact", "damped_base", "off_centre_laws")
    laws = {name: {laws_of(case) for case in cases(name)} for name in files}
    for name in ("eta", "c_2", "contact"):
        assert {zeta for _, _, zeta, *_ in laws[f"damped_{name}"]} == {True, name == "contact"}
    combined = {(True, True, True, "throughout"), (False, True, False, "throughout"), (True, False, False, "attached")}
    assert combined < {(*others, contact) for _, contact, *others in laws["damped_base"]}
    both = [(eta, c_2) for eta in (False, True) for c_2 in (False, True)]
    expected = {("base", *one) for one in both} | {("force", *one) for one in both[1:]}
    assert {(excitation, *others) for excitation, _, _, *others in laws["off_centre_laws"]} == expected
