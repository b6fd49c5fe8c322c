"""Measured columns, read from a CSV file with names and units in its header.

    f [Hz], a [g]
    2.0, 0.05
    5.0, 0.04

The columns become arrays in SI units. Their names are those of the arguments that take them: f, F (or Y, a, U), A and
phi for measured points; t and acceleration for a shock record; f and G for a spectral density; x and F for a loop.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from slowflow.answers.answer import frozen
from slowflow.answers.quantities import DENSITIES, KIND_OF, SI, UNITS
from slowflow.core.mechanism import Floats
from slowflow.core.validate import meant
from slowflow.support.errors import Refused

__all__ = ["Columns", "read_csv"]

#: a head, as "a [m/s^2]", or as slowflow writes it, "a/(m/s^2)", "a/g", "a"
HEAD = re.compile(r"\s*([A-Za-z]\w*)\s*(?:\[(.*)\]|/(.*))?\s*")
SEPARATORS = "\t;,"


class Columns(dict[str, Floats]):
    """Columns by name, in SI units; a spectral density in its own unit.

    units -- the unit of each column that has one
    head  -- the file and the line of the header
    """

    units: dict[str, str]
    head: str


def read_csv(path: str | Path) -> Columns:
    """Read the columns of a CSV file, by name; empty cells are NaN.

    path -- a text file whose first line has names with units, such as "a [m/s^2]"; columns are separated by commas,
            semicolons or tabs, and lines that begin with # are comments

    Raises ValueError for invalid contents, with the line number.
    """
    path = Path(path)
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except (FileNotFoundError, IsADirectoryError, UnicodeDecodeError) as error:
        raise Refused(f"{path}: this file cannot be read as text: {error}") from None
    kept = [(number, line) for number, line in enumerate(lines, 1) if line.strip() and not line.startswith("#")]
    if len(kept) < 2:
        raise Refused(f"{path}: there must be a header, such as 'f [Hz], a [m/s^2]', and rows of numbers below it")
    import csv  # here, not above: `import slowflow` does without it

    separator = max(SEPARATORS, key=kept[0][1].count)
    cut = [(number, next(csv.reader([line], delimiter=separator))) for number, line in kept]
    (first, heads), *rows = cut
    found, sizes = Columns(), list[float]()
    found.units, found.head = {}, f"{path}:{first}"
    for head in heads:
        name, unit, size = _head(found.head, head)
        if name in found:
            raise Refused(f"{found.head}: there are two columns {name}")
        found[name] = np.empty(len(rows))
        sizes.append(size)
        found.units |= {name: unit} if unit else {}
    for k, (number, cells) in enumerate(rows):
        if len(cells) != len(heads):
            raise Refused(f"{path}:{number}: {len(cells)} columns, but the header has {len(heads)}")
        for (name, column), cell, size in zip(found.items(), cells, sizes, strict=True):
            try:
                column[k] = float(cell.strip() or "nan") * size
            except ValueError:
                raise Refused(f"{path}:{number}: {name} = {cell.strip()!r} is not a number") from None
    found.update({name: frozen(column) for name, column in found.items()})
    return found


def _head(where: str, head: str) -> tuple[str, str, float]:
    """The name of a column, its unit in SI, and the size of the one that it is in."""
    match = HEAD.fullmatch(head)
    if match is None:
        raise Refused(
            f"{where}: {head.strip()!r} is not the header of a column: write a name and a unit, such as 'a [m/s^2]'"
        )
    name, *units = match.groups(default="")
    unit = "".join(units).strip()
    known = ("", *KIND_OF, *DENSITIES)
    if unit not in known:
        unit = unit.removeprefix("(").removesuffix(")")
    if unit not in known:
        allowed = f"it must be one of {', '.join(known[1:])}{meant(unit, known)}"
        raise Refused(f"{where}: the unit of {head.strip()!r} is not known: {allowed}")
    kind = KIND_OF.get(unit, "")
    return (name, SI[kind], UNITS[kind][unit]) if kind else (name, unit, 1.0)
