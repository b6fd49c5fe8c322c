"""What runs for one block of a map, anywhere. Takes a question and a block's numbers; returns its columns.

It pickles, and refuses to run where slowflow is another than where the map was asked for: a map is of one version. A
file outlives the program that wrote it: units, codes with their words, and which slowflow it was stand in it, as
attributes that CF knows.
"""

from __future__ import annotations

import dataclasses
import inspect
from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow.answers.results import Remark
from slowflow.answers.table import QUESTIONS
from slowflow.core import backend
from slowflow.core.mechanism import Mechanism
from slowflow.version import __version__
from slowflow_kernels.conventions import FoldKind, Status

#: axes of places, of tables and of records, which are never cut
INNER = ("place", "point", "row", "instant")
#: status of a design in a block that is not computed yet; none of the solvers'
NOT_YET = -1
DIMENSIONLESS = "dimensionless"
#: units of what is not, besides quantities in SI units
UNITS_OF = {"phi": "rad", "transmissibility_dB": "dB", "level_dB": "dB"}


def made_by(mechanism: Mechanism) -> dict[str, str]:
    """Which slowflow computes here, and how: two that differ may differ in the last place."""
    return {"slowflow": __version__, "compiled": str(backend.record_of(mechanism) is not None)}


class MapColumn(NamedTuple):
    """A column of a map: its axis after those of the designs, "" for none, with its length; type and attributes."""

    axis: str
    length: int
    type: np.dtype[Any]
    attributes: dict[str, Any]


@dataclass(frozen=True)
class Ask:
    """A question about designs, asked block by block.

    designs   -- of the kind that is asked; a block's are these with other numbers
    mechanism -- theirs
    names     -- of the numbers that it is called with: the designs', and what the question takes in addition
    options   -- what else it takes, by name
    tables    -- of the numbers those that have an axis of a table or a record, the last one
    plain     -- the dimensionless names of arguments and options, by name
    workers   -- threads that share a block
    columns   -- of the answer by name, remarks last
    about     -- attributes of the whole map
    """

    designs: Any
    mechanism: Mechanism
    question: str
    names: tuple[str, ...]
    options: Mapping[str, Any]
    tables: tuple[str, ...]
    plain: Mapping[str, str]
    workers: int
    columns: Mapping[str, MapColumn] = dataclasses.field(default_factory=dict)
    about: Mapping[str, str] = dataclasses.field(default_factory=dict)

    @property
    def lengths(self) -> dict[str, int]:
        """Of the axes that the answer has behind those of the designs."""
        return {axis: length for axis, length, *_ in self.columns.values() if axis}

    def __call__(self, *values: Any) -> tuple[npt.NDArray[Any], ...]:
        """The columns for numbers that broadcast. Raises RuntimeError where another slowflow runs."""
        here = made_by(self.mechanism)
        there = {name: self.about[name] for name in here}
        if there != here:
            raise RuntimeError(f"this process runs {here}, the map is made by {there}")
        answer = self.answer(*values)
        return tuple(getattr(answer, name) for name in self.columns)

    def answer(self, *values: Any) -> Any:
        """The answer of many designs, from numbers that broadcast."""
        numbers, row = dict(zip(self.names, values, strict=True)), QUESTIONS[self.question]
        extra = {name: numbers.pop(name) for name in self.plain if name in numbers}
        for name in extra:  # a table has a row at least
            if row.argument_axes.get(self.plain[name]) == "row" and name not in self.tables:
                extra[name] = np.asarray(extra[name])[..., np.newaxis]
        arguments = {self.plain[name]: value for name, value in {**extra, **self.options}.items()}
        designs = self.designs._with_values(numbers)
        return designs._ask(self.question, **{**dict.fromkeys(row.may), **arguments}, workers=self.workers)


def attributes(name: str, text: str, unit: str, kinds: type[IntEnum] | None) -> dict[str, Any]:
    """What a file says of numbers: their meaning and unit, or codes with their words.

    kinds -- meaning of the numbers in `kind`
    """
    flags = {"remarks": Remark, "status": Status, "onset": Status, "fold_kind": FoldKind, "kind": kinds}
    codes: Any = flags.get(name)
    if codes is None:
        return {"long_name": text, "units": unit}
    values, meanings = list(map(int, codes)), " ".join(code.name for code in codes)
    if name == "remarks":
        return {"long_name": text, "flag_masks": values, "flag_meanings": meanings}
    if name == "status":
        values, meanings = [NOT_YET, *values], f"NOT_YET {meanings}"
    # what each number stands for, as the derivation states it
    meaning = inspect.cleandoc(codes.__doc__ or "")
    return {"long_name": text, "flag_values": values, "flag_meanings": meanings, "meaning": meaning}
