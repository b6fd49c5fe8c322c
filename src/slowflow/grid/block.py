"""What runs for one block of a map, anywhere. Takes a question and a block's numbers; returns its columns.

It pickles, and refuses to run where slowflow is another than where the map was asked for: a map is of one version. A
file outlives the program that wrote it: units, codes with their words, and which slowflow it was stand in it, as
attributes that CF knows.
"""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow.answers.results import Remark
from slowflow.answers.table import AVERAGING, COLUMNS, MORE_POINTS, OFFSET, QUESTIONS, ManyQuestions, Question
from slowflow.core import backend
from slowflow.core.mechanism import Mechanism
from slowflow.core.model import THROUGHOUT
from slowflow.grid.many import Designs
from slowflow.grid.offset import OffCentreDesigns
from slowflow.second.many import SecondDesigns
from slowflow.version import __version__
from slowflow_kernels.conventions import FoldKind, Status
from slowflow_kernels.domains import DAMPING, DISSIPATION

#: axes of places, of tables and of records, which are never cut
INNER = ("place", "point", "row", "instant")
#: status of a design in a block that is not computed yet; none of the solvers'
NOT_YET = -1
UNITS = "dimensionless"
#: units of what is not dimensionless
UNITS_OF = {"phi": "rad", "transmissibility_dB": "dB", "level_dB": "dB"}


def made_by(mechanism: Mechanism) -> dict[str, str]:
    """Which slowflow computes here, and how: two that differ may differ in the last place."""
    return {"slowflow": __version__, "compiled": str(backend.record_of(mechanism) is not None)}


@dataclass(frozen=True)
class Ask:
    """A question about designs, asked block by block.

    excitation, contact -- what F_0 is the amplitude of, and where dry friction acts
    depth   -- by what it is answered without a load, `AVERAGING` or `SECOND`
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
    contact: str
    question: str
    depth: str
    names: tuple[str, ...]
    options: tuple[tuple[str, Any], ...]
    tables: tuple[str, ...]
    lengths: tuple[tuple[str, int], ...]
    workers: int
    made_by: dict[str, str]

    @property
    def row(self) -> Question:
        """Its row of the table."""
        return QUESTIONS[self.question]

    def columns(self) -> dict[str, tuple[str, np.dtype[Any]]]:
        """What is answered, by name, each with its axis and type; remarks last."""
        return self.row.layout(OFFSET if "load" in self.names else self.depth)

    def __call__(self, *values: Any) -> tuple[npt.NDArray[Any], ...]:
        """The columns for numbers that broadcast. Raises RuntimeError where another slowflow runs."""
        here = made_by(self.mechanism)
        if self.made_by != here:
            raise RuntimeError(f"this process runs {here}, the map is made by {self.made_by}")
        numbers, row = dict(zip(self.names, values, strict=True)), self.row
        extra = {name: numbers.pop(name) for name in (*row.takes, *row.may) if name in numbers}
        for name in extra:  # a table has a row at least
            if row.argument_axes.get(name) == "row" and name not in self.tables:
                extra[name] = np.asarray(extra[name])[..., np.newaxis]
        arguments = {**dict.fromkeys(row.may), **extra, **dict(self.options)}
        answer = self._designs(numbers)._ask(self.question, **arguments, workers=self.workers)
        return tuple(getattr(answer, name) for name in self.columns())

    def _designs(self, numbers: dict[str, Any]) -> ManyQuestions[Any]:
        if "load" in numbers:
            return OffCentreDesigns(self.mechanism, numbers, self.excitation)
        designs = Designs(self.mechanism, numbers, self.excitation, self.contact)
        return designs if self.depth == AVERAGING else SecondDesigns(designs)


def lengths(row: Question, system: str, options: Mapping[str, Any], rows: int) -> tuple[tuple[str, int], ...]:
    """Of the axes that an answer has behind those of the designs."""
    points = options.get("samples", 0) + MORE_POINTS[system]
    known = {"place": options.get("max_count", 0), "point": points, "row": rows}
    own = set(row.columns[system].values())
    return tuple((axis, known[axis]) for axis in INNER if axis in own)


# ---- what the columns of a map mean


def of_map(ask: Ask) -> dict[str, Any]:
    """Of a whole map."""
    about = {"mechanism": ask.mechanism.name, "title": ask.mechanism.title, "excitation": ask.excitation}
    about |= {"question": ask.question, **({} if ask.contact == THROUGHOUT else {"contact": ask.contact})}
    return {**about, "depth": ask.depth, **ask.made_by}


def of_column(ask: Ask, name: str) -> dict[str, Any]:
    """Of a column of an answer, or of one of the numbers that it was asked with."""
    known = {domain.name: domain.doc for domain in (*ask.mechanism.design, *DAMPING, *DISSIPATION)}
    found: dict[str, Any] = {"long_name": known.get(name) or COLUMNS[name].text}
    flags = {"remarks": Remark, "status": Status, "onset": Status, "fold_kind": FoldKind, "kind": ask.row.kinds}
    kind: Any = flags.get(name)
    if kind is None:
        return {**found, "units": UNITS_OF.get(name, UNITS)}
    values, meanings = list(map(int, kind)), " ".join(code.name for code in kind)
    if name == "remarks":
        return {**found, "flag_masks": values, "flag_meanings": meanings}
    if name == "status":
        values, meanings = [NOT_YET, *values], f"NOT_YET {meanings}"
    # what each number stands for, as the derivation states it
    return {**found, "flag_values": values, "flag_meanings": meanings, "meaning": inspect.cleandoc(kind.__doc__ or "")}
