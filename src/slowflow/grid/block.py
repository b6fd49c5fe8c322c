"""What runs for one block of a map, anywhere: in go a question and a block's numbers, out come its columns.

It pickles, and refuses to run where slowflow is another than where the map was asked for: a map is of one version.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow import backend, loads_many, validate
from slowflow.averaged import batches
from slowflow.averaged.asked import MORE_POINTS
from slowflow.averaged.batches import Column
from slowflow.averaged.many import Designs
from slowflow.exact import shocks_many
from slowflow.mechanism import Mechanism
from slowflow.off_centre import many as off_centre
from slowflow.off_centre.many import OffCentreDesigns
from slowflow.off_centre.questions import OffCentre
from slowflow.second.many import UNANSWERED as OF_BATCHES
from slowflow.second.many import SecondDesigns
from slowflow.version import __version__
from slowflow_support.errors import Refused


class Question(NamedTuple):
    """One of the questions about many designs.

    answer  -- what it is answered by
    by      -- what answers it, of the designs; beyond -- of those in the second approximation, None where that does not
    takes   -- numbers that it takes beside the designs', which broadcast with these; may -- and those that it may
    options -- what else it takes, the same for all designs, with its default
    along   -- the axis of a table or a record that such a number may have behind those of the designs
    """

    answer: type[batches.Batch]
    by: Callable[..., batches.Batch]
    beyond: Callable[..., batches.Batch] | None = None
    takes: tuple[str, ...] = ()
    may: tuple[str, ...] = ()
    options: Mapping[str, Any] = {}
    along: Mapping[str, str] = {}


def _transient(designs: Designs, acceleration: Any, workers: int, **pulse: Any) -> shocks_many.Transients:
    given = {"duration": None, "tau": None, **pulse}
    return shocks_many.transients(designs, acceleration, workers=workers, off_centre=OffCentre, **given)


#: why maps have no answer to a question in the second approximation
UNANSWERED = {
    **OF_BATCHES,
    "amplitudes": "a map has no states of the second approximation, many designs without named axes have",
    "frequency_response": "a map has no curves of the second approximation, many designs without named axes have",
}

TABLE, RECORD = {"Omega": "row", "F_0": "row"}, {"tau": "instant", "acceleration": "instant"}
CURVE = {"samples": 1000, "Omega": validate.WINDOW, "places": 6}
PULSE = ("acceleration", "duration")
#: by name
QUESTIONS: Mapping[str, Question] = {
    "detachment": Question(batches.Detachments, Designs.detachment, SecondDesigns.detachment),
    "saddle_node_onset": Question(batches.Onsets, Designs.saddle_node_onset, SecondDesigns.saddle_node_onset),
    "saddle_nodes": Question(
        batches.Folds, Designs.saddle_nodes, SecondDesigns.saddle_nodes, ("F_0",), options={"places": 6}
    ),
    "amplitudes": Question(batches.States, Designs.amplitudes, takes=("F_0", "Omega"), options={"places": 6}),
    "frequency_response": Question(batches.Curves, Designs.frequency_response, takes=("F_0",), options=CURVE),
    "peak": Question(batches.Peaks, Designs.peak, SecondDesigns.peak, ("F_0",)),
    "certify": Question(batches.Proofs, Designs.certify, takes=("F_0",), may=("Omega",)),
    "at_rest": Question(loads_many.ManyAtRest, loads_many.at_rest),
    "margins": Question(loads_many.ManyMargins, loads_many.margins, takes=("F_0",)),
    "hysteresis": Question(loads_many.ManyBands, loads_many.hysteresis, takes=("F_0",), options={"places": 3}),
    "isolation": Question(loads_many.ManyIsolations, loads_many.isolation, takes=("F_0",)),
    "spectrum": Question(loads_many.ManySpectra, loads_many.spectrum, takes=("Omega", "F_0"), along=TABLE),
    "transient": Question(
        shocks_many.Transients,
        _transient,
        takes=("acceleration",),
        may=("duration", "tau"),
        options={"after": None},
        along=RECORD,
    ),
    "shock_spectrum": Question(shocks_many.Shocks, partial(shocks_many.of_designs, off_centre=OffCentre), takes=PULSE),
}
#: the same of designs under a load
LOADED: Mapping[str, Question] = {
    "rest": Question(off_centre.ManyRests, OffCentreDesigns.rest, options={"places": 3}),
    **{
        name: QUESTIONS[name]._replace(answer=answer, by=by, beyond=None)
        for name, answer, by in (
            ("detachment", off_centre.ManyDetachments, OffCentreDesigns.detachment),
            ("saddle_node_onset", off_centre.ManyOnsets, OffCentreDesigns.saddle_node_onset),
            ("saddle_nodes", off_centre.ManyFolds, OffCentreDesigns.saddle_nodes),
            ("amplitudes", off_centre.ManyStates, OffCentreDesigns.amplitudes),
            ("frequency_response", off_centre.OffCentreCurves, OffCentreDesigns.frequency_response),
            ("peak", off_centre.ManyPeaks, OffCentreDesigns.peak),
            ("margins", off_centre.OffCentreMargins, OffCentreDesigns.margins),
            ("hysteresis", off_centre.OffCentreBands, OffCentreDesigns.hysteresis),
            ("isolation", off_centre.OffCentreIsolations, OffCentreDesigns.isolation),
            ("spectrum", loads_many.ManySpectra, OffCentreDesigns.spectrum),
            ("transient", off_centre.OffCentreTransients, OffCentreDesigns.transient),
            ("shock_spectrum", off_centre.OffCentreShocks, OffCentreDesigns.shock_spectrum),
        )
    },
}
#: axes of places, of tables and of records, which are never cut
INNER = ("place", "point", "row", "instant")
#: averaging, and beyond
DEPTHS = ("averaging", "second approximation")


def made_by(mechanism: Mechanism) -> dict[str, str]:
    """Which slowflow computes here, and how: two that differ may differ in the last place."""
    compiled = backend.record_of(mechanism) is not None
    return {"slowflow": __version__, "backend": backend.NAME if compiled else "numpy"}


@dataclass(frozen=True)
class Ask:
    """A question about designs, asked block by block.

    excitation, rubs -- what F_0 is the amplitude of, and where dry friction acts
    depth   -- one of `DEPTHS`
    names   -- of the numbers that it is called with: the design's, mu, zeta and those of other laws of damping, a load,
               and what the question takes beside these
    options -- what else it takes
    tables  -- of the numbers those that have an axis of a table or a record, the last one
    lengths -- of axes that the answer has behind those of the designs
    workers -- threads that share a block
    made_by -- of the slowflow that is to answer
    """

    mechanism: Mechanism
    excitation: str
    rubs: str
    question: str
    depth: str
    names: tuple[str, ...]
    options: tuple[tuple[str, Any], ...]
    tables: tuple[str, ...]
    lengths: tuple[tuple[str, int], ...]
    workers: int
    made_by: dict[str, str]

    @property
    def asked(self) -> Question:
        """What it is among those of these designs."""
        return (LOADED if "load" in self.names else QUESTIONS)[self.question]

    def columns(self) -> dict[str, Column]:
        """What is answered, by name; remarks last."""
        return self.asked.answer.layout()

    def __call__(self, *values: Any) -> tuple[npt.NDArray[Any], ...]:
        """The columns for numbers that broadcast. Raises RuntimeError where another slowflow runs."""
        here = made_by(self.mechanism)
        if self.made_by != here:
            raise RuntimeError(f"this process runs {here}, the map is made by {self.made_by}")
        given, asked = dict(zip(self.names, values, strict=True)), self.asked
        beside = {name: given.pop(name) for name in (*asked.takes, *asked.may) if name in given}
        for name in beside:  # a table has a row at least
            if asked.along.get(name) == "row" and name not in self.tables:
                beside[name] = np.asarray(beside[name])[..., np.newaxis]
        designs = self._designs(given)
        by = asked.beyond if isinstance(designs, SecondDesigns) else asked.by
        if by is None:
            raise Refused(f"{self.question}: {UNANSWERED[self.question]}")
        answer = by(designs, **beside, **dict(self.options), workers=self.workers)
        return tuple(getattr(answer, name) for name in self.columns())

    def _designs(self, given: dict[str, Any]) -> Designs | SecondDesigns | OffCentreDesigns:
        if "load" in given:
            return OffCentreDesigns(self.mechanism, given, self.excitation)
        designs = Designs(self.mechanism, given, self.excitation, self.rubs)
        return designs if self.depth == DEPTHS[0] else SecondDesigns(designs)


def lengths(asked: Question, options: Mapping[str, Any], rows: int) -> tuple[tuple[str, int], ...]:
    """Of the axes that an answer has behind those of the designs."""
    known = {"place": options.get("places", 0), "point": options.get("samples", 0) + MORE_POINTS, "row": rows}
    own = {axis for column in asked.answer.layout().values() for axis in column.inner}
    return tuple((axis, known[axis]) for axis in INNER if axis in own)
