"""Many designs of one mechanism; arrays of xarray and dask make maps: Datasets, and Zarr stores that can be resumed.

Maps need `pip install 'slowflow[grid]'`. Their modules are imported when such an array is passed.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from slowflow.answers.table import ManyQuestions
from slowflow.core import validate
from slowflow.core.mechanism import Mechanism
from slowflow.core.model import THROUGHOUT, WITH_MEAN, off_centre_by
from slowflow.grid.many import Designs
from slowflow.support.text import text, together
from slowflow_kernels.domains import CONTACTS, EXCITATIONS


def designs_of(
    mechanism: Mechanism, values: dict[str, Any], laws: dict[str, Any], contact: str, excitation: str, load: Any
) -> Any:
    """Make designs of a mechanism from numbers by name; labelled arrays make a map.

    laws -- eta, c_2, ...: a plain 0 means absent, as for load
    """
    validate.excitation(excitation, tuple(EXCITATIONS))
    validate.choice("contact", contact, tuple(CONTACTS))
    values |= {name: value for name, value in laws.items() if not validate.is_zero(value)}
    if not mechanism.odd or not validate.is_zero(load):
        why = off_centre_by(mechanism, 0.0) or "load"
        others: list[str] = [text(f"{{{name}}}") for name in laws if name in values and name not in WITH_MEAN]
        others += [f"contact = {contact!r}"] * (contact != THROUGHOUT)
        validate.is_plain(why, together(", ", others), *WITH_MEAN)
        values["load"] = load
    named = any(validate.is_labelled(value) for value in values.values())
    numbers = dict.fromkeys(values, np.empty(0)) if named else values
    if "load" in values:
        from slowflow.off_centre.many import OffCentreDesigns

        designs: ManyQuestions[Any, Any] = OffCentreDesigns(mechanism, numbers, excitation)
    else:
        designs = Designs(mechanism, numbers, excitation, contact)
    if not named:
        return designs
    from slowflow.grid.designs import Grid

    return Grid(mechanism, designs, values)
