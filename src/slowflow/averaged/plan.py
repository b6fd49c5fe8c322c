"""What runs for a question and what does not: in go an oscillator's models and the question, out comes the plan.

It is made in one place and obeyed: an oscillator hands its solvers what `solved` says, and so does the plan, which has
the reasons, step by step, and is made where one is asked for.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from slowflow.averaged import proofs, words
from slowflow.model import Model
from slowflow.results import Remark, SaddleNodeOnset
from slowflow.text import Sentence, text
from slowflow_kernels.conventions import CLOSE

#: questions at one forcing
QUESTIONS = ("frequency_response", "amplitudes", "saddle_nodes", "peak")
#: questions about all forcings
OF_ALL = ("saddle_node_onset", "detachment", "fold_locus", "cusps", "isola_points")


@dataclass(frozen=True)
class Step:
    """One step: whether it runs, and which variant of it or why not."""

    name: str
    runs: bool
    why: str

    def __str__(self) -> str:
        return f"{self.name:14}{'runs' if self.runs else 'skipped':9}{self.why}"


PEAK = (
    Step("peaks", True, "level crossings of the peak locus"),
    Step("folds", False, "not needed for this question"),
)
CURVE = (
    Step("curve", True, "events, arcs and pieces between them"),
    Step("folds", True, "level crossings of the fold locus, and corners: they cut the curve into pieces"),
    Step("phase", False, "computed when .phi is first read"),
)


AT = Sentence(" at {F_0 = :g}")
ABOUT_ALL = Sentence("{F_0 = :r} is not allowed: {question:s} is about all forcings")
QUARTIC = Sentence("{laws:s}: F is a quartic in {Omega}")
BELOW = Sentence("{F_0} < {F_SN = :g}: there is none")
FOLDS = "level crossings of the fold locus, and corners"
STATES = "of states at each frequency: one on each piece of the curve"
IN_BALLS = "; where doubles do not tell how many, balls, with python-flint"


@dataclass(frozen=True)
class Plan:
    """The way to an answer.

    model -- what the solvers get; None where nothing has to be solved
    folds -- whether folds are searched for
    sticks -- whether the mass stays at rest
    steps -- the same in words
    where -- at which forcing, in words
    """

    question: str
    F_0: float | None
    model: Model | None
    folds: bool
    steps: tuple[Step, ...]
    where: str = ""

    @property
    def sticks(self) -> bool:
        """Whether nothing is solved because the mass stays at rest."""
        return self.model is None

    def __str__(self) -> str:
        at = "" if self.F_0 is None else AT.format(self.F_0)
        return "\n".join([f"{self.question}{self.where or at}", *(f"  {step}" for step in self.steps)])


def solved(question: str, F_0: float, whole: Model, onset: SaddleNodeOnset | None) -> tuple[Model | None, bool]:
    """What the solvers get, None where the mass stays at rest, and whether folds are searched for; as `plan`."""
    if whole.sticks(F_0):
        return None, False
    if question != "saddle_nodes":
        return whole, question != "peak"
    return whole, not (whole.linear or (onset is not None and _is_below(F_0, onset)))


def plan(question: str, F_0: float, whole: Model, onset: SaddleNodeOnset | None) -> Plan:
    """The plan for one of `QUESTIONS` at F_0 > 0.

    whole -- the oscillator
    onset -- the onset of folds, if it has been asked for already
    """
    model, searched = solved(question, F_0, whole, onset)
    if model is None:
        return Plan(
            question,
            F_0,
            None,
            False,
            tuple(Step(name, False, words.sticks(whole, F_0)) for name in ("force", "slow flow", "curve", "folds")),
        )
    if whole.linear:
        force = _force(whole, "linear: one piece, no angles, no corner")
    elif not whole.breakpoints:
        force = _force(whole, "one piece: no angles, no corner")
    else:
        force = _force(whole, text("its pieces up to the highest amplitude at {F_0}"))
    told = QUARTIC.format(whole.laws.told()) if whole.laws.any else whole.flow.SCENE
    flow = Step("slow flow", True, told)
    if question == "peak":
        return Plan(question, F_0, whole, searched, (force, flow, *PEAK))
    if question != "saddle_nodes":
        counted = (
            [Step("number", True, STATES + IN_BALLS)] if question == "amplitudes" and proofs.is_plain(whole) else []
        )
        return Plan(question, F_0, whole, searched, (force, flow, *CURVE, *counted))
    if searched:
        why = FOLDS + IN_BALLS if proofs.is_plain(whole) else FOLDS
    else:
        why = "a linear oscillator has none" if onset is None or whole.linear else BELOW.format(onset.F_SN)
    return Plan(question, F_0, whole, searched, (force, flow, Step("folds", searched, why)))


def _is_below(F_0: float, onset: SaddleNodeOnset) -> bool:
    """Whether there is no fold at F_0, however F_SN is rounded."""
    if onset.F_SN is None or Remark.FOLDS_AT_REST in onset.remarks:
        return False
    return bool(onset.F_SN * (1 - CLOSE) > F_0)


LOCUS = {
    "saddle_node_onset": Step("fold locus", False, "cusps, isola points and breakpoints are explicit in A: the lowest"),
    "fold_locus": Step("fold locus", True, "for each A the frequencies at which F_A = 0, and the forcing there"),
    "cusps": Step("fold locus", False, "cusps are explicit in A"),
    "isola_points": Step("fold locus", False, "isola points are explicit in A"),
}


PROOF = text("of folds, {F_SN} and {F_cr}, and of states where {Omega} is given, in interval arithmetic")
_NEWTON = (
    "Newton's iteration on the motion with its order of switches, from what averaging or the motion before leads to"
)
_SWITCHES = "Taylor series from switch to switch: a stop, a breakpoint, a break-away"

LIMIT = text("explicit in {Omega} and {F_0}: where damping alone takes {F_0}, I = {F_0} (27)")
_NO_CURVE = Step("curve", False, "not needed: there is a formula")

#: questions that ask others, or the equation of motion, by what they do
COMPOSED: Mapping[str, tuple[Step, ...]] = MappingProxyType(
    {
        "margins": (
            Step("folds", True, text("how many there are at {F_0}")),
            Step("onset", True, text("{F_SN}, found once for the oscillator")),
            Step("detachment", True, text("{F_cr}, found once for the oscillator")),
            Step("curve", True, text("whether a stable motion passes {u_cr}; not where the force has one piece")),
        ),
        "hysteresis": (
            Step("folds", True, "the ends of the bands"),
            Step("states", True, "in the middle between each two folds: how many are stable"),
        ),
        "isolation": (
            Step("peaks", True, "up to which frequency there is anything to look at"),
            Step("curve", True, "its last stable point that transmits the force"),
            Step("root", True, "next to that point, in A"),
        ),
        "spectrum": (
            Step("states", True, "of each row"),
            Step("folds", True, "of the forcings on the way from row to row: on which side of it they lie"),
            Step("curve", False, "not needed: rows are tones"),
        ),
        "certify": (
            Step("folds", True, "as saddle_nodes has them"),
            Step("proof", True, PROOF),
        ),
        **dict.fromkeys(
            ("force", "stiffness"),
            (
                Step("formula", True, text("of the piece of the force that holds {u}")),
                Step("averaging", False, "not needed: nothing moves"),
            ),
        ),
        "backbone": (Step("formula", True, "explicit in A: where R = 0"), _NO_CURVE),
        "stability": (Step("formula", True, text("the left side of (30), explicit in {Omega} and A")), _NO_CURVE),
        "equivalent_damping": (Step("formula", True, text("explicit in {Omega} and A")), _NO_CURVE),
        "transmissibility_floor": (
            Step("formula", True, text("explicit in {F_0}: what friction passes on")),
            _NO_CURVE,
        ),
        "limit_envelope": (
            Step("formula", True, LIMIT),
            _NO_CURVE,
        ),
        "at_rest": (
            Step("force", True, "its stiffness at the centre, and how far friction holds the mass against it"),
            Step("averaging", False, "not needed: nothing moves"),
        ),
        "rest": (
            Step("boxes", True, text("{u} is cut until each part is proved to hold one place of rest, or none")),
            Step("averaging", False, "not needed: nothing moves"),
        ),
        "steady_state": (
            Step("averaging", True, "where A is given: states and folds to begin with"),
            Step("motion", True, _SWITCHES),
            Step("cycle", True, _NEWTON),
        ),
        "exact_response": (
            Step("start", True, "followed from rest at the lowest frequency until it is shown to settle"),
            Step("motion", True, _SWITCHES),
            Step("curve", True, f"{_NEWTON}; folds, borders and stability on the way"),
            Step("averaging", True, "which other curves there are, in words"),
        ),
        "sweep": (
            Step("motion", True, _SWITCHES),
            Step("settling", True, "at each frequency until it is shown to tend to a periodic motion"),
            Step("averaging", False, "not needed: a sweep only follows"),
        ),
        "transient": (
            Step("motion", True, f"{_SWITCHES}; during the pulse, and after it until it turns twice or rests"),
            Step("averaging", False, "not needed: a shock is no steady state"),
        ),
        "shock_spectrum": (
            Step("motion", True, f"of each pulse: {_SWITCHES}"),
            Step("averaging", False, "not needed: a shock is no steady state"),
        ),
    }
)
#: those of them that search for no fold
WITHOUT_FOLDS = (
    *("force", "stiffness", "backbone", "stability", "equivalent_damping", "transmissibility_floor", "limit_envelope"),
    *("at_rest", "rest", "sweep", "transient", "shock_spectrum"),
)
#: those of them that are about one forcing
AT_ONE = ("margins", "hysteresis", "isolation", "certify", "steady_state", "exact_response", "sweep")


def plan_composed(question: str, F_0: float | None, whole: Model) -> Plan:
    """The plan for one of `COMPOSED`."""
    return Plan(
        question,
        F_0,
        whole,
        question not in WITHOUT_FOLDS,
        COMPOSED[question],
    )


def _force(whole: Model, asked: str) -> Step:
    """The step of the force: what is asked of it, or what the mechanism itself tells of how it is known."""
    told = whole.mechanism.told
    return Step("force", True, asked if told is None else told(*whole.parameters))


def needs_no_solver(question: str, whole: Model) -> bool:
    """Whether it is known beforehand that there is no onset, or no detachment."""
    return whole.linear if question == "saddle_node_onset" else question == "detachment" and not whole.breakpoints


def plan_of_all(question: str, whole: Model) -> Plan:
    """The plan for one of `OF_ALL`, which are about every forcing."""
    told = QUARTIC.format(whole.laws.told()) if whole.laws.any else whole.flow.SCENE
    flow = Step("slow flow", True, told)
    if needs_no_solver(question, whole):
        why = words.NO_DETACHMENT if question == "detachment" else "a linear oscillator has none"
        name = "detachment" if question == "detachment" else "folds"
        return Plan(question, None, None, False, (Step(name, False, why),))
    if question == "detachment":
        return Plan(
            question, None, whole, False, (Step("force", True, text("its first piece, at A = {u_cr} only")), flow)
        )
    force = _force(whole, "all its pieces" if whole.breakpoints else "one piece: no angles, no corner")
    if question == "saddle_node_onset" and whole.zeta == 0 and not whole.laws.any:
        search = Step("fold locus", True, text("zeta = 0: {Omega}^2 = -h_A, so that the level says h - A h_A"))
        return Plan(question, None, whole, True, (force, flow, search))
    return Plan(question, None, whole, True, (force, flow, LOCUS[question]))
