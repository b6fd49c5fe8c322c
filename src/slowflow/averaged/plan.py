"""What runs for a question and what does not: in go an oscillator's models and the question, out comes the plan.

The plan is made in one place and obeyed: an oscillator hands its solvers `Plan.model`, and asks for nothing that the
plan skips. `str(plan)` tells it, step by step, with the reasons.
"""

from __future__ import annotations

from dataclasses import dataclass

from slowflow.averaged import words
from slowflow.model import Model
from slowflow.results import Remark, SaddleNodeOnset

#: questions at one forcing
QUESTIONS = ("frequency_response", "amplitudes", "saddle_nodes", "peak")


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


@dataclass(frozen=True)
class Plan:
    """The way to an answer.

    model -- what the solvers get; None where nothing has to be solved
    folds -- whether folds are searched for
    sticks -- whether the mass stays at rest
    steps -- the same in words
    """

    question: str
    F_0: float
    model: Model | None
    folds: bool
    steps: tuple[Step, ...]

    @property
    def sticks(self) -> bool:
        """Whether nothing is solved because the mass stays at rest."""
        return self.model is None

    def __str__(self) -> str:
        return "\n".join([f"{self.question} at F_0 = {self.F_0:g}", *(f"  {step}" for step in self.steps)])


def plan(question: str, F_0: float, whole: Model, onset: SaddleNodeOnset | None) -> Plan:
    """The plan for one of `QUESTIONS` at F_0 > 0.

    whole -- the oscillator
    onset -- the onset of folds, if it has been asked for already
    """
    if F_0 <= whole.m:
        return Plan(
            question,
            F_0,
            None,
            False,
            tuple(Step(name, False, words.sticks(whole, F_0)) for name in ("force", "slow flow", "curve", "folds")),
        )
    if whole.linear:
        force = Step("force", True, "linear: one piece, no angles, no corner")
    elif not whole.breakpoints:
        force = Step("force", True, "one piece: no angles, no corner")
    else:
        force = Step("force", True, "its pieces up to the highest amplitude at F_0")
    flow = Step("slow flow", True, whole.flow.SCENE)
    if question == "peak":
        return Plan(question, F_0, whole, False, (force, flow, *PEAK))
    if question != "saddle_nodes":
        return Plan(question, F_0, whole, True, (force, flow, *CURVE))
    if whole.linear:
        folds = Step("folds", False, "a linear oscillator has none")
    elif (
        onset is not None and onset.F_SN is not None and F_0 < onset.F_SN and Remark.FOLDS_AT_REST not in onset.remarks
    ):
        folds = Step("folds", False, f"F_0 < F_SN = {onset.F_SN:g}: there is none")
    else:
        folds = Step("folds", True, "level crossings of the fold locus, and corners")
    return Plan(question, F_0, whole, folds.runs, (force, flow, folds))
