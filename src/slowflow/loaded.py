"""What stands for the slow flow of an oscillator under a static load: its numbers in, refusals of all else out.

A load takes the mass off the centre, about which every answer is that does not say `B`. Those questions ask the slow
flow, `Model`; an oscillator with a load has this in its place, so that none can answer as if the load were none.
"""

from __future__ import annotations

from typing import Any

from slowflow.mechanism import Mechanism
from slowflow.model import Model
from slowflow.text import Sentence, text
from slowflow.validate import NoAttribute

#: what a load leaves as it is
KNOWN = (
    *("mechanism", "parameters", "design", "mu", "zeta", "laws", "m"),
    *("excitation", "inertial", "force", "sticks", "breakpoints", "reach"),
)

#: questions that look at motions about the centre, or begin there
CENTRED = Sentence("{question:s} is not available with {why:s}, only about the centre")
AT_CENTRE = Sentence(
    "{why:s}: not available, this question is about motions about the centre. Off it there are rest, detachment, "
    "saddle_nodes, saddle_node_onset, amplitudes, frequency_response, peak, margins, hysteresis, isolation, spectrum, "
    "and exact motions: steady_state, exact_response, sweep, transient and shock_spectrum"
)


def off_centre_by(mechanism: Mechanism, load: float) -> str:
    """What takes motions off the centre, in words; "" for nothing."""
    if not mechanism.odd:
        return "a force that is not odd"
    return text("{load = :g}", load) if load != 0 else ""


class Loaded:
    """The numbers of an oscillator under a load or with a force that is not odd; all else of it is refused."""

    def __init__(self, model: Model, load: float) -> None:
        self.unloaded, self.load = model, load
        for name in KNOWN:
            setattr(self, name, getattr(model, name))
        # off the centre a preload does not change sides next to rest: friction alone holds the mass there
        self.break_loose, self.preload = model.m, 0.0

    def holds(self, F_0: float) -> bool:
        """Whether a mass at rest stays there while there are motions as well: none does, as the preload is 0."""
        return False

    def arguments(self) -> dict[str, Any]:
        """As of `Model`, with the load."""
        return {**self.unloaded.arguments(), "load": self.load}

    def __getattr__(self, name: str) -> Any:
        # what copying and pickling ask for is asked before there are any numbers
        if name.startswith("_") or "load" not in self.__dict__:
            raise AttributeError(name)
        raise NoAttribute(AT_CENTRE.format(off_centre_by(self.unloaded.mechanism, self.load)))
