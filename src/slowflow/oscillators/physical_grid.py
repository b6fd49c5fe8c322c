"""Maps of mounts in SI units over named axes, made from xarray or dask arrays.

Each block of a map is a batch of mounts (`slowflow.oscillators.physical_designs`).
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.answers.answer import optional
from slowflow.answers.quantities import DATA_SHEET, KIND_OF, SHEET, SI, UNITS, ManyScales, si
from slowflow.answers.table import QUANTITIES, QUESTIONS, Question
from slowflow.core import validate
from slowflow.grid.block import DIMENSIONLESS, UNITS_OF, Ask
from slowflow.grid.designs import AT_ONCE, Grid
from slowflow.oscillators.arguments import measured_density, window_in_hertz
from slowflow.oscillators.physical_designs import SETTINGS, PhysicalDesigns, PhysicalQuestions
from slowflow.support.errors import Refused
from slowflow.support.text import in_units

if TYPE_CHECKING:
    import xarray  # noqa: F401  # of a type below

__all__ = ["PhysicalGrid"]


class PhysicalGrid(PhysicalQuestions["xarray.Dataset"], Grid):  # type: ignore[misc]  # questions with other arguments
    """Many mounts in SI units over named axes, and the questions about them; answers are xarray Datasets in SI units.

    Made by `mount.many(k_h=..., m=...)` from arrays of xarray or dask. An array is in SI units unless the attribute
    "units" of a DataArray names another unit. Questions and arguments are those of `PhysicalDesigns`; maps are those of
    `slowflow.grid.designs.Grid`, with SI names of columns, data and arguments, and units as an attribute.
    """

    designs: PhysicalDesigns

    @classmethod
    def _of(cls, kind: Any, sheet: Mapping[str, Any], second: bool = False) -> PhysicalGrid:
        """Make the mounts of a kind of oscillator from a data sheet, of which some numbers are labelled arrays."""
        known = {name: value for name, value in sheet.items() if value is not None}
        settings = {name: known.pop(name) for name in SETTINGS if name in known}
        designs = PhysicalDesigns(kind, {**dict.fromkeys(known, np.empty(0)), **settings}, second)
        values = {name: _in_si(name, value, SHEET[name]) for name, value in known.items()}
        averaged: Any = getattr(designs.designs, "first", designs.designs)
        return cls(averaged.mechanism, designs, values)

    @property
    def scales(self) -> ManyScales:
        """The names and units of numbers, without the sizes of any mount."""
        return self.designs.scales

    @functools.cached_property
    def _by_other_base(self) -> PhysicalGrid:
        return type(self)(self.mechanism, self.designs._by_other_base, self._parameters)

    def store(self, path: Any, question: str, **arguments: Any) -> Any:
        """Write a question's answer into a Zarr store; see `slowflow.grid.designs.Grid.store`.

        path      -- folder of the store, or another store that Zarr accepts
        question  -- name of the method, such as "peak"
        arguments -- of the question, such as F, f and max_count, in SI units, and workers

        Returns the store as a lazy Dataset. Data, arguments and columns are in SI units there, each with its unit.
        """
        mounts, known = self._bound(validate.choice("question", question, tuple(QUESTIONS)), **arguments)
        return super(PhysicalGrid, mounts).store(path, question, **known)

    def _query(self, question: str, workers: int = 1, **arguments: Any) -> tuple[Ask, dict[str, Any]]:
        """Return a question as a function of a block's numbers, and all the numbers that it takes.

        arguments -- of the question, named as in the table, in SI units
        """
        row = QUESTIONS[question]
        in_si = {name: self._argument(row, name, value) for name, value in arguments.items() if value is not None}
        return super()._query(question, workers, **in_si)

    def _argument(self, row: Question, name: str, value: Any) -> Any:
        """An argument in SI units."""
        shown, kind = self.scales.kind(name)
        if name == "psd":
            return measured_density(*value)
        if kind == "frequency" and name in row.options:
            return window_in_hertz(value)
        return _in_si(shown, value, SI[kind]) if kind else value

    def _defaults(self, row: Question) -> dict[str, Any]:
        # a window of frequencies is no default in Hz: that of each mount is
        return {**row.options, **({"Omega": None} if "Omega" in row.options else {})}

    def _shown(self, name: str) -> str:
        return self.scales.symbol(name)

    def _meaning(self, name: str) -> tuple[str, str]:
        if name in self.values:
            unit, meaning = DATA_SHEET[name]
            return meaning, unit or DIMENSIONLESS
        unit = SI.get(QUANTITIES[name].kind and self.scales.kind(name)[1], "")
        return in_units(QUANTITIES[name].text, self.scales), unit or UNITS_OF.get(name, DIMENSIONLESS)

    def _range_checks(self) -> Iterator[str]:
        """Remarks on data that look as if they were in another unit; of many mounts on some, of dask's arrays none."""
        if not any(value.chunks for value in self.values.values()):
            step = math.ceil((math.prod(self.shape) / AT_ONCE) ** (1 / max(1, len(self.shape))))
            some = (value.isel(dict.fromkeys(value.dims, slice(None, None, step))) for value in self.values.values())
            arrays = optional("xarray", "a grid", "grid").broadcast(*some)
            numbers = {name: array.values for name, array in zip(self.values, arrays, strict=True)}
            yield from self.designs._with_values(numbers)._range_checks()


def _in_si(name: str, value: Any, unit: str) -> Any:
    """Numbers in SI units; labelled arrays stay such, without the unit that they may say."""
    if not (validate.is_labelled(value) and hasattr(value, "attrs")):
        return si(name, value, unit)
    if hasattr(value.data, "magnitude"):
        return value.copy(data=si(name, value.data, unit))
    if not unit:
        return value
    known = {unit: 1.0, **UNITS[KIND_OF[unit]]}
    if (word := value.attrs.get("units", unit)) not in known:
        raise Refused(f"{name} has units = {word!r}: they must be one of {', '.join(known)}")
    size = known[word]
    found = value.copy(deep=False) if size == 1.0 else value * size
    found.attrs = {}
    # numbers along an axis of their own name are its coordinate
    own = {name: value.coords[name] * size} if size != 1.0 and name in getattr(value, "coords", ()) else {}
    return found.assign_coords(own) if own else found
