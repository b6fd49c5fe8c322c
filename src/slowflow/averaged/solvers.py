"""The solvers in use: the same questions, on compiled code where a model has it, on NumPy elsewhere.

Which of them is decided when the model is made, see `Model.native`. Those on NumPy are loaded where they are needed.
"""

from collections.abc import Callable
from types import ModuleType
from typing import Any, TypeVar, cast

import numpy as np

from slowflow.averaged import compiled
from slowflow.model import Model

Question = TypeVar("Question", bound=Callable[..., Any])


def _reference() -> ModuleType:
    from slowflow.averaged.reference import answers

    return answers


def _either(on_compiled: Question, on_numpy: Callable[[], Question], laws: bool = False) -> Question:
    """laws -- whether what is compiled answers for other laws of damping too."""

    def ask(model: Model, *arguments: Any) -> Any:
        if (model.searched if laws else model.native) is not None:
            try:
                return on_compiled(model, *arguments)
            except ArithmeticError:
                # what boxes leave unresolved next to an end of a piece NumPy's search may tell
                if not model.laws.any:
                    raise
        # a solver tries values that it then discards: the warnings that these raise are no fault of the arguments
        with np.errstate(all="ignore"):
            return on_numpy()(model, *arguments)

    return cast(Question, ask)


amplitudes = _either(compiled.amplitudes, lambda: _reference().amplitudes, laws=True)
closes = _either(compiled.closes, lambda: _reference().closes, laws=True)
detachment = _either(compiled.detachment, lambda: _reference().detachment, laws=True)
extrema = compiled.extrema
fold_locus = compiled.fold_locus
frequency_response = _either(compiled.frequency_response, lambda: _reference().frequency_response, laws=True)
onset = _either(compiled.onset, lambda: _reference().onset, laws=True)
peak = _either(compiled.peak, lambda: _reference().peak, laws=True)
saddle_nodes = _either(compiled.saddle_nodes, lambda: _reference().saddle_nodes, laws=True)
