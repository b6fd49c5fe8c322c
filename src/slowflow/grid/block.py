"""What runs for one block of a map, anywhere: in go a question and a block's numbers, out come its columns.

It pickles, and refuses to run where slowflow is another than where the map was asked for: a map is of one version.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow import backend
from slowflow.averaged import asked, many
from slowflow.mechanism import Mechanism
from slowflow.version import __version__

if TYPE_CHECKING:
    from slowflow.second.many import SecondDesigns


class Question(NamedTuple):
    """One of the questions about many designs: what asks it, its answer, what it takes beside the designs, and may."""

    asked: asked.Question
    answer: type[many.Batch]
    takes: tuple[str, ...] = ()
    may: tuple[str, ...] = ()


#: by the names of the methods of `Designs`
QUESTIONS = {
    "detachment": Question(asked.DETACHMENT, many.Detachments),
    "saddle_node_onset": Question(asked.ONSET, many.Onsets),
    "saddle_nodes": Question(asked.SADDLE_NODES, many.Folds, ("F_0", "places")),
    "amplitudes": Question(asked.AMPLITUDES, many.States, ("F_0", "Omega", "places")),
    "peak": Question(asked.PEAK, many.Peaks, ("F_0",)),
    "certify": Question(asked.PROVED_FOLDS, many.Proofs, ("F_0",), ("Omega",)),
}


#: numbers beside those of the designs, which broadcast with them
FORCED = ("F_0", "Omega")
#: averaging, and beyond
DEPTHS = ("averaging", "second approximation")


class Column(NamedTuple):
    """A column of an answer: its shape behind that of the designs, and its type."""

    inner: tuple[int, ...]
    kind: np.dtype[Any]


def made_by(mechanism: Mechanism) -> dict[str, str]:
    """Which slowflow computes here, and how: two that differ may differ in the last place."""
    compiled = backend.record_of(mechanism) is not None
    return {"slowflow": __version__, "backend": backend.NAME if compiled else "numpy"}


@dataclass(frozen=True)
class Ask:
    """A question about designs, asked block by block.

    excitation, rubs -- what F_0 is the amplitude of, and where dry friction acts
    depth   -- one of `DEPTHS`
    names   -- of the numbers that it is called with: the design's, mu, zeta and those of other laws of damping, and F_0
               and Omega where it takes them
    places  -- of folds or states; 0 for a question without
    workers -- threads that share a block
    made_by -- of the slowflow that is to answer
    """

    mechanism: Mechanism
    excitation: str
    rubs: str
    question: str
    depth: str
    names: tuple[str, ...]
    places: int
    workers: int
    made_by: dict[str, str]

    def columns(self) -> dict[str, Column]:
        """What is answered, by name; remarks last."""
        asked, answer, *_ = QUESTIONS[self.question]
        names = (entry.name for entry in dataclasses.fields(answer) if entry.repr)
        parts = zip(names, asked.outputs(self.places), strict=True)
        return {name: Column(inner, np.dtype(kind)) for name, (inner, kind) in parts} | {
            "remarks": Column((), np.dtype(np.uint8))
        }

    def __call__(self, *values: Any) -> tuple[npt.NDArray[Any], ...]:
        """The columns for numbers that broadcast. Raises RuntimeError where another slowflow runs."""
        here = made_by(self.mechanism)
        if self.made_by != here:
            raise RuntimeError(f"this process runs {here}, the map is made by {self.made_by}")
        given = dict(zip(self.names, values, strict=True))
        beside = {name: value for name, value in (("places", self.places),) if name in QUESTIONS[self.question].takes}
        beside |= {name: given.pop(name) for name in FORCED if name in given}
        answer = getattr(self._designs(given), self.question)(**beside, workers=self.workers)
        return tuple(getattr(answer, name) for name in self.columns())

    def _designs(self, given: dict[str, Any]) -> many.Designs | SecondDesigns:
        designs = many.Designs(self.mechanism, given, self.excitation, self.rubs)
        if self.depth == DEPTHS[0]:
            return designs
        from slowflow.second.many import SecondDesigns

        return SecondDesigns(designs)
