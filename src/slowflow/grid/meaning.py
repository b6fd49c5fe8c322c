"""What the columns of a map mean. Takes a question and a column's name; returns attributes, as CF has them.

A file outlives the program that wrote it: units, codes with their words, and which slowflow it was stand in it.
"""

from __future__ import annotations

import inspect
from typing import Any

from slowflow.grid.block import Ask
from slowflow.model import THROUGHOUT
from slowflow.results import Remark
from slowflow.table import COLUMNS
from slowflow_kernels.conventions import FoldKind, Status
from slowflow_kernels.domains import DAMPING, DISSIPATION

#: status of a design in a block that is not computed yet; none of the solvers'
NOT_YET = -1
UNITS = "dimensionless"
#: units of what is not dimensionless
UNITS_OF = {"phi": "rad", "transmissibility_dB": "dB", "level_dB": "dB"}


def of_map(ask: Ask) -> dict[str, Any]:
    """Of a whole map."""
    about = {"mechanism": ask.mechanism.name, "title": ask.mechanism.title, "excitation": ask.excitation}
    about |= {"question": ask.question, **({} if ask.rubs == THROUGHOUT else {"rubs": ask.rubs})}
    return {**about, "depth": ask.depth, **ask.made_by}


def of_column(ask: Ask, name: str) -> dict[str, Any]:
    """Of a column of an answer, or of one of the numbers that it was asked with."""
    known = {domain.name: domain.doc for domain in (*ask.mechanism.design, *DAMPING, *DISSIPATION)}
    found: dict[str, Any] = {"long_name": known.get(name) or COLUMNS[name].text}
    flags = {"remarks": Remark, "status": Status, "onset": Status, "fold_kind": FoldKind, "kind": ask.asked.kinds}
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
