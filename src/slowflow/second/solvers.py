"""The solvers of the second approximation in use: compiled where a model has them, on NumPy elsewhere."""

from __future__ import annotations

from types import ModuleType

from slowflow.second import compiled
from slowflow.second.balance import Balance


def of(balance: Balance) -> ModuleType:
    """Those for this model; what runs on NumPy, and SciPy with it, is loaded where it is needed."""
    if compiled.serves(balance):
        return compiled
    from slowflow.second import reference

    return reference
