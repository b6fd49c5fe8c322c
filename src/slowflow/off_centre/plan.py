"""What runs for a question off the centre. Takes the question and a forcing; returns the plan, in words.

There is one way to each answer; what depends on numbers is whether the mass sticks.
"""

from __future__ import annotations

from slowflow.averaged import messages
from slowflow.averaged.plan import COMPOSED, Plan, Step, forcing
from slowflow.model import Model
from slowflow.text import text

_PLANE = "the plane of amplitude A and mean B is cut until each box is proved to hold"
REST = text("{u} is cut until each part is proved to hold one place with f({u}) = load, or none")
_BOXES = f"{_PLANE} one or none"

#: questions to the equation of motion, which does not ask where the centre is
EXACT = ("steady_state", "exact_response", "sweep", "transient", "shock_spectrum")
#: by question what runs for it
STEPS: dict[str, tuple[Step, ...]] = {
    "rest": (Step("boxes", True, REST),),
    "detachment": (
        Step("boxes", True, "along |B| + A at the first breakpoint: where the mean is balanced"),
        Step("forcing", True, "the least of these, each at its best frequency"),
    ),
    "saddle_node_onset": (
        Step("descent", True, "from a fold down to where the forcing is stationary"),
        Step("boxes", True, f"{_PLANE} no fold at a lower forcing"),
    ),
    "amplitudes": (Step("boxes", True, f"{_BOXES}, at each frequency"),),
    "saddle_nodes": (
        Step("boxes", True, text(f"{_BOXES}; A, B and {{Omega}} of a fold are its unknowns")),
        Step("corners", True, "folds on a breakpoint at which the force jumps"),
    ),
    "frequency_response": (
        Step("folds", True, "all of them: they cut the response into arcs"),
        Step("states", True, "all of them between each two folds: they tell the arcs"),
        Step("curve", True, "each arc followed, and neighbours shown to be on one"),
    ),
    "peak": (Step("boxes", True, f"{_PLANE} no motion that goes farther, by a bound on its least forcing"),),
    "margins": (
        *(step for step in COMPOSED["margins"] if step.name != "curve"),
        Step("reach", True, text("whether a stable motion passes {u_cr}; not where the force has one piece")),
    ),
    "isolation": (
        Step("boxes", True, "up to which frequency there is anything to look at"),
        Step("curve", True, "its last stable point that transmits the force"),
        Step("root", True, "next to that point"),
        Step("proof", True, f"{_PLANE} no stable motion that transmits the force beyond it"),
    ),
    "spectrum": COMPOSED["spectrum"][:-1],
    **{question: COMPOSED[question] for question in ("force", "stiffness", "hysteresis", *EXACT)},
}


def plan(question: str, F_0: float | None, model: Model) -> Plan:
    """The plan for one of `STEPS`. Raises ValueError for a forcing that is missing, or not needed."""
    at = forcing(question, F_0)
    may_stick = question in ("amplitudes", "saddle_nodes", "frequency_response", "isolation")
    if at is not None and may_stick and model.sticks(at):
        return Plan(question, at, None, (Step("boxes", False, messages.sticks(model, at)),))
    return Plan(question, at, model, STEPS[question])
