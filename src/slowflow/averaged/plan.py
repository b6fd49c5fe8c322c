"""Plans: the steps by which a function is computed, and why steps are skipped."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from slowflow.answers.results import Remark, SaddleNodeOnset
from slowflow.averaged import messages, proofs
from slowflow.core import validate
from slowflow.core.model import Model
from slowflow.support.errors import Refused
from slowflow.support.text import Sentence, text
from slowflow_kernels.conventions import CLOSE


class Step(NamedTuple):
    """A step of a plan: whether it runs, with a description or the reason."""

    name: str
    runs: bool
    why: str

    def __str__(self) -> str:
        return f"{self.name:14}{'runs' if self.runs else 'skipped':9}{self.why}"


AT = Sentence(" at {F_0 = :g}")
ABOUT_ALL = Sentence("{F_0 = :r} is not allowed: {question:s} takes no forcing")
QUARTIC = Sentence("{laws:s}: F is a quartic in {Omega}")
QUADRATIC = Sentence("{laws:s}: F is a quadratic in {Omega}^2, roots in closed form")
BELOW = Sentence("{F_0} < {F_SN = :g}: there are none")
PIECES = text("pieces up to the largest amplitude at {F_0}")
#: whether it is linear
ONE_PIECE = ("one piece: no detachment, no corner", "linear: one piece, no detachment, no corner")
NO_FOLDS = Step("folds", False, "a linear oscillator has none")
FOLDS = "every amplitude and frequency with F = F_A = 0, and corners"
STATES = "number of states at each frequency: one on each piece of the curve"
IN_BALLS = "; where double precision is inconclusive, ball arithmetic by python-flint"
UNDAMPED = Step("fold locus", True, text("zeta = 0: {Omega}^2 = -h_A, so the forcing follows from h - A h_A"))
_NEWTON = "Newton's method for the periodic motion and its sequence of events, from averaging or the previous motion"
_MOTION = Step("motion", True, "Taylor series from event to event: stop, breakpoint, break-away")
_NOTHING_MOVES = Step("averaging", False, "not needed: a static question")
_NO_STEADY_STATE = Step("averaging", False, "not needed: the motion is not a steady state")
_CURVE = (
    Step("curve", True, "its folds, peaks and corners, and the arcs between them"),
    Step("folds", True, f"{FOLDS}; they divide the curve into pieces"),
    Step("phase", False, "computed when .phi is first read"),
)


def _formula(why: str) -> tuple[Step, ...]:
    return Step("formula", True, why), Step("curve", False, "not needed: a formula suffices")


#: what averaging solves, by what it does when it has the force and the slow flow
SOLVED: Mapping[str, tuple[Step, ...]] = MappingProxyType(
    {
        "frequency_response": _CURVE,
        "amplitudes": (*_CURVE, Step("number", True, STATES + IN_BALLS)),
        "saddle_nodes": (Step("folds", True, FOLDS + IN_BALLS),),
        "peak": (
            Step("peaks", True, "level crossings of the peak locus"),
            Step("folds", False, "not needed for this question"),
        ),
        "saddle_node_onset": (
            Step(
                "fold locus",
                False,
                "not traced: the lowest of cusps, isola points and corners is explicit in A",
            ),
        ),
        "detachment": (),
        "fold_locus": (Step("fold locus", True, "for each A the frequencies with F_A = 0, and their forcings"),),
        "cusps": (Step("fold locus", False, "not traced: cusps are explicit in A"),),
        "isola_points": (Step("fold locus", False, "not traced: isola points are explicit in A"),),
    }
)
#: questions that ask others, or the equation of motion, by what they do
COMPOSED: Mapping[str, tuple[Step, ...]] = MappingProxyType(
    {
        "margins": (
            Step("folds", True, text("number of folds at {F_0}")),
            Step("onset", True, text("{F_SN}, found once for the oscillator")),
            Step("detachment", True, text("{F_cr}, found once for the oscillator")),
            Step("peak", True, text("whether the highest stable motion passes {u_cr}; not for a force of one piece")),
        ),
        "hysteresis": (
            Step("folds", True, "the ends of the bands"),
            Step("states", True, "number of stable states midway between neighbouring folds"),
        ),
        "isolation": (
            Step("peaks", True, "the highest frequency at which a motion can transmit the force"),
            Step("curve", True, "the last stable point that transmits the force"),
            Step("root", True, "the crossing of the level next to that point, in A"),
        ),
        "spectrum": (
            Step("states", True, "states of each row"),
            Step(
                "folds",
                True,
                "at forcings between two rows: whether the path crosses a fold",
            ),
            Step("curve", False, "not needed: each row is a single tone"),
        ),
        "certify": (
            Step("folds", True, "as for saddle_nodes"),
            Step(
                "proof",
                True,
                text("in interval arithmetic: folds, {F_SN}, {F_cr}, and states if {Omega} is given"),
            ),
        ),
        **dict.fromkeys(
            ("force", "stiffness"),
            (Step("formula", True, text("the piece of the force that contains {u}")), _NOTHING_MOVES),
        ),
        "backbone": _formula("explicit in A: where R = 0"),
        "stability": _formula(text("the left side of (30), explicit in {Omega} and A")),
        "equivalent_damping": _formula(text("explicit in {Omega} and A")),
        "transmissibility_floor": _formula(text("explicit in {F_0}: the force transmitted by friction")),
        "limit_envelope": _formula(
            text("explicit in {Omega} and {F_0}: where damping alone balances {F_0}, I = {F_0} (27)")
        ),
        "at_rest": (
            Step("force", True, "its stiffness at the centre, and the distance within which friction holds the mass"),
            _NOTHING_MOVES,
        ),
        "rest": (
            Step(
                "boxes",
                True,
                text("the range of {u} is bisected until each interval is proved to hold one or no equilibrium"),
            ),
            _NOTHING_MOVES,
        ),
        "steady_state": (
            Step("averaging", True, "with A: states and folds as starting points"),
            _MOTION,
            Step("cycle", True, _NEWTON),
        ),
        "exact_response": (
            Step("start", True, "motion from rest at the lowest frequency, until it is shown to settle"),
            _MOTION,
            Step("curve", True, f"{_NEWTON}; with folds, changes of that sequence, and stability"),
            Step("averaging", True, "for a message about disconnected curves"),
        ),
        "sweep": (
            _MOTION,
            Step("settling", True, "at each frequency, until the motion is shown to tend to a periodic one"),
            Step("averaging", False, "not needed: a sweep only follows the motion"),
        ),
        "transient": (
            Step("motion", True, f"{_MOTION.why}; during the pulse, and then until the mass reverses twice or rests"),
            _NO_STEADY_STATE,
        ),
        "shock_spectrum": (Step("motion", True, f"for each pulse: {_MOTION.why}"), _NO_STEADY_STATE),
        "random": (
            Step(
                "linearization", True, "Gaussian averages of force and damping; all fixed points, by a complete search"
            ),
            _NO_STEADY_STATE,
        ),
    }
)
_PLANE = "the plane of amplitude A and mean B is divided until each box is proved to contain"
_REST = text(
    "the range of {u} is bisected until each interval is proved to contain one solution of f({u}) = load or none"
)
_BOXES = f"{_PLANE} one or none"

#: questions about motions in time, which do not ask where the centre is
_EXACT = ("steady_state", "exact_response", "sweep", "transient", "shock_spectrum", "random")
#: by question what runs for it off the centre, where there is one way to each answer
OFF_CENTRE: dict[str, tuple[Step, ...]] = {
    "rest": (Step("boxes", True, _REST),),
    "detachment": (
        Step("boxes", True, "motions with |B| + A at the first breakpoint whose mean is in balance"),
        Step("forcing", True, "the lowest of their forcings over all frequencies"),
    ),
    "saddle_node_onset": (
        Step("descent", True, "along the fold locus down to a minimum of the forcing"),
        Step("boxes", True, f"{_PLANE} no fold at a lower forcing"),
    ),
    "amplitudes": (Step("boxes", True, f"{_BOXES}, at each frequency"),),
    "saddle_nodes": (
        Step("boxes", True, text(f"{_BOXES}; A, B and {{Omega}} of a fold are its unknowns")),
        Step("corners", True, "folds on a breakpoint at which the force jumps"),
    ),
    "frequency_response": (
        Step("folds", True, "all folds; they divide the response into arcs"),
        Step("states", True, "all states at a frequency between each two folds, which identify the arcs"),
        Step("curve", True, "each arc is followed; neighbouring points are shown to be connected"),
    ),
    "peak": (Step("boxes", True, f"{_PLANE} no larger motion, by a bound on the forcing that it needs"),),
    "margins": (
        *(step for step in COMPOSED["margins"] if step.name != "curve"),
        Step("reach", True, text("whether a stable motion passes {u_cr}; not for a force of one piece")),
    ),
    "isolation": (
        Step("boxes", True, "the highest frequency at which a motion can transmit the force"),
        Step("curve", True, "the last stable point that transmits the force"),
        Step("root", True, "the crossing of the level next to that point"),
        Step("proof", True, f"{_PLANE} no stable motion that transmits the force at a higher frequency"),
    ),
    "spectrum": COMPOSED["spectrum"][:-1],
    **{question: COMPOSED[question] for question in ("force", "stiffness", "hysteresis", *_EXACT)},
}
#: every question of an oscillator about the centre
QUESTIONS = (*SOLVED, *COMPOSED)
#: those about one forcing
AT_ONE = (
    *("frequency_response", "amplitudes", "saddle_nodes", "peak"),
    *("margins", "hysteresis", "isolation", "certify", "steady_state", "exact_response", "sweep"),
)


class Plan(NamedTuple):
    """The steps to an answer.

    model  -- model for the solvers; None if nothing has to be solved
    sticks -- whether the mass stays at rest
    steps  -- the steps, with text
    where  -- text about the forcing
    """

    question: str
    F_0: float | None
    model: Model | None
    steps: tuple[Step, ...]
    where: str = ""

    @property
    def sticks(self) -> bool:
        """Whether nothing is solved, because the mass stays at rest."""
        return self.model is None

    def __str__(self) -> str:
        at = "" if self.F_0 is None else AT.format(self.F_0)
        return "\n".join([f"{self.question}{self.where or at}", *(f"  {step}" for step in self.steps)])


def forcing(question: str, F_0: float | None) -> float | None:
    """F_0 of a question at one forcing, None for others. Raises ValueError if it is missing, or not expected."""
    if question in AT_ONE:
        return validate.number("F_0", F_0, above=0.0)
    if F_0 is not None:
        raise Refused(ABOUT_ALL.format(F_0, question))
    return None


def may_have_folds(F_0: float, whole: Model, onset: SaddleNodeOnset | None) -> bool:
    """Whether folds are searched for: not for a linear oscillator, nor below the onset, however F_SN is rounded."""
    if whole.linear:
        return False
    if onset is None or onset.F_SN is None or Remark.FOLDS_AT_REST in onset.remarks:
        return True
    return bool(onset.F_SN * (1 - CLOSE) <= F_0)


def needs_no_solver(question: str, whole: Model) -> bool:
    """Whether it is known in advance that there is no onset, or no detachment."""
    return whole.linear if question == "saddle_node_onset" else question == "detachment" and not whole.breakpoints


def plan(question: str, F_0: float | None, whole: Model, onset: SaddleNodeOnset | None = None) -> Plan:
    """The plan for one of `QUESTIONS`.

    F_0   -- as returned by `forcing`
    whole -- the oscillator
    onset -- the onset of folds, if it is known already
    """
    if question in COMPOSED:
        return Plan(question, F_0, whole, COMPOSED[question])
    if F_0 is not None and whole.sticks(F_0):
        skipped = ("force", "slow flow", "curve", "folds")
        return Plan(question, F_0, None, tuple(Step(name, False, messages.sticks(whole, F_0)) for name in skipped))
    if needs_no_solver(question, whole):
        none = Step(question, False, messages.NO_DETACHMENT) if question == "detachment" else NO_FOLDS
        return Plan(question, None, None, (none,))
    steps = SOLVED[question]
    if F_0 is not None and question == "saddle_nodes" and not may_have_folds(F_0, whole, onset):
        steps = (NO_FOLDS if onset is None or whole.linear else Step("folds", False, BELOW.format(onset.F_SN)),)
    elif question == "saddle_node_onset" and whole.zeta == 0 and not whole.laws.any:
        steps = (UNDAMPED,)
    elif not proofs.is_plain(whole):
        kept = (step for step in steps if step.name != "number")
        steps = tuple(step._replace(why=step.why.removesuffix(IN_BALLS)) for step in kept)
    vanishing = [name for name, value in (("{mu}", whole.mu), ("zeta", whole.zeta)) if value == 0]
    if vanishing and not whole.laws.any:
        equation = QUADRATIC.format(text(" = ".join([*vanishing, "0"])))
    else:
        equation = QUARTIC.format(whole.laws.description() if whole.laws.any else text("{mu} > 0, zeta > 0"))
    return Plan(question, F_0, whole, (_force(question, F_0, whole), Step("slow flow", True, equation), *steps))


def plan_off_centre(question: str, F_0: float | None, model: Model) -> Plan:
    """The plan for one of `OFF_CENTRE`. Raises ValueError for a forcing that is missing, or not expected."""
    at = forcing(question, F_0)
    may_stick = question in ("amplitudes", "saddle_nodes", "frequency_response", "isolation")
    if at is not None and may_stick and model.sticks(at):
        return Plan(question, at, None, (Step("boxes", False, messages.sticks(model, at)),))
    return Plan(question, at, model, OFF_CENTRE[question])


def _force(question: str, F_0: float | None, whole: Model) -> Step:
    """The step of the force: what is evaluated, or the mechanism's own description of how it is known."""
    description = whole.mechanism.told
    if question == "detachment":
        return Step("force", True, text("the first piece, at A = {u_cr} only"))
    if description is not None:
        return Step("force", True, description(*whole.parameters))
    if not whole.breakpoints:
        return Step("force", True, ONE_PIECE[whole.linear])
    return Step("force", True, PIECES if F_0 is not None else "all pieces")
